"""Every figure: it comes out the same each time, shows its parameters, and says what it shows."""

import sys

import matplotlib
import pytest

from rigidtop.errors import RigidtopError
from rigidtop.figures import friction, nutation
from rigidtop.figures.catalog import FIGURES, named
from rigidtop.figures.drawing import rendered
from rigidtop.figures.style import STYLE
from rigidtop.report import tex_lines

every_figure = pytest.mark.parametrize("drawing", FIGURES, ids=lambda drawing: drawing.name)


def test_names_are_unique():
    assert len({drawing.name for drawing in FIGURES}) == len(FIGURES)


def test_named():
    for drawing in FIGURES:
        assert named(drawing.name) is drawing
    with pytest.raises(RigidtopError, match=r"no figure 'cone'; did you mean .*cones"):
        named("cone")
    with pytest.raises(RigidtopError, match=r"no figure 'xyzzy'; there are .*cones"):
        named("xyzzy")


@pytest.mark.parametrize("kind", ["svg", "pdf", "png"])
def test_files_are_the_same_each_time(kind):
    drawing = named("precession-rates")
    assert rendered(drawing, kind) == rendered(drawing, kind)


def test_pyplot_is_not_touched():
    assert (
        "matplotlib.pyplot" not in sys.modules or not sys.modules["matplotlib.pyplot"].get_fignums()
    )


def content(drawing, given):
    """What is drawn: lines, areas, words, and the frame around them."""
    with matplotlib.rc_context(STYLE):
        canvas = drawing.draw(**drawing.values(given))
    found = []
    for axes in canvas.axes:
        found += [axes.get_title(), *axes.get_xlim(), *axes.get_ylim()]
        found += [(line.get_xydata().tobytes(), line.get_markersize()) for line in axes.lines]
        found += [patch.get_path().vertices.tobytes() for patch in axes.patches]
        found += [(text.get_text(), *text.xy) for text in axes.texts]
        for area in axes.collections:
            found += [path.vertices.tobytes() for path in area.get_paths()]
    return found


@every_figure
def test_every_parameter_changes_the_picture_and_its_caption(drawing):
    """It is the same each time, a caption is typeset, words for the ear are ASCII."""
    values = drawing.values()
    picture, caption = content(drawing, {}), drawing.caption(**values)
    assert picture == content(drawing, {})
    words = drawing.alternative(**values)
    assert tex_lines.rich((caption,))
    assert words.isascii()
    assert len(words) > 80
    of_the_frame = ("omega3", "phi_dot") if drawing.name == "regimes" else ()
    # Arrows have directions, and what these make only larger stands in the caption.
    larger = {"two-masses": ("omega",), "leaning-cone": ("density", "g")}.get(drawing.name, ())
    for parameter in drawing.parameters:
        given = {parameter.name: 0.97 * parameter.default or 0.3}
        assert (content(drawing, given) != picture) == (parameter.name not in larger), parameter
        if parameter.name not in of_the_frame:
            assert drawing.caption(**drawing.values(given)) != caption, parameter.name


@pytest.fixture
def cheap(monkeypatch):
    """Shorter motions and coarser maps."""
    monkeypatch.setattr(friction, "MOST_TURNS", 60)
    monkeypatch.setattr(nutation, "COUNTS", (61, 51))
    friction._risen.cache_clear()
    friction._woken.cache_clear()
    yield
    friction._risen.cache_clear()
    friction._woken.cache_clear()


@every_figure
def test_what_is_legal_is_drawn_or_refused_in_one_line(drawing, cheap):
    refused = []
    for number, parameter in enumerate(drawing.parameters):
        low = max(parameter.least, parameter.default / 50)
        high = min(parameter.most, 50 * parameter.default)
        # One end of each is drawn, the other told: both ways go through the same motion.
        for value, ways in ((low, number), (high, number + 1)):
            given = drawing.values({parameter.name: value})
            try:
                if ways % 2 == 0:
                    assert content(drawing, given)
                said = drawing.caption(**given) + drawing.alternative(**given)
                assert "nan" not in said.split()
            except RigidtopError as refusal:
                refused.append(str(refusal))
    assert not any("\n" in each for each in refused)
