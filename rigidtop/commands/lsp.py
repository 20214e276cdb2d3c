"""``rigidtop lsp``: notes judged in an editor, as one types."""

from __future__ import annotations

import argparse

from rigidtop.errors import RigidtopError

ABOUT = "judge notes in your editor as you type (a language server)"

EPILOG = """\
An editor starts it and talks to it over standard input and output. What is wrong is
underlined; hovering says what a line follows from; a quick fix writes the right line;
"go to definition" leads to the lines that it rests on. It wants `pip install
'rigidtop[lsp]'`."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "folder", nargs="?", metavar="COLLECTION", help="the folder of a collection of your own"
    )
    parser.add_argument(
        "--stdio", action="store_true", help="the only way, for editors that say so"
    )


def run(options: argparse.Namespace) -> int:
    """Serve an editor until it says that it ends."""
    from rigidtop.collection import opened

    try:
        from rigidtop.commands.editor import Editor
    except ModuleNotFoundError as error:
        raise RigidtopError(f"{error.name} is not installed: pip install 'rigidtop[lsp]'") from None
    with opened([f"{options.folder}/"] if options.folder else []) as (collection, _):
        Editor(collection).serve()
    return 0
