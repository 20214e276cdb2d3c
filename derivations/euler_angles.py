"""Section 3.3: Euler angles."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Eq, Matrix, Ne, Rational, cos, diag, sin

from rigidtop.proof.equation import Equation, Group, Transposed, Underbrace, as_printed
from rigidtop.proof.page import Assumption, Check, Evidence, Page, Step, claim
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
from rigidtop.theory.symbols import (
    L3,
    L_vec,
    L_z,
    Lambda,
    O_matrix,
    T,
    e1p,
    e2p,
    e3,
    lambda1,
    lambda2,
    lambda3,
    omega1p,
    omega_vec,
    phi,
    phidot,
    psi,
    psidot,
    theta,
    thetadot,
    xhat,
    yhat,
    zhat,
)
from rigidtop.theory.trig import reduce_trig

HALF = Rational(1, 2)
SYMMETRIC = Assumption(Eq(lambda2, lambda1), "a symmetric top", stated=True)
TILTED = Assumption(Ne(sin(theta), 0), "the top is not upright and does not hang")

X, Y, Z = (Matrix(column) for column in ([1, 0, 0], [0, 1, 0], [0, 0, 1]))
SPACE_AXES = {xhat: X, yhat: Y, zhat: Z}
PRIMED = {e1p: X, e2p: Y, e3: Z}


def momentum_primed() -> Matrix:
    """L along e₁′, e₂′, e₃ for any three moments: I turns by ψ against that frame (3×1, J s)."""
    turn = rotation_z(psi)
    return reduce_trig(turn * diag(*MOMENTS) * turn.T) * euler_omega("primed")


def momentum_along_axes() -> dict:
    """L along ẑ and along e₃, for any three moments (J s)."""
    components = momentum_primed()
    vertical_primed = primed_matrix().T * Z_AXIS
    return {L_z: reduce_trig(vertical_primed.dot(components)), L3: components[2]}


def sequence() -> dict:
    """The three turns of the figure as rotations about axes that move: e₂′, e₃ and all of O."""
    first = rotation_z(phi)
    line_of_nodes = first * Y
    second = reduce_trig(rotation(line_of_nodes, theta) * first)
    figure_axis = second * Z
    third = reduce_trig(rotation(figure_axis, psi) * second)
    return {e2p: line_of_nodes, e3: figure_axis, O_matrix: third}


@claim(
    "euler-sequence",
    "Turn about ẑ by φ, about e₂′ by θ, about e₃ by ψ; φ and θ are azimuth and polar angle of e₃.",
)
def euler_sequence() -> Iterator[Evidence]:
    """Rodrigues' formula about each axis in turn; the product is Rz(φ) Ry(θ) Rz(ψ)."""
    turned = sequence()
    with as_printed():
        axis = Equation(
            e3, sin(theta) * cos(phi) * xhat + sin(theta) * sin(phi) * yhat + cos(theta) * zhat
        )
        nodes = Equation(e2p, -sin(phi) * xhat + cos(phi) * yhat)
    meaning = {**turned, **SPACE_AXES}
    yield Check(nodes, meaning, reason="After the first turn.", printed=False)
    yield Check(axis, meaning, reason="After the second, and the third leaves it.", printed=False)
    yield Check(
        Equation(O_matrix, euler_matrix()),
        turned,
        reason="Turns about moving axes, in this order, are turns about fixed axes in the other.",
        printed=False,
    )
    yield Step(Equation(O_matrix, euler_matrix()), "Its columns are e₁, e₂, e₃ in space.")


@claim("3.41", "ω is the sum of the three turns' rotational velocities.")
def omega_sum() -> Iterator[Evidence]:
    """ω read off ṘRᵀ, with R the product of the three turns."""
    with as_printed():
        printed = Equation(omega_vec, phidot * zhat + thetadot * e2p + psidot * e3, tag="3.41")
    turned = sequence()
    yield Check(
        printed,
        {omega_vec: euler_omega("space"), zhat: Z, e2p: turned[e2p], e3: turned[e3]},
    )


@claim("z-hat", "ẑ = cos θ e₃ − sin θ e₁′.")
def vertical() -> Iterator[Evidence]:
    """ẑ resolved along e₁′, e₂′ and e₃, the columns of Rz(φ) Ry(θ)."""
    with as_printed():
        printed = Equation(zhat, cos(theta) * e3 - sin(theta) * e1p)
    axes = primed_matrix()
    yield Check(printed, {zhat: Z, e1p: axes[:, 0], e3: axes[:, 2]})


@claim("3.42", "ω along e₁′, e₂′ and e₃.")
def omega_primed() -> Iterator[Evidence]:
    """ẑ of the exercise put into (3.41); the engine resolves ω of ṘRᵀ along the same axes."""
    with as_printed():
        printed = Equation(
            omega_vec,
            Underbrace(Group(-phidot * sin(theta)), omega1p) * e1p
            + thetadot * e2p
            + Group(psidot + phidot * cos(theta)) * e3,
            tag="3.42",
        )
    omega = euler_omega("primed")
    yield Check(printed, {omega_vec: Matrix(omega), **PRIMED, omega1p: omega[0]})


@claim("skip-last-step", "For λ₁ = λ₂ the last rotation is not needed to write L and T.")
def skip_last_step() -> Iterator[Evidence]:
    """A turn about e₃ leaves diag(λ₁, λ₁, λ₃) as it is, so ψ drops out of L and T; ψ̇ does not."""
    turn = rotation_z(psi)
    with as_printed():
        unchanged = Equation(O_matrix * Lambda * Transposed(O_matrix), Lambda)
    yield Check(
        unchanged,
        {O_matrix: turn, Lambda: diag(*MOMENTS)},
        (SYMMETRIC,),
        "O is here the last turn, by ψ about e₃.",
        printed=False,
    )
    turned = Equation(T, top.kinetic_energy().subs(psi, 0))
    yield Check(
        turned, {T: top.kinetic_energy()}, (SYMMETRIC,), "T is that of ψ = 0.", printed=False
    )


@claim("3.43", "L along e₁′, e₂′ and e₃.")
def momentum() -> Iterator[Evidence]:
    """Lₖ = λₖωₖ along e₁′, e₂′ and e₃, which are principal axes when λ₂ = λ₁."""
    with as_printed():
        printed = Equation(
            L_vec,
            Group(-lambda1 * phidot * sin(theta)) * e1p
            + lambda1 * thetadot * e2p
            + Underbrace(lambda3 * Group(psidot + phidot * cos(theta)), L3) * e3,
            tag="3.43",
        )
    components = momentum_primed()
    yield Check(printed, {L_vec: components, **PRIMED, L3: components[2]}, (SYMMETRIC,))


@claim("3.44", "Kinetic energy in Euler angles.")
def kinetic() -> Iterator[Evidence]:
    """½ω·L (3.32) has one value in all frames; the engine takes it in the body frame."""
    with as_printed():
        printed = Equation(
            T,
            HALF * lambda1 * Group(phidot**2 * sin(theta) ** 2 + thetadot**2)
            + HALF * lambda3 * Group(psidot + phidot * cos(theta)) ** 2,
            tag="3.44",
        )
    yield Step(Equation(T, top.kinetic_energy()), "Any three moments, from ω of RᵀṘ.")
    yield Check(printed, {T: top.kinetic_energy()}, (SYMMETRIC,))


@claim("3.45", "φ̇ from L_z and L₃.")
def azimuthal_rate() -> Iterator[Evidence]:
    """L_z = ẑ·L from (3.43) and the exercise, solved for φ̇: λ₁ sin²θ is divided out.

    Upright, L_z = L₃ whatever φ̇ is, and the right side is 0/0.
    """
    with as_printed():
        printed = Equation(
            phidot, (L_z - L3 * cos(theta)) / (lambda1 * sin(theta) ** 2), tag="3.45"
        )
        projected = Equation(L_z, lambda1 * phidot * sin(theta) ** 2 + L3 * cos(theta))
    meaning = momentum_along_axes()
    yield Check(projected, meaning, (SYMMETRIC,), reason="L along ẑ.", printed=False)
    yield Check(printed, meaning, (SYMMETRIC, TILTED))


page = Page(
    "3.3",
    "Euler angles",
    "Three turns z–y′–z″ that bring the space frame to the body frame.",
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
