"""How a motion changes with its parameters and its start, by its variational equations."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
import sympy
from numpy.typing import ArrayLike
from sympy import Expr, Symbol

from rigidtop.codegen.nodes import ZERO, CallNode, Leaf
from rigidtop.errors import RigidtopError
from rigidtop.motion import checks, taylor
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Accuracy, Flow, Held, InitialValueProblem, flow, on_both_sides
from rigidtop.motion.rows import Rows
from rigidtop.motion.systems import Sizes
from rigidtop.parameters import in_one_line
from rigidtop.system.held import Surface
from rigidtop.system.names import Given, expression, several
from rigidtop.system.numeric import Computed, computed
from rigidtop.system.start import HOLDS, SystemStart, at_its_size, least_size, sizes
from rigidtop.system.trajectory import header

JUMPS = (
    *(sympy.sign, sympy.Heaviside, sympy.DiracDelta, sympy.floor, sympy.ceiling, sympy.frac),
    *(sympy.Mod, sympy.Piecewise),
)
"""Functions that may jump, which derivatives of smooth pieces do not see."""


@dataclass(frozen=True, eq=False, repr=False)
class Sensitivities(Rows):
    """A motion of n coordinates at N times, and its derivatives by k quantities."""

    motion: SystemStart
    """Where it starts, with its system and its parameters."""

    letters: tuple[Symbol, ...]
    """The k quantities, in the order in which they were asked for, as plain symbols."""

    t: Floats
    """Times, shape (N,), in s."""

    q: Floats
    """Coordinates, shape (N, n)."""

    qdot: Floats
    """Velocities, shape (N, n)."""

    q_by: Floats
    """∂q/∂(the quantities), shape (N, n, k), each in the coordinate's unit over the quantity's."""

    qdot_by: Floats
    """∂q̇/∂(the quantities), shape (N, n, k)."""

    @property
    def by(self) -> tuple[Expr, ...]:
        """The k quantities, in the names that were given."""
        return tuple(map(self._system.names.back, self.letters))

    def of(self, quantity: Given) -> tuple[Floats, Floats]:
        """∂q/∂x and ∂q̇/∂x for one of the quantities, each of shape (N, n).

        Raises RigidtopError for a quantity that was not asked for.
        """
        letter = letter_of(self._system, quantity)
        if letter not in self.letters:
            spelled = self._system.names.spelled
            raise RigidtopError(
                f"no derivatives by {spelled(letter)}: there are those by "
                + ", ".join(map(spelled, self.letters))
            )
        k = self.letters.index(letter)
        return self.q_by[:, :, k], self.qdot_by[:, :, k]

    def gradient(self, value: Given) -> Floats:
        """The derivatives of a value of q, q̇, p, t and the parameters along the motion, (N, k).

        Raises RigidtopError for letters that the system does not have.

        >>> from sympy import symbols
        >>> from rigidtop.system.system import System
        >>> k, x, v = symbols("k x v", real=True)
        >>> spring = System(v**2/2 - k*x**2/2, [x], [v])
        >>> run = spring.motion({k: 4}, q=3.0).sensitivities(1.0, by=[k, x])
        >>> run.gradient(spring.energy).round(6)    # of ½kx₀², whatever the time
        array([[ 4.5, 12. ]])
        """
        system, n = self._system, len(self.motion.q)
        plain = system.quantity(expression("the value", value))
        own = [plain.diff(x) if x in system.parameters else sympy.S.Zero for x in self.letters]
        slopes = [plain.diff(x) for x in (*system.names.q, *system.names.v)]
        function = system.numeric.of((*slopes, *own))
        with np.errstate(all="ignore"):
            slope = function.array(self.t, *self.q.T, *self.qdot.T, *self.motion.parameters)
        states = np.concatenate([self.q_by, self.qdot_by], axis=1)
        grad: Floats = np.einsum("it,tik->tk", slope[: 2 * n], states) + slope[2 * n :].T
        return grad

    def columns(self) -> dict[str, Floats]:
        """t, and the derivatives of each coordinate: theta_by_g, and so on."""
        columns = {"t/s": self.t}
        for i, x in enumerate(self._system.names.q):
            for k, letter in enumerate(self.letters):
                columns[_header(x, letter, self._system)] = self.q_by[:, i, k]
        return columns

    @property
    def _system(self) -> Computed:
        return self.motion.system


def sensitivities(motion: SystemStart, t: ArrayLike, by: Given, how: Accuracy) -> Sensitivities:
    """The derivatives of a motion: see `SystemMotion.sensitivities`."""
    times = checks.times(t)
    letters = letters_of(motion.system, by)
    check_smooth(motion.system, letters)
    if motion.system.constraints:
        check_free(motion, letters)
    variation = Variation(motion, letters)
    with np.errstate(all="ignore"):
        states = on_both_sides(
            lambda end: variation.flow(end, how),
            variation.start,
            times,
            lambda flow, ordered: variation.kept(ordered, flow.path(ordered)),
        )
    n, k = len(motion.q), len(letters)
    by_letters = states[2 * n : 2 * n + 2 * n * k].reshape(2, n, k, len(times))
    q_by, qdot_by = np.ascontiguousarray(np.moveaxis(by_letters, -1, 1))
    q, qdot = (states[k * n : (k + 1) * n].T.copy() for k in (0, 1))
    return Sensitivities(motion, letters, times, q, qdot, q_by, qdot_by)


@dataclass(frozen=True)
class Variation:
    """A motion with S = ∂(q, q̇)/∂(letters), which has Ṡ = A S + B.

    A state has q, q̇, S (2n×k, row by row), and the time where it occurs.
    """

    motion: SystemStart
    letters: tuple[Symbol, ...]

    @property
    def _states(self) -> tuple[Symbol, ...]:
        return (*self.motion.system.names.q, *self.motion.system.names.v)

    @cached_property
    def start(self) -> Floats:
        """The state at t = 0: a start changes with itself, and with nothing else."""
        own = [[float(x == y) for y in self.letters] for x in self._states]
        more = [0.0] * int(self.motion.system.numeric.timed)
        return np.array([*self.motion.q, *self.motion.qdot, *np.ravel(own), *more])

    @cached_property
    def scales(self) -> Floats:
        """What changes of each letter are fractions of, shape (k,)."""
        motion = self.motion
        of_states = sizes(motion.system, np.array([*motion.q, *motion.qdot]))
        size_of = dict(zip(self._states, of_states.tolist(), strict=True))
        for x, value in zip(motion.system.parameters, motion.parameters, strict=True):
            size_of[x] = abs(value) or 1.0
        return np.array([size_of[x] for x in self.letters])

    def sizes(self, state: Floats) -> Floats:
        """What absolute tolerances are fractions of."""
        n, count = len(self.motion.q), len(self.start)
        own = sizes(self.motion.system, state[: 2 * n])
        scales = np.concatenate([own, np.ravel(own[:, None] / self.scales), np.ones(1)])
        return scales[:count]

    def rates(self, state: Sequence[float]) -> tuple[float, ...]:
        """ẋ.  Raises RigidtopError where it can't be computed."""
        numeric, n, k = self.motion.system.numeric, len(self.motion.q), len(self.letters)
        row = (state[-1] if numeric.timed else 0.0, *state[: 2 * n], *self.motion.parameters)
        rates, why = computed(lambda row: self._slopes(*row), row)
        if why:
            time, *places = row[: 2 * n + 1]
            self.motion.rates_at([*places, *([time] * self.motion.more)])  # says it of these
            raise RigidtopError(
                f"the variational equations can't be computed: {why}; the accelerations have no "
                "derivative there"
            )
        S = np.array(state[2 * n : 2 * n + 2 * n * k]).reshape(2 * n, k)
        slopes = np.array(rates[n:])
        A, B = slopes[: 2 * n * n].reshape(n, 2 * n), slopes[2 * n * n :].reshape(n, k)
        moved = np.concatenate([S[n:], A @ S + B]).ravel().tolist()
        more = [1.0] * int(numeric.timed)
        return (*state[n : 2 * n], *rates[:n], *moved, *more)

    @cached_property
    def _slopes(self) -> Callable[..., Sequence[float]]:
        return self.motion.system.numeric.slopes(self.letters).scalar

    def flow(self, end: float, how: Accuracy) -> Flow:
        """The flow from t = 0 to `end`."""
        held: Held | None = None
        own: Sizes = self.sizes
        unit = own(self.start)
        if self.motion.system.constraints:  # of which what is at rest strays by its rounding
            held, own = self._held, lambda _: unit

        def run(sizes: Sizes) -> Flow:
            series = partial(self._taylor, sizes(self.start))
            whole = flow(InitialValueProblem(self.rates, self.start, sizes, series, held), end, how)
            self.motion.keeps_signs(whole.path(whole.steps))
            return whole

        return at_its_size(run, own, self.start, least_size(self.motion.system, how))

    def _taylor(self, unit: Floats, end: float, rtol: float) -> Flow:
        """The flow by heyoka's Taylor series, in `unit`s."""
        held = self._held if self.motion.system.constraints else None
        own = unit[[0, len(self.motion.q)]]
        values = [*own, *(1 / own), *self.scales, *self.motion.parameters]
        with self.motion.system.numeric.varied_by(self.letters, rtol) as integrator:
            integrator.pars[:] = values[: len(integrator.pars)]
            integrator.state[:] = self.start / unit
            return taylor.propagated(integrator, end, unit, held=held)

    def kept(self, times: Floats, states: Floats) -> Floats:
        """States (…, N) as the constraints have them."""
        return self._surface.onto(times, states) if self.motion.system.constraints else states

    @cached_property
    def _surface(self) -> Surface:
        return Surface(self.motion.system, self.motion.parameters)

    def _held(self, time: float, state: Floats) -> Floats:
        return self.kept(np.array([time]), state[:, None])[:, 0]


# --- what may be asked for ------------------------------------------------------------------------


def letter_of(system: Computed, letter: Given) -> Symbol:
    """The parameter, coordinate or velocity that is meant.  Raises RigidtopError for none."""
    names = system.names
    there = (*system.parameters, *names.q, *names.v)
    if isinstance(letter, (str, Expr)):
        name = str(getattr(letter, "name", letter))
        for x in there:
            if letter in (x, names.given.get(x)) or name in (x.name, names.spelled(x)):
                return x
    raise RigidtopError(
        f"no derivatives by {in_one_line(letter)}: the system has "
        + ", ".join(map(names.spelled, there))
    )


def letters_of(system: Computed, by: Given) -> tuple[Symbol, ...]:
    """The letters that are asked for, in a row or one alone.  Raises RigidtopError."""
    letters = tuple(letter_of(system, each) for each in several(by))
    if not letters:
        raise RigidtopError("derivatives by what? by = a row of parameters and coordinates")
    for x in letters:
        if letters.count(x) > 1:
            raise RigidtopError(f"{system.names.spelled(x)} stands twice in by")
    return letters


def check_smooth(system: Computed, letters: Sequence[Symbol]) -> None:
    """Raises RigidtopError where the accelerations may jump as a state or a letter changes."""
    moving = {*system.names.q, *system.names.v, *letters}
    for jump in jumps(system, moving):
        raise RigidtopError(
            f"the accelerations may jump with {system.names.back(jump)}, which derivatives don't "
            "see: smooth it, as tanh(v/c) does sign(v), or write it by Max, Min or Abs"
        )


def jumps(system: Computed, moving: set[Symbol]) -> Iterator[Expr]:
    """What may jump in the accelerations where some letters change."""
    sides = system.balanced
    graph, order = sides.graph, sorted(moving, key=str)
    for k in graph.below(sides.solution):
        node = graph.nodes[k]
        if isinstance(node, Leaf):
            inside = node.expression.atoms(*JUMPS)
            yield from (x for x in sorted(inside, key=str) if x.free_symbols & moving)
        elif isinstance(node, CallNode) and node.function in JUMPS:
            slopes = sides.gradients(node.arguments, order)
            if any(x != ZERO for row in slopes for x in row):
                [expression] = system.lines([(1, k)]).written_out()
                yield expression


def check_free(motion: SystemStart, letters: Sequence[Symbol]) -> None:
    """Raises RigidtopError where a constraint keeps a letter from changing alone at the start."""
    system, sides = motion.system, motion.system.balanced
    all_letters = [*system.names.q, *system.names.v, *letters]
    values = [*sides.rules, *sides.speeds]
    rows = sides.gradients(values, all_letters)
    function = system.numeric.on_graph([x for row in rows for x in row], "ties")
    slopes = np.reshape(motion.at_start(function, "a constraint"), (len(values), -1))
    for rule, row in zip([*system.constraints] * 2, np.abs(slopes), strict=True):
        for x, tie in zip(letters, row[-len(letters) :], strict=True):
            if tie > HOLDS * np.max(row[: -len(letters)]):
                raise RigidtopError(
                    f"{system.names.spelled(x)} can't change alone at the start: the constraint "
                    f"{rule} = 0 ties it to the rest; put the constraint into L, or leave it out"
                )


def _header(x: Symbol, letter: Symbol, system: Computed) -> str:
    """theta_by_g, with its unit where both have one."""
    units = [header(each).partition("/")[2].strip("()") for each in (x, letter)]
    name = f"{x.name}_by_{system.names.spelled(letter)}"
    return f"{name}/({units[0]}/({units[1]}))" if all(units) else name
