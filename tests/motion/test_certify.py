"""The ways to one motion agree, and a wrong one is seen."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.motion import certify as module
from rigidtop.motion import equations
from rigidtop.motion.certify import certify

TOP = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
EXAMPLE = TOP.motion(theta=0.5, theta_dot=0.1, phi_dot=1.0, psi_dot=40.0)
BRICK = rt.HeavyBody(3.0, 2.0, 1.5, M=1.0, centre_of_mass=(0.2, 0.3, 0.4))
TILTED = Rotation.from_euler("y", 1.0)
TIMES = np.linspace(0, 10, 21)
OF_TOP = ("exact", "Lagrange", "Routh", "Hamilton")
OF_BODY = ("exact", "Lagrange", "Hamilton")

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
        ("Lagrange", "Hamilton"),
    ),
}


@pytest.mark.parametrize("name", MOTIONS)
def test_ways_agree(name):
    motion, ways = MOTIONS[name]
    certificate = certify(motion, TIMES)
    assert tuple(certificate.differences) == ways
    assert certificate.passed
    assert not certificate.strays
    for way, apart in certificate.differences.items():
        assert apart < (1e-9 if way == "exact" else 1e-14)
    assert set(certificate.drifts) == {"Euler", *{"exact"} & {*ways}}
    drifts = certificate.drifts.values()
    assert max(value for drift in drifts for value in drift.values()) < 1e-10


def test_before_and_after_in_any_order():
    certificate = certify(EXAMPLE, [3.0, -2.0, 0.0, 0.5])
    assert tuple(certificate.differences) == OF_TOP
    assert max(certificate.differences.values()) < 1e-10


def test_at_the_start_alone():
    certificate = certify(EXAMPLE, 0.0)
    assert tuple(certificate.differences) == OF_TOP
    assert max(certificate.differences.values()) < 1e-14


def test_what_is_kept_is_named():
    def kept(name, way):
        return set(certify(MOTIONS[name][0], 1.0).drifts[way])

    assert kept("example", "Euler") == {"energy", "p_phi", "p_psi"}
    assert kept("without weight", "exact") == {"energy", "p_phi", "p_psi", "L"}
    assert kept("free", "exact") == {"energy", "p_phi", "L"}
    assert kept("heavy", "Euler") == {"energy", "p_phi"}


def with_sign_changed(make, entry):
    """The equations with one rate of the opposite sign."""

    def changed(*parameters, **functions):
        rates = make(*parameters, **functions)
        return lambda state: tuple(-x if k == entry else x for k, x in enumerate(rates(state)))

    return changed


@pytest.mark.parametrize(
    ("name", "equation", "way", "entries"),
    [
        ("cusps", "top_in_euler_angles", "Lagrange", range(3)),
        ("cusps", "top_by_routh", "Routh", range(3)),
        ("cusps", "top_by_hamilton", "Hamilton", range(4)),
        ("free", "body_in_euler_angles", "Lagrange", range(3)),
        ("free", "body_by_hamilton", "Hamilton", range(5)),
    ],
)
def test_a_wrong_sign_is_seen_in_its_law_alone(monkeypatch, name, equation, way, entries):
    right = getattr(equations, equation)
    for entry in entries:
        monkeypatch.setattr(equations, equation, with_sign_changed(right, entry))
        certificate = certify(MOTIONS[name][0], TIMES)
        assert certificate.strays == (way,)
        assert certificate.differences[way] > 1e-3
        assert not certificate.passed
        assert not certificate.undecided


def test_a_small_error_in_a_constant_is_seen(monkeypatch):
    right = equations.top_by_hamilton
    monkeypatch.setattr(
        equations, "top_by_hamilton", lambda first, *rest, **f: right(first * 1.00001, *rest, **f)
    )
    assert certify(MOTIONS["cusps"][0], TIMES).strays == ("Hamilton",)


@pytest.mark.parametrize("entry", [4, 5, 6])
def test_a_wrong_sign_in_eulers_equations_is_seen_by_every_law(monkeypatch, entry):
    right = equations.heavy_body
    monkeypatch.setattr(equations, "heavy_body", with_sign_changed(right, entry))
    assert certify(MOTIONS["free"][0], TIMES).strays == ("Lagrange", "Hamilton")


def test_a_wrong_closed_form_is_seen(monkeypatch):
    motion = MOTIONS["free"][0]
    near = rt.FreeBody(1.00001, 2.0, 2.5).motion(omega=motion.omega)
    monkeypatch.setattr(type(motion), "exact", lambda _, t, right=near.exact: right(t))
    assert certify(motion, TIMES).strays == ("exact",)


def test_what_the_solver_itself_may_do_is_not_decided():
    flip = MOTIONS["flip"][0]
    early, late = certify(flip, 100.0, rtol=1e-9), certify(flip, 400.0, rtol=1e-7)
    assert early.passed
    assert not early.undecided
    # Errors of either sign add up as the root of what errors of one sign add up to.
    assert early.reach / early.bounds["exact"] == pytest.approx(math.sqrt(1 + 100 * flip.rate))
    assert late.bounds["exact"] == module.LOOSEST
    assert late.bounds["exact"] < late.differences["exact"] < late.reach
    assert late.undecided
    assert not late.passed
    # What is farther off, or beside a wrong law, is wrong and not undecided.
    far = {**late.differences, "exact": 2 * late.reach}
    assert not replace(late, differences=far).undecided
    assert not replace(late, differences={**late.differences, "Lagrange": 1.0}).undecided


def test_a_difference_that_is_no_number_does_not_pass():
    certificate = certify(EXAMPLE, 1.0)
    assert certificate.passed
    unknown = {**certificate.differences, "Routh": math.nan}
    assert not replace(certificate, differences=unknown).passed


def test_a_top_that_stands_upright_has_no_euler_angles():
    certificate = certify(TOP.motion(theta=0.0, omega3=40.0), TIMES)
    assert tuple(certificate.differences) == ("exact",)
    assert certificate.passed
    for way in ("Lagrange", "Routh", "Hamilton"):
        assert certificate.left_out[way] == (
            "sin θ stays below 0.001: Euler angles are not defined there"
        )


@pytest.mark.parametrize("theta_dot", [0.3, -6.0])
def test_a_motion_through_the_upright_is_compared_elsewhere(theta_dot):
    motion = TOP.motion(theta=0.0, theta_dot=theta_dot, omega3=5.0)
    certificate = certify(motion, TIMES)
    assert tuple(certificate.differences) == OF_TOP
    assert certificate.passed


def test_one_way_alone_does_not_pass():
    certificate = certify(BRICK.motion(omega=(1.0, 2.0, 3.0)), 0.0)
    assert not certificate.differences
    assert not certificate.passed
    assert not certificate.undecided
    assert certificate.left_out["exact"].startswith("no closed form")


def test_a_body_at_rest():
    certificate = certify(rt.FreeBody(1.0, 2.0, 2.5).motion(omega=(0, 0, 0)), TIMES)
    assert certificate.passed
    assert certificate.differences == {"exact": 0.0}


@pytest.mark.parametrize(("rtol", "message"), [(1e-15, "at least"), (0.5, "at most")])
def test_bad_tolerances(rtol, message):
    with pytest.raises(rt.RigidtopError, match=f"^rtol must be {message}"):
        certify(EXAMPLE, TIMES, rtol=rtol)


def test_bad_times():
    with pytest.raises(rt.RigidtopError, match=r"^t must be finite"):
        certify(EXAMPLE, [0.0, math.nan])
