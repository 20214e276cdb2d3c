"""The claims of a collection and of its exercises, as commands ask for them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rigidtop.errors import RigidtopError
from rigidtop.progress import over

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.proof.page import Claim, Page
    from rigidtop.proof.verdict import Judgement

FAILED = 1
"""The exit code where a check failed."""


FOLDER = "a folder with a collection of one's own, such as my_course/, may stand first"
"""What commands say of their words."""


def every(collection: Collection) -> list[tuple[Page, Claim]]:
    """The claims of the lecture in reading order, each with its page."""
    return [(page, claim) for page in collection.pages for claim in page.claims]


def named(collection: Collection, names: Sequence[str]) -> list[tuple[Page, Claim]]:
    """The claims of these names, in reading order; (3.57) is 3.57."""
    claims = every(collection)
    sections = {page.section for page, _ in claims}
    of_sections = [claim.name for page, claim in claims if page.section in names]
    wanted = {name.strip("()") for name in names if name not in sections} | {*of_sections}
    if not wanted <= {claim.name for _, claim in claims}:
        claims += [*of_exercises(collection, claims), *of_conventions(collection)]
    known = [claim.name for _, claim in claims]
    for name in sorted(wanted - set(known)):
        from difflib import get_close_matches

        near = get_close_matches(name, known, n=3, cutoff=0.5)
        hint = f"`{collection.command('list')}` names them all"
        if near:
            hint = f"did you mean {' or '.join(near)}?"
        elif Path(name).is_dir():
            hint = "the folder of this name has no __init__.py"
        raise RigidtopError(f"no equation or claim {name!r}; {hint}")
    return [(page, claim) for page, claim in claims if claim.name in wanted]


def of_exercises(
    collection: Collection, claims: Sequence[tuple[Page, Claim]]
) -> list[tuple[Page, Claim]]:
    """The claims that only exercises make, each with the page of its section."""
    pages = {page.section: page for page, _ in claims}
    made = {claim.name for _, claim in claims}
    found = {
        claim.name: (pages[exercise.section], claim)
        for exercise in collection.exercises
        if exercise.section in pages
        for claim in exercise.claims
        if claim.name not in made
    }
    return list(found.values())


def of_conventions(collection: Collection) -> list[tuple[Page, Claim]]:
    """The claims about the notations of other books, which go with the lecture on the top."""
    if collection.folder is not None:
        return []
    from rigidtop.derivations.conventions import CONVENTIONS

    return [(page, claim) for page in CONVENTIONS for claim in page.claims]


def judged(claims: Sequence[tuple[Page, Claim]]) -> Iterator[tuple[Page, Judgement]]:
    """Judge one claim after the other."""
    from rigidtop.proof.verdict import judge

    for page, claim in over("judging", claims):
        yield page, judge(claim, page.section)


def summary(judgements: Sequence[Judgement]) -> str:
    """Counts of the verdicts, and what did not pass."""
    from rigidtop.proof.verdict import Verdict

    counts = [(verdict.value, sum(j.verdict is verdict for j in judgements)) for verdict in Verdict]
    shown = ", ".join(f"{count} {name}" for name, count in counts if count)
    failed = [j.claim.name for j in judgements if not j.passed]
    last = (
        f"NOT PASSED: {', '.join(failed)}" if failed else "nothing failed that the notes get right"
    )
    return f"{len(judgements)} claim{'s' * (len(judgements) != 1)}: {shown}; {last}"
