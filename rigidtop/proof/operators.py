"""Operators: matrices by their letters, which do not commute, or written out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import sympy
from sympy import Add, Expr, Integer, MatrixBase, Mul, Symbol

from rigidtop.proof.equation import NoMeaningError
from rigidtop.proof.letters import Letters
from rigidtop.proof.values import Value, Vector, has_operators


@dataclass(frozen=True)
class Operators:
    """Computes with operators; `known` has the values that are put in for atoms."""

    letters: Letters
    known: Mapping[Expr, Value] = field(default_factory=dict)

    def operator(self, letter: Symbol) -> Value:
        """An operator, or what is put in for it or for its transpose."""
        if self._is_symmetric(letter):
            return _base(letter)
        if letter in self.known:
            return self.known[letter]
        flipped = self._flipped(letter)
        return self.transposed(self.known[flipped]) if flipped in self.known else letter

    def atom(self, node: Expr) -> Value:
        """An atom, or what is put in for it."""
        return self.known.get(node, node)

    def matrices(self, left: Value, right: Value) -> Value:
        """A product of scalars, operators and matrices."""
        written = [isinstance(side, MatrixBase) for side in (left, right)]
        if all(written) and left.shape[1] != right.shape[0]:
            raise NoMeaningError("matrices of different sizes are multiplied")
        if any(written):
            if has_operators(*(s for s in (left, right) if not isinstance(s, MatrixBase))):
                raise NoMeaningError("a matrix that is written out times one that is not")
            return left * right
        return self.shortened(left * right) if has_operators(left, right) else left * right

    def shortened(self, product: Expr) -> Expr:
        """A product of operators with what is known of products put in, such as OᵀO = 1."""
        for old, new in self.known.items():
            if isinstance(old, Mul) and not old.is_commutative and not isinstance(new, MatrixBase):
                product = sympy.expand(product.subs(old, new))
        return product

    def transposed(self, operator: Value) -> Value:
        if isinstance(operator, MatrixBase):
            return operator.T
        if isinstance(operator, Vector):
            raise NoMeaningError("a vector is transposed")
        made: Expr = Integer(0)
        for term in Add.make_args(sympy.expand(operator)):
            scalars, factors = term.args_cnc()
            made += Mul(*scalars, *(self._flipped(f) for f in reversed(factors)))
        return made

    def determinant(self, operator: Value) -> Expr:
        """Of a product the product of those of its factors; each has a letter for its own."""
        if isinstance(operator, Vector):
            raise NoMeaningError("the determinant of a vector")
        if isinstance(operator, MatrixBase):
            if operator.rows != operator.cols:
                raise NoMeaningError("the determinant of what is no square matrix")
            return operator.det(method="berkowitz")
        scalars, factors = operator.args_cnc()
        named = {x.name: det for x, det in self.letters.determinants.items()}
        made: Expr = Integer(1)
        for base, power in (factor.as_base_exp() for factor in factors):
            letter = named.get(str(base).removesuffix("ᵀ"))
            if letter is None:
                raise NoMeaningError("a determinant that has no letter")
            made *= self.atom(letter) ** power
        if Mul(*scalars) != 1:
            raise NoMeaningError("a determinant that has no letter")
        return made

    def _flipped(self, factor: Expr) -> Expr:
        base, power = factor.as_base_exp()
        if self._is_symmetric(base):
            return _base(base) ** power
        name = base.name[:-1] if base.name.endswith("ᵀ") else base.name + "ᵀ"
        return Symbol(name, commutative=False) ** power

    def _is_symmetric(self, letter: Expr) -> bool:
        """Whether what is put in says that an operator is its own transpose."""
        base = _base(letter)
        flipped = Symbol(base.name + "ᵀ", commutative=False)
        return bool(self.known.get(base) == flipped or self.known.get(flipped) == base)


def _base(letter: Expr) -> Symbol:
    """An operator's letter, without its ᵀ."""
    return Symbol(letter.name.removesuffix("ᵀ"), commutative=False)
