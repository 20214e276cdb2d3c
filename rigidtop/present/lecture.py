"""The lecture as files, and one claim of it as a fragment to paste."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from rigidtop.errors import RigidtopError
from rigidtop.present import html, plain, tex, typst
from rigidtop.present.figures.catalog import FIGURES
from rigidtop.present.figures.drawing import Drawing, rendered
from rigidtop.present.files import write_all
from rigidtop.present.pdf import make_pdf
from rigidtop.present.report import Figure, Judged, claim_blocks, document
from rigidtop.proof.verdict import Judgement

FORMATS = ("text", "latex", "html", "typst")


def fragment(judgement: Judgement, format: str) -> str:
    """A claim as "text", "latex", "html" or "typst", with its derivation and its verdict."""
    blocks = claim_blocks(judgement, marks=format == "text")
    if format == "text":
        return plain.fragment(blocks)
    if format == "latex":
        return tex.fragment(blocks)
    if format == "html":
        return html.fragment(blocks)
    if format == "typst":
        return typst.fragment(blocks)
    raise RigidtopError(f"unknown format {format!r}: choose from {', '.join(FORMATS)}")


def described(drawing: Drawing, given: Mapping[str, float] | None = None) -> Figure:
    """A figure as the lecture's blocks know it, with parameters as `given` or by default."""
    values = drawing.values(given)
    return Figure(drawing.name, drawing.caption(**values), drawing.alternative(**values))


def write_lecture(judged: Judged, out: Path | str, *, pdf: bool = False) -> list[Path]:
    """Write lecture.tex, lecture.html and figures/ into `out`, with `pdf` also lecture.pdf.

    Everything is made before anything is written, and each file is replaced only by a whole one.
    Raises RigidtopError, with one line, where the PDF cannot be made or the folder not written.
    """
    folder = Path(out)
    sections = {page.section for page, _ in judged}
    wanted = [drawing for drawing in FIGURES if drawing.section in sections]
    lecture = document(judged, [(drawing.section, described(drawing)) for drawing in wanted])
    names = [drawing.name for drawing in wanted]
    svg = {drawing.name: rendered(drawing, "svg") for drawing in wanted}
    drawn = {f"figures/{drawing.name}.pdf": rendered(drawing, "pdf") for drawing in wanted}
    vectors = {f"figures/{name}.svg": content for name, content in svg.items()}
    source = tex.write(lecture, {name: f"figures/{name}.pdf" for name in names})
    page = html.write(lecture, {name: content.decode() for name, content in svg.items()})
    contents = {**drawn, **vectors, "lecture.tex": source.encode(), "lecture.html": page.encode()}
    if pdf:
        paths = {name: f"figures/{name}.svg" for name in names}
        contents["lecture.pdf"] = make_pdf(
            lambda: source, lambda: typst.write(lecture, paths), {**drawn, **vectors}
        )
    return write_all(folder, contents)
