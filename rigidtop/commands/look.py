"""What is one's own in a printed lecture: its title and its author, its paper, its class."""

from __future__ import annotations

import argparse
from dataclasses import replace
from datetime import date
from typing import TYPE_CHECKING

from rigidtop.errors import RigidtopError
from rigidtop.terminal.files import text_of

if TYPE_CHECKING:
    from rigidtop.report.blocks import Look
    from rigidtop.report.front import Front

MOST_POINTS = 1000


def add_look(parser: argparse.ArgumentParser) -> None:
    """Add the options that make a printed lecture one's own."""
    group = parser.add_argument_group("what is your own")
    group.add_argument("--title", help="in place of the lecture's")
    group.add_argument("--author", help="beneath the title, and in the PDF")
    group.add_argument("--course", help="beneath the title")
    group.add_argument("--date", help="beneath the title, in any words, or today")
    group.add_argument("--paper", choices=["a4", "letter"], default="a4", help="(default: a4)")
    group.add_argument("--preamble", metavar="FILE", help="LaTeX to be added to the preamble")
    group.add_argument(
        "--class", dest="own_class", metavar="NAME", help="a LaTeX class in place of article"
    )
    group.add_argument("--points", type=float, metavar="N", help="that each exercise can bring")


def front_of(options: argparse.Namespace, front: Front) -> Front:
    """The first page with one's own title, author, course and date."""
    title, *lines = (_words(options, name) for name in ("title", "author", "course", "date"))
    if lines[-1] == "today":
        lines[-1] = date.today().isoformat()
    return replace(
        front,
        title=title or front.title,
        exercises=title or front.exercises,
        author=lines[0] or front.author,
        byline=", ".join(filter(None, lines)),
    )


def _words(options: argparse.Namespace, name: str) -> str:
    """What an option says, its formulas, in LaTeX between dollars, as sentences have them."""
    from rigidtop.notation import NOTES
    from rigidtop.read.page import Raw, pieces
    from rigidtop.typeset.words import parts, prose

    words: str | None = getattr(options, name)
    if words is None:
        return ""
    if not words.strip():
        raise RigidtopError(f"--{name} wants some words")
    words = " ".join(words.split())
    for is_maths, part in parts(words):
        if is_maths and any(isinstance(each, Raw) for each in pieces(f"${part}$", NOTES)):
            raise RigidtopError(f"--{name}: ${part}$ is not read as a formula")
    try:
        prose(words)
    except ValueError as error:
        raise RigidtopError(f"--{name}: {error}") from error
    return words


def look_of(options: argparse.Namespace) -> Look:
    """Paper, preamble and class; RigidtopError where one of them is none."""
    from rigidtop.report.blocks import Look
    from rigidtop.report.pdf import latexmk_for

    preamble = text_of(options.preamble) if options.preamble else ""
    own = options.own_class or ""
    if own and not own.replace("-", "").replace("_", "").isalnum():
        raise RigidtopError(f"--class wants the name of a LaTeX class, not {own!r}")
    look = Look(options.paper, preamble, own)
    if options.pdf:
        latexmk_for(look)  # before half a minute of work, not after it
    return look


def points_of(options: argparse.Namespace) -> str:
    """The points as they are printed at each exercise; "" for none."""
    from rigidtop.report.handout import counted

    if options.points is None:
        return ""
    if not 0 < options.points <= MOST_POINTS:  # nor is NaN
        raise RigidtopError(f"--points wants a number above 0, up to {MOST_POINTS}")
    return counted(options.points)
