"""
Friction raises a top
=====================

A fast top with a round tip stands up on a rough table.
"""

import matplotlib.pyplot as plt
import numpy as np

import rigidtop as rt

toy = rt.SlidingTop(lambda1=4e-5, lambda3=2.5e-5, M=0.1, R=0.03, tip=0.01, mu=0.1)
run = toy.motion(theta=0.5, omega3=200.0).integrate(np.linspace(0, 4, 800))

figure, axes = plt.subplots(figsize=(6, 3), layout="constrained")
axes.plot(run.t, np.degrees(run.theta))
axes.set(xlabel="t (s)", ylabel="θ (degrees)", title=f"ω₃ falls to {run.omega[-1, 2]:.0f} rad/s")
