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
    "the smaller of two, in words": (
        r"$\mu = \frac{mM}{m + M}$. The star $M$ is much heavier than the planet $m$, so "
        r"$\mu \approx M$."
    ),
    "a higher term, in what is lost in a sum": (
        r"$E = \frac{mc^2}{\sqrt{1 - v^2/c^2}}$. At low speeds "
        r"$E \approx mc^2 + \frac12 mv^2 - \frac{3mv^4}{8c^2}$."
    ),
    "a higher term, in a difference": (
        r"$E = \frac{mc^2}{\sqrt{1 - v^2/c^2}}$. At low speeds "
        r"$E - mc^2 \approx \frac12 mv^2\left(1 - \frac{3v^2}{4c^2}\right)$."
    ),
    "a higher term of a cosine": (
        r"$V = b\cos x$. For small $x$, $V \approx b - \frac12 bx^2 - \frac1{24}bx^4$."
    ),
    "of two that are nearly equal": (
        r"$H = \frac{AB}{A + B}$. For coils that are almost alike $H \approx A$."
    ),
    "the greater of two": r"$E = A a^2 + C n^2$. For $n \gg a$, $E \approx A a^2$.",
    "another oscillation, by its index": (
        r"$m\ddot x = -k x$ and $l\ddot y = -g y$. So $x$ swings with $\omega_x^2 = g/l$."
    ),
    "the same with the spring cut": (
        r"$\ddot x = -\frac{k + c}{m}x$. Without the right spring $$\ddot x = -\frac{k + c}{m}x$$"
    ),
    "the same on a rough table": (
        r"$M\ddot x = F$, so $$\ddot x = \frac FM.$$ On a rough table, where the block rubs, "
        r"$$\ddot x = \frac FM$$"
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
    "the greater of two, in words": (
        r"$\mu = \frac{mM}{m + M}$. The star $M$ is much heavier than the planet $m$, so "
        r"$\mu \approx m - \frac{m^2}{M}$."
    ),
    "a higher term, in what is lost in a sum": (
        r"$E = \frac{mc^2}{\sqrt{1 - v^2/c^2}}$. At low speeds "
        r"$E \approx mc^2 + \frac12 mv^2 + \frac{3mv^4}{8c^2}$."
    ),
    "a higher term, in a difference": (
        r"$E = \frac{mc^2}{\sqrt{1 - v^2/c^2}}$. At low speeds "
        r"$E - mc^2 \approx \frac12 mv^2\left(1 + \frac{3v^2}{4c^2}\right)$."
    ),
    "of two that are nearly equal": (
        r"$H = \frac{AB}{A + B}$. For coils that are almost alike $H \approx \frac A2$."
    ),
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
        r"$m\ddot x = -(k + c)x$. Without the right spring we have $$m\ddot x = -kx.$$",
        r"$m\ddot x = F - mg$. A rocket without fuel has $$\ddot x = -g.$$",
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


@pytest.mark.parametrize(
    ("root", "words"),
    [
        (r"\sqrt{u^2 - 2gy}", "where ẏ is not negative"),
        (r"-\sqrt{u^2 - 2gy}", "where ẏ is not positive"),
    ],
)
def test_a_root_of_a_speed_holds_for_one_direction(root, words):
    outcome = judged(rf"$\dot y^2 = u^2 - 2gy$, so $\dot y = {root}$.")[-1].outcome
    assert (outcome.verdict, outcome.why) == ("assuming", words)
