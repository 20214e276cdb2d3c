"""What the letters of the lecture are: numbers, coordinates with their rates, vectors, frames."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from sympy import Expr, Integer, Symbol

from rigidtop.notation import MATRICES
from rigidtop.proof.letters import Letters
from rigidtop.theory import symbols as s

_ROWS = s.VOCABULARY.items()
_K, _L, _PLACE = map(Symbol, ("k", "l", "d3r"))
_AXES = (s.e1, s.e2, s.e3)


def is_a_body(point: Mapping[Symbol, Expr]) -> bool:
    """Whether there is one with the moments, mass and arm of a point, as far as they are there."""
    return _exists(*(point.get(x) for x in (s.lambda1, s.lambda2, s.lambda3, s.M, s.R)))


@lru_cache(maxsize=10_000)
def _exists(
    first: Expr | None, second: Expr | None, third: Expr | None, M: Expr | None, R: Expr | None
) -> bool:
    """The triangle inequality for the moments about the centre of mass.

    A symmetric body has λ₂ = λ₁; with M and R the moments are those about the pivot, and λ₁ (and
    λ₂) are less by MR² about the centre.
    """
    second = first if second is None else second
    if first is None or second is None:
        return True
    shift = Integer(0) if M is None or R is None else M * R**2
    first, second = first - shift, second - shift
    if third is None:
        return bool(first > 0 and second > 0)
    return bool(
        first > 0
        and second > 0
        and first + second >= third
        and second + third >= first
        and third + first >= second
    )


LETTERS = Letters(
    numbers=frozenset(
        {
            *(x for x, _ in _ROWS if x.is_positive and x not in (s.n, s.mu)),
            *(s.R1, s.R2, s.R3, s.alpha, s.beta, s.kappa, s.omega_0, s.omega_20, s.omega_30),
            *(
                s.theta_0,
                s.theta_i,
                s.theta_2,
                s.phidot_i,
                s.A,
                s.eta_0,
                s.epsilon_0,
                s.m,
                s.Omega_b,
            ),
            *(s.damping, s.ellipticity, s.follows, s.nu, s.radius, s.height, s.r_t, s.c_3),
            *(s.M_d, s.M_s, s.r_d, s.h_d, s.z_d, s.l_s, s.lambda_d, s.lambda_s),
            *(s.xhat, s.yhat, s.zhat, s.g_vec, s.F_grav, s.lambda_r, s.lambda_i),
        }
    ),
    coordinates=(s.theta, s.phi, s.psi),
    rates={
        s.theta: s.thetadot,
        s.phi: s.phidot,
        s.psi: s.psidot,
        s.thetadot: s.thetaddot,
        s.phidot: s.phiddot,
        s.psidot: s.psiddot,
        s.omega1: s.omega1dot,
        s.omega2: s.omega2dot,
        s.omega3: s.omega3dot,
        s.omega1dot: s.omega1ddot,
        s.omega2dot: s.omega2ddot,
        s.e3: s.e3dot,
        s.L_vec: s.L_vecdot,
        s.E: s.Edot,
        s.T: s.Tdot,
        s.T_tot: s.T_totdot,
    },
    vectors=frozenset(x for x, quantity in _ROWS if quantity.glyph.bold),
    operators=frozenset(MATRICES),
    determinants={
        s.A_matrix: s.det_A,
        s.B_matrix: s.det_B,
        s.C_matrix: s.det_C,
        s.O_matrix: s.det_O,
    },
    arbitrary=frozenset({s.u_vec, s.v_vec}),
    frames=(
        (s.e1, s.e2, s.e3),
        (s.e1p, s.e2p, s.e3),
        (s.h_vec, s.e2p, s.zhat),
        (s.xhat, s.yhat, s.zhat),
    ),
    body=(s.e1, s.e2, s.e3),
    indexed={
        **dict.fromkeys((s.m_k, s.r_k, s.F_k), frozenset({_K})),
        **dict.fromkeys((s.rho, s.r_vec, s.f_r), frozenset({_PLACE})),
        **dict.fromkeys((s.F_kl, s.F_lk, s.c_kl), frozenset({_K, _L})),
        s.r_l: frozenset({_L}),
        s.delta_k: frozenset({_K, _PLACE}),
    },
    exchanged={s.r_k: s.r_l, s.F_kl: s.F_lk},
    components={
        **{(e, s.omega_vec): w for e, w in zip(_AXES, (s.omega1, s.omega2, s.omega3), strict=True)},
        **{(e, s.L_vec): x for e, x in zip(_AXES, (s.L1, s.L2, s.L3), strict=True)},
        **{(e, s.N_vec): x for e, x in zip(_AXES, (s.N1, s.N2, s.N3), strict=True)},
        (s.e1p, s.omega_vec): s.omega1p,
        (s.e2p, s.omega_vec): s.omega2p,
        **{
            (e, s.L_vec): x
            for e, x in zip((s.xhat, s.yhat, s.zhat), (s.L_x, s.L_y, s.L_z), strict=True)
        },
    },
    branches={s.Omega_minus: (s.Omega, 0), s.Omega_plus: (s.Omega, 1)},
    families=(
        (s.lambda1, s.lambda2, s.lambda3),
        (s.omega1, s.omega2, s.omega3),
        (s.omega1dot, s.omega2dot, s.omega3dot),
        (s.theta, s.phi, s.psi),
        (s.thetadot, s.phidot, s.psidot),
        (s.thetaddot, s.phiddot, s.psiddot),
        (s.e1, s.e2, s.e3),
        (s.e1p, s.e2p, s.e3),
        (s.xhat, s.yhat, s.zhat),
        (s.L1, s.L2, s.L3, s.L_z),
        (s.p_phi, s.p_psi),
        (s.Omega_minus, s.Omega_plus),
        (s.M, s.g, s.R),
        (s.L_vec, s.omega_vec),
        (s.c_phi, s.c_theta, s.c_psi),
        (s.s_phi, s.s_theta, s.s_psi),
        (s.A_matrix, s.B_matrix, s.C_matrix),
        (s.a, s.b),
        (s.M_1, s.M_2),
    ),
    exists=is_a_body,
    placed=frozenset(
        {*_AXES, s.e1p, s.e2p, s.h_vec, s.xhat, s.yhat, s.zhat, s.R_CM, s.inertia, s.V}
    ),
    functions=dict.fromkeys((s.U, s.U_slope, s.Omega), (s.theta, s.p_phi, s.p_psi)),
    units={x: quantity.unit for x, quantity in _ROWS},
)
