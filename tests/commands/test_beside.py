"""Lines judged by two processes become what they become in one."""

import os
import sys

import pytest

from rigidtop.collection import load
from rigidtop.commands import beside
from rigidtop.judge.page import outcome

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux forks safely")

LETTERS = """
from rigidtop.theory.lettered import in_order, real
from rigidtop.theory.symbols import Glyph

W, theta, x = in_order(
    real("W", Glyph("W"), "any number", "1"),
    real("theta", Glyph("θ"), "any number", "1"),
    real("x", Glyph("x"), "any number", "1"),
)
"""
PAGES = """
from rigidtop.proof.page import Page

from . import letters as letters

PAGES = (Page("1", "A page", "A page.", (), text="page"),)
"""
PAGE = r"""# 1 A page

## Laws

Chosen. The size:

$$W = {size}$$

Chosen. The sine:

$$W = x\sin\theta$$

Chosen. The one:

$$x = 1$$

## Lines

Put the one into the sine:

$$W = \sin\theta$$

Divide the sine by $x \neq 0$:

$$\frac{W}{x} = \sin\theta$$

Put the size and the one into the sine:

$$\sin\theta = {size}$$
"""


@pytest.fixture
def lecture(tmp_path, monkeypatch):
    monkeypatch.setattr(beside, "can_fork", lambda: True)

    def of(size):
        folder = tmp_path / "own"
        folder.mkdir(exist_ok=True)
        (folder / "__init__.py").write_text(PAGES, "utf-8")
        (folder / "letters.py").write_text(LETTERS, "utf-8")
        (folder / "page.md").write_text(PAGE.replace("{size}", size), "utf-8")
        return load(folder).lecture

    return of


def nothing(_):
    return None


def judged(alone):
    made, _, _ = beside.judged_beside(alone, nothing, nothing)
    return made


def said(lecture):
    judged = [lecture.judged(id) for id in lecture.lines]
    return [(str(x.problem), x.known.conditions, outcome(lecture, x)) for x in judged]


def test_both_say_the_same(lecture):
    alone = lecture(r"\frac12")
    made = judged(alone)
    assert made is not alone
    assert said(made) == said(alone)
    assert {x.verdict for *_, x in said(made)} >= {"premise", "sampled"}


def test_outcomes_come_from_the_other_process(lecture, monkeypatch):
    made = judged(lecture(r"\frac12"))
    monkeypatch.setattr("rigidtop.judge.page._in_time", lambda *_: pytest.fail("judged here"))
    follow = [x for x in map(made.judged, made.lines) if x.follows]
    assert len({outcome(made, x).verdict for x in follow}) > 1


def test_a_false_line_is_judged_before_what_rests_on_it(lecture):
    alone = lecture("2")
    assert judged(alone) is alone
    assert "holds for no numbers" in str(alone.judged([*alone.lines][-1]).problem)


def test_a_process_that_ends_is_not_waited_for(lecture, monkeypatch):
    monkeypatch.setattr(beside, "_answer", lambda *_: os._exit(1))
    alone = lecture(r"\frac12")
    assert judged(alone) is alone


def test_what_can_not_be_sent_is_judged_here(lecture, monkeypatch):
    def refusing(_):
        raise TypeError

    monkeypatch.setattr(beside.pickle, "dumps", refusing)
    alone = lecture(r"\frac12")
    assert judged(alone) is alone


@pytest.mark.parametrize("size", [r"\frac12", "2"])
def test_what_is_asked_besides_is_asked_in_both(lecture, size):
    alone = lecture(size)
    made, follow, lines = beside.judged_beside(
        alone, lambda x: [x.judged(id).follows for id in x.lines], lambda x: [*x.lines]
    )
    assert follow == [made.judged(id).follows for id in made.lines]
    assert lines == [*alone.lines]


def test_a_single_processor_is_left_alone(monkeypatch):
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: {0})
    assert not beside.can_fork()
