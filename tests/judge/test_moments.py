"""Of which moment a line speaks, and what is known of it there."""

import pytest

from rigidtop.judge.text import judged

THROW = r"""
$$ \ddot x = 0, \qquad \ddot y = -g $$ Thrown from the origin at the angle $\beta$, therefore
$$ x = ct\cos\beta $$ $$ y = ct\sin\beta - \frac12 gt^2. $$
It is on the ground when $y = 0$ again, $t > 0$:
"""
SLIDING = r"""
A ball slides, and does not turn at first: $$ m\dot v = -\mu mg $$ $$ J\dot\omega = \mu mgR $$
With $J = \frac25 mR^2$ $$ v = c - \mu gt $$ $$ R\omega = \frac52\mu gt $$
It rolls when $v = R\omega$, at $$ t_1 = \frac{2c}{7\mu g}. $$ From there on
"""
SPRING = r"""
$$ L = \frac12 m(\dot s^2 + s^2\dot\theta^2) + mgs\cos\theta - \frac12 k(s - a)^2 $$
At rest ($\theta = 0$) the length is
"""
CART = r"""
A pendulum hangs from a cart whose motion $X(t)$ is given.
$$ L = \frac12 m(\dot X^2 + 2l\dot X\dot\theta\cos\theta + l^2\dot\theta^2) + mgl\cos\theta $$
If $\ddot X = b$ stays the same, it can hang still at
"""
DRAG = r"""
The drag is $$ F = \beta v $$ and the pull is $$ P = m g\sin\alpha. $$
With the speed $v = u$ both are equal:
"""
SINKING = r"""
$$ m\dot v = mg - cv $$ In the end $\dot v = 0$ and the speed is $$ u = \frac{mg}{c}. $$
From rest at $t = 0$
"""


GOVERNOR = r"""
$$ L = \frac12 ml^2(\dot\theta^2 + \Omega^2\sin^2\theta) + mgl\cos\theta $$
Besides the lowest position there is another one, $\theta = \theta_0$ with
"""
PUSHED = r"""
A pendulum has the rate $s$ at $\theta = 0$, and $$ \dot\theta^2 = s^2 - 2w^2(1 - \cos\theta). $$
It turns back at $\theta = \alpha$, where
"""
BRAKED = r"""
$$ m\ddot x = -\mu mg $$ If it starts with the speed $u$ it comes to a stop after the way
"""
AXIS = r"""
Let $\mathbf e$ and $\mathbf k$ be unit vectors, with $\mathbf e\cdot\mathbf k = \cos\theta$. Then
"""
BOOK = r"""
$$ A\dot p = (B - C)qr $$ $$ B\dot q = (C - A)rp $$ $$ C\dot r = (A - B)pq $$
As long as $q$ and $r$ are small, $p = \Omega$ is constant, and
"""
LIMIT = r"""
$$ \dot\theta^2 = 4w^2\cos^2\frac\theta2 $$ so
"""
WIRE = r"""
$$ J\ddot\varphi = -D\varphi $$ has the period $$ T_0 = 2\pi\sqrt{\frac JD}. $$
With a ring it becomes
"""


@pytest.mark.parametrize(
    ("above", "line", "old", "new"),
    [
        (GOVERNOR, r"\cos\theta_0 = \frac{g}{l\Omega^2}", "{g}", "{2g}"),
        (PUSHED, r"\cos\alpha = 1 - \frac{s^2}{2w^2}", "1 -", "1 +"),
        (BRAKED, r"s = \frac{u^2}{2\mu g}", r"{2\mu", r"{3\mu"),
        (
            AXIS,
            r"\mathbf e\times(\mathbf k\times\mathbf e) = \mathbf k - \mathbf e\cos\theta",
            "-",
            "+",
        ),
        (BOOK, r"BC\ddot q = -(A - B)(A - C)\Omega^2q", "= -", "= "),
        (LIMIT, r"\dot\theta = 2w\cos\frac\theta2", "2w", "4w"),
        (WIRE, r"T_1 = 2\pi\sqrt{\frac{J + J_1}{D}}", "+", "-"),
        (THROW, r"t = \frac{2c\sin\beta}{g}", "2c", "3c"),
        (SLIDING, r"v = \frac57 c", "5", "6"),
        (SLIDING, r"\omega = \frac{5c}{7R}", "5c", "6c"),
        (SPRING, r"s_0 = a + \frac{mg}{k}", "+", "-"),
        (CART, r"\tan\theta = -\frac bg", "-", ""),
        (DRAG, r"\beta u = mg\sin\alpha", "sin", "cos"),
        (SINKING, r"v = u(1 - e^{-ct/m})", "-c", "-2c"),
    ],
    ids=[
        *("another rest", "turning", "stopping", "unit vectors", "first order"),
        *("a root", "another body"),
        *("a time", "a speed", "a rate", "at rest", "given motion", "both equal", "in the end"),
    ],
)
def test_it_follows_at_its_moment_and_with_a_slip_it_does_not(above, line, old, new):
    assert line.count(old) == 1
    assert judged(f"{above}$$ {line} $$\n")[-1].outcome.passed is True
    assert judged(f"{above}$$ {line.replace(old, new)} $$\n")[-1].outcome.passed is not True


def test_a_line_that_is_wrong_only_by_what_is_supposed_is_not_held():
    text = (
        r"$$ m\dot v = -c\dot m $$ from rest with the mass $m_0$ $$ v = c\ln\frac{m}{m_0}. $$"
        "\n\nWhen half of it is used up, $m = m_0/2$, the speed is $$ v = c\\ln 2. $$"
    )
    assert [row.outcome.passed for row in judged(text)][-3:] == [False, None, None]


def test_a_tie_of_rates_contradicts_one_of_the_places():
    places = r"$$ x = \frac12 a\cos\theta $$ $$ y = \frac12 a\cos\theta $$"
    rows = judged(places + r" so $$ \dot x^2 + \dot y^2 = \frac14 a^2\dot\theta^2 $$")
    assert rows[-1].outcome.verdict == "false"
    assert rows[-1].outcome.why == "it contradicts one of the lines that it rests on"


def test_a_link_of_a_chain_in_the_same_constants_is_refuted():
    text = r"$$ x = \int_0^t u(1 - e^{-s/\tau})\,ds = u(t - 1 + e^{-t/\tau}) $$"
    assert judged(text)[-1].outcome.verdict == "false"


def test_a_factor_of_what_is_nearly_so_is_told():
    text = (
        r"$$ \frac75 b\ddot\varphi = -g\sin\varphi $$ For small angles "
        r"$$ \ddot\varphi \approx %s\varphi $$"
    )
    right, wrong = (judged(text % x)[-1].outcome for x in (r"-\frac{5g}{7b}", r"-\frac gb"))
    assert right.passed
    assert (wrong.verdict, wrong.slip) == ("false", "5/7 times as much")


def test_an_acceleration_that_is_given_by_others_is_refuted():
    text = (
        r"$$ I\ddot\alpha = -k(\alpha - \beta) $$ $$ J\ddot\beta = k(\alpha - \beta) $$"
        r" The twist $\delta = \alpha - \beta$ obeys $$ \ddot\delta = %s\delta $$"
    )
    right, wrong = r"-\left(\frac kI + \frac kJ\right)", r"-\frac{k}{I + J}"
    assert [judged(text % x)[-1].outcome.passed for x in (right, wrong)] == [True, False]


def test_a_slope_by_a_place_has_the_momenta_of_the_function():
    text = (
        r"$$ L = \frac12 m\dot r^2 + \frac12(J + mr^2)\dot\theta^2 $$"
        r"$$ p = (J + mr^2)\dot\theta $$"
        r"$$ H = \frac12 m\dot r^2 + \frac{p^2}{2(J + mr^2)} $$"
        r"$$ -\frac{\partial H}{\partial r} = \frac{mrp^2}{%s} $$"
    )
    right, wrong = "(J + mr^2)^2", "J + mr^2"
    assert [judged(text % x)[-1].outcome.passed for x in (right, wrong)] == [True, False]


def test_a_velocity_in_time_behind_a_start_from_rest_is_no_start():
    text = r"From rest it has $\dot z = -gt$, so $$ \ddot z = -g $$ and $$ \ddot z = g $$"
    assert [row.outcome.passed for row in judged(text)][-2:] == [True, False]


def test_no_law_moves_what_is_given():
    text = (
        r"The height $X(t)$ is prescribed. "
        r"$$ L = \frac12 m\dot X^2 + \frac12 n\dot x^2 - k(x - X)^2 $$"
        r"$$ n\ddot x = -2k(x - X) $$ $$ m\ddot X = 2k(x - X) $$"
    )
    assert [row.outcome.passed for row in judged(text)][-2:] == [True, None]


def test_a_letter_that_nothing_brings_is_told_where_another_one_is_meant():
    text = (
        r"$$ m\ddot x = mg - S $$ $$ J\ddot\varphi = Sr $$ $$ \ddot x = r\ddot\varphi $$ So "
        r"$$ \ddot x = \frac{mgr^2}{mr^2 + J} $$ and $$ S = \frac{mgI}{mr^2 + J} $$"
    )
    outcome = judged(text)[-1].outcome
    assert (outcome.verdict, outcome.slip) == ("false", "J in place of I")
