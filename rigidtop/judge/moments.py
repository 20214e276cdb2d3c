"""Of which moment each statement of a text speaks."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection
from dataclasses import replace

from rigidtop.judge.context import START
from rigidtop.judge.habits import bare
from rigidtop.judge.reading import Read
from rigidtop.judge.sides import letters_in
from rigidtop.read.cues import Cue, ends_moment
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement, Unread

_STARTS = re.compile(
    r"\b(start|beginning|begins? (?:at rest|from|with)|initial|at first|released|let go|dropped"
    r"|anfang|zu beginn|losgelassen"
    r"|début|lâché)",
    re.I,
)


_AGAIN = re.compile(
    r"\b(?:at|in) (?:this|that) (?:place|point|moment|time|instant|angle|height)"
    r"|(?:^|[.;¶] ?)(?:there|dort|là)\b",
    re.I,
)
_AFTER = re.compile(
    r"\b(?:in|after|at|within|nach|zur|bei|à|après|au bout)(?: [\w'-]+){0,3} ?\Z", re.I
)
"""Words in front of the time at which something is: "after the time t = …"."""
_TIME = Letter("t")


def instants(read: Read, moving: frozenset[Letter] = frozenset()) -> list[str]:
    """The instant of which each statement speaks; "" for all times."""
    made: list[str] = []
    seen: set[Letter] = {Letter("t"), *moving}
    sentence, before, now, resting = -1, "", "", -1
    any_time = shown = clocked = False
    for passage, each in read:
        resting = passage.sentence if Cue.REST in passage.cues else resting
        begun = passage.display and resting == passage.sentence and not clocked
        over = passage.sentence == sentence and ends_moment(passage.before)
        if passage.sentence != sentence:
            sentence, before, now, any_time, clocked = passage.sentence, now, "", False, False
        any_time |= isinstance(each, Statement) and each.sides == (_TIME,)
        if Cue.GENERAL in passage.cues or begun or over:
            now = ""
        elif Cue.MOMENT in passage.cues and _AGAIN.search(passage.before):
            now = before or now
        elif Cue.MOMENT in passage.cues and not any_time:
            said = _STARTS.search(f"{passage.before} § {passage.behind}")
            another = shown and not passage.display  # at r = a, §, and at r = b, §
            here = f"s{sentence}" + (f"-{passage.start}" if another else "")
            now = START if said else here if another else now or here
        shown = passage.display
        if isinstance(each, Statement) and is_time(each):
            now = now or (f"s{sentence}" if _AFTER.search(passage.before) else "")
            value, clocked = time_of(each), True
            zero = isinstance(value, n.Number) and value.value == 0
            if zero and (now or not passage.display):
                now = START
                made = [
                    START if x.startswith(f"s{sentence}") else x for x in made
                ]  # v = 0 at t = 0
        starts = isinstance(each, Statement) and _is_start(each)
        now = START if starts and now else now
        named = not passage.display and _introduces(each, seen)
        timed = (
            passage.display
            and _speaks_of_time(each)
            and not (isinstance(each, Statement) and is_time(each))
        )
        general = timed or _is_kinematic(each, moving)
        made.append(START if starts else "" if named or general else now)
        seen |= letters_in(each) if isinstance(each, Statement) else set()
    return made


def _is_kinematic(each: Statement | Unread, moving: frozenset[Letter]) -> bool:
    """Whether it says that a speed that moves is the rate of a place: ẋ = v."""
    if not isinstance(each, Statement) or each.relations != ("=",):
        return False
    left, right = each.sides
    return isinstance(left, n.Rate) and right in moving and left.of in moving


def _speaks_of_time(each: Statement | Unread) -> bool:
    """Whether the time stands in it, so that it is said of all times."""
    return isinstance(each, Statement) and any(_TIME in n.letters(side) for side in each.sides)


def _introduces(each: Statement | Unread, seen: Collection[Letter]) -> bool:
    """Whether it says what a letter is of which nothing has been said: "at the height h = 2 m"."""
    if not isinstance(each, Statement) or each.relations != ("=",):
        return False
    return isinstance(each.sides[0], Letter) and each.sides[0] not in seen


def is_time(statement: Statement) -> bool:
    """Whether a statement says which moment is meant."""
    return time_of(statement) is not None


def time_of(statement: Statement) -> Node | None:
    """The time that a statement says, as t = 0 or ω t = π; None if it says none."""
    if statement.relations != ("=",):
        return None
    left, right = statement.sides
    if left == _TIME:
        return right
    if isinstance(left, n.Product) and left.factors.count(_TIME) == 1:
        rest = tuple(x for x in left.factors if x != _TIME)
        plain_rest = all(isinstance(x, (Letter, n.Number)) for x in rest)
        if plain_rest and _TIME not in n.letters(right):
            return n.Quotient(right, n.Product(rest))
    return None


def instant_at(time_of_it: Node) -> str:
    """The name of the instant at a time."""
    return START if time_of_it == n.Number("0") else f"t = {plain(time_of_it)}"


def at_one_time(statement: Statement, moving: frozenset[Letter]) -> tuple[Statement, Node | None]:
    """A statement such as x(0) = a as one of x, with the time at which it is said of it."""
    calls = {
        node
        for side in statement.sides
        for node in n.walked(side)
        if isinstance(node, n.Call) and bare(node.function) in moving
    }
    times = {node.places for node in calls}
    inside = Counter(x for node in calls for x in n.walked(node) if x in moving)
    everywhere = {x for side in statement.sides for x in n.letters(side)} & moving
    if len(times) != 1 or everywhere - {*inside}:
        return statement, None
    [places] = times
    if len(places) != 1 or not isinstance(places[0], n.Number):
        return statement, None

    def now(node: Node) -> Node:
        return node.function if isinstance(node, n.Call) and node in calls else node

    sides = tuple(n.mapped(side, now) for side in statement.sides)
    return replace(statement, sides=sides), places[0]


def _is_start(statement: Statement) -> bool:
    """Whether a letter is given its own value with a 0 below: θ = θ₀."""
    if statement.relations != ("=",):
        return False
    left, right = statement.sides
    return isinstance(left, Letter) and not left.sub and right == replace(left, sub="0")
