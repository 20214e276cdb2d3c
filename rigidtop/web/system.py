"""The page of a system: what L gives, as JavaScript, with a scene of points and their trails."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from math import pi
from typing import Any

import sympy
from sympy import Expr, MatrixBase, Symbol
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from rigidtop.codegen.javascript import of_arrays
from rigidtop.codegen.lines import StraightLine
from rigidtop.codegen.nodes import Value
from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.proof.equation import Equation
from rigidtop.system.motion import SystemMotion
from rigidtop.system.numeric import BALANCE, Computed
from rigidtop.system.parts import Body, Mass, single
from rigidtop.typeset.mathml import display, mathml
from rigidtop.typeset.text import text
from rigidtop.web.page import LivePage, common, document, json_text
from rigidtop.web.setup import Preset, Setup

Points = Sequence[Sequence[Any]]

LONGEST, WIDTH = 150, 30.0
"""Operations in an equation that a reader can take in, and how wide a line of it is, in em."""


def page_of_system(
    motion: SystemMotion, points: Points = (), height: int = LivePage.height
) -> LivePage:
    """The page of a system's motion; see `rigidtop.show`."""
    title = "Motion in " + ", ".join(map(text, motion.system.names.q))
    scene = Scene(motion.system, points)
    written = document(title, json_text(data(motion, scene, title)), "system", scene.module())
    return LivePage(title, written, height)


class Scene:
    """Where a system's points are, in plain symbols, and which of them are bodies."""

    def __init__(self, system: Computed, points: Points = ()) -> None:
        self.system = system
        if points:
            parts: Sequence[Mass | Body] = [Mass(1, each) for each in _several(points)]
        else:
            parts = single(system.parts)
        self.places = [system.names.plain(part.place) for part in parts]
        self.attitudes: dict[int, MatrixBase] = {
            k: system.names.plain(part.attitude)
            for k, part in enumerate(parts)
            if isinstance(part, Body)
        }
        system.numeric.of(self.seen)  # raises for letters that the system does not have

    @property
    def seen(self) -> tuple[Expr, ...]:
        """x, y, z of each point, then the entries of each attitude, row by row."""
        groups = (*self.places, *self.attitudes.values())
        return tuple(entry for group in groups for entry in group)

    @property
    def planar(self) -> bool:
        """Whether all of it lies in the plane of x and y."""
        return not self.attitudes and all(place[2] == 0 for place in self.places)

    @property
    def state(self) -> tuple[Symbol, ...]:
        """q, q̇, and the time where the equations or the places have it."""
        system = self.system
        measured = (*(x for _, x in self.measured.shared), *self.measured.results)
        timed = system.numeric.timed or any(x.has(system.names.t) for x in (*measured, *self.seen))
        return (*system.names.q, *system.names.v, *([system.names.t] if timed else []))

    @property
    def kept(self) -> Mapping[str, Value]:
        """What stays as it was, by its name; of a constraint zero."""
        watched = self.system.numeric.watched
        return {name: value for name, value in watched.items() if name != BALANCE}

    @cached_property
    def measured(self) -> StraightLine:
        """Jacobi's integral, and of what is kept the value and the size of its terms."""
        kept = self.system.numeric.with_sizes(self.kept.values())
        return self.system.lines([self.system.balanced.energy, *kept])

    def module(self) -> str:
        """The page's own module: rates, points and quantities of a state and of parameters.

        Raises RigidtopError for what has no counterpart in JavaScript.
        """
        system = self.system
        takes = {"s": self.state, "p": system.parameters}
        count = len(system.q)
        clock = (sympy.Integer(1),) * (len(self.state) - 2 * count)
        moved = (*system.names.v, *system.program.results[:count], *clock)
        kept = "E, and constants with their sizes."
        try:
            return "\n\n".join(
                (
                    of_arrays(
                        "rates", "What the state changes by.", takes, moved, system.program.shared
                    ),
                    of_arrays("points", "Where points are, then attitudes.", takes, self.seen),
                    of_arrays("measures", kept, takes, self.measured.results, self.measured.shared),
                )
            )
        except (NotImplementedError, ValueError) as error:
            what = re.search(r">: (?:<class '[\w.]*\.)?(\w+)|words for (\S+)", str(error))
            which = (what[1] or what[2]) if what else "a part of it"
            raise RigidtopError(f"there is no {which} in JavaScript, which a page needs") from None

    def angle(self, x: Symbol) -> bool:
        """Whether a coordinate stands in sines and cosines alone."""
        whole = (self.system.plain, *self.system.rules, *self.seen)
        bare = {f: sympy.Dummy() for e in whole for f in e.atoms(TrigonometricFunction)}
        return any(f.has(x) for f in bare) and not any(e.xreplace(bare).has(x) for e in whole)


def _several(points: Points) -> Points:
    if isinstance(points, (str, bytes, Mapping)) or not all(
        hasattr(each, "__len__") for each in points
    ):
        raise RigidtopError(
            "points are places, each of two or three components, such as [[x, y]], "
            f"not {in_one_line(points)}"
        )
    return points


def data(motion: SystemMotion, scene: Scene, title: str) -> Mapping[str, object]:
    """`SystemData` of the page's types: parameters are p0, p1 …, the start is s0, s1 …"""
    system = motion.system
    count = len(system.q)
    angles = [scene.angle(x) for x in system.names.q]
    state = [
        _letter(x, angle, "at the start", unit if angle else "")
        for group, unit in ((system.names.q, "rad"), (system.names.v, "rad/s"))
        for x, angle in zip(group, angles, strict=True)
    ]
    start = (*motion.q, *motion.qdot)
    tied = set().union(*(rule.free_symbols for rule in system.rules), set())
    sliders = {
        f"p{k}": (_letter(x, False, "", "") | _range(x, value), value)
        for k, (x, value) in enumerate(zip(system.parameters, motion.parameters, strict=True))
        if x not in tied
    }
    if not system.rules:
        angle = {"least": -pi, "most": pi, "logarithmic": False}
        sliders |= {f"s{k}": (each | angle, start[k]) for k, each in enumerate(state)}
    parameters = [{**each, "name": name, "start": True} for name, (each, _) in sliders.items()]
    values = {name: value for name, (_, value) in sliders.items()}
    preset = Preset("given", "As given", "", Setup("system", values), (), "")
    return common("system", title, parameters, (preset,), preset) | {
        "state": state,
        "start": [*start, *[0.0] * (len(scene.state) - 2 * count)],
        "given": motion.parameters,
        "sides": system.one_sided,
        "points": len(scene.places),
        "bodies": list(scene.attitudes),
        "planar": scene.planar,
        "follow": None,
        "kept": list(scene.kept),
        "written": display(list(_equations(system)), limit=WIDTH),
        "recordings": {},
    }


def _letter(x: Symbol, angle: bool, meaning: str, unit: str) -> dict[str, Any]:
    """What a slider says of a symbol."""
    quantity = getattr(x, "quantity", None)
    return {
        "letter": text(x),
        "math": mathml(x),
        "meaning": " ".join(filter(None, (getattr(quantity, "meaning", ""), meaning))).strip(),
        "unit": "" if angle and unit == "rad" else unit or getattr(quantity, "unit", ""),
        "angle": angle and unit == "rad",
    }


def _range(x: Symbol, value: float) -> dict[str, Any]:
    """The ends between which a parameter goes, so that it keeps the sign that was declared."""
    if x.is_positive:
        return {"least": value / 10, "most": 10 * value, "logarithmic": True}
    if x.is_negative:
        return {"least": 10 * value, "most": value / 10, "logarithmic": False}
    size = 3 * abs(value) or 1.0
    least = 0.0 if x.is_nonnegative else -size
    return {"least": least, "most": 0.0 if x.is_nonpositive else size, "logarithmic": False}


def _equations(system: Computed) -> Iterator[Equation]:
    """L and the accelerations, where they are short enough to be read."""
    from rigidtop.theory.symbols import Lagrangian

    if sympy.count_ops(system.plain) <= LONGEST:
        yield Equation(Lagrangian, system.plain)
    right = system.names.plain(system.accelerations)
    for a, value in zip(system.names.a, right, strict=True):
        if sympy.count_ops(value) <= LONGEST:
            yield Equation(a, value)
    yield from (Equation(rule, 0) for rule in system.rules)
