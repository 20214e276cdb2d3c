"""``rigidtop list``: what the notes assert, claim by claim."""

from __future__ import annotations

import argparse

from rigidtop.commands import claims
from rigidtop.commands.output import print_json

ABOUT = "list every claim of the lecture, by section"


def add_options(parser: argparse.ArgumentParser) -> None:
    """What can be asked."""
    parser.add_argument("folder", nargs="?", help="a collection of one's own, such as my_course/")


def run(options: argparse.Namespace) -> int:
    """Print the list."""
    from rigidtop.collection import built_in, load
    from rigidtop.present.records import claim_record
    from rigidtop.present.table import table

    found = claims.every(built_in() if options.folder is None else load(options.folder))
    if options.json:
        print_json([claim_record(claim, page.section) for page, claim in found])
        return 0
    rows = [[page.section, claim.name, claim.says] for page, claim in found]
    print(table(rows, ("section", "claim", "what the notes assert")))
    return 0
