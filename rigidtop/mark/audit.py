"""Notes as they are, judged: each numbered equation of a file against the claim of that number.

A collection of derivations knows what each equation should say.  What the file says takes the
place of what the claim prints, and its residual decides: the verdict is the one that the claim
would have, had it printed this.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, pairwise
from typing import Any

import numpy as np
from sympy import Symbol

from rigidtop.derivations import models
from rigidtop.derivations.letters import LETTERS
from rigidtop.mark.audited import LATE, Audited, Placed
from rigidtop.mark.links import Link, counterexample
from rigidtop.mark.links import judge as judge_in
from rigidtop.mark.ruling import HOLDS, ORDER, Ruling, any_value, asserted, check_of, judged
from rigidtop.mark.surroundings import Near, among, scaled
from rigidtop.notation import NOTES, Notation
from rigidtop.proof.counterexample import assertions, entries
from rigidtop.proof.equation import Equation, Partial, Rate, symbols_of
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.letters import Letters
from rigidtop.proof.page import Check, Claim, Correction, Definition, Evidence, Page, Remark
from rigidtop.proof.verdict import Finding, Judgement, Verdict, judge, judge_check
from rigidtop.read.document import Numbered, lines, numbered
from rigidtop.read.equations import Line
from rigidtop.read.walk import places
from rigidtop.theory.symbols import const
from rigidtop.typeset.text import text

SECONDS = 120.0
"""A file is not judged for longer than this (of the processor's time)."""

MOST_LINES = 50
"""Under one number no more lines are judged."""


@dataclass
class Memo:
    """What has been found out, for audits of files that are much alike.

    It belongs to one collection and one notation: give another collection another memo.
    """

    claims: dict[str, _Known] = field(default_factory=dict)
    groups: dict[tuple[str, tuple[tuple[str, int], ...]], _Outcome] = field(default_factory=dict)


def audit(
    source: str,
    pages: Iterable[Page],
    notation: Notation = NOTES,
    memo: Memo | None = None,
    seconds: float = SECONDS,
    letters: Letters = LETTERS,
    lecture: Lecture | None = None,
) -> tuple[Audited, ...]:
    """Every numbered equation of a file, in order, judged by the claim of its number.

    A claim without checks of its own says what the lines of its number in the `lecture` say.  Once
    the time is up the rest is undecided, and says so.
    """
    memo = memo if memo is not None else Memo()
    claims = {claim.name: (page, claim) for page in pages for claim in page.claims}
    place, end = places(source), time.process_time() + seconds
    return tuple(
        _audited(place, group, claims, notation, letters, memo, end, lecture)
        for group in numbered(source)
    )


# --- Groups --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Known:
    """A claim with what its evidence yields; `others` judges what the notes do not print."""

    section: str
    claim: Claim
    evidence: tuple[Evidence, ...]
    letters: Letters
    others: Mapping[int, Finding]
    problem: str = ""
    own: dict[int, Finding] = field(default_factory=dict)
    rulings: dict[tuple[int | None, Equation], Ruling] = field(default_factory=dict)

    @property
    def printed(self) -> list[int]:
        """The places of what the notes print."""
        return [i for i, item in enumerate(self.evidence) if _is_printed(item)]


@dataclass(frozen=True)
class _Outcome:
    """An `Audited` without its place in a file."""

    lines: tuple[Line, ...]
    rulings: tuple[Ruling, ...]
    judgement: Judgement | None
    absent: tuple[Equation, ...]


def _audited(
    place: Callable[[int], tuple[int, int]],
    group: Numbered,
    claims: Mapping[str, tuple[Page, Claim]],
    notation: Notation,
    letters: Letters,
    memo: Memo,
    end: float,
    lecture: Lecture | None,
) -> Audited:
    first = group.formulas[0].start
    key = group.number, tuple((formula.text, formula.start - first) for formula in group.formulas)
    if key in memo.groups:
        outcome = memo.groups[key]
    elif time.process_time() > end:
        outcome = _Outcome((Line(0, None, LATE),), (Ruling(None, LATE),), None, ())
    else:
        known = _known(group.number, claims, letters, memo, lecture)
        outcome = memo.groups[key] = _outcome(_read(group, notation), known)
    placed = []
    for line, ruling in zip(outcome.lines, outcome.rulings, strict=True):
        row, column = place(first + line.position)
        placed.append(Placed(row, column, line.equation, ruling))
    return Audited(group, tuple(placed), outcome.judgement, outcome.absent)


def _read(group: Numbered, notation: Notation) -> tuple[Line, ...]:
    """The lines of a group, with places that count from where it begins."""
    first = group.formulas[0].start
    found = [replace(x, position=x.position - first) for x in lines(group, notation)]
    if len(found) > MOST_LINES:
        more = f"more than {MOST_LINES} lines under one number"
        found[MOST_LINES:] = [Line(found[MOST_LINES].position, None, more)]
    return tuple(found) or (Line(0, None, "nothing stands there"),)


def _known(
    name: str,
    claims: Mapping[str, tuple[Page, Claim]],
    letters: Letters,
    memo: Memo,
    lecture: Lecture | None,
) -> _Known | None:
    if name not in claims:
        return None
    if name not in memo.claims:
        page, claim = claims[name]
        evidence: tuple[Evidence, ...] = ()
        others: dict[int, Finding] = {}
        own: dict[int, Finding] = {}
        problem = ""
        try:
            evidence = tuple(claim.evidence())
            if not evidence and lecture is not None and name in lecture.names:
                checks = _of_lines(lecture, name)
                verdict = judge(claim, page.section, lecture, letters).verdict
                evidence, own = checks, {i: Finding(x, verdict) for i, x in enumerate(checks)}
            for i, item in enumerate(evidence):
                if isinstance(item, Check) and not _is_printed(item):
                    others[i] = judge_check(item, letters)
        except Exception as error:  # a claim that breaks lets nothing pass
            problem = f"the claim cannot be judged: {type(error).__name__}: {error}"
        memo.claims[name] = _Known(page.section, claim, evidence, letters, others, problem, own)
    return memo.claims[name]


def _of_lines(lecture: Lecture, name: str) -> tuple[Check, ...]:
    """What the lines of a number say: given, each letter and each derivative having any value."""
    lines = [lecture.lines[id] for id in lecture.names[name]]
    stated = dict.fromkeys(e for line in lines for e in line.equations if e.tag in ("", name))
    return tuple(map(_stated, stated))


def _stated(equation: Equation) -> Check:
    nodes = set().union(*(side.atoms(Symbol, Rate, Partial) for side in equation.sides))
    meaning = {node: any_value(node) for node in nodes - {const}}
    if const in equation.sides or equation.relation not in ("=", "≡"):
        return Check(equation, meaning)
    said = assertions(equation, meaning)
    return Check(equation, meaning, given=tuple(x for _, a, b in said for x in entries(a, b)))


def _is_printed(item: Evidence) -> bool:
    if isinstance(item, (Correction, Remark)):
        return False
    return isinstance(item, Definition) or (isinstance(item, Check) and item.printed)


def _outcome(found: tuple[Line, ...], known: _Known | None) -> _Outcome:
    """Each line judged in the place of what the claim prints there."""
    if known is None or known.problem:
        why = known.problem if known is not None else ""
        rulings = tuple(Ruling(None, line.problem or why) for line in found)
        judgement = None
        if known is not None:
            judgement = Judgement(
                known.claim, known.section, Verdict.UNDECIDED, (), 0.0, known.problem
            )
        return _Outcome(found, rulings, judgement, ())
    places = _places([line.equation for line in found], known)
    rulings = tuple(
        Ruling(None, line.problem)
        if line.equation is None
        else _ruling(line.equation, known, place)
        for line, place in zip(found, places, strict=True)
    )
    rulings = _weighed([line.equation for line in found], rulings, places, known)
    left_out = [i for i in known.printed if i not in places]
    unread = any(line.equation is None for line in found)
    absent = () if unread else tuple(_equation(known.evidence[i]) for i in left_out)
    judgement = _judgement(known, dict(zip(places, rulings, strict=True)), rulings)
    return _Outcome(found, rulings, judgement, absent)


def _judgement(
    known: _Known, placed: Mapping[int | None, Ruling], rulings: Sequence[Ruling]
) -> Judgement:
    """The claim with what was read in it, and the verdict that it then gets."""
    items: list[Any] = []
    verdicts = [ruling.verdict for ruling in rulings]
    for i, item in enumerate(known.evidence):
        if i in placed:
            finding = placed[i].finding
            items += [finding] if finding is not None else []
        elif _is_printed(item):
            finding = _own(known, i)
            items.append(finding)
            verdicts.append(finding.verdict)
        elif i in known.others:
            items.append(known.others[i])
            if not isinstance(item, (Correction, Remark)):
                verdicts.append(known.others[i].verdict)
        else:
            items.append(item)
    verdict = max(verdicts, key=ORDER.index)
    return Judgement(known.claim, known.section, verdict, tuple(items), 0.0)


# --- Which line is which -------------------------------------------------------------------------


def _equation(item: Evidence) -> Equation:
    if isinstance(item, Definition):
        return item.equation
    assert isinstance(item, Check)
    return item.claimed


def _places(found: Sequence[Equation | None], known: _Known) -> list[int | None]:
    """For each line the place of what it corresponds to: in order, else by what they have alike."""
    printed = known.printed
    if len(found) == len(printed):
        return list(printed)
    places: list[int | None] = [None] * len(found)
    pairs = sorted(
        (
            (-_likeness(equation, _equation(known.evidence[i])), n, i)
            for n, equation in enumerate(found)
            if equation is not None
            for i in printed
        ),
    )
    for likeness, n, i in pairs:
        if likeness < 0 and places[n] is None and i not in places:
            places[n] = i
    return places


def _likeness(one: Equation, other: Equation) -> float:
    """1 for a common left side that is not 0, and the share of the symbols that both have."""
    here, there = symbols_of(one), symbols_of(other)
    same = one.sides[0] == other.sides[0] and one.sides[0] != 0
    return float(same + len(here & there) / max(len(here | there), 1))


# --- Whether a line says as much -----------------------------------------------------------------


def _weighed(
    found: Sequence[Equation | None],
    rulings: Sequence[Ruling],
    places: Sequence[int | None],
    known: _Known,
) -> tuple[Ruling, ...]:
    """The rulings, where what holds but says less than the claim's equation is undecided."""
    held = [
        equation
        for equation, ruling in zip(found, rulings, strict=True)
        if equation is not None and ruling.verdict in (*HOLDS, Verdict.CONVENTION)
    ]
    made = []
    for equation, ruling, place in zip(found, rulings, places, strict=True):
        if equation in held and place is None:
            assert equation is not None
            if not any(_is_of(equation, base) for i in known.printed for base in _bases(known, i)):
                ruling = Ruling(None, f"the claim has no such line: {text(equation)}")
        elif equation in held and place is not None:
            assert equation is not None
            printed = _equation(known.evidence[place])
            bases = _bases(known, place, ruling.verdict)
            if not _same(equation, printed) and not (
                any(_say_as_much(equation, held, base) for base in bases)
                and any(_says_something(equation, i, known, ruling) for i in known.printed)
            ):
                why = "it says less than the equation of that number"
                ruling = Ruling(None, why, instead=printed)
        made.append(ruling)
    return tuple(made)


def _bases(known: _Known, place: int, verdict: Verdict = Verdict.PROVED) -> list[Check]:
    """What a line in a place has to say: the printed equation, or what corrects it."""
    check = check_of(known.evidence[place])
    if verdict is Verdict.CONVENTION and check.other_reading is not None:
        return [replace(check, meaning=check.other_reading)]
    if _own(known, place).verdict in HOLDS:
        return [check]
    return [item for item in known.evidence if isinstance(item, Correction)]


def _say_as_much(equation: Equation, held: Sequence[Equation], check: Check) -> bool:
    """Whether the check's equation follows from the lines, of which `equation` stands for it."""
    one = check.claimed.relation
    if equation.relation != one and not {equation.relation, one} <= {"=", "≡"}:
        return False
    near = Near(check)
    return among(near.own, np.vstack([near.conditions(line) for line in held]))


def _says_something(equation: Equation, place: int, known: _Known, ruling: Ruling) -> bool:
    """Whether a line is about anything that is in a printed equation, whichever way it goes."""
    bases = _bases(known, place, ruling.verdict)
    return any(bool(len(scaled(Near(base).conditions(equation)))) for base in bases)


def _is_of(equation: Equation, check: Check) -> bool:
    """Whether a line says something, and nothing that the check's equation does not."""
    near = Near(check)
    here = near.conditions(equation)
    return bool(len(scaled(here))) and among(here, near.own)


# --- Judging -------------------------------------------------------------------------------------


def _ruling(equation: Equation, known: _Known, place: int | None) -> Ruling:
    """What becomes of an equation in a place of the claim; once found it is remembered."""
    key = place, equation
    if key not in known.rulings:
        known.rulings[key] = _ruled(equation, known, place)
    return known.rulings[key]


def _ruled(equation: Equation, known: _Known, place: int | None) -> Ruling:
    if place is None:
        return _extra(equation, known)
    printed = _equation(known.evidence[place])
    if _same(equation, printed):
        own = _own(known, place)
        return Ruling(own, known=own.verdict is Verdict.FALSE)
    ruling = judged(equation, check_of(known.evidence[place]), known.letters)
    if ruling.finding is None and equation.relation in ("=", "≡"):
        ruling = _by_facts(equation, known, place) or ruling
    if isinstance(known.evidence[place], Definition) and ruling.verdict in HOLDS:
        assert ruling.finding is not None
        return replace(ruling, finding=replace(ruling.finding, verdict=Verdict.DEFINITION))
    if not ruling.wrong:
        return ruling
    own = _own(known, place)
    if own.verdict is Verdict.FALSE:
        return replace(ruling, known=ruling.verdict is Verdict.FALSE)
    if own.verdict is Verdict.CONVENTION:
        # What differs in the reading in which the claim holds is what is wrong with the line.
        meant = own.check.other_reading or own.check.meaning
        check = replace(own.check, meaning=meant, other_reading=None)
        ruling = judged(equation, check, known.letters)
    return replace(ruling, instead=printed)


def _by_facts(equation: Equation, known: _Known, place: int) -> Ruling | None:
    """What has symbols that the claim does not know, refuted where they are what the facts say.

    The facts are those in which the claim's own equation holds; moments, masses and lengths of
    which they do not speak have any value.
    """
    printed, check = _equation(known.evidence[place]), check_of(known.evidence[place])
    numbers = symbols_of(equation) & known.letters.numbers
    for model in chain.from_iterable(models.families()):
        if not symbols_of(printed) <= model.symbols():
            continue
        if not all(judge_in(link, model).holds for link in _links(printed)):
            continue
        free = {x: x for x in numbers - model.symbols()}
        wide = replace(model, meaning={**model.meaning, **free}) if free else model
        said = [link for each in asserted(equation, check) for link in _links(each)]
        for link, found in [(link, judge_in(link, wide)) for link in said]:
            if found.holds is False and found.at is not None:
                false = Finding(replace(check, claimed=equation), Verdict.FALSE)
                return Ruling(false, counterexample(link, found))
        meant = {x: model.value(x) for x in sorted(numbers, key=str)}
        equal = {x: of for x, of in meant.items() if of.is_Symbol and of != x}
        if equal and all(judge_in(link, wide).holds for link in said):
            where = ", ".join(f"{text(x)} = {text(of)}" for x, of in equal.items())
            return Ruling(None, f"it holds where {where}, which the claim does not say")
        return None
    return None


def _links(equation: Equation) -> list[Link]:
    return [
        Link(left, None if right == const else right) for left, right in pairwise(equation.sides)
    ]


def _extra(equation: Equation, known: _Known) -> Ruling:
    """A line to which nothing in the claim corresponds: it may still hold as one of its lines."""
    for place in known.printed:
        ruling = judged(equation, check_of(known.evidence[place]), known.letters)
        if ruling.verdict in HOLDS:
            return ruling
    return Ruling(None, f"the claim has no such line: {text(equation)}")


def _own(known: _Known, place: int) -> Finding:
    """The finding on what the claim itself prints."""
    if place not in known.own:
        item = known.evidence[place]
        known.own[place] = (
            judge_check(item, known.letters)
            if isinstance(item, Check)
            else Finding(check_of(item), Verdict.DEFINITION)
        )
    return known.own[place]


def _same(one: Equation, other: Equation) -> bool:
    return one.sides == other.sides and one.relation == other.relation
