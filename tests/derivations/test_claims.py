"""Every claim of the notes gets the verdict that physics expects, computed and with numbers."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
import sympy

from rigidtop.derivations import PAGES
from rigidtop.derivations.euler_angles import page as euler_angles
from rigidtop.proof.page import Check, Correction, Definition, Step
from rigidtop.proof.verdict import Finding, Verdict, judge
from rigidtop.theory import symbols as s

SECTIONS = {
    "3.2 (opening)": "two-mass-points",
    "3.2": "3.33 inertia-full",
    "3.2.1": "principal-axes 3.34",
    "3.2.2": "3.35 3.36 euler-with-torque principal-stays off-axis-changes axis-stability",
    "3.2.3": "3.37 omega-oscillator 3.38 3.39 3.40 constant-angle coplanar same-frequency "
    "space-cone free-fall example-33",
    "3.3": "euler-sequence 3.41 z-hat 3.42 skip-last-step 3.43 3.44 3.45",
    "3.4": "3.46 3.47 rotation-group",
    "3.5.1": "3.48 3.49 potential",
    "3.5.2": "3.50 torque-perpendicular 3.51 3.52 torque-direction parallel-approximation "
    "example-34",
    "3.5.3": "3.53 3.54 3.55 3.56 p-phi-is-Lz p-psi-is-L3 constant-rate 3.57 two-roots "
    "slow-agrees fast-is-free",
    "3.5.4": "nutation azimuth friction",
}
"""What the notes assert, in reading order."""

NAMES = [name for names in SECTIONS.values() for name in names.split()]

NOT_PROVED = {
    # name: verdict, and why no proof can do better
    "two-mass-points": ("assuming", "a stick at right angles to ω has L ∥ ω"),
    "inertia-full": ("false", "upright, or for a sphere, I is diagonal in the space frame too"),
    "off-axis-changes": ("assuming", "ω rests on every axis in a plane of equal moments"),
    "axis-stability": ("assuming", "with λ₁ = λ₂ a kick about e₁ grows linearly in time"),
    "3.38": ("assuming", "another ω₂ at t = 0 shifts the phase"),
    "3.39": ("assuming", "the phase of (3.38) again"),
    "3.40": ("assuming", "an oblate body has Ω_b < 0, and no period is negative"),
    "coplanar": ("false", "a vector that turns along, but behind, keeps its angle out of plane"),
    "same-frequency": ("assuming", "a sphere has L ∥ ω, and across e₃ both are at 90°"),
    "free-fall": ("assuming", "the tide turns the Moon"),
    "example-33": ("assuming", "a body that loses no energy tumbles for ever"),
    "3.45": ("assuming", "upright, φ̇ and ψ̇ can't be told apart"),
    "3.46": ("convention", "the sentence multiplies r with O, the equation with Oᵀ"),
    "3.47": ("convention", "the last column printed is e₃ in space: the matrix is O"),
    "3.50": ("assuming", "a nutating e₃ moves along θ too"),
    "torque-perpendicular": ("assuming", "a top that falls gains angular momentum"),
    "3.51": ("assuming", "a nutating e₃ moves along θ too"),
    "3.52": ("assuming", "a top released with ω along e₃ starts with Ω = 0"),
    "torque-direction": ("assuming", "leaning the other way turns the torque round"),
    "constant-rate": ("assuming", "a sleeping top may turn by φ or by ψ, as one likes"),
    "3.57": ("assuming", "upright, every Ω is steady"),
    "two-roots": ("assuming", "below the threshold there is none, horizontal only one"),
    "fast-is-free": ("assuming", "a horizontal top has no fast precession"),
    "nutation": ("assuming", "an upright top below the sleeping spin falls, and does not swing"),
    "azimuth": ("assuming", "with p_φ = p_ψ = 0 the top falls in a plane"),
    "friction": ("assuming", "a tip that does not slip loses nothing"),
}

NUMBERS = [f"3.{n}" for n in range(33, 58)]


# --- the whole ---------------------------------------------------------------------------------


def test_every_claim_once_and_in_reading_order(judgements):
    pages = {page.section: " ".join(claim.name for claim in page.claims) for page in PAGES}
    assert list(pages.items()) == list(SECTIONS.items())
    assert list(judgements) == NAMES  # as a dictionary: none twice
    assert [judged.section for judged in judgements.values()] == [
        section for section, names in SECTIONS.items() for _ in names.split()
    ]


@pytest.mark.parametrize("name", NAMES)
def test_verdict(judgements, name):
    expected, _ = NOT_PROVED.get(name, ("proved", ""))
    assert judgements[name].verdict == expected


def test_every_printed_number_is_on_one_claim_once(judgements):
    tags = Counter()
    for name, judged in judgements.items():
        for item in judged.items:
            if isinstance(item, Finding) and isinstance(item.check, Correction):
                continue  # it may repeat the printed line that it corrects a sentence about
            equation = item.check.claimed if isinstance(item, Finding) else None
            if isinstance(item, (Step, Definition)):
                equation = item.equation
            if equation is None or not equation.tag:
                continue
            tag = equation.tag
            assert tag == name
            printed = isinstance(item, (Step, Definition)) or item.check.printed
            tags[tag] += printed
    assert tags == dict.fromkeys(NUMBERS, 1)


# --- false, and at odds with a definition ------------------------------------------------------


def counterexample(judged):
    """The values of the one counterexample to what a claim asserts, as floats by name."""
    [found] = [f.counterexample for f in judged.findings() if f.counterexample is not None]
    return found, numbers(found)


def numbers(found):
    return {symbol.name: float(value) for symbol, value in found.values.items()}


def without(judged, condition):
    """The counterexample that stands when `condition` is dropped, with its values as floats."""
    found = next(
        tested.without
        for finding in judged.findings()
        for tested in finding.assumptions
        if tested.assumption.condition == condition
    )
    return found, numbers(found)


def rotation(phi, theta, psi):
    """Rz(φ) Ry(θ) Rz(ψ), by hand."""

    def about_z(x):
        return np.array([[np.cos(x), -np.sin(x), 0], [np.sin(x), np.cos(x), 0], [0, 0, 1]])

    about_y = np.array(
        [[np.cos(theta), 0, np.sin(theta)], [0, 1, 0], [-np.sin(theta), 0, np.cos(theta)]]
    )
    return about_z(phi) @ about_y @ about_z(psi)


def test_inertia_with_zeros_in_the_space_frame(judgements):
    found, at = counterexample(judgements["inertia-full"])
    turn = rotation(at["phi"], at["theta"], at["psi"])
    tensor = turn @ np.diag([at["lambda1"], at["lambda2"], at["lambda3"]]) @ turn.T
    assert (found.left, found.right) == (0, 0)
    assert abs(tensor[0, 2]) < 1e-15


def test_vectors_that_keep_their_angle_out_of_one_plane(judgements):
    found, at = counterexample(judgements["coplanar"])

    def triple(angle):
        omega = np.array([at["omega_0"] * np.cos(angle), -at["omega_0"] * np.sin(angle), 0.3])
        behind = angle - at["gamma"]
        across = at["omega_0"]
        follower = np.array([across * np.cos(behind), -across * np.sin(behind), 0.3])
        return omega @ follower, np.cross(omega, follower)[2]

    products, volumes = zip(*(triple(angle) for angle in (0.0, 1.0, 5.0)), strict=True)
    assert np.ptp(products) < 1e-14
    assert volumes[0] == pytest.approx(float(found.left), abs=1e-12)
    assert abs(volumes[0]) > 0.1


def test_printed_matrix_is_not_the_transpose(judgements):
    found, at = counterexample(judgements["3.47"])
    printed = rotation(at["phi"], at["theta"], at["psi"])
    entries = [
        (i, j)
        for i in range(3)
        for j in range(3)
        if printed.T[i, j] == pytest.approx(float(found.left), abs=1e-12)
        and printed[i, j] == pytest.approx(float(found.right), abs=1e-12)
    ]
    assert entries
    assert float(found.left) != pytest.approx(float(found.right))
    [corrected] = judgements["3.47"].corrections()
    assert corrected.verdict is Verdict.PROVED
    assert corrected.check.claimed.sides[0] == s.O_matrix
    assert (
        corrected.check.claimed.sides[1] == judgements["3.47"].findings()[0].check.claimed.sides[1]
    )


def test_corrected_inertia_of_a_symmetric_top(judgements):
    [corrected] = judgements["inertia-full"].corrections()
    assert corrected.verdict is Verdict.ASSUMING
    turn = rotation(0.7, 1.1, -0.4)
    tensor = turn @ np.diag([1.3, 1.3, 0.4]) @ turn.T
    by_hand = (0.4 - 1.3) * np.sin(1.1) * np.cos(1.1) * np.cos(0.7)
    assert tensor[0, 2] == pytest.approx(by_hand, rel=1e-14)


# --- assumptions that the notes do not state ---------------------------------------------------


def test_stick_across_omega_has_its_momentum_along_it(judgements):
    _, at = without(judgements["two-mass-points"], sympy.Ne(sympy.cos(s.alpha), 0))
    along = np.array([0, np.sin(at["alpha"]), np.cos(at["alpha"])])
    omega = np.array([0, 0, at["omega"]])
    momentum = sum(
        m * np.cross(r, np.cross(omega, r))
        for m, r in ((at["M_1"], at["a"] * along), (at["M_2"], -at["b"] * along))
    )
    assert np.cross(momentum, omega) == pytest.approx(np.zeros(3), abs=1e-12)
    assert np.linalg.norm(momentum) > 0.1


def test_upright_every_precession_is_steady(judgements):
    found, at = without(judgements["3.57"], sympy.Ne(sympy.sin(s.theta), 0))
    omega, angle = at["Omega"], at["theta"]
    pull = at["M"] * at["g"] * at["R"]
    quadratic = at["lambda1"] * np.cos(angle) * omega**2 - at["lambda3"] * at["omega3"] * omega
    quadratic += pull
    assert np.sin(angle) * quadratic == 0  # (3.54) holds
    assert quadratic == pytest.approx(float(found.right))
    assert abs(quadratic) > 0.5  # and (3.57) does not


def test_three_equal_moments_leave_every_rotation_as_it_is(judgements):
    [remark] = [
        finding
        for finding in judgements["axis-stability"].remarks()
        if finding.assumptions and finding.verdict is Verdict.ASSUMING
    ]
    conditions = {tested.assumption.condition for tested in remark.assumptions}
    assert conditions == {sympy.Eq(s.lambda2, s.lambda1), sympy.Eq(s.lambda3, s.lambda1)}


# --- what would be seen if a page were wrong ---------------------------------------------------


def test_a_wrong_line_on_a_page_does_not_pass():
    azimuth = euler_angles.claims[-1]
    [*_, line] = [e for e in azimuth.evidence() if isinstance(e, Check)]
    broken = replace(line, claimed=replace_right(line.claimed, 2 * line.claimed.sides[1]))
    judged = judge(replace(azimuth, evidence=lambda: [broken]))
    assert judged.verdict is Verdict.FALSE
    assert judged.problem == "it fails, and no corrected form stands beside it"


def replace_right(equation, right):
    return type(equation)(equation.sides[0], right, relation=equation.relation, tag=equation.tag)
