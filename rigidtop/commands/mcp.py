"""``rigidtop mcp``: what assistants may ask for, as tools."""

from __future__ import annotations

import argparse

from rigidtop.errors import RigidtopError

ABOUT = "let an assistant audit, derive, mark and simulate (a server of the MCP)"

EPILOG = """\
An assistant starts it and talks to it over standard input and output. It reads no file
and runs nothing: texts are handed over whole, within the limits of the commands. It
wants `pip install 'rigidtop[mcp]'`."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """The command has no options of its own."""


def run(options: argparse.Namespace) -> int:
    """Serve an assistant until it hangs up."""
    try:
        from rigidtop.commands.assistant import Assistant
    except ModuleNotFoundError as error:
        raise RigidtopError(f"{error.name} is not installed: pip install 'rigidtop[mcp]'") from None
    Assistant().serve()
    return 0
