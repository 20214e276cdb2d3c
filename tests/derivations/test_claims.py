"""Every claim of the notes gets the verdict that physics expects, computed and with numbers."""

import re
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from rigidtop.derivations import PAGES
from rigidtop.derivations.euler_angles import page as euler_angles
from rigidtop.motion.body import FreeBody
from rigidtop.motion.top import HeavyTop
from rigidtop.proof.page import Check, Correction, Definition, Measure, Step
from rigidtop.proof.verdict import Finding, Verdict, judge
from rigidtop.proof.words import unmarked
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


@pytest.mark.parametrize("name", NAMES)
def test_passes(judgements, name):
    assert (judgements[name].passed, judgements[name].problem) == (True, "")


def test_expectations_are_about_claims():
    assert set(NOT_PROVED) <= set(NAMES)


def test_what_is_not_proved_says_why(judgements):
    for judged in judgements.values():
        findings = judged.findings()
        unstated = [a for f in findings for a in f.assumptions if not a.assumption.stated]
        refuted = [f for f in findings if f.counterexample is not None]
        if judged.verdict is Verdict.ASSUMING:
            assert all(len(a.assumption.words) > 10 for a in unstated)
            assert len(unstated) >= 1
        if judged.verdict in (Verdict.FALSE, Verdict.CONVENTION):
            assert len(refuted) >= 1
        else:
            assert refuted == []


def test_every_claim_gives_its_reason_in_a_sentence(judgements):
    for judged in judgements.values():
        assert re.fullmatch(r"\S.{15,700}[.)]", judged.claim.reason), judged.claim.name


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


def test_measures_pass_with_room_to_spare(judgements):
    measures = {
        unmarked(item.what): item
        for judged in judgements.values()
        for item in judged.items
        if isinstance(item, Measure)
    }
    assert len(measures) == 25
    bound = "angle between L and ω, released with ω along e₃"
    for what, measure in measures.items():
        assert measure.passed, what
        assert measure.error <= (1.0 if what == bound else 0.6) * measure.tolerance, what
    assert measures["θ held over 100 turns at Ω₋ (rad)"].tolerance <= 1e-9
    assert measures["θ held over 100 turns at Ω₊ (rad)"].tolerance <= 1e-9
    assert measures["ω(t) on the body cone, prolate, 50 s (rad/s)"].tolerance <= 1e-10
    assert measures["drift of energy over 100 s, relative"].tolerance <= 1e-9


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


def test_sentence_beside_3_46_gives_another_vector(judgements):
    found, at = counterexample(judgements["3.46"])
    turn = rotation(at["phi"], at["theta"], at["psi"])
    body = np.array([at["r1"], at["r2"], at["r3"]])
    space = turn @ body
    assert turn.T @ space == pytest.approx(body)
    assert float(found.left) == pytest.approx(body[0])
    assert float(sympy.N(found.right)) == pytest.approx((turn @ space)[0])
    assert abs(body[0] - (turn @ space)[0]) > 0.1


def test_corrected_inertia_of_a_symmetric_top(judgements):
    [corrected] = judgements["inertia-full"].corrections()
    assert corrected.verdict is Verdict.ASSUMING
    turn = rotation(0.7, 1.1, -0.4)
    tensor = turn @ np.diag([1.3, 1.3, 0.4]) @ turn.T
    by_hand = (0.4 - 1.3) * np.sin(1.1) * np.cos(1.1) * np.cos(0.7)
    assert tensor[0, 2] == pytest.approx(by_hand, rel=1e-14)


# --- assumptions that the notes do not state ---------------------------------------------------


def test_equal_moments_let_omega_rest(judgements):
    _, at = without(judgements["off-axis-changes"], sympy.Ne(s.lambda1, s.lambda2))
    omega = np.array([at["omega1"], at["omega2"], at["omega3"]])
    momentum = np.array([at["lambda1"], at["lambda2"], at["lambda3"]]) * omega
    assert np.cross(omega, momentum) == pytest.approx(np.zeros(3))
    assert at["omega1"] * at["omega2"] != 0


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


def test_upright_the_rate_of_phi_is_lost(judgements):
    found, at = without(judgements["3.45"], sympy.Ne(sympy.sin(s.theta), 0))
    spin = at["psidot"] + at["phidot"] * np.cos(at["theta"])
    along_axis = at["lambda3"] * spin
    vertical = at["lambda1"] * at["phidot"] * np.sin(at["theta"]) ** 2
    vertical += along_axis * np.cos(at["theta"])
    assert found.right is None
    assert vertical - along_axis * np.cos(at["theta"]) == 0
    assert np.sin(at["theta"]) == 0
    assert float(found.left) == at["phidot"] != 0


def test_upright_every_precession_is_steady(judgements):
    found, at = without(judgements["3.57"], sympy.Ne(sympy.sin(s.theta), 0))
    omega, angle = at["Omega"], at["theta"]
    pull = at["M"] * at["g"] * at["R"]
    quadratic = at["lambda1"] * np.cos(angle) * omega**2 - at["lambda3"] * at["omega3"] * omega
    quadratic += pull
    assert np.sin(angle) * quadratic == 0  # (3.54) holds
    assert quadratic == pytest.approx(float(found.right))
    assert abs(quadratic) > 0.5  # and (3.57) does not


def test_upright_a_constant_theta_leaves_phi_free(judgements):
    found, at = without(judgements["constant-rate"], sympy.Ne(sympy.sin(s.theta), 0))
    assert np.sin(at["theta"]) == 0
    assert float(found.left) == at["phiddot"] != 0
    assert found.right == 0


def test_upright_without_momentum_phi_and_psi_may_turn_against_each_other(judgements):
    found, at = without(judgements["example-34"], sympy.Ne(sympy.sin(s.theta), 0))
    assert np.sin(at["theta"]) == 0
    assert (float(found.left), found.right) == (at["phidot"], 0)
    assert at["phidot"] != 0


def conditions(judged):
    """What a claim assumes but for equalities."""
    return {
        tested.assumption.condition
        for finding in judged.findings()
        for tested in finding.assumptions
        if not isinstance(tested.assumption.condition, sympy.Eq)
    }


def test_omega_may_lean_towards_any_axis_across_e3(judgements):
    """L along ω takes ω along e₃, and not only no part along e₁."""
    judged = judgements["same-frequency"]
    body = {s.lambda1: 1, s.lambda3: 2, s.omega3: 1}
    for leans in ((1, 0), (0, 1), (1, 1)):
        at = {**body, s.omega1: leans[0], s.omega2: leans[1]}
        assert all(condition.subs(at) == sympy.true for condition in conditions(judged))
        omega = np.array([*leans, 1])
        assert np.linalg.norm(np.cross(np.array([1, 1, 2]) * omega, omega)) >= 1
    _, at = without(judged, sympy.Ne(s.omega1**2 + s.omega2**2, 0))
    assert at["omega1"] == at["omega2"] == 0 != at["omega3"]


def test_a_ball_that_rests_in_the_body_loses_nothing(judgements):
    turning = sympy.Gt(s.zeta1**2 + s.zeta2**2 + s.zeta3**2, 0)
    found, at = without(judgements["example-33"], turning)
    assert at["damping"] > 0
    assert (at["zeta1"], at["zeta2"], at["zeta3"]) == (0, 0, 0)
    assert found.left == found.right == 0


def test_another_rotation_than_about_e3_has_energy_to_lose(judgements):
    """Without a part along e₁ or e₂ the energy is the least."""
    found, at = without(judgements["example-33"], s.omega1**2 + s.omega2**2 > 0)
    assert at["omega1"] == at["omega2"] == 0 != at["omega3"]
    least = at["lambda3"] * at["omega3"] ** 2 / 2
    assert (float(found.left), float(found.right)) == (least, least)


def test_a_round_tip_that_turns_about_the_vertical_stays(judgements):
    """ω across ẑ is θ̇ along the line of nodes, and ψ̇ sin θ."""
    condition = sympy.Ne(s.thetadot**2 + s.psidot**2 * sympy.sin(s.theta) ** 2, 0)
    assert condition in conditions(judgements["friction"])
    found, at = without(judgements["friction"], condition)
    axis = rotation(at["phi"], at["theta"], 0.0)[:, 2]
    omega = at["psidot"] * axis  # φ̇ is along ẑ
    assert np.cross(omega, [0, 0, at["r_t"]]) == pytest.approx(np.zeros(3), abs=1e-12)
    assert (at["thetadot"], float(found.left)) == (0, 0)


def test_a_horizontal_top_has_one_steady_precession(judgements):
    _, at = without(judgements["two-roots"], sympy.Ne(sympy.cos(s.theta), 0))
    assert at["lambda1"] * np.cos(at["theta"]) == pytest.approx(0, abs=1e-15)


def test_below_the_threshold_there_is_no_steady_precession(judgements):
    threshold = sympy.Gt(
        s.lambda3**2 * s.omega3**2, 4 * s.lambda1 * s.M * s.g * s.R * sympy.cos(s.theta)
    )
    found, at = without(judgements["two-roots"], threshold)
    roots = np.roots(
        [
            at["lambda1"] * np.cos(at["theta"]),
            -at["lambda3"] * at["omega3"],
            at["M"] * at["g"] * at["R"],
        ]
    )
    assert found.left <= 0
    assert abs(roots[0] - roots[1]) < 1e-6 or abs(roots.imag).max() > 0


@pytest.mark.parametrize("name", ["two-roots", "slow-agrees"])
def test_backwards_the_root_with_minus_is_the_fast_one(judgements, name):
    """The numbers are those of a top that has both rates."""
    found, at = without(judgements[name], sympy.Gt(s.omega3, 0))
    lead, spin = at["lambda1"] * np.cos(at["theta"]), at["lambda3"] * at["omega3"]
    pull = at["M"] * at["g"] * at["R"]
    root = np.sqrt(spin**2 - 4 * lead * pull)
    minus, plus = (spin - root) / (2 * lead), (spin + root) / (2 * lead)
    assert spin < 0
    assert abs(minus) > abs(plus)
    if name == "slow-agrees":  # λ₃ω₃Ω₋(1 + √(1 − 4ε)) = 2MgR
        sides = spin * (1 + root / abs(spin)) * np.array([minus, plus])
    else:
        sides = np.array([minus, plus])
    assert sides == pytest.approx([float(found.left), float(found.right)])


def test_backwards_without_weight_the_root_with_plus_is_rest(judgements):
    found, at = without(judgements["fast-is-free"], sympy.Gt(s.omega3, 0))
    assert at["omega3"] < 0
    assert found.left == 0
    free = at["lambda3"] * at["omega3"] / (at["lambda1"] * np.cos(at["theta"]))
    assert free == pytest.approx(float(found.right))


def test_an_oblate_body_has_no_negative_period(judgements):
    found, at = without(judgements["3.40"], sympy.Gt(s.Omega_b, 0))
    period = float(found.left)
    assert np.cos(at["Omega_b"] * (0.3 + period)) == pytest.approx(np.cos(at["Omega_b"] * 0.3))
    assert period > 0 > float(found.right)


def test_a_middling_torque_does_not_leave_l_along_omega(judgements):
    found, at = without(judgements["parallel-approximation"], sympy.Eq(s.kappa, 0))
    work = at["kappa"] * at["M"] * at["g"] * at["R"] * at["delta"]
    omega = np.array([np.sqrt(2 * work / at["lambda1"]), 0, at["omega3"]])
    momentum = np.array([at["lambda1"], at["lambda1"], at["lambda3"]]) * omega
    squared = (omega @ momentum) ** 2 / (omega @ omega * (momentum @ momentum))
    assert squared == pytest.approx(float(sympy.N(found.left)))
    assert squared < 0.99


def test_a_strong_torque_goes_round_at_another_rate(judgements):
    """Without the limit: the slow rate at a spin, as (3.57) says, and not that of (3.50)."""
    found, at = without(judgements["3.50"], sympy.Eq(s.epsilon, 0))
    pull, spin = at["M"] * at["g"] * at["R"], at["lambda3"] * at["omega3"]
    twice = 2 * at["lambda1"] * np.cos(at["theta"])
    rate = (spin - np.sign(spin) * np.sqrt(spin**2 - 2 * twice * pull)) / twice
    sides = spin * rate * np.sin(at["theta"]), pull * np.sin(at["theta"])
    assert sorted(sides) == pytest.approx(sorted([float(found.left), float(found.right)]))
    assert abs(sides[0] - sides[1]) > 0.1


def test_a_top_at_another_rate_has_another_torque(judgements):
    """Without the slow rate: λ₃ω₃Ω sin θ is not the torque, at Ω₊ as little as at any other."""
    (slow,) = {
        tested.assumption.condition
        for finding in judgements["3.50"].findings()
        for tested in finding.assumptions
        if s.Omega in tested.assumption.condition.free_symbols
    }
    found, at = without(judgements["3.50"], slow)
    torque = at["M"] * at["g"] * at["R"] * np.sin(at["theta"])
    moved = at["lambda3"] * at["omega3"] * at["Omega"] * np.sin(at["theta"])
    sides = sorted([float(found.left), float(found.right)])
    assert sides == pytest.approx(sorted([torque, moved]))
    assert abs(torque - moved) > 0.1


@given(st.floats(0.05, 1.5), st.floats(1.01, 1e4))
def test_what_is_left_out_is_half_of_what_is_kept_at_the_faster_rate(theta, times):
    """−λ₁Ω₊ cos θ ė₃ of (3.50) beside λ₃ω₃ė₃, at any spin that allows the rate."""
    top = HeavyTop(lambda1=0.03, lambda3=0.01, M=0.5, R=0.2)
    least = 2 * np.sqrt(top.lambda1 * top.M * top.g * top.R * np.cos(theta)) / top.lambda3
    slow, fast = top.steady_precession(theta, times * least)
    kept = top.lambda3 * times * least
    assert 0.5 <= top.lambda1 * fast * np.cos(theta) / kept <= 1 + 1e-12
    assert top.lambda1 * slow * np.cos(theta) / kept <= 0.5


def test_a_falling_top_has_its_torque_along_l(judgements):
    found, at = without(judgements["torque-perpendicular"], sympy.Eq(s.thetadot, 0))
    axes = rotation(at.get("phi", 0.0), at["theta"], 0.0)
    momentum = axes @ np.array(
        [
            -at["lambda1"] * at.get("phidot", 0.0) * np.sin(at["theta"]),
            at["lambda1"] * at["thetadot"],
            at.get("lambda3", 1.0)
            * (at.get("psidot", 0.0) + at.get("phidot", 0.0) * np.cos(at["theta"])),
        ]
    )
    torque = at["M"] * at["g"] * at["R"] * np.cross([0, 0, 1], axes[:, 2])
    assert torque @ momentum == pytest.approx(float(found.left))
    assert abs(torque @ momentum) > 0.1


def test_the_mean_of_a_finite_nutation_lies_off_the_steady_angle():
    # θ̈ = −U′(θ)/λ₁ with U of the conserved momenta, averaged over one swing by quadrature.
    moment, moment3, pull, theta0, spin = 1.0, 1.0, 4.905, 0.7, 6.0
    roots = np.roots([moment * np.cos(theta0), -moment3 * spin, pull])
    rate = roots.min()
    p_psi = moment3 * spin
    p_phi = moment * rate * np.sin(theta0) ** 2 + p_psi * np.cos(theta0)
    x = sympy.Symbol("x")
    potential = (p_phi - p_psi * sympy.cos(x)) ** 2 / (2 * moment * sympy.sin(x) ** 2)
    potential += pull * sympy.cos(x)
    slope, second, third = (float(potential.diff(x, order).subs(x, theta0)) for order in (1, 2, 3))
    assert abs(slope) < 1e-12
    amplitude = 0.01
    at = sympy.lambdify(x, potential, "numpy")
    upper = theta0 + amplitude
    low, high = theta0 - 2 * amplitude, theta0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if at(middle) > at(upper) else (low, middle)
    lower, half = high, (upper - high) / 2
    # With θ = centre − half cos u the time element is du × (something smooth).
    u = (np.arange(200) + 0.5) * np.pi / 200
    angle = (upper + lower) / 2 - half * np.cos(u)
    weight = half * np.sin(u) / np.sqrt(2 * (at(upper) - at(angle)) / moment)
    mean = np.sum(angle * weight) / np.sum(weight) - theta0
    assert mean == pytest.approx(-(half**2) * third / (4 * second), rel=1e-2)


@pytest.mark.parametrize(
    ("claim", "condition", "words"),
    [
        ("3.40", sympy.Gt(s.Omega_b, 0), "or a flat one with ω₃ < 0"),
        ("space-cone", sympy.Ne(s.omega1**2 + s.omega2**2, 0), "ω is not along e₃"),
        ("free-fall", sympy.Eq(s.F_1, 0), "no air"),
        ("axis-stability", sympy.Eq(s.damping, 0), "no friction inside"),
    ],
)
def test_conditions_in_words(judgements, claim, condition, words):
    assert any(
        tested.assumption.condition == condition and words in unmarked(tested.assumption.words)
        for finding in judgements[claim].findings()
        for tested in finding.assumptions
    )


def test_an_oblate_body_that_spins_backwards_has_the_printed_period():
    body, spin = FreeBody(1.0, 1.0, 1.8), -2.5
    period = 2 * np.pi / ((1.0 - 1.8) * spin)
    assert period > 0
    path = body.motion(omega=(0.3, 0.0, spin)).integrate([period], rtol=1e-12, atol=1e-14)
    assert path.omega[0] == pytest.approx([0.3, 0, spin], abs=1e-10)


def test_three_equal_moments_leave_every_rotation_as_it_is(judgements):
    [remark] = [
        finding
        for finding in judgements["axis-stability"].remarks()
        if finding.assumptions and finding.verdict is Verdict.ASSUMING
    ]
    conditions = {tested.assumption.condition for tested in remark.assumptions}
    assert conditions == {sympy.Eq(s.lambda2, s.lambda1), sympy.Eq(s.lambda3, s.lambda1)}


def test_friction_inside_leads_from_the_smallest_moment_to_the_largest(judgements):
    """And without it the same kick stays one, for as long."""
    error = {
        unmarked(i.what): i.error
        for i in judgements["axis-stability"].items
        if isinstance(i, Measure)
    }
    assert error["L in space with friction inside, relative"] < 1e-9
    assert error["L at last off the axis of largest moment, relative"] < 0.0011
    free = FreeBody(1.0, 1.7, 2.3).motion(omega=(2.0, 2e-3, 0.0)).exact(np.linspace(0, 300, 3001))
    assert np.abs(free.omega[:, 1:]).max() < 0.003


def test_an_upright_top_sleeps_at_the_sleeping_spin_itself(judgements):
    """(1 − cos θ)Ω stays below the speed of e₃ as seen from a frame that turns at Ω = λ₃ω₃/(2λ₁).

    That goes to zero with the kick, of whatever kind; a little below the spin the top falls.
    """
    [condition] = {
        tested.assumption.condition
        for finding in judgements["nutation"].findings()
        for tested in finding.assumptions
        if s.D in tested.assumption.condition.free_symbols
    }
    assert condition == sympy.Ge(s.D, 0)
    top, kick = HeavyTop(lambda1=1.3, lambda3=0.7, M=0.8, R=0.6, g=9.81), 1e-4
    times, spin = np.linspace(0, 200, 4001), top.sleeping_spin()
    turn = 0.7 * spin / 2.6
    for rate in (0.0, turn, 6.0):
        start = {"theta": kick, "theta_dot": kick, "phi_dot": rate}
        asleep, awake = (
            top.motion(**start, omega3=share * spin).integrate(times, rtol=1e-11, atol=1e-13).theta
            for share in (1.0, 0.98)
        )
        bound = kick * np.sqrt(1 + (rate - turn) ** 2) / turn
        assert kick < asleep.max()
        assert 1 - np.cos(asleep.max()) < 1.001 * bound
        assert awake.max() > 0.3


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
