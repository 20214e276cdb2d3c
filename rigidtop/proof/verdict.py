"""Verdicts, computed from residuals each time a claim is judged."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches

import sympy
from sympy import Expr
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean

from rigidtop.proof import bounds, decide
from rigidtop.proof.counterexample import (
    ANY,
    Counterexample,
    assertions,
    entries,
    imposed_on,
    is_refuted,
    parted,
    refute,
    typed_divisors,
)
from rigidtop.proof.decide import Verdict as Verdict
from rigidtop.proof.derivation import Judged
from rigidtop.proof.equation import Equation
from rigidtop.proof.independence import refuse_circular
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves.move import Condition
from rigidtop.proof.page import (
    Assumption,
    Check,
    Claim,
    Correction,
    Definition,
    Measure,
    Remark,
    Step,
)


class UnneededAssumptionError(Exception):
    """An assumption without which the check holds just as well."""


@dataclass(frozen=True)
class TestedAssumption:
    """An assumption with the counterexample that stands when it alone is dropped.

    What lines divide by, or whose sign they take, comes without one: there they say nothing.
    """

    assumption: Assumption
    without: Counterexample | None
    claimed: Equation | None = None
    """What fails without it."""


@dataclass(frozen=True)
class Finding:
    """A check with its verdict, and what it assumes or where it fails."""

    check: Check
    verdict: Verdict
    assumptions: tuple[TestedAssumption, ...] = ()
    counterexample: Counterexample | None = None


@dataclass(frozen=True)
class Led:
    """The derivation of a claim, line by line.

    `gaps` are the lines below it that do not follow, behind numbered equations too; `assumptions`
    what those named hold under, but for what their text sets.
    """

    lecture: Lecture
    name: str
    ids: tuple[str, ...]
    gaps: tuple[Judged, ...] = ()
    assumptions: tuple[TestedAssumption, ...] = ()


Item = Step | Definition | Measure | Finding | Led


@dataclass(frozen=True)
class Judgement:
    """A claim with its verdict and everything that its evidence showed, in order."""

    claim: Claim
    section: str
    verdict: Verdict
    items: tuple[Item, ...]
    seconds: float
    problem: str = ""

    @property
    def passed(self) -> bool:
        """False if undecided, or if something failed that the notes get right."""
        return not self.problem

    def findings(self) -> tuple[Finding, ...]:
        """What became of the checks of what the notes assert."""
        return tuple(f for f in self._all() if not isinstance(f.check, (Correction, Remark)))

    def corrections(self) -> tuple[Finding, ...]:
        """What became of the corrected forms of the claim."""
        return tuple(f for f in self._all() if isinstance(f.check, Correction))

    def remarks(self) -> tuple[Finding, ...]:
        """What became of the remarks, which are true besides."""
        return tuple(f for f in self._all() if isinstance(f.check, Remark))

    def besides(self) -> tuple[TestedAssumption, ...]:
        """What its lines hold under and its checks do not assume; without checks there is none."""
        assumed = [t.assumption.condition for f in self.findings() for t in f.assumptions]
        given = [each for each in assumed if not isinstance(each, sympy.Eq)]
        led = [item for item in self.items if isinstance(item, Led)] if self.findings() else []
        return tuple(
            tested
            for item in led
            for tested in item.assumptions
            if not _implied(tested.assumption.condition, given)
        )

    def _all(self) -> tuple[Finding, ...]:
        return tuple(item for item in self.items if isinstance(item, Finding))


def judge(
    claim: Claim,
    section: str = "",
    lecture: Lecture | None = None,
    letters: Letters = ANY,
    *,
    written: bool = False,
) -> Judgement:
    """Run the evidence of a claim and compute its verdict.

    With a `lecture` that has lines for it, the moves that lead there are made too; a claim without
    checks is judged by them, under the conditions that they record.  Where the page of the claim is
    `written`, there has to be such a line.  What the `letters` stand for has to exist where numbers
    refute.
    """
    start = time.perf_counter()
    items: list[Item] = []
    problem = ""
    try:
        found = claim.evidence()
        for evidence in found:
            if isinstance(evidence, Check):
                refuse_circular(evidence, found, claim.evidence)
            items.append(
                judge_check(evidence, letters) if isinstance(evidence, Check) else evidence
            )
        if lecture is not None and claim.name in lecture.names:
            items.append(led(lecture, claim.name))
        elif lecture is not None and (written or not items):
            problem = _nowhere(claim.name, lecture)
    except Exception as error:  # a claim that breaks is shown as undecided, never as a pass
        problem = f"{type(error).__name__}: {error}"
    judgement = Judgement(claim, section, Verdict.UNDECIDED, tuple(items), 0.0, problem)
    if not problem:
        verdict = _overall(judgement)
        judgement = replace(judgement, verdict=verdict)
        judgement = replace(judgement, problem=_problem(judgement))
    return replace(judgement, seconds=time.perf_counter() - start)


def _nowhere(name: str, lecture: Lecture) -> str:
    """What is said of a claim that no line of the pages has, such as for a mistyped anchor."""
    near = get_close_matches(name, lecture.names, n=1)
    return f"no line of the pages is called {name}" + (f"; one is {near[0]}" if near else "")


def led(lecture: Lecture, name: str) -> Led:
    """Make the moves that lead to what a name of the lecture names."""
    ids, _ = lecture.way(name)
    gaps = lecture.gaps(lecture.leading([name]))
    found = (c for id in lecture.names[name] for c in lecture.judged(id).known.conditions)
    kept = dict.fromkeys(_relation(c) for c in found if c.relation in _RELATIONS)
    assumed = tuple(
        TestedAssumption(Assumption(each), None)
        for each in kept
        if each != sympy.true and not (isinstance(each, sympy.Ne) and sympy.Gt(each.lhs, 0) in kept)
    )
    return Led(lecture, name, ids, gaps, assumed)


_RELATIONS = {"≠": sympy.Ne, ">": sympy.Gt, "≥": sympy.Ge}
"""What is not set: a division, a root, a sign."""


def _relation(condition: Condition) -> Boolean:
    """As people write it: χ̇ < 0 for −χ̇ > 0."""
    relation = _RELATIONS[condition.relation](condition.expression, 0)
    negative = condition.expression.as_coeff_Mul()[0].is_negative
    return relation.reversedsign if negative and isinstance(relation, Relational) else relation


def _implied(condition: Boolean, given: Sequence[Relational]) -> bool:
    """Whether a condition is known to hold where others do."""
    if isinstance(condition, sympy.Ne):
        difference = condition.lhs - condition.rhs
        signs = (bounds.positive(sign * difference, given) for sign in (1, -1))
        return bounds.nonzero(difference, given) or any(signs)
    return isinstance(condition, Relational) and bounds.positive(
        condition.gts - condition.lts, given
    )


def _overall(judgement: Judgement) -> Verdict:
    order = list(Verdict)
    verdicts = [finding.verdict for finding in judgement.findings()]
    if any(isinstance(item, Definition) for item in judgement.items):
        verdicts.append(Verdict.DEFINITION)
    led = [item for item in judgement.items if isinstance(item, Led)]
    if any(x.gaps for x in led):  # what it rests on is open: only a counterexample stands
        return Verdict.FALSE if Verdict.FALSE in verdicts else Verdict.UNDECIDED
    if not verdicts:  # what the lines lead to, from laws and definitions, is shown by them
        if not led:
            return Verdict.UNDECIDED
        return Verdict.ASSUMING if any(x.assumptions for x in led) else Verdict.PROVED
    return max(verdicts, key=order.index)


def _problem(judgement: Judgement) -> str:
    """One line that says why the claim does not pass, or nothing."""
    for item in judgement.items:
        if isinstance(item, Led) and item.gaps:
            [gap, *_] = item.gaps
            return f"{gap.line.file}, line {gap.line.at}, does not follow"
        if isinstance(item, Measure) and not item.passed:
            return f"{item.what}: error {item.error:.1e} exceeds {item.tolerance:.1e}"
    corrections = judgement.corrections()
    sound = (Verdict.PROVED, Verdict.SAMPLED, Verdict.ASSUMING)
    if any(correction.verdict not in sound for correction in corrections):
        return "the corrected form does not hold either"
    if any(remark.verdict not in sound for remark in judgement.remarks()):
        return "what is remarked besides does not hold"
    wrong = judgement.verdict in (Verdict.FALSE, Verdict.CONVENTION)
    if wrong and not corrections:
        return "it fails, and no corrected form stands beside it"
    if corrections and not wrong:
        return "a corrected form stands beside a claim that needs none"
    if judgement.verdict is Verdict.UNDECIDED:
        return "neither shown nor refuted"
    return ""


# --- one check ---------------------------------------------------------------------------------


def judge_check(check: Check, letters: Letters = ANY) -> Finding:
    """The verdict on one check.  Raises UnneededAssumptionError."""
    shown = _shown(check, letters)
    if shown is not None:
        tested = tuple(_tested(check, assumption, letters) for assumption in check.assuming)
        unstated = any(not assumption.stated for assumption in check.assuming)
        return Finding(check, Verdict.ASSUMING if unstated else shown, tested)
    counterexample = refute(check, letters=letters)
    if counterexample is None:
        return Finding(check, Verdict.UNDECIDED)
    other = check.other_reading
    if other is not None and _shown(replace(check, meaning=other), letters):
        return Finding(check, Verdict.CONVENTION, (), counterexample)
    return Finding(check, Verdict.FALSE, (), counterexample)


def _tested(check: Check, assumption: Assumption, letters: Letters) -> TestedAssumption:
    others = tuple(other for other in check.assuming if other is not assumption)
    without = refute(replace(check, assuming=others), assumption, letters=letters)
    if without is None:
        raise UnneededAssumptionError(
            f"{assumption.condition} is not needed, or no counterexample to dropping it was found"
        )
    return TestedAssumption(assumption, without, check.claimed)


def _shown(check: Check, letters: Letters) -> Verdict | None:
    """PROVED or SAMPLED where the relation holds under the assumptions, else None."""
    relations = assertions(check.claimed, check.meaning)
    equal, conditions = parted(check.assuming)
    # Cheap refutation first: most claims that fail, fail at the first point.
    if is_refuted(check, 8, letters):
        return None
    divisors = typed_divisors(check.claimed, check.meaning)
    if not all(_covered(d, equal, conditions) for d in divisors):
        return None
    sampled = False
    for relation, left, right in relations:
        differences = [
            _without_bars(imposed_on(d, equal), conditions) for d in entries(left, right)
        ]
        if relation in ("=", "≡"):
            given = [imposed_on(h, equal) for h in check.given]
            for difference in differences:
                if any(bounds.follows(difference, h, conditions) for h in given):
                    continue
                found = decide.evidence(difference)
                # Digits are evidence only where a wide search for a counterexample failed.
                if found is None or (
                    found is Verdict.SAMPLED and (given or is_refuted(check, 600, letters))
                ):
                    return None
                sampled |= found is Verdict.SAMPLED
        elif relation == "≠":
            if not any(bounds.nonzero(d, conditions) for d in differences):
                return None
        elif relation in (">", "<"):
            sign = 1 if relation == ">" else -1
            if not all(bounds.positive(sign * d, conditions) for d in differences):
                return None
        else:
            raise ValueError(f"a check can't judge the relation {relation!r}")
    return Verdict.SAMPLED if sampled else Verdict.PROVED


def _covered(divisor: Expr, equal: Mapping[Expr, Expr], conditions: Sequence[Relational]) -> bool:
    """Whether the symbols or the conditions keep a divisor from vanishing."""
    imposed = _without_bars(imposed_on(divisor, equal), conditions)
    return bounds.nonzero(imposed, conditions) or any(
        bounds.positive(sign * imposed, conditions) for sign in (1, -1)
    )


def _without_bars(expression: Expr, conditions: Sequence[Relational]) -> Expr:
    return bounds.without_bars(expression, lambda x: bounds.sign(x, conditions))
