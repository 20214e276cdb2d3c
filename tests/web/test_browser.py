"""The page in a browser, as its readers use it."""

from __future__ import annotations

import math

import numpy as np
import pytest

import rigidtop as rt
from rigidtop.web.page import page, page_of
from rigidtop.web.presets import PRESETS, SPIN, TILT, TOP
from rigidtop.web.tours import TOURS

from .conftest import page_data

pytest.importorskip("selenium", reason="selenium is missing")
from selenium.webdriver import ActionChains, Keys

NAMES = [(kind, made()[k].name) for kind, made in PRESETS.items() for k in (0, -1)]
HEAVY, FREE = PRESETS
STILL = "#play=0"


def named(name):
    """A preset, in SI units and radians."""
    return next(p for made in PRESETS.values() for p in made() if p.name == name)


def press(live, *keys):
    ActionChains(live.driver).send_keys(*keys).perform()


def shift_tab(live):
    chain = ActionChains(live.driver)
    chain.key_down(Keys.SHIFT).send_keys(Keys.TAB).key_up(Keys.SHIFT).perform()


def tab_to(live, selector, most=120):
    """Press Tab until what has the focus is that."""
    for _ in range(most):
        if live.js("document.activeElement.matches(arguments[0])", selector):
            return
        press(live, Keys.TAB)
    raise AssertionError(f"Tab never comes to {selector}")


def click(live, selector):
    """A click by script: what is tested is what the page does then, not where it has scrolled."""
    live.js("document.querySelector(arguments[0]).click()", selector)


def button(label):
    return f'#transport button[aria-label="{label}"]'


@pytest.mark.parametrize(("kind", "name"), NAMES)
def test_a_preset_opens_by_its_address_and_plays(live, kind, name):
    # One is opened anew, the others by their addresses put into the page that stands.
    (live.open if name == PRESETS[kind]()[0].name else live.show)(kind, f"#preset={name}")
    live.wait("rigidtop.motion.now.t > 0.2")
    preset = named(name)
    assert live.values == pytest.approx(dict(preset.setup.values), rel=1e-15)
    assert live.js("document.querySelector('[name=preset]:checked').value") == name
    assert live.find(".about").text == preset.about
    assert len(live.find(".verdict").text) > 20
    meters = live.all("[role=meter]")
    assert len(meters) == (3 if kind == HEAVY else 2)
    for meter in meters:
        assert meter.text.endswith(("held", "exact"))
        assert -16 <= float(meter.get_attribute("aria-valuenow")) < -9
    assert live.js("rigidtop.motion.drift().every((drift) => drift.most < 1e-9)")


def test_an_arrow_key_on_a_slider_starts_another_motion(live):
    live.show(HEAVY, "#preset=cusps&t=1&play=0")
    live.wait("rigidtop.motion.now.t === 1")
    before, said = live.values, live.find(".verdict").text
    live.find("#slider-omega3").send_keys(Keys.ARROW_LEFT * 3)
    live.wait("rigidtop.motion.now.t === 0")
    after = live.values
    assert after["omega3"] < before["omega3"] - 0.1
    assert {**after, "omega3": 0} == {**before, "omega3": 0}
    assert float(live.find("#number-omega3").get_attribute("value")) == after["omega3"]
    live.find("#slider-omega3").send_keys(Keys.HOME)
    live.wait("rigidtop.motion.setup.values.omega3 === -60")
    live.find("#slider-theta").send_keys(Keys.END)
    live.wait("rigidtop.motion.setup.values.theta > 3.14")
    assert live.find(".verdict").text != said
    assert "Changed from" in live.find(".about").text
    # λ₂ goes with λ₁ until it is let go.
    live.find("#slider-lambda1").send_keys(Keys.ARROW_RIGHT)
    live.wait("rigidtop.motion.setup.values.lambda1 > 1.3")
    assert live.values["lambda2"] == live.values["lambda1"]
    click(live, "#symmetric")
    live.find("#slider-lambda2").send_keys(Keys.ARROW_RIGHT)
    live.wait("!rigidtop.motion.symmetric")


def retype(live, name, text):
    field = live.find(f"#number-{name}")
    field.send_keys(Keys.CONTROL + "a")
    field.send_keys(Keys.DELETE + text + Keys.ENTER)


BAD = {
    "abc": "is not a number", "": "is not a number", "1e999": "is not a number",
    "Infinity": "is not a number", "1,5": "is not a number", "61": "goes from",
}  # fmt: skip


def test_a_bad_number_is_named_at_its_field_and_changes_nothing(live):
    live.show(HEAVY, "#preset=cusps&t=0.5&play=0")
    live.wait("rigidtop.motion.now.t === 0.5")
    before = live.values
    field, error = live.find("#number-omega3"), live.find("#error-omega3")
    for text, says in BAD.items():
        retype(live, "omega3", text)
        assert field.get_attribute("aria-invalid") == "true", text
        assert says in error.text, text
        assert "\n" not in error.text
        assert live.all(".error:not(:empty)") == [error]
        live.drawn()
        assert (live.values, live.t) == (before, 0.5)
        # Escape takes what was typed back.
        press(live, Keys.ESCAPE)
        assert field.get_attribute("value") == "12"
        assert field.get_attribute("aria-invalid") is None
    retype(live, "omega3", "abc")
    retype(live, "omega3", "7")
    live.wait("rigidtop.motion.setup.values.omega3 === 7")
    assert field.get_attribute("aria-invalid") is None
    assert not error.text


def test_an_impossible_body_is_refused_and_the_motion_stays(live):
    live.show(HEAVY, "#preset=cusps&t=0.5&play=0")
    live.wait("rigidtop.motion.now.t === 0.5")
    before = live.values
    retype(live, "lambda3", "9")
    live.wait("document.querySelector('#error-lambda3').textContent !== ''")
    text = live.find("#error-lambda3").text
    assert "λ₁ = 1.3 kg m² is too small for λ₃ = 9 kg m²" in text
    assert "The motion shown is the last possible one." in text
    assert (live.values, live.t) == (before, 0.5)
    click(live, "#error-lambda3 button")
    assert float(live.find("#number-lambda3").get_attribute("value")) == before["lambda3"]
    assert not live.find("#error-lambda3").text
    assert live.js("document.activeElement.id") == "slider-lambda3"


def test_transport(live):
    live.show(HEAVY, "#preset=waves")
    live.wait("rigidtop.motion.now.t > 0.3")
    click(live, button("Pause"))
    live.drawn()
    t = live.t
    live.drawn()
    assert (live.t, live.js("rigidtop.playing")) == (t, False)
    click(live, button("One step on"))
    live.wait("rigidtop.motion.now.t !== arguments[0]", t)
    step = live.t - t
    assert 0 < step < 0.2
    click(live, button("One step back"))
    live.wait("rigidtop.motion.now.t < arguments[0]", t + step)
    assert live.t == pytest.approx(t, abs=1e-12)
    click(live, button("Play backwards"))
    live.wait("rigidtop.motion.now.t < arguments[0] - 0.05", t)
    # At the start there is nothing before.
    live.wait("rigidtop.motion.now.t === 0 && !rigidtop.playing")
    click(live, button("Play"))
    live.wait("rigidtop.motion.now.t > 0.6")
    click(live, button("To the start"))
    live.wait("rigidtop.motion.now.t < 0.6 && rigidtop.playing")
    click(live, button("Pause"))
    click(live, button("To the start"))
    live.wait("rigidtop.motion.now.t === 0")
    live.wait("/^t = 0[.]0+ s$/.test(document.querySelector('.clock').textContent)")


def test_the_address_brings_back_what_is_shown(live):
    live.show(HEAVY, "#preset=loops")
    live.find("#slider-omega3").send_keys(Keys.ARROW_LEFT * 2)
    retype(live, "theta", "35.5")
    click(live, "#looks [value=e1]")
    click(live, "#looks [value=trail]")
    click(live, "#looks [value=body]")
    live.wait("rigidtop.motion.now.t > 0.3")
    click(live, button("Pause"))
    live.wait("!rigidtop.playing && location.hash.includes('play=0')")
    live.drawn()
    hash, values, t = live.js(
        "[location.hash, rigidtop.motion.setup.values, rigidtop.motion.now.t]"
    )
    for part in ("preset=loops", "theta=35.5deg", "omega3=", "view=body", "layers=e1,e3"):
        assert part in hash
    looks = "[...document.querySelectorAll('#looks input:checked')].map((x) => x.value)"
    shown = live.js(looks)
    live.open(HEAVY, hash)
    live.wait("rigidtop.motion.now.t > 0")
    assert live.values == values
    assert live.t == pytest.approx(t, abs=1e-4)
    assert live.js(looks) == shown == ["e1", "e3", "body"]
    assert not live.js("rigidtop.playing")
    assert not live.find("#notice").is_displayed()
    # What the page writes before it has read an address does not take its place.
    live.js("(location.hash = '#preset=cusps&play=0', history.replaceState(null, '', '#'))")
    live.wait("document.querySelector('[value=cusps]').checked")


HOSTILE = {
    "theta=abc": "The address says theta=abc, which is not a number; 30° is used.",
    "theta=NaN": "which is not a number",
    "omega3=1e999": "which is not a number",
    "omega3=1e300": "which is out of range",
    "theta=30": "out of range (an angle is in radians, or written 30deg); 30° is used",
    "theta_dot=1e9": "which is out of range; 0 is used",
    "preset=nope": "which is none of the examples",
    "preset=%3Cimg src=x onerror=hit=1%3E": "says preset=<img src=x onerror=hit=1>, which is none",
    "%3Cimg src%3Dx onerror%3Dhit%3D1%3E=1": "names “<img src=x onerror=hit=1>”, which",
    "__proto__=1&constructor=2": "names “__proto__”, which this page does not know (and 1 more)",
    "layers=__proto__,e1": "which is none of",
    "view=toString": "which is none of",
    "t=1e300": "which is more than",
    "t=-1": "which is out of range",
    "%E0%A4%A": "which this page does not know",
    "=5": "names “”, which this page does not know",
    "omega3=+5&omega3=6": "sets omega3 twice; the first is used",
    "lambda3=9": "there is no motion as the address has it",
}


def test_a_hostile_address_gives_one_line(live):
    for number, (hash, says) in enumerate(HOSTILE.items()):
        (live.show if number else live.open)(HEAVY, f"{STILL}&{hash}")
        line = live.find("#notice span")
        assert line.is_displayed()
        assert says.casefold() in line.text.casefold()
        assert "\n" not in line.text
        assert live.js("Object.values(rigidtop.motion.setup.values).every(Number.isFinite)"), hash
        assert live.js("[...rigidtop.motion.now.q].every(Number.isFinite)"), hash
        assert live.t == 0
        assert live.js("[({}).hit, window.hit]") == [None, None]
        assert not live.all("img, #notice span *, .about *")
        click(live, "#notice button")
        assert not live.find("#notice").is_displayed()


FOCUSED = """
const at = document.activeElement;
// What is transparent lies on a label that shows its state.
const shown = getComputedStyle(at).opacity === "0" ? at.closest("label") : at;
const box = shown.getBoundingClientRect();
const { outlineStyle, outlineWidth } = getComputedStyle(shown);
const over = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
return {
  place: [...document.querySelectorAll("*")].indexOf(at), body: at === document.body,
  what: at.outerHTML.slice(0, 200),
  marked: outlineStyle !== "none" && parseFloat(outlineWidth) >= 2,
  seen: box.width > 0 && box.right > 0 && box.left < innerWidth
    && box.bottom > 0 && box.top < innerHeight,
  // By nothing that stays where it is while the page scrolls.
  covered: over && !shown.contains(over) && !over.contains(shown)
    && over.closest("#stage") && !shown.closest("#stage"),
};
"""


def test_tab_goes_round_and_shows_where_it_is(live):
    live.open(HEAVY, STILL)
    seen = []
    for _ in range(120):
        press(live, Keys.TAB)
        focused = live.driver.execute_script(FOCUSED)
        if focused["body"] or focused["place"] in seen:
            break
        assert focused["marked"], focused["what"]
        assert focused["seen"], focused["what"]
        assert not focused["covered"], focused["what"]
        assert live.driver.switch_to.active_element.accessible_name.strip(), focused["what"]
        seen.append(focused["place"])
    else:
        raise AssertionError("Tab never comes back")
    # All that can be used is on the way; of radio buttons the one that is chosen.
    wanted = live.driver.execute_script(
        "const all = [...document.querySelectorAll('*')];"
        "return all.filter((x) => x.matches('a[href], button, select, input, [tabindex=\"0\"]')"
        " && x.checkVisibility() && !x.disabled && (x.type !== 'radio' || x.checked))"
        ".map((x) => all.indexOf(x));"
    )
    assert set(wanted) <= set(seen)
    assert len(seen) > 30
    shift_tab(live)
    assert live.driver.execute_script(FOCUSED)["place"] == seen[-1]


def test_everything_by_the_keyboard_alone(live):
    live.open(HEAVY, "#preset=waves")
    tab_to(live, "select")
    press(live, Keys.ARROW_DOWN)
    live.wait("document.documentElement.dataset.theme === 'dark'")
    tab_to(live, button("Pause"))
    press(live, Keys.SPACE)
    live.wait("!rigidtop.playing")
    t = live.t
    tab_to(live, button("One step on"))
    press(live, Keys.ENTER)
    live.wait("rigidtop.motion.now.t > arguments[0]", t)
    tab_to(live, "#looks [value=e1]")
    press(live, Keys.SPACE)
    live.wait("location.hash.includes('layers=e1,e3')")
    press(live, Keys.SPACE)
    live.wait("!location.hash.includes('layers')")
    tab_to(live, "#looks [value=space]")
    press(live, Keys.ARROW_RIGHT)
    live.wait("location.hash.includes('view=body')")
    tab_to(live, "[name=preset][value=waves]")
    press(live, Keys.ARROW_RIGHT)
    live.wait("rigidtop.motion.setup.values.phi_dot === 0")
    assert live.js("document.querySelector('[name=preset]:checked').value") == "cusps"
    tab_to(live, "#slider-theta")
    theta = live.values["theta"]
    press(live, Keys.ARROW_RIGHT)
    live.wait("rigidtop.motion.setup.values.theta > arguments[0]", theta)
    for _ in range(120):
        if live.js("document.activeElement.matches(arguments[0])", button("One step on")):
            break
        shift_tab(live)
    press(live, Keys.ENTER)
    live.wait("rigidtop.motion.now.t > 0")
    assert not live.js("rigidtop.playing")


SEEN = [
    "Cusps:", "Cusps:", "Waves:", "Loops:", "Steady", "Steady", "Steady", "there is none",
    "It sleeps", "It wakes up",
]  # fmt: skip


def test_the_tour_asks_and_then_shows(live):
    live.open(HEAVY, STILL)
    press(live, "t")
    for number, (step, seen) in enumerate(zip(TOURS[HEAVY](), SEEN, strict=True), 1):
        assert live.find(".tour-place").text.startswith(f"{number} of {len(SEEN)}")
        assert live.find(".tour-question").text == step.ask
        # Nothing tells before it is asked.
        assert not any(live.find(x).is_displayed() for x in (".verdict", "#plots", ".about"))
        assert not live.find(".tour-told").text
        assert not live.js("rigidtop.playing")
        press(live, Keys.TAB * step.answer, Keys.ENTER)
        live.wait("rigidtop.playing && rigidtop.motion.now.t > 0")
        assert live.find(".tour-told").text == step.told
        assert live.find("#tour .right").text == step.choices[step.answer]
        assert live.find(".tour-place").text.endswith(f"; {number} of {number} foreseen")
        said = live.find(".verdict")
        assert said.is_displayed()
        assert seen in said.text
        assert not live.find("#notice").is_displayed()
        press(live, Keys.ENTER)
    assert not live.find("#tour").is_displayed()
    # A wrong answer is marked, and Escape ends it.
    press(live, "t")
    press(live, Keys.TAB * (TOURS[HEAVY]()[0].answer == 0), Keys.ENTER)
    assert live.find("#tour .wrong").is_displayed()
    assert live.find(".tour-place").text.endswith("; 0 of 1 foreseen")
    press(live, Keys.ESCAPE)
    assert not live.find("#tour").is_displayed()


def test_embedded_only_the_picture_and_time_are_left(live):
    live.open(HEAVY, "#preset=loops&embed=1&play=0")
    assert live.find("#scene canvas").is_displayed()
    assert live.find("#transport").is_displayed()
    for selector in ("#tools", "footer", "#column", "#looks", "#corner"):
        assert not live.find(selector).is_displayed()
    live.open(HEAVY, "#embed=yes&play=0")
    assert "embed=yes, which is none of 0, 1, 2" in live.find("#notice").text


def test_a_blow_goes_on_from_where_it_is(live):
    live.open(HEAVY, "#preset=slow&play=0&t=1")
    live.wait("rigidtop.motion.now.t === 1")
    before = live.js("rigidtop.motion.now")
    press(live, "b")
    live.wait("rigidtop.motion.now.t === 0")
    after = live.js("rigidtop.motion.now")
    speed = 0.5 * math.sqrt(TOP.M * TOP.g * TOP.R / TOP.lambda1)
    assert after["theta_dot"] == pytest.approx(before["theta_dot"] + speed, rel=1e-9)
    for name in ("theta", "phi", "phi_dot"):
        assert after[name] == pytest.approx(before[name], rel=1e-9, abs=1e-12)
    assert after["omega"][2] == pytest.approx(before["omega"][2], rel=1e-12)
    _, high = TOP.motion(
        theta=after["theta"], theta_dot=after["theta_dot"], phi_dot=after["phi_dot"],
        omega3=after["omega"][2],
    ).turning_points  # fmt: skip
    assert f"{math.degrees(high):.4g}°" in live.find(".verdict").text
    hash = live.wait("location.hash.includes('theta_dot') && location.hash")
    values = live.values
    live.open(HEAVY, hash)
    assert live.values == pytest.approx(values, rel=1e-9)


def test_the_table_holds_the_motion(live):
    live.open(HEAVY, "#preset=loops&play=0")
    text = live.driver.execute_async_script(
        "const done = arguments[0];"
        "Promise.all(['plotted', 'take'].map((name) => import(`rigidtop/${name}.js`)))"
        ".then(([{ tableOf }, { separated }]) => done(separated(tableOf(rigidtop.motion, 5))));"
    )
    names, *rows = [line.split(",") for line in text.strip().split("\r\n")]
    assert names[:2] == ["t (s)", "theta (rad)"]
    slow, _ = TOP.steady_precession(TILT, SPIN)
    exact = TOP.motion(theta=TILT, phi_dot=-2 * slow, omega3=SPIN).exact(np.linspace(0, 5, 1001))
    table = np.array(rows, dtype=float)
    assert table[:, names.index("theta (rad)")] == pytest.approx(exact.theta, abs=1e-9)
    assert table[:, names.index("phi_dot (rad/s)")] == pytest.approx(exact.phi_dot, abs=1e-9)


def test_a_reader_who_wants_no_motion_gets_none(live, wishes):
    wishes(prefers_reduced_motion="reduce")
    live.open(HEAVY, "#preset=waves")
    live.drawn()
    assert (live.js("rigidtop.playing"), live.t) == (False, 0)
    click(live, button("Play"))
    live.wait("rigidtop.motion.now.t > 0")
    # An address that says so plays.
    live.open(HEAVY, "#preset=waves&play=1")
    live.wait("rigidtop.motion.now.t > 0")


TEXTS = """
const opaque = (colour) => !/, 0\\)$/.test(colour);
return [...document.querySelectorAll("body *")].filter((x) =>
  x.checkVisibility({ visibilityProperty: true, opacityProperty: true })
  && [...x.childNodes].some((n) => n.nodeType === 3 && n.data.trim()) && !x.closest(":disabled")
  && !x.closest(".unseen")
).map((x) => {
  let ground = x, opacity = 1;
  for (let y = x; y; y = y.parentElement) opacity *= getComputedStyle(y).opacity;
  while (ground && !opaque(getComputedStyle(ground).backgroundColor)) ground = ground.parentElement;
  const paper = getComputedStyle(ground ?? document.documentElement).backgroundColor;
  return [getComputedStyle(x).color, paper, opacity, x.outerHTML.slice(0, 150)];
});
"""


def channels(colour):
    assert colour.startswith("rgb("), colour
    return np.array([float(x) for x in colour[4:-1].split(",")]) / 255


def luminance(colour):
    linear = np.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055) ** 2.4)
    return linear @ (0.2126, 0.7152, 0.0722)


@pytest.mark.parametrize(("theme", "least"), [("light", 4.5), ("dark", 4.5), ("contrast", 7)])
def test_text_stands_out_from_its_ground(live, theme, least):
    live.show(HEAVY, f"{STILL}&theme={theme}&preset=nope")
    retype(live, "omega3", "abc")
    found = live.driver.execute_script(TEXTS)
    assert len(found) > 60
    for ink, paper, opacity, what in found:
        ground = channels(paper)
        seen = opacity * channels(ink) + (1 - opacity) * ground
        darker, lighter = sorted([luminance(seen), luminance(ground)])
        assert (lighter + 0.05) / (darker + 0.05) >= least, what


def test_without_webgl_the_page_says_so_and_goes_on(live):
    source = (
        "const usual = HTMLCanvasElement.prototype.getContext;"
        "HTMLCanvasElement.prototype.getContext = function (kind, ...more) {"
        " return /webgl/.test(kind) ? null : usual.call(this, kind, ...more); };"
    )
    script = live.cdp("Page.addScriptToEvaluateOnNewDocument", source=source)
    try:
        live.open(HEAVY, "#preset=waves")
    finally:
        live.cdp("Page.removeScriptToEvaluateOnNewDocument", **script)
    said = live.find("#scene").text
    assert said.startswith("The picture needs WebGL")
    assert "\n" not in said
    assert not live.all("#scene canvas")
    live.wait("rigidtop.motion.now.t > 0.2")
    assert "held" in live.find("[role=meter]").text
    live.find("#slider-theta").send_keys(Keys.ARROW_RIGHT)
    live.wait("rigidtop.motion.setup.values.theta !== Math.PI / 6")
    for key in ("f", "+", "0", "2", " "):
        live.find("#scene").send_keys(key)
    live.wait("!rigidtop.playing && document.querySelector('[value=fast]').checked")
    click(live, "#looks [value=cones]")
    live.drawn()


def test_a_notebook_plays_the_same_page(live):
    own = page_of(rt.FreeBody(1.0, 1.7, 2.3).motion(omega=(0.02, 4.0, 0.02)))
    shown = page(HEAVY)
    frames = own._repr_html_() + shown._repr_html_()
    live.write("notebook", f'<!doctype html><meta charset="utf-8"><title>Notebook</title>{frames}')
    live.open("notebook", ready="")
    for number, verdict in enumerate(("Own motion", "Slow precession")):
        live.driver.switch_to.default_content()
        live.driver.switch_to.frame(number)
        live.wait("window.rigidtop && rigidtop.motion.now.t > 0.1")
        assert live.js("document.querySelector('[name=preset]:checked').parentElement.innerText"
                       ).endswith(verdict)  # fmt: skip
        assert live.find("#scene canvas").is_displayed()
        live.find("#slider-omega3").send_keys(Keys.ARROW_RIGHT)
        live.wait("document.querySelector('.about').textContent.startsWith('Changed')")
        click(live, button("Pause"))
        live.wait("!rigidtop.playing")


def test_a_screen_reader_finds_its_way(live):
    live.open(HEAVY, STILL)
    headings = [
        (int(node["properties"][0]["value"]["value"]), node["name"]["value"])
        for node in accessible(live, "heading")
    ]
    levels = [level for level, _ in headings]
    assert levels[0] == 1
    assert set(levels[1:]) == {2}
    assert all(name for _, name in headings)
    label = live.wait("document.querySelector('#scene[role=img]').ariaLabel")
    assert label.startswith("A heavy top, steady precession")
    assert "Now θ = " in label
    spoken = live.find("#verdict [aria-live=polite]")
    said = live.find(".verdict").text
    live.wait(lambda: spoken.get_attribute("textContent") == said)
    for parameter in page_data(HEAVY)["parameters"]:
        name = parameter["name"]
        slider, field = live.find(f"#slider-{name}"), live.find(f"#number-{name}")
        unit = "°" if parameter["angle"] else parameter["unit"]
        assert parameter["meaning"] in slider.accessible_name
        assert slider.get_attribute("aria-valuetext").endswith(unit)
        assert parameter["meaning"] in field.accessible_name
        assert unit in live.js("arguments[0].ariaDescribedByElements.map((x) => x.innerText).join()"
                               , field)  # fmt: skip
    for role in ("button", "slider", "textbox", "checkbox", "radio", "combobox", "meter", "image"):
        nodes = accessible(live, role)
        assert nodes, role
        assert all(node["name"]["value"].strip() for node in nodes), role


def accessible(live, role):
    """What a screen reader is given of that role."""
    nodes = live.cdp("Accessibility.getFullAXTree")["nodes"]
    return [n for n in nodes if not n["ignored"] and n["role"]["value"] == role]
