"""
The effective potential
=======================

θ runs between two turning points, where the energy meets the effective potential.
"""

import matplotlib.pyplot as plt
import numpy as np

import rigidtop as rt
from rigidtop.figures.potential import draw_effective_potential

top = rt.HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1)
motion = top.motion(theta=np.radians(60), omega3=40.0)
figure, axes = plt.subplots(figsize=(6, 3.5), layout="constrained")
draw_effective_potential(axes, motion)
