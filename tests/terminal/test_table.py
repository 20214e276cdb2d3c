"""Tables for the terminal."""

import io

from hypothesis import given
from hypothesis import strategies as st

from rigidtop.terminal.table import columns, cut, padded, table, wants_color, wrapped

ROWS = [
    ("3.54", "proved", "λ₁θ̈ and φ̇"),
    ("two-roots", "assuming", "only if cos θ ≠ 0 and the spin is high"),
]


def test_columns_are_aligned_whatever_the_accents():
    assert table(ROWS, ("name", "verdict", "note"), width=60).splitlines() == [
        "name       verdict   note",
        "─" * 59,
        "3.54       proved    λ₁θ̈ and φ̇",
        "two-roots  assuming  only if cos θ ≠ 0 and the spin is high",
    ]


def test_the_last_column_is_wrapped():
    assert table(ROWS[1:], width=40).splitlines() == [
        "two-roots  assuming  only if cos θ ≠ 0",
        "                     and the spin is",
        "                     high",
    ]


def test_numbers_to_the_right_and_one_column():
    assert table([("a", "1", "x"), ("b", "10", "y")], right=(1,)).splitlines() == [
        "a   1  x",
        "b  10  y",
    ]
    assert table([("one",), ("two",)], width=20) == "one\ntwo"
    assert table([]) == ""


def test_what_finds_no_room_stands_below_beside_the_first():
    made = table([("0", "1.5", "10.25"), ("1", "2.5", "7")], ("t/s", "x/m", "v/m"), width=12,
                 right=range(3))  # fmt: skip
    assert made.splitlines() == [
        *("t/s  x/m", "────────", "  0  1.5", "  1  2.5", ""),
        *("t/s    v/m", "──────────", "  0  10.25", "  1      7"),
    ]


def test_a_first_column_that_leaves_no_room_is_wrapped():
    rows = [("how fast the top must spin, searched", "4.9e-15", "1e-11"), ("one", "0", "1")]
    assert table(rows, ("a second way", "error", "allowed"), width=40).splitlines() == [
        *("a second way           error    allowed", "─" * 39),
        *("how fast the top must  4.9e-15  1e-11", "spin, searched"),
        "one                    0        1",
    ]
    narrow = table(rows, ("a second way", "error", "allowed"), width=24).splitlines()
    assert max(map(columns, narrow)) <= 24
    assert [line.split("  ")[0] for line in narrow[2:6]] == [
        "how fast the", "top must spin,", "searched", "one",
    ]  # fmt: skip


def test_colour_changes_no_width():
    made = table(ROWS, width=60, colors={"proved": "green"})
    assert "\033[32mproved\033[0m    λ₁" in made
    assert made.replace("\033[32m", "").replace("\033[0m", "") == table(ROWS, width=60)


class _Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_colour_only_on_a_terminal(monkeypatch):
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm")
    assert wants_color(_Terminal())
    assert not wants_color(io.StringIO())
    monkeypatch.setenv("NO_COLOR", "1")
    assert not wants_color(_Terminal())
    monkeypatch.delenv("NO_COLOR")
    monkeypatch.setenv("TERM", "dumb")
    assert not wants_color(_Terminal())


@given(st.text(alphabet="aλφ\u0307\u0308日 ", max_size=30), st.integers(1, 20))
def test_cut_wrap_and_pad_keep_to_their_room(text, room):
    assert columns(cut(text, room)) <= room
    assert all(columns(line) <= room for line in wrapped(text, room))
    assert columns(padded(cut(text, room), room)) == room
