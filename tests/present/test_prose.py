"""Prose with mathematics in it."""

import pytest

from rigidtop.present.characters import MATHS, SUBSCRIPTS, SUPERSCRIPTS
from rigidtop.present.prose import escape, prose, prose_html, segments
from rigidtop.theory.symbols import VOCABULARY

CASES = {
    "θ̈ vanishes": r"$\ddot{\theta}$ vanishes",
    "100 % & a_b #1 {x} $": r"100 \% \& $a_{b}$ \#1 \{x\} \$",
    "sin θ ≠ 0, or sin²θ": r"$\sin \theta \neq 0$, or $\sin^{2}\theta$",
    "cosθ = 0": r"$\cos\theta = 0$",
    "along ẑ and e₃": r"along $\hat{\mathbf{z}}$ and $\mathbf{e}_{3}$",
    "ω₁′ along e₁′": r"$\omega_{1'}$ along $\mathbf{e}_{1}'$",
    "e₁′² + ω₃²": r"$\mathbf{e}_{1}^{\prime 2} + \omega_{3}^{2}$",
    "T = ½ω·L": r"$T = \tfrac{1}{2}\boldsymbol{\omega}\cdot\mathbf{L}$",
    "O⁻¹ = Oᵀ": r"$O^{-1} = O^{T}$",
    "L ∥ ω (3.43)": r"$\mathbf{L} \parallel \boldsymbol{\omega}$ (3.43)",
    "√(λ₁λ₃) and √2": r"$\sqrt{\lambda_{1}\lambda_{3}}$ and $\sqrt{2}$",
    "(λ₁ − λ₃)ω₃/λ₁": r"$(\lambda_{1} - \lambda_{3})\omega_{3}/\lambda_{1}$",
    "L_z and p_φ": r"$L_{z}$ and $p_{\phi}$",
    "kg m², rad/s²": r"kg $\mathrm{m}^{2}$, $\mathrm{rad/s}^{2}$",
    "Wüster, naïve — “so”": "Wüster, naïve --- ``so''",
    "the ẑ-axis, θ's rate": r"the $\hat{\mathbf{z}}\text{-axis}$, $\theta\text{'s}$ rate",
    "ω₃ → ∞": r"$\omega_{3} \to \infty$",
    "Σₖ mₖ": r"$\sum_{k}$ $m_{k}$",
    "∫ρ d³r": r"$\int\rho$ $d^{3}r$",
    "about 10⁻⁹": r"about $10^{-9}$",
    "Rz(φ) Ry(θ)": r"$R_{z}(\phi)$ $R_{y}(\theta)$",
    "((λ₁ − λ₃)ω₃ > 0: a word)": r"($(\lambda_{1} - \lambda_{3})\omega_{3} > 0$: a word)",
    "√(1 − m sin² χ) of m": r"$\sqrt{1 - m \sin^{2} \chi}$ of m",
    "5·10⁻⁵°": r"$5\cdot10^{-5}{}^{\circ}$",
    "a top at rest": "a top at rest",
    "ṙ = Ω × r": r"$\dot{r} = \boldsymbol{\Omega} \times \mathbf{r}$",
    "L̇ = N": r"$\dot{L} = N$",
    "for ω₃ > 0 Ω_b < 0": r"for $\omega_{3} > 0$ $\Omega_{b} < 0$",
    "MgR sin θ": r"$MgR$ $\sin \theta$",
    "ω⊥ across": r"$\omega_{\perp}$ across",
    "|ω|": r"$\vert\omega\vert$",
}


@pytest.mark.parametrize("text", CASES)
def test_prose_as_latex(text):
    assert prose(text) == CASES[text]


def test_an_unknown_character_is_named():
    with pytest.raises(ValueError, match=r"'☃' \(U\+2603, SNOWMAN\)"):
        prose("cold ☃")
    with pytest.raises(ValueError, match="U\\+2603"):
        prose("θ☃")


@pytest.mark.parametrize("character", [*MATHS, *SUBSCRIPTS, *SUPERSCRIPTS])
def test_every_character_becomes_ascii(character):
    made = prose("√2" if character == "√" else f"θ{character}")
    assert made.isascii(), made


def test_the_meanings_of_the_vocabulary_are_prose():
    for quantity in VOCABULARY.values():
        assert prose(quantity.meaning)
        assert prose(quantity.unit) or not quantity.unit


def test_segments_lose_nothing():
    for text in CASES:
        assert "".join(piece for _, piece in segments(text)) == text


def test_prose_as_html():
    assert prose_html("λ₁ < λ₃ & cosθ") == (
        '<span class="m"><i>λ</i><sub>1</sub> &lt; <i>λ</i><sub>3</sub></span> &amp; '
        '<span class="m">cos\u2009<i>θ</i></span>'
    )
    assert prose_html("a <b>'s") == "a &lt;b&gt;’s"
    assert prose_html("p_φ, ω₃², ẑ, e₂′") == (
        '<span class="m"><i>p</i><sub><i>φ</i></sub></span>, '
        '<span class="m"><i>ω</i><sub>3</sub><sup>2</sup></span>, '
        '<span class="m"><b>ẑ</b></span>, <span class="m"><b>e</b><sub>2</sub>′</span>'
    )


def test_escape_covers_what_tex_reserves():
    assert escape("\\~^") == r"\textbackslash{}\textasciitilde{}\textasciicircum{}"
