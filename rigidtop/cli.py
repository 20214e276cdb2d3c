"""The command line: ``rigidtop list | check | derive | lecture | simulate | certify | …``.

Results go to stdout, progress and errors to stderr.  Exit codes: 0 for success, 1 for a check that
failed, 2 for bad input.  Everything that takes time to load is loaded by the command that needs it.
"""

from __future__ import annotations

import argparse
import io
import json
import os
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, NoReturn

from rigidtop.commands import bench, certify, exercise, figure, simulate, sweep
from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.present.solutions import Solution
    from rigidtop.proof.page import Claim, Page
    from rigidtop.proof.verdict import Judgement

FAILED, BAD_INPUT, INTERRUPTED = 1, 2, 130
PROSE = ("text", "latex", "html", "typst")
SOURCES = ("python", "c", "fortran", "julia", "javascript", "octave")


class Parser(argparse.ArgumentParser):
    """Errors in one line, without the usage."""

    def error(self, message: str) -> NoReturn:
        self.exit(BAD_INPUT, f"{self.prog}: {message} (see {self.prog} --help)\n")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns its exit code."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        # A terminal that can't show θ gets an escape in its place, not an error.
        sys.stdout.reconfigure(errors="backslashreplace")
    options = _parser().parse_args(arguments)
    try:
        code = options.run(options)
        sys.stdout.flush()
        return int(code)
    except RigidtopError as error:
        print(f"rigidtop {options.command}: {error}", file=sys.stderr)
        return BAD_INPUT
    except BrokenPipeError:
        # The reader of our output has left, as `| head` does: nothing is wrong.
        sys.stderr.close()
        return 0
    except KeyboardInterrupt:
        print(f"\nrigidtop {options.command}: interrupted", file=sys.stderr)
        return INTERRUPTED
    except OSError as error:
        print(f"rigidtop {options.command}: {error.strerror or error}", file=sys.stderr)
        os.close(sys.stdout.fileno())  # what can't be written is not tried again at exit
        return BAD_INPUT


# --- What can be asked ---------------------------------------------------------------------------


def _parser() -> Parser:
    parser = Parser(
        prog="rigidtop",
        description="Rigid rotation and the spinning top: the lecture derived, judged, typeset "
        "and computed.",
    )
    parser.add_argument("--version", action=_Version)
    commands = parser.add_subparsers(dest="command", required=True, metavar="command")

    def command(name: str, run: Callable[[Any], int], about: str) -> argparse.ArgumentParser:
        sub = commands.add_parser(name, help=about, description=about[0].upper() + about[1:] + ".")
        sub.add_argument("--json", action="store_true", help="print JSON instead of text")
        sub.set_defaults(run=run)
        return sub

    command("list", _list, "list every claim of the lecture, by section")

    check = command("check", _check, "judge every claim and compare the numbers")
    check.add_argument(
        "name",
        nargs="*",
        help="only these claims or sections, such as 3.57, axis-stability or 3.5.4",
    )

    derive = command("derive", _derive, "derive one equation or claim and show every step")
    derive.add_argument("name", help="an equation's number, such as 3.57, or a claim's name")
    derive.add_argument(
        "--format",
        choices=(*PROSE, *SOURCES),
        default="text",
        help="how to write it (default: text); in a programming language, a function that "
        "evaluates its right-hand sides",
    )

    lecture = command(
        "lecture", _lecture, "write the lecture as LaTeX and HTML, with figures and exercises"
    )
    lecture.add_argument(
        "-o", "--output", default="out", metavar="DIR", help="the folder (default: out)"
    )
    lecture.add_argument(
        "--pdf", action="store_true", help="also a PDF, by latexmk or by the extra 'pdf'"
    )
    lecture.add_argument(
        "--student", action="store_true", help="leave the solutions of the exercises out"
    )

    for name, module in (
        ("exercise", exercise),
        ("simulate", simulate),
        ("certify", certify),
        ("sweep", sweep),
        ("figure", figure),
        ("bench", bench),
    ):
        module.add_options(command(name, module.run, module.ABOUT))
    return parser


class _Version(argparse.Action):
    """Looks the version up only when asked."""

    def __init__(self, option_strings: Sequence[str], dest: str, **_: Any) -> None:
        super().__init__(option_strings, dest, nargs=0, help="show the version and exit")

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> NoReturn:
        import rigidtop

        print(f"rigidtop {rigidtop.__version__}")
        parser.exit()


# --- Claims --------------------------------------------------------------------------------------


def _claims() -> list[tuple[Page, Claim]]:
    from rigidtop.derivations import PAGES

    return [(page, claim) for page in PAGES for claim in page.claims]


def _named(names: Sequence[str]) -> list[tuple[Page, Claim]]:
    """The claims of these names, in reading order; (3.57) is 3.57."""
    claims = _claims()
    known = [claim.name for _, claim in claims]
    if not set(names) <= {*known, *(page.section for page, _ in claims)}:
        claims += _of_exercises(claims)
        known = [claim.name for _, claim in claims]
    for page, claim in claims:
        if page.section in names:  # a section stands for its claims
            names = [*names, claim.name]
    sections = {page.section for page, _ in claims}
    wanted = {name.strip("()") for name in names if name not in sections or name in known}
    for name in sorted(wanted - set(known)):
        from difflib import get_close_matches

        near = get_close_matches(name, known, n=3, cutoff=0.5)
        hint = f"did you mean {' or '.join(near)}?" if near else "`rigidtop list` names them all"
        raise RigidtopError(f"no equation or claim {name!r}; {hint}")
    return [(page, claim) for page, claim in claims if claim.name in wanted]


def _of_exercises(claims: Sequence[tuple[Page, Claim]]) -> list[tuple[Page, Claim]]:
    """The claims that only exercises make, each with the page of its section."""
    from rigidtop.derivations.exercises import EXERCISES

    pages = {page.section: page for page, _ in claims}
    made = {claim.name for _, claim in claims}
    return [
        (pages[exercise.section], claim)
        for exercise in EXERCISES
        for claim in exercise.claims
        if claim.name not in made
    ]


def _judged(claims: Sequence[tuple[Page, Claim]]) -> Iterator[tuple[Page, Judgement]]:
    from rigidtop.proof.verdict import judge

    with Progress("judging", len(claims)) as progress:
        for page, claim in claims:
            progress.show(claim.name)
            yield page, judge(claim, page.section)


class Progress:
    """A line on stderr that says where a long command is, once it has run for a second."""

    def __init__(self, doing: str, total: int) -> None:
        self.doing, self.total, self.done = doing, total, 0
        self.start = self.last = time.monotonic()

    def __enter__(self) -> Progress:
        return self

    def show(self, what: str) -> None:
        """About to do `what`."""
        now = time.monotonic()
        live = sys.stderr.isatty()
        if now - self.start > 1 and (live or now - self.last > 2):
            end = "" if live else "\n"
            line = f"{self.doing} {self.done + 1}/{self.total}: {what}"
            print(f"\r\033[K{line}" if live else line, end=end, file=sys.stderr, flush=True)
            self.last = now
        self.done += 1

    def __exit__(self, *_: object) -> None:
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def _list(options: argparse.Namespace) -> int:
    from rigidtop.present.records import claim_record
    from rigidtop.present.table import table

    claims = _claims()
    if options.json:
        return _print_json([claim_record(claim, page.section) for page, claim in claims])
    rows = [[page.section, claim.name, claim.says] for page, claim in claims]
    print(table(rows, ("section", "claim", "what the notes assert")))
    return 0


def _check(options: argparse.Namespace) -> int:
    from rigidtop.present.records import measures, record
    from rigidtop.present.table import table, wants_color

    claims = _named(options.name) if options.name else _claims()
    judgements = [judgement for _, judgement in _judged(claims)]
    passed = all(judgement.passed for judgement in judgements)
    records = [record(judgement) for judgement in judgements]
    if options.json:
        _print_json(records)
        return 0 if passed else FAILED
    colors = VERDICT_COLORS if wants_color(sys.stdout) else None
    rows = [[r["reference"], r["name"], r["verdict"], r["note"]] for r in records]
    print(table(rows, ("section", "claim", "verdict", "note"), colors=colors))
    measured = measures(judgements)
    if measured:
        numbers = [
            [f"{m.error:.1e}", f"{m.tolerance:.1e}", "ok" if m.passed else "FAILED", m.what]
            for m in measured
        ]
        print()
        print(table(numbers, ("error", "tolerance", "", "compared with a computed motion")))
    print()
    print(_summary(judgements))
    return 0 if passed else FAILED


VERDICT_COLORS = {
    "proved": "green",
    "assuming": "yellow",
    "convention": "magenta",
    "false": "red",
    "undecided": "red",
    "sampled": "blue",
    "definition": "dim",
}


def _summary(judgements: Sequence[Judgement]) -> str:
    """Counts of the verdicts, and what did not pass."""
    from rigidtop.proof.verdict import Verdict

    counts = [(verdict.value, sum(j.verdict is verdict for j in judgements)) for verdict in Verdict]
    shown = ", ".join(f"{count} {name}" for name, count in counts if count)
    failed = [j.claim.name for j in judgements if not j.passed]
    last = (
        f"NOT PASSED: {', '.join(failed)}" if failed else "nothing failed that the notes get right"
    )
    return f"{len(judgements)} claim{'s' * (len(judgements) != 1)}: {shown}; {last}"


def _derive(options: argparse.Namespace) -> int:
    from rigidtop.present.lecture import fragment
    from rigidtop.present.records import record

    found = _named([options.name])
    if len(found) != 1:
        names = " ".join(claim.name for _, claim in found)
        raise RigidtopError(f"{options.name} is a section; derive one of its claims: {names}")
    [(_, judgement)] = _judged(found)
    if options.format in SOURCES:
        return _derive_source(options, judgement)
    text = fragment(judgement, options.format)
    if options.json:
        _print_json({**record(judgement), "format": options.format, "text": text})
    else:
        print(text)
    return 0 if judgement.passed else FAILED


def _derive_source(options: argparse.Namespace, judgement: Judgement) -> int:
    from rigidtop.codegen.languages import source
    from rigidtop.codegen.values import NothingToEvaluateError, values
    from rigidtop.present.text import text

    try:
        made = source(values(judgement), options.format, text)
    except NothingToEvaluateError as error:
        raise RigidtopError(str(error)) from None
    if options.json:
        _print_json(
            {
                "name": made.name,
                "language": made.language,
                "arguments": made.arguments,
                "returns": made.returns,
                "source": made.text,
            }
        )
    else:
        print(made.text, end="")
    return 0 if judgement.passed else FAILED


def _lecture(options: argparse.Namespace) -> int:
    from rigidtop.present.files import check_folder
    from rigidtop.present.lecture import write_lecture

    if not options.output:
        raise RigidtopError("--output wants the name of a folder")
    check_folder(options.output)  # before half a minute of work, not after it
    judged: list[tuple[Page, list[Judgement]]] = []
    for page, judgement in _judged(_claims()):
        if not judged or judged[-1][0] is not page:
            judged.append((page, []))
        judged[-1][1].append(judgement)
    judgements = [judgement for _, section in judged for judgement in section]
    solutions = _solutions(judgements)
    with Progress("writing", 1) as progress:
        progress.start -= 1
        progress.show("lecture.tex, lecture.html" + (", lecture.pdf" if options.pdf else ""))
        files = write_lecture(
            judged, solutions, options.output, pdf=options.pdf, student=options.student
        )
    unsolved = [solution.exercise.name for solution in solutions if not solution.passed]
    passed = all(judgement.passed for judgement in judgements) and not unsolved
    if options.json:
        _print_json({"files": [str(file) for file in files], "passed": passed})
    else:
        for file in files:
            print(file)
        print(_summary(judgements))
        confirmed = (
            f"NOT CONFIRMED: {', '.join(unsolved)}" if unsolved else "every number confirmed"
        )
        print(f"{len(solutions)} exercises solved; {confirmed}")
    return 0 if passed else FAILED


def _solutions(judgements: Sequence[Judgement]) -> list[Solution]:
    """Every exercise, solved; claims that were judged already are not judged again."""
    from rigidtop.derivations.exercises import EXERCISES
    from rigidtop.present.solutions import solved

    known = {judgement.claim.name: judgement for judgement in judgements}
    solutions = []
    with Progress("solving", len(EXERCISES)) as progress:
        for each in EXERCISES:
            progress.show(each.name)
            solutions.append(solved(each, judged=known))
    return solutions


def _print_json(value: Any) -> int:
    print(json.dumps(value, ensure_ascii=False, indent=1, allow_nan=False))
    return 0


if __name__ == "__main__":
    sys.exit(main())
