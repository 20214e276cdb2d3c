"""The heavy symmetric top, solved.

With u = cos θ, φ̇ sin²θ + bu = a and ½(θ̇² + φ̇² sin²θ) + μu = ε are constant, where

    b = λ₃ω₃/λ₁,  μ = MgR/λ₁,  a = p_φ/λ₁,

so u̇² is a cubic in u (Goldstein 5.7; Whittaker, Analytical Dynamics §71).  In x = 1 − u and
y = 1 + u, which are known to all their digits near the upright and the hanging top, it is

    ẋ² = 2μ (x − x₁)(x₂ − x)(x − x₃),    x₃ ≤ 0 ≤ x₁ ≤ x ≤ x₂ ≤ 2,
    x = x₁ sn²τ + x₂ cn²τ,    ν² = ½μ(x₂ − x₃),    m = (x₂ − x₁)/(x₂ − x₃).

The spinors cos(θ/2) exp(½i(φ + ψ)) and sin(θ/2) exp(½i(φ − ψ)) are each one theta function over a
common one, times an exponential of time (Klein & Sommerfeld): `theta` has their squares, which are
y and x, and their phases.  What is linear in time follows from φ̇ at x₁ and x₂.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from functools import cache

import numpy as np

from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact import compiled, theta
from rigidtop.motion.exact.heavy_orbit import Half, HeavyOrbit, HeavyStart, spinor
from rigidtop.motion.exact.numbers import ROUNDING, SMALLEST_PART, Arrays, Kit, Real, Truth, cubic
from rigidtop.motion.exact.roots import NEAR_POLE, Roots, Scaled, roots, unless_rounding
from rigidtop.motion.exact.theta import Modulus, along, factor, modulus
from rigidtop.motion.state import CHANGING, TopState, rates
from rigidtop.trace import Solved, Written, written

SMALLEST_TILT = 1e-150
"""Squares of less would lose digits; an attitude does not notice."""


def solve(start: HeavyStart) -> HeavyOrbit:
    """The orbits from starts, which are arrays that broadcast."""
    with np.errstate(all="ignore"):
        return _solve(Arrays, start)


@cache
def _written() -> Written:
    return written(
        len(fields(HeavyStart)),
        lambda k, s: _solve(k, HeavyStart(*s)),
        lambda k, orbit, t: orbit.evaluated(k, t),
    )


def rows(solved: Solved, times: Floats) -> dict[str, Floats]:
    """What changes of the states at many times, and θ, φ̇ and ψ̇, compiled."""
    names = (*CHANGING, "theta", "phi_dot", "psi_dot")
    return dict(zip(names, compiled.rows(solved, _whole, times), strict=True))


def states(solved: Solved, times: Floats, compiled: bool) -> TopState:
    """The states at any number of times (N,), by NumPy or compiled."""
    orbit: HeavyOrbit = solved.orbit
    if not compiled:
        return orbit.states(times)
    values = rows(solved, times)
    return orbit.state({name: values[name] for name in CHANGING})


def _whole(k: Kit, orbit: HeavyOrbit, t: Real) -> tuple[Real, ...]:
    state = orbit.evaluated(k, t)
    theta = 2 * k.atan2(state.sin_half, state.cos_half)
    return *(getattr(state, name) for name in CHANGING), theta, *rates(k, state)


def solved(start: HeavyStart) -> Solved:
    """One motion, whose start is floats; its state is a `TopState`."""
    return _written().solved(*vars(start).values())


def _solve(k: Kit, start: HeavyStart) -> HeavyOrbit:
    scaled = _scaled(k, start)
    r, s, steady = roots(k, scaled)
    r, nome = _nome(k, s, r)
    a1 = k.where(r.x1 < NEAR_POLE * s.x0, s.c_up + s.b * r.x1, s.momentum + s.b * r.delta1)
    a2 = k.where(r.y2 < NEAR_POLE * s.y0, s.c_down - s.b * r.y2, s.momentum + s.b * r.delta2)
    first, second = _halves(k, s, r, nome, a1, a2)
    fixed = k.either(nome.still, steady)
    arrives, passes = _specials(k, scaled)
    mod, swapped = nome.modulus, nome.swapped
    origin = k.where(swapped, mod.theta3, k.where(mod.circular, mod.theta4, mod.theta2))
    per_sine = origin / (mod.rate * cubic(mod.sines, mod.q))
    depth, fall, falls = _fall(k, s, r, nome, origin)
    at = theta.place(k, mod, nome.z0)
    return HeavyOrbit(
        start=start,
        sigma=s.sigma,
        mu=s.mu,
        b=s.b,
        c_up=s.c_up,
        c_down=s.c_down,
        roots=r,
        a1=a1,
        a2=a2,
        nu=nome.nu,
        m1=nome.m1,
        modulus=mod,
        swapped=swapped,
        z0=nome.z0,
        rate=mod.rate * nome.nu * s.sigma,
        first=first,
        second=second,
        moving=r.span > 0,
        wide=k.either(r.x1 < NEAR_POLE * r.x2, r.y2 < NEAR_POLE * r.y1),
        sines=along(k, mod, tuple(per_sine * c for c in mod.sines)),
        fall=k.where(swapped, fall, -fall),
        falls=falls,
        momentum=s.sigma * k.where(swapped, a1, a2),
        momentum_rise=s.sigma * s.b * k.where(swapped, depth, -depth),
        begin=(
            spinor(k, first, at, k.cubics(first.cubics, at.x))[1],
            spinor(k, second, at, k.cubics(second.cubics, at.x))[1],
        ),
        still=nome.still,
        steady=steady,
        asymptotic=k.where(fixed, False, arrives),
        through=k.where(fixed, False, passes),
    )


def _scaled(k: Kit, start: HeavyStart) -> Scaled:
    """The start in units of σ, which no rate exceeds."""
    speed = k.hypot(start.v_theta, start.v_phi)
    sigma = k.sqrt(start.mu) + abs(start.b) + speed
    sigma = k.where(sigma > 0, sigma, 1.0)
    b, v_phi = start.b / sigma, start.v_phi / sigma
    sin_half, cos_half = (
        k.where(half > 0, k.larger(half, SMALLEST_TILT), 0.0)
        for half in (start.sin_half, start.cos_half)
    )
    x0, y0 = 2 * sin_half * sin_half, 2 * cos_half * cos_half
    sine = 2 * sin_half * cos_half
    momentum = sine * v_phi
    away_up = unless_rounding(k, v_phi, -k.over(b * sine, y0))
    away_down = unless_rounding(k, v_phi, k.over(b * sine, x0))
    return Scaled(
        sigma=sigma,
        mu=start.mu / sigma / sigma,
        b=b,
        v_theta=start.v_theta / sigma,
        v_phi=v_phi,
        speed=speed / sigma,
        x0=x0,
        y0=y0,
        sine=sine,
        momentum=momentum,
        away_up=away_up,
        c_up=k.where(x0 < 1, sine * away_up, momentum - b * x0),
        c_down=k.where(x0 < 1, momentum + b * y0, sine * away_down),
    )


def _specials(k: Kit, s: Scaled) -> tuple[Truth, Truth]:
    """Whether rounding of the start cannot tell it from one that arrives at the upright, never to
    leave, and from one that passes through the vertical."""
    up = abs(s.c_up) <= ROUNDING * (abs(s.momentum) + abs(s.b) * s.x0)
    down = abs(s.c_down) <= ROUNDING * (abs(s.momentum) + abs(s.b) * s.y0)
    square, fallen = s.speed * s.speed, 2 * s.mu * s.x0
    left = square - fallen  # speed² of the axis, were it upright
    at_rest = k.both(up, abs(left) <= ROUNDING * (square + fallen))
    # With p_φ = p_ψ alone it may lack the energy to climb there.
    return k.both(at_rest, s.b * s.b < 4 * s.mu), k.either(k.both(up, left > 0), down)


@dataclass(frozen=True)
class Nome:
    """The elliptic functions of a motion, and where it is in their period."""

    modulus: Modulus
    m1: Real
    m23: Real
    """2μ(x₂ − x₃)."""
    nu: Real
    swapped: Truth
    """Whether z counts from x₁, not from x₂."""
    z0: Real
    """z at t = 0."""
    still: Truth
    """Whether the axis is vertical and at rest."""


def _nome(k: Kit, s: Scaled, r: Roots) -> tuple[Roots, Nome]:
    """The roots, which meet where an axis is still, and the nome."""
    mu, x0, y0 = s.mu, s.x0, s.y0
    m13 = r.m03 + 2 * mu * r.x1  # a sum, also next to the separatrix
    m23 = m13 + 2 * mu * r.span
    m, m1 = k.over(2 * mu * r.span, m23), k.over(m13, m23)
    m, m1 = k.where(m23 > 0, m, 0.0), k.where(m23 > 0, m1, 1.0)
    m1 = k.where(m1 < SMALLEST_PART, 0.0, m1)
    k1 = k.sqrt(m1)
    below = 0.0 - r.delta1  # not a zero with a sign
    swapped = r.delta2 * k1 > below
    ratio = k.where(
        swapped,
        k.over(_root(k, k.over(below, r.delta2), 0.0), k1),
        _root(k, k.over(r.delta2, below), 0.0),
    )
    # A vertical axis at rest stays, also where it is not stable; so does one whose motion is too
    # small for the square of its square, 1e-75 rad.
    vertical = k.either(x0 == 0, y0 == 0)
    still = k.either(k.both(r.span == 0, vertical), ratio == math.inf)
    ratio = k.where(k.either(still, r.span == 0), 0.0, ratio)
    if k.any(still):
        stays = Roots(0.0, 0.0, x0, x0, y0, y0, 0.0, r.m03)
        r = Roots(*(k.where(still, *pair) for pair in zip(_parts(stays), _parts(r), strict=True)))
        m, m1 = k.where(still, 0.0, m), k.where(still, 1.0, m1)
    # The frequency of small nutations about the vertical: b² − 4μ cos θ.
    about = k.larger(s.b * s.b - 4 * mu * k.copysign(1.0, y0 - x0), 0.0)
    mod = modulus(k, m, m1)
    z0 = theta.angle(k, mod, ratio)
    return r, Nome(
        modulus=mod,
        m1=m1,
        m23=m23,
        nu=k.sqrt(k.where(still, about, m23)) / 2,
        swapped=swapped,
        z0=k.where((s.v_theta < 0) == swapped, -z0, z0),
        still=still,
    )


def _halves(k: Kit, s: Scaled, r: Roots, nome: Nome, a1: Real, a2: Real) -> tuple[Half, Half]:
    """The spinors: that whose zeros lie above the origin of z, and the other."""
    mod, swapped, m23 = nome.modulus, nome.swapped, nome.m23
    rate = mod.rate * nome.nu
    # Of zeros of y and of x: sn²/cn² of the complementary parameter at b, and at K′ − b.
    downs = k.over(r.y2, r.span), k.over(m23, 2 * s.mu * r.y2)
    ups = k.over(r.x1 * m23, r.span * r.m03), k.over(r.m03, 2 * s.mu * r.x1)
    # Of φ ± (ψ − ω₃t), at the turning point where the phase is slow; at rest, of its neighbours.
    slow_down = k.where(r.y1 > 0, k.over(a1, r.y1), -s.b)
    slow_up = k.where(r.x2 > 0, k.over(a2, r.x2), s.b)
    of_y = (*downs, s.c_down, r.y1, slow_down, r.y2 == 0)
    of_x = (*ups, s.c_up, r.x2, slow_up, r.x1 == 0)

    def half(at_origin: bool) -> Half:
        one, other = (of_x, of_y) if at_origin else (of_y, of_x)
        near, far, c, value, slow, passes = (
            k.where(swapped, *pair) for pair in zip(one, other, strict=True)
        )
        ratios = _root(k, near, 0.0), _root(k, far, math.inf)
        part = factor(k, mod, *ratios, at_origin, swapped)
        sense = k.where(nome.still, 0.0, k.where(c < 0, -1.0, 1.0))
        return Half(
            factor=part,
            scale=k.over(value, part.square) * k.where(part.weighted, 0.5, 1.0),
            sense=sense,
            through=k.where(nome.still, False, passes),
            drift=s.sigma * (slow / 2 - sense * rate * part.slope),
            at_origin=at_origin,
        )

    return half(True), half(False)


def _fall(
    k: Kit, s: Scaled, r: Roots, nome: Nome, origin: Real
) -> tuple[Real, Real, tuple[Real, Real, Real]]:
    """How far x falls from the origin of z, the size of θ̇ (rad/s), and its series."""
    mod = nome.modulus
    # 1 − m of this nome: of m₁ itself the logarithm, which time is measured by, is not as exact.
    two, three = mod.theta2 * mod.theta2, mod.theta3 * mod.theta3
    rest = k.where(mod.circular, nome.m1, 16 * mod.q * (two * two) / (three * three))
    depth = k.where(nome.swapped, r.span * rest, r.span)
    falls, first_fall = _falls(mod)
    origin2 = origin * origin
    fall = 2 * nome.nu * depth * s.sigma * (origin2 * origin2) / (first_fall * mod.rate)
    return depth, fall, falls


def _parts(roots: Roots) -> tuple[Real, ...]:
    return tuple(vars(roots).values())


def _root(k: Kit, square: Real, unknown: float) -> Real:
    """The square root; of 0/0 what makes no difference."""
    return k.sqrt(k.where(square == square, square, unknown))


def _falls(mod: Modulus) -> tuple[tuple[Real, Real, Real], Real]:
    """θ₁(2z) over sin 2z and the distance from its next zero, by powers of (qC)²; and it at 0."""
    q2 = mod.q * mod.q
    q4 = q2 * q2
    square = mod.end * mod.end
    c1 = -4 - 12 * q4 - 24 * q4 * q4 * q2
    c2 = 16 * q2 + 80 * q4 * q4
    c3 = -64 * q4 * q2
    at2 = -c3
    at1 = at2 * square - c2
    at0 = at1 * square - c1
    return (at0, at1, at2), (square - q2) * ((at2 * q2 + at1) * q2 + at0)
