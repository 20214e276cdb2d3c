"""Whipple's bicycle: its rates against published ones, its motion against its rates.

Meijaard, Papadopoulos, Ruina and Schwab, Proc. R. Soc. A 463 (2007) 1955: table 1 and equations
(5.3) to (5.6).  Axes as there: x ahead, y to the right, z down.
"""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import solve
from sympy import Matrix, Rational, cos, pi, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

NAMES = "w c lambda g r_R m_R x_B z_B m_B x_H z_H m_H r_F m_F I_Rxx I_Ryy I_Fxx I_Fyy"
NUMBERS = "1.02 0.08 0 9.81 0.3 2 0.3 -0.9 85 0.9 -0.7 4 0.35 3 0.0603 0.12 0.1405 0.28"
letters = symbols(NAMES)
w, c, tilt, g, r_R, m_R, x_B, z_B, m_B, x_H, z_H, m_H, r_F, m_F, *wheels = letters
I_B, I_H = (symbols(f"I_{body}xx I_{body}yy I_{body}zz I_{body}xz") for body in "BH")
PARAMETERS = {
    **dict(zip(letters, map(Rational, NUMBERS.split()), strict=True)),
    tilt: pi / 10,
    **dict(zip(I_B, map(Rational, ("9.2", "11", "2.8", "2.4")), strict=True)),
    **dict(zip(I_H, map(Rational, ("0.05892", "0.06", "0.00708", "-0.00756")), strict=True)),
}
COORDINATES = dynamicsymbols("x y psi phi theta delta theta_R theta_F")
x, y, psi, phi, theta, delta, theta_R, theta_F = COORDINATES


def about_x(angle):
    return Matrix([[1, 0, 0], [0, cos(angle), -sin(angle)], [0, sin(angle), cos(angle)]])


def about_y(angle):
    return Matrix([[cos(angle), 0, sin(angle)], [0, 1, 0], [-sin(angle), 0, cos(angle)]])


def about_z(angle):
    return Matrix([[cos(angle), -sin(angle), 0], [sin(angle), cos(angle), 0], [0, 0, 1]])


def tensor(xx, yy, zz, xz):
    return Matrix([[xx, 0, xz], [0, yy, 0], [xz, 0, zz]])


def bicycle() -> rt.System:
    """Two wheels that roll, a frame with its rider, a fork: 8 coordinates, 5 constraints."""
    down, t = Matrix([0, 0, 1]), x.args[0]
    leaning = about_z(psi) * about_x(phi)
    frame = leaning * about_y(theta)
    fork = frame * about_y(tilt) * about_z(delta) * about_y(tilt).T
    rear = Matrix([x, y, 0]) - r_R * leaning[:, 2]
    steering = rear + frame * Matrix([w + c, 0, r_R])
    front = steering + fork * Matrix([-c, 0, -r_F])
    axle = fork[:, 1]
    to_ground = r_F * (down - axle[2] * axle) / sqrt(1 - axle[2] ** 2)
    turning = psi.diff() * down + phi.diff() * leaning[:, 0]
    of_rear = turning + theta_R.diff() * leaning[:, 1]
    steered = delta.diff() * frame * about_y(tilt)[:, 2] + theta_F.diff() * axle
    of_front = turning + theta.diff() * leaning[:, 1] + steered
    rolls = rear.diff(t) + of_rear.cross(r_R * leaning[:, 2])
    follows = front.diff(t) + of_front.cross(to_ground)
    R_xx, R_yy, F_xx, F_yy = wheels
    rider = rear + frame * Matrix([x_B, 0, z_B + r_R])
    handlebar = steering + fork * Matrix([x_H - w - c, 0, z_H])
    parts = [
        rt.Body(m_R, [R_xx, R_yy, R_xx], rear, leaning * about_y(theta_R)),
        rt.Body(m_B, tensor(*I_B), rider, frame),
        rt.Body(m_H, tensor(*I_H), handlebar, fork),
        rt.Body(m_F, [F_xx, F_yy, F_xx], front, fork * about_y(theta_F)),
    ]
    rules = [*rolls[:2], *follows[:2], (front + to_ground)[2]]
    return rt.System.of_parts(parts, COORDINATES, gravity=[0, 0, g], constraints=rules)


def upright(speed) -> dict:
    """Straight on at a speed (m/s)."""
    still = dict.fromkeys((y, psi, phi, theta, delta), 0)
    turns = {theta_R.diff(): -speed / PARAMETERS[r_R], theta_F.diff(): -speed / PARAMETERS[r_F]}
    return {**still, x.diff(): speed, **turns, **PARAMETERS}


def published(speed: float) -> NDArray[np.complex128]:
    """The four rates (1/s) of lean and steer by the published M, C₁, K₀ and K₂."""
    M = np.array([[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]])
    C = np.array([[0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]])
    K_0 = np.array([[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]])
    K_2 = np.array([[0, 76.59734589573222], [0, 2.65431523794604]])
    sides = np.hstack([-solve(M, 9.81 * K_0 + speed**2 * K_2), -solve(M, speed * C)])
    return np.linalg.eigvals(np.vstack([np.eye(2, 4, 2), sides]))


@pytest.fixture(scope="module")
def whipple():
    return bicycle()


def rates(system, speed):
    """Those that are not zero, of ten."""
    A, _ = system.linearise(at=upright(speed))
    found = np.linalg.eigvals(np.array(A.evalf(30).tolist(), dtype=float))
    return sorted(found[np.abs(found) > 1e-6], key=lambda s: (s.real, s.imag))


def test_its_rates_are_those_that_are_published(whipple):
    """It falls at 1 m/s; weave, capsize and castering at 5 m/s are those printed in table 2."""
    slow, fast = (rates(whipple, Rational(speed)) for speed in (1, 5))
    for found, speed in ((slow, 1.0), (fast, 5.0)):
        wanted = sorted(published(speed), key=lambda s: (s.real, s.imag))
        assert found == pytest.approx(wanted, rel=1e-11)
    weave = complex(-0.775341882195846, 4.464867713788229)
    printed = [-14.078389692798216, weave.conjugate(), weave, -0.322866429004087]
    assert fast == pytest.approx(printed, rel=1e-11)
    assert max(s.real for s in slow) > 3


def test_a_push_dies_away_as_the_rates_say(whipple):
    """With all that is not linear: a rate of lean of 0.01/s from straight on, at 5 m/s."""
    speed = 5.0
    start = {
        x.diff(): speed,
        theta_R.diff(): -speed / 0.3,
        theta_F.diff(): -speed / 0.35,
        phi.diff(): 0.01,
    }
    motion = whipple.motion(PARAMETERS, q=dict.fromkeys(whipple.q, 0), qdot=start)
    run = motion.integrate(np.linspace(0, 10, 101))
    lean, steer = (np.abs(run.q[:, list(whipple.q).index(each)]) for each in (phi, delta))
    assert 1e-4 < np.max(lean) < 0.01
    assert lean[-1] < np.exp(-0.2 * 10) * np.max(lean)
    assert steer[-1] < np.exp(-0.2 * 10) * np.max(steer)
    assert np.max(np.abs(run.drift()["energy"])) < 1e-9
