"""What `rigidtop` raises when it cannot do what was asked: one line each, for a person to read."""

from __future__ import annotations


class RigidtopError(ValueError):
    """The input makes no sense, or has no answer.  The message says what would."""


class NoSteadyPrecession(RigidtopError):  # noqa: N818 - the public name says what happened
    """The top spins too slowly for a steady precession at this tilt: (3.57) has no real root."""
