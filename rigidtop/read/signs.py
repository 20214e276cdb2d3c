"""What is written how: the signs and commands of formulas, by what they are."""

from __future__ import annotations

import re

from rigidtop.notation.convention import own
from rigidtop.read.tex import FONTS, GREEKS, TEXTS, UPRIGHT, commands, listed
from rigidtop.theory.symbols import Glyph

SPACES = commands("quad qquad enspace hfill")
APART = SPACES | {r"\:", r"\;", r"\ "}
"""What stands between the entries of a row."""
SKIPPED = commands("label hspace vspace phantom hphantom vphantom color textcolor mspace hskip")
SKIPPED |= commands("colorbox cite")
"""Commands that are left out with their first argument."""
LEFT_OUT = commands(
    "boxed fbox mathop mathord mathrel ensuremath scriptstyle displaylimits strut mathstrut null "
    "relax qedhere smash mathclap bf@series protect hfil centering nobreak / -"
)
BETWEEN = commands("intertext shortintertext")
JUDGED = {
    "=": "=",
    "<": "<",
    ">": ">",
    r"\lt": "<",
    r"\gt": ">",
    r"\equiv": "≡",
    r"\neq": "≠",
    r"\ne": "≠",
    r"\approx": "≈",
}
"""The relations that our pages have."""
RELATIONS = {
    **JUDGED,
    **dict.fromkeys(commands("le leq leqslant"), "≤"),
    **dict.fromkeys(commands("ge geq geqslant"), "≥"),
    **dict.fromkeys(commands("simeq cong approxeq"), "≃"),
    **dict.fromkeys(commands("triangleq coloneqq doteq eqqcolon coloneq"), "≡"),
    r"\ll": "≪",
    r"\gg": "≫",
    r"\sim": "∼",
    r"\propto": "∝",
    r"\lesssim": "≲",
    r"\gtrsim": "≳",
    r"\perp": "⊥",
    r"\parallel": "∥",
}
ARROWS = commands(
    "Rightarrow Longrightarrow implies Leftrightarrow iff Longleftrightarrow therefore "
    "rightarrow to longrightarrow leftrightarrow longleftrightarrow because"
)
SIGNS = {r"\pm": ("+", "-"), r"\mp": ("-", "+")}
BOTH = {"±": "+,−", "∓": "−,+"}
"""ε_± is ε₊ with the upper sign and ε₋ with the lower."""
MATHEMATICAL = frozenset({*RELATIONS, *SIGNS, "$", r"\to", r"\in"})
OMITTED = commands("cdots ldots dots dotsb dotsc vdots") | {"…", "⋯"}
BRACKETS = {
    "(": "OPEN",
    ")": "CLOSE",
    r"\{": "OPEN",
    r"\}": "CLOSE",
    "[": "LIST",
    "]": "TSIL",
    "+": "SIGN",
    "-": "SIGN",
    "/": "SLASH",
    r"\cdot": "DOT",
    r"\times": "CROSS",
    r"\sum": "SUM",
}
REFUSED = {
    **dict.fromkeys(commands("langle rangle"), "an average or a product in ⟨ ⟩"),
    **dict.fromkeys(commands("in notin subset subseteq cup cap"), "a set"),
    **dict.fromkeys(commands("forall exists mapsto colon"), "a map or a quantifier"),
    **dict.fromkeys(commands("lim limsup liminf"), "a limit"),
    **dict.fromkeys(commands("max min sup inf arg"), "an extremum"),
    **dict.fromkeys(commands("otimes oplus wedge circ bullet"), "a product of a kind"),
    **dict.fromkeys(commands("prod coprod binom"), "a product over an index, or a binomial"),
    **dict.fromkeys(commands("cancel bcancel xcancel cancelto"), "what is struck out"),
    **dict.fromkeys(commands("iint iiint oint"), "an integral of several dimensions"),
    **dict.fromkeys(commands("includegraphics xymatrix tikz"), "a picture"),
    r"\end": r"an \end without its \begin",
    "*": "a star: a product is written without one",
    "!": "a factorial",
    "?": "a question mark",
}
DEGREES = "an angle in degrees: the reader knows radians"
FRACTIONS = commands("dfrac cfrac tfrac frac nicefrac")
FUNCTIONS = commands(
    "sin cos tan arcsin arccos arctan sinh cosh tanh exp log ln det cot sec csc coth"
)
SPELLED = ("arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "sin", "cos", "tan", "exp", "log")
DOUBTFUL = listed("ln det tr abs sqrt max min arg sgn div rot dim ker lim mod rank curl")
"""Names of functions that may be products too, where they are spelled with single letters."""
WORDS = frozenset(name[1:] for name in FUNCTIONS) | {"tr", "Tr"}
"""Functions that are written as words."""
ELLIPTIC = frozenset({"K", "F"})
"""In the letters of a table these are functions too: ``\\operatorname{K}``."""

OVER = {r"\dot": 1, r"\ddot": 2}
RATED = frozenset(OVER) | {"'", "^"}
"""What a letter has that needs brackets before a power: (y′)²."""
MARKS = {
    **dict.fromkeys(commands("bar overline"), "\u0304"),
    **dict.fromkeys(commands("tilde widetilde"), "\u0303"),
    r"\check": "\u030c",
    r"\breve": "\u0306",
    r"\mathring": "\u030a",
}
STYLES = {
    r"\mathcal": "SCRIPT",
    r"\mathscr": "SCRIPT",
    r"\cal": "SCRIPT",
    r"\mathfrak": "FRAKTUR",
    r"\mathbb": "DOUBLE-STRUCK",
}
HATS = commands("hat widehat")
"""With a small hat a letter is a unit vector; a wide one is a matrix, or what an author makes."""
DRESSES = FONTS | HATS | frozenset(MARKS) | frozenset(OVER)
ARROWS_OVER = commands("vec overrightarrow overrightharpoon")
TAKING = DRESSES | TEXTS | frozenset(STYLES)
"""Commands that take an argument."""
SWITCHES = commands("bf rm it bfseries boldmath")
WORDED = UPRIGHT | commands("textrm text textit mathtt mbox textsf")
UPRIGHT_ALONE = commands("mathrm operatorname operatorname* mathit")
LETTERS = {
    **GREEKS,
    r"\ell": "ℓ",
    r"\hbar": "ħ",
    r"\imath": "i",
    r"\jmath": "j",
    r"\infty": "∞",
    "∞": "∞",
    r"\varpi": "ϖ",
    r"\digamma": "Ϝ",
}
ALPHABET = frozenset("αβγδεζηθικλμνξοπρσςτυφχψωΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩϕϑϖϵℓℒħℋ")
SETS = frozenset("RNZCQ")
WORDLIKE = listed(
    "curl damp diff disc disk drag flux full grad half kick kind left link mass norm part path "
    "pend plan push right roll rolls shift short small spin spins spring step string swing thin "
    "tilt torq turn twist unit vert with work"
)
"""Words of one vowel: in formulas no products."""
ENERGY = re.compile("E[ckmp][a-z]?")
"""A product, or the name of an energy."""
SEGMENT = re.compile("[A-EO-Q]{2}|Re")
"""A product, or the distance of two points or a number's name, where it is a whole side."""
TIME = own(Glyph("t"))
ANGLES = frozenset("θφψϕϑαβγχϖ")
TIMELY = frozenset("xyzrqθφψϕsuvω")
INDEXES = frozenset("ijklαβμνρσκcefgosabd") | frozenset("ABCDEFGHIJKLMOPQRSUVWXYZ")
"""Letters that above another may be its index; n, m, p, x are rather a power."""
RUNNING = frozenset("ijklmnμνρσαβκλ")
"""Letters that are indices where two of them stand together."""
ORDERS = frozenset({"O", "o", "𝒪", "Δ", "δ", "Γ"})
"""Letters whose brackets never hold a factor."""
OPERATORS = frozenset({"D", "𝒟", "ℒ", "T*"})
"""Letters that act on what stands behind them, if a letter does."""
ACTED_ON = frozenset("uyfψΨφΦχ")
"""Letters of functions that an operator may have in front."""
POTENTIALS = frozenset({"f", "F", "U", "V", "H", "ψ", "Ψ"})
"""Letters whose brackets may hold either: it is not guessed."""

CONDITIONS: frozenset[str] = listed(
    "for if when whenever unless provided assuming as at per se quando für wenn falls bei pour "
    "quand si para cuando om når hvis since because 当 若 如果 因为"
)
CONNECTIVES = listed(
    "and or where with so then thus hence but is are from by to let we that which e ed ou et oder "
    "und wobei dove con med og y avec où soit i.e. e.g. otherwise therefore now"
)
CONSTANT = listed("const constant konst konstant costante constante 常数 常量")
UNIT = re.compile(
    r"\(?(?:[kmcMGμn]?(?:m|g|s|N|J|W|Hz|Pa|K|C|V|A|eV|cal)|rad|deg|kg|min|h|hr|km|mi|yr|AU|sec)"
    r"(?:\^?\{?[-−]?\d\}?)?(?:[·/ ]?(?:[kmcMGμn]?(?:m|g|s|N|J|W|Hz|Pa|K|C|V|A)|rad|kg|min|h|hr)"
    r"(?:\^?\{?[-−]?\d\}?)?)*\)?"
)
_FACTOR = r"(?:kg|km|cm|mm|ms|Hz|Pa|rad|eV|[msNJWKCVA])(?:\s?\^\s?\{?[-−]?\d\}?)?"
_APART = r"(?:\s|~|\\[,:; ]|\\cdot(?![a-z])|·)*"
_TENS = r"\s?(?:\\times|\\cdot|×)\s?10\s?\^\s?\{?[-−]?\d+\}?"
_LAST = r"\s?(?=[,;.=&]|$|\\(?:quad|qquad|\\|approx|text|rightarrow|Rightarrow|end))"
_RUN = rf"{_FACTOR}(?:{_APART}/?{_APART}{_FACTOR})*"
DECIMAL_UNIT = re.compile(rf"(?:{_TENS})?{_APART}{_RUN}{_LAST}")
"""What stands behind a number with decimals, and is rather its unit than letters."""
UNITED = re.compile(
    rf"{_TENS}{_APART}{_RUN}{_LAST}|{_APART}{_FACTOR}(?:{_APART}{_FACTOR})*/{_RUN}{_LAST}"
    rf"|(?:~|\s?\\[,:; ]){_APART}{_RUN}{_LAST}|\s?(?:kg|km|cm|mm|ms|Hz|Pa|rad)(?:{_LAST}|(?=[-+]))"
)
"""What stands behind a whole number: 10³ m, m/s, ~s, kg."""
SHORT = re.compile(rf"{UNIT.pattern}|[^\W\d]{{1,6}}|\S*/\S*")
LENGTH = re.compile(r"\s*-?[\d.,]+\s*(?:pt|em|ex|mm|cm|in)\s*")
NUMBER_OF = re.compile(r"\(\d+(?:\.\d+)*[a-z]?\)")

CASES = listed("cases dcases rcases numcases cases* dcases*")
MATRICES = listed("matrix pmatrix bmatrix Bmatrix smallmatrix pmatrix* bmatrix* matrix*")
LINES = listed(
    "aligned align array split gather gathered eqnarray equation alignat alignedat multline "
    "flalign empheq subequations multlined dmath displaymath math IEEEeqnarray Aligned"
)
ARGUED = listed("alignedat alignat IEEEeqnarray empheq")
OPENING, CLOSING = commands("lvert lVert"), commands("rvert rVert")
BARS = frozenset({"|", r"\|"}) | commands("vert Vert") | OPENING | CLOSING
TRANSPOSED = frozenset({"T", "⊤"})
DECIMALS = frozenset("0123456789")
SIGNS_AROUND = frozenset({*RELATIONS, "+", "-", "_", "^", "/", r"\cdot", r"\times"})
BEFORE_LAST = frozenset({"RELATION", "SIGN", "SIGNS", "SLASH", "DOT", "CROSS"})
BEFORE = BEFORE_LAST | {"", "NUMBER", "ALIGN", "LINE", "SPACE", "SEPARATOR", "ARROW", "WORDS"}
BEFORE_SIDE = frozenset({"", "ALIGN", "LINE", "SPACE", "SEPARATOR", "ARROW", "WORDS"})
BEFORE |= {"OPEN", "LIST", "OF", "COMMA"}
