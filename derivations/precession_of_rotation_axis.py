"""Section 3.2.3: precession of the rotation axis."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sympy import Eq, Expr, Gt, Matrix, Ne, Rational, cos, diag, pi, sin, symbols

from rigidtop.proof.page import Assumption, Check, Correction, Evidence, Formal, Page, claim
from rigidtop.theory import gyrostat
from rigidtop.theory import symbols as s
from rigidtop.theory.euler import (
    OMEGA,
    along_flow,
    angular_momentum,
    body_accelerations,
    kinetic_energy,
)
from rigidtop.theory.rotation import X_AXIS, Z_AXIS, rotation_z

from . import toutatis
from .printed import printed

SYMMETRIC = Assumption(Eq(s.lambda2, s.lambda1), "two equal moments", stated=True)
START = Assumption(
    Eq(s.omega_20, 0),
    r"$\mathbf e_1$, which may be chosen freely since $\lambda_1 = \lambda_2$, points along the "
    r"part of $\boldsymbol\omega$ across $\mathbf e_3$ at $t = 0$",
)
FROM_START = replace(START, stated=True)  # (3.38) is given there
RATES = dict(zip((s.omega1dot, s.omega2dot, s.omega3dot), body_accelerations(), strict=True))


def body_frequency() -> Expr:
    """Ω_b as the engine finds it: the coefficient of ω₂ in ω̇₁ for λ₂ = λ₁ (rad/s)."""
    return body_accelerations()[0].subs(s.lambda2, s.lambda1).coeff(s.omega2)


def body_cone() -> Matrix:
    """The solution of (3.37) from ω₀, ω₂,₀, ω₃ at t = 0: a turn about e₃ by −Ω_b t (3×1, rad/s)."""
    return rotation_z(-body_frequency() * s.t) * Matrix([s.omega_0, s.omega_20, s.omega3])


@claim("3.37", r"$\omega_1$ and $\omega_2$ drive each other, and $\omega_3$ is constant.")
def oscillating_pair() -> Iterator[Evidence]:
    r"""$\lambda_2 = \lambda_1$ in (3.36): the third equation has no right side left, and
    $\omega_3$ is a number."""
    meaning = {**RATES, s.Omega_b: body_frequency()}
    yield Formal(printed(r"\dot\omega_3 = 0"), RATES, (SYMMETRIC,))
    for line in printed.lines("3.37"):
        yield Check(line, meaning, (SYMMETRIC,))


@claim(
    "omega-oscillator",
    r"$\omega_1$ and $\omega_2$ obey the equation of an oscillator with frequency $\Omega_b$.",
)
def oscillator() -> Iterator[Evidence]:
    """One of (3.37) differentiated in time, the other inserted."""
    meaning = {
        s.omega1dot: along_flow(s.omega1),
        s.omega2dot: along_flow(s.omega2),
        s.omega1ddot: along_flow(along_flow(s.omega1)),
        s.omega2ddot: along_flow(along_flow(s.omega2)),
        s.Omega_b: body_frequency(),
    }
    for line in printed.lines("omega-oscillator"):
        yield Check(line, meaning, (SYMMETRIC,))


@claim("3.38", r"In the body frame $\boldsymbol\omega$ turns on the body cone.")
def omega_on_body_cone() -> Iterator[Evidence]:
    r"""(3.37) is a turn about $\mathbf e_3$ by $-\Omega_b t$; the printed solution starts it at
    $\omega_2 = 0$."""
    from . import evidence

    yield Check(printed("3.38"), {s.omega_vec: body_cone(), s.Omega_b: body_frequency()}, (START,))
    yield from evidence.body_cone()


@claim("3.39", r"In the body frame $\mathbf L$ turns on a cone of its own.")
def momentum_on_body_cone() -> Iterator[Evidence]:
    r"""$L_k = \lambda_k\omega_k$ applied to (3.38)."""
    momentum = diag(s.lambda1, s.lambda2, s.lambda3) * body_cone()
    yield Check(
        printed("3.39"), {s.L_vec: momentum, s.Omega_b: body_frequency()}, (SYMMETRIC, START)
    )


@claim(
    "3.40",
    r"The frequency $\Omega_b$ of the precession in the body, and its period $2\pi/\Omega_b$.",
)
def body_precession() -> Iterator[Evidence]:
    r"""$\Omega_b$ from (3.37); $\omega(t)$ has the period of $\cos\Omega_b t$, which is
    $2\pi/|\Omega_b|$.

    For an oblate body ($\lambda_3 > \lambda_1$) with $\omega_3 > 0$, and a prolate one with
    $\omega_3 < 0$, $\Omega_b$ is negative: $\omega$ turns the other way, and the period is
    $2\pi/|\Omega_b|$. For $\lambda_1 = \lambda_3$ nothing turns.
    """
    yield Check(printed("3.40"), {s.Omega_b: body_frequency()})
    yield Check(
        printed.lines("3.40")[2],
        {s.tau_b: 2 * pi / abs((s.Omega_b * s.t).diff(s.t))},
        (
            Assumption(
                Gt(s.Omega_b, 0),
                r"$(\lambda_1 - \lambda_3)\omega_3 > 0$: a long body with $\omega_3 > 0$, or a "
                r"flat one with $\omega_3 < 0$",
            ),
        ),
    )


@claim("constant-angle", r"The angle between $\boldsymbol\omega$ and $\mathbf L$ is constant.")
def constant_angle() -> Iterator[Evidence]:
    r"""$\boldsymbol\omega\cdot\mathbf L = 2T$ and $|L|$ are constant for every body; $|\omega|$
    is too when $\lambda_1 = \lambda_2$."""
    on_cone, *sizes, _ = printed.lines("constant-angle")
    solution = body_cone()
    on_body_cone = {
        s.omega_vec: solution,
        s.L_vec: diag(s.lambda1, s.lambda2, s.lambda3) * solution,
    }
    yield Formal(on_cone, on_body_cone, (SYMMETRIC, FROM_START))
    yield Formal(sizes[0], on_body_cone, (FROM_START,))
    yield Formal(sizes[1], on_body_cone, (SYMMETRIC, FROM_START))


@claim(
    "coplanar",
    r"It is because the angle of $\boldsymbol\omega$ and $\mathbf L$ is constant that "
    r"$\mathbf e_3$, $\boldsymbol\omega$ and $\mathbf L$ stay in one plane.",
)
def coplanar() -> Iterator[Evidence]:
    r"""They do, since $\mathbf L = \lambda_1\boldsymbol\omega + (\lambda_3 -
    \lambda_1)\omega_3\mathbf e_3$; but the reason given does not show it.

    Two vectors that turn about $\mathbf e_3$ together, one behind the other, keep their angle and
    span no plane with $\mathbf e_3$. That is a counterexample to the inference, not a body. It
    takes all three angles and one time at which the plane is there, as (3.38) and (3.39) have it at
    $t = 0$.
    """
    axis = Matrix(Z_AXIS)
    meaning = {s.e3: axis, s.omega_vec: Matrix(OMEGA), s.L_vec: angular_momentum()}
    yield Formal(printed.lines("coplanar")[0], meaning, (SYMMETRIC,))
    yield Formal(
        printed.lines("coplanar")[2], meaning, (SYMMETRIC,), "So the three are in one plane."
    )
    gone = s.Omega_b * s.t
    behind = {
        s.e3: axis,
        s.omega_vec: Matrix([s.omega_0 * cos(gone), -s.omega_0 * sin(gone), s.omega3]),
        s.follower: Matrix(
            [s.omega_0 * cos(gone - s.gamma), -s.omega_0 * sin(gone - s.gamma), s.omega3]
        ),
    }
    yield Formal(
        printed(r"\boldsymbol\omega\cdot\mathbf w = \text{const}"),
        {**behind, s.const: lambda product: product.diff(s.t)},
        reason=(
            r"But $\omega$ and a vector $\mathbf w$ that goes round with it, $\gamma$ apart, keep "
            "their angle,"
        ),
    )
    yield Formal(
        printed(r"\mathbf e_3\cdot(\boldsymbol\omega\times\mathbf w) = 0"),
        {vector: means.subs(s.t, 0) for vector, means in behind.items()},
        reason=r"yet they are not in one plane with $\mathbf e_3$.",
    )
    yield Correction(
        printed(
            r"(\mathbf e_3\cdot(\boldsymbol\omega\times\mathbf L))^2"
            r" = (\boldsymbol\omega\cdot\boldsymbol\omega)(\mathbf L\cdot\mathbf L)"
            r" + 2(\boldsymbol\omega\cdot\mathbf L)"
            r"(\mathbf e_3\cdot\boldsymbol\omega)(\mathbf e_3\cdot\mathbf L)"
            r" - (\boldsymbol\omega\cdot\mathbf L)^2"
            r" - (\boldsymbol\omega\cdot\boldsymbol\omega)(\mathbf e_3\cdot\mathbf L)^2"
            r" - (\mathbf L\cdot\mathbf L)(\mathbf e_3\cdot\boldsymbol\omega)^2"
        ),
        {
            s.e3: axis,
            s.omega_vec: Matrix(OMEGA),
            s.L_vec: Matrix(symbols("l_1 l_2 l_3", real=True)),
        },
        reason="The three angles and the lengths decide how far the three are from one plane: with "
        "all of them constant, what is in one plane once stays so.",
        printed=False,
    )


@claim(
    "same-frequency",
    r"$\mathbf L$ precesses about $\mathbf e_3$ as fast as $\boldsymbol\omega$, at another angle.",
)
def same_frequency() -> Iterator[Evidence]:
    r"""The parts of $\mathbf L$ and $\boldsymbol\omega$ across $\mathbf e_3$ are parallel; the
    slopes against $\mathbf e_3$ differ by $\lambda_1/\lambda_3$."""
    momentum = angular_momentum()
    meaning = {s.L1: momentum[0], s.L2: momentum[1]}
    yield Formal(printed.lines("same-frequency")[2], meaning, (SYMMETRIC,))
    yield Formal(
        printed.lines("same-frequency")[5],
        {s.omega_vec: Matrix(OMEGA), s.L_vec: momentum},
        (
            SYMMETRIC,
            Assumption(
                Ne(s.omega1**2 + s.omega2**2, 0), r"$\boldsymbol\omega$ is not along $\mathbf e_3$"
            ),
            Assumption(
                Ne(s.omega3, 0), r"$\boldsymbol\omega$ is not at right angles to $\mathbf e_3$"
            ),
            Assumption(Ne(s.lambda1, s.lambda3), "the third moment differs from the others"),
        ),
    )


@claim(
    "space-cone",
    r"In the space frame the plane of $\mathbf e_3$ and $\boldsymbol\omega$ turns about "
    r"$\mathbf L$ at $\Omega_s = L/\lambda_1$.",
)
def space_cone() -> Iterator[Evidence]:
    r"""$\boldsymbol\omega = \mathbf L/\lambda_1 + (1 - \lambda_3/\lambda_1)\omega_3\mathbf e_3$,
    and the second part does not move $\mathbf e_3$.

    This is the proof that the notes leave out: $\mathbf e_3$ and $\boldsymbol\omega$ both turn with
    the constant vector $L/\lambda_1$. If $\boldsymbol\omega$ is along $\mathbf e_3$ so is
    $\mathbf L$, and there is neither a plane nor a cone.
    """
    from . import evidence

    _, _, axis, omega_rate, _, rate, _ = printed.lines("space-cone")
    momentum = angular_momentum()
    meaning = {
        s.e3: Matrix(Z_AXIS),
        s.e3dot: Matrix(OMEGA).cross(Matrix(Z_AXIS)),
        s.L_vec: momentum,
        s.omega_vec: Matrix(OMEGA),
        omega_rate.sides[0]: body_accelerations(),
    }
    yield Formal(axis, meaning, (SYMMETRIC,))
    yield Formal(omega_rate, meaning, (SYMMETRIC,))
    # Of a vector v that turns about L: L·(v × v̇)/L is Ω_s times the square of its distance.
    across = momentum.cross(Matrix(Z_AXIS))
    size = momentum.dot(momentum) ** Rational(1, 2)
    azimuth = momentum.dot(Matrix(Z_AXIS).cross(meaning[s.e3dot])) * size / across.dot(across)
    yield Formal(
        rate,
        {**meaning, s.Omega_s: azimuth, s.L: size},
        (
            SYMMETRIC,
            Assumption(
                Ne(s.omega1**2 + s.omega2**2, 0),
                r"$\boldsymbol\omega$ is not along $\mathbf e_3$: else there is no plane, and "
                r"$\mathbf e_3$ rests",
                stated=True,
            ),
        ),
    )
    yield from evidence.space_cone()


@claim("free-fall", "In free fall there is no external torque about the centre of mass.")
def free_fall() -> Iterator[Evidence]:
    r"""$\sum m(\mathbf r - \mathbf R_{\text{CM}}) \times \mathbf g = 0$ when gravity is the same
    for all particles.

    So gravity does not turn a body about its centre of mass on the ground either: there the support
    does, and in free fall there is none. A field that varies across the body ($\kappa$, the tide)
    does, and so does the air, which pushes one part more than another ($F_1$).
    """
    positions = [Matrix(symbols(f"x{k} y{k} z{k}", real=True)) for k in (1, 2)]
    masses = (s.M_1, s.M_2)
    centre = (s.M_1 * positions[0] + s.M_2 * positions[1]) / (s.M_1 + s.M_2)
    *_, torque = printed.lines("free-fall")
    tide = s.kappa * diag(-1, -1, 2)
    terms = [
        {s.r_k: r, s.F_k: m * (tide * r - s.g * Matrix(Z_AXIS)) + air * Matrix(X_AXIS)}
        for m, r, air in zip(masses, positions, (s.F_1, 0), strict=True)
    ]
    yield Formal(
        torque,
        {symbols("k"): terms, s.R_CM: centre},
        (
            Assumption(Eq(s.kappa, 0), "gravity is the same all over the body"),
            Assumption(
                Eq(s.F_1, 0),
                "no air pushes a part of it",
            ),
        ),
    )


@claim(
    "example-33",
    "Toutatis has three different moments and does not rotate about a principal axis; most "
    "asteroids do.",
)
def example_33() -> Iterator[Evidence]:
    r"""At given $L$ the energy is least about the axis of the largest moment.

    Friction inside the body takes energy while something moves in it, and leaves $L$ in space
    alone. Off the principal axes $\boldsymbol\omega$ changes, so that a ball in oil, which stands
    for whatever rubs, does not stay at rest in the body. A body that has lost what it can turns
    about the axis of the largest moment; Toutatis does not yet. (Moments and spin state: Takahashi,
    Busch & Scheeres 2013.)
    """
    observed = dict(zip((s.lambda1, s.lambda2, s.lambda3), toutatis.MOMENTS, strict=True))
    spin = Matrix(toutatis.OMEGA_1992)
    momentum = diag(*toutatis.MOMENTS) * spin
    changes = dict(zip(OMEGA, spin, strict=True))
    _, least, *_, lost, falls = printed.lines("example-33")
    for line in printed.lines(
        r"\lambda_1 \neq \lambda_2, \lambda_2 \neq \lambda_3, \lambda_3 \neq \lambda_1"
    ):
        yield Formal(line, observed)
    yield Formal(
        printed(r"\boldsymbol\omega\times\mathbf L \neq [0, 0, 0]^T"),
        {s.omega_vec: spin, s.L_vec: momentum},
    )
    yield Formal(
        printed(r"[\dot\omega_1,\dot\omega_2,\dot\omega_3]^T \neq [0, 0, 0]^T"),
        {w: rate.subs({**observed, **changes}) for w, rate in RATES.items()},
    )
    squared = angular_momentum().dot(angular_momentum())
    meaning = {s.T: kinetic_energy(), s.L: squared ** Rational(1, 2)}
    largest = r"$\lambda_3$ is the largest moment"
    yield Formal(
        least,
        meaning,
        (
            Assumption(Gt(s.lambda3, s.lambda1), largest, stated=True),
            Assumption(Gt(s.lambda3, s.lambda2), largest, stated=True),
            Assumption(
                Gt(s.omega1**2 + s.omega2**2, 0),
                r"the rotation is another than about $\mathbf e_3$",
                stated=True,
            ),
        ),
    )
    rate, relative = gyrostat.along_flow(gyrostat.kinetic_energy()), Matrix(gyrostat.RELATIVE)
    yield Formal(lost, {s.T_totdot: rate, s.zeta_vec: relative})
    yield Formal(
        falls,
        {s.T_totdot: rate},
        (
            Assumption(Gt(s.damping, 0), "the oil brakes the ball"),
            Assumption(Gt(relative.dot(relative), 0), "the ball turns in the body", stated=True),
        ),
    )


page = Page(
    "3.2.3",
    "Precession of the rotation axis",
    r"Two equal moments: $\boldsymbol\omega$, $\mathbf L$ and $\mathbf e_3$ in the body frame and "
    "in space.",
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
