"""
The flip about the middle axis
==============================

A free body that turns about its middle axis turns over, again and again. How long it waits is a
closed form, ``motion.nutation_period``.
"""

import matplotlib.pyplot as plt
import numpy as np

import rigidtop as rt

body = rt.FreeBody(1.0, 2.0, 2.9)
motion = body.motion(omega=[0.01, 2.0, 0.01])
t = np.linspace(0, 40, 2000)
run = motion.exact(t)

figure, axes = plt.subplots(figsize=(7, 3), layout="constrained")
for k, rate in enumerate(run.omega.T):
    axes.plot(t, rate, label=f"ω{'₁₂₃'[k]}")
axes.set(xlabel="t (s)", ylabel="rad/s")
axes.legend(loc="upper right", ncols=3)
