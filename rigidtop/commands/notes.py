"""Notes with everything that an audit finds in them: what every door to it tells."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from rigidtop.commands.findings import (
    AuditFinding,
    absent,
    of_claim,
    of_place,
    of_rows,
    placing,
)
from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.judge.text import Row
    from rigidtop.mark.numbered import Copy
    from rigidtop.read.macros import Macros
    from rigidtop.read.project import TextFile

    Judging = Callable[[str, Macros, float], tuple[Row, ...]]


class NoFormulasError(RigidtopError):
    """A file in which no formula says anything."""


@dataclass(frozen=True)
class Notes:
    """The files of some notes, the first one that was named, and what is found in them.

    `copies` are the equations under numbers of the collection.
    """

    files: tuple[TextFile, ...]
    copies: tuple[Copy, ...]
    findings: tuple[AuditFinding, ...]

    @property
    def source(self) -> TextFile:
        return self.files[0]

    @cached_property
    def macros(self) -> Macros:
        from rigidtop.read.project import macros_of

        return macros_of(self.files)

    @property
    def is_wrong(self) -> bool:
        """Whether anything in the notes is wrong."""
        return any(each.is_wrong for each in self.findings)


def audited(
    files: tuple[TextFile, ...], collection: Collection, judge: Judging | None = None
) -> Notes:
    """Files that belong together, judged by themselves and by a collection.

    `judge` finds the outcomes of a text; that of a text that changes knows those of the last one.
    Raises NoFormulasError where no formula says anything.
    """
    from rigidtop.commands.mark import subject_of
    from rigidtop.judge.text import judged
    from rigidtop.mark.held import held
    from rigidtop.mark.numbered import SECONDS, Numbers, copies, in_its_letters, missing
    from rigidtop.read.document import numbered, problems
    from rigidtop.read.project import left_out, macros_of, whole
    from rigidtop.read.walk import places

    until = time.process_time() + SECONDS
    source, text, macros = files[0].text, whole(files), macros_of(files)
    place = places(source)
    rows = (judge or judged)(text.text, macros, until)
    own: tuple[Copy, ...] = ()
    others = [*rows]
    if numbered(text.text):  # only for these the collection has to be read
        subject = subject_of(collection)
        numbers = Numbers(collection.pages, subject, collection.letters)
        own = in_its_letters(copies(rows, text.text, numbers, macros, until), subject)
        covered = {line.row.number for each in own for line in each.lines}
        others = [row for row in rows if row.number not in covered]
        others = [*held(others, subject, until)] if own else others
    findings = [
        *(of_claim(each, placing(text, files[0])) for each in own),
        *(of_place(place(p.position)[0], p.reason) for p in problems(source) if not p.skipped),
        *(
            of_place(places(each.text)(at)[0], why, each.path.name if len(files) > 1 else "")
            for each in files
            for at, why in left_out(each, files)
        ),
        *of_rows(others, rows, text, files[0]),
    ]
    if not findings:
        named = files[0].path
        raise NoFormulasError(
            f"{named}: no formulas between dollars or the like that say something"
        )
    findings += map(absent, missing(own, collection.pages))
    return Notes(files, own, tuple(findings))
