"""Notations: which letters stand for which symbols, in print and when read.

A notation is a table in a file (`rigidtop.notation.table` says how it is written): the notes',
those of four books, or a lecturer's own.  `written` takes an expression of the notes into a
notation, `in_notes` takes it back.

>>> from rigidtop.theory.symbols import M, R, g, lambda1, thetaddot
>>> goldstein = named("goldstein")
>>> goldstein.written(lambda1 * thetaddot - M * g * R)
I1*thetaddot - M*g*l
>>> goldstein.in_notes(_)
-M*R*g + lambda1*thetaddot
"""

from __future__ import annotations

from rigidtop.notation.convention import MATRICES, Notation, is_matrix
from rigidtop.notation.table import BUILT_IN, named

NOTES = named("notes")
"""The lecture notes."""

GOLDSTEIN = named("goldstein")
"""Goldstein, Poole and Safko."""

__all__ = ["BUILT_IN", "GOLDSTEIN", "MATRICES", "NOTES", "Notation", "is_matrix", "named"]
