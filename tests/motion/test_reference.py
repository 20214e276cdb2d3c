"""The reference itself: its series, what is stored of it, and the integrator judged by it."""

import math

import draw
import judge
import numpy as np
import pytest
import taylor
from judge import Reference
from make import body_of, period_of, top_of
from mpmath import mp
from periods import later_body, later_top, product
from taylor import Body, Number, Numbers, State, Top

DIGITS = 45


@pytest.fixture(scope="module")
def numbers() -> Numbers:
    return taylor.mpmath_numbers(DIGITS)


def gap(numbers: Numbers, one: State, other: State) -> float:
    return max(taylor.differences(numbers, one, other))


def some_top(numbers: Numbers, **changes: Number) -> Top:
    values = (1.0, 0.5, 4.9, 0.5, 0.1, 0.3, 0.2, 0.7, 5.0)
    return Top(*(numbers.real(x) for x in values))._replace(**changes)


def test_symmetric_free_body_turns_about_its_momentum_and_its_axis(numbers: Numbers) -> None:
    """R(t) = (turn by |L|t/λ₁ about L) R(0) Rz((1 − λ₃/λ₁) ω₃ t)."""
    top = some_top(numbers, weight=numbers.real(0))
    start = taylor.top_start(numbers, top)
    body = Body(top.lambda1, top.lambda1, top.lambda3, *start.omega, *start.quaternion)
    # In body components at t = 0: a turn about those of L, before R(0), is about L in space.
    momentum = [x * y for x, y in zip(body[:3], start.omega, strict=True)]
    size = numbers.sqrt(sum(x * x for x in momentum))
    t = numbers.real(3)
    half = numbers.turn(size * t / (2 * top.lambda1))
    own = numbers.turn((1 - top.lambda3 / top.lambda1) * top.omega3 * t / 2)
    turned = product(start.quaternion, (half.real, *(x / size * half.imag for x in momentum)))
    q0, q1, q2, q3 = product(turned, (own.real, t * 0, t * 0, own.imag))
    kappa = numbers.complex(*start.omega[:2]) * (own * own).conjugate()
    attitude = numbers.complex(q0, q3), numbers.complex(q2, -q1)
    known = State(*attitude, kappa.real, kappa.imag, top.omega3)
    assert gap(numbers, known, taylor.follow_top(numbers, top, [t])[0]) < 1e-38
    assert gap(numbers, known, taylor.follow_body(numbers, body, [t])[0]) < 1e-38


def test_steady_precession(numbers: Numbers) -> None:
    """φ̇ = Ω with λ₁Ω² cos θ − λ₃ω₃Ω + MgR = 0, and ψ̇ = ω₃ − Ω cos θ."""
    rate, zero, t = numbers.real(0.75), numbers.real(0), numbers.real(-4)
    top = some_top(numbers, phi_dot=rate, theta_dot=zero)
    cosine = numbers.cos(top.theta)
    omega3 = (top.lambda1 * cosine * rate**2 + top.weight) / (top.lambda3 * rate)
    top = top._replace(omega3=omega3)
    later = top._replace(phi=top.phi + rate * t, psi=top.psi + (omega3 - rate * cosine) * t)
    computed = taylor.follow_top(numbers, top, [t])[0]
    assert gap(numbers, taylor.top_start(numbers, later), computed) < 1e-38


def test_plane_pendulum(numbers: Numbers) -> None:
    """From rest at θ₀ back to rest there, after 4 K(cos(θ₀/2)) √(λ₁/MgR)."""
    zero = numbers.real(0)
    top = some_top(numbers, theta_dot=zero, phi_dot=zero, omega3=zero)
    with mp.workdps(DIGITS):
        period = 4 * mp.ellipk(mp.cos(mp.mpf(0.5) / 2) ** 2) * mp.sqrt(1 / mp.mpf(4.9))
    start, end = taylor.follow_top(numbers, top, [zero, numbers.real(period)])
    assert gap(numbers, start, end) < 1e-38


def test_tiny_tilts_are_as_precise_as_large_ones(numbers: Numbers) -> None:
    """Small motions about the vertical scale with the tilt."""
    tiny = numbers.real("1e-200")
    times = [numbers.real(1)]
    small = some_top(numbers, theta=tiny, theta_dot=3 * tiny)
    twice = small._replace(theta=2 * tiny, theta_dot=6 * tiny)
    one, other = (taylor.follow_top(numbers, top, times)[0] for top in (small, twice))
    assert abs(other.beta / one.beta - 2) < 1e-38


def energy(top: Top, state: State) -> Number:
    across = state.omega1**2 + state.omega2**2
    q0, q1, q2, q3 = state.quaternion
    height = q0**2 - q1**2 - q2**2 + q3**2
    return (top.lambda1 * across + top.lambda3 * state.omega3**2) / 2 + top.weight * height


def vertical_momentum(top: Top, state: State) -> Number:
    q0, q1, q2, q3 = state.quaternion
    z = 2 * (q1 * q3 - q0 * q2), 2 * (q0 * q1 + q2 * q3), q0**2 - q1**2 - q2**2 + q3**2
    across = top.lambda1 * (z[0] * state.omega1 + z[1] * state.omega2)
    return across + top.lambda3 * z[2] * state.omega3


def test_constants_of_the_motion(numbers: Numbers) -> None:
    top = some_top(numbers)
    states = taylor.follow_top(numbers, top, [numbers.real(t) for t in (0, 1, -2)])
    for constant in (energy, vertical_momentum):
        values = [constant(top, state) for state in states]
        assert max(abs(value - values[0]) for value in values) < 1e-38
    for state in states:
        assert abs(sum(x * x for x in state.quaternion) - 1) < 1e-38


def test_series_solve_the_plain_equations(numbers: Numbers) -> None:
    """Central differences of the solutions against q̇ = ½ q∘(0, ω) and Euler's equations."""
    h, t = numbers.real("1e-12"), numbers.real(0.25)
    top = some_top(numbers)
    q, omega = (0.5, 0.1, -0.7, 0.4), (0.3, -2.0, 1.1)
    body = Body(*(numbers.real(x) for x in (1.0, 1.5, 2.0, *omega, *q)))
    for motion, follow in ((top, taylor.follow_top), (body, taylor.follow_body)):
        before, now, after = follow(numbers, motion, [t - h, t, t + h])
        earlier, later = ((*state.quaternion, *state.omega) for state in (before, after))
        rates = [(x - y) / (2 * h) for x, y in zip(later, earlier, strict=True)]
        (q0, q1, q2, q3), (w1, w2, w3) = now.quaternion, now.omega
        if isinstance(motion, Top):
            moments = motion.lambda1, motion.lambda1, motion.lambda3
            torque = (
                motion.weight * 2 * (q0 * q1 + q2 * q3),
                -motion.weight * 2 * (q1 * q3 - q0 * q2),
                0,
            )
        else:
            moments, torque = motion[:3], (0, 0, 0)
        l1, l2, l3 = moments
        expected = (
            (-q1 * w1 - q2 * w2 - q3 * w3) / 2,
            (q0 * w1 + q2 * w3 - q3 * w2) / 2,
            (q0 * w2 + q3 * w1 - q1 * w3) / 2,
            (q0 * w3 + q1 * w2 - q2 * w1) / 2,
            ((l2 - l3) * w2 * w3 + torque[0]) / l1,
            ((l3 - l1) * w3 * w1 + torque[1]) / l2,
            ((l1 - l2) * w1 * w2 + torque[2]) / l3,
        )
        assert max(abs(x - y) for x, y in zip(rates, expected, strict=True)) < 1e-20


def test_periods_by_quadrature_agree_with_the_series(numbers: Numbers) -> None:
    top = some_top(numbers)
    period = period_of(numbers, top)
    times = [-period.time / 2]  # from the half of the period that follows
    direct = taylor.follow_top(numbers, top, times)[0]
    assert gap(numbers, direct, later_top(numbers, top, period, times)[0]) < 1e-35
    q, omega = (0.5, 0.1, -0.7, 0.4), (0.3, -1.0, 2.1)
    body = Body(*(numbers.real(x) for x in (2.0, 1.0, 1.5, *omega, *q)))
    period = period_of(numbers, body)
    times = [-period.time / 2]
    direct = taylor.follow_body(numbers, body, times)[0]
    assert gap(numbers, direct, later_body(numbers, body, period, times)[0]) < 1e-35


@pytest.mark.parametrize(
    "family", ["loops", "near_asymptotic", "through_hanging", "si_sizes", "leaving_middle", "rods"]
)
def test_stored_motions_come_out_again(numbers: Numbers, family: str) -> None:
    reference = judge.of_family(family)[1]
    times = [numbers.real(t) for t in reference.times[:2]]
    if reference.kind == "tops":
        states = taylor.follow_top(numbers, top_of(numbers, reference.inputs), times)
    else:
        states = taylor.follow_body(numbers, body_of(numbers, reference.inputs), times)
    for state, q, omega in zip(states, reference.attitude, reference.omega, strict=False):
        assert [float(x) for x in state.quaternion] == pytest.approx(q, rel=1e-15, abs=1e-30)
        assert [float(x) for x in state.omega] == pytest.approx(omega, rel=1e-15, abs=1e-30)


def test_all_families_are_stored() -> None:
    count = {
        kind: sum(reference.kind == kind for reference in judge.references())
        for kind in judge.FILES
    }
    assert count["tops"] >= 1200
    assert count["bodies"] >= 1000
    assert count["far"] == 300
    expected = {*draw.TOP_FAMILIES, *draw.BODY_FAMILIES, "far_tops", "far_bodies"}
    assert set(judge.families()) == expected


def test_stored_numbers_are_sound() -> None:
    for one in judge.references():
        for numbers in (one.inputs, one.times, one.attitude, one.omega, one.sensitivity):
            assert np.all(np.isfinite(numbers)), one.name
        assert abs(np.linalg.norm(one.attitude, axis=1) - 1).max() < 3e-16, one.name
        assert np.all(one.sensitivity >= 0), one.name
        # A unit of t turns the body by |ω| of it, whatever else changes.
        least = np.linalg.norm(one.omega, axis=1) * [math.ulp(t) for t in one.times]
        assert np.all(one.sensitivity[:, 0] >= least * (1 - 1e-6) - 1e-30), one.name


def spread() -> list[Reference]:
    return [one for one in judge.references() if one.kind != "far"][::30]


def test_integrator_agrees_with_the_reference() -> None:
    """At rtol = 1e-12, to 5e-11 and what 10⁴ units in the last place of the inputs do.

    A step's error is that many units, and an unstable motion makes it grow like a change of the
    inputs.
    """
    judged = spread()
    assert len(judged) > 70
    for reference in judged:
        run = reference.motion.integrate(reference.times, rtol=1e-12, atol=1e-14)
        allowed = judge.allowed(reference, error=5e-11, units=1e4)
        assert np.all(judge.errors(reference, run) <= allowed), judge.describe(reference)
