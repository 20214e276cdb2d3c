"""Derivations of systems beside SymPy's LagrangesMethod, and a motion of one beside PyDy.

Run ``python tests/benchmarks/systems.py``.  A derivation runs in a process of its own, where
nothing is in SymPy's caches; its import is not counted.
"""

from __future__ import annotations

import runpy
import subprocess
import sys
import warnings
from collections.abc import Callable
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import sympy
from motions import END, TOLERANCE
from numpy.typing import NDArray
from rows import ROUNDS, Row, Task, Way, measured, missing, table
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from rigidtop.system.linkage import Joint, Link
from rigidtop.system.mechanism import Mechanism
from rigidtop.system.parts import Body, Mass
from rigidtop.system.system import System
from rigidtop.theory import top

m, length, g = sympy.symbols("m length g", positive=True)
BICYCLE = Path(__file__).parent.parent / "systems/test_bicycle.py"
TWISTS = [sympy.pi / 2, 0, sympy.pi / 2, -sympy.pi / 2, sympy.pi / 2, 0]
PARAMETERS = {m: 1.0, length: 1.0, g: 9.81}


def pendulums(n: int) -> System:
    """n equal masses, each on a rod from the one before, by their angles to the vertical."""
    angles = [dynamicsymbols(f"theta{k + 1}") for k in range(n)]
    x, y, parts = sympy.S.Zero, sympy.S.Zero, []
    for angle in angles:
        x, y = x + length * sympy.sin(angle), y - length * sympy.cos(angle)
        parts.append(Mass(m, [x, y]))
    return System.of_parts(parts, angles, gravity=[0, -g])


def arm() -> System:
    """Six bodies of which each turns about an axis of the one before, as in a robot's arm.

    By Denavit and Hartenberg: turned about z, moved along z and x, turned about x by a right angle.
    """
    angles = dynamicsymbols("q1:7")
    along = sympy.symbols("d1:7", positive=True)
    across = sympy.symbols("a1:7", positive=True)
    behind = sympy.symbols("r1:7", positive=True)
    place, attitude, parts = sympy.zeros(3, 1), sympy.eye(3), []
    for k, angle in enumerate(angles):
        turned = attitude * sympy.rot_axis3(-angle)
        place = place + turned * sympy.Matrix([across[k], 0, along[k]])
        attitude = turned * sympy.rot_axis1(-TWISTS[k])
        centre = place - behind[k] * attitude[:, 2]
        moments = sympy.symbols(f"A{k} B{k} C{k}", positive=True)
        parts.append(Body(sympy.Symbol(f"m{k}", positive=True), moments, centre, attitude))
    return System.of_parts(parts, angles, gravity=[0, 0, -g])


def arm_by_joints() -> System:
    """The same arm by its joints: each link's axes are those of its joint before the twist."""
    along, across, behind = (sympy.symbols(f"{x}1:7", positive=True) for x in "dar")
    links, joints = [Link("base")], []
    place, attitude = sympy.zeros(3, 1), sympy.eye(3)
    for k, twist in enumerate(TWISTS):
        name, before = f"link {k + 1}", links[-1].name
        joints.append(Joint(f"q{k + 1}", before, name, place=place, attitude=attitude))
        attitude = sympy.rot_axis1(-twist)
        place = sympy.Matrix([across[k], 0, along[k]])
        moments = sympy.diag(*sympy.symbols(f"A{k} B{k} C{k}", positive=True))
        centre = place - behind[k] * attitude[:, 2]
        inertia = attitude * moments * attitude.T
        links.append(Link(name, sympy.Symbol(f"m{k}", positive=True), centre, inertia))
    return Mechanism(links, joints).system(gravity=[0, 0, -g])


def bicycle() -> System:
    """Whipple's: 8 coordinates with 5 constraints, as its test has it."""
    made: System = runpy.run_path(str(BICYCLE))["bicycle"]()
    return made


def in_euler_angles(L: sympy.Expr) -> System:
    """A body about a pivot, by a Lagrangian of the theory."""
    angles = dynamicsymbols("theta phi psi")
    own = zip((*top.ANGLES, *top.RATES), (*angles, *(x.diff() for x in angles)), strict=True)
    return System(L.xreplace(dict(own)), angles)


DERIVED = {
    "2 pendulums in a row": ("pendulums(2)", True),
    "4 pendulums in a row": ("pendulums(4)", True),
    "10 pendulums in a row": ("pendulums(10)", False),
    "the symmetric top": ("in_euler_angles(top.symmetric_lagrangian())", True),
    "a heavy body, three moments, any centre of mass": ("in_euler_angles(top.lagrangian())", False),
}
"""Systems, and whether SymPy solves them for q̈ in a reasonable time."""


LONG = {
    "12 pendulums in a row": "pendulums(12)",
    "20 pendulums in a row": "pendulums(20)",
    "an arm of 6 joints": "arm()",
    "the same arm by its joints": "arm_by_joints()",
    "Whipple's bicycle": "bicycle()",
}
"""Systems of which SymPy has no right-hand side in a reasonable time."""


def by_sympy(system: System) -> LagrangesMethod:
    """With its equations formed."""
    method = LagrangesMethod(system.L, list(system.q))
    method.form_lagranges_equations()
    return method


def operations(expressions: Any) -> int:
    """Of SymPy's expressions, their common subexpressions taken out."""
    shared, reduced = sympy.cse(list(expressions))
    return int(sympy.count_ops([*(value for _, value in shared), *reduced]))


def derivation(name: str) -> list[Row]:
    """From L to q̈ as lines, or, where SymPy does not get there, to M and f of Mq̈ = f."""
    made, is_solved = DERIVED[name]
    task = f"derive {name}, to the right-hand side"
    told = "rhs()" if is_solved else "mass_matrix, *method.forcing"
    folder = str(Path(__file__).parent)
    given = f"import sys; sys.path.insert(0, {folder!r}); from systems import *; system = {made}"
    ours = fresh(given, "program = system.program", "program.operations")
    counted = f"operations([*method.{told}])"
    theirs = fresh(given, f"method = by_sympy(system); count = {counted}", "count")
    said = f"{theirs[1]:.0f} operations" + ("" if is_solved else ", not solved")
    return [
        Row(task, "rigidtop.System", ours[0], note=f"{ours[1]:.0f} operations"),
        Row(task, "sympy LagrangesMethod, cse", theirs[0], note=said),
    ]


def callable_(name: str) -> Row:
    """From places and attitudes to a function of numbers."""
    folder = str(Path(__file__).parent)
    given = f"import sys; sys.path.insert(0, {folder!r}); from systems import *"
    statement = f"made = {LONG[name]}.numeric.solved"
    seconds, count = fresh(given, statement, "made.operations")
    return Row(f"{name}, to a function", "rigidtop.System", seconds, note=f"{count:.0f} operations")


def versions() -> str:
    """What was measured."""
    packages = ("rigidtop", "sympy", "mpmath", "numpy", "scipy")
    told = [f"{package} {version(package)}" for package in packages]
    told += [f"heyoka {version('heyoka')}"] if find_spec("heyoka") else []
    return ", ".join([f"Python {sys.version.split()[0]}", *told])


def fresh(given: str, statement: str, told: str) -> tuple[float, float]:
    """Seconds of a statement in a new process, and a number of it."""
    code = (
        f"from time import perf_counter\n{given}\nbegin = perf_counter()\n{statement}\n"
        f"print(perf_counter() - begin, {told})"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    seconds, number = map(float, done.stdout.split())
    return seconds, number


def two_pendulums() -> list[Way]:
    """From 1 and 0.5 rad at rest; the errors are those of the angles, against Taylor series."""
    t = np.linspace(0.0, END, 1000)
    motion = pendulums(2).motion(PARAMETERS, q=[1.0, 0.5])
    truth = motion.integrate(t, "taylor", 2.3e-16).q

    def error(found: NDArray[np.float64]) -> float:
        return float(np.max(np.abs(found - truth)))

    return [
        Way("rigidtop DOP853", lambda: motion.integrate(t, rtol=TOLERANCE).q, error),
        Way("rigidtop taylor", lambda: motion.integrate(t, method="taylor").q, error),
        by_pydy(t, error),
    ]


def by_pydy(t: NDArray[np.float64], error: Callable[[Any], float]) -> Way:
    try:
        from pydy.codegen.ode_function_generators import generate_ode_function
    except ImportError:
        return missing("PyDy, odeint", "PyDy")
    from scipy.integrate import odeint

    method = by_sympy(pendulums(2))
    speeds = sympy.symbols("w1 w2")
    rates = {x.diff(): w for x, w in zip(method.q, speeds, strict=True)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        right = generate_ode_function(
            method.forcing.xreplace(rates),
            list(method.q),
            list(speeds),
            tuple(PARAMETERS),
            mass_matrix=method.mass_matrix.xreplace(rates),
            coordinate_derivatives=sympy.Matrix(speeds),
        )
    values, start = np.array(list(PARAMETERS.values())), np.array([1.0, 0.5, 0.0, 0.0])

    def go() -> NDArray[np.float64]:
        found = odeint(right, start, t, args=(values,), rtol=TOLERANCE, atol=TOLERANCE)
        return np.asarray(found[:, :2])

    return Way("PyDy, odeint", go, error)


def main(quick: bool) -> None:
    names = [*DERIVED][:1] if quick else [*DERIVED]
    rows = [row for name in names for row in derivation(name)]
    task = Task("10 s of two pendulums, 1,000 samples", two_pendulums, 1000)
    rows += map(callable_, [] if quick else LONG)
    print(table([*rows, *measured([task], 1 if quick else ROUNDS)]))
    print(versions())


if __name__ == "__main__":
    main(quick="--quick" in sys.argv)
