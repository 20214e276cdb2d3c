r"""Anyone's notes held against themselves: what each line says, and what the lines above say of it.

The file's own definitions are put in, and Lagrange's equations are taken from its own ℒ: a line
holds because of them, or contradicts them, with numbers.  What nothing above speaks of is taken as
it stands, and not called right.  So notes on a system of which nobody has heard are checked.

>>> from rigidtop.notation import OWN
>>> from rigidtop.read.formula import read
>>> text = (r"L = \frac12 m\dot x^2 - \frac12 kx^2,\quad m\ddot x = -kx,\quad m\ddot x = kx")
>>> for each in held(read(text, OWN)):
...     print(each.verdict, each.note.partition(";")[0], sep=": ")
premise: the Lagrangian of the equations that follow
proved: by Lagrange's equations
false: at k = 1, m = 1, x = 2: ẍ is −2 by Lagrange's equations
"""

from __future__ import annotations

import time
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from itertools import pairwise

import sympy
from sympy import Expr, Symbol

from rigidtop.mark.case import UNREAD, Held, letters
from rigidtop.mark.judge import Judge
from rigidtop.mark.law import accent, bare, base
from rigidtop.mark.ledger import LAGRANGIANS
from rigidtop.notation.convention import own
from rigidtop.proof import equation as eq
from rigidtop.proof.equation import Equation
from rigidtop.proof.verdict import Verdict
from rigidtop.read.formula import Line
from rigidtop.read.habits import NO_HABITS, Habits
from rigidtop.terminal.limit import TooLong, within
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph

A_FORMULA = 10.0
"""No formula is judged for longer than this (s, of the processor's time)."""


def held(
    lines: Iterable[Line],
    habits: Habits = NO_HABITS,
    cases: Sequence[tuple[int, ...]] = (),
    until: float = float("inf"),
    constant: Collection[int] = (),
    special: Collection[int] = (),
) -> tuple[Held, ...]:
    """Each line that was read, judged by the lines above it.

    `cases` says for each line in which case it stands (`rigidtop.read.cases`), its heading first;
    of the `constant` ones, by number, words say that they give what is conserved, of the `special`
    ones that they are of a case.  After a time of `time.process_time` no more are judged, and none
    for longer than `A_FORMULA`.
    """
    found = list(lines)
    paths = list(cases) or [(0,)] * len(found)
    places = [path[0] for path in paths]
    under: dict[int, list[Line]] = {}
    for line, place in zip(found, places, strict=True):
        under.setdefault(place, []).append(line)
    always = frozenset(own(glyph) for glyph in habits.timed)
    dotted = {place: _moving(some) | always for place, some in under.items()}
    # Equations of motion often stand under a heading of their own.
    moving = {place: some | dotted.get(place + 1, frozenset()) for place, some in dotted.items()}
    known = frozenset().union(*moving.values())
    of = {x: args for x, args in _arguments(habits.functions).items() if x not in known}
    ledger = Judge(moving, of, habits.kind, _twins(found))
    ledger.equations = [line.equation for line in found]
    ledger.special = frozenset(special)
    sides = (side for x in found if x.equation is not None for side in x.equation.sides)
    ledger.accelerated = {bare(x) for side in sides for x in letters(side) if accent(x) == "ddot"}
    made = []
    for i, line in enumerate(found):
        if line.equation is None:
            made.append(Held(line, UNREAD, line.problem))
            continue
        if time.process_time() > until:
            made.append(Held(line, Verdict.UNDECIDED.value, "the time for the file was over"))
            continue
        ledger.section = places[i]
        ledger.path = ledger.paths[i] = paths[i]
        before = {*ledger.given}
        try:
            with within(A_FORMULA):
                judged = ledger.take(i, line)
                letter = next((x for x in ledger.given if x not in before and not accent(x)), None)
                if letter is not None:
                    judged = ledger.conserved(i, judged, letter, i in constant)
        except TooLong:
            _forget(ledger, line.equation.sides[0])
            note = f"judging it takes longer than {A_FORMULA:g} s"
            judged = Held(line, Verdict.UNDECIDED.value, note)
        made.append(judged)
    return tuple(made)


def _forget(ledger: Judge, first: Expr) -> None:
    """Judge nothing further by what stood for a letter whose line was not finished."""
    ledger.given.pop(first, None)
    if isinstance(first, Symbol) and base(first) in LAGRANGIANS:
        ledger.law, ledger.sets, ledger.other = None, {}, None


def _twins(lines: Sequence[Line]) -> dict[int, Equation]:
    """The lines that ± makes: two at one place, with the same left side."""
    made: dict[int, Equation] = {}
    for (i, one), (k, two) in pairwise(enumerate(lines)):
        a, b = one.equation, two.equation
        if a is None or b is None or one.position != two.position:
            continue
        if a.sides[0] == b.sides[0] and len(a.sides) == len(b.sides):
            made |= {i: b, k: a}
    return made


def _moving(lines: Iterable[Line]) -> frozenset[Symbol]:
    """The letters that have a dot somewhere."""
    found: set[Symbol] = set()
    for line in lines:
        for side in line.equation.sides if line.equation is not None else ():
            for node in sympy.preorder_traversal(side):
                if isinstance(node, Lettered) and node.quantity.glyph.accent in ("dot", "ddot"):
                    found.add(own(replace(node.quantity.glyph, accent="")))
                elif isinstance(node, eq.Rate) and isinstance(node.args[0], Lettered):
                    found.add(node.args[0])
    return frozenset(found)


def _arguments(functions: Iterable[tuple[Glyph, str]]) -> dict[Symbol, tuple[Symbol, ...]]:
    made: dict[Symbol, set[Symbol]] = {}
    for glyph, of in functions:
        if of:
            made.setdefault(own(glyph), set()).add(own(Glyph(of)))
    return {x: tuple(sorted(args, key=str)) for x, args in made.items()}
