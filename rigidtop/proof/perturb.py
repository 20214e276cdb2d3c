"""Small changes of a printed equation, each of which must make it fall.

A claim that still passes with a sign, a factor, an exponent, an index or a function changed is not
being checked.  A change is left out only where the changed equation follows from the printed one
whatever its symbols mean: two changed signs, λ₂ for λ₁ where the two are assumed equal, ẋ = 0 with
a factor, ω·(r × ω) = 0.  That is found at random meanings of the symbols, which know nothing of
the engine, so a hole in the engine can't make a change look harmless.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import sympy
from sympy import Add, Integer, Symbol
from sympy.matrices.exceptions import ShapeError

from rigidtop.proof import decide
from rigidtop.proof.algebra import Letters
from rigidtop.proof.changed import Families, Perturbation, perturbations
from rigidtop.proof.equation import (
    Equation,
    Meaning,
    NoMeaningError,
    Rate,
    Underbrace,
    value,
)
from rigidtop.proof.page import Check
from rigidtop.proof.verdict import (
    Finding,
    UnneededAssumptionError,
    Verdict,
    assertions,
    entries,
    is_refuted,
    judge_check,
)
from rigidtop.theory.symbols import const, unit

_ANY = Letters()


def upheld(finding: Finding) -> Check | None:
    """The check of a finding in the reading in which it holds; None where it does not hold."""
    if finding.verdict is Verdict.CONVENTION and finding.check.other_reading is not None:
        return replace(finding.check, meaning=finding.check.other_reading, other_reading=None)
    held = (Verdict.PROVED, Verdict.SAMPLED, Verdict.ASSUMING)
    return finding.check if finding.verdict in held else None


def telling(check: Check, letters: Letters = _ANY) -> Iterator[Perturbation]:
    """The perturbations of a check's equation that do not follow from it.

    Letters of one of their families are exchanged.

    An inequality stays true under many changes; of it only the relation is turned round.
    """
    claimed = check.claimed
    opposite = {"≠": "=", ">": "<", "<": ">"}.get(claimed.relation)
    if opposite is not None:
        turned = Equation(*claimed.sides, relation=opposite, tag=claimed.tag)
        yield Perturbation(turned, f"{opposite} for {claimed.relation}")
        return
    trials = _Trials(check, letters.families)
    for perturbation in perturbations(claimed, letters.families):
        try:
            follows = trials.follows(perturbation.equation)
        except (ShapeError, TypeError, AttributeError):
            continue  # the square of a vector and the like: not an equation any more
        if not follows:
            yield perturbation


def falls(check: Check, perturbation: Perturbation, letters: Letters = _ANY) -> bool:
    """Whether the check no longer passes with the changed equation in place of its own."""
    changed = replace(check, claimed=perturbation.equation)
    try:
        # Nearly all fall at one of the first points, long before anything has to be shown.
        if is_refuted(changed, changed.assuming, 40, letters=letters):
            return True
        return judge_check(changed, letters).verdict in (Verdict.FALSE, Verdict.UNDECIDED)
    except NoMeaningError:
        return True  # ∫ρ² d³r is nothing that a body has
    except UnneededAssumptionError:
        return False  # it holds even without an assumption


# --- whether a change says anything ------------------------------------------------------------

_TRIALS = 3


class _Trials:
    """Random meanings of a check's symbols, at which changed equations are compared with its own.

    Each symbol gets a value of the shape that it has in the check: vectors for vectors, matrices
    for matrices; a sum gets random terms, and an integral and the rate behind "= const" a random
    multiple of what they are applied to.
    """

    def __init__(self, check: Check, families: Families) -> None:
        rng = random.Random(3)
        self._meanings = [_random_meaning(check, families, rng) for _ in range(_TRIALS)]
        self._differences = [_differences(check.claimed, m) for m in self._meanings]
        solved = [_made_true(check.claimed, meaning) for meaning in self._meanings]
        self._made_true = [meaning for meaning in solved if meaning is not None]

    def follows(self, changed: Equation) -> bool:
        """Whether the changed equation holds wherever the check's own does."""
        return (
            self._says_nothing(changed) or self._is_multiple(changed) or self._is_implied(changed)
        )

    def _says_nothing(self, changed: Equation) -> bool:
        """It holds whatever its symbols mean, as ω·(r × ω) = 0 does."""
        return all(
            abs(difference) < decide.TOLERANCE
            for meaning in self._meanings
            for difference in _differences(changed, meaning)
        )

    def _is_multiple(self, changed: Equation) -> bool:
        """Its differences are a constant multiple of the old ones."""
        factors: list[complex] = []
        for meaning, old in zip(self._meanings, self._differences, strict=True):
            new = _differences(changed, meaning)
            if len(old) != len(new):
                return False
            for a, b in zip(old, new, strict=True):
                if a == b == 0:
                    continue
                if abs(a) < decide.TOLERANCE or abs(b) < decide.TOLERANCE:
                    return False
                factors.append(b / a)
        return all(abs(f - factors[0]) < decide.TOLERANCE * abs(f) for f in factors)

    def _is_implied(self, changed: Equation) -> bool:
        """It holds with the names on the old one's sides given the values that make that true."""
        return bool(self._made_true) and all(
            abs(difference) < decide.TOLERANCE
            for meaning in self._made_true
            for difference in _differences(changed, meaning)
        )


def _random_meaning(check: Check, families: Families, rng: random.Random) -> dict[Any, Any]:
    """A random value for every symbol, of the shape that its meaning in the check has."""

    def number() -> sympy.Float:
        return sympy.Float(rng.uniform(0.4, 1.9))

    def like(meant: Any) -> Any:
        if isinstance(meant, sympy.MatrixBase):
            return sympy.Matrix(*meant.shape, [number() for _ in meant])
        if isinstance(meant, (list, tuple)):
            return [{key: like(part) for key, part in term.items()} for term in meant]
        return _multiple(number()) if callable(meant) else number()

    conditions = [assumption.condition for assumption in check.assuming]
    symbols = {x for part in (*check.claimed.sides, *conditions) for x in part.free_symbols}
    symbols |= {x for family in families for x in family}
    meaning: dict[Any, Any] = {x: number() for x in sorted(symbols, key=str)}
    meaning |= {key: like(meant) for key, meant in check.meaning.items()}
    if unit in check.meaning:
        meaning[unit] = check.meaning[unit]  # as little a variable as the number 1 is
    for condition in conditions:
        if isinstance(condition, sympy.Eq):
            meaning[condition.lhs] = value(condition.rhs, meaning)
    return meaning


def _multiple(factor: Any) -> Any:
    """A function that is linear, as rates and integrals are."""
    return lambda argument: factor * argument


def _differences(equation: Equation, meaning: Meaning) -> list[complex]:
    """What an equation and the braces in it say to be zero, in numbers."""
    return [
        complex(difference)
        for _, left, right in assertions(equation, meaning)
        for difference in entries(left, right)
    ]


def _made_true(equation: Equation, meaning: dict[Any, Any]) -> dict[Any, Any] | None:
    """The meaning with the names that are sides, or labels, set to what makes the equation true.

    None where no choice of these alone makes it true.
    """
    true = dict(meaning)
    for brace in set().union(*(side.atoms(Underbrace) for side in equation.sides)):
        body, label = brace.args
        true[label] = value(body, true)
    # What can't be solved for gives the value; a rate behind "= const" vanishes.
    fixed = [side for side in equation.sides if side != const and not _unknowns(side)]
    if const in equation.sides:
        fixed = [Integer(0)]
    target = value(fixed[0] if fixed else equation.sides[0], true)
    for side in equation.sides:
        _solve(side, target, true)
    small = all(abs(difference) < decide.TOLERANCE for difference in _differences(equation, true))
    return true if small else None


def _unknowns(side: Any) -> list[Any]:
    """The names that a side can be solved for: one, or one an entry, or a rate in a sum."""
    if isinstance(side, sympy.MatrixBase):
        return list(side) if all(entry.is_Symbol for entry in side) else []
    if isinstance(side, Add):
        return [term for term in side.args if isinstance(term, Rate)][:1]
    base, exponent = side.as_base_exp()
    is_name = side != const and isinstance(base, (Symbol, Rate)) and exponent.is_number
    return [base] if is_name else []


def _solve(side: Any, target: Any, meaning: dict[Any, Any]) -> None:
    """Set the unknowns of a side so that it has the target's value (0 fits every shape)."""
    unknowns = [name for name in _unknowns(side) if name != unit]
    if isinstance(side, sympy.MatrixBase):
        is_vector = isinstance(target, sympy.MatrixBase)
        meaning |= zip(unknowns, target if is_vector else [target] * len(side), strict=False)
        return
    for name in unknowns:
        old = meaning[name]
        if isinstance(old, sympy.MatrixBase) and not isinstance(target, sympy.MatrixBase):
            target = target * sympy.ones(*old.shape)
        # A power has the target's value only where that is 0 or 1, as in "L² = const".
        meaning[name] = old + (target - value(side, meaning)) if isinstance(side, Add) else target
