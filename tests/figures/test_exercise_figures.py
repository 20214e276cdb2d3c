"""Figures that belong to an exercise: two masses, the Earth, a book, points, a cone."""

import math
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure as Canvas
from matplotlib.text import Annotation
from scipy.spatial.transform import Rotation

from rigidtop.derivations.exercises import EXERCISES
from rigidtop.derivations.exercises.net_torque import discs
from rigidtop.figures import (
    leaning_cone,
    polar_motion,
    rotation_order,
    two_masses,
    weights,
)
from rigidtop.figures.catalog import named
from rigidtop.figures.solved import answers
from rigidtop.motion.attitude import from_euler_angles
from rigidtop.proof.exercise import Answer
from rigidtop.proof.words import unmarked

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


def arrows(axes):
    """Start and tip of every arrow (N, 2, 2)."""
    found = [each for each in axes.texts if isinstance(each, Annotation) and each.arrow_patch]
    return np.array([(each.xyann, each.xy) for each in found])


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
    held = two_masses.stick(*chosen)
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
    held = two_masses.stick(*chosen)
    two_masses.draw_two_masses(axes, held)
    alpha = chosen[4]
    view = two_masses.VIEW
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


def test_the_caption_of_two_masses():
    said = caption("two-masses")
    moment = 1.5 * 0.4**2 + 0.8 * 0.5**2
    assert f"of magnitude {moment * 3 / 2:.3g} J s" in said
    assert f"N = ω × L of {moment * 9 * math.sqrt(3) / 4:.3g} N m" in said
    assert f"F = {(1.5 * 0.4 - 0.8 * 0.5) * 9 / 2:.3g} N" in said
    assert "α = 30°" in said
    assert "60° from ω" in said


def test_a_stick_that_needs_no_torque_and_one_that_needs_no_force(axes):
    across = two_masses.stick(1.5, 0.8, 0.4, 0.5, math.pi / 2, 3.0)
    two_masses.draw_two_masses(axes, across)
    assert r"$\mathbf{N} = 0$" in [text.get_text() for text in axes.texts]
    assert "exerts no torque" in caption("two-masses", alpha=math.pi / 2)
    balanced = two_masses.stick(1.5, 1.2, 0.4, 0.5, 0.5, 3.0)
    panel = Canvas().subplots()
    two_masses.draw_two_masses(panel, balanced)
    assert r"$\mathbf{F}$" not in [text.get_text() for text in panel.texts]
    assert "no force" in caption("two-masses", M_2=1.2)


# --- The Earth -----------------------------------------------------------------------------------

EARTH = {parameter.name: parameter.default for parameter in polar_motion.POLAR_MOTION.parameters}


def azimuths(points):
    return np.unwrap(np.arctan2(points[:, 1], points[:, 0]))


@pytest.mark.parametrize("changed", [{}, {"H": 0.01, "angle": 0.05}, {"observed": 1000.0}])
def test_days_on_the_way_of_the_pole(axes, changed):
    given = {**EARTH, **changed}
    polar_motion.draw_polar_motion(axes, **given)
    sidereal_days = 2 * math.pi / given["omega3"] / 86400
    euler = (1 - given["H"]) / given["H"] * sidereal_days
    for label, period in (("_rigid", euler), ("_yielding", given["observed"])):
        [points] = lines(axes, label)
        days = polar_motion.marked_days(period)
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
    motion = polar_motion.wobble(H, angle, share)
    step = 1e-4
    before, now, after = motion.exact([2.0 - step, 2.0, 2.0 + step]).omega

    def momentum(omega):
        bulge = np.outer(omega, omega) / (omega @ omega)
        e3 = np.diag([0.0, 0.0, 1.0])
        return ((1 - H) * np.eye(3) + H * ((1 - share) * e3 + share * bulge)) @ omega

    rate = (momentum(after) - momentum(before)) / (2 * step)
    assert rate == pytest.approx(-np.cross(now, momentum(now)), abs=1e-9)
    assert np.linalg.norm(rate) > 1e-3


@pytest.mark.parametrize("period", [303.8, 433.0, 250.0, 9.99, 10.0, 1.0, 0.0997, 21650.0])
def test_marked_days_are_round_and_few(period):
    days = polar_motion.marked_days(period)
    step = days[1]
    assert f"{step:.9e}"[0] in "125"
    assert step == pytest.approx(float(f"{step:.0e}"))
    assert np.diff(days) == pytest.approx(step)
    assert 3 <= len(days) <= polar_motion.MARKS + 1
    assert 0.4 * step < period - days[-1] < 1.5 * step


def test_the_caption_of_the_earth():
    said = caption("polar-motion")
    sidereal_day = 2 * math.pi / 7.292115e-5 / 86400
    assert f"needs {(1 / 3273795e-9 - 1) * sidereal_day:.3g} days" in said
    assert "radius of 3.08 m" in said  # 0.1″ of 6357 km
    assert "29.8 %" in said
    # L is nearer by the share H: 1 cm
    assert f"L is {3.08185 * 3273795e-9:.3g} m nearer" in said


# --- Two rotations of a book ---------------------------------------------------------------------

TURNS = [(math.pi / 2, math.pi / 2, math.pi / 2), (0.4, -1.1, 0.9), (-3.0, 2.0, 2.5)]


@pytest.mark.parametrize("chosen", TURNS)
def test_both_orders_end_where_the_rotations_do(chosen):
    alpha, beta, gamma = chosen
    a = Rotation.from_rotvec([alpha, 0.0, 0.0])
    b = Rotation.from_rotvec([beta * math.cos(gamma), beta * math.sin(gamma), 0.0])
    vectors = Rotation.random(5, random_state=3).as_matrix()[:, :, 0]
    upper, lower = rotation_order.orders(*chosen)
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


@pytest.mark.parametrize("chosen", TURNS)
def test_the_book_as_it_is_drawn(chosen):
    """The letter lies where the rotation puts it, and is seen where the cover looks at the eye."""
    gamma = chosen[2]
    axes_of = rotation_order.axes_of_rotation(gamma)
    seen = 0
    for row in rotation_order.orders(*chosen):
        for _, turn, last in row:
            panel = Canvas().subplots()
            rotation_order.draw_turned(panel, turn, gamma, last)
            looks = rotation_order.VIEW(turn @ [1.0, 0.0, 0.0])[2] > 0
            drawn = lines(panel, "_letter")
            assert len(drawn) == looks
            seen += len(drawn)
            for letter in drawn:
                placed = Rotation.from_matrix(turn).apply(rotation_order.letter())
                assert pytest.approx(np.array(rotation_order.VIEW(placed)[:2])) == letter.T
            if last is None:
                continue
            [way] = lines(panel, "_turn")
            k, angle = last
            start = 0.82 * 1.15 * axes_of[k] + [0.0, 0.0, 0.34]
            ends = Rotation.from_rotvec(angle * axes_of[k]).apply(start)
            assert way[0] == pytest.approx(on_paper(rotation_order.VIEW, start))
            assert way[-1] == pytest.approx(on_paper(rotation_order.VIEW, ends))
    assert seen >= 3


def test_the_letter_can_be_read_at_first(axes):
    rotation_order.draw_turned(axes, np.eye(3), 1.0)
    [strokes] = lines(axes, "_letter")
    assert strokes[1, 1] > strokes[0, 1]  # up the stem,
    assert strokes[2, 0] > strokes[1, 0]  # then to the right,
    assert strokes[4, 1] < strokes[3, 1]
    assert strokes[5, 0] > strokes[4, 0]  # and again, lower and shorter
    assert strokes[5, 0] < strokes[2, 0]


@pytest.mark.parametrize(("given", "same"), [({"gamma": 0.0}, True), ({"gamma": math.pi}, True)])
def test_turns_about_one_line_commute(given, same):
    assert ("Both end alike" in caption("order-of-rotations", **given)) is same
    assert "Both end alike" not in caption("order-of-rotations", gamma=0.01)


@pytest.mark.parametrize("seed", range(5))
def test_where_a_ray_leaves_the_book(seed):
    draws = Rotation.random(2, random_state=seed).as_matrix()
    turn, ray = draws[0], draws[1][:, 0]
    out, seen = rotation_order.leaves(turn, ray)
    in_book = np.abs(turn.T @ out) / rotation_order.HALF
    assert in_book.max() == pytest.approx(1)
    assert np.cross(out, ray) == pytest.approx(np.zeros(3), abs=1e-15)
    assert out @ ray > 0
    k = int(np.argmax(in_book))
    normal = turn[:, k] * math.copysign(1, out @ turn[:, k])
    assert seen == (normal @ rotation_order.VIEW.axes[2] > 0)


# --- Weights -------------------------------------------------------------------------------------

BODY = weights.points(**{p.name: p.default for p in weights.WEIGHTS.parameters})


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
    weights.draw_weights(axes, body)
    assert tip(axes, r"$\mathbf{N}$") == pytest.approx(
        on_paper(weights.VIEW, 0.6 * direction(lumped))
    )


def test_weights_as_they_are_drawn(axes):
    weights.draw_weights(axes, BODY)
    reach = np.linalg.norm(BODY.places, axis=1).max()
    drawn = arrows(axes)

    def from_here(place):
        """The arrow that starts at a place."""
        [found] = [a for a in drawn if np.allclose(a[0], on_paper(weights.VIEW, place / reach))]
        return found[1] - found[0]

    single = np.array([from_here(place) for place in BODY.places])
    whole = from_here(BODY.centre)
    assert single[:, 0] == pytest.approx(0, abs=1e-12)
    assert single[:, 1] / single[0, 1] == pytest.approx(BODY.masses / BODY.masses[0])
    assert whole == pytest.approx(single.sum(axis=0))
    assert whole[1] < 0


@pytest.mark.parametrize("changed", [{}, {"x1": 15.0}, {"z3": -4.0}, {"m3": 50.0, "y3": 9.0}])
def test_no_weight_leaves_the_paper(axes, changed):
    weights.draw_weights(axes, weights.points(**weights.WEIGHTS.values(changed)))
    x, y = arrows(axes).reshape(-1, 2).T
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    assert left + 0.1 < x.min()
    assert x.max() < right - 0.1
    assert low + 0.1 < y.min()
    assert y.max() < high - 0.1
    # and no more is added than names need
    assert right - left < np.ptp(x) + 0.8


def test_the_caption_of_weights():
    said = caption("weights")
    centre = (BODY.masses @ BODY.places) / 3.5
    assert f"R_CM = ({centre[0]:.3g}, {centre[1]:.3g}, {centre[2]:.3g}) m" in said
    torque = -9.81 * 3.5 * centre[1], 9.81 * 3.5 * centre[0]
    assert f"(−{-torque[0]:.3g}, {torque[1]:.3g}, 0) N m" in said
    assert f"magnitude {math.hypot(*torque):.3g} N m" in said
    assert f"{9.81 * 3.5 * centre[2]:.3g} J" in said


def test_weights_over_the_pivot_have_no_torque(axes):
    upright = dict.fromkeys(("x1", "x2", "x3", "y1", "y2", "y3"), 0.0)
    weights.draw_weights(axes, weights.points(**weights.WEIGHTS.values(upright)))
    assert r"$\mathbf{N} = 0$" in [text.get_text() for text in axes.texts]
    assert "which is zero here" in caption("weights", **upright)


# --- A cone on its tip ---------------------------------------------------------------------------


@pytest.mark.parametrize(("theta", "phi"), [(math.pi / 9, 0.7), (1.3, -2.0), (2.6, 5.0)])
def test_the_cone_as_it_is_drawn(axes, theta, phi):
    """Its centre of mass and its torque from a sum over bits of the cone."""
    radius, height = 0.03, 0.06
    leaning_cone.draw_leaning_cone(axes, radius, height, theta, phi, 0.045)
    bits, sizes = discs(radius, height)
    places = from_euler_angles(theta, phi, 0.0).apply(bits)
    centre = sizes @ places / sizes.sum()
    torque = np.cross(places, -sizes[:, None] * np.array([0.0, 0.0, 1.0])).sum(axis=0)
    view, slant = leaning_cone.view_of(phi), math.hypot(radius, height)
    assert tip(axes, r"$\mathbf{R}_\mathrm{CM}$") == pytest.approx(on_paper(view, centre / slant))
    assert tip(axes, r"$\mathbf{N}$") == pytest.approx(on_paper(view, 0.85 * direction(torque)))
    assert view(torque)[2] < 0  # into the paper
    assert view(centre)[0] > 0  # leans to the right
    top = Rotation.from_euler("ZYZ", [phi, theta, 0]).apply([0.0, 0.0, 1.35])
    assert tip(axes, r"$\mathbf{e}_3$") == pytest.approx(on_paper(view, top))
    _, *lid = axes.patches
    assert bool(lid) == (view(top)[2] > 0)
    for rim in (each.get_xy() for each in lid):
        assert (rim[0] + rim[60]) / 2 == pytest.approx(on_paper(view, height / slant / 1.35 * top))
    # R cos θ upright on paper, shortened as all heights are; Mg hangs on the centre of mass.
    drawn = arrows(axes)
    lengths = drawn[:, 1] - drawn[:, 0]
    rise = centre[2] / slant * math.cos(view.elevation)
    assert any(np.allclose(each, [0.0, rise]) for each in lengths)
    assert any(
        np.allclose(each[0], on_paper(view, centre / slant)) and each[1][1] < each[0][1]
        for each in drawn
    )


def test_the_angles_of_the_cone(axes):
    theta, phi = 0.9, 1.2
    leaning_cone.draw_leaning_cone(axes, 0.03, 0.06, theta, phi, 0.045)
    lean, azimuth = lines(axes, "_angle")
    view = leaning_cone.view_of(phi)
    e3 = Rotation.from_euler("ZYZ", [phi, theta, 0]).apply([0.0, 0.0, 1.0])
    assert lean[0] == pytest.approx(on_paper(view, [0.0, 0.0, 1.18]))
    assert lean[-1] == pytest.approx(on_paper(view, 1.18 * e3))
    assert azimuth[0] == pytest.approx(on_paper(view, [0.4, 0.0, 0.0]))
    assert azimuth[-1] == pytest.approx(on_paper(view, 0.4 * direction([e3[0], e3[1], 0.0])))


def test_the_caption_of_the_cone():
    said = caption("leaning-cone", theta=0.5)
    mass = 700 * math.pi * 0.03**2 * 0.06 / 3
    assert f"M = {mass:.3g} kg" in said
    assert "R = 0.045 m, three quarters of its height" in said
    torque = mass * 9.81 * 0.045 * math.sin(0.5)
    assert f"N, along e₂′, of magnitude MgR sin θ = {torque:.3g} N m" in said
    assert f"MgR cos θ = {mass * 9.81 * 0.045 * math.cos(0.5):.3g} J" in said


@pytest.mark.parametrize("theta", [0.0, math.pi])
def test_a_vertical_cone_has_no_torque(axes, theta):
    leaning_cone.draw_leaning_cone(axes, 0.03, 0.06, theta, 0.7, 0.045)
    assert r"$\mathbf{N} = 0$" in [text.get_text() for text in axes.texts]
    assert lines(axes, "_angle") == []
    assert "it has no azimuth and N = 0" in caption("leaning-cone", theta=theta)
