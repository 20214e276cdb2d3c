"""Where a heavy top turns round: the roots of its cubic, from its start (see `heavy`).

What decides the accuracy is how the roots are found.  Differences from the initial value,
δ = x − x₀, keep the digits of a small nutation; the product of the roots, (a − b)² at x = 0 and
(a + b)² at y = 0, keeps those of the distance from a pole; at a separatrix x₁ and x₃ are the
roots of a quadratic whose discriminant is a sum; and at the threshold of the sleeping top, where
the three roots meet, everything is made of the two differences that are small there, b² − 4μ and
φ̇ − b/y, so that their rounding is no more than another top or another start.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from rigidtop.motion.exact.numbers import ROUNDING, SMALLEST_PART, Kit, Real, Truth

UNITS = 2 * float(np.finfo(float).eps)
"""What rounding does to a sum that decides how near to a pole or a separatrix a motion comes."""

NEWTON_STEPS = 4
"""From roots by cosines, which are good to 1e-8 at worst, to rounding."""

NEAR_POLE = 0.25
"""A turning point nearer to a pole than this part of where the motion starts is known by a
product of roots; a difference would lose digits."""


@dataclass(frozen=True)
class Roots:
    """The turning points x₁ and x₂, as differences from x₀, from the poles and from x₃."""

    delta1: Real
    delta2: Real
    x1: Real
    x2: Real
    y1: Real
    y2: Real
    span: Real
    """x₂ − x₁."""
    m03: Real
    """−2μx₃, finite for μ = 0."""


def unless_rounding(k: Kit, one: Real, other: Real) -> Real:
    """The sum; 0 if it is no more than rounding of the two."""
    total = one + other
    return k.where(abs(total) <= UNITS * (abs(one) + abs(other)), 0.0, total)


@dataclass(frozen=True)
class Scaled:
    """A start in units of σ, and what of it decides how near to a pole it comes."""

    sigma: Real
    mu: Real
    b: Real
    v_theta: Real
    v_phi: Real
    speed: Real
    """Of the axis."""
    x0: Real
    y0: Real
    sine: Real
    momentum: Real
    """φ̇ sin²θ."""
    away_up: Real
    """φ̇ sin θ less what it is on the way through the upright."""
    c_up: Real
    """a − b."""
    c_down: Real
    """a + b."""


def roots(k: Kit, start: Scaled) -> tuple[Roots, Scaled, Truth]:
    """Where ẋ² = c₀ + 2gδ − hδ² − 2μδ³ vanishes, δ = x − x₀.

    Also the start with a ± b zero if the axis passes through a pole, and whether θ is constant, to
    rounding of the start: half the slope g of ẋ² at x₀, and θ̇, are zero.
    """
    mu, b, v_theta, v_phi = start.mu, start.b, start.v_theta, start.v_phi
    x0, y0, s, momentum = start.x0, start.y0, start.sine, start.momentum
    away_up, c_up, c_down = start.away_up, start.c_up, start.c_down
    u0 = (y0 - x0) / 2
    w2 = v_theta * v_theta + v_phi * v_phi
    c0 = (s * v_theta) * (s * v_theta)
    upright = (abs(b) - 2 * k.sqrt(mu)) * (abs(b) + 2 * k.sqrt(mu))  # b² − 4μ
    tilted = upright + 4 * mu * x0  # b² − 4μ cos θ
    h = w2 + tilted
    terms = u0 * w2, mu * s * s, -b * momentum
    sizes = abs(terms[0]) + terms[1] + abs(terms[2])
    # Next to the threshold of steady precession by squares.
    apart = away_up - k.over(b * s * x0, 2 * u0 * y0)
    squares = u0 * (v_theta * v_theta + apart * apart) - k.over(s * s * tilted, 4 * u0)
    at_threshold = k.both(u0 > 0.5, abs(tilted) < b * b / 4)
    g = k.where(at_threshold, squares, terms[0] + terms[1] + terms[2])
    # The cubic for P = −2μδ, whose roots stay finite for μ = 0: P³ − hP² − 4μgP + 4μ²c₀.
    q = k.larger((h * h + 12 * mu * g) / 9, 0.0)
    r = (h * h * h + 18 * h * mu * g - 54 * mu * mu * c0) / 27
    root = k.sqrt(q)
    cosine = k.where(q * root > 0, k.over(r, q * root), 1.0)
    third = k.acos(k.larger(k.smaller(cosine, 1.0), -1.0)) / 3
    high, middle, low = (
        h / 3 + 2 * root * k.cos(third + turn) for turn in (0.0, -2 * math.pi / 3, 2 * math.pi / 3)
    )

    def third_alone() -> tuple[Real, ...]:
        """P for x₃ first; δ₁ and δ₂ are then −δ² + Sδ + Q = 0."""
        p = high
        for _ in range(NEWTON_STEPS):
            value = ((p - h) * p - 4 * mu * g) * p + 4 * mu * mu * c0
            slope = (3 * p - 2 * h) * p - 4 * mu * g
            p = p - k.where(slope > 0, k.over(value, slope), 0.0)
        product = k.where(p > 0, k.over(c0, p), c0)
        total = k.where(p > 0, k.over(2 * g - 2 * mu * product, p), 2 * g - 2 * mu * product)
        larger = (abs(total) + k.sqrt(total * total + 4 * product)) / 2
        smaller = k.where(larger > 0, k.over(product, larger), 0.0)
        delta1 = k.where(total >= 0, -smaller, -larger)
        delta2 = k.where(total >= 0, larger, smaller)
        x1, m03 = k.larger(x0 + delta1, 0.0), k.larger(p - 2 * mu * x0, 0.0)
        x2 = x0 + delta2
        # The nearer one by the product of the roots.
        x1, m03 = (
            k.where(k.both(x1 < NEAR_POLE * x0, m03 > 0), k.over(c_up * k.over(c_up, x2), m03), x1),
            k.where(
                k.both(m03 < NEAR_POLE * p, x1 >= NEAR_POLE * x0),
                k.over(c_up * k.over(c_up, x2), x1),
                m03,
            ),
        )
        return delta1, delta2, x1, m03

    def second_alone() -> tuple[Real, ...]:
        """δ₂ first; x₁ and x₃ are then 2μx² + Bx − C = 0."""
        delta2 = k.larger(k.over(-low, 2 * mu), 0.0)
        for _ in range(NEWTON_STEPS):
            value = ((-2 * mu * delta2 - h) * delta2 + 2 * g) * delta2 + c0
            slope = (-6 * mu * delta2 - 2 * h) * delta2 + 2 * g
            delta2 = k.larger(delta2 - k.where(slope < 0, k.over(value, slope), 0.0), 0.0)
        x2 = x0 + delta2
        c = c_up * k.over(c_up, x2)
        # Half the slope of ẋ² at x = 0.
        direct = w2 - 2 * mu * x0 - b * c_up
        parts = unless_rounding(
            k,
            v_theta * v_theta + away_up * away_up,
            k.over(x0, y0) * (upright + 2 * mu * x0 + b * s * away_up),
        )
        linear = k.over(2 * k.where(x0 < 1, parts, direct) - c, x2)
        larger = (abs(linear) + k.sqrt(linear * linear + 8 * mu * c)) / 2
        other = k.where(larger > 0, k.over(2 * mu * c, larger), 0.0)
        m01, m03 = k.where(linear > 0, other, larger), k.where(linear > 0, larger, other)
        x1 = k.over(m01, 2 * mu)
        # So that the motion starts where and as fast as it does.
        meeting = (m03 + 2 * mu * x0) * delta2
        moved = k.where(
            k.both(2 * x1 > x0, meeting > 0), -k.over(c0, meeting), k.smaller(x1 - x0, 0.0)
        )
        return moved, delta2, k.where(2 * x1 > x0, k.larger(x0 + moved, 0.0), x1), m03

    delta1, delta2, x1, m03 = k.pick(high - middle >= middle - low, third_alone, second_alone)
    from_down = 4 * mu + m03
    y1, y2 = y0 - delta1, y0 - delta2
    product = k.over(c_down * k.over(c_down, y1), from_down)
    y2 = k.where(k.both(y2 < NEAR_POLE * y0, from_down > 0), product, y2)
    x2 = x0 + delta2
    through_up, through_down = x1 <= SMALLEST_PART * x2, y2 <= SMALLEST_PART * y1
    ordered = Roots(
        delta1=delta1,
        delta2=delta2,
        x1=k.where(through_up, 0.0, x1),
        x2=x2,
        y1=y1,
        y2=k.where(through_down, 0.0, y2),
        span=delta2 - delta1,
        m03=m03,
    )
    passing = replace(
        start,
        c_up=k.where(through_up, 0.0, c_up),
        c_down=k.where(through_down, 0.0, c_down),
    )
    steady = k.both(abs(g) <= ROUNDING * sizes, abs(v_theta) <= ROUNDING * start.speed)
    return ordered, passing, steady
