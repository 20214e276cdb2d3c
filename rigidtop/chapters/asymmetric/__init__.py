"""The heavy asymmetric top: the pages, with figures and exercises beside them."""

from __future__ import annotations

from .exercises import hanging, lost

TITLE = "The heavy asymmetric top"
SUBTITLE = "Three numbers that stay, a fourth that Kovalevskaya found, and what happens without it"
SOURCE = (
    "S. Kowalevski found the fourth integral, Acta Math. 12 (1889) 177. The words, the figures and "
    "the numbers are ours."
)

FIGURES = ("section", "apart")
EXERCISES = (hanging, lost)
