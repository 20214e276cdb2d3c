"""The sentences of the blackboard: what each says is one move, however it is put."""

from dataclasses import replace

import pytest

from rigidtop.derivations import FORMERLY, lecture
from rigidtop.notation import NOTES
from rigidtop.proof.moves import Known
from rigidtop.read.equations import equations
from rigidtop.read.page import read_beside
from rigidtop.read.sentence import Antecedents, SentenceError, definition, move


def known(latex, called=""):
    [line] = equations(latex, NOTES)
    return Known(latex, (line.equation,), called=called)


LINES = (
    known(r"\mathbf L = I\boldsymbol\omega \tag{3.26}"),
    known(r"V = MgR\cos\theta", called="the potential"),
    known(r"T = \tfrac12\lambda_1\dot\theta^2 \tag{3.44}"),
    known(r"p_\phi = \lambda_1\dot\phi"),
    known(r"\dot p_\phi = 0"),
)
CONTEXT = Antecedents(LINES, NOTES, LINES, LINES)


@pytest.mark.parametrize(
    ("said", "plainly"),
    [
        ("Substitute (3.44) and $V$ into (3.26)", "Put (3.44) and the potential into (3.26)"),
        ("Substitute $p_\\phi$", "Put $p_\\phi$ into it"),
        ("Substitute into (3.44)", "Put it into (3.44)"),
        ("Substitute the $p_\\phi$ and the $V$ into (3.26)", "Put $p_\\phi$ and $V$ into (3.26)"),
        (r"Differentiate the $V$ by the $\theta$", r"Differentiate $V$ by $\theta$"),
        ("Using the $V$, rewrite (3.44)", "Rewrite (3.44), with $V$"),
        ("The $p_\\phi$ is conserved", "Integrate it, with $p_\\phi$"),
        (
            r"Take the component of the $\mathbf L$ along the $\mathbf e_1$",
            r"Take the component of $\mathbf L$ along $\mathbf e_1$",
        ),
        ("Insert $V$ into (3.44)", "Put $V$ into (3.44)"),
        (
            r"Differentiate (3.44) with respect to $\dot\theta$",
            r"Differentiate (3.44) by $\dot\theta$",
        ),
        (r"Differentiate with respect to $\theta$", r"Differentiate it by $\theta$"),
        ("Differentiate (3.26) in time", "Take the rate of (3.26)"),
        ("Differentiate both sides in time", "Take the rate of it"),
        ("Differentiate (3.26) in time in the body frame", "Take the rate of (3.26) in the body"),
        ("Differentiate in time in the space frame", "Take the rate of it in space"),
        ("Using (3.44), differentiate $V$ in time", "Take the rate of $V$, with (3.44)"),
        ("Differentiate $V$ in time, using (3.44)", "Take the rate of $V$, with (3.44)"),
        ("Hence $p_\\phi$ is conserved", "Integrate it, with $p_\\phi$"),
        ("By $\\dot p_\\phi$, $p_\\phi$ is conserved", "Integrate it, with $p_\\phi$"),
        (r"Project (3.26) on $\mathbf e_1$", r"Take the component of (3.26) along $\mathbf e_1$"),
        (
            r"Both sides of (3.26) agree only if their components along $\mathbf e_1$ and "
            r"$\mathbf e_2$ do",
            r"Resolve (3.26) along $\mathbf e_1$ and $\mathbf e_2$",
        ),
        (r"Take the scalar product of (3.26) with $\mathbf e_3$", r"Dot (3.26) with $\mathbf e_3$"),
        (r"Take the scalar product with $\mathbf e_3$", r"Dot it with $\mathbf e_3$"),
        (
            r"Take the vector product of $\mathbf e_3$ with (3.26)",
            r"Cross $\mathbf e_3$ with (3.26)",
        ),
        ("Take the scalar product of (3.26) with itself", "Dot (3.26) with itself"),
        ("Add $V$", "Add $V$ to it"),
        ("Subtract $2$ times (3.44)", "Subtract $2$ times (3.44) from it"),
        ("Multiply both sides of (3.44) by $2$", "Multiply (3.44) by $2$"),
        (r"Divide by $\sin\theta \neq 0$", r"Divide it by $\sin\theta$"),
        (r"Divide (3.44) by $\sin\theta ≠ 0$", r"Divide (3.44) by $\sin\theta$"),
        ("Cancel $\\mathbf u$", "Strip $\\mathbf u$ from it"),
        (
            r"Solve (3.26) for $\omega_1$, eliminating $\omega_2$",
            r"Solve (3.26) for $\omega_1$, without $\omega_2$",
        ),
        ("Take the square root, for $L > 0$", "Take the root of it, for $L > 0$"),
        ("Determine the sign of (3.44), for $L > 0$", "Take the sign of (3.44), for $L > 0$"),
        ("Hence (3.44) does not vanish, for $L > 0$", "Ask whether (3.44) vanishes, for $L > 0$"),
        ("It does not vanish, for $L > 0$", "Ask whether it vanishes, for $L > 0$"),
        (
            r"For a fast top (large $\omega_3$), drop $MgR$ in (3.44), using $V$",
            r"Neglect $MgR$ in (3.44), for large $\omega_3$, with $V$",
        ),
        (
            r"For a fast top, expand to first order in $\varepsilon$",
            r"Expand it to first order in $\varepsilon$",
        ),
        ("Let $\\dot\\theta = 0$ at all times", "Set $\\dot\\theta = 0$ at all times in it"),
        ("Set $g = 0$", "Set $g = 0$ in it"),
        ("For $L > 0$, using $V$, square (3.44)", "Square (3.44), with $V$, for $L > 0$"),
    ],
)
def test_a_sentence_says_the_same_move_as_a_plain_one(said, plainly):
    one, other = (
        replace(move(f"{words}:", CONTEXT), words="", unnamed=False) for words in (said, plainly)
    )
    assert one == other


@pytest.mark.parametrize(
    ("said", "name", "cited"),
    [
        ("Define the small parameter", "the small parameter", ()),
        ("Call the amplitude, with (3.44)", "the amplitude", LINES[2:3]),
        ("Using (3.44), define the amplitude", "the amplitude", LINES[2:3]),
    ],
)
def test_a_definition_gives_a_name(said, name, cited):
    assert definition(said, CONTEXT) == (name, cited)


@pytest.mark.parametrize(
    ("said", "why"),
    [
        ("Ponder (3.44)", "no move begins with 'Ponder'"),
        ("Differentiate (3.44) sideways", "Differentiate A with respect to"),
        ("Put (3.44)", "Substitute A into B"),
        ("Using the moon, square (3.44)", "nothing above is called 'the moon'"),
    ],
)
def test_another_sentence_says_how_it_is_written(said, why):
    with pytest.raises(SentenceError, match=why):
        move(said, CONTEXT)


def test_a_definition_has_no_condition():
    with pytest.raises(SentenceError, match="has no condition"):
        definition("For $L > 0$, define the amplitude", CONTEXT)


@pytest.mark.parametrize(("former", "now"), FORMERLY)
def test_another_page_may_cite_a_line_by_its_former_name(former, now):
    page = f"Rewrite {former}:\n\n$$\\theta = \\theta$$\n"
    read = read_beside("mine.md", page, lecture(), NOTES).texts[-1]
    [cited] = read.lines[0].move.of
    assert lecture().lines[cited.id].called == now
