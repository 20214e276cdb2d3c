"""The free body, solved: L in the body, and the attitude, by two theta functions.

The moments are renamed I₁, I₂, I₃ so that I₂ lies between the others and ω circles about e₃ (short
axis: I₃ is the largest, long axis: the smallest); signs are chosen so that L₁, L₃ ≥ 0 at t = 0.
With differences I_jk = |I_j − I_k| (Landau & Lifshitz, Mechanics §37; Whittaker §69),

    L₁ = a₁ cn τ,  L₂ = a₂ sn τ,  L₃ = a₃ dn τ,    τ = τ₀ ± νt,
    a₁² = I₁B/I₁₃,  a₂² = I₂B/I₂₃,  a₃² = I₃A/I₁₃,  ν² = I₂₃A/(I₁I₂I₃),
    m = I₁₂B/(I₂₃A),  m₁ = I₁₃D/(I₂₃A),
    A = |L² − 2TI₁|,  B = |L² − 2TI₃|,  D = |L² − 2TI₂|,

where A, B are sums of squares of ω and D, which vanishes on the separatrix, is a difference of two
that factors.  In the frame whose ẑ is L/L the spinors α = cos(θ/2) exp(½i(φ + ψ)) and
β = sin(θ/2) exp(½i(φ − ψ)) are theta functions, as those of a heavy top are, whose periods in τ are
2K and 4iK′: of the parameter m² / (1 + √m₁)⁴, by Landen's transformation.  Their zeros, where
L₃ = ±L, are as far from 2iK′ as from 0, so that one number makes both.  L in the body is −2ᾱβ, and
the mean of the phase of α follows from φ̇ and ψ̇ where L₂ is largest.

`FreeOrbit` is in units of σ = |ω| at t = 0 and of the largest moment; its numbers are floats for
one motion, else arrays that broadcast.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from rigidtop.motion.attitude import Floats, after
from rigidtop.motion.exact import compiled, theta
from rigidtop.motion.exact.numbers import ROUNDING, SMALLEST_PART, Arrays, Kit, Real, Truth, cubic
from rigidtop.motion.exact.samples import Smoothness
from rigidtop.motion.exact.theta import (
    LARGEST_RATIO,
    Factor,
    Modulus,
    Real4,
    factor,
    modulus,
    real4,
)
from rigidtop.trace import Solved, Written, leaves, written

Triple = tuple[Real, Real, Real]


@dataclass(frozen=True)
class FreeState:
    """Attitude and ω at some times, floats or arrays."""

    q0: Real
    q1: Real
    q2: Real
    q3: Real
    """A unit quaternion, from body components to body components at t = 0."""

    omega1: Real
    omega2: Real
    omega3: Real
    """In body components (rad/s)."""

    @property
    def quaternion(self) -> tuple[Real, ...]:
        return self.q0, self.q1, self.q2, self.q3

    @property
    def omega(self) -> tuple[Real, ...]:
        return self.omega1, self.omega2, self.omega3


@dataclass(frozen=True)
class FreeOrbit:
    """The motion from ω at t = 0, made by `solve`."""

    omega: Triple
    """ω at t = 0 in the body's own components, rad/s."""

    sigma: Real
    """The unit of rates (1/s)."""

    axes: Triple
    """Which of the body's axes are e₁, e₂, e₃ here."""

    signs: Triple
    """And in which direction."""

    moments: Triple
    """I₁, I₂, I₃."""

    amplitudes: Triple
    """a₁, a₂, a₃."""

    momentum: Triple
    """L at t = 0."""
    length: Real
    """|L|."""

    m: Real
    m1: Real
    nu: Real
    """dτ/dt, negative about the long axis."""
    uniform: Truth
    """Whether ω is constant."""
    on_separatrix: Truth
    """To rounding of the initial state."""

    modulus: Modulus
    z0: Real
    rate: Real
    """dz/dt (1/s)."""
    along: Factor
    """α."""
    drift: Real
    """What is linear in time of the phase of α (1/s)."""
    functions: Real4
    weight: Real
    sine: Real
    cosine: Real
    """Of Landen's transformation, sn ∝ θ₁θ₄ and cn ∝ θ₂θ₃ over θ₄² + `weight` θ₁²."""
    back: tuple[Real, ...] = ()
    """The quaternion from the frame of L to e₁, e₂, e₃ at t = 0."""

    # --- Periods ---

    @property
    def turning_points(self) -> tuple[Real, Real]:
        """The smallest and the largest angle between L and e₃ (rad)."""
        a1, a2, a3 = self.amplitudes
        now = np.arctan2(np.hypot(*self.momentum[:2]), self.momentum[2])
        return (
            np.where(self.uniform, now, np.arctan2(a1, a3)),
            np.where(self.uniform, now, np.arctan2(a2, a3 * np.sqrt(self.m1))),
        )

    @property
    def nutation_period(self) -> Real:
        """The time from one smallest value of that angle to the next (s); ω returns after two."""
        with np.errstate(all="ignore"):
            return np.where(self._ends, np.inf, 2 * self.modulus.half / np.abs(self.rate))

    @property
    def _ends(self) -> NDArray[np.bool_]:
        """Whether it never comes back from the middle axis, as the regime has it."""
        ends = np.asarray(self.on_separatrix) & (self.m > 0)
        return np.asarray(ends & ~np.asarray(self.uniform))

    @property
    def mean_precession(self) -> Real:
        """The rate at which e₃ turns about L, on average (rad/s)."""
        with np.errstate(all="ignore"):
            # φ + ψ without ψ, which turns by half a circle backwards in a period of τ.
            turned = (np.pi - 2 * self.along.turn) * np.sign(self.nu) / self.nutation_period
            along_middle = self.length * self.sigma / np.asarray(self.moments[1])
            turns = (self.m1 > 0) & (self.nu != 0) & ~self._ends
            return np.where(turns, 2 * self.drift + turned, along_middle)

    @property
    def regime(self) -> NDArray[np.str_]:
        """How ω moves in the body, to rounding of the initial state.

        "steady" (not at all), "regular precession" (two equal moments), "separatrix", and about
        the "short axis" or the "long axis".
        """
        return np.select(
            [
                np.asarray(self.uniform),
                np.asarray(self.m == 0),
                np.asarray(self.on_separatrix),
                np.asarray(self.nu > 0),
            ],
            ["steady", "regular precession", "separatrix", "short axis"],
            "long axis",
        )

    # --- The state ---

    @property
    def smoothness(self) -> Smoothness:
        """How smooth the motion is: see `samples`."""
        strip, rate = theta.strip(self.modulus), abs(self.rate)
        return Smoothness(rate, strip, abs(self.drift) + rate + self.sigma, strip)

    def at(self, t: Real) -> FreeState:
        """The state at times t (s), which broadcast against the orbit."""
        with np.errstate(all="ignore"):
            return self._at(Arrays, t)

    def _at(self, k: Kit, t: Real) -> FreeState:
        def turning() -> tuple[Real, ...]:
            now, momentum = self._state(k, self.z0 + self.rate * t, t)
            w, *turned = after(self.back, now)
            rates = [
                sign * part * (self.sigma / moment)
                for sign, part, moment in zip(self.signs, momentum, self.moments, strict=True)
            ]
            own = [sign * part for sign, part in zip(self.signs, turned, strict=True)]
            return (w, *_renamed(k, self.axes, own), *_renamed(k, self.axes, rates))

        def constant() -> tuple[Real, ...]:
            half = k.hypot(k.hypot(*self.omega[:2]), self.omega[2]) * t / 2
            c, s = k.cos(half), k.sin(half) / self.sigma
            return (c, *(s * rate for rate in self.omega), *(rate + 0 * t for rate in self.omega))

        return FreeState(*k.pick(self.uniform, constant, turning))

    def _state(self, k: Kit, z: Real, t: Real) -> tuple[tuple[Real, ...], Triple]:
        """The quaternion from e₁, e₂, e₃ to the frame of L, but for a constant turn; and L."""
        at = theta.place(k, self.modulus, z)
        one, two, three, four = self.functions.at(k, self.modulus, at)
        per = k.over(1.0, four * four + self.weight * one * one)
        sign = k.where(at.turns == 2 * k.rint(at.turns / 2), 1.0, -1.0)
        sn = self.sine * sign * one * per * four
        cn = self.cosine * sign * two * per * three
        a1, a2, a3 = self.amplitudes
        momentum = a1 * cn, a2 * sn, a3 * k.sqrt(self.m1 + self.m * cn * cn)
        per = k.over(1.0, self.length)
        n1, n2, n3 = (part * per for part in momentum)
        size = k.sqrt((1 + n3) / 2)
        f, g = k.cubics((self.along.odd, self.along.even), at.x)
        phase = k.atan2(at.t * k.where(self.along.weighted, 1.0, at.plus) * f, g)
        phase = self.drift * t - phase - at.turns * self.along.turn
        c, s = k.circle(phase)
        per = -0.5 / size
        b1, b2 = n1 * per, n2 * per
        return (size * c, -(b1 * s + b2 * c), b1 * c - b2 * s, size * s), momentum


def _inverse(q0: Real, q1: Real, q2: Real, q3: Real) -> tuple[Real, ...]:
    return q0, -q1, -q2, -q3


def _renamed(k: Kit, axes: Triple, values: list[Real]) -> tuple[Real, ...]:
    """Components by the body's own axes, from those by the sorted `axes`."""
    return tuple(
        k.where(axes[0] == own, values[0], k.where(axes[1] == own, values[1], values[2]))
        for own in (0, 1, 2)
    )


def solve(moments: Triple, omega: Triple) -> FreeOrbit:
    """The orbits from three moments and ω in body components, arrays that broadcast."""
    with np.errstate(all="ignore"):
        return _solve(Arrays, moments, omega)


@cache
def _written() -> Written:
    return written(
        6,
        lambda k, s: _solve(k, (s[0], s[1], s[2]), (s[3], s[4], s[5])),
        lambda k, orbit, t: orbit._at(k, t),
    )


def rows(solved: Solved, start: Sequence[float], times: Floats) -> Floats:
    """Quaternion and ω at many times, from that at t = 0, compiled."""
    return compiled.rows(solved, _turned, times, *start)


def _turned(k: Kit, orbit: FreeOrbit, t: Real) -> tuple[Real, ...]:
    first = len(leaves(orbit))  # behind the numbers of the orbit
    start = tuple(k.value(f"o[{first + part}]") for part in range(4))
    state = orbit._at(k, t)
    return *after(start, state.quaternion), *state.omega


def solved(moments: Triple, omega: Triple) -> Solved:
    """One motion, from floats; its state is a `FreeState`."""
    return _written().solved(*moments, *omega)


def _ordered(k: Kit, moments: Triple) -> tuple[Real, Real, Real]:
    """Which is the smallest, the middle one and the largest; of equal ones the first."""
    a, b, c = moments
    smallest = k.where(k.both(a <= b, a <= c), 0, k.where(b <= c, 1, 2))
    largest = k.where(k.both(c >= a, c >= b), 2, k.where(b >= a, 1, 0))
    return smallest, 3 - smallest - largest, largest


def _picked(k: Kit, values: Triple, index: Real) -> Real:
    return k.where(index == 0, values[0], k.where(index == 1, values[1], values[2]))


def _solve(k: Kit, moments: Triple, omega: Triple) -> FreeOrbit:
    largest = k.larger(abs(omega[0]), k.larger(abs(omega[1]), abs(omega[2])))
    unit = k.where(largest > 0, largest, 1.0)  # no square of it overflows
    parts = [rate / unit for rate in omega]
    sigma = largest * k.sqrt(sum(part * part for part in parts))
    sigma = k.where(sigma > 0, sigma, 1.0)
    order = _ordered(k, moments)
    small, medium, big = (_picked(k, moments, index) for index in order)
    i = small / big, medium / big, big / big
    i12, i23, i13 = (medium - small) / big, (big - medium) / big, (big - small) / big
    w = [abs(_picked(k, omega, index)) / sigma for index in order]
    # Beside the middle axis: no product of parts that small tells how they go on.
    least = math.sqrt(SMALLEST_PART)
    beside = k.both(w[0] < least, w[2] < least)
    w = [k.where(beside, 0.0, w[0]), w[1], k.where(beside, 0.0, w[2])]
    short, long = k.sqrt(i[2] * i23) * w[2], k.sqrt(i[0] * i12) * w[0]
    d = abs(short - long) * (short + long)
    about_short = short >= long

    def named(values: list[Real] | tuple[Real, ...]) -> tuple[Real, Real, Real]:
        first, second, third = values
        return k.where(about_short, first, third), second, k.where(about_short, third, first)

    axes, (i1, i2, i3), (w1, w2, w3) = named(order), named(i), named(w)
    i12, _, i23 = named((i12, i13, i23))
    a = i2 * i12 * w2 * w2 + i3 * i13 * w3 * w3
    b = i1 * i13 * w1 * w1 + i2 * i23 * w2 * w2
    nu = k.sqrt(i23 * a / (i1 * i2 * i3))
    # Where ω cannot circle (I₂ = I₃ about that axis, or three equal moments) any numbers do.
    idle = nu == 0
    i12, i23, i13 = (k.where(idle, *pair) for pair in ((0.0, i12), (1.0, i23), (1.0, i13)))
    a, b, d = (k.where(idle, *pair) for pair in ((1.0, a), (0.0, b), (1.0, d)))
    a1, a2, a3 = k.sqrt(i1 * b / i13), k.sqrt(i2 * b / i23), k.sqrt(i3 * a / i13)
    m, m1 = i12 * b / (i23 * a), i13 * d / (i23 * a)
    m1 = k.where(m1 < SMALLEST_PART, 0.0, m1)
    k1 = k.sqrt(m1)
    still = b == 0
    cn = k.where(still, 1.0, k.over(i1 * w1, a1))
    sn = k.where(still, 0.0, k.over(i2 * w2, a2))
    dn = k.sqrt(m1 + m * cn * cn)
    # Of Landen's parameter.
    lower = m / ((1 + k1) * (1 + k1))
    low = 2 * k.sqrt(k1) / (1 + k1)
    mod = modulus(k, lower * lower, low * low)
    ratio = k.over(sn, cn) * k.sqrt((1 + k1) * (dn + k1) / (2 * (1 + dn)))
    late = ratio * ratio * low > 1
    ratio = k.where(late, k.over(1.0, low * ratio), ratio)
    # Constant ω: also about a principal axis, be it the middle one, which L never leaves.
    middle = k.both(m1 == 0, k.over(sn, cn) == math.inf)
    uniform = k.either(k.either(idle, middle), k.both(w1 == 0, w2 == 0))
    ratio, late = k.where(uniform, 0.0, ratio), k.where(uniform, False, late)
    z0 = theta.angle(k, mod, ratio)
    z0 = k.where(late, mod.half - z0, z0)
    # e₁ and e₃ point to where L₁, L₃ ≥ 0; e₂ so that the axes are right-handed.
    sign1, sign2, sign3 = (k.where(_picked(k, omega, axis) < 0, -1.0, 1.0) for axis in axes)
    even = (axes[1] - axes[0]) % 3 == 1
    second = sign1 * sign3 * k.where(even, 1.0, -1.0)
    z0 = k.where(second * sign2 < 0, -z0, z0)
    momentum = i1 * w1, i2 * w2, i3 * w3
    length = k.sqrt(sum(part * part for part in momentum))
    length = k.where(uniform, length, k.hypot(a1, a3))
    near = k.smaller(k.over(a1, (length + a3) * k.sqrt(lower)), LARGEST_RATIO)
    near = k.where(b > 0, near, 1.0)
    far = k.over(1.0, lower * near)
    along = factor(k, mod, far, near, True, False)
    rate = k.where(about_short, 1.0, -1.0) * mod.rate * nu * (1 + k1) / 2
    functions = real4(k, mod)
    _, two, three, four = functions.at(k, mod, theta.place(k, mod, rate * 0))
    per_sine = four / (mod.rate * cubic(mod.sines, mod.q))
    # At the other turning point L₃ = a₃k′.
    end3 = a3 * k1
    away = k.over(a2 * a2, length + end3)
    slow = (away / i2 + end3 / i3) / 2
    orbit = FreeOrbit(
        omega=omega,
        sigma=sigma,
        axes=axes,
        signs=(sign1, second, sign3),
        moments=(i1, i2, i3),
        amplitudes=(a1, a2, a3),
        momentum=momentum,
        length=length,
        m=m,
        m1=m1,
        nu=k.where(about_short, nu, -nu),
        uniform=uniform,
        on_separatrix=abs(short - long) <= ROUNDING * (short + long),
        modulus=mod,
        z0=z0,
        rate=rate * sigma,
        along=along,
        drift=sigma * (slow + rate * along.slope),
        functions=functions,
        weight=lower * per_sine * per_sine,
        sine=(1 + lower) * per_sine,
        cosine=four * four / (two * three),
    )
    back = k.pick(
        uniform,
        lambda: (1.0, 0.0, 0.0, 0.0),
        lambda: _inverse(*orbit._state(k, z0, 0.0)[0]),
    )
    return replace(orbit, back=back)
