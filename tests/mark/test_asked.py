"""Lines held against the models: that they follow is one thing, that they are true another."""

from __future__ import annotations

import pytest

from rigidtop.derivations.letters import LETTERS
from rigidtop.mark.asked import NAMES, SPECIAL, ask
from rigidtop.notation import NOTES
from rigidtop.read.page import read_lecture

LAWS = r"""
# Laws

The Lagrangian:

$$\mathcal L = \tfrac12\lambda_1(\dot\phi^2\sin^2\theta + \dot\theta^2)
+ \tfrac12\lambda_3(\dot\psi + \dot\phi\cos\theta)^2 - MgR\cos\theta$$

Along the motion, the spin:

$$p_\psi = \lambda_3(\dot\psi + \dot\phi\cos\theta)$$

Along the motion, the fall:

$$\lambda_1\ddot\theta = \lambda_1\dot\phi^2\sin\theta\cos\theta - p_\psi\dot\phi\sin\theta
+ MgR\sin\theta$$
"""


def asked(page: str, laws: str = LAWS) -> list[tuple[bool | None, bool, str]]:
    """Of the lines of a page: what the models say, whether they follow, why they can't be asked."""
    read = read_lecture([("laws", laws), ("page", page)], LETTERS, NOTES)
    assert not list(read.unread())
    found = ask(read)
    return [
        (found[x.id].holds, read.judged(x.id).follows, found[x.id].why)
        for text in read.texts[1:]
        for x in text.lines
    ]


@pytest.mark.parametrize(
    ("change", "why"),
    [(("+ MgR", "- MgR"), "a sign"), (("sin\\theta\\cos", "cos\\theta\\cos"), "a function")],
)
def test_a_law_that_is_false_is_seen(change: tuple[str, str], why: str) -> None:
    laws = LAWS.replace(*change)
    assert laws != LAWS, why
    read = read_lecture([("laws", laws)], LETTERS, NOTES)
    assert [each.holds for each in ask(read).values()] == [True, True, False]
    assert all(each.holds for each in ask(read_lecture([("laws", LAWS)], LETTERS, NOTES)).values())


def test_true_and_follows_are_two_things() -> None:
    divided = "\nDivide the fall by $\\lambda_1$:\n\n$$\\ddot\\theta = {}$$\n"
    above = r"MgR\sin\theta - p_\psi\dot\phi\sin\theta"
    right = rf"\dot\phi^2\sin\theta\cos\theta + \frac{{{above}}}{{\lambda_1}}"
    spin = r"\lambda_3(\dot\psi + \dot\phi\cos\theta)"
    assert asked(divided.format(right)) == [(True, True, "")]
    # With p_ψ written out, which is not cited: true, and a gap.
    assert asked(divided.format(right.replace(r"p_\psi", spin))) == [(True, False, "")]
    assert asked(divided.format(right.replace("MgR", "2MgR"))) == [(False, False, "")]


def test_an_identity_holds_off_the_motion() -> None:
    """What a law says of any q, q̇ is not borne out by the accelerations of the motion."""
    everywhere = LAWS.replace("Along the motion, the fall", "The fall")
    read = read_lecture([("laws", everywhere)], LETTERS, NOTES)
    assert [each.holds for each in ask(read).values()] == [True, True, False]


def test_what_is_set_holds_where_it_is_set() -> None:
    line = "\nSet $\\dot\\phi = 0$ in the fall:\n\n$$\\lambda_1\\ddot\\theta = {}$$\n"
    assert asked(line.format(r"MgR\sin\theta"))[0][:2] == (True, True)
    assert asked(line.format(r"2MgR\sin\theta"))[0] == (None, False, SPECIAL)


def test_what_no_model_knows_is_not_asked() -> None:
    """A letter that is defined is asked in what it means."""
    page = r"""
Call the gap:

$$\delta = 1 - \cos\theta$$

Put it into the fall:

$$\lambda_1\ddot\theta = \lambda_1\dot\phi^2\sin\theta(1 - \delta) - p_\psi\dot\phi\sin\theta
+ MgR\sin\theta$$
"""
    first, second = asked(page)
    assert first[0] is None
    assert first[2] == NAMES
    assert second[0] is True
