"""Simulators against the exact motions: known orders, wrong ones that are seen, exact digits."""

import json

import numpy as np
import pytest
import referee


def _chosen(*names):
    return [s for s in referee.settings() if (s.engine, s.integrator) in names]


def test_orders_are_those_of_the_integrators():
    pytest.importorskip("mujoco")
    first, fourth = ("MuJoCo", "Euler"), ("MuJoCo", "RK4")
    for score in referee.judge(_chosen(first, fourth)):
        assert score.order == pytest.approx(1 if score.integrator == "Euler" else 4, abs=0.1)
        assert score.errors[2] < (0.02 if score.integrator == "Euler" else 1e-7)


def test_pinocchio_is_of_first_order():
    pytest.importorskip("pinocchio")
    for score in referee.judge(_chosen(("Pinocchio", "aba, semi-implicit Euler"))):
        assert score.order == pytest.approx(1, abs=0.1)
        assert score.errors[2] < 0.02


@pytest.mark.parametrize(
    ("module", "engine", "integrator", "order", "error"),
    [
        ("pydrake", "Drake", "semi_explicit_euler", 1, 0.2),
        ("pydrake", "Drake", "runge_kutta2", 2, 2e-3),
        ("pydrake", "Drake", "runge_kutta3", 3, 1e-5),
        ("exudyn", "Exudyn", "generalised alpha", 2, 1e-3),
        ("pybullet", "PyBullet", "multibody", 1, 0.05),
    ],
)
def test_engines_that_are_seldom_installed(module, engine, integrator, order, error):
    pytest.importorskip(module)
    for score in referee.judge(_chosen((engine, integrator))):
        assert score.order == pytest.approx(order, abs=0.1)
        assert score.errors[2] < error


def test_a_wrong_engine_is_far_off():
    def still(case, step):
        return np.tile(case.quaternion, (len(case.times), 1))

    wrong = referee.Setting("none", "numpy", "stands still", 0.1, still)
    for score in referee.judge([wrong]):
        assert min(score.errors) > 1
        assert not score.order > 0.1


def test_what_is_not_installed_is_said():
    absent = referee.Setting("Absent", "absent_engine", "any", 0.1, lambda case, step: None)
    assert "absent_engine is not installed" in referee.table(referee.judge([absent]))


def test_reference_digits(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", ["referee.py", "-o", str(tmp_path / "exact")])
    referee.main()
    assert capsys.readouterr().out.split() == [
        str(tmp_path / "exact" / f"{name}.json") for name in ("heavy_top", "free_body")
    ]
    for case in referee.cases():
        path = tmp_path / "exact" / f"{case.name.replace(' ', '_')}.json"
        told = json.loads(path.read_text("utf-8"))
        rows = np.array(told["rows"])
        solved = case.motion.integrate(rows[:, 0], rtol=3e-14, atol=1e-14)
        assert np.max(np.abs(rows[:, 5:] - solved.omega)) < 1e-10
        turned = solved.rotation.as_quat(canonical=True)[:, [3, 0, 1, 2]]
        assert np.max(np.abs(np.abs(np.sum(turned * rows[:, 1:5], axis=1)) - 1)) < 1e-12
        assert np.allclose(told["moments_about_joint"], case.motion.body.moments)
