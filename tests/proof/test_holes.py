"""Where something is said, of what it is small, and what the last line was: no page gets by."""

from __future__ import annotations

import pytest

from rigidtop.proof.lecture import Lecture
from rigidtop.proof.moves import Scope

from .pages import lecture as lecture_of

LAWS = r"""
# Laws
Definition. At the moment, the slip => \mathbf v_{tip} = v\,\hat{\mathbf x}
Along the motion, the balance => \lambda_1\ddot\theta = MgR\sin\theta - p_\psi\dot\phi\sin\theta
Along the motion, the steady balance =>
  0 = \lambda_1\cos\theta\,\Omega^2 - \lambda_3\omega_3\Omega + MgR
The discriminant => D = (\lambda_3\omega_3)^2 - 4\lambda_1MgR + 2\lambda_3MgR
Along the motion, the tip at rest => \dot{\mathbf r}_{tip} = 0
The spin => L_3 = \lambda_3\omega_3
"""

ROOTS = r"""
  \Omega_{first} =
  \frac{\lambda_3\omega_3 - \sqrt{(\lambda_3\omega_3)^2 - 4\lambda_1MgR\cos\theta}}
  {2\lambda_1\cos\theta}, \quad \Omega_{second} =
  \frac{\lambda_3\omega_3 + \sqrt{(\lambda_3\omega_3)^2 - 4\lambda_1MgR\cos\theta}}
  {2\lambda_1\cos\theta}
"""
MINUS_FIRST = ROOTS.replace("{first}", "-").replace("{second}", "+")
PLUS_FIRST = ROOTS.replace("{first}", "+").replace("{second}", "-")


def read(page: str) -> Lecture:
    return lecture_of(LAWS, page)


def last(page: str) -> str:
    """Why the last line of a page does not follow, or nothing."""
    lecture = read(page)
    problems = [problem for _, _, problem in lecture.unread()]
    if problems:
        return problems[-1]
    return str(lecture.judged(lecture.texts[1].lines[-1].id).problem or "")


SET = r"""
Set $\Omega = \Omega_{root}$ in the steady balance =>
  0 = \lambda_1\cos\theta\,\Omega_{root}^2 - \lambda_3\omega_3\Omega_{root} + MgR
Neglect $MgR$ in it, for large $\omega_3$ =>
  0 \approx \lambda_1\cos\theta\,\Omega_{root}^2 - \lambda_3\omega_3\Omega_{root}
"""
REFUSED = {
    "of the slow root the weight": (
        "Solve the steady balance for $\\Omega$ =>" + MINUS_FIRST + SET.replace("{root}", "-"),
        "for large omega3 M*R*g is not small beside -Omega_minus*lambda3*omega3, by what stands",
    ),
    "what holds at a moment has no rate": (
        r"Take the rate of the slip => \dot{\mathbf v}_{tip} = \dot v\,\hat{\mathbf x}",
        "its rate does not follow",
    ),
    "it is beneath another heading": (
        r"""
Divide the balance by $\lambda_1$ =>
  \ddot\theta = \frac{MgR\sin\theta - p_\psi\dot\phi\sin\theta}{\lambda_1}
### Another matter
Divide it by $2$ =>
  \tfrac12\ddot\theta = \frac{MgR\sin\theta - p_\psi\dot\phi\sin\theta}{2\lambda_1}
""",
        "beneath this heading",
    ),
    "a condition without need": (
        r"""
Divide the balance by $\lambda_1$, for $\sin\theta > 0$ =>
  \ddot\theta = \frac{MgR\sin\theta - p_\psi\dot\phi\sin\theta}{\lambda_1}
""",
        "is a condition without need",
    ),
    "small where, is not said": (
        r"""
Neglect $MgR\sin\theta$ in the balance => \lambda_1\ddot\theta \approx -p_\psi\dot\phi\sin\theta
""",
        "say where it is small",
    ),
    "the larger one is neglected": (
        r"""
Neglect $-p_\psi\dot\phi\sin\theta$ in the balance, for large $p_\psi$ =>
  \lambda_1\ddot\theta \approx MgR\sin\theta
""",
        "for large p_psi it is not small against what is kept",
    ),
    "one as large as the other": (
        r"""
Neglect $MgR\sin\theta$ in the balance, for small $\theta$ =>
  \lambda_1\ddot\theta \approx -p_\psi\dot\phi\sin\theta
""",
        "for small theta it is not small against what is kept",
    ),
    "as large a one is kept": (
        r"""
Neglect $-4\lambda_1MgR$ in the discriminant, for large $\omega_3$ =>
  D \approx (\lambda_3\omega_3)^2 + 2\lambda_3MgR
""",
        "for large omega3 it is no smaller than",
    ),
    "what is set does not stand there": (
        r"""
Set $\dot\theta = 0$ in the balance =>
  \lambda_1\ddot\theta = MgR\sin\theta - p_\psi\dot\phi\sin\theta
""",
        "thetadot does not stand in",
    ),
    "exchanged roots": (
        "Solve the steady balance for $\\Omega$ =>" + PLUS_FIRST,
        "is the other root",
    ),
    "exchanged roots below the horizontal": (
        "Solve the steady balance for $\\Omega$, for $\\cos\\theta < 0$ =>" + PLUS_FIRST,
        "is the other root",
    ),
}

FOLLOWS = {
    "of the fast root the weight": (
        "Solve the steady balance for $\\Omega$ =>" + MINUS_FIRST + SET.replace("{root}", "+")
    ),
    "of a rate of which nothing is known": (
        "Solve the steady balance for $\\Omega$ =>"
        + MINUS_FIRST
        + r"""
Neglect $MgR$ in the steady balance, for large $\omega_3$ =>
  0 \approx \lambda_1\cos\theta\,\Omega^2 - \lambda_3\omega_3\Omega
"""
    ),
    "of the slow root, of which nothing is said": SET.replace("{root}", "-"),
    "the smaller one is neglected": r"""
Neglect $MgR\sin\theta$ in the balance, for large $p_\psi$ =>
  \lambda_1\ddot\theta \approx -p_\psi\dot\phi\sin\theta
""",
    "both small ones are neglected": r"""
Neglect $-4\lambda_1MgR + 2\lambda_3MgR$ in the discriminant, for large $\omega_3$ =>
  D \approx (\lambda_3\omega_3)^2
""",
    "roots as they are": "Solve the steady balance for $\\Omega$ =>" + MINUS_FIRST,
    "roots of the other sign": r"""
Multiply the steady balance by $-1$ =>
  0 = -\lambda_1\cos\theta\,\Omega^2 + \lambda_3\omega_3\Omega - MgR
Solve it for $\Omega$ =>"""
    + MINUS_FIRST,
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_does_not_follow_is_refused(name: str) -> None:
    page, reason = REFUSED[name]
    assert reason in last(page)


def test_what_is_not_known_to_be_small_is_a_condition() -> None:
    page = read(FOLLOWS["of a rate of which nothing is known"])
    relations = [each.relation for each in page.judged("page:2").known.conditions]
    assert relations == ["large", "≪"]


@pytest.mark.parametrize("name", FOLLOWS)
def test_what_follows_is_not_refused(name: str) -> None:
    assert last(FOLLOWS[name]) == ""


def test_what_rests_on_a_moment_holds_at_it() -> None:
    lecture = read(r"Square the slip => \mathbf v_{tip}^2 = v^2")
    assert lecture.judged("page:1").known.scope is Scope.SET


def test_where_a_vector_starts_is_recorded() -> None:
    lecture = read(
        r"""
Integrate the tip at rest from $\mathbf r_{tip} = R\hat{\mathbf z}$ =>
  \mathbf r_{tip} = R\hat{\mathbf z}
"""
    )
    judged = lecture.judged("page:1")
    assert judged.follows, judged.problem
    [condition] = judged.known.conditions
    assert condition.relation == "start"
    assert {x.name for x in condition.expression.free_symbols} == {"r_tip", "R", "zhat"}


def test_two_starts_of_a_vector_are_two_motions() -> None:
    starts = r"""
Integrate the tip at rest from $\mathbf r_{tip} = R\hat{\mathbf z}$ =>
  \mathbf r_{tip} = R\hat{\mathbf z}
Integrate the tip at rest from $\mathbf r_{tip} = R\hat{\mathbf x}$ =>
  \mathbf r_{tip} = R\hat{\mathbf x}
"""
    add = r"Rewrite both => 2\mathbf r_{tip} = R\hat{\mathbf z} + R\hat{\mathbf x}"
    assert last(starts) == ""
    assert "starts in two ways" in last(starts + add)
