"""TeX taken apart, and letters found whatever they are dressed in."""

import pytest

from rigidtop.notation import NOTES
from rigidtop.read.look import spelling
from rigidtop.read.scan import tokens
from rigidtop.read.tex import UnreadError, pieces
from rigidtop.theory import symbols as s
from rigidtop.theory.symbols import VOCABULARY, Glyph


def kinds(source):
    return [token.kind for token in tokens(source, NOTES)]


def values(source):
    return [token.value for token in tokens(source, NOTES)]


def test_juxtaposed_letters_are_factors_and_an_index_is_none():
    assert values("MgR") == [s.M, s.g, s.R]
    assert values("L_z") == [s.L_z]
    assert values(r"c_\phi c_{\theta}") == [s.c_phi, s.c_theta]


@pytest.mark.parametrize("symbol", VOCABULARY)
def test_every_symbol_of_the_vocabulary_is_one_token(symbol):
    from rigidtop.typeset.latex import latex

    if " " in VOCABULARY[symbol].glyph.base or symbol in (s.unit, s.const, s.A_matrix):
        return  # det O is a function of O, 1 a number, const a word, A here an amplitude
    [token] = tokens(latex(symbol), NOTES)
    assert token.value == symbol


@pytest.mark.parametrize(
    ("source", "symbol"),
    [
        (r"\mathbf{e}_3'", None),
        (r"\mathbf{e}_2'", s.e2p),
        (r"\mathbf{e}'_2", s.e2p),
        (r"\mathbf{e_2}'", s.e2p),
        (r"\mathbf{e}_{2'}", s.e2p),
        (r"\vec{e}_2^{\,\prime}", s.e2p),
        (r"\omega_{1'}", s.omega1p),
        (r"\mathbf{R}_{\text{CM}}", s.R_CM),
        (r"R_{CM}", s.R_CM),
        (r"\mathbf{F}_{\text{grav},M}", s.F_grav),
        (r"\mathbf{F}_k^{(e)}", s.F_k),
        (r"\mathbf{F}^{(e)}_k", s.F_k),
        (r"\mathbf{N}^{(e)}", s.N_ext),
        (r"\mathbf{N}_{\rm ext}", s.N_ext),
        (r"\mathbf N^{\text{ext}}", s.N_ext),
        (r"\mathcal L", s.Lagrangian),
        (r"\mathscr{L}", s.Lagrangian),
        ("ℒ", s.Lagrangian),
        (r"\Omega_-", s.Omega_minus),
        ("Ω₋", s.Omega_minus),
        (r"\varphi", s.phi),
        ("ϕ", s.phi),
        ("θ̈", s.thetaddot),
        ("ẑ", s.zhat),
    ],
)
def test_dresses(source, symbol):
    found = tokens(source, NOTES)
    assert [token.value for token in found if token.kind == "SYMBOL"] == [symbol] * bool(symbol)


def test_what_only_spaces_is_left_out():
    assert kinds(r"T\,\;\!\ ~V\quad\left.\label{x}") == ["SYMBOL", "SYMBOL", "SPACE"]
    assert kinds(r"T\hspace{2em}V\nonumber\\[-1.5ex]") == ["SYMBOL", "SYMBOL", "LINE"]
    assert kinds(r"\\[L]") == ["LINE", "LIST", "SYMBOL", "TSIL"]


def test_comments_end_with_their_line():
    assert values("T % + 1\nV") == [s.T, s.V]


def test_time_and_place_in_brackets_are_left_out():
    assert values(r"\dot{\mathbf{e}}_3(t)\rho(\mathbf{r})") == [s.e3dot, s.rho]


def test_a_star_is_no_part_of_a_letter():
    assert [token.kind for token in tokens(r"\lambda_1*g", NOTES)] == ["SYMBOL", "UNREAD", "SYMBOL"]


@pytest.mark.parametrize("source", ["{", "}", "{{}", "a" * 20_001])
def test_what_is_no_tex_at_all(source):
    with pytest.raises(UnreadError):
        pieces(source)


def test_places_in_unicode_and_entities_are_those_of_the_text():
    source = "&omega;<sub>3</sub> = ½ T"
    assert [source[token.position] for token in tokens(source, NOTES)][:2] == ["&", "="]


def test_glyphs_in_words():
    assert spelling(Glyph("e", "1", bold=True)) == "e_1 with bold type"
