"""What rolls: the pages, with figures and exercises beside them."""

from __future__ import annotations

from .exercises import race, turntable

TITLE = "What rolls"
SUBTITLE = "A wheel on a slope, with a multiplier, and a ball on a turntable"
SOURCE = "The words, the figures and the numbers are ours."

FIGURES = ("wheel", "circle")
EXERCISES = (race, turntable)
