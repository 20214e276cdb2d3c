"""What the derived right-hand sides cost, beside SymPy's LagrangesMethod and code by hand.

Run ``python tests/benchmarks/right_hand_sides.py`` from the repository.  One run prints, for the
symmetric top and for the heavy body with three moments and any centre of mass: the time of the
derivation (in a process of its own, SymPy's import not counted), the operations as derived and
those of one call (+ those done once for a motion), the time of one call on floats and of one
element of an array of 10⁵, and both as ratios to the functions written by hand.  Times are medians
of interleaved rounds.  LagrangesMethod is lambdified by the same bridge, without simplification,
and gets at most `PATIENCE` seconds.
"""

from __future__ import annotations

import argparse
import json
import math
import statistics
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import numpy as np

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


# The table


@dataclass(frozen=True)
class Candidate:
    """One row: what it is, and how to call it once on floats and once on arrays."""

    label: str
    derivation: dict[str, Any] | None
    scalar: Callable[[], Any] | None
    array: Callable[[], Any] | None


def spread(values: list[float]) -> list[np.ndarray]:
    """Arrays of 10⁵ states about the given one."""
    around = np.random.default_rng(0).uniform(0.9, 1.1, (len(values), ELEMENTS))
    return list(np.array(values)[:, None] * around)


def shipped_candidate(label: str, name: str, state: list[float], **parameters: float) -> Candidate:
    make, arrays = getattr(equations, name), spread(state)
    over_arrays = {"sin": np.sin, "cos": np.cos} if make.__kwdefaults__ else {}
    floats, elements = make(*parameters.values()), make(*parameters.values(), **over_arrays)
    return Candidate(label, derived(name), lambda: floats(state), lambda: elements(arrays))


def lagrange_candidate(name: str, parameters: dict[str, float]) -> Candidate:
    label, found = "LagrangesMethod, Euler angles", derived(name)
    if found is None:
        return Candidate(label, None, None, None)
    state, constants = list(ANGLES.values()), list(parameters.values())
    floats: dict[str, Any] = {"sin": math.sin, "cos": math.cos}
    elements: dict[str, Any] = {"sin": np.sin, "cos": np.cos}
    exec(found["source"], floats)
    exec(found["source"], elements)
    arrays = spread(state)
    return Candidate(
        label,
        found,
        lambda: floats["rates"](*state, *constants),
        lambda: elements["rates"](*arrays, *constants),
    )


def seconds_per_call(call: Callable[[], Any], calls: int) -> float:
    begin = perf_counter()
    for _ in range(calls):
        call()
    return (perf_counter() - begin) / calls


def medians(calls: list[Callable[[], Any] | None], repeat: int) -> list[float | None]:
    """Median seconds of one call each, in rounds that take turns."""
    rounds = [[c and seconds_per_call(c, repeat) for c in calls] for _ in range(ROUNDS)]
    columns = zip(*rounds, strict=True)
    return [None if c[0] is None else statistics.median(c) for c in columns]


def report(title: str, candidates: list[Candidate]) -> None:
    """Print one table; the last candidate is the one by hand."""
    scalar = medians([c.scalar for c in candidates], 3000)
    array = [t and t / ELEMENTS for t in medians([c.array for c in candidates], 3)]
    print(f"\n{title}")
    head = (
        "derived in s",
        "written out",
        "operations",
        "call, µs",
        "ratio",
        "element, ns",
        "ratio",
    )
    print(f"{'':44}" + "".join(f"{word:>13}" for word in head))
    for candidate, call, element in zip(candidates, scalar, array, strict=True):
        made = candidate.derivation or {}
        cells = [
            f"{made['seconds']:.3f}" if made else "",
            str(made.get("written out", "")),
            str(made.get("operations", "")),
            *(_cells(call, scalar[-1], 1e6)),
            *(_cells(element, array[-1], 1e9)),
        ]
        if candidate.array is None:
            cells[0] = f"> {PATIENCE}"
        print(f"{candidate.label:44}" + "".join(f"{cell:>13}" for cell in cells))


def _cells(seconds: float | None, reference: float | None, scale: float) -> tuple[str, str]:
    if not seconds or not reference:
        return "", ""
    return f"{seconds * scale:.3g}", f"{seconds / reference:.2f}"


def main() -> None:
    angles = [ANGLES[name] for name in ("theta", "thetadot", "phidot", "psidot")]
    attitude = [*ATTITUDE.values()]
    whole, across = [*attitude, *OMEGA.values()], [*attitude, OMEGA["omega1"], OMEGA["omega2"]]
    angle_arrays, whole_arrays = spread(angles), spread(whole)
    report(
        "Symmetric top",
        [
            shipped_candidate("shipped, Euler angles", "top_in_euler_angles", angles, **TOP),
            shipped_candidate(
                "shipped, quaternion", "heavy_top", across, **TOP, omega3=OMEGA["omega3"]
            ),
            lagrange_candidate("lagrange_top", TOP),
            Candidate(
                "by hand, Euler angles",
                None,
                lambda: top_by_hand(*angles),
                lambda: top_by_hand(*angle_arrays, sin=np.sin, cos=np.cos),
            ),
        ],
    )
    report(
        "Heavy body, three moments, any centre of mass",
        [
            shipped_candidate("shipped, quaternion", "heavy_body", whole, **BODY),
            lagrange_candidate("lagrange_body", BODY),
            Candidate(
                "by hand, quaternion",
                None,
                lambda: body_by_hand(*whole),
                lambda: body_by_hand(*whole_arrays),
            ),
        ],
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--derive", metavar="NAME", help="derive one right-hand side, print JSON")
    arguments = parser.parse_args()
    if arguments.derive:
        print(json.dumps(derive(arguments.derive)))
    else:
        main()
