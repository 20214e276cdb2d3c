"""Section 3.5.4: nutation in the Lagrange formalism."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Eq, Expr, Ge, Gt, Matrix, Ne, cos, pi, sin, symbols

from rigidtop.proof.equation import Equation
from rigidtop.proof.page import Assumption, Evidence, Formal, Page, Remark, Step, claim
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.lagrangian import cyclic_velocities, energy
from rigidtop.theory.rotation import Z_AXIS, euler_omega
from rigidtop.theory.trig import reduce_ratio

from .euler_angles import TILTED
from .printed import printed

SMALL = Assumption(Eq(s.eta_0, 0), "small oscillations", stated=True, otherwise=s.eta_0)


def steady_state() -> dict[Expr, Expr]:
    """p_φ, p_ψ and g of a steady precession at θ with ω₃ and Ω."""
    rates = {s.phidot: s.Omega, s.psidot: s.omega3 - s.Omega * cos(s.theta)}
    weight = (s.lambda3 * s.omega3 * s.Omega - s.lambda1 * cos(s.theta) * s.Omega**2) / (s.M * s.R)
    momenta = top.symmetric_momenta()
    return {s.p_phi: momenta[1].subs(rates), s.p_psi: momenta[2].subs(rates), s.g: weight}


def potential_slope(order: int) -> Expr:
    """The derivative of the effective potential by θ at a steady precession (J)."""
    return reduce_ratio(top.top_effective_potential().diff(s.theta, order).subs(steady_state()))


def mean_shift(second: Expr, third: Expr) -> Expr:
    """The mean of a swing A cos x about the minimum of a potential, to second order in A.

    λ₁θ̈ = −U′ with U′ = U″δ + ½U‴δ² and λ₁ times the square of the frequency = U″: the constant
    term of what is of order A² has to vanish.
    """
    phase, shift, overtone, u2, u3 = symbols("x c_0 c_2 u_2 u_3")
    swing = s.eta_0 * cos(phase) + s.eta_0**2 * (shift + overtone * cos(2 * phase))
    balance = u2 * (swing.diff(phase, 2) + swing) + u3 * swing**2 / 2
    order = (balance.diff(s.eta_0, 2) / 2).subs(s.eta_0, 0)
    # The mean over four quarters of a turn is exact: there is no harmonic above the third.
    constant = sum(order.subs(phase, k * pi / 2) for k in range(4)) / 4
    solution = -constant.subs(shift, 0) / constant.diff(shift)
    return s.eta_0**2 * solution.subs({u2: second, u3: third})


@claim(
    "nutation",
    r"When started a little off, $\theta$ oscillates about the value where it could be constant.",
)
def nutation() -> Iterator[Evidence]:
    r"""$\theta$ moves in the effective potential of its $p_\phi$ and $p_\psi$, whose minimum is
    the steady angle.

    The frequency is $\sqrt{U''/\lambda_1}$, for a fast top $\lambda_3\omega_3/\lambda_1$; released
    at rest, a fast top swings with the amplitude $\lambda_1MgR \sin\theta/(\lambda_3\omega_3)^2$
    about an angle that much below the release. With finite amplitude $A$ the mean lies off the
    steady angle, by $-A^2U'''/(4U'')$.
    """
    from . import evidence

    curvature = potential_slope(2)
    yield Step(
        Equation(s.U, top.top_effective_potential()), r"Minus the Routhian at $\dot\theta = 0$."
    )
    meaning = {s.omega_n2: curvature / s.lambda1, s.g: steady_state()[s.g]}
    yield Formal(printed.lines("nutation")[1], meaning)
    yield Formal(
        printed(r"\delta_{\theta} = 0"),
        {s.mean_theta: mean_shift(curvature, potential_slope(3))},
        (SMALL,),
    )
    lean = 1 - cos(s.theta)
    slower = {s.psidot: s.omega3 - s.phidot * cos(s.theta)}
    spinning = top.symmetric_momenta().subs(slower)
    momenta = dict(zip((s.p_theta, s.p_phi, s.p_psi), spinning, strict=True))
    yield Formal(
        printed(
            r"E - \frac{p_{\psi}^2}{2\lambda_3} - MgR - \Omega(p_{\phi} - p_{\psi})"
            r" = \frac{\lambda_1}{2}(\dot\theta^2 + (\dot\phi - \Omega)^2\sin^2\theta) + \frac{(1"
            r" - \cos\theta)}{8\lambda_1}(2D + (\lambda_3\omega_3)^2(1 - \cos\theta))"
        ),
        {
            **momenta,
            s.E: energy(top.symmetric_lagrangian(), top.RATES).subs(slower),
            s.Omega: s.lambda3 * s.omega3 / (2 * s.lambda1),
            s.D: top.discriminant().subs(s.theta, 0),
        },
    )
    yield Formal(
        printed(r"2D + (\lambda_3\omega_3)^2(1 - \cos\theta) > 0"),
        {},
        (
            Assumption(
                Ge(s.D, 0),
                "an upright top spins so fast that it sleeps and does not fall away from "
                r"$\theta = 0$",
            ),
            Assumption(Ne(s.omega3, 0), "the top spins", stated=True),
            Assumption(Gt(lean, 0), "off the upright", stated=True),
        ),
    )
    yield from evidence.nutation()


@claim("azimuth", r"$\dot\phi$ varies with $\theta$ by (3.45): waves, cusps, loops.")
def azimuth() -> Iterator[Evidence]:
    r"""$\dot\phi$ has the sign of $p_\phi - p_\psi \cos\theta$, which changes at
    $\cos\theta_0 = p_\phi/p_\psi$.

    $\theta_0$ between the turning points makes loops, on one of them cusps, outside them waves. A
    top that is released at rest has $\theta_0$ where it is released: cusps. With
    $p_\phi = p_\psi = 0$ (example 34) $\phi$ rests although $\theta$ changes.
    """
    from . import evidence

    rate = cyclic_velocities(top.symmetric_lagrangian(), (s.phidot, s.psidot), (s.p_phi, s.p_psi))[
        s.phidot
    ]
    momenta = top.symmetric_momenta()
    yield Formal(
        printed(r"\dot\phi = \frac{p_{\phi} - p_{\psi}\cos\theta}{\lambda_1\sin^2\theta}"),
        {s.p_phi: momenta[1], s.p_psi: momenta[2]},
        (TILTED,),
    )
    turning = s.p_psi * (1 + cos(s.theta) ** 2) - 2 * s.p_phi * cos(s.theta)
    yield Formal(
        printed(r"\dot\phi_{\theta} \neq 0"),
        {s.phidot_slope: rate.diff(s.theta)},
        (
            Assumption(
                Ne(turning, 0),
                r"$p_\phi$ and $p_\psi$ do not both vanish, and $\theta$ is not where $\dot\phi$ "
                "is largest or least",
            ),
        ),
    )
    yield from evidence.waves_cusps_loops()


@claim("friction", "Friction moves the point of contact and takes energy from the rotation.")
def friction() -> Iterator[Evidence]:
    r"""$\dot E$ is the contact force times the velocity of the tip where it touches: slip costs
    energy.

    Where static friction holds a sharp tip nothing moves and nothing is lost: that is the fixed
    pivot. Held so, a round tip rolls over the table. Without any friction the contact moves as
    well: the tip slides round at $R\Omega \sin\theta$, while the centre of mass stays above one
    spot.
    """
    direction = Matrix([cos(s.theta), sin(s.theta), 0])
    sliding = {s.F: -s.mu * s.n * direction, s.v_tip: s.slip * direction}
    yield Formal(printed.lines("friction")[-1], {s.Edot: sliding[s.F].dot(sliding[s.v_tip])})
    yield Formal(
        printed(r"\dot E < 0"),
        {s.Edot: sliding[s.F].dot(sliding[s.v_tip])},
        (Assumption(Gt(s.slip, 0), "the contact slips"),),
    )
    figure_axis = Matrix([sin(s.theta), 0, cos(s.theta)])
    turning = s.Omega * Matrix([0, 0, 1])
    moves = (
        "it rolls instead, for the contact to move: a round tip, and not a turn about the vertical "
        "alone"
    )
    yield Formal(
        printed(r"(\boldsymbol\omega\times r_0\hat{\mathbf z})^2 \neq 0"),
        {s.omega_vec: euler_omega("space"), s.zhat: Matrix(Z_AXIS)},
        (
            Assumption(Ne(s.r_t, 0), moves),
            Assumption(Ne(s.thetadot**2 + s.psidot**2 * sin(s.theta) ** 2, 0), moves),
        ),
    )
    yield Remark(
        printed.lines("friction")[4],
        {s.v_tip: -s.R * turning.cross(figure_axis)},
        reason=(
            r"Without friction the centre keeps its place and the tip, at $-R \mathbf e_3$, goes "
            "round."
        ),
    )


page = Page(
    "3.5.4",
    "Nutation in the Lagrange formalism",
    r"What $\theta$ and $\phi$ do when the precession is not quite steady.",
    (nutation, azimuth, friction),
    text="nutation",
)
