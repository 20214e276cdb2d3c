"""`rigidtop figure` on parsed options: what it writes, and what it refuses."""

import argparse
import json
import re

import pytest

from rigidtop.cli import main
from rigidtop.commands import figure
from rigidtop.errors import RigidtopError
from rigidtop.figures.catalog import FIGURES
from rigidtop.figures.drawing import KINDS, rendered
from rigidtop.proof.words import unmarked
from rigidtop.terminal.table import columns


def run(*arguments):
    parser = argparse.ArgumentParser(exit_on_error=False)
    parser.add_argument("--json", action="store_true")
    figure.add_options(parser)
    return figure.run(parser.parse_args(arguments))


@pytest.fixture(autouse=True)
def in_an_empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("width", [80, 120])
def test_list_names_every_figure(width, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(width))
    assert run() == 0
    shown = capsys.readouterr().out
    assert max(map(columns, shown.splitlines())) <= width
    of_each = re.split(r"^(?=\S)", shown, flags=re.MULTILINE)[1:]
    assert len(of_each) == len(FIGURES)
    assert "$" not in shown
    for drawing, block in zip(FIGURES, of_each, strict=True):
        name, words = block.split(maxsplit=1)
        assert name == drawing.name
        assert " ".join(words.split()).startswith(unmarked(drawing.title))
        below = block.splitlines()[1:]
        defaults = " ".join(line.strip() for line in below if re.match(r" {4}\S", line))
        assert defaults.split() == [f"{p.name}={p.default:.4g}" for p in drawing.parameters]


def test_list_as_json(capsys):
    assert run("--json") == 0
    records = json.loads(capsys.readouterr().out)
    assert [record["name"] for record in records] == [drawing.name for drawing in FIGURES]
    assert not any("$" in record["title"] for record in records)
    assert {kind for record in records for kind in record["kinds"]} <= {*KINDS, "gif", "mp4"}
    [paths] = [record for record in records if record["name"] == "paths"]
    assert {"name": "omega3", "default": 40.0, "unit": "rad/s", "about": "ω₃"} in paths[
        "parameters"
    ]


@pytest.mark.parametrize(
    ("suffix", "opening"),
    [("svg", b"<?xml"), ("pdf", b"%PDF-"), ("png", b"\x89PNG"), ("PNG", b"\x89PNG")],
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
        (("cones", "--set", "theta=1"), "no parameter 'theta'; there are lambda1, lambda3,"),
        (("cones", "--set", "lambda1"), "'lambda1' is not of the form name=value"),
        (("cones", "--set", "lambda1=-1"), "lambda1 must be more than 0 kg m², not -1"),
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


def test_the_angles_of_a_figure_are_those_of_its_notation(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for asked in ([], ["--set", "phi=60deg"]):
        assert main(["figure", "euler-angles", *asked, "--notation", "goldstein"]) == 0
        assert "here 60°, 45° and 45°" in capsys.readouterr().out
