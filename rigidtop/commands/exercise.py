"""``rigidtop exercise``: what the notes leave to their reader, solved for any settings."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING

from rigidtop.commands.claims import FAILED, FOLDER
from rigidtop.commands.look import add_look, front_of, look_of, points_of
from rigidtop.commands.notation import add_notation
from rigidtop.commands.notation import chosen as chosen_notation
from rigidtop.commands.output import print_json
from rigidtop.commands.settings import add_settings, apart
from rigidtop.errors import RigidtopError
from rigidtop.terminal.progress import over

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.notation import Notation
    from rigidtop.proof.exercise import Exercise
    from rigidtop.report.solutions import Solution

ABOUT = "solve the exercises that the notes leave to their reader, in symbols and in numbers"

EPILOG = """\
Without a name the exercises are listed.  Angles are radians, or degrees with the suffix
deg; rates are rad/s, or turns a minute with the suffix rpm.

examples:
  rigidtop exercise toppling-top --set theta=30deg
  rigidtop exercise toppling-top --student
  rigidtop exercise --sheet out --student --pdf   # all, without solutions
  rigidtop exercise fast-spin-roots --format nbgrader --points 6 --sheet out"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument("name", nargs="*", help=f"an exercise, such as toppling-top; {FOLDER}")
    add_settings(parser, "change its settings, such as theta=30deg")
    parser.add_argument(
        "--student", action="store_true", help="the question alone, without its solution"
    )
    parser.add_argument(
        "--sheet", metavar="DIR", help="write exercises.tex, exercises.html and figures there"
    )
    parser.add_argument("--pdf", action="store_true", help="with --sheet, also a PDF")
    parser.add_argument(
        "--format",
        choices=("nbgrader", "otter", "moodle"),
        help="with --sheet DIR: write there a notebook with points for nbgrader or Otter, or "
        "questions for Moodle, instead",
    )
    add_look(parser)
    add_notation(parser)


def run(options: argparse.Namespace) -> int:
    """Solve, print or write; 0 if every claim holds and every number is confirmed."""
    if options.pdf and not options.sheet:
        raise RigidtopError("--pdf goes with --sheet DIR")
    if options.points is not None and not options.sheet:
        raise RigidtopError("--points goes with --sheet DIR")
    if options.format and (not options.sheet or options.pdf or options.json):
        raise RigidtopError(
            f"--format {options.format} goes with --sheet DIR, and without --pdf and --json"
        )
    if options.json and options.student:
        raise RigidtopError("--json gives the solutions: leave --student out")
    from rigidtop.collection import is_folder, opened

    if all(map(is_folder, options.name)):  # no exercise before --set: is it behind?
        options.set, more = apart(options.set)
        options.name += more
    with opened(options.name) as (collection, names):
        return _run(collection, names, options)


def _run(collection: Collection, names: Sequence[str], options: argparse.Namespace) -> int:
    notation = chosen_notation(options)
    if options.set and len(names) != 1:
        raise RigidtopError("--set wants one exercise: rigidtop exercise NAME --set name=value")
    if not names and not options.sheet:
        return _list(collection, options.json)
    if options.format:
        return _graded(collection, names, options)
    if options.student:
        return _questions(collection, names, options, notation)
    from rigidtop.report.solutions import solved

    exercises = chosen(collection, names)
    lines = collection.lecture_with(exercises)
    solutions = [solved(each, options.set, lines=lines) for each in over("solving", exercises)]
    if options.sheet:
        _write(collection, solutions, options, notation if notation.images else None)
    elif options.json:
        from rigidtop.report.lecture import solution_in
        from rigidtop.report.solutions import record

        records = [record(solution_in(notation, solution)) for solution in solutions]
        print_json(records[0] if len(records) == 1 else records)
    else:
        from rigidtop.report.lecture import exercise_fragment

        print("\n\n".join(exercise_fragment(each, notation) for each in solutions), end="")
    return 0 if all(solution.passed for solution in solutions) else FAILED


def _graded(collection: Collection, names: Sequence[str], options: argparse.Namespace) -> int:
    """Write the exercises for a program that collects points."""
    from rigidtop.commands.graders import asked, write

    points_of(options)  # which says what is wrong with them
    exercises = asked(collection, chosen(collection, names), options.set, options.points)
    print("\n".join(map(str, write(exercises, options.format, options.sheet))))
    return 0


def chosen(collection: Collection, names: Sequence[str]) -> list[Exercise]:
    """The exercises of these names, or all of them; RigidtopError with near names for another."""
    by_name = {exercise.name: exercise for exercise in collection.exercises}
    for name in names:
        if name not in by_name:
            from difflib import get_close_matches

            near = get_close_matches(name, by_name, n=3, cutoff=0.5)
            listing = f"`{collection.command('exercise')}` lists all"
            hint = f"did you mean {' or '.join(near)}?" if near else listing
            raise RigidtopError(f"no exercise {name!r}; {hint}")
    return [by_name[name] for name in names] if names else list(collection.exercises)


def _questions(
    collection: Collection, names: Sequence[str], options: argparse.Namespace, notation: Notation
) -> int:
    from rigidtop.parameters import settings
    from rigidtop.report.plain import fragment
    from rigidtop.report.solutions import Solution, question
    from rigidtop.report.wording import Wording

    exercises = chosen(collection, names)
    asked = [(each, settings(each.parameters, options.set)) for each in exercises]
    if options.sheet:
        # A sheet of questions needs nothing solved.
        unsolved = [Solution(exercise, values, (), (), 0.0) for exercise, values in asked]
        _write(collection, unsolved, options, notation if notation.images else None)
    else:
        named = not notation.images
        questions = [question(Wording(notation).of(x), values, named=named) for x, values in asked]
        print("\n\n".join(map(fragment, questions)), end="")
    return 0


def _write(
    collection: Collection,
    solutions: Sequence[Solution],
    options: argparse.Namespace,
    notation: Notation | None,
) -> None:
    from rigidtop.report.lecture import Edition, Wanted, write_sheet
    from rigidtop.terminal.files import check_folder

    look, front, points = look_of(options), front_of(options, collection.front), points_of(options)
    check_folder(options.sheet)
    lines = collection.lecture_with([each.exercise for each in solutions])
    edition = Edition(
        options.student, front, notation=notation, lines=lines, points=points, look=look
    )
    files = write_sheet(solutions, options.sheet, edition, Wanted(options.pdf))
    if options.json:
        passed = all(solution.passed for solution in solutions)
        print_json({"files": [str(file) for file in files], "passed": passed})
    else:
        print("\n".join(map(str, files)))


def _list(collection: Collection, as_json: bool) -> int:
    if as_json:
        from rigidtop.report.solutions import listed

        print_json([listed(exercise) for exercise in collection.exercises])
        return 0
    from rigidtop.terminal.table import table
    from rigidtop.typeset.words import unmarked

    rows = [
        [each.section, each.name, unmarked(f"{each.title} ({each.asks})")]
        for each in collection.exercises
    ]
    print(table(rows, ("section", "exercise", "what it is about")))
    return 0
