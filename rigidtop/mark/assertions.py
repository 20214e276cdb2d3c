"""What an answer asserts, line by line, in the letters of its task, with what is said around it.

A condition comes before the value that it is for, what a letter stands for before its first use,
and words of what is large reach on.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from dataclasses import replace

from rigidtop.judge.context import START, Context
from rigidtop.judge.letters import CLOCK, INFINITY
from rigidtop.judge.moments import at_one_time, instant_at, instants, is_time
from rigidtop.judge.reading import Read
from rigidtop.judge.sides import ZERO
from rigidtop.judge.situation import Situation
from rigidtop.judge.text import declared_letters, situation
from rigidtop.mark.angles import with_angles
from rigidtop.mark.names import Names
from rigidtop.mark.task import ALWAYS, Task, letters
from rigidtop.read.document import problems
from rigidtop.read.passages import Passage
from rigidtop.read.phrases import Cue
from rigidtop.read.walk import STRUCK
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.several import each_index
from rigidtop.tree.statement import Statement, Unread


def asserted(
    source: str, read: Read, task: Task
) -> Iterator[tuple[int, Statement | Unread, Situation | str]]:
    """What an answer asserts, in the letters of its task, with the position where it stands.

    With it goes what the words around it say; with what is unread, what stands there.
    """
    facts = ALWAYS.union(*(context.letters for context in task.contexts))
    read = _conditions_first(with_angles(read, facts), facts)
    for problem in problems(source):
        if problem.reason == STRUCK:
            continue
        rest = source[problem.position : problem.position + 60].split("\n", 1)[0]
        yield problem.position, Unread(problem.position, problem.reason), rest
    names = Names.of(read, task.contexts)
    declared, large = declared_letters(source), _behind_large(read)
    moving = frozenset().union(*map(_moving, task.contexts))
    moments = [each or _only_there(k, read, facts) for k, each in enumerate(instants(read, moving))]
    tried: Passage | None = None  # where numbers are tried
    for number in _explained_first(read, facts):
        passage, each = read[number]
        position = passage.start + each.position
        if isinstance(each, Unread):
            if not (_NOTHING.fullmatch(passage.text) or _is_of_signs(passage.text)):
                yield position, each, passage.text
            continue
        if not each.relations or any(
            isinstance(x, n.Omitted) for s in each.sides for x in n.walked(s)
        ):
            continue  # what is left out is not said
        if is_time(each):
            continue  # a moment: what is said of it has its own place there
        if _is_transformation(each, names) or _is_notation(each):
            continue
        at = situation(passage, number, moments[number], False, declared)
        if _TRIED.match(passage.before) or _is_measured(passage, each, facts):
            tried = passage
        if tried is not None and _goes_on(source, tried, passage):
            same = passage.sentence == tried.sentence and not at.derived
            at = replace(at, sentence=tried.sentence, tried=same and _is_value(passage, each))
        if _is_supposed(passage, each):
            at = at.hearing(Cue.CASE)
        if large[number]:
            at = replace(at, cues=at.cues - {Cue.SMALL, Cue.APPROXIMATED} | {Cue.LARGE})
        statement, time = at_one_time(names.in_facts(each), moving)
        if len({*statement.sides}) < len({*each.sides}) == 2:
            continue  # that ϕ is φ
        if time is not None:
            at = replace(at, instant=instant_at(time))
        elif at.instant == START and any(CLOCK in n.letters(side) for side in each.sides):
            at = replace(at, instant="")  # what is written in the time holds at all times
        excluded = {*each.relations} == {"="} and _EXCLUDED.search(passage.before) is not None
        at = replace(at, closed=True, named=not excluded and _names_case(passage, each))
        if excluded:
            statement = replace(statement, relations=("≠",) * len(each.relations))
        for one in _each_meant(statement, facts):
            yield position, one, at


def _each_meant(each: Statement, facts: Collection[Letter]) -> Iterator[Statement]:
    """What it says of several letters of the facts at once, of each: ω_{2,3} = 0, I_k = λ_k."""
    several = [*each_index(each)]
    if len(several) > 1 and not all(letters(x) & {*facts} - letters(each) for x in several):
        several = [each]
    for one in several:
        yield from _for_each_axis(_trial(one, facts), facts)


def _trial(each: Statement, facts: Collection[Letter]) -> Statement:
    """The motion that x ∝ exp(κ t) tries, or x = Re A exp(κ t): of linear laws it obeys those."""
    match each.sides:
        case (Letter() as name, motion) if each.relations == ("∝",) and CLOCK in n.letters(motion):
            amplitude = Letter("c", name.base + name.sub)
            sides = (name, n.Product((amplitude, n.Bracketed(motion))))
            return replace(each, sides=sides, relations=("=",))
        case (Letter() as name, n.Apply("Re", motion)) if CLOCK in n.letters(motion):
            if not n.letters(motion) & {*facts} - ALWAYS:
                return replace(each, sides=(name, motion))
    return each


def _for_each_axis(each: Statement, facts: Collection[Letter]) -> list[Statement]:
    """What names a letter of the answer's own for any axis, I_k = λ_k, as said of all three."""
    head = each.sides[0]
    if not isinstance(head, Letter) or len(head.sub) != 1 or head.sub not in "ijklmn":
        return [each]
    inner = {x for side in each.sides[1:] for x in n.letters(side) if x.sub == head.sub}
    numbered = {replace(x, sub=axis) for x in inner for axis in "123"}
    if not inner or not numbered <= {*facts} or replace(head, sub="1") in facts:
        return [each]

    def along(axis: str) -> Statement:
        def named(node: n.Node) -> n.Node:
            own = isinstance(node, Letter) and node.sub == head.sub
            return replace(node, sub=axis) if own else node  # type: ignore[type-var]

        return replace(each, sides=tuple(n.mapped(side, named) for side in each.sides))

    return [along(axis) for axis in "123"]


_NOTHING = re.compile(r"[\s.]*\\(?:square|blacksquare|Box|qed|checkmark)[\s.]*|\s*[\^_]\W*\w+\W*")
"""No formula: a sign behind what is shown, or what is raised beside a word, as in kg m$^2$."""


def _is_of_signs(text: str) -> bool:
    """Whether it says rightly which sign a product of signs has: (−)(+) < 0."""
    found = _SIGNS.fullmatch(text)
    if found is None:
        return False
    negative = len(re.findall("[-−]", found[1])) % 2 == 1
    return negative == (found[2] == "<" or found[3] in ("-", "−"))


_SIGNS = re.compile(r"((?:\s*\(\s*[-−+]\s*\)\s*)+)(?:([<>])\s*0|=\s*\(?\s*([-−+])\s*\)?)\s*")
"""A product of signs in brackets, and its sign."""


def _moving(context: Context) -> frozenset[Letter]:
    """The letters of the facts that move, vectors as well: ω(0) is said of the start."""
    vectors = {x for x in context.definitions if x.bold and not x.sub and not x.mark}
    return context.habits.moving | vectors


def _is_transformation(each: Statement, names: Names) -> bool:
    """Whether something is put for a letter: φ → φ + ε, or s → c for the slopes of sin and cos."""
    if each.relations != ("→",):
        return False
    left, right = each.sides
    return left in n.letters(right) or bool(n.letters(right) | {left} <= names.defined)


def _is_notation(each: Statement) -> bool:
    """Whether it says how a derivative is written: ∂_θ ℒ = ∂ℒ/∂θ."""
    return len({*each.sides}) == 1 and isinstance(each.sides[0], (n.Derivative, n.TimeDerivative))


_SUPPOSE = re.compile(
    r"\W*(?:(?:we|now|let us|wir) )?(?:suppose|assum|if|let|angenommen|annehm|falls|wenn|seien?)\b",
    re.I,
)
"""Words with which a sentence begins that supposes something."""


_TRIED = re.compile(
    r"\W*(?:(?:(?:as |for )?an? )?(?:numerical |quick |sanity |simple )?"
    r"(?:test|check|example|special case|limit)"
    r"|for (?:example|instance)|e\. ?g\.|numbers|zum beispiel|z\. ?B\.|beispiel|probe|kontrolle)\b",
    re.I,
)
"""Words with which a sentence begins that tries numbers."""


def _goes_on(source: str, begun: Passage, passage: Passage) -> bool:
    """Whether a formula stands in the same paragraph, at most a sentence farther."""
    near = begun.sentence <= passage.sentence <= begun.sentence + 1
    return near and not re.search(r"\n[ \t]*\n", source[begun.start : passage.start])


def _is_supposed(passage: Passage, each: Statement) -> bool:
    """Whether letters are given a number in the first statement of a sentence that supposes."""
    return bool(_SUPPOSE.match(passage.before)) and _is_value(passage, each)


_CASE = re.compile(
    r"\b(?:(?:at|in) (?:the|this|that|an?) \w+(?: \w+)?"
    r"|if|for|at|when|where|while|unless|except|either|or|case|even|only"
    r"|wenn|falls|für|bei|wo|nur|entweder|oder|fall|si|pour|où|quand|cas)\W*\Z",
    re.I,
)
"""Words directly before a formula that names a case."""


_EXCLUDED = re.compile(
    r"\b(?:not (?:valid |defined )?(?:for|at|if|when|where|in the case)"
    r"|except(?: for| at| if| when)?|excluding|unless|nicht (?:für|bei|wenn)|außer(?: für| bei)?"
    r"|sauf(?: si| pour)?)\W*\Z",
    re.I,
)
"""Words directly before a formula that names a case which is left out."""


def _names_case(passage: Passage, each: Statement) -> bool:
    """Whether it names a case: "fine for cos θ = 0", "• cos θ = 0", or "• a = b: then"."""
    if {*each.relations} != {"="} or passage.display:
        return False
    item = bool(passage.scope) and passage.scope[-1] < 0 and not passage.before.strip("-*•: ")
    if item and passage.behind.lstrip().startswith(":"):
        return True
    return each.sides[-1] == ZERO and (item or _CASE.search(passage.before) is not None)


def _is_measured(passage: Passage, each: Statement, facts: Collection[Letter]) -> bool:
    """Whether a letter of the facts is given a number with a unit, but an angle: an example."""
    unit = any(isinstance(x, n.Unit) and x.name != "°" for x in n.walked(each.sides[-1]))
    return unit and each.sides[0] in facts and _is_value(passage, each)


def _is_value(passage: Passage, each: Statement) -> bool:
    """Whether letters, or their rates, or a product of them are given a number."""
    sides = (x.of if isinstance(x, n.TimeDerivative | n.Primed) else x for x in each.sides[:-1])
    number = not any(isinstance(x, Letter) for x in n.walked(each.sides[-1]))
    names = (y for x in sides for y in (x.factors if isinstance(x, n.Product) else (x,)))
    return not passage.display and number and all(isinstance(x, Letter) for x in names)


def _behind_large(read: Read) -> list[bool]:
    """Whether each statement is of what words say is large: these reach on in their scope.

    They end where something is small, or all is general again.
    """
    reached: list[bool] = []
    scope: tuple[int, ...] | None = None
    for passage, each in read:
        tends = isinstance(each, Statement) and each.sides[-1] == INFINITY
        if tends or Cue.LARGE in passage.cues:
            scope = passage.scope
        elif passage.cues & {Cue.SMALL, Cue.GENERAL} or passage.scope != scope:
            scope = None
        reached.append(scope is not None)
    return reached


_WHERE = re.compile(
    r"\W*(?:(?:only|exactly|just|nur|genau) )?(?:for|if|when|where|at|falls|wenn|für|bei|wo)\W*",
    re.I,
)
"""Words between a value and the condition under which a letter has it."""


def _has_condition(k: int, read: Read, facts: Collection[Letter]) -> bool:
    """Whether a letter is given a number there where the next formula holds."""
    if k + 1 >= len(read):
        return False
    (passage, each), (behind, condition) = read[k : k + 2]
    return (
        passage.sentence == behind.sentence
        and passage.start < behind.start
        and bool(_WHERE.fullmatch(passage.behind))
        and isinstance(each, Statement)
        and isinstance(condition, Statement)
        and {*each.relations} == {*condition.relations} == {"="}
        and isinstance(each.sides[-1], n.Number)
        and not is_time(condition)
        and _explained(condition, facts) is None
        and not any(isinstance(side, n.Constant) for side in condition.sides)
    )


def _conditions_first(read: Read, facts: Collection[Letter]) -> Read:
    """The text with the condition before the value that it is for."""
    order = list(range(len(read)))
    for k in order[:-1]:
        if _has_condition(k, read, facts):
            order[k], order[k + 1] = k + 1, k
    return [read[k] for k in order]


_HERE = re.compile(r"\b(?:here|hier|ici)\W*", re.I)
"""A word with which what a letter stands for begins, as it does with "where"."""


def _explained_first(read: Read, facts: Collection[Letter]) -> list[int]:
    """The order in which what a letter of the answer's own stands for is before its first use.

    So a, b and c of a quadratic are known there, of which the text says behind it what they are.
    A letter with a rate may be what an equation is solved for.
    """
    order: list[int] = []
    sides = [x for _, each in read if isinstance(each, Statement) for x in each.sides]
    solved = {x.of for side in sides for x in n.walked(side) if isinstance(x, n.TimeDerivative)}
    said = -1  # the sentence in which the last statement says what a letter stands for
    for number, (passage, each) in enumerate(read):
        place, name = len(order), _explained(each, facts)
        uses = (k for k, other in enumerate(order) if name in _letters(read[other][1]))
        first = next(uses, place) if name is not None else place
        if (
            first < place
            and name not in solved
            and _explained(read[order[first]][1], facts) != name
        ):
            before, use = read[order[first]]
            # What comes of one equation for one letter may be its solution; U(θ) is a name.
            assert isinstance(each, Statement)
            alone = isinstance(each.sides[0], Letter) and len(_letters(use) - {*facts}) < 2
            alone &= not (isinstance(use, Statement) and _only_names(use, name))
            together = passage.start == before.start and not alone
            if passage.sentence > before.sentence and _is_motion(use):
                order.insert(place, number)  # what a motion that is tried takes comes out of it
                continue
            is_here = _HERE.search(passage.before[-9:]) is not None
            if together or is_here or Cue.DEFINED in passage.cues or said == passage.sentence:
                place, said = first, passage.sentence
        elif name is None or first < place:
            said = -1
        order.insert(place, number)
    return order


def _is_motion(use: Statement | Unread) -> bool:
    """Whether something is given in time."""
    if isinstance(use, Unread) or not any(CLOCK in n.letters(x) for x in use.sides[1:]):
        return False
    return not any(isinstance(x, n.TimeDerivative) for x in n.walked(use.sides[0]))


def _only_names(use: Statement, name: Letter | None) -> bool:
    """Whether it is nothing to be solved for a letter: λ θ̈ = Q sin θ or 0 = Q sin θ, Q is short."""
    factors: set[n.Node] = set()
    for side in use.sides:
        match side:
            case n.Product(many):
                factors |= {*many}
            case n.DotProduct(left, right):
                factors |= {left, right}
    rate = any(isinstance(x, n.TimeDerivative) for x in (use.sides[0], *factors))
    return rate or (ZERO in use.sides and name in factors)


def _explained(each: Statement | Unread, facts: Collection[Letter]) -> Letter | None:
    """The letter of the answer's own that a statement puts into letters of the facts."""
    if not isinstance(each, Statement) or each.relations[:1] not in (("=",), ("≡",)):
        return None
    left, right = each.sides[:2]
    match left:  # U(θ) names U
        case n.Call(Letter() as function, places) if {*places} <= {*facts}:
            left = function
    if not isinstance(left, Letter) or left in facts or n.letters(right) - {*facts}:
        return None
    return left


def _letters(each: Statement | Unread) -> frozenset[Letter]:
    return letters(each) if isinstance(each, Statement) and each.relations else frozenset()


def _only_there(k: int, read: Read, facts: Collection[Letter]) -> str:
    """The place of which a condition and the value that stood before it speak, if there is one."""
    for j in (k - 1, k):
        turned = [*read[j : j + 2]][::-1]
        if j >= 0 and len(turned) == 2 and _has_condition(0, turned, facts):
            return f"there {turned[0][0].start}"
    return ""
