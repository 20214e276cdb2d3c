"""The lines of an answer, as they are written: read, with what in them could say two things."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, fields, replace

import sympy
from sympy import Pow, Symbol

from rigidtop.mark.links import is_matrix
from rigidtop.notation import Notation
from rigidtop.proof.equation import Equation, symbols_of, value
from rigidtop.read.cursor import Token
from rigidtop.read.document import bare, formulas, problems
from rigidtop.read.formula import Line, read
from rigidtop.read.habits import Habits
from rigidtop.read.scan import tokens
from rigidtop.read.tex import UnreadError
from rigidtop.read.walk import Formula, Problem, places
from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph, Quantity
from rigidtop.typeset.text import text

MOST_LINES = 200
"""A derivation has no more lines."""

LARGEST_POWER = 12
"""No exponent is larger: what is multiplied out grows with it."""

LARGEST_NUMBER = 10**12
MOST_OPERATIONS = 600
"""A line has no more operations."""


@dataclass(frozen=True)
class Step:
    """A line of the answer as it was read; `own` are letters that the facts do not know."""

    number: int
    line: Line
    source: str
    own: frozenset[Symbol] = frozenset()


_ENDS = frozenset(
    {"RELATION", "SIGN", "COMMA", "SEPARATOR", "CLOSE", "RAB", "_END", "TAG", "XIRTAM"}
)
"""What a product ends at."""
_BLANK = frozenset({"ALIGN", "SPACE"})
_GOES_ON = frozenset({"DOT", "CROSS", "SLASH", "POWER"})
_STEADY = frozenset({s.Omega_b, s.omega_0, s.lambda1, s.lambda2, s.lambda3, s.g, s.M, s.R})


def _doubtful(scanned: Sequence[Token], written: str, known: Notation) -> dict[int, str]:
    """Where a line could say two things, by position: what a derivative is of, what (t) is."""
    found: dict[int, str] = {}
    for i, token in enumerate(scanned):
        ahead = (x.position for x in scanned[i + 1 :] if x.position > token.position)
        behind = next(ahead, len(written))
        if token.value in _STEADY and "(t)" in "".join(written[token.position : behind].split()):
            found[token.position] = f"(t) behind {text(token.value)}: a factor, or that it changes?"
        if token.kind != "RATE":
            continue
        operand = _operand(scanned, i + 1)
        bracketed = scanned[i + 1 : i + 2] and scanned[i + 1].kind == "_BEGIN"
        letters = [x for x in operand if x.kind == "SYMBOL"]
        glyphs = [known.glyphs.get(x.value) for x in letters]
        of_vector = any(glyph is not None and glyph.bold for glyph in glyphs)
        if r"\partial" not in written[token.position : behind]:
            pass
        elif s.Lagrangian in known.glyphs and written.startswith("L", letters[0].position):
            found[token.position] = "∂L/∂t: write \\mathcal L for the Lagrangian"
        elif not of_vector:
            found[token.position] = "∂/∂t: write d/dt, or with a dot, if all that changes is meant"
        if not bracketed and _goes_on(scanned[i + 1 + len(operand) :]):
            found[token.position] = "the derivative could go on here: put brackets"
    return found


def _goes_on(behind: Sequence[Token]) -> bool:
    """Whether the product in front goes on, perhaps in the next row."""
    kinds = (token.kind for token in behind if token.kind not in _BLANK)
    first = next(kinds, "")
    if first == "LINE":
        return next(kinds, "") in _GOES_ON
    return bool(first) and first not in _ENDS


def _operand(scanned: Sequence[Token], at: int) -> Sequence[Token]:
    """The symbol, slope or fraction, or all to the closing bracket, that stands behind d/dt."""
    depth = 0
    for end in range(at, len(scanned)):
        depth += {"OPEN": 1, "_BEGIN": 1, "CLOSE": -1, "_END": -1}.get(scanned[end].kind, 0)
        if depth <= 0 and [x.kind for x in scanned[end + 1 : end + 2]] != ["_BEGIN"]:
            return scanned[at : end + 1]
    return scanned[at:]


@dataclass(frozen=True)
class _Listening(Notation):
    """Takes letters that it does not know down."""

    heard: dict[Glyph, Symbol] = field(default_factory=dict)

    def symbol(self, glyph: Glyph) -> Symbol | None:
        known = super().symbol(glyph)
        if known is None and not (glyph.accent or glyph.bold or glyph.prime):
            name = "own_" + glyph.base + glyph.sub
            meaning = Quantity(glyph, "defined in the answer", "")
            return self.heard.setdefault(glyph, Lettered(name, meaning, real=True))
        return known


def steps(source: str, notation: Notation) -> Iterator[Step]:
    """The lines of an answer, in order; where mathematics was passed over, that too."""
    taken: list[Formula | Problem] = [*formulas(source), *problems(source), *bare(source)]
    place = places(source)
    count = 0
    for found in sorted(taken, key=_position):
        for step in _steps(source, found, notation, place):
            count += 1
            if count > MOST_LINES:
                yield Step(step.number, Line(0, None, f"more than {MOST_LINES} lines"), "")
                return
            yield step


def _position(found: Formula | Problem) -> int:
    return found.start if isinstance(found, Formula) else found.position


def _steps(
    source: str,
    formula: Formula | Problem,
    notation: Notation,
    place: Callable[[int], tuple[int, int]],
) -> Iterator[Step]:
    if isinstance(formula, Problem):
        rest = source[formula.position : formula.position + 60].split("\n", 1)[0]
        yield Step(place(formula.position)[0], Line(0, None, formula.reason), rest)
        return
    written = formula.text
    listening = _Listening(**{x.name: getattr(notation, x.name) for x in fields(notation)})
    scanned: list[Token] = []
    with suppress(UnreadError, RecursionError):  # `read` says so again, with the line
        scanned = tokens(written, listening)
    heard = listening.heard
    known = replace(
        notation, glyphs={**notation.glyphs, **{x: glyph for glyph, x in heard.items()}}
    )
    try:
        found = read(written, known, Habits(conditions=True))
    except RecursionError:
        found = (Line(0, None, "nested too deeply"),)
    for line in _with_doubts(found, _doubtful(scanned, written, known), written):
        if line.equation is None and not formula.display and "no relation" in line.problem:
            continue  # a symbol in the running text
        at, _ = place(formula.start + min(line.position, len(formula.text)))
        own = frozenset(heard.values())
        if line.equation is not None:
            own &= symbols_of(line.equation)
        yield Step(at, line, " ".join(formula.text.split()), own)


def _with_doubts(lines: Sequence[Line], doubts: Mapping[int, str], written: str) -> list[Line]:
    """Lines, those unread within which there is a doubt."""
    made = list(lines)
    for position, problem in doubts.items():
        within = [i for i, line in enumerate(made) if line.position <= position]
        i = within[-1] if within else 0
        behind = made[i + 1 : i + 2]
        if behind and behind[0].equation is None and "\\\\" in written[made[i].position : position]:
            continue  # it stands in the line behind, which is told by the place of its fault
        if made and made[i].equation is not None:
            made[i] = Line(made[i].position, None, problem)
    return made


def too_large(equation: Equation) -> str:
    """What makes an equation too large to be multiplied out, or nothing."""
    trees = [e for side in equation.sides for e in (side if is_matrix(side) else [side])]
    if sum(int(sympy.count_ops(tree)) for tree in trees) > MOST_OPERATIONS:
        return f"more than {MOST_OPERATIONS} operations"
    for tree in trees:
        for power in tree.atoms(Pow):
            exponent = power.exp if power.exp.has(Pow) else value(power.exp, {})
            if not exponent.is_Number or abs(exponent) > LARGEST_POWER:
                return f"an exponent that is not a number up to {LARGEST_POWER}"
            if power.base.atoms(Pow) and abs(exponent) > 4:
                return "a high power of a power"
        if any(max(abs(n.p), n.q) > LARGEST_NUMBER for n in tree.atoms(sympy.Rational)):
            return f"a number beyond {LARGEST_NUMBER:.0e}"
    return ""
