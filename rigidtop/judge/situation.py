"""Where a statement stands, and what the words beside it say."""

from __future__ import annotations

from dataclasses import dataclass, replace

from rigidtop.read.phrases import Cue
from rigidtop.tree.nodes import Letter


@dataclass(frozen=True)
class Situation:
    """Where a statement stands and what the words beside it say, its `cues`.

    `instant`: it is said of one moment; `case`: it is one of several; `inline`: it stands in a line
    of words; `opens`: nothing stands above it in its scope; `declared` are letters that words
    introduce.
    `closed`: all that is needed has been said, so that what does not hold is false; `tried`: it is
    a number of an example, and of what is said beside it alone; `named`: it may name a case.
    """

    number: int
    scope: tuple[int, ...] = ()
    instant: str = ""
    sentence: int = -1
    cues: frozenset[Cue] = frozenset()
    case: bool = False
    inline: bool = False
    closed: bool = False
    tried: bool = False
    named: bool = False
    opens: bool = False
    declared: frozenset[Letter] = frozenset()

    def hearing(self, *cues: Cue) -> Situation:
        """The same where words say more of it."""
        return replace(self, cues=self.cues | {*cues})

    @property
    def supposed(self) -> bool:
        """Whether it is set for what follows."""
        return bool(self.cues & {Cue.CASE, Cue.CONDITION})

    @property
    def derived(self) -> bool:
        """Whether it is said to follow."""
        return Cue.DERIVED in self.cues and Cue.GIVEN not in self.cues

    @property
    def defined(self) -> bool:
        """Whether it is said to give something a name."""
        return Cue.DEFINED in self.cues

    @property
    def small(self) -> bool:
        """Whether it is nearly true where something is small."""
        return bool(self.cues & {Cue.SMALL, Cue.APPROXIMATED})

    @property
    def large(self) -> bool:
        """Whether it is nearly true where something is large."""
        return Cue.LARGE in self.cues

    @property
    def asked(self) -> bool:
        """Whether it is asked or denied, and not asserted."""
        return Cue.ASKED in self.cues

    @property
    def origin(self) -> bool:
        """Whether it says where a letter counts from."""
        return Cue.ORIGIN in self.cues

    @property
    def anew(self) -> bool:
        """Whether it is what a letter stands for after a change."""
        return Cue.ANEW in self.cues

    @property
    def repeated(self) -> bool:
        """Whether words say that it has been said before."""
        return Cue.REPEATED in self.cues

    @property
    def ranges(self) -> bool:
        """Whether it says where something begins or ends."""
        return Cue.RANGE in self.cues

    @property
    def oscillates(self) -> bool:
        """Whether words speak of an oscillation."""
        return Cue.OSCILLATION in self.cues

    @property
    def begins(self) -> bool:
        """Whether words speak of a start from rest."""
        return Cue.REST in self.cues

    @property
    def balanced(self) -> bool:
        """Whether words speak of an equilibrium."""
        return Cue.EQUILIBRIUM in self.cues

    @property
    def balances(self) -> bool:
        """Whether words say which forces are equal."""
        return Cue.BALANCE in self.cues

    @property
    def circular(self) -> bool:
        """Whether words speak of a circle."""
        return Cue.CIRCLE in self.cues

    @property
    def vanishes(self) -> bool:
        """Whether what was said before is zero there."""
        return Cue.VANISHING in self.cues

    @property
    def extreme(self) -> bool:
        """Whether what was said before is greatest or least there."""
        return Cue.EXTREME in self.cues

    @property
    def sign(self) -> int:
        """The sign of the one root, of two, of which the words speak; 0 if of none."""
        return (Cue.POSITIVE in self.cues) - (Cue.NEGATIVE in self.cues)
