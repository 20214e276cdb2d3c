"""Derivatives and differentials: fractions with d or ∂, operators on a line, gradients."""

from __future__ import annotations

from rigidtop.read.grammar import Grammar
from rigidtop.read.scripts import subscripted
from rigidtop.read.shapes import (
    FRACTIONS,
    Head,
    check_order,
    derivative_of,
    framed,
    head_of,
    is_operator,
    primed,
    product_of,
)
from rigidtop.read.tex import UnreadError
from rigidtop.read.tokens import Token, written
from rigidtop.tree.nodes import (
    Derivative,
    Differential,
    Letter,
    Nabla,
    Node,
    Quotient,
    TimeDerivative,
    Tuple,
    letters,
    ungrouped,
)


def fraction(grammar: Grammar) -> Node:
    """A quotient, or a derivative written as one."""
    grammar.take()
    over, under = grammar.argument(), grammar.argument()
    head = head_of((*over, Token("sign", "/", 0), *under))
    if head is None:
        return Quotient(grammar.node_of(over), grammar.node_of(under))
    return operation(grammar, head)


def operation(grammar: Grammar, head: Head, frame: str = "") -> Node:
    """A derivative; what it acts on stands in it, or behind it."""
    if not head.of and grammar.peek().kind == "bar" and grammar.is_sign("_", 1):
        grammar.at += 2
        frame = written(grammar.argument())
    of = grammar.node_of(head.of) if head.of else _operand(grammar)
    by = [grammar.node_of(each) for each in head.by]
    node = derivative_of(head.sign, of, by)
    return (frame and framed(node, frame)) or node


def _operand(grammar: Grammar) -> Node:
    """What an operator acts on: brackets, a derivative, or the factors that stand there."""
    if not grammar.starts():
        raise grammar.missing("what a derivative acts on")
    alone = grammar.peek().kind == "open" or grammar.peek().text in FRACTIONS
    factors = [grammar.factor([])]
    bare = factors[0]
    share = isinstance(bare, Quotient) and not letters(bare.under)  # m/2, in front of the rest
    alone = alone and bool(letters(bare)) and not share  # nobody differentiates a number
    while not alone and grammar.starts():
        factors.append(grammar.factor(factors))
    return ungrouped(product_of(factors))


def differentiated(grammar: Grammar, sign: str) -> Node | None:
    """A derivative on the line, d/dt or dx/dt, or a differential; None if d is a letter."""
    start, first = grammar.at, grammar.take()
    order = 1
    if grammar.is_sign("^") and written((grammar.peek(1),)).isdecimal():
        order = int(written((grammar.peek(1),))[:1])
        grammar.at += 2
    close = grammar.peek().position <= grammar.items[grammar.at - 1].position + 1
    loose = first.kind != "letter" or order > 1 or grammar.integrals > 0
    of: Node | None = None
    if not grammar.is_sign("/") and grammar.is_named() and (close or loose or sign == "∂"):
        of = differential_of(grammar)
    elif grammar.peek().kind == "group" and first.kind != "letter":
        inner = grammar.node_of(grammar.peek().group)
        of = inner if isinstance(inner, (Letter, TimeDerivative)) else None
        grammar.at += of is not None
    elif grammar.peek().kind == "open" and close:
        of = ungrouped(grammar.primary([])) if grammar.at in grammar.partners else None
    by = _below(grammar, sign)
    if by:
        check_order(order, by, first.position)
        return derivative_of(sign, _operand(grammar) if of is None else of, by)
    usual = sign == "∂" or grammar.reading.differentials or loose
    usual = usual and not (
        grammar.reading.lettered and (order > 1 or isinstance(of, TimeDerivative))
    )
    if of is not None and usual and grammar.items[grammar.at - 1].kind != "close":
        return Differential(of, order, sign == "∂")
    grammar.at = start
    return None


def _below(grammar: Grammar, sign: str) -> list[Node]:
    """By what is differentiated behind a slash, each as often as it is; nothing for no operator."""
    start = grammar.at
    by: list[Node] = []
    if not (grammar.is_sign("/") and is_operator(grammar.peek(1), sign)):
        return by
    grammar.take()
    while is_operator(grammar.peek(), sign) and len(by) < 9:
        grammar.take()
        variable = _variable(grammar)
        if variable is None:
            break
        by += [variable] * grammar.exponent()
    if not by:
        grammar.at = start
    return by


def _variable(grammar: Grammar) -> Node | None:
    """By what is differentiated, be it in brackets, as in dL/d(θ̇)."""
    if grammar.is_named():
        return differential_of(grammar)
    if grammar.peek().kind != "open" or grammar.at not in grammar.partners:
        return None
    start = grammar.at
    variable = ungrouped(grammar.primary([]))
    if isinstance(variable, (Letter, TimeDerivative)):
        return variable
    grammar.at = start
    return None


def differential_of(grammar: Grammar) -> Node:
    """A letter with its accents and index, without its powers and places."""
    node = grammar.primary([]) if grammar.peek().text != "d" else Letter(grammar.take().text)
    while grammar.is_sign("_") or grammar.peek().kind == "prime":
        if grammar.take().kind == "prime":
            node = primed(node)
        else:
            node = subscripted(grammar, node, grammar.argument())
    return node


def partial(grammar: Grammar) -> Node:
    """What begins with ∂: ∂ₓf, ∂/∂x with what it acts on, ∂f/∂x, or a differential."""
    if grammar.is_sign("_", 1):
        grammar.at += 2
        by = grammar.node_of(grammar.argument())
        return Derivative(_operand(grammar), by.entries if isinstance(by, Tuple) else (by,))
    node = differentiated(grammar, "∂")
    if node is None:
        raise UnreadError("∂ without what it acts on", grammar.place())
    return node


def nabla(grammar: Grammar) -> Node:
    grammar.take()
    return sloped(grammar)


def sloped(grammar: Grammar) -> Node:
    """What ∇ acts on, with the product between them."""
    product = ""
    if grammar.is_sign("_"):
        grammar.take()
        grammar.argument()
    if grammar.is_sign("·×"):
        product = grammar.take().text
    elif grammar.is_sign("^"):
        grammar.take()
        grammar.argument()
        product = "²"
    if not grammar.starts():
        return Letter("∇")
    return Nabla(ungrouped(grammar.factor([])), product)
