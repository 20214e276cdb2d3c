"""Section 3.5.4: what friction does to a top, on the table and in the air."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, exp, expm1, log, log1p, pi, sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import quad, simpson, solve_ivp
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import brentq

from rigidtop.derivations.nutation import friction
from rigidtop.errors import RigidtopError
from rigidtop.motion.table.motion import SlidingMotion, SlidingTop
from rigidtop.motion.table.trajectory import SlidingTrajectory
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure

from .bodies import GRAVITY
from .sleeping_top import upright_potential

Complex = NDArray[np.complex128]

TIGHT: Any = {"rtol": 1e-9, "atol": 1e-11}


jellett = Claim(
    "jellett", "No force at the contact changes $(R - r_0)L_3 + r_0L_z$ of a top with a round tip."
)


friction_raises = Claim("friction-raises", "Sliding friction at a round tip raises a fast top.")


spin_falls = Claim(
    "spin-in-air",
    r"A sleeping top that the air brakes has its spin fall exponentially, and wakes; $\lambda_1$ "
    "is the moment about the tip.",
)


# --- a top that rises ----------------------------------------------------------------------------


ABOUT_CENTRE = (
    Parameter("lambda1", 4e-5, r"$\lambda_1$ about the centre of mass", "kg m²", above=0),
    Parameter("lambda3", 2.5e-5, r"$\lambda_3$ about the axis", "kg m²", above=0),
    Parameter("M", 0.1, "mass", "kg", above=0),
    Parameter("R", 0.03, "height of the centre of mass of the upright top", "m", above=0),
    GRAVITY,
)
"""What `SlidingTop` takes besides friction: a top of a hand's size."""


def rising(theta: float, omega3: float, **body: float) -> SlidingMotion:
    """A top with a round tip that slides, at the slow precession that is steady without friction.

    On a smooth table that is (3.57) about the centre of mass: there the table turns the top with
    the weight at the middle of the tip.  Raises RigidtopError where there is none.
    """
    top = SlidingTop(**body)
    if top.tip >= top.R:
        raise RigidtopError(
            f"tip = {top.tip:g} must be less than R = {top.R:g}: the centre of mass is above its "
            "middle"
        )
    smooth = HeavyTop(
        lambda1=top.lambda1,
        lambda3=top.lambda3,
        M=top.M,
        R=top.R - top.tip,
        g=top.g,
        physical=False,
    )
    slow, _ = smooth.steady_precession(theta, omega3)
    return top.motion(theta=theta, phi_dot=slow, omega3=omega3)


def rise_by_gyroscope(top: SlidingTop, start: float, end: float, spin: float) -> float:
    """The time to rise if L is along e₃ and the slip along e₂′ (s)."""

    def arm(tilt: float) -> float:
        return top.R - top.tip + top.tip * cos(tilt)

    # Jellett's integral: the spin goes as 1/arm.
    slowness, _ = quad(lambda tilt: arm(start) / arm(tilt) ** 2, end, start)
    return float(slowness) * top.lambda3 * spin / (top.mu * top.M * top.g)


def crossing(path: SlidingTrajectory, tilt: float) -> float | None:
    """The first time at which θ is at `tilt`, None where it never is (s)."""
    beyond = np.flatnonzero(np.diff(np.sign(path.theta - tilt)))
    if not beyond.size:
        return None
    piece = slice(int(beyond[0]), int(beyond[0]) + 2)
    curve = CubicHermiteSpline(path.t[piece], path.theta[piece], path.theta_dot[piece])
    before, after = map(float, path.t[piece])
    return float(brentq(lambda x: float(curve(x)) - tilt, before, after, xtol=1e-15))


def risen(path: SlidingTrajectory, until: float) -> float:
    """The first time at which θ has come down to `until` (s)."""
    seconds = crossing(path, until)
    if seconds is None:
        ends = [f"{event.kind} at {event.time:.3g} s" for event in path.events[:1]]
        raise RigidtopError(
            f"until = {until:g} is not reached, theta gets down to {np.min(path.theta):.4g}: "
            f"{(ends or ['the top rises no further'])[0]}"
        )
    return seconds


def friction_impulse(path: SlidingTrajectory) -> float:
    """∫ ẑ·(ρ × F) dt over a path with many rows (J s)."""
    arm = -(path.motion.body.R - path.motion.body.tip) * path.e3
    force = path.friction_force
    torque = arm[:, 0] * force[:, 1] - arm[:, 1] * force[:, 0]
    return float(simpson(torque, x=path.t))


def energies(path: SlidingTrajectory, k: int) -> tuple[float, ...]:
    """Of the spin, of all other motion, of the weight; heat by friction and by air; their sum."""
    body = path.motion.body
    *across, along = 0.5 * np.array(body.moments) * path.omega[k] ** 2
    spin = float(along)
    height = body.M * body.g * float(path.position[k, 2])
    # Of its parts: what is left of a sum of joules is rounded at their last digit.
    rest = float(sum(across) + 0.5 * body.M * path.velocity[k] @ path.velocity[k])
    heat = float(path.dissipated_by_friction[k]), float(path.dissipated_by_air[k])
    return spin, rest, height, *heat, spin + rest + height + sum(heat)


def budget(path: SlidingTrajectory, rows: int, last: int, title: str) -> Table:
    """Where the energy is at so many times, up to the row `last` of the path.

    What gives no heat at any of them has no column.
    """
    places = np.linspace(0, last, rows).round().astype(int)
    cells = [(float(path.t[k]), float(path.theta[k]), *energies(path, int(k))) for k in places]
    columns = (
        "$t$ (s)",
        r"$\theta$ (rad)",
        r"spin $\tfrac12\lambda_3\omega_3^2$ (J)",
        "other motion (J)",
        "weight (J)",
        "heat by friction (J)",
        "heat by air (J)",
        "sum (J)",
    )
    kept = [k for k, name in enumerate(columns) if "heat" not in name or any(r[k] for r in cells)]
    return Table(
        "budget",
        title,
        tuple(columns[k] for k in kept),
        tuple(tuple(row[k] for k in kept) for row in cells),
    )


@exercise(
    "rising-top",
    "A top that friction raises",
    section="3.5.4",
    asks="“friction … will cause the point of contact of the top on the table to move”",
    statement=r"A fast top with a round tip stands at the tilt $\theta$ on a table and precesses "
    r"slowly; its tip slides with the friction $\mu$. Show that friction raises the top "
    "although it brakes the spin. Which quantity does no force at the contact change, "
    "and which spin does it leave to the upright top?\n\nHow long does the top take to "
    "rise to the final tilt? How much energy has the spin lost by then, and where has it "
    "gone?",
    claims=(friction, jellett, friction_raises),
    parameters=(
        *ABOUT_CENTRE,
        Parameter("tip", 0.01, "radius of the round tip", "m", above=0),
        Parameter("mu", 0.1, "coefficient of sliding friction", above=0),
        Parameter("theta", 0.5, r"$\theta$ at the start", "rad", least=0.05, most=1.2),
        Parameter("until", 0.25, r"final $\theta$", "rad", least=0.01, most=1.2),
        Parameter("omega3", 200.0, r"$\omega_3$ at the start", "rad/s", above=0),
    ),
    figure="rising-top",
    text="exercises/rising_top",
)
def rising_top(
    tip: float, mu: float, theta: float, until: float, omega3: float, **shape: float
) -> Iterator[Outcome]:
    """The motion is integrated with Coulomb's friction. Jellett's integral and the sum of all
    energies keep their values in it."""
    if until >= theta:
        raise RigidtopError(f"until = {until:g} must be less than theta = {theta:g}: the top rises")
    motion = rising(theta, omega3, tip=tip, mu=mu, **shape)
    top, weight = motion.body, motion.body.M * motion.body.g
    expected = rise_by_gyroscope(top, theta, until, omega3)
    seconds = risen(motion.integrate(np.linspace(0, 3 * expected, 1201), **TIGHT), until)
    path = motion.integrate(np.linspace(0, seconds, 801), **TIGHT)
    before, after = energies(path, 0), energies(path, -1)
    lost = before[0] - after[0]
    yield Answer(
        "phi_dot",
        r"$\dot\phi$ at the start, steady if nothing rubs",
        float(path.phi_dot[0]),
        "rad/s",
    )
    yield Answer("time_to_rise", r"time until $\theta$ has its final value", seconds, "s")
    yield Answer(
        "time_gyroscope",
        r"by $L_3\dot\theta = -\mu Mg(R - r_0 + r_0 \cos\theta)$, for comparison",
        expected,
        "s",
    )
    yield Answer("slip", "speed of the contact at the start", float(np.hypot(*path.slip[0])), "m/s")
    yield Answer(
        "slip_then", "speed of the contact at the end", float(np.hypot(*path.slip[-1])), "m/s"
    )
    yield Answer("omega3_then", r"$\omega_3$ at the end", float(path.omega[-1, 2]), "rad/s")
    yield Answer(
        "omega3_upright",
        r"$\omega_3$ of the upright top, if it gets there, by Jellett's integral with this start's "
        "$L_z$",
        float(path.jellett[0]) / (top.lambda3 * top.R),
        "rad/s",
    )
    yield Answer("rise", "rise of the centre of mass", (after[2] - before[2]) / weight, "m")
    yield Answer("spin_lost", "energy that the spin lost", lost, "J")
    yield Answer("to_weight", "share of it in the weight", (after[2] - before[2]) / lost)
    yield Answer("to_motion", "share of it in other motion", (after[1] - before[1]) / lost)
    yield Answer("to_heat", "share of it in heat", after[3] / lost)
    yield budget(path, 9, len(path.t) - 1, "Where the energy is while the top rises")
    integral = path.jellett
    drift = float(np.max(np.abs(integral / integral[0] - 1)))
    yield Measure("Jellett's integral against its value at the start, relative", drift, 1e-9)
    yield Measure("sum of energies and heat, relative", path.budget(), 1e-8)
    gained = float(path.angular_momentum[-1, 2] - path.angular_momentum[0, 2])
    error = abs(friction_impulse(path) / gained - 1)
    yield Measure("$L_z$ gained, by the time integral of the torque, relative", error, 1e-3)
    grown = (top.R - tip * (1 - cos(until))) / (top.R - tip * (1 - cos(theta)))
    ratio = float(path.omega[-1, 2]) / omega3 * grown
    small = top.lambda1 * weight * top.R / (top.lambda3 * omega3) ** 2
    yield Measure(
        r"$\omega_3$ at the end, by Jellett's integral with $\mathbf L$ along "
        r"$\mathbf e_3$",
        abs(ratio - 1),
        small,
    )


# --- a top that wakes ----------------------------------------------------------------------------

MOST_TURNS = 1000
"""No top is integrated here for longer."""


HELD = 1.0
"""Friction that holds the sharp tip of a top that is nearly upright."""


def about_tip(lambda1: float, lambda3: float, M: float, R: float, g: float) -> HeavyTop:
    """The same top on a pivot, from its moments about the centre of mass."""
    return HeavyTop(lambda1=lambda1 + M * R**2, lambda3=lambda3, M=M, R=R, g=g)


def time_asleep(omega3: float, drag3: float, **body: float) -> float:
    """When the air has brought ω₃ down to the sleeping spin, (λ₃/c₃) ln(ω₃/ω_s), in s."""
    sleeping = about_tip(**body).sleeping_spin()
    if omega3 <= sleeping:
        raise RigidtopError(
            f"omega3 = {omega3:g} must be more than the sleeping spin, {sleeping:g} rad/s"
        )
    return body["lambda3"] / drag3 * log(omega3 / sleeping)


def time_to_grow(folds: float, drag3: float, **body: float) -> float:
    """How long from then on a small tilt takes to grow by e^folds, by the rate of each moment (s).

    The rate is (λ₃/2λ₁)√(ω_s² − ω₃²) with ω₃ = ω_s e^−dt, d = c₃/λ₃; its integral is
    (λ₃/2λ₁)(ω_s/d)(artanh s − s) with s² = 1 − e^−2dt.
    """
    top, decay = about_tip(**body), drag3 / body["lambda3"]
    size = top.lambda3 / (2 * top.lambda1) * top.sleeping_spin() / decay

    def grown(later: float) -> float:  # dt, and artanh s = dt + ln(1 + s)
        s = sqrt(-expm1(-2 * later))
        return size * (later + log1p(s) - s) - folds

    return float(brentq(grown, 0.0, folds / size + 1, xtol=1e-14, rtol=1e-12)) / decay


def small_tilt_time(
    top: HeavyTop, spin: float, decay: float, start: float, tilt: float, phi_dot: float
) -> float:
    """The time for a small tilt to grow from `start` to `tilt`, by the linear equation (s).

    With ξ = e₃ₓ + i e₃ᵧ, which starts as `start` with θ̇ = 0 and φ̇ = `phi_dot` (rad/s), it is
    λ₁ξ̈ = iλ₃ω₃ξ̇ + MgRξ: the torque of the air on the spin turns with e₃ and takes nothing but the
    spin.
    """
    growth, turn = top.weight[2] / top.lambda1, top.lambda3 / top.lambda1

    def rates(time: float, state: Complex) -> Complex:
        return np.array(
            [state[1], 1j * turn * spin * exp(-decay * time) * state[1] + growth * state[0]]
        )

    def reached(time: float, state: Complex) -> float:
        return float(np.log(np.abs(state[0]) / tilt))

    reached.terminal = True  # type: ignore[attr-defined]
    first = np.array([start, 1j * phi_dot * start])
    run = solve_ivp(
        rates, (0, 1e3 / decay), first, "DOP853", events=reached, rtol=1e-9, atol=1e-9 * start
    )
    return float(run.t[-1])


@exercise(
    "waking-top",
    "A sleeping top that the air wakes",
    section="3.5.4",
    asks="“the overall rotation to loose [sic] energy”",
    statement="A top with a sharp tip that friction holds in place sleeps upright with the spin "
    r"$\omega_3$. The air brakes its spin with the torque $c_3\omega_3$. When has the "
    "spin come down to the sleeping spin? A disturbance leaves a small tilt with "
    r"$\dot\theta = 0$ and with $\dot\phi$ halfway between the two frequencies that it "
    r"has: $\lambda_3\omega_3/2$ over the moment $\lambda_1 + MR^2$ about the tip. When "
    "has it become visible, and how large is the spin then? When would it become visible "
    r"from $\dot\phi = 0$? Where has the energy gone?",
    claims=(upright_potential, spin_falls, friction),
    parameters=(
        *ABOUT_CENTRE,
        Parameter("drag3", 5e-6, r"$c_3$, drag torque over $\omega_3$", "J s", above=0),
        Parameter("omega3", 165.0, r"$\omega_3$ at the start", "rad/s", above=0),
        Parameter("disturbance", 1e-6, r"$\theta$ at the start", "rad", least=1e-9, most=1e-3),
        Parameter(
            "visible",
            0.1,
            r"$\theta$ at which the top is seen to wake",
            "rad",
            least=0.01,
            most=0.3,
        ),
    ),
    figure="waking-top",
    text="exercises/waking_top",
)
def waking_top(
    drag3: float, omega3: float, disturbance: float, visible: float, **shape: float
) -> Iterator[Outcome]:
    r"""From the sleeping spin on, the growth rate is integrated until the tilt is visible. That
    is good if the tilt grows by a large factor: the time is wrong by about one part in the
    logarithm of this factor. So the top with its disturbance is integrated as well, and the
    linear equation of a small tilt for the start with $\dot\phi = 0$."""
    top = SlidingTop(**shape, mu=HELD, drag3=drag3)
    pivot = about_tip(**shape)
    asleep = time_asleep(omega3, drag3, **shape)
    folds, decay = log(visible / disturbance), drag3 / top.lambda3
    growing = time_to_grow(folds, drag3, **shape)
    yield Answer(
        "sleeping_spin",
        r"smallest $\omega_3$ at which the upright is stable",
        pivot.sleeping_spin(),
        "rad/s",
    )
    yield Answer("time_asleep", r"time until $\omega_3$ has come down to it", asleep, "s")
    yield Answer("half_life", r"time in which $\omega_3$ halves", log(2) / decay, "s")
    yield Answer(
        "time_awake", "time until the tilt is visible, by the growth rate", asleep + growing, "s"
    )
    turns = (asleep + 1.5 * growing) * omega3 / (2 * pi)
    if turns > MOST_TURNS:
        raise RigidtopError(
            f"about {turns:.0f} turns until the top wakes, at most {MOST_TURNS} are integrated "
            "here: give a larger drag3 or a smaller omega3"
        )
    turning = top.lambda3 * omega3 / (2 * pivot.lambda1)
    motion = top.motion(theta=disturbance, phi_dot=turning, omega3=omega3, slip=(0.0, 0.0))
    # The tilt is known relative to what it was at first.
    accuracy: Any = {"rtol": 1e-9, "atol": 1e-6 * disturbance}
    path = motion.integrate(np.linspace(0, asleep + 1.5 * growing, 601), **accuracy)
    seen = crossing(path, visible)
    if seen is None:
        raise RigidtopError(
            f"the tilt does not become visible in time: drag3 = {drag3:g} brakes the spin so fast "
            "that the growth rate of a moment says little"
        )
    yield Answer(
        "phi_dot",
        r"$\dot\phi$ at the start, $\lambda_3\omega_3/2$ over the moment about the tip",
        turning,
        "rad/s",
    )
    yield Answer("seen", "time until the tilt is visible, integrated", seen, "s")
    yield Answer("omega3_then", r"$\omega_3$ then", omega3 * exp(-decay * seen), "rad/s")
    at_rest = small_tilt_time(pivot, omega3, decay, disturbance, visible, 0.0)
    yield Answer(
        "seen_at_rest", r"time from $\dot\phi = 0$, by the equation of a small tilt", at_rest, "s"
    )
    awake = int(np.searchsorted(path.t, seen))
    largest = float(np.max(path.theta[path.t <= asleep]))
    yield Answer("tilt_asleep", r"largest $\theta$ before the sleeping spin", largest, "rad")
    until = motion.integrate(np.linspace(0, seen, 9), **accuracy)
    yield budget(until, 9, 8, "Where the energy is until the tilt is visible")
    error = float(
        np.max(np.abs(path.omega[:awake, 2] / omega3 * np.exp(decay * path.t[:awake]) - 1))
    )
    yield Measure(r"$\omega_3(t)$ on the table until then, relative", error, 1e-6)
    yield Measure("sum of energies and heat, relative", path.budget(), 1e-7)
    error = abs(seen - asleep - growing) / growing
    yield Measure("time from the sleeping spin, by the growth rate, relative", error, 1.5 / folds)
    linear = small_tilt_time(pivot, omega3, decay, disturbance, visible, turning)
    allowed = visible**2 / 10 + 100 * disturbance**2
    yield Measure(
        "time, by the linear equation of a small tilt, relative", abs(linear / seen - 1), allowed
    )


EXERCISES: tuple[Exercise, ...] = (rising_top, waking_top)
"""In the order of the notes."""
