"""Judgements as rows of a table and as records for programs."""

from __future__ import annotations

from collections.abc import Iterable

from rigidtop.proof.page import Claim, Measure
from rigidtop.proof.verdict import Finding, Judgement, Led, TestedAssumption, Verdict
from rigidtop.report import plain
from rigidtop.report.claims import condition, said_at, tested
from rigidtop.report.ways import gap
from rigidtop.typeset.text import text
from rigidtop.typeset.words import unmarked


def record(judgement: Judgement) -> dict[str, object]:
    """What `rigidtop check --json` says of a claim."""
    return {
        "name": judgement.claim.name,
        "reference": judgement.section,
        "verdict": judgement.verdict.value,
        "assumptions": [_assumption(item) for item in tested(judgement)],
        "lines_hold_if": [_assumption(item) for item in judgement.besides()],
        "note": note(judgement),
        "seconds": round(judgement.seconds, 4),
        "passed": judgement.passed,
        "measures": [measure_record(measure) for measure in measures([judgement])],
    }


def measure_record(measure: Measure) -> dict[str, object]:
    """A measure as plain values, for JSON."""
    return {
        "what": unmarked(measure.what),
        "error": float(measure.error),
        "tolerance": float(measure.tolerance),
        "passed": measure.passed,
    }


def claim_record(claim: Claim, section: str) -> dict[str, object]:
    """What `rigidtop list --json` says of a claim."""
    return {
        "name": claim.name,
        "reference": section,
        "says": unmarked(claim.says),
        "reason": unmarked(claim.reason),
    }


def measures(judgements: Iterable[Judgement]) -> list[Measure]:
    """What was measured on computed motions, in order."""
    return [item for j in judgements for item in j.items if isinstance(item, Measure)]


def note(judgement: Judgement) -> str:
    """One line: why it does not pass, or what is silently assumed, or what refutes it."""
    return unmarked(_note(judgement))


def _note(judgement: Judgement) -> str:
    gaps = [
        gap(each, i.lecture.letters)
        for i in judgement.items
        if isinstance(i, Led)
        for each in i.gaps
    ]
    if gaps:
        return gaps[0]
    if judgement.problem:
        # A corrected form that fails is the one to look at.
        failed = _refuted(judgement.corrections() or judgement.findings())
        return "; ".join([judgement.problem, *failed])
    parts = _refuted(judgement.findings())
    silent = [item for item in tested(judgement) if not item.assumption.stated]
    if silent:
        parts.append("holds if " + "; ".join(_assumption(item) for item in silent))
    besides = [_assumption(item) for item in judgement.besides()]
    parts += [f"its lines hold if {'; '.join(besides)}"] if besides else []
    parts += [f"corrected: {_conditioned(finding)}" for finding in judgement.corrections()[:1]]
    return "; ".join(parts)


def _conditioned(finding: Finding) -> str:
    """An equation and what it holds for."""
    conditions = [text(condition(item.assumption)) for item in finding.assumptions]
    return text(finding.check.claimed) + (f" if {', '.join(conditions)}" if conditions else "")


def _refuted(findings: Iterable[Finding]) -> list[str]:
    """The first counterexample with its numbers, if there is one."""
    return [
        f"{_where(finding)}{plain.rich(said_at(finding.counterexample))}"
        for finding in findings
        if finding.counterexample is not None
    ][:1]


def _where(finding: Finding) -> str:
    """The line that fails, in the words beside it."""
    reason = finding.check.reason.rstrip(".,")
    return f"“{reason}” " if reason and finding.verdict is Verdict.FALSE else ""


def _assumption(item: TestedAssumption) -> str:
    relation = text(condition(item.assumption))
    words = item.assumption.words.rstrip(".")
    sentence = f"{relation} ({words})" if words else relation
    return unmarked(f"{sentence} [stated]" if item.assumption.stated else sentence)
