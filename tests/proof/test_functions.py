"""Moves with what is a function of other letters, and with what is constant."""

from __future__ import annotations

import pytest

from .pages import lecture as lecture_of

LAWS = r"""
# Laws
The Lagrangian => \mathcal L = \tfrac12\lambda_1\dot\phi^2\sin^2\theta - MgR\cos\theta \tag{3.53}
Along the motion, the first momentum =>
  p_\phi \equiv \lambda_1\dot\phi\sin^2\theta + p_\psi\cos\theta = \text{const} \tag{3.55}
Along the motion, the second momentum =>
  p_\psi \equiv \lambda_3(\dot\psi + \dot\phi\cos\theta) = \text{const} \tag{3.56}
Along the motion, the balance => \lambda_1\ddot\theta = MgR\sin\theta
Along the motion, the decay => \dot\omega_3 = \varepsilon\omega_3
The rate of precession => \Omega = \dot\phi
The slope of the rate =>
  \frac{\partial\Omega}{\partial\theta} = \frac{p_\psi -
  2\lambda_1\Omega\cos\theta}{\lambda_1\sin\theta}
The symmetry of the tensor => I^T = I
The spin => L_3 = \lambda_3\omega_3
The momentum along the axes =>
  \mathbf L = \lambda_3\omega_3\mathbf e_3 - \lambda_1\Omega\sin\theta\,\mathbf e_1'
"""

PRODUCT = r"""
Call the product => L = \hat{\mathbf z}\cdot I(\dot\phi\,\hat{\mathbf z} + \dot\psi\,\mathbf e_3)
"""

POTENTIAL = r"""
Call the effective potential => U = \frac{p_\psi^2}{2\lambda_3}\cos\theta + \Omega p_\phi
"""

SHORT = r"Put (3.56) into (3.55) => p_\phi - p_\psi\cos\theta = \lambda_1\dot\phi\sin^2\theta"

FALL = r"""
Call the fall => \eta = \theta - \theta_i
Solve it for $\theta$ => \theta = \theta_i + \eta
"""

FOLLOWS = {
    "what the coordinates determine is no function of a velocity": PRODUCT
    + r"""
Differentiate it by $\dot\phi$ =>
  \frac{\partial L}{\partial\dot\phi} = \hat{\mathbf z}\cdot I\hat{\mathbf z}
""",
    "a symmetric operator stands behind either vector": r"""
Call the product => I_{xz} = \hat{\mathbf z}\cdot I\mathbf e_3 + \mathbf e_3\cdot I\hat{\mathbf z}
Put the symmetry of the tensor into it => I_{xz} = 2\mathbf e_3\cdot I\hat{\mathbf z}
""",
    "the slope at constant momenta, with the chain rule": POTENTIAL
    + r"""
Differentiate it by $\theta$, with the slope of the rate =>
  \frac{\partial U}{\partial\theta} = -\frac{p_\psi^2}{2\lambda_3}\sin\theta + p_\phi\frac{p_\psi
  - 2\lambda_1\Omega\cos\theta}{\lambda_1\sin\theta}
Set $p_\phi = 0$ in it => \frac{\partial U}{\partial\theta} = -\frac{p_\psi^2}{2\lambda_3}\sin\theta
""",
    "the rate of a function": r"""
Call the effective potential => U = \frac{p_\psi^2}{2\lambda_3}\cos\theta
Call the double => E = 2U
Take the rate of it, with (3.55) and (3.56) => \dot E = 2\frac{\partial U}{\partial\theta}\dot\theta
""",
    "what is constant is cited": r"""
Call the amplitude, with (3.55) and (3.56) => A = \frac{p_\phi}{p_\psi}
""",
    "at the start and for ever": SHORT
    + r"""
Set $\dot\phi = 0$ and $\theta = \theta_i$ at the start in it, with (3.55) and (3.56) =>
  p_\phi = p_\psi\cos\theta_i
Take the rate of it => \dot p_\phi = \dot p_\psi\cos\theta_i
""",
    "put in before it is expanded": FALL
    + r"""
Expand the balance to first order in $\eta$, with it =>
  \lambda_1\ddot\theta \approx MgR(\sin\theta_i + \eta\cos\theta_i)
""",
    "a vector times an equation": r"""
Subtract $\mathbf e_3$ times the spin from the momentum along the axes =>
  \mathbf L - L_3\mathbf e_3 = -\lambda_1\Omega\sin\theta\,\mathbf e_1'
""",
}

REFUSED = {
    "what the coordinates determine changes with them": (
        PRODUCT + r"Differentiate it by $\theta$ => \frac{\partial L}{\partial\theta} = 0",
        "depends on the coordinates and velocities",
    ),
    "an operator that is not known to be symmetric": (
        r"""
Call the product => I_{xz} = \hat{\mathbf z}\cdot I\mathbf e_3 + \mathbf e_3\cdot I\hat{\mathbf z}
Rewrite it => I_{xz} = 2\mathbf e_3\cdot I\hat{\mathbf z}
""",
        "does not arrive here",
    ),
    "a potential is no function of a velocity": (
        POTENTIAL
        + r"Differentiate it by $\dot\theta$ => \frac{\partial U}{\partial\dot\theta} = 0",
        "U is no function of thetadot",
    ),
    "the chain rule is left out": (
        POTENTIAL
        + r"""
Differentiate it by $\theta$, with the slope of the rate =>
  \frac{\partial U}{\partial\theta} = -\frac{p_\psi^2}{2\lambda_3}\sin\theta
""",
        "does not arrive here",
    ),
    "Routh's trap with a rate of precession": (
        r"""
Put the rate of precession into (3.53) =>
  \mathcal L = \tfrac12\lambda_1\Omega^2\sin^2\theta - MgR\cos\theta
Differentiate it by $\theta$ =>
  \frac{\partial\mathcal L}{\partial\theta} = \lambda_1\Omega^2\sin\theta\cos\theta +
  MgR\sin\theta
""",
        "Omega in page:1 depends on the coordinates and velocities",
    ),
    "the rate of a function of momenta that may change": (
        r"""
Call the effective potential => U = \frac{p_\psi^2}{2\lambda_3}\cos\theta
Call the double => E = 2U
Take the rate of it => \dot E = 2\frac{\partial U}{\partial\theta}\dot\theta
""",
        "does not arrive here",
    ),
    "not known to be constant": (
        r"Call the amplitude, with (3.56) => A = \frac{p_\phi}{p_\psi}",
        "A is a number, and this changes in time",
    ),
    "at the start, and later something else": (
        SHORT
        + r"""
Set $\dot\phi = 0$ at the start in it, with (3.55) and (3.56) => p_\phi = p_\psi\cos\theta
""",
        "this changes after the start",
    ),
    "at the start, without what keeps it": (
        SHORT
        + r"""
Set $\dot\phi = 0$ and $\theta = \theta_i$ at the start in it => p_\phi = p_\psi\cos\theta_i
""",
        "this changes after the start",
    ),
    "a function of what, is not said": (
        POTENTIAL
        + r"""
Differentiate it by $\theta$ =>
  \frac{\partial U}{\partial\theta} = -\frac{p_\psi^2}{2\lambda_3}\sin\theta +
  p_\phi\frac{\partial\Omega}{\partial\theta}
""",
        "Omega is a function of others only if that is cited",
    ),
    "a rate of what is a function of what is not said": (
        POTENTIAL
        + r"""
Take the rate of it, with (3.55) and (3.56) =>
  \frac{d}{dt}U = -\frac{p_\psi^2}{2\lambda_3}\dot\theta\sin\theta +
  p_\phi\frac{\partial\Omega}{\partial\theta}\dot\theta
""",
        "is a function of others only if that is cited",
    ),
    "a derivative in time of what is set": (
        r"""
Call the double => p_\theta = p_\phi\cos\theta
Take the rate of it => \dot p_\theta = \dot p_\phi\cos\theta - p_\phi\dot\theta\sin\theta
Set $p_\phi = 0$ in it => \dot p_\theta = 0
""",
        "what is set at a moment says nothing of a derivative",
    ),
}


def last(page: str) -> str:
    """Why the last line of a page does not follow, or nothing."""
    lecture = lecture_of(LAWS, page)
    assert not list(lecture.unread())
    *before, line = [lecture.judged(line.id) for line in lecture.texts[1].lines]
    assert all(each.follows for each in before), [str(each.problem) for each in before]
    return str(line.problem or "")


@pytest.mark.parametrize("name", FOLLOWS)
def test_a_performed_move_arrives(name: str) -> None:
    assert last(FOLLOWS[name]) == ""


@pytest.mark.parametrize("name", REFUSED)
def test_what_does_not_follow_is_refused(name: str) -> None:
    page, reason = REFUSED[name]
    assert reason in last(page)
