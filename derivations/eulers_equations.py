"""Section 3.2.2: Euler's equations."""

from __future__ import annotations

from collections.abc import Iterator
from operator import itemgetter

from sympy import Eq, Expr, Ge, Le, Matrix, Ne, S

from rigidtop.proof.equation import BODY, Rate
from rigidtop.proof.page import Assumption, Check, Evidence, Formal, Page, Remark, claim
from rigidtop.theory import gyrostat
from rigidtop.theory import symbols as s
from rigidtop.theory.euler import (
    OMEGA,
    angular_momentum,
    axis_growth,
    body_accelerations,
)
from rigidtop.theory.rotation import (
    EULER_RATES,
    euler_matrix,
    euler_omega,
    total_derivative,
)

from .printed import printed

RATES = (s.omega1dot, s.omega2dot, s.omega3dot)
CONSTANT = r"[\dot\omega_1,\dot\omega_2,\dot\omega_3]^T = [0, 0, 0]^T"


def rates(torque: Matrix | None = None) -> dict[Expr, Expr]:
    """ω̇ by Euler's equations (rad/s²)."""
    return dict(zip(RATES, body_accelerations(torque), strict=True))


@claim(
    "3.35",
    r"The rate of $\mathbf L$ in space is its rate in the body plus "
    r"$\boldsymbol\omega \times \mathbf L$, and vanishes.",
)
def transport() -> Iterator[Evidence]:
    r"""The transport theorem (2.87): differentiate $L' = R^TL$ and read $\omega$ off
    $R^T\dot R$."""
    line = printed("3.35")
    attitude = euler_matrix()
    space = Matrix([s.L_x, s.L_y, s.L_z])
    body = attitude.T * space
    # A torque N₃ along ẑ stands for any; (3.33) says that it is not there.
    moving = {**EULER_RATES, s.L_z: s.N3}
    yield Check(
        line,
        {
            s.L_vec: body,
            s.omega_vec: euler_omega("body"),
            line.sides[1]: attitude.T * total_derivative(space, moving),
            Rate(s.L_vec, BODY): total_derivative(body, moving),
        },
        (Assumption(Eq(s.N3, 0), "no external torque (3.33)", stated=True),),
    )


@claim("3.36", "Euler's equations for the case of no external torque.")
def euler_equations() -> Iterator[Evidence]:
    r"""$L_k = \lambda_k\omega_k$ put into (3.35), component by component."""
    for line in printed.lines("3.36"):
        yield Check(line, rates())


@claim("euler-with-torque", "There is a more complete version with external torque.")
def with_torque() -> Iterator[Evidence]:
    r"""(3.35) with $\mathbf N$ in place of 0; $\mathbf N$ has to be resolved along the body axes.

    For gravity that is not cumbersome: $\hat{\mathbf z}$ in body components obeys $\dot\gamma =
    \gamma \times \boldsymbol\omega$.
    """
    for line in printed.lines("euler-with-torque")[-3:]:
        yield Formal(line, rates(Matrix([s.N1, s.N2, s.N3])))


@claim("principal-stays", r"$\boldsymbol\omega$ along a principal axis stays constant.")
def principal_stays() -> Iterator[Evidence]:
    r"""Two of the three $\omega_k$ vanish, so every product on the right of (3.36) does."""
    for line in printed.lines("principal-stays")[:3]:
        yield Formal(line, rates())
    for axis in range(3):
        others = [w for k, w in enumerate(OMEGA) if k != axis]
        yield Formal(
            printed(CONSTANT),
            rates(),
            tuple(
                Assumption(
                    Eq(w, 0), rf"$\boldsymbol\omega$ lies along $\mathbf e_{axis + 1}$", stated=True
                )
                for w in others
            ),
        )


@claim("off-axis-changes", r"$\boldsymbol\omega$ that is not along a principal axis must change.")
def off_axis() -> Iterator[Evidence]:
    r"""Two components of $\boldsymbol\omega$ differ from zero, so one right side of (3.36) does.

    It does if the two moments that go with them differ. Of equal moments $\lambda_1 = \lambda_2$
    every axis in the plane of $\mathbf e_1$ and $\mathbf e_2$ is a principal axis, and
    $\boldsymbol\omega$ rests on it. Without naming axes: $\boldsymbol\omega$ rests where
    $\boldsymbol\omega \times \mathbf L = 0$, that is along any eigenvector of $I$.
    """
    for line in printed.lines("principal-stays")[:3]:
        yield Formal(line, rates())
    yield Formal(
        printed(CONSTANT.replace("=", r"\neq")),
        rates(),
        (
            Assumption(Ne(s.omega1, 0), "two components are not zero", stated=True),
            Assumption(Ne(s.omega2, 0), "two components are not zero", stated=True),
            Assumption(Ne(s.lambda1, s.lambda2), "the moments that go with these two differ"),
        ),
    )
    yield Remark(
        printed(
            r"[\lambda_1\dot\omega_1,\lambda_2\dot\omega_2,\lambda_3\dot\omega_3]^T"
            r" = \mathbf L\times\boldsymbol\omega"
        ),
        {**rates(), s.L_vec: angular_momentum(), s.omega_vec: Matrix(OMEGA)},
        reason=(
            r"Without naming axes: $\boldsymbol\omega$ rests only where "
            r"$\mathbf L \parallel \boldsymbol\omega$, along an eigenvector of $I$."
        ),
    )


@claim(
    "axis-stability",
    "Rotation is stable about the axes of largest and smallest moment and unstable otherwise.",
)
def axis_stability() -> Iterator[Evidence]:
    r"""(3.36) linearised about $\boldsymbol\omega = \omega_3\mathbf e_3$: a deviation grows as
    $\exp(\sigma t)$ with the $\sigma^2$ below.

    Beyond the linear order $2\lambda_3T - L^2$ is conserved and, about an extreme axis, a definite
    square of the deviation: that is stability for all times, if nothing inside takes energy;
    friction inside leads from the axis of the smallest moment to that of the largest. Equal moments
    are not covered: with $\lambda_1 = \lambda_2 \neq \lambda_3$ the axis $\mathbf e_1$ has an
    extreme moment and is left all the same, and with three every axis stays and none is returned
    to.
    """
    from . import evidence

    growth, stable, unstable = itemgetter(2, 5, 6)(printed.lines("axis-stability"))
    momentum = printed(r"L^2 = \text{const}")
    turning = "+".join(rf"(1 - \frac{{\lambda_0}}{{\lambda_{k}}})\zeta_{k}^2" for k in (1, 2, 3))
    with_ball = printed(
        r"2\lambda_3T_{\text{tot}} - L^2 = \frac{\lambda_3 - \lambda_1}{\lambda_1}L_1^2"
        rf" + \frac{{\lambda_3 - \lambda_2}}{{\lambda_2}}L_2^2 + \lambda_0\lambda_3({turning})"
    )
    meaning = {s.sigma2: axis_growth(3)}
    yield Formal(growth, meaning)
    spins = Assumption(Ne(s.omega3, 0), "the body rotates", stated=True)
    differs = "no other moment equals that of the axis"
    unequal = (
        Assumption(Ne(s.lambda3, s.lambda1), differs),
        Assumption(Ne(s.lambda3, s.lambda2), differs),
    )

    def ordered(words: str, *conditions: Expr) -> tuple[Assumption, ...]:
        return tuple(Assumption(condition, words, stated=True) for condition in conditions)

    largest = ordered(
        r"$\lambda_3$ is the largest moment", Ge(s.lambda3, s.lambda1), Ge(s.lambda3, s.lambda2)
    )
    smallest = ordered(
        r"$\lambda_3$ is the smallest moment", Le(s.lambda3, s.lambda1), Le(s.lambda3, s.lambda2)
    )
    between = ordered(
        r"$\lambda_3$ is the middle moment", Ge(s.lambda3, s.lambda1), Le(s.lambda3, s.lambda2)
    )
    extreme = (*unequal, spins)
    yield Formal(stable, meaning, (*largest, *extreme))
    yield Formal(stable, meaning, (*smallest, *extreme))
    yield Formal(unstable, meaning, (*between, *extreme))
    whole = gyrostat.angular_momentum()
    inside = {
        s.T_tot: gyrostat.kinetic_energy(),
        s.const: gyrostat.along_flow,
        s.T_totdot: gyrostat.along_flow(gyrostat.kinetic_energy()),
        s.L: whole.dot(whole) ** S.Half,
        s.L1: whole[0],
        s.L2: whole[1],
        s.zeta_vec: Matrix(gyrostat.RELATIVE),
    }
    yield Formal(
        printed(r"T_{\text{tot}} = \text{const}"),
        inside,
        (Assumption(Eq(s.damping, 0), "no friction inside takes energy"),),
    )
    yield Remark(momentum, inside, reason="With friction $L$ is kept all the same,")
    yield Remark(with_ball, inside, reason=r"but $2\lambda_3T - L^2$, with the ball in it,")
    yield Remark(
        printed(r"\dot T_{\text{tot}} = -c\boldsymbol\zeta\cdot\boldsymbol\zeta"),
        inside,
        reason="falls as the energy does: about the largest moment to zero, but about the "
        "smallest, where it is negative with the ball at rest, ever further from zero.",
    )
    yield Remark(
        printed(CONSTANT),
        rates(),
        tuple(
            Assumption(Eq(moment, s.lambda1), "three equal moments")
            for moment in (s.lambda2, s.lambda3)
        ),
        r"With three equal moments no $\omega$ is left, and none returned to.",
    )
    yield from evidence.axis_rates()
    yield from evidence.axis_with_friction()


page = Page(
    "3.2.2",
    "Euler's equations",
    r"The rate of change of $\boldsymbol\omega$ in the frame of the principal axes.",
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
