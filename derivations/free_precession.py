"""Section 3.2: free precession."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Eq, Expr, Matrix, diag, symbols

from rigidtop.proof.page import Assumption, Check, Correction, Evidence, Formal, Page, claim
from rigidtop.theory import symbols as s
from rigidtop.theory.euler import MOMENTS
from rigidtop.theory.inertia import point_masses
from rigidtop.theory.rotation import euler_matrix, total_derivative
from rigidtop.theory.trig import reduce_trig

from .printed import printed

POSITIONS = tuple(Matrix(symbols(f"x{k} y{k} z{k}", real=True)) for k in (1, 2))
VELOCITIES = tuple(Matrix(symbols(f"u{k} v{k} w{k}", real=True)) for k in (1, 2))
SPIN = Matrix(symbols("omega_x omega_y omega_z", real=True))
MASSES = (s.M_1, s.M_2)

TORQUE_FREE = Assumption(Eq(s.F_1, 0), "no external torque", stated=True)


def newton_rate() -> Matrix:
    """d/dt Σ r × m ṙ of two particles: a central force κ(r₁ − r₂) between them, F₁ x̂ on one."""
    between = s.kappa * (POSITIONS[0] - POSITIONS[1])
    forces = (-between + s.F_1 * Matrix([1, 0, 0]), between)
    momentum = sum(
        (m * r.cross(v) for m, r, v in zip(MASSES, POSITIONS, VELOCITIES, strict=True)),
        Matrix([0, 0, 0]),
    )
    rates: dict[Expr, Expr] = {}
    for m, r, v, force in zip(MASSES, POSITIONS, VELOCITIES, forces, strict=True):
        rates |= dict(zip(r, v, strict=True)) | dict(zip(v, force / m, strict=True))
    return total_derivative(momentum, rates).expand()


@claim(
    "3.33",
    r"In the space frame $\mathbf L = I\boldsymbol\omega$ is conserved without external torque.",
)
def conservation() -> Iterator[Evidence]:
    r"""$\dot{\mathbf L} = \mathbf N$ (1.20) with $\mathbf L = I\boldsymbol\omega$ (3.26); the
    forces inside the body are central and cancel."""
    line = printed("3.33")
    pairs = list(zip(MASSES, POSITIONS, strict=True))
    momentum = sum((m * r.cross(SPIN.cross(r)) for m, r in pairs), Matrix([0, 0, 0]))
    yield Formal(
        printed(r"\mathbf L = I\boldsymbol\omega"),
        {s.L_vec: momentum, s.inertia: point_masses(pairs), s.omega_vec: SPIN},
    )
    rate = newton_rate()
    yield Check(line, {s.L_vecdot: rate, line.sides[2]: rate}, (TORQUE_FREE,))


@claim("inertia-full", "In the space frame all components of $I$ are nonzero.")
def inertia_full() -> Iterator[Evidence]:
    r"""$I = O\Lambda O^T$ turns with the body, and its off-diagonal components pass through
    zero."""
    tensor = reduce_trig(euler_matrix() * diag(*MOMENTS) * euler_matrix().T)
    yield Formal(printed(r"I_{xz} \neq 0"), {s.I_xz: tensor[0, 2]})
    yield Correction(
        printed.lines("inertia-full")[3],
        {s.I_xz: tensor[0, 2]},
        (Assumption(Eq(s.lambda2, s.lambda1), "a symmetric top"),),
        "It vanishes for every upright top, and at all times for a sphere. Of a symmetric top, "
        "for which it vanishes too where the axis is horizontal, it is in the Euler angles of "
        "section 3.3",
    )


page = Page(
    "3.2",
    "Free precession",
    r"Without external torque $\mathbf L$ is constant in the space frame, where $I$ as a rule is "
    "not.",
    (conservation, inertia_full),
    text="free_precession",
)
