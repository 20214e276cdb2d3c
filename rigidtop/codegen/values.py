"""What a claim has to evaluate: its right-hand sides, as expressions in symbols for numbers.

A claim says that two sides are equal.  The side that a program wants is the one that names
something, solved for: (3.54), printed as λ₁θ̈ = …, gives θ̈, and since θ̈ alone can't be
integrated, φ̈ and ψ̈ with it.  Vectors become components in the axes that the page resolves them
along.  What was refuted is left out; its corrected form is there instead.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import sympy
from sympy import Eq, Expr, Mul, Symbol
from sympy.logic.boolalg import Boolean

from rigidtop.notation import MATRICES
from rigidtop.proof.equation import Dot, Equation, Meaning, NoMeaningError, value
from rigidtop.proof.page import Assumption, Correction, Step
from rigidtop.proof.verdict import Finding, Judgement, Led, Verdict
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.lettered import stands_for


class NothingToEvaluateError(ValueError):
    """A claim of which nothing is left that numbers could be put into."""


@dataclass(frozen=True)
class Output:
    """A number that a claim gives: its name, its expression, and the equation that says so.

    `symbol` is what the name stands for, None where that is no symbol; `index` are the places of a
    component, from 1.
    """

    name: str
    expression: Expr
    equation: Equation
    symbol: Symbol | None = None
    index: tuple[int, ...] = ()


@dataclass(frozen=True)
class ClaimLine:
    """An equation of a claim with what it assumes, and a sentence about it, such as a step's."""

    equation: Equation
    assuming: tuple[Assumption, ...] = ()
    reason: str = ""


@dataclass(frozen=True)
class ClaimOutputs:
    """All that a claim gives, with what it takes."""

    claim: str
    says: str
    outputs: tuple[Output, ...]
    arguments: tuple[Symbol, ...]
    lines: tuple[ClaimLine, ...]
    vectors: tuple[tuple[Symbol, Expr], ...] = ()
    """The axes and vectors of the equations with their components, where these are short."""

    note: str = ""

    shared: tuple[tuple[Symbol, Expr], ...] = ()
    """What the outputs share, each in terms of those before it, where it is known already."""


@dataclass(frozen=True)
class _Source:
    """A line with what its symbols mean."""

    line: ClaimLine
    meaning: Meaning

    @property
    def equation(self) -> Equation:
        return self.line.equation

    @property
    def is_limit(self) -> bool:
        return any(a.otherwise is not None for a in self.line.assuming)


def values(judgement: Judgement) -> ClaimOutputs:
    """The right-hand sides of a claim; NothingToEvaluateError, in one line, if there are none.

    >>> from rigidtop.derivations.lagrange_formalism import momentum_psi
    >>> from rigidtop.proof.verdict import judge
    >>> made = values(judge(momentum_psi))
    >>> made.arguments
    (theta, phidot, psidot, lambda3)
    >>> [(output.name, output.expression) for output in made.outputs]
    [('p_psi', lambda3*(phidot*cos(theta) + psidot))]
    """
    printed, others = _sources(judgement)
    for group in (printed, others, [] if printed or others else _led(judgement)):
        sources = _found(group)
        if sources:
            return _values(judgement, sources)
    raise NothingToEvaluateError(
        f"{judgement.claim.name} has no expression to evaluate; it holds between vectors, "
        "or says only that something vanishes, differs or stays constant"
    )


_HOLDS = (Verdict.PROVED, Verdict.SAMPLED, Verdict.ASSUMING)


def _sources(judgement: Judgement) -> tuple[list[_Source], list[_Source]]:
    """What the notes print, or the corrected form of it; and what the engine says besides."""
    holding = [f for f in judgement.findings() if f.verdict in _HOLDS]
    steps = [item for item in judgement.items if isinstance(item, Step)]
    corrected = [f for f in judgement.corrections() if f.verdict in _HOLDS]
    printed = [_source(f) for f in (*holding, *corrected) if f.check.printed]
    exact = {step.equation.sides[0]: _source(step) for step in reversed(steps)}
    # An approximation gives way to a step that has the same left side exactly.
    printed = [exact.get(p.equation.sides[0], p) if p.is_limit else p for p in printed]
    unprinted = [f for f in holding if not f.check.printed]
    others = [
        _source(item)
        for item in judgement.items
        if isinstance(item, Step) or (isinstance(item, Finding) and item in unprinted)
    ]
    return printed, others


def _led(judgement: Judgement) -> list[_Source]:
    """The lines of the text that alone show a claim."""
    return [
        _Source(ClaimLine(equation), {})
        for item in judgement.items
        if isinstance(item, Led)
        for id in item.lecture.names[item.name]
        for equation in item.lecture.lines[id].equations
    ]


def _source(item: Finding | Step) -> _Source:
    if isinstance(item, Step):
        return _Source(ClaimLine(item.equation, reason=item.reason), {})
    check = item.check
    remark = "Corrected: the notes have it otherwise." if isinstance(check, Correction) else ""
    return _Source(ClaimLine(check.claimed, check.assuming, remark), check.meaning)


# --- From equations to expressions ---------------------------------------------------------------


def _found(group: Sequence[_Source]) -> list[tuple[_Source, list[Output]]]:
    """The values of a group of equations, each name once.

    What is an argument already is no value besides: a function that gives back what it is given
    says nothing.
    """
    sources: list[tuple[_Source, list[Output]]] = []
    tagged = any(source.equation.tag for source in group)
    for again in (False, True):  # r′ = Oᵀr where r was made from r′: only if there is nothing else
        meanings: dict[Symbol, Expr] = {}
        names: set[str] = set()
        taken: set[str] = set()
        for source in group:
            if source.equation.relation not in ("=", "≡"):
                continue
            if source.equation.sides[0] == 0 and tagged and not source.equation.tag:
                continue  # a line on the way to the numbered one
            outputs = [
                replace(v, expression=v.expression.xreplace(meanings))  # τ_b = 2π/Ω_b after Ω_b = …
                for v in _of_equation(source, again)
            ]
            new = {v.name for v in outputs}
            used = {x.name for v in outputs for x in v.expression.free_symbols}
            if outputs and not new & (names | taken | used):
                sources.append((source, outputs))
                names |= new
                taken |= used
                meanings |= {v.symbol: v.expression for v in outputs if v.symbol and not v.index}
        if sources:
            break
    return sources


def _of_equation(source: _Source, again: bool) -> Iterator[Output]:
    equation, meaning = source.equation, source.meaning
    left = equation.sides[0]
    target = _target(left)
    if target is None and left != 0 and not _is_dot(left):
        return
    own = _atoms(meaning, left)
    circular = [
        key
        for key, m in meaning.items()
        if isinstance(m, (Expr, sympy.MatrixBase)) and key != left and m.free_symbols & own
    ]
    vectors = [key for key in circular if isinstance(meaning[key], sympy.MatrixBase)]
    if bool(vectors) != again:
        return
    # M, g and the like are what a program knows, also where the page gets them from the rest.
    fixed = [key for key in meaning if getattr(key, "is_positive", False)]
    inside = {key: m for key, m in meaning.items() if key not in (*circular, *fixed)}
    inside |= {key: _components(key, meaning[key]) for key in vectors}
    sides = [side for side in equation.sides[1:] if side not in (0, s.const)]
    sized = [side for side in (_evaluated(side, inside, source) for side in sides) if side]
    right = min(sized, key=lambda side: sum(map(sympy.count_ops, side[0])), default=None)
    if right is None or _is_constant(right[0]):
        return
    entries, shape = right
    if target is None:
        name = "residual" if left == 0 else "_dot_".join(x.name for x in left.args)
        yield from _entries(name, None, entries, shape, equation)
        return
    factor, wanted = target
    if isinstance(wanted, list):
        if len(wanted) == len(entries):
            for symbol, entry in zip(wanted, entries, strict=True):
                yield Output(symbol.name, entry, equation, symbol)
        return
    factor = value(factor, meaning)
    yield from _entries(wanted.name, wanted, [e / factor for e in entries], shape, equation)


def _target(left: Expr) -> tuple[Expr, Symbol | list[Symbol]] | None:
    """What a left side names: x, or c·x as it is printed, or a column of symbols."""
    if isinstance(left, Symbol):
        return sympy.S.One, left
    if isinstance(left, sympy.MatrixBase):
        symbols = [x for x in left if isinstance(x, Symbol)]
        return (sympy.S.One, symbols) if len(symbols) == len(left) else None
    if isinstance(left, Mul) and isinstance(left.args[-1], Symbol):
        *factors, wanted = left.args
        factor = sympy.prod(factors)
        if all(x.is_positive or x in top.ANGLES for x in factor.free_symbols):
            return factor, wanted
    return None


def _is_dot(left: Expr) -> bool:
    return isinstance(left, Dot) and all(isinstance(x, Symbol) for x in left.args)


def _atoms(meaning: Meaning, left: Expr) -> set[Symbol]:
    """The symbols that a left side consists of, if it consists of nothing else."""
    target = _target(left)
    if target is None:
        return set()
    wanted = target[1] if isinstance(target[1], list) else [target[1]]
    meant = [value(x, meaning) for x in wanted]
    flat = [e for m in meant for e in (m if isinstance(m, sympy.MatrixBase) else [m])]
    return set(flat) if all(isinstance(e, Symbol) for e in flat) else set()


def _components(vector: Expr, like: sympy.MatrixBase) -> sympy.MatrixBase:
    names = [f"{vector.name}{''.join(map(str, place))}" for place in _places(like.shape)]
    return sympy.Matrix(*like.shape, [Symbol(name, real=True) for name in names])


def _evaluated(
    side: Expr, meaning: Meaning, source: _Source
) -> tuple[list[Expr], tuple[int, int]] | None:
    """A side as numbers would go into it; None if it stays one of vectors."""
    try:
        number = value(side, meaning)
        for assumption in source.line.assuming:
            if isinstance(assumption.condition, Eq):
                number = number.subs(assumption.condition.lhs, _imposed(assumption))
    except (NoMeaningError, AttributeError, TypeError, KeyError, sympy.ShapeError):
        return None  # a product of vectors that the page leaves without components
    matrix = isinstance(number, sympy.MatrixBase)
    entries = [sympy.sympify(e) for e in number] if matrix else [number]
    symbols = set().union(*(e.free_symbols for e in entries))
    if any(not isinstance(e, Expr) for e in entries) or any(map(_is_vector, symbols)):
        return None
    return entries, number.shape if matrix else (1, 1)


def _imposed(assumption: Assumption) -> Boolean:
    """What stands for a symbol that is fixed; in a limit the symbol's own value."""
    return assumption.condition.rhs if assumption.otherwise is None else assumption.otherwise


def _is_vector(symbol: Expr) -> bool:
    quantity = s.VOCABULARY.get(symbol)
    return symbol in MATRICES or (quantity is not None and quantity.glyph.bold)


def _is_constant(entries: Sequence[Expr]) -> bool:
    """Whether the entries are the same at two points: a number in disguise, such as sin² + cos²."""
    symbols = sorted(set().union(*(e.free_symbols for e in entries)), key=str)
    points = [
        {x: sympy.Rational(k * n + k, 3 * n + 11) for n, x in enumerate(symbols)} for k in (5, 7)
    ]
    first, second = ([e.xreplace(point).evalf(20) for e in entries] for point in points)
    return all(abs(a - b) < 1e-12 for a, b in zip(first, second, strict=True))


def _entries(
    name: str,
    symbol: Symbol | None,
    entries: Sequence[Expr],
    shape: tuple[int, int],
    equation: Equation,
) -> Iterator[Output]:
    if shape == (1, 1):
        [entry] = entries
        if name == "residual":
            yield next(_solved(entry, equation), Output(name, entry, equation))
        else:
            yield Output(name, entry, equation, symbol)
        return
    for place, entry in zip(_places(shape), entries, strict=True):
        yield Output(f"{name}{''.join(map(str, place))}", entry, equation, symbol, place)


def _places(shape: tuple[int, int]) -> list[tuple[int, ...]]:
    rows, columns = shape
    if columns == 1:
        return [(row + 1,) for row in range(rows)]
    return [(row + 1, column + 1) for row in range(rows) for column in range(columns)]


def _solved(residual: Expr, equation: Equation) -> Iterator[Output]:
    """A second derivative that an equation 0 = … is linear in."""
    for symbol in top.ACCELERATIONS:
        coefficient = residual.expand().coeff(symbol)
        if coefficient != 0 and not coefficient.has(*top.ACCELERATIONS):
            rest = residual.subs(symbol, 0)
            yield Output(symbol.name, -rest / coefficient, equation, symbol)


# --- A function of numbers -----------------------------------------------------------------------


def _values(judgement: Judgement, sources: Sequence[tuple[_Source, list[Output]]]) -> ClaimOutputs:
    outputs, note = _complete([v for _, group in sources for v in group], sources)
    takes = arguments(v.expression for v in outputs)
    return ClaimOutputs(
        judgement.claim.name,
        judgement.claim.says,
        tuple(outputs),
        takes,
        tuple(source.line for source, _ in sources),
        tuple(_vectors((source for source, _ in sources), {x.name for x in takes})),
        note,
    )


def _complete(
    outputs: list[Output], sources: Sequence[tuple[_Source, list[Output]]]
) -> tuple[list[Output], str]:
    """θ̈ of the heavy top with φ̈ and ψ̈, which an integrator needs besides."""
    system = dict(zip(top.ACCELERATIONS, top.symmetric_top_accelerations(), strict=True))
    (source, _), *_ = sources
    output, *others = outputs
    if others or output.symbol not in system:
        return outputs, ""
    if source.meaning.get(output.symbol) != system[output.symbol]:
        return outputs, ""
    complete = [Output(x.name, e, output.equation, x) for x, e in system.items()]
    return complete, "Solved together with (3.55) and (3.56); singular where sin θ = 0."


def _vectors(sources: Iterable[_Source], takes: set[str]) -> Iterator[tuple[Symbol, Expr]]:
    """Axes of what is resolved along them, and vectors whose components are arguments."""
    letters: set[Symbol] = set()
    for source in sources:
        left = source.equation.sides[0]
        own = _atoms(source.meaning, left)
        named = set().union(*(side.free_symbols for side in source.equation.sides)) - {left}
        axes = _AXES - {left} if any(map(_is_vector, named)) else set()
        for symbol in s.VOCABULARY:
            components = source.meaning.get(symbol)
            if symbol in letters or not isinstance(components, sympy.MatrixBase):
                continue
            if components.shape != (3, 1) or sum(map(sympy.count_ops, components)) > 6:
                continue
            free = {x.name for x in components.free_symbols}
            if components.free_symbols & own:
                continue
            if (symbol in axes and free <= takes) or (symbol in named and free & takes):
                letters.add(symbol)
                yield symbol, components


_AXES = {s.xhat, s.yhat, s.zhat, s.e1, s.e2, s.e1p, s.e2p, s.e3}

STATE = (
    *(s.t, *top.ANGLES, *top.RATES, *top.QUATERNION),
    *(s.omega1, s.omega2, s.omega3, s.Omega),
)
"""What comes first among arguments, as a solver has it."""


def arguments(expressions: Iterable[Expr]) -> tuple[Symbol, ...]:
    """The symbols of expressions: the state, what else varies, then parameters.

    >>> from rigidtop.theory.symbols import M, g, lambda3, p_psi, theta
    >>> arguments([M * g / lambda3, p_psi * theta])
    (theta, p_psi, lambda3, M, g)
    """
    state = {x.name: i for i, x in enumerate(STATE)}
    order = {x.name: i for i, x in enumerate(s.VOCABULARY)}
    parameters = {x.name for x in s.VOCABULARY if x.is_positive} | {"R1", "R2", "R3"}
    free = {x.name: x for e in expressions for x in e.free_symbols}
    # A symbol of another notation comes where that of the notes does.
    notes = {name: stands_for(x).name for name, x in free.items()}

    def key(own: str) -> tuple[int | str, ...]:
        name = notes[own]
        digits = [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]
        place = 0 if name in state else 2 if name in parameters else 1
        return place, state.get(name, 0), order.get(name, len(order)), *map(str, digits)

    return tuple(free[name] for name in sorted(free, key=key))


# --- In the symbols of another notation ----------------------------------------------------------


def rewritten(claim: ClaimOutputs, written: Callable[[Expr], Expr]) -> ClaimOutputs:
    """The same values with other symbols: `written` takes expressions and equations into them.

    What is −x of the other notation gives x, with its sign turned.
    """
    outputs = tuple(_rewritten(output, written) for output in claim.outputs)
    lines = tuple(
        replace(
            line,
            equation=written(line.equation),
            assuming=tuple(
                replace(a, condition=written(a.condition), otherwise=written(a.otherwise))
                for a in line.assuming
            ),
        )
        for line in claim.lines
    )
    vectors = []
    for vector, components in claim.vectors:
        sign, own = _own(written(vector))[:2]
        vectors.append((own, sign * written(components)))
    outputs, vectors = _along_axes(outputs, vectors)
    takes = arguments(v.expression for v in outputs)
    return replace(claim, outputs=outputs, arguments=takes, lines=lines, vectors=tuple(vectors))


def _along_axes(
    outputs: tuple[Output, ...], vectors: list[tuple[Symbol, Expr]]
) -> tuple[tuple[Output, ...], list[tuple[Symbol, Expr]]]:
    """Components along e₁′, e₂′, e₃ as they are in the other notation: (1, 0, 0), and so on."""
    axes = {stands_for(vector): part for vector, part in vectors}
    if {s.e1p, s.e2p} - set(axes) or any(axes[axis].free_symbols for axis in (s.e1p, s.e2p)):
        return outputs, vectors
    turn = sympy.Matrix.hstack(axes[s.e1p], axes[s.e2p], sympy.Matrix([0, 0, 1])).T
    groups: dict[Expr, list[Output]] = {}
    for output in outputs:
        groups.setdefault(output.symbol, []).append(output)
    turned: list[Output] = []
    for group in groups.values():
        if [output.index for output in group] == [(1,), (2,), (3,)]:
            parts = turn * sympy.Matrix([output.expression for output in group])
            group = [replace(o, expression=e) for o, e in zip(group, parts, strict=True)]
        turned += group
    return tuple(turned), [(vector, turn * part) for vector, part in vectors]


def _rewritten(output: Output, written: Callable[[Expr], Expr]) -> Output:
    expression, equation = written(output.expression), written(output.equation)
    if output.symbol is None:
        names = [x.name for x in getattr(equation.sides[0], "args", ()) if isinstance(x, Symbol)]
        name = "_dot_".join(names) if "_dot_" in output.name else output.name
        return replace(output, name=name, expression=expression, equation=equation)
    sign, own, offset = _own(written(output.symbol))
    name = own.name + output.name.removeprefix(output.symbol.name)
    return Output(name, sign * (expression - offset), equation, own, output.index)


def _own(image: Expr) -> tuple[Expr, Symbol, Expr]:
    """The sign, the symbol and the offset of ±x + c."""
    [own] = image.free_symbols
    sign = image.coeff(own)
    return sign, own, image - sign * own
