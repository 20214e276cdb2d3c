"""What the figures show, read from what they drew, against facts found in another way."""

import math

import numpy as np
import pytest
from matplotlib.figure import Figure as Canvas

import rigidtop as rt
from rigidtop.figures import (
    cones,
    falling,
    free,
    nutation,
    potential,
    precession,
    rotations,
    tops,
)
from rigidtop.figures.catalog import named
from rigidtop.motion.attitude import from_euler_angles
from rigidtop.typeset.words import unmarked

from .conftest import line

TOP = rt.HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1, g=9.81)
WEIGHT = 0.981


# --- Steady precession ---------------------------------------------------------------------------


@pytest.mark.parametrize("theta", [0.3, math.pi / 3, 2.0])
def test_precession_rates_solve_the_quadratic(axes, theta):
    precession.draw_precession_rates(axes, TOP, theta, 40.0)
    for label in ("_slow", "_fast"):
        spin, rate = line(axes, label).T
        rest = TOP.lambda1 * math.cos(theta) * rate**2 - TOP.lambda3 * spin * rate + WEIGHT
        assert np.abs(rest).max() < 1e-9
    least = 2 * math.sqrt(TOP.lambda1 * WEIGHT * max(math.cos(theta), 0)) / TOP.lambda3
    assert line(axes, "_slow")[0, 0] == pytest.approx(least, abs=1e-3)


def test_asymptotics_are_of_the_first_and_of_the_second_order(axes):
    precession.draw_asymptotics(axes, TOP, math.pi / 3, 40.0)
    curves = [np.asarray(each.get_xydata()) for each in axes.lines if len(each.get_xdata()) == 240]
    assert len(curves) == 4
    for curve, power, factor in zip(curves, (1, 1, 2, 2), (1, 1, 2, 1), strict=True):
        epsilon, error = curve[:40].T  # u² − u + ε = 0 with u = ε(1 + ε + 2ε² …) and 1 − ε − ε² …
        assert error == pytest.approx(factor * epsilon**power, rel=0.01)


def test_angle_between_momentum_and_velocity(axes):
    precession.draw_parallel(axes, TOP, math.pi / 3, 150.0)
    t, angle = np.asarray(axes.lines[0].get_xydata()).T
    run = TOP.motion(theta=math.pi / 3, omega3=150.0).integrate(t[::40], rtol=1e-11, atol=1e-13)
    momentum, omega = run.angular_momentum, run.omega_space
    cosine = np.sum(momentum * omega, axis=1) / (
        np.linalg.norm(momentum, axis=1) * np.linalg.norm(omega, axis=1)
    )
    assert np.cos(np.radians(angle[::40])) == pytest.approx(cosine, abs=1e-12)
    assert angle.max() == pytest.approx(axes.lines[1].get_ydata()[0], rel=0.02)


def test_the_bound_on_the_angle_is_never_crossed():
    drawing = named("parallel")
    draws = np.random.default_rng(7)
    near = []
    for _ in range(10):
        about_centre, lambda3, spin, weight = 10 ** draws.uniform(-2, 2, 4)
        arm = 10 ** draws.uniform(-2, 1)
        given = {
            "lambda1": max(about_centre, lambda3 / 2) + arm**2,
            "lambda3": lambda3,
            "M": 1.0,
            "R": arm,
            "g": weight / arm,
            "theta": draws.uniform(0, math.pi),
            "omega3": spin,
        }
        panel = Canvas().subplots()
        top = rt.HeavyTop(**{name: given[name] for name in ("lambda1", "lambda3", "M", "R", "g")})
        precession.draw_parallel(panel, top, given["theta"], spin)
        [bound] = {float(y) for y in line(panel, "_bound")[:, 1]}
        t, angle = line(panel, "_angle").T
        assert angle.max() <= bound * (1 + 1e-9), given
        # By the vectors of an integrated motion, and without turning points.
        run = top.motion(theta=given["theta"], omega3=spin).integrate(t[::100])
        momentum, omega = run.angular_momentum, run.omega_space
        crossed = np.linalg.norm(np.cross(momentum, omega), axis=1)
        tangent = crossed / np.sum(momentum * omega, axis=1)
        assert angle[::100] == pytest.approx(np.degrees(np.arctan(tangent)), abs=0.01)
        assert bound >= np.degrees(np.arctan(tangent)).max() * (1 - 1e-6)
        near.append(angle.max() / bound)
        unmarked(drawing.caption(**given))
    assert max(near) > 0.99  # it is no larger than it must be


# --- Torque --------------------------------------------------------------------------------------


@pytest.mark.parametrize("theta", [0.2, math.pi / 4, 2.5])
def test_torque_is_the_rate_of_the_momentum(theta):
    motion = TOP.motion(theta=theta, phi=math.pi / 2, phi_dot=1.0, omega3=30.0)
    step = 1e-5
    before, after = motion.integrate([-step, step], rtol=1e-12, atol=1e-14).angular_momentum
    assert tops.torque(motion) == pytest.approx((after - before) / (2 * step), abs=1e-6)
    # Leaning to the right in the plane of the paper: x̂ points at the reader, N away from it.
    assert motion.start().e3[0] == pytest.approx([0, math.sin(theta), math.cos(theta)], abs=1e-15)
    assert tops.direction_of_torque(motion) == pytest.approx([-1, 0, 0], abs=1e-12)


# --- Euler's angles ------------------------------------------------------------------------------


@pytest.mark.parametrize("sequence", ["zyz", "zxz"])
@pytest.mark.parametrize("chosen", [(1.0, 0.7, 0.8), (-2.0, 2.5, 4.0), (0.0, 0.0, 0.0)])
def test_every_step_is_a_proper_rotation_about_its_axis(sequence, chosen):
    phi, theta, psi = chosen
    steps = rotations.steps(sequence, *chosen)
    quarter = math.pi / 2 if sequence == "zxz" else 0.0
    assert steps[3].as_matrix() == pytest.approx(
        from_euler_angles(theta, phi - quarter, psi + quarter).as_matrix(), abs=1e-15
    )
    for before, after, (axis, angle, _, _) in zip(
        steps, steps[1:], rotations.turns(sequence, *chosen), strict=False
    ):
        turn = (after * before.inv()).as_matrix()
        assert np.linalg.det(turn) == pytest.approx(1)
        assert turn @ axis == pytest.approx(axis, abs=1e-15)
        assert np.trace(turn) == pytest.approx(1 + 2 * math.cos(angle))
    axes_turned_about = [axis for axis, _, _, _ in rotations.turns(sequence, *chosen)]
    nodes = [-math.sin(phi - quarter), math.cos(phi - quarter), 0]
    assert axes_turned_about[0] == pytest.approx([0, 0, 1])
    assert axes_turned_about[1] == pytest.approx(nodes, abs=1e-15)
    assert axes_turned_about[2] == pytest.approx(steps[3].as_matrix()[:, 2], abs=1e-15)


# --- Cones ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("lambda3", [0.5, 1.7])
def test_cones_touch_along_omega(lambda3):
    motion = cones.free_motion(1.0, lambda3, 0.7, 1.0)
    body, about_l = cones._half_angles(motion)
    assert math.tan(body) == pytest.approx(0.7)
    lean = math.atan2(0.7, lambda3)  # tan of e₃L is λ₁ω₀/(λ₃ω₃)
    # Outside each other, or the one within the other.
    assert lean == pytest.approx(body + about_l if lambda3 < 1 else body - about_l)
    run = motion.exact(np.linspace(0, 9, 40))
    omega = run.omega_space / np.linalg.norm(run.omega_space, axis=1)[:, None]
    momentum = run.angular_momentum / np.linalg.norm(run.angular_momentum, axis=1)[:, None]
    assert np.sum(omega * momentum, axis=1) == pytest.approx(math.cos(about_l))
    assert np.sum(omega * run.e3, axis=1) == pytest.approx(math.cos(body))
    assert np.linalg.det(np.stack([omega, momentum, run.e3], axis=1)) == pytest.approx(0, abs=1e-12)


# --- Free bodies ---------------------------------------------------------------------------------

BODY = rt.FreeBody(1.0, 2.0, 2.9)


def test_polhodes_are_closed_and_keep_energy_and_momentum():
    moments = np.array(BODY.moments)
    found = free.polhodes(BODY)
    assert len(found) == 16
    assert {motion.regime for motion in found} == {"long axis", "short axis"}
    for motion in found:
        omega = free.polhode(motion)
        assert omega**2 @ moments == pytest.approx(1, abs=1e-12)
        momentum = omega**2 @ moments**2
        assert momentum == pytest.approx(momentum[0], abs=1e-12)
        assert omega[-1] == pytest.approx(omega[0], abs=1e-9)
        middle = omega[len(omega) // 2]
        assert np.abs(middle - omega[0]).max() > 0.05  # once round, not twice


def test_the_separatrix_goes_through_the_middle_axis():
    found = free.on_separatrix(BODY)
    assert [motion.regime for motion in found] == ["separatrix"] * 4
    ends = []
    for motion in found:
        omega = free.polhode(motion)
        assert omega**2 @ np.square(BODY.moments) == pytest.approx(2.0, abs=1e-12)  # L² = 2Tλ₂
        assert np.abs(omega[[0, -1]][:, [0, 2]]).max() < 1e-4
        ends += [*omega[[0, -1]][:, 1]]
    assert np.abs(ends) == pytest.approx(1 / math.sqrt(2), abs=1e-6)


def test_polhodes_of_two_equal_moments_are_circles():
    body = rt.FreeBody(2.0, 2.0, 1.0)
    assert free.on_separatrix(body) == []
    for motion in free.polhodes(body):
        assert motion.regime == "regular precession"
        assert np.ptp(free.polhode(motion)[:, 2]) < 1e-12
    with pytest.raises(rt.RigidtopError, match="three equal moments"):
        free.draw_polhodes(Canvas().subplots(), rt.FreeBody(1.0, 1.0, 1.0))


def test_flips_are_seen_at_their_period(axes):
    motion = free.flip(1.0, 2.0, 2.9, 2.0, 0.01)
    free.draw_rates(axes, motion, free._flip_times(motion))
    t, middle = np.asarray(axes.lines[1].get_xydata()).T
    changes = t[np.flatnonzero(middle[:-1] * middle[1:] < 0)]
    assert np.diff(changes) == pytest.approx(motion.nutation_period, abs=2 * (t[1] - t[0]))
    later = motion.integrate(t[::200], rtol=1e-11, atol=1e-13).omega
    shown = np.column_stack([axes.lines[k].get_ydata()[::200] for k in range(3)])
    assert shown == pytest.approx(later, abs=1e-6)


def test_flip_wants_a_middle_axis():
    drawing = named("flip")
    with pytest.raises(rt.RigidtopError, match="three different moments"):
        drawing.draw(**drawing.values({"lambda2": 1.0, "lambda3": 1.5}))


@pytest.mark.parametrize("kick", [6.0, 15.0, 1e-9])
def test_a_flip_wants_a_small_kick(kick):
    drawing = named("flip")
    with pytest.raises(rt.RigidtopError, match="kick must be less than omega = 6 and at least"):
        unmarked(drawing.caption(**drawing.values({"kick": kick})))


def test_tumbling_keeps_the_length_of_the_momentum():
    left, right = Canvas().subplots(1, 2)
    drawing = named("tumbling")
    motion = free._tumbling(**drawing.values())
    free.draw_tumbling(left, right, motion)
    assert motion.regime == "long axis"
    # 5.4 days about the long axis, 7.4 days about L: Ostro et al. 1995.
    assert 2 * motion.nutation_period / free.DAY == pytest.approx(5.4, abs=0.05)
    assert 2 * math.pi / abs(motion.mean_precession) / free.DAY == pytest.approx(7.4, abs=0.05)
    path = next(each for each in left.lines if each.get_label() == "_momentum")
    assert np.nanmax(np.hypot(*np.asarray(path.get_xydata()).T)) <= 1 + 1e-9


# --- Nutation ------------------------------------------------------------------------------------


def test_paths_are_waves_cusps_and_loops():
    drawing = named("paths")
    shapes = {}
    for motion in nutation._paths(**drawing.values()):
        e3 = motion.integrate(nutation.nutation_times(motion), rtol=1e-10).e3
        steps = np.diff(np.unwrap(np.arctan2(e3[:, 1], e3[:, 0])))
        shapes[motion.regime] = steps.min() / steps.max()
    assert shapes["waves"] > 0.01
    assert abs(shapes["cusps"]) < 0.01
    assert shapes["loops"] < -0.1


def test_effective_potential_is_the_energy_at_rest(axes):
    motion = TOP.motion(theta=1.1, phi_dot=2.0, omega3=30.0)
    potential.draw_effective_potential(axes, motion)
    start = motion.start()
    constant = start.p_psi[0] ** 2 / (2 * TOP.lambda3)
    at, value = line(axes, "_energy").T
    assert value == pytest.approx(start.energy[0] - constant, rel=1e-12)
    assert np.radians(at) == pytest.approx(motion.turning_points, abs=1e-12)
    u = potential.effective_potential(TOP, np.radians(at), start.p_phi[0], start.p_psi[0])
    assert u == pytest.approx(value, rel=1e-9)
    theta, curve = line(axes, "_potential").T
    below = (theta > at[0]) & (theta < at[1])
    assert np.all(curve[below] <= value[0] + 1e-12)
    assert np.all(curve[~below] >= value[0] - 1e-12)


def test_energies_add_up(axes):
    motion = TOP.motion(theta=1.0, theta_dot=1.0, phi_dot=2.0, omega3=30.0)
    times = np.linspace(0, 1, 50)
    nutation.draw_energies(axes, motion, times)
    kinetic, height, energy = (each.get_ydata() for each in axes.lines)
    assert kinetic + height == pytest.approx(energy, abs=1e-12)
    run = motion.integrate(times, rtol=1e-11, atol=1e-13)
    across = (run.theta_dot**2 + run.v_phi**2) * TOP.lambda1 / 2
    assert kinetic == pytest.approx(across, abs=1e-8)
    assert height == pytest.approx(WEIGHT * np.cos(run.theta), abs=1e-8)


def test_the_map_shows_the_regimes_of_single_motions(axes):
    theta = math.pi / 3
    nutation.draw_regimes(axes, TOP, theta, 60.0, 30.0)
    [loops] = [each for each in axes.collections if each.hatches and any(each.hatches)]
    draws = np.random.default_rng(1)
    regimes = set()
    for spin, rate in zip(draws.uniform(1, 59, 60), draws.uniform(-29, 29, 60), strict=True):
        regime = TOP.motion(theta=theta, phi_dot=rate, omega3=spin).regime
        inside = any(path.contains_point((spin, rate)) for path in loops.get_paths())
        assert inside == (regime == "loops"), (spin, rate)
        regimes.add(regime)
    assert regimes == {"waves", "loops"}


def test_lines_of_the_map_are_cusps_and_steady(axes):
    theta = math.pi / 3
    nutation.draw_regimes(axes, TOP, theta, 60.0, 30.0)
    for name, regime, count in (
        ("_cusps", "cusps", 2),
        ("_vertical", "through the vertical", 2),
    ):
        lines = [each for each in axes.lines if each.get_label() == name]
        assert len(lines) == count
        for points in (each.get_xydata() for each in lines):
            along = np.linspace(points[0], points[-1], 5) if len(points) == 2 else points[::40]
            for spin, rate in along[1:]:
                assert TOP.motion(theta=theta, phi_dot=rate, omega3=spin).regime == regime
    steady = line(axes, "_steady")
    for spin, rate in steady[10::60]:
        assert TOP.motion(theta=theta, phi_dot=rate, omega3=spin).regime == "steady"


# --- Falls ---------------------------------------------------------------------------------------


def test_time_to_fall_is_an_elliptic_integral():
    from scipy.integrate import quad

    motion = falling._toppling(theta=0.3, lambda1=0.02, M=1.0, R=0.1, g=9.81)

    def slowness(u):  # θ = θ₀ + u², so that the integrand is finite
        drop = 2 * WEIGHT / 0.02 * (math.cos(0.3) - math.cos(0.3 + u * u))
        return 2 * u / math.sqrt(drop)

    expected, _ = quad(slowness, 0.0, math.sqrt(math.pi / 2 - 0.3), epsabs=1e-12)
    assert falling.time_to_fall(motion) == pytest.approx(expected, rel=1e-9)


def test_the_sleeping_top_wakes_below_its_spin(axes):
    falling.draw_sleeping(axes, TOP, math.radians(2), 22.0)
    spin, largest = line(axes, "_largest").T
    assert largest[spin < 0.95 * TOP.sleeping_spin()].min() > 25
    assert largest[spin > 1.5 * TOP.sleeping_spin()].max() < 2.7
    at = int(np.argmin(np.abs(spin - 20)))
    run = TOP.motion(theta=math.radians(2), omega3=spin[at]).integrate(np.linspace(0, 3, 2000))
    assert np.degrees(run.theta.max()) == pytest.approx(largest[at], abs=0.05)
