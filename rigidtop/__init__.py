"""Rigid bodies and the spinning top: derived, proved, typeset, computed.

Names are loaded at first use, so that ``import rigidtop`` loads nothing heavy.
"""

from __future__ import annotations

TYPE_CHECKING = False  # typing itself takes time
if TYPE_CHECKING:
    from typing import Any

    from rigidtop.errors import NoSteadyPrecession, RigidtopError
    from rigidtop.motion.body import FreeBody, HeavyBody
    from rigidtop.motion.many import FreeMotions, TopMotions, free_motions, top_motions
    from rigidtop.motion.motion import Motion
    from rigidtop.motion.table.motion import SlidingMotion, SlidingTop
    from rigidtop.motion.table.trajectory import SlidingTrajectory
    from rigidtop.motion.top import HeavyTop
    from rigidtop.motion.trajectory import Trajectory
    from rigidtop.system.motion import SystemMotion, SystemTrajectory
    from rigidtop.system.parts import Body, Mass
    from rigidtop.system.system import System
    from rigidtop.web.notebook import show

    __version__: str

__all__ = [
    "Body",
    "FreeBody",
    "FreeMotions",
    "HeavyBody",
    "HeavyTop",
    "Mass",
    "Motion",
    "NoSteadyPrecession",
    "RigidtopError",
    "SlidingMotion",
    "SlidingTop",
    "SlidingTrajectory",
    "System",
    "SystemMotion",
    "SystemTrajectory",
    "TopMotions",
    "Trajectory",
    "__version__",
    "free_motions",
    "show",
    "top_motions",
]

_HOMES = {
    "Body": "rigidtop.system.parts",
    "Mass": "rigidtop.system.parts",
    "FreeBody": "rigidtop.motion.body",
    "FreeMotions": "rigidtop.motion.many",
    "HeavyBody": "rigidtop.motion.body",
    "HeavyTop": "rigidtop.motion.top",
    "Motion": "rigidtop.motion.motion",
    "NoSteadyPrecession": "rigidtop.errors",
    "RigidtopError": "rigidtop.errors",
    "SlidingMotion": "rigidtop.motion.table.motion",
    "SlidingTop": "rigidtop.motion.table.motion",
    "SlidingTrajectory": "rigidtop.motion.table.trajectory",
    "System": "rigidtop.system.system",
    "SystemMotion": "rigidtop.system.motion",
    "SystemTrajectory": "rigidtop.system.motion",
    "TopMotions": "rigidtop.motion.many",
    "Trajectory": "rigidtop.motion.trajectory",
    "free_motions": "rigidtop.motion.many",
    "show": "rigidtop.web.notebook",
    "top_motions": "rigidtop.motion.many",
}


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("rigidtop")
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
