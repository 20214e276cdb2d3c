"""Free bodies with three moments: polhodes, the flip about the middle axis, Toutatis."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.eulers_equations import stable_axes
from rigidtop.derivations.exercises.toutatis import toutatis
from rigidtop.errors import RigidtopError
from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, one
from rigidtop.figures.space import UPRIGHT, View, circle, unit
from rigidtop.figures.style import Floats, said
from rigidtop.motion.body import FreeBody
from rigidtop.motion.motion import Motion
from rigidtop.parameters import Parameter

MOMENTS = (
    Parameter("lambda1", 1.0, r"moment about $\mathbf e_1$", "kg m²", above=0),
    Parameter("lambda2", 2.0, r"moment about $\mathbf e_2$", "kg m²", above=0),
    Parameter("lambda3", 2.9, r"moment about $\mathbf e_3$", "kg m²", above=0),
)
LATE = 14.0
"""Of a motion on the separatrix, in units of its rate: from then on it rests, to 10⁻⁶."""

# --- Polhodes on the energy ellipsoid ------------------------------------------------------------


def _by_size(body: FreeBody) -> tuple[Any, tuple[float, float, float]]:
    """Which axes have the smallest, the middle and the largest moment, and the moments."""
    order = np.argsort(body.moments, kind="stable")
    low, middle, high = (body.moments[k] for k in order)
    return order, (low, middle, high)


def _between(body: FreeBody, angle: float) -> Motion:
    """With 2T = 1 J, from ω at an angle (rad) between the largest axis, 0, and the smallest."""
    (small, _, large), (low, _, high) = _by_size(body)
    omega = np.zeros(3)
    omega[large] = math.cos(angle) / math.sqrt(high)
    omega[small] = math.sin(angle) / math.sqrt(low)
    return body.motion(omega=tuple(omega))


def _edge(body: FreeBody) -> float:
    """The angle at which the separatrix starts, where L² = 2Tλ of the middle axis (rad)."""
    _, (low, mid, high) = _by_size(body)
    return math.atan2(math.sqrt(high - mid), math.sqrt(mid - low))


def on_separatrix(body: FreeBody) -> list[Motion]:
    """The motions with L² = 2Tλ of the middle axis, 2T = 1 J, that start between the other two.

    There are four, ± about either; none where two moments are equal.
    """
    edge = _edge(body)
    starts = (edge, -edge, math.pi - edge, math.pi + edge)
    return [_between(body, angle) for angle in starts] if len({*body.moments}) == 3 else []


def polhodes(body: FreeBody, between: int = 4) -> list[Motion]:
    """Motions with 2T = 1 J, evenly between the axes: on both sides of the separatrix, and ±."""
    _, (low, mid, high) = _by_size(body)
    edge, shares = _edge(body), (np.arange(between) + 0.5) / between
    around_large = edge * shares[: between * (high > mid)]
    around_small = math.pi / 2 - (math.pi / 2 - edge) * shares[: between * (mid > low)]
    angles = [end for angle in around_large for end in (angle, math.pi - angle)]
    angles += [end for angle in around_small for end in (angle, -angle)]
    return [_between(body, float(angle)) for angle in angles]


def polhode(motion: Motion, samples: int = 1441) -> Floats:
    """ω in the body (N, 3) once round, or on the separatrix from one end to the other."""
    period = 2 * motion.nutation_period  # θ from L is smallest twice on the way
    if math.isfinite(period):
        return motion.exact(np.linspace(0.0, period, samples)).omega
    low, mid, high = sorted(motion.body.moments)
    rate = math.sqrt((high - mid) * (mid - low) / (high * low * mid))  # at 2T = 1 J
    return motion.exact(np.linspace(-LATE, LATE, samples) / rate).omega


def draw_polhodes(axes: Axes, body: FreeBody) -> None:
    """Polhodes on the energy ellipsoid Σ λₖωₖ² = 1 J in the body frame, and the separatrix."""
    moments = np.array(body.moments)
    if np.ptp(moments) == 0:
        raise RigidtopError("with three equal moments every ω is constant: there are no polhodes")
    (small, middle, large), _ = _by_size(body)
    # The middle axis comes towards the eye, the largest moment's is upright.
    turn = np.zeros((3, 3))
    turn[0, middle], turn[1, small], turn[2, large] = 1.0, 1.0, 1.0
    turn[1, small] = np.linalg.det(turn)
    view = View(azimuth=0.5 * turn[1, small], elevation=0.38)  # all three towards the eye
    eye = view.axes[2] @ turn
    to_paper = math.sqrt(moments.min()) * turn.T  # the longest half axis is 1 on paper

    def curve(points: Floats, color: str, lw: float) -> pen.Curve:
        hidden = (points * moments) @ eye < 0
        return pen.Curve(points @ to_paper, color, lw, z=3, hidden=hidden)

    rim = circle(unit(np.sqrt(moments) * eye), math.pi / 2) / np.sqrt(moments)
    parts: list[pen.Part] = [pen.Face(rim @ to_paper, "#f4f4f4", look.GREY, 0.8, z=0)]
    for path in map(polhode, polhodes(body)):
        parts.append(curve(path, look.FIRST, 0.9))
        # A head on the closed curve, where it is nearest to the eye, says which way it goes.
        near = (path * moments) @ eye
        at = int(np.argmax(near[:-22]))
        if near[at] > 0:
            start, tip = path[[at, at + 21]] @ to_paper
            parts.append(pen.Arrow(tip, "", look.FIRST, 0.5, start, z=4, size=(0.12, 0.3)))
    parts += [curve(polhode(motion), look.SECOND, 1.7) for motion in on_separatrix(body)]
    for k, end in enumerate(np.diag(1 / np.sqrt(moments))):
        for sign in (1.0, -1.0):
            fill = look.INK if sign * eye[k] > 0 else "none"
            parts.append(pen.Markers(sign * end @ to_paper, size=3.2, fill=fill, z=6))
        longer = 0.5 if k == middle else 0.28
        tip = (end + longer * np.eye(3)[k] / math.sqrt(moments.min())) @ to_paper
        parts.append(pen.Arrow(tip, rf"$\omega_{k + 1}$", lw=1.0, start=end @ to_paper))
    pen.picture(axes, parts, (-1.35, 1.35), (-0.98, 1.12), view)


def _three(lambda1: float, lambda2: float, lambda3: float) -> str:
    moments = ", ".join(said(k, 4) for k in (lambda1, lambda2, lambda3))
    return rf"$\lambda_1$, $\lambda_2$, $\lambda_3 = {moments}$"


def _polhodes_facts(**moments: float) -> dict[str, Any]:
    body = FreeBody(**moments)
    middle = int(_by_size(body)[0][1])
    facts = {
        "three": _three(**moments),
        "which": "two moments are equal, and all of them are circles",
        "through": "Two moments are equal, and every curve is a circle about the third axis.",
    }
    if not on_separatrix(body):
        return facts
    return facts | {
        "which": "about the axes of the largest and the smallest moment they are closed, and the "
        rf"separatrix (thick) through the middle axis $\mathbf e_{middle + 1}$ parts them",
        "through": "Two thick curves cross at the ends of the middle axis, here omega"
        f"{middle + 1}, and part the others.",
    }


POLHODES = Drawing(
    "polhodes",
    "Polhodes on the energy ellipsoid, with the separatrix",
    "3.2.2",
    MOMENTS,
    pen.alone(2.7, lambda axes, **moments: draw_polhodes(axes, FreeBody(**moments))),
    r"Polhodes: the paths of $\boldsymbol\omega$ in the body frame on the energy ellipsoid "
    r"$\sum \lambda_k\omega_k^2 = 2T$, for {three} kg m²; {which}. Dashed and open: behind.",
    "An ellipsoid with closed curves around the ends of its shortest and of its longest half axis, "
    "with heads that say which way omega goes. {through}",
    _polhodes_facts,
)

# --- The flip about the middle axis --------------------------------------------------------------

FLIPS = 4


def draw_rates(axes: Axes, motion: Motion, t: Floats) -> None:
    """ω₁, ω₂, ω₃ (rad/s) of a motion against the time (s)."""
    curves = pen.three(t, motion.exact(t).omega)
    pen.chart(axes, curves, "$t$  (s)", r"$\omega_k$  (rad/s)", xlim=(t[0], t[-1]))
    pen.legend_above(axes, ncols=3)


def flip(lambda1: float, lambda2: float, lambda3: float, omega: float, kick: float) -> Motion:
    """A spin `omega` about the middle axis, and `kick` (rad/s) about that of the least moment."""
    body = FreeBody(lambda1, lambda2, lambda3)
    least, middle = _order(body)
    if not 1e-8 * omega <= kick < omega:
        raise RigidtopError(
            f"kick must be less than omega = {omega:g} and at least 1e-08 of it, not {kick:g}"
        )
    rates = [0.0, 0.0, 0.0]
    rates[middle], rates[least] = omega, kick
    return body.motion(omega=rates)


def _order(body: FreeBody) -> tuple[int, int]:
    """Where the least moment is among the three, and where the middle one."""
    (least, between, _), (low, middle, high) = _by_size(body)
    if low == middle or middle == high:
        raise RigidtopError("a flip wants three different moments: two of these are equal")
    return int(least), int(between)


def _flip_times(motion: Motion) -> Floats:
    return np.linspace(0.0, FLIPS * motion.nutation_period, 1601)


def _draw_flip(axes: Axes, **values: float) -> None:
    motion = flip(**values)
    draw_rates(axes, motion, _flip_times(motion))
    turns = (np.arange(FLIPS) + 0.5) * motion.nutation_period
    pen.draw(axes, [pen.Rule(x=float(at), lw=0.8, label="_flip") for at in turns])


def _flip_facts(omega: float, kick: float, **moments: float) -> dict[str, Any]:
    motion = flip(**moments, omega=omega, kick=kick)
    least, middle = _order(FreeBody(**moments))
    rate = np.abs(motion.exact(_flip_times(motion)).omega[:, middle])
    stays = (
        "stays near its first value, {omega} radians per second, then falls to the opposite value "
        "at once and stays there, again and again; the other two are near zero but for a pulse at "
        "each turn"
    )
    swings = (
        "swings between its first value, {omega} radians per second, and the opposite one; the "
        "other two are never small together"
    )
    return {
        "three": _three(**moments),
        "least": rf"$\mathbf e_{least + 1}$",
        "middle": rf"$\mathbf e_{middle + 1}$",
        "number": middle + 1,
        "period": motion.nutation_period,
        "course": stays if np.mean(rate > 0.9 * rate.max()) > 0.5 else swings,
    }


FLIP = Drawing(
    "flip",
    "The flip about the middle axis",
    "",
    stable_axes.parameters,
    pen.alone(2.35, _draw_flip),
    r"The flip about the middle axis {middle}: $\boldsymbol\omega$ in the body frame for {three} "
    "kg m², from {omega} rad/s about that axis and {kick} rad/s about {least}. The body turns over "
    "every {period} s (dotted).",
    "The three components of omega against time. Omega {number} {course}. The time between turns "
    "is {period} seconds.",
    _flip_facts,
    motions=one(flip),
)

# --- Toutatis ------------------------------------------------------------------------------------

DAY = 86400.0
NUTATIONS = 5


def draw_tumbling(body_axes: Axes, space_axes: Axes, motion: Motion) -> None:
    """L in the body frame, once round; e₃ and e₁ in space about L, some nutations long."""
    view = View(azimuth=0.5)
    steady = motion.regime == "steady"
    period = 2 * motion.nutation_period
    if steady or not math.isfinite(period):
        period = 2 * LATE / math.hypot(*motion.omega)
    in_body = motion.exact(np.linspace(0.0, period, 601)).omega * np.array(motion.body.moments)
    in_body /= np.linalg.norm(in_body, axis=1)[:, None]
    parts: list[pen.Part] = [
        pen.Sphere(),
        pen.on_sphere(in_body, look.INK, lw=1.4, label="_momentum"),
    ]
    first, *others = pen.frame(np.eye(3), 1.4, start=1.0)
    parts += [replace(first, shift=(-13.0, 2.0)), *others]  # beside the way of L of a long body
    limits = (-1.3, 1.3), (-1.08, 1.45)
    pen.picture(body_axes, [*parts, _mark(view, in_body[0], look.L_VEC)], *limits, view)

    turn = 2 * math.pi / math.hypot(*motion.omega)  # once round, if ω is constant
    run = motion.exact(np.linspace(0.0, turn if steady else NUTATIONS * period / 2, 2401))
    momentum = unit(run.angular_momentum[0])
    across = circle(momentum, math.pi / 2)[0]
    frame = np.array([across, np.cross(momentum, across), momentum])
    e1, e3 = (run.rotation.as_matrix()[:, :, k] @ frame.T for k in (0, 2))
    parts = [
        pen.Sphere(),
        pen.Arrow(1.4 * UPRIGHT, look.L_VEC, lw=1.0, start=UPRIGHT),
        pen.on_sphere(e1, look.GREY, lw=0.8),
        pen.on_sphere(e3, look.AXIS, lw=1.5, label="_axis"),
        _mark(view, e1[0], look.E1),
        _mark(view, e3[0], look.E3),
    ]
    pen.picture(space_axes, parts, *limits, view)
    body_axes.set_title("body frame")
    space_axes.set_title("space frame")


def _mark(view: View, point: Floats, words: str) -> pen.Markers:
    """A dot with a name, open where it is behind."""
    x, _, near = view(point)
    inwards = -12 * float(x), 5.0  # away from the outline of the sphere
    fill = look.INK if near > 0 else "white"
    return pen.Markers(point, size=4, fill=fill, z=6, words=words, shift=inwards, ha="center")


def _tumbling(omega1: float, omega2: float, omega3: float, **moments: float) -> Motion:
    if not (omega1 or omega2 or omega3):
        raise RigidtopError("omega1, omega2 and omega3 are all 0: the body is at rest")
    return FreeBody(**moments).motion(omega=(omega1, omega2, omega3))


def _draw_tumbling(body: Axes, space: Axes, **values: float) -> None:
    draw_tumbling(body, space, _tumbling(**values))


def _lasting(seconds: float) -> str:
    return f"{said(seconds / DAY)} days" if seconds > DAY / 2 else f"{said(seconds)} s"


FIRST, SECOND, THIRD = r"$\mathbf e_1$", r"$\mathbf e_2$", r"$\mathbf e_3$ (thick)"
NOT_CLOSED = "the tips of e3 and of e1 wind around the upright L, and their paths do not close"

COURSES = {
    "steady": (
        r"$\mathbf L$ rests ({kind})",
        r"the body turns about $\mathbf L$, and {ways}, back after {turn}; one turn is drawn",
        "L rests at a point",
        "the tips of e3 and of e1 go round circles about the upright L, or rest on it",
    ),
    "separatrix": (
        r"$\mathbf L$ tends to the middle axis and never comes back ({kind})",
        rf"{THIRD} and {FIRST} turn about $\mathbf L$ and never come back, as the body comes to "
        "turn about its middle axis",
        "the tip of L goes on a curve to the middle axis, which does not close",
        NOT_CLOSED,
    ),
    "regular precession": (
        r"$\mathbf L$ goes round a circle and comes back after {back} ({kind})",
        r"{circles} goes round a circle about $\mathbf L$, back after {turn}, and {others} not in "
        "general come back; {nutations} nutations are drawn",
        "the tip of L goes round a circle about the axis of symmetry",
        "the tips of e3 and of e1 go around the upright L; that of the axis of symmetry, where it "
        "is one of them, goes round a circle",
    ),
    "": (
        r"$\mathbf L$ comes back after {back} ({kind})",
        rf"this axis turns about $\mathbf L$, on the mean once in {{turn}}, and {THIRD} and "
        rf"{FIRST} never come back; {{nutations}} nutations are drawn",
        "the tip of L goes on a closed curve, of the kind {kind}",
        NOT_CLOSED,
    ),
}
"""What L does in the body and the axes do in space, by the kind of motion: printed, and spoken."""


def _ways(omega: Floats) -> str:
    """What e₃ and e₁ do where ω is constant."""
    still = np.abs(omega) == np.linalg.norm(omega)
    if still[2]:
        return rf"$\mathbf e_3$ rests and {FIRST} goes round a circle"
    if still[0]:
        return f"{FIRST} rests and {THIRD} goes round a circle"
    return f"{THIRD} and {FIRST} go round circles"


def _tumbling_facts(**values: float) -> dict[str, Any]:
    motion = _tumbling(**values)
    steady = motion.regime == "steady"
    rate = math.hypot(*motion.omega) if steady else abs(motion.mean_precession)
    first, second, third = motion.body.moments
    own = 2 if first == second else 1 if first == third else 0  # the axis of symmetry
    course = COURSES.get(motion.regime, COURSES[""])
    return {
        **dict(zip(("body", "space", "left", "right"), course, strict=True)),
        "kind": motion.regime,
        "three": _three(*motion.body.moments),
        "ways": _ways(np.array(motion.omega)),
        "back": _lasting(2 * motion.nutation_period),
        "turn": _lasting(2 * math.pi / rate),
        "circles": (FIRST, SECOND, THIRD)[own],
        "others": (f"{THIRD} does", f"{THIRD} and {FIRST} do", f"{FIRST} does")[own],
        "nutations": NUTATIONS,
    }


TUMBLING = Drawing(
    "tumbling",
    "A tumbling body such as Toutatis, in the body frame and in space",
    "",
    toutatis.parameters[:6],
    pen.panels(look.TEXT, 2.6, _draw_tumbling, 1, 2),
    r"A free body with {three} (in any unit) and at first $\omega_1$, $\omega_2$, "
    r"$\omega_3 = {omega1}, {omega2}, {omega3}$ rad/s. Left: in the body {body}. Right: in space "
    "{space}. Dots, open where they are behind: at first.",
    "Two spheres. On the left, in the body frame, {left}. On the right, in space, {right}.",
    _tumbling_facts,
    motions=one(_tumbling),
)
"""By default the asteroid of example 33, its moments in units of the smallest."""
