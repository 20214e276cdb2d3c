"""The benchmark measures what it says: right answers, ratios, and packages that are missing."""

from pathlib import Path

import motions
import pytest
import rows

from rigidtop.motion import equations

ROWS = [
    rows.Row("walk", "exact", 2e-3, 1000, 1e-15),
    rows.Row("walk", "other", 8e-3, 1000, 1e-12, "5 run, scaled"),
    rows.Row("walk", "absent", None, 1000, None, "absent is not installed"),
    rows.Row("run", "only", 4.2e-7),
]


def test_table():
    assert rows.table(ROWS) == (
        "walk\n"
        "  exact                              2 ms      2 µs each        1 ×  error 1e-15 rad\n"
        "  other                              8 ms      8 µs each        4 ×  error 1e-12 rad"
        "  (5 run, scaled)\n"
        "  absent                       absent is not installed\n"
        "\n"
        "run\n"
        "  only                             420 ns                       1 ×"
    )


KINDS = [
    rows.Row("fly", "exact", 2e-3, 1000, 1e-15, kind="up"),
    rows.Row("fly", "heyoka", 4e-3, 1000, 1e-12, kind="up"),
    rows.Row("fly", "exact", 3e-3, 1000, 1e-15, kind="down"),
    rows.Row("fly", "heyoka", 2e-3, 1000, 1e-12, kind="down"),
]


def test_kinds_are_compared_and_the_worst_comes_first():
    assert rows.table(KINDS) == (
        "fly: exact, heyoka; over heyoka\n"
        "  down                        3 ms      2 ms   1.50 ×  errors 1e-15, 1e-12 rad\n"
        "  up                          2 ms      4 ms   0.50 ×  errors 1e-15, 1e-12 rad"
    )
    assert rows.markdown([*ROWS, *KINDS]).splitlines()[2:] == [
        "| down | 1.50 × | 1e-15, 1e-12 |",
        "| up | 0.50 × | 1e-15, 1e-12 |",
    ]


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


@pytest.fixture
def reference(monkeypatch):
    """The spinors of a top or a body after 10 s, with 25 digits."""
    monkeypatch.syspath_prepend(str(Path(__file__).parent / "motion" / "reference"))
    import taylor

    numbers = taylor.mpmath_numbers(25)
    real = numbers.real

    def top(theta, theta_dot, phi_dot, psi_dot):
        start = taylor.Top(
            lambda1=real(1),
            lambda3=real(0.5),
            weight=real(9.81) * real(0.5),
            theta=real(theta),
            theta_dot=real(theta_dot),
            phi=real(0),
            phi_dot=real(phi_dot),
            psi=real(0),
            omega3=real(psi_dot) + real(phi_dot) * numbers.cos(real(theta)),
        )
        [state] = taylor.follow_top(numbers, start, [real(10)])
        return complex(state.alpha), complex(state.beta)

    def body(moments, omega):
        start = taylor.Body(*map(real, (*moments, *omega, 1, 0, 0, 0)))
        [state] = taylor.follow_body(numbers, start, [real(10)])
        return complex(state.alpha), complex(state.beta)

    return lambda kind: body(kind.moments, kind.omega) if kind.moments else top(*kind.start)


@pytest.mark.parametrize(
    "kind", [motions.EXAMPLE, *motions.KINDS[4::8]], ids=lambda kind: kind.name
)
def test_the_truth_of_a_kind_is_that_of_the_reference(kind, reference):
    alpha, beta = reference(kind)
    expected = alpha.real, -beta.imag, beta.real, alpha.imag
    assert kind.truth == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize(("asked", "shown"), [([], rows.table), (["--markdown"], rows.markdown)])
def test_what_is_printed(asked, shown, monkeypatch, capsys):
    monkeypatch.setattr(motions, "measure", lambda *_: KINDS)
    monkeypatch.setattr("sys.argv", ["motions.py", *asked])
    motions.main()
    assert capsys.readouterr().out == f"{shown(KINDS)}\n"
