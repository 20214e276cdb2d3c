"""Texts judged: what is right follows, what is wrong is told, what is new is taken as it stands."""

import re
from collections import Counter
from pathlib import Path

import pytest

from rigidtop.judge import text as home
from rigidtop.judge.judge import Judge
from rigidtop.judge.text import judged
from rigidtop.read.macros import defined

AUTHORS = Path(__file__).with_name("authors")
FILES = {"goldstein.tex": 9, "landau.tex": 6, "morin.tex": 9, "arnold.md": 8}
"""Notes of four authors, and how many formulas follow in them."""


@pytest.mark.parametrize("name", FILES)
def test_the_notes_of_four_authors_follow_from_themselves(name):
    rows = judged((AUTHORS / name).read_text("utf-8"))
    assert sum(row.outcome.passed is True for row in rows) >= FILES[name]
    assert not {row.outcome.verdict for row in rows} & {"false", "undecided", "unread"}


SLIPS = [
    ("goldstein.tex", r"\cos\theta\right)^2 - Mgl", r"\cos\theta\right)^2 + Mgl"),
    ("goldstein.tex", r"I_1\sin^2\theta + I_3\cos^2", r"I_1\cos^2\theta + I_3\cos^2"),
    ("goldstein.tex", r"\half I_1\frac{(b", r"I_1\frac{(b"),
    ("landau.tex", r"= I_3(\dot\psi + \dot\varphi\cos", r"= I_1(\dot\psi + \dot\varphi\cos"),
    ("landau.tex", r"\frac{\M}{I_3} - \cos", r"\frac{\M}{I_3} + \cos"),
    ("morin.tex", r"+ mg(\ell + x)\cos\th - ", r"- mg(\ell + x)\cos\th - "),
    ("morin.tex", r"= m(\ell + x)^2\dot\th.", r"= m(\ell + x)\dot\th."),
    ("morin.tex", r"+ 2m\dot x\dot\th", r"+ m\dot x\dot\th"),
    ("arnold.md", r"= r^2\dot\ph \tag", r"= r\dot\ph \tag"),
    ("arnold.md", r"r\dot\ph^2 - \frac{\partial U}", r"r\dot\ph^2 + \frac{\partial U}"),
    ("arnold.md", r"M = x\dot y - y\dot x", r"M = x\dot y + y\dot x"),
]
"""A file, what stands there, and a slip: a sign, a factor, a function, an index, a power."""


@pytest.mark.parametrize(("name", "right", "wrong"), SLIPS)
def test_a_slip_is_found_where_it_is_and_nothing_else_is_condemned(name, right, wrong):
    text = (AUTHORS / name).read_text("utf-8")
    assert text.count(right) == 1
    line = text[: text.index(right)].count("\n") + 1
    rows = judged(text.replace(right, wrong))
    [false] = [row for row in rows if row.outcome.passed is False]
    assert false.line in (line, max(row.line for row in rows if row.line <= line))
    assert false.outcome.slip
    assert false.outcome.right
    assert false.outcome.rests_on


SPRING = r"$L = \frac12 m\dot x^2 - \frac12 kx^2$" + "\n"
TEXTS = [
    # a Lagrangian and its equations
    (SPRING + r"$m\ddot x = -kx$", {2: True}),
    (SPRING + r"$m\ddot x = kx$", {2: False}),
    (r"$L = \frac12 m e^{2bt}(\dot x^2 - w^2x^2)$" "\n" r"$\ddot x + 2b\dot x + w^2x = 0$",
     {2: True}),
    (r"$L = \frac12 m\dot x^2 - V(x)$" "\n" r"$m\ddot x = \frac{\partial V(x)}{\partial x}$",
     {2: False}),
    # of quantities of the text's own
    ("$p = mv$\n$w = p$\n$w = -mv$", {1: None, 2: None, 3: False}),
    ("$x = y$\n$x = y$", {1: None, 2: True}),
    (r"$v^2 = 2gh$" "\n" r"$T = \frac12 mv^2$" "\n$T = mgh$", {1: None, 2: None, 3: True}),
    (r"$m\dot v = mg - bv$" "\n$u = mg/b$\n" r"$\dot v = g(1 + v/u)$", {3: False}),
    (r"$m\dot v = mg - bv$" "\n" r"$\frac{dv}{dt} = g$", {2: None}),
    ("$q = q$", {1: None}),
    # what is said of one moment, of a case, or is denied
    (r"$L = \frac12 m\dot x^2 - \frac12 kx^2$, $E = \frac12 m\dot x^2 + \frac12 kx^2$." "\n"
     r"At $t = 0$ we have $x = a$ and $\dot x = 0$. Hence" "\n" r"$$E = \frac12 ka^2$$",
     {2: None, 3: True}),
    (r"$L = \frac12 m\dot x^2 - mgx$." "\n" r"One might think that $\ddot x = g$. But" "\n"
     r"$$\ddot x = -g$$", {2: None, 3: True}),
    (r"$m\dot v = mg - bv$." "\n" "If $v > mg/b$ it gets slower.", {2: None}),
    # a link of a chain that is a new premise
    ("$P = 1 + c$, $Q = 1 - c$" "\n" "$$QP = PQ = 0$$", {2: None}),
    # a variation is no factor
    (r"$h = a\sin\varphi$" "\n" r"$$\delta h = a\cos\varphi\,\delta\varphi$$", {2: None}),
    (r"$T = \oops$", {1: None}),
    # motions in time are put into their equations
    (SPRING + r"With $w = \sqrt{k/m}$" "\n" r"$x = A\cos wt + B\sin wt$", {3: True}),
    (SPRING + r"With $w = \sqrt{k/m}$" "\n" r"$x = A\cosh wt$", {3: None}),
    (r"$\ddot z = -g$" "\n" r"$z = vt - \frac12 gt^2$", {2: True}),
    # what is set in one item does not hold in the next
    ("A bead has $v = 2 a$.\n\n1. Let $x = 3 a$ and $y = 2 x$. Then\n   $y = 6 a$.\n"
     "2. Let $x = 5 a$ and $y = 2 x$. Then\n   $y = 10 a$.\n", {1: None, 4: True, 6: True}),
    # two shapes of a letter are one, unless a text has both
    ("$\\phi = 2 a$\n$b = φ$\n$b = 2 a$", {3: True}),
    ("$\\varphi = 2 a$\n$\\phi = 3 a$\n$b = \\varphi$\n$b = 2 a$", {2: None, 4: True}),
    ("$p_\\phi = 2 a$\n$b = p_\\varphi$\n$b = 2 a$", {3: True}),
]  # fmt: skip
"""Texts, and whether the formulas of a line follow, are wrong (False), or neither (None)."""


@pytest.mark.parametrize(("text", "lines"), TEXTS)
def test_what_becomes_of_a_line(text, lines):
    passed = {}
    for row in judged(text):
        passed.setdefault(row.line, set()).add(row.outcome.passed)
    assert {line: passed[line] for line in lines} == {line: {x} for line, x in lines.items()}


SETS = Path(__file__).with_name("short_notes.txt").read_text("utf-8").split("\n\n")
"""Short notes, a line a display.  What is wrong has ! before it, or !? where it may be of another
case; what holds in a case that it does not state ~, what is right and can't be told ?."""


def test_how_many_lines_of_short_notes_are_told_right():
    counts = Counter()
    for lines in (each.strip().split("\n") for each in SETS[::3]):
        marks = [re.match("!?[~?]?", line)[0] for line in lines]
        source = "\n\n".join(f"$${line.lstrip('!~?')}$$" for line in lines)
        outcomes = {(row.line - 1) // 2: row.outcome for row in judged(source)}
        counts.update((mark, outcomes[k].passed) for k, mark in enumerate(marks))
    assert counts["", True] >= FOLLOWING
    assert counts["", False] <= CONDEMNED
    assert counts["!", False] >= FOUND
    assert counts["!", True] <= EXCUSED


FOLLOWING, CONDEMNED, FOUND, EXCUSED = 74, 1, 33, 1
"""So many right lines follow at least, and are called wrong at most; so many wrong ones are found
at least, and follow at most."""


def test_macros_of_other_files_are_known():
    source = "$$p = m\\q$$\n\n$$w = p$$\n\n$$w = m\\dot x$$"
    rows = judged(source, defined(r"\newcommand{\q}{\dot x}"))
    assert rows[-1].outcome.passed
    assert judged(source)[0].outcome.verdict == "unread"


def test_once_the_time_is_up_the_rest_is_open_and_says_so():
    rows = judged("$E = T$ and $E = V$", until=-1)
    assert {(row.outcome.passed, row.outcome.why) for row in rows} == {
        (None, "the time for the file was over")
    }


def test_a_statement_that_takes_too_long_is_open_and_nothing_is_judged_by_it(monkeypatch):
    kept = Judge.judged

    def slow(judge, statement, situation, context):
        while situation.number == 0:
            pass
        return kept(judge, statement, situation, context)

    monkeypatch.setattr(home, "A_STATEMENT", 0.3)
    monkeypatch.setattr(Judge, "judged", slow)
    first, second = judged("$p = 2 q$\n$p = 3 q$")
    assert first.outcome.why == "judging it takes longer than 0.3 s"
    assert second.outcome.verdict == "definition"


def test_an_error_of_ours_is_not_hidden(monkeypatch):
    def broken(*_):
        raise AttributeError("no")

    monkeypatch.setattr(Judge, "judged", broken)
    [row] = judged("$x = y$")
    assert row.outcome.verdict == "undecided"
    assert row.outcome.why == ("rigidtop itself fails here, please report it (AttributeError: no)")
