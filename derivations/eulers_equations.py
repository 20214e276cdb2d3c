"""Section 3.2.2: Euler's equations."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Eq, Expr, Ge, Le, Matrix, Ne, S

from rigidtop.codegen import shipped
from rigidtop.proof.equation import BODY, SPACE, Cross, Dot, Equation, Group, Rate, as_printed
from rigidtop.proof.page import Assumption, Check, Evidence, Page, Remark, Step, claim
from rigidtop.theory import euler, gyrostat, top
from rigidtop.theory.euler import (
    OMEGA,
    along_flow,
    angular_momentum,
    axis_growth,
    body_accelerations,
    kinetic_energy,
)
from rigidtop.theory.lagrangian import euler_lagrange
from rigidtop.theory.rotation import (
    EULER_RATES,
    Z_AXIS,
    euler_matrix,
    euler_omega,
    quaternion_matrix,
    total_derivative,
)
from rigidtop.theory.symbols import (
    L1,
    L2,
    N1,
    N2,
    N3,
    L_vec,
    L_x,
    L_y,
    L_z,
    T,
    Tdot,
    ball,
    const,
    damping,
    lambda1,
    lambda2,
    lambda3,
    omega1,
    omega1dot,
    omega2,
    omega2dot,
    omega3,
    omega3dot,
    omega_vec,
    psiddot,
    sigma2,
    zeta_vec,
)
from rigidtop.theory.symbols import L as L_magnitude  # noqa: N811

from . import evidence


@claim("3.35", "The rate of L in space is its rate in the body plus ω × L, and vanishes.")
def transport() -> Iterator[Evidence]:
    """The transport theorem (2.87): differentiate L′ = RᵀL and read ω off RᵀṘ."""
    with as_printed():
        printed = Equation(
            0,
            Rate(L_vec, SPACE),
            Rate(L_vec, BODY) + Cross(omega_vec, L_vec),
            tag="3.35",
        )
    attitude = euler_matrix()
    space = Matrix([L_x, L_y, L_z])
    body = attitude.T * space
    # A torque N₃ along ẑ stands for any; (3.33) says that it is not there.
    rates = {**EULER_RATES, L_z: N3}
    yield Check(
        printed,
        {
            L_vec: body,
            omega_vec: euler_omega("body"),
            printed.sides[1]: attitude.T * total_derivative(space, rates),
            Rate(L_vec, BODY): total_derivative(body, rates),
        },
        (Assumption(Eq(N3, 0), "no external torque (3.33)", stated=True),),
    )


def lagrange_third(potential: Expr) -> dict:
    """ω₃ and its rate in Euler angles, ψ̈ taken from Lagrange's equation for ψ."""
    lagrangian = top.kinetic_energy() - potential
    for_psi = euler_lagrange(lagrangian, top.ANGLES, top.RATES, top.ACCELERATIONS)[2]
    solution = -for_psi.subs(psiddot, 0) / for_psi.diff(psiddot)
    omega = euler_omega("body")
    rate = total_derivative(omega[2], EULER_RATES).subs(psiddot, solution)
    return {omega1: omega[0], omega2: omega[1], omega3: omega[2], omega3dot: rate}


@claim("3.36", "Euler's equations for the case of no external torque.")
def euler_equations() -> Iterator[Evidence]:
    """Lₖ = λₖωₖ put into (3.35), component by component."""
    with as_printed():
        first = Equation(lambda1 * omega1dot, Group(lambda2 - lambda3) * omega2 * omega3)
        second = Equation(lambda2 * omega2dot, Group(lambda3 - lambda1) * omega3 * omega1)
        third = Equation(
            lambda3 * omega3dot, Group(lambda1 - lambda2) * omega1 * omega2, tag="3.36"
        )
    yield Step(
        Equation(Cross(omega_vec, L_vec), Matrix(OMEGA).cross(angular_momentum())),
        "In body components, with Lₖ = λₖωₖ.",
    )
    rates = dict(zip((omega1dot, omega2dot, omega3dot), body_accelerations(), strict=True))
    for line in (first, second, third):
        yield Check(line, rates)
    ours = dict(zip((omega1dot, omega2dot, omega3dot), shipped.symbolic("free_body"), strict=True))
    for line in (first, second, third):
        yield Check(line, ours, reason="What rigidtop integrates.", printed=False)
    yield Check(
        third,
        lagrange_third(S.Zero),
        reason="Lagrange's equation for ψ says the same, without (3.35); the other two follow by "
        "renaming the axes in turn.",
        printed=False,
    )


@claim("euler-with-torque", "There is a more complete version with external torque.")
def with_torque() -> Iterator[Evidence]:
    """(3.35) with N in place of 0; N has to be resolved along the body axes.

    For gravity that is not cumbersome: ẑ in body components obeys γ̇ = γ × ω.
    """
    with as_printed():
        first = Equation(lambda1 * omega1dot, Group(lambda2 - lambda3) * omega2 * omega3 + N1)
        second = Equation(lambda2 * omega2dot, Group(lambda3 - lambda1) * omega3 * omega1 + N2)
        third = Equation(lambda3 * omega3dot, Group(lambda1 - lambda2) * omega1 * omega2 + N3)
    torque = Matrix([N1, N2, N3])
    rates = dict(zip((omega1dot, omega2dot, omega3dot), body_accelerations(torque), strict=True))
    for line in (first, second, third):
        yield Check(line, rates, printed=False)
    vertical = euler_matrix().T * Z_AXIS
    yield Check(
        third,
        {**lagrange_third(top.potential_energy()), N3: top.gravity_torque(vertical)[2]},
        reason="Lagrange's equation for ψ of a heavy body, its centre of mass anywhere, agrees.",
        printed=False,
    )
    ours = shipped.symbolic("heavy_body")[4:]
    weight = top.gravity_torque(quaternion_matrix(Matrix(top.QUATERNION)).T * Z_AXIS)
    meaning = {
        **dict(zip((omega1dot, omega2dot, omega3dot), ours, strict=True)),
        **dict(zip((N1, N2, N3), weight, strict=True)),
    }
    for line in (first, second, third):
        yield Check(
            line,
            meaning,
            reason="What rigidtop integrates, the attitude a unit quaternion.",
            printed=False,
        )


def right_sides() -> tuple[Equation, ...]:
    """What (3.36) says of each rate."""
    with as_printed():
        return (
            Equation(omega1dot, Group(lambda2 - lambda3) / lambda1 * omega2 * omega3),
            Equation(omega2dot, Group(lambda3 - lambda1) / lambda2 * omega3 * omega1),
            Equation(omega3dot, Group(lambda1 - lambda2) / lambda3 * omega1 * omega2),
        )


@claim("principal-stays", "ω along a principal axis stays constant.")
def principal_stays() -> Iterator[Evidence]:
    """Two of the three ωₖ vanish, so every product on the right of (3.36) does."""
    with as_printed():
        constant = Equation(Matrix([omega1dot, omega2dot, omega3dot]), Matrix([0, 0, 0]))
    rates = dict(zip((omega1dot, omega2dot, omega3dot), body_accelerations(), strict=True))
    for line in right_sides():
        yield Check(line, rates, reason="A product of two components.", printed=False)
    for axis in range(3):
        others = [w for k, w in enumerate(OMEGA) if k != axis]
        yield Check(
            constant,
            rates,
            tuple(
                Assumption(Eq(w, 0), f"ω lies along e{'₁₂₃'[axis]}", stated=True) for w in others
            ),
            printed=False,
        )


@claim("off-axis-changes", "ω that is not along a principal axis must change.")
def off_axis() -> Iterator[Evidence]:
    """Two components of ω differ from zero, so one right side of (3.36) does.

    It does if the two moments that go with them differ. Of equal moments λ₁ = λ₂ every axis in the
    plane of e₁ and e₂ is a principal axis, and ω rests on it. Without naming axes: ω rests where
    ω × L = 0, that is along any eigenvector of I.
    """
    with as_printed():
        changes = Equation(
            Matrix([omega1dot, omega2dot, omega3dot]), Matrix([0, 0, 0]), relation="≠"
        )
    rates = dict(zip((omega1dot, omega2dot, omega3dot), body_accelerations(), strict=True))
    for line in right_sides():
        yield Check(line, rates, reason="A difference of two moments.", printed=False)
    yield Check(
        changes,
        rates,
        (
            Assumption(Ne(omega1, 0), "two components are not zero", stated=True),
            Assumption(Ne(omega2, 0), "two components are not zero", stated=True),
            Assumption(Ne(lambda1, lambda2), "the moments that go with these two differ"),
        ),
        "With the axes numbered so that the two are ω₁ and ω₂.",
        printed=False,
    )
    with as_printed():
        rests = Equation(
            Matrix([lambda1 * omega1dot, lambda2 * omega2dot, lambda3 * omega3dot]),
            Cross(L_vec, omega_vec),
        )
    yield Remark(
        rests,
        {**rates, L_vec: angular_momentum(), omega_vec: Matrix(OMEGA)},
        reason="Without naming axes: ω rests only where L ∥ ω, along an eigenvector of I.",
        printed=False,
    )


@claim(
    "axis-stability",
    "Rotation is stable about the axes of largest and smallest moment and unstable otherwise.",
)
def axis_stability() -> Iterator[Evidence]:
    """(3.36) linearised about ω = ω₃e₃: a deviation grows as exp(σt) with the σ² below.

    Beyond the linear order 2λ₃T − L² is conserved and, about an extreme axis, a definite square of
    the deviation: that is stability for all times, if nothing inside takes energy; friction inside
    leads from the axis of the smallest moment to that of the largest. Equal moments are not
    covered: with λ₁ = λ₂ ≠ λ₃ the axis e₁ has an extreme moment and is left all the same, and with
    three every axis stays and none is returned to.
    """
    with as_printed():
        growth = Equation(
            sigma2,
            -(Group(lambda3 - lambda1) * Group(lambda3 - lambda2) * omega3**2)
            / (lambda1 * lambda2),
        )
        stable = Equation(sigma2, 0, relation="<")
        unstable = Equation(sigma2, 0, relation=">")
        integral = Equation(
            2 * lambda3 * T - L_magnitude**2,
            lambda1 * Group(lambda3 - lambda1) * omega1**2
            + lambda2 * Group(lambda3 - lambda2) * omega2**2,
        )
        energy = Equation(T, const)
        momentum = Equation(L_magnitude**2, const)
        spins_on = Equation(Matrix([omega1dot, omega2dot, omega3dot]), Matrix([0, 0, 0]))
        turning = [
            Group(1 - ball / moment) * relative**2
            for moment, relative in zip(euler.MOMENTS, gyrostat.RELATIVE, strict=True)
        ]
        with_ball = Equation(
            2 * lambda3 * T - L_magnitude**2,
            Group(lambda3 - lambda1) / lambda1 * L1**2
            + Group(lambda3 - lambda2) / lambda2 * L2**2
            + ball * lambda3 * Group(turning[0] + turning[1] + turning[2]),
        )
        falls = Equation(Tdot, -damping * Dot(zeta_vec, zeta_vec))
    meaning = {
        sigma2: axis_growth(3),
        T: kinetic_energy(),
        L_magnitude: (angular_momentum().dot(angular_momentum())) ** S.Half,
        const: along_flow,
    }
    yield Check(growth, {sigma2: axis_growth(3)}, printed=False)
    spins = Assumption(Ne(omega3, 0), "the body rotates", stated=True)
    differs = "no other moment equals that of the axis"
    unequal = (
        Assumption(Ne(lambda3, lambda1), differs),
        Assumption(Ne(lambda3, lambda2), differs),
    )

    def ordered(words: str, *conditions: Expr) -> tuple[Assumption, ...]:
        return tuple(Assumption(condition, words, stated=True) for condition in conditions)

    largest = ordered("λ₃ is the largest moment", Ge(lambda3, lambda1), Ge(lambda3, lambda2))
    smallest = ordered("λ₃ is the smallest moment", Le(lambda3, lambda1), Le(lambda3, lambda2))
    between = ordered("λ₃ is the middle moment", Ge(lambda3, lambda1), Le(lambda3, lambda2))
    extreme = (*unequal, spins)
    yield Check(stable, meaning, (*largest, *extreme), "Largest moment.", printed=False)
    yield Check(stable, meaning, (*smallest, *extreme), "Smallest moment.", printed=False)
    yield Check(unstable, meaning, (*between, *extreme), "The moment between.", printed=False)
    yield Check(momentum, meaning, reason="Conserved along (3.36).", printed=False)
    yield Check(integral, meaning, reason="A definite form if λ₃ is extreme.", printed=False)
    whole = gyrostat.angular_momentum()
    inside = {
        T: gyrostat.kinetic_energy(),
        const: gyrostat.along_flow,
        Tdot: gyrostat.along_flow(gyrostat.kinetic_energy()),
        L_magnitude: whole.dot(whole) ** S.Half,
        L1: whole[0],
        L2: whole[1],
        zeta_vec: Matrix(gyrostat.RELATIVE),
    }
    yield Check(
        energy,
        inside,
        (Assumption(Eq(damping, 0), "no friction inside takes energy"),),
        "Conserved, also with a ball inside that turns in the body, if no oil brakes it.",
        printed=False,
    )
    yield Remark(momentum, inside, reason="With friction L is kept all the same,", printed=False)
    yield Remark(
        with_ball, inside, reason="but this, the form above with the ball in it,", printed=False
    )
    yield Remark(
        falls,
        inside,
        reason="falls as T does: about the largest moment to zero, but about the smallest, where "
        "it is negative with the ball at rest, ever further from zero.",
        printed=False,
    )
    yield Remark(
        spins_on,
        dict(zip((omega1dot, omega2dot, omega3dot), body_accelerations(), strict=True)),
        tuple(
            Assumption(Eq(moment, lambda1), "three equal moments") for moment in (lambda2, lambda3)
        ),
        "With three equal moments no ω is left, and none returned to.",
        printed=False,
    )
    yield from evidence.axis_rates()
    yield from evidence.axis_with_friction()


page = Page(
    "3.2.2",
    "Euler's equations",
    "The rate of change of ω in the frame of the principal axes.",
    (
        transport,
        euler_equations,
        with_torque,
        principal_stays,
        off_axis,
        axis_stability,
    ),
    text="eulers_equations",
)
