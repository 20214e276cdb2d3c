"""Asteroid 4179 Toutatis: moments, spin state, radar observations, published periods.

Takahashi, Busch & Scheeres 2013, AJ 146:95: moments of inertia in units of the smallest, the spin
state with which their fit starts, and the radar observations.  Attitudes are 3-1-3 Euler angles,
R = Rz(α) Rx(β) Rz(γ), body to inertial; rates are in the body's x, y and z (long) axes, which are
our e₁, e₂ and e₃, so that λ₃ is the smallest moment and λ₂ the largest.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Rational

MOMENTS = (Rational("3.0836"), Rational("3.235"), Rational(1))
"""About the body's x, y and z (long) axis, in units of the last."""

OMEGA_1992 = (Rational("14.51"), Rational("33.529"), Rational("-98.709"))
"""Body rates of `START` in degrees per day."""


@dataclass(frozen=True)
class SpinState:
    """`time` in UTC; 3-1-3 Euler angles (α, β, γ) in degrees; body rates in degrees per day."""

    time: str
    angles: tuple[float, float, float]
    rates: tuple[float, float, float]


START = SpinState(
    "1992-11-09T17:49:47",
    (145.498, 65.865, 241.524),
    (float(OMEGA_1992[0]), float(OMEGA_1992[1]), float(OMEGA_1992[2])),
)
"""The initial condition of the fit."""

OBSERVATIONS = (
    SpinState("1992-12-02T21:40:00", (122.2, 86.5, 107.0), (-35.6, 7.2, -97.0)),
    SpinState("1992-12-03T19:30:00", (86.3, 81.8, 24.5), (-16.4, -29.1, -91.9)),
    SpinState("1992-12-04T18:10:00", (47.8, 60.7, 284.0), (29.1, -23.2, -97.8)),
    SpinState("1992-12-05T18:50:00", (14.6, 39.4, 207.1), (33.3, 8.2, -92.2)),
    SpinState("1992-12-06T17:30:00", (331.3, 23.7, 151.6), (6.6, 34.5, -95.8)),
    SpinState("1992-12-07T17:20:00", (222.5, 25.4, 143.9), (12.8, 25.4, -104.1)),
    SpinState("1992-12-08T16:40:00", (169.8, 45.5, 106.9), (-31.1, -21.9, -97.7)),
    SpinState("1992-12-09T17:50:00", (137.3, 71.3, 22.3), (11.8, -36.9, -94.9)),
    SpinState("1992-12-10T17:20:00", (103.1, 85.2, 292.6), (35.8, -8.9, -97.9)),
    SpinState("1992-12-11T09:40:00", (77.0, 85.7, 225.5), (31.0, 17.0, -96.3)),
    SpinState("1992-12-12T09:20:00", (42.8, 70.2, 133.2), (-1.3, 37.0, -95.9)),
    SpinState("1992-12-13T08:10:00", (13.7, 44.4, 51.9), (-38.3, 17.9, -97.3)),
    SpinState("1992-12-14T07:50:00", (323.7, 14.0, 0.0), (-70.5, -30.6, -91.1)),
    SpinState("1992-12-15T07:50:00", (193.2, 24.4, 21.4), (22.1, -26.6, -96.6)),
    SpinState("1992-12-16T07:10:00", (165.1, 46.4, 310.6), (33.4, -3.4, -93.7)),
    SpinState("1992-12-17T06:49:00", (130.6, 76.1, 234.9), (12.6, 33.9, -94.0)),
    SpinState("1992-12-18T07:09:00", (91.6, 81.6, 142.4), (-24.3, 29.6, -102.0)),
    SpinState("2008-11-23T10:45:00", (86.2, 85.0, 0.3), (-0.4, -36.2, -98.9)),
)
"""By radar, in the order of time.  By 2008 the tides of the Sun and the Earth have acted."""

PERIODS = (
    ("Hudson & Ostro 1995, Science 270:84 (radar)", 5.41, 7.35),
    ("Mueller, Belton & Samarasinha 2000, DPS meeting 32 (light curve)", 5.38, 7.41),
    ("Zhao et al. 2015, arXiv:1504.02024 (flyby)", 5.38, 7.40),
)
"""Published: the rotation about the long axis and the precession of that axis about L, in days."""
