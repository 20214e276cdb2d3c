"""``rigidtop audit``: what it prints, what it writes, what it refuses."""

import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from rigidtop.cli import main

EULER = (
    "Along the axes:\n\n"
    "$$\\lambda_1\\dot\\omega_1 = (\\lambda_2 {} \\lambda_3)\\omega_2\\omega_3,$$\n\n"
    "$$\\lambda_2\\dot\\omega_2 = (\\lambda_3 - \\lambda_1)\\omega_3\\omega_1,$$\n\n"
    "$$\\lambda_3\\dot\\omega_3 = (\\lambda_1 - \\lambda_2)\\omega_1\\omega_2$$\n(3.36)\n"
)
MATRIX = "$\\mathbf{r}' = O^T\\mathbf{r}$ (3.46)\n"


@pytest.fixture
def file(tmp_path):
    def written(text, name="own.md"):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return str(path)

    return written


def test_a_slip_fails_and_is_refuted_in_its_line(capsys, file):
    assert main(["audit", file(EULER.format("+") + MATRIX)]) == 1
    shown = capsys.readouterr().out
    assert shown.startswith("line 3 (3.36) is wrong: it holds with another sign before λ₃\n")
    assert "\n  written  λ₁ ω̇₁ = (λ₂ + λ₃) ω₂ ω₃\n" in shown
    assert "2 numbered equations: 1 convention, 1 false" in shown


def test_records(capsys, file):
    assert main(["audit", file(EULER.format("-") + MATRIX + "$T = \\oops$ (3.44)"), "--json"]) == 0
    euler, matrix, broken, *absent = json.loads(capsys.readouterr().out)
    assert [row["name"] for row in (euler, matrix, broken)] == ["3.36", "3.46", "3.44"]
    assert (euler["verdict"], euler["passed"], euler["line"]) == ("proved", True, 3)
    assert [(e["line"], e["column"], e["verdict"]) for e in euler["equations"]] == [
        (3, 3, "proved"),
        (5, 3, "proved"),
        (7, 3, "proved"),
    ]
    assert euler["equations"][0]["read"] == "λ₁ ω̇₁ = (λ₂ − λ₃) ω₂ ω₃"
    assert (matrix["verdict"], matrix["passed"], matrix["reference"]) == ("convention", True, "3.4")
    assert (broken["verdict"], broken["passed"], broken["line"]) == ("unread", None, 10)
    assert broken["equations"][0]["read"] is None
    assert "\\oops" in broken["equations"][0]["problem"]
    assert [row["name"] for row in absent][:2] == ["3.37", "3.38"]
    assert {(row["verdict"], row["line"], row["passed"]) for row in absent} == {
        ("absent", None, None)
    }


def test_numbers_that_the_file_leaves_out_are_told(capsys, file):
    assert main(["audit", file(EULER.format("-") + MATRIX)]) == 0
    assert "; not in the file: (3.37), (3.38)," in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize(
    ("written", "number"),
    [("$$T = V \\tag{12}$$", "12"), ("$$T = V \\tag{A.3}$$", "A.3"), ("$T = V$ (7)", "7")],
)
def test_a_number_of_no_claim_is_told_with_its_line(written, number, capsys, file):
    assert main(["audit", file(f"{written}\n"), "--json"]) == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert (row["name"], row["line"], row["verdict"]) == (number, 1, "definition")


PENDULA = r"""
$$x_1 = l_1\sin\theta_1,\quad y_1 = -l_1\cos\theta_1,\quad
  x_2 = x_1 + l_2\sin\theta_2,\quad y_2 = y_1 - l_2\cos\theta_2$$
$$T = \tfrac12 m_1(\dot x_1^2 + \dot y_1^2) + \tfrac12 m_2(\dot x_2^2 + \dot y_2^2)$$
$$L = T - m_1 g y_1 - m_2 g y_2$$

## The equations of motion

$$(m_1 + m_2)l_1\ddot\theta_1 + m_2l_2\ddot\theta_2\cos(\theta_1 - \theta_2)
  + m_2l_2\dot\theta_2^2\sin(\theta_1 - \theta_2) + (m_1 + m_2)g\sin\theta_1 = 0$$
$$l_2\ddot\theta_2 + l_1\ddot\theta_1\cos(\theta_1 - \theta_2)
  SIGN l_1\dot\theta_1^2\sin(\theta_1 - \theta_2) + g\sin\theta_2 = 0 \tag{7}$$
"""


def test_the_wrong_sign_of_a_double_pendulum_is_found_from_its_own_lagrangian(capsys, file):
    assert main(["audit", file(PENDULA.replace("SIGN", "-"))]) == 0
    assert capsys.readouterr().out.endswith(
        "8 formulas: 3 compared with what stands above, none wrong; 5 say something new\n"
    )
    wrong = file(PENDULA.replace("SIGN", "+"))
    assert main(["audit", wrong, "--json"]) == 1
    *others, last = json.loads(capsys.readouterr().out)
    assert [row["passed"] for row in others] == [None] * 5 + [True] * 2
    assert (last["name"], last["line"], last["passed"]) == ("7", 11, False)
    assert last["from"] == [2, 3, 4, 5]
    assert last["slip"] == "another sign before l₁ θ̇₁² sin(θ₁ − θ₂)"
    right = "l₂ θ̈₂ + l₁ θ̈₁ cos(θ₁ − θ₂) − l₁ θ̇₁² sin(θ₁ − θ₂) + g sin θ₂ = 0"
    assert last["right"] == right
    assert main(["audit", wrong]) == 1
    assert capsys.readouterr().out.startswith(
        "line 11 (7) is wrong: it holds with another sign before l₁ θ̇₁² sin(θ₁ − θ₂)\n"
        f"  written  {last['equations'][0]['read']}\n"
        f"  right    {right}\n"
        "  against  line 3: y₂ = y₁ − l₂ cos θ₂\n"
        "           line 4: T = ½ m₁ (ẋ₁² + ẏ₁²) + ½ m₂ (ẋ₂² + ẏ₂²)\n"
        "           line 5: L = T − m₁ g y₁ − m₂ g y₂\n"
        "           and 3 more above\n\n"
    )


def test_projects_and_notebooks_are_audited(tmp_path, capsys):
    (tmp_path / "main.tex").write_text("\\newcommand{\\q}{\\dot x}\n\\input{more}\n")
    text = "$$L = \\frac12 m\\q^2 - \\frac12 kx^2$$\n\n$$m\\ddot x = kx \\label{force}$$\n"
    (tmp_path / "more.tex").write_text(text)
    assert main(["audit", str(tmp_path / "main.tex"), "--json"]) == 1
    first, last = json.loads(capsys.readouterr().out)
    assert (first["passed"], last["passed"], last["name"]) == (None, False, "force")
    assert (last["file"], last["line"], last["from"]) == ("more.tex", 3, ["more.tex:1"])
    cells = [
        {"cell_type": "markdown", "source": [cell]}
        for cell in ("First $a = 1$.", text.replace("\\q", "\\dot x"))
    ]
    (tmp_path / "own.ipynb").write_text(json.dumps({"cells": cells}))
    assert main(["audit", str(tmp_path / "own.ipynb"), "--json"]) == 1
    *_, last = json.loads(capsys.readouterr().out)
    assert (last["passed"], last["cell"], last["line"], last["from"]) == (False, 2, 3, ["2:1"])


def test_what_one_file_defines_the_next_may_use(tmp_path, capsys):
    (tmp_path / "main.tex").write_text("\\input{one}\n\\input{two}\n$$w = 6 a$$\n")
    (tmp_path / "one.tex").write_text("$$u = 2 a$$\n")
    (tmp_path / "two.tex").write_text("\n$$w = 3 u$$\n")
    assert main(["audit", str(tmp_path / "main.tex"), "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert [(row["file"], row["line"], row["passed"]) for row in rows] == [
        ("one.tex", 1, None),
        ("two.tex", 2, None),
        ("main.tex", 3, True),
    ]
    assert rows[-1]["from"] == ["one.tex:1", "two.tex:2"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (EULER.format("-"), 0),
        (MATRIX, 0),
        ("$T = 0$ (3.44)", 1),
        ("$T = \\oops$ (3.44)", 0),
        ("$T = T$ (7.1)", 0),
        ("$T = T$ but no number", 0),
        ("$\\Omega_b = \\omega_3\\lambda_2$ (3.40)", 1),
    ],
)
def test_exit_codes(text, code, file, capsys):
    assert main(["audit", file(text)]) == code
    assert capsys.readouterr().err == ""


def test_what_is_open_in_a_sentence_is_told_by_its_reason_too(file, capsys):
    assert main(["audit", file("So $p = = 2$ holds, and $$y = \\foo{3}.$$")]) == 0
    shown = capsys.readouterr().out
    assert "2 could not be read" in shown
    assert re.search(r"1 +unread +a term is missing before = +1\n", shown)
    assert re.search(r"1 +unread +the command \\foo is not known +1\n", shown)


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("No formula at all.", "no formulas between dollars"),
        ("", "no formulas between dollars"),
        (b"\x89PNG\r\n\x1a\n\xff\xfe", "it is not text in UTF-8"),
        (b"a\0b $T = T$ (3.44)", "it is not text in UTF-8"),
        (b" " * 4_000_001, "it has more than 4000000 bytes"),
    ],
)
def test_bad_files_get_one_line(text, complaint, file, capsys):
    assert main(["audit", file(text)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert complaint in err
    assert err.count("\n") == 1


def test_other_bad_input_gets_one_line(tmp_path, file, capsys, monkeypatch):
    name = file(MATRIX)
    for arguments, complaint in (
        ([name, "-o", name], "is the file that is audited"),
        ([name, "-o", str(tmp_path)], "is not an ordinary file"),
    ):
        assert main(["audit", *arguments]) == 2
        err = capsys.readouterr().err
        assert complaint in err
        assert err.count("\n") == 1
    assert Path(name).read_text() == MATRIX


def test_line_ends_and_marks_of_other_systems(file, capsys):
    text = b"\xef\xbb\xbf" + EULER.format("-").replace("\n", "\r\n").encode()
    assert main(["audit", file(text), "--json"]) == 0
    (found,) = json.loads(capsys.readouterr().out)
    assert [e["line"] for e in found["equations"]] == [3, 5, 7]


# --- the annotated page --------------------------------------------------------------------------

EMPTY = {"meta", "mspace", "br"}
KNOWN = (
    r"html|head|meta|title|style|body|a|main|header|h1|h2|h3|h4|p|ul|li|div|span|"
    r"footer|b|i|u|sup|sub|code|math|mrow|mi|mo|mn|mtext|mspace|msub|msup|msubsup|"
    r"mover|munder|munderover|mfrac|msqrt|mtable|mtr|mtd|mstyle|mpadded|mphantom"
)
ATTRIBUTES = (
    r"lang|charset|name|content|class|href|id|aria-hidden|xmlns|display|alttext|"
    r"mathvariant|style|width|scriptlevel|stretchy|displaystyle|form|fence|separator|"
    r"lspace|rspace|minsize|maxsize|symmetric|linethickness|columnalign|accent|"
    r"accentunder|movablelimits|largeop|height|depth|voffset|columnspacing|rowspacing"
)


class Page(HTMLParser):
    """The tags of a page, which must be nested and known, and its text."""

    def __init__(self, source):
        super().__init__()
        self.stack, self.text, self.classes, self.links, self.ids = [], "", [], [], []
        self.feed(source)
        self.close()
        assert self.stack == []

    def handle_starttag(self, tag, attrs):
        assert re.fullmatch(KNOWN, tag), tag
        given = dict(attrs)
        assert all(re.fullmatch(ATTRIBUTES, name) for name in given), attrs
        assert not re.search(r"url|expression|javascript", given.get("style") or "")
        self.classes += (given.get("class") or "").split()
        self.links += [given["href"]] if "href" in given else []
        self.ids += [given["id"]] if "id" in given else []
        if tag not in EMPTY:
            self.stack.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in EMPTY:
            self.stack.pop()

    def handle_endtag(self, tag):
        assert self.stack.pop() == tag

    def handle_data(self, data):
        if self.stack[-1:] != ["style"]:
            self.text += data


def annotated(path, tmp_path):
    out = tmp_path / "page" / "annotated.html"
    code = main(["audit", path, "-o", str(out)])
    return code, out.read_text("utf-8")


HOSTILE = [
    "<script>alert(1)</script>",
    "<img src=x onerror=alert(1)>",
    "[click](javascript:alert(1))",
    "![x](https://evil.example/x.png)",
    '<u onmouseover="alert(1)">x</u>',
    "<sup><script>alert(1)</script></sup>",
    "$\\text{<script>alert(1)</script>} = 1$ (3.44)",
    "$T = <img src=x onerror=alert(1)>$ (3.41)",
    "$<b>x</b>$",
    '$$T = \\text{"><svg/onload=alert(1)>}$$\n(3.45)',
    "# <svg onload=alert(1)> $T = <i>$ (3.40)",
    "- <iframe src=x>",
    "\ue0000\ue001 \ue000999\ue001 \x1b[31m \u202e",
    "**<b>&lt;script&gt;**",
    "<span onclick=alert(1)></span>",
    "<!-- <script>alert(1)</script>",
    "\\begin{align}<script>\\end{align}",
]


@pytest.mark.parametrize("text", [*HOSTILE, "\n\n".join(HOSTILE)])
def test_a_page_of_a_stranger_does_nothing(text, tmp_path, file):
    name = "<script>alert(2)<" + "b>.md"
    name = name.replace("/", "")
    _, source = annotated(file(f"{text}\n\n{MATRIX}", name), tmp_path)
    Page(source)  # known tags with known attributes only
    assert "evil.example" not in source
    assert "javascript:" not in source
    assert not re.search("[\x00-\x08\x0b-\x1f\ue000\ue001\u202e]", source)


def test_no_file_that_was_read_is_written_over(tmp_path, capsys):
    main_file, chapter, link = (tmp_path / name for name in ("main.tex", "ch.tex", "link.html"))
    main_file.write_text("\\documentclass{article}\n\\input{ch}\n$$E = T$$\n", "utf-8")
    chapter.write_text("$$F = ma$$\n", "utf-8")
    link.symlink_to(chapter)
    for page in (main_file, chapter, link):
        assert main(["audit", str(main_file), "-o", str(page)]) == 2
        which = "the file that is audited" if page == main_file else "a file that it takes in"
        said = f"rigidtop audit: {page} is {which}: write the page elsewhere\n"
        assert capsys.readouterr().err == said
    assert chapter.read_text("utf-8") == "$$F = ma$$\n"


def test_a_file_that_is_taken_in_and_is_not_there_is_told(tmp_path, capsys):
    file = tmp_path / "main.tex"
    file.write_text(
        "\\documentclass{article}\\usepackage{amsmath}\n\\input{ch}\n% \\input{old}\n"
        "\\include{../out}\n$$E = T$$\n",
        "utf-8",
    )
    (tmp_path / "ch.tex").write_text("$$F = ma$$\n\\input{gone}\n", "utf-8")
    assert main(["audit", str(file), "--json"]) == 0
    told = [each for each in json.loads(capsys.readouterr().out) if "is not read" in each["note"]]
    assert [(each["file"], each["line"], each["verdict"]) for each in told] == [
        ("main.tex", 4, "unread"),
        ("ch.tex", 2, "unread"),
    ]
    assert told[1]["note"] == "\\input{gone} is not read: there is no such file in the folder"
    assert main(["read", str(file)]) == 0
    assert "unread: \\input{gone} is not read" in capsys.readouterr().out
