"""What rolls on a slope and on a turntable, integrated with its constraints."""

from __future__ import annotations

from functools import cache

from sympy import Expr, Rational, sin, symbols

from rigidtop.system.motion import SystemMotion
from rigidtop.system.system import System

HALF = Rational(1, 2)
SHAPES = {"hoop": 1.0, "disc": 0.5, "ball": 0.4}
"""I/mR² of what rolls."""


@cache
def wheel() -> System:
    """The wheel of (1.1) and (1.2), with its rolling constraint."""
    m, R, inertia, g, alpha = symbols("m R I g alpha", positive=True)
    s, chi, v, w = symbols("s chi sdot chidot", real=True)
    lagrangian = HALF * m * v**2 + HALF * inertia * w**2 + m * g * s * sin(alpha)
    return System(lagrangian, [s, chi], [v, w], constraints=[v - R * w])


@cache
def ball() -> System:
    """A ball on a turntable.

    Of a ball all axes are alike: the components of its rotational velocity in space may stand for
    the rates of coordinates.
    """
    m, R, inertia, turn = symbols("m R I Omega", positive=True)
    x, y, a, b = symbols("x y a b", real=True)
    u, v, p, q = symbols("xdot ydot p q", real=True)
    lagrangian = HALF * m * (u**2 + v**2) + HALF * inertia * (p**2 + q**2)
    touching = [u - R * q + turn * y, v + R * p - turn * x]
    return System(lagrangian, [x, y, a, b], [u, v, p, q], constraints=touching)


def down(ratio: float, slope: float, m: float, R: float, g: float) -> SystemMotion:
    """A wheel of I = `ratio` mR² that is let go on a slope (rad)."""
    values = {"m": m, "R": R, "I": ratio * m * R**2, "g": g, "alpha": slope}
    return wheel().motion(_given(wheel(), values), q=[0.0, 0.0], qdot=[0.0, 0.0])


def set_down(
    place: tuple[float, float], velocity: tuple[float, float], turn: float, R: float = 0.05
) -> SystemMotion:
    """A ball that rolls from a place (m) at a velocity (m/s) on a table that turns (rad/s)."""
    (x, y), (u, v) = place, velocity
    values = {"m": 1.0, "R": R, "I": SHAPES["ball"] * R**2, "Omega": turn}
    spin = (turn * x - v) / R, (u + turn * y) / R
    return ball().motion(_given(ball(), values), q=[x, y, 0.0, 0.0], qdot=[u, v, *spin])


def _given(system: System, values: dict[str, float]) -> dict[Expr, float]:
    return {x: values[x.name] for x in system.parameters}
