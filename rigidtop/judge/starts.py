"""What a text tells in words alone: a start from rest, an energy that is conserved."""

from __future__ import annotations

from dataclasses import replace

from rigidtop.judge.context import (
    PREMISE,
    SETTING,
    START,
    Constraint,
    Context,
    LetterDefinition,
)
from rigidtop.judge.letters import CLOCK, COORDINATES, PLACES, SPEED, SPEEDS
from rigidtop.judge.sides import letters_in
from rigidtop.judge.situation import Situation
from rigidtop.tree.nodes import (
    Derivative,
    Letter,
    Negative,
    Node,
    Number,
    Power,
    Product,
    TimeDerivative,
    Tuple,
    letters,
    walked,
)
from rigidtop.tree.statement import Statement

_TOTALS = (Letter("E"), Letter("ℰ"))
"""Letters of the whole energy."""
_EULER = frozenset({Letter("φ"), Letter("θ"), Letter("ψ")})


def at_rest(context: Context, number: int, scope: tuple[int, ...], placed: bool = False) -> Context:
    """What is known where everything begins at rest; a top that is let go may turn about its axis.

    The clock starts then, if nothing else is said of it; x, y, z do so where they are `placed`.
    """
    moving = context.habits.moving - context.definitions.keys()
    for letter in sorted(moving, key=str):
        still = _still(letter)
        if still is None or (moving >= _EULER and letter == Letter("ψ")):
            continue
        start = Constraint(still, Number("0"), number, SETTING, scope, START)
        context = context.holding(start)
        if placed and letter.base in "xyz":
            start = Constraint(letter, Number("0"), number, SETTING, scope, START)
            context = context.holding(start)
    return replace(context, instants={START: Number("0"), **context.instants})


def turning(statement: Statement, context: Context, number: int, instant: str) -> Context:
    """What is known where words say that something turns back at a place: it stands still there."""
    place = statement.sides[0]
    if place not in context.habits.moving or not isinstance(place, Letter):
        return context
    none = Constraint(TimeDerivative(place, 1, True), Number("0"), number, SETTING, (), instant)
    return context.holding(none) if place.base in COORDINATES else context


def with_energy(context: Context, number: int, scope: tuple[int, ...]) -> Context:
    """What is known where energy is conserved."""
    for letter in _TOTALS:
        if letter in context.definitions:
            kept = Constraint(TimeDerivative(letter, 1, True), Number("0"), number, SETTING, scope)
            return context.holding(kept)
    return context


def with_velocities(statement: Statement, context: Context, number: int) -> Context:
    """What is known where a place x occurs for the first time, and v_x has occurred before.

    Whether it goes the way of a speed v without an index is not said.
    """
    for letter in sorted(letters_in(statement) - context.letters, key=str):
        speed = Letter("v", letter.base)
        if letter in context.habits.moving and letter.base in PLACES and speed in context.letters:
            law = Constraint(TimeDerivative(letter, 1, True), speed, number, PREMISE)
            context = context.holding(law)
    return _with_speed(statement, context, number)


def with_acceleration(context: Context, number: int) -> Context | None:
    """What is known where **a** is the acceleration of the place **r**; None if not both occur."""
    acceleration, place = Letter("a", bold=True), Letter("r", bold=True)
    if not {acceleration, place} <= context.letters:
        return None
    return context.holding(Constraint(acceleration, TimeDerivative(place, 2), number, PREMISE))


def with_coordinates(statement: Statement, at: Situation, context: Context) -> Context | None:
    """What is known where **r** is (x, y, z), and **v** its rate; None if nothing is free so.

    A coordinate that does not move anywhere in the text is zero.
    """
    place, velocity = Letter("r", bold=True), Letter("v", bold=True)
    axes = [*map(Letter, "xyz")]
    if not letters_in(statement) & context.habits.moving & {*axes}:
        return None
    entries = tuple(x if x in context.habits.moving else Number("0") for x in axes)
    if len({*axes} & context.habits.moving) < 2:
        return None
    columns = {
        place: Tuple(entries),
        velocity: Tuple(tuple(TimeDerivative(x, 1, True) for x in entries)),
    }
    free = context.letters - context.definitions.keys()
    made = context
    for vector, column in columns.items():
        if vector in free:
            made = made.defining(vector, LetterDefinition(column, at.number, at.scope))
    return made if made is not context else None


def with_force(statement: Statement, context: Context, number: int) -> Context | None:
    """What is known with Newton's law where only a potential is; None if m ẍ is no side.

    Where the text has no mass, it is that of a mass of 1.
    """
    energies = {Letter(x) for x in "TLEH"} & context.definitions.keys()
    potential = next((x for x in map(Letter, "UV") if x in context.definitions), None)
    side = statement.sides[0]
    match side:
        case Product((Letter(), TimeDerivative(Letter() as place, 2))):
            pass
        case TimeDerivative(Letter() as place, 2) if context.habits.massless:
            pass
        case _:
            return None
    if potential is None or energies or place not in letters(context.definitions[potential].node):
        return None
    force = Negative(Derivative(potential, (place,)))
    return context.holding(Constraint(side, force, number, PREMISE))


def _with_speed(statement: Statement, context: Context, number: int) -> Context:
    """What is known where a place is given in time, and only how fast it changes is known."""
    place, *others = statement.sides
    timed = any(CLOCK in letters(x) for x in others)
    if place not in context.habits.moving & {*map(Letter, PLACES)} or not timed:
        return context
    way = TimeDerivative(place, 1, True)
    always = [c for c in context.constraints if not c.instant]
    rates = {x for c in always for side in (c.left, c.right) for x in walked(side)}
    moving = {x for x in context.habits.moving if x.base in COORDINATES} - {place}
    known = any(isinstance(x, TimeDerivative) and x.of == place for x in rates) or moving
    if SPEED not in context.letters & context.habits.moving or known:
        return context
    square = Number("2")
    law = Constraint(Power(way, square), Power(SPEED, square), number, PREMISE)
    return context.holding(law)


def _still(letter: Letter) -> Node | None:
    """What vanishes at rest of a letter that moves; None if that is not seen by its name."""
    if letter.base in COORDINATES:
        return TimeDerivative(letter, 1, True)
    return letter if letter.base in SPEEDS and letter.sub not in {*"123"} else None
