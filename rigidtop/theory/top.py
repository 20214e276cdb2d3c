"""The heavy top: one argument to the Lagrangian and to Euler's equations.

The general heavy body comes first (three moments about the pivot, centre of mass anywhere); the
lecture's symmetric top is λ₂ = λ₁ with the centre of mass on e₃.
"""

from __future__ import annotations

from functools import cache

import sympy
from sympy import Expr, ImmutableMatrix, Matrix, Rational, cos, diag, sin

from rigidtop.theory import symbols as s
from rigidtop.theory.euler import MOMENTS, OMEGA, body_accelerations
from rigidtop.theory.lagrangian import (
    accelerations,
    effective_potential,
    euler_lagrange,
    hamilton_equations,
    hamiltonian,
    mass_matrix,
    momenta,
    routhian,
)
from rigidtop.theory.lettered import real
from rigidtop.theory.rotation import (
    EULER_RATES,
    Z_AXIS,
    euler_matrix,
    euler_omega,
    primed_matrix,
    quaternion_matrix,
    quaternion_rates,
    total_derivative,
)
from rigidtop.theory.symbols import Glyph
from rigidtop.theory.trig import reduce_ratio, reduce_trig

ANGLES = (s.theta, s.phi, s.psi)
RATES = (s.thetadot, s.phidot, s.psidot)
ACCELERATIONS = (s.thetaddot, s.phiddot, s.psiddot)
CONJUGATE = (s.p_theta, s.p_phi, s.p_psi)
CENTRE_OF_MASS = (s.R1, s.R2, s.R3)
QUATERNION = (s.q0, s.q1, s.q2, s.q3)

friction = real("friction", Glyph("c"), "friction torque over ω", "J s")

SYMMETRIC = {s.lambda2: s.lambda1, s.R1: 0, s.R2: 0, s.R3: s.R}
"""What makes a heavy body the lecture's top."""


@cache
def kinetic_energy() -> Expr:
    """½ Σ λₖωₖ² of any rigid body in Euler angles and rates (J)."""
    omega = euler_omega("body")
    return Rational(1, 2) * omega.dot(diag(*MOMENTS) * omega)


@cache
def potential_energy() -> Expr:
    """Mg times the height of the centre of mass above the pivot (J)."""
    return s.M * s.g * reduce_trig(Z_AXIS.dot(euler_matrix() * Matrix(CENTRE_OF_MASS)))


@cache
def lagrangian() -> Expr:
    """T − V of a heavy body: any three moments, centre of mass anywhere in it (J)."""
    return kinetic_energy() - potential_energy()


@cache
def symmetric_lagrangian() -> Expr:
    """T − V of the heavy symmetric top (J), which is (3.53)."""
    omega1, omega2, omega3 = euler_omega("body")
    # Collected by moment before anything is expanded: λ₁ multiplies ω₁² + ω₂², free of ψ.
    across = reduce_trig(omega1**2 + omega2**2, keep="sin")
    kinetic = Rational(1, 2) * s.lambda1 * across + Rational(1, 2) * s.lambda3 * omega3**2
    return kinetic - potential_energy().subs(SYMMETRIC)


@cache
def symmetric_equations() -> ImmutableMatrix:
    """d/dt ∂L/∂q̇ − ∂L/∂q of the symmetric top for θ, φ, ψ (3×1, N m)."""
    return ImmutableMatrix(euler_lagrange(symmetric_lagrangian(), ANGLES, RATES, ACCELERATIONS))


@cache
def symmetric_momenta() -> ImmutableMatrix:
    """p_θ, p_φ, p_ψ of the symmetric top (3×1, J s)."""
    return ImmutableMatrix(momenta(symmetric_lagrangian(), RATES))


@cache
def symmetric_top_accelerations() -> ImmutableMatrix:
    """θ̈, φ̈, ψ̈ of the symmetric top (3×1, rad/s²); singular where sin θ = 0."""
    return ImmutableMatrix(accelerations(symmetric_lagrangian(), ANGLES, RATES).applyfunc(_tidy))


def along_motion(expression: Expr) -> Expr:
    """d/dt of a function of angles and rates of the symmetric top along its motion."""
    accelerations = dict(zip(ACCELERATIONS, symmetric_top_accelerations(), strict=True))
    return total_derivative(expression, EULER_RATES).subs(accelerations)


def newton_euler_thetaddot() -> Expr:
    """θ̈ from L̇ + ω′ × L = N along e₂′; the frame e₁′, e₂′, e₃ turns with ω′ (rad/s²)."""
    omega = euler_omega("primed")
    frame = Matrix([omega[0], omega[1], s.phidot * cos(s.theta)])
    momentum = Matrix([s.lambda1 * omega[0], s.lambda1 * omega[1], s.lambda3 * omega[2]])
    torque = Matrix([0, 0, s.R]).cross(-s.M * s.g * primed_matrix().T * Z_AXIS)
    return (torque - frame.cross(momentum))[1] / s.lambda1


def _tidy(ratio: Expr) -> Expr:
    """The spin's terms, with λ₃, as one product; then the rest over λ₁ term by term."""
    rest, spin = sympy.expand(ratio).as_independent(s.lambda3, as_Add=True)
    return sympy.factor(spin) + rest


@cache
def top_effective_potential() -> Expr:
    """(p_φ − p_ψ cos θ)²/(2λ₁ sin²θ) + p_ψ²/(2λ₃) + MgR cos θ (J)."""
    cyclic, p = (s.phidot, s.psidot), (s.p_phi, s.p_psi)
    derived = effective_potential(symmetric_lagrangian(), cyclic, p, (s.thetadot,))
    spin = s.p_psi**2 / (2 * s.lambda3)
    gravity = s.M * s.g * s.R * cos(s.theta)
    return reduce_ratio(derived - spin - gravity) + spin + gravity


@cache
def reduced_rates() -> ImmutableMatrix:
    """θ̈, φ̇, ψ̇ from the Routhian, p_φ and p_ψ constant (3×1): a motion of θ alone, and integrals.

    (p_φ − p_ψ cos θ) stays one factor: multiplied out it would lose digits near the vertical.
    """
    L, cyclic, p = symmetric_lagrangian(), (s.phidot, s.psidot), (s.p_phi, s.p_psi)
    [mass] = mass_matrix(routhian(L, cyclic, p), (s.thetadot,))
    potential = top_effective_potential()
    rates = Matrix([-potential.diff(s.theta) / mass, *(potential.diff(pk) for pk in p)])
    return ImmutableMatrix(rates.applyfunc(sympy.factor_terms))


@cache
def symmetric_hamiltonian() -> Expr:
    """p_θ²/(2λ₁) + (p_φ − p_ψ cos θ)²/(2λ₁ sin²θ) + p_ψ²/(2λ₃) + MgR cos θ (J)."""
    derived = hamiltonian(symmetric_lagrangian(), RATES, CONJUGATE)
    nutation, spin = s.p_theta**2 / (2 * s.lambda1), s.p_psi**2 / (2 * s.lambda3)
    rest = nutation + spin + s.M * s.g * s.R * cos(s.theta)
    return reduce_ratio(derived - rest) + rest


@cache
def symmetric_hamilton_equations() -> ImmutableMatrix:
    """θ̇, φ̇, ψ̇, ṗ_θ, ṗ_φ, ṗ_ψ of the symmetric top (6×1); the last two vanish."""
    rates = hamilton_equations(symmetric_hamiltonian(), ANGLES, CONJUGATE)
    return ImmutableMatrix(rates.applyfunc(sympy.factor_terms))


@cache
def accelerations_in_euler_angles() -> ImmutableMatrix:
    """θ̈, φ̈, ψ̈ of any heavy body (3×1, rad/s²); singular where sin θ = 0."""
    return ImmutableMatrix(accelerations(lagrangian(), ANGLES, RATES))


@cache
def angular_momentum_from_conjugate() -> ImmutableMatrix:
    """L₁, L₂, L₃ of any body from the angles and p_θ, p_φ, p_ψ (3×1, J s).

    ω = B q̇, so p = ∂T/∂q̇ = Bᵀ L.

    >>> angular_momentum_from_conjugate()[1]
    p_theta*cos(psi) - (-p_phi + p_psi*cos(theta))*sin(psi)/sin(theta)
    """
    B = euler_omega("body").jacobian(RATES)
    solved = (B.T.inv() * Matrix(CONJUGATE)).applyfunc(reduce_ratio)
    parts = (sympy.expand(entry).as_independent(s.p_theta, as_Add=True) for entry in solved)
    return ImmutableMatrix([sympy.factor(rest) + sympy.factor(part) for rest, part in parts])


@cache
def body_hamiltonian() -> Expr:
    """Σ Lₖ²/(2λₖ) + V of any heavy body, in angles and conjugate momenta (J).

    This is its Lagrangian's Legendre transform, of which it keeps the squares.
    """
    momentum = angular_momentum_from_conjugate()
    kinetic = sum(Lk**2 / (2 * moment) for Lk, moment in zip(momentum, MOMENTS, strict=True))
    return kinetic + potential_energy()


@cache
def body_hamilton_equations() -> ImmutableMatrix:
    """θ̇, φ̇, ψ̇, ṗ_θ, ṗ_φ, ṗ_ψ of any heavy body (6×1); ṗ_φ vanishes."""
    rates = hamilton_equations(body_hamiltonian(), ANGLES, CONJUGATE)
    return ImmutableMatrix(rates.applyfunc(sympy.factor_terms))


def gravity_torque(vertical: Matrix) -> Matrix:
    """R_CM × (−Mg ẑ) in body components (3×1, N m); `vertical` is ẑ in body components."""
    return Matrix(CENTRE_OF_MASS).cross(-s.M * s.g * vertical)


@cache
def heavy_body_rates() -> ImmutableMatrix:
    """(q̇₀ … q̇₃, ω̇₁, ω̇₂, ω̇₃) of a heavy body about a fixed pivot (7×1).

    Attitude as unit quaternion, ω in body components: polynomial, without a coordinate
    singularity, for any three moments and a centre of mass anywhere in the body.
    """
    q = Matrix(QUATERNION)
    vertical = quaternion_matrix(q).T * Z_AXIS
    rates = quaternion_rates(q, Matrix(OMEGA))
    return ImmutableMatrix([*rates, *body_accelerations_with(gravity_torque(vertical))])


@cache
def damped_body_rates() -> ImmutableMatrix:
    """The same with friction at the pivot, which turns against ω with −cω, and what it takes (8×1).

    The last is the rate cω² at which it takes energy (W).
    """
    omega = Matrix(OMEGA)
    damping = [0] * 4 + [friction * w / m for w, m in zip(omega, MOMENTS, strict=True)]
    return ImmutableMatrix([*heavy_body_rates() - Matrix(damping), friction * omega.dot(omega)])


def body_accelerations_with(torque: Matrix) -> Matrix:
    """ω̇ with the torque kept as a product of factors, so that it stays small."""
    free = body_accelerations()
    return Matrix([a + n / m for a, n, m in zip(free, torque, MOMENTS, strict=True)])


@cache
def steady_balance() -> Expr:
    """The θ equation of a steady precession: minus d/dt ∂L/∂θ̇ − ∂L/∂θ at θ̈ = θ̇ = 0 (N m).

    φ̇ = Ω and ψ̇ = ω₃ − Ω cos θ are put in; sin θ is still a factor.
    """
    steady = {
        s.thetaddot: 0,
        s.thetadot: 0,
        s.phidot: s.Omega,
        s.psidot: s.omega3 - s.Omega * cos(s.theta),
    }
    return sympy.factor(reduce_trig(-symmetric_equations()[0].subs(steady)))


@cache
def steady_quadratic() -> Expr:
    """(λ₁ cos θ)Ω² − (λ₃ω₃)Ω + MgR: the balance over sin θ (3.57), which loses sin θ = 0."""
    return sympy.collect(sympy.expand(sympy.cancel(steady_balance() / sin(s.theta))), s.Omega)


@cache
def discriminant() -> Expr:
    """(λ₃ω₃)² − 4λ₁MgR cos θ: steady precession needs it not negative (J² s²)."""
    return sympy.discriminant(steady_quadratic(), s.Omega)


def steady_roots() -> tuple[Expr, Expr]:
    """(Ω₋, Ω₊) for ω₃ > 0, written so that neither cancels for large ω₃ (rad/s).

    Ω₋ = 2MgR/(λ₃ω₃ + √D) is regular at cos θ = 0; Ω₊ = (λ₃ω₃ + √D)/(2λ₁ cos θ) is not: there the
    quadratic has one root only.  For ω₃ < 0 the two change places, so that Ω₋ is the fast
    one, and λ₃ω₃ + √D cancels: the slow and the fast rate are there minus those at −ω₃.
    """
    quadratic = sympy.Poly(steady_quadratic(), s.Omega)
    a, b, c = quadratic.all_coeffs()
    larger = -b + sympy.sqrt(discriminant())
    return 2 * c / larger, larger / (2 * a)


def steady_roots_by_smallness() -> tuple[Expr, Expr]:
    """(Ω₋, Ω₊) for ω₃ of either sign, with √D = λ₃|ω₃|√(1 − 4ε) (rad/s).

    In Ω₋ what is small for ω₃ > 0 stands alone: |ω₃|(1 − √(1 − 4ε)) is 4ε|ω₃|/(1 + √(1 − 4ε)).
    """
    a, b, c = sympy.Poly(steady_quadratic(), s.Omega).all_coeffs()
    size, root = abs(b), sympy.sqrt(1 - 4 * s.epsilon)
    return 2 * c / (size * (1 + root)) - (b + size) / (2 * a), (size * root - b) / (2 * a)


def smallness() -> Expr:
    """ε = λ₁MgR cos θ/(λ₃ω₃)², the one number on which both roots depend: D = (λ₃ω₃)²(1 − 4ε)."""
    a, b, c = sympy.Poly(steady_quadratic(), s.Omega).all_coeffs()
    return a * c / b**2


def leading_roots() -> tuple[Expr, Expr]:
    """The slow and the fast rate for ε → 0, MgR/(λ₃ω₃) and λ₃ω₃/(λ₁ cos θ), of either sign (rad/s).

    For ω₃ > 0 these are Ω₋ and Ω₊, for ω₃ < 0 Ω₊ and Ω₋.
    """
    a, b, c = sympy.Poly(steady_quadratic(), s.Omega).all_coeffs()
    return -c / b, -b / a


def root_factors() -> tuple[Expr, Expr]:
    """The rates over those of `leading_roots`: 2/(1 + √(1 − 4ε)) and (1 + √(1 − 4ε))/2."""
    larger = 1 + sympy.sqrt(1 - 4 * s.epsilon)
    return 2 / larger, larger / 2


@cache
def steady_expansions(order: int = 2) -> tuple[Expr, Expr]:
    """The slow and the fast rate for large |ω₃|: power series in ε, `order` terms each (rad/s).

    >>> slow, fast = steady_expansions(1)
    >>> slow, fast
    (M*R*g/(lambda3*omega3), lambda3*omega3/(lambda1*cos(theta)))
    """

    def expanded(lead: Expr, factor: Expr) -> Expr:
        slopes = (factor.diff(s.epsilon, n).subs(s.epsilon, 0) for n in range(order))
        powers = (k * smallness() ** n / sympy.factorial(n) for n, k in enumerate(slopes))
        return sum(sympy.cancel(lead * power) for power in powers)

    slow, fast = map(expanded, leading_roots(), root_factors())
    return slow, fast
