"""A top as one sees it: a stroboscopic picture, and a film."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.bodies import RATE, SPIN, THETA, TOP, facts_of, has_phi, rates_in_words
from rigidtop.figures.drawing import Drawing, Film, film, one
from rigidtop.figures.nutation import nutation_times
from rigidtop.figures.space import View, unit
from rigidtop.figures.style import Canvas, Floats
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop

VIEW = View(azimuth=0.0, elevation=0.3)
FLASHES = 5
STANDING = 1.4
"""The largest tilt (rad) of a top on a table; others hang from their tip."""
BODY = 0.95, 0.2
"""Height and radius of the top in flashes: thin, so that little is hidden."""

TRAIL = 1.3
"""How far out on the axis the path is drawn."""


def _round_about(motion: TopMotion, times: Floats, lw: float, z: float) -> list[pen.Part]:
    """The table, ẑ and the path of the axis, which go from behind ẑ to before it."""
    path = TRAIL * motion.exact(times).e3
    return [
        *([solids.table(0.6)] if motion.turning_points[1] < STANDING else []),
        pen.Arrow([0, 0, 1.6], look.Z, look.GREY, 0.8, shift=(7, 2), z=1 if z < 7 else 8),
        pen.Curve(path, look.FIRST, lw, z=z, hidden=path[:, 0] < 0),
    ]


def draw_top(axes: Axes, motion: TopMotion, t: float, since: Floats) -> None:
    """The top at the time `t` (s) with e₃, ω and L, and the path of its axis at times `since`."""
    run = motion.exact(t)
    e3, mark = run.e3[0], run.rotation.as_matrix()[0][:, 0]
    parts = [
        *_round_about(motion, since, 1.2, 3),
        *solids.cone(e3, mark=mark, z=2 if e3[0] > 0 else 1.2),
        pen.Arrow(TRAIL * e3, look.E3, look.AXIS, 1.3, start=0.9 * e3),
        pen.Arrow(1.2 * unit(run.angular_momentum[0]), look.L_VEC, look.MOMENTUM, 1.3),
        pen.Arrow(1.05 * unit(run.omega_space[0]), look.OMEGA_VEC, look.OMEGA, 1.5),
    ]
    pen.draw(axes, parts, VIEW)


def draw_stroboscopic(axes: Axes, motion: TopMotion, times: Floats) -> None:
    """The top in some flashes of light, and the path of its axis between them."""
    parts = _round_about(motion, times, 1.3, 7)
    run = motion.exact(np.linspace(times[0], times[-1], FLASHES))
    for place, k in enumerate(np.argsort(VIEW(run.e3)[2], kind="stable")):
        e3, mark, z = run.e3[k], run.rotation.as_matrix()[k][:, 0], 2 + 0.5 * place
        tip, start = TRAIL * e3, BODY[0] * e3
        number = pen.Arrow(tip, rf"${k + 1}$", look.AXIS, 1.2, start, (0, 10), z + 0.4)
        parts += [*solids.cone(e3, *BODY, mark, z), number]
    pen.draw(axes, parts, VIEW)


def _motion(theta: float, phi_dot: float, omega3: float, **top: float) -> TopMotion:
    has_phi(theta, phi_dot)
    return HeavyTop(**top).motion(theta=theta, phi=-1.35, phi_dot=phi_dot, omega3=omega3)


def _times(motion: TopMotion, samples: int) -> Floats:
    """As long as it takes e₃ to pass before the eye, from the left to the right."""
    last = float(nutation_times(motion, 2)[-1])
    turned = abs(motion.mean_precession) * last
    return np.linspace(0.0, last * min(1.0, 2.7 / turned) if turned else last, samples)


def _paper(axes: Axes, motion: TopMotion) -> None:
    low = min(-0.32, 1.5 * math.cos(motion.turning_points[1]) - 0.3)
    pen.paper(axes, (-1.32, 1.32), (low, 1.72))


def _draw(**values: float) -> Canvas:
    motion = _motion(**values)

    def fill(share: float, axes: Axes) -> None:
        draw_stroboscopic(axes, motion, _times(motion, 1200))
        _paper(axes, motion)

    return film(look.COLUMN, 2.9, fill).canvas


def _film(**values: float) -> Film:
    """A turn of precession, on the mean; the spin as slow as the motion is."""
    motion = _motion(**values)
    rate = abs(motion.mean_precession)
    last = 2 * math.pi / rate if rate else float(nutation_times(motion, 2)[-1])
    last = min(last, 8 * float(nutation_times(motion, 2)[-1]))

    def show(share: float, axes: Axes) -> None:
        now = share * last
        draw_top(axes, motion, now, np.linspace(min(now - 1e-9 * last, 0.0), now, 1500))
        _paper(axes, motion)

    return film(look.COLUMN, 2.9, show)


def _facts(theta: float, **others: float) -> dict[str, Any]:
    motion = _motion(theta=theta, **others)
    first, last = motion.turning_points
    return facts_of(
        motion.body,
        rates=rates_in_words(theta),
        theta_dot=0.0,
        regime=motion.regime,
        flashes=FLASHES,
        apart=float(_times(motion, 2)[-1]) / (FLASHES - 1),
        first=first,
        last=last,
    )


SPINNING_TOP = Drawing(
    "top",
    "A top going round, in flashes of light",
    "",
    (*TOP, replace(THETA, default=0.85), RATE, SPIN),
    _draw,
    "A top with {top} from {start}, {rates}, and the path of its axis ({regime}); the line on the "
    r"lid is $\mathbf e_1$. In {flashes} flashes of light, {apart} s apart, where it does not "
    "move.",
    "A top on a table at {flashes} numbered moments, leaning to all sides as it goes round the "
    "vertical, and the path of its axis, of the kind {regime}, between {first:°} and {last:°} "
    "degrees from the vertical.",
    _facts,
    _film,
    motions=one(_motion),
)
