"""The heavy symmetric top, solved.

With u = cos θ, φ̇ sin²θ + bu = a and ½(θ̇² + φ̇² sin²θ) + μu = ε are constant, where

    b = λ₃ω₃/λ₁,  μ = MgR/λ₁,  a = p_φ/λ₁,

so u̇² is a cubic in u (Goldstein 5.7; Whittaker, Analytical Dynamics §71).  In x = 1 − u and
y = 1 + u, which are known to all their digits near the upright and the hanging top, it is

    ẋ² = 2μ (x − x₁)(x₂ − x)(x − x₃),    x₃ ≤ 0 ≤ x₁ ≤ x ≤ x₂ ≤ 2,
    x = x₁ sn²τ + x₂ cn²τ,    τ = τ₀ + νt,    ν² = ½μ(x₂ − x₃),

and φ ± ψ follow from one integral of the third kind each: 2φ = X + Y and 2(ψ − ω₃t) = Y − X with

    Ẋ = (1 + u)φ̇ = b + (a − b)/x,    Ẏ = (1 − u)φ̇ = (a + b)/y − b.

What decides the accuracy is how the roots are found.  Differences from the initial value,
δ = x − x₀, keep the digits of a small nutation; the product of the roots, (a − b)² at x = 0 and
(a + b)² at y = 0, keeps those of the distance from a pole; and at a separatrix x₁ and x₃ are the
roots of a quadratic whose discriminant is a sum.  Where steady precession and separatrix meet, the
root that stands alone is found first.

All quantities are arrays that broadcast.  `Start` and `Orbit` are in units of time 1/σ.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact.elliptic import (
    SMALLEST_ARGUMENT,
    SMALLEST_PART,
    Jacobi,
    first_kind,
    jacobi,
    quarter_period,
)
from rigidtop.motion.exact.series import Series, series
from rigidtop.motion.state import TopState

ROUNDING = 16 * float(np.finfo(float).eps)
"""What rounding of the initial state does to quantities that decide the regime."""

REGIMES = (
    "free precession",
    "sleeping",
    "hanging",
    "steady",
    "asymptotic",
    "plane",
    "through the vertical",
    "cusps",
    "loops",
    "waves",
)
"""What an axis can do: see `Orbit.regime`, which takes the first that holds."""

NEWTON_STEPS = 4
"""From roots by cosines, which are good to 1e-8 at worst, to rounding."""

MANY = 400
"""From so many samples of one motion on, its Fourier series is worth its making."""

APART = 1e-13
"""Of x₀: two ways to x₁ that differ by more come from different cubics."""

NEAR_POLE = 0.25
"""A turning point nearer to a pole than this part of where the motion starts is known by a
product of roots; a difference would lose digits."""


@dataclass(frozen=True)
class Start:
    """A top and its state at t = 0, arrays that broadcast; rates in rad/s, μ in 1/s²."""

    mu: Floats
    """MgR/λ₁ ≥ 0."""

    b: Floats
    """λ₃ω₃/λ₁."""

    omega3: Floats

    cos_half: Floats
    """cos(θ/2) ≥ 0."""

    sin_half: Floats
    """sin(θ/2) ≥ 0."""

    v_theta: Floats
    """θ̇."""

    v_phi: Floats
    """φ̇ sin θ."""

    phi: Floats
    psi: Floats


@dataclass(frozen=True)
class _Roots:
    """The turning points: x₁, x₂ and their distances; 2μ times those from x₃, finite for μ = 0."""

    delta1: Floats
    delta2: Floats
    x1: Floats
    x2: Floats
    m03: Floats
    """−2μx₃."""
    by_product: NDArray[np.bool_]
    """Whether x₁ is known by the product of the roots, and not as x₀ + δ₁."""


@dataclass(frozen=True)
class Orbit:
    """The motion from a start, made by `solve`; rates and times in the unit of `sigma`."""

    start: Start
    sigma: Floats
    """The unit of rates (1/s)."""
    mu: Floats
    b: Floats
    c_up: Floats
    """a − b, zero for an axis that passes through the upright."""
    c_down: Floats
    """a + b, zero for an axis that passes through straight down."""
    x1: Floats
    x2: Floats
    y1: Floats
    y2: Floats
    range: Floats
    """x₂ − x₁."""
    a1: Floats
    """φ̇ sin²θ at x₁."""
    a2: Floats
    """φ̇ sin²θ at x₂."""
    m: Floats
    m1: Floats
    ratio: Floats
    """(x₂ − x₃)/(2 − x₃)."""
    nu: Floats
    quarters: Floats
    """Which of −K, 0, K is nearest to τ₀: −1, 0 or 1."""
    offset: Floats
    """τ₀ from there."""
    begin: Jacobi
    """At τ₀."""
    still: NDArray[np.bool_]
    """Whether θ stays where it is because the axis is vertical and at rest."""
    steady: NDArray[np.bool_]
    """Whether θ is constant, to rounding of the initial state."""
    asymptotic: NDArray[np.bool_]
    """Whether it climbs to the upright for ever, to rounding of the initial state."""
    through: NDArray[np.bool_]
    """Whether its axis passes through the vertical, to rounding of the initial state."""

    # --- Turning points and periods ---

    @cached_property
    def quarter(self) -> Floats:
        """K, the half of a nutation in τ."""
        return quarter_period(self.m1)

    @cached_property
    def tau0(self) -> Floats:
        """τ at t = 0."""
        return np.where(self.quarters == 0, 0.0, self.quarters * self.quarter) + self.offset

    @property
    def turning_points(self) -> tuple[Floats, Floats]:
        """The smallest and the largest θ (rad)."""
        return (
            2 * np.arctan2(np.sqrt(self.x1), np.sqrt(self.y1)),
            2 * np.arctan2(np.sqrt(self.x2), np.sqrt(self.y2)),
        )

    @property
    def nutation_period(self) -> Floats:
        """The time from one smallest θ to the next (s); infinite where there is no next."""
        with np.errstate(all="ignore"):
            return np.where(self.asymptotic, np.inf, 2 * self.quarter / (self.nu * self.sigma))

    @property
    def precession_per_period(self) -> Floats:
        """By how much φ grows in a nutation period (rad), without half turns at the vertical."""
        with np.errstate(all="ignore"):
            mean = self.mean_precession
            return np.where(mean == 0, 0.0, mean * self.nutation_period)

    @property
    def mean_precession(self) -> Floats:
        """The mean of φ̇ over a nutation, or for all times if that never ends (rad/s)."""
        with np.errstate(all="ignore"):
            # To rounding, as the regime: where φ does not jump by a half turn, it makes one.
            up = np.abs(self.c_up) < np.abs(self.c_down)
            upper, lower = self._complete
            turned = np.where(self.through & up, 0.0, upper)
            turned = turned + np.where(self.through & ~up, 0.0, lower)
            mean = (self._drift_x + self._drift_y + turned * self.nu / (2 * self.quarter)) / 2
            mean = np.where((self.m1 > 0) & ~self.asymptotic, mean, self.b / 2)
            return np.where(self.plane, 0.0, mean) * self.sigma

    @property
    def plane(self) -> NDArray[np.bool_]:
        """Whether it is a pendulum without spin, to rounding of the initial state."""
        across = self.x1 * self.y1 + self.range  # about the largest sin²θ
        return (self.b == 0) & (np.abs(self.a1) + np.abs(self.a2) <= ROUNDING * across)

    @cached_property
    def regime(self) -> NDArray[np.str_]:
        """What the axis does, to rounding of the initial state.

        "sleeping" and "hanging" (vertical, at rest), "free precession" (no weight), "steady",
        "asymptotic" (to the upright, which it never reaches), "plane" (a pendulum without spin),
        "through the vertical", and by the sign of φ̇ "waves", "cusps" and "loops".
        """
        upright = self.x1 < self.y1
        return np.select(
            [
                self.mu == 0,
                self.still & upright,
                self.still,
                self.steady,
                self.asymptotic,
                self.plane,
                self.through,
                np.abs(self.a1) <= ROUNDING * (np.abs(self.a2) + np.abs(self.b) * self.range),
                self.a1 * self.a2 < 0,
            ],
            REGIMES[:-1],
            REGIMES[-1],
        )

    # --- Third-kind integrals ---

    @cached_property
    def _drift_x(self) -> Floats:
        """Ẋ at x₂; of a top that stays upright, the limit of its neighbours."""
        a2 = np.where(self.x2 > 0, self.a2, self.b)
        return a2 / np.where(self.x2 > 0, self.x2, 1.0)

    @cached_property
    def _far_from_down(self) -> NDArray[np.bool_]:
        """Whether y varies little; else x₂ is near y = 0, where Ẏ has a peak."""
        return (self.range <= self.y2) & (self.y2 > 0)

    @cached_property
    def _drift_y(self) -> Floats:
        """The part of Ẏ that is constant."""
        return np.where(self._far_from_down, self.a2 / np.where(self.y2 > 0, self.y2, 1.0), -self.b)

    def _third_kinds(self, f: Jacobi, tau: Floats) -> tuple[Floats, Floats]:
        """X and Y without their constant parts, from τ = 0 to |τ| ≤ K."""
        # X: x = x₂(1 − n sn²) is smallest at K.
        moving = self._factor_x != 0
        x = np.where(moving, self.x1 * f.sn**2 + self.x2 * f.cn**2, 1.0)
        p = x / np.where(moving, self.x2, 1.0)
        upper = self._factor_x * f.third_kind(np.where(p > 0, p, 1.0))
        # Y the same way where y does not vary much.
        far, y1, y2 = self._far_from_down, self.y1, self.y2
        if np.all(far):
            return upper, self._factor_y * f.third_kind(1 + self.range / y2 * f.sn**2)
        # Else by the transformation that takes the peak of 1/y at τ = 0 into an arc tangent.
        y1, safe_y2 = np.where(y1 > 0, y1, 1.0), np.where(y2 > 0, y2, 1.0)
        p = np.where(far, 1 + self.range / safe_y2 * f.sn**2, f.cn**2 + self.m1 * y2 / y1 * f.sn**2)
        tail = f.third_kind(np.where(p > 0, p, 1.0))
        weight = self.m1 * np.sqrt(self.ratio * y2 / y1)
        across = np.sqrt(self.ratio * y1 * y2)
        arc = np.arctan2(self.range * f.sn * f.cn, f.dn * across)
        # From the product of the roots at y = 0; through y = 0 itself the phase jumps by π.
        straight = 2 * self.mu * np.sqrt(y1 * y2) / self._root_of_distances
        n = self.range / (self.ratio * y1)
        bent = np.where(weight > 0, weight * (tau + n * tail), 0.0) + straight * tau + arc
        around = 2 * np.copysign(1.0, self.c_down) * bent
        through = np.copysign(np.pi, f.sn)  # the zero is signed: before or after
        near = np.where(self.still, 0.0, np.where(y2 > 0, around, through))
        return upper, np.where(far, self._factor_y * tail, near)

    @cached_property
    def _per_rate(self) -> Floats:
        return 1 / np.where(self.nu > 0, self.nu, np.inf)

    @cached_property
    def _factor_x(self) -> Floats:
        x2 = np.where(self.x2 > 0, self.x2, 1.0)
        return self.range / x2 * (self.c_up / x2) * self._per_rate

    @cached_property
    def _factor_y(self) -> Floats:
        y2 = np.where(self._far_from_down, self.y2, 1.0)
        return -self.range / y2 * (self.c_down / y2) * self._per_rate

    @cached_property
    def _root_of_distances(self) -> Floats:
        """√(2μ(x₂ − x₃) · 2μ(2 − x₃)): 4ν²/√ratio."""
        moving = self.nu > 0
        return np.where(moving, 4 * self.nu**2 / np.sqrt(np.where(moving, self.ratio, 1.0)), 1.0)

    @cached_property
    def _complete(self) -> tuple[Floats, Floats]:
        """X and Y without their constant parts over a nutation, 2K."""
        zero = np.zeros_like(self.m1)
        f = Jacobi(zero + 1, zero, np.sqrt(self.m1))
        with np.errstate(invalid="ignore", over="ignore", divide="ignore"):
            upper, lower = self._third_kinds(f, np.where(self.m1 > 0, self.quarter, 0.0))
        # An axis that passes through the vertical comes out on the other side: φ jumps, by π and
        # back, which is no precession.
        upper = np.where(self._through_up, 0.0, 2 * upper)
        lower = np.where(self._through_down, 0.0, 2 * lower)
        return upper, lower

    @property
    def _through_up(self) -> NDArray[np.bool_]:
        return (self.x1 == 0) & ~self.still

    @property
    def _through_down(self) -> NDArray[np.bool_]:
        return (self.y2 == 0) & ~self.still

    @cached_property
    def _at_start(self) -> tuple[Floats, Floats]:
        return self._third_kinds(self.begin, self.tau0)

    # --- The state ---

    def at(self, t: ArrayLike) -> TopState:
        """The state at times t (s), which broadcast against the orbit."""
        times = np.asarray(t, dtype=float)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
            if self.m1.ndim == 0 and times.ndim == 1 and times.size >= MANY:
                samples = self._samples
                if samples is not None:
                    return self._by_series(samples, times)
            return self._at(times)

    def _at(self, t: Floats) -> TopState:
        scaled = t * self.sigma
        turns, reduced, f = self._phase(scaled)
        x_kind, y_kind = self._third_kinds(f, reduced)
        x_begin, y_begin = self._at_start
        big_x = self._drift_x * scaled + (x_kind - x_begin)
        big_y = self._drift_y * scaled + (y_kind - y_begin)
        if np.any(turns):
            x_turn, y_turn = (np.where(self.m1 > 0, part, 0.0) for part in self._complete)
            big_x, big_y = big_x + turns * x_turn, big_y + turns * y_turn
            odd = np.mod(turns, 2) == 1
            big_x = np.where(odd & self._through_up, big_x + 2 * np.pi, big_x)
            big_y = np.where(odd & self._through_down, big_y - 2 * y_kind, big_y)
        cos_half, sin_half, theta_dot, v_phi = self._axis(f)
        s = self.start
        return TopState(
            cos_half=cos_half,
            sin_half=sin_half,
            phi=s.phi + (big_x + big_y) / 2,
            psi=s.psi + s.omega3 * t + (big_y - big_x) / 2,
            theta_dot=theta_dot,
            v_phi=v_phi,
            omega3=s.omega3,
            upright_phi_dot=s.b / 2,
        )

    def _phase(self, scaled: Floats) -> tuple[Floats, Floats, Jacobi]:
        """Nutations since τ = 0, what remains of τ, and Jacobi's functions of that.

        τ is counted from the nearest multiple of K, so that x − x₁ keeps its digits near x₁ too.
        """
        # At t = 0 the sign of a zero counts.
        since = np.where(scaled == 0, self.offset, self.offset + self.nu * scaled)
        bounded = self.m1 > 0
        quarter = np.where(bounded, self.quarter, 1.0)
        passed = np.where(bounded, np.rint(since / quarter), 0.0)
        rest = np.where(passed == 0, since, since - passed * quarter)
        count = self.quarters + passed
        near_k = np.mod(count, 2) == 1
        side = np.where(rest == 0, np.sign(count), -np.sign(rest))
        f, k1 = jacobi(rest, self.m1), np.sqrt(self.m1)
        if not np.any(near_k):
            return count / 2, rest, f
        around_k = side * f.cn / f.dn, k1 * np.abs(f.sn) / f.dn, k1 / f.dn
        shifted = (
            np.where(near_k, one, other)
            for one, other in zip(around_k, vars(f).values(), strict=True)
        )
        return (
            np.where(near_k, count - side, count) / 2,
            np.where(near_k, side * quarter + rest, rest),
            Jacobi(*shifted),
        )

    def _axis(self, f: Jacobi) -> tuple[Floats, Floats, Floats, Floats]:
        """cos(θ/2), sin(θ/2), θ̇ and φ̇ sin θ."""
        x = self.x1 * f.sn**2 + self.x2 * f.cn**2
        y = self.y1 * f.sn**2 + self.y2 * f.cn**2
        sine = np.sqrt(x * y)
        root = np.sqrt(self.range)
        # cos and sin of an angle that is 0 or π/2 where the axis passes through a pole.
        toward_up = np.where(x > 0, root * f.cn / np.sqrt(x), 1.0)
        toward_down = np.where(y > 0, root * f.sn / np.sqrt(y), np.copysign(1.0, f.sn))
        theta_dot = np.where(
            self.range > 0, -2 * self.nu * self.sigma * f.dn * toward_up * toward_down, 0.0
        )
        momentum = self.a1 * f.sn**2 + self.a2 * f.cn**2
        v_phi = np.where(sine > 0, momentum / np.where(sine > 0, sine, 1.0), 0.0) * self.sigma
        return np.sqrt(y / 2), np.sqrt(x / 2), theta_dot, v_phi

    # --- Many states of one motion ---

    @cached_property
    def _samples(self) -> _Samples | None:
        """The motion's periodic part, if a few harmonics give it to rounding."""
        if not (self.m1 > 0 and self.x1 > 0 and self.y2 > 0):
            return None
        k = self.quarter
        ends = np.array([self.tau0, k])

        def phases(tau: Floats) -> tuple[Jacobi, Floats]:
            f = jacobi(tau, self.m1)
            x_kind, y_kind = self._third_kinds(f, tau)
            return f, np.stack([x_kind + y_kind, y_kind - x_kind]) / 2

        start, rate = phases(ends)[1].T
        rate = rate / k

        def periodic(u: Floats) -> tuple[Floats, Floats]:
            tau = 2 * k * u
            f, angles = phases(tau)
            cos_half, sin_half, theta_dot, v_phi = self._axis(f)
            even = np.stack([cos_half, sin_half, v_phi])
            return even, np.stack([theta_dot, *(angles - rate[:, None] * tau)])

        found = series(periodic)
        return None if found is None else _Samples(found, rate, rate * self.tau0 - start)

    def _by_series(self, samples: _Samples, t: Floats) -> TopState:
        even, odd = np.empty((2, 3, len(t)))
        nu = self.nu * self.sigma
        period = 2 * self.quarter
        samples.periodic.evaluate(self.tau0 / period + nu / period * t, even, odd)
        theta_dot, phi, psi = odd
        phi_drift = (self._drift_x + self._drift_y) / 2 * self.sigma + samples.rates[0] * nu
        psi_drift = (self._drift_y - self._drift_x) / 2 * self.sigma + samples.rates[1] * nu
        s = self.start
        phi += phi_drift * t
        phi += s.phi + samples.first[0]
        psi += (s.omega3 + psi_drift) * t
        psi += s.psi + samples.first[1]
        return TopState(
            cos_half=even[0],
            sin_half=even[1],
            phi=phi,
            psi=psi,
            theta_dot=theta_dot,
            v_phi=even[2],
            omega3=s.omega3,
            upright_phi_dot=s.b / 2,
        )


@dataclass(frozen=True)
class _Samples:
    """A motion as a Fourier series: θ̇, φ and ψ odd in τ, the rest even."""

    periodic: Series
    rates: Floats
    """By how much φ and ψ grow in a unit of τ, on average, beside their constant parts."""
    first: Floats
    """What is added to φ and ψ, whose periodic part is not zero at t = 0."""


def solve(start: Start) -> Orbit:
    """The orbit from a start; arrays broadcast."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
        return _solve(start)


def _solve(start: Start) -> Orbit:
    speed = np.hypot(start.v_theta, start.v_phi)
    sigma = np.sqrt(start.mu) + np.abs(start.b) + speed
    sigma = np.where(sigma > 0, sigma, 1.0)
    mu, b = start.mu / sigma / sigma, start.b / sigma
    # −0 would say on which side of the vertical φ jumps.
    v_theta, v_phi, w = start.v_theta / sigma + 0.0, start.v_phi / sigma, speed / sigma
    # Squares of less would lose digits; an attitude does not notice.
    sin_half, cos_half = (
        np.where((half > 0) & (half < SMALLEST_ARGUMENT), SMALLEST_ARGUMENT, half)
        for half in (start.sin_half, start.cos_half)
    )
    x0, y0 = 2 * sin_half**2, 2 * cos_half**2
    s = 2 * sin_half * cos_half
    momentum = s * v_phi
    c_up, c_down = momentum - b * x0, momentum + b * y0
    # What rounding of the initial state cannot tell from the special cases.
    passes_up = np.abs(c_up) <= ROUNDING * (np.abs(momentum) + np.abs(b) * x0)
    passes_down = np.abs(c_down) <= ROUNDING * (np.abs(momentum) + np.abs(b) * y0)
    w_up = w**2 - 2 * mu * x0  # speed² of the axis, were it upright
    arrives = passes_up & (np.abs(w_up) <= ROUNDING * (w**2 + 2 * mu * x0)) & (b**2 < 4 * mu)
    pull, sizes = _pull(mu, b, w, x0, y0, s, momentum)
    steady = (np.abs(pull) <= ROUNDING * sizes) & (np.abs(v_theta) <= ROUNDING * w)
    roots = _roots(mu, b, w, s * v_theta, pull, x0, y0, c_up)
    delta1, delta2 = roots.delta1, roots.delta2
    x1, x2, y1 = roots.x1, x0 + delta2, y0 - delta1
    from_down = 4 * mu + roots.m03
    y2 = y0 - delta2
    product = c_down * (c_down / y1) / np.where(from_down > 0, from_down, np.inf)
    near_up, near_down = roots.by_product, (y2 < NEAR_POLE * y0) & (from_down > 0)
    y2 = np.where(near_down, product, y2)
    a1 = np.where(near_up, c_up + b * x1, momentum + b * delta1)
    a2 = np.where(near_down, c_down - b * y2, momentum + b * delta2)
    through_up, through_down = x1 <= SMALLEST_PART * x2, y2 <= SMALLEST_PART * y1
    x1, c_up = np.where(through_up, 0.0, x1), np.where(through_up, 0.0, c_up)
    y2 = np.where(through_down, 0.0, y2)
    span = delta2 - delta1
    m13 = roots.m03 + 2 * mu * x1  # a sum, also next to the separatrix
    m23 = m13 + 2 * mu * span
    safe = np.where(m23 > 0, m23, 1.0)
    m, m1 = 2 * mu * span / safe, np.where(m23 > 0, m13 / safe, 1.0)
    m1 = np.where(m1 < SMALLEST_PART, 0.0, m1)
    down = np.where(span > 0, span, 1.0)
    sn = -np.copysign(np.where(span > 0, np.sqrt(delta2 / down), 0.0), v_theta)
    cn = np.where(span > 0, np.sqrt(-delta1 / down), 1.0)
    dn, k1 = np.sqrt(m1 + m * cn**2), np.sqrt(m1)
    near_k = cn**2 < k1 * sn**2
    back = -np.copysign(first_kind(cn / dn, k1 * np.abs(sn) / dn, k1 / dn), sn)
    offset = np.where(near_k, back, first_kind(sn, cn, dn))
    # A vertical axis at rest stays, also where it is not stable; so does one whose motion is too
    # small for the square of its square, 1e-75 rad.
    still = (span == 0) & ((x0 == 0) | (y0 == 0)) | ~np.isfinite(offset)
    x1, x2, y1, y2 = (
        np.where(still, now, part) for now, part in ((x0, x1), (x0, x2), (y0, y1), (y0, y2))
    )
    span, a1, a2, sn = (np.where(still, 0.0, part) for part in (span, a1, a2, sn))
    offset, near_k = np.where(still, 0.0, offset), near_k & ~still
    cn, m, m1 = np.where(still, 1.0, cn), np.where(still, 0.0, m), np.where(still, 1.0, m1)
    # The frequency of small nutations about the vertical: b² − 4μ cos θ.
    m23 = np.where(still, np.maximum(b**2 - 4 * mu * np.sign(y0 - x0), 0.0), m23)
    return Orbit(
        start=start,
        sigma=sigma,
        mu=mu,
        b=b,
        c_up=c_up,
        c_down=c_down,
        x1=x1,
        x2=x2,
        y1=y1,
        y2=y2,
        range=span,
        a1=a1,
        a2=a2,
        m=m,
        m1=m1,
        ratio=np.where(from_down > 0, m23 / np.where(from_down > 0, from_down, 1.0), 1.0),
        nu=np.sqrt(m23) / 2,
        quarters=np.where(near_k, np.sign(sn), 0.0),
        offset=offset,
        begin=Jacobi(sn, cn, np.sqrt(m1 + m * cn**2)),
        still=still,
        steady=steady,
        asymptotic=arrives & ~(still | steady),
        # With p_φ = p_ψ alone it may lack the energy to climb there.
        through=((passes_up & (w_up > 0)) | passes_down) & ~(still | steady),
    )


def _pull(
    mu: Floats, b: Floats, w: Floats, x0: Floats, y0: Floats, s: Floats, momentum: Floats
) -> tuple[Floats, Floats]:
    """g, half the slope of ẋ² at x₀, which steady precession makes zero; and its terms' sizes."""
    terms = (y0 - x0) / 2 * w**2, mu * s**2, -b * momentum
    first, second, third = terms
    return first + second + third, np.abs(first) + np.abs(second) + np.abs(third)


def _roots(
    mu: Floats,
    b: Floats,
    w: Floats,
    x_dot: Floats,
    g: Floats,
    x0: Floats,
    y0: Floats,
    c_up: Floats,
) -> _Roots:
    """Where ẋ² = c₀ + 2gδ − hδ² − 2μδ³ vanishes, δ = x − x₀."""
    c0 = x_dot**2
    u0 = (y0 - x0) / 2
    h = w**2 + b**2 - 4 * mu * u0
    # The cubic for P = −2μδ, whose roots stay finite for μ = 0: P³ − hP² − 4μgP + 4μ²c₀.
    q = np.maximum((h**2 + 12 * mu * g) / 9, 0.0)
    r = (h**3 + 18 * h * mu * g - 54 * mu**2 * c0) / 27
    root = np.sqrt(q)
    third = np.arccos(np.clip(r / np.where(q > 0, q * root, 1.0), -1.0, 1.0)) / 3
    high, middle, low = (
        h / 3 + 2 * root * np.cos(third + turn) for turn in (0.0, -2 * np.pi / 3, 2 * np.pi / 3)
    )
    alone = high - middle >= middle - low  # x₃ is
    first = _third_root_alone(mu, g, h, c0, x0, high)
    product = c_up * (c_up / first.x2) / np.where(first.m03 > 0, first.m03, np.inf)
    first = _nearer_the_pole(first, product, x0, np.ones_like(x0))
    if np.all(alone):
        return _from_the_start(first, mu, x0, c0)
    second = _second_root_alone(mu, b, g, h, c0, w, x0, c_up, low)
    either = (
        np.where(alone, getattr(first, each.name), getattr(second, each.name))
        for each in fields(_Roots)
    )
    return _from_the_start(_Roots(*either), mu, x0, c0)


def _from_the_start(roots: _Roots, mu: Floats, x0: Floats, c0: Floats) -> _Roots:
    """With δ₁ and x₃ such that the motion starts where and as fast as it does.

    Near the critical spin, where all three roots are close, rounding of the coefficients moves
    them by more than their distances.
    """
    off = np.abs(x0 + roots.delta1 - roots.x1) > APART * x0
    between = np.maximum(x0 - roots.x1, 0.0)
    product = roots.delta2 * between
    moving = off & (c0 > 0) & (product > 0)  # else the motion starts at x₁ or x₂
    from_third = c0 / np.where(moving, product, 1.0)
    return replace(
        roots,
        delta1=np.where(off, -between, roots.delta1),
        m03=np.where(moving, np.maximum(from_third - 2 * mu * x0, 0.0), roots.m03),
    )


def _third_root_alone(
    mu: Floats, g: Floats, h: Floats, c0: Floats, x0: Floats, guess: Floats
) -> _Roots:
    """P for x₃ first; δ₁ and δ₂ are then −δ² + Sδ + Q = 0."""
    p = guess
    for _ in range(NEWTON_STEPS):
        value = ((p - h) * p - 4 * mu * g) * p + 4 * mu**2 * c0
        slope = (3 * p - 2 * h) * p - 4 * mu * g
        p = p - np.where(slope > 0, value / np.where(slope > 0, slope, 1.0), 0.0)
    safe = np.where(p > 0, p, 1.0)
    q = c0 / safe
    sum_ = (2 * g - 2 * mu * q) / safe
    span = np.sqrt(sum_**2 + 4 * q)
    larger = (np.abs(sum_) + span) / 2
    smaller = np.where(larger > 0, q / np.where(larger > 0, larger, 1.0), 0.0)
    delta1 = np.where(sum_ >= 0, -smaller, -larger)
    delta2 = np.where(sum_ >= 0, larger, smaller)
    return _Roots(
        delta1=delta1,
        delta2=delta2,
        x1=np.maximum(x0 + delta1, 0.0),
        x2=x0 + delta2,
        m03=np.maximum(p - 2 * mu * x0, 0.0),
        by_product=np.zeros_like(p, dtype=bool),
    )


def _nearer_the_pole(roots: _Roots, product: Floats, x0: Floats, terms: Floats) -> _Roots:
    """With x₁ by the product of the roots, where that is the more accurate.

    x₀ + δ₁ is known to rounding of x₀; the product as well as −2μx₃, which is known to rounding of
    the `terms` that it was made of.
    """
    known = np.minimum(roots.m03 / np.where(terms > 0, terms, 1.0), 1.0)
    by_product = (roots.x1 < NEAR_POLE * x0 * known) & (roots.m03 > 0)
    x1 = np.where(by_product, product, roots.x1)
    return replace(roots, x1=x1, by_product=by_product)


def _second_root_alone(
    mu: Floats,
    b: Floats,
    g: Floats,
    h: Floats,
    c0: Floats,
    w: Floats,
    x0: Floats,
    c_up: Floats,
    guess: Floats,
) -> _Roots:
    """δ₂ first, and then the other two.

    Where they are apart, as roots of 2μδ² + Bδ + C, with the coefficients that gave δ₂.  Next to
    the separatrix, where they meet at the pole, as roots of 2μx² + Bx − C: its discriminant is a
    sum, but its coefficients are others, to rounding, and only there this does not matter.
    """
    safe_mu = np.where(mu > 0, mu, 1.0)
    delta2 = np.maximum(-guess / (2 * safe_mu), 0.0)
    for _ in range(NEWTON_STEPS):
        value = ((-2 * mu * delta2 - h) * delta2 + 2 * g) * delta2 + c0
        slope = (-6 * mu * delta2 - 2 * h) * delta2 + 2 * g
        step = np.where(slope < 0, value / np.where(slope < 0, slope, 1.0), 0.0)
        delta2 = np.maximum(delta2 - step, 0.0)
    lowest = delta2 == 0
    safe_delta2 = np.where(lowest, 1.0, delta2)
    linear = h + 2 * mu * delta2
    last = np.maximum(np.where(lowest, -2 * g, c0 / safe_delta2), 0.0)
    square = linear**2 - 8 * mu * last
    apart = (square > linear**2 / 4) & (linear > 0)
    from_third = (linear + np.sqrt(np.maximum(square, 0.0))) / 2  # 2μ(x₀ − x₃)
    delta1 = -last / np.where(from_third > 0, from_third, 1.0)
    x2 = x0 + delta2
    safe = np.where(x2 > 0, x2, 1.0)
    c = c_up * (c_up / safe)
    w_up = w**2 - 2 * mu * x0  # speed² of the axis, were it upright
    # Where these coefficients are known no better than the others.
    terms = (w**2 + 2 * mu * x0 + np.abs(b * c_up) + c) / safe
    apart &= terms > (w**2 + b**2 + 4 * mu) / 10
    linear = (2 * (w_up - b * c_up) - c) / safe
    root = np.sqrt(linear**2 + 8 * mu * c)
    larger = (np.abs(linear) + root) / 2
    other = 2 * mu * c / np.where(larger > 0, larger, 1.0)
    m01, m03 = np.where(linear > 0, other, larger), np.where(linear > 0, larger, other)
    meeting = (m03 + 2 * mu * x0) * delta2
    x1 = m01 / (2 * safe_mu)
    by_pole = np.where(meeting > 0, -c0 / np.where(meeting > 0, meeting, 1.0), x1 - x0)
    delta1 = np.where(apart, delta1, by_pole)
    roots = _Roots(
        delta1=delta1,
        delta2=delta2,
        x1=np.maximum(x0 + delta1, 0.0),
        x2=x2,
        m03=np.where(apart, np.maximum(from_third - 2 * mu * x0, 0.0), m03),
        by_product=np.zeros_like(x1, dtype=bool),
    )
    x1 = np.where(apart, c / np.where(roots.m03 > 0, roots.m03, np.inf), x1)
    return _nearer_the_pole(roots, x1, x0, np.where(apart, 1.0, terms))
