"""Masses held: two on a turning stick (opening of 3.2), three points and a solid cone (3.5.1)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.net_torque import POINTS, gravity_on_a_solid, gravity_on_points
from rigidtop.derivations.exercises.opening import two_masses
from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.bodies import vertical
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, View, arc, circle, ring, total, unit
from rigidtop.figures.style import Floats, degrees, said
from rigidtop.motion.attitude import from_euler_angles

# --- Two masses on a stick that a bearing turns about a tilted axis ------------------------------

VIEW_TWO_MASSES = View(azimuth=-0.35, elevation=0.5)
"""So that what points at the reader goes down and to the right."""

SHORT = 0.15
"""No room for a name along an arm of this length, or between stick and axis."""


class Stick(NamedTuple):
    """Two masses (kg) on a stick in the yz plane that turns about ẑ, at one moment (SI units)."""

    masses: Floats
    positions: Floats
    omega: Floats
    momentum: Floats
    """L (3,), J s."""
    torque: Floats
    """N = ω × L (3,), which turns L along with the stick, N m."""
    force: Floats
    """F (3,), which keeps the centre of mass on its circle, N."""


def stick(M_1: float, M_2: float, a: float, b: float, alpha: float, omega: float) -> Stick:
    """The first mass above the bearing and to the right of the axis."""
    along = np.array([0.0, math.sin(alpha), math.cos(alpha)])
    masses, positions, turn = np.array([M_1, M_2]), np.outer([a, -b], along), omega * UPRIGHT
    momenta = np.cross(positions, masses[:, None] * np.cross(turn, positions))
    torque = total(np.cross(turn, momenta), omega * float(np.linalg.norm(momenta)))
    force = total(masses[:, None] * np.cross(turn, np.cross(turn, positions)))
    return Stick(masses, positions, turn, total(momenta), torque, force)


def draw_two_masses(axes: Axes, held: Stick) -> None:
    """ω, L, the torque N and the force F of the bearing, which has each a length of its own.

    The masses lie to scale, the longer arm has the length 1; the circles are their ways.
    """
    places = held.positions / np.linalg.norm(held.positions, axis=1).max()
    along, momentum, turning = unit(places[0]), 1.15 * unit(held.momentum), unit(held.torque)
    angle = 0.5 * arc(UPRIGHT, along)
    narrow = (-9, 0) if float(along[1]) < SHORT else (0, 0)
    beside = None if momentum[1] < -0.15 else (-9.0, -2.0)
    parts: list[pen.Part] = [
        pen.Curve([-1.05 * UPRIGHT, pen.ORIGIN], look.RULE, 3.5, z=1, cap="butt"),
        pen.Curve(places, look.NOTE, 2.6, z=4, label="_stick"),
        pen.guide([pen.ORIGIN, 0.55 * along], z=2),
        *pen.angle(angle, r"$\alpha$", narrow, look.NOTE, 1.12, color=look.GREY, lw=0.8, z=3),
        pen.Arrow(1.4 * UPRIGHT, look.OMEGA_VEC, look.OMEGA, 1.7, shift=(9, -2)),
        pen.Arrow(momentum, look.L_VEC, look.MOMENTUM, 1.9, shift=beside, z=5.2),
        pen.couple(turning, (8, -12)),
        pen.Markers(pen.ORIGIN),
    ]
    for k, place in enumerate(places):
        parts += _mass(k, place, 12 * float(np.cbrt(held.masses[k] / held.masses.max())))
    if np.any(held.force):
        parts.append(pen.Arrow(0.55 * unit(held.force), r"$\mathbf{F}$", lw=1.2, shift=(0, 9)))
    if np.any(turning):
        parts.append(pen.Arrow(momentum + 0.5 * turning, "", look.TORQUE, 1.2, start=momentum))
        parts.append(pen.Words(momentum, look.L_DOT, (-4, -17), look.TORQUE, "right"))
    pen.picture(axes, parts, (-1.5, 1.5), (-1.15, 1.35), VIEW_TWO_MASSES)


def _mass(k: int, place: Floats, size: float) -> list[pen.Part]:
    """A ball as one of the same material as the other, its way, and the name of its arm."""
    distance = float(np.linalg.norm(place))
    tilt = math.acos(float(np.clip(place[2] / distance, -1, 1)))
    way = circle(UPRIGHT, tilt, length=distance)
    short = distance < SHORT  # beside F, which may lie there
    aside = (0.5 * size + 3) * (1 - 2 * k), (5, -14)[k] if short else -3
    parts: list[pen.Part] = [
        pen.round_axis(way, look.GREY, lw=0.8, ls=look.DASHED),
        pen.Markers(place, size=size, fill=look.FACE, edge=look.EDGE, width=0.8, z=6),
        pen.Words(place, f"$M_{k + 1}$", aside, ha=("left", "right")[k]),
    ]
    across = 8 * unit([place[2], -place[1]])
    shift = float(across[0]), float(across[1])
    arm = pen.Words(0.62 * place, ("$a$", "$b$")[k], shift, look.NOTE, "center", "center", z=7)
    return parts if short else [*parts, arm]


def _facts_two_masses(**values: float) -> dict[str, Any]:
    held, facts = stick(**values), answers(two_masses, **values)
    turns, pulls = np.any(held.torque), np.any(held.force)
    bearing = "$L$ stays where it is: the bearing exerts no torque"
    if turns:
        bearing = (
            r"As $\mathbf L$ turns with the stick, the bearing exerts the torque $\mathbf N = "
            r"\boldsymbol\omega \times \mathbf L$ of {torque} N m, out of the plane of the paper"
        )
    across = "The torque N points out of the paper, across the plane of stick and omega."
    push = "the force $F = {force}$ N, from the centre of mass to the axis"
    side = "left" if held.force[1] < 0 else "right"
    pushes = f" The force F of the bearing points to the {side}, at right angles to omega."
    return facts | {
        "couple": bearing,
        "push": push if pulls else "no force, as it holds the centre of mass",
        "turns": across if turns else "There is no torque.",
        "pushes": pushes if pulls else "",
    }


TWO_MASSES = Drawing(
    "two-masses",
    r"Two masses on a stick: $\boldsymbol\omega$, $\mathbf L$, and what the bearing exerts",
    "",
    two_masses.parameters,
    pen.alone(2.8, lambda axes, **values: draw_two_masses(axes, stick(**values))),
    "Two masses on a stick, $M_1 = {M_1}$ kg at $a = {a}$ m and $M_2 = {M_2}$ kg at $b = {b}$ m, "
    r"which a bearing turns at $\omega = {omega}$ rad/s, tilted by $\alpha = {alpha:°}$. "
    r"$\mathbf L$ is at right angles to the stick, {angle:°} from $\boldsymbol\omega$, of "
    "magnitude {angular_momentum} J s. {couple}, and {push}. Grey: the shaft of the bearing. "
    "Directions are computed, lengths of arrows are not to one scale.",
    "A stick with a mass at either end goes through a bearing, tilted by {alpha:°} degrees against "
    "the upright arrow omega; dashed circles about omega are the ways of the masses. The arrow L "
    "leans to the other side, {angle:°} degrees from omega, at right angles to the stick. "
    "{turns}{pushes}",
    _facts_two_masses,
    asked={"M_1": 1.0, "M_2": 1.2, "a": 0.5, "b": 0.3, "alpha": math.radians(40), "omega": 2.0},
)

# --- The weights of a body of points, and one weight at its centre of mass -----------------------

VIEW_WEIGHTS = View(azimuth=0.6, elevation=0.36)


@dataclass(frozen=True)
class Points:
    """Mass points (kg; m from the pivot), held together and held at the pivot, and g (m/s²)."""

    masses: Floats
    places: Floats
    g: float

    @property
    def weights(self) -> Floats:
        """The force on each (N, 3), N."""
        return np.outer(self.masses, -self.g * UPRIGHT)

    @property
    def centre(self) -> Floats:
        """R_CM (3,), m."""
        return np.average(self.places, axis=0, weights=self.masses)

    @property
    def torque(self) -> Floats:
        """N = Σ r × mg (3,), N m."""
        return total(np.cross(self.places, self.weights))


def points(g: float, **given: float) -> Points:
    """As the exercise names them: m1, x1, y1, z1, and so on."""
    numbers = range(1, POINTS + 1)
    masses = np.array([given[f"m{k}"] for k in numbers])
    return Points(masses, np.array([[given[f"{x}{k}"] for x in "xyz"] for k in numbers]), g)


def draw_weights(axes: Axes, body: Points) -> None:
    """Each point with its weight, the whole weight at the centre of mass, and the torque of both.

    The farthest point is at the distance 1; all weights together have the length 0.75, N has 0.6.
    """
    reach = float(np.linalg.norm(body.places, axis=1).max()) or 1.0
    places, centre, couple = body.places / reach, body.centre / reach, 0.6 * unit(body.torque)
    weights = 0.75 * body.weights / np.linalg.norm(body.weights, axis=1).sum()
    right = _room_on_the_right(centre, places, np.vstack([0.55 * np.eye(3), 1.15 * couple]))
    side, shift = ("left", (5, 3)) if right else ("right", (-5, 3))
    frame = pen.frame(np.eye(3), 0.45, look.SPACE, color=look.GREY, lw=0.7, z=1.5)
    parts: list[pen.Part] = [*frame]
    for k, place in enumerate(places):
        size = 9 * float(np.cbrt(body.masses[k] / body.masses.max()))  # as balls of one material
        parts += _point(place, weights[k], f"$m_{k + 1}$", size)
    parts += [
        pen.Arrow(centre + weights.sum(axis=0), look.WEIGHT, lw=2.0, start=centre),
        pen.Arrow(centre, lw=1.6, z=5.5),
        pen.Markers(centre, size=4, words=look.R_CM, shift=shift, ha=side),
        pen.couple(couple, (10, -22)),
    ]
    pen.fit(axes, parts, VIEW_WEIGHTS, (0.12, 0.12, 0.1, 0.1))


def _room_on_the_right(centre: Floats, places: Floats, tips: Floats) -> bool:
    """Whether the name of the centre of mass is farther from balls and other names on the right."""
    x, y, _ = VIEW_WEIGHTS(centre)
    balls, names = (np.column_stack(VIEW_WEIGHTS(each)[:2]) for each in (places, tips))
    others = np.vstack([balls, balls + np.array([0.0, 0.09]), names])
    right, left = (np.linalg.norm(others - [x + k * 0.1, y + 0.03], axis=1).min() for k in (1, -1))
    return bool(right >= left)


def _point(place: Floats, weight: Floats, words: str, size: float) -> list[pen.Part]:
    """A ball on its rod, its weight, and a plumb line to the plane of x̂ and ŷ."""
    foot = place * [1.0, 1.0, 0.0]
    return [
        pen.Curve([pen.ORIGIN, place], look.RULE, 2.0),
        pen.Curve([place, foot], look.GREY, 0.7, look.DOTTED, z=1),
        pen.Markers(foot, look.GREY, 3, ".", z=1),
        pen.Arrow(place + weight, "", look.FIRST, 1.3, start=place),
        pen.Markers(place, size=size, fill=look.FACE, edge=look.EDGE, width=0.8, z=6),
        pen.Words(place, words, (0, 0.5 * size + 3), ha="center", z=7),
    ]


def _facts_weights(**values: float) -> dict[str, Any]:
    body, facts = points(**values), answers(gravity_on_points, **values)
    masses = ", ".join(f"$m_{k + 1} = {said(mass)}$" for k, mass in enumerate(body.masses))
    centre, torque = "{centre_x}, {centre_y}, {centre_z}", "{torque_x}, {torque_y}, {torque_z}"
    facts |= {f"torque_{letter}": facts[f"torque_{letter}"] + 0.0 for letter in "xyz"}
    facts |= {"masses": masses, "centre": centre}
    facts["size"] = math.hypot(*(facts[f"torque_{letter}"] for letter in "xyz"))
    if not np.any(body.torque):
        return facts | {"turning": "which is zero here", "torque": "There is no torque."}
    turning = f"here ({torque}) N m, of the magnitude {{size}} N m"
    across = "The torque N, {size} newton metres, is horizontal and at right angles to R_CM."
    return facts | {"turning": turning, "torque": across}


WEIGHTS = Drawing(
    "weights",
    "The weights of three points, and one at their centre of mass",
    "",
    gravity_on_points.parameters,
    pen.alone(2.7, lambda axes, **values: draw_weights(axes, points(**values))),
    "Three masses, {masses} kg, held together by light rods and held at the origin, and their "
    "weights at $g = {g}$ m/s². The whole mass $M = {mass}$ kg at the centre of mass, "
    r"$\mathbf R_{\text{CM}} = ({centre})$ m, has their torque: $\sum \mathbf r_k "
    r"\times m_k\mathbf g = \mathbf R_{\text{CM}} \times M\mathbf g$, {turning}; and their "
    "potential energy, {potential} J. Weights are drawn to one scale, places to another; dotted "
    r"lines lead to the plane of $\hat{\mathbf x}$ and $\hat{\mathbf y}$.",
    "Three balls at the ends of rods from one point, each with an arrow down, its weight. From the "
    "same point R_CM leads to the centre of mass, {centre_z} metres above it, where one arrow Mg "
    "points down, as long as the other three together. {torque}",
    _facts_weights,
)

# --- A solid cone that stands on its tip and leans -----------------------------------------------

TALL = 1.4
"""Of the arrow ẑ, where the mantle of the cone has the length 1."""

NARROW = 0.15
"""An arc that goes less far has no room for a name."""


def view_of(phi: float) -> View:
    """From where a cone that leans towards the azimuth `phi` (rad) leans to the right, and what
    points into the paper goes up and to the left."""
    return View(azimuth=phi - math.pi / 2 - 0.3, elevation=0.42)


def draw_leaning_cone(
    axes: Axes, radius: float, height: float, theta: float, phi: float, **others: float
) -> None:
    """The cone (m), its centre of mass and N.

    The cone is to scale, its mantle has the length 1; Mg and N have lengths of their own.  The
    paper is as large as they need.
    """
    view, attitude = view_of(phi), from_euler_angles(theta, phi, 0.0).as_matrix()
    e3, nodes = attitude[:, 2], attitude[:, 1]
    level = np.array([math.cos(phi), math.sin(phi), 0.0])  # where it leans to
    size = math.hypot(radius, height)
    shape = {"radius": radius, "height": height, "theta": theta, "phi": phi}
    place = answers(gravity_on_a_solid, **shape, **others)["R"] / size * e3
    weight = place - 0.42 * UPRIGHT
    way = ring(pen.ORIGIN, nodes, 1.18, UPRIGHT, theta, 61)
    upright = vertical(theta)
    parts: list[pen.Part] = [
        *solids.cone(e3, height / size, radius / size),
        pen.Arrow(TALL * UPRIGHT, look.Z, look.GREY, 0.8, shift=(-8, 0)),
        pen.Arrow(1.35 * e3, look.E3, look.AXIS, 1.0, shift=(9, 0)),
        pen.Arrow(place, lw=2.0),
        *_height(place, level),
        pen.Arrow(weight, start=place),
        pen.Words(weight, look.WEIGHT, (6, 2)),
        pen.Markers(place, words=look.R_CM, shift=(7, -9)),
        pen.couple(0.0 * nodes if upright else 0.85 * nodes, (20, -4)),
    ]
    if not upright:
        parts += [*_angle(view, way, r"$\theta$", (-8, -2), 3), *_azimuth(view, phi, level)]
    pen.fit(axes, parts, view, (0.2, 0.1, 0.05, 0.08))


def _azimuth(view: View, phi: float, level: Floats) -> list[pen.Part]:
    """The azimuth from x̂ to the direction into which the cone leans, under it."""
    way = ring(pen.ORIGIN, UPRIGHT, 0.4, [1.0, 0.0, 0.0], math.remainder(phi, 2 * math.pi), 61)
    return [
        pen.Arrow([0.6, 0.0, 0.0], look.X, look.GREY, 0.7, z=1.5),
        pen.guide([pen.ORIGIN, 0.5 * level], ls=look.DOTTED, z=1.5),
        *_angle(view, way, degrees(phi), (2, -8), 1.5),
    ]


def _angle(view: View, way: Floats, words: str, aside: pen.Shift, z: float) -> list[pen.Part]:
    """An arc (N, 3) about the origin, and its name: outside, or `aside` where there is no room."""
    x, y, _ = view(way)
    narrow = float(np.linalg.norm(way[-1] - way[0])) < NARROW
    k = 0 if narrow else 2 * len(way) // 5
    away = (8 if words.startswith("$") else 15) / math.hypot(x[k], y[k])
    shift = aside if narrow else (float(x[k]) * away, float(y[k]) * away)
    arc = pen.Curve(way, look.NOTE, 0.8, z=z, label="_angle")
    return [arc, pen.Words(way[k], words, shift, look.NOTE, "center", "center", z=z)]


def _height(place: Floats, level: Floats) -> list[pen.Part]:
    """R cos θ, the height of the centre of mass over the tip, on the other side of ẑ."""
    beyond, height = -0.62 * level, place[2] * UPRIGHT
    top = beyond + height
    return [
        pen.guide([place, 1.1 * beyond + height], ls=look.DASHED, z=2.9),
        pen.guide([pen.ORIGIN, 1.1 * beyond], ls=look.DASHED, z=2.9),
        pen.Arrow(top, "", look.NOTE, 0.8, beyond, z=3, size=(0.12, 0.25), ends="<|-|>"),
        pen.Words((beyond + top) / 2, r"$R\,\cos\theta$", (-4, 0), look.NOTE, "right", "center"),
    ]


def _facts_leaning_cone(theta: float, **others: float) -> dict[str, Any]:
    facts = answers(gravity_on_a_solid, theta=theta, **others)
    if vertical(theta):
        leans = r"on the vertical, $\theta = {theta:°}$, where it has no azimuth and $N = 0$"
        return facts | {"leans": leans, "turning": "There is no torque, as the axis is vertical."}
    leans = (
        r"leaning at $\theta = {theta:°}$ towards the azimuth {phi:°}; $\mathbf N$, along "
        r"$\mathbf e_2'$, of magnitude $MgR \sin\theta = {torque}$ N m, is horizontal"
    )
    turning = "The torque N points horizontally into the paper, at right angles to e3 and z."
    return facts | {"leans": leans, "turning": turning}


LEANING_CONE = Drawing(
    "leaning-cone",
    "A solid cone on its tip: torque and potential energy",
    "",
    gravity_on_a_solid.parameters,
    pen.alone(3.0, draw_leaning_cone),
    "A solid cone on its tip, of radius {radius} m, height {height} m and density {density} kg/m³, "
    "{leans}. The centre of mass of the cone is at $R = {R}$ m, three quarters of its height, and "
    "with $M = {mass}$ kg and $g = {g}$ m/s² its potential energy is "
    r"$MgR \cos\theta = {potential}$ J. The cone is to scale, the arrows are not.",
    "A cone that stands on its tip, its axis e3 at {theta:°} degrees to the upright z. R_CM leads "
    "from the tip to the centre of mass, {R} metres, from which the weight Mg points down. Beside "
    "it its height over the tip is marked, R cos theta. {turning}",
    _facts_leaning_cone,
)
