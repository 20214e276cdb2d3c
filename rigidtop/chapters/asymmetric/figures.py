"""Poincaré's section with Kovalevskaya's integral and without, and two neighbours that part."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film, film
from rigidtop.figures.space import View
from rigidtop.figures.style import Floats
from rigidtop.parameters import Parameter

from .top import Moments, across, angle_rates, parameters, system

MOMENT = Parameter("lambda1", 1.7, r"$\lambda_1$ by $\lambda_3$", least=1.0, most=3.0)

LEVEL = math.pi / 2
"""θ where e₃ is level."""

KOVALEVSKAYA: Moments = (2.0, 2.0, 1.0)


def other(lambda1: float) -> Moments:
    """The top beside Kovalevskaya's, of which one moment is another."""
    return lambda1, 2.0, 1.0


# --- The section ---------------------------------------------------------------------------------

ENERGY = Parameter("energy", 0.5, "$E$ by $MgR$", least=-0.9, most=3.0)
ROWS, STEP = 8001, 0.05
CURVES = 8
"""Motions that start on each of the two lines through the middle."""


def starts(moments: Moments, energy: float) -> tuple[Floats, tuple[Floats, Floats, Floats]]:
    """χ and (ω₁, ω₂, ω₃) at places on the lines ω₃ = 0 and χ = 0, with MgR = 1 and L_z = 0."""
    shares = (2 * np.arange(CURVES) + 1) / CURVES - 1
    chi = np.append(math.acos(max(-energy, -1.0)) * shares, 0 * shares)
    rate = np.append(0 * shares, math.sqrt(2 * (energy + 1) / moments[2]) * shares)
    return chi, (*across(moments, energy, chi, rate), rate)


@lru_cache(maxsize=16)
def points(moments: Moments, energy: float) -> tuple[tuple[Floats, Floats], ...]:
    """χ and ω₃ of the points of each motion, after its start."""
    chi, omega = starts(moments, energy)
    rates = angle_rates(LEVEL, chi, omega)
    motions = system().motions(parameters(moments, 1.0), [0.0, LEVEL, chi], rates)
    t = np.linspace(0.0, STEP * (ROWS - 1), ROWS)
    q, qdot = motions.integrate(t, rtol=1e-9, atol=1e-11)
    return tuple(level(t, q[k], qdot[k]) for k in range(len(chi)))


def level(t: Floats, q: Floats, qdot: Floats) -> tuple[Floats, Floats]:
    """χ and ω₃ where e₃ is level, whichever way it passes: the two are mirrored."""
    theta, psi = (CubicHermiteSpline(t, q[:, k], qdot[:, k]) for k in (1, 2))
    height = q[1:, 1] - LEVEL
    at = t[1:-1][height[:-1] * height[1:] < 0] + STEP / 2
    for _ in range(6):
        at -= (theta(at) - LEVEL) / theta(at, 1)
    return (psi(at) + math.pi) % (2 * math.pi) - math.pi, psi(at, 1)


def draw_section(axes: Axes, moments: Moments, energy: float) -> None:
    """The points of all motions, those of one of them in another colour, and the edge."""
    found = points(moments, energy)
    one = CURVES // 2 - 1
    most = math.sqrt(2 * (energy + 1) / moments[2])
    chi = np.linspace(-1, 1, 361) * math.acos(max(-energy, -1.0))
    edge = np.sqrt(np.maximum(2 * (energy + np.cos(chi)) / moments[2], 0.0))
    parts: list[pen.Part] = [pen.guide((chi, sign * edge)) for sign in (1.0, -1.0)]
    for k, each in enumerate(found):
        color, size, z = (look.SECOND, 1.6, 3) if k == one else (look.FIRST, 0.9, 2)
        parts.append(pen.Markers(each, color, size, z=z, width=0.0))
    pen.draw(axes, parts)
    axes.set(xlabel=r"$\chi$  (rad)", ylim=(-1.08 * most, 1.08 * most))


def _section(with_it: Axes, without: Axes, lambda1: float, energy: float) -> None:
    draw_section(with_it, KOVALEVSKAYA, energy)
    draw_section(without, other(lambda1), energy)
    with_it.set(ylabel=r"$\omega_3$  by  $\nu_3$")


SECTION = Drawing(
    "section",
    "Where the third axis is level",
    "4",
    (MOMENT, ENERGY),
    pen.panels(look.TEXT, 2.8, _section, 1, 2, sharex=True, sharey=True),
    r"The points of sixteen motions with $E/MgR = {energy}$ and $L_z = 0$, those of one of them in "
    r"another colour; thin: the edge. Left $\lambda_1 = \lambda_2 = 2\lambda_3$; right "
    r"$\lambda_1 = {lambda1}\,\lambda_3$, and the other two as before.",
    "Two charts of the rate omega 3 over the angle chi, at the energy {energy}. On the left the "
    "points of each motion lie on smooth closed curves. On the right, where the first moment is "
    "{lambda1} times the third, a few curves surround islands, and scattered points fill the rest.",
)

# --- The neighbours ------------------------------------------------------------------------------

CHI = Parameter("chi", 0.7, r"$\chi$ at the start", "rad", least=-1.8, most=1.8)
APART, SHOWN = 1e-7, 150.0
NEAR = 0.03
"""Up to here a distance grows in proportion."""

VIEW = View(azimuth=0.6, elevation=0.2)


class NeighbouringTops(NamedTuple):
    """Two tops beside each other at N times."""

    t: Floats
    """In 1/ν₃."""
    tips: Floats
    """The axes e₁ in space (2, N, 3)."""
    distance: Floats
    """Of ω and γ, (N,)."""


@lru_cache(maxsize=16)
def pair(moments: Moments, chi: float) -> NeighbouringTops:
    """Two that start with E = MgR/2 and ω₃ = 0, as nearly at χ."""
    rates = angle_rates(LEVEL, chi, (*across(moments, ENERGY.default, chi, 0.0), 0.0))
    begin = [0.0, LEVEL, np.array([chi, chi + APART])]
    t = np.linspace(0.0, SHOWN, 1501)
    motions = system().motions(parameters(moments, 1.0), begin, rates)
    q, qdot = motions.integrate(t, rtol=1e-12, atol=1e-14)
    axes = attitudes(q)
    states = np.concatenate([axes[..., 2, :], body_rates(q, qdot)], axis=-1)
    return NeighbouringTops(t, axes[..., 0], np.linalg.norm(states[1] - states[0], axis=-1))


def attitudes(q: Floats) -> Floats:
    """e₁, e₂ and e₃ in space (…, 3, 3), as columns; the last row is γ₁, γ₂ and γ₃."""
    turns = Rotation.from_euler("ZYZ", q.reshape(-1, 3))
    return np.asarray(turns.as_matrix().reshape(*q.shape, 3))


def body_rates(q: Floats, qdot: Floats) -> Floats:
    """ω₁, ω₂ and ω₃ (…, 3)."""
    gamma, psi = attitudes(q)[..., 2, :], q[..., 2]
    zero = np.zeros_like(psi)
    nodes = np.stack([np.sin(psi), np.cos(psi), zero], axis=-1)
    spin = np.stack([zero, zero, qdot[..., 2]], axis=-1)
    return np.asarray(qdot[..., :1] * gamma + qdot[..., 1:2] * nodes + spin)


def exponent(two: NeighbouringTops) -> tuple[float, float]:
    """σ of the straight line that fits best, and the logarithm of δ with which it starts.

    It is fitted up to where the distance is no longer small for the first time.
    """
    far = np.flatnonzero(two.distance > NEAR)
    last = int(far[0]) if len(far) else len(two.t)
    slope, start = np.polyfit(two.t[:last], np.log(two.distance[:last]), 1)
    return float(slope), float(start)


def draw_distances(axes: Axes, lambda1: float, chi: float, until: int | None = None) -> None:
    """The distances of both pairs as far as a row, and the line that fits."""
    without = pair(other(lambda1), chi)
    slope, start = exponent(without)
    fitted = np.exp(start + slope * without.t)
    line = (without.t[fitted < 3], fitted[fitted < 3])
    curves = []
    for moments, color in ((KOVALEVSKAYA, look.FIRST), (other(lambda1), look.SECOND)):
        two, name = pair(moments, chi), rf"$\lambda_1={moments[0]:g}\lambda_3$"
        curve = two.t[:until], two.distance[:until]
        curves.append(pen.Curve(curve, color, 0.9, label=name))
    growth = pen.Curve(line, look.INK, 0.9, look.DASHED, label=r"$\delta_0e^{\sigma t}$")
    limits = {"xlim": (0, SHOWN), "ylim": (APART / 10, 10)}
    pen.chart(axes, [*curves, growth], r"$\nu_3t$", r"$\delta$", yscale="log", **limits)
    pen.legend_above(axes, ncols=3)


TRAIL = 40


def draw_tips(axes: Axes, two: NeighbouringTops, row: int) -> None:
    """The axes of both at a row, and where they have been shortly before."""
    parts: list[pen.Part] = [pen.Sphere()]
    for tip, color in zip(two.tips, (look.SECOND, look.INK), strict=True):
        trail = tip[max(0, row - TRAIL) : row + 1]
        parts += [pen.on_sphere(trail, color, lw=1.0), pen.Arrow(tip[row], "", color, 1.4)]
    pen.picture(axes, parts, (-1.15, 1.15), (-1.15, 1.15), VIEW)


def parted(two: NeighbouringTops) -> int:
    """The row at which their axes are first a radius apart, or the last one."""
    far = np.flatnonzero(np.linalg.norm(two.tips[1] - two.tips[0], axis=-1) > 1.0)
    return int(far[0]) if len(far) else len(two.t) - 1


def _apart(ball: Axes, chart: Axes, lambda1: float, chi: float) -> None:
    two = pair(other(lambda1), chi)
    draw_tips(ball, two, parted(two))
    draw_distances(chart, lambda1, chi)


def _film(lambda1: float, chi: float) -> Film:
    """The axes of the pair without the integral, and the distances until now."""
    two = pair(other(lambda1), chi)

    def show(share: float, ball: Axes, chart: Axes) -> None:
        row = round(share * (len(two.t) - 1))
        draw_tips(ball, two, row)
        draw_distances(chart, lambda1, chi, row + 1)

    return film(look.TEXT, 2.6, show, (0.0, 0.02, 0.4, 0.96), (0.52, 0.18, 0.46, 0.68))


def _facts(lambda1: float, chi: float) -> dict[str, Any]:
    without = pair(other(lambda1), chi)
    slope, _ = exponent(without)
    grown = pair(KOVALEVSKAYA, chi).distance
    return {
        "sigma": slope,
        "digit": math.log(10) / slope,
        "when": float(without.t[parted(without)]),
        "grown": float(grown.max() / APART),
    }


NEIGHBOURS = Drawing(
    "apart",
    "Two neighbours part",
    "5",
    (MOMENT, CHI),
    pen.panels(look.TEXT, 2.6, _apart, 1, 2, width_ratios=(1, 1.6)),
    r"Two tops start from $\chi = {chi}$ and $10^{-7}$ beside, with $\omega_3 = 0$ and the energy "
    r"of the section. Left: their axes $\mathbf e_1$ at $\nu_3t = {when}$, with "
    r"$\lambda_1 = {lambda1}\,\lambda_3$. Right: their distance, and that of two of Kovalevskaya's "
    r"tops, which grows {grown}-fold. The line has $\sigma = {sigma}\,\nu_3$.",
    "A sphere with two arrows, and the paths of their tips, which have parted. Beside it two "
    "distances in a logarithmic chart: with {lambda1} times the third moment as the first, one "
    "rises along a straight line of slope {sigma} until it is as large as can be; the other one, "
    "from chi = {chi} as well, stays small.",
    _facts,
    _film,
)

FIGURES = (SECTION, NEIGHBOURS)
