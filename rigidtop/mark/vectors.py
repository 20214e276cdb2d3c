"""Vectors of an answer that marks none: all three in ė₃ = Ω × e₃, the first g in g = −g ẑ."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace

from rigidtop.judge.reading import Read
from rigidtop.mark.task import Task
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement


def with_vectors(read: Read, task: Task) -> Read:
    """An answer with vectors for the letters that have to be some; as it is if it marks any."""
    stated = [each for _, each in read if isinstance(each, Statement)]
    names = frozenset(x for each in stated for side in each.sides for x in n.letters(side))
    if any(x.bold and not x.mark for x in names):
        return read
    given = frozenset[Letter]().union(*(context.given for context in task.contexts))
    vectors = KnownVectors(frozenset(x for x in given if x.bold), given)
    return [
        (passage, vectors.marked(each) if isinstance(each, Statement) else each)
        for passage, each in read
    ]


@dataclass(frozen=True)
class KnownVectors:
    """The vectors that are known by name, and all letters that are known."""

    known: Collection[Letter]
    given: Collection[Letter]

    def marked(self, each: Statement) -> Statement:
        """A statement with bold letters where both sides have to be vectors."""
        sides = tuple(n.mapped(side, self._crossed) for side in each.sides)
        if any(map(self.is_vector, sides)):
            sides = tuple(map(self.vector, sides))
        return replace(each, sides=sides)

    def is_vector(self, node: Node) -> bool:
        """Whether a formula can be nothing else."""
        match node:
            case Letter(mark=mark, bold=bold):
                return bold or mark == "hat" or (self.bold(node) and node not in self.given)
            case n.CrossProduct():
                return True
            case n.TimeDerivative(of) | n.Negative(of) | n.Bracketed(of) | n.Quotient(of):
                return self.is_vector(of)
            case n.Product(parts) | n.Sum(parts):
                return any(map(self.is_vector, parts))
        return False

    def vector(self, node: Node) -> Node:
        """A formula as a vector: one factor of a product is, and all terms of a sum are."""
        match node:
            case Letter():
                return replace(node, bold=True) if self.bold(node) else node
            case n.TimeDerivative(of) | n.Negative(of) | n.Bracketed(of):
                return replace(node, of=self.vector(of))
            case n.Quotient(over):
                return replace(node, over=self.vector(over))
            case n.CrossProduct(left, right):
                return n.CrossProduct(self.vector(left), self.vector(right))
            case n.Sum(terms):
                return n.Sum(tuple(map(self.vector, terms)))
            case n.Product(factors):
                # The last one that can be, unless another one has to be.
                order = sorted(range(len(factors)), key=lambda k: (self.is_vector(factors[k]), k))
                for k in reversed(order):
                    vector = self.vector(factors[k])
                    if vector != factors[k] or self.is_vector(factors[k]):
                        return n.Product((*factors[:k], vector, *factors[k + 1 :]))
        return node

    def bold(self, letter: Letter) -> bool:
        """Whether a vector of its name is known."""
        return replace(letter, bold=True) in self.known

    def _crossed(self, node: Node) -> Node:
        return self.vector(node) if isinstance(node, n.CrossProduct) else node
