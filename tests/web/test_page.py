"""The file that is written: whole, self-contained, and what its data say."""

from __future__ import annotations

import gzip
import json
import re
from base64 import b64decode
from html.parser import HTMLParser
from urllib.parse import unquote

import numpy as np
import pytest
from scipy.integrate import DOP853

import rigidtop as rt
from rigidtop.typeset.text import text
from rigidtop.web import page as pages
from rigidtop.web import terms
from rigidtop.web.page import FOLDER, page, page_of
from rigidtop.web.presets import PRESETS, TOP

TRUSTED = ("controls.js", "equation_panel.js", "meter.js", "system.js")
"""What the package wrote is markup in these; nothing that a reader or an address says is."""

CONTROLLED = "default-src 'none'; script-src 'unsafe-inline' data:"


class Elements(HTMLParser):
    """Every start tag with its attributes, and the text of the scripts."""

    def __init__(self, html):
        super().__init__()
        self.tags, self.scripts, self.open = [], [], False
        self.feed(html)

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        self.open = tag == "script"
        if self.open:
            self.scripts.append([dict(attrs), ""])

    def handle_endtag(self, tag):
        self.open = False

    def handle_data(self, data):
        if self.open:
            self.scripts[-1][1] += data


@pytest.fixture(scope="module", params=PRESETS)
def written(request):
    return page(request.param).html


def data_of(html):
    (text_,) = [t for attrs, t in Elements(html).scripts if attrs.get("id") == "data"]
    return json.loads(text_)


def imports_of(html):
    (text_,) = [t for attrs, t in Elements(html).scripts if attrs.get("type") == "importmap"]
    return json.loads(text_)["imports"]


def test_nothing_is_loaded_from_elsewhere(written):
    elements = Elements(written)
    policy = [a["content"] for tag, a in elements.tags if a.get("http-equiv")]
    assert len(policy) == 1
    assert policy[0].startswith(CONTROLLED)
    assert "connect-src" not in policy[0]  # default-src 'none' stands for it
    for tag, attrs in elements.tags:
        for name in ("src", "href", "srcset", "action", "data", "poster"):
            target = attrs.get(name, "")
            assert not target or target.startswith(("#", "data:,")), (tag, target)
        assert not [name for name in attrs if name.startswith("on")], tag


def test_the_page_is_small_and_holds_three_js_whole(written):
    assert len(written.encode()) < 700_000
    (packed,) = [t for attrs, t in Elements(written).scripts if attrs.get("id") == "three"]
    assert gzip.decompress(b64decode(packed)).decode() == pages.three()


def test_no_own_module_asks_for_anything():
    calls = (
        r"\b(fetch|XMLHttpRequest|WebSocket|EventSource|sendBeacon|importScripts|eval|Function)\b"
    )
    for path in FOLDER.glob("*.js"):
        code = re.sub(r"(?s)/\*.*?\*/|//[^\n]*", "", path.read_text("utf-8"))
        assert not re.search(calls, code), path.name
        assert not re.search(r"https?://", code.replace("http://www.w3.org/", "")), path.name
        assert "innerHTML" not in code or path.name in TRUSTED, path.name


def test_every_module_is_there_as_it_lies_in_the_repository(written):
    imports = imports_of(written)
    there = {f"rigidtop/{path.name}" for path in FOLDER.glob("*.js")}
    assert set(imports) | set(dict(pages.modules("system"))) == there
    for path in (FOLDER / name.removeprefix("rigidtop/") for name in imports):
        url = imports[f"rigidtop/{path.name}"]
        start = "data:text/javascript;charset=utf-8,"
        assert url.startswith(start)
        text_ = unquote(url.removeprefix(start))
        back = text_.replace('"rigidtop/', '"./').rsplit("//# sourceURL", 1)[0]
        assert back == path.read_text("utf-8")
        for name in re.findall(r'(?m)^(?:import|\}) .*?"([^"]+)";$', text_):
            assert name in imports, (path.name, name)


def test_placeholders_are_gone_and_data_are_not_looked_through(written, monkeypatch):
    for name in ("title", "style", "three", "importmap", "data"):
        assert f"{{{{{name}}}}}" not in written
    monkeypatch.setitem(pages.TITLES, "free", "{{three}} <b>")
    made = page("free").html
    assert "<title>{{three}} &lt;b&gt;</title>" in made  # neither put in, nor markup
    assert data_of(made)["title"] == "{{three}} <b>"


def test_the_tableau_is_scipys(written):
    tableau = data_of(written)["tableau"]
    for name, values in tableau.items():
        assert np.array_equal(values, getattr(DOP853, name))


@pytest.mark.parametrize("group", [terms.heavy, terms.general, terms.free])
def test_terms_put_together_are_the_equation(group):
    for each in group():
        sides = [text(side) for side in each.equation.sides]
        found = [term.text for term in each.terms]
        rest = [found[0]]
        for part in found[1:]:
            rest.append(f"− {part[1:]}" if part.startswith("−") else f"+ {part}")
        right = " ".join(rest[1:]).removeprefix("+ ")
        assert [found[0], right] == [s for s in sides if s != "const"]
        marks = re.findall(r'data-term="(\d)"', each.mathml)
        assert marks == [str(k) for k in range(len(found))]
        assert all(term.name and term.unit for term in each.terms)


def test_a_motion_of_ones_own_comes_first_and_the_presets_after_it():
    motion = TOP.motion(theta=0.3, theta_dot=0.2, phi=1.0, phi_dot=0.5, psi=2.0, omega3=90.0)
    found = data_of(page_of(motion).html)
    assert found["presets"][-1] == found["first"]
    assert found["first"]["name"] == "own"
    assert found["first"]["speed"] == pytest.approx(60 / 90, rel=0.05)
    values = found["first"]["setup"]["values"]
    expected = {"theta": 0.3, "theta_dot": 0.2, "phi": 1.0, "phi_dot": 0.5, "psi": 2.0,
                "omega3": 90.0, "M": 0.8, "R": 0.6, "g": 9.81, "R1": 0.0, "R2": 0.0,
                "friction": 0.0}  # fmt: skip
    assert {name: values[name] for name in expected} == pytest.approx(expected, rel=1e-12)
    assert max(s["most"] for s in found["parameters"] if s["name"] == "omega3") == 90.0
    assert len(found["presets"]) == 10


def test_a_page_in_a_notebook_is_one_frame():
    made = page_of(rt.FreeBody(1, 2, 2.5).motion(omega=(0, 1, 0.1)), height=500)
    (frame,) = Elements(made._repr_html_()).tags
    assert frame[0] == "iframe"
    assert frame[1]["srcdoc"] == made.html
    assert frame[1]["style"].endswith("height:500px")
    assert frame[1]["title"] == "The free body, live"
    # Its half megabyte is not printed.
    assert repr(made) == "LivePage(title='The free body, live', height=500)"


def test_without_three_js_one_line_says_what_to_install(monkeypatch):
    monkeypatch.setattr(pages, "THREE", "static/none.js")
    with pytest.raises(rt.RigidtopError, match=r"pip install 'rigidtop\[web\]'"):
        page("free")


def test_show_displays_the_page(monkeypatch):
    import IPython.display

    shown = []
    monkeypatch.setattr("IPython.get_ipython", lambda: object())
    monkeypatch.setattr(IPython.display, "display", shown.append)
    motion = TOP.motion(theta=0.3, omega3=20.0)
    assert rt.show(motion, height=600) is None
    assert shown == [page_of(motion, 600)]


def test_show_outside_a_notebook_says_what_to_do():
    motion = TOP.motion(theta=0.3, omega3=20.0)
    with pytest.raises(rt.RigidtopError, match="`rigidtop web` writes the page as a file"):
        rt.show(motion)
    with pytest.raises(rt.RigidtopError, match="height must be a whole number from 1"):
        rt.show(motion, height=0)
