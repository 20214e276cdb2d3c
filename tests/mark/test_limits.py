"""Text from strangers: whatever it is, reading is quick, raises nothing, computes nothing."""

import ast
import io
import json
import random
import re
import time
from pathlib import Path

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

import rigidtop.mark
import rigidtop.read
from rigidtop.cli import main
from rigidtop.derivations import PAGES
from rigidtop.derivations.letters import LETTERS
from rigidtop.errors import RigidtopError
from rigidtop.judge.text import judged
from rigidtop.mark.numbered import Numbers, copies
from rigidtop.mark.task import top
from rigidtop.read import document, tex, walk
from rigidtop.read.equations import equations as read
from rigidtop.read.sizes import DEEPEST
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset.text import text

LABELS = {sympy.Symbol(name) for name in ("space", "body", "d3r", *"abcdefghijklmnopqrstuvwxyz")}
"""Frames, measures and indices of sums."""

TOKENS = (
    *(r"\frac", r"\tfrac12", r"\sqrt", r"\dot", r"\ddot", r"\hat", r"\mathbf", r"\boldsymbol"),
    *(r"\vec", r"\text{const}", r"\sin", r"\cos", r"\left(", r"\right)", r"\bigl[", r"\underbrace"),
    *(r"\stackrel", r"\times", r"\cdot", r"\sum_k", r"\int d^3r", r"\equiv", r"\neq", r"\approx"),
    *(r"\Rightarrow", r"\tag{3.57}", r"\begin{bmatrix}", r"\end{bmatrix}", r"\begin{aligned}"),
    *(r"\end{aligned}", r"\\", r"\quad", r"\,", r"\pm", r"\det", r"\operatorname{K}", r"\exp"),
    *(r"\theta", r"\phi", r"\lambda_1", r"\omega_{1,2}", r"\Omega_b", r"\pi", r"\mathcal{L}"),
    *("M", "g", "R", "L_z", "O", "O^T", "t", "e", "d", "1", "2", "0", "9", "3.5", "(t)", "const"),
    *(
        "{",
        "}",
        "(",
        ")",
        "[",
        "]",
        "^",
        "_",
        "'",
        "&",
        "=",
        "<",
        ">",
        "+",
        "-",
        "/",
        "|",
        ",",
        ".",
    ),
    *(";", "%", "~", "$", "\\", "#", "²", "₃", "θ̇", "𝐋", "&lt;", "<sup>", "</sup>", "\n", "\x00"),
)
REAL = (
    r"\lambda_1\ddot\theta = \lambda_1\dot\phi^2\sin\theta\cos\theta - \lambda_3(\dot\psi + "
    r"\dot\phi\cos\theta)\dot\phi\sin\theta + MgR\sin\theta \tag{3.54}",
    r"\boldsymbol{\omega} = \left[\omega_0 \cos\left(\Omega_b t\right), -\omega_0 "
    r"\sin\left(\Omega_b t\right), \omega_3\right]^T",
    r"0 \stackrel{Eq. (3.33)}{=} \left(\frac{\partial \mathbf{L}}{\partial t}\right)_{\text{space}}"
    r" = \left(\frac{\partial \mathbf{L}}{\partial t}\right)_{\text{body}} + \boldsymbol{\omega} "
    r"\times \mathbf{L}.",
    r"\mathbf{N}^{(e)} = -g \left( \int d^3 \mathbf{r} \,\rho(\mathbf{r}) \,\mathbf{r} \right) "
    r"\times \hat{\mathbf{z}} = \mathbf{R}_{CM} \times \underbrace{\mathbf{F}_{\text{grav},M}}"
    r"_{\equiv -g M \hat{\mathbf{z}}}",
    r"O^{T} = \begin{bmatrix} c_{\phi} & -s_\phi & 0 \\ s_{\phi} & c_\phi & 0 \\ 0 & 0 & 1 "
    r"\end{bmatrix}",
    r"\dot{\omega}_{1} &= \underbrace{\frac{(\lambda_{1} - \lambda_{3})\omega_{3}}{\lambda_{1}}}"
    r"_{\equiv \Omega_{b}} \omega_{2}, \\ \dot{\omega}_{2} &= -\Omega_{b}\omega_{1}.",
)


def depth(tree):
    deepest, level = 0, [tree]
    while level:
        deepest += 1
        level = [part for node in level for part in getattr(node, "args", ())]
    return deepest


PATIENCE = 10
"""Seconds of the processor, whatever else it does: what grows too fast would take minutes."""


def sound(source):
    """Reads it, without losing patience, and looks at all that comes back."""
    begun = time.process_time()
    found = read(source)
    assert time.process_time() - begun < PATIENCE
    for line in found:
        assert (line.equation is None) == bool(line.problem)
        assert line.problem != "this has no meaning", source
        assert 0 <= line.position <= len(source)
        if line.equation is None:
            continue
        for side in line.equation.sides:
            assert not side.has(sympy.nan, sympy.zoo, sympy.oo)
            assert side.free_symbols <= set(VOCABULARY) | LABELS
            assert depth(side) <= 3 * DEEPEST


@settings(max_examples=80)
@given(st.lists(st.sampled_from(TOKENS), max_size=40))
def test_random_tex(parts):
    sound("".join(parts))
    sound(" ".join(parts))


@settings(max_examples=40)
@given(
    st.lists(st.sampled_from(TOKENS), max_size=20), st.lists(st.sampled_from(TOKENS), max_size=20)
)
def test_random_equations(left, right):
    sound(" ".join([*left, "=", *right]))


@settings(max_examples=40)
@given(st.text(max_size=80))
def test_any_text(source):
    sound(source)


@settings(max_examples=80)
@given(st.sampled_from(REAL), st.randoms(use_true_random=False), st.integers(1, 6))
def test_mutated_formulas(source, chance, changes):
    for _ in range(changes):
        at = chance.randrange(len(source) + 1)
        until = min(len(source), at + chance.choice((0, 0, 1, 1, 2, 9)))
        part = chance.choice((*TOKENS, "", "", source[: chance.randrange(30)]))
        source = source[:at] + part + source[until:]
    sound(source)


NASTY = {
    "brackets": "(" * 20_000,
    "closed brackets": "a = " + "(" * 9_000 + "b" + ")" * 9_000,
    "braces": "{" * 20_000,
    "factors": "E = " + "x_1" * 6_600,
    "known factors": "E = " + "M" * 19_000,
    "terms": "E = T" + "+V" * 9_000,
    "signs": "E = " + "-" * 19_000 + "T",
    "carets": "^" * 20_000,
    "powers": "E = M" + "^2" * 9_000,
    "nested powers": "E = " + "9^{" * 6_000 + "9" + "}" * 6_000,
    "fractions": r"\frac" * 4_000,
    "nested fractions": "E = " + r"\frac{1}{" * 2_000 + "M" + "}" * 2_000,
    "few fractions": "E = " + r"\frac{1}{" * 30 + "M" + "}" * 30,
    "accents": r"\dot" * 5_000 + "x",
    "nested accents": r"\dot{" * 2_000 + "x" + "}" * 2_000,
    "fonts": r"\mathbf" * 2_500 + " L = 0",
    "digits": "E = " + "9" * 19_000,
    "a long decimal": "E = 0." + "3" * 19_000,
    "far too long": "9" * 100_000,
    "environments": r"\begin{aligned}" * 1_300,
    "closed environments": r"\begin{aligned}" * 600 + "a=b" + r"\end{aligned}" * 600,
    "matrices": r"\begin{bmatrix}" * 600 + "1" + r"\end{bmatrix}" * 600,
    "a wide matrix": r"O = \begin{bmatrix}" + "1 & " * 4_000 + r"1\end{bmatrix}",
    "functions": "E = " + r"\sin" * 4_000 + r"\theta",
    "bars": "E = " + "|" * 19_000,
    "primes": "L" + "'" * 19_000,
    "indices": "L" + "_1" * 9_000,
    "swapped indices": "E = " + "M^2_1" * 3_900,
    "relations": "E" + "=T" * 9_000,
    "lines": "E=T\\\\" * 3_900,
    "equations": "E=T," * 4_900,
    "spaces": "E=T" + r"\," * 9_000,
    "quads": "E=T" + r"\quad" * 3_900,
    "aligned": "&" * 20_000,
    "marks": "x" + "\u0307" * 19_000,
    "sums": "E = " + r"\sum_k" * 3_000 + "M",
    "integrals": "E = " + r"\int d^3r " * 1_800 + "M",
    "crosses": r"\mathbf N = " + r"\mathbf{L}\times" * 1_200 + r"\mathbf L",
    "choices": r"\omega_{1,2}" * 800 + "= 0",
    "a list of indices": r"\omega_{" + "1," * 9_000 + "1} = 0",
    "unread lines": "x = 1\\\\" * 2_500,
    "entities": "&omega;" * 2_800,
    "tags": "<sup>" * 4_000,
    "underbraces": "E = " + r"\underbrace{" * 1_600,
    "stacked": r"\stackrel{a}" * 1_600 + "=",
    "transposed": "O" + "^T" * 9_000 + " = 1",
    "words": r"\text{" + "a" * 19_000 + "}",
}


@pytest.mark.parametrize("name", NASTY)
def test_a_formula_takes_time_in_proportion_to_its_length(name):
    sound(NASTY[name])


@pytest.mark.parametrize(
    "source",
    [
        *("9^{9^{9^9}}", "9^{9^9}", "9^{99999999}", "((9^{99})^{99})^{99}", "9^{10^{20}}"),
        *(r"\theta^{9^9}", r"9^{T - T + 10^{12}}", r"((\theta^{9})^{9})^9", "10^{-10^{9}}"),
        *(r"e^{9^{9^9}}", r"\exp(9^{9^9})", "9^{9\\cdot9\\cdot9\\cdot9\\cdot9\\cdot9\\cdot9}"),
        r"\left(\frac{1}{9}\right)^{99999999}",
    ],
)
def test_nothing_is_computed_that_has_too_many_digits(source):
    [line] = read(f"E = {source}")
    assert line.equation is None
    assert "too high" in line.problem or "too large" in line.problem


@pytest.mark.parametrize("source", ["2^{10}", r"10^{-12}", r"\theta^{4}", r"\tfrac{1}{3^2}"])
def test_numbers_of_a_lecture_are_read_and_stay_as_they_are(source):
    [line] = read(f"E = {source}")
    assert line.problem == ""
    assert text(line.equation).startswith("E = ")


def test_a_long_sum_is_read_and_a_very_long_one_is_not():
    assert read("E = T" + "+V" * 80)[0].problem == ""
    assert "levels" in read("E = T" + "+V" * 200)[0].problem


def test_the_length_and_the_depth_are_said():
    assert str(tex.LONGEST) in read("a" * (tex.LONGEST + 1))[0].problem
    assert str(tex.DEEPEST) in read("{" * 99)[0].problem


# --- Files ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "part",
    [
        "$$",
        r"\[",
        r"\(",
        "$ a",
        "$x$ ",
        r"\begin{align}",
        "```",
        "<!--",
        "\\",
        "$\n\n",
        "(3.5)\n",
        r"\begin{foo}",
        r"\a[",
        "~",
        "<a ",
        "](",
        r"\tag{3.57}",
        r"\begin{tikzpicture}=\end{tikzpicture}",
    ],
)
def test_a_file_takes_time_in_proportion_to_its_length(part, monkeypatch):
    monkeypatch.setattr(walk, "MOST", 10**9)
    monkeypatch.setattr(document, "MOST_NUMBERS", 10**9)
    source = part * (100_000 // len(part))
    begun = time.process_time()
    document.formulas(source)
    document.numbered(source)
    assert time.process_time() - begun < PATIENCE / 2


def test_a_file_that_is_too_long_is_bad_input():
    with pytest.raises(RigidtopError, match="more than"):
        document.formulas(" " * (walk.LONGEST + 1))


TAG = "\\tag{3.57} "
MANY = {
    "tags": TAG * 30_000,
    "openings": "\\[" * 100_000,
    "closings": "\\]" * 100_000,
    "formulas": "$T = V$ and " * 30_000,
    "bare equations": "E = T\n" * 30_000,
    "numbered displays": "$$T = V$$\n(3.57)\n\n" * 30_000,
    "tagged displays": "".join(f"$${i} = V {TAG}$$\n" for i in range(30_000)),
    "tags in a display": "$$"
    + "".join(f"T = V \\tag{{3.{i}}}\\\\\n" for i in range(30_000))
    + "$$",
    "characters": "x" * 3_000_000,
    "bytes": "x" * 4_100_000,
}


COMMANDS = (["audit"], ["read"], ["mark", "--from=3.53", "--to=3.57"])


@pytest.mark.parametrize(
    ("name", "arguments"),
    [*((name, ["audit"]) for name in MANY), *(("characters", each) for each in COMMANDS[1:])],
)
def test_a_command_refuses_in_one_line_what_is_too_much(name, arguments, tmp_path, capsys):
    file = tmp_path / "own.md"
    file.write_text(MANY[name], "utf-8")
    begun = time.process_time()
    assert main([*arguments, str(file)]) == 2
    assert time.process_time() - begun < PATIENCE
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert re.search(r"more than (5000|20000|2000000|4000000)|no more than 200000", err)


LARGE = {
    "brackets": "$$" + "(" * 100_000 + "$$",
    "a line": "ab " * 33_000,
    "tildes": "~" * 100_000,
    "options": "\\a[" * 33_000,
    "comments": "a <!-" * 20_000,
    "an item": "- a\n" + "b\n" * 45_000,
    "a heading": "# a" + " " * 100_000 + "x",
    "links": "[x](" * 25_000,
    "code": "` " * 50_000,
}


@pytest.mark.parametrize("name", LARGE)
def test_a_long_file_is_audited_annotated_and_read_in_time(name, tmp_path, capsys):
    file = tmp_path / "own.md"
    file.write_text(LARGE[name] + "\n\nHence $$\\mathbf{r}' = O^T\\mathbf{r}$$ (3.46)\n", "utf-8")
    begun = time.process_time()
    assert main(["audit", str(file), "-o", str(tmp_path / "page.html")]) == 0
    assert "1 numbered equation: 1 convention" in capsys.readouterr().out
    assert main(["read", str(file)]) == 0
    assert time.process_time() - begun < PATIENCE / 2


NUMBERS = Numbers(PAGES, top(), LETTERS)


def test_what_is_not_compared_in_time_is_left_out():
    source = "$$T = V$$ (3.57)\n\n$$T = V$$ (3.44)\n"
    assert copies(judged(source), source, NUMBERS, until=0.0) == ()


def test_under_one_number_only_so_many_lines_are_judged(monkeypatch):
    monkeypatch.setattr("rigidtop.mark.numbered.MOST_LINES", 5)
    source = "$$" + "T = V\\\\" * 6 + "$$ (3.57)"
    [found] = copies(judged(source), source, NUMBERS)
    assert not found.passed
    assert "more than 50 lines under one number" in found.note


def test_standard_input_has_an_end(monkeypatch, capsys):
    monkeypatch.setattr("sys.stdin", io.StringIO("x" * 4_000_001))
    assert main(["mark", "-", "--from", "3.53", "--to", "3.57"]) == 2
    assert "standard input: it has more than 4000000 characters" in capsys.readouterr().err


def test_once_the_time_is_up_the_rest_is_unread_and_says_so(monkeypatch, tmp_path, capsys):
    file = tmp_path / "own.md"
    file.write_text("$E = T$ and $$E = V$$\n", "utf-8")
    monkeypatch.setattr("rigidtop.commands.read.SECONDS", -1.0)
    assert main(["read", str(file), "--json"]) == 0
    records = json.loads(capsys.readouterr().out)
    assert [each["problem"] for each in records] == ["the time for the file was over"] * 2


# --- Nothing is evaluated ------------------------------------------------------------------------

MODULES = sorted(
    file
    for room in (rigidtop.read, rigidtop.mark)
    for file in Path(room.__file__).parent.glob("*.py")
)
FORBIDDEN = {
    *("eval", "exec", "compile", "sympify", "S", "parse_expr", "parse_latex", "__import__"),
    *("lambdify", "import_module", "literal_eval", "nsimplify"),
}


def calls(source):
    """The names that a module calls of those that evaluate text."""
    return {
        name
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.Call)
        for name in [getattr(node.func, "id", getattr(node.func, "attr", ""))]
        if name in FORBIDDEN
        and not (name == "compile" and getattr(getattr(node.func, "value", None), "id", "") == "re")
    }


@pytest.mark.parametrize(
    "module", ["tex.py", "grammar.py", "equations.py", "document.py", "walk.py"]
)
def test_no_module_evaluates_text(module):
    [path] = [path for path in MODULES if path.name == module]
    assert calls(path.read_text("utf-8")) == set()


@pytest.mark.parametrize("source", ["eval(x)", "sympy.sympify(text)", "compile(x)", "a.b.S(text)"])
def test_a_call_that_evaluates_is_seen(source):
    assert len(calls(source)) == 1


@pytest.mark.parametrize(
    "source",
    [
        r"E = __import__('os').system('touch /tmp/no')",
        r"E = \operatorname{eval}(1)",
        r"\text{__class__} = 1",
        r"E = T.__class__.__mro__",
        r"E = \operatorname{exec}('x')",
        r"lambda: 0 = 1",
    ],
)
def test_python_is_unread(source):
    assert any(line.equation is None for line in read(source))


def test_random_bytes():
    chance = random.Random(5)
    for _ in range(300):
        sound("".join(chr(chance.randrange(1, 0x2FFF)) for _ in range(60)))
