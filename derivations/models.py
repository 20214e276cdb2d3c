"""The models of the lecture: what every symbol means for a top, a free body, in the simple picture.

Each is a `rigidtop.proof.model.Model`; the facts that a page or an answer is judged by.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache, partial
from typing import Any

import sympy
from sympy import Expr, Integer, Matrix, MatrixBase, Symbol, cos, eye, sin

from rigidtop.derivations.letters import is_a_body
from rigidtop.proof.equation import BODY, SPACE, Partial, Rate
from rigidtop.proof.model import Model
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.euler import (
    OMEGA,
    OMEGA_DOT,
    angular_momentum,
    body_accelerations,
    kinetic_energy,
)
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.rotation import (
    EULER_RATES,
    Z_AXIS,
    euler_matrix,
    euler_omega,
    primed_matrix,
    rotation_z,
    total_derivative,
)
from rigidtop.theory.symbols import Glyph, VocabularyEntry

_model = partial(Model, exists=is_a_body)


def _lettered(name: str, glyph: Glyph, meaning: str = "") -> Symbol:
    return Lettered(name, VocabularyEntry(glyph, meaning, ""), real=True)


def _dotted(symbol: Symbol) -> Symbol:
    glyph = s.VOCABULARY[symbol].glyph
    return _lettered(f"{symbol.name}dot", replace(glyph, accent="dot"), f"rate of {symbol.name}")


SLOPES_IN_RATES: Mapping[Expr, Symbol] = {
    Partial(s.Lagrangian, rate): p for p, rate in zip(top.CONJUGATE, top.RATES, strict=True)
}
"""∂ℒ/∂q̇, and the momentum that it is."""

MOMENTUM_RATES: Mapping[Symbol, Symbol] = {p: _dotted(p) for p in top.CONJUGATE}
OTHER_RATES: Mapping[Symbol, Symbol] = {x: _dotted(x) for x in (s.L_z, s.L3, s.Omega, s.E)}
PHASE = Symbol("chi", real=True)
"""Ω_b t."""


# --- The top -------------------------------------------------------------------------------------

_SYMMETRIC = {s.lambda2: s.lambda1}


def _axes() -> dict[Expr, Expr]:
    """Unit vectors, e₁′, e₂′ and e₃ being the basis."""
    space = primed_matrix().T
    last = rotation_z(s.psi)
    return {
        s.e1p: Matrix([1, 0, 0]),
        s.e2p: Matrix([0, 1, 0]),
        s.e3: Matrix([0, 0, 1]),
        s.e1: last[:, 0],
        s.e2: last[:, 1],
        s.xhat: space[:, 0],
        s.yhat: space[:, 1],
        s.zhat: space[:, 2],
    }


@cache
def heavy_top(along: bool) -> Model:
    """The symmetric top in Euler angles, with any accelerations or those along the motion.

    Vectors are along e₁′, e₂′, e₃.
    """
    found = dict(zip(top.ACCELERATIONS, top.symmetric_top_accelerations(), strict=True))
    accelerations = found if along else {a: a for a in top.ACCELERATIONS}
    rates = {q: accelerations.get(rate, rate) for q, rate in EULER_RATES.items()}
    omega = Matrix(euler_omega("primed"))
    body = euler_omega("body")
    moments = Matrix([s.lambda1, s.lambda1, s.lambda3])
    momentum = moments.multiply_elementwise(omega)
    lagrangian, p = top.symmetric_lagrangian(), top.symmetric_momenta()
    potential = s.M * s.g * s.R * cos(s.theta)
    axes = _axes()
    torque = s.M * s.g * s.R * axes[s.zhat].cross(axes[s.e3])
    # The frame of e₁′, e₂′, e₃ turns: without ψ̇.
    frame = Matrix([omega[0], omega[1], s.phidot * cos(s.theta)])

    def seen_from_space(vector: Matrix) -> Matrix:
        return total_derivative(vector, rates) + frame.cross(vector)

    meaning: dict[Expr, Expr | MatrixBase] = {
        **axes,
        s.lambda2: s.lambda1,
        s.omega1p: omega[0],
        s.omega2p: omega[1],
        s.omega1: body[0],
        s.omega2: body[1],
        s.omega3: omega[2],
        s.omega3dot: total_derivative(omega[2], rates),
        s.omega_vec: omega,
        s.L_vec: momentum,
        s.L1: s.lambda1 * body[0],
        s.L2: s.lambda1 * body[1],
        s.L_vecdot: seen_from_space(momentum),
        s.e3dot: seen_from_space(axes[s.e3]),
        s.L3: momentum[2],
        s.L_z: (axes[s.zhat].T * momentum)[0],
        s.T: lagrangian + potential,
        s.V: potential,
        s.E: lagrangian + 2 * potential,
        s.Lagrangian: lagrangian,
        **dict(zip(top.CONJUGATE, p, strict=True)),
        **{Partial(s.Lagrangian, x): lagrangian.diff(x) for x in (*EULER_RATES, s.t)},
        **{
            pdot: total_derivative(px, rates)
            for px, pdot in zip(p, MOMENTUM_RATES.values(), strict=True)
        },
        Rate(s.L_vec): seen_from_space(momentum),
        Rate(s.L_vec, SPACE): seen_from_space(momentum),
        s.N_vec: torque,
        s.N_ext: torque,
        s.R_CM: s.R * axes[s.e3],
        s.g_vec: -s.g * axes[s.zhat],
    }
    for quantity in (s.L_z, s.L3, s.E):
        meaning[OTHER_RATES[quantity]] = total_derivative(meaning[quantity], rates)
    if along:
        meaning |= accelerations
    return _model("", meaning, rates, frame=frame, omega=omega, along=along)


@cache
def steady() -> Model:
    """θ is constant: φ̇ = Ω and ω₃ are too, and the torque is balanced (3.57), or sin θ = 0."""
    general = heavy_top(along=True)
    meaning = {**general.meaning, s.Omega: s.phidot, OTHER_RATES[s.Omega]: Integer(0)}
    spin = s.omega3 - s.Omega * cos(s.theta)
    at_rest: Mapping[Symbol, Expr] = {s.thetadot: Integer(0)}
    turning: Mapping[Symbol, Expr] = {s.phidot: s.Omega, s.psidot: spin}
    # Ω = 0 balances nothing, so this is every steady motion with sin θ ≠ 0.
    weight = s.M * s.g * s.R
    balanced = {s.omega3: (s.lambda1 * cos(s.theta) * s.Omega**2 + weight) / (s.lambda3 * s.Omega)}
    upright = tuple(
        replace(general, meaning=meaning, limits=(at_rest, turning, {s.theta: angle}))
        for angle in (Integer(0), sympy.pi)
    )
    return replace(
        general,
        words="θ constant",
        meaning=meaning,
        limits=(at_rest, turning, balanced),
        branch=upright,
        lost=sin(s.theta),
    )


@cache
def roots() -> Model:
    """What ω₃ and θ say of the two rates of steady precession."""
    discriminant = (s.lambda3 * s.omega3) ** 2 - 4 * s.lambda1 * s.M * s.g * s.R * cos(s.theta)
    below = 2 * s.lambda1 * cos(s.theta)
    return _model(
        "",
        {
            s.D: discriminant,
            s.Omega_minus: (s.lambda3 * s.omega3 - sympy.sqrt(discriminant)) / below,
            s.Omega_plus: (s.lambda3 * s.omega3 + sympy.sqrt(discriminant)) / below,
        },
        {},
        timeless=True,
    )


# --- Free bodies, the simple picture, components -------------------------------------------------


@cache
def free(symmetric: bool) -> Model:
    """Euler's equations without torque, in body components."""
    rates = dict(zip(OMEGA, body_accelerations(), strict=True))
    momentum = angular_momentum()

    def along(expression: Expr) -> Any:
        return total_derivative(expression, rates)

    meaning: dict[Expr, Expr | MatrixBase] = {
        s.e1: Matrix([1, 0, 0]),
        s.e2: Matrix([0, 1, 0]),
        s.e3: Matrix([0, 0, 1]),
        **dict(zip(OMEGA_DOT, body_accelerations(), strict=True)),
        s.omega1ddot: along(along(s.omega1)),
        s.omega2ddot: along(along(s.omega2)),
        s.omega_vec: Matrix(OMEGA),
        s.L_vec: momentum,
        **dict(zip((s.L1, s.L2, s.L3), momentum, strict=True)),
        s.T: kinetic_energy(),
        Rate(s.L_vec, BODY): along(momentum),
        Rate(s.L_vec, SPACE): sympy.zeros(3, 1),
        s.N_ext: sympy.zeros(3, 1),
        s.t: s.t,
    }
    model = _model("", meaning, {**rates, s.t: Integer(1)}, omega=Matrix(OMEGA))
    if not symmetric:
        return model
    meaning[s.Omega_b] = (s.lambda1 - s.lambda3) * s.omega3 / s.lambda1
    return replace(model, words="λ₂ = λ₁", meaning=meaning, limits=(_SYMMETRIC,))


@cache
def turning() -> Model:
    """Euler's equations with any torque, in body components."""
    torque = Matrix([s.N1, s.N2, s.N3])
    kept, rates = (
        free(symmetric=False).meaning,
        dict(zip(OMEGA, body_accelerations(torque), strict=True)),
    )
    omega, momentum, energy = Matrix(OMEGA), angular_momentum(), kinetic_energy()
    along = total_derivative(momentum, rates)
    meaning: dict[Expr, Expr | MatrixBase] = {
        **{x: kept[x] for x in (s.e1, s.e2, s.e3, s.omega_vec, s.L_vec)},
        **dict(zip((s.L1, s.L2, s.L3), momentum, strict=True)),
        **dict(zip(OMEGA_DOT, rates.values(), strict=True)),
        s.L: sympy.sqrt(momentum.dot(momentum)),
        s.T: energy,
        s.Tdot: total_derivative(energy, rates),
        s.L_vecdot: along + omega.cross(momentum),
        s.N_vec: torque,
        s.N_ext: torque,
    }
    return _model("", meaning, rates, frame=omega, omega=omega)


@cache
def body_cone() -> Model:
    """The solution of a symmetric body that starts with ω₂ = 0, ω₁ = ω₀."""
    model = free(symmetric=True)
    frequency = model.meaning[s.Omega_b]
    turning = {
        s.omega1: s.omega_0 * cos(PHASE),
        s.omega2: -s.omega_0 * sin(PHASE),
        s.t: PHASE / frequency,
    }
    return replace(
        model,
        words="ω₂ = 0 and ω₁ = ω₀ at t = 0",
        meaning={**model.meaning, s.omega_0: s.omega_0},
        limits=(_SYMMETRIC, turning),
    )


@cache
def picture() -> Model:
    """3.5.2: L = λ₃ω₃e₃ turned by the torque of gravity; space components."""
    axis = Matrix([sin(s.theta) * cos(s.phi), sin(s.theta) * sin(s.phi), cos(s.theta)])
    vertical = Matrix(Z_AXIS)
    precession = s.M * s.g * s.R / (s.lambda3 * s.omega3)
    torque = s.M * s.g * s.R * vertical.cross(axis)
    turning = precession * vertical
    attitude = euler_matrix()
    meaning: dict[Expr, Expr | MatrixBase] = {
        s.e1: attitude[:, 0],
        s.e2: attitude[:, 1],
        s.e3: axis,
        s.omega1: Integer(0),
        s.omega2: Integer(0),
        s.e3dot: turning.cross(axis),
        s.xhat: Matrix([1, 0, 0]),
        s.yhat: Matrix([0, 1, 0]),
        s.zhat: vertical,
        s.L_vec: s.lambda3 * s.omega3 * axis,
        s.L_vecdot: torque,
        s.omega_vec: s.omega3 * axis,
        s.N_vec: torque,
        s.N_ext: torque,
        s.R_CM: s.R * axis,
        s.g_vec: -s.g * vertical,
        s.Omega_vec: turning,
        s.Omega: precession,
        s.phidot: precession,
        s.thetadot: Integer(0),
    }
    rates = {s.phi: precession, s.theta: Integer(0)}
    return _model("", meaning, rates, frame=sympy.zeros(3, 1), omega=s.omega3 * axis)


@cache
def components() -> Model:
    """O with e₁, e₂, e₃ as columns, and a vector that is the same in both frames."""
    attitude = euler_matrix()
    body = Matrix(sympy.symbols("r1 r2 r3", real=True))
    short = ((s.c_theta, s.s_theta), (s.c_phi, s.s_phi), (s.c_psi, s.s_psi))
    return _model(
        "",
        {
            **{cosine: cos(a) for (cosine, _), a in zip(short, top.ANGLES, strict=True)},
            **{sine: sin(a) for (_, sine), a in zip(short, top.ANGLES, strict=True)},
            s.O_matrix: attitude,
            s.unit: eye(3),
            s.r_vecp: body,
            s.r_vec: attitude * body,
            **{e: attitude[:, k] for k, e in enumerate((s.e1, s.e2, s.e3))},
            s.xhat: Matrix([1, 0, 0]),
            s.yhat: Matrix([0, 1, 0]),
            s.zhat: Matrix([0, 0, 1]),
        },
        {},
        timeless=True,
    )


def families() -> tuple[tuple[Model, ...], ...]:
    """The models that there are: of each kind of motion from the general to the special."""
    return (
        (components(),),
        (free(symmetric=False), free(symmetric=True), body_cone()),
        (heavy_top(along=False),),
        (heavy_top(along=True), steady(), roots()),
        (picture(),),
    )
