"""Systems and trajectories show themselves, and write themselves for other tools."""

import csv
import io

import numpy as np
import pytest
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m, length, g = symbols("m length g", positive=True)
first, second, third = dynamicsymbols("theta1 theta2 theta3")
near = [length * sin(first), -length * cos(first)]
far = [near[0] + length * sin(second), near[1] - length * cos(second)]
PENDULUM = rt.System.of_parts([rt.Mass(m, near), rt.Mass(m, far)], [first, second], gravity=[0, -g])
RUN = PENDULUM.motion({m: 1, length: 1, g: 9.81}, [1.0, 0.5]).integrate((0, 2))
TOP = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5).motion(theta=0.5, omega3=40.0)
FREE = rt.FreeBody(1.0, 2.0, 2.5).motion(omega=(0.1, 1.0, 0.2))
SLIDING = rt.SlidingTop(lambda1=0.75, lambda3=0.5, M=1.0, R=0.5, tip=0.1, mu=0.3)
EACH = {
    "system": RUN,
    "top": TOP.exact((0, 2)),
    "free": FREE.integrate([0.0, 1.0, 2.0]),
    "sliding": SLIDING.motion(theta=0.3, omega3=60.0).integrate([0.0, 0.1]),
}


@pytest.fixture(params=EACH)
def rows(request):
    return EACH[request.param]


def test_rows_are_counted_and_given(rows):
    assert len(rows) == len(rows.t) == len(list(rows))
    row = list(rows)[-1]
    assert row["t"] == rows.t[-1]
    assert row["energy"] == rows.energy[-1]


def test_equal_are_those_with_equal_columns(rows):
    assert rows == rows
    assert rows != EACH["top" if rows is not EACH["top"] else "free"]
    assert EACH["top"] == TOP.exact((0, 2))
    assert EACH["top"] != TOP.exact((0, 3))
    assert EACH["top"] != "top"


def test_csv_has_all_digits(rows):
    header, *lines = csv.reader(io.StringIO(rows.to_csv()))
    assert header[0] == "t/s"
    for column, values in zip(zip(*lines, strict=True), rows.columns().values(), strict=True):
        assert np.array_equal(np.array(column, dtype=float), values)


def test_csv_into_a_file(tmp_path):
    text = RUN.to_csv(tmp_path / "run.csv")
    assert (tmp_path / "run.csv").read_text("utf-8") == text
    with pytest.raises(rt.RigidtopError, match="cannot write"):
        RUN.to_csv(tmp_path / "run.csv" / "run.csv")


def test_pandas_and_xarray(rows):
    pytest.importorskip("xarray")
    frame, data = rows.to_pandas(), rows.to_xarray()
    assert frame.attrs["units"]["t"] == "s"
    assert np.array_equal(frame["energy"].to_numpy(), rows.energy)
    assert np.array_equal(data["energy"].values, rows.energy)
    assert data.sizes == {"t": len(rows)}


def test_what_is_not_installed_is_said(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(rt.RigidtopError, match="pandas is not installed: pip install pandas"):
        RUN.to_pandas()


def test_reprs_are_short(rows):
    assert repr(rows).startswith(f"<{type(rows).__name__}: {len(rows)} rows, t = 0 … ")
    assert len(repr(rows)) < 300
    assert rows._repr_html_().count("<tr>") == min(len(rows), 8) + 1
    assert repr(PENDULUM) == "<System in theta1, theta2; parameters g, length, m>"


def test_a_system_shows_its_equations():
    k = symbols("k", positive=True)
    x, v = symbols("x v", real=True)
    spring = rt.System(m * v**2 / 2 - k * x**2 / 2, x, v)
    assert spring._repr_latex_().startswith(r"$$\begin{aligned}\mathcal{L} &= ")
    assert r"\ddot{x} &= -\frac{kx}{m}" in spring.latex()


def test_plots_have_the_values(rows):
    axes = rows.plot()
    assert len(axes.lines) == len(rows.plotted)
    assert np.array_equal(axes.lines[0].get_xdata(), np.sort(rows.t))
    energy = rows.plot("energy")
    assert np.array_equal(energy.lines[0].get_ydata(), rows.energy)
    assert energy.get_ylabel() == ("energy" if rows is RUN else "energy (J)")
    with pytest.raises(rt.RigidtopError, match="no column 'height'"):
        rows.plot("height")


def test_a_phase_portrait():
    axes = RUN.plot(("theta1", "theta1_dot"), axes=RUN.plot(("theta2", "theta2_dot")))
    assert np.array_equal(axes.lines[1].get_xdata(), RUN.q[:, 0])
    assert np.array_equal(axes.lines[1].get_ydata(), RUN.qdot[:, 0])


def test_parts_are_where_they_are():
    places = RUN.places()
    assert places.shape == (2, 501, 3)
    assert np.allclose(np.linalg.norm(places[0], axis=1), 1)
    assert np.allclose(np.linalg.norm(places[1] - places[0], axis=1), 1)
    with pytest.raises(rt.RigidtopError, match="not made of masses and bodies"):
        rt.System(m * first.diff() ** 2, first).motion({m: 1}, 0).integrate([1.0]).places()


def test_a_film(tmp_path):
    path = tmp_path / "run.gif"
    RUN.animate(str(path), duration=0.2)
    assert path.read_bytes().startswith(b"GIF8")
    with pytest.raises(rt.RigidtopError, match=r"a film is a \.gif or an \.mp4"):
        RUN.animate(str(tmp_path / "run.png"))
    with pytest.raises(rt.RigidtopError, match="cannot be written"):
        RUN.animate(str(tmp_path / "nowhere" / "run.gif"), duration=0.1)


def test_rods_are_what_keeps_its_length():
    from rigidtop.figures.trajectories import _rods

    assert len(_rods(RUN.places())) == 2
    apart = RUN.places() * np.linspace(1, 2, 501)[:, None]
    assert _rods(apart) == []


def test_rates_are_spelled_as_those_of_a_top():
    motion = PENDULUM.motion({m: 1, length: 1, g: 9.81}, [1.0, 0.5], {"theta2_dot": 2})
    assert repr(motion) == "SystemMotion(theta1=1, theta2=0.5, theta1_dot=0, theta2_dot=2)"
    assert motion.qdot == (0, 2)
    assert "theta2_dot" in next(iter(RUN))
    made = PENDULUM.source("julia")
    assert "theta2_dot" in made
    assert "theta2_ddot" in made
    assert "θ̇₂" in made
    with pytest.raises(rt.RigidtopError, match="which is none of theta1_dot, theta2_dot"):
        PENDULUM.motion({m: 1, length: 1, g: 9.81}, [1.0, 0.5], {"theta3_dot": 2})


def test_notebooks_see_systems_and_motions():
    k = symbols("k", positive=True)
    x, v = symbols("x v", real=True)
    spring = rt.System(m * v**2 / 2 - k * x**2 / 2, x, v)
    assert spring._repr_html_().startswith("<p>&lt;System in x; parameters k, m&gt;</p>")
    assert "; ẍ = −kx/m" in spring._repr_html_()
    assert "<td>1.5</td>" in spring.motion({m: 2, k: 1.5}, 1)._repr_html_()
    assert "θ̈₂ = " in PENDULUM._repr_html_()
    low = [far[0] + length * sin(third), far[1] - length * cos(third)]
    bobs = [rt.Mass(m, place) for place in (near, far, low)]
    triple = rt.System.of_parts(bobs, [first, second, third], gravity=[0, -g])
    assert "θ̈₃" not in triple._repr_html_()  # long
    singular = rt.System(m * v + x**2, x, v)
    assert repr(spring.small({x: 0})) == "<Small deviations of x>"
    assert np.array_equal(RUN["theta2_dot"], RUN.qdot[:, 1])
    assert singular.latex() == r"\begin{aligned}\mathcal{L} &= mv + x^{2}\end{aligned}"
