"""What the derived right-hand sides cost, beside SymPy's LagrangesMethod and code by hand.

Run ``python tests/benchmarks/right_hand_sides.py`` from the repository.  For the symmetric top,
and for the heavy body with three moments and any centre of mass, one run prints the times of a call
on floats and of one on arrays, over those of the functions written by hand; and of each the time of
its derivation (in a process of its own, SymPy's import not counted), the operations as derived, and
those of one call (+ those done once for a motion).  LagrangesMethod is lambdified by the same
bridge, without simplification, and gets at most `PATIENCE` seconds.
"""

from __future__ import annotations

import argparse
import json
import math
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import numpy as np

from rigidtop.bench.rows import Task, Way, measured, table
from rigidtop.motion import equations
from rigidtop.parameters import EXAMPLE_TOP

PATIENCE = 120
ELEMENTS = 100_000
ROUNDS = 15

TOP = EXAMPLE_TOP
BODY = {
    "lambda1": 3.0,
    "lambda2": 2.0,
    "lambda3": 1.5,
    "M": 1.0,
    "g": 9.81,
    "R1": 0.2,
    "R2": 0.3,
    "R3": 0.4,
}
ANGLES = {"theta": 0.7, "phi": 0.3, "psi": 0.2, "thetadot": 0.1, "phidot": 1.0, "psidot": 9.0}
ATTITUDE = {"q0": 0.8, "q1": 0.4, "q2": 0.4, "q3": 0.2}
OMEGA = {"omega1": 1.0, "omega2": 2.0, "omega3": 3.0}


# Derivations, each run in a process of its own


def derive(name: str) -> dict[str, Any]:
    """Seconds, operations and, for LagrangesMethod, the source of a right-hand side."""
    if name.startswith("lagrange"):
        return _derive_lagrange(symmetric=name.endswith("top"))
    from sympy import count_ops

    from rigidtop.codegen import shipped

    side = shipped.named(name)
    begin = perf_counter()
    expressions = tuple(side.derive())
    seconds, split = perf_counter() - begin, shipped.split(side)
    return {
        "seconds": seconds,
        "written out": count_ops(expressions),
        "operations": f"{split.operations} + {split.operations_once}",
    }


def _derive_lagrange(symmetric: bool) -> dict[str, Any]:
    import sympy
    from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

    from rigidtop.codegen.numpy import function

    parameters = sympy.symbols(list(TOP if symmetric else BODY))
    value = {p.name: p for p in parameters}
    begin = perf_counter()
    theta, _, psi = coordinates = dynamicsymbols("theta phi psi")
    theta_dot, phi_dot, psi_dot = rates = dynamicsymbols("theta phi psi", 1)
    sin, cos = sympy.sin, sympy.cos
    omega = (
        -phi_dot * sin(theta) * cos(psi) + theta_dot * sin(psi),
        phi_dot * sin(theta) * sin(psi) + theta_dot * cos(psi),
        psi_dot + phi_dot * cos(theta),
    )
    if symmetric:
        across = value["lambda1"] * (phi_dot**2 * sin(theta) ** 2 + theta_dot**2)
        kinetic = (across + value["lambda3"] * omega[2] ** 2) / 2
        height = value["R"] * cos(theta)
    else:
        kinetic = sum(value[f"lambda{k + 1}"] * w**2 for k, w in enumerate(omega)) / 2
        vertical = (-sin(theta) * cos(psi), sin(theta) * sin(psi), cos(theta))
        height = sum(value[f"R{k + 1}"] * z for k, z in enumerate(vertical))
    method = LagrangesMethod(kinetic - value["M"] * value["g"] * height, coordinates)
    method.form_lagranges_equations()
    accelerations = method.rhs()[3:]
    seconds = perf_counter() - begin
    plain = sympy.symbols(list(ANGLES))
    renamed = dict(zip([*rates, *coordinates], [*plain[3:], *plain[:3]], strict=True))
    accelerations = [a.xreplace(renamed) for a in accelerations]
    made = function(accelerations, [*plain, *parameters], "rates")
    return {
        "seconds": seconds,
        "written out": sympy.count_ops(accelerations),
        "operations": made.operations,
        "source": made.source,
    }


def derived(name: str) -> dict[str, Any] | None:
    """`derive` in a fresh process; None if it takes longer than the patience."""
    command = [sys.executable, __file__, "--derive", name]
    try:
        done = subprocess.run(command, capture_output=True, check=True, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return None
    result: dict[str, Any] = json.loads(done.stdout)
    return result


# By hand


def top_by_hand(
    theta: Any, theta_dot: Any, phi_dot: Any, psi_dot: Any, sin: Any = math.sin, cos: Any = math.cos
) -> tuple[Any, ...]:
    lambda1, lambda3, weight = TOP["lambda1"], TOP["lambda3"], TOP["M"] * TOP["g"] * TOP["R"]
    s, c = sin(theta), cos(theta)
    momentum = lambda3 * (psi_dot + phi_dot * c)
    phi_ddot = theta_dot * (momentum - 2 * lambda1 * phi_dot * c) / (lambda1 * s)
    return (
        s * (phi_dot * (lambda1 * phi_dot * c - momentum) + weight) / lambda1,
        phi_ddot,
        theta_dot * phi_dot * s - phi_ddot * c,
    )


def body_by_hand(q0: Any, q1: Any, q2: Any, q3: Any, w1: Any, w2: Any, w3: Any) -> tuple[Any, ...]:
    weight = BODY["M"] * BODY["g"]
    r1, r2, r3 = weight * BODY["R1"], weight * BODY["R2"], weight * BODY["R3"]
    l1, l2, l3 = BODY["lambda1"], BODY["lambda2"], BODY["lambda3"]
    z1, z2, z3 = 2 * (q1 * q3 - q0 * q2), 2 * (q0 * q1 + q2 * q3), 1 - 2 * (q1 * q1 + q2 * q2)
    return (
        -0.5 * (q1 * w1 + q2 * w2 + q3 * w3),
        0.5 * (q0 * w1 + q2 * w3 - q3 * w2),
        0.5 * (q0 * w2 + q3 * w1 - q1 * w3),
        0.5 * (q0 * w3 + q1 * w2 - q2 * w1),
        ((l2 - l3) * w2 * w3 + r3 * z2 - r2 * z3) / l1,
        ((l3 - l1) * w3 * w1 + r1 * z3 - r3 * z1) / l2,
        ((l1 - l2) * w1 * w2 + r2 * z1 - r1 * z2) / l3,
    )


# The tables


@dataclass(frozen=True)
class Candidate:
    """One row: what it is, what its derivation took, how to call it on floats and on arrays."""

    label: str
    note: str
    on_floats: Callable[[], object] | None = None
    on_arrays: Callable[[], object] | None = None


def said(found: dict[str, Any] | None) -> str:
    """What a derivation took, and what came of it."""
    if found is None:
        return f"not derived within {PATIENCE} s"
    took = "derived in {seconds:.3f} s, {written out} operations, {operations} of a call"
    return took.format_map(found)


def spread(values: list[float]) -> list[np.ndarray]:
    """Arrays of 10⁵ states about the given one."""
    around = np.random.default_rng(0).uniform(0.9, 1.1, (len(values), ELEMENTS))
    return list(np.array(values)[:, None] * around)


def shipped_candidate(label: str, name: str, state: list[float], **parameters: float) -> Candidate:
    make, arrays = getattr(equations, name), spread(state)
    over_arrays = {"sin": np.sin, "cos": np.cos} if make.__kwdefaults__ else {}
    floats, elements = make(*parameters.values()), make(*parameters.values(), **over_arrays)
    made = said(derived(name))
    return Candidate(label, made, lambda: floats(state), lambda: elements(arrays))


def lagrange_candidate(name: str, parameters: dict[str, float]) -> Candidate:
    label, found = "LagrangesMethod, Euler angles", derived(name)
    if found is None:
        return Candidate(label, said(None))
    state, constants = list(ANGLES.values()), list(parameters.values())
    floats: dict[str, Any] = {"sin": math.sin, "cos": math.cos}
    elements: dict[str, Any] = {"sin": np.sin, "cos": np.cos}
    exec(found["source"], floats)
    exec(found["source"], elements)
    arrays = spread(state)
    return Candidate(
        label,
        said(found),
        lambda: floats["rates"](*state, *constants),
        lambda: elements["rates"](*arrays, *constants),
    )


def tasks(title: str, candidates: list[Candidate]) -> list[Task]:
    """A call on floats and one on arrays; the first candidate is the one by hand."""
    floats = [Way(c.label, c.on_floats, note=c.note) for c in candidates]
    arrays = [Way(c.label, c.on_arrays) for c in candidates]
    return [
        Task(f"{title}: a call on floats", lambda: floats),
        Task(f"{title}: arrays of 10⁵ states", lambda: arrays, ELEMENTS),
    ]


def main() -> None:
    angles = [ANGLES[name] for name in ("theta", "thetadot", "phidot", "psidot")]
    attitude = [*ATTITUDE.values()]
    whole, across = [*attitude, *OMEGA.values()], [*attitude, OMEGA["omega1"], OMEGA["omega2"]]
    angle_arrays, whole_arrays = spread(angles), spread(whole)
    top = [
        Candidate(
            "by hand, Euler angles",
            "",
            lambda: top_by_hand(*angles),
            lambda: top_by_hand(*angle_arrays, sin=np.sin, cos=np.cos),
        ),
        shipped_candidate("shipped, Euler angles", "top_in_euler_angles", angles, **TOP),
        shipped_candidate(
            "shipped, quaternion", "heavy_top", across, **TOP, omega3=OMEGA["omega3"]
        ),
        lagrange_candidate("lagrange_top", TOP),
    ]
    body = [
        Candidate(
            "by hand, quaternion",
            "",
            lambda: body_by_hand(*whole),
            lambda: body_by_hand(*whole_arrays),
        ),
        shipped_candidate("shipped, quaternion", "heavy_body", whole, **BODY),
        lagrange_candidate("lagrange_body", BODY),
    ]
    heavy = "Heavy body, three moments, any centre of mass"
    print(table(measured([*tasks("Symmetric top", top), *tasks(heavy, body)], ROUNDS)))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--derive", metavar="NAME", help="derive one right-hand side, print JSON")
    arguments = parser.parse_args()
    if arguments.derive:
        print(json.dumps(derive(arguments.derive)))
    else:
        main()
