"""The real pages: the lecture and its record can be written in every way, and fit their paper."""

import io
import math
import re
import shutil
import subprocess
from dataclasses import replace
from itertools import pairwise
from xml.etree import ElementTree

import pypdf
import pytest

from rigidtop.derivations import PAGES
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.figures.drawing import both
from rigidtop.report import html, myst, pdf, plain, tex, typst
from rigidtop.report.blocks import (
    Cited,
    Display,
    ExerciseHead,
    Figure,
    Look,
    NameLine,
    Paragraph,
    Table,
)
from rigidtop.report.lecture import FORMATS, Edition, fragment, lecture, record, sheet
from rigidtop.report.numbers import written

from ..web.conftest import chrome


def _is(block, *kinds):
    return isinstance(block, Table) and block.kind in kinds


@pytest.fixture(scope="module")
def recorded(judged, solutions, lines):
    return record(judged, solutions, Edition(lines=lines))[0]


@pytest.fixture(scope="module")
def whole(judged, solutions, lines):
    return lecture(judged, solutions, Edition(lines=lines))


@pytest.fixture(scope="module")
def document(whole):
    return whole[0]


@pytest.fixture(scope="module")
def pictures(whole):
    return whole[1]


def test_every_claim_has_every_fragment(judged):
    every = [judgement for _, judgements in judged for judgement in judgements]
    for number, judgement in enumerate(every):  # as text and as LaTeX each elsewhere
        assert fragment(judgement, [*FORMATS][number % len(FORMATS)]).strip()


@pytest.fixture(scope="module")
def drawn(pictures):
    """Each figure as PDF and as SVG."""
    return {p.name: both(p.drawing, p.given) for p in pictures}


def test_html_of_all_pages(document, drawn):
    made = html.write(document, {name: svg.decode() for name, (_, svg) in drawn.items()})
    root = ElementTree.fromstring(made.removeprefix("<!DOCTYPE html>\n"))
    names = [e.get("id") for e in root.iter() if e.get("id")]
    assert len(set(names)) == len(names)
    assert not re.search(r"\b(src|srcset)=|@import|url\((?!#)|<link|<script [^>]*src", made)
    tags = [e.text for e in root.iter("span") if e.get("class") == "tag"]
    numbers = [f"(3.{n})" for n in range(33, 58)]
    assert set(numbers) <= set(tags)
    links = {e.get("href")[1:] for e in root.iter("a")}
    assert links <= set(names)
    places = {e.get("id") for e in root.iter("div") if e.get("data-tex")}
    assert None not in places  # every equation can be linked to
    assert len(places) > 300
    levels = [int(e.tag[1]) for e in root.iter() if re.fullmatch("h[1-6]", e.tag)]
    assert all(below <= above + 1 for above, below in pairwise(levels))
    titles = [e for e in document.blocks if isinstance(e, ExerciseHead) and e.kind == "Solution"]
    assert {title.level for title in titles} == {2}


@pytest.fixture(scope="module")
def paper(document, drawn):
    """The PDF of the lecture by Typst; by LaTeX the first command of the README makes it."""
    names = {name: f"figures/{name}.svg" for name in drawn}
    files = {names[name]: svg for name, (_, svg) in drawn.items()}
    return pdf.by_typst(typst.write(document, names), files)


@pytest.fixture(scope="module")
def words(paper):
    """The text of each page, in the order in which it is set."""
    if not shutil.which("pdftotext"):
        pytest.skip("needs pdftotext")
    command = ["pdftotext", "-raw", "-", "-"]
    done = subprocess.run(command, input=paper, capture_output=True, check=True, timeout=120)
    return done.stdout.decode().split("\f")[:-1]


def test_a_pdf_says_what_it_is(paper, document):
    about = pypdf.PdfReader(io.BytesIO(paper)).metadata
    assert (about.title, about.author) == (document.title, "rigidtop")
    assert about.subject == document.subtitle
    assert "Euler angles" in document.keywords
    words = about["/Keywords"].replace("’", "'")
    assert re.split("[,;] ", words) == list(document.keywords)


def test_typst_of_all_pages(words):
    whole = "\n".join(words)
    for number in range(33, 58):
        assert f"(3.{number})" in whole
    assert len(words) > 20
    for number in range(1, len(EXERCISES) + 1):
        assert whole.count(f"Exercise {number}.") == 1
        assert whole.count(f"Solution {number}.") == 1


# --- Exercises ------------------------------------------------------------------------------------


def test_the_record_has_every_line_once(recorded, document):
    def lines(whole):
        rows = (row for b in whole.blocks if isinstance(b, Display) for row in b.rows)
        return [row.line for row in rows if row.line and row.reason]

    there = lines(recorded)
    assert len(set(there)) == len(there)
    assert set(there) == set(lines(document))


def test_a_student_sees_no_solution(judged, solutions, lines):
    (document, pictures), (whole, _) = (
        lecture(judged, solutions, Edition(student, lines=lines)) for student in (True, False)
    )
    told, known = (
        " ".join(b.caption for b in each.blocks if isinstance(b, Figure))
        for each in (document, whole)
    )
    for answer in ("0.66", "1.71 N m", "0.391 s", "76.5 %"):
        assert answer in known
        assert answer not in told
    assert not any(picture.name.startswith("exercise-") for picture in pictures)
    assert not any(_is(block, "numbers", "values") for block in document.blocks)
    heads = [b.number for b in document.blocks if isinstance(b, ExerciseHead)]
    assert heads == list(range(1, len(EXERCISES) + 1))
    new = {j.claim.name for s in solutions for j in s.judgements} - {
        claim.name for page in PAGES for claim in page.claims
    }
    assert new
    assert not new & _marked(document)
    assert new <= _marked(whole)


def _marked(document):
    """The claims that have a mark."""
    rows = (row for b in document.blocks if isinstance(b, Display) for row in b.rows)
    said = (block for block in document.blocks if isinstance(block, Paragraph))
    return {each.mark.name for each in (*rows, *said) if each.mark is not None}


def test_every_claim_of_the_notes_has_its_mark(document, judged):
    names = {j.claim.name for _, judgements in judged for j in judgements}
    assert names <= _marked(document)
    rows = (row for b in document.blocks if isinstance(b, Display) for row in b.rows)
    marks = {row.mark.name: row.mark for row in rows if row.mark is not None}
    # What is false is marked at the words of the notes, not at the right lines above them.
    said = [x for x in document.blocks if isinstance(x, Paragraph) and x.mark is not None]
    false = {x.mark.name: x for x in said if x.mark.verdict.value == "false"}
    assert set(false) == {"coplanar", "inertia-full"}
    assert all(str(x.content[0]).startswith("The notes say: ") for x in false.values())
    assert not set(false) & set(marks)
    assert plain.rich(marks["3.45"].note) == (
        "if the top is not upright and does not hang (sin θ ≠ 0)"
    )
    assert marks["3.54"].note == ()


def test_figures_are_numbered_in_order_and_cited(document):
    figures = [block for block in document.blocks if isinstance(block, Figure)]
    assert [figure.number for figure in figures] == list(range(1, len(figures) + 1))
    contents = [b.content for b in document.blocks if isinstance(b, Paragraph)]
    contents += [row.spoken for b in document.blocks if isinstance(b, Display) for row in b.rows]
    cited = {piece.anchor for c in contents for piece in c if isinstance(piece, Cited)}
    spoken = {f.anchor for f in figures if not f.name.startswith("exercise-")} - {"figure-map"}
    assert spoken <= cited


def test_numbers_are_written_as_people_do():
    assert plain.rich(written(math.pi / 6, "rad")) == "30°"
    assert plain.rich(written(-0.5, "m/s")) == "−0.5\u2009m/s"
    assert plain.rich(written(math.radians(0.1 / 3600), "rad")) == "0.1″"
    assert written("waves", "1") == ("waves",)


def test_a_sheet_is_signed_and_numbered(solutions, lines):
    edition = Edition(student=True, points="2.5 points", lines=lines)
    document, pictures = sheet(solutions, edition)
    assert document.subtitle == f"Questions, {2.5 * len(EXERCISES):g} points"
    # What a question cites stands beneath.
    rows = [row for block in document.blocks if isinstance(block, Display) for row in block.rows]
    assert {row.tag for row in rows} >= {"3.52", "3.57"}
    assert all(row.anchor == f"claim-{row.tag.replace('.', '-')}" for row in rows if row.tag)
    cited = {
        piece.anchor
        for block in document.blocks
        if isinstance(block, Paragraph)
        for piece in block.content
        if isinstance(piece, Cited)
    }
    assert cited == {row.anchor for row in rows if row.tag}
    assert isinstance(document.blocks[0], NameLine)
    heads = [block for block in document.blocks if isinstance(block, ExerciseHead)]
    assert [head.number for head in heads] == list(range(1, len(EXERCISES) + 1))
    assert {head.points for head in heads} == {"2.5 points"}
    assert pictures == []


def test_a_sheet_has_the_claims_in_full(solutions):
    document, pictures = sheet(solutions)
    tables = [block for block in document.blocks if _is(block, "numbers")]
    assert tables
    assert not any("tolerance" in table.head for table in tables)  # that is the record's
    assert _marked(document) >= {j.claim.name for s in solutions for j in s.judgements}
    assert {p.name for p in pictures} == {
        f"exercise-{exercise.name}" for exercise in EXERCISES if exercise.figure
    }


def test_chapters_can_be_read_into_another_document(document, drawn, tmp_path):
    kind, names = "[twocolumn]{report}", ("marks", "3-5-3", "3-3", "letters")
    paths = {name: f"figures/{name}.pdf" for name in drawn}
    made = tex.chapters(document, paths)
    wanted = ["rigidtop.sty", *(f"chapters/{name}.tex" for name in names)]
    assert set(wanted) <= set(made)
    if not shutil.which("pdflatex"):
        pytest.skip("needs pdflatex")
    for name in wanted:
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(made[name], "utf-8")
    (tmp_path / "figures").mkdir()
    for name, (figure, _) in drawn.items():
        (tmp_path / paths[name]).write_bytes(figure)
    chosen = "".join(rf"\input{{chapters/{name}}}" for name in names)
    used = r"\usepackage{rigidtop}\usepackage{hyperref}\begin{document}"
    own = rf"\documentclass{kind}{used}{chosen}"
    (tmp_path / "own.tex").write_text(own + r"\end{document}", "utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "own.tex"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, timeout=120)
    assert (tmp_path / "own.pdf").exists()
    log = (tmp_path / "own.log").read_text("utf-8", errors="replace")
    # What a chapter cites and does not stand there is words.
    assert "undefined" not in log
    assert r"Overfull \hbox" not in log


def test_a_myst_project_has_every_numbered_equation(document):
    made = myst.write(document)
    whole = "\n".join(made.values())
    for number in range(33, 58):
        assert re.search(
            rf"^\(claim-3-{number}\)=\n```{{math}}[^`]*\\tag{{3.{number}}}$", whole, re.M
        )
    files = re.findall(r"- file: (\S+)", made["myst/myst.yml"])
    assert {f"myst/{file}" for file in files} == set(made) - {"myst/myst.yml", "myst/_toc.yml"}
    assert files[1:] == [f"{x}.md" for x in re.findall(r"- file: (\S+)", made["myst/_toc.yml"])]
    labels = re.findall(r"^\((\S+)\)=$", whole, re.M)
    assert len(set(labels)) == len(labels)


@pytest.fixture(scope="module")
def projector(document, drawn, tmp_path_factory):
    """The slides in a browser: presses a key, or goes to a place, and says what is then shown."""
    path = tmp_path_factory.mktemp("slides") / "slides.html"
    svg = {name: page.decode() for name, (_, page) in drawn.items()}
    path.write_text(html.write(document, svg, slides=True), "utf-8")
    driver = chrome()
    driver.get(path.as_uri())
    yield driver
    driver.quit()


PRESS = "dispatchEvent(new KeyboardEvent('keydown', { key: arguments[0] }))"
SHOWN_NOW = """const now = document.querySelector(".slide.now");
return [now.textContent, now.querySelectorAll(".covered").length, location.hash]"""


def test_the_arrow_keys_uncover_lines(projector):
    def shown(key):
        projector.execute_script(PRESS, key)
        return projector.execute_script(SHOWN_NOW)

    words, covered, place = shown("Home")
    assert "Rigid rotation" in words
    projector.execute_script("location.replace('#3-5-3')")
    assert "Precession in the Lagrange formalism" in projector.execute_script(SHOWN_NOW)[0]
    projector.execute_script("location.replace('#3-57')")
    assert "(3.57)" in projector.execute_script(SHOWN_NOW)[0]
    words, covered, place = shown("ArrowDown")
    assert place.endswith(".1")
    lines = 1 + covered
    for k in range(1, lines):
        assert shown("ArrowRight")[:2] == [words, covered - k]
    assert shown("ArrowRight")[0] != words
    assert shown("ArrowLeft")[:2] == [words, 0]


def test_a_lecture_of_ones_own_looks(document):
    look = Look("letter", "% mine\n", "scrartcl")
    own = replace(document, look=look, title="Kreisel", byline="A. Lecturer, PHY 305")
    source = tex.write(own, {b.name: "x" for b in own.blocks if isinstance(b, Figure)})
    assert r"\documentclass[10pt,letterpaper,fleqn]{scrartcl}" in source
    assert re.search(r"% mine\s+\\begin\{document\}", source)
    assert "A. Lecturer, PHY 305" in source
    assert "pdftitle={Kreisel}" in source
