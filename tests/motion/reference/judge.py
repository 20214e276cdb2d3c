"""Judges computed motions by the reference.

The error of an attitude is the angle of the rotation between the two (rad), of ω the norm of the
difference (rad/s).  Allowed are

    2e-13 + 50 × sensitivity   and   2e-13 max(1, |ω|) + 50 × sensitivity,

where the sensitivity is what a unit in the last place of all inputs does to the motion.  A ratio is
the error divided by what is allowed: at most 1 is right.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import rigidtop as rt

Floats = NDArray[np.float64]

HERE = Path(__file__).parent
FILES = {"tops": "tops.npz", "bodies": "bodies.npz", "far": "far.npz"}
ERROR = 2e-13
UNITS = 50.0
SMALLEST_TILT = 1e-50
"""Below this the closed form claims nothing relative to the tilt: see `Motion.exact`."""


@dataclass(frozen=True, eq=False)
class Reference:
    """One stored motion."""

    kind: str
    """The file that it is from; `far` are tops and bodies after many periods."""

    number: int
    family: str

    inputs: Floats
    """λ₁, λ₃, M, R, g, θ, θ̇, φ, φ̇, ψ, ω₃ of a top; λ₁…₃, ω₁…₃, q (scalar first) of a body."""

    times: Floats

    attitude: Floats
    """q at each time, scalar first."""

    omega: Floats
    """Body components at each time."""

    sensitivity: Floats
    """Of the attitude (rad) and of ω (rad/s) at each time."""

    axis_sensitivity: Floats
    """Of sin θ exp(iφ), which is the horizontal part of e₃, at each time."""

    @property
    def name(self) -> str:
        return f"{self.kind}[{self.number}]"

    @property
    def motion(self) -> Any:
        """The same motion, of the package that is judged."""
        values = self.inputs.tolist()
        if len(values) == 11:
            lambda1, lambda3, mass, arm, g, theta, theta_dot, phi, phi_dot, psi, omega3 = values
            top = rt.HeavyTop(lambda1=lambda1, lambda3=lambda3, M=mass, R=arm, g=g)
            return top.motion(
                theta=theta,
                theta_dot=theta_dot,
                phi=phi,
                phi_dot=phi_dot,
                psi=psi,
                omega3=omega3,
            )
        attitude = Rotation.from_quat(np.roll(values[6:10], -1))
        return rt.FreeBody(*values[:3]).motion(values[3:6], attitude)


@cache
def references() -> tuple[Reference, ...]:
    """All stored motions, in the order of the files."""
    found = []
    for kind, name in FILES.items():
        if not (HERE / name).exists():
            continue
        with np.load(HERE / name) as file:
            stored = {key: file[key] for key in file}
        for k, family in enumerate(stored["family"].tolist()):
            inputs = stored["inputs"][k]
            found.append(
                Reference(
                    kind,
                    k,
                    family,
                    inputs[:10] if family == "far_bodies" else inputs,  # padded to 11
                    stored["times"][k],
                    stored["attitude"][k],
                    stored["omega"][k],
                    stored["sensitivity"][k].astype(float),
                    stored["axis_sensitivity"][k],
                )
            )
    return tuple(found)


def families() -> list[str]:
    return list(dict.fromkeys(reference.family for reference in references()))


def of_family(name: str) -> list[Reference]:
    return [reference for reference in references() if reference.family == name]


Run = Callable[[Any, Floats], Any]
"""From a motion and times, a trajectory with `rotation` and `omega`."""


def exact(motion: Any, times: Floats) -> Any:
    return motion.exact(times)


def compiled(motion: Any, times: Floats) -> Any:
    return motion.exact(times, compiled=True)


def errors(reference: Reference, run: Any) -> Floats:
    """For each time, the errors of attitude (rad) and ω (rad/s)."""
    computed = np.roll(run.rotation.as_quat(), 1, axis=-1)
    q0, q = computed[:, 0], computed[:, 1:]
    r0, r = reference.attitude[:, 0], reference.attitude[:, 1:]
    # The vector part of the relative quaternion keeps the digits of tiny angles.
    vector = r0[:, None] * q - q0[:, None] * r - np.cross(r, q)
    angle = 2 * np.linalg.norm(vector, axis=1)
    return np.stack([angle, np.linalg.norm(run.omega - reference.omega, axis=1)], axis=1)


def axis_ratios(reference: Reference, run: Run = exact) -> Floats:
    """For each time, the error of sin θ exp(iφ) of a top divided by that allowed.

    Allowed is an error relative to the largest tilt from the vertical at these times and t = 0, if
    that is more than `SMALLEST_TILT`.  The turn of the body about e₃ does not matter here, though
    it may be known to a few digits only.
    """

    def horizontal(q: Floats) -> NDArray[np.complex128]:
        return 2 * (q[:, 0] + 1j * q[:, 3]) * (q[:, 2] - 1j * q[:, 1])

    expected = horizontal(reference.attitude)
    size = max(np.abs(expected).max(), np.sin(reference.inputs[5]), SMALLEST_TILT)
    computed = np.roll(run(reference.motion, reference.times).rotation.as_quat(), 1, axis=-1)
    found = np.abs(horizontal(computed) - expected)
    most = ERROR * size + UNITS * reference.axis_sensitivity
    return np.where(np.isnan(found), np.inf, found) / most


def allowed(reference: Reference, error: float = ERROR, units: float = UNITS) -> Floats:
    """For each time, the errors of attitude (rad) and ω (rad/s) that are allowed."""
    size = np.maximum(1.0, np.linalg.norm(reference.omega, axis=1))
    scale = np.stack([np.ones(len(size)), size], axis=1)
    return error * scale + units * reference.sensitivity


def ratios(reference: Reference, run: Run = exact) -> Floats:
    """For each time, the errors of attitude and ω divided by those allowed; NaN becomes inf."""
    found = errors(reference, run(reference.motion, reference.times)) / allowed(reference)
    return np.where(np.isnan(found), np.inf, found)


def worst(
    judged: Sequence[Reference],
    run: Run = exact,
    measure: Callable[[Reference, Run], Floats] = ratios,
) -> Iterator[tuple[float, Reference, str]]:
    """For each motion its largest ratio and, for an exception, what it says (ratio inf)."""
    for reference in judged:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                yield float(measure(reference, run).max()), reference, ""
        except Exception as problem:
            yield np.inf, reference, f"{type(problem).__name__}: {problem}"


def describe(reference: Reference, run: Run = exact) -> str:
    """The inputs of a motion, and times, errors and what is allowed."""
    lines = [f"{reference.name} {reference.family}", f"  {reference.motion.body}"]
    names = "theta theta_dot phi phi_dot psi omega3" if len(reference.inputs) == 11 else ""
    names = names or "omega1 omega2 omega3 q0 q1 q2 q3"
    values = reference.inputs.tolist()[-len(names.split()) :]
    pairs = zip(names.split(), values, strict=True)
    lines.append("  " + ", ".join(f"{name}={value!r}" for name, value in pairs))
    try:
        found = errors(reference, run(reference.motion, reference.times))
    except Exception as problem:
        found = np.full((len(reference.times), 2), np.nan)
        lines.append(f"  {type(problem).__name__}: {problem}")
    for t, error, most in zip(reference.times.tolist(), found, allowed(reference), strict=True):
        attitude, omega = (f"{x:.1e} of {y:.1e}" for x, y in zip(error, most, strict=True))
        lines.append(f"  t={t!r}: attitude {attitude}, ω {omega}")
    return "\n".join(lines)
