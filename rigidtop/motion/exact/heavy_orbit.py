"""The orbit of a heavy symmetric top, solved by `heavy`: turning points, periods, regime, states.

`HeavyStart` and `HeavyOrbit` are floats of one motion, else arrays that broadcast.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact import theta
from rigidtop.motion.exact.numbers import ROUNDING, Arrays, Kit, Real, Truth
from rigidtop.motion.exact.roots import Roots
from rigidtop.motion.exact.samples import BLOCK, Smoothness, in_blocks
from rigidtop.motion.exact.theta import Cubic, Factor, Modulus
from rigidtop.motion.state import CHANGING, TopState

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
"""What an axis can do: see `HeavyOrbit.regime`, which takes the first that holds."""


@dataclass(frozen=True)
class HeavyStart:
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
class HeavyOrbit:
    """The motion from a start, made by `solve`."""

    start: HeavyStart
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
    def smoothness(self) -> Smoothness:
        """How smooth the motion is: see `samples`."""
        rate, strip, half = abs(self.rate), theta.strip(self.modulus), self.modulus.half
        nearest = min(strip / 2, self.first.factor.distance, self.second.factor.distance)
        if self.first.through or self.second.through or not rate:
            return Smoothness(rate, strip, rate, half=half)
        return Smoothness(rate, strip, rate, nearest, half)

    def at(self, t: Real) -> TopState:
        """The state at times t (s), which broadcast against the orbit."""
        with np.errstate(all="ignore"):
            return self.evaluated(Arrays, t)

    def sizes(self, times: Floats) -> Callable[[TopState], Sequence[tuple[str, Floats | float]]]:
        """The sizes to which the quantities of states are needed, at times of this size."""
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

        return self.state(dict(zip(CHANGING, in_blocks(columns, times), strict=True)))

    def state(self, changing: dict[str, Floats]) -> TopState:
        s = self.start
        fixed = {"omega3": np.asarray(s.omega3), "upright_phi_dot": np.asarray(s.b / 2)}
        return TopState(**changing, **fixed)

    def evaluated(self, k: Kit, t: Real) -> TopState:
        z = self.z0 + self.rate * t
        if k.any(self.z0 == 0):
            z = k.where(t == 0, self.z0, z)  # its sign counts
        at = theta.place(k, self.modulus, z)
        own, other = self.first, self.second
        cubics = k.cubics([*own.cubics, *other.cubics, self.sines], at.x)
        square1, phase1 = spinor(k, own, at, cubics[:3])
        square2, phase2 = spinor(k, other, at, cubics[3:6])
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


def spinor(k: Kit, half: Half, at: theta.PeriodPlace, cubics: Sequence[Real]) -> tuple[Real, Real]:
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
