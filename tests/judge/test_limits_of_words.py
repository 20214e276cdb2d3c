r"""What words say of one case, of one limit or of one oscillation holds of no other."""

import pytest

from rigidtop.judge.text import judged

WRONG = {
    "a force that vanishes at rest": r"$F = q v B$. It vanishes for $v = 0$. So $F = 9 q v B$.",
    "a torque that vanishes": (
        r"$M = m g s\sin\theta$. It vanishes if $s = 0$. At $\theta = \pi/2$ it is $M = 5 m g s$."
    ),
    "another limit, by a sign": (
        r"$v = u(1 - e^{-t/\tau})$, where $u = g\tau$. For $t \gg \tau$, $v \approx g t$."
    ),
    "another limit, by a word": r"$F = -k x + b x^3$. For small $x$, $F \approx b x^3$.",
    "the greater of two": r"$E = A a^2 + C n^2$. For $n \gg a$, $E \approx A a^2$.",
    "another oscillation, by its index": (
        r"$m\ddot x = -k x$ and $l\ddot y = -g y$. So $x$ swings with $\omega_x^2 = g/l$."
    ),
    "the other root": (
        r"$v^2 - 2 u v - w^2 = 0$. The positive root is $v = u - \sqrt{u^2 + w^2}$."
    ),
}


@pytest.mark.parametrize("text", WRONG.values(), ids=WRONG)
def test_what_is_wrong_does_not_pass(text):
    assert not judged(text)[-1].outcome.passed


RIGHT = {
    "the same limit, by a sign": (
        r"$v = u(1 - e^{-t/\tau})$, where $u = g\tau$. For $t \ll \tau$, $v \approx g t$."
    ),
    "the same limit, by a word": r"$F = -k x + b x^3$. For small $x$, $F \approx -k x$.",
    "the greater one": r"$E = A a^2 + C n^2$. For $n \gg a$, $E \approx C n^2$.",
    "the oscillation of that index": (
        r"$m\ddot x = -k x$ and $l\ddot y = -g y$. So $x$ swings with $\omega_x^2 = k/m$."
    ),
    "the root that is meant": (
        r"$v^2 - 2 u v - w^2 = 0$. The positive root is $v = u + \sqrt{u^2 + w^2}$."
    ),
}


@pytest.mark.parametrize("text", RIGHT.values(), ids=RIGHT)
def test_what_is_right_passes(text):
    assert judged(text)[-1].outcome.passed


@pytest.mark.parametrize(
    "text",
    [
        r"$l\ddot\phi = -g\phi$. A pendulum of length $4 l$ has $\omega_1^2 = g/(4 l)$.",
        r"$m\ddot x = -k x$. The spring cut in half has $\omega_1^2 = 2k/m$.",
        r"$m\ddot x = -k x$. With the mass $M$ instead, $\omega^2 = k/M$.",
    ],
)
def test_another_body_may_have_another_frequency(text):
    assert judged(text)[-1].outcome.passed is not False


ROCKET = r"""
$$m\dot v = -u\dot m$$
At $t = 0$ it starts with $v = 0$ and $m = m_0$. Hence
$$v = u\ln\frac{m_0}m$$
and so
$$m = m_0e^{-v/u}$$
When the rocket has become as fast as its gas, $v = u$, there is left of it
$$m = m_0e^{-1}$$
"""


@pytest.mark.parametrize(("sign", "passed"), [("-", True), ("", False)])
def test_what_has_been_integrated_holds_from_there_on(sign, passed):
    *_, exponential, _, last = judged(ROCKET.replace("e^{-v/u}", f"e^{{{sign}v/u}}"))
    assert exponential.outcome.passed is passed
    assert last.outcome.passed


def test_what_has_been_integrated_in_a_case_ends_with_it():
    *_, there, in_general, square = judged(r"""
$$m\dot v = -\mu m g$$
It starts with $v = w$ at $t = 0$. Without friction, $\mu = 0$, it keeps its speed:
$$v = w$$
In general
$$v = w$$
and
$$v^2 = w^2$$
""")
    assert there.outcome.passed
    assert not in_general.outcome.passed
    assert not square.outcome.passed
