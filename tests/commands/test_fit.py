"""`rigidtop fit`: tables as apps write them, and one line for those that are none."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import rigidtop as rt
from rigidtop.cli import main
from rigidtop.commands.recording import recording

MADE = Path(__file__).parents[2] / "notebooks" / "data" / "thrown-phone.csv"
T = np.arange(0, 0.8, 0.02)
OMEGA = rt.FreeBody(1.0, 4.1, 4.9).motion(omega=(1.5, 11.0, 2.0)).exact(T).omega
PHYPHOX = ["Time (s)", *(f"Gyroscope {axis} (rad/s)" for axis in "xyz")]


def table(head, columns, separator=",", decimal="."):
    rows = [separator.join(f'"{name}"' for name in head)]
    for row in zip(*columns, strict=True):
        rows.append(separator.join(f"{x:.9f}".replace(".", decimal) for x in row))
    return "\n".join(rows) + "\n"


def fit(capsys, *words):
    """Exit code, stdout and stderr."""
    try:
        code = main(["fit", *map(str, words)])
    except SystemExit as stopped:
        code = stopped.code
    return code, *capsys.readouterr()


X, Y, Z = OMEGA.T
APPS = {
    "phyphox": table(PHYPHOX, (T, X, Y, Z)),
    "semicolons and decimal commas": table(PHYPHOX, (T, X, Y, Z), ";", ","),
    "tabs and decimal commas": table(PHYPHOX, (T, X, Y, Z), "\t", ","),
    "Sensor Logger": table(
        ("time", "seconds_elapsed", "z", "y", "x"), (T * 1e9 + 1.7e18, T, Z, Y, X)
    ),
    "degrees": table(
        ("Time (ms)", *(f"gyro_{axis} [deg/s]" for axis in "xyz")),
        (T * 1e3, *np.degrees(OMEGA.T)),
    ),
    "with an accelerometer": table(
        ("t (s)", "Acceleration x (m/s^2)", *PHYPHOX[1:], "Absolute (rad/s)"), (T, T, X, Y, Z, T)
    ),
    "rigidtop": rt.FreeBody(1.0, 4.1, 4.9).motion(omega=OMEGA[0]).exact(T).to_csv(),
}


@pytest.mark.parametrize("app", APPS)
def test_tables_of_apps(app, tmp_path):
    file = tmp_path / "data.csv"
    file.write_text("# a note\n\n" + APPS[app], "utf-8-sig")
    data = recording(str(file), -math.inf, math.inf)
    np.testing.assert_allclose(data.t, T, atol=1e-6)
    np.testing.assert_allclose(data.columns["omega"], OMEGA, atol=1e-6)


def test_a_fit_as_a_record(tmp_path, capsys):
    file = tmp_path / "data.csv"
    file.write_text(APPS["phyphox"], "utf-8")
    code, out, err = fit(capsys, file, "--json")
    assert (code, err) == (0, "")
    record = json.loads(out)
    assert record["values"]["lambda2"] == pytest.approx(4.1, rel=1e-5)
    assert record["values"]["lambda3"] == pytest.approx(4.9, rel=1e-5)
    assert record["rows"] == len(T)
    assert np.shape(record["covariance"]) == (8, 8)


def test_a_top(tmp_path, capsys):
    top = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
    run = top.motion(theta=0.5, phi_dot=0.5, omega3=20.0).exact(np.linspace(0, 2, 80))
    file = tmp_path / "top.csv"
    file.write_text(
        table(
            ("t (s)", "theta (deg)", "phi (deg)"),
            (run.t, np.degrees(run.theta), np.degrees(run.phi)),
        )
    )
    code, out, _ = fit(capsys, file)
    assert code == 0
    assert "λ₃ω₃/λ₁" in out
    assert "λ₁, λ₃ and M by themselves cannot be known" in out


def test_a_table_and_a_figure(tmp_path, capsys):
    file = tmp_path / "fit.pdf"
    code, out, _ = fit(capsys, MADE, "-o", file, "--lambda1", "1.1e-4", "--to", "0.6")
    assert code == 0
    assert file.read_bytes().startswith(b"%PDF")
    assert "λ₁    0.00011    given  kg m²\n" in out
    assert "61 rows, short axis" in out
    assert out.endswith("fit.pdf\n")


ROWS = table(PHYPHOX, (T, X, Y, Z))


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "has no rows"),
        ("a,b\n1,2\n", "needs columns for the time and for x, y, z of a gyroscope, such as"),
        (ROWS + "1,2\n", "line 42 has 2 cells, too few"),
        (ROWS + "1,2,fast,4\n", "line 42: 'fast' under omega1 is no number"),
        (ROWS + "0.1,2,3,4\n", "the time goes from 0.78 to 0.1 s, not on"),
        (ROWS.replace("1.500000000", "nan"), "omega must be finite"),
        (ROWS.replace("1.500000000", "1e90"), "fit"),
        ("\n".join(ROWS.splitlines()[:4]), "3 rows are too few"),
        ("\0", "is not text"),
        (ROWS + '"open', "is no table: unexpected end of data"),
        (" " * 200_000 + "\n1\n", "has no rows"),
        ("(" * 100_000 + "\n1\n", "needs columns"),
        (table(PHYPHOX, (T, 0 * T, 0 * T + 9, 0 * T)), "moments cannot be known from this"),
    ],
)
def test_a_bad_file_is_one_line(text, says, tmp_path, capsys):
    file = tmp_path / "data.csv"
    file.write_text(text, "utf-8")
    code, out, err = fit(capsys, file)
    assert (code, out) == (2, "")
    assert says in err
    assert err.count("\n") == 1


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["nowhere.csv"], "cannot read nowhere.csv"),
        ([MADE, "--from", "2"], "it goes from 0 to 0.79 s"),
        ([MADE, "-o", "fit.gif"], "suffix .svg, .pdf or .png"),
        ([MADE, "--lambda1", "-1"], "lambda1 must be positive"),
        ([MADE, "--from", "soon"], "must be a number"),
    ],
)
def test_bad_words_are_one_line(words, says, capsys):
    code, out, err = fit(capsys, *words)
    assert (code, out) == (2, "")
    assert says in err
    assert err.count("\n") == 1
