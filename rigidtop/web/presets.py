"""Motions worth seeing, their numbers computed."""

from __future__ import annotations

from collections.abc import Callable
from math import pi, radians

from rigidtop.derivations.exercises import bodies
from rigidtop.derivations.toutatis import MOMENTS, START
from rigidtop.motion.body import FreeBody
from rigidtop.motion.top import HeavyTop
from rigidtop.web.setup import FREE, HEAVY, Preset, free, heavy

TOP = HeavyTop(**{p.name: p.default for p in bodies.HEAVY_TOP})
"""The top of the exercises."""

TILT = bodies.TILT.default
SPIN = 12.0
"""Slow enough to be followed by eye (rad/s)."""

AXIS = ("e3", "trail")


def _top(
    name: str, title: str, about: str, layers: tuple[str, ...] = AXIS, speed: float = 1.0,
    **state: float,
) -> Preset:  # fmt: skip
    setup = heavy(TOP, TOP.M, TOP.g, (0.0, 0.0, TOP.R), **state)
    return Preset(name, title, about, setup, layers, "top", speed=speed)


def heavy_presets() -> tuple[Preset, ...]:
    """The motions of the heavy top that the page offers."""
    slow, fast = TOP.steady_precession(TILT, SPIN)
    sleeping = TOP.sleeping_spin()
    arrows = ("e3", "omega", "L", "torque", "trail")
    return (
        _top(
            "loops",
            "Loops",
            "Pushed against its precession: φ̇ changes sign, and e₃ draws loops.",
            theta=TILT, phi_dot=-2 * slow, omega3=SPIN,
        ),
        _top(
            "slow",
            "Slow precession",
            "φ̇₀ is the slow root Ω₋ of (3.57): the axis keeps its tilt, and the torque turns L "
            "about the vertical.",
            arrows,
            theta=TILT, phi_dot=slow, omega3=SPIN,
        ),
        _top(
            "fast",
            "Fast precession",
            "φ̇₀ is the fast root Ω₊ of (3.57), which for fast spin tends to λ₃ω₃/(λ₁ cos θ): the "
            "free precession, in which gravity plays no part.",
            ("e3", "omega", "L", "trail"),
            speed=0.5,
            theta=TILT, phi_dot=fast, omega3=SPIN,
        ),
        _top(
            "waves",
            "Waves",
            "φ̇ keeps its sign, so e₃ draws waves between two circles.",
            theta=TILT, phi_dot=slow / 2, omega3=SPIN,
        ),
        _top(
            "cusps",
            "Cusps",
            "Held at rest and let go: φ̇ vanishes at the upper circle, where e₃ stops for an "
            "instant.",
            theta=TILT, phi_dot=0.0, omega3=SPIN,
        ),
        _top(
            "sleeping",
            "Sleeping",
            "Spinning faster than 2√(λ₁MgR)/λ₃, an upright top that is pushed a little stays near "
            "the vertical.",
            theta=radians(1), omega3=1.2 * sleeping,
        ),
        _top(
            "waking",
            "Waking",
            "A little slower than 2√(λ₁MgR)/λ₃ the same push grows: the top falls away from the "
            "vertical, rises again, and so on.",
            theta=radians(1), omega3=0.9 * sleeping,
        ),
        _top(
            "toppling",
            "Toppling",
            "Without spin it is a pendulum that stands on its head: it falls. At the lowest point "
            "e₃ goes through the vertical, where φ jumps by 180°.",
            ("e3", "torque", "trail"),
            theta=radians(10),
        ),
        _top(
            "running-down",
            "Running down",
            "Friction takes the spin: the slower the top, the faster it goes round, until it can "
            "no longer hold its tilt and sinks. In the end it hangs.",
            theta=TILT, phi_dot=slow, omega3=SPIN, friction=0.05,
        ),
    )  # fmt: skip


def free_presets() -> tuple[Preset, ...]:
    """The motions of free bodies that the page offers."""
    cones, poinsot = ("e3", "omega", "L", "cones"), ("omega", "L", "poinsot")
    return (
        Preset(
            "free-precession",
            "Free precession",
            "λ₃ is the smallest moment: the body cone rolls on the outside of the space cone, and "
            "both touch along ω.",
            free((1.3, 1.3, 0.7), (1.5, 0.0, 2.5)),
            cones,
            "brick",
        ),
        Preset(
            "plate",
            "Wobbling plate",
            "For a flat plate λ₃ = 2λ₁: e₃ wobbles about twice as fast as the plate spins, and the "
            "space cone lies inside the body cone, which rolls around it.",
            free((1.0, 1.0, 2.0), (1.0, 0.0, 4.0)),
            cones,
            "wheel",
        ),
        Preset(
            "flip",
            "Flip",
            "Started nearly along e₂, the axis of the intermediate moment, the body flips again "
            "and again. L does not move.",
            free((1.0, 1.7, 2.3), (0.02, 4.0, 0.02)),
            ("e2", "omega", "L", "trail"),
            "T-handle",
        ),
        Preset(
            "largest",
            "Largest moment",
            "ω stays near e₃: its polhode is a closed curve around the axis.",
            free((1.0, 1.7, 2.3), (1.5, 0.0, 3.5)),
            poinsot,
            "brick",
        ),
        Preset(
            "smallest",
            "Smallest moment",
            "ω stays near e₁: rotation about the axis of the smallest moment is stable too, as "
            "long as no friction takes energy.",
            free((1.0, 1.7, 2.3), (3.5, 0.0, 1.0)),
            poinsot,
            "brick",
        ),
        _toutatis(),
    )


def _toutatis() -> Preset:
    moments, rates = tuple(map(float, MOMENTS)), tuple(map(radians, START.rates))
    motion = FreeBody(*moments).motion(omega=rates)
    about = (
        "From its state of 9 November 1992 (Takahashi, Busch & Scheeres 2013): ω circles about "
        f"the long axis e₃ in {2 * motion.nutation_period:.1f} days, while that axis turns about L "
        f"in {2 * pi / abs(motion.mean_precession):.1f} days. At ×1 each second shows a day; "
        "moments are in units of the smallest."
    )
    setup = free((moments[0], moments[1], moments[2]), (rates[0], rates[1], rates[2]), "d")
    layers = ("e3", "omega", "L", "trail")
    return Preset("toutatis", "Toutatis", about, setup, layers, "asteroid")


PRESETS: dict[str, Callable[[], tuple[Preset, ...]]] = {HEAVY: heavy_presets, FREE: free_presets}
