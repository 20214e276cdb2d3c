"""Section 3.5.2: precession in a simplified picture."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from sympy import Eq, Expr, Gt, Matrix, Ne, Poly, cos, sin, sqrt

from rigidtop.proof.equation import Cross, Dot, Equation, as_printed
from rigidtop.proof.page import Assumption, Check, Evidence, Page, Step, claim
from rigidtop.theory import top
from rigidtop.theory.rotation import (
    EULER_RATES,
    Z_AXIS,
    euler_omega,
    primed_matrix,
    total_derivative,
)
from rigidtop.theory.symbols import (
    R_CM,
    L_vec,
    L_vecdot,
    M,
    N_vec,
    Omega,
    Omega_minus,
    Omega_vec,
    R,
    Tdot,
    delta,
    e2p,
    e3,
    e3dot,
    epsilon,
    g,
    g_vec,
    kappa,
    lambda1,
    lambda3,
    omega3,
    omega_0,
    omega_vec,
    phi,
    phiddot,
    phidot,
    psiddot,
    psidot,
    theta,
    thetaddot,
    thetadot,
    yhat,
    zhat,
)
from rigidtop.theory.trig import reduce_ratio, reduce_trig

from . import evidence

WEAK = Assumption(
    Eq(epsilon, 0),
    "to leading order in ε = λ₁MgR cos θ/(λ₃ω₃)²: weak torque",
    stated=True,
    otherwise=top.smallness(),
)
NO_NUTATION = Assumption(Eq(thetadot, 0), "θ does not change: there is no nutation")
STEADY = Assumption(
    Eq(thetaddot, 0),
    "the top is set going steadily; released with ω along e₃ it nutates, and the equation holds on "
    "average",
)
SPINNING = Assumption(Ne(omega3, 0), "the top spins about e₃", stated=True)


@cache
def balance() -> Expr:
    """What vanishes by L̇ = N along e₂′, for L = λ₃ω₃e₃ + λ₁ e₃ × ė₃ at constant λ₃ω₃ (N m).

    Of λ₁ e₃ × ë₃ what a steady precession at Ω has is written with ε, with which it vanishes.
    """
    axes = primed_matrix()
    axis, nodes = axes[:, 2], axes[:, 1]
    velocity = total_derivative(axis, EULER_RATES)
    torque = M * g * R * Matrix(Z_AXIS).cross(axis)
    kept = nodes.dot(lambda3 * omega3 * velocity - torque)
    rest = lambda1 * nodes.dot(axis.cross(total_derivative(velocity, EULER_RATES)))
    kept, rest = (reduce_trig(part).subs(phidot, Omega) for part in (kept, rest))
    steady = rest.subs(thetaddot, 0)
    small = epsilon * reduce_ratio(steady / top.smallness())
    return (kept + (rest - steady).expand() + small).expand()


def steady_rate() -> Expr:
    """The Ω at which the torque keeps θ, that of the two which gravity makes (rad/s)."""
    a, b, c = Poly(balance().subs(thetaddot, 0), Omega).all_coeffs()
    return -2 * c / b / (1 + sqrt(1 - (4 * a * c / b**2).expand()))


def picture() -> dict:
    """e₃ at angle θ in the plane of x̂ and ẑ, precessing at Ω (space components).

    θ̇ is left in: a top that nutates.
    """
    axis = Matrix([sin(theta), 0, cos(theta)])
    vertical = Matrix(Z_AXIS)
    turning = Omega * vertical
    down = -g * vertical
    centre = R * axis
    torque = M * centre.cross(down)
    return {
        e3: axis,
        e3dot: turning.cross(axis) + thetadot * axis.diff(theta),
        zhat: vertical,
        yhat: Matrix([0, 1, 0]),
        g_vec: down,
        R_CM: centre,
        N_vec: torque,
        L_vecdot: torque,
        Omega_vec: turning,
    }


@claim("3.50", "λ₃ω₃ ė₃ = M R_CM × g, from L ∥ ω.")
def torque_balance() -> Iterator[Evidence]:
    """L̇ = N for the exact L = λ₃ω₃e₃ + λ₁ e₃ × ė₃; λ₁ e₃ × ë₃ is smaller by ε and left out.

    With L along e₃ at all times ω would be along e₃ too, and e₃ could not move: the equation can
    only hold to leading order, and exactly where cos θ = 0. A top that is released with ω along
    e₃, as the notes have it, starts with ė₃ = 0 and makes cusps; the equation is then that of its
    mean motion.
    """
    with as_printed():
        printed = Equation(
            L_vecdot, lambda3 * omega3 * e3dot, M * Cross(R_CM, g_vec), N_vec, tag="3.50"
        )
        momentum = Equation(L_vec, lambda3 * omega3 * e3 + lambda1 * Cross(e3, e3dot))
    axes = primed_matrix()
    omega = euler_omega("primed")
    spin = reduce_trig(axes * Matrix([lambda1 * omega[0], lambda1 * omega[1], lambda3 * omega[2]]))
    moving = axes[:, 2].diff(theta) * thetadot + axes[:, 2].diff(phi) * phidot
    yield Check(
        momentum,
        {L_vec: spin, omega3: omega[2], e3: axes[:, 2], e3dot: moving},
        reason="What L is without the simplification.",
        printed=False,
    )
    yield Check(printed, picture(), (STEADY, WEAK, NO_NUTATION), given=(balance(),))
    yield from evidence.mean_precession()


@claim("torque-perpendicular", "The torque is orthogonal to L and turns it at constant length.")
def perpendicular() -> Iterator[Evidence]:
    """N = MgR ẑ × e₃ is orthogonal to e₃; L has a part λ₁ e₃ × ė₃ besides, and N·L = λ₁MgR θ̇ sin θ.

    So |L| is constant while θ is, and pulsates with the nutation.
    """
    axes = primed_matrix()
    omega = euler_omega("primed")
    exact = axes * Matrix([lambda1 * omega[0], lambda1 * omega[1], lambda3 * omega[2]])
    figure_axis = axes[:, 2]
    torque = M * g * R * Matrix(Z_AXIS).cross(figure_axis)
    with as_printed():
        power = Equation(Dot(N_vec, L_vec), lambda1 * M * g * R * thetadot * sin(theta))
        orthogonal = Equation(Dot(N_vec, L_vec), 0)
    meaning = {N_vec: torque, L_vec: exact}
    yield Check(power, meaning, reason="Half the rate of |L|².", printed=False)
    yield Check(
        orthogonal,
        meaning,
        (Assumption(Eq(thetadot, 0), "θ does not change, as in steady precession"),),
        printed=False,
    )


@claim("3.51", "e₃ turns about a vertical Ω.")
def axis_turns() -> Iterator[Evidence]:
    """R_CM = R e₃ and g = −g ẑ put into (3.50); λ₃ω₃ is divided out."""
    with as_printed():
        printed = Equation(
            e3dot,
            M * g * R / (lambda3 * omega3) * Cross(zhat, e3),
            Cross(Omega_vec, e3),
            tag="3.51",
        )
    yield Check(printed, picture(), (STEADY, WEAK, NO_NUTATION, SPINNING), given=(balance(),))


@claim("3.52", "The precession vector Ω.")
def precession_vector() -> Iterator[Evidence]:
    """Read off (3.51); Ω is the rate at which L̇ = N keeps θ, exact for every spin."""
    with as_printed():
        printed = Equation(Omega_vec, M * g * R / (lambda3 * omega3) * zhat, tag="3.52")
    yield Step(
        Equation(Omega_minus, top.steady_expansions(2)[0]), "The slow root to the next order."
    )
    slow = Assumption(Eq(Omega, steady_rate()), STEADY.words)
    yield Check(printed, picture(), (slow, WEAK, SPINNING))


@claim("torque-direction", "The torque of gravity points into the paper.")
def torque_direction() -> Iterator[Evidence]:
    """N = R_CM × Mg for e₃ in the paper: x̂ to the right, ẑ up, so ŷ points into it."""
    with as_printed():
        across = Equation(N_vec, M * g * R * sin(theta) * yhat)
        into = Equation(Dot(N_vec, yhat), 0, relation=">")
    yield Check(across, picture(), reason="Sideways, never out of the horizontal.", printed=False)
    yield Check(
        into,
        picture(),
        (Assumption(Gt(sin(theta), 0), "the top leans to the right of the figure"),),
        printed=False,
    )


@claim("parallel-approximation", "L ∥ ω is a good approximation for a weak torque.")
def parallel() -> Iterator[Evidence]:
    """The part of ω across e₃ gains its energy from the weight alone: ½λ₁ω⊥² = MgR(cos θ₀ − cos θ).

    Started with ω along e₃, it stays of the order of the root of the torque, and cos² of the angle
    between L and ω tends to 1. A weak torque alone is not enough: a top in free precession has
    none, and its L and ω are not parallel.
    """
    with as_printed():
        aligned = Equation(
            Dot(L_vec, omega_vec) ** 2 / (Dot(L_vec, L_vec) * Dot(omega_vec, omega_vec)), 1
        )
        balance = Equation(Tdot, M * g * R * thetadot * sin(theta))
    # Along the motion d/dt ½λ₁(φ̇² sin²θ + θ̇²) is the power of the weight.
    rates = euler_omega("primed")
    across = (rates[0] ** 2 + rates[1] ** 2) / 2
    accelerations = dict(zip(top.ACCELERATIONS, top.symmetric_top_accelerations(), strict=True))
    power = total_derivative(across, EULER_RATES).subs(accelerations)
    yield Check(
        balance,
        {Tdot: lambda1 * power},
        reason="The rate of ½λ₁ω⊥²: gravity does the work, and ω₃ is constant.",
        printed=False,
    )
    transverse = sqrt(omega_0**2 + 2 * kappa * M * g * R / lambda1 * delta)
    yield Check(
        aligned,
        {
            L_vec: Matrix([lambda1 * transverse, 0, lambda3 * omega3]),
            omega_vec: Matrix([transverse, 0, omega3]),
        },
        (
            Assumption(Eq(omega_0, 0), "the top starts with ω along e₃", stated=True),
            Assumption(Eq(kappa, 0), "the torque κMgR is weak", stated=True, otherwise=kappa),
            SPINNING,
        ),
        "With δ = cos θ₀ − cos θ, along ω⊥ and e₃.",
        printed=False,
    )
    yield from evidence.parallel()


@claim("example-34", "A top released tilted with L = 0: how L evolves, and what motion it is.")
def toppling() -> Iterator[Evidence]:
    """L_z = L₃ = 0 stay zero, so φ and ψ rest: a plane pendulum that falls over.

    L grows along the fixed horizontal axis e₂′, which the torque has too; nothing precesses.
    """
    rest = {phidot: 0, psidot: 0}
    momentum = reduce_trig(
        primed_matrix()
        * Matrix([lambda1, lambda1, lambda3]).multiply_elementwise(euler_omega("primed"))
    ).subs(rest)
    accelerations = top.symmetric_top_accelerations().subs(rest)
    with as_printed():
        pendulum = Equation(lambda1 * thetaddot, M * g * R * sin(theta))
        along_nodes = Equation(L_vec, lambda1 * thetadot * e2p)
        azimuth_rests = Equation(Matrix([phiddot, psiddot]), Matrix([0, 0]))
        torque_along = Equation(N_vec, M * g * R * sin(theta) * e2p)
    nodes = primed_matrix()[:, 1]
    yield Check(
        azimuth_rests,
        {phiddot: accelerations[1], psiddot: accelerations[2]},
        reason="φ̇ and ψ̇ start at zero and have no rate.",
        printed=False,
    )
    yield Check(along_nodes, {L_vec: momentum, e2p: nodes}, printed=False)
    figure_axis = primed_matrix()[:, 2]
    yield Check(
        torque_along,
        {N_vec: M * g * R * Matrix(Z_AXIS).cross(figure_axis), e2p: nodes},
        printed=False,
    )
    yield Check(pendulum, {thetaddot: accelerations[0]}, printed=False)


page = Page(
    "3.5.2",
    "Precession in a simplified picture",
    "A fast top under a weak torque.",
    (
        torque_balance,
        perpendicular,
        axis_turns,
        precession_vector,
        torque_direction,
        parallel,
        toppling,
    ),
    text="simplified_picture",
)
