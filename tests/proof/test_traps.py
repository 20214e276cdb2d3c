"""Pages that lie: each has a line that is false, or that does not follow from what it cites."""

from __future__ import annotations

import pytest

from rigidtop.derivations.letters import LETTERS
from rigidtop.notation import NOTES
from rigidtop.read.page import read_lecture

LAWS = r"""
# Laws

The kinetic energy:

$$T = \tfrac12\lambda_1(\dot\phi^2\sin^2\theta + \dot\theta^2)
+ \tfrac12\lambda_3(\dot\psi + \dot\phi\cos\theta)^2$$

Along the motion, the balance:

$$0 = \lambda_1\dot\phi^2\sin\theta\cos\theta - p_\psi\dot\phi\sin\theta + MgR\sin\theta$$

Along the motion, Euler's third equation:

$$\lambda_3\dot\omega_3 = (\lambda_1 - \lambda_2)\omega_1\omega_2$$

Along the motion, the first of Euler's equations:

$$\lambda_1\dot\omega_1 = (\lambda_2 - \lambda_3)\omega_2\omega_3$$

Along the motion, the rate of spin:

$$\dot\omega_3 = \frac{\lambda_1 - \lambda_2}{\lambda_3}\omega_1\omega_2$$

Along the motion, the pair:

$$\dot\omega_1 = \omega_{3,0}\omega_2, \quad \dot\omega_2 = -\omega_{3,0}\omega_1$$

Along the motion, the power:

$$\lambda_1\,\dot{\mathbf e}_3\cdot\ddot{\mathbf e}_3 = MgR\,\dot\theta\sin\theta$$

Along the motion, the drift:

$$\dot\omega_3 > 0$$

Along the motion, the sum law:

$$T = \lambda_3\dot\omega_3 + E$$

Not zero:

$$\mathbf L \ne 0$$

Three moments:

$$\lambda_1 \ne \lambda_2 \ne \lambda_3$$

The far:

$$\omega_2 = \frac{\omega_1}{\varepsilon} + \frac{\omega_1}{1-\varepsilon}$$
"""


def problems(page: str) -> list[str]:
    """What is said against a page below the laws."""
    lecture = read_lecture([("laws", LAWS), ("page", page)], LETTERS, NOTES)
    found = [problem for _, _, problem in lecture.problems()]
    judged = [lecture.judged(line.id) for line in lecture.texts[1].lines]
    return found + [str(each.problem) for each in judged if each.problem is not None]


TRAPS = {
    "an inequality is put in": (
        r"""
Put the drift into the sum law:

$$T = E$$
""",
        "only an equation can be put in",
    ),
    "the square of what is not zero": (
        r"""
Dot not zero with itself:

$$\mathbf L\cdot\mathbf L = 0$$
""",
        "a relation ≠ can't be treated so",
    ),
    "≠ is not handed on": (
        r"""
Rewrite three moments:

$$\lambda_1 \ne \lambda_3$$
""",
        "does not arrive",
    ),
    "an inequality is set": (
        r"""
Set $\lambda_1 > \lambda_2$ in Euler's third equation:

$$\lambda_3\dot\omega_3 = 0$$
""",
        "a letter is set with one =",
    ),
    "what is set nearly": (
        r"""
Set $\lambda_1 \approx \lambda_2$ in Euler's third equation:

$$\lambda_3\dot\omega_3 = 0$$
""",
        "a letter is set with one =",
    ),
    "two things set in one chain": (
        r"""
Set $\lambda_1 = \lambda_2 = \lambda_3$ in Euler's third equation:

$$\lambda_3\dot\omega_3 = 0$$
""",
        "a letter is set with one =",
    ),
    "one or the other is set": (
        r"""
Set $\omega_1 = 0$ or $\omega_2 = 0$ in Euler's third equation:

$$\lambda_3\dot\omega_3 = 0$$
""",
        "with “and” between",
    ),
    "under one condition or the other": (
        r"""
Take the sign of the rate of spin, for $\lambda_1 > \lambda_2$ or $\omega_1 > 0$ or $\omega_2 < 0$:

$$\dot\omega_3 < 0$$
""",
        "with “and” between",
    ),
    "two conditions in a chain": (
        r"""
Take the sign of the rate of spin, for $0 < \omega_1 < \omega_2$ and $\lambda_1 > \lambda_2$:

$$\dot\omega_3 > 0$$
""",
        "two sides, and another condition",
    ),
    "a start that is no number": (
        r"""
Integrate the pair from $\omega_1 > 0$ and $\omega_2 = 0$:

$$\omega_1 = 0, \quad \omega_2 = 0$$
""",
        "a letter is set with one =",
    ),
    "constant at a moment": (
        r"""
Set $\omega_1 = 0$ in the rate of spin:

$$\omega_3 = \text{const}$$
""",
        "set at a moment does not say that something is constant",
    ),
    "set, put in and differentiated": (
        r"""
Set $\omega_1 = 0$ in the rate of spin:

$$\dot\omega_3 = 0$$

Put it into the sum law:

$$T = E, \quad \frac{d}{dt}\dot\omega_3 = 0$$
""",
        "says nothing of a derivative",
    ),
    "integrated with what is set at a moment": (
        r"""
Set $\dot\omega_1 = 0$ in the first of Euler's equations:

$$0 = (\lambda_2 - \lambda_3)\omega_2\omega_3$$

Divide it by $\omega_3(\lambda_2 - \lambda_3)$:

$$\omega_2 = 0$$

Integrate Euler's third equation, with it:

$$\omega_3 = \text{const}$$
""",
        "set at a moment does not say",
    ),
    "the square of what is large has a larger error": (
        r"""
Expand the far to zeroth order in $\varepsilon$:

$$\omega_2 \approx \frac{\omega_1}{\varepsilon} + \omega_1$$

Square it:

$$\omega_2^2 \approx \omega_1^2(\frac1{\varepsilon} + 1)^2$$
""",
        "its error is of order 0",
    ),
    "an error is forgotten in the next expansion": (
        r"""
Call the ratio:

$$\mu = \frac{1}{1 - \varepsilon} + \frac{1}{1-\delta}$$

Expand it to first order in $\varepsilon$:

$$\mu \approx 1 + \varepsilon + \frac{1}{1-\delta}$$

Expand it to first order in $\delta$:

$$\mu \approx 2 + \varepsilon + \delta$$

Multiply it by $1 + \varepsilon$:

$$(1+\varepsilon)\mu \approx (2 + \varepsilon + \delta)(1 + \varepsilon)$$
""",
        "two small quantities at once",
    ),
    "a definition with <": (
        r"""
Call the ratio:

$$\mu < \lambda_1/\lambda_3$$
""",
        "a definition has a letter on its left",
    ),
    "a brace of a definition that lies": (
        r"""
Call the ratio:

$$\mu = \underbrace{\frac{\lambda_1}{\lambda_3}}_{\equiv 1}$$
""",
        "nothing comes of this move",
    ),
    "a definition of a component that is another one": (
        r"""
Call the component:

$$\omega_1' = \omega_3$$
""",
        "is the component of",
    ),
    "any vector is a certain one": (
        r"""
Call the arbitrary:

$$\mathbf u = \mathbf e_1$$
""",
        "has a meaning of its own",
    ),
    "a unit vector is defined": (
        r"""
Call the axis:

$$\hat{\mathbf x} = 2\mathbf e_1$$
""",
        "has a meaning of its own",
    ),
    "a potential of velocities": (
        r"""
Call the potential energy:

$$V = \lambda_1\dot\theta^2$$

Subtract it from the kinetic energy:

$$T - V = \tfrac12\lambda_1(\dot\phi^2\sin^2\theta + \dot\theta^2)
+ \tfrac12\lambda_3(\dot\psi + \dot\phi\cos\theta)^2 - \lambda_1\dot\theta^2$$
""",
        "is a function of the coordinates alone",
    ),
    "a name is given twice": (
        r"""
Call the balance:

$$\mu = 1$$

Rearrange the balance:

$$\mu - 1 = 0$$
""",
        "names something above",
    ),
    "a number is given twice": (
        r"""
Rewrite the balance:

$$\lambda_1 = \lambda_2 \tag{9.9}$$

Rewrite the rate of spin:

$$\dot\omega_3 = \frac{\lambda_1 - \lambda_2}{\lambda_3}\omega_1\omega_2 \tag{9.9}$$
""",
        "does not arrive",
    ),
    "a brace of an integral that lies": (
        r"""
Integrate the power from $\dot{\mathbf e}_3 = 0$ and $\theta = \theta_i$:

$$\underbrace{\tfrac12\lambda_1\dot{\mathbf e}_3^2}_{T} = MgR(\cos\theta_i - \cos\theta)$$
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
Divide the balance by $\sin\theta$:

$$0 = \lambda_1\dot\phi^2\cos\theta - p_\psi\dot\phi + MgR \tag{9.9}$$

Rearrange (9.9):

$$p_\psi\dot\phi = \lambda_1\dot\phi^2\cos\theta + MgR \tag{9.9}$$
"""
    assert problems(page) == []
