"""A motion shown in Jupyter, as `Motion.show` asks for it."""

from __future__ import annotations

from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import Motion
from rigidtop.web.page import page_of


def display(motion: Motion, height: int) -> None:
    """Display the page in the running notebook; RigidtopError where there is none."""
    if not isinstance(height, int) or height < 1:
        raise RigidtopError(f"height must be a whole number of pixels from 1, not {height!r}")
    try:
        from IPython import get_ipython
        from IPython.display import display as show
    except ImportError:
        get_ipython = None
    if get_ipython is None or get_ipython() is None:
        raise RigidtopError(
            "show() wants a notebook; `rigidtop web` writes the page as a file, and so does "
            "rigidtop.web.page.page_of(motion).html"
        )
    show(page_of(motion, height))
