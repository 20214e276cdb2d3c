"""From one equation of the lecture to another: where a derivation may start, and what it may use.

Any start and goal are a passage where the pages lead from the one to the other.  The facts that a
line is judged by are those of the goal (`rigidtop.derivations.goals`); the lines that a page has
between say how much of the way an answer shows, and what comes next.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import pairwise
from typing import Any

import sympy
from sympy import Expr, MatrixBase, Symbol

from rigidtop.derivations import lecture, models
from rigidtop.derivations.goals import goals
from rigidtop.errors import RigidtopError
from rigidtop.mark.links import ERRORS, Link, judge
from rigidtop.notation import NOTES, Notation
from rigidtop.proof.counterexample import entries
from rigidtop.proof.derivation import Line
from rigidtop.proof.equation import Equation, Partial, Rate, symbols_of
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.letters import Letters
from rigidtop.proof.model import Model, Passage, unknown
from rigidtop.proof.trial import same
from rigidtop.theory import symbols as s
from rigidtop.typeset.text import text


@dataclass(frozen=True, eq=False)
class Subject:
    """What answers are judged by: a lecture, models of which each family goes from the general to
    the special, letters, and `goals` that are no matter of models alone."""

    lecture: Lecture
    families: tuple[tuple[Model, ...], ...]
    notation: Notation
    goals: Mapping[str, Passage] = field(default_factory=dict)


@cache
def top() -> Subject:
    """The lecture on the top."""
    return Subject(lecture(), models.families(), NOTES, goals())


@cache
def passage(start: str, goal: str, subject: Subject | None = None) -> Passage:
    """The passage between two numbers or names.  Raises RigidtopError where there is none."""
    subject = subject or top()
    start, goal = start.strip("()"), goal.strip("()")
    refused = f"no derivation from {start} to {goal} is marked"
    names = subject.lecture.names
    for name in (start, goal):
        if name not in names:
            raise RigidtopError(f"{refused}: no line of the lecture is called {name!r}")
    if not _leads(start, goal, subject.lecture):
        raise RigidtopError(f"{refused}: the lecture does not lead from the one to the other")
    try:
        found = subject.goals.get(goal) or _by_models(goal, subject)
        return replace(found, start=start, families=subject.lecture.letters.families)
    except _NoGoalError as why:
        raise RigidtopError(f"{refused}: {why}") from None


def letters_of(passage: Passage, notation: Notation = NOTES) -> Notation:
    """The notes' letters, but only those that mean something here."""
    known = set().union(*(model.symbols() for model in passage.models))
    glyphs = {x: glyph for x, glyph in notation.glyphs.items() if x in known}
    spellings = {g: x for g, x in notation.spellings.items() if x in known}
    for x in (*models.MOMENTUM_RATES.values(), *models.OTHER_RATES.values()):
        if x in known:
            glyphs[x] = x.quantity.glyph
    return replace(notation, glyphs=glyphs, spellings=spellings)


class _NoGoalError(Exception):
    """Why a line of the lecture is not marked as a goal."""


def _leads(start: str, goal: str, pages: Lecture) -> bool:
    """Whether the goal rests on the start, or stands behind it on the same page."""
    first, last = pages.names[start], pages.names[goal]
    if first == last:
        return False
    if any({*first} & {*pages.above(id)} for id in last):
        return True
    lines = list(pages.lines)
    same_page = pages.lines[first[0]].file == pages.lines[last[0]].file
    return (
        same_page and bool(_derived(goal, pages)) and lines.index(first[-1]) < lines.index(last[0])
    )


def between(start: str, goal: str, subject: Subject) -> tuple[Line, ...]:
    """The lines of the pages that rest on the start and that the goal rests on."""
    pages, stated = subject.lecture, passage(start, goal, subject).equations
    goals = {line.id for line in _derived(goal, pages) if {*stated} & {*line.equations}}
    above = {x for id in goals for x in pages.above(id)}
    below = {x for id in pages.names[start] for x in pages.below(id)}
    ids = (above & below) - {*pages.names[start]} - goals
    return tuple(line for id, line in pages.lines.items() if id in ids)


def _derived(goal: str, pages: Lecture) -> tuple[Line, ...]:
    """What the lecture derives under a number, or a name; a number may be that of a definition."""
    lines = [pages.lines[id] for id in pages.names[goal] if id not in pages.laws]
    numbered = [line for line in lines if any(e.tag == goal for e in line.equations)]
    return tuple(numbered or (x for x in lines if x.move is not None and x.move.verb != "call"))


# --- A goal that is judged by the models there are ------------------------------------------------


def _by_models(goal: str, subject: Subject) -> Passage:
    """The facts under which a goal holds: the most general ones, and all that are more general.

    Raises _NoGoalError.
    """
    lines = _derived(goal, subject.lecture)
    if len(lines) != 1:
        raise _NoGoalError(f"{goal} is {len(lines)} lines there, not one")
    equations = lines[0].equations
    odd = sorted({e.relation for e in equations} - {"=", "≡"})
    if odd:
        raise _NoGoalError(f"{goal} says {odd[0]}, and only equations are marked as goals")
    if any(map(_has_rates, equations)):
        raise _NoGoalError(f"{goal} is about a derivative, which every line of it could rename")
    letters = {x for e in equations for x in symbols_of(e)}
    strange: set[Symbol] = set(letters)
    for family in subject.families:
        for k, model in enumerate(family):
            strange = min(strange, letters - model.symbols(), key=len)
            if not (letters <= model.symbols() and all(_holds(e, model) for e in equations)):
                continue
            loose = _loose(equations, model)
            if loose is not None:
                told = {x for e in equations for x in _told(e, model)}
                known = {*subject.lecture.letters.units}
                for x in letters - told:
                    letters |= getattr(model.value(x), "free_symbols", set()) & known
                return Passage(goal, family[: k + 1], loose, equations, frozenset(letters))
    if strange:
        named = ", ".join(sorted(map(text, strange)))
        raise _NoGoalError(f"{goal} has letters of which no model here knows the values: {named}")
    raise _NoGoalError(f"{goal} is no equation for one letter that a model here bears out")


def _has_rates(equation: Equation) -> bool:
    return any(side == s.const or side.atoms(Rate, Partial) for side in equation.sides)


def _holds(equation: Equation, model: Model) -> bool:
    return all(judge(Link(a, b), model).holds for a, b in pairwise(equation.sides))


def _told(equation: Equation, model: Model) -> list[Any]:
    """The letters of the left side to which a model gives a value in others."""
    return [x for x in equation.sides[0].free_symbols if model.meaning.get(x, x) != x]


def _loose(equations: Sequence[Equation], model: Model) -> Model | None:
    """The model without what the goal tells; None where the goal is an identity all the same."""
    free: dict[Expr, Expr] = {}
    for x in (x for e in equations for x in _told(e, model)):
        meant = model.meaning[x]
        is_matrix = isinstance(meant, MatrixBase)
        free[x] = unknown(f"free_{x.name}", *meant.shape) if is_matrix else x
    loose = model.freed(free)
    try:
        gaps = [
            difference
            for e in equations
            for a, b in pairwise(e.sides)
            for difference in entries(loose.value(a), loose.value(b))
        ]
    except ERRORS:
        return None
    return loose if any(difference != 0 for difference in gaps) else None


# --- How much of the way is shown ----------------------------------------------------------------


@dataclass(frozen=True)
class Way:
    """The lines of the pages between start and goal."""

    start: str
    goal: str
    lines: tuple[Line, ...]
    letters: Letters

    def next(self, shown: Collection[Equation]) -> Line | None:
        """The line behind the last one that is shown; the first where none is."""
        said = [each for equation in shown for each in _of_page(equation)]
        behind = 0
        for k, line in enumerate(self.lines):
            if any(same(one, e, self.letters) for e in line.equations for one in said):
                behind = k + 1
        return self.lines[behind] if behind < len(self.lines) else None

    def missing(self, shown: Collection[Equation]) -> str:
        """What comes next on the page, in words; nothing where the pages have no more."""
        line = self.next(shown)
        if line is None:
            return ""
        equations = "; ".join(text(equation) for equation in line.equations)
        return f"next on the page ({line.file}, line {line.at}): {equations}"

    @property
    def skipped(self) -> str:
        """That nothing of it was shown, in words; nothing where there is nothing between."""
        count = len(self.lines)
        if count == 0:
            return ""
        lie = f"{count} lines of the page lie" if count > 1 else "1 line of the page lies"
        return f"it shows nothing of the way: {lie} between"


@cache
def way(start: str, goal: str, subject: Subject) -> Way:
    """The way between the ends of a passage."""
    return Way(start, goal, between(start, goal, subject), subject.lecture.letters)


def _of_page(equation: Equation) -> Iterator[Equation]:
    """An equation of an answer as the pages may have it: ∂ℒ/∂q̇ is the momentum, or not yet."""
    rates: dict[Expr, Expr] = {dotted: Rate(p) for p, dotted in models.MOMENTUM_RATES.items()}
    momenta = {p: slope for slope, p in models.SLOPES_IN_RATES.items()}
    with sympy.evaluate(False):
        named = [side.xreplace(rates) for side in equation.sides]
        both = [side.xreplace(momenta) for side in named]
    for sides in (named, both):
        yield Equation(*sides, relation=equation.relation, tag=equation.tag)
