"""Sentences with mathematics between dollars, as LaTeX and as HTML.

A character that LaTeX would not know raises a `ValueError` that names it.
"""

from __future__ import annotations

from collections.abc import Callable
from html import escape as escape_html

from rigidtop.notation.characters import escape
from rigidtop.present import formula
from rigidtop.proof.words import parts


def prose(text: str) -> str:
    r"""A sentence as LaTeX.

    >>> print(prose("$θ̈$ vanishes & $sin θ ≠ 0$ (3.54): 100 %"))
    $\ddot{\theta}$ vanishes \& $\sin \theta \neq 0$ (3.54): 100 \%
    """
    return written(text, tex, escape)


def prose_html(text: str) -> str:
    """The same as HTML, its formulas as MathML.

    >>> prose_html("a & b's")
    'a &amp; b’s'
    """
    return written(text, formula.mathml, _plain_html)


def _plain_html(text: str) -> str:
    return escape_html(text.replace("'", "’"), quote=False)


def tex(part: str) -> str:
    """A formula of a sentence between dollars."""
    return f"${formula.tex(part)}$"


def written(text: str, maths: Callable[[str], str], plain: Callable[[str], str]) -> str:
    """A sentence; `maths` writes its formulas, `plain` the rest."""
    return "".join(maths(part) if is_maths else plain(part) for is_maths, part in parts(text))
