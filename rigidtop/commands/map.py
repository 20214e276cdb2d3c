"""``rigidtop map``: which equation rests on which, from the laws to the last claim."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from rigidtop.commands import claims
from rigidtop.commands.notation import add_notation, chosen
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.notation import Notation
    from rigidtop.proof.lecture import Lecture

ABOUT = "show which equation rests on which, from the laws to the last claim"


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "name",
        nargs="*",
        help="only what these rest on, such as 3.57, and what rests on them; " + claims.FOLDER,
    )
    parser.add_argument("-o", "--output", metavar="FILE", help="draw it: .svg, .pdf or .png")
    add_notation(parser)


def run(options: argparse.Namespace) -> int:
    """Print the map of claims, or draw it; returns the exit code."""
    from rigidtop.collection import opened

    notation = chosen(options)
    with opened(options.name) as (collection, names):
        lecture = collection.lecture_with(collection.exercises)
        for name in names:
            if name.strip("()") not in lecture.names:
                raise RigidtopError(
                    f"nothing on the map is called {name!r}; `{collection.command('map')}` "
                    "shows all that is"
                )
        return _run(lecture, [name.strip("()") for name in names], options, notation)


def _run(
    lecture: Lecture, names: list[str], options: argparse.Namespace, notation: Notation
) -> int:
    from rigidtop.report.map import KINDS, drawn, label, part
    from rigidtop.terminal.table import paragraph

    whole = lecture.map
    entries = part(whole, names) if names else whole
    falling = [name for name in entries if lecture.gaps(lecture.leading([name]))]
    code = claims.FAILED if falling else 0
    if options.output is not None:
        from rigidtop.terminal.files import check_folder, write_whole

        path = Path(options.output)
        kind = path.suffix[1:].lower()
        if kind not in KINDS:
            raise RigidtopError(f"{options.output}: draw it as .svg, .pdf or .png")
        check_folder(path.parent)
        write_whole(path, drawn(lecture, entries, kind, notation))
        if not options.json:
            print(path)
            return code
    if options.json:
        print_json(
            {
                "results": [
                    {
                        "name": name,
                        "rests_on": list(on),
                        "falls_with": list(lecture.resting(name)),
                        "follows": name not in falling,
                    }
                    for name, on in entries.items()
                    if name not in lecture.laws
                ],
                "laws": [
                    {
                        "id": name,
                        "name": label(lecture, name, notation),
                        "source": lecture.lines[name].source,
                    }
                    for name in entries
                    if name in lecture.laws
                ],
            }
        )
        return code
    for name, on in entries.items():
        if name not in lecture.laws:
            basis = ", ".join(label(lecture, each, notation) for each in on) or "definitions alone"
            print(paragraph(f"{label(lecture, name, notation)}: {basis}", rest="  "))
    for name in names:
        below = [label(lecture, each, notation) for each in lecture.resting(name)]
        this = label(lecture, name, notation)
        on_it = f"On {this} rest {len(below)}: {', '.join(below)}"
        print("\n" + paragraph(on_it if below else f"On {this} rests nothing", rest="  "))
    if falling:
        labels = [label(lecture, each, notation) for each in falling]
        print(paragraph(f"\nNot every line to these follows: {', '.join(labels)}"))
    return code
