"""Systems: n pendulums in a row, beside SymPy's LagrangesMethod, and two of them beside PyDy.

Run ``python tests/benchmarks/systems.py``.  A derivation runs in a process of its own, where
nothing is in SymPy's caches; its import is not counted.
"""

from __future__ import annotations

import subprocess
import sys
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import sympy
from numpy.typing import NDArray
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from rigidtop.bench.motions import END, TOLERANCE
from rigidtop.bench.rows import ROUNDS, Row, Task, Way, measured, missing, table
from rigidtop.system.parts import Mass
from rigidtop.system.system import System

SOLVED = 4
"""More pendulums than these SymPy does not solve in a reasonable time."""

m, length, g = sympy.symbols("m length g", positive=True)
PARAMETERS = {m: 1.0, length: 1.0, g: 9.81}


def masses(n: int) -> tuple[list[Any], list[Mass]]:
    """Of pendulums in a row their angles to the vertical, and the masses with their places."""
    angles = [dynamicsymbols(f"theta{k + 1}") for k in range(n)]
    x, y, found = sympy.S.Zero, sympy.S.Zero, []
    for angle in angles:
        x, y = x + length * sympy.sin(angle), y - length * sympy.cos(angle)
        found.append(Mass(m, [x, y]))
    return angles, found


def pendulums(n: int) -> System:
    """n equal masses, each on a rod from the one before, by their angles to the vertical."""
    angles, parts = masses(n)
    return System.of_parts(parts, angles, gravity=[0, -g])


def by_sympy(n: int) -> LagrangesMethod:
    """With its equations formed."""
    angles, parts = masses(n)
    t = dynamicsymbols._t
    T = sum(part.mass * part.place.diff(t).dot(part.place.diff(t)) for part in parts) / 2
    V = sum(part.mass * g * part.place[1] for part in parts)
    method = LagrangesMethod(T - V, angles)
    method.form_lagranges_equations()
    return method


def operations(expressions: Any) -> int:
    """Of SymPy's expressions, their common subexpressions taken out."""
    shared, reduced = sympy.cse(list(expressions))
    return int(sympy.count_ops([*(value for _, value in shared), *reduced]))


def derivation(n: int) -> list[Row]:
    """To q̈ as lines, or, where SymPy does not get there, to M and f of Mq̈ = f."""
    task = f"derive {n} pendulums in a row, to the right-hand side"
    told = "rhs()" if n <= SOLVED else "mass_matrix, *method.forcing"
    imports = f"import sys; sys.path.insert(0, {str(Path(__file__).parent)!r}); import systems"
    counted = f"systems.operations([*method.{told}])"
    made = pendulums(n).program.operations
    seconds, count = fresh(imports, f"method = systems.by_sympy({n}); count = {counted}", "count")
    said = f"{count:.0f} operations" + ("" if n <= SOLVED else ", not solved")
    return [
        Row(
            task,
            "rigidtop.System",
            fresh(imports, f"systems.pendulums({n}).program", "0")[0],
            note=f"{made} operations",
        ),
        Row(task, "sympy LagrangesMethod, cse", seconds, note=said),
    ]


def fresh(imports: str, statement: str, told: str) -> tuple[float, float]:
    """Seconds of a statement in a new process, and a number of it."""
    code = (
        f"from time import perf_counter\n{imports}\nbegin = perf_counter()\n{statement}\n"
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

    method = by_sympy(2)
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
    rows = [row for n in ((2,) if quick else (2, 4, 10)) for row in derivation(n)]
    task = Task("10 s of two pendulums, 1,000 samples", two_pendulums, 1000)
    print(table([*rows, *measured([task], 1 if quick else ROUNDS)]))


if __name__ == "__main__":
    main(quick="--quick" in sys.argv)
