"""The lecture as a document: what it says, how it is written, and that files are whole."""

import io
import os
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from datetime import date
from pathlib import Path
from xml.etree import ElementTree

import pypdf
import pytest
from sympy import Integer, Ne, Rational, cos, sin, sqrt

from rigidtop.errors import RigidtopError
from rigidtop.proof import verdict
from rigidtop.proof.counterexample import Counterexample
from rigidtop.proof.equation import Equation, as_printed
from rigidtop.proof.page import (
    Assumption,
    Check,
    Claim,
    Correction,
    Definition,
    Measure,
    Page,
    Step,
)
from rigidtop.proof.verdict import Finding, Judgement, Verdict
from rigidtop.report import html, pdf, plain, tex, typst
from rigidtop.report.blocks import (
    Document,
    Figure,
    Look,
    Paragraph,
    Table,
)
from rigidtop.report.claims import claim_blocks
from rigidtop.report.lecture import Edition, Wanted, fragment, write_lecture
from rigidtop.report.record import document
from rigidtop.terminal import files
from rigidtop.theory.symbols import (
    L3,
    L_z,
    Omega,
    inertia,
    lambda1,
    lambda3,
    omega3,
    phidot,
    psidot,
    theta,
    thetaddot,
)
from rigidtop.typeset import nodes as lay
from rigidtop.typeset.text import text

SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="9pt"><g id="a"><use href="#a"/></g></svg>'
FIGURE = Figure("small", "The caption of λ₁.", 'A "quoted" thing & more.', 1)


def _claim(name: str, says: str, reason: str = "") -> Claim:
    return Claim(name, says, reason=reason)


@pytest.fixture(scope="session")
def judged(printed):
    """Three claims by hand: one assuming in three lines, one false, one proved with a measure."""
    lines = [printed[number] for number in ("3.57a", "3.57b", "3.57")]
    lines = [Equation(*line.sides, tag="3.57" if i == 2 else "") for i, line in enumerate(lines)]
    tilted = Assumption(Ne(sin(theta), 0), "the top is not upright")
    spinning = Assumption(Ne(omega3, 0), stated=True)
    at = Counterexample({theta: Integer(0), Omega: Rational(1, 2)}, Integer(0), sqrt(2) * 7**5 / 49)
    quadratic = Judgement(
        _claim("3.57", "Steady precession & its rate.", "The factor sin θ is divided out (100 %)."),
        "3.5.3",
        Verdict.ASSUMING,
        (
            Finding(Check(lines[0], reason="$θ̈ = 0$ in (3.54)"), Verdict.PROVED),
            Finding(
                Check(lines[1], {psidot: omega3 - Omega * cos(theta)}, given=(thetaddot,)),
                Verdict.ASSUMING,
                (verdict.TestedAssumption(tilted, at), verdict.TestedAssumption(spinning, at)),
            ),
            Finding(Check(lines[2]), Verdict.PROVED),
            Step(printed["3.54"], "Lagrange's equation of (3.53)."),
            Measure("θ held over 100 turns", 1.6e-12, 1e-9),
        ),
        0.1,
    )
    with as_printed():
        wrong = Equation(inertia, lambda1 - lambda3)
        right = Equation(inertia, lambda3 - lambda1)
    false = Judgement(
        _claim("no-number", "I is λ₁ − λ₃."),
        "3.5.3",
        Verdict.FALSE,
        (
            Finding(Check(wrong), Verdict.FALSE, (), replace(at, left=None)),
            Finding(Correction(right, reason="The other sign."), Verdict.PROVED),
        ),
        0.1,
        "it fails <somehow>",
    )
    simple = Judgement(
        _claim("3.45", "φ̇ from L_z and L₃."),
        "3.5.3",
        Verdict.PROVED,
        (
            Definition(Equation(Omega, phidot), "The rate of φ."),
            Finding(Check(printed["3.45"], {L_z: L3 * cos(theta)}), Verdict.PROVED),
        ),
        0.1,
    )
    page = Page("3.5.3", "Precession & more", "About θ̈ and λ₁.", ())
    return [(page, (quadratic, false, simple))]


@pytest.fixture(scope="session")
def lecture(judged):
    made = document(judged)
    return replace(made, blocks=(*made.blocks, FIGURE))


# --- What is said ---------------------------------------------------------------------------------


def _labelled(judgement, label):
    (block,) = [b for b in claim_blocks(judgement) if getattr(b, "label", "") == label]
    return block


def test_the_tag_stands_once_behind_the_last_line(judged):
    (shown,) = [
        b for b in claim_blocks(judged[0][1][0]) if getattr(b, "label", "") == "The notes print"
    ]
    assert [row.tag for row in shown.rows] == ["", "", "3.57"]
    assert [row.follows for row in shown.rows] == [False, True, False]
    assert [row.verdict for row in shown.rows] == ["proved", "assuming", "proved"]


def test_a_number_that_several_lines_bear_stands_behind_the_last(printed):
    lines = [Equation(*printed[n].sides, tag="3.37") for n in ("3.37", "3.37b")]
    judgement = Judgement(
        _claim("3.37", ""),
        "",
        Verdict.PROVED,
        tuple(Finding(Check(line), Verdict.PROVED) for line in lines),
        0.0,
    )
    assert [row.tag for row in _labelled(judgement, "The notes print").rows] == ["", "3.37"]


def test_the_engines_meaning_is_shown_where_it_says_something(judged):
    shown = _labelled(judged[0][1][0], "The engine's own expressions")
    assert [text(row.equation) for row in shown.rows] == ["ψ̇ = ω₃ − Ω cos θ"]


def test_a_false_claim_has_its_numbers_and_its_correction(judged):
    blocks = claim_blocks(judged[0][1][1])
    (numbers,) = [b for b in blocks if isinstance(b, Paragraph) and b.label == "Counterexample"]
    said = "I = λ₁ − λ₃ fails: at Ω = ½, θ = 0: the left side is undefined, the right side 343√2."
    assert plain.rich(numbers.content) == said
    corrected = _labelled(judged[0][1][1], "Corrected form")
    assert text(corrected.rows[0].equation, "printed") == "I = λ₃ − λ₁"
    assert blocks[-1] == Paragraph(("This claim does not pass. It fails <somehow>.",))


# --- HTML -----------------------------------------------------------------------------------------


@pytest.fixture(scope="session")
def page(lecture):
    return html.write(lecture, {"small": SVG})


@pytest.fixture(scope="session")
def root(page):
    return ElementTree.fromstring(page.removeprefix("<!DOCTYPE html>\n"))


def _named(root, name):
    return [e for e in root.iter() if e.tag.rpartition("}")[2] == name]


def test_html_says_its_figures_and_formulas_in_words(root):
    (svg,) = _named(root, "svg")
    assert svg.get("role") == "img"
    assert svg.get("aria-label") == 'A "quoted" thing & more.'
    formulas = _named(root, "math")
    assert formulas
    assert all(e.get("alttext") for e in formulas)


def test_html_escapes(page):
    assert "It fails &lt;somehow&gt;." in page
    assert "Steady precession &amp; its rate." in page


# --- LaTeX, Typst, text ---------------------------------------------------------------------------


def test_latex_document(lecture):
    source = tex.write(lecture, {"small": "figures/small.pdf"})
    assert source.isascii() or "ü" in source
    assert {c for c in source if not c.isascii()} <= {"ü"}
    assert r"\tag{3.57}" in source
    assert r"\rtfigure{figures/small.pdf}{figure-small}{Figure 1}" in source
    assert source.count(r"\begin{align") == source.count(r"\end{align")
    used = set(re.findall(r"\\usepackage(?:\[[^]]*\])?\{([^}]*)\}", source))
    basic = (
        "fontenc inputenc lmodern microtype geometry amsmath amssymb graphicx booktabs longtable"
    )
    assert {p for group in used for p in group.split(",")} <= {
        *basic.split(),
        "array",
        "multicol",
        "xcolor",
        "hyperref",
    }


def test_typst_keeps_primes_and_small_fractions():
    assert typst.maths(r"\mathbf{e}_{1}'") == "upright(bold(e))'_(1)"
    assert typst.maths(r"\tfrac{1}{2}x") == "inline(1/2) x"
    assert typst.maths(r"\frac{\nu}{\mu}(x)") == "frac(nu, mu)(x)"
    assert typst.maths(r"x\frac{a}{12}b") == "x frac(a, 12) b"
    assert typst.maths(r"x = \text{const}") == 'x = "const"'


def test_an_unknown_format_is_one_line(judged):
    with pytest.raises(RigidtopError, match="unknown format 'rtf': choose from text, latex, html"):
        fragment(judged[0][1][0], "rtf")


# --- PDF ------------------------------------------------------------------------------------------


PLAIN = "R&D 100 % #x, a_b {q} ~ ^ \\ <x> in Zürich: $5 or $6"


@pytest.mark.parametrize("by", ["latexmk", "typst"])
def test_a_title_is_its_words_whatever_means_something_elsewhere(by):
    way = shutil.which("latexmk")
    if by == "latexmk" and not way:
        pytest.skip("needs latexmk")
    whole = Document(f"{PLAIN}, $θ̇$", "S", (Paragraph(("A.",)),), "C", "J. #1 & Söhne", PLAIN)
    made = pdf.by_latexmk(way, tex.write(whole, {}), {}) if way and by == "latexmk" else None
    made = pdf.by_typst(typst.write(whole, {}), {}) if made is None else made
    reader = pypdf.PdfReader(io.BytesIO(made))
    assert (reader.metadata.title, reader.metadata.author) == (f"{PLAIN}, θ̇", "J. #1 & Söhne")
    assert PLAIN in " ".join(reader.pages[0].extract_text().split())
    page = ElementTree.fromstring(html.write(whole, {}).removeprefix("<!DOCTYPE html>\n"))
    assert next(page.iter("title")).text == f"{PLAIN}, θ̇"
    (byline,) = (each.text for each in page.iter("p") if each.get("class") == "byline")
    assert byline.replace("\u202f", " ") == PLAIN


TABLE = Table(("first", "second"), ((lay.Number("1.5"),) * 2,) * 6, "The title of the table")


def test_a_long_table_may_be_broken():
    long = replace(TABLE, rows=TABLE.rows * 20)
    made = pdf.by_typst(typst.write(Document("T", "S", (long,), "C"), {}), {})
    assert len(pypdf.PdfReader(io.BytesIO(made)).pages) > 1
    tables = tex.tex_block(long).split(r"\rttable")[1:]
    assert [made.count(r"$1.5$ \\") for made in tables] == [30] * 4


def test_an_error_of_latex_is_one_line():
    source = "\\documentclass{article}\n\\begin{document}\n\\nonsense\n\\end{document}\n"
    with pytest.raises(pdf.LatexError) as caught:
        pdf.by_latexmk(shutil.which("latexmk") or "", source, {})
    assert str(caught.value) == (
        r"no PDF: latexmk failed: Undefined control sequence \nonsense (line 3 of the .tex)"
    )
    assert "! Undefined control sequence." in caught.value.log


@pytest.mark.skipif(not shutil.which("latexmk"), reason="needs latexmk")
def test_where_latex_fails_its_log_is_left(judged, tmp_path):
    look = Look(documentclass="nosuch")
    with pytest.raises(RigidtopError) as caught:
        write_lecture(judged, (), tmp_path, Edition(figures=(), look=look), Wanted(pdf=True))
    said = (
        r"no PDF: latexmk failed: LaTeX Error: File `nosuch.cls' not found \(line \d of the .tex\)"
    )
    assert re.fullmatch(rf"{said}; see {tmp_path}/lecture.tex and .log", str(caught.value))
    there = {path.name for path in tmp_path.iterdir()}
    assert there >= {"lecture.tex", "lecture.log", "lecture.html"}
    assert "lecture.pdf" not in there


def _sleeper(folder: Path) -> str:
    script = folder / "latexmk"
    script.write_text("#!/bin/sh\nexec sleep 60\n")
    script.chmod(0o755)
    return str(script)


def test_latexmk_has_a_time_limit(tmp_path, monkeypatch):
    monkeypatch.setattr(pdf, "SECONDS", 0.2)
    with pytest.raises(RigidtopError, match="latexmk took more than 0 s"):
        pdf.by_latexmk(_sleeper(tmp_path), "", {})


def test_an_error_of_typst_is_one_line():
    with pytest.raises(RigidtopError, match=r"^no PDF: typst failed: .*unknown variable: nonsense"):
        pdf.by_typst("#nonsense", {})


def test_without_latexmk_typst_is_used(monkeypatch):
    monkeypatch.setattr(pdf.shutil, "which", lambda name: None)
    assert pdf.make_pdf(lambda: "", lambda: "A page.", {}).startswith(b"%PDF")


def test_a_class_of_ones_own_needs_latex(monkeypatch):
    monkeypatch.setattr(pdf.shutil, "which", lambda name: None)
    for look in (Look(documentclass="scrartcl"), Look(preamble="% mine")):
        with pytest.raises(RigidtopError, match="are for LaTeX, and no latexmk is on the PATH"):
            pdf.make_pdf(lambda: "", lambda: "A page.", {}, look)


@pytest.mark.parametrize("by", ["latexmk", "typst"])
def test_a_pdf_has_its_day(monkeypatch, by):
    if by == "latexmk" and not shutil.which("latexmk"):
        pytest.skip("needs latexmk")
    if by == "typst":
        monkeypatch.setattr(pdf.shutil, "which", lambda name: None)
    whole = Document("T", "S", (Paragraph(("A.",)),), "C")

    def made():
        return pdf.make_pdf(lambda: tex.write(whole, {}), lambda: typst.write(whole, {}), {})

    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700006400")
    first = made()
    assert pypdf.PdfReader(io.BytesIO(first)).metadata.creation_date.date() == date(2023, 11, 15)
    assert made() == first
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "yesterday")
    with pytest.raises(RigidtopError, match="wants seconds since 1970, not 'yesterday'"):
        made()


def test_without_either_one_line_names_both(monkeypatch, judged, tmp_path):
    monkeypatch.setattr(pdf.shutil, "which", lambda name: None)
    monkeypatch.setattr(pdf, "find_spec", lambda name: None)
    with pytest.raises(RigidtopError, match=r"latexmk.*typst and tylax") as caught:
        write_lecture(judged, (), tmp_path / "out", wanted=Wanted(pdf=True))
    assert "\n" not in str(caught.value)
    assert not (tmp_path / "out").exists()  # nothing half-written


# --- Files ----------------------------------------------------------------------------------------


def test_the_lecture_is_written_whole(judged, tmp_path):
    written = write_lecture(judged, (), tmp_path / "deep" / "out")
    folder = tmp_path / "deep" / "out"
    names = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*.*"))
    assert names == sorted(path.relative_to(folder).as_posix() for path in written)
    assert names == [
        "figures/precession-rates.pdf",
        "figures/precession-rates.svg",
        "lecture.html",
        "lecture.tex",
    ]
    ElementTree.fromstring(
        (folder / "lecture.html").read_text(encoding="utf-8").removeprefix("<!DOCTYPE html>\n")
    )


def test_the_lecture_is_the_same_each_time(judged, tmp_path):
    once, again = (write_lecture(judged, (), tmp_path / name) for name in "ab")
    assert [path.read_bytes() for path in once] == [path.read_bytes() for path in again]


def test_a_failure_leaves_the_old_file(tmp_path, monkeypatch):
    target = tmp_path / "lecture.tex"
    target.write_text("old")

    def refuse(source, destination):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files.os, "replace", refuse)
    with pytest.raises(RigidtopError, match=r"cannot write .*lecture.tex: No space left on device"):
        files.write_whole(target, b"new")
    assert target.read_text() == "old"
    assert os.listdir(tmp_path) == ["lecture.tex"]


def test_a_folder_that_is_a_file_is_one_line(judged, tmp_path):
    (tmp_path / "out").write_text("a file")
    with pytest.raises(RigidtopError, match=r"^cannot write [^\n]*$"):
        write_lecture(judged, (), tmp_path / "out")
    assert (tmp_path / "out").read_text() == "a file"


def test_the_printers_load_neither_matplotlib_nor_scipy():
    code = (
        "import sys, rigidtop.typeset.latex, rigidtop.typeset.text, rigidtop.terminal.table;"
        "print([m for m in ('matplotlib', 'scipy', 'typst', 'tylax') if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=120
    )
    assert done.stdout.strip() == "[]"
