"""Section 3.5.3: precession in the Lagrange formalism."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sympy import Eq, Gt, Lt, Matrix, Ne, cos, sin

from rigidtop.proof.equation import Equation, symbols_of, value
from rigidtop.proof.page import Assumption, Check, Evidence, Formal, Page, Remark, Step, claim
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.lagrangian import momenta
from rigidtop.theory.rotation import Z_AXIS, primed_matrix

from .euler_angles import SYMMETRIC, TILTED, momentum_along_axes
from .printed import printed

UP = {s.zhat: Matrix(Z_AXIS)}
CONSERVED = {s.const: top.along_motion}
WITHOUT_G = r"\Omega_+ = \frac{\lambda_3\omega_3}{\lambda_1\cos\theta}"
ROOTS = dict(zip((s.Omega_minus, s.Omega_plus), top.steady_roots_by_smallness(), strict=True))
EXACT = {s.epsilon: top.smallness()} | {
    root: rate.subs(s.epsilon, top.smallness()) for root, rate in ROOTS.items()
}
FAST = Assumption(
    Eq(s.epsilon, 0),
    r"$\omega_3$ very large: to leading order in $\varepsilon = \lambda_1MgR "
    r"\cos\theta/(\lambda_3\omega_3)^2$",
    stated=True,
    otherwise=top.smallness(),
)
SPINNING = Assumption(Ne(s.omega3, 0), r"the top spins about $\mathbf e_3$", stated=True)
FORWARD = Assumption(
    Gt(s.omega3, 0),
    r"$\omega_3$ counts positive: for $\omega_3 < 0$ the two roots change places",
    stated=True,
)
HORIZONTAL = Assumption(Ne(cos(s.theta), 0), "the top is not horizontal, where there is one root")
ON_AXIS = tuple(
    Assumption(
        Eq(x, place),
        r"the centre of mass lies on $\mathbf e_3$, at $R$ from the pivot",
        stated=True,
    )
    for x, place in zip(top.CENTRE_OF_MASS, (0, 0, s.R), strict=True)
)


@claim("3.53", "Lagrangian of the heavy symmetric top.")
def lagrangian() -> Iterator[Evidence]:
    """$T$ of (3.44) minus the potential; the engine starts from three moments and any centre."""
    yield Check(printed("3.53"), {s.Lagrangian: top.lagrangian()}, (SYMMETRIC, *ON_AXIS))


@claim("3.54", r"Equation of motion for $\theta$.")
def theta_equation() -> Iterator[Evidence]:
    r"""Lagrange's equation of (3.53) for $\theta$."""
    line = printed("3.54")
    yield Check(line, {s.thetaddot: top.symmetric_top_accelerations()[0]})
    yield Formal(line, {s.thetaddot: top.newton_euler_thetaddot()})  # without a Lagrangian


@claim("3.55", r"$p_\phi$ is constant.")
def momentum_phi() -> Iterator[Evidence]:
    r"""$\phi$ does not enter (3.53), so $\partial\mathcal{L}/\partial\dot\phi$ is conserved."""
    yield Check(printed("3.55"), {s.p_phi: top.symmetric_momenta()[1], **CONSERVED})


@claim("3.56", r"$p_\psi$ is constant.")
def momentum_psi() -> Iterator[Evidence]:
    r"""$\psi$ does not enter (3.53) either."""
    from . import evidence

    yield Check(printed("3.56"), {s.p_psi: top.symmetric_momenta()[2], **CONSERVED})
    yield from evidence.conserved()


@claim("p-phi-is-Lz", r"$p_\phi$ is $L_z$.")
def p_phi_is_l_z() -> Iterator[Evidence]:
    r"""$\partial T/\partial\dot\phi$ is $\hat{\mathbf z}\cdot\mathbf L$ for every body, since
    $\phi$ turns the whole body about $\hat{\mathbf z}$."""
    meaning = {s.p_phi: momenta(top.lagrangian(), top.RATES)[1], **momentum_along_axes()}
    formula = Equation(s.L_z, printed("3.55").sides[1])
    yield Formal(printed("p-phi-is-Lz"), meaning)
    yield Formal(formula, meaning, (replace(SYMMETRIC, words="a symmetric top has (3.55)"),))


@claim("p-psi-is-L3", r"$p_\psi$ is $L_3$.")
def p_psi_is_l_3() -> Iterator[Evidence]:
    r"""$\partial T/\partial\dot\psi$ is $\mathbf e_3\cdot\mathbf L$ for every body; it is
    conserved if the body is symmetric about $\mathbf e_3$."""
    meaning = {s.p_psi: momenta(top.lagrangian(), top.RATES)[2], **momentum_along_axes()}
    yield Formal(printed(r"p_\psi = L_3"), meaning)


@claim("constant-rate", r"Constant $\theta$ implies constant $\dot\phi$.")
def constant_rate() -> Iterator[Evidence]:
    r"""$\dot p_\phi = \cos\theta \dot p_\psi$ at constant $\theta$ is $\lambda_1
    \sin^2\theta \ddot\phi = 0$; upright, $\dot\phi$ and $\dot\psi$ may do as they like."""
    equations = top.symmetric_equations()
    balance = ((equations[1] - cos(s.theta) * equations[2]).expand(),)
    steady = (Assumption(Eq(s.thetadot, 0), r"$\theta$ is constant", stated=True), TILTED)
    rates, _, constant = printed.lines("constant-rate")
    yield Formal(rates, given=balance)
    yield Formal(constant, {}, steady, given=balance)


@claim("3.57", "The quadratic for the rate of steady precession.")
def steady_precession() -> Iterator[Evidence]:
    r"""$\ddot\theta$ vanishes in (3.54); dividing by $\sin\theta$ loses the tops for which
    every $\Omega$ is steady."""
    from . import evidence

    resting = top.symmetric_equations()[0].subs({s.thetaddot: 0, s.thetadot: 0})
    steady = {s.phidot: s.Omega, s.psidot: s.omega3 - s.Omega * cos(s.theta)}
    balance, divided, ordered = printed.lines("3.57")
    yield Check(balance, given=(resting,))
    for line in (divided, ordered):
        yield Check(line, steady, (TILTED,), given=(top.steady_balance(),))
    yield from evidence.steady_precession()


@claim(
    "two-roots",
    r"Two solutions; for large $\omega_3$ a slow one, $MgR/(\lambda_3\omega_3)$, and a fast one, "
    r"$\lambda_3\omega_3/(\lambda_1 \cos\theta)$.",
)
def two_roots() -> Iterator[Evidence]:
    r"""The standard formula, written so that neither root cancels for large $\omega_3$."""
    meaning = {s.D: top.discriminant()}
    for root, exact in zip((s.Omega_minus, s.Omega_plus), top.steady_roots(), strict=True):
        yield Step(Equation(root, exact), r"For $\omega_3 > 0$; regular at $\cos\theta = 0$.")
        meaning[root] = exact
    yield Formal(printed(r"\lambda_1\cos\theta \neq 0"), {}, (HORIZONTAL,))
    below = Assumption(Lt(cos(s.theta), 0), "the top hangs below the horizontal")
    two = printed("D > 0")
    spin = s.lambda3**2 * s.omega3**2
    above = Assumption(Gt(spin, spin - top.discriminant()), "the spin is above the threshold")
    yield Formal(two, meaning, (above,))
    yield Remark(two, meaning, (below,), "Below the horizontal there is no threshold.")
    for line in printed.lines("two-roots"):
        if line.sides[0] in ROOTS and line.relation == "=" and s.epsilon in symbols_of(line):
            yield Formal(line, EXACT, (FORWARD, HORIZONTAL))
    yield Check(printed(r"\Omega_- = \frac{MgR}{\lambda_3\omega_3}"), ROOTS, (FAST, FORWARD))
    yield Check(printed(WITHOUT_G), ROOTS, (FAST, FORWARD, HORIZONTAL))


@claim(
    "slow-agrees",
    r"$\Omega_-$ agrees with (3.52); that $\omega_3$ is large means the same as that the torque is "
    "weak.",
)
def slow_agrees() -> Iterator[Evidence]:
    r"""$\Omega_- \lambda_3\omega_3/(MgR)$ depends on $\varepsilon$ alone: $\delta$ times the
    spin does what $1/\delta^2$ times the weight does."""
    meaning = {**ROOTS, **UP, s.Omega_vec: value(printed("3.52").sides[1], UP)}
    scaled = Assumption(Ne(s.delta, 0), r"the spin is multiplied by $\delta$", stated=True)
    footnote = printed(
        r"\frac{\lambda_1MgR\cos\theta}{(\lambda_3\delta\omega_3)^2}"
        r" = \frac{\varepsilon}{\delta^2}"
    )
    yield Formal(footnote, {s.epsilon: top.smallness()}, (scaled, SPINNING))
    slow = r"\lambda_3\omega_3\Omega_-(1 + \sqrt{1 - 4\varepsilon}) = 2MgR"
    yield Formal(printed(slow), EXACT, (FORWARD,))
    yield Formal(
        printed(r"\Omega_- = \boldsymbol\Omega\cdot\hat{\mathbf z}"), meaning, (FAST, FORWARD)
    )


@claim("fast-is-free", r"$\Omega_+$ does not depend on $g$ and is the free precession of 3.2.3.")
def fast_is_free() -> Iterator[Evidence]:
    r"""Without weight the top turns about $\mathbf L$ at $\Omega_s = L/\lambda_1$ (not
    $\Omega_b$), $\mathbf L$ vertical if $\theta$ is constant."""
    from . import evidence

    across = -s.lambda1 * ROOTS[s.Omega_plus] * sin(s.theta)
    momentum = primed_matrix() * Matrix([across, 0, s.lambda3 * s.omega3])
    meaning = {**ROOTS, **UP, s.L_vec: momentum}
    free = printed(r"\Omega_+\hat{\mathbf z} = \frac{\mathbf L}{\lambda_1}")
    yield Formal(printed(WITHOUT_G), meaning, (FAST, FORWARD, HORIZONTAL))
    yield Formal(free, meaning, (FAST, FORWARD))
    yield from evidence.fast_root_is_free()


page = Page(
    "3.5.3",
    "Precession in the Lagrange formalism",
    r"The heavy symmetric top, without the assumption $\mathbf L \parallel \boldsymbol\omega$.",
    (
        lagrangian,
        theta_equation,
        momentum_phi,
        momentum_psi,
        p_phi_is_l_z,
        p_psi_is_l_3,
        constant_rate,
        steady_precession,
        two_roots,
        slow_agrees,
        fast_is_free,
    ),
    text="lagrange_formalism",
)
