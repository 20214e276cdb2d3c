"""Roots with an index: frequencies of what oscillates in two ways, eigenvalues, quadratic forms."""

import pytest

from rigidtop.judge.text import judged

CARTS = r"""
$$ L = \frac12 m(\dot x^2 + \dot y^2) - \frac12 kx^2 - \frac12 k(x - y)^2 - \frac12 ky^2 $$
"""
SECULAR = r"""
$$ A = \begin{pmatrix} 2a & b \\ b & 2a \end{pmatrix} $$ The eigenvalues follow from
$$ (2a - \lambda)^2 - b^2 = 0 $$ so
"""
FORM = r"""
$$ V = \frac12 kx^2 + \frac12 k(y - x)^2 $$
It is $V = \frac12 q^T K q$ with $q = (x, y)^T$ and the matrix
"""
CHARGE = r"""
A charge moves in $\mathbf B = B\,\mathbf e_z$:
$$ m\ddot{\mathbf r} = q\,\dot{\mathbf r}\times\mathbf B $$ By components
"""
CHAIN = r"""
$$ m\ddot u_n = k(u_{n+1} - 2u_n + u_{n-1}) $$ With the wave
$$ u_n = A e^{i(na\kappa - \omega t)} $$ we find
"""


@pytest.mark.parametrize(
    ("above", "line", "old", "new"),
    [
        (CARTS + "The frequencies are\n", r"\omega_2^2 = \frac{3k}{m}", "3", "2"),
        (SECULAR, r"\lambda_1 = 2a + b", "2a", "a"),
        (FORM, r"K = \begin{pmatrix} 2k & -k \\ -k & k \end{pmatrix}", "2k", "3k"),
        (CHARGE, r"m\ddot y = -qB\dot x", "-q", "q"),
        (CHAIN, r"\omega^2 = \frac{4k}{m}\sin^2\frac{a\kappa}{2}", "4", "2"),
    ],
    ids=["frequency", "eigenvalue", "quadratic form", "component", "chain"],
)
def test_one_of_several_follows_and_is_told_with_a_slip(above, line, old, new):
    assert line.count(old) == 1
    assert judged(f"{above}$$ {line} $$\n")[-1].outcome.verdict == "sampled"
    assert judged(f"{above}$$ {line.replace(old, new)} $$\n")[-1].outcome.verdict == "false"


def test_a_frequency_that_is_only_given_a_name_is_not_told():
    rows = judged(
        CARTS + r"With $\omega_0^2 = 2k/m$ the first one is $$ \omega_1^2 = \omega_0^2/2 $$"
    )
    assert [row.outcome.passed for row in rows[1:]] == [None, True]


def test_components_go_on_from_each_other():
    text = CHARGE + r"$$ m\ddot x = qB\dot y $$ $$ m\ddot z = 0 $$ $$ m\ddot y = qB\dot x $$"
    assert [row.outcome.passed for row in judged(text)[-3:]] == [True, True, False]


@pytest.mark.parametrize(
    ("words", "square"),
    [
        ("If the second cart is held fast, the frequency is", "3k/m"),
        ("The lower one of the frequencies is", "3k/m"),
        ("Their mean is", "3k/m"),
        ("On the moon, with other springs, the frequency is", "k/m"),
    ],
)
def test_a_root_of_something_else_does_not_follow(words, square):
    text = CARTS + rf"{words} $$ \omega_1^2 = {square} $$"
    assert judged(text)[-1].outcome.passed is not True


@pytest.mark.parametrize(
    ("words", "passed"), [("the two radii are equal", None), ("both are equal", True)]
)
def test_only_what_has_a_name_last_is_equal_where_both_are(words, passed):
    named = r"$$ F = \beta v $$ $$ P = m g\sin\alpha $$"
    text = rf"{named} Then {words}: $$ \beta v = mg\sin\alpha $$"
    assert judged(text)[-1].outcome.passed is passed


@pytest.mark.parametrize(("name", "passed"), [("min", None), ("max", True)])
def test_a_greatest_value_bends_downwards(name, passed):
    text = rf"$$ h = cs - gs^2 $$ $$ h_{{\{name}}} = \frac{{c^2}}{{4g}} $$"
    assert judged(text)[-1].outcome.passed is passed


def test_what_is_no_unit_vector_is_none():
    words = r"Let {} unit vectors be $\mathbf n$ and $\mathbf k$. $$ \mathbf n\cdot\mathbf n = 1 $$"
    passed = [judged(words.replace("{}", x))[-1].outcome.passed for x in ("two", "not two")]
    assert passed[1] is None


def test_a_series_to_fourth_order_is_right():
    text = r"$$ V = b\cos x $$ For small $x$ $$ V \approx b - \frac12 bx^2 + \frac{1}{24}bx^4 $$"
    assert judged(text)[-1].outcome.passed is not False


def test_what_is_counted_may_be_a_whole_number():
    text = r"With an integer $n$ $$ \cos n\pi = (-1)^n $$"
    assert judged(text)[-1].outcome.passed is not False
