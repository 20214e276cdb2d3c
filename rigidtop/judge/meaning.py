"""What a formula means in a context: an expression of SymPy in the numbers of a world.

Letters that stand for something are put in, rates are taken by the chain rule, vectors are columns
of three components, and sums run over three particles.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise, product
from typing import Any, Self

import sympy
from sympy import Expr, ImmutableMatrix, MatrixBase, Rational, Symbol

from rigidtop.judge.brackets import bracket, conjugates, is_bracket
from rigidtop.judge.calculus import Calculus, put
from rigidtop.judge.jets import Jet, jets, symbol
from rigidtop.judge.names import component_of, is_vector
from rigidtop.judge.units import UNITS
from rigidtop.judge.values import (
    UnclearError,
    Value,
    added,
    crossed,
    dotted,
    length,
    matrix_product,
    multiplied,
    scaled,
    unit_times,
)
from rigidtop.judge.vocabulary import Curvature, Meant
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node


@dataclass
class Meaning(Calculus):
    """What finds the value of any formula in one context."""

    def value(self, node: Node) -> Value:
        """The value of a formula.  Raises UnclearError where it has none here."""
        if self.known is not None and id(node) in self.known:
            return self.known[id(node)]
        handler = _HANDLERS.get(type(node))
        if handler is None:
            raise UnclearError(f"{type(node).__name__.lower()} is not judged")
        return handler(self, node)

    def remembering(self, *nodes: Node) -> Self:
        """What has the values of these trees, and of all parts of them, at hand."""
        known: dict[int, Value] = {}
        for node in nodes:
            for part in reversed([*n.walked(node)]):
                try:
                    known[id(part)] = self.with_(known=known).value(part)
                except UnclearError:
                    continue
        return self.with_(known=known)


# --- one handler a kind of node ------------------------------------------------------------------


def _number(_: Meaning, node: n.Number) -> Expr:
    value: Fraction = node.value
    return Rational(value.numerator, value.denominator)


def _power(meaning: Meaning, node: n.Power) -> Value:
    e = Letter("e")
    if node.base == e and e not in meaning.context.habits.own:
        power = meaning.value(node.exponent)
        return _exponential(power) if isinstance(power, MatrixBase) else sympy.exp(power)
    base = meaning.value(node.base)
    exponent = meaning.scalar(node.exponent)
    if isinstance(base, MatrixBase):
        if base.shape[1] == 1:
            if exponent.is_Integer and exponent.is_even and exponent > 0:
                return dotted(base, base) ** (exponent / 2)
            raise UnclearError("a power of a vector")
        if not exponent.is_Integer or base.rows != base.cols:
            raise UnclearError("a power of a matrix")
    return base**exponent


def _exponential(matrix: MatrixBase) -> Value:
    """Of a matrix with two rows, by what its square is where it has no trace."""
    if matrix.shape != (2, 2):
        raise UnclearError("an exponential of a matrix that has not two rows is not judged")
    half = matrix.trace() / 2
    rest = matrix - half * sympy.eye(2)
    turn = sympy.powdenest(sympy.sqrt(rest.det().factor()), force=True)  # of J, J² = −1, it is 1
    ratio = sympy.sin(turn) / turn if turn != 0 else 1
    inner = sympy.cos(turn) * sympy.eye(2) + ratio * rest
    return ImmutableMatrix(sympy.exp(half) * inner)


def _apply(meaning: Meaning, node: n.Apply) -> Value:
    of = meaning.value(node.of)
    if node.name in ("det", "tr"):
        if not isinstance(of, MatrixBase):
            raise UnclearError(f"{node.name} of what is no matrix")
        return of.det(method="berkowitz") if node.name == "det" else of.trace()
    function = _NAMED.get(node.name)
    if function is None or isinstance(of, MatrixBase):
        raise UnclearError(f"{node.name} is not judged")
    return function(of)


def _dot(meaning: Meaning, node: n.DotProduct) -> Value:
    left, right = meaning.value(node.left), meaning.value(node.right)
    if isinstance(left, MatrixBase) and isinstance(right, MatrixBase):
        if left.shape == right.shape and left.shape[1] == 1:
            return dotted(left, right)
        return matrix_product(left, right)
    return left * right


def _cross(meaning: Meaning, node: n.CrossProduct) -> Value:
    left, right = meaning.value(node.left), meaning.value(node.right)
    vectors = isinstance(left, MatrixBase), isinstance(right, MatrixBase)
    if not any(vectors):
        if n.letters(node.left) & n.letters(node.right):
            # Nobody writes a number times itself with ×: these are vectors that nothing names so.
            raise UnclearError("× between what are no vectors of three components")
        return left * right
    if not all(vectors) or left.shape != (3, 1) or right.shape != (3, 1):
        if left == 0 or right == 0:
            return sympy.zeros(3, 1)
        raise UnclearError("× between what are no vectors of three components")
    return crossed(left, right)


def _quotient(meaning: Meaning, node: n.Quotient) -> Value:
    under = meaning.scalar(node.under)
    if under == 0:
        raise UnclearError("a division by zero")
    return scaled(meaning.value(node.over), 1 / under)


def _matrix(meaning: Meaning, node: n.Matrix) -> Value:
    if node.bracket == "|" and len(node.rows) > 1:
        return _determinant(meaning, node)
    made = ImmutableMatrix([[meaning.scalar(x) for x in row] for row in node.rows])
    return _in_space(meaning, made)


def _determinant(meaning: Meaning, node: n.Matrix) -> Value:
    """Along the first row, in which vectors may stand, as in a cross product."""
    first, *rows = node.rows
    if any(len(row) != len(node.rows) for row in node.rows):
        raise UnclearError("a determinant that is not square")
    below = ImmutableMatrix([[meaning.scalar(x) for x in row] for row in rows])
    terms = []
    for k, each in enumerate(first):
        rest = below.extract([*range(len(rows))], [j for j in range(len(first)) if j != k])
        terms.append((-1) ** k * rest.det() * meaning.value(each))
    return added(terms)


def _column(meaning: Meaning, node: n.Tuple) -> Value:
    if is_bracket(node):
        value = _poisson(meaning, *node.entries)
        if value is not None:
            return value
    return _in_space(meaning, ImmutableMatrix([meaning.scalar(x) for x in node.entries]))


def _poisson(meaning: Meaning, one: Node, other: Node) -> Expr | None:
    """The bracket of two functions, in their letters as they stand or in what these stand for."""
    names = meaning.context.letters
    momenta = frozenset(x for pair in conjugates(names) for x in pair)
    held = meaning.with_(held=meaning.held | momenta)
    for inner, f, g in product((held, meaning), _forms(meaning, one), _forms(meaning, other)):
        value = bracket(inner.scalar(f), inner.scalar(g), names)
        if value is not None:
            return meaning.context.brackets * value
    return None


def _forms(meaning: Meaning, node: Node) -> list[Node]:
    """A function, and what a text has found for it: its rates, or its momenta."""
    definition = meaning.definition(node) if isinstance(node, Letter) else None
    return [node, *(definition.also if definition is not None else ())]


def _in_space(meaning: Meaning, made: MatrixBase) -> Value:
    """Components in space of a vector, or a tensor, that is written in the axes that are meant."""
    basis = meaning.context.basis
    if basis is None or made.shape not in ((3, 1), (3, 3)):
        return made
    turned = matrix_product(basis, made)
    return turned if made.shape == (3, 1) else matrix_product(turned, basis.T)


def _curvature(meaning: Meaning, node: Curvature) -> Value:
    column = meaning.value(node.by)
    if not isinstance(column, MatrixBase) or not all(x.is_Symbol for x in column):
        raise UnclearError("derivatives by what is no column of letters")
    return ImmutableMatrix(sympy.hessian(meaning.scalar(node.of), [*column]))


def _transposed(meaning: Meaning, node: n.TransposedMatrix) -> Value:
    value = meaning.value(node.of)
    if isinstance(n.ungrouped(node.of), n.Tuple):
        return value  # a row with commas that is turned is the column that we make of it anyway
    return value.T if isinstance(value, MatrixBase) else value


def _taken(meaning: Meaning, node: n.Component) -> Value:
    value = meaning.value(node.of)
    names = "123" if node.index in "123" else "xyz"
    if isinstance(value, MatrixBase) and node.index.endswith("′"):  # along e₁′
        return meaning.scalar(n.DotProduct(node.of, component_of(Letter("e", node.index)).right))
    if not isinstance(value, MatrixBase) or node.index not in names:
        raise UnclearError("a component of what is no vector")
    basis = meaning.context.basis
    value = value if basis is None or value.shape != (3, 1) else matrix_product(basis.T, value)
    return value[names.index(node.index)]


AT_REST, IN_BODY = ("space", "inertial", "fixed"), ("body", "rot")
"""How the names of frames begin that do not turn, and of those that turn with **ω**."""


def _rate_of(meaning: Meaning, node: n.TimeDerivative) -> Value:
    if node.frame and not node.frame.startswith(AT_REST):
        if not node.frame.startswith(IN_BODY):
            raise UnclearError(f"a rate seen from {node.frame}")
        vector = meaning.value(node.of)
        turning = meaning.value(Letter("ω", bold=True))
        if not isinstance(vector, MatrixBase) or vector.shape != (3, 1):
            raise UnclearError(f"a rate seen from {node.frame} of what is no vector")
        for _ in range(node.order):
            vector = meaning.rate(vector) - crossed(turning, vector)
        return vector
    return meaning.differentiated(meaning.value(node.of), node.order)


def _at(meaning: Meaning, node: n.At) -> Value:
    value = meaning.value(node.of)
    if node.letter is None or node.value is None:
        raise UnclearError("a value at a place that is no equation")
    if node.letter == meaning.context.habits.running:
        return meaning.at_time(value, node.value)
    if node.letter in meaning.moving and any(jet.order for jet in jets(value).values()):
        raise UnclearError(f"a rate where {node.letter.base} has a value")
    return put(value, meaning.scalar(node.letter), meaning.scalar(node.value))


def _gradient(meaning: Meaning, node: n.Nabla) -> Value:
    """∇f as a column of slopes, where f is written in x, y and z."""
    places = [Letter(x) for x in "xyz"]
    if node.product or any(meaning.definition(x) is not None for x in places):
        raise UnclearError("this ∇ is not judged")
    value = meaning.scalar(node.of)
    numbers = [meaning.free(x) for x in places]
    if not value.free_symbols & {*numbers}:
        raise UnclearError("∇ of what is not written in x, y and z")
    return ImmutableMatrix([value.diff(x) for x in numbers])


def _unit(_: Meaning, node: n.Unit) -> Expr:
    known = UNITS.get(node.name)
    if known is None:
        raise UnclearError(f"the unit {node.name} is not known")
    factor, powers = known
    return factor * sympy.Mul(*(Symbol(f"unit {x}", positive=True) ** p for x, p in powers.items()))


def _product(meaning: Meaning, node: n.Product) -> Value:
    for first, behind in pairwise(node.factors):
        own = meaning.context.habits.own | meaning.context.definitions.keys()
        varied = first == Letter("δ") and first not in own
        if varied and isinstance(behind, (Letter, n.TimeDerivative)):
            raise UnclearError("a variation, δ before a letter, is not judged")
    return multiplied([meaning.value(x) for x in node.factors])


def _grouped(meaning: Meaning, node: n.Bracketed) -> Value:
    if node.bracket == "[" and isinstance(node.of, Letter):
        raise UnclearError("a dimension, a letter in square brackets, is not judged")
    return meaning.value(node.of)


def _sum(meaning: Meaning, node: n.Sum) -> Value:
    values = [meaning.value(x) for x in node.terms]
    square = next((x for x in values if isinstance(x, MatrixBase) and x.rows == x.cols > 1), None)
    if square is not None:
        values = [unit_times(_without_unit(meaning, x), square) for x in values]
    return added(values)


def _without_unit(meaning: Meaning, value: Value) -> Value:
    """A number without the letter of the unit matrix, where nothing else is said of that."""
    if isinstance(value, MatrixBase):
        return value
    free = (x for x in (Letter("E"), Letter("I"), Letter("𝟙")) if meaning.definition(x) is None)
    for x in (symbol(Jet(letter)) for letter in free):
        slope = value.diff(x)
        if slope != 0 and sympy.expand(slope * x - value) == 0:
            return slope
    return value


def _average(meaning: Meaning, node: n.Average) -> Value:
    """The mean of a letter is a number of its own; those of sums and of multiples come from it."""
    match n.ungrouped(node.of):
        case Letter() as letter if not is_vector(letter):
            return symbol(Jet(replace(letter, mark="bar")))
        case n.Sum(terms):
            return added([_average(meaning, n.Average(x)) for x in terms])
        case n.Negative(of):
            return -_average(meaning, n.Average(of))
        case n.Product(factors):
            moving = meaning.context.habits.moving | meaning.context.definitions.keys()
            still = [x for x in factors if not n.letters(x) & moving]
            rest = tuple(x for x in factors if x not in still)
            if still and rest:
                mean = n.Average(rest[0] if len(rest) == 1 else n.Product(rest))
                return multiplied([*map(meaning.value, still), _average(meaning, mean)])
    raise UnclearError("an average of what is no letter is not judged")


def _sign(meaning: Meaning, node: n.PlusMinus) -> Value:
    return (-meaning.sign if node.inverted else meaning.sign) * meaning.value(node.of)


_HANDLERS: dict[type[Node], Callable[[Meaning, Any], Value]] = {
    Letter: Meaning.letter,
    n.Number: _number,
    n.Unit: _unit,
    n.Sum: _sum,
    n.Negative: lambda m, node: -m.value(node.of),
    n.PlusMinus: _sign,
    n.Product: _product,
    n.Quotient: _quotient,
    n.Power: _power,
    n.Root: lambda m, node: m.scalar(node.of) ** Rational(1, node.degree),
    n.Apply: _apply,
    n.Call: Meaning.call,
    n.Bracketed: _grouped,
    n.Braced: lambda m, node: m.value(node.of),
    n.Average: _average,
    n.Absolute: lambda m, node: length(m.value(node.of)),
    n.TimeDerivative: _rate_of,
    n.Primed: Meaning.primed,
    n.Derivative: Meaning.derivative,
    n.DotProduct: _dot,
    n.CrossProduct: _cross,
    n.Tuple: _column,
    n.Matrix: _matrix,
    n.TransposedMatrix: _transposed,
    n.Component: _taken,
    n.Integral: Meaning.integral,
    n.Total: Meaning.total,
    n.At: _at,
    n.Nabla: _gradient,
    Curvature: _curvature,
    Meant: lambda _, node: node.value,
}

_NAMED = {
    name: getattr(sympy, name)
    for name in [
        "sin",
        "cos",
        "tan",
        "cot",
        "sec",
        "csc",
        "sinh",
        "cosh",
        "tanh",
        "coth",
        "exp",
        "asin",
        "acos",
        "atan",
        "asinh",
    ]
} | {
    "ln": sympy.log,
    "log": sympy.log,
    "arcsin": sympy.asin,
    "arccos": sympy.acos,
    "arctan": sympy.atan,
    "arccot": sympy.acot,
    "arsinh": sympy.asinh,
    "arcosh": sympy.acosh,
    "artanh": sympy.atanh,
    "Re": sympy.re,
    "Im": sympy.im,
    "sgn": sympy.sign,
}
