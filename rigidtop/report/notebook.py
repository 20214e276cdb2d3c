"""Jupyter: symbols print as in the notes, claims with their verdicts; pictures, and sliders.

After `enable()`, which ``from rigidtop.notebook import *`` calls, a SymPy expression, a matrix or
an `Equation` that ends a cell is typeset as the notes print it, a `Claim` is judged and shown with
its verdict, and an `Exercise` asks.  It needs `pip install 'rigidtop[notebook]'`.
"""

from __future__ import annotations

import base64
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from io import BytesIO
from typing import Any

import matplotlib
import sympy
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from PIL import Image
from sympy import Basic

from rigidtop.derivations import PAGES, lecture, lecture_with
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.derivations.letters import LETTERS
from rigidtop.errors import RigidtopError
from rigidtop.figures.catalog import named
from rigidtop.figures.style import STYLE, WIDE, canvas
from rigidtop.parameters import settings
from rigidtop.proof.equation import Equation
from rigidtop.proof.exercise import Exercise, texts
from rigidtop.proof.page import Claim
from rigidtop.proof.verdict import Judgement, judge
from rigidtop.report import plain
from rigidtop.report.blocks import Display, TableBlock
from rigidtop.report.claims import claim_blocks
from rigidtop.report.markdown import LINE, markdown
from rigidtop.report.solutions import Solution, question, solved
from rigidtop.report.solutions import blocks as solution_blocks
from rigidtop.report.ways import way_blocks
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset.latex import aligned, aligned_lines, latex
from rigidtop.typeset.text import letter as text_letter
from rigidtop.typeset.text import text
from rigidtop.typeset.words import unmarked

DOTS = 144
"""Of a picture, to the inch; on the page an inch is 96 pixels, so a fine screen has use for it."""

COLOURS = 64
"""Of a picture; lines on paper need no more."""


def enable(formatter: Any = None) -> None:
    """Show the objects of rigidtop and SymPy as the notes print them, in the running notebook.

    `formatter` is an IPython `DisplayFormatter`; by default that of the running shell.  Raises
    RigidtopError where there is none.

    >>> from IPython.core.formatters import DisplayFormatter
    >>> from rigidtop.theory.symbols import lambda1, phidot
    >>> formatter = DisplayFormatter()
    >>> enable(formatter)
    >>> shown, _ = formatter.format(lambda1 * phidot)
    >>> print(shown["text/latex"], shown["text/plain"])
    $\\displaystyle \\lambda_{1}\\dot{\\phi}$ λ₁φ̇
    """
    formatters = (formatter or _shell().display_formatter).formatters
    tex, words = formatters["text/latex"], formatters["text/plain"]
    for kind in (sympy.Basic, sympy.MatrixBase, Equation):
        words.for_type(kind, lambda tree, printer, cycle: printer.text(_words(tree)))
    for kind in (sympy.Basic, sympy.MatrixBase, Equation, list, tuple, dict):
        tex.for_type(kind, typeset)
    for kind in (Claim, Judgement, Exercise, Solution, StepList):
        words.for_type(
            kind, lambda thing, printer, cycle: printer.text(plain.fragment(shown_blocks(thing)))
        )
        formatters["text/markdown"].for_type(kind, lambda thing: markdown(shown_blocks(thing)))


def _shell() -> Any:
    try:
        from IPython.core.getipython import get_ipython
    except ImportError:
        raise _missing() from None
    shell = get_ipython()
    if shell is None:
        raise RigidtopError("enable() is for a notebook: here is no running IPython")
    return shell


def _missing() -> RigidtopError:
    return RigidtopError("notebooks need Jupyter: pip install 'rigidtop[notebook]'")


# --- Formulas ------------------------------------------------------------------------------------


def typeset(tree: Basic) -> str | None:
    r"""LaTeX between dollars; None for what is no formula.

    A sequence of equations is aligned at their signs, a mapping is shown as equations.

    >>> from rigidtop.theory.symbols import Omega, lambda1, lambda3, theta, thetadot
    >>> print(typeset([Equation(Omega, lambda1, tag="3.1"), Equation(theta, lambda3)]))
    $\displaystyle \begin{aligned}
    \Omega &= \lambda_{1} && \text{(3.1)} \\
    \theta &= \lambda_{3}
    \end{aligned}$
    >>> print(typeset((lambda1, thetadot)), typeset((1, 2)))
    $\displaystyle \left(\lambda_{1},\; \dot{\theta}\right)$ None
    """
    if isinstance(tree, Equation):
        return _between(_aligned([tree]))
    if isinstance(tree, Mapping):
        if tree and all(_symbolic(x) for pair in tree.items() for x in pair):
            return _between(_aligned([Equation(*pair) for pair in tree.items()]))
        return None
    if isinstance(tree, (list, tuple)):
        if tree and all(isinstance(item, Equation) for item in tree):
            return _between(_aligned(tree))
        if tree and all(map(_symbolic, tree)):
            inside = r",\; ".join(map(_tex, tree))
            return _between(rf"\left({inside}\right)")
        return None
    return _between(_tex(tree))


def _between(tex: str) -> str:
    return rf"$\displaystyle {tex}$"


def _symbolic(item: Any) -> bool:
    return isinstance(item, (sympy.Basic, sympy.MatrixBase, Equation))


def _tex(tree: Basic) -> str:
    try:
        return latex(tree)
    except TypeError:  # an integral, a set: SymPy's own layout, with the letters of the notes
        return str(sympy.latex(tree, symbol_names=_letters()))


@cache
def _letters() -> dict[sympy.Symbol, str]:
    return {symbol: latex(symbol) for symbol in VOCABULARY}


def _aligned(equations: Sequence[Equation]) -> str:
    rows = []
    for equation in equations:
        try:
            lines = aligned_lines([equation], limit=LINE)
        except TypeError:
            left, *others = map(_tex, equation.sides)
            lines = [f"{left} &{equation.relation} " + f" {equation.relation} ".join(others)]
        lines[-1] += rf" && \text{{({equation.tag})}}" if equation.tag else ""
        rows += lines
    return aligned(rows)


def _words(tree: Basic) -> str:
    try:
        return text(tree, tag=True)
    except TypeError:
        sides = tree.sides if isinstance(tree, Equation) else [tree]
        return f" {tree.relation} ".join(map(str, sides)) if len(sides) > 1 else str(tree)


# --- Claims and exercises ------------------------------------------------------------------------

OWN_WAY = ("Derivation", "The engine's own expressions")
"""Labels of what a notebook derives itself, or need not see."""


@dataclass(frozen=True)
class StepList:
    """The lines of the lecture that lead to an equation or a claim."""

    name: str


def steps(name: str) -> StepList:
    """The lines that lead to an equation by its number, or to a claim, as `derive` prints them.

    Raises RigidtopError for a name that the lecture does not have.

    >>> steps("3.57")
    StepList(name='3.57')
    """
    if name not in lecture().names:
        raise RigidtopError(f"no lines of the lecture lead to {name!r}")
    return StepList(name)


def shown_blocks(thing: Claim | Judgement | Exercise | Solution | StepList) -> list[Any]:
    """What a notebook shows of a claim, judged, and of an exercise, solved or not.

    Of a claim alone its verdict, its conditions and its counterexamples; the whole derivation is in
    the lecture.  Never what is measured on motions: its last digits differ between machines.
    """
    if isinstance(thing, Exercise):
        return question(thing, settings(thing.parameters))
    if isinstance(thing, StepList):
        return way_blocks(lecture(), thing.name)
    if isinstance(thing, Solution):
        blocks = solution_blocks(thing)
        left_out: tuple[str, ...] = OWN_WAY[1:]
    else:
        blocks = claim_blocks(_judged(thing) if isinstance(thing, Claim) else thing)
        left_out = OWN_WAY
    return [
        block
        for block in blocks
        if not (isinstance(block, TableBlock) and block.head[-1] == "tolerance")
        and not (isinstance(block, Display) and block.label in left_out)
    ]


def verdict(name: str) -> Claim:
    """A claim of the lecture by its name; a notebook shows it judged.

    Raises RigidtopError for a name that no claim has.

    >>> verdict("axis-stability").name
    'axis-stability'
    """
    claims: dict[str, Claim] = {claim.name: claim for page in PAGES for claim in page.claims}
    if name in claims:
        return claims[name]
    raise RigidtopError(f"no claim of the lecture is called {name!r}")


def solution(name: str, **given: float) -> Solution:
    """An exercise of the lecture by its name, solved, with parameters by name.

    Raises RigidtopError for an unknown name or parameter, and for a value out of range.

    >>> solution("toppling-top", until=2.0).settings["until"]
    2.0
    """
    by_name = {exercise.name: exercise for exercise in EXERCISES}
    if name not in by_name:
        raise RigidtopError(f"no exercise {name!r}; there are {', '.join(by_name)}")
    exercise = by_name[name]
    return solved(exercise, given, lines=lecture_with(texts([exercise], EXERCISES)))


@cache
def _judged(claim: Claim) -> Judgement:
    """A claim is shown in more than one way, and judged once."""
    return judge(claim, letters=LETTERS)


# --- Pictures ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Picture:
    """A picture as a notebook shows it, and in `words` what there is to see."""

    png: bytes = field(repr=False)
    words: str
    width: int
    """On the page (pixels)."""

    def _repr_mimebundle_(self, **_: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        data = base64.b64encode(self.png).decode("ascii")
        bundle = {"image/png": data, "text/plain": unmarked(self.words)}
        return bundle, {"image/png": {"width": self.width}}


def picture(drawn: Canvas, words: str) -> Picture:
    """The picture that is drawn at these values of the sliders."""
    buffer = BytesIO()
    with matplotlib.rc_context(STYLE):
        drawn.savefig(buffer, format="png", dpi=DOTS, facecolor="white")
    whole = Image.open(buffer).convert("RGB")
    small = BytesIO()
    whole.quantize(COLOURS, dither=Image.Dither.NONE).save(small, format="png", optimize=True)
    return Picture(small.getvalue(), words, round(96 * drawn.get_size_inches()[0]))


def figure(name: str, **given: float) -> Picture:
    """A figure of the catalogue, `rigidtop.figures.catalog`, with parameters by name.

    Raises RigidtopError for an unknown name or parameter, and for a value out of range.
    """
    drawing = named(name)
    values = drawing.values(given)
    with matplotlib.rc_context(STYLE):
        return picture(drawing.draw(**values), drawing.caption(**values))


@contextmanager
def plot(words: str, width: float = WIDE, height: float = 2.6, columns: int = 1) -> Iterator[Any]:
    """Axes to draw on, in the style of rigidtop's figures; shown when the block ends.

    `words` say what there is to see, for who cannot see it.  `width` and `height` are in inches.
    With several `columns` there are as many Axes beside each other.

        with plot("θ against t", columns=2) as (left, right):
            left.plot(path.t, path.theta)
    """
    with matplotlib.rc_context(STYLE):
        drawn = canvas(width, height)
        yield drawn.subplots(1, columns)
        finished = picture(drawn, words)
    _display(finished)


def _display(thing: Any) -> None:
    try:
        from IPython.display import display
    except ImportError:
        raise _missing() from None
    display(thing)  # type: ignore[no-untyped-call]


# --- Sliders -------------------------------------------------------------------------------------

Draw = Callable[..., None]
WIDGET = "application/vnd.jupyter.widget-view+json"
"""What a notebook shows in place of the picture while a kernel runs."""


@dataclass(frozen=True)
class Sliders:
    """A picture that follows its sliders; without a kernel it is the picture of their start."""

    draw: Draw
    words: str
    ranges: Mapping[str, tuple[float, float, float]]
    width: float
    height: float
    columns: int

    def picture(self, values: Mapping[str, float]) -> Picture:
        """The picture that is drawn at these values of the sliders."""
        with matplotlib.rc_context(STYLE):
            drawn = canvas(self.width, self.height)
            axes = drawn.subplots(1, self.columns)
            self.draw(*([axes] if isinstance(axes, Axes) else axes), **values)
            return picture(drawn, self.words)

    def start(self) -> dict[str, float]:
        """The values at which the sliders are at first."""
        return {name: start for name, (_, start, _) in self.ranges.items()}

    def widget(self) -> Any:
        """The sliders above their picture, as an `ipywidgets.VBox`."""
        try:
            import ipywidgets
        except ImportError:
            raise _missing() from None
        controls = {
            name: ipywidgets.FloatSlider(
                value=start,
                min=least,
                max=most,
                step=10.0 ** math.floor(math.log10((most - least) / 100)),
                description=slider_label(name),
                readout_format=".3g",
                style={"description_width": "7rem"},
                layout={"width": "32rem"},
            )
            for name, (least, start, most) in self.ranges.items()
        }
        image = ipywidgets.Image(layout={"max_width": "100%"})
        says = ipywidgets.Label()

        def follow(_: Any = None) -> None:
            try:
                drawn = self.picture({name: control.value for name, control in controls.items()})
            except RigidtopError as error:  # there is no such motion: say so, keep the last
                says.value = str(error)
                return
            says.value, image.value, image.width = "", drawn.png, str(drawn.width)

        for control in controls.values():
            control.observe(follow, "value")
        follow()
        return ipywidgets.VBox([*controls.values(), says, image])

    def _repr_mimebundle_(self, **_: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        bundle, beside = self.picture(self.start())._repr_mimebundle_()
        live = self.widget()._repr_mimebundle_()
        return {**bundle, WIDGET: live[WIDGET]}, beside


def sliders(
    draw: Draw,
    words: str,
    *,
    width: float = WIDE,
    height: float = 2.6,
    columns: int = 1,
    **ranges: tuple[float, float, float],
) -> Sliders:
    """A picture to play with: ``sliders(draw, "…", theta=(0.1, 0.5, 1.5))``.

    `draw` takes as many Axes as there are `columns`, then the values by name.  Each range is
    (least, at the start, most).  A RigidtopError that `draw` raises is shown beside the sliders.
    """
    return Sliders(draw, words, ranges, width, height, columns)


def slider_label(name: str) -> str:
    """A name with the glyph and the unit that it has in the vocabulary.

    >>> slider_label("omega3"), slider_label("phi_dot"), slider_label("turns")
    ('ω₃ (rad/s)', 'φ̇ (rad/s)', 'turns')
    """
    entries = {symbol.name: quantity for symbol, quantity in VOCABULARY.items()}
    quantity = entries.get(name) or entries.get(name.replace("_dot", "dot"))
    if quantity is None:
        return name
    return text_letter(quantity.glyph) + (f" ({quantity.unit})" if quantity.unit != "1" else "")
