"""The record of every verdict as a document."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType

import sympy
from sympy import MatrixBase

from rigidtop.proof.equation import Equation
from rigidtop.proof.verdict import (
    Judgement,
    TestedAssumption,
    Verdict,
)
from rigidtop.report import blocks as b
from rigidtop.report.claims import claim_blocks, condition, tested
from rigidtop.report.handout import parted
from rigidtop.report.symbols import symbol_list
from rigidtop.typeset.layout import layout
from rigidtop.typeset.nodes import Node
from rigidtop.typeset.sizes import width

READING = (
    "Each claim of the notes is typed as it is printed there and held against what a computer "
    "algebra system derives by itself from the definitions. The residual between the two "
    "decides. Nothing is judged by its looks, and no verdict is written by hand."
)


def document(
    judged: b.Judged,
    closing: Iterable[tuple[str, b.Block]] = (),
    front: b.Front = b.NOTES,
    texts: Mapping[str, Sequence[b.Block]] = MappingProxyType({}),
) -> b.Document:
    """The lecture.  The blocks `closing` a section come with its number: figures, exercises.

    `texts` are the sections' texts by their numbers; behind them stand the verdicts.
    """
    after: dict[str, list[b.Block]] = {}
    for section, block in closing:
        after.setdefault(section, []).append(block)
    blocks: list[b.Block] = [*_front(judged)]
    for page, judgements in judged:
        blocks.extend(b.headings(page))
        blocks.extend(texts.get(page.section, [b.Paragraph((page.about,), held=True)]))
        for judgement in judgements:
            blocks.extend(claim_blocks(judgement))
        blocks.extend(after.get(page.section, ()))
    whole = (*parted(blocks), *symbol_list(blocks))
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
    yield b.Listing(("verdict", "claims", "what it says"), tuple(rows), (0, 0, 0.68))
    found = tuple(_found(judgement) for judgement in everything if judgement.verdict in _NOTED)
    if found:
        yield b.Heading(1, "", "What was found in the notes", "found")
        head = ("section", "claim", "verdict", "what is amiss")
        yield b.Listing(head, found, (0, 0.17, 0, 0.5))


_NOTED = (Verdict.ASSUMING, Verdict.CONVENTION, Verdict.FALSE, Verdict.UNDECIDED)


def _found(judgement: Judgement) -> tuple[b.Rich, ...]:
    claim = judgement.claim
    content: b.Rich
    if judgement.verdict is Verdict.ASSUMING:
        silent = [t for t in tested(judgement) if not t.assumption.stated]
        content = ("Not stated: ", *_joined(silent), ".")
    else:
        content = (claim.says,)
        corrected = [c.check.claimed for c in judgement.corrections()]
        shown = [layout(equation, "printed") for equation in corrected if not _has_matrix(equation)]
        short = [node for node in shown if width(node) < 45]
        for i, node in enumerate(short):
            content = (*content, "; " if i else " Corrected: ", node)
        if len(short) < len(corrected):
            content = (*content, "; more at the claim" if short else " Corrected at the claim")
        if corrected:
            content = (*content, ".")
    name = b.Cited(claim.name, b.anchor(claim.name))
    return (judgement.section,), (name,), (judgement.verdict,), content


def _has_matrix(equation: Equation) -> bool:
    nodes = (node for side in equation.sides for node in sympy.preorder_traversal(side))
    return any(isinstance(node, MatrixBase) for node in nodes)


def _joined(tested: Sequence[TestedAssumption]) -> b.Rich:
    pieces: list[str | Node] = []
    for i, item in enumerate(tested):
        pieces.append("; " if i else "")
        pieces.append(condition(item.assumption))
        if item.assumption.words:
            pieces.append(f" ({item.assumption.words.rstrip('.')})")
    return tuple(piece for piece in pieces if piece != "")
