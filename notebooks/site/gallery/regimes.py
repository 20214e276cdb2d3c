"""
A map of 40,000 tops
====================

How far each top falls, over its spin and its first rate of precession: one call.
"""

import matplotlib.pyplot as plt
import numpy as np

import rigidtop as rt

spins, rates = np.meshgrid(np.linspace(0, 60, 200), np.linspace(-5, 5, 200))
tops = rt.top_motions(lambda1=1, lambda3=0.5, M=1, R=0.5, theta=0.5, phi_dot=rates, omega3=spins)
lowest = np.degrees(tops.turning_points[1])

figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
drawn = axes.pcolormesh(spins, rates, lowest, shading="auto")
axes.set(xlabel="ω₃ (rad/s)", ylabel="φ̇ (rad/s)")
figure.colorbar(drawn, label="greatest θ (degrees)")
