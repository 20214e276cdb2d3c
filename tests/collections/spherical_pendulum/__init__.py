"""The spherical pendulum: a collection of its own, with nothing of the top in it."""

from __future__ import annotations

from . import conical, equations, tension
from .exercises import conical_pendulum

TITLE = "The spherical pendulum: derived and judged"
SUBTITLE = "A mass on a string, its cones, and how it nods about them"
SOURCE = "The claims are those of textbooks; the wording and the derivations are ours."

PAGES = (equations.page, conical.page, tension.page)
EXERCISES = (conical_pendulum,)
