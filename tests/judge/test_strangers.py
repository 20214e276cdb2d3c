"""What passed, was condemned or made the judge fail in texts that nobody here wrote, shortened."""

from pathlib import Path

import pytest

from rigidtop.collection import built_in
from rigidtop.commands.notes import audited
from rigidtop.read.project import TextFile

PENDULUM = "The pendulum obeys $m l^2\\ddot\\theta + m g l\\sin\\theta = 0$. "
VARIED = (
    r"Let $\theta = \theta_0 + \delta\theta$ with small $\delta\theta$ and constant $\theta_0$. "
    r"From $$\ddot\theta = W^2\sin\theta\cos\theta - k\sin\theta, \quad "
    r"k\sin\theta_0 = W^2\sin\theta_0\cos\theta_0$$ we get to first order "
)
TURNING = r"It obeys $\dot x = w y$ and $\dot y = -w x$ with a constant $w$. So "
CIRCLE = (
    r"$$m\ddot r = \frac{\ell^2}{m r^3} - \frac{k}{r^n}$$ The circle of radius $a$ has "
    r"$\ddot r = 0$, hence $$\ell^2 = m k a^{3-n}$$ "
    r"Put $r = a + u$ and keep the first order in $u$: "
)
BOOK = (
    r"$$A\dot x = (B - C)yz, \quad B\dot y = (C - A)zx, \quad C\dot z = (A - B)xy$$ "
    r"With small deviations $$x = u, \quad y = n + v, \quad z = w$$ To first order in $u, v, w$ "
    r"$$A\dot u = (B - C)n w, \quad C\dot w = (A - B)n u$$ and "
)
OSCILLATOR = "It obeys $\\ddot x = -\\omega^2 x$. Its solution is "


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        # A new letter that would have to vanish is not brought.
        (
            PENDULUM + r"$$E = \frac12 m l^2\dot\theta^2 - m g l\cos\theta$$ "
            r"$$\dot E = m l^2\dot\theta\ddot\theta + \dot\theta m g l\sin\theta = 7 u\dot\theta$$",
            False,
        ),
        # A bound at the end of a chain is no part of what the chain shows, unless it always holds.
        (r"Let $a = L/I$ and $b = J/I$. $$\frac ab = \frac LJ < 1$$", None),
        (r"Let $a = L/I$ and $b = J/I$. $$\frac ab = \frac LJ > 0$$", True),
        # What is aimed at is not so.
        (r"$$\ddot q = u$$ Our goal is to bring $\dot q = 0$. Then $$u = 0$$", None),
        # One solution, and twice as much with the same letters.
        (
            OSCILLATOR + r"$$x(t) = A\cos\omega t$$ and also $$x(t) = 2 A\cos\omega t$$",
            None,
        ),
        # Where the sides vanish by what stands above, ≈ asks how the one becomes the other.
        (
            r"$$0 = \ddot s + w^2(\sin s\cos f + \cos s\sin f)$$ For small $f$ "
            r"$$w^2(\sin s\cos f + \cos s\sin f) \approx w^2(\sin s + f\cos s)$$",
            True,
        ),
        # What its letter depends on is no link of a chain.
        (
            r"It is on $y = \frac{x^2}{2p}$. $$\mathbf r = x\mathbf i + y\mathbf j$$ "
            r"$$\mathbf r = \mathbf r(q_1, q_2) = x\mathbf i + y\mathbf j$$",
            True,
        ),
        # The zero of a frame is no power: R⁰₁ is not 1.
        (r"The frame obeys $$(R^0_1)^T = 7(R^0_1)^{-1} - 6$$", None),
        # A place that is spoken of in passing says nothing of what comes behind it.
        (r"There is a jump close to $q = 0$. $$f = c\sin q$$ Hence $$f = 7 c\sin q$$", False),
        # In a chain what is new ties what is known: the link behind it does not make it follow.
        (r"$$F = m a$$ For a charge $$F = 7 q v B = 7 B v q$$", None),
        (
            r"$$m\ddot x = -k x, \quad \ddot x + w_0^2 x = 0, \quad w_0^2 = k/m$$ It has "
            r"$$x(t) = E e^{iwt} + E^* e^{-iwt}$$ Or try $c e^{rt}$, so that "
            r"$$\ddot x + w_0^2 x = c r^2 e^{rt} + 5 w_0^2 c e^{rt} = 0$$",
            None,
        ),
        # Nothing is integrated here, so the new letter is a slip of the pen.
        (r"$$m(w + \dot v) = -m g + T$$ so $$\dot v = -g + \frac Sm - w$$", False),
        # What nobody has seen move is constant because it is said to be, not because it follows.
        (r"$$J = \frac12 v^2 - \frac1s$$ The constant $J$ is known.", None),
        # Cases in a list do not hold together.
        (r"There are three: $$c < w, \quad c = w, \quad c > w$$", None),
        # Solved for another letter, it does not show what it comes from; it follows from that.
        (r"$$F = m a \quad\Rightarrow\quad a = F/m$$", True),
        # Of numbers nobody says that they commute.
        (r"Turned about two axes, $$R_a(u) R_b(w) = R_b(w) R_a(u)$$", None),
        # A mass and how it speeds up begin Newton's law as a force does.
        (r"$$F = -k x_0$$ By Newton's law $$m a = m\ddot x = -k x$$", None),
        # What x is at the start may be called x₀.
        (
            r"$$\dot x = -w A\sin wt + w B\cos wt$$ $$x(0) = A$$ "
            r"$$\dot x = w C e^{wt} - w D e^{-wt}$$ $$x(0) = C + D = x_0$$",
            None,
        ),
        # A number that stands alone in its line opens an exercise.
        (
            "1. Free:\n$$L = \\frac12 m\\dot x^2 - m g x, \\quad p = m\\dot x$$\n2. \na. Springs:\n"
            "$$L = \\frac12 m\\dot y^2 - \\frac12 k y^2$$\n$$p = m\\dot y$$\n"
            "$$\\ddot y = \\dot p/m$$\n",
            True,
        ),
        # Letters below each other move as what they are set equal to.
        (
            r"$$\begin{pmatrix} p_x \\ p_y\end{pmatrix} = "
            r"\begin{pmatrix} l\cos q \\ l\sin(q + s)\end{pmatrix}$$ "
            r"$$v = \frac{dP}{dt} = \frac{\partial P}{\partial q}\dot q"
            r" + \frac{\partial P}{\partial s}\dot q$$",
            None,
        ),
        # sec² behind a number is no second.
        (r"$$a = 2\sec^2\dfrac b2$$ So $$a\cos^2\frac b2 = 2$$", True),
        # To first order a slip is told in a display, and δ with a letter is one of its own.
        (VARIED + r"$$\delta\ddot\theta = (W^2\cos 2\theta_0 - k\cos\theta_0)\delta\theta$$", True),
        (
            VARIED + r"$$\delta\ddot\theta = (W^2\sin 2\theta_0 - k\cos\theta_0)\delta\theta$$",
            False,
        ),
        (
            VARIED + r"$$\delta\ddot\theta = (W^2\cos 2\theta_0 + k\cos\theta_0)\delta\theta$$",
            False,
        ),
        # An angle whose sine vanishes may be 0 as well as π.
        (r"We need $\sin\theta_0 = 0$. Below it is $\cos\theta_0 = 1$", None),
        (r"We need $\sin\theta_0 = 0$. Above it is $\cos\theta_0 = -1$", None),
        # What is written with its own start is not what is so at the start.
        (TURNING + r"$$x = x(0)\cos wt + y(0)\sin wt$$", True),
        (TURNING + r"$$x = x(0)\cos wt - y(0)\sin wt$$", False),
        # A rate that words call constant is no coordinate, whatever else is tied to it.
        (
            r"A rod turns at the constant rate $w$. Since $$L = \frac12 m(\dot r^2 + w^2 r^2)$$ "
            r"we have $$\ddot r = w^2 r$$ and, if it starts at $r = a$ with $\dot r = 0$, "
            r"$$r = a\cosh wt$$ It pushes with $$N = 2 m w\dot r = 2 m a w^2\sinh wt$$ and "
            r"$$T = \frac12 m a^2w^2\cosh 2wt$$ so that $$\dot T = N w r$$",
            True,
        ),
        # Where a motion leaves a special one, that is over, and what it said of constants is not.
        (CIRCLE + r"$$m\ddot u = -(3 - n)\frac{\ell^2}{m a^4}u$$", True),
        (CIRCLE + r"$$m\ddot u = -(3 - n)\frac{\ell^2}{m a^3}u$$", False),
        (
            r"$$\ddot\theta = \dot\phi^2\sin\theta\cos\theta - k\sin\theta, \quad "
            r"p = \dot\phi\sin^2\theta = \text{const}$$ On the circle $\theta = \theta_0$ and "
            r"$\dot\phi = W$ for all times. Let $\theta = \theta_0 + u$ with small $u$ and the "
            r"same $p = W\sin^2\theta_0$. To first order $$\ddot u = -W^2(1 + 2\cos^2\theta_0) u$$",
            None,
        ),
        # One that is let go is no other one.
        (
            r"$$\ddot x = 2 c t$$ It is let go at rest, $x = 0$ and $\dot x = 0$ at $t = 0$: "
            r"$$\dot x = c t^2$$ $$x = \frac12 c t^3$$",
            False,
        ),
        # Rounding in one world does not hide in others that a term is as large as what is left out.
        (
            r"$$s = \sqrt{a^2 + y^2}, \quad m\ddot y = -2 k y\left(1 - \frac bs\right)$$ "
            r"For small $y$ $$s\approx a + \frac{y^2}{2 a} - \frac{y^4}{4 a^3}$$",
            False,
        ),
        # A product of two small things is left out; rates of a small motion follow from the rest.
        (BOOK + r"$$B\dot v = 0$$", True),
        (BOOK + r"$$\ddot u = \frac{(B - C)(A - B)}{A C}n^2 u$$", True),
        # The same everywhere is not in general.
        (
            "$$m\\ddot r = m w^2 r - k(r - b)$$\n\n### $k = m w^2$\n\nNow the force is the same "
            "everywhere:\n\n$$\\ddot r = w^2 b$$",
            True,
        ),
        # What a small letter stands for is no special case that ends "in general".
        (
            r"Let $u = a/b^2$ with $u\ll1$. $$\sqrt{1 + u}\approx 1 + \frac u2$$ In general "
            r"$$u b^2 = a$$",
            True,
        ),
        # A zero at the end may be rounded.
        (r"It takes $t = 3.7\cdot 160\ \mathrm s$. $$t\approx 590\ \mathrm s$$", True),
    ],
)
def test_what_becomes_of_the_last_formula(text, expected):
    rows = audited([TextFile(Path("notes.md"), text)], built_in()).findings
    assert rows[-1].record["passed"] is expected, rows[-1].record["note"]


def test_a_sum_over_small_steps_is_no_failure_of_ours():
    text = r"$$W = \sum_{i=0}^{n} F_i\Delta x_i$$ For $n\to\infty$ and $\Delta x_i\to 0$."
    rows = audited([TextFile(Path("notes.md"), text)], built_in()).findings
    assert not any("fails" in row.record["note"] for row in rows)
