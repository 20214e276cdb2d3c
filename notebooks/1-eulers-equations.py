# %% [markdown]
# # 1 Euler's equations, and which axes are stable
#
# Sections 3.2 to 3.2.2 of the notes. We start from the conservation of angular momentum, write it
# in a frame that turns with the body, and get three short equations. Two questions follow. About
# which axes can a body rotate steadily? And what does it do when it is pushed a little?
#
# You need nothing but the definition $\mathbf{L} = I\boldsymbol{\omega}$. The first cell brings
# the letters of the notes, which print as there: `lambda1` as $\lambda_1$, `omega1dot` as
# $\dot\omega_1$.

# %%
from rigidtop.notebook import *

# %% [markdown]
# ## From $\dot{\mathbf{L}} = 0$ to Euler's equations
#
# No torque acts, so in the space frame $\dot{\mathbf{L}} = 0$ (3.33). But there the inertia tensor
# turns with the body, and $I(t)$ is awkward. Along the principal axes $\mathbf{e}_1, \mathbf{e}_2,
# \mathbf{e}_3$ it is diagonal and constant, and $L_k = \lambda_k\omega_k$:

# %%
omega = Matrix([omega1, omega2, omega3])
L = diag(lambda1, lambda2, lambda3) * omega
Equation(L_vec, L)

# %% [markdown]
# The price is that these axes turn. A vector that is constant in space seems to turn backwards when
# it is seen from the body, which is (3.35):
#
# $$0 = \left(\frac{d\mathbf{L}}{dt}\right)_{\text{body}} + \boldsymbol{\omega}\times\mathbf{L}.$$
#
# In the body $\lambda_k$ is a number, so the first term is $\lambda_k\dot\omega_k$. All that is
# left to work out is the cross product:

# %%
turning = -omega.cross(L)
rates = (omega1dot, omega2dot, omega3dot)
moments = (lambda1, lambda2, lambda3)
[
    Equation(moment * rate, factor(right))
    for moment, rate, right in zip(moments, rates, turning, strict=True)
]

# %% [markdown]
# These are Euler's equations (3.36). Every right side is a product of *two* components of
# $\boldsymbol{\omega}$, times the difference of *the other two* moments. So
#
# - if $\boldsymbol{\omega}$ lies along a principal axis, two components vanish, and with them all
#   three right sides: the rotation is steady;
# - if two moments are equal, one right side vanishes for every $\boldsymbol{\omega}$.
#
# Two quantities never change: twice the kinetic energy, $2T = \boldsymbol{\omega}\cdot\mathbf{L}$
# (3.32), and $L^2$. We differentiate both along the motion, with the chain rule and nothing else:

# %%
omega_dot = Matrix([right / moment for right, moment in zip(turning, moments, strict=True)])


def along_the_motion(quantity):
    return (Matrix([quantity]).jacobian(omega) * omega_dot)[0].expand()


along_the_motion(omega.dot(L)), along_the_motion(L.dot(L))

# %% [markdown]
# ## A small push
#
# Let the body rotate about $\mathbf{e}_3$, so $\boldsymbol{\omega} = \omega_3\mathbf{e}_3$, and
# push it a little: $\omega_1$ and $\omega_2$ become small but not zero. We keep what is of first
# order in them. The matrix of first derivatives says it all:

# %%
jacobian = omega_dot.jacobian(omega).subs({omega1: 0, omega2: 0})
jacobian

# %% [markdown]
# $\omega_3$ does not change in this order, while $\omega_1$ drives $\omega_2$ and the other way
# round. If both grow as $e^{\sigma t}$, then $\sigma^2$ is the product of the two entries:

# %%
growth = factor(jacobian[0, 1] * jacobian[1, 0])
Equation(sigma2, growth)

# %% [markdown]
# Read the sign:
#
# - $\lambda_3$ is the **largest** or the **smallest** moment: both differences have the same sign,
#   $\sigma^2 < 0$, and the push makes small oscillations with the frequency $\sqrt{-\sigma^2}$.
# - $\lambda_3$ lies **between** the others: $\sigma^2 > 0$, and the push grows as $e^{\sigma t}$.
#
# ## Three axes of one body
#
# Now numbers. A body with the moments 1, 2 and 3 kg m² rotates at 2 rad/s about each of its axes in
# turn, and gets the same push of 0.01 rad/s. `motion.exact` gives the motion in closed form.

# %%
body = rt.FreeBody(1.0, 2.0, 3.0)
spin, push = 2.0, 0.01
times = np.linspace(0.0, 20.0, 1201)


def pushed(axis):
    """The motion after a push, when the body rotates about the axis 0, 1 or 2."""
    start = np.full(3, push)
    start[axis] = spin
    return body.motion(omega=tuple(start))


for axis, which in enumerate(("smallest", "middle", "largest")):
    # The formula above with the axes renamed: the axis in question plays the part of e₃.
    own, one, other = (body.moments[(axis + k) % 3] for k in (0, 1, 2))
    square = -(own - one) * (own - other) * spin**2 / (one * other)
    path = pushed(axis).exact(times).omega
    furthest = np.abs(np.delete(path, axis, axis=1)).max()
    print(
        f"axis of the {which:8} moment: σ² = {square:6.3f} /s², "
        f"largest |ω| across it in 20 s: {furthest:.3f} rad/s"
    )

# %%
with plot(
    "ω₁, ω₂, ω₃ against time for a rotation about each axis: steady, flipping, steady", columns=3
) as panels:
    for axis, (axes, which) in enumerate(
        zip(panels, ("smallest", "middle", "largest"), strict=True)
    ):
        path = pushed(axis).exact(times)
        for component, colour, name in zip(
            path.omega.T, (FIRST, SECOND, THIRD), "123", strict=True
        ):
            axes.plot(path.t, component, color=colour, label=rf"$\omega_{name}$")
        axes.set_title(f"about the axis of the {which} moment")
        axes.set_xlabel("$t$  (s)")
        axes.set_ylim(-2.4, 2.9)
    panels[0].set_ylabel(r"$\omega$  (rad/s)")
    panels[0].legend(ncols=3, loc="upper center", columnspacing=1.0, handlelength=1.2)

# %% [markdown]
# About the middle axis the body turns over, again and again. Each time it rests for a while near
# $\pm\mathbf{e}_2$, for the push first has to grow. In the beginning it grows as the linear theory
# says:

# %%
middle = body.motion(omega=(1e-6, spin, 1e-6)).exact([6.0, 7.0]).omega[:, 0]
sigma = np.sqrt((2.0 - 1.0) * (3.0 - 2.0) * spin**2 / (1.0 * 3.0))
print(f"σ = {sigma:.4f} /s; from the motion: {np.log(middle[1] / middle[0]):.3f} /s")

# %% [markdown]
# ## All rotations at once
#
# $T$ and $L^2$ are constant, and each is a sum of squares of $\omega_k$ with weights. So in the
# body $\boldsymbol{\omega}$ runs along the curve in which two ellipsoids meet. Here are these
# curves for one energy and many values of $L$: round $\mathbf{e}_1$ and $\mathbf{e}_3$ they are
# small closed loops, but near $\mathbf{e}_2$ they lead away. That is the picture behind the signs
# above.

# %%
figure("polhodes", lambda1=1.0, lambda2=2.0, lambda3=3.0)

# %% [markdown]
# ## Play
#
# Change the middle moment. At the upper end of the slider it equals the largest: what becomes of
# the flips there? (At the lower end the body is a flat plate, $\lambda_1 + \lambda_2 = \lambda_3$;
# no body lies beyond.) Then change the push, and see how long the body waits.


# %%
def flips(axes, lambda2, push):
    motion = rt.FreeBody(1.0, lambda2, 3.0).motion(omega=(push, 2.0, push))
    path = motion.exact(np.linspace(0.0, 40.0, 1601))
    axes.plot(path.t, path.omega[:, 1], color=SECOND)
    axes.axhline(0.0, color=GREY, lw=0.6)
    axes.set_xlabel("$t$  (s)")
    axes.set_ylabel(r"$\omega_2$  (rad/s)")
    axes.set_ylim(-2.6, 2.6)


sliders(
    flips,
    "ω₂ against time: the body turns over at equal intervals",
    height=2.2,
    lambda2=(2.0, 2.2, 3.0),
    push=(0.001, 0.01, 0.3),
)

# %% [markdown] tags=["lecturer"]
# ## What the notes say, judged
#
# The notes say that rotation is stable about the axes of the largest and of the smallest moment,
# and unstable otherwise. `rigidtop` types this claim, derives its own form and compares. The
# verdict *assuming* means: true only under a condition that is not written beside the claim. Here
# it is that no other moment *equals* that of the axis. The counterexample stands beside the
# condition.

# %% tags=["lecturer"]
verdict("axis-stability")

# %% [markdown] tags=["lecturer"]
# The same gap shows in the sentence that $\boldsymbol{\omega}$ *must* change if it does not lie
# along a principal axis and two components are not zero: the two moments have to differ.

# %% tags=["lecturer"]
verdict("off-axis-changes")

# %% [markdown]
# ## Exercises
#
# ### Exercise 1.1
#
# Linear theory says nothing about late times. Show that $2\lambda_3 T - L^2$ is conserved, and that
# it does not contain $\omega_3$. Why does that prove stability about $\mathbf{e}_3$ *for all times*
# if $\lambda_3$ is the largest or the smallest moment? Why not if it is the middle one? Give both
# weights, those of $\omega_1^2$ and $\omega_2^2$, for the body of this notebook.
#
# <details><summary>First hint</summary>
#
# Write out $2\lambda_3 T$ and $L^2$ in $\omega_1, \omega_2, \omega_3$ before you subtract.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# The factor before $\omega_1^2$ is $\lambda_1(\lambda_3-\lambda_1)$. Which signs can it have, and
# which the other?
#
# </details>

# %% tags=["solution"]
conserved = factor(lambda3 * omega.dot(L) - L.dot(L))
conserved.expand().collect([omega1, omega2], factor), along_the_motion(conserved)

# %% [markdown] tags=["solution"]
# Both coefficients have the same sign if $\lambda_3$ is extreme. Then $\omega_1^2$ and
# $\omega_2^2$, each with a positive weight, have a constant sum: what starts small stays small. If
# $\lambda_3$ is the middle moment the signs differ, and both terms may grow together.

# %% [markdown] tags=["solution"]
# The same with all steps, and numbers for the body of this notebook (assignment 5 of the notes):

# %% tags=["solution"]
solution("stable-axes", lambda1=1.0, lambda2=2.0, lambda3=3.0)

# %% tags=["check"]
# %%answer exercise-1.1 --hint tries
# weight_1 = 2.0 kg² m⁴
# weight_2 = 2.0 kg² m⁴

# %% [markdown]
# ### Exercise 1.2
#
# A coin-like body has $\lambda_1 = \lambda_2 = 2$ and $\lambda_3 = 3$ kg m². It rotates at 2 rad/s
# about $\mathbf{e}_1$, which has the *smallest* moment. What is $\sigma^2$? Push it by 0.01 rad/s
# along $\mathbf{e}_3$ and look at $\omega_1$ for 700 s. Is this rotation stable? How long is a
# quarter of the period of $\omega_1$?
#
# <details><summary>First hint</summary>
#
# Rename the axes in the formula for $\sigma^2$: now $\mathbf{e}_1$ plays the part of
# $\mathbf{e}_3$.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# $\omega_3$ is constant. With it the other two equations are an oscillator, however slow.
#
# </details>

# %% tags=["solution"]
coin = rt.FreeBody(2.0, 2.0, 3.0)
path = coin.motion(omega=(2.0, 0.0, 0.01)).exact(np.linspace(0.0, 700.0, 1401))
print(f"σ² = {-(2.0 - 2.0) * (2.0 - 3.0) * 2.0**2 / (2.0 * 3.0) + 0.0:.1f} /s²")
print(f"ω₁ falls from {path.omega[0, 0]:.2f} to {path.omega[:, 0].min():.2f} rad/s")
with plot("ω₁ and ω₂ of the coin: slow full oscillations", 4.5, 2.2) as axes:
    axes.plot(path.t, path.omega[:, 0], color=FIRST, label=r"$\omega_1$")
    axes.plot(path.t, path.omega[:, 1], color=SECOND, label=r"$\omega_2$")
    axes.set_xlabel("$t$  (s)")
    axes.set_ylabel("rad/s")
    axes.legend(ncols=2, loc="upper right")
    axes.set_ylim(-2.2, 3.0)

# %% [markdown] tags=["solution"]
# $\sigma^2 = 0$: nothing grows exponentially, but $\omega_2$ grows in proportion to the time, and
# after a quarter of $2\pi/|\Omega_b|$ the axis $\mathbf{e}_1$ has been left altogether. It is not
# stable, although its moment is the smallest: this is the condition that the notes leave out.

# %% tags=["check"]
# %%answer exercise-1.2 --hint tries
# sigma_squared = 0.0 1/s²
# quarter = 314.2 s

# %% [markdown]
# ### Exercise 1.3
#
# Make the push about the middle axis ten times smaller, again and again. By how much longer does
# the body with moments 1, 2, 3 kg m² wait between two flips? Explain the number by $\sigma$.
#
# <details><summary>First hint</summary>
#
# Near the middle axis a deviation grows as $e^{\sigma t}$. How long until it is ten times as large?
#
# </details>
#
# <details><summary>Second hint</summary>
#
# It also has to shrink on the way in: a flip begins and ends near the axis.
#
# </details>

# %% tags=["solution"]
waits = []
for exponent in (2, 3, 4, 5, 6):
    motion = body.motion(omega=(10.0**-exponent, spin, 0.0))
    path = motion.exact(np.linspace(0.0, 60.0, 60001))
    flip_times = path.t[1:][np.diff(np.sign(path.omega[:, 1])) != 0]
    waits.append(flip_times[1] - flip_times[0])
    print(f"push 10^-{exponent} rad/s: a flip every {waits[-1]:.3f} s")
print(
    f"longer by {np.diff(waits)[-1]:.3f} s each time; 2 ln(10)/σ = {2 * np.log(10) / sigma:.3f} s"
)

# %% [markdown] tags=["solution"]
# Between two flips a deviation shrinks as $e^{-\sigma t}$ to about the size of the push, and grows
# again as $e^{\sigma t}$. A push ten times smaller costs $\ln 10/\sigma$ on each side.

# %% tags=["check"]
# %%answer exercise-1.3 --hint tries
# longer = 3.99 s

# %% [markdown]
# ### Exercise 1.4
#
# Throw a phone, with the moments $\lambda_1 : \lambda_2 : \lambda_3 = 0.21 : 0.80 : 1$ in units of
# the largest, so that it turns twice a second about $\mathbf{e}_2$. Your hand is never better than
# 5 degrees. How long until it has turned over for the first time? Let $\boldsymbol{\omega}$ lean
# towards $\mathbf{e}_1$, then towards $\mathbf{e}_3$, and wait until $\omega_2$ changes its sign.
#
# <details><summary>First hint</summary>
#
# Start with $\omega\sin 5°$ along one axis and $\omega\cos 5°$ along $\mathbf{e}_2$, with $\omega =
# 4\pi$ rad/s.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# `motion.exact(times).omega[:, 1]` is $\omega_2$; find where it first is negative.
#
# </details>

# %% tags=["solution"]
phone = rt.FreeBody(0.21, 0.80, 1.0)
rate, lean = 2 * 2 * np.pi, np.radians(5.0)
for name, start in (
    ("towards e₁", (rate * np.sin(lean), rate * np.cos(lean), 0.0)),
    ("towards e₃", (0.0, rate * np.cos(lean), rate * np.sin(lean))),
):
    path = phone.motion(omega=start).exact(np.linspace(0.0, 2.0, 20001))
    first = path.t[np.argmax(path.omega[:, 1] < 0)]
    print(f"5° {name}: ω₂ changes its sign after {first:.2f} s")

# %% tags=["check"]
# %%answer exercise-1.4 --hint tries
# towards_e1 = 0.40 s
# towards_e3 = 0.38 s
