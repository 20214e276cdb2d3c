"""The page's motions against the closed forms, and what they keep."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import DOP853, solve_ivp
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.web.presets import PRESETS, TOP
from rigidtop.web.setup import body_of, free, heavy, setup_of

QUICK = {"max_examples": 12}


def triple(most):
    """Three numbers."""
    return st.lists(st.floats(-most, most), min_size=3, max_size=3)


def as_json(setup):
    return {"kind": setup.kind, "clock": setup.clock, "values": dict(setup.values)}


def sample(engine, setup, *times):
    """The page's samples at these times, reached one after the other."""
    return engine.run(
        "m = createMotion(setup, tableau); times.map((t) => { m.go(t); return m.now; })",
        setup=as_json(setup),
        times=times,
    )


def assert_same(found, expected, tolerance):
    """A sample of the page and a row of a trajectory."""
    turned = Rotation.from_matrix(np.reshape(found["rotation"], (3, 3)))
    assert (turned * expected.rotation[0].inv()).magnitude() < tolerance
    for name, values in (
        ("omega", expected.omega), ("omegaSpace", expected.omega_space),
        ("momentum", expected.angular_momentum), ("e3", expected.e3),
    ):  # fmt: skip
        scale = 1 + np.abs(values).max()
        assert np.allclose(found[name], values[0], atol=tolerance * scale), name
    assert math.isclose(found["energy"], expected.energy[0], rel_tol=1e-12, abs_tol=1e-12)


@pytest.mark.parametrize(
    "preset",
    [p for made in PRESETS.values() for p in made() if not p.setup.values.get("friction")],
)
def test_each_preset_is_the_closed_form(engine, tableau, preset):
    body = body_of(preset.setup)
    values = preset.setup.values
    if preset.setup.kind == "free":
        rows = sample(engine, preset.setup, 0, 3.7, 10)
        omega = [values[f"omega{k}"] for k in (1, 2, 3)]
        turn = Rotation.from_matrix(np.reshape(rows[0]["rotation"], (3, 3)))
        motion = body.motion(omega=omega, attitude=turn)
        assert np.allclose(rows[0]["momentum"][:2], 0, atol=1e-12 * rows[0]["momentum"][2])
    else:
        start = ("theta", "theta_dot", "phi", "phi_dot", "psi", "omega3")
        motion = body.motion(**{name: values[name] for name in start})
        rows = sample(engine, preset.setup, 0, 3.7, 10)
    for row in rows:
        exact = motion.exact([row["t"]])
        assert_same(row, exact, 2e-10)
        if preset.setup.kind == "heavy-top" and preset.name != "toppling":
            assert math.isclose(row["phi"], exact.phi[0], abs_tol=1e-9 * (1 + abs(exact.phi[0])))
            assert math.isclose(row["psi"], exact.psi[0], abs_tol=1e-9 * (1 + abs(exact.psi[0])))
            assert math.isclose(row["p_phi"], exact.p_phi[0], rel_tol=1e-12)
            assert math.isclose(row["p_psi"], exact.p_psi[0], rel_tol=1e-12)


@pytest.mark.parametrize("moments", [(1.3, 1.3, 0.7), (1.3, 1.1, 0.7)])
def test_friction_is_newtons_law_with_a_torque_against_omega(engine, tableau, moments):
    inertia, c, M, g, R, until = np.array(moments), 0.3, 0.8, 9.81, 0.6, 5.0
    start = {"theta": 0.5, "theta_dot": 0.2, "phi_dot": 0.6, "omega3": 12.0}
    setup = heavy(rt.FreeBody(*moments), M, g, (0, 0, R), friction=c, **start)
    first, last = sample(engine, setup, 0, until)

    def rates(t, state):
        turn = state[3:].reshape(3, 3)
        omega = turn @ (turn.T @ state[:3] / inertia)
        torque = np.cross(R * turn[:, 2], [0, 0, -M * g]) - c * omega
        return np.concatenate([torque, np.cross(omega, turn.T).T.ravel()])

    begun = np.concatenate([first["momentum"], first["rotation"]])
    exact = solve_ivp(rates, (0, until), begun, "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    assert np.allclose(last["momentum"], exact[:3], atol=1e-8)
    assert np.allclose(last["rotation"], exact[3:], atol=1e-8)
    # What friction takes is what the energy loses, and along e₃ of a symmetric top it is alone.
    assert first["energy"] - last["energy"] > 40
    assert math.isclose(last["energy"] + last["taken"], first["energy"], rel_tol=1e-12)
    [drift] = engine.run("m.drift()")
    assert (drift["name"], drift["most"] < 1e-12) == ("E + W", True)
    if moments[0] == moments[1]:
        assert math.isclose(last["omega"][2], 12 * math.exp(-c * until / 0.7), rel_tol=1e-12)


def test_a_top_runs_down_until_it_hangs(engine, tableau):
    setup = next(p.setup for p in PRESETS["heavy-top"]() if p.name == "running-down")
    rows = sample(engine, setup, 0, 5, 300)
    assert [round(math.degrees(row["theta"])) for row in rows] == [30, 34, 180]
    assert rows[1]["phi_dot"] > 1.3 * rows[0]["phi_dot"]  # it goes round faster as it slows
    assert engine.run("setup.values.friction = -1; try { startOf(setup) } catch (e) { e.message }",
                      setup=as_json(setup)) == "friction must not be negative"  # fmt: skip


@settings(**QUICK)
@given(
    st.floats(0, math.pi), st.floats(-3, 3), st.floats(-3, 3), st.floats(-6, 6),
    st.floats(-3, 3), st.floats(-20, 20),
)  # fmt: skip
def test_any_heavy_top(engine, tableau, theta, theta_dot, phi, phi_dot, psi, omega3):
    state = {
        "theta": theta, "theta_dot": theta_dot, "phi": phi, "phi_dot": phi_dot, "psi": psi,
        "omega3": omega3,
    }  # fmt: skip
    motion = TOP.motion(**state)
    (row,) = sample(engine, setup_of(motion), 1.3)
    # What grows near the upright grows by e^(1.3·2) at most here.
    exact = motion.exact([1.3])
    assert_same(row, exact, 1e-9)
    # Through the vertical φ goes by half a turn, either way.
    vertical = motion.regime in ("plane", "through the vertical")
    if min(math.sin(theta), math.sin(row["theta"])) > 1e-3 and not vertical:
        assert math.isclose(row["phi"], exact.phi[0], rel_tol=1e-6, abs_tol=1e-6)
        assert math.isclose(row["psi"], exact.psi[0], rel_tol=1e-6, abs_tol=1e-6)


@settings(**QUICK)
@given(
    st.lists(st.floats(-4, 4), min_size=3, max_size=3),
    st.lists(st.floats(-3, 3), min_size=3, max_size=3),
)
def test_any_free_body(engine, tableau, omega, angles):
    turn = Rotation.from_euler("ZYZ", angles)
    motion = rt.FreeBody(1.0, 1.7, 2.3).motion(omega=omega, attitude=turn)
    (row,) = sample(engine, setup_of(motion), 2.1)
    assert_same(row, motion.exact([2.1]), 1e-9)


@settings(**QUICK)
@given(
    st.lists(st.floats(-4, 4), min_size=3, max_size=3),
    st.lists(st.floats(-3, 3), min_size=3, max_size=3),
)
def test_any_heavy_body(engine, tableau, omega, angles):
    body = rt.HeavyBody(3.0, 2.0, 1.5, M=1.0, centre_of_mass=(0.2, 0.3, 0.4))
    motion = body.motion(omega=omega, attitude=Rotation.from_euler("ZYZ", angles))
    (row,) = sample(engine, setup_of(motion), 1.1)
    assert_same(row, motion.integrate([1.1], rtol=1e-13, atol=1e-14), 1e-9)


@pytest.mark.parametrize("theta", [0.0, math.pi])
def test_an_upright_body_that_is_pushed(engine, tableau, theta):
    turn = Rotation.from_euler("ZYZ", [0.3, theta, 0.4])
    motion = TOP.motion(attitude=turn, omega=(0.2, -0.5, 9.0))
    (start, row) = sample(engine, setup_of(motion), 0, 0.8)
    assert_same(start, motion.exact([0.0]), 1e-12)
    assert_same(row, motion.exact([0.8]), 1e-9)


@pytest.mark.parametrize("theta", [0.0, math.pi])
def test_a_vertical_body_at_rest_stays_exactly(engine, tableau, theta):
    (row,) = sample(engine, setup_of(TOP.motion(theta=theta, phi=0.3, psi=0.4, omega3=3.0)), 50.0)
    assert math.isclose(row["theta"], theta, abs_tol=1e-15)
    assert math.isclose(row["phi"], 0.3, abs_tol=1e-12)
    assert math.isclose(row["psi"], 150.4, rel_tol=1e-12)


def test_solver_steps_as_scipy_does(engine, tableau):
    # A step from the same state with the same coefficients is the same to rounding.
    rates = "(x, f) => { f[0] = x[1]; f[1] = -Math.sin(x[0]); }"
    found = engine.run(
        f"s = createSolver(tableau, {rates}, [1, 0.5], 0, 0.1, {{ rtol: 1e-9, atol: 1e-12 }});"
        "x = new Float64Array(2); s.step(); t = s.t; h = s.h;"
        "[t, h, ...[0.25, 0.5, 1].flatMap((part) => { s.at(part * t, x); return [...x]; })]"
    )

    def pendulum(_, x):
        return [x[1], -math.sin(x[0])]

    theirs = DOP853(pendulum, 0, [1, 0.5], 10, first_step=0.1, rtol=1e-9, atol=1e-12)
    theirs.step()
    dense = theirs.dense_output()
    expected = [theirs.t, theirs.h_abs]
    expected += [x for part in (0.25, 0.5, 1) for x in dense(part * theirs.t)]
    assert math.isclose(found[1], expected[1], rel_tol=1e-5)  # the error is itself near rounding
    assert np.allclose(found[2:], expected[2:], rtol=1e-13, atol=1e-15)
    assert found[0] == 0.1


def test_rewinding_meets_the_same_states(engine, tableau):
    setup = setup_of(TOP.motion(theta=0.5, omega3=12.0))
    there, back, again = sample(engine, setup, 8.0, 2.5, 8.0)
    once, twice = sample(engine, setup, 2.5, 8.0)
    assert np.allclose(back["rotation"], once["rotation"], atol=1e-10)
    assert np.allclose(again["rotation"], twice["rotation"], atol=1e-10)
    for angle in ("phi", "psi"):
        assert math.isclose(back[angle], once[angle], abs_tol=1e-10)
        assert math.isclose(again[angle], twice[angle], abs_tol=1e-10)
    assert np.allclose(there["rotation"], twice["rotation"], atol=1e-10)
    # The trail ends where the motion is, and the start is exact.
    assert engine.run("m.go(3); m.trail.at(-1).t <= 3 && m.trail.at(-1).t > 2.9") is True
    # What strayed on the way is not forgotten at t = 0, before which there is nothing.
    same, before, after = engine.run(
        "most = m.drift()[0].most; m.go(0); [m.now === m.start, most, m.drift()[0].most]"
    )
    assert same is True
    assert after >= before > 0
    said = engine.run("try { m.go(-1); '' } catch (error) { error.message }")
    assert said == "a time wants to be a number from 0 on"
    assert engine.run("m.reset(); [m.now === m.start, m.trail.length, m.drift()[0].most]") == [
        True, 1, 0
    ]  # fmt: skip


def test_the_trail_is_evenly_spaced_and_bounded(engine, tableau):
    setup = setup_of(TOP.motion(theta=0.5, omega3=40.0))
    (then,) = sample(engine, setup, 0.5)
    times = engine.run("m.trail.map((x) => x.t)")
    gaps = np.diff(times)
    assert len(gaps) > 50
    assert np.allclose(gaps, gaps[0], rtol=1e-9)
    assert engine.run("for (let k = 1; k < 80; k++) m.go(k); m.trail.length") <= 10_000
    # What it has forgotten is computed anew.
    forgotten, back = engine.run("first = m.trail[0].t; m.go(0.5); [first, m.now]")
    assert forgotten > 10
    assert np.allclose(back["rotation"], then["rotation"], atol=1e-10)
    assert math.isclose(back["phi"], then["phi"], abs_tol=1e-10)


@pytest.mark.parametrize("near", [3e-3, math.pi - 3e-3])
@pytest.mark.parametrize("phi_dot", [-400.0, -40.0, 3.0, 40.0, 400.0])
@pytest.mark.parametrize("omega3", [-9.0, 5.0])
def test_turns_are_counted_beside_the_vertical(engine, tableau, near, phi_dot, omega3):
    # φ goes round by nearly half a turn, or more, while the axis passes by.
    motion = TOP.motion(theta=near, theta_dot=-1.0, phi_dot=phi_dot, omega3=omega3)
    times = [0.01, 0.3, 2.0, 5.0]
    rows = sample(engine, setup_of(motion), *times)
    exact = motion.exact(times)
    assert np.allclose([row["phi"] for row in rows], exact.phi, atol=1e-6)
    assert np.allclose([row["psi"] for row in rows], exact.psi, atol=1e-6)


def test_ahead_ends_where_it_would_take_long(engine, tableau):
    setup = setup_of(TOP.motion(theta=0.5, omega3=12.0))
    times = sample(engine, setup, 0) and engine.run("m.ahead(Infinity, 5).map((x) => x.t)")
    assert times == pytest.approx(np.linspace(0, times[-1], 5))
    assert times[-1] == pytest.approx(2000 * engine.run("m.timescale"))
    short = engine.run("m.ahead(2, 3).map((x) => x.theta)")
    exact = TOP.motion(theta=0.5, omega3=12.0).exact([0.0, 1.0, 2.0])
    assert np.allclose(short, exact.theta, atol=1e-12)


def test_most_is_that_of_all_steps(engine, tableau):
    # Each time reached in one go: what strayed on the way counts, and not just where it ends.
    setup = setup_of(TOP.motion(theta=0.5, phi_dot=1.0, omega3=12.0))
    found = engine.run(
        "ACCURACY.rtol = ACCURACY.atol = 1e-4; m = createMotion(setup, tableau);"
        "seen = Array.from({ length: 30 }, (_, k) => { m.reset(); m.go((k + 1) / 4);"
        " const [drift] = m.drift(); return [drift.now, drift.most]; });"
        "ACCURACY.rtol = 2.5e-14; ACCURACY.atol = 1e-14; seen",
        setup=as_json(setup),
    )
    now, most = np.transpose(found)
    assert np.all(now <= most)
    assert np.any(now < most)
    assert not np.all(np.diff(now) >= 0)


def test_a_deadline_stops_between_two_steps(engine, tableau):
    setup = setup_of(TOP.motion(theta=0.5, omega3=12.0))
    reached, t = engine.run(
        "m = createMotion(setup, tableau); clock = 0; performance.now = () => clock++;"
        "r = m.go(1000, 20); performance.now = () => 0; [r, m.now.t]",
        setup=as_json(setup),
    )
    assert reached is False
    assert 0 < t < 1000
    (row,) = sample(engine, setup, t)
    assert math.isclose(engine.run("m.now.theta"), row["theta"], rel_tol=1e-12)


def test_drift_is_relative_to_the_energy_that_changes(engine, tableau):
    # An integration that is too coarse on purpose, so that there is something to compare.
    setup = setup_of(TOP.motion(theta=0.5, phi_dot=1.0, omega3=12.0))
    found = engine.run(
        "ACCURACY.rtol = 1e-4; ACCURACY.atol = 1e-4; m = createMotion(setup, tableau);"
        "for (let k = 1; k <= 100; k++) m.go(k / 10);"
        "ACCURACY.rtol = 2.5e-14; ACCURACY.atol = 1e-14; [m.drift(), m.now, m.start]",
        setup=as_json(setup),
    )
    drift, now, start = found
    kinetic = start["energy"] - TOP.weight[2] * math.cos(0.5)
    whole = kinetic + TOP.weight[2]
    # What the constant spin has of the energy would hide what the rest strays.
    scale = whole - TOP.lambda3 * 12.0**2 / 2
    assert [d["name"] for d in drift] == ["E", "p_phi", "p_psi"]
    assert [d["exact"] for d in drift] == [False, False, True]
    change = abs(now["energy"] - start["energy"])
    assert change > 1e-9
    assert math.isclose(drift[0]["now"], change / scale, rel_tol=1e-9)
    assert drift[0]["most"] >= drift[0]["now"]
    momentum = math.sqrt(2 * TOP.lambda1 * whole)
    change = abs(now["p_phi"] - start["p_phi"])
    assert math.isclose(drift[1]["now"], change / momentum, rel_tol=1e-9)


@pytest.mark.parametrize(
    ("setup", "says"),
    [
        (free((1.0, 1.0, 3.0), (0, 0, 1)),
         "λ₁ = 1 kg m² is too small for λ₃ = 3 kg m²: it must be at least λ₃/2 = 1.5 kg m²"),
        (heavy(rt.FreeBody(1, 1, 0.5), 1.0, 9.81, (0, 0, 0.9)),
         "λ₁ = 1 kg m² is too small for λ₃ = 0.5 kg m²: it must be at least MR² + λ₃/2 = 1.06"),
        (heavy(rt.FreeBody(1, 1.2, 0.5), 1.0, 9.81, (0, 0, 0.95)), "about the centre of mass"),
        (heavy(rt.FreeBody(1, 1, 0.5), 1.0, -1.0, (0, 0, 0)), "g must not be negative"),
        (heavy(rt.FreeBody(1, 1, 0.5), -1.0, 1.0, (0, 0, 0)), "must be positive"),
        (heavy(rt.FreeBody(1, 1, 0.5), math.nan, 1.0, (0, 0, 0)), "numbers that are finite"),
    ],
)  # fmt: skip
def test_what_is_no_body_is_refused_in_one_sentence(engine, tableau, setup, says):
    values = {k: None if math.isnan(v) else v for k, v in setup.values.items()}
    found = engine.run(
        "for (const k in values) if (values[k] === null) values[k] = NaN;"
        "try { createMotion({ kind, clock: 's', values }, tableau); '' } catch (e) { e.message }",
        values=values,
        kind=setup.kind,
    )
    assert says in found
    assert "\n" not in found


@settings(max_examples=80)
@given(
    *[st.floats(0.2, 3.0)] * 3,
    st.floats(0.1, 2.0),
    *[st.sampled_from([0.0, 0.1, 0.35, 0.6, 0.9])] * 3,
)
def test_the_page_refuses_just_the_bodies_that_python_refuses(
    engine, tableau, lambda1, lambda2, lambda3, M, x, y, z
):
    try:
        body = rt.HeavyBody(lambda1, lambda2, lambda3, M=M, centre_of_mass=(x, y, z))
    except rt.RigidtopError:
        body = None
    setup = heavy(rt.FreeBody(1, 1, 1), M, 9.81, (x, y, z))
    moments = {"lambda1": lambda1, "lambda2": lambda2, "lambda3": lambda3}
    found = engine.run(
        "try { createMotion({ kind: 'heavy-top', clock: 's', values }, tableau); true }"
        " catch (e) { false }",
        values={**setup.values, **moments},
    )
    assert found is (body is not None)
