r"""A folder of Markdown alone is a collection: sections, claims and letters come from its pages."""

import json
from pathlib import Path

import pytest

from rigidtop import derivations
from rigidtop.cli import main
from rigidtop.collection import load
from rigidtop.collection.faults import faults, places
from rigidtop.collection.pages import KINDS, declared, table_of
from rigidtop.errors import RigidtopError
from rigidtop.figures.catalog import FIGURES
from rigidtop.starter import letters
from rigidtop.theory.lettered import Lettered

SPRING = r"""# 2 The spring

A cart of mass $m$ on a spring.

| letter | meaning | unit | kind |
| ------ | ------- | ---- | ---- |
| $m$ | mass of the cart | kg | positive |
| $k$ | stiffness | N/m | positive |
| $x_0$ | place of rest | m | number |
| $x$ | place | m | coordinate |
| $E$ | energy | J | |

## Laws

Hooke 1678 and Newton 1687. Along the motion, the law of the spring:

$$\ddot x = -\frac km x$$

Definition. The energy:

$$E = \tfrac12 m\dot x^2 + \tfrac12 kx^2$$

## Nothing is lost

The energy of the cart is conserved.

Differentiate the energy in time:

$$\dot E = m\dot x\ddot x + kx\dot x$$

<a id="kept"></a>

What the spring takes it gives back, as $\dot E$ says.

Substitute the law of the spring into $\dot E$:

$$\dot E = 0 \tag{2.1}$$
"""


@pytest.fixture
def spring(tmp_path):
    folder = tmp_path / "spring"
    folder.mkdir()
    (folder / "cart.md").write_text(SPRING, "utf-8")
    return folder


def test_sections_and_claims_are_those_of_the_pages(spring):
    (spring / "early.md").write_text("# 1.10 Before\n\nWords.\n", "utf-8")
    (spring / "notes.md").write_text("No section.\n", "utf-8")
    pages = load(spring).pages
    assert [(page.section, page.title, page.text) for page in pages] == [
        ("1.10", "Before", "early"),
        ("2", "The spring", "cart"),
    ]
    assert pages[1].about == "A cart of mass $m$ on a spring."
    assert [(claim.name, claim.says) for claim in pages[1].claims] == [
        ("kept", r"What the spring takes it gives back, as $\dot E$ says."),
        ("2.1", r"What the spring takes it gives back, as $\dot E$ says."),
    ]


def test_every_line_is_judged(spring, capsys):
    assert main(["check", f"{spring}/", "--json"]) == 0
    told = {each["name"]: each["verdict"] for each in json.loads(capsys.readouterr().out)}
    assert told == {"kept": "proved", "2.1": "proved"}
    wrong = SPRING.replace(r"+ kx\dot x", r"- kx\dot x")
    (spring / "cart.md").write_text(wrong, "utf-8")
    assert main(["check", f"{spring}/"]) == 1
    assert "cart.md, line 27, does not follow" in " ".join(capsys.readouterr().out.split())


def test_letters_have_kinds_and_rates_and_units(spring):
    collection = load(spring)
    by_name = {x.name: x for x in collection.notation.glyphs if isinstance(x, Lettered)}
    assert by_name["x_ddot"].quantity.unit == "m/s²"
    assert by_name["x_dot"].quantity.meaning == "rate of place"
    assert [by_name[x].is_positive for x in ("m", "x_0")] == [True, None]
    assert collection.letters.numbers == {by_name[x] for x in ("m", "k", "x_0")}
    assert collection.letters.coordinates == (by_name["x"],)


def test_a_wrong_unit_is_told(spring, capsys):
    (spring / "cart.md").write_text(SPRING.replace("| N/m |", "| N |"), "utf-8")
    assert main(["check", f"{spring}/"]) == 1
    told = " ".join(capsys.readouterr().out.split())
    assert "cart.md, line 15: the units disagree: ẍ is in" in told


@pytest.mark.parametrize(
    ("row", "why"),
    [
        ("| $m$ | mass | kg |", "cart.md, line 7: a letter has four columns"),
        ("| $m$ | mass | kg | great |", "line 7: 'great' is no kind of letter: positive, number,"),
        ("| mass | mass | kg | |", "line 7: mass is no letter between dollars, such as $m$"),
        ("| $m + k$ | mass | kg | |", "$m + k$ is no letter"),
        (r"| $\mathbf m$ | mass | kg | |", "a vector is bold, and what is bold is a vector"),
        ("| $x$ | way | m | coordinate |", "$x$ is 'way' already: a letter means one thing"),
        (r"| $\mathbf m$ | axis | | frame |", "a frame is three letters in one row"),
        (r"| $m$, $n$, $p$ | axes | | frame |", "a vector is bold, and what is bold is a vector"),
        ("| $m$ | mass | stone | positive |", "the unit 'stone' of m is not known"),
    ],
)
def test_a_row_that_declares_no_letter_is_told(spring, row, why):
    declared_so = SPRING.replace("| $m$ | mass of the cart | kg | positive |", row)
    (spring / "cart.md").write_text(declared_so, "utf-8")
    with pytest.raises(RigidtopError) as told:
        load(spring).lecture_with(())
    assert why in str(told.value)


def test_a_folder_without_a_section_is_no_collection(tmp_path):
    (tmp_path / "a.md").write_text("# Words\n", "utf-8")
    with pytest.raises(RigidtopError, match="begins with a section such as '# 1 The pendulum'"):
        load(tmp_path)


def test_what_is_started_as_a_page_passes_and_has_the_starters_letters(tmp_path, capsys):
    folder = tmp_path / "chapter"
    assert main(["new", "--page", str(folder)]) == 0
    assert [file.name for file in folder.iterdir()] == ["pendulum.md"]
    assert main(["check", f"{folder}/"]) == 0
    assert "2 claims: 1 proved, 1 assuming" in capsys.readouterr().out
    text = (folder / "pendulum.md").read_text("utf-8")
    own = [x for x in vars(letters).values() if isinstance(x, Lettered)]
    found = declared([("pendulum.md", text)]).symbols
    assert {x.quantity.glyph: x.quantity.unit for x in found} == {
        x.quantity.glyph: x.quantity.unit for x in own
    }
    assert table_of(sorted(own, key=lambda x: x.place)) in text


def test_the_kinds_are_those_of_the_guide():
    from pathlib import Path

    guide = Path(__file__).parents[2] / "notebooks" / "site" / "howto" / "own-page.md"
    assert all(f"`{kind}`" in guide.read_text("utf-8") for kind in KINDS)


PLAIN = r"""# 3 Second page

Ein Wagen.

Multiply the energy by $2$:

$$2E = m\dot x^2 + kx^2$$
"""


@pytest.mark.parametrize("alone", [False, True])
def test_a_page_without_claims_is_in_the_lecture(spring, alone, tmp_path, capsys):
    cart = spring / "cart.md"
    if alone:
        head = SPRING.partition("## Nothing is lost")[0]
        cart.write_text(head, "utf-8")
    (spring / "second.md").write_text(PLAIN, "utf-8")
    wanted = ["--slides", "--fragment", "--format", "myst", "--no-live"]
    assert main(["lecture", str(spring), "-o", str(tmp_path / "out"), *wanted]) == 0
    counts = "no claims" if alone else "2 claims"
    assert counts in capsys.readouterr().out
    files = "lecture.html", "lecture.tex", "slides.html", "chapters/3.tex", "myst/section-3.md"
    for name in files:
        written = (tmp_path / "out" / name).read_text("utf-8")
        assert "Second page" in written
        assert "Ein Wagen." in written
    assert "Hooke 1678" in (tmp_path / "out" / "lecture.html").read_text("utf-8")
    assert main(["lecture", str(spring), "-o", str(tmp_path / "out"), "--record"]) == 0
    assert "Ein Wagen." in (tmp_path / "out" / "record.html").read_text("utf-8")


LAW = "## Laws\n\n{}A further law:\n\n$$E = \\tfrac12 m\\dot x^2$$\n"
TABLE = "| letter | meaning | unit | kind |\n| - | - | - | - |\n| {} | {} | {} | positive |\n"
FAULTS = {
    "Frobnicate it:\n\n$$E = 0$$": "no move begins with 'Frobnicate'",
    "See [there](#nowhere).": "nothing has the name #nowhere, to which a link leads",
    "As [figure](#figure-nothing) shows.": "nothing has the name #figure-nothing",
    "Words 🙂.": "no document can set '🙂' (U+1F642)",
    "Turned \u202eround.": "no document can set '\\u202e' (U+202E)",
    "A bell \x07.": "no document can set '\\x07' (U+0007)",
    "## Heading ☃": "no document can set '☃' (U+2603)",
    "Hooke 1678. The 漢 law:\n\n$$x = x_0$$": "no document can set '漢' (U+6F22)",
    TABLE.format("$p$", "push", "pound"): "the unit 'pound' of p is not known: write it in kg",
    TABLE.format("$ж$", "push", "N"): "no document can set 'ж', the letter of ж",
    TABLE.format("$p$", "漢", "N"): "no document can set '漢' (U+6F22)",
    TABLE.format("p", "push", "N"): "p is no letter between dollars",
    TABLE.format("$m$", "push", "N"): "$m$ is 'mass of the cart' already",
    LAW.format("It is a nice day. "): "'A further law' has no source: say in front of it whose",
}


def check(folder, capsys):
    code = main(["check", f"{folder}/"])
    return code, " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize("text", FAULTS)
def test_a_fault_is_told_with_its_place(spring, text, capsys):
    source = f"{SPRING}\n{text}\n"
    (spring / "cart.md").write_text(source, "utf-8")
    told = FAULTS[text]
    at = SPRING.count("\n") + 2
    last = 2 * text.startswith(("| letter", "## Laws", "Frob"))
    code, out = check(spring, capsys)
    assert code == 1
    assert f"cart.md, line {at + last}: {told}" in out
    assert out.endswith("NOT PASSED")


def test_all_faults_are_told_in_one_run(spring, capsys):
    (spring / "cart.md").write_text("\n\n".join([SPRING, *FAULTS]), "utf-8")
    code, out = check(spring, capsys)
    assert code == 1
    assert [told for told in FAULTS.values() if told not in out] == []
    assert main(["derive", f"{spring}/", "2.1"]) == 2  # with letters of which nothing is known
    assert "cart.md, line 62: the unit 'pound' of p" in capsys.readouterr().err


def test_what_is_there_is_no_fault(spring, capsys):
    links = "[This](#kept), [that](#nothing-is-lost), [more](cart.md#2-the-spring)."
    fair = [links, "Naïve “x” — 3·10⁻⁴.", *(LAW.format(f"{whose} ") for whose in SOURCES)]
    (spring / "cart.md").write_text("\n\n".join([SPRING, *fair]), "utf-8")
    code, out = check(spring, capsys)
    assert code == 0, out


SOURCES = (
    "Definition.",
    "Given.",
    "Lagrange 1788.",
    "Coulomb's law: against the slip.",
    "Equation (1.2), for a cart.",
    "A well-known result (Landau and Lifshitz, section 32).",
    "Per mass it has half of that, by Steiner's theorem.",
)


HEADINGS = ("", "# Only a title\n", "# 3 A section\n", "## Deeper\n\n### Still\n")


@pytest.mark.parametrize("text", HEADINGS)
def test_an_empty_page_among_others_is_told(spring, text, capsys):
    (spring / "README.md").write_text("About this folder.\n", "utf-8")
    assert check(spring, capsys)[0] == 0
    (spring / "other.md").write_text(text, "utf-8")
    code, out = check(spring, capsys)
    assert code == 1
    assert "other.md, line 1: the page is empty: it has neither words nor displays" in out
    assert main(["check", f"{spring}/", "--lines", "--json"]) == 1
    capsys.readouterr()


def test_a_page_beside_the_lecture_has_faults_too(tmp_path, capsys):
    page = tmp_path / "mine.md"
    links = "[Here](#mine), [there](#nowhere), [the figure](#figure-cones)."
    page.write_text(f"# Mine\n\n{links}\n", "utf-8")
    assert main(["check", str(page), "--json"]) == 1
    rows = json.loads(capsys.readouterr().out)
    assert [(row["line"], row["note"]) for row in rows] == [
        (3, "nothing has the name #nowhere, to which a link leads")
    ]


def test_the_pages_that_come_with_rigidtop_have_none():
    root = Path(derivations.__file__).parent
    names = [f"figure-{each.name}" for each in FIGURES]
    for page in root.rglob("*.md"):
        source = page.read_text("utf-8")
        assert [*faults(source, [*names, *places(source)])] == [], page


MOMENTUM = r"""# 3 Free

| letter | meaning | unit | kind |
| ------ | ------- | ---- | ---- |
| $m$ | mass | kg | positive |
| $v$ | velocity | m/s | coordinate |
| $p$ | momentum | kg m/s | coordinate |

## Laws

Definition. The momentum:

$$p = mv$$

Newton 1687. Along the motion, the law of the free body:

$$\dot p = 0$$

## It goes on

Rewrite the law of the free body:

$$\dot p = 0$$

Substitute the momentum into it:

$$m\dot v = 0 \tag{3.1}$$
"""


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ("", "", ""),
        (r"m\dot v = 0", r"m\dot v = m\ddot vv/\dot v", "it gives mv̇ = 0"),
        ("| $m$ | mass | kg | positive |", "| $m$ | mass | kg | |", "it gives mv̇ + vṁ = 0"),
        ("Definition. The momentum:", "Definition. At the moment, the momentum:", "it gives ṗ = 0"),
    ],
)
def test_a_value_is_put_in_under_a_time_derivative(tmp_path, capsys, old, new, why):
    (tmp_path / "free.md").write_text(MOMENTUM.replace(old, new, 1) if old else MOMENTUM, "utf-8")
    assert main(["check", f"{tmp_path}/", "--lines", "--json"]) == (1 if why else 0)
    last = json.loads(capsys.readouterr().out)[-1]
    assert (last["verdict"] == "follows") == (not why)
    assert why in last["note"]


def diagonal(*entries):
    """A matrix in LaTeX that is 0 beside its diagonal."""
    zeros = range(len(entries))
    rows = (" & ".join(x if i == k else "0" for i in zeros) for k, x in enumerate(entries))
    return r"\begin{pmatrix}" + r" \\ ".join(rows) + r"\end{pmatrix}"


MATRICES = rf"""# 4 Matrices

| letter | meaning | unit | kind |
| ------ | ------- | ---- | ---- |
| $a$ | length | m | number |
| $b$ | width | m | number |
| $A$ | matrix | m | matrix |

## Laws

Definition. The lengths:

$$A = {diagonal(*"aaaaaa")}$$

Definition. The square:

$${diagonal(*"aaaaaa")} = {diagonal(*"bbbbbb")}$$

## What is wrong

"""


@pytest.mark.parametrize(
    ("line", "why"),
    [
        (
            f"Rewrite the lengths:\n\n$$A = {diagonal(*'baaaaa')}$$",
            ": in row 1, column 1 it gives a, the line has b",
        ),
        (
            f"Rewrite the square:\n\n$${diagonal(*'aaaaaa')} = {diagonal('2b', *'bbbbb')}$$",
            ": in row 1, column 1 it gives b, the line has 2b",
        ),
        (
            f"Rewrite the square:\n\n$${diagonal('3a', *'aaaaa')} = {diagonal(*'bbbbbb')}$$",
            ": in row 1, column 1 it gives a = b, the line has 3a = b",
        ),
        (
            f"Rewrite the lengths:\n\n$$2A = {diagonal(*'aaaaaa')}$$",
            ": it gives A with these entries and else zeros; a in row 1, column 1; "
            + "; ".join(f"a in row {k}, column {k}" for k in range(2, 7)),
        ),
        (
            f"Rewrite the lengths:\n\n$$A = {diagonal(*'bbbbbb')} + {diagonal(*'bbbbbb')}"
            r"\begin{pmatrix}" + r" \\ ".join(["1 & 1 & 1 & 1 & 1 & 1"] * 6) + r"\end{pmatrix}$$",
            ": in row 1, column 1 it gives a, the line has 2b; "
            + "".join(f"in row 1, column {k} it gives 0, the line has b; " for k in range(2, 7))
            + "…",
        ),
    ],
)
def test_of_matrices_is_told_what_differs(tmp_path, capsys, line, why):
    (tmp_path / "matrices.md").write_text(f"{MATRICES}{line}\n", "utf-8")
    assert main(["check", f"{tmp_path}/", "--lines", "--json"]) == 1
    last = json.loads(capsys.readouterr().out)[-1]
    assert last["note"] == f"the move does not arrive here{why}"
