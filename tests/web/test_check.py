"""The page "Check my derivation": its worker under node, and the page in a browser."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from io import BytesIO
from pathlib import Path
from xml.etree import ElementTree
from zipfile import ZipFile

import pytest

from rigidtop.cli import main
from rigidtop.commands.browser import NOTHING, SECONDS, Desk
from rigidtop.errors import RigidtopError
from rigidtop.web.check import EXAMPLE, FETCH, FOLDER, package, page

NODE = shutil.which("node")
PYODIDE = Path(os.environ.get("RIGIDTOP_PYODIDE", "nowhere"))
"""A folder with Pyodide's release: what the page says how to get."""

TEXTS = {
    "bob": EXAMPLE,
    "spring": "Let $L = \\tfrac12 m\\dot x^2 - \\tfrac12 k x^2$. Then $m\\ddot x = -k x$ and\n"
    "\n\\begin{align} p &= m\\dot x \\\\ \\dot p &= -2 k x \\end{align}\n\n$$x^{x^{$$\n",
}
NUMBERED = "$$L_3 = \\lambda_3\\omega_3 \\tag{3.50}$$\n\n$$\\sin^2 x + \\cos^2 x = 1$$\n"
"""With an equation of the lecture, which is judged by a computed motion."""

HARNESS = """
import { readFileSync } from "node:fs";
globalThis.self = globalThis;
const [worker, code, folder, texts] = process.argv.slice(2);
let heard;
globalThis.postMessage = (data) => heard(data);
await import(worker);
const told = [];
const asked = (message, ends) => new Promise((resolve, reject) => {
  heard = (data) => {
    told.push(data);
    if (data.missing ?? data.failure) reject(new Error(data.missing ?? data.failure));
    if (ends(data)) resolve(data);
  };
  self.onmessage({ data: message });
});
const bytes = new Uint8Array(readFileSync(code));
await asked({ base: `${folder}/`, code: bytes }, (data) => data.state === "");
const answers = {};
for (const [name, text] of Object.entries(JSON.parse(readFileSync(texts, "utf-8"))))
  answers[name] = (await asked({ text, left: [] }, (data) => data.answer)).answer;
const open = await asked({ text: "$a = 1$ and $$a = 2$$", left: [1] }, (data) => data.answer);
process.stdout.write("\\n" + JSON.stringify({ answers, told, open: open.answer }));
process.exit(0);
"""


@pytest.mark.skipif(NODE is None, reason="node is missing")
@pytest.mark.skipif(
    not (PYODIDE / "pyodide.mjs").is_file(),
    reason="RIGIDTOP_PYODIDE names no folder with Pyodide's release",
)
def test_outcomes_in_pyodide_are_those_of_the_command(tmp_path, capsys):
    (tmp_path / "harness.mjs").write_text(HARNESS, "utf-8")
    shutil.copy(FOLDER / "worker.js", tmp_path / "worker.mjs")
    (tmp_path / "rigidtop.zip").write_bytes(package())
    texts = TEXTS | ({"numbered": NUMBERED} if any(PYODIDE.glob("scipy-*.whl")) else {})
    (tmp_path / "texts.json").write_text(json.dumps(texts), "utf-8")
    names = ("harness.mjs", "worker.mjs", "rigidtop.zip")
    words = [NODE, *(str(tmp_path / x) for x in names), str(PYODIDE.resolve())]
    done = subprocess.run(
        [*words, str(tmp_path / "texts.json")], capture_output=True, text=True, timeout=280
    )
    assert done.returncode == 0, done.stderr[-2000:]
    found = json.loads(done.stdout.splitlines()[-1])
    for name, text in texts.items():
        file = tmp_path / f"{name}.md"
        file.write_text(text, "utf-8")
        code = main(["audit", str(file), "--json"])
        assert found["answers"][name]["outcomes"] == json.loads(capsys.readouterr().out), name
        assert found["answers"][name]["isWrong"] == (code == 1), name
        assert found["answers"][name] == answer(text), name
    assert [x["line"] for x in found["told"] if "line" in x][:7] == [1, 1, 3, 7, 11, 13, 15]
    assert [x["verdict"] for x in found["open"]["outcomes"]] == ["definition", "undecided"]


def answer(text, left=()):
    return json.loads(Desk().answer(text, left, lambda *_: None))


# --- Python's side -------------------------------------------------------------------------------

ALONE = """
import json, signal, sys
sys.path.insert(0, sys.argv[1])
for name in ("scipy", "matplotlib", "multiprocessing", "rigidtop.web", "rigidtop.figures"):
    sys.modules[name] = None  # importing it fails
del signal.setitimer
# Where rigidtop is installed to be edited, parts that are left out come from there.
sys.meta_path = [x for x in sys.meta_path if "editable" not in getattr(x, "__module__", "")]
import rigidtop
assert rigidtop.__file__.startswith(sys.argv[1])
from rigidtop.commands.browser import Desk
print(json.dumps([json.loads(Desk().answer(text, [], print)) for text in json.loads(sys.argv[2])]))
"""


def test_what_the_page_brings_judges_without_signals_and_processes(tmp_path):
    with ZipFile(BytesIO(package())) as archive:
        assert {name.split("/")[0] for name in archive.namelist()} == {"rigidtop"}
        assert not [name for name in archive.namelist() if name.endswith(".pyc")]
        archive.extractall(tmp_path)
    texts = list(TEXTS.values())
    done = subprocess.run(
        [sys.executable, "-c", ALONE, str(tmp_path), json.dumps(texts)],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    assert json.loads(done.stdout.splitlines()[-1]) == [answer(text) for text in texts]


def test_the_same_files_make_the_same_package():
    assert package() == package()


def test_what_is_wrong_comes_with_its_line_and_the_right_one():
    found = answer(EXAMPLE)
    assert found["summary"] == (
        "5 formulas: 3 compared with what stands above, 1 wrong; 2 say something new"
    )
    root = ElementTree.fromstring(f"<ol>{found['wrong']}</ol>")
    assert len(root) == 1
    assert [x.get("data-line") for x in root.iter("button")] == ["11", "3"]
    words = " ".join("".join(root.itertext()).split())
    assert "it holds with another sign" in words
    alternatives = [x.get("alttext") for x in root.iter() if x.tag.endswith("}math")]
    assert alternatives == [
        r"l\ddot\theta = g\sin\theta",
        r"l \ddot{\theta} = -g \sin \theta",
        r"L = \tfrac12 m l^2\dot\theta^2 + m g l\cos\theta",
    ]
    lines = ElementTree.fromstring(f"<ol>{found['lines']}</ol>")
    assert [x.find(".//button").text for x in lines] == [
        f"line {number}" for number in (3, 7, 11, 13, 15)
    ]


def test_before_each_statement_the_page_is_told():
    told = []
    desk = Desk()
    desk.answer(EXAMPLE, [], lambda *each: told.append(each))
    assert told == [(k, line, k + 1, 7) for k, line in enumerate((1, 1, 3, 7, 11, 13, 15))]
    told.clear()
    desk.answer(EXAMPLE.replace(r"g\sin", r"-g\sin"), [], lambda *each: told.append(each))
    assert [line for _, line, _, _ in told] == [11, 13, 15]


def test_what_took_too_long_is_left_open():
    found = answer(EXAMPLE, [4])
    assert [x["verdict"] for x in found["outcomes"]] == [
        *("definition", "sampled", "undecided", "premise", "assuming")
    ]
    assert found["outcomes"][2]["note"] == f"judging it takes longer than {SECONDS} s"
    assert not found["isWrong"]
    assert found["wrong"] == ""
    assert found["summary"] == (
        "5 formulas: 2 compared with what stands above, none wrong; 2 say something new; 1 is open"
    )


def test_a_text_without_formulas_is_not_called_right():
    assert answer("Nothing to see here.") == {"error": NOTHING}


def test_what_a_text_says_is_no_html():
    found = answer("$x = 1$, $<script>alert(1)</script> = \\text{<b>}$ and $\\strange{<i>} = 2$")
    html = found["wrong"] + found["lines"]
    assert "<script" not in html
    assert "<b>" not in html
    assert "<i>" not in html
    ElementTree.fromstring(f"<ol>{html}</ol>")


# --- The page ------------------------------------------------------------------------------------


def test_the_page_is_whole_and_may_speak_with_nobody_else():
    made = page(SECONDS)
    ElementTree.fromstring(made.removeprefix("<!DOCTYPE html>\n"))
    ids = re.findall(r'\bid="([^"]+)"', made.split("<body>")[1])
    assert len(ids) == len(set(ids))
    policy = re.search(r'Content-Security-Policy" content="([^"]+)"', made)[1]
    rules = dict(rule.strip().split(" ", 1) for rule in policy.split(";"))
    assert rules["default-src"] == "'none'"
    assert rules["connect-src"] == "'self'"
    assert rules["form-action"] == "'none'"
    far = page(SECONDS, "https://example.org/pyodide/full")
    assert "connect-src 'self' https://example.org;" in far
    assert '"base":"https://example.org/pyodide/full/"' in far


@pytest.mark.parametrize("base", ["", "javascript:x", "file:///tmp", "a b", "https:///x", "x;y"])
def test_what_is_no_address_is_refused(base):
    with pytest.raises(RigidtopError, match="is no address"):
        page(SECONDS, base)


STAND_IN = """
window.asked = []; window.ended = 0;
window.Worker = class {
  constructor() { window.worker = this; }
  postMessage(data) {
    const say = (data) => setTimeout(() => this.onmessage({ data }));
    if (data.base) { say({ state: "Loading Pyodide" }); say({ state: "" }); return; }
    asked.push(data);
    if (window.slow && !data.left.length) say({ number: 4, line: 11, nth: 5, count: 7 });
    else say({ answer: ANSWER });
  }
  terminate() { ended += 1; }
};
"""


@pytest.fixture
def sheet(live):
    """Opens the page with a stand-in for the worker, which has the answer to the example."""
    source = STAND_IN.replace("ANSWER", json.dumps(answer(EXAMPLE)))
    script = live.cdp("Page.addScriptToEvaluateOnNewDocument", source=source)

    def opened(seconds=SECONDS):
        live.write("check", page(seconds))
        live.open("check", ready="document.querySelector('#numbers span')")
        return live

    yield opened
    live.cdp("Page.removeScriptToEvaluateOnNewDocument", **script)


def checked(live):
    live.find("#check").click()
    live.wait("document.querySelector('#summary').textContent")


def test_the_page_shows_what_is_wrong_first(sheet):
    live = sheet()
    checked(live)
    assert live.js("asked") == [{"text": EXAMPLE, "left": []}]
    assert live.find("#summary").text == answer(EXAMPLE)["summary"]
    wrong, *more = live.all("#wrong li.audited")
    assert not more
    assert wrong.text.startswith("l")
    assert "it holds with another sign" in wrong.text
    assert [x.text for x in live.all("#numbers .amiss")] == ["11"]
    assert len(live.all("#lines li")) == 5
    assert live.js("document.activeElement.id") == "content"
    assert live.js("document.querySelector('#wrong').offsetTop"
                   " < document.querySelector('#lines').offsetTop")  # fmt: skip
    live.find("#wrong .place").click()
    selected = "((x) => x.value.slice(x.selectionStart, x.selectionEnd))(document.activeElement)"
    assert live.js(selected) == r"$$l\ddot\theta = g\sin\theta.$$"


def test_outcomes_of_a_text_that_has_changed_say_so(sheet):
    live = sheet()
    live.js("void (window.slow = true)")
    live.find("#check").click()
    live.wait("document.querySelector('#status').textContent.startsWith('Line 11 is judged, 5 of')")
    live.find("#text").send_keys("more")
    live.js(f"worker.onmessage({{ data: {{ answer: {json.dumps(answer(EXAMPLE))} }} }})")
    assert live.find("#status").text.startswith("The text has changed")
    assert not live.all("#numbers .amiss")


def test_a_line_that_takes_too_long_is_left_open_by_a_new_worker(sheet):
    live = sheet(0.2)
    live.js("void (window.slow = true)")
    live.driver.execute_script(
        "window.words = []; const status = document.querySelector('#status');"
        "new MutationObserver(() => words.push(status.textContent))"
        ".observe(status, { childList: true });"
    )
    checked(live)
    assert any("Line 11 takes longer than 0.2 s and is left open" in x for x in live.js("words"))
    assert live.js("asked.map((each) => each.left)") == [[], [4]]
    assert live.js("ended") == 1


def test_it_can_be_stopped(sheet):
    live = sheet()
    live.js("void (window.slow = true)")
    live.find("#check").click()
    live.wait("document.querySelector('#status').textContent.startsWith('Line 11')")
    live.find("#stop").click()
    assert live.find("#status").text == "Stopped while line 11 was judged."
    assert live.js("ended") == 1
    assert live.find("#check").is_enabled()
    assert not live.find("#stop").is_displayed()


def test_keys_check_too_and_all_has_names(sheet):
    from selenium.webdriver.common.keys import Keys

    live = sheet()
    live.find("#text").send_keys(Keys.CONTROL, Keys.ENTER)
    live.wait("document.querySelector('#summary').textContent")
    assert live.find("#text").accessible_name.startswith("Your text, Markdown or LaTeX")
    assert live.find("#content").accessible_name == "Outcomes"
    assert live.find("#status").aria_role == "status"


def test_it_fits_a_phone(sheet, phone):
    live = sheet()
    checked(live)
    assert live.js("document.documentElement.scrollWidth") == 390
    small = [x.text for x in live.all("button") if x.is_displayed() and x.size["height"] < 24]
    assert small == []


def test_without_pyodide_the_page_says_how_to_get_it(live):
    live.write("check", page(SECONDS))
    live.open("check", ready="document.querySelector('#numbers span')")
    live.find("#check").click()
    live.wait("document.querySelector('#status code')")
    words = live.find("#status").text
    assert words.startswith("Pyodide, which runs Python in a browser, is not found at pyodide/: ")
    assert f"save this page in a folder, run there {FETCH} (about 400 MB)" in words
    assert "python -m http.server 8000" in words
    assert "http://localhost:8000/check.html" in words
    assert live.find("#check").is_enabled()
    live.complaints()  # the browser logs what is not there
