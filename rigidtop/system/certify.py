"""The same system by other ways: how far Lagrange, Hamilton, Newton and Euler are apart."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy
from sympy import Expr

from rigidtop.codegen.graph import somewhere
from rigidtop.codegen.lines import straight_line
from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.system.balance import Balance, Balanced
from rigidtop.system.names import numbers

if TYPE_CHECKING:
    from rigidtop.system.numeric import Computed

STATES = 20
"""States that are drawn."""


def certify(system: Computed, parameters: Mapping[Expr, object], seed: int = 0) -> dict[str, float]:
    """The largest differences between independent ways: see `System.certify`."""
    values = [float(x) for x in numbers(system.parameters, parameters).values()]
    n = len(system.q)
    rng = np.random.default_rng(checks.whole("seed", seed, 0))
    rows = rng.uniform(-1.0, 1.0, (2 * n, STATES))
    times = rng.uniform(0.0, 1.0, STATES)
    with np.errstate(all="ignore"):
        solved = system.numeric.solved.array(times, *rows, *values)
        differences = {}
        if not system.constraints:
            differences["Hamilton"] = _apart(solved, _hamilton(system, times, rows, values))
        if system.parts:
            for name, way in (
                ("Newton–Euler", Balance.of_parts),
                ("Lagrange", Balance.of_lagrangian),
            ):
                other = _on_graph(system, way).array(times, *rows, *values)
                differences[name] = _apart(solved, other)
        if not system.constraints:
            differences["balance of energy"] = _balance(system, times, rows, values)
    if not differences:
        raise RigidtopError("there is no other way to a system with constraints and without parts")
    return differences


def _apart(one: Any, other: Any) -> float:
    """The largest difference, relative to the largest value, where both are finite."""
    good = np.all(np.isfinite(one) & np.isfinite(other), axis=0)
    if not good.any():
        raise RigidtopError("no state that was drawn has finite accelerations")
    one, other = one[:, good], other[:, good]
    size = np.max(np.abs(one), axis=0)
    return float(np.max(np.abs(one - other) / np.where(size > 0, size, 1.0)))


def _hamilton(system: Computed, times: Any, rows: Any, values: Any) -> Any:
    """q̈ from Hamilton's equations: q̇(q, p), ṗ(q, p), by the chain rule."""
    names, n = system.names, len(system.q)
    momenta = system.numeric.of(system.conjugate).array(times, *rows, *values)
    arguments = (names.t, *names.q, *names.p, *system.parameters)
    H = system.reduced_hamiltonian
    velocity = [H.diff(p) for p in names.p]
    back = dict(zip(names.v, velocity, strict=True))
    forces = [Q.xreplace(back) for Q in system.generalised_forces]
    pushed = [-H.diff(x) + Q for x, Q in zip(names.q, forces, strict=True)]
    turned = [
        sympy.Add(
            *(
                v.diff(x) * rate + v.diff(p) * push
                for x, p, rate, push in zip(names.q, names.p, velocity, pushed, strict=True)
            ),
            v.diff(names.t),
        )
        for v in velocity
    ]
    function = system.numeric.made(turned, "hamilton", arguments=arguments)
    return function.array(times, *rows[:n], *momenta, *values)


def _on_graph(system: Computed, way: Callable[[Balance], Balanced]) -> Any:
    """q̈ by d'Alembert's principle, or by Lagrange."""
    names = system.names
    balance = somewhere(
        (names.t, *names.q, *names.v, *system.multipliers, *system.given),
        lambda graph: way(Balance(system, graph)),
    )
    program = straight_line(balance.graph, balance.solution, system.free())
    return system.numeric.made(program.results, "other", program.shared)


def _balance(system: Computed, times: Any, rows: Any, values: Any) -> float:
    """dE/dt by the accelerations less the power of the forces, relative to the terms of both."""
    names = system.names
    rates = [system.jacobi.diff(x) for x in (*names.q, *names.v)]
    function = system.numeric.of((*rates, system.jacobi.diff(names.t), system.work_rate))
    *slopes, explicit, power = function.array(times, *rows, *values)
    accelerations = system.numeric.solved.array(times, *rows, *values)
    n = len(names.q)
    terms = [s * r for s, r in zip(slopes, (*rows[n:], *accelerations), strict=True)]
    terms = [*terms, explicit, -power]
    good = np.all(np.isfinite(terms), axis=0)
    total, size = (f(np.array(terms)[:, good], axis=0) for f in (np.sum, _size))
    return float(np.max(np.abs(total) / np.where(size > 0, size, 1.0), initial=0.0))


def _size(terms: Any, axis: int) -> Any:
    return np.sum(np.abs(terms), axis=axis)
