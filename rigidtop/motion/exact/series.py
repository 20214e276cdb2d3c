"""Fourier series of periodic functions, for many samples of one motion.

The closed forms cost some hundred operations a sample; their periodic parts are smooth, and a dozen
harmonics give them to rounding.  The coefficients come from the closed forms themselves, at equally
spaced phases, and are used only if they have fallen below rounding.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from rigidtop.motion.attitude import Floats

NODES = (48, 192)
"""Samples of a period from which coefficients are found; the second where the first are few."""

NEGLIGIBLE = 1e-17
"""Coefficients below this, of the largest value of the function, are left out."""

CONVERGED = 4e-16
"""So small, of the largest value, the last third of the coefficients must be."""

BLOCK = 8192
"""Samples at a time: the harmonics of these fit the processor's cache."""


@dataclass(frozen=True)
class Series:
    """Σ even[:, k] cos 2πku and Σ odd[:, k] sin 2πku, a row each; u counts periods."""

    even: Floats
    odd: Floats

    def evaluate(self, u: Floats, even: Floats, odd: Floats) -> None:
        """Write the rows at phases u (N,) to `even` and `odd`, of shapes (rows, N)."""
        harmonics = self.even.shape[1]
        cosines, sines = np.empty((2, harmonics, min(BLOCK, len(u))))
        cosines[0], sines[0] = 1.0, 0.0
        for first in range(0, len(u), BLOCK):
            chunk = slice(first, min(first + BLOCK, len(u)))
            c, s = cosines[:, : chunk.stop - first], sines[:, : chunk.stop - first]
            angle = u[chunk] - np.rint(u[chunk])
            angle *= 2 * np.pi
            if harmonics > 1:
                np.cos(angle, out=c[1])
                np.sin(angle, out=s[1])
                twice = 2 * c[1]
            for k in range(2, harmonics):
                for wave in (c, s):
                    np.multiply(twice, wave[k - 1], out=wave[k])
                    wave[k] -= wave[k - 2]
            np.matmul(self.even, c, out=even[:, chunk])
            np.matmul(self.odd, s, out=odd[:, chunk])


def series(functions: Callable[[Floats], tuple[Floats, Floats]]) -> Series | None:
    """The series of functions of the phase u: even rows and odd rows in, None if it is too long."""
    for nodes in NODES:
        u = np.arange(nodes) / nodes
        even, odd = functions(u - np.rint(u))
        spectra = np.fft.rfft(even).real * (2 / nodes), np.fft.rfft(odd).imag * (-2 / nodes)
        spectra[0][:, 0] /= 2
        rows = np.concatenate([even, odd])
        scale = np.maximum(np.abs(rows).max(axis=1), 1e-300)
        largest = (np.abs(np.concatenate(spectra)) / scale[:, None]).max(axis=0)
        rounding = largest[nodes // 3 :].max()  # of a converged spectrum, else NaN or more
        if rounding < CONVERGED:
            last = np.flatnonzero(largest > max(NEGLIGIBLE, rounding))[-1]
            return Series(*(np.ascontiguousarray(part[:, : last + 1]) for part in spectra))
    return None
