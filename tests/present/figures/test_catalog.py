"""Every figure: it comes out the same each time, shows its parameters, and says what it shows."""

import sys
from xml.etree import ElementTree

import pytest

from rigidtop.errors import RigidtopError
from rigidtop.present.figures.catalog import FIGURES, named
from rigidtop.present.figures.drawing import rendered
from rigidtop.present.figures.style import COLUMN, WIDE

every_figure = pytest.mark.parametrize("drawing", FIGURES, ids=lambda drawing: drawing.name)


@pytest.fixture(scope="module")
def as_it_is():
    """Each figure as it is without any setting, as SVG."""
    return {drawing.name: rendered(drawing, "svg") for drawing in FIGURES}


def test_names_are_unique():
    assert len({drawing.name for drawing in FIGURES}) == len(FIGURES)


def test_named():
    for drawing in FIGURES:
        assert named(drawing.name) is drawing
    with pytest.raises(RigidtopError, match=r"no figure 'cone'; did you mean .*cones"):
        named("cone")
    with pytest.raises(RigidtopError, match=r"no figure 'xyzzy'; there are .*cones"):
        named("xyzzy")


@every_figure
def test_svg_is_well_formed_and_the_same_each_time(drawing, as_it_is):
    made = as_it_is[drawing.name]
    assert made == rendered(drawing, "svg")
    assert b"<metadata" not in made
    root = ElementTree.fromstring(made)
    assert root.tag.endswith("svg")
    assert b"font-family" not in made  # letters are paths, no font is asked for
    width = float(root.get("width").removesuffix("pt")) / 72
    assert width == pytest.approx(COLUMN, abs=0.01) or width == pytest.approx(WIDE, abs=0.01)


@pytest.mark.parametrize("kind", ["pdf", "png"])
def test_other_kinds_are_the_same_each_time(kind):
    drawing = named("precession-rates")
    assert rendered(drawing, kind) == rendered(drawing, kind)


def test_pyplot_is_not_touched():
    assert (
        "matplotlib.pyplot" not in sys.modules or not sys.modules["matplotlib.pyplot"].get_fignums()
    )


@pytest.mark.parametrize(
    ("drawing", "parameter"),
    [(drawing, parameter) for drawing in FIGURES for parameter in drawing.parameters],
    ids=lambda each: each.name,
)
def test_every_parameter_changes_the_picture(drawing, parameter, as_it_is):
    changed = 0.97 * parameter.default or 0.3
    assert rendered(drawing, "svg", {parameter.name: changed}) != as_it_is[drawing.name]
