"""What the models of a lecture say, as contexts in which an answer is judged."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import sympy
from sympy import Expr, ImmutableMatrix, MatrixBase, Symbol, eye

from rigidtop.judge.context import LAW, SETTING, Constraint, Context, Habits, LetterDefinition
from rigidtop.judge.jets import TIME, Jet, jets, rate, symbol
from rigidtop.judge.vocabulary import Meant
from rigidtop.proof.model import Model
from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import Symbol as Lettered
from rigidtop.theory.rotation import euler_matrix, euler_omega, primed_matrix
from rigidtop.theory.symbols import Glyph
from rigidtop.tree.nodes import Letter, Node

GIVEN = -1
"""The number of a statement that is given."""

TENSOR = Letter("I", bold=True)
"""The tensor of inertia."""

_ORDERS = {"dot": 1, "ddot": 2}
_ANGLES = (s.phi, s.theta, s.psi)
_RATES = (s.phidot, s.thetadot, s.psidot)


def letter(glyph: Glyph) -> Letter:
    """The letter that a glyph is, without its dots."""
    mark = "hat" if glyph.accent == "hat" else "′" if glyph.prime else ""
    return Letter(glyph.base, glyph.sub.replace("−", "-"), mark, glyph.bold)


def number(x: Symbol) -> Symbol:
    """The number of a world that a symbol of the theory is."""
    if x == s.t:
        return TIME
    if isinstance(x, Lettered):
        glyph = x.quantity.glyph
    elif x in s.VOCABULARY:
        glyph = s.VOCABULARY[x].glyph
    else:
        return symbol(Jet(Letter(x.name)))
    return symbol(Jet(letter(glyph), _ORDERS.get(glyph.accent, 0)))


def context(model: Model, declared: frozenset[Letter] = frozenset()) -> Context:
    """What a model says: what its letters stand for, how they move, what is special about it.

    `declared` are the letters that mean something besides.
    """
    given = _Given(model)
    moving = given.moving()
    return Context(
        Habits(moving=moving, lengths=given.lengths()),
        definitions={**given.definitions, **given.tensor()},
        constraints=tuple(given.constraints),
        letters=given.letters,
        given=given.letters,
        declared=declared,
        lawless=not model.along,
        timeless=model.timeless,
        bases=given.bases(),
    )


def with_angles(known: Context) -> Context:
    """What is said of a free body, its attitude by Euler's angles, as an answer may write it."""
    shown = {hidden: angle for angle, hidden in _HIDDEN.items()}

    def visible(node: Node) -> Node:
        return Meant(_put(node.value, shown)) if isinstance(node, Meant) else node

    definitions = {x: replace(d, node=visible(d.node)) for x, d in known.definitions.items()}
    angles = frozenset(letter(s.VOCABULARY[x].glyph) for x in _ANGLES)
    axes = _mapped(primed_matrix())
    for k in (0, 1):
        axis = Letter("e", str(k + 1), "′", bold=True)
        definitions[axis] = LetterDefinition(Meant(ImmutableMatrix(axes[:, k])), GIVEN)
    for k, name in enumerate("xyz"):
        fixed = Letter(name, mark="hat", bold=True)
        definitions[fixed] = LetterDefinition(Meant(ImmutableMatrix(eye(3)[:, k])), GIVEN)
    momentum = definitions[Letter("L", bold=True)].node
    definitions[Letter("L", "z")] = LetterDefinition(Meant(momentum.value[2]), GIVEN)  # type: ignore[attr-defined]
    letters = known.letters | angles | definitions.keys()
    return replace(
        known,
        habits=replace(known.habits, moving=known.habits.moving | angles),
        definitions=definitions,
        constraints=tuple(
            replace(c, left=visible(c.left), right=visible(c.right)) for c in known.constraints
        ),
        letters=letters,
        given=letters,
        bases=(*(ImmutableMatrix(_put(x, shown)) for x in known.bases), ImmutableMatrix(axes)),
    )


def _put(value: Any, numbers: Mapping[Expr, Expr]) -> Any:
    if isinstance(value, MatrixBase):
        return ImmutableMatrix(value.applyfunc(lambda x: x.xreplace(numbers)))
    return sympy.sympify(value).xreplace(numbers)


def is_turned(known: Context) -> bool:
    """Whether it is about a body whose attitude has no name."""
    return not _numbers(known).isdisjoint(_HIDDEN.values())


def _numbers(known: Context) -> frozenset[Symbol]:
    values = (x for c in known.constraints for x in (c.left, c.right) if isinstance(x, Meant))
    return frozenset().union(*(sympy.sympify(x.value).free_symbols for x in values))


def special(model: Model) -> tuple[Mapping[Expr, Expr], ...]:
    """What is special about the motions of a model, to be put in one after the other."""
    given = _Given(model)
    moving = given.moving()
    found: list[Mapping[Expr, Expr]] = []
    for limit in model.limits:
        put: dict[Expr, Expr] = {}
        for x, value in limit.items():
            [jet], meant = jets(number(x)).values(), sympy.sympify(given.value(value))
            for order in range(jet.order, 3):
                put[symbol(replace(jet, order=order))] = meant
                meant = rate(meant, moving)
        found.append(put)
    return tuple(found)


class _Given:
    """A model taken apart."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.axes, self.in_space = _axes(model.meaning)
        self.definitions: dict[Letter, LetterDefinition] = {}
        self.constraints: list[Constraint] = []
        for x, value in model.meaning.items():
            if isinstance(x, Symbol) and value != x:
                self._define(x, value)
        for x, slope in model.rates.items():
            self._move(x, slope)
        for limit in model.limits:
            self._limit(limit)
        if self.axes == "body":
            for x, value in zip((s.omega1, s.omega2, s.omega3), _turning(), strict=True):
                self._hold(number(x), value, LAW)
        values = [d.node.value for d in self.definitions.values() if isinstance(d.node, Meant)]
        spoken = {jet.letter for x in values for jet in jets(x).values()}
        spoken |= {jet.letter for c in self.constraints for jet in _jets_of(c)}
        self.letters = frozenset(spoken | {*self.definitions} | self.moving() | self.lengths())

    def value(self, found: Any) -> Any:
        """A value of the model in the numbers of a world, vectors in space."""
        if isinstance(found, MatrixBase):
            mapped = found.applyfunc(self.value)
            turned = found.shape == (3, 1) and self.in_space is not None
            return ImmutableMatrix(self.in_space * mapped) if turned else ImmutableMatrix(mapped)
        expression = sympy.sympify(found)
        return expression.xreplace({x: number(x) for x in expression.free_symbols})

    def _define(self, x: Symbol, value: Any) -> None:
        made = number(x)
        [jet] = jets(made).values() if made != TIME else [None]
        if jet is None or jet.order or callable(value):
            return
        self.definitions[jet.letter] = LetterDefinition(Meant(self.value(value)), GIVEN)

    def _move(self, x: Symbol, slope: Expr) -> None:
        if x == s.t:
            return
        [jet] = jets(number(x)).values()
        if jet.letter not in self.definitions:
            self._hold(symbol(replace(jet, order=jet.order + 1)), self.value(slope), LAW)

    def _limit(self, limit: Mapping[Symbol, Expr]) -> None:
        when = limit.get(s.t)
        put: dict[Expr, Expr] = {}
        if when is not None:  # a phase is given in place of the time
            [phase] = when.free_symbols - {*self.model.meaning} - {s.omega3, s.lambda1, s.lambda3}
            put = {phase: sympy.solve(when - s.t, phase)[0]}
        for x, value in limit.items():
            if x != s.t and value != x:
                value = sympy.sympify(value).xreplace(put)
                self._hold(number(x), self.value(value), SETTING)

    def _hold(self, left: Expr, right: Expr, kind: str) -> None:
        if left != right:
            self.constraints.append(Constraint(Meant(left), Meant(right), GIVEN, kind))

    def moving(self) -> frozenset[Letter]:
        values = [d.node.value for d in self.definitions.values() if isinstance(d.node, Meant)]
        entries = [x for v in values for x in (v if isinstance(v, MatrixBase) else [v])]
        entries += [x.value for c in self.constraints for x in (c.left, c.right)]  # type: ignore[attr-defined]
        found = {
            jet.letter for x in entries for jet in jets(sympy.sympify(x)).values() if jet.order
        }
        return frozenset(found)

    def lengths(self) -> frozenset[Letter]:
        """Letters that stand for the length of a vector."""
        vectors = [x for x in self.definitions if x.bold and not x.sub and not x.mark]
        return frozenset(replace(x, bold=False) for x in vectors) - {*self.definitions}

    def tensor(self) -> dict[Letter, LetterDefinition]:
        """The tensor of inertia, where axes are known in which it is diagonal."""
        if self.in_space is None:
            return {}
        second = s.lambda1 if self.axes == "primed" else s.lambda2
        moments = sympy.diag(*(number(x) for x in (s.lambda1, second, s.lambda3)))
        turned = ImmutableMatrix(self.in_space * moments * self.in_space.T)
        return {TENSOR: LetterDefinition(Meant(turned), GIVEN)}

    def bases(self) -> tuple[MatrixBase, ...]:
        """The axes along which components may be meant: those of the model first."""
        own = [] if self.in_space is None else [self.in_space]
        others = (
            [self.value(sympy.Matrix(primed_matrix())), eye(3)] if self.axes != "body" else [eye(3)]
        )
        return tuple(ImmutableMatrix(x) for x in [*own, *others])


def _axes(meaning: Mapping[Any, Any]) -> tuple[str, MatrixBase | None]:
    """In which axes a model gives vectors, and these as a matrix of unit vectors in space."""
    first = sympy.Matrix([1, 0, 0])
    if meaning.get(s.e1p) == first:
        return "primed", _mapped(primed_matrix())
    if meaning.get(s.e1) == first:
        return "body", _mapped(euler_matrix()).xreplace(_HIDDEN)
    return "space", None


def _mapped(matrix: MatrixBase) -> MatrixBase:
    return ImmutableMatrix(
        sympy.Matrix(matrix).applyfunc(
            lambda e: sympy.sympify(e).xreplace({x: number(x) for x in e.free_symbols})
        )
    )


_HIDDEN: dict[Expr, Expr] = {
    number(x): symbol(Jet(Letter("attitude", str(k)), order))
    for order, row in enumerate((_ANGLES, _RATES))
    for k, x in enumerate(row)
}
"""The attitude of a free body, of which no angle has a name."""


def _turning() -> list[Expr]:
    """The rotational velocity in the body by the attitude."""
    return [x.xreplace(_HIDDEN) for x in _mapped(sympy.Matrix(euler_omega("body")))]


def _jets_of(constraint: Constraint) -> list[Jet]:
    sides = (constraint.left, constraint.right)
    return [j for x in sides if isinstance(x, Meant) for j in jets(sympy.sympify(x.value)).values()]
