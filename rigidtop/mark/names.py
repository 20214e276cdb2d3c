"""What an answer calls the things of its facts: **e**₃ or e₃, L or ℒ, U or V, J ω or **L**."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

from rigidtop.judge.context import Context
from rigidtop.judge.reading import Read
from rigidtop.mark.arrival import head
from rigidtop.mark.facts import TENSOR
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement

_VERTICAL = Letter("z", mark="hat", bold=True)
_ALIASES = {
    Letter("U"): Letter("V"),
    Letter("e", "z", bold=True): _VERTICAL,
    Letter("e", "z", "hat"): _VERTICAL,
    Letter("e", "z", "hat", bold=True): _VERTICAL,
    Letter("k", mark="hat"): _VERTICAL,
    Letter("k", mark="hat", bold=True): _VERTICAL,
}
"""Other names that are usual for letters of the facts."""

_TENSORS = frozenset("IJΘ")
"""Names of the tensor of inertia, where it stands before ω."""

_LENGTH, _LAGRANGIAN = Letter("L"), Letter("ℒ")
"""L is the length of **L**, if it is not the Lagrangian."""


@dataclass(frozen=True)
class Names:
    """The letters of the facts, those that an answer defines itself, and whether L is ℒ there.

    `called` are the letters that an answer has for some that move, as in ϕ = φ.
    """

    facts: frozenset[Letter]
    defined: frozenset[Node]
    has_lagrangian: bool
    called: Mapping[str, str]

    @classmethod
    def of(cls, read: Read, contexts: Collection[Context]) -> Names:
        """The names of an answer that has been read, beside the facts of some contexts."""
        stated = [each for _, each in read if isinstance(each, Statement)]
        facts = frozenset().union(*(context.letters for context in contexts))
        defined = frozenset(head(each.sides[0]) for each in stated)
        moving = frozenset().union(*(context.habits.moving for context in contexts))
        nodes = [node for each in stated for side in each.sides for node in n.walked(side)]
        rates = {x.of for x in nodes if isinstance(x, n.TimeDerivative)}
        called: dict[str, str] = {}
        for each in stated:
            for pair in (each.sides, each.sides[::-1]):
                match pair:
                    case (Letter(own, "", ""), Letter(base, "", "") as letter) if (
                        Letter(own) in rates - facts and letter in moving - rates
                    ):
                        called[own] = base
        has_lagrangian = _LAGRANGIAN in facts and any(map(_has_lagrangian, stated))
        return cls(facts, defined, has_lagrangian, called)

    def in_facts(self, each: Statement) -> Statement:
        """A statement in the letters of the facts."""
        meant = tuple(n.mapped(side, self._meant) for side in each.sides)
        if any(_is_column(side) for side in meant[1:]):
            meant = (self._vector(meant[0]), *meant[1:])
        return replace(each, sides=meant)

    def _vector(self, side: Node) -> Node:
        """The vector of the facts of which the letter, or what it is at a time, is the name."""
        match side:
            case n.Call(function, places):
                return n.Call(self._vector(function), places)
            case Letter() if (bold := replace(side, bold=True)) in self.facts:
                return bold
        return side

    def _meant(self, node: Node) -> Node:
        match node:
            case n.Product((Letter() as tensor, Letter("ω", bold=True) as omega)) | n.DotProduct(
                Letter() as tensor, Letter("ω", bold=True) as omega
            ) if tensor.base in _TENSORS and not tensor.sub and tensor not in self.facts:
                return n.Product((TENSOR, omega))
            case n.Primed(Letter(mark="", sub=sub) as axis, 1) if sub in ("1", "2", "3"):
                named = replace(axis, bold=True, mark="′")
                component = replace(axis, sub=sub + "′")
                return next((x for x in (named, component) if x in self.facts), node)
            case Letter():
                return self._letter(node)
        return node

    def _letter(self, letter: Letter) -> Node:
        base, sub = (self.called.get(x, x) for x in (letter.base, letter.sub))
        letter = replace(letter, base=base if not letter.sub else letter.base, sub=sub)
        if letter == _LENGTH and self.has_lagrangian:
            return _LAGRANGIAN
        if letter in self.facts:
            return letter
        if letter not in self.defined or letter.mark == "hat":
            primed = _primed(letter)
            marks = [letter, primed, replace(letter, mark=_hatless(letter))]
            bold = [primed, *(replace(x, bold=True) for x in marks)]
            usual = (*bold, _ALIASES.get(letter))
            known = next((x for x in usual if x in self.facts), None)
            if known is not None:
                return known
        bare = replace(letter, sub="")
        # θ_t is θ̇.
        return (
            n.TimeDerivative(bare, 1, True) if letter.sub == "t" and bare in self.facts else letter
        )


def _is_column(side: Node) -> bool:
    return isinstance(side, n.Tuple) and len(side.entries) == 3


def _primed(letter: Letter) -> Letter:
    """e₁′ for e with the index 1′."""
    if letter.mark or not letter.sub.endswith("′"):
        return letter
    return replace(letter, sub=letter.sub.rstrip("′"), mark="′")


def _hatless(letter: Letter) -> str:
    return letter.mark.replace("hat", "")


def _has_lagrangian(each: Statement) -> bool:
    """Whether L is differentiated, or said to be T − V or T − U."""
    nodes = [node for side in each.sides for node in n.walked(side)]
    if any(isinstance(x, n.Derivative) and n.ungrouped(x.of) == _LENGTH for x in nodes):
        return True
    return each.sides[0] == _LENGTH and any(map(_is_difference_of_energies, each.sides[1:]))


def _is_difference_of_energies(side: Node) -> bool:
    match side:
        case n.Sum((Letter("T"), n.Negative(Letter("U" | "V")))):
            return True
    return False
