"""Trees are values: equal where they are written alike, and rebuilt from their own parts."""

import copy
import pickle
from dataclasses import fields

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node, Number

LETTERS = st.builds(
    Letter,
    st.sampled_from(["x", "θ", "I", "ω"]),
    st.sampled_from(["", "1", "eff"]),
    st.sampled_from(["", "hat", "′"]),
    st.booleans(),
)
LEAVES = st.one_of(
    LETTERS,
    st.sampled_from(["0", "2", "0.80"]).map(Number),
    st.just(n.Constant()),
    st.just(n.Omitted()),
    st.builds(n.Unit, st.sampled_from(["kg", "m"])),
)


def _fields(below):
    """What the fields of each kind of node that has parts may be."""
    several = st.lists(below, min_size=1, max_size=3).map(tuple)
    orders = st.integers(1, 3)
    maybe = st.none() | below
    return {
        n.Sum: (several,),
        n.Product: (several,),
        n.Negative: (below,),
        n.PlusMinus: (below, st.booleans()),
        n.Quotient: (below, below, st.booleans()),
        n.Power: (below, below),
        n.Root: (below, st.integers(2, 3)),
        n.Apply: (st.sampled_from(["sin", "ln"]), below),
        n.Call: (LETTERS, several),
        n.Bracketed: (below, st.sampled_from("([")),
        n.Absolute: (below,),
        n.Average: (below,),
        n.TimeDerivative: (below, orders, st.booleans(), st.sampled_from(["", "body"])),
        n.Primed: (below, orders),
        n.Derivative: (below, several, st.booleans()),
        n.Differential: (below, orders, st.booleans()),
        n.Nabla: (below, st.sampled_from(["", "·", "²"])),
        n.DotProduct: (below, below),
        n.CrossProduct: (below, below),
        n.Tuple: (several,),
        n.Matrix: (st.lists(several, min_size=1, max_size=2).map(tuple),),
        n.TransposedMatrix: (below,),
        n.Component: (below, st.sampled_from("12z")),
        n.Integral: (below, LETTERS, maybe, maybe),
        n.Total: (below, st.lists(LETTERS, max_size=2).map(tuple), maybe, maybe),
        n.At: (below, maybe, maybe, st.sampled_from(["", "B"])),
        n.Braced: (below, maybe, st.sampled_from(["", "zero"])),
        n.Limit: (below, LETTERS, below),
        n.Remainder: (below,),
    }


def _above(below):
    return st.one_of([st.builds(kind, *values) for kind, values in _fields(below).items()])


few = settings(max_examples=40)
TREES = st.recursive(LEAVES, _above, max_leaves=8)

COPIES = {
    "pickled": lambda tree: pickle.loads(pickle.dumps(tree)),
    "deeply copied": copy.deepcopy,
    "mapped onto itself": lambda tree: n.mapped(tree, lambda node: node),
    "rebuilt of its parts": lambda tree: n.rebuilt(tree, n.parts(tree)) if n.parts(tree) else tree,
}


@pytest.mark.parametrize("copied", COPIES.values(), ids=COPIES)
@few
@given(tree=TREES)
def test_a_copy_is_equal_and_hashes_and_prints_alike(copied, tree):
    other = copied(tree)
    assert other == tree
    assert type(other) is type(tree)
    assert hash(other) == hash(tree)
    assert repr(other) == repr(tree)


@few
@given(one=TREES, other=TREES)
def test_trees_are_equal_where_they_print_alike(one, other):
    assert (one == other) == (repr(one) == repr(other))


@few
@given(tree=TREES, data=st.data())
def test_a_rebuilt_tree_has_the_parts_that_it_was_given(tree, data):
    others = data.draw(st.lists(LETTERS, min_size=len(n.parts(tree)), max_size=len(n.parts(tree))))
    rebuilt = n.rebuilt(tree, others)
    assert type(rebuilt) is type(tree)
    assert n.parts(rebuilt) == tuple(others)
    for field in fields(tree):
        value = getattr(tree, field.name)
        if not isinstance(value, (Node, tuple)):
            assert getattr(rebuilt, field.name) == value


@few
@given(tree=TREES)
def test_every_node_is_walked_from_the_outside_in(tree):
    walked = list(n.walked(tree))
    assert walked[0] == tree
    assert walked[1:] == [each for part in n.parts(tree) for each in n.walked(part)]
    assert n.letters(tree) == {each for each in walked if isinstance(each, Letter)}


@few
@given(tree=TREES, old=LETTERS)
def test_a_letter_that_is_replaced_is_gone_and_comes_back(tree, old):
    new = Letter("Ξ")
    gone = n.replaced(tree, old, new)
    assert n.letters(gone) == {new if each == old else each for each in n.letters(tree)}
    assert n.replaced(gone, new, old) == tree


def test_trees_of_every_kind_are_tried():
    tried = {Letter, Number, n.Unit, n.Constant, n.Omitted, *_fields(LETTERS)}
    kinds = {value for value in vars(n).values() if isinstance(value, type)}
    assert tried == {kind for kind in kinds if issubclass(kind, Node)} - {Node}


@pytest.mark.parametrize(("name", "value"), [("base", "y"), ("colour", "red")])
def test_a_node_cannot_be_changed(name, value):
    with pytest.raises((AttributeError, TypeError)):
        setattr(Letter("x"), name, value)
