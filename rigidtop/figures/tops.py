"""Tops as one sees them: the arrows of torque, a top going round, one from the toy box."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises import toy_top
from rigidtop.derivations.exercises.sleeping_top import RPM
from rigidtop.errors import NoSteadyPrecession
from rigidtop.figures import bodies, solids
from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film, film, one
from rigidtop.figures.nutation import nutation_times
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, View, arc, bow, circle, total, unit
from rigidtop.figures.style import Canvas, Floats, canvas
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

# --- The torque of the weight, and where it moves the angular momentum ---------------------------

VIEW_TORQUE = View(azimuth=-0.3, elevation=0.42)
"""So that what points into the paper goes up and to the left."""


def torque(motion: TopMotion) -> Floats:
    """N = R_CM × (−Mgẑ) at the start (3.49), space components (3,), N m."""
    top = motion.body
    centre = top.R * motion.start().e3[0]
    return np.cross(centre, [0.0, 0.0, -top.M * top.g])


def direction_of_torque(motion: TopMotion) -> Floats:
    """N as a unit vector; zero for a top that is upright or hangs, to rounding."""
    top = motion.body
    return unit(total(torque(motion)[None], top.M * top.g * top.R))


def draw_torque(axes: Axes, motion: TopMotion) -> None:
    """R_CM, Mg, N, L and ω of a top at the start of a motion; each has a length of its own.

    The circle is that on which the tip of L goes in a steady precession.
    """
    start = motion.start()
    e3, momentum, omega = start.e3[0], unit(start.angular_momentum[0]), unit(start.omega_space[0])
    turning = direction_of_torque(motion)
    lean, tilt = (math.acos(float(np.clip(each[2], -1, 1))) for each in (e3, momentum))
    standing = lean < 1.3  # above the table, which it does not touch but with its tip
    half = min(0.37, 0.8 * (math.pi / 2 - lean)) if standing else 0.37
    centre, end = 0.62 * e3, 1.42 * momentum
    weight = centre - 0.46 * UPRIGHT
    parts: list[pen.Part] = [
        *([solids.table(0.62)] if standing else []),
        *solids.cone(e3, 0.78, 0.78 * math.tan(half)),
        pen.round_axis(circle(UPRIGHT, tilt, length=1.42), look.MOMENTUM, lw=0.9, ls=look.DASHED),
        pen.Arrow(1.95 * UPRIGHT, look.Z, look.GREY, 0.8, shift=(7, 2)),
        pen.Arrow(centre, lw=2.0),
        pen.Arrow(1.05 * e3, look.E3, look.AXIS, 1.0, shift=(9, 0)),
        pen.Arrow(end, look.L_VEC, look.MOMENTUM, 1.7, shift=(9, 2)),
        pen.Arrow(1.2 * omega, look.OMEGA_VEC, look.OMEGA, 1.7, shift=(9, -3)),
        pen.couple(0.95 * turning, (-6, -10), "right"),
        pen.Arrow(weight, start=centre),
        pen.Words(weight, look.WEIGHT, (6, 2)),
        pen.Markers(centre, words=look.R_CM, shift=(6, -8)),
        pen.Words(pen.ORIGIN, "$O$", (5, -10)),
    ]
    if np.any(turning):
        beyond = end + 0.42 * turning
        parts.append(pen.Arrow(beyond, "", look.TORQUE, 1.2, start=end))
        parts.append(pen.Words(beyond, look.L_DOT, (2, 4), look.TORQUE, "center", z=7))
    low = min(-0.3, 1.6 * e3[2] - 0.4)
    pen.picture(axes, parts, (-1.45, 1.7), (low, 1.92), VIEW_TORQUE)


def _motion_torque(theta: float, omega3: float, **top: float) -> TopMotion:
    """With e₃ leaning to the right in the plane of the paper, the yz plane.

    Steady and slow; where there is no steady precession, let go with ω along e₃.
    """
    body = HeavyTop(**top)
    try:
        rate, _ = body.steady_precession(theta, omega3)
    except NoSteadyPrecession:
        rate = 0.0
    return body.motion(theta=theta, phi=math.pi / 2, phi_dot=rate, omega3=omega3)


def _facts_torque(**values: float) -> dict[str, Any]:
    motion = _motion_torque(**values)
    start, along = motion.start(), direction_of_torque(motion)
    lean = float(unit(start.angular_momentum[0]) @ start.e3[0])
    rate = float(start.phi_dot[0])
    steady = "the top goes round at {rate} rad/s, its exact slow rate"
    where = (
        r"it points into the paper, and the tip of $\mathbf L$ follows it round $\hat{\mathbf z}$"
    )
    points = (
        f"The torque N points horizontally {'into' if along[0] < 0 else 'out of'} the paper, at "
        "right angles to e3 and to z, and so does the change of L at its tip, along a dashed "
        "circle around z."
    )
    return bodies.facts_of(
        motion.body,
        where=where if np.any(along) else "on the vertical there is none",
        size=float(np.linalg.norm(torque(motion))),
        rate=rate,
        goes=steady if rate else r"$\boldsymbol\omega$ is along $\mathbf e_3$ at first",
        lean=math.acos(min(1.0, max(-1.0, lean))),
        points=points if along[0] else "There is no torque, as the axis is vertical.",
    )


TORQUE_ARROWS = Drawing(
    "torque",
    r"The torque of the weight, $\mathbf L$ and $\boldsymbol\omega$: into the paper",
    "3.5.2",
    (
        *bodies.TOP,
        Parameter("theta", math.pi / 4, r"$\theta$", "rad", least=0, most=math.pi),
        Parameter("omega3", 30.0, r"$\omega_3$", "rad/s", above=0),
    ),
    pen.alone(2.75, lambda axes, **values: draw_torque(axes, _motion_torque(**values))),
    r"The torque $\mathbf N = \mathbf R_{\text{CM}} \times M\mathbf g$ of the weight, with "
    r"$\mathbf e_3$ leaning to the right in the plane of the paper: {where}. At {start}, with "
    "{top}, its magnitude is {size} N m, and {goes}. Directions are computed, lengths are not to "
    "one scale.",
    "A top on a table, its axis e3 leaning to the right. From the contact point O the arrows e3, "
    "omega and L, L {lean:°} degrees from e3. The weight points down from the centre of mass. "
    "{points}",
    _facts_torque,
    motions=one(_motion_torque),
)

# --- A top as one sees it ------------------------------------------------------------------------

VIEW_SPINNING = View(azimuth=0.0, elevation=0.3)
FLASHES = 5
STANDING = 1.4
"""The largest tilt (rad) of a top on a table; others hang from their tip."""
BODY_SPINNING = 0.95, 0.2
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
    _put(axes, motion, parts)


def draw_stroboscopic(axes: Axes, motion: TopMotion, times: Floats) -> None:
    """The top in some flashes of light, and the path of its axis between them."""
    parts = _round_about(motion, times, 1.3, 7)
    run = motion.exact(np.linspace(times[0], times[-1], FLASHES))
    for place, k in enumerate(np.argsort(VIEW_SPINNING(run.e3)[2], kind="stable")):
        e3, mark, z = run.e3[k], run.rotation.as_matrix()[k][:, 0], 2 + 0.5 * place
        tip, start = TRAIL * e3, BODY_SPINNING[0] * e3
        number = pen.Arrow(tip, rf"${k + 1}$", look.AXIS, 1.2, start, (0, 10), z + 0.4)
        parts += [*solids.cone(e3, *BODY_SPINNING, mark, z), number]
    _put(axes, motion, parts)


_motion_spinning = partial(bodies.top_motion, phi=-1.35)


def _times(motion: TopMotion, samples: int) -> Floats:
    """As long as it takes e₃ to pass before the eye, from the left to the right."""
    last = float(nutation_times(motion, 2)[-1])
    turned = abs(motion.mean_precession) * last
    return np.linspace(0.0, last * min(1.0, 2.7 / turned) if turned else last, samples)


def _put(axes: Axes, motion: TopMotion, parts: list[pen.Part]) -> None:
    low = min(-0.32, 1.5 * math.cos(motion.turning_points[1]) - 0.3)
    pen.picture(axes, parts, (-1.32, 1.32), (low, 1.72), VIEW_SPINNING)


def _draw_spinning(axes: Axes, **values: float) -> None:
    motion = _motion_spinning(**values)
    draw_stroboscopic(axes, motion, _times(motion, 1200))


def _film(**values: float) -> Film:
    """A turn of precession, on the mean; the spin as slow as the motion is."""
    motion = _motion_spinning(**values)
    rate, some = abs(motion.mean_precession), float(nutation_times(motion, 2)[-1])
    last = min(2 * math.pi / rate, 8 * some) if rate else some

    def show(share: float, axes: Axes) -> None:
        now = share * last
        draw_top(axes, motion, now, np.linspace(min(now - 1e-9 * last, 0.0), now, 1500))

    return film(look.COLUMN, 2.9, show)


def _facts_spinning(theta: float, **others: float) -> dict[str, Any]:
    motion = _motion_spinning(theta, **others)
    apart = float(_times(motion, 2)[-1]) / (FLASHES - 1)
    return bodies.facts_of_motion(motion, theta, 0.0, flashes=FLASHES, apart=apart)


SPINNING_TOP = Drawing(
    "top",
    "A top going round, in flashes of light",
    "",
    (*bodies.TOP, replace(bodies.THETA, default=0.85), bodies.RATE, bodies.SPIN),
    pen.abreast(2.9, _draw_spinning, width=look.COLUMN),
    "A top with {top} from {start}, {rates}, and the path of its axis ({regime}); the line on the "
    r"lid is $\mathbf e_1$. In {flashes} flashes of light, {apart} s apart, where it does not "
    "move.",
    "A top on a table at {flashes} numbered moments, leaning to all sides as it goes round the "
    "vertical, and the path of its axis, of the kind {regime}, between {first:°} and {last:°} "
    "degrees from the vertical.",
    _facts_spinning,
    _film,
    motions=one(_motion_spinning),
)

# --- A top from the toy box ----------------------------------------------------------------------

VIEW_TOY_TOP = View(azimuth=0.0, elevation=0.2)

SAMPLES = 30, 20_001
"""For each nutation, and at most: where there are more they are too small to be seen."""

DISC = ("disc_radius", "disc_thickness", "disc_height")
BODY_TOY_TOP = ("disc_mass", *DISC, "stem_mass", "stem_length", "g")
"""Names of parameters."""


def draw_toy_top(axes: Axes, R: float, theta: float, omega3: float, **sizes: float) -> None:
    """Disc, stem and centre of mass (a dot) to scale, leaning to the right in the yz plane."""
    e3 = np.array([0.0, math.sin(theta), math.cos(theta)])
    lengths = np.array([R, sizes["stem_length"], *(sizes[name] for name in DISC)])
    _, stem_length, radius, thickness, place = lengths
    lengths /= max(stem_length, math.hypot(radius, place + thickness / 2))
    centre, top, half, height, middle = lengths
    way = (top + 0.5) * arc(UPRIGHT, e3)
    pieces = ((0.0, middle), 1.5), ((middle + height / 2, top), 3.0)
    stem: Any = {"lw": 2.4, "cap": "butt", "label": "_stem"}
    parts: list[pen.Part] = [
        solids.table(),
        *(pen.Curve(np.outer(ends, e3), look.NOTE, z=z, **stem) for ends, z in pieces),
        *solids.disc(middle * e3, e3, half, height),
        pen.Markers(centre * e3, label="_centre", words=look.R_CM, shift=(5, -8)),
        pen.guide(np.outer([top, top + 0.62], e3)),
        pen.guide(np.outer([0.0, top + 0.62], UPRIGHT)),
        *pen.angle(way, r"$\theta$", (0, 2), out=1.05, color=look.GREY, lw=0.8, z=1),
        pen.Turning((top + 0.2) * e3, e3, 0.16, omega3, r"$\omega_3$"),
    ]
    pen.picture(axes, parts, (-1.02, 1.02), (-0.25, 1.85), VIEW_TOY_TOP)


def touches(motion: TopMotion, touching: float) -> float | None:
    """When a top that is let go leans by `touching` (rad) for the first time, if it does (s)."""
    return None if motion.turning_points[1] < touching else bodies.time_to(motion, touching)


def draw_path_from_above(axes: Axes, motion: TopMotion, touching: float) -> None:
    """Where e₃ leans, for one turn or until the rim touches: θ outwards, φ as the angle.

    Dotted is the tilt at which the rim touches the table.
    """
    last = touches(motion, touching) or 2 * math.pi / abs(motion.mean_precession)
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
        pen.Markers((x[0], y[0]), look.FIRST),
        pen.Curve(bow(edge), look.SECOND, 0.9, look.DOTTED),
        pen.Words((0.0, edge), "rim touches", (0, 3), look.SECOND, "center"),
        pen.Markers((0.0, 0.0), look.GREY, 6, "+"),
        pen.Words((0.0, -below), rf"$\theta = {theta[0]:.3g}°$", shift, ha="center"),
    ]
    pen.picture(axes, parts, (-1.04 * edge, 1.04 * edge), (-1.04 * edge, 1.25 * edge))


def draw_against_spin(axes: Axes, top: HeavyTop, theta: float, omega3: float) -> None:
    """Turns of the axis and nutations in a second at the tilt `theta`, against the spin (rpm).

    The dots are at the spin `omega3` (rad/s); dotted is the spin from which on the top sleeps.
    """
    least, wakes, given = top.smallest_spin(theta), top.sleeping_spin(), abs(omega3)
    last = max(2.0 * wakes, 1.25 * given)
    spins = least + (last - least) * np.linspace(1e-6, 1.0, 300) ** 2
    every = [toy_top.spinning_at(top, theta, float(spin)) for spin in (*spins, given)]
    rates, marked = np.split(np.array(every) / (2 * math.pi), [-1])
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
            pen.Markers((given * RPM, marked[0, k]), color, 4.5, label=f"_{words} now"),
            pen.Words(place, words, (0, 5), color, "center"),
        ]
    limits = {"xlim": (0.9 * least * RPM, last * RPM), "ylim": (0.6 * rates[-1, 0], high)}
    pen.chart(axes, parts, "spin  (turns a minute)", "in a second", yscale="log", **limits)
    axes.yaxis.set_major_formatter("{x:g}")


def _top(values: dict[str, float]) -> tuple[HeavyTop, TopMotion, float]:
    """The top, let go with ω along e₃, and the tilt at which its rim touches the table."""
    top = toy_top.measured(**{name: values[name] for name in BODY_TOY_TOP})
    theta = values["theta"]
    touching = toy_top.free_of_the_table(theta, **{name: values[name] for name in DISC})
    toy_top.spinning_at(top, theta, values["omega3"])  # says so where it falls
    return top, top.motion(theta=theta, omega3=values["omega3"]), touching


def _draw_toy_top(**values: float) -> Canvas:
    top, motion, touching = _top(values)
    drawn = canvas(look.COLUMN, 3.2)
    parts = drawn.subplot_mosaic([["top", "path"], ["chart", "chart"]], height_ratios=(1.1, 1))
    draw_toy_top(parts["top"], top.R, **values)
    draw_path_from_above(parts["path"], motion, touching)
    draw_against_spin(parts["chart"], top, values["theta"], values["omega3"])
    return drawn


def _facts_toy_top(**values: float) -> dict[str, Any]:
    _, motion, touching = _top(values)
    facts = answers(toy_top.top_from_the_toy_box, **values)
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
    toy_top.top_from_the_toy_box.parameters,
    _draw_toy_top,
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
    _facts_toy_top,
)
