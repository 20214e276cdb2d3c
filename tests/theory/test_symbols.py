"""Every symbol is described, once, with a unit and a way to write it."""

import keyword
import re

import pytest
from sympy import Symbol

from rigidtop.theory import symbols
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset.words import unmarked

MODULE = {name: x for name, x in vars(symbols).items() if isinstance(x, Symbol)}
UNITS = {
    "1/(J s)",
    *("", "1", "rad", "s", "m", "kg", "N", "J", "W"),
    *("1/s", "1/s²", "rad/s", "rad/s²", "rad/s³", "m/s", "m/s²", "kg m²", "kg/m³", "N m", "J s"),
    *("N/m³", "N/m", "1/m³", "J² s²", "s²"),
}


def test_every_symbol_of_the_module_is_described():
    assert set(MODULE.values()) == set(VOCABULARY)


def test_a_symbol_has_the_name_under_which_it_is_found():
    assert all(x.name == name for name, x in MODULE.items())
    assert all(name.isidentifier() and not keyword.iskeyword(name) for name in MODULE)


@pytest.mark.parametrize("symbol", VOCABULARY, ids=str)
def test_description_and_unit(symbol):
    row = VOCABULARY[symbol]
    assert re.fullmatch(r"\S.{2,60}[^.\s]", unmarked(row.meaning))
    assert row.unit in UNITS
    assert row.glyph.base
    assert row.glyph.accent in ("", "dot", "ddot", "hat")


def test_no_two_symbols_look_alike():
    by_glyph = {}
    for symbol, row in VOCABULARY.items():
        by_glyph.setdefault(row.glyph, set()).add(symbol.name)
    # A matrix on the page of 3.4 and an amplitude on that of 3.5.4.
    assert [names for names in by_glyph.values() if len(names) > 1] == [{"A_matrix", "A"}]


def test_a_dot_costs_a_second():
    # The unit of a rate is that of what it is the rate of, over s.
    per_second = {"": "1/s", "rad": "rad/s", "rad/s": "rad/s²", "rad/s²": "rad/s³", "J": "W"}
    per_second |= {"J s": "N m"}
    for name, symbol in MODULE.items():
        for ending, steps in (("ddot", 2), ("dot", 1)):
            if name.endswith(ending) and name[: -len(ending)] in MODULE:
                unit = VOCABULARY[MODULE[name[: -len(ending)]]].unit
                for _ in range(steps):
                    unit = per_second[unit]
                assert VOCABULARY[symbol].unit == unit
                break


def test_positive_is_what_can_only_be_positive():
    positive = {x.name for x in VOCABULARY if x.is_positive}
    assert positive == {
        *("lambda1", "lambda2", "lambda3", "M", "g", "R", "m_k", "rho"),
        *("M_1", "M_2", "a", "b", "mu", "n", "ball"),
    }
    assert all(x.is_real for x in VOCABULARY)
