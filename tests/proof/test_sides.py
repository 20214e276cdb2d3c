"""What is done with both sides of an equation, or of an inequality."""

from __future__ import annotations

import pytest

from .test_moves import last

LAWS = r"""
# Laws
The order => \omega_1 > \omega_2
The lower bound => \omega_2 > \Omega
The squares => \omega_1^2 = \omega_2^2
The spin => \omega_3 = \omega_2 + \Omega
The torque => \boldsymbol\omega\times\mathbf L = \mathbf N
The mean => \omega_1 \approx \omega_2
The lever => U = MgR - M_dgh_d
The balance => MR = M_dh_d
The inverse pair => \delta\tau = 1
The product with its sine => \tau\sin\tau = 1
The shares => \beta = \delta\tau + \tau
The gap => \chi = (\omega_1 - \omega_2)^2 + \frac gR
The bare gap => \chi = (\omega_1 - \omega_2)^2
The fraction => \beta = \frac{\delta}{\delta + \tau}
The root => \epsilon_0 = \tau\sqrt{\delta^2 + 1}
The wave => \mu = \sin(\delta + \tau)
The product => \omega_1\omega_2 = \omega_3^2
The other product => \Omega^2 = \omega_1\omega_2 + \omega_3^2
"""

FOLLOWS = {
    "a term of an inequality": r"Subtract $\omega_2$ from the order => \omega_1 - \omega_2 > 0",
    "a power": r"Subtract $\omega_2^2$ from the squares => \omega_1^2 - \omega_2^2 = 0",
    "a vector": r"""
Subtract $\boldsymbol\omega\times\mathbf L$ from the torque =>
  0 = \mathbf N - \boldsymbol\omega\times\mathbf L
""",
    "to the line above": "Rewrite the order => \\omega_1 > \\omega_2\n"
    r"Add $\Omega$ => \omega_1 + \Omega > \omega_2 + \Omega",
    "a letter as what it is": r"Add $\omega_3$ to the order =>"
    r" \omega_1 + \omega_3 > \omega_2 + \omega_2 + \Omega",
    "a product of numbers": r"Put the balance into the lever => U = 0",
    "a product that is 1": r"Put the inverse pair into the shares => \beta = 1 + \tau",
    "squares of an inequality": (
        r"Square the order, for $\omega_2 > 0$ => \omega_1^2 > \omega_2^2"
    ),
    "squares of what is negative": (
        r"Square the order, for $\omega_1 < 0$ => \omega_1^2 < \omega_2^2"
    ),
    "the sign of a sum of squares": r"Take the sign of the gap => \chi > 0",
    "what is small below a line": (
        r"Neglect $\delta$ in the fraction, for small $\delta$ => \beta \approx \frac\delta\tau"
    ),
    "what is small beneath a root": (
        r"Neglect $1$ in the root, for large $\delta$ => \epsilon_0 \approx \tau\sqrt{\delta^2}"
    ),
    "a letter as itself": r"Subtract $\omega_3$ from the order =>"
    r" \omega_1 - \omega_3 > \omega_2 - \omega_3",
}
REFUSED = {
    "the other sign": (
        r"Subtract $\omega_2$ from the order => \omega_2 - \omega_1 > 0",
        "the move gives <",
    ),
    "on one side": (
        r"Add $\Omega$ to the order => \omega_1 + \Omega > \omega_2",
        "does not arrive",
    ),
    "a balance the other way": (r"Put the balance into the lever => U = 2MgR", "does not arrive"),
    "another product": (r"Put the inverse pair into the shares => \beta = 2", "does not arrive"),
    "a product that may vanish": (
        r"Put the product into the other product => \Omega^2 = 2\omega_3^2",
        "gives no letter",
    ),
    "a letter in the rest of its product": (
        r"Put the product with its sine into the shares => \beta = \delta\tau + 1/\sin\tau",
        "gives no letter",
    ),
    "what a product ties": (
        r"""
Put the balance into the lever => U = 0
Differentiate it by $R$ => \frac{\partial U}{\partial R} = 0
""",
        "tied to other letters",
    ),
    "squares of any sign": (r"Square the order => \omega_1^2 > \omega_2^2", "may be negative"),
    "squares where the larger is positive": (
        r"Square the order, for $\omega_1 > 0$ => \omega_1^2 > \omega_2^2",
        "may be negative",
    ),
    "squares of what is negative, not turned": (
        r"Square the order, for $\omega_1 < 0$ => \omega_1^2 > \omega_2^2",
        "the move gives <",
    ),
    "the sign of a square": (r"Take the sign of the bare gap => \chi > 0", "sign is not known"),
    "what is large below a line": (
        r"Neglect $\delta$ in the fraction, for large $\delta$ => \beta \approx \frac\delta\tau",
        "not small",
    ),
    "what is no smaller below a line": (
        r"Neglect $\tau$ in the fraction, for small $\delta$ => \beta \approx 1",
        "not small",
    ),
    "all below a line": (
        r"Neglect $\delta + \tau$ in the fraction, for small $\delta$ => \beta \approx \delta",
        "nothing is left",
    ),
    "what is large beneath a root": (
        r"Neglect $\delta^2$ in the root, for large $\delta$ => \epsilon_0 \approx \tau",
        "not small",
    ),
    "in an angle": (
        r"Neglect $\delta$ in the wave, for small $\delta$ => \mu \approx \sin\tau",
        "does not stand there",
    ),
    "twice": (
        r"Subtract $\omega_2^2$ from the squares => \omega_1^2 - 2\omega_2^2 = 0",
        "does not arrive",
    ),
    "to what is approximate": (
        r"Subtract $\omega_2$ from the mean => \omega_1 - \omega_2 \approx 0",
        "no order is known",
    ),
}


@pytest.mark.parametrize("name", FOLLOWS)
def test_what_is_done_with_both_sides_follows(name: str) -> None:
    assert last(FOLLOWS[name], LAWS) == ""


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_done_otherwise_is_refused(name: str) -> None:
    page, reason = REFUSED[name]
    assert reason in last(page, LAWS)
