"""Section 3.5.3: precession in the Lagrange formalism."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Eq, Expr, Gt, Lt, Matrix, Ne, Poly, cos, diag, sin, sqrt

from rigidtop.codegen import shipped
from rigidtop.proof.equation import Dot, Equation, Group, Underbrace, as_printed
from rigidtop.proof.page import Assumption, Check, Evidence, Page, Remark, Step, claim
from rigidtop.theory import top
from rigidtop.theory.euler import MOMENTS
from rigidtop.theory.lagrangian import momenta
from rigidtop.theory.rotation import (
    EULER_RATES,
    Z_AXIS,
    euler_matrix,
    euler_omega,
    primed_matrix,
    total_derivative,
)
from rigidtop.theory.symbols import (
    L3,
    R1,
    R2,
    R3,
    D,
    L_vec,
    L_z,
    Lagrangian,
    M,
    Omega,
    Omega_minus,
    Omega_plus,
    Omega_vec,
    R,
    const,
    delta,
    epsilon,
    g,
    lambda1,
    lambda2,
    lambda3,
    omega3,
    p_phi,
    p_psi,
    phiddot,
    phidot,
    psidot,
    theta,
    thetaddot,
    thetadot,
    zhat,
)

from . import evidence
from .euler_angles import HALF

TILTED = Assumption(Ne(sin(theta), 0), "the top is not upright and does not hang")
FAST = Assumption(
    Eq(epsilon, 0),
    "ω₃ very large: to leading order in ε = λ₁MgR cos θ/(λ₃ω₃)²",
    stated=True,
    otherwise=top.smallness(),
)
SPINNING = Assumption(Ne(omega3, 0), "the top spins about e₃", stated=True)
HORIZONTAL = Assumption(Ne(cos(theta), 0), "the top is not horizontal: else there is one root")
SYMMETRIC = Assumption(Eq(lambda2, lambda1), "a symmetric top", stated=True)
ON_AXIS = (
    Assumption(Eq(R1, 0), "the centre of mass lies on e₃, at R from the pivot", stated=True),
    Assumption(Eq(R2, 0), "the centre of mass lies on e₃, at R from the pivot", stated=True),
    Assumption(Eq(R3, R), "the centre of mass lies on e₃, at R from the pivot", stated=True),
)


def along_motion(expression: Expr) -> Expr:
    """d/dt along the top's equations of motion."""
    accelerations = dict(zip(top.ACCELERATIONS, top.symmetric_top_accelerations(), strict=True))
    return total_derivative(expression, EULER_RATES).subs(accelerations)


@claim("3.53", "Lagrangian of the heavy symmetric top.")
def lagrangian() -> Iterator[Evidence]:
    """T of (3.44) minus the potential; the engine starts from three moments and any centre."""
    with as_printed():
        printed = Equation(
            Lagrangian,
            HALF * lambda1 * Group(phidot**2 * sin(theta) ** 2 + thetadot**2)
            + HALF * lambda3 * Group(psidot + phidot * cos(theta)) ** 2
            - M * g * R * cos(theta),
            tag="3.53",
        )
    yield Check(printed, {Lagrangian: top.lagrangian()}, (SYMMETRIC, *ON_AXIS))
    yield Check(
        printed,
        {Lagrangian: top.symmetric_lagrangian()},
        reason="The form that rigidtop ships.",
        printed=False,
    )


def newton_euler_thetaddot() -> Expr:
    """θ̈ from L̇ + ω′ × L = N along e₂′; the frame e₁′, e₂′, e₃ turns with ω′ (rad/s²)."""
    omega = euler_omega("primed")
    frame = Matrix([omega[0], omega[1], phidot * cos(theta)])
    momentum = Matrix([lambda1 * omega[0], lambda1 * omega[1], lambda3 * omega[2]])
    vertical = primed_matrix().T * Z_AXIS
    torque = Matrix([0, 0, R]).cross(-M * g * vertical)
    return (torque - frame.cross(momentum))[1] / lambda1


@claim("3.54", "Equation of motion for θ.")
def theta_equation() -> Iterator[Evidence]:
    """Lagrange's equation of (3.53) for θ."""
    with as_printed():
        printed = Equation(
            lambda1 * thetaddot,
            lambda1 * phidot**2 * sin(theta) * cos(theta)
            - lambda3 * (psidot + phidot * cos(theta)) * phidot * sin(theta)
            + M * g * R * sin(theta),
            tag="3.54",
        )
    yield Check(printed, {thetaddot: top.symmetric_top_accelerations()[0]})
    yield Check(
        printed,
        {thetaddot: newton_euler_thetaddot()},
        reason="L̇ = N along e₂′ gives the same, without a Lagrangian.",
        printed=False,
    )
    yield Check(
        printed,
        {thetaddot: shipped.symbolic("top_in_euler_angles")[0]},
        reason="The function that rigidtop integrates, run on symbols.",
        printed=False,
    )


@claim("3.55", "p_φ is constant.")
def momentum_phi() -> Iterator[Evidence]:
    """φ does not enter (3.53), so ∂ℒ/∂φ̇ is conserved."""
    with as_printed():
        printed = Equation(
            p_phi,
            lambda1 * phidot * sin(theta) ** 2
            + lambda3 * (psidot + phidot * cos(theta)) * cos(theta),
            const,
            tag="3.55",
        )
    yield Check(printed, {p_phi: top.symmetric_momenta()[1], const: along_motion})


@claim("3.56", "p_ψ is constant.")
def momentum_psi() -> Iterator[Evidence]:
    """ψ does not enter (3.53) either."""
    with as_printed():
        printed = Equation(p_psi, lambda3 * Group(psidot + phidot * cos(theta)), const, tag="3.56")
    yield Check(printed, {p_psi: top.symmetric_momenta()[2], const: along_motion})
    yield from evidence.conserved()


@claim("p-phi-is-Lz", "p_φ is L_z.")
def p_phi_is_l_z() -> Iterator[Evidence]:
    """∂T/∂φ̇ is ẑ·L for every body, since φ turns the whole body about ẑ."""
    momentum = euler_matrix() * diag(*MOMENTS) * euler_omega("body")
    with as_printed():
        same = Equation(p_phi, L_z)
        formula = Equation(
            L_z,
            lambda1 * phidot * sin(theta) ** 2
            + lambda3 * (psidot + phidot * cos(theta)) * cos(theta),
        )
    meaning = {p_phi: momenta(top.lagrangian(), top.RATES)[1], L_z: (Z_AXIS.T * momentum)[0]}
    yield Check(same, meaning, reason="For any three moments.", printed=False)
    yield Check(formula, meaning, (SYMMETRIC,), "L_z is the p_φ of (3.55).", printed=False)


@claim("p-psi-is-L3", "p_ψ is L₃.")
def p_psi_is_l_3() -> Iterator[Evidence]:
    """∂T/∂ψ̇ is e₃·L for every body; it is conserved if the body is symmetric about e₃."""
    momentum = diag(*MOMENTS) * euler_omega("body")
    with as_printed():
        same = Equation(p_psi, L3)
        formula = Equation(L3, lambda3 * Group(psidot + phidot * cos(theta)))
    meaning = {p_psi: momenta(top.lagrangian(), top.RATES)[2], L3: momentum[2]}
    yield Check(same, meaning, printed=False)
    yield Check(formula, meaning, reason="L₃ of (3.43) is the p_ψ of (3.56).", printed=False)


@claim("constant-rate", "Constant θ implies constant φ̇.")
def constant_rate() -> Iterator[Evidence]:
    """ṗ_φ = cos θ ṗ_ψ at constant θ is λ₁ sin²θ φ̈ = 0; upright, φ̇ and ψ̇ may do as they like."""
    equations = top.symmetric_equations()
    balance = equations[1] - cos(theta) * equations[2]
    with as_printed():
        rates = Equation(
            0,
            lambda1 * phiddot * sin(theta) ** 2
            + 2 * lambda1 * phidot * thetadot * sin(theta) * cos(theta)
            - lambda3 * (psidot + phidot * cos(theta)) * thetadot * sin(theta),
        )
        constant = Equation(phiddot, 0)
    yield Check(
        rates,
        {},
        reason="Lagrange's equation for φ less cos θ times that for ψ.",
        given=(balance.expand(),),
        printed=False,
    )
    yield Check(
        constant,
        {},
        (Assumption(Eq(thetadot, 0), "θ is constant", stated=True), TILTED),
        given=(balance.expand(),),
        printed=False,
    )


@claim("3.57", "The quadratic for the rate of steady precession.")
def steady_precession() -> Iterator[Evidence]:
    """Constant θ makes θ̈ vanish in (3.54); the factor sin θ is divided out.

    That loses the branch sin θ = 0: upright or hanging, every Ω is a steady motion.
    """
    with as_printed():
        balance = Equation(
            0,
            lambda1 * phidot**2 * sin(theta) * cos(theta)
            - lambda3 * (psidot + phidot * cos(theta)) * phidot * sin(theta)
            + M * g * R * sin(theta),
        )
        divided = Equation(
            0,
            lambda1 * Omega**2 * cos(theta)
            - lambda3 * Underbrace(Group(psidot + phidot * cos(theta)), omega3) * Omega
            + M * g * R,
        )
        printed = Equation(
            0,
            Group(lambda1 * cos(theta)) * Omega**2 - Group(lambda3 * omega3) * Omega + M * g * R,
            tag="3.57",
        )
    resting = top.symmetric_equations()[0].subs({thetaddot: 0, thetadot: 0})
    steady = {phidot: Omega, psidot: omega3 - Omega * cos(theta), omega3: omega3}
    yield Check(balance, {}, reason="θ̇ = θ̈ = 0 in (3.54)", given=(resting,))
    yield Check(
        divided, steady, (TILTED,), "divided by sin θ, with φ̇ = Ω", given=(top.steady_balance(),)
    )
    yield Check(printed, {}, (TILTED,), "ordered by powers of Ω", given=(top.steady_balance(),))
    yield from evidence.steady_precession()


@claim(
    "two-roots",
    "Two solutions; for large ω₃ a slow one, MgR/(λ₃ω₃), and a fast one, λ₃ω₃/(λ₁ cos θ).",
)
def two_roots() -> Iterator[Evidence]:
    """The standard formula, written so that neither root cancels for large ω₃.

    They are two if the discriminant D is positive: (λ₃ω₃)² > 4λ₁MgR cos θ, always true for
    cos θ < 0, where they have opposite signs. At cos θ = 0 only the slow one is left.
    """
    slow, fast = top.steady_roots()
    leading, _, _ = Poly(top.steady_quadratic(), Omega).all_coeffs()
    lead = top.leading_roots()
    factor = top.root_factors()
    with as_printed():
        discriminant = Equation(
            D, Group(lambda3 * omega3) ** 2 - 4 * lambda1 * M * g * R * cos(theta)
        )
        quadratic = Equation(leading, 0, relation="≠")
        two = Equation(D, 0, relation=">")
        apart = Equation(lambda1 * cos(theta) * Group(Omega_plus - Omega_minus), sqrt(D))
        solves = [
            Equation(
                Group(lambda1 * cos(theta)) * root**2 - Group(lambda3 * omega3) * root + M * g * R,
                0,
            )
            for root in (Omega_minus, Omega_plus)
        ]
        slow_root = Equation(Omega_minus, M * g * R / (lambda3 * omega3))
        fast_root = Equation(Omega_plus, lambda3 * omega3 / (lambda1 * cos(theta)))
    meaning = {D: top.discriminant(), Omega_minus: slow, Omega_plus: fast}
    yield Step(Equation(Omega_minus, slow), "For ω₃ > 0; regular at cos θ = 0.")
    yield Step(Equation(Omega_plus, fast), "For ω₃ > 0.")
    yield Check(discriminant, meaning, printed=False)
    for line in solves:
        yield Check(line, meaning, reason="It solves (3.57).", printed=False)
    yield Check(apart, meaning, reason="The roots are √D apart.", printed=False)
    yield Check(
        quadratic,
        {},
        (HORIZONTAL,),
        "(3.57) is quadratic.",
        printed=False,
    )
    yield Check(
        two,
        meaning,
        (
            Assumption(
                Gt(lambda3**2 * omega3**2, 4 * lambda1 * M * g * R * cos(theta)),
                "the spin is above the threshold",
            ),
        ),
        "The roots are real and differ.",
        printed=False,
    )
    yield Remark(
        two,
        meaning,
        (Assumption(Lt(cos(theta), 0), "the top hangs below the horizontal"),),
        "No threshold there.",
        printed=False,
    )
    yield Check(slow_root, {Omega_minus: lead[0] * factor[0]}, (FAST, SPINNING))
    yield Check(fast_root, {Omega_plus: lead[1] * factor[1]}, (FAST, HORIZONTAL))
    slow_series, fast_series = top.steady_expansions(2)
    yield Step(Equation(Omega_minus, slow_series), "The slow root to the next order.")
    yield Step(Equation(Omega_plus, fast_series), "The fast root to the next order.")


@claim(
    "slow-agrees",
    "Ω₋ agrees with (3.52); that ω₃ is large means the same as that the torque is weak.",
)
def slow_agrees() -> Iterator[Evidence]:
    """Ω₋ λ₃ω₃/(MgR) depends on ε alone: δ times the spin does what 1/δ² times the weight does.

    What has to be small is the weight MgR against (λ₃ω₃)²/λ₁. The torque MgR sin θ does not tell:
    near the vertical it is as small as one likes at any spin.
    """
    slow = top.leading_roots()[0] * top.root_factors()[0]
    with as_printed():
        agrees = Equation(Omega_minus, Dot(Omega_vec, zhat))
        vector = Equation(Omega_vec, M * g * R / (lambda3 * omega3) * zhat)
        equivalent = Equation(
            epsilon, lambda1 * (M * g * R / delta**2) * cos(theta) / Group(lambda3 * omega3) ** 2
        )
    # (3.50) without its first side: λ₃ω₃ Ω × e₃ = N.
    figure_axis = Matrix([sin(theta), 0, cos(theta)])
    torque = M * g * R * Matrix(Z_AXIS).cross(figure_axis)
    simple = torque[1] / figure_axis[0] / (lambda3 * omega3) * Matrix(Z_AXIS)
    meaning = {Omega_minus: slow, Omega_vec: simple, zhat: Matrix(Z_AXIS)}
    scaled = Assumption(Ne(delta, 0), "the spin is multiplied by δ", stated=True)
    yield Check(
        equivalent,
        {epsilon: top.smallness().subs(omega3, delta * omega3)},
        (scaled, SPINNING),
        "The footnote: large ω₃ and weak torque are the same.",
        printed=False,
    )
    yield Check(vector, meaning, (SPINNING,), "(3.52),", printed=False)
    yield Check(agrees, meaning, (FAST,), "which Ω₋ tends to.", printed=False)


@claim("fast-is-free", "Ω₊ does not depend on g and is the free precession of 3.2.3.")
def fast_is_free() -> Iterator[Evidence]:
    """Without weight the top turns about L at Ω_s = L/λ₁ (not Ω_b), L vertical if θ is constant.

    At Ω₊ the L of (3.43) is λ₁Ω₊ẑ, to leading order. 3.2.3 holds about the fixed point too, with
    the moments about that point. With weight Ω₊ does depend on g: by its next term, −MgR/(λ₃ω₃).
    """
    fast = top.leading_roots()[1] * top.root_factors()[1]
    momentum = primed_matrix() * Matrix([-lambda1 * fast * sin(theta), 0, lambda3 * omega3])
    with as_printed():
        without_g = Equation(Omega_plus, lambda3 * omega3 / (lambda1 * cos(theta)))
        free = Equation(Omega_plus * zhat, L_vec / lambda1)
    meaning = {Omega_plus: fast, L_vec: momentum, zhat: Matrix(Z_AXIS)}
    yield Check(without_g, meaning, (FAST, HORIZONTAL), "No g on the right.", printed=False)
    yield Check(
        free,
        meaning,
        (FAST,),
        "The rotational velocity of the free precession in space, L/λ₁.",
        printed=False,
    )
    yield from evidence.fast_root_is_free()


page = Page(
    "3.5.3",
    "Precession in the Lagrange formalism",
    "The heavy symmetric top, without the assumption L ∥ ω.",
    (
        lagrangian,
        theta_equation,
        momentum_phi,
        momentum_psi,
        p_phi_is_l_z,
        p_psi_is_l_3,
        constant_rate,
        steady_precession,
        two_roots,
        slow_agrees,
        fast_is_free,
    ),
    text="lagrange_formalism",
)
