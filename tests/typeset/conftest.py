"""The equations of the notes as they are printed there, typed by hand."""

import pytest
from sympy import Matrix, Rational, cos, sin, symbols

from rigidtop.proof.equation import (
    Cross,
    Dot,
    Equation,
    Group,
    Rate,
    SumOver,
    Transposed,
    Underbrace,
    VolumeIntegral,
    as_printed,
)
from rigidtop.theory.symbols import (
    L3,
    R_CM,
    F_grav,
    F_k,
    L_vec,
    L_vecdot,
    L_z,
    Lagrangian,
    M,
    N_ext,
    O_matrix,
    Omega,
    Omega_b,
    Omega_vec,
    R,
    T,
    const,
    e1p,
    e2p,
    e3,
    e3dot,
    f_r,
    g,
    inertia,
    lambda1,
    lambda2,
    lambda3,
    omega1,
    omega1dot,
    omega1p,
    omega2,
    omega2dot,
    omega3,
    omega_0,
    omega_vec,
    p_phi,
    phidot,
    psidot,
    r_k,
    r_vec,
    r_vecp,
    rho,
    t,
    theta,
    thetaddot,
    thetadot,
    zhat,
)


def _printed() -> dict[str, Equation]:
    k, d3r = symbols("k d3r")
    space, body = symbols("space body")
    c_phi, c_theta, c_psi = symbols("c_phi c_theta c_psi")
    s_phi, s_theta, s_psi = symbols("s_phi s_theta s_psi")
    with as_printed():
        spin = psidot + phidot * cos(theta)
        kinetic = (
            Rational(1, 2) * lambda1 * (phidot**2 * sin(theta) ** 2 + thetadot**2)
            + Rational(1, 2) * lambda3 * (psidot + phidot * cos(theta)) ** 2
        )
        content = VolumeIntegral(d3r, rho * r_vec)
        rate = (lambda1 - lambda3) * omega3 / lambda1
        equations = [
            Equation(0, L_vecdot, Rate(inertia * omega_vec), tag="3.33"),
            Equation(r_vecp, Transposed(O_matrix) * r_vec, tag="3.34"),
            Equation(
                0,
                Rate(L_vec, space),
                Rate(L_vec, body) + Cross(omega_vec, L_vec),
                tag="3.35",
            ),
            Equation(lambda1 * omega1dot, (lambda2 - lambda3) * omega2 * omega3, tag="3.36"),
            Equation(omega1dot, Underbrace(rate, Omega_b) * omega2, Omega_b * omega2, tag="3.37"),
            Equation(omega2dot, -rate * omega1, -Omega_b * omega1, tag="3.37b"),
            Equation(
                omega_vec,
                Transposed(
                    Matrix([[omega_0 * cos(Omega_b * t), -omega_0 * sin(Omega_b * t), omega3]])
                ),
                tag="3.38",
            ),
            Equation(
                omega_vec,
                Underbrace(Group(-phidot * sin(theta)), omega1p) * e1p + thetadot * e2p + spin * e3,
                tag="3.42",
            ),
            Equation(T, Rational(1, 2) * Dot(omega_vec, L_vec), kinetic, tag="3.44"),
            Equation(phidot, (L_z - L3 * cos(theta)) / (lambda1 * sin(theta) ** 2), tag="3.45"),
            Equation(
                Transposed(O_matrix),
                Matrix(
                    [
                        [
                            c_phi * c_theta * c_psi - s_phi * s_psi,
                            -c_psi * s_phi - c_phi * c_theta * s_psi,
                            c_phi * s_theta,
                        ],
                        [
                            c_phi * s_psi + c_theta * c_psi * s_phi,
                            c_phi * c_psi - c_theta * s_phi * s_psi,
                            s_phi * s_theta,
                        ],
                        [-c_psi * s_theta, s_theta * s_psi, c_theta],
                    ]
                ),
                tag="3.47",
            ),
            Equation(
                N_ext,
                SumOver(k, Cross(r_k, F_k)),
                VolumeIntegral(d3r, Cross(r_vec, f_r)),
                tag="3.48",
            ),
            Equation(
                N_ext,
                -g * VolumeIntegral(d3r, rho * Cross(r_vec, zhat)),
                -g * Cross(content, zhat),
                -g * M * Cross(Group(content) / M, zhat),
                -g * M * Cross(R_CM, zhat),
                Cross(R_CM, Underbrace(F_grav, -g * M * zhat)),
                tag="3.49",
            ),
            Equation(
                e3dot,
                M * g * R / (lambda3 * omega3) * Cross(zhat, e3),
                Cross(Omega_vec, e3),
                tag="3.51",
            ),
            Equation(Lagrangian, kinetic - M * g * R * cos(theta), tag="3.53"),
            Equation(
                lambda1 * thetaddot,
                lambda1 * phidot**2 * sin(theta) * cos(theta)
                - lambda3 * spin * phidot * sin(theta)
                + M * g * R * sin(theta),
                tag="3.54",
            ),
            Equation(
                p_phi,
                lambda1 * phidot * sin(theta) ** 2 + lambda3 * spin * cos(theta),
                const,
                tag="3.55",
            ),
            Equation(
                0,
                lambda1 * phidot**2 * sin(theta) * cos(theta)
                - lambda3 * spin * phidot * sin(theta)
                + M * g * R * sin(theta),
                tag="3.57a",
            ),
            Equation(
                0,
                lambda1 * Omega**2 * cos(theta)
                - lambda3 * Underbrace(Group(spin), omega3) * Omega
                + M * g * R,
                tag="3.57b",
            ),
            Equation(
                0,
                Group(lambda1 * cos(theta)) * Omega**2
                - Group(lambda3 * omega3) * Omega
                + M * g * R,
                tag="3.57",
            ),
        ]
    return {equation.tag: equation for equation in equations}


@pytest.fixture(scope="session")
def printed() -> dict[str, Equation]:
    """By number; "3.57a" and "3.57b" are the lines above (3.57)."""
    return _printed()
