"""Figures that belong to an exercise: two masses, the Earth, a book, points, a cone."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from rigidtop.derivations.exercises import EXERCISES
from rigidtop.figures import (
    points,
    rotations,
    wobbles,
)
from rigidtop.figures.catalog import named
from rigidtop.figures.solved import answers
from rigidtop.proof.exercise import Answer
from rigidtop.typeset.words import unmarked

from .conftest import direction

OF = {
    "two-masses": "two-masses",
    "earth-euler-period": "polar-motion",
    "rotations-form-a-group": "order-of-rotations",
    "gravity-on-points": "weights",
    "gravity-on-a-solid": "leaning-cone",
}


def lines(axes, label):
    return [np.asarray(each.get_xydata()) for each in axes.lines if each.get_label() == label]


def tip(axes, words):
    """Where the arrow of this name ends."""
    [found] = [each for each in axes.texts if each.get_text() == words]
    return np.array(found.xy)


def on_paper(view, vector):
    return np.array(view(vector)[:2])


def caption(name, **given):
    drawing = named(name)
    return unmarked(drawing.caption(**drawing.values(given)))


@pytest.mark.parametrize("exercise", EXERCISES, ids=lambda exercise: exercise.name)
def test_answers_of_an_exercise_stand_first(exercise):
    settings = {parameter.name: parameter.default for parameter in exercise.parameters}
    if exercise.name in OF:
        outcomes = exercise.solve(**settings)
        whole = {each.name: each.value for each in outcomes if isinstance(each, Answer)}
        assert answers(exercise, **settings) == whole
        assert exercise.figure == OF[exercise.name]
        assert named(exercise.figure).parameters == exercise.parameters


# --- Two masses on a stick -----------------------------------------------------------------------

STICKS = [
    (1.5, 0.8, 0.4, 0.5, math.pi / 6, 3.0),
    (0.3, 2.0, 0.7, 0.2, 1.2, 0.5),
    (1.0, 3.0, 0.5, 0.9, 0.1, 20.0),
]


def turned(held, t):
    """Positions after t (s), by rotation."""
    return Rotation.from_rotvec(t * held.omega).apply(held.positions)


@pytest.mark.parametrize("chosen", STICKS)
def test_the_bearing_moves_what_it_holds(chosen):
    """L by the inertia tensor; N and F by what Newton's law asks, from differences in time."""
    held = points.stick(*chosen)
    r, m = held.positions, held.masses
    tensor = sum(k * (p @ p * np.eye(3) - np.outer(p, p)) for k, p in zip(m, r, strict=True))
    assert held.momentum == pytest.approx(tensor @ held.omega, rel=1e-12)
    step = 1e-3 / chosen[-1]
    second = (turned(held, step) - 2 * r + turned(held, -step)) / step**2
    pushes = m[:, None] * second
    scale = np.linalg.norm(pushes, axis=1).sum()
    assert held.force == pytest.approx(pushes.sum(axis=0), abs=1e-6 * scale)
    assert held.torque == pytest.approx(np.cross(r, pushes).sum(axis=0), abs=1e-6 * scale)


@pytest.mark.parametrize("chosen", STICKS)
def test_two_masses_as_they_are_drawn(axes, chosen):
    held = points.stick(*chosen)
    points.draw_two_masses(axes, held)
    alpha = chosen[4]
    view = points.VIEW_TWO_MASSES
    # L leans to the other side than the first mass, at right angles to the stick.
    across = np.array([0.0, -math.cos(alpha), math.sin(alpha)])
    assert tip(axes, r"$\mathbf{L}$") == pytest.approx(on_paper(view, 1.15 * across))
    assert tip(axes, r"$\mathbf{N}$") == pytest.approx(on_paper(view, [1.0, 0.0, 0.0]))
    side = -math.copysign(0.55, chosen[0] * chosen[2] - chosen[1] * chosen[3])
    assert tip(axes, r"$\mathbf{F}$") == pytest.approx(on_paper(view, [0.0, side, 0.0]))
    [stick] = lines(axes, "_stick")
    longer = max(chosen[2:4])
    for end, arm in zip(stick, (chosen[2], -chosen[3]), strict=True):
        place = arm / longer * np.array([0.0, math.sin(alpha), math.cos(alpha)])
        assert end == pytest.approx(on_paper(view, place))
    assert view([1.0, 0.0, 0.0])[2] > 0  # N looks at the reader


# --- The Earth -----------------------------------------------------------------------------------

EARTH = {parameter.name: parameter.default for parameter in wobbles.POLAR_MOTION.parameters}


def azimuths(points):
    return np.unwrap(np.arctan2(points[:, 1], points[:, 0]))


@pytest.mark.parametrize("changed", [{}, {"H": 0.01, "angle": 0.05}, {"observed": 1000.0}])
def test_days_on_the_way_of_the_pole(axes, changed):
    given = {**EARTH, **changed}
    wobbles.draw_polar_motion(axes, **given)
    sidereal_days = 2 * math.pi / given["omega3"] / 86400
    euler = (1 - given["H"]) / given["H"] * sidereal_days
    for label, period in (("_rigid", euler), ("_yielding", given["observed"])):
        [points] = lines(axes, label)
        days = wobbles.marked_days(period)
        away = given["radius"] * math.tan(given["angle"])
        assert np.hypot(*points.T) == pytest.approx(away, rel=1e-8)
        # Eastwards is counterclockwise, seen from above the north pole.
        assert azimuths(points) == pytest.approx(2 * math.pi * days / period, abs=1e-6)
        written = [f"${day:.4g}$" for day in days[1:]]
        texts = {text.get_text(): text.xy for text in axes.texts}
        assert set(written) <= set(texts)
    [way] = lines(axes, "_way")
    assert azimuths(way)[-1] == pytest.approx(2 * math.pi, abs=1e-6)


def test_a_yielding_earth_keeps_its_angular_momentum():
    """The bulge is turned in part towards ω; L̇ + ω × L = 0 by differences in time."""
    H, angle, share = 0.3, 0.1, 0.4
    motion = wobbles.wobble(H, angle, share)
    step = 1e-4
    before, now, after = motion.exact([2.0 - step, 2.0, 2.0 + step]).omega

    def momentum(omega):
        bulge = np.outer(omega, omega) / (omega @ omega)
        e3 = np.diag([0.0, 0.0, 1.0])
        return ((1 - H) * np.eye(3) + H * ((1 - share) * e3 + share * bulge)) @ omega

    rate = (momentum(after) - momentum(before)) / (2 * step)
    assert rate == pytest.approx(-np.cross(now, momentum(now)), abs=1e-9)
    assert np.linalg.norm(rate) > 1e-3


# --- Two rotations of a book ---------------------------------------------------------------------

TURNS = [(math.pi / 2, math.pi / 2, math.pi / 2), (0.4, -1.1, 0.9), (-3.0, 2.0, 2.5)]


@pytest.mark.parametrize("chosen", TURNS)
def test_both_orders_end_where_the_rotations_do(chosen):
    alpha, beta, gamma = chosen
    a = Rotation.from_rotvec([alpha, 0.0, 0.0])
    b = Rotation.from_rotvec([beta * math.cos(gamma), beta * math.sin(gamma), 0.0])
    vectors = Rotation.random(5, random_state=3).as_matrix()[:, :, 0]
    upper, lower = rotations.orders(*chosen)
    # B first, then A: each vector is turned by one after the other.
    for row, first, second, title in ((upper, b, a, "$AB$"), (lower, a, b, "$BA$")):
        (_, start, _), (_, middle, by), (words, end, last) = row
        assert start == pytest.approx(np.eye(3))
        assert vectors @ middle.T == pytest.approx(first.apply(vectors), abs=1e-14)
        assert vectors @ end.T == pytest.approx(second.apply(first.apply(vectors)), abs=1e-14)
        assert words.endswith(title)
        assert by == ((1, beta) if row is upper else (0, alpha))
        assert last == ((0, alpha) if row is upper else (1, beta))
    apart = Rotation.from_matrix(upper[2][1]) * Rotation.from_matrix(lower[2][1]).inv()
    names = {"alpha": alpha, "beta": beta, "gamma": gamma}
    words = caption("order-of-rotations", **names)
    turned = f"{math.degrees(apart.magnitude()):.3g}°"
    assert f"From where one ends to where the other ends it is a turn by {turned}" in words
    whole = math.degrees(Rotation.from_matrix(upper[2][1]).magnitude())
    assert f"AB is one turn, by {whole:.3g}°" in words


# --- Weights -------------------------------------------------------------------------------------

BODY = points.points(**{p.name: p.default for p in points.WEIGHTS.parameters})


def potential(body, turn):
    return float(body.g * body.masses @ turn.apply(body.places)[:, 2])


@pytest.mark.parametrize("change", [0.0, 1.0, -2.0])
def test_the_torque_of_weights_is_the_slope_of_their_energy(axes, change):
    body = replace(BODY, places=BODY.places + change * np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1]]))
    step = 1e-5
    slopes = [
        (
            potential(body, Rotation.from_rotvec(step * axis))
            - potential(body, Rotation.from_rotvec(-step * axis))
        )
        / (2 * step)
        for axis in np.eye(3)
    ]
    assert body.torque == pytest.approx(-np.array(slopes), abs=1e-7)
    lumped = np.cross(body.centre, [0.0, 0.0, -body.g * body.masses.sum()])
    assert body.torque == pytest.approx(lumped, abs=1e-12)
    points.draw_weights(axes, body)
    assert tip(axes, r"$\mathbf{N}$") == pytest.approx(
        on_paper(points.VIEW_WEIGHTS, 0.6 * direction(lumped))
    )
