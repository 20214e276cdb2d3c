"""The exercises that the notes leave to their reader, solved, in reading order."""

from __future__ import annotations

from rigidtop.derivations.exercises import simplified_picture

EXERCISES = (*simplified_picture.EXERCISES,)
"""Every exercise."""
