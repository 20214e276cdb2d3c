# %% [markdown]
# # 6 Friction, and your own top
#
# The end of section 3.5.4: "get your own toy-top and play with it." On a table nobody holds the
# tip. Friction moves the point of contact and takes energy, as the notes say; it also does
# something that they do not say: it makes a fast top stand up. We derive the power of friction,
# follow the life of a top from its start to its fall, and then ask what *your* top will do.

# %%
from rigidtop.notebook import *

# %% [markdown]
# ## A top without a pivot
#
# Now the natural point is the centre of mass, and in this notebook $\lambda_1$ and $\lambda_3$ are
# moments **about the centre of mass**. (About the tip it is $\lambda_1 + MR^2$.) The tip is round,
# with the radius $r$. From the centre of mass to the contact leads $\boldsymbol{\rho} =
# -(R-r)\mathbf{e}_3 - r\hat{\mathbf{z}}$. Newton moves the centre of mass with the contact force
# $\mathbf{C}$ and the weight; Euler's equations turn the top with the torque
# $\boldsymbol{\rho}\times\mathbf{C}$.
#
# How fast does the energy change? The weight's power cancels against the potential energy. What is
# left is $\mathbf{C}\cdot\mathbf{V}$ and the rate of $T$ along Euler's equations. We compare it
# with $\mathbf{C}\cdot\mathbf{v}$, where $\mathbf{v} = \mathbf{V} +
# \boldsymbol{\omega}\times\boldsymbol{\rho}$ is the velocity of the contact point of the body, the
# *slip*:

# %%
rho, contact_force, V = (Matrix(symbols(f"{name}_1:4", real=True)) for name in ("rho", "C", "V"))
power = contact_force.dot(V) + along_flow(kinetic_energy(), rho.cross(contact_force))
slip = V + Matrix(OMEGA).cross(rho)
(power - contact_force.dot(slip)).expand()

# %% [markdown]
# So $\dot E = \mathbf{C}\cdot\mathbf{v}$. No slip, no loss: a tip that is held, or that rolls,
# costs nothing. Sliding friction points against $\mathbf{v}$, and takes $\mu N|\mathbf{v}|$.

# %% [markdown] tags=["lecturer"]
# The verdict on the notes' sentence:

# %% tags=["lecturer"]
verdict("friction")

# %% [markdown]
# ## Why friction raises a top
#
# One quantity survives friction *at the contact*, whatever its law:
# $\mathbf{L}\cdot\boldsymbol{\rho}$, found by Jellett in 1872. Its rate is
# $\dot{\mathbf{L}}\cdot\boldsymbol{\rho} + \mathbf{L}\cdot\dot{\boldsymbol{\rho}}$. The first term
# is $(\boldsymbol{\rho}\times\mathbf{C})\cdot\boldsymbol{\rho} = 0$. The second is
# $-(R-r)\,\mathbf{L}\cdot(\boldsymbol{\omega}\times\mathbf{e}_3)$, a triple product of the three
# vectors that lie in one plane (notebook 2):

# %%
momentum = angular_momentum().subs(lambda2, lambda1)
momentum.dot(Matrix(OMEGA).cross(Matrix([0, 0, 1]))).expand()

# %% [markdown]
# So $(R-r)L_3 + rL_z$ is constant. For a fast top $\mathbf{L}$ is along $\mathbf{e}_3$, and this is
# $\lambda_3\omega_3\,(R - r + r\cos\theta)$. The energy of a fast top is nearly all in its spin, so
# what friction takes has to come from there: $\omega_3$ falls. Then the bracket must grow, and
# $\theta$ falls: the top stands up. With a sharp tip, $r = 0$, the spin stays what it is. Then
# friction takes from the height instead, and the top sinks.
#
# ## The life of a top
#
# A wooden top of 30 g on a wet table. Friction is viscous here, $-\gamma\mathbf{v}$, and the air
# brakes the rotation. It starts at 20° with 250 rad/s (40 turns a second).

# %%
toy = {"lambda1": 5e-6, "lambda3": 6e-6, "M": 0.030, "R": 0.020}  # SI units
top = rt.SlidingTop(**toy, tip=0.003, viscosity=0.01, drag1=1e-6, drag3=1e-6)
life = top.motion(theta=np.radians(20.0), omega3=250.0).integrate(
    np.linspace(0.0, 15.0, 1501), rtol=1e-8, atol=1e-10
)
about_tip = toy["lambda1"] + toy["M"] * toy["R"] ** 2
sleeping = 2 * np.sqrt(about_tip * toy["M"] * 9.81 * toy["R"]) / toy["lambda3"]
awake = life.t[np.argmax(life.omega[:, 2] < sleeping)]
print(f"it stands up to {np.degrees(life.theta.min()):.1f}°")
print(
    f"a held top would sleep above {sleeping:.0f} rad/s; this one is slower from {awake:.1f} s on"
)
print(f"the end: {life.ended.kind} after {life.ended.time:.1f} s")

# %%
with plot("θ and ω₃ against time: the top stands up, then sinks and falls", columns=2) as (
    left,
    right,
):
    left.plot(life.t, np.degrees(life.theta), color=FIRST)
    left.set_ylabel(r"$\theta$  (degrees)")
    right.plot(life.t, life.omega[:, 2], color=SECOND)
    right.axhline(sleeping, color=GREY, ls=":", lw=0.9)
    right.set_ylabel(r"$\omega_3$  (rad/s)")
    for axes in (left, right):
        axes.axvline(awake, color=GREY, ls=":", lw=0.9)
        axes.set_xlabel("$t$  (s)")

# %% [markdown]
# Where did the energy go? Friction takes its part while the tip slips; the air takes nearly all.
# The sum of what is left and what is gone stays what it was:

# %%
parts = {
    "energy": life.energy,
    "taken by friction": life.dissipated_by_friction,
    "taken by the air": life.dissipated_by_air,
}
with plot("energy, and what friction and air have taken, against time", 4.6, 2.5) as axes:
    for (name, values), colour in zip(parts.items(), (FIRST, SECOND, THIRD), strict=True):
        axes.plot(life.t, 1e3 * values, color=colour, label=name)
    axes.set_xlabel("$t$  (s)")
    axes.set_ylabel("mJ")
    axes.legend(loc="center right")
for name, values in parts.items():
    print(f"{name:18} {1e3 * values[-1]:7.2f} mJ at the end")
print(f"all adds up to 1e-6 of the energy: {life.budget() < 1e-6}")

# %% [markdown]
# ## Where the tip goes
#
# Without friction nothing pushes sideways: the centre of mass stays above one spot, and the *tip*
# goes round it. With friction the tip drags the top across the table. Both for two seconds:

# %%
with plot("paths of the contact: a ring on a smooth table, a curl on a wet one", columns=2) as (
    left,
    right,
):
    for axes, viscosity, title in ((left, 0.0, "smooth"), (right, 0.01, "wet")):
        top = rt.SlidingTop(**toy, tip=0.003, viscosity=viscosity)
        path = top.motion(theta=np.radians(20.0), omega3=250.0).integrate(
            np.linspace(0.0, 2.0, 1501), rtol=1e-8, atol=1e-10
        )
        axes.plot(*(1e3 * path.contact[:, :2].T), color=FIRST, lw=0.8)
        axes.plot(*(1e3 * path.centre.T), color=SECOND, lw=1.5)
        axes.set_aspect("equal")
        axes.set_title(title)
        axes.set_xlabel("x  (mm)")
    left.set_ylabel("y  (mm)")

# %% [markdown]
# ## Play
#
# Change the radius of the tip and the friction. When does the top stand up quickly? What does a
# sharp tip do?


# %%
def standing_up(left, right, tip, viscosity):
    top = rt.SlidingTop(**toy, tip=tip / 1000, viscosity=viscosity)
    path = top.motion(theta=np.radians(20.0), omega3=250.0).integrate(
        np.linspace(0.0, 4.0, 801), rtol=1e-7, atol=1e-9
    )
    left.plot(path.t, np.degrees(path.theta), color=FIRST)
    left.set_ylim(0, 25)
    left.set_ylabel(r"$\theta$  (degrees)")
    right.plot(path.t, np.linalg.norm(path.slip, axis=1), color=SECOND, lw=0.5)
    right.set_ylabel("slip  (m/s)")
    for axes in (left, right):
        axes.set_xlabel("$t$  (s)")


sliders(
    standing_up,
    "θ falls, and the slip with it",
    columns=2,
    tip=(0.0, 3.0, 8.0),
    viscosity=(0.0, 0.01, 0.05),
)

# %% [markdown]
# ## Your own top
#
# Measure the mass, the radius and the height of your top. For a simple shape the moments are
# integrals. Here is a solid cone that stands on its apex, with the radius $a$ and the height $b$:
# its centre of mass, and its moments about the tip.

# %%
solid = cone(a, b)
about_apex = solid.inertia(M)
[
    Equation(R, solid.centre()[2]),
    Equation(lambda1, about_apex[0, 0]),
    Equation(lambda3, about_apex[2, 2]),
]

# %% [markdown]
# The least spin at which it sleeps, $\omega_3 = \frac{2}{\lambda_3}\sqrt{\lambda_1MgR}$ (notebook
# 5), does not depend on the mass:

# %%
least = 2 * sqrt(about_apex[0, 0] * M * g * solid.centre()[2]) / about_apex[2, 2]
least_squared = simplify(least**2)
least_squared

# %%
for radius, height in ((0.015, 0.03), (0.025, 0.025), (0.03, 0.015)):
    rate = float(sqrt(least_squared).subs({a: radius, b: height, g: Rational("9.81")}))
    print(
        f"radius {1000 * radius:.0f} mm, height {1000 * height:.0f} mm: "
        f"{rate:5.0f} rad/s = {rate / (2 * np.pi):4.0f} turns a second"
    )

# %% [markdown]
# With your fingers you reach 20 to 40 turns a second. So a good top is flat: broad, and low.
#
# ## Exercises
#
# ### Exercise 6.1
#
# Let the wooden top run with a sharp tip ($r = 0$) on the same wet table, without air, for four
# seconds. Does it stand up? Compare with Jellett's constant. Give the mean $\theta$ in the last
# second.
#
# <details><summary>First hint</summary>
#
# Only `tip=0.0` changes, and the drags are left out.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# With $r = 0$ Jellett's constant is $RL_3$. What does it say about $\theta$?
#
# </details>

# %% tags=["solution"]
for tip in (0.003, 0.0):
    sharp = rt.SlidingTop(**toy, tip=tip, viscosity=0.01)
    path = sharp.motion(theta=np.radians(20.0), omega3=250.0).integrate(
        np.linspace(0.0, 4.0, 401), rtol=1e-8, atol=1e-10
    )
    late = np.degrees(path.theta[-100:].mean())
    kept = np.ptp(path.jellett) < 1e-6 * path.jellett[0]
    print(f"r = {1000 * tip:.0f} mm: θ = {late:.1f}° in the last second; Jellett kept: {kept}")

# %% [markdown] tags=["solution"]
# With $r = 0$ Jellett's constant is $RL_3$: it only says that the spin stays. The sharp top does
# not stand up: what friction takes, little, comes from its height, and it sinks from 20° to 21°.

# %% tags=["check"]
# %%answer exercise-6.1 --hint tries
# theta = 21.0°

# %% [markdown]
# ### Exercise 6.2
#
# Now a dry table: Coulomb friction with $\mu = 0.1$ and the round tip, without air. Follow the
# slip. What happens, and what becomes of the energy afterwards? Give the time, and the mean
# $\theta$ from then on.
#
# <details><summary>First hint</summary>
#
# `rt.SlidingTop(**toy, tip=0.003, mu=0.1)`; its trajectory has `events`.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# `path.rolling` says when it rolls; what does friction take where nothing slips?
#
# </details>

# %% tags=["solution"]
dry = rt.SlidingTop(**toy, tip=0.003, mu=0.1)
path = dry.motion(theta=np.radians(20.0), omega3=250.0).integrate(
    np.linspace(0.0, 2.0, 401), rtol=1e-8, atol=1e-10
)
for event in path.events:
    print(f"{event.kind} at {event.time:.3f} s")
later = path.rolling
print(f"θ when it rolls: {np.degrees(path.theta[later].mean()):.1f}°")
print(f"its energy stays: {np.ptp(path.energy[later]) < 1e-9 * path.energy[0]}")

# %% [markdown] tags=["solution"]
# After a moment static friction holds the tip: it rolls, the slip is zero, and nothing is lost any
# more. The top does not stand up further.

# %% tags=["check"]
# %%answer exercise-6.2 --hint tries
# time = 0.249 s
# theta = 15.6°

# %% [markdown]
# ### Exercise 6.3
#
# A top slows down in the air as $\omega_3 = \omega_0e^{-c_3t/\lambda_3}$. How long does the wooden
# top stay above the sleeping spin if you start it with 250 rad/s? How much longer with twice the
# spin? Find the time also in the motion above.
#
# <details><summary>First hint</summary>
#
# Solve $\omega_0e^{-c_3t/\lambda_3} = \omega_s$ for the time.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# `sleeping` above is $\omega_s$, and $c_3$ is `drag3`, $10^{-6}$ N m s.
#
# </details>

# %% tags=["solution"]
decay = toy["lambda3"] / 1e-6
for rate in (250.0, 500.0):
    print(f"from {rate:.0f} rad/s: {decay * np.log(rate / sleeping):.2f} s")
print(f"in the motion {awake:.2f} s")

# %% [markdown] tags=["solution"]
# Twice the spin adds $(\lambda_3/c_3)\ln 2$, always the same time.

# %% tags=["check"]
# %%answer exercise-6.3 --hint tries
# asleep = 5.18 s
# twice = 9.34 s

# %% [markdown]
# ### Exercise 6.4
#
# Film your own top. Count its turns per second at the start and note when it begins to wobble. From
# its shape compute the sleeping spin, and from both the drag $c_3$. (No top at hand? Take a cone of
# 40 g, 25 mm in radius and 25 mm high, which starts with 30 turns a second and wobbles after 12 s.)
# The check is for the cone.
#
# <details><summary>First hint</summary>
#
# The moments and the centre of mass of a cone stand above, about its tip.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# Between the start and the wobble $\omega_3 = \omega_0e^{-c_3t/\lambda_3}$: solve for $c_3$.
#
# </details>

# %% tags=["solution"]
values = {a: Rational("0.025"), b: Rational("0.025"), M: Rational("0.04"), g: Rational("9.81")}
own_sleeping = float(sqrt(least_squared).subs(values))
own_lambda3 = float(about_apex[2, 2].subs(values))
start = 2 * np.pi * 30
print(f"it should wobble below {own_sleeping:.0f} rad/s; it starts with {start:.0f} rad/s")
print(f"c₃ = {own_lambda3 * np.log(start / own_sleeping) / 12:.2e} N m s")

# %% [markdown] tags=["solution"]
# And a top from the toy box, measured with more care:

# %% tags=["solution"]
solution("top-from-the-toy-box")

# %% tags=["check"]
# %%answer exercise-6.4 --hint tries
# sleeping_spin = 99.0 rad/s
# drag3 = 4.02e-7 N m s
