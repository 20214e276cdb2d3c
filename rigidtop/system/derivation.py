"""The way from L to the equations of motion, line by line, judged by the engine of the lecture.

Every line is what a lecturer writes on the board: ∂ℒ/∂q̇, its rate, ∂ℒ/∂q, both put into
Lagrange's equation, solved for q̈; what is conserved besides.  The system says what each line is;
the engine (`rigidtop.proof.derivation`) makes the move that its sentence names with what it cites,
and has to arrive there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import sympy
from sympy import Expr, Symbol

from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.proof.derivation import Judged, Line
from rigidtop.proof.equation import Equation, Partial, Rate
from rigidtop.proof.lecture import Block, Heading, Lecture, Prose, Shown, Text
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import Known, Move, Scope
from rigidtop.proof.values import TIME
from rigidtop.report import html, plain, tex
from rigidtop.report.blocks import Display
from rigidtop.report.lines import step
from rigidtop.report.ways import gap, text_blocks
from rigidtop.system.derived import Derived
from rigidtop.system.forms import parts_of, short
from rigidtop.system.names import lettered, own_functions
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import E, Lagrangian, const
from rigidtop.typeset.latex import latex

if TYPE_CHECKING:
    from rigidtop.report.blocks import Block as Written

SOLVED = 4
"""Unknowns up to which equations are solved on the board."""

LONG = 400
"""Operations in what is solved for up to which it is written on the board."""

NAME = "the system"


@dataclass(frozen=True)
class Derivation:
    """The lines from L to the equations of motion, each with its move; it shows itself.

    `lecture` is what the engine judges: `rigidtop.proof.lecture.Lecture`.
    """

    system: Derived
    lecture: Lecture = field(repr=False)

    @cached_property
    def judged(self) -> tuple[Judged, ...]:
        """Each line with what the judge says of it, in order."""
        return tuple(self.lecture.judged(id) for id in self.lecture.lines)

    @property
    def follows(self) -> bool:
        """Whether every line follows by its move from what it cites."""
        return all(each.follows for each in self.judged)

    def gaps(self) -> tuple[str, ...]:
        """What does not follow, one line each."""
        return tuple(gap(each, self.lecture.letters) for each in self.judged if not each.follows)

    def __len__(self) -> int:
        return len(self.judged)

    def __iter__(self) -> Iterator[Judged]:
        return iter(self.judged)

    def __repr__(self) -> str:
        state = "all follow" if self.follows else f"{len(self.gaps())} do not follow"
        return f"<Derivation: {len(self)} lines, {state}>"

    @cached_property
    def blocks(self) -> list[Written]:
        """The blocks from which documents are made."""
        [page] = self.lecture.texts
        # SymPy has put the equations together: they are ordered as mechanics has it.
        return [
            replace(block, rows=tuple(replace(row, order="auto") for row in block.rows))
            if isinstance(block, Display)
            else block
            for block in text_blocks(self.lecture, page)
        ]

    def __str__(self) -> str:
        return plain.fragment(self.blocks)

    def latex(self) -> str:
        """The derivation in LaTeX, for a document that loads amsmath."""
        return tex.fragment(self.blocks)

    def html(self) -> str:
        """The derivation in HTML, its formulas in MathML."""
        return "\n".join(map(html.html_block, self.blocks))

    def markdown(self) -> str:
        """A page of a collection (`rigidtop new --system`), which reads back line by line."""
        [page] = self.lecture.texts
        lines = []
        following = (*page.blocks[1:], page.blocks[-1])
        for block, after in zip(page.blocks, following, strict=True):
            if isinstance(block, Heading):
                if isinstance(after, Shown) and after.name:
                    lines.append(f'<a id="{after.name}"></a>')
                lines.append(f"{'#' * block.level} {block.words}")
            elif isinstance(block, Prose):
                lines.append(block.words)
            elif isinstance(block, Shown) and block.line is not None:
                tag = next((e.tag for e in block.line.equations if e.tag), "")
                number = rf" \tag{{{tag}}}" if tag else ""
                sentence = f"{block.line.source} {block.line.sentence}".lstrip()
                lines += [sentence, f"$${block.latex}{number}$$"]
        return "\n\n".join(lines) + "\n"

    def _repr_html_(self) -> str:
        return self.html()

    def steps(self) -> list[dict[str, object]]:
        """The lines as records for programs, as `rigidtop derive --json` gives them."""
        return [step(self.lecture, id) for id in self.lecture.lines]


def derivation(system: Derived, section: str = "") -> Derivation:
    """The derivation of a system's equations: see `System.derivation`."""
    for x in own_functions([system.plain, *system.rules, *system.generalised_forces]):
        raise RigidtopError(f"L has the function {x}: put in what it is before you derive")
    if not isinstance(section, str):
        raise RigidtopError(f'section must be a text such as "3.1", not {in_one_line(section)}')
    writer = _Writer(system, section)
    writer.write()
    page = Text("the derivation", NAME, tuple(writer.blocks))
    return Derivation(system, Lecture(writer.letters, (page,)))


@dataclass
class _Writer:
    """Writes the lines in order, in letters that have their places in print."""

    system: Derived
    section: str = ""
    blocks: list[Block] = field(default_factory=list)
    name: str = ""
    """Of the lines that come, as claims may be called."""

    @cached_property
    def shown(self) -> dict[Symbol, Symbol]:
        """Rates and coordinates with their places in print; parameters have none of their own."""
        names = self.system.names
        row = [*names.a, *names.v, *names.q]
        return {x: lettered(x, place) for place, x in enumerate(row)} | {names.t: TIME}

    @cached_property
    def letters(self) -> Letters:
        """What the engine has to know of the letters."""
        names, shown = self.system.names, self.shown
        q, v, a = (tuple(shown[x] for x in group) for group in (names.q, names.v, names.a))
        every = (*self.system.parameters, *names.q, *names.v, *names.a)
        # A plain symbol is called as it likes: a is no length because the lecture's is one.
        units = {shown.get(x, x): x.quantity.unit for x in every if isinstance(x, Lettered)}
        return Letters(
            numbers=frozenset(self.system.parameters),
            coordinates=q,
            rates=dict(zip((*q, *v), (*v, *a), strict=True)),
            units=units,
        )

    def write(self) -> None:
        """Write the whole derivation into `blocks`."""
        system, names = self.system, self.system.names
        letters = _between([self.own(x) for x in names.q])
        self.heading("The equations of motion for ", *letters, level=1)
        self.heading("Laws")
        self.L = self.law("Given", "The Lagrangian", Equation(Lagrangian, self.own(system.plain)))
        laws = []
        for k, x in enumerate(self.own(y) for y in names.q):
            pushed = system.generalised_forces[k] + system.reactions[k]
            right = Partial(Lagrangian, x) + self.own(pushed)
            equation = Equation(Rate(Partial(Lagrangian, self.own(names.v[k]))), right)
            laws.append(
                self.law("Lagrange 1788", "Lagrange's equation for ", equation, x, along=True)
            )
        count = len(system.rules)
        rules = [
            self.law(
                "Given", _numbered("the constraint", i, count), Equation(self.own(x), 0), along=True
            )
            for i, x in enumerate(system.rules)
        ]
        slopes = {self.own(v): Partial(Lagrangian, self.own(v)) for v in names.v}
        turned = sympy.Add(*(v * slope for v, slope in slopes.items()), -Lagrangian)
        self.jacobi = self.law("Jacobi's integral", "The energy", Equation(E, turned))
        coordinates = [self.coordinate(k, law) for k, law in enumerate(laws)]
        held = [self.held(rule, i) for i, rule in enumerate(rules)]
        solved = self.solved([balanced for balanced, _ in coordinates], held)
        self.energy([momentum for _, momentum in coordinates], solved)

    # --- lines ------------------------------------------------------------------------------------

    def own(self, value: Expr) -> Expr:
        """An expression in the letters in which the derivation shows it."""
        return value.xreplace(self.shown)

    def tag(self, number: str) -> str:
        """An equation's number, in the section if there is one."""
        return f"{self.section}.{number}" if self.section else number

    def heading(self, *words: Expr | str, level: int = 2, name: str = "") -> None:
        self.name = name
        self.blocks.append(Heading(level, _said(words), len(self.blocks) + 1, words))

    def law(
        self, source: str, called: str, equation: Equation, *more: Expr, along: bool = False
    ) -> Known:
        """What stands by itself, with its source; some of it holds along the motion only."""
        words = ("Along the motion, " + called if along else called, *more)
        scope = Scope.MOTION if along else Scope.IDENTITY
        return self.line(words, equation, None, scope, called + _said(more), f"{source}.")

    def line(
        self,
        words: Sequence[Expr | str],
        equations: Equation | Sequence[Equation],
        move: Move | None,
        scope: Scope = Scope.IDENTITY,
        called: str = "",
        source: str = "",
    ) -> Known:
        """Write a line with its sentence; returns what later lines may cite."""
        spoken, at = (*words, ":"), len(self.blocks) + 1
        row = (equations,) if isinstance(equations, Equation) else tuple(equations)
        line = Line(
            id=f"line {at}",
            equations=row,
            sentence=_said(spoken),
            words=spoken,
            move=move,
            scope=scope,
            called=called,
            source=source,
            file="the derivation",
            at=at,
        )
        tex = r",\quad ".join(latex(each) for each in row)
        self.blocks.append(Shown(tex, at, line, name=self.name))
        return Known(line.id, line.equations, line.scope, called=line.called)

    def coordinate(self, k: int, law: Known) -> tuple[Known, Known]:
        """∂ℒ/∂q̇, its rate, ∂ℒ/∂q, put into Lagrange's equation; and the first of these."""
        system, names = self.system, self.system.names
        x, v = self.own(names.q[k]), self.own(names.v[k])
        by_rate, by_place = Partial(Lagrangian, v), Partial(Lagrangian, x)
        momentum = self.own(short(system.conjugate[k]))
        slope = self.own(short(system.plain.diff(names.q[k])))
        self.heading("Equation of motion for ", x)
        p = self.line(
            ("Differentiate the Lagrangian with respect to ", v),
            Equation(by_rate, momentum),
            Move("differentiate", (self.L,), by=(v,)),
        )
        force = self.line(
            ("Differentiate the Lagrangian with respect to ", x),
            Equation(by_place, slope),
            Move("differentiate", (self.L,), by=(x,)),
        )
        if system.q[k] in system.cyclic:
            self.conserved(p, force, law, x)
        rate = short(self.rate(momentum))
        turning = self.line(
            ("Differentiate ", by_rate, " in time"),
            Equation(Rate(by_rate), rate),
            Move("rate", (p,)),
        )
        [equation] = law.equations
        right = short(equation.sides[1].xreplace({by_place: slope}))
        line = self.line(
            ("Substitute it and ", by_place, " into Lagrange's equation for ", x),
            Equation(rate, right, tag=self.tag(str(k + 1))),
            Move("put", (law,), using=(turning, force)),
        )
        return line, p

    def conserved(self, p: Known, force: Known, law: Known, x: Expr) -> None:
        """The momentum of a cyclic coordinate."""
        by_rate, momentum = p.equations[0].sides
        kept = self.line(
            ("Substitute into Lagrange's equation for ", x),
            Equation(Rate(by_rate), 0),
            Move("put", (law,), using=(force,)),
        )
        self.line(
            ("Hence ", by_rate, " is conserved"),
            Equation(by_rate, momentum, const),
            Move("integrate", (kept,), using=(p,)),
        )

    def rate(self, value: Expr) -> Expr:
        """d/dt of a value in the letters that are shown."""
        rates = self.letters.rates
        return sympy.Add(*(value.diff(x) * rate for x, rate in rates.items()), value.diff(TIME))

    def held(self, rule: Known, i: int) -> Known:
        """A constraint, its rate taken until it has accelerations."""
        count = len(self.system.rules)
        self.heading("The rate of " + _numbered("the constraint", i, count))
        line, words = rule, f"Differentiate {rule.called} in time"
        for last in (False, True) if self.system.holonomic[i] else (True,):
            rate = short(self.rate(line.equations[0].sides[0]))
            line = self.line(
                (words,),
                Equation(rate, 0, tag=self.tag(f"c{i + 1}") if last else ""),
                Move("rate", (line,)),
            )
            words = "Differentiate in time"
        return line

    def solved(self, balanced: Sequence[Known], held: Sequence[Known]) -> list[Known]:
        """The accelerations, of equations that hang together at once; none where that is long."""
        system, names = self.system, self.system.names
        unknown = [*names.a, *system.multipliers]
        parts = parts_of(names.plain(system.mass_matrix))
        if held:
            parts = [list(range(len(unknown)))]
        self.heading("The accelerations", name="accelerations")
        if (most := max(map(len, parts))) > SOLVED:
            return self.unsolved(f"{most} unknowns stand in {most} equations at once")
        values = [*map(names.plain, (*system.accelerations, *system.constraint_forces))]
        if (most := max(value.count_ops() for value in values)) > LONG:
            return self.unsolved(f"the longest of them would have {most} operations")
        lines = []
        for part in parts:
            equations = [(*balanced, *held)[k] for k in part]
            which = _listed([f"({line.tag})" for line in equations])
            wanted = [self.own(unknown[k]) for k in part]
            lines.append(
                self.line(
                    (f"Solve {which} for ", *_between(wanted)),
                    [Equation(x, self.own(values[k])) for x, k in zip(wanted, part, strict=True)],
                    Move("solve", tuple(equations), by=tuple(wanted)),
                )
            )
        return lines

    def unsolved(self, why: str) -> list[Known]:
        """Say why equations are not solved on the board."""
        sentence = f"They are not solved here: {why}. In numbers `accelerations` has them."
        self.blocks.append(Prose(sentence, len(self.blocks) + 1, (sentence,)))
        return []

    def energy(self, momenta: Sequence[Known], solved: Sequence[Known]) -> None:
        """Jacobi's integral, and that it is constant where it is."""
        system, names = self.system, self.system.names
        slopes = [Partial(Lagrangian, self.own(v)) for v in names.v]
        self.heading("The energy", name="energy")
        energy = self.line(
            ("Substitute the Lagrangian", *_more(slopes), " into the energy"),
            Equation(E, self.own(system.jacobi)),
            Move("put", (self.jacobi,), using=(self.L, *momenta)),
        )
        if "energy" not in system.constant or not solved or system.constraints:
            return
        letters = [e.sides[0] for line in solved for e in line.equations]
        kept = self.line(
            ("Using ", *_between(letters), ", differentiate in time"),
            Equation(Rate(E), 0),
            Move("rate", (energy,), using=tuple(solved)),
        )
        self.line(
            ("Hence ", E, " is conserved"),
            Equation(E, energy.equations[0].sides[1], const),
            Move("integrate", (kept,), (energy,)),
        )


def _numbered(what: str, k: int, count: int) -> str:
    return what if count == 1 else f"{what} no. {k + 1}"


def _said(words: Sequence[Expr | str]) -> str:
    """A sentence with its mathematics in dollars."""
    return "".join(x if isinstance(x, str) else f"${latex(x)}$" for x in words)


def _listed(words: Sequence[str]) -> str:
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def _between(letters: Sequence[Expr]) -> list[Any]:
    """Letters as a list in words: "x, y and z"."""
    return _more(letters)[1:]


def _more(letters: Sequence[Expr]) -> list[Any]:
    """The same with a comma or "and" before each: ", x, y and z"."""
    pieces: list[Expr | str] = []
    for k, x in enumerate(letters):
        pieces += [" and " if k == len(letters) - 1 else ", ", x]
    return pieces
