"""Judgements in another notation: the same verdicts, with every equation written in its symbols.

A claim is judged in the symbols of the notes.  That it says the same in those of another notation
is what the claims of `rigidtop.derivations.conventions` prove.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from sympy import Basic, Expr, Matrix, MatrixBase, pi

from rigidtop.notation.convention import Notation
from rigidtop.proof.counterexample import Counterexample
from rigidtop.proof.page import Assumption, Check, Definition, Measure, Step
from rigidtop.proof.verdict import Finding, Item, Judgement, Led, TestedAssumption
from rigidtop.theory import symbols as s
from rigidtop.theory.rotation import X_AXIS, Y_AXIS, Z_AXIS


def judgement_in(notation: Notation, judgement: Judgement) -> Judgement:
    """A judgement with all its equations, conditions and counterexamples in a notation."""
    if not notation.images:
        return judgement
    return replace(judgement, items=tuple(_item(notation, item) for item in judgement.items))


def _item(notation: Notation, item: Item) -> Item:
    if isinstance(item, Measure):
        return item
    if isinstance(item, Led):  # lines are put into a notation where they are shown
        return replace(item, assumptions=_tested(notation, item.assumptions))
    if isinstance(item, (Step, Definition)):
        return replace(item, equation=notation.written(item.equation))
    counterexample = item.counterexample
    return Finding(
        _check(notation, item.check),
        item.verdict,
        _tested(notation, item.assumptions),
        None if counterexample is None else _numbers(notation, counterexample),
    )


def _tested(
    notation: Notation, assumptions: Iterable[TestedAssumption]
) -> tuple[TestedAssumption, ...]:
    return tuple(
        TestedAssumption(
            _assumption(notation, t.assumption),
            None if t.without is None else _numbers(notation, t.without),
            None if t.claimed is None else notation.written(t.claimed),
        )
        for t in assumptions
    )


def _check(notation: Notation, check: Check) -> Check:
    other = check.other_reading
    return replace(
        check,
        claimed=notation.written(check.claimed),
        meaning=_resolved(notation, check.meaning),
        assuming=tuple(_assumption(notation, each) for each in check.assuming),
        given=tuple(map(notation.written, check.given)),
        other_reading=None if other is None else _resolved(notation, other),
    )


def _assumption(notation: Notation, assumption: Assumption) -> Assumption:
    return replace(
        assumption,
        condition=notation.written(assumption.condition),
        otherwise=notation.written(assumption.otherwise),
    )


def _resolved(notation: Notation, meaning: Mapping[Expr, Expr]) -> dict[Expr, Expr]:
    """What symbols mean; vectors along this notation's e₁′ and e₂′ where they are along primes."""
    own = _meaning(notation, meaning)
    axes = {s.e1p: X_AXIS, s.e2p: Y_AXIS}
    if not any(meaning.get(axis) == along for axis, along in axes.items()):
        return own
    turn = Matrix.hstack(
        *(own.get(notation.letters.get(axis, axis), along) for axis, along in axes.items()), Z_AXIS
    )
    return {
        key: turn.T * means if isinstance(means, MatrixBase) and means.shape == (3, 1) else means
        for key, means in own.items()
    }


def _meaning(notation: Notation, meaning: Mapping[Expr, Expr]) -> dict[Expr, Expr]:
    """What symbols mean; of −e₂′ its meaning with the other sign, where e₁′ had one."""
    images = {}
    for key, means in meaning.items():
        image = notation.images.get(key)
        means = _meant(notation, means)
        if image is None:
            key = notation.written(key)
        else:
            key = image.symbol
            means = -means if image.negative else means
            means = means - image.quarters * pi / 2 if image.quarters else means
        images[key] = means
    return images


def _meant(notation: Notation, means: Expr) -> Expr:
    """A meaning: an expression, the terms of a sum, or a function such as d/dt."""
    if isinstance(means, (list, tuple)):
        return [_meaning(notation, term) for term in means]
    if callable(means) and not isinstance(means, Basic):
        return lambda inside: notation.written(means(notation.in_notes(inside)))
    return notation.written(means)


def _numbers(notation: Notation, counterexample: Counterexample) -> Counterexample:
    """The same point: where φ is counted from another axis, it has another value there."""
    return replace(counterexample, values=_meaning(notation, counterexample.values))
