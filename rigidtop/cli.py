"""The command line: ``rigidtop list | check | derive | lecture | simulate | certify | …``.

Results go to stdout, progress and errors to stderr.  Exit codes: 0 for success, 1 for a check that
failed, 2 for bad input, 130 for an interrupt.  Whatever takes time to load is loaded inside `main`,
so that an interrupt is one line from the start.
"""

from __future__ import annotations

import os
import sys

from rigidtop.errors import RigidtopError

TYPE_CHECKING = False  # typing itself takes time
if TYPE_CHECKING:
    from collections.abc import Sequence

BAD_INPUT, INTERRUPTED = 2, 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns its exit code."""
    kept = sys.stdout, sys.stderr
    try:
        return _main(arguments)
    finally:
        sys.stdout, sys.stderr = kept


def _main(arguments: Sequence[str] | None) -> int:
    asked = "rigidtop"
    try:
        from rigidtop.terminal.visible import shown_on

        sys.stdout, sys.stderr = shown_on(sys.stdout), shown_on(sys.stderr)
        from rigidtop.commands.parser import parsed

        options = parsed(arguments)
        asked = f"rigidtop {options.command}"
        code = options.run(options)
        sys.stdout.flush()
        return int(code)
    except RigidtopError as error:
        from rigidtop.terminal.table import message

        print(message(f"{asked}: {error}", sys.stderr), file=sys.stderr)
        return BAD_INPUT
    except BrokenPipeError:
        # The reader of our output has left, as `| head` does: nothing is wrong.
        sys.stderr.close()
        return 0
    except KeyboardInterrupt as interrupt:
        behind = [""] if sys.stderr.isatty() else []  # the ^C that a terminal shows
        said = [*behind, *map(str, interrupt.args), f"{asked}: interrupted"]
        print("\n".join(said), file=sys.stderr)
        return INTERRUPTED
    except OSError as error:
        print(f"{asked}: {error.strerror or error}", file=sys.stderr)
        os.close(sys.stdout.fileno())  # what can't be written is not tried again at exit
        return BAD_INPUT


if __name__ == "__main__":
    sys.exit(main())
