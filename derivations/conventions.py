"""The Euler angles of other books: z–x′–z″ instead of z–y′–z″.

These claims are not the notes'.  They prove what `rigidtop.notation` does with equations: φ and ψ
of the notes are shifted by a quarter turn, the axes after the second turn change places, and the
Lagrangian keeps its form.
"""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Expr, Matrix, Rational, Symbol, cos, diag, pi, sin

from rigidtop.derivations.euler_angles import SYMMETRIC, momentum_primed
from rigidtop.notation.convention import SEQUENCES
from rigidtop.proof.equation import Equation, Group, as_printed
from rigidtop.proof.page import Evidence, Formal, Page, claim
from rigidtop.theory import symbols as s
from rigidtop.theory.euler import MOMENTS
from rigidtop.theory.lettered import real
from rigidtop.theory.rotation import (
    Z_AXIS,
    euler_matrix,
    euler_omega,
    omega_body,
    primed_matrix,
    rotation_x,
    rotation_z,
)
from rigidtop.theory.top import SYMMETRIC as SYMMETRIC_TOP
from rigidtop.theory.top import potential_energy

HALF = Rational(1, 2)

phi_x = real("phi_x", s.Glyph("φ", "x"), "first Euler angle z–x′–z″: azimuth of the nodes", "rad")
psi_x = real("psi_x", s.Glyph("ψ", "x"), "third Euler angle z–x′–z″: turn from the nodes", "rad")
e1x = real("e1x", s.Glyph("e", "1x", bold=True), "line of nodes: e₁ after the turn by φₓ", "")
e2x = real("e2x", s.Glyph("e", "2x", bold=True), "e₂ before the turn by ψₓ", "")


def counted(angle: Symbol) -> Expr:
    """An angle of the sequence z–x′–z″ by those of the notes, as `rigidtop.notation` has it."""
    return angle - SEQUENCES["zxz"][angle].quarters * pi / 2


ANGLES = {phi_x: counted(s.phi), psi_x: counted(s.psi)}


def nodes_matrix() -> Matrix:
    """Rz(φₓ) Rx(θ): its columns are the line of nodes, the axis across it, and e₃."""
    return rotation_z(ANGLES[phi_x]) * rotation_x(s.theta)


def axes() -> dict[Expr, Expr]:
    """The axes after the second turn of either sequence, in the space frame."""
    nodes, primed = nodes_matrix(), primed_matrix()
    return {
        e1x: nodes[:, 0],
        e2x: nodes[:, 1],
        s.e1p: primed[:, 0],
        s.e2p: primed[:, 1],
        s.e3: primed[:, 2],
    }


@claim(
    "euler-zxz",
    r"With $\phi_x = \phi + \pi/2$ and $\psi_x = \psi - \pi/2$ the turns $z$–$x'$–$z''$ lead to "
    "the same attitude.",
)
def attitude() -> Iterator[Evidence]:
    r"""$R_y(\theta)$ is $R_x(\theta)$ between quarter turns about $z$, which join the turns by
    $\phi$ and by $\psi$.

    The first matrix is $R_z(\phi_x) R_x(\theta) R_z(\psi_x)$; the engine has
    $R_z(\phi) R_y(\theta) R_z(\psi)$.
    """
    with as_printed():
        printed = Matrix(
            [
                [
                    cos(phi_x) * cos(psi_x) - sin(phi_x) * cos(s.theta) * sin(psi_x),
                    -cos(phi_x) * sin(psi_x) - sin(phi_x) * cos(s.theta) * cos(psi_x),
                    sin(phi_x) * sin(s.theta),
                ],
                [
                    sin(phi_x) * cos(psi_x) + cos(phi_x) * cos(s.theta) * sin(psi_x),
                    -sin(phi_x) * sin(psi_x) + cos(phi_x) * cos(s.theta) * cos(psi_x),
                    -cos(phi_x) * sin(s.theta),
                ],
                [sin(s.theta) * sin(psi_x), sin(s.theta) * cos(psi_x), cos(s.theta)],
            ]
        )
    turns = rotation_z(phi_x) * rotation_x(s.theta) * rotation_z(psi_x)
    said = Equation(s.O_matrix, printed)
    yield Formal(said, {s.O_matrix: turns}, reason="The product of the three turns.")
    yield Formal(
        said,
        {s.O_matrix: euler_matrix(), **ANGLES},
        reason="The attitude of the notes, with the angles shifted.",
    )


@claim(
    "nodes-zxz",
    r"The axes after the second turn change places: $\mathbf e_{1x} = \mathbf e_2'$ and "
    r"$\mathbf e_{2x} = -\mathbf e_1'$.",
)
def nodes() -> Iterator[Evidence]:
    r"""The line of nodes is $\mathbf e_2'$ in one sequence and the first axis in the other;
    $\mathbf e_3$ is the same."""
    with as_printed():
        along, across = Equation(e1x, s.e2p), Equation(e2x, -s.e1p)
        vertical = Equation(s.zhat, cos(s.theta) * s.e3 + sin(s.theta) * e2x)
    yield Formal(along, axes(), reason="The line of nodes.")
    yield Formal(across, axes(), reason=r"The axis across it and $\mathbf e_3$.")
    yield Formal(
        vertical, {**axes(), s.zhat: Z_AXIS}, reason="The vertical has no part along the nodes."
    )


@claim(
    "omega-zxz",
    r"$\boldsymbol\omega$ along the line of nodes, across it and along $\mathbf e_3$, and along "
    "the body's axes.",
)
def rotational_velocity() -> Iterator[Evidence]:
    r"""The engine takes $\omega$ from $\dot RR^T$ and $R^T\dot R$ of the notes' angles; the
    rates are the same."""
    with as_printed():
        along_nodes = Equation(
            s.omega_vec,
            s.thetadot * e1x
            + s.phidot * sin(s.theta) * e2x
            + Group(s.psidot + s.phidot * cos(s.theta)) * s.e3,
        )
        along_body = Equation(
            s.omega_vec,
            Matrix(
                [
                    s.phidot * sin(s.theta) * sin(psi_x) + s.thetadot * cos(psi_x),
                    s.phidot * sin(s.theta) * cos(psi_x) - s.thetadot * sin(psi_x),
                    s.phidot * cos(s.theta) + s.psidot,
                ]
            ),
        )
    yield Formal(
        along_nodes, {s.omega_vec: euler_omega("space"), **axes()}, reason="(3.42) goes over."
    )
    yield Formal(
        along_body,
        {s.omega_vec: euler_omega("body"), **ANGLES},
        reason=r"The components along $\mathbf e_1$, $\mathbf e_2$ and $\mathbf e_3$.",
    )


@claim("momentum-zxz", r"$\mathbf L$ along the line of nodes, across it and along $\mathbf e_3$.")
def momentum() -> Iterator[Evidence]:
    r"""(3.43) goes over; the engine has $\mathbf L = I\boldsymbol\omega$ along $\mathbf e_1'$,
    $\mathbf e_2'$ and $\mathbf e_3$, turned into space."""
    with as_printed():
        printed = Equation(
            s.L_vec,
            s.lambda1 * s.thetadot * e1x
            + s.lambda1 * s.phidot * sin(s.theta) * e2x
            + s.lambda3 * Group(s.psidot + s.phidot * cos(s.theta)) * s.e3,
        )
    space = primed_matrix() * momentum_primed()
    yield Formal(printed, {s.L_vec: space, **axes()}, (SYMMETRIC,))


@claim("lagrangian-zxz", "The Lagrangian (3.53) has the same form in the angles $z$–$x'$–$z''$.")
def lagrangian() -> Iterator[Evidence]:
    r"""$T$ from $R^T\dot R$ with $R = R_z(\phi_x) R_x(\theta) R_z(\psi_x)$, for any three
    moments, less $V$, at height $R \cos\theta$."""
    turns = rotation_z(phi_x) * rotation_x(s.theta) * rotation_z(psi_x)
    rates = {s.theta: s.thetadot, phi_x: s.phidot, psi_x: s.psidot}
    omega = omega_body(turns, rates)
    kinetic = HALF * omega.dot(diag(*MOMENTS) * omega)
    with as_printed():
        printed = Equation(
            s.Lagrangian,
            HALF * s.lambda1 * Group(s.phidot**2 * sin(s.theta) ** 2 + s.thetadot**2)
            + HALF * s.lambda3 * Group(s.psidot + s.phidot * cos(s.theta)) ** 2
            - s.M * s.g * s.R * cos(s.theta),
        )
    potential = potential_energy().subs(SYMMETRIC_TOP)
    yield Formal(printed, {s.Lagrangian: kinetic - potential}, (SYMMETRIC,))


page = Page(
    "3.3",
    "Euler angles of other books",
    "Three turns $z$–$x'$–$z''$, as Goldstein, Landau and Lifshitz and Morin have them.",
    (attitude, nodes, rotational_velocity, momentum, lagrangian),
)

CONVENTIONS = (page,)
"""What is proved besides the notes."""
