"""Sentences that say what is done: "Put (3.44) and the potential into the Lagrangian:".

A small language, in the words of the blackboard.  A sentence stands in front of a display and names
a move (`rigidtop.proof.moves`), what it is done with, and what is put in besides:

    Put A, B and C into D.                  Take the component of A along $e$.
    Differentiate A by $x$.                 Resolve A along $e$, $f$ and $g$.
    Take the rate of A.                     Dot A with $e$.      Cross $e$ with A.
    Dot A with itself.  (each of its equations with each)
    Integrate A.  (to a constant)           Integrate A from $x = x_0$.  (where t = 0)
    Integrate A from $x = x_0$ to $x = x_1$.  (A gives $\\dot x$; this the time that it takes)
    Add A to B.                             Subtract $f$ times A from B.
    Sum A over all parts.  (k)
    Multiply A by $f$.                      Divide A by $f$.
    Multiply A by B.  (both sides: of a = b and c = d, ac = bd)
    Multiply A by $O$ from the right.       Exchange the factors in A.  (of a product that is 1)
    Take the transpose of A.                Take the determinant of A.
    Strip $x$, $y$ and $z$ from A.  (Ax = Bx, Ay = By and Az = Bz give A = B)
    Rearrange A.   Expand A.   Collect A.   Factor A.
    Exchange $k$ and $l$ in A.              (the indices of two sums)
    Solve A for $x$.                        Solve A for $x$, without $y$.
    Take the root of A.                     Square A.
    Take the sine of A.                     (or the cosine, or the logarithm)
    Take the sign of A.  (A's right side is < 0 or > 0)
    Ask whether A vanishes.  (it is ≠ 0)
    Set $x = 0$ in A.                       Set $x = 0$ at all times in A.
    Set $x = 0$ at the start in A.  (what A says is constant, with what is cited)
    Expand A to second order in $x$.        Neglect $f$ in A, for large $x$.  (or small)
    Expand A to first order in $x$ and $y$.  (both small alike)
    Call the name of it.                    (a definition)

Behind a comma may stand "with B" (put in as well) and "for $x > 0$" (under a condition).  A, B are
numbers in brackets, names, letters in dollars, "it" (the line above) or "both" (the two above).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from sympy import Expr, Symbol

from rigidtop.notation import Notation
from rigidtop.proof.equation import BODY, SPACE, Equation, symbols_of
from rigidtop.proof.moves import Condition, Known, Move
from rigidtop.read.equations import equations as read
from rigidtop.theory.symbols import Glyph, const


class SentenceError(ValueError):
    """A sentence that is not of this language, and what would be right."""


_MATH = re.compile(r"\$([^$]+)\$")


@dataclass(frozen=True)
class Context:
    """What sentences may speak of: the lines above, in order, and how letters are written."""

    above: Sequence[Known]
    notation: Notation
    page: Sequence[Known] = ()
    """The lines of this page."""
    near: Sequence[Known] = ()
    """Those beneath the last heading, of which "it" is the last."""


def move(sentence: str, context: Context) -> Move:
    """The move that a sentence says.  Raises SentenceError."""
    plain = " ".join(sentence.strip().rstrip(":").split())
    plain = re.sub(r"^(?:Now|Then|Next|Again|Finally|And),? +", "", plain)
    plain = plain[:1].upper() + plain[1:]
    body, using, where = _suffixes(plain, context)
    for pattern, shape in _PATTERNS:
        found = pattern.fullmatch(body)
        if found is not None:
            made = shape.move(found.groupdict(), context)
            using = (*made.using, *using)
            by = _as_cited(made.by, (*made.of, *using), context.notation)
            return replace(made, by=by, using=using, where=(*made.where, *where), words=sentence)
    first = plain.split()[0] if plain else ""
    raise SentenceError(f"no move begins with {first!r}" if first not in _FIRST else _hint(first))


def _as_cited(by: Sequence[Any], cited: Sequence[Known], notation: Notation) -> tuple[Any, ...]:
    """Letters as those of what is cited, where others are written alike: A as a matrix."""
    there = {x for known in cited for e in known.equations for x in symbols_of(e)}
    glyphs = {notation.glyphs[x]: x for x in there if x in notation.glyphs}
    return tuple(
        each if each in there or not isinstance(each, Symbol) else _alike(each, glyphs, notation)
        for each in by
    )


def _alike(letter: Symbol, glyphs: Mapping[Glyph, Symbol], notation: Notation) -> Symbol:
    glyph = notation.glyphs.get(letter)
    return letter if glyph is None else glyphs.get(glyph, letter)


def _suffixes(plain: str, context: Context) -> tuple[str, tuple[Known, ...], tuple[Condition, ...]]:
    """The sentence without ", with …" and ", for …", and what these say."""
    using: tuple[Known, ...] = ()
    where: tuple[Condition, ...] = ()
    while True:
        found = re.fullmatch(r"(.*), (with|for) (.+?)", plain) if ", " in plain else None
        if found is None:
            return plain, using, where
        body, word, rest = found.groups()
        if word == "for":
            if not _MATH.match(rest):
                return plain, using, where
            _only_and(rest)
            where = (*(_condition(m[1], context) for m in _MATH.finditer(rest)), *where)
        else:
            using = (*_list(rest, context), *using)
        plain = body


def _condition(latex: str, context: Context) -> Condition:
    equation = _equation(latex, context)
    if len(equation.sides) != 2:
        raise SentenceError(f"${latex}$: two sides, and another condition behind an “and”")
    left, right = equation.sides
    difference = left - right if right != 0 else left
    if equation.relation == "<":
        return Condition(right - left, ">")
    if equation.relation in (">", "≠"):
        return Condition(difference, equation.relation)
    raise SentenceError(f"a condition is ≠, > or <, not {equation.relation}")


def _equation(latex: str, context: Context) -> Equation:
    lines = read(latex, context.notation)
    if len(lines) != 1 or lines[0].equation is None:
        raise SentenceError(f"${latex}$ is not read: {lines[0].problem}")
    return lines[0].equation


def _expression(latex: str, context: Context) -> Expr:
    side, *more = _equation(latex + " = 0", context).sides
    if len(more) > 1:
        raise SentenceError(f"${latex}$ is an equation: its left side says which is meant")
    return side


def _only_and(said: str) -> list[str]:
    """Mathematics in dollars, with nothing but commas and "and" between."""
    found = _MATH.findall(said)
    if not found or set(_MATH.sub("", said).replace(",", " ").split()) - {"and"}:
        raise SentenceError(f"{said!r}: letters stand in dollars, with “and” between them")
    return found


def _list(said: str, context: Context) -> tuple[Known, ...]:
    """What "A, B and C" names."""
    said = said.strip()
    if said in ("both", "both of them"):
        return _last(context, 2)
    if said == "all three":
        return _last(context, 3)
    one = _named(said, context)
    if one is not None:
        return (one,)
    parts = [p.strip() for p in re.split(r",(?: and)? | and ", said)]
    if len(parts) == 1:
        raise SentenceError(_unknown(said, context))
    return tuple(k for part in parts for k in _list(part, context))


def _last(context: Context, count: int) -> tuple[Known, ...]:
    if len(context.near) < count:
        raise SentenceError("there are not so many lines above, beneath this heading: name them")
    return tuple(context.near[-count:])


def _named(said: str, context: Context) -> Known | None:
    if said in ("it", "this"):
        return _last(context, 1)[0]
    number = re.fullmatch(r"\(([^()\s]+)\)", said)
    if number is not None:
        return next((k for k in reversed(context.above) if k.tag == number[1]), None)
    letter = _MATH.fullmatch(said)
    if letter is not None:
        return _of_letter(_expression(letter[1], context), context)
    name = _key(said)
    return next((k for k in reversed(context.above) if k.called and _key(k.called) == name), None)


def _of_letter(letter: Expr, context: Context) -> Known | None:
    """The last equation of this page, else of those before, that says what a letter is."""
    for lines in (context.page, context.above):
        for says in (_says_what, _says_constant, _bounds):
            for known in reversed(lines):
                own = tuple(e for e in known.equations if says(letter, e))
                if own:
                    return replace(known, equations=own)
    return None


def _says_what(letter: Expr, equation: Equation) -> bool:
    what = equation.sides[0] == letter and equation.sides[1:] != (const,)
    return what and equation.relation in ("=", "≡", "≈")


def _says_constant(letter: Expr, equation: Equation) -> bool:
    return bool(equation.sides == (letter, const))


def _bounds(letter: Expr, equation: Equation) -> bool:
    return equation.relation in "<≤≥>" and bool(equation.sides[0] == letter)


def is_taken(name: str, context: Context) -> bool:
    """Whether something above goes by a name."""
    return any(k.called and _key(k.called) == _key(name) for k in context.above)


def _key(name: str) -> str:
    words = re.sub(r"^(?:the|a|an) ", "", name.strip(), flags=re.I)
    return " ".join(words.split()).lower()


def _unknown(said: str, context: Context) -> str:
    from difflib import get_close_matches

    names = [k.called for k in context.above if k.called] + [
        f"({k.tag})" for k in context.above if k.tag
    ]
    keys = {_key(name): name for name in names}
    near = [keys[key] for key in get_close_matches(_key(said), keys, n=2)]
    hint = f"did you mean {' or '.join(near)}?" if near else _CALLED
    return f"nothing above is called {said!r}; {hint}"


_CALLED = "a line goes by its number, its name, its left side in dollars, “it” or “both”"


_A, _B, _U = (f"(?P<{name}>.+?)" for name in "abu")
_X, _L = r"(?P<x>.+?)", r"(?P<x>\$[^$]+\$)"
_POWERS = {"zeroth": 0, "first": 1, "second": 2, "third": 3, "fourth": 4, "large": 1, "small": -1}


class _Shape(NamedTuple):
    """A sentence of the language, and the verb of its move.

    The groups `a` and `b` name the lines that the move is of, `u` those that are put in, `x`, `y`
    and `w` letters in dollars (as many as `w` has are to be without), `s` and `e` equations that
    set a letter, `k` and `l` indices; `n` is a word for the power.
    """

    pattern: str
    verb: str
    power: int = 0
    by: tuple[Any, ...] = ()

    def move(self, parts: Mapping[str, str | None], context: Context) -> Move:
        """The move that a sentence of this shape says."""

        def each(names: str, take: Callable[[str, Context], Sequence[Any]]) -> tuple[Any, ...]:
            return tuple(
                x for name in names if (said := parts.get(name)) for x in take(said, context)
            )

        without = each("w", _math)
        by = (*each("xy", _math), *without, *each("se", _settings), *each("kl", _index), *self.by)
        of = each("ab", _list) * (2 if parts.get("twice") else 1)
        power = len(without) or _POWERS.get(parts.get("n") or "", self.power)
        using = each("u", _list)
        if any(known in of for known in using):
            raise SentenceError("a line is put into another, not into itself: name those put in")
        return Move(self.verb, of, by=by, using=using, power=power)


def _math(said: str, context: Context) -> tuple[Expr, ...]:
    return tuple(_expression(latex, context) for latex in _only_and(said))


def _settings(said: str, context: Context) -> tuple[Equation, ...]:
    found = tuple(_equation(latex, context) for latex in _only_and(said))
    for latex, equation in zip(_only_and(said), found, strict=True):
        if equation.relation != "=" or len(equation.sides) != 2:
            raise SentenceError(f"${latex}$: a letter is set with one =")
    return found


def _index(said: str, _: Context) -> tuple[Symbol]:
    return (Symbol(said),)


_SHAPES = (
    _Shape(rf"Put {_U} into {_A}", "put"),
    _Shape(rf"Compare {_U} with {_A}", "put"),
    _Shape(rf"Differentiate {_A} by {_X}", "differentiate"),
    _Shape(rf"Take the rate of {_A} in the body", "rate", by=(BODY,)),
    _Shape(rf"Take the rate of {_A} in space", "rate", by=(SPACE,)),
    _Shape(rf"Take the rate of {_A}", "rate"),
    _Shape(rf"Integrate {_A} from (?P<s>\$[^$]+\$) to (?P<e>\$[^$]+\$)", "integrate", 1),
    _Shape(rf"Integrate {_A} from (?P<s>\$.+\$)", "integrate"),
    _Shape(rf"Integrate {_A}", "integrate"),
    _Shape(rf"Take the component of {_A} along {_X}", "component"),
    _Shape(rf"Resolve {_A} along {_X}", "component"),
    *(
        shape
        for verb in ("dot", "cross")
        for shape in (
            _Shape(rf"{verb.title()} {_A} with (?P<twice>itself)", verb),
            _Shape(rf"{verb.title()} {_A} with {_L}", verb, 1),
            _Shape(rf"{verb.title()} {_L} with {_A}", verb),
            _Shape(rf"{verb.title()} {_A} with {_B}", verb),
        )
    ),
    _Shape(rf"Add {_L} times {_A} to {_B}", "add", by=(1,)),
    _Shape(rf"Add {_A} to {_B}", "add"),
    _Shape(rf"Subtract {_L} times {_A} from {_B}", "subtract", by=(1,)),
    _Shape(rf"Subtract {_A} from {_B}", "subtract"),
    _Shape(rf"Sum {_A} over all parts", "sum", by=(Symbol("k"),)),
    _Shape(rf"Multiply {_A} by {_L} from the right", "multiply", 1),
    _Shape(rf"Multiply {_A} by (?P<x>.*\$.*)", "multiply"),
    _Shape(rf"Multiply {_A} by {_B}", "multiply"),
    _Shape(rf"Take the transpose of {_A}", "transpose"),
    _Shape(rf"Take the determinant of {_A}", "determinant"),
    _Shape(rf"Exchange the factors in {_A}", "turn factors"),
    _Shape(rf"Strip {_X} from {_A}", "strip"),
    _Shape(rf"Divide {_A} by {_X}", "divide"),
    _Shape(rf"Expand {_A} to (?P<n>{'|'.join([*_POWERS][:5])}) order in {_X}", "expand"),
    _Shape(rf"(?:Rearrange|Expand|Factor|Rewrite) {_A}", "rewrite"),
    _Shape(rf"Collect {_A}(?: in .+?)?", "rewrite"),
    _Shape(rf"Exchange \$(?P<k>[a-z])\$ and \$(?P<l>[a-z])\$ in {_A}", "exchange"),
    _Shape(rf"Solve {_A} for (?P<x>\$.+\$), without (?P<w>\$.+\$)", "solve"),
    _Shape(rf"Solve {_A} for (?P<x>\$.+\$)", "solve"),
    *(
        _Shape(rf"Take the {what} of {_A}", what)
        for what in ("root", "sign", "sine", "cosine", "logarithm")
    ),
    _Shape(rf"Ask whether {_A} vanishes", "sign"),
    _Shape(rf"Square {_A}", "square"),
    _Shape(rf"Neglect {_X} in {_A}, for (?P<n>large|small) (?P<y>\$[^$]+\$)", "neglect"),
    _Shape(rf"Neglect {_X} in {_A}", "neglect"),
    _Shape(rf"Set (?P<s>.+?) at all times in {_A}", "set", 1),
    _Shape(rf"Set (?P<s>.+?) at the start in {_A}", "set", 2),
    _Shape(rf"Set (?P<s>.+?) in {_A}", "set"),
)
_PATTERNS = tuple((re.compile(shape.pattern), shape) for shape in _SHAPES)
_FIRST = {shape.pattern.split()[0] for shape in _SHAPES} | {
    *("Rearrange", "Expand", "Factor", "Rewrite")
}
DEFINES = re.compile(r"Call (?P<name>.+)")


def definition(words: str, context: Context) -> tuple[str, tuple[Known, ...]]:
    """The name that a definition gives, and what it cites."""
    body, using, where = _suffixes(words, context)
    if where:
        raise SentenceError("a definition has no condition")
    return body.removeprefix("Call "), using


def _hint(first: str) -> str:
    return f"written so: {', or '.join(f'“{e}:”' for e in _EXAMPLES if e.startswith(first))}"


_TABLE = "".join((__doc__ or "").split("\n\n")[2:3])  # none under python -OO
_EXAMPLES = tuple(
    " ".join(each.split())
    for each in re.findall(r"(?:Put|Take|[A-Z][a-z]+) [^.:\n]+(?=[.:])", _TABLE)
)
"""The sentences of the table at the top."""


__all__ = ["BODY", "DEFINES", "SPACE", "Context", "SentenceError", "Symbol", "move"]
