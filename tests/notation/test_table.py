"""Tables in files: what is wrong with one is one line."""

import pytest

from rigidtop.errors import RigidtopError
from rigidtop.notation import BUILT_IN, GOLDSTEIN, NOTES, named
from rigidtop.notation.table import identifier, parsed
from rigidtop.theory import symbols as s
from rigidtop.theory.symbols import VOCABULARY, Glyph


@pytest.mark.parametrize("name", BUILT_IN)
def test_every_built_in_table_says_where_it_comes_from(name):
    notation = named(name)
    assert notation.title
    assert len(notation.source) > 40
    assert set(notation.glyphs) == set(VOCABULARY)


@pytest.mark.parametrize("name", BUILT_IN)
def test_letters_and_names_are_unambiguous(name):
    notation = named(name)
    names = [notation.letters.get(x, x).name for x in VOCABULARY]
    assert len(set(names)) == len(names)
    for symbol in notation.letters:
        glyph = notation.glyphs[symbol]
        assert [x for x, other in notation.glyphs.items() if other == glyph] == [symbol]


def test_letters_of_the_books():
    landau, taylor, morin = map(named, ("landau", "taylor", "morin"))
    assert GOLDSTEIN.glyphs[s.lambda3] == Glyph("I", "3")
    assert landau.glyphs[s.M] == Glyph("μ")
    assert landau.glyphs[s.L3] == Glyph("M", "3")
    assert landau.glyphs[s.omega3dot] == Glyph("Ω", "3", "dot")
    assert landau.glyphs[s.Lagrangian] == Glyph("L")
    assert taylor.glyphs[s.N_vec] == Glyph("Γ", bold=True)
    assert taylor.glyphs[s.lambda1] == NOTES.glyphs[s.lambda1]
    assert morin.glyphs[s.R] == Glyph("ℓ")
    assert {n.name: n.sequence for n in map(named, BUILT_IN)} == {
        "notes": "zyz",
        "goldstein": "zxz",
        "landau": "zxz",
        "taylor": "zyz",
        "morin": "zxz",
    }


def test_a_symbol_is_found_by_its_letter():
    assert GOLDSTEIN.symbol(Glyph("I", "1")) == s.lambda1
    assert GOLDSTEIN.symbol(Glyph("λ", "1")) is None
    assert GOLDSTEIN.symbol(Glyph("ℓ")) == s.R
    assert NOTES.symbol(Glyph("N", "(e)", bold=True)) == s.N_ext
    assert NOTES.symbol(Glyph("x", accent="hat")) == s.xhat  # bold type forgiven
    assert named("landau").symbol(Glyph("N", "(e)", bold=True)) is None


def test_angles_by_other_letters():
    table = parsed('[euler]\nsequence = "zxz"\nangles = ["ψ", "θ", "φ"]', "mine")
    assert (table.letters[s.phi].name, table.letters[s.psidot].name) == ("psi", "phidot")
    assert table.glyphs[s.p_phi] == Glyph("p", "ψ")
    assert table.glyphs[s.c_psi] == Glyph("c", "φ")


def test_a_table_of_ones_own(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(
        'title = "Mine"\n[symbols]\nR = { base = "h", sub = "c", meaning = "height" }\n'
    )
    mine = named(str(path))
    assert (mine.name, mine.title) == ("mine", "Mine")
    assert mine.letters[s.R].name == "h_c"
    assert mine.letters[s.R].quantity.meaning == "height"
    assert mine.letters[s.R].quantity.unit == "m"
    assert set(mine.letters) == {s.R}


def test_what_is_not_said_of_a_glyph_stays():
    table = parsed("[symbols]\nR_CM = { sub = 'S' }\nM = { name = 'mass' }", "mine")
    assert table.glyphs[s.R_CM] == Glyph("R", "S", bold=True)
    assert table.letters[s.M].name == "mass"
    assert table.glyphs[s.M] == Glyph("M")


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ("title", "not TOML: Expected '=' after a key"),
        ("titel = 'x'", "no entry 'titel' in a notation; did you mean title?"),
        ("title = 3", "title wants text, not 3"),
        ("symbols = 3", "symbols wants a table, not 3"),
        (
            "[symbols]\nlamda1 = { base = 'I' }",
            "symbols: no symbol 'lamda1'; did you mean lambda1?",
        ),
        ("[symbols]\nR = 'l'", "symbols.R wants a table, not 'l'"),
        ("[symbols]\nR = { base = 3 }", "symbols.R.base wants text, not 3"),
        ("[symbols]\nR = { base = ' ' }", "symbols.R.base is empty"),
        ("[symbols]\nR = { base = 'l', bold = 'yes' }", "symbols.R.bold wants true or false"),
        ("[symbols]\nR = { base = 'l', accent = 'tilde' }", "symbols.R.accent is dot, ddot or hat"),
        ("[symbols]\nR = { bas = 'l' }", "symbols.R: no part 'bas'; did you mean base?"),
        ("[symbols]\nR = { base = 'l', name = 'l 1' }", "symbols.R: 'l 1' is no name for code"),
        ("[symbols]\nR = { base = 'l', name = 'lambda' }", "'lambda' is no name for code"),
        ("[symbols]\nR = { base = '3' }", "symbols.R: '3' is no name for code"),
        ("[symbols]\nR = { base = 'M' }", "M and R are both written M"),
        ("[symbols]\nR = { base = 'l' }\nM = { base = 'l' }", "M and R are both written l"),
        ("[letters]\n'λ' = 'ω'", "omega1 and lambda1 are both written ω_1"),
        ("[letters]\n'L' = 'M'", "M and L are both written M"),
        ("[symbols]\nR = { base = 'l', name = 'g' }", "g and R are both named g in code"),
        ("[letters]\n'ж' = 'I'", "letters: no symbol is written with 'ж'"),
        ("[symbols]\nR = { base = 'ж' }", "symbols.R.base: 'ж' is no letter that is known here"),
        ("[symbols]\nR = { base = '<b>' }", "symbols.R.base: '<' is no letter"),
        ("[symbols]\nR = { base = '\\input{x}' }", "symbols.R.base: '\\\\' is no letter"),
        ("[symbols]\nR = { base = 'l', sub = '$' }", "symbols.R.sub: '$' is no letter"),
        ("[letters]\n'λ' = '&'", "letters.λ: '&' is no letter"),
        ("[euler]\nangles = ['a', 'b', '%']", "euler.angles: '%' is no letter"),
        ("[letters]\n'λ' = ''", "letters.λ is empty"),
        ("[euler]\nsequence = 'zyx'", "euler.sequence is zyz or zxz, whose θ is the polar angle"),
        ("[euler]\nangle = 'zyx'", "euler: no entry 'angle'; did you mean angles?"),
        ("[euler]\nangles = ['φ', 'θ']", "euler.angles wants three different letters"),
        ("[euler]\nangles = ['φ', 'θ', 'φ']", "euler.angles wants three different letters"),
        ("[euler]\nangles = ['α', 'β', 'γ']", "are both written"),
        ("[spellings]\nR = { base = 'l' }", "spellings.R wants a list"),
        ("[spellings]\nR = [{ base = 'l' }]\nM = [{ base = 'l' }]", "l is R already"),
        ("", "it is no table of a notation: no title, no entry"),
        ("title = ''\n[letters]", "it is no table of a notation: no title, no entry"),
    ],
)
def test_what_is_wrong_is_one_line(table, said):
    with pytest.raises(RigidtopError) as error:
        parsed(table, "mine", "mine.toml")
    assert str(error.value).startswith("mine.toml: ")
    assert said in str(error.value)
    assert "\n" not in str(error.value)


def test_no_such_notation():
    with pytest.raises(RigidtopError, match=r"no notation 'goldstien'; did you mean goldstein\?"):
        named("goldstien")


@pytest.mark.parametrize(
    ("glyph", "name"),
    [
        (Glyph("λ", "1"), "lambda1"),
        (Glyph("Ω", "+"), "Omega_plus"),
        (Glyph("e", "1", bold=True, prime=True), "e1p"),
        (Glyph("z", accent="hat", bold=True), "zhat"),
        (Glyph("L", accent="dot", bold=True), "L_vecdot"),
        (Glyph("ℓ"), "l"),
        (Glyph("ω²", "n"), "omega2_n"),
    ],
)
def test_names_in_code(glyph, name):
    assert identifier(glyph) == name
