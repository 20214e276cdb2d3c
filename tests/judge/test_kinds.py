"""Kinds of lines that texts have: right ones follow, and with one change they are told."""

import pytest

from rigidtop.judge.text import judged

HOOP = r"""
$$ L = \frac12 m a^2(\dot\theta^2 + \Omega^2\sin^2\theta) + m g a\cos\theta $$
"""
TOP = r"""
$$ L = \frac12 A(\dot\theta^2 + \dot\phi^2\sin^2\theta)
   + \frac12 C(\dot\psi + \dot\phi\cos\theta)^2 - MgR\cos\theta $$
and $\omega_3 = \dot\psi + \dot\phi\cos\theta$.

For $\theta = \theta_0 = $ const with $\sin\theta_0 \neq 0$ and $\dot\phi = \Omega$
"""
PRECESSION = r"The rates obey $A\Omega^2\cos\theta - C\omega\Omega + MgR = 0$." + "\n\n"
STRING = r"Its angular momentum is $$ L = m r^2\omega $$ and it is conserved, so" + "\n"
PENDULUM = r"""
The energy is $$ E = \frac12 m l^2 \omega^2 A^2, \qquad \omega = \sqrt{g/l}. $$
If the string is shortened slowly, $J = E/\omega$ stays constant. From $l_1$ to $l_2$ it becomes
"""
DAMPED = r"""
$$ R = \frac12 c(\dot x - \dot y)^2 $$ and
$$ L = \frac12 m\dot x^2 + \frac12 n\dot y^2 - \frac12 kx^2. $$ The rule
$$ \frac{d}{dt}\frac{\partial L}{\partial\dot q} - \frac{\partial L}{\partial q}
   = -\frac{\partial R}{\partial\dot q} $$
for $q = x$ and for $q = y$ gives
"""
SATELLITE = r"""
On a circle with $GM = 3.986\cdot10^{14}\ \mathrm{m^3/s^2}$ and $r = 6.878\cdot10^6\ \mathrm m$
$$ n = \sqrt{\frac{GM}{r^3}} $$ and the swings take $$ \tau = \frac{2\pi}{\sqrt3\,n} $$ or
"""
BOUNCE = r"""
It rises to the height $$ h = \frac{E}{mg} $$ and
$$ J = 2\int_0^h\sqrt{2m(E - mgz)}\,dz. $$ Hence
"""
DROP = r"""
$$ m = m_0 + \kappa t $$ and $$ \frac{d}{dt}(mv) = mg. $$ Let $v = 0$ at $t = 0$. Integrated,
"""
ORBIT = r"""
$$ r = \frac{p}{1 + e\cos\varphi}, \qquad r^2\dot\varphi = h $$
Hence $$ \dot r = \frac{eh}{p}\sin\varphi $$ and
"""
WAVE = r"$$ y = A\sin kx\cos ckt $$ is the sum of two waves" + "\n"
KINDS = [
    (
        "a place where it stays",
        TOP,
        r"A\Omega^2\cos\theta_0 - C\omega_3\Omega + MgR = 0",
        "- C",
        "+ C",
    ),
    (
        "the slow root",
        PRECESSION + "For a fast top ",
        r"\Omega_- \approx \frac{MgR}{C\omega}",
        "{MgR",
        "{2MgR",
    ),
    (
        "the fast root",
        PRECESSION + "For a fast top ",
        r"\Omega_+ \approx \frac{C\omega}{A\cos\theta}",
        r"\cos",
        r"\sin",
    ),
    (
        "two states",
        STRING,
        r"\omega_2 = \omega_1\frac{r_1^2}{r_2^2}",
        "r_1^2}{r_2^2",
        "r_2^2}{r_1^2",
    ),
    ("an invariant", PENDULUM, r"A_2 = A_1\left(\frac{l_1}{l_2}\right)^{3/4}", "3/4", "1/4"),
    ("a rule for q", DAMPED, r"n\ddot y + c(\dot y - \dot x) = 0", r"(\dot y - \dot x)", r"\dot y"),
    ("a number", SATELLITE, r"\tau \approx 3278\ \mathrm s", "3278", "3728"),
    ("a root at the end", BOUNCE, r"J = \frac{4\sqrt2}{3}\frac{E^{3/2}}{g\sqrt m}", "{3}", "{5}"),
    ("an integral of a start", DROP, r"mv = m_0gt + \frac12\kappa gt^2", r"\frac12", ""),
    ("a constant h", ORBIT, r"\ddot r = \frac{eh^2}{pr^2}\cos\varphi", r"h^2", "h"),
    ("an argument", WAVE, r"y = \frac A2[\sin k(x - ct) + \sin k(x + ct)]", "ct) +", "ct) -"),
    ("small numbers", "$$ S = 10^{-12}n $$ so\n", r"2S = 2\cdot10^{-12}n", r"2\cdot", r"3\cdot"),
    (
        "large numbers",
        "$$ y = (10^7 + x)^2 - 10^{14} $$ so\n",
        r"y - 2\cdot10^7x = x^2",
        "= x",
        "= 2x",
    ),
]
"""A name, what stands above, a line that follows, and what is changed in it to be wrong."""


@pytest.mark.parametrize(
    ("above", "line", "old", "new"), [x[1:] for x in KINDS], ids=[x[0] for x in KINDS]
)
def test_a_line_follows_and_is_told_with_a_slip(above, line, old, new):
    assert line.count(old) == 1
    right = judged(f"{above}\n$$ {line} $$\n")[-1].outcome
    wrong = judged(f"{above}\n$$ {line.replace(old, new)} $$\n")[-1].outcome
    assert (right.passed, wrong.passed) == (True, False)
