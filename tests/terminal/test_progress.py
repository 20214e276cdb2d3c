"""A bar is for a terminal: one line that is gone in the end, and nothing in a file."""

import io

from rigidtop.terminal import progress


class Terminal(io.StringIO):
    def isatty(self):
        return True


def clock(monkeypatch, times):
    ticks = iter(times)
    monkeypatch.setattr(progress.time, "monotonic", lambda: next(ticks))


def test_a_bar_counts_what_is_new(monkeypatch):
    clock(monkeypatch, [0.0, 0.01, 2.0, 2.01, 9.0])
    out = Terminal()
    show = progress.bar("sweeping", out)
    for done in (500, 600, 601, 1000):
        show(done, 1000)
    shown = "sweeping [############        ]  60%  600 of 1000, 50/s, 0:08 left"
    assert out.getvalue() == f"\r\033[K{shown}\r\033[K"


def test_nothing_in_a_file():
    out = io.StringIO()
    show = progress.bar("sweeping", out)
    for done in range(1001):
        show(done, 1000)
    assert out.getvalue() == ""


def test_hours():
    text = progress.line("x", 1, 10**9, 1, 0.001)
    assert text.endswith(" 1 of 1000000000, 1k/s, 277:46:40 left")
    assert progress.line("x", 0, 10, 0, 5.0).endswith("0%  0 of 10")


def test_items_pass_through_with_a_bar(monkeypatch):
    clock(monkeypatch, [0.0, 1.0, 2.0, 3.0, 4.0])
    out = Terminal()
    assert list(progress.over("judging", ["a", "b", "c"], out)) == ["a", "b", "c"]
    lines = out.getvalue().split("\r\033[K")
    assert [line[:7] for line in lines] == ["", "judging", "judging", "judging", ""]
    assert lines[2].startswith("judging [######              ]  33%  1 of 3, ")


def test_seconds_pass_where_the_length_is_unknown():
    out, file = Terminal(), io.StringIO()
    for stream in (out, file):
        show = progress.ticking("typesetting", stream)
        for seconds in (0.4, 1.2, 1.9, 2.0, -1):
            show(seconds)
    assert out.getvalue() == "\r\033[Ktypesetting, 1 s\r\033[Ktypesetting, 2 s\r\033[K"
    assert file.getvalue() == ""
