"""The page's modules in an embedded JavaScript engine, and in a browser."""

from __future__ import annotations

import json
import re
import shutil
from contextlib import contextmanager
from functools import cache

import pytest

from rigidtop.web.page import FOLDER, data, page
from rigidtop.web.presets import PRESETS


class Engine:
    """Modules of the page, all their names global; values go in and come out as JSON."""

    def __init__(self, *names):
        self.context = pytest.importorskip("quickjs", reason="quickjs-ng is missing").Context()
        self.context.eval("globalThis.performance = { now: () => 0 };")
        for name in names:
            self.load((FOLDER / f"{name}.js").read_text("utf-8"))

    def load(self, text):
        """A module more."""
        text = re.sub(r"(?ms)^import .*?;\n", "", text)
        self.context.eval(re.sub(r"(?m)^export ", "", text))

    def run(self, text, **given):
        """The value of an expression, or of the last statement; `given` are global there."""
        for name, value in given.items():
            self.context.set("given", json.dumps(value))
            self.context.eval(f"globalThis.{name} = JSON.parse(given);")
        # JSON has no NaN and no infinities.
        self.context.set("text", text)
        answer = self.context.eval(
            "JSON.stringify({ value: (0, eval)(text) }, (_, x) =>"
            " typeof x === 'number' && !Number.isFinite(x) ? String(x) : x)"
        )
        return json.loads(answer, object_hook=_numbers)["value"]


def _numbers(found):
    special = {"NaN": float("nan"), "Infinity": float("inf"), "-Infinity": -float("inf")}

    def back(value):
        if isinstance(value, list):
            return [back(each) for each in value]
        return special.get(value, value) if isinstance(value, str) else value

    return {name: back(value) for name, value in found.items()}


@pytest.fixture(scope="session")
def engine():
    """All modules that compute."""
    return Engine("equations", "dop853", "moving", "motion", "polhode", "facts", "regimes")


@cache
def page_data(kind):
    """What Python writes into the page of that kind."""
    presets = PRESETS[kind]()
    return data(kind, "", presets, presets[0])


@pytest.fixture(scope="session")
def tableau(engine):
    """DOP853's, also known to the engine by that name."""
    engine.run("tableau", tableau=page_data("free")["tableau"])
    return page_data("free")["tableau"]


CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")


# All of the page runs but for the pixels, which take a processor nine tenths of its time.
UNPAINTED = """
for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext])
  for (const name of ["clear", "drawArrays", "drawElements", "drawElementsInstanced"])
    if (name in prototype) prototype[name] = () => {};
"""


class Live:
    """A browser that shows the page; everything is waited for, nothing slept for."""

    PATIENCE = 30

    def __init__(self, driver, folder):
        self.driver = driver
        self.folder = folder
        self.opened = 0
        self.unpainted = self.cdp("Page.addScriptToEvaluateOnNewDocument", source=UNPAINTED)
        for kind in PRESETS:
            self.write(kind, page(kind).html)

    def write(self, name, html):
        (self.folder / f"{name}.html").write_text(html, "utf-8")

    @contextmanager
    def painting(self):
        """WebGL draws what it is told to, for pages that are opened from here on."""
        self.cdp("Page.removeScriptToEvaluateOnNewDocument", **self.unpainted)
        self.driver.get("about:blank")
        yield
        self.unpainted = self.cdp("Page.addScriptToEvaluateOnNewDocument", source=UNPAINTED)
        self.driver.get("about:blank")

    def open(self, name, hash="", ready="window.rigidtop && rigidtop.frames > 1"):
        """The page of that name, loaded anew."""
        self.opened += 1
        self.driver.get(f"{(self.folder / name).as_uri()}.html?{self.opened}{hash}")
        if ready:
            self.wait(ready)
            # What is folded away is there all the same.
            self.driver.execute_script(
                "for (const part of document.querySelectorAll('#more details')) part.open = true;"
            )

    def show(self, kind, hash):
        """The page of that kind by an address that is put into it, loaded only where it is not."""
        if f"/{kind}.html?" not in self.driver.current_url:
            self.open(kind, hash)
            return
        self.opened += 1
        # The page reads over empty parts; with them the address is another than it was.
        self.driver.execute_async_script(
            "const [hash, done] = arguments; addEventListener('hashchange', () =>"
            " requestAnimationFrame(() => requestAnimationFrame(done)), { once: true });"
            "location.hash = hash;",
            hash + "&" * (1 + self.opened % 2),
        )

    def js(self, text, *arguments):
        """The value of an expression."""
        return self.driver.execute_script(f"return {text};", *arguments)

    def wait(self, condition, *arguments):
        """The value of an expression as soon as it is true, or of a function of no arguments."""
        from selenium.webdriver.support.wait import WebDriverWait

        ask = condition if callable(condition) else lambda: self.js(condition, *arguments)
        waiting = WebDriverWait(self.driver, self.PATIENCE, poll_frequency=0.05)
        return waiting.until(lambda _: ask(), f"never: {condition}")

    def frames(self, count=2):
        """Let the page draw so many frames."""
        seen = self.js("rigidtop.frames")
        self.wait("rigidtop.frames >= arguments[0]", seen + count)

    def drawn(self):
        """Let everything that was asked for be drawn: at rest no more frames come."""
        self.driver.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done));"
        )

    def find(self, selector):
        return self.driver.find_element("css selector", selector)

    def all(self, selector):
        return self.driver.find_elements("css selector", selector)

    def cdp(self, command, **arguments):
        return self.driver.execute_cdp_cmd(command, arguments)

    @property
    def t(self):
        return self.js("rigidtop.motion.now.t")

    @property
    def values(self):
        return self.js("rigidtop.motion.setup.values")

    def complaints(self):
        """What the browser logged since it was asked last."""
        messages = [entry["message"] for entry in self.driver.get_log("browser")]
        # Where the processor composes the page, it waits for the pictures.
        return [each for each in messages if "GPU stall due to ReadPixels" not in each]

    def requests(self):
        """What the page asked for since it was asked last."""
        messages = (json.loads(e["message"])["message"] for e in self.driver.get_log("performance"))
        sent = (m["params"] for m in messages if m["method"] == "Network.requestWillBeSent")
        return [each["request"]["url"] for each in sent]


def chrome(*flags):
    """Headless Chromium, which draws in three dimensions by the processor."""
    webdriver = pytest.importorskip("selenium.webdriver", reason="selenium is missing")
    if not CHROMIUM or not DRIVER:
        pytest.skip(f"{'chromedriver' if CHROMIUM else 'chromium'} is missing")
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    usual = ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=1280,800")
    for flag in (*usual, *flags):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=webdriver.ChromeService(DRIVER))
    # What hangs falls with a message.
    driver.set_page_load_timeout(60)
    driver.set_script_timeout(60)
    return driver


@pytest.fixture(scope="session")
def browser(tmp_path_factory):
    """One for all tests of a process."""
    driver = chrome(
        "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing"
    )
    try:
        yield Live(driver, tmp_path_factory.mktemp("pages"))
    finally:
        driver.quit()


@pytest.fixture
def live(browser):
    """The browser as at first; no test may leave a complaint or have sent a request."""
    yield browser
    sent = [url for url in browser.requests() if not re.match("(file|data|blob|about):", url)]
    said = browser.complaints()
    browser.driver.switch_to.default_content()
    assert not sent
    assert not said


@pytest.fixture
def wishes(live):
    """Sets what the reader's system asks for."""

    def media(**features):
        wanted = [{"name": name.replace("_", "-"), "value": v} for name, v in features.items()]
        live.cdp("Emulation.setEmulatedMedia", features=wanted)

    yield media
    media()
