"""Each verdict reached by a small claim, and each way in which a claim does not pass."""

import math

import numpy as np
import pytest
import sympy
from sympy import Eq, Gt, Lt, Matrix, Ne, Symbol, cos, sin, sqrt, symbols

from rigidtop.proof import floats, page
from rigidtop.proof.counterexample import assertions, refute
from rigidtop.proof.equation import Cross, Dot, Equation, Underbrace, as_printed
from rigidtop.proof.page import (
    Assumption,
    Check,
    Correction,
    Definition,
    Measure,
    Step,
)
from rigidtop.proof.verdict import UnneededAssumptionError, Verdict, judge, judge_check
from rigidtop.theory.symbols import const

x, y, z = symbols("x y z", real=True)
a, b = symbols("a b", positive=True)
v, w = symbols("v w")


def claim(*evidence, error=None):
    def run():
        yield from evidence
        if error is not None:
            raise error

    run.__doc__ = "Since it\n    is so."
    return page.claim("made-up", "It is so.")(run)


def typed(left, right, relation="="):
    return Equation(left, right, relation=relation)


def square():
    with as_printed():
        return Check(Equation(y, x**2 - 1), {y: (x - 1) * (x + 1)})


WRONG = Check(typed(y, x), {y: 2 * x})
TAUTOLOGY = Check(typed(x, x))


# --- the verdicts ------------------------------------------------------------------------------


def test_proved():
    judged = judge(claim(square()), "9.9")
    assert (judged.verdict, judged.passed, judged.section) == (Verdict.PROVED, True, "9.9")


def test_definition():
    judged = judge(claim(Definition(typed(x, y))))
    assert (judged.verdict, judged.passed) == (Verdict.DEFINITION, True)


def test_a_definition_beside_a_check_counts_for_nothing():
    assert judge(claim(Definition(typed(x, y)), square())).verdict is Verdict.PROVED
    assert judge(claim(Definition(typed(x, y)), WRONG)).verdict is Verdict.FALSE


def test_assuming_names_the_assumption_and_a_counterexample():
    needed = Assumption(Ne(x, 0), "x is not zero")
    judged = judge(claim(Check(typed(x**2, 0, ">"), {}, (needed,))))
    assert (judged.verdict, judged.passed) == (Verdict.ASSUMING, True)
    [finding] = judged.findings()
    [tested] = finding.assumptions
    assert tested.assumption is needed
    assert dict(tested.without.values) == {x: 0}
    assert (tested.without.left, tested.without.right) == (0, 0)


def test_proved_under_what_the_notes_state():
    stated = Assumption(Ne(x, 0), "x is not zero", stated=True)
    [finding] = judge(claim(Check(typed(x**2, 0, ">"), {}, (stated,)))).findings()
    assert finding.verdict is Verdict.PROVED
    assert len(finding.assumptions) == 1


def test_convention():
    check = Check(typed(y, x), {y: -x}, other_reading={y: x})
    judged = judge(claim(check, Correction(typed(y, -x), {y: -x})))
    assert (judged.verdict, judged.passed) == (Verdict.CONVENTION, True)
    assert judged.findings()[0].counterexample.values[x] != 0


def test_no_convention_where_the_other_reading_fails_too():
    assert judge_check(Check(typed(y, x), {y: -x}, other_reading={y: 3 * x})).verdict == "false"


def test_false_shows_numbers():
    finding = judge_check(WRONG)
    found = finding.counterexample
    assert finding.verdict is Verdict.FALSE
    assert found.left == 2 * found.values[x] != found.right == found.values[x]


def test_false_with_a_correction_passes():
    judged = judge(claim(WRONG, Correction(typed(y, 2 * x), {y: 2 * x})))
    assert (judged.verdict, judged.passed) == (Verdict.FALSE, True)


def test_undecided():
    # Its normal form says no, and no number of forty digits shows it.
    hidden = Check(typed(y, x), {y: (1 + sympy.Rational(1, 10**60)) * x})
    judged = judge(claim(hidden))
    assert (judged.verdict, judged.passed) == (Verdict.UNDECIDED, False)
    assert judged.problem == "neither shown nor refuted"


def test_sampled_only_by_what_is_not_shown():
    identity = Check(typed(y, sympy.log(a) + sympy.log(b)), {y: sympy.log(a * b)})
    assert judge_check(identity).verdict is Verdict.PROVED
    nested = sqrt(a + b + 2 * sqrt(a * b))
    sampled = judge(claim(Check(typed(y, sqrt(a) + sqrt(b)), {y: nested})))
    assert (sampled.verdict, sampled.passed) == (Verdict.SAMPLED, True)
    assert judge_check(square()).verdict is Verdict.PROVED


@pytest.mark.parametrize(
    ("typed", "meant", "verdict"),
    [
        ("u*((10**7 + x)**2 - 10**14 - 2*10**7*x)", "u*x**2", "proved"),
        ("u*((10**7 + x)**2 - 10**14 - 2*10**7*x)", "2*u*x**2", "false"),
        ("105**2*x**2/10**72", "105**2*x**2/(2*10**72)", "false"),
        ("x + 1/10**45", "x", "false"),
        ("x + 2", "x + 2", "proved"),
    ],
)
def test_large_and_tiny_numbers_are_compared_by_their_digits(typed, meant, verdict):
    y, names = Symbol("y", real=True), {"x": Symbol("x", real=True), "u": Symbol("u", real=True)}
    with as_printed():
        claimed = Equation(y, sympy.parse_expr(typed, local_dict=names, evaluate=False))
    found = judge_check(Check(claimed, {y: sympy.sympify(meant, locals=names)}))
    assert found.verdict == verdict
    if found.counterexample is not None:
        assert found.counterexample.left != found.counterexample.right


def test_the_last_verdict_of_its_checks_is_the_claims():
    assert judge(claim(square(), WRONG, square())).verdict is Verdict.FALSE
    unstated = Check(typed(x**2, 0, ">"), {}, (Assumption(Ne(x, 0)),))
    assert judge(claim(unstated, square())).verdict is Verdict.ASSUMING


def test_a_correction_is_no_part_of_the_verdict():
    wrong_correction = Correction(WRONG.claimed, WRONG.meaning)
    judged = judge(claim(square(), wrong_correction))
    assert judged.verdict is Verdict.PROVED
    assert not judged.passed


# --- what does not pass ------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("evidence", "problem"),
    [
        ((WRONG,), "it fails, and no corrected form stands beside it"),
        (
            (WRONG, Correction(typed(y, 3 * x), {y: 2 * x})),
            "the corrected form does not hold either",
        ),
        (
            (TAUTOLOGY, Correction(typed(x, x))),
            "a corrected form stands beside a claim that needs none",
        ),
        ((TAUTOLOGY, Measure("a rate", 2e-9, 1e-9)), "a rate: error 2.0e-09 exceeds 1.0e-09"),
        ((TAUTOLOGY, Measure("a rate", -5.0, 1e-6)), "a rate: error -5.0e+00 exceeds 1.0e-06"),
        ((TAUTOLOGY, Measure("a rate", -math.inf, 1.0)), "a rate: error -inf exceeds 1.0e+00"),
        ((TAUTOLOGY, Measure("a rate", math.nan, 1.0)), "a rate: error nan exceeds 1.0e+00"),
        ((Measure("a rate", 0.0, 1.0),), "neither shown nor refuted"),
        ((Step(typed(x, x), "so"),), "neither shown nor refuted"),
        ((), "neither shown nor refuted"),
    ],
)
def test_problems(evidence, problem):
    judged = judge(claim(*evidence))
    assert (judged.passed, judged.problem) == (False, problem)


@pytest.mark.parametrize("tolerance", [math.nan, math.inf, -1e-9])
def test_a_tolerance_is_a_number_from_zero_on(tolerance):
    with pytest.raises(ValueError, match=f"^a rate: a tolerance must be .*, not {tolerance}$"):
        Measure("a rate", 0.0, tolerance)
    assert Measure("a rate", -1e-9, 1e-9).passed


def test_a_claim_that_breaks_is_undecided():
    judged = judge(claim(square(), error=ZeroDivisionError("0/0")))
    assert (judged.verdict, judged.problem) == (Verdict.UNDECIDED, "ZeroDivisionError: 0/0")
    assert len(judged.items) == 1


def test_an_unneeded_assumption_is_an_error():
    idle = Assumption(Ne(x, 0))
    with pytest.raises(UnneededAssumptionError, match=r"Ne\(x, 0\) is not needed"):
        judge_check(Check(typed(y, 2 * x), {y: x + x}, (idle,)))
    judged = judge(claim(Check(typed(y, 2 * x), {y: x + x}, (idle,))))
    assert not judged.passed
    assert judged.problem.startswith("UnneededAssumptionError: Ne(x, 0) is not needed")


def test_one_of_two_assumptions_that_is_implied_by_the_other_is_an_error():
    both = (Assumption(Ne(x, 0)), Assumption(Gt(x, 0)))
    with pytest.raises(UnneededAssumptionError, match=r"Ne\(x, 0\) is not needed"):
        judge_check(Check(typed(x**2, 0, ">"), {}, both))


def test_a_relation_that_is_no_assertion():
    with pytest.raises(ValueError, match="can't judge the relation '≈'"):
        judge_check(Check(typed(x, x, "≈")))


def test_a_vector_is_no_number():
    with pytest.raises(TypeError, match="a vector can't equal a number other than 0"):
        judge_check(Check(typed(v, 1), {v: Matrix([1, 1, 1])}))


# --- divisions, limits, readings ---------------------------------------------------------------


def test_a_division_has_a_condition_and_loses_a_branch():
    divided = Check(
        typed(y, 1),
        {},
        (Assumption(Ne(sin(x), 0), "sin x is divided out"),),
        given=(sin(x) * (y - 1),),
    )
    finding = judge_check(divided)
    assert finding.verdict is Verdict.ASSUMING
    lost = finding.assumptions[0].without
    assert sympy.sin(lost.values[x]) == 0  # there the given equation holds
    assert lost.left == lost.values[y] != 1 == lost.right  # and the divided one does not


def test_without_its_condition_a_division_is_not_shown():
    assert judge_check(Check(typed(y, 1), {}, given=(sin(x) * (y - 1),))).verdict == "false"


def test_a_division_by_what_the_meaning_makes_zero():
    # x (a/x) is a wherever it is anything; as it is typed, it is nothing at x = 0.
    with as_printed():
        printed = Equation(y, z / x)
    finding = judge_check(Check(printed, {z: a * x, y: a}, (Assumption(Ne(x, 0)),)))
    lost = finding.assumptions[0].without
    assert finding.verdict is Verdict.ASSUMING
    assert (lost.values[x], lost.left, lost.right) == (0, lost.values[a], None)


def test_a_limit_is_refuted_with_numbers_that_go_together():
    epsilon = Symbol("epsilon", real=True)
    exact = (sqrt(1 + 4 * epsilon) - 1) / (2 * epsilon)  # → 1
    limit = Assumption(Eq(epsilon, 0), "b is large", otherwise=a / b**2)
    check = Check(typed(y, a), {y: a * 2 / (1 + sqrt(1 + 4 * epsilon))}, (limit,))
    [tested] = judge_check(check).assumptions
    at = {k.name: float(n) for k, n in tested.without.values.items()}
    assert set(at) == {"a", "b"}
    by_hand = at["a"] * float(exact.subs(epsilon, at["a"] / at["b"] ** 2))
    assert float(tested.without.left) == pytest.approx(by_hand)
    assert float(tested.without.right) == at["a"] != pytest.approx(by_hand)


def test_equalities_are_put_in_also_one_into_another():
    check = Check(typed(x + y + z, 3 * z), {}, (Assumption(Eq(x, y)), Assumption(Eq(y, z))))
    assert judge_check(check).verdict is Verdict.ASSUMING


def test_bars_are_taken_off_by_a_condition():
    below = Assumption(Lt(x, 0))
    assert judge_check(Check(typed(sympy.Abs(x), -x), {}, (below,))).verdict == "assuming"
    assert judge_check(Check(typed(sympy.Abs(x), -x))).verdict == "false"


def test_every_link_of_a_chain_counts():
    good = Equation(y, 2 * x, x + x)
    first, last = Equation(y, x, 2 * x), Equation(y, 2 * x, 3 * x)
    verdicts = [judge_check(Check(chain, {y: 2 * x})).verdict for chain in (good, first, last)]
    assert verdicts == ["proved", "false", "false"]


def test_every_entry_of_a_vector_counts():
    turned = {v: Matrix([cos(x), sin(x), 0]), w: Matrix([-sin(x), cos(x), 0])}
    for k in range(3):
        wrong = Matrix([0, 0, 1])
        wrong[k] += 1
        assert judge_check(Check(Equation(Cross(v, w), wrong), turned)).verdict == "false"
    assert judge_check(Check(Equation(Cross(v, w), Matrix([0, 0, 1])), turned)).verdict == "proved"
    assert judge_check(Check(Equation(Dot(v, w), 0), turned)).verdict == "proved"


def test_one_entry_that_differs_makes_vectors_unequal():
    check = Check(typed(v, Matrix([x, y, 0]), "≠"), {v: Matrix([x, y, 1])})
    assert judge_check(check).verdict is Verdict.PROVED
    assert judge_check(Check(typed(v, Matrix([x, y, 0]), "≠"), {v: Matrix([x, y, z])})).verdict == (
        "false"
    )


def test_constant_means_that_its_rate_vanishes():
    meaning = {const: lambda side: side.diff(x)}
    with as_printed():
        kept = Equation(sin(x) ** 2 + cos(x) ** 2, const)
        lost = Equation(sin(x) ** 2 - cos(x) ** 2, const)
    assert judge_check(Check(kept, meaning)).verdict == "proved"
    assert judge_check(Check(lost, meaning)).verdict == "false"
    assert assertions(kept, meaning) == [("=", 0, 0)]


def test_what_stands_under_a_brace_is_asserted():
    with as_printed():
        braced = Equation(y, Underbrace(2 * x, z) + 1)
    right, wrong = ({y: 2 * x + 1, z: k * x} for k in (2, 3))
    assert judge_check(Check(braced, right)).verdict == "proved"
    assert judge_check(Check(braced, wrong)).verdict == "false"
    assert judge_check(Check(braced, {y: 2 * x + 1})).verdict == "proved"


def test_a_counterexample_keeps_to_the_assumptions():
    within = (Assumption(Gt(x, 0)), Assumption(Eq(y, -x)))
    found = refute(Check(typed(x * y, 0, ">"), {}, within))
    assert found.values[x] > 0
    assert found.left == -(found.values[x] ** 2)


def test_a_counterexample_satisfies_what_is_given():
    found = refute(Check(typed(x, 1), {}, given=(x * y - 2,)))
    at = np.array([float(found.values.get(k, np.nan)) for k in (x, y)])
    assert found.left != 1
    assert np.isnan(at).any() or at.prod() == pytest.approx(2)


def test_the_reason_is_the_docstring():
    assert claim().reason == "Since it is so."


def test_a_typed_division_needs_its_condition():
    """Without the condition nothing is proved, though the division cancels for the engine."""
    from rigidtop.theory import symbols as s

    with as_printed():
        divided = Equation(s.phidot, s.L_z / sympy.sin(s.theta) ** 2)
    meaning = {s.L_z: s.phidot * sympy.sin(s.theta) ** 2}
    assert judge_check(Check(divided, meaning)).verdict is Verdict.UNDECIDED
    condition = Assumption(sympy.Ne(sympy.sin(s.theta), 0))
    finding = judge_check(Check(divided, meaning, (condition,)))
    assert finding.verdict is Verdict.ASSUMING
    assert sympy.sin(finding.assumptions[0].without.values[s.theta]) == 0


def test_counterexamples_are_of_bodies_that_exist():
    """λ₃ ≤ 2(λ₁ − MR²): what `HeavyTop` accepts."""
    from rigidtop.derivations.letters import LETTERS
    from rigidtop.motion.top import HeavyTop
    from rigidtop.theory import symbols as s

    names = (s.lambda1, s.lambda3, s.M, s.R, s.omega3)
    points = list(floats.points(names, set(), 200, LETTERS.exists))
    assert len(points) == 200
    for point in points:
        HeavyTop(
            lambda1=float(point[s.lambda1]),
            lambda3=float(point[s.lambda3]),
            M=float(point[s.M]),
            R=float(point[s.R]),
        )


def test_what_is_given_is_not_solved_by_a_division_by_zero():
    # x = 2/y has no counterexample at y = 0, where the given equation says 2 = 0.
    found = refute(Check(typed(x * y, 1), {}, given=(x * y - 2,)))
    assert found.values[y] != 0
    assert found.left == 2


def test_what_is_given_has_what_a_limit_leaves_out():
    """Without the limit, what is given and what is claimed speak of the same numbers."""
    weak = Assumption(Eq(z, 0), stated=True, otherwise=x * y)
    check = Check(typed(x, 1), {}, (weak,), given=(x - 1 - z,))
    finding = judge_check(check)
    assert finding.verdict == "proved"
    [tested] = finding.assumptions
    at = tested.without.values
    assert z not in at
    assert tested.without.left - 1 == tested.without.left * at[y]  # x − 1 = xy
