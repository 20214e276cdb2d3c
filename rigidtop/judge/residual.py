"""An expression that vanishes where all holds that a text says."""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr

from rigidtop.judge.context import PREMISE, Constraint


@dataclass(frozen=True, eq=False)
class Residual:
    """An expression that vanishes, and the statements that say so."""

    expression: Expr
    rests_on: frozenset[int]
    kind: str = PREMISE
    constraint: Constraint | None = None
    instant: str = ""
