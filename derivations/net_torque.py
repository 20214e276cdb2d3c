"""Section 3.5.1: net torque."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations
from typing import Any

from sympy import Eq, Expr, Integer, Matrix, MatrixBase, Symbol, symbols

from rigidtop.proof.equation import (
    Cross,
    Equation,
    Group,
    NoMeaningError,
    Underbrace,
    VolumeIntegral,
    as_printed,
)
from rigidtop.proof.page import Assumption, Check, Evidence, Page, claim
from rigidtop.theory import symbols as s
from rigidtop.theory.rotation import Z_AXIS, euler_matrix, total_derivative

from .printed import printed

POSITION = Matrix(symbols("x y z", real=True))
D3R = Symbol("d3r")
K = Symbol("k")


def over_particles(places: list[tuple[Matrix, Matrix]], density: Matrix) -> Callable[[Any], Any]:
    """∫ d³r of what is linear in a force density that sits on particles: its sifting property."""

    def integral(integrand: Matrix) -> Matrix:
        total = Matrix([0, 0, 0])
        for place, force in places:
            here = dict(zip(POSITION, place, strict=True))
            total += integrand.subs({**here, **dict(zip(density, force, strict=True))})
        return total

    return integral


def over_body(centre: Matrix) -> Callable[[Any], Any]:
    """∫ d³r of ρ times what is linear in r, for any ρ: its mass M and centre of mass decide."""

    def integral(integrand: Expr | MatrixBase) -> Expr | MatrixBase:
        if isinstance(integrand, Matrix):
            return integrand.applyfunc(integral)
        linear = integrand.expand()
        moments = [s.M * component for component in centre]
        first = sum(
            (
                linear.coeff(x, 1).coeff(s.rho, 1) * m
                for x, m in zip(POSITION, moments, strict=True)
            ),
            Integer(0),
        )
        constant = linear.subs(dict.fromkeys(POSITION, 0))
        rest = (
            linear
            - constant
            - sum(s.rho * x * linear.coeff(x, 1).coeff(s.rho, 1) for x in POSITION)
        )
        if rest.expand() != 0:
            raise NoMeaningError(r"the integrand is not $\rho$ times something linear in $r$")
        return first + constant.coeff(s.rho, 1) * s.M

    return integral


@claim("3.48", "Torque as a sum over particles and as an integral over the force density.")
def torque() -> Iterator[Evidence]:
    r"""$d/dt \sum \mathbf r \times m \dot{\mathbf r}$ (1.20): forces along the line between two
    particles drop out, pair by pair.

    So they do for any number of particles, as the lines show; here they are three.  A force
    density that sits on the particles makes the integral the sum.
    """
    several = range(1, 4)
    positions = [Matrix(symbols(f"x{k} y{k} z{k}", real=True)) for k in several]
    velocities = [Matrix(symbols(f"u{k} v{k} w{k}", real=True)) for k in several]
    forces = [Matrix(symbols(f"F{k}x F{k}y F{k}z", real=True)) for k in several]
    masses = symbols("m1:4", positive=True)
    inner = [Matrix([0, 0, 0]) for _ in several]
    for one, other in combinations(range(len(inner)), 2):
        along = Symbol(f"c{one}{other}", real=True) * (positions[one] - positions[other])
        inner[one] += along
        inner[other] -= along
    rates: dict[Expr, Expr] = {}
    momentum = Matrix([0, 0, 0])
    for m, r, v, outer, between in zip(masses, positions, velocities, forces, inner, strict=True):
        rates |= dict(zip(r, v, strict=True)) | dict(zip(v, (outer + between) / m, strict=True))
        momentum += m * r.cross(v)
    density = Matrix(symbols("f_x f_y f_z", real=True))
    yield Check(
        printed("3.48"),
        {
            s.N_ext: total_derivative(momentum, rates).expand(),
            K: [{s.r_k: r, s.F_k: force} for r, force in zip(positions, forces, strict=True)],
            D3R: over_particles(list(zip(positions, forces, strict=True)), density),
            s.r_vec: POSITION,
            s.f_r: density,
        },
    )


@claim("3.49", "The torque of gravity is that of all the mass at the centre of mass.")
def gravity() -> Iterator[Evidence]:
    r"""The integral of $\rho r$ is $M \mathbf R_{\text{CM}}$ by definition; the same $g$
    everywhere is part of $f$.

    The torque is known besides from the energy: about each axis it is how much this falls with a
    small turn.
    """
    centre = Matrix(symbols("X Y Z", real=True))
    with as_printed():
        whole = VolumeIntegral(D3R, s.rho * s.r_vec)
        printed = Equation(
            s.N_ext,
            -s.g * VolumeIntegral(D3R, s.rho * Cross(s.r_vec, s.zhat)),
            -s.g * Cross(Group(whole), s.zhat),
            -s.g * s.M * Cross(Group(whole) / s.M, s.zhat),
            -s.g * s.M * Cross(s.R_CM, s.zhat),
            Cross(s.R_CM, Underbrace(s.F_grav, -s.g * s.M * s.zhat)),
            tag="3.49",
        )
    measure = over_body(centre)
    turn = Matrix(symbols("a_x a_y a_z", real=True))
    energy = measure(s.rho * s.g * (POSITION + turn.cross(POSITION)).dot(Z_AXIS))
    yield Check(
        printed,
        {
            s.N_ext: Matrix([-energy.diff(angle) for angle in turn]),
            D3R: measure,
            s.r_vec: POSITION,
            s.zhat: Matrix(Z_AXIS),
            s.R_CM: centre,
            s.F_grav: -s.g * s.M * Matrix(Z_AXIS),
        },
    )


@claim("potential", r"The potential energy is that of the mass at its centre: $MgR \cos\theta$.")
def potential() -> Iterator[Evidence]:
    r"""$\int\rho g z$ is $Mg$ times the height of the centre of mass, which lies on
    $\mathbf e_3$ at $R$ from the pivot."""
    centre = euler_matrix() * Matrix([s.R1, s.R2, s.R3])
    on_axis = r"the centre of mass lies on $\mathbf e_3$, at $R$ from the pivot"
    yield Check(
        printed(r"V = \int d^3\mathbf r\rho g\hat{\mathbf z}\cdot\mathbf r = MgR\cos\theta"),
        {
            s.V: s.M * s.g * (Z_AXIS.T * centre)[0],
            D3R: over_body(centre),
            s.zhat: Matrix(Z_AXIS),
            s.r_vec: POSITION,
        },
        tuple(
            Assumption(Eq(x, value), on_axis, stated=True)
            for x, value in ((s.R1, 0), (s.R2, 0), (s.R3, s.R))
        ),
        printed=True,
    )


page = Page(
    "3.5.1",
    "Net torque",
    "What gravity does to an extended body.",
    (torque, gravity, potential),
    opens="Dynamics of a spinning top",
    text="net_torque",
)
