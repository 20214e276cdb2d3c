"""The lecture as files, and one claim of it as a fragment to paste."""

from __future__ import annotations

from pathlib import Path

from rigidtop.errors import RigidtopError
from rigidtop.present import html, plain, tex, typst
from rigidtop.present.files import write_all
from rigidtop.present.pdf import make_pdf
from rigidtop.present.plots import FIGURES, rendered
from rigidtop.present.report import Judged, claim_blocks, document
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


def write_lecture(judged: Judged, out: Path | str, *, pdf: bool = False) -> list[Path]:
    """Write lecture.tex, lecture.html and figures/ into `out`, with `pdf` also lecture.pdf.

    Everything is made before anything is written, and each file is replaced only by a whole one.
    Raises RigidtopError, with one line, where the PDF cannot be made or the folder not written.
    """
    folder = Path(out)
    sections = {page.section for page, _ in judged}
    wanted = [(section, figure, draw) for section, figure, draw in FIGURES if section in sections]
    lecture = document(judged, [(section, figure) for section, figure, _ in wanted])
    names = [figure.name for _, figure, _ in wanted]
    svg = {figure.name: rendered(draw, "svg") for _, figure, draw in wanted}
    drawn = {f"figures/{figure.name}.pdf": rendered(draw, "pdf") for _, figure, draw in wanted}
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
