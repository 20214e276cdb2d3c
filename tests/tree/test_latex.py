"""What is written as LaTeX reads back as the same nodes."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rigidtop.read.statements import statements
from rigidtop.tree.latex import latex
from rigidtop.tree.nodes import (
    Absolute,
    Apply,
    At,
    Average,
    Bracketed,
    Call,
    Component,
    CrossProduct,
    Derivative,
    DotProduct,
    Integral,
    Letter,
    Limit,
    Matrix,
    Nabla,
    Negative,
    Node,
    Number,
    PlusMinus,
    Power,
    Primed,
    Product,
    Quotient,
    Root,
    Sum,
    TimeDerivative,
    Total,
    TransposedMatrix,
    Tuple,
    mapped,
)
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import RELATIONS, Statement

F = Letter("f")
T = Letter("t")
LETTERS = st.builds(
    Letter,
    st.sampled_from("abcxyzmgRMVθφωλΩℓℒ"),
    st.sampled_from(["", "", "1", "12", "eff", "±", "1,2", "3′", "x"]),
    st.sampled_from(["", "", "bar", "tilde", "star", "hat"]),
    st.booleans(),
)
NUMBERS = st.builds(Number, st.sampled_from(["0", "1", "2", "17", "0.80"]))
SCALARS = st.builds(Letter, st.sampled_from("xyθ"), st.sampled_from(["", "1"]))


def several(nodes: st.SearchStrategy[Node], least: int = 2) -> st.SearchStrategy[tuple[Node, ...]]:
    return st.lists(nodes, min_size=least, max_size=3).map(tuple)


def larger(nodes: st.SearchStrategy[Node]) -> st.SearchStrategy[Node]:
    order = st.integers(1, 3)
    one: list[Callable[..., Node]] = [
        *(Negative, Absolute, Average, Root, TransposedMatrix, Nabla),
        *(lambda of, make=make: make(of) for make in (PlusMinus,)),
    ]
    apply = st.builds(Apply, st.sampled_from(["sin", "exp", "tr", "arctan"]), nodes)
    return st.one_of(
        *(st.builds(make, nodes) for make in one),
        *(st.builds(make, nodes, nodes) for make in (DotProduct, CrossProduct)),
        # A letter with a zero above it is another letter: nobody writes a power for 1.
        st.builds(Power, nodes, nodes.filter(lambda x: x != Number("0"))),
        apply,
        st.builds(Sum, several(nodes)),
        st.builds(Product, several(nodes)),
        st.builds(Tuple, several(nodes)),
        st.builds(Quotient, nodes, nodes, st.booleans()),
        st.builds(TimeDerivative, nodes, order, st.booleans(), st.sampled_from(["", "body"])),
        st.builds(Primed, SCALARS, order),
        st.builds(Derivative, nodes, several(SCALARS, 1), st.booleans()),
        st.builds(Integral, nodes, SCALARS, nodes, nodes),
        st.builds(Total, nodes, st.just((Letter("i"),)), NUMBERS, nodes),
        st.builds(Limit, nodes, SCALARS, NUMBERS),
        st.builds(At, nodes, SCALARS, NUMBERS),
        st.builds(Call, st.just(F), several(nodes, 1)),
        st.builds(Component, st.builds(CrossProduct, nodes, nodes), st.sampled_from(["1", "z"])),
        st.builds(lambda a, b: Matrix(((a, b), (b, a))), nodes, nodes),
    )


NODES = st.recursive(st.one_of(LETTERS, NUMBERS, SCALARS, st.just(T)), larger, max_leaves=8)


def bare(node: Node) -> Node:
    """A node without brackets; products and terms in them are one."""
    return mapped(node, lambda each: each.of if isinstance(each, Bracketed) else each)


@settings(max_examples=60, deadline=None)
@given(several(NODES), st.sampled_from([x for x in RELATIONS if x != "→"]))
def test_it_reads_back(sides: tuple[Node, ...], relation: str) -> None:
    written = Statement(sides, (relation,) * (len(sides) - 1))
    (read,) = statements(latex(written), functions=frozenset({F}))
    assert isinstance(read, Statement), (latex(written), read)
    assert read.relations == written.relations
    assert tuple(map(bare, read.sides)) == sides, latex(written)
    assert plain(read)


@pytest.mark.parametrize(
    ("text", "plainly"),
    [
        (r"\frac{a+b}{c} \left(x-y\right)", "(a + b)/c (x − y)"),
        (r"\vec L = \hat{\mathbf z}\times\dot{\mathbf e}_3", "L = ẑ × ė₃"),
        (r"x = x_0\,\mathrm{e}^{-\gamma t}", "x = x₀ e^(−γ t)"),
    ],
)
def test_plain(text: str, plainly: str) -> None:
    (read,) = statements(text)
    assert isinstance(read, Statement)
    assert plain(read) == plainly
    assert statements(latex(read))[0].sides == read.sides  # type: ignore[union-attr]
