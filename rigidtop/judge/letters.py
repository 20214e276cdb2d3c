"""What letters are usually called, where a text does not say what they are."""

from __future__ import annotations

from rigidtop.tree.nodes import Letter

CLOCK = Letter("t")
"""The time."""

INFINITY = Letter("∞")
"""No number: an end of integrals and sums, and a limit."""

SPEED = Letter("v")
"""The speed of what moves."""

ANGLES = frozenset("αβγδθϑφϕψχ")
"""Angles: inclinations, and coordinates of what turns."""

PLACES = frozenset("xyzshd")
"""Places along a line, and heights."""

COORDINATES = frozenset("xyzsdrquhwlℓηξζρσ") | ANGLES
"""Places and angles of what moves, where they have a rate."""

SPEEDS = frozenset("vω")
"""How fast something goes or turns, where it has a rate."""

VELOCITIES = frozenset("uvwV")
"""How fast bodies go, perhaps backwards, as after an impact."""

TURNING = frozenset("ωΩw")
"""How fast something turns."""

FREQUENCIES = frozenset("ωΩνκnfw")
"""How fast something oscillates, where words speak of an oscillation."""

FORCES = frozenset("FfNSHZλ")
"""Forces, where nothing says what they are."""

MOMENTA = frozenset("pPπJℓlDS")
"""Momenta, in which a function may be written."""

TIMES = frozenset("tτT")
"""Moments, and how long something takes."""

PERIODS = frozenset("TτP")
"""How long an oscillation, or a turn, takes."""


def is_mass(letter: Letter) -> bool:
    """Whether a letter is the mass of a body."""
    return letter.base in ("m", "M") and not letter.bold
