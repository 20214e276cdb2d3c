"""``rigidtop bench``: what the numbers cost, beside what a user would otherwise take."""

from __future__ import annotations

import argparse

from rigidtop.commands.output import print_json

ABOUT = "measure the numbers beside what one would otherwise take"


def add_options(parser: argparse.ArgumentParser) -> None:
    """What can be asked."""
    parser.add_argument(
        "--quick", action="store_true", help="a tenth of the samples and one round, in seconds"
    )
    parser.add_argument(
        "--markdown", action="store_true", help="print the table of kinds of motions as Markdown"
    )


def run(options: argparse.Namespace) -> int:
    """Measure and print."""
    from rigidtop import bench
    from rigidtop.terminal.progress import bar

    rows = bench.measure(options.quick, bar("measuring"))
    if options.json:
        print_json(bench.records(rows))
    else:
        print(bench.markdown(rows) if options.markdown else bench.table(rows))
    return 0
