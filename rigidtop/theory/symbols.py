"""The vocabulary: every symbol of the lecture, how it is written, what it means, its unit.

A symbol's *name* is a Python identifier, so that generated code is readable; its `Glyph` says how
it is written, from which LaTeX, MathML and terminal text are all made.  Velocities are plain
symbols (`thetadot`), not derivatives of functions: `rigidtop.theory.rates.total_derivative`
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
class VocabularyEntry:
    """A row of the vocabulary.  `unit` is SI; "1" for a pure number.

    "" is for a label or a unit vector.
    """

    glyph: Glyph
    meaning: str
    unit: str
    matrix: bool = False


_ROWS: dict[Symbol, VocabularyEntry] = {}


def _real(name: str, glyph: Glyph, meaning: str, unit: str) -> Symbol:
    symbol = Symbol(name, real=True)
    _ROWS[symbol] = VocabularyEntry(glyph, meaning, unit)
    return symbol


def _positive(name: str, glyph: Glyph, meaning: str, unit: str) -> Symbol:
    symbol = Symbol(name, positive=True)
    _ROWS[symbol] = VocabularyEntry(glyph, meaning, unit)
    return symbol


lambda1 = _positive(
    "lambda1", Glyph("λ", "1"), r"principal moment of inertia about $\mathbf e_1$", "kg m²"
)
lambda2 = _positive(
    "lambda2", Glyph("λ", "2"), r"principal moment of inertia about $\mathbf e_2$", "kg m²"
)
lambda3 = _positive(
    "lambda3", Glyph("λ", "3"), r"principal moment of inertia about $\mathbf e_3$", "kg m²"
)
ball = _positive("ball", Glyph("λ", "0"), "moment of inertia of a ball inside the body", "kg m²")
lambda_r = _real("lambda_r", Glyph("λ", "r"), "real part of a moment of inertia", "kg m²")
lambda_i = _real("lambda_i", Glyph("λ", "i"), "imaginary part of a moment of inertia", "kg m²")
lambda_d = _real(
    "lambda_d", Glyph("λ", "d"), r"moment of the disc about $\mathbf e_1$, at the tip", "kg m²"
)
lambda_s = _real(
    "lambda_s", Glyph("λ", "s"), r"moment of the stem about $\mathbf e_1$, at the tip", "kg m²"
)
M = _positive("M", Glyph("M"), "mass of the body", "kg")
m_k = _positive("m_k", Glyph("m", "k"), "mass of particle $k$", "kg")
rho = _positive("rho", Glyph("ρ"), "mass density", "kg/m³")
g = _positive("g", Glyph("g"), "acceleration of gravity", "m/s²")
R = _positive("R", Glyph("R"), "distance from the pivot to the centre of mass", "m")
R1 = _real("R1", Glyph("R", "1"), r"centre of mass from the pivot, along $\mathbf e_1$", "m")
R2 = _real("R2", Glyph("R", "2"), r"centre of mass from the pivot, along $\mathbf e_2$", "m")
R3 = _real("R3", Glyph("R", "3"), r"centre of mass from the pivot, along $\mathbf e_3$", "m")
r1 = _real("r1", Glyph("r", "1"), r"position along $\mathbf e_1$", "m")
r2 = _real("r2", Glyph("r", "2"), r"position along $\mathbf e_2$", "m")
r3 = _real("r3", Glyph("r", "3"), r"position along $\mathbf e_3$", "m")
epsilon = _real(
    "epsilon",
    Glyph("ε"),
    r"weight against spin, $\lambda_1MgR \cos\theta/(\lambda_3\omega_3)^2$",
    "1",
)
epsilon_0 = _real(
    "epsilon_0", Glyph("ε", "0"), r"weight against spin, $\lambda_1MgR/(\lambda_3\omega_3)^2$", "1"
)
tau = _real("tau", Glyph("τ"), "relative error of an approximation", "1")
radius = _real("radius", Glyph("r"), "radius of a solid", "m")
height = _real("height", Glyph("h"), "height of a solid", "m")
M_1 = _positive("M_1", Glyph("M", "1"), "mass of the first point", "kg")
M_2 = _positive("M_2", Glyph("M", "2"), "mass of the second point", "kg")
a = _positive("a", Glyph("a"), "distance of the first mass from the origin", "m")
b = _positive("b", Glyph("b"), "distance of the second mass from the origin", "m")
r_t = _real("r_t", Glyph("r", "0"), "radius of a round tip", "m")
M_d = _real("M_d", Glyph("M", "d"), "mass of the disc", "kg")
M_s = _real("M_s", Glyph("M", "s"), "mass of the stem", "kg")
r_d = _real("r_d", Glyph("r", "d"), "radius of the disc", "m")
h_d = _real("h_d", Glyph("h", "d"), "thickness of the disc", "m")
z_d = _real("z_d", Glyph("z", "d"), "height of the disc above the tip, along the stem", "m")
l_s = _real("l_s", Glyph("l", "s"), "length of the stem", "m")
mu = _positive("mu", Glyph("μ"), "coefficient of sliding friction", "1")
n = _positive("n", Glyph("n"), "normal force at the contact, or pull along an axle", "N")
kappa = _real("kappa", Glyph("κ"), "gradient of gravity across the body", "1/s²")
inertia = _real("inertia", Glyph("I"), "inertia tensor", "kg m²")
Lambda = _real("Lambda", Glyph("Λ"), "diagonal matrix of the principal moments", "kg m²")
ellipticity = _real(
    "ellipticity", Glyph("H"), r"dynamical ellipticity $(\lambda_3 - \lambda_1)/\lambda_3$", "1"
)
follows = _real(
    "follows", Glyph("k"), r"share of the equatorial bulge that follows $\boldsymbol\omega$", "1"
)
I_xz = _real("I_xz", Glyph("I", "xz"), "component of the inertia tensor", "kg m²")
A_matrix = _real("A_matrix", Glyph("A"), "a square matrix", "1")
B_matrix = _real("B_matrix", Glyph("B"), "a square matrix", "1")
C_matrix = _real("C_matrix", Glyph("C"), "a square matrix", "1")
unit = _real("unit", Glyph("1"), "the unit matrix", "1")
trace_O = _real("trace_O", Glyph("tr O"), r"trace of $O$: $1 + 2 \times$ cosine of its angle", "1")
det_O = _real("det_O", Glyph("det O"), "determinant of $O$", "1")
det_A = _real("det_A", Glyph("det A"), "determinant of $A$", "1")
det_B = _real("det_B", Glyph("det B"), "determinant of $B$", "1")
det_C = _real("det_C", Glyph("det C"), "determinant of $C$", "1")
O_matrix = _real(
    "O_matrix",
    Glyph("O"),
    r"matrix whose columns are $\mathbf e_1$, $\mathbf e_2$, $\mathbf e_3$",
    "1",
)
T = _real("T", Glyph("T"), "kinetic energy", "J")
T_tot = _real("T_tot", Glyph("T", "tot"), "kinetic energy with that of a ball inside", "J")
V = _real("V", Glyph("V"), "potential energy", "J")
U = _real("U", Glyph("U"), r"effective potential of $\theta$", "J")
U_slope = _real("U_slope", Glyph("U", prime=True), "slope of the effective potential", "J")
E = _real("E", Glyph("E"), "energy", "J")
Lagrangian = _real("Lagrangian", Glyph("ℒ"), "Lagrangian $T - V$", "J")
L = _real("L", Glyph("L"), "magnitude of the angular momentum", "J s")
L_x = _real(
    "L_x", Glyph("L", "x"), r"angular momentum along $\hat{\mathbf x}$ of the space frame", "J s"
)
L_y = _real(
    "L_y", Glyph("L", "y"), r"angular momentum along $\hat{\mathbf y}$ of the space frame", "J s"
)
L_z = _real(
    "L_z", Glyph("L", "z"), r"angular momentum along $\hat{\mathbf z}$ of the space frame", "J s"
)
L1 = _real("L1", Glyph("L", "1"), r"angular momentum along $\mathbf e_1$", "J s")
L2 = _real("L2", Glyph("L", "2"), r"angular momentum along $\mathbf e_2$", "J s")
L3 = _real("L3", Glyph("L", "3"), r"angular momentum along $\mathbf e_3$", "J s")
p_theta = _real("p_theta", Glyph("p", "θ"), r"momentum conjugate to $\theta$", "J s")
p_phi = _real("p_phi", Glyph("p", "φ"), r"momentum conjugate to $\phi$", "J s")
p_psi = _real("p_psi", Glyph("p", "ψ"), r"momentum conjugate to $\psi$", "J s")
N1 = _real("N1", Glyph("N", "1"), r"torque along $\mathbf e_1$", "N m")
N2 = _real("N2", Glyph("N", "2"), r"torque along $\mathbf e_2$", "N m")
N3 = _real("N3", Glyph("N", "3"), r"torque along $\mathbf e_3$", "N m")
D = _real("D", Glyph("D"), "discriminant of the steady-precession quadratic", "J² s²")
F = _real("F", Glyph("F", bold=True), "a force: external, or at the contact", "N")
c_kl = _real("c_kl", Glyph("c", "kl"), "force between particles $k$ and $l$ over distance", "N/m")
delta_k = _real("delta_k", Glyph("δ", "k"), r"Dirac's $\delta$ at particle $k$", "1/m³")
F_1 = _real(
    "F_1", Glyph("F", "1"), r"external force on the first particle, along $\hat{\mathbf x}$", "N"
)
Edot = _real("Edot", Glyph("E", accent="dot"), "rate of the energy", "W")
Tdot = _real("Tdot", Glyph("T", accent="dot"), "rate of the kinetic energy", "W")
T_totdot = _real(
    "T_totdot", Glyph("T", "tot", accent="dot"), "rate of the energy with a ball inside", "W"
)
damping = _real(
    "damping", Glyph("c"), r"torque of the friction inside the body over $\zeta$", "J s"
)
c_3 = _real(
    "c_3", Glyph("c", "3"), r"drag torque of the air along $\mathbf e_3$ over $\omega_3$", "J s"
)
sigma2 = _real("sigma2", Glyph("σ²"), r"square of the rate $\sigma$ of growth", "1/s²")
nu = _real("nu", Glyph("ν"), "frequency of a nutation, rate of a flip", "rad/s")
omega_n2 = _real(
    "omega_n2", Glyph("ω²", "n"), r"square of the frequency $\omega_n$ of nutation", "1/s²"
)
A = _real("A", Glyph("A"), "an amplitude", "rad")
eta_0 = _real("eta_0", Glyph("η", "0"), "amplitude of the nutation", "rad")
delta = _real(
    "delta", Glyph("δ"), r"how far the tip of $\mathbf e_3$ is above or below a level", "1"
)
eta = _real(
    "eta", Glyph("η"), r"how far $\theta$ is from where it was at the start, or from $\pi$", "rad"
)
mean_theta = _real("mean_theta", Glyph("δ", "θ"), r"mean of $\theta$ less the steady angle", "rad")
phidot_slope = _real(
    "phidot_slope", Glyph("φ", "θ", accent="dot"), r"slope of $\dot\phi$ against $\theta$", "1/s"
)
slip = _real("slip", Glyph("v"), "speed of the contact point over the table", "m/s")
Omega_b = _real("Omega_b", Glyph("Ω", "b"), "free precession in the body frame", "rad/s")
Omega_s = _real("Omega_s", Glyph("Ω", "s"), "free precession in the space frame", "rad/s")
omega = _real("omega", Glyph("ω"), "magnitude of the rotational velocity", "rad/s")
omega_20 = _real("omega_20", Glyph("ω", "2,0"), r"$|\omega_2|$ at $t = 0$", "rad/s")
omega_30 = _real("omega_30", Glyph("ω", "3,0"), r"$\omega_3$ at $t = 0$", "rad/s")
omega_0 = _real(
    "omega_0",
    Glyph("ω", "0"),
    r"part of $\boldsymbol\omega$ across $\mathbf e_3$, or $\omega_1$, at the start",
    "rad/s",
)
omega1 = _real("omega1", Glyph("ω", "1"), r"rotational velocity along $\mathbf e_1$", "rad/s")
omega2 = _real("omega2", Glyph("ω", "2"), r"rotational velocity along $\mathbf e_2$", "rad/s")
omega3 = _real("omega3", Glyph("ω", "3"), r"rotational velocity along $\mathbf e_3$", "rad/s")
zeta1 = _real(
    "zeta1", Glyph("ζ", "1"), r"rotation of the ball in the body, along $\mathbf e_1$", "rad/s"
)
zeta2 = _real(
    "zeta2", Glyph("ζ", "2"), r"rotation of the ball in the body, along $\mathbf e_2$", "rad/s"
)
zeta3 = _real(
    "zeta3", Glyph("ζ", "3"), r"rotation of the ball in the body, along $\mathbf e_3$", "rad/s"
)
omega1p = _real("omega1p", Glyph("ω", "1′"), r"rotational velocity along $\mathbf e_1'$", "rad/s")
omega2p = _real("omega2p", Glyph("ω", "2′"), r"rotational velocity along $\mathbf e_2'$", "rad/s")
omega1dot = _real(
    "omega1dot", Glyph("ω", "1", accent="dot"), r"time derivative of $\omega_1$", "rad/s²"
)
omega2dot = _real(
    "omega2dot", Glyph("ω", "2", accent="dot"), r"time derivative of $\omega_2$", "rad/s²"
)
omega3dot = _real(
    "omega3dot", Glyph("ω", "3", accent="dot"), r"time derivative of $\omega_3$", "rad/s²"
)
omega1ddot = _real(
    "omega1ddot", Glyph("ω", "1", accent="ddot"), r"second derivative of $\omega_1$", "rad/s³"
)
omega2ddot = _real(
    "omega2ddot", Glyph("ω", "2", accent="ddot"), r"second derivative of $\omega_2$", "rad/s³"
)
thetaddot = _real(
    "thetaddot", Glyph("θ", accent="ddot"), r"second derivative of $\theta$", "rad/s²"
)
phiddot = _real("phiddot", Glyph("φ", accent="ddot"), r"second derivative of $\phi$", "rad/s²")
psiddot = _real("psiddot", Glyph("ψ", accent="ddot"), r"second derivative of $\psi$", "rad/s²")
phidot = _real("phidot", Glyph("φ", accent="dot"), r"rate of $\phi$: precession", "rad/s")
phidot_i = _real("phidot_i", Glyph("φ", "i", accent="dot"), r"rate of $\phi$ at the start", "rad/s")
thetadot = _real("thetadot", Glyph("θ", accent="dot"), r"rate of $\theta$: nutation", "rad/s")
psidot = _real("psidot", Glyph("ψ", accent="dot"), r"rate of $\psi$", "rad/s")
Omega = _real("Omega", Glyph("Ω"), "rate of steady precession", "rad/s")
Omega_minus = _real("Omega_minus", Glyph("Ω", "−"), "slow steady precession", "rad/s")
Omega_plus = _real("Omega_plus", Glyph("Ω", "+"), "fast steady precession", "rad/s")
tau_b = _real("tau_b", Glyph("τ", "b"), "period of the free precession in the body", "s")
t = _real("t", Glyph("t"), "time", "s")
q0 = _real("q0", Glyph("q", "0"), "scalar part of the attitude quaternion", "1")
q1 = _real("q1", Glyph("q", "1"), "first vector part of the attitude quaternion", "1")
q2 = _real("q2", Glyph("q", "2"), "second vector part of the attitude quaternion", "1")
q3 = _real("q3", Glyph("q", "3"), "third vector part of the attitude quaternion", "1")
c_phi = _real("c_phi", Glyph("c", "φ"), r"$\cos\phi$", "1")
s_phi = _real("s_phi", Glyph("s", "φ"), r"$\sin\phi$", "1")
c_theta = _real("c_theta", Glyph("c", "θ"), r"$\cos\theta$", "1")
s_theta = _real("s_theta", Glyph("s", "θ"), r"$\sin\theta$", "1")
c_psi = _real("c_psi", Glyph("c", "ψ"), r"$\cos\psi$", "1")
s_psi = _real("s_psi", Glyph("s", "ψ"), r"$\sin\psi$", "1")
alpha = _real("alpha", Glyph("α"), r"tilt of the stick against $\boldsymbol\omega$", "rad")
beta = _real("beta", Glyph("β"), "half the angle of the rotation $C$", "rad")
alpha1 = _real("alpha1", Glyph("α", "1"), "half the angle of the first rotation", "rad")
alpha2 = _real("alpha2", Glyph("α", "2"), "half the angle of the second rotation", "rad")
gamma = _real("gamma", Glyph("γ"), "angle between two axes, or of one vector behind another", "rad")
theta_0 = _real("theta_0", Glyph("θ", "0"), r"polar angle at which $\dot\phi$ vanishes", "rad")
m = _real("m", Glyph("m"), "parameter of an elliptic integral", "1")
chi = _real("chi", Glyph("χ"), "amplitude of an elliptic integral, or angle of two turns", "rad")
theta_i = _real("theta_i", Glyph("θ", "i"), "polar angle at the start", "rad")
theta_2 = _real("theta_2", Glyph("θ", "2"), "polar angle of the lower turning point", "rad")
phi = _real("phi", Glyph("φ"), r"first Euler angle: azimuth of $\mathbf e_3$", "rad")
theta = _real("theta", Glyph("θ"), r"second Euler angle: polar angle of $\mathbf e_3$", "rad")
psi = _real("psi", Glyph("ψ"), r"third Euler angle: turn about $\mathbf e_3$", "rad")
const = _real("const", Glyph("const"), "a value that does not change in time", "")
xhat = _real("xhat", Glyph("x", accent="hat", bold=True), "first axis of the space frame", "")
yhat = _real("yhat", Glyph("y", accent="hat", bold=True), "second axis of the space frame", "")
zhat = _real("zhat", Glyph("z", accent="hat", bold=True), "vertical of the space frame", "")
e1 = _real("e1", Glyph("e", "1", bold=True), "first principal axis of the body", "")
e2 = _real("e2", Glyph("e", "2", bold=True), "second principal axis of the body", "")
e1p = _real(
    "e1p",
    Glyph("e", "1", bold=True, prime=True),
    r"$\mathbf e_1$ before the last Euler rotation",
    "",
)
e2p = _real(
    "e2p", Glyph("e", "2", bold=True, prime=True), r"line of nodes: $\mathbf e_2$ after $\phi$", ""
)
e3 = _real("e3", Glyph("e", "3", bold=True), "third principal axis: figure axis", "")
e3dot = _real(
    "e3dot",
    Glyph("e", "3", accent="dot", bold=True),
    r"velocity of the tip of $\mathbf e_3$",
    "1/s",
)
n_1 = _real("n_1", Glyph("n", "1", bold=True), "axis of the first rotation, a unit vector", "")
n_2 = _real("n_2", Glyph("n", "2", bold=True), "axis of the second rotation, a unit vector", "")
s_vec = _real("s_vec", Glyph("s", bold=True), "axis of a rotation times sine of its angle", "")
h_vec = _real(
    "h_vec", Glyph("h", bold=True), r"horizontal direction in which $\mathbf e_3$ leans", ""
)
omega_phi = _real(
    "omega_phi", Glyph("ω", "φ", bold=True), r"rotational velocity of $\phi$", "rad/s"
)
omega_theta = _real(
    "omega_theta", Glyph("ω", "θ", bold=True), r"rotational velocity of $\theta$", "rad/s"
)
omega_psi = _real(
    "omega_psi", Glyph("ω", "ψ", bold=True), r"rotational velocity of $\psi$", "rad/s"
)
omega_vec = _real("omega_vec", Glyph("ω", bold=True), "rotational velocity", "rad/s")
zeta_vec = _real(
    "zeta_vec", Glyph("ζ", bold=True), "rotational velocity of a ball relative to the body", "rad/s"
)
Omega_vec = _real("Omega_vec", Glyph("Ω", bold=True), "rotational velocity of precession", "rad/s")
L_vec = _real("L_vec", Glyph("L", bold=True), "angular momentum", "J s")
L_vecdot = _real(
    "L_vecdot", Glyph("L", accent="dot", bold=True), "rate of the angular momentum", "N m"
)
N_vec = _real("N_vec", Glyph("N", bold=True), "torque", "N m")
N_ext = _real("N_ext", Glyph("N", "ext", bold=True), "external torque", "N m")
r_vec = _real("r_vec", Glyph("r", bold=True), "position in space components", "m")
r_vecp = _real("r_vecp", Glyph("r", bold=True, prime=True), "position in body components", "m")
r_k = _real("r_k", Glyph("r", "k", bold=True), "position of particle $k$", "m")
F_k = _real("F_k", Glyph("F", "k", bold=True), "external force on particle $k$", "N")
r_l = _real("r_l", Glyph("r", "l", bold=True), "position of particle $l$", "m")
F_kl = _real("F_kl", Glyph("F", "kl", bold=True), "force on particle $k$ from particle $l$", "N")
F_lk = _real("F_lk", Glyph("F", "lk", bold=True), "force on particle $l$ from particle $k$", "N")
N_in = _real("N_in", Glyph("N", "in", bold=True), "torque of the inner forces", "N m")
f_r = _real("f_r", Glyph("f", bold=True), "force density", "N/m³")
R_CM = _real("R_CM", Glyph("R", "CM", bold=True), "centre of mass from the origin", "m")
g_vec = _real("g_vec", Glyph("g", bold=True), "acceleration of gravity as a vector", "m/s²")
follower = _real(
    "follower", Glyph("w", bold=True), r"a vector that turns along behind $\omega$", ""
)
r_1 = _real(
    "r_1", Glyph("r", "1", bold=True), "position of the first mass, or the middle of a disc", "m"
)
r_2 = _real(
    "r_2", Glyph("r", "2", bold=True), "position of the second mass, or the middle of a stem", "m"
)
v_1 = _real("v_1", Glyph("v", "1", bold=True), "velocity of the first mass", "m/s")
v_2 = _real("v_2", Glyph("v", "2", bold=True), "velocity of the second mass", "m/s")
u_vec = _real("u_vec", Glyph("u", bold=True), "any vector", "")
v_vec = _real("v_vec", Glyph("v", bold=True), "any vector", "")
v_tip = _real("v_tip", Glyph("v", "tip", bold=True), "velocity of the contact point", "m/s")
r_tip = _real("r_tip", Glyph("r", "tip", bold=True), "contact point from the centre of mass", "m")
v_CM = _real("v_CM", Glyph("v", "CM", bold=True), "velocity of the centre of mass", "m/s")
omega_perp = _real(
    "omega_perp",
    Glyph("ω", "⊥", bold=True),
    "rotational velocity perpendicular to the stick",
    "rad/s",
)
L_later = _real(
    "L_later", Glyph("L", "later", bold=True), "angular momentum half a turn later", "J s"
)
F_grav = _real("F_grav", Glyph("F", "grav", bold=True), "weight", "N")

VOCABULARY: Mapping[Symbol, VocabularyEntry] = MappingProxyType(_ROWS)
"""Every symbol with its glyph, meaning and unit, in the order of print."""
