"""Section 3.4: rotations form a group, and their order matters."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, pi, sin

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

from rigidtop.derivations.rotation_matrices import rotation_group
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure

product_of_rotations = Claim(
    "product-of-rotations", "Two rotations in turn are one, by Rodrigues' half-angle formula."
)


commutator_of_rotations = Claim(
    "commutator-of-rotations", "Two small rotations fail to commute by the product of both."
)


Square = NDArray[np.float64]


def about(axis: NDArray[np.float64], angle: float) -> Square:
    """The matrix of a turn, as the exponential of its generator."""
    x, y, z = angle * axis
    return np.asarray(expm(np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])))


def angle_of(matrix: Square) -> float:
    """The angle of a rotation matrix, in [0, π]; as good for small ones."""
    sine = np.linalg.norm(matrix - matrix.T) / np.sqrt(8)
    return atan2(float(sine), float(np.trace(matrix) - 1) / 2)


HALVINGS = 6


@exercise(
    "rotations-form-a-group",
    "Rotations form a group, but their order matters",
    section="3.4",
    asks="“these matrices form a group (see math)”",
    statement=r"Let $A$ be a turn by the angle $2\alpha_1$ about $\mathbf n_1$, $B$ one by "
    r"$2\alpha_2$ about $\mathbf n_2$, and $\gamma$ the angle between these axes. Show "
    "that $AB$ is a rotation, and find its angle and axis. Convince yourself of what "
    "else makes a group: a neutral element, inverses, $(AB)C = A(BC)$ for a third turn "
    "$C$.\n\nThe order matters: by what angle do $AB$ and $BA$ differ? Halve both angles "
    "again and again: what is that angle for small turns, and about which axis?",
    claims=(rotation_group, product_of_rotations, commutator_of_rotations),
    parameters=(
        Parameter("alpha", pi / 2, r"angle $2\alpha_1$ of $A$", "rad", least=-pi, most=pi),
        Parameter("beta", pi / 2, r"angle $2\alpha_2$ of $B$", "rad", least=-pi, most=pi),
        Parameter("gamma", pi / 2, r"angle $\gamma$ between the axes", "rad", least=0, most=pi),
    ),
    figure="order-of-rotations",
    text="exercises/rotations_form_a_group",
)
def rotations_form_a_group(alpha: float, beta: float, gamma: float) -> Iterator[Outcome]:
    r"""Angle and axis of $AB$ come from the half-angle formula, and are those of the product of
    the matrices. $\mathbf n_1$ is $\hat{\mathbf x}$, and $\mathbf n_2$ lies in the plane of
    $\hat{\mathbf x}$ and $\hat{\mathbf y}$. The unit matrix is a turn by zero, the inverse a
    turn by the opposite angle, and a product of three matrices does not depend on the brackets."""
    first, second = np.array([1.0, 0.0, 0.0]), np.array([np.cos(gamma), np.sin(gamma), 0.0])
    A, B = about(first, alpha), about(second, beta)
    one = np.eye(3)

    # Rodrigues: half angles, and the axes' products.
    sines, cosines = np.sin([alpha / 2, beta / 2]), np.cos([alpha / 2, beta / 2])
    half_cosine = cosines[0] * cosines[1] - sines[0] * sines[1] * (first @ second)
    half_sine = (
        sines[0] * cosines[1] * first
        + cosines[0] * sines[1] * second
        + sines[0] * sines[1] * np.cross(first, second)
    )
    size = float(np.linalg.norm(half_sine))
    # −q is the same rotation as q: of the two, the one by less than half a turn.
    sign = 1.0 if half_cosine >= 0 else -1.0
    angle = 2 * atan2(size, abs(float(half_cosine)))
    axis = sign * half_sine / size if size else first
    C = about(axis, angle)

    apart = 4 * np.arcsin(abs(sines[0] * sines[1] * sin(gamma)))
    yield Answer("angle", "angle of $AB$", angle, "rad")
    for letter, component in zip("xyz", axis, strict=True):
        yield Answer(f"axis_{letter}", f"axis of $AB$, along ${letter}$", float(component))
    # 4 arcsin is at most 2π; a turn by more than π is one by less the other way.
    yield Answer(
        "commutator",
        "angle by which $AB$ and $BA$ differ",
        float(min(apart, 2 * pi - apart)),
        "rad",
    )
    yield Table(
        "small_turns",
        "Both angles halved: the angle of $ABA^{-1}B^{-1}$ and its axis",
        (
            r"$2\alpha_1$ (rad)",
            r"$2\alpha_2$ (rad)",
            "angle (rad)",
            r"angle over $4\alpha_1\alpha_2$, in radians",
            "$x$",
            "$y$",
            "$z$",
        ),
        tuple(_commutator(first, second, alpha / 2**k, beta / 2**k) for k in range(HALVINGS + 1)),
    )

    by_scipy = Rotation.from_matrix(A @ B).as_rotvec()
    apart_by_scipy = (Rotation.from_matrix(A @ B) * Rotation.from_matrix(B @ A).inv()).magnitude()
    product = about(axis, angle)
    errors = {
        "$AB$ by the half-angle formula, against the product": product - A @ B,
        "$AB$ is orthogonal": (A @ B).T @ (A @ B) - one,
        r"$\det(AB) - 1$": np.linalg.det(A @ B) - 1,
        "$A^{-1}$ is a turn by the opposite angle": about(first, -alpha) @ A - one,
        "$(AB)C - A(BC)$": (A @ B) @ C - A @ (B @ C),
        "angle of $AB$ against SciPy (rad)": np.linalg.norm(by_scipy) - angle,
    }
    for what, error in errors.items():
        yield Measure(what, float(np.max(np.abs(error))), 1e-14)
    # Near half a turn the angle of a matrix has half of its digits.
    cosine = np.cos(apart_by_scipy) - np.cos(apart)
    yield Measure("cosine of the angle between $AB$ and $BA$, against SciPy", abs(cosine), 1e-14)


def _commutator(
    first: NDArray[np.float64], second: NDArray[np.float64], alpha: float, beta: float
) -> tuple[float, ...]:
    """Both angles, the angle of A B A⁻¹B⁻¹, that over their product, and its axis."""
    A, B = about(first, alpha), about(second, beta)
    matrix = A @ B @ A.T @ B.T
    vector = np.array([matrix[2, 1], matrix[0, 2], matrix[1, 0]]) - [
        matrix[1, 2],
        matrix[2, 0],
        matrix[0, 1],
    ]
    size, angle = float(np.linalg.norm(vector)), angle_of(matrix)
    axis = vector / size if size else vector
    share = angle / (alpha * beta) if alpha * beta else 0.0
    return alpha, beta, angle, share, *map(float, axis)


EXERCISES: tuple[Exercise, ...] = (rotations_form_a_group,)
