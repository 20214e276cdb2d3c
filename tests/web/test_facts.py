"""What the page says of a motion is what Python computes of it."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

import rigidtop as rt
from rigidtop.web.presets import TOP
from rigidtop.web.setup import setup_of

WORDS = {"steady": "steady precession", "plane": "plane pendulum", "asymptotic": "waves"}


def facts(engine, motion):
    setup = setup_of(motion)
    return engine.run(
        "factsOf(createMotion(setup, tableau))",
        setup={"kind": setup.kind, "clock": setup.clock, "values": dict(setup.values)},
    )


@settings(max_examples=50)
@given(
    st.floats(0.05, 3.0), st.sampled_from([0.0, 0.0, 1.0, -2.0]), st.floats(-8, 8),
    st.floats(-30, 30),
)  # fmt: skip
def test_regime_and_turning_points_of_any_top(engine, tableau, theta, theta_dot, phi_dot, omega3):
    motion = TOP.motion(theta=theta, theta_dot=theta_dot, phi_dot=phi_dot, omega3=omega3)
    found = facts(engine, motion)
    assume(motion.regime in ("waves", "loops", "cusps"))
    assume(abs(phi_dot) + abs(omega3) > 1e-6)  # else it is a pendulum, to rounding
    # φ̇ that vanishes at a turning point to nine digits is a cusp for one and none for the other.
    least, most = motion.turning_points
    rates = [abs(motion.start().p_phi[0] - motion.start().p_psi[0] * math.cos(x))
             for x in (least, most)]  # fmt: skip
    if min(rates) > 1e-7 * max(rates):
        assert found["regime"] == motion.regime
    assert math.isclose(found["turningPoints"][0], least, abs_tol=1e-7)
    assert math.isclose(found["turningPoints"][1], most, abs_tol=1e-7)


def alike(theta, omega3):
    """φ̇ with which p_φ = p_ψ, and with which p_φ = −p_ψ."""
    ratio = TOP.lambda3 / TOP.lambda1 * omega3 / math.sin(theta) ** 2
    return {"alike": ratio * (1 - math.cos(theta)), "opposite": -ratio * (1 + math.cos(theta))}


@pytest.mark.parametrize("theta", [math.radians(10), 0.5, 2.0, 3.0])
@pytest.mark.parametrize("theta_dot", [0.0, -2.0])
@pytest.mark.parametrize("omega3", [0.0, -3.0, 12.0])
@pytest.mark.parametrize("phi_dot", ["alike", "opposite", 0.0, 1.0, -1.5])
def test_where_the_axis_may_pass_through_the_vertical(
    engine, tableau, theta, theta_dot, omega3, phi_dot
):
    rate = alike(theta, omega3).get(phi_dot, phi_dot)
    motion = TOP.motion(theta=theta, theta_dot=theta_dot, phi_dot=rate, omega3=omega3)
    found = facts(engine, motion)
    # Near a pole θ goes with the root of what is rounded.
    assert found["turningPoints"] == pytest.approx(motion.turning_points, abs=1e-6)
    # The formulas of `alike` round, too: Python then sees a motion beside the special one.
    if phi_dot not in ("alike", "opposite"):
        assert found["regime"] == WORDS.get(motion.regime, motion.regime)


@pytest.mark.parametrize(
    ("state", "regime"),
    [
        ({"theta": 0.0, "omega3": 9.0}, "sleeping"),
        ({"theta": math.pi, "omega3": 9.0}, "hanging"),
        ({"theta": 0.5, "omega3": 0.0}, "plane pendulum"),
        ({"theta": 0.5, "omega3": 12.0}, "cusps"),
        ({"theta": 0.0, "theta_dot": 1.0, "omega3": 5.0}, "through the vertical"),
    ],
)
def test_special_starts(engine, tableau, state, regime):
    motion = TOP.motion(**state)
    found = facts(engine, motion)
    assert found["regime"] == regime == WORDS.get(motion.regime, motion.regime)


@settings(max_examples=25)
@given(st.floats(0.02, 3.1), st.floats(-8, 8), st.floats(-30, 30))
@example(1.0, 0.0078125, 0.0)
@example(1.0, 1e-6, 0.0)
def test_the_mean_precession_is_that_of_the_closed_form(engine, tableau, theta, phi_dot, omega3):
    motion = TOP.motion(theta=theta, phi_dot=phi_dot, omega3=omega3)
    assume(motion.regime in ("waves", "loops", "cusps"))
    said = facts(engine, motion)["verdict"]
    assume("on average" in said)
    found = float(re.search(r"([-−.e\d]+) rad/s on average", said)[1].replace("−", "-"))
    expected = motion.precession_per_period / motion.nutation_period
    assert math.isclose(found, expected, rel_tol=1e-3, abs_tol=1e-9)


@pytest.mark.parametrize("which", [0, 1])
@pytest.mark.parametrize("omega3", [7.0, -7.0, 12.0, 40.0])
def test_both_steady_rates_are_steady(engine, tableau, which, omega3):
    rates = TOP.steady_precession(0.5, omega3)
    found = facts(engine, TOP.motion(theta=0.5, phi_dot=rates[which], omega3=omega3))
    assert found["regime"] == "steady precession"
    assert found["verdict"].startswith("Steady precession: θ stays at 28.65°. ")
    assert found["steady"] == pytest.approx(rates, rel=1e-12)
    near = facts(engine, TOP.motion(theta=0.5, phi_dot=rates[which] * 1.001, omega3=omega3))
    assert near["regime"] == "waves"
    assert near["verdict"].startswith("It precesses, and nods by no more than 0.0")


def test_a_flip_says_so_and_when(engine, tableau):
    motion = rt.FreeBody(1.0, 1.7, 2.3).motion(omega=(0.02, 4.0, 0.02))
    said = facts(engine, motion)["verdict"]
    # ω₂ has one sign until it turns over: a period of the body's nutation is twice that.
    times = np.linspace(0.0, 60.0, 60001)
    middle = motion.exact(times).omega[:, 1]
    signs = times[1:][np.diff(np.sign(middle)) != 0]
    assert f"turns over every {np.diff(signs).mean():.3f} s" in said
    assert "It flips: it spins about e₂" in said
    gentle = rt.FreeBody(1.0, 1.7, 2.3).motion(omega=(3.0, 1.0, 0.5))
    assert "flips" not in facts(engine, gentle)["verdict"]


@settings(max_examples=25, deadline=None)
@given(
    theta=st.floats(0.1, 3.0), phi_dot=st.floats(-8, 8), omega3=st.floats(-30, 30),
)  # fmt: skip
def test_the_map_of_starts_agrees_with_the_motions(engine, tableau, theta, phi_dot, omega3):
    motion = TOP.motion(theta=theta, phi_dot=phi_dot, omega3=omega3)
    rates = [abs(motion.start().p_phi[0] - motion.start().p_psi[0] * math.cos(x))
             for x in motion.turning_points]  # fmt: skip
    assume(min(rates) > 1e-7 * max(rates))
    assume(abs(phi_dot) + abs(omega3) > 1e-6)  # else it is a pendulum, to rounding
    regime = motion.regime
    top = {name: getattr(TOP, name) for name in ("M", "R", "g", "lambda1", "lambda3")}
    sign = engine.run("backwards(top, ...start)", top=top, start=[theta, phi_dot, omega3])
    if regime == "waves":
        assert sign == 1
    if regime == "loops":
        assert sign == -1


BODIES = [(1.0, 1.7, 2.3), (2.3, 1.0, 1.7), (1.3, 1.3, 0.7), (1, 2, 2), (2, 1, 2), (1, 1, 1)]


@settings(max_examples=80)
@given(
    st.sampled_from(BODIES),
    st.lists(st.sampled_from([0.0, 0.5, 1.0, -2.0, 3.7]), min_size=3, max_size=3),
)
def test_the_regime_of_any_free_body(engine, tableau, moments, omega):
    assume(any(omega))
    motion = rt.FreeBody(*moments).motion(omega=omega)
    assert facts(engine, motion)["regime"] == motion.regime


@pytest.mark.parametrize("oblate", [False, True])
def test_omega_turns_the_way_that_is_said(engine, tableau, oblate):
    moments = (1.0, 1.0, 2.0) if oblate else (1.3, 1.3, 0.7)
    motion = rt.FreeBody(*moments).motion(omega=(1.5, 0, 2.5))
    turned = math.atan2(*motion.exact([0.1]).omega[0, [1, 0]])
    verdict = facts(engine, motion)["verdict"]
    assert ("turns anticlockwise" in verdict) is (turned > 0)
    assert ("turns clockwise" in verdict) is (turned < 0)


def test_a_top_whose_centre_of_mass_is_on_the_other_side(engine, tableau):
    body = rt.HeavyBody(1.3, 1.3, 0.7, M=0.8, centre_of_mass=(0, 0, -0.6))
    for theta, mirrored in ((0.5, math.pi - 0.5), (2.5, math.pi - 2.5)):
        start = TOP.motion(theta=theta, phi_dot=0.3, omega3=9.0)
        found = facts(engine, body.motion(omega=start.omega, attitude=start.attitude))
        same = facts(engine, TOP.motion(theta=mirrored, phi_dot=0.3, omega3=-9.0))
        assert found["steady"] == pytest.approx(same["steady"], rel=1e-12)
        assert found["smallestSpin"] == pytest.approx(same["smallestSpin"])
        least, most = same["turningPoints"]
        assert found["turningPoints"] == pytest.approx((math.pi - most, math.pi - least), abs=1e-9)
        assert found["regime"] == same["regime"]


def test_friction_says_how_fast_it_takes_the_spin(engine, tableau):
    setup = {"kind": "heavy-top", "clock": "s", "values": {
        "lambda1": 1.3, "lambda2": 1.3, "lambda3": 0.7, "M": 0.8, "g": 9.81, "R": 0.6, "R1": 0,
        "R2": 0, "friction": 0.05, "theta": 0.5, "theta_dot": 0, "phi": 0, "phi_dot": 0, "psi": 0,
        "omega3": 12}}  # fmt: skip
    text = "factsOf(createMotion(setup, tableau))"
    assert engine.run(text, setup=setup)["verdict"] == (
        "Friction takes the spin: ω₃ halves every 9.704 s. From t = 7.409 s on it is too slow to "
        "sleep upright."
    )
    setup["values"]["lambda2"] = 1.2
    assert "at the rate cω²" in engine.run(text, setup=setup)["verdict"]


def test_without_symmetry_nothing_is_promised(engine, tableau):
    body = rt.HeavyBody(1.3, 1.4, 0.7, M=0.8, centre_of_mass=(0, 0, 0.6))
    found = facts(engine, body.motion(omega=(0, 0, 12.0)))
    assert found["steady"] is None
    assert found["turningPoints"] is None
    assert "in general only the energy and p_φ are conserved" in found["verdict"]
