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
TURNED = r"""
$$ \boldsymbol\omega = (0, w\cos\beta, w\sin\beta), \qquad \mathbf v = (\dot x, \dot y, \dot z) $$
The acceleration is $\mathbf c = -2\boldsymbol\omega\times\mathbf v$, in components
$$ c_x = 2w\dot y\sin\beta - 2w\dot z\cos\beta $$
"""
RUBBER = r"""
$$ L = \frac12 m(\dot r^2 + r^2\dot\theta^2) - \frac12 k(r - b)^2 + mgr\cos\theta $$
The equation of motion is
"""
BEATS = r"""
$$ y = \frac a2(\cos w_1 t - \cos w_2 t) $$ or, with $s = \frac12(w_1 + w_2)$ and
$d = \frac12(w_2 - w_1)$,
"""
KINDS = [
    ("a component of a vector", TURNED, r"c_y = -2w\dot x\sin\beta", "= -2", "= 2"),
    (
        "an equation of two terms",
        RUBBER,
        r"r\ddot\theta + 2\dot r\dot\theta + g\sin\theta = 0",
        r"2\dot r\dot\theta +",
        "",
    ),
    ("d that is a letter", BEATS, r"y = a\sin st\sin dt", "= a", "= -a"),
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
    ("a chain behind a remark", r"$b = 2c$ and $a = 3b$ (for $c > 0$) ", "$= 6c$", "6", "5"),
    ("a chain in a display of its own", "$$ a = 3b + 3c $$ or\n", "= 3(b + c)", "b +", "b -"),
    (
        "a root that is expanded to its second term",
        "For a small $a$ we have\n",
        r"\sqrt{b^2 - 4ac} \approx b - \frac{2ac}{b}",
        "2ac",
        "4ac",
    ),
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


@pytest.mark.parametrize(
    "line",
    ["x + 10^{-45}", "x + 20^{-45}", "x + 10^{-2000}", "(1 + 10^{-60})x", r"x + 10^{-60}\sin x"],
)
def test_no_number_is_too_small_to_be_something(line):
    outcome = judged(f"$$ s = x $$ so\n$$ s = {line} $$\n")[-1].outcome
    assert outcome.passed is not True
    assert not outcome.right  # nothing that is as small makes it hold


CUBIC = "$$ s^3 + s = x $$ and $$ s = u^2 + xu $$ so\n"
SWING = r"The equation of motion is $\ddot x = -\frac km x$. Try $x = A\cos\omega t$. Then" + "\n"
ENERGY = (
    r"$$ E = \frac12 mv^2 + \frac12 kx^2, \qquad v = \dot x, \qquad m\ddot x = -kx $$ so" + "\n"
)
DECAY = r"$$ \ddot x + 2\gamma\dot x + \nu^2x = 0 $$ Try $x = e^{\lambda t}$. Then" + "\n"
BESIDE_EXTREMES = [
    (ENERGY, r"\dot E = 10^{-14}", r"10^{14}\dot E = 0"),
    (
        DECAY,
        r"\lambda^2 + 2\gamma\lambda(1 + 10^{-30}) + \nu^2 = 0",
        r"10^9\lambda^2 + 2\cdot10^9\gamma\lambda + 10^9\nu^2 = 0",
    ),
    (
        ORBIT,
        r"\ddot r = \frac{eh^2}{pr^2}\cos\varphi - 10^{-15}r",
        r"10^{10}\ddot r = 10^{10}\frac{eh^2}{pr^2}\cos\varphi",
    ),
    (CUBIC, r"s^3 + s = x\cos 10^{-4}", r"\sin(10^9s^3 + 10^9s) = \sin(10^9x)"),
    (CUBIC, r"s^3 + s = x + \pi^{-10}e^{-10}", r"\frac{10^{20}}{s^3 + s} = \frac{10^{20}}x"),
    (CUBIC, "s^3 + s = x + 10^{-45}", "s^3 + s + 10^{-45} = x + 10^{-45}"),
    (CUBIC, "s^3 + s = x + 10^{-9}", "(s + 10^{-9})^2 = (u^2 + xu)^2 + 2\\cdot10^{-9}s + 10^{-18}"),
    (CUBIC, "s^3 + 2s = x + u^2 + xu(1 + 10^{-9})", "10^9s^3 + 10^9s = 10^9x"),
    (CUBIC, "s^3 + s = x + e^{-50}", "e^{-50}(s^3 + 2s) = e^{-50}(x + u^2 + xu)"),
    (CUBIC, "s^3 + s = x + 10^{-2000}", "10^{-30}s = 10^{-30}u^2 + 10^{-30}xu"),
    (SWING, r"\omega^2 = \frac km + 10^{-9}", r"\omega^2 + 10^{-9} = \frac km + 10^{-9}"),
    (SWING, r"\omega^2 = \frac km(1 + 10^{-9})", r"10^9m\omega^2 = 10^9k"),
    ("$$ y = x $$ so\n", "y = (1 + 10^{-9})x", "10^9y + y = 10^9x + x"),
    (
        "$$ x^2 = a^2 + b $$ so\n",
        r"x = \pm\sqrt{a^2 + b + 10^{-9}}",
        r"x = \pm10^{-9}\sqrt{10^{18}a^2 + 10^{18}b}",
    ),
    (
        r"$$ \epsilon = 10^{-9}, \qquad s^3 + s = x, \qquad s = u^2 + xu $$ so" + "\n",
        r"s^3 + s = x + \epsilon",
        r"s^3 + s + \epsilon = x + 10^{-9}",
    ),
    (
        "$$ s^3 + s = x + 10^{-9} $$ and $$ s = u^2 + xu $$ so\n",
        "s^3 + s = x",
        "s^3 + 2s = x + u^2 + xu + 10^{-9}",
    ),
]
"""What stands above, a line that is wrong by nothing that is seen, and one that is right."""


@pytest.mark.parametrize(("above", "wrong", "right"), BESIDE_EXTREMES)
def test_no_number_is_too_small_where_equations_hold(above, wrong, right):
    assert judged(f"{above}$$ {wrong} $$\n")[-1].outcome.passed is not True
    assert judged(f"{above}$$ {right} $$\n")[-1].outcome.passed


def test_what_takes_too_many_digits_is_said_to_be_unseen():
    outcome = judged(f"{CUBIC}$$ s^3 + s = x + 10^{{-2000}} $$\n")[-1].outcome
    assert outcome.why == "a number in it is too small or too large to be seen beside the rest"


@pytest.mark.parametrize("above", [r"y = \pi x", r"y = \pi x, \qquad x = u^3 + yu"])
@pytest.mark.parametrize(
    "line",
    [
        "y = 3.14159265358979x",
        r"10^{-12}y = 3.14159265358979\cdot10^{-12}x",
        r"\frac y3 = 1.0471975511966x",
        "y = 3.141592653x",
    ],
)
def test_a_rounded_number_stays_one_where_small_ones_stand(above, line):
    assert judged(f"$$ {above} $$ so\n$$ {line} $$\n")[-1].outcome.passed


@pytest.mark.parametrize("line", ["y = 3.14159265358979x", r"y \approx 3.1415927x"])
def test_a_number_is_as_good_as_it_is_written(line):
    assert judged(f"$$ y = \\pi x $$ so\n$$ {line} $$\n")[-1].outcome.passed


FLIGHT = r"A shot has $$ \dot y = u - gt. $$ At the highest point $\dot y = 0$. There" + "\n"
HOLLOW = r"""
The potential is $U = ax^4 - bx^2$. In equilibrium $\frac{dU}{dx} = 0$, so
$$ x^2 = \frac{b}{2a} $$ For any $x$
"""
SPHERE = r"""
$$ v^2 = 2gR(1 - \cos\theta) $$ and the normal force is
$$ N = mg\cos\theta - \frac{mv^2}{R}. $$ The ball leaves the sphere when $N = 0$, that is
$$ \cos\theta = \frac23. $$ While it slides
$$ \dot v = g\sin\theta. $$
"""
ROD = r"""
$$ \omega^2 = \frac{3g}{l}(1 - \cos\theta) $$ For $\theta = \pi$
$$ \omega = \sqrt{\frac{6g}{l}} $$ and $\dot\omega = \frac{3g}{2l}\sin\theta$. In general
"""
SPRING = r"""
$$ E = \frac12 mv^2 + \frac12 kx^2. $$ Half way, $x = A/2$,
$$ v^2 = \frac{2E}{m} - \frac{kA^2}{4m}. $$ At every point
"""
SLOW = r"""
$$ E = \frac12 m\omega^2A^2, \qquad \omega = \sqrt{k/m}. $$
The quantity $J = E/\omega$ stays constant while it goes from $k_1$ to $k_2$. Then
"""
DROPS = r"With $\dot m = kmv$ and $$ m\dot v + \dot mv = mg $$ one solution is" + "\n"
BEAD = r"A bead has $$ L = \frac12 m(\dot r^2 + r^2\omega^2). $$ Its energy is" + "\n"
DISC = (
    r"$\alpha^2\dot\alpha = -\kappa$. From the start $\alpha = \alpha_0$ at $t = 0$ we find" + "\n"
)
ELSEWHERE = {
    "after the highest point": FLIGHT
    + r"$$ t = \frac ug. $$ During the whole flight $$ \dot y = 0 $$",
    "for any place": HOLLOW + r"$$ \frac{d^2U}{dx^2} = 4b $$",
    "before it leaves": SPHERE + r"$$ v^2 = gR\cos\theta $$",
    "at other angles": ROD + r"$$ \omega^2 = \frac{6g}{l} $$",
    "at every point": SPRING + r"$$ x = \frac A2 $$",
    "what is not conserved": SLOW + r"$$ \omega_2 = \omega_1 $$",
    "with a mass that may not vanish": DROPS + r"$$ v = \frac12gt $$",
    "after the start": DISC + r"$$ \alpha^3 = \alpha_0^3 - \frac13\kappa t $$",
}
"""Texts of which the last line is wrong, and would be right somewhere else."""


@pytest.mark.parametrize("text", ELSEWHERE.values(), ids=ELSEWHERE)
def test_what_holds_somewhere_does_not_hold_in_general(text):
    assert judged(text)[-1].outcome.passed is not True


def test_the_energy_of_what_is_turned_need_not_be_that_of_jacobi():
    line = r"$$ E = \frac12 m(\dot r^2 + r^2\omega^2) $$"
    assert judged(BEAD + line)[-1].outcome.passed is not False


def test_a_line_that_says_what_a_wrong_one_says_is_wrong_too():
    text = r"$$ L = \frac12ml^2\dot\phi^2 - mgl\cos\phi $$ so $$ ml^2\ddot\phi + mgl\sin\phi = 0 $$"
    rows = judged(text + r" or $$ \ddot\phi = -\frac gl\sin\phi $$")
    assert [row.outcome.passed for row in rows[1:]] == [False, False]


def test_a_sum_is_not_told_by_how_many_particles_are_taken():
    text = r"$$ \mathbf F_{ij} + \mathbf F_i = \dot{\mathbf p}_i $$ Added, $$ \sum_{i\ne j}"
    text += r"\mathbf F_{ij} + \sum_i\mathbf F_i = \sum_i\dot{\mathbf p}_i $$"
    assert judged(text)[-1].outcome.passed is None


def test_a_prime_may_be_a_rate():
    text = r"$$ \frac{dx}{dt} = 2 - x $$ We let $u = x + 3$. Then "
    assert judged(text + "$$ u' = 5 - u $$")[-1].outcome.passed
    assert not judged(text + "$$ u' = 4 - u $$")[-1].outcome.passed


def test_a_force_of_friction_acts_beside_energies():
    text = r"$V=\frac12kx^2$ and $K=\frac12m\dot x^2$, with $$E=K+V.$$ There is a force "
    text += (
        r"$F_v=-c\dot x$. The equation of motion is $$ \ddot x+\frac{c}{m}\dot x+\frac km x=0 $$"
    )
    assert judged(text)[-1].outcome.passed
    assert judged(text.replace("{c}{m}", "{2c}{m}"))[-1].outcome.passed is False
