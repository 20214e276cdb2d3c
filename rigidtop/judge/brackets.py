"""Poisson brackets: {f, g} = Σ ∂f/∂q ∂g/∂p − ∂f/∂p ∂g/∂q, or with the other sign of some books."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from sympy import Add, Expr

from rigidtop.judge.jets import Jet, jets, symbol
from rigidtop.judge.letters import ANGLES
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node

_MOMENTA = frozenset("pPπ")


def conjugates(names: Collection[Letter]) -> list[tuple[Letter, Letter]]:
    """Coordinates with their momenta, by their names: q and p, x and p, θ and p_θ, q₁ and p₁."""
    pairs = [
        (q, p)
        for p in sorted(names, key=str)
        for q in (Letter(p.sub), Letter("q", p.sub), Letter("x", p.sub), Letter("Q", p.sub))
        if p.base == ("P" if q.base == "Q" else "p") and q in names
    ]
    if not pairs:
        pairs = [(w, action) for w, action in _ACTIONS if {w, action} <= {*names}]
    return pairs if len({p for _, p in pairs}) == len(pairs) else []


_ACTIONS = [(Letter(w), Letter(action)) for w in sorted(ANGLES | {"w"}) for action in "JI"]
"""Angles with their actions."""


def is_bracket(node: Node) -> bool:
    """Whether two entries stand in braces or square brackets."""
    return isinstance(node, n.Tuple) and node.bracket in ("{", "[") and len(node.entries) == 2


def bracket(f: Expr, g: Expr, names: Iterable[Letter]) -> Expr | None:
    """The bracket of two functions of coordinates and momenta; None if they have none.

    `names` are the letters of a text, among which the partners of theirs are.
    """
    own = {jet.letter for x in (f, g) for jet in jets(x).values()}
    rates = any(jet.order for x in (f, g) for jet in jets(x).values())
    pairs = [x for x in conjugates({*names, *own}) or conjugates(own) if own & {*x}]
    if rates or not pairs:
        return None
    numbers = [(symbol(Jet(q)), symbol(Jet(p))) for q, p in pairs]
    return Add(*(f.diff(q) * g.diff(p) - f.diff(p) * g.diff(q) for q, p in numbers))


def convention(left: Node, right: Node) -> int | None:
    """The sign of ∂f/∂q ∂g/∂p where a text says what its brackets are; None if it does not."""
    if not (isinstance(left, n.Tuple) and is_bracket(left)):
        return None
    f, g = left.entries
    if not (isinstance(f, Letter) and isinstance(g, Letter) and {f, g} <= n.letters(right)):
        return None
    terms = [x for x in n.walked(right) if isinstance(x, n.Product)]
    minus = {id(x.of) for x in n.walked(right) if isinstance(x, n.Negative)}
    for term in terms:
        by = {x.of: x.by[0] for x in term.factors if isinstance(x, n.Derivative)}
        if {*by} == {f, g} and isinstance(by[f], Letter):
            sign = -1 if id(term) in minus else 1
            return -sign if by[f].base in _MOMENTA else sign  # type: ignore[attr-defined]
    return None
