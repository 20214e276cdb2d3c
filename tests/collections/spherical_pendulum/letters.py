"""The symbols of the spherical pendulum."""

from __future__ import annotations

from rigidtop.theory.lettered import in_order, positive, real
from rigidtop.theory.symbols import Glyph

(
    m,
    g,
    length,
    S,
    Lagrangian,
    U,
    E,
    L_z,
    p_phi,
    Omega2,
    omega,
    thetaddot,
    phiddot,
    phidot,
    thetadot,
    phi,
    theta,
    v,
) = in_order(
    positive("m", Glyph("m"), "mass of the bob", "kg"),
    positive("g", Glyph("g"), "acceleration of gravity", "m/s²"),
    positive("length", Glyph("l"), "length of the string", "m"),
    real("S", Glyph("S"), "force in the string", "N"),
    real("Lagrangian", Glyph("ℒ"), "Lagrangian", "J"),
    real("U", Glyph("U"), r"effective potential of $\theta$", "J"),
    real("E", Glyph("E"), "energy", "J"),
    real("L_z", Glyph("L", "z"), "vertical part of the angular momentum", "J s"),
    real("p_phi", Glyph("p", "φ"), r"momentum conjugate to $\phi$", "J s"),
    real("Omega2", Glyph("Ω²"), "square of the frequency of nodding", "1/s²"),
    real("omega", Glyph("ω"), "rate at which a cone is gone round", "rad/s"),
    real("thetaddot", Glyph("θ", accent="ddot"), r"second derivative of $\theta$", "rad/s²"),
    real("phiddot", Glyph("φ", accent="ddot"), r"second derivative of $\phi$", "rad/s²"),
    real("phidot", Glyph("φ", accent="dot"), r"rate of $\phi$", "rad/s"),
    real("thetadot", Glyph("θ", accent="dot"), r"rate of $\theta$", "rad/s"),
    real("phi", Glyph("φ"), "azimuth of the bob", "rad"),
    real("theta", Glyph("θ"), "angle of the string with the downward vertical", "rad"),
    real("v", Glyph("v"), "speed", "m/s"),
)
