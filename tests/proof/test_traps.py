"""Pages that lie: each has a line that is false, or that does not follow from what it cites."""

from __future__ import annotations

import pytest

from .pages import lecture as lecture_of

LAWS = r"""
# Laws
The kinetic energy =>
  T = \tfrac12\lambda_1(\dot\phi^2\sin^2\theta + \dot\theta^2) + \tfrac12\lambda_3(\dot\psi +
  \dot\phi\cos\theta)^2
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
Along the motion, the power =>
  \lambda_1\,\dot{\mathbf e}_3\cdot\ddot{\mathbf e}_3 = MgR\,\dot\theta\sin\theta
Along the motion, the drift => \dot\omega_3 > 0
Along the motion, the sum law => T = \lambda_3\dot\omega_3 + E
Not zero => \mathbf L \ne 0
Three moments => \lambda_1 \ne \lambda_2 \ne \lambda_3
Along the motion, the mean => \dot{\mathbf L} \approx \mathbf N
The transport theorem =>
  \left(\frac{\partial\mathbf L}{\partial t}\right)_{\text{space}} = \left(\frac{\partial\mathbf
  L}{\partial t}\right)_{\text{body}} + \boldsymbol\omega\times\mathbf L
The deviation => \delta = 1
The other deviation => \delta = 2
The height => E = MgR\cos\theta
The use => T = MgR\cos\theta
The product => \omega_1\omega_2 = 0
The squares => \omega_1^2 = \omega_2^2
The quotient => \mu = \frac{1}{1-\varepsilon}
The rest => \beta = \frac{\mu - 1 - \varepsilon}{\varepsilon^2}
The rest on the left => \frac{\mu}{\varepsilon^2} = \beta
The far => \omega_2 = \frac{\omega_1}{\varepsilon} + \frac{\omega_1}{1-\varepsilon}
The bound => U > MgR\cos\theta + MgR
The steady angle => \theta = \theta_0
The spin => c_3 = \lambda_3\dot\psi\cos\theta
The use of spin => T = \tfrac12\lambda_3\dot\psi^2
Equal ones => L_1 = L_2
The opposite => L_1 = -\lambda_1\omega_1
The use of angles => T_{tot} = MgR\,\theta^2
The turned => L_1\cos\theta = L_2\,\theta\cos\theta
The sum => \tau = \delta + \varepsilon
The share => \epsilon_0 = \frac{\tau - \delta + \varepsilon^2}{\varepsilon}
The square below zero => \beta^2 = -1
The tie => \lambda_3 = 2\lambda_1
The torque => \mathbf N = \boldsymbol\omega\times\mathbf L
"""


def problems(page: str) -> list[str]:
    """What is said against a page below the laws."""
    lecture = lecture_of(LAWS, page)
    found = [problem for _, _, problem in lecture.unread()]
    judged = [lecture.judged(line.id) for line in lecture.texts[1].lines]
    return found + [str(each.problem) for each in judged if each.problem is not None]


TRAPS = {
    "two motions in one line": (
        r"""
Integrate the pair from $\omega_1 = \omega_0$ and $\omega_2 = 0$ =>
  \omega_1 = \omega_0\cos\omega_{3,0}t, \quad \omega_2 = -\omega_0\sin\omega_{3,0}t
Integrate the pair from $\omega_1 = 0$ and $\omega_2 = 0$ => \omega_1 = 0, \quad \omega_2 = 0
Rewrite both => \omega_1 = 0, \quad \omega_1 = \omega_0\cos\omega_{3,0}t
""",
        "starts in two ways",
    ),
    "the time stands still": (
        r"""
Integrate the pair from $\omega_1 = \omega_0$ and $\omega_2 = 0$ =>
  \omega_1 = \omega_0\cos\omega_{3,0}t, \quad \omega_2 = -\omega_0\sin\omega_{3,0}t
Set $t = 0$ at all times in it => \omega_1 = \omega_0, \quad \omega_2 = 0
""",
        "t is set at a moment only",
    ),
    "an axis that is too long": (
        r"Set $\mathbf e_3 = 2\hat{\mathbf x}$ in the power => 0 = MgR\,\dot\theta\sin\theta",
        "e3 is a unit vector",
    ),
    "a slope by what it is no function of": (
        r"""
Call the fall => \eta = \theta - \theta_i
Differentiate the height by $\eta$ => \frac{\partial E}{\partial\eta} = 0
""",
        "E is no function of eta",
    ),
    "a slope by what is no letter": (
        r"""
Differentiate the height by $2\theta$ => \frac{\partial E}{\partial\theta} = -MgR\sin\theta
""",
        "is no letter to differentiate by",
    ),
    "what is small hides in a letter": (
        r"""
Call the large => \eta = \frac{1}{\varepsilon}
Multiply the quotient by $1 + \eta\varepsilon$ =>
  (1 + \eta\varepsilon)\mu = \frac{1 + \eta\varepsilon}{1 - \varepsilon}
Expand it to zeroth order in $\varepsilon$ => (1 + \eta\varepsilon)\mu \approx 1
""",
        "eta is defined by epsilon: put its definition in first",
    ),
    "a definition holds where that does which keeps it": (
        r"""
Set $\omega_1 = 0$ at all times in the rate of spin => \dot\omega_3 = 0
Call the number, with it => \Omega_b = \frac{(\lambda_1 - \lambda_3)\omega_3}{\lambda_1}
Differentiate it by $\omega_3$ => 0 = \frac{\lambda_1 - \lambda_3}{\lambda_1}
""",
        "the number holds along the motion only",
    ),
    "a number that is kept approximately": (
        r"""
Expand the rate of spin to first order in $\omega_1$ and $\omega_2$ => \dot\omega_3 \approx 0
Call the number, with it => \Omega_b = \frac{(\lambda_1 - \lambda_3)\omega_3}{\lambda_1}
""",
        "at a moment, or approximately, does not keep it",
    ),
    "solved for what two equations say": (
        r"Solve the deviation and the other deviation for $\delta$ => \delta = 1",
        "more equations than unknowns",
    ),
    "a display behind its sentence": (
        "\nRewrite the use: $$T = 0$$\n",
        "a display stands by itself",
    ),
    "divided by what is cited as 0": (
        r"""
Set $\lambda_2 = \lambda_1$ in Euler's third equation => \lambda_3\dot\omega_3 = 0
Divide it by $\lambda_1 - \lambda_2$ => \frac{\lambda_3\dot\omega_3}{\lambda_1 - \lambda_2} = 0
""",
        "a division by 0",
    ),
    "divided by the rate of what stays": (
        r"""
Set $\theta = \theta_0$ at all times in the use => T = MgR\cos\theta_0
Divide it by $\dot\theta$ => \frac{T}{\dot\theta} = \frac{MgR\cos\theta_0}{\dot\theta}
""",
        "a division by 0",
    ),
    "1 = 0": (
        r"Divide the product by $\omega_1\omega_2$ => 1 = 0",
        "this can't hold",
    ),
    "0 where it was divided by": (
        r"""
Divide the product by $\omega_1$ => \omega_2 = 0
Put it into the squares => \omega_1^2 = 0
""",
        "this can't hold",
    ),
    "two moments whose sum is 0": (
        r"""
Set $\lambda_1 = -\lambda_2$ in Euler's third equation =>
  \lambda_3\dot\omega_3 = -2\lambda_2\omega_1\omega_2
""",
        "this can't hold",
    ),
    "a definition of 0": (
        r"Call the zero => \alpha = \phi - \phi",
        "it is 0, or of another sign",
    ),
    "a length below 0": (
        "Call the length => a = -b",
        "it is 0, or of another sign",
    ),
    "all of it neglected": (
        r"Neglect $MgR\cos\theta$ in the use, for small $g$ => T \approx 0",
        "nothing is left of a side",
    ),
    "an error as large as the result": (
        r"""
Expand the quotient to first order in $\varepsilon$ => \mu \approx 1 + \varepsilon
Put it into the rest => \beta \approx 0
""",
        "nothing is known",
    ),
    "an error that grows on the left": (
        r"""
Expand the quotient to first order in $\varepsilon$ => \mu \approx 1 + \varepsilon
Put it into the rest on the left => \frac{1 + \varepsilon}{\varepsilon^2} \approx \beta
Multiply it by $1 + \varepsilon$ =>
  \frac{(1 + \varepsilon)^2}{\varepsilon^2} \approx (1 + \varepsilon)\beta
""",
        "the line claims more than it has: its error is of order 0",
    ),
    "an inequality is put in": (
        "Put the drift into the sum law => T = E",
        "only an equation can be put in",
    ),
    "the square of what is not zero": (
        r"Dot not zero with itself => \mathbf L\cdot\mathbf L = 0",
        "a relation ≠ can't be treated so",
    ),
    "≠ is not handed on": (
        r"Rewrite three moments => \lambda_1 \ne \lambda_3",
        "does not arrive",
    ),
    "an inequality is set": (
        r"Set $\lambda_1 > \lambda_2$ in Euler's third equation => \lambda_3\dot\omega_3 = 0",
        "a letter is set with one =",
    ),
    "one or the other is set": (
        r"""
Set $\omega_1 = 0$ or $\omega_2 = 0$ in Euler's third equation => \lambda_3\dot\omega_3 = 0
""",
        "with “and” between",
    ),
    "two conditions in a chain": (
        r"""
Take the sign of the rate of spin, for $0 < \omega_1 < \omega_2$ and $\lambda_1 > \lambda_2$ =>
  \dot\omega_3 > 0
""",
        "two sides, and another condition",
    ),
    "constant at a moment": (
        r"Set $\omega_1 = 0$ in the rate of spin => \omega_3 = \text{const}",
        "set at a moment does not say that something is constant",
    ),
    "set, put in and differentiated": (
        r"""
Set $\omega_1 = 0$ in the rate of spin => \dot\omega_3 = 0
Put it into the sum law => T = E, \quad \frac{d}{dt}\dot\omega_3 = 0
""",
        "says nothing of a derivative",
    ),
    "integrated with what is set at a moment": (
        r"""
Set $\dot\omega_1 = 0$ in the first of Euler's equations =>
  0 = (\lambda_2 - \lambda_3)\omega_2\omega_3
Divide it by $\omega_3(\lambda_2 - \lambda_3)$ => \omega_2 = 0
Integrate Euler's third equation, with it => \omega_3 = \text{const}
""",
        "set at a moment does not say",
    ),
    "the square of what is large has a larger error": (
        r"""
Expand the far to zeroth order in $\varepsilon$ =>
  \omega_2 \approx \frac{\omega_1}{\varepsilon} + \omega_1
Square it => \omega_2^2 \approx \omega_1^2(\frac1{\varepsilon} + 1)^2
""",
        "its error is of order 0",
    ),
    "an error is forgotten in the next expansion": (
        r"""
Call the ratio => \eta = \frac{1}{1 - \varepsilon} + \frac{1}{1-\delta}
Expand it to first order in $\varepsilon$ => \eta \approx 1 + \varepsilon + \frac{1}{1-\delta}
Expand it to first order in $\delta$ => \eta \approx 2 + \varepsilon + \delta
Multiply it by $1 + \varepsilon$ =>
  (1+\varepsilon)\eta \approx (2 + \varepsilon + \delta)(1 + \varepsilon)
""",
        "two small quantities at once",
    ),
    "a definition with <": (
        r"Call the ratio => \eta < \lambda_1/\lambda_3",
        "a definition has a letter on its left",
    ),
    "a brace of a definition that lies": (
        r"Call the ratio => \eta = \underbrace{\frac{\lambda_1}{\lambda_3}}_{\equiv 1}",
        "nothing comes of this move",
    ),
    "a definition of a component that is another one": (
        r"Call the component => \omega_1' = \omega_3",
        "is the component of",
    ),
    "any vector is a certain one": (
        r"Call the arbitrary => \mathbf u = \mathbf e_1",
        "has a meaning of its own",
    ),
    "a potential of velocities": (
        r"""
Call the potential energy => V = \lambda_1\dot\theta^2
Subtract it from the kinetic energy =>
  T - V = \tfrac12\lambda_1(\dot\phi^2\sin^2\theta + \dot\theta^2) + \tfrac12\lambda_3(\dot\psi +
  \dot\phi\cos\theta)^2 - \lambda_1\dot\theta^2
""",
        "is a function of the coordinates alone",
    ),
    "a name is given twice": (
        r"""
Call the balance => \eta = 1
Rearrange the balance => \eta - 1 = 0
""",
        "names something above",
    ),
    "the slope of a bound": (
        r"""
Differentiate the bound by $\theta$ => \frac{\partial U}{\partial\theta} = -MgR\sin\theta
""",
        "a relation > can't be treated so",
    ),
    "an inequality where both sides vanish": (
        r"Set $\dot\omega_3 = 0$ in the drift => 0 > 0",
        "this can't hold",
    ),
    "a steady angle is put in and differentiated": (
        r"""
Put the steady angle into the use => T = MgR\cos\theta_0
Differentiate it by $\theta$ => \frac{\partial T}{\partial\theta} = 0
""",
        "holds along the motion only",
    ),
    "a number that velocities make is put in and differentiated": (
        r"""
Solve the spin for $\dot\psi$ => \dot\psi = \frac{c_3}{\lambda_3\cos\theta}
Put it into the use of spin => T = \frac{c_3^2}{2\lambda_3\cos^2\theta}
Differentiate it by $\theta$ =>
  \frac{\partial T}{\partial\theta} = \frac{c_3^2\sin\theta}{\lambda_3\cos^3\theta}
""",
        "holds along the motion only",
    ),
    "divided by what a law says is 0": (
        r"""
Multiply equal ones by $L_1$ => L_1^2 = L_1L_2
Multiply equal ones by $L_2$ => L_1L_2 = L_2^2
Subtract it from $L_1^2$ => L_1^2 - L_1L_2 = L_1L_2 - L_2^2
Divide it by $L_1 - L_2$ => L_1 = L_2
""",
        "a division by 0",
    ),
    "a root with two signs that a law excludes": (
        r"""
Square the opposite => L_1^2 = \lambda_1^2\omega_1^2
Take the root of it, for $L_1 > 0$ and $\omega_1 > 0$ => L_1 = \lambda_1\omega_1
""",
        "this can't hold",
    ),
    "set in what was divided by": (
        r"""
Divide the turned by $\cos\theta$ => L_1 = L_2\,\theta
Set $\theta = \frac\pi2$ in it => L_1 = \tfrac\pi2L_2
""",
        "a division by 0",
    ),
    "two moments in one line": (
        r"""
Set $\theta = 0$ in the use => T = MgR
Set $\theta = \theta_0$ in the use of angles => T_{tot} = MgR\,\theta_0^2
Add it to $T$ => T + T_{tot} = MgR + MgR\,\theta_0^2
""",
        "is set in two ways",
    ),
    "what was set stands there again": (
        r"""
Set $\theta = 0$ in the use => T = MgR
Add it to the use of angles => T + T_{tot} = MgR + MgR\,\theta^2
""",
        "theta is set and stands there still",
    ),
    "what was neglected is all that is left": (
        r"""
Neglect $\varepsilon$ in the sum, for small $\varepsilon$ => \tau \approx \delta
Put it into the share => \epsilon_0 \approx \varepsilon
""",
        "of what is neglected no order is known",
    ),
    "what is kept beside the neglected is set to 0": (
        r"""
Neglect $\varepsilon$ in the sum, for small $\varepsilon$ => \tau \approx \delta
Set $\delta = 0$ in it => \tau \approx 0
""",
        "nothing is known",
    ),
    "a square that is no number's": (
        r"Add the square below zero to the deviation => \beta^2 + \delta = 0",
        "this can't hold",
    ),
    "a vector set to another and to its opposite": (
        r"""
Set $\boldsymbol\omega = \Omega\hat{\mathbf z}$ in the torque =>
  \mathbf N = \Omega\hat{\mathbf z}\times\mathbf L \tag{9.1}
Set $\boldsymbol\omega = -\Omega\hat{\mathbf z}$ in the torque =>
  \mathbf N = -\Omega\hat{\mathbf z}\times\mathbf L \tag{9.2}
Add (9.1) to (9.2) => 2\mathbf N = 0
""",
        "is set in two ways",
    ),
    "a number that was tied in a line that is wrong": (
        r"""
Put the tie into the use of spin => T = 3\lambda_1\dot\psi^2
Differentiate it by $\lambda_1$ => \frac{\partial T}{\partial\lambda_1} = 3\dot\psi^2
""",
        "tied to other letters",
    ),
    "a brace of an integral that lies": (
        r"""
Integrate the power from $\dot{\mathbf e}_3 = 0$ and $\theta = \theta_i$ =>
  \underbrace{\tfrac12\lambda_1\dot{\mathbf e}_3^2}_{T} = MgR(\cos\theta_i - \cos\theta)
""",
        "does not arrive",
    ),
}


@pytest.mark.parametrize("name", TRAPS)
def test_a_trap_is_refused(name: str) -> None:
    page, reason = TRAPS[name]
    assert any(reason in problem for problem in problems(page)), problems(page)


def test_a_line_with_the_number_of_a_law_is_another_line() -> None:
    page = r"""
Divide the balance by $\sin\theta$ =>
  0 = \lambda_1\dot\phi^2\cos\theta - p_\psi\dot\phi + MgR \tag{9.9}
Rearrange (9.9) => p_\psi\dot\phi = \lambda_1\dot\phi^2\cos\theta + MgR \tag{9.9}
"""
    assert problems(page) == []
