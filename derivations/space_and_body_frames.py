"""Section 3.2.1: space versus body frames."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Integer, Matrix, diag, eye, symbols

from rigidtop.proof.equation import Dot, Equation, Transposed, as_printed
from rigidtop.proof.page import Check, Evidence, Page, Step, claim
from rigidtop.theory.inertia import point_masses, principal_axes
from rigidtop.theory.lettered import in_order, real
from rigidtop.theory.rotation import euler_matrix
from rigidtop.theory.symbols import (
    Glyph,
    Lambda,
    O_matrix,
    det_O,
    inertia,
    r_vec,
    r_vecp,
    unit,
)

U_VECTOR, V_VECTOR = in_order(
    *(real(f"{x}_vec", Glyph(x, bold=True), "any vector", "") for x in "uv")
)


@claim(
    "principal-axes",
    "I has three real orthogonal eigenvectors, and O built from them diagonalises I.",
)
def principal() -> Iterator[Evidence]:
    """I is symmetric, so u·Iv = v·Iu for all u and v.

    With u and v the real and imaginary part of an eigenvector this makes its moment real; with two
    eigenvectors it makes (λ − λ′) u·v = 0; and the plane across an eigenvector is mapped to itself,
    so there is another eigenvector in it.
    """
    u, v = (
        Matrix([real(f"{x}_{k}", Glyph(x, str(k)), f"component {k} of {x}", "") for k in (1, 2, 3)])
        for x in "uv"
    )
    positions = (Matrix(symbols("x y z", real=True)), Matrix(symbols("x2 y2 z2", real=True)))
    masses = symbols("M_1 M_2", positive=True)
    with as_printed():
        symmetric = Equation(Dot(U_VECTOR, inertia * V_VECTOR), Dot(V_VECTOR, inertia * U_VECTOR))
        diagonal = Equation(Transposed(O_matrix) * inertia * O_matrix, Lambda)
        orthogonal = Equation(Transposed(O_matrix) * O_matrix, unit)
    tensor = point_masses(zip(masses, positions, strict=True))
    yield Check(
        symmetric,
        {inertia: tensor, U_VECTOR: u, V_VECTOR: v},
        reason="For the tensor of any masses and any two vectors u and v.",
        printed=False,
    )
    body = point_masses(
        [
            (Integer(1), Matrix([1, 2, 2])),
            (Integer(2), Matrix([2, 1, -2])),
            (Integer(3), Matrix([2, -2, 1])),
        ]
    )
    moments, axes = principal_axes(body)
    meaning = {inertia: body, O_matrix: axes, Lambda: diag(*moments), unit: eye(3)}
    yield Step(
        Equation(inertia, body),
        "Masses of 1, 2 and 3 kg at (1, 2, 2), (2, 1, −2) and (2, −2, 1) m.",
    )
    yield Check(diagonal, meaning, reason="O from its eigenvectors.", printed=False)
    yield Check(orthogonal, meaning, reason="The eigenvectors are orthonormal.", printed=False)
    yield Check(
        Equation(det_O, 1),
        {det_O: axes.det()},
        reason="Numbered so that they are right-handed, which cross products in (3.36) need; "
        "with two of them exchanged O still diagonalises I, but det O = −1.",
        printed=False,
    )


@claim("3.34", "O with the principal axes as columns takes body components to space components.")
def components() -> Iterator[Evidence]:
    """r = Σ rₖ eₖ is O r′ when the columns of O are the eₖ; OᵀO = 1 turns it round."""
    with as_printed():
        to_body = Equation(r_vecp, Transposed(O_matrix) * r_vec)
        to_space = Equation(r_vec, O_matrix * r_vecp, tag="3.34")
    attitude = euler_matrix()
    body = Matrix(symbols("r1 r2 r3", real=True))
    vector = sum((body[k] * attitude[:, k] for k in range(3)), Matrix([0, 0, 0]))
    meaning = {r_vec: vector, r_vecp: body, O_matrix: attitude}
    yield Check(to_body, meaning)
    yield Check(to_space, meaning)


page = Page(
    "3.2.1",
    "Space versus body frames",
    "The principal axes as a basis that turns with the body.",
    (principal, components),
    text="space_and_body_frames",
)
