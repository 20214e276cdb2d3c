"""What a system is declared with, and whether it is one: forces, names, constraints.

Each check raises RigidtopError, in one line, for what is no system.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import sympy
from sympy import Dummy, Expr, Symbol
from sympy.core.function import AppliedUndef

from rigidtop.codegen.graph import Direction, Graph, somewhere
from rigidtop.codegen.nodes import ONE, ZERO
from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.system.names import Given, PlainSymbols, expression, own_functions, several


def acting(forces: Given, q: Given) -> tuple[Expr, ...]:
    """Forces in the order of the coordinates; nothing for None."""
    if forces is None:
        return ()
    if isinstance(forces, Mapping):
        unknown = [x for x in forces if x not in tuple(q)]
        if unknown:
            raise RigidtopError(
                f"a force on {in_one_line(unknown[0])}, which is none of the coordinates "
                f"{', '.join(map(str, q))}"
            )
        forces = [forces.get(x, 0) for x in q]
    return tuple(expression("a force", each) for each in several(forces))


def with_time(names: PlainSymbols, letters: Iterable[Symbol], q: Sequence[Expr]) -> PlainSymbols:
    """The names with the time that stands among the letters, if there is one, which all share."""
    times = {x for x in letters if x.name == names.t.name} - {*names.q, *names.v}
    plain = all(x.is_Symbol for x in q)
    if len(times | ({names.t} if not plain else set())) > 1:
        raise RigidtopError(
            f"two symbols named {names.t}: there is only one time"
            + ("" if plain else f", that of {q[0]}")
        )
    return replace(names, t=times.pop()) if times else names


def check_signs(velocities: Sequence[Symbol], terms: Sequence[Expr] | None) -> None:
    """A velocity of one sign is refused where that matters to the `terms`, or to a force."""
    for v in velocities:
        signed = v.is_positive or v.is_negative
        if signed and (terms is None or not all(is_even(each, v) for each in terms)):
            raise RigidtopError(
                f"{v} is declared to have one sign, and |{v}| is {v} then: "
                "a velocity has both, declare it real"
            )


def check_terms(
    terms: Mapping[str, Sequence[Expr]], q: Sequence[Expr], names: PlainSymbols
) -> None:
    """Nothing but coordinates, velocities, the time and constants stands in what is given."""
    for what, group in terms.items():
        for each in map(names.plain, group):
            if each.has(*names.a):
                raise RigidtopError(
                    f"{what} has an acceleration: coordinates, velocities and "
                    "the time may stand there"
                )
            for x in own_functions([each]):
                if x.has(*(y.func for y in q if isinstance(y, AppliedUndef))):
                    raise RigidtopError(f"{what} has {x}, which is none of the velocities")


def check_letters(letters: Iterable[Symbol]) -> None:
    """Each letter has a name of its own."""
    by_name: dict[str, Symbol] = {}
    for x in letters:
        if not x.name.strip():
            raise RigidtopError("there is a symbol without a name")
        if by_name.setdefault(x.name, x) != x:
            raise RigidtopError(f"two different symbols are called {x.name}")


def check_rules(rules: Mapping[Expr, Expr], names: PlainSymbols) -> None:
    """Each constraint, with itself in plain symbols, is of places, or linear in velocities."""
    for rule, plain in rules.items():
        if not plain.has(*names.q, *names.v):
            raise RigidtopError(f"the constraint {rule} = 0 has no coordinate and no velocity")
        if not _is_linear(plain, [v for v in names.v if plain.has(v)]):
            raise RigidtopError(f"the constraint {rule} = 0 is not linear in the velocities")


def check_sliding(velocity: Expr, plain: Expr, names: PlainSymbols) -> None:
    """The velocity of a dry friction, with itself in plain symbols, is linear in velocities."""
    moving = [v for v in names.v if plain.has(v)]
    if not moving or not _is_linear(plain, moving):
        raise RigidtopError(
            f"a DryFriction is of a coordinate, or of a velocity linear in the q̇, not of {velocity}"
        )


def _is_linear(value: Expr, velocities: Sequence[Symbol]) -> bool:
    """Whether no second derivative by velocities is left."""
    along = [Direction({v: ONE}) for v in velocities]

    def holds(graph: Graph) -> bool:
        rule = graph.expression(value)
        slopes = [graph.derivative(rule, each) for each in along]
        return all(graph.derivative(x, each) == ZERO for x in slopes for each in along)

    return not along or somewhere([value], holds)


def is_even(value: Expr, x: Symbol) -> bool:
    """Whether −x gives the same as x, but for what stands within a function."""
    inside = value.replace(lambda e: isinstance(e, sympy.Function) and e.has(x), lambda e: Dummy())
    return bool(sympy.expand(inside - inside.subs(x, -x)) == 0)
