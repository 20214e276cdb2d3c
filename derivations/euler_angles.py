"""Section 3.3: Euler angles."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Eq, Expr, Matrix, Ne, diag, sin

from rigidtop.proof.equation import Equation
from rigidtop.proof.page import Assumption, Check, Evidence, Formal, Page, claim
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.euler import MOMENTS
from rigidtop.theory.rotation import (
    Z_AXIS,
    euler_matrix,
    euler_omega,
    primed_matrix,
    rotation,
    rotation_z,
)
from rigidtop.theory.trig import reduce_trig

from .printed import printed

SYMMETRIC = Assumption(Eq(s.lambda2, s.lambda1), "a symmetric top", stated=True)
TILTED = Assumption(Ne(sin(s.theta), 0), "the top is not upright and does not hang")

X, Y, Z = (Matrix(column) for column in ([1, 0, 0], [0, 1, 0], [0, 0, 1]))
SPACE_AXES = {s.xhat: X, s.yhat: Y, s.zhat: Z}
PRIMED = {s.e1p: X, s.e2p: Y, s.e3: Z}


def momentum_primed() -> Matrix:
    """L along e₁′, e₂′, e₃ for any three moments: I turns by ψ against that frame (3×1, J s)."""
    turn = rotation_z(s.psi)
    return reduce_trig(turn * diag(*MOMENTS) * turn.T) * euler_omega("primed")


def momentum_along_axes() -> dict[Expr, Expr]:
    """L along ẑ and along e₃, for any three moments (J s)."""
    components = momentum_primed()
    vertical_primed = primed_matrix().T * Z_AXIS
    return {s.L_z: reduce_trig(vertical_primed.dot(components)), s.L3: components[2]}


def sequence() -> dict[Expr, Expr]:
    """The three turns of the figure as rotations about axes that move: e₂′, e₃ and all of O."""
    first = rotation_z(s.phi)
    line_of_nodes = first * Y
    second = reduce_trig(rotation(line_of_nodes, s.theta) * first)
    figure_axis = second * Z
    third = reduce_trig(rotation(figure_axis, s.psi) * second)
    return {s.e2p: line_of_nodes, s.e3: figure_axis, s.O_matrix: third}


@claim(
    "euler-sequence",
    r"Turn about $\hat{\mathbf z}$ by $\phi$, about $\mathbf e_2'$ by $\theta$, about "
    r"$\mathbf e_3$ by $\psi$; $\mathbf e_3$ has the polar angle $\theta$ and the azimuth of "
    r"$\cos\phi \hat{\mathbf x} + \sin\phi \hat{\mathbf y}$.",
)
def euler_sequence() -> Iterator[Evidence]:
    r"""Rodrigues' formula about each axis in turn; the product is
    $R_z(\phi) R_y(\theta) R_z(\psi)$."""
    turned = sequence()
    meaning = {**turned, **SPACE_AXES}
    yield Formal(printed.lines("euler-sequence")[0], meaning)
    yield Formal(Equation(s.O_matrix, euler_matrix()), turned)


@claim("3.41", r"$\boldsymbol\omega$ is the sum of the three turns' rotational velocities.")
def omega_sum() -> Iterator[Evidence]:
    r"""$\omega$ read off $\dot RR^T$, with $R$ the product of the three turns."""
    turned = sequence()
    yield Check(
        printed("3.41"),
        {s.omega_vec: euler_omega("space"), s.zhat: Z, s.e2p: turned[s.e2p], s.e3: turned[s.e3]},
    )


@claim("z-hat", r"$\hat{\mathbf z} = \cos\theta \mathbf e_3 - \sin\theta \mathbf e_1'$.")
def vertical() -> Iterator[Evidence]:
    r"""$\hat{\mathbf z}$ resolved along $\mathbf e_1'$, $\mathbf e_2'$ and $\mathbf e_3$, the
    columns of $R_z(\phi) R_y(\theta)$."""
    axes = primed_matrix()
    yield Check(printed("z-hat"), {s.zhat: Z, s.e1p: axes[:, 0], s.e3: axes[:, 2]})


@claim("3.42", r"$\boldsymbol\omega$ along the axes after two turns.")
def omega_primed() -> Iterator[Evidence]:
    r"""$\hat{\mathbf z}$ of the exercise put into (3.41); the engine resolves $\omega$ of
    $\dot RR^T$ along the same axes."""
    omega = euler_omega("primed")
    yield Check(printed("3.42"), {s.omega_vec: Matrix(omega), **PRIMED, s.omega1p: omega[0]})


@claim(
    "skip-last-step",
    r"For $\lambda_1 = \lambda_2$ the last rotation is not needed to write $\mathbf L$ and $T$.",
)
def skip_last_step() -> Iterator[Evidence]:
    r"""A turn about $\mathbf e_3$ leaves $\text{diag}(\lambda_1, \lambda_1, \lambda_3)$ as it
    is, so $\psi$ drops out of $L$ and $T$; $\dot\psi$ does not."""
    turn = rotation_z(s.psi)
    yield Formal(
        printed(r"O\Lambda O^T = \Lambda"),
        {s.O_matrix: turn, s.Lambda: diag(*MOMENTS)},
        (SYMMETRIC,),
    )
    turned = Equation(s.T, top.kinetic_energy().subs(s.psi, 0))
    yield Formal(turned, {s.T: top.kinetic_energy()}, (SYMMETRIC,))


@claim("3.43", r"$\mathbf L$ along the axes after two turns.")
def momentum() -> Iterator[Evidence]:
    r"""$L_k = \lambda_k\omega_k$ along $\mathbf e_1'$, $\mathbf e_2'$ and $\mathbf e_3$, which
    are principal axes when $\lambda_2 = \lambda_1$."""
    components = momentum_primed()
    yield Check(printed("3.43"), {s.L_vec: components, **PRIMED, s.L3: components[2]}, (SYMMETRIC,))


@claim("3.44", "Kinetic energy in Euler angles.")
def kinetic() -> Iterator[Evidence]:
    r"""$\tfrac12\boldsymbol\omega\cdot\mathbf L$ (3.32) has one value in all frames; the engine
    takes it in the body frame."""
    yield Check(printed("3.44"), {s.T: top.kinetic_energy()}, (SYMMETRIC,))


@claim("3.45", r"$\dot\phi$ from $L_z$ and $L_3$.")
def azimuthal_rate() -> Iterator[Evidence]:
    r"""$L_z = \hat{\mathbf z}\cdot\mathbf L$ from (3.43) and the exercise, solved for $\dot\phi$:
    $\lambda_1 \sin^2\theta$ is divided out.

    Upright, $L_z = L_3$ whatever $\dot\phi$ is, and the right side is 0/0.
    """
    yield Check(printed("3.45"), momentum_along_axes(), (SYMMETRIC, TILTED))


page = Page(
    "3.3",
    "Euler angles",
    "Three turns $z$–$y'$–$z''$ that bring the space frame to the body frame.",
    (
        euler_sequence,
        omega_sum,
        vertical,
        omega_primed,
        skip_last_step,
        momentum,
        kinetic,
        azimuthal_rate,
    ),
    text="euler_angles",
)
