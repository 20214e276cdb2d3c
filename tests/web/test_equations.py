"""The generated functions give what Python's give, and hold what they are taken from."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.codegen import shipped
from rigidtop.motion import equations as in_python
from rigidtop.theory import top
from rigidtop.web import equations, terms
from rigidtop.web.__main__ import main

RTOL = 1e-12

positive = st.floats(0.1, 10.0)
signed = st.floats(-10.0, 10.0)
angle = st.floats(0.05, math.pi - 0.05)


@st.composite
def quantities(draw):
    """Numbers for every symbol; q is a unit quaternion."""
    names = ("lambda1", "lambda2", "lambda3", "M", "g", "R", "R1", "R2", "R3", "friction")
    found = {name: draw(positive) for name in names}
    more = ("omega1", "omega2", "omega3", "phidot", "psidot", "thetadot", "p_phi", "p_psi", "E")
    found |= {name: draw(signed) for name in more}
    found |= {name: draw(signed) for name in ("phi", "psi", "angle")} | {"theta": draw(angle)}
    rotation = Rotation.from_euler("ZYZ", [found["phi"], found["theta"], found["psi"]])
    x, y, z, w = rotation.as_quat().tolist()
    return found | {"q0": w, "q1": x, "q2": y, "q3": z}


EXPECTED = {
    "attitudeMatrix": lambda: list(equations.attitude()),
    "omegaOfRates": lambda: list(equations.rotation.euler_omega("body")),
    "eulerRates": lambda: list(equations.euler_rates()),
    "quaternionOfAngles": equations.quaternion_of_angles,
    "energy": lambda: [equations.energy()],
    "effectivePotential": lambda: [top.top_effective_potential()],
    "nutationCubic": equations.nutation_cubic,
    "precessionNumerator": equations.precession_numerator,
    "bodyConeRate": lambda: [equations.body_cone_rate()],
    **{
        each.function: (lambda each=each: each.values)
        for each in (*terms.heavy(), *terms.general())
    },
}


@pytest.mark.parametrize("name", EXPECTED)
def test_a_function_evaluates_to_what_its_expressions_do(engine, name):
    expressions = [sympy.sympify(e) for e in EXPECTED[name]()]
    arguments = sorted({x.name for e in expressions for x in e.free_symbols})
    plain = {x: sympy.Symbol(x.name) for e in expressions for x in e.free_symbols}
    value = sympy.lambdify(
        [sympy.Symbol(a) for a in arguments], [e.xreplace(plain) for e in expressions], "math"
    )
    # What sums of terms of either sign leave is compared with the size of the terms.
    size = sympy.lambdify(
        [sympy.Symbol(a) for a in arguments],
        [sum((abs(t) for t in sympy.Add.make_args(e.xreplace(plain))), sympy.S.Zero)
         for e in map(sympy.expand, expressions)],
        "math",
    )  # fmt: skip

    @settings(max_examples=20)
    @given(quantities())
    def check(numbers):
        found = np.atleast_1d(engine.run(f"{name}(numbers)", numbers=numbers))
        given_ = [numbers[a] for a in arguments]
        for mine, theirs, scale in zip(found, value(*given_), size(*given_), strict=True):
            assert abs(mine - theirs) <= RTOL * max(abs(scale), abs(theirs))

    check()


@pytest.mark.parametrize(("name", "side"), [("heavyTop", "heavy_top"), ("heavyBody", "heavy_body")])
@settings(max_examples=25)
@given(quantities())
def test_right_hand_sides_are_those_that_python_integrates(engine, name, side, numbers):
    made = shipped.named(side)
    parameters = [numbers[x.name] for x in made.parameters]
    state = [numbers[x.name] for x in made.state]
    found = engine.run(
        f"rates = new Float64Array({len(state)}); {name}(...p)(state, rates); [...rates]",
        p=parameters, state=state,
    )  # fmt: skip
    expected = getattr(in_python, side)(*parameters)(state)
    scale = 1 + max(map(abs, expected))
    assert np.allclose(found, expected, rtol=RTOL, atol=RTOL * scale)


@settings(max_examples=25)
@given(quantities())
def test_space_vectors_and_energy_are_those_of_a_trajectory(engine, numbers):
    n = numbers
    arm = (n["R1"], n["R2"], n["R3"])
    moments = np.array([n["lambda1"], n["lambda2"], n["lambda3"]])
    rotation = Rotation.from_quat([n["q1"], n["q2"], n["q3"], n["q0"]])
    omega = np.array([n["omega1"], n["omega2"], n["omega3"]])
    assert np.allclose(engine.run("angularMomentum(n)", n=n), rotation.apply(moments * omega))
    weight = np.array([0, 0, -n["M"] * n["g"]])
    assert np.allclose(engine.run("gravityTorque(n)", n=n), np.cross(rotation.apply(arm), weight))
    height = rotation.apply(arm)[2]
    energy = moments @ omega**2 / 2 + n["M"] * n["g"] * height
    assert math.isclose(engine.run("energy(n)", n=n), energy, rel_tol=1e-11, abs_tol=1e-11)


@settings(max_examples=25)
@given(numbers=quantities())
def test_angles_and_rates_go_there_and_back(engine, numbers):
    q = [numbers[f"q{k}"] for k in range(4)]
    made = np.array(engine.run("quaternionOfAngles(numbers)", numbers=numbers))
    assert min(np.abs(made - q).max(), np.abs(made + q).max()) < 1e-13
    omega = engine.run("omegaOfRates(numbers)", numbers=numbers)
    given_ = numbers | dict(zip(("omega1", "omega2", "omega3"), omega, strict=True))
    back = engine.run("eulerRates(given_)", given_=given_)
    wanted = [numbers[name] for name in ("thetadot", "phidot", "psidot")]
    assert np.allclose(back, wanted, rtol=1e-11, atol=1e-11)


@settings(max_examples=25)
@given(st.floats(0.01, 1.5), st.floats(0.1, 40.0))
def test_steady_rates_and_their_threshold_are_those_of_the_top(engine, theta, omega3):
    top_ = rt.HeavyTop(lambda1=1.3, lambda3=0.7, M=0.8, R=0.6)
    given_ = {**vars(top_), "theta": theta, "omega3": omega3}
    least = engine.run("smallestSpin(given_)", given_=given_)
    assert math.isclose(least, top_.smallest_spin(theta), rel_tol=1e-12)
    found = engine.run("steadyRates(given_)", given_=given_)
    if omega3 < least:
        assert all(math.isnan(rate) for rate in found)
    else:
        expected = top_.steady_precession(theta, omega3)
        assert np.allclose(found, expected, rtol=1e-12)


@settings(max_examples=25)
@given(st.floats(0.5, 1.0), st.floats(1.05, 1.4), st.floats(-3, 3), signed, signed, signed)
def test_a_polhode_keeps_both_integrals(engine, small, middle, angle_, w1, w2, w3):
    moments = {"lambda1": small, "lambda2": middle, "lambda3": 1.5}
    omega = {"omega1": w1, "omega2": w2, "omega3": w3}
    twice_T, L2 = engine.run("firstIntegrals(all)", all=moments | omega)
    if twice_T * middle >= L2:
        return  # it goes round e₁
    asked = moments | {"twice_T": twice_T, "L_squared": L2, "angle": angle_}
    found = engine.run("polhode(asked)", asked=asked)
    names = ("omega1", "omega2", "omega3")
    kept = engine.run("firstIntegrals(all)", all=moments | dict(zip(names, found, strict=True)))
    assert np.allclose(kept, [twice_T, L2], rtol=1e-11)


@pytest.fixture(scope="module")
def sides():
    """The momenta p_φ and p_ψ, and the functions that give both sides of an equation."""
    groups = (*terms.heavy(), *terms.general())
    return top.symmetric_momenta()[1:], [each.function for each in groups]


@settings(max_examples=25)
@given(quantities())
def test_the_two_sides_of_each_equation_agree(engine, sides, numbers):
    # p_φ and p_ψ are those of the motion here.
    momenta, functions = sides
    n = dict(numbers)
    for name, p in zip(("p_phi", "p_psi"), momenta, strict=True):
        n[name] = float(p.subs({x: n[x.name] for x in p.free_symbols}))
    for function in functions:
        left, *right = engine.run(f"{function}(n)", n=n)
        assert math.isclose(left, sum(right), rel_tol=1e-9, abs_tol=1e-9 * sum(map(abs, right)))


@pytest.fixture(scope="module")
def current():
    """The module as the theory gives it."""
    return equations.module_text()


def test_the_module_is_what_the_theory_gives(current):
    assert equations.PATH.read_text("utf-8") == current


def test_a_module_that_is_not_what_the_theory_gives_is_found(
    tmp_path, monkeypatch, capsys, current
):
    stale = tmp_path / "equations.js"
    stale.write_text(current.replace("lambda3*omega3", "lambda1*omega3", 1), "utf-8")
    monkeypatch.setattr("rigidtop.web.__main__.PATH", stale)
    monkeypatch.setattr("rigidtop.web.__main__.module_text", lambda: current)
    assert main(["--check"]) == 1
    assert "run python -m rigidtop.web" in capsys.readouterr().out
    assert main([]) == 0
    assert stale.read_text("utf-8") == current
    assert main(["--check"]) == 0
    assert capsys.readouterr().out.endswith("equations.js is current\n")
