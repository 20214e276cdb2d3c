"""Lines that follow from lines: what moves make, and what they refuse."""

from __future__ import annotations

import pytest

from .pages import lecture as lecture_of

LAWS = r"""
# Laws
The kinetic energy =>
  T = \tfrac12\lambda_1(\dot\phi^2\sin^2\theta + \dot\theta^2) + \tfrac12\lambda_3(\dot\psi +
  \dot\phi\cos\theta)^2
The Lagrangian =>
  \mathcal L = \tfrac12\lambda_1(\dot\phi^2\sin^2\theta + \dot\theta^2) +
  \tfrac12\lambda_3(\dot\psi + \dot\phi\cos\theta)^2 - MgR\cos\theta \tag{3.53}
The spin momentum => p_\psi = \lambda_3(\dot\psi + \dot\phi\cos\theta)
The deviation => \delta = 1
The other deviation => \delta = 2
Along the motion, Lagrange's equation for $\theta$ =>
  \frac{d}{dt}\frac{\partial\mathcal L}{\partial\dot\theta} = \frac{\partial\mathcal
  L}{\partial\theta}
Along the motion, the balance =>
  0 = \lambda_1\dot\phi^2\sin\theta\cos\theta - p_\psi\dot\phi\sin\theta + MgR\sin\theta
Along the motion, Euler's third equation =>
  \lambda_3\dot\omega_3 = (\lambda_1 - \lambda_2)\omega_1\omega_2
Along the motion, the first of Euler's equations =>
  \lambda_1\dot\omega_1 = (\lambda_2 - \lambda_3)\omega_2\omega_3
Along the motion, the rate of spin =>
  \dot\omega_3 = \frac{\lambda_1 - \lambda_2}{\lambda_3}\omega_1\omega_2
Along the motion, the pair =>
  \dot\omega_1 = \omega_{3,0}\omega_2, \quad \dot\omega_2 = -\omega_{3,0}\omega_1
Along the motion, the sum of the pair => \dot\omega_1 + \dot\omega_2 = 0
Along the motion, a root => \lambda_3\dot\omega_3 = M\sqrt{\omega_3}
Along the motion, the law of angular momentum => \dot{\mathbf L} = \mathbf N
The transport theorem =>
  \left(\frac{\partial\mathbf L}{\partial t}\right)_{\text{space}} = \left(\frac{\partial\mathbf
  L}{\partial t}\right)_{\text{body}} + \boldsymbol\omega\times\mathbf L
Along the motion, the power =>
  \lambda_1\,\dot{\mathbf e}_3\cdot\ddot{\mathbf e}_3 = MgR\,\dot\theta\sin\theta
The square of the speed => \sigma^2 = \dot{\mathbf e}_3^2
## Of many particles
The inner torque => \mathbf N_{\text{in}} = \sum_k\sum_l\mathbf r_k\times\mathbf F_{kl}
Along the motion, the force on a particle =>
  m_k\ddot{\mathbf r}_k = \mathbf F_k^{(e)} + \sum_l\mathbf F_{kl}
The momentum of particles => \mathbf L = \sum_k m_k\,\mathbf r_k\times\dot{\mathbf r}_k
The mass of a particle => m_k = M
The place of $\delta_k$ => \int d^3\mathbf r\,\delta_k\,\mathbf r = \mathbf r_k
The force density => f(\mathbf r) = \sum_k\delta_k\,\mathbf F_k^{(e)}
The external torque => \mathbf N^{(e)} = \int d^3\mathbf r\,\mathbf r\times f(\mathbf r)
"""


def judged(page: str, laws: str = LAWS):
    """The lines of a page below the laws, each with what became of it."""
    lecture = lecture_of(laws, page)
    assert not list(lecture.unread())
    return [lecture.judged(line.id) for line in lecture.texts[1].lines]


def last(page: str, laws: str = LAWS) -> str:
    """Why the last line does not follow, or nothing."""
    *before, line = judged(page, laws)
    assert all(each.follows for each in before), [str(each.problem) for each in before]
    return str(line.problem or "")


FOLLOWS = {
    "divide": r"""
Divide the balance by $\sin\theta$ => 0 = \lambda_1\dot\phi^2\cos\theta - p_\psi\dot\phi + MgR
""",
}

FOLLOWS |= {
    "indices change places": r"""
Exchange $k$ and $l$ in the inner torque =>
  \mathbf N_{\text{in}} = \sum_k\sum_l\mathbf r_l\times\mathbf F_{lk}
Exchange $k$ and $l$ in it => \mathbf N_{\text{in}} = \sum_l\sum_k\mathbf r_k\times\mathbf F_{kl}
""",
    "a law for each particle is put into a sum": r"""
Take the rate of the momentum of particles, with the force on a particle =>
  \dot{\mathbf L} = \sum_k\mathbf r_k\times\mathbf F_k^{(e)} + \sum_k\sum_l\mathbf
  r_k\times\mathbf F_{kl}
""",
    "an integral of a sum": r"""
Put the place of $\delta_k$ and the force density into the external torque =>
  \mathbf N^{(e)} = \underbrace{\sum_k\mathbf r_k\times\mathbf F_k^{(e)}}_{\mathbf N^{(e)}}
""",
    "a first integral": r"""
Integrate the power from $\dot{\mathbf e}_3 = 0$ and $\theta = \theta_i$ =>
  \tfrac12\lambda_1\dot{\mathbf e}_3^2 = MgR(\cos\theta_i - \cos\theta)
Put it into the square of the speed => \sigma^2 = \frac{2MgR}{\lambda_1}(\cos\theta_i - \cos\theta)
""",
}


OPERATORS = r"""
# Laws
The axes =>
  O\hat{\mathbf x} = \mathbf e_1, \quad O\hat{\mathbf y} = \mathbf e_2, \quad O\hat{\mathbf z} =
  \mathbf e_3
Two axes => A\hat{\mathbf x} = \hat{\mathbf y}, \quad A\hat{\mathbf y} = -\hat{\mathbf x}
All axes =>
  B\hat{\mathbf x} = \hat{\mathbf y}, \quad B\hat{\mathbf y} = -\hat{\mathbf x}, \quad
  B\hat{\mathbf z} = \hat{\mathbf z}
The same to all =>
  A\mathbf e_1 = BC\mathbf e_1, \quad A\mathbf e_2 = BC\mathbf e_2, \quad A\mathbf e_3 = BC\mathbf
  e_3
The symmetry => \mathbf v\cdot I\mathbf u = \mathbf u\cdot I\mathbf v
The symmetry with more =>
  \mathbf v\cdot I\mathbf u + \mathbf w\cdot I\mathbf w = \mathbf u\cdot I\mathbf v + \mathbf
  w\cdot I\mathbf w
The inverse => AB = 1
The product => C = AB
"""

OF_OPERATORS = {
    "the entries of all products of columns": (
        r"""
Dot the axes with itself =>
  \begin{aligned} \hat{\mathbf x}\cdot O^TO\hat{\mathbf x} &= 1, & \hat{\mathbf y}\cdot
  O^TO\hat{\mathbf y} &= 1, & \hat{\mathbf z}\cdot O^TO\hat{\mathbf z} &= 1, \\ \hat{\mathbf
  x}\cdot O^TO\hat{\mathbf y} &= 0, & \hat{\mathbf y}\cdot O^TO\hat{\mathbf z} &= 0, &
  \hat{\mathbf z}\cdot O^TO\hat{\mathbf x} &= 0 \end{aligned}
Strip $\hat{\mathbf x}$, $\hat{\mathbf y}$ and $\hat{\mathbf z}$ from it => O^TO = 1
""",
        "",
    ),
    "some entries are not all": (
        r"""
Dot the axes with itself =>
  \hat{\mathbf x}\cdot O^TO\hat{\mathbf x} = 1, \quad \hat{\mathbf y}\cdot O^TO\hat{\mathbf y} =
  1, \quad \hat{\mathbf z}\cdot O^TO\hat{\mathbf z} = 1
Strip $\hat{\mathbf x}$, $\hat{\mathbf y}$ and $\hat{\mathbf z}$ from it => O^TO = 1
""",
        "not known for all of them",
    ),
    "what does the same is the same": (
        r"Strip $\mathbf e_1$, $\mathbf e_2$ and $\mathbf e_3$ from the same to all => A = BC",
        "",
    ),
    "the order of factors matters": (
        r"Strip $\mathbf e_1$, $\mathbf e_2$ and $\mathbf e_3$ from the same to all => A = CB",
        "does not arrive",
    ),
    "columns": (
        r"""
Strip $\hat{\mathbf x}$, $\hat{\mathbf y}$ and $\hat{\mathbf z}$ from all axes =>
  B = \begin{bmatrix} 0 & -1 & 0 \\ 1 & 0 & 0 \\ 0 & 0 & 1 \end{bmatrix}
Take the determinant of it => \det B = 1
""",
        "",
    ),
    "columns are no rows": (
        r"""
Strip $\hat{\mathbf x}$, $\hat{\mathbf y}$ and $\hat{\mathbf z}$ from all axes =>
  B = \begin{bmatrix} 0 & 1 & 0 \\ -1 & 0 & 0 \\ 0 & 0 & 1 \end{bmatrix}
""",
        "does not arrive",
    ),
    "no frame": (
        r"Strip $\hat{\mathbf x}$, $\hat{\mathbf y}$ and $\mathbf e_3$ from all axes => B = 1",
        "three axes of a frame",
    ),
    "symmetry": (
        r"Strip $\mathbf u$ and $\mathbf v$ from the symmetry => I = I^T",
        "",
    ),
    "symmetry where vectors are chosen": (
        r"""
Set $\mathbf w = \mathbf u$ in the symmetry with more =>
  \mathbf v\cdot I\mathbf u + \mathbf u\cdot I\mathbf u = \mathbf u\cdot I\mathbf v + \mathbf
  u\cdot I\mathbf u
Strip $\mathbf u$ and $\mathbf v$ from it => I = I^T
""",
        "does not hold for any vector",
    ),
    "an inverse from the right": (
        "Exchange the factors in the inverse => BA = 1",
        "",
    ),
    "factors of what is not 1": (
        "Exchange the factors in the product => C = BA",
        "only where a product is 1",
    ),
    "a transpose turns the order round": (
        "Take the transpose of the product => C^T = B^TA^T",
        "",
    ),
    "no division by a matrix": (
        "Divide the product by $B$ => A = C",
        "a division by what is no scalar",
    ),
    "no solution for a matrix": (
        "Solve the product for $A$ => A = C",
        "a matrix equation is not solved so",
    ),
    "a determinant of a sum": (
        r"""
Add the inverse to the product => C + AB = AB + 1
Take the determinant of it => \det C = 1
""",
        "has no letter",
    ),
}


@pytest.mark.parametrize("name", OF_OPERATORS)
def test_operators(name: str) -> None:
    page, problem = OF_OPERATORS[name]
    found = last(page, OPERATORS)
    assert problem in found if problem else found == ""


INEQUALITIES = r"""
Call the amplitude => \chi = \theta^2 + \phi^2
Rearrange it => \chi - \phi^2 = \theta^2
Take the sign of it, for $\theta \ne 0$ => \phi^2 < \chi
Call the excess => \tau = \chi + \psi^2
Rearrange it => \tau - \chi = \psi^2
Take the sign of it, for $\psi \ne 0$ =>"""
FOLLOWS |= {
    "inequalities added": INEQUALITIES
    + r"""  \chi < \tau
Add $\psi^2$ times it to $\phi^2$, for $\psi \ne 0$ => \psi^2\chi + \phi^2 < \chi + \psi^2\tau
""",
    "a sine": r"""
Call the amplitude => \chi = \arcsin\left(\tfrac12\theta\right)
Take the sine of it => \sin\chi = \tfrac12\theta
""",
    "a negative root": r"""
Call the amplitude => \chi = \theta^2
Rewrite it => \theta^2 = \chi
Take the root of it, for $\theta < 0$ => -\theta = \sqrt\chi
""",
    "a root of one by a positive cosine": r"""
Call the amplitude => \chi = \sqrt{\cos\theta}
Call the excess => \tau = \frac1\chi
Put the amplitude into it, for $\cos\theta > 0$ => \tau = \sqrt{\frac1{\cos\theta}}
""",
    "the rate of a component along a fixed axis": r"""
Set $\mathbf N = 0$ at all times in the law of angular momentum => \dot{\mathbf L} = 0
Take the component of it along $\hat{\mathbf z}$ => \hat{\mathbf z}\cdot\dot{\mathbf L} = 0
Integrate it => L_z = \text{const}
""",
}


@pytest.mark.parametrize("name", FOLLOWS)
def test_a_performed_move_arrives(name: str) -> None:
    assert last(FOLLOWS[name]) == ""


REFUSED = {
    "Routh's trap": (
        r"""
Put the spin momentum into (3.53) =>
  \mathcal L = \tfrac12\lambda_1(\dot\phi^2\sin^2\theta + \dot\theta^2) +
  \frac{p_\psi^2}{2\lambda_3} - MgR\cos\theta
Differentiate it by $\theta$ =>
  \frac{\partial\mathcal L}{\partial\theta} = \lambda_1\dot\phi^2\sin\theta\cos\theta +
  MgR\sin\theta
""",
        "p_psi in page:1 depends on the coordinates and velocities",
    ),
    "set and then differentiated": (
        r"""
Set $\dot\theta = 0$ in (3.53) =>
  \mathcal L = \tfrac12\lambda_1\dot\phi^2\sin^2\theta + \tfrac12\lambda_3(\dot\psi +
  \dot\phi\cos\theta)^2 - MgR\cos\theta
Differentiate it by $\dot\theta$ => \frac{\partial\mathcal L}{\partial\dot\theta} = 0
""",
        "holds where something is set: it can't be differentiated by thetadot",
    ),
    "the rate of what is set at a moment": (
        r"""
Set $\dot\phi = 0$ in the spin momentum => p_\psi = \lambda_3\dot\psi
Take the rate of it => \frac{d}{dt}p_\psi = \lambda_3\ddot\psi
""",
        "holds where something is set, at a moment",
    ),
    "along the motion only": (
        r"Differentiate the balance by $\theta$ => 0 = \lambda_1\dot\phi^2",
        "holds along the motion only",
    ),
    "= where ≈ follows": (
        r"""
Neglect $MgR\sin\theta$ in the balance, for large $p_\psi$ =>
  0 = \lambda_1\dot\phi^2\sin\theta\cos\theta - p_\psi\dot\phi\sin\theta
""",
        "only ≈ follows",
    ),
    "= for the sum of what is approximate": (
        r"""
Expand the rate of spin to second order in $\omega_1$ =>
  \dot\omega_3 \approx \frac{\lambda_1 - \lambda_2}{\lambda_3}\omega_1\omega_2
Add it to the sum of the pair =>
  \dot\omega_1 + \dot\omega_2 + \dot\omega_3 = \frac{\lambda_1 -
  \lambda_2}{\lambda_3}\omega_1\omega_2
""",
        "only ≈ follows",
    ),
    "a sum with what was neglected": (
        r"""
Neglect $MgR\sin\theta$ in the balance, for large $p_\psi$ =>
  0 \approx \lambda_1\dot\phi^2\sin\theta\cos\theta - p_\psi\dot\phi\sin\theta
Subtract the balance from it => 0 \approx -MgR\sin\theta
""",
        "of what is neglected no order is known",
    ),
    "≈ where nothing is neglected": (
        r"""
Divide the balance by $\sin\theta$ => 0 \approx \lambda_1\dot\phi^2\cos\theta - p_\psi\dot\phi + MgR
""",
        "nothing was neglected",
    ),
    "a root of one by a cosine of any sign": (
        r"""
Call the amplitude => \chi = \sqrt{\cos\theta}
Call the excess => \tau = \frac1\chi
Put the amplitude into it => \tau = \sqrt{\frac1{\cos\theta}}
""",
        "does not arrive",
    ),
    "a root of one by another positive cosine": (
        r"""
Call the amplitude => \chi = \sqrt{\cos\theta}
Call the excess => \tau = \frac1\chi
Put the amplitude into it, for $\cos\phi > 0$ => \tau = \sqrt{\frac1{\cos\theta}}
""",
        "does not arrive",
    ),
    "one root of two": (
        r"""
Divide the balance by $\sin\theta$ => 0 = \lambda_1\dot\phi^2\cos\theta - p_\psi\dot\phi + MgR
Solve it for $\dot\phi$ =>
  \dot\phi = \frac{p_\psi - \sqrt{p_\psi^2 - 4\lambda_1 MgR\cos\theta}}{2\lambda_1\cos\theta}
""",
        "there is another root",
    ),
    "a root without its sign": (
        r"""
Square the spin momentum => p_\psi^2 = \lambda_3^2(\dot\psi + \dot\phi\cos\theta)^2
Take the root of it => p_\psi = \lambda_3(\dot\psi + \dot\phi\cos\theta)
""",
        "the root is ±: say for which sign of p_psi",
    ),
    "more than its order": (
        r"""
Call the ratio => \mu = \frac{1}{1 - \varepsilon}
Expand it to first order in $\varepsilon$ => \mu \approx 1 + \varepsilon
Divide it by $\varepsilon$ =>
  \frac{\mu}{\varepsilon} \approx \frac{1}{\varepsilon} + 1 + \varepsilon
""",
        "does not arrive",
    ),
    "premises that contradict each other": (
        r"""
Put the deviation and the other deviation into the spin momentum => p_\psi = \lambda_3\dot\psi
""",
        "contradicts itself: see The other deviation",
    ),
    "an acceleration can't be defined": (
        r"Call the acceleration => \ddot\theta = \kappa\sin\theta",
        "is a coordinate or a rate",
    ),
    "a letter is defined twice": (
        r"Call the energy again => T = \lambda_1\dot\theta^2",
        "T stands for something already",
    ),
    "a number that changes": (
        r"Call the frequency => \Omega_b = \frac{(\lambda_1 - \lambda_3)\omega_3}{\lambda_1}",
        "Omega_b is a number, and this changes in time",
    ),
    "nothing is said": (
        r"Rearrange the balance => \lambda_1 = \lambda_1",
        "it says nothing",
    ),
}

REFUSED |= {
    "a sign that is not known": (
        r"""
Take the sign of the rate of spin, for $\lambda_1 > \lambda_2$ and $\omega_1 > 0$ =>
  \dot\omega_3 > 0
""",
        "the sign is not known",
    ),
    "the other sign": (
        r"""
Take the sign of the rate of spin, for $\lambda_1 > \lambda_2$, $\omega_1 > 0$ and $\omega_2 > 0$ =>
  \dot\omega_3 < 0
""",
        "the move gives >, the line says <",
    ),
    "what is set stands there still": (
        r"""
Set $\lambda_2 = \lambda_1$ in the first of Euler's equations =>
  \lambda_1\dot\omega_1 = (\lambda_2 - \lambda_3)\omega_2\omega_3
""",
        "lambda2 is set and stands there still",
    ),
    "solved for what does not stand there": (
        r"Solve the rate of spin for $\dot{\boldsymbol\zeta}$ => \dot{\boldsymbol\zeta} = 0",
        "fewer equations than unknowns",
    ),
    "a condition without need": (
        r"""
Take the sign of the rate of spin, for $\lambda_1 \ne \lambda_2$, $\lambda_3 > \lambda_1$, $\omega_1
  \ne 0$ and $\omega_2 \ne 0$ =>
  \dot\omega_3 \ne 0
""",
        "is a condition without need",
    ),
    "the sign of what is approximate": (
        r"""
Expand the rate of spin to second order in $\omega_1$ =>
  \dot\omega_3 \approx \frac{\lambda_1 - \lambda_2}{\lambda_3}\omega_1\omega_2
Take the sign of it, for $\lambda_1 > \lambda_2$, $\omega_1 > 0$ and $\omega_2 > 0$ =>
  \dot\omega_3 > 0
""",
        "is approximate: what is left out of it is not known",
    ),
    "integrated without a start": (
        r"""
Integrate the pair from $\omega_1 = \omega_0$ =>
  \omega_1 = \omega_0\cos\omega_{3,0}t, \quad \omega_2 = -\omega_0\sin\omega_{3,0}t
""",
        "where omega2 starts is not said",
    ),
    "fewer equations than letters": (
        r"""
Integrate the sum of the pair from $\omega_1 = 0$ and $\omega_2 = 0$ =>
  \omega_1 = \omega_0^2t, \quad \omega_2 = -\omega_0^2t
""",
        "as many equations as letters",
    ),
    "a solution that is not the only one": (
        r"Integrate a root from $\omega_3 = 0$ => \omega_3 = 0",
        "the rates are not smooth functions",
    ),
    "integrated from the wrong start": (
        r"""
Integrate the pair from $\omega_1 = 0$ and $\omega_2 = \omega_0$ =>
  \omega_1 = \omega_0\cos\omega_{3,0}t, \quad \omega_2 = -\omega_0\sin\omega_{3,0}t
""",
        "omega1 does not start there",
    ),
    "a letter of one index": (
        "Exchange $k$ and $l$ in the mass of a particle => m_k = M",
        "m_k with the other index has no letter",
    ),
    "another thing under a brace": (
        r"""
Put the place of $\delta_k$ and the force density into the external torque =>
  \mathbf N^{(e)} = \sum_k\underbrace{\mathbf r_k}_{\equiv 2\mathbf r_k}\times\mathbf F_k^{(e)}
""",
        "the move does not arrive here",
    ),
    "a first integral that starts elsewhere": (
        r"""
Integrate the power from $\dot{\mathbf e}_3 = 0$ and $\theta = \theta_0$ =>
  \tfrac12\lambda_1\dot{\mathbf e}_3^2 = MgR(\cos\theta_i - \cos\theta)
""",
        "this does not hold at the start",
    ),
    "a start that stands nowhere": (
        r"""
Integrate the power from $\dot{\mathbf e}_3 = 0$, $\theta = \theta_i$ and $\phi = 0$ =>
  \tfrac12\lambda_1\dot{\mathbf e}_3^2 = MgR(\cos\theta_i - \cos\theta)
""",
        "phi does not stand there",
    ),
    "an integral of what is set": (
        r"""
Set $\dot\theta = 0$ in the power => \lambda_1\,\dot{\mathbf e}_3\cdot\ddot{\mathbf e}_3 = 0
Integrate it from $\dot{\mathbf e}_3 = 0$ => \dot{\mathbf e}_3^2 = 0
""",
        "holds at a moment",
    ),
}


REFUSED |= {
    "inequalities that say opposite things": (
        INEQUALITIES
        + r"""  \tau > \chi
Add it to $\phi^2$ => \phi^2 + \tau < 2\chi
""",
        "nothing follows for the sum",
    ),
    "an inequality times what may be negative": (
        INEQUALITIES
        + r"""  \chi < \tau
Add $\psi$ times it to $\phi^2$ => \phi^2 + \psi\chi < \chi + \psi\tau
""",
        "psi has no known sign: an inequality may turn round",
    ),
    "the rate of a component along an axis that turns": (
        r"""
Set $\mathbf N = 0$ at all times in the law of angular momentum => \dot{\mathbf L} = 0
Take the component of it along $\mathbf e_3$ => \mathbf e_3\cdot\dot{\mathbf L} = 0
Integrate it => L_3 = \text{const}
""",
        "the move does not arrive",
    ),
    "an inequality the wrong way round": (
        INEQUALITIES
        + r"""  \tau > \chi
Subtract it from $\phi^2$ => \phi^2 - \tau > 0
""",
        "the move gives <, the line says >",
    ),
    "a logarithm of what is negative": (
        r"""
Call the amplitude => \chi = -\exp\theta
Take the logarithm of it => \log\chi = \theta
""",
        "the logarithm of what is not positive",
    ),
    "a sine of a vector": (
        r"Take the sine of the law of angular momentum => \dot{\mathbf L} = \mathbf N",
        "a function of what is no scalar",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_does_not_follow_is_refused(name: str) -> None:
    page, reason = REFUSED[name]
    assert reason in last(page)


def test_conditions_of_a_division_are_inherited() -> None:
    first, second = judged(
        FOLLOWS["divide"]
        + r"""
Put the spin momentum into it =>
  0 = \lambda_1\dot\phi^2\cos\theta - \lambda_3(\dot\psi + \dot\phi\cos\theta)\dot\phi + MgR
"""
    )
    assert [str(c.expression) for c in first.known.conditions] == ["sin(theta)"]
    assert first.known.conditions == second.known.conditions
    assert second.known.conditions[0].lost


def test_an_equation_is_cited_by_its_left_side() -> None:
    """Or as it stands above: else any right side would do."""
    page = r"Divide $\mathbf N_{\text{in}} = 0$ by $M$ => \frac{\mathbf N_{\text{in}}}{M} = 0"
    lecture = lecture_of(LAWS, page)
    [(_, _, problem)] = lecture.unread()
    assert "a line goes by its number, its name, its left side in dollars" in problem


def test_what_equals_a_square_is_not_negative():
    """Of θ² = χ the root says nothing of χ; of a letter that is no square it does."""
    squared = judged(FOLLOWS["a negative root"])[-1]
    bare = judged(r"Take the root of the other deviation => \sqrt\delta = \sqrt2")[-1]
    assert squared.follows
    assert bare.follows
    assert "≥" not in {c.relation for c in squared.known.conditions}
    assert "≥" in {c.relation for c in bare.known.conditions}
