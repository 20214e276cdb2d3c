"""``rigidtop lecture``: the whole lecture as files, with figures and exercises."""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rigidtop.commands import claims
from rigidtop.commands.look import add_look, front_of, look_of, points_of
from rigidtop.commands.notation import add_notation, chosen
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError
from rigidtop.terminal.progress import over

if TYPE_CHECKING:
    from rigidtop.collection import Collection

ABOUT = "write the lecture as LaTeX and HTML, with figures and exercises"


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument("folder", nargs="?", help="a collection of one's own, such as my_course/")
    parser.add_argument(
        "-o", "--output", default="out", metavar="DIR", help="the folder (default: out)"
    )
    parser.add_argument(
        "--pdf", action="store_true", help="also a PDF, by latexmk or by the extra 'pdf'"
    )
    parser.add_argument(
        "--student", action="store_true", help="leave the solutions of the exercises out"
    )
    parser.add_argument(
        "--record",
        action="store_true",
        help="the record of every verdict instead: assumptions, counterexamples, measures",
    )
    parser.add_argument(
        "--slides",
        action="store_true",
        help="also slides.html for the projector, without boxes and solutions: arrow keys",
    )
    parser.add_argument(
        "--solutions", action="store_true", help="with --slides: also the exercises, solved"
    )
    parser.add_argument(
        "--fragment",
        action="store_true",
        help="also chapters/*.tex and rigidtop.sty, to be read into a document of your own",
    )
    parser.add_argument(
        "--format", choices=["myst"], help="also the pages as a MyST project, for a course site"
    )
    parser.add_argument(
        "--live",
        action=argparse.BooleanOptionalAction,
        help="figures of motions can be played in the HTML (default: where the extra 'web' is "
        "installed)",
    )
    add_look(parser)
    add_notation(parser)


def run(options: argparse.Namespace) -> int:
    """Judge, solve and write; 0 if every claim passes and every number is confirmed."""
    claims.prepare()
    from rigidtop.collection import opened

    if not options.output:
        raise RigidtopError("--output wants the name of a folder")
    # A slash says that it is a folder, whatever else it is not.
    words = [] if options.folder is None else [f"{options.folder}/"]
    with opened(words) as (collection, _):
        return _run(collection, options)


def _listed(files: Sequence[Path], folder: str) -> str:
    """What was written, files of folders counted.

    >>> _listed([Path("out/lecture.tex"), Path("out/figures/a.pdf")], "out")
    'out: lecture.tex, figures (1 file)'
    """
    tops = Counter(file.relative_to(folder).parts[0] for file in files)
    names = (
        name if Path(folder, name) in files else f"{name} ({count} file{'s' * (count != 1)})"
        for name, count in tops.items()
    )
    return f"{folder}: {', '.join(sorted(names, key=lambda name: '(' in name))}"


def playable(wished: bool | None) -> bool:
    """Whether figures can be played: as it is wished, else where what plays them is installed.

    Raises RigidtopError where it is wished and not installed, before half a minute of work.
    """
    from rigidtop.web.page import three

    if wished is False:
        return False
    try:
        three()
    except RigidtopError:
        if wished:
            raise
        return False
    return True


def _run(collection: Collection, options: argparse.Namespace) -> int:
    from rigidtop.report.lecture import Edition, Wanted, write_lecture
    from rigidtop.report.solutions import solved
    from rigidtop.terminal.files import check_folder
    from rigidtop.terminal.table import paragraph
    from rigidtop.web.player import player

    if options.record and (options.slides or options.fragment or options.format or options.live):
        raise RigidtopError(
            "--record is the record alone: leave --slides, --fragment, --format, --live out"
        )
    live = not options.record and playable(options.live)
    notation, look = chosen(options), look_of(options)
    front, points = front_of(options, collection.front), points_of(options)
    check_folder(options.output)  # before half a minute of work, not after it
    lines = collection.lecture_with(collection.exercises)
    every = claims.every(collection)
    pairs = [*claims.judged(every, collection.letters, lines)]
    judgements = [judgement for _, judgement in pairs]
    # A page without claims is read like any other.
    judged = [(page, [j for home, j in pairs if home is page]) for page in collection.pages]
    by_name = {judgement.claim.name: judgement for judgement in judgements}
    solutions = [
        solved(each, judged=by_name, lines=lines) for each in over("solving", collection.exercises)
    ]
    files = write_lecture(
        judged,
        solutions,
        options.output,
        Edition(
            options.student,
            front,
            collection.figures,
            # Pages of one's own need not be about Euler angles.
            notation if collection.folder is None or notation.images else None,
            lines,
            points,
            look,
        ),
        Wanted(
            options.pdf,
            options.slides,
            options.solutions,
            options.fragment,
            options.format == "myst",
            player if live else None,
        ),
        options.record,
    )
    unsolved = [solution.exercise.name for solution in solutions if not solution.passed]
    amiss = [*claims.faults(lines), *claims.gaps(lines)]
    passed = all(judgement.passed for judgement in judgements) and not (unsolved or amiss)
    if options.json:
        print_json({"files": [str(file) for file in files], "passed": passed})
    else:
        print(paragraph(_listed(files, options.output)))
        outcome = f"NOT CONFIRMED: {', '.join(unsolved)}" if unsolved else "every number confirmed"
        solved_all = f"{claims.counted(len(solutions), 'exercise')} solved; {outcome}"
        missing = f"{claims.counted(len(unsolved), 'exercise')} not confirmed" if unsolved else ""
        summary = claims.summary(judgements, lines, more=missing)
        for each in (solved_all, *amiss, summary):
            print(paragraph(each))
    return 0 if passed else claims.FAILED
