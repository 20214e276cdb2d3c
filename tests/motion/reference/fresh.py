"""Judges the closed forms by motions that nobody has seen: `python fresh.py --seed N -n COUNT`.

They are drawn from the families of `draw`, in turn, from the seed, and computed at 40 digits; needs
gmpy2, and about 20 ms of one core for each.  What rounding of the inputs does is computed, with
some ten times the work, only for those that differ by more than 2e-13.  The exit code is 1 if an
error is beyond what `judge` allows: of the attitude, of ω or, relative to the tilt, of the axis.
"""

from __future__ import annotations

import argparse
import sys
import warnings
from collections import defaultdict
from collections.abc import Iterator, Sequence
from functools import partial
from multiprocessing import Pool
from typing import Any

import draw
import judge
import make
import numpy as np
import taylor
from draw import Drawn
from judge import Reference


def drawn(names: list[str], count: int, seed: int) -> Iterator[Drawn]:
    """`count` motions, from the families in turn."""
    for number in range(count):
        name = names[number % len(names)]
        one = draw.top if name in draw.TOP_FAMILIES else draw.body
        yield one(name, number // len(names), seed)


def reference(one: Drawn, result: tuple[Any, ...]) -> Reference:
    attitude, omega, changes = (np.array(part) for part in result)
    inputs, times = np.array(one.inputs), np.array(one.times)
    return Reference(
        "fresh", 0, one.family, inputs, times, attitude, omega, changes[:, :2], changes[:, 2]
    )


def worst(known: Reference, runs: Sequence[judge.Run]) -> float:
    """The largest ratio of an error to what is allowed."""
    measures = [judge.ratios]
    if len(known.inputs) == len(draw.TOP_INPUTS):
        measures.append(judge.axis_ratios)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return max(float(measure(known, run).max()) for measure in measures for run in runs)


def judged(one: Drawn, runs: Sequence[judge.Run]) -> tuple[Drawn, float, str]:
    """The ratio, and what to say of one above 1."""
    try:
        is_top = len(one.inputs) == len(draw.TOP_INPUTS)
        numbers = taylor.gmpy2_numbers()
        times = [numbers.real(t) for t in one.times]
        if is_top:
            states = taylor.follow_top(numbers, make.top_of(numbers, one.inputs), times)
        else:
            states = taylor.follow_body(numbers, make.body_of(numbers, one.inputs), times)
        ratio = worst(reference(one, (*make.rounded(states), np.zeros((len(times), 3)))), runs)
        if ratio <= 1:
            return one, ratio, ""
        known = reference(one, make.compute_top(one) if is_top else make.compute_body(one))
        ratio = worst(known, runs)
        return one, ratio, "\n".join(judge.describe(known, run) for run in runs if ratio > 1)
    except Exception as problem:
        return one, np.inf, f"{one}: {type(problem).__name__}: {problem}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("family", nargs="*", help="families (default: all)")
    parser.add_argument("-n", type=int, default=2000, help="how many motions (default: 2000)")
    parser.add_argument("--seed", type=int, default=draw.SEED + 1)
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument("--compiled", action="store_true", help="judge the path by Numba too")
    options = parser.parse_args()
    try:
        taylor.gmpy2_numbers()
    except ImportError:
        parser.error("40 digits need gmpy2: pip install gmpy2")
    runs = [judge.exact, judge.compiled] if options.compiled else [judge.exact]
    names = options.family or [*draw.TOP_FAMILIES, *draw.BODY_FAMILIES]
    found: dict[str, list[float]] = defaultdict(list)
    wrong = 0
    with Pool(options.jobs) as pool:
        every = drawn(names, options.n, options.seed)
        for done, (one, ratio, message) in enumerate(
            pool.imap_unordered(partial(judged, runs=runs), every, 8), 1
        ):
            found[one.family].append(ratio)
            if not ratio <= 1:
                wrong += 1
                print(f"{one.family} {ratio:.2g}\n{message}", flush=True)
            if done % 1000 == 0:
                print(f"{done} of {options.n}, {wrong} beyond", file=sys.stderr, flush=True)
    print(f"{'family':28}{'motions':>8}{'beyond':>7}{'median':>9}{'worst':>9}")
    for name in names:
        values = found[name]
        beyond = sum(not value <= 1 for value in values)
        if values:
            print(f"{name:28}{len(values):8}{beyond:7}{np.median(values):9.2g}{max(values):9.2g}")
    print(f"{options.n} motions, seed {options.seed}: {wrong} beyond what is allowed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
