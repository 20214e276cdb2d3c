"""What the figures look like: one column or two, letters of 8 points or more, the same symbols as
the equations, and colours that differ in grey too."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rigidtop.notation.characters import SUPERSCRIPTS
from rigidtop.typeset.words import tex

Canvas: TypeAlias = Figure
Floats: TypeAlias = NDArray[np.float64]

COLUMN, TEXT, WIDE = 3.4, 5.25, 7.0
"""Widths of a figure (inches): one column, 8.6 cm, the text beside a margin, and two columns."""

SMALL = 8
"""The smallest letters (points)."""

STYLE: Any = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.labelsize": 9,
    "xtick.labelsize": SMALL,
    "ytick.labelsize": SMALL,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.7,
    "xtick.major.width": 0.7,
    "ytick.major.width": 0.7,
    "lines.linewidth": 1.3,
    "hatch.linewidth": 0.5,
    "legend.frameon": False,
    "svg.fonttype": "path",
    "svg.hashsalt": "rigidtop",
    "pdf.fonttype": 42,
    "ps.fonttype": 42,
    "path.simplify_threshold": 0.03,
}

INK, FIRST, SECOND, THIRD = "#1a1a1a", "#0b4f8a", "#cf5b2e", "#86b56b"
"""Lines of one picture, from dark to light."""

GREY, RULE, NOTE = "#8a8a8a", "#bdbdbd", "#4d4d4d"
"""What is beside the matter: marks, the outline of a sphere, words."""

AXIS, OMEGA, MOMENTUM, TORQUE = SECOND, FIRST, INK, "#7d4e1d"
"""Arrows as the notes colour them: principal axes, ω, L, N."""

FACE, MANTLE, EDGE = "#c3d6b1", "#dbe7cf", "#55703f"
"""A body: its lid, its side, its outline."""

GROUND = "#ececec"
"""The table, the foot of a stand."""

DASHED: tuple[float, Sequence[float]] = (0, (4, 2))
HIDDEN: tuple[float, Sequence[float]] = (0, (2.5, 2))
DASH_DOT: tuple[float, Sequence[float]] = (0, (6, 1.5, 1, 1.5))
DOTTED: tuple[float, Sequence[float]] = (0, (1, 1.6))

OMEGA_VEC, L_VEC, N_VEC = r"$\boldsymbol{\omega}$", r"$\mathbf{L}$", r"$\mathbf{N}$"
L_DOT, WEIGHT = r"$\dot{\mathbf{L}}=\mathbf{N}$", r"$M\mathbf{g}$"
R_CM = r"$\mathbf{R}_\mathrm{CM}$"
BODY = E1, E2, E3 = tuple(rf"$\mathbf{{e}}_{k}$" for k in (1, 2, 3))
SPACE = X, Y, Z = tuple(rf"$\hat{{\mathbf{{{axis}}}}}$" for axis in "xyz")


def canvas(width: float, height: float) -> Canvas:
    """An empty figure (inches), whose parts make room for each other."""
    return Canvas(figsize=(width, height), layout="constrained")


TINY = 1e-4
"""Angles that say nothing in degrees (rad)."""

# --- Numbers in words ----------------------------------------------------------------------------


def said(value: float, digits: int = 3) -> str:
    """A number as captions print it.

    >>> said(-2.5), said(40.0), said(1.2345e-7), said(-1e20)
    ('−2.5', '40', '1.23\\u202f×\\u202f10⁻⁷', '−10²⁰')
    """
    if not math.isfinite(value):
        return "∞" if value > 0 else "−∞"
    text = f"{value:.{digits}g}"
    mantissa, power, exponent = text.partition("e")
    if not power and value and not 1e-3 <= abs(value) < 1e4:
        mantissa, _, exponent = f"{value:.{digits - 1}e}".partition("e")
        mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    if not exponent:
        return text.replace("-", "−")
    raised = "".join({c: up for up, c in SUPERSCRIPTS.items()}[c] for c in str(int(exponent)))
    factor = {"1": "", "-1": "−"}.get(mantissa, f"{mantissa}\u202f×\u202f".replace("-", "−"))
    return f"{factor}10{raised}"


def in_math(value: float, digits: int = 3) -> str:
    """The same in a formula of Matplotlib's, whose letters have no raised digits.

    >>> print(in_math(-2.5), in_math(1.2345e-7), in_math(1e20))
    -2.5 1.23\\,\\times\\,10^{-7} 10^{20}
    """
    return tex(said(value, digits))


def spoken(value: float) -> str:
    """The same for a screen reader, in ASCII.

    >>> spoken(-2.5), spoken(1.2345e-7)
    ('minus 2.5', '1.23e-07')
    """
    return f"{value:.3g}".replace("inf", "infinity").replace("-", "minus ", int(value < 0))


def degrees(angle: float) -> str:
    """An angle (rad) in degrees, but a tiny one as it is.

    >>> degrees(math.pi / 3), degrees(1e-6)
    ('60°', '10⁻⁶\\u202frad')
    """
    if 0 < abs(angle) < TINY:
        return f"{said(angle)}\u202frad"
    return f"{said(math.degrees(angle))}°"
