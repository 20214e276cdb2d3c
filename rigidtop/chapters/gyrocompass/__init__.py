"""The gyrocompass: the pages, with figures and exercises beside them."""

from __future__ import annotations

from .exercises import course, swing

TITLE = "The gyrocompass"
SUBTITLE = "How a spinning wheel finds north on an earth that turns, and misses it on a ship"
SOURCE = "The words, the figures and the numbers are ours; the pages name whose results they use."

FIGURES = ("level", "search")
EXERCISES = (swing, course)
