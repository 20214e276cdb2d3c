"""The closed forms, judged by the reference: every stored motion, on and near all special cases.

The attitude may be wrong by 2e-13 rad and ω by 2e-13 of |ω| (or 2e-13 rad/s, if that is more), and
by what 50 units in the last place of the inputs would change.
"""

from collections.abc import Sequence

import judge
import numpy as np
import pytest
import taylor
from judge import Reference
from make import top_of

from rigidtop import FreeBody

TOPS = [name for name in judge.families() if len(judge.of_family(name)[0].inputs) == 11]


@pytest.mark.parametrize("family", judge.families())
def test_motions_of(family: str) -> None:
    _all_right(list(judge.worst(judge.of_family(family))))


@pytest.mark.parametrize("family", TOPS)
def test_axis_relative_to_its_tilt_of(family: str) -> None:
    """sin θ exp(iφ), to 2e-13 of the largest sin θ and 50 units in the last place of the inputs."""
    _all_right(list(judge.worst(judge.of_family(family), measure=judge.axis_ratios)))


def test_where_three_roots_meet() -> None:
    """At the threshold of the sleeping top, one unit of the inputs does 2e-14 there."""
    inputs = [
        3.1193852397748603, 3.716627228668256, 1.0, 0.6372049720662561, 9.81, 0.05531511941424391,
        0.0034154711537521384, 0.0, -1.4155983430294339, 0.0, -2.3762347763763585,
    ]  # fmt: skip
    numbers, times = taylor.mpmath_numbers(45), np.array([-21.13141048634151])
    top = top_of(numbers, inputs)
    known = taylor.follow_top(numbers, top, [numbers.real(t) for t in times])
    none = np.zeros((1, 3))
    known_parts = (
        np.array(part, dtype=float)
        for part in zip(*((s.quaternion, s.omega) for s in known), strict=True)
    )
    reference = Reference(
        "tops", 0, "triple_root", np.array(inputs), times, *known_parts, none[:, :2], none[:, 2]
    )
    assert judge.errors(reference, reference.motion.exact(times)).max() < 2e-14
    assert judge.axis_ratios(reference).max() < 0.1


def _all_right(found: Sequence[tuple[float, Reference, str]]) -> None:
    wrong = sorted((one for one in found if not one[0] <= 1), key=lambda one: -one[0])
    report = [f"{one.name} {ratio:.1e} {problem}" for ratio, one, problem in wrong[:5]]
    assert not wrong, "\n".join([*report, judge.describe(wrong[0][1])])


def test_parts_whose_products_vanish_beside_the_middle_axis_count_as_none() -> None:
    """ω₁ and ω₃ of 10⁻¹⁹⁸: their squares are no floats, and the turn about e₂ went elsewhere."""
    tiny = FreeBody(1.0, 1.7, 2.3).motion(omega=[2.9e-247, 1.0, 3.5e-198])
    turned = tiny.exact([2.1]).rotation[0].as_rotvec()
    np.testing.assert_allclose(turned, [0.0, 2.1, 0.0], atol=1e-14)
