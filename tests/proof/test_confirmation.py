"""Zeros confirmed by another arithmetic: what it confirms, what it refutes, what it hears."""

import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import Abs, Integer, Rational, atan, cos, exp, log, pi, sin, sqrt, symbols, tan
from sympy.abc import x, y
from sympy.ntheory import isprime

from rigidtop.cli import main
from rigidtop.commands import check
from rigidtop.proof import confirmation, decide, values
from rigidtop.proof.confirmation import PRIME, confirmed, heard, zeros
from rigidtop.proof.equation import Rate
from rigidtop.theory.polynomial import Polynomial

a, b = symbols("a b", positive=True)
r, s = symbols("r s", real=True)
A, B = symbols("A B", commutative=False)
m = sympy.Symbol("m")

TRUE = (
    sin(x) ** 2 + cos(x) ** 2 - 1,
    sin(x + y) - sin(x) * cos(y) - cos(x) * sin(y),
    cos(3 * x) - 4 * cos(x) ** 3 + 3 * cos(x),
    2 * sin(x / 2) * cos(x / 2) - sin(x),
    sin(x * y) ** 2 - 1 + cos(x * y) ** 2,
    tan(x) - sin(x) / cos(x),
    1 / (x - y) + 1 / (y - x),
    pi * (x + y) - pi * x - pi * y,
    sqrt(a * b + a) - sqrt(a) * sqrt(b + 1),
    sqrt(a**2 + 2 * a * b + b**2) - a - b,
    sqrt(r**2 - 2 * r * s + s**2) - Abs(r - s),
    1 / (sqrt(2) - 1) - sqrt(2) - 1,
    (2 + sqrt(3)) * (2 - sqrt(3)) - 1,
    (a * b + b) ** Rational(1, 3) - b ** Rational(1, 3) * (a + 1) ** Rational(1, 3),
    sin(x + pi / 3) - sin(x) / 2 - sqrt(3) * cos(x) / 2,
    sin(sqrt(a * b + b * b) / b) - sin(sqrt((a + b) / b)),
    exp(x + y) - exp(x) * exp(y),
    log(a * b) - log(a) - log(b),
    atan(a) + atan(1 / a) - pi / 2,
    sympy.elliptic_k(2 * m / 2) - sympy.elliptic_k((m**2 + m) / (m + 1)),
    Rate(x) * (Rate(x) + 1) - Rate(x) ** 2 - Rate(x),
    (A + B) * (A - B) - A * A + B * B + A * B - B * A,
    x * A * (B + 1) - x * A * B - x * A,
)
FALSE = (
    x * Rational(1, 10**60),
    x * Rational(1, 10**120),  # exact numbers are needed for it
    sin(x) ** 2 + cos(x) ** 2 - 1 + Rational(1, 10**50),
    sin(x) - x,
    sqrt(r**2) - r,
    sqrt((r - s) ** 2) - r + s,
    sqrt(a * b + 1) - sqrt(a) * sqrt(b) - 1,
    sqrt(a**2 + 1) - a - Rational(1, 10**40),
    log(r**2) - 2 * log(Abs(r)) + Rational(1, 10**45),
    exp(x) - exp(x + Rational(1, 10**40)),
    atan(r) + atan(1 / r) - pi / 2,  # of negative ones it is −π/2
    sympy.elliptic_k(m) - sympy.elliptic_k(m + Rational(1, 10**30)),
    Rate(x) - Rate(y),
)


@pytest.mark.parametrize("zero", TRUE, ids=str)
def test_what_vanishes_is_confirmed(zero):
    assert zero != 0
    assert confirmed(zero) is True


@pytest.mark.parametrize("wrong", FALSE, ids=str)
def test_what_does_not_is_refuted(wrong):
    assert confirmed(wrong) is False


@pytest.mark.parametrize(
    "strange", [A * B - B * A, sqrt(-1 - r**2) - 1, sympy.I * x - x * sympy.I + sympy.I], ids=str
)
def test_what_has_no_value_is_not_confirmed(strange):
    assert confirmed(strange) is not True


def test_the_field_is_what_it_is_said_to_be():
    assert isprime(PRIME)
    assert PRIME % 4 == 3
    for q in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31):
        assert pow(q, (PRIME - 1) // 2, PRIME) == 1


# --- Random identities ---------------------------------------------------------------------------

LETTERS = st.sampled_from((x, y, a, b, r, Integer(2), Integer(-3), Rational(1, 2)))
ANGLES = st.builds(lambda u, v, p, q: p * u + q * v, *2 * [st.sampled_from((x, y, r))],
                   *2 * [st.integers(-3, 3)])  # fmt: skip
TERMS = st.recursive(
    LETTERS | st.builds(sin, ANGLES) | st.builds(cos, ANGLES) | st.builds(sqrt, st.just(a + b)),
    lambda inner: (
        st.builds(lambda u, v: u + v, inner, inner)
        | st.builds(lambda u, v: u * v, inner, inner)
        | st.builds(lambda u: 1 / (u**2 + 1), inner)
    ),
    max_leaves=6,
)
"""Trees that are real at all places, and have no pole that is everywhere."""


def rewritten(term, angle):
    """The same in other words: multiplied out, a rotation there and back, sines by half angles."""
    turned = sin(angle) * (sin(angle) * term) + cos(angle) * (cos(angle) * term)
    half = sympy.expand_trig(sympy.expand(turned))
    return half.subs(sin(x), 2 * sin(x / 2) * cos(x / 2))


@settings(max_examples=30, deadline=None)
@given(TERMS, ANGLES)
def test_random_identities_are_confirmed_and_what_is_near_them_is_refuted(term, angle):
    zero = term - rewritten(term, angle)
    assert zero == 0 or confirmed(zero) is True
    assert confirmed(zero + Rational(1, 10**50)) is False
    assume(term != 0)
    assert confirmed(zero + x * Rational(1, 10**50)) is False
    assert confirmed(zero - r * cos(angle + x) / 10**40) is False


# --- What is heard -------------------------------------------------------------------------------


def test_yes_is_heard_once_and_only_while_someone_listens():
    one = sin(x) ** 2 + cos(x) ** 2 - 1
    assert values.vanishes(one)
    with zeros() as outer:
        assert decide.vanishes(x * one)
        with zeros() as inner:
            assert values.vanishes(one)
            assert not values.vanishes(one + x)
            assert values.vanishes(Integer(0))
            assert decide.evidence(one * y)
            assert decide.evidence(sin(y) - y) is None
            assert decide.digits_vanish([one])
    assert inner == [one, one * y]
    assert outer == [x * one]


def test_an_error_ends_the_listening():
    broken = heard(lambda _: 1 / 0)
    with pytest.raises(ZeroDivisionError), zeros():
        broken(x)
    assert confirmation._HEARD.get() is None


@pytest.mark.parametrize(
    "wrong", [x * Rational(1, 10**60), sin(x) ** 2 + cos(x) ** 2 - 1 + Rational(1, 10**50)], ids=str
)
def test_a_wrong_zero_is_refuted(wrong, monkeypatch):
    monkeypatch.setattr(Polynomial, "is_zero", lambda _: True)
    with zeros() as found:
        assert values.vanishes(wrong)
        assert decide.evidence(wrong)
    assert found == [wrong, wrong]
    denied, counts = check.confirmed(dict.fromkeys(found, "page.md, line 7"))
    assert denied == [f"page.md, line 7: another arithmetic refutes that this is 0: {wrong}"]
    assert counts == ["0 zeros confirmed by another arithmetic, 1 not"]


COURSE = """
from rigidtop.proof.equation import Equation
from rigidtop.proof.page import Check, Page, claim
from sympy import Rational, cos, sin
from sympy.abc import x

@claim("1.1", "the circle, nearly")
def circle():
    yield Check(Equation(sin(x) ** 2 + cos(x) ** 2, {}))

PAGES = (Page("1", "Numbers", "About numbers.", (circle,)),)
"""


@pytest.mark.parametrize(
    ("right", "code", "said"),
    [
        ("1 + 0 * x", 0, "1 zero confirmed by another arithmetic, 0 not"),
        ("1 - Rational(1, 10**50)", 1, "1.1: another arithmetic refutes that this is 0: sin(x)"),
    ],
)
def test_check_thorough_fails_where_a_zero_is_refuted(
    right, code, said, tmp_path, capsys, monkeypatch
):
    folder = tmp_path / f"course_{code}"
    folder.mkdir()
    (folder / "__init__.py").write_text(COURSE.format(right))
    assert main(["check", f"{folder}/"]) == code  # the normal form tells it from 1
    monkeypatch.setattr(Polynomial, "is_zero", lambda _: True)
    capsys.readouterr()
    assert main(["check", f"{folder}/"]) == 0
    assert "another arithmetic" not in capsys.readouterr().out
    assert main(["check", f"{folder}/", "--thorough"]) == code
    assert said in capsys.readouterr().out
