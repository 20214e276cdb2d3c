"""What the numbers cost, beside what a user would otherwise take: medians of rounds in one run.

The example top: λ₁ = 1, λ₃ = 0.5, M = 1, g = 9.81, R = 0.5, θ = 0.5, θ̇ = 0.1, φ̇ = 1, ψ̇ = 40, over
10 s.  Every way gives θ, φ, ψ and their rates at every sample.  Compilation and derivation are not
in the times of a motion; a closed form is solved anew each time.  How long that takes depends on
the motion: other kinds, of the same top and of free bodies, stand beside it.
"""

from __future__ import annotations

import contextlib
import importlib
import math
import statistics
import subprocess
import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from time import perf_counter
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Floats = NDArray[np.float64]
Progress = Callable[[int, int], None]

TOP = {"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "g": 9.81, "R": 0.5}
START = {"theta": 0.5, "theta_dot": 0.1, "phi_dot": 1.0, "psi_dot": 40.0}
STATE = (0.5, 0.0, 0.0, 0.1, 1.0, 40.0)
"""θ, φ, ψ and their rates at t = 0."""

END = 10.0


@dataclass(frozen=True)
class Kind:
    """A motion of the example top, or of a free body."""

    name: str

    truth: tuple[float, float, float, float]
    """The quaternion of its attitude at the end, by Taylor series with 50 digits.

    See tests/motion/reference/taylor.py."""

    start: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    """θ, θ̇, φ̇ and ψ̇ of the top."""

    moments: tuple[float, float, float] | None = None
    """Of a free body, which starts with the identity and `omega`."""

    omega: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def motion(self) -> Any:
        from rigidtop.motion.body import FreeBody
        from rigidtop.motion.top import HeavyTop

        if self.moments is not None:
            return FreeBody(*self.moments).motion(self.omega)
        return HeavyTop(**TOP).motion(**dict(zip(START, self.start, strict=True)))


EXAMPLE = Kind(
    "the example top",
    (-0.9151311559196205, 0.21371230694656781, 0.11348931310410929, -0.322462700379366),
    (0.5, 0.1, 1.0, 40.0),
)

KINDS = (
    Kind(
        "cusps",
        (0.5980458820117939, 0.05743452787550003, -0.24177956323027677, -0.7619613118922971),
        (0.5, 0.0, 0.0, 40.0),
    ),
    Kind(
        "a slow spin",
        (0.2546020767963464, 0.20830445167153472, -0.29429430151155445, 0.8973170576795222),
        (0.5, 0.0, 0.0, 10.0),
    ),
    Kind(
        "a wild one",
        (0.1381890696023954, 0.8965299373352204, 0.42084435843019774, -0.0052800077277763815),
        (2.0, 3.0, -4.0, 15.0),
    ),
    Kind(
        "loops",
        (0.7880870356962916, 0.26382257477702636, -0.5534427359353015, -0.05493278844097244),
        (1.0, 0.0, -3.0, 30.0),
    ),
    Kind(
        "almost steady",
        (0.952227557148584, -0.18772539131419735, -0.16105776239366845, 0.17911519766763626),
        (0.5, 0.0, 0.25, 40.0),
    ),
    Kind(
        "past the upright",
        (0.7535015896112485, -0.5353846893834542, 0.13092767862528268, -0.3584083310930407),
        (0.3, 4.0, 0.0, 12.0),
    ),
    Kind(
        "a pendulum",
        (-0.880147553072263, 0.0, 0.4747002052041982, 0.0),
        (1.0, 0.5, 0.0, 0.0),
    ),
    Kind(
        "falling",
        (-0.1905448670271952, -0.1343583266208076, 0.9614552640970927, -0.1457541383880216),
        (0.1, 0.0, 0.0, 2.0),
    ),
    Kind(
        "near the separatrix",
        (0.9406261528082588, 0.278999810157476, -0.1067934817981889, 0.16117288491134762),
        (1.0, -2.052, 0.65, 1.65),
    ),
    Kind(
        "a free body",
        (-0.28920088681658684, 0.017729711160730306, 0.05941901511352761, -0.955258020144084),
        moments=(1.0, 1.7, 2.5),
        omega=(1.0, 0.5, 2.0),
    ),
    Kind(
        "about the long axis",
        (-0.1769606477526958, -0.9570475734555294, 0.12718994790750193, -0.19122653696889527),
        moments=(1.0, 1.7, 2.5),
        omega=(2.0, 0.5, 0.3),
    ),
    Kind(
        "two equal moments",
        (-0.9927950068330401, 0.10674107924202153, 0.004151078964511475, 0.05428798166318777),
        moments=(1.0, 1.0, 1.6),
        omega=(1.0, 0.5, 3.0),
    ),
    Kind(
        "the flip",
        (-0.012931118997556819, 0.998548307446118, -0.006665672431725793, -0.051861668590557984),
        moments=(1.0, 2.0, 3.0),
        omega=(0.01, 2.0, 0.01),
    ),
)

FREE = next(kind for kind in KINDS if kind.moments)

TOLERANCE = 1e-12
ROUNDS = 5
STATES = 100_000
TOPS = 1_000_000
SHORTEST = 0.05
"""A round repeats what is shorter than this (s)."""


@dataclass(frozen=True)
class Row:
    """One way of doing something."""

    task: str
    way: str
    seconds: float | None
    """Median of one go; None where a package is missing, which `note` says."""

    per: int = 1
    """How many samples, tops or evaluations that is."""

    error: float | None = None
    """The largest error of θ, φ, ψ at the end, or of the attitude, rad."""

    note: str = ""

    kind: str = ""
    """The kind of motion, in a task that has many."""


@dataclass(frozen=True)
class Way:
    """A way that can be run: `go` returns what was computed."""

    name: str
    go: Callable[[], Any] | None
    error: Callable[[Any], float] | None = None
    note: str = ""
    rounds: int = ROUNDS
    clock: Callable[[], float] | None = None
    """Instead of `go`: runs and returns the seconds."""
    of_all: float = 1.0
    """The part of the task that `go` does; its time is divided by it."""


def measure(quick: bool = False, progress: Progress | None = None) -> list[Row]:
    """Run everything; `quick` has a tenth of the samples, and one round.

    `progress` is called with the number of tasks done, and of all.
    """
    scale, rounds = (10, 1) if quick else (1, ROUNDS)
    sizes = 10_000 // scale, 1_000_000 // scale
    others = "{:,} samples of other motions"
    tasks: list[tuple[str, str, int, Callable[[], list[Way]]]] = [
        *((f"{n:,} samples of one motion", "", n, lambda n=n: _trajectory(n)) for n in sizes),
        *(
            (others.format(n), kind.name, n, lambda n=n, kind=kind: _other(kind, n))
            for n in sizes
            for kind in KINDS
        ),
        ("one time of a top", "", 1, lambda: _one_time(EXAMPLE)),
        ("one time of a free body", "", 1, lambda: _one_time(FREE)),
        (
            f"{TOPS // scale:,} tops, each at one time",
            "",
            TOPS // scale,
            lambda: _tops(TOPS // scale),
        ),
        ("one right-hand side", "", 1, _one_call),
        (f"{STATES:,} right-hand sides", "", STATES, _batch),
        ("derive the equations of motion", "", 1, _derivations),
        *(
            (
                f"derive {n} pendulums in a row, to the right-hand side",
                "",
                1,
                lambda n=n: _row_of(n),
            )
            for n in ((2, 4) if quick else (2, 4, 10))
        ),
        ("10 s of two pendulums, 1,000 samples", "", 1000, _two_pendulums),
    ]
    rows: list[Row] = []
    for done, (task, kind, per, ways) in enumerate(tasks):
        rows += [replace(row, kind=kind) for row in _rows(task, per, ways(), rounds)]
        if progress is not None:
            progress(done + 1, len(tasks))
    return rows


def _rows(task: str, per: int, ways: Sequence[Way], rounds: int) -> list[Row]:
    """The first way is the one that the others are measured against."""
    seconds: dict[str, list[float]] = {way.name: [] for way in ways}
    errors: dict[str, float] = {}
    for way in ways:
        if way.go is not None:
            result = way.go()  # the first go pays for imports and compilation
            if way.error is not None:
                errors[way.name] = way.error(result)
    for k in range(rounds):
        for way in ways:
            if k < way.rounds and (way.go or way.clock):
                taken = way.clock() if way.clock else _once(way.go)
                seconds[way.name].append(taken / way.of_all)
    return [
        Row(
            task,
            way.name,
            statistics.median(seconds[way.name]) if seconds[way.name] else None,
            per,
            errors.get(way.name),
            way.note,
        )
        for way in ways
    ]


def _once(go: Callable[[], Any] | None) -> float:
    """Seconds of one go; if it is short, the median of several."""
    assert go is not None
    begin, taken = perf_counter(), list[float]()
    while not taken or perf_counter() - begin < SHORTEST:
        before = perf_counter()
        go()
        taken.append(perf_counter() - before)
    return statistics.median(taken)


def _module(name: str) -> Any:
    """A package that may be missing."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def _missing(name: str, package: str) -> Way:
    return Way(name, None, note=f"{package} is not installed")


# --- One motion -----------------------------------------------------------------------------------


def _by_hand(theta: float, theta_dot: float, phi_dot: float, psi_dot: float) -> tuple[float, ...]:
    """θ̈, φ̈, ψ̈ as one writes them who solves (3.54)–(3.56) for them."""
    weight = TOP["M"] * TOP["g"] * TOP["R"]
    s, c = math.sin(theta), math.cos(theta)
    momentum = TOP["lambda3"] * (psi_dot + phi_dot * c)
    phi_ddot = theta_dot * (momentum - 2 * TOP["lambda1"] * phi_dot * c) / (TOP["lambda1"] * s)
    return (
        s * (phi_dot * (TOP["lambda1"] * phi_dot * c - momentum) + weight) / TOP["lambda1"],
        phi_ddot,
        theta_dot * phi_dot * s - phi_ddot * c,
    )


def _system(state: Sequence[float]) -> tuple[float, ...]:
    theta, _, _, theta_dot, phi_dot, psi_dot = state
    return theta_dot, phi_dot, psi_dot, *_by_hand(theta, theta_dot, phi_dot, psi_dot)


def _trajectory(samples: int) -> list[Way]:
    from scipy.integrate import odeint, solve_ivp

    t = np.linspace(0.0, END, samples)
    exact, heyoka = _other(EXAMPLE, samples)

    def dop853() -> Any:
        return solve_ivp(
            lambda _, state: _system(state.tolist()),
            (0.0, END),
            STATE,
            method="DOP853",
            t_eval=t,
            rtol=TOLERANCE,
            atol=TOLERANCE,
        ).y

    def lsoda() -> Any:
        return odeint(
            lambda state, _: _system(state.tolist()),
            STATE,
            t,
            rtol=TOLERANCE,
            atol=TOLERANCE,
            mxstep=100_000,
        ).T

    return [
        exact,
        heyoka,
        Way("solve_ivp DOP853, 1e-12", dop853, exact.error),
        Way("odeint, 1e-12", lsoda, exact.error, rounds=2 if samples > 100_000 else ROUNDS),
        _pydy(t, exact.error),
    ]


def _other(kind: Kind, samples: int) -> list[Way]:
    """The closed form and the fastest of the others; of a free body attitude and ω."""
    from rigidtop.motion import attitude

    t, truth = np.linspace(0.0, END, samples), np.array(kind.truth)
    theta, *rates = kind.start

    def exact() -> Any:
        path = kind.motion().exact(t)
        if kind.moments is not None:
            return [*path.quaternion.T, *path.omega.T]
        return path.theta, path.phi, path.psi, path.theta_dot, path.phi_dot, path.psi_dot

    def last(rows: Any) -> float:
        q = np.array([row[-1] for row in rows[:4]])
        if kind.moments is None:
            q = attitude.from_spinors(np.cos(q[0] / 2), np.sin(q[0] / 2), q[1], q[2])
        q = q / np.linalg.norm(q)
        return 2 * float(min(np.linalg.norm(q - truth), np.linalg.norm(q + truth)))

    body = (1.0, 0.0, 0.0, 0.0, *kind.omega)
    start = (theta, 0.0, 0.0, *rates) if kind.moments is None else body
    return [Way("exact", exact, last), _heyoka_grid(t, last, start, kind.moments)]


def _heyoka_grid(
    t: Floats,
    last: Callable[[Any], float],
    start: Sequence[float],
    moments: Sequence[float] | None,
) -> Way:
    """The example top in Euler angles, or a free body in its quaternion and ω."""
    from rigidtop.motion import equations

    name = "heyoka propagate_grid"
    heyoka = _module("heyoka")
    if heyoka is None:
        return _missing(name, "heyoka")
    if moments is None:
        state = heyoka.make_vars("theta", "phi", "psi", "thetadot", "phidot", "psidot")
        of_top = equations.top_in_euler_angles(*TOP.values(), sin=heyoka.sin, cos=heyoka.cos)
        rates = [*state[3:], *of_top([state[0], *state[3:]])]
    else:
        state = heyoka.make_vars("q0", "q1", "q2", "q3", "omega1", "omega2", "omega3")
        rates = list(equations.heavy_body(*moments, *[0.0] * 5)(state))
    integrator = heyoka.taylor_adaptive(list(zip(state, rates, strict=True)), list(start))

    def go() -> Any:
        integrator.time = 0.0
        integrator.state[:] = start
        return integrator.propagate_grid(t)[-1].T

    return Way(name, go, last)


def _pydy(t: Floats, last: Callable[[Any], float] | None) -> Way:
    """The same top from Kane's equations, as PyDy's manual has it."""
    name = "PyDy System.integrate, 1e-12"
    with _quiet():
        system_module = _module("pydy.system")
    if system_module is None:
        return _missing(name, "pydy")
    import sympy
    from sympy.physics import mechanics

    lambda1, lambda3, M, g, R = parameters = sympy.symbols(list(TOP))
    theta, phi, psi = angles = mechanics.dynamicsymbols("theta phi psi")
    speeds = mechanics.dynamicsymbols("u_theta u_phi u_psi")
    space = mechanics.ReferenceFrame("N")
    turned = space.orientnew("A", "Axis", [phi, space.z])
    tilted = turned.orientnew("B", "Axis", [theta, turned.y])
    body = tilted.orientnew("C", "Axis", [psi, tilted.z])
    kinematic = [
        u - q.diff(mechanics.dynamicsymbols._t) for q, u in zip(angles, speeds, strict=True)
    ]
    pivot = mechanics.Point("O")
    pivot.set_vel(space, 0)
    centre = pivot.locatenew("G", R * body.z)
    centre.v2pt_theory(pivot, space, body)
    across = lambda1 - M * R**2
    inertia = mechanics.inertia(body, across, across, lambda3)
    top = mechanics.RigidBody("top", centre, body, M, (inertia, centre))
    kane = mechanics.KanesMethod(space, q_ind=angles, u_ind=speeds, kd_eqs=kinematic)
    with _quiet():
        kane.kanes_equations([top], [(centre, -M * g * space.z)])
        system = system_module.System(
            kane,
            constants=dict(zip(parameters, TOP.values(), strict=True)),
            initial_conditions=dict(zip([*angles, *speeds], STATE, strict=True)),
            times=t,
        )
        system.generate_ode_function(generator="lambdify")
    order = [system.states.index(x) for x in (*angles, *speeds)]

    def go() -> Any:
        with _quiet():
            return system.integrate(rtol=TOLERANCE, atol=TOLERANCE, mxstep=100_000).T[order]

    return Way(name, go, last, rounds=1)


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """PyDy warns of what it will change."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


# --- One time ---


def _one_time(kind: Kind) -> list[Way]:
    known = kind.motion()
    return [
        Way("exact, a new motion", lambda: kind.motion().exact(END)),
        Way("exact, again", lambda: known.exact(END)),
        Way("integrate, DOP853, 1e-12", lambda: known.integrate(END, rtol=1e-12), rounds=1),
    ]


# --- Many motions ---------------------------------------------------------------------------------


def _tops(count: int) -> list[Way]:
    from scipy.integrate import solve_ivp

    from rigidtop.motion.many import top_motions
    from rigidtop.motion.top import HeavyTop

    random = np.random.default_rng(1)
    spread: dict[str, Any] = {
        name: value * random.uniform(0.95, 1.05, count) for name, value in START.items()
    }
    times = random.uniform(0.0, END, count)

    def exact() -> Any:
        return top_motions(**TOP, **spread).exact(times)

    few = 5

    def one_by_one() -> Any:
        body = HeavyTop(**TOP)
        for k in range(few):
            body.motion(**{name: float(values[k]) for name, values in spread.items()}).exact(
                times[k]
            )

    def dop853() -> Any:
        for k in range(few):
            state = [spread["theta"][k], 0.0, 0.0, *(spread[n][k] for n in list(START)[1:])]
            solve_ivp(
                lambda _, x: _system(x.tolist()),
                (0.0, times[k]),
                state,
                method="DOP853",
                rtol=TOLERANCE,
                atol=TOLERANCE,
            )

    return [
        Way("exact, in one call", exact),
        Way("exact, one by one", one_by_one, of_all=few / count, note=f"{few} run, scaled"),
        Way("solve_ivp DOP853, 1e-12", dop853, of_all=few / count, note=f"{few} run, scaled"),
    ]


# --- Right-hand sides -----------------------------------------------------------------------------

_RATES = (0.5, 0.1, 1.0, 40.0)
"""θ, θ̇, φ̇, ψ̇."""


def _one_call() -> list[Way]:
    from rigidtop.motion import equations

    shipped = equations.top_in_euler_angles(*TOP.values())
    ways = [
        Way("derived, Python", _many(lambda: shipped(_RATES)), of_all=1000),
        Way("by hand, Python", _many(lambda: _by_hand(*_RATES)), of_all=1000),
    ]
    compiled = _compiled("numba")
    if compiled is None:
        return [*ways, _missing("derived, numba", "numba")]
    arguments = (*_RATES, *TOP.values())
    return [*ways, Way("derived, numba", _many(lambda: compiled.scalar(*arguments)), of_all=1000)]


def _many(call: Callable[[], Any], times: int = 1000) -> Callable[[], None]:
    def go() -> None:
        for _ in range(times):
            call()

    return go


def _batch() -> list[Way]:
    from rigidtop.motion import equations

    states = np.array(_RATES)[:, None] * np.random.default_rng(0).uniform(0.9, 1.1, (4, STATES))
    shipped = equations.top_in_euler_angles(*TOP.values(), sin=np.sin, cos=np.cos)
    rows = list(states)
    ways = [Way("derived, NumPy", lambda: shipped(rows))]
    numba, heyoka = _compiled("numba"), _compiled("heyoka")
    if numba is None:
        ways.append(_missing("derived, numba", "numba"))
    else:
        ways.append(Way("derived, numba", lambda: numba.array(*rows, *TOP.values())))
    if heyoka is None:
        ways.append(_missing("derived, heyoka", "heyoka"))
    else:
        arguments = np.empty((9, STATES))
        arguments[:4] = states
        arguments[4:] = np.array(list(TOP.values()))[:, None]
        results = np.empty((3, STATES))
        ways.append(Way("derived, heyoka", lambda: heyoka.batch(arguments, outputs=results)))
    return ways


def _compiled(backend: str) -> Any:
    """The derived right-hand side by a backend; None without its package."""
    if _module(backend) is None:
        return None
    module = importlib.import_module(f"rigidtop.codegen.{backend}")
    shipped = importlib.import_module("rigidtop.codegen.shipped")
    side = shipped.named("top_in_euler_angles")
    return module.function(side.derive(), (*side.state, *side.parameters), "rates")


def _derivations() -> list[Way]:
    """Each in a process of its own, SymPy's import not counted: nothing is in its caches."""
    ours = "from rigidtop.theory import top", "top.symmetric_top_accelerations()"
    sympy_s = (
        "from rigidtop.bench import lagranges_method; from sympy.physics import mechanics",
        "lagranges_method()",
    )
    return [
        Way("rigidtop.theory", None, clock=lambda: _fresh(*ours), rounds=3),
        Way("sympy LagrangesMethod.rhs", None, clock=lambda: _fresh(*sympy_s), rounds=3),
    ]


SOLVED = 4
"""More pendulums than these SymPy does not solve in a reasonable time."""


def _row_of(n: int) -> list[Way]:
    """To q̈ as lines, or, where SymPy does not get there, to M and f of Mq̈ = f."""
    from rigidtop.system import pendulums

    imports = "from rigidtop.system.pendulums import by_sympy, operations, pendulums"
    told = "method.rhs()" if n <= SOLVED else "[*method.mass_matrix, *method.forcing]"
    solved = f"method = by_sympy({n})\noperations({told})"
    ours = pendulums.pendulums(n).program.operations
    method = pendulums.by_sympy(n)
    sides = method.rhs() if n <= SOLVED else [*method.mass_matrix, *method.forcing]
    said = f"{pendulums.operations(sides)} operations" + ("" if n <= SOLVED else ", not solved")
    return [
        Way(
            "rigidtop.System",
            None,
            clock=lambda: _fresh(imports, f"pendulums({n}).program"),
            rounds=1,
            note=f"{ours} operations",
        ),
        Way(
            "sympy LagrangesMethod, cse",
            None,
            clock=lambda: _fresh(imports, solved),
            rounds=1,
            note=said,
        ),
    ]


def _two_pendulums() -> list[Way]:
    """From 1 and 0.5 rad at rest; the errors are those of the angles, against Taylor series."""
    from rigidtop.system import pendulums

    t = np.linspace(0.0, END, 1000)
    motion = pendulums.pendulums(2).motion(pendulums.PARAMETERS, q=[1.0, 0.5])
    has_heyoka = _module("heyoka") is not None
    finest = ("taylor", 2.3e-16) if has_heyoka else ("DOP853", 3e-14)
    truth = motion.integrate(t, *finest).q

    def error(found: Floats) -> float:
        return float(np.max(np.abs(found - truth)))

    ways = [
        Way("rigidtop DOP853", lambda: motion.integrate(t, rtol=TOLERANCE).q, error),
        Way("rigidtop taylor", lambda: motion.integrate(t, method="taylor").q, error)
        if has_heyoka
        else _missing("rigidtop taylor", "heyoka"),
    ]
    pydy = _module("pydy.codegen.ode_function_generators")
    if pydy is None:
        return [*ways, _missing("PyDy, odeint", "PyDy")]
    go = _by_pydy(pydy, t)
    return [*ways, Way("PyDy, odeint", go, error)]


def _by_pydy(pydy: Any, t: Floats) -> Callable[[], Floats]:
    import sympy
    from scipy.integrate import odeint

    from rigidtop.system import pendulums

    method = pendulums.by_sympy(2)
    speeds = sympy.symbols("w1 w2")
    rates = {x.diff(): w for x, w in zip(method.q, speeds, strict=True)}
    constants = tuple(pendulums.PARAMETERS)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        right = pydy.generate_ode_function(
            method.forcing.xreplace(rates),
            list(method.q),
            list(speeds),
            constants,
            mass_matrix=method.mass_matrix.xreplace(rates),
            coordinate_derivatives=sympy.Matrix(speeds),
        )
    values = np.array(list(pendulums.PARAMETERS.values()))
    start = np.array([1.0, 0.5, 0.0, 0.0])

    def go() -> Floats:
        found = odeint(right, start, t, args=(values,), rtol=TOLERANCE, atol=TOLERANCE)
        return np.asarray(found[:, :2])

    return go


def _fresh(imports: str, statement: str) -> float:
    """Seconds of a statement in a new process."""
    code = (
        f"from time import perf_counter\n{imports}\nbegin = perf_counter()\n{statement}\n"
        "print(perf_counter() - begin)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return float(done.stdout)


def lagranges_method() -> Any:
    """θ̈, φ̈, ψ̈ of the symmetric top as SymPy's manual has it."""
    import sympy
    from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

    lambda1, lambda3, M, g, R = sympy.symbols(list(TOP))
    angles = dynamicsymbols("theta phi psi")
    theta, theta_dot, phi_dot, psi_dot = angles[0], *(angle.diff() for angle in angles)
    across = lambda1 * (phi_dot**2 * sympy.sin(theta) ** 2 + theta_dot**2)
    along = lambda3 * (psi_dot + phi_dot * sympy.cos(theta)) ** 2
    method = LagrangesMethod((across + along) / 2 - M * g * R * sympy.cos(theta), angles)
    method.form_lagranges_equations()
    return method.rhs()


# --- The table and the plot -----------------------------------------------------------------------


def table(rows: Sequence[Row]) -> str:
    """Each task with its ways: seconds, per item, ratio to the first way, error at the end."""
    blocks = []
    for task, ways in _by_task(rows):
        lines = [task]
        for kind, exact, other, share in _compared(ways):
            errors = ", ".join(
                f"{row.error:.0e}" for row in (exact, other) if row.error is not None
            )
            times = f"{_time(exact.seconds or 0):>10}{_time(other.seconds or 0):>10}"
            lines.append(f"  {kind:29}{times}{_digits(share):>9} ×  errors {errors} rad")
        if len(lines) > 1:
            lines[0] += ", exact and heyoka, and their ratio"
        for row, ratio in ways:
            if row.kind:
                continue
            if row.seconds is None:
                lines.append(f"  {row.way:29}{row.note}")
                continue
            cells = [
                f"{_time(row.seconds):>10}",
                f"{_time(row.seconds / row.per):>10} each" if row.per > 1 else " " * 15,
                f"{_digits(ratio or math.nan):>9} ×",
                f"  error {row.error:.0e} rad" if row.error is not None else "",
                f"  ({row.note})" if row.note else "",
            ]
            lines.append(f"  {row.way:29}" + "".join(cells).rstrip())
        blocks.append("\n".join(lines))
    return "\n\n".join(blocks)


def _compared(
    ways: Sequence[tuple[Row, float | None]],
) -> list[tuple[str, Row, Row, float]]:
    """Of each kind of motion its two ways, and the time of the first over the other's: worst first.

    Nothing where the other is missing.
    """
    kinds = dict.fromkeys(row.kind for row, _ in ways if row.kind)
    found = []
    for kind in kinds:
        exact, other = (row for row, _ in ways if row.kind == kind)
        if exact.seconds and other.seconds:
            found.append((kind, exact, other, exact.seconds / other.seconds))
    return sorted(found, key=lambda one: -one[3])


def markdown(rows: Sequence[Row]) -> str:
    """Every kind of motion: a line of times over heyoka's, a column each task, the worst first."""
    tasks = {task: _compared(ways) for task, ways in _by_task(rows)}
    tasks = {task: found for task, found in tasks.items() if found}
    lines = [["`exact`, over heyoka's time", *tasks, "error of `exact`, of heyoka (rad)"]]
    lines.append(["---"] * len(lines[0]))
    for kind in [found[0] for found in next(iter(tasks.values()), [])]:
        one = {task: next(x for x in found if x[0] == kind) for task, found in tasks.items()}
        errors = [row.error for row in list(one.values())[-1][1:3] if row.error is not None]
        shares = [f"{share:.2f} ×" for _, _, _, share in one.values()]
        lines.append([kind, *shares, ", ".join(f"{error:.0e}" for error in errors)])
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def records(rows: Sequence[Row]) -> list[dict[str, Any]]:
    """The rows for JSON, with the ratio to the first way of the task."""
    return [{**vars(row), "ratio": ratio} for _, ways in _by_task(rows) for row, ratio in ways]


def _by_task(rows: Sequence[Row]) -> list[tuple[str, list[tuple[Row, float | None]]]]:
    """Tasks in order, their rows with the ratio to the first of them."""
    tasks: dict[str, list[Row]] = {}
    for row in rows:
        tasks.setdefault(row.task, []).append(row)
    found = []
    for task, ways in tasks.items():
        first = {way.kind: way.seconds or math.nan for way in reversed(ways)}
        found.append((task, [(w, w.seconds / first[w.kind] if w.seconds else None) for w in ways]))
    return found


def figure(rows: Sequence[Row]) -> Figure:
    """The ratios as bars, on a logarithmic scale."""
    from matplotlib.figure import Figure

    panels = []
    for task, ways in _by_task(rows):
        compared = [(kind, share, exact) for kind, exact, _, share in _compared(ways)]
        alone = [(row.way, ratio, row) for row, ratio in ways if ratio is not None and not row.kind]
        if compared:
            panels.append((f"{task}: exact over heyoka", compared, len(compared)))
        if alone:
            panels.append((task, alone, 1))
    heights = [len(bars) for _, bars, _ in panels]
    size = 7.2, 0.32 * sum(heights) + 0.75 * len(panels)
    drawing = Figure(figsize=size, layout="constrained")
    axes = drawing.subplots(len(panels), 1, height_ratios=[h + 0.6 for h in heights])
    for axis, (title, bars, dark) in zip(axes, panels, strict=True):
        ratios = [ratio for _, ratio, _ in bars]
        grey = ["0.25"] * dark + ["0.7"] * (len(bars) - dark)
        axis.barh([name for name, _, _ in bars], ratios, color=grey, height=0.7, left=0)
        axis.set_xscale("log")
        axis.set_xlim(min(0.1, *ratios) / 2, max(ratios) * 60)
        axis.invert_yaxis()
        axis.set_title(title, loc="left", fontsize=9)
        axis.tick_params(labelsize=8)
        axis.spines[["top", "right"]].set_visible(False)
        for place, (_, ratio, row) in enumerate(bars):
            label = f" {_digits(ratio)} ×  ({_time(row.seconds or 0)})"
            axis.text(ratio, place, label, va="center", fontsize=8)
    axes[-1].set_xlabel("time, relative to the first way, or to heyoka's", fontsize=8)
    return drawing


def _time(seconds: float) -> str:
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{_digits(seconds / size)} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def _digits(value: float) -> str:
    """Three digits, and no power of ten.

    >>> _digits(0.4321), _digits(15734.2)
    ('0.432', '15,734')
    """
    return f"{value:.3g}" if value < 1000 else f"{value:,.0f}"
