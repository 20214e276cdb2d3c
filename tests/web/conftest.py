"""The page's modules in an embedded JavaScript engine, and in a browser."""

from __future__ import annotations

import json
import re
import shutil
from functools import cache

import pytest

from rigidtop.web.page import FOLDER, data
from rigidtop.web.presets import PRESETS


class Engine:
    """Modules of the page, all their names global; values go in and come out as JSON."""

    def __init__(self, *names):
        self.context = pytest.importorskip("quickjs", reason="quickjs-ng is missing").Context()
        self.context.eval("globalThis.performance = { now: () => 0 };")
        for name in names:
            text = (FOLDER / f"{name}.js").read_text("utf-8")
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
    return Engine("equations", "dop853", "motion", "facts")


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
