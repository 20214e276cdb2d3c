"""Motions after many periods, from the period itself: by quadrature, without elliptic functions.

A turning motion goes back and forth between two roots of a polynomial.  With an angle χ in place of
the coordinate, u = (u₂+u₁)/2 + (u₂−u₁)/2 sin χ, the integrands are periodic and analytic in χ, so
that the trapezoidal rule converges as fast as a geometric series.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from mpmath.ctx_mp import MPContext
from taylor import Body, Number, Numbers, State, Top, body_start, follow_body, follow_top

FIRST_POINTS = 32
MOST_POINTS = 4096

LONGEST = 40
"""In rad: the series is followed through up to a whole period."""


class Period(NamedTuple):
    """T (s), and by how much the attitude has turned after it.

    For a heavy top R(t+T) = Rz(turn) R(t) Rz(own_turn): turn is φ(T) − φ(0), own_turn is
    ψ(T) − ψ(0).  For a free body `turn` is about the angular momentum and own_turn is 0.
    """

    time: Number
    turn: Number
    own_turn: Number


def trapezoidal(
    mp: MPContext, integrand: Callable[[Number], tuple[Number, ...]]
) -> tuple[Number, ...]:
    """The integrals of functions of χ with period 2π over a period, to nearly all digits."""
    points, before = FIRST_POINTS, None
    # The midpoints of one rule are the new points of the next.
    total = [mp.zero] * 3
    offset, count = mp.zero, points
    while points <= MOST_POINTS:
        for k in range(count):
            values = integrand(2 * mp.pi * (k + offset) / count)
            total = [x + y for x, y in zip(total, values, strict=True)]
        now = [x * 2 * mp.pi / points for x in total]
        if before is not None and all(
            abs(x - y) <= mp.mpf(10) ** -(mp.dps - 8) * (1 + abs(x))
            for x, y in zip(now, before, strict=True)
        ):
            return tuple(now)
        before, offset, count = now, mp.mpf(1) / 2, points
        points *= 2
    raise ArithmeticError("the integrand comes too near to a pole")


def top_period(mp: MPContext, top: Top) -> Period:
    """Of the nutation of a heavy top, away from the vertical and from any separatrix.

    With u = cos θ,  u̇² = (2/λ₁)(E′ − MgR u)(1−u²) − ((p_φ − p_ψ u)/λ₁)²,
    φ̇ = (p_φ − p_ψ u)/(λ₁(1−u²)) and ψ̇ = ω₃ − φ̇ u.
    """
    cosine, sine = mp.cos(top.theta), mp.sin(top.theta)
    p_psi = top.lambda3 * top.omega3
    p_phi = top.lambda1 * top.phi_dot * sine**2 + p_psi * cosine
    energy = top.lambda1 * (top.theta_dot**2 + (top.phi_dot * sine) ** 2) / 2 + top.weight * cosine
    cubic = [
        2 * top.weight / top.lambda1,
        -2 * energy / top.lambda1 - (p_psi / top.lambda1) ** 2,
        -2 * top.weight / top.lambda1 + 2 * p_phi * p_psi / top.lambda1**2,
        2 * energy / top.lambda1 - (p_phi / top.lambda1) ** 2,
    ]
    roots = mp.polyroots(cubic, maxsteps=200, extraprec=200)
    low, high, beyond = sorted(mp.re(root) for root in roots)
    if low < -0.97 or high > 0.97 or high - low < 1e-4 or beyond - high < 0.03:
        raise ArithmeticError("too near to a special case")

    def integrand(chi: Number) -> tuple[Number, ...]:
        u = (high + low) / 2 + (high - low) / 2 * mp.sin(chi)
        per_angle = 1 / mp.sqrt(cubic[0] * (beyond - u))  # dt/dχ
        precession = (p_phi - p_psi * u) / (top.lambda1 * (1 - u * u))
        return per_angle, precession * per_angle, (top.omega3 - precession * u) * per_angle

    return Period(*trapezoidal(mp, integrand))


def body_period(mp: MPContext, body: Body) -> Period:
    """Of a free body with three different moments, away from the separatrix and steady rotation.

    Along the axis `c` (of the largest or of the smallest moment) ω keeps its sign; `b` is the
    middle axis and ω_b = W sin χ.  The axis `c` turns about L at the rate
    |L| (λ_aω_a² + λ_bω_b²)/(L_a² + L_b²).
    """
    moments, omega = body[:3], body[3:6]
    squared = sum((x * y) ** 2 for x, y in zip(moments, omega, strict=True))
    double_energy = sum(x * y**2 for x, y in zip(moments, omega, strict=True))
    smallest, middle, largest = sorted(moments)
    around_largest = squared > double_energy * middle
    c, a = (largest, smallest) if around_largest else (smallest, largest)
    b = middle
    # a (c−a) ω_a² + b (c−b) ω_b² = 2E c − L² and c (c−a) ω_c² + b (b−a) ω_b² = L² − 2E a, each of
    # one sign throughout.
    across, along = double_energy * c - squared, squared - double_energy * a
    W2 = across / (b * (c - b))
    ratio = W2 * b * (b - a) / along  # the share of the second sum that moves to and fro
    if ratio > 0.97 or W2 * b < 0.003 * double_energy or abs(c - a) < 0.03 * largest:
        raise ArithmeticError("too near to a special case")
    size = mp.sqrt(squared)

    def integrand(chi: Number) -> tuple[Number, ...]:
        omega_b2 = W2 * mp.sin(chi) ** 2
        omega_a2 = W2 * mp.cos(chi) ** 2 * b * (c - b) / (a * (c - a))
        omega_c2 = (along - b * (b - a) * omega_b2) / (c * (c - a))
        # ω̇_b = ±(c−a)/b ω_c ω_a, and ω_a = cos χ times a constant.
        rate = mp.sqrt(omega_c2 * (c - b) * (c - a) / (a * b))
        turning = size * (a * omega_a2 + b * omega_b2) / (a**2 * omega_a2 + b**2 * omega_b2)
        return 1 / rate, turning / rate, mp.zero

    period = Period(*trapezoidal(mp, integrand))
    if period.time * mp.sqrt(sum(x * x for x in omega)) > LONGEST:
        raise ArithmeticError("too near to two equal moments")
    return period


def later_top(numbers: Numbers, top: Top, period: Period, times: Sequence[Number]) -> list[State]:
    """The states at `times` (s), however late, from the series within one period."""
    counts, rests = _divided(times, period)
    states = []
    for count, state in zip(counts, follow_top(numbers, top, rests), strict=True):
        turn, own_turn = numbers.turn(count * period.turn / 2), count * period.own_turn
        half = numbers.turn(own_turn / 2)
        kappa = numbers.complex(state.omega1, state.omega2) * (half * half).conjugate()
        alpha, beta = state.alpha * turn * half, state.beta * turn * half.conjugate()
        states.append(State(alpha, beta, kappa.real, kappa.imag, state.omega3))
    return states


def later_body(
    numbers: Numbers, body: Body, period: Period, times: Sequence[Number]
) -> list[State]:
    """The states at `times` (s), however late, from the series within one period."""
    counts, rests = _divided(times, period)
    start = body_start(numbers, body)
    momentum = [x * y for x, y in zip(body[:3], start.omega, strict=True)]
    # L in space components: q∘(0, Iω)∘q̄.
    inverse = [start.quaternion[0], *(-x for x in start.quaternion[1:])]
    axis = product(product(start.quaternion, (numbers.real(0), *momentum)), inverse)[1:]
    size = numbers.sqrt(sum(x * x for x in axis))
    states = []
    for count, state in zip(counts, follow_body(numbers, body, rests), strict=True):
        half = numbers.turn(count * period.turn / 2)
        turned = (half.real, *(x * half.imag / size for x in axis))
        q0, q1, q2, q3 = product(turned, state.quaternion)
        attitude = numbers.complex(q0, q3), numbers.complex(q2, -q1)
        states.append(State(*attitude, *state.omega))
    return states


def product(p: Sequence[Number], q: Sequence[Number]) -> tuple[Number, ...]:
    """Of quaternions, scalar first."""
    return (
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3],
        p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1],
    )


def _divided(times: Sequence[Number], period: Period) -> tuple[list[int], list[Number]]:
    counts = [math.floor(t / period.time) for t in times]
    return counts, [t - n * period.time for n, t in zip(counts, times, strict=True)]
