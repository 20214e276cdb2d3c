"""What is done with equations: moves, performed.

A move takes cited equations and makes new ones of them.  It knows no model: what it does not find
in the equations that are cited, it does not use.  What can't be done raises `RefusedError`, with
the reason in words.
"""

from rigidtop.proof.moves.conditions import domain, flat_with, joined, never_vanishes, nonzero
from rigidtop.proof.moves.move import (
    Condition,
    Known,
    Move,
    Order,
    Pair,
    Performed,
    RefusedError,
    Scope,
)
from rigidtop.proof.moves.orders import NEGLECTED
from rigidtop.proof.moves.pairs import (
    braces_of,
    give,
    named_components,
    pairs_of,
    put_in,
    where_set,
)
from rigidtop.proof.moves.perform import perform, with_rates

__all__ = [
    "NEGLECTED",
    "Condition",
    "Known",
    "Move",
    "Order",
    "Pair",
    "Performed",
    "RefusedError",
    "Scope",
    "braces_of",
    "domain",
    "flat_with",
    "give",
    "joined",
    "named_components",
    "never_vanishes",
    "nonzero",
    "pairs_of",
    "perform",
    "put_in",
    "where_set",
    "with_rates",
]
