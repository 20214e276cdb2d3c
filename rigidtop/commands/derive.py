"""``rigidtop derive``: one equation or claim with every step, to read, to paste or to run."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from rigidtop.commands import claims
from rigidtop.commands.notation import add_notation, chosen
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.notation import Notation
    from rigidtop.proof.lecture import Lecture
    from rigidtop.proof.verdict import Judgement

ABOUT = "derive one equation or claim and show every step"
PROSE = ("text", "latex", "html", "typst")
SOURCES = ("python", "c", "fortran", "julia", "javascript", "octave")


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "name",
        nargs="+",
        help=f"an equation's number, such as 3.57, or a claim's name; {claims.FOLDER}",
    )
    parser.add_argument(
        "--format",
        choices=(*PROSE, *SOURCES),
        default="text",
        metavar="FORMAT",
        help=f"how to write it: {', '.join(PROSE)} (default: text), or a function that evaluates "
        f"its right-hand sides: {', '.join(SOURCES)}",
    )
    parser.add_argument(
        "--deep",
        action="store_true",
        help="start from the laws and definitions, not from the numbered equations above",
    )
    add_notation(parser)


def run(options: argparse.Namespace) -> int:
    """Judge the claim and print it; 0 if it passes."""
    from rigidtop.collection import opened

    with opened(options.name) as (collection, names):
        if len(names) != 1:
            raise RigidtopError(f"one claim at a time; `{collection.command('list')}` names them")
        return _run(collection, names[0], options)


def _run(collection: Collection, name: str, options: argparse.Namespace) -> int:
    from rigidtop.report.lecture import fragment

    notation = chosen(options)
    judgement, lecture = derived(collection, name)
    if options.format in SOURCES:
        return _source(options, judgement, notation)
    text = fragment(judgement, options.format, notation, options.deep)
    if options.json:
        way = record(judgement, lecture, notation, options.deep)
        print_json({**way, "format": options.format, "text": text})
    else:
        print(text)
    return 0 if judgement.passed else claims.FAILED


def derived(collection: Collection, name: str) -> tuple[Judgement, Lecture]:
    """A claim as it is judged, and the lecture that derives it."""
    chosen = claims.named(collection, [name])
    if len(chosen) != 1:
        names = " ".join(claim.name for _, claim in chosen)
        raise RigidtopError(f"{name} is a section; derive one of its claims: {names}")
    lecture = collection.lecture_with(collection.solved_by(claim for _, claim in chosen))
    [(_, judgement)] = claims.judged(chosen, collection.letters, lecture)
    return judgement, lecture


def record(
    judgement: Judgement, lecture: Lecture, notation: Notation, deep: bool = False
) -> dict[str, Any]:
    """A claim with each step that leads to it, as plain values."""
    from rigidtop.report import records
    from rigidtop.report.lines import way_record
    from rigidtop.report.wording import Wording

    about = records.record(Wording(notation).judgement(judgement))
    way, starts = way_record(lecture, judgement.claim.name, notation, deep)
    return {**about, "steps": way, "rests_on": starts}


def _source(options: argparse.Namespace, judgement: Judgement, notation: Notation) -> int:
    from rigidtop.codegen.languages import source
    from rigidtop.codegen.values import NothingToEvaluateError, rewritten, values
    from rigidtop.typeset.text import text

    try:
        program = source(rewritten(values(judgement), notation.written), options.format, text)
    except (NothingToEvaluateError, ValueError) as error:  # ValueError: no such function there
        raise RigidtopError(str(error)) from None
    if options.json:
        print_json(
            {
                "name": program.name,
                "language": program.language,
                "arguments": program.arguments,
                "returns": program.returns,
                "source": program.text,
            }
        )
    else:
        print(program.text, end="")
    return 0 if judgement.passed else claims.FAILED
