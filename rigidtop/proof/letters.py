"""What the letters of a subject are."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from sympy import Expr, Symbol

from rigidtop.proof import floats
from rigidtop.proof.equation import Partial, Rate


@dataclass(frozen=True)
class Letters:
    """What a subject's letters are.

    `numbers` do not change in time, be they scalars or vectors; `coordinates` and `rates` (of each
    letter that has a rate with a letter of its own) are what a Lagrangian is a function of; every
    other scalar depends on the motion.  `vectors` and `operators` say what is no scalar;
    `determinants` have letters of their own; `arbitrary` vectors stand for any; `frames` are
    right-handed triples of unit vectors, of which `body` is fixed in the body; `indexed` letters
    belong to one particle of many, or to one place, named by the indices that a Σ or ∫ goes over;
    `exchanged` says what letter each becomes when two indices change places, r_k for r_l;
    `components` name the
    scalar product of an axis and a vector, `branches` the roots of an equation for a letter, with
    their places, 0 for the one with − before the square root;
    `placed` are vectors, operators and scalars that coordinates alone determine, and `functions`
    letters with the other letters that they are a function of, such as an effective potential of
    an angle and of momenta; a slip of the pen exchanges letters of one of the `families`;
    `exists` tells whether there is something with these numbers, as far as they are given: a body
    with these moments;
    `units` are SI; `defined` says what stands in the definition of a letter that has been read, and
    `means` what a scalar is by its definition, or by a law; `solved` what one is for which a page
    solves; `relations` vanish by other laws.
    """

    numbers: frozenset[Symbol] = frozenset()
    coordinates: tuple[Symbol, ...] = ()
    rates: Mapping[Symbol, Symbol] = field(default_factory=dict)
    vectors: frozenset[Symbol] = frozenset()
    operators: frozenset[Symbol] = frozenset()
    determinants: Mapping[Symbol, Symbol] = field(default_factory=dict)
    arbitrary: frozenset[Symbol] = frozenset()
    frames: tuple[tuple[Symbol, Symbol, Symbol], ...] = ()
    body: tuple[Symbol, ...] = ()
    indexed: Mapping[Symbol, frozenset[Symbol]] = field(default_factory=dict)
    exchanged: Mapping[Symbol, Symbol] = field(default_factory=dict)
    components: Mapping[tuple[Symbol, Symbol], Symbol] = field(default_factory=dict)
    branches: Mapping[Symbol, tuple[Symbol, int]] = field(default_factory=dict)
    families: tuple[tuple[Symbol, ...], ...] = ()
    exists: Callable[[Mapping[Symbol, Expr]], bool] = floats.anything
    placed: frozenset[Symbol] = frozenset()
    functions: Mapping[Symbol, tuple[Symbol, ...]] = field(default_factory=dict)
    units: Mapping[Symbol, str] = field(default_factory=dict)
    defined: Mapping[Symbol, frozenset[Symbol]] = field(default_factory=dict)
    means: Mapping[Symbol, Expr] = field(default_factory=dict)
    solved: Mapping[Symbol, Expr] = field(default_factory=dict)
    relations: tuple[Expr, ...] = ()

    @cached_property
    def unit_vectors(self) -> frozenset[Symbol]:
        return frozenset(e for frame in self.frames for e in frame)

    def made_of(self, letter: Symbol) -> frozenset[Symbol]:
        """What a letter is made of, by its definition and by those of what stands in that."""
        direct = self.defined.get(letter, frozenset())
        return direct.union(*(self.made_of(x) for x in direct))

    @cached_property
    def velocities(self) -> frozenset[Symbol]:
        return frozenset(self.rates[q] for q in self.coordinates if q in self.rates)

    @cached_property
    def fixed_components(self) -> Mapping[Symbol, tuple[Symbol, Symbol]]:
        """The letters that are components along an axis that does not turn: (axis, vector)."""
        return {x: (e, v) for (e, v), x in self.components.items() if e in self.numbers}

    @cached_property
    def values(self) -> dict[Expr, Any]:
        """What printed trees say in these letters, of those of which it has been asked."""
        return {}

    def arguments(self, letter: Symbol) -> frozenset[Symbol]:
        """What a partial derivative of a letter holds fixed: numbers and what it is a function of.

        What is no function of other letters is one of coordinates and velocities.
        """
        return self.numbers | (
            frozenset(self.functions.get(letter, ())) or self.velocities | {*self.coordinates}
        )

    def is_placed(self, node: Expr) -> bool:
        """Whether coordinates alone determine an atom: no velocity changes it."""
        names = {x.name for x in self.placed | self.numbers | {*self.coordinates}}
        return not node.has(Rate, Partial) and all(
            x.name.removesuffix("ᵀ") in names for x in node.free_symbols
        )
