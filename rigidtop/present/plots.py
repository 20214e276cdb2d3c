"""Figures: drawn on a given Axes, readable in grey, with the symbols of the equations.

Nothing here touches the state of pyplot.  `rendered` gives the bytes of a figure, the same each
time.

>>> sorted(figure.name for _, figure, _ in FIGURES)
['cones', 'effective-potential', 'paths', 'precession-rates']
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from io import BytesIO
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from rigidtop.motion.top import HeavyTop
from rigidtop.present.report import Figure

Floats = NDArray[np.float64]

STYLE: Any = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.7,
    "lines.linewidth": 1.4,
    "legend.frameon": False,
    "svg.fonttype": "path",
    "svg.hashsalt": "rigidtop",
    "pdf.fonttype": 42,
    "path.simplify_threshold": 0.3,
}
INK, GREY, RULE = "#1a1a1a", "#8a8a8a", "#bdbdbd"
FIRST, SECOND, THIRD = "#0b4f8a", "#a33c1a", "#3f6b2a"

EXAMPLE = HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1, g=9.81)
"""The top of the figures: MgR = 0.981 J, and about the centre of mass 0.01 kg m² each way."""


# --- Steady precession ---------------------------------------------------------------------------


def draw_precession_rates(axes: Axes, top: HeavyTop, theta: float, fastest: float) -> None:
    """Ω₋ and Ω₊ of (3.57) against ω₃ up to `fastest` (rad/s), at the tilt `theta` (rad).

    Dashed are the values that the notes give for large ω₃; the dotted line is the least spin at
    which a steady precession exists.
    """
    least = top.smallest_spin(theta)
    spins = least + (fastest - least) * np.linspace(0.0, 1.0, 400) ** 2
    spins[0] = np.nextafter(least, np.inf)
    rates = np.array([_roots(top, theta, spin) for spin in spins])
    weight = top.M * top.g * top.R
    axes.axvline(least, color=GREY, lw=0.9, ls=":")
    slow, fast = weight / (top.lambda3 * spins), top.lambda3 * spins / (top.lambda1 * np.cos(theta))
    axes.plot(spins, fast, color=GREY, lw=1.0, ls="--")
    axes.plot(spins, slow, color=GREY, lw=1.0, ls="--")
    axes.plot(spins, rates[:, 1], color=SECOND)
    axes.plot(spins, rates[:, 0], color=FIRST)
    end = spins[-1]
    _label(axes, end, rates[-1, 1], r" $\Omega_+$", SECOND)
    _label(axes, end, rates[-1, 0], r" $\Omega_-$", FIRST)
    where = 0.45
    x = least + where * (end - least)
    _note(
        axes,
        x,
        float(np.interp(x, spins, fast)),
        r"$\lambda_3\omega_3/(\lambda_1\cos\theta)$",
        (-4, 6),
        "right",
    )
    _note(axes, x, float(np.interp(x, spins, slow)), r"$MgR/(\lambda_3\omega_3)$", (0, 5), "left")
    axes.annotate(
        r"$\omega_3 = \frac{2}{\lambda_3}\sqrt{\lambda_1 MgR\,\cos\theta}$",
        (least, float(rates[-1, 1])),
        xytext=(5, 0),
        textcoords="offset points",
        va="top",
        color="#555555",
    )
    axes.set_xlim(0.5 * least, end)
    axes.set_ylim(0, None)
    axes.set_xlabel(r"$\omega_3$  (rad/s)")
    axes.set_ylabel(r"$\Omega$  (rad/s)")


def _roots(top: HeavyTop, theta: float, spin: float) -> tuple[float, float]:
    """Both roots of (3.57), the slow one without cancellation."""
    a, b, c = top.lambda1 * np.cos(theta), top.lambda3 * spin, top.M * top.g * top.R
    root = np.sqrt(max(b * b - 4 * a * c, 0.0))
    return 2 * c / (b + root), (b + root) / (2 * a)


# --- The effective potential ----------------------------------------------------------------------


def effective_potential(top: HeavyTop, theta: ArrayLike, p_phi: float, p_psi: float) -> Floats:
    """(p_φ − p_ψ cos θ)²/(2λ₁ sin² θ) + MgR cos θ, in J; θ in rad, the momenta in J s."""
    angle = np.asarray(theta, dtype=float)
    turning = (p_phi - p_psi * np.cos(angle)) ** 2 / (2 * top.lambda1 * np.sin(angle) ** 2)
    return np.asarray(turning + top.M * top.g * top.R * np.cos(angle))


def draw_effective_potential(
    axes: Axes, top: HeavyTop, p_phi: float, p_psi: float, energy: float
) -> None:
    """U(θ) with the energy (J, without p_ψ²/2λ₃) and the turning points between which θ runs."""
    angles = np.linspace(0.02, np.pi - 0.02, 2000)
    potential = effective_potential(top, angles, p_phi, p_psi)
    low = int(np.argmin(potential))

    def above(angle: float) -> float:
        return float(effective_potential(top, angle, p_phi, p_psi)) - energy

    first, last = 0.02, np.pi - 0.02
    turns = [float(brentq(above, *ends)) for ends in ((first, angles[low]), (angles[low], last))]
    depth = energy - potential[low]
    axes.plot(np.degrees(angles), potential, color=FIRST)
    inside = np.linspace(turns[0], turns[1], 200)
    axes.fill_between(
        np.degrees(inside),
        effective_potential(top, inside, p_phi, p_psi),
        energy,
        color=FIRST,
        alpha=0.12,
        lw=0,
    )
    axes.plot(np.degrees(turns), [energy, energy], color=INK, lw=1.0)
    axes.plot(np.degrees(turns), [energy, energy], "o", color=INK, ms=4)
    axes.plot(np.degrees(angles[low]), potential[low], "s", color=SECOND, ms=4.5)
    bottom = potential[low] - 1.2 * depth
    for turn, name in zip(turns, (r"$\theta_1$", r"$\theta_2$"), strict=True):
        axes.plot(np.degrees([turn, turn]), [bottom, energy], color=GREY, lw=0.8, ls=":")
        axes.annotate(
            name,
            (float(np.degrees(turn)), bottom),
            xytext=(4, 3),
            textcoords="offset points",
        )
    axes.annotate(
        "$E$", (float(np.degrees(turns[1])), energy), xytext=(6, -3), textcoords="offset points"
    )
    axes.annotate(
        "steady",
        (float(np.degrees(angles[low])), float(potential[low])),
        xytext=(0, -6),
        textcoords="offset points",
        ha="center",
        va="top",
        color=SECOND,
    )
    span = turns[1] - turns[0]
    axes.set_xlim(*np.degrees([turns[0] - 0.6 * span, turns[1] + 0.6 * span]))
    axes.set_ylim(bottom, energy + 2.2 * depth)
    axes.set_xlabel(r"$\theta$  (degrees)")
    axes.set_ylabel(r"$U(\theta)$  (J)")


# --- On the sphere --------------------------------------------------------------------------------


def projected(points: ArrayLike, elevation: float = 0.42) -> tuple[Floats, Floats, Floats]:
    """Right, up and towards the eye: points (N, 3) seen from `elevation` (rad)."""
    x, y, z = np.asarray(points, dtype=float).T
    up = z * np.cos(elevation) - x * np.sin(elevation)
    near = z * np.sin(elevation) + x * np.cos(elevation)
    return y, up, near


def _curve(axes: Axes, points: Floats, **style: Any) -> None:
    """A curve on a sphere, faint and dashed where the sphere hides it."""
    across, up, near = projected(points)
    back = np.where(near < 0, 1.0, np.nan)
    front = np.where(near >= -1e-9, 1.0, np.nan)
    color, width = style.pop("color", INK), style.pop("lw", 1.2)
    axes.plot(across * back, up * back, color=color, lw=0.6 * width, alpha=0.45, ls=(0, (3, 2)))
    axes.plot(across * front, up * front, color=color, lw=width, **style)


def _parallel(theta: float, count: int = 181) -> Floats:
    around = np.linspace(0, 2 * np.pi, count)
    return np.column_stack(
        [
            np.sin(theta) * np.cos(around),
            np.sin(theta) * np.sin(around),
            np.full(count, np.cos(theta)),
        ]
    )


def draw_path(axes: Axes, e3: ArrayLike, title: str = "") -> None:
    """The path of the figure axis, unit vectors (N, 3) in space, on the sphere."""
    path = np.asarray(e3, dtype=float)
    around = np.linspace(0, 2 * np.pi, 241)
    axes.plot(np.cos(around), np.sin(around), color=RULE, lw=0.8)
    polar = np.arccos(np.clip(path[:, 2], -1, 1))
    _curve(axes, _parallel(np.pi / 2), color=RULE, lw=0.8)
    for theta in (polar.min(), polar.max()):
        _curve(axes, _parallel(float(theta)), color=GREY, lw=0.8)
    _curve(axes, path, color=FIRST, lw=1.5)
    _, top, _ = projected(np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 1.35]]))
    axes.annotate(
        "",
        (0, float(top[1])),
        xytext=(0, float(top[0])),
        arrowprops={"arrowstyle": "-|>", "color": INK, "lw": 0.9, "shrinkA": 0, "shrinkB": 0},
    )
    axes.annotate(
        r"$\mathbf{\hat{z}}$", (0, float(top[1])), xytext=(4, -6), textcoords="offset points"
    )
    axes.set_ylim(-1.05, 1.25)
    if title:
        axes.set_title(title, fontsize=10)
    axes.set_aspect("equal")
    axes.set_axis_off()


def paths() -> list[tuple[str, Floats]]:
    """The three ways in which a top that nutates goes round: e₃ (N, 3) from computed motions.

    All three start at θ = 60° with θ̇ = 0 and ω₃ = 40 rad/s; they differ in φ̇ at the start.
    """
    made = []
    for name, rate in (("waves", 1.2), ("cusps", 0.0), ("loops", -2.5)):
        motion = EXAMPLE.motion(theta=np.pi / 3, phi=-1.25, phi_dot=rate, omega3=40.0)
        made.append((name, motion.integrate(np.linspace(0.0, 1.75, 1500)).e3))
    return made


# --- Cones ----------------------------------------------------------------------------------------


def draw_cones(axes: Axes, lambda1: float, lambda3: float, tilt: float, *, space: bool) -> None:
    """The cones of a free symmetric body; `tilt` is the angle (rad) between ω and e₃.

    In the body frame ω and L go round e₃; in the space frame ω and e₃ go round L.
    """
    momentum = np.arctan(lambda1 / lambda3 * np.tan(tilt))
    angles = {"e": 0.0, "w": tilt, "L": momentum}
    axis = momentum if space else 0.0
    lengths = {"e": 1.0, "w": 1.05, "L": 1.15}
    names = {"e": r"$\mathbf{e}_3$", "w": r"$\boldsymbol{\omega}$", "L": r"$\mathbf{L}$"}
    styles = {"e": (SECOND, "-"), "w": (FIRST, "-"), "L": (INK, "-")}
    around = np.linspace(0, 2 * np.pi, 241)
    for key, angle in angles.items():
        lean = angle - axis
        color, line = styles[key]
        length = lengths[key]
        tip = length * np.array([0.0, -np.sin(lean), np.cos(lean)])
        if abs(lean) > 1e-9:
            circle = length * np.column_stack(
                [
                    np.sin(lean) * np.cos(around),
                    np.sin(lean) * np.sin(around),
                    np.full_like(around, np.cos(lean)),
                ]
            )
            across, up, near = projected(circle)
            front, back = near >= near.mean(), near < near.mean()
            axes.plot(
                np.where(front, across, np.nan), np.where(front, up, np.nan), color=color, lw=0.9
            )
            axes.plot(
                np.where(back, across, np.nan),
                np.where(back, up, np.nan),
                color=color,
                lw=0.7,
                ls=(0, (3, 2)),
            )
            edge = int(np.argmax(across)), int(np.argmin(across))
            axes.fill(
                np.append(across, [0.0]),
                np.append(up, [0.0]),
                color=color,
                alpha=0.05 if key != "w" else 0.12,
                lw=0,
            )
            for i in edge:
                axes.plot([0, across[i]], [0, up[i]], color=color, lw=0.5, alpha=0.6)
        (x,), (y,), _ = projected(tip[None, :])
        axes.annotate(
            "",
            (x, y),
            xytext=(0, 0),
            arrowprops={
                "arrowstyle": "-|>",
                "color": color,
                "lw": 1.6,
                "ls": line,
                "shrinkA": 0,
                "shrinkB": 0,
            },
        )
        side = -1 if x < -0.02 else 1
        axes.annotate(
            names[key],
            (x, y),
            xytext=(6 * side, 3),
            textcoords="offset points",
            ha="right" if side < 0 else "left",
            color=color,
            fontsize=11,
        )
    title = (
        r"space frame: the plane turns at $\Omega_s = L/\lambda_1$"
        if space
        else r"body frame: $\boldsymbol{\omega}$ goes round at $\Omega_b$"
    )
    axes.set_title(title, fontsize=10)
    axes.set_aspect("equal")
    axes.set_xlim(-0.95, 0.95)
    axes.set_ylim(-0.03, 1.22)
    axes.set_axis_off()


# --- The figures of the lecture -------------------------------------------------------------------


def _label(axes: Axes, x: float, y: float, words: str, color: str) -> None:
    axes.annotate(
        words,
        (x, y),
        xytext=(2, 0),
        textcoords="offset points",
        va="center",
        color=color,
        fontsize=11,
        annotation_clip=False,
    )


def _note(axes: Axes, x: float, y: float, words: str, shift: tuple[int, int], side: str) -> None:
    axes.annotate(words, (x, y), xytext=shift, textcoords="offset points", ha=side, color="#555555")


def _cones() -> Canvas:
    canvas = Canvas(figsize=(6.6, 2.9), layout="constrained")
    left, right = canvas.subplots(1, 2)
    draw_cones(left, 1.0, 0.55, 0.42, space=False)
    draw_cones(right, 1.0, 0.55, 0.42, space=True)
    return canvas


def _precession_rates() -> Canvas:
    canvas = Canvas(figsize=(5.6, 3.4), layout="constrained")
    draw_precession_rates(canvas.subplots(), EXAMPLE, np.pi / 3, 70.0)
    return canvas


def _effective_potential() -> Canvas:
    canvas = Canvas(figsize=(5.6, 3.2), layout="constrained")
    theta = np.pi / 3
    p_psi = EXAMPLE.lambda3 * 40.0
    p_phi = p_psi * np.cos(theta)  # φ̇ = 0 at the start
    energy = EXAMPLE.M * EXAMPLE.g * EXAMPLE.R * np.cos(theta)
    draw_effective_potential(canvas.subplots(), EXAMPLE, p_phi, p_psi, energy)
    return canvas


def _paths() -> Canvas:
    canvas = Canvas(figsize=(6.8, 2.6), layout="constrained")
    for axes, (name, e3) in zip(canvas.subplots(1, 3), paths(), strict=True):
        draw_path(axes, e3, name)
    return canvas


FIGURES: Sequence[tuple[str, Figure, Callable[[], Canvas]]] = (
    (
        "3.2.3",
        Figure(
            "cones",
            "The cones of a free symmetric body with λ₁ > λ₃. Left: in the body frame ω and L go "
            "round e₃ at Ω_b. Right: in the space frame L stands still, and the plane of the three "
            "turns about it at Ω_s.",
            "Two drawings of three arrows from one point, always in one plane. In the body frame "
            "the arrow e3 stands upright and the tips of omega and, farther out, of L go round it "
            "on circles. In the space frame L stands upright, omega and e3 go round it.",
        ),
        _cones,
    ),
    (
        "3.5.3",
        Figure(
            "precession-rates",
            "Both roots of (3.57) against ω₃ at θ = 60°, for λ₁ = 0.02 kg m², λ₃ = 0.01 kg m², "
            "MgR = 0.981 J. Dashed: what the notes give for large ω₃. Left of the dotted line no "
            "steady precession exists.",
            "Two curves that begin at a common point at the least spin, about 20 radians per "
            "second, where both rates are about 10. The fast rate rises to the straight line "
            "lambda3 omega3 over lambda1 cos theta, the slow rate falls to the hyperbola M g R "
            "over lambda3 omega3.",
        ),
        _precession_rates,
    ),
    (
        "3.5.4",
        Figure(
            "effective-potential",
            "The effective potential U, less the constant p_ψ²/(2λ₃), of a top that is let go at "
            "θ₁ = 60° with φ̇ = θ̇ = 0 and ω₃ = 40 rad/s. θ runs between the turning points θ₁ and "
            "θ₂; the square marks the steady precession with the same momenta.",
            "A valley-shaped curve of the effective potential against theta. A horizontal line at "
            "the energy E meets it at two turning points, 60 degrees and about 74 degrees; the "
            "lowest point lies between them.",
        ),
        _effective_potential,
    ),
    (
        "3.5.4",
        Figure(
            "paths",
            "The path of e₃ on the sphere, integrated from θ = 60°, θ̇ = 0, ω₃ = 40 rad/s with "
            "φ̇ = 1.2, 0 and −2.5 rad/s. The thin circles are the turning points of θ.",
            "Three spheres with the path of the figure axis between two circles of latitude: a "
            "wavy line, a line with cusps on the upper circle, and a line with loops on the upper "
            "circle.",
        ),
        _paths,
    ),
)
"""Section, description and drawing of each figure of the lecture."""


def rendered(draw: Callable[[], Canvas], kind: str) -> bytes:
    """The bytes of a figure as "svg", "pdf" or "png"; the same each time."""
    with matplotlib.rc_context(STYLE):
        canvas = draw()
        buffer = BytesIO()
        metadata: dict[str, Any] = {
            "svg": {},  # goes below
            "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
            "png": {"Software": None},
        }[kind]
        canvas.savefig(buffer, format=kind, metadata=metadata, dpi=200, transparent=kind == "svg")
    made = buffer.getvalue()
    if kind == "svg":
        return re.sub(rb"\s*<metadata>.*?</metadata>", b"", made, flags=re.DOTALL)
    return made
