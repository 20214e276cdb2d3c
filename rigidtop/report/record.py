"""The record of every verdict as a document."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from rigidtop.notation import NOTES, Notation
from rigidtop.proof.equation import Equation
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.verdict import (
    Judgement,
    TestedAssumption,
    Verdict,
)
from rigidtop.report import blocks as b
from rigidtop.report.claims import condition, in_words, tested
from rigidtop.report.handout import parted
from rigidtop.report.solutions import Solution, numbers, question
from rigidtop.report.symbols import symbol_list
from rigidtop.report.ways import called, claim_told, told_rows
from rigidtop.typeset.layout import layout
from rigidtop.typeset.nodes import Node

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
    """Every claim with the lines that lead to it and what was found, section by section.

    The exercises of a section close it.  What the lines start from stands at the end.
    """
    blocks: list[b.Block] = [*_front(judged)]
    told = {judgement.claim.name for _, judgements in judged for judgement in judgements}
    numbered = [*enumerate(solutions, 1)]
    for page, judgements in judged:
        blocks += b.headings(page)
        blocks.append(b.Paragraph((page.about,), held=True))
        for judgement in judgements:
            blocks += claim_told(judgement, notation)
        for number, solution in numbered:
            if solution.exercise.section == page.section:
                blocks += _solved(solution, number, told, notation)
                told |= {judgement.claim.name for judgement in solution.judgements}
    blocks += _cited(lines, told, notation)
    whole = (*parted(blocks), *symbol_list(blocks, b.Heading(1, "", "Symbols", "symbols")))
    return b.Document(front.title, front.subtitle, whole, front.source, front.author)


def _solved(
    solution: Solution, number: int, told: Collection[str], notation: Notation
) -> Iterable[b.Block]:
    """An exercise; claims that were `told` before are named only."""
    yield from question(solution.exercise, solution.settings, number=number, named=False)
    there = [each.claim for each in solution.judgements if each.claim.name in told]
    if there:
        names = ", ".join(f"({c.name})" if b.is_number(c.name) else c.name for c in there)
        kind = "claim" if len(there) == 1 else "claims"
        yield b.Paragraph((f"See the {kind} {names} above.",))
    for judgement in solution.judgements:
        if judgement.claim.name not in told:
            yield from claim_told(judgement, notation)
    yield from numbers(solution)


def _cited(lines: Lecture, told: Collection[str], notation: Notation) -> Iterable[b.Block]:
    """The laws and other lines from which those of the claims start, and which are not shown."""
    ways = [lines.way(name) for name in lines.names if name in told]
    shown = {id for way, _ in ways for id in way}
    starts = {id for _, starts in ways for id in starts} - shown
    rows: list[b.Row] = []
    said: set[tuple[Equation, ...]] = set()
    for id, line in lines.lines.items():
        if id in starts and line.equations not in said:
            said.add(line.equations)
            first, *others = told_rows(lines, line, notation)
            # What was done to get to another line stands in the lecture.
            named = (
                first if id in lines.laws else replace(first, reason=(*called(line, notation), ":"))
            )
            rows += [named, *others]
    if rows:
        yield b.Heading(1, "", "Laws, definitions and other lines that are cited", "cited")
        yield b.Display(tuple(rows))


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
        silent = [t for t in tested(judgement) if not t.assumption.stated]
        content = ("Not stated: ", *_joined(silent), ".")
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


def _joined(tested: Sequence[TestedAssumption]) -> b.Rich:
    pieces: list[str | Node] = []
    for i, item in enumerate(tested):
        pieces.append("; " if i else "")
        pieces.append(condition(item.assumption))
        if item.assumption.words:
            pieces.append(f" ({item.assumption.words.rstrip('.')})")
    return tuple(piece for piece in pieces if piece != "")
