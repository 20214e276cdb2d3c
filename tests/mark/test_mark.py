"""Right derivations are accepted in any form; a slip is found at its line, and named."""

import importlib.util
import re
import time
from contextlib import suppress
from functools import cache
from pathlib import Path

import pytest

from rigidtop.errors import RigidtopError
from rigidtop.judge.judge import Judge
from rigidtop.judge.reading import read_text
from rigidtop.judge.slips import changes
from rigidtop.mark.answer import mark as mark_task
from rigidtop.mark.marking import Mark
from rigidtop.mark.task import task
from rigidtop.notation import NOTES
from rigidtop.read.equations import equations
from rigidtop.tree import nodes as n
from rigidtop.tree.latex import latex

_SPEC = importlib.util.spec_from_file_location("motions", Path(__file__).with_name("motions.py"))
motions = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(motions)


@cache
def mark(source, start, goal):
    return mark_task(source, task(start, goal))


ANSWERS = {
    file.stem: (*re.findall(r"3\.\d\d", file.stem), file.read_text("utf-8"))
    for file in sorted((Path(__file__).parent / "answers").glob("*.tex"))
}


@pytest.mark.parametrize("name", ANSWERS)
def test_a_right_answer_passes(name):
    start, goal, source = ANSWERS[name]
    found = mark(source, start, goal)
    assert found.passed, found
    assert found.summary == f"every line follows, and the derivation arrives at ({goal})"
    assert {line.mark for line in found.lines} <= {Mark.FOLLOWS, Mark.DEFINITION, Mark.ASSUMPTION}


# --- The way on the pages ------------------------------------------------------------------------

ROOT = (
    r"\frac{\lambda_3\omega_3 SIGN \sqrt{\lambda_3^2\omega_3^2 - 4\lambda_1MgR\cos\theta}}"
    r"{2\lambda_1\cos\theta}"
)
SLOW, FAST = ROOT.replace("SIGN", "-"), ROOT.replace("SIGN", "+")
KINETIC = (
    r"T = \tfrac12\lambda_1(\dot\phi^2\sin^2\theta + \dot\theta^2)"
    r" + \tfrac12\lambda_3(\dot\psi + \dot\phi\cos\theta)^2"
)


@pytest.mark.parametrize(
    ("start", "goal", "right", "wrong"),
    [
        ("3.36", "3.40", r"\Omega_b = \frac{(\lambda_1 - \lambda_3)\omega_3}{\lambda_1}",
         r"\Omega_b = \frac{(\lambda_3 - \lambda_1)\omega_3}{\lambda_1}"),
        ("3.41", "3.44", KINETIC, KINETIC.replace(r"\sin^2", r"\cos^2")),
        ("3.57", "two-roots", rf"\Omega_- = {SLOW}$$ $$\Omega_+ = {FAST}",
         rf"\Omega_- = {FAST}$$ $$\Omega_+ = {SLOW}"),
    ],
)  # fmt: skip
def test_any_goal_to_which_the_pages_lead(start, goal, right, wrong):
    found = mark(f"$${right}$$", start, goal)
    assert found.passed
    assert not mark(f"$${wrong}$$", start, goal).passed
    assert mark(f"$${wrong}$$", start, goal).first_wrong is not None


def test_one_root_of_two_does_not_arrive():
    assert not mark(rf"$$\Omega_- = {SLOW}$$", "3.57", "two-roots").arrives
    alone = (
        r"For large $\omega_3$ $$\Omega_+ \approx \frac{\lambda_3\omega_3}{\lambda_1\cos\theta}$$"
    )
    assert not mark(alone, "3.57", "two-roots").arrives


def matrix(first=r"c_\phi c_\theta c_\psi - s_\phi s_\psi"):
    return rf"""$$O = \begin{{bmatrix}}
{first} & -c_\phi c_\theta s_\psi - s_\phi c_\psi & c_\phi s_\theta\\
s_\phi c_\theta c_\psi + c_\phi s_\psi & c_\phi c_\psi - s_\phi c_\theta s_\psi & s_\phi s_\theta\\
-s_\theta c_\psi & s_\theta s_\psi & c_\theta
\end{{bmatrix}}$$"""


def test_a_matrix_may_be_the_goal():
    right, wrong = (mark(source, "3.46", "3.47") for source in (matrix(), matrix(r"c_\phi c_\psi")))
    assert right.passed
    assert not wrong.passed
    assert wrong.first_wrong is not None


def test_a_name_that_is_none_is_refused():
    with pytest.raises(RigidtopError, match="no line of the lecture is called 'x'"):
        mark("", "x", "3.53")


COEFFICIENTS = r"a = \lambda_1\cos\theta$, $b = -\lambda_3\omega_3$ and $c = MgR"


@pytest.mark.parametrize(
    "said",
    [
        rf"It is $a\Omega^2 + b\Omega + c = 0$ with ${COEFFICIENTS}$.",
        rf"It is $$a\Omega^2 + b\Omega + c = 0$$ where ${COEFFICIENTS}$.",
        rf"$$a\Omega^2 + b\Omega + c = 0$$ Here ${COEFFICIENTS}$.",
        r"$$a\Omega^2 + b\Omega + c = 0,\quad "
        + COEFFICIENTS.replace("$ and $", ",\\ ").replace("$, $", ",\\ ")
        + "$$",
    ],
)
def test_coefficients_may_be_said_behind_their_equation(said):
    answer = rf"{said} $$\Omega = \frac{{-b \pm \sqrt{{b^2 - 4ac}}}}{{2a}}$$ $$\Omega_\pm = ROOT$$"
    found = mark(answer.replace("ROOT", ROOT.replace("SIGN", r"\pm")), "3.57", "two-roots")
    assert found.passed
    assert [line.mark for line in found.lines[:3]] == [Mark.DEFINITION] * 3


def test_a_wrong_coefficient_is_found_in_its_equation():
    said = rf"$$a\Omega^2 + b\Omega + c = 0$$ Here ${COEFFICIENTS.replace('b = -', 'b = ')}$."
    wrong = mark(said, "3.57", "two-roots")
    assert wrong.first_wrong.said == "a Ω² + b Ω + c = 0"
    assert wrong.first_wrong.slip == "another sign before b Ω"


def test_what_comes_of_an_equation_is_no_name_in_front_of_it():
    answer = r"$$0 = Z - \lambda_1\ddot\theta,\quad Z = 2\lambda_1\ddot\theta$$"
    assert mark(answer, "3.53", "3.54").first_wrong.said == "Z = 2 λ₁ θ̈"


# --- Slips ---------------------------------------------------------------------------------------

SLIPS = [
    # where, what is written, what is written instead, the line of the file
    ("from-3.53-to-3.54-by-lagrange", "+ MgR", "- MgR", 6),
    ("from-3.53-to-3.54-by-lagrange", r"MgR\sin", r"MgR\cos", 6),
    ("from-3.53-to-3.54-by-lagrange", r"&= \lambda_1\dot\theta", r"&= \lambda_3\dot\theta", 5),
    ("from-3.53-to-3.54-with-omega3", r"\lambda_3\omega_3\dot\phi + MgR)$$"
     + "\n" + r"$$\ddot", r"2\lambda_3\omega_3\dot\phi + MgR)$$" + "\n" + r"$$\ddot", 3),
    ("from-3.53-to-3.55-differentiated",
     r" + 2\lambda_1\dot\phi\dot\theta\sin\theta\cos\theta - "
     r"\lambda_3(\dot\psi + \dot\phi\cos\theta)\dot\theta\sin\theta",
     r" + \lambda_3(\ddot\psi + \ddot\phi\cos\theta)\cos\theta", 2),
    ("from-3.53-to-3.56", r" - \dot\phi\dot\theta\sin\theta", "", 3),
    ("from-3.54-to-3.57", r"- (\lambda_3\omega_3)", r"+ (\lambda_3\omega_3)", 6),
    ("from-3.53-to-3.57-spin-alone", r"$$\omega_3 = \frac{\lambda_1\cos\theta\,\Omega^2 + MgR}"
     r"{\lambda_3\Omega}$$",
     r"$$\Omega = \frac{\lambda_3\omega_3 - \sqrt{\lambda_3^2\omega_3^2 "
     r"- 4\lambda_1MgR\cos\theta}}{2\lambda_1\cos\theta}$$", 4),
    ("from-3.41-to-3.42", r"\cos\theta\,\mathbf e_3 - \sin\theta\,\mathbf e_1'$$",
     r"\cos\theta\,\mathbf e_3 + \sin\theta\,\mathbf e_1'$$", 1),
    ("from-3.42-to-3.43", r"\lambda_3(\dot\psi + \dot\phi\cos\theta)", r"\lambda_3\dot\psi", 3),
    ("from-3.43-to-3.45", r"L_3\cos\theta + \lambda_1", r"L_3\sin\theta + \lambda_1", 1),
    ("from-3.36-to-3.37", r"(\lambda_2 - \lambda_3)", r"(\lambda_2 + \lambda_3)", 1),
    ("from-3.37-to-3.38", r"-\Omega_b^2\omega_1", r"\Omega_b^2\omega_1", 1),
    ("from-3.50-to-3.52", r"gR\,\hat{\mathbf z}\times\mathbf e_3",
     r"gR\,\mathbf e_3\times\hat{\mathbf z}", 1),
    ("from-3.34-to-3.46", r"\mathbf r = O\mathbf r'", r"\mathbf r = O^T\mathbf r'", 1),
]  # fmt: skip


@pytest.mark.parametrize(("name", "old", "new", "line"), SLIPS)
def test_a_slip_is_found_at_its_line(name, old, new, line):
    start, goal, source = ANSWERS[name]
    assert old in source
    found = mark(source.replace(old, new, 1), start, goal)
    wrong = found.first_wrong
    assert not found.passed
    assert wrong is not None
    assert wrong.line == line
    assert "it holds with " in wrong.note or "the left side is " in wrong.note
    if wrong.slip:
        again = mark(f"$${wrong.right}$$", start, goal).lines
        assert [x.mark for x in again] == [Mark.FOLLOWS], "the right line is not right"


def changed(name):
    """Lines with one small change, in TeX, and whether that makes them wrong.

    Whether a line is wrong is told by motions that share nothing with the judge.
    """
    start, goal, source = ANSWERS[name]
    found = []
    for _, each in read_text(source)[0]:
        if each.relations == ("=",):
            known = n.letters(each.sides[0]) | n.letters(each.sides[1])
            found += changes(*each.sides, known, frozenset())
    for change in found[:: max(1, len(found) // TRIED)]:
        written = f"{latex(change.left)} = {latex(change.right)}"
        [line] = equations(written, NOTES)
        with suppress(ArithmeticError, AttributeError, KeyError, TypeError, ValueError):
            yield motions.is_wrong(line.equation, start, goal), written


TRIED = 12
"""Of so many changes of an answer it is asked whether they make a line wrong."""


CHANGED = (
    *("from-3.34-to-3.46", "from-3.36-to-3.37", "from-3.43-to-3.45", "from-3.50-to-3.52"),
    *("from-3.53-to-3.54-by-lagrange", "from-3.54-to-3.57"),
)
"""An answer for each kind of motion."""


@pytest.mark.parametrize("name", CHANGED)
def test_a_change_is_never_passed(name):
    start, goal, _ = ANSWERS[name]
    wrong, harmless = [], []
    for is_wrong, written in changed(name):
        (wrong if is_wrong else harmless).append(written)
    assert wrong
    for written in wrong[:2]:
        for line in mark(f"$${written}$$", start, goal).lines:
            assert line.mark is not Mark.FOLLOWS, (written, line)
    for written in harmless[:1]:
        for line in mark(f"$${written}$$", start, goal).lines:
            assert line.mark is not Mark.WRONG, (written, line)


# --- Arrival -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("start", "goal", "source"),
    [
        ("3.53", "3.54", "$$0 = 0$$"),
        ("3.53", "3.54", r"$$\mathcal L = T - V$$"),
        ("3.54", "3.57", r"$$\dot\theta = 0$$"),
        # Times zero, and times what may vanish.
        ("3.54", "3.57", r"$$0\cdot(\lambda_1\Omega^2\cos\theta + MgR) = 0$$"),
        ("3.54", "3.57", r"$$\lambda_1\Omega^2\sin\theta\cos\theta - \lambda_3\omega_3\Omega"
         r"\sin\theta + MgR\sin\theta = 0$$"),
        ("3.54", "3.57", r"$$\cos\theta(\lambda_1\Omega^2\cos\theta - \lambda_3\omega_3\Omega"
         r" + MgR) = 0$$"),
        ("3.53", "3.55", r"$$p_\phi = \lambda_1\dot\phi\sin^2\theta + "
         r"\lambda_3(\dot\psi + \dot\phi\cos\theta)\cos\theta$$"),
        ("3.53", "3.55", r"$$p_\phi = \text{const}$$"),
        ("3.53", "3.56", r"$$p_\phi = \text{const}$$"),
        ("3.41", "3.42", r"$$\boldsymbol\omega = \dot\phi\hat{\mathbf z} + \dot\theta\mathbf e_2'"
         r" + \dot\psi\mathbf e_3$$"),
        ("3.42", "3.43", r"$$\boldsymbol\omega = -\dot\phi\sin\theta\mathbf e_1' + "
         r"\dot\theta\mathbf e_2' + (\dot\psi + \dot\phi\cos\theta)\mathbf e_3$$"),
        ("3.43", "3.44", r"$$T = \frac12\boldsymbol\omega\cdot\mathbf L$$"),
        ("3.36", "3.37", r"$$\lambda_1\dot\omega_1 = (\lambda_2 - \lambda_3)\omega_2\omega_3$$"),
    ],
)  # fmt: skip
def test_truth_that_does_not_reach_the_goal(start, goal, source):
    found = mark(source, start, goal)
    assert [line.mark for line in found.lines] == [Mark.FOLLOWS]
    assert not found.arrives
    assert not found.passed
    assert "does not arrive" in found.summary


def test_a_lost_branch_is_named_unless_it_is_excluded():
    start, goal, source = ANSWERS["from-3.54-to-3.57"]
    assert mark(source, start, goal).lost == ("sin θ = 0 is lost",)
    assert mark(r"$$\sin\theta \neq 0$$" + source, start, goal).lost == ()


def test_what_is_left_undivided_arrives_only_where_it_may_be_divided():
    whole = r"$$\sin\theta(\lambda_1\Omega^2\cos\theta - \lambda_3\omega_3\Omega + MgR) = 0$$"
    assert not mark(whole, "3.54", "3.57").arrives
    assert mark(r"$$\sin\theta \ne 0$$" + whole, "3.54", "3.57").arrives


# --- What is not judged is no pass ----------------------------------------------------------------


@pytest.mark.parametrize(
    ("source", "found"),
    [
        (r"$$x = x$$", Mark.INCONCLUSIVE),
        (r"$$\ddot\theta \approx 0$$", Mark.INCONCLUSIVE),
        (r"$$\mathbf L = 1$$", Mark.INCONCLUSIVE),
        (r"$$\theta^{\theta} = \theta^{\theta}$$", Mark.INCONCLUSIVE),
        (r"$$\frac{1}{0} = \frac{1}{0}$$", Mark.INCONCLUSIVE),
        (r"$$\cos\theta \neq \cos\theta$$", Mark.WRONG),
        (r"$$M = 0$$", Mark.WRONG),
        (r"$$\dot\theta = 0$$", Mark.WRONG),  # not in general
    ],
)
def test_what_can_not_be_judged_is_no_pass(source, found):
    goal = ANSWERS["from-3.53-to-3.54-with-omega3"][2]
    marking = mark(source + goal, "3.53", "3.54")
    assert marking.lines[0].mark is found
    assert not marking.passed


@pytest.mark.parametrize(
    ("start", "goal", "source", "found"),
    [
        # e₁′, e₂′ and e₃ turn: their components along themselves do not tell.
        ("3.53", "3.54", r"$$\mathbf e_3 = \text{const}$$", Mark.WRONG),
        ("3.53", "3.54", r"$$\frac{d}{dt}(\mathbf e_3) = \dot{\mathbf e}_3$$", Mark.FOLLOWS),
        (
            "3.53",
            "3.54",
            r"$$\dot{\mathbf e}_3 = \boldsymbol\omega\times\mathbf e_3$$",
            Mark.FOLLOWS,
        ),
        ("3.53", "3.54", r"$$\dot{\mathbf L} = \mathbf N$$", Mark.FOLLOWS),
        ("3.53", "3.54", r"$$\hat{\mathbf z} = \text{const}$$", Mark.FOLLOWS),
        ("3.50", "3.52", r"$$\mathbf e_3 = \text{const}$$", Mark.WRONG),
        ("3.36", "3.37", r"$$\mathbf L = \text{const}$$", Mark.FOLLOWS),
        ("3.34", "3.46", r"$$\mathbf r' = \text{const}$$", Mark.INCONCLUSIVE),
        ("3.34", "3.46", r"$$O = \text{const}$$", Mark.INCONCLUSIVE),
    ],
)
def test_rates_of_vectors_are_those_seen_from_space(start, goal, source, found):
    assert [line.mark for line in mark(source, start, goal).lines] == [found]


def test_a_letter_is_defined_once():
    twice = r"$$a = \lambda_1\cos\theta$$ $$a = \lambda_1$$"
    assert [line.mark for line in mark(twice, "3.54", "3.57").lines] == [
        Mark.DEFINITION,
        Mark.WRONG,
    ]


def test_what_is_false_behind_a_wrong_line_is_not_the_first():
    source = (
        r"$$p_\psi = 2\lambda_3\omega_3$$ $$p_\psi = 3\lambda_3\omega_3$$ $$V = MgR\cos\theta$$"
    )
    marks = [line.mark for line in mark(source, "3.53", "3.56").lines]
    assert marks == [Mark.WRONG, Mark.CARRIED, Mark.FOLLOWS]


def test_of_a_chain_the_wrong_link_is_named():
    found = mark(r"$$p_\psi = \lambda_3\omega_3 = \lambda_3\dot\psi$$", "3.53", "3.56")
    assert found.lines[0].note.startswith("λ₃ ω₃ = λ₃ ψ̇: at λ₃ = ")


def test_other_pairs_are_refused():
    with pytest.raises(RigidtopError, match=r"no derivation from 3\.57 to 3\.57 is marked"):
        mark("", "3.57", "3.57")
    with pytest.raises(RigidtopError, match=r"3\.26 is where a derivation starts"):
        mark("", "3.57", "3.26")
    with pytest.raises(RigidtopError, match="the lecture does not lead from the one to the other"):
        mark("", "two-roots", "p-phi-is-Lz")


@pytest.mark.parametrize("start", ["3.55", "3.57"])
def test_an_equation_may_be_reached_from_one_behind_it(start):
    balance = r"$$L_z = \lambda_1\dot\phi\sin^2\theta + L_3\cos\theta$$"
    answer = balance + "\n" + r"$$\dot\phi = \frac{L_z - L_3\cos\theta}{\lambda_1\sin^2\theta}$$"
    found = mark(answer, start, "3.45")
    assert found.passed
    assert found.summary == "every line follows, and the derivation arrives at (3.45)"
    short = mark(r"$$L_3 = \lambda_3(\dot\psi + \dot\phi\cos\theta)$$", start, "3.45")
    assert short.summary == "every line follows, but the derivation does not arrive at (3.45)"
    wrong = mark(answer.replace("- L_3", "+ L_3"), start, "3.45")
    assert [line.mark for line in wrong.lines] == [Mark.FOLLOWS, Mark.WRONG]
    wrong = mark(answer.translate(str.maketrans("+-", "-+")), start, "3.45")
    assert [line.mark for line in wrong.lines] == [Mark.WRONG, Mark.CARRIED]
    assert wrong.lines[0].slip == "another sign before L₃ cos θ"
    assert wrong.lines[1].note == "follows from line 1, which does not"


# --- Derivatives ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "source",
    [
        r"\frac{d}{dt}\lambda_1\dot\theta = 0",
        r"\frac{d}{dt}\lambda_3(\dot\psi + 7\dot\phi\cos\theta) = 0",
        r"\frac{d}{dt}L_3\cos\theta = 0",
        r"\frac{d}{dt}(p_\theta^2) = \dot p_\theta^2",
    ],
)
def test_a_derivative_that_does_not_vanish(source):
    assert mark(f"$${source}$$", "3.53", "3.54").lines[0].mark is Mark.WRONG


@pytest.mark.parametrize(
    "source",
    [
        r"\frac{d}{dt}p_\psi = 0",
        r"0 = \frac{d}{dt}L_3",
        r"\frac{d}{dt}p_\psi + \dot p_\phi = 0",
        r"\left(\frac{d}{dt}p_\psi\right)\dot\theta = 0",
        r"\frac{dp_\theta}{dt}^2 = \dot p_\theta^2",
        r"\frac{d}{dt}(\lambda_1\dot\theta) = \lambda_1\ddot\theta",
        r"\frac{d}{dt}\frac{\partial L}{\partial\dot\theta} = \frac{\partial L}{\partial\theta}",
        r"\frac{\partial \mathcal{L}}{\partial t} = 0",
    ],
)
def test_a_derivative_of_one_thing_is_read(source):
    found = mark(f"$${source}$$", "3.53", "3.54")
    assert [line.mark for line in found.lines] == [Mark.FOLLOWS]


@pytest.mark.parametrize(
    "missed",
    [
        "\n\nThis $ is alone: \n\n",
        "\n\n\\begin{mathstuff}\n p_\\psi = 7\n\\end{mathstuff}\n\n",
        "\n\n```\n$$p_\\psi = 7$$\n```\n\n",
        "\n\n<!-- $$p_\\psi = 7$$ -->\n\n",
    ],
)
def test_mathematics_that_is_passed_over_is_no_pass(missed):
    start, goal, source = ANSWERS["from-3.53-to-3.56"]
    found = mark(source + missed, start, goal)
    assert found.lines[-1].mark in (Mark.UNREAD, Mark.WRONG)
    assert found.lines[-1].line in (source.count("\n") + 3, source.count("\n") + 4)
    assert found.arrives
    assert not found.passed


# --- Constants and assumptions -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("source", "found"),
    [
        (r"p_\psi = \text{const} = 2\lambda_3(\dot\psi + \dot\phi\cos\theta)", Mark.WRONG),
        (r"\text{const} = p_\psi = 2\lambda_3\omega_3", Mark.WRONG),
        (r"p_\psi = \text{const} = p_\phi", Mark.WRONG),
        (r"p_\psi = \text{const} = \lambda_3\dot\psi", Mark.WRONG),
        (r"p_\psi = \text{const} = \lambda_3(\dot\psi + \dot\phi\cos\theta)", Mark.FOLLOWS),
    ],
)
def test_on_both_sides_of_const_stands_the_same(source, found):
    marking = mark(f"$${source}$$", "3.53", "3.56")
    assert [line.mark for line in marking.lines] == [found]
    assert marking.passed is (found is Mark.FOLLOWS)


@pytest.mark.parametrize(
    ("goal", "source", "arrives"),
    [
        ("3.55", r"$$\dot p_\phi = 0$$", False),
        (
            "3.55",
            r"$$\frac{d}{dt}\frac{\partial\mathcal L}{\partial\dot\phi} = 0$$",
            False,
        ),
        ("3.56", r"$$\dot p_\psi = 0$$", False),
        ("3.56", r"$$\dot L_3 = 0$$", False),
        ("3.56", r"$$L_3 = \text{const}$$", False),
        ("3.56", r"$$p_\psi = L_3 = \text{const}$$", False),
        (
            "3.56",
            r"$$\dot p_\psi = 0$$ $$p_\psi = \lambda_3(\dot\psi + \dot\phi\cos\theta)$$",
            True,
        ),
        ("3.56", r"$$\dot L_3 = 0$$ $$L_3 = \lambda_3(\dot\psi + \dot\phi\cos\theta)$$", True),
        ("3.56", r"$$\lambda_3(\dot\psi + \dot\phi\cos\theta) = \text{const}$$", True),
    ],
)
def test_a_letter_that_is_constant_is_not_yet_the_goal(goal, source, arrives):
    found = mark(source, "3.53", goal)
    assert {line.mark for line in found.lines} == {Mark.FOLLOWS}
    assert found.arrives is arrives


UNDIVIDED = r"$$\sin\theta(\lambda_1\Omega^2\cos\theta - \lambda_3\omega_3\Omega + MgR) = 0$$"


def test_theta_is_not_the_sine_of_theta():
    found = mark(r"$$\theta \ne 0$$" + UNDIVIDED, "3.54", "3.57")
    assert found.lines[0].mark is Mark.ASSUMPTION
    assert not found.arrives
    source = ANSWERS["from-3.54-to-3.57"][2]
    assert mark(r"$$\theta \ne 0$$" + source, "3.54", "3.57").lost == ("sin θ = 0 is lost",)


@pytest.mark.parametrize(
    ("assumption", "found"),
    [
        (r"\sin\theta \ne 0", Mark.ASSUMPTION),
        (r"\Omega \ne 0", Mark.ASSUMPTION),
        (r"\lambda_1 \ne \lambda_3", Mark.ASSUMPTION),
        (r"\lambda_3^2\omega_3^2 - 4\lambda_1MgR\cos\theta \ne 0", Mark.ASSUMPTION),
        (r"p_\psi \ne \text{const}", Mark.WRONG),
        (r"\lambda_1\Omega^2\cos\theta - \lambda_3\omega_3\Omega + MgR \ne 0", Mark.WRONG),
    ],
)
def test_an_assumption_leaves_nearly_every_motion(assumption, found):
    marking = mark(f"$${assumption}$$", "3.54", "3.57")
    assert [line.mark for line in marking.lines] == [found]


def test_rounding_is_no_counterexample():
    found = mark(r"$$\dot{\mathbf L} = 0\,\mathbf L$$", "3.53", "3.54")
    assert found.lines[0].mark is Mark.WRONG
    assert "e−" not in found.lines[0].note


@pytest.mark.parametrize(
    "source",
    [
        "so $\\dot\\theta$, θ̈ = φ̇ with it",
        r"\lambda_1\ddot\theta = -MgR\sin\theta",
        "`λ₁θ̈ = MgR`",
        "```\nλ₁θ̈ = 0\n```",
    ],
)
def test_mathematics_outside_of_dollars_is_no_pass(source):
    start, goal, right = ANSWERS["from-3.54-to-3.57"]
    assert mark(right, start, goal).passed
    found = mark(f"{source}\n\n{right}", start, goal)
    assert (found.lines[0].line, found.lines[0].mark) in ((1, Mark.UNREAD), (1, Mark.WRONG))
    assert not found.passed


# --- Text from strangers ------------------------------------------------------------------------

BOMBS = [
    "$$" + "(" * 5000 + "1" + ")" * 5000 + " = 1$$",
    "$$" + "{" * 5000 + "1" + "}" * 5000 + " = 1$$",
    r"$$9^{9^{9^{9^{9}}}} = 1$$",
    r"$$(\dot\theta + \dot\phi)^{99999} = 0$$",
    "$$" + r"((\theta + \phi + 1)^{12})^{12}" * 3 + " = 1$$",
    "$$" + r"(\theta + \phi + \psi + \dot\theta + \dot\phi + \dot\psi)^{12}" * 12 + " = 0$$",
    "$$" + "+".join(["1"] * 9000) + " = 1$$",
    "$$" + "9" * 15000 + " = 1$$",
    "$$" + r"\sin(" * 40 + r"\theta" + ")" * 40 + " = 0$$",
    "$$" + r"\frac{1}{" * 50 + r"\theta" + "}" * 50 + " = 0$$",
    r"$$__import__('os').system('true') = 1$$",
    "$$\x00 = \ud7ff$$",
]


@pytest.mark.parametrize("bomb", BOMBS, ids=range(len(BOMBS)))
def test_a_bomb_is_no_pass_and_takes_no_time(bomb):
    found = mark_task(bomb, task("3.53", "3.54"), a_line=1, altogether=10)
    assert not found.passed
    assert all(line.mark is not Mark.FOLLOWS for line in found.lines)


def test_a_line_that_takes_too_long_is_inconclusive(monkeypatch):
    judged = Judge.judged

    def slow(judge, statement, *others):
        end = time.process_time() + 60 * (statement.sides[0] == n.Letter("V"))
        while time.process_time() < end:
            pass
        return judged(judge, statement, *others)

    monkeypatch.setattr(Judge, "judged", slow)
    found = mark_task(r"$$2T = T + T$$ $$V = V$$ $$E = T + V$$", task("3.53", "3.54"), a_line=0.5)
    marks = [line.mark for line in found.lines]
    assert marks == [Mark.FOLLOWS, Mark.INCONCLUSIVE, Mark.FOLLOWS]
    assert found.lines[1].note == "judging it takes longer than 0.5 s"


def test_what_breaks_is_said_to_be_ours(monkeypatch):
    def breaks(*_):
        raise ZeroDivisionError("of ours")

    asked = task("3.53", "3.54")
    monkeypatch.setattr(Judge, "judged", breaks)
    found = mark_task("$$E = T + V$$", asked)
    assert "rigidtop itself fails here" in found.lines[0].note
    assert not found.passed


def test_too_much_is_refused():
    with pytest.raises(RigidtopError, match="no more than 200000 characters"):
        mark("x" * 200_001, "3.53", "3.54")
    many = mark("$$1 = 1$$\n" * 310, "3.53", "3.54")
    assert len(many.lines) == 301
    assert many.lines[-1].note == "more than 300 lines"


def test_what_follows_from_a_wrong_line_is_told_from_what_does_not():
    wrong = r"$$L_3 = \lambda_3\dot\psi$$" + "\n\n"
    found = mark(wrong + r"$$2L_3 = 2\lambda_3\dot\psi$$", "3.53", "3.56").lines[1]
    assert (found.mark, found.note) == (Mark.CARRIED, "follows from line 1, which does not")
    found = mark(wrong + r"$$2L_3 = 3\lambda_3\dot\psi$$", "3.53", "3.56").lines[1]
    assert found.mark is Mark.CARRIED
    assert found.note.startswith("does not hold either, behind a wrong line: ")
