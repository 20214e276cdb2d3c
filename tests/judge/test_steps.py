"""Steps that texts of mechanics take: what follows so is told, and what does not is not."""

import pytest

from rigidtop.judge.text import judged

OSCILLATOR = r"$$\ddot x + \omega^2 x = f\cos\nu t$$" "\n"
IMPACT = "$$m u = m v + M w$$\n$$w - v = e u$$\n"
HOOP = (
    r"$$L = \frac12 m a^2(\dot\theta^2 + \Omega^2\sin^2\theta) + m g a\cos\theta$$"
    "\n"
    r"The bead stays at rest if $\ddot\theta = 0$. Either"
    "\n"
)
TUBE = r"$$L = \frac12 m(\dot r^2 + r^2\dot\phi^2) - m g r\cot\alpha$$" "\n"
STEPS = {
    "a derivative along an orbit": (
        r"$$\ell = m r^2\dot\varphi$$" "\n" r"Put $u = \frac1r$. Then" "\n",
        r"$$\dot r = -\frac{\ell}{m}\frac{du}{d\varphi}$$",
        r"$$\dot r = \frac{\ell}{m}\frac{du}{d\varphi}$$",
    ),
    "motions that go together": (
        r"$$m\ddot x = q B\dot y$$"
        "\n"
        r"$$m\ddot y = -q B\dot x$$"
        "\n"
        r"With $\nu = q B/m$ a solution is"
        "\n",
        r"$$x = a\sin\nu t$$",
        r"$$x = a\sin2\nu t$$",
    ),
    "a particular solution": (
        OSCILLATOR + r"At $t = 0$ let $x = 0$ and $\dot x = 0$. A particular solution is" "\n",
        r"$$x = \frac{f}{\omega^2 - \nu^2}\cos\nu t$$",
        r"$$x = \frac{f}{\omega^2 + \nu^2}\cos\nu t$$",
    ),
    "a way at a speed": (
        r"$$m\dot v = -\gamma v$$" "\n" r"$$v = v_0 e^{-\gamma t/m}$$" "\n",
        r"$$x = \frac{m v_0}{\gamma}(1 - e^{-\gamma t/m})$$",
        r"$$x = \frac{m v_0}{2\gamma}(1 - e^{-\gamma t/m})$$",
    ),
    "the speed that is reached": (
        r"$$m\dot v = F - c v^2$$" "\nThe final speed is\n",
        r"$$w = \sqrt{\frac Fc}$$",
        r"$$w = \sqrt{\frac{F}{2 c}}$$",
    ),
    "when something stops": (
        r"$$\dot\omega = -k$$" "\n" r"$$\omega = \omega_0 - k t$$" "\nIt stops after\n",
        r"$$t_1 = \frac{\omega_0}{k}$$",
        r"$$t_1 = \frac{2\omega_0}{k}$$",
    ),
    "a value at a time that has a name": (
        r"$$v = c - g t$$" "\n" r"$$t_1 = \frac{c}{3 g}$$" "\n",
        r"$$v_1 = \frac23 c$$",
        r"$$v_1 = \frac13 c$$",
    ),
    "a kinetic energy": (
        r"$$x = a\sin\theta$$" "\n" r"$$y = -a\cos\theta$$" "\n",
        r"$$T = \frac12 m a^2\dot\theta^2$$",
        r"$$T = m a^2\dot\theta^2$$",
    ),
    "an effective potential": (
        TUBE + r"$$p = m r^2\dot\phi$$"
        "\n"
        r"$$E = \frac12 m\dot r^2 + \frac{p^2}{2 m r^2}"
        r" + m g r\cot\alpha$$"
        "\n",
        r"$$W(r) = \frac{p^2}{2 m r^2} + m g r\cot\alpha$$",
        r"$$W(r) = \frac{p^2}{m r^2} + m g r\cot\alpha$$",
    ),
    "a greatest value": (
        r"$$x = s(1 - \cos\omega t)$$" "\n",
        r"$$x_{\max} = 2 s$$",
        r"$$x_{\max} = 3 s$$",
    ),
    "a least distance": (
        r"$$r = \frac{p}{1 + \varepsilon\cos\phi}$$" "\n",
        r"$$r_1 = \frac{p}{1 + \varepsilon}$$",
        r"$$r_1 = \frac{p}{2 + \varepsilon}$$",
    ),
    "an equation of motion from an energy": (
        r"$$E = \frac12 m l^2\dot\theta^2 - m g l\cos\theta$$" "\nand therefore\n",
        r"$$l\ddot\theta + g\sin\theta = 0$$",
        r"$$l\ddot\theta - g\sin\theta = 0$$",
    ),
    "a force from a potential": (
        r"$$U = \frac12 k(x - y)^2$$" "\n",
        r"$$m\ddot x = -k(x - y)$$",
        r"$$m\ddot x = k(x - y)$$",
    ),
    "an acceleration as a vector": (
        r"$$\mathbf a = -2\boldsymbol\Omega\times\mathbf v$$"
        "\n"
        r"With $\boldsymbol\Omega = (0, 0, \Omega)$, $\mathbf r = (x, y, 0)$ and"
        r" $\mathbf v = (\dot x, \dot y, 0)$"
        "\n",
        r"$$\ddot x = 2\Omega\dot y$$",
        r"$$\ddot x = -2\Omega\dot y$$",
    ),
    "one place of several": (HOOP, r"$$\sin\theta = 0$$", r"$$\cos\theta = 0$$"),
    "another place": (
        HOOP,
        r"$$\cos\theta = \frac{g}{a\Omega^2}$$",
        r"$$\cos\theta = \frac{2 g}{a\Omega^2}$$",
    ),
    "where it begins": (
        r"A pendulum is let go from rest at the angle $\alpha$."
        "\n"
        r"$$E = \frac12 m l^2\dot\theta^2 - m g l\cos\theta$$"
        "\n",
        r"$$E = -m g l\cos\alpha$$",
        r"$$E = -m g l\sin\alpha$$",
    ),
    "a mass that grows": (
        IMPACT + r"Against a wall, $M\to\infty$," "\n",
        "$$v = -e u$$",
        "$$v = -2 e u$$",
    ),
    "equal masses": (IMPACT + "For equal masses\n", r"$$w = \frac{1 + e}{2}u$$", "$$w = e u$$"),
    "a number for what was solved for": (
        IMPACT + "For $e = 1$\n",
        r"$$v = \frac{m - M}{m + M}u$$",
        r"$$v = \frac{m - 2 M}{m + M}u$$",
    ),
    "a letter that tends to another": (
        r"$$y = \frac{\cos\nu t - \cos\omega t}{\omega - \nu}$$"
        "\n"
        r"In the limit $\nu\to\omega$"
        "\n",
        r"$$y = t\sin\omega t$$",
        r"$$y = 2 t\sin\omega t$$",
    ),
    "a limit that is written": (
        r"$$v = c\tanh\frac{g t}{c}$$" "\n",
        r"$$\lim_{t\to\infty} v = c$$",
        r"$$\lim_{t\to\infty} v = 2 c$$",
    ),
    "a function at a place": (
        r"$$\omega^2 = \frac{g s}{k^2 + s^2}$$"
        "\n"
        r"$$\lambda(s) = \frac{g}{\omega^2} = s + \frac{k^2}{s}$$"
        "\n",
        r"$$\lambda(k) = 2 k$$",
        r"$$\lambda(k) = 3 k$$",
    ),
    "what a letter stands for, turned over": (
        r"$$T = \frac{2\pi}{\nu}$$" "\n",
        r"$$\nu T = 2\pi$$",
        r"$$\nu T = \pi$$",
    ),
    "vectors in a plane": (
        r"$$\mathbf e = (\cos\phi, \sin\phi), \qquad \mathbf f = (-\sin\phi, \cos\phi)$$"
        "\n"
        r"$$\dot\phi = w$$"
        "\n",
        r"$$\dot{\mathbf e} = \dot\phi\,\mathbf f$$",
        r"$$\dot{\mathbf e} = -\dot\phi\,\mathbf f$$",
    ),
    "beside a circle": (
        TUBE + r"With $r = r_0 + u$, small $u$ and the same momentum" "\n",
        r"$$\ddot u = -\frac{3 g\cot\alpha}{r_0}\,u$$",
        r"$$\ddot u = -\frac{2 g\cot\alpha}{r_0}\,u$$",
    ),
    "units that stand as words": (
        "Data: $m = 800$ kg and $g = 9.81$ m/s$^2$.\n",
        r"$$F = m g = 7848\ \mathrm{N}$$",
        r"$$F = m g = 784.8\ \mathrm{N}$$",
    ),
    "turns a minute": (
        r"$n = 1800\ \mathrm{min^{-1}}$" "\n",
        r"$$\omega = \frac{2\pi n}{60} = 188.5\ \mathrm{s^{-1}}$$",
        r"$$\omega = \frac{2\pi n}{60} = 377\ \mathrm{s^{-1}}$$",
    ),
    "turns a minute over 30": (
        r"$n = 1800\ \mathrm{min^{-1}}$" "\n",
        r"$$\omega = \frac{\pi n}{30} = 188.5\ \mathrm{s^{-1}}$$",
        r"$$\omega = \frac{\pi n}{30} = 377\ \mathrm{s^{-1}}$$",
    ),
    "metres a minute": (
        r"$s = 60\ \mathrm{m}$ and $t = 1\ \mathrm{min}$" "\n",
        r"$$v = \frac st = 1\ \mathrm{m/s}$$",
        r"$$v = \frac st = 60\ \mathrm{m/s}$$",
    ),
    "a speed in minutes": (
        "",
        r"$$v = 60\ \mathrm{m/min} = 1\ \mathrm{m/s}$$",
        r"$$v = 60\ \mathrm{m/min} = 60\ \mathrm{m/s}$$",
    ),
    "thousands with thin spaces": (
        r"$r = 42\,164\ \mathrm{km}$ and $R = 6378\ \mathrm{km}$" "\n",
        r"$$r - R = 35\,786\ \mathrm{km}$$",
        r"$$r - R = 45\,786\ \mathrm{km}$$",
    ),
    "the usual g": (
        r"$m = 2.0\,\mathrm{kg}$, $h = 5.0\,\mathrm{m}$" "\n" r"$$v = \sqrt{2 g h}$$" "\n",
        r"$$v = 9.9\,\mathrm{m/s}$$",
        r"$$v = 19.8\,\mathrm{m/s}$$",
    ),
}
"""What stands above, then a line that follows and one that does not."""


@pytest.mark.parametrize("name", STEPS)
def test_a_step_is_told_from_a_slip(name):
    above, right, wrong = STEPS[name]
    assert judged(above + right)[-1].outcome.passed is True
    assert judged(above + wrong)[-1].outcome.passed is not True


@pytest.mark.parametrize(
    ("text", "slip"),
    [
        # in the momenta a Hamiltonian is written in, and not in rates
        (r"$$L = \frac12 m(\dot x^2 + \dot y^2) + \frac12 q B(x\dot y - y\dot x)$$" "\n"
         r"$$p_x = m\dot x - \frac12 q B y, \qquad p_y = m\dot y + \frac12 q B x$$" "\n"
         r"$$H = \frac{1}{2 m}[(p_x + \frac12 q B y)^2 + (p_y - \frac12 q B x)^2]$$" "\n"
         r"$$m\ddot y = q B\dot x$$", "another sign"),
        (r"$$D = \frac12(1 - e^2)m u^2$$" "\n" r"$$2 D = m(1 - e)^2 u^2$$", "in place of"),
        (r"$$\gamma T = \Lambda$$" "\n" r"$$T = \frac{2\pi}{\nu}$$" "\n"
         r"Hence $$\gamma T = \frac{2\pi\nu}{\gamma}$$", "in place of"),
        (r"$$\ddot x = 2 w g t$$" "\n" r"At $t = 0$ we have $\dot x = 0$. Then" "\n"
         r"$$\dot x = 2 w g t^2$$", "2"),
        (r"$$x = a\sin\alpha + b\sin\beta$$" "\n" r"$$y = -a\cos\alpha - b\cos\beta$$" "\n"
         r"$$\dot x^2 + \dot y^2 = a^2\dot\alpha^2 + b^2\dot\beta^2"
         r" + 2 a b\dot\alpha\dot\beta\cos(\alpha + \beta)$$", "another sign"),
    ],
)  # fmt: skip
def test_a_slip_is_found(text, slip):
    outcome = judged(text)[-1].outcome
    assert outcome.passed is False
    assert slip in outcome.slip


def test_a_case_in_italics_ends_with_the_next():
    text = r"""*Sliding.* The force is $R = \mu N$.
$$m\ddot x = m g - \mu N$$
*Free fall.* There
$$m\ddot x = m g$$
"""
    assert all(row.outcome.passed is not False for row in judged(text))


def test_rows_of_cases_have_their_conditions():
    text = r"""$$\begin{cases} m\ddot y = -m g, & y > 0, \\ m\ddot y = -m g - k y, & y \le 0.
\end{cases}$$"""
    conditions = [row.statement.conditions for row in judged(text)]
    assert [each[0].relations for each in conditions] == [(">",), ("≤",)]


def test_what_is_written_for_a_letter_is_what_it_stands_for():
    rows = judged(r"I write $A$ for $\lambda_1$ and $n$ for $a + b$. $$2 n = 2 a + 2 b$$")
    assert rows[-1].outcome.passed
    assert len(rows) == 3
