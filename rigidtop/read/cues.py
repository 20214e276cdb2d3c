r"""What the words around a formula say of it, in English, German and French.

The words are those of its sentence from the formula before to the one behind.  In them § stands for
a letter or another formula, and ¶ for the end of a title.

>>> sorted(cue.name for cue in cues("at the start", "", "\\dot\\theta = 0", False))
['MOMENT']
>>> sorted(cue.name for cue in cues("Suppose", "", "p_1 = p_2", False))
['CASE']
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

from rigidtop.read.phrases import BEFORE, BEHIND, INLINE, TITLED, WITHIN, Cue
from rigidtop.read.words import WORD

_LET_GO = r"(?:released|let go|dropped|losgelassen|lâchée?s?|abandonnée?s?)"
_REST = re.compile(
    r"\b(?:(?:start|begin|falls?|moves? off|set(?:ting|s)? (?:off|out)|initially|released|dropped)"
    r"\w*(?: [\w'-]+){0,3} (?:at|from|in) rest"
    r"|rests? (?:at|in|on)\b[^.;]{0,40}\buntil"
    r"|(?:(?<!\()(?<!§ )from rest|aus der Ruhe|(?:anfangs|zu Beginn|zunächst) (?:\w+ ){0,2}in Ruhe"
    r"|ruht (?:anfangs|zu Beginn|zunächst)|part(?:ant|ent)? du repos|initialement au repos)"
    r"|(?:without|ohne|sans)(?: \w+)?(?: initiale?r?)?"
    r" (?:push|velocity|speed|\w*[Gg]eschwindigkeit|Stoß|Schwung|vitesse|impulsion)"
    rf"|{_LET_GO}(?![^.;]{{0,80}}\b(?:with|mit|avec)\b))\b",
    re.I,
)


_INEQUALITY = re.compile(
    r"[<>≠≤≥≪≫]|\\(?:neq?|not|l[et]q?|g[et]q?|leqslant|geqslant|ll|gg)(?![A-Za-z])"
)
_VANISHING = re.compile(r"=\s*0\s*[.,;]?\s*\Z")
_PREMISES = frozenset({Cue.CASE, Cue.DEFINED, Cue.CONDITION, Cue.CONSTANT, Cue.CONSTRAINT})
_LIST = re.compile(r"[\s,;]*(?:(?:and|or|und|oder|et|ou)[\s,]*)?", re.I)
_ROW = re.compile(r"(?:§[ ,]*){3,}")
"""A list of letters says no more than two of them."""
_CLAUSE = re.compile(r"\s*,\s*")
_CONCLUSION = re.compile(
    r"[;:§].|\b(?:hence|so|therefore|thus|and|but|daher|somit|und|aber|donc|et|mais)\b", re.I
)
"""What ends the moment or place that a formula says."""


def _ends(patterns: tuple[str, ...], behind: str) -> re.Pattern[str]:
    return re.compile(rf"(?:{'|'.join(patterns)}){behind}\Z", re.I)


_BEFORE = {cue: _ends(patterns, "[ :(]*") for cue, patterns in BEFORE.items()}
_INLINE = {cue: _ends(patterns, "[ ,:(]*") for cue, patterns in INLINE.items()}
_WITHIN = {cue: re.compile("|".join(patterns), re.I) for cue, patterns in WITHIN.items()}
_BEHIND = {cue: re.compile("|".join(patterns), re.I) for cue, patterns in BEHIND.items()}
_TITLED = re.compile(rf"(?:{'|'.join(TITLED)})\Z", re.I)
_WHERE = re.compile(r"\bwhere\Z", re.I)
_CHOSEN = re.compile(
    r"\b(?:let|choose|take|put|set|with|sei|wähle|mit|soit|avec)(?: (?:us|now))?[ :(]*\Z", re.I
)
"""What chooses a coordinate, in front of the place from which it counts."""
_TO = re.compile(r"(?:to|and|bis|und|à|et)\b", re.I)
_UP_TO = re.compile(r"\b(?:to|and|bis|und|à|et)\Z", re.I)
"""What stands between the beginning and the end of a range."""
_THAT_IS = re.compile(r"(?:^|[¶,.;] ?|\bou )soit[ :,]*\Z", re.I)
"""In front of a display it says the same in another form; in front of a letter it is "let"."""
_SUPPOSED_BEHIND = re.compile(
    r"(?:at|for|für|if|when|bei|zur Zeit|wenn|falls|si|lorsque|à|à l'instant|pour)", re.I
)
"""All that stands between a formula and the one that says where it holds."""

_WITH = re.compile(r"\b(?:with|mit|avec) ?\Z", re.I)
_ONE_HAS = re.compile(
    r",? ?(?:one|we|you|it|this|man|on|hat man|erhält man)\b(?: (?:has|have|gets?|finds?|obtains?"
    r"|becomes?|is|hat|erhält|a|obtient))?\b"
)
_VALUE = re.compile(r"=\s*[-−+]?\s*\\?(?:[\d./]+|pi|π)\s*\Z")
"""A number that is put in: "with § one has §" where § is cos θ = 0."""

LONGEST = 200
"""Of the words in front of a formula no more are looked at, and no more behind it."""


@lru_cache(maxsize=5000)
def cues(before: str, behind: str, text: str, display: bool) -> frozenset[Cue]:
    """What the words next to a formula say of it."""
    before = _ROW.sub("§ § ", before.strip()[-LONGEST:])
    behind = behind.strip()[:LONGEST]
    heard = {cue for cue, pattern in _BEFORE.items() if pattern.search(before)}
    heard |= {cue for cue, pattern in _WITHIN.items() if pattern.search(before)}
    heard |= {cue for cue, pattern in _BEHIND.items() if pattern.match(behind)}
    if not (display and before[:1].isupper()):  # within a sentence, or at its end
        heard -= {Cue.CIRCUMSTANCE}
    if not display:
        if _SUPPOSED_BEHIND.fullmatch(behind):
            heard |= {Cue.CASE, Cue.MOMENT}
        if _WITH.search(before) and _ONE_HAS.match(behind) and _VALUE.search(text):
            heard |= {Cue.CASE}
        heard |= {cue for cue, pattern in _INLINE.items() if pattern.search(before)}
        if Cue.RANGE in heard and not (_TO.match(behind) or _UP_TO.search(before)):
            heard -= {Cue.RANGE}
        if Cue.DEFINED in heard:
            heard -= {Cue.DERIVED}  # "that is, with §"
        titled = _TITLED.match(before) or ("¶" in behind and Cue.DERIVED not in heard)
        if titled:
            heard = heard - {Cue.DEFINED} | {Cue.CASE}
        if heard & {Cue.MOMENT, Cue.CASE} and not _CHOSEN.search(before):
            heard = heard - {Cue.ORIGIN}
        if _WHERE.search(before) and _VANISHING.search(text):
            heard = heard - {Cue.DEFINED} | {Cue.MOMENT}
        if Cue.EXCEPTED in heard:
            heard = heard - {Cue.MOMENT, Cue.CASE, Cue.ASKED}
    elif _THAT_IS.search(before):
        heard = heard - {Cue.CASE} | {Cue.DERIVED}
    if Cue.ORIGIN in heard:
        heard = heard - {Cue.EQUILIBRIUM}
    return unequal(frozenset(heard), text, display)


def unequal(heard: frozenset[Cue], text: str, display: bool) -> frozenset[Cue]:
    """Cues, with a condition for what supposes an inequality, and for nothing else."""
    supposed = heard & {Cue.CASE, Cue.DEFINED, Cue.CONDITION}
    if _INEQUALITY.search(text) is None:
        return heard - {Cue.CONDITION}
    return heard - supposed | {Cue.CONDITION} if supposed and not display else heard


_OF_THE_SENTENCE = {
    *(Cue.EQUILIBRIUM, Cue.OSCILLATION, Cue.CIRCLE, Cue.EQUAL_MASSES, Cue.NEARLY_EQUAL),
    *(Cue.ELSEWHERE, Cue.OTHER, Cue.COMPONENTS, Cue.THERE, Cue.SEVERAL),
}
"""Cues that hold of all formulas that follow in a sentence."""


def passed_on(
    heard: frozenset[Cue], opening: str, before: str, display: bool, follower: bool
) -> frozenset[Cue]:
    """Which cues of a formula hold of the next one, too, by the words between them.

    `opening` are the words in front of the first of its list; `display` and `follower` say whether
    the one and the other stand on a line of their own.
    """
    moment = heard & {Cue.MOMENT} if not _CONCLUSION.search(before) else frozenset()
    moment |= heard & _OF_THE_SENTENCE
    if not before.strip():
        moment |= heard & {Cue.CIRCUMSTANCE}
    if Cue.RANGE in heard and _TO.fullmatch(before.strip()):
        moment |= {Cue.RANGE}
    if not enumerates(before):
        return moment
    clause = _CLAUSE.fullmatch(before) and _INLINE[Cue.CASE].search(opening)
    if display != follower or clause or not before.strip():
        return heard - _PREMISES - {Cue.EXCEPTED}
    return heard - {Cue.CONSTANT} | ({Cue.CASE} if Cue.CONDITION in heard else set())


_KEPT = re.compile(
    r"\b(?:energy (?:is|stays|remains) (?:conserved|constant|the same)|conservation of energy"
    r"|Energie (?:ist|bleibt) (?:erhalten|konstant|gleich)|Energieerhaltung|Erhaltung der Energie"
    r"|énergie (?:se conserve|est (?:conservée|constante))|conservation de l'énergie)\b",
    re.I,
)


_STAYS = (
    rf"(?:(?:is|stays|remains|ist|bleibt|est|reste)(?: {WORD}){{0,2}}? (?:conserved|constant"
    r"|unchanged|the same|erhalten|konstant|unverändert|conservée?|constante?)"
    r"|(?:does not|cannot) change"
    r"|se conserve|ändert sich nicht)\b"
)
_IT_STAYS = re.compile(
    rf"\b(?:it|this|which|that|quantity|product|ratio|sum|(?:adiabatic )?invariant|er|sie|es|dies"
    rf"|elle|il|cette quantité) {_STAYS}",
    re.I,
)
_MOMENTUM_STAYS = re.compile(
    rf"\b(?:momentum|\w*[Ii]mpuls|\w*Drall|moment cinétique)(?: [\w'-]+){{0,5}}? {_STAYS}"
    r"|\b(?:conservation of (?:\w+ )?momentum|\w*[Ii]mpulserhaltung|conservation du moment)\b",
    re.I,
)


def kept(words: str) -> Iterator[Cue]:
    """What words say to be conserved: energy, a momentum, what was spoken of.

    >>> [cue.name for cue in kept("and it is conserved while the string is pulled in")]
    ['KEPT']
    >>> [cue.name for cue in kept("The angular momentum of the disc stays the same:")]
    ['MOMENTUM_KEPT']
    """
    patterns = {
        Cue.CONSERVED: _KEPT,
        Cue.KEPT: _IT_STAYS,
        Cue.MOMENTUM_KEPT: _MOMENTUM_STAYS,
    }
    return (cue for cue, pattern in patterns.items() if pattern.search(words))


def ends_moment(before: str) -> bool:
    """Whether words between two formulas say when the first one holds: "§ at the start, §"."""
    match = _BEHIND[Cue.MOMENT].match(before)
    return match is not None and before[match.end() :].strip(" ,") == ""


def begins_at_rest(words: str) -> bool:
    """Whether words say that everything begins at rest.

    >>> begins_at_rest("Released at § without velocity,"), begins_at_rest("let go with a speed")
    (True, False)
    """
    return _REST.search(words) is not None


def enumerates(before: str) -> bool:
    """Whether words between two formulas say no more than "and"."""
    return _LIST.fullmatch(before) is not None
