"""The picture of the page, drawn and looked at: these tests alone need the pixels."""

from __future__ import annotations

import io
import math

import numpy as np
import pytest
from PIL import Image

from rigidtop.web.presets import SPIN, TILT, TOP

pytest.importorskip("selenium", reason="selenium is missing")
from selenium.webdriver import ActionChains

from .test_browser import HEAVY, NAMES, STILL


@pytest.fixture(autouse=True, scope="module")
def painted(browser):
    with browser.painting():
        yield


def picture(live, selector="#scene canvas"):
    """What stands there now; the letters in it and the map in its corner are no part of it."""
    live.js(
        "document.querySelectorAll('#scene > [aria-hidden], #corner').forEach((x) =>"
        " { x.style.visibility = 'hidden'; })"
    )
    return Image.open(io.BytesIO(live.find(selector).screenshot_as_png)).convert("RGB")


def settled(live):
    """The picture as soon as nothing in it moves any more: what is to come is drawn."""
    last = []

    def still():
        last.append(picture(live))
        return len(last) > 3 and last[-1] == last[-2] == last[-3]

    live.wait(still)
    return last[-1]


def turned(one, other):
    """Whether two pictures differ by more than their sharpness, which follows the machine."""
    return np.abs(np.asarray(one, float) - np.asarray(other, float)).mean() > 3


@pytest.mark.parametrize(("kind", "name"), NAMES)
def test_each_preset_has_its_picture(live, kind, name):
    """The body, its arrows and the sphere, smooth at the edges, on an empty ground."""
    live.show(kind, f"{STILL}&preset={name}")
    pixels = np.asarray(picture(live), dtype=int).reshape(-1, 3) @ (65536, 256, 1)
    counts = np.unique(pixels, return_counts=True)[1]
    assert len(counts) > 100
    assert 0.2 < counts.max() / len(pixels) < 0.99


APART = """
const done = arguments[0];
Promise.all(["ghost", "motion", "facts"].map((name) => import(`rigidtop/${name}.js`)))
  .then(([{ apart, ghostValues }, { createMotion }, { factsOf }]) => {
    const { motion } = rigidtop;
    const { tableau } = JSON.parse(document.getElementById("data").textContent);
    const values = ghostValues("other", motion.setup.values, factsOf(motion));
    const ghost = createMotion({ ...motion.setup, values }, tableau, motion.timescale);
    motion.go(3), ghost.go(3);
    const same = ghost.trail.every(({ t }, k) => t === motion.trail[k].t);
    done([values.phi_dot, apart("heavy-top")(motion.now, ghost.now), same]);
  });
"""


def test_the_ghost_has_one_setting_changed(live):
    live.open(HEAVY, "#preset=slow&play=0")
    alone = settled(live)
    live.open(HEAVY, "#preset=slow&play=0&ghost=other&plot=energy")
    live.wait(lambda: np.abs(np.asarray(picture(live), float) - alone).max() > 100)
    rate, apart, same = live.driver.execute_async_script(APART)
    slow, fast = TOP.steady_precession(TILT, SPIN)
    assert rate == pytest.approx(fast, rel=1e-12)
    tips = [TOP.motion(theta=TILT, phi_dot=r, omega3=SPIN).exact([3.0]).e3[0] for r in (slow, fast)]
    assert math.cos(apart) == pytest.approx(tips[0] @ tips[1], abs=1e-9)
    assert same
    pick = "[...document.querySelectorAll('.pick select')].map((x) => x.value)"
    assert live.js(pick) == ["energy", "other"]
    live.show(HEAVY, "#preset=sleeping&theta=20deg&omega3=1&play=0&ghost=other")
    assert "this top has no steady precession" in live.find("#notice").text
    live.show(HEAVY, "#ghost=nobody&plot=__proto__&play=0")
    assert "ghost=nobody, which is none of" in live.find("#notice").text


def test_a_mouse_turns_the_view(live):
    live.show(HEAVY, STILL)
    before = settled(live)
    chain = ActionChains(live.driver, duration=0)
    chain.click_and_hold(live.find("#scene canvas")).move_by_offset(60, 20).release().perform()
    live.wait(lambda: turned(picture(live), before))
