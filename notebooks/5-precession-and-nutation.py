# %% [markdown]
# # 5 Steady precession and nutation
#
# Sections 3.5.3 and 3.5.4 of the notes. When can the tilt of a top stay constant? The answer is the
# quadratic (3.57), with a slow and a fast solution, and one branch that gets lost on the way. Then
# we disturb the steady top: it nods, and its axis draws waves, cusps or loops.

# %%
from rigidtop.notebook import *

# %% [markdown]
# ## Constant tilt
#
# The lines of the lecture, from Lagrange's equation for $\theta$ to (3.57):

# %%
steps("3.57")

# %% [markdown]
# But a product also vanishes with the factor by which it is divided. For $\sin\theta = 0$, upright
# or hanging, every $\Omega$ is a steady motion.

# %% [markdown] tags=["lecturer"]
# The notes divide without a word; the verdict finds the lost branch.

# %% tags=["lecturer"]
verdict("3.57")

# %% [markdown]
# ## Slow and fast
#
# For $\cos\theta \ne 0$ the equation is quadratic. Its discriminant decides whether there are
# solutions:

# %%
quadratic = steady_quadratic()
discriminant = Poly(quadratic, Omega).discriminant()
minus, plus = (
    (lambda3 * omega3 + sign * sqrt(discriminant)) / (2 * lambda1 * cos(theta)) for sign in (-1, 1)
)
[Equation(D, discriminant), Equation(Omega_minus, minus), Equation(Omega_plus, plus)]

# %% [markdown]
# Put both roots into the quadratic:

# %%
[quadratic.subs(Omega, root).expand() for root in (minus, plus)]

# %% [markdown]
# For a top above the horizontal there is a least spin, $\omega_3 =
# \frac{2}{\lambda_3}\sqrt{\lambda_1 MgR\cos\theta}$; below it no steady precession exists. For
# large $\omega_3$ everything depends on one small number, $\epsilon = \lambda_1
# MgR\cos\theta/(\lambda_3\omega_3)^2$. Measured by what the notes give, $MgR/(\lambda_3\omega_3)$
# and $\lambda_3\omega_3/(\lambda_1\cos\theta)$, the roots are

# %%
x = sqrt(1 - 4 * epsilon)
slow = series(2 / (1 + x), epsilon, 0, 3).removeO()
fast = series((1 + x) / 2, epsilon, 0, 3).removeO()
[
    Equation(Omega_minus / (M * g * R / (lambda3 * omega3)), slow, relation="≈"),
    Equation(Omega_plus / (lambda3 * omega3 / (lambda1 * cos(theta))), fast, relation="≈"),
]

# %%
example = {"lambda1": 0.02, "lambda3": 0.01, "M": 1.0, "R": 0.1}
top = rt.HeavyTop(**example)
tilt, spin = np.pi / 3, 40.0
print(f"least spin at 60°: {top.smallest_spin(tilt):.3f} rad/s")
for rate, name in zip(top.steady_precession(tilt, spin), ("slow", "fast"), strict=True):
    motion = top.motion(theta=tilt, phi_dot=rate, omega3=spin)
    path = motion.integrate(np.linspace(0.0, 20.0, 401), rtol=1e-12, atol=1e-13)
    held = np.abs(path.theta - tilt).max() < 1e-8
    print(f"{name}: Ω = {rate:.5f} rad/s; θ holds for 20 s: {held}")
try:
    top.steady_precession(tilt, 15.0)
except rt.NoSteadyPrecession as error:
    print(error)

# %% [markdown]
# Tilt the top with the slider. Above 90° the centre of mass is below the pivot: the threshold is
# gone, and the fast root turns the other way.


# %%
def rates(axes, theta, omega3):
    draw_precession_rates(axes, top, theta, omega3)


sliders(
    rates,
    "Ω₋ and Ω₊ against ω₃, dashed the values for large ω₃, dotted the least spin",
    width=4.8,
    height=3.0,
    theta=(0.1, 1.05, 2.8),
    omega3=(15.0, 40.0, 90.0),
)

# %% [markdown]
# ## The sleeping top
#
# Upright, every $\Omega$ is steady, but is it stable? Near $\theta = 0$ the same quadratic, with
# $\cos\theta = 1$, gives the two frequencies at which the axis circles round the vertical. They are
# real, and a small tilt stays small, for a top that is faster than $\lambda_3\omega_3 =
# 2\sqrt{\lambda_1 MgR}$. Let us release tops at 3°:

# %%
wakes = top.sleeping_spin()
print(f"sleeping spin {wakes:.3f} rad/s")
for factor in (1.2, 1.05, 0.95, 0.8):
    motion = top.motion(theta=np.radians(3.0), omega3=factor * wakes)
    print(f"ω₃ = {factor:.2f} of it: θ up to {np.degrees(motion.turning_points[1]):6.2f}°")

# %% [markdown]
# ## Nutation
#
# $\theta$ moves like a particle in the effective potential of its $p_\phi$ and $p_\psi$. The steady
# tilt is its minimum. How stiff is it there? We differentiate twice and put in the momenta and the
# weight of a steady precession. The slope vanishes, and $\lambda_1$ times the stiffness is a sum of
# two squares:

# %%
U = top_effective_potential()
momenta = {
    p_phi: lambda1 * Omega * sin(theta) ** 2 + lambda3 * omega3 * cos(theta),
    p_psi: lambda3 * omega3,
}
weight = solve(quadratic, g)[0]
slope = reduce_ratio(U.diff(theta).subs(momenta).subs(g, weight))
stiffness = reduce_ratio(U.diff(theta, 2).subs(momenta).subs(g, weight))
squares = (lambda3 * omega3 - 2 * lambda1 * Omega * cos(theta)) ** 2 + (
    lambda1 * Omega * sin(theta)
) ** 2
slope, reduce_trig(lambda1 * stiffness - squares)

# %%
Equation(lambda1**2 * omega_n2, squares)

# %% [markdown]
# $\omega_n^2 = U''/\lambda_1$ is never negative. So every steady precession with $\sin\theta\ne0$
# is stable. For a fast top it is nearly $\lambda_3\omega_3/\lambda_1$. Check with motions that
# start a little off the slow precession:

# %%
for spin in (32.0, 40.0, 80.0, 160.0):
    rate = top.steady_precession(tilt, spin)[0]
    square = (
        (0.01 * spin - 2 * 0.02 * rate * np.cos(tilt)) ** 2 + (0.02 * rate * np.sin(tilt)) ** 2
    ) / 0.02**2
    motion = top.motion(theta=tilt, theta_dot=1e-4, phi_dot=rate, omega3=spin)
    seen = 2 * np.pi / motion.nutation_period
    print(
        f"ω₃ = {spin:5.0f} rad/s: ω_n = {np.sqrt(square):8.4f}, in the motion {seen:8.4f}", end=""
    )
    print(f", λ₃ω₃/λ₁ = {0.01 * spin / 0.02:4.1f} rad/s")

# %% [markdown]
# ## Waves, cusps, loops
#
# While $\theta$ nods, $\dot\phi$ varies by (3.45): it has the sign of $p_\phi - p_\psi\cos\theta$.
# If that changes between the turning points the axis goes back for a while and draws loops; if it
# vanishes just at one of them there are cusps; else there are waves. A spinning top whose axis is
# *let go at rest* always makes cusps, since there $\dot\phi = 0$ at a turning point. The slider
# sets $\dot\phi$ at the start.

# %%
with plot("paths of e₃ on the sphere: waves, cusps, loops", columns=3, height=2.7) as panels:
    for axes, rate in zip(panels, (1.6, 0.0, -1.6), strict=True):
        motion = top.motion(theta=tilt, phi=-1.25, phi_dot=rate, omega3=40.0)
        draw_path(axes, motion.exact(nutation_times(motion)).e3, motion.regime)


# %%
def path_and_rate(left, right, phi_dot, omega3):
    motion = top.motion(theta=tilt, phi=-1.25, phi_dot=phi_dot, omega3=omega3)
    times = nutation_times(motion)
    path = motion.exact(times)
    draw_path(left, path.e3, motion.regime)
    shown = times < 4 * motion.nutation_period
    right.plot(np.degrees(path.phi[shown]), np.degrees(path.theta[shown]), color=FIRST)
    right.plot(np.degrees(path.phi[0]), np.degrees(path.theta[0]), "o", color=SECOND, ms=4)
    right.invert_yaxis()
    right.set_xlabel(r"$\phi$  (degrees)")
    right.set_ylabel(r"$\theta$  (degrees)")


sliders(
    path_and_rate,
    "the path of e₃ on the sphere, and θ against φ with a dot at the start",
    height=2.9,
    columns=2,
    phi_dot=(-4.0, -1.0, 6.0),
    omega3=(20.0, 40.0, 80.0),
)

# %% [markdown]
# Now play with it. The cell below shows the live top, which starts with the loops on the right:
# grab its axis and flick it, change its spin, let friction run it down.

# %%
rt.show(top.motion(theta=tilt, phi_dot=-1.6, omega3=40.0))

# %% [markdown]
# All starts at once: which motion follows from which $\omega_3$ and which $\dot\phi$, at 60° and
# $\dot\theta = 0$? Every point of this map is a motion in closed form.

# %%
with plot("map of the regimes over ω₃ and φ̇ at the start", 4.8, 3.2) as axes:
    draw_regimes(axes, top, tilt, 60.0, 12.0)

# %% [markdown] tags=["lecturer"]
# The notes say that $\theta$ oscillates about the value where it could be constant. That holds for
# *small* oscillations; for larger ones the mean lies beside it. And upright it takes a fast top:

# %% tags=["lecturer"]
verdict("nutation")

# %% [markdown]
# ## Exercises
#
# ### Exercise 5.1
#
# A fast top is let go at rest at the tilt $\theta$. Show by numbers that it nods by $\pm\lambda_1
# MgR\sin\theta/(\lambda_3\omega_3)^2$. How does the formula fail for a slow top? Compare at 60° and
# 30 rad/s.
#
# <details><summary>First hint</summary>
#
# `motion.turning_points` are the smallest and the largest $\theta$.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# The amplitude is half of their difference; multiply $\omega_3$ by two again and again.
#
# </details>

# %% tags=["solution"]
for spin in (30.0, 60.0, 120.0, 240.0):
    highest, lowest = top.motion(theta=tilt, omega3=spin).turning_points
    amplitude = np.degrees((lowest - highest) / 2)
    formula = np.degrees(0.02 * 0.981 * np.sin(tilt) / (0.01 * spin) ** 2)
    print(f"ω₃ = {spin:5.0f} rad/s: {amplitude:7.3f}°, by the formula {formula:7.3f}°")

# %% [markdown] tags=["solution"]
# The relative error shrinks as $1/\omega_3^2$, with $\epsilon$. A slow top nods further than the
# formula says.

# %% tags=["check"]
# %%answer exercise-5.1 --hint tries
# amplitude = 13.1°
# formula = 10.8°

# %% [markdown]
# ### Exercise 5.2
#
# A conical pendulum is a top without spin that hangs: $\omega_3 = 0$ and $\theta > 90°$. What does
# (3.57) give? Check with `steady_precession` at 120°. Why is there no solution above the
# horizontal?
#
# <details><summary>First hint</summary>
#
# Without the term in $\omega_3$ the quadratic has $\Omega^2$ and a constant alone.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# $\Omega^2 = -MgR/(\lambda_1\cos\theta)$. Which sign has $\cos\theta$?
#
# </details>

# %% tags=["solution"]
without_spin = solve(quadratic.subs(omega3, 0), Omega**2)[0]
numbers = top.steady_precession(2 * np.pi / 3, 0.0)
print(f"Ω = ±{np.sqrt(0.981 / (0.02 * 0.5)):.5f} by hand, {numbers[0]:.5f} and {numbers[1]:.5f}")
Equation(Omega**2, without_spin)

# %% [markdown] tags=["solution"]
# $\Omega^2$ is positive only for $\cos\theta < 0$.

# %% tags=["check"]
# %%answer exercise-5.2 --hint tries
# Omega = 9.905 rad/s

# %% [markdown]
# ### Exercise 5.3
#
# At exactly $\theta = 90°$ (a gyroscope with a horizontal axis) the quadratic loses its first term.
# Which root is left, and is (3.52) then exact? What becomes of the other one as $\theta\to90°$?
# Give it at 40 rad/s.
#
# <details><summary>First hint</summary>
#
# With $\cos\theta = 0$ the equation is linear in $\Omega$.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# For the other root look at $\lambda_3\omega_3/(\lambda_1\cos\theta)$ as the cosine goes to zero.
#
# </details>

# %% tags=["solution"]
for degrees in (80.0, 89.0, 89.9, 90.0):
    slow_rate, fast_rate = top.steady_precession(np.radians(degrees), 40.0)
    print(f"θ = {degrees:4.1f}°: Ω₋ = {slow_rate:.6f}, Ω₊ = {fast_rate:.1f} rad/s")
print(f"MgR/(λ₃ω₃) = {0.981 / 0.4:.6f} rad/s")

# %% [markdown] tags=["solution"]
# The slow one is left, and (3.52) is exact there: with the axis at right angles to
# $\hat{\mathbf{z}}$ the precession adds nothing to $L_z$ along $\mathbf{e}_3$. The fast one grows
# without limit.

# %% tags=["check"]
# %%answer exercise-5.3 --hint tries
# Omega = 2.4525 rad/s

# %% [markdown]
# ### Exercise 5.4
#
# The fast root does not contain $g$, and the notes call it "the free precession, not too obviously
# so". Make it obvious: switch gravity off and compare $\Omega_+$ with $L/\lambda_1$. Then switch it
# on: by how much does $\Omega_+$ change in the next order? Give the rate without weight at 60° and
# 40 rad/s, and the change at 400 rad/s.
#
# <details><summary>First hint</summary>
#
# For constant $\theta$ and $g = 0$ the vector $\mathbf{L}$ is vertical, and $L\cos\theta =
# \lambda_3\omega_3$.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# The two roots have the sum $\lambda_3\omega_3/(\lambda_1\cos\theta)$: what one gains the other
# loses.
#
# </details>

# %% tags=["solution"]
weightless = rt.HeavyTop(**example, g=0.0)
free = weightless.steady_precession(tilt, 40.0)[1]
size = np.linalg.norm(
    weightless.motion(theta=tilt, phi_dot=free, omega3=40.0).start().angular_momentum
)
print(f"without weight: Ω₊ = {free:.6f}, L/λ₁ = {size / 0.02:.6f} rad/s")

heavy = top.steady_precession(tilt, 400.0)[1] - weightless.steady_precession(tilt, 400.0)[1]
print(f"at 400 rad/s the weight changes it by {heavy:.5f} rad/s; -MgR/(λ₃ω₃) = {-0.981 / 4:.5f}")
Equation(Omega_plus, steady_expansions(2)[1])

# %% [markdown] tags=["solution"]
# Without weight $\mathbf{L}$ is constant, and the axis turns about it at $L/\lambda_1$ (notebook
# 2). As $\theta$ is constant, $\mathbf{L}$ is vertical.

# %% tags=["check"]
# %%answer exercise-5.4 --hint tries
# free = 40.0 rad/s
# change = -0.2453 rad/s
