"""Free bodies with three moments: polhodes, the flip about the middle axis, Toutatis."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas

from rigidtop.derivations.exercises.eulers_equations import stable_axes
from rigidtop.derivations.exercises.toutatis import toutatis
from rigidtop.errors import RigidtopError
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, one
from rigidtop.figures.space import UPRIGHT, Scene, View, circle, paper, unit
from rigidtop.figures.style import Floats, alone, canvas, legend_above, said, spoken
from rigidtop.motion.body import FreeBody
from rigidtop.motion.motion import Motion
from rigidtop.parameters import Parameter

MOMENTS = (
    Parameter("lambda1", 1.0, "moment about $e₁$", "kg m²", above=0),
    Parameter("lambda2", 2.0, "moment about $e₂$", "kg m²", above=0),
    Parameter("lambda3", 2.9, "moment about $e₃$", "kg m²", above=0),
)
LATE = 14.0
"""Of a motion on the separatrix, in units of its rate: from then on it rests, to 10⁻⁶."""

# --- Polhodes on the energy ellipsoid ------------------------------------------------------------


def on_separatrix(body: FreeBody) -> list[Motion]:
    """The motions with L² = 2Tλ of the middle axis, 2T = 1 J, that start between the other two.

    There are four, ± about either; none where two moments are equal.
    """
    small, middle, large = np.argsort(body.moments, kind="stable")
    low, mid, high = (body.moments[k] for k in (small, middle, large))
    if low == mid or mid == high:
        return []
    found = []
    for first in (1.0, -1.0):
        for second in (1.0, -1.0):
            omega = np.zeros(3)
            omega[large] = first * math.sqrt((mid - low) / ((high - low) * high))
            omega[small] = second * math.sqrt((high - mid) / ((high - low) * low))
            found.append(body.motion(omega=tuple(omega)))
    return found


def polhodes(body: FreeBody, between: int = 4) -> list[Motion]:
    """Motions with 2T = 1 J, evenly between the axes: on both sides of the separatrix, and ±."""
    small, middle, large = np.argsort(body.moments, kind="stable")
    low, mid, high = (body.moments[k] for k in (small, middle, large))
    edge = math.atan2(math.sqrt(high - mid), math.sqrt(mid - low))
    around_large = [edge * (k + 0.5) / between for k in range(between)] if high > mid else []
    rest = math.pi / 2 - edge
    around_small = [math.pi / 2 - rest * (k + 0.5) / between for k in range(between) if mid > low]
    found = []
    for angles, axis in ((around_large, large), (around_small, small)):
        for angle in angles:
            for sign in (1.0, -1.0):
                omega = np.zeros(3)
                omega[large] = math.cos(angle) / math.sqrt(high)
                omega[small] = math.sin(angle) / math.sqrt(low)
                omega[axis] *= sign
                found.append(body.motion(omega=tuple(omega)))
    return found


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
    small, middle, large = np.argsort(moments, kind="stable")
    # The middle axis comes towards the eye, the largest moment's is upright.
    turn = np.zeros((3, 3))
    turn[0, middle], turn[1, small], turn[2, large] = 1.0, 1.0, 1.0
    turn[1, small] = np.linalg.det(turn)
    view = View(azimuth=0.5 * turn[1, small], elevation=0.38)  # all three towards the eye
    eye = view.axes[2] @ turn
    scale = math.sqrt(moments.min())  # the longest half axis is 1 on paper

    scene = Scene(axes, view)

    def draw(points: Floats, **style: object) -> None:
        scene.curve(scale * points @ turn.T, (points * moments) @ eye < 0, **style)

    rim = circle(unit(np.sqrt(1 / moments) * eye * moments), math.pi / 2) / np.sqrt(moments)
    scene.face(scale * rim @ turn.T, fc="#f4f4f4", ec=look.GREY, lw=0.8, zorder=0)
    for motion in polhodes(body):
        path = polhode(motion)
        draw(path, color=look.FIRST, lw=0.9)
        # A head on the closed curve, where it is nearest to the eye, says which way it goes.
        near = (path * moments) @ eye
        at = int(np.argmax(near[:-22]))
        if near[at] > 0:
            ends = scale * path[[at, at + 21]] @ turn.T
            scene.head(ends, width=0.12, length=0.3, color=look.FIRST, lw=0.5, zorder=4)
    for motion in on_separatrix(body):
        draw(polhode(motion), color=look.SECOND, lw=1.7)
    for k in range(3):
        end = np.zeros(3)
        end[k] = 1 / math.sqrt(moments[k])
        for sign in (1.0, -1.0):
            shown = sign * eye[k] > 0
            color = look.INK if shown else "none"
            scene.dot(scale * sign * turn @ end, ms=3.2, color=color, mec=look.INK, zorder=6)
        longer = 0.5 if k == middle else 0.28
        tip = end * (1 + longer * math.sqrt(moments[k] / moments.min()))
        name, start = rf"$\omega_{k + 1}$", scale * turn @ end
        scene.arrow(scale * turn @ tip, name, start=start, lw=1.0)
    paper(axes, (-1.35, 1.35), (-0.98, 1.12))


def _three(lambda1: float, lambda2: float, lambda3: float) -> str:
    values = ", ".join(said(moment, 4) for moment in (lambda1, lambda2, lambda3))
    return f"$λ₁$, $λ₂$, $λ₃ = {values}$"


def _polhodes_caption(**moments: float) -> str:
    middle = int(np.argsort(list(moments.values()), kind="stable")[1])
    index = "₁₂₃"[middle]
    if on_separatrix(FreeBody(**moments)):
        which = (
            "about the axes of the largest and the smallest moment they are closed, and the "
            f"separatrix (thick) through the middle axis $e{index}$ parts them"
        )
    else:
        which = "two moments are equal, and all of them are circles"
    return (
        "Polhodes: the paths of $𝛚$ in the body frame on the energy ellipsoid "
        f"$Σ λₖωₖ² = 2T$, for {_three(**moments)} kg m²; {which}. Dashed and open: behind."
    )


def _polhodes_in_words(**moments: float) -> str:
    through = (
        "Two thick curves cross at the ends of the middle axis, here omega"
        f"{int(np.argsort(list(moments.values()), kind='stable')[1]) + 1}, and part the others."
        if on_separatrix(FreeBody(**moments))
        else "Two moments are equal, and every curve is a circle about the third axis."
    )
    return (
        "An ellipsoid with closed curves around the ends of its shortest and of its longest half "
        f"axis, with heads that say which way omega goes. {through}"
    )


POLHODES = Drawing(
    "polhodes",
    "Polhodes on the energy ellipsoid, with the separatrix",
    "3.2.2",
    MOMENTS,
    alone(2.7, lambda axes, **moments: draw_polhodes(axes, FreeBody(**moments))),
    _polhodes_caption,
    _polhodes_in_words,
)

# --- The flip about the middle axis --------------------------------------------------------------

FLIPS = 4


def draw_rates(axes: Axes, motion: Motion, t: Floats) -> None:
    """ω₁, ω₂, ω₃ (rad/s) of a motion against the time (s)."""
    omega = motion.exact(t).omega
    for k, (color, style) in enumerate(
        ((look.SECOND, look.DASH_DOT), (look.FIRST, "-"), (look.INK, look.DASHED))
    ):
        axes.plot(t, omega[:, k], color=color, ls=style, label=rf"$\omega_{k + 1}$", lw=1.2)
    axes.axhline(0, color=look.RULE, lw=0.6, zorder=0)
    axes.set(xlim=(t[0], t[-1]), xlabel="$t$  (s)", ylabel=r"$\omega_k$  (rad/s)")
    legend_above(axes, ncols=3)


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
    low, middle, high = sorted(body.moments)
    if low == middle or middle == high:
        raise RigidtopError("a flip wants three different moments: two of these are equal")
    least, between, _ = np.argsort(body.moments)
    return int(least), int(between)


def _flip_times(motion: Motion) -> Floats:
    return np.linspace(0.0, FLIPS * motion.nutation_period, 1601)


def share_near_ends(motion: Motion) -> float:
    """The part of the time in which ω about the middle axis is above 0.9 of its largest value."""
    _, middle = _order(FreeBody(*motion.body.moments))
    rate = np.abs(motion.exact(_flip_times(motion)).omega[:, middle])
    return float(np.mean(rate > 0.9 * rate.max()))


def _draw_flip(axes: Axes, **values: float) -> None:
    motion = flip(**values)
    draw_rates(axes, motion, _flip_times(motion))
    for k in range(FLIPS):
        at = (k + 0.5) * motion.nutation_period
        axes.axvline(at, color=look.GREY, lw=0.8, ls=look.DOTTED, zorder=0, label="_flip")


def _flip_caption(lambda1: float, lambda2: float, lambda3: float, omega: float, kick: float) -> str:
    motion = flip(lambda1, lambda2, lambda3, omega, kick)
    least, middle = _order(FreeBody(lambda1, lambda2, lambda3))
    return (
        f"The flip about the middle axis $e{'₁₂₃'[middle]}$: $𝛚$ in the body frame for "
        f"{_three(lambda1, lambda2, lambda3)} kg m², from {said(omega)} rad/s about that axis and "
        f"{said(kick)} rad/s about $e{'₁₂₃'[least]}$. The body turns over every "
        f"{said(motion.nutation_period)} s (dotted)."
    )


def _flip_in_words(**values: float) -> str:
    motion = flip(**values)
    _, middle = _order(FreeBody(*motion.body.moments))
    value = spoken(values["omega"])
    if share_near_ends(motion) > 0.5:
        course = (
            f"stays near its first value, {value} radians per second, then falls to the opposite "
            "value at once and stays there, again and again; the other two are near zero but for a "
            "pulse at each turn"
        )
    else:
        course = (
            f"swings between its first value, {value} radians per second, and the opposite one; "
            "the other two are never small together"
        )
    return (
        f"The three components of omega against time. Omega {middle + 1} {course}. The time "
        f"between turns is {spoken(motion.nutation_period)} seconds."
    )


FLIP = Drawing(
    "flip",
    "The flip about the middle axis",
    "",
    stable_axes.parameters,
    alone(2.35, _draw_flip),
    _flip_caption,
    _flip_in_words,
    motions=one(flip),
)

# --- Toutatis ------------------------------------------------------------------------------------

DAY = 86400.0
NUTATIONS = 5


def draw_tumbling(body_axes: Axes, space_axes: Axes, motion: Motion) -> None:
    """L in the body frame, once round; e₃ and e₁ in space about L, some nutations long."""
    body, space = (Scene(axes, View(azimuth=0.5)) for axes in (body_axes, space_axes))
    steady = motion.regime == "steady"
    period = 2 * motion.nutation_period
    if steady or not math.isfinite(period):
        period = 2 * LATE / math.hypot(*motion.omega)
    moments = np.array(motion.body.moments)
    in_body = motion.exact(np.linspace(0.0, period, 601)).omega * moments
    in_body /= np.linalg.norm(in_body, axis=1)[:, None]
    body.sphere()
    for k in range(3):
        axis, name = np.eye(3)[k], rf"$\mathbf{{e}}_{k + 1}$"
        shift = (-13.0, 2.0) if k == 0 else None  # beside the way of L of a long body
        body.arrow(1.4 * axis, name, start=axis, shift=shift, color=look.AXIS, lw=1.0)
    body.on_sphere(in_body, color=look.INK, lw=1.4, label="_momentum")
    _mark(body, in_body[0], look.L_VEC)
    turn = 2 * math.pi / math.hypot(*motion.omega)  # once round, if ω is constant
    run = motion.exact(np.linspace(0.0, turn if steady else NUTATIONS * period / 2, 2401))
    momentum = unit(run.angular_momentum[0])
    across = unit(np.cross(momentum, [1.0, 0.0, 0.0] if abs(momentum[0]) < 0.9 else [0, 1.0, 0]))
    frame = np.array([across, np.cross(momentum, across), momentum])
    path = run.e3 @ frame.T
    space.sphere()
    space.arrow(1.4 * UPRIGHT, look.L_VEC, start=UPRIGHT, lw=1.0)
    first = run.rotation.as_matrix()[:, :, 0] @ frame.T
    space.on_sphere(first, color=look.GREY, lw=0.8)
    space.on_sphere(path, color=look.AXIS, lw=1.5, label="_axis")
    _mark(space, first[0], r"$\mathbf{e}_1$")
    _mark(space, path[0], r"$\mathbf{e}_3$")


def _mark(scene: Scene, point: Floats, words: str) -> None:
    """A dot with a name, open where it is behind."""
    x, _, near = scene.view(point)
    scene.dot(point, ms=4, color=look.INK if near > 0 else "white", mec=look.INK, zorder=6)
    inwards = -12 * float(x), 5.0  # away from the outline of the sphere
    scene.words(point, words, inwards, ha="center", color=look.INK, zorder=7)


def _tumbling(omega1: float, omega2: float, omega3: float, **moments: float) -> Motion:
    motion = FreeBody(**moments).motion(omega=(omega1, omega2, omega3))
    if not any(motion.omega):
        raise RigidtopError("omega1, omega2 and omega3 are all 0: the body is at rest")
    return motion


def _draw_tumbling(**values: float) -> Canvas:
    drawn = canvas(look.TEXT, 2.6)
    left, right = drawn.subplots(1, 2)
    draw_tumbling(left, right, _tumbling(**values))
    left.set_title("body frame")
    right.set_title("space frame")
    for axes in (left, right):
        paper(axes, (-1.3, 1.3), (-1.08, 1.45))
    return drawn


def _lasting(seconds: float) -> str:
    return f"{said(seconds / DAY)} days" if seconds > DAY / 2 else f"{said(seconds)} s"


def _own_axis(body: FreeBody) -> int:
    """Which axis is that of symmetry, where two moments are equal."""
    first, second, third = body.moments
    return 2 if first == second else 1 if first == third else 0


def _tumbling_course(motion: Motion) -> tuple[str, str]:
    """What L does in the body, and what the axes do in space, in this kind of motion."""
    kind, back = motion.regime, _lasting(2 * motion.nutation_period)
    if kind == "steady":
        turn = _lasting(2 * math.pi / math.hypot(*motion.omega))
        still = np.abs(motion.omega) == np.linalg.norm(motion.omega)
        if still[2] or still[0]:
            rests, moves = ("$e₃$", "$e₁$") if still[2] else ("$e₁$", "$e₃$ (thick)")
            ways = f"{rests} rests and {moves} goes round a circle"
        else:
            ways = "$e₃$ (thick) and $e₁$ go round circles"
        return (
            "$𝐋$ rests (steady)",
            f"the body turns about $𝐋$, and {ways}, back after {turn}; one turn is drawn",
        )
    drawn = f"{NUTATIONS} nutations are drawn"
    if kind == "separatrix":
        return (
            "$𝐋$ tends to the middle axis and never comes back (separatrix)",
            "$e₃$ (thick) and $e₁$ turn about $𝐋$ and never come back, as the body comes to turn "
            "about its middle axis",
        )
    turn = _lasting(2 * math.pi / abs(motion.mean_precession))
    if kind == "regular precession":
        own = _own_axis(FreeBody(*motion.body.moments))
        circles = ("$e₁$", "$e₂$", "$e₃$ (thick)")[own]
        rest = ("$e₃$ (thick) does", "$e₃$ (thick) and $e₁$ do", "$e₁$ does")[own]
        return (
            f"$𝐋$ goes round a circle and comes back after {back} ({kind})",
            f"{circles} goes round a circle about $𝐋$, back after {turn}, and {rest} not in "
            f"general come back; {drawn}",
        )
    return (
        f"$𝐋$ comes back after {back} ({kind})",
        f"this axis turns about $𝐋$, on the mean once in {turn}, and $e₃$ (thick) and $e₁$ never "
        f"come back; {drawn}",
    )


def _tumbling_caption(omega1: float, omega2: float, omega3: float, **moments: float) -> str:
    motion = _tumbling(omega1, omega2, omega3, **moments)
    rates = ", ".join(map(said, motion.omega))
    in_body, in_space = _tumbling_course(motion)
    return (
        f"A free body with {_three(**moments)} (in any unit) and at first $ω₁$, $ω₂$, "
        f"$ω₃ = {rates}$ rad/s. Left: in the body {in_body}. Right: in space {in_space}. "
        "Dots, open where they are behind: at first."
    )


def _tumbling_in_words(**values: float) -> str:
    motion = _tumbling(**values)
    left, right = {
        "steady": (
            "L rests at a point",
            "the tips of e3 and of e1 go round circles about the upright L, or rest on it",
        ),
        "separatrix": (
            "the tip of L goes on a curve to the middle axis, which does not close",
            "the tips of e3 and of e1 wind around the upright L, and their paths do not close",
        ),
        "regular precession": (
            "the tip of L goes round a circle about the axis of symmetry",
            "the tips of e3 and of e1 go around the upright L; that of the axis of symmetry, where "
            "it is one of them, goes round a circle",
        ),
    }.get(
        motion.regime,
        (
            f"the tip of L goes on a closed curve, of the kind {motion.regime}",
            "the tips of e3 and of e1 wind around the upright L, and their paths do not close",
        ),
    )
    return f"Two spheres. On the left, in the body frame, {left}. On the right, in space, {right}."


TUMBLING = Drawing(
    "tumbling",
    "A tumbling body such as Toutatis, in the body frame and in space",
    "",
    toutatis.parameters[:6],
    _draw_tumbling,
    _tumbling_caption,
    _tumbling_in_words,
    motions=one(_tumbling),
)
"""By default the asteroid of example 33, its moments in units of the smallest."""
