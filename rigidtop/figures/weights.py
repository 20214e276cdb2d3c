"""The weights of a body of points, and one weight at its centre of mass (section 3.5.1)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.net_torque import POINTS, gravity_on_points
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import Scene, View, paper, total, unit
from rigidtop.figures.style import Floats, alone, said, spoken

VIEW = View(azimuth=0.6, elevation=0.36)


@dataclass(frozen=True)
class Points:
    """Mass points (kg; m from the pivot), held together and held at the pivot, and g (m/s²)."""

    masses: Floats
    places: Floats
    g: float

    @property
    def weights(self) -> Floats:
        """The force on each (N, 3), N."""
        made: Floats = self.masses[:, None] * np.array([0.0, 0.0, -self.g])
        return made

    @property
    def centre(self) -> Floats:
        """R_CM (3,), m."""
        made: Floats = self.masses @ self.places / self.masses.sum()
        return made

    @property
    def torque(self) -> Floats:
        """N = Σ r × mg (3,), N m."""
        return total(np.cross(self.places, self.weights))


def points(g: float, **given: float) -> Points:
    """As the exercise names them: m1, x1, y1, z1, and so on."""
    numbers = range(1, POINTS + 1)
    masses = np.array([given[f"m{k}"] for k in numbers])
    return Points(masses, np.array([[given[f"{x}{k}"] for x in "xyz"] for k in numbers]), g)


@dataclass(frozen=True)
class Sketch:
    """What is drawn: places with the farthest at 1, weights to a scale of their own, and N."""

    places: Floats
    weights: Floats
    centre: Floats
    couple: Floats


def sketch(body: Points) -> Sketch:
    """Lengths for the paper; all weights together have the length 0.75, N has 0.6."""
    reach = float(np.linalg.norm(body.places, axis=1).max()) or 1.0
    weights = 0.75 * body.weights / np.linalg.norm(body.weights, axis=1).sum()
    return Sketch(body.places / reach, weights, body.centre / reach, 0.6 * unit(body.torque))


def draw_weights(axes: Axes, body: Points) -> None:
    """Each point with its weight, the whole weight at the centre of mass, and the torque of both.

    The paper is as large as they need.
    """
    scene, drawn = Scene(axes, VIEW), sketch(body)
    for tip, words in zip(0.45 * np.eye(3), look.SPACE, strict=True):
        scene.arrow(tip, words, color=look.GREY, lw=0.7, zorder=1.5)
    for k, place in enumerate(drawn.places):
        size = 9 * float(np.cbrt(body.masses[k] / body.masses.max()))  # as balls of one material
        _draw_point(scene, place, drawn.weights[k], f"$m_{k + 1}$", size)
    end = drawn.centre + drawn.weights.sum(axis=0)
    scene.arrow(end, look.WEIGHT, start=drawn.centre, color=look.INK, lw=2.0)
    scene.arrow(drawn.centre, color=look.INK, lw=1.6, zorder=5.5)
    scene.dot(drawn.centre, ms=4)
    side, shift = ("left", (5, 3)) if _room_on_the_right(drawn) else ("right", (-5, 3))
    scene.words(drawn.centre, look.R_CM, shift, color=look.INK, ha=side, zorder=8)
    scene.couple(drawn.couple, (10, -22))
    under = drawn.places + drawn.weights
    x, y, _ = scene.view(np.vstack([0.55 * np.eye(3), drawn.places, under, end, drawn.couple]))
    paper(axes, (x.min() - 0.2, x.max() + 0.2), (y.min() - 0.15, y.max() + 0.15))


def _room_on_the_right(drawn: Sketch) -> bool:
    """Whether the name of the centre of mass is farther from balls and other names on the right."""
    x, y, _ = VIEW(drawn.centre)
    balls = np.column_stack(VIEW(drawn.places)[:2])
    above = balls + np.array([0.0, 0.09])
    tips = np.column_stack(VIEW(np.vstack([0.55 * np.eye(3), 1.15 * drawn.couple]))[:2])
    others = np.vstack([balls, above, tips])
    right, left = (np.linalg.norm(others - [x + k * 0.1, y + 0.03], axis=1).min() for k in (1, -1))
    return bool(right >= left)


def _draw_point(scene: Scene, place: Floats, weight: Floats, words: str, size: float) -> None:
    """A ball on its rod, its weight, and a plumb line to the plane of x̂ and ŷ."""
    scene.line([np.zeros(3), place], color=look.RULE, lw=2.0, zorder=2)
    foot = np.array([place[0], place[1], 0.0])
    scene.line([place, foot], color=look.GREY, lw=0.7, ls=look.DOTTED, zorder=1)
    scene.line(foot, ".", color=look.GREY, ms=3, zorder=1)
    scene.arrow(place + weight, start=place, color=look.FIRST, lw=1.3)
    scene.dot(place, ms=size, mfc=look.FACE, mec=look.EDGE, mew=0.8, zorder=6)
    scene.words(place, words, (0, 0.5 * size + 3), color=look.INK, ha="center", zorder=7)


def _caption(**values: float) -> str:
    body, found = points(**values), answers(gravity_on_points, **values)
    masses = ", ".join(f"$m{'₁₂₃'[k]} = {said(mass)}$" for k, mass in enumerate(body.masses))
    centre = ", ".join(said(found[f"centre_{letter}"]) for letter in "xyz")
    turning = "which is zero here"
    if np.any(body.torque):
        parts = ", ".join(said(found[f"torque_{letter}"] + 0.0) for letter in "xyz")
        turning = f"here ({parts}) N m, of the magnitude {said(_size(found))} N m"
    return (
        f"Three masses, {masses} kg, held together by light rods and held at the origin, and their "
        f"weights at $g = {said(values['g'])}$ m/s². The whole mass $M = {said(found['mass'])}$ "
        f"kg at the centre of mass, $𝐑_CM = ({centre})$ m, has their torque: $Σ 𝐫ₖ × mₖ𝐠 = "
        f"𝐑_CM × M𝐠$, {turning}; and their potential energy, {said(found['potential'])} J. Weights "
        "are drawn to one scale, places to another; dotted lines lead to the plane of $x̂$ and $ŷ$."
    )


def _size(found: dict[str, float]) -> float:
    """The magnitude of the torque, N m."""
    return math.hypot(*(found[f"torque_{letter}"] for letter in "xyz"))


def _in_words(**values: float) -> str:
    body, found = points(**values), answers(gravity_on_points, **values)
    height = spoken(found["centre_z"])
    seen = (
        "Three balls at the ends of rods from one point, each with an arrow down, its weight. "
        f"From the same point R_CM leads to the centre of mass, {height} metres above it, where "
        "one arrow Mg points down, as long as the other three together. "
    )
    if np.any(body.torque):
        return seen + (
            f"The torque N, {spoken(_size(found))} newton metres, is horizontal and at right "
            "angles to R_CM."
        )
    return seen + "There is no torque."


WEIGHTS = Drawing(
    "weights",
    "The weights of three points, and one at their centre of mass",
    "",
    gravity_on_points.parameters,
    alone(2.7, lambda axes, **values: draw_weights(axes, points(**values))),
    _caption,
    _in_words,
)
