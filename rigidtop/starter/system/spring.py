"""Section 1: a mass on a spring in a plane, by its Lagrangian."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Ne, Rational

import rigidtop as rt
from rigidtop.proof.equation import Equation, Group, as_printed
from rigidtop.proof.page import Assumption, Check, Evidence, Measure, Page, claim
from rigidtop.theory.symbols import const

from .letters import E, k, m, phi, phiddot, phidot, r, rddot, rdot

HALF = Rational(1, 2)
SYSTEM = rt.System.of_energies(
    T=HALF * m * (rdot**2 + r**2 * phidot**2),
    V=HALF * k * r**2,
    q=[r, phi],
    qdot=[rdot, phidot],
)


@claim("1.1", "Lagrange's equation for r.")
def radial() -> Iterator[Evidence]:
    """The radial force and the centrifugal one."""
    # Typed as it is to be printed, and held against what the system derives.
    with as_printed():
        printed = Equation(m * rddot, m * r * phidot**2 - k * r, tag="1.1")
    yield Check(printed, {rddot: SYSTEM.accelerations[0]})


@claim("1.2", "Lagrange's equation for φ.")
def turning() -> Iterator[Evidence]:
    """The angular momentum mr²φ̇ is constant."""
    with as_printed():
        printed = Equation(m * r * Group(r * phiddot + 2 * rdot * phidot), 0, tag="1.2")
    yield Check(printed, {phiddot: SYSTEM.accelerations[1]})


@claim("accelerations", "Solved for φ̈; the mass is not at the centre.")
def solved() -> Iterator[Evidence]:
    """mr² is divided out."""
    with as_printed():
        printed = Equation(phiddot, -2 * rdot * phidot / r)
    away = Assumption(Ne(r, 0), "the mass is not at the centre", stated=True)
    yield Check(printed, {phiddot: SYSTEM.accelerations[1]}, assuming=(away,))


@claim("energy", "The energy is constant.")
def energy() -> Iterator[Evidence]:
    """The Lagrangian does not contain the time."""
    with as_printed():
        total = HALF * m * rdot**2 + HALF * m * r**2 * phidot**2 + HALF * k * r**2
        printed = Equation(E, total, const)
    yield Check(printed, {E: SYSTEM.energy, const: SYSTEM.rate})
    # And by a motion: what is conserved does not stray.
    run = SYSTEM.motion({m: 1, k: 4}, q=[1, 0], qdot=[0, 1]).integrate([1.0, 10.0])
    yield Measure("energy and angular momentum, relative", max(run.drift().values()), 1e-8)


page = Page(
    "1",
    "A mass on a spring",
    "A mass on a spring that turns in a plane, by its Lagrangian.",
    (radial, turning, solved, energy),
    text="spring",  # spring.md: how one gets there, line by line
)
