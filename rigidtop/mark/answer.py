"""Marking a derivation: the first line that does not follow, why not, and what the slip was.

A line is right if it holds for every motion that the facts of its passage allow
(`rigidtop.mark.passages`): in any order and any form.  It is not compared with the line before it:
what is marked is truth, not how much is shown.  The goal alone, copied, passes, and it is said how
many lines the page has in between; of what does not arrive it is said what comes next.  Normal
forms prove a line, numbers refute it; where neither succeeds it is inconclusive, never right.  The
derivation has to arrive: at the goal, or at what is the goal times a factor that does not vanish.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field
from itertools import combinations, pairwise
from typing import Any

import sympy
from sympy import Expr, Ne, Pow, Symbol, cos, sin

from rigidtop.derivations import models
from rigidtop.mark.explain import (
    counterexample,
    explain,
    foreign,
    is_own,
    side_text,
    symbols_in,
)
from rigidtop.mark.links import ERRORS, Link, Verdict, is_matrix, judge, one_angle
from rigidtop.mark.marking import Mark, Marked, Marking
from rigidtop.mark.passages import Subject, letters_of, passage, top, way
from rigidtop.mark.steps import Step, steps, too_large
from rigidtop.proof import bounds, decide
from rigidtop.proof.counterexample import entries
from rigidtop.proof.equation import Equation, Rate, Underbrace
from rigidtop.proof.model import Model, Passage
from rigidtop.proof.moves import Known
from rigidtop.proof.trial import diagnose
from rigidtop.theory import symbols as s
from rigidtop.theory.trig import reduce_ratio
from rigidtop.typeset.text import text


def mark(
    source: str,
    start: str,
    goal: str,
    skip: Collection[int] = (),
    heard: Callable[[Marked], None] = lambda _: None,
    subject: Subject | None = None,
) -> Marking:
    """Mark a derivation, the text of a file, from one numbered equation to another.

    The lines `skip`, counted from 0, are not judged: they are inconclusive.  `heard` is told each
    line as soon as it is marked.  The subject is the top if none is given.  Raises RigidtopError
    where there are no facts for these two.
    """
    subject = subject or top()
    answer = _Answer(passage(start, goal, subject), subject)
    for i, step in enumerate(steps(source, letters_of(answer.passage, subject.notation))):
        heard(answer.take(step, judged=i not in skip))
    return answer.marking()


# --- The answer ----------------------------------------------------------------------------------


@dataclass
class _Answer:
    """Takes one line after the other."""

    passage: Passage
    subject: Subject = field(default_factory=top)
    marked: list[Marked] = field(default_factory=list)
    true: list[Equation] = field(default_factory=list)
    definitions: dict[Expr, Expr] = field(default_factory=lambda: {**models.SLOPES_IN_RATES})
    wrong: list[tuple[int, Equation]] = field(default_factory=list)
    stated: list[Any] = field(default_factory=list)
    lost: list[str] = field(default_factory=list)
    failed: bool = False
    explained: bool = True

    def take(self, step: Step, judged: bool = True, explained: bool = True) -> Marked:
        """Mark the next line, or leave it unjudged; `explained`: look for the slip, too."""
        self.explained = explained
        unjudged = Marked(step.number, step.source, Mark.INCONCLUSIVE, "it takes too long to judge")
        self.marked.append(self._marked(step) if judged else unjudged)
        return self.marked[-1]

    def marking(self) -> Marking:
        goal, lost = self.passage.goal, tuple(dict.fromkeys(self.lost))
        arrives, pages = self._arrives(), way(self.passage.start, self.passage.goal, self.subject)
        if not arrives:
            note = pages.missing(self.true)
        else:
            note = "" if any(map(self._is_a_step, self.true)) else pages.skipped
        return Marking(tuple(self.marked), arrives, goal, lost, way=note)

    def _is_a_step(self, equation: Equation) -> bool:
        """Whether a line says anything but the goal, or a part of it, and what is trivial."""
        goals = self._needed()
        sides = [side for side in equation.sides if side != s.const]
        for left, right in pairwise(sides):
            given = _differences(left, right, self.passage.loose)
            if not given or not self._in_terms(left, right):
                return True
            if not all(d == 0 or any(self._implies(d, goal) for goal in goals) for d in given):
                return True
            if all(d == 0 for d in given) and left != right:
                return True
        return len(sides) == 1 and sides[0] != self.passage.conserved

    def _marked(self, step: Step) -> Marked:
        equation = step.line.equation
        if equation is None:
            return Marked(step.number, step.source, Mark.UNREAD, step.line.problem)
        said = _said(equation, step.source)
        large = too_large(equation)
        if large:
            return Marked(step.number, said, Mark.UNREAD, large)
        links, defined = self._links(equation)
        undefined = sorted(
            {x for link in links for x in symbols_in(link) if is_own(x)} - set(self.definitions),
            key=str,
        )
        if undefined:
            names = ", ".join(text(x) for x in undefined)
            note = f"{names} means nothing yet: define it on a line of its own"
            return Marked(step.number, said, Mark.UNREAD, note)
        if equation.relation == "≠":
            return self._assumed(step, said, links)
        if equation.relation not in ("=", "≡"):
            note = f"statements with {equation.relation} are not judged"
            return Marked(step.number, said, Mark.INCONCLUSIVE, note)
        if not links:
            return Marked(step.number, said, Mark.DEFINITION, f"{', '.join(map(text, defined))}")
        return self._judged(step, said, links)

    # Definitions

    def _links(self, equation: Equation) -> tuple[list[Link], list[Symbol]]:
        """The equalities of a chain, without those that define a letter of the student's own."""
        links: list[Link] = []
        defined: list[Symbol] = []
        braces = [
            (label, body)
            for brace in set().union(*(_atoms(side, Underbrace) for side in equation.sides))
            for body, label in [brace.args]
        ]
        # a = const = b says of both that they are constant, and that they are equal.
        chain = [side for side in equation.sides if side != s.const]
        to_const = [(a, b) for a, b in pairwise(equation.sides) if s.const in (a, b)]
        pairs = [*pairwise(chain), *to_const, *braces]
        for left, right in pairs:
            for name, meant in ((left, right), (right, left)):
                if self._defines(equation, name, meant):
                    self.definitions[name] = self._own_replaced(meant)
                    defined.append(name)
                    break
            else:
                if right == s.const or left == s.const:
                    other = left if right == s.const else right
                    if other != s.const:
                        links.append(Link(self._own_replaced(other), None))
                else:
                    links.append(Link(self._own_replaced(left), self._own_replaced(right)))
        return links, defined

    def _defines(self, equation: Equation, name: Expr, meant: Expr) -> bool:
        if equation.relation not in ("=", "≡") or not is_own(name) or name in self.definitions:
            return False
        if meant == s.const or is_matrix(meant):
            return False
        return not any(is_own(x) and x not in self.definitions for x in meant.free_symbols)

    def _own_replaced(self, side: Expr) -> Any:
        """A side with the student's letters replaced by what they were defined as."""
        if is_matrix(side):
            return side.applyfunc(self._own_replaced)
        if side in self.definitions:
            return self.definitions[side]
        if not side.args or not side.has(*self.definitions):
            return side
        with sympy.evaluate(False):
            return side.func(*(self._own_replaced(argument) for argument in side.args))

    # Assumptions

    def _assumed(self, step: Step, said: str, links: Sequence[Link]) -> Marked:
        model = self.passage.models[-1]
        note = ""
        for link in links:
            try:
                if link.right is None or not (_is_analytic(link.left) and _is_analytic(link.right)):
                    return Marked(step.number, said, Mark.INCONCLUSIVE, _NO_ASSUMPTION)
                left, right = model.value(link.left), model.value(link.right)
                [difference] = entries(left, right)
            except ERRORS:
                return Marked(step.number, said, Mark.INCONCLUSIVE, "not compared")
            if decide.vanishes(one_angle(difference)):
                return Marked(step.number, said, *self._wrong(), "the two are equal")
            self.stated.append(Ne(difference, 0))
            if difference in (s.theta, -s.theta):
                note = "sin θ = 0 is possible all the same, at θ = π"
        return Marked(step.number, said, Mark.ASSUMPTION, note)

    def _wrong(self) -> tuple[Mark]:
        """The first wrong line is wrong; what is false behind it may come from there."""
        found = Mark.CARRIED if self.failed else Mark.WRONG
        self.failed = True
        return (found,)

    # Equalities

    def _judged(self, step: Step, said: str, links: Sequence[Link]) -> Marked:
        """Judged for the most general motion for which all links hold."""
        failed: tuple[Link, Verdict, Model] | None = None
        unsure: Verdict | None = None
        for model in self.passage.models:
            verdicts = [self._judge_if_known(link, model) for link in links]
            if all(v.holds for v in verdicts):
                assert step.line.equation is not None
                self.true.append(_replaced(step.line.equation, self._own_replaced))
                note = f"for {model.words}" if model.words else ""
                lost = self._lost(links, model)
                if lost:
                    note = f"{note}; {lost}" if note else lost
                return Marked(step.number, said, Mark.FOLLOWS, note)
            bad = next((i for i, v in enumerate(verdicts) if v.holds is False), None)
            unsure = next((v for v in verdicts if v.holds is None), None)
            failed = None if bad is None else (links[bad], verdicts[bad], model)
        if failed is not None and step.line.condition:
            note = f"it does not hold always; whether it does {step.line.condition} is not judged"
            return Marked(step.number, said, Mark.INCONCLUSIVE, note)
        if failed is None:
            assert unsure is not None
            return Marked(step.number, said, Mark.INCONCLUSIVE, unsure.why)
        link, verdict, model = failed
        [found] = self._wrong()
        where = f"{side_text(link.left)} = {side_text(link.right)}: " if len(links) > 1 else ""
        note = where + counterexample(link, verdict)
        assert step.line.equation is not None
        whole = _replaced(step.line.equation, self._own_replaced)
        if found is Mark.CARRIED:
            note, behind = self._carried(step.number, whole)
            return Marked(step.number, said, found, note, behind=behind)
        self.wrong.append((step.number, whole))
        named = explain(link, self.passage) if self.explained else ()
        if named:
            note = f"{', or '.join(slip.words for slip in named)}; {note}"
        return Marked(step.number, said, found, note, named)

    def _carried(self, number: int, equation: Equation) -> tuple[str, int]:
        """Whether what is false follows from a false line above it, in words, and that line."""
        for line, above in reversed(self.wrong):
            try:
                found = diagnose([equation], [Known("", (above,))], self.subject.lecture.letters)
            except ERRORS:
                continue
            if found is not None and found.entailed:
                self.wrong.append((number, equation))
                return f"follows from line {line}, which does not", line
        return "does not hold either, behind a wrong line", 0

    def _judge_if_known(self, link: Link, model: Model) -> Verdict:
        """Ω means nothing for a motion that is not steady."""
        unknown = foreign(link, model)
        if unknown:
            names = ", ".join(text(x) for x in sorted(unknown, key=str))
            return Verdict(None, why=f"{names} means nothing here")
        return judge(link, model)

    def _lost(self, links: Sequence[Link], model: Model) -> str:
        """What a line leaves out that the facts allow."""
        if model.lost is None or any(
            bounds.nonzero(model.lost, [condition]) for condition in self.stated
        ):
            return ""
        for branch in model.branch:
            if any(judge(link, branch).holds is False for link in links):
                said = f"{text(model.lost)} = 0 is lost"
                self.lost.append(said)
                return said
        return ""

    # Arrival

    def _arrives(self) -> bool:
        loose, needed = self.passage.loose, self._needed()
        constant = self.passage.conserved is None
        reached = [False] * len(needed)
        for equation in self.true:
            if self.passage.conserved is not None:
                constants = self._constants_in(equation, needed[0])
                constant = constant or bool(constants)
                if any(self._is_shown(x) for x in constants if x != self.passage.conserved):
                    reached = [True] * len(needed)  # p is but a name for what is constant
            for left, right in combinations(equation.sides, 2):
                if not self._in_terms(left, right):
                    continue
                for given in _differences(left, right, loose):
                    for i, goal in enumerate(needed):
                        reached[i] = reached[i] or self._implies(given, goal)
        return constant and all(reached)

    def _needed(self) -> list[Expr]:
        """What has to vanish for the goal."""
        loose = self.passage.loose
        made: list[Expr] = []
        for equation in self.passage.equations:
            sides = [side for side in equation.sides if side != s.const]
            for left, right in pairwise(sides):
                made += [d for d in entries(loose.value(left), loose.value(right)) if d != 0]
        return made

    def _in_terms(self, *sides: Any) -> bool:
        """Whether two sides speak only of what the goal speaks of."""
        if s.const in sides or any(_atoms(side, Rate) for side in sides):
            return False
        typed = set().union(*(side.free_symbols for side in sides))
        return typed <= self.passage.allowed

    def _implies(self, given: Expr, goal: Expr) -> bool:
        """Whether goal = 0 follows from given = 0, neither of them an identity."""
        conditions = [*self.passage.given, *self.stated]
        factor = reduce_ratio(sympy.expand_trig(given) / goal)
        if factor.is_number:
            return bool(factor != 0)  # 0 = 0 implies nothing
        # Its numerator: what the line divides by is not zero where the line says anything.
        return bounds.nonzero(factor, conditions)

    def _constants_in(self, equation: Equation, goal: Expr) -> list[Any]:
        """The momentum of the goal, in all forms in which a line says that it is constant."""
        candidates: list[Any] = []
        if s.const in equation.sides:
            candidates += [side for side in equation.sides if side != s.const]
        if 0 in equation.sides:
            candidates += [x for side in equation.sides for x in _under_rate(side)]
        return [what for what in candidates if self._is_momentum(what, goal)]

    def _is_momentum(self, what: Expr, goal: Expr) -> bool:
        loose, momentum = self.passage.loose, self.passage.conserved
        if what == momentum:
            return True
        if is_matrix(what) or not what.free_symbols <= self.passage.allowed | {s.L3}:
            return False
        found = loose.value(what)
        return decide.vanishes(found - momentum + goal) or decide.vanishes(found - momentum - goal)

    def _is_written_out(self, side: Expr) -> bool:
        """Whether it is the momentum in moments and rates, not another letter for it."""
        if is_matrix(side) or not side.free_symbols & {s.lambda1, s.lambda3}:
            return False
        return self.passage.conserved != s.p_psi or s.L3 not in side.free_symbols

    def _is_shown(self, what: Expr) -> bool:
        """Whether what is constant is written out, there or in another line."""
        if self._is_written_out(what):
            return True
        return any(
            what in equation.sides and any(self._is_written_out(side) for side in equation.sides)
            for equation in self.true
        )


_NO_ASSUMPTION = "an assumption is that a rational expression in sines and cosines is not zero"


def _is_analytic(side: Expr) -> bool:
    """Whether it vanishes at single motions only, or for all: no |x|, root or inverse function.

    What such an assumption excludes has no interior; nearly every motion remains.
    """
    if is_matrix(side) or _atoms(side, Underbrace):
        return False
    functions = {type(f) for f in side.atoms(sympy.Function)}
    return functions <= {sin, cos} and all(power.exp.is_Integer for power in side.atoms(Pow))


def _under_rate(side: Expr) -> list[Any]:
    """What a side is the rate of: d/dt p, ṗ."""
    if isinstance(side, Rate):
        return [side.args[0]]
    for quantity, rate in {**models.MOMENTUM_RATES, **models.OTHER_RATES}.items():
        if side == rate:
            return [quantity]
    return []


def _differences(left: Expr, right: Expr, model: Model) -> list[Expr]:
    try:
        return [one_angle(d) for d in entries(model.value(left), model.value(right))]
    except ERRORS:
        return []


def _atoms(side: Expr, kind: Any) -> set[Expr]:
    trees = list(side) if is_matrix(side) else [side]
    return set().union(*(tree.atoms(kind) for tree in trees))


def _replaced(equation: Equation, change: Any) -> Equation:
    sides = [change(side) for side in equation.sides]
    return Equation(*sides, relation=equation.relation, tag=equation.tag)


# --- Words ---------------------------------------------------------------------------------------


def _said(equation: Equation, source: str) -> str:
    """The equation as it was read."""
    try:
        return text(equation)
    except (TypeError, AttributeError, ValueError, KeyError):
        return source
