"""The numbers that the exercises of the notebooks ask for: ``%%answer exercise-1.2``.

They are computed from motions or from closed forms, with the bodies of the notebook that asks.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, cos, hypot, log, pi, radians, sin, sqrt

import numpy as np

from rigidtop.derivations import toutatis
from rigidtop.motion.body import FreeBody
from rigidtop.motion.table.motion import SlidingTop
from rigidtop.motion.top import HeavyTop
from rigidtop.proof.exercise import Answer, Exercise

Numbers = Iterator[Answer]

BODY = FreeBody(1.0, 2.0, 3.0)
"""That of the first notebook."""
TOP = HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1)
"""The example top."""
ACROSS, ALONG, WEIGHT = TOP.lambda1, TOP.lambda3, TOP.M * TOP.g * TOP.R
"""Its moments (kg m²), and its weight with its arm (J)."""
TILT = radians(60.0)
TOY = {"lambda1": 5e-6, "lambda3": 6e-6, "M": 0.030, "R": 0.020}
"""The wooden top of the sixth notebook; moments about its centre of mass."""


def conserved() -> Numbers:
    first, second, third = BODY.moments
    for name, moment in (("weight_1", first), ("weight_2", second)):
        what = f"weight of the square of the component {name[-1]}"
        yield Answer(name, what, moment * (third - moment), "kg² m⁴")


def coin() -> Numbers:
    yield Answer("sigma_squared", "square of the rate of growth", 0.0, "1/s²")
    yield Answer("quarter", "quarter of the period", pi / 2 / abs((2 - 3) / 2 * 0.01), "s")


def delay() -> Numbers:
    sigma = sqrt((2 - 1) * (3 - 2) * 2.0**2 / (1 * 3))
    yield Answer("longer", "time that a push ten times smaller adds", 2 * log(10) / sigma, "s")


def phone() -> Numbers:
    across, along = 4 * pi * sin(radians(5.0)), 4 * pi * cos(radians(5.0))
    for name, omega in (
        ("towards_e1", (across, along, 0.0)),
        ("towards_e3", (0.0, along, across)),
    ):
        path = FreeBody(0.21, 0.80, 1.0).motion(omega=omega).exact(np.linspace(0.0, 2.0, 20001))
        first = float(path.t[np.argmax(path.omega[:, 1] < 0)])
        yield Answer(name, "time until the component along e₂ changes its sign", first, "s")


def earth() -> Numbers:
    yield Answer("period", "period of the free precession", 0.99727 * 304, "days")


def plate() -> Numbers:
    yield Answer("wobbles", "number of wobbles for a turn", 2.0)


def long_body() -> Numbers:
    yield Answer("Omega_s", "rate in space", hypot(0.45, 0.55), "rad/s")
    yield Answer("Omega_b", "rate in the body", 0.45, "rad/s")
    yield Answer("beta", "angle from the axis to L", atan2(0.45, 0.55), "rad")


def settled() -> Numbers:
    body = FreeBody(*map(float, toutatis.MOMENTS))
    start = body.motion(omega=np.radians(toutatis.START.rates).tolist()).exact(0.0)
    momentum = float(np.linalg.norm(start.angular_momentum[0]))
    left = momentum**2 / (2 * max(body.moments)) / float(start.energy[0])
    yield Answer("left", "share of the energy that is left", left)


def inverse() -> Numbers:
    yield Answer("phi", "first angle", pi - radians(50.0), "rad")
    yield Answer("theta", "second angle", radians(40.0), "rad")
    yield Answer("psi", "third angle", pi - radians(30.0), "rad")


def hanging() -> Numbers:
    yield Answer("psi", "angle that gives the same attitude", radians(30.0), "rad")


def body_rates() -> Numbers:
    phi_dot, theta_dot, psi_dot, psi = 2.0, 1.0, 3.0, radians(30.0)
    along = phi_dot * sin(TILT)
    for name, rate in (
        ("omega1", theta_dot * sin(psi) - along * cos(psi)),
        ("omega2", theta_dot * cos(psi) + along * sin(psi)),
        ("omega3", psi_dot + phi_dot * cos(TILT)),
    ):
        yield Answer(name, f"component along e{name[-1]}", rate, "rad/s")


def momenta() -> Numbers:
    path = TOP.motion(theta=TILT, phi_dot=2.0, omega3=40.0).exact(np.array([0.1]))
    yield Answer(
        "L_z",
        "component along the vertical",
        ACROSS * 2.0 * sin(TILT) ** 2 + ALONG * 40.0 * cos(TILT),
        "J s",
    )
    yield Answer("L_3", "component along the axis", ALONG * 40.0, "J s")
    yield Answer("phi_dot", "rate after 0.1 s", float(path.phi_dot[0]), "rad/s")


def falling() -> Numbers:
    fall = TOP.motion(theta=radians(10.0), omega3=0.0)
    times = np.linspace(0.0, fall.nutation_period / 2, 20001)
    time = float(np.interp(pi / 2, fall.exact(times).theta, times))
    yield Answer("time_to_fall", "time until the axis is horizontal", time, "s")


def newton() -> Numbers:
    right = ACROSS * 2.0**2 * cos(TILT) - ALONG * 40.0 * 2.0 + WEIGHT
    yield Answer("theta_ddot", "angular acceleration", right * sin(TILT) / ACROSS, "rad/s²")


def spring() -> Numbers:
    yield Answer("kappa", "least stiffness at which it stands", WEIGHT, "J")


def point() -> Numbers:
    rate = TOP.g / TOP.R * sin(TILT)
    yield Answer("theta_ddot", "angular acceleration from rest", rate, "rad/s²")


def nodding() -> Numbers:
    highest, lowest = TOP.motion(theta=TILT, omega3=30.0).turning_points
    formula = ACROSS * WEIGHT * sin(TILT) / (ALONG * 30.0) ** 2
    yield Answer("amplitude", "amplitude of the motion", (lowest - highest) / 2, "rad")
    yield Answer("formula", "amplitude by the formula", formula, "rad")


def pendulum() -> Numbers:
    rate = abs(TOP.steady_precession(radians(120.0), 0.0)[0])
    yield Answer("Omega", "rate of precession at 120°", rate, "rad/s")


def horizontal() -> Numbers:
    yield Answer("Omega", "rate of precession at 90°", WEIGHT / (ALONG * 40.0), "rad/s")


def weightless() -> Numbers:
    yield Answer("free", "fast rate without weight", ALONG * 40.0 / (ACROSS * cos(TILT)), "rad/s")
    yield Answer(
        "change", "what the weight changes at 400 rad/s", -WEIGHT / (ALONG * 400.0), "rad/s"
    )


def sharp() -> Numbers:
    top = SlidingTop(**TOY, tip=0.0, viscosity=0.01)
    path = top.motion(theta=radians(20.0), omega3=250.0).integrate(
        np.linspace(0.0, 4.0, 401), rtol=1e-8, atol=1e-10
    )
    yield Answer("theta", "mean angle in the last second", float(path.theta[-100:].mean()), "rad")


def dry() -> Numbers:
    top = SlidingTop(**TOY, tip=0.003, mu=0.1)
    path = top.motion(theta=radians(20.0), omega3=250.0).integrate(
        np.linspace(0.0, 2.0, 401), rtol=1e-8, atol=1e-10
    )
    yield Answer("time", "time at which it begins to roll", path.events[0].time, "s")
    yield Answer("theta", "angle at which it rolls", float(path.theta[path.rolling].mean()), "rad")


def asleep() -> Numbers:
    about_tip = TOY["lambda1"] + TOY["M"] * TOY["R"] ** 2
    sleeping = 2 * sqrt(about_tip * TOY["M"] * 9.81 * TOY["R"]) / TOY["lambda3"]
    for name, start in (("asleep", 250.0), ("twice", 500.0)):
        yield Answer(name, "time above the sleeping spin", 6 * log(start / sleeping), "s")


def cone() -> Numbers:
    mass, radius, height = 0.04, 0.025, 0.025
    across = 3 / 5 * mass * (radius**2 / 4 + height**2)
    along = 3 / 10 * mass * radius**2
    sleeping = 2 * sqrt(across * mass * 9.81 * 3 / 4 * height) / along
    yield Answer("sleeping_spin", "least spin of a cone that sleeps", sleeping, "rad/s")
    drag = along * log(60 * pi / sleeping) / 12
    yield Answer("drag3", "drag along the axis", drag, "N m s")


_ASKED = (
    (conserved, coin, delay, phone),
    (earth, plate, long_body, settled),
    (inverse, hanging, body_rates, momenta),
    (falling, newton, spring, point),
    (nodding, pendulum, horizontal, weightless),
    (sharp, dry, asleep, cone),
)
"""By notebook, in the order of its exercises."""

QUESTIONS = tuple(
    Exercise(
        f"exercise-{chapter}.{number}",
        f"Exercise {chapter}.{number} of the notebooks",
        section="",
        asks="",
        statement="",
        claims=(),
        parameters=(),
        solve=solve,
    )
    for chapter, asked in enumerate(_ASKED, 1)
    for number, solve in enumerate(asked, 1)
)
