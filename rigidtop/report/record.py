"""The record of every verdict as a document."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rigidtop.notation import NOTES, Notation
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.page import Assumption
from rigidtop.proof.verdict import (
    Judgement,
    Verdict,
)
from rigidtop.report import blocks as b
from rigidtop.report.claims import condition, in_words, tested
from rigidtop.report.handout import Parts, answer, parted, question, section
from rigidtop.report.solutions import Solution, confirmed
from rigidtop.report.symbols import symbol_list
from rigidtop.report.ways import law_blocks
from rigidtop.typeset.layout import layout

NO_LINES = Lecture()

READING = (
    "Each claim of the notes is typed as it is printed there and held against what a computer "
    "algebra system derives by itself from the definitions. The residual between the two "
    "decides. Nothing is judged by its looks, and no verdict is written by hand."
)


def document(
    judged: b.Judged,
    solutions: Sequence[Solution] = (),
    lines: Lecture = NO_LINES,
    front: b.Front = b.NOTES,
    notation: Notation = NOTES,
) -> b.Document:
    """The lecture without figures, and with each claim all that was found, in place of its mark.

    The solved exercises of a section close it.  What the lines start from stands at the end.
    """
    parts = Parts(lines, notation, {}, {}, recorded=True)
    blocks: list[b.Block] = [*_front(judged)]
    told: dict[str, b.Rich] = {j.claim.name: () for _, judgements in judged for j in judgements}
    texts = {page.text for page, _ in judged}
    numbered = [*enumerate(solutions, 1)]
    for page, judgements in judged:
        blocks += section(page, judgements, parts)
        for number, solution in numbered:
            if solution.exercise.section == page.section:
                blocks += question(solution.exercise, solution.settings, number)
                blocks += answer(solution, parts, told)
                blocks += [confirmed(solution.measures)] if solution.measures else []
                told |= {judgement.claim.name: () for judgement in solution.judgements}
                texts |= {solution.text.name} if solution.text is not None else set()
    cited = law_blocks(lines, texts, notation)
    if cited:
        blocks += [b.Heading(1, "", "Laws and definitions that are cited", "cited"), *cited]
    whole = (*parted(blocks), *symbol_list(blocks, b.Heading(1, "", "Symbols", "symbols")))
    return b.Document(front.title, front.subtitle, whole, front.source, front.author)


def _front(judged: b.Judged) -> Iterable[b.Block]:
    everything = [judgement for _, judgements in judged for judgement in judgements]
    yield b.Heading(1, "", "How to read the verdicts", "verdicts")
    yield b.Paragraph((READING,))
    counts = [(v, sum(j.verdict is v for j in everything)) for v in Verdict]
    rows: list[tuple[b.Rich, ...]] = [
        ((v,), (str(count),), (b.MEANINGS[v],)) for v, count in counts if count
    ]
    rows.append((("all",), (str(len(everything)),), ()))
    yield b.Table(("verdict", "claims", "what it says"), tuple(rows), "", "text", (0, 0, 0.68))
    yield b.Paragraph(("The claims that only exercises make are ours, and are not counted here.",))
    found = tuple(_found(judgement) for judgement in everything if judgement.verdict in _NOTED)
    if found:
        yield b.Heading(1, "", "What was found in the notes", "found")
        head = ("section", "claim", "verdict", "what is amiss")
        yield b.Table(head, found, "", "text", (0, 0.17, 0, 0.5))


_NOTED = (Verdict.ASSUMING, Verdict.CONVENTION, Verdict.FALSE, Verdict.UNDECIDED)


def _found(judgement: Judgement) -> tuple[b.Rich, ...]:
    claim = judgement.claim
    content: b.Rich
    if judgement.verdict is Verdict.ASSUMING:
        silent = [t.assumption for t in tested(judgement) if not t.assumption.stated]
        content = ("Not stated: ", *b.listed(map(_named, silent), "; "), ".")
    else:
        printed = {f.check.claimed.sides for f in judgement.findings() if f.check.printed}
        amended = [c.check for c in judgement.corrections()]
        corrected = [check.claimed for check in amended if check.claimed.sides not in printed]
        reasons = [] if corrected else [check.reason for check in amended]
        content = (" ".join([claim.says, *filter(None, reasons)]),)
        short = [each for each in (layout(c, "printed") for c in corrected) if in_words(each)]
        for i, node in enumerate(short):
            content = (*content, "; " if i else " Corrected: ", node)
        if len(short) < len(corrected):
            content = (*content, "; more at the claim" if short else " Corrected at the claim")
        if corrected:
            content = (*content, ".")
    name = b.Cited(claim.name, b.anchor(claim.name))
    return (judgement.section,), (name,), (judgement.verdict,), content


def _named(assumption: Assumption) -> b.Rich:
    """A condition, and what it says in words."""
    words = assumption.words.rstrip(".")
    return (condition(assumption), *([f" ({words})"] if words else []))
