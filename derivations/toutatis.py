"""Asteroid 4179 Toutatis: Takahashi, Busch & Scheeres 2013, AJ 146:95.

Moments of inertia in units of the smallest, and the spin state of 1992-11-09T17:49:47 UTC with
which their fit starts: 3-1-3 Euler angles (body to inertial, Rz(α) Rx(β) Rz(γ)) and body rates.
"""

from __future__ import annotations

from sympy import Rational

MOMENTS = (Rational("3.0836"), Rational("3.235"), Rational(1))
"""About the body's x, y and z (long) axis, in units of the last."""

OMEGA_1992 = (Rational("14.51"), Rational("33.529"), Rational("-98.709"))
"""Body rates in degrees per day."""
