"""Which changes count, and that a hole in a check is seen."""

import pytest
from sympy import Eq, Matrix, Ne, Rational, Symbol, cos, eye, sin

from rigidtop.derivations.letters import LETTERS
from rigidtop.proof.changed import perturbations
from rigidtop.proof.equation import (
    SPACE,
    Cross,
    Dot,
    Equation,
    Group,
    Rate,
    SumOver,
    Transposed,
    Underbrace,
    VolumeIntegral,
    as_printed,
)
from rigidtop.proof.page import Assumption, Check
from rigidtop.proof.perturb import falls, telling, upheld
from rigidtop.proof.verdict import Finding, judge_check
from rigidtop.theory import symbols as s


def changes(check):
    return {perturbation.change for perturbation in telling(check, LETTERS)}


def survivors(check):
    return {p.change for p in telling(check, LETTERS) if not falls(check, p, LETTERS)}


def sound():
    with as_printed():
        printed = Equation(s.L3, s.lambda3 * (s.psidot + s.phidot * cos(s.theta)))
    return Check(printed, {s.L3: s.lambda3 * (s.psidot + s.phidot * cos(s.theta))})


def test_kinds_of_change():
    assert changes(sound()) >= {
        "sign of psidot",
        "psidot dropped",
        "twice psidot",
        "phidot for psidot",
        "square of psidot",
        "psi for theta",
        "the other function in cos(theta)",
        "square of cos(theta)",
        "lambda1 for lambda3",
        "sign of L3",
        "L_z for L3",
    }
    assert survivors(sound()) == set()


def test_changes_of_vectors_matrices_and_numbers():
    with as_printed():
        printed = Equation(
            Dot(s.e3, Cross(s.omega_vec, s.L_vec)),
            Rational(1, 2) * Group(s.a**2),
            Transposed(s.O_matrix),
        )
        entry = Equation(s.r_vec, Matrix([s.omega1, 0, 1]))
    assert {p.change for p in perturbations(printed, LETTERS.families)} >= {
        "factors of × exchanged",
        "transposition dropped",
        "exponent of a",
        "3/2 for 1/2",
        "sign of 1/2",
        "b for a",
    }
    found = {p.change for p in perturbations(entry, LETTERS.families)}
    assert {"entry 1: omega2 for omega1", "entry 3: 2 for 1"} <= found
    assert not any(change.startswith("entry 2") for change in found)


def test_labels_and_measures_are_left_alone():
    k, d3r = Symbol("k"), Symbol("d3r")
    rate = Rate(s.L_vec, SPACE)
    with as_printed():
        printed = Equation(Underbrace(s.a, s.M), SumOver(k, s.b), VolumeIntegral(d3r, s.rho), rate)
    changed = {p.change for p in perturbations(printed, LETTERS.families)}
    assert not any(
        name in change for change in changed for name in ("k", "d3r", "space for", "of M")
    )
    assert f"sign of {rate}" in changed


def test_a_hole_is_seen():
    with as_printed():
        printed = Equation(s.omega1, 2 * s.omega2)
    empty = Check(printed, {s.omega1: s.theta * 0, s.omega2: s.theta * 0})
    assert judge_check(empty).verdict == "proved"
    assert {"3 for 2", "sign of omega2", "twice omega1"} <= survivors(empty)


def test_what_holds_even_without_an_assumption_has_not_fallen():
    with as_printed():
        printed = Equation(s.omega1, s.omega2 / s.L3)
    zero = sin(s.theta) ** 2 + cos(s.theta) ** 2 - 1
    nothing = {s.omega1: zero, s.omega2: zero}
    check = Check(printed, nothing, (Assumption(Ne(s.L3, 0)),))
    assert judge_check(check).verdict == "assuming"
    assert "exponent of L3" in survivors(check)


@pytest.mark.parametrize(
    ("sides", "harmless"),
    [
        ((s.omega3dot, 0), {"twice omega3dot", "sign of omega3dot", "square of omega3dot"}),
        ((s.det_O, 1), {"square of det_O"}),
        ((s.L**2, s.const), {"twice L", "exponent of L", "sign of L", "square of L"}),
        ((s.a, s.b * cos(s.theta)), {"sign of theta"}),
        ((0, s.omega1, s.omega2), {"sign of omega1", "twice omega2", "square of omega2"}),
    ],
)
def test_harmless_changes_do_not_count(sides, harmless):
    check = Check(Equation(*sides), {s.const: lambda value: value})
    assert harmless <= {p.change for p in perturbations(check.claimed, LETTERS.families)}
    assert not harmless & changes(check)


def test_one_is_one_squared_for_matrices_too():
    with as_printed():
        printed = Equation(Transposed(s.O_matrix) * s.O_matrix, s.unit)
    check = Check(printed, {s.O_matrix: Matrix(3, 3, range(9)), s.unit: eye(3)})
    assert "square of unit" not in changes(check)
    assert {"twice unit", "transposition dropped", "square of O_matrix"} <= changes(check)


def test_equal_moments_may_be_exchanged():
    with as_printed():
        printed = Equation(s.L1, s.lambda1 * s.omega1)
    stated = Assumption(Eq(s.lambda2, s.lambda1), stated=True)
    assert "lambda2 for lambda1" in changes(Check(printed, {}))
    assert "lambda2 for lambda1" not in changes(Check(printed, {}, (stated,)))
    assert "lambda3 for lambda1" in changes(Check(printed, {}, (stated,)))


def test_of_an_inequality_the_relation_is_turned():
    for relation, opposite in (("≠", "= for ≠"), (">", "< for >"), ("<", "> for <")):
        check = Check(Equation(s.a, 0, relation=relation), {})
        assert changes(check) == {opposite}


def test_a_convention_is_perturbed_in_the_reading_in_which_it_holds():
    with as_printed():
        printed = Equation(s.L1, sin(s.theta))
    check = Check(printed, {s.L1: -sin(s.theta)}, other_reading={s.L1: sin(s.theta)})
    held = upheld(judge_check(check))
    assert (held.meaning, held.other_reading) == ({s.L1: sin(s.theta)}, None)
    assert survivors(held) == set()


def test_what_is_false_has_nothing_to_fall():
    false = judge_check(Check(Equation(s.a, 2 * s.a), {}))
    assert (false.verdict, upheld(false)) == ("false", None)
    undecided = Finding(Check(Equation(s.a, s.a)), "undecided")
    assert upheld(undecided) is None


def test_conditions_hold_for_the_changed_equation_too():
    tilted = Assumption(Ne(sin(s.theta), 0))
    with as_printed():
        printed = Equation(s.phidot, s.L_z / sin(s.theta))
    check = Check(printed, {s.L_z: s.phidot * sin(s.theta)}, (tilted,))
    assert judge_check(check).verdict == "assuming"
    assert survivors(check) == set()
