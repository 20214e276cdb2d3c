"""A and B near steady motions: against known answers, and against what the motions do."""

import numpy as np
import pytest
import sympy
from scipy.linalg import solve_continuous_are
from sympy import Matrix, cos, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt
from rigidtop.theory.rotation import euler_matrix

m, M, g, length, k = symbols("m M g length k", positive=True)
x, y, u, v, theta, w, F, N = symbols("x y u v theta w F N", real=True)
CART = rt.System(
    (M + m) * u**2 / 2 + m * length * u * w * cos(theta) + m * length**2 * w**2 / 2
    - m * g * length * cos(theta),
    [x, theta],
    [u, w],
    forces={x: F},
)  # fmt: skip

PARALLEL = rt.System(m * (u**2 + v**2) / 2, [x, y], [u, v], constraints=x - y)


def test_a_cart_with_a_pole():
    A, B = CART.linearise(at={x: 0, theta: 0}, inputs=[F])
    assert (
        Matrix(
            [
                [0, 0, 1, 0],
                [0, 0, 0, 1],
                [0, -g * m / M, 0, 0],
                [0, g * (M + m) / (M * length), 0, 0],
            ]
        )
        == A
    )
    assert Matrix([0, 0, 1 / M, -1 / (M * length)]) == B


def test_a_regulator_holds_the_pole():
    """By the Riccati equation; the closed motion, with all that is not linear, comes to rest."""
    A, B = (
        np.array(side.subs({M: 1, m: 0.1, length: 0.5, g: 9.81}), dtype=float)
        for side in CART.linearise(at={theta: 0}, inputs=[F])
    )
    K = B.T @ solve_continuous_are(A, B, np.eye(4), np.eye(1))
    force = -sum(a * q for a, q in zip(K[0], (x, theta, u, w), strict=True))
    held = rt.System(CART.L, [x, theta], [u, w], forces={x: force})
    run = held.motion({M: 1, m: 0.1, length: 0.5, g: 9.81}, [0.2, 0.3]).integrate([0, 20])
    assert np.max(np.abs(run.q[-1])) < 1e-5
    with pytest.raises(rt.RigidtopError, match="a force of"):
        CART.linearise(at={theta: 0})  # with F in it, which is no input then


def test_an_input_with_a_value_and_numbers_for_parameters():
    lifted = rt.System(m * u**2 / 2 - m * g * x, x, u, forces=[F])
    A, B = lifted.linearise(at={F: m * g}, inputs=F)
    assert (Matrix([[0, 1], [0, 0]]), Matrix([0, 1 / m])) == (A, B)
    _, B = lifted.linearise(at={"F": 20, "m": 2, "g": 10}, inputs="F")
    assert Matrix([0, sympy.Rational(1, 2)]) == B
    t = symbols("t")
    pulled = sympy.Function("f")(t)
    A, B = rt.System(m * u**2 / 2 + pulled * x, x, u).linearise({}, [pulled])
    assert Matrix([0, 1 / m]) == B


def test_what_is_driven_by_a_parameter_of_L():
    _, B = rt.System(m * u**2 / 2 - k * (x - N) ** 2 / 2, x, u).linearise({x: 0}, [N])
    assert Matrix([0, k / m]) == B


def test_without_inputs_b_has_no_columns():
    A, B = rt.System(m * u**2 / 2 - k * x**2 / 2, x, u).linearise(at={x: 0})
    assert Matrix([[0, 1], [-k / m, 0]]) == A
    assert B.shape == (2, 0)


def test_the_steady_precession_of_a_heavy_top():
    l1, l3, Omega, alpha = symbols("lambda1 lambda3 Omega alpha", positive=True)
    angles = dynamicsymbols("phi theta psi")
    theta = angles[1]
    rates = [angle.diff() for angle in angles]
    top = rt.System(
        l1 * (rates[1] ** 2 + sin(theta) ** 2 * rates[0] ** 2) / 2
        + l3 * (rates[2] + cos(theta) * rates[0]) ** 2 / 2
        - m * g * length * cos(theta),
        angles,
    )
    spin = (m * g * length + l1 * Omega**2 * cos(alpha)) / (l3 * Omega) - Omega * cos(alpha)
    about = {theta: alpha, rates[0]: Omega, rates[2]: spin}
    A, _ = top.linearise(at=about)
    values = {l1: 2, l3: 1, m: 1, g: 9.81, length: 0.5, Omega: 1.5, alpha: 0.8}
    found = np.linalg.eigvals(np.array(A.subs(values), dtype=float))
    [known] = top.small(about).frequencies({str(a): b for a, b in values.items()})
    assert np.sort(np.abs(found))[-2:] == pytest.approx([known, known])
    assert np.max(np.abs(found.real)) < 1e-6
    with pytest.raises(rt.RigidtopError, match="no steady motion: a force of"):
        top.linearise(at={theta: alpha, rates[0]: Omega})


def test_a_pendulum_by_constraint_is_one_by_its_angle():
    bob = rt.System(
        m * (u**2 + v**2) / 2 - m * g * y,
        [x, y],
        [u, v],
        forces=[F, 0],
        constraints=x**2 + y**2 - length**2,
    )
    A, B = bob.linearise(at={x: 0, y: -length}, inputs=[F])
    assert Matrix([[0, 1], [-g / length, 0]]) == A
    assert Matrix([0, 1 / m]) == B


def test_a_place_in_decimals_is_one():
    """sin of π in floats is 10⁻¹⁶, and so is what a constraint has left."""
    A, _ = CART.linearise(at={theta: float(np.pi)}, inputs=[F])
    assert A[3, 1].subs({M: 1, m: 1, length: 1, g: 1}) == pytest.approx(-2)
    slope, rod = 0.3, 2.0
    bob = rt.System(
        m * (u**2 + v**2) / 2 - m * g * y,
        [x, y],
        [u, v],
        forces=[F, 0],
        constraints=x**2 + y**2 - length**2,
    )
    place = {x: rod * np.sin(slope), y: -rod * np.cos(slope), length: rod}
    A, _ = bob.linearise({**place, F: 3 * 9.81 * np.tan(slope), m: 3, g: 9.81}, [F])
    assert A[1, 0] == pytest.approx(-9.81 / rod / np.cos(slope))
    with pytest.raises(rt.RigidtopError, match="no steady motion"):
        bob.linearise({**place, F: 3 * 9.81 * np.tan(slope) + 1e-9, m: 3, g: 9.81}, [F])
    with pytest.raises(rt.RigidtopError, match="does not hold there"):
        bob.linearise({**place, length: 2.000001}, [F])


def rolling_disc():
    """A thin disc of radius `length` on a table: x, y of its centre, e₃ its axle."""
    x, y, phi, theta, psi = q = dynamicsymbols("x y phi theta psi")
    R, height = euler_matrix(phi, theta, psi), length * sin(theta)
    body = rt.Body(m, [m * length**2 / 4, m * length**2 / 4, m * length**2 / 2], [x, y, height], R)
    rates = [each.diff() for each in q]
    omega = Matrix(
        [
            -sin(phi) * rates[3] + cos(phi) * sin(theta) * rates[4],
            cos(phi) * rates[3] + sin(phi) * sin(theta) * rates[4],
            rates[2] + cos(theta) * rates[4],
        ]
    )
    down = length * Matrix([cos(theta) * cos(phi), cos(theta) * sin(phi), -sin(theta)])
    slip = Matrix([rates[0], rates[1], 0]) + omega.cross(down)
    return rt.System.of_parts(body, q, gravity=[0, 0, -g], constraints=[slip[0], slip[1]])


def test_a_disc_that_rolls_upright():
    """Stable from ψ̇² > g/(3r): s² = 4(g/r − 3ψ̇²)/5 for a thin one."""
    disc = rolling_disc()
    _, y, phi, theta, psi = disc.q
    W, s = symbols("W s")
    about = {phi: 0, theta: pi / 2, psi.diff(): W, y.diff(): -W * length}
    A, B = disc.linearise(at=about)
    assert A.shape == (8, 8)  # five coordinates, three speeds
    assert B.shape == (8, 0)
    known = s**6 * (s**2 - sympy.Rational(4, 5) * (g / length - 3 * W**2))
    assert sympy.simplify(A.charpoly(s).as_expr() - known) == 0
    with pytest.raises(rt.RigidtopError, match="a force of"):
        disc.linearise(at={phi: 0, theta: 1})
    with pytest.raises(rt.RigidtopError, match="does not hold there"):
        disc.linearise(at={phi: 0, theta: pi / 2, psi.diff(): W})


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        (lambda: CART.linearise({theta: 1}, [F]), "no steady motion: a force of"),
        (lambda: CART.linearise({}, [F]), "gives no value for theta"),
        (lambda: PARALLEL.linearise({u: 1}), "the constraint x - y = 0 does not hold there"),
        (lambda: CART.linearise({theta: 0, w: 1}, [F]), "theta changes, and the equations"),
        (lambda: CART.linearise({theta: 0}, [k]), "the input k is in no force"),
        (lambda: CART.linearise({theta: 0}, [x]), "a letter of a force or of L, not x"),
        (lambda: CART.linearise({theta: 0}, [2 * F]), r"a letter of a force or of L, not 2\*F"),
        (lambda: CART.linearise({k: 0}, [F]), "k is none of the coordinates"),
        (lambda: CART.linearise(3), "given as {coordinate: value}"),
        (lambda: CART.linearise({theta: 0}, 3), "inputs are letters"),
        (
            lambda: rt.System(u**2 * x / 2, x, u).linearise({x: 0}),
            "the mass matrix is singular there",
        ),
        (
            lambda: rt.System(u**2 / 2 + 1 / x, x, u).linearise({x: 0}),
            "the equations are singular there",
        ),
    ],
)
def test_what_is_not_linear_is_said_in_one_line(asked, said):
    with pytest.raises(rt.RigidtopError, match=said) as caught:
        asked()
    assert "\n" not in str(caught.value)
