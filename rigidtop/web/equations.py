"""The functions that the page computes with, as derived, written into a JavaScript module.

``python -m rigidtop.web`` rewrites `rigidtop/web/live-page/equations.js`; with ``--check`` it only
says whether that is current.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import sympy
from sympy import Expr, Matrix, diag, sqrt

from rigidtop.codegen.javascript import quantity, rates
from rigidtop.codegen.shipped import RightHandSide, named
from rigidtop.theory import euler, rotation, top
from rigidtop.theory import symbols as s
from rigidtop.typeset.text import text
from rigidtop.web import terms

PATH = Path(__file__).parent / "live-page" / "equations.js"
"""The generated module."""

HEADER = """\
// Right-hand sides, momenta, energies and bounds of rigid-body motion, as derived.
//
// Written by `python -m rigidtop.web` from `rigidtop.theory`: do not edit.
//
// λ₁, λ₂, λ₃ are the moments of inertia about the pivot (of a free body, about its centre of mass),
// q₀ … q₃ is the unit quaternion, scalar first, that takes body components to space components, and
// ω₁, ω₂, ω₃ are components in the body frame.  SI units and radians.
"""


def attitude() -> Matrix:
    """R of the unit quaternion, body to space."""
    return rotation.quaternion_matrix(Matrix(top.QUATERNION))


def quaternion_of_angles() -> tuple[Expr, ...]:
    """The unit quaternion of Rz(φ) Ry(θ) Rz(ψ): the product of those of the three turns."""
    turns = [
        sympy.Quaternion.from_axis_angle(axis, angle)
        for axis, angle in (((0, 0, 1), s.phi), ((0, 1, 0), s.theta), ((0, 0, 1), s.psi))
    ]
    product = turns[0] * turns[1] * turns[2]
    return tuple(sympy.trigsimp(part) for part in product.args)


def euler_rates() -> Matrix:
    """θ̇, φ̇, ψ̇ from ω in body components; singular where sin θ = 0."""
    omega = rotation.euler_omega("body")
    solved = sympy.solve(list(omega - Matrix(euler.OMEGA)), top.RATES, dict=True)
    return Matrix([sympy.simplify(solved[0][rate]) for rate in top.RATES])


def energy() -> Expr:
    """½ Σ λₖωₖ² and Mg times the height of the centre of mass."""
    height = rotation.Z_AXIS.dot(attitude() * Matrix(top.CENTRE_OF_MASS))
    return euler.kinetic_energy() + s.M * s.g * height


def smallest_spin() -> Expr:
    """The ω₃ > 0 at which the discriminant of (3.57) vanishes."""
    square = sympy.Symbol("square", positive=True)
    [solution] = sympy.solve(top.discriminant().subs(s.omega3**2, square), square)
    return sympy.powdenest(sqrt(solution), force=True)


def polhode() -> tuple[Expr, ...]:
    """ω₁, ω₂, ω₃ > 0 on the polhode round e₃ with given 2T and L², at an angle on it.

    2Tλ₃ − L² has no ω₃ in it: an ellipse in ω₁ and ω₂.
    """
    twice_T, L_squared, angle = sympy.symbols("twice_T L_squared angle", real=True)
    energy, momentum = euler.first_integrals()
    ellipse = sympy.expand(energy * s.lambda3 - momentum)
    across = [
        sqrt((twice_T * s.lambda3 - L_squared) / sympy.factor(ellipse.coeff(omega, 2))) * turn
        for omega, turn in ((s.omega1, sympy.cos(angle)), (s.omega2, sympy.sin(angle)))
    ]
    kept = {s.omega1: across[0], s.omega2: across[1]}
    third = sqrt(sympy.expand((twice_T - energy.subs(s.omega3, 0)) / s.lambda3)).subs(kept)
    return *across, third


def nutation_cubic() -> tuple[Expr, ...]:
    """Coefficients of u³, u², u and 1 in θ̇² sin²θ, with u = cos θ; E is the energy."""
    inertia = sympy.expand(top.symmetric_lagrangian()).coeff(s.thetadot, 2)  # ½λ₁
    squared = (s.E - top.top_effective_potential()) / inertia * sympy.sin(s.theta) ** 2
    u = sympy.Symbol("u")
    in_u = sympy.expand(squared).subs(sympy.sin(s.theta) ** 2, 1 - u**2).subs(sympy.cos(s.theta), u)
    return tuple(map(sympy.factor_terms, sympy.Poly(sympy.expand(in_u), u).all_coeffs()))


def precession_numerator() -> tuple[Expr, ...]:
    """Coefficients of u and 1 in φ̇ sin²θ, with u = cos θ."""
    u = sympy.Symbol("u")
    _, phidot, _ = top.reduced_rates()
    product = sympy.expand(phidot * sympy.sin(s.theta) ** 2).subs(sympy.cos(s.theta), u)
    return tuple(sympy.Poly(product, u).all_coeffs())


def body_cone_rate() -> Expr:
    """Ω_b of (3.37): ω̇₁ = Ω_b ω₂ for λ₂ = λ₁."""
    return sympy.factor(euler.body_accelerations()[0].subs(s.lambda2, s.lambda1) / s.omega2)


def damped_body() -> RightHandSide:
    """A heavy body that friction slows."""
    heavy = named("heavy_body")
    return RightHandSide(
        "damped_body",
        "q̇₀ … q̇₃, ω̇₁, ω̇₂, ω̇₃ of a heavy body with friction −cω at its pivot, and what that takes.",
        (*heavy.state, sympy.Symbol("taken")),
        (*heavy.parameters, top.friction),
        top.damped_body_rates,
    )


def functions() -> Iterator[str]:
    """The JavaScript of each function of the generated module."""
    yield rates("heavyTop", named("heavy_top"))
    yield rates("heavyBody", named("heavy_body"))
    yield rates("dampedBody", damped_body())
    R = attitude()
    yield quantity("attitudeMatrix", "R row by row, body to space.", list(R))
    yield quantity(
        "quaternionOfAngles",
        "The unit quaternion of R = Rz(φ) Ry(θ) Rz(ψ).",
        quaternion_of_angles(),
    )
    omega = rotation.euler_omega("body")
    yield quantity("omegaOfRates", "ω₁, ω₂, ω₃ from Euler angles and rates (3.41).", list(omega))
    yield quantity(
        "eulerRates", "θ̇, φ̇, ψ̇ from ω; not finite where sin θ = 0 (rad/s).", list(euler_rates())
    )
    momentum = diag(*euler.MOMENTS) * Matrix(euler.OMEGA)
    yield quantity("angularMomentum", "L in space components (J s).", list(R * momentum))
    torque = (R * Matrix(top.CENTRE_OF_MASS)).cross(-s.M * s.g * rotation.Z_AXIS)
    yield quantity("gravityTorque", "R_CM × Mg in space components (N m).", list(torque))
    yield quantity("energy", "Kinetic and potential energy (J).", energy())
    yield quantity(
        "effectivePotential",
        "(p_φ − p_ψ cos θ)²/(2λ₁ sin²θ) + p_ψ²/(2λ₃) + MgR cos θ of the symmetric top (J).",
        top.top_effective_potential(),
    )
    yield quantity(
        "smallestSpin",
        "The smallest ω₃ > 0 with a steady precession at θ, where cos θ > 0 (rad/s).",
        smallest_spin(),
    )
    yield quantity(
        "steadyRates",
        "Ω₋ and Ω₊, the roots of (3.57), for ω₃ > 0; not finite where there are none (rad/s).",
        list(top.steady_roots()),
    )
    yield quantity(
        "nutationCubic",
        "Coefficients of u³, u², u and 1 in θ̇² sin²θ, where u = cos θ and E is the energy.",
        nutation_cubic(),
    )
    yield quantity(
        "precessionNumerator",
        "Coefficients of u and 1 in φ̇ sin²θ, where u = cos θ.",
        precession_numerator(),
    )
    yield quantity("bodyConeRate", "Ω_b of (3.37), for λ₂ = λ₁ (rad/s).", body_cone_rate())
    yield quantity("firstIntegrals", "2T and L² (J, J² s²).", euler.first_integrals())
    yield quantity(
        "polhode",
        "ω on the polhode round e₃, ω₃ > 0, with given 2T and L², at an angle on it (rad/s).",
        polhode(),
    )
    for each in (*terms.heavy(), *terms.general()):
        yield quantity(each.function, f"The terms of {text(each.equation)}.", each.values)


def module_text() -> str:
    """The whole text of the generated module."""
    return "\n\n".join([HEADER.rstrip(), *functions()]) + "\n"
