"""The tours tell what Python computes of the motions that they show."""

from __future__ import annotations

import math

import numpy as np
import pytest

import rigidtop as rt
from rigidtop.web.presets import PRESETS, SPIN, TILT, TOP
from rigidtop.web.setup import FREE, HEAVY, body_of
from rigidtop.web.tours import TOURS, heavy_tour


def motion_of(kind, step):
    """The motion that an address of the page means."""
    said = dict(part.split("=") for part in step.show.split("&"))
    preset = next(p for p in PRESETS[kind]() if p.name == said["preset"])
    values = {name: float(said.get(name, value)) for name, value in preset.setup.values.items()}
    if kind == FREE:
        return body_of(preset.setup).motion(omega=[values[f"omega{k}"] for k in (1, 2, 3)])
    return TOP.motion(**{n: values[n] for n in ("theta", "theta_dot", "phi_dot", "omega3")})


def test_the_nutations_are_what_the_tour_says():
    for step in heavy_tour():
        if set(step.choices) == {"waves", "cusps", "loops"}:
            assert step.choices[step.answer] == motion_of(HEAVY, step).regime
    first, *_ = heavy_tour()
    path = motion_of(HEAVY, first).exact(np.linspace(0, 0.02, 50))
    fallen, aside = path.theta[-1] - TILT, math.sin(TILT) * path.phi[-1]
    assert first.choices[first.answer] == "it falls"
    assert fallen > 5 * abs(aside) > 0


def test_the_steady_rates_are_what_the_tour_says():
    steady = [s for s in heavy_tour() if "stays at 30°" in s.ask or "steady" in s.ask]
    for step in heavy_tour()[4:7]:
        motion = motion_of(HEAVY, step)
        assert np.ptp(motion.exact(np.linspace(0, 5, 100)).theta) < 1e-9
    assert len(steady) == 3
    slow, fast = TOP.steady_precession(TILT, SPIN)
    half = TOP.steady_precession(TILT, 2 * SPIN)[0] / slow
    assert 0.4 < half < 0.6
    assert fast > slow
    with pytest.raises(rt.RigidtopError):
        TOP.steady_precession(TILT, motion_of(HEAVY, heavy_tour()[7]).omega[2])


def test_the_flips_are_what_the_tour_says():
    steps = {step.show: motion_of(FREE, step) for step in TOURS[FREE]()}
    flip, near, on, separatrix = list(steps.values())[4:8]
    assert flip.nutation_period == pytest.approx(7.696, abs=1e-3)
    # What is off the axis grows as e^(σt): with ω₂ = 4 that is σ = 4 √((λ₂−λ₁)(λ₃−λ₂)/(λ₁λ₃)).
    sigma = 4 * math.sqrt(0.7 * 0.6 / 2.3)
    later = near.nutation_period - flip.nutation_period
    assert later == pytest.approx(2 * math.log(10) / sigma, rel=1e-3)
    assert f"later, by {later:.1f} s" in TOURS[FREE]()[5].choices
    assert (on.regime, separatrix.regime) == ("steady", "separatrix")
    middle = separatrix.exact(np.linspace(0, 10, 1000)).omega[:, 1]
    assert np.count_nonzero(np.diff(np.sign(middle))) == 1
    L = steps["preset=free-precession"].exact([0.0, 0.7]).angular_momentum
    assert L[0] == pytest.approx(L[1], abs=1e-12)
