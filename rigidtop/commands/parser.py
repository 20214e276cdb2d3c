"""What can be asked for on the command line, in all."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from itertools import groupby
from textwrap import fill, wrap
from typing import Any, NoReturn

from rigidtop.commands import (
    audit,
    certify,
    check,
    derive,
    exercise,
    figure,
    fit,
    lecture,
    listing,
    lsp,
    map,
    mark,
    mcp,
    new,
    notation,
    read,
    simulate,
    sweep,
    watch,
    web,
)
from rigidtop.terminal.table import columns, terminal_width, wrapped
from rigidtop.terminal.table import message as message_of

COMMANDS = {
    "list": listing,
    "check": check,
    "audit": audit,
    "watch": watch,
    "lsp": lsp,
    "mcp": mcp,
    "derive": derive,
    "map": map,
    "lecture": lecture,
    "new": new,
    "exercise": exercise,
    "mark": mark,
    "notation": notation,
    "read": read,
    "figure": figure,
    "web": web,
    "simulate": simulate,
    "fit": fit,
    "certify": certify,
    "sweep": sweep,
}
"""Each module has ABOUT, perhaps an EPILOG, `add_options(parser)`, and `run(options)`, which gives
the exit code."""


class Help(argparse.HelpFormatter):
    """Paragraphs as wide as the terminal; what is indented stands as it is written if it fits."""

    def format_help(self) -> str:
        # argparse breaks no line within an option: [--axis NAME=VALUE [NAME=VALUE ...]].
        lines = super().format_help().splitlines()
        return "".join(f"{part}\n" for line in lines for part in _option(line, terminal_width()))

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        filled: list[str] = []
        for indented, group in groupby(text.splitlines(), lambda line: line[:1] in ("", " ")):
            lines = list(group)
            if indented:
                filled += [part for line in lines for part in _example(line, width)]
            else:
                filled += fill(" ".join(lines), width).splitlines()
        return "\n".join(indent + line for line in filled)


def _option(line: str, width: int) -> list[str]:
    """A line that names options, in lines that fit, as far as its words do."""
    if columns(line) <= width:
        return [line]
    longest = max(columns(word) for word in line.split())
    start = " " * max(0, min(len(line) - len(line.lstrip()), width - longest - 2))
    first, *rest = wrapped(line, max(width - len(start) - 2, longest))
    return [start + first, *(f"{start}  {part}" for part in rest)]


def _example(line: str, width: int) -> list[str]:
    """A command in lines that a shell takes for one; a remark behind it has lines of its own."""
    if columns(line) <= width:
        return [line]
    command, mark, remark = line.partition("  # ")
    start = " " * (len(line) - len(line.lstrip()))
    parts = wrap(
        command.strip(),
        width - 2,
        initial_indent=start,
        subsequent_indent=start + "    ",
        break_long_words=False,
        break_on_hyphens=False,
    )
    rows = [*(f"{part} \\" for part in parts[:-1]), *parts[-1:]]
    begun = f"{start}  # "
    more = wrap(remark, width, initial_indent=begun, subsequent_indent=begun) if mark else []
    return rows + more


class Parser(argparse.ArgumentParser):
    """Errors in one line, without the usage."""

    def error(self, message: str) -> NoReturn:
        complaint = f"{self.prog}: {message} (see {self.prog} --help)"
        self.exit(2, message_of(complaint, sys.stderr) + "\n")


def parsed(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    """The options of a command, with its name as `command` and what it does as `run`."""
    options, unknown = _parser().parse_known_args(arguments)
    if unknown:
        options.refuse(f"unrecognized arguments: {' '.join(unknown)}")
    return options


def _parser() -> Parser:
    parser = Parser(
        prog="rigidtop",
        description="Rigid rotation and the spinning top: the lecture derived, judged, typeset "
        "and computed.",
        formatter_class=Help,
    )
    parser.add_argument("--version", action=_Version)
    commands = parser.add_subparsers(dest="command", required=True, metavar="command")
    for name, module in COMMANDS.items():
        about = module.ABOUT
        command = commands.add_parser(
            name, help=about, description=about[0].upper() + about[1:] + "."
        )
        if epilog := getattr(module, "EPILOG", None):
            command.epilog = epilog
        command.formatter_class = Help
        command.add_argument("--json", action="store_true", help="print JSON instead of text")
        command.set_defaults(run=module.run, refuse=command.error)
        module.add_options(command)
    return parser


class _Version(argparse.Action):
    """Looks the version up only when asked."""

    def __init__(self, option_strings: Sequence[str], dest: str, **_: Any) -> None:
        super().__init__(option_strings, dest, nargs=0, help="show the version and exit")

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> NoReturn:
        import rigidtop

        print(f"rigidtop {rigidtop.__version__}")
        parser.exit()
