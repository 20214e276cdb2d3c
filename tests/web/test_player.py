"""Figures of motions played in place, as in the lecture."""

from __future__ import annotations

import gzip
import json
import re
from base64 import b64decode
from xml.etree import ElementTree

import numpy as np
import pytest

from rigidtop.figures.catalog import FIGURES
from rigidtop.figures.drawing import both
from rigidtop.report import html
from rigidtop.report.lecture import PlacedFigure
from rigidtop.web.player import player
from rigidtop.web.setup import body_of, setup_of

PICTURES = [PlacedFigure(each.name, each, {}) for each in FIGURES if each.motions]


@pytest.fixture(scope="module")
def made():
    return player({each.name: each.motions() for each in PICTURES})


def read(made, name):
    return json.loads(re.search(rf'<script[^>]* id="{name}">(.*?)</script>', made, re.DOTALL)[1])


def test_a_body_has_no_style(made):
    assert "<style" not in made
    assert "\\u003cstyle" in made


def test_every_motion_of_a_figure_is_one_of_the_page(made):
    shown = read(made, "live-motions")
    assert set(shown) == {each.name for each in PICTURES}
    pages = {kind: read(made, f"live-{kind}") for kind in ("free", "heavy-top")}
    for each in PICTURES:
        motions = each.motions()
        assert len({words for *_, words in shown[each.name]}) == len(motions)
        for (kind, name, words), motion in zip(shown[each.name], motions, strict=True):
            (preset,) = [p for p in pages[kind]["presets"] if p["name"] == name]
            setup = setup_of(motion)
            assert preset["setup"]["values"] == pytest.approx(dict(setup.values), rel=1e-12)
            assert body_of(setup).moments == motion.body.moments
            assert words.startswith("Play" if len(motions) == 1 else motion.regime.capitalize())
    for found in pages.values():
        for slider in found["parameters"]:
            values = [p["setup"]["values"][slider["name"]] for p in found["presets"]]
            assert slider["least"] <= min(values) <= max(values) <= slider["most"]


def test_it_is_markup_of_its_own_and_one_page(made):
    ElementTree.fromstring(f"<body>{made}</body>")
    packed = re.search(r'id="live-page">(.*?)</script>', made)[1]
    page = gzip.decompress(b64decode(packed)).decode()
    assert page.count("{{data}}") == 1
    assert len(made) < 450_000
    assert player({"two-masses": ()}) == ""


def lecture_of(made, *names):
    figures = "".join(
        html._figure(each.described(1), {each.name: both(each.drawing)[1].decode()})
        for each in PICTURES
        if each.name in names
    )
    return f'<!DOCTYPE html><meta charset="utf-8"><title>Lecture</title>{figures}{made}'


def test_what_a_page_opens_with_moves_unasked(live, wishes, made):
    page = lecture_of(made, "paths").replace('id="figure-paths"', 'id="figure-opening"')
    live.write("opening", page)
    live.open("opening", ready="")
    live.wait("document.querySelector('iframe')")
    assert not live.find("#figure-opening svg").is_displayed()
    live.driver.switch_to.frame(live.find("iframe"))
    live.wait("window.rigidtop && rigidtop.motion.now.t > 0")
    wishes(prefers_reduced_motion="reduce")
    live.open("opening", ready="")
    live.wait("document.querySelector('iframe')")
    live.driver.switch_to.frame(live.find("iframe"))
    live.wait("window.rigidtop && rigidtop.frames > 1")
    assert live.t == 0
    # On paper it is the still.
    live.driver.switch_to.default_content()
    live.cdp("Emulation.setEmulatedMedia", media="print")
    assert live.find("#figure-opening svg").is_displayed()
    assert not live.find("iframe").is_displayed()
    live.cdp("Emulation.setEmulatedMedia", media="")


def test_a_figure_is_played_in_its_place(live, made):
    live.write("lecture", lecture_of(made, "paths", "flip"))
    live.open("lecture", ready="")
    bars = [[b.text for b in bar.find_elements("css selector", "button") if b.is_displayed()]
            for bar in live.all(".live-bar")]  # fmt: skip
    assert bars == [["▶ Play"], ["▶ Waves", "▶ Cusps", "▶ Loops"]]
    assert not live.all("iframe")
    for name, number in (("flip", 0), ("paths", 2)):
        picture = next(each for each in PICTURES if each.name == name)
        live.js(
            f"""document.querySelectorAll('[data-figure="{name}"] .live-bar button')"""
            f"[{number}].click()"
        )
        live.wait("document.querySelector('iframe')")
        assert len(live.all("iframe")) == 1
        assert not live.find(f'[data-figure="{name}"] svg').is_displayed()
        live.driver.switch_to.frame(live.find("iframe"))
        live.wait("window.rigidtop && rigidtop.motion.now.t > 0")
        assert live.find("#start").is_displayed()
        assert live.find(".verdict").is_displayed()
        assert not live.find("#plots").is_displayed()
        assert not live.find("#notice").is_displayed()
        t, e3 = live.js("[rigidtop.motion.now.t, [...rigidtop.motion.now.e3]]")
        expected = picture.motions()[number].exact([t]).e3[0]
        assert e3 == pytest.approx(np.asarray(expected), abs=1e-8)
        # What a slider sets is in the picture, in the sentence and beside the equation.
        slider, set_to = ("omega2", 3.0) if name == "flip" else ("omega3", 14.0)
        said = live.find(".verdict").text
        live.js(
            "(document.querySelector(arguments[0]).value = arguments[1],"
            " document.querySelector(arguments[0]).dispatchEvent(new Event('change')))",
            f"#number-{slider}",
            str(set_to),
        )
        live.wait("rigidtop.motion.setup.values[arguments[0]] === arguments[1]", slider, set_to)
        assert live.find(".verdict").text != said
        assert live.find("#equations [data-term]").is_displayed()
        verdict = live.find(".verdict").text
        live.driver.switch_to.default_content()
        # And in the caption, whose printed numbers are those of another motion.
        caption = f'[data-figure="{name}"] figcaption'
        letter, printed = ("ω₂", "about the middle axis") if name == "flip" else ("ω₃", "path of")
        now = live.wait(
            lambda place=caption, words=f"{letter} = {set_to:g} rad/s": words
            in live.find(place).text and live.find(place).text)  # fmt: skip
        assert now.endswith(verdict)
        assert printed not in now
    live.js("""document.querySelector('[data-figure="paths"] .live-bar button:nth-child(4)')"""
            ".click()")  # fmt: skip
    assert not live.all("iframe")
    assert live.find('[data-figure="paths"] svg').is_displayed()
    for name in ("flip", "paths"):
        assert "changed" not in live.find(f'[data-figure="{name}"] figcaption').text
    assert "path of" in live.find('[data-figure="paths"] figcaption').text
