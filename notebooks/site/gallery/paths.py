"""
Waves, cusps, loops
===================

The path of the axis e₃ of a top on the sphere, for three rates φ̇ at the start. Where φ̇ vanishes at
a turning point of θ the path has cusps; more makes waves, less makes loops.
"""

import matplotlib.pyplot as plt
import numpy as np

import rigidtop as rt
from rigidtop.figures.nutation import draw_path

top = rt.HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1)
figure, axes = plt.subplots(1, 3, figsize=(9, 3.2), layout="constrained")
for place, phi_dot in zip(axes, (4.0, 0.0, -4.0), strict=True):
    motion = top.motion(theta=np.radians(60), phi_dot=phi_dot, omega3=40.0)
    t = np.linspace(0, 6 * motion.nutation_period, 800)
    draw_path(place, motion.exact(t).e3, title=f"{motion.regime}: φ̇ = {phi_dot:g} rad/s")
