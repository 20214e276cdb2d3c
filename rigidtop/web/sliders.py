"""What the reader may change on the page, with units and ranges."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import pi

from rigidtop.theory import symbols as s
from rigidtop.theory.symbols import VOCABULARY, Glyph
from rigidtop.typeset.mathml import letter
from rigidtop.typeset.text import letter as text_letter
from rigidtop.web.setup import HEAVY, Setup

MOMENTS, RATES = (1e-3, 10.0), (-60.0, 60.0)


@dataclass(frozen=True)
class Slider:
    """A number of the setup; `glyph` is its letter, with ₀ where it is a start."""

    name: str
    glyph: Glyph
    meaning: str
    unit: str
    least: float
    most: float
    logarithmic: bool = False
    start: bool = False
    """Of the start, not of the body: these are always in sight."""

    @property
    def letter(self) -> str:
        """The slider's symbol as plain text."""
        return text_letter(self.glyph)

    @property
    def math(self) -> str:
        """The slider's symbol as a MathML element."""
        return f'<math xmlns="http://www.w3.org/1998/Math/MathML">{letter(self.glyph)}</math>'

    @property
    def angle(self) -> bool:
        """Whether it is shown in degrees."""
        return self.unit == "rad"


MOMENT_SLIDERS = tuple(
    Slider(x.name, VOCABULARY[x].glyph, f"moment about e{k}", "kg m²", *MOMENTS, True)
    for x, k in zip((s.lambda1, s.lambda2, s.lambda3), "₁₂₃", strict=True)
)


HEAVY_SLIDERS = (
    *MOMENT_SLIDERS,
    Slider("M", Glyph("M"), "mass", "kg", 1e-3, 10.0, True),
    Slider("R", Glyph("R"), "pivot to centre of mass", "m", 0.0, 2.0),
    Slider("g", Glyph("g"), "acceleration of gravity", "m/s²", 0.0, 30.0),
    Slider("friction", Glyph("c"), "friction: torque over ω", "J s", 0.0, 0.5),
    Slider("theta", Glyph("θ", "0"), "tilt at the start", "rad", 0.0, pi, start=True),
    Slider(
        "phi_dot", Glyph("φ", "0", "dot"), "precession at the start", "rad/s", *RATES, start=True
    ),
    Slider("omega3", Glyph("ω", "3"), "spin: ω along e₃", "rad/s", *RATES, start=True),
)

FREE_SLIDERS = (
    *MOMENT_SLIDERS,
    *(
        Slider(
            f"omega{k}",
            Glyph("ω", str(k)),
            f"ω along e{sub} at the start",
            "rad/s",
            *RATES,
            start=True,
        )
        for k, sub in zip((1, 2, 3), "₁₂₃", strict=True)
    ),
)


def sliders(kind: str, motions: Iterable[Setup]) -> tuple[Slider, ...]:
    """The sliders of a page, long enough for all that it shows."""
    setups = tuple(motions)
    return tuple(
        replace(
            slider,
            least=min([slider.least, *(s.values[slider.name] for s in setups)]),
            most=max([slider.most, *(s.values[slider.name] for s in setups)]),
        )
        for slider in (HEAVY_SLIDERS if kind == HEAVY else FREE_SLIDERS)
    )
