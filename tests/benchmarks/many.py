"""Many motions, sections and exponents of systems: CPU seconds, all in one run.

Run ``python tests/benchmarks/many.py``; ``--quick`` has a hundredth of the motions.  Every row is
the least of three goes but for those that compile, which are new each time.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import partial
from importlib.util import find_spec
from time import process_time

import numpy as np
import sympy
from rows import Row, table
from systems import PARAMETERS, pendulums, versions

from rigidtop.system.many import SystemMotions
from rigidtop.system.system import System

END = 10.0


def cpu(go: Callable[[], object], goes: int = 3) -> float:
    """The least CPU time (s) of so many goes, all threads together."""
    taken = []
    for _ in range(goes):
        before = process_time()
        go()
        taken.append(process_time() - before)
    return min(taken)


def many(count: int) -> list[Row]:
    """Double pendulums over 10 s at 1e-10, from arrays to arrays."""
    task = f"{count:,} double pendulums over 10 s at 1e-10"
    starts = np.random.default_rng(1).uniform(-1, 1, (2, count))
    system, few = pendulums(2), max(count // 200, 2)
    rows = []
    for method in ("taylor", "DOP853") if find_spec("heyoka") else ("DOP853",):
        motions = system.motions(PARAMETERS, q=starts)
        alone = system.motions(PARAMETERS, q=starts[:, :few])
        motions.integrate(0.1, method)  # what is compiled, is so now
        motions[0].integrate(0.1, method)

        def together(method: str) -> object:
            return system.motions(PARAMETERS, q=starts).integrate(END, method)

        def one_by_one(method: str, alone: SystemMotions) -> object:
            return [each.integrate(END, method) for each in alone]

        rows += [
            Row(task, motions.way(method), cpu(partial(together, method)), count),
            Row(
                task,
                f"{method}, one by one",
                cpu(partial(one_by_one, method, alone), 1) * count / few,
                count,
                note=f"{few} run, scaled",
            ),
        ]
    return rows


def one() -> list[Row]:
    """A motion over 10 s at 1e-12: with a new integrator, the same again, from another start."""
    task, system = "one double pendulum over 10 s at 1e-12", pendulums(2)
    first = system.motion(PARAMETERS, q=[1.0, 0.5])
    other = system.motion(PARAMETERS, q=[1.1, 0.5])
    runs = (("new", first, 1), ("again", first, 3), ("from another start", other, 3))
    return [
        Row(task, f"taylor, {name}", cpu(partial(motion.integrate, END, "taylor", 1e-12), goes))
        for name, motion, goes in runs
    ]


def stars() -> System:
    """Hénon's and Heiles's."""
    x, y, u, v = sympy.symbols("x y u v", real=True)
    return System((u**2 + v**2) / 2 - (x**2 + y**2) / 2 - x**2 * y + y**3 / 3, [x, y], [u, v])


def section() -> list[Row]:
    """Where x increases through zero over 1000 s, with states."""
    motion, x = stars().motion(q=[0, 0.1], qdot=[0.49, 0.0]), sympy.Symbol("x", real=True)
    go = partial(motion.section, x, 1000.0, 1, "taylor")
    note = f"{len(go())} points"
    return [Row("a Poincaré section over 1000 s at 1e-12", "taylor", cpu(go), note=note)]


def exponent() -> list[Row]:
    """Of a chaotic double pendulum, compiled before."""
    motion = pendulums(2).motion(PARAMETERS, q=[2.0, 1.0])
    go = partial(motion.lyapunov, 100.0, "taylor")
    return [Row("the largest Lyapunov exponent over 100 s", "taylor", cpu(go), note=repr(go()))]


def derivatives() -> list[Row]:
    """Of a double pendulum by six quantities, beside its motion alone; both compiled before."""
    system = pendulums(2)
    motion = system.motion(PARAMETERS, q=[1.0, 0.5])
    by = [system.parameters[0], system.parameters[1], *system.q, *system.names.v]
    alone, together = partial(motion.integrate, (0, 10)), partial(motion.sensitivities, (0, 10), by)
    alone(), together()
    first, second = cpu(alone), cpu(together)
    note = f"{second / first:.1f} times the motion"
    return [
        Row("a motion over 10 s", "DOP853", first),
        Row("and its derivatives by 6 quantities", "DOP853", second, note=note),
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description="Measure many motions of systems.")
    parser.add_argument("--quick", action="store_true", help="a hundredth of the motions")
    options = parser.parse_args()
    rows = [*many(100 if options.quick else 10_000), *derivatives()]
    if find_spec("heyoka"):
        rows += [*one(), *section(), *exponent()]
    print(table(rows))
    print(versions())


if __name__ == "__main__":
    main()
