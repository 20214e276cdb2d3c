"""Section 1: the equations of motion, and what stays constant."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Ne, Rational, cos, sin

from rigidtop.proof.equation import Equation, Group, as_printed
from rigidtop.proof.page import Assumption, Check, Evidence, Page, claim
from rigidtop.theory.lagrangian import energy as jacobi
from rigidtop.theory.lagrangian import momenta
from rigidtop.theory.symbols import const

from . import evidence
from .engine import POSITION, VELOCITIES, VELOCITY, across_the_string, along_motion, lagrange
from .engine import lagrangian as engine_lagrangian
from .letters import (
    E,
    L_z,
    Lagrangian,
    g,
    length,
    m,
    p_phi,
    phiddot,
    phidot,
    theta,
    thetaddot,
    thetadot,
)

HALF = Rational(1, 2)
INCLINED = Assumption(Ne(sin(theta), 0), "the string is not vertical")


@claim("1.1", "Lagrangian of the spherical pendulum.")
def lagrangian() -> Iterator[Evidence]:
    r"""$\tfrac12mv^2 + m\mathbf g\cdot\mathbf r$ for a bob at the distance l from the support."""
    with as_printed():
        printed = Equation(
            Lagrangian,
            HALF * m * length**2 * Group(thetadot**2 + phidot**2 * sin(theta) ** 2)
            + m * g * length * cos(theta),
            tag="1.1",
        )
    yield Check(printed, {Lagrangian: engine_lagrangian()})


@claim("1.2", r"Equation of motion for $\theta$.")
def theta_equation() -> Iterator[Evidence]:
    r"""Lagrange's equation for $\theta$, divided by ml."""
    with as_printed():
        printed = Equation(
            length * thetaddot,
            length * phidot**2 * sin(theta) * cos(theta) - g * sin(theta),
            tag="1.2",
        )
    yield Check(printed, {thetaddot: lagrange()[thetaddot]})
    yield Check(
        printed,
        {thetaddot: across_the_string()},
        reason="Newton's law across the string gives the same, without a Lagrangian.",
        printed=False,
    )


@claim("1.3", r"Equation of motion for $\phi$.")
def phi_equation() -> Iterator[Evidence]:
    r"""Lagrange's equation for $\phi$, with $ml^2 \sin^2\theta$ divided out."""
    with as_printed():
        printed = Equation(phiddot, -2 * thetadot * phidot * cos(theta) / sin(theta), tag="1.3")
    yield Check(printed, {phiddot: lagrange()[phiddot]}, (INCLINED,))


@claim("1.4", r"$p_\phi$ is constant.")
def momentum() -> Iterator[Evidence]:
    r"""$\phi$ does not enter the Lagrangian."""
    with as_printed():
        printed = Equation(p_phi, m * length**2 * phidot * sin(theta) ** 2, const, tag="1.4")
    yield Check(printed, {p_phi: momenta(engine_lagrangian(), VELOCITIES)[1], const: along_motion})


@claim("p-phi-is-Lz", r"$p_\phi$ is the angular momentum about the vertical.")
def p_phi_is_l_z() -> Iterator[Evidence]:
    r"""$\partial T/\partial\dot\phi$ is $\hat{\mathbf z}\cdot(\mathbf r \times m\mathbf v)$,
    since $\phi$ turns the bob about $\hat{\mathbf z}$."""
    with as_printed():
        same = Equation(p_phi, L_z)
    momentum = momenta(engine_lagrangian(), VELOCITIES)[1]
    yield Check(same, {p_phi: momentum, L_z: m * POSITION.cross(VELOCITY)[2]})


@claim("1.5", "The energy is constant.")
def energy() -> Iterator[Evidence]:
    """The Lagrangian does not contain the time: Jacobi's integral is $T + V$."""
    with as_printed():
        printed = Equation(
            E,
            HALF * m * length**2 * Group(thetadot**2 + phidot**2 * sin(theta) ** 2)
            - m * g * length * cos(theta),
            const,
            tag="1.5",
        )
    yield Check(printed, {E: jacobi(engine_lagrangian(), VELOCITIES), const: along_motion})
    yield from evidence.conserved()


page = Page(
    "1",
    "Equations of motion",
    "A mass on a string of constant length, by two angles.",
    (lagrangian, theta_equation, phi_equation, momentum, p_phi_is_l_z, energy),
)
