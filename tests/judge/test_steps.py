"""Steps that texts of mechanics take: what follows so is told, and what does not is not."""

import pytest

from rigidtop.judge.text import judged

OSCILLATOR = r"$$\ddot x + \omega^2 x = f\cos\nu t$$" "\n"
IMPACT_OF_TWO = r"""$$m v = m a + M b$$
$$\frac12 m v^2 = \frac12 m a^2 + \frac12 M b^2$$
"""
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
    "without what is excluded": (
        IMPACT_OF_TWO + "Apart from $b = 0$ the only solution is\n",
        r"$$a = \frac{m - M}{m + M}v$$",
        r"$$a = \frac{m + M}{m - M}v$$",
    ),
    "what comes out may be negative": (
        IMPACT_OF_TWO
        + "Apart from $b = 0$ the only solution is\n"
        + r"$$a = \frac{m - M}{m + M}v$$"
        + "\nFor $M = 3 m$\n",
        r"$$a = -\frac12 v$$",
        r"$$a = -\frac13 v$$",
    ),
    "a limit of what has been found": (
        IMPACT_OF_TWO
        + "Apart from $b = 0$\n"
        + r"$$b = \frac{2 m}{m + M}v$$"
        + "\n"
        + r"For $M\to\infty$"
        + "\n",
        r"$$b \to 0$$",
        r"$$b \to v$$",
    ),
    "the time at which something is so": (
        r"$$v = v_0 - b t$$" "\n" r"$$w = c t$$" "\n" "They are alike when $v = w$, at the time\n",
        r"$$\tau = \frac{v_0}{b + c}$$",
        r"$$\tau = \frac{v_0}{b - c}$$",
    ),
    "what was left open": (
        r"$$e = \frac12 v^2 - \frac{k}{r}$$" "\n" "On the whole\n" r"$$v^2 r = q$$" "\n",
        r"$$e = \frac{q}{2 r} - \frac kr$$",
        r"$$e = \frac{q}{r} - \frac kr$$",
    ),
    "a balance": (
        r"$$e = \frac12 v^2 - \frac{k}{r}$$"
        "\n"
        "The attraction is just what the circle needs,\n"
        r"$$\frac{v^2}{r} = \frac{k}{r^2}$$"
        "\n",
        r"$$e = -\frac{k}{2 r}$$",
        r"$$e = \frac{k}{2 r}$$",
    ),
    "indices": (
        r"$$F = 6\pi\eta r v$$"
        "\n"
        r"$$F = \rho r^3$$"
        "\nHence\n"
        r"$$v = \frac{\rho r^2}{6\pi\eta}$$"
        "\nFor two with $r_2 = 3 r_1$\n",
        r"$$\frac{v_2}{v_1} = 9$$",
        r"$$\frac{v_2}{v_1} = 3$$",
    ),
    "a value in a case": (
        r"$$v^2 = k\left(\frac2r - \frac1a\right)$$" "\n" "On the first circle $a = r = r_1$, so\n",
        r"$$v_1 = \sqrt{\frac{k}{r_1}}$$",
        r"$$v_1 = \sqrt{\frac{2 k}{r_1}}$$",
    ),
    "the time of a turn": (
        r"$$L = \frac12 m r^2\dot\phi^2 - V$$"
        "\n"
        r"$$\dot\phi^2 = \frac gs$$"
        "\nOne turn takes\n",
        r"$$\tau = 2\pi\sqrt{\frac sg}$$",
        r"$$\tau = \pi\sqrt{\frac sg}$$",
    ),
    "where arms keep their angle": (
        r"$$L = \frac12 m a^2(\dot\theta^2 + \Omega^2\sin^2\theta) + m g a\cos\theta$$"
        "\n"
        r"If the arms keep their angle and do not hang down ($\sin\theta \ne 0$),"
        "\n",
        r"$$\cos\theta = \frac{g}{a\Omega^2}$$",
        r"$$\cos\theta = \frac{2 g}{a\Omega^2}$$",
    ),
    "the speed on a path": (
        r"$$x = u t, \qquad y = w t - \frac12 g t^2$$" "\nIts speed is\n",
        r"$$v = \sqrt{u^2 + (w - g t)^2}$$",
        r"$$v = \sqrt{u^2 + (w + g t)^2}$$",
    ),
    "a kinetic energy alone": (
        r"$$T = \frac12 m(\dot r^2 + \Omega^2 r^2)$$" "\n",
        r"$$\ddot r = \Omega^2 r$$",
        r"$$\ddot r = \frac{F}{m}r$$",
    ),
    "a rule for the other coordinate": (
        r"$$L = \frac12 m\dot x^2 + \frac12 n\dot y^2, \qquad F = \frac12 c(\dot x - \dot y)^2$$"
        "\n"
        r"$$\frac{d}{dt}\frac{\partial L}{\partial\dot x} - \frac{\partial L}{\partial x}"
        r" = -\frac{\partial F}{\partial\dot x}$$"
        "\nand the same for $y$, which means\n",
        r"$$n\ddot y = c(\dot x - \dot y)$$",
        r"$$n\ddot y = -c(\dot x - \dot y)$$",
    ),
    "rates at a place": (
        r"$$\tan\beta = \cos\delta\tan\alpha$$"
        "\n"
        r"$$\dot\beta = q$$"
        "\n"
        r"At $\alpha = 0$"
        "\n",
        r"$$\dot\beta = \dot\alpha\cos\delta$$",
        r"$$\dot\beta = \dot\alpha\sin\delta$$",
    ),
    "from rest at the origin": (
        r"$$m\ddot y = -q B\dot x$$" "\nIf the charge starts from rest at the origin, this gives\n",
        r"$$\dot y = -\frac{q B}{m}x$$",
        r"$$\dot y = \frac{q B}{m}x$$",
    ),
    "on a circle": (
        r"$$W = \frac{D^2}{2 m r^2} + c r^4$$"
        "\n"
        r"$$W' = -\frac{D^2}{m r^3} + 4 c r^3$$"
        "\n"
        "On a circle of radius $R$ we have $W' = 0$, that is\n",
        r"$$D^2 = 4 m c R^6$$",
        r"$$D^2 = 2 m c R^6$$",
    ),
    "a time as a number": (
        r"Within $t = 30\ \mathrm{s}$ it goes $s = 60\ \mathrm{m}$." "\n",
        r"$$\frac st = 2\ \mathrm{m/s}$$",
        r"$$\frac st = 3\ \mathrm{m/s}$$",
    ),
    "rolling behind the equations of motion": (
        r"$$m\ddot x = F - f, \qquad J\ddot\varphi = f R - F r$$"
        "\nNo slipping means\n"
        r"$$\dot x = R\dot\varphi$$"
        "\n",
        r"$$\ddot x = \frac{F R(R - r)}{J + m R^2}$$",
        r"$$\ddot x = \frac{F R(R + r)}{J + m R^2}$$",
    ),
    "gears behind the equations of motion": (
        r"$$J_1\dot\omega_1 = M - F r_1, \qquad J_2\dot\omega_2 = F r_2$$"
        "\n"
        r"$$r_1\omega_1 = r_2\omega_2$$"
        "\n",
        r"$$J_1\dot\omega_1 + J_2\frac{r_1}{r_2}\dot\omega_2 = M$$",
        r"$$\dot\omega_1 = \frac{M}{J_1}$$",
    ),
    "a momentum that is named": (
        r"$$L = \frac12 m(\dot r^2 + r^2\dot\phi^2) - V$$" "\nThe angle does not occur, and\n",
        r"$$D = m r^2\dot\phi$$",
        r"$$D = m r\dot\phi$$",
    ),
    "an entry of a matrix": (
        r"$$K = \begin{pmatrix} a & 2 b \\ 2 b & c \end{pmatrix}$$" "\n",
        r"$$K_{12} = 2 b$$",
        r"$$K_{12} = -2 b$$",
    ),
    "a root where its sign is not said": (
        r"It steers upstream by $\alpha$ with $\sin\alpha = \frac cv$." "\n",
        r"$$\cos\alpha = \sqrt{1 - \frac{c^2}{v^2}}$$",
        r"$$\cos\alpha = \sqrt{1 + \frac{c^2}{v^2}}$$",
    ),
    "the amplitude of a trial": (
        r"$$M\ddot x + k x = F\sin\Omega t$$"
        "\n"
        r"In the steady state $x = X\sin\Omega t$ with"
        "\n",
        r"$$X = \frac{F}{k - M\Omega^2}$$",
        r"$$X = \frac{F}{k + M\Omega^2}$$",
    ),
    "a case in which another solution is singular": (
        r"$$\ddot x + \omega^2 x = f\cos\nu t,$$"
        "\n"
        r"and at $t = 0$ it is at rest, $x = 0$ and $\dot x = 0$."
        "\n\n1. "
        r"$\nu \ne \omega$. The solution is "
        r"$$x = \frac{f}{\omega^2 - \nu^2}(\cos\nu t - \cos\omega t)$$"
        "\n\n2. "
        r"$\nu = \omega$. The amplitude grows: ",
        r"$$x = \frac{f t}{2\omega}\sin\omega t$$",
        r"$$x = \frac{f t}{\omega}\sin\omega t$$",
    ),
    "the greatest value is not the least": (
        r"$$r = \frac{p}{2 + \cos\phi}$$" "\n",
        r"$$r_{\max} = p$$",
        r"$$r_{\max} = \frac p3$$",
    ),
    "when it turns, and not when it is back": (
        r"$$y = w t - \frac12 g t^2$$" "\nIt is at the highest point after\n",
        r"$$\tau = \frac wg$$",
        r"$$\tau = \frac{2 w}{g}$$",
    ),
    "no way from elsewhere": (
        r"$$v = c - b t$$" "\nIt goes on from there:\n",
        r"$$x = c t - \frac12 b t^2$$",
        r"$$x = c t - b t^2$$",
    ),
    "what holds under the opposite condition": (
        r"Moving to the left, $\dot x < 0$:"
        "\n"
        r"$$m\ddot x = -k x + R$$"
        "\n"
        r"Now to the right, $\dot x > 0$:"
        "\n"
        r"$$m\ddot x = -k x - R$$"
        "\n",
        r"$$\ddot x = -\frac{k x + R}{m}$$",
        r"$$\ddot x = -\frac{k x - R}{m}$$",
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
        # the rate of what stands alone on a side
        (r"$$y = a(1 - \cos\theta)$$" "\n" r"$$\dot y = a\dot\theta\cos\theta$$", "sin"),
        # what is given in time, at a time that is known
        (r"$$v = c - g t$$" "\n" r"$$\tau = \frac{c}{3 g}$$" "\n" r"$$v(\tau) = \frac13 c$$",
         "times as much"),
        (r"$$m = n - \mu t$$" "\n" r"$$m\dot v = \mu u - m g$$" "\n"
         r"From the start, $v = 0$ at $t = 0$:" "\n" r"$$v = u\ln\frac{n}{n - \mu t}$$", "−g t"),
        # a force from a potential where nothing has a mass
        (r"$$V = \frac12 x^2 + x^2 y$$" "\n" r"$$\ddot x = -x - x y$$", "2 times"),
        # a term of amplitudes
        (r"$$M\ddot x = -K x - k(x - y) + F\cos\Omega t$$" "\n" r"$$m\ddot y = -k(y - x)$$" "\n"
         r"We try $x = X\cos\Omega t$, $y = Y\cos\Omega t$. This gives" "\n"
         r"$$(K - M\Omega^2)X - k Y = F$$", "the term"),
        (r"$$K = \begin{pmatrix} a & b \\ b & c \end{pmatrix}$$" "\n" r"$$K_{12} = -b$$",
         "another sign"),
        (r"$$z = x - u$$" "\n" r"$$m\ddot x = -k z$$" "\n" r"$$\ddot x = \ddot z - \ddot u$$",
         "sign"),
        # what would hold all still is no law
        (r"$$x + 2 y = s$$" "\n" r"$$\dot y = -2\dot x$$", "times as much"),
        # a factor above and one below
        (r"$$k s^2 = m v^2\left(1 + \frac mM\right)$$" "\nHence\n"
         r"$$v = s\sqrt{\frac{k(M + m)}{m M}}$$", "exchanged"),
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


def test_what_one_letter_stands_for_is_contradicted_by_what_two_give():
    *_, outcome = (
        row.outcome
        for row in judged(r"""
$$\omega_1 = \dot\phi\sin\theta\sin\psi + \dot\theta\cos\psi$$
$$\omega_2 = \dot\phi\sin\theta\cos\psi + \dot\theta\sin\psi$$
$$\omega_1\sin\psi + \omega_2\cos\psi = \dot\phi\sin\theta$$""")
    )
    assert outcome.passed is False
    assert outcome.why == "it contradicts one of the lines that it rests on"
    assert outcome.right.count(r"\omega_") == 2


def test_a_period_with_another_body_is_no_slip_in_the_one_without():
    text = r"""$$J\ddot\phi = -D\phi$$
The period is $$\tau = 2\pi\sqrt{\frac JD}$$
With a second body the period becomes $$\tau_1 = 2\pi\sqrt{\frac{J + J_1}{D}}$$"""
    assert [row.outcome.passed for row in judged(text)] == [None, True, True]


def test_what_it_is_thrown_with_is_no_value_where_it_turns():
    text = r"""$$e = \frac12 v^2 - \frac kr$$
It is thrown up from the ground, $r = R$, with $v = u$, and turns at $r = 3R$ where $v = 0$."""
    assert all(row.outcome.passed is not False for row in judged(text))


def test_behind_a_slip_in_a_frequency_goes_on_what_it_should_have_been():
    text = r"""$$m\ddot x = -k x$$
The frequency of the oscillation is $$\omega = \sqrt{\frac mk}$$
$$\frac{2\pi}{\omega} = 2\pi\sqrt{\frac mk}$$"""
    assert [row.outcome.passed for row in judged(text)] == [None, False, True]


def test_where_a_letter_vanishes_it_is_not_used_again():
    text = r"""$$N = m g\cos\theta - m\frac{v^2}{R}$$
**With a push.** He leaves it, $N = 0$, where $$v^2 = g R\cos\theta$$"""
    assert judged(text)[-1].outcome.passed is True


RIGHT = [
    r"""*On top of a hill* the acceleration points down,
$$\frac{m v^2}{r} = m g - N$$

*At the bottom of a dip* it points up,
$$\frac{m v^2}{r} = N - m g$$""",
    r"""$$m\dot v = -m g$$
A stone is thrown from $y = 0$ with $v = w$. Were there no weight, it would be at $$y = w t$$""",
    r"""$$m\ddot x = -k x$$
It oscillates with $$\omega = \sqrt{\frac km}$$
The energy oscillates with $$\omega_K = 2\sqrt{\frac km}$$""",
    "A block of 2 kg on a spring, $$U = \\frac12 k x^2$$ $$\\ddot x = -\\frac12 k x$$",
    r"On the Earth $g = 9.81\,\mathrm{m/s^2}$. On the Moon $g = 1.62\,\mathrm{m/s^2}$.",
]


@pytest.mark.parametrize("text", RIGHT)
def test_what_is_right_is_not_condemned(text):
    assert all(row.outcome.passed is not False for row in judged(text))


OPEN = [
    r"$$m\ddot x = -k x, \qquad m\ddot y = -4 k y$$ So it is that $$\dot x = 2\dot y$$",
    r"""$$J\ddot\theta = -m g s\sin\theta$$
Let $\theta = \beta$. At this moment $$\ddot\theta = 0$$""",
    r"The rod hangs in the field of its weight. $$T = \frac12 J\dot\theta^2$$ $$\ddot\theta = 0$$",
    r"A body of 2 kg has $$U = \frac12 k x^2$$ $$\ddot x = -k x$$",
    r"$$l\ddot\theta = -g\sin\theta$$ The acceleration is $$a = -\frac gl\sin\theta$$",
    r"A disc has $$J = \frac12 M R^2$$ A thin ring has $$J_1 = \frac12 M_1 R_1^2$$",
]


@pytest.mark.parametrize("text", OPEN)
def test_what_only_seems_to_follow_does_not(text):
    assert judged(text)[-1].outcome.passed is not True
