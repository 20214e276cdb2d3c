"""Verdicts as marks in the margin: their legend, their notes, and what is set right behind them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from sympy import Basic

from rigidtop.proof.equation import Equation
from rigidtop.proof.page import Assumption
from rigidtop.proof.verdict import Finding, Judgement, Verdict
from rigidtop.report import blocks as b
from rigidtop.report.claims import condition, in_words, place, refuted, tested
from rigidtop.typeset.layout import layout
from rigidtop.typeset.nodes import Chain, Node

LEGEND: Mapping[Verdict, str] = {
    Verdict.PROVED: "it was shown to hold, in symbols",
    Verdict.SAMPLED: "it holds at random points to 40 digits, and was not shown in symbols",
    Verdict.ASSUMING: "it holds under the condition noted with it, or under one in its lines",
    Verdict.CONVENTION: "right in content, at odds with the notes’ own definitions",
    Verdict.FALSE: "it does not hold as the notes have it; the right form stands beneath",
    Verdict.DEFINITION: "it introduces a name, and there is nothing to prove",
    Verdict.UNDECIDED: "neither shown nor refuted",
}


def legend(judgements: Iterable[Judgement]) -> b.Legend:
    """What the marks mean that are used."""
    used = {judgement.verdict for judgement in judgements}
    return b.Legend(tuple((v, words) for v, words in LEGEND.items() if v in used))


def set_right(judgement: Judgement) -> Judgement:
    """A claim as its corrected form was judged, for those who have no quarrel with the notes."""
    verdicts = [finding.verdict for finding in judgement.corrections()]
    return replace(judgement, verdict=max(verdicts, key=ORDER)) if verdicts else judgement


ORDER = list(Verdict).index


def marked(
    judgement: Judgement, lines: Sequence[Equation] = ()
) -> tuple[b.MarginMark | b.Block, ...]:
    """The mark of a claim; behind it, where the notes are wrong, the numbers and the right form.

    What its text has among its `lines` is not said again.
    """
    claim, verdict = judgement.claim, judgement.verdict
    if verdict in (Verdict.FALSE, Verdict.CONVENTION):
        there = {each.sides for each in lines}
        mark = b.MarginMark(claim.name, verdict)
        if lines and verdict is Verdict.FALSE:
            # The lines above are right: the mark is that of the sentence in the notes.
            remark, *behind = _set_right(judgement, there)
            assert isinstance(remark, b.Paragraph)
            return (replace(remark, mark=mark), *behind)
        return (mark, *_set_right(judgement, there))
    return (b.MarginMark(claim.name, verdict, _note(judgement, lines)),)


def _note(judgement: Judgement, lines: Sequence[Equation]) -> b.Rich:
    """Under which conditions that the notes do not state a claim holds.

    What its lines divide by, they say themselves; letters that no line has, words say.
    """
    if judgement.verdict is not Verdict.ASSUMING:
        return ()
    together: dict[str, list[Assumption]] = {}
    for item in tested(judgement):
        if not item.assumption.stated and item.without is not None:
            together.setdefault(item.assumption.words.rstrip("."), []).append(item.assumption)
    letters = {x for each in lines for x in _letters(*each.sides)}

    def clause(words: str, assumed: Sequence[Assumption]) -> b.Rich:
        relations = b.listed((condition(each),) for each in assumed)
        if not words:
            return ("if ", *relations)
        seen = letters.issuperset(_letters(*(each.condition for each in assumed)))
        return ("if ", words, *((" (", *relations, ")") if seen or not lines else ()))

    return b.listed((clause(*each) for each in together.items()), "; ")


def _letters(*parts: Basic) -> set[Basic]:
    return {letter for part in parts for letter in part.free_symbols}


SAID = "The notes say: "


def _related(left: b.Piece, relation: str, right: b.Piece) -> b.Rich:
    """Two sides with the sign between them; one of them may be words, "undefined"."""
    if isinstance(left, Node) and isinstance(right, Node):
        return (Chain((left, right), (relation,)),)
    return left, f" {relation} ", right


def _set_right(judgement: Judgement, there: Collection[Any]) -> Iterator[b.Block]:
    """A statement that is wrong, its numbers, and its corrected form, in a sentence."""
    claim = judgement.claim
    correction = {
        Verdict.FALSE: "This is false",
        Verdict.CONVENTION: "This is at odds with the notes’ own definitions",
    }[judgement.verdict]
    words: list[b.Piece] = [SAID, f"{claim.says.rstrip('.')}. ", correction]
    failed = next((f for f in judgement.findings() if f.counterexample), None)
    if failed is not None and failed.counterexample is not None:
        at, left, right = refuted(failed.counterexample)
        claimed = layout(failed.check.claimed, "printed")
        what = f"({claim.name})" if b.is_number(claim.name) else "the equation"
        words += [": ", *at, ", " if at else ""]
        words += [claimed] if in_words(claimed) else [what, " as the notes print it"]
        entry = place(failed.counterexample)
        words += [" would be ", *_related(left, failed.check.claimed.relation, right)]
        words += [" ", *entry] if entry else []
    corrected = [c for c in judgement.corrections() if c.check.claimed.sides not in there]
    equations = [finding.check.claimed for finding in corrected]
    short = [layout(equation, "printed") for equation in equations]
    if len(short) == 1 and in_words(short[0]) and not corrected[0].check.reason:
        words += [". It should be ", short[0], *_under(corrected[0]), "."]
        yield b.Paragraph(tuple(words), mark=None)
        return
    yield b.Paragraph((*(each for each in words if each != ""), "."), held=bool(corrected))
    rows = tuple(
        b.DisplayRow(finding.check.claimed, "printed", reason=_colon(finding.check.reason, finding))
        for finding in corrected
    )
    if rows:
        yield b.Display(rows)


def _under(finding: Finding) -> b.Rich:
    """The conditions of a corrected form."""
    under = b.listed((condition(item.assumption),) for item in finding.assumptions)
    return (", where ", *under) if under else ()


def _colon(reason: str, finding: Finding) -> b.Rich:
    words = reason.strip().rstrip(".:") or "What holds"
    return (words, *_under(finding), ":")
