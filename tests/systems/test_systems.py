"""Systems that know their exact answers, and other ways to their equations."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest
import sympy
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

import rigidtop as rt

KNOWN = sorted(Path(__file__).with_name("known").glob("*.py"))


def _loaded(path):
    spec = importlib.util.spec_from_file_location(f"known_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module", params=KNOWN, ids=lambda path: path.stem)
def known(request):
    return _loaded(request.param)


def test_a_system_gives_its_known_answer(known):
    answers = list(known.answers())
    assert answers
    for what, error, allowed in answers:
        assert np.max(np.abs(error)) <= allowed, what


def test_what_is_conserved_is_found(known):
    assert set(known.SYSTEM.conserved) == known.CONSERVED


def _in_functions(system):
    """L and the rest of a system in functions of time, as SymPy wants them."""
    names = system.names
    if names.given:
        given = dict(names.given)
    else:
        functions = dynamicsymbols([f"{x.name}_f" for x in names.q])
        t = dynamicsymbols._t
        given = {
            **dict(zip(names.q, functions, strict=True)),
            **{v: f.diff(t) for v, f in zip(names.v, functions, strict=True)},
        }
    rules = [rule.xreplace(given) for rule in system.rules]
    forces = [Q.xreplace(given) for Q in system.generalised_forces]
    return system.plain.xreplace(given), [given[x] for x in names.q], rules, forces, given


def _sympy(system):
    """M and f of SymPy's LagrangesMethod, with the multipliers' columns where it has them."""
    L, q, rules, forces, given = _in_functions(system)
    frame = sympy.physics.mechanics.ReferenceFrame("N")
    points = [sympy.physics.mechanics.Point(f"P{k}") for k in range(len(q))]
    loads = []
    for x, point, Q in zip(q, points, forces, strict=True):
        point.set_vel(frame, x.diff() * frame.x)
        loads += [(point, Q * frame.x)] if Q != 0 else []
    flags = dict(zip(("hol", "non"), ([], []), strict=True))
    for rule, of_places in zip(rules, system.holonomic, strict=True):
        flags["hol" if of_places else "non"].append(rule)
    method = LagrangesMethod(
        L,
        q,
        forcelist=loads or None,
        frame=frame,
        hol_coneqs=flags["hol"] or None,
        nonhol_coneqs=flags["non"] or None,
    )
    method.form_lagranges_equations()
    return method, given


def _point(system, seed):
    rng = np.random.default_rng(seed)
    arguments = system.numeric.arguments
    return {x: float(rng.uniform(0.5, 1.5)) for x in arguments}


def test_accelerations_are_those_of_sympy(known):
    system = known.SYSTEM
    method, given = _sympy(system)
    n = len(system.q)
    back = {f: x for x, f in given.items()}
    rates = {f: x for f, x in back.items() if isinstance(f, sympy.Derivative)}
    at = _point(system, 1)
    matrix, force = (
        np.array(side.xreplace(rates).xreplace(back).xreplace(at).evalf(20).tolist(), dtype=float)
        for side in (method.mass_matrix_full, method.forcing_full)
    )
    theirs = np.linalg.solve(matrix, force).ravel()[n : 2 * n]
    ours = system.numeric.solved.scalar(*at.values())[:n]
    assert ours == pytest.approx(theirs, rel=1e-9, abs=1e-9)
    written = system.names.plain(system.accelerations).xreplace(at)
    assert [float(x) for x in written] == pytest.approx(theirs, rel=1e-9, abs=1e-9)


OPERATIONS = {
    "bead": 8,
    "cart_pole": 23,
    "charge": 7,
    "double_pendulum": 39,
    "elastic_pendulum": 19,
    "foucault": 14,
    "gyrostat": 33,
    "heavy_body": 94,
    "kepler": 11,
    "kovalevskaya": 39,
    "rod": 37,
    "sleigh": 31,
    "spherical_pendulum": 13,
}
"""How long the programs were when they were shortest."""


def test_programs_get_no_longer(known):
    name = known.__name__.removeprefix("known_")
    assert known.SYSTEM.program.operations <= OPERATIONS[name]


def test_equations_vanish_with_the_accelerations(known):
    system, names = known.SYSTEM, known.SYSTEM.names
    at = _point(system, 3)
    solved = system.numeric.solved.scalar(*at.values())
    n = len(system.q)
    at |= dict(zip(names.a, solved, strict=False))
    at |= dict(zip(system.multipliers, (-x for x in solved[n:]), strict=True))
    assert [float(x) for x in names.plain(system.equations).xreplace(at)] == pytest.approx(
        [0.0] * n, abs=1e-9
    )


def test_certified(known):
    if known.SYSTEM.constraints and not known.SYSTEM.parts:
        with pytest.raises(rt.RigidtopError, match="no other way"):
            known.SYSTEM.certify(known.PARAMETERS)
        return
    differences = known.SYSTEM.certify(known.PARAMETERS)
    assert differences
    assert all(error < 1e-9 for error in differences.values()), differences


def test_accelerations_are_those_of_pydy():
    from pydy.codegen.ode_function_generators import generate_ode_function

    known = _loaded(next(path for path in KNOWN if path.stem == "double_pendulum"))
    method, _ = _sympy(known.SYSTEM)
    _, q, *_ = _in_functions(known.SYSTEM)
    speeds = dynamicsymbols("w1 w2")
    rates = {x.diff(): w for x, w in zip(q, speeds, strict=True)}
    constants = tuple(known.PARAMETERS)
    right = generate_ode_function(
        method.forcing.xreplace(rates),
        q,
        speeds,
        constants,
        mass_matrix=method.mass_matrix.xreplace(rates),
        coordinate_derivatives=sympy.Matrix(speeds),
    )
    values = np.array([float(v) for v in known.PARAMETERS.values()])
    state = np.array([0.3, 1.1, -0.4, 2.0])
    by_name = {x.name: value for x, value in zip(constants, values, strict=True)}
    ours = known.SYSTEM.numeric.solved.scalar(
        0.0, *state, *(by_name[x.name] for x in known.SYSTEM.parameters)
    )
    assert ours == pytest.approx(right(state, 0.0, values)[2:], rel=1e-12)
