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
    real("U", Glyph("U"), "effective potential of $θ$", "J"),
    real("E", Glyph("E"), "energy", "J"),
    real("L_z", Glyph("L", "z"), "vertical part of the angular momentum", "J s"),
    real("p_phi", Glyph("p", "φ"), "momentum conjugate to $φ$", "J s"),
    real("Omega2", Glyph("Ω²"), "square of the frequency of nodding", "1/s²"),
    real("omega", Glyph("ω"), "rate at which a cone is gone round", "rad/s"),
    real("thetaddot", Glyph("θ", accent="ddot"), "second derivative of $θ$", "rad/s²"),
    real("phiddot", Glyph("φ", accent="ddot"), "second derivative of $φ$", "rad/s²"),
    real("phidot", Glyph("φ", accent="dot"), "rate of $φ$", "rad/s"),
    real("thetadot", Glyph("θ", accent="dot"), "rate of $θ$", "rad/s"),
    real("phi", Glyph("φ"), "azimuth of the bob", "rad"),
    real("theta", Glyph("θ"), "angle of the string with the downward vertical", "rad"),
    real("v", Glyph("v"), "speed", "m/s"),
)
