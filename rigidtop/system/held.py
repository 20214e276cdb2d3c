"""States brought back to where the constraints hold, which rounding and a solver's errors leave."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from rigidtop.motion.attitude import Floats

if TYPE_CHECKING:
    from rigidtop.system.numeric import Computed

STEPS = 2
"""Of Newton's method, from what is as near as a solver's error."""


@dataclass(frozen=True)
class Surface:
    """Where the constraints hold, for numbers of the parameters.

    A state is moved by as little as can be, as the masses measure it: M δ + Aᵀλ = 0, A δ = −g for
    the coordinates, and then for the velocities with what is left of A q̇ + b.
    """

    system: Computed
    parameters: tuple[float, ...]

    def onto(self, times: Floats, states: Floats) -> Floats:
        """The nearest states (x, N) of q, q̇ and what follows them; itself where there is none."""
        n, nearer = len(self.system.q), states.copy()
        chosen = np.array(self.system.holonomic, dtype=bool)
        surface = self.system.numeric.surface
        ends = np.cumsum([n * n, len(chosen) * n, len(chosen)])
        for last in (*[False] * STEPS, True):
            with np.errstate(all="ignore"):
                numbers = surface.array(times, *nearer[: 2 * n], *self.parameters)
            mass, A, speeds, places = np.split(numbers, ends)
            mass, A = mass.T.reshape(-1, n, n), A.T.reshape(-1, len(chosen), n)
            A, left = (A, speeds.T) if last else (A[:, chosen], places.T)
            k = A.shape[1]
            border = np.zeros((len(times), n + k, n + k))
            border[:, :n, :n], border[:, n:, :n] = mass, A
            border[:, :n, n:] = A.swapaxes(1, 2)
            right = np.concatenate([np.zeros((len(times), n)), -left], axis=1)
            try:
                moved = np.linalg.solve(border, right[..., None])[:, :n, 0].T
            except np.linalg.LinAlgError:
                return states
            nearer[slice(n, 2 * n) if last else slice(n)] += moved
        return np.where(np.isfinite(nearer), nearer, states)
