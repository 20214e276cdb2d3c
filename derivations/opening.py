"""Opening of chapter 3.2: two point masses on a stick."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Integer, Matrix, Ne, cos, pi, sin

from rigidtop.proof.equation import Cross, Dot, Equation, as_printed
from rigidtop.proof.page import Assumption, Check, Evidence, Page, claim
from rigidtop.theory.inertia import point_masses
from rigidtop.theory.rotation import Z_AXIS, rotation_z
from rigidtop.theory.symbols import (
    M_1,
    M_2,
    L_later,
    L_vec,
    a,
    alpha,
    b,
    delta,
    omega,
    omega_perp,
    omega_vec,
    r_1,
    xhat,
    yhat,
    zhat,
)
from rigidtop.theory.trig import reduce_trig

STICK = Matrix([0, sin(alpha), cos(alpha)])

TILTED = Assumption(Ne(sin(alpha), 0), "the stick is tilted against ω", stated=True)
TURNING = Assumption(Ne(omega, 0), "the masses move", stated=True)
OBLIQUE = Assumption(Ne(cos(alpha), 0), "the stick is not at right angles to ω either")


def angular_momentum(turn: Matrix) -> Matrix:
    """Σ m r × (ω × r) of both masses, after the stick has been turned (3×1)."""
    spin = omega * Matrix(Z_AXIS)
    positions = ((M_1, a * turn * STICK), (M_2, -b * turn * STICK))
    total = sum((m * r.cross(spin.cross(r)) for m, r in positions), Matrix([0, 0, 0]))
    return reduce_trig(total, keep="sin")


@claim(
    "two-mass-points",
    "For two point masses on a stick tilted to ω, L is not parallel to ω and lies in the plane of "
    "the masses and ω; with ω constant L would turn, so ω must change when the body is free.",
)
def two_mass_points() -> Iterator[Evidence]:
    """L = Σ m r × (ω × r) has a part across ω, which half a turn with constant ω would reverse.

    For points exactly on a line that does not make ω change: the part of ω along the stick moves
    nothing, and the rest can stay constant along L.
    """
    before = angular_momentum(rotation_z(Integer(0)))
    meaning = {
        L_vec: before,
        L_later: angular_momentum(rotation_z(pi)),
        omega_vec: omega * Matrix(Z_AXIS),
        r_1: a * STICK,
        xhat: Matrix([1, 0, 0]),
        yhat: Matrix([0, 1, 0]),
        zhat: Matrix(Z_AXIS),
    }
    moment = M_1 * a**2 + M_2 * b**2
    with as_printed():
        momentum = Equation(
            L_vec,
            (M_1 * a**2 + M_2 * b**2)
            * omega
            * sin(alpha)
            * (sin(alpha) * zhat - cos(alpha) * yhat),
        )
        in_plane = Equation(Dot(L_vec, Cross(r_1, omega_vec)), 0)
        not_parallel = Equation(Cross(L_vec, omega_vec), 0, relation="≠")
        turned = Equation(L_later, L_vec, relation="≠")
        same_motion = Equation(Cross(omega_vec, r_1), Cross(omega_perp, r_1))
        told_apart = Equation(Cross(omega_vec, r_1), Cross(omega_perp, r_1), relation="≠")
    yield Check(momentum, meaning, reason="Masses in the yz plane, ω along ẑ.", printed=False)
    tensor = point_masses([(M_1, a * STICK), (M_2, -b * STICK)]) * meaning[omega_vec]
    yield Check(
        momentum,
        {**meaning, L_vec: tensor},
        reason="The inertia tensor (3.26) gives the same.",
        printed=False,
    )
    yield Check(in_plane, meaning, reason="L lies in the plane.", printed=False)
    tilted = (TILTED, TURNING, OBLIQUE)
    yield Check(not_parallel, meaning, tilted, "L is not parallel to ω.", printed=False)
    yield Check(
        turned, meaning, tilted, "Half a turn later the vector L would be another.", printed=False
    )
    yield Check(
        same_motion,
        {**meaning, omega_perp: before / moment},
        reason="Points on a line do not feel the part of ω along it: the constant "
        "ω⊥ = L/(M₁a² + M₂b²), which is parallel to L, moves them just so.",
        printed=False,
    )
    yield Check(
        told_apart,
        {**meaning, omega_perp: before / moment, r_1: a * STICK + delta * Matrix([1, 0, 0])},
        (
            TURNING,
            OBLIQUE,
            Assumption(
                Ne(delta, 0), "the stick has a thickness δ, so that it shows a turn about itself"
            ),
        ),
        "Only beside the line does the motion tell ω from ω⊥, so that it is ω that must change.",
        printed=False,
    )


page = Page(
    "3.2 (opening)",
    "Two masses on a stick",
    "Why a rotation axis that is not parallel to L can't stay where it is.",
    (two_mass_points,),
    text="opening",
)
