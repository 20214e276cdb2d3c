"""Section 3.4: rotation matrices."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Eq, Matrix, cos, eye, sin, symbols

from rigidtop.proof.equation import Equation, Transposed
from rigidtop.proof.page import Assumption, Check, Correction, Evidence, Formal, Page, claim
from rigidtop.theory import symbols as s
from rigidtop.theory.rotation import euler_matrix
from rigidtop.theory.trig import reduce_trig

from .euler_angles import sequence
from .printed import printed


@claim(
    "3.46",
    r"A rotation matrix is an orthogonal $O$ which, applied to $\mathbf r$, gives $\mathbf r'$: "
    r"$\mathbf r' = O^T\mathbf r$.",
)
def rotated_components() -> Iterator[Evidence]:
    r"""(3.34) again. But the sentence beside it has $O$ where the equation has $O^T$.

    And orthogonal is not enough: a mirror image is orthogonal too. It takes $\det O = 1$.
    """
    attitude = euler_matrix()
    body = Matrix(symbols("r1 r2 r3", real=True))
    meaning = {s.r_vec: attitude * body, s.r_vecp: body, s.O_matrix: attitude}
    handed = symbols("s", real=True)
    line = printed("3.46")
    yield Check(line, meaning)
    yield Formal(
        printed(r"\mathbf r' = O\mathbf r"),
        meaning,
        reason=r"As the sentence has it: “applied to $\mathbf r$”.",
        other_reading={**meaning, s.O_matrix: attitude.T},
    )
    yield Formal(
        printed(r"\det O = 1"),
        {s.det_O: reduce_trig((handed * attitude).det())},
        (
            Assumption(
                Eq(handed, 1), "$O$ is not a mirror image ($s = -1$): the S of SO(N)", stated=True
            ),
        ),
        "A rotation times $s$ with $s^2 = 1$ is orthogonal for both signs of $s$.",
        given=(handed**2 - 1,),
    )
    yield Correction(line, meaning, reason=r"It is $O^T$ that is applied to $\mathbf r$.")


@claim("3.47", "This matrix of Euler angles is $O^T$.")
def euler_angle_matrix() -> Iterator[Evidence]:
    r"""The printed matrix has $\mathbf e_1$, $\mathbf e_2$, $\mathbf e_3$ as columns: by (3.34)
    that is $O$, not $O^T$.

    Its last column is $\mathbf e_3 = (\cos\phi \sin\theta$, $\sin\phi \sin\theta$, $\cos\theta$),
    as the figure of 3.3 has it.
    """
    _, matrix = printed("3.47").sides
    short = {
        s.c_phi: cos(s.phi),
        s.s_phi: sin(s.phi),
        s.c_theta: cos(s.theta),
        s.s_theta: sin(s.theta),
        s.c_psi: cos(s.psi),
        s.s_psi: sin(s.psi),
    }
    attitude = sequence()[s.O_matrix]
    yield Check(
        Equation(Transposed(s.O_matrix), matrix, tag="3.47"),
        {s.O_matrix: attitude, **short},
        reason="With $c$ and $s$ for cosine and sine.",
        other_reading={s.O_matrix: attitude.T, **short},
    )
    yield Correction(
        Equation(s.O_matrix, matrix),
        {s.O_matrix: attitude, **short},
        reason="Its columns are the axes of the body: it is $O$.",
    )


@claim("rotation-group", "Rotation matrices form a group, SO(3), in which $det O = 1$.")
def rotation_group() -> Iterator[Evidence]:
    r"""Products and inverses of orthogonal matrices are orthogonal, and determinants multiply.

    The identities hold entry by entry for any matrices; shown for $2 \times 2$ and $3 \times 3$.
    """
    for size in (2, 3):
        A, B, C = (Matrix(size, size, symbols(f"{x}:{size * size}", real=True)) for x in "abc")
        one = eye(size)
        meaning = {s.A_matrix: A, s.B_matrix: B, s.C_matrix: C, s.unit: one}
        yield Formal(printed(r"(AB)^TAB - 1 = B^T(A^TA - 1)B + B^TB - 1"), meaning)
        yield Formal(printed(r"(AB)C = A(BC)"), meaning)
        yield Formal(
            printed(r"\det O = \det A\det B"),
            {s.det_O: (A * B).det(method="berkowitz"), s.det_A: A.det(), s.det_B: B.det()},
        )
    attitude = euler_matrix()
    yield Formal(
        printed(r"O^T = A"),
        {s.O_matrix: attitude, s.A_matrix: euler_matrix(-s.psi, -s.theta, -s.phi)},
    )


page = Page(
    "3.4",
    "Rotation matrices",
    "The same rotations as matrices, and the group that they form.",
    (rotated_components, euler_angle_matrix, rotation_group),
    text="rotation_matrices",
)
