"""Laws held against models: that lines follow is one thing, that their laws are true another."""

from __future__ import annotations

import pytest

from rigidtop.derivations.letters import LETTERS
from rigidtop.mark.laws import laws_in, of_the_top
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

Of a length, the square:

$$h^2 = 2h$$
"""


def held(laws: str) -> list[bool | None]:
    read = read_lecture([("laws", laws)], LETTERS, NOTES)
    assert not list(read.unread())
    return [*laws_in(read, of_the_top()).values()]


@pytest.mark.parametrize(
    ("change", "why"),
    [
        (("", ""), ""),
        (("+ MgR", "- MgR"), "a sign"),
        (("sin\\theta\\cos", "cos\\theta\\cos"), "a function"),
        (("= \\lambda_1\\dot\\phi^2", "= 2\\lambda_1\\dot\\phi^2"), "a factor"),
    ],
)
def test_a_law_that_is_false_is_seen(change: tuple[str, str], why: str) -> None:
    laws = LAWS.replace(*change) if why else LAWS
    assert (laws != LAWS) == bool(why)
    assert held(laws)[:3] == [True, True, not why]


def test_what_no_model_knows_is_not_asked() -> None:
    assert held(LAWS)[3] is None


def test_of_some_lines_the_laws_alone_are_asked() -> None:
    read = read_lecture([("laws", LAWS)], LETTERS, NOTES)
    [first, *_] = read.lines
    assert laws_in(read, of_the_top(), [first]) == {first: True}
