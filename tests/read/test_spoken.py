"""What a file says of its letters is said with them, and nothing that it does not say."""

import pytest
from sympy import Mul

from rigidtop.commands.read import run
from rigidtop.notation import OWN
from rigidtop.proof.equation import At
from rigidtop.read.document import formulas
from rigidtop.read.formula import read
from rigidtop.read.habits import Habits
from rigidtop.read.spoken import spoken
from rigidtop.theory.symbols import Glyph

SAID = {
    r"where $I_1$ is the moment of inertia about $e_1$.": (
        "moment of inertia",
        "moment of inertia",
    ),
    "Let $x$ be the displacement, then": ("the displacement", "length"),
    "Here $x(t)$ denotes the angle to the vertical.": ("the angle", "angle"),
    "a bob of mass $m$ hangs": ("mass", "mass"),
    "and total angular momentum $\\vec L$": ("angular momentum", "angular momentum"),
    "$o$ is the position of the center of mass.": (
        "the position of the center of mass",
        "position",
    ),
    "where $q$ is a constant of": ("a constant", ""),
}


@pytest.mark.parametrize("text", SAID)
def test_words_of_a_letter(text):
    [found] = spoken(text, OWN).values()
    assert (found.words.startswith(SAID[text][0]) or SAID[text][0] in found.words, found.kind) == (
        True,
        SAID[text][1],
    )


@pytest.mark.parametrize(
    "text",
    [
        "the sum $m + n$ is the mass",
        "we see that $m$ is large",
        "$v$ is a bit more complicated due to it",
        "from the mass we find $k$",
        "$$m$$ is the mass",
    ],
)
def test_what_says_nothing_of_a_letter(text):
    assert spoken(text, OWN) == {}


def test_the_first_words_count_with_their_line():
    found = spoken("\nIts mass $m$.\n\nLet $m$ be the slope.", OWN)
    assert (found[Glyph("m")].words, found[Glyph("m")].line) == ("mass", 2)


def test_read_says_them_and_where_an_l_stays_open(tmp_path, capsys):
    from argparse import Namespace

    def letters(words):
        path = tmp_path / "a.md"
        path.write_text(f"{words}\n\n$$L = I_1\\omega$$", "utf-8")
        run(Namespace(file=str(path), notation="own", json=False))
        return capsys.readouterr().out

    told = letters("where $I_1$ is the moment of inertia and $L$ is the angular momentum.")
    assert "I₁  a number (kg m²); line 1: the moment of inertia" in told
    assert "L   a number, a vector where × stands (J s); line 1: the angular momentum" in told
    assert "the Lagrangian, or the size of an angular momentum?" in letters("Some words.")


def read_with(text):
    path_habits = Habits(said=spoken(text, OWN))
    return [
        line
        for each in formulas(text)
        if each.display
        for line in read(each.text, OWN, path_habits)
    ]


@pytest.mark.parametrize(
    ("words", "kind", "unit"),
    [
        ("mit der Masse $m$", "mass", "kg"),
        ("wobei $m$ das Trägheitsmoment um die Achse ist", "moment of inertia", "kg m²"),
        ("Der Drehimpuls $m$ bleibt", "angular momentum", "J s"),
        ("the centre of mass $m$", "position", "m"),
        ("where $m$ is the potential energy of", "potential", "J"),
    ],
)
def test_the_kind_decides_the_unit(words, kind, unit):
    [found] = spoken(words, OWN).values()
    assert (found.kind, found.role.rpartition("(")[2]) == (kind, f"{unit})")


@pytest.mark.parametrize(
    ("words", "formula", "problem"),
    [
        # words make vectors where × stands and nothing is in bold type
        ("the angular momentum $L$, the position $r$ and the momentum $p$", "L = r\\times p", ""),
        ("the position $r$", "L = r\\times p", "× between a vector and a scalar"),
        ("the mass $r$ and the mass $p$", "L = r\\times p", "× between a scalar and a scalar"),
        ("the momentum $p$", "p = 3\\times 10^4", ""),
        ("the momentum $p$", "\\vec L = p\\times\\vec r", "× between a scalar and a vector"),
        # brackets behind a mass hold a factor, behind a potential what it is a function of
        ("of length $F$", "x = F(a + b)", ""),
        ("some words", "x = F(a + b)", "F of what stands in brackets, or times it?"),
        ("the force $F$", "x = F(a + b)", "F of what stands in brackets, or times it?"),
        ("at frequency $F$", "x = F(t + b)", "F of what stands in brackets, or times it?"),
    ],
)
def test_the_kind_decides_how_a_letter_is_read(words, formula, problem):
    [line] = read_with(f"{words}.\n\n$${formula}$$")
    assert line.problem == problem


def test_a_potential_is_a_function_and_a_length_is_none():
    [potential] = read_with("the potential energy $U$.\n\n$$x = U(a + b)$$")
    assert potential.equation.sides[1].func is At
    [length] = read_with("a rod of length $U$.\n\n$$x = U(a + b)$$")
    assert isinstance(length.equation.sides[1], Mul)
