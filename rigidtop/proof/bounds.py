"""Signs: whether an expression differs from zero or exceeds it, where conditions hold.

Factors of known sign decide; the answer "yes" is a proof, "no" is that it is not known.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache

import sympy
from sympy import Expr, Matrix
from sympy.core.relational import Relational

from rigidtop.proof.decide import in_digits, vanishes
from rigidtop.theory.polynomial import CACHED
from rigidtop.theory.trig import reduce_ratio


def divided_by(slopes: Matrix) -> list[Expr]:
    """The factors by which the last row is divided where it is a sum of multiples of the others.

    >>> r, x = sympy.symbols("r x")
    >>> divided_by(Matrix([[r**2, 0], [0, x], [r, x]])), divided_by(Matrix([[r], [r**2]]))
    ([r], [])
    """
    factors = slopes[:-1, :].T.LUsolve(slopes[-1, :].T)
    below = [sympy.fraction(reduce_ratio(factor))[1] for factor in factors]
    return list(dict.fromkeys(x for each in below for x in _factors(each) if x.free_symbols))


def nonzero(expression: Expr, conditions: Sequence[Relational] = ()) -> bool:
    """True only if every factor is known to differ from zero, by its symbols or a condition.

    >>> from sympy import sin
    >>> x, m = sympy.Symbol("x", real=True), sympy.Symbol("m", positive=True)
    >>> nonzero(m*sin(x)**2), nonzero(m*sin(x)**2, [sympy.Ne(sin(x), 0)])
    (False, True)
    """
    known = [condition.lhs - condition.rhs for condition in conditions if _strict(condition)]
    known_factors = [f for k in known for f in _factors(reduce_ratio(k))]
    return all(
        factor.is_nonzero or any(_are_alike(factor, k) for k in known_factors)
        for factor in _factors(reduce_ratio(expression))
    )


def _are_alike(one: Expr, other: Expr) -> bool:
    """Whether two expressions are the same but for their signs: most are told apart by numbers."""
    gap = one**2 - other**2
    return in_digits([("=", gap)]) is not False and vanishes(gap)


def positive(expression: Expr, conditions: Sequence[Relational] = ()) -> bool:
    """True only if the sign of every factor is known and their product is positive.

    >>> a, b = sympy.symbols("a b", real=True)
    >>> positive((a - b)**3, [sympy.Gt(a, b)]), positive(a - b)
    (True, False)
    """
    # A point where it is negative tells this sooner than its factors do.
    if _is_negative_somewhere(expression, conditions):
        return False
    ratio = reduce_ratio(expression)
    # A sum of squares is one as it is written, and no longer where they are expanded.
    if expression.is_positive or ratio.is_positive or _sign(ratio, conditions) == 1:
        return True
    # A condition may bound a product that stands in the ratio as a whole.
    return any(_sign(reduce_ratio(ratio / fact), conditions) == 1 for fact in _facts(conditions))


def sign(expression: Expr, conditions: Sequence[Relational] = ()) -> int:
    """1 or −1 where an expression is shown to have this sign, else 0."""
    return next((k for k in (1, -1) if positive(k * expression, conditions)), 0)


def without_bars(expression: Expr, sign_of: Callable[[Expr], int]) -> Expr:
    """An expression with x or −x for each |x| of which the sign is known.

    >>> x, y = sympy.symbols("x y", real=True)
    >>> without_bars(abs(x) + abs(y), lambda size: -1 if size == x else 0)
    -x + Abs(y)
    """

    def bare(size: Expr) -> Expr:
        known = sign_of(size)
        return known * size if known else sympy.Abs(size)

    return expression.replace(sympy.Abs, bare)


def _is_negative_somewhere(expression: Expr, conditions: Sequence[Relational]) -> bool:
    """Whether numbers at a few points where bounds hold refute that an expression is positive."""
    bounds = [c.gts - c.lts for c in conditions if isinstance(c, _BOUNDS)]
    return in_digits([("≥", expression)], bounds=bounds) is False


_BOUNDS = (sympy.Gt, sympy.Lt, sympy.Ge, sympy.Le)


def nonnegative(expression: Expr, conditions: Sequence[Relational] = ()) -> bool:
    """True only if every term is known not to be negative.

    >>> a, b = sympy.symbols("a b", real=True)
    >>> nonnegative(a**2 + b**2), nonnegative(2*a - 2*b), nonnegative(2*a - 2*b, [a >= b])
    (True, False, True)
    """
    ratio = reduce_ratio(expression)
    return _at_least_zero(ratio, conditions) or (
        isinstance(ratio, sympy.Add)
        and all(_at_least_zero(term, conditions) for term in _grouped(ratio))
    )


def _facts(conditions: Sequence[Relational]) -> list[Expr]:
    """What the conditions say to be positive; a ≥ b together with a ≠ b is a > b."""
    strict = [c.gts - c.lts for c in conditions if isinstance(c, (sympy.Gt, sympy.Lt))]
    weak = [c.gts - c.lts for c in conditions if isinstance(c, (sympy.Ge, sympy.Le))]
    unequal = [c.lhs - c.rhs for c in conditions if isinstance(c, sympy.Ne)]
    return strict + [w for w in weak if any(sympy.expand(w**2 - u**2) == 0 for u in unequal)]


def _sign(ratio: Expr, conditions: Sequence[Relational]) -> int:
    """1 or −1 where the sign of a product is known, else 0."""
    sign = 1
    for factor in sympy.Mul.make_args(ratio):
        base, power = factor.as_base_exp()
        if power.is_even:
            known = 1 if nonzero(base, conditions) else 0
        else:
            known = _base_sign(base, conditions)
        if known == 0:
            return 0
        sign *= known
    return sign


def _base_sign(base: Expr, conditions: Sequence[Relational]) -> int:
    if base.is_positive:
        return 1
    if base.is_negative:
        return -1
    for fact in _facts(conditions):
        quotient = reduce_ratio(base / fact)
        if quotient.is_number:
            return 1 if quotient > 0 else -1
        if quotient.is_positive:
            return 1
    if isinstance(base, sympy.Add):
        for sign in (1, -1):
            terms = [sign * term for term in _grouped(base)]
            if all(_at_least_zero(t, conditions) for t in terms) and (
                any(t.is_positive or _sign(reduce_ratio(t), conditions) == 1 for t in terms)
                or any(_has_parts(terms, fact, conditions) for fact in _facts(conditions))
            ):
                return sign
    return 0


def _has_parts(terms: Sequence[Expr], fact: Expr, conditions: Sequence[Relational]) -> bool:
    """Whether terms are positive multiples of all parts of a positive sum, of which one is too."""
    return all(
        any(_sign(reduce_ratio(term / part), conditions) == 1 for term in terms)
        for part in sympy.Add.make_args(fact)
    )


@lru_cache(maxsize=CACHED)
def _grouped(total: Expr) -> tuple[Expr, ...]:
    """The terms of a sum, those with a common square of a symbol taken together."""
    factors = {f for term in total.args for f in term.args}
    squares = {f for f in factors if f.is_Pow and f.exp == 2 and not f.base.is_positive}
    for square in sorted(squares, key=str):
        grouped = sympy.collect(total, [square, *sorted(squares - {square}, key=str)])
        if isinstance(grouped, sympy.Add):
            return tuple(grouped.args)
    return tuple(total.args)


def _at_least_zero(term: Expr, conditions: Sequence[Relational]) -> bool:
    factored = reduce_ratio(term)
    bases = [f.as_base_exp() for f in sympy.Mul.make_args(factored)]
    odd = sympy.Mul(*(b**p for b, p in bases if not p.is_even))
    if odd.is_nonnegative or _sign(odd, conditions) == 1:
        return True
    weak = [c.gts - c.lts for c in conditions if isinstance(c, (sympy.Ge, sympy.Le))]
    return any(reduce_ratio(odd / fact).is_positive for fact in weak)


def _strict(condition: Relational) -> bool:
    return isinstance(condition, (sympy.Ne, sympy.Gt, sympy.Lt))


def _factors(ratio: Expr) -> list[Expr]:
    """What a ratio in lowest terms has above, of a sum what no number divides."""
    numerator, _ = sympy.fraction(ratio)
    bases = [f.as_base_exp()[0] for f in sympy.Mul.make_args(numerator)]
    return [base.primitive()[1] if base.is_Add else base for base in bases]


def lost(wanted: Expr, given: Expr, conditions: Sequence[Relational] = ()) -> list[Expr]:
    """What may vanish of that by which given = 0 is divided to make wanted = 0.

    Where it is no multiple, this is given itself.

    >>> x, y = sympy.symbols("x y", real=True)
    >>> lost(y - 1, x*(y - 1)), lost(x*(y - 1), y - 1)
    ([x], [])
    """
    if vanishes(wanted):
        return []
    factor = reduce_ratio(given / wanted)
    return [x for x in _factors(factor) if not nonzero(x, conditions)]


def vanishes_by_squares(expression: Expr, conditions: Sequence[Relational] = ()) -> bool:
    """True only if A√ρ + B is zero because A²ρ is B², and A and B are of opposite signs.

    >>> a, b = sympy.symbols("a b", positive=True)
    >>> vanishes_by_squares(sympy.sqrt(a + b + 2*sympy.sqrt(a*b)) - sympy.sqrt(a) - sympy.sqrt(b))
    True
    >>> vanishes_by_squares(sympy.sqrt(a + b - 2*sympy.sqrt(a*b)) - sympy.sqrt(a) + sympy.sqrt(b))
    False
    """
    above = sympy.expand(sympy.fraction(sympy.together(expression))[0])
    roots = [p for p in above.atoms(sympy.Pow) if p.exp == sympy.S.Half and p.base.is_Add]
    for root in sorted(roots, key=sympy.count_ops, reverse=True):
        factor, rest = above.coeff(root), above.coeff(root, 0)
        if factor == 0 or not vanishes(above - factor * root - rest):
            continue
        if vanishes(factor**2 * root.base - rest**2) and positive(-factor * rest, conditions):
            return True
    return False


def follows(residual: Expr, given: Expr, conditions: Sequence[Relational] = ()) -> bool:
    """True only if given = 0 implies residual = 0: their ratio is a factor known to be nonzero.

    >>> x, y = sympy.symbols("x y", real=True)
    >>> follows(y - 1, x*(y - 1)), follows(y - 1, x*(y - 1), [sympy.Ne(x, 0)])
    (False, True)
    """
    return not lost(residual, given, conditions)
