"""What friction and air do to a top on a table: the one raises it, the other wakes it."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas

from rigidtop.derivations.exercises.friction import (
    ABOUT_CENTRE,
    HELD,
    about_tip,
    crossing,
    rising,
    rising_top,
    time_asleep,
    time_to_grow,
    waking_top,
)
from rigidtop.errors import RigidtopError
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.style import Floats, canvas, degrees, legend_above, name_at, said, spoken
from rigidtop.motion.table.motion import SlidingMotion, SlidingTop
from rigidtop.motion.table.trajectory import SlidingTrajectory

MOST_TURNS = 1000
"""About e₃; a motion is followed no longer."""

SAMPLES = 1601


def _top_in_words(top: SlidingTop) -> str:
    return (
        f"$λ₁ = {said(top.lambda1)}$ and $λ₃ = {said(top.lambda3)}$ kg m² about the centre of "
        f"mass, $Mg = {said(top.M * top.g)}$ N and $R = {said(top.R)}$ m"
    )


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
    motion: SlidingMotion = rising(**values)
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
    return motion.integrate(
        np.linspace(0.0, min([shown, *_end_of(found)]), SAMPLES), rtol=1e-9, atol=1e-11
    )


def _end_of(path: SlidingTrajectory) -> list[float]:
    return [path.ended.time] if path.ended else []


def draw_tilt(axes: Axes, path: SlidingTrajectory, until: float) -> None:
    """θ(t) (degrees), and when it has come down to `until` (rad)."""
    axes.plot(path.t, np.degrees(path.theta), color=look.FIRST, label="_theta")
    then = crossing(path, until)
    if then is not None:
        axes.plot(then, math.degrees(until), "o", color=look.SECOND, ms=4, label="_until")
        name_at(axes, then, math.degrees(until), f"{then:.3g} s", (5, 3), color=look.INK)
    axes.set(ylim=(0, None), ylabel=r"$\theta$  (degrees)")


def parts(path: SlidingTrajectory) -> dict[str, Floats]:
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
    made: Floats = path.motion.body.lambda3 * (squares[0] - squares) / 2
    return made


FILLS = {"heat": look.SECOND, "weight": look.FIRST, "other motion": look.THIRD}


def draw_budget(axes: Axes, path: SlidingTrajectory) -> None:
    """Where the energy of the spin has gone (mJ): three shares, one on the other; dashed, the loss.

    That the shares reach up to the dashed line is the conservation of energy.
    """
    below = np.zeros(len(path.t))
    for name, gain in parts(path).items():
        above = below + 1e3 * gain
        axes.fill_between(path.t, below, above, fc=FILLS[name], ec="white", lw=0.3, label=name)
        below = above
    axes.plot(
        path.t, 1e3 * spent(path), color=look.INK, lw=1.1, ls=look.DASHED, label="lost by the spin"
    )
    axes.set(
        ylim=(min(0.0, axes.get_ylim()[0]) if below.min() < 0 else 0.0, None), ylabel="energy  (mJ)"
    )


def draw_slip(axes: Axes, path: SlidingTrajectory) -> None:
    """|v(t)| of the contact over the table (m/s)."""
    axes.plot(path.t, np.hypot(*path.slip.T), color=look.FIRST, label="_slip")
    axes.set(ylim=(0, None), ylabel="slip  (m/s)")


def draw_track(axes: Axes, path: SlidingTrajectory) -> None:
    """The way of the contact on the table (cm), from above: dashed after its first standstill."""
    x, y = 1e2 * path.contact[:, :2].T
    rest = stands(path)
    first = len(x) if rest is None else int(np.searchsorted(path.t, rest))
    for piece, words, color, style in (
        (slice(0, first + 1), "slides", look.FIRST, "-"),
        (
            slice(first, None),
            "rolls, slips" if slips_again(path) else "rolls",
            look.SECOND,
            look.DASHED,
        ),
    ):
        count = len(x[piece])
        if count > 1:
            axes.plot(x[piece], y[piece], color=color, ls=style, label=f"_{words}")
        if count > 0.05 * len(x):
            k = count // 2
            along = np.array([x[piece][k + 1] - x[piece][k - 1], y[piece][k + 1] - y[piece][k - 1]])
            beside = 6 * np.array([along[1], -along[0]]) / np.hypot(*along)
            # Inside the bend there is room.
            beside *= math.copysign(1, beside @ [x.mean() - x[piece][k], y.mean() - y[piece][k]])
            name_at(
                axes,
                float(x[piece][k]),
                float(y[piece][k]),
                words,
                (float(beside[0]), float(beside[1])),
                ha="left" if beside[0] > 0 else "right",
                va="bottom" if beside[1] > 0 else "top",
                color=color,
            )
    axes.plot(x[0], y[0], "o", color=look.INK, ms=3.5)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set(xlabel="$x$  (cm)", ylabel="$y$  (cm)")


def _draw_rising(until: float, **values: float) -> Canvas:
    path = _risen(until, **values)
    drawn = canvas(look.TEXT, 2.6)
    (tilt, energy), (slip, track) = drawn.subplots(2, 2)
    draw_tilt(tilt, path, until)
    draw_budget(energy, path)
    draw_slip(slip, path)
    draw_track(track, path)
    rest = stands(path)
    for axes in (tilt, energy, slip):
        axes.set(xlim=(0, path.t[-1]), xlabel="$t$  (s)")
        if rest is not None:
            axes.axvline(rest, color=look.INK, lw=0.8, ls=look.DOTTED, label="_standstill")
    if rest is not None:
        name_at(slip, rest, slip.get_ylim()[1], "slip ends", (4, -2), va="top", color=look.INK)
    room = {"handlelength": 1.6, "handletextpad": 0.4, "columnspacing": 1.0}
    legend_above(energy, ncols=4, fontsize=look.SMALL, **room)
    return drawn


def _rising_caption(until: float, **values: float) -> str:
    path = _risen(until, **values)
    top, then = path.motion.body, crossing(path, until)
    reached = (
        f"is down to {degrees(until)} after {said(then)} s"
        if then is not None
        else f"comes down to {degrees(float(path.theta.min()))}"
    )
    lost = float(spent(path)[-1])
    heat, weight, other = (said(100 * float(gain[-1]) / lost) for gain in parts(path).values())
    dashed = ", dashed once it rolls" if stands(path) is not None else ""
    return (
        f"A top with {_top_in_words(top)}, a round tip of radius {said(top.tip)} m and the "
        f"friction $μ = {said(top.mu)}$, from $θ = {degrees(values['theta'])}$, $θ̇ = 0$, "
        f"$φ̇ = {said(float(path.phi_dot[0]))}$ rad/s (steady if nothing rubs) and "
        f"$ω₃ = {said(values['omega3'])}$ rad/s: $θ$ {reached}. {_contact_in_words(path)} Of the "
        f"{said(1e3 * lost)} mJ that the spin has lost in the end (dashed), {heat} % went into "
        f"heat, {weight} % into lifting the weight and {other} % into other motion. Below on the "
        f"right: the path of the contact on the table, seen from above{dashed}."
    )


def _contact_in_words(path: SlidingTrajectory) -> str:
    rest, end = stands(path), said(float(path.t[-1]))
    if rest is not None:
        later = "then rolls, but slips again and again" if slips_again(path) else "then rolls"
        told = f"until {said(rest)} s (dotted), {later}"
    else:
        told = f"all the {end} s that are shown"
    ending = f" Then it ends with a {path.ended.kind}." if path.ended else ""
    return f"It slips, at first at {said(float(np.hypot(*path.slip[0])))} m/s, {told}.{ending}"


def _rising_in_words(until: float, **values: float) -> str:
    path = _risen(until, **values)
    rest = stands(path)
    ends = f"zero at {spoken(rest)} seconds" if rest is not None else "no standstill"
    return (
        f"Theta against time goes from {spoken(math.degrees(values['theta']))} degrees down to "
        f"{spoken(math.degrees(float(path.theta.min())))}, while the slip of the contact goes to "
        f"{ends}. Three bands, heat, weight and other motion, add up to the energy that the spin "
        f"has lost, {spoken(1e3 * float(spent(path)[-1]))} millijoules in the end, of which heat "
        "is the most. Beside it the path of the contact on the table."
    )


RISING = Drawing(
    "rising-top",
    "Friction raises a fast top: $θ$, energy, slip and path",
    "3.5.4",
    rising_top.parameters,
    _draw_rising,
    _rising_caption,
    _rising_in_words,
    asked={"mu": 0.15, "theta": 0.6, "until": 0.35, "omega3": 230.0},
)


# --- A top that wakes ----------------------------------------------------------------------------


@lru_cache(maxsize=8)
def _woken(
    omega3: float, drag3: float, disturbance: float, visible: float, **body: float
) -> SlidingTrajectory:
    """The motion from its disturbance to its fall, or to somewhat after it was seen to wake."""
    asleep = time_asleep(omega3, drag3, **body)
    growing = time_to_grow(math.log(visible / disturbance), drag3, **body)
    last = asleep + 1.5 * growing
    turns = last * omega3 / (2 * math.pi)
    if turns > MOST_TURNS:
        raise RigidtopError(
            f"about {turns:.0f} turns until the top wakes, at most {MOST_TURNS} are drawn: give a "
            "larger drag3 or a smaller omega3"
        )
    pivot = about_tip(**body)
    motion = SlidingTop(**body, mu=HELD, drag3=drag3).motion(
        theta=disturbance,
        phi_dot=pivot.lambda3 * omega3 / (2 * pivot.lambda1),
        omega3=omega3,
        slip=(0.0, 0.0),
    )
    # The tilt is known relative to what it was at first.
    times = np.linspace(0.0, last, SAMPLES)  # later ones than its fall are left out
    return motion.integrate(times, rtol=1e-9, atol=1e-6 * disturbance)


def draw_waking(
    tilt: Axes, spin: Axes, path: SlidingTrajectory, visible: float, sleeping: float
) -> None:
    """θ(t) (degrees, logarithmic) and ω₃(t) (rad/s).

    Dotted: where ω₃ is `sleeping` (rad/s), and where θ is `visible` (rad) for the first time.
    """
    tilt.plot(path.t, np.degrees(path.theta), color=look.FIRST, label="_theta")
    tilt.set(yscale="log", ylabel=r"$\theta$  (degrees)")
    spin.plot(path.t, path.omega[:, 2], color=look.FIRST, label="_omega3")
    spin.set(ylabel=r"$\omega_3$  (rad/s)", xlabel="$t$  (s)")
    seen = crossing(path, visible)
    asleep = float(np.interp(-sleeping, -path.omega[:, 2], path.t))
    for axes in (tilt, spin):
        axes.set_xlim(0, path.t[-1])
        axes.axvline(asleep, color=look.GREY, lw=0.9, ls=look.DOTTED, label="_asleep")
        if seen is not None:
            axes.axvline(seen, color=look.GREY, lw=0.9, ls=look.DOTTED, label="_seen")
    spin.axhline(sleeping, color=look.GREY, lw=0.9, ls=look.DOTTED, label="_sleeping")
    low, high = spin.get_ylim()
    spin.set_ylim(low, max(high, sleeping + 0.3 * (high - low)))
    # Beside the curve, which is above this line at first and below it in the end.
    early = asleep < path.t[-1] / 2
    name_at(
        spin,
        (asleep + path.t[-1]) / 2 if early else asleep / 2,
        sleeping,
        r"$\frac{2}{\lambda_3}\sqrt{(\lambda_1+MR^2)MgR}$",
        (0, 4 if early else -4),
        ha="center",
        va="bottom" if early else "top",
    )
    start = path.t[0], math.degrees(path.theta[0])
    tilt.plot(*start, "o", color=look.INK, ms=3.5, clip_on=False, zorder=4)
    if seen is not None:
        tilt.plot(seen, math.degrees(visible), "o", color=look.SECOND, ms=4, label="_visible")
        name_at(
            tilt, seen, math.degrees(visible), f"{seen:.3g} s", (-5, 2), ha="right", color=look.INK
        )


def _draw_waking(**values: float) -> Canvas:
    path = _woken(**values)
    drawn = canvas(look.COLUMN, 2.8)
    panels = drawn.subplots(2, 1, sharex=True)
    sleeping = about_tip(**{p.name: values[p.name] for p in ABOUT_CENTRE}).sleeping_spin()
    draw_waking(panels[0], panels[1], path, values["visible"], sleeping)
    drawn.align_ylabels(panels)
    return drawn


def _waking_facts(**values: float) -> tuple[SlidingTrajectory, float, float, float | None]:
    """The motion, the sleeping spin (rad/s), when ω₃ is down to it and when the top wakes (s)."""
    path = _woken(**values)
    body = {p.name: values[p.name] for p in ABOUT_CENTRE}
    asleep = time_asleep(values["omega3"], values["drag3"], **body)
    return path, about_tip(**body).sleeping_spin(), asleep, crossing(path, values["visible"])


def _waking_caption(**values: float) -> str:
    path, sleeping, asleep, seen = _waking_facts(**values)
    wakes = (
        f"a tilt of {degrees(values['visible'])} is only seen after {said(seen)} s, at "
        f"$ω₃ = {said(float(np.interp(seen, path.t, path.omega[:, 2])))}$ rad/s"
        if seen is not None
        else f"a tilt of {degrees(values['visible'])} is not seen in the time that is shown"
    )
    end = f" It lies after {said(path.ended.time)} s." if path.ended else ""
    return (
        f"A top with {_top_in_words(path.motion.body)} sleeps on a sharp tip that friction holds, "
        f"from $ω₃ = {said(values['omega3'])}$ rad/s, $θ = {degrees(values['disturbance'])}$, $θ̇ "
        f"= 0$ and $φ̇ = {said(float(path.phi_dot[0]))}$ rad/s, which is $λ₃ω₃/2$ over $λ₁ + MR²$. "
        f"The torque of the air, $c₃ = {said(values['drag3'])}$ J s times $ω₃$, brings it down to "
        f"the sleeping spin, {said(sleeping)} rad/s, after {said(asleep)} s; {wakes} (dotted).{end}"
    )


def _waking_in_words(**values: float) -> str:
    _, sleeping, asleep, seen = _waking_facts(**values)
    wakes = f"at {spoken(seen)} seconds" if seen is not None else "not in the time shown"
    return (
        "Theta on a logarithmic scale and omega 3, both against time. The spin decays and goes "
        f"through the sleeping spin, {spoken(sleeping)} radians per second, at {spoken(asleep)} "
        "seconds. Theta stays small until then; after that it grows, ever faster, and reaches "
        f"{spoken(math.degrees(values['visible']))} degrees {wakes}."
    )


WAKING = Drawing(
    "waking-top",
    "The air wakes a sleeping top: $θ(t)$ and $ω₃(t)$",
    "",
    waking_top.parameters,
    _draw_waking,
    _waking_caption,
    _waking_in_words,
)
