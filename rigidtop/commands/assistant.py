"""The tools of an assistant: commands on a text or on numbers that are handed over.

What they are given is a stranger's text: it is read within the limits of the commands, nothing of
it is run, and no file is opened on its account.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from mcp.server.mcpserver import Context, MCPServer
from mcp.server.mcpserver.exceptions import ToolError
from mcp.types import CallToolResult, InputRequiredResult
from pydantic import BaseModel, Field, ValidationError

from rigidtop import HeavyTop, __version__
from rigidtop.commands import certify, derive
from rigidtop.commands.draft import well_formed
from rigidtop.commands.findings import summary
from rigidtop.commands.notes import NoFormulasError, audited
from rigidtop.commands.worker import Worker
from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import TopMotion
from rigidtop.parameters import EXAMPLE_TOP
from rigidtop.terminal.limit import TooLong, within

SECONDS = 20.0
"""A motion is not computed for longer than this (of the processor's time)."""

Record = dict[str, Any]
Times = Annotated[int, Field(ge=2, le=10_000, description="how many times, from 0 to `time`")]
Time = Annotated[float, Field(ge=-1e6, le=1e6, description="the last time, s")]
Tex = Annotated[str, Field(description="Markdown with $…$ and $$…$$, or LaTeX")]


class Top(BaseModel):
    """A heavy symmetric top, its tip held, and its start: SI units, and radians."""

    lambda1: float = Field(EXAMPLE_TOP["lambda1"], description="moment across the axis, pivot")
    lambda3: float = Field(EXAMPLE_TOP["lambda3"], description="moment about the axis")
    mass: float = EXAMPLE_TOP["M"]
    arm: float = Field(EXAMPLE_TOP["R"], description="from the pivot to the centre of mass")
    gravity: float = EXAMPLE_TOP["g"]
    theta: float = Field(description="tilt of the axis")
    theta_dot: float = 0.0
    phi_dot: float = Field(0.0, description="rate of precession")
    omega3: float = Field(description="spin about the axis")

    @property
    def motion(self) -> TopMotion:
        top = HeavyTop(
            lambda1=self.lambda1, lambda3=self.lambda3, M=self.mass, R=self.arm, g=self.gravity
        )
        return top.motion(
            theta=self.theta,
            theta_dot=self.theta_dot,
            phi_dot=self.phi_dot,
            omega3=self.omega3,
        )


class _Server(MCPServer):
    """A server that says in a line what is amiss with what it is handed."""

    async def call_tool(
        self, name: str, arguments: Record, context: Context | None = None
    ) -> CallToolResult | InputRequiredResult:
        try:
            return await super().call_tool(name, arguments, context)
        except ToolError as error:
            if isinstance(error.__cause__, ValidationError):
                raise ToolError(f"{name}: {_amiss(error.__cause__)}") from None
            raise


def _amiss(error: ValidationError) -> str:
    """Which arguments are missing, and what is wrong with others."""
    problems = [(".".join(map(str, each["loc"])), each) for each in error.errors()]
    missing = [f"`{name}`" for name, each in problems if each["type"] == "missing"]
    wrong = [
        f"`{name}` {each['msg'].removeprefix('Input ')}"
        for name, each in problems
        if each["type"] != "missing"
    ]
    verb = "is" if len(missing) == 1 else "are"
    return "; ".join([f"{' and '.join(missing)} {verb} missing"] * bool(missing) + wrong)


class Assistant:
    """A server of tools, whose work is done one after another."""

    def __init__(self) -> None:
        self.worker = Worker()
        self.server = _Server(
            "rigidtop",
            version=__version__,
            instructions="Check a derivation in mechanics line by line before it is believed.",
            log_level="CRITICAL",
        )
        for tool in (self.audit, self.derive, self.mark, self.simulate, self.certify):
            self.server.add_tool(tool)

    def serve(self) -> None:
        """Answer on standard output what comes by standard input, until it ends."""
        self.worker.serve(lambda: asyncio.run(self.server.run_stdio_async()))

    async def audit(self, text: Tex) -> Record:
        """Judge every formula of a text: it follows from the lines above, is wrong, new or open."""
        return await self._done(lambda: _audit(well_formed(text)))

    async def derive(self, name: str) -> Record:
        """Derive an equation of the lecture on the top, such as 3.57, with every step."""
        return await self._done(lambda: _derive(name))

    async def mark(self, text: Tex, start: str = "", goal: str = "", given: Tex = "") -> Record:
        """Mark a derivation from one equation of the lecture to another, each by its number.

        With `given`, a text with what may be used, `goal` is a formula in LaTeX.
        """
        return await self._done(lambda: _mark(*map(well_formed, (text, start, goal, given))))

    async def simulate(self, top: Top, time: Time = 10.0, samples: Times = 21) -> Record:
        """Compute the motion of a top in closed form: a table, and what it keeps."""
        return await self._done(lambda: _limited(lambda: _simulate(top, time, samples)))

    async def certify(self, top: Top, time: Time = 10.0, samples: Times = 21) -> Record:
        """Compute the motion of a top in several ways, and by how much they differ."""
        return await self._done(lambda: _limited(lambda: _certify(top, time, samples)))

    async def _done(self, job: Callable[[], Record]) -> Record:
        try:
            return await asyncio.wrap_future(self.worker.result(job))
        except RigidtopError as error:
            raise ToolError(str(error)) from None


def _limited(job: Callable[[], Record]) -> Record:
    try:
        with within(SECONDS):
            return job()
    except TooLong:
        raise RigidtopError(f"it takes longer than {SECONDS:g} s") from None


def _audit(text: str) -> Record:
    from rigidtop.collection import built_in
    from rigidtop.read.project import TextFile

    try:  # a name that is not LaTeX's: no other file is taken in
        findings = audited((TextFile(Path("text.md"), text),), built_in()).findings
    except NoFormulasError:
        raise RigidtopError("no formulas between dollars or the like that say something") from None
    return {"findings": [each.record for each in findings], "summary": summary(findings)}


def _derive(name: str) -> Record:
    from rigidtop.collection import built_in

    collection = built_in()
    if not collection.has(name):
        raise RigidtopError(f"no equation or claim {name!r}")
    return derive.record(*derive.derived(collection, name), collection.notation)


def _mark(text: str, start: str, goal: str, given: str) -> Record:
    from rigidtop.mark.answer import mark
    from rigidtop.mark.task import task, task_of

    if not goal or bool(start) == bool(given):
        raise RigidtopError("say `goal`, and either `start` or `given`")
    return dict(mark(text, task_of(given, goal) if given else task(start, goal)).record)


def _simulate(top: Top, time: float, samples: int) -> Record:
    motion = top.motion
    path = motion.exact(np.linspace(0.0, time, samples))
    columns = {name: [float(x) for x in column] for name, column in path.columns().items()}
    drift = {name: float(x) for name, x in path.drift().items()}
    return {"regime": motion.regime, "columns": columns, "drift": drift}


def _certify(top: Top, time: float, samples: int) -> Record:
    from rigidtop.motion.certify import certify as compared

    return certify.record(compared(top.motion, np.linspace(0.0, time, samples)))
