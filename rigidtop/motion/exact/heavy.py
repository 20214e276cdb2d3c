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

`Start` and `Orbit` are floats of one motion, else arrays that broadcast.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from functools import cache, cached_property

import numpy as np
from numpy.typing import NDArray

from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact import compiled, theta
from rigidtop.motion.exact.numbers import ROUNDING, SMALLEST_PART, Arrays, Kit, Real, Truth, cubic
from rigidtop.motion.exact.roots import NEAR_POLE, Roots, roots, unless_rounding
from rigidtop.motion.exact.samples import BLOCK, Course, in_blocks
from rigidtop.motion.exact.theta import Cubic, Factor, Modulus, along, factor, modulus
from rigidtop.motion.state import TopState, rates
from rigidtop.trace import Solved, Written, written

SMALLEST_TILT = 1e-150
"""Squares of less would lose digits; an attitude does not notice."""

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

CHANGING = ("cos_half", "sin_half", "phi", "psi", "theta_dot", "v_phi")
"""What of a state is not constant."""


@dataclass(frozen=True)
class Start:
    """A top and its state at t = 0; rates in rad/s, μ in 1/s²."""

    mu: Real
    """MgR/λ₁ ≥ 0."""

    b: Real
    """λ₃ω₃/λ₁."""

    omega3: Real

    cos_half: Real
    """cos(θ/2) ≥ 0."""

    sin_half: Real
    """sin(θ/2) ≥ 0."""

    v_theta: Real
    """θ̇."""

    v_phi: Real
    """φ̇ sin θ."""

    phi: Real
    psi: Real


@dataclass(frozen=True)
class Half:
    """One of the two spinors, squared: what the other is not."""

    factor: Factor
    scale: Real
    """Of its square."""
    sense: Real
    """1 or −1: how its phase turns next to its pole."""
    through: Truth
    """Whether it goes through 0, where its phase jumps to and fro."""
    drift: Real
    """What is linear in time of its phase (1/s)."""
    at_origin: bool

    @property
    def cubics(self) -> tuple[Cubic, Cubic, Cubic]:
        return self.factor.odd, self.factor.even, self.factor.winding


@dataclass(frozen=True)
class Orbit:
    """The motion from a start, made by `solve`."""

    start: Start
    sigma: Real
    """The unit of rates of what follows (1/s)."""
    mu: Real
    b: Real
    c_up: Real
    """a − b, zero for an axis that passes through the upright."""
    c_down: Real
    """a + b, zero for an axis that passes through straight down."""
    roots: Roots
    a1: Real
    """φ̇ sin²θ at x₁."""
    a2: Real
    """φ̇ sin²θ at x₂."""
    nu: Real
    m1: Real
    modulus: Modulus
    swapped: Truth
    """Whether z counts from x₁, not from x₂."""
    z0: Real
    """z at t = 0."""
    rate: Real
    """dz/dt (1/s)."""
    first: Half
    """That whose zeros lie above the origin of z: of x if swapped, else of y."""
    second: Half
    moving: Truth
    """Whether θ changes at all."""
    wide: Truth
    """Whether a turning point is much nearer to a pole than the other."""
    sines: Cubic
    """So that sn², or cn² where z counts from x₁, is t²(1 + C) times its square over θ₄²."""
    fall: Real
    falls: tuple[Real, Real, Real]
    """θ̇ is θ₁(2z), but for factors."""
    momentum: Real
    """φ̇ sin²θ at the origin of z, over σ."""
    momentum_rise: Real
    begin: tuple[Real, Real]
    """The phases at t = 0."""
    still: Truth
    """Whether θ stays where it is because the axis is vertical and at rest."""
    steady: Truth
    """Whether θ is constant, to rounding of the initial state."""
    asymptotic: Truth
    """Whether it climbs to the upright for ever, to rounding of the initial state."""
    through: Truth
    """Whether its axis passes through the vertical, to rounding of the initial state."""

    # --- Turning points and periods ---

    @property
    def turning_points(self) -> tuple[Real, Real]:
        """The smallest and the largest θ (rad)."""
        r = self.roots
        return (
            2 * np.arctan2(np.sqrt(r.x1), np.sqrt(r.y1)),
            2 * np.arctan2(np.sqrt(r.x2), np.sqrt(r.y2)),
        )

    @property
    def nutation_period(self) -> Real:
        """The time from one smallest θ to the next (s); infinite where there is no next."""
        with np.errstate(all="ignore"):
            period = 2 * self.modulus.half / np.asarray(self.rate)
            return np.where((self.m1 > 0) & ~np.asarray(self.asymptotic), period, np.inf)

    @property
    def precession_per_period(self) -> Real:
        """By how much φ grows in a nutation period (rad), without half turns at the vertical."""
        with np.errstate(all="ignore"):
            mean = self.mean_precession
            return np.where(mean == 0, 0.0, mean * self.nutation_period)

    @property
    def mean_precession(self) -> Real:
        """The mean of φ̇ over a nutation, or for all times if that never ends (rad/s)."""
        with np.errstate(all="ignore"):
            mean = self.first.drift + self.second.drift
            # To rounding, as the regime: where φ does not jump by a half turn, it makes one.
            nearest = (np.abs(self.c_up) < np.abs(self.c_down)) == self.swapped
            for half, near in ((self.first, nearest), (self.second, ~nearest)):
                turn = np.where(self.through & near, half.factor.turn - np.pi, half.factor.turn)
                turn = np.where(half.through, 0.0, turn)
                mean = mean + half.sense * turn / self.nutation_period
            mean = np.where((self.m1 > 0) & ~np.asarray(self.asymptotic), mean, self.start.b / 2)
            return np.where(self.plane, 0.0, mean)

    @property
    def plane(self) -> NDArray[np.bool_]:
        """Whether it is a pendulum without spin, to rounding of the initial state."""
        across = self.roots.x1 * self.roots.y1 + self.roots.span  # about the largest sin²θ
        sizes = np.abs(self.a1) + np.abs(self.a2)
        return np.asarray((self.b == 0) & (self.mu > 0) & (sizes <= ROUNDING * across))

    @cached_property
    def regime(self) -> NDArray[np.str_]:
        """What the axis does, to rounding of the initial state.

        "sleeping" and "hanging" (vertical, at rest), "free precession" (no weight), "steady",
        "asymptotic" (to the upright, which it never reaches), "plane" (a pendulum without spin),
        "through the vertical", and by the sign of φ̇ "waves", "cusps" and "loops".
        """
        r, a1, a2 = self.roots, np.asarray(self.a1), np.asarray(self.a2)
        still, upright = np.asarray(self.still), np.asarray(r.x1 < r.y1)
        return np.select(
            [
                np.asarray(self.mu == 0),
                still & upright,
                still,
                np.asarray(self.steady),
                np.asarray(self.asymptotic),
                self.plane,
                np.asarray(self.through),
                np.abs(a1) <= ROUNDING * (np.abs(a2) + np.abs(self.b) * r.span),
                a1 * a2 < 0,
            ],
            REGIMES[:-1],
            REGIMES[-1],
        )

    # --- The state ---

    @property
    def course(self) -> Course:
        """How smooth the motion is: see `samples`."""
        rate, strip, half = abs(self.rate), theta.strip(self.modulus), self.modulus.half
        nearest = min(strip / 2, self.first.factor.distance, self.second.factor.distance)
        if self.first.through or self.second.through or not rate:
            return Course(rate, strip, rate, half=half)
        return Course(rate, strip, rate, nearest, half)

    def at(self, t: Real) -> TopState:
        """The state at times t (s), which broadcast against the orbit."""
        with np.errstate(all="ignore"):
            return self._at(Arrays, t)

    def sizes(self, times: Floats) -> Callable[[TopState], Sequence[tuple[str, Floats | float]]]:
        """To what the quantities of states are needed, at times of this size."""
        latest = float(max(abs(times[0]), abs(times[-1])))

        def needed(state: TopState) -> list[tuple[str, Floats | float]]:
            rounding = 1 + abs(self.rate) * latest  # that of z
            turning = np.abs(state.phi_dot)
            turned = turning + (abs(self.first.drift) + abs(self.second.drift))
            fastest = np.sqrt((state.theta_dot**2 + state.v_phi**2).max())
            speed = rounding * fastest
            return [
                ("cos_half", rounding * state.cos_half),
                ("sin_half", rounding * state.sin_half),
                ("theta_dot", speed),
                ("v_phi", speed),
                ("phi", 1 + latest * turned),
                ("psi", 1 + latest * (abs(self.start.omega3) + turned)),
                ("phi_dot", speed + rounding * turning),
            ]

        return needed

    def states(self, times: Floats) -> TopState:
        """The states at any number of times (N,) of one motion."""
        if len(times) <= BLOCK:
            return self.at(times)

        def columns(part: Floats) -> tuple[Floats, ...]:
            state = self.at(part)
            return tuple(getattr(state, name) for name in CHANGING)

        return self._state(dict(zip(CHANGING, in_blocks(columns, times), strict=True)))

    def _state(self, changing: dict[str, Floats]) -> TopState:
        s = self.start
        fixed = {"omega3": np.asarray(s.omega3), "upright_phi_dot": np.asarray(s.b / 2)}
        return TopState(**changing, **fixed)

    def _at(self, k: Kit, t: Real) -> TopState:
        z = self.z0 + self.rate * t
        if k.any(self.z0 == 0):
            z = k.where(t == 0, self.z0, z)  # its sign counts
        at = theta.place(k, self.modulus, z)
        own, other = self.first, self.second
        cubics = k.cubics([*own.cubics, *other.cubics, self.sines], at.x)
        square1, phase1 = _half(k, own, at, cubics[:3])
        square2, phase2 = _half(k, other, at, cubics[3:6])
        share = 1 / (square1 + square2)
        root1, root2, root = k.sqrt(square1), k.sqrt(square2), k.sqrt(share)
        turned1 = own.drift * t + own.sense * (phase1 - self.begin[0])
        turned2 = other.drift * t + other.sense * (phase2 - self.begin[1])
        up = k.where(self.swapped, turned1, turned2)
        down = k.where(self.swapped, turned2, turned1)
        sides = root1 * root, root2 * root
        cos_half = k.where(self.swapped, sides[1], sides[0])
        sin_half = k.where(self.swapped, sides[0], sides[1])
        slope = k.over(at.t, root1)
        if k.any(root1 == 0):  # in a pole at the origin, where it is that of its neighbours
            beside = cubics[0] * k.sqrt(own.scale * at.plus)
            slope = k.where(root1 > 0, slope, k.over(k.copysign(1.0, z), beside))
        end, left = self.modulus.end, at.left
        q2 = (end - left) * (end - left)
        speed = (
            left * (2 * end - left) * ((self.falls[2] * q2 + self.falls[1]) * q2 + self.falls[0])
        )
        theta_dot = k.where(
            self.moving, self.fall * slope * at.plus * speed * share * k.over(1.0, root2), 0.0 * z
        )
        sine = 2 * root1 * root2 * share

        def small() -> tuple[Real]:
            rise = at.t * cubics[6]
            return (self.momentum + self.momentum_rise * rise * rise * at.plus * share,)

        def wide() -> tuple[Real]:
            x, y = 2 * sin_half * sin_half, 2 * cos_half * cos_half
            above = k.where(x < y, self.c_up + self.b * x, self.c_down - self.b * y)
            return (self.sigma * above,)

        momentum = k.pick(self.wide, wide, small)[0]
        v_phi = k.over(momentum, sine)
        if k.any(sine == 0):
            v_phi = k.where(sine > 0, v_phi, 0.0)
        s = self.start
        return TopState(
            cos_half=cos_half,
            sin_half=sin_half,
            phi=s.phi + (up + down),
            psi=s.psi + s.omega3 * t + (down - up),
            theta_dot=theta_dot,
            v_phi=v_phi,
            omega3=s.omega3,
            upright_phi_dot=s.b / 2,
        )


def _half(k: Kit, half: Half, at: theta.Place, cubics: Sequence[Real]) -> tuple[Real, Real]:
    """The square of a spinor, but for the common denominator; and its phase."""
    f, g, winding = cubics

    def weighted() -> tuple[Real, ...]:
        across = at.t * f
        return at.t, across, half.scale * (across * across + g * g) * at.plus

    def alone() -> tuple[Real, ...]:
        t = at.t * at.plus
        across = t * f
        return t, across, half.scale * (across * across + g * g)

    t, across, square = k.pick(half.factor.weighted, weighted, alone)

    y, x = k.pick(half.factor.wound, lambda: (t * winding, g + at.t * across), lambda: (across, g))
    angle = k.atan2(y, x)

    def jumping() -> tuple[Real]:
        odd = at.turns != 2 * k.rint(at.turns / 2)
        if not half.at_origin:
            return (k.where(odd, math.pi, 0.0),)
        turned = k.where(at.t == 0, k.copysign(math.pi / 2, at.z), angle)
        return (k.where(odd, -turned, turned),)

    phase = k.pick(half.through, jumping, lambda: (angle + at.turns * half.factor.turn,))[0]
    return square, phase


def solve(start: Start) -> Orbit:
    """The orbits from starts, which are arrays that broadcast."""
    with np.errstate(all="ignore"):
        return _solve(Arrays, start)


@cache
def _written() -> Written:
    return written(
        len(fields(Start)), lambda k, s: _solve(k, Start(*s)), lambda k, orbit, t: orbit._at(k, t)
    )


def rows(solved: Solved, times: Floats) -> dict[str, Floats]:
    """What changes of the states at many times, and θ, φ̇ and ψ̇, compiled."""
    names = (*CHANGING, "theta", "phi_dot", "psi_dot")
    return dict(zip(names, compiled.rows(solved, _whole, times), strict=True))


def states(solved: Solved, times: Floats, compiled: bool) -> TopState:
    """The states at any number of times (N,), by NumPy or compiled."""
    orbit: Orbit = solved.orbit
    if not compiled:
        return orbit.states(times)
    found = rows(solved, times)
    return orbit._state({name: found[name] for name in CHANGING})


def _whole(k: Kit, orbit: Orbit, t: Real) -> tuple[Real, ...]:
    state = orbit._at(k, t)
    theta = 2 * k.atan2(state.sin_half, state.cos_half)
    return *(getattr(state, name) for name in CHANGING), theta, *rates(k, state)


def solved(start: Start) -> Solved:
    """One motion, whose start is floats; its state is a `TopState`."""
    return _written().solved(*vars(start).values())


def _solve(k: Kit, start: Start) -> Orbit:
    speed = k.hypot(start.v_theta, start.v_phi)
    sigma = k.sqrt(start.mu) + abs(start.b) + speed
    sigma = k.where(sigma > 0, sigma, 1.0)
    mu, b = start.mu / sigma / sigma, start.b / sigma
    v_theta, v_phi, w = start.v_theta / sigma, start.v_phi / sigma, speed / sigma
    sin_half, cos_half = (
        k.where(half > 0, k.larger(half, SMALLEST_TILT), 0.0)
        for half in (start.sin_half, start.cos_half)
    )
    x0, y0 = 2 * sin_half * sin_half, 2 * cos_half * cos_half
    s = 2 * sin_half * cos_half
    momentum = s * v_phi
    away_up = unless_rounding(k, v_phi, -k.over(b * s, y0))
    away_down = unless_rounding(k, v_phi, k.over(b * s, x0))
    c_up = k.where(x0 < 1, s * away_up, momentum - b * x0)
    c_down = k.where(x0 < 1, momentum + b * y0, s * away_down)
    # What rounding of the initial state cannot tell from the special cases.
    passes_up = abs(c_up) <= ROUNDING * (abs(momentum) + abs(b) * x0)
    passes_down = abs(c_down) <= ROUNDING * (abs(momentum) + abs(b) * y0)
    w_up = w * w - 2 * mu * x0  # speed² of the axis, were it upright
    arrives = k.both(
        k.both(passes_up, abs(w_up) <= ROUNDING * (w * w + 2 * mu * x0)), b * b < 4 * mu
    )
    r, pull, sizes, c_up, c_down = roots(
        k, mu, b, v_theta, v_phi, x0, y0, s, momentum, away_up, c_up, c_down
    )
    steady = k.both(abs(pull) <= ROUNDING * sizes, abs(v_theta) <= ROUNDING * w)
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
    about = k.larger(b * b - 4 * mu * k.copysign(1.0, y0 - x0), 0.0)
    nu = k.sqrt(k.where(still, about, m23)) / 2
    mod = modulus(k, m, m1)
    z0 = theta.angle(k, mod, ratio)
    backwards = (v_theta < 0) == swapped
    z0 = k.where(backwards, -z0, z0)
    sides = (
        (k.over(r.y2, r.span), k.over(m23, 2 * mu * r.y2)),
        (k.over(r.x1 * m23, r.span * r.m03), k.over(r.m03, 2 * mu * r.x1)),
    )
    near, far = (k.where(swapped, sides[1][j], sides[0][j]) for j in (0, 1))
    first = factor(k, mod, _root(k, near, 0.0), _root(k, far, math.inf), True, swapped)
    near, far = (k.where(swapped, sides[0][j], sides[1][j]) for j in (0, 1))
    second = factor(k, mod, _root(k, near, 0.0), _root(k, far, math.inf), False, swapped)
    a1 = k.where(r.x1 < NEAR_POLE * x0, c_up + b * r.x1, momentum + b * r.delta1)
    a2 = k.where(r.y2 < NEAR_POLE * y0, c_down - b * r.y2, momentum + b * r.delta2)
    # Of φ ± (ψ − ω₃t), at the turning point where the phase is slow; at rest, of its neighbours.
    rates = (
        k.where(r.y1 > 0, k.over(a1, r.y1), -b),
        k.where(r.x2 > 0, k.over(a2, r.x2), b),
    )
    rate = mod.rate * nu
    downs, ups = (c_down, r.y1, rates[0], r.y2 == 0), (c_up, r.x2, rates[1], r.x1 == 0)
    halves = []
    for part, at_origin in ((first, True), (second, False)):
        one, other = (ups, downs) if at_origin else (downs, ups)
        c, value, slow, passes = (k.where(swapped, *pair) for pair in zip(one, other, strict=True))
        sense = k.where(still, 0.0, k.where(c < 0, -1.0, 1.0))
        halves.append(
            Half(
                factor=part,
                scale=k.over(value, part.square) * k.where(part.weighted, 0.5, 1.0),
                sense=sense,
                through=k.where(still, False, passes),
                drift=sigma * (slow / 2 - sense * rate * part.slope),
                at_origin=at_origin,
            )
        )
    origin = k.where(swapped, mod.theta3, k.where(mod.circular, mod.theta4, mod.theta2))
    per_sine = origin / (mod.rate * cubic(mod.sines, mod.q))
    # 1 − m of this nome: of m₁ itself the logarithm, which time is measured by, is not as exact.
    two, three = mod.theta2 * mod.theta2, mod.theta3 * mod.theta3
    rest = k.where(mod.circular, m1, 16 * mod.q * (two * two) / (three * three))
    depth = k.where(swapped, r.span * rest, r.span)
    falls, first_fall = _falls(mod)
    origin2 = origin * origin
    fall = 2 * nu * depth * sigma * (origin2 * origin2) / (first_fall * mod.rate)
    at = theta.place(k, mod, z0)
    return Orbit(
        start=start,
        sigma=sigma,
        mu=mu,
        b=b,
        c_up=c_up,
        c_down=c_down,
        roots=r,
        a1=a1,
        a2=a2,
        nu=nu,
        m1=m1,
        modulus=mod,
        swapped=swapped,
        z0=z0,
        rate=rate * sigma,
        first=halves[0],
        second=halves[1],
        moving=r.span > 0,
        wide=k.either(r.x1 < NEAR_POLE * r.x2, r.y2 < NEAR_POLE * r.y1),
        sines=along(k, mod, tuple(per_sine * c for c in mod.sines)),
        fall=k.where(swapped, fall, -fall),
        falls=falls,
        momentum=sigma * k.where(swapped, a1, a2),
        momentum_rise=sigma * b * k.where(swapped, depth, -depth),
        begin=(
            _half(k, halves[0], at, k.cubics(halves[0].cubics, at.x))[1],
            _half(k, halves[1], at, k.cubics(halves[1].cubics, at.x))[1],
        ),
        still=still,
        steady=steady,
        asymptotic=k.where(k.either(still, steady), False, arrives),
        # With p_φ = p_ψ alone it may lack the energy to climb there.
        through=k.where(
            k.either(still, steady), False, k.either(k.both(passes_up, w_up > 0), passes_down)
        ),
    )


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
