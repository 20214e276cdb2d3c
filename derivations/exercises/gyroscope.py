"""Section 3.5.2: the gyroscope and the bicycle wheel."""

from __future__ import annotations

from collections.abc import Iterator
from math import asin, atan, copysign, cos, hypot, pi, sin, sqrt

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from rigidtop.derivations.simplified_picture import precession_vector, torque_direction
from rigidtop.errors import RigidtopError
from rigidtop.motion.top import ROUNDING, HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure

from .bodies import GRAVITY, least_spin, simple_rate, smallness

spin_for_accuracy = Claim(
    "spin-for-accuracy",
    r"(3.52) is off by the share $\tau$ where $\varepsilon = \tau/(1 + \tau)^2$.",
)


disc_on_an_arm = Claim(
    "disc-on-an-arm",
    r"A disc on an axle without mass, held at $R$: the mass drops out of $\Omega$.",
)


wheel_on_an_axle = Claim(
    "wheel-on-an-axle", r"A hoop whose horizontal axle is held at one end: $\Omega$ is exact."
)


Grains = tuple[NDArray[np.float64], NDArray[np.float64]]
"""Masses (n,) and places (n, 3) along e₁, e₂, e₃ from the pivot."""


def hoop(mass: float, radius: float, arm: float) -> Grains:
    """Six equal grains on a circle about e₃: they have the mass, centre and moments of a hoop."""
    turns = 2 * pi * np.arange(6) / 6
    places = np.stack(
        [radius * np.cos(turns), radius * np.sin(turns), np.full_like(turns, arm)], axis=1
    )
    return np.full(6, mass / 6), places


def disc(mass: float, radius: float, arm: float) -> Grains:
    """Half of the mass on the rim and half at the centre: those of a uniform disc."""
    masses, places = hoop(mass / 2, radius, arm)
    return np.append(masses, mass / 2), np.vstack([places, [0.0, 0.0, arm]])


def steadily_moved(grains: Grains, theta: float, rate: float, omega3: float) -> Grains:
    """Places and accelerations in space of grains in steady precession, by Rz(φ)Ry(θ)Rz(ψ).

    φ̇ = `rate` and ψ̇ = ω₃ − φ̇ cos θ are constant, so that each d/dt of the product is a factor
    φ̇ ẑ× in front or ψ̇ ẑ× behind.
    """
    about = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    tilt = np.array(
        [[cos(theta), 0.0, sin(theta)], [0.0, 1.0, 0.0], [-sin(theta), 0.0, cos(theta)]]
    )
    spin = omega3 - rate * cos(theta)
    second = (
        rate**2 * about @ about @ tilt
        + 2 * rate * spin * about @ tilt @ about
        + spin**2 * tilt @ about @ about
    )
    return grains[1] @ tilt.T, grains[1] @ second.T


def unbalanced(grains: Grains, theta: float, rate: float, omega3: float, g: float) -> float:
    """|Σ r × m(a − g)| over Σ|r × ma| + Σ|r × mg|: by Newton's law for each grain it vanishes."""
    places, accelerations = steadily_moved(grains, theta, rate, omega3)
    needed = np.cross(places, grains[0][:, None] * accelerations)
    given = np.cross(places, grains[0][:, None] * np.array([0.0, 0.0, -g]))
    size = np.linalg.norm(needed, axis=1).sum() + np.linalg.norm(given, axis=1).sum()
    return float(np.linalg.norm((needed - given).sum(axis=0)) / size)


def seen_from_above(rate: float) -> str:
    """Which way a precession goes."""
    return "anticlockwise" if rate > 0 else "clockwise"


def spinning(omega3: float) -> None:
    """RigidtopError for a wheel at rest."""
    if omega3 == 0:
        raise RigidtopError("omega3 must not be 0: a wheel that does not spin falls")


def disc_on_axle(M: float, radius: float, R: float, g: float) -> HeavyTop:
    """A uniform disc on an axle without mass that is held at R from it."""
    return HeavyTop(lambda1=M * (radius**2 / 4 + R**2), lambda3=M * radius**2 / 2, M=M, R=R, g=g)


def hoop_on_axle(M: float, radius: float, R: float, g: float) -> HeavyTop:
    """A wheel that is all rim, on an axle without mass that is held at R from it."""
    return HeavyTop(lambda1=M * (radius**2 / 2 + R**2), lambda3=M * radius**2, M=M, R=R, g=g)


def spin_for(tolerance: float, top: HeavyTop, theta: float) -> float:
    """The |ω₃| (rad/s) from which on (3.52) is off by no more than the share `tolerance`."""
    cosine = cos(theta) if abs(cos(theta)) > ROUNDING else 0.0
    # Below the horizontal the exact rate is the smaller one.
    share = tolerance if cosine > 0 else -tolerance
    needed = sqrt(top.lambda1 * top.weight[2] * abs(cosine) / tolerance) * (1 + share)
    return needed / top.lambda3


def slope_of_cord(rate: float, R: float, cord: float, g: float) -> float:
    """tan β of a cord that keeps a centre of mass at R from its end on its circle.

    The circle has the radius R + ℓ sin β, and is run through at `rate` (rad/s).
    """

    def unmet(slope: float) -> float:
        return g * slope - rate**2 * (R + cord * slope / hypot(1.0, slope))

    most = rate**2 * (R + cord) / g
    return float(brentq(unmet, 0.0, most, xtol=1e-15 * most, rtol=1e-15))


FACTORS = (0.25, 0.5, 1.0, 2.0, 4.0, 8.0)


@exercise(
    "gyroscope",
    "The gyroscope of introductory books",
    section="3.5.2",
    asks="example 35: gyroscopes",
    statement="A uniform disc spins on a thin axle through its centre. The end of the axle rests "
    "on a stand, at the distance $R$ from the disc, and the axle makes the angle "
    r"$\theta$ with the vertical. In which direction does it precess, how fast, and how "
    "long does one turn take?\n\nCompare (3.52) with the exact rate. How fast must the "
    "disc spin so that (3.52) is wrong by no more than the error allowed, and how fast "
    "so that it can precess steadily at all?",
    claims=(precession_vector, torque_direction, disc_on_an_arm, spin_for_accuracy),
    parameters=(
        Parameter("M", 0.17, "mass of the disc", "kg", above=0),
        Parameter("radius", 0.055, "radius of the disc", "m", above=0),
        Parameter("R", 0.105, "from the stand to the disc", "m", above=0),
        Parameter("omega3", 90 * pi, r"$\omega_3$", "rad/s"),
        Parameter("theta", pi / 3, r"$\theta$ of the axle", "rad", above=0, most=3.1),
        Parameter("tolerance", 0.01, "error allowed, relative to (3.52)", above=0, most=0.9),
        GRAVITY,
    ),
    figure="gyroscope",
    text="exercises/gyroscope",
)
def gyroscope(
    M: float, radius: float, R: float, omega3: float, theta: float, tolerance: float, g: float
) -> Iterator[Outcome]:
    """The exact rate is the slow root of (3.57). Newton's law for each grain of a disc that moves
    so, without moments of inertia or Euler's equations, asks for the torque of its weight and no
    other."""
    spinning(omega3)
    top = disc_on_axle(M, radius, R, g)
    exact, _ = top.steady_precession(theta, omega3)
    simple = simple_rate(top, omega3)
    off = exact / simple - 1
    needed = spin_for(tolerance, top, theta)

    yield Answer("lambda1", r"$\lambda_1$ about the stand", top.lambda1, "kg m²")
    yield Answer("lambda3", r"$\lambda_3$", top.lambda3, "kg m²")
    yield Answer("simple", r"$\Omega$ by (3.52)", simple, "rad/s")
    yield Answer("exact", r"$\Omega_-$ of (3.57)", exact, "rad/s")
    yield Answer("off", "by how much it exceeds (3.52), relative", off)
    yield Answer("period", "time for one turn", 2 * pi / abs(exact), "s")
    yield Answer("direction", "direction, seen from above", seen_from_above(exact))
    yield Answer(
        "epsilon_0", r"$\varepsilon_0 = \lambda_1MgR/(\lambda_3\omega_3)^2$", smallness(top, omega3)
    )
    yield Answer("good", "is (3.52) good enough?", "yes" if abs(off) <= tolerance else "no")
    least = least_spin(top, theta)
    yield Answer("spin_needed", r"it is for $|\omega_3|$ from", needed or least, "rad/s")
    yield Answer("smallest_spin", r"smallest $|\omega_3|$ to go round", least, "rad/s")

    def at(spin: float) -> tuple[float | str, ...]:
        rough = simple_rate(top, spin)
        if abs(spin) < top.smallest_spin(theta):
            return spin, smallness(top, spin), rough, "none", "none"
        rate, _ = top.steady_precession(theta, spin)
        return spin, smallness(top, spin), rough, rate, rate / rough - 1

    yield Table(
        "spins",
        "At less and at more spin",
        (
            r"$\omega_3$ (rad/s)",
            r"$\varepsilon_0$",
            r"$\Omega$ by (3.52) (rad/s)",
            r"$\Omega_-$ (rad/s)",
            "excess",
        ),
        tuple(at(factor * omega3) for factor in FACTORS),
    )
    yield Measure(
        "torque that the moving disc needs besides its weight's, relative",
        unbalanced(disc(M, radius, R), theta, exact, omega3, g),
        1e-12,
    )
    if needed:
        rate, _ = top.steady_precession(theta, needed)
        excess = rate / simple_rate(top, needed) - 1
        share = copysign(tolerance, cos(theta))
        yield Measure("excess at the spin for the tolerance", abs(excess - share), 1e-12)


@exercise(
    "bicycle-wheel",
    "The bicycle wheel on a cord",
    section="3.5.2",
    asks="example 35: the videos",
    statement="A bicycle wheel, all of its mass in the rim, spins on a horizontal axle. One end of "
    "the axle, at the distance $R$ from the wheel, is held up by a cord. Which way does the "
    "wheel go round, and how fast? What is the force in the cord, and by what angle does the "
    "cord lean?\n\nSomebody holds the other end of the axle at rest and lets it go, with the "
    "first end on a fixed pivot. How far does the axle dip, and how often?",
    claims=(precession_vector, torque_direction, wheel_on_an_axle),
    parameters=(
        Parameter("M", 1.5, "mass of the rim", "kg", above=0),
        Parameter("radius", 0.31, "radius of the rim", "m", above=0),
        Parameter("R", 0.15, "from the cord to the wheel", "m", above=0),
        Parameter("omega3", 6 * pi, r"$\omega_3$", "rad/s"),
        Parameter("cord", 1.0, "length of the cord", "m", least=0),
        GRAVITY,
    ),
    figure="bicycle-wheel",
    text="exercises/bicycle_wheel",
)
def bicycle_wheel(
    M: float, radius: float, R: float, omega3: float, cord: float, g: float
) -> Iterator[Outcome]:
    """The cord leans until its pull keeps the wheel on its circle: its angle is the root of an
    equation. Newton's law for six grains of the rim asks for no other torque, and no other
    force."""
    spinning(omega3)
    top = hoop_on_axle(M, radius, R, g)
    rate, _ = top.steady_precession(pi / 2, omega3)
    weak = smallness(top, omega3)
    slope = slope_of_cord(rate, R, cord, g)
    tension, reach = M * g * hypot(1.0, slope), R + cord * slope / hypot(1.0, slope)
    dip = asin(4 * weak / (1 + sqrt(1 + 16 * weak**2)))
    motion = top.motion(theta=pi / 2, omega3=omega3)

    yield Answer("lambda1", r"$\lambda_1$ about the end of the axle", top.lambda1, "kg m²")
    yield Answer("lambda3", r"$\lambda_3$", top.lambda3, "kg m²")
    yield Answer("precession", r"$\Omega$, exact at $\theta = 90^\circ$", rate, "rad/s")
    yield Answer("period", "time for one turn", 2 * pi / abs(rate), "s")
    yield Answer("direction", "direction, seen from above", seen_from_above(rate))
    yield Answer("tension", "force in the cord", tension, "N")
    yield Answer("lean", "angle of the cord with the vertical", atan(slope), "rad")
    yield Answer("epsilon_0", r"$\varepsilon_0 = \lambda_1MgR/(\lambda_3\omega_3)^2$", weak)
    yield Answer("dip", "dip of the axle, let go at rest", dip, "rad")
    yield Answer("dip_period", "time from dip to dip", motion.nutation_period, "s")

    grains = hoop(M, radius, R)
    yield Measure(
        "torque that the moving wheel needs besides its weight's, relative",
        unbalanced(grains, pi / 2, rate, omega3, g),
        1e-12,
    )
    masses, places = hoop(M, radius, reach)
    _, accelerations = steadily_moved((masses, places), pi / 2, rate, omega3)
    pull = tension * np.array([-sin(atan(slope)), 0.0, cos(atan(slope))])
    weight = np.array([0.0, 0.0, -M * g])
    size = masses @ np.linalg.norm(accelerations, axis=1) + tension + M * g
    yield Measure(
        "force on the moving wheel against cord and weight, relative",
        float(np.linalg.norm(masses @ accelerations - pull - weight) / size),
        1e-12,
    )
    lowest = motion.turning_points[1] - pi / 2
    yield Measure("dip against the exact motion's (rad)", abs(dip - lowest), 1e-12)


EXERCISES: tuple[Exercise, ...] = (gyroscope, bicycle_wheel)
