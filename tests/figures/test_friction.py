"""What the figures of tops with friction show, against facts found in another way."""

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

import rigidtop as rt
from rigidtop.derivations.exercises.friction import small_tilt_time
from rigidtop.figures import friction, style
from rigidtop.figures.catalog import named
from rigidtop.motion.table.motion import SlidingTop
from rigidtop.typeset.words import unmarked

from .conftest import line

RISING, WAKING = named("rising-top"), named("waking-top")
BODY = {"lambda1": 4e-5, "lambda3": 2.5e-5, "M": 0.1, "R": 0.03, "g": 9.81}


def bands(axes):
    """Lower and upper edge of each filled band, by its name."""
    found = {}
    for area in axes.collections:
        vertices = area.get_paths()[0].vertices
        count = (len(vertices) - 3) // 2
        lower, upper = vertices[1 : count + 1, 1], vertices[count + 2 : 2 * count + 2, 1][::-1]
        found[area.get_label()] = lower, upper
    return found


@pytest.fixture(scope="module")
def risen():
    """The panels as they are without any setting."""
    return RISING.draw(**RISING.values()).axes


@pytest.fixture(scope="module")
def again():
    """The motion of the default figure, by another solver and without its code."""
    weight = 0.1 * 9.81 * 0.02
    [rate] = [
        float(brentq(lambda x: 4e-5 * math.cos(0.5) * x**2 - 2.5e-5 * 200 * x + weight, 0, 50))
    ]
    top = SlidingTop(**BODY, tip=0.01, mu=0.1)
    motion = top.motion(theta=0.5, phi_dot=rate, omega3=200.0)
    return lambda times: motion.integrate(times, method="LSODA", rtol=1e-11, atol=1e-13)


def test_theta_slip_and_path_are_those_of_the_motion(risen, again):
    tilt, _, slip, track = risen
    t, theta = line(tilt, "_theta")[::160].T
    run = again(t)
    assert np.radians(theta) == pytest.approx(run.theta, abs=1e-6)
    assert line(slip, "_slip")[::160, 1] == pytest.approx(np.hypot(*run.slip.T), abs=1e-6)
    way = np.vstack([line(track, "_slides"), line(track, "_rolls")[1:]])[::160]
    below = run.position - 0.02 * run.e3
    assert way == pytest.approx(100 * below[:, :2], abs=1e-4)


def test_standstill_is_where_the_event_is(risen, again):
    tilt, energy, slip, _ = risen
    found = again(np.linspace(0, 1.0, 11))
    [event] = found.events
    assert event.kind == "standstill"
    for panel in (tilt, energy, slip):
        assert line(panel, "_standstill")[:, 0] == pytest.approx(event.time, abs=1e-6)
    t, speed = line(slip, "_slip").T
    assert np.all(speed[t < event.time] > 0)
    assert np.all(speed[t > event.time + 1e-9] == 0)
    assert f"until {style.said(event.time)} s (dotted)" in unmarked(
        RISING.caption(**RISING.values())
    )


def test_the_bands_add_up_to_what_the_spin_has_lost(risen, again):
    _, energy, _, _ = risen
    t, lost = line(energy, "lost by the spin").T
    shown = bands(energy)
    assert list(shown) == ["heat", "weight", "other motion"]
    edges = list(shown.values())
    assert edges[0][0] == pytest.approx(0)
    for (_, upper), (lower, _) in pairwise(edges):
        assert upper == pytest.approx(lower, abs=1e-12)
    assert edges[-1][1] == pytest.approx(lost, abs=1e-6 * lost.max())
    run = again(t[::160])
    spin = 2.5e-5 * (200.0**2 - run.omega[:, 2] ** 2) / 2
    assert lost[::160] == pytest.approx(1e3 * spin, abs=1e-4)
    height = run.position[:, 2] - run.position[0, 2]
    weight = shown["weight"][1] - shown["weight"][0]
    assert weight[::160] == pytest.approx(1e3 * 0.1 * 9.81 * height, abs=1e-4)
    # Heat is the work of the friction: its power is F·v.
    steps = np.linspace(0, t[800], 4001)
    fine = again(steps)
    power = -np.sum(fine.friction_force * fine.slip, axis=1)
    work = float(np.trapezoid(power, steps)) * 1e3
    heat = shown["heat"][1] - shown["heat"][0]
    assert heat[800] == pytest.approx(work, rel=1e-5)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"mu": 1.0, "omega3": 170.0, "theta": 1.0472}, "Then it ends with a lift-off."),
        ({"mu": 0.02, "omega3": 300.0}, "then rolls, but slips again and again"),
        ({"mu": 0.001}, "m/s, all the"),
    ],
)
def test_other_fates(given, words, monkeypatch):
    monkeypatch.setattr(friction, "MOST_TURNS", 400 if "again" in words else 150)
    values = RISING.values(given)
    assert words in unmarked(RISING.caption(**values))
    slip = RISING.draw(**values).axes[2]
    shown = [each for each in slip.lines if each.get_label() == "_standstill"]
    assert len(shown) == ("s (dotted)" in unmarked(RISING.caption(**values)))


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"until": 0.6}, "until = 0.6 must be less than theta = 0.5"),
        ({"tip": 0.04}, "tip = 0.04 must be less than R = 0.03"),
        ({"omega3": 20.0}, "no steady precession at theta = 0.5 with omega3 = 20"),
    ],
)
def test_no_rise(given, message):
    with pytest.raises(rt.RigidtopError, match=message):
        unmarked(RISING.caption(**RISING.values(given)))


# --- Waking --------------------------------------------------------------------------------------


@pytest.mark.parametrize("given", [{}, {"omega3": 190.0, "drag3": 1e-5, "visible": 0.05}])
def test_when_a_top_wakes(given):
    values = WAKING.values(given)
    tilt, spin = WAKING.draw(**values).axes
    decay = values["drag3"] / 2.5e-5
    about_tip = 4e-5 + 0.1 * 0.03**2
    sleeping = 2 * math.sqrt(about_tip * 0.1 * 9.81 * 0.03) / 2.5e-5
    assert line(spin, "_sleeping")[:, 1] == pytest.approx(sleeping)
    asleep = math.log(values["omega3"] / sleeping) / decay
    top = rt.HeavyTop(lambda1=about_tip, lambda3=2.5e-5, M=0.1, R=0.03, g=9.81)
    turning = 2.5e-5 * values["omega3"] / (2 * about_tip)
    seen = small_tilt_time(top, values["omega3"], decay, 1e-6, values["visible"], turning)
    assert f"θ̇ = 0 and φ̇ = {style.said(turning)} rad/s" in unmarked(WAKING.caption(**values))
    for panel in (tilt, spin):
        assert line(panel, "_asleep")[:, 0] == pytest.approx(asleep, abs=1e-4)
        assert line(panel, "_seen")[:, 0] == pytest.approx(seen, rel=2e-3)
    t, rate = line(spin, "_omega3").T
    early = t < asleep + 0.8 * (seen - asleep)
    assert rate[early] == pytest.approx(values["omega3"] * np.exp(-decay * t[early]), rel=1e-6)
    [(at, angle)] = line(tilt, "_visible")
    assert math.radians(angle) == pytest.approx(values["visible"])
    t, theta = line(tilt, "_theta").T
    assert np.interp(at, t, np.radians(theta)) == pytest.approx(values["visible"], rel=1e-3)
    assert theta[t < at].max() < angle
    assert (
        f"down to the sleeping spin, {style.said(sleeping)} rad/s, after {style.said(asleep)} s"
        in unmarked(WAKING.caption(**values))
    )


def test_growth_by_quadrature():
    top = friction.exercise.about_tip(**BODY)
    decay, sleeping = 5e-6 / 2.5e-5, top.sleeping_spin()
    for folds in (0.01, 3.0, 11.5, 200.0):

        def rate(t):
            return (
                top.lambda3 / (2 * top.lambda1) * sleeping * math.sqrt(-math.expm1(-2 * decay * t))
            )

        until = friction.exercise.time_to_grow(folds, 5e-6, **BODY)
        total, _ = quad(rate, 0, until, epsrel=1e-11)
        assert total == pytest.approx(folds, rel=1e-9)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"omega3": 150.0}, "omega3 = 150 must be more than the sleeping spin, 156.479 rad/s"),
        ({"drag3": 1e-8}, "turns until the top wakes, at most 1000 are drawn"),
    ],
)
def test_no_waking(given, message):
    with pytest.raises(rt.RigidtopError, match=message):
        unmarked(WAKING.caption(**WAKING.values(given)))
