"""Section 2: cones, and small nodding about them."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Eq, Expr, Lt, Ne, cos, sin

from rigidtop.proof.equation import Equation, Group, as_printed
from rigidtop.proof.page import (
    Assumption,
    Check,
    Correction,
    Evidence,
    Page,
    Remark,
    Step,
    claim,
)
from rigidtop.theory.lagrangian import effective_potential, euler_lagrange
from rigidtop.theory.trig import reduce_ratio

from . import evidence
from .engine import ANGLES, ON_A_CONE, VELOCITIES, lagrangian
from .equations import INCLINED
from .letters import (
    Omega2,
    U,
    g,
    length,
    m,
    omega,
    p_phi,
    phiddot,
    phidot,
    theta,
    thetaddot,
    thetadot,
)

WEIGHT = {g: length * omega**2 * cos(theta)}
"""The gravity at which the bob goes round at ω at the angle θ."""

MOVES = Assumption(Ne(omega, 0), "the bob goes round", stated=True)


def potential() -> Expr:
    """Minus the Routhian at θ̇ = 0 (J)."""
    return effective_potential(lagrangian(), (phidot,), (p_phi,), (thetadot,))


def nodding() -> Expr:
    """U″/(ml²) on the cone (1/s²)."""
    steady = {p_phi: m * length**2 * sin(theta) ** 2 * omega, **WEIGHT}
    return reduce_ratio(potential().diff(theta, 2).subs(steady) / (m * length**2))


@claim("2.1", r"$\theta$ moves in an effective potential.")
def effective() -> Iterator[Evidence]:
    r"""$\dot\phi$ is eliminated by the constant $p_\phi$."""
    with as_printed():
        printed = Equation(
            U,
            p_phi**2 / (2 * m * length**2 * sin(theta) ** 2) - m * g * length * cos(theta),
            tag="2.1",
        )
    inclined = Assumption(INCLINED.condition, "the string is not vertical", stated=True)
    yield Check(printed, {U: potential()}, (inclined,))


@claim("2.2", "The rate of the conical pendulum.")
def cone() -> Iterator[Evidence]:
    r"""$\dot\theta = \ddot\theta = 0$ in the equation for $\theta$, divided by $\sin\theta$. A
    bob that hangs at rest has no rate."""
    accelerations = (thetaddot, phiddot)
    balance = euler_lagrange(lagrangian(), ANGLES, VELOCITIES, accelerations)[0].subs(ON_A_CONE)
    with as_printed():
        printed = Equation(length * omega**2 * cos(theta), g, tag="2.2")
    yield Check(printed, {}, (INCLINED,), given=(balance,))
    yield from evidence.cone()


@claim("least-rate", r"No cone is gone round at less than $\sqrt{g/l}$.")
def least_rate() -> Iterator[Evidence]:
    r"""$\omega^2 =$ g/(l $\cos\theta$), and $\cos\theta$ is less than 1 on a cone."""
    with as_printed():
        printed = Equation(omega**2, g / length, relation=">")
    narrow = Assumption(Lt(cos(theta), 1), "it is a cone", stated=True)
    yield Check(printed, WEIGHT, (MOVES, narrow))


@claim("2.3", "How often a bob nods that is pushed a little on its cone.")
def frequency() -> Iterator[Evidence]:
    r"""$U''/(ml^2)$ at the angle of the cone."""
    with as_printed():
        printed = Equation(Omega2, omega**2 * Group(1 + 3 * cos(theta) ** 2), tag="2.3")
        always = Equation(Omega2, 0, relation=">")
    yield Step(Equation(U, potential()), r"Minus the Routhian at $\dot\theta = 0$.")
    yield Check(printed, {Omega2: nodding()})
    yield Check(always, {Omega2: nodding()}, (MOVES,), "Every cone is stable.", printed=False)
    yield from evidence.nodding()


@claim(
    "nods-twice", r"On every cone the bob nods twice while it goes round once: $\Omega = 2\omega$."
)
def nods_twice() -> Iterator[Evidence]:
    """A path like an ellipse about its centre is that of small angles only."""
    meaning = {Omega2: nodding()}
    with as_printed():
        twice = Equation(Omega2, 4 * omega**2)
        right = Equation(Omega2, omega**2 * Group(1 + 3 * cos(theta) ** 2))
    small = Assumption(Eq(theta, 0), "a narrow cone", stated=True, otherwise=theta)
    yield Check(twice, meaning)
    yield Correction(right, meaning)
    yield Remark(twice, meaning, (small,), "In the limit of narrow cones it is true.")


page = Page(
    "2",
    "Cones",
    r"Motions in which $\theta$ is constant, and those close to them.",
    (effective, cone, least_rate, frequency, nods_twice),
)
