"""Statements of several things at once: of the letters in ω_{1,2} = 0, of the signs in x = ±a.

>>> from rigidtop.tree.nodes import Number, PlusMinus
>>> from rigidtop.tree.plain import plain
>>> both = Statement((Letter("ω", "1,2"), Number("0")), ("=",))
>>> [plain(each) for each in each_index(both)]
['ω₁ = 0', 'ω₂ = 0']
>>> [plain(signed(PlusMinus(Letter("a")), sign)) for sign in (1, -1)]
['a', '−a']
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement


def each_index(statement: Statement) -> Iterator[Statement]:
    """What is said of several letters at once, of each; the statement itself if of one."""
    letters = frozenset().union(*map(n.letters, statement.sides))
    lists = {x.sub for x in letters if re.fullmatch(r"\w(,\w)+", x.sub)}
    counts = {len(sub.split(",")) for sub in lists}
    if len(counts) != 1:
        yield statement
        return
    for k in range(*counts):

        def chosen(node: Node, k: int = k) -> Node:
            if isinstance(node, Letter) and node.sub in lists:
                return replace(node, sub=node.sub.split(",")[k])
            return node

        sides = tuple(n.mapped(side, chosen) for side in statement.sides)
        yield replace(statement, sides=sides)


def each_sign(statement: Statement) -> Iterator[Statement]:
    """What is said with the upper signs and with the lower ones; the statement without ±."""
    if not any(map(has_sign, statement.sides)):
        yield statement
        return
    for sign in (1, -1):
        yield replace(statement, sides=tuple(signed(side, sign) for side in statement.sides))


def has_sign(node: Node) -> bool:
    """Whether ± stands in it, also in the index of a letter."""
    return any(
        isinstance(x, n.PlusMinus) or (isinstance(x, Letter) and ("±" in x.sub or "∓" in x.sub))
        for x in n.walked(node)
    )


def signed(node: Node, sign: int) -> Node:
    """An expression with the upper or the lower sign."""

    def chosen(each: Node) -> Node:
        if isinstance(each, n.PlusMinus):
            return each.of if (sign > 0) != each.inverted else n.Negative(each.of)
        return each

    return n.mapped(node, chosen) if has_sign(node) else node
