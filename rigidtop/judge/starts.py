"""What a text tells in words alone: a start from rest, an energy that is conserved."""

from __future__ import annotations

from dataclasses import replace

from rigidtop.judge.context import PREMISE, SETTING, START, Constraint, Context
from rigidtop.judge.sides import letters_in
from rigidtop.tree.nodes import Letter, Node, Number, Rate
from rigidtop.tree.statement import Statement

COORDINATES = frozenset("xyzrsqhuldℓηξζθφψαβγδχρσ")
SPEEDS = frozenset("vω")
"""What these letters stand for where something has a rate: places and angles, and how fast."""
_TOTALS = (Letter("E"), Letter("ℰ"))
"""Letters of the whole energy."""
_EULER = frozenset({Letter("φ"), Letter("θ"), Letter("ψ")})


def at_rest(context: Context, number: int, scope: tuple[int, ...]) -> Context:
    """What is known where everything begins at rest; a top that is let go may turn about its axis.

    The clock starts then, if nothing else is said of it.
    """
    moving = context.habits.moving - context.definitions.keys()
    for letter in sorted(moving, key=str):
        still = _still(letter)
        if still is None or (moving >= _EULER and letter == Letter("ψ")):
            continue
        start = Constraint(still, Number("0"), number, SETTING, scope, START)
        context = context.holding(start)
    return replace(context, instants={START: Number("0"), **context.instants})


def with_energy(context: Context, number: int, scope: tuple[int, ...]) -> Context:
    """What is known where energy is conserved."""
    for letter in _TOTALS:
        if letter in context.definitions:
            kept = Constraint(Rate(letter, 1, True), Number("0"), number, SETTING, scope)
            return context.holding(kept)
    return context


def with_velocities(statement: Statement, context: Context, number: int) -> Context:
    """What is known where a place x occurs for the first time, and v_x has occurred before."""
    for letter in sorted(letters_in(statement) - context.letters, key=str):
        speed = Letter("v", letter.base)
        if letter in context.habits.moving and letter.base in "xyz" and speed in context.letters:
            law = Constraint(Rate(letter, 1, True), speed, number, PREMISE)
            context = context.holding(law)
    return context


def _still(letter: Letter) -> Node | None:
    """What vanishes at rest of a letter that moves; None if that is not seen by its name."""
    if letter.base in COORDINATES:
        return Rate(letter, 1, True)
    return letter if letter.base in SPEEDS and letter.sub not in {*"123"} else None
