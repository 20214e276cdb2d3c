"""The closed forms, judged by the reference: every stored motion, on and near all special cases.

The attitude may be wrong by 2e-13 rad and ω by 2e-13 of |ω| (or 2e-13 rad/s, if that is more), and
by what 50 units in the last place of the inputs would change.
"""

from collections.abc import Sequence

import judge
import pytest
from judge import Reference

TOPS = [name for name in judge.families() if len(judge.of_family(name)[0].inputs) == 11]


@pytest.mark.parametrize("family", judge.families())
def test_motions_of(family: str) -> None:
    _all_right(list(judge.worst(judge.of_family(family))))


@pytest.mark.parametrize("family", TOPS)
def test_axis_relative_to_its_tilt_of(family: str) -> None:
    """sin θ exp(iφ), to 2e-13 of the largest sin θ and 50 units in the last place of the inputs."""
    _all_right(list(judge.worst(judge.of_family(family), measure=judge.axis_ratios)))


def _all_right(found: Sequence[tuple[float, Reference, str]]) -> None:
    wrong = sorted((one for one in found if not one[0] <= 1), key=lambda one: -one[0])
    report = [f"{one.name} {ratio:.1e} {problem}" for ratio, one, problem in wrong[:5]]
    assert not wrong, "\n".join([*report, judge.describe(wrong[0][1])])
