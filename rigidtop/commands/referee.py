"""``rigidtop referee``: how far simulators are from the exact top and the exact free body."""

from __future__ import annotations

import argparse
from pathlib import Path

from rigidtop.commands.output import print_json

ABOUT = "hold installed simulators against the exact top and free body"

EPILOG = """\
Engines that are known: MuJoCo (pip install mujoco), Pinocchio (pip install pin).
With -o the exact motions are written, for those who write simulators:
  rigidtop referee -o exact"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What can be asked."""
    parser.add_argument(
        "-o",
        "--output",
        metavar="FOLDER",
        help="write the exact motions as JSON; nothing is judged",
    )


def run(options: argparse.Namespace) -> int:
    """Judge and print, or write."""
    from rigidtop import referee
    from rigidtop.terminal.files import write_all
    from rigidtop.terminal.progress import bar

    if options.output is not None:
        contents = {
            f"{case.name.replace(' ', '_')}.json": referee.written(case).encode()
            for case in referee.cases()
        }
        paths = write_all(Path(options.output), contents)
        if options.json:
            print_json({"files": list(map(str, paths))})
        else:
            print("\n".join(map(str, paths)))
        return 0
    scores = referee.judge(progress=bar("judging"))
    if options.json:
        print_json(referee.records(scores))
    else:
        print(referee.table(scores))
    return 0
