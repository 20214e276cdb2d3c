"""Letters that a statement gives a meaning: for the first time, or again in another part."""

from __future__ import annotations

from dataclasses import replace

from sympy import MatrixBase, Symbol

from rigidtop.judge.context import PREMISE as SUPPOSED
from rigidtop.judge.context import RULE, Constraint, Context, LetterDefinition
from rigidtop.judge.jets import TIME
from rigidtop.judge.laws import ENERGIES
from rigidtop.judge.letters import COORDINATES
from rigidtop.judge.names import is_vector
from rigidtop.judge.numbers import are_numbers, compared
from rigidtop.judge.outcome import DEFINITION, Outcome
from rigidtop.judge.question import Judgement, Question
from rigidtop.judge.sides import ZERO, letters_of, named, own_letters, speaks_of
from rigidtop.judge.values import UnclearError, Value
from rigidtop.judge.vocabulary import Curvature, Meant
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words
from rigidtop.tree.several import signed


def definition(question: Question, name: Node, other: Node) -> Judgement | None:
    """What a letter stands for that nothing has fixed yet."""
    letter, places = named(name)
    if letter is None or isinstance(other, n.Constant):
        return None
    if question.at.instant and not isinstance(n.ungrouped(_bare(other)), n.Matrix):
        return None  # the tensor about the centre is no value at one moment
    context, habits = question.context, question.context.habits
    if letter == Letter("π") and letter not in habits.own:
        return None
    spoken = context.letters | context.definitions.keys()
    if isinstance(name, n.Primed) and name.of in spoken & habits.functions.keys():
        return None  # a derivative of what is known
    letter = question.meaning().named(letter)
    index = next((x for x in habits.indices if letter.sub == x), "")
    deviates = _deviates(question, letter, other)
    if letter in context.definitions and not (deviates or _only_names(question, letter)):
        return None
    if letter in context.given or letter in own_letters(other) or _acts(letter, other):
        return None
    meaning = question.meaning(bound={index: 0} if index else {})
    value = meaning.value(other)
    if speaks_of(value, letter) or _is_clock(question, letter, other, value):
        return None
    if letter in habits.lengths and speaks_of(value, replace(letter, bold=True)):
        return None  # its length is known
    place = name is question.right and question.left in context.letters
    if place and (letter in context.letters or not question.at.derived):
        return None  # at x = a
    if (
        name is question.right
        and letter in context.letters
        and not isinstance(question.left, Letter)
    ):
        return None  # what it is equal to is worked out
    free = letter in habits.fields or _is_replaced(question, letter, other)
    free |= _has_columns(question, letter, other)
    if not free and _is_fixed(question, letter, value):
        return None
    if meaning.component(letter) is not None:
        return None
    if letter in habits.moving and are_numbers(value, value) and question.at.inline:
        return None  # a place where it may be
    if name is question.right and question.moves(value):
        return None  # x + y = s ties x to y, and s is what it is
    if _stays(question, letter, value):
        return None  # put into a Lagrangian, it would hide how the letter moves
    if is_vector(letter) and not isinstance(value, MatrixBase) and value != 0:
        raise UnclearError("one side is a vector, the other is a number")
    at, node = question.at, signed(other, question.signs[0])
    supposed = _is_case(question, letter, node)
    meant = LetterDefinition(node, at.number, at.scope, places, index, supposed=supposed)
    if deviates:
        meant = replace(meant, deviation=True)
        context = context.deviating(letter)
    known = context.defining(letter, meant)
    why = f"what {in_words(name)} stands for"
    brings = frozenset({in_words(letter)})
    return Outcome(DEFINITION, why, frozenset(meaning.used), brings=brings), known


def _deviates(question: Question, letter: Letter, other: Node) -> bool:
    """Whether it is a place and what moves away from there, as r = a + ε, or 0 + ε."""
    context = question.context
    if letter not in question.moving or question.at.closed:
        return False
    terms = other.terms if isinstance(other, n.Sum) else (other,)
    new = {x for x in terms if x in question.moving and x not in context.letters}
    before = context.definitions.get(letter)
    return bool(new) and (
        before is None or not own_letters(before.node).isdisjoint(question.moving)
    )


def nearly(question: Question) -> Judgement | None:
    """What ω₁ ≈ w calls the value of what hardly changes: a new letter for one that moves."""
    name, left, context, at = question.right, question.left, question.context, question.at
    known = context.letters | context.given | context.declared | context.definitions.keys()
    if not isinstance(name, Letter) or name in known or left not in question.moving:
        return None
    brings = frozenset({in_words(name)})
    outcome = Outcome(DEFINITION, f"what {in_words(name)} stands for", brings=brings)
    return outcome, context.defining(name, LetterDefinition(left, at.number, at.scope))


def _is_clock(question: Question, letter: Letter, other: Node, value: Value) -> bool:
    """Whether it is the time, by what is given in time itself: t = γ(t′ + v x′/c²)."""
    called = any(isinstance(x, n.Call) for x in n.walked(other))  # t = x(t)/u is put into others
    timed = not isinstance(value, MatrixBase) and value.has(TIME)
    return letter == question.context.habits.running and timed and not called


def _acts(letter: Letter, other: Node) -> bool:
    """Whether a letter is a function whose value is taken: f in 2 f(x)."""
    return any(isinstance(x, n.Call) and x.function == letter for x in n.walked(other))


def form(question: Question) -> Judgement | None:
    """The matrix that a quadratic form is said to have, where the form is known: V = ½ qᵀ K q."""
    left, right, at = question.left, question.right, question.at
    known = question.context.definitions
    match right:
        case n.Product((*numbers, n.TransposedMatrix(column), Letter() as matrix, other)):
            is_form = column == other and not frozenset().union(*map(n.letters, numbers))
        case _:
            return None
    if not is_form or left not in known or matrix in known.keys() | question.context.given:
        return None
    half = n.Quotient(n.Number("1"), n.Product((n.Number("2"), *numbers)))
    meant = LetterDefinition(n.Product((half, Curvature(left, column))), at.number, at.scope)
    words = f"{in_words(matrix)} is the matrix of {in_words(left)}"
    brings = frozenset({in_words(matrix)})
    return Outcome(DEFINITION, words, brings=brings), question.context.defining(matrix, meant)


def _bare(node: Node) -> Node:
    """The last factor of a product."""
    return node.factors[-1] if isinstance(node, n.Product) else node


def _has_columns(question: Question, letter: Letter, other: Node) -> bool:
    """Whether words give a vector its components, of which laws have spoken: with r = (x, y, 0)."""
    at = question.at
    return letter.bold and at.inline and not at.derived and isinstance(n.ungrouped(other), n.Tuple)


def _is_replaced(question: Question, letter: Letter, other: Node) -> bool:
    """Whether another letter that moves takes the place of one: put z = h + u."""
    at, moving = question.at, question.moving
    new = own_letters(other) & moving - question.context.letters
    said = at.supposed or at.defined or (at.inline and not at.derived)
    return said and letter in moving and len(new) == 1


def _stays(question: Question, letter: Letter, value: Value) -> bool:
    """Whether a letter that a law moves is said to stay at a value with a name, as in θ = θ₀."""
    named = isinstance(value, Symbol) and not question.moves(value)
    return named and any(
        letter in letters_of(each.expression) and each.constraint is None for each in question.pool
    )


def _is_case(question: Question, letter: Letter, node: Node) -> bool:
    """Whether a letter is given a number that is supposed, or is one of two that are equal."""
    alike = isinstance(node, Letter) and node.base == letter.base
    alike = alike and not _is_measure(question, letter, node)
    at, passed = question.at, letter.base in COORDINATES and not letter.sub
    if passed and at.inline and not at.derived and letter in question.context.letters:
        return True  # half way, x = A/2
    again = at.supposed and at.inline and not at.defined and letter in question.context.letters
    return alike or again or (at.supposed and not n.letters(node))


def _is_measure(question: Question, letter: Letter, node: Node) -> bool:
    """Whether others of its kind are given by the same letter: with m₁ = 4 m and m₃ = m."""
    known = question.context.definitions.items()
    return any(
        x != letter and x.base == letter.base and x != node and node in n.letters(each.node)
        for x, each in known
        if each.node != node
    )


def _only_names(question: Question, letter: Letter) -> bool:
    """Whether a letter stands for others of which not all is said, as L does in L = T − V."""
    context = question.context
    names = n.letters(context.definitions[letter].node)
    known = {*context.definitions, *question.moving}
    return (
        bool(names - known)
        and all(x in ENERGIES for x in names)
        and not any(names & n.letters(c.left) | n.letters(c.right) for c in context.constraints)
    )


def _is_fixed(question: Question, letter: Letter, value: Value) -> bool:
    """Whether something that holds speaks of the letter, so that it is no name to give.

    A law moves a coordinate and does not say where it is; but a motion that is given in time
    has to obey it. What follows from a Lagrangian with an unknown function does not say which.
    """
    motion = letter in question.moving and not value.has(TIME)
    return any(
        speaks_of(each.expression, letter, functions=each.constraint is not None)
        and (each.constraint is not None or not motion)
        for each in question.pool
    )


def again(question: Question) -> Judgement | None:
    """A letter that is used again in another part of the text."""
    letter, places = named(question.left)
    context, at = question.context, question.at
    older = context.definitions.get(letter) if letter is not None else None
    if letter is None or older is None or at.instant or not _may_be_another(question, older):
        return None
    if question.right in context.definitions and at.scope == older.scope:
        return None  # where two of them are equal
    value = question.meaning().value(question.right)
    if speaks_of(value, letter) or isinstance(value, MatrixBase) != is_vector(letter):
        return None
    kept = tuple(
        c
        for c in context.constraints
        if c.kind == RULE or letter not in n.letters(c.left) | n.letters(c.right)
    )
    newer = LetterDefinition(question.right, at.number, at.scope, places)
    known = _given_anew(replace(context, constraints=kept), letter, newer)
    return Outcome(DEFINITION, f"{in_words(letter)} is used again"), known


def number_again(question: Question) -> Judgement | None:
    """A number that is given to a letter in place of the one that it had in another problem.

    A measured one contradicts the one above where words say that it has been said before.
    """
    letter, _ = named(question.left)
    context, at = question.context, question.at
    older = context.definitions.get(letter) if letter is not None else None
    if letter is None or older is None or at.instant:
        return None
    measured = any(isinstance(x, n.Unit) for x in n.walked(older.node))
    given = not own_letters(older.node) and (measured or not own_letters(question.right))
    new = not at.repeated if measured else at.inline
    other = (
        at.extreme or (new and not at.derived) or (measured and bool(own_letters(question.right)))
    )
    other &= not question.inner
    if not given or not (other or _may_be_another(question, older)):
        return None
    if compared(question.left, question.right, question.meant).passed:
        return None
    known = _given_anew(context, letter, LetterDefinition(question.right, at.number, at.scope))
    return Outcome(DEFINITION, f"{in_words(letter)} is used again"), known


def _given_anew(context: Context, letter: Letter, newer: LetterDefinition) -> Context:
    """What is known where a letter stands for something else from here on.

    An equation that has been solved for it holds as before: e = 1 in w − v = e u.
    """
    older = context.definitions[letter]
    if isinstance(older.node, Meant):
        equation = Constraint(letter, older.node, older.number, SUPPOSED, older.scope)
        context = context.holding(equation)
    return context.defining(letter, newer)


def _may_be_another(question: Question, older: LetterDefinition) -> bool:
    """Whether what a letter stood for may be another problem's: outside, or by the words."""
    at = question.at
    within = at.scope[: len(older.scope)] == older.scope
    if within and question.right == ZERO and own_letters(older.node):
        return False  # where it vanishes
    said = at.scope != older.scope and (at.defined or at.supposed) and not at.derived
    # A property, as a moment of inertia, is another body's; what moves is a special motion.
    moves = question.moves(*(x for pair in question.meant for x in pair))
    other = at.supposed and at.inline and not (moves or at.small or at.large)
    both = isinstance(older.node, Letter) and isinstance(question.right, Letter)
    named = both and at.supposed and at.inline  # for q = x, and for q = y
    # In a part of its own what stands for something free is given numbers.
    number = at.scope != older.scope and bool(own_letters(older.node)) and not at.derived
    named |= number and not own_letters(question.right)
    columns = isinstance(older.node, n.Tuple) and isinstance(question.right, n.Tuple)
    named |= columns and at.inline and not at.derived
    return not within or (not question.inner and (said or other or named or at.anew))
