"""What is wrong with a page as it is written: links to nowhere, and what no document can set."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

from rigidtop.notation.characters import unwritable
from rigidtop.proof.lecture import Fault, Lecture, Text
from rigidtop.read.tables import rows

EMPTY = "the page is empty: it has neither words nor displays"

_LINK = re.compile(r"(?<!!)\[[^\[\]]*\]\([\w./-]*#([^()\s]+)\)")  # a picture is no link
_PLACE = re.compile(r'<a id="([\w.-]+)"></a>')
_HEADING = re.compile(r"^#+[ \t]+(.+?)[ \t]*$", re.M)


def places(source: str) -> Iterator[str]:
    """Where a link into a page can lead: its anchors, and its headings as code hosts call them.

    >>> [*places('# 1 The pendulum\\n\\n<a id="from-energy"></a>')]
    ['from-energy', '1-the-pendulum']
    """
    yield from _PLACE.findall(source)
    for words in _HEADING.findall(source):
        yield re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")


def faults(source: str, there: Collection[str]) -> Iterator[Fault]:
    """Links to what is not `there`, and characters that no document can set, line by line."""
    tabled = {row.line for row in rows(source)}  # letters are judged where they are declared
    for at, line in enumerate(source.split("\n"), 1):
        for place in _LINK.findall(line):
            if place not in there:
                yield Fault(at, f"nothing has the name #{place}, to which a link leads")
        if at not in tabled:
            yield from (Fault(at, strange(each)) for each in unwritable(line))


def strange(character: str) -> str:
    """What is said of a character that no document can set."""
    return f"no document can set {character!r} (U+{ord(character):04X})"


def is_empty(source: str) -> bool:
    """Whether a page has headings at most."""
    return not _HEADING.sub("", source).strip()


def with_faults(
    lecture: Lecture,
    sources: Iterable[tuple[str, str]],
    figures: Iterable[str] = (),
    besides: Sequence[tuple[str, Fault]] = (),
) -> Lecture:
    """A lecture whose texts have the faults of their `sources`, (name, text), and those `besides`.

    Links lead to any of them, and to `figures` by their names.
    """
    written = dict(sources)
    there = {place for source in written.values() for place in places(source)}
    there |= {f"figure-{name}" for name in figures}

    def read(text: Text) -> Text:
        more = [fault for name, fault in besides if name == text.name]
        more += faults(written[text.name], there) if text.name in written else ()
        return replace(text, faults=(*text.faults, *more)) if more else text

    return replace(lecture, texts=tuple(map(read, lecture.texts)))
