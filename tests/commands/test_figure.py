"""`rigidtop figure` on parsed options: what it writes, and what it refuses."""

import argparse
import json
import re

import pytest

from rigidtop.commands import figure
from rigidtop.errors import RigidtopError
from rigidtop.figures.catalog import FIGURES
from rigidtop.figures.drawing import rendered


def run(*arguments):
    parser = argparse.ArgumentParser(exit_on_error=False)
    parser.add_argument("--json", action="store_true")
    figure.add_options(parser)
    return figure.run(parser.parse_args(arguments))


@pytest.fixture(autouse=True)
def in_an_empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize(
    ("suffix", "opening"),
    [("svg", b"<?xml"), ("pdf", b"%PDF-"), ("PNG", b"\x89PNG")],
)
def test_kind_by_suffix(suffix, opening, tmp_path, capsys):
    assert run("effective-potential", "-o", f"new/figure.{suffix}") == 0
    path = tmp_path / "new" / f"figure.{suffix}"
    assert path.read_bytes().startswith(opening)
    assert capsys.readouterr().out.startswith(f"new/figure.{suffix}\nThe effective potential")
    assert [p.name for p in path.parent.iterdir()] == [path.name]  # nothing half-written is left


def test_svg_by_default_and_settings(tmp_path, capsys):
    assert run("--json", "--set", "theta=30deg", "omega3 = 600rpm", "paths") == 0
    record = json.loads(capsys.readouterr().out)
    assert record["file"] == "paths.svg"
    assert record["parameters"]["theta"] == pytest.approx(0.5235987755982988)
    assert record["parameters"]["omega3"] == pytest.approx(62.83185307179586)
    assert "θ = 30° and ω₃ = 62.8 rad/s" in record["caption"]
    [drawing] = [drawing for drawing in FIGURES if drawing.name == "paths"]
    assert (tmp_path / "paths.svg").read_bytes() == rendered(drawing, "svg", record["parameters"])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("cone",), "no figure 'cone'; did you mean cones"),
        (("cones", "-o", "x.jpg"), "--output wants a file with the suffix .svg, .pdf, .png, .gif"),
        (("cones", "-o", "x"), "and 'x' has none"),
        (
            ("cones", "-o", "x.gif"),
            "cones does not move: write it as .svg, .pdf or .png (what moves:",
        ),
        (("cones", "--frames", "5"), "--frames goes with a .gif or .mp4, not with a .svg"),
        (("cones", "--seconds", "5"), "--seconds goes with a .gif or .mp4, not with a .svg"),
        (("top", "-o", "x.gif", "--seconds", "5", "--frames", "9"), "both say how long it is"),
        (("cones", "--dpi", "90"), "--dpi goes with a .png, .gif or .mp4: a .svg has no dots"),
        (
            ("cones", "-o", "x.png", "--dpi", "1200", "--width", "50"),
            "a row of 23622 dots is too long: at most 10000",
        ),
        (("cones", "--set", "lambda3=9"), "lambda3 = 9 exceeds the sum of the other two moments"),
        (("precession-rates", "--set", "omega3=1"), "|omega3| must be at least"),
        (("-o", "x.svg"), "which figure?"),
        (("--set", "theta=1"), "which figure?"),
        (("--set", "theta=1", "paths", "top"), "one figure at a time: paths top are too many"),
    ],
)
def test_refusals_are_one_line(arguments, message, tmp_path):
    with pytest.raises(RigidtopError, match=re.escape(message)) as refusal:
        run(*arguments)
    assert "\n" not in str(refusal.value)
    assert list(tmp_path.iterdir()) == []


def test_a_film(tmp_path, capsys):
    assert run("top", "-o", "top.gif", "--frames", "3", "--json") == 0
    record = json.loads(capsys.readouterr().out)
    assert record["frames"] == 3
    assert (tmp_path / "top.gif").read_bytes().startswith(b"GIF89a")
    assert [path.name for path in tmp_path.iterdir()] == ["top.gif"]


def test_a_figure_as_wide_and_as_fine_as_is_asked(tmp_path):
    assert run("paths", "-o", "paths.svg", "--width", "12.7") == 0
    wide = re.search(
        rb'width="([\d.]+)pt" height="([\d.]+)pt"', (tmp_path / "paths.svg").read_bytes()
    )
    assert float(wide[1]) == pytest.approx(360)
    assert run("paths", "-o", "paths.png", "--width", "12.7", "--dpi", "100") == 0
    header = (tmp_path / "paths.png").read_bytes()[16:20]
    assert int.from_bytes(header, "big") == 500


def test_a_film_as_long_and_as_fine_as_is_asked(tmp_path, capsys):
    size = ("--seconds", "0.2", "--width", "5.08", "--dpi", "50")
    assert run("top", "-o", "top.gif", *size, "--json") == 0
    assert json.loads(capsys.readouterr().out)["frames"] == 4
    content = (tmp_path / "top.gif").read_bytes()
    assert int.from_bytes(content[6:8], "little") == 100
    assert content.count(b"\x21\xf9\x04") == 4


def test_a_number_out_of_range_is_told_with_the_range():
    for option, text, said in (("--width", "1", "2 to 50"), ("--seconds", "x", "0.1 to 100")):
        with pytest.raises(argparse.ArgumentError, match=f"not a number from {said}"):
            run("cones", option, text)


def test_a_folder_that_cannot_be_written(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(RigidtopError, match="is not a folder"):
        run("cones", "-o", "file/cones.svg")


def test_frames_are_a_whole_number():
    for text in ("1", "x", "1e3", "99999"):
        with pytest.raises(argparse.ArgumentError, match="not a whole number from 2"):
            run("cones", "--frames", text)


def test_a_figure_in_another_notation(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert run("torque", "--notation", "landau", "-o", "torque.svg") == 0
    caption = capsys.readouterr().out
    assert caption.startswith("torque.svg\nThe torque K = R_CM × μg of the weight")
    with pytest.raises(RigidtopError, match=r"--notation goes with .* not with a .gif"):
        run("rolling-cones", "--notation", "landau", "-o", "cones.gif")
