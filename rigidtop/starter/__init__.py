"""My course: what `rigidtop new` has written, to be changed at will.

`rigidtop check` judges the pages below, `rigidtop lecture` typesets them.  This folder is Python
and runs as such.
"""

from __future__ import annotations

from .pendulum import page, period

TITLE = "My course"
SUBTITLE = "A pendulum to start from"
SOURCE = "The claims and the derivations are mine."

PAGES = (page,)
EXERCISES = (period,)
