"""Section 3.2.3: e₃, ω and L of a symmetric body; the Earth, and a plate thrown in the air."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, cos, hypot, pi, sin, sqrt, tan

import numpy as np
from numpy.typing import NDArray

from rigidtop.derivations.precession_of_rotation_axis import (
    body_precession,
    constant_angle,
    coplanar,
    same_frequency,
    space_cone,
)
from rigidtop.errors import RigidtopError
from rigidtop.motion.body import FreeBody
from rigidtop.motion.trajectory import Trajectory
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure

from .bodies import FREE1, LAMBDA3, angles

Vectors = NDArray[np.float64]

ACROSS = Parameter(
    "omega_0",
    0.6,
    r"$\boldsymbol\omega$ across $\mathbf e_3$ at the start, along $\mathbf e_1$",
    "rad/s",
    above=0,
)
ALONG = Parameter("omega3", 2.0, r"$\omega_3$ at the start", "rad/s", above=0)

UPWARD = (0.0, 0.0, 1.0)
PARALLEL = 1e-7
"""Two directions this near (rad) span no plane that rounding leaves in its place."""

MOST_ANGLE = 1e4
"""No body is followed for longer than it takes to turn by this (rad)."""


def turned(vectors: Vectors, axis: Vectors) -> float:
    """By how much the rows of an array (N, 3) turn about `axis`, whole turns counted (rad)."""
    unit = axis / np.linalg.norm(axis)
    across = vectors - np.outer(vectors @ unit, unit)
    forward = np.sum(across[:-1] * across[1:], axis=1)
    sideways = np.cross(across[:-1], across[1:]) @ unit
    return float(np.arctan2(sideways, forward).sum())


def way(vectors: Vectors, axis: Vectors) -> float:
    """How far the tips of the rows of an array (N, 3) go on their circle about `axis`."""
    distance = np.linalg.norm(np.cross(vectors, axis / np.linalg.norm(axis)), axis=1)
    return abs(turned(vectors, axis)) * float(distance.mean())


# --- angles and plane --------------------------------------------------------------------------


widest_angle = Claim(
    "widest-angle",
    r"The angle between $\boldsymbol\omega$ and $\mathbf L$, and the widest that a body allows.",
)


@exercise(
    "cone-plane",
    r"The angles between $\mathbf e_3$, $\boldsymbol\omega$ and $\mathbf L$, and their plane",
    section="3.2.3",
    asks="constant angle",
    statement=r"A body with $\lambda_1 = \lambda_2$ turns with $\omega_0$ across $\mathbf e_3$ and "
    r"$\omega_3$ along it. What angles do $\mathbf e_3$, $\boldsymbol\omega$ and "
    r"$\mathbf L$ make with each other, which of $\boldsymbol\omega$ and $\mathbf L$ is "
    r"nearer to $\mathbf e_3$, and how large can the angle between $\boldsymbol\omega$ "
    r"and $\mathbf L$ be for such a body? Convince yourself on a computed motion that "
    "the angles stay and that the three remain in one plane.\n\nNow let $\\lambda_2$ "
    r"differ from $\lambda_1$. By how much do the angles vary, and how far does "
    r"$\mathbf e_3$ leave the plane of $\boldsymbol\omega$ and $\mathbf L$?",
    claims=(constant_angle, coplanar, same_frequency, widest_angle),
    parameters=(
        FREE1,
        Parameter("lambda2", 1.5, r"$\lambda_2$ of the body without symmetry", "kg m²", above=0),
        LAMBDA3,
        ACROSS,
        ALONG,
    ),
    figure="cones",
    text="exercises/cone_plane",
)
def cone_plane(
    lambda1: float, lambda2: float, lambda3: float, omega_0: float, omega3: float
) -> Iterator[Outcome]:
    r"""The angles follow from (3.38) and (3.39). Both bodies are followed by integration. Where
    $\lambda_2 \neq \lambda_1$, the angle between $\boldsymbol\omega$ and $\mathbf L$ is least
    and greatest where $\omega_2 = 0$ and where $\omega_2^2$ is largest, a quarter of a turn of
    $\boldsymbol\omega$ in the body later, since at given $T$ and $L^2$ the square $|\omega|^2$
    is linear in $\omega_2^2$."""
    tilt, momentum_tilt = atan2(omega_0, omega3), atan2(lambda1 * omega_0, lambda3 * omega3)
    between = abs(momentum_tilt - tilt)
    if between < PARALLEL:
        raise RigidtopError(
            "ω and L are parallel, as far as numbers tell, and span no plane: let lambda1 and "
            "lambda3 differ more, and omega_0 and omega3 less"
        )
    nearest = r"$\boldsymbol\omega$" if lambda1 > lambda3 else r"$\mathbf L$"
    yield Answer("e3_omega", r"angle between $\mathbf e_3$ and $\boldsymbol\omega$", tilt, "rad")
    yield Answer("e3_L", r"angle between $\mathbf e_3$ and $\mathbf L$", momentum_tilt, "rad")
    yield Answer("omega_L", r"angle between $\boldsymbol\omega$ and $\mathbf L$", between, "rad")
    yield Answer(
        "nearest",
        r"which of $\boldsymbol\omega$ and $\mathbf L$ is nearer to $\mathbf e_3$",
        nearest,
    )
    widest = atan2(abs(lambda1 - lambda3), 2 * sqrt(lambda1 * lambda3))
    yield Answer(
        "widest",
        r"largest angle between $\boldsymbol\omega$ and $\mathbf L$ for this body",
        widest,
        "rad",
    )
    yield Answer(
        "widest_at",
        r"angle between $\mathbf e_3$ and $\boldsymbol\omega$ there",
        atan2(sqrt(lambda3), sqrt(lambda1)),
        "rad",
    )
    rows: list[tuple[float | str, ...]] = []
    start = (omega_0, 0.0, omega3)
    for name, second in (
        (r"$\lambda_2 = \lambda_1$", lambda1),
        (r"$\lambda_2 \neq \lambda_1$", lambda2),
    ):
        motion = FreeBody(lambda1, second, lambda3).motion(omega=start)
        period = motion.nutation_period
        # Where nothing turns there is no period; any time shows that nothing does.
        span = period if np.isfinite(period) else 2 * pi / hypot(omega_0, omega3)
        if span * hypot(omega_0, omega3) > MOST_ANGLE:
            raise RigidtopError(
                f"{name}: ω takes {span:.3g} s to come back, too many turns to follow here"
            )
        path = motion.integrate(np.linspace(0, span, 401), rtol=1e-11, atol=1e-13)
        seen = cone_angles(path)
        rows += [(name, what, float(x.min()), float(x.max())) for what, x in seen.items()]
        found = seen[r"$\boldsymbol\omega$ and $\mathbf L$"]
        ends = cone_angles(motion.exact([0.0, span / 2]))[r"$\boldsymbol\omega$ and $\mathbf L$"]
        if second == lambda1:
            expected = {
                r"$\mathbf e_3$ and $\boldsymbol\omega$": tilt,
                r"$\mathbf e_3$ and $\mathbf L$": momentum_tilt,
            }
            expected |= {
                r"$\boldsymbol\omega$ and $\mathbf L$": between,
                r"$\mathbf e_3$ out of their plane": 0.0,
            }
            errors = [abs(values - expected[what]).max() for what, values in seen.items()]
            yield Measure("angles of the integrated motion (rad)", float(max(errors)), 1e-8)
        else:
            variation = float(abs(ends[1] - ends[0]))
            yield Answer(
                "variation",
                r"by how much the angle between $\boldsymbol\omega$ and $\mathbf L$ varies if "
                r"$\lambda_2 \neq \lambda_1$",
                variation,
                "rad",
            )
            yield Measure(
                "this variation along the integrated motion (rad)",
                abs(float(np.ptp(found)) - variation),
                1e-8,
            )
    yield Table(
        "angles",
        "Over a period of an integrated motion",
        ("body", "angle", "least (rad)", "greatest (rad)"),
        tuple(rows),
    )


def cone_angles(path: Trajectory) -> dict[str, Vectors]:
    """The three angles, and that of e₃ with the plane of ω and L, along a motion (N,)."""
    omega, momentum, axis = path.omega_space, path.angular_momentum, path.e3
    normal = np.cross(omega, momentum)
    height = np.abs(np.sum(axis * normal, axis=1))
    return {
        r"$\mathbf e_3$ and $\boldsymbol\omega$": angles(axis, omega),
        r"$\mathbf e_3$ and $\mathbf L$": angles(axis, momentum),
        r"$\boldsymbol\omega$ and $\mathbf L$": angles(omega, momentum),
        r"$\mathbf e_3$ out of their plane": np.arctan2(
            height, np.linalg.norm(np.cross(axis, normal), axis=1)
        ),
    }


# --- cones that roll ---------------------------------------------------------------------------


rolling = Claim("rolling-cones", "The body cone rolls on the space cone without slipping.")


@exercise(
    "space-rate",
    "How fast the cones turn",
    section="3.2.3",
    asks=r"$\Omega_s = L/\lambda_1$, “technically tricky”",
    statement=r"A body with $\lambda_1 = \lambda_2$ turns with $\omega_0$ across $\mathbf e_3$ and "
    r"$\omega_3$ along it. How fast does $\boldsymbol\omega$ turn about $\mathbf e_3$ in "
    r"the body, and the plane of $\mathbf e_3$ and $\boldsymbol\omega$ about $\mathbf L$ "
    "in space? Give both periods and the half angles of the cones on which "
    "$\\boldsymbol\\omega$ moves.\n\nShow that one cone rolls on the other without "
    "slipping. What is different for a flat body?",
    claims=(body_precession, space_cone, rolling),
    parameters=(FREE1, LAMBDA3, ACROSS, ALONG),
    figure="rolling-cones",
    text="exercises/space_rate",
)
def space_rate(lambda1: float, lambda3: float, omega_0: float, omega3: float) -> Iterator[Outcome]:
    r"""Rates and angles are those of section 3.2.3. The motion is integrated over one turn in
    space; the turns of $\mathbf e_3$ about $\mathbf L$ and of $\boldsymbol\omega$ about
    $\mathbf e_3$ are counted, and the paths of the tip of $\boldsymbol\omega$ over the two cones
    measured, which are equally long if nothing slips."""
    body = FreeBody(lambda1, lambda1, lambda3)
    body_rate, space = cone_rates(lambda1, lambda3, omega_0, omega3)
    size = hypot(omega_0, omega3)
    tilt, momentum_tilt = atan2(omega_0, omega3), atan2(lambda1 * omega_0, lambda3 * omega3)
    yield Answer("angular_momentum", "$L$", lambda1 * space, "J s")
    yield Answer(
        "Omega_b",
        r"$\Omega_b$, the rate of $\boldsymbol\omega$ about $-\mathbf e_3$ in the body",
        body_rate,
        "rad/s",
    )
    yield Answer(
        "Omega_s",
        r"$\Omega_s$, the rate of $\mathbf e_3$ and $\boldsymbol\omega$ about $\mathbf L$ in space",
        space,
        "rad/s",
    )
    if body_rate:
        yield Answer("period_body", "period in the body", 2 * pi / abs(body_rate), "s")
    yield Answer("period_space", "period in space", 2 * pi / space, "s")
    yield Answer(
        "body_cone",
        r"half angle of the body cone, of $\boldsymbol\omega$ about $\mathbf e_3$",
        tilt,
        "rad",
    )
    space_half = abs(momentum_tilt - tilt)
    yield Answer(
        "space_cone",
        r"half angle of the space cone, of $\boldsymbol\omega$ about $\mathbf L$",
        space_half,
        "rad",
    )
    yield Answer(
        "axis_cone",
        r"half angle of the cone of $\mathbf e_3$ about $\mathbf L$",
        momentum_tilt,
        "rad",
    )
    kind = (
        "on the space cone"
        if body_rate > 0
        else "around the space cone"
        if body_rate < 0
        else "not at all"
    )
    yield Answer("kind", "the body cone rolls", kind)
    shapes = (
        (r"rod, $\lambda_3 \ll \lambda_1$", 0.0),
        ("cube", 1.0),
        (r"plate, $\lambda_3 = 2\lambda_1$", 2.0),
    )
    yield Table(
        "shapes",
        r"Other bodies with the same $\boldsymbol\omega$",
        ("body", r"$\Omega_b/\omega_3$", r"$\Omega_s/\omega_3$", "space cone (rad)"),
        tuple(
            (
                name,
                1 - ratio,
                hypot(omega_0, ratio * omega3) / omega3,
                abs(atan2(omega_0, ratio * omega3) - tilt),
            )
            for name, ratio in shapes
        ),
    )
    # Enough samples that no step is half a turn, neither in space nor in the body.
    samples = 721 + int(8 * abs(body_rate) / space)
    path = body.motion(omega=(omega_0, 0.0, omega3)).integrate(
        np.linspace(0, 2 * pi / space, samples), rtol=1e-12, atol=1e-14
    )
    axis = path.angular_momentum[0]
    yield Measure(
        r"$\mathbf e_3$ about $\mathbf L$ after one turn, integrated "
        "(rad)",
        abs(turned(path.e3, axis) - 2 * pi),
        1e-8,
    )
    about_axis = turned(path.omega, np.array(UPWARD))
    yield Measure(
        r"$\boldsymbol\omega$ about $\mathbf e_3$ meanwhile, against $-2\pi \Omega_b/\Omega_s$ "
        "(rad)",
        abs(about_axis + 2 * pi * body_rate / space),
        1e-8 * (1 + abs(body_rate) / space),
    )
    ways = [way(path.omega, np.array(UPWARD)), way(path.omega_space, axis)]
    yield Measure(
        r"way of the tip of $\boldsymbol\omega$ over the body cone less that over the space cone, "
        r"in $|\omega|$",
        abs(ways[0] - ways[1]) / size,
        1e-8 * (1 + abs(body_rate) / space),
    )


def cone_rates(
    lambda1: float, lambda3: float, omega_0: float, omega3: float
) -> tuple[float, float]:
    """Ω_b of (3.40) and Ω_s = L/λ₁ (rad/s)."""
    return (lambda1 - lambda3) * omega3 / lambda1, hypot(omega_0, lambda3 * omega3 / lambda1)


# --- the Earth ---------------------------------------------------------------------------------


euler_period = Claim(
    "euler-period", "The Euler period in turns of the body, and what a yielding bulge adds."
)


ROUNDING = 1e-12

DAY = 86400.0
"""A mean solar day (s)."""


@exercise(
    "earth-euler-period",
    "The Euler period of the Earth",
    section="3.2.3",
    asks="free rotation in the solar system",
    statement=r"The Earth bulges at the equator: $H = (\lambda_3 - \lambda_1)/\lambda_3$ is known "
    "from the precession of the equinoxes (IERS Conventions 2010, Table 1.1). How long "
    "would its axis of rotation take to go once around the pole of its figure if it were "
    "rigid, and which way around?\n\nThe wobble that Chandler found has another period "
    "today. What share of the bulge must follow the axis of rotation to explain it? How "
    "far from the pole of the figure does the axis meet the ground?",
    claims=(body_precession, euler_period),
    parameters=(
        # IERS Conventions 2010 (TN 36), Tables 1.1 and 1.2: H, Ω, and the polar radius a(1 − f).
        Parameter("H", 3273795e-9, "$H$, the dynamical ellipticity", above=0, most=0.5),
        Parameter("omega3", 7.292115e-5, "rate of rotation", "rad/s", above=0),
        Parameter("observed", 433.0, "period of Chandler's wobble", "days", above=0),
        Parameter(
            "angle",
            pi / 180 / 36000,
            r"angle between $\boldsymbol\omega$ and $\mathbf e_3$",
            "rad",
            above=0,
            most=0.1,
        ),
        Parameter("radius", 6356751.9, "distance of the pole from the centre", "m", above=0),
    ),
    figure="polar-motion",
    text="exercises/earth_euler_period",
)
def earth_euler_period(
    H: float, omega3: float, observed: float, angle: float, radius: float
) -> Iterator[Outcome]:
    """Euler's period is that of (3.40). The share of the bulge follows from the rate of the wobble,
    solved for $k$, and the period that is observed."""
    turns = (1 - H) / H
    sidereal = 2 * pi / omega3
    period = turns * sidereal / DAY
    # P = P_E (1 + kH/(1 − H))/(1 − k), solved for k.
    ratio = observed / period
    share = (ratio - 1) / (ratio + H / (1 - H))
    if share < -ROUNDING:
        raise RigidtopError(
            f"observed = {observed:g} must be at least Euler's period, {period:.6g} days: a bulge "
            "that follows the axis makes the period longer"
        )
    yield Answer("turns", "Euler period in turns of the Earth (sidereal days)", turns)
    yield Answer("period", "Euler period", period, "days")
    yield Answer(
        "direction",
        r"$\boldsymbol\omega$ goes around $\mathbf e_3$",
        "eastwards, as the Earth turns",
    )
    yield Answer("observed", "Chandler's period over Euler's", ratio)
    yield Answer(
        "share", r"share $k$ of the bulge that follows $\boldsymbol\omega$ to explain it", share
    )
    yield Answer("ground", "distance of the poles on the ground", radius * tan(angle), "m")
    space = omega3 * hypot(tan(angle), 1 / (1 - H))
    yield Answer(
        "space_period",
        r"of a rigid Earth: turn of $\mathbf e_3$ about $\mathbf L$ in space",
        2 * pi / space / DAY,
        "days",
    )
    momentum_tilt = atan2((1 - H) * tan(angle), 1.0)
    yield Answer(
        "space_cone",
        r"of a rigid Earth: angle of $\boldsymbol\omega$ and $\mathbf L$",
        angle - momentum_tilt,
        "rad",
    )

    # A = 1 − H in units of C, and time in turns over 2π.
    body = FreeBody(1 - H, 1 - H, 1.0)
    motion = body.motion(omega=(tan(angle), 0.0, 1.0))
    whole = 2 * pi * turns
    back = motion.exact(whole).omega[0] - np.array([tan(angle), 0.0, 1.0])
    yield Measure(
        r"$\omega$ after one Euler period, in closed form, relative to the wobble",
        float(np.linalg.norm(back)) / tan(angle),
        1e-9 + 1e-15 / tan(angle),  # and what rounding does to ω itself
    )
    tenth = motion.integrate(whole / 10, rtol=1e-12, atol=1e-14).omega[0]
    # Eastwards is the sense of the rotation itself: from e₁ to e₂.
    yield Measure(
        r"azimuth of $\omega$ after a tenth, integrated (rad)",
        abs(atan2(tenth[1], tenth[0]) - 2 * pi / 10),
        1e-8,
    )
    bulge = (1 - share) * H * omega3 / (1 - H + share * H)
    yield Measure(
        "period of the yielding Earth by the claim, against the observed one, relative",
        abs(2 * pi / bulge / DAY / observed - 1),
        1e-12 * (1 + ratio),
    )


# --- Feynman's plate ---------------------------------------------------------------------------


wobble_to_spin = Claim(
    "wobble-to-spin", "A flat plate wobbles twice as fast as it spins, and faster when tilted."
)


def plate(radius: float, thickness: float) -> FreeBody:
    """A disc of the mass 1 kg; the mass has no part in its motion."""
    lambda1, lambda3 = (3 * radius**2 + thickness**2) / 12, radius**2 / 2
    return FreeBody(lambda1, lambda1, lambda3)


def plate_rates(body: FreeBody, theta: float, omega3: float) -> tuple[float, float]:
    """The wobble, and the mean rate of a mark on the rim, seen along L: φ̇ and φ̇ + ψ̇ (rad/s)."""
    wobble = body.lambda3 / (body.lambda1 * cos(theta)) * omega3
    # With ω₃ = ψ̇ + φ̇ cosθ.
    return wobble, omega3 + wobble * (1 - cos(theta))


@exercise(
    "wobbling-plate",
    "Feynman's wobbling plate",
    section="3.2.3",
    asks="throw objects up in your room",
    statement="A plate, a disc of radius $r$ and thickness $h$, is thrown up spinning and "
    r"wobbling, its axis tilted by $\theta$ from $\mathbf L$. How fast does it wobble, "
    "how fast does a mark on its rim go around, and what is the ratio of the two? How "
    "does it depend on $\\theta$ and on the thickness?\n\nFeynman saw such a plate in a "
    "dining hall and remembered that the mark goes around twice as fast as the plate "
    "wobbles. Was he right?",
    claims=(space_cone, wobble_to_spin),
    parameters=(
        Parameter(
            "theta", pi / 36, r"tilt of $\mathbf e_3$ from $\mathbf L$", "rad", above=0, most=1.4
        ),
        Parameter("radius", 0.12, "radius of the plate", "m", above=0),
        Parameter("thickness", 0.004, "thickness of the plate", "m", above=0),
        Parameter("omega3", 15.0, r"$\omega_3$", "rad/s", above=0),
    ),
    figure="wobbling-plate",
    text="exercises/wobbling_plate",
)
def wobbling_plate(
    theta: float, radius: float, thickness: float, omega3: float
) -> Iterator[Outcome]:
    r"""It is the wobble that is twice as fast; Feynman remembered the two exchanged (Chao 1989,
    Physics Today 42:15). In a motion integrated over five wobbles the turns of $\mathbf e_3$
    about $\mathbf L$, and those of a mark on the rim as seen along $\mathbf L$, come out the
    same."""
    body = plate(radius, thickness)
    flatness = body.lambda3 / body.lambda1
    wobble, mark = plate_rates(body, theta, omega3)
    yield Answer("moments", r"$\lambda_3/\lambda_1$, 2 for a flat plate", flatness)
    yield Answer("wobble", r"rate of the wobble, $\Omega_s = L/\lambda_1$", wobble, "rad/s")
    yield Answer("ratio", r"wobble over spin, $\Omega_s/\omega_3$", wobble / omega3)
    yield Answer("mark", r"mean rate of a mark on the rim, seen along $\mathbf L$", mark, "rad/s")
    yield Answer("wobble_to_mark", "wobble over mark", wobble / mark)
    yield Answer("memory", "wobble over mark as Feynman remembered it", 0.5)
    tilts = [(f"{degrees}°", pi / 180 * degrees) for degrees in (1, 5, 10, 20, 45)]
    yield Table(
        "tilts",
        "The same plate, and a flat one, at other tilts",
        (
            r"$\theta$",
            r"$\Omega_s/\omega_3$",
            r"$\Omega_s/\omega_3$, flat",
            "wobble over mark, flat",
        ),
        tuple((said, flatness / cos(x), 2 / cos(x), 2 / (2 - cos(x))) for said, x in tilts),
    )
    turns = 5
    start = body.motion(omega=(wobble * sin(theta), 0.0, omega3))
    path = start.integrate(
        np.linspace(0, turns * 2 * pi / wobble, 200 * turns + 1), rtol=1e-12, atol=1e-14
    )
    axis = path.angular_momentum[0]
    yield Measure(
        r"$\mathbf e_3$ about $\mathbf L$ after five wobbles, integrated (rad)",
        abs(turned(path.e3, axis) - 2 * pi * turns),
        1e-8,
    )
    # φ + ψ: e₃ about L, and the body about e₃ against L, which it sees turn the other way.
    spun = -turned(path.omega * np.array(body.moments), np.array(UPWARD))
    yield Measure(
        "the mark meanwhile, integrated (rad)",
        abs(turned(path.e3, axis) + spun - 2 * pi * turns * mark / wobble),
        1e-8,
    )
    yield Measure(
        r"angle of $\mathbf e_3$ and $\mathbf L$, in closed form "
        "(rad)",
        abs(start.turning_points[1] - theta),
        1e-12,
    )


EXERCISES: tuple[Exercise, ...] = (cone_plane, space_rate, earth_euler_period, wobbling_plate)
