"""The page in a browser, as its readers use it."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy

import rigidtop as rt
from rigidtop.web import terms
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
    assert len(meters) == (1 if name == "running-down" else 3 if kind == HEAVY else 2)
    for meter in meters:
        assert meter.text.endswith(("held", "exact"))
        assert -16 <= float(meter.get_attribute("aria-valuenow")) < -9
    assert live.js("rigidtop.motion.drift().every((drift) => drift.most < 1e-9)")


HOUR = """
const [name, seconds, done] = arguments;
import("rigidtop/motion.js").then(({ createMotion }) => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const { setup, speed } = data.presets.find((preset) => preset.name === name);
  const motion = createMotion(setup, data.tableau);
  let most = 0;
  for (let frame = 1; frame <= seconds * 10; frame++) {
    motion.go((speed * frame) / 10);
    const { energy, taken } = motion.now;
    most = Math.max(most, Math.abs((energy + taken) / motion.start.energy - 1));
  }
  done([motion.now.t, most, motion.drift().map((drift) => drift.most)]);
}, (error) => done(String(error)));
"""


@pytest.mark.parametrize("kind", PRESETS)
def test_an_hour_of_frames_keeps_the_energy(live, kind):
    live.show(kind, STILL)
    for number, preset in enumerate(PRESETS[kind]()):
        seconds = 20 if number else 3600  # one for an hour
        t, energy, drifts = live.driver.execute_async_script(HOUR, preset.name, seconds)
        assert t == pytest.approx(seconds * preset.speed)
        assert energy < 1e-10, preset.name
        assert max(drifts) < 1e-10, preset.name


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


def test_a_typed_number_starts_another_motion(live):
    live.show(HEAVY, "#preset=cusps&t=1&play=0")
    live.wait("rigidtop.motion.now.t === 1")
    said = live.find(".verdict").text
    retype(live, "theta", "60")
    live.wait("rigidtop.motion.setup.values.theta === Math.PI / 3")
    assert live.t == 0
    assert live.find(".verdict").text != said
    retype(live, "phi_dot", "−1.5e0")
    live.wait("rigidtop.motion.setup.values.phi_dot === -1.5")


def test_units_may_stand_behind_a_typed_number(live):
    live.show(HEAVY, "#preset=cusps&play=0")
    for name, text, expected in (
        ("theta", "60deg", math.pi / 3), ("theta", "0.5 rad", 0.5), ("theta", "30°", math.pi / 6),
        ("omega3", "60rpm", 2 * math.pi), ("omega3", "-180deg", -math.pi),
    ):  # fmt: skip
        retype(live, name, text)
        live.wait(f"Math.abs(rigidtop.motion.setup.values.{name} - {expected}) < 1e-12")
    for name, text in (("theta", "3rpm"), ("M", "1deg"), ("omega3", "5 kg")):
        retype(live, name, text)
        assert "is not a number" in live.find(f"#error-{name}").text


def test_no_box_keeps_what_the_motion_does_not_have(live):
    live.show(HEAVY, "#preset=cusps&play=0")
    retype(live, "theta", "abc")
    retype(live, "lambda3", "9")
    live.wait("document.querySelector('#error-lambda3').textContent !== ''")
    assert live.find("#number-theta").get_attribute("value") == "30"
    assert not live.find("#error-theta").text
    retype(live, "g", "3")
    live.wait("rigidtop.motion.setup.values.g === 3")
    assert live.values["lambda3"] == 0.7
    assert live.find("#number-lambda3").get_attribute("value") == "0.7"
    assert not live.all(".error:not(:empty)")


def test_an_address_may_set_what_has_no_slider(live):
    live.show(HEAVY, "#preset=waves&theta_dot=0.5&psi=30deg&play=0")
    assert live.values["theta_dot"] == 0.5
    assert live.values["psi"] == pytest.approx(math.pi / 6)
    assert not live.find("#notice").is_displayed()
    click(live, ".steady button")
    live.wait("rigidtop.motion.setup.values.theta_dot === 0")
    assert live.find(".verdict").text.startswith("Steady precession: θ stays at 30°.")


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


@pytest.mark.parametrize(("index", "letter"), [(0, "Ω₋"), (1, "Ω₊")])
def test_the_buttons_make_the_precession_steady(live, index, letter):
    live.show(HEAVY, "#preset=cusps&play=0&theta=40deg")
    choice = live.all(".steady button")[index]
    assert letter in choice.text
    live.driver.execute_script("arguments[0].click()", choice)
    live.wait("rigidtop.motion.setup.values.phi_dot !== 0")
    rates = TOP.steady_precession(math.radians(40), 12.0)
    assert live.values["phi_dot"] == pytest.approx(rates[index], rel=1e-12)
    live.wait("document.querySelector('#scene').ariaLabel.includes(', steady precession. Now')")
    found = live.js(
        "(({ motion }) => Array.from({ length: 51 }, (_, k) =>"
        " (motion.go(k / 10), motion.now.theta - motion.start.theta)))(rigidtop)"
    )
    assert max(map(abs, found)) < 1e-9
    assert live.t == 5


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


SPEED = """
const done = arguments[0];
let before = null, rates = [];
function look(now) {
  const t = rigidtop.motion.now.t;
  // Of a long frame the page takes a twentieth of a second.
  if (before) rates.push((t - before[1]) / Math.min(now - before[0], 50) * 1000);
  before = [now, t];
  if (rates.length < 15) requestAnimationFrame(look); else done(rates.sort((a, b) => a - b)[7]);
}
requestAnimationFrame(look);
"""


def test_slow_motion_slows(live):
    live.show(HEAVY, "#preset=waves")
    usual = live.driver.execute_async_script(SPEED)
    live.find("#speed").send_keys(Keys.ARROW_LEFT * 3)
    live.wait("document.querySelector('.speed output').textContent === '×0.1'")
    slow = live.driver.execute_async_script(SPEED)
    assert 0.5 < usual < 2
    assert 0.05 < slow / usual < 0.2
    assert live.find("#speed").get_attribute("aria-valuetext") == "×0.1, 0.1 s each second"


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


def test_on_a_phone_nothing_lies_over_what_has_the_focus(phone):
    phone.open(FREE, STILL)
    seen = set()
    for step in range(90):
        (press(phone, Keys.TAB) if step < 60 else shift_tab(phone))
        focused = phone.driver.execute_script(FOCUSED)
        assert not focused["covered"], focused["what"]
        seen.add(focused["what"])
    assert len(seen) > 25


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


def test_keys_of_their_own(live):
    live.open(HEAVY, STILL)
    press(live, " ")
    live.wait("rigidtop.playing && rigidtop.motion.now.t > 0")
    press(live, "k")
    live.wait("!rigidtop.playing")
    t = live.t
    press(live, ".")
    live.wait("rigidtop.motion.now.t > arguments[0]", t)
    press(live, ",")
    live.wait("Math.abs(rigidtop.motion.now.t - arguments[0]) < 1e-12", t)
    press(live, "r")
    live.wait("rigidtop.motion.now.t === 0")
    press(live, "4")
    live.wait("document.querySelector('[value=waves]').checked")
    press(live, "f")
    live.wait("document.querySelector('#looks [value=body]').checked")
    press(live, "f")
    live.wait("document.querySelector('#looks [value=space]').checked")
    press(live, "?")
    live.wait("document.getElementById('keys').open")
    assert live.find("#keys").is_displayed()
    assert "play, pause" in live.find("#keys").text
    press(live, Keys.ESCAPE)
    live.wait("!document.getElementById('keys').open")
    tab_to(live, '[aria-label="Keys"]')
    press(live, Keys.ENTER)
    live.wait("document.getElementById('keys').open")
    press(live, Keys.ENTER)
    live.wait("!document.getElementById('keys').open")
    # A field that is typed in has all keys.
    live.find("#number-theta").send_keys("3", "k", "r", "?")
    live.drawn()
    assert not live.js("rigidtop.playing || document.getElementById('keys').open")
    assert live.js("document.querySelector('[value=waves]').checked")


@pytest.mark.parametrize(
    ("kind", "hash"),
    [(HEAVY, "preset=loops&t=0.7"), (HEAVY, "preset=loops&lambda2=1.5&t=0.7"),
     (FREE, "preset=flip&t=3.7")],
)  # fmt: skip
def test_a_term_is_named_with_its_value(live, kind, hash):
    live.show(kind, f"{STILL}&{hash}")
    live.wait("rigidtop.motion.now.t > 0.5")
    live.frames(0)
    numbers = quantities(live)
    figures = [each for each in live.all(".equation") if each.is_displayed()]
    assert len(figures) == 3
    for figure in figures:
        found = figure.find_element("css selector", ".equation-naming")
        of = found.find_element("css selector", ".equation-amount")
        each = terms_of(of.get_attribute("id").removeprefix("amount-"), kind)
        drawn = figure.find_elements("css selector", "[data-term]")
        assert {int(x.get_attribute("data-term")) for x in drawn} == {*range(len(each.terms))}
        assert not found.text
        for target in drawn:
            number = int(target.get_attribute("data-term"))
            term, expected = each.terms[number], value_of(each.values[number], numbers)
            ActionChains(live.driver, duration=0).move_to_element(target).perform()
            assert_named(found, of, term, expected)
        ActionChains(live.driver, duration=0).move_to_element(live.find("h1")).perform()
        assert not found.text
        # By the keyboard: the first by Tab, the others by the arrows.
        live.driver.execute_script("arguments[0].focus()", drawn[0])
        for target in drawn:
            number = int(target.get_attribute("data-term"))
            term, expected = each.terms[number], value_of(each.values[number], numbers)
            assert live.driver.switch_to.active_element == target
            assert_named(found, of, term, expected)
            assert term.name.replace("_", " ") in target.accessible_name  # as it is spoken
            described = target.get_attribute("aria-describedby")
            assert described == of.get_attribute("id")
            press(live, Keys.ARROW_RIGHT)
        assert live.driver.switch_to.active_element == drawn[0]


def test_a_term_lights_its_arrow(live):
    live.driver.get("about:blank")  # nothing is folded away by what came before
    live.show(HEAVY, f"{STILL}&preset=loops&layers=e3")
    ActionChains(live.driver, duration=0).move_to_element(live.find("h1")).perform()
    shown = "[...document.querySelectorAll('#scene span')].filter((x) => x.style.display !== 'none'"
    shown += " && ['L', 'N', 'ω'].includes(x.textContent)).map((x) => x.textContent)"
    terms_ = live.all("#equations figure:first-of-type [data-term]")
    for term, arrows in ((terms_[3], ["N"]), (terms_[1], [])):
        live.driver.execute_script("arguments[0].focus()", term)
        live.wait(lambda arrows=arrows: live.js(shown) == arrows)
    live.driver.execute_script("arguments[0].focus()", terms_[3])
    live.wait(lambda: live.js(shown) == ["N"])
    live.driver.execute_script("arguments[0].blur()", terms_[3])
    live.wait(lambda: not live.js(shown))


def quantities(live):
    """The state of the page by SymPy's names."""
    return live.driver.execute_async_script(
        "const done = arguments[0]; import('rigidtop/motion.js')"
        ".then(({ quantities }) => done(quantities(rigidtop.motion.now, rigidtop.motion)));"
    )


def terms_of(function, kind):
    known = terms.free() if kind == FREE else (*terms.heavy(), *terms.general())
    return next(each for each in known if each.function == function)


def value_of(expression, numbers):
    expression = sympy.sympify(expression)
    return float(expression.subs({x: numbers[x.name] for x in expression.free_symbols}))


def assert_named(line, amount, term, expected):
    """ "MgR sin θ = 1.240 N m" and the term's name stand in the line."""
    plain = str.maketrans({"_": None, "\N{NARROW NO-BREAK SPACE}": " "})
    says, equals, rest = amount.get_attribute("textContent").translate(plain).rpartition(" = ")
    assert (says, equals) == (term.text.translate(plain), " = ")
    number, unit = rest.split(" ", 1)
    assert unit == term.unit
    mantissa, _, power = number.replace("−", "-").partition("·10")
    exponent = power.translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-"))
    assert float(mantissa) * 10.0 ** int(exponent or 0) == pytest.approx(expected, rel=1e-3)
    assert term.name.translate(plain) in line.get_attribute("textContent")


def test_a_narrow_screen(phone):
    phone.open(HEAVY, STILL)
    wide = "[...document.querySelectorAll('body *')].filter((x) => x.checkVisibility()"
    assert phone.js("[innerWidth, document.documentElement.scrollWidth]") == [390, 390]
    assert not phone.js(f"{wide} && x.tagName === 'SECTION' && x.scrollWidth > 391)")
    for selector in ("#scene canvas", "#transport", ".clock", button("Play")):
        box = phone.find(selector).rect
        assert box["width"] > 30
        assert box["y"] >= 0
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= 390
        assert box["y"] + box["height"] <= 844
    # What is set, what it will do and the beginning of the plot are in view with the picture.
    for selector in ("#start .row:last-child", ".verdict", "#plots canvas"):
        box = phone.find(selector).rect
        assert box["y"] + min(box["height"], 50) <= 844
    for each in phone.all("#start input[type=range]"):
        assert each.size["width"] >= 150
    # A finger needs room.
    for each in phone.all("#transport button"):
        assert min(each.size.values()) >= 40


SIZES = ((1280, 720), (1024, 768), (3840, 2160))


def test_cause_and_effect_are_in_view_together(live):
    live.open(FREE, STILL)
    sliders = "#start input[type=range]"
    assert len(live.all(sliders)) == 3
    try:
        for width, height in SIZES:
            live.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height,
                     deviceScaleFactor=1, mobile=False)  # fmt: skip
            live.drawn()
            for selector in ("#scene", "#verdict .verdict", "#plots", "#regimes canvas", sliders):
                for each in live.all(selector):
                    box = each.rect
                    assert min(box["x"], box["y"]) >= 0, (selector, width)
                    assert box["x"] + box["width"] <= width, (selector, width)
                    assert box["y"] + box["height"] <= height, (selector, height)
            assert all(each.size["width"] >= 150 for each in live.all(sliders))
            assert live.find("#plots").size["height"] >= 150
            assert live.find("#regimes").size["width"] >= 180
    finally:
        live.cdp("Emulation.clearDeviceMetricsOverride")


def test_a_hand_is_caught_by_the_steady_rates(live):
    live.open(HEAVY, "#preset=cusps&play=0")
    slow, _ = TOP.steady_precession(TILT, SPIN)
    track = live.find("#slider-phi_dot")
    live.js(
        "(window.seen = [], arguments[0].addEventListener('input', () =>"
        " seen.push(arguments[0].getAttribute('aria-valuetext'))))", track)  # fmt: skip
    chain = ActionChains(live.driver, duration=1)
    chain.move_to_element_with_offset(track, -30, 0).click_and_hold()
    for _ in range(30):
        chain.move_by_offset(2, 0)
    chain.release().perform()
    seen = live.js("seen")
    assert len(set(seen)) > 10
    assert "0 rad/s" in seen
    assert f"{slow:.4g} rad/s" in seen


def test_the_map_of_starts_sets_both(live):
    live.open(HEAVY, "#preset=cusps&play=0")
    box = live.find("#regimes canvas")
    ActionChains(live.driver).move_to_element_with_offset(box, -40, -20).click().perform()
    live.wait("rigidtop.motion.setup.values.phi_dot !== 0")
    assert live.values["phi_dot"] < 0
    assert 0 < live.values["omega3"] < 12
    assert float(live.find("#number-omega3").get_attribute("value")) == live.values["omega3"]
    live.open(HEAVY, "#preset=sleeping&theta=0&play=0")
    assert not live.find("#regimes").is_displayed()


def test_omega_is_dragged_across_the_separatrix(live):
    live.open(FREE, "#preset=largest&play=0")
    moments = [live.values[f"lambda{k}"] for k in (1, 2, 3)]
    energy = np.dot(moments, [live.values[f"omega{k}"] ** 2 for k in (1, 2, 3)])
    box = live.find("#regimes canvas")
    hand = ActionChains(live.driver, duration=0)
    hand.move_to_element_with_offset(box, 0, -60).click_and_hold()
    hand.move_by_offset(-60, 80).release().perform()
    live.wait("document.querySelector('.verdict').textContent.includes('goes round e₁')")
    omega = [live.values[f"omega{k}"] for k in (1, 2, 3)]
    assert np.dot(moments, np.square(omega)) == pytest.approx(energy, rel=1e-12)
    # Near the separatrix ω is taken onto it: halfway between e₂ and the plane across e₂.
    front = np.array([0.52, 0.74, 0.42]) / np.linalg.norm([0.52, 0.74, 0.42])
    up = np.array([0, 0, 1]) - front[2] * front
    up /= np.linalg.norm(up)
    u = np.array([math.sqrt(moments[2] - moments[1]), 0, math.sqrt(moments[1] - moments[0])])
    u = (u / np.linalg.norm(u) + (0, 1, 0)) / math.sqrt(2)
    em = float(box.value_of_css_property("font-size").removesuffix("px"))
    radius = min(box.size["width"] / 2 - 2 * em, box.size["height"] / 2 - 1.9 * em)
    x, y = radius * np.cross(up, front) @ u + 2, 0.3 * em - radius * up @ u
    hand.move_to_element_with_offset(box, round(x), round(y)).click().perform()
    live.wait("document.querySelector('.verdict').textContent.includes('on the separatrix')")


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
        assert live.find(".tour-place").text.endswith(f"; {number} of {number} predicted")
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
    assert live.find(".tour-place").text.endswith("; 0 of 1 predicted")
    press(live, Keys.ESCAPE)
    assert not live.find("#tour").is_displayed()


@pytest.mark.parametrize(("kind", "plot"), [(HEAVY, "phase"), (HEAVY, "energy"), (FREE, "angles")])
def test_what_is_plotted_is_said(live, kind, plot):
    live.open(kind, f"{STILL}&plot={plot}&t=1&ghost=larger")
    live.wait("rigidtop.motion.now.t === 1")
    said = live.wait(lambda: "At t = 1" in (text := aria(live)) and text)
    sample = live.js("rigidtop.motion.now")
    if plot == "energy":
        assert f"E = {sample['energy']:.4g}"[:8] in said
    else:
        assert f"θ = {math.degrees(sample['theta']):.2f}°" in said
    assert said.startswith("θ̇ against θ" if plot == "phase" else "Against time")


def aria(live):
    return live.js("document.querySelector('#plots canvas').ariaLabel") or ""


def test_embedded_only_the_picture_and_time_are_left(live):
    live.open(HEAVY, "#preset=loops&embed=1&play=0")
    assert live.find("#scene canvas").is_displayed()
    assert live.find("#transport").is_displayed()
    for selector in ("#tools", "footer", "#column", "#looks", "#corner"):
        assert not live.find(selector).is_displayed()
    live.open(HEAVY, "#embed=yes&play=0")
    assert "embed=yes, which is none of 0, 1, 2" in live.find("#notice").text


@pytest.mark.parametrize(("width", "height"), [(1280, 800), (1440, 900), (1920, 1080)])
def test_the_map_stands_beside_the_sphere(live, width, height):
    """The sphere, of radius 1, as the scene draws it: see scene.js."""
    size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
    live.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    try:
        live.open(HEAVY, f"{STILL}&preset=loops")
        low = live.js("document.querySelector('#corner .start-map').getBoundingClientRect()")
        scene = live.js("document.querySelector('#scene').getBoundingClientRect()")
        tangent = math.tan(math.radians(13.5)) / min(1, scene["width"] / scene["height"]) * 1.08
        radius = scene["height"] / 2 / tangent * math.tan(math.asin(1 / 5.2))
        x = scene["x"] + (0.5 + 0.08) * scene["width"] - low["right"]
        y = scene["y"] + (0.5 + 0.045) * scene["height"] - low["bottom"]
        assert math.hypot(x, y) > radius + 5
    finally:
        live.driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def test_pivot_arm_and_centre_of_mass_are_lettered(live):
    """From below upwards where the top stands nearly upright; a free body has none of them."""
    named = "[...document.querySelectorAll('#scene span')].filter((x) => x.style.display !== 'none'"
    named += " && ['pivot', 'R', 'CM'].includes(x.textContent)).map((x) =>"
    named += " [x.textContent, x.getBoundingClientRect().y, x.getBoundingClientRect().x])"
    live.show(HEAVY, f"{STILL}&preset=sleeping")
    names, heights, sides = zip(*live.js(named), strict=True)
    assert names == ("pivot", "R", "CM")
    assert heights[0] > heights[1] + 10 > heights[2] + 20
    assert max(sides) - min(sides) < 40
    live.show(FREE, STILL)
    assert live.js(named) == []


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


def test_shown_to_a_room(live):
    live.open(HEAVY, "#preset=loops&play=0")
    press(live, "p")
    live.wait("document.body.classList.contains('presenting')")
    assert live.find(".verdict").value_of_css_property("font-size") == "28px"
    assert not live.find("#sliders, #start").is_displayed()
    letters = "[...document.querySelectorAll('#scene div[aria-hidden]')][0].style.fontSize"
    live.wait(f"parseFloat({letters}) >= 28")
    press(live, "p")
    live.wait("!document.body.classList.contains('presenting')")
    assert live.find("#start").is_displayed()


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


@pytest.mark.parametrize("preset", ["waking", "toppling"])
def test_the_window_of_time_holds_a_few_nutations(live, preset):
    live.open(HEAVY, f"#preset={preset}&play=0")
    duration, period = live.driver.execute_async_script(
        "const done = arguments[0]; const { motion } = rigidtop;"
        "Promise.all(['plotted', 'facts'].map((name) => import(`rigidtop/${name}.js`)))"
        ".then(([{ plottedOf }, { factsOf }]) =>"
        " done([plottedOf(motion, 'angles').duration, factsOf(motion).nutationPeriod]));"
    )
    assert f" every {period:.4g} s" in live.find(".verdict").text
    assert 1.8 <= duration / period <= 4.6


LOOKING = """
window.seen = [];
window.hidings = 0;
document.addEventListener("visibilitychange", () => (hidings += document.hidden ? 1 : 0));
(function look(now) {
  seen.push([now, rigidtop.motion.now.t]);
  requestAnimationFrame(look);
})(performance.now());
"""


def test_a_hidden_page_stands_still_and_does_not_jump(live):
    live.show(HEAVY, "#preset=waves")
    live.wait("rigidtop.motion.now.t > 0")
    live.driver.execute_script(LOOKING)
    live.wait("seen.length > 5")
    live.driver.minimize_window()
    try:
        live.wait("hidings === 1 && document.hidden")
        hidden, frames = live.js("[performance.now(), rigidtop.frames]")
        live.wait("performance.now() > arguments[0] + 1500", hidden)
        assert live.js("rigidtop.frames") <= frames + 1
    finally:
        live.driver.set_window_size(1280, 800)
    live.wait("!document.hidden")
    live.frames(5)
    seen = np.array(live.js("seen"))
    gaps, steps = np.diff(seen, axis=0).T
    assert gaps.max() > 1400
    # At most a twentieth of a second for each frame, however long it was.
    assert steps.max() <= 0.05 + 1e-9
    assert live.js("rigidtop.playing")


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
    for key in ("f", "+", "0", "3", " "):
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
    for number, verdict in enumerate(("Own motion", "Loops")):
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
    assert label.startswith("A heavy top, loops")
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
