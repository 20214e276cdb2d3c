"""Section 3.5.2: L beside ω, the toppling top, the gyroscope, the bicycle wheel."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from math import asin, atan, atan2, cos, factorial, hypot, pi, sin, sqrt

import numpy as np
import sympy
from numpy.typing import NDArray
from scipy.integrate import quad
from scipy.optimize import brentq, minimize_scalar
from scipy.special import elliprf
from sympy import Expr, Gt, Matrix, Ne

from rigidtop.derivations.euler_angles import TILTED
from rigidtop.derivations.simplified_picture import (
    SPINNING,
    parallel,
    precession_vector,
    toppling,
    torque_direction,
)
from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import ROUNDING, HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.equation import Cross, Dot, Equation, Group, as_printed
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Assumption, Check, Evidence, Measure, Step, claim
from rigidtop.theory import top as theory
from rigidtop.theory.inertia import cylinder, parallel_axis, torus
from rigidtop.theory.lagrangian import energy
from rigidtop.theory.rotation import Z_AXIS
from rigidtop.theory.symbols import (
    F,
    L_vec,
    M,
    N_vec,
    Omega,
    Omega_minus,
    R,
    chi,
    delta,
    e3,
    epsilon,
    epsilon_0,
    g,
    height,
    kappa,
    lambda1,
    lambda3,
    m,
    omega1p,
    omega2p,
    omega3,
    omega_0,
    omega_vec,
    phi,
    phidot,
    psidot,
    radius,
    t,
    t_chi2,
    tau,
    theta,
    theta_i,
    thetadot,
    zhat,
)
from rigidtop.theory.trig import reduce_ratio, reduce_trig

from .bodies import ARM, GRAVITY, HEAVY_TOP, LAMBDA1, MASS, SPIN


@cache
def conserved() -> tuple[Expr, Expr]:
    """What has not changed since a top was released at θ_i with ω along e₃: E (J) and p_φ (J s).

    Both as they are now less as they were, which is zero; cos θ_i = cos θ + δ.
    """
    now = {psidot: omega3 - phidot * sympy.cos(theta)}
    start = {psidot: omega3, phidot: 0, thetadot: 0}
    total = energy(theory.symmetric_lagrangian(), theory.RATES)
    changed = []
    for quantity in (total, theory.symmetric_momenta()[1]):
        then = quantity.subs(start).subs(sympy.cos(theta), sympy.cos(theta) + delta)
        changed.append(reduce_trig(quantity.subs(now) - then, keep="sin"))
    return changed[0], changed[1]


@cache
def released() -> dict[Expr, Expr]:
    """δ, ω₃ and ε₀ of the release from which a top came to be at θ with ω₁′ and ω₂′ across e₃."""
    total, momentum = conserved()
    [sunk] = sympy.solve(total, delta)
    [spin] = sympy.solve(momentum.subs(delta, sunk), omega3)
    across = {phidot: -omega1p / sympy.sin(theta), thetadot: omega2p}
    state = {name: reduce_ratio(x.subs(across)) for name, x in ((delta, sunk), (omega3, spin))}
    weak = theory.smallness() / sympy.cos(theta)
    return {**state, epsilon_0: reduce_ratio(weak.subs(state))}


@claim("bound-on-the-axis", "A top released with ω along e₃ keeps |ω⊥| ≤ 2Ω sin θ, Ω of (3.52).")
def bound_on_the_axis() -> Iterator[Evidence]:
    """What the top has sunk, δ = cos θᵢ − cos θ, gives the energy of ω⊥, and L_z its direction.

    Together: |λ₃ω₃| |ω⊥| ≤ 2MgR sin θ at any spin, with both sides equal where θ is largest.
    """
    with as_printed():
        across = Group(omega1p**2 + omega2p**2)
        torque = 4 * Group(M * g * R) ** 2 * sympy.sin(theta) ** 2
        momentum = Group(lambda3 * omega3) ** 2
        sinking = Equation(lambda1 * across, 2 * M * g * R * delta)
        turning = Equation(lambda3 * omega3 * delta, -lambda1 * omega1p * sympy.sin(theta))
        short_of = Equation(
            delta * Group(torque - momentum * across),
            2 * lambda1 * M * g * R * omega2p**2 * sympy.sin(theta) ** 2,
        )
        bound = Equation(momentum * across, torque, relation="<")
    state = released()
    yield Check(sinking, state, reason="By energy: the top can only sink.", printed=False)
    yield Check(turning, state, reason="L_z is what it was.", printed=False)
    yield Check(short_of, state, reason="From both.", printed=False)
    moving = Assumption(Ne(omega2p, 0), "θ changes: at the lowest point both sides are equal")
    yield Check(bound, state, (moving, TILTED), "The square of the bound.", printed=False)


@claim("bound-on-the-tilt", "Where it is lowest, sin²θ < sin²θᵢ/(1 − 4ε₀ cos θᵢ).")
def bound_on_the_tilt() -> Iterator[Evidence]:
    """|ω⊥| is largest where the top is lowest, by energy; there θ̇ = ω₂′ = 0 and δ = 2ε₀ sin²θ.

    So the top that starts at θᵢ stays near it, and |ω⊥| near 2Ω sin θᵢ at most, if 4ε₀ cos θᵢ is
    small. It says nothing where that exceeds 1: below the spin of a steady precession at θᵢ.
    """
    sine2 = 1 - (sympy.cos(theta_i) - delta) ** 2
    sunk = {sympy.sin(theta): sympy.sqrt(sine2)}
    with as_printed():
        reach = Group(2 * epsilon_0 * sympy.sin(theta) ** 2 - delta)
        narrowed = Group(1 - 4 * epsilon_0 * sympy.cos(theta_i)) * sympy.sin(theta) ** 2
        lowest = Equation(omega1p**2 * reach, delta * omega2p**2)
        tilts = Equation(
            sympy.sin(theta_i) ** 2 - narrowed, delta**2 + 2 * sympy.cos(theta_i) * reach
        )
        bound = Equation(narrowed, sympy.sin(theta_i) ** 2, relation="<")
    yield Check(
        lowest, released(), reason="The bracket is zero at the lowest point.", printed=False
    )
    yield Check(tilts, sunk, reason="With cos θ = cos θᵢ − δ.", printed=False)
    yield Check(
        bound,
        {**sunk, epsilon_0: delta / (2 * sine2)},
        (Assumption(Ne(delta, 0), "the top has sunk: it is not at the start"),),
        "With the bracket zero: δ² is left.",
        printed=False,
    )


@claim(
    "bound-on-the-angle", "tan of the angle between L and ω ≤ 2ε₀|1 − λ₃/λ₁| sin θ at all times."
)
def bound_on_the_angle() -> Iterator[Evidence]:
    """tan of the angle is |L × ω|/L·ω, and L·ω is at least λ₃ω₃².

    With ω⊥ = ω₀ as large as it may be it is 2|λ₁ − λ₃| MgR sin θ/(λ₃ω₃)² at most: first order in
    the torque, ε₀ = λ₁MgR/(λ₃ω₃)². At the lowest point sin θ is at most sin θᵢ/√(1 − 4ε₀ cos θᵢ),
    so that L ∥ ω is as good an approximation as ε₀ is small.
    """
    parts = {
        L_vec: Matrix([lambda1 * omega_0, 0, lambda3 * omega3]),
        omega_vec: Matrix([omega_0, 0, omega3]),
    }
    with as_printed():
        crossed = Dot(Cross(L_vec, omega_vec), Cross(L_vec, omega_vec))
        apart = Group(lambda1 - lambda3) ** 2
        size = Equation(crossed, apart * omega3**2 * omega_0**2)
        along = Equation(Dot(L_vec, omega_vec), lambda1 * omega_0**2 + lambda3 * omega3**2)
        bound = Equation(
            Group(lambda3 * omega3) ** 4 * crossed,
            4 * apart * Group(M * g * R) ** 2 * sympy.sin(theta) ** 2 * Dot(L_vec, omega_vec) ** 2,
            relation="<",
        )
    yield Check(size, parts, reason="Across each other,", printed=False)
    yield Check(along, parts, reason="and along.", printed=False)
    # The bound on ω₀ as an equality: 4(MgR)² sin²θ = (λ₃ω₃)²(ω₀² + κ).
    allowed = lambda3 * omega3 * sympy.sqrt(omega_0**2 + kappa) / (2 * M * g * R)
    yield Check(
        bound,
        {**parts, sympy.sin(theta): allowed},
        (
            Assumption(Ne(lambda1, lambda3), "not a spherical top, whose L and ω are parallel"),
            Assumption(Gt(kappa, 0), "κ is by how much ω₀² stays below its bound"),
            SPINNING,
        ),
        "The square of the bound.",
        printed=False,
    )


def powers(expression: Expr, order: int) -> Expr:
    """The Taylor series of an expression in ε₀, up to this power."""
    terms = (
        expression.diff(epsilon_0, n).subs(epsilon_0, 0) / factorial(n) for n in range(order + 1)
    )
    return sum(term * epsilon_0**n for n, term in enumerate(terms))


@cache
def mean_over_simple() -> Expr:
    """Mean φ̇ over MgR/(λ₃ω₃) of a top released with ω along e₃, to first order in ε₀."""
    total, momentum = conserved()
    [azimuth] = sympy.solve(momentum, phidot)
    square = sympy.Symbol("square")
    [fall] = sympy.solve(total.subs(phidot, azimuth).subs(thetadot**2, square), square)
    sine2 = 1 - (sympy.cos(theta_i) - delta) ** 2
    weak = {M: epsilon_0 * (lambda3 * omega3) ** 2 / (lambda1 * g * R)}
    # The square of dδ/dt = θ̇ sin θ is δ times a quadratic: δ is zero at the start, δ₂ at the lowest
    # point, and the third zero δ₃ is negative.
    cubic = sympy.expand(fall * sympy.sin(theta) ** 2).subs(sympy.sin(theta) ** 2, sine2)
    c2, c1, c0 = sympy.Poly(sympy.cancel(cubic.subs(weak) / delta), delta).all_coeffs()
    root = sympy.sqrt(sympy.cancel(1 - 4 * c2 * c0 / c1**2))
    lowest = powers(sympy.cancel(-2 * c0 / c1) / (1 + root), 2)
    # With δ = δ₂ sin²χ the time is an integral over χ from 0 to π/2 of 1/√(1 − δ/δ₃).
    moved = lowest * sympy.sin(chi) ** 2
    slowness = 1 / sympy.sqrt(1 - sympy.cancel(moved * lowest * c2 / c0))
    simple = (M * g * R / (lambda3 * omega3)).subs(weak)
    rate = sympy.cancel((azimuth.subs(sympy.sin(theta) ** 2, sine2) / simple).subs(delta, moved))
    over, whole = (
        sympy.integrate(powers(x, 1), (chi, 0, sympy.pi / 2)) for x in (rate * slowness, slowness)
    )
    return powers(over / whole, 1)


@claim("mean-of-the-cusps", "The mean precession of a released top is (3.52) times 1 + ε₀ cos θᵢ.")
def mean_of_the_cusps() -> Iterator[Evidence]:
    """φ̇ of L_z averaged over a nutation, with δ between its turning points, to first order in ε₀.

    It is the rate Ω₋ of a steady precession at θᵢ: to this order the nutation changes nothing.
    """
    simple = M * g * R / (lambda3 * omega3)
    mean = mean_over_simple()
    weak = (theory.smallness() / sympy.cos(theta)).subs(theta, theta_i)
    with as_printed():
        faster = Equation(
            lambda3 * omega3 * Omega, M * g * R * Group(1 + epsilon_0 * sympy.cos(theta_i))
        )
        steady = Equation(Omega, Omega_minus)
    yield Check(
        faster,
        {Omega: simple * mean},
        reason="To first order in ε₀ of the weak torque.",
        printed=False,
    )
    yield Check(
        steady,
        {
            Omega: simple * mean.subs(epsilon_0, weak),
            Omega_minus: theory.steady_expansions(2)[0].subs(theta, theta_i),
        },
        reason="Ω₋ of (3.57), to the same order.",
        printed=False,
    )


def smallness(top: HeavyTop, spin: float) -> float:
    """ε₀ = λ₁MgR/(λ₃ω₃)²."""
    return top.lambda1 * top.weight[2] / (top.lambda3 * spin) ** 2


def bound_of_angle(top: HeavyTop, start: float, spin: float) -> float:
    """No angle between L and ω of a top released at θ = `start` with ω along e₃ exceeds this (rad).

    sin θ ≤ 1 besides, where the spin is too low for the bound on the tilt.
    """
    weak = smallness(top, spin)
    narrowed = 1 - 4 * weak * cos(start)
    sine = min(1.0, sin(start) / sqrt(narrowed)) if narrowed > 0 else 1.0
    return atan(2 * weak * abs(1 - top.lambda3 / top.lambda1) * sine)


def fastest_across(top: HeavyTop, theta: float, omega3: float) -> float:
    """The largest |ω⊥| of a top released at θ with ω along e₃: at its lowest point (rad/s)."""
    if sin(theta) == 0:
        return 0.0  # nothing disturbs it
    weak = smallness(top, omega3)
    # δ = 2ε₀ sin²θ there, with cos θ = cos θᵢ − δ; without differences of large numbers.
    linear, torque = 1 - 4 * weak * cos(theta), 4 * weak * sin(theta)
    root = hypot(linear, torque)
    sunk = torque * sin(theta) / (root + linear) if linear > 0 else (root - linear) / (4 * weak)
    return sqrt(2 * top.weight[2] * sunk / top.lambda1)


def largest_angle(top: HeavyTop, theta: float, omega3: float) -> float:
    """The largest angle between L and ω of a top released at θ with ω along e₃ (rad).

    Its tangent |λ₁ − λ₃| |ω₃| |ω⊥|/(λ₁ω⊥² + λ₃ω₃²) grows up to λ₁ω⊥² = λ₃ω₃². A fast top stays
    below that: its angle is largest where it is lowest. A slow top comes past it on its way.
    """
    across = min(fastest_across(top, theta, omega3), sqrt(top.lambda3 / top.lambda1) * abs(omega3))
    crossed = abs((top.lambda1 - top.lambda3) * omega3) * across
    return atan2(crossed, top.lambda1 * across**2 + top.lambda3 * omega3**2)


def angle_between(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Of the rows (N, 3) of both (rad)."""
    across = np.linalg.norm(np.cross(a, b), axis=1)
    return np.asarray(np.arctan2(across, np.sum(a * b, axis=1)))


def widest_on_the_way(motion: TopMotion) -> float:
    """The largest angle between L and ω in space on the way down, integrated (rad)."""

    def missing(time: float) -> float:
        path = motion.integrate(time, rtol=1e-12, atol=1e-14)
        return -float(angle_between(path.angular_momentum, path.omega_space)[0])

    down = motion.nutation_period / 2
    # The angle has one maximum on the way, or is largest at its end.
    found = minimize_scalar(
        missing, bounds=(0.0, down), method="bounded", options={"xatol": 1e-12 * down}
    )
    return max(-float(found.fun), -missing(down))


DOUBLINGS = 8


@exercise(
    "parallel-bound",
    "How nearly L is parallel to ω",
    section="3.5.2",
    asks="“this would have to be shown”",
    statement="A top is released at the angle θ, spinning about e₃, so that at first L and ω are "
    "parallel. Show that for a weak torque they stay nearly so: find a bound on the angle between "
    "them, for all times, in terms of ε₀ = λ₁MgR/(λ₃ω₃)².\n\n"
    "How good is the bound? Double the spin again and again, and compare with the largest angle of "
    "the exact motion. How good is (3.52) for the mean precession?",
    claims=(parallel, bound_on_the_axis, bound_on_the_tilt, bound_on_the_angle, mean_of_the_cusps),
    parameters=(
        Parameter("theta", pi / 6, "θ at the start", "rad", above=0, most=3.1),
        SPIN,
        *HEAVY_TOP,
    ),
    figure="parallel",
)
def parallel_bound(
    theta: float, omega3: float, lambda1: float, lambda3: float, M: float, R: float, g: float
) -> Iterator[Outcome]:
    """The largest angle is a closed form: at the lowest point of a fast top, on the way to it of a
    slow one. The mean precession of the exact motion is a closed form too. The table doubles the
    spin from row to row. The motion integrated with quaternions is searched for the same angle."""
    top = HeavyTop(lambda1=lambda1, lambda3=lambda3, M=M, R=R, g=g)
    if omega3 == 0:
        raise RigidtopError(
            "omega3 must not be 0: without spin the top topples, and ε₀ is infinite"
        )
    if lambda1 == lambda3:
        raise RigidtopError("lambda1 and lambda3 must differ: with equal moments L is along ω")

    def compared(spin: float) -> tuple[float, ...]:
        weak, bound = smallness(top, spin), bound_of_angle(top, theta, spin)
        largest = largest_angle(top, theta, spin)
        mean = top.motion(theta=theta, omega3=spin).mean_precession
        off = mean / (top.weight[2] / (lambda3 * spin)) - 1
        return spin, weak, bound, largest, largest / bound, mean, off, off / weak

    rows = tuple(compared(omega3 * 2**k) for k in range(DOUBLINGS))
    _, weak, bound, largest, share, mean, off, _ = rows[0]
    yield Answer("epsilon_0", "ε₀", weak)
    yield Answer("bound", "no angle between L and ω exceeds", bound, "rad")
    yield Answer("largest", "the largest angle is", largest, "rad")
    yield Answer("share", "the largest angle over the bound", share)
    yield Answer("simple", "Ω by (3.52)", top.weight[2] / (lambda3 * omega3), "rad/s")
    yield Answer("mean", "mean precession", mean, "rad/s")
    yield Answer("off", "by how much it exceeds (3.52), relative", off)
    yield Answer("off_first_order", "ε₀ cos θ, of which that is to first order", weak * cos(theta))
    yield Table(
        "spins",
        "the spin doubled again and again",
        (
            "ω₃ (rad/s)",
            "ε₀",
            "bound (rad)",
            "largest angle (rad)",
            "their ratio",
            "mean φ̇ (rad/s)",
            "excess over (3.52)",
            "excess/ε₀",
        ),
        rows,
    )

    above = max(row[4] for row in rows) - 1
    yield Measure("by how much any angle of the table exceeds its bound", max(above, 0.0), 1e-9)
    motion = top.motion(theta=theta, omega3=omega3)
    yield Measure(
        "the largest angle against that of L and ω in space, integrated (rad)",
        abs(widest_on_the_way(motion) - largest),
        1e-11,
    )
    lowest = motion.turning_points[1]
    path = motion.integrate(motion.nutation_period / 2, rtol=1e-12, atol=1e-14)
    across = float(np.hypot(*path.omega[0, :2]))
    yield Measure(
        "|ω⊥| at the lowest point against 2Ω sin θ there, relative",
        abs(across / (2 * top.weight[2] * sin(lowest) / abs(lambda3 * omega3)) - 1),
        1e-8,
    )


def fall_rate_squared() -> Expr:
    """θ̇² of a top let go at θ_i without rotation, from its energy (rad²/s²)."""
    falling = theory.symmetric_lagrangian().subs({phidot: 0, psidot: 0})
    gained = energy(falling, [thetadot])
    at_rest = gained.subs({thetadot: 0, theta: theta_i})
    square = sympy.Symbol("square")
    [rate] = sympy.solve((gained - at_rest).subs(thetadot**2, square), square)
    return rate


@claim("time-to-fall", "A top let go at θᵢ at rest takes the time of an elliptic integral to fall.")
def time_to_fall() -> Iterator[Evidence]:
    """The energy gives θ̇, and the time is the integral of dθ/θ̇.

    With m = cos²(θᵢ/2) and cos(θ/2) = √m sin χ it is Legendre's integral of the first kind; χ falls
    from π/2 at the start. A pendulum would take as long from π − θᵢ to π − θ.
    """
    with as_printed():
        rate = Equation(
            thetadot**2, 2 * M * g * R / lambda1 * (sympy.cos(theta_i) - sympy.cos(theta))
        )
        legendre = Equation(Group(1 - m * sympy.sin(chi) ** 2) * t_chi2, lambda1 / (M * g * R))
        whole = Equation(
            t,
            sympy.sqrt(lambda1 / (M * g * R)) * (sympy.elliptic_k(m) - sympy.elliptic_f(chi, m)),
        )
    derived = fall_rate_squared()
    yield Check(rate, {thetadot: sympy.sqrt(derived)}, reason="By energy.", printed=False)
    # cos θ = 2 cos²(θ/2) − 1, at the start and later.
    cosine = 2 * m * sympy.sin(chi) ** 2 - 1
    against_chi = cosine.diff(chi) ** 2 / (1 - cosine**2)
    slope = against_chi / derived.subs({sympy.cos(theta): cosine, sympy.cos(theta_i): 2 * m - 1})
    yield Check(
        legendre,
        {t_chi2: reduce_ratio(slope)},
        reason="(dθ/dχ)² over θ̇² is the square of dt/dχ.",
        printed=False,
    )
    yield Step(whole, "Integrated from χ to π/2.")
    top = HeavyTop(lambda1=1.3, lambda3=0.7, M=0.8, R=0.6)
    start, end = 0.4, 2.5
    seconds, _ = fall(top, start, end)
    fallen = top.motion(theta=start, omega3=0.0).integrate(seconds, rtol=1e-12, atol=1e-14)
    yield Measure("θ at that time, integrated (rad)", abs(float(fallen.theta[0]) - end), 1e-9)


def fall(top: HeavyTop, start: float, end: float) -> tuple[float, float]:
    """The time (s) from rest at θ = `start` to `end` ≥ `start` (rad), and θ̇ then (rad/s)."""
    slowest = sqrt(top.lambda1 / top.weight[2])
    fallen = sin((end - start) / 2) * sin((end + start) / 2)  # cos²(θᵢ/2) − cos²(θ/2)
    # K(m) − F(χ, m) = F(β, m) with tan β = cot χ/√(1 − m) (DLMF 19.11.7), in Carlson's form
    # (19.25.5), which keeps its digits for a top that is let go close to the upright.
    across = (sin(start / 2) * cos(end / 2)) ** 2
    sine2, cosine2 = fallen / (fallen + across), across / (fallen + across)
    legendre = sqrt(sine2) * elliprf(cosine2, cosine2 + sin(start / 2) ** 2 * sine2, 1.0)
    return slowest * float(legendre), 2 * sqrt(fallen) / slowest


@exercise(
    "toppling-top",
    "The toppling top",
    section="3.5.2",
    asks="example 34",
    statement="A top leans at the angle θ and is let go without any rotation, so that L = 0. How "
    "does L evolve, and what motion is this? How long does the top take to fall to the angle "
    "“until”, and how fast does it fall then? Compare with the "
    "time that exponential growth, which holds for small angles, would give.",
    claims=(toppling, time_to_fall),
    parameters=(
        Parameter("theta", pi / 18, "θ at the start", "rad", above=0, most=pi),
        Parameter("until", pi / 2, "θ at the end", "rad", above=0, most=pi),
        LAMBDA1,
        MASS,
        ARM,
        GRAVITY,
    ),
    figure="toppling",
)
def toppling_top(
    theta: float, until: float, lambda1: float, M: float, R: float, g: float
) -> Iterator[Outcome]:
    """The elliptic integral is evaluated; the same time comes from the integral of dθ/θ̇ by
    quadrature, and the motion in closed form is where it should be at that time."""
    if until <= theta:
        raise RigidtopError(f"until = {until:g} must be more than theta = {theta:g}: the top falls")
    # λ₃ plays no part: that of a body with three equal moments about its centre of mass.
    top = HeavyTop(lambda1=lambda1, lambda3=lambda1 - M * R**2, M=M, R=R, g=g)
    seconds, rate = fall(top, theta, until)
    growth = sqrt(top.weight[2] / lambda1)
    yield Answer("growth_rate", "growth rate κ = √(MgR/λ₁) of a small tilt", growth, "1/s")
    yield Answer("time_to_fall", "time until θ has the value “until”", seconds, "s")
    yield Answer("theta_dot", "θ̇ then", rate, "rad/s")
    yield Answer("angular_momentum", "L then, along e₂′", lambda1 * rate, "J s")
    yield Answer(
        "time_linear",
        "time by θ = θᵢ cosh κt, for comparison",
        float(np.arccosh(until / theta)) / growth,
        "s",
    )

    def slowness(x: float) -> float:
        # θ = θᵢ + (θ − θᵢ)x²: the inverse root at the start is gone.
        passed = (until - theta) * x * x
        fallen = sin(theta + passed / 2) * sin(passed / 2)
        return (until - theta) * x / (growth * sqrt(fallen))

    numeric, _ = quad(slowness, 0.0, 1.0, epsabs=0.0, epsrel=1e-12, limit=400)
    yield Measure("that time by quadrature, relative", abs(numeric / seconds - 1), 1e-10)
    moved = top.motion(theta=theta, omega3=0.0).exact(seconds)
    yield Measure("θ at that time, in closed form (rad)", abs(float(moved.theta[0]) - until), 1e-9)


@claim("spin-for-accuracy", "(3.52) is off by the share τ where ε = τ/(1 + τ)².")
def spin_for_accuracy() -> Iterator[Evidence]:
    """Ω₋ of (3.57) over what it tends to depends on ε = λ₁MgR cos θ/(λ₃ω₃)² alone; solved for ε.

    τ grows with ε, to 1 at ε = ¼: the smallest spin of steady precession, where (3.52) gives
    half of the truth.
    """
    off = theory.root_factors()[0] - 1
    with as_printed():
        needed = Equation(epsilon * Group(1 + tau) ** 2, tau)
        spin = Equation(
            epsilon * Group(lambda3 * omega3) ** 2, lambda1 * M * g * R * sympy.cos(theta)
        )
    yield Check(needed, {tau: off}, reason="τ = Ω₋ over (3.52), less 1.", printed=False)
    yield Check(spin, {epsilon: theory.smallness()}, printed=False)


def on_an_arm(about_centre: Matrix) -> Matrix:
    """The tensor about a pivot on e₃ at R from the centre (3×3, kg m²)."""
    return parallel_axis(about_centre, M, Matrix([0, 0, R]))


@claim("disc-on-an-arm", "A disc on an axle without mass, held at R: the mass drops out of Ω.")
def disc_on_an_arm() -> Iterator[Evidence]:
    """A cylinder without height, and Steiner's theorem; (3.52) with its λ₃."""
    tensor = on_an_arm(cylinder(radius, height).inertia(M).subs(height, 0))
    with as_printed():
        along = Equation(lambda3, M * radius**2 / 2)
        across = Equation(lambda1, M * Group(radius**2 / 4 + R**2))
        rate = Equation(radius**2 * omega3 * Omega, 2 * g * R)
    moments = {lambda1: tensor[0, 0], lambda3: tensor[2, 2]}
    yield Check(along, moments, printed=False)
    yield Check(across, moments, printed=False)
    simple = theory.leading_roots()[0].subs(lambda3, moments[lambda3])
    yield Check(rate, {Omega: simple}, reason="(3.52).", printed=False)


@claim("wheel-on-an-axle", "A hoop whose horizontal axle is held at one end: Ω is exact.")
def wheel_on_an_axle() -> Iterator[Evidence]:
    """A torus without thickness, and Steiner's theorem; at cos θ = 0 (3.57) has one root, (3.52).

    A cord that leans pulls along the horizontal axle with some F besides: about the centre of mass
    that has no torque, and the rate is the same. Let go at rest, the axle dips by arcsin δ.
    """
    tensor = on_an_arm(torus(radius, height).inertia(M).subs(height, 0))
    axle, vertical = Matrix([sympy.cos(phi), sympy.sin(phi), 0]), Matrix(Z_AXIS)
    pulled = (-R * axle).cross(M * g * vertical - F * axle)
    moments = {lambda1: tensor[0, 0], lambda3: tensor[2, 2]}
    horizontal = theory.steady_quadratic().subs(theta, sympy.pi / 2).subs(lambda3, tensor[2, 2])
    with as_printed():
        along = Equation(lambda3, M * radius**2)
        across = Equation(lambda1, M * Group(radius**2 / 2 + R**2))
        rate = Equation(radius**2 * omega3 * Omega, g * R)
        torque = Equation(N_vec, M * g * R * Cross(zhat, e3))
        dip = Equation(2 * epsilon_0 * Group(1 - delta**2), delta)
    yield Check(along, moments, printed=False)
    yield Check(across, moments, printed=False)
    [root] = sympy.solve(horizontal, Omega)
    yield Check(rate, {Omega: root}, reason="(3.57) at θ = 90°.", printed=False)
    yield Check(
        torque,
        {N_vec: pulled, zhat: vertical, e3: axle},
        reason="About the centre of mass, by the cord at the end of the axle.",
        printed=False,
    )
    # At the lowest point ω₂′ = 0, and released at 90°, δ = −cos θ: that takes a weight.
    lowest = {name: x.subs(omega2p, 0) for name, x in released().items()}
    [weight] = sympy.solve(lowest[delta] + sympy.cos(theta), M)
    strength = reduce_ratio(lowest[epsilon_0].subs(M, weight))
    yield Check(
        dip,
        {delta: -sympy.cos(theta), epsilon_0: strength},
        reason="Where the axle is lowest.",
        printed=False,
    )


Grains = tuple[NDArray[np.float64], NDArray[np.float64]]
"""Masses (n,) and places (n, 3) along e₁, e₂, e₃ from the pivot."""


def hoop(mass: float, radius: float, arm: float) -> Grains:
    """Six equal grains on a circle about e₃: they have the mass, centre and moments of a hoop."""
    turns = 2 * pi * np.arange(6) / 6
    places = np.stack(
        [radius * np.cos(turns), radius * np.sin(turns), np.full_like(turns, arm)], axis=1
    )
    return np.full(6, mass / 6), places


def disc(mass: float, radius: float, arm: float) -> Grains:
    """Half of the mass on the rim and half at the centre: those of a uniform disc."""
    masses, places = hoop(mass / 2, radius, arm)
    return np.append(masses, mass / 2), np.vstack([places, [0.0, 0.0, arm]])


def steadily_moved(grains: Grains, theta: float, rate: float, omega3: float) -> Grains:
    """Places and accelerations in space of grains in steady precession, by Rz(φ)Ry(θ)Rz(ψ).

    φ̇ = `rate` and ψ̇ = ω₃ − φ̇ cos θ are constant, so that each d/dt of the product is a factor
    φ̇ ẑ× in front or ψ̇ ẑ× behind.
    """
    about = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    tilt = np.array(
        [[cos(theta), 0.0, sin(theta)], [0.0, 1.0, 0.0], [-sin(theta), 0.0, cos(theta)]]
    )
    spin = omega3 - rate * cos(theta)
    second = (
        rate**2 * about @ about @ tilt
        + 2 * rate * spin * about @ tilt @ about
        + spin**2 * tilt @ about @ about
    )
    return grains[1] @ tilt.T, grains[1] @ second.T


def unbalanced(grains: Grains, theta: float, rate: float, omega3: float, g: float) -> float:
    """|Σ r × m(a − g)| over Σ|r × ma| + Σ|r × mg|: by Newton's law for each grain it vanishes."""
    places, accelerations = steadily_moved(grains, theta, rate, omega3)
    needed = np.cross(places, grains[0][:, None] * accelerations)
    given = np.cross(places, grains[0][:, None] * np.array([0.0, 0.0, -g]))
    size = np.linalg.norm(needed, axis=1).sum() + np.linalg.norm(given, axis=1).sum()
    return float(np.linalg.norm((needed - given).sum(axis=0)) / size)


def seen_from_above(rate: float) -> str:
    """Which way a precession goes."""
    return "anticlockwise" if rate > 0 else "clockwise"


def spinning(omega3: float) -> None:
    """RigidtopError for a wheel at rest."""
    if omega3 == 0:
        raise RigidtopError("omega3 must not be 0: a wheel that does not spin falls")


FACTORS = (0.25, 0.5, 1.0, 2.0, 4.0, 8.0)


@exercise(
    "gyroscope",
    "The gyroscope of introductory books",
    section="3.5.2",
    asks="example 35: gyroscopes",
    statement="A uniform disc spins on a thin axle through its centre. The end of the axle rests "
    "on a stand, at the distance R from the disc, and the axle makes the angle θ with the "
    "vertical. In which direction does it precess, how fast, and how long does one turn take?\n\n"
    "Compare (3.52) with the exact rate. How fast must the disc spin so that (3.52) is wrong by no "
    "more than a share “tolerance”, and how fast so that it can precess steadily at all?",
    claims=(precession_vector, torque_direction, disc_on_an_arm, spin_for_accuracy),
    parameters=(
        Parameter("M", 0.17, "mass of the disc", "kg", above=0),
        Parameter("radius", 0.055, "radius of the disc", "m", above=0),
        Parameter("R", 0.105, "from the stand to the disc", "m", above=0),
        Parameter("omega3", 90 * pi, "ω₃: 45 turns a second", "rad/s"),
        Parameter("theta", pi / 3, "θ of the axle", "rad", above=0, most=3.1),
        Parameter("tolerance", 0.01, "error allowed, relative", above=0, most=0.9),
        GRAVITY,
    ),
)
def gyroscope(
    M: float, radius: float, R: float, omega3: float, theta: float, tolerance: float, g: float
) -> Iterator[Outcome]:
    """The exact rate is the slow root of (3.57). By Newton's law grain by grain, without moments of
    inertia or Euler's equations, it is checked that a disc so moved needs the torque of its weight
    and no other; and the spin for the tolerance by the exact rate there."""
    spinning(omega3)
    top = HeavyTop(lambda1=M * (radius**2 / 4 + R**2), lambda3=M * radius**2 / 2, M=M, R=R, g=g)
    exact, _ = top.steady_precession(theta, omega3)
    simple = top.weight[2] / (top.lambda3 * omega3)
    off = exact / simple - 1
    cosine = cos(theta) if abs(cos(theta)) > ROUNDING else 0.0
    # Below the horizontal the exact rate is the smaller one.
    share = tolerance if cosine > 0 else -tolerance
    needed = sqrt(top.lambda1 * top.weight[2] * abs(cosine) / tolerance) * (1 + share)
    needed /= top.lambda3

    yield Answer("lambda1", "λ₁ about the stand", top.lambda1, "kg m²")
    yield Answer("lambda3", "λ₃", top.lambda3, "kg m²")
    yield Answer("simple", "Ω by (3.52)", simple, "rad/s")
    yield Answer("exact", "Ω₋ of (3.57)", exact, "rad/s")
    yield Answer("off", "by how much it exceeds (3.52), relative", off)
    yield Answer("period", "time for one turn", 2 * pi / abs(exact), "s")
    yield Answer("direction", "direction, seen from above", seen_from_above(exact))
    yield Answer("epsilon_0", "ε₀", smallness(top, omega3))
    yield Answer("good", "is (3.52) good enough?", "yes" if abs(off) <= tolerance else "no")
    yield Answer("spin_needed", "it is for |ω₃| from", needed, "rad/s")
    yield Answer("smallest_spin", "smallest |ω₃| to go round", top.smallest_spin(theta), "rad/s")

    def at(spin: float) -> tuple[float | str, ...]:
        rough = top.weight[2] / (top.lambda3 * spin)
        if abs(spin) < top.smallest_spin(theta):
            return spin, smallness(top, spin), rough, "none", "none"
        rate, _ = top.steady_precession(theta, spin)
        return spin, smallness(top, spin), rough, rate, rate / rough - 1

    yield Table(
        "spins",
        "at less and at more spin",
        ("ω₃ (rad/s)", "ε₀", "Ω by (3.52) (rad/s)", "Ω₋ (rad/s)", "excess"),
        tuple(at(factor * omega3) for factor in FACTORS),
    )
    yield Measure(
        "torque that the moving disc needs besides its weight's, relative",
        unbalanced(disc(M, radius, R), theta, exact, omega3, g),
        1e-12,
    )
    if needed:
        rate, _ = top.steady_precession(theta, needed)
        excess = rate * top.lambda3 * needed / top.weight[2] - 1
        yield Measure("excess at the spin for the tolerance", abs(excess - share), 1e-12)


@exercise(
    "bicycle-wheel",
    "The bicycle wheel on a cord",
    section="3.5.2",
    asks="example 35: the wheel of the videos",
    statement="A bicycle wheel, all of its mass in the rim, spins on a horizontal axle. One end of "
    "the axle, at the distance R from the wheel, is held up by a cord. Which way does the wheel go "
    "round, and how fast? What is the force in the cord, and by what angle does the cord lean?\n\n"
    "Somebody holds the other end of the axle at rest and lets it go, with the first end on a "
    "fixed pivot. How far does the axle dip, and how often?",
    claims=(precession_vector, torque_direction, wheel_on_an_axle, bound_on_the_tilt),
    parameters=(
        Parameter("M", 1.5, "mass of the rim", "kg", above=0),
        Parameter("radius", 0.31, "radius of the rim", "m", above=0),
        Parameter("R", 0.15, "from the cord to the wheel", "m", above=0),
        Parameter("omega3", 6 * pi, "ω₃: 180 turns a minute", "rad/s"),
        Parameter("cord", 1.0, "length of the cord", "m", least=0),
        GRAVITY,
    ),
)
def bicycle_wheel(
    M: float, radius: float, R: float, omega3: float, cord: float, g: float
) -> Iterator[Outcome]:
    """The cord leans until its horizontal part keeps the wheel on its circle: a root is found. That
    the rate needs no other torque, and the cord no other force, is checked by Newton's law for six
    grains of the rim; the dip against the turning points of the exact motion."""
    spinning(omega3)
    top = HeavyTop(lambda1=M * (radius**2 / 2 + R**2), lambda3=M * radius**2, M=M, R=R, g=g)
    rate, _ = top.steady_precession(pi / 2, omega3)
    weak = smallness(top, omega3)

    def unmet(slope: float) -> float:
        # The centre of mass is on a circle of radius R + ℓ sin β; tan β is the slope.
        return g * slope - rate**2 * (R + cord * slope / hypot(1.0, slope))

    most = rate**2 * (R + cord) / g
    slope = float(brentq(unmet, 0.0, most, xtol=1e-15 * most, rtol=1e-15))
    tension, reach = M * g * hypot(1.0, slope), R + cord * slope / hypot(1.0, slope)
    dip = asin(4 * weak / (1 + sqrt(1 + 16 * weak**2)))
    motion = top.motion(theta=pi / 2, omega3=omega3)

    yield Answer("lambda1", "λ₁ about the end of the axle", top.lambda1, "kg m²")
    yield Answer("lambda3", "λ₃", top.lambda3, "kg m²")
    yield Answer("precession", "Ω, exact at θ = 90°", rate, "rad/s")
    yield Answer("period", "time for one turn", 2 * pi / abs(rate), "s")
    yield Answer("direction", "direction, seen from above", seen_from_above(rate))
    yield Answer("tension", "force in the cord", tension, "N")
    yield Answer("lean", "angle of the cord with the vertical", atan(slope), "rad")
    yield Answer("epsilon_0", "ε₀", weak)
    yield Answer("dip", "dip of the axle, let go at rest", dip, "rad")
    yield Answer("dip_period", "time from dip to dip", motion.nutation_period, "s")

    grains = hoop(M, radius, R)
    yield Measure(
        "torque that the moving wheel needs besides its weight's, relative",
        unbalanced(grains, pi / 2, rate, omega3, g),
        1e-12,
    )
    masses, places = hoop(M, radius, reach)
    _, accelerations = steadily_moved((masses, places), pi / 2, rate, omega3)
    pull = tension * np.array([-sin(atan(slope)), 0.0, cos(atan(slope))])
    weight = np.array([0.0, 0.0, -M * g])
    size = masses @ np.linalg.norm(accelerations, axis=1) + tension + M * g
    yield Measure(
        "force on the moving wheel against cord and weight, relative",
        float(np.linalg.norm(masses @ accelerations - pull - weight) / size),
        1e-12,
    )
    lowest = motion.turning_points[1] - pi / 2
    yield Measure("dip against the exact motion's (rad)", abs(dip - lowest), 1e-12)


EXERCISES: tuple[Exercise, ...] = (parallel_bound, toppling_top, gyroscope, bicycle_wheel)
