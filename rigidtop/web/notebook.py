"""The page of a motion, shown inside a Jupyter notebook."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.motion.motion import Motion
from rigidtop.web.page import LivePage, page_of

if TYPE_CHECKING:
    from rigidtop.motion.table.motion import SlidingMotion
    from rigidtop.system.motion import SystemMotion


def show(
    motion: Motion | SystemMotion | SlidingMotion,
    height: int = 760,
    points: Sequence[Sequence[Any]] = (),
) -> None:
    """Show a motion in a notebook, from its start: the page computes it in the browser.

    `height` is that of the page, in pixels.  A top or a free body has the page of `rigidtop web`,
    which wants ``pip install 'rigidtop[web]'``.  Of a system the page has the coordinates against
    time, sliders of its parameters and its start, and a picture of its masses and bodies, or of
    `points`: places of two or three components, expressions of q and t.  A top on a table is
    computed here, for 10 s, also with other friction and less spin, and played there.  No page
    needs a network.

    Raises RigidtopError where there is no notebook, for what has no counterpart in JavaScript, and
    where three.js is not installed.
    """
    checks.whole("height", height, 1)
    try:
        from IPython import get_ipython
        from IPython.display import display
    except ImportError:
        get_ipython = None
    if get_ipython is None or get_ipython() is None:
        raise RigidtopError(
            "show() wants a notebook; `rigidtop web` writes the page as a file, and so does "
            "rigidtop.web.notebook.page_for(motion).html"
        )
    display(page_for(motion, height, points))  # type: ignore[no-untyped-call]


def page_for(
    motion: Motion | SystemMotion | SlidingMotion,
    height: int = 760,
    points: Sequence[Sequence[Any]] = (),
) -> LivePage:
    """The page that `show` displays; its `html` is a file that needs nothing else.

    Raises RigidtopError for bodies that it doesn't know, for what has no counterpart in JavaScript,
    and where three.js is not installed.

    >>> import rigidtop as rt
    >>> from sympy import cos, sin, symbols
    >>> m, l, g, theta, rate = symbols("m l g theta thetadot", positive=True)
    >>> theta, rate = symbols("theta thetadot", real=True)
    >>> bob = rt.Mass(m, [l*sin(theta), -l*cos(theta)])
    >>> pendulum = rt.System.of_parts(bob, theta, rate, gravity=[0, -g])
    >>> page_for(pendulum.motion({m: 1, l: 1, g: 9.81}, q=0.5)).title
    'Motion in θ'
    """
    from rigidtop.motion.table.motion import SlidingMotion
    from rigidtop.system.motion import SystemMotion

    if isinstance(motion, (Motion, SlidingMotion)):
        if points:
            raise RigidtopError("points are those of a system; a top has its own picture")
        if isinstance(motion, Motion):
            return page_of(motion, height)
        from rigidtop.web.table import page_of_table

        return page_of_table(motion, height)
    from rigidtop.web.system import page_of_system

    if not isinstance(motion, SystemMotion):
        raise RigidtopError(
            f"show() wants a motion of a top, a body or a System, not a {type(motion).__name__}"
        )
    return page_of_system(motion, points, height)
