"""The lines of the pages, asked of the models of the lecture: are they true, whoever follows?

A line follows by its move from what it cites, which knows no model.  Apart from that its equations
are held here against `rigidtop.theory`, by numbers: an identity at any q and q̇, what holds along
the motion with q̈ by the equations of motion, what holds where something is set with that put in.
Of the models that know its letters one has to bear it out.  It is false where one refutes it that
bears out all that it cites; where none does the motion is a special one, and it can't be asked.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise

import sympy
from sympy import Expr, Symbol

from rigidtop.derivations import models
from rigidtop.mark.links import ERRORS, Link, sides_of
from rigidtop.proof import decide
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.counterexample import entries
from rigidtop.proof.derivation import Line
from rigidtop.proof.equation import BODY, SPACE, Equation, NoMeaningError, Partial
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.model import Model
from rigidtop.proof.moves import Condition, Known, Scope
from rigidtop.theory import symbols as s
from rigidtop.theory.symbols import const

PLACES = 3
"""So many places at which all is real are enough."""

NEARLY = "it holds approximately"
STRANGE = "no model knows its letters"
NOWHERE = "no model says what it speaks of"
SPECIAL = "it holds for special bodies or motions"
NAMES = "it gives a name"


@dataclass(frozen=True)
class Asked:
    """What the models say of a line: whether it holds; None with `why` it can't be asked."""

    line: Line
    holds: bool | None
    why: str = ""


def ask(
    lecture: Lecture, ids: Collection[str] = (), models: Sequence[Model] = ()
) -> dict[str, Asked]:
    """What models say of lines, or of all, and of those that they rest on, by their ids.

    The models are those of the top if none is given.
    """
    wanted = {*ids, *(x for id in ids for x in lecture.above(id))} if ids else {*lecture.lines}
    asking = [_Asking(model, lecture) for model in models or of_the_top()]
    return {id: _asked(lecture, line, asking) for id, line in lecture.lines.items() if id in wanted}


def _asked(lecture: Lecture, line: Line, models: Sequence[_Asking]) -> Asked:
    known = lecture.judged(line.id).known
    if known.order is not None or any(e.relation == "≈" for e in line.equations):
        return Asked(line, None, NEARLY)
    if _is_named(line) and [model for model in models if model.names(line)]:
        return Asked(line, None, NAMES)
    refuting, why = [], STRANGE
    for model in models:
        found = model.holds(line.id)
        if found is True:
            return Asked(line, True)
        if found is False:
            refuting.append(model)
        elif model.knows(line):
            why = NOWHERE
    if not refuting:
        return Asked(line, None, why)
    cited = [x for x in lecture.cites(line.id) if not _is_named(lecture.lines[x])]
    if _is_given(line) or not any(all(map(model.holds, cited)) for model in refuting):
        return Asked(line, None, SPECIAL)
    return Asked(line, False)


def _is_named(line: Line) -> bool:
    return line.move is not None and line.move.verb == "call"


def _is_given(line: Line) -> bool:
    """Whether it says what an exercise is about, or names or sets something."""
    if line.move is None:
        return line.file.startswith("exercises/")
    return line.move.verb in ("call", "set")


def _letters(line: Line) -> set[Symbol]:
    found = {x for e in line.equations for side in e.sides for x in side.free_symbols}
    return found - {const, SPACE, BODY}


def of_the_top() -> list[Model]:
    """The models that mark answers, and a body with a torque, with what pages write besides."""
    made = []
    of_marks = (model for family in models.families() for model in family)
    for model in (*of_marks, models.turning()):
        more: dict[Expr, Expr] = {}
        if s.omega_vec in model.meaning and s.T in model.meaning:
            symmetric = s.Lagrangian in model.meaning
            more[s.inertia] = sympy.diag(
                s.lambda1, s.lambda1 if symmetric else s.lambda2, s.lambda3
            )
        made.append(replace(model, meaning={**model.meaning, **more}))
    return made


# --- One model -----------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class _Asking:
    """A model with the letters that pages define in its terms, and what it says of lines."""

    model: Model
    lecture: Lecture
    defined: list[tuple[str, Expr, Expr]] = field(default_factory=list)
    found: dict[str, bool | None] = field(default_factory=dict)
    slopes: dict[Expr, Expr] = field(default_factory=dict)
    """Of letters that are functions of others: their slopes, in these."""

    def names(self, line: Line) -> bool:
        """Take a definition down; whether the model has no such letter of its own."""
        letter, right = line.equations[0].sides[:2]
        if letter in self.letters:
            return False
        if right.free_symbols <= self.letters | {*self._own(line.file)}:
            with suppress(*ERRORS):  # else the letter stays unknown
                self.defined.append((line.file, letter, self._on(line).before_limits(right)))
                self._function(line, letter, right)
        return True

    def _function(self, line: Line, letter: Symbol, right: Expr) -> None:
        """Take the slopes of a letter down that is a function of others, which are held fixed."""
        letters = self.lecture.letters
        of = letters.functions.get(letter, ())
        value = Algebra(letters, self.slopes).value(right) if of else None
        if value is None or not value.free_symbols <= {*of, *letters.numbers}:
            return
        for x in of:
            self.slopes[Partial(letter, x)] = slope = value.diff(x)
            meant = self._on(line).before_limits(slope)
            self.defined.append((line.file, Partial(letter, x), meant))

    @cached_property
    def letters(self) -> set[Symbol]:
        return self.model.symbols()

    def _own(self, file: str) -> Mapping[Expr, Expr]:
        """The letters that were defined on the page, or in the lecture before."""
        return {x: v for of, x, v in self.defined if of == file or not of.startswith("exercises/")}

    def _on(self, line: Line) -> Model:
        """With what was defined, and with slopes: a letter is one of coordinates and rates."""
        own, meaning = self._own(line.file), self.model.meaning
        slopes = {node for e in line.equations for x in e.sides for node in x.atoms(Partial)}
        known: dict[Expr, Expr] = {
            Partial(f, x): meaning[f].diff(x)
            for f, x in (node.args for node in slopes)
            if f in meaning and f not in self.lecture.letters.functions and x in self.model.rates
        }
        return (
            replace(self.model, meaning={**own, **known, **meaning}) if own or known else self.model
        )

    def knows(self, line: Line) -> bool:
        """Whether it has all letters of a line."""
        return _letters(line) <= self.letters | {*self._own(line.file)}

    def holds(self, id: str) -> bool | None:
        """Whether a line holds here; None where that can't be asked."""
        if id not in self.found:
            line = self.lecture.lines[id]
            self.found[id] = None
            if self.knows(line):
                with suppress(*ERRORS):
                    known = self.lecture.judged(id).known
                    cited = [self.lecture.judged(x).known.scope for x in self.lecture.cites(id)]
                    # Of a line that does not follow it is not known where it should hold.
                    if not self.model.along or max([known.scope, *cited]) is not Scope.IDENTITY:
                        self.found[id] = _holds(line, known, self._on(line))
        return self.found[id]


def _holds(line: Line, known: Known, model: Model) -> bool | None:
    """Whether a line holds at a few places; None where nothing is real.

    Raises one of `ERRORS` where the model has no value for it.
    """
    put = _where_set(known.conditions, model)
    bounds = [
        sympy.sympify(model.value(c.expression)).xreplace(put)
        for c in known.conditions
        if c.relation in (">", "≥")
    ]
    gaps = [
        (e.relation, sympy.sympify(gap).xreplace(put))
        for e in line.equations
        for gap in _gaps(e, model)
    ]
    return decide.in_digits(gaps, PLACES, bounds)


def _gaps(equation: Equation, model: Model) -> Iterator[Expr]:
    """What an equation compares with 0."""
    for left, right in pairwise(equation.sides):
        if left == const:
            raise NoMeaningError("a constant of which nothing is known")
        yield from entries(*sides_of(Link(left, None if right == const else right), model))


def _where_set(conditions: Iterable[Condition], model: Model) -> Mapping[Symbol, Expr]:
    """What is set, as values for free letters.  Raises NoMeaningError where it gives none."""
    put: dict[Symbol, Expr] = {}
    vanishing = (model.value(c.expression) for c in conditions if c.relation == "=")
    for entry in (x for value in vanishing for x in entries(value, sympy.Integer(0))):
        gap = sympy.sympify(entry).xreplace(put)
        for x in sorted(gap.free_symbols, key=str):
            slope = gap.diff(x)
            if slope.is_number and slope != 0:
                new = {x: x - gap / slope}
                put = {old: value.xreplace(new) for old, value in put.items()} | new
                break
        else:
            if gap != 0:
                raise NoMeaningError("what is set is none of the letters that are free")
    return put
