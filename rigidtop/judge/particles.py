"""Particles over which sums and integrals run, with the masses and volumes that they have."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Symbol

from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node

PARTICLES = 3
"""Of a sum over particles so many are taken."""

REGION = "∫"
"""The index of the particles of a body over which an integral is taken, and its letter's mark."""

MASS, VOLUME, DENSITY = Letter("m"), Letter("V"), Letter("ρ")

SPREAD = frozenset("rxyzvρ")
"""Letters of places, velocities and densities, which differ within a body."""


def is_over_body(node: n.Integral) -> bool:
    """Whether an integral is over places in space, and not over a pressure as in ∫ p dV."""
    letters = n.letters(node.of)
    local = not letters or any(x.base in SPREAD for x in letters)
    return node.dimension == 3 or node.by == MASS or (node.by in (VOLUME, Letter("τ")) and local)


def part(of: Letter, particle: int) -> Symbol:
    """The mass or the volume of one particle of a body."""
    return Symbol(f"part {of.base} {particle}", real=True)


def particles(names: frozenset[str], *sides: Node, most: int = PARTICLES) -> list[dict[str, int]]:
    """Which particle each index is that stands outside of all sums, for all cases."""
    bound: list[dict[str, int]] = [{}]
    if not names:
        return bound
    for index in sorted({x for side in sides for x in _free_indices(side, names)}):
        bound = [{**each, index: k} for each in bound for k in range(most)]
    return bound


def _free_indices(node: Node, names: frozenset[str]) -> set[str]:
    """The indices over which no sum in a formula runs."""
    if isinstance(node, n.Total):
        bound = {x.base for x in node.index}
        return {x for each in n.parts(node) for x in _free_indices(each, names)} - bound
    if isinstance(node, Letter):
        return {x for x in names if node.sub == x or node.sub.endswith("," + x)}
    return {x for each in n.parts(node) for x in _free_indices(each, names)}


def tuples(spans: Sequence[range]) -> list[tuple[int, ...]]:
    """One number of each span, in all ways."""
    made: list[tuple[int, ...]] = [()]
    for span in spans:
        made = [(*each, k) for each in made for k in span]
    return made
