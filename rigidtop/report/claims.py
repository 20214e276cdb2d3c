"""A judged claim as blocks: what is said and in which order."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import sympy
from sympy import Expr, Symbol

from rigidtop.proof.counterexample import Counterexample
from rigidtop.proof.equation import Equation, Printed
from rigidtop.proof.page import Assumption, Correction, Definition, Measure, Step
from rigidtop.proof.verdict import Finding, Judgement, Led, TestedAssumption, Verdict
from rigidtop.report import blocks as b
from rigidtop.theory.lettered import known
from rigidtop.typeset import nodes as lay
from rigidtop.typeset import sizes
from rigidtop.typeset.layout import layout
from rigidtop.typeset.nodes import Node
from rigidtop.typeset.sizes import width
from rigidtop.typeset.text import text


def claim_blocks(judgement: Judgement, *, marks: bool = True) -> list[b.Block]:
    """A claim with all that its evidence showed; `marks` puts verdicts that differ beside lines."""
    claim = judgement.claim
    findings = judgement.findings()
    blocks: list[b.Block] = [
        b.ClaimHead(claim.name, b.anchor(claim.name), claim.says, judgement.verdict)
    ]
    mixed = marks and len({finding.verdict for finding in findings}) > 1
    led = any(isinstance(item, Led) for item in judgement.items)
    rows = tagged_rows(judgement, mixed)
    amiss = judgement.verdict in (Verdict.FALSE, Verdict.CONVENTION)
    if rows and (amiss or not led):
        blocks.append(b.Display(rows, "The notes print"))
    if not led:  # else its lines say the rest
        if claim.reason:
            blocks.append(b.Paragraph((claim.reason,), "Reason"))
        blocks.extend(derivation(judgement, mixed))
        meanings = _meanings(judgement)
        if meanings:
            blocks.append(b.Display(meanings, "The engine's own expressions"))
    assumed = tested(judgement)
    if assumed:
        blocks.append(b.Items(conditions(assumed), "Assumptions"))
    besides = judgement.besides()
    if besides:
        blocks.append(b.Items(conditions(besides), "Its lines hold under"))
    blocks.extend(
        b.Paragraph((*_failing(finding), *said_at(finding.counterexample), "."), "Counterexample")
        for finding in findings
        if finding.counterexample is not None
    )
    for label, more in (
        ("Corrected form", judgement.corrections()),
        ("Besides", judgement.remarks()),
    ):
        if more:
            more_rows = tuple(replace(_notes_row(item, False), tag="") for item in more)
            blocks.append(b.Display(more_rows, label))
            under = conditions([t for item in more for t in item.assumptions])
            blocks += [b.Items(under, "Assumptions")] if under else []
    measures = tuple(item for item in judgement.items if isinstance(item, Measure))
    if measures:
        blocks.append(measured(measures))
    if judgement.problem and not any(isinstance(i, Led) and i.gaps for i in judgement.items):
        blocks.append(
            b.Paragraph((f"This claim does not pass. {_sentence(judgement.problem)}",), "")
        )
    return blocks


def tagged_rows(judgement: Judgement, mixed: bool = False) -> tuple[b.DisplayRow, ...]:
    """What the notes print of a claim, with its number."""
    items: list[Definition | Finding] = [
        *(item for item in judgement.items if isinstance(item, Definition)),
        *(finding for finding in judgement.findings() if finding.check.printed),
    ]
    rows = [_notes_row(item, mixed) for item in items]
    return _tagged(rows, judgement.claim.name) if rows else ()


def derivation(judgement: Judgement, mixed: bool) -> Iterable[b.Block]:
    """Steps and formal checks in their order; an equation that stands already is not repeated."""
    rows: list[b.DisplayRow] = []
    again: list[str] = []
    seen = {_said(f) for f in judgement.findings() if f.check.printed}
    for item in judgement.items:
        if isinstance(item, Step):
            rows.append(b.DisplayRow(item.equation, "auto", reason=item.reason))
        elif isinstance(item, Finding) and item in judgement.findings():
            if item.check.printed:
                continue
            if _said(item) in seen:
                again.append(item.check.reason)
                continue
            seen.add(_said(item))
            rows.append(replace(_notes_row(item, mixed), tag=""))
    if rows:
        yield b.Display(tuple(rows), "Derivation")
    sentences = list(dict.fromkeys(filter(None, again)))
    if sentences:
        yield b.Paragraph((" ".join(map(_sentence, sentences)),), "Checked again")


def _said(finding: Finding) -> b.Rich:
    """What a line says: the equation, its verdict, and, where a reason tells, under what."""
    check = finding.check
    conditions = {str(a.condition) for a in check.assuming} if check.reason else ()
    return (*check.claimed.sides, check.claimed.relation, finding.verdict, frozenset(conditions))


def _sentence(words: str) -> str:
    return words[:1].upper() + words[1:].rstrip(".") + "."


def _notes_row(item: Definition | Finding, mixed: bool) -> b.DisplayRow:
    if isinstance(item, Definition):
        return b.DisplayRow(item.equation, "printed", item.equation.tag, item.reason)
    check = item.check
    return b.DisplayRow(
        check.claimed,
        "printed",
        check.claimed.tag,
        check.reason,
        bool(check.given) and not isinstance(check, Correction),
        item.verdict if mixed else None,
    )


def _tagged(rows: Sequence[b.DisplayRow], name: str) -> tuple[b.DisplayRow, ...]:
    """Each number once, behind the last of its lines; the claim's own if no line has one."""
    tags = [row.tag for row in rows]
    if not any(tags) and b.is_number(name):
        tags[-1] = name
    once = [tag if tag not in tags[i + 1 :] else "" for i, tag in enumerate(tags)]
    return tuple(replace(row, tag=tag) for row, tag in zip(rows, once, strict=True))


LONGEST = 110.0
"""A meaning that is wider than this is not printed, nor one that does not go into two lines."""


def _meanings(judgement: Judgement) -> tuple[b.DisplayRow, ...]:
    """What the symbols of the claim stand for in the engine, where that is short and the same
    in all checks of what the notes print, and not shown as a step."""
    checks = [finding.check for finding in judgement.findings()]
    steps = {item.equation.sides for item in judgement.items if isinstance(item, Step)}
    rows_of: dict[str, set[b.DisplayRow]] = {}
    for check in [c for c in checks if c.printed] or checks:
        for symbol, meaning in check.meaning.items():
            used = any(side.has(symbol) for side in check.claimed.sides)
            if used and _is_shown(symbol, meaning):
                row = b.DisplayRow(Equation(symbol, meaning), "auto")
                rows_of.setdefault(text(symbol), set()).add(row)
    rows = [
        row for alternatives in rows_of.values() if len(alternatives) == 1 for row in alternatives
    ]
    return tuple(row for row in rows if row.equation.sides not in steps and _is_short(row.equation))


def _is_short(equation: Equation) -> bool:
    if width(layout(equation)) > LONGEST:
        return False
    return all(width(line.right) <= sizes.LINE for line in sizes.lines(equation))


def _is_shown(symbol: Any, meaning: Any) -> bool:
    if not isinstance(symbol, (Symbol, Printed)):
        return False
    if isinstance(meaning, sympy.MatrixBase):  # an axis along itself says nothing
        return bool(meaning.free_symbols)
    return isinstance(meaning, Expr) and not meaning.is_Atom


def tested(judgement: Judgement) -> list[TestedAssumption]:
    """The assumptions of all findings, each once; of a claim without any those of its lines."""
    once: dict[tuple[str, str], TestedAssumption] = {}
    led = [item for item in judgement.items if isinstance(item, Led)]
    for finding in judgement.findings() or led:
        for tested in finding.assumptions:
            key = (str(tested.assumption.condition), tested.assumption.words)
            once.setdefault(key, tested)
    return list(once.values())


def condition(assumption: Assumption) -> Node:
    """The relation as it is written; a limit, ε = 0 for the engine, as ε → 0."""
    relation = layout(assumption.condition)
    if assumption.otherwise is not None and isinstance(relation, lay.Chain):
        return replace(relation, signs=("→",))
    return relation


def measured(
    rows: Sequence[Measure], title: str = "Measured", compared: str = "on a computed motion"
) -> b.TableBlock:
    """What was compared: on computed motions, or by a second way to the same number."""
    cells = tuple(
        (row.what, *(lay.decimal(x, 2) for x in (row.error, row.tolerance))) for row in rows
    )
    return b.TableBlock((compared, "error", "tolerance"), cells, title)


def conditions(assumed: Sequence[TestedAssumption]) -> tuple[b.Rich, ...]:
    """Assumptions as they are listed: those with the same words together, one counterexample.

    Where they are of several equations, it is said which fails.
    """
    together: dict[tuple[str, bool], list[TestedAssumption]] = {}
    for item in assumed:
        words = item.assumption.words.rstrip(".")
        key = (words or str(item.assumption.condition), item.assumption.stated)
        together.setdefault(key, []).append(item)
    several = len({item.claimed for item in assumed} - {None}) > 1
    return tuple(_condition(items, several) for items in together.values())


def _condition(items: Sequence[TestedAssumption], several: bool) -> b.Rich:
    relations = tuple(dict.fromkeys(condition(item.assumption) for item in items))
    first = items[0].assumption
    words = f", {first.words.rstrip('.')}" if first.words.rstrip(".") else ""
    stated = "stated" if first.stated else "not stated"
    dropped = "it" if len(relations) == 1 else "the first"
    relation = relations[0] if len(relations) == 1 else lay.Enumeration(relations)
    if items[0].without is None:  # its lines say it
        return (relation, f"{words}.")
    failing = _fails(items[0].claimed) if several else ()
    behind = " " if failing else ", "
    numbers = said_at(items[0].without)
    return (relation, f"{words} ({stated}). Without {dropped}{behind}", *failing, *numbers, ".")


def _failing(finding: Finding) -> b.Rich:
    """Which equation it is that fails, if that has no number of the notes."""
    return () if finding.check.claimed.tag else _fails(finding.check.claimed)


def _fails(claimed: Equation | None) -> b.Rich:
    equation = None if claimed is None else layout(claimed, "printed")
    return () if equation is None or not in_words(equation, LONG) else (equation, " fails: ")


SHORT = 45.0
"""An equation of so many letters stands in a sentence."""


LONG = 60.0
"""And of so many where lines are as wide as the page."""


def in_words(equation: Node, most: float = SHORT) -> bool:
    """Whether an equation stands in a sentence: of fewer than `most` letters, without a matrix."""
    return width(equation) < most and not _has_grid(equation)


def _has_grid(node: Node) -> bool:
    return isinstance(node, lay.Grid) or any(_has_grid(part) for part in lay.parts(node))


def refuted(counterexample: Counterexample) -> tuple[b.Rich, b.Piece, b.Piece]:
    """Where two sides differ, "at a = 1, b = 2", in the order of the vocabulary; and the two."""
    ordered = sorted(counterexample.values.items(), key=lambda kv: (known(kv[0])[0], str(kv[0])))
    numbers = ((lay.Chain((layout(x), short_number(value)), ("=",)),) for x, value in ordered)
    at = ("at ", *b.listed(numbers)) if ordered else ()
    pair = counterexample.left, counterexample.right
    left, right = map(_real_number, pair)
    if left == right and pair[0] != pair[1]:
        left, right = (_real_number(side, 12) for side in pair)
    return at, left or "undefined", right or "undefined"


def sides(left: b.Piece, right: b.Piece, place: b.Rich = ()) -> b.Rich:
    """What two sides are, in words; of vectors and matrices in one `place`."""
    if left == right:
        return ("both sides are ", left)
    return (*place, " " * bool(place), "the left side is ", left, ", the right side ", right)


def place(counterexample: Counterexample) -> b.Rich:
    """Which entry of a vector or of a matrix differs.

    >>> one = sympy.Integer(1)
    >>> ["".join(place(Counterexample({}, one, -one, entry))) for entry in ((), (2,), (1, 3))]
    ['', 'in component 2', 'in row 1, column 3']
    """
    match counterexample.entry:
        case (row, column):
            return (f"in row {row}, column {column}",)
        case (component,):
            return (f"in component {component}",)
    return ()


def said_at(counterexample: Counterexample) -> b.Rich:
    """A counterexample in words: the numbers, then both sides there."""
    at, left, right = refuted(counterexample)
    words = sides(left, right, place(counterexample))
    return (*at, ": ", *words) if at else words


def _real_number(side: Expr, digits: int = 4) -> Node | None:
    """A side of a counterexample; None where it has no real value there."""
    if side is None or not sympy.sympify(side).evalf(12).is_real:
        return None
    return short_number(side, digits)


def short_number(number: Expr, digits: int = 4) -> Node:
    """An exact number where it is short, else so many digits of it.

    >>> third = sympy.Rational(3, 7)
    >>> text(short_number(third)), text(short_number(sympy.sin(third / 3 * 2)))
    ('3/7', '0.2818')
    """
    number = sympy.sympify(number)
    exact = layout(number)
    if width(exact) <= 6 and not number.has(sympy.Function):
        return exact
    value = float(number.evalf(15))
    node = lay.decimal(abs(value), max(digits, len(str(int(abs(value))))))
    return lay.negated(node) if value < 0 else node
