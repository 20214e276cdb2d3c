"""The printers: the equations of the notes, the order of mechanics, and two laws."""

import re
import unicodedata
from fractions import Fraction
from xml.etree import ElementTree

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import And, Eq, Float, Ge, Gt, Le, Ne, Rational, Symbol, cos, pi, sin, sqrt, symbols

from rigidtop.proof.equation import Cross, Dot, Equation, Group, as_printed, value
from rigidtop.read.equations import equations as read
from rigidtop.theory.symbols import (
    L3,
    VOCABULARY,
    Glyph,
    L_z,
    M,
    Omega,
    R,
    e1,
    e2,
    epsilon,
    g,
    lambda1,
    lambda2,
    lambda3,
    omega1,
    omega1dot,
    omega2,
    omega3,
    p_phi,
    p_psi,
    p_theta,
    phidot,
    psi,
    psidot,
    t,
    theta,
    thetaddot,
    thetadot,
)
from rigidtop.typeset import nodes as lay
from rigidtop.typeset import sizes
from rigidtop.typeset.latex import AlignRow, align, latex, letter
from rigidtop.typeset.layout import is_typed, layout
from rigidtop.typeset.mathml import display, mathml
from rigidtop.typeset.nodes import glyph
from rigidtop.typeset.text import text

from .conftest import LATEX

TEXT = {
    "3.33": ("0 = L̇ = d/dt (Iω)"),
    "3.34": ("r′ = Oᵀr"),
    "3.35": ("0 = (∂L/∂t)_space = (∂L/∂t)_body + ω × L"),
    "3.36": ("λ₁ω̇₁ = (λ₂ − λ₃)ω₂ω₃"),
    "3.37": ("ω̇₁ = ((λ₁ − λ₃)ω₃/λ₁)ω₂ = Ω_b ω₂, with (λ₁ − λ₃)ω₃/λ₁ ≡ Ω_b"),
    "3.37b": ("ω̇₂ = −((λ₁ − λ₃)ω₃/λ₁)ω₁ = −Ω_b ω₁"),
    "3.38": ("ω = [ω₀ cos(Ω_b t), −ω₀ sin(Ω_b t), ω₃]ᵀ"),
    "3.42": ("ω = (−φ̇ sin θ)e₁′ + θ̇e₂′ + (ψ̇ + φ̇ cos θ)e₃, with −φ̇ sin θ ≡ ω₁′"),
    "3.44": ("T = ½ω · L = ½λ₁(φ̇² sin² θ + θ̇²) + ½λ₃(ψ̇ + φ̇ cos θ)²"),
    "3.45": ("φ̇ = (L_z − L₃ cos θ)/(λ₁ sin² θ)"),
    "3.47": (
        "Oᵀ = [c_φ c_θ c_ψ − s_φ s_ψ, −c_ψ s_φ − c_φ c_θ s_ψ, c_φ s_θ; c_φ s_ψ + c_θ c_ψ "
        "s_φ, c_φ c_ψ − c_θ s_φ s_ψ, s_φ s_θ; −c_ψ s_θ, s_θ s_ψ, c_θ]"
    ),
    "3.48": ("N_ext = Σ_k r_k × F_k = ∫ d³r r × f"),
    "3.49": (
        "N_ext = −g ∫ d³r ρr × ẑ = −g(∫ d³r ρr) × ẑ = −gM ((∫ d³r ρr)/M) × ẑ = −gM R_CM "
        "× ẑ = R_CM × F_grav, with F_grav ≡ −gMẑ"
    ),
    "3.51": ("ė₃ = (MgR/(λ₃ω₃))ẑ × e₃ = Ω × e₃"),
    "3.53": ("ℒ = ½λ₁(φ̇² sin² θ + θ̇²) + ½λ₃(ψ̇ + φ̇ cos θ)² − MgR cos θ"),
    "3.54": ("λ₁θ̈ = λ₁φ̇² sin θ cos θ − λ₃(ψ̇ + φ̇ cos θ)φ̇ sin θ + MgR sin θ"),
    "3.55": ("p_φ = λ₁φ̇ sin² θ + λ₃(ψ̇ + φ̇ cos θ) cos θ = const"),
    "3.57a": ("0 = λ₁φ̇² sin θ cos θ − λ₃(ψ̇ + φ̇ cos θ)φ̇ sin θ + MgR sin θ"),
    "3.57b": ("0 = λ₁Ω² cos θ − λ₃(ψ̇ + φ̇ cos θ)Ω + MgR, with ψ̇ + φ̇ cos θ ≡ ω₃"),
    "3.57": ("0 = (λ₁ cos θ)Ω² − (λ₃ω₃)Ω + MgR"),
}


@pytest.mark.parametrize("number", LATEX)
def test_latex_of_the_notes(printed, number):
    assert latex(printed[number], "typed") == LATEX[number]


@pytest.mark.parametrize("number", TEXT)
def test_text_of_the_notes(printed, number):
    assert text(printed[number], "typed") == unicodedata.normalize("NFC", TEXT[number])


def test_every_equation_is_here():
    assert set(LATEX) == set(TEXT)


MECHANICS = [
    (
        lambda1 * thetaddot
        - lambda1 * phidot**2 * sin(theta) * cos(theta)
        + lambda3 * (psidot + phidot * cos(theta)) * phidot * sin(theta)
        - M * g * R * sin(theta),
        "λ₁θ̈ − λ₁φ̇² sin θ cos θ + λ₃(ψ̇ + φ̇ cos θ)φ̇ sin θ − MgR sin θ",
    ),
    (
        lambda1 * (phidot**2 * sin(theta) ** 2 + thetadot**2) / 2
        + lambda3 * (psidot + phidot * cos(theta)) ** 2 / 2
        - M * g * R * cos(theta),
        "½λ₁(φ̇² sin² θ + θ̇²) + ½λ₃(ψ̇ + φ̇ cos θ)² − MgR cos θ",
    ),
    ((L_z - L3 * cos(theta)) / (lambda1 * sin(theta) ** 2), "(L_z − L₃ cos θ)/(λ₁ sin² θ)"),
    (
        (p_phi - p_psi * cos(theta)) ** 2 / (2 * lambda1 * sin(theta) ** 2)
        + p_theta**2 / (2 * lambda1)
        + M * g * R * cos(theta),
        "p_θ²/(2λ₁) + (p_φ − p_ψ cos θ)²/(2λ₁ sin² θ) + MgR cos θ",
    ),
    ((lambda3 - lambda1) * omega3 * omega1 / lambda2, "(λ₃ − λ₁)ω₁ω₃/λ₂"),
    (-phidot * sin(theta) * cos(psi) + thetadot * sin(psi), "θ̇ sin ψ − φ̇ sin θ cos ψ"),
    (lambda1 * omega1dot + (lambda3 - lambda2) * omega2 * omega3, "λ₁ω̇₁ + (λ₃ − λ₂)ω₂ω₃"),
    (
        lambda1 * Omega**2 * cos(theta) - lambda3 * omega3 * Omega + M * g * R,
        "λ₁Ω² cos θ − λ₃ω₃Ω + MgR",
    ),
    (2 * sqrt(lambda1 * M * g * R), "2√(λ₁MgR)"),
    (
        (lambda3 * omega3 - sqrt(lambda3**2 * omega3**2 - 4 * lambda1 * M * g * R)) / (2 * lambda1),
        "(λ₃ω₃ − √(λ₃²ω₃² − 4λ₁MgR))/(2λ₁)",
    ),
    (Rational(3, 7) * epsilon, "(3/7)ε"),
    (-((omega1 + omega2) ** 2), "−(ω₁ + ω₂)²"),
    (sin(2 * theta) * cos(theta) ** 2, "sin(2θ) cos² θ"),
    (sympy.exp(-(t**2) / 2), "e^(−½t²)"),
    (sympy.atan2(omega1, omega2), "atan2(ω₁, ω₂)"),
    (sympy.acos(Omega**2), "arccos(Ω²)"),
    (sympy.Abs(omega1), "|ω₁|"),
    (Float("0.000012345678"), "1.23457 × 10⁻⁵"),
    (Float("-2.5"), "−2.5"),
    (sympy.Integer(-3), "−3"),
    (sympy.oo, "∞"),
    (-sympy.oo, "−∞"),
    (2 * pi / omega3, "2π/ω₃"),
    (Ne(sin(theta), 0), "sin θ ≠ 0"),
    (Eq(lambda2, lambda1), "λ₂ = λ₁"),
    (Gt(lambda3 * omega3, 2 * sqrt(lambda1 * M * g * R)), "λ₃ω₃ > 2√(λ₁MgR)"),
    (And(Ge(theta, 0), Le(theta, pi / 2)), "θ ≥ 0 and θ ≤ ½π"),
    (sympy.true, "true"),
    (sympy.Matrix([[1, 2], [3, omega1]]), "[1, 2; 3, ω₁]"),
    (sympy.Matrix([1, omega1, 0]), "[1, ω₁, 0]ᵀ"),
    (sympy.Derivative(p_phi, theta), "∂p_φ/∂θ"),
    (sympy.Function("rho")(t), "ρ(t)"),
    (sympy.MatrixSymbol("O", 3, 3).T * sympy.MatrixSymbol("A", 3, 3), "OᵀA"),
    (Symbol("M_1") * Symbol("alpha") - Symbol("c_phi") * Symbol("xddot"), "M₁α − c_φ ẍ"),
]


@pytest.mark.parametrize(("tree", "shown"), MECHANICS, ids=[shown for _, shown in MECHANICS])
def test_the_order_of_mechanics(tree, shown):
    assert text(tree) == unicodedata.normalize("NFC", shown)


@pytest.mark.parametrize("tree", [tree for tree, _ in MECHANICS], ids=str)
def test_every_renderer_knows_every_node(tree):
    assert latex(tree)
    ElementTree.fromstring(mathml(tree))
    assert sizes.width(layout(tree)) > 0


def test_latex_details():
    assert latex(sympy.And(Ge(t, 0), Le(t, 1))) == r"t \geq 0 \quad\text{and}\quad t \leq 1"
    assert latex(Float("1.5e-7")) == r"1.5 \times 10^{-7}"
    assert latex(sqrt(lambda1 / 2)) == r"\tfrac{1}{2}\sqrt{2\lambda_{1}}"
    assert latex(pi * R) == r"\pi R"
    assert latex(sympy.atan2(t, theta)) == r"\operatorname{atan2}(t, \theta)"
    assert latex(sympy.atan(t / R)) == r"\arctan\left(\frac{t}{R}\right)"
    assert latex(sympy.Abs(omega1 / 2)) == r"\tfrac{1}{2}\lvert \omega_{1}\rvert"


def test_the_natural_logarithm_is_ln():
    tree = sympy.log(2 * theta)
    assert text(tree) == "ln(2θ)"
    assert latex(tree) == r"\ln(2\theta)"
    assert "<mi>ln</mi>" in mathml(tree)
    [line] = read(f"E = {latex(tree)}")
    assert line.equation is not None
    assert line.equation.sides[1].doit() == tree


def test_what_is_typed_and_what_is_not():
    with as_printed():
        typed = omega3 * omega1 * lambda1
    assert is_typed(typed)
    with as_printed():
        assert is_typed(omega3 * omega1)
        assert is_typed(psidot + phidot)
        assert is_typed((omega1 * omega3) ** 2)
    assert text(typed) == "ω₃ω₁λ₁"
    assert not is_typed(lambda1 * omega3 * omega1 + 2 * (omega1 + omega2))
    assert text(omega3 * omega1 * lambda1) == "λ₁ω₁ω₃"
    assert text(typed, "mechanics") == text(typed.doit())


def test_typed_order_beats_canonical_order():
    with as_printed():
        side = theta * psi
    assert text(side, "typed") == "θψ"


def test_a_side_from_the_engine_among_printed_ones():
    with as_printed():
        side = Omega * omega3
    engine = M * g * R * cos(theta) + lambda1 * phidot**2 * sin(theta)
    equation = Equation(side, engine)
    assert text(equation, "printed") == "Ωω₃ = λ₁φ̇² sin θ + MgR cos θ"


def test_brackets_stand_where_the_meaning_needs_them():
    a, b, c = symbols("a b c")
    with as_printed():
        cases = {
            a - (b - c): "a − (b − c)",
            a - (b + c) * (b - c): "a − (b + c)(b − c)",
            a * (-b): "a(−b)",
            -(a + b): "−(a + b)",
            (a + b) / (b * c): "(a + b)/(bc)",
            a / b / c: "a/(bc)",
            a / (b / c): "a/(b/c)",
            Rational(1, 2) * a / b / c: "½ (a/(bc))",
            (-a) ** 2: "(−a)²",
            -(a**2): "−a²",
            (a * b) ** 2: "(ab)²",
            a * 2 * b: "a·2b",
            sin(a) * b: "sin a b",
            sin(a * b) * c: "sin(ab)c",
            sin(-a): "sin(−a)",
            sin(a + b) ** 2: "sin²(a + b)",
            Cross(e1, Cross(e1, e2)): "e₁ × (e₁ × e₂)",
            Cross(e1 + e2, e2): "(e₁ + e₂) × e₂",
            Dot(e1, e2) * a: "(e₁ · e₂)a",
            a * Dot(e1, e2): "ae₁ · e₂",
            Group(a * b) * c: "(ab)c",
        }
    assert {shown: text(tree, "typed") for tree, shown in cases.items()} == {
        shown: shown for shown in cases.values()
    }


def test_glyphs_of_names_outside_the_vocabulary():
    assert glyph("M_1") == Glyph("M", "1")
    assert glyph("alpha") == Glyph("α")
    assert glyph("c_phi") == Glyph("c", "φ")
    assert glyph("x2") == Glyph("x", "2")
    assert glyph("betaddot") == Glyph("β", accent="ddot")
    assert glyph("v_vec") == Glyph("v", bold=True)
    assert glyph("nhat") == Glyph("n", accent="hat", bold=True)
    assert glyph("e3p") == Glyph("e", "3", bold=True, prime=True)
    assert glyph("dot") == Glyph("dot")


@pytest.mark.parametrize("symbol", VOCABULARY, ids=str)
def test_the_whole_vocabulary_is_printed(symbol):
    tex, shown = latex(symbol), text(symbol)
    assert tex.isascii()
    ElementTree.fromstring(mathml(symbol))
    assert unicodedata.normalize("NFC", shown) == shown


def test_glyphs_with_an_exponent_a_function_or_a_digit():
    shown = {
        Glyph("ω²", "n"): r"\omega_{n}^{2}",
        Glyph("σ²"): r"\sigma^{2}",
        Glyph("det O"): r"\det O",
        Glyph("1"): "1",
        Glyph("ω", "2,0"): r"\omega_{2,0}",
        Glyph("I", "xz"): "I_{xz}",
        Glyph("L", "½", bold=True): r"\mathbf{L}_{\tfrac{1}{2}}",
        Glyph("ω", "⊥", bold=True): r"\boldsymbol{\omega}_{\perp}",
    }
    for mark, tex in shown.items():
        assert latex(lay.lettered(mark)) == tex
        ElementTree.fromstring(mathml(lay.lettered(mark)))


def test_letters():
    assert letter(Glyph("ω", "1", "dot")) == r"\dot{\omega}_{1}"
    assert letter(Glyph("ω", "1′")) == r"\omega_{1'}"
    assert letter(Glyph("Ω", "−")) == r"\Omega_{-}"
    assert letter(Glyph("z", accent="hat", bold=True)) == r"\hat{\mathbf{z}}"
    assert letter(Glyph("ℒ")) == r"\mathcal{L}"
    assert letter(Glyph("const")) == r"\text{const}"


# --- Aligned displays -----------------------------------------------------------------------------


def test_aligned_lines_with_reasons_and_a_tag(printed):
    first, second = (tuple(sizes.lines(printed[name], "typed")) for name in ("3.57b", "3.57"))
    reason = r"$\omega_{3}$ is constant"
    made = align([AlignRow(first, "3.57b", reason), AlignRow(second, "3.57")])
    assert made == "\n".join(
        [
            r"\begin{align}",
            rf"{LATEX['3.57b'].replace('0 =', '0 &=')} && \text{{$\omega_{{3}}$ is constant}}"
            r" \tag{3.57b} \\",
            rf"{LATEX['3.57'].replace('0 =', '0 &=')} \tag{{3.57}}",
            r"\end{align}",
        ]
    )


def test_a_long_chain_is_broken_before_a_relation(printed):
    made = align([AlignRow(tuple(sizes.lines(printed["3.49"], "typed")), "3.49")])
    assert made.count(r"\\") == 1
    assert made.count(r"\tag{3.49}") == 1
    assert made.count(r"\notag") == 1
    assert r"\notag \\*" + "\n&= " in made


def test_a_long_sum_is_broken_before_a_sign():
    letters = symbols("a b c d", positive=True)
    terms = sum(lambda1 * x * sin(theta) ** i for i, x in enumerate(letters, start=2))
    broken = sizes.lines(Equation(p_phi, terms - lambda2), limit=24)
    assert len(broken) > 1
    assert broken[0].left is not None
    assert all(line.left is None and line.sign == "" for line in broken[1:])
    assert all(text(line.right)[:2] in ("+ ", "− ") for line in broken[1:])
    whole = " ".join(text(line.right) for line in broken)
    assert whole == text(terms - lambda2)


# --- MathML ---------------------------------------------------------------------------------------


def test_mathml_of_an_underbrace(printed):
    made = mathml(printed["3.57b"], "typed")
    brace = (
        '<munder><mrow style="border-bottom:2px dotted;padding-bottom:0.15em">'
        '<mrow><mo form="prefix" fence="true" stretchy="false">(</mo><mrow>'
        '<mover><mi>ψ</mi><mo scriptlevel="0">˙</mo></mover><mo>+</mo><mrow>'
        '<mover><mi>ϕ</mi><mo scriptlevel="0">˙</mo></mover>'
        '<mo>&#x2062;</mo><mspace width="0.1667em"/><mrow><mi>cos</mi><mo>&#x2061;</mo>'
        '<mspace width="0.1667em"/><mi>θ</mi></mrow></mrow></mrow>'
        '<mo form="postfix" fence="true" stretchy="false">)</mo></mrow>'
        "</mrow>"
        "<mrow><mo>≡</mo><msub><mi>ω</mi><mn>3</mn></msub></mrow></munder>"
    )
    assert brace in made


def test_mathml_of_a_small_case():
    assert mathml(Eq(lambda2, lambda1)) == (
        '<math xmlns="http://www.w3.org/1998/Math/MathML" alttext="λ₂ = λ₁"><mrow>'
        "<msub><mi>λ</mi><mn>2</mn></msub><mo>=</mo><msub><mi>λ</mi><mn>1</mn></msub>"
        "</mrow></math>"
    )


@pytest.mark.parametrize("number", LATEX)
def test_mathml_is_well_formed_and_says_itself(printed, number):
    for made in (mathml(printed[number], "typed"), display([printed[number]], "typed")):
        root = ElementTree.fromstring(made)
        assert root.get("alttext") == text(printed[number], "typed")
    assert root.get("display") == "block"
    for element in root.iter():
        arity = {"mfrac": 2, "msub": 2, "msup": 2, "munder": 2, "mover": 2, "msubsup": 3}
        tag = element.tag.rpartition("}")[2]
        assert len(element) == arity.get(tag, len(element)), ElementTree.tostring(element)


# --- Laws -----------------------------------------------------------------------------------------

LETTERS = symbols("a b c d")
VALUES = dict(zip(LETTERS, map(Rational, (2, 3, "5/7", -11)), strict=True))


def _nodes(inner):
    pair = st.tuples(inner, inner)
    return st.one_of(
        pair.map(lambda p: p[0] + p[1]),
        pair.map(lambda p: p[0] - p[1]),
        pair.map(lambda p: p[0] * p[1]),
        pair.map(lambda p: p[0] / p[1]),
        inner.map(lambda x: -x),
        inner.map(lambda x: x**2),
        inner.map(Group),
    )


@st.composite
def typed_trees(draw):
    leaf = st.one_of(
        st.sampled_from(LETTERS),
        st.integers(1, 12).map(sympy.Integer),
        st.sampled_from([Rational(1, 2), Rational(3, 7)]),
    )
    with as_printed():
        return draw(st.recursive(leaf, _nodes, max_leaves=9))


def evaluate(shown: str) -> Fraction:
    """A tiny reader of what `text` writes.  A product binds closer than a fraction bar."""
    tokens = re.findall(r"\d+|[a-z]|[()/+·½⅓⅔¼¾⅛−]|[⁰¹²³⁴⁵⁶⁷⁸⁹]+", shown)
    position = 0

    def peek() -> str:
        return tokens[position] if position < len(tokens) else ""

    def take() -> str:
        nonlocal position
        position += 1
        return tokens[position - 1]

    def total() -> Fraction:
        sign = -1 if peek() == "−" and take() else 1
        result = sign * quotient()
        while peek() in ("+", "−"):
            sign = -1 if take() == "−" else 1
            result += sign * quotient()
        return result

    def quotient() -> Fraction:
        result = product()
        while peek() == "/":
            take()
            result /= factor()
        return result

    def product() -> Fraction:
        result = factor()
        while peek() and peek() not in "+−/)":
            if peek() == "·":
                take()
            result *= factor()
        return result

    def factor() -> Fraction:
        token = take()
        if token == "(":
            result = total()
            assert take() == ")"
        elif token in "½⅓⅔¼¾⅛":
            result = Fraction(unicodedata.normalize("NFKC", token).replace("⁄", "/"))
        elif token.isdigit() and token.isascii():
            result = Fraction(int(token))
        else:
            number = VALUES[Symbol(token)]
            result = Fraction(int(number.p), int(number.q))
        while peek() and peek()[0] in "⁰¹²³⁴⁵⁶⁷⁸⁹":
            result **= int(unicodedata.normalize("NFKC", take()))
        return result

    result = total()
    assert position == len(tokens), shown
    return result


def _value(tree):
    result = value(tree, VALUES)
    return sympy.nsimplify(result.doit() if hasattr(result, "doit") else result)


@settings(max_examples=40)
@given(typed_trees())
def test_what_is_printed_means_what_was_typed(tree):
    expected = _value(tree)
    if not expected.is_Rational:
        return  # a division by zero
    try:
        read = evaluate(text(tree, "typed"))
    except ZeroDivisionError:
        return
    assert read == Fraction(int(expected.p), int(expected.q)), text(tree, "typed")


@settings(max_examples=40)
@given(typed_trees())
def test_the_order_of_mechanics_keeps_the_value(tree):
    tree = value(tree, {})
    tree = tree.doit() if hasattr(tree, "doit") else tree
    if tree.has(sympy.zoo, sympy.nan):
        return
    expected = tree.subs(VALUES)
    if not expected.is_Rational:
        return
    try:
        read = evaluate(text(tree, "mechanics"))
    except ZeroDivisionError:
        return
    assert read == Fraction(int(expected.p), int(expected.q)), text(tree, "mechanics")
