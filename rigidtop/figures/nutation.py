"""Nutation: the path of the figure axis, its angles in time, and what kinds of motion there are."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike, NDArray
from scipy.ndimage import distance_transform_edt, label

from rigidtop.errors import RigidtopError
from rigidtop.figures import style as look
from rigidtop.figures.bodies import (
    SPIN,
    THETA,
    TOP,
    has_phi,
    of_top,
    rates_in_words,
    start_in_words,
    top_in_words,
    vertical,
)
from rigidtop.figures.drawing import Drawing, one
from rigidtop.figures.space import UPRIGHT, Scene, View, circle, paper
from rigidtop.figures.style import (
    Floats,
    alone,
    canvas,
    degrees,
    legend_above,
    name_at,
    said,
    spoken,
)
from rigidtop.motion.many import top_motions
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

# --- The path of e₃ on the sphere ----------------------------------------------------------------

MOST_NUTATIONS = 14
"""In one picture; more of them blur."""


def draw_path(axes: Axes, e3: ArrayLike, title: str = "") -> None:
    """The path of the figure axis, unit vectors (N, 3) in space, on the sphere."""
    path = np.asarray(e3, dtype=float)
    scene = Scene(axes, View(elevation=0.5))
    scene.sphere()
    polar = np.arccos(np.clip(path[:, 2], -1, 1))
    for theta in (polar.min(), polar.max()):
        scene.on_sphere(circle(UPRIGHT, float(theta)), color=look.GREY, lw=0.7)
    scene.on_sphere(path, color=look.FIRST, lw=1.3, label="_path")
    scene.arrow(1.45 * UPRIGHT, look.Z, start=UPRIGHT, lw=0.9, shift=(7, -3))
    paper(axes, (-1.04, 1.04), (-1.04, 1.34))
    if title:
        axes.set_title(title, color=look.INK)


def nutation_times(motion: TopMotion, samples: int = 2400) -> Floats:
    """Times (s) of a path that shows how a motion nutates: about half a turn of precession."""
    period = motion.nutation_period
    if not math.isfinite(period):  # to the upright, or at rest
        top = motion.body
        rate = math.hypot(*motion.omega[:2]) + math.sqrt(top.M * top.g * top.R / top.lambda1)
        return np.linspace(0.0, 12 / rate, samples)
    turn = abs(motion.mean_precession)
    wanted = 4.2 / turn if turn else math.inf
    return np.linspace(0.0, min(max(wanted, 2 * period), MOST_NUTATIONS * period), samples)


def _leaning(theta: float) -> None:
    if vertical(theta):
        raise RigidtopError(
            f"at theta = {theta:g} phi has no meaning, and what phi_dot does cannot be shown: "
            "give a theta between 0 and 180 degrees"
        )


def _paths(theta: float, phi_dot: float, omega3: float, **top: float) -> list[TopMotion]:
    """φ̇ at the start positive, zero, negative; the middle of the picture faces the reader."""
    _leaning(theta)
    body = HeavyTop(**top)
    return [
        body.motion(theta=theta, phi=-1.25, phi_dot=rate, omega3=omega3)
        for rate in (phi_dot, 0.0, -phi_dot)
    ]


def _draw_paths(**values: float) -> Canvas:
    drawn = canvas(look.TEXT, 2.7)
    spheres, strips = drawn.subplots(2, 3, sharey="row", height_ratios=(2, 1))
    for sphere, strip, motion in zip(spheres, strips, _paths(**values), strict=True):
        run = motion.exact(nutation_times(motion))
        draw_path(sphere, run.e3, motion.regime)
        few = run.t <= 4 * motion.nutation_period
        turned = np.degrees(run.phi[few] - run.phi[0])
        strip.plot(turned, np.degrees(run.theta[few]), color=look.FIRST, lw=1.1)
        strip.set_xlabel(r"$\phi$  (degrees)")
    strips[0].set_ylabel(r"$\theta$  (degrees)")
    strips[0].margins(y=0.1)
    strips[0].invert_yaxis()
    return drawn


def _paths_caption(body: HeavyTop, theta: float, phi_dot: float, omega3: float) -> str:
    _leaning(theta)
    return (
        f"The path of $e₃$ on the sphere from {start_in_words(theta, omega3)} with $θ̇ = 0$ and "
        f"$φ̇ = {said(phi_dot)}$, 0 and {said(-phi_dot)} rad/s, for {top_in_words(body)}. "
        "The circles that a path touches lie at the turning points of $θ$. "
        "Below: $θ$ against $φ$ from the start, for four nutations at most."
    )


def _paths_in_words(**values: float) -> str:
    regimes = [motion.regime for motion in _paths(**values)]
    return (
        "Three spheres with the path of the figure axis between two circles of latitude, for a "
        f"start with phi dot {spoken(values['phi_dot'])}, zero and {spoken(-values['phi_dot'])} "
        f"radians per second: {', '.join(regimes)}. Below each theta, "
        "downwards, against phi."
    )


PATHS = Drawing(
    "paths",
    "The path of $e₃$ on the sphere: waves, cusps, loops",
    "3.5.4",
    (
        *TOP,
        THETA,
        Parameter("phi_dot", 1.6, "$φ̇$ at the start, in turn positive, 0, negative", "rad/s"),
        SPIN,
    ),
    _draw_paths,
    of_top(_paths_caption),
    _paths_in_words,
    motions=_paths,
)


# --- θ(t), φ(t), energies ------------------------------------------------------------------------


def draw_theta(axes: Axes, motion: TopMotion, t: Floats) -> None:
    """θ(t) (degrees) between its turning points."""
    axes.plot(t, np.degrees(motion.exact(t).theta), color=look.FIRST, label="_theta")
    for angle in np.degrees(motion.turning_points):
        axes.axhline(float(angle), color=look.GREY, lw=0.8, ls=look.DOTTED)
    axes.set_ylabel(r"$\theta$  (degrees)")


def draw_phi(axes: Axes, motion: TopMotion, t: Floats) -> None:
    """φ(t) (degrees), and what it would be at its mean rate."""
    phi = motion.exact(t).phi
    mean = motion.mean_precession
    if math.isfinite(mean):
        axes.plot(t, np.degrees(phi[0] + mean * t), color=look.GREY, lw=0.9, ls=look.DASHED)
    axes.plot(t, np.degrees(phi), color=look.FIRST, label="_phi")
    axes.set_ylabel(r"$\phi$  (degrees)")


def draw_energies(axes: Axes, motion: TopMotion, t: Floats) -> None:
    """T, V and E = T + V (J), without the constant part p_ψ²/(2λ₃) of T and of E."""
    run, top = motion.exact(t), motion.body
    constant = run.p_psi**2 / (2 * top.lambda3)
    potential = run.vertical @ np.array(top.weight)
    energy = run.energy - constant
    for values, words, color, style in (
        (energy - potential, "$T$", look.SECOND, look.DASH_DOT),
        (potential, "$V$", look.FIRST, "-"),
        (energy, "$E$", look.INK, look.DASHED),
    ):
        axes.plot(t, values, color=color, ls=style, lw=1.2, label=words)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.34 * (high - low))
    axes.legend(loc="upper center", ncols=3, handlelength=2.6, borderaxespad=0.0)
    axes.set_ylabel("energy  (J)")


def _start(
    theta: float, theta_dot: float, phi_dot: float, omega3: float, **top: float
) -> TopMotion:
    has_phi(theta, phi_dot)
    return HeavyTop(**top).motion(theta=theta, theta_dot=theta_dot, phi_dot=phi_dot, omega3=omega3)


def _shown_time(motion: TopMotion) -> float:
    period = motion.nutation_period
    return 5 * period if math.isfinite(period) else float(nutation_times(motion, 2)[-1])


def _draw_motion(**values: float) -> Canvas:
    motion = _start(**values)
    times = np.linspace(0.0, _shown_time(motion), 1201)
    drawn = canvas(look.COLUMN, 3.2)
    panels = drawn.subplots(3, 1, sharex=True)
    for axes, draw in zip(panels, (draw_theta, draw_phi, draw_energies), strict=True):
        draw(axes, motion, times)
        axes.set_xlim(0, times[-1])
    panels[-1].set_xlabel("$t$  (s)")
    drawn.align_ylabels(panels)
    return drawn


def _motion_caption(
    theta: float, theta_dot: float, phi_dot: float, omega3: float, **top: float
) -> str:
    motion = _start(theta, theta_dot, phi_dot, omega3, **top)
    first, last = np.degrees(motion.turning_points)
    mean = f"{said(motion.mean_precession)} rad/s"
    if motion.regime in AT_REST:
        course = f"$θ$ stays ${said(first)}°$; $φ$ is drawn at the rate of a top nearby, {mean}."
    elif motion.regime == "steady":
        course = f"$θ$ stays ${said(first)}°$, and $φ$ goes on at {mean}."
    else:
        course = (
            f"$θ$ runs between ${said(first)}°$ and ${said(last)}°$ (dotted), there and back in "
            f"{said(motion.nutation_period)} s; dashed, $φ$ at its mean rate, {mean}."
        )
    return (
        f"A top with {top_in_words(motion.body)} from {start_in_words(theta, omega3)}, "
        f"{rates_in_words(theta, phi_dot, theta_dot)} ({motion.regime}): {course} $T$ and $E$ are "
        "without the constant $p_ψ²/(2λ₃)$."
    )


AT_REST = ("sleeping", "hanging")
"""Regimes in which e₃ stays on the vertical."""


def _motion_in_words(**values: float) -> str:
    motion = _start(**values)
    mean = f"{spoken(motion.mean_precession)} radians per second"
    if motion.regime in (*AT_REST, "steady"):
        phi = "phi, which has no meaning there, is drawn" if motion.regime in AT_REST else "phi is"
        return (
            f"Three panels over time: theta stays {spoken(math.degrees(values['theta']))} degrees; "
            f"{phi} as a straight line at {mean}; the energies T, V and their sum E are constant."
        )
    return (
        "Three curves over time: theta goes up and down between its turning points with a period "
        f"of {spoken(motion.nutation_period)} seconds; phi goes on, now faster, now slower, at a "
        f"mean rate of {mean}; of the energies T and V mirror each other, and their sum E stays "
        "the same."
    )


RATE = Parameter("phi_dot", 0.0, "$φ̇$ at the start", "rad/s")

MOTION = Drawing(
    "motion",
    "$θ(t)$, $φ(t)$ and the energies of a top",
    "",
    (*TOP, THETA, Parameter("theta_dot", 0.0, "$θ̇$ at the start", "rad/s"), RATE, SPIN),
    _draw_motion,
    _motion_caption,
    _motion_in_words,
    motions=one(_start),
)

# --- A map of regimes ----------------------------------------------------------------------------

COUNTS = 241, 201
AREAS: Mapping[str, tuple[str, str]] = {
    "waves": ("#ffffff", ""),
    "loops": ("#c9d6e3", "////"),
}
"""Colour and hatching of the regimes that fill areas; the others are lines and points."""


VERTICAL: Mapping[str, Any] = {
    "color": look.INK,
    "lw": 1.0,
    "ls": look.DOTTED,
    "label": "_vertical",
}


def regime_map(top: HeavyTop, theta: float, spins: Floats, rates: Floats) -> NDArray[np.str_]:
    """The regimes (rates, spins) of tops that start at θ with θ̇ = 0."""
    rates, spins = rates[:, None], spins[None, :]
    return top_motions(**vars(top), theta=theta, phi_dot=rates, omega3=spins).regime


def spin_to_the_upright(top: HeavyTop, theta: float) -> float:
    """The |ω₃| (rad/s) above which a top that starts at θ with θ̇ = 0 can come to the upright.

    It is √(2λ₁MgR(1 + cos θ))/λ₃; there the second cusps begin as well.
    """
    return math.sqrt(2 * top.lambda1 * top.weight[2] * (1 + math.cos(theta))) / top.lambda3


def draw_regimes(axes: Axes, top: HeavyTop, theta: float, omega3: float, phi_dot: float) -> None:
    """What a top does that starts at θ with θ̇ = 0, over ω₃ up to `omega3` and |φ̇| to `phi_dot`.

    Solid: steady precession.  Dashed: cusps, where φ̇ vanishes at a turning point.  Dotted: through
    the vertical, p_φ = ±p_ψ; upright only above `spin_to_the_upright`.
    """
    _leaning(theta)
    # No line of the grid lies on an axis, where the regimes are those of lines.
    spins = omega3 * (np.arange(COUNTS[0]) + 0.5) / COUNTS[0]
    rates = phi_dot * ((np.arange(COUNTS[1]) + 0.5) / COUNTS[1] * 2 - 1)
    rates = rates + 1e-3 * phi_dot / COUNTS[1]
    regimes = regime_map(top, theta, spins, rates)
    known = [name for name in AREAS if np.any(regimes == name)]
    for name in known:
        inside = (regimes == name).astype(float)
        color, hatch = AREAS[name]
        if inside.all():
            axes.axhspan(-phi_dot, phi_dot, fc=color, ec=look.RULE, hatch=hatch or None, lw=0)
            continue
        axes.contourf(
            spins, rates, inside, levels=[0.5, 1.5], colors=[color], hatches=[hatch or None]
        )
    weight, high, low = top.M * top.g * top.R, 1 + math.cos(theta), 1 - math.cos(theta)
    whole = np.linspace(0.0, omega3, 2)
    axes.plot(whole, 0 * whole, color=look.INK, lw=1.0, ls=look.DASHED, label="_cusps")
    axes.plot(whole, -top.lambda3 * whole / (top.lambda1 * low), **VERTICAL)
    least = spin_to_the_upright(top, theta)
    if least < omega3:
        fast = np.linspace(least, omega3, 200)[1:]
        second = 2 * weight / (top.lambda3 * fast)
        axes.plot(fast, second, color=look.INK, lw=1.0, ls=look.DASHED, label="_cusps")
        axes.plot(fast, top.lambda3 * fast / (top.lambda1 * high), **VERTICAL)
    _steady_lines(axes, top, theta, omega3, phi_dot)
    for name in known:
        _name_area(axes, spins, rates, regimes == name, name)
    axes.set(
        xlim=(0, omega3),
        ylim=(-phi_dot, phi_dot),
        xlabel=r"$\omega_3$  (rad/s)",
        ylabel=r"$\dot\phi$ at the start  (rad/s)",
    )
    handles = [
        Line2D([], [], color=look.SECOND, lw=1.6, label="steady"),
        Line2D([], [], color=look.INK, lw=0.9, ls=look.DASHED, label="cusps"),
        Line2D([], [], color=look.INK, lw=0.9, ls=look.DOTTED, label="vertical"),
    ]
    legend_above(axes, handles=handles, ncols=3)


def _steady_lines(axes: Axes, top: HeavyTop, theta: float, omega3: float, phi_dot: float) -> None:
    least = top.smallest_spin(theta)
    if least >= omega3:
        return
    spins = least + (omega3 - least) * np.linspace(0.0, 1.0, 300)[1:] ** 2
    roots = np.array([top.steady_precession(theta, spin) for spin in spins])
    if least:  # both begin at one point
        spins = np.concatenate([spins[::-1], spins])
        axes.plot(spins, np.append(roots[::-1, 1], roots[:, 0]), color=look.SECOND, lw=1.6)
        return
    for root in roots.T:
        axes.plot(
            spins, np.where(np.abs(root) < 10 * phi_dot, root, np.nan), color=look.SECOND, lw=1.6
        )


def _name_area(
    axes: Axes, spins: Floats, rates: Floats, inside: NDArray[np.bool_], name: str
) -> None:
    """The name of a regime, in the middle of each large part of its area."""
    above, count = label(inside & (rates > 0)[:, None])
    below, more = label(inside & (rates < 0)[:, None])
    parts = above + np.where(below > 0, below + count, 0)
    for part in range(1, count + more + 1):
        here = parts == part
        if here.mean() < 0.04:
            continue
        depth = distance_transform_edt(np.pad(here, 1))[1:-1, 1:-1]
        row, column = np.unravel_index(int(np.argmax(depth)), depth.shape)
        name_at(
            axes,
            float(spins[column]),
            float(rates[row]),
            name,
            ha="center",
            va="center",
            color=look.INK,
        )


def _regimes_caption(body: HeavyTop, theta: float, omega3: float, phi_dot: float) -> str:
    _leaning(theta)
    least = body.smallest_spin(theta)
    begins = f" It begins at $ω₃ = {said(least)}$ rad/s." if 0 < least < omega3 else ""
    reached = spin_to_the_upright(body, theta)
    upright = (
        f" The axis comes to the upright, on the upper dotted line, from {said(reached)} rad/s on."
        if 0 < reached < omega3
        else ""
    )
    return (
        f"What a top with {top_in_words(body)} does that starts at $θ = {degrees(theta)}$ with $θ̇ "
        "= 0$, for each $ω₃$ and $φ̇$: waves, or loops (hatched), with cusps between (dashed), or "
        f"a way through the vertical (dotted).{upright} Solid: steady precession.{begins}"
    )


def _regimes_in_words(body: HeavyTop, theta: float, omega3: float, phi_dot: float) -> str:
    _leaning(theta)
    points = np.linspace(0.05, 1, 20) * omega3, np.linspace(-0.99, 0.99, 20) * phi_dot
    regimes = regime_map(body, theta, *points)
    share = float(np.mean(regimes == "loops"))
    return (
        "A map over the spin and the first rate of precession. Areas of waves and hatched areas of "
        f"loops, the latter {spoken(100 * share)} per cent of it, are parted by dashed lines of "
        "cusps and dotted lines through the vertical. A solid curve of steady precession begins at "
        f"the least spin, {spoken(body.smallest_spin(theta))} radians per second, and splits "
        "into the slow and the fast one."
    )


REGIMES = Drawing(
    "regimes",
    "A map of regimes over $ω₃$ and $φ̇$",
    "3.5.4",
    (
        *TOP,
        THETA,
        Parameter("omega3", 60.0, "largest $ω₃$", "rad/s", above=0),
        Parameter("phi_dot", 30.0, "largest $|φ̇|$", "rad/s", above=0),
    ),
    alone(2.8, of_top(draw_regimes)),
    of_top(_regimes_caption),
    of_top(_regimes_in_words),
)
