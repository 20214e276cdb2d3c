"""What a text says: sides with relations between them, and where that stands."""

from __future__ import annotations

from dataclasses import dataclass

from rigidtop.tree.nodes import Node

RELATIONS = (
    "=",
    "≡",
    "≈",
    "∼",
    "∝",
    "<",
    "≤",
    ">",
    "≥",
    "≪",
    "≫",
    "≲",
    "≳",
    "≠",
    "→",
    "∈",
    "∥",
    "⊥",
)
"""The relations that stand between two sides; "≡" is also written ":=" and "≅" is "≈"."""


@dataclass(frozen=True, slots=True)
class Statement:
    """Sides a, b, c with a relation between each two: a = b ≈ c.

    `position` counts characters from the start of the formula to where the statement begins;
    `continues` is true where it begins with a relation, so that its first side is the last one of
    the statement before it (`Omitted` if none is).  `tag` is the number that it bears, and
    `condition` the words that stand beside it ("for small θ"); `conditions` are statements there
    (sin θ ≠ 0).
    """

    sides: tuple[Node, ...]
    relations: tuple[str, ...]
    position: int = 0
    tag: str = ""
    continues: bool = False
    condition: str = ""
    conditions: tuple[Statement, ...] = ()


@dataclass(frozen=True, slots=True)
class Unread:
    """What could not be read, with its place and the reason."""

    position: int
    reason: str
    tag: str = ""
