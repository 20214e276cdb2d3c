"""What words say of a formula: where it holds, what vanishes there, what is only supposed."""

import pytest

from rigidtop.judge.text import judged

BOWL = r"""
The pressing force of a cube in a bowl is
$$ N = m g\cos\theta - \frac{m v^2}{b}, \qquad v^2 = 2 g b(1 - \cos\theta). $$
"""
SPOOL = r"""
A thread pulls a spool: $$ m a = F\cos\beta - f, \qquad J\frac aR = f R - F q, \qquad J = k m R^2 $$
so that $$ a = \frac{F(R\cos\beta - q)}{m R(1 + k)}. $$
"""
MOTOR = r"La puissance est $$ P = F v - c v^3. $$" + "\n"
BEAM = r"The moment in a beam is $$ B = p x(b - x) F. $$" + "\n"
HOOP = r"""
A hoop on a ramp has $$ M a = M g\sin\gamma - F, \qquad M R^2\beta = F R $$
and there is no slip, so $a = R\beta$. Thus
"""
PULL = r"""
The work is $$ W = F s\cos\alpha. $$

{level} For $\alpha = 0$ $$ W = F s. $$

{slant} At a slant
"""
STARRED = PULL.format(level="*(a)*", slant="*(b)*")
NUMBERED = PULL.format(level=r"\emph{(i)}", slant=r"\emph{(ii)}")
COMET = r"""
A comet has $r^2\dot\varphi = h$, and with its perihelion at $\varphi = 0$,
$$ u = A(1 + e\cos\varphi). $$ Hence
"""
THREAD = r"""
When $\varphi$ has been unwound, $$ s = l - a\varphi, \qquad v = s\dot\varphi. $$ Hence
"""
WHEEL = (
    r"The wheel obeys $J\ddot\varphi = b$. At the start $\varphi = 0$, $\dot\varphi = w$, so" + "\n"
)
STICK = r"A stick is hit. Afterwards $$ J\omega_0 = P(h - R). $$ For $h = R$" + "\n"
BALL = r"""
$$ v = v_0 - \mu g t, \qquad \omega = \frac{5\mu g}{2R}t $$
The ball stops sliding when $v = R\omega$, at the time
"""
STOPPED = BALL + r"$$ t_1 = \frac{2v_0}{7\mu g}; $$ the speed is then" + "\n"
LIST = r"""
The acceleration follows from

1. $T - f = m a$
2. $T r + f R = J\beta$
3. $a - R\beta = 0$

Hence
"""

TOLD = [
    ("without slip", HOOP, r"a = \frac12 g\sin\gamma", r"\sin", r"\cos", "sin in place of cos"),
    ("a place", COMET, r"\dot u = -A e\dot\varphi\sin\varphi", "-", "", "another sign"),
    (
        "any angle",
        THREAD,
        r"\dot v = s\ddot\varphi - a\dot\varphi^2",
        "-",
        "+",
        "another sign before a φ̇²",
    ),
    (
        "a start",
        WHEEL,
        r"J\dot\varphi^2 = J w^2 + 2b\varphi",
        "+",
        "-",
        "another sign before 2 b φ",
    ),
    (
        "a list",
        LIST,
        r"a = \frac{T R(R + r)}{m R^2 + J}",
        "R + r",
        "R - r",
        "another sign before r",
    ),
]
"""A name, what stands above, a line that follows, what is changed in it, and what is told then."""


@pytest.mark.parametrize(
    ("above", "line", "old", "new", "slip"), [x[1:] for x in TOLD], ids=[x[0] for x in TOLD]
)
def test_a_line_follows_where_words_say_and_is_told_with_a_slip(above, line, old, new, slip):
    assert line.count(old) == 1
    right = judged(f"{above}$$ {line} $$\n")[-1].outcome
    wrong = judged(f"{above}$$ {line.replace(old, new)} $$\n")[-1].outcome
    assert (right.verdict, wrong.verdict, wrong.slip) == ("sampled", "false", slip)


PLACES = [
    (
        "a force is zero",
        BOWL,
        r"The cube leaves the bowl when this force is zero, i.e. at $\cos\theta = \frac23$.",
        r"\frac23",
        r"\frac13",
    ),
    ("it does not roll", SPOOL, r"It does not roll at all if $\cos\beta = q/R$.", "q/R", "R/q"),
    ("in French", MOTOR, r"Ceci s'annule si $F = c v^2$.", "c v", "2c v"),
    ("greatest", BEAM, r"It is greatest for $x = \frac b2$.", "b2", "b3"),
    ("in a part with stars", STARRED, r"$$ W = F s\cos\alpha $$", r"\cos\alpha", ""),
    ("in a part with roman numbers", NUMBERED, r"$$ W = F s\cos\alpha $$", r"\cos\alpha", ""),
    ("a hit at the centre", STICK, r"$$ J\omega_0 = 0 $$", "= 0", "= P R"),
    ("when it stops", BALL, r"$$ t_1 = \frac{2v_0}{7\mu g} $$", "2v_0", "5v_0"),
    ("how fast it is then", STOPPED, r"$$ v_1 = \frac57 v_0 $$", "57", "27"),
]
"""The same of lines that, with the change, may be another place's: they only must not pass."""


@pytest.mark.parametrize(
    ("above", "line", "old", "new"), [x[1:] for x in PLACES], ids=[x[0] for x in PLACES]
)
def test_a_place_follows_from_what_the_words_say_of_it(above, line, old, new):
    assert line.count(old) == 1
    right = judged(f"{above}{line}\n")[-1].outcome
    wrong = judged(f"{above}{line.replace(old, new)}\n")[-1].outcome
    assert right.passed is True
    assert wrong.passed is not True


def test_rolling_without_slip_is_supposed_although_it_says_so():
    outcome = judged(HOOP)[-1].outcome
    assert (outcome.verdict, outcome.why) == ("premise", "a special case")


def test_what_a_letter_is_set_to_is_no_frequency():
    rows = judged(r"$$ m\ddot x = -2kx $$ With $\omega_0^2 = k/m$ $$ \ddot x = -2\omega_0^2x $$")
    assert [row.outcome.verdict for row in rows] == ["premise", "premise", "sampled"]


def test_at_a_place_a_rate_has_a_value_too():
    text = r"""
$$ \dot\phi^2 = \frac{2g}l(\cos\phi - \cos\phi_0). $$
At $\phi = 0$ it is $$ \dot\phi^2 = \frac{2g}l(1 - \cos\phi_0) $$
"""
    assert judged(text)[-1].outcome.passed


def test_a_measured_speed_is_no_other_speed():
    text = r"""
A car has
$$ g = 9.8\ \mathrm{m/s^2}, \quad r = 12\ \mathrm m, \quad \mu = 0.5, \quad v = 6\ \mathrm{m/s}. $$
At the limit $$ v = \sqrt{\mu g r}. $$
"""
    outcome = judged(text)[-1].outcome
    assert (outcome.verdict, outcome.why) == ("definition", "v is used again")


def test_a_measured_number_that_comes_again_is_another_one_only_where_words_take_it():
    given = r"A rod has the moment $J = 4\,\mathrm{kg\,m^2}$. "
    taken = judged(given + r"We now take $$ J = 9\,\mathrm{kg\,m^2} $$")[-1].outcome
    assert (taken.verdict, taken.why) == ("definition", "J is used again")
    stated = judged(given + r"As stated above, $$ J = 9\,\mathrm{kg\,m^2} $$")[-1].outcome
    assert (stated.verdict, stated.why) == ("false", "the left side is 4 kg m²")


ROTOR = r"A rotor has the moment $J = 4\,\mathrm{kg\,m^2}$. "
STATED = [
    r"As has been said before, its moment is $J = 11$ kg m².",
    r"The moment still amounts to $J = 11$ kg m².",
    r"Das Trägheitsmoment beträgt, wie gesagt, $J = 11$ kg m².",
]
TAKEN = [
    r"Suppose $J = 11$ kg m².",
    r"Now with $J = 11$ kg m² it is slower.",
    r"For $J = 11$ kg m² it is slower.",
    r"Another rotor has $J = 11$ kg m².",
    r"Loaded it has $J = 11$ kg m².",
    r"Ein anderer Rotor hat $J = 11$ kg m².",
    "\n\n**Example 2.** The moment amounts to $J = 11$ kg m².",
]


@pytest.mark.parametrize("line", STATED)
def test_a_measured_number_in_a_sentence_may_not_contradict_the_one_above(line):
    first, *_, last = judged(ROTOR + line)
    assert (last.outcome.verdict, last.outcome.slip) == ("false", "another number")
    assert last.outcome.why == "the left side is 4 kg m²"
    assert last.outcome.rests_on == {first.number}


@pytest.mark.parametrize("line", TAKEN)
def test_a_measured_number_in_a_sentence_is_another_one_where_words_take_it(line):
    outcome = judged(ROTOR + line)[-1].outcome
    assert (outcome.verdict, outcome.why) == ("definition", "J is used again")


def test_a_measured_speed_is_another_one_later_on():
    outcome = judged(r"A car goes at $v = 20$ m/s. It brakes to $v = 5$ m/s.")[-1].outcome
    assert (outcome.verdict, outcome.why) == ("definition", "v is used again")


def test_a_measured_number_is_another_one_in_a_new_exercise():
    other = "\n\n## Exercise 2\n\nThe moment amounts to $J = 11$ kg m²."
    outcome = judged(f"## Exercise 1\n\n{ROTOR}{other}")[-1].outcome
    assert (outcome.verdict, outcome.why) == ("definition", "J is used again")
