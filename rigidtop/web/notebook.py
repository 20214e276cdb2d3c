"""A motion shown in Jupyter."""

from __future__ import annotations

from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import Motion
from rigidtop.web.page import page_of


def show(motion: Motion, height: int = 760) -> None:
    """Show a motion in a notebook: the page of `rigidtop web`, from its start.

    `height` is that of the page, in pixels.  The page computes the motion in the browser; it needs
    no network, and ``pip install 'rigidtop[web]'``.

    Raises RigidtopError where there is no notebook, and where three.js is not installed.
    """
    if not isinstance(height, int) or height < 1:
        raise RigidtopError(f"height must be a whole number of pixels from 1, not {height!r}")
    try:
        from IPython import get_ipython
        from IPython.display import display
    except ImportError:
        get_ipython = None
    if get_ipython is None or get_ipython() is None:
        raise RigidtopError(
            "show() wants a notebook; `rigidtop web` writes the page as a file, and so does "
            "rigidtop.web.page.page_of(motion).html"
        )
    display(page_of(motion, height))
