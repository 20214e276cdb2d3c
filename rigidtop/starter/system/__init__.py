"""My system: what `rigidtop new --system` has written, to be changed at will.

The letters stand in letters.py, the Lagrangian in spring.py, and the derivation in spring.md:
`print(SYSTEM.derivation("1").markdown())` writes that for another Lagrangian, and what you change
in it is judged line by line.  This folder is Python and runs as such.
"""

from __future__ import annotations

from .spring import page

TITLE = "My system"
SUBTITLE = "A mass on a spring that turns in a plane"
SOURCE = "The claims and the derivations are mine."

PAGES = (page,)
