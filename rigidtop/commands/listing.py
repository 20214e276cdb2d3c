"""``rigidtop list``: what the notes assert, claim by claim."""

from __future__ import annotations

import argparse

from rigidtop.commands import claims
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError

ABOUT = "list every claim of the lecture, by section"


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "name", nargs="*", help=f"only these claims or sections, such as 3.5; {claims.FOLDER}"
    )
    parser.add_argument(
        "--chapters",
        action="store_true",
        help="list the chapters that `rigidtop new --from` copies",
    )


def run(options: argparse.Namespace) -> int:
    """Print the claims that are named, or all by section; the exit code is 0."""
    from rigidtop.collection import opened
    from rigidtop.report.records import claim_record
    from rigidtop.terminal.table import table
    from rigidtop.typeset.words import unmarked

    if options.chapters:
        return _chapters(options)
    with opened(options.name) as (collection, names):
        chosen = claims.named(collection, names) if names else claims.every(collection)
    if options.json:
        print_json([claim_record(claim, page.section) for page, claim in chosen])
        return 0
    rows = [[page.section, claim.name, unmarked(claim.says)] for page, claim in chosen]
    print(table(rows, ("section", "claim", "what the notes assert")))
    return 0


def _chapters(options: argparse.Namespace) -> int:
    """Print the chapters that come with rigidtop, with the titles of their pages."""
    from rigidtop.collection.chapters import chapters
    from rigidtop.terminal.table import table

    if options.name:
        raise RigidtopError("--chapters lists them all: no name is needed")
    if options.json:
        print_json([{"name": name, "pages": titles} for name, titles in chapters().items()])
    else:
        rows = [[name, "; ".join(titles)] for name, titles in chapters().items()]
        print(table(rows, ("chapter", "pages")))
    return 0
