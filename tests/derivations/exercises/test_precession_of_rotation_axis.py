"""Section 3.2.3, with the Earth and the plate."""

from math import acos, cos, hypot, pi, sin, sqrt, tan

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

from rigidtop.errors import RigidtopError
from rigidtop.typeset.words import unmarked


def body_path(moments, omega, times):
    """ω in the body by (3.36), with a method and a right side of its own."""
    i1, i2, i3 = moments

    def rates(_, w):
        return [
            (i2 - i3) / i1 * w[1] * w[2],
            (i3 - i1) / i2 * w[2] * w[0],
            (i1 - i2) / i3 * w[0] * w[1],
        ]

    path = solve_ivp(rates, (0, times[-1]), omega, "LSODA", times, rtol=1e-11, atol=1e-13)
    return path.y.T


# --- cone-plane ---


@pytest.mark.parametrize("lambda3", [0.2, 1.5, 2.6])
def test_widest_angle_is_a_maximum(solve, lambda3):
    """Against a search over all tilts."""

    def between(tilt):
        a = np.array([sin(tilt), cos(tilt)])
        b = np.array([1.3, lambda3]) * a
        return acos(a @ b / np.linalg.norm(a) / np.linalg.norm(b))

    best = minimize_scalar(lambda x: -between(x), bounds=(0.01, 1.56), options={"xatol": 1e-10})
    found = solve("cone-plane", lambda3=lambda3, lambda2=1.4)
    assert found["widest"] == pytest.approx(-best.fun, rel=1e-9)
    assert found["widest_at"] == pytest.approx(best.x, abs=1e-5)


def test_widest_angle_of_a_flat_body(solve):
    """A plate, λ₃ = 2λ₁: 19.47°, a third as sine."""
    found = solve("cone-plane", lambda3=2.6, lambda2=1.4)
    assert np.degrees(found["widest"]) == pytest.approx(19.471, abs=1e-3)


def test_angles_of_ω_and_L(solve):
    """From scalar products, both signs of λ₁ − λ₃."""
    for lambda3, nearest in ((0.7, "ω"), (2.0, "L")):
        found = solve("cone-plane", lambda3=lambda3)
        omega, momentum = np.array([0.6, 0, 2]), np.array([1.3 * 0.6, 0, lambda3 * 2])
        cosine = omega @ momentum / np.linalg.norm(omega) / np.linalg.norm(momentum)
        assert found["omega_L"] == pytest.approx(acos(cosine), rel=1e-9)
        assert unmarked(found["nearest"]) == nearest
        apart = found["e3_L"] - found["e3_omega"]
        assert abs(apart) == pytest.approx(found["omega_L"], rel=1e-14)


@pytest.mark.parametrize("given", [{"lambda3": 1.3}, {"omega_0": 1e-9}, {"omega3": 1e-9}])
def test_parallel_vectors_span_no_plane(solve, given):
    with pytest.raises(RigidtopError, match="span no plane"):
        solve("cone-plane", **given)


# --- space-rate ---


@pytest.mark.parametrize("lambda3", [0.2, 0.7, 1.3, 2.6])
def test_cones_of_any_shape(solve, lambda3):
    """Ω_s by e₃'s speed over its distance from L; Ω_b by ω̇₁ = Ω_b ω₂ after a quarter of a turn."""
    found = solve("space-rate", lambda3=lambda3)
    assert all(measure.passed for measure in found.measures)
    omega, momentum = np.array([0.6, 0, 2]), np.array([1.3 * 0.6, 0, lambda3 * 2])
    speed = np.linalg.norm(np.cross(omega, [0, 0, 1]))
    distance = np.linalg.norm(np.cross([0, 0, 1], momentum)) / np.linalg.norm(momentum)
    assert found["Omega_s"] == pytest.approx(speed / distance, rel=1e-13)
    if lambda3 != 1.3:
        assert found["period_body"] == pytest.approx(2 * pi / abs(found["Omega_b"]))
        quarter = found["period_body"] / 4
        turned = body_path((1.3, 1.3, lambda3), (0.6, 0, 2), np.array([0, quarter]))[-1]
        sign = -1 if lambda3 < 1.3 else 1
        assert turned == pytest.approx([0, sign * 0.6, 2], abs=1e-8)
    rolled = abs(found["Omega_b"]) * sin(found["body_cone"])
    assert rolled == pytest.approx(found["Omega_s"] * sin(found["space_cone"]), rel=1e-12)


def test_a_ball_only_spins(solve):
    found = solve("space-rate", lambda3=1.3)
    assert found["Omega_b"] == 0
    assert found["space_cone"] == pytest.approx(0, abs=1e-15)
    assert found["kind"] == "not at all"
    assert found["Omega_s"] == pytest.approx(hypot(0.6, 2), rel=1e-14)


def test_flat_body_within(solve):
    assert solve("space-rate", lambda3=2.0)["kind"] == "around the space cone"
    assert solve("space-rate", lambda3=0.7)["kind"] == "on the space cone"


# --- the Earth ---


def test_euler_period_of_the_earth(solve):
    """Goldstein, Classical Mechanics §5.6: 306 days with (C − A)/A = 0.00327.

    And from moments: Yoder 1995 (Global Earth Physics) has A = 8.0101, C = 8.0365 in 10³⁷ kg m².
    """
    found = solve("earth-euler-period")
    assert found["turns"] == pytest.approx(8.0101 / (8.0365 - 8.0101), rel=5e-3)
    # A sidereal day is 86164.0989 s (to the equinox, or 86164.0905 s).
    assert found["period"] == pytest.approx(found["turns"] * 86164.1 / 86400, rel=1e-6)
    older = solve("earth-euler-period", H=0.00327 / 1.00327)
    assert older["turns"] == pytest.approx(306, abs=0.3)


def test_polar_motion_of_a_tenth_of_a_second(solve):
    """One second of arc is 30.8 m on the ground (1′ is a nautical mile, 1852 m, to 1 in 200)."""
    found = solve("earth-euler-period")
    assert found["ground"] == pytest.approx(1852 / 600, rel=5e-3)


def test_the_earth_in_space(solve):
    """The speed of e₃ over its distance from L, and a scalar product; bulge and tilt are large."""
    found = solve("earth-euler-period", H=0.2, angle=0.1)
    omega = 7.292115e-5 * np.array([tan(0.1), 0, 1])
    momentum = omega * np.array([0.8, 0.8, 1])
    unit = momentum / np.linalg.norm(momentum)
    rate = np.linalg.norm(np.cross(omega, [0, 0, 1])) / np.linalg.norm(np.cross(unit, [0, 0, 1]))
    assert found["space_period"] == pytest.approx(2 * pi / rate / 86400, rel=1e-12)
    assert found["space_cone"] == pytest.approx(
        acos(omega @ unit / np.linalg.norm(omega)), rel=1e-9
    )


def test_share_of_the_bulge_is_a_ratio_of_love_numbers(solve):
    """The share is k₂/k_s; the secular number is k_s = 3GMJ₂/(a³Ω²) (IERS Conventions 2010).

    From Chandler's period k₂ = 0.28: Munk & MacDonald, The Rotation of the Earth (1960).
    """
    secular = 3 * 3.986004418e14 * 1.0826359e-3 / (6378136.6**3 * 7.292115e-5**2)
    assert solve("earth-euler-period")["share"] * secular == pytest.approx(0.28, abs=0.01)


def test_rigid_earth_needs_no_share(solve):
    period = solve("earth-euler-period")["period"]
    assert solve("earth-euler-period", observed=period)["share"] == pytest.approx(0, abs=1e-14)


def test_a_bulge_that_follows_never_shortens_the_period(solve):
    with pytest.raises(RigidtopError, match=r"observed = 200 must be at least .* 303\.625 days"):
        solve("earth-euler-period", observed=200)


# --- the plate ---


def test_flat_plate_wobbles_twice_as_fast(solve):
    """Chao 1989, Physics Today 42(2):15; also Tuleja, Gazovic, Tomori & Hanc 2007, AJP 75:240."""
    found = solve("wobbling-plate", theta=1e-4, thickness=1e-7)
    assert found["ratio"] == pytest.approx(2, rel=1e-7)
    assert found["wobble_to_mark"] == pytest.approx(2, rel=1e-7)


def test_thick_plate_and_long_rod(solve):
    """λ₃ = λ₁ at h = √3 r, where a cylinder is as round as a ball; a rod wobbles slowly."""
    found = solve("wobbling-plate", theta=1e-4, radius=1, thickness=sqrt(3))
    assert found["moments"] == pytest.approx(1, rel=1e-14)
    assert found["ratio"] == pytest.approx(1, rel=1e-7)
    assert solve("wobbling-plate", radius=0.01, thickness=1)["ratio"] < 0.001
