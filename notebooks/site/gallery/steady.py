"""
The two steady precessions
==========================

Both roots Ω of (3.57) against the spin: below the least spin there is none.
"""

import matplotlib.pyplot as plt
import numpy as np

import rigidtop as rt

top = rt.HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1)
theta = np.radians(60)
least = top.smallest_spin(theta)
spins = np.linspace(least, 3 * least, 300)
slow, fast = np.transpose([top.steady_precession(theta, spin) for spin in spins])

figure, axes = plt.subplots(figsize=(6, 3.5), layout="constrained")
axes.semilogy(spins, slow, label="Ω₋")
axes.semilogy(spins, fast, label="Ω₊")
axes.axvline(least, color="grey", linestyle=":")
axes.set(xlabel="ω₃ (rad/s)", ylabel="Ω (rad/s)")
axes.legend()
