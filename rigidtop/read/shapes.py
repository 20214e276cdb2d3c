r"""What parts of formulas are, by their shape: brackets, derivatives, dressed letters.

>>> from rigidtop.read.tex import pieces
>>> from rigidtop.read.tokens import tokens
>>> head = head_of(tokens(pieces(r"\frac{\partial L}{\partial x}")))
>>> head.sign, [each.text for each in head.of]
('∂', ['L'])
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from rigidtop.read.tex import UnreadError, commands
from rigidtop.read.tokens import Token, written
from rigidtop.tree.nodes import (
    At,
    Braced,
    Derivative,
    Differential,
    Integral,
    Letter,
    Node,
    Number,
    Omitted,
    Power,
    Primed,
    Product,
    Quotient,
    TimeDerivative,
    TransposedMatrix,
    Unit,
    parts,
    rebuilt,
    ungrouped,
)

TIME: Final = Letter("t")
FRACTIONS: Final = commands("frac tfrac dfrac cfrac nicefrac flatfrac")


def parted(items: Sequence[Token], kind: str) -> list[Sequence[Token]]:
    """The parts between the tokens of a kind."""
    parts: list[list[Token]] = [[]]
    for token in items:
        if token.kind == kind:
            parts.append([])
        else:
            parts[-1].append(token)
    return [*parts]


def brackets(items: Sequence[Token]) -> tuple[dict[int, int], dict[int, bool]]:
    """Where each bracket closes, and whether a relation stands in it."""
    partners: dict[int, int] = {}
    related: dict[int, bool] = {}
    opened: list[int] = []
    for i, token in enumerate(items):
        if token.kind == "open":
            opened.append(i)
        elif token.kind == "close" and opened:
            partners[opened.pop()] = i
        elif token.kind == "relation" and opened and items[i - 1].text not in ("_", "^"):
            related[opened[-1]] = True
    return partners, related


def product_of(factors: Sequence[Node]) -> Node:
    flat: list[Node] = []
    for each in factors:
        flat += each.factors if isinstance(each, Product) else [each]
    return flat[0] if len(flat) == 1 else Product(tuple(flat))


def unbraced(token: Token) -> Token:
    """What stands in braces by itself, if it is upright: {\\rm d}."""
    upright = [each.kind for each in token.group] == ["upright"]
    return token.group[0] if token.kind == "group" and upright else token


def is_operator(token: Token, sign: str) -> bool:
    return token.text == sign and token.kind in ("letter", "upright", "sign")


def upright(items: Sequence[Token], within: bool = False) -> str:
    r"""Upright letters with their powers as text, "" for anything else.

    ``\frac{\mathrm m}{\mathrm s^2}`` is "m/(s^2)"; where it is `within` what is upright, all
    letters are.
    """
    if len(items) == 3 and items[0].text in FRACTIONS:
        over, under = (upright(_argument(each), within) for each in items[1:])
        return f"{over}/({under})" if over and under else ""
    text = ""
    for token in items:
        if token.kind == "group":
            part = upright(token.group, within)
        elif token.kind in ("upright", "words") or (within and token.kind == "letter"):
            part = f" {token.text.strip()}"
        else:
            part = token.text if token.kind == "number" or token.text in ("^", "-", "·") else ""
        if not part:
            return ""
        text += part
    return text.strip()


@dataclass(frozen=True)
class Head:
    """A derivative as it is written: by what, and of what if that stands above the bar."""

    sign: str
    of: Sequence[Token]
    by: Sequence[Sequence[Token]]


def head_of(items: Sequence[Token]) -> Head | None:
    """The derivative that tokens are, a fraction with its bar or d…/d…; None for something else."""
    if len(items) == 3 and items[0].text in FRACTIONS:
        items = (*_argument(items[1]), Token("sign", "/", 0), *_argument(items[2]))
    slashes = [i for i, each in enumerate(items) if each.text == "/" and each.kind == "sign"]
    if not slashes or not slashes[0]:
        return None
    over, under = items[: slashes[-1]], items[slashes[-1] + 1 :]
    sign = unbraced(over[0]).text
    if sign not in ("d", "∂") or not under or not is_operator(unbraced(under[0]), sign):
        return None
    over, order = over[1:], "1"
    if over and over[0].text == "^" and over[0].kind == "sign":
        over, order = over[2:], written(over[1:2])
    by: list[list[Token]] = []
    for token in under:
        if is_operator(unbraced(token), sign) and (not by or by[-1]):
            by.append([])
        else:
            by[-1].append(token)
    repeated: list[list[Token]] = []
    if any(not part or part[0].text == "_" for part in by) or (over and over[0].text == "_"):
        return None  # d with an index is a letter
    for part in by:
        times = 1
        if len(part) > 2 and part[-2].text == "^" and written(part[-1:]).isdecimal():
            times, part = min(int(written(part[-1:])), 9), part[:-2]
        repeated += [part] * times
    if order.isdecimal():
        check_order(int(order), repeated, items[0].position)
    return Head(sign, over, repeated)


def check_order(order: int, by: Sequence[object], position: int) -> None:
    """UnreadError where a derivative has another order above its bar than below, as d²x/dt."""
    if order != len(by):
        raise UnreadError(f"a derivative is of order {order} above and {len(by)} below", position)


def _argument(token: Token) -> tuple[Token, ...]:
    return token.group if token.kind == "group" else (token,)


def derivative_of(sign: str, of: Node, by: Sequence[Node]) -> Node:
    if sign == "d" and all(each == TIME for each in by):
        return TimeDerivative(ungrouped(of), len(by))
    return Derivative(ungrouped(of), tuple(map(ungrouped, by)), partial=sign == "∂")


def framed(node: Node, frame: str) -> Node | None:
    """A rate as a frame sees it, and at a fixed value what else is differentiated."""
    if not frame or any(sign in frame for sign in "=≈→<>"):
        return None
    if isinstance(node, TimeDerivative):
        return replace(node, frame=frame)
    if isinstance(node, Derivative):
        timely = all(each == TIME for each in node.by)
        return TimeDerivative(node.of, len(node.by), frame=frame) if timely else At(node, sub=frame)
    return None


def integrand_of(node: Node, position: int) -> tuple[Node, Node]:
    """What is integrated, and by what, where the differential stands within."""
    if isinstance(node, Differential):
        return Number("1"), node.of
    if isinstance(node, Quotient):
        over, by = integrand_of(node.over, position)
        return replace(node, over=over), by
    if isinstance(node, Braced):
        of, by = integrand_of(node.of, position)
        return replace(node, of=of), by
    if isinstance(node, Product):
        for i, each in enumerate(node.factors):
            if isinstance(each, (Differential, Quotient, Braced)):
                try:
                    inside, by = integrand_of(each, position)
                except UnreadError:
                    continue
                kept = (*node.factors[:i], inside, *node.factors[i + 1 :])
                return product_of([x for x in kept if x != Number("1")] or [Number("1")]), by
    if isinstance(node, Integral):
        return node, node.by
    raise UnreadError("an integral that does not say over what", position)


def with_index(node: Node, text: str) -> Node | None:
    """A letter with an index more, however it is dressed; None for what is no letter."""
    if isinstance(node, Letter):
        return replace(node, sub=f"{node.sub},{text}" if node.sub else text)
    if isinstance(node, Unit):
        return Letter(node.name, text)
    dressed = isinstance(node, (Power, Primed, TransposedMatrix))
    if not dressed and not (isinstance(node, TimeDerivative) and node.dotted):
        return None
    indexed = with_index(parts(node)[0], text)
    return indexed and rebuilt(node, (indexed, *parts(node)[1:]))


def primed(node: Node) -> Node:
    """A prime more; with a unit vector it belongs to the name, below a dot to the letter."""
    if isinstance(node, TimeDerivative) and node.dotted:
        return replace(node, of=primed(node.of))
    if isinstance(node, Letter) and (node.mark == "hat" or (node.bold and node.base == "e")):
        return replace(node, mark=node.mark + "′")
    if isinstance(node, Primed):
        return replace(node, order=node.order + 1)
    return Primed(node)


def is_place(node: Node) -> bool:
    dressed = isinstance(node, Primed) or (isinstance(node, TimeDerivative) and node.dotted)
    core = parts(node)[0] if dressed else node
    return isinstance(core, (Letter, Omitted)) or node == Number("0")
