"""Sentences that say what is done: "Substitute (3.44) and the potential into the Lagrangian:".

A small language, in the words of the blackboard.  A sentence stands in front of a display and names
a move (`rigidtop.proof.moves`), what it is done with, and what is put in besides:

    Substitute A, B and C into D.           Substitute A into B.
    Differentiate A with respect to $x$.    Differentiate A in time.
    Differentiate A in time in the body frame.  (or in the space frame)
    Differentiate A with respect to $x$ along the motion.  ($du/dx = \\dot u/\\dot x$)
    Integrate A.  (to a constant)           Integrate A from $x = x_0$.  (where t = 0)
    Integrate A from $x = x_0$ to $x = x_1$.  (A gives $\\dot x$; this the time that it takes)
    Integrate A over $\\phi$ from $x = x_0$.  (where $\\phi = 0$)
    Hence $p$ is conserved.                 (the line above says that its rate is 0)
    Project A on $e$.                       Project A on $e$, $f$ and $g$.
    Both sides of A agree only if their components along $e$, $f$ and $g$ do.  (the same)
    Take the scalar product of A with $e$.  Take the vector product of $e$ with A.
    Take the scalar product of A with itself.  (each of its equations with each)
    Add A to B.                             Subtract $f$ times A from B.
    Add $f$ to A.                           (to both of its sides)
    Sum A over all parts.  (k)
    Multiply A by $f$.                      Divide A by $f$.      Divide A by $f \\neq 0$.
    Multiply A by B.  (both sides: of a = b and c = d, ac = bd)
    Multiply A by $O$ from the right.       Exchange the factors in A.  (of a product that is 1)
    Take the transpose of A.                Take the determinant of A.
    Cancel $x$, $y$ and $z$ in A.           (Ax = Bx, Ay = By and Az = Bz give A = B)
    Rearrange A.   Expand A.   Collect A.   Factor A.   Rewrite A.   Simplify A.
    Exchange $k$ and $l$ in A.              (the indices of two sums)
    Solve A for $x$.                        Solve A for $x$, eliminating $y$.
    Eliminate $x$ and $y$ from A.  (linear and with no rest: the determinant is 0)
    Take the square root of A.              Square A.
    Take the sine of A.                     (or the cosine, or the logarithm)
    Determine the sign of A.                (A's right side is < 0 or > 0)
    Hence A does not vanish.                (it is ≠ 0)
    Set $x = 0$ in A.                       Set $x = 0$ at all times in A.
    Set $x = 0$ at the start in A.  (what A says is constant, with what is cited)
    Expand A to second order in $x$.        Drop $f$ in A, for large $x$.  (or small)
    Expand A to first order in $x$ and $y$.  (both small alike)
    Define the name of it.                  (a definition)

In front, or behind a comma, may stand "using B" (put in as well), and "for $x > 0$" or "if $x > 0$"
(under a condition): "Using (3.55), differentiate (3.53) in time"; "For a fast top (large $x$), drop
$f$". A, B are numbers in brackets, names, letters or equations in dollars, "it" or "this" (the line
directly above) or "both" (the two above); a letter may have an article, as names have. Where none
is named the line above is meant: "Differentiate in time", "Project on $e$", "Substitute into
(3.53)". What lecturers say besides is read alike: put, insert, neglect, dot with, resolve along,
take the component along, differentiate by, call.
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
_ARTICLE = re.compile(r"\b(?:the|an?) (?=\$)", re.I)
"""What may stand before a letter as before a name in words: "differentiate the $V$ in time"."""


@dataclass(frozen=True)
class Antecedents:
    """What sentences may speak of: the lines above, in order, and how letters are written."""

    above: Sequence[Known]
    notation: Notation
    page: Sequence[Known] = ()
    """The lines of this page."""
    near: Sequence[Known] = ()
    """Those beneath the last heading, of which "it" is the last."""


def move(sentence: str, context: Antecedents) -> Move:
    """The move that a sentence says.  Raises SentenceError."""
    plain = _capital(_ARTICLE.sub("", _plain(sentence)))
    body, using, where = _circumstances(plain, context)
    for pattern, shape in _PATTERNS:
        found = pattern.fullmatch(body)
        if found is not None:
            made = shape.move(found.groupdict(), context)
            using = (*made.using, *using)
            by = _as_cited(made.by, (*made.of, *using), context.notation)
            return replace(made, by=by, using=using, where=(*made.where, *where), words=sentence)
    first = plain.split()[0] if plain else ""
    raise SentenceError(f"no move begins with {first!r}" if first not in _FIRST else _hint(first))


def _plain(sentence: str) -> str:
    plain = " ".join(sentence.strip().rstrip(":").split())
    return _capital(re.sub(r"^(?:Now|Then|Next|Again|Finally|And|Hence|So|Thus),? +", "", plain))


def _capital(said: str) -> str:
    return said[:1].upper() + said[1:]


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


def _circumstances(
    plain: str, context: Antecedents
) -> tuple[str, tuple[Known, ...], tuple[Condition, ...]]:
    """The sentence without "using …" and "for …", in front or behind, and what these say."""
    opening = _OPENING.fullmatch(plain)
    if opening is not None:
        word, said, rest = opening.groups()
        body, using, where = _circumstances(_capital(rest), context)
        body, more, also = _circumstances(f"{body}, {word.lower()} {said}", context)
        return body, (*more, *using), (*also, *where)
    using, where = (), ()
    while True:
        found = re.fullmatch(r"(.*), (with|using|for|if) (.+?)", plain) if ", " in plain else None
        if found is None:
            return plain, using, where
        body, word, rest = found.groups()
        if word in ("for", "if"):
            if not _MATH.match(rest):
                return plain, using, where
            _only_and(rest)
            where = (*(_condition(m[1], context) for m in _MATH.finditer(rest)), *where)
        else:
            using = (*_list(rest, context), *using)
        plain = body


def _condition(latex: str, context: Antecedents) -> Condition:
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


def _equation(latex: str, context: Antecedents) -> Equation:
    lines = read(latex, context.notation)
    if len(lines) != 1 or lines[0].equation is None:
        raise SentenceError(f"${latex}$ is not read: {lines[0].problem}")
    return lines[0].equation


def _expression(latex: str, context: Antecedents) -> Expr:
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


def _list(said: str, context: Antecedents) -> tuple[Known, ...]:
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


def _last(context: Antecedents, count: int) -> tuple[Known, ...]:
    if len(context.near) < count:
        raise SentenceError("there are not so many lines above, beneath this heading: name them")
    return tuple(context.near[-count:])


def _named(said: str, context: Antecedents) -> Known | None:
    if said in ("it", "It", "this", "both sides", "the right-hand side"):
        return _last(context, 1)[0]
    number = re.fullmatch(r"\(([^()\s]+)\)", said)
    if number is not None:
        return next((k for k in reversed(context.above) if k.tag == number[1]), None)
    letter = _MATH.fullmatch(said)
    if letter is not None:
        sides = _equation(f"{letter[1]} = 0", context).sides[:-1]
        return _of_equation(sides, context) if sides[1:] else _of_letter(sides[0], context)
    name = _key(said)
    return next((k for k in reversed(context.above) if k.called and _key(k.called) == name), None)


def _of_equation(sides: Sequence[Expr], context: Antecedents) -> Known | None:
    """The last line above that says an equation."""
    for known in reversed(context.above):
        own = tuple(e for e in known.equations if e.sides == sides and e.relation == "=")
        if own:
            return replace(known, equations=own)
    return None


def _of_letter(letter: Expr, context: Antecedents) -> Known | None:
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


def is_taken(name: str, context: Antecedents) -> bool:
    """Whether something above goes by a name."""
    return any(k.called and _key(k.called) == _key(name) for k in context.above)


def _key(name: str) -> str:
    words = re.sub(r"^(?:the|a|an) ", "", _ARTICLE.sub("", name.strip()), flags=re.I)
    return " ".join(words.split()).lower()


def _unknown(said: str, context: Antecedents) -> str:
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
_FUNCTIONS = ("sine", "cosine", "logarithm", "sign")
_POWERS = {"zeroth": 0, "first": 1, "second": 2, "third": 3, "fourth": 4, "large": 1, "small": -1}


class _Shape(NamedTuple):
    """A sentence of the language, and the verb of its move.

    The groups `a` and `b` name the lines that the move is of, `u` those that are put in, each the
    line above where nothing is said; `x`, `y` and `w` letters in dollars (as many as `w` has are to
    be without), `d` what it is divided by, `s` and `e` equations that set a letter, `k` and `l`
    indices; `t` is a term, or the line that says what that is, `n` a word for the power.
    """

    pattern: str
    verb: str
    power: int = 0
    by: tuple[Any, ...] = ()

    def move(self, parts: Mapping[str, str | None], context: Antecedents) -> Move:
        """The move that a sentence of this shape says."""

        def each(names: str, take: Callable[[str, Antecedents], Sequence[Any]]) -> tuple[Any, ...]:
            said = (parts[name] or _ABOVE.get(name) for name in names if name in parts)
            return tuple(x for part in said if part for x in take(part, context))

        without = each("w", _math)
        by = (*each("xy", _math), *each("d", _divisor), *without)
        by = (*by, *each("se", _settings), *each("kl", _index), *self.by)
        of = each("ab", _list) * (2 if parts.get("twice") else 1)
        if term := parts.get("t"):
            known = _named(term, context)
            by = _math(term, context)
            if known is not None and all(e.relation not in "<≤≥>" for e in known.equations):
                of = (known, *of)
        power = len(without) or _POWERS.get(parts.get("n") or "", self.power)
        using = each("u", _list)
        if any(known in of for known in using):
            raise SentenceError("a line is put into another, not into itself: name those put in")
        unnamed = any(name in parts and not parts[name] for name in _ABOVE)
        return Move(self.verb, of, by=by, using=using, power=power, unnamed=unnamed)


_ABOVE = dict.fromkeys("abu", "it")
"""What is meant where a sentence does not name a line."""


def _math(said: str, context: Antecedents) -> tuple[Expr, ...]:
    return tuple(_expression(latex, context) for latex in _only_and(said))


def _divisor(said: str, context: Antecedents) -> tuple[Expr, ...]:
    """What both sides are divided by; that it does not vanish may be said, and is always asked."""
    latex, *zero = re.split(r"\\neq? *0(?=\$$)|≠ *0(?=\$$)", said)
    return _math(latex + "$" if zero else said, context)


def _settings(said: str, context: Antecedents) -> tuple[Equation, ...]:
    found = tuple(_equation(latex, context) for latex in _only_and(said))
    for latex, equation in zip(_only_and(said), found, strict=True):
        if equation.relation != "=" or len(equation.sides) != 2:
            raise SentenceError(f"${latex}$: a letter is set with one =")
    return found


def _index(said: str, _: Antecedents) -> tuple[Symbol]:
    return (Symbol(said),)


def _of(preposition: str) -> str:
    """A line behind a preposition, or nothing where the line above is meant."""
    return rf"(?: {preposition} {_A})?"


_OBJECT = rf"(?: (?:both sides of )?{_A})?"
_SIZE = r"(?:[^,$(]+ \()?(?P<n>large|small) (?P<y>\$[^$]+\$)\)?"

_SHAPES = (
    _Shape(rf"(?:Substitute|Put|Insert)(?: {_U})? into {_A}", "put"),
    _Shape(rf"(?:Substitute|Insert) {_U}(?: into {_A})?", "put"),
    _Shape(rf"Compare {_U} with {_A}", "put"),
    *(
        _Shape(rf"{said}{where}", "rate", by=by)
        for where, by in (
            (" in the body(?: frame)?", (BODY,)),
            (" in (?:the space frame|space)", (SPACE,)),
            ("", ()),
        )
        for said in (rf"Differentiate{_OBJECT} in time", rf"Take the rate{_of('of')}")
    ),
    _Shape(rf"Differentiate{_OBJECT} (?:by|with respect to) {_X} along the motion", "along"),
    _Shape(rf"Differentiate{_OBJECT} (?:by|with respect to) {_X}", "differentiate"),
    _Shape(rf"Integrate{_OBJECT} over {_L} from (?P<s>\$.+\$)", "integrate over"),
    _Shape(rf"Integrate{_OBJECT} from (?P<s>\$[^$]+\$) to (?P<e>\$[^$]+\$)", "integrate", 1),
    _Shape(rf"Integrate{_OBJECT} from (?P<s>\$.+\$)", "integrate"),
    _Shape(rf"Integrate{_OBJECT}", "integrate"),
    _Shape(rf"(?:By {_A}, )?{_U} is conserved", "integrate"),
    _Shape(rf"Project{_OBJECT} on {_X}", "component"),
    _Shape(rf"Take the components?{_of('of')} along {_X}", "component"),
    _Shape(rf"Resolve{_OBJECT} along {_X}", "component"),
    _Shape(rf"Both sides{_of('of')} agree only if their components along {_X} do", "component"),
    *(
        shape
        for said, verb in (
            (r"(?:Dot|Take the scalar product(?: of)?)", "dot"),
            (r"(?:Cross|Take the vector product(?: of)?)", "cross"),
        )
        for shape in (
            _Shape(rf"{said}{_OBJECT} with (?P<twice>itself)", verb),
            _Shape(rf"{said}{_OBJECT} with {_L}", verb, 1),
            _Shape(rf"{said} {_L} with {_A}", verb),
            _Shape(rf"{said}{_OBJECT} with {_B}", verb),
        )
    ),
    *(
        shape
        for verb, to in (("add", "to"), ("subtract", "from"))
        for shape in (
            _Shape(rf"{verb.title()} {_L} times {_A}(?: {to} {_B})?", verb, by=(1,)),
            _Shape(rf"{verb.title()} (?P<t>\$[^$=]+\$)(?: {to} {_B})?", verb),
            _Shape(rf"{verb.title()} {_A}(?: {to} {_B})?", verb),
        )
    ),
    _Shape(rf"Sum{_OBJECT} over all parts", "sum", by=(Symbol("k"),)),
    _Shape(rf"Multiply{_OBJECT} by {_L} from the right", "multiply", 1),
    _Shape(rf"Multiply{_OBJECT} by (?P<x>.*\$.*)", "multiply"),
    _Shape(rf"Multiply{_OBJECT} by {_B}", "multiply"),
    _Shape(rf"Take the transpose{_of('of')}", "transpose"),
    _Shape(rf"Take the determinant{_of('of')}", "determinant"),
    _Shape(rf"Exchange the factors{_of('in')}", "turn factors"),
    _Shape(rf"(?:Cancel|Strip) {_X}{_of('(?:in|from)')}", "strip"),
    _Shape(rf"Divide{_OBJECT} by (?P<d>.+?)", "divide"),
    _Shape(
        rf"Expand{_OBJECT} to (?P<n>{'|'.join([*_POWERS][:5])}) order in {_X}(?:, for [^,$]+)?",
        "expand",
    ),
    _Shape(rf"(?:Rearrange|Expand|Factor|Rewrite|Simplify){_OBJECT}", "rewrite"),
    _Shape(rf"Collect{_OBJECT}(?: in .+?)?", "rewrite"),
    _Shape(rf"Exchange \$(?P<k>[a-z])\$ and \$(?P<l>[a-z])\${_of('in')}", "exchange"),
    _Shape(rf"Solve{_OBJECT} for (?P<x>\$.+\$), (?:without|eliminating) (?P<w>\$.+\$)", "solve"),
    _Shape(rf"Solve{_OBJECT} for (?P<x>\$.+\$)", "solve"),
    _Shape(rf"Eliminate {_X}{_of('from')}", "eliminate"),
    *(
        _Shape(rf"(?:Take|Determine) the {said}{_of('of')}", verb)
        for said, verb in (("(?:square )?root", "root"), *((each, each) for each in _FUNCTIONS))
    ),
    _Shape(rf"Ask whether {_A} vanishes", "sign"),
    _Shape(rf"{_A} does not vanish", "sign"),
    _Shape(rf"Square{_OBJECT}", "square"),
    _Shape(rf"(?:Neglect|Drop) {_X}{_of('in')}, for {_SIZE}", "neglect"),
    _Shape(rf"(?:Neglect|Drop) {_X}{_of('in')}", "neglect"),
    _Shape(rf"(?:Set|Let) (?P<s>.+?) at all times{_of('in')}", "set", 1),
    _Shape(rf"(?:Set|Let) (?P<s>.+?) at the start{_of('in')}", "set", 2),
    _Shape(rf"(?:Set|Let) (?P<s>.+?){_of('in')}", "set"),
)
_PATTERNS = tuple((re.compile(shape.pattern), shape) for shape in _SHAPES)
_DEFINES = re.compile(r"(?:Define|Call) (?P<name>.+)")


def _verbs(pattern: str) -> frozenset[str]:
    """The words that a sentence of a pattern may begin with, but for names."""
    first = re.match(r"(?:\(\?:)?([A-Z][a-z|A-Z]+)", pattern)
    return frozenset(first[1].split("|")) - {"By"} if first else frozenset()


_FIRST = frozenset().union(*(_verbs(p.pattern) for p in (_DEFINES, *(p for p, _ in _PATTERNS))))
_OPENING = re.compile(
    rf"(Using|With|For) (.+?), ((?:using|{'|'.join(map(str.lower, _FIRST))})\b.*)"
)


def definition(words: str, context: Antecedents) -> tuple[str, tuple[Known, ...]] | None:
    """The name that a definition gives, and what it cites; None for another sentence."""
    plain = _plain(words)
    opening = _OPENING.fullmatch(plain)
    if not _DEFINES.match(_capital(opening[3]) if opening else plain):
        return None
    body, using, where = _circumstances(plain, context)
    if where:
        raise SentenceError("a definition has no condition")
    return _DEFINES.sub(r"\g<name>", body), using


def _hint(first: str) -> str:
    moves = {shape.verb for shape in _SHAPES if first in _verbs(shape.pattern)}
    verbs = {verb for shape in _SHAPES if shape.verb in moves for verb in _verbs(shape.pattern)}
    examples = [e for e in _EXAMPLES if e.startswith(first)] or [
        e for e in _EXAMPLES if e.split()[0] in verbs
    ]
    return f"written so: {', or '.join(f'“{e}:”' for e in examples)}"


_TABLE = "".join((__doc__ or "").split("\n\n")[2:3])  # none under python -OO
_EXAMPLES = tuple(
    " ".join(each.split()) for each in re.findall(r"[A-Z][a-z]+ [^.:\n]+(?=[.:])", _TABLE)
)
"""The sentences of the table at the top."""


__all__ = ["BODY", "SPACE", "Antecedents", "SentenceError", "Symbol", "definition", "move"]
