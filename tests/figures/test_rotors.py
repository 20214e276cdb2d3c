"""What the figures of gyroscope, wheel, plate and toy top show, against facts found otherwise."""

import math

import matplotlib
import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.figures import rotors, style, wobbles
from rigidtop.figures.catalog import named
from rigidtop.typeset.words import unmarked

from .conftest import direction, line

GYROSCOPE, WHEEL = named("gyroscope"), named("bicycle-wheel")
PLATE, TOY = named("wobbling-plate"), named("toy-top")


def arrows(axes, color):
    """Start and tip on paper of the straight arrows of a colour."""
    drawn = [text for text in axes.texts if text.arrowprops and not text.get_text()]
    return [np.array([text.xyann, text.xy]) for text in drawn if text.arrowprops["color"] == color]


def words(axes):
    return [text.get_text() for text in axes.texts if text.get_text()]


def drawn(drawing, given):
    with matplotlib.rc_context(style.STYLE):
        return drawing.draw(**drawing.values(given))


# --- All four ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("drawing", "given", "message"),
    [
        (GYROSCOPE, {"omega3": 0.0}, "omega3 must not be 0: a wheel that does not spin falls"),
        (GYROSCOPE, {"omega3": 100.0}, r"\|omega3\| must be at least 103\.001"),
        (WHEEL, {"omega3": 0.0}, "omega3 must not be 0: a wheel that does not spin falls"),
        (TOY, {"theta": 0.5}, r"the rim of the disc touches the table at 0\.4899"),
        (TOY, {"disc_height": 0.003}, "the disc must be on the stem"),
        (TOY, {"omega3": 50.0}, r"\|omega3\| must be at least 54\.8"),
    ],
)
def test_what_cannot_be_is_refused_by_picture_and_words(drawing, given, message):
    values = drawing.values(given)
    for each in (drawing.draw, drawing.caption, drawing.alternative):
        with pytest.raises(rt.RigidtopError, match=message):
            each(**values)


# --- Gyroscope and wheel -------------------------------------------------------------------------

HELD = [
    (GYROSCOPE, rotors.VIEW_GYROSCOPE, given)
    for given in (
        {},
        {"theta": math.pi / 2},
        {"theta": 2.3, "omega3": -150.0},
        {"theta": 3.0},
        {"omega3": 110.0, "theta": 0.8, "R": 0.06},
    )
] + [
    (WHEEL, rotors.VIEW_BICYCLE_WHEEL, given)
    for given in ({}, {"omega3": -9.0, "R": 0.4}, {"cord": 30.0, "omega3": 3.0})
]


def held_top(drawing, given):
    """Its body, θ and rates, with moments from the tables and Ω by the formula of a quadratic."""
    values = drawing.values(given)
    M, radius, R = values["M"], values["radius"], values["R"]
    theta = values.get("theta", math.pi / 2)
    share = 0.5 if drawing is GYROSCOPE else 1.0  # of Mr² about the axis, half of it across
    lambda3 = share * M * radius**2
    body = rt.HeavyTop(lambda1=lambda3 / 2 + M * R**2, lambda3=lambda3, M=M, R=R, g=9.81)
    momentum, weight = lambda3 * values["omega3"], M * 9.81 * R
    cosine = math.cos(theta) if drawing is GYROSCOPE and theta != math.pi / 2 else 0.0
    rate = weight / momentum
    if cosine:
        roots = np.roots([body.lambda1 * cosine, -momentum, weight])
        rate = float(min(roots, key=abs))
    return body, theta, values["omega3"], rate


@pytest.mark.parametrize(("drawing", "view", "given"), HELD)
def test_the_change_of_momentum_is_along_the_torque(drawing, view, given):
    """By the differences of an integrated motion, on paper."""
    body, theta, omega3, rate = held_top(drawing, given)
    motion = body.motion(theta=theta, phi=math.pi / 2, phi_dot=rate, omega3=omega3)
    step = 1e-5
    path = motion.integrate([-step, 0.0, step], rtol=1e-12, atol=1e-14)
    before, momentum, after = path.angular_momentum
    assert np.ptp(path.theta) < 1e-7  # it is steady
    change = (after - before) / (2 * step)
    pull = np.cross(body.R * path.e3[1], [0.0, 0.0, -body.M * 9.81])
    assert change == pytest.approx(pull, rel=1e-5, abs=1e-7)
    panel = drawn(drawing, given).axes[0]
    along = direction(np.array(view(change)[:2]))
    change_drawn, torque_drawn = arrows(panel, style.TORQUE)
    for start, tip in (change_drawn, torque_drawn):
        assert direction(tip - start) == pytest.approx(along, abs=1e-6)
    [(foot, tip)] = [
        each for each in arrows(panel, style.MOMENTUM) if each[0, 0] != each[1, 0]
    ]  # Mg, of the same colour, is upright
    assert direction(tip - foot) == pytest.approx(direction(view(momentum)[:2]), abs=1e-9)
    assert change_drawn[0] == pytest.approx(tip)
    assert torque_drawn[0] == pytest.approx((0, 0))
    size = math.hypot(body.R, drawing.values(given)["radius"])
    assert foot == pytest.approx(view(body.R / size * path.e3[1])[:2])
    way = line(panel, "_way")
    assert way[0] == pytest.approx(tip)
    assert direction(way[1] - way[0]) == pytest.approx(along, abs=0.02)  # a short chord
    shown = f"$\\Omega = {style.said(rate)}$ rad/s".replace("−", "-")
    assert shown in words(panel)


@pytest.mark.parametrize("given", [{}, {"theta": 2.2, "tolerance": 0.05}, {"theta": 0.3}])
def test_rates_against_the_spin(given):
    body, theta, omega3, rate = held_top(GYROSCOPE, given)
    chart = drawn(GYROSCOPE, given).axes[1]
    weight = body.M * 9.81 * body.R
    spin, exact = line(chart, r"$\Omega_-$ of (3.57)").T
    rest = body.lambda1 * math.cos(theta) * exact**2 - body.lambda3 * spin * exact + weight
    assert np.abs(rest).max() < 1e-9
    # The slow one of the two roots, whose product is MgR/(λ₁ cos θ).
    assert np.all(exact**2 <= weight / (body.lambda1 * abs(math.cos(theta))) * (1 + 1e-9))
    at, simple = line(chart, r"$MgR/(\lambda_3\omega_3)$").T
    assert simple * at * body.lambda3 == pytest.approx(weight)
    assert line(chart, "_now")[0] == pytest.approx((omega3, rate))
    tolerance = GYROSCOPE.values(given)["tolerance"]

    def apart(x):
        a, b = body.lambda1 * math.cos(theta), body.lambda3 * x
        slow = min(np.roots([a, -b, weight]), key=abs)
        return abs(slow * b / weight - 1) - tolerance

    needed = brentq(apart, 150.0, 5000.0)
    assert line(chart, "_needed")[:, 0] == pytest.approx(needed)
    assert f"{style.said(needed)} rad/s on" in unmarked(
        GYROSCOPE.caption(**GYROSCOPE.values(given))
    )
    assert f"{100 * tolerance:.3g} % apart" in words(chart)
    dotted = [each for each in chart.lines if each.get_label() == "_least"]
    assert len(dotted) == (theta < math.pi / 2)
    for each in dotted:
        least = 2 * math.sqrt(body.lambda1 * weight * math.cos(theta)) / body.lambda3
        assert each.get_xdata()[0] == pytest.approx(least)


@pytest.mark.parametrize("given", [{}, {"cord": 3.0, "omega3": 4.0}, {"cord": 0.3}])
def test_the_cord_leans_as_newton_says(given):
    """Its upright part bears the weight, its other keeps the wheel on a circle."""
    values = WHEEL.values(given)
    _, _, _, rate = held_top(WHEEL, given)
    panel = drawn(WHEEL, given).axes[0]
    view = rotors.VIEW_BICYCLE_WHEEL
    lower, upper = line(panel, "_cord")
    assert lower == pytest.approx((0, 0))
    # In the plane of ŷ and ẑ two numbers on paper give two in space.
    inward, up = np.linalg.solve(view.axes[:2, 1:], upper)
    sine = -inward / math.hypot(inward, up)
    reach = values["R"] + values["cord"] * sine
    assert -inward / up == pytest.approx(rate**2 * reach / 9.81)
    length = values["cord"] / math.hypot(values["R"], values["radius"])
    assert math.hypot(inward, up) == pytest.approx(min(length, rotors.LONGEST))
    pull = values["M"] * math.hypot(9.81, rate**2 * reach)
    caption = unmarked(WHEEL.caption(**values))
    assert (
        f"pulls with {style.said(pull)} N and leans by {style.degrees(math.asin(sine))}" in caption
    )


# --- The plate -----------------------------------------------------------------------------------

THROWN = [{}, {"theta": 0.6, "thickness": 0.05}, {"theta": 1.3}, {"thickness": 0.2}]


def thrown(given):
    """Wobble, mean rate of the mark, and the motion integrated: L upright, e₃ to the right."""
    values = PLATE.values(given)
    theta, spin = values["theta"], values["omega3"]
    across = values["radius"] ** 2 / 4 + values["thickness"] ** 2 / 12
    along = values["radius"] ** 2 / 2
    wobble = along * spin / (across * math.cos(theta))
    mark = wobble + spin - wobble * math.cos(theta)
    # e₁ towards the reader, e₂ to the right and down: L = λ₂ω₂ e₂ + λ₃ω₃ e₃ is upright.
    frame = np.array(
        [[1, 0, 0], [0, math.cos(theta), math.sin(theta)], [0, -math.sin(theta), math.cos(theta)]]
    )
    motion = rt.FreeBody(across, across, along).motion(
        omega=(0.0, -wobble * math.sin(theta), spin),
        attitude=Rotation.from_matrix(frame),
    )
    return wobble, mark, motion


@pytest.mark.parametrize("given", THROWN)
def test_plate_turns_as_it_is_integrated(given):
    wobble, mark, motion = thrown(given)
    chart = drawn(PLATE, given).axes[0]
    t, turns = line(chart, "_wobble").T
    assert t[-1] == pytest.approx(2 * 2 * math.pi / wobble)
    assert turns == pytest.approx(wobble * t / (2 * math.pi), abs=1e-9)
    run = motion.integrate(t, rtol=1e-11, atol=1e-13)
    momentum = run.angular_momentum
    assert momentum[:, :2] == pytest.approx(0, abs=1e-9 * momentum[0, 2])
    first = run.rotation.as_matrix()[:, :, 0]
    seen = np.unwrap(np.arctan2(first[:, 1], first[:, 0])) / (2 * math.pi)
    shown = line(chart, "_mark")[:, 1]
    assert shown == pytest.approx(seen - seen[0], abs=1e-7)
    # φ + atan2(sin ψ, cos θ cos ψ), which is φ + ψ to within arcsin tan²(θ/2).
    tilt = PLATE.values(given)["theta"]
    stray = math.asin(math.tan(tilt / 2) ** 2) + 1e-9
    assert np.abs(2 * math.pi * shown - mark * t).max() <= stray
    for label in ("_wobble", "_mark"):
        whole, dots = line(chart, label), line(chart, f"{label}_dots")
        assert dots[:, 0] == pytest.approx(np.linspace(0, t[-1], wobbles.PICTURES))
        assert dots[:, 1] == pytest.approx(np.interp(dots[:, 0], *whole.T))


def test_a_flat_plate_wobbles_twice_as_fast_as_its_mark_goes_round():
    chart = drawn(PLATE, {"theta": 0.001, "thickness": 1e-6}).axes[0]
    assert line(chart, "_wobble")[-1, 1] == pytest.approx(2)
    assert line(chart, "_mark")[-1, 1] == pytest.approx(1, abs=1e-5)


# --- The toy top ---------------------------------------------------------------------------------

SPUN = [{}, {"theta": 0.3, "omega3": -100.0}, {"stem_mass": 0.03, "stem_length": 0.08}]


def toy(given):
    values = TOY.values(given)
    disc, stem = values["disc_mass"], values["stem_mass"]
    r, h, z = values["disc_radius"], values["disc_thickness"], values["disc_height"]
    length = values["stem_length"]
    lambda1 = disc * (r**2 / 4 + h**2 / 12 + z**2) + stem * length**2 / 3
    body = rt.HeavyTop(
        lambda1=lambda1,
        lambda3=disc * r**2 / 2,
        M=disc + stem,
        R=(disc * z + stem * length / 2) / (disc + stem),
        g=9.81,
    )
    return values, body


def path_of(values, body, times):
    """x and y of the lean in degrees, integrated."""
    motion = body.motion(theta=values["theta"], omega3=values["omega3"])
    run = motion.integrate(times, rtol=1e-12, atol=1e-14)
    return np.degrees(run.theta) * np.array([np.cos(run.phi), np.sin(run.phi)])


@pytest.mark.parametrize("given", SPUN)
def test_path_of_the_toy_top(given):
    values, body = toy(given)
    shown = line(drawn(TOY, given).axes[1], "_path")
    motion = body.motion(theta=values["theta"], omega3=values["omega3"])
    last = 2 * math.pi / abs(motion.mean_precession)
    times = np.linspace(0, last, len(shown))[::200]
    expected = path_of(values, body, times)
    assert np.abs(shown[::200].T - expected).max() < 1e-5
    turned = np.ptp(np.unwrap(np.arctan2(*shown.T[::-1])))
    assert turned == pytest.approx(2 * math.pi, rel=0.05)
    lowest = style.said(float(np.hypot(*shown.T).max()))
    assert f"for one turn, down to {lowest}°." in unmarked(TOY.caption(**values))


@pytest.mark.parametrize("given", SPUN)
def test_rates_of_the_toy_top_against_its_spin(given):
    values, body = toy(given)
    chart = drawn(TOY, given).axes[2]
    theta, weight = values["theta"], body.M * 9.81 * body.R
    spin, turns = line(chart, "_turns of the axis").T
    slow, spin = 2 * math.pi * turns, spin * math.pi / 30
    rest = body.lambda1 * math.cos(theta) * slow**2 - body.lambda3 * spin * slow + weight
    assert np.abs(rest / weight).max() < 1e-9
    nutations = line(chart, "_nutations")[:, 1]
    for k in (40, 150, 299):
        kicked = body.motion(
            theta=theta, theta_dot=1e-5 * slow[k], phi_dot=slow[k], omega3=float(spin[k])
        )
        assert nutations[k] == pytest.approx(1 / kicked.nutation_period, rel=1e-6)
    now = abs(values["omega3"]) * 30 / math.pi
    for label in ("_nutations", "_turns of the axis"):
        [(at, value)] = line(chart, f"{label} now")
        assert at == pytest.approx(now)
        assert value == pytest.approx(np.interp(at, *line(chart, label).T), rel=1e-3)
    sleeping = 2 * math.sqrt(body.lambda1 * weight) / body.lambda3 * 30 / math.pi
    assert line(chart, "_sleeps")[:, 0] == pytest.approx(sleeping)
    caption = unmarked(TOY.caption(**values))
    energy = body.lambda3 * values["omega3"] ** 2 / 2
    assert f"sleeps from {style.said(sleeping, 4)} turns a minute on" in caption
    lift = energy / (body.M * 9.81)
    assert f"has {style.said(energy)} J, which could lift it by {style.said(lift)} m" in caption
