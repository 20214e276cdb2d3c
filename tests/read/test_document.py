"""Formulas in files, and the numbers that stand beside them."""

import json

import pytest

from rigidtop.cli import main
from rigidtop.read.document import bare, formulas, lines, numbered, problems
from rigidtop.typeset.text import text


def found(source):
    """The number of each group, with its equations as text."""
    return {
        group.number: [
            text(line.equation) if line.equation else f"[{line.problem}]" for line in lines(group)
        ]
        for group in numbered(source)
    }


@pytest.mark.parametrize(
    "source",
    [
        "$$T = V$$ (3.57)",
        "$$T = V.$$\n(3.57)\n",
        "$$T = V. \\tag{3.57}$$",
        "$$T = V. \\tag*{(3.57)}$$",
        "$$T = V \\quad (3.57)$$",
        "$$T = V. \\eqno(3.57)$$",
        "\\[ T = V \\tag{3.57} \\]",
        "\\begin{equation}T = V \\tag{3.57}\\end{equation}",
        "\\begin{align}\nT &= V \\tag{3.57}\n\\end{align}",
        "$$\\begin{aligned} T &= V \\end{aligned} \\quad (3.57)$$",
        "$T = V$\t(3.57)",
        "| $T = V$ | (3.57) |\n",
        "<td>$T = V$</td><td>(3.57)\n",
        "and hence  $T = V$ (3.57)\n",
        "\\(T = V\\) (3.57)\n",
        "costs \\$3, so $T = V$ (3.57)\n",
        "```\n$a = b$ (3.1)\n```\n$T = V$ (3.57)\n",
        "<!-- $a = b$ (3.1) -->\n$T = V$ (3.57)\n",
    ],
)
def test_a_number_is_found(source):
    assert found(source) == {"3.57": ["T = V"]}


@pytest.mark.parametrize(
    ("written", "number"),
    [
        *(("$$T = V \\tag{12}$$", "12"), ("$$T = V \\tag{A.3}$$", "A.3"), ("$$T = V$$ (7)", "7")),
        *(("$$T = V$$\n(A.3)\n", "A.3"), ("$T = V$ (12a)\n", "12a"), ("$$T = V$$ (*)", "*")),
        *(("$$T = V \\eqno(7)$$", "7"), ("$$T = V, \\quad (7)$$", "7"), ("$T = V$ (B2)", "B2")),
        *(("$$T = V \\tag{$\\ast$}$$", r"\ast"), ("$$T = V \\tag{3.57'}$$", "3.57'")),
        *(("$$T = V \\tag*{(3.5.7)}$$", "3.5.7"), ("$$T = V$$ (3-57)", "3-57")),
    ],
)
def test_a_number_of_another_kind_is_not_dropped(written, number):
    assert found(written) == {number: ["T = V"]}


def test_a_year_is_no_number_and_a_line_behind_the_last_number_belongs_to_it():
    assert found("as Euler found: $T = V$ (1758)\n") == {}
    source = r"\begin{align} T &= V \tag{3.1} \\ E &= T \tag{3.2} \\ L &= 0 \end{align}"
    assert found(source) == {"3.1": ["T = V"], "3.2": ["E = T", "L = 0"]}


BARE = [
    "so λ₁θ̈ = MgR sin θ holds",
    r"\lambda_1\ddot\theta = MgR\sin\theta",
    "the spin, ω₃ ≈ 40, is large",
    "for ω₃ > 0 and no other",
    r"and \dot\theta vanishes",
    r"hence p_\psi \propto L_3.",
    "\\begin{document}\nE = T\n\\end{document}",
]


@pytest.mark.parametrize("source", BARE)
def test_mathematics_outside_of_dollars_is_told(source):
    [told] = bare(f"First $T = V$.\n\n{source}\n")
    assert told.reason == "mathematics outside of dollars: put it between $ and $"
    assert told.position >= len("First $T = V$.\n\n")


@pytest.mark.parametrize(
    "source",
    [
        *("plain words", "<a href='x=1'>link</a>", '<img src="a"\n alt="b=c">', "[x](a?b=c)"),
        *("see https://a.org/?b=c there", "A title\n=======\n", "> quoted", "a -> b <b>c</b>"),
        *(r"\includegraphics[width=3cm]{a}", r"\href{a?b=c}{link}", "$T = V$ and $$E = T$$"),
        *("% E = T", "<!-- E = T -->", "A picture {#fig width=50%}", "costs 5$ or more"),
        "\\documentclass[a=b]{c}\n\\hypersetup{d=e}\n\\foo{x=1}\n\\begin{document}\n$T = V$"
        "\n\\begin{tikzpicture}\\draw (a) = (b);\\end{tikzpicture}\\end{document}",
    ],
)
def test_what_is_no_mathematics_is_not_told(source):
    assert bare(source) == ()


@pytest.mark.parametrize("source", ["E = T (3.57)\n", "so E = T\n(3.57)\n", "- E = T (7).\n"])
def test_a_number_beside_mathematics_outside_of_dollars_is_unread(source):
    [group] = numbered(source)
    assert group.number in ("3.57", "7")
    assert [(line.equation, line.problem) for line in lines(group)] == [
        (None, "mathematics outside of dollars: put it between $ and $")
    ]


def test_code_with_an_equation_is_told():
    [told] = problems("`E = T`")
    assert (told.skipped, told.reason) == (True, "skipped: code")


@pytest.mark.parametrize(
    "source",
    [
        "with Eq. (3.33) we find $T = V$ there",
        "From $T = V$, see Eq. (3.33)\n",
        "the angle $\\theta$ (3.26)\nof the axis",
        "$$0 \\stackrel{Eq. (3.33)}{=} T$$",
        "$T = V$ (a guess)\n",
        "no formula (3.57)\n",
    ],
)
def test_a_reference_is_no_number(source):
    assert found(source) == {}


def test_displays_without_words_between_share_a_number():
    source = "$$\\dot\\theta = 0,$$\n  $$\\dot\\psi = -\\omega_3.$$\n(3.37)\n\n$$T = V$$"
    assert found(source) == {"3.37": ["θ̇ = 0", "ψ̇ = −ω₃"]}
    assert found(source.replace("\n  ", "\nand\n")) == {"3.37": ["ψ̇ = −ω₃"]}


def test_a_display_with_several_numbers():
    source = (
        r"\begin{align} T &= V \tag{3.1} \\ E &= T \\ &\quad {}+ V \tag{3.2} \\ L &= 0 \tag{3.3}"
    )
    source += r"\end{align}"
    assert found(source) == {"3.1": ["T = V"], "3.2": ["E = T + V"], "3.3": ["L = 0"]}


@pytest.mark.parametrize(
    "source",
    [
        *(
            r"\begin{alignat}{2} T &= V \tag{3.57}\end{alignat}",
            r"\begin{math}T = V\end{math} (3.57)",
        ),
        *(r"\begin{dmath}[compact] T = V \end{dmath} (3.57)", "```math\nT = V\n```\n(3.57)\n"),
        r"\begin{IEEEeqnarray}{rCl} T &=& V \tag{3.57}\end{IEEEeqnarray}",
        r"\begin{subequations}\begin{flalign}T &= V \tag{3.57}\end{flalign}\end{subequations}",
        r"\begin {align} T &= V \tag{3.57} \end { align }",
        "\\begin{document}\n% $a = b$ (3.1)\n\\verb|$| \\iffalse $ \\fi $T = V$ (3.57)\n"
        "\\end{document} $",
        "5% of $T = V$ (3.57)\n",
        "% $$a = b$$ (3.1)\n\\begin{comment}$a = b$ (3.2)\n\\end{comment} `$x$` $T = V$ (3.57)\n",
        "a top that costs 5$ has $T = V$ (3.57)\n",
    ],
)
def test_every_way_to_write_a_formula_and_to_leave_one_out(source):
    assert found(source) == {"3.57": ["T = V"]}


LOST = {
    r"$$T = V \tag{3.57}": ("$$", "without its closing"),
    "\\[ T = V\n(3.57)\n\nand $E = T$": ("\\[", "without its closing"),
    "\\[ T = V (3.57)\n \\[ E = T \\]": ("\\[", "without its closing"),
    "so \\( T = V (3.57)\n": ("\\(", "without its closing"),
    "\\begin{align} T &= V (3.57)\n\nand $E = T$": ("\\begin", "without its"),
    r"T = V \tag{3.57} \end{align}": (r"\tag", "outside a formula"),
    r"\begin{foo}T = V \tag{3.57}\end{foo}": ("T = V", "not read: foo"),
    r"\begin{aligned}T &= V \tag{3.57}\end{aligned}": ("T &=", "not read: aligned"),
    "5$ and $T = V$ and 6$ (3.57)\n": ("$ and", "words"),
    "$5 and $T = V (3.57)\n$E = T$ and $E = T": ("$5", "odd number"),
    "$T = V$ and E = T$ (3.57)\n": ("$ (3", "odd number"),
}


@pytest.mark.parametrize("source", LOST)
def test_what_is_not_taken_is_told_and_its_number_is_unread(source):
    place, reason = LOST[source]
    told = next(problem for problem in problems(source) if reason in problem.reason)
    assert source[told.position :].startswith(place)
    assert not told.skipped
    [group] = [group for group in numbered(source) if group.number == "3.57"]
    [line] = lines(group)
    assert line.equation is None
    assert line.problem
    assert line.tag == "3.57"


def test_a_stray_dollar_does_not_turn_text_and_formulas_inside_out():
    source = r"A top that costs 5$ has $\lambda_1 = \lambda_3$."
    assert [formula.text for formula in formulas(source)] == [r"\lambda_1 = \lambda_3"]
    assert [source[problem.position - 1] for problem in problems(source)] == ["5"]
    assert problems(r"costs 5\$ and has $\lambda_1 = \lambda_3$") == ()


@pytest.mark.parametrize(
    "source", ["% $$T = V$$", "<!-- $T = V$ -->", "```\n$T = V$\n```", "`$T = V$`"]
)
def test_a_comment_with_a_formula_is_told(source):
    [told] = problems(source)
    assert told.skipped
    assert told.reason.startswith("skipped: ")
    assert formulas(source) == ()
    assert problems(source.replace("$T = V$", "T")) == ()


def test_places_are_those_in_the_file():
    source = "We find\n$$T = V,$$\n$$q_9 = E \\tag{3.5}$$\n"
    [group] = numbered(source)
    assert [source[line.position :][:3] for line in lines(group)] == ["T =", "q_9"]
    assert [source[f.start : f.start + len(f.text)] == f.text for f in formulas(source)] == [
        True
    ] * 2
    assert [source[f.opens : f.end] for f in formulas(source)] == [
        "$$T = V,$$",
        "$$q_9 = E \\tag{3.5}$$",
    ]


def test_formulas_of_every_kind():
    source = r"$a$ $$b$$ \(c\) \[d\] \begin{gather*}e\end{gather*} \$f\$ $g" + "\n\n" + "h$"
    assert [(f.text, f.display) for f in formulas(source)] == [
        *(("a", False), ("b", True), ("c", False), ("d", True), ("e", True))
    ]


def test_quirks_of_markdown_from_a_pdf():
    table = (
        "Equations of motion\t\n$p_{\\psi} \\equiv \\lambda_3\\omega_3 = \\text{const}$\t(3.56)\n"
    )
    assert found(table) == {"3.56": ["p_ψ = λ₃ω₃ = const"]}
    box = (
        "# Motion In the frame, $\\dot\\theta = 0$ (3.38)\n\nand hence using (3.26)  $T = V$ also\n"
    )
    assert found(box) == {"3.38": ["θ̇ = 0"]}
    spaced = "$$T = V,\n$$\n  \n$$L = 0,$$\n  \n\n(3.36)\n"
    assert found(spaced) == {"3.36": ["T = V", "L = 0"]}


def test_the_command_says_what_is_read_and_what_is_not(tmp_path, capsys):
    path = tmp_path / "notes.md"
    path.write_text("The angle $\\theta$.\n\n$$T = V,$$\n(3.5)\nand $q_9 = E$\n", encoding="utf-8")
    assert main(["read", str(path), "--notation", "notes", "--json"]) == 0
    first, second = json.loads(capsys.readouterr().out)
    assert first == {
        "number": "3.5",
        "equation": "T = V",
        "label": None,
        "condition": None,
        "problem": None,
        "letters": {},
        "line": 3,
        "column": 3,
    }
    assert (second["line"], second["column"], second["equation"]) == (5, 6, None)
    assert "no symbol q₉" in second["problem"]
    assert main(["read", str(path), "--notation", "notes"]) == 0
    assert "unread: no symbol q₉" in capsys.readouterr().out


def test_the_command_tells_what_was_not_taken(tmp_path, capsys):
    path = tmp_path / "notes.md"
    path.write_text("5$ has $T = V$\n\n% $a = b$\n\n$$ E = T (3.5)\n", encoding="utf-8")
    assert main(["read", str(path), "--json"]) == 0
    records = json.loads(capsys.readouterr().out)
    assert [(r["line"], r["number"], r["equation"]) for r in records] == [
        *((1, "", None), (1, "", "T = V"), (3, "", None), (5, "3.5", None))
    ]
    assert "skipped" in records[2]["problem"]


def test_a_file_that_is_no_text_is_bad_input(tmp_path, capsys):
    path = tmp_path / "notes.md"
    path.write_bytes(b"\xff\xfe\x00")
    assert main(["read", str(path)]) == 2
    assert "not text" in capsys.readouterr().err


def test_the_signs_of_a_quotation_are_no_relations():
    [formula] = formulas("> Note\n> $$\n> a = b\n> + c > 0\n> $$\n")
    assert formula.text.split() == ["a", "=", "b", "+", "c", ">", "0"]
    assert formulas("$$\n> a\n$$\n")[0].text.split() == [">", "a"]


OTHERS = {
    "```{math}\n:label: one\na=b\n```\n": ["a=b"],
    "```{math}\n---\nlabel: one\nnowrap:\n---\na=b\n```\n": ["a=b"],
    "- x\n\n      ```math\n      a=b\n      ```\n": ["a=b"],
    "> ```math\n> a\n> = b\n> ```\n": ["a\n  = b"],
    "~~~math\na=b\n~~~\n": ["a=b"],
    "````{note}\n```{math}\na=b\n```\n$c$\n````\n$d$\n": ["a=b", "c", "d"],
    ":::{math}\n:label: one\na=b\n:::\n:::{tip}\n$c$\n:::\n": ["a=b", "c"],
    "so {math}`a=b` and :math:`c=d`.": ["a=b", "c=d"],
    "{{< math >}}\n$$a=b$$\n{{< /math >}}\n{{< katex >}}c{{< /katex >}}": ["a=b", "c"],
    "{% katex display %}\na=b\n{% endkatex %}": ["a=b"],
    r"so \\[a=b\\] and \\(c=d\\), no \\[4pt]": ["a=b", "c=d"],
    "We $`a=b`$ and $`c`$": ["a=b", "c"],
    "<p>$$a=b$$</p><script type='math/tex; mode=display'>c</script>": ["a=b", "c"],
    ".. math::\n   :label: one\n\n   a=b\n\n   c=d\n\nText $e$\n\n.. math:: f\n": [
        *("a=b", "c=d", "e", "f")
    ],
    "#+title: x\n\\begin{equation}\na=b\n\\end{equation}\n": ["a=b"],
    "so stem:[a=b], latexmath:[$c$]\n\n[stem]\n++++\nd\n++++\n": ["a=b", "c", "d"],
    "`$` and $x$ and `$`": ["x"],
    "$a$`code` $b$": ["a", "b"],
}


@pytest.mark.parametrize("source", OTHERS)
def test_formulas_of_other_dialects(source):
    assert [formula.text.strip() for formula in formulas(source)] == OTHERS[source]
    assert problems(source) == ()


@pytest.mark.parametrize("source", ["```python\na=b\n```\n$c$", "```{code-cell}\na=b\n```\n$c$"])
def test_code_in_a_fence_is_told(source):
    assert [formula.text for formula in formulas(source)] == ["c"]
    assert [problem.reason for problem in problems(source)] == ["skipped: code"]
