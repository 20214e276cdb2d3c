"""Section 3.4: rotation matrices."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Eq, Matrix, cos, eye, sin, symbols

from rigidtop.proof.equation import Equation, Group, Transposed, as_printed
from rigidtop.proof.page import Assumption, Check, Correction, Evidence, Page, claim
from rigidtop.theory.rotation import euler_matrix
from rigidtop.theory.symbols import (
    A_matrix,
    B_matrix,
    C_matrix,
    O_matrix,
    c_phi,
    c_psi,
    c_theta,
    det_A,
    det_B,
    det_O,
    phi,
    psi,
    r_vec,
    r_vecp,
    s_phi,
    s_psi,
    s_theta,
    theta,
    unit,
)
from rigidtop.theory.trig import reduce_trig

from .euler_angles import sequence


@claim(
    "3.46",
    "r′ = Oᵀr; a rotation matrix is an orthogonal matrix O which, multiplied to r, gives r′.",
)
def rotated_components() -> Iterator[Evidence]:
    """(3.34) again. But the sentence beside it has O where the equation has Oᵀ.

    And orthogonal is not enough: a mirror image is orthogonal too. It takes det O = 1.
    """
    attitude = euler_matrix()
    body = Matrix(symbols("r1 r2 r3", real=True))
    meaning = {r_vec: attitude * body, r_vecp: body, O_matrix: attitude}
    handed = symbols("s", real=True)
    with as_printed():
        printed = Equation(r_vecp, Transposed(O_matrix) * r_vec, tag="3.46")
        sentence = Equation(r_vecp, O_matrix * r_vec)
        proper = Equation(det_O, 1)
    yield Check(printed, meaning)
    yield Check(
        sentence,
        meaning,
        reason="As the sentence has it: “multiplied to r”.",
        other_reading={**meaning, O_matrix: attitude.T},
        printed=False,
    )
    yield Check(
        proper,
        {det_O: reduce_trig((handed * attitude).det())},
        (
            Assumption(
                Eq(handed, 1), "O is not a mirror image (s = −1): the S of SO(N)", stated=True
            ),
        ),
        "A rotation times s with s² = 1 is orthogonal for both signs of s.",
        given=(handed**2 - 1,),
        printed=False,
    )
    yield Correction(printed, meaning, reason="It is Oᵀ that is multiplied to r.")


@claim("3.47", "Oᵀ in Euler angles.")
def euler_angle_matrix() -> Iterator[Evidence]:
    """The printed matrix has e₁, e₂, e₃ as columns: by (3.34) that is O, not Oᵀ.

    Its last column is e₃ = (cos φ sin θ, sin φ sin θ, cos θ), as the figure of 3.3 has it.
    """
    with as_printed():
        entries = Matrix(
            [
                [
                    c_phi * c_theta * c_psi - s_phi * s_psi,
                    -(c_psi * s_phi) - c_phi * c_theta * s_psi,
                    c_phi * s_theta,
                ],
                [
                    c_phi * s_psi + c_theta * c_psi * s_phi,
                    c_phi * c_psi - c_theta * s_phi * s_psi,
                    s_phi * s_theta,
                ],
                [-(c_psi * s_theta), s_theta * s_psi, c_theta],
            ]
        )
        printed = Equation(Transposed(O_matrix), entries, tag="3.47")
        corrected = Equation(O_matrix, entries)
    short = {
        c_phi: cos(phi),
        s_phi: sin(phi),
        c_theta: cos(theta),
        s_theta: sin(theta),
        c_psi: cos(psi),
        s_psi: sin(psi),
    }
    attitude = sequence()[O_matrix]
    yield Check(
        printed,
        {O_matrix: attitude, **short},
        reason="With c and s for cosine and sine.",
        other_reading={O_matrix: attitude.T, **short},
    )
    yield Correction(corrected, {O_matrix: attitude, **short})


@claim("rotation-group", "Rotation matrices form a group; SO(N) has det O = 1.")
def rotation_group() -> Iterator[Evidence]:
    """Products and inverses of orthogonal matrices are orthogonal, and determinants multiply.

    The identities hold entry by entry for any matrices; shown for 2 × 2 and 3 × 3.
    """
    for size in (2, 3):
        A, B, C = (Matrix(size, size, symbols(f"{x}:{size * size}", real=True)) for x in "abc")
        one = eye(size)
        meaning = {A_matrix: A, B_matrix: B, C_matrix: C, unit: one}
        with as_printed():
            closed = Equation(
                Transposed(A_matrix * B_matrix) * (A_matrix * B_matrix) - unit,
                Transposed(B_matrix) * (Transposed(A_matrix) * A_matrix - unit) * B_matrix
                + (Transposed(B_matrix) * B_matrix - unit),
            )
            associative = Equation(
                Group(A_matrix * B_matrix) * C_matrix, A_matrix * Group(B_matrix * C_matrix)
            )
            determinants = Equation(det_O, det_A * det_B)
        yield Check(
            closed,
            meaning,
            reason="If AᵀA = 1 and BᵀB = 1 then (AB)ᵀ(AB) = 1.",
            printed=False,
        )
        yield Check(associative, meaning, printed=False)
        yield Check(
            determinants,
            {det_O: (A * B).det(method="berkowitz"), det_A: A.det(), det_B: B.det()},
            reason="The determinant of O = AB: so det = 1 is kept.",
            printed=False,
        )
    attitude = euler_matrix()
    with as_printed():
        inverse = Equation(Transposed(O_matrix) * O_matrix, unit)
        inside = Equation(Transposed(O_matrix), A_matrix)
    yield Check(
        inverse, {O_matrix: attitude, unit: eye(3)}, reason="Oᵀ is the inverse,", printed=False
    )
    yield Check(
        inside,
        {O_matrix: attitude, A_matrix: euler_matrix(-psi, -theta, -phi)},
        reason="and a rotation itself, by −ψ, −θ, −φ.",
        printed=False,
    )


page = Page(
    "3.4",
    "Rotation matrices",
    "The same rotations as matrices, and the group that they form.",
    (rotated_components, euler_angle_matrix, rotation_group),
    text="rotation_matrices",
)
