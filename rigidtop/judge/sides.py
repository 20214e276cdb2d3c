"""Sides of a statement as they are written: the letters in them, and what kind of thing each is."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace

from sympy import Expr, MatrixBase
from sympy.core.function import AppliedUndef

from rigidtop.judge.jets import jets
from rigidtop.judge.letters import CLOCK
from rigidtop.judge.names import function_name
from rigidtop.judge.values import Value
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement

EQUALS = ("=", "≡")
NEARLY = ("≈", "∼")
CONDITIONS = ("≠", "<", ">", "≤", "≥", "≪", "≫")

ZERO = n.Number("0")

# --- Letters -------------------------------------------------------------------------------------


def named(node: Node) -> tuple[Letter | None, tuple[Node, ...]]:
    """The letter that a side is, with the places behind it."""
    if isinstance(node, n.Primed) and isinstance(node.of, Letter):
        return replace(node.of, mark=node.of.mark + "′" * node.order), ()
    if isinstance(node, Letter):
        return node, ()
    if isinstance(node, n.Call) and isinstance(node.function, Letter):
        simple = all(isinstance(n.ungrouped(x), (Letter, n.TimeDerivative)) for x in node.places)
        if simple:
            return node.function, () if node.places == (CLOCK,) else node.places
    return None, ()


def own_letters(node: Node) -> frozenset[Letter]:
    """The letters of a side but for π and the time."""
    return n.letters(node) - {Letter("π"), CLOCK}


def letters_in(statement: Statement) -> frozenset[Letter]:
    """The letters of all sides of a statement."""
    return frozenset().union(*map(own_letters, statement.sides))


def letters_of(expression: Expr) -> set[Letter]:
    """The letters that an expression means."""
    return {jet.letter for jet in jets(expression).values()}


def entries(value: Value) -> list[Expr]:
    """The components of a vector or a matrix, or the number itself."""
    return list(value) if isinstance(value, MatrixBase) else [value]


def moving_in(statement: Statement) -> frozenset[Letter]:
    """The letters of which a statement says how they move, if it says more than what a rate is."""
    if isinstance(statement.sides[0], Letter) and CLOCK in n.letters(statement.sides[-1]):
        return frozenset(statement.sides[:1])  # type: ignore[arg-type]
    if is_setting(statement.sides[0], statement.sides[-1], ()):
        return frozenset()
    rates = (
        x for side in statement.sides for x in n.walked(side) if isinstance(x, n.TimeDerivative)
    )
    return frozenset().union(*(n.letters(x.of) for x in rates))


def speaks_of(value: Value, letter: Letter, functions: bool = False) -> bool:
    """Whether a letter occurs in what is meant, with `functions` also as an unknown function."""
    if functions and any(
        function_name(letter) == str(f.func) for x in entries(value) for f in x.atoms(AppliedUndef)
    ):
        return True
    return any(letter in letters_of(x) for x in entries(value))


# --- Kinds ---------------------------------------------------------------------------------------


def has_components(statement: Statement) -> bool:
    """Whether a column of three components, or a square of nine, stands in it."""
    return any(
        isinstance(x, n.Component)
        or (isinstance(x, n.Tuple) and len(x.entries) == 3)
        or (isinstance(x, n.Matrix) and len(x.rows) == 3 and len(x.rows[0]) in (1, 3))
        for side in statement.sides
        for x in n.walked(side)
    )


def is_start(node: Node) -> bool:
    """Whether it is what a letter is at one time, as in x(0)."""
    return (
        isinstance(node, n.Call) and len(node.places) == 1 and isinstance(node.places[0], n.Number)
    )


def is_setting(left: Node, right: Node, definitions: Collection[Letter]) -> bool:
    """Whether a letter or a rate is given a number or another letter."""
    bare = left.of if isinstance(left, n.TimeDerivative) and left.dotted else left
    if bare is not left and bare in definitions:
        return False
    value = n.ungrouped(right)
    while isinstance(value, n.Negative):
        value = value.of
    if bare is not left and isinstance(value, n.TimeDerivative) and isinstance(value.of, Letter):
        value = value.of if value.of.base == getattr(bare, "base", "") else value
    is_named = isinstance(bare, Letter) or is_start(left)
    return is_named and (isinstance(value, (n.Number, Letter)) or is_start(value))


def gives_all_a_value(statement: Statement) -> bool:
    """Whether it gives one number to several letters or rates: ω₁ = ω₂ = 0."""
    *sides, value = statement.sides
    bare = (x.of if isinstance(x, n.TimeDerivative) and x.dotted else x for x in sides)
    are_named = all(isinstance(x, Letter) or is_start(x) for x in bare)
    return are_named and isinstance(value, n.Number) and {*statement.relations} == {"="}


def with_constant_last(statement: Statement) -> Statement:
    """A chain in which a constant stands at the end: a = const = b is a = b = const."""
    sides = [side for side in statement.sides if not isinstance(side, n.Constant)]
    if len(sides) in (len(statement.sides), 0) or not {*statement.relations} <= {*EQUALS}:
        return statement
    constant = n.Constant()
    return replace(statement, sides=(*sides, constant), relations=("=",) * len(sides))


def with_ratio(statement: Statement, moving: Collection[Letter]) -> Statement:
    """What A ∝ B says if they move: that A/B is constant."""
    if statement.relations != ("∝",) or not letters_in(statement) & {*moving, CLOCK}:
        return statement
    left, right = map(n.Bracketed, statement.sides)
    return replace(statement, sides=(n.Quotient(left, right), n.Constant()), relations=("=",))


# --- Signs ---------------------------------------------------------------------------------------


def other_root(node: Node) -> Node:
    """A root with the other sign."""
    return n.Negative(node) if isinstance(node, n.Root) else node


def without_places(statement: Statement) -> Statement:
    """A chain without a side that says what its letter depends on: r = r(q₁, q₂) = x i + y j."""
    head, *others = statement.sides
    said = [k for k, x in enumerate(others) if isinstance(x, n.Call) and x.function == head]
    if len(others) < 2 or not said or len(said) == len(others):
        return statement
    kept = [k for k in range(len(others)) if k not in said]
    sides = (head, *(others[k] for k in kept))
    return replace(statement, sides=sides, relations=tuple(statement.relations[k] for k in kept))


def says_its_places(statement: Statement) -> bool:
    """Whether a letter is said to depend on others, and no more: L = L(q, q̇, t)."""
    left, *_, right = statement.sides
    alone = len(statement.sides) == 2 and statement.relations[0] in EQUALS
    return (
        alone and isinstance(right, n.Call) and isinstance(left, Letter) and right.function == left
    )


def braces(statement: Statement) -> Iterator[n.Braced]:
    """The braces of a statement below which stands what the part is equal to, and no count."""
    found = (x for side in statement.sides for x in n.walked(side) if isinstance(x, n.Braced))
    for brace in found:
        is_count = isinstance(brace.label, n.Number) and brace.label != ZERO
        if brace.label is not None and not is_count:
            yield brace


def is_acceleration(node: Node) -> bool:
    """Whether it is a second rate in time."""
    return isinstance(node, n.TimeDerivative) and node.order == 2
