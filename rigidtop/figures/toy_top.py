"""A top from the toy box: what it looks like, and what it does with the spin that it is given."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from scipy.optimize import brentq

from rigidtop.derivations.exercises.sleeping_top import RPM
from rigidtop.derivations.exercises.toy_top import (
    free_of_the_table,
    measured,
    spinning_at,
    top_from_the_toy_box,
)
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.rotors import sense_of_turn, solid_disc
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, Scene, View, arc, paper, ring
from rigidtop.figures.style import canvas, degrees, name_at, said, spoken
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop

VIEW = View(azimuth=0.0, elevation=0.2)

SAMPLES = 30, 20_001
"""For each nutation, and at most: where there are more they are too small to be seen."""

DISC = ("disc_radius", "disc_thickness", "disc_height")
BODY = ("disc_mass", *DISC, "stem_mass", "stem_length", "g")
"""Names of parameters."""


# --- The top, to scale ---------------------------------------------------------------------------


def draw_toy_top(
    axes: Axes,
    theta: float,
    omega3: float,
    centre_of_mass: float,
    *,
    disc_radius: float,
    disc_thickness: float,
    disc_height: float,
    stem_length: float,
) -> None:
    """Disc, stem and centre of mass (a dot) to scale, leaning to the right in the yz plane."""
    scene = Scene(axes, VIEW)
    size = max(stem_length, math.hypot(disc_radius, disc_height + disc_thickness / 2))
    e3 = np.array([0.0, math.sin(theta), math.cos(theta)])
    top, middle = stem_length / size, disc_height / size
    half, height = disc_radius / size, disc_thickness / size
    ground = ring(np.zeros(3), UPRIGHT, 0.75, VIEW.axes[0])
    scene.face(ground, fc=look.GROUND, ec=look.RULE, lw=0.6, zorder=0)
    upper = middle + height / 2
    for ends, order in (((0.0, middle), 1.5), ((upper, top), 3.0)):
        style = {"lw": 2.4, "solid_capstyle": "butt", "zorder": order, "label": "_stem"}
        scene.line(np.outer(ends, e3), color=look.NOTE, **style)
    solid_disc(scene, middle * e3, e3, half, height, zorder=2)
    centre = centre_of_mass / size * e3
    scene.dot(centre, label="_centre")
    scene.words(centre, look.R_CM, (5, -8), color=look.INK, zorder=8)
    scene.line([top * e3, (top + 0.62) * e3], color=look.GREY, lw=0.8, zorder=1)
    scene.line(np.outer([0.0, top + 0.62], UPRIGHT), color=look.GREY, lw=0.8, zorder=1)
    way = (top + 0.5) * arc(UPRIGHT, e3)
    scene.line(way, color=look.GREY, lw=0.9, zorder=1)
    scene.words(1.05 * way[30], r"$\theta$", (0, 2), color=look.INK, ha="center")
    sense_of_turn(scene, (top + 0.2) * e3, e3, 0.16, omega3, r"$\omega_3$", zorder=4)
    paper(axes, (-1.02, 1.02), (-0.25, 1.85))


# --- The path of its axis ------------------------------------------------------------------------


def touches(motion: TopMotion, touching: float) -> float | None:
    """When a top that is let go leans by `touching` (rad) for the first time, if it does (s)."""
    if motion.turning_points[1] < touching:
        return None

    def above(t: float) -> float:
        return float(motion.exact(t).theta[0]) - touching

    return float(brentq(above, 0.0, motion.nutation_period / 2, xtol=1e-14, rtol=1e-13))


def time_shown(motion: TopMotion, touching: float) -> float:
    """For one turn of the axis (s), or until the rim touches."""
    end = touches(motion, touching)
    return 2 * math.pi / abs(motion.mean_precession) if end is None else end


def draw_path_from_above(axes: Axes, motion: TopMotion, touching: float) -> None:
    """Where e₃ leans: θ as the distance from the middle, φ as the angle.

    Dotted is the tilt at which the rim touches the table.
    """
    last = time_shown(motion, touching)
    each, most = SAMPLES
    count = min(1001 + each * int(min(last / motion.nutation_period, most)), most)
    run = motion.exact(np.linspace(0.0, last, count))
    theta, phi = np.degrees(run.theta), run.phi
    axes.plot(theta * np.cos(phi), theta * np.sin(phi), color=look.FIRST, lw=1.0, label="_path")
    axes.plot(theta[0] * np.cos(phi[0]), theta[0] * np.sin(phi[0]), "o", color=look.FIRST, ms=3.5)
    edge = math.degrees(touching)
    around = np.linspace(0, 2 * math.pi, 241)
    axes.plot(
        edge * np.cos(around), edge * np.sin(around), color=look.SECOND, lw=0.9, ls=look.DOTTED
    )
    name_at(axes, 0.0, edge, "rim touches", (0, 3), color=look.SECOND, ha="center")
    axes.plot(0, 0, "+", color=look.GREY, ms=6)
    # In the middle, if there is room.
    below = 0.0 if theta[0] > 0.45 * edge else 0.5 * float(theta.max() + edge)
    words = rf"$\theta = {theta[0]:.3g}°$"
    name_at(axes, 0.0, -below, words, (0, -11 if not below else -3), color=look.INK, ha="center")
    paper(axes, (-1.04 * edge, 1.04 * edge), (-1.04 * edge, 1.25 * edge))


# --- Against the spin ----------------------------------------------------------------------------


def draw_against_spin(axes: Axes, top: HeavyTop, theta: float, omega3: float) -> None:
    """Turns of the axis and nutations in a second at the tilt `theta`, against the spin (rpm).

    The dots are at the spin `omega3` (rad/s); dotted is the spin from which on the top sleeps.
    """
    least, wakes, given = top.smallest_spin(theta), top.sleeping_spin(), abs(omega3)
    last = max(2.0 * wakes, 1.25 * given)
    spins = least + (last - least) * np.linspace(1e-6, 1.0, 300) ** 2
    rates = np.array([spinning_at(top, theta, float(spin)) for spin in spins]) / (2 * math.pi)
    marked = np.array(spinning_at(top, theta, given)) / (2 * math.pi)
    styles = ((2, look.SECOND, look.DASHED, "nutations"), (0, look.FIRST, "-", "turns of the axis"))
    for k, color, style, words in styles:
        axes.plot(spins * RPM, rates[:, k], color=color, ls=style, label=f"_{words}")
        axes.plot(given * RPM, marked[k], "o", color=color, ms=4.5, label=f"_{words} now")
        at = int(0.85 * len(spins))
        name_at(axes, spins[at] * RPM, rates[at, k], words, (0, 5), color=color, ha="center")
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter("{x:g}")
    axes.set(xlim=(0.9 * least * RPM, last * RPM), ylim=(0.6 * rates[-1, 0], 3 * rates[-1, 2]))
    axes.axvline(wakes * RPM, color=look.GREY, lw=0.9, ls=look.DOTTED, label="_sleeps")
    name_at(axes, wakes * RPM, 3 * rates[-1, 2], "sleeps", (4, -1), va="top", color=look.INK)
    axes.set(xlabel="spin  (turns a minute)", ylabel="in a second")


# --- Together ------------------------------------------------------------------------------------


def _top(values: dict[str, float]) -> tuple[HeavyTop, TopMotion, float]:
    """The top, let go with ω along e₃, and the tilt at which its rim touches the table."""
    top = measured(**{name: values[name] for name in BODY})
    theta = values["theta"]
    touching = free_of_the_table(theta, **{name: values[name] for name in DISC})
    spinning_at(top, theta, values["omega3"])  # says so where it falls
    return top, top.motion(theta=theta, omega3=values["omega3"]), touching


def _draw(**values: float) -> Canvas:
    top, motion, touching = _top(values)
    drawn = canvas(look.COLUMN, 3.2)
    parts = drawn.subplot_mosaic([["top", "path"], ["chart", "chart"]], height_ratios=(1.1, 1))
    sizes = {name: values[name] for name in (*DISC, "stem_length")}
    draw_toy_top(parts["top"], values["theta"], values["omega3"], top.R, **sizes)
    draw_path_from_above(parts["path"], motion, touching)
    draw_against_spin(parts["chart"], top, values["theta"], values["omega3"])
    return drawn


def _caption(**values: float) -> str:
    _, motion, touching = _top(values)
    found = answers(top_from_the_toy_box, **values)
    lowest = motion.turning_points[1]
    end = touches(motion, touching)
    goes = f"for one turn, down to {degrees(lowest)}"
    if end is not None:
        goes = f"until its rim touches the table, at {degrees(touching)}, after {said(end)} s"
    return (
        f"A top, a disc of {said(values['disc_mass'])} kg, radius {said(values['disc_radius'])} m "
        f"and thickness {said(values['disc_thickness'])} m at {said(values['disc_height'])} m on a "
        f"stem of {said(values['stem_mass'])} kg and {said(values['stem_length'])} m, with $g = "
        f"{said(values['g'])}$ m/s², leaning by $θ = {degrees(values['theta'])}$, to scale. "
        f"Right: its axis, $θ$ outwards and $φ$ around, let go with {said(found['spin_rpm'], 4)} "
        f"turns a minute and $𝛚$ along $e₃$, {goes}. Below: turns and nutations in a second, "
        f"against the spin, at this tilt. In steady precession the axis takes "
        f"{said(found['slow_turn'])} s for a turn; pushed a little, it nutates "
        f"{said(found['nutation'])} times a second. Upright, it sleeps from "
        f"{said(found['sleeping_rpm'], 4)} turns a minute on. The spin has "
        f"{said(found['energy'])} J, which could lift it by {said(found['height'])} m."
    )


def _in_words(**values: float) -> str:
    _, motion, touching = _top(values)
    found = answers(top_from_the_toy_box, **values)
    end = touches(motion, touching)
    path = "goes round in small arches" if end is None else "falls until the rim touches the table"
    return (
        "A disc on a thin stem whose tip is on a table, leaning by "
        f"{spoken(math.degrees(values['theta']))} degrees. Beside it the path of its axis from "
        f"above, which {path}, inside a dotted circle at the tilt, "
        f"{spoken(math.degrees(touching))} degrees, at which the rim touches. Below, the turns of "
        "the axis in a second fall with the spin and the nutations in a second rise: at "
        f"{spoken(found['spin_rpm'])} turns a minute they are "
        f"{spoken(1 / found['slow_turn'])} and {spoken(found['nutation'])}. A dotted line marks "
        f"{spoken(found['sleeping_rpm'])} turns a minute, from which on the upright top sleeps."
    )


TOY_TOP = Drawing(
    "toy-top",
    "A top from the toy box: its path, its precession and nutation against the spin",
    "",
    top_from_the_toy_box.parameters,
    _draw,
    _caption,
    _in_words,
)
