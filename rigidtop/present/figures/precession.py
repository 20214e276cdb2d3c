"""Steady precession: its two rates."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas

from rigidtop.motion.top import HeavyTop
from rigidtop.present.figures.bodies import SPIN, THETA, TOP, top_in_words
from rigidtop.present.figures.drawing import Drawing
from rigidtop.present.figures.style import (
    COLUMN,
    DASHED,
    DOTTED,
    FIRST,
    GREY,
    INK,
    SECOND,
    canvas,
    degrees,
    name_at,
    said,
    spoken,
)

# --- Ω₋ and Ω₊ against ω₃ ------------------------------------------------------------------------


def draw_precession_rates(axes: Axes, top: HeavyTop, theta: float, omega3: float) -> None:
    """Ω₋ and Ω₊ of (3.57) against ω₃, at the tilt `theta` (rad); dots at the spin `omega3` (rad/s).

    Dashed are the values that the notes give for large ω₃; the dotted line is the least spin at
    which a steady precession exists.  Raises NoSteadyPrecession if `omega3` is less.
    """
    marked = top.steady_precession(theta, omega3)
    least = top.smallest_spin(theta)
    last = max(3.5 * least, 1.25 * omega3)
    spins = least + (last - least) * np.linspace(0.0, 1.0, 400)[1:] ** 2
    spins[0] = least * (1 + 1e-12) if least else spins[0]
    rates = np.array([top.steady_precession(theta, spin) for spin in spins])
    weight, cosine = top.M * top.g * top.R, math.cos(theta)
    leaning = math.isfinite(marked[1])  # horizontal, there is no fast precession
    slow = weight / (top.lambda3 * spins)
    axes.plot(spins, slow, color=GREY, lw=1.0, ls=DASHED)
    if least:
        axes.axvline(least, color=GREY, lw=0.9, ls=DOTTED)
    if leaning:
        fast = top.lambda3 * spins / (top.lambda1 * cosine)
        axes.plot(spins, fast, color=GREY, lw=1.0, ls=DASHED)
        axes.plot(spins, rates[:, 1], color=SECOND, label="_fast")
        axes.plot(omega3, marked[1], "o", color=SECOND, ms=4)
        name_at(axes, last, rates[-1, 1], r"$\Omega_+$", (3, 0), va="center", color=SECOND)
    axes.plot(spins, rates[:, 0], color=FIRST, label="_slow")
    axes.plot(omega3, marked[0], "o", color=FIRST, ms=4)
    name_at(axes, last, rates[-1, 0], r"$\Omega_-$", (3, 0), va="center", color=FIRST)
    top_edge = max(rates[-1, 1] if leaning else 0.0, 0.0) or 4 * float(marked[0])
    bottom = min(rates[-1, 1], 0.0) if leaning else 0.0
    axes.set_xlim(0.5 * least, last)
    axes.set_ylim(1.02 * bottom, 1.08 * top_edge)
    where = least + 0.55 * (last - least)
    if leaning:
        name_at(
            axes,
            where,
            float(np.interp(where, spins, fast)),
            r"$\lambda_3\omega_3/(\lambda_1\cos\theta)$",
            (-5, 5 * (1 if cosine > 0 else -1)),
            ha="right",
            va="bottom" if cosine > 0 else "top",
        )
    name_at(
        axes,
        where,
        float(np.interp(where, spins, slow)),
        r"$MgR/(\lambda_3\omega_3)$",
        (0, 6),
        ha="center",
    )
    if least:
        name_at(
            axes,
            least,
            1.08 * top_edge,
            r"$\frac{2}{\lambda_3}\sqrt{\lambda_1 MgR\,\cos\theta}$",
            (4, -1),
            va="top",
            color=INK,
        )
    axes.set_xlabel(r"$\omega_3$  (rad/s)")
    axes.set_ylabel(r"$\Omega$  (rad/s)")


def _precession_rates(theta: float, omega3: float, **top: float) -> Canvas:
    drawn = canvas(COLUMN, 2.5)
    draw_precession_rates(drawn.subplots(), HeavyTop(**top), theta, omega3)
    return drawn


def _precession_rates_caption(theta: float, omega3: float, **top: float) -> str:
    body = HeavyTop(**top)
    slow, fast = body.steady_precession(theta, omega3)
    least = body.smallest_spin(theta)
    roots = f"Ω₋ = {said(slow)} rad/s"
    if math.isfinite(fast):
        roots += f" and Ω₊ = {said(fast)} rad/s"
    left = (
        f" Left of the dotted line, ω₃ = {said(least)} rad/s, no steady precession exists."
        if least
        else ""
    )
    return (
        f"The roots of (3.57) against ω₃ at θ = {degrees(theta)}, for {top_in_words(body)}; at "
        f"ω₃ = {said(omega3)} rad/s they are {roots}. Dashed: what the notes give for large ω₃."
        f"{left}"
    )


def _precession_rates_in_words(theta: float, omega3: float, **top: float) -> str:
    body = HeavyTop(**top)
    slow, fast = body.steady_precession(theta, omega3)
    least = body.smallest_spin(theta)
    if not least:
        return (
            "Rates of steady precession against the spin of a top that does not stand above the "
            f"horizontal: at {spoken(omega3)} radians per second the slow one is {spoken(slow)} "
            f"and the fast one {spoken(fast)}."
        )
    return (
        f"Two curves that begin at a common point at the least spin, {spoken(least)} radians per "
        "second. The fast rate rises to the straight line lambda3 omega3 over lambda1 cos theta, "
        f"the slow rate falls to the hyperbola M g R over lambda3 omega3; at {spoken(omega3)} they "
        f"are {spoken(fast)} and {spoken(slow)}."
    )


PRECESSION_RATES = Drawing(
    "precession-rates",
    "Ω₋ and Ω₊ against ω₃, with the threshold",
    "3.5.3",
    (*TOP, THETA, SPIN),
    _precession_rates,
    _precession_rates_caption,
    _precession_rates_in_words,
)
