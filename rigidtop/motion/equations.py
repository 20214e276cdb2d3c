"""Right-hand sides of rigid-body motion, as derived.

Written by `python -m rigidtop.codegen` from `rigidtop.theory`: do not edit.

Each function takes the parameters once, in the order of its first line, and returns the rates as a
function of the state.  The numbers may be floats, NumPy arrays that broadcast, or symbols; where
angles occur, `sin` and `cos` are those of `math` unless others are given.  SI units and radians;
λ₁, λ₂, λ₃ are the moments of inertia about the pivot (for a free body, and for a top on a table,
about the centre of mass), and ω₁, ω₂, ω₃ are components in the body frame unless said otherwise.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

Number = Any  # a float, an array or a symbol
Function = Callable[[Number], Number]
Rates = Callable[[Sequence[Number]], tuple[Number, ...]]


def top_in_euler_angles(*parameters: Number, cos: Function = math.cos,
        sin: Function = math.sin) -> Rates:
    """θ̈, φ̈, ψ̈ of the heavy symmetric top: (3.54)-(3.56).  Singular where sin θ = 0.

    The state is (theta, thetadot, phidot, psidot).
    """
    lambda1, lambda3, M, g, R = parameters
    c0 = (lambda1 - lambda3)/lambda1
    c1 = M*R*g/lambda1
    c2 = lambda3/lambda1
    c3 = (2*lambda1 - lambda3)/lambda1

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        theta, thetadot, phidot, psidot = state
        x0 = sin(theta)
        x1 = c2*psidot
        x2 = cos(theta)
        x3 = thetadot/x0
        x4 = x1*x3
        x5 = phidot*x3
        return (
            c0*phidot**2*x0*x2 + c1*x0 - phidot*x0*x1,
            -c3*x2*x5 + x4,
            c0*x2**2*x5 - x2*x4 + x5,
        )

    return rates


def heavy_body(*parameters: Number) -> Rates:
    """q̇₀ … q̇₃, ω̇₁, ω̇₂, ω̇₃ of a heavy body about a pivot, centre of mass anywhere in it.

    The state is (q0, q1, q2, q3, omega1, omega2, omega3).
    """
    lambda1, lambda2, lambda3, M, g, R1, R2, R3 = parameters
    c0 = (lambda2 - lambda3)/lambda1
    c1 = M*R2*g/lambda1
    c2 = 2*M*R3*g/lambda1
    c3 = M*R1*g/lambda2
    c4 = (lambda1 - lambda3)/lambda2
    c5 = 2*M*R3*g/lambda2
    c6 = (lambda1 - lambda2)/lambda3
    c7 = 2*M*R1*g/lambda3
    c8 = 2*M*R2*g/lambda3

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        q0, q1, q2, q3, omega1, omega2, omega3 = state
        x0 = omega1/2
        x1 = q2/2
        x2 = q3/2
        x3 = omega2/2
        x4 = omega3/2
        x5 = q0*q1 + q2*q3
        x6 = 2*q1**2 + 2*q2**2 - 1
        x7 = q0*q2 - q1*q3
        return (
            -omega2*x1 - omega3*x2 - q1*x0,
            -omega2*x2 + omega3*x1 + q0*x0,
            q0*x3 - q1*x4 + q3*x0,
            q0*x4 + q1*x3 - q2*x0,
            c0*omega2*omega3 + c1*x6 + c2*x5,
            -c3*x6 - c4*omega1*omega3 + c5*x7,
            c6*omega1*omega2 - c7*x5 - c8*x7,
        )

    return rates


def heavy_top(*parameters: Number) -> Rates:
    """q̇₀ … q̇₃, ω̇₁, ω̇₂ of the symmetric top, in the frame that does not turn about e₃.

    The state is (q0, q1, q2, q3, omega1, omega2).
    """
    lambda1, lambda3, M, g, R, omega3 = parameters
    c0 = lambda3*omega3/lambda1
    c1 = 2*M*R*g/lambda1

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        q0, q1, q2, q3, omega1, omega2 = state
        x0 = omega1/2
        x1 = omega2/2
        return (
            -q1*x0 - q2*x1,
            q0*x0 - q3*x1,
            q0*x1 + q3*x0,
            omega2*q1/2 - q2*x0,
            -c0*omega2 + c1*(q0*q1 + q2*q3),
            c0*omega1 + c1*(q0*q2 - q1*q3),
        )

    return rates


def top_by_routh(*parameters: Number, cos: Function = math.cos,
        sin: Function = math.sin) -> Rates:
    """θ̈, φ̇, ψ̇ of the heavy symmetric top from its Routhian.  Singular where sin θ = 0.

    The state is (theta).
    """
    lambda1, lambda3, M, g, R, p_phi, p_psi = parameters
    c0 = 1/lambda1
    c1 = M*R*g
    c2 = p_psi/lambda1
    c3 = p_psi/lambda3

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        (theta,) = state
        x0 = sin(theta)
        x1 = cos(theta)
        x2 = p_phi - p_psi*x1
        x3 = c0*x2/x0**2
        return (
            c0*(c0*x1*x2**2/x0**3 + c1*x0 - c2*x2/x0),
            x3,
            c3 - x1*x3,
        )

    return rates


def top_by_hamilton(*parameters: Number, cos: Function = math.cos,
        sin: Function = math.sin) -> Rates:
    """θ̇, φ̇, ψ̇, ṗ_θ of the heavy symmetric top: Hamilton's equations, singular at sin θ = 0.

    The state is (theta, p_theta).
    """
    lambda1, lambda3, M, g, R, p_phi, p_psi = parameters
    c0 = 1/lambda1
    c1 = p_psi/lambda3
    c2 = M*R*g
    c3 = p_psi/lambda1

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        theta, p_theta = state
        x0 = sin(theta)
        x1 = cos(theta)
        x2 = p_phi - p_psi*x1
        x3 = c0*x2/x0**2
        return (
            c0*p_theta,
            x3,
            c1 - x1*x3,
            c0*x1*x2**2/x0**3 + c2*x0 - c3*x2/x0,
        )

    return rates


def body_in_euler_angles(*parameters: Number, cos: Function = math.cos,
        sin: Function = math.sin) -> Rates:
    """θ̈, φ̈, ψ̈ of a heavy body about a pivot: Lagrange's equations, singular at sin θ = 0.

    The state is (theta, psi, thetadot, phidot, psidot).
    """
    lambda1, lambda2, lambda3, M, g, R1, R2, R3 = parameters
    c0 = (lambda1 - lambda2 + lambda3)/lambda1
    c1 = M*R3*g/lambda1
    c2 = (lambda2 - lambda3)/lambda1
    c3 = M*R1*g/lambda2
    c4 = M*R3*g*(lambda1 - lambda2)/(lambda1*lambda2)
    c5 = (lambda1 - lambda2)*(lambda1 + lambda2 - lambda3)/(lambda1*lambda2)
    c6 = M*R2*g/lambda1
    c7 = (lambda1 - lambda2 - lambda3)/lambda2
    c8 = (lambda1 + lambda2 - lambda3)/lambda2
    c9 = (lambda1 - lambda2 + lambda3)/lambda3
    c10 = (lambda2 - lambda3)*(lambda1 - lambda2 - lambda3)/(lambda2*lambda3)
    c11 = (lambda1 - lambda2)/lambda3
    c12 = M*R1*g/lambda3
    c13 = M*R2*g/lambda3
    c14 = M*R1*g*(lambda2 - lambda3)/(lambda2*lambda3)
    c15 = M*R2*g*(lambda1 - lambda3)/(lambda1*lambda3)
    c16 = ((lambda1 - lambda2)*(2*lambda1*lambda2 - lambda1*lambda3 - lambda2*lambda3 + lambda3**2)/
        (lambda1*lambda2*lambda3))
    c17 = (lambda1 - lambda2)*(lambda1 - lambda3)*(lambda2 - lambda3)/(lambda1*lambda2*lambda3)

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        theta, psi, thetadot, phidot, psidot = state
        x0 = sin(theta)
        x1 = cos(psi)
        x2 = cos(theta)
        x3 = x1*x2
        x4 = sin(psi)
        x5 = x2*x4
        x6 = phidot*psidot*x0
        x7 = phidot**2
        x8 = x0*x7
        x9 = thetadot*x4
        x10 = phidot*x2
        x11 = c5*x1
        x12 = 1/x0
        x13 = thetadot*x12
        x14 = c7*psidot*x13
        x15 = x12*x5
        x16 = x12*x3
        x17 = x2**2
        x18 = x17 - 1
        x19 = 1/x0**2
        x20 = c4*x19*x4
        x21 = thetadot*x1
        x22 = x12*x4
        x23 = phidot*x22
        x24 = psidot*x23
        x25 = x22*x7
        x26 = phidot*x13
        x27 = x1*x12
        x28 = x17*x27
        x29 = x21 + x23
        x30 = thetadot**2
        return (
            -c0*x6 + c1*x0 + c2*x2*x8 + c3*x3 + c4*x0*x1**2 - c6*x5 + x11*(-psidot*x9 + x1*x6 - x10*
                x9 + x3*x8),
            c3*x15 + c6*x16 - c8*x10*x13 - x1*x18*x20 + x11*x12*(psidot*x21 + x10*x21 + x15*x7 -
                x17*x24 - x2**3*x25 + x24) - x14,
            -c10*x17*x26 + c11*x27*(-2*phidot*x21 + x12*x30*x4 - x17*x22*x30 - x25) - c12*x22 - c13*
                x27 + c14*x17*x22 + c15*x28 + c16*phidot*x28*x29 - c17*x1*x19*x2**4*x4*x7 + c5*
                psidot*x16*(phidot*x12*x17*x4 - x29) + c9*x26 + x14*x2 + x18*x20*x3,
        )

    return rates


def body_by_hamilton(*parameters: Number, cos: Function = math.cos,
        sin: Function = math.sin) -> Rates:
    """θ̇, φ̇, ψ̇, ṗ_θ, ṗ_ψ of a heavy body: Hamilton's equations, singular at sin θ = 0.

    The state is (theta, psi, p_theta, p_psi).
    """
    lambda1, lambda2, lambda3, M, g, R1, R2, R3, p_phi = parameters
    c0 = 1/lambda1
    c1 = 1/lambda2
    c2 = 1/lambda3
    c3 = M*g

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        theta, psi, p_theta, p_psi = state
        x0 = sin(psi)
        x1 = cos(psi)
        x2 = sin(theta)
        x3 = 1/x2
        x4 = cos(theta)
        x5 = -p_phi + p_psi*x4
        x6 = x3*x5
        x7 = p_theta*x0 + x1*x6
        x8 = c0*x7
        x9 = p_theta*x1 - x0*x6
        x10 = c1*x9
        x11 = x1*x8
        x12 = x3*x4
        x13 = x0*x10
        x14 = p_psi + x4*x5/x2**2
        return (
            x0*x8 + x1*x10,
            x3*(c1*x0*x9 - x11),
            c2*p_psi + x11*x12 - x12*x13,
            c0*x1*x14*x7 - c3*(-R1*x1*x4 + R2*x0*x4 - R3*x2) - x13*x14,
            c1*x7*x9 - c3*x2*(R1*x0 + R2*x1) - x8*x9,
        )

    return rates


def contact_kinematics(*parameters: Number) -> Rates:
    """Of a top on a table e₃, the velocity of its centre of mass, and a (see `theory.sliding`).

    The state is (q0, q1, q2, q3, omega1, omega2, omega3, v_x, v_y).
    """
    lambda1, lambda3, M, g, R, tip, drag, drag1, drag3 = parameters
    c0 = R
    c1 = 2*tip
    c2 = 2*R - 2*tip
    c3 = 2*R - 4*tip
    c4 = (R*lambda3 - lambda1*tip)/lambda1
    c5 = drag/M
    c6 = R*(M*drag1 - drag*lambda1)/(M*lambda1)
    c7 = 2*tip*(lambda1 - lambda3)/lambda1
    c8 = 2*(R - tip)*(M*drag1 - drag*lambda1)/(M*lambda1)
    c9 = 2*tip*(M*drag1 - drag*lambda1)/(M*lambda1)
    c10 = 2*(R*lambda3 + lambda1*tip - 2*lambda3*tip)/lambda1
    c11 = 2*(R - 2*tip)*(M*drag1 - drag*lambda1)/(M*lambda1)
    c12 = 2*tip*(M*drag3 - drag*lambda3)/(M*lambda3)
    c13 = 2*lambda3*(R - tip)/lambda1
    c14 = g
    c15 = R - tip

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        q0, q1, q2, q3, omega1, omega2, omega3, v_x, v_y = state
        x0 = q0*q2
        x1 = q1*q3
        x2 = q0*q1
        x3 = q1**2
        x4 = 2*x3
        x5 = q2**2
        x6 = 2*x5
        x7 = q1*q2
        x8 = c3*x7
        x9 = omega2*x5
        x10 = 2*q0*q3
        x11 = 2*q3**2
        x12 = omega1*x10 - omega2*x11 + omega2
        x13 = omega2*x3
        x14 = omega1*x3
        x15 = omega1*x11 - omega1 + omega2*x10
        x16 = q2*q3
        x17 = -omega1*x16 - omega1*x2 + omega2*q1*q3 - omega2*x0
        x18 = c11*x7
        x19 = c10*omega3*x7
        x20 = c7*omega3
        x21 = omega1**2
        x22 = omega2**2
        x23 = c13*omega3
        return (
            2*x0 + 2*x1,
            2*q2*q3 - 2*x2,
            -x4 - x6 + 1,
            c0*x12 + c1*(omega3*q2*q3 - omega3*x2 - x13) - c2*x9 - omega1*x8 + v_x,
            c0*x15 + c1*(omega1*x5 - omega3*x0 - omega3*x1) + c2*x14 + omega2*x8 + v_y,
            c2*x17,
            c12*omega3*(q2*q3 - x2) + c13*omega1*omega3*x5 + c2*(x0*x21 + x0*x22 + x1*x21 + x1*
                x22) + c4*omega3*x15 - c5*v_x + c6*x12 - c8*x9 - c9*x13 - omega1*x18 - omega2*x19 -
                x14*x20,
            -c12*omega3*(x0 + x1) + c2*(q2*q3*x21 + q2*q3*x22 - x2*x21 - x2*x22) - c4*omega3*x12 -
                c5*v_y + c6*x15 + c8*x14 + c9*omega1*x5 - omega1*x19 + omega2*x18 + x13*x23 - x20*
                x9,
            -c14 + c15*(-x21*x4 - x21*x6 + x21 - x22*x4 - x22*x6 + x22) + c8*x17 + x23*(omega1*q0*
                q2 - omega1*x1 - omega2*x16 - omega2*x2),
        )

    return rates


def sliding_force(*parameters: Number) -> Rates:
    """F_x, F_y, N of a tip that slides in the direction d, v̇, and by what N was divided.

    The state is (e_x, e_y, e_z, v_x, v_y, d_x, d_y, a_x, a_y, a_z).
    """
    lambda1, lambda3, M, R, tip, mu, viscosity = parameters
    c0 = 1/M
    c1 = 1/lambda1
    c2 = (-R + tip)**2
    c3 = mu*(-R + tip)/lambda1
    c4 = R - tip
    c5 = viscosity*(-R + tip)/lambda1
    c6 = tip**2*(1/lambda3 - 1/lambda1)
    c7 = (-R + tip)**2/lambda1
    c8 = (-R + tip)/lambda1

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        e_x, e_y, e_z, v_x, v_y, d_x, d_y, a_x, a_y, a_z = state
        x0 = c4*e_z + tip
        x1 = e_x*x0
        x2 = -x0
        x3 = e_y*x2
        x4 = e_x**2
        x5 = c2*x4
        x6 = e_y**2
        x7 = c2*x6
        x8 = c0 + c1*(x5 + x7) - c3*d_x*x1 + c3*d_y*x3
        x9 = (a_z - c5*v_x*x1 + c5*v_y*x3)/x8
        x10 = mu*x9
        x11 = d_x*x10 - v_x*viscosity
        x12 = d_y*x10 - v_y*viscosity
        x13 = c8*x9
        x14 = e_x*e_y
        x15 = -c6*x14 - c7*x14
        return (
            x11,
            x12,
            -x9,
            a_x - x1*x13 + x11*(c0 + c1*(x0**2 + x7) + c6*x6) + x12*x15,
            a_y + x11*x15 + x12*(c0 + c1*(x2**2 + x5) + c6*x4) + x13*x3,
            M*x8,
        )

    return rates


def rolling_force(*parameters: Number) -> Rates:
    """F_x, F_y, N that let the point of contact rest.

    The state is (e_x, e_y, e_z, a_x, a_y, a_z).
    """
    lambda1, lambda3, M, R, tip = parameters
    c0 = tip**2*(1/lambda3 - 1/lambda1)
    c1 = (-R + tip)**2/lambda1
    c2 = 1/M
    c3 = 1/lambda1
    c4 = (-R + tip)**2
    c5 = R - tip
    c6 = (-R + tip)**2/lambda1**2
    c7 = 2*(-R + tip)**2/lambda1**2
    c8 = (-R + tip)/lambda1

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        e_x, e_y, e_z, a_x, a_y, a_z = state
        x0 = c5*e_z + tip
        x1 = -x0
        x2 = e_x*e_y
        x3 = x0*x2
        x4 = -c0*x2 - c1*x2
        x5 = e_x**2
        x6 = c4*x5
        x7 = e_y**2
        x8 = c4*x7
        x9 = c2 + c3*(x6 + x8)
        x10 = c6*x1*x3 + x4*x9
        x11 = x1*x4
        x12 = c8*e_y
        x13 = x1**2
        x14 = c0*x5 + c2 + c3*(x13 + x6)
        x15 = c8*e_x*x0
        x16 = x11*x12 + x14*x15
        x17 = c6*x13*x7
        x18 = x4**2
        x19 = x0**2
        x20 = c6*x19*x5
        x21 = c0*x7 + c2 + c3*(x19 + x8)
        x22 = 1/(-c7*x11*x3 - x14*x20 + x14*x21*x9 - x17*x21 - x18*x9)
        x23 = -x1*x12*x21 - x15*x4
        return (
            x22*(a_x*(-x14*x9 + x17) + a_y*x10 + a_z*x16),
            x22*(a_x*x10 + a_y*(x20 - x21*x9) + a_z*x23),
            x22*(a_x*x16 + a_y*x23 + a_z*(-x14*x21 + x18)),
        )

    return rates


def sliding_top(*parameters: Number) -> Rates:
    """Rates of q₀ … q₃, ω and what friction and air dissipate, from the contact force.

    The state is (q0, q1, q2, q3, omega1, omega2, omega3, v_x, v_y, V_x, V_y, V_z, F_x, F_y, N).
    """
    lambda1, lambda3, R, tip, drag, drag1, drag3 = parameters
    c0 = R/lambda1
    c1 = drag1/lambda1
    c2 = lambda3/lambda1
    c3 = 2*tip/lambda1
    c4 = 2*(R - tip)/lambda1
    c5 = 2*(R - 2*tip)/lambda1
    c6 = drag3/lambda3
    c7 = 2*tip/lambda3
    c8 = drag
    c9 = drag1
    c10 = drag3

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        q0, q1, q2, q3, omega1, omega2, omega3, v_x, v_y, V_x, V_y, V_z, F_x, F_y, N = state
        x0 = omega1/2
        x1 = omega2/2
        x2 = c2*omega3
        x3 = F_x*q2
        x4 = q2**2
        x5 = F_x*q0
        x6 = 2*q3
        x7 = q3**2
        x8 = N*q0
        x9 = N*q3
        x10 = q1**2
        x11 = F_y*q1
        x12 = F_y*q0
        return (
            -q1*x0 - q2*x1,
            q0*x0 - q3*x1,
            q0*x1 + q3*x0,
            omega2*q1/2 - q2*x0,
            -F_y*c3*x4 + c0*(-2*F_y*x7 + F_y - x5*x6) - c1*omega1 + c4*(-F_y*x10 + q1*x8 + q2*x9) +
                c5*q1*x3 - omega2*x2,
            F_x*c3*x10 + c0*(2*F_x*x7 - F_x - x12*x6) - c1*omega2 + c4*(F_x*x4 - q1*x9 + q2*x8) -
                c5*q2*x11 + omega1*x2,
            -c6*omega3 + c7*(q1*x5 + q2*x12 + q3*x11 - q3*x3),
            -F_x*v_x - F_y*v_y,
            c10*omega3**2 + c8*(V_x**2 + V_y**2 + V_z**2) + c9*(omega1**2 + omega2**2),
        )

    return rates
