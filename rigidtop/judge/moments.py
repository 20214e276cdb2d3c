"""Of which moment each statement of a text speaks."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from rigidtop.judge.context import START
from rigidtop.judge.habits import bare
from rigidtop.judge.letters import CLOCK, COORDINATES
from rigidtop.judge.reading import Read
from rigidtop.judge.sides import letters_in
from rigidtop.read.cues import ends_moment
from rigidtop.read.passages import Passage
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement, Unread

_STARTS = re.compile(
    r"\b(start|count(?:ed|ing|s)? (?:the )?time from|beginning|begins? (?:at rest|from|with)"
    r"|initial|at first|released|let go|dropped|thrown|launched|fired|projected|geworfen|lancé"
    r"|anfang|zu beginn|losgelassen"
    r"|début|lâché)",
    re.I,
)


_AGAIN = re.compile(
    r"\b(?:at|in) (?:this|that) (?:place|point|moment|time|instant|angle|height)"
    r"|\bfrom (?:then|there|that moment) on\b|\bvon da an\b|\bdès lors\b"
    r"|(?:^|[.;¶] ?)(?:there|dort|là)\b",
    re.I,
)
_THAT_IS = re.compile(
    r"\b(?:i\. ?e\.|that is|that means|d\. ?h\.|das heißt|c['’]est-à-dire)[ ,:(]*\Z", re.I
)
_AFTER = re.compile(
    r"\b(?:in|after|at|within|nach|zur|bei|à|après|au bout)(?: [\w'-]+){0,3} ?\Z", re.I
)
"""Words in front of the time at which something is: "after the time t = …"."""


def instants(read: Read, moving: frozenset[Letter] = frozenset()) -> list[str]:
    """The instant of which each statement speaks; "" for all times."""
    made: list[str] = []
    seen: set[Letter] = {CLOCK}
    words = _Words()
    for passage, each in read:
        words.hear(passage, each, moving)
        if not words.now and Cue.MOMENT in passage.cues and _AGAIN.search(passage.before):
            k = len(made) - 1
            while k >= 0 and not made[k] and _is_passed(*read[k], passage.sentence, moving):
                made[k] = words.now = f"s{passage.sentence - 1}"
                k -= 1
        if isinstance(each, Unread):
            made.append(words.now)
            continue
        if words.starts_with(each):
            made = [START if words.is_of_sentence(x) else x for x in made]  # v = 0 at t = 0
        stays = _is_start(each) and _stays(passage)
        starts = _is_start(each) and not stays
        words.now = "" if stays else words.now
        words.now = START if starts and words.now else words.now
        named = _introduces(each, seen, moving, passage.display)
        general = stays or named or _is_kinematic(each, moving) or words.are_general(each)
        made.append(START if starts else "" if general else words.now)
        if named and each.sides[0] in moving:
            words.now, words.any_time = "", True
        seen |= letters_in(each)
    return _counted(made)


def _counted(made: Sequence[str]) -> list[str]:
    """The instants with those that have a place for a name counted: places move as one writes.

    >>> _counted(["", "s7", "start", "s7", "s9-310"])
    ['', 's000', 'start', 's000', 's001']
    """
    placed = dict.fromkeys(x for x in made if _PLACED.fullmatch(x))
    names = {x: f"s{count:03}" for count, x in enumerate(placed)}
    return [names.get(x, x) for x in made]


_PLACED = re.compile(r"s\d+(?:-\d+)?")


@dataclass
class _Words:
    """The instant of which the words speak `now`, and of which they spoke in the sentence before.

    `spoken` is the latest one of this sentence.
    It is given by the `place`, a letter that has a value then, or by a time; `any_time` says that
    the sentence speaks of all times, `clocked` that it has said which time is meant, and `called`
    is the instant of what is written with its time, as x(0).
    """

    now: str = ""
    before: str = ""
    spoken: str = ""
    sentence: int = -1
    resting: int = -1
    place: Node | None = None
    any_time: bool = False
    clocked: bool = False
    called: str = ""
    display: bool = False

    def hear(self, passage: Passage, each: Statement | Unread, moving: frozenset[Letter]) -> None:
        """What the words in front of a statement say."""
        cues = passage.cues
        self.resting = passage.sentence if Cue.REST in cues else self.resting
        begun = passage.display and self.resting == passage.sentence and not self.clocked
        over = passage.sentence == self.sentence and ends_moment(passage.before)
        if passage.sentence != self.sentence:
            self.sentence, self.before, self.now = passage.sentence, self.now, ""
            self.spoken = ""
            self.place, self.any_time, self.clocked, self.called = None, False, False, ""
        if isinstance(each, Statement) and _is_anywhere(each, passage):
            self.any_time, self.now = True, ""  # he has at the angle θ
        self.any_time |= isinstance(each, Statement) and _is_any(each, moving)
        if Cue.GENERAL in cues or begun or over:
            self.now = ""
        elif Cue.REST in cues and not passage.display and _is_start_value(each, moving):
            self.now = START  # let it start from rest with u = b
        elif self.called and _THAT_IS.search(passage.before):
            self.now = self.called
        elif Cue.MOMENT in cues and _AGAIN.search(passage.before):
            self.now = self.before or self.now
        elif Cue.MOMENT in cues and not self.any_time:
            said = _STARTS.search(f"{passage.before} § {passage.behind}")
            again = isinstance(each, Statement) and each.sides[0] == self.place
            another = not passage.display and (self.display or again)  # and at r = b
            here = f"s{self.sentence}" + (f"-{passage.start}" if another else "")
            same = self.now or self.spoken or here
            self.now = self.spoken = START if said else here if another else same
        self.display = passage.display
        if self.place is None and self.now and not self.display and isinstance(each, Statement):
            self.place = each.sides[0]
        if isinstance(each, Statement) and is_time(each):
            spoken = _AFTER.search(passage.before)
            self.now, self.clocked = self.now or (f"s{self.sentence}" if spoken else ""), True
        if isinstance(each, Statement):
            _, time = at_one_time(each, moving)
            self.called = self.called if time is None else instant_at(time)

    def starts_with(self, each: Statement) -> bool:
        """Whether a statement says that the time is zero now, where the motion begins."""
        value = time_of(each)
        zero = isinstance(value, n.Number) and value.value == 0
        if zero and (self.now or not self.display):
            self.now = START
            return True
        return False

    def is_of_sentence(self, instant: str) -> bool:
        """Whether an instant is one of which the sentence has spoken."""
        return instant.startswith(f"s{self.sentence}")

    def are_general(self, each: Statement) -> bool:
        """Whether a display holds at all times: the time stands in it, or what gives the place."""
        if not self.display or is_time(each):
            return self.display and _is_motion(each)
        return _speaks_of_time(each) or _speaks_of(each, self.place) or _is_motion(each)


def _is_of_motion(each: Statement | Unread, moving: frozenset[Letter]) -> bool:
    """Whether it gives what moves, or the rate of that, a value."""
    return isinstance(each, Statement) and len(each.sides) == 2 and bare(each.sides[0]) in moving


def _is_start_value(each: Statement | Unread, moving: frozenset[Letter]) -> bool:
    """Whether it gives what moves a value, and not one in time."""
    return isinstance(each, Statement) and _is_of_motion(each, moving) and not _speaks_of_time(each)


def _is_any(each: Statement, moving: frozenset[Letter]) -> bool:
    """Whether it is the time alone, or a letter that moves: "when the angle φ has been unwound"."""
    return len(each.sides) == 1 and each.sides[0] in moving | {CLOCK}


def _is_passed(
    passage: Passage, each: Statement | Unread, sentence: int, moving: frozenset[Letter]
) -> bool:
    """Whether the sentence before another one gives what moves a value, which it then passes."""
    near = passage.sentence == sentence - 1 and not passage.display
    return near and _is_of_motion(each, moving)


_ANYWHERE = re.compile(
    r"\bat (?:the |an? )?(?:angle|height|distance|depth|time|place|position|point|radius) ?\Z", re.I
)


def _is_anywhere(each: Statement, passage: Passage) -> bool:
    """Whether it is a coordinate alone that words call a place, or a time: at the angle θ."""
    side = each.sides[0]
    named = isinstance(side, Letter) and not side.sub and side.base in COORDINATES | {CLOCK.base}
    return named and len(each.sides) == 1 and _ANYWHERE.search(passage.before) is not None


def _is_kinematic(each: Statement, moving: frozenset[Letter]) -> bool:
    """Whether it says that a speed that moves is the rate of a place: ẋ = v."""
    if each.relations != ("=",):
        return False
    left, right = each.sides
    return isinstance(left, n.TimeDerivative) and right in moving and left.of in moving


def _is_motion(each: Statement) -> bool:
    """Whether an acceleration stands in it beside the same letter, or its velocity."""
    nodes = {x for side in each.sides for x in n.walked(side)}
    moved = {x.of for x in nodes if isinstance(x, n.TimeDerivative) and x.order > 1}
    return any(isinstance(x, n.TimeDerivative) and x.order == 1 and x.of in moved for x in nodes)


def _speaks_of(each: Statement, place: Node | None) -> bool:
    """Whether the letter that says where something is stands in it, so that it holds anywhere."""
    named = isinstance(place, Letter) and not place.sub
    return named and any(_has(side, place) for side in each.sides)


def _has(node: Node, place: Node | None) -> bool:
    """Whether a letter stands in it and not only its rate: at φ = 0 the rate has a value too."""
    if isinstance(node, n.TimeDerivative):
        return False
    return node == place or any(_has(part, place) for part in n.parts(node))


def _speaks_of_time(each: Statement) -> bool:
    """Whether the time stands in it, so that it is said of all times."""
    return any(CLOCK in n.letters(side) for side in each.sides)


def _introduces(
    each: Statement, seen: Collection[Letter], moving: frozenset[Letter], display: bool
) -> bool:
    """Whether it says what a letter is of which nothing has been said: "at the height h = 2 m".

    One that moves may be said to follow another one: "the sleeve, at z = −2 l cos θ".
    """
    if each.relations != ("=",):
        return False
    letter, value = each.sides
    if isinstance(letter, n.Call):
        return display and letter.function not in moving  # N(x) = …, at any x
    if not isinstance(letter, Letter) or letter in seen:
        return False
    if value == n.Number("0"):
        return False
    follows = letter in moving and bool(n.letters(value) & moving - {letter})
    return follows or not (display or letter in moving)


def is_time(statement: Statement) -> bool:
    """Whether a statement says which moment is meant."""
    return time_of(statement) is not None


def time_of(statement: Statement) -> Node | None:
    """The time that a statement says, as t = 0 or ω t = π; None if it says none."""
    if statement.relations != ("=",):
        return None
    left, right = statement.sides
    if left == CLOCK:
        return right
    if isinstance(left, n.Product) and left.factors.count(CLOCK) == 1:
        rest = tuple(x for x in left.factors if x != CLOCK)
        plain_rest = all(isinstance(x, (Letter, n.Number)) for x in rest)
        if plain_rest and CLOCK not in n.letters(right):
            return n.Quotient(right, n.Product(rest))
    return None


def instant_at(time_of_it: Node) -> str:
    """The name of the instant at a time."""
    return START if time_of_it == n.Number("0") else f"t = {plain(time_of_it)}"


def at_one_time(statement: Statement, moving: frozenset[Letter]) -> tuple[Statement, Node | None]:
    """A statement such as x(0) = a as one of x, with the time at which it is said of it."""
    nodes = [node for side in statement.sides for node in n.walked(side)]
    calls = [node for node in nodes if isinstance(node, n.Call) and bare(node.function) in moving]
    times = {node.places for node in calls}
    inside = Counter(x for node in calls for x in n.walked(node) if x in moving)
    if len(times) != 1 or Counter(x for x in nodes if x in moving) != inside:
        return statement, None
    [places] = times
    if len(places) != 1 or not isinstance(places[0], n.Number):
        return statement, None

    def now(node: Node) -> Node:
        return node.function if isinstance(node, n.Call) and node in calls else node

    sides = tuple(n.mapped(side, now) for side in statement.sides)
    return replace(statement, sides=sides), places[0]


def _stays(passage: Passage) -> bool:
    """Whether words say of θ = θ₀ that it is so all the time, or suppose it of no start."""
    supposed = Cue.CASE in passage.cues and not _STARTS.search(passage.before)
    return supposed or bool(passage.cues & {Cue.EQUILIBRIUM, Cue.GENERAL})


def _is_start(statement: Statement) -> bool:
    """Whether a letter is given its own value with a 0 below: θ = θ₀."""
    if statement.relations != ("=",):
        return False
    left, right = statement.sides
    return isinstance(left, Letter) and not left.sub and right == replace(left, sub="0")
