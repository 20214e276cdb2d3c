# %% [markdown]
# # 3 Euler angles and rotation matrices
#
# Sections 3.3 and 3.4 of the notes. Three angles say how a body is turned. We build the rotation
# from three simple ones, find $\boldsymbol{\omega}$ from it in two ways, and get the kinetic energy
# (3.44) and the formula for $\dot\phi$ (3.45). On the way we meet the matrix (3.47), which the
# notes call $O^T$. Is it?

# %%
from rigidtop.notebook import *

# %% [markdown]
# ## Three turns
#
# Turn about $\hat{\mathbf{z}}$ by $\phi$, about the new $\mathbf{e}_2'$ by $\theta$, about the new
# $\mathbf{e}_3$ by $\psi$.

# %%
figure("euler-angles")

# %% [markdown]
# Each turn alone is a simple matrix. Its columns are where the three axes go:

# %%


def turn_z(angle):
    return Matrix([[cos(angle), -sin(angle), 0], [sin(angle), cos(angle), 0], [0, 0, 1]])


def turn_y(angle):
    return Matrix([[cos(angle), 0, sin(angle)], [0, 1, 0], [-sin(angle), 0, cos(angle)]])


turn_z(phi), turn_y(theta)

# %% [markdown]
# The second turn is about $\mathbf{e}_2'$, which the first has moved. Turning about a moved axis
# is: turn back, turn about the axis where it was, and turn forth again. So the matrix of the second
# turn is $R_z(\phi)R_y(\theta)R_z(\phi)^{-1}$, and after two turns we have $R_z(\phi)R_y(\theta)$.
# The third goes the same way. The product stands in the order of the sequence:
#
# $$O = R_z(\phi)\,R_y(\theta)\,R_z(\psi).$$

# %%
O = turn_z(phi) * turn_y(theta) * turn_z(psi)  # noqa: E741
Equation(O_matrix, O)

# %% [markdown]
# ## The matrix of (3.47)
#
# Its columns are $\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3$ in the space frame. The last one is the
# figure axis, with the polar angle $\theta$ and the azimuth $\phi$, as it should be. By the notes'
# own definition (3.34), $\mathbf{r} = O\mathbf{r}'$ takes body components to space components. The
# body's own $\mathbf{e}_3$ has $\mathbf{r}' = (0, 0, 1)$. Try both:

# %%
body_axis = Matrix([0, 0, 1])
(O * body_axis).T, (O.T * body_axis).T

# %% [markdown]
# The first is $\mathbf{e}_3$ in space. The second is something else: $\hat{\mathbf{z}}$ in the
# body. So the printed matrix is $O$, not $O^T$.

# %% [markdown] tags=["lecturer"]
# The verdict *convention* says: right in content, but at odds with the notes' own definitions. One
# set of angles is enough to see it:

# %% tags=["lecturer"]
verdict("3.47")

# %% [markdown]
# ## $\boldsymbol{\omega}$ from the matrix
#
# A point that is fixed in the body has $\mathbf{r} = O\mathbf{r}'$ with constant $\mathbf{r}'$, so
# $\dot{\mathbf{r}} = \dot O O^T\mathbf{r}$. But $\dot{\mathbf{r}} =
# \boldsymbol{\omega}\times\mathbf{r}$. Therefore $\dot O O^T$ is the matrix of
# "$\boldsymbol{\omega}\times$", and we can read $\boldsymbol{\omega}$ off it. $\dot O$ comes by the
# chain rule. The matrix has to be antisymmetric, so we add its transpose:

# %%
rate = O.diff(phi) * phidot + O.diff(theta) * thetadot + O.diff(psi) * psidot
cross = reduce_trig(rate * O.T)
cross + cross.T

# %%
in_space = Matrix([cross[2, 1], cross[0, 2], cross[1, 0]])
Equation(omega_vec, in_space)

# %% [markdown]
# The notes go another way: rotational velocities add up, so $\boldsymbol{\omega} =
# \dot\phi\,\hat{\mathbf{z}} + \dot\theta\,\mathbf{e}_2' + \dot\psi\,\mathbf{e}_3$ (3.41). The
# difference of the two ways:

# %%
primed = turn_z(phi) * turn_y(theta)  # its columns are e₁′, e₂′, e₃
added = phidot * Matrix([0, 0, 1]) + thetadot * primed[:, 1] + psidot * primed[:, 2]
reduce_trig(in_space - added).T

# %% [markdown]
# Along $\mathbf{e}_1', \mathbf{e}_2', \mathbf{e}_3$ it is short, and $\psi$ is gone. The first line
# is $\hat{\mathbf{z}}$ along these axes, the exercise of the notes; the second is (3.42):

# %%
vertical = primed.T * Matrix([0, 0, 1])
omega = reduce_trig(primed.T * in_space)
[Equation(zhat, vertical), Equation(omega_vec, omega)]

# %% [markdown]
# ## Kinetic energy, and $\dot\phi$
#
# For two equal moments these axes are principal axes too, whatever $\psi$ is. So $L_k =
# \lambda_k\omega_k$ along them (3.43), and $T = \tfrac12\boldsymbol{\omega}\cdot\mathbf{L}$ is
# (3.44):

# %%
L = diag(lambda1, lambda1, lambda3) * omega
kinetic = omega.dot(L) / 2
Equation(T, kinetic.expand().collect([lambda1, lambda3], lambda x: x.factor()))

# %% [markdown]
# Gravity has no torque about $\hat{\mathbf{z}}$ and none about $\mathbf{e}_3$, so $L_z$ and $L_3$
# will be the constants of the top. Take both from the $\mathbf{L}$ above, and solve for $\dot\phi$:

# %%
along_z = vertical[0] * L[0] + vertical[2] * L3
[solved] = solve(along_z - L_z, phidot)
[Equation(L_z, along_z), Equation(phidot, solved)]

# %% [markdown]
# That is (3.45). We divided by $\lambda_1\sin^2\theta$, and so lost the upright top: there $L_z =
# L_3$, and the right side is 0/0.

# %% [markdown] tags=["lecturer"]
# The verdict names the condition:

# %% tags=["lecturer"]
verdict("3.45")

# %% [markdown]
# A motion that comes close to the upright shows what this means. The axis passes $\hat{\mathbf{z}}$
# at a small distance, $\dot\phi$ has a high peak, and $\phi$ changes by nearly half a turn. But
# nothing happens to the body: $\dot\phi + \dot\psi$ stays finite. Make $\dot\phi$ at the start
# smaller and look.


# %%
def near_the_upright(left, right, phi_dot):
    top = rt.HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1)
    motion = top.motion(theta=0.4, theta_dot=-7.0, phi_dot=phi_dot, omega3=0.0)
    path = motion.exact(np.linspace(0.0, 0.16, 1201))
    left.plot(path.t, path.phi_dot, color=FIRST, label=r"$\dot\phi$")
    left.plot(path.t, path.phi_dot + path.psi_dot, color=SECOND, label=r"$\dot\phi+\dot\psi$")
    left.set_ylabel("rad/s")
    left.legend(loc="upper right")
    right.plot(path.t, np.degrees(path.phi), color=FIRST, label=r"$\phi$")
    right.plot(path.t, np.degrees(path.theta), color=GREY, label=r"$\theta$")
    right.set_ylabel("degrees")
    right.legend(loc="upper left")
    for axes in (left, right):
        axes.set_xlabel("$t$  (s)")


sliders(
    near_the_upright,
    "φ̇ has a narrow peak where θ is smallest, φ a step of nearly 180 degrees; φ̇ + ψ̇ stays small",
    columns=2,
    phi_dot=(0.2, 1.0, 5.0),
)

# %% [markdown]
# ## Rotations form a group
#
# $O^TO = 1$ and $\det O = 1$, so $O$ is in SO(3). Turns about different axes do not commute: a
# quarter turn about $\hat{\mathbf{x}}$ and one about $\hat{\mathbf{y}}$, in both orders, lead to
# different attitudes.

# %%
quarter_x, quarter_y = rotation_x(pi / 2), turn_y(pi / 2)
reduce_trig(O.T * O) - eye(3), quarter_x * quarter_y, quarter_y * quarter_x

# %% [markdown]
# ## Exercises
#
# ### Exercise 3.1
#
# $O^T$ undoes $O$. Which Euler angles has the rotation $O^T$? Check your answer with the matrices.
# Take $\phi = 30°$, $\theta = 40°$, $\psi = 50°$, and give three angles between 0 and 180° for
# $O^T$.
#
# <details><summary>First hint</summary>
#
# To undo three turns, undo the last one first.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# A negative $\theta$ is a positive one after half a turn: $R_y(-\theta) =
# R_z(\pi)R_y(\theta)R_z(-\pi)$.
#
# </details>


# %% tags=["solution"]
def euler(a, b, c):
    return turn_z(a) * turn_y(b) * turn_z(c)


euler(-psi, -theta, -phi) - O.T

# %% [markdown] tags=["solution"]
# The three turns are undone in the opposite order: $(-\psi, -\theta, -\phi)$. If $\theta$ is to lie
# between 0 and $\pi$, take $(\pi-\psi, \theta, -\pi-\phi)$, which is the same rotation.

# %% tags=["check"]
# %%answer exercise-3.1 --hint tries
# phi = 130°
# theta = 40°
# psi = 150°

# %% [markdown]
# ### Exercise 3.2
#
# Different angles may give the same attitude. Show that for $\theta = 0$ only $\phi + \psi$
# matters. Which combination matters for $\theta = \pi$? At $\theta = 180°$, which $\psi$ goes with
# $\phi = 80°$, if the attitude is that of $\phi = 70°$ and $\psi = 20°$?
#
# <details><summary>First hint</summary>
#
# For $\theta = 0$ the middle matrix is the unit matrix.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# For $\theta = \pi$ it turns the third axis round: $R_y(\pi)R_z(\psi) = R_z(-\psi)R_y(\pi)$.
#
# </details>

# %% tags=["solution"]
(
    (euler(phi, 0, psi) - euler(phi + psi, 0, 0)).applyfunc(simplify),
    (euler(phi, pi, psi) - euler(phi - psi, pi, 0)).applyfunc(simplify),
)

# %% [markdown] tags=["solution"]
# For $\theta = \pi$ it is $\phi - \psi$. At the poles one of the three numbers is lost, and
# $\dot\phi$ and $\dot\psi$ can't be told from $\boldsymbol{\omega}$. This is why `rigidtop`
# integrates with unit quaternions.

# %% tags=["check"]
# %%answer exercise-3.2 --hint tries
# psi = 30°

# %% [markdown]
# ### Exercise 3.3
#
# Find $\boldsymbol{\omega}$ along $\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3$ (not the primed axes).
# Start from $O^T\dot O$. Why is $\omega_1^2 + \omega_2^2$ the same along both pairs of axes? As a
# check, put in $\theta = 60°$, $\psi = 30°$ and the rates $\dot\phi = 2$, $\dot\theta = 1$,
# $\dot\psi = 3$ rad/s.
#
# <details><summary>First hint</summary>
#
# $O^T\dot O$ is the matrix of "$\boldsymbol{\omega}\times$" in components along the body axes.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# The primed components turn by $-\psi$ about $\mathbf{e}_3$: $\omega_1 = \omega_1'\cos\psi +
# \omega_2'\sin\psi$.
#
# </details>

# %% tags=["solution"]
cross_in_body = reduce_trig(O.T * rate)
in_body = Matrix([cross_in_body[2, 1], cross_in_body[0, 2], cross_in_body[1, 0]])
across = reduce_trig(in_body[0] ** 2 + in_body[1] ** 2, keep="sin")
Equation(omega_vec, in_body), across - reduce_trig(omega[0] ** 2 + omega[1] ** 2, keep="sin")

# %% [markdown] tags=["solution"]
# The last turn, by $\psi$ about $\mathbf{e}_3$, mixes the first two components and leaves their
# length. Only for $\lambda_1 = \lambda_2$ does $T$ not see it.

# %% tags=["check"]
# %%answer exercise-3.3 --hint tries
# omega1 = -1.00 rad/s
# omega2 = 1.732 rad/s
# omega3 = 4.00 rad/s

# %% [markdown]
# ### Exercise 3.4
#
# A top has $\lambda_1 = 0.02$ and $\lambda_3 = 0.01$ kg m² and starts at $\theta = 60°$ with
# $\dot\phi = 2$ and $\omega_3 = 40$ rad/s. Find $L_z$ and $L_3$. Then find $\dot\phi$ at a later
# time from its $\theta$ alone, by (3.45), and compare with the motion. Give $\dot\phi$ after 0.1 s,
# with $M = 1$ kg and $R = 0.1$ m.
#
# <details><summary>First hint</summary>
#
# $L_3 = \lambda_3\omega_3$, and $L_z = \lambda_1\dot\phi\sin^2\theta + L_3\cos\theta$.
#
# </details>
#
# <details><summary>Second hint</summary>
#
# `motion.exact([0.1]).theta` gives the angle; both momenta are what they were at the start.
#
# </details>

# %% tags=["solution"]
top = rt.HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1)
path = top.motion(theta=np.pi / 3, phi_dot=2.0, omega3=40.0).exact([0.0, 0.1, 0.2, 0.3])
start_3 = 0.01 * 40.0
start_z = 0.02 * 2.0 * np.sin(np.pi / 3) ** 2 + start_3 * np.cos(np.pi / 3)
print(f"L_z = {start_z:.4f} J s, L₃ = {start_3:.4f} J s")
for moment, tilt, seen in zip(path.t, path.theta, path.phi_dot, strict=True):
    by_formula = (start_z - start_3 * np.cos(tilt)) / (0.02 * np.sin(tilt) ** 2)
    print(f"t = {moment:.1f} s: φ̇ by (3.45) {by_formula:.6f}, in the motion {seen:.6f} rad/s")

# %% tags=["check"]
# %%answer exercise-3.4 --hint tries
# L_z = 0.230 J s
# L_3 = 0.400 J s
# phi_dot = 2.737 rad/s
