"""The page of a lecture in a browser: cards, the way back, contents, views, notes in the margin."""

from __future__ import annotations

import re
from base64 import b64decode

import pytest
from sympy import symbols

from rigidtop.proof.equation import Equation
from rigidtop.proof.verdict import Verdict
from rigidtop.report import blocks as b
from rigidtop.report import html
from rigidtop.report.transcript import transcript
from rigidtop.theory.symbols import phi, phidot
from rigidtop.typeset.mathml import mathml

from ..web.conftest import chrome

pytest.importorskip("selenium", reason="selenium is missing")
from selenium.webdriver import ActionChains, Keys
from selenium.webdriver.support.wait import WebDriverWait

X, Y = symbols("x y")


def _line(number):
    row = b.DisplayRow(
        Equation(X, Y),
        "auto",
        number,
        reason=("Take",),
        mark=b.MarginMark(number, Verdict.ASSUMING, ("if x is small",)),
        anchor=b.anchor(number),
    )
    return b.Display((row,), step=True)


def _filling(count):
    return [b.Paragraph(("Words that fill the page.",))] * count


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    blocks = [
        b.SectionHead(1, "1", "First", "section-1"),
        _line("1.1"),
        b.SectionHead(2, "1.1", "Inner", "section-1-1"),
        *_filling(40),
        b.Paragraph(("By ", b.Cited("(1.1)", b.anchor("1.1")), " and so on.")),
        *_filling(10),
        b.SectionHead(1, "2", "Second", "section-2"),
        *_filling(40),
    ]
    path = tmp_path_factory.mktemp("page") / "lecture.html"
    path.write_text(html.write(b.Document("T", "", tuple(blocks), "", lecture=True), {}), "utf-8")
    driver = chrome()
    yield driver, path.as_uri()
    driver.quit()


@pytest.fixture
def shown(page):
    """The driver at the page as it is at first, its citation in the middle."""
    driver, address = page
    driver.get("about:blank")
    driver.get(address)
    link = driver.find_element("css selector", "p a[href='#claim-1-1']")
    driver.execute_script("arguments[0].scrollIntoView({ block: 'center' })", link)
    return driver, link


def test_its_letters_come_with_the_page(page):
    driver, address = page
    driver.get(address)
    kept, names = driver.execute_async_script(
        "document.fonts.ready.then((all) => Promise.all([...all].map((each) => each.load())))"
        ".then((all) => arguments[0]([all.map(({ status }) => status), ['p', 'math'].map((each) =>"
        " getComputedStyle(document.querySelector(each)).fontFamily.split(',')[0])]))"
    )
    assert kept == ["loaded"] * 4
    assert names == ['"rigidtop Text"', '"rigidtop Math"']
    letters = re.findall(r"base64,([^)]+)\)", html.style("fonts.css"))
    assert [b64decode(each)[:4] for each in letters] == [b"wOF2"] * 4
    assert sum(map(len, letters)) < 250_000


def _card(driver):
    card = driver.find_element("id", "card")
    return card.text.split() if card.is_displayed() else None


def test_a_citation_that_is_pointed_at_has_a_card(shown):
    driver, link = shown
    assert _card(driver) is None
    ActionChains(driver).move_to_element(link).perform()
    assert _card(driver) == ["x", "=", "y", "(1.1)"]
    assert link.get_attribute("aria-describedby") == "card"
    # The pointer may go onto the card, and the card is in sight.
    card = driver.find_element("id", "card")
    ActionChains(driver).move_to_element(card).perform()
    assert _card(driver)
    assert driver.execute_script("return card.getBoundingClientRect().bottom <= innerHeight")
    ActionChains(driver).send_keys(Keys.ESCAPE).perform()
    assert _card(driver) is None
    assert link.get_attribute("aria-describedby") is None


def test_a_citation_that_has_the_focus_has_a_card_and_a_way_back(shown):
    driver, link = shown
    before = driver.execute_script("arguments[0].focus(); return scrollY", link)
    assert _card(driver)
    back = driver.find_element("class name", "back")
    assert not back.is_displayed()
    ActionChains(driver).send_keys(Keys.ENTER).perform()
    assert _card(driver) is None
    assert driver.execute_script("return [location.hash, scrollY < 300]") == ["#claim-1-1", True]
    back.click()
    assert driver.execute_script("return scrollY") == pytest.approx(before, abs=2)
    assert driver.switch_to.active_element == link
    assert not back.is_displayed()
    assert _card(driver) is None


def test_a_number_in_the_address_leads_to_its_equation(shown, page):
    driver, _ = shown
    row = "return [document.querySelector(':target')?.className, location.hash]"
    driver.execute_script("scrollTo(0, 500); location.hash = '1.1'")
    WebDriverWait(driver, 5).until(lambda _: driver.execute_script(row)[0])
    assert driver.execute_script(row) == ["row result", "#claim-1-1"]
    assert driver.execute_script("return scrollY < 300")
    driver.get("about:blank")
    driver.get(f"{page[1]}#1.1")
    assert driver.execute_script(row) == ["row result", "#claim-1-1"]
    driver.execute_script("location.hash = '7.7'")
    assert driver.execute_script(row) == [None, "#7.7"]


def test_a_tap_opens_the_card_whose_number_leads_there(shown):
    driver, link = shown
    driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True})

    def tap(node):
        x, y = driver.execute_script(
            "const { x, y, width, height } = arguments[0].getBoundingClientRect();"
            "return [x + width / 2, y + height / 2]",
            node,
        )
        for kind, points in (("touchStart", [{"x": x, "y": y}]), ("touchEnd", [])):
            driver.execute_cdp_cmd(
                "Input.dispatchTouchEvent", {"type": kind, "touchPoints": points}
            )

    try:
        tap(link)
        assert _card(driver)
        assert driver.execute_script("return location.hash") == ""
        tap(driver.find_element("css selector", "#card .place"))
        assert driver.execute_script("return location.hash") == "#claim-1-1"
        assert driver.find_element("class name", "back").is_displayed()
    finally:
        driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})


MARKED = """dispatchEvent(new Event("scroll"));
const links = [...document.querySelectorAll(".toc a")];
const bold = links.filter((each) => getComputedStyle(each).fontWeight > 400);
const marked = links.filter((each) => each.matches("[aria-current=true]"));
return [bold.map((each) => each.textContent), marked.length]"""


def test_the_section_that_is_read_is_marked_on_two_levels(shown):
    driver, _ = shown
    assert driver.execute_script(MARKED) == [["1First", "1.1Inner"], 1]
    driver.execute_script("scrollTo(0, 1e6)")
    assert driver.execute_script(MARKED) == [["2Second"], 1]
    driver.execute_script("scrollTo(0, 0)")
    assert driver.execute_script(MARKED) == [["1First"], 1]
    assert len(driver.find_elements("css selector", ".toc li li")) == 1


NOTE = """const [note, row] = [".side", ".row"].map((name) =>
  document.querySelector(name).getBoundingClientRect());
return [note.left >= row.right, note.top < row.bottom, note.right <= innerWidth,
  document.documentElement.scrollWidth <= innerWidth]"""


@pytest.mark.parametrize(
    ("width", "beside"), [(1920, True), (1280, True), (1240, False), (390, False)]
)
def test_a_condition_stands_in_the_margin_where_there_is_room(shown, width, beside):
    driver, _ = shown
    size = {"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": width < 500}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    assert driver.execute_script(NOTE) == [beside, beside, True, True]
    driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def test_what_is_shown_and_its_colours_want_no_script(shown):
    driver, _ = shown
    why = driver.find_element("class name", "why")
    for words, seen in (("Results only", False), ("Steps and reasons", True), ("Steps", False)):
        driver.find_element("xpath", f"//label[.='{words}']").click()
        assert why.is_displayed() == seen
    paper = "return getComputedStyle(document.body).backgroundColor"
    light = driver.execute_script(paper)
    driver.find_element("xpath", "//label[.='Light or dark']").click()
    assert light == "rgb(253, 253, 251)"
    assert driver.execute_script(paper) == "rgb(23, 24, 26)"


HEIGHTS = """return [...document.querySelectorAll("math")].map((each) =>
  each.querySelector("mi").getBoundingClientRect().top
  - each.querySelector("mn").getBoundingClientRect().top)"""


def test_an_exponent_stands_beside_an_accent(page, tmp_path):
    """As high as at the letter without it."""
    driver, _ = page
    formulas = [mathml(each**2) for each in (phi, phidot, phidot + phi)]
    formulas += [
        transcript(tex, {}) for tex in (r"\dot\phi^2", r"\ddot{\phi}_a^2", r"\hat\phi^{2}")
    ]
    path = tmp_path / "exponents.html"
    body = "<p>".join(formulas)
    path.write_text(f'<!DOCTYPE html><meta charset="utf-8"><p>{body}', "utf-8")
    driver.get(path.as_uri())
    bare, *accented = driver.execute_script(HEIGHTS)
    assert accented == pytest.approx([bare] * 5, abs=3)
