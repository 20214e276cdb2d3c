"""What kind of slip makes a line wrong: the one small repair after which it holds.

Every repair of a kind is tried: a sign, a factor, a power, an index, sine for cosine, φ̇ cos θ
beside ψ̇, a transposition.  If all repairs that help are of one kind, that is the slip; if they
are of several, they are candidates.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, Symbol, cos, sin

from rigidtop.derivations.letters import LETTERS
from rigidtop.notation import MATRICES
from rigidtop.proof.equation import Cross, Group, Transposed, as_printed
from rigidtop.theory import symbols as s
from rigidtop.typeset.text import text

MOST = 400
"""So many repairs of a line are tried at most."""


@dataclass(frozen=True)
class Slip:
    """`kind` is one of "sign", "factor", "power", "index", …; `words` say where."""

    kind: str
    words: str


@dataclass(frozen=True)
class Repair:
    """A slip, and the side without it."""

    slip: Slip
    side: Expr


Holds = Callable[[Any, Any], bool]


def found(left: Expr, right: Expr, holds: Holds) -> tuple[Slip, ...]:
    """The slips that would explain why left = right fails, one of a kind.

    `holds` tells whether two sides are equal, by numbers; a repair for which it raises an
    ArithmeticError, TypeError or ValueError is passed over.
    """
    made: dict[str, Slip] = {}
    tried = 0
    for first, side, other in ((True, right, left), (False, left, right)):
        for repair in repairs(side):
            tried += 1
            if tried > MOST:
                break
            if repair.slip.kind in made:
                continue
            pair = (other, repair.side) if first else (repair.side, other)
            try:
                if holds(*pair):
                    made[repair.slip.kind] = repair.slip
            except (ArithmeticError, TypeError, ValueError, AttributeError):
                continue
    return tuple(made.values())


def repairs(side: Expr) -> Iterator[Repair]:
    """A side with one thing in it put right, for every thing that could be a slip."""
    if isinstance(side, sympy.MatrixBase):
        for k, entry in enumerate(side):
            for repair in repairs(entry):
                entries = [*side[:k], repair.side, *side[k + 1 :]]
                words = f"{repair.slip.words} (entry {k + 1})"
                yield Repair(
                    Slip(repair.slip.kind, words), sympy.ImmutableMatrix(*side.shape, entries)
                )
        return
    if not isinstance(side, Add) and side not in (0, s.const):
        yield from _of_term(side, lambda new: new)
    yield from _inside(side)


def _inside(node: Expr) -> Iterator[Repair]:
    yield from _here(node)
    for k, argument in enumerate(node.args):
        if isinstance(node, Pow) and k == 1:
            continue
        for repair in _inside(argument):
            with as_printed():
                rebuilt = node.func(*node.args[:k], repair.side, *node.args[k + 1 :])
            yield Repair(repair.slip, rebuilt)


def _of_term(term: Expr, put: Callable[[Any], Any]) -> list[Repair]:
    """What can be wrong with a term as a whole."""
    shown = _shown(term)
    lost = [
        factor
        for factor in (sin(s.theta), cos(s.theta), sin(s.theta) ** 2)
        if not term.has(*factor.atoms(sin, cos))
    ]
    changed = [
        ("sign", f"the sign of {shown}", Integer(-1)),
        ("factor", f"a factor 2 at {shown}", Integer(2)),
        ("factor", f"a factor ½ at {shown}", Rational(1, 2)),
        *(("factor lost", f"{text(factor)} is missing from {shown}", factor) for factor in lost),
    ]
    made = [
        Repair(Slip(kind, words), put(Mul(factor, term, evaluate=False)))
        for kind, words, factor in changed
    ]
    kept = [k for k, factor in enumerate(Mul.make_args(term)) if isinstance(factor, (sin, cos))]
    for k in kept if isinstance(term, Mul) else ():
        words = f"{text(term.args[k])} is too much at {shown}"
        rest = Mul(*term.args[:k], *term.args[k + 1 :], evaluate=False)
        made.append(Repair(Slip("factor kept", words), put(rest)))
    return made


def _here(node: Expr) -> Iterator[Repair]:
    if isinstance(node, Add):
        for k, term in enumerate(node.args):
            if isinstance(term, Add):
                continue  # without brackets: its terms are terms of the whole sum
            before, behind = node.args[:k], node.args[k + 1 :]
            yield from _of_term(term, partial(_between, before, behind))
            rest = (*before, *behind)
            yield Repair(
                Slip("too much", f"{_shown(term)} is too much"),
                Add(*rest, evaluate=False) if len(rest) > 1 else rest[0],
            )
    elif isinstance(node, Pow) and node.exp.is_Integer and abs(node.exp) > 1:
        step = 1 if node.exp > 0 else -1
        for exponent in (node.exp - step, node.exp + step):
            yield Repair(
                Slip("power", f"the power of {text(node.base)}"), _raised(node.base, exponent)
            )
    elif isinstance(node, (sin, cos)):
        other = (cos if isinstance(node, sin) else sin)(*node.args, evaluate=False)
        yield Repair(Slip("function", f"{text(node)} where {text(other)} is meant"), other)
        yield Repair(Slip("power", f"the power of {text(node)}"), _raised(node, Integer(2)))
    elif isinstance(node, Symbol):
        yield from _of_symbol(node)
    elif isinstance(node, Transposed):
        inside = node.args[0]
        yield Repair(Slip("transpose", f"{text(node)} where {text(inside)} is meant"), inside)
    elif isinstance(node, Cross):
        a, b = node.args
        yield Repair(Slip("sign", f"the order of {text(a)} × {text(b)}"), Cross(b, a))


def _between(before: tuple[Any, ...], behind: tuple[Any, ...], term: Expr) -> Any:
    return Add(*before, term, *behind, evaluate=False)


def _raised(base: Expr, exponent: Expr) -> Any:
    return Pow(base, exponent, evaluate=False)


def _of_symbol(node: Symbol) -> Iterator[Repair]:
    if node in MATRICES and node != s.unit:
        turned = Transposed(node)
        yield Repair(Slip("transpose", f"{text(node)} where {text(turned)} is meant"), turned)
        return
    if node == s.psidot:
        spin = Group(Add(node, s.phidot * cos(s.theta), evaluate=False))
        yield Repair(Slip("spin", "φ̇ cos θ is missing beside ψ̇"), spin)
    for family in LETTERS.families:
        if node in family:
            for other in family:
                if other != node:
                    words = f"{text(node)} where {text(other)} is meant"
                    yield Repair(Slip("index", words), other)
    yield Repair(Slip("power", f"the power of {text(node)}"), _raised(node, Integer(2)))


def _shown(term: Expr) -> str:
    """A term without its sign."""
    if isinstance(term, Mul) and term.args[0] == -1:
        term = Mul(*term.args[1:], evaluate=False) if len(term.args) > 2 else term.args[1]
    try:
        return text(term).lstrip("−")
    except (TypeError, AttributeError, ValueError):
        return "a term"
