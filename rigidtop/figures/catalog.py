"""Every figure by its name.

>>> [drawing.name for drawing in FIGURES][:2]
['two-masses', 'polhodes']
"""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches

from rigidtop.errors import RigidtopError
from rigidtop.figures import (
    cones,
    falling,
    free,
    friction,
    nutation,
    points,
    potential,
    precession,
    rotations,
    rotors,
    tops,
    wobbles,
)
from rigidtop.figures.drawing import Drawing

FIGURES: tuple[Drawing, ...] = (
    points.TWO_MASSES,
    free.POLHODES,
    free.FLIP,
    cones.CONES,
    cones.ROLLING_CONES,
    wobbles.POLAR_MOTION,
    wobbles.WOBBLING_PLATE,
    free.TUMBLING,
    rotations.EULER_ANGLES,
    rotations.ORDER_OF_ROTATIONS,
    points.WEIGHTS,
    points.LEANING_CONE,
    tops.TORQUE_ARROWS,
    precession.PARALLEL,
    falling.TOPPLING,
    rotors.GYROSCOPE,
    rotors.BICYCLE_WHEEL,
    precession.PRECESSION_RATES,
    precession.ASYMPTOTICS,
    falling.SLEEPING,
    potential.EFFECTIVE_POTENTIAL,
    tops.SPINNING_TOP,
    nutation.PATHS,
    nutation.MOTION,
    nutation.REGIMES,
    friction.RISING,
    friction.WAKING,
    tops.TOY_TOP,
)
"""In the order of the notes."""


def named(name: str, figures: Sequence[Drawing] = FIGURES) -> Drawing:
    """The one of some figures that has this name; RigidtopError, with near names, if none has.

    >>> named("path")
    Traceback (most recent call last):
    ...
    rigidtop.errors.RigidtopError: no figure 'path'; did you mean paths?
    """
    known = {drawing.name: drawing for drawing in figures}
    if name in known:
        return known[name]
    near = get_close_matches(name, known, n=3, cutoff=0.5)
    there = f"there are {', '.join(known)}" if known else "there is none"
    hint = f"did you mean {' or '.join(near)}?" if near else there
    raise RigidtopError(f"no figure {name!r}; {hint}")
