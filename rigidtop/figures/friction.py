"""What friction and air do to a top on a table: the one raises it, the other wakes it."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises import friction as exercise
from rigidtop.errors import RigidtopError
from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.style import Floats
from rigidtop.motion.table.motion import SlidingMotion, SlidingTop
from rigidtop.motion.table.trajectory import SlidingTrajectory

MOST_TURNS = 1000
"""About e₃; a motion is followed no longer."""

SAMPLES = 1601


def _facts_of(path: SlidingTrajectory, **more: Any) -> dict[str, Any]:
    """What both captions say of a top, in {top}, of how it starts and ends, and `more`."""
    top = path.motion.body
    return {
        "Mg": top.M * top.g,
        "top": r"$\lambda_1 = {lambda1}$ and $\lambda_3 = {lambda3}$ kg m² about the centre of "
        "mass, $Mg = {Mg}$ N and $R = {R}$ m",
        "phi_dot": float(path.phi_dot[0]),
        "end": path.ended.time if path.ended else float(path.t[-1]),
        **more,
    }


def stands(path: SlidingTrajectory) -> float | None:
    """The time of the first standstill of the contact (s), if there is one."""
    return next((event.time for event in path.events if event.kind == "standstill"), None)


def slips_again(path: SlidingTrajectory) -> bool:
    """Whether the contact slips after it stood still."""
    kinds = [event.kind for event in path.events]
    return "standstill" in kinds and "slip" in kinds[kinds.index("standstill") :]


# --- A top that rises ----------------------------------------------------------------------------


@lru_cache(maxsize=8)
def _risen(until: float, **values: float) -> SlidingTrajectory:
    """The motion from its start to somewhat after the standstill of its contact."""
    if until >= values["theta"]:
        raise RigidtopError(
            f"until = {until:g} must be less than theta = {values['theta']:g}: the top rises"
        )
    motion: SlidingMotion = exercise.rising(**values)
    top, spin = motion.body, values["omega3"]
    # The weight's friction turns L, of about λ₃ω₃, upright; the slip ends about then.
    upright = values["theta"] * top.lambda3 * spin / (top.mu * top.M * top.g * top.R)
    longest = MOST_TURNS * 2 * math.pi / spin
    for last in (min(upright, longest), min(3 * upright, longest)):
        found = motion.integrate([0.0, last], rtol=1e-9, atol=1e-11)
        rest = stands(found)
        if rest is not None or found.ended:
            break
    # Where it sticks and slips by turns there is no more to see, and each turn takes its time.
    shown = last if rest is None or slips_again(found) else 1.5 * rest
    end = min(shown, found.ended.time) if found.ended else shown
    return motion.integrate(np.linspace(0.0, end, SAMPLES), rtol=1e-9, atol=1e-11)


def tilt_in_time(
    path: SlidingTrajectory, tilt: float, label: str, shift: pen.Shift
) -> list[pen.Part]:
    """θ(t) (degrees), and when it comes to a tilt (rad), with the number beside it."""
    theta = pen.Curve((path.t, np.degrees(path.theta)), look.FIRST, 1.3, label="_theta")
    then = exercise.crossing(path, tilt)
    if then is None:
        return [theta]
    words, ha = f"{then:.3g} s", "left" if shift[0] > 0 else "right"
    name: Any = {"words": words, "shift": shift, "ha": ha, "ink": look.INK}
    return [theta, pen.Markers((then, math.degrees(tilt)), look.SECOND, 4, label=label, **name)]


def gains(path: SlidingTrajectory) -> dict[str, Floats]:
    """Gains since t = 0 (J): heat of friction, weight, motion other than ½λ₃ω₃²."""
    body = path.motion.body
    weight = body.M * body.g * path.position[:, 2]
    other = path.energy - weight - body.lambda3 * path.omega[:, 2] ** 2 / 2
    return {
        "heat": path.dissipated_by_friction,
        "weight": weight - weight[0],
        "other motion": other - other[0],
    }


def spent(path: SlidingTrajectory) -> Floats:
    """What ½λ₃ω₃² has lost since t = 0 (J)."""
    squares = path.omega[:, 2] ** 2
    return np.asarray(path.motion.body.lambda3 * (squares[0] - squares) / 2)


FILLS = {"heat": look.SECOND, "weight": look.FIRST, "other motion": look.THIRD}


def draw_budget(axes: Axes, path: SlidingTrajectory) -> None:
    """Where the energy of the spin has gone (mJ): three shares, one on the other; dashed, the loss.

    That the shares reach up to the dashed line is the conservation of energy.
    """
    below = np.zeros(len(path.t))
    bands: list[pen.Part] = []
    for name, gain in gains(path).items():
        above = below + 1e3 * gain
        bands.append(pen.Band(path.t, below, above, FILLS[name], 1.0, name))
        below = above
    lost, label = 1e3 * spent(path), "lost by the spin"
    loss = pen.Curve((path.t, lost), look.INK, 1.1, look.DASHED, label=label)
    pen.chart(axes, [*bands, loss], "$t$  (s)", "energy  (mJ)")
    low = min(0.0, axes.get_ylim()[0]) if below.min() < 0 else 0.0
    axes.set(ylim=(low, None))


def draw_track(axes: Axes, path: SlidingTrajectory) -> None:
    """The way of the contact on the table (cm), from above: dashed after its first standstill."""
    track = 1e2 * path.contact[:, :2]
    rest = stands(path)
    first = len(track) if rest is None else int(np.searchsorted(path.t, rest))
    later = "rolls, slips" if slips_again(path) else "rolls"
    parts: list[pen.Part] = [pen.Markers(track[0])]
    for piece, words, color, style in (
        (track[: first + 1], "slides", look.FIRST, "-"),
        (track[first:], later, look.SECOND, look.DASHED),
    ):
        if len(piece) > 1:
            parts.append(pen.Curve(piece, color, 1.3, style, label=f"_{words}"))
        if len(piece) > 0.05 * len(track):
            k = len(piece) // 2
            along = piece[k + 1] - piece[k - 1]
            beside = 6 * np.array([along[1], -along[0]]) / np.hypot(*along)
            # Inside the bend there is room.
            right, up = beside * math.copysign(1, beside @ (track.mean(axis=0) - piece[k]))
            sides = "left" if right > 0 else "right", "bottom" if up > 0 else "top"
            parts.append(pen.Words(piece[k], words, (right, up), color, *sides))
    pen.chart(axes, parts, "$x$  (cm)", "$y$  (cm)")
    axes.set_aspect("equal", adjustable="datalim")


def _draw_rising(
    tilt: Axes, energy: Axes, slip: Axes, track: Axes, until: float, **values: float
) -> None:
    path = _risen(until, **values)
    theta = tilt_in_time(path, until, "_until", (5, 3))
    pen.chart(tilt, theta, "$t$  (s)", r"$\theta$  (degrees)", ylim=(0, None))
    draw_budget(energy, path)
    speed = pen.Curve((path.t, np.hypot(*path.slip.T)), look.FIRST, 1.3, label="_slip")
    pen.chart(slip, [speed], "$t$  (s)", "slip  (m/s)", ylim=(0, None))
    draw_track(track, path)
    rest = stands(path)
    for axes in (tilt, energy, slip):
        axes.set(xlim=(0, path.t[-1]))
        if rest is not None:
            pen.draw(axes, [pen.Rule(x=rest, color=look.INK, lw=0.8, label="_standstill")])
    if rest is not None:
        pen.draw(slip, [pen.Words((rest, slip.get_ylim()[1]), "slip ends", (4, -2), va="top")])
    room = {"handlelength": 1.6, "handletextpad": 0.4, "columnspacing": 1.0}
    pen.legend_above(energy, ncols=4, fontsize=look.SMALL, **room)


def _rising_facts(until: float, **values: float) -> dict[str, Any]:
    path = _risen(until, **values)
    rest, then, end = stands(path), exercise.crossing(path, until), path.ended
    lost = float(spent(path)[-1])
    shares = {name: float(gain[-1]) / lost for name, gain in gains(path).items()}
    slips = "all the {shown} s that are shown"
    if rest is not None:
        later = ", but slips again and again" if slips_again(path) else ""
        slips = f"until {{rest}} s (dotted), then rolls{later}"
    reached = "is down to {until:°} after {then} s"
    return _facts_of(
        path,
        then=then,
        lowest=float(path.theta.min()),
        reached="comes down to {lowest:°}" if then is None else reached,
        slip=float(np.hypot(*path.slip[0])),
        slips=slips,
        shown=float(path.t[-1]),
        ending=f" Then it ends with a {end.kind}." if end else "",
        rest=rest,
        standstill="zero at {rest} seconds" if rest is not None else "no standstill",
        dashed=", dashed once it rolls" if rest is not None else "",
        lost=1e3 * lost,
        heat=shares["heat"],
        weight=shares["weight"],
        other=shares["other motion"],
    )


RISING = Drawing(
    "rising-top",
    r"Friction raises a fast top: $\theta$, energy, slip and path",
    "3.5.4",
    exercise.rising_top.parameters,
    pen.panels(look.TEXT, 2.6, _draw_rising, 2, 2),
    r"A top with {top}, a round tip of radius {tip} m and the friction $\mu = {mu}$, from "
    r"$\theta = {theta:°}$, $\dot\theta = 0$, $\dot\phi = {phi_dot}$ rad/s (steady if nothing "
    r"rubs) and $\omega_3 = {omega3}$ rad/s: $\theta$ {reached}. It slips, at first at {slip} m/s, "
    "{slips}.{ending} Of the {lost} mJ that the spin has lost in the end (dashed), {heat:%} % went "
    "into heat, {weight:%} % into lifting the weight and {other:%} % into other motion. Below on "
    "the right: the path of the contact on the table, seen from above{dashed}.",
    "Theta against time goes from {theta:°} degrees down to {lowest:°}, while the slip of the "
    "contact goes to {standstill}. Three bands, heat, weight and other motion, add up to the "
    "energy that the spin has lost, {lost} millijoules in the end, of which heat is the most. "
    "Beside it the path of the contact on the table.",
    _rising_facts,
    asked={"mu": 0.15, "theta": 0.6, "until": 0.35, "omega3": 230.0},
)


# --- A top that wakes ----------------------------------------------------------------------------


@lru_cache(maxsize=8)
def _woken(
    omega3: float, drag3: float, disturbance: float, visible: float, **body: float
) -> SlidingTrajectory:
    """The motion from its disturbance to its fall, or to somewhat after it was seen to wake."""
    asleep = exercise.time_asleep(omega3, drag3, **body)
    growing = exercise.time_to_grow(math.log(visible / disturbance), drag3, **body)
    last = asleep + 1.5 * growing
    turns = last * omega3 / (2 * math.pi)
    if turns > MOST_TURNS:
        raise RigidtopError(
            f"about {turns:.0f} turns until the top wakes, at most {MOST_TURNS} are drawn: give a "
            "larger drag3 or a smaller omega3"
        )
    pivot = exercise.about_tip(**body)
    start = {"theta": disturbance, "phi_dot": pivot.lambda3 * omega3 / (2 * pivot.lambda1)}
    top = SlidingTop(**body, mu=exercise.HELD, drag3=drag3)
    motion = top.motion(**start, omega3=omega3, slip=(0.0, 0.0))
    # The tilt is known relative to what it was at first.
    times = np.linspace(0.0, last, SAMPLES)  # later ones than its fall are left out
    return motion.integrate(times, rtol=1e-9, atol=1e-6 * disturbance)


def draw_waking(
    tilt: Axes, spin: Axes, path: SlidingTrajectory, visible: float, sleeping: float
) -> None:
    """θ(t) (degrees, logarithmic) and ω₃(t) (rad/s).

    Dotted: where ω₃ is `sleeping` (rad/s), and where θ is `visible` (rad) for the first time.
    """
    seen = exercise.crossing(path, visible)
    asleep = float(np.interp(-sleeping, -path.omega[:, 2], path.t))
    upright: list[pen.Part] = [pen.Rule(x=asleep, label="_asleep")]
    if seen is not None:
        upright.append(pen.Rule(x=seen, label="_seen"))
    limits = {"xlim": (0, path.t[-1])}
    theta = tilt_in_time(path, visible, "_visible", (-5, 2))
    parts = [*theta, pen.Markers((path.t[0], math.degrees(path.theta[0]))), *upright]
    pen.chart(tilt, parts, "", r"$\theta$  (degrees)", yscale="log", **limits)
    omega3 = pen.Curve((path.t, path.omega[:, 2]), look.FIRST, 1.3, label="_omega3")
    # Beside the curve, which is above this line at first and below it in the end.
    early = asleep < path.t[-1] / 2
    middle = (asleep + path.t[-1]) / 2 if early else asleep / 2
    shift, side = ((0, 4), "bottom") if early else ((0, -4), "top")
    formula = r"$\frac{2}{\lambda_3}\sqrt{(\lambda_1+MR^2)MgR}$"
    words = pen.Words((middle, sleeping), formula, shift, look.NOTE, "center", side)
    parts = [omega3, *upright, pen.Rule(y=sleeping, label="_sleeping"), words]
    pen.chart(spin, parts, "$t$  (s)", r"$\omega_3$  (rad/s)", **limits)
    low, high = spin.get_ylim()
    spin.set_ylim(low, max(high, sleeping + 0.3 * (high - low)))


def _draw_waking(tilt: Axes, spin: Axes, **values: float) -> None:
    body = {p.name: values[p.name] for p in exercise.ABOUT_CENTRE}
    sleeping = exercise.about_tip(**body).sleeping_spin()
    draw_waking(tilt, spin, _woken(**values), values["visible"], sleeping)


def _waking_facts(**values: float) -> dict[str, Any]:
    path = _woken(**values)
    body = {p.name: values[p.name] for p in exercise.ABOUT_CENTRE}
    seen = exercise.crossing(path, values["visible"])
    wakes = "a tilt of {visible:°} is not seen in the time that is shown"
    if seen is not None:
        wakes = r"a tilt of {visible:°} is only seen after {seen} s, at $\omega_3 = {then}$ rad/s"
    return _facts_of(
        path,
        sleeping=exercise.about_tip(**body).sleeping_spin(),
        asleep=exercise.time_asleep(values["omega3"], values["drag3"], **body),
        seen=seen,
        then=None if seen is None else float(np.interp(seen, path.t, path.omega[:, 2])),
        wakes=wakes,
        reaches="at {seen} seconds" if seen is not None else "not in the time shown",
        lies=" It lies after {end} s." if path.ended else "",
    )


WAKING = Drawing(
    "waking-top",
    r"The air wakes a sleeping top: $\theta(t)$ and $\omega_3(t)$",
    "",
    exercise.waking_top.parameters,
    pen.panels(look.COLUMN, 2.8, _draw_waking, 2, sharex=True),
    r"A top with {top} sleeps on a sharp tip that friction holds, from $\omega_3 = {omega3}$ "
    r"rad/s, $\theta = {disturbance:°}$, $\dot\theta = 0$ and $\dot\phi = {phi_dot}$ rad/s, which "
    r"is $\lambda_3\omega_3/2$ over $\lambda_1 + MR^2$. The torque of the air, $c_3 = {drag3}$ J s "
    r"times $\omega_3$, brings it down to the sleeping spin, {sleeping} rad/s, after {asleep} s; "
    "{wakes} (dotted).{lies}",
    "Theta on a logarithmic scale and omega 3, both against time. The spin decays and goes through "
    "the sleeping spin, {sleeping} radians per second, at {asleep} seconds. Theta stays small "
    "until then; after that it grows, ever faster, and reaches {visible:°} degrees {reaches}.",
    _waking_facts,
)
