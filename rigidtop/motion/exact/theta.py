"""Theta functions of one motion: everything that is periodic in it, from four terms of a series.

A motion with Jacobi's parameter m is a quotient of theta functions of z + ib, where z grows with
time and b is a constant, the distance of a zero from the real axis.  For m ≤ ½ their nome
q = exp(−πK′/K) is at most e^(−π), and four terms are enough; for m > ½ Jacobi's imaginary
transformation exchanges K and K′, so that q = exp(−πK/K′) is as small, z is imaginary and b real.
So every motion costs the same, next to a separatrix too.  With

    t = tan z, C = cos 2z   (m ≤ ½)   or   t = tanh ζ, C = cosh 2ζ   (m > ½)

a theta function is (G + i t F) times 1 or √((1 + C)/2), where F and G are cubics of qC.  Its
phase is arctan(tF/G), which has no jumps but at a zero on the real axis.  For m > ½ they are
cubics of (1 + q²)/2 − qC, which vanishes at the end of half a period, to keep their digits there.

z counts from that turning point, the `origin`, that is nearest to the start; so a motion that
starts next to a zero is known to all its digits there.  A function is `at_origin` if its zeros lie
above the origin (θ₁ near to it, θ₄ far from it), else they lie above the other turning point (θ₂,
θ₃).  See DLMF 20.2, 20.7(viii).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from rigidtop.motion.exact.numbers import Kit, Real, Truth, cubic

MEANS = 12
"""At most so many arithmetic-geometric means: 10 are enough for 1 and 1e-150."""

LANDEN = 5
"""At most so many of Landen's transformations, which take a parameter of ½ to 1e-86."""

LARGEST_EXPONENT = 100.0
"""Of a hyperbolic function in such a transformation: beyond, the parameter has underflowed."""

NO_MORE = 1e-35
"""A difference of means that does nothing, not even to the cosh of an angle."""

Cubic = tuple[Real, Real, Real, Real]
"""Coefficients, the constant first."""


@dataclass(frozen=True)
class Modulus:
    """The constants of the theta functions that depend on m alone."""

    circular: Truth
    """m ≤ ½."""
    chain: tuple[tuple[Real, Real, Real], ...]
    """a, b and a − b of arithmetic-geometric means, for the smaller of m and 1 − m."""
    rate: Real
    """dz/dτ: π/(2K), or π/(2K′)."""
    q: Real
    half: Real
    """z at the other turning point: π/2, or πK/(2K′)."""
    end: Real
    """qC there, for m > ½."""
    sines: Cubic
    """θ₁(z) over sin z, or over sinh ζ."""
    theta2: Real
    """θ₂(0) without its factor 2 q^(1/4)."""
    theta3: Real
    theta4: Real


def modulus(k: Kit, m: Real, m1: Real) -> Modulus:
    """The constants of m and 1 − m, both known to all their digits."""
    circular = m <= m1
    small, large = k.where(circular, m, m1), k.where(circular, m1, m)
    a, b = small * 0 + 1.0, k.sqrt(large)
    d = small / (1 + b)
    chain = []
    for _ in range(LANDEN):
        chain.append((a, b, d))
        a, b = (a + b) / 2, k.sqrt(a * b)
        d = d * d / (4 * (a + b))
        if not k.any(d > NO_MORE):
            break
    rate = (a + b) / 2
    other, low = 1.0, k.sqrt(small)
    for _ in range(MEANS):
        other, low = (other + low) / 2, k.sqrt(other * low)
        if not k.any(other - low > 1e-8 * other):
            break
    other = k.where(small > 0, (other + low) / 2, 0.0)
    ratio = math.pi * k.over(rate, other)
    q = k.exp(-ratio)
    q2 = q * q
    q4 = q2 * q2
    q6 = q4 * q2
    even, odd = 1 + 2 * q4, 2 * q * (1 + q4 * q4)
    return Modulus(
        circular=circular,
        chain=tuple(chain),
        rate=rate,
        q=q,
        half=k.where(circular, math.pi / 2, ratio / 2),
        end=(1 + q2) / 2,
        sines=_odd_multiples(q, -1.0, 1.0, 0.0, 1.0)[:4],
        theta2=1 + q2 + q6 + q6 * q6,
        theta3=even + odd,
        theta4=even - odd,
    )


def angle(k: Kit, modulus: Modulus, r: Real) -> Real:
    """z ≥ 0 from r, which is sn/cn, or for m > ½ sn of an imaginary argument over i."""
    ways = (lambda: (circular_angle(k, modulus, r),), lambda: (hyperbolic_angle(k, modulus, r),))
    return k.pick(modulus.circular, *ways)[0]


def circular_angle(k: Kit, modulus: Modulus, r: Real) -> Real:
    """z ≥ 0 from r = sn/cn, by Landen's descending transformation."""
    angle = k.atan(r)
    for a, b, d in modulus.chain:
        angle = 2 * angle - k.atan(d * r / (a + b * r * r))
        r = k.tan(angle)
    return angle / 2 ** len(modulus.chain)


def hyperbolic_angle(k: Kit, modulus: Modulus, r: Real) -> Real:
    """The same of an imaginary argument: b ≥ 0 from sn(ib) = ir."""
    angle = k.asinh(r)
    for a, _, d in modulus.chain:
        angle = 2 * angle - k.atanh(d * r * k.sqrt(1 + r * r) / (a + d * r * r))
        r = k.sinh(k.smaller(angle, LARGEST_EXPONENT))
    return angle / 2 ** len(modulus.chain)


def along(k: Kit, mod: Modulus, c: Cubic) -> Cubic:
    """A cubic of qC as one of `PeriodPlace.x`."""

    def from_end() -> Cubic:
        first = c[1] + (2 * c[2] + 3 * c[3] * mod.end) * mod.end
        return cubic(c, mod.end), -first, c[2] + 3 * c[3] * mod.end, -c[3]

    result: Cubic = k.pick(mod.circular, lambda: c, from_end)
    return result


@dataclass(frozen=True)
class PeriodPlace:
    """The place of a motion in its period."""

    turns: Real
    """Whole periods since the origin."""
    z: Real
    """What is left, at most `half`."""
    t: Real
    plus: Real
    """1 + C."""
    x: Real
    """qC, or its distance from that at the end of half a period if m > ½."""
    left: Real
    """That distance."""


FARTHEST = 340.0
"""ζ of a motion without period, from which its distance from its pole counts as none."""


def place(k: Kit, mod: Modulus, z: Real) -> PeriodPlace:
    """The place in its period of a motion at z."""

    def circular() -> tuple[Real, ...]:
        turns = k.rint(z * (1 / math.pi)) + 0.0
        rest = z - turns * math.pi  # a zero keeps its sign
        t = k.tan(rest)
        plus = 2 / (1 + t * t)
        x = mod.q * (plus - 1)
        return turns, rest, t, plus, x, mod.end - x

    def hyperbolic() -> tuple[Real, ...]:
        bounded = k.finite(mod.half)
        period = k.where(bounded, 2 * mod.half, 1.0)
        turns = k.where(bounded, k.rint(z / period), 0.0) + 0.0
        rest = z - turns * period
        size = abs(rest)
        shrunk = k.exp(-2 * k.smaller(size, FARTHEST))
        end = k.tanh(mod.half - size)
        left = end / (1 + end) * (1 - mod.q * shrunk)
        plus = (1 + shrunk) * (1 + shrunk) / (2 * shrunk)
        return turns, rest, k.tanh(rest), plus, left, left

    return PeriodPlace(*k.pick(mod.circular, circular, hyperbolic))


def strip(mod: Modulus) -> float:
    """How far from the real axis of z the denominator of one motion has its zeros."""
    return -math.log(mod.q) / 2 if mod.circular and mod.q > 0 else math.pi / 2


@dataclass(frozen=True)
class Factor:
    """A theta function of z + ib along a motion."""

    odd: Cubic
    """F, or F/(1 + C) if it is not `weighted`."""
    even: Cubic
    """G."""
    winding: Cubic
    """Of its phase: the same, or F − G."""
    wound: Truth
    """Whether its phase is counted from z, with which it turns, so that what is left is small."""
    weighted: Truth
    """Whether its square has the factor (1 + C)/2."""
    turn: Real
    """By how much its phase grows in a period."""
    distance: Real
    """Of its zeros from the real axis of z; inf if it is more than half of `strip`."""
    slope: Real
    """How its phase grows with z at that turning point from which its zeros are far."""
    square: Real
    """The square of its magnitude there, of that of the common denominator there."""


LARGEST_RATIO = 1e45
"""Of sn/cn at a zero: one so far away does nothing."""


def factor(
    k: Kit,
    mod: Modulus,
    near: Real,
    far: Real,
    at_origin: bool,
    swapped: Truth,
) -> Factor:
    """The factor from sn/cn of the complementary parameter at b, and at K′ − b.

    `swapped` says whether the origin is the turning point at τ = K, not that at τ = 0: there the
    common denominator of the motion is θ₃, not θ₄.
    """
    is_near = near < far
    r = k.smaller(k.smaller(near, far), LARGEST_RATIO)

    def hyperbolic() -> tuple[Real, Real, Real]:
        angle = hyperbolic_angle(k, mod, r)
        return k.cosh(angle), k.sinh(angle), angle

    def circular() -> tuple[Real, Real, Real]:
        angle = circular_angle(k, mod, r)
        one, other = k.cos(angle), k.sin(angle)
        angle = k.where(is_near, angle, math.pi / 2 - angle)
        return k.where(is_near, one, other), k.where(is_near, other, one), angle

    c, s, angle = k.pick(mod.circular, hyperbolic, circular)
    distance = k.where(is_near, angle, k.where(mod.circular, math.inf, angle))
    c2 = 1 + k.where(mod.circular, 2, -2) * s * s
    q = mod.q
    if at_origin:
        halves = k.either(k.where(mod.circular, False, True), is_near)
        sign: Real = -1.0
    else:
        halves = k.both(mod.circular, is_near)
        sign = k.where(mod.circular, 1.0, -1.0)
    wound = k.both(k.both(mod.circular, is_near), near > 0)
    own = -1.0 if at_origin else 1.0
    odd_even = k.pick(
        halves,
        lambda: _odd_multiples(q, own, *((c, s) if at_origin else (s, c)), c2),
        lambda: _even_multiples(q, sign, c, s, c2),
    )
    odd, even = tuple(odd_even[:4]), tuple(odd_even[4:8])
    winding = k.pick(wound, lambda: _difference(q, own, c + s), lambda: odd)
    if at_origin:
        slope, square = _at_end(k, mod, odd, even, winding, is_near, c, s, c2, swapped)
    else:
        origin = k.where(swapped, mod.theta3, k.where(mod.circular, mod.theta4, mod.theta2))
        at = cubic(even, q)
        slope = k.over(cubic(winding, q), at) * k.where(halves, 1.0, 2.0)
        square = (at / origin) ** 2
    turn = k.where(mod.circular, k.where(near > 0, 0.0, math.pi), math.pi - 2 * angle)
    odd, even, winding = along(k, mod, odd), along(k, mod, even), along(k, mod, winding)
    if not at_origin:
        # θ₄(ã + iζ) there is 2i exp(−iã) θ₁(ã), to all its digits.
        value = 2 * s * s * cubic(mod.sines, q * c2)
        even = (k.where(mod.circular, even[0], value), *even[1:])
    return Factor(odd, even, winding, wound, halves, turn, distance, slope, square)


@dataclass(frozen=True)
class Real4:
    """θ₁, θ₂, θ₃ and θ₄ on the real axis, but for factors: see `Factor`."""

    first: Cubic
    second: Cubic
    third: Cubic
    fourth: Cubic

    def at(self, k: Kit, mod: Modulus, place: PeriodPlace) -> tuple[Real, Real, Real, Real]:
        weight = k.sqrt(place.plus / 2)
        all_four = self.first, self.second, self.third, self.fourth
        first, second, third, fourth = k.cubics(all_four, place.x)
        second, fourth = k.pick(
            mod.circular,
            lambda: (weight * second, fourth),
            lambda: (second, weight * fourth),
        )
        return place.t * weight * first, second, third, fourth


def real4(k: Kit, mod: Modulus) -> Real4:
    """The theta functions θ₁ to θ₄ of real z, signed as between z = ±π/2, or ±πK/(2K′)."""
    q = mod.q
    halves = _odd_multiples(q, 1.0, 0.0, 1.0, 1.0)[4:8]
    minus, plus = (_even_multiples(q, sign, 1.0, 0.0, 1.0)[4:8] for sign in (-1.0, 1.0))
    second = k.pick(mod.circular, lambda: halves, lambda: minus)
    fourth = k.pick(mod.circular, lambda: minus, lambda: halves)
    second, third, fourth = (along(k, mod, tuple(c)) for c in (second, plus, fourth))
    second = (k.where(mod.circular, second[0], 0.0), *second[1:])
    return Real4(along(k, mod, mod.sines), second, third, fourth)


def _odd_multiples(q: Real, sign: float, f: Real, g: Real, c2: Real) -> tuple[Real, ...]:
    """Σ ±qⁿ⁽ⁿ⁺¹⁾ of the multiples 1, 3, 5, 7: F with f, and G with g, by Chebyshev polynomials.

    cos 3b = (2 cos 2b − 1) cos b and sin 3b = (2 cos 2b + 1) sin b; which of the two f is, its
    sign at `sign` tells: f is the cosine of b for θ₁, and g for θ₂.
    """
    q2 = q * q
    q4, q9 = q2 * q2, q2 * q2 * q2 * q2 * q
    cosines = (
        2 * c2 - 1,
        (4 * c2 - 2) * c2 - 1,
        ((8 * c2 - 4) * c2 - 4) * c2 + 1,
    )
    sines = (
        2 * c2 + 1,
        (4 * c2 + 2) * c2 - 1,
        ((8 * c2 + 4) * c2 - 4) * c2 - 1,
    )
    fs, gs = (cosines, sines) if sign < 0 else (sines, cosines)
    f1, f2, f3 = sign * q * f * fs[0], q4 * f * fs[1], sign * q9 * f * fs[2]
    g1, g2, g3 = sign * q * g * gs[0], q4 * g * gs[1], sign * q9 * g * gs[2]
    return (
        f + q * f1 - q2 * f2 - q2 * q * f3,
        2 * f1 + 2 * q * f2 - 4 * q2 * f3,
        4 * f2 + 4 * q * f3,
        8 * f3,
        g - q * g1 - q2 * g2 + q2 * q * g3,
        2 * g1 - 2 * q * g2 - 4 * q2 * g3,
        4 * g2 - 4 * q * g3,
        8 * g3,
    )


def _difference(q: Real, sign: float, grown: Real) -> Cubic:
    """F − G of Σ ±qⁿ⁽ⁿ⁺¹⁾ of the multiples 1, 3, 5, 7, from e^b."""
    q2 = q * q
    shrunk = 1 / grown
    one, other = shrunk * shrunk, grown * grown
    # −±(f − g) and f + g of each.
    d0, d1 = -sign * shrunk, -q * shrunk * one
    q4 = q2 * q2
    q9 = q4 * q4 * q
    d2, d3 = -sign * q4 * shrunk * one * one, -q9 * shrunk * one * one * one
    s1, s2 = sign * q * grown * other, q4 * grown * other * other
    s3 = sign * q9 * grown * other * other * other
    return (
        d0 + q * s1 - q2 * d2 - q2 * q * s3,
        2 * d1 + 2 * q * s2 - 4 * q2 * d3,
        4 * d2 + 4 * q * s3,
        8 * d3,
    )


def _even_multiples(q: Real, sign: Real, c: Real, s: Real, c2: Real) -> tuple[Real, ...]:
    """1 + 2 Σ ±q^(n²) of the multiples 2, 4, 6: F/(1 + C), and G."""
    q2 = q * q
    q6 = q2 * q2 * q2
    s2 = 2 * s * c
    d1, d2, d3 = -2 * sign * s2, -4 * q2 * s2 * c2, -2 * sign * q6 * s2 * (4 * c2 * c2 - 1)
    e1, e2, e3 = 2 * sign * c2, 2 * q2 * (2 * c2 * c2 - 1), 2 * sign * q6 * c2 * (4 * c2 * c2 - 3)
    h0, h1, h2 = d1 - q2 * d3, 2 * d2, 4 * d3
    return (
        q * h0,
        q * h1,
        q * h2,
        0 * q,
        1 - q2 * e2,
        e1 - 3 * q2 * e3,
        2 * e2,
        4 * e3,
    )


def _at_end(
    k: Kit,
    mod: Modulus,
    odd: Cubic,
    even: Cubic,
    winding: Cubic,
    is_near: Truth,
    c: Real,
    s: Real,
    c2: Real,
    swapped: Truth,
) -> tuple[Real, Real]:
    """`slope` and `square` of a function whose zeros lie above the origin."""
    q = mod.q

    def circular() -> tuple[Real, Real]:
        f, g = cubic(odd, -q), cubic(even, -q)
        denominator = k.where(swapped, mod.theta4, mod.theta3)
        near = k.where(g > 0, k.over(-cubic(winding, -q), f), 0.0)
        slope = k.where(is_near, near, k.over(-2 * f, g))
        return slope, (k.where(is_near, f, g) / denominator) ** 2

    def hyperbolic() -> tuple[Real, Real]:
        q3 = q * q * q
        value = (
            1
            - 2 * q * c2
            + 2 * q * q3 * (2 * c2 * c2 - 1)
            - 2 * q3 * q3 * q3 * c2 * (4 * c2 * c2 - 3)
        )
        slope = 8 * s * c * q * (1 - 4 * q3 * c2 + 3 * q3 * q3 * q * q * (4 * c2 * c2 - 1)) / value
        denominator = k.where(swapped, 16 * q * mod.theta2**2, mod.theta3**2)
        return slope, k.over(value * value, denominator)

    values = k.pick(mod.circular, circular, hyperbolic)
    return values[0], values[1]
