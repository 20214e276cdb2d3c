"""Sentences with mathematics in them, as LaTeX, as HTML and on one line of Unicode."""

import ast
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

import rigidtop
from rigidtop.notation.characters import MATHS, SUBSCRIPTS, SUPERSCRIPTS, escape
from rigidtop.report.html import prose_html
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset.mathml import APPLY, THIN, held
from rigidtop.typeset.words import characters, parts, prose, tex, unmarked

CHARACTERS = {
    r"\ddot\theta": "θ̈",
    r"\sin\theta \neq 0": "sin θ ≠ 0",
    r"\lambda_1\sin^2\theta": "λ₁ sin² θ",
    r"\hat{\mathbf z} = \cos\theta\,\mathbf e_3": "ẑ = cos θ e₃",
    r"\mathbf e_1'^2 + \omega_{1'}": "e₁′² + ω₁′",
    r"\tfrac12\boldsymbol\omega\cdot\mathbf L": "½ω·L",
    r"\sqrt{\lambda_1\lambda_3} + \sqrt{2}": "√(λ₁λ₃) + √2",
    r"p_\phi - L_z": "p_φ − L_z",
    r"\mathbf R_{\text{CM}} \times M\mathbf g": "R_CM × Mg",
    r"e^{\sigma t} + 2^n": "e^(σt) + 2ⁿ",
    r"5\cdot10^{-5}{}^\circ": "5·10⁻⁵°",
    r"|\omega_\perp| \leq 2MgR\sin\theta": "|ω⊥| ≤ 2MgR sin θ",
    r"\frac{2\pi}{|\Omega_b|}": "(2π)/(|Ω_b|)",
    r"O^{-1} = O^T": "O⁻¹ = Oᵀ",
    r"\partial\mathcal{L}/\partial\dot\phi": "∂ℒ/∂φ̇",
    r"\omega t": "ωt",
    r"U''/\lambda_1": "U″/λ₁",
    r"\ln(8\sin(\theta/2))": "ln(8 sin(θ/2))",
    r"\omega_{2,0} = 0": "ω_2,0 = 0",
    r"\theta\text{-axis}": "θ-axis",
}


@pytest.mark.parametrize("formula", CHARACTERS)
def test_a_formula_on_one_line_of_unicode(formula):
    assert characters(formula) == CHARACTERS[formula]


def test_prose_as_latex_ties_numbers_to_their_units():
    assert prose(r"100 % & $a_b$ #1 {x}") == r"100\,\% \& $a_b$ \#1 \{x\}"
    assert prose("0.981 N at 3 m, 2 J s, $N = 2$ N m") == (
        r"0.981\,N at 3\,m, 2\,J\,s, $N = 2$\,N\,m"
    )
    assert prose("a height $h$ (m), as $s$ grows") == "a height $h$ (m), as $s$ grows"
    assert prose("at the distances $a$ and $b$") == "at the distances $a$ and $b$"
    assert prose("Wüster, naïve — “so”") == "Wüster, naïve --- ``so''"


def test_an_unknown_character_is_named():
    with pytest.raises(ValueError, match=r"'☃' \(U\+2603, SNOWMAN\)"):
        prose("cold ☃")
    with pytest.raises(ValueError, match="U\\+2603"):
        prose(r"$\theta☃$")


@pytest.mark.parametrize("character", [*MATHS, *SUBSCRIPTS, *SUPERSCRIPTS])
def test_every_character_in_a_formula_becomes_a_command(character):
    assert tex(f"a{character}").isascii()


def test_commands_beside_characters_stay_whole():
    for character in MATHS:
        made = tex(rf"\theta = \lambda_1 {character} 4")
        assert made.startswith(r"\theta = \lambda_1 ")
    assert tex("\\theta = 3\u202f×\u202f10⁻⁶\u202frad") == (
        r"\theta = 3\,\times\,10^{-6}\,\text{rad}"
    )


def test_the_meanings_of_the_vocabulary_are_prose():
    for quantity in VOCABULARY.values():
        assert prose(quantity.meaning).isascii()
        assert prose(quantity.unit) or not quantity.unit


@pytest.mark.parametrize(
    "room", ["chapters", "derivations", "figures", "notation", "starter", "theory"]
)
def test_formulas_in_sentences_are_latex(room):
    folder = Path(rigidtop.__file__).parent / room
    folder = folder if folder.exists() else folder.parent.parent / room
    for file in folder.rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                words = re.sub(r"\{\w+:[^}]*\}", "", node.value)  # the numbers of a caption
                assert all(part.isascii() for formal, part in parts(words) if formal), words


def test_parts_lose_nothing():
    text = r"$a$ and $b + c$, $5 or $6"
    assert "".join(part for _, part in parts(text)) == "a and b + c, $5 or $6"


def test_what_is_not_marked_is_no_formula():
    """But what LaTeX has no letter for is written as it can be."""
    assert prose("MgR, sin, a_b") == r"MgR, sin, a\_b"
    assert prose("−1.6·10⁻⁵, m², e₁") == r"$-$1.6$\cdot$10$^{-5}$, m$^{2}$, e$_{1}$"


def test_a_sentence_for_the_terminal_has_no_marks():
    assert unmarked(r"the angle of $\dot{\mathbf L}$ and $\boldsymbol\omega'$") == (
        "the angle of L̇ and ω′"
    )


def _marked_up(text: str) -> str:
    """Prose as HTML, without the frame of each formula."""
    return re.sub(r'<math xmlns="[^"]*" alttext="[^"]*">(.*?)</math>', r"⟦\1⟧", prose_html(text))


HTML = {
    r"$\lambda_1 < \lambda_3$ & $\cos\theta$": "⟦<mrow><msub><mi>λ</mi><mn>1</mn></msub><mo>&lt;"
    "</mo><msub><mi>λ</mi><mn>3</mn></msub></mrow>⟧ &amp; "
    f"⟦<mrow><mi>cos</mi>{APPLY}{THIN}<mi>θ</mi></mrow>⟧",
    "a <b>'s": "a &lt;b&gt;’s",
    r"$\sqrt D$ apart": "⟦<msqrt><mi>D</mi></msqrt>⟧ apart",
    r"$\mathbf e_2'$": '⟦<msub><mrow><mi mathvariant="normal" style="font-weight:bold">e</mi>'
    '<mpadded width="0"><mo>′</mo></mpadded></mrow><mn>2</mn></msub>⟧',
    "$10⁻⁶$": '⟦<msup><mn>10</mn><mrow><mo form="prefix">−</mo><mn>6</mn></mrow></msup>⟧',
    r"kg $\mathrm m^2$": "kg ⟦<msup><mtext>m</mtext><mn>2</mn></msup>⟧",
}


@pytest.mark.parametrize("text", HTML)
def test_prose_as_html(text):
    assert _marked_up(text) == HTML[text]


def test_a_bracket_is_raised_as_a_whole():
    made = _marked_up(r"$(\cos\theta)^2$")
    assert made.startswith("⟦<msup><mrow>")
    assert made.endswith("</mo></mrow><mn>2</mn></msup>⟧")


@pytest.mark.parametrize("formula", [*CHARACTERS, *(f"a{character}2" for character in MATHS)])
def test_html_of_prose_is_well_formed_and_says_itself(formula):
    root = ElementTree.fromstring(f"<p>{prose_html(f'${formula}$')}</p>")
    assert [child.get("alttext") for child in root] == [characters(formula)]


def test_escape_covers_what_tex_reserves():
    assert escape("\\~^") == r"\textbackslash{}\textasciitilde{}\textasciicircum{}"


def test_no_line_ends_between_a_formula_and_its_comma():
    words = r"It is $\sqrt 3$; so ($\theta$) is, or $\theta$ here, $F = 2$ N m, 3 N, 45 turns."
    made = held(prose_html(words))
    assert re.findall(r'<span class="m">([^<]*)<math.*?</math>([^<]*)</span>', made) == [
        ("", ";"),
        ("(", ")"),
        ("", "\u202fN\u202fm,"),
    ]
    assert made.endswith("3\u202fN, 45\u00a0turns.")
    assert made.count("<span") == 3
