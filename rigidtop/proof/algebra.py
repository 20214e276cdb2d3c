"""Printed trees as things to compute with: scalars, vectors, operators.

A *scalar* is a SymPy expression.  Its atoms are letters and what stands for itself: the product of
two vectors, ∂ℒ/∂θ̇, the rate of a letter.  A *vector* is a sum of such atoms with scalars before
them, ``ω₁e₁ + ω × L``, never three components: what is said of vectors holds in every frame.  An
*operator* is a matrix by its letter, which does not commute, or written out.

What is known of a letter comes with the `Letters` of the subject; there is no top here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import reduce
from typing import Any

import sympy
from sympy import Add, Dummy, Expr, Integer, MatrixBase, Mul, Pow, Symbol, srepr

from rigidtop.proof.equation import (
    BODY,
    Cross,
    Dot,
    Group,
    IntegralOver,
    Matrices,
    NoMeaningError,
    Partial,
    Printed,
    Rate,
    Slope,
    Transposed,
    Underbrace,
)
from rigidtop.proof.operators import Operators
from rigidtop.proof.sums import (
    SUMS,
    indices,
    is_vector,
    linear,
    linear_factors,
    order_of,
    parted,
    varies,
)
from rigidtop.proof.values import (
    ELLIPTIC,
    TIME,
    ZERO,
    Applied,
    Value,
    Vector,
    antiderivative,
    flattened,
    has_operators,
    is_zero,
    without_zeros,
)
from rigidtop.theory.rates import slope
from rigidtop.theory.symbols import unit


@dataclass(frozen=True)
class Algebra(Operators):
    """Computes with printed trees; `known` has the values that are put in for atoms."""

    # --- trees -------------------------------------------------------------------------------

    def value(self, node: Expr) -> Value:
        """What a printed tree says, with what is known put in."""
        if isinstance(node, Vector):
            return self.total(
                self.times(self.value(factor), self.value(atom))
                for atom, factor in node.terms.items()
            )
        node = sympy.sympify(node)
        if isinstance(node, MatrixBase):
            return self._written_out(node)
        if self.known or not node.args:
            return self._value(node)
        kept = self.letters.values
        if node not in kept:
            value = self._value(node)
            # A matrix may be changed; what an integral finds to be zero is to be heard each time.
            if isinstance(value, MatrixBase) or node.has(IntegralOver):
                return value
            kept[node] = value
        return kept[node]

    def _value(self, node: Expr) -> Value:
        if node in self.known:
            return self.known[node]
        if isinstance(node, Symbol):
            return self._letter(node) if node.is_commutative else self.operator(node)
        if not node.args:
            return node
        if isinstance(node, (Group, Underbrace)):
            return self.value(node.args[0])
        if isinstance(node, Printed):
            return self._printed(node)
        parts = [self.value(part) for part in node.args]
        if isinstance(node, Add):
            return self.total(parts)
        if isinstance(node, Mul):
            made = parts[0]
            for part in parts[1:]:
                made = self.times(made, part)
            return made
        if isinstance(node, Pow) and isinstance(parts[0], Vector):
            if parts[1] != 2:
                raise NoMeaningError("a power of a vector other than its square")
            return self.dot(parts[0], parts[0])
        if any(isinstance(part, Vector) for part in parts):
            raise NoMeaningError(f"{node.func.__name__} of a vector")
        if isinstance(node, ELLIPTIC):
            parts = [sympy.factor(part) for part in parts]
        return node.func(*parts)

    def _letter(self, letter: Symbol) -> Value:
        if letter in self.letters.vectors:
            return Vector({letter: Integer(1)})
        if letter == unit:
            return Integer(1)
        if letter in self.letters.operators:
            return self.operator(Symbol(letter.name, commutative=False))
        return letter

    def _written_out(self, matrix: MatrixBase) -> Value:
        entries = matrix.applyfunc(self.value)
        if matrix.shape == (3, 1) and self.letters.body:
            # A column is one of components along the axes of the body.
            return Vector(dict(zip(self.letters.body, entries, strict=True)))
        return entries

    def _printed(self, node: Printed) -> Value:
        if isinstance(node, Partial):
            return self.atom(node)  # one atom: what is put in does not reach into it
        if isinstance(node, SUMS):
            return self.summed(node, self.value(node.args[1]))
        if isinstance(node, IntegralOver):
            return self.integrated(*node.args)
        if isinstance(node, Rate):
            return self.rate(self.value(node.args[0]), node.args[1] if len(node.args) > 1 else None)
        if isinstance(node, Slope):  # what is put in does not change what is differentiated
            bare = Algebra(self.letters)
            return self.value(bare.slope(*map(bare.value, node.args)))
        parts = [self.value(part) for part in node.args]
        if isinstance(node, Cross):
            return self.cross(*parts)
        if isinstance(node, Dot):
            return self.dot(*parts)
        if isinstance(node, Transposed):
            return self.transposed(parts[0])
        if isinstance(node, Matrices):
            return reduce(self.times, parts)
        if isinstance(node, Applied):
            return self.times(*parts)
        raise NoMeaningError(f"no meaning for {type(node).__name__}")

    # --- sums and products -------------------------------------------------------------------

    def total(self, parts: Any) -> Value:
        """The sum; 0 fits every kind."""
        made: Value = Integer(0)
        for part in parts:
            if is_zero(made):
                made = part
            elif is_zero(part):
                continue
            elif isinstance(made, Vector) != isinstance(part, Vector):
                raise NoMeaningError("a vector and a scalar are added")
            elif isinstance(made, MatrixBase) != isinstance(part, MatrixBase):
                scalar, matrix = (part, made) if isinstance(made, MatrixBase) else (made, part)
                if has_operators(scalar):
                    raise NoMeaningError("a matrix that is written out and one that is not")
                made = matrix + scalar * sympy.eye(matrix.shape[0])
            else:
                made = made + part
        return made

    def times(self, left: Value, right: Value) -> Value:
        if isinstance(left, Vector) and isinstance(right, Vector):
            raise NoMeaningError("two vectors side by side: · or × between them?")
        turned = isinstance(left, Vector)
        if turned:
            left, right = right, left
        if not isinstance(right, Vector):
            return self.matrices(left, right)
        if isinstance(left, MatrixBase):
            raise NoMeaningError("a matrix that is written out acts on no vector without a frame")
        if left.is_commutative:
            return right.times(left)
        if turned:
            raise NoMeaningError("a vector before a matrix")
        return self.total(self._applied(term, right) for term in Add.make_args(sympy.expand(left)))

    def _applied(self, term: Expr, vector: Vector) -> Vector:
        """A product of operators, with a scalar before it, acting on a vector."""
        scalars, factors = self.shortened(term).args_cnc()
        made: Value = vector
        for base, power in (factor.as_base_exp() for factor in reversed(factors)):
            for _ in range(power):
                made = self.total(
                    self._image(base, atom).times(before) for atom, before in made.terms.items()
                )
                made = made if isinstance(made, Vector) else ZERO
        return _as_vector(made.times(Mul(*scalars)))

    def _image(self, operator: Expr, atom: Expr) -> Vector:
        """What an operator makes of an atom."""
        if isinstance(atom, Applied):
            operator, atom = self.shortened(operator * atom.args[0]), atom.args[1]
            scalars, factors = operator.args_cnc()
            if scalars or not factors or operator.is_Add:
                return _as_vector(self.times(operator, self._one(atom)))
        return _as_vector(self.atom(Applied(operator, atom)))

    def dot(self, left: Value, right: Value) -> Expr:
        if is_zero(left) or is_zero(right):
            return Integer(0)
        if not (isinstance(left, Vector) and isinstance(right, Vector)):
            raise NoMeaningError("a scalar product of what is no vector")
        return Add(
            *(
                p * q * self._dot_atoms(a, b)
                for a, p in left.terms.items()
                for b, q in right.terms.items()
            )
        )

    def _dot_atoms(self, a: Expr, b: Expr) -> Expr:
        for frame in self.letters.frames:
            if a in frame and b in frame:
                return Integer(int(a == b))
        if isinstance(a, Applied) or isinstance(b, Applied):
            return self._dot_images(a, b)
        for vector, other in ((a, b), (b, a)):
            if isinstance(vector, SUMS) and self._bilinear(vector, other):
                return self._summed_scalar(vector, self._dotted(vector.args[1], other))
        if isinstance(b, Cross) and not isinstance(a, Cross):
            a, b = b, a
        if isinstance(a, Cross):
            if isinstance(b, Cross):  # (a × b)·(c × d) = (a·c)(b·d) − (a·d)(b·c)
                (p, q), (u, v) = a.args, b.args
                dot = self._dot_atoms
                return dot(p, u) * dot(q, v) - dot(p, v) * dot(q, u)
            three = (*a.args, b)
            if len(set(three)) < 3:
                return Integer(0)
            order = sorted(range(3), key=lambda k: srepr(three[k]))
            sign = 1 if order in ([0, 1, 2], [1, 2, 0], [2, 0, 1]) else -1
            x, y, z = (three[k] for k in order)
            return sign * self.atom(Dot(Cross(x, y), z))
        return self._ordered(a, b)

    def _dot_images(self, a: Expr, b: Expr) -> Expr:
        """Pu·Qv = u·(PᵀQ)v = v·(QᵀP)u, the one of the two that comes first."""
        (p, u), (q, v) = (x.args if isinstance(x, Applied) else (Integer(1), x) for x in (a, b))
        operator = self.shortened(self.transposed(p) * q)
        back = self.shortened(self.transposed(operator))
        for left, made, right in ((u, operator, v), (v, back, u)):
            if made.is_commutative:
                return made * self._dot_atoms(left, right)
            image = self.times(made, self._one(right))
            if set(image.terms) != {Applied(made, right)}:
                return self.dot(self._one(left), image)
        _, left, right, made = min(
            (srepr(sympy.Tuple(u, v, operator)), u, v, operator),
            (srepr(sympy.Tuple(v, u, back)), v, u, back),
            key=lambda found: found[0],
        )
        return self.atom(Dot(left, Applied(made, right)))

    def _ordered(self, a: Expr, b: Expr) -> Expr:
        named = self.letters.components
        made = named.get((a, b)) or named.get((b, a))
        return self.atom(made or Dot(*sorted((a, b), key=srepr)))

    def cross(self, left: Value, right: Value) -> Vector:
        if is_zero(left) or is_zero(right):
            return ZERO
        if not (isinstance(left, Vector) and isinstance(right, Vector)):
            raise NoMeaningError("a vector product of what is no vector")
        terms = (
            self._cross_atoms(a, b).times(p * q)
            for a, p in left.terms.items()
            for b, q in right.terms.items()
        )
        return _as_vector(self.total(terms))

    def _cross_atoms(self, a: Expr, b: Expr) -> Vector:
        if a == b:
            return ZERO
        for frame in self.letters.frames:
            if a in frame and b in frame:
                i, j = frame.index(a), frame.index(b)
                sign = 1 if (j - i) % 3 == 1 else -1
                return Vector({frame[3 - i - j]: Integer(sign)})
        if isinstance(b, Cross):  # a × (u × v) = u(a·v) − v(a·u)
            u, v = b.args
            return Vector({u: self._dot_atoms(a, v)}) + Vector({v: -self._dot_atoms(a, u)})
        if isinstance(a, Cross):
            return self._cross_atoms(b, a).times(Integer(-1))
        sign = 1
        if srepr(b) < srepr(a):
            a, b, sign = b, a, -1
        return _as_vector(self.atom(Cross(a, b))).times(Integer(sign))

    # --- sums over particles, integrals over a body ------------------------------------------

    def summed(self, node: Expr, body: Value) -> Value:
        """Σ or ∫ of a value: linear, and what does not change from part to part comes out."""
        if isinstance(body, Vector):
            return self.total(
                self._summed_term(node, term, atom)
                for atom, factor in body.terms.items()
                for term in Add.make_args(sympy.expand(factor))
            )
        return Add(*(self._summed_scalar(node, t) for t in Add.make_args(sympy.expand(body))))

    def _exchanged(self, node: Expr, term: Expr) -> Value | None:
        """Σ of a term with another Σ as a factor that is written outside: first here, then there.

        None where there is no such factor, or where its index stands elsewhere in the term too.
        """
        for inner in linear_factors(term):
            if not isinstance(inner, SUMS) or term.count(inner) != 1:
                continue
            bound = inner.args[0]
            mixed = varies(inner, node, self.letters) and order_of(inner) < order_of(node)
            if mixed and bound not in indices(term.xreplace({inner: Integer(1)}), self.letters):
                body = self.value(term.xreplace({inner: inner.args[1]}))
                return self.summed(inner, self.summed(node, body))
        return None

    def _summed_term(self, node: Expr, term: Expr, atom: Expr) -> Vector:
        outside, inside = parted(node, term, self.letters)
        turned = self._exchanged(node, Mul(inside, atom, evaluate=False))
        if turned is not None:
            return _as_vector(self.times(outside, turned))

        def changes(part: Expr) -> bool:
            return varies(part, node, self.letters)

        if not changes(atom):
            return Vector({atom: outside * self._summed_scalar(node, inside)})
        if isinstance(atom, Cross) and not all(map(changes, atom.args)):
            a, b = atom.args
            if changes(a):
                return self.cross(self._summed_term(node, inside, a), self._one(b)).times(outside)
            return self.cross(self._one(a), self._summed_term(node, inside, b)).times(outside)
        made = self.atom(node.func(node.args[0], Mul(inside, atom)))
        return _as_vector(made).times(outside)

    def _one(self, atom: Expr) -> Vector:
        return Vector({atom: Integer(1)})

    def _summed_scalar(self, node: Expr, term: Expr) -> Expr:
        outside, inside = parted(node, term, self.letters)
        turned = self._exchanged(node, inside)
        if turned is not None:
            return outside * turned
        dots = linear(node, inside, self.letters)
        if len(dots) == 1:  # of several none is the one that comes out
            [product] = dots
            a, b = product.args
            varying, fixed = (a, b) if varies(a, node, self.letters) else (b, a)
            rest = Mul(*(f for f in Mul.make_args(inside) if f is not product))
            return outside * self.dot(self._summed_term(node, rest, varying), self._one(fixed))
        return outside * self.atom(node.func(node.args[0], inside))

    def _bilinear(self, vector: Expr, other: Expr) -> bool:
        """Whether Σ m(r·u)r stands before ·v: the sum of m(r·u)(r·v), alike in u and v."""
        if varies(other, vector, self.letters):
            return False
        return bool(linear(vector, vector.args[1], self.letters))

    def _dotted(self, term: Expr, other: Expr) -> Expr:
        """A scalar times an atom, · another atom."""
        [atom] = [f for f in Mul.make_args(term) if is_vector(f, self.letters)]
        scalar = Mul(*(f for f in Mul.make_args(term) if f is not atom))
        return scalar * self._dot_atoms(atom, other)

    def integrated(self, variable: Symbol, low: Expr, high: Expr, body: Expr) -> Expr:
        """The integral of a scalar, by a primitive where one is known, else as it stands."""
        bound = Dummy(real=True)
        flat, nodes = flattened(self.value(body.xreplace({variable: bound})))
        if any(node.has(bound) for node in nodes.values()):
            raise NoMeaningError("an integral over what stands in a product or a rate")
        primitive = antiderivative(flat, bound)
        ends = [self.value(end) for end in (low, high)]
        if primitive is None:
            return self.atom(
                IntegralOver(variable, *ends, flat.xreplace({**nodes, bound: variable}))
            )
        return (primitive.subs(bound, ends[1]) - primitive.subs(bound, ends[0])).xreplace(nodes)

    # --- rates -------------------------------------------------------------------------------

    def rate(self, value: Value, frame: Expr | None = None) -> Value:
        """d/dt along the motion; of vectors as seen from space, or from the body."""
        if isinstance(value, Vector):
            parts: list[Value] = []
            for atom, factor in value.terms.items():
                parts.append(Vector({atom: self._scalar_rate(factor)}))
                parts.append(self._atom_rate(atom, frame).times(factor))
            return without_zeros(self.total(parts))
        if isinstance(value, MatrixBase):
            return value.applyfunc(self._scalar_rate)
        if not value.is_commutative:
            raise NoMeaningError("the rate of an operator")
        return self._scalar_rate(value)

    def slope(self, value: Value, by: Expr) -> Value:
        """The derivative along the motion by what changes in time, where its rate is not 0."""
        rate = self.rate(by)
        if rate == 0:
            raise NoMeaningError(f"a derivative by {by}, which does not change")
        return self.times(1 / rate, self.rate(value))

    def _scalar_rate(self, expression: Expr) -> Expr:
        flat, atoms = flattened(expression)
        parts = (slope(flat, x) * self._rate_of(x, atoms) for x in flat.free_symbols)
        return Add(*parts).xreplace(atoms)

    def _rate_of(self, x: Symbol, atoms: Mapping[Symbol, Expr]) -> Expr:
        node = atoms.get(x, x)
        if node in self.letters.numbers:
            return Integer(0)
        if node == TIME:
            return Integer(1)
        if isinstance(node, Dot):
            a, b = (self._node_vector(part) for part in node.args)
            return self.dot(self.rate(a), b) + self.dot(a, self.rate(b))
        if isinstance(node, SUMS):
            return self.summed(node, self._scalar_rate(node.args[1]))
        if isinstance(node, ELLIPTIC):  # the chain rule
            rates = map(self._scalar_rate, node.args)
            return Add(*(node.fdiff(k) * rate for k, rate in enumerate(rates, 1) if rate != 0))
        if node in self.letters.rates:
            return self.atom(self.letters.rates[node])
        if node in self.letters.fixed_components:
            axis, vector = self.letters.fixed_components[node]
            return self.dot(self._one(axis), self._atom_rate(vector, None))
        if node in self.letters.functions:  # the chain rule
            known = self.letters.functions[node]
            return Add(*(self.atom(Partial(node, y)) * self._rate_of(y, {}) for y in known))
        return self.atom(Rate(node))

    def _node_vector(self, node: Expr) -> Vector:
        if isinstance(node, Cross):
            return self.cross(*(self._node_vector(part) for part in node.args))
        return Vector({node: Integer(1)})

    def _atom_rate(self, atom: Expr, frame: Expr) -> Vector:
        """The rate of a vector that is an atom."""
        seen = frame if frame == BODY else None
        if seen is None and atom in self.letters.numbers:
            return ZERO
        if seen == BODY and atom in self.letters.body:
            return ZERO
        if isinstance(atom, Cross):
            a, b = atom.args
            first = self.cross(self._atom_rate(a, frame), self._one(b))
            second = self.cross(self._one(a), self._atom_rate(b, frame))
            return _as_vector(self.total([first, second]))
        if isinstance(atom, SUMS):
            factors = Mul.make_args(atom.args[1])
            [inner] = [f for f in factors if is_vector(f, self.letters)]
            scalar = Mul(*(f for f in factors if f is not inner))
            return _as_vector(self.summed(atom, self.rate(Vector({inner: scalar}), frame)))
        if seen is None:
            return _as_vector(self.atom(self.letters.rates.get(atom, Rate(atom))))
        return _as_vector(self.atom(Rate(atom, seen)))


def _as_vector(made: Value) -> Vector:
    """What stands for an atom, as a vector: it may be 0."""
    if isinstance(made, Vector):
        return made
    return ZERO if made == 0 else Vector({made: Integer(1)})
