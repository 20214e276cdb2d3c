"""The claims of a collection and of its exercises, as commands ask for them."""

from __future__ import annotations

import gc
import os
import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rigidtop.errors import RigidtopError
from rigidtop.terminal.progress import over

if TYPE_CHECKING:
    from rigidtop import collection as collections
    from rigidtop.proof.lecture import Lecture
    from rigidtop.proof.letters import Letters
    from rigidtop.proof.page import Claim, Page
    from rigidtop.proof.verdict import Judgement

FAILED = 1
"""The exit code where a check failed."""


FOLDER = "a folder with a collection of one's own, such as my_course/, may stand first"
"""What commands say of their words."""

_SECTION = re.compile(r"\d+(\.\d+\.\d+(\.\d+)*)?")
"""What can be a section's number alone, unlike 3.5, which could be an equation's."""


def prepare() -> None:
    """Before SymPy is imported by a command that judges a whole lecture, and then ends.

    It asks for the same sums and products again and again; who has set a size keeps it.  Its
    expressions live on: to walk them again and again finds no cycle.
    """
    os.environ.setdefault("SYMPY_CACHE_SIZE", "None")
    gc.set_threshold(500_000, 10, 1000)


def every(collection: collections.Collection) -> list[tuple[Page, Claim]]:
    """The claims of the lecture in reading order, each with its page."""
    return [(page, claim) for page in collection.pages for claim in page.claims]


def named(collection: collections.Collection, names: Sequence[str]) -> list[tuple[Page, Claim]]:
    """The claims of these names and sections, in reading order; (3.57) is 3.57."""
    claims = every(collection)
    bare_names = {claim.name for _, claim in claims}
    if not all(collection.section(name) or name.strip("()") in bare_names for name in names):
        claims = collection.claims()
        bare_names = {claim.name for _, claim in claims}
    wanted: set[str] = set()
    for name in names:
        bare, pages = name.strip("()"), collection.section(name)
        if bare not in bare_names and not pages:
            raise RigidtopError(_unknown(collection, name, bare_names))
        # An equation's number is none of a section.
        wanted |= {bare} if bare in bare_names else {c.name for page in pages for c in page.claims}
    return [(page, claim) for page, claim in claims if claim.name in wanted]


def _unknown(collection: collections.Collection, name: str, names: Iterable[str]) -> str:
    """What is said of a name that no claim has: what may be meant, or where names are found."""
    from difflib import get_close_matches

    if _SECTION.fullmatch(name):
        return f"no section {name!r}; there are {', '.join(p.section for p in collection.pages)}"
    problem = f"no equation or claim {name!r}"
    elsewhere = _elsewhere(collection)
    if name in elsewhere:
        return f"{problem}; did you mean {elsewhere[name]}?"
    near = get_close_matches(name, {*names, *elsewhere}, n=3, cutoff=0.5)
    if near:
        return f"{problem}; did you mean {' or '.join(elsewhere.get(each, each) for each in near)}?"
    if name and Path(name).is_dir():
        return f"{problem}; the folder of this name has no __init__.py"
    listing = f"{problem}; `{collection.command('list')}` names "
    if len(collection.claims()) == len(every(collection)):
        return f"{listing}them all"
    return f"{listing}those of the lecture, `{collection.command('exercise')} NAME` an exercise's"


def _elsewhere(collection: collections.Collection) -> dict[str, str]:
    """Names of what is no claim, with the commands that ask for it."""
    hints = {e.name: f"`{collection.command('exercise')} {e.name}`" for e in collection.exercises}
    if collection.folder is None:
        from rigidtop.figures.catalog import FIGURES

        hints = {figure.name: f"`rigidtop figure {figure.name}`" for figure in FIGURES} | hints
    return hints


def judged(
    claims: Sequence[tuple[Page, Claim]], letters: Letters, lecture: Lecture | None = None
) -> Iterator[tuple[Page, Judgement]]:
    """Judge one claim after the other, with the lines of a lecture that lead to it."""
    from rigidtop.proof.verdict import judge

    for page, claim in over("judging", claims):
        yield page, judge(claim, page.section, lecture, letters, written=bool(page.text))


def faults(lecture: Lecture) -> list[str]:
    """What is wrong with the pages besides lines that do not follow, each with file and line."""
    wrong = [*lecture.unread(), *lecture.faults()]
    return [f"{file}, line {at}: {problem}" for file, at, problem in wrong]


def gaps(lecture: Lecture, ids: Collection[str] | None = None) -> list[str]:
    """Which of these lines, or of all, do not follow, each with file and line and the reason."""
    from rigidtop.report.ways import gap

    return [gap(each, lecture.letters) for each in lecture.gaps(ids)]


def summary(
    judgements: Sequence[Judgement],
    lecture: Lecture | None,
    ids: Collection[str] | None = None,
    more: str = "",
) -> str:
    """Counts of the verdicts and of these lines, or of all, and what did not pass.

    What is amiss besides is said by `more`.
    """
    from rigidtop.proof.verdict import Verdict

    counts = [(verdict.value, sum(j.verdict is verdict for j in judgements)) for verdict in Verdict]
    verdicts = ", ".join(f"{count} {name}" for name, count in counts if count)
    parts = [f"{counted(len(judgements), 'claim')}: {verdicts}" if judgements else "no claims"]
    wrong = 0
    if lecture is not None:
        lines, gaps = len(lecture.lines if ids is None else ids), len(lecture.gaps(ids))
        amiss = len(faults(lecture))
        wrong = gaps + amiss
        ends = "s" * ((gaps or lines) == 1)
        does = f"of {counted(lines, 'line')} {gaps} do{'es' * bool(ends)} not follow"
        parts += [does if gaps else f"{counted(lines, 'line')} follow{ends}"] if lines else []
        parts += [counted(amiss, "fault")] if amiss else []
    else:
        parts.append("lines were not judged")
    parts += [more] if more else []
    if failed := [j.claim.name for j in judgements if not j.passed]:
        parts.append(f"NOT PASSED: {', '.join(failed)}")
    else:
        parts.append("NOT PASSED" if wrong or more else "nothing failed that the notes get right")
    return "; ".join(parts)


def counted(count: int, what: str) -> str:
    """How many there are of what: 1 line, 2 lines."""
    return f"{count} {what}{'s' * (count != 1)}"
