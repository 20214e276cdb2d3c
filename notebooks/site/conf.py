"""The site of the documentation: ``sphinx-build -W notebooks/site out/site``.

The lecture on it, with a page for each claim, is what `rigidtop lecture` writes into the folder
``lecture``.
"""

from __future__ import annotations

import re
import shutil
from importlib import import_module
from pathlib import Path

from rigidtop.cli import main
from rigidtop.collection.chapters import chapter, chapters

HERE = Path(__file__).parent
project = "rigidtop"
copyright = "the authors of rigidtop, BSD-3-Clause"
extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx-mathjax-offline",
    "sphinx.ext.viewcode",
    "sphinx_gallery.gen_gallery",
]
exclude_patterns = ["gallery/*", "figures/*.ipynb", "**/sg_execution_times.rst"]
nb_execution_mode = "off"
nb_render_markdown_format = "myst"
myst_enable_extensions = ["dollarmath", "deflist", "attrs_inline"]
myst_heading_anchors = 3

html_theme = "furo"
html_title = "rigidtop"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_theme_options = {"top_of_page_buttons": []}

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
    "capture_repr": (),  # what an example prints, and no object that its last line happens to give
    "show_signature": False,
    "min_reported_time": 1e9,
    "within_subsection_order": "FileNameSortKey",
}


# The notebooks with what they show, as they stand.
shutil.copytree(HERE.parent / "teacher", HERE / "notebooks", dirs_exist_ok=True)


LECTURE = HERE / "lecture"
BESIDE = LECTURE / "beside"
"""Pages that stand beside those of Sphinx, as they are."""


CHAPTERS = """\
# Chapters

Collections of pages that come with rigidtop.  Every line is judged as in the lecture, and each one
is a start for a chapter of your own: `rigidtop new --from kepler my_chapter` copies it.
"""


def written(*words: str) -> None:
    """What a command of rigidtop writes."""
    if main([*words]):
        raise SystemExit(f"rigidtop {' '.join(words)} failed")


written("lecture", "--format", "myst", "--live", "-o", str(LECTURE))
shutil.rmtree(BESIDE, ignore_errors=True)
for name, kind, preset in (("top", "heavy-top", "loops"), ("free", "free", "flip")):
    (BESIDE / name).mkdir(parents=True)
    written("web", kind, "--preset", preset, "-o", str(BESIDE / name / "index.html"))
written("web", "check", "-o", str(BESIDE / "check.html"))
shutil.copy(LECTURE / "lecture.html", BESIDE)
(BESIDE / "chapters").mkdir()
doors = []
for name in chapters():
    written("lecture", str(chapter(name)), "--no-live", "-o", str(LECTURE / "chapters" / name))
    shutil.copy(LECTURE / "chapters" / name / "lecture.html", BESIDE / "chapters" / f"{name}.html")
    told = import_module(f"rigidtop.chapters.{name}")
    doors.append(f'- <a href="../chapters/{name}.html">{told.TITLE}</a>: {told.SUBTITLE}')
(LECTURE / "chapters.md").write_text(f"{CHAPTERS}\n{chr(10).join(doors)}\n", "utf-8")
html_extra_path = [str(BESIDE)]

# Sphinx takes the order of pages from trees of contents, where mystmd has a file.
pages = re.findall(r"- file: (\S+)\.md", (LECTURE / "myst" / "myst.yml").read_text("utf-8"))
for above, inside in (("index", "[^/]+"), ("claims", "claims/.+")):
    below = [page for page in pages[1:] if re.fullmatch(inside, page)]
    with (LECTURE / "myst" / f"{above}.md").open("a", encoding="utf-8") as file:
        print("\n```{toctree}\n:hidden:\n", *below, "```", sep="\n", file=file)


def _as_it_stands(app, what, name, obj, options, lines):
    """|ω₃| and a*b in a docstring's words are no markup of reStructuredText."""
    example = False
    for k, line in enumerate(lines):
        example = line.lstrip().startswith(">>>") or (example and bool(line.strip()))
        if not example:
            parts = line.split("`")
            parts[::2] = [re.sub(r"([|*])", r"\\\1", part) for part in parts[::2]]
            lines[k] = "`".join(parts)


LABELS = {
    'class="caption" role="heading"': 'class="caption" role="heading" aria-level="2"',
    '<aside class="sidebar-drawer">': '<aside class="sidebar-drawer" aria-label="Site">',
    '<aside class="toc-drawer': '<aside aria-label="On this page" class="toc-drawer',
    "<pre>": '<pre tabindex="0">',  # what is wide scrolls, also by the keys
}
"""What the theme leaves without a name, for those who hear the page."""


def _labelled(app, error):
    for page in [] if error else Path(app.outdir).rglob("*.html"):
        words = page.read_text("utf-8")
        if 'id="furo-main-content"' in words:
            for bare, named in LABELS.items():
                words = words.replace(bare, named)
            page.write_text(words, "utf-8")


def setup(app):
    app.connect("autodoc-process-docstring", _as_it_stands)
    app.connect("build-finished", _labelled)
