"""A top from the toy box: what it looks like, and what it does with the spin that it is given."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.sleeping_top import RPM
from rigidtop.derivations.exercises.toy_top import (
    free_of_the_table,
    measured,
    spinning_at,
    top_from_the_toy_box,
)
from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.bodies import time_to
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, View, arc, bow
from rigidtop.figures.style import Canvas, canvas
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
    size = max(stem_length, math.hypot(disc_radius, disc_height + disc_thickness / 2))
    e3 = np.array([0.0, math.sin(theta), math.cos(theta)])
    top, middle, half, height, centre = (
        length / size
        for length in (stem_length, disc_height, disc_radius, disc_thickness, centre_of_mass)
    )
    way = (top + 0.5) * arc(UPRIGHT, e3)
    pieces = ((0.0, middle), 1.5), ((middle + height / 2, top), 3.0)
    stem: Any = {"lw": 2.4, "cap": "butt", "label": "_stem"}
    parts: list[pen.Part] = [
        solids.table(),
        *(pen.Curve(np.outer(ends, e3), look.NOTE, z=z, **stem) for ends, z in pieces),
        *solids.disc(middle * e3, e3, half, height),
        pen.Mark(centre * e3, label="_centre", words=look.R_CM, shift=(5, -8)),
        pen.guide(np.outer([top, top + 0.62], e3)),
        pen.guide(np.outer([0.0, top + 0.62], UPRIGHT)),
        *pen.angle(way, r"$\theta$", (0, 2), out=1.05, color=look.GREY, lw=0.8, z=1),
        pen.Turning((top + 0.2) * e3, e3, 0.16, omega3, r"$\omega_3$"),
    ]
    pen.picture(axes, parts, (-1.02, 1.02), (-0.25, 1.85), VIEW)


# --- The path of its axis ------------------------------------------------------------------------


def touches(motion: TopMotion, touching: float) -> float | None:
    """When a top that is let go leans by `touching` (rad) for the first time, if it does (s)."""
    return None if motion.turning_points[1] < touching else time_to(motion, touching)


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
    theta, edge = np.degrees(run.theta), math.degrees(touching)
    x, y = theta * np.cos(run.phi), theta * np.sin(run.phi)
    # In the middle, if there is room.
    below = 0.0 if theta[0] > 0.45 * edge else 0.5 * float(theta.max() + edge)
    shift = (0, -3 if below else -11)
    parts = [
        pen.Curve((x, y), look.FIRST, 1.0, label="_path"),
        pen.Mark((x[0], y[0]), look.FIRST),
        pen.Curve(bow(edge), look.SECOND, 0.9, look.DOTTED),
        pen.Words((0.0, edge), "rim touches", (0, 3), look.SECOND, "center"),
        pen.Mark((0.0, 0.0), look.GREY, 6, "+"),
        pen.Words((0.0, -below), rf"$\theta = {theta[0]:.3g}°$", shift, ha="center"),
    ]
    pen.picture(axes, parts, (-1.04 * edge, 1.04 * edge), (-1.04 * edge, 1.25 * edge))


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
    high, at = 3 * rates[-1, 2], int(0.85 * len(spins))
    parts: list[pen.Part] = [
        pen.Rule(x=wakes * RPM, label="_sleeps"),
        pen.Words((wakes * RPM, high), "sleeps", (4, -1), va="top"),
    ]
    for k, color, style, words in styles:
        place = spins[at] * RPM, rates[at, k]
        parts += [
            pen.Curve((spins * RPM, rates[:, k]), color, 1.3, style, label=f"_{words}"),
            pen.Mark((given * RPM, marked[k]), color, 4.5, label=f"_{words} now"),
            pen.Words(place, words, (0, 5), color, "center"),
        ]
    limits = {"xlim": (0.9 * least * RPM, last * RPM), "ylim": (0.6 * rates[-1, 0], high)}
    pen.chart(axes, parts, "spin  (turns a minute)", "in a second", yscale="log", **limits)
    axes.yaxis.set_major_formatter("{x:g}")


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


def _facts(**values: float) -> dict[str, Any]:
    _, motion, touching = _top(values)
    facts = answers(top_from_the_toy_box, **values)
    end = touches(motion, touching)
    lowest, turns = motion.turning_points[1], 1 / facts["slow_turn"]
    facts |= {"lowest": lowest, "touching": touching, "end": end, "turns": turns}
    goes, falls = "for one turn, down to {lowest:°}", "goes round in small arches"
    if end is not None:
        goes = "until its rim touches the table, at {touching:°}, after {end} s"
        falls = "falls until the rim touches the table"
    return facts | {"goes": goes, "falls": falls}


TOY_TOP = Drawing(
    "toy-top",
    "A top from the toy box: its path, its precession and nutation against the spin",
    "",
    top_from_the_toy_box.parameters,
    _draw,
    "A top, a disc of {disc_mass} kg, radius {disc_radius} m and thickness {disc_thickness} m at "
    "{disc_height} m on a stem of {stem_mass} kg and {stem_length} m, with $g = {g}$ m/s², leaning "
    r"by $\theta = {theta:°}$, to scale. Right: its axis, $\theta$ outwards and $\phi$ around, let "
    r"go with {spin_rpm:4} turns a minute and $\boldsymbol\omega$ along $\mathbf e_3$, {goes}. "
    "Below: turns and nutations in a second, against the spin, at this tilt. In steady precession "
    "the axis takes {slow_turn} s for a turn; pushed a little, it nutates {nutation} times a "
    "second. Upright, it sleeps from {sleeping_rpm:4} turns a minute on. The spin has {energy} J, "
    "which could lift it by {height} m.",
    "A disc on a thin stem whose tip is on a table, leaning by {theta:°} degrees. Beside it the "
    "path of its axis from above, which {falls}, inside a dotted circle at the tilt, {touching:°} "
    "degrees, at which the rim touches. Below, the turns of the axis in a second fall with the "
    "spin and the nutations in a second rise: at {spin_rpm} turns a minute they are {turns} and "
    "{nutation}. A dotted line marks {sleeping_rpm} turns a minute, from which on the upright top "
    "sleeps.",
    _facts,
)
