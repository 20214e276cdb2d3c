"""Nutation: the path of the figure axis, its angles in time, and what kinds of motion there are."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray
from scipy.ndimage import distance_transform_edt, label

from rigidtop.errors import RigidtopError
from rigidtop.figures import bodies
from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, one
from rigidtop.figures.space import UPRIGHT, View, circle
from rigidtop.figures.style import Floats
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
    polar = np.arccos(np.clip(path[:, 2], -1, 1))
    turning = [circle(UPRIGHT, float(theta)) for theta in (polar.min(), polar.max())]
    parts = [
        pen.Sphere(),
        *(pen.on_sphere(points, look.GREY, lw=0.7) for points in turning),
        pen.on_sphere(path, look.FIRST, lw=1.3, label="_path"),
        pen.Arrow(1.45 * UPRIGHT, look.Z, lw=0.9, start=UPRIGHT, shift=(7, -3)),
    ]
    pen.picture(axes, parts, (-1.04, 1.04), (-1.04, 1.34), View(elevation=0.5))
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
    if bodies.vertical(theta):
        raise RigidtopError(
            f"at theta = {theta:g} phi has no meaning, and what phi_dot does cannot be shown: "
            "give a theta between 0 and 180 degrees"
        )


def _paths(theta: float, phi_dot: float, **others: float) -> list[TopMotion]:
    """φ̇ at the start positive, zero, negative; the middle of the picture faces the reader."""
    _leaning(theta)
    return [
        bodies.top_motion(theta, rate, **others, phi=-1.25) for rate in (phi_dot, 0.0, -phi_dot)
    ]


def _draw_paths(*panels: Axes, **values: float) -> None:
    spheres, strips = panels[:3], panels[3:]
    for sphere, strip, motion in zip(spheres, strips, _paths(**values), strict=True):
        run = motion.exact(nutation_times(motion))
        draw_path(sphere, run.e3, motion.regime)
        few = run.t <= 4 * motion.nutation_period
        turned = np.degrees(run.phi[few] - run.phi[0])
        curve = pen.Curve((turned, np.degrees(run.theta[few])), look.FIRST, 1.1)
        pen.chart(strip, [curve], r"$\phi$  (degrees)", "")
    strips[0].set_ylabel(r"$\theta$  (degrees)")
    strips[0].margins(y=0.1)
    strips[0].invert_yaxis()


def _paths_facts(**values: float) -> dict[str, Any]:
    motions = _paths(**values)
    regimes = ", ".join(motion.regime for motion in motions)
    return bodies.facts_of(motions[0].body, back=-values["phi_dot"], regimes=regimes)


PATHS = Drawing(
    "paths",
    r"The path of $\mathbf e_3$ on the sphere: waves, cusps, loops",
    "3.5.4",
    (
        *bodies.TOP,
        bodies.THETA,
        Parameter(
            "phi_dot", 1.6, bodies.RATE.about + ", in turn positive, 0, negative", bodies.RATE.unit
        ),
        bodies.SPIN,
    ),
    pen.panels(look.TEXT, 2.7, _draw_paths, 2, 3, sharey="row", height_ratios=(2, 1)),
    r"The path of $\mathbf e_3$ on the sphere from {start} with $\dot\theta = 0$ and "
    r"$\dot\phi = {phi_dot}$, 0 and {back} rad/s, for {top}. The circles that a path touches lie "
    r"at the turning points of $\theta$. Below: $\theta$ against $\phi$ from the start, for four "
    "nutations at most.",
    "Three spheres with the path of the figure axis between two circles of latitude, for a start "
    "with phi dot {phi_dot}, zero and {back} radians per second: {regimes}. Below each theta, "
    "downwards, against phi.",
    _paths_facts,
    motions=_paths,
)


# --- θ(t), φ(t), energies ------------------------------------------------------------------------


def draw_theta(axes: Axes, motion: TopMotion, t: Floats) -> None:
    """θ(t) (degrees) between its turning points."""
    limits = [pen.Rule(y=math.degrees(angle), lw=0.8) for angle in motion.turning_points]
    theta = pen.Curve((t, np.degrees(motion.exact(t).theta)), look.FIRST, 1.3, label="_theta")
    pen.chart(axes, [theta, *limits], "", r"$\theta$  (degrees)")


def draw_phi(axes: Axes, motion: TopMotion, t: Floats) -> None:
    """φ(t) (degrees), and what it would be at its mean rate."""
    phi, mean = np.degrees(motion.exact(t).phi), np.degrees(motion.mean_precession)
    parts = [pen.Curve((t, phi), look.FIRST, 1.3, label="_phi")]
    if math.isfinite(mean):
        parts.insert(0, pen.Curve((t, phi[0] + mean * t), look.GREY, 0.9, look.DASHED))
    pen.chart(axes, parts, "", r"$\phi$  (degrees)")


def draw_energies(axes: Axes, motion: TopMotion, t: Floats) -> None:
    """T, V and E = T + V (J), without the constant part p_ψ²/(2λ₃) of T and of E."""
    run, top = motion.exact(t), motion.body
    constant = run.p_psi**2 / (2 * top.lambda3)
    potential = run.vertical @ np.array(top.weight)
    energy = run.energy - constant
    curves = [
        pen.Curve((t, energy - potential), look.SECOND, ls=look.DASH_DOT, label="$T$"),
        pen.Curve((t, potential), look.FIRST, label="$V$"),
        pen.Curve((t, energy), look.INK, ls=look.DASHED, label="$E$"),
    ]
    pen.chart(axes, curves, "", "energy  (J)")
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.34 * (high - low))
    axes.legend(loc="upper center", ncols=3, handlelength=2.6, borderaxespad=0.0)


def _draw_motion(*panels: Axes, **values: float) -> None:
    motion = bodies.top_motion(**values)
    period = motion.nutation_period
    last = 5 * period if math.isfinite(period) else float(nutation_times(motion, 2)[-1])
    times = np.linspace(0.0, last, 1201)
    for axes, panel in zip(panels, (draw_theta, draw_phi, draw_energies), strict=True):
        panel(axes, motion, times)
        axes.set_xlim(0, times[-1])
    panels[-1].set_xlabel("$t$  (s)")


AT_REST = ("sleeping", "hanging")
"""Regimes in which e₃ stays on the vertical."""

AT_ONE_TILT = (
    "Three panels over time: theta stays {theta:°} degrees; {still} as a straight line at {mean} "
    "radians per second; the energies T, V and their sum E are constant."
)
NUTATING = (
    "Three curves over time: theta goes up and down between its turning points with a period of "
    "{period} seconds; phi goes on, now faster, now slower, at a mean rate of {mean} radians per "
    "second; of the energies T and V mirror each other, and their sum E stays the same."
)


def _motion_facts(theta: float, theta_dot: float, **others: float) -> dict[str, Any]:
    motion = bodies.top_motion(theta, theta_dot=theta_dot, **others)
    rests = motion.regime in AT_REST
    first, last = np.degrees(motion.turning_points)
    course = (
        r"$\theta$ runs between ${first}^\circ$ and ${last}^\circ$ (dotted), there and back in "
        r"{period} s; dashed, $\phi$ at its mean rate, {mean} rad/s."
    )
    if motion.regime == "steady":
        course = r"$\theta$ stays ${first}^\circ$, and $\phi$ goes on at {mean} rad/s."
    if rests:
        course = (
            r"$\theta$ stays ${first}^\circ$; $\phi$ is drawn at the rate of a top nearby, "
            "{mean} rad/s."
        )
    return bodies.facts_of_motion(
        motion,
        theta,
        theta_dot,
        first=first,
        last=last,
        course=course,
        mean=motion.mean_precession,
        period=motion.nutation_period,
        seen=AT_ONE_TILT if rests or motion.regime == "steady" else NUTATING,
        still="phi, which has no meaning there, is drawn" if rests else "phi is",
    )


MOTION = Drawing(
    "motion",
    r"$\theta(t)$, $\phi(t)$ and the energies of a top",
    "",
    (
        *bodies.TOP,
        bodies.THETA,
        Parameter("theta_dot", 0.0, r"$\dot\theta$ at the start", "rad/s"),
        bodies.RATE,
        bodies.SPIN,
    ),
    pen.panels(look.COLUMN, 3.2, _draw_motion, 3, sharex=True),
    "A top with {top} from {start}, {rates} ({regime}): {course} $T$ and $E$ are without the "
    r"constant $p_\psi^2/(2\lambda_3)$.",
    "{seen}",
    _motion_facts,
    motions=one(bodies.top_motion),
)

# --- A map of regimes ----------------------------------------------------------------------------

COUNTS = 241, 201
LINES: Mapping[str, dict[str, Any]] = {
    "steady": {"color": look.SECOND, "lw": 1.6},
    "cusps": {"lw": 1.0, "ls": look.DASHED},  # φ̇ vanishes at a turning point
    "vertical": {"lw": 1.0, "ls": look.DOTTED},  # p_φ = ±p_ψ
}


def _line(kind: str, spins: ArrayLike, rates: ArrayLike, hidden: str = "_") -> pen.Curve:
    return pen.Curve((spins, rates), label=hidden + kind, **LINES[kind])


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
    loops = regimes == "loops"
    hatched: Any = {"colors": ["#c9d6e3"], "hatches": ["////"], "levels": [0.5, 1.5]}
    if loops.all():
        axes.axhspan(-phi_dot, phi_dot, fc="#c9d6e3", ec=look.RULE, hatch="////", lw=0)
    elif loops.any():
        axes.contourf(spins, rates, loops.astype(float), **hatched)
    weight, ratio = top.M * top.g * top.R, top.lambda3 / top.lambda1
    whole = np.linspace(0.0, omega3, 2)
    parts: list[pen.Part] = [_line(kind, [], [], "") for kind in LINES]
    parts.append(_line("cusps", whole, 0 * whole))
    parts.append(_line("vertical", whole, -ratio * whole / (1 - math.cos(theta))))
    least = spin_to_the_upright(top, theta)
    if least < omega3:
        fast = np.linspace(least, omega3, 200)[1:]
        parts.append(_line("cusps", fast, 2 * weight / (top.lambda3 * fast)))
        parts.append(_line("vertical", fast, ratio * fast / (1 + math.cos(theta))))
    parts += _steady_lines(top, theta, omega3, phi_dot)
    parts += [
        pen.Words((spins[column], rates[row]), name, ha="center", va="center", z=3)
        for name in ("waves", "loops")
        for row, column in _middles(regimes == name, rates)
    ]
    limits = {"xlim": (0, omega3), "ylim": (-phi_dot, phi_dot)}
    across, up = r"$\omega_3$  (rad/s)", r"$\dot\phi$ at the start  (rad/s)"
    pen.chart(axes, parts, across, up, **limits)
    pen.legend_above(axes, ncols=3)


def _steady_lines(top: HeavyTop, theta: float, omega3: float, phi_dot: float) -> list[pen.Curve]:
    least = top.smallest_spin(theta)
    if least >= omega3:
        return []
    spins = least + (omega3 - least) * np.linspace(0.0, 1.0, 300)[1:] ** 2
    slow, fast = np.array([top.steady_precession(theta, spin) for spin in spins]).T
    if least:  # both begin at one point
        return [_line("steady", np.append(spins[::-1], spins), np.append(fast[::-1], slow))]
    roots = [np.where(np.abs(root) < 10 * phi_dot, root, np.nan) for root in (slow, fast)]
    return [_line("steady", spins, root) for root in roots]


def _middles(inside: NDArray[np.bool_], rates: Floats) -> list[tuple[int, int]]:
    """Row and column of the middle of each large part of an area, above φ̇ = 0 and below it."""
    middles = []
    for side in (rates > 0, rates < 0):
        parts, count = label(inside & side[:, None])
        for part in (parts == k + 1 for k in range(count)):
            if part.mean() >= 0.04:
                depth = distance_transform_edt(np.pad(part, 1))[1:-1, 1:-1]
                row, column = np.unravel_index(int(np.argmax(depth)), depth.shape)
                middles.append((int(row), int(column)))
    return middles


def _regimes_facts(body: HeavyTop, theta: float, omega3: float, phi_dot: float) -> dict[str, Any]:
    _leaning(theta)
    least, reached = body.smallest_spin(theta), spin_to_the_upright(body, theta)
    points = np.linspace(0.05, 1, 20) * omega3, np.linspace(-0.99, 0.99, 20) * phi_dot
    upright = " The axis comes to the upright, on the upper dotted line, from {reached} rad/s on."
    return bodies.facts_of(
        body,
        least=least,
        reached=reached,
        upright=upright if 0 < reached < omega3 else "",
        begins=r" It begins at $\omega_3 = {least}$ rad/s." if 0 < least < omega3 else "",
        loops=float(np.mean(regime_map(body, theta, *points) == "loops")),
    )


REGIMES = Drawing(
    "regimes",
    r"A map of regimes over $\omega_3$ and $\dot\phi$",
    "3.5.4",
    (
        *bodies.TOP,
        bodies.THETA,
        Parameter("omega3", 60.0, r"largest $\omega_3$", "rad/s", above=0),
        Parameter("phi_dot", 30.0, r"largest $|\dot\phi|$", "rad/s", above=0),
    ),
    pen.alone(2.8, bodies.of_top(draw_regimes)),
    r"What a top with {top} does that starts at $\theta = {theta:°}$ with $\dot\theta = 0$, for "
    r"each $\omega_3$ and $\dot\phi$: waves, or loops (hatched), with cusps between (dashed), or a "
    "way through the vertical (dotted).{upright} Solid: steady precession.{begins}",
    "A map over the spin and the first rate of precession. Areas of waves and hatched areas of "
    "loops, the latter {loops:%} per cent of it, are parted by dashed lines of cusps and dotted "
    "lines through the vertical. A solid curve of steady precession begins at the least spin, "
    "{least} radians per second, and splits into the slow and the fast one.",
    bodies.of_top(_regimes_facts),
)
