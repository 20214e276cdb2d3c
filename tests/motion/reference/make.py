"""Computes the reference: `python make.py` in this folder, ten minutes on two cores; needs gmpy2.

Each motion is computed at more than 40 digits and stored rounded to the nearest float, and with it
what an error of one unit in the last place of the inputs does to it: no computation in floats can
be expected to do better.  For that the motion is computed again, at 40 digits as well, with each
input in turn changed by such a unit, and the changes that this makes are added up.  Near an
unstable motion they are large, and not proportional to the change of the input.
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Callable, Iterator, Sequence
from multiprocessing import Pool
from pathlib import Path
from typing import Any

import draw
import numpy as np
import periods
import taylor
from draw import Drawn
from mpmath.ctx_mp import MPContext
from mpmath.libmp import NoConvergence
from numpy.typing import NDArray
from periods import Period
from taylor import Body, Number, Numbers, State, Top

HERE = Path(__file__).parent

LINEAR = 1e-13
"""Below this a change is proportional to that of the input, and as large for the opposite one."""

Floats = NDArray[np.float64]

Changes = Floats
"""For each time: changes of the attitude (rad), of ω (rad/s) and of the axis' horizontal part."""


def top_of(numbers: Numbers, inputs: Sequence[float]) -> Top:
    lambda1, lambda3, mass, arm, g, *motion = (numbers.real(x) for x in inputs)
    return Top(lambda1, lambda3, mass * arm * g, *motion)


def body_of(numbers: Numbers, inputs: Sequence[float]) -> Body:
    return Body(*(numbers.real(x) for x in inputs))


def top_changes(numbers: Numbers, inputs: Sequence[float]) -> Iterator[tuple[str, Number]]:
    """The inputs that matter to more than the attitude at t = 0, with their units.

    M, R and g occur only in the product MgR, whose unit is that of its factors together.
    """
    given = dict(zip(draw.TOP_INPUTS, inputs, strict=True))
    for name in ("lambda1", "lambda3", "theta", "theta_dot", "phi_dot", "omega3"):
        yield name, unit(numbers, given[name])
    factors = [given[name] for name in ("M", "R", "g")]
    weight = math.prod(numbers.real(x) for x in factors)
    relative = sum(unit(numbers, x) / numbers.real(x) for x in factors if x)
    yield "weight", weight * relative


def body_changes(numbers: Numbers, inputs: Sequence[float]) -> Iterator[tuple[str, Number]]:
    for name, value in zip(draw.BODY_INPUTS[:6], inputs[:6], strict=True):
        yield name, unit(numbers, value)


def unit(numbers: Numbers, value: float) -> Number:
    """One unit in the last place; 0 for 0, which is exact."""
    return numbers.real(math.ulp(value) if value else 0.0)


def sensitivity(
    numbers: Numbers,
    motion: Any,
    changes: Iterator[tuple[str, Number]],
    follow: Callable[[Any], list[State]],
) -> tuple[list[State], Changes]:
    """The states, and the sum over the inputs of what one unit more or less changes."""
    states = follow(motion)

    def changed(name: str, amount: Number) -> Changes:
        other = follow(motion._replace(**{name: getattr(motion, name) + amount}))
        pairs = zip(states, other, strict=True)
        return np.array([taylor.differences(numbers, *pair) for pair in pairs])

    total = np.zeros((len(states), 3))
    speeds = [math.hypot(*map(float, s.omega)) for s in states]
    sizes = np.array([[1.0, speed or 1.0, 1.0] for speed in speeds])
    for name, amount in changes:
        if amount:
            change = changed(name, amount)
            if np.any(change > LINEAR * sizes):
                change = np.maximum(change, changed(name, -amount))
            total += change
    return states, total


FAR_TOPS, FAR_BODIES = 200, 100


def period_of(numbers: Numbers, motion: Top | Body) -> Period:
    """At 50 digits; ArithmeticError too near to a special case."""
    context = MPContext()
    context.dps = 50
    exact = type(motion)(*(context.mpf(str(x)) for x in motion))
    found = (periods.top_period if isinstance(motion, Top) else periods.body_period)(context, exact)
    return Period(*(numbers.real(context.nstr(x, 50)) for x in found))


def far(count: int, drawn: Sequence[Drawn], name: str, seed: int) -> list[Drawn]:
    """The first `count` motions that have a period, at times of up to 10⁶ s."""
    numbers, rng = taylor.gmpy2_numbers(), np.random.default_rng([draw.SEED, seed])
    result: list[Drawn] = []
    for one in rng.permutation(np.array(drawn, dtype=object)):
        make = top_of if name == "far_tops" else body_of
        try:
            period_of(numbers, make(numbers, one.inputs))
        except (ArithmeticError, NoConvergence):
            continue
        times = [draw.log_uniform(rng, 1e2, 1e5), rng.uniform(1e5, 1e6) * rng.choice([-1, 1])]
        result.append(Drawn(name, one.inputs, [float(t) for t in times]))
        if len(result) == count:
            break
    return result


def write_far(folder: Path, jobs: int) -> None:
    tops = far(FAR_TOPS, draw.tops(), "far_tops", 3)
    bodies = far(FAR_BODIES, draw.bodies(), "far_bodies", 4)
    bodies = [Drawn(one.family, [*one.inputs, math.nan], one.times) for one in bodies]
    write(folder / "far.npz", [*tops, *bodies], compute_far, jobs)


def compute_far(drawn: Drawn) -> tuple[Any, ...]:
    if drawn.family == "far_tops":
        return compute_top(drawn, late=True)
    return compute_body(Drawn(drawn.family, drawn.inputs[:10], drawn.times), late=True)


def rounded(states: Sequence[State]) -> tuple[list[list[float]], list[list[float]]]:
    return (
        [[float(x) for x in s.quaternion] for s in states],
        [[float(x) for x in s.omega] for s in states],
    )


def from_time(states: Sequence[State], moments: Floats, weight: float, t: list[float]) -> Changes:
    """What a unit of t changes."""
    result = []
    for state, at in zip(states, t, strict=True):
        q0, q1, q2, q3 = map(float, state.quaternion)
        omega = np.array(state.omega, dtype=float)
        z = 2 * (q1 * q3 - q0 * q2), 2 * (q0 * q1 + q2 * q3)
        torque = np.array([weight * z[1], -weight * z[0], 0.0])
        rate = (np.cross(moments * omega, omega) + torque) / moments
        speeds = [np.linalg.norm(omega), np.linalg.norm(rate), math.hypot(*omega[:2])]
        result.append([speed * math.ulp(at) for speed in speeds])
    return np.array(result)


def compute_top(drawn: Drawn, late: bool = False) -> tuple[Any, ...]:
    numbers = taylor.gmpy2_numbers()
    times = [numbers.real(t) for t in drawn.times]

    def follow(top: Top) -> list[State]:
        if late:
            return periods.later_top(numbers, top, period_of(numbers, top), times)
        return taylor.follow_top(numbers, top, times)

    top = top_of(numbers, drawn.inputs)
    states, changes = sensitivity(numbers, top, top_changes(numbers, drawn.inputs), follow)
    given = dict(zip(draw.TOP_INPUTS, drawn.inputs, strict=True))
    moments = np.array([given["lambda1"], given["lambda1"], given["lambda3"]])
    changes += from_time(states, moments, given["M"] * given["R"] * given["g"], drawn.times)
    # φ turns the motion about ẑ, ψ that of the axes in the body about e₃.
    phi, psi = (math.ulp(given[name]) if given[name] else 0.0 for name in ("phi", "psi"))
    for change, state in zip(changes, states, strict=True):
        across = math.hypot(float(state.omega1), float(state.omega2))
        sine = 2 * float(abs(state.alpha * state.beta))
        change += (phi + psi, psi * across, phi * sine)
    return (*rounded(states), changes)


def compute_body(drawn: Drawn, late: bool = False) -> tuple[Any, ...]:
    numbers = taylor.gmpy2_numbers()
    times = [numbers.real(t) for t in drawn.times]

    def follow(body: Body) -> list[State]:
        if late:
            return periods.later_body(numbers, body, period_of(numbers, body), times)
        return taylor.follow_body(numbers, body, times)

    body = body_of(numbers, drawn.inputs)
    states, changes = sensitivity(numbers, body, body_changes(numbers, drawn.inputs), follow)
    changes += from_time(states, np.array(drawn.inputs[:3]), 0.0, drawn.times)
    if max(map(abs, drawn.inputs[6:])) < 1:
        changes[:, 0] += 2 * math.ulp(1.0)  # the attitude at t = 0, which turns everything
    return (*rounded(states), changes)


def write(path: Path, drawn: Sequence[Drawn], compute: Callable[[Drawn], Any], jobs: int) -> None:
    begin, results = time.monotonic(), []
    with Pool(jobs) as pool:
        for result in pool.imap(compute, drawn, chunksize=4):
            results.append(result)
            if len(results) % 100 == 0:
                print(f"{path.name}: {len(results)} of {len(drawn)}, "
                      f"{time.monotonic() - begin:.0f} s", flush=True)  # fmt: skip
    attitudes, omegas, changes = (np.array(column) for column in zip(*results, strict=True))
    np.savez_compressed(
        path,
        family=np.array([d.family for d in drawn]),
        inputs=np.array([d.inputs for d in drawn]),
        times=np.array([d.times for d in drawn]),
        attitude=attitudes,
        omega=omegas,
        sensitivity=changes[:, :, :2].astype(np.float32),
        axis_sensitivity=changes[:, :, 2],  # may be smaller than the smallest float32
    )
    print(f"{path.name}: {len(drawn)} motions, {time.monotonic() - begin:.0f} s", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--every", type=int, default=1, help="only every n-th motion")
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument("--folder", type=Path, default=HERE, help="where the files go")
    parser.add_argument("files", nargs="*", default=["tops", "bodies", "far"])
    options = parser.parse_args()
    folder, every, jobs = options.folder, options.every, options.jobs
    if "tops" in options.files:
        write(folder / "tops.npz", draw.tops()[::every], compute_top, jobs)
    if "bodies" in options.files:
        write(folder / "bodies.npz", draw.bodies()[::every], compute_body, jobs)
    if "far" in options.files:
        write_far(folder, jobs)


if __name__ == "__main__":
    main()
