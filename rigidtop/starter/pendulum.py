"""Section 1: a pendulum in a plane, with two claims and an exercise."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos as cosine
from math import hypot, pi, sqrt
from math import sin as sine

from scipy.integrate import solve_ivp
from sympy import Expr, Ne, Rational, cos, sin

from rigidtop.parameters import Parameter
from rigidtop.proof.equation import Equation, as_printed
from rigidtop.proof.exercise import Answer, Outcome, exercise
from rigidtop.proof.page import Assumption, Check, Evidence, Measure, Page, Step, claim
from rigidtop.theory.lagrangian import accelerations, energy
from rigidtop.theory.rotation import total_derivative

from .letters import E, g, length, m, theta, thetaddot, thetadot

RATES = {theta: thetadot, thetadot: thetaddot}
"""Which symbol is whose rate."""


def lagrangian() -> Expr:
    """T − V of the pendulum (J): all that the engine starts from."""
    return Rational(1, 2) * m * length**2 * thetadot**2 + m * g * length * cos(theta)


@claim("1.1", "The equation of motion of the pendulum.")
def equation_of_motion() -> Iterator[Evidence]:
    """Lagrange's equation for θ."""
    # Typed as the notes print it: inside `as_printed` SymPy keeps the order of typing.
    with as_printed():
        printed = Equation(thetaddot, -(g / length) * sin(theta), tag="1.1")
    # What the engine derives for θ̈, held against what is printed: the residual decides.
    yield Check(printed, {thetaddot: accelerations(lagrangian(), [theta], [thetadot])[0]})


@claim("from-energy", "The equation of motion follows from the energy being constant.")
def from_energy() -> Iterator[Evidence]:
    """dE/dt = 0 has the factor θ̇, which is divided out.

    A pendulum that stays at any angle at all has a constant energy too.
    """
    total = energy(lagrangian(), [thetadot])
    yield Step(Equation(E, total), "Jacobi's integral, which is T + V here.")
    with as_printed():
        printed = Equation(thetaddot, -(g / length) * sin(theta))
    # `given` is known to vanish. Without the assumption a counterexample in numbers stands; the
    # verdict is "assuming", since the claim does not say so. An assumption that is not needed is
    # an error.
    yield Check(
        printed,
        given=(total_derivative(total, RATES),),
        assuming=(Assumption(Ne(thetadot, 0), "the pendulum moves"),),
    )


page = Page(
    "1",
    "The pendulum",
    "A mass on a string that swings in a plane.",
    (equation_of_motion, from_energy),
    text="pendulum",  # pendulum.md: how one gets there, line by line
)


@exercise(
    "period",
    "The period of a wide swing",
    section="1",
    asks="exercise 1",
    statement="A pendulum is let go at rest at the angle θ. After what time is it there again, and "
    "how much longer is that than for a small swing?",
    claims=(equation_of_motion,),
    parameters=(
        Parameter("theta", pi / 3, "θ at the start", "rad", above=0, most=3.0),
        Parameter("length", 1.0, "length of the string", "m", above=0),
        Parameter("g", 9.81, "acceleration of gravity", "m/s²", above=0),
    ),
)
def period(theta: float, length: float, g: float) -> Iterator[Outcome]:
    """2π√(l/g) over the arithmetic–geometric mean of 1 and cos(θ/2); the equation of motion is
    integrated besides."""
    small = 2 * pi * sqrt(length / g)
    a, b = 1.0, cosine(theta / 2)
    for _ in range(8):  # each step doubles the digits
        a, b = (a + b) / 2, sqrt(a * b)
    seconds = small / a
    yield Answer("period", "period", seconds, "s")
    yield Answer("longer", "longer than a small swing, as a share", seconds / small - 1)
    # Two independent ways to a number: a difference above the tolerance is a failed check.
    solved = solve_ivp(
        lambda _, y: (y[1], -g / length * sine(y[0])),
        (0, seconds),
        (theta, 0),
        rtol=1e-11,
        atol=1e-12,
    )
    angle, rate = solved.y[:, -1]
    missed = hypot(angle - theta, rate * sqrt(length / g))
    yield Measure("back at the start after a period (rad)", missed, 1e-6)
