"""A system's right-hand side as source for others, in the lines in which it is solved."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from rigidtop.codegen import languages
from rigidtop.codegen.values import ClaimOutputs, Output
from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.proof.equation import Equation
from rigidtop.system.friction import refuse
from rigidtop.system.names import lettered, like
from rigidtop.typeset.text import text

if TYPE_CHECKING:
    from rigidtop.system.derived import Derived


def source(system: Derived, language: str, name: str) -> str:
    """The source text of q̈ in a language: see `System.source`."""
    refuse(system.friction, "a source file", "a program of one's own has to switch as it lets go")
    if language not in tuple(languages.LANGUAGES):
        there = ", ".join(languages.LANGUAGES)
        raise RigidtopError(f"no language {in_one_line(language)}: there are {there}")
    name = str(name)
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name):
        raise RigidtopError(f"{name!r} is no name for a function: give it letters, digits and _")
    names, program = system.names, system.program
    n = len(names.q)
    letters = (*names.a, *system.multipliers)
    results = (*program.results[:n], *(-x for x in program.results[n:]))
    own = {v: like(lettered(v), names.spelled(v)) for v in names.v}
    outputs = tuple(
        Output(names.spelled(x), value.xreplace(own), Equation(x, value), lettered(x))
        for x, value in zip(letters, results, strict=True)
    )
    used = set().union(*(x.free_symbols for x in (*results, *(e for _, e in program.shared))))
    parameters = [x for x in (names.t, *system.parameters) if x in used]
    time = [x for x in parameters if x == names.t]
    claim = ClaimOutputs(
        claim=name,
        says="the accelerations of " + ", ".join(text(x) for x in names.q),
        outputs=outputs,
        arguments=(
            *time,
            *map(lettered, names.q),
            *own.values(),
            *(lettered(x) for x in parameters if x not in time),
        ),
        lines=(),
        shared=tuple((x, value.xreplace(own)) for x, value in program.shared),
    )
    try:
        return languages.source(claim, language, text).text
    except NotImplementedError as error:
        [what] = re.findall(r"by <class '[^']*'>: (?:<class '[\w.]*\.)?(\w+)", str(error))[:1] or [
            error
        ]
        raise RigidtopError(f"there is no {what} in {language}") from None
