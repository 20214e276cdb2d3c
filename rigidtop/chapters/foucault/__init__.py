"""The earth that turns: the pages, with figures and exercises beside them."""

from __future__ import annotations

from .exercises import pantheon, tower

TITLE = "The earth turns"
SUBTITLE = "A laboratory that turns, a stone that falls to the east, Foucault's pendulum"
SOURCE = "The words, the figures and the numbers are ours."

FIGURES = ("laboratory", "rosette")
EXERCISES = (tower, pantheon)
