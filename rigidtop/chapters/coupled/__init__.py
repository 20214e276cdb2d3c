"""Coupled pendulums: the pages, with figures and exercises beside them."""

from __future__ import annotations

from .exercises import exchange, three

TITLE = "Coupled pendulums"
SUBTITLE = "Small swings, modes and beats, and many in a row"
SOURCE = "The words, the figures and the numbers are ours."

FIGURES = ("modes", "beats")
EXERCISES = (exchange, three)
