"""Right-hand sides of rigid-body motion, as derived.

Written by `python -m rigidtop.codegen` from `rigidtop.theory`: do not edit.

Each function takes the parameters once and returns the rates as a function of the state.  The
numbers may be floats, NumPy arrays that broadcast, or symbols; where angles occur, `sin` and `cos`
are those of `math` unless others are given.  SI units and radians; λ₁, λ₂, λ₃ are the moments of
inertia about the pivot (for a free body about the centre of mass), and ω₁, ω₂, ω₃ are components
in the body frame unless said otherwise.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

Number = Any  # a float, an array or a symbol
Rates = Callable[[Sequence[Number]], tuple[Number, ...]]


def free_body(lambda1: Number, lambda2: Number, lambda3: Number) -> Rates:
    """ω̇₁, ω̇₂, ω̇₃ of a free body: Euler's equations (3.36).

    The state is (omega1, omega2, omega3).
    """
    c0 = (lambda2 - lambda3) / lambda1
    c1 = (lambda1 - lambda3) / lambda2
    c2 = (lambda1 - lambda2) / lambda3

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        omega1, omega2, omega3 = state
        return (
            c0 * omega2 * omega3,
            -c1 * omega1 * omega3,
            c2 * omega1 * omega2,
        )

    return rates


def top_in_euler_angles(
    lambda1: Number,
    lambda3: Number,
    M: Number,
    g: Number,
    R: Number,
    *,
    cos: Callable[[Any], Any] = math.cos,
    sin: Callable[[Any], Any] = math.sin,
) -> Rates:
    """θ̈, φ̈, ψ̈ of the heavy symmetric top: (3.54)-(3.56).  Singular where sin θ = 0.

    The state is (theta, thetadot, phidot, psidot).
    """
    c0 = (lambda1 - lambda3) / lambda1
    c1 = M * R * g / lambda1
    c2 = lambda3 / lambda1
    c3 = (2 * lambda1 - lambda3) / lambda1

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        theta, thetadot, phidot, psidot = state
        x0 = sin(theta)
        x1 = c2 * psidot
        x2 = cos(theta)
        x3 = thetadot / x0
        x4 = x1 * x3
        x5 = phidot * x3
        return (
            c0 * phidot**2 * x0 * x2 + c1 * x0 - phidot * x0 * x1,
            -c3 * x2 * x5 + x4,
            c0 * x2**2 * x5 - x2 * x4 + x5,
        )

    return rates


def heavy_body(
    lambda1: Number,
    lambda2: Number,
    lambda3: Number,
    M: Number,
    g: Number,
    R1: Number,
    R2: Number,
    R3: Number,
) -> Rates:
    """q̇₀ … q̇₃, ω̇₁, ω̇₂, ω̇₃ of a heavy body about a pivot, centre of mass anywhere in it.

    The state is (q0, q1, q2, q3, omega1, omega2, omega3).
    """
    c0 = (lambda2 - lambda3) / lambda1
    c1 = M * R2 * g / lambda1
    c2 = 2 * M * R3 * g / lambda1
    c3 = M * R1 * g / lambda2
    c4 = (lambda1 - lambda3) / lambda2
    c5 = 2 * M * R3 * g / lambda2
    c6 = (lambda1 - lambda2) / lambda3
    c7 = 2 * M * R1 * g / lambda3
    c8 = 2 * M * R2 * g / lambda3

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        q0, q1, q2, q3, omega1, omega2, omega3 = state
        x0 = omega1 / 2
        x1 = q2 / 2
        x2 = q3 / 2
        x3 = omega2 / 2
        x4 = omega3 / 2
        x5 = q0 * q1 + q2 * q3
        x6 = 2 * q1**2 + 2 * q2**2 - 1
        x7 = q0 * q2 - q1 * q3
        return (
            -omega2 * x1 - omega3 * x2 - q1 * x0,
            -omega2 * x2 + omega3 * x1 + q0 * x0,
            q0 * x3 - q1 * x4 + q3 * x0,
            q0 * x4 + q1 * x3 - q2 * x0,
            c0 * omega2 * omega3 + c1 * x6 + c2 * x5,
            -c3 * x6 - c4 * omega1 * omega3 + c5 * x7,
            c6 * omega1 * omega2 - c7 * x5 - c8 * x7,
        )

    return rates


def heavy_top(
    lambda1: Number, lambda3: Number, M: Number, g: Number, R: Number, omega3: Number
) -> Rates:
    """q̇₀ … q̇₃, ω̇₁, ω̇₂ of the symmetric top, in the frame that does not turn about e₃.

    The state is (q0, q1, q2, q3, omega1, omega2).
    """
    c0 = lambda3 * omega3 / lambda1
    c1 = 2 * M * R * g / lambda1

    def rates(state: Sequence[Number]) -> tuple[Number, ...]:
        q0, q1, q2, q3, omega1, omega2 = state
        x0 = omega1 / 2
        x1 = omega2 / 2
        return (
            -q1 * x0 - q2 * x1,
            q0 * x0 - q3 * x1,
            q0 * x1 + q3 * x0,
            omega2 * q1 / 2 - q2 * x0,
            -c0 * omega2 + c1 * (q0 * q1 + q2 * q3),
            c0 * omega1 + c1 * (q0 * q2 - q1 * q3),
        )

    return rates
