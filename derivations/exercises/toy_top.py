"""Section 3.5.4: a top from the toy box."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import atan2, pi

import numpy as np

from rigidtop.derivations.lagrange_formalism import two_roots
from rigidtop.errors import RigidtopError
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, exercise
from rigidtop.proof.page import Claim, Measure

from .bodies import GRAVITY, SPIN, simple_rate
from .nutation import INCLINED, TIGHT, small_frequency
from .sleeping_top import RPM, upright_potential

disc_on_a_stem = Claim(
    "disc-on-a-stem", "Mass, centre of mass and moments of a disc on a thin stem."
)


def quadrature_moments(
    disc_mass: float, radius: float, thickness: float, height: float, stem_mass: float, stem: float
) -> tuple[float, float]:
    """λ₁ and λ₃ about the tip from Gauss points in the disc and on the stem (kg m²)."""
    nodes, weights = np.polynomial.legendre.leggauss(4)
    across, along = (nodes + 1) / 2, nodes / 2
    r = radius * across
    ring = weights * across  # ∫ 2 x dx from 0 to 1, with half the weights
    r2 = float(ring @ r**2)
    z2 = float(weights / 2 @ (height + thickness * along) ** 2)
    stem2 = float(weights / 2 @ (stem * across) ** 2)
    return disc_mass * (r2 / 2 + z2) + stem_mass * stem2, disc_mass * r2


def measured(
    disc_mass: float,
    disc_radius: float,
    disc_thickness: float,
    disc_height: float,
    stem_mass: float,
    stem_length: float,
    g: float,
) -> HeavyTop:
    """The top of these parts; RigidtopError for a disc that is not on its stem."""
    if disc_height <= disc_thickness / 2 or disc_height + disc_thickness / 2 > stem_length:
        raise RigidtopError(
            f"disc_height = {disc_height:g}: the disc must be on the stem, above the tip and "
            f"below the end at stem_length = {stem_length:g}"
        )
    mass = disc_mass + stem_mass
    lambda1 = disc_mass * (disc_radius**2 / 4 + disc_thickness**2 / 12 + disc_height**2)
    lambda1 += stem_mass * stem_length**2 / 3
    return HeavyTop(
        lambda1=lambda1,
        lambda3=disc_mass * disc_radius**2 / 2,
        M=mass,
        R=(disc_mass * disc_height + stem_mass * stem_length / 2) / mass,
        g=g,
    )


def free_of_the_table(
    theta: float, disc_radius: float, disc_thickness: float, disc_height: float
) -> float:
    """The tilt at which the rim touches the table (rad); RigidtopError if θ is not less."""
    touching = atan2(disc_height - disc_thickness / 2, disc_radius)
    if theta >= touching:
        raise RigidtopError(
            f"theta = {theta:g}: the rim of the disc touches the table at {touching:g} rad"
        )
    return touching


def spinning_at(top: HeavyTop, theta: float, omega3: float) -> tuple[float, float, float]:
    """Ω₋, Ω₊ and the rate of a small nutation (rad/s); RigidtopError where there is none."""
    slow, fast = top.steady_precession(theta, omega3)
    if omega3 == 0:
        raise RigidtopError("omega3 = 0: the top has to spin")
    return slow, fast, small_frequency(top, theta, slow, omega3)


def _length(name: str, default: float, about: str) -> Parameter:
    return Parameter(name, default, about, "m", above=0)


@exercise(
    "top-from-the-toy-box",
    "A top from the toy box",
    section="3.5.4",
    asks="“get your own toy-top and play with it”",
    statement="Weigh and measure a top that is a disc on a thin stem; the stem's lower end is the "
    "tip, and it may be held in place by a small hole in the table. From which spin on does it "
    "sleep? How fast does it precess and nutate with the spin and the tilt that you give it, and "
    "how much energy is in the spin?\n\n"
    "Film your top and compare: the spin in turns a minute, the time for one turn of the axis.",
    claims=(disc_on_a_stem, two_roots, upright_potential),
    parameters=(
        Parameter("disc_mass", 0.05, "mass of the disc", "kg", above=0),
        _length("disc_radius", 0.03, "radius of the disc"),
        _length("disc_thickness", 0.008, "thickness of the disc"),
        _length("disc_height", 0.02, "height of the middle of the disc above the tip"),
        Parameter("stem_mass", 0.005, "mass of the stem", "kg", above=0),
        _length("stem_length", 0.05, "length of the stem from the tip"),
        GRAVITY,
        replace(INCLINED, default=pi / 12),
        replace(SPIN, default=150.0),
    ),
    figure="toy-top",
    text="exercises/toy_box",
)
def top_from_the_toy_box(
    disc_mass: float,
    disc_radius: float,
    disc_thickness: float,
    disc_height: float,
    stem_mass: float,
    stem_length: float,
    g: float,
    theta: float,
    omega3: float,
) -> Iterator[Outcome]:
    """The moments are put together from disc and stem; precession and nutation are those of a heavy
    top with them."""
    top = measured(disc_mass, disc_radius, disc_thickness, disc_height, stem_mass, stem_length, g)
    mass, arm, lambda1, lambda3 = top.M, top.R, top.lambda1, top.lambda3
    touching = free_of_the_table(theta, disc_radius, disc_thickness, disc_height)
    slow, fast, frequency = spinning_at(top, theta, omega3)
    energy = lambda3 * omega3**2 / 2
    yield Answer("M", "mass", mass, "kg")
    yield Answer("R", "distance from the tip to the centre of mass", arm, "m")
    yield Answer("lambda1", r"$\lambda_1$ about the tip", lambda1, "kg m²")
    yield Answer("lambda3", r"$\lambda_3$", lambda3, "kg m²")
    yield Answer("touching", "tilt at which the rim touches the table", touching, "rad")
    yield Answer("sleeping_rpm", "spin from which on it sleeps", top.sleeping_spin() * RPM, "rpm")
    yield Answer("least_rpm", r"least spin at $\theta$", top.smallest_spin(theta) * RPM, "rpm")
    yield Answer("spin_rpm", "the given spin", omega3 * RPM, "rpm")
    yield Answer("slow", r"slow precession $\Omega_-$", slow, "rad/s")
    yield Answer("slow_leading", r"by $MgR/(\lambda_3\omega_3)$", simple_rate(top, omega3), "rad/s")
    yield Answer("slow_turn", "time for one turn of the axis", 2 * pi / abs(slow), "s")
    yield Answer("fast", r"fast precession $\Omega_+$", fast, "rad/s")
    yield Answer("nutation", "nutations in a second", frequency / (2 * pi), "1/s")
    yield Answer("energy", "energy of the spin", energy, "J")
    yield Answer("height", "height by which it could lift the top", energy / (mass * g), "m")
    summed = quadrature_moments(
        disc_mass, disc_radius, disc_thickness, disc_height, stem_mass, stem_length
    )
    error = max(abs(a / b - 1) for a, b in zip(summed, (lambda1, lambda3), strict=True))
    yield Measure("moments summed over points, relative", error, 1e-12)
    # A turn, or as many nutations as are enough to tell.
    seconds = min(2 * pi / abs(slow), 100 * pi / frequency)
    turn = top.motion(theta=theta, phi_dot=slow, omega3=omega3).integrate(seconds, **TIGHT)
    error = abs(float(turn.phi[0]) - slow * seconds)
    yield Measure(r"$\phi = \Omega_-t$, integrated (rad)", error, 1e-6)
    kicked = top.motion(theta=theta, theta_dot=1e-6 * frequency, phi_dot=slow, omega3=omega3)
    error = abs(2 * pi / kicked.nutation_period / frequency - 1)
    yield Measure("frequency of a nutation of $10^{-6}$ rad in closed form, relative", error, 1e-8)


EXERCISES: tuple[Exercise, ...] = (top_from_the_toy_box,)
"""In the order of the notes."""
