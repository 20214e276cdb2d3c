"""A charge in E along ŷ and B along ẑ, a velocity-dependent L: it drifts along E × B on a cycloid.

Landau and Lifshitz, The Classical Theory of Fields, § 22: x = (E/B)(t − sin ωt/ω), and
y = (E/(Bω))(1 − cos ωt) from rest, with ω = qB/m and q > 0.
"""

import numpy as np
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m, q, E, B = symbols("m q E B", positive=True)
x, y, z = dynamicsymbols("x y z")
SYSTEM = rt.System(
    m * (x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2) / 2
    + q * B * (x * y.diff() - y * x.diff()) / 2
    + q * E * y,
    [x, y, z],
)
PARAMETERS = {m: 2, q: 1.5, E: 0.7, B: 3}
CONSERVED = {"energy", "p_z"}


def answers():
    """The cycloid, and the momentum m ẋ − qBy that the gauge hides."""
    run = SYSTEM.motion(PARAMETERS, q=[0, 0, 0], qdot={z: 0.25}).integrate([1.0, 6.0], rtol=1e-12)
    rate, drift = 1.5 * 3 / 2, 0.7 / 3
    known = np.stack(
        [
            drift * (run.t - np.sin(rate * run.t) / rate),
            drift / rate * (1 - np.cos(rate * run.t)),
            0.25 * run.t,
        ]
    )
    yield "the cycloid", run.q - known.T, 1e-10
    yield "m ẋ − qBy", 1 - SYSTEM.is_conserved(m * x.diff() - q * B * y), 0
