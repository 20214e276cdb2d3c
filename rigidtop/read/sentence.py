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
    Take the sign of A.  (A's right side is < 0, > 0 or ≠ 0)
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
from typing import Any

from sympy import Expr, Symbol

from rigidtop.notation import Notation
from rigidtop.proof.equation import BODY, SPACE, Equation
from rigidtop.proof.moves import Condition, Known, Move
from rigidtop.read.formula import read
from rigidtop.theory.symbols import const


class SentenceError(ValueError):
    """A sentence that is not of this language, and what would be right."""


ORDERS = {"zeroth": 0, "first": 1, "second": 2, "third": 3, "fourth": 4}
_MATH = re.compile(r"\$([^$]+)\$")
_REF = r"(?P<{}>.+?)"


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
    for pattern, build in _PATTERNS:
        found = pattern.fullmatch(body)
        if found is not None:
            made = build(_Words(found.groupdict(), context))
            return replace(
                made, using=(*made.using, *using), where=(*made.where, *where), words=sentence
            )
    first = plain.split()[0] if plain else ""
    raise SentenceError(f"no move begins with {first!r}" if first not in _FIRST else _hint(first))


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


@dataclass(frozen=True)
class _Words:
    """The parts of a sentence that matched."""

    parts: Mapping[str, str]
    context: Context

    def known(self, name: str) -> tuple[Known, ...]:
        return _list(self.parts[name], self.context)

    def math(self, name: str) -> tuple[Expr, ...]:
        return tuple(_expression(latex, self.context) for latex in _only_and(self.parts[name]))

    def equations(self, name: str) -> tuple[Equation, ...]:
        found = []
        for latex in _only_and(self.parts[name]):
            equation = _equation(latex, self.context)
            if equation.relation != "=" or len(equation.sides) != 2:
                raise SentenceError(f"${latex}$: a letter is set with one =")
            found.append(equation)
        return tuple(found)


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
        for known in reversed(lines):
            own = tuple(e for e in known.equations if _says_what(letter, e))
            if own:
                return replace(known, equations=own)
        for known in reversed(lines):
            own = tuple(e for e in known.equations if e.sides == (letter, const))
            if own:
                return replace(known, equations=own)
        for known in reversed(lines):
            own = tuple(e for e in known.equations if e.relation in "<≤≥>" and e.sides[0] == letter)
            if own:
                return replace(known, equations=own)
    return None


def _says_what(letter: Expr, equation: Equation) -> bool:
    return (
        equation.sides[0] == letter
        and equation.sides[1:] != (const,)
        and equation.relation in ("=", "≡", "≈")
    )


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
    near = get_close_matches(said, names, n=2)
    hint = f"; did you mean {' or '.join(near)}?" if near else ""
    return f"nothing above is called {said!r}{hint}"


def _simple(verb: str, **fixed: Any) -> Callable[[_Words], Move]:
    return lambda w: Move(verb, w.known("a"), **fixed)


def _by(verb: str, **fixed: Any) -> Callable[[_Words], Move]:
    return lambda w: Move(verb, w.known("a"), by=w.math("x"), **fixed)


def _multiply(w: _Words) -> Move:
    if "$" in w.parts["x"]:
        return Move("multiply", w.known("a"), by=w.math("x"))
    return Move("multiply", (*w.known("a"), *w.known("x")))


def _put(w: _Words) -> Move:
    return Move("put", w.known("b"), using=w.known("a"))


def _rate(frame: Expr | None = None) -> Callable[[_Words], Move]:
    return lambda w: Move("rate", w.known("a"), by=() if frame is None else (frame,))


def _product(verb: str) -> Callable[[_Words], Move]:
    def build(w: _Words) -> Move:
        a, b = w.parts["a"], w.parts["b"]
        if b == "itself":
            return Move(verb, w.known("a") * 2)
        if _is_vector(b, w.context):
            return Move(verb, w.known("a"), by=w.math("b"), power=1)
        if _is_vector(a, w.context):
            return Move(verb, w.known("b"), by=w.math("a"))
        return Move(verb, (*w.known("a"), *w.known("b")))

    return build


def _is_vector(said: str, context: Context) -> bool:
    """Whether a letter in dollars is meant as itself, not as the equation that says what it is."""
    return _MATH.fullmatch(said.strip()) is not None


def _combined(verb: str) -> Callable[[_Words], Move]:
    def build(w: _Words) -> Move:
        factor = w.math("x")[0] if w.parts.get("x") else None
        by = () if factor is None else (factor, 1)
        return Move(verb, (*w.known("a"), *w.known("b")), by=by)

    return build


def _solve(w: _Words) -> Move:
    without = w.math("y") if w.parts.get("y") else ()
    return Move("solve", w.known("a"), by=(*w.math("x"), *without), power=len(without))


def _exchange(w: _Words) -> Move:
    return Move("exchange", w.known("a"), by=tuple(Symbol(w.parts[x]) for x in "xy"))


def _expand(w: _Words) -> Move:
    return Move("expand", w.known("a"), by=w.math("x"), power=ORDERS[w.parts["n"]])


def _neglect(w: _Words) -> Move:
    power = 1 if w.parts["n"] == "large" else -1
    return Move("neglect", w.known("a"), by=(*w.math("x"), *w.math("y")), power=power)


def _between(w: _Words) -> Move:
    begin, end = w.equations("x"), w.equations("y")
    if len(begin) != 1 or len(end) != 1:
        raise SentenceError("one letter is integrated over, from one value to another")
    return Move("integrate", w.known("a"), by=(*begin, *end), power=1)


def _integrate(w: _Words) -> Move:
    return Move("integrate", w.known("a"), by=w.equations("x"))


def _set(when: int) -> Callable[[_Words], Move]:
    return lambda w: Move("set", w.known("a"), by=w.equations("x"), power=when)


_A, _B, _X, _Y = (_REF.format(name) for name in "abxy")
_SHAPES: tuple[tuple[str, Callable[[_Words], Move]], ...] = (
    (rf"Put {_A} into {_B}", _put),
    (rf"Compare {_A} with {_B}", _put),
    (rf"Differentiate {_A} by {_X}", _by("differentiate")),
    (rf"Take the rate of {_A} in the body", _rate(BODY)),
    (rf"Take the rate of {_A} in space", _rate(SPACE)),
    (rf"Take the rate of {_A}", _rate()),
    (rf"Integrate {_A} from (?P<x>\$.+\$) to (?P<y>\$.+\$)", _between),
    (rf"Integrate {_A} from (?P<x>\$.+\$)", _integrate),
    (rf"Integrate {_A}", _simple("integrate")),
    (rf"Take the component of {_A} along {_X}", _by("component")),
    (rf"Resolve {_A} along {_X}", _by("component")),
    (rf"Dot {_A} with {_B}", _product("dot")),
    (rf"Cross {_A} with {_B}", _product("cross")),
    (rf"Add (?:(?P<x>\$[^$]+\$) times )?{_A} to {_B}", _combined("add")),
    (rf"Subtract (?:(?P<x>\$[^$]+\$) times )?{_A} from {_B}", _combined("subtract")),
    (rf"Sum {_A} over all parts", _simple("sum", by=(Symbol("k"),))),
    (rf"Multiply {_A} by (?P<x>\$[^$]+\$) from the right", _by("multiply", power=1)),
    (rf"Multiply {_A} by {_X}", _multiply),
    (rf"Take the transpose of {_A}", _simple("transpose")),
    (rf"Take the determinant of {_A}", _simple("determinant")),
    (rf"Exchange the factors in {_A}", _simple("turn factors")),
    (rf"Strip {_X} from {_A}", _by("strip")),
    (rf"Divide {_A} by {_X}", _by("divide")),
    (rf"Expand {_A} to (?P<n>{'|'.join(ORDERS)}) order in {_X}", _expand),
    (rf"(?:Rearrange|Expand|Factor|Rewrite) {_A}", _simple("rewrite")),
    (rf"Collect {_A}(?: in {_X})?", _simple("rewrite")),
    (rf"Exchange \$(?P<x>[a-z])\$ and \$(?P<y>[a-z])\$ in {_A}", _exchange),
    (rf"Solve {_A} for (?P<x>\$.+\$), without (?P<y>\$.+\$)", _solve),
    (rf"Solve {_A} for (?P<x>\$.+\$)", _solve),
    (rf"Take the root of {_A}", _simple("root")),
    (rf"Take the sign of {_A}", _simple("sign")),
    *((rf"Take the {f} of {_A}", _simple(f)) for f in ("sine", "cosine", "logarithm")),
    (rf"Square {_A}", _simple("square")),
    (rf"Neglect {_X} in {_A}, for (?P<n>large|small) (?P<y>\$[^$]+\$)", _neglect),
    (rf"Neglect {_X} in {_A}", _by("neglect")),
    (rf"Set {_X} at all times in {_A}", _set(1)),
    (rf"Set {_X} at the start in {_A}", _set(2)),
    (rf"Set {_X} in {_A}", _set(0)),
)
_PATTERNS = tuple((re.compile(shape), build) for shape, build in _SHAPES)
_FIRST = {shape.split()[0] for shape, _ in _SHAPES} | {"Rearrange", "Expand", "Factor", "Rewrite"}
DEFINES = re.compile(r"Call (?P<name>.+)")


def definition(words: str, context: Context) -> tuple[str, tuple[Known, ...]]:
    """The name that a definition gives, and what it cites."""
    body, using, where = _suffixes(words, context)
    if where:
        raise SentenceError("a definition has no condition")
    return body.removeprefix("Call "), using


def _hint(first: str) -> str:
    return f"written so: {', or '.join(f'“{e}:”' for e in _EXAMPLES if e.startswith(first))}"


_EXAMPLES = tuple(
    " ".join(each.split())
    for each in re.findall(r"(?:Put|Take|[A-Z][a-z]+) [^.:\n]+(?=[.:])", __doc__.split("\n\n")[2])
)
"""The sentences of the table at the top."""


__all__ = ["BODY", "DEFINES", "SPACE", "Context", "SentenceError", "Symbol", "move"]
