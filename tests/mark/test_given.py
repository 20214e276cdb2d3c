"""Answers marked by what another file states, without a lecture."""

import pytest

from rigidtop.cli import main
from rigidtop.errors import RigidtopError
from rigidtop.mark.answer import mark
from rigidtop.mark.task import task_of

BEAD = r"On a parabola $L = \frac12 m(1 + a^2x^2)\dot x^2 - \frac12 mga x^2$"
GOAL = r"(1 + a^2x^2)\ddot x = -a^2x\dot x^2 - gax"
RIGHT = r"""
$$\frac{\partial L}{\partial\dot x} = m(1+a^2x^2)\dot x$$
$$\frac{d}{dt}\left(m(1+a^2x^2)\dot x\right) = m(1+a^2x^2)\ddot x + 2ma^2x\dot x^2$$
$$(1+a^2x^2)\ddot x + a^2x\dot x^2 + gax = 0$$
"""


def test_a_right_answer_arrives_and_half_of_it_does_not():
    assert mark(RIGHT, task_of(BEAD, GOAL)).passed
    half = mark("".join(RIGHT.splitlines(True)[:3]), task_of(BEAD, GOAL))
    assert half.first_wrong is None
    assert not half.arrives


@pytest.mark.parametrize(
    ("old", "new", "line", "slip"),
    [
        ("+ 2ma", "+ ma", 3, "2 times m a² x ẋ²"),
        ("+ gax", "- gax", 4, "another sign before g a x"),
        (r"(1+a^2x^2)\dot x$$", r"(1+a^2x)\dot x$$", 2, "x squared"),
    ],
)
def test_a_wrong_line_is_named(old, new, line, slip):
    wrong = mark(RIGHT.replace(old, new, 1), task_of(BEAD, GOAL)).first_wrong
    assert (wrong.line, wrong.slip) == (line, slip)


def test_a_force_that_the_file_gives_may_be_used():
    given = (
        r"With $v = \dot x$: $L = \frac12 m v^2$ and "
        r"$\frac{d}{dt}\frac{\partial L}{\partial\dot x} = -bv$"
    )
    goal = r"m\ddot x + b\dot x = 0"
    assert mark(r"$$m\ddot x = -b\dot x$$", task_of(given, goal)).passed
    assert not mark(r"$$m\ddot x = b\dot x$$", task_of(given, goal)).passed


@pytest.mark.parametrize(
    ("given", "goal", "said"),
    [
        ("no formula", "x = 1", "no formula of that file"),
        (BEAD, "x", "no equation is read in 'x'"),
    ],
)
def test_what_says_nothing_is_refused(given, goal, said):
    with pytest.raises(RigidtopError, match=said):
        task_of(given, goal)


def test_the_command(tmp_path, capsys):
    given, answer = tmp_path / "given.md", tmp_path / "answer.md"
    given.write_text(BEAD, "utf-8")
    answer.write_text(RIGHT, "utf-8")
    assert main(["mark", str(answer), "--given", str(given), "--to", GOAL]) == 0
    assert "every line follows, and the derivation arrives" in capsys.readouterr().out
    assert main(["mark", str(answer), "--given", str(given), "--from", "1", "--to", GOAL]) == 2
    assert "--given FILE --to TEX" in capsys.readouterr().err


def test_an_answer_may_not_give_a_start_two_values():
    given = r"On a spring $L = \frac12 m\dot x^2 - \frac12 k x^2$."
    starts = r"$$ x(0) = 3, \quad \dot x(0) = 1, \quad x(0) = {} $$ $$ m\ddot x = -k x $$"
    task = task_of(given, r"m\ddot x = -k x")
    assert mark(starts.format(3), task).passed
    wrong = mark(starts.format(2), task).first_wrong
    assert (wrong.said, wrong.slip) == ("x = 2", "3 in place of 2")
