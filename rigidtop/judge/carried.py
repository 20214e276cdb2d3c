"""Outcomes of a text carried over to a changed one, in which what they are of stands elsewhere.

A statement need not be judged again where it is as before and the same is known in front of it,
even if it has another number and stands in another sentence or scope: numbers are only compared.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from itertools import chain, pairwise, takewhile
from typing import TypeVar

from rigidtop.judge.context import Bound, Constraint, Context, LetterDefinition, LimitingCase
from rigidtop.judge.reading import LATE
from rigidtop.judge.text import Asked, Knowledge, Reading, Row, TextStep, around, start

Item = TypeVar("Item", LetterDefinition, Constraint, Bound, LimitingCase)


class GoneError(Exception):
    """What something rests on is not in the changed text."""


@dataclass(frozen=True)
class Numbering:
    """The numbers that statements, sentences and scopes have in a changed text, by the old ones.

    Where one has become two, or two one, it is none of them.
    """

    statements: Mapping[int, int]
    sentences: Mapping[int, int]
    scopes: Mapping[int, int]
    as_before: bool = False
    """Whether all numbers of the text before are those of the changed one."""
    made: dict[int, tuple[object, object]] = field(default_factory=dict)
    """What has been numbered anew, by its identity, so that contexts go on sharing it."""

    def statement(self, number: int) -> int:
        return _of(self.statements, number)

    def sentence(self, number: int | None) -> int | None:
        return number if number is None else _of(self.sentences, number)

    def scope(self, scope: tuple[int, ...] | None) -> tuple[int, ...] | None:
        if scope is None:
            return None
        if not self.scopes.keys() >= {*scope}:
            raise GoneError
        return tuple(self.scopes[x] for x in scope)

    def rests_on(self, numbers: frozenset[int]) -> frozenset[int]:
        return frozenset(map(self.statement, numbers))

    def context(self, known: Context) -> Context:
        """What is known, with the new numbers; raises GoneError.

        Numbers of statements of which nothing is known any more are left out.
        """
        if self.as_before:
            return known
        if id(known) not in self.made:
            self.made[id(known)] = known, self._context(known)
        return self.made[id(known)][1]  # type: ignore[return-value]

    def _context(self, known: Context) -> Context:
        alive = _alive(known)
        return replace(
            known,
            definitions={x: self._item(each) for x, each in known.definitions.items()},
            constraints=self._items(known.constraints),
            bounds=self._items(known.bounds),
            open=self._items(known.open),
            accelerations=self._items(known.accelerations),
            followed=self._items(known.followed),
            limits=self._items(known.limits),
            supported=self.rests_on(known.supported & alive),
            doubted=self.rests_on(known.doubted & alive),
            compared=self.sentences.get(known.compared, -1),
        )

    def _items(self, items: Iterable[Item]) -> tuple[Item, ...]:
        return tuple(map(self._item, items))

    def _item(self, item: Item) -> Item:
        if id(item) not in self.made:
            self.made[id(item)] = item, self._numbered(item)
        return self.made[id(item)][1]  # type: ignore[return-value]

    def _numbered(self, item: Item) -> Item:
        changes: dict[str, object] = {}
        match item:
            case LetterDefinition() | Bound():
                changes = {"number": self.statement(item.number)}
            case Constraint():
                number, until = self.statement(item.number), self.sentence(item.until)
                changes = {"number": number, "until": until}
            case LimitingCase():
                changes = {"sentence": self.sentence(item.sentence)}
        if isinstance(item, LetterDefinition | Constraint):
            changes["scope"] = self.scope(item.scope)
        same = all(getattr(item, name) == value for name, value in changes.items())
        return item if same else replace(item, **changes)  # type: ignore[arg-type]


def _of(numbers: Mapping[int, int], number: int) -> int:
    """The new number; one below zero is nobody's."""
    if number < 0:
        return number
    if number not in numbers:
        raise GoneError
    return numbers[number]


def _alive(known: Context) -> frozenset[int]:
    """The statements of which something is still known: an outcome rests on no others."""
    equations = (known.constraints, known.open, known.accelerations, known.followed)
    stated = {each.number for each in chain(*equations)}
    definitions = {each.number for each in known.definitions.values()}
    return frozenset(stated | definitions | {each.number for each in known.bounds})


def numbering(pairs: Sequence[tuple[Asked, Asked]], whole: bool) -> Numbering:
    """The numbers of a changed text, where these statements of both stand for each other.

    With `whole` these are all of both.
    """
    numbers = sorted((old.number, new.number) for old, new in pairs)
    ordered = all(a[1] < b[1] for a, b in pairwise(numbers))
    passages = [(old.passage, new.passage) for old, new in pairs]
    scopes = [
        zip(old.scope, new.scope, strict=True)
        for old, new in passages
        if _shape(old.scope) == _shape(new.scope)
    ]
    as_before = all((old.sentence, old.scope) == (new.sentence, new.scope) for old, new in passages)
    return Numbering(
        dict(numbers if ordered else ()),
        _one_to_one((old.sentence, new.sentence) for old, new in passages),
        _one_to_one(chain.from_iterable(scopes)),
        whole and as_before and all(old == new for old, new in numbers),
    )


def _shape(scope: tuple[int, ...]) -> list[bool]:
    """Which of its parts are items."""
    return [part < 0 for part in scope]


def _one_to_one(pairs: Iterable[tuple[int, int]]) -> dict[int, int]:
    """Pairs without those of which either has another partner, too."""
    distinct = {*pairs}
    olds, news = (Counter(pair[k] for pair in distinct) for k in (0, 1))
    return {a: b for a, b in distinct if olds[a] == news[b] == 1}


@dataclass(frozen=True, eq=False)
class Older:
    """The steps that were made of an older text, or of its beginning, beside a newer text."""

    read: Reading
    steps: Sequence[TextStep]
    newer: Reading

    def carried(self, made: Sequence[TextStep]) -> TextStep | None:
        """The step behind those that have been made, if it would be as it was."""
        place = self._places.get(len(made))
        if place is None or _is_late(self.steps[place]):
            return None
        before = self.steps[place - 1].behind if place else start(self.read)
        known = made[-1].behind if made else start(self.newer)
        try:
            asked = self.newer.asked[len(made)]
            if not _is_known(self._known(before), known, asked):
                return None
            return self._moved(self.steps[place], asked, before, known)
        except GoneError:
            return None

    def as_it_was(self, place: int) -> TextStep | None:
        """What became of what is asked in a place, though it may not be so any more."""
        try:
            old, asked = self.steps[self._places[place]], self.newer.asked[place]
            return replace(old, asked=asked, row=_row(old.row, asked, self._numbering))
        except (KeyError, GoneError):
            return None

    @cached_property
    def _places(self) -> Mapping[int, int]:
        """Where what is asked now was asked then."""
        if (self.read.habits, self.read.names) != (self.newer.habits, self.newer.names):
            return {}
        old = [_likeness(each.asked) for each in self.steps]
        new = [_likeness(each) for each in self.newer.asked]
        head = _alike(old, new)
        tail = min(_alike(old[::-1], new[::-1]), len(old) - head, len(new) - head)
        places = {k: k for k in range(head)}
        if len(old) == len(new):
            places |= {k: k for k, (a, b) in enumerate(zip(old, new, strict=True)) if a == b}
        return places | {len(new) - k: len(old) - k for k in range(1, tail + 1)}

    @cached_property
    def _numbering(self) -> Numbering:
        places, newer = dict(self._places), self.newer.asked
        whole = bool(places) and len(self.steps) == len(newer)
        if whole:  # what has changed has its number, too
            places = {k: k for k in range(len(newer))} | places
        pairs = [(self.steps[old].asked, newer[new]) for new, old in places.items()]
        return numbering(pairs, whole)

    def _known(self, known: Knowledge) -> Knowledge:
        """What was known, with the new numbers; raises GoneError."""
        context, scope = self._numbering.context(known.context), self._numbering.scope(known.scope)
        return replace(known, context=context, scope=scope)

    def _moved(self, step: TextStep, asked: Asked, before: Knowledge, known: Knowledge) -> TextStep:
        """A step as one of what is asked now; raises GoneError."""
        passage, numbers = asked.passage, self._numbering
        there = (asked.number, passage.sentence, passage.scope)
        was = step.asked.passage
        found = numbers.statement(step.asked.number), numbers.sentence(was.sentence)
        if (*found, numbers.scope(was.scope)) != there:
            raise GoneError
        spent = before.seconds - step.behind.seconds
        if (
            min(before.seconds, known.seconds)
            > 0
            >= min(step.behind.seconds, known.seconds - spent)
        ):
            raise GoneError  # a search for slips that was given up, or would be now
        behind = replace(self._known(step.behind), seconds=known.seconds - spent)
        return TextStep(asked, _row(step.row, asked, numbers), behind)


def _row(row: Row | None, asked: Asked, numbers: Numbering) -> Row | None:
    if row is None:
        return None
    at, passage = row.situation, asked.passage
    if at is not None:
        at = replace(at, number=asked.number, scope=passage.scope, sentence=passage.sentence)
    return Row(
        asked.line,
        replace(row.statement, position=asked.statement.position),
        replace(row.outcome, rests_on=numbers.rests_on(row.outcome.rests_on)),
        passage,
        asked.number,
        at,
    )


def _is_late(step: TextStep) -> bool:
    return step.row is not None and step.row.outcome.why == LATE


def _likeness(asked: Asked) -> tuple[object, ...]:
    """What a statement is judged by, but for its numbers."""
    passage = asked.passage
    return (
        replace(asked.statement, position=0),
        *(passage.before, passage.cues, passage.display, _shape(passage.scope)),
        *(asked.moment, asked.is_case),
    )


def _alike(one: Sequence[object], other: Sequence[object]) -> int:
    """How many are the same at the beginning."""
    pairs = zip(one, other, strict=False)
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))


def _is_known(one: Knowledge, other: Knowledge, asked: Asked) -> bool:
    """Whether the same is known where something is asked, and there is patience left in both."""
    if one.scope != other.scope or (one.seconds > 0) != (other.seconds > 0):
        return False
    if one.context is other.context:
        return True
    compared = [known.context.compared == asked.passage.sentence for known in (one, other)]
    known = [_relevant(around(asked, known.context)) for known in (one, other)]
    return compared[0] == compared[1] and _same(*known)


def _relevant(known: Context) -> Context:
    """A context without numbers of what is forgotten, and of sentences, which end."""
    alive = _alive(known)
    supported, doubted = known.supported & alive, known.doubted & alive
    return replace(known, supported=supported, doubted=doubted, compared=-1)


def _same(one: object, other: object) -> bool:
    """Whether both hold the same, in the same order."""
    if one is other:
        return True
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(_same, one, other))
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return _same((*one.items(),), (*other.items(),))
    if isinstance(one, _BY_IDENTITY) and type(one) is type(other):
        names = (each.name for each in fields(one))
        return all(_same(getattr(one, name), getattr(other, name)) for name in names)
    return bool(one == other)


_BY_IDENTITY = (Context, LetterDefinition, Constraint, Bound)
"""What Python compares by its identity."""
