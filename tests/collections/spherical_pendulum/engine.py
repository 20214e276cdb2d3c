"""What the pages start from: where the bob is, and Newton's or Lagrange's equations."""

from __future__ import annotations

from functools import cache

from sympy import Expr, Matrix, Rational, cos, sin, solve, sqrt

from rigidtop.theory.lagrangian import accelerations
from rigidtop.theory.rotation import total_derivative
from rigidtop.theory.trig import reduce_trig

from .letters import g, length, m, omega, phi, phiddot, phidot, theta, thetaddot, thetadot

ANGLES, VELOCITIES = (theta, phi), (thetadot, phidot)
RATES = {theta: thetadot, phi: phidot, thetadot: thetaddot, phidot: phiddot}
POSITION = length * Matrix([sin(theta) * cos(phi), sin(theta) * sin(phi), -cos(theta)])
VELOCITY = total_derivative(POSITION, RATES)
WEIGHT = Matrix([0, 0, -m * g])

ON_A_CONE = {thetaddot: 0, thetadot: 0, phidot: omega}


@cache
def speed() -> Expr:
    """|v| (m/s)."""
    return sqrt(reduce_trig(VELOCITY.dot(VELOCITY), keep="sin"))


@cache
def lagrangian() -> Expr:
    """½mv² + m g·r from the position of the bob (J)."""
    kinetic = Rational(1, 2) * m * VELOCITY.dot(VELOCITY)
    return reduce_trig(kinetic + WEIGHT.dot(POSITION), keep="sin")


@cache
def along_the_string() -> Expr:
    """The force with which the string pulls, by Newton's law along it (N)."""
    force = m * total_derivative(VELOCITY, RATES) - WEIGHT
    return reduce_trig(-force.dot(POSITION) / length, keep="sin")


@cache
def across_the_string() -> Expr:
    """θ̈ by Newton's law across the string, where the string does not pull (rad/s²)."""
    force = m * total_derivative(VELOCITY, RATES) - WEIGHT
    [found] = solve(reduce_trig(force.dot(POSITION.diff(theta))), thetaddot)
    return found


@cache
def lagrange() -> dict[Expr, Expr]:
    """θ̈ and φ̈ by Lagrange's equations."""
    found = accelerations(lagrangian(), ANGLES, VELOCITIES)
    return dict(zip((thetaddot, phiddot), found, strict=True))


def along_motion(expression: Expr) -> Expr:
    """d/dt along the equations of motion."""
    return total_derivative(expression, RATES).subs(lagrange())
