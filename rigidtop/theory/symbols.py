"""The vocabulary: every symbol of the lecture, how it is written, what it means, its unit.

A symbol's *name* is a Python identifier, so that generated code is readable; its `Glyph` says how
it is written, from which LaTeX, MathML and terminal text are all made.  Velocities are plain
symbols (`thetadot`), not derivatives of functions: `rigidtop.theory.rotation.total_derivative`
knows which symbol is whose rate.  The order of `VOCABULARY` is the order in which factors are
printed: constants, parameters, momenta, rates, angles.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from sympy import Symbol


@dataclass(frozen=True)
class Glyph:
    """How a symbol is written: ``Glyph("ω", sub="3", accent="dot")`` is ω̇₃."""

    base: str
    sub: str = ""
    accent: str = ""  # "", "dot", "ddot" or "hat"
    bold: bool = False
    prime: bool = False


@dataclass(frozen=True)
class Quantity:
    """A row of the vocabulary.  `unit` is SI; "1" for a pure number.

    "" is for a label or a unit vector.
    """

    glyph: Glyph
    meaning: str
    unit: str


def _real(name: str) -> Symbol:
    return Symbol(name, real=True)


def _positive(name: str) -> Symbol:
    return Symbol(name, positive=True)


# Parameters
lambda1, lambda2, lambda3 = map(_positive, ("lambda1", "lambda2", "lambda3"))
M, g, R = map(_positive, ("M", "g", "R"))
R1, R2, R3 = map(_real, ("R1", "R2", "R3"))
epsilon = _real("epsilon")

# Euler angles z–y′–z″ with their rates
t = _real("t")
theta, phi, psi = map(_real, ("theta", "phi", "psi"))
thetadot, phidot, psidot = map(_real, ("thetadot", "phidot", "psidot"))
thetaddot, phiddot, psiddot = map(_real, ("thetaddot", "phiddot", "psiddot"))

# Attitude as a unit quaternion, scalar first
q0, q1, q2, q3 = map(_real, ("q0", "q1", "q2", "q3"))

# Rotational velocity in the body frame
omega1, omega2, omega3 = map(_real, ("omega1", "omega2", "omega3"))
omega1p, omega2p = map(_real, ("omega1p", "omega2p"))
omega1dot, omega2dot, omega3dot = map(_real, ("omega1dot", "omega2dot", "omega3dot"))
omega1ddot, omega2ddot = map(_real, ("omega1ddot", "omega2ddot"))
omega_0 = _real("omega_0")
theta_i, chi, t_chi2, m = map(_real, ("theta_i", "chi", "t_chi2", "m"))
Omega, Omega_b, Omega_s, tau_b = map(_real, ("Omega", "Omega_b", "Omega_s", "tau_b"))
Omega_minus, Omega_plus = map(_real, ("Omega_minus", "Omega_plus"))

# Momenta, energies, torque
L, L_x, L_y, L_z = map(_real, ("L", "L_x", "L_y", "L_z"))
L1, L2, L3 = map(_real, ("L1", "L2", "L3"))
p_theta, p_phi, p_psi = map(_real, ("p_theta", "p_phi", "p_psi"))
N1, N2, N3 = map(_real, ("N1", "N2", "N3"))
T, V, E, Lagrangian = map(_real, ("T", "V", "E", "Lagrangian"))
const = _real("const")

# Vectors and matrices, as they stand in printed equations
xhat, yhat, zhat = map(_real, ("xhat", "yhat", "zhat"))
e1, e2, e3 = map(_real, ("e1", "e2", "e3"))
e1p, e2p = map(_real, ("e1p", "e2p"))
e3dot = _real("e3dot")
h_vec = _real("h_vec")
omega_phi, omega_theta, omega_psi = map(_real, ("omega_phi", "omega_theta", "omega_psi"))
omega_vec, Omega_vec = map(_real, ("omega_vec", "Omega_vec"))
L_vec, L_vecdot, N_vec, N_ext = map(_real, ("L_vec", "L_vecdot", "N_vec", "N_ext"))
r_vec, r_vecp, r_k, F_k, f_r, R_CM, g_vec, F_grav = map(
    _real, ("r_vec", "r_vecp", "r_k", "F_k", "f_r", "R_CM", "g_vec", "F_grav")
)
inertia, Lambda, O_matrix = map(_real, ("inertia", "Lambda", "O_matrix"))
det_O, det_A, det_B, det_C = map(_real, ("det_O", "det_A", "det_B", "det_C"))
I_xz = _real("I_xz")
m_k, rho = map(_positive, ("m_k", "rho"))
r_l, F_kl, F_lk, c_kl, N_in, delta_k = map(
    _real, ("r_l", "F_kl", "F_lk", "c_kl", "N_in", "delta_k")
)

# What the pages need besides: a stick with two masses, starts, deviations, contact
M_1, M_2, a, b = map(_positive, ("M_1", "M_2", "a", "b"))
alpha, beta, delta, theta_0, omega, omega_20 = map(
    _real, ("alpha", "beta", "delta", "theta_0", "omega", "omega_20")
)
sigma2, omega_n2, D, kappa, A = map(_real, ("sigma2", "omega_n2", "D", "kappa", "A"))
F, F_1 = map(_real, ("F", "F_1"))
mu, n = map(_positive, ("mu", "n"))
U, U_slope, mean_theta, phidot_slope = map(_real, ("U", "U_slope", "mean_theta", "phidot_slope"))
follower = _real("follower")
eta = _real("eta")
slip, Edot, Tdot, damping = map(_real, ("slip", "Edot", "Tdot", "damping"))
r_1, v_tip, omega_perp, L_later = map(_real, ("r_1", "v_tip", "omega_perp", "L_later"))
ball = _positive("ball")
zeta1, zeta2, zeta3, zeta_vec = map(_real, ("zeta1", "zeta2", "zeta3", "zeta_vec"))
r_2, v_1, v_2, u_vec, v_vec = map(_real, ("r_2", "v_1", "v_2", "u_vec", "v_vec"))
lambda_r, lambda_i = map(_real, ("lambda_r", "lambda_i"))
r1, r2, r3 = map(_real, ("r1", "r2", "r3"))
r_tip, v_CM = map(_real, ("r_tip", "v_CM"))
alpha1, alpha2, gamma = map(_real, ("alpha1", "alpha2", "gamma"))
n_1, n_2, s_vec, trace_O = map(_real, ("n_1", "n_2", "s_vec", "trace_O"))
epsilon_0, tau, radius, height = map(_real, ("epsilon_0", "tau", "radius", "height"))
ellipticity, follows = map(_real, ("ellipticity", "follows"))
A_matrix, B_matrix, C_matrix, unit = map(_real, ("A_matrix", "B_matrix", "C_matrix", "unit"))
c_phi, s_phi, c_theta, s_theta, c_psi, s_psi = map(
    _real, ("c_phi", "s_phi", "c_theta", "s_theta", "c_psi", "s_psi")
)

# Turning points, a round tip in air, and a toy top: a disc on a stem
theta_1, phidot_i = map(_real, ("theta_1", "phidot_i"))
r_t, c_3, omega_30 = map(_real, ("r_t", "c_3", "omega_30"))
M_d, M_s, r_d, h_d, z_d, l_s = map(_real, ("M_d", "M_s", "r_d", "h_d", "z_d", "l_s"))
lambda_d, lambda_s = map(_real, ("lambda_d", "lambda_s"))

VOCABULARY: Mapping[Symbol, Quantity] = MappingProxyType(
    {
        lambda1: Quantity(Glyph("λ", "1"), "principal moment of inertia about $e₁$", "kg m²"),
        lambda2: Quantity(Glyph("λ", "2"), "principal moment of inertia about $e₂$", "kg m²"),
        lambda3: Quantity(Glyph("λ", "3"), "principal moment of inertia about $e₃$", "kg m²"),
        ball: Quantity(Glyph("λ", "0"), "moment of inertia of a ball inside the body", "kg m²"),
        lambda_r: Quantity(Glyph("λ", "r"), "real part of a moment of inertia", "kg m²"),
        lambda_i: Quantity(Glyph("λ", "i"), "imaginary part of a moment of inertia", "kg m²"),
        lambda_d: Quantity(Glyph("λ", "d"), "moment of the disc about $e₁$, at the tip", "kg m²"),
        lambda_s: Quantity(Glyph("λ", "s"), "moment of the stem about $e₁$, at the tip", "kg m²"),
        M: Quantity(Glyph("M"), "mass of the body", "kg"),
        m_k: Quantity(Glyph("m", "k"), "mass of particle $k$", "kg"),
        rho: Quantity(Glyph("ρ"), "mass density", "kg/m³"),
        g: Quantity(Glyph("g"), "acceleration of gravity", "m/s²"),
        R: Quantity(Glyph("R"), "distance from the pivot to the centre of mass", "m"),
        R1: Quantity(Glyph("R", "1"), "centre of mass from the pivot, along $e₁$", "m"),
        R2: Quantity(Glyph("R", "2"), "centre of mass from the pivot, along $e₂$", "m"),
        R3: Quantity(Glyph("R", "3"), "centre of mass from the pivot, along $e₃$", "m"),
        r1: Quantity(Glyph("r", "1"), "position along $e₁$", "m"),
        r2: Quantity(Glyph("r", "2"), "position along $e₂$", "m"),
        r3: Quantity(Glyph("r", "3"), "position along $e₃$", "m"),
        epsilon: Quantity(Glyph("ε"), "gravity against spin, $λ₁MgR cosθ/(λ₃ω₃)²$", "1"),
        epsilon_0: Quantity(Glyph("ε", "0"), "gravity against spin, $λ₁MgR/(λ₃ω₃)²$", "1"),
        tau: Quantity(Glyph("τ"), "relative error of an approximation", "1"),
        radius: Quantity(Glyph("r"), "radius of a solid", "m"),
        height: Quantity(Glyph("h"), "height of a solid", "m"),
        M_1: Quantity(Glyph("M", "1"), "mass of the first point", "kg"),
        M_2: Quantity(Glyph("M", "2"), "mass of the second point", "kg"),
        a: Quantity(Glyph("a"), "distance of the first mass from the origin", "m"),
        b: Quantity(Glyph("b"), "distance of the second mass from the origin", "m"),
        r_t: Quantity(Glyph("r", "0"), "radius of a round tip", "m"),
        M_d: Quantity(Glyph("M", "d"), "mass of the disc", "kg"),
        M_s: Quantity(Glyph("M", "s"), "mass of the stem", "kg"),
        r_d: Quantity(Glyph("r", "d"), "radius of the disc", "m"),
        h_d: Quantity(Glyph("h", "d"), "thickness of the disc", "m"),
        z_d: Quantity(Glyph("z", "d"), "height of the disc above the tip, along the stem", "m"),
        l_s: Quantity(Glyph("l", "s"), "length of the stem", "m"),
        mu: Quantity(Glyph("μ"), "coefficient of sliding friction", "1"),
        n: Quantity(Glyph("n"), "normal force at the contact", "N"),
        kappa: Quantity(Glyph("κ"), "gradient of gravity across the body", "1/s²"),
        inertia: Quantity(Glyph("I"), "inertia tensor", "kg m²"),
        Lambda: Quantity(Glyph("Λ"), "diagonal matrix of the principal moments", "kg m²"),
        ellipticity: Quantity(Glyph("H"), "dynamical ellipticity $(λ₃ − λ₁)/λ₃$", "1"),
        follows: Quantity(Glyph("k"), "share of the equatorial bulge that follows $ω$", "1"),
        I_xz: Quantity(Glyph("I", "xz"), "component of the inertia tensor", "kg m²"),
        A_matrix: Quantity(Glyph("A"), "a square matrix", "1"),
        B_matrix: Quantity(Glyph("B"), "a square matrix", "1"),
        C_matrix: Quantity(Glyph("C"), "a square matrix", "1"),
        unit: Quantity(Glyph("1"), "the unit matrix", "1"),
        trace_O: Quantity(Glyph("tr O"), "trace of $O$: $1 + 2 ×$ cosine of its angle", "1"),
        det_O: Quantity(Glyph("det O"), "determinant of $O$", "1"),
        det_A: Quantity(Glyph("det A"), "determinant of $A$", "1"),
        det_B: Quantity(Glyph("det B"), "determinant of $B$", "1"),
        det_C: Quantity(Glyph("det C"), "determinant of $C$", "1"),
        O_matrix: Quantity(Glyph("O"), "matrix whose columns are $e₁$, $e₂$, $e₃$", "1"),
        T: Quantity(Glyph("T"), "kinetic energy", "J"),
        V: Quantity(Glyph("V"), "potential energy", "J"),
        U: Quantity(Glyph("U"), "effective potential of $θ$", "J"),
        U_slope: Quantity(Glyph("U", prime=True), "slope of the effective potential", "J"),
        E: Quantity(Glyph("E"), "energy", "J"),
        Lagrangian: Quantity(Glyph("ℒ"), "Lagrangian $T − V$", "J"),
        L: Quantity(Glyph("L"), "magnitude of the angular momentum", "J s"),
        L_x: Quantity(Glyph("L", "x"), "angular momentum along $x̂$ of the space frame", "J s"),
        L_y: Quantity(Glyph("L", "y"), "angular momentum along $ŷ$ of the space frame", "J s"),
        L_z: Quantity(Glyph("L", "z"), "angular momentum along $ẑ$ of the space frame", "J s"),
        L1: Quantity(Glyph("L", "1"), "angular momentum along $e₁$", "J s"),
        L2: Quantity(Glyph("L", "2"), "angular momentum along $e₂$", "J s"),
        L3: Quantity(Glyph("L", "3"), "angular momentum along $e₃$", "J s"),
        p_theta: Quantity(Glyph("p", "θ"), "momentum conjugate to $θ$", "J s"),
        p_phi: Quantity(Glyph("p", "φ"), "momentum conjugate to $φ$", "J s"),
        p_psi: Quantity(Glyph("p", "ψ"), "momentum conjugate to $ψ$", "J s"),
        N1: Quantity(Glyph("N", "1"), "torque along $e₁$", "N m"),
        N2: Quantity(Glyph("N", "2"), "torque along $e₂$", "N m"),
        N3: Quantity(Glyph("N", "3"), "torque along $e₃$", "N m"),
        D: Quantity(Glyph("D"), "discriminant of the steady-precession quadratic", "J² s²"),
        F: Quantity(Glyph("F", bold=True), "a force: external, or at the contact", "N"),
        c_kl: Quantity(
            Glyph("c", "kl"), "force between particles $k$ and $l$ over distance", "N/m"
        ),
        delta_k: Quantity(Glyph("δ", "k"), "Dirac's $δ$ at particle $k$", "1/m³"),
        F_1: Quantity(Glyph("F", "1"), "external force on the first particle, along $x̂$", "N"),
        Edot: Quantity(Glyph("E", accent="dot"), "rate of the energy", "W"),
        Tdot: Quantity(Glyph("T", accent="dot"), "rate of the kinetic energy", "W"),
        damping: Quantity(Glyph("c"), "torque of the friction inside the body over $ζ$", "J s"),
        c_3: Quantity(Glyph("c", "3"), "drag torque of the air along $e₃$ over $ω₃$", "J s"),
        sigma2: Quantity(Glyph("σ²"), "square of a growth rate", "1/s²"),
        omega_n2: Quantity(Glyph("ω²", "n"), "square of the nutation frequency", "1/s²"),
        A: Quantity(Glyph("A"), "amplitude of the nutation", "rad"),
        delta: Quantity(Glyph("δ"), "a deviation: of a shape, an angle, a start", "1"),
        eta: Quantity(Glyph("η"), "how far $θ$ is from where it was at the start", "rad"),
        mean_theta: Quantity(Glyph("δ", "θ"), "mean of $θ$ less the steady angle", "rad"),
        phidot_slope: Quantity(Glyph("φ", "θ", "dot"), "slope of $φ̇$ against $θ$", "1/s"),
        slip: Quantity(Glyph("v"), "speed of the contact point over the table", "m/s"),
        Omega_b: Quantity(Glyph("Ω", "b"), "free precession in the body frame", "rad/s"),
        Omega_s: Quantity(Glyph("Ω", "s"), "free precession in the space frame", "rad/s"),
        omega: Quantity(Glyph("ω"), "magnitude of the rotational velocity", "rad/s"),
        omega_20: Quantity(Glyph("ω", "2,0"), "$ω₂$ at $t = 0$", "rad/s"),
        omega_30: Quantity(Glyph("ω", "3,0"), "$ω₃$ at $t = 0$", "rad/s"),
        omega_0: Quantity(Glyph("ω", "0"), "amplitude of $𝛚$ across $e₃$", "rad/s"),
        omega1: Quantity(Glyph("ω", "1"), "rotational velocity along $e₁$", "rad/s"),
        omega2: Quantity(Glyph("ω", "2"), "rotational velocity along $e₂$", "rad/s"),
        omega3: Quantity(Glyph("ω", "3"), "rotational velocity along $e₃$", "rad/s"),
        zeta1: Quantity(Glyph("ζ", "1"), "rotation of the ball in the body, along $e₁$", "rad/s"),
        zeta2: Quantity(Glyph("ζ", "2"), "rotation of the ball in the body, along $e₂$", "rad/s"),
        zeta3: Quantity(Glyph("ζ", "3"), "rotation of the ball in the body, along $e₃$", "rad/s"),
        omega1p: Quantity(Glyph("ω", "1′"), "rotational velocity along $e₁′$", "rad/s"),
        omega2p: Quantity(Glyph("ω", "2′"), "rotational velocity along $e₂′$", "rad/s"),
        omega1dot: Quantity(Glyph("ω", "1", "dot"), "time derivative of $ω₁$", "rad/s²"),
        omega2dot: Quantity(Glyph("ω", "2", "dot"), "time derivative of $ω₂$", "rad/s²"),
        omega3dot: Quantity(Glyph("ω", "3", "dot"), "time derivative of $ω₃$", "rad/s²"),
        omega1ddot: Quantity(Glyph("ω", "1", "ddot"), "second derivative of $ω₁$", "rad/s³"),
        omega2ddot: Quantity(Glyph("ω", "2", "ddot"), "second derivative of $ω₂$", "rad/s³"),
        thetaddot: Quantity(Glyph("θ", accent="ddot"), "second derivative of $θ$", "rad/s²"),
        phiddot: Quantity(Glyph("φ", accent="ddot"), "second derivative of $φ$", "rad/s²"),
        psiddot: Quantity(Glyph("ψ", accent="ddot"), "second derivative of $ψ$", "rad/s²"),
        phidot: Quantity(Glyph("φ", accent="dot"), "rate of $φ$: precession", "rad/s"),
        phidot_i: Quantity(Glyph("φ", "i", accent="dot"), "rate of $φ$ at the start", "rad/s"),
        thetadot: Quantity(Glyph("θ", accent="dot"), "rate of $θ$: nutation", "rad/s"),
        psidot: Quantity(Glyph("ψ", accent="dot"), "rate of $ψ$: spin", "rad/s"),
        Omega: Quantity(Glyph("Ω"), "rate of steady precession", "rad/s"),
        Omega_minus: Quantity(Glyph("Ω", "−"), "slow steady precession", "rad/s"),
        Omega_plus: Quantity(Glyph("Ω", "+"), "fast steady precession", "rad/s"),
        tau_b: Quantity(Glyph("τ", "b"), "period of the free precession in the body", "s"),
        t: Quantity(Glyph("t"), "time", "s"),
        q0: Quantity(Glyph("q", "0"), "scalar part of the attitude quaternion", "1"),
        q1: Quantity(Glyph("q", "1"), "first vector part of the attitude quaternion", "1"),
        q2: Quantity(Glyph("q", "2"), "second vector part of the attitude quaternion", "1"),
        q3: Quantity(Glyph("q", "3"), "third vector part of the attitude quaternion", "1"),
        c_phi: Quantity(Glyph("c", "φ"), "$cos φ$", "1"),
        s_phi: Quantity(Glyph("s", "φ"), "$sin φ$", "1"),
        c_theta: Quantity(Glyph("c", "θ"), "$cos θ$", "1"),
        s_theta: Quantity(Glyph("s", "θ"), "$sin θ$", "1"),
        c_psi: Quantity(Glyph("c", "ψ"), "$cos ψ$", "1"),
        s_psi: Quantity(Glyph("s", "ψ"), "$sin ψ$", "1"),
        alpha: Quantity(Glyph("α"), "tilt of the stick against $𝛚$", "rad"),
        beta: Quantity(Glyph("β"), "angle between $𝐋$ and $e₃$", "rad"),
        alpha1: Quantity(Glyph("α", "1"), "half the angle of the first rotation", "rad"),
        alpha2: Quantity(Glyph("α", "2"), "half the angle of the second rotation", "rad"),
        gamma: Quantity(Glyph("γ"), "angle between the axes of two rotations", "rad"),
        theta_0: Quantity(Glyph("θ", "0"), "polar angle at which $φ̇$ vanishes", "rad"),
        m: Quantity(Glyph("m"), "parameter of an elliptic integral", "1"),
        chi: Quantity(Glyph("χ"), "amplitude of an elliptic integral", "rad"),
        t_chi2: Quantity(Glyph("t²", "χ"), "square of $dt/dχ$", "s²"),
        theta_i: Quantity(Glyph("θ", "i"), "polar angle at the start", "rad"),
        theta_1: Quantity(Glyph("θ", "1"), "polar angle of the other turning point", "rad"),
        phi: Quantity(Glyph("φ"), "first Euler angle: azimuth of $e₃$", "rad"),
        theta: Quantity(Glyph("θ"), "second Euler angle: polar angle of $e₃$", "rad"),
        psi: Quantity(Glyph("ψ"), "third Euler angle: turn about $e₃$", "rad"),
        const: Quantity(Glyph("const"), "a value that does not change in time", ""),
        xhat: Quantity(Glyph("x", accent="hat", bold=True), "first axis of the space frame", ""),
        yhat: Quantity(Glyph("y", accent="hat", bold=True), "second axis of the space frame", ""),
        zhat: Quantity(Glyph("z", accent="hat", bold=True), "vertical of the space frame", ""),
        e1: Quantity(Glyph("e", "1", bold=True), "first principal axis of the body", ""),
        e2: Quantity(Glyph("e", "2", bold=True), "second principal axis of the body", ""),
        e1p: Quantity(
            Glyph("e", "1", bold=True, prime=True), "$e₁$ before the last Euler rotation", ""
        ),
        e2p: Quantity(Glyph("e", "2", bold=True, prime=True), "line of nodes: $e₂$ after $φ$", ""),
        e3: Quantity(Glyph("e", "3", bold=True), "third principal axis: figure axis", ""),
        e3dot: Quantity(
            Glyph("e", "3", accent="dot", bold=True), "velocity of the tip of $e₃$", "1/s"
        ),
        n_1: Quantity(Glyph("n", "1", bold=True), "axis of the first rotation", ""),
        n_2: Quantity(Glyph("n", "2", bold=True), "axis of the second rotation", ""),
        s_vec: Quantity(Glyph("s", bold=True), "axis of a rotation times sine of its angle", ""),
        h_vec: Quantity(Glyph("h", bold=True), "horizontal direction in which $e₃$ leans", ""),
        omega_phi: Quantity(Glyph("ω", "φ", bold=True), "rotational velocity of $φ$", "rad/s"),
        omega_theta: Quantity(Glyph("ω", "θ", bold=True), "rotational velocity of $θ$", "rad/s"),
        omega_psi: Quantity(Glyph("ω", "ψ", bold=True), "rotational velocity of $ψ$", "rad/s"),
        omega_vec: Quantity(Glyph("ω", bold=True), "rotational velocity", "rad/s"),
        zeta_vec: Quantity(
            Glyph("ζ", bold=True), "rotational velocity of a ball relative to the body", "rad/s"
        ),
        Omega_vec: Quantity(Glyph("Ω", bold=True), "rotational velocity of precession", "rad/s"),
        L_vec: Quantity(Glyph("L", bold=True), "angular momentum", "J s"),
        L_vecdot: Quantity(
            Glyph("L", accent="dot", bold=True), "rate of the angular momentum", "N m"
        ),
        N_vec: Quantity(Glyph("N", bold=True), "torque", "N m"),
        N_ext: Quantity(Glyph("N", "ext", bold=True), "external torque", "N m"),
        r_vec: Quantity(Glyph("r", bold=True), "position in space components", "m"),
        r_vecp: Quantity(Glyph("r", bold=True, prime=True), "position in body components", "m"),
        r_k: Quantity(Glyph("r", "k", bold=True), "position of particle $k$", "m"),
        F_k: Quantity(Glyph("F", "k", bold=True), "external force on particle $k$", "N"),
        r_l: Quantity(Glyph("r", "l", bold=True), "position of particle l", "m"),
        F_kl: Quantity(Glyph("F", "kl", bold=True), "force on particle $k$ from particle l", "N"),
        F_lk: Quantity(Glyph("F", "lk", bold=True), "force on particle l from particle $k$", "N"),
        N_in: Quantity(Glyph("N", "in", bold=True), "torque of the inner forces", "N m"),
        f_r: Quantity(Glyph("f", bold=True), "force density", "N/m³"),
        R_CM: Quantity(Glyph("R", "CM", bold=True), "centre of mass from the pivot", "m"),
        g_vec: Quantity(Glyph("g", bold=True), "acceleration of gravity as a vector", "m/s²"),
        follower: Quantity(Glyph("w", bold=True), "a vector that turns along behind $ω$", ""),
        r_1: Quantity(Glyph("r", "1", bold=True), "position of the first mass", "m"),
        r_2: Quantity(Glyph("r", "2", bold=True), "position of the second mass", "m"),
        v_1: Quantity(Glyph("v", "1", bold=True), "velocity of the first mass", "m/s"),
        v_2: Quantity(Glyph("v", "2", bold=True), "velocity of the second mass", "m/s"),
        u_vec: Quantity(Glyph("u", bold=True), "any vector", ""),
        v_vec: Quantity(Glyph("v", bold=True), "any vector", ""),
        v_tip: Quantity(Glyph("v", "tip", bold=True), "velocity of the contact point", "m/s"),
        r_tip: Quantity(Glyph("r", "tip", bold=True), "contact point from the centre of mass", "m"),
        v_CM: Quantity(Glyph("v", "CM", bold=True), "velocity of the centre of mass", "m/s"),
        omega_perp: Quantity(
            Glyph("ω", "⊥", bold=True), "rotational velocity perpendicular to the stick", "rad/s"
        ),
        L_later: Quantity(
            Glyph("L", "later", bold=True), "angular momentum half a turn later", "J s"
        ),
        F_grav: Quantity(Glyph("F", "grav", bold=True), "weight", "N"),
    }
)
"""Every symbol with its glyph, meaning and unit, in the order of print."""
