"""``rigidtop bench``: what the numbers cost, beside what a user would otherwise take."""

from __future__ import annotations

import argparse
import io
import json
from pathlib import Path

from rigidtop.errors import RigidtopError

PLOTS = (".png", ".svg", ".pdf")

ABOUT = "measure the numbers beside what one would otherwise take"


def add_options(parser: argparse.ArgumentParser) -> None:
    """What can be asked."""
    parser.add_argument(
        "--quick", action="store_true", help="a tenth of the samples and one round, in seconds"
    )
    parser.add_argument(
        "--markdown", action="store_true", help="print the table of kinds of motions as Markdown"
    )
    parser.add_argument("--plot", metavar="FILE", help="also draw the ratios (.png, .svg, .pdf)")


def run(options: argparse.Namespace) -> int:
    """Measure and print."""
    from rigidtop import bench
    from rigidtop.terminal.files import write_whole
    from rigidtop.terminal.progress import bar

    plot = Path(options.plot) if options.plot else None
    if plot is not None and plot.suffix not in PLOTS:
        raise RigidtopError(f"--plot wants a name that ends in {', '.join(PLOTS)}, not {plot}")
    rows = bench.measure(options.quick, bar("measuring"))
    shown = bench.markdown(rows) if options.markdown else bench.table(rows)
    print(json.dumps(bench.records(rows), indent=1) if options.json else shown)
    if plot is not None:
        drawing = io.BytesIO()
        bench.figure(rows).savefig(drawing, format=plot.suffix[1:], dpi=150)
        write_whole(plot, drawing.getvalue())
        if not options.json:
            print(plot)
    return 0
