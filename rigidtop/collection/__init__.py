"""Collections of derivation pages: the lecture on the top, or a folder of one's own.

A collection is a folder with an ``__init__.py`` that defines::

    PAGES      its pages, a tuple of `rigidtop.proof.page.Page` in reading order
    EXERCISES  a tuple of `rigidtop.proof.exercise.Exercise`; may be left out
    FIGURES    the names of the figures that its figures.py draws; may be left out
    MODELS     a tuple of `rigidtop.proof.model.Model`, which lines are held against, whoever
               follows; may be left out
    TITLE, SUBTITLE, SOURCE  what stands on the first page of the lecture; may be left out
    AUTHOR     whom its PDF names as author; may be left out

and as many other files as it likes, imported with a dot (``from .pendulum import page``).  Its
symbols come from `rigidtop.theory.lettered`, so that they are printed with its own letters, or
from `rigidtop.theory.symbols`.  ``rigidtop new my_course`` writes one to start from.

**A collection is Python, and runs as such**: with all rights of whoever checks it, like any other
program.  Read a collection before you run it.  Nothing is imported but the folder that is named on
the command line, and from it nothing can take the place of another module.

What is wrong in a collection is one line with its file and the number of the line: a
`RigidtopError` for what cannot be imported or typeset; a claim that breaks is undecided, with that
line beside it.
"""

from __future__ import annotations

import os
import shlex
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from sympy import Symbol

from rigidtop.collection.faults import EMPTY, is_empty, with_faults
from rigidtop.collection.figures import checked, drawings, names_of
from rigidtop.collection.folder import PageError as PageError
from rigidtop.collection.folder import imported, in_one_line, module_name, said, watched
from rigidtop.collection.kinds import (
    check_exercises,
    check_letters,
    check_names,
    check_pages,
    claims,
    many,
    text,
)
from rigidtop.collection.pages import declared, page_of, pages_of
from rigidtop.derivations.letters import LETTERS
from rigidtop.errors import RigidtopError
from rigidtop.judge.page import refuted
from rigidtop.notation import NOTES as NOTATION
from rigidtop.notation import Notation, is_matrix
from rigidtop.proof.exercise import Exercise, texts
from rigidtop.proof.lecture import Fault, Lecture, Text
from rigidtop.proof.letters import Letters
from rigidtop.proof.model import Model
from rigidtop.proof.page import Claim, Page, by_lines
from rigidtop.proof.units import is_energy
from rigidtop.read.library import Law, laws_of
from rigidtop.read.page import read_beside, read_exercises, read_lecture
from rigidtop.read.tables import rows
from rigidtop.report.front import NOTES, Front
from rigidtop.terminal.files import text_of
from rigidtop.theory import symbols
from rigidtop.theory.lettered import Lettered

if TYPE_CHECKING:
    from rigidtop.figures.drawing import Drawing


@dataclass(frozen=True)
class Collection:
    """Pages and exercises with what stands in front of them; `folder` is None for the built-in.

    `notation` says which letters stand for which symbols, where formulas in LaTeX are read.  The
    claims of the pages `besides` are judged when they are asked for by name.  `asked` finds the
    exercises, and `drawn` the figures, which are loaded when something needs them; `read` reads
    the text, with the solutions of exercises that are named behind it; `letters` says what its
    letters are.
    """

    front: Front
    pages: tuple[Page, ...]
    asked: Callable[[], tuple[Exercise, ...]] = tuple
    folder: Path | None = None
    notation: Notation = NOTATION
    besides: tuple[Page, ...] = ()
    read: Callable[[Sequence[str]], Lecture] = lambda _: Lecture()
    letters: Letters = LETTERS
    models: tuple[Any, ...] = ()
    drawn: Callable[[], tuple[Drawing, ...]] = tuple

    @cached_property
    def exercises(self) -> tuple[Exercise, ...]:
        """The exercises of the collection, in reading order."""
        return self.asked()

    @cached_property
    def figures(self) -> tuple[Drawing, ...]:
        """The figures of its pages.  Raises RigidtopError for what cannot be loaded."""
        return self.drawn()

    @property
    def lecture(self) -> Lecture:
        """The text, with every line and the move that leads to it; read when it is asked for.

        Raises RigidtopError, with file and line, for displays that can't be read.
        """
        return self.lecture_with(())

    def lecture_with(self, exercises: Iterable[Exercise]) -> Lecture:
        """The text with the solutions of these exercises behind it, and what shows their claims.

        Raises RigidtopError, with file and line, for displays that can't be read, and for letters
        of which nothing can be made.
        """
        lecture = self.as_written(exercises)
        home = self.folder or Path()
        stops = ((x.file, y.at, y.problem) for x in lecture.texts for y in x.faults if y.stops)
        amiss = (*stops, *lecture.unread())
        unread = [f"{home / file}, line {at}: {problem}" for file, at, problem in amiss]
        if unread:
            raise RigidtopError("\n".join(unread))
        return lecture

    def as_written(self, exercises: Iterable[Exercise] = ()) -> Lecture:
        """The same with whatever is wrong with it: `Lecture.unread` and `Lecture.faults`."""
        asked = [*exercises]
        return self.read(texts(asked, self.exercises) if asked else [])

    def with_page(self, path: Path) -> Lecture:
        """The lecture with one more page, which may cite it, as it is written.

        A page with the name of one of its own stands in the place of that and of all behind it.
        """
        from rigidtop.figures.catalog import FIGURES

        source = text_of(path)
        lecture = read_beside(str(path), source, self.lecture, self.notation)
        return with_faults(lecture, [(path.stem, source)], [each.name for each in FIGURES])

    def solved_by(self, claims: Iterable[Claim]) -> tuple[Exercise, ...]:
        """The exercises that some of these claims solve: those of no page."""
        names = {claim.name for page in self.pages for claim in page.claims}
        wanted = {claim.name for claim in claims} - names
        if not wanted:
            return ()
        return tuple(e for e in self.exercises if wanted & {claim.name for claim in e.claims})

    def command(self, name: str) -> str:
        """How `rigidtop` is asked for something of this collection."""
        asked = f"rigidtop {name}"
        return asked if self.folder is None else f"{asked} {typed(self.folder)}"

    def section(self, number: str) -> tuple[Page, ...]:
        """The pages of a section: its own and those of its subsections."""
        below = (f"{number}.", f"{number} ")
        return tuple(p for p in self.pages if p.section == number or p.section.startswith(below))

    def claims(self) -> list[tuple[Page, Claim]]:
        """Every claim once, with the page of its section: the lecture's, then those of exercises.

        Last come those of the pages `besides`.
        """
        home = {page.section: page for page in reversed(self.pages)}
        claims = [(page, claim) for page in self.pages for claim in page.claims]
        claims += [
            (home[exercise.section], claim)
            for exercise in self.exercises
            if exercise.section in home
            for claim in exercise.claims
        ]
        claims += [(page, claim) for page in self.besides for claim in page.claims]
        once: dict[str, tuple[Page, Claim]] = {}
        for page, claim in claims:
            once.setdefault(claim.name, (page, claim))
        return [*once.values()]

    def has(self, word: str) -> bool:
        """Whether a word names a claim, a section or an exercise; (3.57) is 3.57."""
        names = {claim.name for _, claim in self.claims()}
        names |= {exercise.name for exercise in self.exercises}
        return word.strip("()") in names or bool(self.section(word))


def typed(folder: Path) -> str:
    """A folder as it is typed where it may not be taken for a name.

    >>> typed(Path("my_course")), typed(Path("my notes", "course"))
    ('my_course/', "'my notes/course/'")
    """
    return shlex.quote(f"{folder}{os.sep}")


def built_in() -> Collection:
    """The collection that rigidtop ships: the lecture on the top."""
    from rigidtop.derivations import PAGES, lecture_with
    from rigidtop.derivations.conventions import CONVENTIONS

    return Collection(
        NOTES, PAGES, _exercises, besides=CONVENTIONS, read=lecture_with, drawn=_catalog
    )


def _exercises() -> tuple[Exercise, ...]:
    from rigidtop.derivations import exercises

    shipped: tuple[Exercise, ...] = exercises.EXERCISES
    return shipped


def _catalog() -> tuple[Drawing, ...]:
    from rigidtop.figures.catalog import FIGURES

    return FIGURES


def is_folder(word: str) -> bool:
    """Whether a word of the command line names a collection, not a claim.

    A bare word that names something of the lecture means that, whatever folders there are.

    >>> is_folder("my_course/"), is_folder("3.57")
    (True, False)
    """
    if any(separator in word for separator in {"/", os.sep}):
        return True
    folder = Path(word)
    is_one = (folder / "__init__.py").is_file() or (folder.is_dir() and bool(pages_of(folder)))
    return is_one and not built_in().has(word)


def is_collection(folder: Path) -> bool:
    """Whether a folder has a module, or a page that declares letters: an answer declares none."""
    if (folder / "__init__.py").is_file():
        return True
    pages = pages_of(folder) if folder.is_dir() else ()
    texts = (text_of(folder / f"{name}.md") for *_, name in pages)
    return any(True for text in texts for _ in rows(text))


@contextmanager
def opened(words: Sequence[str]) -> Iterator[tuple[Collection, list[str]]]:
    """The collection that the first word names, or else the built-in one, and the other words.

    Inside this context whatever breaks in a lecturer's folder raises RigidtopError, in one line.
    """
    if words and is_folder(words[0]):
        collection = load(words[0])
        with in_one_line(Path(words[0])):
            yield collection, list(words[1:])
    else:
        yield built_in(), list(words)


def load(folder: Path | str) -> Collection:
    """Import a folder: this runs what Python it has.  RigidtopError for what is wrong in it."""
    folder = Path(folder)
    if not folder.is_dir():
        raise RigidtopError(f"no folder {str(folder)!r}")
    if not (folder / "__init__.py").is_file():
        if not pages_of(folder):
            raise RigidtopError(
                f"{folder} is no collection: it has no __init__.py, and no page in Markdown that "
                "begins with a section such as '# 1 The pendulum'"
            )
        return _collection(ModuleType(module_name(folder)), folder)
    try:
        module = imported(folder)
    except (Exception, SystemExit) as error:
        raise RigidtopError(said(error, folder)) from None
    try:
        return _collection(module, folder)
    except RigidtopError as error:
        raise RigidtopError(f"{folder / '__init__.py'}: {error}") from None


# --- From a module to a collection ---------------------------------------------------------------


def _collection(module: ModuleType, folder: Path) -> Collection:
    by_hand = many(getattr(module, "PAGES", ()), Page, "PAGES")
    written = () if by_hand else pages_of(folder)
    if not by_hand and not written:
        raise RigidtopError(
            "has no PAGES, the tuple of its pages, and no page in Markdown begins with a section "
            "such as '# 1 The pendulum'"
        )
    names = [page.text for page in by_hand if page.text] or [name for *_, name in written]
    own = declared(_sources(folder, names))
    notation = _notation(folder, own.symbols)
    letters = letters_of(notation)
    numbers = letters.numbers - {*own.symbols} | own.numbers
    letters = replace(letters, numbers=numbers, frames=own.frames)
    exercises = many(getattr(module, "EXERCISES", ()), Exercise, "EXERCISES")
    asked_in = tuple(f"exercise-{each.name}" for each in exercises if each.figure)
    pictures = names_of(module)
    read = partial(_lecture, folder, names, notation, letters, pictures, asked_in, own.faults)
    texts = {text.name: text for text in read(()).texts} if written else {}
    pages = by_hand or tuple(page_of(number, title, texts[name]) for number, title, name in written)
    check_pages(pages)
    check_exercises(exercises, pages)
    if not by_hand:
        exercises = tuple(_with_claims_of(pages, each) for each in exercises)
    check_names(pages, exercises)
    title = text(module, "TITLE", folder.resolve().name)
    front = Front(
        title,
        text(module, "SUBTITLE", ""),
        text(module, "SOURCE", ""),
        f"{title}: exercises",
        text(module, "AUTHOR", NOTES.author),
    )
    once = {id(claim): watched(claim, folder) for claim in claims(pages, exercises)}

    def mine(owner: Any) -> Any:
        return replace(owner, claims=tuple(once[id(claim)] for claim in owner.claims))

    asked = tuple(map(mine, exercises))
    return Collection(
        front,
        tuple(map(mine, pages)),
        lambda: asked,
        folder,
        notation,
        read=read,
        letters=letters,
        models=many(getattr(module, "MODELS", ()), Model, "MODELS"),
        drawn=partial(drawings, module, folder),
    )


def _with_claims_of(pages: Sequence[Page], exercise: Exercise) -> Exercise:
    """The exercise, with the pages' own claims where it names them: `Claim("2.3", "…")`."""
    written = {claim.name: claim for page in pages for claim in page.claims}
    own = (written.get(c.name, c) if c.evidence is by_lines else c for c in exercise.claims)
    return replace(exercise, claims=tuple(own))


@cache
def _library() -> tuple[Law, ...]:
    """The laws of the lecture on the top, which a page cites by their names."""
    from rigidtop.derivations import laws

    return tuple(
        replace(law, source=f"The lecture on the top: {law.source}") for law in laws_of(laws())
    )


LAWS = "laws"
"""The text that stands before all others, if a folder has it."""


def _sources(folder: Path, names: Sequence[str]) -> list[tuple[str, str]]:
    """The texts of a folder with their names, laws.md first."""
    names = [LAWS, *names] if (folder / f"{LAWS}.md").is_file() else names
    return [(name, text_of(folder / f"{name}.md")) for name in names]


def _lecture(
    folder: Path,
    names: Sequence[str],
    notation: Notation,
    letters: Letters,
    figures: Sequence[str],
    exercise_figures: Sequence[str],
    amiss: Sequence[tuple[str, Fault]],
    exercises: Sequence[str],
) -> Lecture:
    """The texts of a folder, those of exercises last, with what is `amiss` with their letters."""
    sources = _sources(folder, names)
    read = checked(read_lecture(sources, letters, notation, _library), figures)
    behind = [(name, text_of(folder / f"{name}.md")) for name in exercises]
    lecture = read_exercises(behind, replace(read, refuted=refuted), notation)
    places = (*figures, *exercise_figures)
    lecture = with_faults(lecture, [*sources, *behind], places, amiss)
    return replace(lecture, texts=(*lecture.texts, *_empty(folder, lecture)))


def _empty(folder: Path, lecture: Lecture) -> Iterator[Text]:
    """The files of a folder in which a page was begun, and nothing stands but headings."""
    names = {text.name for text in lecture.texts}
    for path in sorted(folder.glob("*.md")):
        if path.stem not in names and is_empty(text_of(path)):
            yield Text(path.name, path.stem, (), (Fault(1, EMPTY),))


def letters_of(notation: Notation) -> Letters:
    """What a notation's letters are, as far as they show it.

    What is positive is a number; a letter with a dotted one is a coordinate, whose rate that is,
    unless it is an energy; bold letters are vectors.  Units are the symbols' own.  Letters of the
    lecture on the top are exchanged and belong to bodies that exist as they do there.
    """
    glyphs = notation.glyphs
    dots = {"": "dot", "dot": "ddot"}
    rates = {
        x: notation.names[dotted]
        for x, glyph in glyphs.items()
        if glyph.accent in dots
        and (dotted := replace(glyph, accent=dots[glyph.accent])) in notation.names
    }
    unit = {
        x: (x.quantity if isinstance(x, Lettered) else symbols.VOCABULARY[x]).unit for x in glyphs
    }
    return Letters(
        numbers=frozenset(x for x in glyphs if x.is_positive),
        coordinates=tuple(
            x
            for x in rates
            if glyphs[x].accent == "" and not glyphs[x].bold and not is_energy(unit[x])
        ),
        rates=rates,
        vectors=frozenset(x for x, glyph in glyphs.items() if glyph.bold),
        operators=frozenset(filter(is_matrix, glyphs)),
        families=tuple(f for f in LETTERS.families if len({*f} & {*glyphs}) > 1),
        exists=LETTERS.exists,
        units=unit,
    )


def _notation(folder: Path, declared: Sequence[Lettered]) -> Notation:
    """The letters that pages declare and those that the folder's modules have.

    Modules have their own and those of the lecture that they import.
    """
    name = module_name(folder)
    modules = [vars(m) for module, m in sys.modules.items() if f"{module}.".startswith(f"{name}.")]
    values = [value for names in modules for value in names.values()]
    used = {value for value in values if isinstance(value, Symbol)} | {
        symbols.const,
        symbols.t,
        *declared,
    }
    if any(value is symbols for value in values):  # from rigidtop.theory import symbols
        used |= {*NOTATION.glyphs}
    own = sorted((x for x in used if isinstance(x, Lettered)), key=lambda x: (x.place, x.name))
    check_letters([x for x in own if x not in declared])  # these have their places in a page
    glyphs = {x: x.quantity.glyph for x in own}
    taken = {*glyphs.values()}
    theirs = {x: g for x, g in NOTATION.glyphs.items() if x in used and g not in taken}
    spellings = {g: x for g, x in NOTATION.spellings.items() if x in theirs and g not in taken}
    return Notation(folder.resolve().name, {**theirs, **glyphs}, spellings)
