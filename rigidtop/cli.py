"""The command line: ``rigidtop list | check | derive | lecture | simulate | certify | …``.

Results go to stdout, progress and errors to stderr.  Exit codes: 0 for success, 1 for a check that
failed, 2 for bad input.  Everything that takes time to load is loaded by the command that needs it.
"""

from __future__ import annotations

import argparse
import io
import os
import sys
from collections.abc import Sequence
from typing import Any, NoReturn

from rigidtop.commands import (
    audit,
    bench,
    certify,
    check,
    derive,
    exercise,
    figure,
    lecture,
    listing,
    mark,
    new,
    notation,
    read,
    simulate,
    sweep,
    web,
)
from rigidtop.errors import RigidtopError

COMMANDS = {
    "list": listing,
    "check": check,
    "audit": audit,
    "derive": derive,
    "lecture": lecture,
    "new": new,
    "exercise": exercise,
    "mark": mark,
    "notation": notation,
    "read": read,
    "figure": figure,
    "web": web,
    "simulate": simulate,
    "certify": certify,
    "sweep": sweep,
    "bench": bench,
}
"""Each module has ABOUT, `add_options(parser)` and `run(options)`, which returns the exit code."""

BAD_INPUT, INTERRUPTED = 2, 130


class Parser(argparse.ArgumentParser):
    """Errors in one line, without the usage."""

    def error(self, message: str) -> NoReturn:
        self.exit(BAD_INPUT, f"{self.prog}: {message} (see {self.prog} --help)\n")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns its exit code."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        # A terminal that can't show θ gets an escape in its place, not an error.
        sys.stdout.reconfigure(errors="backslashreplace")
    options, unknown = _parser().parse_known_args(arguments)
    if unknown:
        options.refuse(f"unrecognized arguments: {' '.join(unknown)}")
    try:
        code = options.run(options)
        sys.stdout.flush()
        return int(code)
    except RigidtopError as error:
        print(f"rigidtop {options.command}: {error}", file=sys.stderr)
        return BAD_INPUT
    except BrokenPipeError:
        # The reader of our output has left, as `| head` does: nothing is wrong.
        sys.stderr.close()
        return 0
    except KeyboardInterrupt:
        print(f"\nrigidtop {options.command}: interrupted", file=sys.stderr)
        return INTERRUPTED
    except OSError as error:
        print(f"rigidtop {options.command}: {error.strerror or error}", file=sys.stderr)
        os.close(sys.stdout.fileno())  # what can't be written is not tried again at exit
        return BAD_INPUT


# --- What can be asked ---------------------------------------------------------------------------


def _parser() -> Parser:
    parser = Parser(
        prog="rigidtop",
        description="Rigid rotation and the spinning top: the lecture derived, judged, typeset "
        "and computed.",
    )
    parser.add_argument("--version", action=_Version)
    commands = parser.add_subparsers(dest="command", required=True, metavar="command")
    for name, module in COMMANDS.items():
        about = module.ABOUT
        command = commands.add_parser(
            name, help=about, description=about[0].upper() + about[1:] + "."
        )
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


if __name__ == "__main__":
    sys.exit(main())
