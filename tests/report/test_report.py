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
from sympy import Add, Integer, Ne, Rational, cos, sin, sqrt, symbols

from rigidtop.errors import RigidtopError
from rigidtop.figures.catalog import FIGURES
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
from rigidtop.report import html, pdf, plain, tex, tex_lines, typst
from rigidtop.report.blocks import (
    ClaimHead,
    Display,
    DisplayRow,
    Document,
    Figure,
    Look,
    Paragraph,
    SectionHead,
    TableBlock,
    anchor,
    groups,
    is_number,
)
from rigidtop.report.claims import claim_blocks, said_at, short_number
from rigidtop.report.lecture import Edition, PlacedFigure, Wanted, fragment, write_lecture
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
from rigidtop.typeset import sizes
from rigidtop.typeset.latex import latex
from rigidtop.typeset.layout import layout
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


def test_a_claim_of_one_verdict_repeats_it_nowhere(judged):
    (shown,) = [
        b for b in claim_blocks(judged[0][1][2]) if getattr(b, "label", "") == "The notes print"
    ]
    assert {row.verdict for row in shown.rows} == {None}
    assert [row.tag for row in shown.rows] == ["", "3.45"]


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


def test_equal_sides_are_said_once():
    assert plain.rich(said_at(Counterexample({}, Integer(2), Integer(2)))) == "both sides are 2"


def _texts(blocks):
    return [block for block in blocks if isinstance(block, TableBlock) and block.kind == "text"]


def test_the_front_counts_and_lists(lecture):
    summary, found = _texts(lecture.blocks)
    assert [(*verdict, *count) for verdict, count, _ in summary.rows] == [
        ("proved", "1"),
        ("assuming", "1"),
        ("false", "1"),
        ("all", "3"),
    ]
    assert [plain.rich(row[1]) for row in found.rows] == ["3.57", "no-number"]
    assert [plain.rich(row[3]) for row in found.rows] == [
        "if the top is not upright (sin θ ≠ 0)",
        "The notes say: I is λ₁ − λ₃. This is false: at Ω = ½, θ = 0, I = λ₁ − λ₃ would be "
        "undefined = 343√2.",
    ]


def test_a_correction_with_a_fraction_is_listed(printed):
    with as_printed():
        right = Equation(*printed["3.45"].sides)
    found = Finding(Correction(right), Verdict.PROVED)
    wrong = Judgement(_claim("false", "It is not."), "3.2", Verdict.FALSE, (found,), 0.1)
    blocks = document([(Page("3.2", "x", "y", ()), (wrong,))]).blocks
    content = _texts(blocks)[1].rows[0][3]
    assert plain.rich(content).endswith("It should be φ̇ = (L_z − L₃ cos θ)/(λ₁ sin² θ).")
    flat = r"(L_{z} - L_{3}\cos\theta)/(\lambda_{1}\sin^{2}\theta)"
    assert flat in tex_lines.rich(content)


def test_fractions_in_sentences_have_brackets_where_they_need_them():
    a, b, c = symbols("a b c")
    shown = {
        (a + b) / c: "(a + b)/c",
        -a / (b * c): "-a/(bc)",
        a / (b + c): "a/(b + c)",
        a * cos(b) / c: r"(a\cos b)/c",
        a / b**2: "a/b^{2}",
        Rational(1, 2) * a: r"\tfrac{1}{2}a",
    }
    for value, written in shown.items():
        assert tex_lines.rich((layout(value),)) == f"${written}$"


def test_products_too_long_for_a_line_are_broken_before_and_inside_brackets():
    a, b, *many = symbols("a b x1:31")
    lines = sizes.lines(Equation(a, b * Add(*many)), limit=40)
    assert max(sizes.width(line.right) for line in lines) <= 40
    assert latex(lines[0].right) == "b"
    bracket = [latex(line.right) for line in lines[1:]]
    assert bracket[0].startswith(r" \cdot (")
    assert bracket[-1].endswith(")")
    assert "".join(bracket).count("x_") == 30
    vectors = Add(*(symbols("r_vec") * x for x in many))
    carried = [latex(line.right) for line in sizes.lines(Equation(a, b * vectors), limit=40)]
    assert carried[0].startswith(r"b(x_")  # a · would be the product of two vectors
    assert not any(r"\cdot" in line for line in carried)
    short = sizes.lines(Equation(a, b * Add(*many[:5])), limit=40)
    assert [latex(line.right) for line in short] == ["b(x_{1} + x_{2} + x_{3} + x_{4} + x_{5})"]


def test_rows_are_grouped_between_reasons_and_tags(judged):
    shown = Display(tuple(claim_blocks(judged[0][1][2])[1].rows))
    assert [len(group) for group in groups(shown)] == [2]
    reasons = tuple(replace(row, reason="why") for row in shown.rows)
    assert [len(group) for group in groups(Display(reasons))] == [1, 1]
    bare = Display(tuple(replace(row, reason="", tag="") for row in shown.rows))
    assert [len(group) for group in groups(bare)] == [2]


def test_names():
    assert is_number("3.57")
    assert not is_number("two-roots")
    assert anchor("3.57") == "claim-3-57"


def test_short_numbers():
    assert text(short_number(sqrt(3) / 16)) == "(1/16)√3"
    assert text(short_number(sin(Rational(2, 7)))) == "0.2818"
    assert text(short_number(Rational(-123456789, 1000))) == "−123457"


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


def test_html_badges_are_words(root):
    badges = [e for e in root.iter("span") if "badge" in (e.get("class") or "")]
    assert badges
    for badge in badges:
        words = "".join(badge.itertext()).split()
        assert words[-1] in {str(v) for v in Verdict}
        assert badge[0].get("aria-hidden") == "true"


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


def test_a_latex_fragment_begins_with_an_equation_or_a_sentence(judged):
    for _, judgements in judged:
        for judgement in judgements:
            for paste in re.split(r"^%.*\n", tex.fragment(claim_blocks(judgement)), flags=re.M):
                assert not paste.startswith("$\\Rightarrow")


def test_latex_fragment_is_equations_with_comments(judged):
    made = fragment(judged[0][1][0], "latex")
    assert made.startswith("% (3.57)  [assuming]\n% Steady precession & its rate.\n")
    outside = re.sub(r"\\begin\{align\*?\}.*?\\end\{align\*?\}", "", made, flags=re.DOTALL)
    kept = [line for line in outside.splitlines() if line and not line.startswith("%")]
    assert kept == [r"$\ddot{\theta} = 0$ in (3.54)", r"Lagrange's equation of (3.53)."]
    assert made.count(r"\tag{3.57}") == 1


def test_typst_document(lecture):
    source = typst.write(lecture, {"small": "figures/small.svg"})
    assert '#eq("3.57", "proved", $ 0 &= (lambda_(1) cos theta) Omega^(2)' in source
    assert "<claim" not in source  # labels are made by the function
    assert "inline(1/2)" in source


STEP = DisplayRow(Equation(lambda1, lambda3), "printed", reason="Put the moments equal:")


def test_a_step_in_typst_goes_on_the_words_above_it_or_has_one_line():
    said, step = Paragraph(("We go on.",)), Display((STEP,), step=True)
    long = replace(step, rows=(replace(STEP, tag="9.9"),))
    short, numbered = (
        typst.write(Document("T", "S", (said, each), "C"), {}) for each in (step, long)
    )
    assert '#step[#"Put the moments equal:";][#box($display(lambda_(1) = lambda_(3))$)]' in short
    assert '#held[#"We go on."; #"Put the moments equal:";]\n#eq("9.9", ""' in numbered


@pytest.mark.skipif(not shutil.which("pdftotext"), reason="needs pdftotext")
@pytest.mark.parametrize("count", [0, 8, 20, 44, 46])
def test_a_figure_in_typst_stands_above_nothing_of_what_comes_before_it(count):
    before = (*FILL[:count], SectionHead(1, "1", "Its section", "section-1"), FILL[count])
    source = typst.write(Document("T", "S", (*before, FIGURE, *FILL[80:]), "C"), {"small": "a.svg"})
    made = pdf.by_typst(source, {"a.svg": SVG.encode()})
    command = ["pdftotext", "-layout", "-", "-"]
    told = subprocess.run(command, input=made, capture_output=True, check=True).stdout.decode()
    places = [told.index(words) for words in (f"Line {count}.", "The caption", "Line 89.")]
    assert places == sorted(places)
    pages = told.split("\f")
    (page,) = (k for k, page in enumerate(pages) if "The caption" in page)
    if f"Line {count}." not in pages[page]:  # it is the first on its page
        assert pages[page].index("The caption") < pages[page].index("Line ")


@pytest.mark.skipif(not shutil.which("pdftotext"), reason="needs pdftotext")
def test_an_equation_that_no_break_makes_narrow_enough_is_smaller_in_typst():
    many = symbols("w10:70")
    wide = DisplayRow(Equation(lambda1, sqrt(Add(*many))), "printed", "9.9")
    made = pdf.by_typst(typst.write(Document("T", "S", (Display((wide,)),), "C"), {}), {})
    command = ["pdftotext", "-bbox", "-", "-"]
    told = subprocess.run(command, input=made, capture_output=True, check=True).stdout.decode()
    ends = {word: float(x) for x, word in re.findall(r'xMax="([\d.]+)" .*>(.*)</word>', told)}
    number = ends.pop("(9.9)")
    assert max(ends.values()) < number < (210 - 27) / 25.4 * 72


def test_typst_keeps_primes_and_small_fractions():
    assert typst.maths(r"\mathbf{e}_{1}'") == "upright(bold(e))'_(1)"
    assert typst.maths(r"\tfrac{1}{2}x") == "inline(1/2) x"
    assert typst.maths(r"\frac{\nu}{\mu}(x)") == "frac(nu, mu)(x)"
    assert typst.maths(r"x\frac{a}{12}b") == "x frac(a, 12) b"
    assert typst.maths(r"x = \text{const}") == 'x = "const"'


def test_dashes_of_words_in_a_typst_formula():
    assert "--" not in typst.prose("turns z–y′–z″")


def test_text_fragment(judged):
    assert fragment(judged[0][1][0], "text").splitlines()[:8] == [
        "(3.57)  [assuming]",
        "Steady precession & its rate.",
        "",
        "The notes print:",
        "  θ̈ = 0 in (3.54)",
        "    0 = λ₁φ̇² sin θ cos θ − λ₃(ψ̇ + φ̇ cos θ)φ̇ sin θ + MgR sin θ  [proved]",
        "    0 = λ₁Ω² cos θ − λ₃(ψ̇ + φ̇ cos θ)Ω + MgR, with ψ̇ + φ̇ cos θ ≡ ω₃  [assuming]",
        "    0 = (λ₁ cos θ)Ω² − (λ₃ω₃)Ω + MgR  (3.57)  [proved]",
    ]


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


def test_a_long_remark_may_stand_beneath_its_heading_in_html():
    assert re.search(r"\.head \{[^}]*flex-wrap: wrap", html.style("page.css"))


OPENING = (
    SectionHead(1, "1", "An opening", "section-1"),
    Paragraph(("What it is about.",), held=True),
    ClaimHead("a-claim", "claim-a", "It says so.", Verdict.PROVED),
    Paragraph(("The reason.",), "Reason"),
    Display((DisplayRow(Equation(lambda1, lambda3), "printed"),), "Derivation"),
)


def _page_of(made: bytes, words: str) -> int:
    """The last page that has the words: the first has the contents."""
    pages = [page.extract_text() for page in pypdf.PdfReader(io.BytesIO(made)).pages]
    return max(i for i, text in enumerate(pages) if words in text)


def set_once(source: str, folder: Path) -> bytes:
    """The pages of a document without its contents, which a second time would bring."""
    (folder / "once.tex").write_text(source, "utf-8")
    command = ["pdflatex", "-interaction=batchmode", "-halt-on-error", "once.tex"]
    for path in folder.glob("once.[!t]*"):
        path.unlink()
    subprocess.run(command, cwd=folder, check=True, capture_output=True, timeout=120)
    return (folder / "once.pdf").read_bytes()


@pytest.mark.skipif(not shutil.which("latexmk"), reason="needs latexmk")
def test_a_section_opens_with_its_first_claim_in_latex(tmp_path):
    for count in range(26, 36, 2):
        source = tex.write(Document("T", "S", (*FILL[:count], *OPENING), "C"), {})
        made = set_once(source, tmp_path)
        assert _page_of(made, "An opening") == _page_of(made, "The reason."), count


def test_a_section_opens_with_its_first_claim_in_typst():
    for count in range(24, 45):
        source = typst.write(Document("T", "S", (*FILL[:count], *OPENING), "C"), {})
        made = pdf.by_typst(source, {})
        assert _page_of(made, "An opening") == _page_of(made, "The reason."), count


FILL = tuple(Paragraph((f"Line {i}.",)) for i in range(90))
TABLE = TableBlock(("first", "second"), ((lay.Digits("1.5"),) * 2,) * 6, "The title of the table")


def _places(made: bytes) -> dict[str, int]:
    """The pages on which the title of the table, its first and its last row stand."""
    pages = [page.extract_text() for page in pypdf.PdfReader(io.BytesIO(made)).pages]
    titles = [i for i, words in enumerate(pages) if "The title of the table" in words]
    rows = [i for i, words in enumerate(pages) if "1.5" in words]
    assert len(titles) == 1
    return {"title": titles[0], "first": rows[0], "last": rows[-1]}


@pytest.mark.skipif(not shutil.which("latexmk"), reason="needs latexmk")
def test_a_table_stays_with_its_title_in_latex(tmp_path):
    for count in range(26, 34, 2):
        source = tex.write(Document("T", "S", (*FILL[:count], TABLE), "C"), {})
        made = set_once(source, tmp_path)
        assert len(set(_places(made).values())) == 1, count


def test_a_table_stays_with_its_title_in_typst():
    for count in range(24, 45):
        source = typst.write(Document("T", "S", (*FILL[:count], TABLE), "C"), {})
        assert len(set(_places(pdf.by_typst(source, {})).values())) == 1, count


def test_a_long_table_may_be_broken():
    long = replace(TABLE, rows=TABLE.rows * 20)
    made = pdf.by_typst(typst.write(Document("T", "S", (long,), "C"), {}), {})
    assert len(pypdf.PdfReader(io.BytesIO(made)).pages) > 1
    tables = tex.tex_block(long).split(r"\rttable")[1:]
    assert [made.count(r"$1.5$ \\") for made in tables] == [30] * 4


@pytest.mark.skipif(not shutil.which("latexmk"), reason="needs latexmk")
def test_wide_tables_and_figures_stand_behind_narrow_tables_of_their_solution():
    """They go over both columns, and would hold up what stands in one."""

    def numbered(title, columns):
        return TableBlock(tuple(f"$c_{k}$" for k in range(columns)), (("1",) * columns,), title)

    def words(text):
        return Paragraph((text,))

    first, second = (SectionHead(2, "", title, title) for title in ("First", "Second"))
    values = TableBlock(("what", "", ""), (("a", "1", ""),), "listed", "values")
    blocks = [
        *(
            words("above"),
            numbered("kept", 7),
            numbered("here", 6),
        ),  # in one column all stand still
        SectionHead(1, "", "Solutions", "solutions"),
        *(first, words("begins"), words("goes on"), values),
        *(numbered("wide", 7), FIGURE, numbered("narrow", 6), words("ends")),
        *(second, words("then"), numbered("wider", 9), words("last"), numbered("small", 2)),
    ]
    source = tex.write(Document("T", "S", tuple(blocks), "C"), {"small": "figures/small.pdf"})
    body = source[source.index(r"\begin{document}") :]
    order = [
        *("above", "kept", "here", "Solutions"),
        *("First", "begins", "narrow", "wide", "figures/small", "goes on", "listed", "ends"),
        *("Second", "then", "small", "wider", "last"),
    ]
    marks = {x: rf"rttable{{{x}}}" for x in ("kept", "here", "narrow", "wide", "small", "wider")}
    places = [body.index(marks.get(each, each)) for each in order]
    assert places == sorted(places)


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


def test_without_a_date_a_pdf_is_of_today(monkeypatch):
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)
    monkeypatch.setattr(pdf.time, "time", lambda: 1700006400 + 3600.5)
    assert pdf.written_at() == 1700006400


def test_contents_stand_where_there_are_sections():
    sheet = Document(
        "T", "S", (SectionHead(1, "", "List of symbols", "letters"),), "C", lecture=True
    )
    whole = replace(sheet, blocks=(*OPENING, *sheet.blocks))
    for by, mark in (
        (tex, "contentsname}\\rttoc}"),
        (typst, "#outline("),
        (html, '<nav class="toc"'),
    ):
        assert mark in by.write(whole, {})
        assert mark not in by.write(sheet, {})


def test_without_either_one_line_names_both(monkeypatch, judged, tmp_path):
    monkeypatch.setattr(pdf.shutil, "which", lambda name: None)
    monkeypatch.setattr(pdf, "find_spec", lambda name: None)
    with pytest.raises(RigidtopError, match=r"latexmk.*typst and tylax") as caught:
        write_lecture(judged, (), tmp_path / "out", wanted=Wanted(pdf=True))
    assert "\n" not in str(caught.value)
    assert not (tmp_path / "out").exists()  # nothing half-written


# --- Files ----------------------------------------------------------------------------------------


def test_the_lecture_is_written_whole_and_the_same_each_time(judged, tmp_path):
    written = write_lecture(judged, (), tmp_path / "deep" / "out")
    folder = tmp_path / "deep" / "out"
    names = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*.*"))
    assert names == sorted(path.relative_to(folder).as_posix() for path in written)
    assert names == [
        "figures/opening.pdf",
        "figures/opening.svg",
        "figures/precession-rates.pdf",
        "figures/precession-rates.svg",
        "lecture.html",
        "lecture.tex",
    ]
    again = write_lecture(judged, (), tmp_path / "again")
    assert [path.read_bytes() for path in written] == [path.read_bytes() for path in again]


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


def test_every_figure_of_the_lecture_has_words():
    for figure in (PlacedFigure(each.name, each, {}).described(1) for each in FIGURES):
        assert len(figure.alternative) > 80
        assert figure.alternative.isascii()  # it is spoken
        assert tex_lines.rich((figure.caption,))
