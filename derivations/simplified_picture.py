"""Section 3.5.2: precession in a simplified picture."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from sympy import Eq, Expr, Gt, Matrix, MatrixBase, Ne, Poly, cos, diag, sin, sqrt

from rigidtop.proof.page import Assumption, Check, Evidence, Formal, Page, claim
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.rotation import (
    EULER_RATES,
    Z_AXIS,
    euler_omega,
    primed_matrix,
    total_derivative,
)
from rigidtop.theory.trig import reduce_ratio, reduce_trig

from .printed import printed

MOMENTS = diag(s.lambda1, s.lambda1, s.lambda3)
WEAK = Assumption(
    Eq(s.epsilon, 0),
    r"to leading order in $\varepsilon = \lambda_1MgR \cos\theta/(\lambda_3\omega_3)^2$: weak "
    "torque",
    stated=True,
    otherwise=top.smallness(),
)
NO_NUTATION = Assumption(Eq(s.thetadot, 0), "the top does not nutate")
SPINNING = Assumption(Ne(s.omega3, 0), r"the top spins about $\mathbf e_3$", stated=True)


@cache
def balance() -> Expr:
    """What vanishes by L̇ = N along e₂′, for L = λ₃ω₃e₃ + λ₁ e₃ × ė₃ at constant λ₃ω₃ (N m).

    Of λ₁ e₃ × ë₃ what a steady precession at Ω has is written with ε, with which it vanishes.
    """
    axes = primed_matrix()
    axis, nodes = axes[:, 2], axes[:, 1]
    velocity = total_derivative(axis, EULER_RATES)
    torque = s.M * s.g * s.R * Matrix(Z_AXIS).cross(axis)
    kept = nodes.dot(s.lambda3 * s.omega3 * velocity - torque)
    rest = s.lambda1 * nodes.dot(axis.cross(total_derivative(velocity, EULER_RATES)))
    kept, rest = (reduce_trig(part).subs(s.phidot, s.Omega) for part in (kept, rest))
    steady = rest.subs(s.thetaddot, 0)
    small = s.epsilon * reduce_ratio(steady / top.smallness())
    return (kept + (rest - steady).expand() + small).expand()


def steady_rate() -> Expr:
    """The Ω at which the torque keeps θ, that of the two which gravity makes (rad/s)."""
    a, b, c = Poly(balance().subs(s.thetaddot, 0), s.Omega).all_coeffs()
    return -2 * c / b / (1 + sqrt(1 - (4 * a * c / b**2).expand()))


@cache
def steady() -> Assumption:
    """At the other rate, Ω₊, what (3.50) leaves out is half of what it keeps, or more."""
    return Assumption(
        Eq(s.Omega, steady_rate()),
        "a fast top, or one under a weak torque, goes round at the slower of its steady rates",
    )


def picture() -> dict[Expr, Expr | MatrixBase]:
    """e₃ at angle θ in the plane of x̂ and ẑ, precessing at Ω (space components).

    θ̇ is left in: a top that nutates.
    """
    axis = Matrix([sin(s.theta), 0, cos(s.theta)])
    vertical = Matrix(Z_AXIS)
    turning = s.Omega * vertical
    down = -s.g * vertical
    centre = s.R * axis
    torque = s.M * centre.cross(down)
    return {
        s.e3: axis,
        s.e3dot: turning.cross(axis) + s.thetadot * axis.diff(s.theta),
        s.zhat: vertical,
        s.yhat: Matrix([0, 1, 0]),
        s.g_vec: down,
        s.R_CM: centre,
        s.N_vec: torque,
        s.L_vecdot: torque,
        s.Omega_vec: turning,
    }


@claim(
    "3.50",
    r"With $\mathbf L = \lambda_3\omega_3\mathbf e_3$ the torque of the weight moves the axis.",
)
def torque_balance() -> Iterator[Evidence]:
    r"""$\dot{\mathbf L} = \mathbf N$ for the exact $\mathbf L = \lambda_3\omega_3\mathbf e_3 +
    \lambda_1 \mathbf e_3 \times \dot{\mathbf e}_3$; $\lambda_1 \mathbf e_3
    \times \ddot{\mathbf e}_3$ is smaller by $\varepsilon$ and left out.

    With $\mathbf L$ along $\mathbf e_3$ at all times $\boldsymbol\omega$ would be along
    $\mathbf e_3$ too, and $\mathbf e_3$ could not move: the equation can only hold to leading
    order, and exactly where $\cos\theta = 0$. A top that is released with $\boldsymbol\omega$ along
    $\mathbf e_3$, as the notes have it, starts with $\dot{\mathbf e}_3 = 0$ and makes cusps; the
    equation is then that of its mean motion.
    """
    from . import evidence

    yield Check(
        printed(
            r"\dot{\mathbf L} = \lambda_3\omega_3\dot{\mathbf e}_3"
            r" = M\mathbf R_{\text{CM}}\times\mathbf g = \mathbf N \tag{3.50}"
        ),
        picture(),
        (steady(), WEAK, NO_NUTATION),
    )
    yield from evidence.mean_precession()


@claim(
    "torque-perpendicular",
    r"The torque is orthogonal to $\mathbf L$ and turns it at constant length.",
)
def perpendicular() -> Iterator[Evidence]:
    r"""$\mathbf N = MgR \hat{\mathbf z} \times \mathbf e_3$ is orthogonal to $\mathbf e_3$;
    $\mathbf L$ has a part $\lambda_1 \mathbf e_3 \times \dot{\mathbf e}_3$ besides, and
    $\mathbf N\cdot\mathbf L = \lambda_1MgR \dot\theta \sin\theta$.

    So $|L|$ is constant while $\theta$ is, and pulsates with the nutation.
    """
    axes = primed_matrix()
    exact = axes * MOMENTS * euler_omega("primed")
    figure_axis = axes[:, 2]
    torque = s.M * s.g * s.R * Matrix(Z_AXIS).cross(figure_axis)
    meaning = {s.N_vec: torque, s.L_vec: exact}
    yield Formal(printed.lines("torque-perpendicular")[1], meaning)
    yield Formal(
        printed(r"\mathbf N\cdot\mathbf L = 0"),
        meaning,
        (Assumption(Eq(s.thetadot, 0), r"$\theta$ does not change, as in steady precession"),),
    )


@claim("3.51", r"$\mathbf e_3$ turns about a vertical $\boldsymbol\Omega$.")
def axis_turns() -> Iterator[Evidence]:
    r"""$\mathbf R_{\text{CM}} = R \mathbf e_3$ and $g = -g \hat{\mathbf z}$ put into (3.50);
    $\lambda_3\omega_3$ is divided out."""
    yield Check(
        printed(
            r"\dot{\mathbf e}_3 = \frac{MgR}{\lambda_3\omega_3}\hat{\mathbf z}\times\mathbf e_3"
            r" = \boldsymbol\Omega\times\mathbf e_3\tag{3.51}"
        ),
        picture(),
        (steady(), WEAK, NO_NUTATION, SPINNING),
    )


@claim("3.52", r"The precession vector $\boldsymbol\Omega$.")
def precession_vector() -> Iterator[Evidence]:
    r"""Read off (3.51); $\Omega$ is the rate at which $\dot{\mathbf L} = \mathbf N$ keeps
    $\theta$, exact for every spin."""
    yield Check(printed("3.52"), picture(), (steady(), WEAK, SPINNING))


@claim("torque-direction", "The torque of gravity points into the paper.")
def torque_direction() -> Iterator[Evidence]:
    r"""$\mathbf N = \mathbf R_{\text{CM}} \times M\mathbf g$ for $\mathbf e_3$ in the paper:
    $\hat{\mathbf x}$ to the right, $\hat{\mathbf z}$ up, so $\hat{\mathbf y}$ points into it."""
    yield Formal(printed(r"\mathbf N = MgR\sin\theta\hat{\mathbf y}"), picture())
    yield Formal(
        printed(r"\mathbf N\cdot\hat{\mathbf y} > 0"),
        picture(),
        (Assumption(Gt(sin(s.theta), 0), "the top leans to the right of the figure"),),
    )


@claim(
    "parallel-approximation",
    r"$\mathbf L \parallel \boldsymbol\omega$ is a good approximation for a weak torque.",
)
def parallel() -> Iterator[Evidence]:
    r"""The part of $\boldsymbol\omega$ across $\mathbf e_3$ gains its energy from the weight
    alone: $\tfrac12\lambda_1\omega_\perp^2 = MgR(\cos\theta_0 - \cos\theta)$.

    Started with $\boldsymbol\omega$ along $\mathbf e_3$, it stays of the order of the root of the
    torque, and $\cos^2$ of the angle between $\mathbf L$ and $\boldsymbol\omega$ tends to 1. A weak
    torque alone is not enough: a top in free precession has none, and its $\mathbf L$ and
    $\boldsymbol\omega$ are not parallel.
    """
    from . import evidence

    # Along the motion d/dt ½λ₁(φ̇² sin²θ + θ̇²) is the power of the weight.
    rates = euler_omega("primed")
    across = (rates[0] ** 2 + rates[1] ** 2) / 2
    yield Formal(
        printed(r"\dot T = MgR\dot\theta\sin\theta"), {s.Tdot: s.lambda1 * top.along_motion(across)}
    )
    transverse = sqrt(s.omega_0**2 + 2 * s.kappa * s.M * s.g * s.R / s.lambda1 * s.delta)
    yield Formal(
        printed(
            r"\frac{(\mathbf L\cdot\boldsymbol\omega)^2}"
            r"{(\mathbf L\cdot\mathbf L)\boldsymbol\omega\cdot\boldsymbol\omega} = 1"
        ),
        {
            s.L_vec: Matrix([s.lambda1 * transverse, 0, s.lambda3 * s.omega3]),
            s.omega_vec: Matrix([transverse, 0, s.omega3]),
        },
        (
            Assumption(
                Eq(s.omega_0, 0),
                r"the top starts with $\boldsymbol\omega$ along $\mathbf e_3$",
                stated=True,
            ),
            Assumption(
                Eq(s.kappa, 0), r"the torque $\kappa MgR$ is weak", stated=True, otherwise=s.kappa
            ),
            SPINNING,
        ),
    )
    yield from evidence.parallel()


@claim(
    "example-34",
    r"A top released tilted with $\mathbf L = 0$: how $\mathbf L$ evolves, and what motion it is.",
)
def toppling() -> Iterator[Evidence]:
    r"""$L_z = L_3 = 0$ stay zero, so $\phi$ and $\psi$ rest: a plane pendulum that falls over.

    $L$ grows along the fixed horizontal axis $\mathbf e_2'$, which the torque has too; nothing
    precesses.
    """
    _, about_vertical, about_axis = top.symmetric_momenta()
    across = (about_vertical - cos(s.theta) * about_axis).expand()
    tilted = Assumption(Ne(sin(s.theta), 0), "the top is released tilted", stated=True)
    yield Formal(printed(r"\dot\phi = 0"), {}, (tilted,), given=(across,))
    yield Formal(printed(r"\dot\psi = 0"), given=(about_axis.subs(s.phidot, 0),))
    rest = {s.phidot: 0, s.psidot: 0}
    falling = top.symmetric_top_accelerations()[0].subs(rest)
    yield Formal(printed.lines("example-34")[6], {s.thetaddot: falling})


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
