"""No letter stands for two things on a page, in any notation: in formulas, words or figures."""

import re
import unicodedata
from collections import defaultdict

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

from rigidtop.derivations.exercises import EXERCISES
from rigidtop.figures.catalog import FIGURES
from rigidtop.figures.catalog import named as figure
from rigidtop.notation import BUILT_IN, named
from rigidtop.report import plain
from rigidtop.report.claims import claim_blocks
from rigidtop.report.lecture import picture, solution_in
from rigidtop.report.solutions import blocks, solved
from rigidtop.report.symbols import symbols_used
from rigidtop.report.wording import Wording
from rigidtop.theory.lettered import stands_for
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset.text import letter

NOTATIONS = [named(name) for name in BUILT_IN if name != "notes"]


def origins(monkeypatch, notation):
    """For each letter that words get, the letters of the notes in whose place it stands."""
    found = defaultdict(set)
    other = Wording._other

    def noted(self, old, primes, alone):
        made = other(self, old, primes, alone)
        plain = re.fullmatch(r"\(?(?:½π \+ |−)?(.*?)(?: − ½π)?\)?", made)[1]
        found[unicodedata.normalize("NFC", plain)].add(old + primes)
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


@pytest.mark.parametrize("figure", FIGURES, ids=lambda figure: figure.name)
def test_captions_and_names_in_figures(figure, monkeypatch):
    values = figure.values()
    canvas = figure.draw(**values)
    renderer = FigureCanvasAgg(canvas).get_renderer()
    names = {name: name.get_text() for name in canvas.findobj(Text)}
    for notation in NOTATIONS:
        found, wording = origins(monkeypatch, notation), Wording(notation)
        caption = wording.drawing(figure).caption(**values)
        assert ambiguous(found) == {}
        monkeypatch.undo()
        assert not {old for old in gone(notation) if old in caption}
        made = {name: wording.label(words) for name, words in names.items()}
        for old, tex in (("λ₁", r"\lambda"), ("ω₃", r"\omega"), ("MgR", "MgR")):
            assert old not in gone(notation) or tex not in " ".join(made.values())
        for name, words in made.items():
            name.set_text(words)
            name.get_window_extent(renderer)  # Matplotlib knows the letters


def test_a_figure_is_drawn_with_these_names():
    figure, wording = FIGURES[0], Wording(named("landau"))
    of_notes, of_landau = (
        [name.get_text() for name in drawing.draw(**figure.values()).findobj(Text)]
        for drawing in (figure, wording.drawing(figure))
    )
    assert of_landau == [wording.label(words) for words in of_notes] != of_notes


def test_names_in_figures_are_other_letters():
    label = Wording(named("landau")).label
    assert label(r"$\mathbf{N}$ in N") == r"$\mathbf{K}$ in N"
    assert label(r"$\omega_k$, $\Omega_s$") == r"$\Omega_{k}$, $\Omega_{s}$"
    assert label(r"$\mathbf{R}_\mathrm{CM}$") == r"$\mathbf{R}_\mathrm{CM}$"
    assert label("M of N") == "M of N"
    assert Wording(named("goldstein")).label(r"${p_\psi}^2$") == r"${p_{\psi}}^2$"
    assert Wording(named("goldstein")).label(r"$\dot\phi$ by $\phi$ to $R\phi$") == (
        r"$\dot{\phi}$ by $\phi$ to $l (\phi-\pi/2)$"
    )


def test_an_eigenvalue_is_no_tensor_of_inertia():
    words = Wording(named("goldstein"))
    assert words("$(λ − λ′) 𝐮·𝐯$, and $Lᵢ = λᵢωᵢ$") == "$(λ − λ′) 𝐮·𝐯$, and $Lᵢ = Iᵢωᵢ$"
    assert words("$ṘRᵀ$ of $R = Rz(φ)$") == "$ṘRᵀ$ of $R = Rz(φ − ½π)$"
    assert (
        words("$sin φ$ is 3 N m, at $R$ (N m), 2 kg $m²$")
        == "$sin (φ − ½π)$ is 3 N m, at $l$ (N m), 2 kg $m²$"
    )
    landau = Wording(named("landau"))
    assert landau("$R$ in m, $N$ (N m), 5 N/m³") == "$l$ in m, $K$ (N m), 5 N/m³"
    assert landau("along $𝐋̇$ and $𝛚$") == "along $𝐌̇$ and $𝛀$"


def test_the_notes_stay_as_they_are(judgements):
    words = Wording(named("notes"))
    each = judgements["3.52"]
    assert words.of(each) is each
    assert words.drawing(FIGURES[0]) is FIGURES[0]
    assert words("λ₁") == "λ₁"


def test_euler_angles_are_drawn_in_the_sequence_of_the_notation():
    drawing = Wording(named("goldstein")).drawing(figure("euler-angles"))
    titles = [axes.get_title() for axes in drawing.draw(**drawing.values()).axes]
    assert titles == [
        r"(i)  $\phi$ about $\hat{\mathbf{z}}$",
        r"(ii)  $\theta$ about $\mathbf{e}_{1}'$",
        r"(iii)  $\psi$ about $\mathbf{e}_{3}$",
    ]
    assert drawing.caption(phi=0.0, theta=0.0, psi=0.0).startswith(
        "Euler's angles $φ$, $θ$ and $ψ$, here 0°, 0° and 0°:"
    )
