"""A planet in polar coordinates: Kepler's equation, and the vector of Laplace, Runge and Lenz.

Goldstein, Classical Mechanics, sections 3.7 to 3.9.
"""

import numpy as np
from scipy.optimize import brentq
from sympy import cos, sin, symbols

import rigidtop as rt

m, k, r = symbols("m k r", positive=True)
phi, u, w = symbols("phi u w", real=True)
SYSTEM = rt.System.of_energies(m * (u**2 + r**2 * w**2) / 2, -k / r, [r, phi], [u, w])
PARAMETERS = {m: 1, k: 1}
CONSERVED = {"energy", "p_phi"}
MAJOR, ECCENTRICITY = 1.5, 0.6


def answers():
    """From the perihelion: r = a(1 − e cos E), tan ½φ = √((1+e)/(1−e)) tan ½E; nt = E − e sin E."""
    a, e = MAJOR, ECCENTRICITY
    nearest, n = a * (1 - e), a**-1.5
    start = {"q": [nearest, 0], "qdot": [0, np.sqrt((1 + e) / nearest) / nearest]}
    run = SYSTEM.motion(PARAMETERS, **start).integrate([1.0, 4.0], rtol=1e-12)
    for t, found in zip(run.t, run.q, strict=True):
        E = brentq(lambda E, t=t: E - e * np.sin(E) - n * t, 0, 10, xtol=1e-15)
        angle = 2 * np.arctan(np.sqrt((1 + e) / (1 - e)) * np.tan(E / 2))
        yield "the place", found - [a * (1 - e * np.cos(E)), angle], 1e-9
    p_r, p_phi = SYSTEM.p
    lenz = [
        p_phi * (p_r * s + p_phi * c / r) - m * k * c
        for c, s in ((cos(phi), sin(phi)), (sin(phi), -cos(phi)))
    ]
    yield "its conservation", [1 - SYSTEM.is_conserved(x) for x in lenz], 0
    bracket = SYSTEM.poisson(*lenz)
    H = SYSTEM.hamiltonian
    yield "{A_x, A_y} = −2mHp_φ", int((bracket + 2 * m * H * p_phi).simplify() != 0), 0
