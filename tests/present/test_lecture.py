"""The real pages: all of them can be written in every way, and fit on their paper."""

import io
import re
import shutil
import subprocess
from xml.etree import ElementTree

import pypdf
import pytest

from rigidtop.derivations import PAGES
from rigidtop.present import html, pdf, tex, typst
from rigidtop.present.figures.catalog import FIGURES
from rigidtop.present.figures.drawing import rendered
from rigidtop.present.lecture import FORMATS, described, fragment
from rigidtop.present.report import document
from rigidtop.proof.verdict import judge_page


@pytest.fixture(scope="module")
def judged():
    return [(page, judge_page(page)) for page in PAGES]


@pytest.fixture(scope="module")
def lecture(judged):
    return document(judged, [(each.section, described(each)) for each in FIGURES if each.section])


@pytest.fixture(scope="module")
def drawn():
    return {each.name: each for each in FIGURES if each.section}


def test_every_figure_has_its_section():
    assert {each.section for each in FIGURES} - {""} <= {page.section for page in PAGES}


def test_every_claim_has_every_fragment(judged):
    for _, judgements in judged:
        for judgement in judgements:
            for kind in FORMATS:
                assert fragment(judgement, kind).strip()


def test_html_of_all_pages(lecture, drawn):
    made = html.write(
        lecture, {name: rendered(drawing, "svg").decode() for name, drawing in drawn.items()}
    )
    root = ElementTree.fromstring(made.removeprefix("<!DOCTYPE html>\n"))
    names = [e.get("id") for e in root.iter() if e.get("id")]
    assert len(set(names)) == len(names)
    assert not re.search(r"\b(src|srcset)=|@import|url\((?!#)|<link|<script", made)
    tags = [e.text for e in root.iter("span") if e.get("class") == "tag"]
    numbers = [f"(3.{n})" for n in range(33, 58)]
    assert [tag for tag in tags if tag in numbers] == numbers  # each once, in order


@pytest.mark.skipif(not shutil.which("latexmk"), reason="needs latexmk")
def test_no_line_leaves_the_page(lecture, drawn, tmp_path):
    (tmp_path / "figures").mkdir()
    for name, drawing in drawn.items():
        (tmp_path / "figures" / f"{name}.pdf").write_bytes(rendered(drawing, "pdf"))
    source = tex.write(lecture, {name: f"figures/{name}.pdf" for name in drawn})
    (tmp_path / "lecture.tex").write_text(source, encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "lecture.tex"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, timeout=120)
    log = (tmp_path / "lecture.log").read_text(encoding="utf-8", errors="replace")
    wide = [float(points) for points in re.findall(r"Overfull \\hbox \(([\d.]+)pt", log)]
    assert max(wide, default=0) < 12  # of the 444 points of a line, and of 77 points of margin


def test_typst_of_all_pages(lecture, drawn):
    source = typst.write(lecture, {name: f"figures/{name}.svg" for name in drawn})
    figures = {f"figures/{name}.svg": rendered(drawing, "svg") for name, drawing in drawn.items()}
    made = pypdf.PdfReader(io.BytesIO(pdf.by_typst(source, figures)))
    words = "\n".join(page.extract_text() for page in made.pages)
    for number in range(33, 58):
        assert f"(3.{number})" in words
    assert len(made.pages) > 20
