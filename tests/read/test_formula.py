"""What is printed reads back, whatever is changed is seen, and what can't be read says where."""

import re

import pytest
import sympy
from sympy import Matrix, Rational

from rigidtop.derivations import PAGES, lecture_with
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.notation import GOLDSTEIN, MATRICES, NOTES
from rigidtop.proof.equation import Equation, Printed, Rate, SumOver, VolumeIntegral, as_printed
from rigidtop.proof.equation import value as meaning_of
from rigidtop.proof.page import Check, Definition, Step
from rigidtop.read.document import lines, numbered
from rigidtop.read.equations import equations as read
from rigidtop.read.kinds import kind
from rigidtop.theory import symbols as s
from rigidtop.typeset.latex import AlignRow, align, latex
from rigidtop.typeset.sizes import lines as broken
from rigidtop.typeset.text import text

CLAIMS = {claim.name: claim for page in PAGES for claim in page.claims} | {
    claim.name: claim for exercise in EXERCISES for claim in exercise.claims
}


def printed_equations(claim):
    """Everything that a claim shows, with the order in which the report prints it."""
    for item in claim.evidence():
        if isinstance(item, Check):
            yield item.claimed, "printed"
            for symbol, meant in item.meaning.items():
                if symbol in s.VOCABULARY and isinstance(meant, (sympy.Expr, sympy.MatrixBase)):
                    yield Equation(symbol, meant), "auto"
        elif isinstance(item, (Definition, Step)):
            yield item.equation, "auto"


def known(equation):
    """Whether all symbols are in the vocabulary, and all of its nodes are those of a formula."""
    nodes = [node for side in equation.sides for node in sympy.preorder_traversal(side)]
    extra = (sympy.Derivative, sympy.Subs, sympy.core.function.AppliedUndef)
    named = {SumOver: 0, VolumeIntegral: 0, Rate: 1}
    labels = {node.args[i] for node in nodes for kind, i in named.items()
              if isinstance(node, kind) and len(node.args) > i}  # fmt: skip
    letters = {node for node in nodes if isinstance(node, sympy.Symbol)}
    return letters - labels <= set(s.VOCABULARY) and not any(isinstance(n, extra) for n in nodes)


# --- By value ------------------------------------------------------------------------------------


def number(name, salt=0):
    """A rational number of either sign that belongs to a name."""
    seed = sum((i + 7 + salt) * ord(c) for i, c in enumerate(name)) % 9973
    return (-1) ** seed * Rational(seed + 101, 5003)


def meanings(equation):
    """Numbers for every symbol, of its kind."""
    made = {}
    for side in equation.sides:
        for node in sympy.preorder_traversal(side):
            if isinstance(node, Rate):
                size = 3 if kind(node) == "vector" else 0
                name = sympy.srepr(node)
                made[node] = vector(name) if size else number(name)
            elif isinstance(node, SumOver):
                made[node.args[0]] = [
                    {s.r_k: vector(f"r{i}"), s.F_k: vector(f"F{i}"), s.m_k: number(f"m{i}")}
                    for i in "12"
                ]
            elif isinstance(node, VolumeIntegral):
                made[node.args[0]] = lambda body: body * Rational(7, 3)
            elif isinstance(node, sympy.Symbol) and node not in made:
                made[node] = (
                    vector(node.name)
                    if kind(node) == "vector"
                    else square(node.name)
                    if node in MATRICES
                    else number(node.name)
                )
    if s.unit in made:
        made[s.unit] = sympy.eye(3)
    return made


def vector(name):
    return Matrix([number(name, salt) for salt in (1, 2, 3)])


def square(name):
    return Matrix(3, 3, [number(name, salt) for salt in range(1, 10)])


def digits(equation):
    """The two sides in numbers; the label of a brace counts as a side."""
    meaning = meanings(equation)
    found = []
    for side in equation.sides:
        braces = [n for n in sympy.preorder_traversal(side) if type(n).__name__ == "Underbrace"]
        for tree in (side, *(brace.args[1] for brace in braces)):
            worth = meaning_of(tree, meaning)
            entries = list(worth) if isinstance(worth, sympy.MatrixBase) else [worth]
            found += [sympy.N(entry, 25) for entry in entries]
    return found


def same(first, second):
    """Whether two equations say the same, side by side, at a point that is no special one."""
    if first.relation != second.relation or len(first.sides) != len(second.sides):
        return False
    try:
        left, right = digits(first), digits(second)
    except (TypeError, sympy.ShapeError, NotImplementedError):
        return latex(first, "typed") == latex(second, "typed")
    return len(left) == len(right) and all(
        abs(a - b) <= 1e-18 * (1 + abs(a)) for a, b in zip(left, right, strict=True)
    )


@pytest.mark.parametrize("name", CLAIMS)
def test_what_is_printed_reads_back(name):
    for equation, order in printed_equations(CLAIMS[name]):
        if not known(equation):
            continue
        on_one_line = latex(equation, order)
        rows = [AlignRow(tuple(broken(equation, order, 20)), "3.57", "The reason.")]
        narrow = align(rows, 20)
        for source in (on_one_line, narrow[narrow.index(r"\begin") :]):
            found = read(source)
            assert [line.problem for line in found] == [""], source
            assert same(found[0].equation, equation), source
            assert latex(found[0].equation, "typed") == on_one_line


def test_every_line_of_the_lecture_means_in_print_what_it_says():
    """Bars that are lost, or brackets, change what is said."""
    whole = lecture_with([exercise.text for exercise in EXERCISES if exercise.text])
    equations = [each for line in whole.lines.values() for each in line.equations]
    assert len(equations) > 700
    for equation in equations:
        source = latex(equation, "printed")
        found = read(source)
        assert [line.problem for line in found] == [""], source
        assert same(found[0].equation, equation), source


def test_rows_of_a_display_read_back_with_their_reasons_and_tags(printed_again):
    first, second = printed_again
    shown = align([
        AlignRow(tuple(broken(first, "typed")), "3.55", "A reason, with a comma.", "(false)"),
        AlignRow(tuple(broken(second, "typed")), "3.56", "Another, which is longer " * 4),
    ])  # fmt: skip
    assert shown.count("which is longer") == 4
    assert "(false)" in shown
    found = read(shown[shown.index(r"\begin") :])
    assert [line.tag for line in found] == ["3.55", "3.56"]
    assert [text(line.equation) for line in found] == [text(first), text(second)]


@pytest.fixture
def printed_again():
    with as_printed():
        return (
            Equation(s.p_phi, s.lambda1 * s.phidot * sympy.sin(s.theta) ** 2, s.const),
            Equation(s.p_psi, s.lambda3 * (s.psidot + s.phidot * sympy.cos(s.theta)), s.const),
        )


# --- Faithful ------------------------------------------------------------------------------------

CHANGES = [
    (r"\+", "-"),
    (r"(?<![\w{(^_&\\]) ?- ", " + "),
    (r"\\sin", r"\\cos"),
    (r"\\cos", r"\\sin"),
    (r"\\lambda_\{1\}", r"\\lambda_{3}"),
    (r"\\lambda_\{3\}", r"\\lambda_{1}"),
    (r"\\omega_\{1\}", r"\\omega_{2}"),
    (r"\\omega_\{2\}", r"\\omega_{3}"),
    (r"\\omega_\{3\}", "2\\\\omega_{3}"),
    (r"\^\{2\}", ""),
    (r"\^\{2\}", "^{3}"),
    (r"\\dot\{\\phi\}", r"\\phi"),
    (r"\\dot\{\\psi\}", r"\\dot{\\theta}"),
    (r"\\ddot", r"\\dot"),
    (r"'", ""),
    (r"O\^\{T\}", "O"),
    (r"\\times", r"\\cdot"),
    (r"(\\mathbf\{e\}_\{)3", r"\g<1>1"),
    (r"\\hat\{\\mathbf\{z\}\}", r"\\hat{\\mathbf{x}}"),
    (r"\\tfrac\{1\}\{2\}", r"\\tfrac{1}{3}"),
    (r"MgR", "MR"),
    (r"g", "gg"),
    (r" - [^+=-]*$", ""),
    (r" \+ [^+=-]*$", ""),
    (r"\\Omega_\{b\}", r"\\Omega_{s}"),
    (r"= ", r"\\neq "),
]


def test_no_change_of_a_printed_equation_goes_unseen():
    tried = unread = 0
    for page in PAGES:
        for claim in page.claims:
            if not re.match(r"\d", claim.name):
                continue
            for item in claim.evidence():
                if not isinstance(item, Check):
                    continue
                source = latex(item.claimed, "typed")
                for pattern, instead in CHANGES:
                    for match in re.finditer(pattern, source):
                        changed = source[: match.start()] + re.sub(pattern, instead, match[0])
                        changed += source[match.end() :]
                        if changed == source:
                            continue
                        tried += 1
                        found = read(changed)
                        if any(line.equation is None for line in found):
                            unread += 1
                            continue
                        assert len(found) != 1 or not same(found[0].equation, item.claimed), changed
    assert tried >= 300
    assert unread < tried / 2


# --- Spellings -----------------------------------------------------------------------------------


def shown(source):
    """What is read, as text; a reason in brackets."""
    return [text(line.equation) if line.equation else f"[{line.problem}]" for line in read(source)]


SPELLINGS = {
    "ė₃ = N": [
        r"\mathbf{\dot e}_3 = \mathbf N",
        r"\dot{\mathbf{e}}_3 = \vec N",
        r"\vec{\dot e}_3 = {\bf N}",
        r"\bm{\dot{e}_3} = \boldsymbol{N}",
        r"\dot{\vec e_3} = \pmb N",
        r"\dot\mathbf{e}_3(t) = \mathbf{N}(t)",
        r"{\bf \dot e}_3 = \mathbf{N}",
        "ė₃ = 𝐍",
    ],
    "ω̇₁ = Ω_b ω₂": [
        r"\dot\omega_1 = \Omega_b\omega_2",
        r"\dot{\omega_1} = {\Omega}_b\,{\omega_2}",
        r"{\dot\omega}_{1} = \Omega_{\mathrm b}~\omega_{2} % from (3.36)",
        r"\frac{d\omega_1}{dt} &= \Omega_b(t)\;\omega_2(t),",
        r"\frac{\mathrm d}{\mathrm dt}\omega_1 \stackrel{(3.36)}{=} \Omega_b\omega_2.",
        r"\frac{\mathrm{d}\omega_{1}}{\mathrm{d}t} = \Omega_{b}\omega_{2}",
        "ω̇₁ = Ω_b ω₂",
        "&#x3c9;̇<sub>1</sub> = &Omega;<sub>b</sub>&nbsp;&omega;<sub>2</sub>",
        r"\begin{array}{rcl} \dot\omega_1 &=& \Omega_b\omega_2 \\[2pt] \end{array}",
        r"\begin{aligned}\dot\omega_1 \\* &= \Omega_b\omega_2 \\*[2pt] \end{aligned}",
        r"\left.\dot\omega_1 = \Omega_b\omega_2\right.",
    ],
    "θ̈ = 0": [
        r"\frac{d^2\theta}{dt^2} = 0",
        r"d\dot\theta/dt = 0",
        r"\ddot{\vartheta}=0",
        r"\frac{\mathrm{d}^{2}\theta}{\mathrm{d}t^{2}} = 0",
    ],
    "T = ½λ₁φ̇² sin² θ": [
        r"T = \tfrac12\lambda_1\dot\phi^2\sin^2\theta",
        r"T = \frac12 \lambda_1 \dot{\varphi}^2 \sin^2 \theta",
        r"T = \frac{1}{2}\lambda_1{\dot\phi}^2\sin^{2}(\theta)",
        r"T = \frac 1 2 \lambda_1 \dot\phi^2 \sin ^2\theta",
        "T = ½ λ₁ φ̇² \\sin^2 θ",
    ],
    "E = sin θ cos φ + sin(2θ) + sin(Ω_b t) + cos(½θ)": [
        r"E = \sin\theta\cos\phi + \sin 2\theta + \sin\Omega_b t + \cos\frac{1}{2}\theta",
        r"E = \sin{\theta}\cos(\phi) + \sin\left(2\theta\right) + \sin(\Omega_b t) "
        r"+ \cos(\tfrac12\theta)",
    ],
    "τ_b = 2π/Ω_b": [r"\tau_b = 2\pi/\Omega_b", r"\tau_b = \frac{2\pi}{\Omega_b}", "τ_b = 2π/Ω_b"],
    "L = √(L · L)": [
        r"L = |\mathbf L|",
        r"L = \lVert\mathbf L\rVert",
        r"L = \left|\vec L\right|",
        r"L = \bigl\lvert\mathbf{L}\bigr\rvert",
        r"L = \|\mathbf{L}\|",
    ],
    "p_ψ = const": [
        *(r"p_\psi = \text{const}", r"p_\psi = \,\mathrm{const}", r"p_\psi = \text{const.}"),
        *(r"p_\psi = const", r"p_\psi = {\rm const}", r"p_{\psi}=\textrm{constant}."),
    ],
    "(ψ̇ + φ̇ cos θ) = L, with ψ̇ + φ̇ cos θ ≡ ω₃": [
        r"\underbrace{\dot\psi + \dot\phi\cos\theta}_{\equiv\omega_3} = L",
        r"\overbrace{\dot\psi + \dot\phi\cos\theta}^{=\,\omega_3} = L",
    ],
    "ω_n² = λ₃": [r"\omega_n^2 = \lambda_3", r"\omega^2_n = \lambda_3"],
    "ω = φ̇ẑ + θ̇e₂′ + ψ̇e₃": [
        r"\boldsymbol\omega = \dot\phi\hat z + \dot\theta\mathbf e'_2 + \dot\psi\hat{\mathbf e}_3",
        r"\vec\omega = \dot\phi\,\hat{\mathbf{z}} + \dot\theta\vec{e}_{2'} + \dot\psi\vec e_3",
        r"\bm{\omega} = \dot\phi\mathbf{\hat{z}} + \dot\theta\,\mathbf{e}_2^{\prime}"
        r"\\ + \dot\psi\mathbf e_3",
    ],
    "ω₃ = ω_{3,0}e^(−c₃t/λ₃)": [
        r"\omega_3 = \omega_{3,0}e^{-c_3t/\lambda_3}",
        r"\omega_3 = \omega_{3,0}\,\mathrm{e}^{-c_3 t/\lambda_3}",
        r"\omega_3 = \omega_{3,0}\exp(-c_3t/\lambda_3)",
    ],
}  # fmt: skip


@pytest.mark.parametrize(
    ("said", "source"), [(said, source) for said in SPELLINGS for source in SPELLINGS[said]]
)
def test_spellings(said, source):
    wanted = read(latex(read(SPELLINGS[said][0])[0].equation, "typed"))[0].equation
    found = read(source)
    assert [line.problem for line in found] == [""]
    assert latex(found[0].equation, "typed") == latex(wanted, "typed")


@pytest.mark.parametrize("notation", [NOTES, GOLDSTEIN])
@pytest.mark.parametrize("sign", ["d", r"\mathrm d", "d^2", r"\delta ", r"\partial "])
@pytest.mark.parametrize(
    "letter",
    [
        *(r"\dot{\boldsymbol\omega}", r"\ddot{\mathbf r}", r"\dot{\mathbf{\dot L}}", r"\dot\phi_1"),
        *(r"\hat{\mathbf n}", r"\vec r", r"\omega_{1,2}", r"\Omega_\pm", r"\bar x", r"\pi"),
    ],
)
def test_a_differential_of_any_letter_is_read_or_says_why_not(letter, sign, notation):
    for source in (r"E = \int \mathbf L\cdot %s", r"\frac{%s}{dt} = 0", "%s = 0", r"E = \pm %s"):
        for line in read(source % f"{sign}{letter}", notation):
            assert (line.equation is None) == bool(line.problem)


def test_several_equations():
    assert shown(r"\ddot{\omega}_{1,2} = -\Omega_b^2\omega_{1,2}") == [
        "ω̈₁ = −Ω_b² ω₁",
        "ω̈₂ = −Ω_b² ω₂",
    ]
    assert shown(r"\theta = 0, \qquad \phi = 0 \text{ and } \psi = 0; T = V") == [
        *("θ = 0", "φ = 0", "ψ = 0", "T = V")
    ]
    assert shown(r"\theta = 0 \quad \phi = 0") == ["θ = 0", "φ = 0"]
    assert shown(r"a &= b & M &= R \\ -L &= E \\ T &= V \\ & + E") == [
        *("a = b", "M = R", "−L = E", "T = V + E")
    ]
    assert shown(r"\ddot\theta = \dot\theta = 0") == ["θ̈ = θ̇ = 0"]
    assert shown(r"a = b \neq M") == ["a = b", "b ≠ M"]


def test_equations_between_arrows():
    source = r"T = V, \Rightarrow \\ E = T \Longrightarrow E = V \\ \therefore V = 0 \iff T = 0"
    assert shown(source) == ["T = V", "E = T", "E = V", "V = 0", "T = 0"]


@pytest.mark.parametrize(
    "source",
    [
        *(r"T = V \tag{3.5}", r"T = V \quad (3.5)", r"T = V, (3.5)", r"T = V \eqno(3.5)"),
        *(r"T = V \tag*{(3.5)}", r"T = V. \qquad \text{(3.5)}", r"q_9 = 1 \tag{3.5}"),
    ],
)
def test_tags(source):
    assert [line.tag for line in read(source)] == ["3.5"]


UNREAD = {
    r"E = \mathbf{L}\mathbf{N}": "· or ×",
    r"\omega = \dot\phi\hat z": "bold",
    r"\mathbf L = \mathbf{N} + E": "added",
    r"E = 2 3": "the number 3 behind a factor",
    r"E = \omega2": "the number 2 behind a factor",
    r"k = 1,2,3": "a scalar and a vector are compared",
    r"L_k = \lambda_k\omega_k": "no symbol L",
    r"E = \alpha_9": "no symbol α₉",
    r"E = q_0 + d\theta": "dθ: that is not read here",
    r"\mathbf{L}(t=0) = 0": "at one place",
    r"a = \frac{b}{0}": "a division by 0",
    r"a = 9^{9^{9^9}}": "too high",
    r"a = b^{10^{30}}": "too high",
    r"a = (b": "without its end",
    r"a = (b = M)": "= cannot stand here",
    r"= a": "a relation without its left side",
    r"a + b": "no relation",
    r"a = \foo b": "the command \\foo is not known",
    r"a = \begin{bmatrix} 1 & 2 \\ 3 \end{bmatrix}": "rows of different lengths",
    r"\Omega_b = x": "no symbol x",
    r"a = {b": "without its }",
    r"a = b}": "without its {",
    r"O^2 = 1": "a power of a matrix",
    r"a = b \text{ if $b = M$}": "words inside a formula",
    "E = T + \x00": "control character (U+0000)",
    r"E = \sin(a, b)": "sin of a vector",
    r"\mathbf L = \sqrt{\mathbf N}": "the root of a vector",
    r"E = e^{\mathbf L}": "exp of a vector",
    r"E = \ln 0": "the logarithm of 0",
    r"E = F(\chi)": "F of an angle and a parameter",
    r"E = K(m, \chi)": "K is of a parameter",
}


@pytest.mark.parametrize("source", UNREAD)
def test_what_is_unread_says_why(source):
    [line] = [line for line in read(source) if line.equation is None]
    assert UNREAD[source] in line.problem


READ = {
    r"E = \sin\theta^2": "E = sin(θ²)",
    r"E = 1/2\lambda_1": "E = ½λ₁",
    r"E = \cos\theta/2": "E = cos θ/2",
    r"E = \cos{\theta/2}": "E = cos(θ/2)",
    r"E = \cos\frac12\theta": "E = cos(½θ)",
    r"E = \cos^{-1}\theta": "E = arccos θ",
    r"\frac{d}{dt}L_z\cos\theta = 0": "d/dt (L_z cos θ) = 0",
    r"\partial_t T = 0": "∂T/∂t = 0",
    r"a \geq b": "a ≥ b",
    r"E = \sqrt[3]{M}": "E = ∛M",
}


@pytest.mark.parametrize("source", READ)
def test_what_could_mean_two_things_is_read_as_it_usually_is(source):
    assert shown(source) == [READ[source]]


def test_words_between_lines_end_a_line_and_a_sign_above_a_relation_is_a_comment():
    assert shown(r"a = b \intertext{and} M = R") == ["a = b", "M = R"]
    assert shown(r"a &= b \shortintertext{so} E &= T") == ["a = b", "E = T"]
    assert shown(r"a \stackrel{!}{=} b") == ["a = b"]
    assert shown(r"E = \sin{2\theta} + \cos{\Omega_b t}")[0].startswith("E = sin(2θ) + cos")


def test_one_line_that_is_unread_leaves_the_others():
    source = r"a = q_9 \\ M = R \\ E = \foo{T = V}, \\ L_z = L_3"
    found = read(source)
    assert [bool(line.equation) for line in found] == [False, True, False, True]
    assert [source[line.position] for line in found] == ["a", "M", "\\", "L"]


def test_every_line_has_its_place():
    source = "T &= V, \\\\\n  E &= T + V \\\\ L &= 0"
    assert [source[line.position] for line in read(source)] == ["T", "E", "L"]


def test_a_chain_of_numbers_and_units_is_no_equation_of_others():
    assert shown("p_\\phi \\equiv L = \\text{const}") == ["p_φ = L = const"]


def test_no_symbol_is_read_that_the_notation_does_not_have():
    for glyph, symbol in NOTES.names.items():
        assert symbol in s.VOCABULARY, glyph


def test_the_tree_is_that_of_typing():
    with as_printed():
        typed = Equation(s.T, Rational(1, 2) * s.lambda1 * s.omega1**2 + s.M * s.g * s.R)
    [line] = read(r"T = \frac{1}{2}\lambda_1\omega_1^2 + MgR")
    assert line.equation == typed


def test_printed_nodes_stay():
    [line] = read(r"\mathbf{N} = M\mathbf{R}_{CM} \times \mathbf{g}")
    assert any(
        isinstance(node, Printed) for node in sympy.preorder_traversal(line.equation.sides[1])
    )


def test_numbered_equations_know_their_number():
    [group] = numbered("$$T = V.$$\n(3.57)\n")
    assert [line.equation is not None for line in lines(group)] == [True]


@pytest.mark.parametrize("text", ["T = V (3.57)", "(3.57) T = V", r"T = V + (3.57)\lambda_1"])
def test_the_number_of_an_equation_is_no_factor(text):
    [line] = read(text)
    assert line.equation is None
    assert line.problem.startswith("a number in brackets")
    [tagged] = read("T = V, (3.57)")
    assert tagged.tag == "3.57"


def test_reading_leaves_the_caches_of_sympy_alone(monkeypatch):
    def thrown(_):
        raise AssertionError("SymPy's switch for evaluation, which empties its caches")

    monkeypatch.setattr(sympy, "evaluate", thrown)
    [line] = read(r"\mathbf L = 2\lambda_1\,[\sin\theta, 3\omega_3, 0]^T/R")
    first, second, third = line.equation.sides[1]
    assert str(first) == "((2*lambda1)*sin(theta))/R"
    assert str(second) == "((2*lambda1)*(3*omega3))/R"
    assert third == 0


def test_a_thin_space_is_no_comma():
    [spaced] = read(r"\frac{d}{dt}\left(\delta\,\dot\theta\right) = 0")
    [plain] = read(r"\frac{d}{dt}(\delta\dot\theta) = 0")
    assert spaced.equation is not None
    assert spaced.equation.sides == plain.equation.sides
