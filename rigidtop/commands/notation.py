"""``rigidtop notation``: the conventions of other books, and what each writes otherwise."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from rigidtop.commands.output import print_json

if TYPE_CHECKING:
    from rigidtop.notation import Notation

ABOUT = "list the notations of other books and what each writes otherwise"

EPILOG = """\
A table of one's own is a file in TOML, for instance:

  title = "My lecture"
  source = "PHY 305, 2026, week 8"
  [euler]
  sequence = "zxz"
  [letters]
  "λ" = "I"
  [symbols]
  R = { base = "l", meaning = "distance from the pivot to the centre of mass" }

examples:
  rigidtop notation landau
  rigidtop derive 3.54 --notation goldstein --format latex
  rigidtop lecture --notation my_table.toml"""


def add_notation(parser: argparse.ArgumentParser) -> None:
    """The option that other commands have."""
    parser.add_argument(
        "--notation",
        default="notes",
        metavar="NAME|FILE",
        help="write it as another book does, such as goldstein, or as a table of one's own says "
        "(a file in TOML); `rigidtop notation` lists them",
    )


def chosen(options: argparse.Namespace) -> Notation:
    """The notation that was asked for.  Raises RigidtopError, in one line, where it is none."""
    from rigidtop.notation import named

    return named(options.notation)


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "name", nargs="*", metavar="NAME|FILE", help="only these; a file is checked (default: all)"
    )


def run(options: argparse.Namespace) -> int:
    """Print the conventions, or one symbol by symbol."""
    from rigidtop.notation import BUILT_IN, named
    from rigidtop.report.notations import record, rows, turns
    from rigidtop.terminal.table import paragraph, table, terminal_width
    from rigidtop.typeset.words import unmarked

    notations = [named(name) for name in options.name or BUILT_IN]
    if options.json:
        print_json([record(notation) for notation in notations])
        return 0
    blocks = []
    for notation in notations:
        about = (notation.source, unmarked(turns(notation)), unmarked(notation.note))
        head = [
            paragraph(f"{notation.name}: {notation.title}", rest="  "),
            *(paragraph(words, "  ", "  ") for words in about if words),
        ]
        entries = rows(notation)
        if entries:
            columns = ("here", "in the notes", "in code", "meaning")
            lines = table(entries, columns, width=terminal_width() - 2)
            head += [f"  {line}" for line in lines.splitlines()]
        else:
            head.append("  All letters are those of the notes.")
        blocks.append("\n".join(head))
    print("\n\n".join(blocks))
    return 0
