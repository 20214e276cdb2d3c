"""What equations say of quantities: tensions, frequencies, velocities in time, averages, slopes."""

import pytest

from rigidtop.judge.text import judged

BUCKET = r"""
A bucket hangs from a drum: $$ m\ddot x = m g - S $$ $$ J\dot\omega = r S $$
The rope unwinds, $\dot x = r\omega$. It carries
"""
POINTER = (
    r"The pointer of an instrument obeys $$ J\ddot\varphi = -D\varphi - c\varphi $$ and swings with"
    + "\n"
)
BAR = r"""
A bar in an orbit swings: $$ \ddot\vartheta = -3n^2\sin\vartheta\cos\vartheta. $$
For small $\vartheta$ $$ \ddot\vartheta \approx -3n^2\vartheta. $$ The frequency is
"""
PEBBLE = r"""
A pebble sinks: $$ m\ddot y = m g - \kappa\dot y, \qquad \dot y(0) = 0. $$ With $\tau = m/\kappa$
"""
VIRIAL = r"""
The virial theorem says $2\langle T\rangle = n\langle V\rangle$. The energy is
$$ E = \langle T\rangle + \langle V\rangle. $$ Hence
"""
LOAD = r"""
At the distance $d$ from the end $J_0 = M d^2$, and with a load $$ J = J_0 + 2Mdx + mx^2. $$
For $x = 2d$
"""
MOMENTA = r"""
With $\{x, p_x\} = 1$ and so on, $$ L_x = y p_z - z p_y, \qquad L_y = z p_x - x p_z. $$ Hence
"""
WIND = r"""
Along a front
$$ \rho f v = \frac{\partial p}{\partial x}, \qquad \rho f u = -\frac{\partial p}{\partial y} $$
and therefore
"""
SQUARES = r"$$ c^2 = a^2 + (\gamma B)^2 $$ so" + "\n"
MASSES = r"$$ p = (m + M)v $$ so" + "\n"
FALL = r"$$ (v + u)^2 = 2 g h $$ so" + "\n"
KINDS = [
    ("a tension", BUCKET, r"S = m g\frac{J}{J + m r^2}", "{J}", "{m r^2}", "J in place of m r²"),
    ("a frequency", POINTER, r"\omega_1^2 = \frac{D + c}{J}", "+", "-", "another sign before c"),
    ("a small swing", BAR, r"\omega = \sqrt3n", r"\sqrt3", "3", "the root of 3"),
    (
        "averages",
        VIRIAL,
        r"\langle T\rangle = \frac{n E}{n + 2}",
        "+",
        "-",
        "another sign before 2",
    ),
    ("a distance d", LOAD, r"J = 5M d^2 + 4m d^2", "5M", "3M", "5 in place of 3"),
    ("a bracket", MOMENTA, r"\{p_x, L_y\} = p_z", "p_z", "p_y", "p_z in place of p_y"),
    ("a square", SQUARES, r"a^2 = c^2 - (\gamma B)^2", r"(\gamma B)^2", r"\gamma B", "γ B squared"),
    ("masses", MASSES, r"v = \frac{p}{m + M}", "m + M", "M", "m + M in place of M"),
    ("a root", FALL, r"v + u = \sqrt{2 g h}", r"\sqrt{2 g h}", "2 g h", "the root of it"),
]
"""A name, what stands above, a line that follows, what is changed in it, and what is told then."""


@pytest.mark.parametrize(
    ("above", "line", "old", "new", "slip"), [x[1:] for x in KINDS], ids=[x[0] for x in KINDS]
)
def test_a_quantity_follows_and_is_told_with_a_slip(above, line, old, new, slip):
    assert line.count(old) == 1
    right = judged(f"{above}$$ {line} $$\n")[-1].outcome
    wrong = judged(f"{above}$$ {line.replace(old, new)} $$\n")[-1].outcome
    assert (right.verdict, wrong.verdict, wrong.slip) == ("sampled", "false", slip)


def test_a_tie_of_accelerations_is_supposed():
    rows = judged(r"$$ ma = T - f $$ $$ J\beta = Tr + fR $$ They obey $$ a = R\beta $$")
    assert [row.outcome.verdict for row in rows] == ["premise"] * 3


VELOCITY = r"$$ \dot y = g\tau(1 - e^{-t/\tau}) $$"


@pytest.mark.parametrize(("old", "new"), [("{-t", "{t"), (r"g\tau", r"\frac12g\tau")])
def test_a_velocity_in_time_solves_an_equation_of_motion(old, new):
    right = judged(PEBBLE + VELOCITY)[-1].outcome
    wrong = judged(PEBBLE + VELOCITY.replace(old, new))[-1].outcome
    assert (right.verdict, right.why) == ("sampled", "it solves what stands above")
    assert wrong.passed is not True


SLOPE = r"$$ u\frac{\partial p}{\partial x} + v\frac{\partial p}{\partial y} = 0 $$"


def test_a_slope_follows_from_others_of_the_same_field():
    assert judged(WIND + SLOPE)[-1].outcome.verdict == "sampled"
    wrong = judged(WIND + SLOPE.replace("+", "-"))[-1].outcome
    assert (wrong.verdict, wrong.passed) == ("premise", None)


@pytest.mark.parametrize("angle", [r"\varphi", r"\delta"])
def test_a_torque_is_greatest_at_some_angle_whatever_that_is_called(angle):
    text = rf"$$ B = m g l\cos{angle}. $$ At most it is $$ B_{{\max}} = m g l $$"
    outcome = judged(text)[-1].outcome
    assert (outcome.passed, outcome.why) == (True, "it is an extreme value of B")


@pytest.mark.parametrize("angle", [r"\varphi", r"\psi"])
def test_an_angle_goes_with_an_action_whatever_it_is_called(angle):
    functions = rf"$$ f = I^2\cos{angle}, \qquad h = {angle} I. $$"
    text = rf"{functions} $$ \{{f, h\}} = -I^2{angle}\sin{angle} - 2I^2\cos{angle} $$"
    assert judged(text)[-1].outcome.passed
