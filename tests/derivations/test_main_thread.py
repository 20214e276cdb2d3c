"""The main thread of the lecture stands by itself, and its numbers are right."""

from math import cos, degrees, hypot, log, pi, radians, sin, sqrt

import pytest

from rigidtop.derivations import PAGES, lecture
from rigidtop.derivations.toutatis import MOMENTS, OMEGA_1992
from rigidtop.motion.top import HeavyTop
from rigidtop.proof.lecture import Prose


def test_the_main_thread_never_rests_on_a_box():
    text = lecture()
    boxed = frozenset().union(*(page.boxed for page in text.texts))
    assert len(boxed) > 100
    for id in text.lines.keys() - boxed:
        assert not boxed & {*text.cites(id)}, id


def test_every_numbered_equation_is_in_the_main_thread():
    numbers = {claim.name for page in PAGES for claim in page.claims if claim.name[0].isdigit()}
    for page in lecture().texts:
        inside = [line for line in page.lines if line.id in page.boxed]
        assert not numbers & {each.tag for line in inside for each in line.equations}


def _top():
    """A disc of 50 g on a stem of 5 g."""
    disc, radius, thickness, height, stem, length = 0.05, 0.03, 0.008, 0.02, 0.005, 0.05
    mass = disc + stem
    across = disc * (radius**2 / 4 + thickness**2 / 12 + height**2) + stem * length**2 / 3
    centre = (disc * height + stem * length / 2) / mass
    return HeavyTop(lambda1=across, lambda3=disc * radius**2 / 2, M=mass, R=centre, g=9.81)


TILT, SPIN = radians(15), 150.0
TOP = _top()
WEIGHT = TOP.M * TOP.g * TOP.R
SLOW, FAST = TOP.steady_precession(TILT, SPIN)
NODDING = hypot(
    TOP.lambda3 * SPIN / TOP.lambda1 - 2 * SLOW * cos(TILT),
    SLOW * sin(TILT),
)
SMALL = TOP.lambda1 * WEIGHT / (TOP.lambda3 * SPIN) ** 2
ENERGY = sum(m * w**2 for m, w in zip(MOMENTS, OMEGA_1992, strict=True))
MOMENTUM = sum((m * w) ** 2 for m, w in zip(MOMENTS, OMEGA_1992, strict=True))


@pytest.mark.parametrize(
    ("words", "value", "said", "within"),
    [
        ("$\\lambda_1 = \\lambda_2 = 36", TOP.lambda1 * 1e6, 36, 0.5),
        ("$\\lambda_3 = 22.5", TOP.lambda3 * 1e6, 22.5, 0.05),
        ("$MgR = 11\\ ", WEIGHT * 1e3, 11, 0.5),
        ("a torque of 2.9 mN m", WEIGHT * sin(TILT) * 1e3, 2.9, 0.05),
        ("3.26\\times 10^{-3}", TOP.lambda3 * SPIN * cos(TILT) * 1e3, 3.26, 0.005),
        ("goes round in 1.9 seconds if", 2 * pi / SLOW, 1.9, 0.05),
        ("= 1.9$ seconds", 2 * pi * TOP.lambda3 * SPIN / WEIGHT, 1.9, 0.05),
        ("24 turns a second", SPIN / (2 * pi), 24, 0.5),
        ("$\\Omega_- = 3.4$", SLOW, 3.4, 0.05),
        ("$\\Omega_+ = 95$", FAST, 95, 0.5),
        ("simplified picture says 3.3", WEIGHT / (TOP.lambda3 * SPIN), 3.3, 0.05),
        ("nods 14 times a second", NODDING / (2 * pi), 14, 0.05),
        ("half a degree", degrees(SMALL * sin(TILT)), 0.5, 0.05),
        ("above 533 turns", TOP.smallest_spin(0.0) * 30 / pi, 533, 0.5),
        ("1.9 times the energy", float(max(MOMENTS) * ENERGY / MOMENTUM), 1.9, 0.05),
        ("doubles in 0.19 turns", log(2) * sqrt(3) / (2 * pi), 0.19, 0.005),
        ("has $(0.26, 0, 0.97)$ there", sin(TILT), 0.26, 0.005),
        ("has $(0.26, 0, 0.97)$ there", cos(TILT), 0.97, 0.005),
        ("take 304 days", 1 / 0.003273795 - 1, 304, 0.5),
    ],
)
def test_a_number_in_words_is_right(words, value, said, within):
    told = [b.words for page in lecture().texts for b in page.blocks if isinstance(b, Prose)]
    assert any(words in each for each in told)
    assert value == pytest.approx(said, abs=within)
