"""The symbols of this course: name in programs, letter in print, meaning, unit.

What is positive is constant.  A rate is a symbol of its own; its letter has an accent.
"""

from __future__ import annotations

from rigidtop.theory.lettered import in_order, positive, real
from rigidtop.theory.symbols import E, Glyph, Lagrangian

m, k, rddot, phiddot, rdot, phidot, r, phi = in_order(
    positive("m", Glyph("m"), "mass", "kg"),
    positive("k", Glyph("k"), "stiffness of the spring", "N/m"),
    real("rddot", Glyph("r", accent="ddot"), "second rate of r", "m/s²"),
    real("phiddot", Glyph("φ", accent="ddot"), "second rate of φ", "rad/s²"),
    real("rdot", Glyph("r", accent="dot"), "rate of r", "m/s"),
    real("phidot", Glyph("φ", accent="dot"), "rate of φ", "rad/s"),
    real("r", Glyph("r"), "length of the spring", "m"),
    real("phi", Glyph("φ"), "angle of the spring in the plane", "rad"),
)

__all__ = ["E", "Lagrangian", "k", "m", "phi", "phiddot", "phidot", "r", "rddot", "rdot"]
