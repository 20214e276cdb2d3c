"""Numbers refute what is wrong, and nothing that follows."""

import pytest
from sympy import cos, sin, sqrt

from rigidtop.derivations import lecture
from rigidtop.derivations.letters import LETTERS
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.changed import perturbations
from rigidtop.proof.derivation import Line, arrive, survivors
from rigidtop.proof.equation import Cross, Equation, as_printed
from rigidtop.proof.moves import Known, Move, Pair, RefusedError, perform
from rigidtop.proof.numbers import Numbers
from rigidtop.theory import symbols as s


def refuted(equation, *pairs):
    return Numbers(Algebra(LETTERS), [Pair(*map(Algebra(LETTERS).value, p)) for p in pairs]).refute(
        equation
    )


@pytest.mark.parametrize(
    ("sides", "made", "wrong"),
    [
        ((s.a, 2 * s.b), (s.a, 2 * s.b), False),
        ((3 * s.a, 6 * s.b), (s.a, 2 * s.b), False),
        ((s.a, 3 * s.b), (s.a, 2 * s.b), True),
        ((s.a**2, 4 * s.b**2), (s.a, 2 * s.b), True),
        ((sin(s.theta) ** 2, s.b), (1 - cos(s.theta) ** 2, s.b), False),
        ((sin(s.theta), s.b), (cos(s.theta), s.b), True),
        ((Cross(s.e1, s.e2), s.L_vec), (s.e3, s.L_vec), False),
        ((Cross(s.e2, s.e1), s.L_vec), (s.e3, s.L_vec), True),
        # What is an identity, real nowhere, or no scalar, is left to the normal forms.
        ((s.a, s.a), (s.a, s.b), False),
        ((sqrt(-(s.b**2)), s.b), (s.a, s.b), False),
        ((s.O_matrix, s.unit), (s.a, s.b), False),
    ],
)
def test_what_numbers_tell(sides, made, wrong):
    with as_printed():
        equation = Equation(*sides)
    assert refuted(equation, made) is wrong


def test_a_sum_of_numbers_far_apart_is_not_refuted_by_rounding():
    large = 10**9 * s.a
    with as_printed():
        equation = Equation(large + s.b - large, s.b + s.a)
    assert not refuted(equation, (s.b, s.b + s.a))


@pytest.mark.parametrize("id", ["3.54", "3.44", "3.35", "3.43"])
def test_numbers_refute_nothing_that_follows(id):
    """And nearly all that does not, else they would be of no use."""
    line = lecture().judged(id).line
    performed = perform(line.move, LETTERS)
    numbers = Numbers(Algebra(LETTERS, performed.given), performed.pairs)
    told = wrong = 0
    for equation in line.equations:
        assert not numbers.refute(equation)
        for change in perturbations(equation, LETTERS.families):
            found = numbers.refute(change.equation)
            try:
                arrive([change.equation], line.move, LETTERS, performed)
                assert not found, change.change
            except RefusedError:
                wrong, told = wrong + 1, told + found
    assert told > 0.8 * wrong > 0


def test_a_change_that_stands_is_seen_and_what_says_the_same_is_none():
    with as_printed():
        cited, equal = Equation(s.a, 2 * s.omega1), Equation(s.omega1, s.omega2)
        said = Equation(s.a, 2 * s.omega2 * cos(-s.theta) / cos(s.theta))
    move = Move("put", of=(Known("one", (cited,)),), using=(Known("two", (equal,)),))
    tried, stood = survivors(Line("three", (said,), "", move=move), LETTERS)
    assert stood == ("omega1 for omega2",)
    changes = len(perturbations(said, LETTERS.families))
    assert 5 < tried < changes + 2  # two other moves besides
