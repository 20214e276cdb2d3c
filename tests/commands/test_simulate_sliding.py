"""`rigidtop simulate sliding`: options, columns, events, and one line where they make no sense."""

import json

import numpy as np
import pytest

import rigidtop as rt
from rigidtop.cli import main

RAISED = ["--theta", "0.3", "--omega3", "60", "--tip", "0.1", "--mu", "0.3"]


def simulate(capsys, *options):
    """Exit code, stdout and stderr."""
    try:
        code = main(["simulate", "sliding", *options])
    except SystemExit as stopped:
        code = stopped.code
    return code, *capsys.readouterr()


def test_json_is_the_motion(capsys):
    code, out, err = simulate(capsys, *RAISED, "--samples", "5", "--json")
    assert (code, err) == (0, "")
    found = json.loads(out)
    top = rt.SlidingTop(lambda1=0.75, lambda3=0.5, M=1.0, R=0.5, tip=0.1, mu=0.3)
    run = top.motion(theta=0.3, omega3=60.0).integrate(np.linspace(0, 10, 5))
    columns = found["columns"]
    for name, wanted in (
        ("t/s", run.t),
        ("theta/rad", run.theta),
        ("x/m", run.position[:, 0]),
        ("z/m", run.position[:, 2]),
        ("slip_y/(m/s)", run.slip[:, 1]),
        ("rolling", run.rolling),
        ("normal_force/N", run.normal_force),
        ("dissipated/J", run.dissipated_by_friction),
    ):
        assert columns[name] == wanted.tolist(), name
    assert found["events"] == [{"time": run.events[0].time, "kind": "standstill"}]
    assert found["ended"] is None
    assert found["budget"] < 1e-8


def test_a_smooth_table_has_the_closed_form(capsys):
    start = ["--theta", "30deg", "--phi-dot", "1", "--velocity", "0.1", "0", "--samples", "3"]
    values = []
    for method in ([], ["--method", "DOP853", "--rtol", "1e-12"]):
        code, out, _ = simulate(capsys, *start, *method, "--json")
        assert code == 0
        values.append(json.loads(out)["columns"])
    assert values[0]["x/m"] == pytest.approx([0, 0.5, 1])
    for name, column in values[0].items():
        assert column == pytest.approx(values[1][name], abs=1e-7), name


def test_csv(capsys, tmp_path):
    file = tmp_path / "run.csv"
    code, out, _ = simulate(capsys, *RAISED, "--drag3", "0.01", "--samples", "4", "-o", str(file))
    assert code == 0
    assert out.splitlines()[0] == str(file)
    head, *rows = file.read_text("utf-8").splitlines()
    assert head.split(",")[-1] == "dissipated/J"
    assert len(rows) == 4
    assert float(rows[-1].split(",")[-1]) > 1


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--steady", "slow"], "--steady does not go with `simulate sliding`"),
        (["--moments", "1", "2", "3"], "--moments does not go with `simulate sliding`"),
        (["--mu", "-1"], "mu must be zero or positive, not -1"),
        (["--mu", "1", "--method", "exact"], "no closed form: friction or air take energy"),
        (["--mu", "1", "--method", "taylor"], "Taylor series do not see friction"),
        (["--mu", "1", "--time", "-1"], "t must not be negative"),
        (["--rtol", "1e-8"], "--rtol is for integration: give a --method too"),
        (["--theta", "2"], "theta = 2 is no start"),
        (["--slip", "0", "0", "--velocity", "0", "0"], "not allowed with"),
        (["--time", "0"], "--time 0 leaves nothing to compute"),
    ],
)
def test_bad_input_is_one_line(capsys, options, message):
    code, out, err = simulate(capsys, *options)
    assert (code, out) == (2, "")
    assert message in err
    assert len(err.splitlines()) == 1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["certify", "sliding"], "invalid choice: 'sliding'"),
        (["certify", "top", "--mu", "1"], "unrecognized arguments"),
        (["simulate", "top", "--mu", "1"], "--mu does not go with `simulate top`"),
        (["simulate", "top", "--slip", "0", "0"], "--slip does not go with `simulate top`"),
        (
            ["simulate", "free", "--moments", "1", "2", "3", "--omega", "1", "1", "1", "--tip=1"],
            "--tip does not go with `simulate free`",
        ),
        (
            ["sweep", "-o", "nowhere/x.npy", "--axis", "mu=0,1"],
            "mu",
        ),
    ],
)
def test_what_cannot_slide_says_so(capsys, arguments, message):
    try:
        code = main(arguments)
    except SystemExit as stopped:
        code = stopped.code
    out, err = capsys.readouterr()
    assert (code, out) == (2, "")
    assert message in err
    assert len(err.splitlines()) == 1


def test_friction_goes_on_when_rtol_is_given_alone(capsys):
    code, *_ = simulate(capsys, *RAISED, "--rtol", "1e-8", "--time", "1", "--samples", "2")
    assert code == 0
