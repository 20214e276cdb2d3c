"""What kind of slip a wrong line may be."""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial

import sympy
from sympy import Expr, Pow, Symbol

from rigidtop.derivations import models
from rigidtop.mark import slips
from rigidtop.mark.links import (
    ERRORS,
    Link,
    Verdict,
    apart,
    in_numbers,
    is_matrix,
    judge,
    number_text,
    one_angle,
    pair_text,
)
from rigidtop.proof import decide
from rigidtop.proof.changed import Families
from rigidtop.proof.counterexample import entries
from rigidtop.proof.equation import Partial
from rigidtop.proof.model import Model, Passage, samples
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.trig import reduce_ratio
from rigidtop.typeset.text import text

TRIALS = 10
"""Motions at which a repaired line is tried."""


def explain(link: Link, passage: Passage) -> tuple[slips.Slip, ...]:
    """What kind of slip a wrong link may be, one of a kind; none where no small repair helps.

    A repair after which the link holds for every motion comes before one after which it holds for
    special motions: there many repairs help, and only the goal says that the motion is special.
    """
    forgotten = _partial(link, passage)
    if forgotten:
        return (forgotten,)
    fitting = [model for model in passage.models if not foreign(link, model)]
    for named in (partial(_repaired, passage.families), _missing):
        for model in fitting:
            found = named(link, model)
            if found:
                return found
    return ()


def _repaired(families: Families, link: Link, model: Model) -> tuple[slips.Slip, ...]:
    """The slips after whose repair a link holds for the motions of a model."""
    lost = _lost_root(link, model)
    if lost:
        return (lost,)
    if link.right is None:
        return slips.found(
            link.left, s.const, lambda left, _: _holds(Link(left, None), model), families
        )
    return slips.found(link.left, link.right, lambda a, b: _holds(Link(a, b), model), families)


def _holds(link: Link, model: Model) -> bool:
    """Whether a link holds at a few motions."""
    found = in_numbers(link, model, samples(model)[-TRIALS:])
    known = [sides for sides in found if sides is not None]
    return len(known) > TRIALS // 2 and not any(apart(*sides) for sides in known)


def _partial(link: Link, passage: Passage) -> slips.Slip | None:
    """∂/∂t for d/dt: the line holds if only velocities change, the angles being forgotten."""
    if not set(top.RATES) <= set(passage.models[0].rates):
        return None
    free, forgetful = _forgetful()
    slip = slips.Slip("partial", "∂/∂t where d/dt is meant: the angles change in time too")
    try:
        if link.right is None or not symbols_in(link) <= known_in(free):
            return None
        if judge(link, forgetful).holds and judge(link, free).holds is False:
            return slip
        # What is left of d/dt p = 0 without the angles' rates.
        [difference] = entries(free.value(link.left), free.value(link.right))
        for p in (s.p_phi, s.p_psi):
            complete, rate = (each.meaning[models.MOMENTUM_RATES[p]] for each in (free, forgetful))
            if rate == 0 or difference == 0 or decide.vanishes(complete - rate):
                continue
            if reduce_ratio(difference / rate).is_number:
                return slip
    except ERRORS:
        return None
    return None


@cache
def _forgetful() -> tuple[Model, Model]:
    """A top of which every motion is allowed, and one in whose rates the angles are forgotten."""
    free = models.heavy_top(along=False)
    still = replace(free, frozen=frozenset(top.ANGLES))
    rates = {models.MOMENTUM_RATES[p]: still.rate(p) for p in top.CONJUGATE}
    return free, replace(still, meaning={**free.meaning, **rates})


def _lost_root(link: Link, model: Model) -> slips.Slip | None:
    """For every motion the line holds with one sign of the root, but not always with the same."""
    if link.right is None or is_matrix(link.left) or is_matrix(link.right):
        return None
    roots = {
        power
        for side in (link.left, link.right)
        for power in side.atoms(Pow)
        if power.exp == sympy.Rational(1, 2)
    }
    if len(roots) != 1:
        return None
    [root] = roots
    with sympy.evaluate(False):
        turned = {root: sympy.Mul(sympy.Integer(-1), root)}
        other = Link(link.left.xreplace(turned), link.right.xreplace(turned))
    seen = set()
    tried = samples(model)
    for both in zip(*(in_numbers(each, model, tried) for each in (link, other)), strict=True):
        if None in both:
            continue
        holds = tuple(not apart(*pair) for pair in both if pair is not None)
        if not any(holds):
            return None
        seen.add(holds)
    if (False, True) in seen and (True, False) in seen:
        return slips.Slip("root", f"the root with the other sign of {text(root)} is lost")
    return None


def _missing(link: Link, model: Model) -> tuple[slips.Slip, ...]:
    """The one term by which the sides differ."""
    try:
        if link.right is None:
            return ()
        [difference] = entries(model.value(link.left), model.value(link.right))
        difference = reduce_ratio(one_angle(difference))
    except ERRORS:
        return ()
    if difference.is_Add or sympy.count_ops(difference) > 25:
        return ()
    _, below = sympy.fraction(difference)
    if below.has(sympy.Add):
        return ()
    return (slips.Slip("missing", f"a term: the left side is more by {side_text(difference)}"),)


# --- Links in words -------------------------------------------------------------------------------


@cache
def known_in(model: Model) -> set[Expr]:
    return model.symbols() | {x for x in model.meaning if isinstance(x, Partial)}


def symbols_in(link: Link) -> set[Expr]:
    """The letters of a link; a slope is one thing."""
    todo, found = [link.left, *([] if link.right is None else [link.right])], set[Expr]()
    while todo:
        node = todo.pop()
        if isinstance(node, (Symbol, Partial)):
            found.add(node)
        else:
            todo += [*node] if is_matrix(node) else [*node.args]
    return found


def foreign(link: Link, model: Model) -> set[Expr]:
    """The letters of a link that mean nothing in a model."""
    return {x for x in symbols_in(link) if not is_own(x)} - known_in(model)


def is_own(node: Expr) -> bool:
    return isinstance(node, Lettered) and node.quantity.meaning == "defined in the answer"


def side_text(side: Expr) -> str:
    try:
        return "const" if side is None else text(side)
    except (TypeError, AttributeError, ValueError, KeyError):
        return "…"


def counterexample(link: Link, verdict: Verdict) -> str:
    """The motion at which a link fails, in the symbols that stand in it, and its two sides."""
    assert verdict.at is not None
    point, meaning = verdict.at.point, verdict.at.meaning
    typed = sorted(symbols_in(link), key=str)
    values = {x: point.get(x, meaning.get(x)) for x in typed}
    if any(is_matrix(value) for value in values.values()) or link.right is None:
        values |= point
    numbers = {x: v for x, v in values.items() if v is not None and not is_matrix(v)}
    where = ", ".join(f"{side_text(x)} = {number_text(v)}" for x, v in numbers.items())
    at, one, other = f"at {where}: " * bool(where), verdict.left, verdict.right
    left, right = pair_text(one, other), pair_text(other, one)
    if left == right:
        left, right = pair_text(one, other, digits=15), pair_text(other, one, digits=15)
    if link.right is None:
        return f"{at}the rate is {left}, not 0"
    return f"{at}the left side is {left}, the right side {right}"
