"""What pictures are made of: points of the paper, names, films, and paper that fits."""

import math

import numpy as np
import pytest

from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures.drawing import film
from rigidtop.figures.space import View, bow, circle


def xy(line):
    return np.asarray(line.get_xydata(), dtype=float)


def test_places_on_the_paper_are_pairs_or_points(axes):
    points = bow(2.0, 0.0, math.pi / 2, (1.0, 0.0), count=3)
    assert points == pytest.approx(np.array([[3, 0], [1 + math.sqrt(2), math.sqrt(2)], [1, 2]]))
    pen.draw(axes, [pen.Curve(points), pen.Curve((points[:, 0], points[:, 1]))])
    assert xy(axes.lines[0]) == pytest.approx(points)
    assert xy(axes.lines[1]) == pytest.approx(points)


def test_marks_and_angles_have_names(axes):
    named = pen.Markers((1.0, 2.0), "red", words="here", shift=(3, 4), ink="blue")
    pen.draw(axes, [named, *pen.angle(bow(1.0, 0.0, math.pi), r"$\theta$", out=2.0)])
    here, theta = axes.texts
    assert (here.get_text(), here.xy, here.xyann, here.get_color()) == (
        "here",
        (1.0, 2.0),
        (3, 4),
        "blue",
    )
    assert theta.xy == pytest.approx((0.0, 2.0))


def test_paper_fits_lines_areas_and_arrows(axes):
    across, up, _ = View().axes
    shapes = [
        pen.Curve([0 * up, 3 * up]),
        pen.Face([-across, across, 0 * up], "red"),
        pen.Arrow(5 * across, "x"),
    ]
    pen.fit(axes, shapes, View(), (0.1, 0.2, 0.3, 0.4))
    assert axes.get_xlim() == pytest.approx((-1 - 0.6, 5 + 1.2))
    assert axes.get_ylim() == pytest.approx((0 - 1.8, 3 + 2.4))


def test_faces_of_a_box_look_outwards():
    attitude = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))[0]
    sizes = np.array([1.0, 2.0, 3.0])
    faces = solids.faces(attitude, sizes)
    assert len(faces) == 6
    for k, (corners, normal) in enumerate(faces):
        assert corners @ normal == pytest.approx(sizes[k // 2])
        assert normal == pytest.approx((-1) ** k * attitude[:, k // 2])
        diagonals = np.linalg.norm(corners[:2] - corners[2:], axis=1)
        assert diagonals == pytest.approx(2 * math.hypot(*np.delete(sizes, k // 2)))


def test_a_film_draws_anew_in_its_boxes():
    def fill(share, left, right):
        for axes in (left, right):
            pen.draw(axes, [pen.Markers((share, 0.0))])

    boxes = (0.0, 0.0, 0.4, 1.0), (0.5, 0.1, 0.5, 0.9)
    film_of_marks = film(4.0, 2.0, fill, *boxes)
    film_of_marks.show(0.5)
    assert tuple(film_of_marks.canvas.get_size_inches()) == (4.0, 2.0)
    for axes, box in zip(film_of_marks.canvas.axes, boxes, strict=True):
        assert axes.get_position().bounds == pytest.approx(box)
        [mark] = axes.lines
        assert xy(mark) == pytest.approx(np.array([[0.5, 0.0]]))


def test_pictures_stand_abreast():
    widths = []
    drawn = pen.abreast(2.0, *[lambda axes, a: widths.append(a)] * 3)(a=7.0)
    assert widths == [7.0] * 3
    lefts = [axes.get_position().x0 for axes in drawn.axes]
    assert lefts == pytest.approx([0, 1 / 3, 2 / 3])


def test_three_rates_have_names_and_zero(axes):
    rates = circle([0.0, 0.0, 1.0], 1.0, count=5)
    pen.draw(axes, pen.three(np.arange(5.0), rates, "/a_2"))
    labels = [each.get_label() for each in axes.lines]
    assert labels[:3] == [rf"$\omega_{k}/a_2$" for k in (1, 2, 3)]
    for line, rate in zip(axes.lines, rates.T, strict=False):
        assert xy(line)[:, 1] == pytest.approx(rate)
