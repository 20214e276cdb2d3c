"""Motions, by what a user would otherwise take: medians of rounds in one run.

Run ``python tests/benchmarks/motions.py``; ``--quick`` takes seconds, and ``--markdown`` prints the
table of the kinds of motions.

The example top: λ₁ = 1, λ₃ = 0.5, M = 1, g = 9.81, R = 0.5, θ = 0.5, θ̇ = 0.1, φ̇ = 1, ψ̇ = 40, over
10 s.  Every way gives θ, φ, ψ and their rates at every sample.  Compilation and derivation are not
in the times of a motion; a closed form is solved anew each time.  How long that takes depends on
the motion: other kinds, of the same top and of free bodies, stand beside it.
"""

from __future__ import annotations

import argparse
import importlib
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray
from rows import ROUNDS, Progress, Row, Task, Way, markdown, measured, missing, table

from rigidtop.motion import attitude, equations
from rigidtop.motion.body import FreeBody
from rigidtop.motion.many import top_motions
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import EXAMPLE_TOP
from rigidtop.terminal.progress import bar

Floats = NDArray[np.float64]

TOP = EXAMPLE_TOP
START = {"theta": 0.5, "theta_dot": 0.1, "phi_dot": 1.0, "psi_dot": 40.0}
STATE = (0.5, 0.0, 0.0, 0.1, 1.0, 40.0)
"""θ, φ, ψ and their rates at t = 0."""

END = 10.0


@dataclass(frozen=True)
class Kind:
    """A motion of the example top, or of a free body."""

    name: str

    truth: tuple[float, float, float, float]
    """The quaternion of its attitude at the end, by Taylor series with 50 digits.

    See tests/motion/reference/taylor.py."""

    start: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    """θ, θ̇, φ̇ and ψ̇ of the top."""

    moments: tuple[float, float, float] | None = None
    """Of a free body, which starts with the identity and `omega`."""

    omega: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def motion(self) -> Any:
        if self.moments is not None:
            return FreeBody(*self.moments).motion(self.omega)
        return HeavyTop(**TOP).motion(**dict(zip(START, self.start, strict=True)))


EXAMPLE = Kind(
    "the example top",
    (-0.9151311559196205, 0.21371230694656781, 0.11348931310410929, -0.322462700379366),
    (0.5, 0.1, 1.0, 40.0),
)

KINDS = (
    Kind(
        "cusps",
        (0.5980458820117939, 0.05743452787550003, -0.24177956323027677, -0.7619613118922971),
        (0.5, 0.0, 0.0, 40.0),
    ),
    Kind(
        "a slow spin",
        (0.2546020767963464, 0.20830445167153472, -0.29429430151155445, 0.8973170576795222),
        (0.5, 0.0, 0.0, 10.0),
    ),
    Kind(
        "a wild one",
        (0.1381890696023954, 0.8965299373352204, 0.42084435843019774, -0.0052800077277763815),
        (2.0, 3.0, -4.0, 15.0),
    ),
    Kind(
        "loops",
        (0.7880870356962916, 0.26382257477702636, -0.5534427359353015, -0.05493278844097244),
        (1.0, 0.0, -3.0, 30.0),
    ),
    Kind(
        "almost steady",
        (0.952227557148584, -0.18772539131419735, -0.16105776239366845, 0.17911519766763626),
        (0.5, 0.0, 0.25, 40.0),
    ),
    Kind(
        "past the upright",
        (0.7535015896112485, -0.5353846893834542, 0.13092767862528268, -0.3584083310930407),
        (0.3, 4.0, 0.0, 12.0),
    ),
    Kind(
        "a pendulum",
        (-0.880147553072263, 0.0, 0.4747002052041982, 0.0),
        (1.0, 0.5, 0.0, 0.0),
    ),
    Kind(
        "falling",
        (-0.1905448670271952, -0.1343583266208076, 0.9614552640970927, -0.1457541383880216),
        (0.1, 0.0, 0.0, 2.0),
    ),
    Kind(
        "near the separatrix",
        (0.9406261528082588, 0.278999810157476, -0.1067934817981889, 0.16117288491134762),
        (1.0, -2.052, 0.65, 1.65),
    ),
    Kind(
        "a free body",
        (-0.28920088681658684, 0.017729711160730306, 0.05941901511352761, -0.955258020144084),
        moments=(1.0, 1.7, 2.5),
        omega=(1.0, 0.5, 2.0),
    ),
    Kind(
        "about the long axis",
        (-0.1769606477526958, -0.9570475734555294, 0.12718994790750193, -0.19122653696889527),
        moments=(1.0, 1.7, 2.5),
        omega=(2.0, 0.5, 0.3),
    ),
    Kind(
        "two equal moments",
        (-0.9927950068330401, 0.10674107924202153, 0.004151078964511475, 0.05428798166318777),
        moments=(1.0, 1.0, 1.6),
        omega=(1.0, 0.5, 3.0),
    ),
    Kind(
        "the flip",
        (-0.012931118997556819, 0.998548307446118, -0.006665672431725793, -0.051861668590557984),
        moments=(1.0, 2.0, 3.0),
        omega=(0.01, 2.0, 0.01),
    ),
)

FREE = next(kind for kind in KINDS if kind.moments)

TOLERANCE = 1e-12
TOPS = 1_000_000


def measure(quick: bool = False, progress: Progress | None = None) -> list[Row]:
    """Run everything; `quick` has a tenth of the samples, and one round.

    `progress` is called with the number of tasks done, and of all.
    """
    scale = 10 if quick else 1
    sizes, tops = (10_000 // scale, 1_000_000 // scale), TOPS // scale
    tasks = [Task(f"{n:,} samples of one motion", partial(_trajectory, n), n) for n in sizes]
    tasks += [
        Task(f"{n:,} samples", partial(_other, kind, n), n, kind.name)
        for n in sizes
        for kind in KINDS
    ]
    tasks += [
        Task("one time of a top", partial(_one_time, EXAMPLE)),
        Task("one time of a free body", partial(_one_time, FREE)),
        Task(f"{tops:,} tops, each at one time", partial(_tops, tops), tops),
    ]
    return measured(tasks, 1 if quick else ROUNDS, progress)


def _module(name: str) -> ModuleType | None:
    """A package that may be missing."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


# --- One motion -----------------------------------------------------------------------------------


def _by_hand(theta: float, theta_dot: float, phi_dot: float, psi_dot: float) -> tuple[float, ...]:
    """θ̈, φ̈, ψ̈ as one writes them who solves (3.54)–(3.56) for them."""
    weight = TOP["M"] * TOP["g"] * TOP["R"]
    s, c = math.sin(theta), math.cos(theta)
    momentum = TOP["lambda3"] * (psi_dot + phi_dot * c)
    phi_ddot = theta_dot * (momentum - 2 * TOP["lambda1"] * phi_dot * c) / (TOP["lambda1"] * s)
    return (
        s * (phi_dot * (TOP["lambda1"] * phi_dot * c - momentum) + weight) / TOP["lambda1"],
        phi_ddot,
        theta_dot * phi_dot * s - phi_ddot * c,
    )


def _system(state: Sequence[float]) -> tuple[float, ...]:
    theta, _, _, theta_dot, phi_dot, psi_dot = state
    return theta_dot, phi_dot, psi_dot, *_by_hand(theta, theta_dot, phi_dot, psi_dot)


def _trajectory(samples: int) -> list[Way]:
    from scipy.integrate import odeint, solve_ivp

    t = np.linspace(0.0, END, samples)
    exact, compiled, heyoka = _other(EXAMPLE, samples)

    def dop853() -> object:
        return solve_ivp(
            lambda _, state: _system(state.tolist()),
            (0.0, END),
            STATE,
            method="DOP853",
            t_eval=t,
            rtol=TOLERANCE,
            atol=TOLERANCE,
        ).y

    def lsoda() -> object:
        return odeint(
            lambda state, _: _system(state.tolist()),
            STATE,
            t,
            rtol=TOLERANCE,
            atol=TOLERANCE,
            mxstep=100_000,
        ).T

    return [
        exact,
        compiled,
        heyoka,
        Way("solve_ivp DOP853, 1e-12", dop853, exact.error),
        Way("odeint, 1e-12", lsoda, exact.error, rounds=2 if samples > 100_000 else ROUNDS),
    ]


def _other(kind: Kind, samples: int) -> list[Way]:
    """The closed form, twice, and the fastest of the others; of a free body attitude and ω."""
    t, truth = np.linspace(0.0, END, samples), np.array(kind.truth)
    theta, *rates = kind.start

    def exact(compiled: bool = False) -> object:
        path = kind.motion().exact(t, compiled)
        if kind.moments is not None:
            return [*path.quaternion.T, *path.omega.T]
        return path.theta, path.phi, path.psi, path.theta_dot, path.phi_dot, path.psi_dot

    def last(rows: Any) -> float:
        q = np.array([row[-1] for row in rows[:4]])
        if kind.moments is None:
            q = attitude.from_spinors(np.cos(q[0] / 2), np.sin(q[0] / 2), q[1], q[2])
        q = q / np.linalg.norm(q)
        return 2 * float(min(np.linalg.norm(q - truth), np.linalg.norm(q + truth)))

    body = (1.0, 0.0, 0.0, 0.0, *kind.omega)
    start = (theta, 0.0, 0.0, *rates) if kind.moments is None else body
    by_numba = Way("exact, Numba", lambda: exact(compiled=True), last)
    return [
        Way("exact", exact, last),
        by_numba if _module("numba") else missing("exact, Numba", "numba"),
        _heyoka_grid(t, last, start, kind.moments),
    ]


def _heyoka_grid(
    t: Floats,
    last: Callable[[Any], float],
    start: Sequence[float],
    moments: Sequence[float] | None,
) -> Way:
    """The example top in Euler angles, or a free body in its quaternion and ω."""
    name = "heyoka propagate_grid"
    heyoka = _module("heyoka")
    if heyoka is None:
        return missing(name, "heyoka")
    if moments is None:
        state = heyoka.make_vars("theta", "phi", "psi", "thetadot", "phidot", "psidot")
        of_top = equations.top_in_euler_angles(*TOP.values(), sin=heyoka.sin, cos=heyoka.cos)
        rates = [*state[3:], *of_top([state[0], *state[3:]])]
    else:
        state = heyoka.make_vars("q0", "q1", "q2", "q3", "omega1", "omega2", "omega3")
        rates = list(equations.heavy_body(*moments, *[0.0] * 5)(state))
    integrator = heyoka.taylor_adaptive(list(zip(state, rates, strict=True)), list(start))

    def go() -> object:
        integrator.time = 0.0
        integrator.state[:] = start
        return integrator.propagate_grid(t)[-1].T

    return Way(name, go, last)


# --- One time ---


def _one_time(kind: Kind) -> list[Way]:
    known = kind.motion()
    return [
        Way("exact, a new motion", lambda: kind.motion().exact(END)),
        Way("exact, again", lambda: known.exact(END)),
        Way("integrate, DOP853, 1e-12", lambda: known.integrate(END, rtol=1e-12), rounds=1),
    ]


# --- Many motions ---------------------------------------------------------------------------------


def _tops(count: int) -> list[Way]:
    from scipy.integrate import solve_ivp

    random = np.random.default_rng(1)
    spread: dict[str, Any] = {
        name: value * random.uniform(0.95, 1.05, count) for name, value in START.items()
    }
    times = random.uniform(0.0, END, count)

    def exact() -> Any:
        return top_motions(**TOP, **spread).exact(times)

    few = 5

    def one_by_one() -> Any:
        body = HeavyTop(**TOP)
        for k in range(few):
            body.motion(**{name: float(values[k]) for name, values in spread.items()}).exact(
                times[k]
            )

    def dop853() -> Any:
        for k in range(few):
            state = [spread["theta"][k], 0.0, 0.0, *(spread[n][k] for n in list(START)[1:])]
            solve_ivp(
                lambda _, x: _system(x.tolist()),
                (0.0, times[k]),
                state,
                method="DOP853",
                rtol=TOLERANCE,
                atol=TOLERANCE,
            )

    return [
        Way("exact, in one call", exact),
        Way("exact, one by one", one_by_one, of_all=few / count, note=f"{few} run, scaled"),
        Way("solve_ivp DOP853, 1e-12", dop853, of_all=few / count, note=f"{few} run, scaled"),
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description="Measure motions beside what one would take.")
    parser.add_argument("--quick", action="store_true", help="a tenth of the samples, one round")
    parser.add_argument("--markdown", action="store_true", help="the kinds of motions as Markdown")
    options = parser.parse_args()
    rows = measure(options.quick, bar("measuring"))
    print(markdown(rows) if options.markdown else table(rows))


if __name__ == "__main__":
    main()
