"""``rigidtop mark``: a derivation in several lines, and the first that does not follow."""

from __future__ import annotations

import argparse
import gc
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from rigidtop.commands.claims import FAILED
from rigidtop.commands.motions import number
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError
from rigidtop.terminal.files import LONGEST, text_of

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.mark.marking import Marking
    from rigidtop.mark.task import Subject

    Judge = Callable[[str], tuple[str, str, Marking]]

ABOUT = "mark a derivation: the first line that does not follow, and the slip"

EPILOG = """\
FILE is LaTeX, or Markdown with dollars; every formula in it is a line of the answer.
A line follows if it holds for every motion that the lecture allows between the two
equations, in whatever form and order.  It is judged by its truth for these, not by
the line before; where nothing of the way is shown, that is said.  N is the number of
an equation, or the name of a claim, such as two-roots.  With --given the answer
starts from what another file states, such as a Lagrangian of one's own.  The exit
code is 0 only if every line follows and the last equation is reached; a line that is
wrong, unread or inconclusive gives 1.  For a folder it is 0 if each answer could be
marked.

examples:
  rigidtop mark answer.tex --from 3.53 --to 3.57
  rigidtop mark answers/ --exercise fast-spin-roots -o marked/
  rigidtop mark answer.tex --given own.tex --to 'm\\ddot x = -kx'"""

COLORS = {
    "follows": "green",
    "definition": "dim",
    "assumption": "yellow",
    "wrong": "red",
    "carried": "red",
    "inconclusive": "magenta",
    "unread": "magenta",
}


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "file",
        nargs="+",
        metavar="FILE",
        help="the answer; - reads it from standard input; a folder of answers becomes a table of "
        "marks (CSV); before it a folder with a collection of one's own, if they are to be marked "
        "by that",
    )
    parser.add_argument("--from", dest="start", metavar="N", help="the equation to start from")
    parser.add_argument(
        "--to",
        dest="goal",
        metavar="N",
        help="the equation to arrive at; with --given a formula in TeX",
    )
    parser.add_argument(
        "--given",
        metavar="FILE",
        help="in place of --from: a file with what the answer may use, in formulas",
    )
    parser.add_argument(
        "--exercise",
        metavar="NAME",
        help="in place of both: the derivation that an exercise asks for, or its numbers, a line "
        "each, such as time_to_fall = 1.55 s",
    )
    parser.add_argument(
        "--set",
        dest="settings",
        nargs="+",
        default=(),
        metavar="NAME=VALUE",
        help="settings of the exercise, such as theta=30deg",
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="PATH",
        help="write the answer with its marks as a page; of a folder of answers a page for each, "
        "and index.html with all marks and the commonest slips, into the folder PATH",
    )
    parser.add_argument(
        "--seconds", type=number, default=20.0, help="time for a line (default: %(default)g)"
    )


def run(options: argparse.Namespace) -> int:
    """Mark and print; 0 if every line follows and the derivation arrives."""
    gc.set_threshold(500_000, 10, 1000)  # expressions live on: to walk them again finds no cycle
    from rigidtop.collection import is_collection

    start = options.start if options.given is None else options.given
    both = options.start is not None and options.given is not None
    if both or (options.exercise is None) == (None in (start, options.goal)):
        raise RigidtopError("say --from N --to N, --given FILE --to TEX, or --exercise NAME")
    if options.exercise is None and options.settings:
        raise RigidtopError("--set: only an exercise has settings")
    if not 0 < options.seconds <= 3600:
        raise RigidtopError(f"--seconds must be between 0 and 3600, not {options.seconds:g}")
    *folders, file = options.file
    output = Path(options.output) if options.output else None
    if len(folders) > 1:
        raise RigidtopError(f"one answer at a time: {len(options.file)} names are too many")
    if is_collection(Path(file)):
        raise RigidtopError(f"{file} is a collection, no answer: the answer stands behind it")
    if folders and options.given is not None:
        raise RigidtopError("--given: a file stands for the collection; leave one of them out")
    from rigidtop.collection import opened

    with opened([f"{folder}/" for folder in folders]) as (collection, _):
        # What is wrong with a collection, or with what is asked for, is told once, and first.
        subject = subject_of(collection) if folders else None
        judge = _judge(options, collection, subject)
        if file != "-" and Path(file).is_dir():
            from rigidtop.commands.classroom import write_class

            def marked(name: str, source: str) -> Marking:
                return _with_lines(name, judge(source))[-1]

            return 0 if write_class(Path(file), marked, output) else FAILED
        return _one(file, options, judge)


def _one(file: str, options: argparse.Namespace, judge: Judge) -> int:
    """Mark one answer and print the result; returns the exit code."""
    source = _typed() if file == "-" else text_of(file)
    start, goal, marking = _with_lines(file, judge(source))
    if options.output:
        from rigidtop.commands.annotation import marked_page
        from rigidtop.terminal.files import write_whole

        page = Path(options.output)
        if page.exists() and Path(file).exists() and page.samefile(file):
            raise RigidtopError(f"{page} is the answer that is marked: write the page elsewhere")
        write_whole(page, marked_page(Path(file).name, source, marking).encode())
    if options.json:
        print_json({"from": start, "to": goal, **marking.record})
    else:
        _print(marking)
    return 0 if marking.passed else FAILED


def _with_lines(name: str, marked: tuple[str, str, Marking]) -> tuple[str, str, Marking]:
    """The marks of the answer of that name, if there is anything that has been marked."""
    if not marked[-1].lines:
        raise RigidtopError(f"no formula in {name}: put each between $$ and $$")
    return marked


def subject_of(collection: Collection) -> Subject:
    """A collection, each of its models a family of its own; the built-in one is the top."""
    from rigidtop.mark.task import Subject, top

    if collection.folder is None:
        return top()
    families = tuple((model,) for model in collection.models)
    return Subject(collection.lecture, families, collection.notation)


def _judge(options: argparse.Namespace, collection: Collection, subject: Subject | None) -> Judge:
    """What marks an answer and says the ends of the derivation, if it is one.

    Raises RigidtopError if what the answers are about is not there.
    """
    from rigidtop.mark.answer import mark
    from rigidtop.mark.task import task, task_of

    limits = options.seconds, 6 * options.seconds
    if options.exercise is not None:
        from rigidtop.mark.exercise import answered, named
        from rigidtop.parameters import settings

        name, chosen = options.exercise, options.settings
        settings(named(name, collection.exercises).parameters, chosen)
        return lambda source: answered(name, source, chosen, *limits, collection.exercises, subject)
    if options.given is not None:
        start, asked = options.given, task_of(text_of(options.given), options.goal)
    else:
        start, asked = options.start, task(options.start, options.goal, subject)
    return lambda source: (start, options.goal, mark(source, asked, *limits))


def _print(marking: Marking) -> None:
    from rigidtop.terminal.table import paragraph, table, wants_color

    rows = [[str(line.line or ""), line.mark.value, line.said] for line in marking.lines]
    colors = COLORS if wants_color(sys.stdout) else None
    print(table(rows, ("line", "verdict", "what was read"), colors=colors))
    print()
    for line in marking.lines:
        if line.note and line.mark.value != "definition":
            print(paragraph(f"line {line.line}: {line.note}", rest="  "))
    print(paragraph(marking.summary))
    for lost in marking.lost:
        print(paragraph(f"{lost}: state the condition, or look at that motion on its own"))


def _typed() -> str:
    """The text that comes in by standard input."""
    try:
        text = sys.stdin.read(LONGEST + 1)
    except UnicodeDecodeError:
        raise RigidtopError("cannot read standard input: it is not text in UTF-8") from None
    if len(text) > LONGEST:
        raise RigidtopError(f"cannot read standard input: it has more than {LONGEST} characters")
    return text
