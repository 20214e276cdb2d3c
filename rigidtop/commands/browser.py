"""What the page "Check my derivation" is answered: a text judged where Python runs in a browser.

The page keeps the limit of time there, since nothing else can stop Python in a browser
(`rigidtop.terminal.limit`): it is told of each statement before that is judged, ends the worker
that takes too long with one, and asks a new one to leave that open.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Collection, Iterator, Sequence
from html import escape
from pathlib import Path

from rigidtop.collection import built_in
from rigidtop.commands.audit import MOST_AGAINST
from rigidtop.commands.draft import Audit, Draft, TextRemark, well_formed
from rigidtop.commands.findings import AuditFinding, FilePlace, summary
from rigidtop.errors import RigidtopError
from rigidtop.judge.text import Asked, Reading
from rigidtop.report.annotated import note_html, verdict_badge
from rigidtop.report.transcript import transcript
from rigidtop.terminal.visible import visible

SECONDS = 30
"""So long a statement is judged in a browser, where Python takes about three times its time (s)."""

Tell = Callable[[int, int, int, int], object]
"""Is told before a statement is judged: its number, its line, the how manyth it is, and of how
many."""

NOTHING = (
    "There are no formulas between dollars, or the like, that say something: "
    "nothing could be compared."
)


class Desk:
    """Where a text is judged again and again; what stands above a change is not judged anew."""

    def __init__(self) -> None:
        self.draft = Draft(Path("text.md"))

    def answer(self, text: str, left: Sequence[int], tell: Tell) -> str:
        """What became of a text as JSON, but for the statements of these numbers, left open.

        `summary` is the one of ``rigidtop audit``, `outcomes` are the rows of its ``--json``;
        `wrong` and `lines` are HTML, what is wrong and what became of each formula; `isWrong` says
        whether anything is.  A text that cannot be audited has an `error` alone.
        """
        try:
            audit = self._audit(well_formed(text), frozenset(left), tell)
        except RigidtopError as error:
            return json.dumps({"error": visible(str(error))})
        if audit.notes is None:
            return json.dumps({"error": NOTHING})
        findings = audit.notes.findings
        parts = {
            "summary": visible(summary(findings)),
            "isWrong": audit.notes.is_wrong,
            "outcomes": [each.record for each in findings],
            "wrong": "".join(_wrong(each, audit) for each in findings if each.is_wrong),
            "lines": "".join(_line(each, audit) for each in _in_order(findings)),
        }
        return json.dumps(parts)

    def _audit(self, text: str, left: Collection[int], tell: Tell) -> Audit:
        def refusal(asked: Asked, read: Reading) -> str:
            if asked.number in left:
                return f"judging it takes longer than {SECONDS} s"
            tell(asked.number, asked.line, read.asked.index(asked) + 1, len(read.asked))
            return ""

        is_tex = re.search(r"\\(?:documentclass|begin\s*\{document\})", text) is not None
        self.draft.path = Path("text.tex" if is_tex else "text.md")
        return self.draft.audit_but(text, built_in(), refusal)


def _in_order(findings: Sequence[AuditFinding]) -> list[AuditFinding]:
    """The findings that have a place, ordered by their lines."""
    placed = [(each.place.line, each) for each in findings if each.place is not None]
    return [each for _, each in sorted(placed, key=lambda pair: pair[0])]


def _wrong(each: AuditFinding, audit: Audit) -> str:
    """What is wrong: as it is written, as it has to be, what it contradicts."""
    remarks = [x for x in audit.remarks if x.finding is each]
    right = "".join(_formula(x.repair, audit) for x in remarks if x.repair)
    right = right or escape(visible(each.right))
    against = "".join(
        f"<li>{_link(place.line, str(place))} {_at(place, formula, audit)}</li>"
        for place, formula in each.against[-MOST_AGAINST:]
    )
    parts = [
        f'<p class="why">{note_html(each.note)}</p>',
        f'<div class="right"><span class="label">right</span> {right}</div>' * bool(right),
        f'<p class="label">against</p><ul class="against">{against}</ul>' * bool(against),
    ]
    return f'<li class="audited amiss">{_shown(each, remarks, audit)}{"".join(parts)}</li>'


def _line(each: AuditFinding, audit: Audit) -> str:
    """What became of a formula, with what it follows from."""
    remarks = [x for x in audit.remarks if x.finding is each]
    words = f'<p class="why">{note_html(each.words)}</p>' if each.words else ""
    amiss = " amiss" if each.is_wrong else ""
    return f'<li class="audited{amiss}">{_shown(each, remarks, audit)}{words}</li>'


def _shown(each: AuditFinding, remarks: Sequence[TextRemark], audit: Audit) -> str:
    """A formula with its place and its verdict."""
    formulas = "".join(_formulas(each, remarks, audit))
    place = _link(each.place.line if each.place is not None else 0, each.title)
    side = f'<div class="side">{place}{verdict_badge(each.verdict)}</div>'
    return f'<div class="eq">{formulas}</div>{side}'


def _formulas(each: AuditFinding, remarks: Sequence[TextRemark], audit: Audit) -> Iterator[str]:
    for remark in remarks:
        if each.rows:  # else the whole line, of which nothing was read
            yield f"<div>{_formula(audit.text[remark.start : remark.end], audit)}</div>"


def _formula(source: str, audit: Audit) -> str:
    """A formula of the text as MathML, sign by sign; as it is written where it can't be set."""
    macros = audit.notes.macros if audit.notes is not None else {}
    tex = re.sub(r"(?<!\\)&", "", source).strip()
    return transcript(tex, macros, True) or f"<code>{escape(visible(source.strip()))}</code>"


def _at(place: FilePlace, formula: str, audit: Audit) -> str:
    """The formula of a place as it stands in the text, or else in plain characters."""
    for x in audit.remarks:
        if x.finding.place == place and x.finding.written == formula:
            return _formula(audit.text[x.start : x.end], audit)
    return escape(visible(formula))


def _link(line: int, words: str) -> str:
    """What leads to a line of the text."""
    return f'<button type="button" class="place" data-line="{line}">{escape(words)}</button>'
