"""The paths of 𝐋 on its sphere, and a body that turns over again and again."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from scipy.spatial.transform import Rotation

from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film, film
from rigidtop.figures.space import View, ring
from rigidtop.figures.style import Canvas, Floats
from rigidtop.motion.body import FreeBody
from rigidtop.motion.trajectory import Trajectory
from rigidtop.parameters import Parameter

from .bodies import Path, body
from .exercises import MOMENTS

# --- The sphere ----------------------------------------------------------------------------------

VIEW = View(azimuth=0.75, elevation=0.3)
BETWEEN = 3
"""Paths between an axis and the separatrix."""


def about_third(top: FreeBody, angle: float) -> Floats:
    """The path (N, 3) of 𝐋 on the unit sphere that starts at an angle from 𝐞₃, towards 𝐞₁."""
    first, _, third = top.moments
    return Path.started(top, math.sin(angle) / first, math.cos(angle) / third).momentum(361)


def edge(top: FreeBody) -> float:
    """The angle from 𝐞₃ at which the separatrix starts, where (1.8) has 0 on the right (rad)."""
    first, middle, third = top.moments
    return math.atan(math.sqrt(first * (third - middle) / (third * (middle - first))))


def paths(top: FreeBody) -> list[Floats]:
    """About 𝐞₃, and about 𝐞₁, which (1.6) and (1.7) tell by the numbers alone."""
    shares = (np.arange(BETWEEN) + 0.5) / BETWEEN
    turned = FreeBody(*top.moments[::-1])
    rest = math.pi / 2 - edge(top)
    found = [about_third(top, edge(top) * share) for share in shares]
    return found + [about_third(turned, rest * share)[:, ::-1] for share in shares]


def draw_sphere(axes: Axes, **moments: float) -> None:
    """The sphere of 𝐋, the paths on it and the separatrix."""
    top = body(**moments)
    parts: list[pen.Part] = [pen.Sphere()]
    for sign in (1.0, -1.0):
        start = [sign * math.sin(edge(top)), 0.0, math.cos(edge(top))]
        both = ring(pen.ORIGIN, np.cross(start, [0.0, 1.0, 0.0]), 1.0, start, count=361)
        parts += [pen.on_sphere(sign * path, look.FIRST, lw=0.9) for path in paths(top)]
        parts.append(pen.on_sphere(both, look.SECOND, lw=1.7))
    parts += pen.frame(np.eye(3), 1.35, start=1.0, color=look.INK)
    parts.append(pen.Markers(np.eye(3), size=3))
    pen.picture(axes, parts, (-1.3, 1.3), (-1.05, 1.45), VIEW)


SPHERE = Drawing(
    "sphere",
    "Where the angular momentum goes",
    "1",
    MOMENTS,
    pen.alone(2.9, draw_sphere),
    r"The moments are $\lambda_1$, $\lambda_2$, $\lambda_3 = {lambda1}, {lambda2}, {lambda3}$ "
    "kg m². Thick: the separatrix, two circles through the ends of the middle axis, {edge:°} from "
    r"$\mathbf e_3$. Dashed: behind.",
    "A sphere with the three principal axes. Closed curves lie about the first axis and about the "
    "third; two thick circles, {edge:°} degrees from the third, cross at the second axis and part "
    "the curves.",
    lambda **moments: {"edge": edge(body(**moments))},
)

# --- The tumbling body ---------------------------------------------------------------------------

PUSH = Parameter("push", 0.01, r"push, $\delta/a_2$", above=0, most=1)
FLIPS, BOXES, APART = 3, 7, 2.6
FRONT = View(azimuth=0.0, elevation=0.3)


def path_of(push: float, **moments: float) -> Path:
    """Of a body that is spun with a₂ = 1 rad/s."""
    return Path(body(**moments), 1.0, push)


def tumbling(path: Path, shares: Floats) -> Trajectory:
    """The motion from the middle of a wait; a share of 1 is the end of the last wait."""
    motion = path.body.motion(omega=(0.0, path.a2, path.push))
    return motion.exact(shares * FLIPS * path.period / 2)


def attitudes(run: Trajectory) -> Floats:
    """The axes of the body (N, 3, 3), as columns, where 𝐋 points to the right."""
    momentum = run.angular_momentum[0]
    upright = Rotation.align_vectors([[0.0, 1.0, 0.0]], [momentum])[0]
    return np.asarray((upright * run.rotation).as_matrix())


def box(axes: Floats, sizes: Floats, centre: Floats) -> list[pen.Part]:
    """A body of half edges `sizes` with principal axes (3, 3), and its middle axis."""
    near = float(FRONT(axes[:, 1])[2]) > 0
    start, tip = (centre + length * axes[:, 1] for length in (sizes[1], sizes[1] + 0.55))
    parts: list[pen.Part] = [pen.Arrow(tip, "", look.AXIS, 1.4, start, z=4 if near else 2)]
    for k, (corners, normal) in enumerate(solids.faces(axes, sizes)):
        color = look.MANTLE if k < 4 else look.FACE
        parts.append(pen.Face(corners + centre, color, look.EDGE, z=3, normal=normal))
    return parts


def half_edges(moments: dict[str, float]) -> Floats:
    """Of a homogeneous box with these moments, the longest 1."""
    values = np.array([moments[p.name] for p in MOMENTS])
    edges = np.sqrt(np.maximum(values.sum() / 2 - values, 0.01 * values.max()))
    return np.asarray(edges / edges.max())


def draw_boxes(axes: Axes, push: float, shares: Floats, **moments: float) -> None:
    """The body at some moments, from the left to the right."""
    run = tumbling(path_of(push, **moments), np.concatenate([[0.0], shares]))
    parts: list[pen.Part] = []
    for k, turned in enumerate(attitudes(run)[1:]):
        parts += box(turned, half_edges(moments), np.array([0.0, APART * k, 0.0]))
    right = APART * (len(shares) - 0.5)
    pen.picture(axes, parts, (-APART / 2, right), (-APART / 2, APART / 2), FRONT)


def draw_rates(axes: Axes, push: float, until: float = 1.0, **moments: float) -> None:
    """ω₁, ω₂ and ω₃ by a₂, until a share of the time."""
    path = path_of(push, **moments)
    run = tumbling(path, until * np.linspace(0.0, 1.0, 901))
    rates = pen.three(run.t / (2 * math.pi), run.omega, "/a_2")
    last, most = FLIPS * path.period / (4 * math.pi), 1.05 * max(1.0, path.a1, path.a3)
    limits = {"xlim": (0, last), "ylim": (-most, most)}
    pen.chart(axes, rates, r"time  (turns, $2\pi/a_2$)", "", **limits)
    pen.legend_above(axes, ncols=3)


def _tumble(**values: float) -> Canvas:
    """The boxes stand over their times."""
    drawn, beside = Canvas(figsize=(look.TEXT, 3.0)), 0.8 / (BOXES - 1) / 2
    above = drawn.add_axes((0.11 - beside, 0.74, 0.8 + 2 * beside, 0.26))
    draw_boxes(above, shares=np.linspace(0, 1, BOXES), **values)
    draw_rates(drawn.add_axes((0.11, 0.15, 0.8, 0.47)), **values)
    return drawn


def _film(**values: float) -> Film:
    """The body above, what it did below."""

    def show(share: float, above: Axes, below: Axes) -> None:
        draw_boxes(above, shares=np.array([share]), **values)
        draw_rates(below, **values, until=share)

    return film(look.TEXT, 4.2, show, (0.3, 0.52, 0.4, 0.47), (0.1, 0.11, 0.87, 0.32))


def _facts(push: float, **moments: float) -> dict[str, Any]:
    path = path_of(push, **moments)
    log = 2 / path.p * math.log(4 * path.a3 / push)
    return {"turns": path.period / (4 * math.pi), "log": log / (2 * math.pi)}


TUMBLE = Drawing(
    "tumble",
    "A body that turns over",
    "4",
    (*MOMENTS, PUSH),
    _tumble,
    r"It has $\lambda_1$, $\lambda_2$, $\lambda_3 = {lambda1}, {lambda2}, {lambda3}$ kg m², and "
    r"$\delta/a_2 = {push}$; $\mathbf L$ points to the right. From one flip to the next it turns "
    r"{turns} times, by (4.8) {log} times. Above: the body with $\mathbf e_2$, over the time at "
    "which it stands so.",
    "Above, a box in seven positions, with an arrow along its middle axis, which points to the "
    "right, later to the left, and to the right again. Below, the three rates over the time: the "
    "second one stays at one value, jumps to the opposite one after {turns} turns, and back again; "
    "at each jump the other two have a pulse.",
    _facts,
    _film,
)

FIGURES = (SPHERE, TUMBLE)
