"""Whether the meaning of a statement comes from anything but the statement.

Held against a meaning that is typed equal to it, every statement is true.  What the engine derives
may well be the same tree, so the trees alone do not tell: the page is read.  What stands there is
*typed* if it consists of names, numbers, operations and elementary functions, rearranged or not, in
the page or in functions and modules beside it.  It is *derived* if anything else is called: a
derivative, a product of vectors, the engine.
"""

from __future__ import annotations

import ast
import inspect
import linecache
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib.util import resolve_name
from itertools import pairwise
from types import CodeType, ModuleType
from typing import Any

from sympy import Basic, Expr, MatrixBase, Mul, Number, NumberSymbol, Symbol, expand
from sympy.core.function import FunctionClass

from rigidtop.proof.equation import Cross, Dot, Group, SumOver, Transposed, VolumeIntegral, value
from rigidtop.proof.page import Check
from rigidtop.theory.symbols import const

WRITING = {
    *("Add", "Mul", "Pow", "Rational", "Integer", "Float", "Matrix", "ImmutableMatrix", "sqrt"),
    *("Symbol", "symbols", "sympify", "subs", "xreplace", "replace", "doit", "evalf", "items"),
    *("expand", "factor", "simplify", "together", "apart", "cancel", "collect", "trigsimp"),
    *("expand_trig", "radsimp", "factor_terms", "nsimplify", "reduce_trig", "reduce_ratio"),
    *("lines", "dict", "list", "tuple", "zip", "sum", "range", "cache"),
}
"""What makes an expression as it is typed, or writes it in another form."""

WORK = (Cross, Dot, Transposed, SumOver, VolumeIntegral)
"""What is worked out from the meanings of its parts."""

_WRITERS = (
    *("rigidtop.proof.equation", "rigidtop.proof.page", "rigidtop.theory.lettered"),
    "rigidtop.read.page",
)


class CircularMeaningError(Exception):
    """What is put into a statement is typed on the page, and is the statement itself."""


def refuse_circular(check: Check, found: Any, evidence: Callable[..., Any]) -> None:
    """Raises CircularMeaningError if a check proves nothing but itself.

    It is what `found`, made by calling `evidence`, has just yielded.  It is circular if all that is
    put into the statement is typed and makes two of its sides one tree (or, for what the statement
    gives the value of, the same when multiplied out), or if an equation that is said to be given is
    typed and is the statement.
    """
    while inspect.isgenerator(getattr(found, "gi_yieldfrom", None)):
        found = found.gi_yieldfrom
    page, line = None, 0
    if inspect.isgenerator(found) and found.gi_frame is not None:
        page, line = _text(found.gi_code, found.gi_frame.f_globals), found.gi_frame.f_lineno
    elif inspect.isfunction(function := inspect.unwrap(evidence)):
        page = _text(function.__code__, function.__globals__)
    sides = [side for side in check.claimed.sides if side != const]
    used = [x for x, m in check.meaning.items() if m != x and any(s.has(x) for s in sides)]
    if page is None or check.claimed.relation not in ("=", "≡") or not (used or check.given):
        return
    # What is worked out from meanings that are typed is no copy, unless it is typed in them.
    worked_out = any(s.has(*WORK) for s in sides) and not _has_work(check.meaning[x] for x in used)
    for arguments in page.checks(line):
        meant = [page.found(x, arguments.get("meaning")) for x in used]
        if not all(meant) or any(map(_derived, meant)):
            continue
        given = "given" in arguments and not _derived([(page, arguments["given"])])
        known = [value(h, {}) for h in check.given if given]
        meanings = [value(value(side, check.meaning), {}) for side in sides]
        for names, (a, b) in zip(pairwise(sides), pairwise(meanings), strict=True):
            stated = any(_gives(*names, x) or _gives(*names[::-1], x) for x in used)
            if used and not worked_out and (a == b or (stated and _vanishes(a, b))):
                what = f"the meaning of {', '.join(map(str, used))}"
            elif any(_vanishes(h, c) for h in known for c in (a - b, b - a)):
                what = "what is given"
            else:
                continue
            raise CircularMeaningError(
                f"{what} is typed, and is what the statement says: derive it"
            )


def _has_work(meanings: Iterable[Any]) -> bool:
    return any(isinstance(m, (Basic, MatrixBase)) and m.has(*WORK) for m in meanings)


def _gives(side: Expr, other: Expr, x: Expr) -> bool:
    """Whether one side is x, or a multiple of it, and the other is what x is said to be."""
    factors = side.args if isinstance(side, (Mul, Group)) else ()
    return not other.has(x) and (side == x or any(_gives(part, other, x) for part in factors))


def _vanishes(a: Any, b: Any) -> bool:
    if isinstance(a, MatrixBase) != isinstance(b, MatrixBase):
        return False
    difference = expand(a - b)
    return bool(difference.is_zero_matrix if isinstance(a, MatrixBase) else difference == 0)


@dataclass(frozen=True)
class _Text:
    """A function, or a module outside of its functions; and what the names of the module are."""

    body: ast.AST
    names: Mapping[str, Any]

    def checks(self, line: int) -> list[dict[str, ast.expr]]:
        """The arguments, by name, of the checks that are made where `line` is; else of all."""
        made = [call for call in _calls(self.body) if _is_check(self.known(call.func))]
        here = [call for call in made if call.lineno <= line <= (call.end_lineno or line)]
        return [
            {
                **dict(zip(Check.__dataclass_fields__, call.args, strict=False)),
                **{word.arg: word.value for word in call.keywords if word.arg},
            }
            for call in here or made
        ]

    def known(self, node: ast.AST | None) -> Any:
        """What a name of the module, or of one that it has, is; None for all else."""
        if isinstance(node, ast.Name) and node.id not in _bindings(self.body):
            return self.names.get(node.id)
        if isinstance(node, ast.Attribute) and isinstance(self.known(node.value), ModuleType):
            return getattr(self.known(node.value), node.attr, None)
        return None

    def bound(self, node: ast.AST | None) -> list[tuple[_Text, ast.AST]]:
        """What a name stands for, where the page or a neighbour says so."""
        if isinstance(node, ast.Attribute) and isinstance(self.known(node.value), ModuleType):
            return self._beside(self.known(node.value), node.attr)
        return self._named(node.id) if isinstance(node, ast.Name) else []

    def _named(self, name: str) -> list[tuple[_Text, ast.AST]]:
        if name in _bindings(self.body):
            return [
                (_Text(part, self.names) if isinstance(part, ast.FunctionDef) else self, part)
                for part in _bindings(self.body)[name]
            ]
        tree = _tree(self.names.get("__file__"))
        if self.body is not tree:
            return _Text(tree, self.names)._named(name)
        for node in (n for n in tree.body if isinstance(n, ast.ImportFrom) and n.level):
            for alias in node.names:
                if name == (alias.asname or alias.name):
                    relative = "." * node.level + (node.module or "")
                    whole = resolve_name(relative, self.names["__package__"])
                    if f"{whole}.{alias.name}" not in sys.modules:
                        return self._beside(sys.modules.get(whole), alias.name)
        return []

    def _beside(self, module: ModuleType | None, name: str) -> list[tuple[_Text, ast.AST]]:
        """What a name of another module stands for, if that is one of the same folder."""
        here, there = (f"{m.get('__package__')}." for m in (self.names, vars(module or ast)))
        if module is None or not (here.startswith(there) or there.startswith(here)):
            return []
        return _Text(_tree(module.__file__), vars(module))._named(name)

    def found(self, key: Expr, mapping: ast.AST | None) -> list[tuple[_Text, ast.AST]]:
        """Where the page has what a mapping gives for a key; nothing where it has no such key."""
        there = self.known(mapping)
        if mapping is None or (isinstance(there, Mapping) and key not in there):
            return []
        if isinstance(mapping, ast.Name) and (bound := self.bound(mapping)):
            return [part for text, node in bound for part in text.found(key, node)]
        if not isinstance(mapping, ast.Dict):
            return [(self, mapping)]
        unsure: list[tuple[_Text, ast.AST]] = []
        for name, node in reversed([*zip(mapping.keys, mapping.values, strict=True)]):
            if name is not None and self.known(name) == key:
                return [*unsure, (self, node)]
            if name is None:
                unsure += self.found(key, node)
            elif self.known(name) is None:
                unsure.append((self, node))
        return unsure


def _derived(parts: Sequence[tuple[_Text, ast.AST]]) -> bool:
    """Whether anything is called, there or in what it is made of, that does more than to write."""
    todo, seen = [*parts], set[ast.AST]()
    while todo:
        text, whole = todo.pop()
        if whole in seen:
            continue
        seen.add(whole)
        body = whole.body if isinstance(whole, ast.FunctionDef) else [whole]
        for node in (node for part in body for node in ast.walk(part)):
            if isinstance(text.known(node), Symbol) or _is_function(text.known(node)):
                continue  # a name; what a page prints
            bound = text.bound(node)
            todo += bound
            if not bound and _is_made(text.known(node)):
                return True
            if isinstance(node, ast.Call) and not text.bound(node.func):
                function = text.known(node.func)
                name = getattr(node.func, "attr", getattr(node.func, "id", ""))
                if not (name in WRITING or _is_function(function)):
                    return True
    return False


def _is_function(thing: Any) -> bool:
    """Whether it is a sine, or makes what stands in printed equations."""
    return isinstance(thing, FunctionClass) or getattr(thing, "__module__", "") in _WRITERS


def _is_made(thing: Any) -> bool:
    """Whether it is an expression from elsewhere, or a collection of them, and no mere name."""
    if isinstance(thing, (tuple, list, Mapping)):
        return any(map(_is_made, thing.values() if isinstance(thing, Mapping) else thing))
    made = isinstance(thing, (Basic, MatrixBase))
    return made and not isinstance(thing, (Symbol, Number, NumberSymbol))


def _is_check(thing: Any) -> bool:
    return isinstance(thing, type) and issubclass(thing, Check)


def _text(code: CodeType, names: Mapping[str, Any]) -> _Text | None:
    """The function with this code, or None where its source is not to be had."""
    linecache.checkcache(code.co_filename)
    found = _functions(_tree(code.co_filename)).get((code.co_name, code.co_firstlineno))
    return None if found is None else _Text(found, names)


@lru_cache(maxsize=100)
def _functions(tree: ast.AST) -> Mapping[tuple[str, int], ast.FunctionDef]:
    """Those of a file, by name and first line, which may be a decorator's."""
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    return {
        (f.name, min([f.lineno, *(decorator.lineno for decorator in f.decorator_list)])): f
        for f in functions
    }


@lru_cache(maxsize=1000)
def _calls(body: ast.AST) -> Sequence[ast.Call]:
    return [node for node in ast.walk(body) if isinstance(node, ast.Call)]


def _tree(file: str | None) -> ast.Module:
    return _parsed("".join(linecache.getlines(file)) if file else "")


@lru_cache(maxsize=100)
def _parsed(source: str) -> ast.Module:
    return ast.parse(source)


@lru_cache(maxsize=1000)
def _bindings(body: ast.AST) -> Mapping[str, Sequence[ast.AST]]:
    """What each name is bound to there, by assignments, loops and definitions."""
    made: dict[str, list[ast.AST]] = {}
    todo = [*ast.iter_child_nodes(body)]
    while todo:
        node = todo.pop()
        if isinstance(node, ast.FunctionDef):
            made.setdefault(node.name, []).append(node)
            continue
        todo += ast.iter_child_nodes(node)
        targets = getattr(node, "targets", [getattr(node, "target", None)])
        given = getattr(node, "value", getattr(node, "iter", None))
        for name in (name for target in targets if target for name in ast.walk(target)):
            if isinstance(name, ast.Name) and isinstance(given, ast.expr):
                made.setdefault(name.id, []).append(given)
    return made
