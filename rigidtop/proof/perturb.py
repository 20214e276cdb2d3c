"""Small changes of a printed equation, each of which must make it fall.

A claim that still passes with a sign, a factor, an exponent, an index or a function changed is not
being checked.  Changes that leave an equation saying the same are not among them: two changed
signs, or λ₂ for λ₁ where the two are assumed equal.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, Symbol, cos, sin
from sympy.matrices.exceptions import ShapeError

from rigidtop.proof.equation import (
    Cross,
    Equation,
    Rate,
    SumOver,
    Transposed,
    Underbrace,
    VolumeIntegral,
    as_printed,
    value,
)
from rigidtop.proof.page import Check
from rigidtop.proof.verdict import entries
from rigidtop.theory import symbols as s

_FAMILIES: tuple[tuple[Symbol, ...], ...] = (
    (s.lambda1, s.lambda2, s.lambda3),
    (s.omega1, s.omega2, s.omega3),
    (s.omega1dot, s.omega2dot, s.omega3dot),
    (s.theta, s.phi, s.psi),
    (s.thetadot, s.phidot, s.psidot),
    (s.e1p, s.e2p, s.e3),
    (s.xhat, s.yhat, s.zhat),
    (s.L1, s.L3),
    (s.L_z, s.L3),
    (s.p_phi, s.p_psi),
    (s.Omega_minus, s.Omega_plus),
    (s.M, s.g, s.R),
    (s.c_phi, s.c_theta, s.c_psi),
    (s.s_phi, s.s_theta, s.s_psi),
    (s.A_matrix, s.B_matrix, s.C_matrix),
    (s.a, s.b),
    (s.M_1, s.M_2),
)
"""Symbols that a slip of the pen exchanges."""


@dataclass(frozen=True)
class Perturbation:
    """A changed equation and what was changed."""

    equation: Equation
    change: str


def perturbations(equation: Equation) -> Iterator[Perturbation]:
    """Every single change of sign, factor, exponent, index, function or term, side by side."""
    for position, side in enumerate(equation.sides):
        neighbours = equation.sides[max(position - 1, 0) : position + 2]
        to_vanish = any(_is_zero(other) for other in neighbours if other is not side)
        for changed, change in _changed_side(side, to_vanish):
            sides = (*equation.sides[:position], changed, *equation.sides[position + 1 :])
            new = Equation(*sides, relation=equation.relation, tag=equation.tag)
            yield Perturbation(new, change)


def _is_zero(side: Any) -> bool:
    if isinstance(side, sympy.MatrixBase):
        return bool(side.is_zero_matrix)
    return bool(side in (0, s.const))


def telling(check: Check) -> Iterator[Perturbation]:
    """The perturbations of a check's equation that do not say the same thing.

    An inequality stays true under many changes; of it only the relation is turned round.
    """
    claimed = check.claimed
    if claimed.relation in _OPPOSITE:
        opposite = _OPPOSITE[claimed.relation]
        yield Perturbation(
            replace_relation(claimed, opposite), f"{opposite} for {claimed.relation}"
        )
        return
    for perturbation in perturbations(claimed):
        try:
            same = _same(check, perturbation.equation)
        except (ShapeError, TypeError, AttributeError):
            continue  # the square of a vector and the like: not an equation any more
        if not same:
            yield perturbation


_OPPOSITE = {"≠": "=", ">": "<", "<": ">"}


def replace_relation(equation: Equation, relation: str) -> Equation:
    """The same sides with another relation between them."""
    return Equation(*equation.sides, relation=relation, tag=equation.tag)


def perturbed(check: Check, perturbation: Perturbation) -> Check:
    """The check with the changed equation in place of its own."""
    return replace(check, claimed=perturbation.equation)


def _changed_side(side: Any, to_vanish: bool) -> Iterator[tuple[Any, str]]:
    """`to_vanish`: the side is said to be zero or constant, and a bare name is so at any scale."""
    if isinstance(side, sympy.MatrixBase):
        entries = list(side)
        for k, entry in enumerate(entries):
            if to_vanish and entry.is_Atom:
                continue
            for changed, change in _changed(entry, entry.is_Atom):
                new = [*entries[:k], changed, *entries[k + 1 :]]
                yield sympy.ImmutableMatrix(*side.shape, new), f"entry {k + 1}: {change}"
    elif not (to_vanish and _is_name(side)):
        yield from _changed(side, False)


def _is_name(side: Any) -> bool:
    base, exponent = side.as_base_exp()
    return bool(base.is_Symbol and exponent.is_number) or isinstance(side, Rate)


def _changed(node: Any, only_names: bool) -> Iterator[tuple[Any, str]]:
    # Built as lists: a generator that pauses inside the context would leave it on for its caller.
    with as_printed():
        here = list(_exchanged(node) if only_names else _changed_here(node))
    yield from here
    if isinstance(node, Rate):
        return  # one thing with a meaning of its own
    for k, argument in enumerate(node.args):
        if _is_label(node, k):
            continue
        for changed, change in _changed(argument, only_names):
            with as_printed():
                rebuilt = node.func(*node.args[:k], changed, *node.args[k + 1 :])
            yield rebuilt, change


def _is_label(node: Any, k: int) -> bool:
    """The label of a brace, the index of a sum and the measure of an integral assert nothing."""
    return (isinstance(node, Underbrace) and k == 1) or (
        isinstance(node, (SumOver, VolumeIntegral)) and k == 0
    )


def _exchanged(node: Any) -> Iterator[tuple[Any, str]]:
    for family in _FAMILIES:
        if node in family:
            yield from ((other, f"{other} for {node}") for other in family if other != node)


def _changed_here(node: Any) -> Iterator[tuple[Any, str]]:
    if node == 0 or node == s.const:
        return
    if isinstance(node, Add):
        for k, term in enumerate(node.args):
            others = (*node.args[:k], *node.args[k + 1 :])
            yield Add(*node.args[:k], -term, *node.args[k + 1 :]), f"sign of {term}"
            yield (Add(*others) if len(others) > 1 else others[0]), f"{term} dropped"
            yield Add(*node.args[:k], 2 * term, *node.args[k + 1 :]), f"twice {term}"
    elif isinstance(node, Pow):
        base, exponent = node.args
        yield Pow(base, exponent + 1), f"exponent of {base}"
        yield Mul(node, Integer(-1)), f"sign of {node}"
    elif isinstance(node, Symbol):
        yield from _exchanged(node)
        yield Mul(Integer(2), node), f"twice {node}"
        yield Mul(Integer(-1), node), f"sign of {node}"
        yield Mul(node, node), f"square of {node}"
    elif isinstance(node, (sin, cos)):
        yield (cos if isinstance(node, sin) else sin)(*node.args), f"the other function in {node}"
        yield Mul(Integer(-1), node), f"sign of {node}"
        yield Pow(node, Integer(2)), f"square of {node}"
    elif isinstance(node, Rate):
        yield Mul(Integer(-1), node), f"sign of {node}"
    elif isinstance(node, Cross):
        yield Cross(node.args[1], node.args[0]), "factors of × exchanged"
    elif isinstance(node, Transposed):
        yield node.args[0], "transposition dropped"
    elif node.is_Number:
        yield node + 1, f"{node + 1} for {node}"
        yield Mul(Integer(-1), node), f"sign of {node}"


def _same(check: Check, changed: Equation) -> bool:
    """Whether the changed equation says the same: its differences are a multiple of the old ones.

    Compared at random meanings of the symbols, vectors for vectors and matrices for matrices, that
    know nothing of the engine; so a hole in the engine can't make a change look harmless.
    """
    rng = random.Random(3)
    factors: list[set[Expr]] = []
    for _ in range(3):
        meaning = _random_meaning(check, rng)
        old = _differences(check.claimed, meaning)
        new = _differences(changed, meaning)
        if len(old) != len(new):
            return False
        pairs = [(a, b) for a, b in zip(old, new, strict=True) if (a, b) != (0, 0)]
        if any(a == 0 or b == 0 for a, b in pairs):
            return False
        factors.append({b / a for a, b in pairs})
    return factors[0] == factors[1] == factors[2] and len(factors[0]) <= 1


def _random_meaning(check: Check, rng: random.Random) -> dict[Any, Any]:
    """A random value for every symbol, of the shape that its meaning in the check has."""

    def number() -> Rational:
        return Rational(rng.randint(2, 97), rng.randint(2, 97))

    def like(meant: Any) -> Any:
        if isinstance(meant, sympy.MatrixBase):
            return sympy.Matrix(*meant.shape, [number() for _ in meant])
        if isinstance(meant, (list, tuple)):
            return [{key: like(part) for key, part in term.items()} for term in meant]
        return meant if callable(meant) else number()

    inside = {
        symbol
        for m in check.meaning.values()
        if isinstance(m, (list, tuple))
        for term in m
        for symbol in term
    }
    plain = {x for side in check.claimed.sides for x in side.free_symbols} - inside
    family = {x for row in _FAMILIES for x in row}
    meaning: dict[Any, Any] = {x: number() for x in sorted(plain | family, key=str)}
    meaning |= {key: like(meant) for key, meant in check.meaning.items()}
    for assumption in check.assuming:
        condition = assumption.condition
        if isinstance(condition, sympy.Eq) and condition.lhs in meaning:
            meaning[condition.lhs] = value(condition.rhs, meaning)
    return meaning


def _differences(equation: Equation, meaning: dict[Any, Any]) -> list[Expr]:
    values = [side if side == s.const else value(side, meaning) for side in equation.sides]
    differences: list[Expr] = []
    for left, right in zip(values, values[1:], strict=False):
        if right == s.const:
            differences += list(left) if isinstance(left, sympy.MatrixBase) else [left]
        else:
            differences += [sympy.nsimplify(d) for d in entries(left, right)]
    return differences
