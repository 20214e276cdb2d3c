"""The kinds of quantities of mechanics, and the words that name them, in English and German.

A file's own words say what its letters are; what a kind decides is told by its `sort`.

>>> kind_of("the moment of inertia of the disc"), kind_of("the position of the centre of mass")
('moment of inertia', 'position')
>>> kind_of("das Trägheitsmoment der Scheibe"), kind_of("a constant")
('moment of inertia', '')
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum


class Sort(StrEnum):
    """What a letter of a kind is, and so how it is read."""

    NUMBER = "a number"
    """Brackets behind it hold a factor."""
    FUNCTION = "a number or a function"
    """Brackets behind it hold what it is a function of."""
    SPATIAL = "a number, a vector where × stands"
    """In a formula with × and nothing in bold type it is a vector."""


@dataclass(frozen=True)
class Kind:
    """The words that name a quantity, its unit, and what a letter for it is."""

    words: str
    unit: str
    sort: Sort = Sort.NUMBER


KINDS = {
    "moment of inertia": Kind(
        r"(?:principal )?moments? of inertia|principal moments?|inertia|\w*trägheitsmomente?",
        "kg m²",
    ),
    "the Lagrangian": Kind("lagrangian|lagrange-?funktion", "J", Sort.FUNCTION),
    "the Hamiltonian": Kind("hamiltonian|hamilton-?funktion", "J", Sort.FUNCTION),
    "angular momentum": Kind("angular momentum|drehimpuls", "J s", Sort.SPATIAL),
    "momentum": Kind("(?:linear )?moment(?:um|a)|impuls", "kg m/s", Sort.SPATIAL),
    "potential": Kind(r"potential(?: energy)?|potentielle energie", "J", Sort.FUNCTION),
    "energy": Kind(r"energy|\w*energie", "J"),
    "torque": Kind("torques?|force moments?|drehmoment", "N m", Sort.SPATIAL),
    "stiffness": Kind("(?:spring|force) constant|stiffness|federkonstante", "N/m"),
    "force": Kind(r"forces?|weight|\w*kraft", "N", Sort.SPATIAL),
    "angular velocity": Kind(
        "angular (?:velocity|speed|rate)|spin|winkelgeschwindigkeit", "rad/s", Sort.SPATIAL
    ),
    "frequency": Kind(r"(?:angular )?frequency|\w*frequenz", "rad/s"),
    "velocity": Kind("velocity|speed|geschwindigkeit", "m/s", Sort.SPATIAL),
    "acceleration": Kind("acceleration|beschleunigung", "m/s²", Sort.SPATIAL),
    "mass": Kind(r"mass(?:es)?|\w*masse", "kg"),
    "time": Kind("time|period|zeit|periode", "s"),
    "angle": Kind(r"angles?|latitude|longitude|phase|\w*winkel", "rad"),
    "position": Kind(
        r"position|cent(?:er|re) of mass|ort|ortsvektor|schwerpunkt", "m", Sort.SPATIAL
    ),
    "length": Kind(
        "lengths?|radius|distance|displacement|height|coordinate|amplitude"
        "|länge|abstand|auslenkung|höhe|koordinate",
        "m",
    ),
}
"""Of two at one place the one that stands first counts."""

_VECTOR = re.compile(r"(?<![-\d])\b(?:vectors?|\w*vektor)$", re.I)
_KIND = re.compile(
    "|".join(rf"(?P<k{i}>\b(?:{kind.words})\b)" for i, kind in enumerate(KINDS.values())), re.I
)
_OF = re.compile(r"(?<!moment)(?<!moments)(?<!center)(?<!centre) (?:of|der|des|vom|von) ")


@dataclass(frozen=True)
class Spoken:
    """The words that say what a letter is, in which line; the kind of quantity, if they name it."""

    words: str
    line: int
    kind: str = ""
    timed: bool = False
    """Whether it is said to depend on the time."""

    @property
    def sort(self) -> Sort | None:
        """What the letter is by these words, if they say anything of it."""
        if _VECTOR.search(self.words):
            return Sort.SPATIAL
        return KINDS[self.kind].sort if self.kind else None

    @property
    def role(self) -> str:
        """The same in words, with the unit of its kind."""
        unit = f" ({KINDS[self.kind].unit})" if self.kind else ""
        return f"{self.sort}{' that changes in time' * self.timed}{unit}" if self.sort else ""


def kind_of(said: str) -> str:
    """The kind of quantity that words name, if they do; what stands behind "of" is of another."""
    found = [each.lastgroup or "" for each in _KIND.finditer(_OF.split(said, maxsplit=1)[0])]
    return list(KINDS)[int(found[-1][1:])] if found else ""


def named_last(said: str) -> str:
    """The words for a quantity at the end of some words: "mass" of "a bob of mass"."""
    found = [each for each in _KIND.finditer(said) if each.end() == len(said)]
    return said[found[0].start() :] if found else ""
