"""What the judge can do, a short text for each: what is right follows, what is wrong is told."""

from dataclasses import dataclass
from functools import cache

import pytest

from rigidtop.judge.text import judged

TEXTS = r"""
# definitions in any order
. L = T - V
. T = \frac12 ml^2\dot\theta^2
. V = -mgl\cos\theta
+ \ddot\theta = -\frac gl\sin\theta
- \ddot\theta = \frac gl\sin\theta

# Lagrange's equations
. L = \frac12 m(\dot r^2 + r^2\dot\phi^2) + \frac kr
+ \frac{d}{dt}\frac{\partial L}{\partial\dot r} = mr\dot\phi^2 - \frac k{r^2}
- \frac{d}{dt}\frac{\partial L}{\partial\dot r} = mr\dot\phi - \frac k{r^2}
+ r\ddot\phi + 2\dot r\dot\phi = 0
- r\ddot\phi + \dot r\dot\phi = 0

# multipliers
. L = \frac12 m(\dot x^2 + \dot y^2) - mgy + \lambda(x^2 + y^2 - l^2)
+ m\ddot x = 2\lambda x
- m\ddot x = \lambda x
+ m\ddot y = -mg + 2\lambda y
- m\ddot y = -mg + 2\lambda x
+ x^2 + y^2 = l^2
- x^2 - y^2 = l^2

# a rolling tie
. I = \frac12 MR^2
. L = \frac12 M\dot x^2 + \frac12 I\dot\theta^2 + Mgx\sin\alpha
> It rolls without slipping, $\dot x = R\dot\theta$. Hence
+ \ddot x = \frac23 g\sin\alpha
- \ddot x = \frac32 g\sin\alpha

# a coordinate put in
. L = \frac12 m\dot x^2 + \frac12 I\dot\theta^2 + mgx\sin\alpha
. x = R\theta
+ (m + \frac I{R^2})\ddot x = mg\sin\alpha
- (m - \frac I{R^2})\ddot x = mg\sin\alpha

# momenta and the energy by their names
. L = \frac12 m(\dot r^2 + r^2\dot\phi^2) + \frac kr
+ p_\phi = mr^2\dot\phi
- p_\phi = mr\dot\phi
+ \dot p_\phi = 0
+ E = \frac12 m\dot r^2 + \frac{p_\phi^2}{2mr^2} - \frac kr
- E = \frac12 m\dot r^2 + \frac{p_\phi^2}{2mr^2} + \frac kr
+ \dot E = 0

# a momentum put into L
. L = \frac12 m(\dot r^2 + r^2\dot\phi^2) + \frac kr
+ p = mr^2\dot\phi
+ L = \frac12 m\dot r^2 + \frac{p^2}{2mr^2} + \frac kr
- L = \frac12 m\dot r^2 - \frac{p^2}{2mr^2} + \frac kr
+ m\ddot r = \frac{p^2}{mr^3} - \frac k{r^2}
- m\ddot r = -\frac{p^2}{mr^3} - \frac k{r^2}

# vectors
. \mathbf M = m\mathbf r\times\dot{\mathbf r}
+ \dot{\mathbf M} = m\mathbf r\times\ddot{\mathbf r}
- \dot{\mathbf M} = m\ddot{\mathbf r}\times\mathbf r
. m\ddot{\mathbf r} = -k\mathbf r
+ \dot{\mathbf M} = 0

# Newton's law within a chain
. F = ma = m\ddot x = -kx
+ \ddot x = -\frac kmx
- \ddot x = \frac kmx

# the sum of forces
. \sum F = m\ddot y = -mg - b\dot y
+ \ddot y = -g - \frac bm\dot y
- \ddot y = -g + \frac bm\dot y

# integrals over a body
. M = \int \rho\,d^3r
. \mathbf R = \frac1M\int d^3r\,\rho(\mathbf r)\,\mathbf r
+ \int d^3r\,\rho(\mathbf r)\,(\mathbf r - \mathbf R) = 0
- \int d^3r\,\rho(\mathbf r)\,(\mathbf r + \mathbf R) = 0
. \mathbf N = -g\int d^3r\,\rho(\mathbf r)\,\mathbf r\times\hat{\mathbf z}
+ \mathbf N = -gM\mathbf R\times\hat{\mathbf z}
- \mathbf N = gM\mathbf R\times\hat{\mathbf z}

# a body of which each part turns alike
. \mathbf v = \boldsymbol\omega\times\mathbf r
. \mathbf L = \int \mathbf r\times\mathbf v\,dm
+ \mathbf L = \int (r^2\boldsymbol\omega - (\mathbf r\cdot\boldsymbol\omega)\mathbf r)\,dm
- \mathbf L = \int (r^2\boldsymbol\omega + (\mathbf r\cdot\boldsymbol\omega)\mathbf r)\,dm
+ \int v^2\,dm = \boldsymbol\omega\cdot\mathbf L
- 2\int v^2\,dm = \boldsymbol\omega\cdot\mathbf L

# two cross products
. \mathbf d = \mathbf a\times(\mathbf b\times\mathbf c)
+ \mathbf d = \mathbf b(\mathbf a\cdot\mathbf c) - \mathbf c(\mathbf a\cdot\mathbf b)
- \mathbf d = \mathbf b(\mathbf a\cdot\mathbf c) + \mathbf c(\mathbf a\cdot\mathbf b)

# components
. \boldsymbol\omega = (\omega_1, \omega_2, \omega_3)
. \mathbf L = (I_1\omega_1, I_2\omega_2, I_3\omega_3)
+ (\boldsymbol\omega\times\mathbf L)_1 = (I_3 - I_2)\omega_2\omega_3
- (\boldsymbol\omega\times\mathbf L)_1 = (I_2 - I_3)\omega_2\omega_3

# matrices
. R = \begin{pmatrix}\cos\alpha & -\sin\alpha\\ \sin\alpha & \cos\alpha\end{pmatrix}
+ \det R = 1
- \det R = 2
+ R^T R = \begin{pmatrix}1 & 0\\ 0 & 1\end{pmatrix}

# sums over particles
. M = \sum_i m_i
. M\mathbf R = \sum_i m_i\mathbf r_i
. \mathbf P = \sum_i m_i\dot{\mathbf r}_i
+ \mathbf P = M\dot{\mathbf R}
- \mathbf P = -M\dot{\mathbf R}

# an integral
. I = \int_0^R \frac{2M}{R^2}r^3\,dr
+ I = \frac12 MR^2
- I = \frac14 MR^2

# a motion that solves
. \ddot x + w^2x = 0
+ x = A\cos wt + B\sin wt
- x = A\cos 2wt + B\sin wt

# a motion that is tried
. \ddot x + 2b\dot x + w^2x = F\cos\nu t
. x = P\cos\nu t + Q\sin\nu t
+ (w^2 - \nu^2)P + 2b\nu Q = F
- (w^2 - \nu^2)P - 2b\nu Q = F
+ (w^2 - \nu^2)Q - 2b\nu P = 0
- (w^2 - \nu^2)Q - 2b\nu Q = 0

# a complex exponential that is tried
. \ddot x + 2b\dot x + w^2x = 0
. x = Ae^{i\nu t}
+ -\nu^2 + 2ib\nu + w^2 = 0
- -\nu^2 - 2ib\nu + w^2 = 0

# complex numbers
. \zeta = x + iy
. \ddot x = 2\Omega\dot y
. \ddot y = -2\Omega\dot x
+ \ddot\zeta = -2i\Omega\dot\zeta
- \ddot\zeta = 2i\Omega\dot\zeta

# Euler's formula
. z = re^{i\phi}
+ z = r(\cos\phi + i\sin\phi)
- z = r(\cos\phi - i\sin\phi)

# values at the time 0
. x = A\cos wt + B\sin wt
> At $t = 0$ we have $x = a$ and $\dot x = v$. Hence
+ A = a
- A = 2a
+ B = \frac vw
- B = -\frac vw
+ x = a\cos wt + \frac vw\sin wt

# what is conserved has its value from the start
. L = \frac12 m(\dot r^2 + r^2\dot\phi^2) + \frac kr
+ p_\phi = mr^2\dot\phi
> At $t = 0$ we have $r = a$ and $\dot\phi = w$. Hence
+ r^2\dot\phi = a^2w
- r^2\dot\phi = aw

# a special case ends with its section
. L = \frac12 ml^2(\dot\theta^2 + \sin^2\theta\,\dot\phi^2) + mgl\cos\theta
> ## In a plane
> Let $\dot\phi = 0$. Then
+ \ddot\theta = -\frac gl\sin\theta
- \ddot\theta = \frac gl\sin\theta
> ## In space
+ \ddot\theta = \sin\theta\cos\theta\,\dot\phi^2 - \frac gl\sin\theta
? \ddot\theta = -\frac gl\sin\theta

# both roots, and when they are real
. 4I_1cs^2 - 2I_3ws + Mgl = 0
+ s = \frac{I_3w \pm\sqrt{I_3^2w^2 - 4I_1cMgl}}{4I_1c}
- s = \frac{I_3w \pm\sqrt{I_3^2w^2 + 4I_1cMgl}}{4I_1c}
. I_3^2w^2 - 4I_1cMgl \geq 0
+ w^2 \geq \frac{4I_1cMgl}{I_3^2}
- w^2 \geq \frac{2I_1cMgl}{I_3^2}

# both signs
. s_\pm = -b \pm w
+ s_+s_- = b^2 - w^2
- s_+s_- = b^2 + w^2

# what is constant
. m\ddot x = -kx
+ m\dot x^2 + kx^2 = \text{const}
- m\dot x^2 - kx^2 = \text{const}

# small motions
. L = \frac12 ml^2\dot\theta^2 + mgl\cos\theta
~ \ddot\theta \approx -\frac gl\theta
- \ddot\theta \approx -\frac{g}{2l}\theta

# numbers with units
. m = 2.0\,\mathrm{kg}
. v = 3.0\,\mathrm{m/s}
. T = \frac12 mv^2
+ T = 9.0\,\mathrm J
x T = 18\,\mathrm J
? T = 9.0\,\mathrm N

# a missing term
. L = \frac12 m(\dot r^2 + r^2\dot\phi^2) + mgr\cos\phi - \frac12 k(r - l)^2
+ m\ddot r = mr\dot\phi^2 + mg\cos\phi - kr + kl
- m\ddot r = mr\dot\phi^2 + mg\cos\phi + kl

# a contradiction with what a letter stands for
. u = a + b
. v = a + b
+ uv = a^2 + 2ab + b^2
x uv = a^2 - b^2

# another letter
. L = \frac12 m\dot x^2 + \frac12 M\dot y^2 - \frac12 k(x - y)^2
+ m\ddot x = -k(x - y)
- m\ddot x = -k(x - m)
+ M\ddot y = k(x - y)
- m\ddot y = k(x - y)

# a derivative is worked out
. a = \frac{Mn}{n^2J + K}
+ \frac{da}{dn} = \frac{M(K - n^2J)}{(n^2J + K)^2}
- \frac{da}{dn} = \frac{M(K - n^2J)}{n^2J + K}
x \frac{da}{dn} = \frac{M(K - nJ^2)}{n^2J + K}

# a derivative may vanish, or be nearly equal
. V = mgl(1 - \cos\theta) - Nl\theta
+ \frac{\partial V}{\partial\theta} = mgl\sin\theta - Nl
? \frac{\partial V}{\partial\theta} = 0
? \frac{\partial V}{\partial\theta} = mgl\theta - Nl

# a factor below a root
. q = \sqrt{\frac{2J}{mw}}\sin\theta
+ \frac{\partial q}{\partial J} = \frac{\sin\theta}{\sqrt{2mwJ}}
- \frac{\partial q}{\partial J} = \frac{\sin\theta}{\sqrt{mwJ}}

# a number times as much in all components
. I = Ma^2\begin{pmatrix} 2 & -1 \\ -1 & 2\end{pmatrix}
+ I\begin{pmatrix} 1 \\ -1\end{pmatrix} = 3Ma^2\begin{pmatrix} 1 \\ -1\end{pmatrix}
- I\begin{pmatrix} 1 \\ -1\end{pmatrix} = \frac75Ma^2\begin{pmatrix} 1 \\ -1\end{pmatrix}
. I\begin{pmatrix} 1 \\ -1\end{pmatrix} = Mb^2\begin{pmatrix} 1 \\ -1\end{pmatrix}

# a characteristic polynomial holds for all its roots
. K = k\begin{pmatrix} 2 & -1 \\ -1 & 2\end{pmatrix}
+ \det(K - z) = (2k - z)^2 - k^2
- \det(K - z) = (2k - z)^2 - 2k^2

# what is a function of an angle moves with it
. w^2 = \frac{4g}{R\sin\alpha}
. E = \frac12 mR^2w^2\sin^2\alpha + mgR\sin\alpha
. \dot E = -P
+ \dot\alpha = -\frac{P}{3mgR\cos\alpha}
- \dot\alpha = -\frac{P}{3mgR\sin\alpha}

# an integral over a motion that is found
. \dot w = -\frac{kg}R
. w(0) = w_0
+ w = w_0 - \frac{kg}Rt
+ \tau = \frac{Rw_0}{kg}
+ \int_0^\tau w\,dt = \frac{Rw_0^2}{2kg}
- \int_0^\tau w\,dt = \frac{Rw_0^2}{kg}

# an integral over a motion that is not known
. \dot w = -\frac{kg}Rw^3
. \tau = \frac{2R}g
? \int_0^\tau w\,dt = w\tau

# a number with a unit
. J = \frac{mga^2\tau^2}{4\pi^2h}
> Here $m = 2\,\mathrm{kg}$, $a = 0.15\,\mathrm m$, $h = 1.2\,\mathrm m$.
> Here $\tau = 1.5\,\mathrm s$, $g = 9.81\,\mathrm{m/s^2}$.
+ J = 0.021\,\mathrm{kg\,m^2}
- J = 0.21\,\mathrm{kg\,m^2}

# a relation in time, and its rate
. r = a(1 - e\cos E)
. nt = E - e\sin E
+ \dot E = \frac n{1 - e\cos E}
- \dot E = \frac n{1 - e\sin E}
+ \dot r = \frac{nae\sin E}{1 - e\cos E}
- \dot r = \frac{nae\cos E}{1 - e\cos E}

# two relations solved together
. P = m(v - u)
. V = \frac PM
. u = V + wd
+ P = \frac{m(v - wd)}{1 + \frac mM}
- P = \frac{m(v - wd)}{1 - \frac mM}

# canonical equations
. H = \frac{p_r^2}{2m} + \frac{K^2}{2mr^2} - \frac cr
+ \dot r = \frac{p_r}m
- \dot r = -\frac{p_r}m
+ \dot p_r = \frac{K^2}{mr^3} - \frac c{r^2}
- \dot p_r = \frac{K^2}{mr^3} + \frac c{r^2}

# canonical equations with friction
. H = \frac{p^2}{2m} + \frac12kx^2
+ \dot x = \frac pm
. \dot p = -kx - bp

# a prime on a curve
. y = c\cosh\frac xc
+ y' = \sinh\frac xc
- y' = c\sinh\frac xc
+ y'' = \frac y{c^2}
- y'' = \frac y{2c^2}

# a prime on the letter of other axes
. y = kx
. x' = x\cos\alpha + y\sin\alpha
. y' = y\cos\alpha - x\sin\alpha

# a row that is turned
. I = \begin{pmatrix} A & D \\ D & B\end{pmatrix}
. w = (u, v)^T
+ w^T I w = Au^2 + 2Duv + Bv^2
- w^T I w = Au^2 + Duv + Bv^2

# what runs is an angle
. \frac{dS}{d\phi} = \mu S
. S(0) = S_0
+ S = S_0e^{\mu\phi}
- S = S_0e^{-\mu\phi}

# sine and cosine
. x = l\sin\theta
+ \dot x = l\dot\theta\cos\theta
- \dot x = l\dot\theta\sin\theta

# a start that words tell
. m\dot v = mg - cv^2
+ v_\infty = \sqrt{\frac{mg}c}
> Released from rest it has the speed
+ v = v_\infty\tanh\frac{gt}{v_\infty}
- v = v_\infty\tanh\frac{gt}{2v_\infty}

# an energy at the start
. \ddot\phi = -\frac{2g}{3b}\sin\phi
> Released at $\phi = \alpha$ without velocity
+ \dot\phi^2 = \frac{4g}{3b}(\cos\phi - \cos\alpha)
- \dot\phi^2 = \frac{4g}{3b}(\cos\phi + \cos\alpha)

# an angle at which it starts
. \ddot\phi = -\frac{2g}{3b}\sin\phi
> It is let go at $\phi_0$:
+ \dot\phi^2 = \frac{4g}{3b}(\cos\phi - \cos\phi_0)

# two conditions at the start
. \ddot\theta = -k\sin\theta
> If $\theta = 0$ and $\dot\theta = w$ at the start,
+ \dot\theta^2 = w^2 - 2k(1 - \cos\theta)
- \dot\theta^2 = w^2 + 2k(1 - \cos\theta)

# an equilibrium
. L = \frac12ml^2(\dot\theta^2 + w^2\sin^2\theta) + mgl\cos\theta
> In equilibrium, at $\theta_0\ne0$,
+ \cos\theta_0 = \frac g{lw^2}
- \cos\theta_0 = \frac g{lw}

# a value at a place
. v^2 = \mu\left(\frac2r - \frac1a\right)
> At $r = q$ the speed is
+ v_q^2 = \mu\frac{2a - q}{qa}
- v_q^2 = \mu\frac{2a + q}{qa}

# the frequency of an oscillation
. A\ddot\phi = -\left(c + \frac{h^2}B\right)\phi
> The period of rolling is
+ \tau = 2\pi\sqrt{\frac{AB}{cB + h^2}}
- \tau = 2\pi\sqrt{\frac{AB}{c + h^2}}

# a period beside a fall
. \ddot y = -g
. \ddot u = -\frac kmu
> The period of u is
+ \tau = 2\pi\sqrt{\frac mk}
- \tau = 2\pi\sqrt{\frac km}

# an energy that is conserved, and what it is
> The energy is conserved, and it is
. E = \frac12m\dot y^2 + mgy
+ \ddot y = -g
- \ddot y = -2g

# the frequency of small oscillations
. J\ddot\phi = (m_2b - m_1a)g\cos\phi - Mgs\sin\phi
> When the children balance, $m_1a = m_2b$, small swings have
+ \omega^2 = \frac{Mgs}J
- \omega^2 = \frac{Mgs}{2J}

# every term that is kept
> For small $x$
~ \frac1{(1 - x)^2}\approx 1 + 2x
- \frac1{(1 - x)^2}\approx 1 - 2x
~ \sin x\approx x - \frac{x^3}6
- \sin x\approx x + \frac{x^3}6
~ \cos x\approx 1

# items of a list that go together
> - translation: $mv = P$
> - rotation: $J\omega = Ph$ with $J = \frac25mR^2$
>
+ \omega = \frac{5vh}{2R^2}
- \omega = \frac{5vh}{2R}

# numbers that come of a relation
. a = 8
. g = 9.81
. \tan\alpha = \frac ag
+ \tan\alpha = 0.815
- \alpha = 50.8^\circ

# a momentum of which it is not said whose it is
. L = \frac m2(\dot r^2 + r^2\dot\phi^2\sin^2\alpha)
+ p = mr^2\dot\phi\sin^2\alpha
+ \ddot r = \frac{p^2}{m^2r^3\sin^2\alpha}
- \ddot r = \frac{p^2}{m^2r^3}

# what is divided by
. P\left(\frac1R - \frac1r\right) = \frac12Q(r^2 - R^2)
> Divide by $r - R$:
+ r^2 + Rr - \frac{2P}{QR} = 0
- r^2 + Rr - \frac P{QR} = 0

# energy that is conserved by what is said
. E = \frac12\left(m + \frac J{r^2}\right)\dot s^2 - mgs
> Energy is conserved, so
+ \ddot s = \frac{mgr^2}{J + mr^2}
- \ddot s = \frac{mgr}{J + mr^2}

# masses that are brought one after the other
. J_1\ddot a_1 = -c(a_1 - a_2)
. J_2\ddot a_2 = c(a_1 - a_2)
+ J_1\dot a_1 + J_2\dot a_2 = \mathrm{const}
- J_1\dot a_1 - J_2\dot a_2 = \mathrm{const}

# where what was said vanishes
. V = c\left(\left(\frac sr\right)^{12} - \left(\frac sr\right)^6\right)
+ \frac{dV}{dr} = -\frac{6c}r\left(2\left(\frac sr\right)^{12} - \left(\frac sr\right)^6\right)
> It vanishes at
+ r_0 = 2^{1/6}s
- r_0 = 2^{1/3}s

# a circle
. L = \frac12(m + M)\dot r^2 + \frac12mr^2\dot\phi^2 - Mgr
. \dot\phi = w
> On a circle of radius $r_0$ we have
+ mr_0w^2 = Mg
- mr_0w^2 = 2Mg

# two numbers of a period exchanged
. \ddot\phi = -\frac{5g}{7a}\phi
> A swing has the period
+ \tau = 2\pi\sqrt{\frac{7a}{5g}}
- \tau = 2\pi\sqrt{\frac{5a}{7g}}

# the largest rate
. J\ddot\phi = -\mu B\sin\phi
> It is released at $\phi_0$:
+ \dot\phi^2 = \frac{2\mu B}J(\cos\phi - \cos\phi_0)
> At $\phi = 0$ it is
+ \dot\phi_m^2 = \frac{2\mu B}J(1 - \cos\phi_0)
- \dot\phi_m^2 = \frac{\mu B}J(1 - \cos\phi_0)

# what something tends to
. a = \frac{ew^2}{q^2 - w^2}
> For $w\to\infty$
~ a \to -e
- a \to e

# a motion that is tried in a Lagrangian
. L = \frac12m_1\dot x^2 + \frac12m_2\dot y^2 - \frac12k(x - y)^2 - \frac12qy^2
. x = a\cos\omega t
. y = b\cos\omega t
+ (k - m_1\omega^2)(k + q - m_2\omega^2) - k^2 = 0
- (k - m_1\omega^2)(k - q - m_2\omega^2) - k^2 = 0

# a motion and its constants, which may be zero
. \ddot x = -\omega^2x
+ x = A\cos\omega t + B\sin\omega t
> At the start
. \dot x = 0
> Hence
+ B = 0

# a gradient
. f = Ax^2 + By^2 + Cz^2
+ \nabla f = (2Ax, 2By, 2Cz)
- \nabla f = (2Ax, By, 2Cz)

# d with a square is the length of a vector
. \mathbf d = (R, R, 0)
+ d^2m = 2R^2m
- d^2m = 3R^2m

# a constant that has the name of a start
. m\dot v = -bv^2
+ \frac1v - \frac1{v_0} = \frac{bt}m

# a constant that has the name of a start, and is none
. m\dot v = -bv^2
. \frac1v + \frac1{v_0} = \frac{bt}m
"""
"""A line that begins with "." is taken as it stands, one with "+" follows, and one with "~" nearly.

With "-" it is a false variant of the line above and the judge knows the right one, with "x" it is
false, and with "?" it does not follow; ">" is prose.
"""

TAKEN = {"premise", "definition"}


@dataclass(frozen=True)
class Line:
    mark: str
    text: str

    @property
    def source(self) -> str:
        return self.text if self.mark == ">" else f"$${self.text}$$"


def right_and_wrong():
    """For each text the right lines, and for each variant those before it with it behind them."""
    for text in TEXTS.strip().split("\n\n"):
        title, *lines = text.splitlines()
        right: list[Line] = []
        variants = 0
        for line in (Line(line[0], line[2:]) for line in lines):
            if line.mark in "-x?":
                variants += 1
                yield pytest.param((*right[:-1], line), id=f"{title[2:]}, wrong {variants}")
            else:
                right.append(line)
        yield pytest.param(tuple(right), id=title[2:])


@cache
def rows_of(lines):
    """The outcomes of the formulas that stand alone, with their marks."""
    rows = judged("\n".join(line.source for line in lines))
    assert not {row.outcome.verdict for row in rows if not row.display} - TAKEN
    outcomes = {row.line: row.outcome for row in rows if row.display}
    return [(line.mark, outcomes[k]) for k, line in enumerate(lines, 1) if line.mark != ">"]


def has_its_mark(mark, outcome):
    if mark == ".":
        return outcome.verdict in TAKEN
    if mark == "?":
        return outcome.verdict == "undecided"
    if mark == "~":
        return outcome.verdict == "assuming" and bool(outcome.conditions)
    return outcome.passed is (mark == "+")


CASES = list(right_and_wrong())
WRONG = [case for case in CASES if case.values[0][-1].mark == "-"]


@pytest.mark.parametrize("lines", CASES)
def test_every_line_is_judged_as_it_deserves(lines):
    rows = rows_of(lines)
    assert [(mark, x) for mark, x in rows if not has_its_mark(mark, x)] == []


@pytest.mark.parametrize("lines", WRONG)
def test_what_is_said_to_be_right_is_right(lines):
    *before, wrong = lines
    _, outcome = rows_of(lines)[-1]
    assert outcome.slip
    mended = Line(wrong.mark, outcome.right)
    _, again = rows_of((*before, mended))[-1]
    assert again.passed
