"""`rigidtop check`: each line of every page is judged; pages are read to their end."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from rigidtop.cli import main
from rigidtop.commands import new
from rigidtop.terminal.files import write_all


@pytest.fixture
def course(tmp_path: Path) -> Path:
    """The collection that `rigidtop new` writes."""
    folder = tmp_path / "my_course"
    starter = new.STARTER
    write_all(folder, {f.name: f.read_bytes() for f in starter.glob("*") if f.is_file()})
    return folder


def add(course: Path, text: str) -> Path:
    page = course / "pendulum.md"
    page.write_text(page.read_text("utf-8") + f"\n{text}\n", "utf-8")
    return page


def lines(path: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, list[dict]]:
    code = main(["check", str(path), "--lines", "--json"])
    return code, json.loads(capsys.readouterr().out)


WRONG_REMARK = """## A remark

Multiply the kinetic energy by $2$:

$$2T = 3 m l^2\\dot\\theta^2$$"""


def test_a_line_that_no_claim_needs_is_judged(course, capsys):
    assert main(["check", f"{course}/"]) == 0
    add(course, WRONG_REMARK)
    capsys.readouterr()
    assert main(["check", f"{course}/"]) == 1
    out = " ".join(capsys.readouterr().out.split())
    assert "pendulum.md, line" in out
    assert "does not follow" in out
    assert out.endswith("2 claims: 1 proved, 1 assuming; of 16 lines 1 does not follow; NOT PASSED")


def test_each_line_says_what_becomes_of_it_in_worlds(course, capsys):
    page = add(course, WRONG_REMARK)
    _, rows = lines(course, capsys)
    worlds = {row["worlds"] for row in rows if row["file"] == page.name}
    assert rows[-1]["worlds"] == "undecided"  # its move does not arrive
    assert {"sampled", "premise"} <= worlds
    assert "false" not in worlds


def test_each_display_has_a_verdict_and_its_place(course, capsys):
    page = add(course, WRONG_REMARK)
    code, rows = lines(course, capsys)
    assert code == 1
    source = page.read_text("utf-8").splitlines()
    begins = [k for k, text in enumerate(source, 1) if text.startswith("$$")]
    assert [row["line"] for row in rows if row["file"] == "pendulum.md"] == begins
    assert rows[-1]["verdict"] == "gap"
    assert rows[-1]["note"].startswith("the move does not arrive here: it gives 2T = ml²θ̇²;")
    assert {row["verdict"] for row in rows[:-1]} == {"premise", "follows"}


def test_a_display_in_a_quotation_is_told_at_its_own_line(course, capsys):
    page = add(course, "> A quotation says\n> that:\n>\n> $$\n> T = 0\n> $$")
    code, rows = lines(course, capsys)
    assert code == 1
    source = page.read_text("utf-8").splitlines()
    assert rows[-1]["line"] == source.index("> $$") + 1
    assert rows[-1]["note"] == "a display stands by itself, between empty lines and in $$"


def test_a_claim_behind_a_numbered_gap_does_not_pass(course, capsys):
    page = course / "pendulum.md"
    text = page.read_text("utf-8")
    numbered = text.replace(
        r"$$\frac{\partial\mathcal L}{\partial\theta} = -mgl\sin\theta$$",
        r"$$\frac{\partial\mathcal L}{\partial\theta} = -2mgl\sin\theta \tag{1.0}$$",
    )
    assert numbered != text
    page.write_text(numbered, "utf-8")
    assert main(["check", f"{course}/", "1.1"]) == 1
    out = capsys.readouterr().out
    assert "NOT PASSED: 1.1" in out
    assert main(["derive", f"{course}/", "1.1"]) == 1
    assert "does not follow" in capsys.readouterr().out


def test_a_claim_with_a_gap_below_is_not_called_proved(course, tmp_path, capsys):
    page = course / "pendulum.md"
    text = page.read_text("utf-8")
    page.write_text(text.replace("= -mgl\\sin\\theta$$", "= -2mgl\\sin\\theta$$", 1), "utf-8")
    assert main(["check", f"{course}/", "--json"]) == 1
    verdicts = {each["name"]: each["verdict"] for each in json.loads(capsys.readouterr().out)}
    assert verdicts == {"1.1": "undecided", "from-energy": "assuming"}
    counts = "2 claims: 1 assuming, 1 undecided; of 15 lines 2 do not follow;"
    for words, besides in (
        (["check", f"{course}/"], ""),
        (["lecture", f"{course}/", "-o", str(tmp_path / "out")], "1 exercise not confirmed; "),
    ):
        assert main(words) == 1
        last = " ".join(capsys.readouterr().out.split())
        assert last.endswith(f"{counts} {besides}NOT PASSED: 1.1")


def test_the_last_line_tells_of_faults_too(course, tmp_path, capsys):
    assert main(["check", f"{course}/"]) == 0
    last = "15 lines follow; nothing failed that the notes get right"
    out = " ".join(capsys.readouterr().out.split())
    assert out.endswith(f"2 claims: 1 proved, 1 assuming; {last}")
    assert main(["check", f"{course}/", "1.1"]) == 0
    last = "1 claim: 1 proved; 10 lines follow; nothing failed that the notes get right"
    assert " ".join(capsys.readouterr().out.split()).endswith(last)
    assert main(["check", f"{course}/", "--quick"]) == 0
    last = "1 proved, 1 assuming; lines were not judged; nothing failed that the notes get right"
    assert " ".join(capsys.readouterr().out.split()).endswith(last)
    add(course, "It follows from (7.77) at once.")
    for words in (["check", f"{course}/"], ["lecture", f"{course}/", "-o", str(tmp_path / "out")]):
        assert main(words) == 1
        out = " ".join(capsys.readouterr().out.split())
        assert "no line has the number (7.77)" in out
        assert out.endswith("15 lines follow; 1 fault; NOT PASSED")


def test_a_page_by_itself_is_judged_in_the_letters_of_the_lecture(tmp_path, capsys):
    page = tmp_path / "own.md"
    page.write_text(
        "# Mine\n\nSolve (3.57) for $\\Omega$, with the discriminant:\n\n"
        "$$\\Omega_- = \\frac{\\lambda_3\\omega_3 - \\sqrt D}{2\\lambda_1\\cos\\theta}, \\quad"
        "\\Omega_+ = \\frac{\\lambda_3\\omega_3 + \\sqrt D}{2\\lambda_1\\cos\\theta}$$\n\n"
        "Square (3.44):\n\n$$T^2 = 0$$\n",
        "utf-8",
    )
    code, (roots, wrong) = lines(page, capsys)
    assert code == 1
    assert (roots["line"], roots["verdict"]) == (5, "follows")
    assert "cos θ ≠ 0" in roots["conditions"]
    assert (wrong["line"], wrong["verdict"]) == (9, "gap")
    assert wrong["file"] == str(page)


FAULTS = {
    "## Empty": "",
    "Twice the kinetic energy is:\n\nNothing stands here.": "a sentence ends in a colon",
    "It follows from (7.77) at once.": "no line has the number (7.77)",
    '<a name="mine"></a>\n\nWords.': "an anchor is written",
    "Multiply the kinetic energy by $2$:\n\n$$2T = m l^2\\dot\\theta^2 \\tag{1.1}$$": (
        "(1.1) is the number of a line above"
    ),
    "## Laws\n\nThe weight:\n\n$$V = 2V$$": "'The weight' has no source",
}


def test_a_page_is_read_to_its_end(course, capsys):
    for text in [*FAULTS][1:]:
        add(course, text)
    add(course, "Frobnicate it:\n\n$$x = $$")
    assert main(["check", f"{course}/"]) == 1
    out = capsys.readouterr().out
    assert all(said in out for said in FAULTS.values())
    assert "not read" in out
    assert main(["derive", f"{course}/", "1.1"]) == 2
    assert "pendulum.md, line" in capsys.readouterr().err


def test_a_list_may_follow_a_colon(course, capsys):
    add(course, "There are two of them:\n\n- one\n- two")
    assert main(["check", f"{course}/"]) == 0


def test_a_mistyped_anchor_is_named(course, capsys):
    page = course / "pendulum.md"
    text = page.read_text("utf-8")
    assert '<a id="from-energy"></a>' in text
    module = course / "pendulum.py"
    source = module.read_text("utf-8")
    start = source.index('@claim("from-energy"')
    end = source.index("page = Page(")
    claim = 'from_energy = Claim("from-energy", "It follows.")\n\n\n'
    module.write_text(source[:start] + claim + source[end:], "utf-8")
    module.write_text(module.read_text("utf-8").replace("Page, Step", "Claim, Page, Step"), "utf-8")
    assert main(["check", f"{course}/"]) == 0, capsys.readouterr().out
    page.write_text(text.replace('id="from-energy"', 'id="from-enregy"'), "utf-8")
    capsys.readouterr()
    assert main(["check", f"{course}/"]) == 1
    out = " ".join(capsys.readouterr().out.split())
    assert "no line of the pages is called from-energy; one is from-enregy" in out


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ('"kg"', '"pound"', "the unit 'pound' of m is not known: write it in kg, m, s, A, K"),
        (
            'Glyph("m")',
            'Glyph("ж")',
            "no document can set 'ж', the letter of m",
        ),
    ],
)
def test_a_letter_that_no_line_can_be_held_to_is_refused(right, wrong, said, course, capsys):
    letters = course / "letters.py"
    text = letters.read_text("utf-8")
    assert right in text
    letters.write_text(text.replace(right, wrong), "utf-8")
    assert main(["check", f"{course}/"]) == 2
    assert said in capsys.readouterr().err


def test_a_gap_is_told_wherever_a_result_is_shown(course, tmp_path, capsys):
    page = course / "pendulum.md"
    text = page.read_text("utf-8")
    page.write_text(text.replace("= -mgl\\sin\\theta$$", "= -2mgl\\sin\\theta$$", 1), "utf-8")
    assert main(["map", f"{course}/"]) == 1
    assert "Not every line to these follows: (1.1)" in capsys.readouterr().out
    assert main(["map", f"{course}/", "--json"]) == 1
    results = {each["name"]: each for each in json.loads(capsys.readouterr().out)["results"]}
    assert results["1.1"]["follows"] is False
    assert main(["lecture", f"{course}/", "-o", str(tmp_path / "out")]) == 1
    assert "does not follow" in capsys.readouterr().out
    page.write_text(text + "\n" + WRONG_REMARK, "utf-8")  # to which no result is led
    assert main(["map", f"{course}/"]) == 0
    assert main(["lecture", f"{course}/", "-o", str(tmp_path / "out")]) == 1


@pytest.mark.parametrize("text", ["", "## The pendulum\n"])
def test_no_claim_passes_on_an_empty_page(course, text, capsys):
    (course / "pendulum.md").write_text(text, "utf-8")
    assert main(["check", f"{course}/", "--json"]) == 1
    claims = json.loads(capsys.readouterr().out)
    assert [(claim["verdict"], claim["passed"]) for claim in claims] == [("undecided", False)] * 2


@pytest.mark.parametrize(
    ("sentence", "says"),
    [
        ("Put the pair into it", "nothing above is called 'the pair'; a line goes by its number"),
        ("Put both into it", "a line is put into another, not into itself"),
    ],
)
def test_what_is_put_in_is_asked_for_by_a_name(sentence, says, course, capsys):
    right = "$$2T = ml^2\\dot\\theta^2$$"
    doubled = f"Multiply the kinetic energy by $2$:\n\n{right}\n\n"
    add(course, f"## A pair\n\n{doubled}{doubled}{sentence}:\n\n{right}")
    _, rows = lines(course, capsys)
    assert rows[-1]["verdict"] == "unread"
    assert says in rows[-1]["note"]
