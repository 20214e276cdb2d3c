"""Figures of the chapters: on their pages, of their parameters, and true to their equations."""

import importlib
import math
import re

import matplotlib
import numpy as np
import pytest

from rigidtop.collection import load
from rigidtop.collection.chapters import CHAPTERS, chapters
from rigidtop.collection.folder import module_name
from rigidtop.errors import RigidtopError
from rigidtop.figures.style import STYLE
from rigidtop.report import tex_lines

COLLECTIONS = {name: load(CHAPTERS / name) for name in chapters()}
FIGURES = [(name, each) for name, found in COLLECTIONS.items() for each in found.figures]
every_figure = pytest.mark.parametrize(
    "drawing", [each for _, each in FIGURES], ids=[f"{name}-{each.name}" for name, each in FIGURES]
)
every_chapter = pytest.mark.parametrize("name", COLLECTIONS)


def beside(name, module):
    """A module of a chapter, as the chapter has loaded it."""
    return importlib.import_module(f"{module_name(CHAPTERS / name)}.{module}")


def content(canvas):
    """What is drawn: lines, areas and words."""
    shown = []
    for axes in canvas.axes:
        shown += [axes.get_xlim(), axes.get_ylim()]
        shown += [line.get_xydata().tobytes() for line in axes.lines]
        shown += [patch.get_path().vertices.tobytes() for patch in axes.patches]
        shown += [(text.get_text(), *text.xy) for text in axes.texts]
    return shown


def drawn(drawing, **given):
    with matplotlib.rc_context(STYLE):
        return content(drawing.draw(**drawing.values(given)))


@every_chapter
def test_two_figures_stand_on_the_pages_and_are_spoken_of(name):
    pages = "".join(page.read_text("utf-8") for page in (CHAPTERS / name).glob("*.md"))
    names = [each.name for each in COLLECTIONS[name].figures]
    assert len(names) >= 2
    assert sorted(re.findall(r"^!\[.+\]\(#([\w-]+)\)$", pages, re.M)) == sorted(names)
    assert {*re.findall(r"\[[Tt]he figure\]\(#figure-([\w-]+)\)", pages)} == {*names}


@every_figure
def test_every_parameter_changes_the_picture_and_its_caption_or_is_refused_in_one_line(drawing):
    picture, caption = drawn(drawing), drawing.caption(**drawing.values())
    words = drawing.alternative(**drawing.values())
    assert words.isascii()
    assert len(words) > 80
    assert tex_lines.rich((caption,))

    def changed(name, value):
        shown, refusal = picture, ""
        try:
            shown = drawn(drawing, **{name: value})
        except RigidtopError as error:
            refusal = str(error)
        assert "\n" not in refusal
        return shown != picture and drawing.caption(**drawing.values({name: value})) != caption

    for each in drawing.parameters:
        far = (min(max(x * each.default, each.least), each.most) for x in (1 / 30, 30))
        found = [changed(each.name, value) for value in far]
        assert any(found) or changed(each.name, 0.9 * each.default), each.name


@every_chapter
def test_one_moves(name):
    moving = [each for each in COLLECTIONS[name].figures if each.animate is not None]
    assert moving
    for each in moving:
        with matplotlib.rc_context(STYLE):
            film = each.animate(**each.values())
            frames = []
            for share in (0.0, 0.3, 0.7):
                film.show(share)
                frames.append(content(film.canvas))
        assert frames[0] != frames[1] != frames[2] != frames[0]


# --- What they show ------------------------------------------------------------------------------


def area(x, y):
    return abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) / 2


def test_orbits_are_those_of_the_page():
    figures, orbits = beside("kepler", "figures"), beside("kepler", "orbits")
    for epsilon in (0.0, 0.6, 1.0, 1.5):
        r, phi = orbits.orbit(1.0, epsilon).integrate(np.linspace(-2.0, 2.0, 41)).q.T
        np.testing.assert_allclose(r * (1 + epsilon * np.cos(phi)), 1.0, rtol=1e-8)
    areas = [area(*figures.sector(0.6, start, 1 / 12)) for start in (-1 / 24, 0.2, 11 / 24)]
    ellipse = math.pi / (1 - 0.6**2) ** 1.5
    np.testing.assert_allclose(areas, ellipse / 12, rtol=1e-3)


def test_beats_stay_between_what_changes_slowly():
    figures = beside("coupled", "figures")
    first, second = figures.frequencies(0.15)
    t = np.linspace(0.0, 40.0, 801)
    run = figures.let_go((1e-3, 0.0), 0.15, t) / 1e-3
    slow, fast = (second - first) * t / 2, (second + first) * t / 2
    np.testing.assert_allclose(run[:, 0], np.cos(slow) * np.cos(fast), atol=1e-5)
    np.testing.assert_allclose(run[:, 1], np.sin(slow) * np.sin(fast), atol=1e-5)
    for sign in (1, -1):
        mode = figures.let_go((1e-3, sign * 1e-3), 0.15, t)
        np.testing.assert_allclose(mode[:, 1], sign * mode[:, 0], atol=1e-9)


def test_the_rosette_goes_through_the_middle_or_misses_it():
    figures = beside("foucault", "figures")
    assert np.hypot(*figures.path(9.0, 1.0, held=False)).min() < 0.01
    # An ellipse whose axes are as Ω to ω₁, for those who turn back.
    assert np.hypot(*figures.path(9.0, 1.0, held=True)).min() == pytest.approx(1 / 9, rel=1e-3)
    x, y = figures.path(8.0, 1 / 8, held=False)
    assert math.atan2(y[-1], x[-1]) == pytest.approx(-math.pi / 4, abs=1e-6)  # clockwise


def test_the_ball_keeps_its_distance_and_its_path_on_the_table_closes():
    figures = beside("rolling", "figures")
    times = np.linspace(0.0, 14.0, 301)
    run = figures.places(0.2, 0.1, math.pi, times)
    radius = 0.35 / math.pi
    np.testing.assert_allclose(np.hypot(run[:, 0] - 0.2, run[:, 1] - radius), radius, rtol=1e-8)
    path = figures._on_table(run, math.pi * times)
    np.testing.assert_allclose(path[-1], path[0], atol=1e-8)
    assert np.abs(path[150] - path[0]).max() > 0.1


def test_a_tippe_top_keeps_what_jellett_found_and_never_has_less_energy_than_the_least():
    figures, top = beside("tippe", "figures"), beside("tippe", "top")
    run = figures.risen(155.0, 0.2)
    assert run.theta[-1] > 3
    np.testing.assert_allclose(run.jellett, run.jellett[0], rtol=1e-9)
    least = [top.least_energy(run.motion.body, run.jellett[0], tilt) for tilt in run.theta]
    assert (run.energy > least).all()
    assert run.energy[-1] < 1.01 * least[-1]
    assert (np.diff(run.energy) <= 1e-12).all()
    assert figures.risen(20.0, 0.2).theta[-1] < figures.START


def test_the_axis_swings_about_north_as_a_pendulum_and_a_liquid_brings_it_to_rest():
    figures, compass = beside("gyrocompass", "figures"), beside("gyrocompass", "compass")
    values = {"turns": 20000.0, "latitude": math.radians(50)}
    time = figures.whole(1e-3, **values)
    assert time == pytest.approx(14.18, rel=1e-4)
    t, angle = figures.swings(1e-3, time=time, **values)
    np.testing.assert_allclose(angle, 1e-3 * np.cos(2 * math.pi * t / time), atol=1e-8)
    t, angle = figures.swings(2.0, time=figures.whole(2.0, **values), **values)
    np.testing.assert_allclose(angle[::100], [2, 0, -2, 0, 2], atol=1e-5)
    # (4.2) and (4.3).
    spin, nu = values["turns"] * compass.MINUTE, 2 * math.pi / time
    t = np.linspace(0.0, 30.0, 61)
    for gamma, wanted in (
        (0.6 * nu, np.exp(-0.6 * nu * t) * (np.cos(0.8 * nu * t) + 0.75 * np.sin(0.8 * nu * t))),
        (nu, (1 + nu * t) * np.exp(-nu * t)),
    ):
        run = compass.let_go(1e-3, spin, values["latitude"], damping=gamma).integrate(t)
        np.testing.assert_allclose(run.q[:, 0], 1e-3 * wanted, atol=1e-8)


def test_a_wheel_has_the_share_of_the_acceleration_that_its_caption_says():
    rolling = beside("rolling", "rolling")
    for ratio in (1.0, 0.5, 0.4):
        run = rolling.down(ratio, 0.3, 2.0, 0.1, 9.81).integrate([1.0])
        assert run.qdot[0, 0] == pytest.approx(9.81 * math.sin(0.3) / (1 + ratio), rel=1e-9)
        assert run.q[0, 0] == pytest.approx(0.1 * run.q[0, 1], rel=1e-9)


def test_paths_on_the_sphere_are_those_of_the_motion():
    figures, bodies = beside("freebody", "figures"), beside("freebody", "bodies")
    top = bodies.body(1.0, 2.0, 2.6)
    for path in figures.paths(top):
        run = top.motion(omega=path[40] / top.moments).integrate(np.linspace(0.0, 3.0, 7))
        tips = run.omega * top.moments
        away = np.linalg.norm(tips[:, None] - path, axis=2).min(axis=1)
        assert away.max() < np.linalg.norm(np.diff(path, axis=0), axis=1).max()


def test_what_tumbles_is_the_other_way_round_after_each_wait():
    figures = beside("freebody", "figures")
    moments = {"lambda1": 1.0, "lambda2": 2.0, "lambda3": 3.0}
    run = figures.tumbling(figures.path_of(0.01, **moments), np.arange(4) / 3)
    np.testing.assert_allclose(run.omega[:, 1], [1, -1, 1, -1], rtol=1e-7)
    np.testing.assert_allclose(figures.attitudes(run)[:, 1, 1], [1, -1, 1, -1], atol=1e-3)


def test_the_angle_that_is_left_over_needs_its_solid_angle():
    bodies = beside("freebody", "bodies")
    # Near the axis the path is an ellipse, whose half axes are as those of (1.6).
    narrow = bodies.Path.started(bodies.body(1.0, 2.0, 3.0), 3e-3, 1.0)
    ellipse = math.pi * 1e-3 * (2 / 3 * narrow.a2)
    assert narrow.solid_angle == pytest.approx(ellipse, rel=1e-4)


def test_points_of_the_section_keep_what_stays_and_kovalevskayas_integral_where_there_is_one():
    figures, top = beside("asymmetric", "figures"), beside("asymmetric", "top")
    for moments, kept in ((figures.KOVALEVSKAYA, True), ((1.7, 2.0, 1.0), False)):
        chi, omega = figures.starts(moments, 0.5)
        one = figures.CURVES // 2 - 1
        motion = top.let_go(moments, 1.0, chi[one], tuple(x[one] for x in omega))
        run = motion.integrate(np.linspace(0.0, 40.0, 9))
        np.testing.assert_allclose(run.energy, 0.5, atol=1e-8)
        np.testing.assert_allclose(run.momenta[:, 0], 0.0, atol=1e-9)
        integral = run.value(top.kovalevskaya(2.0, 1.0))
        assert bool(np.ptp(integral) < 1e-9 * integral[0]) is kept
        # By the search for zeros of a motion, both ways.
        section = motion.section(top.GAMMA[2], 40.0)
        found = figures.points(moments, 0.5)[one]
        later = section.t > 0.1
        wanted = np.remainder(section.q[later, 2] + math.pi, 2 * math.pi) - math.pi
        count = len(wanted)
        assert count >= 7
        np.testing.assert_allclose(found[0][:count], wanted, atol=1e-5)
        np.testing.assert_allclose(found[1][:count], section.qdot[later, 2], atol=1e-4)


def test_neighbours_part_with_the_exponent_that_the_page_says():
    pytest.importorskip("heyoka", reason="it takes minutes without Taylor series")
    figures, top = beside("asymmetric", "figures"), beside("asymmetric", "top")
    for moments, value in (((1.7, 2.0, 1.0), 0.127), (figures.KOVALEVSKAYA, 0.002)):
        omega = (*top.across(moments, 0.5, 0.7, 0.0), 0.0)
        motion = top.let_go(moments, 1.0, 0.7, omega)
        far = motion.lyapunov(3000.0, rtol=1e-10, atol=1e-12)
        assert far.value == pytest.approx(value, abs=5e-4)
        assert (far.value > 5 * far.error) is (value > 0.1)
    fitted, _ = figures.exponent(figures.pair((1.7, 2.0, 1.0), 0.7))
    assert fitted == pytest.approx(0.127, abs=0.015)
    grown = figures.pair(figures.KOVALEVSKAYA, 0.7).distance
    assert grown.max() < 200 * figures.APART
