"""Guided tours: each step asks what will happen, and then shows it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import degrees, hypot, radians, sqrt

from rigidtop.motion.body import FreeBody
from rigidtop.web.presets import SPIN, TILT, TOP
from rigidtop.web.setup import FREE, HEAVY


@dataclass(frozen=True)
class TourQuestion:
    """A question on a motion, what may be answered, and what is to be seen.

    `show` is an address of the page; the first of `choices` that is right is number `answer`.
    """

    show: str
    ask: str
    choices: tuple[str, ...]
    answer: int
    told: str


NUTATIONS = ("waves", "cusps", "loops")


def heavy_tour() -> tuple[TourQuestion, ...]:
    """The questions of the tour on the heavy top."""
    twice = TOP.steady_precession(TILT, 2 * SPIN)[0]
    slow, fast = TOP.steady_precession(TILT, SPIN)
    least = TOP.smallest_spin(TILT)
    sleeping = TOP.sleeping_spin()
    awake = TOP.motion(theta=radians(1), omega3=0.9 * sleeping)
    lowest = degrees(awake.turning_points[1])
    return (
        TourQuestion(
            "preset=cusps",
            "The top spins about its axis, which is held at 30°. Which way will it move first when "
            "it is let go?",
            ("it falls", "it goes sideways", "it rises"),
            0,
            "It falls, as anything does. Only then, as it moves, does the spin turn it aside: the "
            "gyroscopic term of (3.54) is proportional to φ̇, which begins at 0.",
        ),
        TourQuestion(
            "preset=cusps",
            "Let go again, and look at the path of e₃: waves, cusps or loops?",
            NUTATIONS,
            1,
            "Cusps: p_φ and p_ψ are conserved, so that φ̇ is 0 again whenever θ is back at 30°, "
            "where θ̇ is 0 as well.",
        ),
        TourQuestion(
            "preset=waves",
            "Now it is pushed a little in the direction of its precession. Waves, cusps or loops?",
            NUTATIONS,
            0,
            "Waves: φ̇ is smallest at the upper circle, and it is not 0 there any more.",
        ),
        TourQuestion(
            "preset=loops",
            "And pushed against its precession?",
            NUTATIONS,
            2,
            "Loops: at the upper circle it goes backwards, at the lower one forwards.",
        ),
        TourQuestion(
            "preset=slow",
            f"Pushed with {slow:.3g} rad/s, twice as much as for the waves. What will θ do?",
            ("swing more", "swing less", "stay"),
            2,
            "It stays: this is Ω₋, a root of (3.57), at which the torque of gravity is what turns "
            "L about the vertical.",
        ),
        TourQuestion(
            f"preset=slow&omega3={2 * SPIN}&phi_dot={twice!r}",
            "It spins twice as fast. How fast is its steady precession now?",
            ("twice as fast", "as fast as before", "half as fast"),
            2,
            f"About half as fast, {twice:.3g} rad/s: for fast spin Ω₋ tends to MgR/(λ₃ω₃). The "
            "same torque has more angular momentum to turn.",
        ),
        TourQuestion(
            "preset=fast&ghost=other",
            "Is there another push with which θ stays at 30°, at the spin of before?",
            ("no", "yes, a slower one", "yes, a faster one"),
            2,
            f"Yes: (3.57) is quadratic, and its other root is Ω₊ = {fast:.3g} rad/s. Beside it "
            "goes the slow one.",
        ),
        TourQuestion(
            "preset=waves&omega3=6",
            "It spins at 6 rad/s. Is there a push with which θ stays at 30°?",
            ("always", "not any more"),
            1,
            f"Not any more: below |ω₃| = {least:.4g} rad/s the roots of (3.57) are complex. It "
            "falls, and comes back.",
        ),
        TourQuestion(
            "preset=sleeping",
            "Nearly upright, and faster than 2√(λ₁MgR)/λ₃. It is pushed by a degree: what now?",
            ("it stays near the vertical", "it falls, and comes back", "it lies down"),
            0,
            "It sleeps: upright, the effective potential has a minimum.",
        ),
        TourQuestion(
            "preset=waking",
            "The same push, a little slower than 2√(λ₁MgR)/λ₃?",
            ("it stays near the vertical", "it falls, and comes back", "it lies down"),
            1,
            f"It wakes up, falls to {lowest:.3g}°, and comes back: nothing takes energy from it. "
            "Friction does that to a top on a table.",
        ),
    )


def free_tour() -> tuple[TourQuestion, ...]:
    """The questions of the tour on the free body."""
    body = FreeBody(1.0, 1.7, 2.3)
    period = body.motion(omega=(0.02, 4.0, 0.02)).nutation_period
    nearer = body.motion(omega=(0.002, 4.0, 0.002)).nutation_period
    # On the separatrix L² = 2Tλ₂ whatever ω₂ is.
    first, third = sqrt((2.3 - 1.7) * 2.3), sqrt((1.7 - 1.0) * 1.0)
    scale = 0.4 / hypot(first, third)
    on = f"omega1={scale * first!r}&omega2=-3.5&omega3={scale * third!r}"
    return (
        TourQuestion(
            "preset=free-precession",
            "No torque acts on the brick. Which of these stays where it is, seen from space?",
            ("ω", "L", "e₃"),
            1,
            "L: without a torque it is conserved. ω and e₃ turn about it together, in one plane "
            "with it.",
        ),
        TourQuestion(
            "preset=plate",
            "A plate is thrown, spinning and a little tilted. How fast does it wobble?",
            ("half as fast as it spins", "as fast as it spins", "twice as fast as it spins"),
            2,
            "About twice as fast: Ω_s = L/λ₁, and for a flat plate λ₃ = 2λ₁.",
        ),
        TourQuestion(
            "preset=largest",
            "Three different moments, and a start near the axis of the largest one. Will ω stay "
            "near it?",
            ("yes", "no"),
            0,
            "Yes: ω goes round e₃ on a closed curve, the polhode.",
        ),
        TourQuestion(
            "preset=smallest",
            "Near the axis of the smallest moment?",
            ("yes", "no"),
            0,
            "Yes: around e₁ the polhodes are closed curves, too. With a little friction inside it "
            "would leave: T falls while L stays.",
        ),
        TourQuestion(
            "preset=flip",
            "Near the axis of the intermediate moment, half a degree away?",
            ("it stays near it", "it turns over once", "it turns over again and again"),
            2,
            f"Again and again, every {period:.3g} s: the polhode that comes near e₂ goes on to "
            "−e₂. L does not move.",
        ),
        TourQuestion(
            "preset=flip&omega1=0.002&omega3=0.002",
            "Now started ten times as near to that axis. After how long will it turn over?",
            ("sooner", f"later, by {nearer - period:.1f} s", "ten times as late"),
            1,
            f"Every {nearer:.3g} s: what is off the axis grows as e^(σt), so that a factor of ten "
            "takes the same time each, ln 10/σ, to grow and again to fade.",
        ),
        TourQuestion(
            "preset=flip&omega1=0&omega3=0",
            "And started on the axis itself?",
            ("it turns over at once", "it never does"),
            1,
            "It never does: ω along a principal axis stays. But it is unstable, and no hand can do "
            "it.",
        ),
        TourQuestion(
            f"preset=flip&{on}",
            "This start lies on the separatrix, L² = 2Tλ₂. How often will it turn over?",
            ("never", "once", "again and again"),
            1,
            "Once: ω goes from near −e₂ to e₂, nearer and nearer, and takes for ever. (Rounding "
            "ends that here: after some twenty seconds the page's body turns over again.)",
        ),
        TourQuestion(
            "preset=toutatis&speed=2",
            "The asteroid Toutatis: ω circles in it in 5.4 days, and its long axis turns about L "
            "in 7.4. After how long is it again as it was?",
            ("5.4 days", "7.4 days", "after neither"),
            2,
            "After neither: when ω is back where it was in the body, the body has turned about L "
            "by less than once. It has no day.",
        ),
    )


TOURS: dict[str, Callable[[], tuple[TourQuestion, ...]]] = {HEAVY: heavy_tour, FREE: free_tour}
