"""The symbols of this course: name in programs, letter in print, meaning, unit.

Their order here is the order in which the factors of a product are printed.
"""

from __future__ import annotations

from rigidtop.theory.lettered import in_order, positive, real
from rigidtop.theory.symbols import Glyph

m, g, length, Lagrangian, E, T, V, thetaddot, thetadot, theta = in_order(
    positive("m", Glyph("m"), "mass of the bob", "kg"),
    positive("g", Glyph("g"), "acceleration of gravity", "m/s²"),
    positive("length", Glyph("l"), "length of the string", "m"),
    real("Lagrangian", Glyph("ℒ"), "Lagrangian", "J"),
    real("E", Glyph("E"), "energy", "J"),
    real("T", Glyph("T"), "kinetic energy", "J"),
    real("V", Glyph("V"), "potential energy", "J"),
    # A rate is a symbol of its own; its letter has an accent.
    real("thetaddot", Glyph("θ", accent="ddot"), r"second derivative of $\theta$", "rad/s²"),
    real("thetadot", Glyph("θ", accent="dot"), r"rate of $\theta$", "rad/s"),
    real("theta", Glyph("θ"), "angle between string and vertical", "rad"),
)
