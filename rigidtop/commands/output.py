"""What every command prints in the same way."""

from __future__ import annotations

import json

from rigidtop.terminal.visible import escaped


def print_json(value: object) -> None:
    """Values as JSON, with every letter as it is written; NaN is an error, since it is none."""
    print(escaped(json.dumps(value, ensure_ascii=False, indent=1, allow_nan=False)))
