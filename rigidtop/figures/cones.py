"""The cones on which e₃, ω and L of a free symmetric body go round each other."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film, film, one
from rigidtop.figures.space import UPRIGHT, View, circle, ring, unit
from rigidtop.figures.style import Floats
from rigidtop.motion.body import FreeBody
from rigidtop.motion.motion import Motion
from rigidtop.parameters import Parameter

ACROSS = r"magnitude of $\boldsymbol\omega$ across the axis"
BODY = (
    Parameter("lambda1", 1.0, "moment across the axis", "kg m²", above=0),
    Parameter("lambda3", 0.55, "moment about the axis", "kg m²", above=0),
    Parameter("omega_0", 0.45, ACROSS, "rad/s", above=0),
    Parameter("omega3", 1.0, r"$\omega_3$", "rad/s", above=0),
)


def free_motion(lambda1: float, lambda3: float, omega_0: float, omega3: float) -> Motion:
    """(3.38) at t = 0: ω = (ω₀, 0, ω₃)."""
    return FreeBody(lambda1, lambda1, lambda3).motion(omega=(omega_0, 0.0, omega3))


def on_paper(motion: Motion, *, space: bool) -> tuple[Floats, Floats]:
    """e₃, ω and L (3, 3) as unit vectors at t = 0, in the plane of the paper (yz), to the left of
    ẑ; and the matrix that brings them there.

    In the body frame e₃ is along ẑ, in the space frame L.
    """
    start = motion.start()
    vectors = np.array([start.e3[0], start.omega_space[0], start.angular_momentum[0]])
    vectors /= np.linalg.norm(vectors, axis=1)[:, None]
    # Left is where ω and L lean from e₃, and e₃ from L.
    upright, away = vectors[[2, 0] if space else [0, 2]]
    left = unit(away - (away @ upright) * upright)
    matrix = np.array([np.cross(-left, upright), -left, upright])
    return vectors @ matrix.T, matrix


def draw_cones(axes: Axes, motion: Motion, *, space: bool) -> None:
    """The cones of a free symmetric body, and the three arrows in one plane.

    In the body frame ω and L go round e₃; in the space frame ω and e₃ go round L.
    """
    directions, _ = on_paper(motion, space=space)
    upright = directions[2 if space else 0]
    parts: list[pen.Part] = []
    looks = (
        (look.E3, look.AXIS, 1.0, 0.05),
        (look.OMEGA_VEC, look.OMEGA, 1.06, 0.12),
        (look.L_VEC, look.MOMENTUM, 1.18, 0.05),
    )
    for direction, (words, color, length, alpha) in zip(directions, looks, strict=True):
        angle = angle_between(upright, direction)
        if angle > 1e-9:
            parts += solids.cone_mantle(circle(upright, angle, length=length), color, alpha)
        high = 1.35 if np.all(direction == upright) else length  # its name above the rims
        parts.append(pen.Arrow(high * direction, words, color, 1.5))
    pen.picture(axes, parts, (-1.0, 1.0), (-0.03, 1.4))
    axes.set_title("space frame" if space else "body frame")


def angle_between(first: Floats, second: Floats) -> float:
    """Of two unit vectors (rad)."""
    return math.atan2(float(np.linalg.norm(np.cross(first, second))), float(first @ second))


def _cones(body: Axes, space: Axes, **values: float) -> None:
    draw_cones(body, free_motion(**values), space=False)
    draw_cones(space, free_motion(**values), space=True)


def _relation(lambda1: float, lambda3: float) -> str:
    return ">" if lambda1 > lambda3 else "<" if lambda1 < lambda3 else "="


def _cones_facts(lambda1: float, lambda3: float, **omega: float) -> dict[str, Any]:
    motion = free_motion(lambda1, lambda3, **omega)
    (e3, omega3, momentum), _ = on_paper(motion, space=False)
    return {
        "relation": _relation(lambda1, lambda3),
        "tilt": angle_between(e3, omega3),
        "lean": angle_between(e3, momentum),
        "in_body": (lambda1 - lambda3) * motion.omega[2] / lambda1,  # Ω_b of (3.40)
        "in_space": motion.mean_precession,
    }


CONES = Drawing(
    "cones",
    "The cones of a free symmetric body, in the body frame and in space",
    "3.2.3",
    BODY,
    pen.panels(look.TEXT, 2.15, _cones, 1, 2),
    "The cones of a free symmetric body with "
    r"$\lambda_1 = {lambda1} {relation} \lambda_3 = {lambda3}$ kg m², $\omega_0 = {omega_0}$ and "
    r"$\omega_3 = {omega3}$ rad/s. Left: in the body frame $\boldsymbol\omega$ and $\mathbf L$ go "
    r"round $-\mathbf e_3$ at $\Omega_b = {in_body}$ rad/s. Right: in the space frame $\mathbf L$ "
    "stands still, and the plane of the three turns about it at "
    r"$\Omega_s = L/\lambda_1 = {in_space}$ rad/s.",
    "Two drawings of three arrows from one point, always in one plane. In the body frame the arrow "
    "e3 stands upright and the tips of omega and of L, {tilt:°} and {lean:°} degrees from it, go "
    "round it on circles. In the space frame L stands upright, omega and e3 go round it.",
    _cones_facts,
    motions=one(free_motion),
)


# --- The body cone rolls on the space cone -------------------------------------------------------

STRIPES = 12
"""Lines on each cone, so that the rolling can be seen."""


def draw_rolling_cones(axes: Axes, motion: Motion, t: float = 0.0, low: float = -0.12) -> None:
    """The body cone, fixed in the body, on the space cone at the time `t` (s), in the space frame.

    They touch along ω, which is the line that is at rest for a moment; L is upright.  Both have
    the length 1 along their mantles.  The lower edge of the paper is at `low`.
    """
    view, run = View(elevation=0.34), motion.exact(t)
    _, to_paper = on_paper(motion, space=True)
    axis, contact = to_paper @ run.e3[0], to_paper @ unit(run.omega_space[0])
    mark = to_paper @ run.rotation.as_matrix()[0][:, 0]
    space, body = angle_between(contact, UPRIGHT), angle_between(contact, axis)
    inside = angle_between(axis, UPRIGHT) < body
    aside = math.copysign(10, view(contact)[0]), 0.0  # away from the name of L
    parts: list[pen.Part] = [
        *_striped(view, UPRIGHT, space, circle(UPRIGHT, space)[0], look.OMEGA, 4.0 - (not inside)),
        *_striped(view, axis, body, mark, look.AXIS, 4.0 - inside),
        pen.Arrow(1.25 * axis, look.E3, look.AXIS, 1.3),
        pen.Arrow(1.32 * UPRIGHT, look.L_VEC, look.MOMENTUM, 1.3),
        pen.Arrow(1.2 * contact, look.OMEGA_VEC, look.OMEGA, 1.9, shift=aside, z=6),
    ]
    pen.picture(axes, parts, (-1.3, 1.3), (low, 1.45), view)
    lambda1, _, lambda3 = motion.body.moments
    axes.set_title(rf"$\lambda_1 {_relation(lambda1, lambda3)} \lambda_3$")


def _striped(
    view: View, axis: Floats, half: float, mark: Floats, color: str, z: float
) -> list[pen.Part]:
    """A cone of this half angle, with lines on it, the first on the side of a `mark`."""
    centre, radius = math.cos(half) * axis, math.sin(half)
    ends = ring(centre, axis, radius, mark, count=STRIPES + 1)[:-1]
    far = view(ends)[2] < float(view(centre)[2])
    stripes = [
        pen.Curve([pen.ORIGIN, end], color, 0.6, alpha=0.2 if behind else 0.6)
        for end, behind in zip(ends, far, strict=True)
    ]
    return [*solids.cone_mantle(circle(axis, half), color, 0.13, z), *stripes]


def _rolling(lambda1: float, lambda3: float, lambda3_right: float, **omega: float) -> list[Motion]:
    return [free_motion(lambda1, third, **omega) for third in (lambda3, lambda3_right)]


def _rolling_film(low: float = -0.5, **values: float) -> Film:
    """A turn of each about L, with room below for a body cone that comes towards the eye."""
    motions = _rolling(**values)

    def show(share: float, *panels: Axes) -> None:
        for axes, motion in zip(panels, motions, strict=True):
            t = share * 2 * math.pi / motion.mean_precession
            draw_rolling_cones(axes, motion, t, low)

    return film(look.TEXT, 2.3, show, (0.01, 0.0, 0.48, 0.9), (0.51, 0.0, 0.48, 0.9))


def _half_angles(motion: Motion) -> tuple[float, float]:
    """Of the body cone and of the space cone (rad)."""
    (e3, omega, momentum), _ = on_paper(motion, space=True)
    return angle_between(e3, omega), angle_between(momentum, omega)


def _touching(motion: Motion, side: str) -> str:
    lambda1, _, lambda3 = motion.body.moments
    if lambda1 == lambda3:
        return r"$\boldsymbol\omega$, $\mathbf L$ and the space cone are one line"
    how = "rolls on the outside of" if lambda1 > lambda3 else "rolls with its inside on"
    return (
        rf"the body cone, of half angle ${{body_{side}}}^\circ$, {how} the space cone, of "
        rf"${{space_{side}}}^\circ$, and goes round $\mathbf L$ at $\Omega_s = {{rate_{side}}}$ "
        "rad/s"
    )


def _rolling_facts(**values: float) -> dict[str, Any]:
    facts: dict[str, Any] = {}
    for side, motion in zip(("left", "right"), _rolling(**values), strict=True):
        facts[f"body_{side}"], facts[f"space_{side}"] = np.degrees(_half_angles(motion))
        facts[f"rate_{side}"] = motion.mean_precession
        facts[f"relation_{side}"] = _relation(*motion.body.moments[1:])
        facts[f"touching_{side}"] = _touching(motion, side)
    return facts


ROLLING_CONES = Drawing(
    "rolling-cones",
    "The body cone rolls on the space cone",
    "3.2.3",
    (
        BODY[0],
        Parameter("lambda3", 0.5, "moment about the axis, left", "kg m²", above=0),
        Parameter("lambda3_right", 1.7, "moment about the axis, right", "kg m²", above=0),
        replace(BODY[2], default=0.7),
        BODY[3],
    ),
    lambda **values: _rolling_film(-0.12, **values).canvas,
    r"The body cone (red, about $\mathbf e_3$) rolls without slipping on the space cone (blue, "
    r"about $\mathbf L$): they touch along $\boldsymbol\omega$. Left, "
    r"$\lambda_1 = {lambda1} {relation_left} \lambda_3 = {lambda3}$ kg m²: {touching_left}. Right, "
    r"$\lambda_1 = {lambda1} {relation_right} \lambda_3 = {lambda3_right}$ kg m²: "
    r"{touching_right}. $\omega_0 = {omega_0}$ and $\omega_3 = {omega3}$ rad/s.",
    "Two pairs of cones with their tips at one point, which touch along the arrow omega: a body "
    "cone of half angle {body_left} and a space cone of {space_left} degrees; a body cone of half "
    "angle {body_right} and a space cone of {space_right} degrees. The space cone stands upright "
    "about L, the body cone leans about e3. Where lambda1 is larger than lambda3 they touch from "
    "outside, else the body cone contains the space cone.",
    _rolling_facts,
    _rolling_film,
    motions=_rolling,
)
