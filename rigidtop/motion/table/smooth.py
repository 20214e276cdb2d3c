"""A top on a smooth plane in closed form: one quadrature over the nutation, as Fourier series.

Shares no code with the equations of motion.  The plane pushes upwards only, so the horizontal
velocity of the centre of mass is constant, and the torque about it, of a vertical force at a point
below a point of the axis, has no component along ẑ or e₃: L_z and L₃ = λ₃ω₃ are constant, with the
moments about the centre of mass.  The centre of mass is at the height r + h cos θ, h = R − r.  With
u = cos θ, a = L_z/λ₁, b = λ₃ω₃/λ₁, β = 2Mgh/λ₁ and κ = Mh²/λ₁ the energy is

    (1 + κ(1 − u²)) u̇² = P(u) = (1 − u²)(α − βu) − (a − bu)²

which is the cubic of a held top with the moment λ₁; κ makes it hyperelliptic.  Between its roots
P = (u − u₁)(u₂ − u) G(u) with the linear G = α + b² − β(u₁ + u₂) − βu > 0, and with
u = mean + amplitude cos χ everything is smooth and even in χ:

    dt/dχ = √((1 + κ(1 − u²))/G),    φ̇ = (a − bu)/(1 − u²),    ψ̇ = ω₃ − uφ̇

A cosine series of these integrates to a straight line and a sine series; t(χ) is inverted by
Newton's method.  1 − u = 1 − u₂ + 2 amplitude sin²(χ/2) and a − bu = a − b + b(1 − u) keep their
digits near the upright.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from rigidtop.errors import RigidtopError

Floats = NDArray[np.float64]

MOST_NODES = 1 << 13
"""Series that need more than these do not end soon: a separatrix or a pole is too near."""

CONVERGED = 2e-15
"""So small, of the largest, the last third of the coefficients must be."""

BLOCK = 1024
"""Times of which the harmonics are in memory together."""

ROUNDING = 16 * float(np.finfo(float).eps)
"""What rounding of the start does to a − b."""

POLE = 1e-13
"""1 − |u| below this is the vertical."""


@dataclass(frozen=True)
class NutationState:
    """States at N times, arrays (N,); φ and ψ count from those at t = 0 (rad, rad/s)."""

    theta: Floats
    theta_dot: Floats
    v_phi: Floats  # φ̇ sin θ
    phi: Floats
    psi: Floats


@dataclass(frozen=True)
class SineSeries:
    """slope χ + Σ sines[k − 1] sin kχ."""

    slope: float
    sines: Floats

    def at(self, chi: Floats) -> Floats:
        harmonics = np.arange(1, len(self.sines) + 1)
        values = self.slope * chi
        for first in range(0, len(chi), BLOCK):
            part = slice(first, first + BLOCK)
            values[part] += np.sin(np.multiply.outer(chi[part], harmonics)) @ self.sines
        return values


@dataclass(frozen=True)
class Nutation:
    """A nutation between θ₁ and θ₂."""

    a_less_b: float
    b: float
    beta: float
    kappa: float
    omega3: float
    weight: float  # Mg
    lever: float  # Mh
    stiffness: float  # G's value at u = 0

    from_upright: float
    """1 − u₂."""

    through: bool
    """Whether the axis passes through the vertical, to rounding of the start: then a = b."""

    from_hanging: float
    """1 + u₁."""

    amplitude: float
    chi_0: float  # at t = 0

    time: SineSeries
    phi: SineSeries
    psi: SineSeries  # of ∫ uφ̇ dt

    @property
    def turning_points(self) -> tuple[float, float]:
        """The smallest and the largest θ (rad)."""
        upright, hanging = self.away(np.array([0.0, np.pi]))
        smallest, largest = 2 * np.arctan2(np.sqrt(upright), np.sqrt(hanging))
        return float(smallest), float(largest)

    def away(self, chi: Floats) -> tuple[Floats, Floats]:
        """The distances 1 − u and 1 + u of u = cos θ from both ends, at χ (N,)."""
        half = chi / 2
        upright = self.from_upright + 2 * self.amplitude * np.sin(half) ** 2
        hanging = self.from_hanging + 2 * self.amplitude * np.cos(half) ** 2
        return upright, hanging

    def slope(self, upright: Floats, hanging: Floats) -> Floats:
        """dt/dχ where 1 − u and 1 + u are those (s)."""
        u = (hanging - upright) / 2
        return np.sqrt((1 + self.kappa * upright * hanging) / (self.stiffness - self.beta * u))

    def azimuthal(self, upright: Floats, hanging: Floats) -> Floats:
        """φ̇ there (rad/s); of a sleeping top that of its neighbours."""
        if self.amplitude == self.from_upright == 0:
            return np.full_like(upright, self.b / 2)
        if self.through:
            return self.b / hanging
        return (self.a_less_b + self.b * upright) / (upright * hanging)

    @property
    def nutation_period(self) -> float:
        """The time from one smallest θ to the next, or of a small nutation if θ is constant (s)."""
        return 2 * np.pi * self.time.slope

    @property
    def smallest_normal_force(self) -> float:
        """The least N in a period (N)."""
        return float(self.normal_force(np.linspace(0, np.pi, 2001)).min())

    def normal_force(self, chi: Floats) -> Floats:
        """N = Mg + Mh ü, with ü from u̇² = P/(1 + κ(1 − u²)) (N)."""
        upright, hanging = self.away(chi)
        u = (hanging - upright) / 2
        inertia, linear = 1 + self.kappa * upright * hanging, self.stiffness - self.beta * u
        width = self.amplitude**2 * np.sin(chi) ** 2  # (u − u₁)(u₂ − u)
        slope = -2 * self.amplitude * np.cos(chi) * linear - self.beta * width  # dP/du
        acceleration = (slope + 2 * self.kappa * u * width * linear / inertia) / (2 * inertia)
        return self.weight + self.lever * acceleration

    def at(self, times: Floats) -> NutationState:
        """The state at `times` (N,) in s."""
        first = np.array([self.chi_0])
        since = times + self.time.at(first)[0]
        turns = np.rint(since / self.nutation_period)
        chi = self._inverted(since - turns * self.nutation_period)
        chi = np.where(times == 0, self.chi_0, chi)  # its sign counts
        upright, hanging = self.away(chi)
        sine = np.sqrt(upright * hanging)
        whole = 2 * np.pi * turns

        def counted(line: SineSeries) -> Floats:
            angle: Floats = line.slope * whole + line.at(chi) - line.at(first)
            return angle

        safe = np.where(sine > 0, sine, 1.0)
        slope = self.slope(upright, hanging)
        falling = self.amplitude * np.sin(chi) / slope
        at_pole = np.copysign(np.sqrt(2 * self.amplitude / np.maximum(hanging, 1.0)), chi) / slope
        half_turn = np.zeros(len(times))
        if self.through:  # e₃ comes out on the other side, to and fro
            side = np.where(turns % 2 == 0, 0.5, -0.5) * np.copysign(np.pi, chi)
            half_turn = side - math.copysign(np.pi / 2, self.chi_0)
        return NutationState(
            theta=2 * np.arctan2(np.sqrt(upright), np.sqrt(hanging)),
            theta_dot=np.where(sine > 0, falling / safe, at_pole),
            v_phi=np.where(sine > 0, (self.a_less_b + self.b * upright) / safe, 0.0),
            phi=counted(self.phi) + half_turn,
            psi=self.omega3 * times - counted(self.psi) - half_turn,
        )

    def _inverted(self, times: Floats) -> Floats:
        """χ of times in half a period around 0."""
        low, high = np.full(len(times), -np.pi - 1e-9), np.full(len(times), np.pi + 1e-9)
        chi = times / self.time.slope
        for _ in range(60):
            missing = self.time.at(chi) - times
            low, high = np.where(missing < 0, chi, low), np.where(missing > 0, chi, high)
            new = chi - missing / self.slope(*self.away(chi))
            new = np.where((new < low) | (new > high), (low + high) / 2, new)
            change = float(np.max(np.abs(new - chi)))
            chi = new
            if change < 1e-15 * np.pi:
                break
        return chi


def solve(
    *,
    lambda1: float,
    lambda3: float,
    M: float,
    g: float,
    h: float,
    theta: float,
    theta_dot: float,
    v_phi: float,
    omega3: float,
) -> Nutation:
    """The nutation from θ, θ̇, φ̇ sin θ and ω₃ at t = 0 (rad, rad/s); moments about the centre.

    Raises RigidtopError where it comes too near to the vertical without going through it, and where
    the series are too long.
    """
    sine, u0 = math.sin(theta), math.cos(theta)
    upright, hanging = 2 * math.sin(theta / 2) ** 2, 2 * math.cos(theta / 2) ** 2
    b, beta, kappa = lambda3 * omega3 / lambda1, 2 * M * g * h / lambda1, M * h**2 / lambda1
    # In w = u − u₀ nothing cancels at a turning point or in steady precession:
    # P = p₀ + p₁w + p₂w² + βw³.
    free = (1 + kappa * sine**2) * theta_dot**2 + v_phi**2  # α − βu₀
    p0 = (1 + kappa * sine**2) * (sine * theta_dot) ** 2
    p1 = -2 * u0 * free - beta * sine**2 + 2 * b * sine * v_phi
    p2 = -free - b**2 + 2 * beta * u0
    low, high = _interval((p0, p1, p2, beta), -hanging, upright)
    amplitude = (high - low) / 2
    stiffness = free + b**2 - beta * (u0 + low + high)  # α + b² − β(u₁ + u₂)
    sleeping = amplitude == upright == 0
    a_less_b = sine * v_phi - b * upright
    rounding = ROUNDING * (abs(sine * v_phi) + abs(b) * upright)
    through = upright - high < POLE and abs(a_less_b) <= rounding and not sleeping
    if through:
        a_less_b, high, amplitude = 0.0, upright, (upright - low) / 2
    if min(math.inf if through else upright - high, hanging + low) < POLE and not sleeping:
        raise RigidtopError(
            "no closed form: the axis comes too near to the vertical; integrate the motion"
        )
    if not stiffness - beta * (u0 + (high if beta > 0 else low)) > 0:
        raise RigidtopError(
            "no closed form: the motion has no period, or a top sleeps that would wake; "
            "integrate the motion"
        )
    # tan²(χ/2) = (u₂ − u₀)/(u₀ − u₁), and u falls for χ in (0, π).
    half = math.atan2(math.sqrt(high), math.sqrt(-low)) if amplitude > 0 else 0.0
    nothing = SineSeries(1.0, np.zeros(0))
    orbit = Nutation(
        a_less_b=a_less_b,
        b=b,
        beta=beta,
        kappa=kappa,
        omega3=omega3,
        weight=M * g,
        lever=M * h,
        stiffness=stiffness,
        from_upright=upright - high,
        through=through,
        from_hanging=hanging + low,
        amplitude=amplitude,
        chi_0=math.copysign(2 * half, theta_dot),
        time=nothing,
        phi=nothing,
        psi=nothing,
    )

    def integrands(chi: Floats) -> Floats:
        above, below = orbit.away(chi)
        slope = orbit.slope(above, below)
        turning = orbit.azimuthal(above, below) * slope
        return np.stack([slope, turning, (below - above) / 2 * turning])

    time, phi, psi = _lines(integrands)
    return replace(orbit, time=time, phi=phi, psi=psi)


def _interval(
    cubic: tuple[float, float, float, float], least: float, most: float
) -> tuple[float, float]:
    """The roots w₁ ≤ 0 ≤ w₂ of p₀ + p₁w + p₂w² + p₃w³ next to 0, between which it is positive.

    It is not positive at `least` and `most`, the vertical; beyond one of these is the third root.
    """
    p0, p1, p2, p3 = cubic

    def value(w: float) -> float:
        return p0 + w * (p1 + w * (p2 + w * p3))

    if p0 > 0:
        lower, upper = (
            end if value(end) >= 0 else float(brentq(value, 0.0, end, xtol=1e-300, maxiter=1000))
            for end in (least, most)
        )
        return lower, upper
    if p1 == 0:
        return 0.0, 0.0
    # 0 is a root; the others are those of a quadratic, without cancellation.
    q = -(p2 + math.copysign(math.sqrt(max(p2**2 - 4 * p1 * p3, 0.0)), p2)) / 2
    roots = ([p1 / q] if q else []) + ([q / p3] if p3 else [])
    other = min((w for w in roots if w * p1 > 0), key=abs, default=0.0)
    return min(other, 0.0), max(other, 0.0)


def _lines(integrands: Callable[[Floats], Floats]) -> tuple[SineSeries, SineSeries, SineSeries]:
    """The integrals over χ of three smooth even functions of period 2π."""
    nodes = 32
    while nodes <= MOST_NODES:
        values = integrands(2 * np.pi * np.arange(nodes) / nodes)
        cosines = np.fft.rfft(values).real / nodes
        scale = np.abs(values).max(axis=1) + 1e-300
        tail = np.abs(cosines[:, nodes // 3 :]).max(axis=1) / scale
        if np.all(tail < CONVERGED):
            break
        nodes *= 2
    else:
        raise RigidtopError(
            "no closed form: the motion comes too near to the vertical or to one without period; "
            "integrate it"
        )
    size = np.abs(cosines).max(axis=0) / scale.max()
    last = int(np.flatnonzero(np.append(size[: nodes // 3], 0.0) > 1e-17)[-1]) + 1
    harmonics = np.arange(1, last)
    lines = [SineSeries(float(row[0]), 2 * row[1:last] / harmonics) for row in cosines]
    return lines[0], lines[1], lines[2]
