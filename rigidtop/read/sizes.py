"""How large a formula may be, so that none takes long: its depth, its powers, its digits."""

from __future__ import annotations

from dataclasses import dataclass

from rigidtop.read.kinds import UnknownError
from rigidtop.tree import nodes as n

DEEPEST = 100
"""No expression is a deeper tree; a sum of n terms is one of n levels."""

RAISED = 20
"""No power is higher, powers of powers multiplied: SymPy may multiply it out."""

DIGITS = 400
"""No number has more, were its powers computed."""


@dataclass(frozen=True)
class Size:
    """How deep a tree is, how high its powers are, how many digits its numbers come to."""

    depth: float = 1
    raised: float = 1
    digits: float = 0


def checked_size(node: n.Node) -> Size:
    """The size of a node.  Raises UnknownError for one that is too large."""
    if isinstance(node, n.Number):
        return Size(digits=len(node.text))
    parts = [checked_size(part) for part in n.parts(node)]
    # A sum of n terms is a tree of n levels.
    levels = max(len(parts) - 1, 1) if isinstance(node, (n.Sum, n.Product)) else 1
    depth = levels + max((x.depth for x in parts), default=0)
    raised = max((x.raised for x in parts), default=1)
    digits = sum(x.digits for x in parts)
    if isinstance(node, n.Power):
        base, exponent = parts
        times = max(_largest(node.exponent, exponent.digits), 1)
        raised = base.raised * times if n.letters(node.base) else base.raised
        digits = base.digits * times + exponent.digits
        if raised > RAISED or times > 10**4:
            raise UnknownError("a power too high")
    if digits > DIGITS:
        raise UnknownError("a number too large")
    if depth > DEEPEST:
        raise UnknownError(f"an expression of more than {DEEPEST} levels: fewer terms or brackets")
    return Size(depth, raised, digits)


def _largest(exponent: n.Node, digits: float) -> float:
    """How large an exponent may be at most, as far as its numbers go."""
    node = n.ungrouped(exponent)
    node = n.ungrouped(node.of) if isinstance(node, n.Negative) else node
    if isinstance(node, n.Number):
        return float(node.value)
    return 10.0 ** min(digits, 20) if digits else 1
