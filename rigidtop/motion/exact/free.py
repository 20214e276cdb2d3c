"""The free body, solved: ω by Jacobi's functions, the attitude by one integral of the third kind.

The moments are renamed I₁, I₂, I₃ so that I₂ lies between the others and ω circles about e₃ (short
axis: I₃ is the largest, long axis: the smallest); signs are chosen so that L₁, L₃ ≥ 0 at t = 0.
With differences I_jk = |I_j − I_k| (Landau & Lifshitz, Mechanics §37; Whittaker §69),

    L₁ = a₁ cn τ,  L₂ = a₂ sn τ,  L₃ = a₃ dn τ,    τ = τ₀ ± νt,
    a₁² = I₁B/I₁₃,  a₂² = I₂B/I₂₃,  a₃² = I₃A/I₁₃,  ν² = I₂₃A/(I₁I₂I₃),
    m = I₁₂B/(I₂₃A),  m₁ = I₁₃D/(I₂₃A),
    A = |L² − 2TI₁|,  B = |L² − 2TI₃|,  D = |L² − 2TI₂|,

where A, B are sums of squares of ω and D, which vanishes on the separatrix, is a difference of two
that factors.  In the frame whose ẑ is L/L, with Euler angles z–y′–z″, θ and ψ follow from L in the
body, and

    φ̇ = L/I₂ + L(1/I₁ − 1/I₂) cn²/(cn² + κ sn²),    κ = I₂I₁₃/(I₁I₂₃) = 1 + I₃I₁₂/(I₁I₂₃).

The integral is Π of a negative characteristic; transformed to one between m and 1 (Abramowitz &
Stegun 17.7.15) it has only positive terms, and the jumps of φ become an arc tangent.

All quantities are arrays that broadcast; those of `Orbit` are in units of σ = |ω| at t = 0 and of
the largest moment.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

from rigidtop.motion import attitude
from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact.elliptic import (
    SMALLEST_PART,
    Jacobi,
    first_kind,
    jacobi,
    quarter_period,
)

ROUNDING = 16 * float(np.finfo(float).eps)
"""What rounding of the initial state does to the distance from the separatrix."""


@dataclass(frozen=True)
class Orbit:
    """The motion from ω at t = 0, made by `solve`; shape S is that of the motions."""

    omega: Floats
    """ω at t = 0 in the body's own components (S, 3), rad/s."""

    sigma: Floats
    """The unit of rates (1/s)."""

    axes: NDArray[np.intp]
    """(S, 3): which of the body's axes are e₁, e₂, e₃ here."""

    signs: Floats
    """(S, 3): and in which direction."""

    moments: Floats
    """I₁, I₂, I₃ (S, 3)."""

    amplitudes: Floats
    """a₁, a₂, a₃ (S, 3)."""

    tilt: Floats
    """The angle between L and e₃ at t = 0 (rad)."""
    length: Floats
    """|L|."""

    kappa: Floats
    n: Floats
    """κ − 1."""
    m: Floats
    m1: Floats
    nu: Floats
    """dτ/dt, negative about the long axis."""
    tau0: Floats
    uniform: NDArray[np.bool_]
    """Whether ω is constant."""
    on_separatrix: NDArray[np.bool_]
    """To rounding of the initial state."""

    # --- Periods ---

    @cached_property
    def quarter(self) -> Floats:
        """K, a quarter of the period of ω in τ."""
        return quarter_period(self.m1)

    @property
    def turning_points(self) -> tuple[Floats, Floats]:
        """The smallest and the largest angle between L and e₃ (rad)."""
        a1, a2, a3 = np.moveaxis(self.amplitudes, -1, 0)
        smallest = np.arctan2(a1, a3)
        largest = np.arctan2(a2, a3 * np.sqrt(self.m1))
        return (
            np.where(self.uniform, self.tilt, smallest),
            np.where(self.uniform, self.tilt, largest),
        )

    @property
    def nutation_period(self) -> Floats:
        """The time from one smallest value of that angle to the next (s); ω returns after two."""
        with np.errstate(all="ignore"):
            return np.where(self._ends, np.inf, 2 * self.quarter / (np.abs(self.nu) * self.sigma))

    @property
    def precession_per_period(self) -> Floats:
        """By how much e₃ turns about L in it (rad)."""
        with np.errstate(all="ignore"):
            mean = self.mean_precession
            return np.where(mean == 0, 0.0, mean * self.nutation_period)

    @property
    def mean_precession(self) -> Floats:
        """The rate at which e₃ turns about L, on average (rad/s)."""
        with np.errstate(all="ignore"):
            share = np.where((self.m1 > 0) & ~self._ends, self._complete / (2 * self.quarter), 0.0)
            rate = self.length * (1 / self._i(1) + (1 / self._i(0) - 1 / self._i(1)) * share)
        return rate * self.sigma

    @property
    def _ends(self) -> NDArray[np.bool_]:
        """Whether it never comes back from the middle axis, as the regime has it."""
        return self.on_separatrix & ~self.uniform & (self.m > 0)

    def _i(self, k: int) -> Floats:
        return self.moments[..., k]

    @cached_property
    def regime(self) -> NDArray[np.str_]:
        """How ω moves in the body, to rounding of the initial state.

        "steady" (not at all), "regular precession" (two equal moments), "separatrix", and about
        the "short axis" or the "long axis".
        """
        return np.select(
            [self.uniform, self.m == 0, self.on_separatrix, self.nu > 0],
            ["steady", "regular precession", "separatrix", "short axis"],
            "long axis",
        )

    # --- The integral ---

    def _third_kind(self, f: Jacobi) -> Floats:
        """∫ cn²/(cn² + κ sn²) dτ from 0 to |τ| ≤ K."""
        part = self.m1 / self.kappa
        p = f.cn**2 + part * f.sn**2
        tail = np.where(part > 0, f.third_kind(np.where(p > 0, p, 1.0)), 0.0)
        q = np.sqrt(self.n * (self.m + self.n) / self.kappa)
        z = f.sn * f.cn / f.dn
        arc = np.where(q > 0, np.arctan(q * z) / np.where(q > 0, q, 1.0), z)
        return part * tail + arc

    @cached_property
    def _complete(self) -> Floats:
        """The same over 2K."""
        zero = np.zeros_like(self.m1)
        at_k = Jacobi(zero + 1, zero, np.sqrt(np.where(self.m1 > 0, self.m1, 1.0)))
        return np.where(self.m1 > 0, 2 * self._third_kind(at_k), 0.0)

    # --- The state ---

    def at(self, t: ArrayLike) -> tuple[Floats, Floats]:
        """At times t (s), of a shape that broadcasts against S.

        Returns unit quaternions (…, 4), scalar first, that take body components at t to body
        components at t = 0, and ω (…, 3) in body components at t (rad/s).
        """
        t = np.asarray(t, dtype=float)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
            scaled = t * self.sigma
            start = self._state(np.zeros_like(self.sigma))
            now = self._state(scaled)
            turned = attitude.product(attitude.conjugate(start[0]), now[0])
            half = np.linalg.norm(self.omega, axis=-1) * t / 2
            unit = self.omega / self.sigma[..., None]
            steady = np.concatenate([np.cos(half)[..., None], np.sin(half)[..., None] * unit], -1)
        uniform = self.uniform[..., None]
        quaternion = np.where(uniform, steady, turned)
        return quaternion, np.where(uniform, self.omega, now[1])

    def _state(self, scaled: Floats) -> tuple[Floats, Floats]:
        """Quaternions from body components to the frame of L, and ω in body components."""
        tau = self.tau0 + self.nu * scaled
        bounded = np.isfinite(self.quarter)
        half = np.where(bounded, 2 * self.quarter, 1.0)
        turns, first = (np.where(bounded, np.round(x / half), 0.0) for x in (tau, self.tau0))
        f = jacobi(tau - turns * half, self.m1)
        begin = self._third_kind(jacobi(self.tau0 - first * half, self.m1))
        integral = (turns - first) * self._complete + self._third_kind(f) - begin
        sign = 1 - 2 * np.mod(turns, 2)
        cn, sn = sign * f.cn, sign * f.sn
        i1, i2 = self._i(0), self._i(1)
        phi = self.length * (scaled / i2 + (1 / i1 - 1 / i2) * integral / self.nu)
        psi = np.arctan2(np.sqrt(self.kappa) * sn, -cn)
        a1, a2, a3 = np.moveaxis(self.amplitudes, -1, 0)
        momentum = np.stack([a1 * cn, a2 * sn, a3 * f.dn], axis=-1)
        theta = np.arctan2(np.hypot(momentum[..., 0], momentum[..., 1]), momentum[..., 2])
        renamed = attitude.from_spinors(np.cos(theta / 2), np.sin(theta / 2), phi, psi)
        rates = np.empty_like(momentum)
        axes = np.broadcast_to(self.axes, momentum.shape)
        np.put_along_axis(rates, axes, self.signs * momentum / self.moments, axis=-1)
        return attitude.product(renamed, self._renaming), rates * self.sigma[..., None]

    @cached_property
    def _renaming(self) -> Floats:
        """Quaternions (S, 4) from the body's own axes to e₁, e₂, e₃."""
        matrices = self.signs[..., None] * (self.axes[..., None] == np.arange(3))
        flat = Rotation.from_matrix(matrices.reshape(-1, 3, 3))
        return attitude.quaternions(flat).reshape(*self.axes.shape[:-1], 4)


def solve(moments: Floats, omega: Floats) -> Orbit:
    """The orbit from moments (…, 3) and ω (…, 3) in body components, which broadcast."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
        return _solve(*np.broadcast_arrays(moments, omega))


def _solve(moments: Floats, omega: Floats) -> Orbit:
    largest = np.abs(omega).max(axis=-1)
    unit = np.where(largest > 0, largest, 1.0)  # no square of it overflows
    sigma = largest * np.linalg.norm(omega / unit[..., None], axis=-1)
    sigma = np.where(sigma > 0, sigma, 1.0)
    order = np.argsort(moments, axis=-1, kind="stable")
    i, w = (
        np.moveaxis(np.take_along_axis(values, order, -1), -1, 0)
        for values in (
            moments / moments.max(axis=-1, keepdims=True),
            np.abs(omega) / sigma[..., None],
        )
    )
    short = np.sqrt(i[2] * (i[2] - i[1])) * w[2]
    long = np.sqrt(i[0] * (i[1] - i[0])) * w[0]
    d = np.abs(short - long) * (short + long)
    about_short = (short >= long)[..., None]
    axes = np.where(about_short, order, order[..., ::-1])
    direction = np.where(about_short[..., 0], 1.0, -1.0)
    i1, i2, i3 = (np.where(about_short[..., 0], i[k], i[2 - k]) for k in range(3))
    w1, w2, w3 = (np.where(about_short[..., 0], w[k], w[2 - k]) for k in range(3))
    i12, i23, i13 = np.abs(i1 - i2), np.abs(i2 - i3), np.abs(i1 - i3)
    a = i2 * i12 * w2**2 + i3 * i13 * w3**2
    b = i1 * i13 * w1**2 + i2 * i23 * w2**2
    nu = np.sqrt(i23 * a / (i1 * i2 * i3))
    # Where ω cannot circle (I₂ = I₃ about that axis, or three equal moments) any numbers do.
    idle = ~(nu > 0)
    i12, i23, i13 = (np.where(idle, x, part) for x, part in ((0.0, i12), (1.0, i23), (1.0, i13)))
    a, b, d = (np.where(idle, x, part) for x, part in ((1.0, a), (0.0, b), (1.0, d)))
    amplitudes = np.stack(
        [np.sqrt(i1 * b / i13), np.sqrt(i2 * b / i23), np.sqrt(i3 * a / i13)], axis=-1
    )
    m, m1 = i12 * b / (i23 * a), i13 * d / (i23 * a)
    m1 = np.where(m1 < SMALLEST_PART, 0.0, m1)
    n = i3 * i12 / (i1 * i23)
    still = b == 0
    cn = np.where(still, 1.0, i1 * w1 / np.where(still, 1.0, amplitudes[..., 0]))
    sn = np.where(still, 0.0, i2 * w2 / np.where(still, 1.0, amplitudes[..., 1]))
    tau0 = first_kind(sn, cn, np.sqrt(m1 + m * cn**2))
    # Constant ω: also about a principal axis, be it the middle one, which L never leaves.
    uniform = idle | ((w1 == 0) & (w2 == 0)) | ~np.isfinite(tau0)
    tau0 = np.where(uniform, 0.0, tau0)
    # e₁ and e₃ point to where L₁, L₃ ≥ 0; e₂ so that the axes are right-handed.
    ordered = np.take_along_axis(omega, axes, -1)
    signs = np.where(ordered < 0, -1.0, 1.0)
    even = np.mod(axes[..., 1] - axes[..., 0], 3) == 1
    second = signs[..., 0] * signs[..., 2] * np.where(even, 1.0, -1.0)
    tau0 = np.where(second * signs[..., 1] < 0, -tau0, tau0)
    signs = np.stack([signs[..., 0], second, signs[..., 2]], axis=-1)
    renamed = np.stack([i1, i2, i3], axis=-1)
    momentum = renamed * np.stack([w1, w2, w3], axis=-1)
    return Orbit(
        omega=np.asarray(omega, dtype=float),
        sigma=sigma,
        axes=axes,
        signs=signs,
        moments=renamed,
        amplitudes=amplitudes,
        tilt=np.arctan2(np.hypot(momentum[..., 0], momentum[..., 1]), momentum[..., 2]),
        length=np.linalg.norm(momentum, axis=-1),
        kappa=1 + n,
        n=n,
        m=m,
        m1=m1,
        nu=direction * nu,
        tau0=tau0,
        uniform=uniform,
        on_separatrix=np.abs(short - long) <= ROUNDING * (short + long),
    )
