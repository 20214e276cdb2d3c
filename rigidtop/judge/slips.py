"""The changes that a pen makes: what a statement would say with one sign, factor or letter else."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise

from rigidtop.judge.letters import is_mass
from rigidtop.judge.particles import PARTICLES
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node, Number
from rigidtop.tree.plain import plain

MOST = 900
"""No more changes of one statement are tried."""

_FUNCTIONS = {
    "sin": ("cos", "tan"), "cos": ("sin",), "tan": ("sin", "cot"), "cot": ("tan",),
    "sinh": ("cosh",), "cosh": ("sinh",),
}  # fmt: skip


@dataclass(frozen=True)
class Change:
    """A statement with one thing changed, and what that is in words."""

    left: Node
    right: Node
    words: str
    rank: float


def changes(
    left: Node,
    right: Node,
    known: frozenset[Letter],
    moving: frozenset[Letter],
    letter: Letter | None = None,
    indices: frozenset[str] = frozenset(),
    sums: frozenset[n.Sum] = frozenset(),
) -> list[Change]:
    """The likeliest first; with `letter` only those that put another letter in its place.

    `known` are letters that may be put in, `moving` those that have rates; no letter is exchanged
    for one that differs in an index of `indices`, of which a sum says what it means.  Of a letter
    may be one of `sums` in which it stands, as R − a.
    """
    names = n.letters(left) | n.letters(right)
    found = []
    for side, other, is_left in ((right, left, False), (left, right, True)):
        whole = not (is_left and _is_name(left)) and not _is_zero(other)
        for node, words, rank in _changed(side, names, known, moving, letter, whole):
            sides = (node, other) if is_left else (other, node)
            found.append(Change(*sides, words, rank + 0.1 * is_left))
        for node, words, rank in _everywhere(side, lambda x: _in_sums(x, sums)):
            sides = (node, other) if is_left else (other, node)
            found.append(Change(*sides, words, rank))
    if indices:
        found = [each for each in found if not _exchanges(each, left, right, indices)]
    return sorted(found, key=lambda change: change.rank)[:MOST]


def _exchanges(change: Change, left: Node, right: Node, indices: frozenset[str]) -> bool:
    """Whether letters that count have come in or gone with a letter."""
    before, after = (
        n.letters(left) | n.letters(right),
        n.letters(change.left) | n.letters(change.right),
    )
    return any(indices & {*letter.sub} for letter in before ^ after)


def _changed(
    side: Node,
    names: frozenset[Letter],
    known: frozenset[Letter],
    moving: frozenset[Letter],
    letter: Letter | None,
    whole: bool,
) -> Iterator[tuple[Node, str, float]]:
    if letter is not None:
        for other in sorted(known - {letter}, key=str):
            if other.bold == letter.bold and letter in n.letters(side):
                words = f"{plain(other)} in place of {plain(letter)}"
                yield n.replaced(side, letter, other), words, 1.0
        return
    yield from _everywhere(side, lambda node: _single(node, names, known, moving))
    yield from _times(side, names, known, moving, whole)
    angles = {n.ungrouped(x.of) for x in n.walked(side) if isinstance(x, n.Apply)}
    for angle in sorted(angles, key=plain):
        swapped = _swapped(side, angle)
        if swapped != side:
            yield swapped, f"sine and cosine of {plain(angle)} exchanged", 3.5


def _everywhere(
    side: Node, local: Callable[[Node], Iterator[tuple[Node, str, float]]]
) -> Iterator[tuple[Node, str, float]]:
    """Every tree in which one node is replaced by what `local` offers for it."""
    for new, words, rank in local(side):
        yield new, words, rank
    below = n.parts(side)
    for k, part in enumerate(below):
        if isinstance(side, (n.Total, n.Integral)) and k > 0:
            continue  # what is counted or integrated over has no name of its own
        for new, words, rank in _everywhere(part, local):
            yield n.rebuilt(side, [*below[:k], new, *below[k + 1 :]]), words, rank


def _single(
    node: Node, names: frozenset[Letter], known: frozenset[Letter], moving: frozenset[Letter]
) -> Iterator[tuple[Node, str, float]]:
    match node:
        case n.Sum(terms):
            for k, term in enumerate(terms):
                turned = term.of if isinstance(term, n.Negative) else n.Negative(term)
                words = f"another sign before {plain(_bare(term))}"
                yield n.Sum((*terms[:k], turned, *terms[k + 1 :])), words, 0.0
                rest = (*terms[:k], *terms[k + 1 :])
                left = n.Sum(rest) if len(rest) != 1 else rest[0]
                if len(rest) > 1 or (rest and all(isinstance(x, Letter) for x in terms)):
                    yield left, f"no {plain(_bare(term))}", 5.0 if len(rest) > 1 else 2.85
        case n.Product(factors) if len(factors) > 1:
            for k, factor in enumerate(factors):
                if isinstance(factor, (Letter, n.Apply, Number)):
                    rest = (*factors[:k], *factors[k + 1 :])
                    without = n.Product(rest) if len(rest) > 1 else rest[0]
                    rank = 0.95 if isinstance(factor, Number) else 2.08
                    yield without, f"no factor {plain(factor)}", rank
            for k, pair in enumerate(pairwise(factors)):
                if all(isinstance(x, Letter) and not x.bold for x in pair):
                    square = n.Power(n.Bracketed(n.Product(pair)), Number("2"))
                    rest = (*factors[:k], square, *factors[k + 2 :])
                    squared = n.Product(rest) if len(rest) > 1 else square
                    yield squared, f"{plain(n.Product(pair))} squared", 2.3
        case n.Number(text):
            value = node.value
            for other in (2 * value, value / 2, value + 1, value - 1, 3 * value, value / 3):
                if other > 0:
                    yield _number(other), f"{other} in place of {text}", 1.5
            if value > 1:
                yield n.Root(node), f"the root of {text}", 2.6
            for other in (value + 2, value - 2):
                if other > 0:
                    yield _number(other), f"{other} in place of {text}", 1.9
        case n.Apply(name, of):
            for other_name in _FUNCTIONS.get(name, ()):
                yield n.Apply(other_name, of), f"{other_name} in place of {name}", 2.0
            squared = n.Power(node, Number("2"))
            yield squared, f"{plain(squared)} in place of {plain(node)}", 2.35
            if isinstance(of, Letter):
                twice = n.Apply(name, n.Product((Number("2"), of)))
                yield twice, f"{plain(twice)} in place of {plain(node)}", 3.0
        case n.Power(base, exponent) if not isinstance(exponent, Number):
            words = f"another sign before {plain(_bare(exponent))}"
            yield n.Power(base, _negated(exponent)), words, 0.3
        case n.Power(base, exponent) if isinstance(exponent, Number):
            for other in (exponent.value + 1, exponent.value - 1):
                new = base if other == 1 else n.Power(base, _number(other))
                if other > 0:
                    yield new, f"{plain(new)} in place of {plain(node)}", 2.0
            if exponent.value == 2 and isinstance(base, Letter):
                for letter in sorted(names - {base}, key=str):
                    alike = letter.base == base.base or (is_mass(letter) and is_mass(base))
                    if alike and letter.bold == base.bold:
                        mixed = n.Product((base, letter))
                        yield mixed, f"{plain(mixed)} in place of {plain(node)}", 2.4
            inner = n.ungrouped(base)
            if exponent.value == 2 and isinstance(inner, n.Sum):
                each = n.Bracketed(n.Sum(tuple(map(_squared, inner.terms))))
                yield each, f"{plain(each)} in place of {plain(node)}", 2.3
            if exponent.value == 2:
                yield n.Power(base, Number("4")), f"the fourth power of {plain(base)}", 3.0
        case Letter():
            yield n.Power(node, Number("2")), f"{plain(node)} squared", 2.05
            if node in moving:
                yield n.TimeDerivative(node, 1, True), f"a dot on {plain(node)}", 2.8
            for other_letter in sorted(known | names, key=str):
                alike = replace(other_letter, mark=node.mark) == node
                near = other_letter.base == node.base
                looks = (
                    near
                    or {node, other_letter} <= moving | names
                    or _look_alike(node.base, other_letter.base)
                )
                if looks and not alike and other_letter.bold == node.bold:
                    words = f"{plain(other_letter)} in place of {plain(node)}"
                    yield other_letter, words, 2.4 if near else 3.2
                alike_in_kind = near or node.base.swapcase() == other_letter.base
                if alike_in_kind and node.base in "mMkJI":  # m + M, and k₁ + k₂
                    both = n.Bracketed(n.Sum((node, other_letter)))
                    if not alike and not node.bold and not other_letter.bold:
                        yield both, f"{plain(both.of)} in place of {plain(node)}", 2.7
        case n.TimeDerivative(of, order) if order > 0:
            if order > 1:
                yield n.TimeDerivative(of, order - 1, True), f"{order - 1} dot on {plain(of)}", 2.8
            elif node.dotted:
                yield of, f"no dot on {plain(of)}", 2.8
            yield n.TimeDerivative(of, order + 1, node.dotted), f"one more dot on {plain(of)}", 3.0
        case n.CrossProduct(left, right):
            yield n.CrossProduct(right, left), "the factors of × exchanged", 1.0
        case n.Bracketed(n.Sum()):
            yield n.Power(node, Number("2")), f"{plain(node)} squared", 3.0
        case n.TransposedMatrix(of):
            yield of, "no transpose", 1.0
        case n.Root(of, _):
            yield of, "no root", 3.0
        case n.Quotient(over, under):
            if isinstance(under, n.Sum):
                square = n.Power(n.Bracketed(under), Number("2"))
                yield n.Quotient(over, square), f"{plain(n.Bracketed(under))} squared", 3.0
                for term in {_bare(x) for x in under.terms} - {over}:
                    words = f"{plain(term)} in place of {plain(over)}"
                    yield n.Quotient(term, under), words, 2.5
            yield n.Quotient(under, over), "the fraction turned over", 3.0
            count = [x for x in _factors(over) if not n.letters(x) - {Letter("π")}]
            others = [x for x in _factors(over) if x not in count]
            if count and others and n.letters(under):
                turned = n.Quotient(n.Product((*count, *_factors(under))), _joined(others))
                yield turned, f"{plain(turned)} in place of {plain(node)}", 2.9
            if n.letters(node):
                yield n.Power(n.Bracketed(node), Number("2")), f"{plain(node)} squared", 2.2
            yield from _exchanged(over, under)
            yield from _of_the_other_sum(over, under)


def _in_sums(node: Node, sums: frozenset[n.Sum]) -> Iterator[tuple[Node, str, float]]:
    """For a letter the sums in which it stands: R − a for R."""
    if isinstance(node, Letter):
        for each in sorted(sums, key=plain):
            if node in map(_bare, each.terms):
                yield n.Bracketed(each), f"{plain(each)} in place of {plain(node)}", 2.6


def _of_the_other_sum(over: Node, under: Node) -> Iterator[tuple[Node, str, float]]:
    """A fraction with a term of the sum above or below that the other one lacks."""
    above, below = _summands(over), _summands(under)
    for term in (x for x in below if x not in above and len(below) > 1):
        yield n.Quotient(n.Sum((*above, term)), under), f"{plain(_bare(term))} above, too", 2.9
    for term in (x for x in above if x not in below and len(above) > 1):
        yield n.Quotient(over, n.Sum((*below, term))), f"{plain(_bare(term))} below, too", 2.9


def _summands(node: Node) -> tuple[Node, ...]:
    bare = n.ungrouped(node)
    return bare.terms if isinstance(bare, n.Sum) else (bare,)


def _exchanged(over: Node, under: Node) -> Iterator[tuple[Node, str, float]]:
    """A fraction in which a factor above and one below have changed places."""
    above, below = _factors(over), _factors(under)
    if len(above) == len(below) == 1:
        return
    for one in (x for x in above if n.letters(x)):
        for other in (x for x in below if n.letters(x) and x != one):
            up = _joined([other if x is one else x for x in above])
            down = _joined([one if x is other else x for x in below])
            yield n.Quotient(up, down), f"{plain(one)} and {plain(other)} exchanged", 2.95


def _factors(node: Node) -> tuple[Node, ...]:
    return node.factors if isinstance(node, n.Product) else (node,)


def _joined(factors: list[Node]) -> Node:
    return n.Product(tuple(factors)) if len(factors) > 1 else factors[0]


_ALIKE = tuple(map(frozenset, ("θϑΘ", "φϕϐψΦΨ", "ωΩw", "lℓL", "vνuV", "pρP", "aαA", "γyr")))
"""Letters that a pen takes for each other, apart from small ones for capitals."""


def _look_alike(one: str, other: str) -> bool:
    """Whether a letter is easily taken for another one: in its shape, or as P beside Q."""
    neighbours = len(one) == len(other) == 1 and abs(ord(one) - ord(other)) == 1
    shapes = any({one, other} <= each for each in _ALIKE)
    return neighbours or shapes or one.lower() == other.lower()


def _times(
    side: Node,
    names: frozenset[Letter],
    known: frozenset[Letter],
    moving: frozenset[Letter],
    whole: bool,
) -> Iterator[tuple[Node, str, float]]:
    """A sign, a factor or a letter more or less on one term or entry, or on the `whole`."""
    near = [*sorted(names, key=str), *sorted(known - names, key=str)]
    scalars = [x for x in near if not x.bold and x.base not in "πt"][:12]
    factors: list[tuple[Node, str, float]] = [
        (Number("2"), "2", 1.0),
        (n.Quotient(Number("1"), Number("2")), "½", 1.0),
        (Number("3"), "3", 2.6),
        (n.Quotient(Number("1"), Number("3")), "⅓", 2.6),
        (n.Quotient(Number("2"), Number("3")), "⅔", 2.7),
        (n.Quotient(Number("4"), Number("3")), "4/3", 2.7),
        (n.Quotient(Number("3"), Number("2")), "3/2", 2.7),
        (Number("4"), "4", 2.7),
        (n.Quotient(Number("1"), Number("4")), "¼", 2.7),
    ]
    factors += [(x, plain(x), 2.1) for x in scalars]
    factors += [(n.Quotient(Number("1"), x), f"1/{plain(x)}", 2.3) for x in scalars]
    factors += [
        (n.TimeDerivative(x, 1, True), f"the rate of {plain(x)}", 2.9)
        for x in scalars
        if x in moving
    ]
    for name in ("sin", "cos"):
        for x in scalars:
            if any(isinstance(a, n.Apply) and n.ungrouped(a.of) == x for a in n.walked(side)):
                yes = n.Apply(name, x)
                factors.append((yes, plain(yes), 2.4))
                factors.append((n.Quotient(Number("1"), yes), f"1/{plain(yes)}", 2.6))

    # How many particles are taken for a sum says nothing of the sum.
    counted = any(isinstance(x, n.Total) for x in n.walked(side))
    number = Number(str(PARTICLES))
    shares = (number, n.Quotient(Number("1"), number)) if counted else ()
    factors = [x for x in factors if x[0] not in shares]

    def local(node: Node) -> Iterator[tuple[Node, str, float]]:
        for k, term in enumerate(_terms(node)):
            yield from _scaled(node, k, term, factors)

    bare = side.of if isinstance(side, n.TimeDerivative) else side
    if whole and not isinstance(bare, (n.Sum, n.Tuple, n.Matrix, Number)):
        yield _negated(side), "another sign", 0.2
        yield n.Root(side), "the root of it", 2.5
        for factor, words, rank in factors:
            if not _cancels(factor, side):
                yield _product(factor, side), f"{words} times as much", rank
    yield from _everywhere(side, local)


def _is_name(side: Node) -> bool:
    """Whether it is a letter or a rate of one, which has no factor."""
    return isinstance(side.of if isinstance(side, n.TimeDerivative) else side, Letter)


def _cancels(factor: Node, side: Node) -> bool:
    """Whether a factor is one over what the side is, or over a factor of it."""
    return isinstance(factor, n.Quotient) and factor.under in _factors(side)


def _terms(node: Node) -> tuple[Node, ...]:
    """What can have a factor of its own: terms, entries, and what stands below a fraction."""
    match node:
        case n.Sum(terms):
            return terms
        case n.Root(of) if not isinstance(of, n.Sum):
            return (of,)
        case n.Tuple(entries):
            return entries
        case n.Matrix(rows):
            return tuple(x for row in rows for x in row)
        case n.Quotient():
            return ()
    return ()


def _scaled(
    node: Node, k: int, term: Node, factors: list[tuple[Node, str, float]]
) -> Iterator[tuple[Node, str, float]]:
    below = list(n.parts(node))
    if _is_zero(term):
        return
    if not isinstance(node, n.Sum):
        yield (
            n.rebuilt(node, [*below[:k], _negated(term), *below[k + 1 :]]),
            f"another sign before {plain(_bare(term))}",
            0.3,
        )
    for factor, words, rank in factors:
        bare = _bare(term)
        new = _product(factor, bare)
        if isinstance(term, n.Negative):
            new = n.Negative(new)
        elif isinstance(term, n.PlusMinus):
            new = replace(term, of=new)
        told = f"{words} times {plain(bare)}"
        if isinstance(bare, Number) and isinstance(factor, Number):
            product = _number(factor.value * bare.value)
            told = f"{plain(product)} in place of {plain(bare)}"
            new = n.Negative(product) if isinstance(term, n.Negative) else product
        yield n.rebuilt(node, [*below[:k], new, *below[k + 1 :]]), told, rank


def _swapped(side: Node, angle: Node) -> Node:
    """With sine and cosine of an angle exchanged everywhere."""
    names = {"sin": "cos", "cos": "sin"}

    def swap(node: Node) -> Node:
        if isinstance(node, n.Apply) and n.ungrouped(node.of) == angle:
            return replace(node, name=names.get(node.name, node.name))
        return node

    return n.mapped(side, swap)


def _squared(term: Node) -> Node:
    """A term squared, with its sign."""
    if isinstance(term, n.Negative):
        return n.Negative(_squared(term.of))
    return term if term == Number("1") else n.Power(term, Number("2"))


def _negated(side: Node) -> Node:
    """The same with another sign, without two signs in a row."""
    if isinstance(side, n.Negative):
        return side.of
    return n.Negative(n.Bracketed(side) if isinstance(side, n.Sum) else side)


def _product(factor: Node, side: Node) -> Node:
    """The same times a factor, whose sign stands in front."""
    if isinstance(side, n.Negative):
        return n.Negative(_product(factor, side.of))
    if isinstance(side, n.Product):
        return n.Product((factor, *side.factors))
    return n.Product((factor, n.Bracketed(side) if isinstance(side, n.Sum) else side))


def times(factor: Fraction, side: Node) -> Node:
    """A side times a number, which goes together with one that stands in front."""
    if factor < 0:
        return _negated(times(-factor, side))
    match side:
        case n.Negative(of):
            return n.Negative(times(factor, of))
        case n.Product((n.Number() as first, *rest)):
            return n.Product((_number(factor * first.value), *rest))
        case n.Product((n.Quotient(n.Number() as over, n.Number() as under), *rest)):
            return n.Product((_number(factor * over.value / under.value), *rest))
    return _product(_number(factor), side)


def _bare(term: Node) -> Node:
    return term.of if isinstance(term, (n.Negative, n.PlusMinus)) else term


def _number(value: Fraction) -> Node:
    if value.denominator == 1:
        return Number(str(value.numerator))
    return n.Quotient(Number(str(value.numerator)), Number(str(value.denominator)))


def _is_zero(node: Node) -> bool:
    return isinstance(node, Number) and node.value == 0
