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

ACROSS = Parameter("omega_0", 0.6, "$𝛚$ across $e₃$ at the start, along $e₁$", "rad/s", above=0)
ALONG = Parameter("omega3", 2.0, "$ω₃$ at the start", "rad/s", above=0)

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
    "widest-angle", "The angle between $𝛚$ and $𝐋$, and the widest that a body allows."
)


@exercise(
    "cone-plane",
    "The angles between $e₃$, $𝛚$ and $𝐋$, and their plane",
    section="3.2.3",
    asks="constant angle",
    statement="A body with $λ₁ = λ₂$ turns with $ω₀$ across $e₃$ and $ω₃$ along it. What angles "
    "do $e₃$, $𝛚$ "
    "and $𝐋$ make with each other, which of $𝛚$ and $𝐋$ is nearer to $e₃$, and how large can the "
    "angle between $𝛚$ and $𝐋$ be for such a body? Convince yourself on a computed motion that "
    "the angles stay and that the three remain in one plane.\n\nNow let $λ₂$ differ from $λ₁$. "
    "By how much do the angles vary, and how far does $e₃$ leave the plane of $𝛚$ and $𝐋$?",
    claims=(constant_angle, coplanar, same_frequency, widest_angle),
    parameters=(
        FREE1,
        Parameter("lambda2", 1.5, "$λ₂$ of the body without symmetry", "kg m²", above=0),
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
    """The angles follow from (3.38) and (3.39). Both bodies are followed by integration. Where $λ₂
    ≠ λ₁$, the angle between $𝛚$ and $𝐋$ is least and greatest where $ω₂ = 0$ and where $ω₂²$ is
    largest, a quarter of a turn of $𝛚$ in the body later, since at given $T$ and $L²$ the square
    $|ω|²$ is linear in $ω₂²$."""
    tilt, momentum_tilt = atan2(omega_0, omega3), atan2(lambda1 * omega_0, lambda3 * omega3)
    between = abs(momentum_tilt - tilt)
    if between < PARALLEL:
        raise RigidtopError(
            "ω and L are parallel, as far as numbers tell, and span no plane: let lambda1 and "
            "lambda3 differ more, and omega_0 and omega3 less"
        )
    nearest = "$𝛚$" if lambda1 > lambda3 else "$𝐋$"
    yield Answer("e3_omega", "angle between $e₃$ and $𝛚$", tilt, "rad")
    yield Answer("e3_L", "angle between $e₃$ and $𝐋$", momentum_tilt, "rad")
    yield Answer("omega_L", "angle between $𝛚$ and $𝐋$", between, "rad")
    yield Answer("nearest", "which of $𝛚$ and $𝐋$ is nearer to $e₃$", nearest)
    widest = atan2(abs(lambda1 - lambda3), 2 * sqrt(lambda1 * lambda3))
    yield Answer("widest", "largest angle between $𝛚$ and $𝐋$ for this body", widest, "rad")
    yield Answer(
        "widest_at", "angle between $e₃$ and $𝛚$ there", atan2(sqrt(lambda3), sqrt(lambda1)), "rad"
    )
    rows: list[tuple[float | str, ...]] = []
    start = (omega_0, 0.0, omega3)
    for name, second in (("$λ₂ = λ₁$", lambda1), ("$λ₂ ≠ λ₁$", lambda2)):
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
        found = seen["$𝛚$ and $𝐋$"]
        ends = cone_angles(motion.exact([0.0, span / 2]))["$𝛚$ and $𝐋$"]
        if second == lambda1:
            expected = {"$e₃$ and $𝛚$": tilt, "$e₃$ and $𝐋$": momentum_tilt}
            expected |= {"$𝛚$ and $𝐋$": between, "$e₃$ out of their plane": 0.0}
            errors = [abs(values - expected[what]).max() for what, values in seen.items()]
            yield Measure("angles of the integrated motion (rad)", float(max(errors)), 1e-8)
        else:
            variation = float(abs(ends[1] - ends[0]))
            yield Answer(
                "variation",
                "by how much the angle between $𝛚$ and $𝐋$ varies if $λ₂ ≠ λ₁$",
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
        "$e₃$ and $𝛚$": angles(axis, omega),
        "$e₃$ and $𝐋$": angles(axis, momentum),
        "$𝛚$ and $𝐋$": angles(omega, momentum),
        "$e₃$ out of their plane": np.arctan2(
            height, np.linalg.norm(np.cross(axis, normal), axis=1)
        ),
    }


# --- cones that roll ---------------------------------------------------------------------------


rolling = Claim("rolling-cones", "The body cone rolls on the space cone without slipping.")


@exercise(
    "space-rate",
    "How fast the cones turn",
    section="3.2.3",
    asks="$Ω_s = L/λ₁$, “technically tricky”",
    statement="A body with $λ₁ = λ₂$ turns with $ω₀$ across $e₃$ and $ω₃$ along it. How fast "
    "does $𝛚$ turn "
    "about $e₃$ in the body, and the plane of $e₃$ and $𝛚$ about $𝐋$ in space? Give both periods "
    "and the half angles of the cones on which $𝛚$ moves.\n\nShow that one cone rolls on the "
    "other without slipping. What is different for a flat body?",
    claims=(body_precession, space_cone, rolling),
    parameters=(FREE1, LAMBDA3, ACROSS, ALONG),
    figure="rolling-cones",
    text="exercises/space_rate",
)
def space_rate(lambda1: float, lambda3: float, omega_0: float, omega3: float) -> Iterator[Outcome]:
    """Rates and angles are those of section 3.2.3. The motion is integrated over one turn in space;
    the turns of $e₃$ about $𝐋$ and of $𝛚$ about $e₃$ are counted, and the paths of the tip of $𝛚$
    over the two cones measured, which are equally long if nothing slips."""
    body = FreeBody(lambda1, lambda1, lambda3)
    body_rate, space = cone_rates(lambda1, lambda3, omega_0, omega3)
    size = hypot(omega_0, omega3)
    tilt, momentum_tilt = atan2(omega_0, omega3), atan2(lambda1 * omega_0, lambda3 * omega3)
    yield Answer("angular_momentum", "$L$", lambda1 * space, "J s")
    yield Answer("Omega_b", "$Ω_b$, the rate of $𝛚$ about $−e₃$ in the body", body_rate, "rad/s")
    yield Answer("Omega_s", "$Ω_s$, the rate of $e₃$ and $𝛚$ about $𝐋$ in space", space, "rad/s")
    if body_rate:
        yield Answer("period_body", "period in the body", 2 * pi / abs(body_rate), "s")
    yield Answer("period_space", "period in space", 2 * pi / space, "s")
    yield Answer("body_cone", "half angle of the body cone, of $𝛚$ about $e₃$", tilt, "rad")
    space_half = abs(momentum_tilt - tilt)
    yield Answer("space_cone", "half angle of the space cone, of $𝛚$ about $𝐋$", space_half, "rad")
    yield Answer("axis_cone", "half angle of the cone of $e₃$ about $𝐋$", momentum_tilt, "rad")
    kind = (
        "on the space cone"
        if body_rate > 0
        else "around the space cone"
        if body_rate < 0
        else "not at all"
    )
    yield Answer("kind", "the body cone rolls", kind)
    shapes = (("rod, $λ₃ ≪ λ₁$", 0.0), ("cube", 1.0), ("plate, $λ₃ = 2λ₁$", 2.0))
    yield Table(
        "shapes",
        "Other bodies with the same $𝛚$",
        ("body", "$Ω_b/ω₃$", "$Ω_s/ω₃$", "space cone (rad)"),
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
        "$e₃$ about $𝐋$ after one turn, integrated (rad)", abs(turned(path.e3, axis) - 2 * pi), 1e-8
    )
    about_axis = turned(path.omega, np.array(UPWARD))
    yield Measure(
        "$𝛚$ about $e₃$ meanwhile, against $−2π Ω_b/Ω_s$ (rad)",
        abs(about_axis + 2 * pi * body_rate / space),
        1e-8 * (1 + abs(body_rate) / space),
    )
    ways = [way(path.omega, np.array(UPWARD)), way(path.omega_space, axis)]
    yield Measure(
        "way of the tip of $𝛚$ over the body cone less that over the space cone, in $|ω|$",
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
    statement="The Earth bulges at the equator: $H = (λ₃ − λ₁)/λ₃$ is known from the precession of "
    "the equinoxes (IERS Conventions 2010, Table 1.1). How long would its axis of rotation take to "
    "go once around the pole of its figure if it were rigid, and which way around?\n\n"
    "The wobble that Chandler found has another period today. What share of the bulge must follow "
    "the axis of rotation to explain it? How far from the pole of the figure does the axis meet "
    "the ground?",
    claims=(body_precession, euler_period),
    parameters=(
        # IERS Conventions 2010 (TN 36), Tables 1.1 and 1.2: H, Ω, and the polar radius a(1 − f).
        Parameter("H", 3273795e-9, "$H$, the dynamical ellipticity", above=0, most=0.5),
        Parameter("omega3", 7.292115e-5, "rate of rotation", "rad/s", above=0),
        Parameter("observed", 433.0, "period of Chandler's wobble", "days", above=0),
        Parameter(
            "angle", pi / 180 / 36000, "angle between $𝛚$ and $e₃$", "rad", above=0, most=0.1
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
    yield Answer("direction", "$𝛚$ goes around $e₃$", "eastwards, as the Earth turns")
    yield Answer("observed", "Chandler's period over Euler's", ratio)
    yield Answer("share", "share $k$ of the bulge that follows $𝛚$ to explain it", share)
    yield Answer("ground", "distance of the poles on the ground", radius * tan(angle), "m")
    space = omega3 * hypot(tan(angle), 1 / (1 - H))
    yield Answer(
        "space_period",
        "of a rigid Earth: turn of $e₃$ about $𝐋$ in space",
        2 * pi / space / DAY,
        "days",
    )
    momentum_tilt = atan2((1 - H) * tan(angle), 1.0)
    yield Answer(
        "space_cone", "of a rigid Earth: angle of $𝛚$ and $𝐋$", angle - momentum_tilt, "rad"
    )

    # A = 1 − H in units of C, and time in turns over 2π.
    body = FreeBody(1 - H, 1 - H, 1.0)
    motion = body.motion(omega=(tan(angle), 0.0, 1.0))
    whole = 2 * pi * turns
    back = motion.exact(whole).omega[0] - np.array([tan(angle), 0.0, 1.0])
    yield Measure(
        "$ω$ after one Euler period, in closed form, relative to the wobble",
        float(np.linalg.norm(back)) / tan(angle),
        1e-9 + 1e-15 / tan(angle),  # and what rounding does to ω itself
    )
    tenth = motion.integrate(whole / 10, rtol=1e-12, atol=1e-14).omega[0]
    # Eastwards is the sense of the rotation itself: from e₁ to e₂.
    yield Measure(
        "azimuth of $ω$ after a tenth, integrated (rad)",
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
    "wobbling, "
    "its axis tilted by $θ$ from $𝐋$. How fast does it wobble, how fast does a mark on its rim go "
    "around, and what is the ratio of the two? How does it depend on $θ$ and on the thickness?\n\n"
    "Feynman saw such a plate in a dining hall and remembered that the mark goes around twice as "
    "fast as the plate wobbles. Was he right?",
    claims=(space_cone, wobble_to_spin),
    parameters=(
        Parameter("theta", pi / 36, "tilt of $e₃$ from $𝐋$", "rad", above=0, most=1.4),
        Parameter("radius", 0.12, "radius of the plate", "m", above=0),
        Parameter("thickness", 0.004, "thickness of the plate", "m", above=0),
        Parameter("omega3", 15.0, "$ω₃$", "rad/s", above=0),
    ),
    figure="wobbling-plate",
    text="exercises/wobbling_plate",
)
def wobbling_plate(
    theta: float, radius: float, thickness: float, omega3: float
) -> Iterator[Outcome]:
    """It is the wobble that is twice as fast; Feynman remembered the two exchanged (Chao 1989,
    Physics Today 42:15). In a motion integrated over five wobbles the turns of $e₃$ about $𝐋$, and
    those of a mark on the rim as seen along $𝐋$, come out the same."""
    body = plate(radius, thickness)
    flatness = body.lambda3 / body.lambda1
    wobble, mark = plate_rates(body, theta, omega3)
    yield Answer("moments", "$λ₃/λ₁$, 2 for a flat plate", flatness)
    yield Answer("wobble", "rate of the wobble, $Ω_s = L/λ₁$", wobble, "rad/s")
    yield Answer("ratio", "wobble over spin, $Ω_s/ω₃$", wobble / omega3)
    yield Answer("mark", "mean rate of a mark on the rim, seen along $𝐋$", mark, "rad/s")
    yield Answer("wobble_to_mark", "wobble over mark", wobble / mark)
    yield Answer("memory", "wobble over mark as Feynman remembered it", 0.5)
    tilts = [(f"{degrees}°", pi / 180 * degrees) for degrees in (1, 5, 10, 20, 45)]
    yield Table(
        "tilts",
        "The same plate, and a flat one, at other tilts",
        ("$θ$", "$Ω_s/ω₃$", "$Ω_s/ω₃$, flat", "wobble over mark, flat"),
        tuple((said, flatness / cos(x), 2 / cos(x), 2 / (2 - cos(x))) for said, x in tilts),
    )
    turns = 5
    start = body.motion(omega=(wobble * sin(theta), 0.0, omega3))
    path = start.integrate(
        np.linspace(0, turns * 2 * pi / wobble, 200 * turns + 1), rtol=1e-12, atol=1e-14
    )
    axis = path.angular_momentum[0]
    yield Measure(
        "$e₃$ about $𝐋$ after five wobbles, integrated (rad)",
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
        "angle of $e₃$ and $𝐋$, in closed form (rad)", abs(start.turning_points[1] - theta), 1e-12
    )


EXERCISES: tuple[Exercise, ...] = (cone_plane, space_rate, earth_euler_period, wobbling_plate)
