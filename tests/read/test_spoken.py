"""What a file says of its letters is said with them, and nothing that it does not say."""

import pytest

from rigidtop.commands.read import run
from rigidtop.notation import OWN
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
    "$o$ is the position of the center of mass.": ("the position of the center of mass", "length"),
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
    assert "I₁  a number; line 1: the moment of inertia" in told
    assert "L   a number; line 1: the angular momentum" in told
    assert "the Lagrangian, or the size of an angular momentum?" in letters("Some words.")
