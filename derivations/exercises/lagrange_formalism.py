"""Section 3.5.3: both rates of precession of a fast top."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import comb, cos, sqrt

import numpy as np
from scipy.optimize import brentq

from rigidtop.derivations.lagrange_formalism import two_roots
from rigidtop.errors import RigidtopError
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure

from .bodies import HEAVY_TOP, SPIN, TILT, heavy_top, simple_rate, smallness

roots_in_powers = Claim(
    "roots-in-powers",
    "Both rates of a fast top as power series in "
    r"$\varepsilon = \lambda_1MgR \cos\theta/(\lambda_3\omega_3)^2$.",
)


fast_enough = Claim(
    "fast-enough", "From which spin on the leading terms of both rates are as good as one wants."
)


def catalan(n: int) -> int:
    """1, 1, 2, 5, 14, 42, …"""
    return comb(2 * n, n) // (n + 1)


def series_factors(terms: int, smallness: float) -> tuple[float, float]:
    """Ω₋ and Ω₊ over their leading terms, to as many terms of the series in ε."""
    slow = sum(catalan(n) * smallness**n for n in range(terms))
    fast = 1 - sum(catalan(n - 1) * smallness**n for n in range(1, terms))
    return slow, fast


def leading(top: HeavyTop, tilt: float, spin: float) -> tuple[float, float]:
    """MgR/(λ₃ω₃) and λ₃ω₃/(λ₁ cos θ) (rad/s)."""
    return simple_rate(top, spin), top.lambda3 * spin / (top.lambda1 * cos(tilt))


def spin_for(top: HeavyTop, tilt: float, accuracy: float) -> tuple[float, float]:
    """From which |ω₃| on each leading term is that accurate, relative to the rate (rad/s)."""
    delta = accuracy if cos(tilt) > 0 else -accuracy
    weight = top.lambda1 * top.weight[2] * cos(tilt)
    slow, fast = weight / (delta * (1 - delta)), (1 + delta) ** 2 * weight / delta
    return sqrt(slow) / top.lambda3, sqrt(fast) / top.lambda3


def spin_by_search(top: HeavyTop, tilt: float, accuracy: float) -> tuple[float, float]:
    """The same by a search for the spin at which the error has that size."""

    def excess(root: int) -> Callable[[float], float]:
        def of(spin: float) -> float:
            exact = top.steady_precession(tilt, spin)[root]
            return abs(leading(top, tilt, spin)[root] / exact - 1) - accuracy

        return of

    scale = sqrt(top.lambda1 * top.weight[2]) / top.lambda3
    low = top.smallest_spin(tilt) * (1 + 1e-9) or 1e-6 * sqrt(-cos(tilt)) * scale
    found = []
    for root in (0, 1):
        high = 2 * low
        while excess(root)(high) > 0:
            high *= 2
        found.append(float(brentq(excess(root), low, high, xtol=1e-300, rtol=1e-14)))
    return found[0], found[1]


@exercise(
    "fast-spin-roots",
    "Both rates of precession of a fast top",
    section="3.5.3",
    asks="the exercise below (3.57)",
    statement=r"Solve the quadratic (3.57) for the rate $\Omega$ of steady precession and find "
    r"both solutions for very large $\omega_3$. What is the next term of each, and how "
    "good is each order for the given top?\n\nHow fast must the top spin for the leading "
    "terms to be right within the given accuracy?",
    claims=(two_roots, roots_in_powers, fast_enough),
    parameters=(
        *HEAVY_TOP,
        TILT,
        SPIN,
        Parameter("accuracy", 0.01, r"error allowed, relative to $\Omega$", least=1e-9, most=0.4),
    ),
    figure="asymptotics",
    text="exercises/fast_spin_roots",
)
def fast_spin_roots(
    theta: float, omega3: float, accuracy: float, **shape: float
) -> Iterator[Outcome]:
    """The table compares both roots with their series, order by order. The spin from which the
    leading terms suffice follows from the two conditions just derived."""
    top = heavy_top(**shape)
    if abs(cos(theta)) < 1e-9:
        raise RigidtopError(
            f"theta = {theta:g}: a horizontal axis has the slow rate alone, MgR/(λ₃ω₃) exactly"
        )
    exact = top.steady_precession(theta, omega3)
    if omega3 == 0:
        raise RigidtopError("omega3 = 0: the leading terms are those of a top that spins")
    epsilon = smallness(top, omega3) * cos(theta)
    lead = leading(top, theta, omega3)
    yield Answer(
        "epsilon", r"$\varepsilon = \lambda_1MgR \cos\theta/(\lambda_3\omega_3)^2$", epsilon
    )
    rows = []
    for terms in range(1, 6):
        pair = [x * f for x, f in zip(lead, series_factors(terms, epsilon), strict=True)]
        errors = [x / root - 1 for x, root in zip(pair, exact, strict=True)]
        rows.append((terms, pair[0], errors[0], pair[1], errors[1]))
    for k, name, sign in ((0, "slow", "₋"), (1, "fast", "₊")):
        yield Answer(f"{name}", rf"$\Omega{sign}$, root of (3.57)", exact[k], "rad/s")
        yield Answer(f"{name}_leading", rf"$\Omega{sign}$, leading term", lead[k], "rad/s")
        yield Answer(f"{name}_error", "its error, relative to the root", rows[0][2 + 2 * k])
        yield Answer(
            f"{name}_next", rf"$\Omega{sign}$ with the next term", rows[1][1 + 2 * k], "rad/s"
        )
        yield Answer(f"{name}_next_error", "its error", rows[1][2 + 2 * k])
    yield Table(
        "orders",
        "Both series, order by order",
        ("terms", r"$\Omega_-$ (rad/s)", "relative error", r"$\Omega_+$ (rad/s)", "relative error"),
        tuple(rows),
    )
    spins = spin_for(top, theta, accuracy)
    yield Answer(
        "threshold",
        r"smallest $|\omega_3|$ of steady precession",
        top.smallest_spin(theta),
        "rad/s",
    )
    yield Answer(
        "slow_spin",
        r"$|\omega_3|$ from which $MgR/(\lambda_3\omega_3)$ is accurate enough",
        spins[0],
        "rad/s",
    )
    yield Answer(
        "fast_spin",
        r"$|\omega_3|$ from which $\lambda_3\omega_3/(\lambda_1 \cos\theta)$ is",
        spins[1],
        "rad/s",
    )
    coefficients = [top.lambda1 * cos(theta), -top.lambda3 * omega3, top.weight[2]]
    companion = sorted(np.roots(coefficients).real, key=abs)
    difference = max(abs(a / b - 1) for a, b in zip(companion, exact, strict=True))
    scale = max(1.0, abs(exact[1] / exact[0]))  # eigenvalues have errors of the size of the larger
    yield Measure(
        "roots as eigenvalues of the companion matrix, relative", difference, 1e-7 * scale
    )
    searched = spin_by_search(top, theta, accuracy)
    for name, found, closed in zip(("slow", "fast"), searched, spins, strict=True):
        what = f"spin from which the leading term of the {name} rate suffices, searched, relative"
        yield Measure(what, abs(found / closed - 1), 1e-11 + 1e-14 / accuracy)


EXERCISES: tuple[Exercise, ...] = (fast_spin_roots,)
"""In the order of the notes."""
