"""
Polhodes
========

Where ω may go on the energy ellipsoid of a body with three moments, and the separatrix between the
motions about the first and about the last axis.
"""

import matplotlib.pyplot as plt

import rigidtop as rt
from rigidtop.figures.free import draw_polhodes

figure, axes = plt.subplots(figsize=(5, 5), layout="constrained")
draw_polhodes(axes, rt.FreeBody(1.0, 2.0, 2.9))
