"""What the closed form tells of a whole motion, or of each of many."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, Generic, TypeVar, cast

import numpy as np

Word = TypeVar("Word")
"""A str, or an array of them."""

Number = TypeVar("Number")
"""A float, or an array of them."""


class Periods(ABC, Generic[Word, Number]):
    """Regime, turning points, periods and mean rates, of one motion or of each of many."""

    @abstractmethod
    def _of_orbit(self, name: str) -> Any:
        """A quantity of the closed form; of one that is a pair, both."""

    @property
    def regime(self) -> Word:
        """What kind of motion it is, to rounding of the initial state.

        Of a free body: "short axis" or "long axis" (the largest or the smallest moment's, about
        which ω circles in the body), "separatrix", "regular precession" (two equal moments) or
        "steady" (ω constant).  Of a heavy symmetric body: "sleeping" and "hanging" (at rest, the
        centre of mass above or below the pivot), "free precession" (no weight), "steady",
        "asymptotic" (to the upright), "plane" (a pendulum), "through the vertical", "waves",
        "cusps", "loops".
        """
        return cast(Word, self._of_orbit("regime"))

    @property
    def turning_points(self) -> tuple[Number, Number]:
        """The smallest and the largest θ (rad).

        Of a top θ is the angle between e₃ and the vertical, of another heavy body that between the
        vertical and the direction to its centre of mass; of a free body that between L and the
        principal axis about which ω circles, towards the side on which it is.
        """
        smallest, largest = self._of_orbit("turning_points")
        return smallest, largest

    @property
    def nutation_period(self) -> Number:
        """The time from one smallest θ to the next (s).

        Where θ is constant, that of a small nutation; infinite where there is no next.
        """
        return cast(Number, self._of_orbit("nutation_period"))

    @property
    def precession_per_period(self) -> Number:
        """The angle by which the axis turns about the vertical, or about L, in that time (rad)."""
        mean, period = np.asarray(self.mean_precession), np.asarray(self.nutation_period)
        with np.errstate(invalid="ignore"):  # of 0 in a period without end
            angle = np.where(mean == 0, 0.0, mean * period)
        return cast(Number, angle if angle.ndim else angle.item())

    @property
    def mean_precession(self) -> Number:
        """The mean rate of that turning (rad/s).

        Where the axis is constant, that of its neighbours.  An axis that passes through the
        vertical, to rounding of the initial state, comes out on the other side; this half turn is
        none of precession, so a pendulum that swings in a plane has 0.
        """
        return cast(Number, self._of_orbit("mean_precession"))
