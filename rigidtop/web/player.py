"""What plays the figures of a lecture in place: the live page once, and the motions of each."""

from __future__ import annotations

import gzip
from base64 import b64encode
from collections.abc import Mapping, Sequence
from pathlib import Path

from rigidtop.motion.motion import Motion
from rigidtop.web.page import TITLES, data, document, json_text, own_preset
from rigidtop.web.setup import Preset

FOLDER = Path(__file__).parent


def player(figures: Mapping[str, Sequence[Motion]]) -> str:
    """HTML for the end of a document's body, of the motions of its figures by their names.

    A figure is a ``figure`` element with its name as ``data-figure``.  The page needs no network;
    it is unpacked when a figure is first played.

    Raises RigidtopError where three.js is not installed.
    """
    presets: dict[str, list[Preset]] = {kind: [] for kind in TITLES}
    options: dict[str, list[tuple[str, str, str]]] = {}
    for name, motions in figures.items():
        regimes = [motion.regime for motion in motions]
        for number, motion in enumerate(motions, 1):
            words = "Play" if len(motions) == 1 else motion.regime.capitalize()
            if regimes.count(motion.regime) > 1:
                words += f" {number}"
            title = name.replace("-", " ").capitalize()
            preset = own_preset(motion, f"{name}-{number}", title, "The motion of the figure.")
            presets[preset.setup.kind].append(preset)
            options.setdefault(name, []).append((preset.setup.kind, preset.name, words))
    if not options:
        return ""
    page = gzip.compress(document("Live", "{{data}}").encode(), mtime=0)
    parts = [_json("live-motions", options)]
    for kind, group in presets.items():
        if group:
            parts.append(_json(f"live-{kind}", data(kind, TITLES[kind], tuple(group), group[0])))
    parts.append(f'<script type="text/plain" id="live-page">{b64encode(page).decode()}</script>')
    script = (FOLDER / "player.js").read_text("utf-8")
    style = _text(f"<style>{(FOLDER / 'player.css').read_text('utf-8')}</style>")
    script += f'\ndocument.head.insertAdjacentHTML("beforeend", {style});'  # a body has no style
    # The marks of CDATA are comments to a browser, and keep the page well-formed XML.
    parts.append(f"<script>/*<![CDATA[*/{script}/*]]>*/</script>")
    return "\n".join(parts) + "\n"


def _json(name: str, value: object) -> str:
    return f'<script type="application/json" id="{name}">{_text(value)}</script>'


def _text(value: object) -> str:
    """Data that neither HTML nor XML takes for markup."""
    return json_text(value).replace("&", "\\u0026").replace(">", "\\u003e")
