"""Inertia tensors against tables, and against quadrature."""

import numpy as np
import pytest
import sympy
from sympy import Matrix, Rational, diag, eye, pi, sqrt, symbols

from rigidtop.theory.inertia import (
    cone,
    cuboid,
    cylinder,
    ellipsoid,
    hemisphere,
    parallel_axis,
    point_masses,
    principal_axes,
    sphere,
    torus,
)

M, a, b, c, r, h = symbols("M a b c r h", positive=True)

TABLE = [
    # Goldstein, Poole, Safko, Classical Mechanics; Landau and Lifshitz, Mechanics §32, problem 2.
    ("sphere", sphere(r), pi * 4 / 3 * r**3, diag(*[Rational(2, 5) * r**2] * 3)),
    (
        "ellipsoid",
        ellipsoid(a, b, c),
        pi * 4 / 3 * a * b * c,
        diag(b**2 + c**2, c**2 + a**2, a**2 + b**2) / 5,
    ),
    (
        "cylinder",
        cylinder(r, h),
        pi * r**2 * h,
        diag(*[(r**2 + h**2 / 3) / 4] * 2, r**2 / 2),
    ),
    ("cuboid", cuboid(a, b, c), a * b * c, diag(b**2 + c**2, c**2 + a**2, a**2 + b**2) / 12),
    # About the apex, §32 problem 2e: I₃ = 3MR²/10 and I₁ = 3M(R²/4 + h²)/5.
    (
        "cone",
        cone(r, h),
        pi * r**2 * h / 3,
        diag(*[Rational(3, 5) * (r**2 / 4 + h**2)] * 2, Rational(3, 10) * r**2),
    ),
    # About the centre of the ball: half of a ball of twice the mass.
    ("hemisphere", hemisphere(r), pi * 2 / 3 * r**3, diag(*[Rational(2, 5) * r**2] * 3)),
    # Weisstein, Eric W., "Moment of Inertia: Ring torus": (3/4)a² + c² and (5/8)a² + c²/2.
    (
        "torus",
        torus(a + b, b),
        2 * pi**2 * (a + b) * b**2,
        diag(
            *[Rational(5, 8) * b**2 + (a + b) ** 2 / 2] * 2,
            Rational(3, 4) * b**2 + (a + b) ** 2,
        ),
    ),
]


@pytest.mark.parametrize(
    ("solid", "volume", "table"), [row[1:] for row in TABLE], ids=[row[0] for row in TABLE]
)
def test_table(solid, volume, table):
    assert sympy.expand(solid.volume() - volume) == 0
    assert (solid.inertia(M) - M * table).expand() == sympy.zeros(3)


def test_centres_of_mass():
    assert cone(r, h).centre() == Matrix([0, 0, Rational(3, 4) * h])
    assert hemisphere(r).centre() == Matrix([0, 0, Rational(3, 8) * r])
    assert torus(a + b, b).centre() == sympy.zeros(3, 1)
    assert cuboid(a, b, c).centre() == sympy.zeros(3, 1)


def test_a_cone_by_quadrature():
    # Discs of Gauss-Legendre heights: exact for the polynomials there are.
    radius, height, mass = 0.7, 1.9, 2.3
    nodes, weights = np.polynomial.legendre.leggauss(6)
    z, dz = (nodes + 1) * height / 2, weights * height / 2
    disc = radius * z / height
    density = mass / (np.pi * radius**2 * height / 3)
    dm = density * np.pi * disc**2 * dz
    across, along = np.sum(dm * (disc**2 / 4 + z**2)), np.sum(dm * disc**2 / 2)
    ours = cone(r, h).inertia(M).subs({r: radius, h: height, M: mass})
    assert np.array(ours, dtype=float) == pytest.approx(np.diag([across, across, along]), rel=1e-13)


def test_point_masses_is_the_double_cross_product():
    rng = np.random.default_rng(3)
    masses, places, omega = rng.uniform(1, 2, 4), rng.normal(size=(4, 3)), rng.normal(size=3)
    momentum = sum(m * np.cross(x, np.cross(omega, x)) for m, x in zip(masses, places, strict=True))
    tensor = np.array(
        point_masses((m, Matrix(x)) for m, x in zip(masses, places, strict=True)).evalf(),
        dtype=float,
    )
    assert tensor @ omega == pytest.approx(momentum)
    assert tensor == pytest.approx(tensor.T)


def test_parallel_axis_moves_a_cone_from_apex_to_centre():
    apex, shift = cone(r, h).inertia(M), Matrix([0, 0, Rational(3, 4) * h])
    centre = apex - point_masses([(M, shift)])
    # Landau and Lifshitz, same place: about the centre of mass 3M(R² + h²/4)/20.
    assert sympy.expand(centre[0, 0] - Rational(3, 20) * M * (r**2 + h**2 / 4)) == 0
    assert parallel_axis(centre, M, shift).expand() == apex.expand()
    assert parallel_axis(centre, M, -shift).expand() == apex.expand()


def test_parallel_axis_of_points_is_what_the_points_give():
    points = [(1, Matrix([1, 0, 2])), (2, Matrix([0, -1, 1])), (3, Matrix([2, 2, -1]))]
    centre = sum((m * x for m, x in points), Matrix([0, 0, 0])) / 6
    about = point_masses([(m, x - centre) for m, x in points])
    assert parallel_axis(about, 6, centre) == point_masses(points)


TENSORS = [
    Matrix([[3, 1, 0], [1, 3, 0], [0, 0, 5]]),
    Matrix([[4, -1, 0], [-1, 4, -1], [0, -1, 4]]),
    Matrix([[2, 0, 0], [0, 2, 0], [0, 0, 2]]),
    Matrix([[5, 0, 0], [0, 1, 0], [0, 0, 3]]),
    Matrix([[4, 1, 1], [1, 4, 1], [1, 1, 4]]),  # two equal moments
    point_masses([(1, Matrix([1, 2, 2])), (2, Matrix([2, 1, -2])), (3, Matrix([2, -2, 1]))]),
]


@pytest.mark.parametrize("tensor", TENSORS)
def test_principal_axes_are_a_right_handed_frame(tensor):
    moments, axes = principal_axes(tensor)
    assert list(moments) == sorted(moments, key=lambda moment: float(moment))
    assert sorted(map(float, moments)) == pytest.approx(
        np.linalg.eigvalsh(np.array(tensor, dtype=float))
    )
    assert sympy.simplify(axes.T * axes) == eye(3)
    assert sympy.simplify(axes.T * tensor * axes) == diag(*moments)
    assert sympy.simplify(axes.det()) == 1


def test_principal_axes_with_symbols():
    moments, axes = principal_axes(Matrix([[a, b, 0], [b, a, 0], [0, 0, c]]))
    assert set(moments) == {a + b, a - b, c}
    assert axes.T * axes == eye(3)
    assert axes.det() == 1
    assert abs(axes[0, 0]) in (0, sqrt(2) / 2)


@pytest.mark.parametrize(
    "wrong", [Matrix([[1, 2, 0], [0, 1, 0], [0, 0, 1]]), eye(2), Matrix([[1, 2, 3]])]
)
def test_not_an_inertia_tensor(wrong):
    with pytest.raises(ValueError, match="an inertia tensor is a symmetric 3×3 matrix"):
        principal_axes(wrong)
