"""The cones on which e₃, ω and L of a free symmetric body go round each other."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas

from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film, one
from rigidtop.figures.space import Scene, View, circle, paper, unit
from rigidtop.figures.style import Floats, canvas, said, spoken
from rigidtop.motion.body import FreeBody
from rigidtop.motion.motion import Motion
from rigidtop.parameters import Parameter

BODY = (
    Parameter("lambda1", 1.0, "moment across the axis", "kg m²", above=0),
    Parameter("lambda3", 0.55, "moment about the axis", "kg m²", above=0),
    Parameter("omega_0", 0.45, "magnitude of $𝛚$ across the axis", "rad/s", above=0),
    Parameter("omega3", 1.0, "$ω₃$", "rad/s", above=0),
)


def free_motion(lambda1: float, lambda3: float, omega_0: float, omega3: float) -> Motion:
    """(3.38) at t = 0: ω = (ω₀, 0, ω₃)."""
    return FreeBody(lambda1, lambda1, lambda3).motion(omega=(omega_0, 0.0, omega3))


def three_directions(motion: Motion, *, space: bool) -> tuple[Floats, Floats, Floats]:
    """e₃, ω and L as unit vectors at t = 0, in the plane of the paper (yz), to the left of ẑ.

    In the body frame e₃ is along ẑ, in the space frame L.
    """
    start = motion.start()
    e3, omega, momentum = start.e3[0], unit(start.omega_space[0]), unit(start.angular_momentum[0])
    upright = momentum if space else e3
    # Left is where ω and L lean from e₃, and e₃ from L.
    away = e3 if space else momentum
    left = unit(away - (away @ upright) * upright)
    frame = np.array([np.cross(-left, upright), -left, upright])
    first, second, third = (frame @ vector for vector in (e3, omega, momentum))
    return first, second, third


def draw_cones(axes: Axes, motion: Motion, *, space: bool) -> None:
    """The cones of a free symmetric body, and the three arrows in one plane.

    In the body frame ω and L go round e₃; in the space frame ω and e₃ go round L.
    """
    scene = Scene(axes)
    directions = three_directions(motion, space=space)
    upright = directions[2 if space else 0]
    drawn = (
        (look.E3, look.AXIS, 1.0),
        (look.OMEGA_VEC, look.OMEGA, 1.06),
        (look.L_VEC, look.MOMENTUM, 1.18),
    )
    for direction, (_, color, length) in zip(directions, drawn, strict=True):
        angle = math.atan2(
            float(np.linalg.norm(np.cross(upright, direction))), float(upright @ direction)
        )
        if angle > 1e-9:
            rim = circle(upright, angle, length=length)
            scene.ring(rim, color=color, lw=0.9)
            shade(scene, rim, color, 0.12 if color == look.OMEGA else 0.05)
    for direction, (words, color, length) in zip(directions, drawn, strict=True):
        high = 1.35 if direction is upright else length  # its name above the rims
        scene.arrow(high * direction, words, color=color, lw=1.5)
    paper(axes, (-1.0, 1.0), (-0.03, 1.4))


def shade(scene: Scene, rim: Floats, color: str, alpha: float) -> None:
    """The mantle of a cone from the origin to its rim (N, 3), with its two edges."""
    across, up, _ = scene.view(rim)
    scene.face([*rim, np.zeros(3)], color=color, alpha=alpha, lw=0, zorder=1)
    turn = np.unwrap(np.arctan2(across, up))
    if np.ptp(turn) < math.pi:  # else the eye looks into it, and there is no edge
        for i in (int(np.argmax(turn)), int(np.argmin(turn))):
            scene.line([np.zeros(3), rim[i]], color=color, lw=0.6, alpha=0.7, zorder=2)


def _cones(**values: float) -> Canvas:
    drawn = canvas(look.TEXT, 2.15)
    motion = free_motion(**values)
    left, right = drawn.subplots(1, 2)
    draw_cones(left, motion, space=False)
    draw_cones(right, motion, space=True)
    left.set_title("body frame")
    right.set_title("space frame")
    return drawn


def _rates(motion: Motion) -> tuple[float, float]:
    """Ω_b of (3.40), and Ω_s: how fast the plane turns in the body and in space."""
    lambda1, _, lambda3 = motion.body.moments
    return (lambda1 - lambda3) * motion.omega[2] / lambda1, motion.mean_precession


def _relation(lambda1: float, lambda3: float) -> str:
    return ">" if lambda1 > lambda3 else "<" if lambda1 < lambda3 else "="


def _shape(lambda1: float, lambda3: float) -> str:
    return f"$λ₁ = {said(lambda1)} {_relation(lambda1, lambda3)} λ₃ = {said(lambda3)}$ kg m²"


def _cones_caption(lambda1: float, lambda3: float, omega_0: float, omega3: float) -> str:
    in_body, in_space = _rates(free_motion(lambda1, lambda3, omega_0, omega3))
    return (
        f"The cones of a free symmetric body with {_shape(lambda1, lambda3)}, $ω₀ = "
        f"{said(omega_0)}$ and $ω₃ = {said(omega3)}$ rad/s. Left: in the body frame $𝛚$ and $𝐋$ go "
        f"round $-e₃$ at $Ω_b = {said(in_body)}$ rad/s. Right: in the space frame $𝐋$ stands "
        f"still, and the plane of the three turns about it at $Ω_s = L/λ₁ = "
        f"{said(in_space)}$ rad/s."
    )


def _cones_in_words(lambda1: float, lambda3: float, omega_0: float, omega3: float) -> str:
    motion = free_motion(lambda1, lambda3, omega_0, omega3)
    e3, omega, momentum = three_directions(motion, space=False)
    tilt = math.degrees(math.acos(min(1.0, float(e3 @ omega))))
    lean = math.degrees(math.acos(min(1.0, float(e3 @ momentum))))
    return (
        "Two drawings of three arrows from one point, always in one plane. In the body frame the "
        f"arrow e3 stands upright and the tips of omega and of L, {spoken(tilt)} and "
        f"{spoken(lean)} degrees from it, go round it on circles. In the space frame L stands "
        "upright, omega and e3 go round it."
    )


CONES = Drawing(
    "cones",
    "The cones of a free symmetric body, in the body frame and in space",
    "3.2.3",
    BODY,
    _cones,
    _cones_caption,
    _cones_in_words,
    motions=one(free_motion),
)


# --- The body cone rolls on the space cone -------------------------------------------------------

STRIPES = 12
"""Lines on each cone, so that the rolling can be seen."""


def draw_rolling_cones(axes: Axes, motion: Motion, t: float = 0.0) -> None:
    """The body cone, fixed in the body, on the space cone at the time `t` (s), in the space frame.

    They touch along ω, which is the line that is at rest for a moment; L is upright.  Both have
    the length 1 along their mantles.
    """
    scene = Scene(axes, View(elevation=0.34))
    run = motion.exact([0.0, t])
    e3, _, momentum = three_directions(motion, space=True)
    # From the space frame of the motion to that of the paper, in which L is upright.
    start_e3, start_momentum = run.e3[0], unit(run.angular_momentum[0])
    to_paper = _frame(e3, momentum).T @ _frame(start_e3, start_momentum)
    axis = to_paper @ run.e3[1]
    contact = to_paper @ unit(run.omega_space[1])
    momentum = np.array([0.0, 0.0, 1.0])
    first = to_paper @ run.rotation.as_matrix()[1][:, 0]
    space, body = angle_between(contact, momentum), angle_between(contact, axis)
    inside = angle_between(axis, momentum) < body
    around = np.linspace(0, 2 * math.pi, STRIPES, endpoint=False)[:, None]
    second = np.cross(axis, first)
    body_lines = math.cos(body) * axis + math.sin(body) * (
        np.cos(around) * first + np.sin(around) * second
    )
    space_lines = circle(momentum, space, STRIPES + 1)[:-1]
    for apex, half, lines, color, above in (
        (momentum, space, space_lines, look.OMEGA, 2.0 if inside else 1.0),
        (axis, body, body_lines, look.AXIS, 1.0 if inside else 2.0),
    ):
        rim = circle(apex, half)
        shade(scene, rim, color, 0.13)
        scene.ring(rim, color=color, lw=1.0, zorder=2 + above)
        middle = scene.view(rim)[2].mean()
        for line in lines:
            alpha = 0.6 if scene.view(line)[2] >= middle else 0.2
            scene.line([np.zeros(3), line], color=color, lw=0.6, alpha=alpha, zorder=2)
    scene.arrow(1.25 * axis, look.E3, color=look.AXIS, lw=1.3)
    scene.arrow(1.32 * momentum, look.L_VEC, color=look.MOMENTUM, lw=1.3)
    aside = math.copysign(10, scene.view(contact)[0]), 0.0  # away from the name of L
    scene.arrow(1.2 * contact, look.OMEGA_VEC, shift=aside, color=look.OMEGA, lw=1.9, zorder=6)


def angle_between(first: Floats, second: Floats) -> float:
    """Of two unit vectors (rad)."""
    return math.atan2(float(np.linalg.norm(np.cross(first, second))), float(first @ second))


def _frame(e3: Floats, momentum: Floats) -> Floats:
    """Rows: an orthonormal frame from the plane of two directions."""
    across = unit(np.cross(momentum, e3))
    return np.array([momentum, across, np.cross(momentum, across)])


def _rolling(lambda1: float, lambda3: float, lambda3_right: float, **omega: float) -> list[Motion]:
    moments = ((lambda1, lambda3), (lambda1, lambda3_right))
    return [free_motion(first, third, **omega) for first, third in moments]


def _draw_rolling(**values: float) -> Canvas:
    return _rolling_cones(-0.12, **values).canvas


def _rolling_film(**values: float) -> Film:
    """With room below for a body cone that comes towards the eye."""
    return _rolling_cones(-0.5, **values)


def _rolling_cones(low: float, **values: float) -> Film:
    """A turn of each about L; `low` is the lower edge of the paper."""
    drawn = Canvas(figsize=(look.TEXT, 2.3))
    axes = [drawn.add_axes((left, 0.0, 0.48, 0.9)) for left in (0.01, 0.51)]
    motions = _rolling(**values)

    def show(share: float) -> None:
        for each, motion in zip(axes, motions, strict=True):
            each.clear()
            draw_rolling_cones(each, motion, share * 2 * math.pi / motion.mean_precession)
            paper(each, (-1.3, 1.3), (low, 1.45))
            lambda1, _, lambda3 = motion.body.moments
            each.set_title(rf"$\lambda_1 {_relation(lambda1, lambda3)} \lambda_3$")

    show(0.0)
    return Film(drawn, show)


def _half_angles(motion: Motion) -> tuple[float, float]:
    """Of the body cone and of the space cone (rad)."""
    e3, omega, momentum = three_directions(motion, space=True)
    return angle_between(e3, omega), angle_between(momentum, omega)


def _touching(motion: Motion) -> str:
    lambda1, _, lambda3 = motion.body.moments
    body, space = (math.degrees(angle) for angle in _half_angles(motion))
    if lambda1 == lambda3:
        return "$𝛚$, $𝐋$ and the space cone are one line"
    how = "rolls on the outside of" if lambda1 > lambda3 else "rolls with its inside on"
    return (
        f"the body cone, of half angle ${said(body)}°$, {how} the space cone, of ${said(space)}°$, "
        f"and goes round $𝐋$ at $Ω_s = {said(_rates(motion)[1])}$ rad/s"
    )


def _rolling_caption(**values: float) -> str:
    left, right = _rolling(**values)
    return (
        "The body cone (red, about $e₃$) rolls without slipping on the space cone (blue, about "
        "$𝐋$): they touch along $𝛚$. Left, "
        f"{_shape(values['lambda1'], values['lambda3'])}: {_touching(left)}. Right, "
        f"{_shape(values['lambda1'], values['lambda3_right'])}: {_touching(right)}. $ω₀ = "
        f"{said(values['omega_0'])}$ and $ω₃ = {said(values['omega3'])}$ rad/s."
    )


def _rolling_in_words(**values: float) -> str:
    parts = []
    for motion in _rolling(**values):
        body, space = (spoken(math.degrees(angle)) for angle in _half_angles(motion))
        parts.append(f"a body cone of half angle {body} and a space cone of {space} degrees")
    return (
        "Two pairs of cones with their tips at one point, which touch along the arrow omega: "
        f"{'; '.join(parts)}. The space cone stands upright about L, the body cone leans about e3. "
        "Where lambda1 is larger than lambda3 they touch from outside, else the body cone "
        "contains the space cone."
    )


ROLLING_CONES = Drawing(
    "rolling-cones",
    "The body cone rolls on the space cone",
    "3.2.3",
    (
        BODY[0],
        Parameter("lambda3", 0.5, "moment about the axis, left", "kg m²", above=0),
        Parameter("lambda3_right", 1.7, "moment about the axis, right", "kg m²", above=0),
        Parameter("omega_0", 0.7, "magnitude of $𝛚$ across the axis", "rad/s", above=0),
        BODY[3],
    ),
    _draw_rolling,
    _rolling_caption,
    _rolling_in_words,
    _rolling_film,
    motions=_rolling,
)
