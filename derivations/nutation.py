"""Section 3.5.4: nutation in the Lagrange formalism."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import (
    Eq,
    Expr,
    Ge,
    Gt,
    Matrix,
    Ne,
    cos,
    factor_list,
    pi,
    sin,
    solve,
    symbols,
)

from rigidtop.proof.equation import Cross, Dot, Equation, Group, as_printed
from rigidtop.proof.page import Assumption, Check, Evidence, Page, Remark, Step, claim
from rigidtop.theory import top
from rigidtop.theory.euler import OMEGA, along_flow, kinetic_energy
from rigidtop.theory.lagrangian import Linearisation, cyclic_velocities, linearise
from rigidtop.theory.symbols import (
    A,
    D,
    E,
    Edot,
    F,
    M,
    Omega,
    R,
    U,
    U_slope,
    delta,
    g,
    lambda1,
    lambda3,
    mean_theta,
    mu,
    n,
    omega1,
    omega2,
    omega3,
    omega_n2,
    omega_vec,
    p_phi,
    p_psi,
    p_theta,
    phidot,
    phidot_slope,
    psidot,
    slip,
    theta,
    theta_0,
    thetadot,
    v_tip,
    zhat,
)
from rigidtop.theory.trig import reduce_ratio

from . import evidence
from .euler_angles import TILTED

SMALL = Assumption(Eq(A, 0), "small oscillations", stated=True, otherwise=A)


def steady_state() -> dict:
    """p_φ, p_ψ and g of a steady precession at θ with ω₃ and Ω."""
    rates = {phidot: Omega, psidot: omega3 - Omega * cos(theta)}
    weight = (lambda3 * omega3 * Omega - lambda1 * cos(theta) * Omega**2) / (M * R)
    momenta = top.symmetric_momenta()
    return {p_phi: momenta[1].subs(rates), p_psi: momenta[2].subs(rates), g: weight}


def potential_slope(order: int) -> Expr:
    """The derivative of the effective potential by θ at a steady precession (J)."""
    return reduce_ratio(top.top_effective_potential().diff(theta, order).subs(steady_state()))


def mean_shift(second: Expr, third: Expr) -> Expr:
    """The mean of a swing A cos x about the minimum of a potential, to second order in A.

    λ₁θ̈ = −U′ with U′ = U″δ + ½U‴δ² and λ₁ times the square of the frequency = U″: the constant
    term of what is of order A² has to vanish.
    """
    phase, shift, overtone, u2, u3 = symbols("x c_0 c_2 u_2 u_3")
    swing = A * cos(phase) + A**2 * (shift + overtone * cos(2 * phase))
    balance = u2 * (swing.diff(phase, 2) + swing) + u3 * swing**2 / 2
    order = (balance.diff(A, 2) / 2).subs(A, 0)
    # The mean over four quarters of a turn is exact: there is no harmonic above the third.
    constant = sum(order.subs(phase, k * pi / 2) for k in range(4)) / 4
    [solution] = solve(constant, shift)
    return A**2 * solution.subs({u2: second, u3: third})


def upright() -> Linearisation:
    """The symmetric top near θ = 0, in e₃ = (x, y, z): regular there, as φ and θ are not.

    The Routhian with p_ψ = λ₃ω₃ constant; φ̇ cos θ is φ̇, the rate of an angle, which changes no
    equation, less (1 − z)φ̇ = (xẏ − yẋ)/(1 + z).
    """
    x, y, u, v = symbols("x y u v", real=True)
    z = 1 - (x**2 + y**2) / 2  # and smaller terms, which no second derivative at 0 sees
    kinetic = lambda1 / 2 * (u**2 + v**2 + (x * u + y * v) ** 2)
    routhian = kinetic - p_psi * (x * v - y * u) / (1 + z) - M * g * R * z
    return linearise(routhian, (x, y), (u, v), {x: 0, y: 0, u: 0, v: 0})


@claim(
    "nutation",
    "When started a little off, θ oscillates about the value where it could be constant.",
)
def nutation() -> Iterator[Evidence]:
    """θ moves in the effective potential of its p_φ and p_ψ, whose minimum is the steady angle.

    The frequency is √(U″/λ₁), for a fast top λ₃ω₃/λ₁; released at rest, a fast top swings with the
    amplitude λ₁MgR sin θ/(λ₃ω₃)² about an angle that much below the release. With finite
    amplitude A the mean lies off the steady angle, by −A²U‴/(4U″).
    """
    with as_printed():
        frequency = Equation(
            lambda1**2 * omega_n2,
            Group(lambda3 * omega3) ** 2
            - 4 * lambda1 * M * g * R * cos(theta)
            + Group(lambda1 * Omega * sin(theta)) ** 2,
        )
        squares = Equation(
            lambda1**2 * omega_n2,
            Group(lambda3 * omega3 - 2 * lambda1 * Omega * cos(theta)) ** 2
            + Group(lambda1 * Omega * sin(theta)) ** 2,
        )
        centre = Equation(mean_theta, 0)
    curvature = potential_slope(2)
    meaning = {omega_n2: curvature / lambda1, g: steady_state()[g]}
    yield Step(Equation(U, top.top_effective_potential()), "Minus the Routhian at θ̇ = 0.")
    yield Check(
        Equation(U_slope, 0),
        {U_slope: potential_slope(1)},
        reason="The slope of the potential vanishes at the steady angle.",
        printed=False,
    )
    yield Check(frequency, meaning, reason="λ₁U″ at the steady angle.", printed=False)
    yield Check(
        squares,
        meaning,
        reason="A sum of squares: every steady precession with sin θ ≠ 0 is stable.",
        printed=False,
    )
    yield Check(
        centre,
        {mean_theta: mean_shift(curvature, potential_slope(3))},
        (SMALL,),
        "The mean of θ less the steady angle.",
        printed=False,
    )
    characteristic = upright().characteristic(Omega)
    [factor, _] = [f for f in factor_list(characteristic)[1] if f[0].has(p_psi)][:2]
    spin = {p_psi: lambda3 * omega3}
    lean = 1 - cos(theta)
    with as_printed():
        discriminant = Equation(D, Group(lambda3 * omega3) ** 2 - 4 * lambda1 * M * g * R)
        kept = Equation(
            E - p_psi**2 / (2 * lambda3) - M * g * R - Omega * Group(p_phi - p_psi),
            lambda1 / 2 * Group(thetadot**2 + Group(phidot - Omega) ** 2 * sin(theta) ** 2)
            + Group(lean)
            / (8 * lambda1)
            * Group(2 * D + Group(lambda3 * omega3) ** 2 * Group(lean)),
        )
        stays = Equation(2 * D + Group(lambda3 * omega3) ** 2 * Group(lean), 0, relation=">")
    threshold = factor[0].as_poly(Omega).discriminant().subs(spin)
    yield Check(
        discriminant,
        {D: threshold},
        reason="Upright, θ = 0 is constant too. There the frequencies Ω solve λ₁Ω² − λ₃ω₃Ω + MgR "
        "= 0, with the discriminant D.",
        printed=False,
    )
    spinning = top.symmetric_momenta().subs(psidot, omega3 - phidot * cos(theta))
    momenta = dict(zip((p_theta, p_phi, p_psi), spinning, strict=True))
    yield Check(
        kept,
        {
            **momenta,
            E: top.symmetric_hamiltonian().subs(momenta),
            Omega: lambda3 * omega3 / (2 * lambda1),
            D: threshold,
        },
        reason="With Ω = λ₃ω₃/(2λ₁), halfway between them, this is constant,",
        printed=False,
    )
    yield Check(
        stays,
        {},
        (
            Assumption(
                Ge(D, 0),
                "an upright top has at least the sleeping spin, else it falls away from θ = 0",
            ),
            Assumption(Ne(omega3, 0), "the top spins", stated=True),
            Assumption(Gt(lean, 0), "off the upright", stated=True),
        ),
        "and zero only upright and at rest, so that θ stays small, if a top sleeps.",
        printed=False,
    )
    yield from evidence.nutation()


@claim("azimuth", "φ̇ then varies by (3.45): waves, cusps, loops.")
def azimuth() -> Iterator[Evidence]:
    """φ̇ has the sign of p_φ − p_ψ cos θ, which changes at cos θ₀ = p_φ/p_ψ.

    θ₀ between the turning points makes loops, on one of them cusps, outside them waves. A top that
    is released at rest has θ₀ where it is released: cusps. With p_φ = p_ψ = 0 (example 34) φ rests
    although θ changes.
    """
    rate = cyclic_velocities(top.symmetric_lagrangian(), (phidot, psidot), (p_phi, p_psi))[phidot]
    momenta = top.symmetric_momenta()
    with as_printed():
        printed = Equation(phidot, (p_phi - p_psi * cos(theta)) / (lambda1 * sin(theta) ** 2))
        changes_sign = Equation(
            lambda1 * sin(theta) ** 2 * phidot, p_psi * Group(cos(theta_0) - cos(theta))
        )
        released = Equation(p_phi, p_psi * cos(theta))
        varies = Equation(phidot_slope, 0, relation="≠")
    yield Check(
        printed,
        {p_phi: momenta[1], p_psi: momenta[2]},
        (TILTED,),
        "(3.45) with the momenta.",
        printed=False,
    )
    yield Check(
        changes_sign,
        {phidot: rate.subs(p_phi, p_psi * cos(theta_0))},
        reason="With p_φ = p_ψ cos θ₀.",
        printed=False,
    )
    yield Check(
        released,
        {p_phi: momenta[1].subs(phidot, 0), p_psi: momenta[2].subs(phidot, 0)},
        reason="At φ̇ = 0: a release at rest.",
        printed=False,
    )
    turning = p_psi * (1 + cos(theta) ** 2) - 2 * p_phi * cos(theta)
    yield Check(
        varies,
        {phidot_slope: rate.diff(theta)},
        (
            Assumption(
                Ne(turning, 0), "p_φ and p_ψ do not both vanish, and θ is not the one extremum"
            ),
        ),
        "The slope of φ̇ against θ.",
        printed=False,
    )
    yield from evidence.waves_cusps_loops()


@claim("friction", "Friction moves the point of contact and takes energy from the rotation.")
def friction() -> Iterator[Evidence]:
    """Ė is the contact force times the velocity of the tip where it touches: slip costs energy.

    Where static friction holds a sharp tip nothing moves and nothing is lost: that is the fixed
    pivot. Held so, a round tip rolls over the table. Without any friction the contact moves as
    well: the tip slides round at RΩ sin θ, while the centre of mass stays above one spot.
    """
    contact, force, velocity = (
        Matrix(symbols(f"{x}_1 {x}_2 {x}_3", real=True)) for x in ("r", "f", "v")
    )
    with as_printed():
        power = Equation(Edot, Dot(F, v_tip))
        loss = Equation(Edot, -mu * n * slip)
        falls = Equation(Edot, 0, relation="<")
        slides = Equation(Dot(v_tip, v_tip), Group(R * Omega * sin(theta)) ** 2)
        rolls = Equation(Cross(omega_vec, delta * zhat), Matrix([0, 0, 0]), relation="≠")
    torque = contact.cross(force)
    # In body components about the centre of mass: v·F for the motion of the centre, gravity's
    # power cancels against the potential energy, and Euler's equations give the rest.
    rate = velocity.dot(force) + along_flow(kinetic_energy(), torque)
    tip = velocity + Matrix(OMEGA).cross(contact)
    yield Check(
        power,
        {Edot: rate, F: force, v_tip: tip},
        reason="Newton for the centre, Euler about it; F is the contact force.",
        printed=False,
    )
    direction = Matrix([cos(theta), sin(theta), 0])
    sliding = {F: -mu * n * direction, v_tip: slip * direction}
    yield Check(
        loss,
        {Edot: sliding[F].dot(sliding[v_tip])},
        reason="Sliding friction μn against the slip v.",
        printed=False,
    )
    yield Check(
        falls,
        {Edot: sliding[F].dot(sliding[v_tip])},
        (Assumption(Gt(slip, 0), "the contact point slips over the table"),),
        printed=False,
    )
    figure_axis = Matrix([sin(theta), 0, cos(theta)])
    turning = Omega * Matrix([0, 0, 1])
    yield Check(
        rolls,
        {omega_vec: Matrix([omega1, omega2, omega3]), zhat: Matrix([0, 0, 1])},
        (
            Assumption(Ne(delta, 0), "the tip is round, with radius δ: held by friction it rolls"),
            Assumption(Ne(omega1, 0), "the top does not turn about the vertical alone"),
        ),
        "The velocity of the middle of a round tip that rolls, ω here along x̂, ŷ, ẑ; the contact "
        "follows below it.",
        printed=False,
    )
    yield Remark(
        slides,
        {v_tip: -R * turning.cross(figure_axis)},
        reason="Without friction the centre keeps its place and the tip, at −R e₃, goes round.",
        printed=False,
    )


page = Page(
    "3.5.4",
    "Nutation in the Lagrange formalism",
    "What θ and φ do when the precession is not quite steady.",
    (nutation, azimuth, friction),
    text="nutation",
)
