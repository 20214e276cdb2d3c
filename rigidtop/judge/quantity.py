"""A formula that a letter may name."""

from __future__ import annotations

from dataclasses import dataclass

from rigidtop.judge.context import Context
from rigidtop.tree.nodes import Node


@dataclass(frozen=True, eq=False)
class Quantity:
    """A formula that a letter may name, in `words`, where `context` is known, at an `instant`."""

    words: str
    node: Node
    context: Context | None = None
    instant: str = ""
