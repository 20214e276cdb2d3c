"""The free asymmetric top: the pages, with figures and exercises beside them."""

from __future__ import annotations

from .exercises import turnover, whole_turn

TITLE = "The free asymmetric top"
SUBTITLE = "Ellipses on a sphere, Jacobi's functions, the flip, and the angle that is left over"
SOURCE = (
    "Euler found the equations in 1758, R. Montgomery the angle in 1991, Am. J. Phys. 59, 394. The "
    "words, the figures and the numbers are ours."
)

FIGURES = ("sphere", "tumble")
EXERCISES = (turnover, whole_turn)
