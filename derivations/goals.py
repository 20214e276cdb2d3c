"""Goals that answers lead to: what they may be said in, and by which facts they are judged.

What else the lecture says is judged by the first of `rigidtop.derivations.models.families` in which
it holds.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

from sympy import Matrix, Ne, Symbol

from rigidtop.derivations import lecture, models
from rigidtop.proof.equation import Equation, Meaning
from rigidtop.proof.model import Model, Passage, unknown
from rigidtop.theory import symbols as s
from rigidtop.theory.euler import OMEGA, OMEGA_DOT

_MOMENTS = frozenset({s.lambda1, s.lambda3})
_WEIGHT = frozenset({s.M, s.g, s.R})
_BASIS = frozenset({s.e1p, s.e2p, s.e3})
_SPINNING = _MOMENTS | {s.theta, s.phidot, s.psidot, s.omega3, s.L3, s.p_psi}
_ANGULAR = _SPINNING | {s.thetadot}


@cache
def goals() -> Mapping[str, Passage]:
    """Goals that may be said in other letters than those of the page, or that are no identities
    alone, by their numbers or names."""
    top, moving, steady = models.heavy_top(False), models.heavy_top(True), models.steady()
    free, symmetric, cone = models.free(False), models.free(True), models.body_cone()
    picture, roots, frames = models.picture(), models.roots(), models.components()
    # λ₁ is in no line of the picture: one that has it is false, not unread.
    picture = picture.freed({s.lambda1: s.lambda1})
    w, momentum = unknown("w", 3), unknown("l", 3)
    both = {s.Omega_minus: s.Omega_minus, s.Omega_plus: s.Omega_plus}
    made = (
        _goal("3.37", (free, symmetric), OMEGA_DOT, {*_MOMENTS, s.Omega_b, *OMEGA, *OMEGA_DOT[:2]}),
        _goal(
            "3.38",
            (symmetric, cone),
            {s.omega1: w[0], s.omega2: w[1], s.omega_vec: Matrix([w[0], w[1], s.omega3])},
            {s.omega_vec, *OMEGA, s.omega_0, s.Omega_b, s.t, s.e1, s.e2, s.e3},
        ),
        _goal(
            "3.39",
            (symmetric, cone),
            {s.L_vec: momentum, **dict(zip((s.L1, s.L2, s.L3), momentum, strict=True))},
            {*_MOMENTS, s.L_vec, s.L1, s.L2, s.L3, s.omega_0, s.Omega_b, s.t, s.omega3}
            | {s.e1, s.e2, s.e3},
        ),
        _goal(
            "3.42",
            (top,),
            {s.omega_vec: w},
            {*_ANGULAR, *_BASIS, s.omega_vec} | {s.omega1p, s.omega2p},
        ),
        _goal("3.43", (top,), {s.L_vec: momentum}, {*_ANGULAR, *_BASIS, s.L_vec}),
        _goal("3.44", (top,), [s.T], {*_ANGULAR, s.T}),
        _goal("3.45", (top,), [s.L_z, s.L3], {s.phidot, s.theta, s.lambda1, s.L_z, s.L3}),
        _goal(
            "3.46",
            (frames,),
            {s.r_vecp: unknown("p", 3), s.r_vec: unknown("r", 3)},
            {s.r_vecp, s.r_vec, s.O_matrix},
        ),
        _goal(
            "3.52",
            (picture,),
            {s.Omega_vec: unknown("W", 3)},
            {*_WEIGHT, s.Omega_vec, s.zhat, s.lambda3, s.omega3},
            given=(Ne(s.omega3, 0),),
        ),
        _goal("3.54", (moving,), {}, {*_SPINNING, *_WEIGHT, s.thetaddot}, loose=top),
        _goal(
            "3.55",
            (moving,),
            {},
            {*_SPINNING, s.p_phi} - {s.p_psi},
            loose=top.freed({s.p_phi: s.p_phi}),
            conserved=s.p_phi,
        ),
        # L₃ is p_ψ: only another letter.
        _goal(
            "3.56",
            (moving,),
            {},
            _SPINNING - {s.L3},
            loose=top.freed({s.p_psi: s.p_psi}),
            conserved=s.p_psi,
        ),
        _goal(
            "3.57",
            (moving, steady),
            {},
            {*_SPINNING, *_WEIGHT, s.Omega},
            # Everything but the balance of torques.
            loose=replace(steady, limits=steady.limits[:2], branch=()),
            given=(Ne(s.Omega, 0),),
        ),
        _goal(
            "two-roots",
            (moving, steady, roots),
            both,
            {*_MOMENTS, *_WEIGHT, *both, s.D, s.omega3, s.theta},
        ),
    )
    return {passage.goal: passage for passage in made}


def _goal(
    goal: str,
    known: tuple[Model, ...],
    free: Meaning | Sequence[Symbol],
    allowed: Collection[Symbol],
    loose: Model | None = None,
    conserved: Symbol | None = None,
    given: tuple[Any, ...] = (),
) -> Passage:
    """A passage; what the goal tells is `free`, as itself or as what stands for it."""
    if not isinstance(free, Mapping):
        free = {x: x for x in free}
    if loose is None:
        loose = known[-1].freed(free)
    return Passage(
        goal, known, loose, _printed(goal, [*free]), frozenset(allowed), conserved, given
    )


def _printed(goal: str, told: Sequence[Symbol]) -> tuple[Equation, ...]:
    """The equations that the lecture has under a number, or else for what is told."""
    found: list[tuple[Equation, ...]] = [
        line.equations
        for line in lecture().lines.values()
        if any(e.tag == goal for e in line.equations)
        or (
            not goal[0].isdigit()
            and line.equations[0].relation == "="
            and [e.sides[0] for e in line.equations] == told
        )
    ]
    [equations] = found
    return equations
