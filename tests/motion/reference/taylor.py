"""Motions at 40 digits: Taylor series of the equations of motion, nothing else.

The attitude R (body components to space components) is the quaternion q, scalar first, written as
two complex numbers, and ω₁ and ω₂ (body components, rad/s) as one:

    α = q₀ + i q₃,    β = q₂ − i q₁,    κ = ω₁ + i ω₂.

Then q̇ = ½ q∘(0, ω) is

    α̇ = ½ i (ω₃ α − β κ̄),    β̇ = −½ i (ω₃ β + α κ),

and −2 ᾱβ = z₁ + i z₂ are the first two body components of ẑ.  All right-hand sides are sums of
products of two unknowns, so each coefficient of a series follows from a convolution of those
before it.

Nothing here depends on the package that is judged, and the type of the numbers is an argument:
mpmath serves where a few motions are wanted, gmpy2 is some ten times faster.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from operator import mul
from typing import Any, NamedTuple

Number = Any
"""A real or complex number of whatever type `Numbers` makes."""

ORDER = 48
"""About ½ ln(1/TOLERANCE), at which the least work is done per unit of time."""

TOLERANCE = 1e-44
"""Size of the last coefficient's term in a step, relative to that unknown."""


@dataclass(frozen=True)
class Numbers:
    """A type of numbers: how it is made from floats, and the functions that are needed."""

    real: Callable[[Any], Number]
    complex: Callable[[Any, Any], Number]
    cos: Callable[[Number], Number]
    sin: Callable[[Number], Number]
    sqrt: Callable[[Number], Number]
    pi: Number

    def turn(self, angle: Number) -> Number:
        """exp(i angle)."""
        return self.complex(self.cos(angle), self.sin(angle))


def mpmath_numbers(digits: int = 50) -> Numbers:
    from mpmath.ctx_mp import MPContext

    context = MPContext()
    context.dps = digits
    return Numbers(context.mpf, context.mpc, context.cos, context.sin, context.sqrt, +context.pi)


def gmpy2_numbers(bits: int = 170) -> Numbers:
    """Sets the precision of the thread's context, which gmpy2 keeps globally."""
    import gmpy2

    gmpy2.get_context().precision = bits
    return Numbers(gmpy2.mpfr, gmpy2.mpc, gmpy2.cos, gmpy2.sin, gmpy2.sqrt, gmpy2.const_pi())


class State(NamedTuple):
    """Attitude and ω at one time; α and β complex, ω real."""

    alpha: Number
    beta: Number
    omega1: Number
    omega2: Number
    omega3: Number

    @property
    def quaternion(self) -> tuple[Number, Number, Number, Number]:
        """q, scalar first."""
        return self.alpha.real, -self.beta.imag, self.beta.real, self.alpha.imag

    @property
    def omega(self) -> tuple[Number, Number, Number]:
        """Body components, rad/s."""
        return self.omega1, self.omega2, self.omega3


class Top(NamedTuple):
    """A heavy symmetric top and its motion: λ₁, λ₃ (kg m²), MgR (J), angles (rad), rates (rad/s).

    R = Rz(φ) Ry(θ) Rz(ψ), and ω₃ = ψ̇ + φ̇ cos θ.
    """

    lambda1: Number
    lambda3: Number
    weight: Number
    theta: Number
    theta_dot: Number
    phi: Number
    phi_dot: Number
    psi: Number
    omega3: Number


class Body(NamedTuple):
    """A free body and its motion: moments (kg m²), ω (rad/s, body components), q at t = 0.

    q, scalar first, need not have length 1: it is normalised.
    """

    lambda1: Number
    lambda2: Number
    lambda3: Number
    omega1: Number
    omega2: Number
    omega3: Number
    q0: Number
    q1: Number
    q2: Number
    q3: Number


def _convolution(left: Sequence[Number], right: Sequence[Number]) -> Number:
    """The next coefficient of a product of series."""
    return sum(map(mul, left, reversed(right)))


def _size(value: Number) -> Number:
    return max(abs(value.real), abs(value.imag))


Series = Callable[[tuple[Number, ...]], list[list[Number]]]
"""From a state, the Taylor coefficients of each of its components."""


def _follow(series: Series, start: tuple[Number, ...], ends: Sequence[Number]) -> Iterator[Any]:
    """The states at `ends`, which all lie on one side of 0, in order of distance from it."""
    state, now = start, ends[0] * 0
    for end in ends:
        while (left := end - now) != 0:
            columns = series(state)
            step = abs(left)
            for column in columns:
                # The first terms tell how large an unknown is, though it be passing through zero.
                size = max(map(_size, column[:3]))
                for n in (ORDER - 1, ORDER):
                    last = float(_size(column[n]) / size) if size else 0.0
                    if last > 0:
                        step = min(step, (TOLERANCE / last) ** (1 / n))
            h = left if step >= abs(left) else math.copysign(1.0, float(left)) * step
            values = []
            for coefficients in columns:
                value = coefficients[-1]
                for coefficient in reversed(coefficients[:-1]):
                    value = value * h + coefficient
                values.append(value)
            state, now = tuple(values), now + h
        yield state


def _both_sides(
    series: Series, start: tuple[Number, ...], times: Sequence[Number]
) -> list[tuple[Number, ...]]:
    """The states at `times`, in any order, of either sign."""
    found: dict[int, tuple[Number, ...]] = {}
    for side in (
        [k for k, t in enumerate(times) if t >= 0],
        [k for k, t in enumerate(times) if t < 0],
    ):
        side.sort(key=lambda k: abs(times[k]))
        ends = [times[k] for k in side]
        found.update(zip(side, _follow(series, start, ends) if ends else (), strict=True))
    return [found[k] for k in range(len(times))]


def top_start(numbers: Numbers, top: Top) -> State:
    """α = cos(θ/2) exp(i(φ+ψ)/2), β = sin(θ/2) exp(i(φ−ψ)/2), κ = (−φ̇ sin θ + iθ̇) exp(−iψ).

    The float nearest to π stands for π: a top that hangs straight down.
    """
    theta = numbers.pi if top.theta == math.pi else top.theta
    alpha = numbers.cos(theta / 2) * numbers.turn((top.phi + top.psi) / 2)
    beta = numbers.sin(theta / 2) * numbers.turn((top.phi - top.psi) / 2)
    if top.theta == math.pi:
        alpha = alpha * 0
    sine = numbers.sin(theta) if top.theta != math.pi else theta * 0
    kappa = numbers.complex(-top.phi_dot * sine, top.theta_dot) * numbers.turn(-top.psi)
    return State(alpha, beta, kappa.real, kappa.imag, top.omega3)


def follow_top(numbers: Numbers, top: Top, times: Sequence[Number]) -> list[State]:
    """The states of a heavy symmetric top at `times` (s), in that order.

    The frame that does not turn about e₃, in which the body has turned by ω₃t, has the unknowns
    a = α exp(−½iω₃t), b = β exp(½iω₃t), k = κ exp(iω₃t), however fast the top spins.  With the
    torque −MgR e₃×ẑ of the weight, Euler's equations λ₁ω̇₁ = (λ₁−λ₃)ω₂ω₃ + MgR z₂ and
    λ₁ω̇₂ = −(λ₁−λ₃)ω₁ω₃ − MgR z₁ become the third of

        ȧ = −½ i b k̄,    ḃ = −½ i a k,    k̇ = i (λ₃ω₃/λ₁) k + 2i (MgR/λ₁) ā b.

    Time is measured in 1/ν, so that all rates are of size 1 at most.
    """
    start = top_start(numbers, top)
    kappa = numbers.complex(start.omega1, start.omega2)
    nu = (
        abs(top.lambda3 * top.omega3 / top.lambda1)
        + numbers.sqrt(top.weight / top.lambda1)
        + abs(kappa)
    )
    if nu == 0:
        nu = nu + 1
    minus_half_i = numbers.complex(0, -1) / 2
    spin = numbers.complex(0, top.lambda3 * top.omega3 / (top.lambda1 * nu))
    pull = numbers.complex(0, 2 * top.weight / (top.lambda1 * nu**2))

    def series(state: tuple[Number, ...]) -> list[list[Number]]:
        a, b, k = ([value] for value in state)
        a_conjugate, k_conjugate = [a[0].conjugate()], [k[0].conjugate()]
        for n in range(1, ORDER + 1):
            a_next = minus_half_i * _convolution(b, k_conjugate) / n
            b_next = minus_half_i * _convolution(a, k) / n
            k_next = (spin * k[-1] + pull * _convolution(a_conjugate, b)) / n
            a.append(a_next)
            b.append(b_next)
            k.append(k_next)
            a_conjugate.append(a_next.conjugate())
            k_conjugate.append(k_next.conjugate())
        return [a, b, k]

    run = _both_sides(series, (start.alpha, start.beta, kappa / nu), [t * nu for t in times])
    states = []
    for t, (a, b, k) in zip(times, run, strict=True):
        turn = numbers.turn(top.omega3 * t / 2)
        kappa = k * nu * (turn * turn).conjugate()
        states.append(State(a * turn, b * turn.conjugate(), kappa.real, kappa.imag, top.omega3))
    return states


def body_start(numbers: Numbers, body: Body) -> State:
    q = (body.q0, body.q1, body.q2, body.q3)
    q0, q1, q2, q3 = (x / numbers.sqrt(sum(x * x for x in q)) for x in q)
    omega = (body.omega1, body.omega2, body.omega3)
    return State(numbers.complex(q0, q3), numbers.complex(q2, -q1), *omega)


def follow_body(numbers: Numbers, body: Body, times: Sequence[Number]) -> list[State]:
    """The states of a free body at `times` (s), in that order: Euler's equations and q̇.

    Time is measured in 1/ν, so that all rates are of size 1 at most.
    """
    start = body_start(numbers, body)
    first, second, third = body.lambda1, body.lambda2, body.lambda3
    nu = numbers.sqrt(sum(x * x for x in start.omega))
    if nu == 0:
        nu = nu + 1
    half_i = numbers.complex(0, 1) / 2
    factor1 = (second - third) / first
    factor2 = (third - first) / second
    factor3 = (first - second) / third

    def series(state: tuple[Number, ...]) -> list[list[Number]]:
        alpha, beta, omega1, omega2, omega3 = ([value] for value in state)
        kappa = [numbers.complex(omega1[0], omega2[0])]
        conjugate = [kappa[0].conjugate()]
        for n in range(1, ORDER + 1):
            along = _convolution(omega3, alpha), _convolution(omega3, beta)
            alpha_next = half_i * (along[0] - _convolution(beta, conjugate)) / n
            beta_next = -half_i * (along[1] + _convolution(alpha, kappa)) / n
            omega1_next = factor1 * _convolution(omega2, omega3) / n
            omega2_next = factor2 * _convolution(omega3, omega1) / n
            omega3_next = factor3 * _convolution(omega1, omega2) / n
            alpha.append(alpha_next)
            beta.append(beta_next)
            omega1.append(omega1_next)
            omega2.append(omega2_next)
            omega3.append(omega3_next)
            kappa.append(numbers.complex(omega1_next, omega2_next))
            conjugate.append(kappa[-1].conjugate())
        return [alpha, beta, omega1, omega2, omega3]

    scaled = (start.alpha, start.beta, *(x / nu for x in start.omega))
    run = _both_sides(series, scaled, [t * nu for t in times])
    return [State(alpha, beta, *(x * nu for x in omega)) for alpha, beta, *omega in run]


def differences(numbers: Numbers, one: State, other: State) -> tuple[float, float, float]:
    """How far apart two states are.

    The attitude (2 |sin(½ angle)|, rad), ω (norm, rad/s), and the axis: the horizontal part of the
    difference between the two e₃, which are 2αβ = sin θ exp(iφ).
    """
    a, b = one.alpha, one.beta
    across = a * other.beta - b * other.alpha
    along = (a.conjugate() * other.alpha + b.conjugate() * other.beta).imag
    vector = numbers.sqrt(across.real**2 + across.imag**2 + along**2)
    omega = sum((x - y) ** 2 for x, y in zip(one.omega, other.omega, strict=True))
    axis = 2 * (a * b - other.alpha * other.beta)
    return float(2 * vector), float(numbers.sqrt(omega)), float(abs(axis))
