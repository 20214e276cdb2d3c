"""The real pages: the lecture and its record can be written in every way, and fit their paper."""

import io
import math
import re
import shutil
import subprocess
import unicodedata
from dataclasses import fields, is_dataclass, replace
from itertools import pairwise
from xml.etree import ElementTree

import numpy as np
import pypdf
import pytest

from rigidtop.derivations import PAGES
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.figures.catalog import FIGURES
from rigidtop.figures.drawing import both, rendered
from rigidtop.notation import NOTES
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.verdict import Verdict
from rigidtop.report import html, myst, pdf, plain, tex, typst
from rigidtop.report.blocks import (
    Cited,
    ClaimHead,
    Display,
    ExerciseHead,
    Figure,
    Legend,
    Look,
    NameLine,
    Paragraph,
    Results,
    Room,
    SectionHead,
    Subhead,
    TableBlock,
    UprightUnit,
    is_number,
)
from rigidtop.report.claims import claim_blocks
from rigidtop.report.handout import CONDITIONS, Parts, summary
from rigidtop.report.lecture import FORMATS, LETTERS, Edition, fragment, lecture, record, sheet
from rigidtop.report.map import columns, heights, reduced
from rigidtop.report.numbers import written
from rigidtop.report.selection import projected
from rigidtop.report.symbols import symbols_used
from rigidtop.report.ways import law_blocks, running
from rigidtop.report.wording import LETTER, braced
from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import known
from rigidtop.typeset.latex import latex
from rigidtop.typeset.nodes import Node
from rigidtop.typeset.text import text
from rigidtop.typeset.words import characters, parts

from ..web.conftest import chrome


def _is(block, *kinds):
    return isinstance(block, TableBlock) and block.kind in kinds


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


@pytest.fixture(scope="module")
def for_students(judged, solutions, lines):
    return lecture(judged, solutions, Edition(student=True, lines=lines))


def test_every_figure_has_its_section():
    assert {each.section for each in FIGURES} - {""} <= {page.section for page in PAGES}


def test_every_claim_has_every_fragment(judged):
    every = [judgement for _, judgements in judged for judgement in judgements]
    for number, judgement in enumerate(every):  # as text and as LaTeX each elsewhere
        assert fragment(judgement, [*FORMATS][number % len(FORMATS)]).strip()


@pytest.fixture(scope="module")
def drawn(pictures):
    """Each figure as PDF and as SVG."""
    return {p.name: both(p.drawing, p.given) for p in pictures}


@pytest.fixture(scope="module")
def made(document, drawn):
    """The lecture as HTML."""
    return html.write(document, {name: svg.decode() for name, (_, svg) in drawn.items()})


def test_html_of_all_pages(document, made):
    root = ElementTree.fromstring(made.removeprefix("<!DOCTYPE html>\n"))
    names = [e.get("id") for e in root.iter() if e.get("id")]
    assert len(set(names)) == len(names)
    assert not re.search(r"\b(src|srcset)=|@import|url\((?!#|data:)|<link|<script [^>]*src", made)
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
    # It opens with a top, of which it says what is asked; without a script that is a still.
    first = root.find(".//main/figure")
    assert [*root.find(".//main")].index(first) == 1
    assert "".join(first.find("figcaption").itertext()) == Edition().front.opening.invitation
    assert first.find("{http://www.w3.org/2000/svg}svg").get("role") == "img"


@pytest.fixture(scope="module", params=["latexmk", "typst"])
def paper(request, document, drawn):
    """The PDF of the lecture, both ways."""
    latexmk = shutil.which("latexmk")
    if request.param == "latexmk" and not latexmk:
        pytest.skip("needs latexmk")
    kind, by, way = ("pdf", tex, latexmk) if request.param == "latexmk" else ("svg", typst, None)
    names = {name: f"figures/{name}.{kind}" for name in drawn}
    files = {names[name]: each[kind == "svg"] for name, each in drawn.items()}
    source = by.write(document, names)
    return pdf.by_latexmk(way, source, files) if way else pdf.by_typst(source, files)


@pytest.fixture(scope="module")
def words(paper):
    """The text of each page, in the order in which it is set."""
    if not shutil.which("pdftotext"):
        pytest.skip("needs pdftotext")
    command = ["pdftotext", "-raw", "-", "-"]
    done = subprocess.run(command, input=paper, capture_output=True, check=True, timeout=120)
    return done.stdout.decode().split("\f")[:-1]


def _starts(paper):
    """The page on which each section begins, by its title."""
    reader = pypdf.PdfReader(io.BytesIO(paper))
    return {
        entry.title: reader.get_destination_page_number(entry)
        for entry in reader.outline
        if not isinstance(entry, list)
    }


@pytest.mark.skipif(not shutil.which("pdftoppm"), reason="needs pdftoppm")
def test_pages_have_no_white_gaps(paper, tmp_path):
    (tmp_path / "lecture.pdf").write_bytes(paper)
    command = ["pdftoppm", "-r", "36", "-gray", "lecture.pdf", "page"]
    subprocess.run(command, cwd=tmp_path, check=True, timeout=120)
    reader = pypdf.PdfReader(io.BytesIO(paper))
    # By Typst, which is there for those without LaTeX, pages are looser.
    columns = "TeX" in reader.metadata.get("/Creator", "")
    starts = _starts(paper)
    solved, results = starts["Solutions of the exercises"], starts["Summary of results"]
    # By LaTeX the contents have a page of their own.
    ends = {
        -1 + columns,
        solved - 1,
        results - 1,
        starts["What rests on what"] - 1,
        len(reader.pages) - 1,
    }
    for k, path in enumerate(sorted(tmp_path.glob("page-*.pgm"))):
        _, size, _, dots = path.read_bytes().split(b"\n", 3)
        width, height = map(int, size.split())
        page = np.frombuffer(dots, np.uint8).reshape(height, width)
        two = columns and k >= solved
        for part in (page[:, : width // 2], page[:, width // 2 :]) if two else (page,):
            rows = np.flatnonzero((part < 250).any(axis=1)) / height
            body = rows[rows < (0.94 if columns else 0.905)]
            assert np.diff(body).max() < 0.06, f"inside page {k + 1}"
            if k not in ends:
                least = 0.06 if columns else 0.22
                assert body[-1] > (0.94 if columns else 0.905) - least, f"beneath page {k + 1}"
    assert len(reader.pages) < (56 if columns else 60)


PLACES = ((16, 25), (25, 159), (163, 203))
COLUMNS = ((9, 17), (17, 100.5), (101, 109.5), (109.5, 193))
"""What words stand in on A4, from left to right (mm): text with its margins, and two columns."""


def _boxes(made):
    """The words of each page: their boxes as an array of rows x, y, x, y in points, their letters.

    Words of combining accents are left out, which lie on their letter, and so are braces.
    """
    done = subprocess.run(
        ["pdftotext", "-bbox", "-", "-"], input=made, capture_output=True, check=True, timeout=120
    )
    # Not quite XML: letters of a formula may be control characters.
    for page in done.stdout.decode().split("<page ")[1:]:
        words = [
            (*map(float, sides), word)
            for *sides, word in re.findall(WORD, page)
            if re.search(r"\w", word) and not any(map(unicodedata.combining, word))
        ]
        yield np.array([word[:4] for word in words]).reshape(-1, 4), [word[4] for word in words]


WORD = r'<word xMin="(.+?)" yMin="(.+?)" xMax="(.+?)" yMax="(.+?)">(.+?)</word>'


def _overlaps(boxes):
    """The pairs of boxes that share a line and more than a fifth of their height along it."""
    left, top, right, bottom = (boxes[:, k] for k in range(4))
    height = np.minimum.outer(bottom - top, bottom - top)
    along = np.minimum.outer(right, right) - np.maximum.outer(left, left)
    apart = np.abs(np.subtract.outer(top + bottom, top + bottom)) / 2
    return np.argwhere(np.triu((along > 0.2 * height) & (apart < 0.3 * height), 1))


def _beyond(boxes, places):
    """Which boxes stand in none of the places."""
    low, high = 72 / 25.4 * np.array(places).T
    inside = (low - 2 < boxes[:, :1]) & (boxes[:, 2:3] < high + 2)
    return ~inside.any(axis=1)


@pytest.mark.skipif(not shutil.which("pdftotext"), reason="needs pdftotext")
def test_no_word_lies_on_another_or_beyond_its_column(paper, document):
    starts = _starts(paper)
    solved, letters = starts["Solutions of the exercises"], starts[LETTERS.title]
    tables = [b for b in document.blocks if _is(b, "numbers")]
    captions = [b.caption for b in document.blocks if isinstance(b, Figure)]
    told = set(" ".join([plain.fragment(tables), *captions]).split())
    lying, beyond, seen = [], [], 0
    for k, (boxes, words) in enumerate(_boxes(paper)):
        lying += [(k + 1, words[i], words[j]) for i, j in _overlaps(boxes)]
        out = _beyond(boxes, COLUMNS if k >= solved else PLACES)
        if k >= solved:  # floats over both columns stand above them
            wide = [boxes[i, 3] for i in np.flatnonzero(out) if words[i] in told]
            out &= _beyond(boxes, [(17, 193)]) | (boxes[:, 3] > max(wide, default=0))
        # The list of letters has three columns in LaTeX.
        beyond += [(k + 1, words[i]) for i in np.flatnonzero(out) if k < letters]
        seen += len(words)
    assert (lying, beyond) == ([], [])
    assert seen > 15_000


@pytest.mark.parametrize("paper", ["latexmk"], indirect=True)
def test_no_table_stands_above_the_head_of_its_solution(words, document):
    """The first that is said of a solution is its title; those of its tables come later."""
    titles = {b.number: b.title for b in document.blocks if isinstance(b, ExerciseHead)}
    told = re.findall(r"^Solution (\d+)\. (\w+)", "\n".join(words), re.MULTILINE)
    first = dict(reversed(told))
    assert first == {str(k): re.match(r"\w+", title)[0] for k, title in titles.items()}
    assert len(told) > len(first)


def test_no_heading_ends_a_page(words, document):
    kinds = (SectionHead, ExerciseHead, Subhead)
    titles = {
        b.words if isinstance(b, Subhead) else b.title
        for b in document.blocks
        if isinstance(b, kinds)
    }
    titles = {_letters(title) for title in titles} - {""}
    seen = 0
    for page in words[1:]:  # behind the contents
        # A title has no full stop; the end of a sentence may be a title's words.
        lines = [
            _letters(x) if x[-1] != "." else "." for x in map(str.strip, page.splitlines()) if x
        ]
        seen += sum(line in titles for line in lines)
        # The number of a page has no letters.
        assert [line for line in lines if line][-1] not in titles
    assert seen > 50


def _letters(line):
    """The letters of a line, without the word that begins the title of an exercise."""
    line = re.sub(r"^exercise\b", "", line.lower())
    return "".join(re.findall(r"[a-z]+", line))


def test_a_pdf_says_what_it_is(paper, document):
    about = pypdf.PdfReader(io.BytesIO(paper)).metadata
    assert (about.title, about.author) == (document.title, "rigidtop")
    assert about.subject == document.subtitle
    assert "Euler angles" in document.keywords
    words = about["/Keywords"].replace("’", "'")
    assert re.split("[,;] ", words) == list(document.keywords)


@pytest.mark.skipif(not shutil.which("latexmk"), reason="needs latexmk")
def test_no_line_of_the_record_leaves_the_page(recorded, pictures, tmp_path):
    (tmp_path / "figures").mkdir()
    one = rendered(pictures[0].drawing, "pdf", pictures[0].given)
    (tmp_path / "figures" / "one.pdf").write_bytes(one)
    figures = {b.name: "figures/one.pdf" for b in recorded.blocks if isinstance(b, Figure)}
    (tmp_path / "record.tex").write_text(tex.write(recorded, figures), encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "record.tex"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, timeout=120)
    log = (tmp_path / "record.log").read_text(encoding="utf-8", errors="replace")
    wide = [float(points) for points in re.findall(r"Overfull \\hbox \(([\d.]+)pt", log)]
    # Of 444 points of a line and of 77 points of margin, small ones.
    assert max(wide, default=0) < 12


@pytest.mark.parametrize("paper", ["latexmk"], indirect=True)
def test_no_letter_is_too_small(paper):
    """What follows an exercise is as large again as what stands before it."""
    sizes: set[float] = set()
    for page in pypdf.PdfReader(io.BytesIO(paper)).pages[1::9]:
        page.extract_text(visitor_text=lambda *about: sizes.add(about[-1]))
    assert min(sizes) > 4.9


@pytest.mark.parametrize("paper", ["typst"], indirect=True)
def test_typst_of_all_pages(words):
    whole = "\n".join(words)
    for number in range(33, 58):
        assert f"(3.{number})" in whole
    assert len(words) > 20
    for number in range(1, len(EXERCISES) + 1):
        assert whole.count(f"Exercise {number}.") == 1
        assert whole.count(f"Solution {number}.") == 1


# --- Exercises ------------------------------------------------------------------------------------


def test_titles_of_tables_begin_with_a_capital(recorded):
    titles = [block.title for block in recorded.blocks if _is(block, "numbers")]
    assert titles
    assert [title for title in titles if title[0].islower()] == []


MOMENTS = {s.lambda1, s.lambda2, s.lambda3}


def test_moments_are_made_of_masses_and_lengths(recorded):
    units: dict[str, dict[str, str]] = {}
    for block in recorded.blocks:
        for row in block.rows if isinstance(block, Display) else ():
            left, right = row.equation.sides[0], row.equation.sides[-1]
            made_of = {x: known(x)[1] for x in right.free_symbols}
            found = {str(x): quantity.unit for x, quantity in made_of.items() if quantity}
            if left in MOMENTS and "kg" in found.values():
                units[text(row.equation)] = found
    assert len(units) > 5
    made_of = {unit for found in units.values() for unit in found.values()}
    assert made_of - {""} == {"kg", "m"}  # an index has no unit


@pytest.mark.parametrize("name", ["principal-axes", "cone-on-its-tip", "wobble-to-spin"])
def test_symbols_of_their_own_are_explained(judged, solutions, name):
    everything = [
        *(j for _, row in judged for j in row),
        *(j for x in solutions for j in x.judgements),
    ]
    judgement = next(judgement for judgement in everything if judgement.claim.name == name)
    used = symbols_used(claim_blocks(judgement))
    # Of any two vectors there are components, which need no words.
    free = {f"{x}_{k}" for x in "uv" for k in (1, 2, 3)} | {"d3r"}
    assert {x.name for x in used if known(x)[1] is None} <= free


def test_every_exercise_stands_once_in_its_section(recorded):
    titles = [block.title for block in recorded.blocks if isinstance(block, ExerciseHead)]
    assert sorted(titles) == sorted(exercise.title for exercise in EXERCISES)


def test_a_claim_of_the_lecture_is_named_and_not_repeated(recorded, solutions):
    heads = [block.name for block in recorded.blocks if isinstance(block, ClaimHead)]
    assert len(set(heads)) == len(heads)
    assert {j.claim.name for solution in solutions for j in solution.judgements} <= set(heads)
    shown = [plain.rich(b.content) for b in recorded.blocks if isinstance(b, Paragraph)]
    assert any(words.startswith("We have shown: “") for words in shown)


def test_the_record_has_every_line_once(recorded, document):
    def lines(whole):
        rows = (row for b in whole.blocks if isinstance(b, Display) for row in b.rows)
        return [row.line for row in rows if row.line and row.reason]

    there = lines(recorded)
    assert len(set(there)) == len(there)
    assert set(there) == set(lines(document))


def test_a_student_sees_no_solution(document, for_students, solutions):
    asked, pictures = for_students
    told, known = (
        " ".join(b.caption for b in each.blocks if isinstance(b, Figure))
        for each in (asked, document)
    )
    for answer in ("0.66", "1.71 N m", "0.391 s", "76.5 %"):
        assert answer in known
        assert answer not in told
    assert not any(picture.name.startswith("exercise-") for picture in pictures)
    assert not any(_is(block, "numbers", "values") for block in asked.blocks)
    heads = [b.number for b in asked.blocks if isinstance(b, ExerciseHead)]
    assert heads == list(range(1, len(EXERCISES) + 1))
    new = {j.claim.name for s in solutions for j in s.judgements} - {
        claim.name for page in PAGES for claim in page.claims
    }
    assert new
    assert not new & _marked(asked)
    assert new <= _marked(document)


def test_a_student_has_no_quarrel_with_the_notes(document, for_students):
    quarrels = {Verdict.FALSE, Verdict.CONVENTION}
    for whole, student in ((for_students[0], True), (document, False)):
        shown = {"legend": {v for v, _ in _one(whole, Legend).rows}}
        shown["summary"] = {v for *_, v in _one(whole, Results).rows}
        shown["margin"] = {mark.verdict for mark in _marks(whole)}
        for place, verdicts in shown.items():
            assert bool(verdicts & quarrels) is not student, place


def _one(document, kind):
    [block] = [block for block in document.blocks if isinstance(block, kind)]
    return block


def _marked(document):
    """The claims that have a mark."""
    return {mark.name for mark in _marks(document)}


def _marks(document):
    rows = (row for b in document.blocks if isinstance(b, Display) for row in b.rows)
    said = (block for block in document.blocks if isinstance(block, Paragraph))
    return [each.mark for each in (*rows, *said) if each.mark is not None]


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


def test_a_false_statement_stands_with_its_numbers_and_its_right_form(document):
    said = [plain.rich(b.content) for b in document.blocks if isinstance(b, Paragraph)]
    (words,) = [each for each in said if each.startswith("The notes say: In the space frame all")]
    assert "This is false: at λ₁ = 1, λ₂ = 2" in words
    assert "ψ = 0, I_xz ≠ 0 would be 0 ≠ 0" in words
    assert any("ψ = 0, r′ = Or would be 1 = −2.253 in component 1" in x for x in said)
    assert any(
        "(3.47) as the notes print it would be ¼√3 = −½√3 in row 1, column 2" in x for x in said
    )
    place = said.index(words)
    (row,) = next(
        b.rows
        for b in document.blocks[document.blocks.index(_paragraph(document, place)) :]
        if isinstance(b, Display)
    )
    assert text(row.equation) == "I_xz = (λ₃ − λ₁) sin θ cos θ cos φ"


def _paragraph(document, place):
    return [block for block in document.blocks if isinstance(block, Paragraph)][place]


def _formulas(tree):
    """What a block says in letters, but in its displays."""
    if isinstance(tree, str):
        yield from (part for formal, part in parts(tree) if formal)
    elif isinstance(tree, tuple):
        for each in tree:
            yield from _formulas(each)
    elif isinstance(tree, Node):
        yield latex(tree)
    elif is_dataclass(tree) and not isinstance(tree, (UprightUnit, Cited, Display, Results)):
        for field in fields(tree):
            yield from _formulas(getattr(tree, field.name))


def _letters_of(tree):
    found = [each for words in _formulas(tree) for each in LETTER.finditer(braced(words))]
    letters = (characters(x["letter"] + x["primes"]) for x in found if x["letter"])
    return {unicodedata.normalize("NFD", x) for x in letters}


def test_every_letter_is_listed_or_introduced(document):
    (symbols,) = [block for block in document.blocks if _is(block, "symbols")]
    said = _letters_of(tuple(b for b in document.blocks if b is not symbols))
    listed = _letters_of(tuple(node for node, *_ in symbols.rows))
    # Coordinates, any vector and any axis, indices, the imaginary unit, d of a rate, e of a power.
    introduced = {*"xyzwnilπde", "m₁", "m₂", "m₃"}
    assert introduced < said
    known = listed | introduced
    others = {re.sub("[\u0307\u0308]", "", x.replace("_i", "ᵢ")) for x in said - known}
    assert {re.sub("ₖ|_k", "₁", x) for x in others - known} <= known


def test_the_laws_that_pages_cite_are_printed(document, lines):
    rows = [row for block in document.blocks if isinstance(block, Display) for row in block.rows]
    laws = {"1.20", "2.84", "2.85", "3.12", "3.26", "3.32"}
    assert laws <= {row.tag for row in rows}
    cited = {p.anchor for row in rows for p in row.reason if isinstance(p, Cited)}
    assert "claim-1-20" in cited
    alone = law_blocks(lines, {"opening"})
    own = {row.tag for block in alone if isinstance(block, Display) for row in block.rows}
    assert laws & own == {"3.12"}
    assert law_blocks(lines, {"laws"}) == []


def test_figures_are_numbered_in_order_and_cited(document):
    figures = [block for block in document.blocks if isinstance(block, Figure)]
    assert [figure.number for figure in figures] == list(range(1, len(figures) + 1))
    contents = [b.content for b in document.blocks if isinstance(b, Paragraph)]
    contents += [row.spoken for b in document.blocks if isinstance(b, Display) for row in b.rows]
    cited = {piece.anchor for c in contents for piece in c if isinstance(piece, Cited)}
    spoken = {f.anchor for f in figures if not f.name.startswith("exercise-")} - {"figure-map"}
    assert spoken <= cited


def test_the_map_has_every_number_and_nothing_in_its_arrows_way(pictures, lines):
    shown = next(each for each in pictures if each.name == "map").drawing.draw()
    words = {each.get_text() for each in shown.axes[0].texts}
    assert {f"(3.{n})" for n in range(33, 58)} <= words
    made, arrows = columns(reduced(lines.map))
    at = {cell: k for k, column in enumerate(made) for cell in column}
    assert all(at[end] == at[start] + 1 for start, end in arrows)
    boxes = [cell for cell in at if not cell[1]]
    assert sorted(name for name, _ in boxes) == sorted(lines.map)
    room = {cell: 0.8 if cell[1] else 1.6 for cell in at}
    down = heights(made, arrows, room)
    for column in made:
        order = sorted(column, key=down.__getitem__)
        for upper, lower in pairwise(order):
            assert down[lower] - down[upper] >= (room[lower] + room[upper]) / 2 - 1e-9


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
    # There is room to write beneath each, and where it all comes from stands at the end.
    assert document.blocks.count(Room()) == len(EXERCISES)
    for source in (tex.write(document, {}), typst.write(document, {}), html.write(document, {})):
        assert source.count("45mm") >= len(EXERCISES) or source.count('class="room"') == len(heads)
        assert source.index("Sebastian") > source.rindex("Given")
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
    whole = replace(document, blocks=tuple(projected(document.blocks)))
    path.write_text(html.write(whole, svg, slides=True), "utf-8")
    driver = chrome()
    driver.get(path.as_uri())
    yield driver
    driver.quit()


SLIDES = """const all = document.createElement("style");
const each = ".shown .slide";
all.textContent = `${each} { display: flow-root } ${each}:has(figure) { display: flex }`;
document.head.append(all);
const size = (math) => parseFloat(getComputedStyle(math).fontSize);
const beside = (node) => node.scrollWidth - node.clientWidth;
const right = (node) => node.getBoundingClientRect().right;
const out = (node) => right(node) - right(node.parentNode);
return [...document.querySelectorAll(".slide")].map((slide) => [
  slide.scrollHeight - slide.clientHeight,
  Math.max(beside(slide), ...[...slide.querySelectorAll(".eq")].map(beside),
    ...[...slide.querySelectorAll("figcaption")].map(out)),
  Math.min(...[...slide.querySelectorAll(".eq:not(.recalled) math")].map(size)),
  slide.textContent,
])"""
ALONE = """return slides.flatMap((slide) => [...slide.querySelectorAll(".why")].filter((why) => {
  const [, meant] = /^(?!.*\\. ).*\\b(it|both(?! sides))\\b/.exec(why.textContent) ?? [];
  const before = [...slide.querySelectorAll(".eq")].filter(
    (eq) => why.compareDocumentPosition(eq) & Node.DOCUMENT_POSITION_PRECEDING);
  return meant && before.length < (meant === "both" ? 2 : 1);
}).map((why) => why.textContent))"""
PRESS = "dispatchEvent(new KeyboardEvent('keydown', { key: arguments[0] }))"
SHOWN_NOW = """const now = document.querySelector(".slide.now");
return [now.textContent, now.querySelectorAll(".covered").length, location.hash]"""


def test_no_slide_is_longer_than_the_screen(projector):
    slides = projector.execute_script(SLIDES)
    assert 50 < len(slides) <= 70
    for over, beside, letters, words in slides:
        assert over <= 0, words
        assert beside <= 1, words
        assert letters is None or letters >= 28, words
        assert "as above" not in words
    # What a sentence means by "it" and "both" is on its slide, but where a line fills that.
    assert len(projector.execute_script(ALONE)) <= 1
    # Whose notes they are is said.
    assert "Wüster" in slides[0][3]


MARK = """const row = document.querySelector(".slide.now .row:has(.seal)");
const middle = (node) => {
  const { y, height } = node.getBoundingClientRect();
  return y + height / 2;
};
const signs = [...row.querySelectorAll(".eq mo")].filter(
  (mo) => mo.textContent === "=" && mo.getClientRects().length);
return middle(row.querySelector(".seal")) - middle(signs.at(-1))"""


def test_a_mark_stands_at_the_sign_of_the_last_line(projector):
    """Also where a brace hangs beneath that."""
    for place in ("3-37", "3-49", "3-57", "3.57"):
        projector.execute_script(f"location.replace('#{place}')")
        assert abs(projector.execute_script(MARK)) < 2


ASTRAY = """const [words] = arguments;
[...document.querySelectorAll(".tools label")].find((each) => each.textContent === words).click();
const every = [...document.querySelectorAll(".row .seal")];
const seals = every.filter((seal) => seal.getClientRects().length);
return [seals.length, seals.filter((seal) => {
  const { y, height } = seal.getBoundingClientRect();
  const { top, bottom } = seal.closest(".row").querySelector(".eq").getBoundingClientRect();
  return y + height / 2 < top || y + height / 2 > bottom;
}).length]"""


def test_a_mark_stays_beside_its_equation_in_every_view(made, tmp_path):
    path = tmp_path / "lecture.html"
    path.write_text(made, "utf-8")
    driver = chrome()
    try:
        driver.get(path.as_uri())
        for view in ("Results only", "Steps", "Steps and reasons"):
            marks, astray = driver.execute_script(ASTRAY, view)
            assert marks > 80, view
            assert astray == 0, view
    finally:
        driver.quit()


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


@pytest.mark.parametrize(
    ("words", "cited"),
    [
        ("see [the figure](#figure-torque).", "figure 6"),
        ("[The figure](#figure-torque) shows it.", "Figure 6"),
    ],
)
def test_a_figure_is_cited_as_the_sentence_has_it(words, cited):
    figures = {"torque": Figure("torque", "A caption.", "A picture.", 6)}
    [piece] = [each for each in running([words], figures=figures) if isinstance(each, Cited)]
    assert piece.words == cited


def test_a_lecture_of_ones_own_looks(document):
    look = Look("letter", "% mine\n", "scrartcl")
    own = replace(document, look=look, title="Kreisel", byline="A. Lecturer, PHY 305")
    source = tex.write(own, {b.name: "x" for b in own.blocks if isinstance(b, Figure)})
    assert r"\documentclass[10pt,letterpaper,fleqn]{scrartcl}" in source
    assert re.search(r"% mine\s+\\begin\{document\}", source)
    assert "A. Lecturer, PHY 305" in source
    assert "pdftitle={Kreisel}" in source


def test_a_matrix_keeps_its_columns_in_the_summary(document):
    (results,) = (block for block in document.blocks if isinstance(block, Results))
    (row,) = (row for row in results.rows if row[0] == "3.47")
    (rows,) = re.findall(r"\\begin{bmatrix}(.*?)\\end{bmatrix}", tex.tex_block(Results((row,))))
    assert [line.count("&") for line in rows.split(r"\\")] == [2, 2, 2]
    assert len({number for number, *_ in results.rows}) == len(results.rows)


def test_the_summary_speaks_of_conditions_where_a_mark_has_some(judged):
    parts = Parts(Lecture(), NOTES, {}, {})
    for page, judgements in judged:
        marks = {each.verdict for each in judgements if is_number(each.claim.name)}
        said = [
            block for block in summary([(page, judgements)], parts) if isinstance(block, Paragraph)
        ]
        assert said == [Paragraph((CONDITIONS,))] * (Verdict.ASSUMING in marks), page.section
