r"""The vocabulary of formulas in TeX: what each command, sign and environment means.

>>> MEANINGS[r"\leqslant"], SEQUENCES["->"]
(('relation', '≤'), ('relation', '→'))
"""

from __future__ import annotations

from typing import Final

from rigidtop.notation.characters import GREEK
from rigidtop.read.tex import commands, listed


def _table(kind: str, meanings: dict[str, str]) -> dict[str, tuple[str, str]]:
    """The kind and the text of each sign; a text that is empty is the sign itself."""
    return {
        sign: (kind, text)
        for names, text in meanings.items()
        for sign in (commands(names) if names[0].isalpha() else names.split())
    }


_LETTERS: Final = {"\\" + name: letter for name, letter in GREEK.items()} | {
    **{r"\var" + name: letter for name, letter in GREEK.items() if name[0].isupper()},
    r"\varphi": "ϕ",
    r"\vartheta": "ϑ",
    r"\varepsilon": "ε",
    r"\varrho": "ρ",
    r"\ell": "ℓ",
    r"\hbar": "ħ",
    r"\imath": "i",
    r"\jmath": "j",
    r"\infty": "∞",
    r"\varpi": "ϖ",
    r"\varsigma": "ς",
    r"\varkappa": "κ",
    r"\aleph": "ℵ",
    r"\top": "⊤",
    r"\intercal": "⊤",
    r"\circ": "∘",
    r"\star": "⋆",
    r"\ast": "*",
    r"\dagger": "†",
    r"\odot": "⊙",
    r"\oplus": "⊕",
    r"\degree": "°",
}
MEANINGS: Final = {
    **{sign: ("letter", letter) for sign, letter in _LETTERS.items()},
    **_table(
        "relation",
        {
            "le leq leqslant leqq": "≤",
            "ge geq geqslant geqq": "≥",
            "lt": "<",
            "gt": ">",
            "= < >": "",
            "ne neq": "≠",
            "approx simeq cong approxeq": "≈",
            "equiv triangleq coloneqq doteq eqqcolon coloneq": "≡",
            "sim": "∼",
            "propto": "∝",
            "ll": "≪",
            "gg": "≫",
            "lesssim": "≲",
            "gtrsim": "≳",
            "to rightarrow longrightarrow": "→",
            "in": "∈",
            "parallel": "∥",
            "perp bot": "⊥",
        },
    ),
    **_table(
        "arrow",
        {
            "Rightarrow Longrightarrow implies leadsto Leftrightarrow iff Longleftrightarrow": "⇒",
            "therefore because leftrightarrow longleftrightarrow Leftarrow mapsto": "⇒",
        },
    ),
    **_table(
        "sign",
        {
            "+ - / * _ ^ ! ?": "",
            "pm": "±",
            "mp": "∓",
            "cdot bullet": "·",
            "times wedge": "×",
            "div": "/",
            "partial": "∂",
            "nabla": "∇",
            "int iint iiint": "∫",
            "oint": "∮",
            "sum": "Σ",
            "prod": "Π",
        },
    ),
    **_table("open", {"( [": "", "lbrack": "[", "lbrace": "{", r"\{": "{"}),
    **_table("open", {"langle": "⟨", "lvert lVert": "|"}),
    **_table("close", {")": "(", "] \\rbrack": "[", r"\} \rbrace": "{"}),
    **_table("close", {"rangle": "⟨", "rvert rVert": "|"}),
    **_table("bar", {r"| \|": "|", "vert Vert mid": "|"}),
    **_table("dots", {"cdots ldots dots dotsb dotsc dotsm vdots ddots": "…", "…": "…", "⋯": "…"}),
    **_table("upright", {"Re": "Re", "Im": "Im"}),
    **_table("prime", {"'": "′", "prime": "′"}),
    **_table("comma", {", ; :": "", "colon": ":"}),
    **_table("quad", {"quad qquad enspace hfill": "quad"}),
    **_table("align", {"&": "&"}),
    **_table("stop", {".": "."}),
}
SEQUENCES: Final = {
    ":=": ("relation", "≡"),
    "=:": ("relation", "≡"),
    "<=>": ("arrow", "⇒"),
    "=>": ("arrow", "⇒"),
    "==>": ("arrow", "⇒"),
    "->": ("relation", "→"),
    "<=": ("relation", "≤"),
    ">=": ("relation", "≥"),
    "!=": ("relation", "≠"),
    "<<": ("relation", "≪"),
    ">>": ("relation", "≫"),
    "...": ("dots", "…"),
    "==": ("relation", "="),
    "**": ("sign", "^"),
}
"""What is written with several characters."""

SPACES = frozenset({r"\,", r"\;", r"\:", "\\ ", "\\\n", "~"}) | commands("thinspace space")
SILENT: Final = (
    commands("displaystyle textstyle scriptstyle limits nolimits nonumber notag middle allowbreak")
    | commands("boxed fbox mathop mathord mathrel mathbin ensuremath displaylimits strut mathstrut")
    | commands("null relax smash mathclap protect hfil centering nobreak noindent cancel")
    | commands("qed qedhere qedsymbol blacksquare checkmark")
    | commands("bcancel xcancel underbracket hline toprule midrule bottomrule pqty bqty")
    | {f"\\{size}{side}" for size in ("big", "Big", "bigg", "Bigg") for side in ("", *"lrm")}
    | {r"\!", r"\/", r"\-", "$", r"\)", r"\(", r"\[", r"\]", "​", r"\$"}
)
"""What says nothing."""
SKIPPED: Final = commands(
    "label vspace phantom hphantom vphantom color textcolor mspace hskip colorbox cite"
) | commands("ref eqref cline hspace cancelto")
"""Commands that are left out with what they take."""
TEXTS: Final = commands("text textrm textit textbf mbox hbox textnormal textsf texttt intertext")
TEXTS_BETWEEN: Final = commands("intertext shortintertext")
"""Commands for words in a row of their own."""
UPRIGHT: Final = commands("mathrm operatorname operatorname* mathsf mathtt")
"""Commands whose letters stand upright."""
SWITCHES: Final = {
    r"\bf": r"\mathbf",
    r"\bfseries": r"\mathbf",
    r"\boldmath": r"\mathbf",
    r"\rm": r"\mathrm",
    r"\it": r"\mathit",
    r"\cal": r"\mathcal",
}
"""Commands that set a font for all that follows, with those that set it for one group."""
FUNCTIONS: Final = listed(
    "sin cos tan cot sec csc arcsin arccos arctan sinh cosh tanh coth exp ln log det tr sgn "
    "arctanh artanh arsinh arcosh arcsinh arccosh sn cn dn max min Re Im"
)
"""Functions that have a name."""
CONSTANT: Final = listed("const constant konst konstant costante constante cste cte cst 常数 常量")
LINES: Final = listed(
    "aligned align split gather gathered eqnarray equation alignat alignedat multline flalign "
    "subequations multlined dmath displaymath math IEEEeqnarray Aligned rcases empheq"
)
"""Environments of which each row is read by itself."""
CASES: Final = listed("cases dcases numcases")
MATRICES: Final = {
    "matrix": "",
    "pmatrix": "(",
    "bmatrix": "[",
    "Bmatrix": "{",
    "vmatrix": "|",
    "smallmatrix": "",
    "psmallmatrix": "(",
    "bsmallmatrix": "[",
    "array": "",
}
"""Environments that are matrices, with their brackets."""
DERIVATIVES: Final = {r"\dv": "d", r"\pdv": r"\partial"}
"""Commands of the package physics, with the sign that they write."""
