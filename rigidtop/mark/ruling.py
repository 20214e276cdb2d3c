"""What becomes of an equation in the place of what a claim prints there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy
from sympy import Expr, Symbol

from rigidtop.proof.counterexample import Counterexample, is_refuted
from rigidtop.proof.equation import Equation, Meaning, Underbrace, as_printed, symbols_of, value
from rigidtop.proof.letters import Letters
from rigidtop.proof.page import Check, Definition, Evidence
from rigidtop.proof.verdict import Finding, UnneededAssumptionError, Verdict, judge_check
from rigidtop.read.equations import kind
from rigidtop.report import plain
from rigidtop.report.claims import refuted, sides
from rigidtop.theory.symbols import const, phi, phidot, psi, psidot, theta, thetadot
from rigidtop.typeset.text import text

ORDER = list(Verdict)
HOLDS = (Verdict.DEFINITION, Verdict.PROVED, Verdict.SAMPLED, Verdict.ASSUMING)
_RATES = {phi: phidot, theta: thetadot, psi: psidot}
"""Where a claim speaks of the rate of an angle and not of the angle, that may have any value."""


@dataclass(frozen=True)
class Ruling:
    """What became of one equation: a finding, or the reason why there is none.

    `instead` is what the claim prints in its place, where that says something else.
    """

    finding: Finding | None
    problem: str = ""
    instead: Equation | None = None
    known: bool = False
    """Whether the claim itself prints what is false, and says so."""

    @property
    def verdict(self) -> Verdict:
        return self.finding.verdict if self.finding is not None else Verdict.UNDECIDED

    @property
    def wrong(self) -> bool:
        """Refuted or undecided, and not as the collection has it."""
        return self.verdict in (Verdict.FALSE, Verdict.UNDECIDED) and not self.known


def check_of(item: Evidence) -> Check:
    """A definition as a check: its left side means its right side, and vectors are any vectors."""
    if isinstance(item, Check):
        return item
    assert isinstance(item, Definition)
    left, *others = item.equation.sides
    meaning = {symbol: any_value(symbol) for symbol in symbols_of(item.equation)}
    meaning[left] = value(others[0], meaning)
    return Check(item.equation, meaning, reason=item.reason)


def any_value(node: Expr) -> Any:
    """A letter or a derivative as a number, a vector or a matrix of which nothing is known."""
    rows, columns = {"vector": (3, 1), "matrix": (3, 3)}.get(kind(node), (0, 0))
    if not rows:
        return node if isinstance(node, Symbol) else Symbol(text(node), real=True)
    name = text(node)
    entries = [Symbol(f"{name}_{k}", real=True) for k in range(rows * columns)]
    return sympy.Matrix(rows, columns, entries)


def judged(equation: Equation, check: Check, letters: Letters) -> Ruling:
    """A read equation with the meaning and under the assumptions of a check."""
    known = _known_symbols(check)
    rulings = [_one(replace(check, claimed=e), known, letters) for e in asserted(equation, check)]
    worst = max(rulings, key=lambda ruling: ORDER.index(ruling.verdict))
    if worst.finding is None:
        return worst
    return replace(worst, finding=replace(worst.finding, check=replace(check, claimed=equation)))


def _one(check: Check, known: frozenset[Symbol], letters: Letters) -> Ruling:
    free = {angle for angle, rate in _RATES.items() if rate in known}
    strangers = sorted(symbols_of(check.claimed) - known - free, key=str)
    unsaid = f"the claim does not say what {_listed(strangers)} is here" if strangers else ""
    spatial = {x: any_value(x) for x in strangers if kind(x) != "scalar"}
    try:
        clash = _clash(check.claimed, {**check.meaning, **spatial})
        if clash:
            return Ruling(Finding(check, Verdict.FALSE), clash)
        if spatial:
            return Ruling(None, unsaid)
        # With a value at will for a symbol that the claim does not know, nothing is refuted.
        if strangers and is_refuted(check, 40, letters):
            return Ruling(None, unsaid)
        finding = _lightest(check, letters)
    except Exception as error:
        # What was typed can be anything, and SymPy's errors are many; none of them is a pass.
        return Ruling(None, unsaid or f"it has no meaning in this claim ({_brief(error)})")
    if strangers and finding.verdict not in HOLDS:
        return Ruling(None, unsaid)
    return Ruling(finding)


def _brief(error: Exception) -> str:
    said = " ".join(str(error).split())
    return f"{type(error).__name__}: {said}"[:120]


def _listed(symbols: Sequence[Symbol]) -> str:
    return ", ".join(map(text, symbols))


def _known_symbols(check: Check) -> frozenset[Symbol]:
    """The symbols that mean something in a claim."""
    expressions = [*check.meaning, *check.meaning.values(), *check.given]
    expressions += [assumption.condition for assumption in check.assuming]
    for meant in check.meaning.values():
        if isinstance(meant, (list, tuple)):  # the terms of a sum
            expressions += [symbol for term in meant for symbol in term]
    known = symbols_of(check.claimed) | {const}
    return known.union(*(getattr(e, "free_symbols", ()) for e in expressions))


def _clash(equation: Equation, meaning: Meaning) -> str:
    """Words for sides that can't be equal whatever their values; 0 fits every shape."""
    shapes: dict[tuple[int, ...], None] = {}
    for side in equation.sides:
        if side == const:
            continue
        meant = value(side, meaning)
        if meant != 0:
            shapes[getattr(meant, "shape", ())] = None
    if len(shapes) < 2:
        return ""
    return " and ".join(map(_shape, shapes)) + " can't be equal"


def _shape(shape: tuple[int, ...]) -> str:
    if not shape:
        return "a number"
    if 1 not in shape:
        return "a matrix"
    return "a row" if shape[0] == 1 else "a vector"


def _lightest(check: Check, letters: Letters) -> Finding:
    """The finding with those assumptions only that the equation needs."""
    try:
        return judge_check(check, letters)
    except UnneededAssumptionError:
        for assumption in check.assuming:
            others = tuple(other for other in check.assuming if other is not assumption)
            finding = _lightest(replace(check, assuming=others), letters)
            if finding.verdict in HOLDS:
                return finding
        # Shown under all of them, only that none can be spared was not.
        return Finding(check, Verdict.ASSUMING)


def asserted(equation: Equation, check: Check) -> list[Equation]:
    """What an equation says: itself, and what stands under its braces.

    A brace over a name says what the name is; where neither is one, the two sides are equal.
    """
    braces = sorted(
        set().union(*(side.atoms(Underbrace) for side in equation.sides)),
        key=sympy.default_sort_key,
    )
    turned: dict[Expr, Expr] = {}
    beneath = []
    for brace in braces:
        body, label = brace.args
        if label in check.meaning:
            continue
        if body in check.meaning:
            with as_printed():
                turned[brace] = Underbrace(label, body)
        else:
            beneath.append(Equation(body, label))
    if not turned:
        return [equation, *beneath]
    with as_printed():
        sides = [side.xreplace(turned) for side in equation.sides]
    return [Equation(*sides, relation=equation.relation, tag=equation.tag), *beneath]


# --- Words ---------------------------------------------------------------------------------------


def refutation(found: Finding, counterexample: Counterexample) -> str:
    """The numbers that refute a line: two sides that differ, or a rate that does not vanish."""
    at, left, right = refuted(counterexample)
    said = plain.rich(sides(left, right))
    if counterexample.left == counterexample.right and counterexample.left is not None:
        said = "it does not hold"
    elif left == right != "undefined":
        said = "it does not hold, by less than the digits that are shown"
    rate = counterexample.right == 0 and found.check.claimed.sides[-1] == const
    if rate and left != "undefined":
        said = f"what is to be constant changes at the rate {plain.rich((left,))}"
    return f"{plain.rich(at)}: {said}" if at else said
