"""The one linearisation: what is left of the equations near a steady motion, to first order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy
from sympy import Expr, Matrix, MatrixBase, Symbol
from sympy.core.function import AppliedUndef

from rigidtop.codegen.graph import Direction, Graph, somewhere
from rigidtop.codegen.lines import straight_line
from rigidtop.codegen.nodes import ONE, Value
from rigidtop.codegen.points import points
from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.proof import decide
from rigidtop.system.balance import Balance
from rigidtop.system.forms import LARGEST, PRINTED, short
from rigidtop.system.names import Given, expression, mapping
from rigidtop.theory.trig import reduce_ratio

if TYPE_CHECKING:
    from rigidtop.system.derived import Derived

IN_TIME = "the deviations change in time by themselves: their coefficients are not constant"

ROUNDING = 1e-14
"""Of a number that is given in decimals."""

Place = Mapping[Expr, Expr]
"""The steady values of plain letters."""


@dataclass(frozen=True)
class Linear:
    """M δq̈ + C δq̇ + K δq = U δu + Aᵀδλ, and what the constraints leave of δq and δq̇; plain.

    δq = P η and δq̇ = N ν + G η, with the deviations η of the independent coordinates and ν of the
    independent speeds.  AN = 0, so that Nᵀ times the equations has no multipliers.
    """

    place: Place
    mass: Matrix
    damping: Matrix
    stiffness: Matrix
    push: Matrix
    coordinates: Sequence[int]
    """Which are independent."""
    speeds: Sequence[int]
    places: Matrix
    """P (n×p)."""
    rates: Matrix
    """N (n×s)."""
    carried: Matrix
    """G (n×p)."""

    def of_first_order(self) -> tuple[Matrix, Matrix]:
        """A and B of ẋ = A x + B u for x = (η, ν).  Raises RigidtopError for a singular mass."""
        N, G, own = self.rates, self.carried, list(self.coordinates)
        by_place, by_speed = G.extract(own, range(G.cols)), N.extract(own, range(N.cols))
        M, C, K = self.mass, self.damping, self.stiffness
        right = N.T * Matrix.hstack(
            -M * G * by_place - C * G - K * self.places, -M * G * by_speed - C * N, self.push
        )
        mass = (N.T * M * N).applyfunc(_shortened)
        if _is_zero(mass.det(method="berkowitz")):
            raise RigidtopError(
                "the mass matrix is singular there: choose other coordinates near this motion"
            )
        below = mass.LUsolve(right).applyfunc(_in_lowest_terms)
        above = Matrix.hstack(by_place, by_speed)
        return Matrix.vstack(above, below[:, : above.cols]), Matrix.vstack(
            sympy.zeros(above.rows, self.push.cols), below[:, above.cols :]
        )


def linearise(
    system: Derived, at: Mapping[Expr, object], inputs: Given = ()
) -> tuple[Matrix, Matrix]:
    """The matrices A and B at a state: see `System.linearise`."""
    letters = _inputs(system, inputs)
    place = place_of(system, at, (*letters, *system.parameters))
    near = linear(system, {**dict.fromkeys(letters, sympy.S.Zero), **place}, letters)
    A, B = near.of_first_order()
    return system.names.back(A), system.names.back(B)


def _inputs(system: Derived, inputs: Given) -> list[Expr]:
    """The letters that are inputs, plain."""
    by_name = {x.name: x for x in system.parameters}
    letters = []
    if not isinstance(inputs, (Expr, str, Sequence, MatrixBase)):
        raise RigidtopError(f"the inputs are letters, such as [F], not {in_one_line(inputs)}")
    for each in (inputs,) if isinstance(inputs, (Expr, str)) else inputs:
        letter = by_name.get(str(each), each)
        if not isinstance(letter, (Symbol, AppliedUndef)) or letter in (*system.q, *system.qdot):
            raise RigidtopError(f"an input is a letter of a force or of L, not {in_one_line(each)}")
        if not any(x.has(letter) for x in system.given):
            raise RigidtopError(f"the input {letter} is in no force and not in L")
        letters.append(letter)
    return letters


def place_of(system: Derived, about: Mapping[Expr, object], others: Sequence[Expr] = ()) -> Place:
    """The values that are given, by plain letters; velocities that are not given are zero.

    `others` are letters besides coordinates and velocities that may have a value.
    """
    names = system.names
    about = mapping("a motion is given as {coordinate: value}", about)
    place = dict.fromkeys(names.v, sympy.S.Zero)
    by_name = {str(x): x for x in others}
    for key, value in about.items():
        symbol = names.find(key) or by_name.get(str(key))
        symbol = symbol or names.plain(expression("a coordinate", key))
        if symbol not in (*names.q, *names.v, *others):
            raise RigidtopError(f"{in_one_line(key)} is none of the coordinates and velocities")
        place[symbol] = names.plain(expression(f"the value of {key}", value))
    return place


def linear(system: Derived, place: Place, inputs: Sequence[Expr] = ()) -> Linear:
    """What the equations are near a steady motion, by derivatives on the graph.

    Raises RigidtopError where it is no steady motion, or its deviations change by themselves.
    """
    names, n = system.names, len(system.q)
    moved = [x for x, v in zip(names.q, names.v, strict=True) if place[v] != 0]
    place = {x: value for x, value in place.items() if x not in moved}
    M, force, K, C, U, A, D, speeds, left = _sides(system, place, inputs)
    _hold(system, place, A, speeds, left, moved)
    following = A.rref(iszerofunc=_is_zero)[1]
    if len(following) < A.rows:
        raise RigidtopError("the constraints depend on one another there")
    pushes = _pushes(system, A, force, following)
    left = force.xreplace(pushes).applyfunc(_shortened)
    _stands(system, place, left, moved)
    at = [place.get(x, sympy.S.Zero) for x in (*names.q, *names.v, *inputs)]
    slopes = Matrix.hstack(K.xreplace(pushes), C, U)
    for i, x in enumerate(left):
        if not _is_zero(x) and not _is_rounding(x, slopes[i, :], at):
            size = names.back(sympy.factor_terms(-x))
            raise RigidtopError(f"this is no steady motion: a force of {size} is left")
    M, C, K, U = (side.applyfunc(_shortened) for side in (M, -C, -K.xreplace(pushes), U))
    _stands(system, place, (*A, *D, *M, *C, *K, *U), moved, IN_TIME)
    of_places = [i for i, each in enumerate(system.holonomic) if each]
    coordinates, P = _free(A.extract(of_places, range(n)))
    independent, N = _free(A)
    carried = sympy.zeros(n, P.cols)
    if following:
        own = A.extract(range(A.rows), list(following)).LUsolve(-D * P)
        for row, k in enumerate(following):
            carried[k, :] = own[row, :]
    return Linear(place, M, C, K, U, coordinates, independent, P, N, carried)


def _hold(
    system: Derived, place: Place, A: Matrix, speeds: Matrix, left: Matrix, moved: Sequence[Expr]
) -> None:
    """Raises RigidtopError where a constraint, or its rate, does not hold at the place."""
    names = system.names
    for i, (rule, constraint) in enumerate(zip(system.rules, system.constraints, strict=True)):
        wanted = [(speeds[i], names.v)]
        if system.holonomic[i] and not rule.has(*moved):
            wanted.append((left[i], names.q))
        _stands(system, place, [x for x, _ in wanted], moved)
        if not all(
            _is_zero(x) or _is_rounding(x, A[i, :], [place.get(y, sympy.S.Zero) for y in letters])
            for x, letters in wanted
        ):
            raise RigidtopError(f"the constraint {constraint} = 0 does not hold there")


def _pushes(
    system: Derived, A: Matrix, force: Matrix, following: Sequence[int]
) -> dict[Expr, Expr]:
    """The multipliers that hold what follows where it is."""
    if not following:
        return {}
    own = list(following)
    without = force.xreplace(dict.fromkeys(system.multipliers, sympy.S.Zero))
    values = A.extract(range(A.rows), own).T.LUsolve(-without.extract(own, [0]))
    return dict(zip(system.multipliers, values, strict=True))


def _sides(system: Derived, place: Place, inputs: Sequence[Expr]) -> tuple[Matrix, ...]:
    """M; F = f + Aᵀλ, by q, q̇ and inputs too; A; A q̇ + b by q, and itself; the constraints.

    All have their values at the place.
    """
    names, n, k, m = system.names, len(system.q), len(system.rules), len(inputs)

    def values(graph: Graph) -> list[Expr]:
        balance = Balance(system, graph)
        sides = balance.of_parts()
        pushes = [graph.expression(x) for x in system.multipliers]
        reactions = [
            [graph.product([push, a]) for a in A]
            for push, A in zip(pushes, sides.constraints, strict=True)
        ]
        force = [
            graph.total([x, *(row[i] for row in reactions)]) for i, x in enumerate(sides.force)
        ]
        by_inputs = [Direction({x: ONE}) for x in inputs]

        def slopes(column: Sequence[Value], directions: Sequence[Direction]) -> list[Value]:
            return [graph.derivative(x, each) for x in column for each in directions]

        wanted = [
            *(x for row in sides.mass for x in row),
            *force,
            *slopes(force, balance.along_places),
            *slopes(force, balance.along_velocities),
            *slopes(force, by_inputs),
            *(x for row in sides.constraints for x in row),
            *slopes(sides.speeds, balance.along_places),
            *sides.speeds,
            *map(graph.expression, system.rules),
        ]
        program = straight_line(graph, wanted, system.free())
        return list(program.written_out(place))

    letters = (names.t, *names.q, *names.v, *system.multipliers, *inputs, *system.given)
    left = somewhere(letters, values)
    if any(x.has(sympy.nan, sympy.zoo, sympy.oo) for x in left):
        raise RigidtopError("the equations are singular there: choose other coordinates")
    sides = []
    for rows, columns in ((n, n), (n, 1), (n, n), (n, n), (n, m), (k, n), (k, n), (k, 1), (k, 1)):
        sides.append(Matrix(rows, columns, left[: rows * columns]))
        left = left[rows * columns :]
    return tuple(sides)


def _stands(
    system: Derived,
    place: Place,
    values: Sequence[Expr],
    moved: Sequence[Expr] = (),
    in_time: str = "the equations change in time there: no steady motion",
) -> None:
    """Raises RigidtopError where a letter is left that has no value, or changes."""
    names = system.names
    left = set().union(*(x.free_symbols for x in values))
    left -= set().union(*(x.free_symbols for x in place.values()))
    for x in names.q:
        if x in left and x in moved:
            raise RigidtopError(f"{names.back(x)} changes, and the equations contain it")
        if x in left:
            raise RigidtopError(f"the steady motion gives no value for {names.back(x)}")
    if names.t in left:
        raise RigidtopError(in_time)


def _free(rows: Matrix) -> tuple[list[int], Matrix]:
    """The columns that are free where rows times a column vanish, and all columns by them."""
    following = rows.rref(iszerofunc=_is_zero)[1]
    free = [i for i in range(rows.cols) if i not in following]
    if not following:
        return free, sympy.eye(rows.cols)
    return free, Matrix.hstack(*rows.nullspace(iszerofunc=_is_zero), sympy.zeros(rows.cols, 0))


def _in_lowest_terms(value: Expr) -> Expr:
    return reduce_ratio(value) if value.count_ops() <= PRINTED else value


def _shortened(value: Expr) -> Expr:
    if value.is_number:
        return sympy.expand(value)
    return short(value) if value.count_ops() < LARGEST else value


def _is_rounding(value: Expr, slopes: Matrix, at: Sequence[Expr]) -> bool:
    """Whether a value is what the rounding of decimals in a place leaves, where it has slopes."""
    if not value.has(sympy.Float):
        return False
    shares = [abs(slope * x) for slope, x in zip(slopes, at, strict=True)]
    letters = set().union(*(x.free_symbols for x in (value, *shares)))
    point = next(points(sorted(letters, key=str)))
    left, size = (sympy.N(x.xreplace(point)) for x in (abs(value), sympy.Add(*shares)))
    return bool(left <= ROUNDING * size)


def _is_zero(value: Expr) -> bool:
    return decide.vanishes(value) or decide.vanishes(sympy.simplify(value))
