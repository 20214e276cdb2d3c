"""What an answer has to do: from facts that are given to a goal.

In a lecture both ends are lines of it; the facts are those of its models in which both hold, from
the general motion to the special one, or, where no model knows them, what its pages start from.  A
file with laws of one's own, such as a Lagrangian, can stand for a lecture.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from sympy import Expr

from rigidtop.derivations import lecture, models
from rigidtop.errors import RigidtopError
from rigidtop.judge.context import LAW, Constraint, Context
from rigidtop.judge.habits import habits_of
from rigidtop.judge.judge import Judge
from rigidtop.judge.outcome import FALSE
from rigidtop.judge.question import Patience
from rigidtop.judge.situation import Situation
from rigidtop.judge.text import folded
from rigidtop.mark.facts import GIVEN, context, special
from rigidtop.notation import NOTES, Notation
from rigidtop.proof.derivation import Line
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.model import Model
from rigidtop.proof.moves import Condition
from rigidtop.read.statements import statements
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement
from rigidtop.typeset.text import text

Together = tuple[Statement, ...]
"""Statements that stand in one display."""

_NAMING = ("call", "solve")
"""Moves that say what a letter is."""

_RENAMING = ("put", "rewrite")
"""Moves behind which a result stands in other letters."""

ALWAYS = frozenset({Letter("π"), Letter("t"), Letter("i"), Letter("e")})


@dataclass(frozen=True, eq=False)
class Subject:
    """A lecture, models of which each family goes from the general to the special, and letters."""

    lecture: Lecture
    families: tuple[tuple[Model, ...], ...]
    notation: Notation


@dataclass(frozen=True)
class PageLine:
    """A line of a page on the way, with what it states."""

    file: str
    at: int
    statements: Together

    def __str__(self) -> str:
        said = "; ".join(map(plain, self.statements))
        return f"({self.file}, line {self.at}): {said}"


@dataclass(frozen=True, eq=False)
class Branch:
    """Motions that the facts allow besides: what is put in for them, and in words what vanishes."""

    special: tuple[Mapping[Expr, Expr], ...]
    lost: str


@dataclass(frozen=True, eq=False)
class Task:
    """Facts, as contexts from the general to the special, and any of some goals to be reached.

    In `names` is only what letters are called, whatever they are made of.  `words` say for what
    each context holds, if not in general; `way` are the lines of the pages between, if there are
    pages.
    """

    contexts: tuple[Context, ...]
    names: Context
    goals: tuple[Together, ...]
    name: str
    words: tuple[str, ...]
    branches: tuple[Branch, ...] = ()
    way: tuple[PageLine, ...] = ()


@cache
def top() -> Subject:
    """The lecture on the top; of its lines only what their moves set is asked, and no world."""
    return Subject(replace(lecture(), refuted=None), models.families(), NOTES)


@cache
def task(start: str, goal: str, subject: Subject | None = None) -> Task:
    """From one numbered equation, or one claim, of a lecture to another.

    A numbered equation may stand before the one to start from: what its own derivation rests on is
    known.  Raises RigidtopError where the lecture does not have them, or does not lead from the one
    to a claim, or no facts are known in which the goal holds.
    """
    subject = subject or top()
    pages = subject.lecture
    start, goal = start.strip("()"), goal.strip("()")
    refused = f"no derivation from {start} to {goal} is marked"
    for name in (start, goal):
        if name not in pages.names:
            raise RigidtopError(f"{refused}: no line of the lecture is called {name!r}")
    derived = _is_numbered(goal, pages) and pages.names[start] != pages.names[goal]
    if not derived and not _leads(start, goal, pages):
        raise RigidtopError(f"{refused}: the lecture does not lead from the one to the other")
    results = _results(goal, pages)
    goals = tuple(stated(id, pages) for id in results)
    if not goals:
        raise RigidtopError(f"{refused}: {goal} is where a derivation starts, not where one ends")
    given = tuple(x for id in pages.names[start] for x in stated(id, pages))
    called = _names(start, goal, pages)
    used, contexts = _family(goals, given, called, subject)
    if not contexts and subject.families:
        raise RigidtopError(f"{refused}: no model of the collection knows what {goal} is about")
    contexts = contexts or (_from_pages(start, goal, subject),)
    if not _is_numbered(goal, pages):
        goals = _otherwise(_both_roots(goals), given, contexts[0], _calls(goal, pages))
    # What letters are called holds for whatever they are made of.
    known = frozenset().union(*(context(model).given for model in used))
    own = [x for x in called if x.sides[0] not in known]
    alone = knowing(bare(contexts[0]), own)
    branches = tuple(
        Branch(special(branch), f"{text(model.lost)} = 0")
        for model in used[-1:]
        if model.lost is not None
        for branch in model.branch
    )
    held = tuple(_holding(each, given) for each in contexts)
    words = tuple(model.words for model in used) or ("",)
    return Task(held, alone, goals, goal, words, branches, _way(start, results, pages))


def task_of(source: str, goal: str) -> Task:
    """From what a text states, such as a Lagrangian, to a formula in TeX.

    Raises RigidtopError where one of them states nothing.
    """
    stated = [x for x in statements(goal) if isinstance(x, Statement) and x.relations]
    if not stated:
        raise RigidtopError(f"--to: no equation is read in {goal!r}")
    _, found = folded(source)
    if not found.definitions and not found.constraints:
        raise RigidtopError("--given: no formula of that file says what an answer could use")
    spoken = frozenset(found.definitions) | found.letters
    known = replace(found, given=spoken)
    return Task((known,), bare(known), (tuple(stated),), goal, ("",))


# --- Goals ---------------------------------------------------------------------------------------


def stated(id: str, pages: Lecture) -> Together:
    """What a line of a page states."""
    return tuple(x for x in statements(_written(pages)[id]) if isinstance(x, Statement))


@cache
def _written(pages: Lecture) -> dict[str, str]:
    return {x.line.id: x.latex for page in pages.texts for x in page.shown if x.line}


def _results(goal: str, pages: Lecture) -> tuple[str, ...]:
    """What the lecture derives under a number, or under a name and uses no more there."""
    lines = [pages.lines[id] for id in pages.names[goal] if id not in pages.laws]
    numbered = [line for line in lines if _is_numbered_so(line, goal)]
    derived = [line for line in lines if line.move is not None and line.move.verb != "call"]
    used = {
        id
        for line in derived
        if line.move is not None and line.move.verb not in _RENAMING
        for id in pages.cites(line.id)
    }
    results = [line for line in derived if line.id not in used]
    results += [line for line in derived if _is_exact(line.id, results, pages)]
    telling = [line for line in results if not _nearly_vanishes(line.id, pages)]
    results = telling or results
    return tuple(line.id for line in numbered or results)


def _nearly_vanishes(id: str, pages: Lecture) -> bool:
    """Whether a line says no more than what is nearly zero."""
    together = stated(id, pages)
    return all(x.relations == ("≈",) and x.sides[-1] == n.Number("0") for x in together)


def _is_numbered(goal: str, pages: Lecture) -> bool:
    """Whether a name is the number of an equation, and not that of a claim."""
    return any(_is_numbered_so(pages.lines[id], goal) for id in pages.names[goal])


def _is_numbered_so(line: Line, number: str) -> bool:
    return any(each.tag == number for each in line.equations)


def _is_exact(id: str, results: Sequence[Line], pages: Lecture) -> bool:
    """Whether a line says exactly what a result says nearly of letters that the pages call."""
    heads = (
        n.letters(x.sides[0])
        for result in results
        if id in pages.above(result.id)
        for x in stated(result.id, pages)
        if x.relations == ("≈",)
    )
    [*exact] = (n.letters(x.sides[0]) for x in stated(id, pages) if x.relations == ("=",))
    return any(head <= _called(pages) and any(head <= each for each in exact) for head in heads)


@cache
def _called(pages: Lecture) -> frozenset[Letter]:
    """The letters that pages call something, as they stand on the left."""
    called = (id for id, line in pages.lines.items() if line.move and line.move.verb == "call")
    sides = (x.sides[0] for id in called for x in stated(id, pages))
    return frozenset().union(*map(n.letters, sides))


def _calls(goal: str, pages: Lecture) -> tuple[Statement, ...]:
    """What pages call something on the way to a goal."""
    wanted = {x for id in pages.names[goal] for x in (id, *pages.above(id))}
    called = (pages.lines[id] for id in pages.lines if id in wanted)
    ids = [line.id for line in called if line.move is not None and line.move.verb == "call"]
    return tuple(x for id in ids for x in stated(id, pages) if x.relations == ("=",))


def _both_roots(goals: tuple[Together, ...]) -> tuple[Together, ...]:
    """Goals of which what is said of Ω₊ and of Ω₋ are one goal, where both are."""
    roots: dict[str, list[Together]] = {"+": [], "-": []}
    for each in goals:
        match each:
            case (Statement((Letter(sub=sub), *_)),) if sub[-1:] in roots:
                roots[sub[-1]].append(each)
    if not all(roots.values()):
        return goals
    single = [each for both in roots.values() for each in both]
    both = tuple((*upper, *lower) for upper in roots["+"] for lower in roots["-"])
    return (*(each for each in goals if each not in single), *both)


def _otherwise(
    goals: tuple[Together, ...], given: Together, known: Context, calls: Sequence[Statement]
) -> tuple[Together, ...]:
    """Goals with what else says the same in words: what stays as it began is constant, of a chain
    the ends are enough, an axis may have another number where the facts are the same for all, and
    a scalar product with both lengths says the cosine.
    """
    kept = (*map(_kept, goals), *map(_ends, goals))
    turned = _turned(given)
    if turned != given and _holds(turned, known):
        once = tuple(_turned(_written_out(each, calls)) for each in kept)
        kept = (*kept, *once, *map(_turned, once))
    others = (*map(_as_vector, kept), _cosine([x for together in goals for x in together]))
    return tuple(dict.fromkeys((*goals, *kept, *filter(None, others))))


def _written_out(together: Together, calls: Sequence[Statement]) -> Together:
    """Statements with what the pages call something in the place of its name."""
    values = {x.sides[0]: n.Bracketed(x.sides[1]) for x in calls}

    def written(each: Statement) -> Statement:
        if each.sides[0] in values:
            return each
        put = (n.mapped(side, lambda node: values.get(node, node)) for side in each.sides)
        return replace(each, sides=tuple(put))

    return tuple(map(written, together))


def _kept(together: Together) -> Together:
    """Statements with a constant for what a letter is at the start: ω₃ = const for ω₃ = ω₃,₀."""

    def kept(each: Statement) -> Statement:
        left, right = each.sides[0], each.sides[-1]
        if not isinstance(left, Letter) or right != replace(left, sub=f"{left.sub},0".strip(",")):
            return each
        return replace(each, sides=(*each.sides[:-1], n.Constant()))

    return tuple(map(kept, together))


def _as_vector(together: Together) -> Together:
    """That a vector is constant, where each of its three components is; nothing where not."""
    first = together[0].sides[0]
    if not isinstance(first, Letter):
        return ()
    components = {replace(first, sub=sub) for sub in "123"}
    fixed = all(isinstance(x.sides[-1], (n.Number, n.Constant)) for x in together)
    if not fixed or {x.sides[0] for x in together} != components:
        return ()
    vector = replace(first, sub="", bold=True)
    return (Statement((vector, n.Constant()), ("=",), 0),)


def _cosine(said: Sequence[Statement]) -> Together:
    """The cosine of the angle between two vectors whose product and squares are said."""
    values = {
        (x.sides[0].left, x.sides[0].right): x.sides[-1]
        for x in reversed(said)
        if isinstance(x.sides[0], n.DotProduct) and n.letters(x.sides[-1]) and x.relations == ("=",)
    }
    for (u, v), product in values.items():
        if u != v and (u, u) in values and (v, v) in values:
            size = n.Product((n.Absolute(u), n.Absolute(v)))
            roots = n.Product((n.Root(values[u, u]), n.Root(values[v, v])))
            sides = n.Quotient(n.DotProduct(u, v), size), n.Quotient(product, roots)
            return (Statement(sides, ("=",), 0),)
    return ()


def _ends(together: Together) -> Together:
    """Statements of which chains say no more than that their ends are equal."""
    return tuple(
        replace(x, sides=(x.sides[0], x.sides[-1]), relations=("=",))
        if {*x.relations} == {"="}
        else x
        for x in together
    )


_NEXT = str.maketrans("123", "231")


def _turned(together: Together) -> Together:
    """Statements with the next one of three axes for each, 2 for 1, 3 for 2 and 1 for 3."""

    def turned(node: n.Node) -> n.Node:
        if not isinstance(node, Letter) or node.sub[:1] not in {*"123"} or node.sub[1:2].isdigit():
            return node
        return replace(node, sub=node.sub[0].translate(_NEXT) + node.sub[1:])

    return tuple(
        replace(x, sides=tuple(n.mapped(side, turned) for side in x.sides)) for x in together
    )


def _leads(start: str, goal: str, pages: Lecture) -> bool:
    """Whether the goal rests on the start, or on what that rests on and stands behind it."""
    first, last = pages.names[start], pages.names[goal]
    if first == last:
        return False
    above = {x for id in last for x in pages.above(id)}
    if {*first} & above:
        return True
    lines = list(pages.lines)
    same_page = pages.lines[first[0]].file == pages.lines[last[0]].file
    related = same_page or bool({x for id in first for x in pages.above(id)} & above)
    return related and lines.index(first[-1]) < lines.index(last[0])


def _way(start: str, results: Sequence[str], pages: Lecture) -> tuple[PageLine, ...]:
    """The lines of the pages that rest on the start and that the goal rests on."""
    above = {x for id in results for x in pages.above(id)}
    below = {x for id in pages.names[start] for x in pages.below(id)}
    ids = (above & below) - {*pages.names[start], *results}
    return tuple(
        PageLine(line.file, line.at, stated(id, pages))
        for id, line in pages.lines.items()
        if id in ids
    )


# --- Facts ---------------------------------------------------------------------------------------


def _family(
    goals: Sequence[Together], begun: Together, names: Sequence[Statement], subject: Subject
) -> tuple[tuple[Model, ...], tuple[Context, ...]]:
    """The models, and what they say, up to the most general one for both ends.

    The best is one in which a goal holds and the start too; what knows the start alone will do.
    """
    known = [context(model) for family in subject.families for model in family]
    named = frozenset().union(*(each.definitions.keys() for each in known))
    # What one model alone calls its start, ω₀, may be called so where others are spoken of.
    usual = Counter(x for each in known for x in each.given)
    declared = named | {x for x, count in usual.items() if count > 1}
    spoken = frozenset().union(*(letters(x) for together in goals for x in together)) - ALWAYS
    found: list[tuple[tuple[bool, int, int, int], tuple[Model, ...], tuple[Context, ...]]] = []
    for family in subject.families:
        contexts = tuple(knowing(context(model, declared), names) for model in family)
        for k, each in enumerate(contexts):
            begins = _holds(begun, each)
            ends = sum(_holds(together, each) for together in goals)
            if begins or ends:
                rank = (not (begins and ends), -ends, len(spoken - each.given), k)
                found.append((rank, family[: k + 1], contexts[: k + 1]))
    if not found:
        return (), ()
    _, used, contexts = min(found, key=lambda x: x[0])
    given = frozenset().union(*(each.given for each in contexts))
    return used, tuple(replace(each, declared=each.declared | given) for each in contexts)


def _names(start: str, goal: str, pages: Lecture) -> list[Statement]:
    """What pages call a letter, or solve for it, on the way to a goal or as a part of it.

    What comes of something that they set on the way is no name.
    """
    wanted = {*pages.names[goal]}
    wanted |= {x for id in wanted for x in pages.above(id)}
    usual = {condition for id in pages.names[start] for condition in _set(id, pages)}
    ids = (id for id in pages.lines if id in wanted)
    return [x for id in ids for x in names(id, pages) if _set(id, pages) <= usual]


def names(id: str, pages: Lecture) -> Together:
    """What a line says of a letter that it calls something, or for which it solves."""
    move = pages.lines[id].move
    if move is None or move.verb not in _NAMING:
        return ()
    return tuple(
        x for x in stated(id, pages) if x.relations[:1] == ("=",) and isinstance(x.sides[0], Letter)
    )


def _set(id: str, pages: Lecture) -> set[Condition]:
    """What has been set for a line."""
    return {c for c in pages.judged(id).known.conditions if c.relation == "="}


def bare(known: Context) -> Context:
    """A context with the same letters, of which nothing is known, nor of time."""
    return replace(known, definitions={}, constraints=(), lawless=True, timeless=True)


def knowing(known: Context, names: Iterable[Statement]) -> Context:
    """A context with letters that it does not have, and which are said to be something in it."""
    judge = Judge(patience=Patience(0))
    for each in names:
        head = each.sides[0]
        assert isinstance(head, Letter)
        first = replace(each, sides=each.sides[:2], relations=each.relations[:1])
        if head not in known.definitions and letters(first) - {head} - ALWAYS <= known.given:
            known = replace(known, given=known.given - {head})
            _, known = judge.judged(first, Situation(GIVEN, closed=True), known)
            if head in known.definitions:
                known = replace(known, given=known.given | {head})
    return known


def _holds(together: Sequence[Statement], known: Context) -> bool:
    """Whether a context knows all letters of some statements, and all of these follow in it."""
    if not together or any(letters(each) - known.given - ALWAYS for each in together):
        return False
    judge, at = Judge(patience=Patience(0)), Situation(GIVEN, closed=True)
    return all(judge.judged(each, at, known)[0].passed for each in together)


def _holding(known: Context, given: Together) -> Context:
    """A context in which what stands at the start holds, unless it is wrong there."""
    judge, at = Judge(patience=Patience(0)), Situation(GIVEN, closed=True)
    for each in given:
        if letters(each) - known.given - ALWAYS:
            continue
        outcome, _ = judge.judged(each, at, known)
        if outcome.passed is None and outcome.verdict != FALSE:
            for left, right in zip(each.sides, each.sides[1:], strict=False):
                known = known.holding(Constraint(left, right, GIVEN, LAW))
    return known


def _from_pages(start: str, goal: str, subject: Subject) -> Context:
    """What the pages start from on their way to a goal: laws, names and the start itself."""
    pages = subject.lecture
    wanted = {x for name in (start, goal) for id in pages.names[name] for x in pages.above(id)}
    wanted |= {*pages.names[start]}
    lines = [
        line
        for id, line in pages.lines.items()
        if id in wanted
        and (line.move is None or line.move.verb == "call" or id in pages.names[start])
    ]
    premises = [x for line in lines for x in stated(line.id, pages) if x.relations]
    known, judge = Context(habits_of(premises)), Judge(patience=Patience(0))
    for number, each in enumerate(premises):
        _, known = judge.judged(each, Situation(GIVEN - 1 - number), known)
    return replace(known, given=known.letters)


def letters(statement: Statement) -> frozenset[Letter]:
    """The letters of a statement."""
    return frozenset().union(*map(n.letters, statement.sides))
