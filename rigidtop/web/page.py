"""One self-contained page: markup, style, modules, three.js and the data, in one file."""

from __future__ import annotations

import gzip
import json
import re
from base64 import b64encode
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from html import escape
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import Any

from scipy.integrate import DOP853

from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import Motion
from rigidtop.web import terms
from rigidtop.web.presets import PRESETS
from rigidtop.web.setup import FREE, HEAVY, Preset, setup_of
from rigidtop.web.sliders import Slider, sliders
from rigidtop.web.tours import TOURS

FOLDER = Path(__file__).parent / "live-page"
THREE = "static/r130/three.min.js"
TITLES = {HEAVY: "The heavy top, live", FREE: "The free body, live"}
TABLEAU = ("A", "B", "E3", "E5", "D", "A_EXTRA")


@dataclass(frozen=True)
class LivePage:
    """A page, as a file or in a notebook."""

    title: str
    html: str = field(repr=False)

    height: int = 760
    """In a notebook, pixels."""

    def _repr_html_(self) -> str:
        frame = "width:100%;border:0;background:#fff"
        return (
            f'<iframe title="{escape(self.title)}" srcdoc="{escape(self.html)}" '
            f'style="{frame};height:{self.height}px"></iframe>'
        )


def page(kind: str, first: Preset | None = None, height: int = LivePage.height) -> LivePage:
    """The page of a kind of body, which shows a preset of that kind first.

    Raises RigidtopError where three.js is not installed.
    """
    presets = PRESETS[kind]()
    preset = first or presets[0]
    title = TITLES[kind]
    text = json_text(data(kind, title, presets, preset))
    return LivePage(title, document(title, text), height)


def document(title: str, text: str, main: str = "top", derived: str = "") -> str:
    """The page with the JSON of its data, its first module, and a module that those may import.

    Raises RigidtopError where three.js is wanted and not installed.
    """
    parts = {
        "title": escape(title),
        "main": main,
        "three": _packed(three()) if main == "top" else "",
        "style": "\n".join((FOLDER / f"{name}.css").read_text("utf-8") for name in STYLES),
        "importmap": json_text({"imports": dict(modules(main, derived))}),
        "data": text,
    }
    # In one pass: what is put in is not looked through again.
    template = (FOLDER / "page.html").read_text("utf-8")
    return re.sub(r"\{\{(\w+)\}\}", lambda place: parts[place[1]], template)


def _packed(script: str) -> str:
    packed = b64encode(gzip.compress(script.encode(), mtime=0)).decode()
    return f'<script type="text/plain" id="three">{packed}</script>'


STYLES = ("style", "panels")


def page_of(motion: Motion, height: int = LivePage.height) -> LivePage:
    """The page that shows a motion first.

    Raises RigidtopError for bodies that it doesn't know, and where three.js is not installed.
    """
    preset = own_preset(motion, "own", "Own motion", "The motion that was given.")
    return page(preset.setup.kind, preset, height)


def own_preset(motion: Motion, name: str, title: str, about: str) -> Preset:
    """A motion as an example of the page; raises RigidtopError for bodies that it doesn't know."""
    setup = setup_of(motion)
    rate = max(map(abs, motion.omega), default=0.0)
    rolls = setup.kind == FREE and motion.regime == "regular precession"
    layers = ("e3", "omega", "L", "cones" if rolls else "trail")
    wheel = "top" if setup.kind == HEAVY else "wheel"
    shape = wheel if setup.kind == HEAVY or motion.body.symmetric else "brick"
    # What turns ten times a second can't be followed, nor a body that turns in days.
    speed = 60 / rate if rate > 60 else 1 / rate if 0 < rate < 0.01 else 1.0
    return Preset(name, title, about, setup, layers, shape, speed=speed)


def three() -> str:
    """The source of three.js; RigidtopError where it is not installed."""
    try:
        return files("jupyter_threejs_sage").joinpath(THREE).read_text("utf-8")
    except (ModuleNotFoundError, FileNotFoundError):
        raise RigidtopError("the live page wants three.js: pip install 'rigidtop[web]'") from None


def modules(main: str = "top", derived: str = "") -> Iterator[tuple[str, str]]:
    """A module and all that it imports: the name that each is imported by, and a URL that holds it.

    A module whose own address is its text can't name others by where they lie, so "./motion.js"
    becomes "rigidtop/motion.js", which the import map knows.
    """
    texts = {"derived": derived}
    wanted = [main]
    while wanted:
        name = wanted.pop()
        if name not in texts:
            texts[name] = (FOLDER / f"{name}.js").read_text("utf-8")
            wanted += re.findall(_IMPORTED, texts[name])
    for name, text in sorted(texts.items()):
        linked = re.sub(_IMPORTED, r'from "rigidtop/\1.js"', text)
        named = f"{linked}//# sourceURL=rigidtop/{name}.js\n"
        if text:
            yield f"rigidtop/{name}.js", f"data:text/javascript;charset=utf-8,{_quoted(named)}"


_IMPORTED = r'from "\./(\w+)\.js"'


def _quoted(text: str) -> str:
    """What means something in a URL, escaped; the rest stays readable."""
    return re.sub(r"[%#\n\r\t]", lambda mark: f"%{ord(mark[0]):02X}", text)


def data(kind: str, title: str, presets: tuple[Preset, ...], first: Preset) -> Mapping[str, object]:
    """`PageData` of the page's types; what is not one of the presets stands behind them."""
    offered = presets if first in presets else (*presets, first)
    parameters = [_slider(each) for each in sliders(kind, (p.setup for p in offered))]
    return common(kind, title, parameters, offered, first) | {
        "equations": [_equation(each) for each in _equations(kind)],
        "tour": [vars(step) for step in TOURS[kind]()],
    }


def common(
    kind: str,
    title: str,
    parameters: Sequence[Mapping[str, Any]],
    presets: Sequence[Preset],
    first: Preset,
) -> dict[str, Any]:
    """`PageData` of any page, so far without equations and a tour."""
    return {
        "kind": kind,
        "version": version("rigidtop"),
        "title": title,
        "tableau": tableau(),
        "parameters": parameters,
        "presets": [_preset(p) for p in presets],
        "equations": [],
        "first": _preset(first),
        "tour": [],
    }


def tableau() -> dict[str, object]:
    """The coefficients of the Runge–Kutta method DOP853, for the page's script."""
    return {name: getattr(DOP853, name).tolist() for name in TABLEAU}


def _equations(kind: str) -> tuple[tuple[terms.TermsOf, bool | None], ...]:
    """The equations, and whether they are for symmetric bodies, for the others, or for all."""
    if kind == FREE:
        return tuple((each, None) for each in terms.free())
    symmetric = tuple((each, True) for each in terms.heavy())
    return symmetric + tuple((each, False) for each in terms.general())


def _equation(pair: tuple[terms.TermsOf, bool | None]) -> dict[str, object]:
    each, symmetric = pair
    names = ("text", "name", "unit", "arrow")
    return {
        "tag": each.equation.tag,
        **{name: getattr(each, name) for name in ("title", "mathml", "function")},
        "symmetric": symmetric,
        "terms": [{name: getattr(term, name) for name in names} for term in each.terms],
    }


def _slider(slider: Slider) -> dict[str, object]:
    own = {name: value for name, value in vars(slider).items() if name != "glyph"}
    seen = {"letter": slider.letter, "math": slider.math, "angle": slider.angle}
    return own | seen | {"unit": "" if slider.angle else slider.unit}


def _preset(preset: Preset) -> dict[str, object]:
    setup = {**vars(preset.setup), "values": dict(preset.setup.values)}
    return {**vars(preset), "setup": setup}


def json_text(value: object) -> str:
    """The value as JSON for a script element: no "<" in it."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c")
