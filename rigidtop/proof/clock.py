"""Another letter in the place of the time: u as a function of φ, with du/dφ as its rate."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from sympy import Dummy, Expr, Symbol

from rigidtop.proof.equation import Equation, Slope
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import Condition, Known, Move, RefusedError
from rigidtop.proof.values import TIME
from rigidtop.theory.symbols import const


@dataclass(frozen=True)
class Clock:
    """A letter that goes on like the time; `shown` are it and the slopes by it, as time and rates.

    `rates` has the letters that stand for these slopes.
    """

    letter: Symbol
    shown: Mapping[Expr, Expr]
    rates: Mapping[Symbol, Symbol]

    @classmethod
    def of(cls, letter: Symbol, equations: Iterable[Equation]) -> Clock:
        """A clock for what these equations have slopes of."""
        slopes = {x for e in equations for side in e.sides for x in side.atoms(Slope)}
        shown: dict[Expr, Expr] = {letter: TIME}
        rates: dict[Symbol, Symbol] = {}
        for slope in sorted(slopes, key=lambda x: len(x.atoms(Slope))):  # du/dφ before d²u/dφ²
            of = shown.get(slope.args[0], slope.args[0])
            if slope.args[1] == letter and isinstance(of, Symbol):
                shown[slope] = rates.setdefault(of, Dummy())
        return cls(letter, shown, rates)

    def equation(self, equation: Equation, letters: Letters) -> Equation:
        """An equation by this clock.  RefusedError where it has what is no function of the letter.

        So are the time itself and what changes in it.
        """
        sides = (side.xreplace(self.shown) for side in equation.sides)
        made = Equation(*sides, relation=equation.relation)
        timely = equation.symbols & {TIME}
        for x in timely | made.symbols - letters.numbers - {TIME, const, *_all(self.rates)}:
            raise RefusedError("nothing says what {} is as a function of {}", x, self.letter)
        return made

    def known(self, each: Known, letters: Letters) -> Known:
        """What is cited, by this clock."""
        return replace(each, equations=tuple(self.equation(e, letters) for e in each.equations))

    def move(self, move: Move, letters: Letters) -> Move:
        """An integration from values where the letter is 0, as one over time."""
        _, *starts = move.by
        return replace(
            move,
            verb="integrate",
            of=tuple(self.known(each, letters) for each in move.of),
            using=tuple(self.known(each, letters) for each in move.using),
            by=tuple(self.equation(each, letters) for each in starts),
        )

    def condition(self, each: Condition) -> Condition:
        """A condition in the letters of the page."""
        return replace(each, expression=self._back(each.expression))

    def problem(self, error: RefusedError) -> RefusedError:
        """What went wrong, in the letters of the page."""
        return RefusedError(error.message, *map(self._back, error.nodes))

    def _back(self, node: Any) -> Any:
        if isinstance(node, Equation):
            return Equation(*map(self._back, node.sides), relation=node.relation)
        back = {new: old for old, new in self.shown.items()}
        for _ in self.shown:  # d²u/dφ² is a slope of a slope
            node = node if isinstance(node, str) else node.xreplace(back)
        return node


def _all(rates: Mapping[Symbol, Symbol]) -> set[Symbol]:
    return {*rates, *rates.values()}
