"""``rigidtop check``: every claim judged, every number compared."""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rigidtop.commands import claims
from rigidtop.commands.beside import judged_beside
from rigidtop.commands.notation import add_notation, chosen
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError
from rigidtop.terminal.progress import over

if TYPE_CHECKING:
    from sympy import Expr

    from rigidtop import collection as collections
    from rigidtop.notation import Notation
    from rigidtop.proof.lecture import Lecture, Text, Trial
    from rigidtop.proof.model import Model
    from rigidtop.proof.page import Claim, Page
    from rigidtop.proof.verdict import Judgement

ABOUT = "judge every claim and compare the numbers"

VERDICT_COLORS = {
    "proved": "green",
    "assuming": "yellow",
    "convention": "magenta",
    "false": "red",
    "undecided": "red",
    "sampled": "blue",
    "definition": "dim",
}
LINE_COLORS = {
    "follows": "green",
    "definition": "dim",
    "premise": "dim",
    "gap": "red",
    "unread": "red",
    "fault": "red",
}


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "name",
        nargs="*",
        help="only these claims or sections, such as 3.57, axis-stability, 3.5.4 or 3.5, which is "
        f"all of 3.5.1 to 3.5.4; {claims.FOLDER}; or one page, such as my_page.md, that is written "
        "in the letters of the lecture and may cite it",
    )
    parser.add_argument(
        "--lines",
        action="store_true",
        help="the verdict on every line of every page, not on claims; with --json also whether it "
        "is true in worlds, wherever all is true that it rests on",
    )
    depth = parser.add_mutually_exclusive_group()
    depth.add_argument(
        "--quick", action="store_true", help="do not make the moves of the derivations"
    )
    depth.add_argument(
        "--thorough",
        action="store_true",
        help="besides, drop each line's premises one by one, and change it in ten ways or more: "
        "all have to fall; and confirm what was found to be zero by another arithmetic",
    )
    add_notation(parser)


def run(options: argparse.Namespace) -> int:
    """Judge and print; 0 if nothing failed that the notes get right."""
    claims.prepare()
    from rigidtop.collection import built_in, opened

    notation = chosen(options)
    if options.name and (page := Path(options.name[0])).suffix == ".md":
        if len(options.name) > 1:
            raise RigidtopError("one page at a time")
        lecture = built_in().with_page(page)
        return _lines(lecture, lecture.texts[-1:], notation, options)
    with opened(options.name) as (collection, names):
        if options.lines:
            if names:
                raise RigidtopError("--lines is about whole pages: leave the names out")
            written = collection.as_written(collection.exercises)
            lecture, _, _ = judged_beside(written, _nothing, _nothing)
            return _lines(lecture, lecture.texts, notation, options)
        return _run(collection, names, notation, options)


def _nothing(_: Lecture) -> None:
    """What is asked besides the lines where nothing is."""


def _lines(
    lecture: Lecture, pages: Sequence[Text], notation: Notation, options: argparse.Namespace
) -> int:
    """Print the verdict on every line of some pages; 0 if all follow and nothing else is wrong."""
    from rigidtop.report.lines import line_records
    from rigidtop.terminal.table import table, wants_color

    records = line_records(lecture, pages, notation)
    counts = Counter(str(record["verdict"]) for record in records)
    if options.json:
        print_json(records)
    else:
        rows = [
            [f"{each['file']}, line {each['line']}", str(each["verdict"]), _beside(each)]
            for each in records
        ]
        colors = LINE_COLORS if wants_color(sys.stdout) else None
        print(table(rows, ("place", "verdict", "conditions"), colors=colors))
        print(", ".join(f"{count} {verdict}" for verdict, count in counts.items()))
    return claims.FAILED if counts.keys() & {"gap", "unread", "fault"} else 0


def _beside(record: Mapping[str, Any]) -> str:
    return str(record["note"]) or ", ".join(record["conditions"])


def _run(
    collection: collections.Collection,
    names: Sequence[str],
    notation: Notation,
    options: argparse.Namespace,
) -> int:
    from rigidtop.proof.page import by_lines
    from rigidtop.report.records import measures, record
    from rigidtop.report.wording import Wording
    from rigidtop.terminal.table import paragraph, table, wants_color
    from rigidtop.typeset.words import unmarked

    chosen = claims.named(collection, names) if names else claims.every(collection)
    every = options.thorough and not names
    solved = collection.solved_by(claim for _, claim in chosen) if names else collection.exercises
    # A claim that only its lines show is judged by them.
    quick = options.quick and all(claim.evidence is not by_lines for _, claim in chosen)
    lecture = None if quick else collection.as_written(solved)

    def judging(lecture: Lecture | None) -> tuple[list[Judgement], dict[Expr, str]]:
        return judged(chosen, collection, lecture, not names)

    def modelled(lecture: Lecture | None) -> list[str]:
        if lecture is None or not (collection.models or collection.folder is None):
            return []
        named = [claim.name for _, claim in chosen] if names or not every else []
        return in_models(lecture, collection.models, named)

    if lecture is not None and not names and not options.thorough:
        lecture, (judgements, vanishing), model = judged_beside(lecture, judging, modelled)
    else:
        (judgements, vanishing), model = judging(lecture), modelled(lecture)
    denied, confirmation = confirmed(vanishing) if options.thorough else ([], [])
    trials = tried(lecture, names) if lecture is not None and options.thorough else {}
    amiss = [line for place, trial in trials.items() for line in _amiss(place, trial)] + denied
    more = len(amiss)
    ids = None
    if lecture is not None:
        ids = lecture.leading(claim.name for _, claim in chosen) if names else None
        amiss = [*claims.faults(lecture), *claims.gaps(lecture, ids), *amiss]
    amiss += model[:-1]
    more += len(model[:-1])
    passed = all(judgement.passed for judgement in judgements) and not amiss
    records = [record(Wording(notation).judgement(judgement)) for judgement in judgements]
    if options.json:
        print_json(records)
        return 0 if passed else claims.FAILED
    colors = VERDICT_COLORS if wants_color(sys.stdout) else None
    columns = ("reference", "name", "verdict", "note")
    rows = [[str(each[column]) for column in columns] for each in records]
    if rows:
        print(table(rows, ("section", "claim", "verdict", "note"), colors=colors))
        print()
    measured = measures(judgements)
    if measured:
        numbers = [
            [
                f"{m.error:.1e}",
                f"{m.tolerance:.1e}",
                "ok" if m.passed else "FAILED",
                unmarked(m.what),
            ]
            for m in measured
        ]
        print(table(numbers, ("error", "tolerance", "", "compared with a computed motion")))
        print()
    counts = [_counts([*trials.values()])] if trials else []
    truths = [true_in_worlds(lecture)] if lecture is not None and not names else []
    besides = f"{more} more told above" if more else ""
    summary = claims.summary(judgements, lecture, ids, besides)
    for line in (*amiss, *counts, *confirmation, *truths, *model[-1:], summary):
        print(paragraph(line))
    return 0 if passed else claims.FAILED


def true_in_worlds(lecture: Lecture) -> str:
    """How many lines follow, and how many of them are true wherever what they rest on is."""
    from rigidtop.judge.page import outcome

    lines = [each for each in map(lecture.judged, lecture.lines) if each.follows]
    counts = Counter(outcome(lecture, each).verdict for each in lines)
    roots, true = counts["premise"] + counts["definition"], counts["sampled"]
    return (
        f"{len(lines)} lines follow: {roots} laws and definitions, {true} that are true in every "
        f"world of what they rest on, and {len(lines) - roots - true} not compared there"
    )


def in_models(lecture: Lecture, models: Sequence[Model], names: Sequence[str]) -> list[str]:
    """The laws that are false in the models, a line each; last how many these bear out.

    The models are those of the top if there are none.
    """
    from rigidtop.mark.laws import laws_in, of_the_top

    wanted = [id for name in names for id in lecture.names.get(name, ())]
    ids = {*wanted, *(above for id in wanted for above in lecture.above(id))}
    if names and not ids:
        return []
    laws = laws_in(lecture, models or of_the_top(), ids)
    lines = {id: lecture.lines[id] for id, holds in laws.items() if holds is False}
    wrong = [f"{x.file}, line {x.at}: this law is false in the models" for x in lines.values()]
    true, unknown = (sum(x is each for x in laws.values()) for each in (True, None))
    count = f"{len(laws)} law{'s' * (len(laws) != 1)}, of which the models bear out {true}"
    more = f"; {unknown} speak of what no model knows" if unknown else ""
    return [*wrong, count + more] if laws else []


def tried(lecture: Lecture, names: Sequence[str]) -> dict[str, Trial]:
    """What came of dropping the premises of each line and of changing it, by its place."""
    wanted = [name for name in names if name in lecture.names]
    ids = {id for name in wanted for id in lecture.way(name)[0]} if names else set(lecture.lines)
    lines = [line for id, line in lecture.lines.items() if id in ids]
    return {
        f"{line.file}, line {line.at}": lecture.trial(line.id)
        for line in over("changing lines", lines)
    }


def judged(
    chosen: Sequence[tuple[Page, Claim]],
    collection: collections.Collection,
    lecture: Lecture | None,
    lines: bool,
) -> tuple[list[Judgement], dict[Expr, str]]:
    """Claims judged, with all `lines` if asked; and what was found to be zero, and where."""
    from rigidtop.proof.confirmation import zeros

    judgements: list[Judgement] = []
    places: dict[Expr, str] = {}

    def take(place: str) -> None:
        for zero in here:
            places.setdefault(zero, place)
        here.clear()

    with zeros() as here:
        if lecture is not None and lines:
            for line in over("following lines", [*lecture.lines.values()]):
                lecture.judged(line.id)
                take(f"{line.file}, line {line.at}")
        for _, judgement in claims.judged(chosen, collection.letters, lecture):
            judgements.append(judgement)
            take(judgement.claim.name)
    return judgements, places


def confirmed(zeros: Mapping[Expr, str]) -> tuple[list[str], list[str]]:
    """What another arithmetic refutes of what was found to be zero, a line each, and the counts."""
    from rigidtop.proof.confirmation import confirmed

    truths = {zero: confirmed(zero) for zero in over("confirming", [*zeros])}
    denied = [
        f"{zeros[x]}: another arithmetic refutes that this is 0: {x}"
        for x, each in truths.items()
        if each is False
    ]
    right, unknown = (sum(each is truth for each in truths.values()) for truth in (True, None))
    more = f", {unknown} of which it knows no value" if unknown else ""
    counts = f"{right} zero{'s' * (right != 1)} confirmed by another arithmetic, {len(denied)} not"
    return denied, [counts + more]


def _amiss(place: str, trial: Trial) -> list[str]:
    faults = [f"{place}: {cited} is not needed" for cited in trial.unneeded]
    return faults + [f"{place}: it still follows with {what}" for what in trial.survived]


def _counts(trials: Sequence[Trial]) -> str:
    """How much was tried, and how much of it stood."""
    tried = [trial for trial in trials if trial.changes]
    premises, changes = sum(t.premises for t in tried), sum(t.changes for t in tried)
    fewest = min((trial.changes for trial in tried), default=0)
    stood = sum(len(trial.unneeded) + len(trial.survived) for trial in tried)
    return (
        f"{len(tried)} lines: {premises} premises dropped, {changes} changes, at least {fewest} a "
        f"line; {stood or 'none'} of them passed unnoticed"
    )
