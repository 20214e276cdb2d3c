"""Why numbers that tell two sides apart refute nothing: what the line may be meant to say."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain

import sympy
from sympy import Pow, Symbol

from rigidtop.mark.case import Held
from rigidtop.mark.indices import running
from rigidtop.mark.law import accent, base
from rigidtop.mark.reasons import IMAGINARY, Reasons
from rigidtop.proof import equation as eq
from rigidtop.proof.equation import Equation
from rigidtop.read.values import kind
from rigidtop.theory.lettered import Lettered
from rigidtop.typeset.text import text


def doubt(ledger: Reasons, found: Held) -> str:
    """What a line that numbers refute may be meant to say, in words; "" where it is wrong."""
    rests = [ledger.equations[x] for x in found.rests]
    equations = [x for x in (found.line.equation, *rests) if x is not None]
    return next(chain(_of_places(ledger, found), _of_letters(ledger, equations)), "")


def _of_places(ledger: Reasons, found: Held) -> Iterator[str]:
    """It stands in another case than what it is held against."""
    if found.line.condition:
        yield f"holds at most “{found.line.condition}”, which is not judged"
    equation = found.line.equation
    assert equation is not None
    if max(ledger.places) in ledger.twins and len(equation.sides) > 2:
        yield "one of the two signs is meant"
    if ledger.special & {*found.rests}:
        yield "what it rests on is said of a case"
    if not ledger.holds(ledger.section, found.rests):
        yield "at odds with another case"
    far = {x for x in found.rests if ledger.places[x] != ledger.section}
    law = ledger.law
    if law is not None and ledger.sure and law.section == ledger.section - 1:
        far -= law.rests  # equations of motion often stand under a heading of their own
    if far:
        yield "at odds with what stands under another heading"
    stand = set().union(*(side.free_symbols for side in equation.sides))
    made = stand.union(*(ledger.given[x].value.free_symbols for x in stand & {*ledger.given}))
    for x in ledger.sets:
        if x in made and not accent(x) and x not in ledger.moving:
            yield f"{text(x)} = {text(ledger.sets[x].value)} was said above"


def _of_letters(ledger: Reasons, equations: Sequence[Equation]) -> Iterator[str]:
    """Its letters may be no numbers, or have a value at one place alone."""
    sides = [side for equation in equations for side in equation.sides]
    if any(isinstance(x.args[0], Symbol) for side in sides for x in side.atoms(sympy.Abs)):
        yield "|…| may be a norm, or another measure"
    if ledger.is_open(IMAGINARY) and any(IMAGINARY in side.free_symbols for side in sides):
        yield "i: a number, or the imaginary unit? nothing says"
    squares = [x for x in sides if isinstance(x, Pow) and x.exp.is_even]
    if squares and any(x.is_number and x < 0 for x in sides):
        yield f"{text(squares[0])} < 0: its letter is no number"
    for node in (x for side in sides for x in side.atoms(eq.Dot)):
        one, *others = ({base(y) for y in x.free_symbols if kind(y) == "scalar"} for x in node.args)
        if any(one & other for other in others):
            yield f"{text(node)} may be a product of vectors"
    for equation in equations[1:]:
        first, *_, last = equation.sides
        if isinstance(first, Lettered) and last == 0 and not accent(first):
            yield f"{text(first)} = 0 may be said of one place"
    for index in map(running, equations):
        if index:
            yield f"the index {index} runs, and what is summed over it is not judged"
