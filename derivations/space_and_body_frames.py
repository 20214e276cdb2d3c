"""Section 3.2.1: space versus body frames."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Integer, Matrix, diag, eye, symbols

from rigidtop.proof.page import Check, Evidence, Formal, Page, claim
from rigidtop.theory import symbols as s
from rigidtop.theory.inertia import point_masses, principal_axes
from rigidtop.theory.rotation import euler_matrix

from .printed import printed


@claim(
    "principal-axes",
    "$I$ has three real orthogonal eigenvectors, and $O$ built from them diagonalises $I$.",
)
def principal() -> Iterator[Evidence]:
    r"""$I$ is symmetric, so $\mathbf u\cdot I\mathbf v = \mathbf v\cdot I\mathbf u$ for all
    $\mathbf u$ and $\mathbf v$.

    With $\mathbf u$ and $\mathbf v$ the real and imaginary part of an eigenvector this makes its
    moment real; with two eigenvectors it makes ($\lambda - \lambda'$)
    $\mathbf u\cdot\mathbf v = 0$; and the plane across an eigenvector is mapped to itself, so there
    is another eigenvector in it.
    """
    u, v, *positions = (Matrix(symbols(f"{x}_1:4", real=True)) for x in "uvxy")
    masses = symbols("M_1 M_2", positive=True)
    tensor = point_masses(zip(masses, positions, strict=True))
    yield Formal(
        printed(r"\mathbf u\cdot I\mathbf v = \mathbf v\cdot I\mathbf u"),
        {s.inertia: tensor, s.u_vec: u, s.v_vec: v},
    )
    places = ([1, 2, 2], [2, 1, -2], [2, -2, 1])
    body = point_masses((Integer(m), Matrix(r)) for m, r in enumerate(places, start=1))
    moments, axes = principal_axes(body)
    meaning = {s.inertia: body, s.O_matrix: axes, s.Lambda: diag(*moments), s.unit: eye(3)}
    *_, diagonal = printed.lines("principal-axes")
    yield Formal(diagonal, meaning)


@claim("3.34", "$O$ with the principal axes as columns takes body components to space components.")
def components() -> Iterator[Evidence]:
    r"""$r = \sum r_k \mathbf e_k$ is $O r'$ when the columns of $O$ are the $\mathbf e_k$;
    $O^TO = 1$ turns it round."""
    attitude = euler_matrix()
    body = Matrix(symbols("r1 r2 r3", real=True))
    vector = sum((body[k] * attitude[:, k] for k in range(3)), Matrix([0, 0, 0]))
    meaning = {s.r_vec: vector, s.r_vecp: body, s.O_matrix: attitude}
    for line in printed.lines("3.34"):
        yield Check(line, meaning)


page = Page(
    "3.2.1",
    "Space versus body frames",
    "The principal axes as a basis that turns with the body.",
    (principal, components),
    text="space_and_body_frames",
)
