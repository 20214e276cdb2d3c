"""The ways to one motion agree, and a wrong one is found out."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.motion import certify as module
from rigidtop.motion import equations
from rigidtop.motion.certify import WAYS, certify
from rigidtop.motion.orders import orders
from rigidtop.motion.trajectory import BodyTrajectory

TOP = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
EXAMPLE = TOP.motion(theta=0.5, theta_dot=0.1, phi_dot=1.0, psi_dot=40.0)
BRICK = rt.HeavyBody(3.0, 2.0, 1.5, M=1.0, centre_of_mass=(0.2, 0.3, 0.4))
TILTED = Rotation.from_euler("y", 1.0)
TIMES = np.linspace(0, 10, 21)
OF_TOP = tuple(WAYS)
OF_BODY = ("Euler", "Lagrange", "Hamilton", "exact")

MOTIONS = {
    "example": (EXAMPLE, OF_TOP),
    "cusps": (TOP.motion(theta=1.0, omega3=10.0), OF_TOP),
    "pendulum on a cone": (TOP.motion(theta=1.0, phi_dot=2.0, omega3=0.0), OF_TOP),
    "below": (TOP.motion(theta=2.8, phi=1.0, psi=-2.0, phi_dot=-1.0, omega3=5.0), OF_TOP),
    "without weight": (
        rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.0).motion(
            theta=0.7, phi_dot=1.0, omega3=3.0
        ),
        OF_TOP,
    ),
    "free": (rt.FreeBody(1.0, 2.0, 2.5).motion(omega=(1.0, 0.5, 0.2)), OF_BODY),
    "flip": (rt.FreeBody(1.0, 2.0, 3.0).motion(omega=(0.01, 2.0, 0.01)), OF_BODY),
    "flip of e₃": (
        rt.FreeBody(1.0, 3.0, 2.0).motion(omega=(0.01, 0.01, 2.0), attitude=TILTED),
        OF_BODY,
    ),
    "symmetric and free": (rt.FreeBody(2.0, 2.0, 1.0).motion(omega=(0.7, 0.0, 5.0)), OF_TOP),
    "heavy": (
        BRICK.motion(omega=(0.1, 0.2, 5.0), attitude=TILTED),
        ("Euler", "Lagrange", "Hamilton"),
    ),
}


@pytest.fixture(autouse=True)
def without_orders(monkeypatch):
    """They take longer than all the rest, and have their own tests."""
    monkeypatch.setattr(module, "orders", lambda motion: ((), {}))


@pytest.mark.parametrize("name", MOTIONS)
def test_ways_agree(name):
    motion, ways = MOTIONS[name]
    found = certify(motion, TIMES)
    assert found.ways == ways
    assert found.passed
    assert found.largest < 1e-9
    assert np.array_equal(np.diag(found.differences), np.zeros(len(ways)))
    assert set(found.drifts) == set(ways)
    assert max(value for drift in found.drifts.values() for value in drift.values()) < 1e-10


def test_before_and_after_in_any_order():
    found = certify(EXAMPLE, [3.0, -2.0, 0.0, 0.5])
    assert found.ways == OF_TOP
    assert found.largest < 1e-10


def test_at_the_start_alone():
    found = certify(EXAMPLE, 0.0)
    assert found.ways == OF_TOP
    assert found.largest < 1e-14


def test_what_is_kept_is_named():
    assert set(certify(EXAMPLE, 1.0).drifts["Routh"]) == {"energy", "p_phi", "p_psi"}
    without = certify(MOTIONS["without weight"][0], 1.0)
    assert set(without.drifts["Routh"]) == {"energy", "p_phi", "p_psi", "L"}
    assert set(certify(MOTIONS["free"][0], 1.0).drifts["exact"]) == {"energy", "p_phi", "L"}
    assert set(certify(MOTIONS["heavy"][0], 1.0).drifts["Euler"]) == {"energy", "p_phi"}


def with_sign_changed(make, entry):
    """The equations with one rate of the opposite sign."""

    def changed(*parameters, **functions):
        rates = make(*parameters, **functions)

        def wrong(state):
            found = list(rates(state))
            found[entry] = -found[entry]
            return tuple(found)

        return wrong

    return changed


def assert_only_wrong(found, way):
    """It disagrees with all others, or runs into a pole that is not there; the others agree."""
    assert not found.passed
    others = [k for k, name in enumerate(found.ways) if name != way]
    assert len(others) >= 3
    assert np.all(found.differences[np.ix_(others, others)] < found.bound)
    if way in found.ways:
        wrong = found.ways.index(way)
        assert np.all(found.differences[wrong, others] > 1e-3)
        assert np.all(found.differences[others, wrong] > 1e-3)
    else:
        assert found.stray == (way,)
        assert found.left_out[way].endswith("; by Euler's equations e₃ is near no pole there")


@pytest.mark.parametrize(
    ("equation", "way", "entries"),
    [
        ("top_in_euler_angles", "Lagrange", range(3)),
        ("top_by_routh", "Routh", range(3)),
        ("top_by_hamilton", "Hamilton", range(4)),
    ],
)
def test_a_wrong_sign_is_seen_in_its_row_and_column(monkeypatch, equation, way, entries):
    motion, times = MOTIONS["cusps"][0], np.linspace(0, 0.5, 6)
    right = getattr(equations, equation)
    for entry in entries:
        monkeypatch.setattr(equations, equation, with_sign_changed(right, entry))
        assert_only_wrong(certify(motion, times), way)


@pytest.mark.parametrize(
    ("equation", "way", "entries"),
    [("body_in_euler_angles", "Lagrange", range(3)), ("body_by_hamilton", "Hamilton", range(5))],
)
def test_a_wrong_sign_of_a_free_body_is_seen(monkeypatch, equation, way, entries):
    motion, times = MOTIONS["free"][0], np.linspace(0, 0.5, 6)
    right = getattr(equations, equation)
    for entry in entries:
        monkeypatch.setattr(equations, equation, with_sign_changed(right, entry))
        assert_only_wrong(certify(motion, times), way)


def test_a_small_error_in_a_constant_is_seen(monkeypatch):
    right = equations.top_by_hamilton
    monkeypatch.setattr(
        equations, "top_by_hamilton", lambda first, *rest, **f: right(first * 1.00001, *rest, **f)
    )
    assert not certify(MOTIONS["cusps"][0], TIMES).passed


def test_what_the_solvers_themselves_may_do_is_not_decided():
    flip = MOTIONS["flip"][0]
    early, late = certify(flip, 100.0, rtol=1e-9), certify(flip, 300.0, rtol=1e-7)
    assert early.passed
    assert not early.undecided
    # Errors of either sign add up as the root of what errors of one sign add up to.
    assert early.reach / early.bound == pytest.approx(math.sqrt(1 + 100 * flip.rate))
    assert late.bound == module.LOOSEST
    assert late.bound < late.largest < late.reach
    assert late.undecided
    assert not late.passed
    # What is farther off, or ends at a pole that is not there, is wrong and not undecided.
    assert not replace(late, differences=late.differences + late.reach).undecided
    assert not replace(late, stray=("Lagrange",)).undecided


def test_a_way_that_gives_no_numbers_is_left_out(monkeypatch):
    def wrong(motion, times, rtol):
        attitudes = np.tile([1.0, 0, 0, 0], (len(times), 1))
        return BodyTrajectory(motion, times, attitudes, np.full((len(times), 3), np.nan))

    monkeypatch.setattr(module, "WAYS", {**WAYS, "wrong": wrong})
    found = certify(EXAMPLE, TIMES)
    assert found.ways == OF_TOP
    assert found.left_out["wrong"] == "it leaves the numbers"


def test_a_difference_that_is_no_number_does_not_pass():
    found = certify(EXAMPLE, 1.0)
    assert found.passed
    unknown = found.differences.copy()
    unknown[0, 1] = math.nan
    assert not replace(found, differences=unknown).passed


def test_upright_start_has_no_euler_angles():
    found = certify(TOP.motion(theta=0.0, theta_dot=0.3, omega3=40.0), TIMES)
    assert found.ways == ("Euler", "exact")
    assert found.passed
    for way in ("Lagrange", "Routh", "Hamilton"):
        assert found.left_out[way] == (
            "θ comes within 0.001 of 0 at t = 0: Euler angles are not defined there"
        )


@pytest.mark.parametrize("miss", [0.0, 1e-9, 1e-5])
def test_a_motion_through_the_upright_says_when(miss):
    theta, spin = 0.5, 5.0
    # p_φ = p_ψ up to `miss`, fast enough to arrive
    phi_dot = (0.5 * spin * (1 - math.cos(theta)) + miss) / math.sin(theta) ** 2
    motion = TOP.motion(theta=theta, theta_dot=-6.0, phi_dot=phi_dot, omega3=spin)
    found = certify(motion, TIMES)
    assert found.ways == ("Euler", "exact")
    assert found.passed
    for way in ("Lagrange", "Routh", "Hamilton"):
        assert found.left_out[way].startswith("θ comes within 0.001 of 0 at t = 0.08")
    assert found.stray == ()


def test_hanging_pendulum_reaches_pi():
    found = certify(TOP.motion(theta=2.0, omega3=0.0), TIMES)
    assert found.ways == ("Euler", "exact")
    assert found.left_out["Hamilton"].startswith("θ comes within 0.001 of π at t = ")


def test_near_the_upright_but_not_in_it():
    theta, spin = 0.5, 5.0
    phi_dot = (0.5 * spin * (1 - math.cos(theta)) + 0.02) / math.sin(theta) ** 2
    motion = TOP.motion(theta=theta, theta_dot=-6.0, phi_dot=phi_dot, omega3=spin)
    found = certify(motion, np.linspace(0, 5, 11))
    assert found.ways == OF_TOP
    assert found.passed


def test_one_way_alone_does_not_pass():
    found = certify(BRICK.motion(omega=(1.0, 2.0, 3.0)), [0.0, 1.0])
    assert found.ways == ("Euler",)
    assert not found.passed
    assert found.left_out["exact"].startswith("no closed form")
    assert found.left_out["Routh"].startswith("ψ is not cyclic")


def test_a_body_at_rest():
    found = certify(rt.FreeBody(1.0, 2.0, 2.5).motion(omega=(0, 0, 0)), TIMES)
    assert found.passed
    assert found.largest < 1e-15


@pytest.mark.parametrize(("rtol", "message"), [(1e-15, "at least"), (0.5, "at most")])
def test_bad_tolerances(rtol, message):
    with pytest.raises(rt.RigidtopError, match=f"^rtol must be {message}"):
        certify(EXAMPLE, TIMES, rtol=rtol)


def test_bad_times():
    with pytest.raises(rt.RigidtopError, match=r"^t must be finite"):
        certify(EXAMPLE, [0.0, math.nan])


@pytest.mark.parametrize("name", ["example", "cusps", "free", "flip"])
def test_observed_orders_are_the_classical_ones(name):
    measured, reasons = orders(MOTIONS[name][0])
    assert reasons == {}
    assert [order.method for order in measured] == ["RK23", "RK45", "DOP853", "Radau"]
    for order, classical in zip(measured, (3, 5, 8, 5), strict=True):
        assert order.classical == classical
        assert order.observed == pytest.approx(classical, abs=0.3)
        assert order.steps[1] == 2 * order.steps[0]
        assert order.errors[0] > order.errors[1]


def test_orders_that_cannot_be_seen_have_a_reason():
    measured, reasons = orders(rt.FreeBody(1.0, 2.0, 2.5).motion(omega=(0, 0, 0)))
    assert measured == ()
    assert set(reasons.values()) == {"nothing moves"}
    _, reasons = orders(BRICK.motion(omega=(1.0, 2.0, 3.0)))
    assert reasons["order of RK45"].startswith("no closed form")


def test_orders_that_change_are_left_out():
    assert {"BDF", "LSODA", "taylor"} <= set(certify(EXAMPLE, 1.0).left_out)
