"""A formula that is written out gives what the formula gives, and computes what it needs."""

import math
from dataclasses import dataclass

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rigidtop.trace import Trace, written

FLOATS = st.floats(-1e3, 1e3)


@dataclass(frozen=True)
class Pair:
    one: object
    other: object
    positive: object
    fixed: str = "as it was"


def solve(k, s):
    a, b = s
    larger = k.larger(a, b)

    def above():
        return k.sqrt(a), k.sqrt(a) / 2

    def below():
        return k.where(b > 0, b, -b) + k.sqrt(-a), larger

    root, half = k.pick(a > 0, above, below)
    return Pair((root, half), k.over(a, b), k.either(a > 0, b > 0))


def at(k, pair, t):
    return pair.one[0] * t, k.where(pair.positive, pair.one[1], abs(pair.other)) + t * t


def by_hand(a, b, t):
    root = math.sqrt(a) if a > 0 else abs(b) + math.sqrt(-a)
    half = root / 2 if a > 0 else max(a, b)
    over = a / b if b else math.copysign(math.inf, a) * math.copysign(1.0, b) if a else math.nan
    return (root, half, over, float(a > 0 or b > 0)), (
        root * t,
        (half if a > 0 or b > 0 else abs(over)) + t * t,
    )


WRITTEN = written(2, solve, at)


@given(FLOATS, FLOATS, FLOATS)
def test_what_is_written_is_the_formula(a, b, t):
    numbers, state = by_hand(a, b, t)
    found = WRITTEN.solved(a, b)
    assert found.numbers == pytest.approx(numbers, rel=1e-15, nan_ok=True)
    assert found.at(t) == pytest.approx(state, rel=1e-15, nan_ok=True)
    built = found.orbit
    assert (*built.one, built.other) == pytest.approx(numbers[:3], nan_ok=True)
    assert (built.positive, built.fixed) == (a > 0 or b > 0, "as it was")


def test_a_branch_that_is_not_taken_is_not_computed():
    """√ of less than nothing would raise, and a common part is computed once."""
    assert WRITTEN.solve((4.0, 1.0))[:2] == (2.0, 1.0)
    assert WRITTEN.solve((-4.0, 1.0))[:2] == (3.0, 1.0)
    assert WRITTEN.source.count("sqrt(") == 2
    k = Trace()
    a = k.value("a")
    outside = a + 1
    inside, other = k.pick(a > 0, lambda: (a + 1, a + 2), lambda: (a + 1, a + 2))
    assert inside is outside
    assert other is not a + 2  # that of the arms may be one that must not be computed
    assert a + 0.0 is not a + -0.0  # equal floats, and not the same


def test_a_formula_may_not_branch_by_itself():
    with pytest.raises(TypeError, match="branches by `where` and `pick`"):
        written(1, lambda k, s: (s[0],) if s[0] > 0 else (-s[0],), at)


def test_numbers_of_python_stay_such():
    k = Trace()
    assert k.where(True, 1.0, 2.0) == 1.0
    assert k.pick(False, lambda: (1.0,), lambda: (2.0,)) == (2.0,)
    assert k.any(False) is False
    assert k.any(k.value("a") > 0) is True
