"""No letter stands for two things on a page, in any notation: in formulas, words or figures."""

import re
from collections import defaultdict

import pytest

from rigidtop.derivations.exercises import EXERCISES
from rigidtop.figures.catalog import FIGURES
from rigidtop.notation import named
from rigidtop.report import plain
from rigidtop.report.claims import claim_blocks
from rigidtop.report.lecture import picture, solution_in
from rigidtop.report.solutions import blocks, solved
from rigidtop.report.symbols import symbols_used
from rigidtop.report.wording import Wording
from rigidtop.theory.lettered import stands_for
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset.text import letter
from rigidtop.typeset.words import characters

NOTATIONS = [named("goldstein"), named("landau")]
"""One with other axes, and one with other letters alone."""


def origins(monkeypatch, notation):
    """For each letter that words get, the letters of the notes in whose place it stands."""
    found = defaultdict(set)
    other = Wording._other

    def noted(self, old, primes, alone):
        made = other(self, old, primes, alone)
        plain = re.fullmatch(r"\(?(?:½π \+ |−)?(.*?)(?: − ½π)?\)?", characters(made))[1]
        found[plain].add(characters(old + primes))
        return made

    monkeypatch.setattr(Wording, "_other", noted)
    return found


def of_symbols(found, symbols):
    for symbol in symbols:
        origin = stands_for(symbol)
        if origin in VOCABULARY and (origin is not symbol or symbol in VOCABULARY):
            shown = getattr(symbol, "quantity", None) or VOCABULARY[symbol]
            found[letter(shown.glyph)].add(letter(VOCABULARY[origin].glyph))


# The letters that change places where the line of nodes is e₁′ stand for the same role.
ROLES = {"e₁′": "e₂′", "ω₁′": "ω₂′", "s_φ": "c_φ", "s_ψ": "c_ψ"}


def ambiguous(found):
    roles = {at: {ROLES.get(old, old) for old in olds} for at, olds in found.items()}
    return {at: olds for at, olds in roles.items() if len(olds) > 1}


def gone(notation):
    """Letters of the notes that the notation has for nothing; MgR where it has another R."""
    printed = {letter(glyph) for glyph in notation.glyphs.values()}
    olds = {letter(VOCABULARY[x].glyph) for x in notation.images} - printed
    return {x for x in olds if not x.isascii()} | ({"MgR"} if "R" in olds else set())


def of_the_notes_alone(shown, notation):
    """What is shown in letters that the notation does not have."""
    words = re.sub("MgR[₁₂₃]|ω_n²?", "", plain.fragment(shown))  # the tables have no other
    return {old for old in gone(notation) if old in words}


@pytest.fixture(scope="module")
def solutions(judgements):
    """Without their derivations, which have letters of their own."""
    return [solved(exercise, judged=judgements) for exercise in EXERCISES]


@pytest.mark.parametrize("notation", NOTATIONS, ids=lambda notation: notation.name)
def test_no_claim_has_a_letter_for_two_things_or_of_the_notes_alone(
    judgements, notation, monkeypatch
):
    for judgement in judgements.values():
        found = origins(monkeypatch, notation)
        made = claim_blocks(Wording(notation).judgement(judgement))
        of_symbols(found, symbols_used(made))
        assert ambiguous(found) == {}, judgement.claim.name
        monkeypatch.undo()
        assert of_the_notes_alone(made, notation) == set(), judgement.claim.name


@pytest.mark.parametrize("notation", NOTATIONS, ids=lambda notation: notation.name)
def test_no_exercise_has_a_letter_for_two_things_or_of_the_notes_alone(
    solutions, notation, monkeypatch
):
    for each in solutions:
        found = origins(monkeypatch, notation)
        solution = solution_in(notation, each)
        drawn = picture(solution, notation)
        if drawn is not None:
            drawn.described(1)
        made = blocks(solution, notation=notation)
        of_symbols(found, symbols_used(made))
        assert found
        assert ambiguous(found) == {}, solution.exercise.name
        monkeypatch.undo()
        assert of_the_notes_alone(made, notation) == set(), solution.exercise.name


def test_the_notes_stay_as_they_are(judgements):
    words = Wording(named("notes"))
    each = judgements["3.52"]
    assert words.of(each) is each
    assert words.drawing(FIGURES[0]) is FIGURES[0]
    assert words("λ₁") == "λ₁"
