# %% [markdown]
# # 2 Free precession, and the asteroid Toutatis
#
# Section 3.2.3 of the notes. A body with two equal moments rotates freely. We solve Euler's
# equations, look at the result once from the body and once from space, and prove what the notes
# leave open: that in space everything turns about $\mathbf{L}$ at the rate $L/\lambda_1$. Then we
# follow a real body that tumbles, the asteroid Toutatis, and compare with radar observations.

# %%
from rigidtop.notebook import *

# %% [markdown]
# ## Euler's equations for two equal moments
#
# Put $\lambda_2 = \lambda_1$ into (3.36). The third equation loses its right side, so $\omega_3$ is
# a constant number from now on:

# %%
rates = body_accelerations().subs(lambda2, lambda1)
[Equation(x, y) for x, y in zip((omega1dot, omega2dot, omega3dot), rates, strict=True)]

# %% [markdown]
# What stands before $\omega_2$ in the first line is the frequency $\Omega_b$ of (3.37) and (3.40).
# The two equations that are left say $\dot\omega_1 = \Omega_b\omega_2$ and $\dot\omega_2 =
# -\Omega_b\omega_1$.

# %%
frequency = rates[0].coeff(omega2)
Equation(Omega_b, frequency)

# %% [markdown]
# Differentiate the first once more and put in the second: $\ddot\omega_1 = -\Omega_b^2\omega_1$, an
# oscillator. Choose $\mathbf{e}_1$ along the part of $\boldsymbol{\omega}$ across $\mathbf{e}_3$ at
# $t = 0$ (with two equal moments we may), and call the length of that part $\omega_0$:

# %%
swing = Function("omega_1", real=True)
oscillation = dsolve(
    swing(t).diff(t, 2) + Omega_b**2 * swing(t),
    ics={swing(0): omega_0, swing(t).diff(t).subs(t, 0): 0},
)
first = oscillation.rhs.rewrite(cos).simplify()
in_body = Matrix([first, first.diff(t) / Omega_b, omega3])
Equation(omega_vec, in_body)

# %% [markdown]
# This is (3.38): in the body $\boldsymbol{\omega}$ goes round $\mathbf{e}_3$ on a circle, in the
# negative sense if $\Omega_b > 0$. $\mathbf{L}$ follows from $L_k = \lambda_k\omega_k$, which is
# (3.39):

# %%
L = diag(lambda1, lambda1, lambda3) * in_body
Equation(L_vec, L)

# %% [markdown]
# ## One plane
#
# $\mathbf{e}_3$, $\boldsymbol{\omega}$ and $\mathbf{L}$ lie in one plane at all times: their triple
# product vanishes, and one is a combination of the other two.

# %%
axis = Matrix([0, 0, 1])
triple = axis.dot(in_body.cross(L)).simplify()
combination = (lambda1 * in_body + (lambda3 - lambda1) * omega3 * axis - L).expand()
triple, combination.T

# %% [markdown] tags=["lecturer"]
# The notes draw the same conclusion, but from the fact that the *angle* between
# $\boldsymbol{\omega}$ and $\mathbf{L}$ is constant. That is not enough. The verdict below keeps
# the claim, and gives two vectors that keep their angle and still leave the plane.

# %% tags=["lecturer"]
verdict("coplanar")

# %% [markdown]
# ## In space
#
# $\boldsymbol{\omega}$ has a part along $\mathbf{L}$ and one along $\mathbf{e}_3$. The second does
# not move $\mathbf{e}_3$; the first turns it about the *constant* vector $\mathbf{L}$ with the rate
# $\Omega_s = L/\lambda_1$. This is the proof that the notes leave out:

# %%
steps("space-cone")

# %% [markdown]
# Two rates for one motion: $\Omega_b$ as seen from the body, $\Omega_s$ as seen from space. Here
# are both for a long body and for a flat one, with motions computed in closed form and looked at in
# space.

# %%
for shape, lambda_3 in (("long", 0.55), ("flat", 1.6)):
    body = rt.FreeBody(1.0, 1.0, lambda_3)
    motion = body.motion(omega=(0.45, 0.0, 1.0))
    path = motion.exact(np.linspace(0.0, 1.0, 2))
    size = np.linalg.norm(path.angular_momentum[0])
    up = path.angular_momentum[0] / size
    # How far has e₃ gone round L in one second?
    across = path.e3 - np.outer(path.e3 @ up, up)
    turned = np.arctan2(up @ np.cross(*across), across[0] @ across[1])
    print(
        f"{shape}: Ω_b = {(1.0 - lambda_3) * 1.0 / 1.0:+.3f} rad/s, "
        f"e₃ round L by {turned:.6f} rad in 1 s, L/λ₁ = {size / 1.0:.6f} rad/s"
    )

# %% [markdown]
# The picture of the notes, computed. In the body (left) $\boldsymbol{\omega}$ and $\mathbf{L}$ go
# round $\mathbf{e}_3$; in space (right) $\mathbf{L}$ stands still. Move $\lambda_3$ through
# $\lambda_1 = 1$: for a flat body $\boldsymbol{\omega}$ lies on the other side of $\mathbf{L}$.


# %%
def cones(left, right, lambda3, omega_0):
    motion = rt.FreeBody(1.0, 1.0, lambda3).motion(omega=(omega_0, 0.0, 1.0))
    draw_cones(left, motion, space=False)
    draw_cones(right, motion, space=True)
    left.set_title("body frame")
    right.set_title("space frame")


sliders(
    cones,
    "the cones on which e₃, ω and L go round each other, in the body frame and in space",
    height=2.9,
    columns=2,
    lambda3=(0.1, 0.55, 2.0),
    omega_0=(0.05, 0.45, 1.5),
)

# %% [markdown]
# ## Toutatis (example 33)
#
# Most asteroids rotate about a principal axis. Toutatis does not, and it has three different
# moments, so (3.38) does not hold for it. Euler's equations still have a closed form, in Jacobi's
# elliptic functions, and `rt.FreeBody` uses it. Moments (in units of the smallest) and the spin
# state in 1992 are those of Takahashi, Busch & Scheeres (2013); we count in days.

# %%
asteroid = rt.FreeBody(*map(float, toutatis.MOMENTS))


def attitude(state):
    """R = Rz(α) Rx(β) Rz(γ), body to space, of the published angles."""
    return Rotation.from_euler("ZXZ", state.angles, degrees=True)


start = toutatis.START
tumbling = asteroid.motion(omega=np.radians(start.rates), attitude=attitude(start))
path = tumbling.exact(np.linspace(0.0, 30.0, 3001))
up = path.angular_momentum[0] / np.linalg.norm(path.angular_momentum[0])
lean = np.degrees(np.arccos(path.e3 @ up))
around_axis = 2 * tumbling.nutation_period
around_L = 2 * np.pi / abs(tumbling.mean_precession)
print(f"regime: {tumbling.regime}")
print(f"the long axis is {lean.min():.1f} to {lean.max():.1f} degrees from L")
print(f"ω goes round the long axis once in {around_axis:.2f} days")
print(f"the long axis goes round L once in {around_L:.2f} days, on average")
for source, rotation, precession in toutatis.PERIODS:
    print(f"    published: {rotation} and {precession} days, {source}")

# %%
figure("tumbling")

# %% [markdown]
# Radar saw the asteroid on seventeen days in December 1992, three weeks after the start of our
# motion. Nothing is fitted here: we follow the free motion to each of these times and compare the
# rates in the body.

# %%
states = [state for state in toutatis.OBSERVATIONS if state.time.startswith("1992")]
epoch = datetime.fromisoformat(start.time)
days = np.array([(datetime.fromisoformat(s.time) - epoch).total_seconds() / 86400 for s in states])
seen = np.array([state.rates for state in states])
computed = tumbling.exact(days)
lag = np.degrees(
    [
        (attitude(state).inv() * now).magnitude()
        for state, now in zip(states, computed.rotation, strict=True)
    ]
)
print(f"attitude: half of the times less than {np.median(lag):.0f}° off, at most {lag.max():.0f}°")
with plot("body rates of Toutatis: curves computed, dots observed", height=2.7) as axes:
    fine = tumbling.exact(np.linspace(days[0] - 0.5, days[-1] + 0.5, 800))
    for k, (colour, name) in enumerate(zip((FIRST, SECOND, THIRD), "123", strict=True)):
        axes.plot(fine.t, np.degrees(fine.omega[:, k]), color=colour)
        axes.plot(days, seen[:, k], "o", color=colour, ms=3.5, label=rf"$\omega_{name}$")
    axes.set_xlabel("days since 9 November 1992")
    axes.set_ylabel("degrees per day")
    axes.legend(ncols=3, loc="upper right")
    axes.set_ylim(-120, 80)

# %% [markdown]
# Why do most asteroids *not* tumble? Inside a body that tumbles, stresses change and friction eats
# energy, while $\mathbf{L}$ stays. At given $L$ the energy is least for rotation about the axis of
# the *largest* moment. So a body that loses energy ends there. Toutatis turns so slowly that it has
# not yet.

# %% tags=["lecturer"]
verdict("example-33")

# %% [markdown]
# ## Exercises
#
# ### Exercise 2.1
#
# The Earth has $(\lambda_3-\lambda_1)/\lambda_3 = 1/305$ and rotates once in 0.99727 days. After
# how many days would a free precession of its rotation axis in the body be completed? (The
# wobble that Chandler found has a period of 433 days today, as the Earth is not rigid.) Which way
# does it go round?
#
# <details><summary>First hint</summary>
#
# You need $(\lambda_1-\lambda_3)/\lambda_1$. What is it, if $H = (\lambda_3-\lambda_1)/\lambda_3$?
#
# </details>
#
# <details><summary>Second hint</summary>
#
# It is $-H/(1-H) = -1/304$, and $\omega_3$ is nearly the whole rate of rotation.
#
# </details>

# %% tags=["solution"]
H = 1 / 305
omega_earth = 2 * np.pi / 0.99727
ratio = -H / (1 - H)  # (λ₁ − λ₃)/λ₁
rate = ratio * omega_earth
print(f"Ω_b = {rate:.5f} rad/day, 2π/|Ω_b| = {2 * np.pi / abs(rate):.1f} days")

# %% [markdown] tags=["solution"]
# $\Omega_b < 0$ for a flat body: (3.38) then turns in the positive sense, the same way as the Earth
# rotates. As $\tau_b = 2\pi/\Omega_b$ of the notes is negative here, it should be read with
# $|\Omega_b|$.

# %% tags=["check"]
# %%answer exercise-2.1 --hint tries
# period = 303.2 days

# %% [markdown]
# ### Exercise 2.2
#
# A dinner plate is thrown with a small wobble. In the space frame, how many wobbles does it make
# for one turn of its pattern about $\mathbf{e}_3$? (A flat disc has $\lambda_3 = 2\lambda_1$.
# Feynman remembered the answer the wrong way round.)
#
# <details><summary>First hint</summary>
#
# The wobble is the motion of $\mathbf{e}_3$ about $\mathbf{L}$, with the rate $L/\lambda_1$.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# For a small wobble $L$ is nearly $\lambda_3\omega_3$.
#
# </details>

# %% tags=["solution"]
plate = rt.FreeBody(1.0, 1.0, 2.0)
for tilt in (0.3, 0.1, 0.01):
    motion = plate.motion(omega=(2.0 * np.tan(tilt), 0.0, 1.0))
    print(f"e₃ {tilt:.2f} rad from L: Ω_s/ω₃ = {abs(motion.mean_precession):.4f}")

# %% [markdown] tags=["solution"]
# $\Omega_s = L/\lambda_1 = \lambda_3\omega_3/(\lambda_1\cos\beta)$, where $\beta$ is the angle from
# $\mathbf{e}_3$ to $\mathbf{L}$. For a small wobble that is $2\omega_3$: two wobbles a turn.

# %% tags=["solution"]
solution("wobbling-plate")

# %% tags=["check"]
# %%answer exercise-2.2 --hint tries
# wobbles = 2.0

# %% [markdown]
# ### Exercise 2.3
#
# How are $\Omega_s$, $\Omega_b$ and $\omega_3$ related? Let $\beta$ be the angle between
# $\mathbf{L}$ and $\mathbf{e}_3$. Show that $\omega_3 = \Omega_s\cos\beta + \Omega_b$. What does
# this say about the Euler angles $\phi$ and $\psi$ with $\mathbf{L}$ as the vertical? Give
# $\Omega_s$, $\Omega_b$ and $\beta$ for the long body above, with $\boldsymbol{\omega} = (0.45, 0,
# 1)$ rad/s.
#
# <details><summary>First hint</summary>
#
# $L_3 = L\cos\beta = \lambda_3\omega_3$.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# Divide by $\lambda_1$, and add $\Omega_b = (\lambda_1-\lambda_3)\omega_3/\lambda_1$.
#
# </details>

# %% tags=["solution"]
# cos β = L₃/L and Ω_s = L/λ₁, so their product is L₃/λ₁.
(lambda3 * omega3 / lambda1 + frequency).simplify()

# %% [markdown] tags=["solution"]
# It says $\omega_3 = \dot\phi\cos\theta + \dot\psi$ with $\theta = \beta$, $\dot\phi = \Omega_s$
# and $\dot\psi = \Omega_b$: free precession is a steady precession without weight.

# %% tags=["check"]
# %%answer exercise-2.3 --hint tries
# Omega_s = 0.7106 rad/s
# Omega_b = 0.450 rad/s
# beta = 39.3°

# %% [markdown]
# ### Exercise 2.4
#
# Suppose friction slowly takes energy from Toutatis while $\mathbf{L}$ stays. How much of its
# kinetic energy is lost when it rotates about the axis of the largest moment? About which axis did
# it rotate with the *most* energy? What share of its energy is left?
#
# <details><summary>First hint</summary>
#
# For rotation about a principal axis $T = L^2/2\lambda$.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# With the same $L$ the energy is least for the largest moment, and most for the smallest.
#
# </details>

# %% tags=["solution"]
momentum = np.linalg.norm(path.angular_momentum[0])
now = path.energy[0]
least, most = momentum**2 / (2 * asteroid.lambda2), momentum**2 / (2 * asteroid.lambda3)
print(f"now T is {now / most:.3f} of the most that this L allows (about e₃, the long axis)")
print(f"at the end {least / now:.3f} of the present energy is left, about e₂")

# %% tags=["check"]
# %%answer exercise-2.4 --hint tries
# left = 0.518
