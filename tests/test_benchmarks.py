"""The benchmark measures what it says: right answers, ratios, and packages that are missing."""

import motions
import pytest
import rows

from rigidtop.motion import equations


def test_rows_are_medians_of_rounds():
    ways = [
        rows.Way("whole", lambda: None),
        rows.Way("part", lambda: None, of_all=0.1, rounds=1),
        rows.missing("absent", "absent"),
    ]
    clocked = iter([3.0, 0.5, 1.0, 2.0])
    task = rows.Task("task", lambda: ways)
    found = rows.rows_of(task, 3, lambda go: next(clocked))
    assert [row.seconds for row in found] == [2.0, 5.0, None]
    assert found[2].note == "absent is not installed"


def test_the_hand_written_equations_are_the_derived_ones():
    derived = equations.top_in_euler_angles(*motions.TOP.values())
    for state in [(0.5, 0.1, 1.0, 40.0), (2.0, -1.0, 0.3, -7.0)]:
        assert motions._by_hand(*state) == pytest.approx(derived(state), rel=1e-13)


@pytest.mark.parametrize("k", [0, 2, 3, 4])
def test_every_way_arrives_at_the_truth(k):
    """θ, φ and ψ after 10 s, which the reference code of the tests gives with 50 digits."""
    way = motions._trajectory(50)[k]
    if way.go is None:
        pytest.skip(way.note)
    error = way.error(way.go())
    assert error < (1e-13 if way.name == "exact" else 1e-8)


@pytest.mark.parametrize("kind", motions.KINDS, ids=lambda kind: kind.name)
def test_every_kind_arrives_at_the_truth(kind):
    exact, _, heyoka = motions._other(kind, 500)
    most = 5e-12 if kind.name == "near the separatrix" else 1e-13
    for way, bound in ((exact, most), (heyoka, 1e-10)):
        if way.go is not None:
            assert way.error(way.go()) < bound
