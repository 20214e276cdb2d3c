"""The tippe top: the pages, with figures and exercises beside them."""

from __future__ import annotations

from .exercises import over, spin

TITLE = "The tippe top"
SUBTITLE = "Why a ball with a low centre of mass ends up on its head"
SOURCE = "The words, the figures and the numbers are ours; the pages name whose results they use."

FIGURES = ("contact", "rise")
EXERCISES = (spin, over)
