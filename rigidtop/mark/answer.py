"""An answer marked: each of its lines by what is given, and whether it arrives.

A line follows if it holds in one of the contexts of its task, with what the answer itself has set
and named, in any order and any form.  It is not compared with the line before it: what is marked is
truth, not how much is shown.  The goal alone, copied, passes, and it is said how many lines the
page has in between; of what does not arrive it is said what comes next.
"""

from __future__ import annotations

import re
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from rigidtop.errors import RigidtopError
from rigidtop.judge.context import START, Context
from rigidtop.judge.equality import ALL_VANISH
from rigidtop.judge.judge import Judge
from rigidtop.judge.letters import CLOCK
from rigidtop.judge.neighbours import STEADY, around, is_steady
from rigidtop.judge.outcome import (
    DEFINITION,
    FALSE,
    PREMISE,
    SAMPLED,
    UNDECIDED,
    UNREAD,
    Outcome,
)
from rigidtop.judge.question import Patience
from rigidtop.judge.reading import Read, read_text
from rigidtop.judge.sides import NEARLY, ZERO
from rigidtop.judge.situation import Situation
from rigidtop.judge.text import in_time
from rigidtop.mark import linear, variants
from rigidtop.mark.arrival import equalities, holds_on, is_reached, is_said, is_trivial
from rigidtop.mark.assertions import asserted
from rigidtop.mark.contexts import (
    believing,
    free_letters,
    habits_in,
    in_angles,
    in_names_of,
    with_habits,
    without_facts,
    without_trials,
)
from rigidtop.mark.marking import Mark, Marked, Marking
from rigidtop.mark.task import Branch, Task, Together
from rigidtop.mark.vectors import with_vectors
from rigidtop.read.phrases import Cue
from rigidtop.read.walk import places
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Node
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement, Unread

LONGEST = 200_000
"""An answer has no more characters."""

MOST_LINES = 300
"""More lines of an answer are not marked."""

SECONDS_A_LINE, SECONDS = 20.0, 120.0
"""How long a line and an answer are judged (s, of the processor's time)."""


def mark(
    source: str, task: Task, a_line: float = SECONDS_A_LINE, altogether: float = SECONDS
) -> Marking:
    """What becomes of the lines of an answer, the text of a file, and of the whole.

    A line that takes longer than `a_line` seconds is inconclusive, and so is all behind
    `altogether`.  Raises RigidtopError for a text that is too long.
    """
    if len(source) > LONGEST:
        raise RigidtopError(f"an answer has no more than {LONGEST} characters, not {len(source)}")
    until = time.process_time() + altogether
    source = _CODE.sub(lambda match: f" {match[1]} ", source)
    read, _ = read_text(source, until=until, plain=True)
    task = in_angles(read, in_names_of(read, task))
    read = with_vectors(read, task)
    answer = _Answer.begun(source, read, task)
    lines: list[Marked] = []
    line_of = places(source)
    for position, each, situated in asserted(source, read, task):
        at = line_of(position)[0]
        if len(lines) == MOST_LINES:
            why = f"more than {MOST_LINES} lines"
            lines.append(Marked(at, "", Mark.UNREAD, why, position=position))
            break
        if isinstance(each, Unread):
            text = " ".join(str(situated).split())
            if _IN_WORDS.fullmatch(text):
                continue
            lines.append(Marked(at, text, Mark.UNREAD, each.reason, position=position))
            continue
        assert isinstance(situated, Situation)
        after, outcome, place = answer.after(each, situated, _Limits(a_line, until))
        if situated.asked and outcome.verdict == UNDECIDED:
            continue  # "Ω = 0 is no solution" says nothing of what holds
        answer = after
        wrong = next((x.line for x in lines if x.mark is Mark.WRONG), 0)
        marked = _marked(at, each, outcome, answer, wrong, task.words[place])
        lines.append(replace(marked, position=position))
    return _marking(tuple(sorted(lines, key=lambda x: x.line)), answer, task, until)


_CODE = re.compile(r"(?<![`\\])`([^`'\n]+)`(?!`)")
"""A formula that is marked as code, as some write plain text."""

_IN_WORDS = re.compile(r"['′]|\\?sin\s*\^\{?2\}?\s*\+\s*\\?cos\s*\^\{?2\}?\s*=\s*1")
"""A prime alone, and sin² + cos² = 1 of whatever angle, are parts of the words."""


@dataclass(frozen=True)
class _Limits:
    """Seconds for a line, and the time at which all is over."""

    a_line: float
    until: float


# --- The fold ------------------------------------------------------------------------------------


def _judged(
    judge: Judge, each: Statement, at: Situation, contexts: Sequence[Context], limits: _Limits
) -> list[tuple[Outcome, Context]]:
    return [in_time(judge, each, at, x, limits.until, limits.a_line) for x in contexts]


@dataclass(frozen=True, eq=False)
class _Answer:
    """What is known behind a line of an answer.

    `contexts` are the task's with what the answer has set and named, and `names` what letters are
    called, which is asked where a line follows from nothing else; `believed` is what would hold
    if the first wrong line were right.  `sound` are the equalities that follow, `momentary` those
    of them that are said of one moment or suppose a case, `chain` the sides of the last chain, and
    `lost` what a right line leaves out; `in_body`: dots on vectors may be rates as they are seen
    from the body.  `moment` is the instant of which the last line speaks, and `aside` what is known
    in a case of which only the sentence with the number `aside_sentence` speaks, or the item of a
    list that is `aside_scope`.  `linear` is what holds to first order, where something hardly
    changes.
    """

    judge: Judge
    contexts: tuple[Context, ...]
    names: Context
    branches: tuple[Branch, ...]
    believed: tuple[Context, ...] = ()
    sound: tuple[Statement, ...] = ()
    momentary: tuple[Statement, ...] = ()
    chain: tuple[Node, ...] = ()
    lost: tuple[str, ...] = ()
    carried: bool = False
    in_body: bool = False
    moment: str = ""
    aside: Context | None = None
    aside_sentence: int = -1
    aside_scope: tuple[int, ...] = ()
    linear: Context | None = None

    @classmethod
    def begun(cls, source: str, read: Read, task: Task) -> _Answer:
        own = habits_in(read, task)
        contexts = tuple(with_habits(context, own) for context in task.contexts)
        in_body = bool(variants.BODY.search(source))
        names = with_habits(task.names, own)
        return cls(Judge(), contexts, names, task.branches, in_body=in_body)

    def after(
        self, each: Statement, at: Situation, limits: _Limits
    ) -> tuple[_Answer, Outcome, int]:
        """What is known behind the next line, what becomes of it, and in which context."""
        if at.tried:
            return self._after_example(each, at, limits)
        each, judgements = self._tried(each, at, limits)
        quick = Judge(self.judge.memory, patience=Patience(0))

        def judged(
            contexts: Sequence[Context], judge: Judge = quick
        ) -> list[tuple[Outcome, Context]]:
            return _judged(judge, each, at, contexts, limits)

        place = _best([outcome for outcome, _ in judgements], self.contexts)
        outcome = judgements[place][0]
        [(named, names)] = judged([self.names])
        names = names if outcome.verdict != FALSE else self.names
        if named.passed and not outcome.passed and _is_of_numbers(each):
            outcome, place = named, 0
        nearly = bool({*each.relations} & {*NEARLY})
        if nearly and named.verdict == FALSE and outcome.verdict == UNDECIDED:
            outcome = named  # what letters are called says already what tends to what
        if "≠" in each.relations:
            outcome = next((o for o, _ in judgements if o.verdict == FALSE), outcome)
        unclear = outcome.verdict == FALSE and not outcome.slip
        unclear |= nearly and outcome.verdict == UNDECIDED and each.sides[-1] != ZERO
        if unclear and not self.believed:
            searched = judged((*self.contexts, self.names), self.judge)
            outcome = next((o for o, _ in searched if o.slip), outcome)
        if outcome.verdict == FALSE and not outcome.slip and not self.believed:
            free = free_letters(each, self.contexts[place])
            # It may say what is meant with them.
            why = f"it does not follow from what is said of {', '.join(map(plain, free))}"
            outcome = Outcome(UNDECIDED, why) if free else outcome
        to_first_order, outcome = self._linearised(each, at, outcome, limits)
        there, aside = self._beside(each, at, outcome, limits)
        is_aside = bool(there.passed) or there.verdict in (PREMISE, DEFINITION)
        outcome = there if is_aside else outcome
        then = outcome.verdict == FALSE and self._holds_then(each, at, limits)
        if then:
            always = Cue.GENERAL in at.cues or any(CLOCK in n.letters(x) for x in each.sides)
            why = "at the moment of which the line before speaks"
            outcome = Outcome(UNDECIDED, f"it holds {why}") if always else Outcome(SAMPLED, why)
        believed, carried = self.believed, False
        if believed:
            in_error = judged(believed)
            believed = tuple(context for _, context in in_error)
            carried = outcome.verdict == FALSE and any(o.passed for o, _ in in_error)
        elif outcome.verdict == FALSE:
            believed = tuple(believing(context, each) for context in self.contexts)
        chain = (*self.chain, *each.sides[1:]) if each.continues and self.chain else each.sides
        sound, momentary = self.sound, self.momentary
        passes = outcome.passed is not False and outcome.verdict != UNDECIDED
        # What is said of the start, or of a case of its own, holds there alone.
        if passes and not (at.instant == START or is_aside or then):
            said = equalities(chain, each)
            sound = (*sound, *said)
            is_case = at.supposed and outcome.verdict == PREMISE
            momentary = (*momentary, *said) if at.instant or is_case else momentary
        contexts = tuple(around(each, at.number, x, self.judge.memory) for _, x in judgements)
        if is_steady(contexts[0]) and not is_steady(self.contexts[0]):
            outcome = replace(outcome, why=f"{outcome.why}; it is where the motion is steady")
        special = bool(outcome.passed) and not then and place == len(self.contexts) - 1
        lost = self._lost(each) if special else ()
        answer = replace(
            self,
            contexts=contexts,
            names=names,
            believed=believed,
            sound=sound,
            momentary=momentary,
            chain=chain,
            lost=tuple(dict.fromkeys((*self.lost, *lost))),
            carried=carried,
            moment=at.instant or (self.moment if then else ""),
            aside=aside,
            aside_sentence=at.sentence if aside is not None else self.aside_sentence,
            aside_scope=at.scope if aside is not None else self.aside_scope,
            linear=to_first_order,
        )
        return answer, outcome, place

    def _tried(
        self, each: Statement, at: Situation, limits: _Limits
    ) -> tuple[Statement, list[tuple[Outcome, Context]]]:
        """A line as it is written, or as it may be meant where it fails so; with its outcomes."""
        quick = Judge(self.judge.memory, patience=Patience(0))
        real = tuple(map(without_trials, self.contexts))
        if real != self.contexts and any(CLOCK in n.letters(side) for side in each.sides[1:]):
            # Of what was tried with complex numbers this may be the real part.
            again = _judged(quick, each, at, real, limits)
            if any(outcome.passed for outcome, _ in again):
                return each, again
        judgements = _judged(quick, each, at, self.contexts, limits)
        along, known = variants.aligned(each, self.contexts)
        fails = not any(outcome.passed for outcome, _ in judgements)
        if along is not each and (
            at.supposed or (fails and (at.inline or self._is_kept(each, at, limits)))
        ):
            judgements = _judged(quick, along, at.hearing(Cue.CASE), known, limits)
            if len(each.sides) > 2:  # and what it is besides
                known = tuple(context for _, context in judgements)
                judgements = _judged(quick, each, at, known, limits)
            else:
                each = along
        for other, verdict in self._otherwise(each):
            if any(outcome.verdict != verdict for outcome, _ in judgements):
                continue
            again = _judged(quick, other, at, self.contexts, limits)
            if verdict == UNDECIDED or any(outcome.passed for outcome, _ in again):
                each, judgements = other, again
        if is_steady(self.contexts[0]) and not any(outcome.passed for outcome, _ in judgements):
            # Beside a steady motion "=" is often written to first order.
            again = _judged(quick, each, at.hearing(Cue.SMALL), self.contexts, limits)
            if any(outcome.passed for outcome, _ in again):
                return each, again
        vector = variants.of_whole_vector(each, self.contexts)
        if vector is not None and any(outcome.passed for outcome, _ in judgements):
            again = _judged(quick, vector, at, self.contexts, limits)
            if any(outcome.passed for outcome, _ in again):
                return vector, again
        return each, judgements

    def _is_kept(self, each: Statement, at: Situation, limits: _Limits) -> bool:
        """Whether the left side does not change, so that an axis may be laid along it."""
        still = variants.unchanging(each)
        return all(x.passed for x, _ in _judged(self.judge, still, at, self.contexts, limits))

    def _after_example(
        self, each: Statement, at: Situation, limits: _Limits
    ) -> tuple[_Answer, Outcome, int]:
        """The same of a number that is tried: nothing that is said elsewhere rests on it."""
        aside = self.aside if at.sentence == self.aside_sentence else None
        known = aside or self.contexts[-1]
        quick, at = Judge(self.judge.memory, patience=Patience(0)), at.hearing(Cue.CASE)
        judgements = _judged(quick, each, at, (known, without_facts(known)), limits)
        fits = (x for x in judgements if x[0].passed or x[0].verdict in (PREMISE, DEFINITION))
        outcome, aside = next(fits, judgements[0])
        return replace(self, aside=aside, aside_sentence=at.sentence), outcome, 0

    def _beside(
        self, each: Statement, at: Situation, outcome: Outcome, limits: _Limits
    ) -> tuple[Outcome, Context | None]:
        """What becomes of it in a case that only its sentence is about, and what is known there.

        It is a case that laws exclude, as θ = 0, where the equations for φ and ψ divide by zero.
        """
        aside = self.aside if self._is_beside(at) else None
        supposes = at.supposed or (at.named and not at.derived)
        begins = aside is None and not each.continues and (supposes or bool(at.instant))
        fails = outcome.verdict == FALSE or (outcome.verdict == UNDECIDED and at.inline)
        if not fails or (aside is None and not begins):
            return Outcome(UNDECIDED), aside
        known = aside or without_facts(self.contexts[0])
        quick = Judge(self.judge.memory, patience=Patience(0))
        value = isinstance(each.sides[-1], n.Number) and len(n.letters(each.sides[0])) == 1
        at = at.hearing(Cue.CASE) if value or supposes else at
        [(there, known)] = _judged(quick, each, at, [known], limits)
        sets = there.verdict in (PREMISE, DEFINITION) and at.supposed
        if not (sets or (there.passed and not begins)):
            return Outcome(UNDECIDED), aside
        return there, known

    def _linearised(
        self, each: Statement, at: Situation, outcome: Outcome, limits: _Limits
    ) -> tuple[Context | None, Outcome]:
        """What holds to first order behind a line, and what becomes of it there where it fails."""
        begun = linear.linearised(each, at.small, at.number, self.contexts[0])
        if begun is not None:
            [(named, known)] = _judged(self.judge, each, at, [begun], limits)
            if named.passed and not outcome.passed:
                outcome = replace(named, why=linear.TO_FIRST_ORDER)
            return known, named if named.verdict == DEFINITION else outcome
        if self.linear is None:
            return None, outcome
        [(there, known)] = _judged(self.judge, each, at, [self.linear], limits)
        if there.passed and not outcome.passed:
            outcome = replace(there, why=linear.TO_FIRST_ORDER)
        elif there.verdict == FALSE and outcome.verdict == UNDECIDED:
            outcome = there
        return linear.remembering(each, there, at.number, known), outcome

    def _is_beside(self, at: Situation) -> bool:
        """Whether a statement stands in the sentence, or in the item of a list, of an aside."""
        item = bool(at.scope) and at.scope[-1] < 0 and at.scope == self.aside_scope
        return at.sentence == self.aside_sentence or item

    def _holds_then(self, each: Statement, at: Situation, limits: _Limits) -> bool:
        """Whether it is right at the moment of which the line before speaks, or of steady motion.

        Words speak of the latter: "θ₀ is the angle with φ̇ = Ω".
        """
        moment = self.moment
        if not moment and at.inline and is_steady(self.contexts[0]):
            moment = STEADY
        if not moment or at.instant:
            return False
        quick = Judge(self.judge.memory, patience=Patience(0))
        then = replace(at, instant=moment)
        *sides, last = each.sides
        zeros = sides if last == ZERO and {*each.relations} == {"="} else []
        parts = [replace(each, sides=(x, ZERO), relations=("=",)) for x in zeros] or [each]
        return all(
            any(o.passed for o, _ in _judged(quick, x, then, self.contexts, limits)) for x in parts
        )

    def _otherwise(self, each: Statement) -> Iterator[tuple[Statement, str]]:
        """How a line may be meant too, with the verdict on it as it is written."""
        with_vector = variants.with_vector(each, self.contexts)
        if with_vector is not None:
            yield with_vector, UNDECIDED
        if (turning := variants.in_its_frame(each)) is not None:
            yield turning, UNDECIDED
        in_body = variants.in_body(each) if self.in_body or variants.is_turned(each) else None
        if in_body is not None:
            yield in_body, FALSE
        if (vectors := variants.of_vectors(each, self.contexts)) is not None:
            yield from ((vectors, verdict) for verdict in (FALSE, UNDECIDED))

    def _lost(self, each: Statement) -> list[str]:
        """What a line that follows leaves out that the facts allow, unless that is excluded."""
        last = self.contexts[-1]
        excluding = [Statement((x, n.Number("0")), ("=",), 0) for x in last.not_zero]
        return [
            f"{branch.lost} is lost"
            for branch in self.branches
            if holds_on(each, branch.special, last) is False
            and not any(holds_on(x, branch.special, last) for x in excluding)
        ]


def _best(outcomes: Sequence[Outcome], contexts: Sequence[Context]) -> int:
    """In which context a line does best: it follows, else is set or named, else is wrong.

    What names a letter that another context knows says nothing, nor does that a line is wrong in
    general if it is open in the special case.
    """
    special = outcomes[-1].verdict == UNDECIDED and outcomes[-1].why != ALL_VANISH
    kinds = (DEFINITION, PREMISE, *((UNDECIDED, FALSE) if special else (FALSE, UNDECIDED)))
    names = {plain(x) for context in contexts for x in context.given}

    def place(k: int) -> tuple[bool, bool, int, bool]:
        outcome = outcomes[k]
        order = kinds.index(outcome.verdict) if outcome.verdict in kinds else len(kinds)
        return not outcome.passed, bool(outcome.brings & names), order, not outcome.slip

    return min(range(len(outcomes)), key=place)


def _is_of_numbers(each: Statement) -> bool:
    """Whether no vector stands in a statement but for its length."""

    def length(node: Node) -> Node:
        return n.Number("1") if isinstance(node, n.Absolute) else node

    return not any(x.bold for side in each.sides for x in n.letters(n.mapped(side, length)))


# --- Marks ---------------------------------------------------------------------------------------

_MARKS = {
    DEFINITION: Mark.DEFINITION,
    PREMISE: Mark.ASSUMPTION,
    UNREAD: Mark.UNREAD,
    UNDECIDED: Mark.INCONCLUSIVE,
}


def _marked(
    at: int, each: Statement, outcome: Outcome, answer: _Answer, wrong: int, words: str
) -> Marked:
    """A line with its mark; `wrong` is the first line that is wrong, if there is one above it."""
    text = plain(each)
    if outcome.passed:
        notes = [f"for {words}" * bool(words), outcome.why]
        return Marked(at, text, Mark.FOLLOWS, "; ".join(filter(None, notes)))
    if outcome.verdict != FALSE:
        return Marked(at, text, _MARKS[outcome.verdict], outcome.why)
    if not wrong:
        return Marked(at, text, Mark.WRONG, outcome.why, outcome.slip, outcome.right)
    if answer.carried:
        return Marked(
            at, text, Mark.CARRIED, f"follows from line {wrong}, which does not", behind=wrong
        )
    why = f"does not hold either, behind a wrong line: {outcome.why}"
    return Marked(at, text, Mark.CARRIED, why, outcome.slip, outcome.right)


def _marking(lines: tuple[Marked, ...], answer: _Answer, task: Task, until: float) -> Marking:
    """The whole: whether it arrives, and what the pages have on the way that it has not."""

    contexts = (answer.names, *answer.contexts)

    def reached(together: Together, statements: Sequence[Statement]) -> bool:
        return all(is_reached(each, statements, contexts) for each in together)

    always = tuple(x for x in answer.sound if x not in answer.momentary)
    arrives = any(reached(x, said) for said in (answer.sound, always) for x in task.goals)
    if time.process_time() > until:
        problem = "" if arrives else "the time for the answer was over"
        return Marking(lines, arrives, task.name, answer.lost, problem)
    if not arrives:
        shown = [
            k
            for k, step in enumerate(task.way)
            if step.statements and all(is_said(x, answer.sound) for x in step.statements)
        ]
        following = task.way[shown[-1] + 1 if shown else 0 :]
        way = "" if not following else f"next on the page {following[0]}"
        return Marking(lines, False, task.name, answer.lost, way=way)
    habits = answer.names.habits
    copied = all(
        is_trivial(x, habits) or any(reached((x,), goal) for goal in task.goals)
        for x in answer.sound
    )
    way = skipped(len(task.way)) if copied else ""
    return Marking(lines, True, task.name, answer.lost, way=way)


def skipped(count: int) -> str:
    """That nothing of the way was shown, in words; nothing where there is nothing between."""
    if count == 0:
        return ""
    lie = f"{count} lines of the page lie" if count > 1 else "1 line of the page lies"
    return f"it shows nothing of the way: {lie} between"
