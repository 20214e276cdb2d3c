"""How a text uses its letters: which move, which are functions, vectors, lengths, indices."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

from rigidtop.judge.brackets import conjugates
from rigidtop.judge.context import Habits
from rigidtop.judge.differentials import DELTA, is_factor
from rigidtop.judge.fields import fields_of
from rigidtop.judge.laws import ENERGIES, HAMILTONIANS, LAGRANGIANS
from rigidtop.judge.letters import CLOCK, COORDINATES, PLACES, SPEED, SPEEDS
from rigidtop.judge.names import is_component
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement, Unread


def functions_of(read: Iterable[Statement | Unread]) -> frozenset[Letter]:
    """The letters that are written with a place behind them: U(r), V(x)."""
    return frozenset(
        node.function
        for each in read
        if isinstance(each, Statement)
        for side in each.sides
        for node in n.walked(side)
        if isinstance(node, n.Call) and isinstance(node.function, Letter)
    )


def has_length(read: Iterable[Statement | Unread]) -> bool:
    """Whether a text uses d as a letter, or as one of a vector."""
    return any(
        {Letter("d"), Letter("d", bold=True)} & n.letters(side)
        for each in read
        if isinstance(each, Statement)
        for side in each.sides
    )


def _changing(nodes: Iterable[Node], moving: Collection[Letter]) -> set[Letter]:
    """Places and speeds of which a product has a rate, as v in d(mv)/dt, if nothing else moves."""
    products = [n.letters(x.of) for x in nodes if isinstance(x, n.TimeDerivative) and not x.dotted]
    return {
        x
        for letters in products
        if not letters & {*moving, CLOCK}
        for x in letters
        if x.base in COORDINATES | SPEEDS
    }


def _velocities(read: Sequence[Statement]) -> set[Letter]:
    """Letters that a product ties to a rate, as ω in R ω = ẋ, and of which an energy has a square.

    Θ̇ = Ω alone is as often a constant rate.
    """
    tied: set[Letter] = set()
    squared: set[Letter] = set()
    for each in read:
        for one, other in zip(each.sides, each.sides[1:], strict=False):
            for side, rates in ((one, other), (other, one)):
                if isinstance(side, n.Product) and any(
                    isinstance(x, n.TimeDerivative) and x.order == 1 for x in n.walked(rates)
                ):
                    tied |= {x for x in side.factors if isinstance(x, Letter)}
        if each.sides[0] in ENERGIES | {*LAGRANGIANS}:
            squared |= {
                x.base
                for side in each.sides[1:]
                for x in n.walked(side)
                if isinstance(x, n.Power) and x.exponent == n.Number("2")
                if isinstance(x.base, Letter) and x.base.base in "ωv"
            }
    return tied & squared


_PLACES = frozenset("θφψxyzrs")


def _passed(read: Sequence[Statement], moving: Collection[Letter]) -> set[Letter]:
    """The place that moves a speed: θ in v² = 2gR(1 − cos θ), if v moves and nothing else does."""
    passed = set()
    timed = _beside_time(read)
    for each in read:
        if each.relations != ("=",):
            continue
        left, right = each.sides
        speed = left.base if isinstance(left, n.Power) else left
        names = n.letters(right)
        places = {x for x in names if x.base in _PLACES and not (x.sub or x.bold)}
        is_speed = isinstance(speed, Letter) and speed.base in SPEEDS and speed in moving
        is_speed &= not isinstance(right, Letter)  # ω = s is a value
        if is_speed and not names & {*moving, CLOCK} and len(places) == 1 and not places & timed:
            passed |= places
    return passed


def _travelled(read: Sequence[Statement], moving: Collection[Letter]) -> set[Letter]:
    """The place that is given in time where a speed v moves, and no place does."""
    given = {each.sides[0] for each in read for x in each.sides[1:] if CLOCK in n.letters(x)}
    places = {x for x in map(Letter, PLACES) if x in given}
    others = any(x.base in COORDINATES and x != SPEED for x in moving)
    return places if SPEED in moving and len(places) == 1 and not others else set()


def _beside_time(read: Sequence[Statement]) -> frozenset[Letter]:
    """The letters of what is given as a function of the time, which are constant in it."""
    sides = [each.sides[1] for each in read if each.relations[:1] == ("=",)]
    return frozenset().union(*(n.letters(x) for x in sides if CLOCK in n.letters(x)))


def _driven(read: Sequence[Statement], moving: Collection[Letter]) -> set[Letter]:
    """The speed of which a momentum is a function, where that moves: v in p = m v/√(1 − v²/c²)."""
    driven = set()
    for each in read:
        names = n.letters(each.sides[-1])
        speeds = {x for x in names if x.base in SPEEDS and not x.bold}
        given = each.relations == ("=",) and each.sides[0] in moving
        momentum = isinstance(each.sides[0], Letter) and each.sides[0].base == "p"
        if given and momentum and not names & {*moving, CLOCK} and len(speeds) == 1:
            driven |= speeds
    return driven


def _conjugate(read: Sequence[Statement], moving: Collection[Letter]) -> set[Letter]:
    """The momenta, and the coordinates, of a Hamiltonian of which the other one moves."""
    names = [
        frozenset().union(*map(n.letters, each.sides[1:]))
        for each in read
        if each.sides[0] in HAMILTONIANS
    ]
    pairs = {pair for each in names for pair in conjugates(each)}
    return {x for pair in pairs for x in pair if {*pair} & {*moving}}


def _components(read: Sequence[Statement], moving: Collection[Letter]) -> set[Letter]:
    """The components x, y, z of a vector that moves, of which none is written with a rate."""
    names: set[Letter] = set()
    for each in read:
        of_vector = each.sides[0] in moving and isinstance(each.sides[0], Letter)
        for side in each.sides[1:] if of_vector else ():
            column = side.of if isinstance(side, n.TransposedMatrix) else side
            entries = column.entries if isinstance(column, n.Tuple) else ()
            letters = {x for x in entries if isinstance(x, Letter)}
            if len(letters) == len(entries) and not letters & {*moving}:
                names |= letters
    return names


def _parameters(read: Sequence[Statement], moving: Collection[Letter]) -> set[Letter]:
    """The letters that move what is said to be a function of them: u in s = 4a sin(u/2).

    Those that stand beside the time do not: β in y = v t sin β.
    """
    given = [(x.sides[0], x.sides[1]) for x in read if x.relations[:1] == ("=",)]
    parameters = set()
    driven = {*moving, CLOCK} | {name for name, value in given if n.letters(value) & {*moving}}
    driven |= _beside_time(read) | {name for name, value in given if CLOCK in n.letters(value)}
    for name, value in given:
        letters = n.letters(value)
        if name in moving and not letters & driven and not _is_multiple(value):
            places = [x for x in letters if x.base in COORDINATES and not x.sub]
            parameters |= {*places} if len(places) == 1 else set()
    return parameters


def _is_multiple(value: Node) -> bool:
    """Whether it is a number of times a letter, which may be its value at one place: v = 3 u.

    It may stand before a unit vector, as in **ω** = w **e**₃.
    """
    bare = value.of if isinstance(value, n.Negative) else value
    factors = bare.factors if isinstance(bare, n.Product) else (bare,)
    names = [x for x in factors if n.letters(x) and not (isinstance(x, Letter) and x.bold)]
    return len(names) == 1 and isinstance(names[0], Letter)


_PLACE = Letter("x")


def _curves(read: Sequence[Statement], primed: Collection[Letter]) -> set[Letter]:
    """The letters with a prime that are given by a place x, as y is in y = c cosh(x/c)."""
    if _PLACE in primed:
        return set()  # a prime means other axes
    return {
        y
        for each in read
        for y in each.sides[:1]
        if isinstance(y, Letter) and y in primed and _PLACE in n.letters(each.sides[-1])
    }


def _written_in_one(
    read: Sequence[Statement], moving: Collection[Letter]
) -> Iterator[tuple[Letter, Letter]]:
    """Letters that are given by one coordinate and no rate, with that: U by θ."""
    for each in read:
        name, value = each.sides[0], each.sides[-1]
        if isinstance(name, Letter) and not any(
            isinstance(x, n.TimeDerivative) for x in n.walked(value)
        ):
            places = n.letters(value) & {*moving}
            if len(places) == 1:
                yield name, *places  # type: ignore[misc]


def habits_of(read: Sequence[Statement]) -> Habits:
    """How a text uses its letters."""
    nodes = [node for each in read for side in each.sides for node in n.walked(side)]
    calls = [x for x in nodes if isinstance(x, n.Call)]
    running = running_of(read)
    timed = {x.function for x in calls if x.places == (running,)}
    timed |= {x.of for x in nodes if isinstance(x, n.Derivative) and x.by == (running,)}
    moving = {x for x in timed if isinstance(x, Letter)} | {
        of
        for x in nodes
        if isinstance(x, n.TimeDerivative) and not _is_function(x.of)
        for of in [bare(x.of)]
        if isinstance(of, Letter)
    }
    moving |= _changing(nodes, moving)
    moving |= _velocities(read)
    moving |= {x for x in map(Letter, PLACES) if x in nodes and Letter("v", x.base) in moving}
    moving |= _travelled(read, moving)
    moving |= _driven(read, moving)
    moving |= _passed(read, moving)
    moving |= _conjugate(read, moving)
    moving |= _parameters(read, moving)
    moving |= _components(read, moving)
    functions: dict[Letter, tuple[Node, ...]] = {}
    for call in calls:
        function = call.function.of if isinstance(call.function, n.Primed) else call.function
        if not isinstance(function, Letter) or function in moving:
            continue
        if call.places != (running,) and all(isinstance(bare(x), Letter) for x in call.places):
            functions.setdefault(function, call.places)
    primed = {x.of for x in nodes if isinstance(x, n.Primed) and isinstance(x.of, Letter)}
    fields = fields_of(read, moving)
    moving -= fields.keys()
    functions |= fields
    functions |= dict.fromkeys(_curves(read, primed - {*functions} - moving), (_PLACE,))
    functions |= {
        x: (place,)
        for x, place in _written_in_one(read, moving)
        if x in primed and x not in moving and not {*functions.get(x, ())} & {*moving}
    }
    twice = any(isinstance(x, n.Primed) and x.order > 1 and x.of not in functions for x in nodes)
    dotted = any(isinstance(x, n.TimeDerivative) and x.dotted for x in nodes)
    primes_are_rates = twice and not dotted
    if primes_are_rates:
        moving |= primed - {*functions}
    indices = {x.base for node in nodes if isinstance(node, n.Total) for x in node.index}
    bold = {x for x in nodes if isinstance(x, Letter) and x.bold}
    vectors = {x for x in bold if not x.sub}
    moving |= {x for x in vectors if any(is_component(each, x) for each in moving)}
    entries = {
        (each.sides[0], x) for each in read for side in each.sides[1:] for x in n.letters(side)
    }
    lengths = {
        x
        for x in (replace(each, bold=False) for each in bold if each.sub in {"", *indices})
        if x not in moving and (replace(x, bold=True), x) not in entries and x.base not in "xyzt"
    }
    own = {
        side
        for each in read
        for side in each.sides[:1]
        if side in (Letter("e"), Letter("π")) or (each.relations and side == Letter("i"))
    }
    own |= {DELTA} if is_factor(nodes) else set()
    return Habits(
        frozenset(moving),
        functions,
        frozenset(indices),
        frozenset(own),
        primes_are_rates,
        frozenset(lengths),
        frozenset(vectors),
        running,
        frozenset(fields),
    )


def running_of(read: Sequence[Statement]) -> Letter:
    """The letter with which everything moves: φ, if dS/dφ = μS is the first that is said of S.

    It is the time where that stands anywhere, or a rate.
    """
    before: frozenset[Letter] = frozenset()
    running = set()
    for each in read:
        nodes = [node for side in each.sides for node in n.walked(side)]
        if CLOCK in nodes or any(isinstance(x, n.TimeDerivative) for x in nodes):
            return CLOCK
        slopes = [x for x in nodes if isinstance(x, n.Derivative) and not x.partial]
        running |= {x.by for x in slopes if _is_unknown(x.of, before) and nodes.count(x.of) > 1}
        before |= frozenset().union(*map(n.letters, each.sides))
    [by] = running if len(running) == 1 else [(CLOCK,)]
    return by[0] if len(by) == 1 and isinstance(by[0], Letter) else CLOCK


def _is_unknown(node: Node, before: Collection[Letter]) -> bool:
    """Whether it is a letter that occurs for the first time."""
    return isinstance(node, Letter) and node not in before


def _is_function(node: Node) -> bool:
    """Whether it is written as a function of something else than the time, as F(q)."""
    return isinstance(node, n.Call) and CLOCK not in node.places


def bare(node: Node) -> Node:
    while isinstance(node, (n.TimeDerivative, n.Bracketed)):
        node = node.of
    return node.function if isinstance(node, n.Call) else node
