"""Section 3.2.3: precession of the rotation axis."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sympy import (
    Eq,
    Expr,
    Gt,
    Matrix,
    Ne,
    Rational,
    cos,
    diag,
    periodicity,
    pi,
    sin,
    symbols,
)

from rigidtop.proof.equation import (
    BODY,
    SPACE,
    Cross,
    Dot,
    Equation,
    Group,
    Rate,
    SumOver,
    Underbrace,
    as_printed,
)
from rigidtop.proof.page import Assumption, Check, Correction, Evidence, Page, claim
from rigidtop.theory import gyrostat
from rigidtop.theory.euler import (
    OMEGA,
    along_flow,
    angular_momentum,
    body_accelerations,
    kinetic_energy,
)
from rigidtop.theory.rotation import X_AXIS, Z_AXIS, rotation_z, total_derivative
from rigidtop.theory.symbols import (
    F_1,
    L1,
    L2,
    L3,
    M_1,
    M_2,
    R_CM,
    F_k,
    L,
    L_vec,
    Omega_b,
    Omega_s,
    T,
    Tdot,
    const,
    damping,
    delta,
    e3,
    e3dot,
    follower,
    g,
    kappa,
    lambda1,
    lambda2,
    lambda3,
    omega1,
    omega1ddot,
    omega1dot,
    omega2,
    omega2ddot,
    omega2dot,
    omega3,
    omega3dot,
    omega_0,
    omega_20,
    omega_vec,
    phi,
    r_k,
    t,
    tau_b,
    zeta_vec,
)

from . import evidence, toutatis

SYMMETRIC = Assumption(Eq(lambda2, lambda1), "two equal moments", stated=True)
START = Assumption(
    Eq(omega_20, 0),
    "e₁, which is free to choose when λ₁ = λ₂, points along the part of ω across e₃ at t = 0",
)
FROM_START = replace(START, stated=True)  # (3.38) is given there
RATES = dict(zip((omega1dot, omega2dot, omega3dot), body_accelerations(), strict=True))


def body_frequency() -> Expr:
    """Ω_b as the engine finds it: the coefficient of ω₂ in ω̇₁ for λ₂ = λ₁ (rad/s)."""
    return body_accelerations()[0].subs(lambda2, lambda1).coeff(omega2)


def body_cone() -> Matrix:
    """The solution of (3.37) from ω₀, ω₂,₀, ω₃ at t = 0: a turn about e₃ by −Ω_b t (3×1, rad/s)."""
    return rotation_z(-Omega_b * t) * Matrix([omega_0, omega_20, omega3])


@claim("3.37", "ω̇₁ = Ω_b ω₂, ω̇₂ = −Ω_b ω₁, and ω₃ is constant.")
def oscillating_pair() -> Iterator[Evidence]:
    """λ₂ = λ₁ in (3.36): the third equation has no right side left, and ω₃ is a number."""
    with as_printed():
        coefficient = Group(lambda1 - lambda3) * omega3 / lambda1
        first = Equation(omega1dot, Underbrace(coefficient, Omega_b) * omega2, Omega_b * omega2)
        second = Equation(omega2dot, -coefficient * omega1, -Omega_b * omega1, tag="3.37")
        third = Equation(omega3dot, 0)
    meaning = {**RATES, Omega_b: body_frequency()}
    yield Check(third, RATES, (SYMMETRIC,), "From the third equation.", printed=False)
    yield Check(first, meaning, (SYMMETRIC,))
    yield Check(second, meaning, (SYMMETRIC,))


@claim("omega-oscillator", "ω₁ and ω₂ obey the equation of an oscillator with frequency Ω_b.")
def oscillator() -> Iterator[Evidence]:
    """One of (3.37) differentiated in time, the other inserted."""
    with as_printed():
        first = Equation(omega1ddot, -(Omega_b**2) * omega1)
        second = Equation(omega2ddot, -(Omega_b**2) * omega2)
    meaning = {
        omega1ddot: along_flow(along_flow(omega1)),
        omega2ddot: along_flow(along_flow(omega2)),
        Omega_b: body_frequency(),
    }
    yield Check(first, meaning, (SYMMETRIC,))
    yield Check(second, meaning, (SYMMETRIC,))


@claim("3.38", "In the body frame ω turns on the body cone.")
def omega_on_body_cone() -> Iterator[Evidence]:
    """(3.37) is a turn about e₃ by −Ω_b t; the printed solution starts it at ω₂ = 0."""
    with as_printed():
        printed = Equation(
            omega_vec,
            Matrix([omega_0 * cos(Omega_b * t), -(omega_0 * sin(Omega_b * t)), omega3]),
            tag="3.38",
        )
        first = Equation(omega1dot, Omega_b * omega2)
        second = Equation(omega2dot, -Omega_b * omega1)
    solution = body_cone()
    meaning = {
        omega1: solution[0],
        omega2: solution[1],
        omega1dot: solution[0].diff(t),
        omega2dot: solution[1].diff(t),
    }
    yield Check(first, meaning, reason="The turn solves (3.37),", printed=False)
    yield Check(second, meaning, reason="both lines, from any start.", printed=False)
    yield Check(printed, {omega_vec: solution}, (START,))
    yield from evidence.body_cone()


@claim("3.39", "In the body frame L turns on a cone of its own.")
def momentum_on_body_cone() -> Iterator[Evidence]:
    """Lₖ = λₖωₖ applied to (3.38)."""
    with as_printed():
        printed = Equation(
            L_vec,
            Matrix(
                [
                    lambda1 * omega_0 * cos(Omega_b * t),
                    -(lambda1 * omega_0 * sin(Omega_b * t)),
                    lambda3 * omega3,
                ]
            ),
            tag="3.39",
        )
    momentum = diag(lambda1, lambda2, lambda3) * body_cone()
    yield Check(printed, {L_vec: momentum}, (SYMMETRIC, START))


@claim("3.40", "The frequency Ω_b of the precession in the body, and its period τ_b = 2π/Ω_b.")
def body_precession() -> Iterator[Evidence]:
    """Ω_b from (3.37); ω(t) has the period of cos Ω_b t, which is 2π/|Ω_b|.

    For an oblate body (λ₃ > λ₁) with ω₃ > 0, and a prolate one with ω₃ < 0, Ω_b is negative: ω
    turns the other way, and the period is 2π/|Ω_b|. For λ₁ = λ₃ nothing turns.
    """
    with as_printed():
        printed = Equation(Omega_b, Group(lambda1 - lambda3) * omega3 / lambda1, tag="3.40")
        period = Equation(tau_b, 2 * pi / Omega_b)
    yield Check(printed, {Omega_b: body_frequency()})
    yield Check(
        period,
        {tau_b: periodicity(cos(Omega_b * t), t)},
        (
            Assumption(
                Gt(Omega_b, 0),
                "(λ₁ − λ₃)ω₃ > 0: a prolate body with ω₃ > 0, or an oblate one with ω₃ < 0",
            ),
        ),
    )


@claim("constant-angle", "The angle between ω and L is constant.")
def constant_angle() -> Iterator[Evidence]:
    """ω·L = 2T and |L| are constant for every body; |ω| is too when λ₁ = λ₂."""
    with as_printed():
        product = Equation(Dot(omega_vec, L_vec), 2 * T)
        conserved = Equation(T, const)
        on_cone = Equation(Dot(omega_vec, L_vec), lambda1 * omega_0**2 + lambda3 * omega3**2)
        sizes = (
            Equation(Dot(omega_vec, omega_vec), omega_0**2 + omega3**2),
            Equation(Dot(L_vec, L_vec), lambda1**2 * omega_0**2 + lambda3**2 * omega3**2),
        )
    meaning = {
        omega_vec: Matrix(OMEGA),
        L_vec: angular_momentum(),
        T: kinetic_energy(),
        const: along_flow,
    }
    yield Check(product, meaning, reason="For every body.", printed=False)
    yield Check(conserved, meaning, reason="For every body.", printed=False)
    solution = body_cone()
    on_body_cone = {omega_vec: solution, L_vec: diag(lambda1, lambda2, lambda3) * solution}
    yield Check(
        on_cone,
        on_body_cone,
        (SYMMETRIC, FROM_START),
        "The scalar product of (3.38) and (3.39): no t is left,",
        printed=False,
    )
    yield Check(sizes[0], on_body_cone, (FROM_START,), "nor in the square of |ω|,", printed=False)
    yield Check(
        sizes[1], on_body_cone, (SYMMETRIC, FROM_START), "nor in that of |L|.", printed=False
    )


@claim("coplanar", "e₃, ω and L remain in one plane, because the angle of ω and L is constant.")
def coplanar() -> Iterator[Evidence]:
    """They do, since L = λ₁ω + (λ₃ − λ₁)ω₃e₃; but the reason given does not show it.

    Two vectors that turn about e₃ together, one behind the other, keep their angle and span no
    plane with e₃. That is a counterexample to the inference, not a body. It takes all three angles
    and one time at which the plane is there, as (3.38) and (3.39) have it at t = 0.
    """
    with as_printed():
        plane = Equation(Dot(e3, Cross(omega_vec, L_vec)), 0)
        combination = Equation(L_vec, lambda1 * omega_vec + Group(lambda3 - lambda1) * omega3 * e3)
    axis = Matrix(Z_AXIS)
    meaning = {e3: axis, omega_vec: Matrix(OMEGA), L_vec: angular_momentum()}
    yield Check(combination, meaning, (SYMMETRIC,), printed=False)
    yield Check(plane, meaning, (SYMMETRIC,), "So the three are in one plane.", printed=False)
    behind = {
        e3: axis,
        omega_vec: Matrix([omega_0 * cos(phi), -omega_0 * sin(phi), omega3]),
        follower: Matrix([L1 * cos(phi + delta), -L1 * sin(phi + delta), L3]),
    }
    with as_printed():
        same_angle = Equation(Dot(omega_vec, follower), const)
        same_plane = Equation(Dot(e3, Cross(omega_vec, follower)), 0)
        angles_decide = Equation(
            Dot(e3, Cross(omega_vec, L_vec)) ** 2,
            Group(Dot(omega_vec, omega_vec)) * Group(Dot(L_vec, L_vec))
            + 2 * Group(Dot(omega_vec, L_vec)) * Group(Dot(e3, omega_vec)) * Group(Dot(e3, L_vec))
            - Group(Dot(omega_vec, L_vec)) ** 2
            - Group(Dot(omega_vec, omega_vec)) * Group(Dot(e3, L_vec)) ** 2
            - Group(Dot(L_vec, L_vec)) * Group(Dot(e3, omega_vec)) ** 2,
        )
    yield Check(
        same_angle,
        {**behind, const: lambda product: product.diff(phi)},
        reason="But ω and any vector w that follows it by δ keep their angle as φ grows,",
        printed=False,
    )
    yield Check(same_plane, behind, reason="yet they are not in one plane with e₃.", printed=False)
    yield Correction(
        angles_decide,
        {
            e3: axis,
            omega_vec: Matrix(OMEGA),
            L_vec: Matrix(symbols("l_1 l_2 l_3", real=True)),
        },
        reason="The three angles and the lengths decide how far the three are from one plane: with "
        "all of them constant, what is in one plane once stays so.",
        printed=False,
    )


@claim("same-frequency", "L precesses about e₃ as fast as ω, at another angle.")
def same_frequency() -> Iterator[Evidence]:
    """The parts of L and ω across e₃ are parallel; the slopes against e₃ differ by λ₁/λ₃."""
    momentum = angular_momentum()
    with as_printed():
        parallel = Equation(L1 * omega2, L2 * omega1)
        slopes = Equation(L1 * omega3, L3 * omega1, relation="≠")
    meaning = {L1: momentum[0], L2: momentum[1], L3: momentum[2]}
    yield Check(parallel, meaning, (SYMMETRIC,), "The same azimuth about e₃.", printed=False)
    yield Check(
        slopes,
        meaning,
        (
            Assumption(Ne(omega1, 0), "ω is not along e₃", stated=True),
            Assumption(Ne(omega3, 0), "ω is not across e₃ either"),
            Assumption(Ne(lambda1, lambda3), "the third moment is another"),
        ),
        "Another polar angle from e₃.",
        printed=False,
    )


@claim("space-cone", "In the space frame the plane of e₃ and ω turns about L at Ω_s = L/λ₁.")
def space_cone() -> Iterator[Evidence]:
    """ω = L/λ₁ + (1 − λ₃/λ₁)ω₃e₃, and the second part does not move e₃.

    This is the proof that the notes leave out: e₃ and ω both turn with the constant vector L/λ₁. If
    ω is along e₃ so is L, and there is neither a plane nor a cone.
    """
    with as_printed():
        axis = Equation(e3dot, Cross(L_vec / lambda1, e3))
        omega_rate = Equation(Rate(omega_vec, SPACE), Cross(L_vec / lambda1, omega_vec))
        speed = L**2 * Dot(e3dot, e3dot) / Dot(Cross(L_vec, e3), Cross(L_vec, e3))
        rate = Equation(Omega_s**2, speed, Group(L / lambda1) ** 2)
    momentum = angular_momentum()
    meaning = {
        e3: Matrix(Z_AXIS),
        e3dot: Matrix(OMEGA).cross(Matrix(Z_AXIS)),
        L_vec: momentum,
        omega_vec: Matrix(OMEGA),
        omega_rate.sides[0]: body_accelerations(),
    }
    yield Check(axis, meaning, (SYMMETRIC,), "e₃ is carried along by ω × e₃.", printed=False)
    yield Check(
        omega_rate,
        meaning,
        (SYMMETRIC,),
        "The rate of ω is the same in both frames, since ω × ω = 0.",
        printed=False,
    )
    # Of a vector v that turns about L: L·(v × v̇)/L is Ω_s times the square of its distance.
    across = momentum.cross(Matrix(Z_AXIS))
    size = momentum.dot(momentum) ** Rational(1, 2)
    azimuth = momentum.dot(Matrix(Z_AXIS).cross(meaning[e3dot])) * size / across.dot(across)
    yield Check(
        rate,
        {**meaning, Omega_s: azimuth, L: size},
        (
            SYMMETRIC,
            Assumption(
                Ne(omega1**2 + omega2**2, 0),
                "ω is not along e₃: else there is no plane, and e₃ rests",
                stated=True,
            ),
        ),
        "Squared, the speed of e₃ over its distance from the axis L.",
        printed=False,
    )
    yield from evidence.space_cone()


@claim("free-fall", "In free fall there is no external torque about the centre of mass.")
def free_fall() -> Iterator[Evidence]:
    """Σ m(r − R_CM) × g = 0 when gravity is the same for all particles.

    So gravity does not turn a body about its centre of mass on the ground either: there the support
    does, and in free fall there is none. A field that varies across the body (κ, the tide) does,
    and so does the air, which pushes one part more than another (F₁).
    """
    positions = [Matrix(symbols(f"x{k} y{k} z{k}", real=True)) for k in (1, 2)]
    masses = (M_1, M_2)
    centre = (M_1 * positions[0] + M_2 * positions[1]) / (M_1 + M_2)
    with as_printed():
        torque = Equation(SumOver(symbols("k"), Cross(r_k - R_CM, F_k)), 0)
    tide = kappa * diag(-1, -1, 2)
    terms = [
        {r_k: r, F_k: m * (tide * r - g * Matrix(Z_AXIS)) + air * Matrix(X_AXIS)}
        for m, r, air in zip(masses, positions, (F_1, 0), strict=True)
    ]
    yield Check(
        torque,
        {symbols("k"): terms, R_CM: centre},
        (
            Assumption(Eq(kappa, 0), "gravity is uniform across the body"),
            Assumption(
                Eq(F_1, 0), "no air pushes one part more than another, here the first particle"
            ),
        ),
        printed=False,
    )


@claim(
    "example-33",
    "Toutatis has three different moments and does not rotate about a principal axis; most "
    "asteroids do.",
)
def example_33() -> Iterator[Evidence]:
    """At given L the energy is least about the axis of the largest moment.

    Friction inside the body lowers T and leaves L in space alone, so a body that loses energy ends
    there; Toutatis has not yet. A ball in oil inside stands for whatever rubs. (Moments and spin
    state: Takahashi, Busch & Scheeres 2013.)
    """
    observed = dict(zip((lambda1, lambda2, lambda3), toutatis.MOMENTS, strict=True))
    spin = Matrix(toutatis.OMEGA_1992)
    momentum = diag(*toutatis.MOMENTS) * spin
    changes = dict(zip(OMEGA, spin, strict=True))
    with as_printed():
        different = [
            Equation(x, y, relation="≠")
            for x, y in ((lambda1, lambda2), (lambda2, lambda3), (lambda3, lambda1))
        ]
        off_axis = Equation(Cross(omega_vec, L_vec), Matrix([0, 0, 0]), relation="≠")
        tumbling = Equation(
            Matrix([omega1dot, omega2dot, omega3dot]), Matrix([0, 0, 0]), relation="≠"
        )
        excess = Equation(
            T - L**2 / (2 * lambda3),
            (
                lambda1 * Group(lambda3 - lambda1) * omega1**2
                + lambda2 * Group(lambda3 - lambda2) * omega2**2
            )
            / (2 * lambda3),
        )
        least = Equation(T, L**2 / (2 * lambda3), relation=">")
        lost = Equation(Tdot, -damping * Dot(zeta_vec, zeta_vec))
        kept = Equation(Rate(L_vec, SPACE), Matrix([0, 0, 0]))
        dragged = Equation(Rate(zeta_vec, BODY), -Rate(omega_vec, BODY))
        falls = Equation(Tdot, 0, relation="<")
    for line in different:
        yield Check(line, observed, printed=False)
    yield Check(off_axis, {omega_vec: spin, L_vec: momentum}, printed=False)
    yield Check(
        tumbling,
        {w: rate.subs({**observed, **changes}) for w, rate in RATES.items()},
        printed=False,
    )
    squared = angular_momentum().dot(angular_momentum())
    meaning = {T: kinetic_energy(), L: squared ** Rational(1, 2)}
    yield Check(excess, meaning, reason="For any body,", printed=False)
    largest = "λ₃ is the largest moment"
    yield Check(
        least,
        meaning,
        (
            Assumption(Gt(lambda3, lambda1), largest, stated=True),
            Assumption(Gt(lambda3, lambda2), largest, stated=True),
            Assumption(Ne(omega1, 0), "the rotation is another than about e₃", stated=True),
        ),
        "so every other rotation with the same L has more energy.",
        printed=False,
    )
    whole, rates = gyrostat.angular_momentum(), gyrostat.rates()
    relative, turning = (
        Matrix([rates[x] for x in letters]) for letters in (gyrostat.RELATIVE, OMEGA)
    )
    at_rest = dict.fromkeys(gyrostat.RELATIVE, 0)
    yield Check(
        kept,
        {kept.sides[0]: total_derivative(whole, rates) + Matrix(OMEGA).cross(whole)},
        reason="A ball inside, whose rotation relative to the body is braked by oil, leaves the "
        "vector L in space as it is,",
        printed=False,
    )
    yield Check(
        lost,
        {
            Tdot: gyrostat.along_flow(gyrostat.kinetic_energy()),
            zeta_vec: Matrix(gyrostat.RELATIVE),
        },
        reason="and takes energy as long as it turns in the body;",
        printed=False,
    )
    yield Check(
        dragged,
        {dragged.sides[0]: relative.subs(at_rest), Rate(omega_vec, BODY): turning.subs(at_rest)},
        reason="which a ball at rest there does at once, unless ω is along a principal axis.",
        printed=False,
    )
    yield Check(
        falls,
        {Tdot: -damping * delta**2},
        (
            Assumption(Gt(damping, 0), "energy is lost inside the body"),
            Assumption(Ne(delta, 0), "ω is not along a principal axis", stated=True),
        ),
        "So T falls as long as δ, the rate of that, is not zero; without friction the tumbling "
        "lasts.",
        printed=False,
    )


page = Page(
    "3.2.3",
    "Precession of the rotation axis",
    "Two equal moments: ω, L and e₃ in the body frame and in space.",
    (
        oscillating_pair,
        oscillator,
        omega_on_body_cone,
        momentum_on_body_cone,
        body_precession,
        constant_angle,
        coplanar,
        same_frequency,
        space_cone,
        free_fall,
        example_33,
    ),
    text="precession_of_rotation_axis",
)
