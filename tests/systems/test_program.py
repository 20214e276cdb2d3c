"""The programs of systems, by a graph: against other ways, and how long they are."""

import shutil
import subprocess
from functools import cache

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt
from rigidtop.codegen.graph import Direction, Graph
from rigidtop.codegen.lines import straight_line
from rigidtop.codegen.nodes import ONE
from rigidtop.codegen.points import points
from rigidtop.codegen.solve import SingularError, solved
from rigidtop.theory import top
from rigidtop.theory.rotation import euler_matrix

m, length, g = symbols("m length g", positive=True)
x, y, z = symbols("x y z", real=True)
u, v, w = symbols("u v w", real=True)


@cache
def chain(n):
    """n masses, each on a rod from the one before."""
    angles = dynamicsymbols(f"theta1:{n + 1}")
    across = down = sympy.S.Zero
    parts = []
    for angle in angles:
        across, down = across + length * sin(angle), down - length * cos(angle)
        parts.append(rt.Mass(m, [across, down]))
    return rt.System.of_parts(parts, angles, gravity=[0, -g])


def arm(n):
    """n bodies in a row, hinged about axes that are perpendicular in turn."""
    angles = dynamicsymbols(f"q1:{n + 1}")
    turn, place, parts = sympy.eye(3), sympy.zeros(3, 1), []
    moments = symbols("A B C", positive=True)
    for k, angle in enumerate(angles):
        turn = turn * (sympy.rot_axis1, sympy.rot_axis2)[k % 2](angle).T
        parts.append(rt.Body(m, moments, place - turn[:, 2] * length / 2, turn))
        place = place - length * turn[:, 2]
    return rt.System.of_parts(parts, angles, gravity=[0, 0, -g])


def by_lagrange(system, row):
    """q̈ from M and f as SymPy has them, at a point."""
    at = dict(zip(system.numeric.arguments, row, strict=True))
    mass, force = system._balance
    numbers = [sympy.N(entry.xreplace(at), 30) for entry in (*mass, *force)]
    n = len(force)
    return np.array(
        sympy.Matrix(n, n, numbers[: n * n]).LUsolve(sympy.Matrix(numbers[n * n :])), dtype=float
    ).ravel()


def row(system):
    rng = np.random.default_rng(1)
    return [float(a) for a in rng.uniform(0.4, 1.4, len(system.numeric.arguments))]


@pytest.mark.parametrize("system", [chain(4), arm(3)], ids=["chain", "arm"])
def test_parts_give_what_lagrange_gives(system):
    at = row(system)
    wanted = by_lagrange(system, at)
    found = np.array(system.numeric.solved.scalar(*at))
    assert np.max(np.abs(found - wanted)) <= 1e-13 * np.max(np.abs(wanted))


def test_a_long_chain_is_what_its_formula_says():
    """M is ml²(n − max(i, j)) cos(θᵢ − θⱼ), and f has the sines with the squares of the rates."""
    n, system = 12, chain(12)
    at = np.array(row(system))
    theta, rates, values = at[1 : n + 1], at[n + 1 : 2 * n + 1], at[2 * n + 1 :]
    gravity, rod, mass = values
    behind = n - np.maximum.outer(np.arange(n), np.arange(n))
    apart = np.subtract.outer(theta, theta)
    M = mass * rod**2 * behind * np.cos(apart)
    f = -mass * rod**2 * (behind * np.sin(apart)) @ rates**2
    f -= mass * gravity * rod * np.diag(behind) * np.sin(theta)
    wanted = np.linalg.solve(M, f)
    found = np.array(system.numeric.solved.scalar(*at))
    assert np.max(np.abs(found - wanted)) <= 1e-12 * np.max(np.abs(wanted))


@pytest.mark.parametrize(
    ("system", "most"),
    [(chain(2), 38), (chain(5), 260), (chain(12), 1450), (arm(6), 3500)],
    ids=["2", "5", "12", "arm"],
)
def test_programs_are_short(system, most):
    """The most of small ones are the operations of normal forms alone."""
    assert system.program.operations <= most


def test_the_heavy_top_is_short():
    angles = dynamicsymbols("theta phi psi")
    own = zip((*top.ANGLES, *top.RATES), (*angles, *(a.diff() for a in angles)), strict=True)
    system = rt.System(top.lagrangian().xreplace(dict(own)), angles)
    assert system.program.operations <= 103


def test_a_lagrangian_alone_gives_as_short_a_program_as_its_parts():
    by_parts = chain(12)
    bobs = [rt.Mass(m, part.place) for part in by_parts.parts]
    T = sum(m * bob.place.diff(dynamicsymbols._t).dot(bob.place.diff(dynamicsymbols._t)) / 2
            for bob in bobs)  # fmt: skip
    V = sum(m * g * bob.place[1] for bob in bobs)
    system = rt.System.of_energies(T, V, by_parts.q)
    assert system.program.operations <= by_parts.program.operations
    at = row(system)
    assert system.numeric.solved.scalar(*at) == pytest.approx(by_parts.numeric.solved.scalar(*at))


TERMS = [x, y, x * y, sin(x), cos(y), sin(x + y), cos(x) * sin(y), x**2, sympy.exp(y / 3), z * x]


@settings(max_examples=10, deadline=None)
@given(
    st.lists(st.tuples(st.integers(0, 9), st.integers(-3, 3)), min_size=3, max_size=3),
    st.lists(st.tuples(st.integers(0, 9), st.integers(-3, 3)), min_size=1, max_size=3),
    st.integers(0, 2),
)
def test_any_small_lagrangian(moved, potential, force):
    """Squares of rates that depend on places, on which more than one way agrees."""
    rates = (u, v, w)
    T = (u**2 + v**2 + w**2) * m
    for (k, c), rate in zip(moved, rates, strict=True):
        T += (rate + c * TERMS[k] * rates[(k + 1) % 3]) ** 2 / 2
    V = sum(c * TERMS[k] for k, c in potential)
    Q = [0, 0, 0]
    Q[force] = -v * sin(x)
    system = rt.System(T - V, [x, y, z], rates, forces=Q)
    at = row(system)
    wanted = by_lagrange(system, at)
    size = max(1.0, np.max(np.abs(wanted)))
    assert system.numeric.solved.scalar(*at) == pytest.approx(wanted, abs=1e-11 * size)


def test_equal_nodes_are_one():
    graph = Graph(next(points([x, y])))
    one = graph.expression(sin(x) ** 2 + cos(x) ** 2)
    assert one == ONE
    assert graph.expression(sin(x + y)) == graph.expression(sin(x) * cos(y) + cos(x) * sin(y))
    assert graph.expression(sympy.Abs(x)) != graph.expression(x)  # equal at the point alone
    assert graph.expression(sympy.sqrt(x**2 + y)) != graph.expression(x)


@pytest.mark.parametrize(
    "value",
    [x**3 / y, sin(x * y) ** 2, sympy.atan2(x, y), x**y, sympy.sqrt(x), sympy.Max(x, y) ** 2],
)
def test_derivatives_are_those_of_sympy(value):
    graph = Graph(next(points([x, y])))
    slope = graph.derivative(graph.expression(value), Direction({x: ONE}))
    made = straight_line(graph, [slope], sympy.numbered_symbols("t")).written_out()[0]
    at = {x: sympy.Float("1.3", 30), y: sympy.Float("0.7", 30)}
    assert abs(sympy.N((made - value.diff(x)).xreplace(at), 30)) < 1e-20


def test_a_matrix_that_hides_that_it_is_singular():
    hidden = sympy.Matrix([[sin(x) ** 2, 1 - cos(x) ** 2], [1, 1]])
    with pytest.raises(SingularError):
        solved(hidden, [x, y], sympy.numbered_symbols("t"))


def test_a_long_program_in_c_computes_the_same(tmp_path):
    if shutil.which("cc") is None:
        pytest.skip("no cc")
    system = chain(8)
    at = row(system)
    given = ", ".join(map(repr, at[1:]))  # without the time
    (tmp_path / "it.c").write_text(
        system.source("c")
        + "#include <stdio.h>\nint main(void) { double out[8]; "
        + f"accelerations({given}, out);\n"
        + 'for (int k = 0; k < 8; k++) printf("%.17g\\n", out[k]); return 0; }\n'
    )
    subprocess.run(["cc", "it.c", "-o", "it", "-lm"], cwd=tmp_path, check=True)
    told = subprocess.run(["./it"], cwd=tmp_path, check=True, capture_output=True, text=True)
    found = [float(a) for a in told.stdout.split()]
    assert found == pytest.approx(system.numeric.solved.scalar(*at), rel=1e-11)


def test_a_tensor_that_is_tilted_in_the_body_is_that_of_turned_principal_axes():
    """A body by its tensor, and the same one by its principal moments and the axes they have."""
    angles = dynamicsymbols("phi theta psi")
    attitude = euler_matrix(*angles)
    three, four = Rational(3, 5), Rational(4, 5)
    about_z = Matrix([[three, -four, 0], [four, three, 0], [0, 0, 1]])
    tilt = about_z * Matrix([[four, 0, three], [0, 1, 0], [-three, 0, four]])
    principal = Matrix.diag(2, 3, 4)
    place = attitude[:, 2] / 3
    by_tensor, by_moments = (
        rt.System.of_parts(rt.Body(2, inertia, place, R), angles, gravity=[0, 0, -9.81])
        for inertia, R in (
            (tilt * principal * tilt.T, attitude),
            ((2, 3, 4), attitude * tilt),
        )
    )
    at = [0.0, 0.3, 0.7, -0.4, 0.5, 1.1, -0.8]
    one, other = (system.numeric.solved.scalar(*at) for system in (by_tensor, by_moments))
    assert one == pytest.approx(other, rel=1e-12)
    assert by_tensor.certify({})["Newton–Euler"] < 1e-12


def test_a_result_that_is_a_term_of_another_stays_what_it_is():
    """Its number went into the first where that was a product used in one sum alone."""
    a, f, h = symbols("a f h")
    matrix = Matrix([[a, -Rational(1, 5)], [-Rational(1, 5), 1]])
    found = solved(matrix, [f, h], sympy.numbered_symbols("t")).written_out()
    wanted = matrix.LUsolve(Matrix([f, h]))
    assert [sympy.simplify(x - y) for x, y in zip(found, wanted, strict=True)] == [0, 0]


def test_decimals_and_fractions_go_together():
    """Python's fractions know nothing of SymPy's decimals."""
    mixed = rt.System(u**2 / 3 + 0.25 * u**2 * x**2 + Rational(2, 9) * x**2, [x], [u])
    [force] = mixed.numeric.solved.scalar(0.0, 2.0, 1.0)
    assert force == pytest.approx((4 / 9 * 2 - 0.5 * 2) / (2 / 3 + 0.5 * 4), rel=1e-15)


def test_a_motion_waits_for_no_lagrangian():
    """Energy, momenta and drift are known without it, with forces and constraints too."""
    t = dynamicsymbols._t
    b, parts, q = dynamicsymbols("b"), chain(8).parts, chain(8).q
    turning = rt.Body(1, [1, 2, 3], [0, 0, 0], sympy.rot_axis3(b))
    free = rt.System.of_parts([*parts, turning], [*q, b], gravity=[0, -g])
    pushed = rt.System.of_parts(
        parts, q, gravity=[0, -g], forces={q[0]: sin(t)}, constraints=q[0] - q[1] / 2 - t / 5
    )
    numbers, kept = {m: 2, length: 0.5, g: 9.81}, []
    for system in (free, pushed):
        rates = np.linspace(0.2, 0.0, len(system.q))
        start = np.linspace(1.0, 2.0, len(system.q))
        rates[:2], start[:2] = (0.0, -0.4), (0.5, 1.0)
        run = system.motion(numbers, start, rates).integrate([0.0, 0.2, 0.4])
        kept.append([*run.drift()])
        assert max(run.drift().values()) < 1e-9
        assert "L" not in vars(system)
        assert run.energy == pytest.approx(run.value(system.energy))
        assert run.momenta[:, 1] == pytest.approx(run.value(system.momenta[1]))
    assert kept == [["energy", "p_b"], ["energy balance", "constraint 1"]]


def test_what_is_not_analytic_is_asked_of_sympy():
    """Of a root the graph doesn't know that its square is what it is the root of."""
    root = sympy.sqrt(x**2 + 1)
    none = (root + 1) * (root - 1) - x**2
    system = rt.System((u**2 + v**2) / 2 + none + y**2 * root, [x, y], [u, v])
    assert system.cyclic == ()
    system = rt.System((u**2 + v**2) / 2 + none + y**2, [x, y], [u, v])
    assert system.cyclic == (x,)
    assert system.is_conservative
