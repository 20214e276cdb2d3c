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
from sympy import Add, Expr, Integer, Mul, Pow, Rational, cos, sin

from rigidtop.notation import MATRICES
from rigidtop.proof.changed import Families, Single, changes, walked
from rigidtop.proof.equation import Group, Transposed, as_printed
from rigidtop.theory import symbols as s
from rigidtop.typeset.text import text

MOST = 400
"""So many repairs of a line are tried at most."""


@dataclass(frozen=True)
class Slip:
    """`kind` is one of "sign", "factor", "power", "index", …; `words` say where."""

    kind: str
    words: str


Holds = Callable[[Any, Any], bool]


def found(left: Expr, right: Expr, holds: Holds, families: Families = ()) -> tuple[Slip, ...]:
    """The slips that would explain why left = right fails, one of a kind.

    `holds` tells whether two sides are equal, by numbers; a repair for which it raises an
    ArithmeticError, TypeError or ValueError is passed over.
    """
    made: dict[str, Slip] = {}
    tried = 0
    for first, side, other in ((True, right, left), (False, left, right)):
        for repaired, slip in repairs(side, families):
            tried += 1
            if tried > MOST:
                break
            if slip.kind in made:
                continue
            pair = (other, repaired) if first else (repaired, other)
            try:
                if holds(*pair):
                    made[slip.kind] = slip
            except (ArithmeticError, TypeError, ValueError, AttributeError):
                continue
    return tuple(made.values())


def repairs(side: Expr, families: Families = ()) -> Iterator[tuple[Expr, Slip]]:
    """A side with one thing in it put right, for every thing that could be a slip."""
    if isinstance(side, sympy.MatrixBase):
        for k, entry in enumerate(side):
            for new, slip in repairs(entry, families):
                entries = [*side[:k], new, *side[k + 1 :]]
                placed = Slip(slip.kind, f"{slip.words} (entry {k + 1})")
                yield sympy.ImmutableMatrix(*side.shape, entries), placed
        return
    with as_printed():
        alone = [] if isinstance(side, Add) or side in (0, s.const) else [*_of_term(side)]
    for new, single in [*alone, *walked(side, partial(_here, families))]:
        yield new, Slip(single.kind, single.words.format(*map(_shown, single.of)))


def _of_term(term: Expr) -> Iterator[tuple[Expr, Single]]:
    """What can be wrong with a term as a whole."""
    yield Mul(Integer(-1), term), Single("sign", (term,), "the sign of {}")
    yield Mul(Integer(2), term), Single("factor", (term,), "a factor 2 at {}")
    yield Mul(Rational(1, 2), term), Single("factor", (term,), "a factor ½ at {}")
    for lost in (sin(s.theta), cos(s.theta), sin(s.theta) ** 2):
        if not term.has(*lost.atoms(sin, cos)):
            yield Mul(lost, term), Single("factor lost", (lost, term), "{} missing from {}")
    for k, kept in enumerate(term.args if isinstance(term, Mul) else ()):
        if isinstance(kept, (sin, cos)):
            rest = Mul(*term.args[:k], *term.args[k + 1 :])
            yield rest, Single("factor kept", (kept, term), "{} too much at {}")


def _here(families: Families, node: Expr) -> Iterator[tuple[Expr, Single]]:
    """What can be wrong with a node; of a sum the terms are what has a sign and a factor."""
    power, other = "the power of {}", "{} where {} is meant"
    if isinstance(node, Add):
        for k, term in enumerate(node.args):
            if not isinstance(term, Add):  # without brackets: its terms are those of the whole sum
                for new, single in _of_term(term):
                    yield Add(*node.args[:k], new, *node.args[k + 1 :]), single
    if node in MATRICES and node != s.unit:
        turned = Transposed(node)
        yield turned, Single("transpose", (node, turned), other)
        return
    if node == s.psidot:
        spin = Group(Add(node, s.phidot * cos(s.theta)))
        yield spin, Single("spin", (), "φ̇ cos θ missing beside ψ̇")
    if isinstance(node, Pow):
        for step in (-1, 1) if node.exp.is_Integer and abs(node.exp) > 1 else ():
            new = Pow(node.base, Integer(int(node.exp) + step))
            yield new, Single("power", (node.base,), power)
        return
    for new, single in changes(node, families):
        if single.kind == "order":
            yield new, Single("sign", node.args, "the order of {} × {}")
        elif single.kind == "too much" and not isinstance(single.of, Add):
            yield new, Single(single.kind, (single.of,), "{} too much")
        elif single.kind == "power":
            yield new, Single(single.kind, (node,), power)
        elif single.kind in ("function", "index", "transpose"):
            yield new, Single(single.kind, (node, single.of), other)


def _shown(term: Expr) -> str:
    """A term without its sign."""
    if isinstance(term, Mul) and term.args[0] == -1:
        term = Mul(*term.args[1:], evaluate=False) if len(term.args) > 2 else term.args[1]
    try:
        return text(term).lstrip("−")
    except (TypeError, AttributeError, ValueError):
        return "a term"
