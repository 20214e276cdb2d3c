"""What a notebook shows: formulas, claims, exercises, pictures, sliders."""

from __future__ import annotations

import builtins
from io import BytesIO

import pytest
import sympy
from IPython.core.formatters import DisplayFormatter
from PIL import Image

from rigidtop.derivations.exercises import EXERCISES
from rigidtop.derivations.rotation_matrices import euler_angle_matrix
from rigidtop.errors import NoSteadyPrecession, RigidtopError
from rigidtop.motion.top import HeavyTop
from rigidtop.proof.equation import Equation
from rigidtop.proof.verdict import judge
from rigidtop.report import notebook
from rigidtop.report.markdown import markdown
from rigidtop.report.solutions import solved
from rigidtop.theory.symbols import (
    VOCABULARY,
    lambda1,
    phidot,
    theta,
)


@pytest.fixture(scope="module")
def shown():
    formatter = DisplayFormatter()
    notebook.enable(formatter)
    return lambda thing: formatter.format(thing)[0]


def test_equations_are_aligned_with_their_tags(shown):
    first = Equation(phidot, lambda1, tag="3.45")
    second = Equation(theta, 2 * lambda1)
    made = shown([first, second])["text/latex"]
    assert made.count("&=") == 2
    assert r"&& \text{(3.45)} \\" in made
    assert made.startswith(r"$\displaystyle \begin{aligned}")
    assert shown(first)["text/plain"] == "φ̇ = λ₁  (3.45)"
    assert shown({phidot: lambda1})["text/latex"] == notebook.typeset(Equation(phidot, lambda1))


def test_what_the_layout_does_not_know_keeps_the_letters():
    integral = sympy.Integral(phidot, theta)
    assert notebook.typeset(integral) == r"$\displaystyle \int \dot{\phi}\, d\theta$"
    assert r"\dot{\phi}" in notebook.typeset(Equation(phidot, integral))
    for symbol in VOCABULARY:
        assert notebook.typeset(sympy.Integral(symbol, theta))


@pytest.mark.parametrize("other", [[1, 2], (), [], {}, {"a": 1}, ("x", lambda1)])
def test_other_sequences_are_left_alone(shown, other):
    assert "text/latex" not in shown(other)


def test_a_claim_shows_its_verdict(shown):
    made = shown(euler_angle_matrix)
    assert "**(3.47)** — **⇄ convention**" in made["text/markdown"]
    assert "Corrected form" in made["text/markdown"]
    assert "(3.47)  [convention]" in made["text/plain"]
    assert made == shown(judge(euler_angle_matrix))


def test_every_claim_can_be_shown(judgements):
    for judged in judgements.values():
        made = markdown(notebook.shown_blocks(judged))
        assert made.count("$$") % 2 == 0
        assert made.replace("$$", "").count("$") % 2 == 0
        assert "<math" not in made  # a page that is not trusted would lose it


def test_every_exercise_can_be_shown():
    for exercise in EXERCISES:
        made = markdown(notebook.shown_blocks(exercise))
        assert exercise.title[:6] in made
        assert "Solution" not in made


def test_a_solution_has_no_digits_of_this_machine(shown):
    [exercise] = [e for e in EXERCISES if e.name == "toppling-top"]
    made = shown(solved(exercise))["text/markdown"]
    assert "**Solution in numbers**" in made
    assert ["| ", " until θ has the value “until” |"][0] in made
    assert all(measure.what not in made for measure in solved(exercise).measures)


def test_the_lines_of_the_lecture_as_derive_prints_them(shown):
    made = shown(notebook.steps("3.54"))["text/markdown"]
    assert "Substitute both into Lagrange's equation for $\\theta$:" in made
    assert made.count("$$") == 8
    with pytest.raises(RigidtopError, match=r"^no lines of the lecture lead to '3\.99'$"):
        notebook.steps("3.99")


def test_a_solution_by_its_name(shown):
    made = shown(notebook.solution("toppling-top", theta=0.3))["text/markdown"]
    assert "$0.3$ | rad" in made
    assert "The engine's own" not in made
    with pytest.raises(RigidtopError, match=r"no exercise 'toppling'; there are .*toppling-top"):
        notebook.solution("toppling")
    with pytest.raises(RigidtopError, match="no parameter"):
        notebook.solution("toppling-top", spin=1.0)


# --- Pictures and sliders ------------------------------------------------------------------------


def opened(picture):
    return Image.open(BytesIO(picture.png))


def test_a_plot_is_shown_at_the_end_of_the_block(monkeypatch):
    seen = []
    monkeypatch.setattr(notebook, "_display", seen.append)
    with notebook.plot("a line", 4.0, 2.0, columns=2) as (left, right):
        left.plot([0, 1], [0, 1])
        right.plot([0, 1], [1, 0])
        assert seen == []
    [picture] = seen
    data, beside = picture._repr_mimebundle_()
    assert data["text/plain"] == "a line"
    assert beside["image/png"]["width"] == 384
    image = opened(picture)
    assert image.size == (4 * notebook.DOTS, 2 * notebook.DOTS)
    assert image.convert("RGB").getpixel((0, 0)) == (255, 255, 255)
    assert len(picture.png) < 30_000


def test_pictures_are_the_same_each_time():
    first, second = (notebook.figure("paths", omega3=35.0) for _ in range(2))
    assert first == second
    assert r"$\omega_3 = 35$ rad/s" in first.words


def test_a_wrong_figure_is_an_error_of_one_line():
    with pytest.raises(RigidtopError, match="did you mean"):
        notebook.figure("path")
    with pytest.raises(RigidtopError, match="no parameter"):
        notebook.figure("paths", spin=1.0)


def rates(axes, omega3):
    top = HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5, g=8.0)
    axes.bar([0, 1], top.steady_precession(0.0, omega3))


def test_sliders_move_the_picture():
    made = notebook.sliders(rates, "two bars", width=3.0, height=2.0, omega3=(1.0, 10.0, 20.0))
    box = made.widget()
    slider, says, image = box.children
    assert (slider.min, slider.value, slider.max) == (1.0, 10.0, 20.0)
    assert slider.description == "ω₃ (rad/s)"
    before = image.value
    assert before == made.picture({"omega3": 10.0}).png
    slider.value = 15.0
    assert image.value == made.picture({"omega3": 15.0}).png != before
    assert says.value == ""
    last = image.value
    slider.value = 2.0  # there is no such precession: it is said, and the picture stays
    assert says.value.startswith("no steady precession")
    assert image.value == last
    slider.value = 10.0
    assert says.value == ""
    with pytest.raises(NoSteadyPrecession):
        made.picture({"omega3": 2.0})


def test_sliders_without_a_kernel_are_a_picture():
    made = notebook.sliders(rates, "two bars", omega3=(1.0, 10.0, 20.0))
    data, _ = made._repr_mimebundle_()
    assert set(data) == {"image/png", "text/plain", notebook.WIDGET}
    assert data["text/plain"] == "two bars"


def test_without_a_notebook():
    with pytest.raises(RigidtopError, match="no running IPython"):
        notebook.enable()


@pytest.mark.parametrize("call", [notebook.enable, lambda: notebook._display(1)])
def test_without_jupyter(monkeypatch, call):
    real = builtins.__import__

    def without(name, *args, **kwargs):
        if name.split(".")[0] in ("IPython", "ipywidgets"):
            raise ImportError(name)
        return real(name, *args, **kwargs)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(RigidtopError, match=r"pip install 'rigidtop\[notebook\]'"):
        call()
    with pytest.raises(RigidtopError, match="pip install"):
        notebook.sliders(rates, "", omega3=(1.0, 10.0, 20.0)).widget()


def test_a_verdict_is_asked_for_by_the_name_of_its_claim():
    assert notebook.verdict("3.47") is euler_angle_matrix
    with pytest.raises(RigidtopError, match="no claim of the lecture is called 'no-such'"):
        notebook.verdict("no-such")
