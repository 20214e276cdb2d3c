"""Section 3.2.3, example 33: the asteroid Toutatis, computed and observed."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import datetime
from math import degrees, inf, pi, radians

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from rigidtop.derivations.precession_of_rotation_axis import example_33
from rigidtop.derivations.relaxation import relaxed
from rigidtop.derivations.toutatis import MOMENTS, OBSERVATIONS, PERIODS, START, SpinState
from rigidtop.errors import RigidtopError
from rigidtop.motion.body import FreeBody
from rigidtop.motion.exact import free
from rigidtop.motion.motion import Motion
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Measure

from .bodies import angles
from .precession_of_rotation_axis import MOST_ANGLE, turned

Vectors = NDArray[np.float64]


def attitude(state: SpinState) -> Rotation:
    """R = Rz(α) Rx(β) Rz(γ), body to inertial."""
    return Rotation.from_euler("ZXZ", state.angles, degrees=True)


def days(state: SpinState) -> float:
    """Since the start."""
    passed = datetime.fromisoformat(state.time) - datetime.fromisoformat(START.time)
    return passed.total_seconds() / 86400


def split(error: Rotation) -> tuple[float, float, float]:
    """A rotation in body components: its angle, that by which it moves e₃, and the turn about e₃.

    In degrees; first about e₃ and then about an axis across it makes the whole.
    """
    x, y, z, w = np.abs(error.as_quat())
    return (
        degrees(float(error.magnitude())),
        degrees(2 * np.arctan2(np.hypot(x, y), np.hypot(z, w))),
        degrees(2 * np.arctan2(z, w)),
    )


def comparison(motion: Motion, seen: SpinState) -> tuple[float | str, ...]:
    """A row: the computed state against an observed one."""
    path = motion.exact(days(seen))
    whole, axis, twist = split(path.rotation[0].inv() * attitude(seen))
    rates = np.radians(seen.rates)
    turn = degrees(float(angles(path.omega, rates[None, :])[0]))
    size = degrees(float(np.linalg.norm(path.omega[0] - rates)))
    # L, which a free body keeps, as the observation alone has it.
    momentum = attitude(seen).apply(np.array(motion.body.moments) * rates)[None, :]
    expected = path.angular_momentum
    strayed = degrees(float(angles(momentum, expected)[0]))
    ratio = float(np.linalg.norm(momentum) / np.linalg.norm(expected))
    return seen.time[:10], days(seen), whole, axis, twist, turn, size, strayed, ratio


DAY = 86400.0
"""In seconds."""


@exercise(
    "toutatis",
    "Toutatis, computed and observed",
    section="3.2.3",
    asks="example 33",
    statement="Takahashi, Busch & Scheeres (AJ 146:95, 2013) give the moments of the asteroid "
    r"Toutatis and its state of rotation on 9 November 1992; our $\mathbf e_3$ is its "
    r"long axis, so that $\lambda_3$ is the smallest moment here. About which axis does "
    r"$\boldsymbol\omega$ circle, how long does one turn about the long axis take, and "
    r"how long one turn of that axis about $\mathbf L$? Compute its attitude for the "
    "times at which they give what radar saw, and compare.\n\nHow much of its energy "
    "could friction inside the body still take, and about which axis would it then "
    "rotate? Why do most asteroids rotate so already? (One degree per day is "
    r"$2.02 \times 10^{-7}$ rad/s; moments are in units of $\lambda_3$.)",
    claims=(example_33,),
    parameters=(
        Parameter("lambda1", float(MOMENTS[0]), r"$\lambda_1$, about the body's $x$ axis", above=0),
        Parameter("lambda2", float(MOMENTS[1]), r"$\lambda_2$, about its $y$ axis", above=0),
        Parameter("lambda3", float(MOMENTS[2]), r"$\lambda_3$, about its long axis", above=0),
        *(
            Parameter(
                rf"omega{k + 1}", radians(rate) / DAY, rf"$\omega_{k + 1}$ at the start", "rad/s"
            )
            for k, rate in enumerate(START.rates)
        ),
        Parameter("ball", 0.5, r"$\lambda_0$, moment of a ball in oil inside", above=0),
        Parameter(
            "friction",
            0.2,
            r"$c/(\lambda_0\omega)$, drag of the oil on the ball, with $\omega$ at the start",
            least=0.05,
            most=2,
        ),
    ),
    figure="tumbling",
)
def toutatis(
    lambda1: float,
    lambda2: float,
    lambda3: float,
    omega1: float,
    omega2: float,
    omega3: float,
    ball: float,
    friction: float,
) -> Iterator[Outcome]:
    r"""The motion is that of a free body without friction, carried on from the start in closed
    form. From the published moments and start, half of the radar attitudes of December 1992 are
    met to $5.6^\circ$, and all to $15.9^\circ$; two of the observed $\boldsymbol\omega$, of 7
    and 14 December, do not go with the $\mathbf L$ of all others. In 2008 $\mathbf L$ still
    points where it did, but the phase is lost: over a thousand turns the last printed digits of
    moments and start can add up to some twenty degrees, and the tides of the Sun and the Earth,
    which are left out here, to far more. With friction the body has the ball in oil of section
    3.2.3, far stronger than what rubs in a rock; $\mathbf L$ in space stays, and the oil takes
    the energy that is missing at the end."""
    moments = np.array([lambda1, lambda2, lambda3])
    omega = np.array([omega1, omega2, omega3]) * DAY  # the unit of time from here on: a day
    if lambda3 >= min(lambda1, lambda2):
        raise RigidtopError(
            "lambda3 must be the smallest moment: e₃ is the long axis, and another must not be"
        )
    if not omega.any():
        raise RigidtopError("omega1, omega2 and omega3 are all zero: nothing rotates")
    body = FreeBody(lambda1, lambda2, lambda3)
    most = sum(moments) - 2 * max(moments)
    if ball > most:
        raise RigidtopError(
            f"ball = {ball:g} leaves moments that no body around it has: at most {most:g}"
        )
    motion = body.motion(omega=omega.tolist(), attitude=attitude(START))
    if motion.regime == "steady":
        raise RigidtopError(
            "ω is along a principal axis, where it stays and circles about none: change it a little"
        )
    half = motion.nutation_period
    if not half < inf:
        raise RigidtopError("ω has no period, as on the separatrix: change it a little")
    speed = float(np.linalg.norm(omega))
    if half * speed > MOST_ANGLE / 20:
        raise RigidtopError(
            f"ω circles once in {2 * half:.3g} days, too many turns to follow: let the moments "
            "differ more"
        )
    # Two equal moments, which are the largest here, leave the long axis as the one it circles.
    mode = "short axis" if motion.regime == "short axis" else "long axis"
    yield Answer("mode", r"$\boldsymbol\omega$ circles about the", mode)
    yield Answer(
        "rotation", r"turn about the axis about which $\boldsymbol\omega$ circles", 2 * half, "days"
    )
    precession = 2 * pi / abs(motion.mean_precession)
    yield Answer(
        "precession", r"turn of this axis about $\mathbf L$, on average", precession, "days"
    )
    least, greatest = motion.turning_points
    yield Answer("least_tilt", r"smallest angle between $\mathbf L$ and this axis", least, "rad")
    yield Answer(
        "greatest_tilt", r"largest angle between $\mathbf L$ and this axis", greatest, "rad"
    )
    yield Table(
        "periods",
        "Periods: computed, and published for the long axis of Toutatis",
        (
            "source",
            r"turn of $\boldsymbol\omega$ about its axis (days)",
            r"turn of this axis about $\mathbf L$ (days)",
        ),
        # With as many digits as are published.
        ((f"this motion, {mode}", float(f"{2 * half:.3g}"), float(f"{precession:.3g}")), *PERIODS),
    )
    rows = tuple(comparison(motion, seen) for seen in OBSERVATIONS)
    yield Table(
        "observations",
        "Computed against observed: how far apart",
        (
            "date",
            "days from the start",
            r"error of attitude ($^\circ$)",
            r"tilt of long axis ($^\circ$)",
            r"turn about long axis ($^\circ$)",
            r"$\boldsymbol\omega$, direction ($^\circ$)",
            r"$\boldsymbol\omega$ ($^\circ/\text{day}$)",
            r"$\mathbf L$, direction ($^\circ$)",
            r"$|\mathbf L|$, observed over computed",
        ),
        rows,
    )
    early = [float(row[2]) for row, seen in zip(rows, OBSERVATIONS, strict=True) if days(seen) < 60]
    yield Answer(
        "median_error", "median error of the attitude in 1992", float(np.median(early)), "°"
    )
    yield Answer("largest_error", "largest error of the attitude in 1992", max(early), "°")
    yield _last_digits(motion)
    yield from _energies(moments, omega, ball, friction)

    far = np.linspace(0.0, min(days(OBSERVATIONS[-2]), MOST_ANGLE / speed), 101)
    exact, integrated = motion.exact(far), motion.integrate(far, rtol=1e-12, atol=1e-14)
    apart = float((exact.rotation.inv() * integrated.rotation).magnitude().max())
    yield Measure("attitude in November and December 1992, integrated (rad)", apart, 1e-8)
    ten = motion.integrate(np.linspace(0, 20 * half, 2001), rtol=1e-12, atol=1e-14)
    back = float(np.linalg.norm(ten.omega[-1] - omega)) / speed
    yield Measure(r"$\omega$ after ten of its periods, integrated, relative", back, 1e-8)
    axis = ten.rotation.apply(np.eye(3)[int(free.solve(tuple(moments), tuple(omega)).axes[2])])
    counted = abs(turned(axis, ten.angular_momentum[0]))
    yield Measure(
        r"turns of the axis about $\mathbf L$ meanwhile (rad)",
        abs(counted - abs(motion.mean_precession) * 20 * half),
        1e-7,
    )


def _last_digits(motion: Motion) -> Table:
    """What half of the last printed digit of the start does to the last attitude."""
    halves = {"lambda1": 5e-5, "lambda2": 5e-4, "omega1": 5e-3, "omega2": 5e-4, "omega3": 5e-4}
    time = days(OBSERVATIONS[-1])
    there = motion.exact(time).rotation[0]
    values = dict(zip(("lambda1", "lambda2", "lambda3"), motion.body.moments, strict=True))
    values |= dict(zip(("omega1", "omega2", "omega3"), motion.omega, strict=True))
    rows = []
    for name, change in halves.items():
        added = radians(change) if name.startswith("omega") else change
        lambda1, lambda2, lambda3, *omega = (values | {name: values[name] + added}).values()
        moved = FreeBody(lambda1, lambda2, lambda3).motion(omega=omega, attitude=motion.attitude)
        turn = float((there.inv() * moved.exact(time).rotation[0]).magnitude())
        rows.append((rf"$\{name[:-1]}_{name[-1]}$", change, degrees(turn)))
    return Table(
        "last_digits",
        "Half of the last printed digit of moments and start, and the attitude of 2008",
        ("changed", r"by ($\omega$: in $^\circ/\text{day}$)", r"change of attitude ($^\circ$)"),
        tuple(rows),
    )


def _energies(moments: Vectors, omega: Vectors, ball: float, friction: float) -> Iterator[Outcome]:
    """Energies at this L, and the end to which friction leads."""
    momentum = moments * omega
    size = float(np.linalg.norm(momentum))
    energy = float(momentum @ omega) / 2
    alone = size**2 / (2 * moments)
    yield Table(
        "energies",
        "Rotation with this $L$ about one axis",
        ("axis", "moment", "energy over that at the start", "period (days)"),
        tuple(
            (
                rf"$\mathbf e_{k + 1}$",
                float(moment),
                float(alone[k]) / energy,
                float(2 * pi * moment / size),
            )
            for k, moment in enumerate(moments)
        ),
    )
    lost = 1 - float(alone.min()) / energy
    yield Answer("energy_to_lose", "share of the energy that friction can take", lost)
    longest = 4000 * float(moments.min()) / size
    run = relaxed(moments, omega, ball, friction, longest)
    there = moments == moments.max()
    tilts = np.arctan2(
        np.linalg.norm(run.momentum[:, ~there], axis=1),
        np.linalg.norm(run.momentum[:, there], axis=1),
    )
    yield Table(
        "friction",
        "With friction inside: the way to rotation with the largest moment",
        (
            "time (days)",
            "energy over that at the start",
            r"$\mathbf L$ from the axis of largest moment (rad)",
        ),
        tuple(
            (float(time), float(part), float(tilt))
            for time, part, tilt in zip(run.t, run.energy / energy, tilts, strict=True)
        ),
    )
    yield Answer(
        "tilt_at_end",
        r"angle of $\mathbf L$ and the axis of the largest moment at the end",
        float(tilts[-1]),
        "rad",
    )
    yield Measure("$L$ in space with friction, relative", run.strayed, 1e-9)
    yield Measure("energy lost against the heat of the oil, relative", run.imbalance, 1e-9)


EXERCISES: tuple[Exercise, ...] = (toutatis,)
