r"""What a derivation page is made of: claims, and the evidence that each one yields.

A claim is a function.  Its docstring is the reason, in one sentence; its body takes the equation
as the page prints it, lets the engine go its own way, and yields what there is to see: a `Check` of
the equation against the engine, a `Correction`, a `Measure` of a computed motion, or a `Step` of
the engine's own that no page prints.  `rigidtop.proof.verdict.judge` runs it.  Mathematics in
sentences stands between dollars: `rigidtop.typeset.words`::

    @claim("3.45", r"$\dot\phi$ from the two conserved momenta")
    def azimuthal_rate():
        r'''(3.43) along $\hat{\mathbf z}$ and $\mathbf e_3$; $\sin^2\theta$ is divided out.'''
        tilted = Assumption(Ne(sin(theta), 0), "the top is not upright and does not hang")
        yield Check(printed("3.45"), {L_z: …, L3: …}, assuming=(tilted,))
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from sympy import Expr
from sympy.logic.boolalg import Boolean

from rigidtop.errors import RigidtopError
from rigidtop.proof.equation import Equation, Meaning


@dataclass(frozen=True)
class Assumption:
    """A condition under which a check holds.

    `condition` is a SymPy relation.  ``Eq(symbol, value)`` is applied by substitution; other
    relations decide signs and record divisions.  `stated` says that the notes state it too.
    `words` say what it means.  For a limit such as ``Eq(epsilon, 0)``, `otherwise` is what the
    symbol stands for where the limit is not taken, so that a counterexample is one in numbers
    that go together.
    """

    condition: Boolean
    words: str = ""
    stated: bool = False
    otherwise: Expr | None = None


@dataclass(frozen=True)
class Check:
    """A typed equation held against the engine's `meaning` of its symbols.

    A meaning, or a `given`, that is typed on the page and is the statement itself is refused.
    `given` are expressions known to vanish (an equation from which this one is said to follow).
    `other_reading` is the meaning under which the same content is right although the notes' own
    definitions say otherwise.  `reason` is the sentence beside the line; `printed` says whether
    the notes have the equation.
    """

    claimed: Equation
    meaning: Meaning = field(default_factory=dict)
    assuming: tuple[Assumption, ...] = ()
    reason: str = ""
    given: tuple[Expr, ...] = ()
    other_reading: Meaning | None = None
    printed: bool = True


@dataclass(frozen=True)
class Formal(Check):
    """A formal version of what the notes say in words."""

    printed: bool = False


@dataclass(frozen=True)
class Correction(Check):
    """The corrected form that stands beside a claim that is false or at odds with a definition."""


@dataclass(frozen=True)
class Remark(Check):
    """What is true besides: judged, and it must hold, but its conditions are not the claim's."""

    printed: bool = False


@dataclass(frozen=True)
class Definition:
    """An equation that introduces its left side: nothing to prove."""

    equation: Equation
    reason: str = ""


@dataclass(frozen=True)
class Step:
    """An equation of the engine's own derivation, shown with its reason."""

    equation: Equation
    reason: str


@dataclass(frozen=True)
class Measure:
    """A number from a computed motion: what was compared, its error, and what is allowed.

    An error of either sign counts by its size.  Raises RigidtopError, a ValueError, for a
    tolerance that is not finite, or negative.
    """

    what: str
    error: float
    tolerance: float

    def __post_init__(self) -> None:
        if not 0 <= self.tolerance < math.inf:
            raise RigidtopError(
                f"{self.what}: a tolerance must be finite and zero or more, not {self.tolerance}"
            )

    @property
    def passed(self) -> bool:
        return bool(abs(self.error) <= self.tolerance)  # False for NaN


Evidence = Step | Check | Definition | Measure


def by_lines() -> tuple[Evidence, ...]:
    """No evidence besides the lines of a text that have a claim's name."""
    return ()


@dataclass(frozen=True)
class Claim:
    """A row of the lecture.  `says` is what the notes assert, in our own words; `reason` why.

    Without `evidence` of its own it is shown by the lines of its name in a text.
    """

    name: str
    says: str
    evidence: Callable[[], Iterable[Evidence]] = by_lines
    reason: str = ""


def claim(name: str, says: str) -> Callable[[Callable[[], Iterable[Evidence]]], Claim]:
    """Make the decorated generator function a `Claim`; its docstring is the reason."""
    return lambda evidence: Claim(name, says, evidence, paragraph(evidence))


def paragraph(function: Callable[..., object]) -> str:
    """The docstring of a function, as one paragraph."""
    return " ".join((function.__doc__ or "").split())


@dataclass(frozen=True)
class Page:
    """One section of the notes: its number, its title, what it is about, its claims in order.

    `opens` is the title of the section above, such as 3.5 for 3.5.1, where this is its first page
    and there is none of its own.  `text` is the name of its text, a file in Markdown.
    """

    section: str
    title: str
    about: str
    claims: tuple[Claim, ...]
    opens: str = ""
    text: str = ""
