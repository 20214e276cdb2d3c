"""Where a statement stands, and what the words beside it say."""

from __future__ import annotations

from dataclasses import dataclass

from rigidtop.tree.nodes import Letter


@dataclass(frozen=True)
class Situation:
    """Where a statement stands and what the words beside it say.

    `supposed`: it is set for what follows; `case`: it is one of several; `derived`: it is said to
    follow; `instant`: it is said of one moment; `small` and `large`: for what it is nearly true;
    `declared` are letters that words introduce, and `asked` says that it is not asserted.
    `origin`: it says where a letter counts from.
    `oscillates`, `begins`, `balanced`, `circular`: words speak of an oscillation, of a start from
    rest, of an equilibrium, of a circle. `vanishes`: what was said before is zero there, and
    `extreme`: greatest or least. `sign`: that of the one root, of two, of which the words speak.
    `anew`: it is what a letter stands for after a change; `ranges`: it says where something
    begins or ends.
    `inline`: it stands in a line of words, and `opens`: nothing stands above it in its scope.
    `closed`: all that is needed has been said, so that what does not hold is false.
    """

    number: int
    scope: tuple[int, ...] = ()
    instant: str = ""
    sentence: int = -1
    supposed: bool = False
    case: bool = False
    derived: bool = False
    defined: bool = False
    small: bool = False
    large: bool = False
    asked: bool = False
    origin: bool = False
    anew: bool = False
    ranges: bool = False
    oscillates: bool = False
    begins: bool = False
    balanced: bool = False
    circular: bool = False
    vanishes: bool = False
    extreme: bool = False
    sign: int = 0
    inline: bool = False
    closed: bool = False
    opens: bool = False
    declared: frozenset[Letter] = frozenset()
