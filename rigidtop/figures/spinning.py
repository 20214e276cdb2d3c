"""A top as one sees it: a stroboscopic picture, and a film."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas

from rigidtop.figures import style as look
from rigidtop.figures.bodies import TOP, has_phi, rates_in_words, start_in_words, top_in_words
from rigidtop.figures.drawing import Drawing, Film, one
from rigidtop.figures.nutation import nutation_times
from rigidtop.figures.space import Scene, View, paper, table, top_body, unit
from rigidtop.figures.style import Floats, said, spoken
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

VIEW = View(azimuth=0.0, elevation=0.3)
FLASHES = 5
STANDING = 1.4
"""The largest tilt (rad) of a top on a table; others hang from their tip."""
BODY = 0.95, 0.2
"""Height and radius of the top in flashes: thin, so that little is hidden."""

TRAIL = 1.3
"""How far out on the axis the path is drawn."""


def draw_top(axes: Axes, motion: TopMotion, t: float, since: Floats) -> None:
    """The top at the time `t` (s) with e₃, ω and L, and the path of its axis at times `since`."""
    scene, run = Scene(axes, VIEW), motion.exact(t)
    e3 = run.e3[0]
    if motion.turning_points[1] < STANDING:
        table(scene, 0.6)
    scene.arrow([0, 0, 1.6], look.Z, lw=0.8, color=look.GREY, shift=(7, 2), zorder=1)
    path = TRAIL * motion.exact(since).e3
    scene.curve(path, path[:, 0] < 0, color=look.FIRST, lw=1.2)
    mark = run.rotation.as_matrix()[0][:, 0]
    top_body(scene, e3, psi_mark=mark, zorder=2 if e3[0] > 0 else 1.2)
    scene.arrow(TRAIL * e3, look.E3, color=look.AXIS, lw=1.3, start=0.9 * e3)
    scene.arrow(1.2 * unit(run.angular_momentum[0]), look.L_VEC, color=look.MOMENTUM, lw=1.3)
    scene.arrow(1.05 * unit(run.omega_space[0]), look.OMEGA_VEC, color=look.OMEGA, lw=1.5)


def draw_stroboscopic(axes: Axes, motion: TopMotion, times: Floats) -> None:
    """The top in some flashes of light, and the path of its axis between them."""
    scene = Scene(axes, VIEW)
    if motion.turning_points[1] < STANDING:
        table(scene, 0.6)
    scene.arrow([0, 0, 1.6], look.Z, lw=0.8, color=look.GREY, shift=(7, 2), zorder=8)
    path = TRAIL * motion.exact(times).e3
    scene.curve(path, path[:, 0] < 0, color=look.FIRST, lw=1.3, zorder=7)
    flashes = np.linspace(times[0], times[-1], FLASHES)
    run = motion.exact(flashes)
    towards = VIEW(run.e3)[2]
    for place, k in enumerate(np.argsort(towards, kind="stable")):
        mark = run.rotation.as_matrix()[k][:, 0]
        e3 = run.e3[k]
        level = 2 + 0.5 * place
        top_body(scene, e3, *BODY, psi_mark=mark, zorder=level)
        about: dict[str, Any] = {"color": look.AXIS, "lw": 1.2, "zorder": level + 0.4}
        scene.arrow(TRAIL * e3, rf"${k + 1}$", start=BODY[0] * e3, shift=(0, 10), **about)


def _motion(theta: float, phi_dot: float, omega3: float, **top: float) -> TopMotion:
    has_phi(theta, phi_dot)
    return HeavyTop(**top).motion(theta=theta, phi=-1.35, phi_dot=phi_dot, omega3=omega3)


def _times(motion: TopMotion, samples: int) -> Floats:
    """As long as it takes e₃ to pass before the eye, from the left to the right."""
    last = float(nutation_times(motion, 2)[-1])
    turned = abs(motion.mean_precession) * last
    return np.linspace(0.0, last * min(1.0, 2.7 / turned) if turned else last, samples)


def _empty() -> tuple[Canvas, Axes]:
    drawn = Canvas(figsize=(look.COLUMN, 2.9))
    return drawn, drawn.add_axes((0.0, 0.0, 1.0, 1.0))


def _lowest(motion: TopMotion) -> float:
    return min(-0.32, 1.5 * math.cos(motion.turning_points[1]) - 0.3)


def _draw(**values: float) -> Canvas:
    drawn, axes = _empty()
    motion = _motion(**values)
    draw_stroboscopic(axes, motion, _times(motion, 1200))
    paper(axes, (-1.32, 1.32), (_lowest(motion), 1.72))
    return drawn


def _film(**values: float) -> Film:
    """A turn of precession, on the mean; the spin as slow as the motion is."""
    drawn, axes = _empty()
    motion = _motion(**values)
    rate = abs(motion.mean_precession)
    last = 2 * math.pi / rate if rate else float(nutation_times(motion, 2)[-1])
    last = min(last, 8 * float(nutation_times(motion, 2)[-1]))

    def show(share: float) -> None:
        axes.clear()
        now = share * last
        draw_top(axes, motion, now, np.linspace(min(now - 1e-9 * last, 0.0), now, 1500))
        paper(axes, (-1.32, 1.32), (_lowest(motion), 1.72))

    show(0.0)
    return Film(drawn, show)


def _caption(theta: float, phi_dot: float, omega3: float, **top: float) -> str:
    motion = _motion(theta, phi_dot, omega3, **top)
    last = float(_times(motion, 2)[-1])
    return (
        f"A top with {top_in_words(motion.body)} from {start_in_words(theta, omega3)}, "
        f"{rates_in_words(theta, phi_dot)}, and the path of its axis ({motion.regime}); the line "
        f"on the lid is $e₁$. In {FLASHES} flashes of light, {said(last / (FLASHES - 1))} s apart, "
        "where it does not move."
    )


def _in_words(**values: float) -> str:
    motion = _motion(**values)
    first, last = (math.degrees(angle) for angle in motion.turning_points)
    return (
        f"A top on a table at {FLASHES} numbered moments, leaning to all sides as it goes round "
        f"the vertical, and the path of its axis, of the kind {motion.regime}, between "
        f"{spoken(first)} and {spoken(last)} degrees from the vertical."
    )


SPINNING_TOP = Drawing(
    "top",
    "A top going round, in flashes of light",
    "",
    (
        *TOP,
        Parameter("theta", 0.85, "$θ$ at the start", "rad", least=0, most=math.pi),
        Parameter("phi_dot", 0.0, "$φ̇$ at the start", "rad/s"),
        Parameter("omega3", 40.0, "$ω₃$", "rad/s", above=0),
    ),
    _draw,
    _caption,
    _in_words,
    _film,
    motions=one(_motion),
)
