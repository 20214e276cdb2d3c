"""Rigid bodies and the spinning top: derived, proved, typeset, computed.

Names are loaded at first use, so that ``import rigidtop`` loads nothing heavy.
"""

from __future__ import annotations

TYPE_CHECKING = False  # typing itself takes time
if TYPE_CHECKING:
    from typing import Any

    from rigidtop.errors import NoSteadyPrecession, RigidtopError
    from rigidtop.motion.body import FreeBody, HeavyBody
    from rigidtop.motion.fit import fit
    from rigidtop.motion.free_fit import FreeFit
    from rigidtop.motion.many import FreeMotions, TopMotions, free_motions, top_motions
    from rigidtop.motion.motion import Motion
    from rigidtop.motion.table.motion import SlidingMotion, SlidingTop
    from rigidtop.motion.table.trajectory import SlidingTrajectory
    from rigidtop.motion.top import HeavyTop
    from rigidtop.motion.top_fit import TopFit
    from rigidtop.motion.trajectory import Trajectory
    from rigidtop.system.fit import SystemFit
    from rigidtop.system.friction import DryFriction
    from rigidtop.system.linkage import Joint, Link
    from rigidtop.system.many import SystemMotions
    from rigidtop.system.mechanism import Mechanism
    from rigidtop.system.motion import SystemMotion
    from rigidtop.system.parts import Body, Mass
    from rigidtop.system.system import System
    from rigidtop.system.trajectory import SystemSection, SystemTrajectory
    from rigidtop.web.notebook import show

    __version__: str

__all__ = [
    "Body",
    "DryFriction",
    "FreeBody",
    "FreeFit",
    "FreeMotions",
    "HeavyBody",
    "HeavyTop",
    "Joint",
    "Link",
    "Mass",
    "Mechanism",
    "Motion",
    "NoSteadyPrecession",
    "RigidtopError",
    "SlidingMotion",
    "SlidingTop",
    "SlidingTrajectory",
    "System",
    "SystemFit",
    "SystemMotion",
    "SystemMotions",
    "SystemSection",
    "SystemTrajectory",
    "TopFit",
    "TopMotions",
    "Trajectory",
    "__version__",
    "fit",
    "free_motions",
    "show",
    "top_motions",
]

_ROOMS = {
    "errors": ("NoSteadyPrecession", "RigidtopError"),
    "motion.body": ("FreeBody", "HeavyBody"),
    "motion.fit": ("fit",),
    "motion.free_fit": ("FreeFit",),
    "motion.many": ("FreeMotions", "TopMotions", "free_motions", "top_motions"),
    "motion.motion": ("Motion",),
    "motion.table.motion": ("SlidingMotion", "SlidingTop"),
    "motion.table.trajectory": ("SlidingTrajectory",),
    "motion.top": ("HeavyTop",),
    "motion.top_fit": ("TopFit",),
    "motion.trajectory": ("Trajectory",),
    "system.fit": ("SystemFit",),
    "system.friction": ("DryFriction",),
    "system.linkage": ("Joint", "Link"),
    "system.many": ("SystemMotions",),
    "system.mechanism": ("Mechanism",),
    "system.motion": ("SystemMotion",),
    "system.parts": ("Body", "Mass"),
    "system.system": ("System",),
    "system.trajectory": ("SystemSection", "SystemTrajectory"),
    "web.notebook": ("show",),
}
_HOMES = {name: f"rigidtop.{room}" for room, names in _ROOMS.items() for name in names}


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("rigidtop")
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_HOMES[name]), name)


def load_ipython_extension(shell: Any) -> None:
    """Give a notebook ``%%audit`` and ``%%answer``: ``%load_ext rigidtop``."""
    from rigidtop.commands.cell import load_ipython_extension as load

    load(shell)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
