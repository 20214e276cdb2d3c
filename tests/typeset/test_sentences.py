"""Prose with mathematics in it."""

import re
from xml.etree import ElementTree

import pytest

from rigidtop.notation.characters import MATHS, SUBSCRIPTS, SUPERSCRIPTS, escape
from rigidtop.proof.words import bold, parts, unbold, unmarked
from rigidtop.report.html import prose_html
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset.mathml import APPLY, THIN, held
from rigidtop.typeset.sentences import prose

CASES = {
    "$θ̈$ vanishes": r"$\ddot{\theta}$ vanishes",
    "100 % & $a_b$ #1 {x}": r"100\,\% \& $a_{b}$ \#1 \{x\}",
    "$sin θ ≠ 0$, or $sin²θ$": r"$\sin \theta \neq 0$, or $\sin^{2}\theta$",
    "$cosθ = 0$": r"$\cos\theta = 0$",
    "along $ẑ$ and $e₃$": r"along $\hat{\mathbf{z}}$ and $\mathbf{e}_{3}$",
    "$ω₁′$ along $e₁′$": r"$\omega_{1'}$ along $\mathbf{e}_{1}'$",
    "$e₁′² + ω₃²$": r"$\mathbf{e}_{1}^{\prime 2} + \omega_{3}^{2}$",
    "$T = ½𝛚·𝐋$": r"$T = \tfrac{1}{2}\boldsymbol{\omega}\cdot\mathbf{L}$",
    "$O⁻¹ = Oᵀ$": r"$O^{-1} = O^{T}$",
    "$𝐋 ∥ 𝛚$ (3.43)": r"$\mathbf{L} \parallel \boldsymbol{\omega}$ (3.43)",
    "$√(λ₁λ₃)$ and $√2$": r"$\sqrt{\lambda_{1}\lambda_{3}}$ and $\sqrt{2}$",
    "$(λ₁ − λ₃)ω₃/λ₁$": r"$(\lambda_{1} - \lambda_{3})\omega_{3}/\lambda_{1}$",
    "$L_z$ and $p_φ$": r"$L_{z}$ and $p_{\phi}$",
    "kg $m²$, $rad/s²$": r"kg $\mathrm{m}^{2}$, $\mathrm{rad/s}^{2}$",
    "Wüster, naïve — “so”": "Wüster, naïve --- ``so''",
    "the $ẑ-axis$, $θ's$ rate": r"the $\hat{\mathbf{z}}\text{-axis}$, $\theta\text{'s}$ rate",
    "$ω₃ → ∞$": r"$\omega_{3} \to \infty$",
    "$Σₖ mₖ$": r"$\sum_{k} m_{k}$",
    "$∫ρ d³r$": r"$\int\rho d^{3}r$",
    "about $10⁻⁹$": r"about $10^{-9}$",
    "$Rz(φ) Ry(θ)$": r"$R_{z}(\phi) R_{y}(\theta)$",
    "($(λ₁ − λ₃)ω₃ > 0$: a word)": r"($(\lambda_{1} - \lambda_{3})\omega_{3} > 0$: a word)",
    "$√(1 − m sin² χ)$ of $m$": r"$\sqrt{1 - m \sin^{2} \chi}$ of $m$",
    "$5·10⁻⁵°$": r"$5\cdot10^{-5}{}^{\circ}$",
    "a top at rest": "a top at rest",
    "$𝐫̇ = 𝛀 × 𝐫$": r"$\dot{\mathbf{r}} = \boldsymbol{\Omega} \times \mathbf{r}$",
    "$𝐋̇ = 𝐍$": r"$\dot{\mathbf{L}} = \mathbf{N}$",
    "for $ω₃ > 0$ $Ω_b < 0$": r"for $\omega_{3} > 0$ $\Omega_{b} < 0$",
    "$MgR sin θ$": r"$MgR \sin \theta$",
    "$ω⊥$ across": r"$\omega_{\perp}$ across",
    "$|ω|$": r"$\vert\omega\vert$",
    "$= MgR(cos θ₀ − cos θ)$": r"$= MgR(\cos \theta_{0} - \cos \theta)$",
    "$|ω⊥| ≤ 2MgR sin θ$": r"$\vert\omega_{\perp}\vert \leq 2MgR \sin \theta$",
    "$Σ m(𝐫 − 𝐑_CM) × 𝐠$": r"$\sum m(\mathbf{r} - \mathbf{R}_{\text{CM}}) \times \mathbf{g}$",
    "as $|𝐋 × 𝛚|/𝐋·𝛚$": r"as $\vert\mathbf{L} \times \boldsymbol{\omega}\vert"
    r"/\mathbf{L}\cdot\boldsymbol{\omega}$",
    "gravity ($g$), tilt (m)": r"gravity ($g$), tilt (m)",
    "as $K(m)$ grows": r"as $K(m)$ grows",
    "if $ω_2,0 = 0$": r"if $\omega_{2,0} = 0$",
    "as $|L|$ and $K$ go": r"as $\vert L\vert$ and $K$ go",
    "$𝐋 = Σ m 𝐫 × 𝐯$": r"$\mathbf{L} = \sum m \mathbf{r} \times \mathbf{v}$",
    "$𝐑_CM × M𝐠$": r"$\mathbf{R}_{\text{CM}} \times M\mathbf{g}$",
    "grows as $e^{σt}$ or $2^n$": r"grows as $e^{\sigma t}$ or $2^{n}$",
    "$e^(−x/2)$": r"$e^{-x/2}$",
    "$ln(8 sin(θ/2))$": r"$\ln(8 \sin(\theta/2))$",
    "$(C − A)/C$ and $(AB)C$": r"$(C - A)/C$ and $(AB)C$",
    "0.981 N at 3 m, 2 J s": r"0.981\,N at 3\,m, 2\,J\,s",
    "$N = 2$ N m": r"$N = 2$\,N\,m",
    "a height $h$ (m), as $s$ grows": r"a height $h$ (m), as $s$ grows",
    "at the distances $a$ and $b$": r"at the distances $a$ and $b$",
    "A top turns by $A$": r"A top turns by $A$",
    "$(d cos θ/dχ)²$": r"$(d \cos \theta/d\chi)^{2}$",
    "the angle of $𝐋$ and $𝛚$": r"the angle of $\mathbf{L}$ and $\boldsymbol{\omega}$",
    "a body with the speed $ω$, a rod of length $L$": r"a body with the speed $\omega$, "
    r"a rod of length $L$",
    "$𝐋 = I𝛚$": r"$\mathbf{L} = I\boldsymbol{\omega}$",
    "$𝛚 = 𝐋/λ₁ + kω₃e₃$": r"$\boldsymbol{\omega} = \mathbf{L}/\lambda_{1} + k\omega_{3}"
    r"\mathbf{e}_{3}$",
    "$|𝛚 × 𝐋|/(ωL)$": r"$\vert\boldsymbol{\omega} \times \mathbf{L}\vert/(\omega L)$",
    "about $𝐋$ at the rate $L/λ₁$": r"about $\mathbf{L}$ at the rate $L/\lambda_{1}$",
    "so $𝐮·I𝐯 = 𝐯·I𝐮$ for all $𝐮$ and $𝐯$": r"so $\mathbf{u}\cdot I\mathbf{v} = "
    r"\mathbf{v}\cdot I\mathbf{u}$ for all $\mathbf{u}$ and $\mathbf{v}$",
    "from $ω$ to $−ω$": r"from $\omega$ to $-\omega$",
}


@pytest.mark.parametrize("text", CASES)
def test_prose_as_latex(text):
    assert prose(text) == CASES[text]


def test_an_unknown_character_is_named():
    with pytest.raises(ValueError, match=r"'☃' \(U\+2603, SNOWMAN\)"):
        prose("cold ☃")
    with pytest.raises(ValueError, match="U\\+2603"):
        prose("$θ☃$")


@pytest.mark.parametrize("character", [*MATHS, *SUBSCRIPTS, *SUPERSCRIPTS])
def test_every_character_becomes_ascii(character):
    made = prose("$√2$" if character == "√" else f"$θ{character}$")
    assert made.isascii(), made


def test_the_meanings_of_the_vocabulary_are_prose():
    for quantity in VOCABULARY.values():
        assert prose(quantity.meaning)
        assert prose(quantity.unit) or not quantity.unit


def test_parts_lose_nothing():
    for text in CASES:
        assert "".join(part for _, part in parts(text)) == text.replace("$", "")


def test_what_is_not_marked_is_no_formula():
    """But what LaTeX has no letter for is written as it can be."""
    assert prose("MgR, sin, a_b") == r"MgR, sin, a\_b"
    assert prose("−1.6·10⁻⁵, m², e₁") == r"$-$1.6$\cdot$10$^{-5}$, m$^{2}$, e$_{1}$"


def test_a_sentence_for_the_terminal_has_no_marks():
    assert unmarked("the angle of $𝐋̇$ and $𝛚′$") == "the angle of L̇ and ω′"
    assert all(unbold(bold(letter)) == letter for letter in "AZazαωΩLNω")


def _marked_up(text: str) -> str:
    """Prose as HTML, without the frame of each formula."""
    return re.sub(r'<math xmlns="[^"]*" alttext="[^"]*">(.*?)</math>', r"⟦\1⟧", prose_html(text))


HTML = {
    "$λ₁ < λ₃$ & $cosθ$": "⟦<mrow><msub><mi>λ</mi><mn>1</mn></msub><mo>&lt;</mo>"
    "<msub><mi>λ</mi><mn>3</mn></msub></mrow>⟧ &amp; "
    f"⟦<mrow><mi>cos</mi>{APPLY}{THIN}<mi>θ</mi></mrow>⟧",
    "a <b>'s": "a &lt;b&gt;’s",
    "$φ̇$, $θ̈$": '⟦<mover><mi>ϕ</mi><mo scriptlevel="0">˙</mo></mover>⟧, '
    '⟦<mover><mi>θ</mi><mo scriptlevel="0">¨</mo></mover>⟧',
    "is $√3$": "is ⟦<msqrt><mn>3</mn></msqrt>⟧",
    "$√D$ apart": "⟦<msqrt><mi>D</mi></msqrt>⟧ apart",
    "$√(1 − m)$": "⟦<msqrt><mrow><mn>1</mn><mo>−</mo><mi>m</mi></mrow></msqrt>⟧",
    "$p_φ$, $ω₃²$, $e₂′$": "⟦<msub><mi>p</mi><mi>ϕ</mi></msub>⟧, "
    "⟦<msubsup><mi>ω</mi><mn>3</mn><mn>2</mn></msubsup>⟧, "
    '⟦<msub><mrow><mi mathvariant="normal" style="font-weight:bold">e</mi>'
    '<mpadded width="0"><mo>′</mo></mpadded></mrow><mn>2</mn></msub>⟧',
    "$e^{σt}$": "⟦<msup><mi>e</mi><mrow><mi>σ</mi><mi>t</mi></mrow></msup>⟧",
    "$sin²θ$": f"⟦<mrow><msup><mi>sin</mi><mn>2</mn></msup>{APPLY}{THIN}<mi>θ</mi></mrow>⟧",
    "$|ω|$": '⟦<mrow><mo form="prefix" fence="true" stretchy="false">|</mo><mi>ω</mi>'
    '<mo form="postfix" fence="true" stretchy="false">|</mo></mrow>⟧',
    "$Ω₋$": '⟦<msub><mi mathvariant="normal">Ω</mi><mo form="prefix">−</mo></msub>⟧',
    "$½$": "⟦<mfrac><mn>1</mn><mn>2</mn></mfrac>⟧",
    "$10⁻⁶$": '⟦<msup><mn>10</mn><mrow><mo form="prefix">−</mo><mn>6</mn></mrow></msup>⟧',
    "kg $m²$": "kg ⟦<msup><mtext>m</mtext><mn>2</mn></msup>⟧",
}


@pytest.mark.parametrize("text", HTML)
def test_prose_as_html(text):
    assert _marked_up(text) == HTML[text]


def test_a_bracket_is_raised_as_a_whole():
    made = _marked_up("$(cos θ)²$")
    assert made.startswith("⟦<msup><mrow>")
    assert made.endswith("</mo></mrow><mn>2</mn></msup>⟧")


@pytest.mark.parametrize("text", [*CASES, *(f"$θ{character}2$" for character in MATHS)])
def test_html_of_prose_is_well_formed_and_says_itself(text):
    root = ElementTree.fromstring(f"<p>{prose_html(text)}</p>")
    formulas = [unbold(formula) for formal, formula in parts(text) if formal]
    assert [child.get("alttext") for child in root] == formulas


def test_escape_covers_what_tex_reserves():
    assert escape("\\~^") == r"\textbackslash{}\textasciitilde{}\textasciicircum{}"


def test_no_line_ends_between_a_formula_and_its_comma():
    made = held(prose_html("It is $√3$; so ($θ$) is, or $θ$ here, $F = 2$ N m, 3 N, 45 turns."))
    assert re.findall(r'<span class="m">([^<]*)<math.*?</math>([^<]*)</span>', made) == [
        ("", ";"),
        ("(", ")"),
        ("", "\u202fN\u202fm,"),
    ]
    assert made.endswith("3\u202fN, 45\u00a0turns.")
    assert made.count("<span") == 3
