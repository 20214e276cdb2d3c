# %% [markdown]
# # 4 The heavy top, from its Lagrangian
#
# Sections 3.5.1 to 3.5.3 of the notes. Gravity pulls at the centre of mass, and the top does not
# fall but walks round. First the quick argument with $\dot{\mathbf{L}} = \mathbf{N}$, then the
# Lagrangian and its equations of motion (3.54) to (3.56), with nothing assumed about
# $\boldsymbol{\omega}$. We turn these equations into a program and compare it with the closed form.

# %%
from rigidtop.notebook import *

# %% [markdown]
# ## The quick argument
#
# Gravity acts as if all mass sat at the centre of mass (3.49), at $R\mathbf{e}_3$ from the pivot.
# Its torque about the pivot is $\mathbf{N} = R\mathbf{e}_3\times(-Mg\hat{\mathbf{z}})$:

# %%
z = Matrix([0, 0, 1])
axis = Matrix([sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)])
torque = (R * axis).cross(-M * g * z)
Equation(N_vec, torque)

# %% [markdown]
# It is horizontal, and at right angles to $\mathbf{e}_3$: it pushes the axis sideways. Suppose that
# $\mathbf{L} = \lambda_3\omega_3\mathbf{e}_3$ remains along the axis, as it nearly does for a fast
# top. Then $\dot{\mathbf{L}} = \mathbf{N}$ is an equation for $\mathbf{e}_3$ alone (3.50), and it
# says that $\mathbf{e}_3$ turns about $\hat{\mathbf{z}}$ with the rate $MgR/(\lambda_3\omega_3)$,
# which is (3.51) with (3.52):

# %%
rate = M * g * R / (lambda3 * omega3)
difference = torque / (lambda3 * omega3) - (rate * z).cross(axis)
Equation(Omega_vec, rate * z), difference.expand().T

# %%
figure("torque")

# %% [markdown] tags=["lecturer"]
# The notes say that $\mathbf{L}\parallel\boldsymbol{\omega}$ is a good approximation for a weak
# torque, and that this would have to be shown. Here it is, with the condition under which it holds:

# %% tags=["lecturer"]
verdict("parallel-approximation")

# %% [markdown]
# ## The Lagrangian
#
# From (3.44) and the height $R\cos\theta$ of the centre of mass, with no assumption about
# $\mathbf{L}$:

# %%
spin = psidot + phidot * cos(theta)  # ω₃, from (3.42)
kinetic = lambda1 * (phidot**2 * sin(theta) ** 2 + thetadot**2) / 2 + lambda3 * spin**2 / 2
potential = M * g * R * cos(theta)
L = kinetic - potential
Equation(Lagrangian, L)

# %% [markdown]
# The equation of motion for $\theta$ follows in four lines:

# %%
steps("3.54")

# %% [markdown]
# $\phi$ and $\psi$ do not occur in $\mathcal{L}$, so their momenta are constant, (3.55) and (3.56):

# %%
diff(L, phi), diff(L, psi)

# %%
momenta = [factor_terms(diff(L, rate)) for rate in (phidot, psidot)]
[Equation(p_phi, momenta[0]), Equation(p_psi, momenta[1])]

# %% [markdown]
# What *are* these constants? $p_\psi = \lambda_3\omega_3$ is $L_3$. That $p_\phi$ is $L_z$ is "not
# obvious to see", say the notes. So take $\mathbf{L}$ along $\mathbf{e}_1', \mathbf{e}_2',
# \mathbf{e}_3$ (3.43), and $\hat{\mathbf{z}} = \cos\theta\,\mathbf{e}_3 -
# \sin\theta\,\mathbf{e}_1'$:

# %%
momentum = Matrix([-lambda1 * phidot * sin(theta), lambda1 * thetadot, lambda3 * spin])
vertical = Matrix([-sin(theta), 0, cos(theta)])
(vertical.dot(momentum) - momenta[0]).expand()

# %% [markdown]
# ## From equations to a program
#
# The same by the toolkit, which works for any $\mathcal{L}(q, \dot q)$. `accelerations` solves the
# three equations for the second derivatives:

# %%
q, v = (theta, phi, psi), (thetadot, phidot, psidot)
second = accelerations(L, q, v)
[Equation(x, y) for x, y in zip((thetaddot, phiddot, psiddot), second, strict=True)]

# %% [markdown]
# Note the $\sin\theta$ below the fraction line: these equations break down at the upright. Now make
# them a function of numbers and integrate. The example top has $\lambda_1 = 0.02$ and $\lambda_3 =
# 0.01$ kg m², $M = 1$ kg and $R = 0.1$ m. It starts at 60° with $\omega_3 = 40$ rad/s and no other
# motion.

# %%
numbers = {lambda1: Rational("0.02"), lambda3: Rational("0.01"), M: 1, R: Rational("0.1")}
right_side = lambdify((*q, *v), list(second.subs(numbers).subs(g, Rational("9.81"))))

tilt, fast = np.pi / 3, 40.0
times = np.linspace(0.0, 2.0, 401)
mine = solve_ivp(
    lambda t, state: [*state[3:], *right_side(*state)],
    (0.0, 2.0),
    [tilt, 0.0, 0.0, 0.0, 0.0, fast],
    t_eval=times,
    rtol=1e-10,
    atol=1e-10,
)

top = rt.HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1)
motion = top.motion(theta=tilt, omega3=fast)
exact = motion.exact(times)
error = np.abs(mine.y[:3] - [exact.theta, exact.phi, exact.psi]).max()
print(f"my program and the closed form agree: {error < 1e-7}")
print(f"regime: {motion.regime}, θ from {np.degrees(motion.turning_points[0]):.2f}°", end=" ")
print(f"to {np.degrees(motion.turning_points[1]):.2f}°")

# %%
with plot("θ and φ against time; dashed the quick argument", columns=2) as (left, right):
    left.plot(times, np.degrees(exact.theta), color=FIRST)
    left.set_ylabel(r"$\theta$  (degrees)")
    right.plot(times, np.degrees(exact.phi), color=FIRST, label=r"$\phi$")
    quick = 1.0 * 9.81 * 0.1 / (0.01 * fast)
    right.plot(times, np.degrees(quick * times), color=GREY, ls="--", label="(3.52)")
    right.set_ylabel(r"$\phi$  (degrees)")
    right.legend()
    for axes in (left, right):
        axes.set_xlabel("$t$  (s)")
print(f"mean precession {motion.mean_precession:.4f} rad/s, by (3.52) {quick:.4f} rad/s")

# %% [markdown]
# The top does precess about as fast as the quick argument says, but its axis nods at the same time:
# $\theta$ is not constant. That is nutation, the subject of the next notebook. The three constants
# of the motion, along my own solution:

# %%
constants = [kinetic + potential, *momenta]
evaluate = lambdify((*q, *v), [c.subs(numbers).subs(g, Rational("9.81")) for c in constants])
values = np.array(evaluate(*mine.y))
for name, row in zip(("energy (J)", "p_φ (J s)", "p_ψ (J s)"), values, strict=True):
    print(f"{name:10}  {row[0]:.6f}  changes by less than 1e-8: {np.ptp(row) < 1e-8}")

# %% [markdown]
# ## One motion of $\theta$ alone
#
# With two constants at hand $\dot\phi$ and $\dot\psi$ can be eliminated. What is left of the energy
# is $\tfrac12\lambda_1\dot\theta^2$ and a function of $\theta$, the *effective potential*:

# %%
velocities = solve([momenta[0] - p_phi, momenta[1] - p_psi], [phidot, psidot])
turning = lambda1 * sin(theta) ** 2 * velocities[phidot] ** 2 / 2
effective = reduce_ratio(turning) + p_psi**2 / (2 * lambda3) + potential
Equation(phidot, reduce_ratio(velocities[phidot])), Equation(U, effective)

# %% [markdown]
# $\theta$ runs to and fro between the two angles at which this potential takes the value of the
# energy. Let the spin go down, and see how far the top falls.


# %%


def potential_and_path(left, right, theta, omega3):
    motion = top.motion(theta=theta, phi=-1.2, omega3=omega3)
    draw_effective_potential(left, motion)
    draw_path(right, motion.exact(nutation_times(motion)).e3, motion.regime)


sliders(
    potential_and_path,
    "the effective potential with the turning points, and the path of e₃ on the sphere",
    height=2.9,
    columns=2,
    theta=(0.1, 1.05, 2.5),
    omega3=(5.0, 30.0, 80.0),
)

# %% [markdown]
# ## Exercises
#
# ### Exercise 4.1
#
# Example 34 of the notes: a top leans and is let go without any rotation. Which motion is this? How
# does $\mathbf{L}$ evolve? How long does the example top take to fall from 10° to 90°? Guess first.
#
# <details><summary>First hint</summary>
#
# What do the three equations of motion say for $\dot\phi = \dot\psi = 0$?
#
# </details>
#
# <details><summary>Second hint</summary>
#
# The energy gives $\dot\theta$ at each angle; or let `motion.exact` say when $\theta = 90°$.
#
# </details>

# %% tags=["solution"]
falling = second.subs({phidot: 0, psidot: 0})
[Equation(x, y) for x, y in zip((thetaddot, phiddot, psiddot), falling, strict=True)]

# %% tags=["solution"]
fall = top.motion(theta=np.radians(10.0), omega3=0.0)
time_to_fall = brentq(lambda t: fall.exact(t).theta[0] - np.pi / 2, 0.0, fall.nutation_period / 2)
momentum_then = fall.exact(time_to_fall).angular_momentum[0]
print(f"e₃ is horizontal after {time_to_fall:.4f} s, when L_y = {momentum_then[1]:.4f} J s")

# %% [markdown] tags=["solution"]
# $\phi$ and $\psi$ stay at rest, and $\lambda_1\ddot\theta = MgR\sin\theta$ is a pendulum that
# falls over. $\mathbf{L} = \lambda_1\dot\theta\,\mathbf{e}_2'$ grows along a fixed horizontal axis,
# which the torque has too. Nothing precesses: there is no $\mathbf{L}$ that could be turned.

# %% [markdown] tags=["solution"]
# The time is an elliptic integral. The whole solution:

# %% tags=["solution"]
solution("toppling-top", lambda1=0.02, M=1.0, R=0.1)

# %% tags=["check"]
# %%answer exercise-4.1 --hint tries
# time_to_fall = 0.4206 s

# %% [markdown]
# ### Exercise 4.2
#
# Derive (3.54) without a Lagrangian. Use $\dot{\mathbf{L}} = \mathbf{N}$ in the frame
# $\mathbf{e}_1', \mathbf{e}_2', \mathbf{e}_3$, which turns with $\boldsymbol{\omega}' =
# \dot\phi\,\hat{\mathbf{z}} + \dot\theta\,\mathbf{e}_2'$, and take the component along
# $\mathbf{e}_2'$. Then find $\ddot\theta$ of the example top at $\theta = 60°$ with $\dot\phi = 2$
# and $\omega_3 = 40$ rad/s.
#
# <details><summary>First hint</summary>
#
# In a frame that turns, $\dot{\mathbf{L}}$ is the rate of the components plus
# $\boldsymbol{\omega}'\times\mathbf{L}$.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# Along $\mathbf{e}_2'$ the weight has the torque $MgR\sin\theta$.
#
# </details>

# %% tags=["solution"]
frame = phidot * vertical + thetadot * Matrix([0, 1, 0])
weight = Matrix([0, 0, R]).cross(-M * g * vertical)
newton = (weight - frame.cross(momentum))[1]
(newton - diff(L, theta)).expand()

# %% tags=["check"]
# %%answer exercise-4.2 --hint tries
# theta_ddot = 9.57 rad/s²

# %% [markdown]
# ### Exercise 4.3
#
# A spring pulls the axis towards the vertical, with the potential $\tfrac12\kappa\sin^2\theta$.
# Which momenta are still conserved? Find $\ddot\theta$. How large must $\kappa$ be for a top
# *without* spin to stand upright? Give the number for the example top.
#
# <details><summary>First hint</summary>
#
# A coordinate that does not occur in $\mathcal{L}$ has a constant momentum.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# Near $\theta = 0$ the potential is $(\kappa - MgR)\theta^2/2$ and a constant.
#
# </details>

# %% tags=["solution"]
with_spring = L - kappa * sin(theta) ** 2 / 2
new = accelerations(with_spring, q, v)[0].subs({phidot: 0, psidot: 0})
cyclic(with_spring, q), Equation(thetaddot, new), new.diff(theta).subs(theta, 0)

# %% [markdown] tags=["solution"]
# $p_\phi$ and $p_\psi$ are conserved as before. Near $\theta = 0$ the last expression times
# $\theta$ is $\ddot\theta$; it is negative, and the top stands, for $\kappa > MgR$.

# %% tags=["check"]
# %%answer exercise-4.3 --hint tries
# kappa = 0.981 J

# %% [markdown]
# ### Exercise 4.4
#
# Let $\lambda_3$ go to zero and $\lambda_1 = MR^2$: all mass sits at one point. Show that
# $\mathcal{L}$ becomes that of a spherical pendulum that is held from below. Which of the conserved
# quantities has lost its meaning? With $R = 0.1$ m, how large is $\ddot\theta$ if it is let go at
# rest at 60°?
#
# <details><summary>First hint</summary>
#
# Put both values into $\mathcal{L}$, and compare with $\tfrac12Mv^2$ in polar coordinates.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# $MR^2\ddot\theta = MgR\sin\theta$ without a rotation about the vertical.
#
# </details>

# %% tags=["solution"]
Equation(Lagrangian, L.subs({lambda3: 0, lambda1: M * R**2}))

# %% [markdown] tags=["solution"]
# $\theta$ and $\phi$ are polar coordinates of the mass, with $\hat{\mathbf{z}}$ up. $p_\psi$ is
# gone with $\psi$: a point has no spin.

# %% tags=["check"]
# %%answer exercise-4.4 --hint tries
# theta_ddot = 84.96 rad/s²
