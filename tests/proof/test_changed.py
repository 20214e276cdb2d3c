"""What is changed in an equation, and that a hole in a check is seen."""

from types import SimpleNamespace

from sympy import Matrix, Rational, Symbol, cos, sin

from rigidtop.derivations.letters import LETTERS
from rigidtop.proof.changed import perturbations
from rigidtop.proof.derivation import Line
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
from rigidtop.proof.moves import Known, Move
from rigidtop.proof.page import Check
from rigidtop.proof.trial import survivors
from rigidtop.proof.verdict import Finding, judge_check
from rigidtop.theory import symbols as s


def test_kinds_of_change():
    with as_printed():
        printed = Equation(s.L3, s.lambda3 * (s.psidot + s.phidot * cos(s.theta)))
    assert {p.change for p in perturbations(printed, LETTERS.families)} >= {
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


def test_a_hole_is_seen(fallen):
    with as_printed():
        printed = Equation(s.omega1, 2 * s.omega2)
    nothing = judge_check(Check(printed, {s.omega1: s.theta * 0, s.omega2: s.theta * 0}))
    sound = judge_check(Check(printed, {s.omega1: 2 * s.theta, s.omega2: s.theta}))
    assert (nothing.verdict, sound.verdict) == ("proved", "proved")
    fell, stood = fallen(SimpleNamespace(items=(nothing,)))
    assert (fell, len(stood)) == (1, 3)  # ω₃ is nothing that was said
    assert fallen(SimpleNamespace(items=(sound,))) == (4, [])


def test_what_is_false_has_nothing_to_fall(fallen):
    false = judge_check(Check(Equation(s.a, 2 * s.a), {}))
    undecided = Finding(Check(Equation(s.a, s.a)), "undecided")
    assert false.verdict == "false"
    assert fallen(SimpleNamespace(items=(false, undecided))) == (0, [])


def test_a_convention_is_changed_in_the_reading_in_which_it_holds(fallen):
    with as_printed():
        printed = Equation(s.L1, sin(s.theta))
    check = Check(printed, {s.L1: -sin(s.theta)}, other_reading={s.L1: sin(s.theta)})
    fell, stood = fallen(SimpleNamespace(items=(judge_check(check),)))
    assert fell > len(stood)


def test_a_change_that_stands_is_seen_and_what_says_the_same_is_none():
    with as_printed():
        cited, equal = Equation(s.a, 2 * s.omega1), Equation(s.omega1, s.omega2)
        said = Equation(s.a, 2 * s.omega2 * cos(-s.theta) / cos(s.theta))
    move = Move("put", of=(Known("one", (cited,)),), using=(Known("two", (equal,)),))
    tried, stood = survivors(Line("three", (said,), "", move=move), LETTERS)
    assert stood == ("omega1 for omega2",)
    changes = len(perturbations(said, LETTERS.families))
    assert 5 < tried < changes + 2  # two other moves besides
