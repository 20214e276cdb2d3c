"""What stands in another book is read with its letters, taken into the notes', and judged."""

from dataclasses import replace

import pytest
from sympy import expand

from rigidtop.derivations.lagrange_formalism import page
from rigidtop.notation import BUILT_IN, GOLDSTEIN, NOTES, named
from rigidtop.proof.equation import value
from rigidtop.proof.page import Check
from rigidtop.proof.verdict import Verdict, judge_check
from rigidtop.read.equations import equations as read
from rigidtop.theory import symbols as s
from rigidtop.theory.rotation import euler_omega
from rigidtop.typeset.latex import latex
from rigidtop.typeset.text import text

CLAIMS = {claim.name: claim for claim in page.claims}


def one(tex, notation):
    """The one equation of a formula, in the symbols of the notes."""
    [line] = read(tex, notation)
    assert line.problem == ""
    return notation.read(line.equation)


def check_of(name):
    return next(e for e in CLAIMS[name].evidence() if isinstance(e, Check) and e.printed)


HEAVY_TOP = {
    "goldstein": r"I_1\ddot\theta = I_1\dot\phi^2\sin\theta\cos\theta"
    r" - I_3(\dot\psi + \dot\phi\cos\theta)\dot\phi\sin\theta + Mgl\sin\theta",
    "landau": r"I_1\ddot\theta = I_1\dot\phi^2\sin\theta\cos\theta"
    r" - I_3(\dot\psi + \dot\phi\cos\theta)\dot\phi\sin\theta + \mu gl\sin\theta",
    "morin": r"I_1\ddot\theta = I_1\dot\phi^2\sin\theta\cos\theta"
    r" - I_3(\dot\psi + \dot\phi\cos\theta)\dot\phi\sin\theta + Mgl\sin\theta",
}


@pytest.mark.parametrize("name", HEAVY_TOP)
def test_the_equation_of_the_heavy_top(name):
    equation = one(HEAVY_TOP[name], named(name))
    check = check_of("3.54")
    assert text(equation, "typed") == text(check.claimed, "typed")
    assert judge_check(replace(check, claimed=equation)).verdict is Verdict.PROVED


def test_a_slip_in_it_falls():
    wrong = one(HEAVY_TOP["goldstein"].replace("+ Mgl", "- Mgl"), GOLDSTEIN)
    assert judge_check(replace(check_of("3.54"), claimed=wrong)).verdict is Verdict.FALSE


COMPONENT = r"\omega_1 = \dot\phi\sin\theta\sin\psi + \dot\theta\cos\psi"  # Goldstein (4.87)


def test_angles_of_the_book_are_not_those_of_the_notes():
    meaning = {s.omega1: euler_omega("body")[0]}
    assert judge_check(Check(one(COMPONENT, GOLDSTEIN), meaning)).verdict is Verdict.PROVED
    assert judge_check(Check(one(COMPONENT, NOTES), meaning)).verdict is Verdict.FALSE


def test_a_letter_of_another_book_is_not_understood():
    [line] = read(r"\lambda_1\ddot\theta = Mgl\sin\theta", GOLDSTEIN)
    assert line.equation is None
    assert "λ" in line.problem


@pytest.mark.parametrize("name", [name for name in BUILT_IN if name != "morin"])  # \ell
@pytest.mark.parametrize("number", ["3.53", "3.54", "3.55", "3.56", "3.57"])
def test_what_is_printed_in_a_notation_reads_back(number, name):
    notation = named(name)
    for check in CLAIMS[number].evidence():
        if not isinstance(check, Check):
            continue
        equation = replace_tag(check.claimed)
        again = one(latex(notation.written(equation), "printed"), notation)
        for old, new in zip(equation.sides, again.sides, strict=True):
            assert expand(value(old, {})) == expand(value(new, {}))


def replace_tag(equation):
    return type(equation)(*equation.sides, relation=equation.relation)
