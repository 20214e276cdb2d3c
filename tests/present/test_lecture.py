"""The real pages: all of them can be written in every way, and fit on their paper."""

import io
import re
import shutil
import subprocess
from xml.etree import ElementTree

import numpy as np
import pypdf
import pytest
from sympy import Symbol

from rigidtop.derivations import PAGES
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.present import html, pdf, tex, typst
from rigidtop.present import layout as lay
from rigidtop.present.figures.catalog import FIGURES
from rigidtop.present.figures.drawing import rendered
from rigidtop.present.lecture import FORMATS, fragment, lecture, sheet
from rigidtop.present.report import (
    ClaimHead,
    DataTable,
    Display,
    ExerciseHead,
    Heading,
    Measures,
    Paragraph,
    Quantities,
    claim_blocks,
    symbols_used,
)
from rigidtop.present.solutions import solved
from rigidtop.present.text import text
from rigidtop.proof.verdict import judge_page
from rigidtop.theory import symbols as s


@pytest.fixture(scope="module")
def judged():
    return [(page, judge_page(page)) for page in PAGES]


@pytest.fixture(scope="module")
def solutions(judged):
    known = {j.claim.name: j for _, judgements in judged for j in judgements}
    return [solved(exercise, judged=known) for exercise in EXERCISES]


@pytest.fixture(scope="module")
def whole(judged, solutions):
    return lecture(judged, solutions)


@pytest.fixture(scope="module")
def document(whole):
    return whole[0]


@pytest.fixture(scope="module")
def pictures(whole):
    return whole[1]


def test_every_figure_has_its_section():
    assert {each.section for each in FIGURES} - {""} <= {page.section for page in PAGES}


def test_every_claim_has_every_fragment(judged):
    for _, judgements in judged:
        for judgement in judgements:
            for kind in FORMATS:
                assert fragment(judgement, kind).strip()


def test_html_of_all_pages(document, pictures):
    svg = {p.name: rendered(p.drawing, "svg", p.given).decode() for p in pictures}
    made = html.write(document, svg)
    root = ElementTree.fromstring(made.removeprefix("<!DOCTYPE html>\n"))
    names = [e.get("id") for e in root.iter() if e.get("id")]
    assert len(set(names)) == len(names)
    assert not re.search(r"\b(src|srcset)=|@import|url\((?!#)|<link|<script", made)
    tags = [e.text for e in root.iter("span") if e.get("class") == "tag"]
    numbers = [f"(3.{n})" for n in range(33, 58)]
    assert [tag for tag in tags if tag in numbers] == numbers  # each once, in order


@pytest.fixture(scope="module", params=["latexmk", "typst"])
def paper(request, document, pictures):
    """The PDF of the lecture, both ways."""
    latexmk = shutil.which("latexmk")
    if request.param == "latexmk" and not latexmk:
        pytest.skip("needs latexmk")
    kind, by, way = ("pdf", tex, latexmk) if request.param == "latexmk" else ("svg", typst, None)
    names = {p.name: f"figures/{p.name}.{kind}" for p in pictures}
    files = {names[p.name]: rendered(p.drawing, kind, p.given) for p in pictures}
    source = by.write(document, names)
    return pdf.by_latexmk(way, source, files) if way else pdf.by_typst(source, files)


END = 0.905
"""Where the body of a page ends, and its number follows, as a share of its height."""


@pytest.mark.skipif(not shutil.which("pdftoppm"), reason="needs pdftoppm")
def test_pages_have_no_white_gaps(paper, tmp_path):
    (tmp_path / "lecture.pdf").write_bytes(paper)
    command = ["pdftoppm", "-r", "36", "-gray", "lecture.pdf", "page"]
    subprocess.run(command, cwd=tmp_path, check=True, timeout=120)
    inside, beneath = [], []
    for path in sorted(tmp_path.glob("page-*.pgm")):
        _, size, _, dots = path.read_bytes().split(b"\n", 3)
        width, height = map(int, size.split())
        page = np.frombuffer(dots, np.uint8).reshape(height, width)
        rows = np.flatnonzero((page < 250).any(axis=1)) / height
        body = rows[rows < END]
        inside.append(np.diff(body).max())
        beneath.append(END - body[-1])
    assert max(inside) < 0.06
    # The list of symbols begins a page, and a last figure that found no room has the one before.
    texts = [page.extract_text() for page in pypdf.PdfReader(io.BytesIO(paper)).pages]
    ends = {
        k - back
        for k, text in enumerate(texts)
        for back in (1, 2)
        if text.lstrip().startswith("Symbols\n")
    }
    beneath = [gap for k, gap in enumerate(beneath[:-1]) if k not in ends]
    # What may not be parted begins the next page: a table, a claim with its first lines.
    assert max(beneath) < 0.22
    assert np.mean(beneath) < 0.065


def test_no_heading_ends_a_page(paper, document):
    titles = {"Solution in symbols", "Solution in numbers"}
    for block in document.blocks:
        if isinstance(block, (Heading, ExerciseHead, ClaimHead)):
            titles.add(block.shown if isinstance(block, ClaimHead) else block.title)
    titles = {_letters(title) for title in titles} - {""}
    heads = 0
    for page in pypdf.PdfReader(io.BytesIO(paper)).pages[1:]:  # behind the contents
        lines = [_letters(line) for line in page.extract_text().splitlines() if line.strip()]
        heads += sum(line in titles for line in lines)
        assert lines[-2] not in titles  # above the number of the page
    assert heads > 50


def _letters(line):
    """The letters of a line, without the word that begins the title of an exercise."""
    return "".join(re.findall(r"[a-z]+", line.lower())).removeprefix("exercise")


def test_a_pdf_says_what_it_is(paper, document):
    about = pypdf.PdfReader(io.BytesIO(paper)).metadata
    assert (about.title, about.author) == (document.title, "rigidtop")
    assert about.subject == document.subtitle
    assert "Euler angles" in document.keywords
    words = about["/Keywords"].replace("’", "'")
    assert re.split("[,;] ", words) == list(document.keywords)


@pytest.mark.skipif(not shutil.which("latexmk"), reason="needs latexmk")
def test_no_line_leaves_the_page(document, pictures, tmp_path):
    (tmp_path / "figures").mkdir()
    for p in pictures:
        (tmp_path / "figures" / f"{p.name}.pdf").write_bytes(rendered(p.drawing, "pdf", p.given))
    source = tex.write(document, {p.name: f"figures/{p.name}.pdf" for p in pictures})
    (tmp_path / "lecture.tex").write_text(source, encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "lecture.tex"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, timeout=120)
    log = (tmp_path / "lecture.log").read_text(encoding="utf-8", errors="replace")
    wide = [float(points) for points in re.findall(r"Overfull \\hbox \(([\d.]+)pt", log)]
    assert max(wide, default=0) < 12  # of the 444 points of a line, and of 77 points of margin


@pytest.mark.parametrize("paper", ["typst"], indirect=True)
def test_typst_of_all_pages(paper):
    made = pypdf.PdfReader(io.BytesIO(paper))
    words = "\n".join(page.extract_text() for page in made.pages)
    for number in range(33, 58):
        assert f"(3.{number})" in words
    assert len(made.pages) > 20
    assert words.count("Exercise: ") == 2 * len(EXERCISES)  # each in the contents too


# --- Exercises ------------------------------------------------------------------------------------


def test_titles_of_tables_begin_with_a_capital(document):
    titles = [block.title for block in document.blocks if isinstance(block, DataTable)]
    assert titles
    assert [title for title in titles if title[0].islower()] == []


MOMENTS = {s.lambda1, s.lambda2, s.lambda3}


def test_moments_are_made_of_masses_and_lengths(document):
    units: dict[str, dict[str, str]] = {}
    for block in document.blocks:
        for row in block.rows if isinstance(block, Display) else ():
            left, right = row.equation.sides[0], row.equation.sides[-1]
            made_of = {x: lay.known(x)[1] for x in right.free_symbols}
            found = {str(x): quantity.unit for x, quantity in made_of.items() if quantity}
            if left in MOMENTS and "kg" in found.values():
                units[text(row.equation)] = found
    assert len(units) > 5
    assert {unit for found in units.values() for unit in found.values()} == {"kg", "m"}


@pytest.mark.parametrize("name", ["principal-axes", "cone-on-its-tip", "wobble-to-spin"])
def test_symbols_of_their_own_are_explained(judged, solutions, name):
    everything = [
        *(j for _, row in judged for j in row),
        *(j for x in solutions for j in x.judgements),
    ]
    judgement = next(judgement for judgement in everything if judgement.claim.name == name)
    used = symbols_used(claim_blocks(judgement))
    assert {x for x in used if lay.known(x)[1] is None} <= {Symbol("d3r")}


def test_every_exercise_stands_once_in_its_section(document):
    titles = [block.title for block in document.blocks if isinstance(block, ExerciseHead)]
    assert sorted(titles) == sorted(exercise.title for exercise in EXERCISES)


def test_a_claim_of_the_lecture_is_named_and_not_repeated(document, solutions):
    heads = [block.name for block in document.blocks if isinstance(block, ClaimHead)]
    assert len(set(heads)) == len(heads)
    assert {j.claim.name for solution in solutions for j in solution.judgements} <= set(heads)
    assert ("See the claim example-34 above.",) in [
        block.content for block in document.blocks if isinstance(block, Paragraph)
    ]


def test_a_student_sees_no_solution(judged, solutions):
    (document, pictures), (whole, _) = (
        lecture(judged, solutions, student=student) for student in (True, False)
    )
    assert not any(picture.name.startswith("exercise-") for picture in pictures)
    assert not any(isinstance(block, DataTable) for block in document.blocks)
    labels = {block.label for block in document.blocks if isinstance(block, Quantities)}
    assert labels == {"Given"}
    new = {j.claim.name for s in solutions for j in s.judgements} - {
        claim.name for page in PAGES for claim in page.claims
    }
    assert new
    assert not new & {b.name for b in document.blocks if isinstance(b, ClaimHead)}
    assert len(document.blocks) < len(whole.blocks)


def test_a_sheet_has_the_claims_in_full(solutions):
    document, pictures = sheet(solutions)
    heads = {block.name for block in document.blocks if isinstance(block, ClaimHead)}
    assert heads == {j.claim.name for solution in solutions for j in solution.judgements}
    assert sum(isinstance(block, Measures) for block in document.blocks) >= len(solutions)
    assert {p.name for p in pictures} == {
        f"exercise-{exercise.name}" for exercise in EXERCISES if exercise.figure
    }
