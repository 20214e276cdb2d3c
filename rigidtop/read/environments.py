"""Environments within a formula: matrices, cases, and equations below one another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rigidtop.read import signs
from rigidtop.read.cursor import Token
from rigidtop.read.look import behind, rows
from rigidtop.read.tex import Piece, UnreadError, flat, plain, said, split
from rigidtop.read.worded import Words


class Environments(Words):
    """Takes what stands between ``\\begin`` and ``\\end``."""

    def environment(self) -> Iterator[Token]:
        piece = self.peek()
        name, end = self.named_environment()
        kind = name.rstrip("*")
        inner = self.items[self.at + 2 : end]
        if kind in ("array", *signs.ARGUED):
            while inner and inner[0].text in ("[", "{}"):
                inner = inner[behind(inner) :]
        self.at = end + 2
        whole = self.last != "OPEN" and not self.depth
        if (name in signs.CASES and self.open) or (kind in ("array", "matrix") and whole):
            yield from self.system(name, inner, piece.position)
        elif name in signs.MATRICES or kind == "array":
            yield from self.rows(name, inner, piece.position)
        elif kind in signs.LINES:
            yield from self.inside(inner, nested=False)
            yield Token("SPACE", r"\end", piece.position)
        elif kind.endswith("vmatrix") or kind == "Vmatrix":
            raise UnreadError("a determinant that is written out", piece.position)
        else:
            raise UnreadError(f"the environment {name}", piece.position)

    def named_environment(self) -> tuple[str, int]:
        r"""The name of the environment that begins here, and where its ``\end`` stands."""
        position, name = self.peek().position, plain(self.peek(1))
        end = self.closing(self.at, (r"\begin", r"\end"))
        if end is None:
            raise UnreadError(rf"\begin{{{name}}} without its \end", position)
        ends = plain(*self.items[end + 1 : end + 2])
        if ends != name:
            raise UnreadError(rf"\begin{{{name}}} that ends as {ends}", position)
        return name, end

    def system(self, name: str, inner: Sequence[Piece], position: int) -> Iterator[Token]:
        """Equations below one another, or the values that one side has in several cases."""
        cells = [split(row, "&") for row in rows(inner) if row]
        heads = [p for row in cells for p in (*flat(row[0]), *(q for x in row[1:2] for q in x[:1]))]
        related = any(p.text in signs.RELATIONS for p in heads)
        if name not in signs.CASES or (self.last != "RELATION" and related):
            yield from self.inside(inner, nested=False)
            yield Token("SPACE", r"\end", position)
            return
        branches = []
        for row in cells:
            value = [t for t in self.inside(row[0]) if t.kind not in ("ALIGN", "SPACE")]
            while value and value[-1].kind in ("COMMA", "SEPARATOR"):
                value.pop()
            condition = " ".join(filter(None, map(said, row[1:])))
            branches.append((tuple(value), condition))
        if not branches:
            raise UnreadError("cases without any", position)
        yield Token("BRANCHES", tuple(branches), position)

    def rows(self, name: str, inner: Sequence[Piece], position: int) -> Iterator[Token]:
        yield Token("MATRIX", name, position)
        for i, row in enumerate(rows(inner)):
            if i:
                yield Token("LINE", r"\\", position)
            for j, cell in enumerate(split(row, "&")):
                if j:
                    yield Token("COMMA", "&", position)
                yield from self.inside(cell)
        yield Token("XIRTAM", name, position)
