"""What is shipped is what was derived, and is small."""

import ast

import numpy as np
import pytest
import sympy
from sympy import Float, Matrix, cos, sin

from rigidtop.codegen import shipped
from rigidtop.codegen.__main__ import main
from rigidtop.motion import equations
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.trig import reduce_ratio

NAMES = [side.name for side in shipped.SHIPPED]


@pytest.fixture(scope="module")
def current():
    """The module as the theory gives it."""
    return shipped.module_text()


def test_module_is_what_the_theory_gives(current):
    assert shipped.PATH.read_text("utf-8") == current


@pytest.mark.parametrize("name", NAMES)
def test_shipped_equals_derived(name):
    for ours, theirs in zip(shipped.symbolic(name), shipped.derived(name), strict=True):
        # The numerator's normal form in sines and cosines is unique: it decides.
        assert reduce_ratio(ours - theirs) == 0


@pytest.mark.parametrize("name", NAMES)
def test_a_changed_rate_is_not_what_was_derived(name):
    for ours, theirs in zip(shipped.symbolic(name), shipped.derived(name), strict=True):
        assert reduce_ratio(ours * (1 + s.epsilon) - theirs) != 0


@pytest.mark.parametrize("name", NAMES)
def test_shipped_is_exact_on_symbols(name):
    assert not any(rate.has(Float) for rate in shipped.symbolic(name))


def test_a_changed_module_is_not_what_was_derived(current):
    text = current.replace("c0 = (lambda2 - lambda3)", "c0 = (lambda2 + lambda3)")
    assert shipped.symbolic("heavy_body", text)[4] != shipped.symbolic("heavy_body")[4]


@pytest.mark.parametrize(
    ("name", "most"),
    [
        ("top_in_euler_angles", 60),
        ("heavy_body", 60),
        ("heavy_top", 60),
        ("top_by_routh", 30),
        ("top_by_hamilton", 30),
        ("body_in_euler_angles", 150),
        ("body_by_hamilton", 80),
    ],
)
def test_operations(name, most):
    counted = shipped.split(shipped.named(name)).rates.operations
    (definition,) = (
        node
        for node in ast.walk(ast.parse(shipped.PATH.read_text("utf-8")))
        if isinstance(node, ast.FunctionDef) and node.name == name
    )
    (rates,) = (node for node in definition.body if isinstance(node, ast.FunctionDef))
    inner = [node for statement in rates.body for node in ast.walk(statement)]
    assert counted == sum(isinstance(n, (ast.BinOp, ast.UnaryOp, ast.Call)) for n in inner)
    assert counted <= most


def test_small_differences_are_not_multiplied_out():
    """p_φ − p_ψ cos θ loses its digits where it is small if it is squared term by term."""
    for name in ("top_by_routh", "top_by_hamilton", "body_by_hamilton"):
        side = shipped.named(name)
        rates = getattr(equations, name)(
            *(0.0 if p.name in "MgR1R2R3" else 2.0 for p in side.parameters)
        )
        at = {s.theta: 1e-4, s.psi: 0.3, s.p_theta: 0.0, s.p_psi: 2.0}
        found = rates([at[x] for x in side.state])
        # With p_φ = p_ψ all rates are bounded near the vertical.
        assert max(map(abs, found)) < 2
        assert found[0] == pytest.approx(0.0, abs=1e-3)


def test_constants_do_not_contain_the_state():
    for side in shipped.SHIPPED:
        for constant in shipped.split(side).constants.values():
            assert constant.free_symbols <= set(side.parameters)


def turned_back(frame):
    """q̇ and ω̇ in the body, from rates in the frame at an angle χ to it, less the theory's own."""
    chi = sympy.Symbol("chi", real=True)
    c, d = cos(chi), sin(chi)  # the frame is turned by 2χ, so that half angles need no care
    p, u = Matrix(top.QUATERNION), Matrix([s.omega1, s.omega2])
    q = Matrix([p[0] * c - p[3] * d, p[1] * c + p[2] * d, p[2] * c - p[1] * d, p[3] * c + p[0] * d])
    cos2, sin2 = c**2 - d**2, 2 * c * d
    omega = Matrix([u[0] * cos2 + u[1] * sin2, u[1] * cos2 - u[0] * sin2, s.omega3])
    rates = dict(zip([*p, *u, chi], [*frame, s.omega3 / 2], strict=True))
    turned = Matrix([*q, *omega])
    moving = sum((turned.diff(x) * rate for x, rate in rates.items()), sympy.zeros(7, 1))
    state = dict(zip([*p, *u], turned[:6], strict=True))
    body = top.heavy_body_rates().subs(top.SYMMETRIC).subs(state, simultaneous=True)
    return [(entry.rewrite(sympy.exp)).expand() for entry in moving - body]


def test_frame_without_spin_is_the_body_frame_turned_back():
    assert turned_back(shipped.symbolic("heavy_top")) == [0] * 7


@pytest.mark.parametrize("row", range(6))
def test_a_wrong_sign_in_the_frame_is_seen(row):
    frame = list(shipped.symbolic("heavy_top"))
    frame[row] = -frame[row]
    assert turned_back(frame) != [0] * 7


@pytest.mark.parametrize("name", NAMES)
def test_arrays_and_floats_agree(name):
    side = shipped.named(name)
    rng = np.random.default_rng(1)
    states = rng.uniform(0.3, 1.2, (len(side.state), 6))
    parameters = rng.uniform(0.5, 2.0, len(side.parameters))
    angles = s.theta in side.state
    over_arrays = {"sin": np.sin, "cos": np.cos} if angles else {}
    make = getattr(equations, name)
    rates = np.array(make(*parameters, **over_arrays)(states))
    each = np.array([make(*parameters)(column.tolist()) for column in states.T]).T
    assert rates == pytest.approx(each, rel=1e-13, abs=1e-13)


def test_command_says_whether_the_module_is_current(monkeypatch, tmp_path, capsys, current):
    copy = tmp_path / "equations.py"
    monkeypatch.setattr(shipped, "PATH", copy)
    monkeypatch.setattr(shipped, "module_text", lambda: current)
    assert main(["--check"]) == 1
    assert not copy.exists()
    assert "run python -m rigidtop.codegen" in capsys.readouterr().out
    assert main([]) == 0
    assert copy.read_text("utf-8") == current
    assert main(["--check"]) == 0
    copy.write_text(copy.read_text("utf-8") + "\n# edited\n", "utf-8")
    assert main(["--check"]) == 1


def test_unknown_name_lists_the_names():
    with pytest.raises(ValueError, match="'spin': top_in_euler_angles, heavy_body"):
        shipped.named("spin")
