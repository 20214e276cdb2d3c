"""The record of every verdict: the text of the lecture with all that was found at each claim."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from rigidtop.notation import NOTES as NOTES_NOTATION
from rigidtop.notation import Notation
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.verdict import (
    Judgement,
    Verdict,
)
from rigidtop.report import blocks as b
from rigidtop.report.front import NOTES, Front
from rigidtop.report.handout import Parts, answer, parted, question, section
from rigidtop.report.marks import LEGEND, marked
from rigidtop.report.solutions import Solution, confirmed
from rigidtop.report.symbols import symbol_list
from rigidtop.report.ways import law_blocks

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
    front: Front = NOTES,
    notation: Notation = NOTES_NOTATION,
) -> b.Document:
    """The lecture without figures, and with each claim all that was found, in place of its mark.

    The solved exercises of a section close it.  What the lines start from stands at the end.
    """
    parts = Parts(lines, notation, {}, {}, recorded=True)
    blocks: list[b.Block] = [*_front(judged)]
    places: dict[str, b.Rich] = {j.claim.name: () for _, judgements in judged for j in judgements}
    texts = {page.text for page, _ in judged}
    numbered = [*enumerate(solutions, 1)]
    for page, judgements in judged:
        blocks += section(page, judgements, parts)
        for number, solution in numbered:
            if solution.exercise.section == page.section:
                blocks += question(solution.exercise, solution.settings, number)
                blocks += answer(solution, parts, places)
                blocks += [confirmed(solution.measures)] if solution.measures else []
                places |= {judgement.claim.name: () for judgement in solution.judgements}
                texts |= {solution.text.name} if solution.text is not None else set()
    cited = law_blocks(lines, texts, notation)
    if cited:
        blocks += [b.SectionHead(1, "", "Laws and definitions that are cited", "cited"), *cited]
    whole = (*parted(blocks), *symbol_list(blocks, b.SectionHead(1, "", "Symbols", "symbols")))
    return b.Document(front.title, front.subtitle, whole, front.source, front.author)


def _front(judged: b.Judged) -> Iterable[b.Block]:
    everything = [judgement for _, judgements in judged for judgement in judgements]
    yield b.SectionHead(1, "", "How to read the verdicts", "verdicts")
    yield b.Paragraph((READING,))
    counts = Counter(judgement.verdict for judgement in everything)
    rows: list[tuple[b.Rich, ...]] = [
        ((v,), (str(counts[v]),), (words,)) for v, words in LEGEND.items() if counts[v]
    ]
    rows.append((("all",), (str(len(everything)),), ()))
    yield b.TableBlock(("verdict", "claims", "what it says"), tuple(rows), "", "text", (0, 0, 0.68))
    yield b.Paragraph(("The claims that only exercises make are ours, and are not counted here.",))
    amiss = tuple(_amiss(judgement) for judgement in everything if judgement.verdict in _NOTED)
    if amiss:
        yield b.SectionHead(1, "", "What was found in the notes", "found")
        head = ("section", "claim", "verdict", "what is amiss")
        yield b.TableBlock(head, amiss, "", "text", (0, 0.17, 0, 0.5))


_NOTED = (Verdict.ASSUMING, Verdict.CONVENTION, Verdict.FALSE, Verdict.UNDECIDED)


def _amiss(judgement: Judgement) -> tuple[b.Rich, ...]:
    """A row of the list: what the margin of the lecture says of a claim, or what stands behind."""
    mark, *behind = marked(judgement)
    remark = behind[0] if behind else mark
    content = remark.note if isinstance(remark, b.MarginMark) else getattr(remark, "content", ())
    content = content or (judgement.claim.says,)
    name = b.Cited(judgement.claim.name, b.anchor(judgement.claim.name))
    return (judgement.section,), (name,), (judgement.verdict,), content
