"""What became of a statement."""

from __future__ import annotations

from dataclasses import dataclass, replace

PROVED, SAMPLED, ASSUMING = "proved", "sampled", "assuming"
PREMISE, DEFINITION = "premise", "definition"
FALSE, UNDECIDED, UNREAD = "false", "undecided", "unread"

PASSED = {
    PROVED: True,
    SAMPLED: True,
    ASSUMING: True,
    FALSE: False,
    PREMISE: None,
    DEFINITION: None,
    UNDECIDED: None,
    UNREAD: None,
}
"""The verdict words, and whether a statement with it passes; None is neither yes nor no."""


@dataclass(frozen=True)
class Outcome:
    """A verdict with its reason.

    `rests_on` are the numbers of the statements that it follows from, or contradicts; `slip` is
    what is wrong in a false one and `right` the line as it has to be; `conditions` is what a
    statement that follows needs besides.  `brings` names the letters that occur in it for the first
    time; it `restricts` where it fixes letters of which statements above speak.
    """

    verdict: str
    why: str = ""
    rests_on: frozenset[int] = frozenset()
    slip: str = ""
    right: str = ""
    conditions: tuple[str, ...] = ()
    brings: frozenset[str] = frozenset()
    restricts: bool = False

    @property
    def passed(self) -> bool | None:
        return PASSED[self.verdict]


def joint(outcomes: list[Outcome]) -> Outcome:
    """What becomes of a chain: false if a link is, open if one is, else what its links show.

    A link that only names what the others speak of does not keep the chain from following.
    """
    for verdict in (FALSE, UNREAD, UNDECIDED):
        for outcome in outcomes:
            if outcome.verdict == verdict:
                return outcome
    shown = [outcome for outcome in outcomes if outcome.restricts]
    shown = shown or [outcome for outcome in outcomes if outcome.passed] or outcomes
    weakest = max(shown, key=lambda outcome: [*PASSED].index(outcome.verdict))
    rests_on = frozenset().union(*(outcome.rests_on for outcome in outcomes))
    conditions = tuple(dict.fromkeys(x for outcome in outcomes for x in outcome.conditions))
    return replace(weakest, rests_on=rests_on, conditions=conditions)
