"""Kepler's problem: the pages, with figures and exercises beside them."""

from __future__ import annotations

from .exercises import comet, seasons

TITLE = "Planets and comets"
SUBTITLE = "The conic, the time on the orbit, and a vector that stays where it is"
SOURCE = (
    "Kepler found his laws in 1609 and 1619, Newton derived them in 1687. The words, the figures "
    "and the numbers are ours."
)

FIGURES = ("conics", "areas")
EXERCISES = (comet, seasons)
