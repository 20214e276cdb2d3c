"""Formulas of one motion, written out once as a function of floats.

A formula that is run with the kit `Trace` computes nothing: it leaves the operations that it made,
and they are written out in a row, as Python.  What is needed in one branch only is computed there,
and what is used once has no name.  That runs in a third of the time of the formula itself, and
Numba compiles the same lines.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, is_dataclass
from functools import cached_property
from typing import Any

Block = tuple[tuple[int, bool], ...]
"""The arms of branches, by their numbers, in which something is computed, the outermost first."""

Number = Any
"""A float, a bool, or a `Value` that stands for one: one formula takes all."""

LONGEST = 400
"""An expression with more characters gets a name, for it would be nested too deeply."""


def over(a: float, b: float) -> float:
    """a/0."""
    return math.copysign(math.inf, a) * math.copysign(1.0, b) if a else math.nan


NAMES: dict[str, Any] = {
    **{name: value for name, value in vars(math).items() if not name.startswith("_")},
    "over": over,
    "rint": round,
}
"""What the lines call."""


def _infix(
    sign: str, truth: bool = False, turned: bool = False
) -> Callable[[Number, Number], Value]:
    template = "({1} %s {0})" if turned else "({0} %s {1})"
    return lambda one, other: one.trace.value(template % sign, one, other, truth=truth)


def _call(name: str, truth: bool = False) -> Any:
    def call(self: Trace, *arguments: Number) -> Value:
        places = ", ".join(f"{{{k}}}" for k in range(len(arguments)))
        return self.value(f"{name}({places})", *arguments, truth=truth)

    return call


@dataclass(frozen=True, eq=False, repr=False)
class Value:
    """A number that is not known yet."""

    trace: Trace
    template: str
    """Its expression, of those of the arguments; none of a branch, and of what comes of one."""
    arguments: tuple[Number, ...]
    truth: bool = False
    arms: tuple[tuple[Number, ...], tuple[Number, ...]] | None = None
    """Of a branch, whose argument is the condition: what comes of either."""

    __add__, __radd__ = _infix("+"), _infix("+", turned=True)
    __sub__, __rsub__ = _infix("-"), _infix("-", turned=True)
    __mul__, __rmul__ = _infix("*"), _infix("*", turned=True)
    __truediv__, __rtruediv__ = _infix("/"), _infix("/", turned=True)
    __mod__ = _infix("%")
    __lt__, __le__ = _infix("<", True), _infix("<=", True)
    __gt__, __ge__ = _infix(">", True), _infix(">=", True)
    __eq__, __ne__ = _infix("==", True), _infix("!=", True)  # type: ignore[assignment]
    __hash__ = object.__hash__

    def __neg__(self) -> Value:
        return self.trace.value("(-{0})", self)

    def __abs__(self) -> Value:
        return self.trace.value("abs({0})", self)

    def __pow__(self, power: int) -> Value:
        assert power == 2
        return self * self

    def __bool__(self) -> bool:
        raise TypeError("a formula of a kit branches by `where` and `pick`")


class Trace:
    """A kit of formulas, and what they did."""

    sqrt, exp = _call("sqrt"), _call("exp")
    sin, cos, tan = _call("sin"), _call("cos"), _call("tan")
    acos, atan, atan2 = _call("acos"), _call("atan"), _call("atan2")
    sinh, cosh, tanh = _call("sinh"), _call("cosh"), _call("tanh")
    asinh, atanh = _call("asinh"), _call("atanh")
    hypot, copysign, rint = _call("hypot"), _call("copysign"), _call("rint")
    finite = _call("isfinite", truth=True)
    _over = _call("over")

    def __init__(self) -> None:
        self.values: list[Value] = []
        self._known: list[dict[tuple[object, ...], Value]] = [{}]  # of the arms that are open

    def value(self, template: str, *arguments: Number, truth: bool = False) -> Value:
        key = (template, *(x if isinstance(x, Value) else repr(x) for x in arguments))
        for known in self._known:
            if key in known:
                return known[key]
        made = self._known[-1][key] = Value(self, template, arguments, truth)
        self.values.append(made)
        return made

    def both(self, a: Number, b: Number) -> Number:
        return self.value("({0} and {1})", a, b, truth=True)

    def either(self, a: Number, b: Number) -> Number:
        return self.value("({0} or {1})", a, b, truth=True)

    def larger(self, a: Number, b: Number) -> Number:
        return self.where(self.value("({0} > {1})", b, a, truth=True), b, a)

    def smaller(self, a: Number, b: Number) -> Number:
        return self.where(self.value("({0} < {1})", b, a, truth=True), b, a)

    def over(self, a: Number, b: Number) -> Number:
        return self.pick(b != 0, lambda: (a / b,), lambda: (self._over(a, b),))[0]

    def circle(self, angle: Number) -> tuple[Number, Number]:
        """cos and sin."""
        return self.cos(angle), self.sin(angle)

    @staticmethod
    def cubics(coefficients: Sequence[Sequence[Number]], x: Number) -> Sequence[Number]:
        return [((c[3] * x + c[2]) * x + c[1]) * x + c[0] for c in coefficients]

    @staticmethod
    def any(condition: Number) -> bool:
        return condition if isinstance(condition, bool) else True

    def where(self, condition: Number, one: Number, other: Number) -> Number:
        return self.pick(condition, lambda: (one,), lambda: (other,))[0]

    def pick(
        self,
        condition: Number,
        one: Callable[[], Sequence[Number]],
        other: Callable[[], Sequence[Number]],
    ) -> Sequence[Number]:
        if isinstance(condition, bool):
            return one() if condition else other()
        arms = []
        for arm in (one, other):
            self._known.append({})
            arms.append(tuple(arm()))
            self._known.pop()
        branch = Value(self, "", (condition,), arms=(arms[0], arms[1]))
        self.values.append(branch)
        return tuple(
            pair[0] if pair[0] is pair[1] else self._part(branch, k, pair)
            for k, pair in enumerate(zip(*arms, strict=True))
        )

    def _part(self, branch: Value, index: int, pair: tuple[Number, Number]) -> Value:
        truth = all(x.truth if isinstance(x, Value) else isinstance(x, bool) for x in pair)
        made = Value(self, "", (branch, index), truth)
        self.values.append(made)
        return made

    def inputs(self, name: str, tree: Any) -> Any:
        """The tree with elements of a row of that name in the place of its values."""
        count = iter(range(len(leaves(tree))))

        def element(leaf: Value) -> Value:
            template = "({}[{}] != 0.0)" if leaf.truth else "{}[{}]"
            return self.value(template.format(name, next(count)), truth=leaf.truth)

        return _mapped(tree, element)

    def lines(self, results: Sequence[Value]) -> tuple[list[str], list[str]]:
        """The lines that compute the results, and what these then are, as floats."""
        lines = _Lines(self.values, results)
        return lines.body(), lines.shown()

    def function(self, head: str, results: Sequence[Value]) -> str:
        """Source of a function that returns the results."""
        body, shown = self.lines(results)
        return "\n    ".join([f"def {head}:", *body, f"return ({', '.join(shown)},)"])


class _Lines:
    """Where values are computed, and how they are written."""

    def __init__(self, values: Sequence[Value], results: Sequence[Value]) -> None:
        self.values, self.results = values, results
        self.blocks: dict[Value, Block] = {}
        self.uses: dict[Value, int] = defaultdict(int)
        self.parts: dict[Value, list[Value]] = defaultdict(list)
        for result in results:
            self._use(result, ())
        for value in reversed(values):
            if value in self.blocks:
                self._use_arguments(value, self.blocks[value])
        self.texts: dict[Value, str] = {}
        self.statements: dict[Block, list[str]] = defaultdict(list)

    def _use(self, value: Any, block: Block) -> None:
        if isinstance(value, Value):
            self.uses[value] += 1
            known = self.blocks.get(value, block)
            same = [a == b for a, b in zip(known, block, strict=False)]
            self.blocks[value] = block[: [*same, False].index(False)]

    def _use_arguments(self, value: Value, block: Block) -> None:
        for argument in value.arguments:
            self._use(argument, block)
        if not value.template and value.arms is None:
            self.parts[value.arguments[0]].append(value)
        if value.arms is not None:
            for arm, kept in zip(value.arms, (True, False), strict=True):
                for part in self.parts[value]:
                    self._use(arm[part.arguments[1]], (*block, (id(value), kept)))

    def body(self) -> list[str]:
        for number, value in enumerate(self.values):
            if value not in self.blocks:
                continue
            if value.arms is not None:
                self._branch(number, value, value.arms)
            elif value not in self.texts:
                known = value.template or self.texts[value.arguments[0]]
                text = known.format(*map(self._text, value.arguments)) if value.template else known
                if self.uses[value] > 1 or len(text) > LONGEST:
                    self.statements[self.blocks[value]].append(f"v{number} = {text}")
                    text = f"v{number}"
                self.texts[value] = text
        return self.statements[()]

    def shown(self) -> list[str]:
        return [
            f"1.0 if {self._text(each)} else 0.0" if each.truth else self._text(each)
            for each in self.results
        ]

    def _branch(self, number: int, branch: Value, arms: tuple[Number, Number]) -> None:
        block, condition = self.blocks[branch], self._text(branch.arguments[0])
        sides = [(*block, (id(branch), kept)) for kept in (True, False)]
        parts = {part.arguments[1]: part for part in self.parts[branch]}
        if len(parts) == 1 and not any(self.statements[side] for side in sides):
            one, other = (self._text(arm[index]) for arm in arms for index in parts)
            self.texts[branch] = f"({one} if {condition} else {other})"
            return
        found = self.statements[block]
        for side, arm, head in zip(sides, arms, (f"if {condition}:", "else:"), strict=True):
            found.append(head)
            found += [f"    {line}" for line in self.statements[side]]
            found += [f"    v{number}_{index} = {self._text(arm[index])}" for index in parts]
        self.texts |= {part: f"v{number}_{index}" for index, part in parts.items()}

    def _text(self, value: Any) -> str:
        return self.texts[value] if isinstance(value, Value) else repr(value)


def leaves(tree: Any) -> list[Value]:
    """The values in a dataclass or a tuple, and in those in it."""
    if is_dataclass(tree) and not isinstance(tree, Value):
        tree = tuple(getattr(tree, each.name) for each in fields(tree))
    if isinstance(tree, tuple):
        return [leaf for part in tree for leaf in leaves(part)]
    return [tree] if isinstance(tree, Value) else []


def _mapped(tree: Any, change: Callable[[Value], Any]) -> Any:
    if isinstance(tree, Value):
        return change(tree)
    if is_dataclass(tree):
        parts = (_mapped(getattr(tree, each.name), change) for each in fields(tree))
        return type(tree)(*parts)  # type: ignore[misc]
    return tuple(_mapped(part, change) for part in tree) if isinstance(tree, tuple) else tree


def _constructed(tree: Any, names: dict[str, Any]) -> str:
    """Source of a tree of inputs."""
    if isinstance(tree, Value):
        return tree.template
    if is_dataclass(tree):
        names[type(tree).__name__] = type(tree)
        parts = (_constructed(getattr(tree, each.name), names) for each in fields(tree))
        return f"{type(tree).__name__}({', '.join(parts)})"
    if isinstance(tree, tuple):
        return f"({''.join(_constructed(part, names) + ', ' for part in tree)})"
    return repr(tree)


@dataclass(frozen=True)
class Solved:
    """One motion: its closed form, and the numbers that this takes from its start."""

    written: Written
    numbers: tuple[float, ...]

    @cached_property
    def orbit(self) -> Any:
        """Of the room that wrote it, for arrays of times."""
        return self.written.build(self.numbers)

    def at(self, t: float) -> tuple[float, ...]:
        """The state at a time (s)."""
        return self.written.at(self.numbers, t)


@dataclass(frozen=True, eq=False)
class Written:
    """The closed form of one motion, for floats; its numbers are a row of floats."""

    source: str
    orbit: Any
    """As it was traced."""
    solve: Callable[[Sequence[float]], tuple[float, ...]]
    """What the motion starts from, to its numbers."""
    build: Callable[[Sequence[float]], Any]
    """The orbit of these numbers."""
    at: Callable[[Sequence[float], float], tuple[float, ...]]
    """The state at a time."""

    def solved(self, *start: float) -> Solved:
        return Solved(self, self.solve(start))


def written(
    count: int,
    solve: Callable[[Trace, Sequence[Value]], Any],
    at: Callable[[Trace, Any, Value], Any],
) -> Written:
    """From the formulas for an orbit, of `count` numbers, and for its state."""
    first, second = Trace(), Trace()
    orbit = solve(first, [first.value(f"s[{k}]") for k in range(count)])
    inputs = second.inputs("o", orbit)
    state = at(second, inputs, second.value("t"))
    names: dict[str, Any] = {}
    source = "\n\n\n".join(
        [
            first.function("solve(s)", leaves(orbit)),
            second.function("at(o, t)", leaves(state)),
            f"def build(o):\n    return {_constructed(inputs, names)}\n",
        ]
    )
    made = loaded(source, names)
    return Written(source, orbit, *(made[name] for name in ("solve", "build", "at")))


def loaded(source: str, names: dict[str, Any]) -> dict[str, Any]:
    """What source that was written here defines; `names` are those that it uses beside `NAMES`."""
    found = NAMES | names
    exec(source, found)
    return found
