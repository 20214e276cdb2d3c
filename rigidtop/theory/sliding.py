"""A symmetric top with a round tip that slides or rolls on a horizontal table.

Here λ₁ = λ₂ and λ₃ are moments about the **centre of mass**, not about a pivot: there is none.  R
is the distance of the centre of mass from the lowest point of the upright top, the tip is part of
a sphere of radius r (`tip`) whose centre lies on the axis, at R − r below the centre of mass (above
it where r > R).  The point of the top that touches the table is then at

    ρ = −(R − r) e₃ − r ẑ

from the centre of mass, which is at the height r + (R − r) cos θ.  Newton's law moves the centre of
mass and Euler's equations turn the top about it, both by the contact force (F_x, F_y, N), the
weight, and the drag of the air: −c V on the centre of mass, −(c₁ω₁, c₁ω₂, c₃ω₃) about it.

What moves is written with the **slip** v, the velocity of the material point that touches the
table, in place of the velocity V of the centre of mass: V = v − ω × ρ.  Rolling is v = 0, exactly.
The components of ω are those in a frame that follows e₃ without turning about it, so that a fast
spin is no fast motion; every vector else has space components.

Without contact force the point of contact would accelerate by a (`free_slip`); the contact force C
adds W C with the mobility W (`mobility`).  This is all that the law of contact needs:

    sliding   F = −(μN/|v| + γ) v,  and N from  ẑ·(a + W C) = 0
    rolling   C from  a + W C = 0,  as long as |F| ≤ μN
"""

from __future__ import annotations

from functools import cache

import sympy
from sympy import ImmutableMatrix, Matrix, eye

from rigidtop.theory import symbols as s
from rigidtop.theory.euler import OMEGA, body_accelerations
from rigidtop.theory.lettered import real
from rigidtop.theory.rotation import Z_AXIS, hat, quaternion_matrix, quaternion_rates
from rigidtop.theory.symbols import Glyph
from rigidtop.theory.top import QUATERNION, body_accelerations_with

tip = real("tip", Glyph("r"), "radius of the round tip", "m")
viscosity = real("viscosity", Glyph("γ"), "viscous friction force over the slip", "N s/m")
drag = real("drag", Glyph("c"), "drag force over the velocity of the centre of mass", "N s/m")
drag1 = real("drag1", Glyph("c", "1"), "drag torque across e₃ over ω₁ or ω₂", "J s")
drag3 = real("drag3", Glyph("c", "3"), "drag torque along e₃ over ω₃", "J s")
V_x = real("V_x", Glyph("V", "x"), "velocity of the centre of mass along x̂", "m/s")
V_y = real("V_y", Glyph("V", "y"), "velocity of the centre of mass along ŷ", "m/s")
V_z = real("V_z", Glyph("V", "z"), "velocity of the centre of mass along ẑ", "m/s")
v_x = real("v_x", Glyph("v", "x"), "slip along x̂", "m/s")
v_y = real("v_y", Glyph("v", "y"), "slip along ŷ", "m/s")
e_x = real("e_x", Glyph("e", "x"), "component of e₃ along x̂", "1")
e_y = real("e_y", Glyph("e", "y"), "component of e₃ along ŷ", "1")
e_z = real("e_z", Glyph("e", "z"), "component of e₃ along ẑ: cos θ", "1")
d_x = real("d_x", Glyph("d", "x"), "direction of the slip along x̂", "1")
d_y = real("d_y", Glyph("d", "y"), "direction of the slip along ŷ", "1")
a_x = real("a_x", Glyph("a", "x"), "slip's rate along x̂ without contact force", "m/s²")
a_y = real("a_y", Glyph("a", "y"), "slip's rate along ŷ without contact force", "m/s²")
a_z = real("a_z", Glyph("a", "z"), "slip's rate along ẑ without contact force", "m/s²")
F_x = real("F_x", Glyph("F", "x"), "friction force along x̂", "N")
F_y = real("F_y", Glyph("F", "y"), "friction force along ŷ", "N")
N = real("N", Glyph("N"), "normal force of the table", "N")

SLIP = (v_x, v_y)
AXIS = (e_x, e_y, e_z)
DIRECTION = (d_x, d_y)
VELOCITY = (V_x, V_y, V_z)
FREE_SLIP = (a_x, a_y, a_z)
CONTACT_FORCE = (F_x, F_y, N)
CENTRE_ABOVE_TIP = s.R - tip

_SYMMETRIC = {s.lambda2: s.lambda1}


def attitude() -> Matrix:
    """The rotation (3×3) from the frame that follows e₃ to space components."""
    return quaternion_matrix(Matrix(QUATERNION))


def arm(axis: Matrix) -> Matrix:
    """ρ, from the centre of mass to the point of contact, of e₃ in space components (3×1, m)."""
    return -CENTRE_ABOVE_TIP * axis - tip * Matrix(Z_AXIS)


def drag_torque() -> Matrix:
    """−(c₁ω₁, c₁ω₂, c₃ω₃) (3×1, N m)."""
    return -Matrix([drag1 * s.omega1, drag1 * s.omega2, drag3 * s.omega3])


@cache
def kinematics() -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """e₃ and the velocity V of the centre of mass, of q, ω and the slip (3×1 each, space).

    V = v − ω × ρ; its last component is the rate of r + (R − r) cos θ.
    """
    frame, omega = attitude(), Matrix(OMEGA)
    axis = frame * Matrix(Z_AXIS)
    # ω × ρ term by term, so that no product of two rotated vectors is multiplied out.
    axis_rate = frame * omega.cross(Z_AXIS)
    about_vertical = (frame * omega).cross(Z_AXIS)
    velocity = Matrix([*SLIP, 0]) + CENTRE_ABOVE_TIP * axis_rate + tip * about_vertical
    return ImmutableMatrix(axis), ImmutableMatrix(velocity)


@cache
def free_slip() -> ImmutableMatrix:
    """a = d/dt (V + ω × ρ) where no contact force acts (3×1, space, m/s²).

    That is −gẑ − cV/M + ω̇ × ρ + ω × ρ̇ with ω̇ from Euler's equations and ρ̇ = −(R − r) ω × e₃.
    """
    frame, omega = attitude(), Matrix(OMEGA)
    turning = body_accelerations(drag_torque()).subs(_SYMMETRIC)
    of_axis = turning.cross(Z_AXIS) + omega.cross(omega.cross(Z_AXIS))
    velocity = Matrix(VELOCITY)
    return ImmutableMatrix(
        -s.g * Matrix(Z_AXIS)
        - drag / s.M * velocity
        - CENTRE_ABOVE_TIP * (frame * of_axis)
        - tip * (frame * turning).cross(Z_AXIS)
    )


@cache
def mobility() -> ImmutableMatrix:
    """W: a contact force C changes the slip at the rate W C (3×3, space, 1/kg).

    C/M moves the centre of mass, and I⁻¹(ρ × C) × ρ turns the point of contact about it.
    """
    axis = Matrix(AXIS)
    rho = arm(axis)
    # I⁻¹ is 1/λ₁ but for e₃, and ρ × e₃ is short.
    across = rho.cross(axis).applyfunc(sympy.expand)
    of_spin = (1 / s.lambda3 - 1 / s.lambda1) * (across * across.T)
    return ImmutableMatrix(eye(3) / s.M + hat(rho) * hat(rho).T / s.lambda1 + of_spin)


@cache
def sliding_force() -> ImmutableMatrix:
    """F_x, F_y, N of a tip that slides, v̇_x, v̇_y, and what N was divided by, times M (6×1).

    F = −μN d − γ v with the direction d of the slip v.  N keeps the contact on the table:
    ẑ·(a + W C) = 0, which is linear in N.  Where its coefficient is not positive, no normal force
    does that (Painlevé).
    """
    friction = [-s.mu * N * d - viscosity * v for d, v in zip(DIRECTION, SLIP, strict=True)]
    balance = a_z + (mobility()[2, :] * Matrix([*friction, N]))[0]
    coefficient = s.M * balance.diff(N)
    normal = -s.M * balance.subs(N, 0) / coefficient
    force = [*(f.subs(N, normal) for f in friction), normal]
    slipping = Matrix(FREE_SLIP) + mobility() * Matrix(force)
    return ImmutableMatrix([*force, *slipping[:2], coefficient])


@cache
def rolling_force() -> ImmutableMatrix:
    """F_x, F_y, N that hold the point of contact: a + W C = 0 solved for C (3×1, N)."""
    names = ImmutableMatrix(3, 3, sympy.symbols("W:9"))
    solved = -names.adjugate() * Matrix(FREE_SLIP) / names.det()
    values = dict(zip(names, mobility(), strict=True))
    return ImmutableMatrix(solved.subs(values))


@cache
def rates() -> ImmutableMatrix:
    """The rates of q₀ … q₃, ω₁, ω₂, ω₃ and of what friction and air dissipate (9×1).

    Of the contact force and the velocities.  The last two are −F·v and cV² + c₁(ω₁² + ω₂²) + c₃ω₃²
    (W).
    """
    q, omega, force = Matrix(QUATERNION), Matrix(OMEGA), Matrix(CONTACT_FORCE)
    frame = attitude()
    # ρ × C in the frame, each of its two parts turned but once.
    of_axis = CENTRE_ABOVE_TIP * Matrix(Z_AXIS).cross(frame.T * force)
    of_tip = tip * (frame.T * Matrix(Z_AXIS).cross(force))
    turning = body_accelerations_with(drag_torque() - of_axis - of_tip).subs(_SYMMETRIC)
    # The frame turns by −ω₃ about e₃ against the body.
    turning += s.omega3 * Matrix([-s.omega2, s.omega1, 0])
    velocity = Matrix(VELOCITY)
    of_air = drag * velocity.dot(velocity) - omega.dot(drag_torque())
    return ImmutableMatrix(
        [
            *quaternion_rates(q, Matrix([s.omega1, s.omega2, 0])),
            *turning,
            -(F_x * v_x + F_y * v_y),
            of_air,
        ]
    )
