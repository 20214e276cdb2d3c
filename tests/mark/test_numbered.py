"""Numbered equations of notes: as they are, and with one thing changed in one equation."""

import re
from pathlib import Path

import pytest
import sympy
from sympy import Symbol, cos, sin

from rigidtop.derivations import PAGES
from rigidtop.derivations.letters import LETTERS
from rigidtop.judge.outcome import UNREAD
from rigidtop.judge.text import judged
from rigidtop.mark.numbered import UNKNOWN, Numbers, copies
from rigidtop.mark.task import Subject, top
from rigidtop.notation import NOTES
from rigidtop.proof.equation import Equation
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.page import Check, Claim, Correction, Definition, Page, claim
from rigidtop.read.document import numbered
from rigidtop.theory.symbols import (
    Omega,
    T,
    omega_vec,
    phidot,
    theta,
)

SOURCE = Path(__file__).with_name("notes.md").read_text("utf-8")
NUMBERS = [group.number for group in numbered(SOURCE)]


OURS = Numbers(PAGES, top(), LETTERS)


def audit(source, numbers=OURS):
    """What a text has under its numbers."""
    return copies(judged(source), source, numbers)


@pytest.fixture(scope="module")
def unchanged():
    return {each.number: each for each in audit(SOURCE)}


def one(formula, number, numbers=OURS):
    """The audit of a file with one equation."""
    (found,) = audit(f"$${formula}$$\n({number})\n", numbers)
    return found


# --- as they are ---------------------------------------------------------------------------------


def test_every_numbered_equation_is_read(unchanged):
    assert [*unchanged] == NUMBERS == [f"3.{n}" for n in range(33, 58)]
    for each in unchanged.values():
        assert all(line.outcome.verdict != UNREAD for line in each.lines)


# --- one thing changed ---------------------------------------------------------------------------


# Whether a change changes anything, found without the claims: by numbers.


def vector(rng):
    return sympy.Matrix([rng.uniform(0.5, 2) for _ in range(3)])


# --- what else can stand there -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("number", "formula", "verdict", "said"),
    [
        ("3.99", "T = T", UNKNOWN, "no claim of this number"),
        ("3.44", r"T = \qux", UNREAD, r"the command \qux is not known"),
        ("3.38", r"\boldsymbol{\omega} = [\omega_0, 0, \omega_3]", "false", "at ω₀ = "),
        ("3.40", r"\Omega_b = \omega_3 \lambda_2", "false", "the left side is 0.1408"),
        (
            "3.33",
            r"\dot{\mathbf L} = \mathbf{e}_1",
            "undecided",
            "the claim does not say what e₁ is",
        ),
        ("3.41", r"\boldsymbol{\omega} = \mathbf{L}", "false", "the left side is −0.7644"),
        ("3.40", r"\Omega_b \approx \omega_3", "undecided", "nearly true"),
        ("3.55", r"p_\phi = \lambda_3", "false", "the left side is"),
        # ψ̇ is in the claim and ψ is not: the angle may have any value.
        ("3.56", r"p_\psi = \lambda_3(\psi + \dot\phi\cos\theta)", "false", "a dot on ψ"),
    ],
)
def test_what_does_not_pass_says_why(number, formula, verdict, said):
    found = one(formula, number)
    assert (found.verdict, found.passed) == (verdict, False)
    assert said in found.note


@pytest.mark.parametrize(
    ("number", "formula"),
    [
        ("3.44", r"T = \mathbf{L}"),
        ("3.46", r"\mathbf{r}' = O^T"),
        ("3.41", r"\boldsymbol{\omega} = \mathbf{L}^2"),
    ],
)
def test_what_is_no_equation_at_all_is_refused_in_words(number, formula):
    found = one(formula, number)
    assert (found.verdict, found.passed) in (("false", False), (UNREAD, False))
    assert "vector" in found.note


@pytest.mark.parametrize(
    ("number", "formula", "verdict"),
    [
        ("3.45", r"\lambda_1\dot\phi\sin^2\theta = L_z - L_3\cos\theta", "assuming"),
        ("3.44", r"2T = \lambda_1\dot\phi^2 - \lambda_1\dot\phi^2\cos^2\theta"
         r" + \lambda_1\dot\theta^2 + \lambda_3(\dot\psi + \dot\phi\cos\theta)^2", "sampled"),
        ("3.36", r"\dot\omega_2 = \frac{\lambda_3 - \lambda_1}{\lambda_2}\omega_3\omega_1",
         "sampled"),
        ("3.57", r"MgR = \lambda_3\omega_3\Omega - \lambda_1\cos\theta\,\Omega^2", "assuming"),
        ("3.56", r"\lambda_3(\dot\psi + \dot\phi\cos\theta) = p_\psi = \text{const}", "sampled"),
        ("3.54", r"\lambda_2\ddot\theta = \lambda_1\dot\phi^2\sin\theta\cos\theta"
         r" - \lambda_3(\dot\psi + \dot\phi\cos\theta)\dot\phi\sin\theta + MgR\sin\theta",
         "proved"),
    ],
)  # fmt: skip
def test_another_way_to_write_it_is_upheld(number, formula, verdict):
    found = one(formula, number)
    assert (found.verdict, found.passed) == (verdict, True), found.note


@pytest.mark.parametrize("number", [n for n in NUMBERS if n != "3.38"])
def test_nothing_is_not_the_equation_of_a_number(number):
    found = one("0 = 0", number)
    assert (found.verdict, found.passed) == ("undecided", False)


@pytest.mark.parametrize(
    ("number", "formula"),
    [
        # True whatever the symbols mean, true of other things, true of one component only, …
        ("3.41", r"\boldsymbol\omega = \boldsymbol\omega"),
        ("3.52", r"\hat{\mathbf z}\cdot\hat{\mathbf z} = 1"),
        ("3.45", r"\sin^2\theta + \cos^2\theta = 1"),
        ("3.40", r"\Omega_b = \Omega_b"),
        ("3.41", r"\hat{\mathbf z}\cdot\boldsymbol\omega = \dot\phi + \dot\psi\cos\theta"),
        ("3.51", r"\dot{\mathbf e}_3 = \mathbf\Omega\times\mathbf e_3"),
        ("3.56", r"p_\psi = \lambda_3(\dot\psi + \dot\phi\cos\theta)"),
        ("3.56", r"p_\psi = \text{const}"),
    ],
)
def test_what_says_less_is_not_the_equation_of_a_number(number, formula):
    found = one(formula, number)
    assert (found.verdict, found.passed) == ("undecided", False)
    said = (
        "it says less than the equation of that number",
        "it says nothing",
        "it is true, and not",
    )
    assert found.note.startswith(said)
    assert found.right


def test_lines_say_together_what_the_claim_says():
    first = r"\lambda_1\dot\omega_1 = (\lambda_2 - \lambda_3)\omega_2\omega_3"
    second = r"\lambda_2\dot\omega_2 = (\lambda_3 - \lambda_1)\omega_3\omega_1"
    third = r"\lambda_3\dot\omega_3 = (\lambda_1 - \lambda_2)\omega_1\omega_2"
    in_any_order = rf"{third} \\ {first} \\ {second}"
    assert one(in_any_order, "3.36").verdict == "proved"
    with_nothing = one(rf"{first} \\ 0 = 0 \\ {third}", "3.36")
    verdicts = [each.outcome.verdict for each in with_nothing.lines]
    assert verdicts == ["proved", "undecided", "proved"]
    more = one(rf"{in_any_order} \\ \omega_1 = \omega_1", "3.36")
    assert (more.verdict, more.passed) == ("undecided", False)
    assert "it says nothing" in more.note
    split = (
        r"\dot{\mathbf e}_3 = \frac{MgR}{\lambda_3\omega_3}\hat{\mathbf z}\times\mathbf e_3"
        r" \\ \dot{\mathbf e}_3 = \mathbf\Omega\times\mathbf e_3"
    )
    assert one(split, "3.51").passed


def test_a_rate_is_told_that_is_visibly_not_0():
    found = one(r"\lambda_3\dot\psi = \text{const}", "3.56")
    assert re.search(r"the left side is −?0\.[1-9]\d*, the right side 0", found.note)


def test_the_corrected_matrix_is_right():
    (group,) = [group for group in numbered(SOURCE) if group.number == "3.47"]
    text = group.formulas[0].text
    found = one(text.replace("O^{T}", "O"), "3.47")
    assert (found.verdict, found.passed) == ("sampled", True)


def test_a_slip_in_what_is_at_odds_with_a_definition_is_refuted_where_it_is():
    (group,) = [group for group in numbered(SOURCE) if group.number == "3.47"]
    text = group.formulas[0].text
    found = one(text.replace(r"-c_{\psi}s_{\theta}", r"c_{\psi}s_{\theta}"), "3.47")
    assert (found.verdict, found.passed) == ("false", False)
    assert re.match(r"at c_φ = .*: the left side is −?\d", found.note)


def test_lines_that_are_left_out_or_added_are_said():
    found = one(r"\lambda_3\dot\omega_3 = (\lambda_1 - \lambda_2)\omega_1\omega_2", "3.36")
    assert (found.verdict, found.passed) == ("proved", True)
    assert found.note == (
        "not among the file's lines: λ₁ ω̇₁ = (λ₂ − λ₃) ω₂ ω₃, λ₂ ω̇₂ = (λ₃ − λ₁) ω₃ ω₁"
    )
    true, false = (rf"\Omega_b = {sign}(\lambda_1 - \lambda_3)\omega_3/\lambda_1" for sign in "+-")
    first = r"\Omega_b = \frac{(\lambda_1 - \lambda_3)\omega_3}{\lambda_1}, \tau_b = 2\pi/\Omega_b"
    assert one(rf"{first}, {true}", "3.40").verdict == "assuming"
    more = one(rf"{first}, {false}", "3.40")
    assert (more.verdict, more.passed) == ("false", False)


def test_what_stands_under_a_brace_is_judged():
    brace = r"p_\psi = \lambda_3 \underbrace{(\dot\psi + \dot\phi\cos\theta)}_{= %s} = const"
    assert one(brace % r"\dot\phi\cos\theta + \dot\psi", "3.56").verdict == "sampled"
    assert one(brace % r"\dot\phi\cos\theta - \dot\psi", "3.56").verdict == "false"
    assert one(brace % r"\omega_3", "3.56").verdict == "sampled"
    assert one(brace % r"\omega_1", "3.56").verdict == "false"


# --- a lecturer's own collection -----------------------------------------------------------------


def collection(*claims):
    pages = Page("9", "Own", "A page of one's own.", claims)
    return Numbers([pages], Subject(Lecture(), (), NOTES), LETTERS)


def own(*evidence):
    """A collection of one claim, (9.1)."""

    @claim("9.1", "A claim of one's own.")
    def made():
        """As it is."""
        yield from evidence

    return collection(made)


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        (r"\Omega = \dot\phi\sin\theta", "definition"),
        (r"\dot\phi\sin\theta \equiv \Omega", "definition"),
        (r"\Omega = \dot\phi\cos\theta", "false"),
        (r"\Omega = -\dot\phi\sin\theta", "false"),
        (r"\Omega_b = \dot\phi\sin\theta", "undecided"),
    ],
)
def test_a_definition_must_say_the_same(formula, verdict):
    pages = own(Definition(Equation(Omega, phidot * sin(theta))))
    found = one(formula, "9.1", pages)
    assert (found.verdict, found.passed) == (verdict, verdict == "definition")


def test_a_definition_of_a_vector():
    pages = own(Definition(Equation(omega_vec, Omega * Symbol("zhat", real=True))))
    assert one(r"\boldsymbol\omega = \Omega\hat{\mathbf z}", "9.1", pages).passed
    assert one(r"\boldsymbol\omega = -\Omega\hat{\mathbf z}", "9.1", pages).verdict == "false"


def test_what_the_collection_knows_to_be_false_is_no_failure():
    wrong = Check(Equation(T, cos(theta)), {T: sin(theta)})
    pages = own(wrong, Correction(Equation(T, sin(theta)), {T: sin(theta)}))
    found = one(r"T = \cos\theta", "9.1", pages)
    assert (found.verdict, found.passed) == ("false", True)
    assert one(r"T = \sin\theta", "9.1", pages).verdict == "sampled"


def test_a_claim_that_breaks_lets_nothing_pass():
    def broken():
        yield Check(Equation(T, T))
        raise RuntimeError("no")

    pages = collection(Claim("9.1", "", broken))
    found = one("T = T", "9.1", pages)
    assert (found.verdict, found.passed) == ("undecided", False)
    assert "RuntimeError: no" in found.note
