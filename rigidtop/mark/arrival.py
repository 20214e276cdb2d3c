"""Whether what was said comes to the same as a statement.

Apart from what letters stand for nothing is known here: a statement is reached if it holds in every
world in which what was said holds, and not in others besides.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import combinations, islice, pairwise

from sympy import Abs, Expr, ImmutableMatrix, Integer, MatrixBase, Rational, Symbol, nan, zoo

from rigidtop.judge import worlds as w
from rigidtop.judge.context import Context, Habits
from rigidtop.judge.jets import TIME, Jet, jet_of, jets, rate, symbol
from rigidtop.judge.letters import FREQUENCIES
from rigidtop.judge.meaning import Meaning
from rigidtop.judge.names import component_of, vector_of
from rigidtop.judge.sides import EQUALS, NEARLY, has_components
from rigidtop.judge.values import UnclearError, pairs, plain
from rigidtop.judge.vocabulary import Meant, Memory
from rigidtop.mark.task import ALWAYS
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement

MOST_SIDES = 5
"""Of a longer chain the last sides are compared with what is to be reached."""

MOST_NAMES = 8
"""So often a letter of an answer is taken for one of what is to be reached."""


def equalities(sides: Sequence[Node], each: Statement) -> list[Statement]:
    """What a chain that ends with a statement says, two sides at a time."""
    both = list(combinations(sides[-MOST_SIDES:], 2))
    relation = "≈" if "→" in each.relations else each.relations[-1]
    found = [replace(each, sides=pair, relations=(relation,)) for pair in both]
    return [*found, *(with_root for x in found for with_root in _roots(x))]


def _roots(each: Statement) -> list[Statement]:
    """What a letter with two values says of letters for each: Ω = … ± … of Ω_±."""
    letter, signs = each.sides[0], any(isinstance(x, n.PlusMinus) for x in n.walked(each.sides[1]))
    if not signs or not isinstance(letter, Letter) or "±" in letter.sub:
        return []
    return [replace(each, sides=(replace(letter, sub=letter.sub + "±"), *each.sides[1:]))]


def is_reached(goal: Statement, said: Sequence[Statement], contexts: Iterable[Context]) -> bool:
    """Whether what was said comes to a statement in one of some contexts, in other names too."""
    contexts = tuple(contexts)
    given = frozenset().union(*(context.given for context in contexts))
    said = [*said, *_frequencies(goal, said, given)]
    named = [*islice(_in_names_of(goal, said, given), MOST_NAMES)]
    if there := _at_places(goal, said, contexts):
        named.append(there)
    return any(comes_to(goal, x, context) for x in (said, *named) for context in contexts)


def _in_names_of(
    goal: Statement, said: Sequence[Statement], given: frozenset[Letter]
) -> Iterator[list[Statement]]:
    """What was said of a letter with an index of its own, as said of one in a statement.

    So θ_s is where θ is, Ω₁ is one of Ω₊ and Ω₋, and u₀ after u = cos θ is cos θ₀.
    """
    spoken = frozenset().union(*map(_letters, said))
    for own in sorted(spoken - given, key=str):
        for letter in sorted(_letters(goal) - {own}, key=str):
            if own.sub and replace(own, sub=letter.sub) == letter:
                yield [
                    replace(x, sides=tuple(_with_name(side, own, letter) for side in x.sides))
                    for x in said
                    if letter not in _letters(x)
                ]


def _at_places(
    goal: Statement, said: Sequence[Statement], contexts: Iterable[Context]
) -> list[Statement]:
    """What was said of u₀ as said of cos θ₀, where u is cos θ and the goal speaks of θ₀."""
    known = {x: d.node for context in contexts for x, d in context.definitions.items()}
    places = {replace(x, sub=""): x for x in _letters(goal) if x.sub}
    values: dict[Node, Node] = {}
    for own in frozenset().union(*map(_letters, said)):
        node = known.get(replace(own, sub="")) if own.sub else None
        inside = n.letters(node) if node is not None else frozenset()
        if node is not None and inside and inside <= places.keys():
            there = n.mapped(node, lambda x: places.get(x, x) if isinstance(x, Letter) else x)
            if {x.sub for x in n.letters(there)} == {own.sub}:
                values[own] = n.Bracketed(there)

    def put(side: Node) -> Node:
        return n.mapped(side, lambda x: values.get(x, x))

    return [replace(x, sides=tuple(map(put, x.sides))) for x in said] if values else []


def _frequencies(
    goal: Statement, said: Sequence[Statement], given: frozenset[Letter]
) -> Iterator[Statement]:
    """That ω² is k after ẍ = −k x, where ω is the frequency for which a goal is one."""
    names = [x for x in n.letters(goal.sides[0]) - given if x.base in FREQUENCIES and x.sub]
    for each in said:
        rates = {
            x for x in n.walked(each.sides[0]) if isinstance(x, n.TimeDerivative) and x.order == 2
        }
        if len(rates) != 1 or len(each.sides) != 2:
            continue
        [acceleration] = rates
        left, right = each.sides
        if not _is_multiple(right, acceleration.of):
            continue
        place = n.replaced(left, acceleration, acceleration.of)
        for name in names:
            square = n.Negative(n.Quotient(n.Bracketed(right), n.Bracketed(place)))
            yield replace(each, sides=(n.Power(name, n.Number("2")), square))


def _is_multiple(side: Node, place: Node) -> bool:
    """Whether a side is a product with a letter that stands nowhere else in it."""
    while isinstance(side, n.Negative | n.Bracketed):
        side = side.of
    factors = side.factors if isinstance(side, n.Product) else ()
    return place in factors and sum(x == place for x in n.walked(side)) == 1


def _with_name(side: Node, own: Letter, letter: Letter) -> Node:
    return n.mapped(side, lambda node: letter if node == own else node)


def is_trivial(each: Statement, habits: Habits) -> bool:
    """Whether a statement holds whatever its letters are."""
    return holds_on(each, (), Context(habits, lawless=True)) is True


def is_said(line: Statement, said: Iterable[Statement]) -> bool:
    """Whether one of some true statements has a side of another true one, and so says the same."""
    sides = {_bare(side) for side in line.sides if not isinstance(side, (n.Number, n.Constant))}
    return any(_bare(side) in sides for each in said for side in each.sides)


def _bare(side: Node) -> Node:
    return n.mapped(side, n.ungrouped)


def comes_to(goal: Statement, sound: Sequence[Statement], context: Context) -> bool:
    """Whether what was said comes to a statement in a context, in the same names."""
    own = {x: d for x, d in context.definitions.items() if d.number >= 0}
    names = _names_in(goal, context)
    names |= _also_called(_letters(goal) | names, sound)
    allowed = _spelt(_letters(goal), context) | {*own} | names
    allowed |= {replace(x, bold=True) for x in allowed & context.habits.lengths}
    vectors = {x.base for x in allowed if x.bold and not x.sub}
    allowed |= {x for each in sound for x in _letters(each) if x.base in vectors and x.sub}
    # What the vector is says what its components are.
    wholes = {vector_of(x) for x in _letters(goal.sides[0]) if x.sub} & context.definitions.keys()
    allowed |= wholes | (_axes(context) if wholes or has_components(goal) else frozenset())
    allowed |= _synonyms(allowed, context)
    # Constants of the answer's own may tie what the goal speaks of, as in ω₂ = u exp(σ t).
    written = frozenset().union(*map(_letters, sound))
    tying = written - context.given - context.declared - context.definitions.keys() - allowed
    allowed |= tying
    spelt = _spelt_slopes(sound)
    said = [each for each in sound if _is_said_in(each, allowed, goal, spelt, context)]
    if not said:
        return False
    # Who speaks of the length of a vector speaks of that.
    lengths = {replace(x, bold=True) for x in _letters(goal) & context.habits.lengths}
    named = (_letters(goal) | names | lengths) & context.definitions.keys() - own.keys()
    written = frozenset().union(*map(_letters, said))
    # Who says what the components are has said what the vector is.
    spoken = (written | {vector_of(x) for x in written if x.sub}) & named
    heads = spoken & {head(goal.sides[0])}
    # What only the pages on the way to a goal say of its left side is to be said.
    here = _letters(goal.sides[0]) & named
    asked = frozenset(x for x in here if not _is_of_model(x, context))
    scalars = frozenset(x for x in spoken if not x.bold)
    constant = any(isinstance(side, n.Constant) for side in goal.sides)
    bases = context.bases if any(map(has_components, (goal, *said))) else ()
    for free in dict.fromkeys(asked | x for x in (frozenset(), heads, scalars, spoken)):
        # That a name is constant does not say of what.
        using = [x for x in said if not constant or not _letters(x) & scalars - free]
        bare = _without(free, context)
        for basis in bases or (None,):
            there = replace(bare, basis=basis)
            if any(_same(goal, each, there) for each in _selections(goal, using, tying)):
                return True
    return False


def _selections(
    goal: Statement, said: list[Statement], tying: frozenset[Letter]
) -> Iterator[list[Statement]]:
    """What was said in the letters of a goal; with what ties them; exactly; each of its head alone.

    Any of these is enough, and what else was said may not go together with the others everywhere.
    """
    plain_said = [x for x in said if not _letters(x) & tying]
    yield plain_said
    if len(plain_said) < len(said):
        yield said
    nearly = [x for x in said if {*x.relations} & {*NEARLY}]
    if nearly and not {*goal.relations} & {*NEARLY}:
        yield [x for x in said if x not in nearly]
    spoken = n.letters(goal.sides[0])
    alone = [[x] for x in said if spoken <= _letters(x)] if len(said) > 1 else []
    yield from reversed(alone)


def _synonyms(letters: frozenset[Letter], context: Context) -> frozenset[Letter]:
    """Letters of the facts that are what some letters are: L₃ where p_ψ is one of these."""
    meaning = Meaning(context, Memory())
    values: dict[Letter, Expr] = {}
    for letter in context.definitions.keys() & context.given:
        with suppress(UnclearError):
            if not isinstance(value := meaning.value(letter), MatrixBase):
                values[letter] = value.expand()
    same = {values[x] for x in letters & values.keys()}
    return frozenset(x for x, value in values.items() if value in same)


def _axes(context: Context) -> frozenset[Letter]:
    """The names of the unit vectors along which components may be meant."""
    columns = [basis[:, k] for basis in context.bases for k in range(3)]
    return frozenset(
        x
        for x, definition in context.definitions.items()
        if x.bold and isinstance(definition.node, Meant) and definition.node.value in columns
    )


def _without(letters: frozenset[Letter], context: Context) -> Context:
    """What letters are called, but for some that may be anything of their kind at any time."""
    kept = {x: d for x, d in context.definitions.items() if x not in letters}
    for letter in letters:
        with suppress(UnclearError):
            value = Meaning(context, Memory()).value(letter)
            if isinstance(value, MatrixBase):
                if not letter.bold:
                    entries = [symbol(Jet(letter, 0, (k,))) for k in range(len(value))]
                    made = Meant(ImmutableMatrix(*value.shape, entries))
                    kept[letter] = replace(context.definitions[letter], node=made)
                for each in {*kept} - letters:
                    along = component_of(each)
                    if vector_of(each) == letter and along.right in kept:
                        kept[each] = replace(kept[each], node=along)
    habits = replace(context.habits, moving=context.habits.moving | letters)
    return replace(context, definitions=kept, habits=habits, constraints=(), lawless=True)


def _is_of_model(letter: Letter, context: Context) -> bool:
    return isinstance(context.definitions[letter].node, Meant)


def _spelt(letters: frozenset[Letter], context: Context) -> frozenset[Letter]:
    """Some letters, and those by which pages say what they are."""
    known = frozenset(x for x in letters if x in context.definitions)
    below = frozenset().union(*(n.letters(context.definitions[x].node) for x in known))
    return letters if below <= letters else _spelt(letters | below, context)


def _names_in(goal: Statement, context: Context) -> frozenset[Letter]:
    """Names of numbers that are made of nothing but what a statement speaks of."""
    meaning = Meaning(context, Memory())
    try:
        spoken = {x for gap in _gaps(goal, replace(context, definitions={})) for x in _jets(gap)}
    except UnclearError:
        return frozenset()
    names = set()
    for letter in context.definitions:
        try:
            value = meaning.value(letter)
        except UnclearError:
            continue
        if not letter.bold and not isinstance(value, MatrixBase) and _jets(value) <= spoken:
            names.add(letter)
    return frozenset(names)


def _jets(expression: Expr) -> set[Letter]:
    return {jet.letter for jet in jets(expression).values()}


def _also_called(letters: frozenset[Letter], said: Iterable[Statement]) -> frozenset[Letter]:
    """Letters that are said to be made of some: p_φ in p_φ = L_z, or p_ψ in p_ψ = λ₃ ω₃."""
    equal = (x.sides for x in said if x.relations == ("=",))
    ties = (x for a, b in equal for x in ((a, b), (b, a)))
    return frozenset(
        b
        for a, b in ties
        if isinstance(b, Letter) and not b.bold and (made := n.letters(a)) and made <= letters
    )


def _same(goal: Statement, said: Sequence[Statement], context: Context) -> bool | None:
    """Whether the goal holds where the others do; None where it holds in any case."""
    try:
        asked = _gaps(goal, context)
    except UnclearError:
        return False
    given, apart = [], []
    for each in said:
        with suppress(UnclearError):
            given += _gaps(each, context)
    if any(isinstance(side, n.Constant) for side in goal.sides):
        given += [slope for gap in given if (slope := rate(gap, context.habits.moving)) != 0]
    given += [*_rates_in_time(given, asked, context)]
    for node in context.not_zero:
        with suppress(UnclearError):
            apart.append(Meaning(context, Memory()).scalar(node))
    flat = [_without_bars(x, context) for x in plain([*asked, *given, *apart])]
    count = len(asked), len(asked) + len(given)
    asked, given, apart = flat[: count[0]], flat[count[0] : count[1]], flat[count[1] :]
    letters = w.symbols_of(flat)
    if w.found([], letters).holds([(gap, 0 * gap) for gap in asked]):
        return None
    may_vanish = context.habits.moving if n.Number("0") in goal.sides else ()
    here = w.found(given, letters, may_vanish, apart)
    if not here.holds([(gap, 0 * gap) for gap in asked]):
        return False
    # Where a product vanishes it may be for another factor.
    size = Rational(7, 10)
    return not any(w.found([*given, gap - size], letters, may_vanish, apart).count for gap in asked)


def _rates_in_time(
    given: Sequence[Expr], asked: Sequence[Expr], context: Context
) -> Iterator[Expr]:
    """The rates of motions that are given in time, as far as the goal speaks of rates."""
    order = max((jet.order for gap in asked for jet in jets(gap).values()), default=0)
    motions = [gap for gap in given if gap.has(TIME)]
    for _ in range(order):
        motions = [rate(gap, context.habits.moving) for gap in motions]
        yield from motions


def _without_bars(expression: Expr, context: Context) -> Expr:
    """The same with a letter for its amount where it does not move: then it is positive."""
    put = {
        each: each.args[0]
        for each in expression.atoms(Abs)
        if isinstance(each.args[0], Symbol)
        and (jet := jet_of(each.args[0])) is not None
        and not jet.order
        and jet.letter not in context.habits.moving
    }
    return expression.xreplace(put)


def holds_on(
    statement: Statement, special: Sequence[Mapping[Expr, Expr]], context: Context
) -> bool | None:
    """Whether a statement holds where something special is put in; None where it has no value."""
    try:
        gaps = _gaps(statement, context)
    except UnclearError:
        return None
    for put in special:
        gaps = [gap.xreplace(dict(put)) for gap in gaps]
    gaps = [gap for gap in plain(gaps) if gap != 0]
    if any(gap.has(nan, zoo) for gap in gaps):
        return None
    return w.found([], w.symbols_of(gaps)).holds([(gap, 0 * gap) for gap in gaps])


def _gaps(statement: Statement, context: Context) -> list[Expr]:
    """What vanishes where a statement holds, for the upper sign and the lower one."""
    made: list[Expr] = []
    for sign in (1, -1):
        meaning = Meaning(context, Memory(), sign=sign)
        for left, right in pairwise(statement.sides):
            if isinstance(right, n.Constant):
                both = pairs(meaning.rate(meaning.value(left)), Integer(0))
            else:
                both = pairs(meaning.value(left), meaning.value(right))
            made += [a - b for a, b in both]
    return [gap for gap in dict.fromkeys(made) if gap != 0]


def _letters(written_in: Statement | Node) -> frozenset[Letter]:
    """The letters of a statement, or of a side, for both signs of ±."""
    sides = written_in.sides if isinstance(written_in, Statement) else (written_in,)
    written = frozenset().union(*map(n.letters, sides))
    both = (Meaning(Context(Habits()), sign=sign).named(x) for x in written for sign in (1, -1))
    return frozenset(both)


def head(node: Node) -> Node:
    """What is differentiated, grouped or called on a side, to its innermost."""
    while isinstance(node, (n.TimeDerivative, n.Bracketed, n.Call)):
        node = node.function if isinstance(node, n.Call) else node.of
    return node


def _spelt_slopes(sound: Iterable[Statement]) -> frozenset[Node]:
    """The derivatives of which is said what they are, as ∂ℒ/∂φ̇ = λ₁ φ̇ sin² θ + …"""

    def spells(side: Node) -> bool:
        return isinstance(side, n.Sum | n.Product | n.Bracketed) and not any(
            isinstance(x, n.Derivative) for x in n.walked(side)
        )

    return frozenset(
        side
        for each in sound
        if any(map(spells, each.sides))
        for side in each.sides
        if isinstance(side, n.Derivative)
    )


def _is_said_in(
    each: Statement,
    allowed: frozenset[Letter],
    goal: Statement,
    spelt: frozenset[Node],
    context: Context,
) -> bool:
    """Whether a statement has letters that may stand in the goal, and no derivative but there.

    That something is constant may be said of ∂ℒ/∂φ̇, in which no other letters are left, if that
    is `spelt` out.
    """
    if not {*each.relations} <= {*EQUALS, *NEARLY}:
        return False
    derived = (n.Derivative, n.Integral, n.Total)
    of_goal = any(isinstance(x, derived) for side in goal.sides for x in n.walked(side))
    constant = any(isinstance(side, n.Constant) for side in goal.sides)  # a rate that vanishes
    if not (of_goal or constant) and any(
        isinstance(x, derived) for s in each.sides for x in n.walked(s)
    ):
        return False
    if _letters(each) - ALWAYS <= allowed:
        return True
    slopes = {x for s in each.sides for x in n.walked(s) if isinstance(x, n.Derivative)}
    if not constant or not slopes <= spelt:
        return False
    try:
        spoken = {x for gap in _gaps(each, context) for x in _jets(gap)}
    except UnclearError:
        return False
    return bool(spoken) and spoken <= allowed
