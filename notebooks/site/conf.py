"""The site of the documentation: ``sphinx-build -W notebooks/site out/site``.

The lecture on it is what `rigidtop lecture` writes; one that stands already is taken from the
folder that RIGIDTOP_LECTURE names.
"""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

from docutils import nodes
from latex2mathml.converter import convert

from rigidtop.cli import main

HERE = Path(__file__).parent
project = "rigidtop"
copyright = "the authors of rigidtop, BSD-3-Clause"
extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.viewcode",
    "sphinx_gallery.gen_gallery",
]
exclude_patterns = ["gallery/*", "figures/*.ipynb", "**/sg_execution_times.rst", "lecture/*"]
nb_execution_mode = "off"
myst_enable_extensions = ["dollarmath", "deflist", "attrs_inline"]
myst_heading_anchors = 3

html_theme = "furo"
html_title = "rigidtop"
html_static_path: list[str] = []
html_show_sphinx = False
html_math_renderer = "mathml"

# Docstrings mark code by single backticks.
default_role = "code"
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_inherit_docstrings = False

sphinx_gallery_conf = {
    "examples_dirs": ["gallery"],
    "gallery_dirs": ["figures"],
    "filename_pattern": r"\.py$",
    "download_all_examples": False,
    "remove_config_comments": True,
    "show_signature": False,
    "min_reported_time": 1e9,
    "within_subsection_order": "FileNameSortKey",
}


# The notebooks with what they show, as they stand.
shutil.copytree(HERE.parent / "teacher", HERE / "notebooks", dirs_exist_ok=True)


def lecture() -> str:
    """The folder with lecture.html, written if it does not stand."""
    given = os.environ.get("RIGIDTOP_LECTURE")
    folder = Path(given).resolve() if given else HERE / "lecture"
    if not (folder / "lecture.html").is_file() and main(["lecture", "-o", str(folder)]):
        raise SystemExit("rigidtop lecture failed")
    return str(folder / "lecture.html")


html_extra_path = [lecture()]


def _inline(writer, node):
    writer.body.append(convert(node.astext()))
    raise nodes.SkipNode


def _block(writer, node):
    writer.body.append(convert(node.astext(), display="block"))
    raise nodes.SkipNode


def _as_it_stands(app, what, name, obj, options, lines):
    """|ω₃| and a*b in a docstring's words are no markup of reStructuredText."""
    example = False
    for k, line in enumerate(lines):
        example = line.lstrip().startswith(">>>") or (example and bool(line.strip()))
        if not example:
            parts = line.split("`")
            parts[::2] = [re.sub(r"([|*])", r"\\\1", part) for part in parts[::2]]
            lines[k] = "`".join(parts)


def setup(app):
    # Formulas as MathML, which browsers draw without a script and without a network.
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
    app.connect("autodoc-process-docstring", _as_it_stands)
