"""
A double pendulum
=================

From two masses to their equations, their motion, and how far the energy strays.
"""

import matplotlib.pyplot as plt
import numpy as np
from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m, R, g = symbols("m R g", positive=True)
a, b = dynamicsymbols("a b")
T = m * R**2 * (a.diff() ** 2 + b.diff() ** 2 / 2 + a.diff() * b.diff() * cos(a - b))
system = rt.System(T + m * g * R * (2 * cos(a) + cos(b)), [a, b])

run = system.motion({m: 1, R: 1, g: 9.81}, q=[2.0, 1.0]).integrate(np.linspace(0, 10, 1000))
figure, axes = plt.subplots(1, 2, figsize=(9, 3.5), layout="constrained")
run.plot(axes=axes[0])
run.plot(("a", "b"), axes=axes[1])
print({name: float(f"{drift:.1e}") for name, drift in run.drift().items()})
