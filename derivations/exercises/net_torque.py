"""Section 3.5.1: torque and potential energy of gravity on points and on a solid."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from math import cos, pi, sin

import numpy as np
import sympy
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from rigidtop.derivations.net_torque import gravity, potential, torque
from rigidtop.motion.attitude import from_euler_angles
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, exercise
from rigidtop.proof.page import Claim, Measure
from rigidtop.theory.inertia import cone

from .bodies import GRAVITY, least_spin

Vectors = NDArray[np.float64]

POINTS = 3
PLACES: tuple[tuple[float, float, float, float], ...] = (
    (1.0, 0.3, 0.0, 0.5),
    (2.0, -0.1, 0.4, 0.7),
    (0.5, 0.6, -0.2, 1.1),
)
"""Mass (kg) and x, y, z (m) of each point; no two sums of them are alike."""


def point_parameters() -> Iterator[Parameter]:
    """m1, x1, y1, z1, and so on."""
    for k, (mass, *place) in enumerate(PLACES, start=1):
        yield Parameter(f"m{k}", mass, f"mass of point\u00a0{k}", "kg", above=0)
        for axis, x in zip("xyz", place, strict=True):
            yield Parameter(f"{axis}{k}", x, f"${axis}$ of point\u00a0{k}", "m")


@exercise(
    "gravity-on-points",
    "Gravity on a body of points",
    section="3.5.1",
    asks="(3.48) and (3.49)",
    statement="Three masses are held together by light rods, and the body is held at the origin. "
    "Add up the torque of gravity and the potential energy, mass by mass. Then put all "
    "the mass at the centre of mass, and compare.\n\nA third way: give the body a "
    r"quarter turn to either side about $\hat{\mathbf x}$, about $\hat{\mathbf y}$ and "
    r"about $\hat{\mathbf z}$. What do the potential energies say about the torque?",
    claims=(torque, gravity, potential),
    parameters=(*point_parameters(), GRAVITY),
    figure="weights",
)
def gravity_on_points(g: float, **given: float) -> Iterator[Outcome]:
    r"""Both sums are taken point by point. For the third way $V$ of the turned points is
    computed: a turn by $\alpha$ changes $V$ by terms in $\cos\alpha$ and in $\sin\alpha$, so
    $(V(90^\circ) - V(-90^\circ))/2$ is its slope at $\alpha = 0$, and the torque about that axis
    is minus the slope."""
    masses = np.array([given[f"m{k + 1}"] for k in range(POINTS)])
    places = np.array([[given[f"{axis}{k + 1}"] for axis in "xyz"] for k in range(POINTS)])
    weights = -g * masses[:, None] * np.array([0.0, 0.0, 1.0])
    total, centre = masses.sum(), masses @ places / masses.sum()
    summed = np.cross(places, weights).sum(axis=0)
    energy = float(g * masses @ places[:, 2])

    yield Answer("mass", "$M$", float(total), "kg")
    for letter, x in zip("xyz", centre, strict=True):
        yield Answer(f"centre_{letter}", f"centre of mass along ${letter}$", float(x), "m")
    for letter, n in zip("xyz", summed, strict=True):
        yield Answer(f"torque_{letter}", f"torque along ${letter}$", float(n), "N m")
    yield Answer("potential", "potential energy", energy, "J")

    size = float(np.linalg.norm(places, axis=1) @ np.linalg.norm(weights, axis=1)) or 1.0
    lumped = np.cross(centre, [0.0, 0.0, -total * g])
    yield Measure(
        r"torque of all the mass at its centre, over $\sum|r||F|$",
        float(np.abs(lumped - summed).max()) / size,
        1e-14,
    )
    yield Measure(
        "potential energy of all the mass at its centre, over the same",
        abs(float(total * g * centre[2]) - energy) / size,
        1e-14,
    )

    def turned(axis: Vectors, angle: float) -> float:
        return float(g * masses @ Rotation.from_rotvec(angle * axis).apply(places)[:, 2])

    slopes = [(turned(axis, pi / 2) - turned(axis, -pi / 2)) / 2 for axis in np.eye(3)]
    yield Measure(
        "torque as minus the slope of the potential energy, over the same",
        float(np.abs(summed + slopes).max()) / size,
        1e-14,
    )


torque_along_the_nodes = Claim(
    "torque-along-the-nodes",
    r"The torque $MgR \sin\theta$ on a top lies along $\mathbf e_2'$, and drives $\theta$.",
)


cone_on_its_tip = Claim(
    "cone-on-its-tip", "A cone on its tip: its centre, its moments, its torque and energy."
)


def discs(radius: float, height: float, nodes: int = 8) -> tuple[Vectors, Vectors]:
    """Points (n, 3) in a cone on its tip and their shares of ∫ d³r (n,): disc by disc.

    Gauss's nodes along the axis and across it, and as many equal steps around: exact for
    polynomials in x, y, z up to the degree `nodes` − 1.
    """
    x, weight = np.polynomial.legendre.leggauss(nodes)
    x, weight = (x + 1) / 2, weight / 2
    z, share, turn = np.meshgrid(height * x, x, 2 * pi * np.arange(nodes) / nodes, indexing="ij")
    across = share * radius * z / height
    points = np.stack([across * np.cos(turn), across * np.sin(turn), z], axis=-1)
    # d³r = ϱ dϱ dφ dz, with ϱ from 0 to the edge of the disc.
    sizes = (
        (height * weight)[:, None, None]
        * weight[None, :, None]
        * across
        * (radius * z / height)
        * (2 * pi / nodes)
    )
    return points.reshape(-1, 3), sizes.ravel()


@exercise(
    "gravity-on-a-solid",
    "Gravity on a cone that stands on its tip",
    section="3.5.1",
    asks=r"exercise: the potential energy is $MgR \cos\theta$",
    statement="A solid cone of uniform density stands on its tip, which is held so high that no "
    r"table is in the way, and leans at $\theta$ towards some azimuth. Every bit of it "
    "has a weight, an arm and a height of its own. Find the torque and the potential "
    "energy as integrals over the cone, and compare with one force $Mg$ at the centre of "
    "mass.\n\nFind its moments about the tip too: then the cone is a top. How fast must "
    r"it spin so that it can stand upright, or go round steadily at $\theta$?",
    claims=(gravity, potential, torque_along_the_nodes, cone_on_its_tip),
    parameters=(
        Parameter("radius", 0.03, "radius of the base", "m", above=0),
        Parameter("height", 0.06, "height", "m", above=0),
        Parameter("density", 700.0, "density, that of beech", "kg/m³", above=0),
        Parameter("theta", pi / 9, r"$\theta$, tilt of the axis", "rad", least=0, most=pi),
        Parameter("phi", 0.7, "azimuth of the axis", "rad"),
        GRAVITY,
    ),
    figure="leaning-cone",
    text="exercises/gravity_on_a_solid",
)
def gravity_on_a_solid(
    radius: float, height: float, density: float, theta: float, phi: float, g: float
) -> Iterator[Outcome]:
    r"""Mass, centre and moments follow from these formulas, the smallest spins from the
    discriminant of (3.57), at $\theta$ and upright. A sum over the tilted cone, disc by disc,
    has the same torque and energy."""
    shape = dict(zip(_SHAPE, (radius, height, density), strict=True))
    volume, centre, across, along = (float(x.subs(shape)) for x in _of_a_cone())
    mass = density * volume
    top = HeavyTop(lambda1=mass * across, lambda3=mass * along, M=mass, R=centre, g=g)
    turning = top.weight[2] * sin(theta)
    direction = np.array([-sin(phi), cos(phi), 0.0])
    energy = top.weight[2] * cos(theta)

    yield Answer("mass", "$M$", mass, "kg")
    yield Answer("R", "$R$, from the tip to the centre of mass", centre, "m")
    yield Answer("lambda1", r"$\lambda_1$ about the tip", top.lambda1, "kg m²")
    yield Answer("lambda3", r"$\lambda_3$", top.lambda3, "kg m²")
    yield Answer("torque", r"torque $MgR \sin\theta$", turning, "N m")
    yield Answer("torque_x", r"torque along $\hat{\mathbf x}$", turning * direction[0], "N m")
    yield Answer("torque_y", r"torque along $\hat{\mathbf y}$", turning * direction[1], "N m")
    yield Answer("potential", r"potential energy $MgR \cos\theta$", energy, "J")
    yield Answer(
        "sleeping_spin", r"smallest $\omega_3$ to stand upright", top.sleeping_spin(), "rad/s"
    )
    yield Answer(
        "smallest_spin",
        r"smallest $\omega_3$ to go round steadily at $\theta$",
        least_spin(top, theta),
        "rad/s",
    )

    points, sizes = discs(radius, height)
    bits = density * sizes
    standing = from_euler_angles(theta, phi, 0.0).apply(points)
    summed = np.cross(standing, -g * bits[:, None] * np.array([0.0, 0.0, 1.0])).sum(axis=0)
    scale = top.weight[2]
    errors = {
        "mass, disc by disc, relative": bits.sum() / mass - 1,
        "torque, disc by disc, over $MgR$": (summed - turning * direction) / scale,
        "potential energy, disc by disc, over $MgR$": (g * bits @ standing[:, 2] - energy) / scale,
        r"$\lambda_1$ about the tip, disc by disc, relative": bits
        @ (points[:, 1] ** 2 + points[:, 2] ** 2)
        / top.lambda1
        - 1,
        r"$\lambda_3$, disc by disc, "
        "relative": bits @ (points[:, 0] ** 2 + points[:, 1] ** 2) / top.lambda3 - 1,
    }
    for what, error in errors.items():
        yield Measure(what, float(np.max(np.abs(error))), 1e-12)


_SHAPE = sympy.symbols("radius height density", positive=True)


@cache
def _of_a_cone() -> tuple[sympy.Expr, ...]:
    """Volume (m³), R (m), and λ₁ and λ₃ of one kilogram (m²) of a cone on its tip."""
    solid = cone(*_SHAPE[:2])
    tensor = solid.inertia(sympy.Integer(1))
    return solid.volume(), solid.centre()[2], tensor[0, 0], tensor[2, 2]


EXERCISES: tuple[Exercise, ...] = (gravity_on_points, gravity_on_a_solid)
