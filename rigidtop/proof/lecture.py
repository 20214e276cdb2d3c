"""The lecture as its own source: pages of text with their derivations, and what rests on what.

A page is read from Markdown (`rigidtop.read.page`); here is what it is made of, whoever reads it.
Lines cite lines above them only, so that every chain ends in laws and definitions.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import islice
from typing import Any

from sympy import Expr, Symbol

from rigidtop.errors import RigidtopError
from rigidtop.proof import units
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.derivation import Judged, Line, judge_line, unproved
from rigidtop.proof.equation import NoMeaningError, Printed
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import Known, RefusedError, Scope
from rigidtop.proof.trial import survivors, unneeded
from rigidtop.proof.values import Value
from rigidtop.theory.symbols import const


@dataclass(frozen=True)
class Prose:
    """A paragraph; `at` is the line of its file, `pieces` its text and its mathematics, read."""

    words: str
    at: int
    pieces: tuple[Any, ...] = ()


@dataclass(frozen=True)
class Heading:
    """A heading with its level, 1 for the highest."""

    level: int
    words: str
    at: int
    pieces: tuple[Any, ...] = ()


@dataclass(frozen=True)
class Shown:
    """A display as it is written, with the line that was read of it, or the `problem` with it.

    `name` is the name of what it shows, such as a claim without a number.
    """

    latex: str
    at: int
    line: Line | None = None
    problem: str = ""
    name: str = ""


@dataclass(frozen=True)
class Illustration:
    """A figure at its place, by its name, with the words beneath it."""

    name: str
    words: str
    at: int
    pieces: tuple[Any, ...] = ()


@dataclass(frozen=True)
class Box:
    """Where a box begins, which holds what goes beyond the main thread; its words are its title.

    One `for_lecturers` is about the notes, not about the subject.
    """

    words: str
    at: int
    pieces: tuple[Any, ...] = ()
    for_lecturers: bool = False


@dataclass(frozen=True)
class BoxEnd:
    """Where a box ends."""


Block = Prose | Heading | Shown | Illustration | Box | BoxEnd


@dataclass(frozen=True)
class Fault:
    """What is wrong with a page besides its displays; `at` is the line of its file.

    What `stops` has to be mended before anything is made of the page, such as a unit that is none.
    """

    at: int
    problem: str
    stops: bool = False


@dataclass(frozen=True)
class Text:
    """A page, read to its end, with all its faults."""

    file: str
    name: str
    blocks: tuple[Block, ...]
    faults: tuple[Fault, ...] = ()

    @property
    def shown(self) -> tuple[Shown, ...]:
        return tuple(block for block in self.blocks if isinstance(block, Shown))

    @property
    def lines(self) -> tuple[Line, ...]:
        return tuple(block.line for block in self.shown if block.line is not None)

    @cached_property
    def boxed(self) -> frozenset[str]:
        """The ids of the lines that stand in boxes."""
        ids, inside = set[str](), False
        for block in self.blocks:
            inside = isinstance(block, Box) or (inside and not isinstance(block, BoxEnd))
            if inside and isinstance(block, Shown) and block.line is not None:
                ids.add(block.line.id)
        return frozenset(ids)


_NUMBER = re.compile(r"\((\d+(?:\.\d+)+[a-z]?)\)")
"""How running text cites a numbered equation."""

_SOURCE = re.compile(
    r"[Dd]efin|\bGiven\b|\b(?:[Ee]quations?|[Ss]ections?) \(?\d|\(\d+\.\d"
    r"|\b[A-Z]\w+(?:['’]s\b|,? \(?\d{4}\b)|(?<=[\w,;(] )[A-Z]\w+|(?<=\()[A-Z]\w+"
)
"""What a source names: a definition, an equation, a section, or whose it is."""

OTHERS = 12
"""So many other lines are tried in the place of a cited one."""


@dataclass(frozen=True)
class Trial:
    """What came of trying a line: what it cites for nothing, its changes, which of them stood."""

    premises: int = 0
    unneeded: tuple[str, ...] = ()
    changes: int = 0
    survived: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Lecture:
    """Pages in reading order, the laws first."""

    letters: Letters = field(default_factory=Letters)
    texts: tuple[Text, ...] = ()
    main: int | None = None
    """So many texts are the lecture's; those behind are exercises, each by itself."""
    refuted: Callable[[Lecture, Judged], str] | None = None
    """Why a line is false at which a move arrives, or nothing: a second opinion."""
    formerly: tuple[tuple[str, str], ...] = ()
    """What lines were called once, with what they are called now: other pages may cite either."""

    @cached_property
    def lines(self) -> dict[str, Line]:
        """Every line by its id, in reading order."""
        return {line.id: line for text in self.texts for line in text.lines}

    @cached_property
    def laws(self) -> frozenset[str]:
        """The ids of what stands by itself."""
        return frozenset(id for id, line in self.lines.items() if line.move is None)

    @cached_property
    def names(self) -> dict[str, tuple[str, ...]]:
        """The ids of the lines that state what a name or a number names."""
        made: dict[str, list[str]] = {}
        for text in self.texts:
            for shown in text.shown:
                if shown.line is not None:
                    tags = {e.tag for e in shown.line.equations if e.tag}
                    for name in sorted({shown.name, *tags} - {""}):
                        made.setdefault(name, []).append(shown.line.id)
        return {name: tuple(ids) for name, ids in made.items()}

    def cites(self, id: str) -> tuple[str, ...]:
        """The ids of what a line cites."""
        move = self.lines[id].move
        return () if move is None else tuple(known.id for known in move.cited)

    def before(self, id: str) -> str:
        """The id of the line just above a line on its page, or nothing."""
        for text in self.texts:
            ids = [line.id for line in text.lines]
            if id in ids:
                place = ids.index(id)
                return ids[place - 1] if place else ""
        return ""

    def way(self, name: str, deep: bool = False) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """The ids of the lines that lead to what a name names, and of what they start from.

        They start from numbered equations and from laws; a `deep` way from laws alone.
        """
        if name not in self.names:
            raise RigidtopError(f"no line of the lecture is called {name!r}")
        wanted, starts = set(self.names[name]), set()
        waiting = list(wanted)
        while waiting:
            for cited in self.cites(waiting.pop()):
                if cited in self.laws or (self._numbered(cited) and not deep):
                    starts.add(cited)
                elif cited not in wanted:
                    wanted.add(cited)
                    waiting.append(cited)
        starts -= wanted
        return self._ordered(wanted), self._ordered(starts)

    @cached_property
    def map(self) -> dict[str, tuple[str, ...]]:
        """What each law and each named result rests on directly: laws and other named results.

        Names are equations' numbers and claims' names, each at its last line, so that the order of
        reading is kept; a law goes by its id.
        """
        named: dict[str, tuple[str, ...]] = {}  # a line may have a number and a name
        for name, ids in self.names.items():
            named[ids[-1]] = (*named.get(ids[-1], ()), name)
        named = {id: (id,) for id in self.laws} | named
        of_name = {**{id: (id,) for id in self.laws}, **self.names}
        made: dict[str, tuple[str, ...]] = {}
        for name in (name for id in self.lines for name in named.get(id, ())):
            found: set[str] = set()
            waiting = [cited for each in of_name[name] for cited in self.cites(each)]
            while waiting:
                cited = waiting.pop()
                if cited in named:
                    found.update(named[cited])
                else:
                    waiting += self.cites(cited)
            made[name] = tuple(other for other in made if other in found)
        return made

    def resting(self, name: str) -> tuple[str, ...]:
        """The named results that rest on one, directly or not: what falls if it falls."""
        found = {name}
        for other, on in self.map.items():
            if found & set(on):
                found.add(other)
        return tuple(other for other in self.map if other in found - {name})

    def _numbered(self, id: str) -> bool:
        return any(equation.tag for equation in self.lines[id].equations)

    def _ordered(self, ids: Collection[str]) -> tuple[str, ...]:
        return tuple(id for id in self.lines if id in ids)

    def above(self, id: str) -> tuple[str, ...]:
        """The ids of all lines that a line rests on."""
        return self._ordered(self._closed(id) - {id})

    def leading(self, names: Iterable[str]) -> tuple[str, ...]:
        """The ids of the lines that have these names, and of all that they rest on."""
        ids = [id for name in names for id in self.names.get(name, ())]
        return self._ordered(set().union(*map(self._closed, ids)))

    def gaps(self, ids: Iterable[str] | None = None) -> tuple[Judged, ...]:
        """Of these lines, or of all, those that do not follow."""
        judged = map(self.judged, self.lines if ids is None else ids)
        return tuple(each for each in judged if not each.follows)

    def below(self, id: str) -> tuple[str, ...]:
        """The ids of all lines that rest on a line: what falls if it falls."""
        found = {id}
        for other in self.lines:
            if found & set(self.cites(other)):
                found.add(other)
        return self._ordered(found - {id})

    def judged(self, id: str) -> Judged:
        """What becomes of a line, and of all that it rests on."""
        for each in () if id in self._found else self._ordered(self._closed(id)):
            if each not in self._found:
                standing = {cited: self._found[cited].known for cited in self.cites(each)}
                line = with_standing(self.lines[each], standing)
                above = (self._found[one].known for one in self.above(each))
                self._found[each] = self._judged(line, above)
        return self._found[id]

    def _judged(self, line: Line, above: Iterable[Known]) -> Judged:
        """What becomes of a line; where the engine itself breaks, it is a gap that says so."""
        try:
            judged = judge_line(line, self.letters_at(line.id), above)
            if judged.follows and self.refuted and (why := self.refuted(self, judged)):
                return Judged(line, unproved(line), RefusedError("{}", why))
            return judged
        except Exception as error:
            broken = f"rigidtop breaks here, please report it: {type(error).__name__}: {error}"
            return Judged(line, unproved(line), RefusedError("{}", broken))

    def letters_at(self, id: str) -> Letters:
        """The letters, with the units and meanings of those that the pages define.

        What an exercise defines is its own.
        """
        file = self.lines[id].file
        if file not in self._letters:
            own = [text for text in self.texts[self.main :] if text.file == file]
            self._letters[file] = _defined(self.letters, (*self.texts[: self.main], *own), file)
        return self._letters[file]

    @cached_property
    def _letters(self) -> dict[str, Letters]:
        """What `letters_at` has been asked for, by the file."""
        return {}

    @cached_property
    def _found(self) -> dict[str, Judged]:
        """Of lines that were judged already."""
        return {}

    def _closed(self, id: str) -> set[str]:
        wanted, waiting = {id}, [id]
        while waiting:
            new = set(self.cites(waiting.pop())) - wanted
            wanted |= new
            waiting += new
        return wanted

    def unread(self) -> Iterator[tuple[str, int, str]]:
        """File, line and reason of each display that was not read."""
        for text in self.texts:
            for shown in text.shown:
                if shown.problem:
                    yield text.file, shown.at, shown.problem

    def faults(self) -> Iterator[tuple[str, int, str]]:
        """File, line and reason of what else is wrong with the pages."""
        numbers = {e.tag for line in self.lines.values() for e in line.equations if e.tag}
        for text in self.texts:
            unknown = [
                Fault(block.at, f"no line has the number ({number})")
                for block in text.blocks
                if isinstance(block, Prose | Illustration)
                for number in dict.fromkeys(_NUMBER.findall(block.words))
                if number not in numbers
            ]
            unfounded = [
                Fault(line.at, f"{line.called!r} has no source: say in front of it whose law it is")
                for line in text.lines
                if line.move is None and line.source and not _SOURCE.search(line.source)
            ]
            for fault in sorted((*text.faults, *unknown, *unfounded), key=lambda fault: fault.at):
                yield text.file, fault.at, fault.problem

    def trial(self, id: str, every: int = 1) -> Trial:
        """Drop what a line cites, change it, cite other lines, move otherwise: each has to fall.

        Of the changes every so many are tried.
        """
        judged = self.judged(id)
        move = judged.line.move
        if move is None or move.verb == "call" or not judged.follows:
            return Trial()
        # What the cited lines rest on, or what rests on them, may serve as well.
        near = {id, *self.cites(id)}
        for cited in self.cites(id):
            near |= {*self.below(cited), *self.above(cited)}
        far = islice((each for each in self.lines if each not in near), OTHERS)
        others = [self.judged(each).known for each in far]
        letters = self.letters_at(id)
        needless = tuple(known.id for known in unneeded(judged.line, letters))
        return Trial(len(move.using), needless, *survivors(judged.line, letters, others, every))


def _defined(letters: Letters, texts: Iterable[Text], file: str) -> Letters:
    """With what definitions say of their letters, their units too.

    Of one page it has the laws, and the letters that are solved for.
    """
    defined: dict[Symbol, frozenset[Symbol]] = {}
    means: dict[Symbol, Expr] = {}
    solved: dict[Symbol, set[Expr]] = {}
    relations: list[Expr] = []
    for line in (line for text in texts for line in text.lines):
        is_named = line.move is not None and line.move.verb == "call"
        is_law = line.move is None and line.file == file and line.scope is Scope.IDENTITY
        is_solved = line.move is not None and line.move.verb == "solve" and line.file == file
        for equation in line.equations if is_named or is_law or is_solved else ():
            letter, *meant = equation.sides
            if is_named:
                letters = units.defining(letters, equation)
                free: set[Symbol] = set().union(*(side.free_symbols for side in meant))
                defined[letter] = frozenset(free)
            if len(meant) > 1 or equation.relation not in "=≡" or const in meant:
                continue
            with suppress(NoMeaningError):
                left, right = map(Algebra(letters).value, equation.sides)
                if _is_plain(left) and _is_plain(right):
                    if is_solved:
                        solved.setdefault(letter, set()).add(right)
                    elif isinstance(letter, Symbol):
                        means[letter] = right
                    else:
                        relations.append(left - right)
    # A letter that is solved for twice is not one thing on its page.
    one = {x: values.pop() for x, values in solved.items() if len(values) == 1}
    return replace(letters, defined=defined, means=means, solved=one, relations=tuple(relations))


def _is_plain(value: Value) -> bool:
    """Whether a value is an expression of letters alone."""
    return isinstance(value, Expr) and bool(value.is_commutative) and not value.has(Printed)


def with_standing(line: Line, standing: dict[str, Known]) -> Line:
    """A line whose citations have the scope, conditions and order that they were found to have."""
    if line.move is None:
        return line

    def found(known: Known) -> Known:
        # Of several equations a letter cites its own only.
        return replace(standing.get(known.id, known), equations=known.equations)

    of, using = (tuple(map(found, cited)) for cited in (line.move.of, line.move.using))
    return replace(line, move=replace(line.move, of=of, using=using))
