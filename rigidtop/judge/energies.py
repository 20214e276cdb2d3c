"""Kinetic and potential energies, and speeds, of bodies of which it is said where they are."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from sympy import Expr

from rigidtop.judge.context import Context
from rigidtop.judge.jets import jets
from rigidtop.judge.letters import (
    is_mass,
)
from rigidtop.judge.quantity import Quantity
from rigidtop.judge.question import Question
from rigidtop.judge.sides import own_letters
from rigidtop.judge.values import UnclearError
from rigidtop.judge.vocabulary import Meant
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node

_SQUARE = n.Number("2")
_KINETIC = Letter("T")
TOTALS = tuple(map(Letter, "EHL"))
"""Letters of functions in which a kinetic energy stands."""


def kinetic(question: Question) -> Iterator[Quantity]:
    """½ m (ẋ² + ẏ²) of the bodies of which it is said where they are."""
    terms: list[Node] = []
    for mass in _masses(question):
        places = _places_of(mass, question.context)
        if not places:
            return
        squares = tuple(n.Power(n.TimeDerivative(x, 1, True), _SQUARE) for x in places)
        half = n.Quotient(n.Number("1"), _SQUARE)
        terms.append(n.Product((half, mass, n.Bracketed(n.Sum(squares)))))
    if terms:
        yield Quantity("the kinetic energy", n.Sum(tuple(terms)))


def lagrangian(question: Question) -> Iterator[Quantity]:
    """The kinetic energy less that of the weight, of bodies of which it is said where they are."""
    for moving in kinetic(question):
        for hanging in weight(question):
            node = n.Sum((moving.node, n.Negative(n.Bracketed(hanging.node))))
            yield Quantity("T − V with the places above", node)


def _masses(question: Question) -> list[Letter]:
    """The masses in the right side."""
    return sorted(filter(is_mass, own_letters(question.right)), key=str)


def _places_of(mass: Letter, context: Context) -> list[Letter]:
    """The places x, y, z of a body, which have the index of its mass."""
    names = (Letter(x, mass.sub) for x in "xyz")
    moving = context.habits.moving
    return [x for x in names if x in context.definitions or (x in moving and x in context.letters)]


def weight(question: Question) -> Iterator[Quantity]:
    """m g y, or m g z, of the bodies of which it is said where they are."""
    masses = _masses(question)
    for name in "yz":
        heights = [Letter(name, mass.sub) for mass in masses]
        if masses and all(x in question.context.definitions for x in heights):
            pairs = zip(masses, heights, strict=True)
            terms = tuple(n.Product((mass, Letter("g"), x)) for mass, x in pairs)
            yield Quantity("the potential energy of the weight", n.Sum(terms))


def effective(question: Question) -> Iterator[Quantity]:
    """What is left of an energy without the square of a rate."""
    moving = kinetic_part(question)
    energy = next((x for x in TOTALS[:2] if x in question.context.definitions), None)
    if moving is not None and energy is not None:
        yield Quantity("the effective potential", n.Sum((energy, n.Negative(Meant(moving)))))
    if moving is not None and Letter("L") in question.context.definitions:
        rest = n.Sum((Meant(moving), n.Negative(Letter("L"))))
        yield Quantity("the effective potential", rest)


def kinetic_part(question: Question) -> Expr | None:
    """What is quadratic in rates in an energy or a Lagrangian, if nothing is linear in them."""
    for letter in (_KINETIC, *TOTALS):
        if letter not in question.context.definitions:
            continue
        with suppress(UnclearError):
            energy = _with_momenta(question, letter)
            speeds = {x: 0 for x, jet in jets(energy).items() if jet.order == 1}
            kinetic = energy - energy.subs(speeds)
            if speeds and not any(kinetic.diff(x).subs(speeds) != 0 for x in speeds):
                return kinetic
    return None


def _with_momenta(question: Question, letter: Letter) -> Expr:
    """An energy in the momenta in which it is written, as numbers of their own."""
    meaning, definition = question.meaning(), question.context.definitions[letter]
    node = (definition.node, *definition.also)[-1]
    momenta = frozenset(x for x in n.letters(node) if meaning.is_momentum(x))
    return meaning.with_(held=momenta).scalar(node)
