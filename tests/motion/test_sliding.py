"""A top on a table: limits, integrals, the budget of its energy, and a second computation."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.motion.table.contact import Contact

BODY = {"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "R": 0.5}
START = {"theta": 0.5, "theta_dot": 0.1, "phi_dot": 1.0, "omega3": 40.0}
TIGHT = {"rtol": 1e-12, "atol": 1e-14}

RADIUS, SHIFT = 0.02, 0.3
TIPPE_TOP = rt.SlidingTop(
    lambda1=131 / 350 * 0.02 * RADIUS**2,
    lambda3=0.4 * 0.02 * RADIUS**2,
    M=0.02,
    R=RADIUS * (1 - SHIFT),
    tip=RADIUS,
    viscosity=0.3 * 0.02 * 9.81,
    fall=math.pi,
)
"""The one of Ciocci, Malengier, Langerock and Grimonprez: friction μNv with μ = 0.3 s/m."""


def top(**changes):
    return rt.SlidingTop(**(BODY | changes))


# --- The same motion computed once more ----------------------------------------------------------


def cross(a, b):
    """np.cross of two vectors takes thirty times as long."""
    return np.array(
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    )


def by_rotation_matrix(body, motion, times, epsilon=0.0):
    """θ, slip and X, Y from Newton and Euler with R and ω in space components.

    N is found from what the height does with N = 0 and N = 1; nothing is shared with rigidtop.
    Coulomb friction is smeared out over slips of `epsilon`.
    """
    across = np.array([1.0, 1.0, 0.0])
    z = np.array([0.0, 0.0, 1.0])
    h = body.R - body.tip

    def parts(y):
        R, omega, V = y[:9].reshape(3, 3), y[9:12], np.array([*y[12:14], 0.0])
        e = R[:, 2]
        e_dot = cross(omega, e)
        V[2] = h * e_dot[2]
        return R, omega, V, e, e_dot, -h * e - body.tip * z

    def rates(_, y):
        R, omega, V, e, e_dot, rho = parts(y)
        inertia = R @ np.diag(body.moments) @ R.T
        slip = (V + cross(omega, rho)) * across
        size = math.sqrt(slip @ slip + epsilon**2)
        drag_torque = R @ (-np.array([body.drag1, body.drag1, body.drag3]) * (R.T @ omega))

        def accelerations(N):
            coulomb = body.mu * N / size if body.mu else 0.0
            force = N * z - (coulomb + body.viscosity) * slip
            torque = cross(rho, force) + drag_torque
            turning = np.linalg.solve(inertia, torque - cross(omega, inertia @ omega))
            rising = h * (cross(turning, e) + cross(omega, e_dot))[2]
            linear = (force - body.drag * V) / body.M - body.g * z
            return turning, linear, linear[2] - rising

        without, pull = accelerations(0.0)[2], accelerations(1.0)[2]
        turning, linear, _ = accelerations(without / (without - pull))
        R_dot = np.column_stack([cross(omega, column) for column in R.T])
        return np.concatenate([R_dot.ravel(), turning, linear[:2], V[:2]])

    R0 = motion.attitude.as_matrix()
    start = np.concatenate([R0.ravel(), R0 @ np.array(motion.omega), motion.velocity, np.zeros(2)])
    method = "Radau" if epsilon else "DOP853"
    found = solve_ivp(
        rates, (0, times[-1]), start, method, times, rtol=1e-7 if epsilon else 1e-12, atol=1e-13
    )
    assert found.success
    slips = []
    for y in found.y.T:
        _, omega, V, _, _, rho = parts(y)
        slips.append((V + cross(omega, rho))[:2])
    theta = np.arctan2(np.hypot(found.y[2], found.y[5]), found.y[8])
    return theta, np.array(slips), found.y[14:].T, found.y[:9].T.reshape(-1, 3, 3)


def differences(path, other):
    theta, slip, centre, matrices = other
    turned = path.rotation.inv() * Rotation.from_matrix(matrices)
    return [
        np.abs(path.theta - theta).max(),
        np.abs(path.slip - slip).max(),
        np.abs(path.centre - centre).max(),
        turned.magnitude().max(),
    ]


@pytest.mark.parametrize(
    "changes",
    [
        {"tip": 0.1, "viscosity": 0.7},
        {"tip": 0.8, "viscosity": 0.3, "drag": 0.2, "drag1": 0.05, "drag3": 0.1},
    ],
)
def test_second_computation_agrees_where_nothing_sticks(changes):
    body = top(**changes)
    motion = body.motion(**START, phi=0.3, psi=0.7, velocity=(0.2, -0.1))
    times = np.linspace(0, 2, 21)
    other = by_rotation_matrix(body, motion, times)
    assert max(differences(motion.integrate(times, **TIGHT), other)) < 1e-9
    wrong = replace(body, tip=body.tip + 1e-5)
    assert max(differences(replace(motion, body=wrong).integrate(times), other)) > 1e-7


@pytest.mark.parametrize(
    ("changes", "start", "kinds", "end"),
    [
        ({"mu": 0.3, "tip": 0.1}, {"theta": 0.3, "omega3": 60.0}, ["standstill"], 1.0),
        ({"mu": 0.2}, {"theta": 0.3, "omega3": 5.0, "slip": (0, 0)}, ["slip"], 1.2),
    ],
)
def test_coulomb_friction_is_the_limit_of_a_smeared_one(changes, start, kinds, end):
    """Through standstill and slip: the difference falls with the slip that smears it out."""
    body = top(**changes)
    motion = body.motion(**start)
    times = np.linspace(0, end, 13)
    path = motion.integrate(times, **TIGHT)
    assert [event.kind for event in path.events] == kinds
    assert len(path.t) == len(times)
    coarse, fine = (
        max(differences(path, by_rotation_matrix(body, motion, times, epsilon=epsilon)))
        for epsilon in (2e-4, 2e-5)
    )
    assert fine < 5e-3
    assert 5 < coarse / fine < 14


# --- Infinite grip -------------------------------------------------------------------------------


HELD = rt.HeavyTop(lambda1=1.25, lambda3=0.5, M=1.0, R=0.5)  # about the pivot: λ₁ + MR²


def test_sharp_tip_that_grips_is_a_fixed_pivot():
    times = np.linspace(0, 10, 101)
    path = top(mu=5.0).motion(**START, slip=(0, 0)).integrate(times, **TIGHT)
    held = HELD.motion(**START).exact(times)
    assert path.rolling.all()
    assert path.events == ()
    for name in ("theta", "phi", "psi"):
        assert getattr(path, name) == pytest.approx(getattr(held, name), abs=1e-11)
    assert path.contact == pytest.approx(np.tile(path.contact[0], (101, 1)), abs=1e-13)
    assert path.energy - path.energy[0] == pytest.approx(0, abs=1e-9)
    # The pivot's moments, not those about the centre of mass.
    other = rt.HeavyTop(lambda1=1.2, lambda3=0.5, M=1.0, R=0.5).motion(**START).exact(times)
    assert np.abs(path.theta - other.theta).max() > 1e-3


def test_strong_viscous_friction_tends_to_a_fixed_pivot():
    times = np.linspace(0, 0.7, 8)
    held = HELD.motion(**START).exact(times)

    def error(viscosity):
        motion = top(viscosity=viscosity).motion(**START, slip=(0, 0))
        path = motion.integrate(times, method="Radau", rtol=1e-9, atol=1e-11)
        return np.abs(path.theta - held.theta).max()

    errors = np.array([error(viscosity) for viscosity in (1e3, 1e4, 1e5)])
    orders = np.log10(errors[:-1] / errors[1:])
    assert orders == pytest.approx([1, 1], abs=0.05)
    assert errors[-1] < 1e-4


# --- What is kept, and what is lost --------------------------------------------------------------


COURSES = {
    "raised": (top(mu=0.3, tip=0.1), {"theta": 0.3, "omega3": 60.0}, 20.0, ["standstill"]),
    "viscous": (top(viscosity=0.5, tip=0.1), {"theta": 0.3, "omega3": 60.0}, 20.0, []),
    "falls": (
        top(mu=0.2),
        {"theta": 0.3, "omega3": 5.0, "slip": (0, 0)},
        5.0,
        ["slip", "fall"],
    ),
    "in air": (
        top(mu=0.5, tip=0.01, drag=0.05, drag1=0.02, drag3=0.01),
        {"theta": 0.2, "omega3": 40.0},
        60.0,
        ["standstill"],
    ),
    "stops in air and falls": (
        top(mu=0.5, tip=0.03, drag3=0.5),
        {"theta": 0.2, "omega3": 40.0},
        30.0,
        ["standstill", "fall"],
    ),
    "lifts off": (
        top(mu=0.3),
        {"theta": 1.2, "phi_dot": 6.0, "omega3": 20.0, "slip": (0, 0)},
        5.0,
        ["lift-off"],
    ),
    "tippe top": (TIPPE_TOP, {"theta": 0.1, "omega3": 155.0}, 10.0, []),
}


@pytest.fixture(scope="module", params=COURSES, ids=str)
def run(request):
    body, start, end, kinds = COURSES[request.param]
    return body, body.motion(**start).integrate(np.linspace(0, end, 301)), kinds


def test_budget_of_the_energy(run):
    _, path, kinds = run
    assert [event.kind for event in path.events] == kinds
    assert path.budget() < 1e-8
    rates = np.diff(path.dissipated_by_friction), np.diff(path.dissipated_by_air)
    assert all(np.all(rate >= -1e-12 * path.energy[0]) for rate in rates)
    # It can fail: a thousandth less of what is lost leaves a gap.
    lost = path.dissipated_by_friction + path.dissipated_by_air
    if lost[-1] > 1e-3 * path.energy[0]:
        less = replace(
            path,
            dissipated_by_friction=0.999 * path.dissipated_by_friction,
            dissipated_by_air=0.999 * path.dissipated_by_air,
        )
        assert less.budget() > 1e-7


def test_jelletts_integral(run):
    body, path, _ = run
    scale = abs(path.jellett[0])
    drift = np.abs(path.jellett - path.jellett[0]).max() / scale
    if body.drag1 or body.drag3:
        assert drift > 1e-2
    else:
        assert drift < 1e-8


def test_law_of_contact(run):
    """F = −(μN/|v| + γ)v where it slides, |F| ≤ μN and no slip where it rolls; N pushes."""
    body, path, _ = run
    speed = np.hypot(*path.slip.T)
    size = np.hypot(*path.friction_force.T)
    assert np.all(path.normal_force > 0)
    assert np.all(speed[path.rolling] == 0)
    assert np.all(size[path.rolling] <= body.mu * path.normal_force[path.rolling] * (1 + 1e-9))
    slides = ~path.rolling
    wanted = body.mu * path.normal_force + body.viscosity * speed
    assert size[slides] == pytest.approx(wanted[slides], rel=1e-9)
    power = np.sum(path.friction_force * path.slip, axis=1)
    assert power == pytest.approx(-size * speed, rel=1e-9, abs=1e-15)


def test_position_and_velocity_belong_together(run):
    body, path, _ = run
    assert path.position[:, 2] == pytest.approx(body.tip + (body.R - body.tip) * np.cos(path.theta))
    assert path.contact[:, 2] == pytest.approx(0, abs=1e-12)
    below = path.contact - path.position
    of_contact = path.velocity + np.cross(path.omega_space, below)
    assert of_contact == pytest.approx(
        np.column_stack([path.slip, np.zeros(len(path.t))]), abs=1e-9 * body.R * 200
    )


def test_normal_force_moves_the_centre_of_mass():
    body = top(mu=0.3, tip=0.1, drag=0.3)
    step = 1e-5
    motion = body.motion(theta=0.4, phi_dot=2.0, omega3=30.0)
    for middle in (0.1, 2.0):  # sliding and rolling
        before, here, after = (motion.integrate([middle + k * step], **TIGHT) for k in (-1, 0, 1))
        rate = (after.velocity - before.velocity)[0] / (2 * step)
        force = [*here.friction_force[0], here.normal_force[0] - body.M * body.g]
        wanted = (np.array(force) - body.drag * here.velocity[0]) / body.M
        assert rate == pytest.approx(wanted, abs=1e-6)
        assert here.rolling[0] == (middle == 2.0)


def test_friction_raises_a_fast_top_with_a_round_tip():
    """While it slips; a sharp tip that grips does not rise, and without friction none does."""
    times = np.linspace(0, 6, 601)

    def mean_tilts(**changes):
        theta = top(**changes).motion(theta=0.3, omega3=60.0).integrate(times).theta
        return theta[:100].mean(), theta[-100:].mean()

    for changes in ({"mu": 0.02}, {"viscosity": 0.1}):
        early, late = mean_tilts(tip=0.2, **changes)
        assert late < 0.95 * early
    for changes in ({"tip": 0.2}, {"mu": 3.0}):
        early, late = mean_tilts(**changes)
        assert late == pytest.approx(early, rel=0.02)


def test_tippe_top_turns_over():
    body, start, *_ = COURSES["tippe top"]
    run = body.motion(**start).integrate([0.0, 10.0])
    assert run.theta[-1] > 3.13
    # Spin about the vertical goes on in the same sense, so ω₃ changes sign.
    assert run.omega_space[-1, 2] > 0
    assert run.omega3[-1] < 0
    assert run.position[-1, 2] > run.position[0, 2]
    slow = TIPPE_TOP.motion(theta=0.1, omega3=30.0).integrate(np.linspace(0, 4, 101))
    assert slow.theta.max() < 1


# --- Sleep ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("changes", "moment"), [({"mu": 1.0}, 1.25), ({}, 1.0)], ids=["gripped", "smooth"]
)
def test_a_sleeping_top_wakes_where_it_is_unstable(changes, moment):
    """λξ̈ − iλ₃ω₃ξ̇ − MgRξ = 0 for the tilt ξ; λ about the tip where it is held, else the centre."""
    body = top(**changes)
    threshold = 2 * math.sqrt(moment * 9.81 * 0.5) / 0.5
    start = {"theta": 1e-6} | ({"slip": (0, 0)} if changes else {})
    times = np.linspace(0, 10, 1001)

    def tilt(spin):
        return body.motion(**start, omega3=spin).integrate(times, **TIGHT).theta

    assert tilt(1.01 * threshold).max() < 1.2e-5
    growing = tilt(0.95 * threshold)
    square = 9.81 * 0.5 / moment - (0.5 * 0.95 * threshold / (2 * moment)) ** 2
    late = (times > 6) & (times < 9)
    growth = np.polyfit(times[late], np.log(growing[late]), 1)[0]
    assert growth == pytest.approx(math.sqrt(square), rel=1e-3)
    assert math.sqrt(square) > 0.5


def test_air_takes_the_spin_until_it_wakes():
    drag = 1e-3
    body = top(mu=1.0, drag3=drag)
    threshold = 2 * math.sqrt(1.25 * 9.81 * 0.5) / 0.5
    start = {"theta": 1e-4, "slip": (0, 0)}
    times = np.linspace(0, 80, 4001)
    run = body.motion(**start, omega3=1.05 * threshold).integrate(times)
    asleep = run.omega3 > threshold
    assert run.omega3 == pytest.approx(1.05 * threshold * np.exp(-drag / 0.5 * run.t))
    assert run.theta[asleep].max() < 2e-3
    woken = run.omega3[np.argmax(run.theta > 1e-2)]
    assert 0.96 * threshold < woken < threshold
    assert run.theta.max() > 0.3


def test_exactly_upright_it_sleeps_for_ever():
    run = top(mu=0.3, tip=0.1, drag3=0.1).motion(theta=0, omega3=5.0).integrate([0.0, 10.0])
    assert run.theta.tolist() == [0, 0]
    assert run.omega3[1] == pytest.approx(5 * math.exp(-0.1 / 0.5 * 10))
    assert run.normal_force == pytest.approx([9.81, 9.81])
    assert run.dissipated_by_air[1] == pytest.approx(0.25 * (25 - run.omega3[1] ** 2))


# --- Changes of the contact ----------------------------------------------------------------------


def test_an_impulse_at_the_contact_is_booked_to_the_last_digit():
    body = top(tip=0.1, mu=0.4)
    contact = Contact(body)
    state = body.motion(**START, phi=0.2, velocity=(0.3, 0.1))._initial()
    energies = []
    for slip in ((state[7], state[8]), (0.0, 0.0), (0.7, -0.4)):
        values = contact.struck(state, slip)
        _, _, _, *velocity = contact.kinematics(values[:9])[:6]
        kinetic = body.M * sum(v * v for v in velocity) + np.dot(
            body.moments, np.square(values[4:7])
        )
        energies.append(kinetic / 2 + values[12])
        assert values[7:9] == pytest.approx(slip)
    assert energies == pytest.approx([energies[0]] * 3, rel=1e-13)


def test_slip_begins_where_static_friction_ends():
    run = top(mu=0.2).motion(theta=0.3, omega3=5.0, slip=(0, 0))
    [slips] = [e.time for e in run.integrate([1.2], **TIGHT).events if e.kind == "slip"]
    before, after = (run.integrate([slips + dt], **TIGHT) for dt in (-1e-7, 1e-4))
    assert before.rolling[0]
    assert not after.rolling[0]
    ratio = np.hypot(*before.friction_force[0]) / before.normal_force[0]
    assert ratio == pytest.approx(0.2, rel=1e-6)
    # No jump: friction is what it was.
    assert after.friction_force[0] == pytest.approx(before.friction_force[0], rel=1e-2)


TOY = {"lambda1": 5e-6, "lambda3": 6e-6, "M": 0.03, "R": 0.02, "tip": 0.003}
LOOSE = {"rtol": 1e-8, "atol": 1e-10}


@pytest.mark.parametrize(
    ("changes", "end", "kinds"),
    [
        ({"mu": 0.03}, 3.0, ["standstill"]),
        ({"mu": 0.2, "drag3": 1e-6}, 12.0, ["standstill", "slip", "standstill", "slip", "fall"]),
    ],
)
def test_a_slip_dies_out_below_the_tolerance_of_the_solver(changes, end, kinds):
    """It once stayed for ever at 1e-10, in steps of nanoseconds: as small as that tolerance."""
    motion = rt.SlidingTop(**TOY, **changes).motion(theta=0.35, omega3=250)
    run = motion.integrate(np.linspace(0, end, 50), **LOOSE)
    assert [event.kind for event in run.events] == kinds
    assert run.budget() < 1e-8


def test_no_tolerance_is_too_large_for_a_slip_to_end():
    motion = rt.SlidingTop(**TOY, mu=0.3).motion(theta=0.35, omega3=250)
    [best] = motion.integrate([0.5], **TIGHT).events
    for atol in (1e-8, 1e-4):
        [event] = motion.integrate([0.5], rtol=1e-6, atol=atol).events
        assert event.kind == "standstill"
        assert event.time == pytest.approx(best.time, rel=1e-3)


def test_a_slip_between_two_steps_is_seen():
    """With every nutation the tip slips for a moment, shorter than a step while it rolls."""
    body = rt.SlidingTop(
        lambda1=4.47e-5, lambda3=3.34e-5, M=0.0317, R=0.0853, tip=0.0572, mu=0.62, drag3=7.7e-7
    )
    motion = body.motion(theta=1.3, omega3=112.7)
    times = np.linspace(0, 0.8, 301)
    coarse, fine = (motion.integrate(times, **accuracy) for accuracy in (LOOSE, {}))
    assert [event.kind for event in coarse.events] == [event.kind for event in fine.events]
    assert len(fine.events) > 6
    assert [event.time for event in coarse.events] == pytest.approx(
        [event.time for event in fine.events], abs=1e-4
    )
    friction = np.hypot(*fine.friction_force[fine.rolling].T)
    assert np.all(friction <= body.mu * fine.normal_force[fine.rolling] * (1 + 1e-9))


def test_a_slip_that_begins_so_slowly_that_it_is_stiff():
    body = rt.SlidingTop(
        lambda1=6.457150e-4, lambda3=1.16731e-4, M=0.0646864, R=0.0553158, mu=0.42764
    )
    motion = body.motion(theta=0.680256, omega3=12.2043, theta_dot=1.36132, slip=(0, 0))
    run = motion.integrate(np.linspace(0, 0.192, 31))
    assert [event.kind for event in run.events] == ["slip"]
    assert run.budget() < 1e-8


def test_more_changes_than_one_waits_for_are_refused(monkeypatch):
    monkeypatch.setattr("rigidtop.motion.table.phases.MOST_EVENTS", 5)
    motion = rt.SlidingTop(**TOY, mu=0.2, drag3=1e-6).motion(theta=0.35, omega3=250)
    assert len(motion.integrate([8.4], **LOOSE).events) == 2
    monkeypatch.setattr("rigidtop.motion.table.phases.MOST_EVENTS", 1)
    with pytest.raises(rt.RigidtopError, match=r"more than 1 changes .* until t = 8\.3"):
        motion.integrate([9.0], **LOOSE)


def test_at_rest_on_too_smooth_a_table_it_slips_at_once():
    body = top(mu=0.02)
    motion = body.motion(theta=0.5, omega3=0.0, slip=(0, 0))
    start = motion.start()
    assert not start.rolling[0]
    # It slides down to +x: the foot goes to −x and friction holds it back.
    assert start.friction_force[0] == pytest.approx([0.02 * start.normal_force[0], 0], abs=1e-9)
    assert motion.integrate([0.01], **TIGHT).slip[0, 0] < 0


def test_a_fall_ends_the_motion():
    motion = top(mu=0.3, fall=1.0).motion(theta=0.3, omega3=1.0, slip=(0, 0))
    run = motion.integrate([3.0, 0.5, 0.0, 0.2])
    assert run.ended is not None
    assert run.ended.kind == "fall"
    assert run.t.tolist() == [0.5, 0.0, 0.2]
    last = motion.integrate([run.ended.time, 5.0])
    assert last.theta == pytest.approx([1.0], abs=1e-8)
    with pytest.raises(rt.RigidtopError, match=r"the motion ends at t = .* \(fall\)"):
        motion.integrate([5.0])


def test_lift_off_is_where_the_table_stops_pushing():
    body, start, *_ = COURSES["lifts off"]
    motion = body.motion(**start)
    ended = motion.integrate([0.0, 5.0]).ended
    assert ended is not None
    assert ended.kind == "lift-off"
    assert motion.integrate([ended.time * (1 - 1e-9)]).normal_force[0] < 1e-6
    assert motion.integrate([0.5 * ended.time]).normal_force[0] > 1


def test_times_in_any_order_and_one_alone():
    motion = top(mu=0.3, tip=0.1).motion(theta=0.3, omega3=60.0)
    times = [2.0, 0.0, 0.5, 2.0]
    run, sorted_run = motion.integrate(times), motion.integrate(sorted(times))
    assert run.t.tolist() == times
    assert run.phi[[1, 2, 0, 3]].tolist() == sorted_run.phi.tolist()
    assert motion.integrate(0.0).theta == pytest.approx([0.3])
    assert motion.start().budget() == 0


def test_solvers_agree():
    motion = top(mu=0.05).motion(theta=0.3, phi_dot=1.0, omega3=20.0, slip=(0, 0))
    best = motion.integrate([5.0], **TIGHT)
    for method in ("Radau", "LSODA"):
        other = motion.integrate([5.0], method=method, rtol=1e-9)
        assert other.theta == pytest.approx(best.theta, abs=1e-6)
        assert other.events[0].time == pytest.approx(best.events[0].time, abs=1e-6)


# --- Bad input -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"mu": -0.1}, "mu must be zero or positive"),
        ({"tip": math.nan}, "tip must be finite"),
        ({"R": 0}, "R must be positive"),
        ({"g": 0}, "g must be positive"),
        ({"lambda3": 2.1}, "exceeds 2 lambda1 = 2: no body has"),
        ({"fall": 4.0}, "fall must be an angle"),
        ({"drag3": "a"}, "drag3 must be a number"),
    ],
)
def test_impossible_tops(changes, message):
    with pytest.raises(rt.RigidtopError, match=message):
        top(**changes)


@pytest.mark.parametrize(
    ("start", "message"),
    [
        ({"theta": 0.3}, "give theta and the spin"),
        ({"theta": 0.3, "omega3": 1, "psi_dot": 1}, "psi_dot or omega3, not both"),
        ({"theta": 1.6, "omega3": 1}, "theta = 1.6 is no start"),
        ({"theta": 0.3, "omega3": 1, "velocity": 3}, "velocity must be two numbers"),
        ({"theta": 0.3, "omega3": 1, "slip": (0, math.inf)}, "slip\\[1\\] must be finite"),
        ({"theta": 0.3, "omega3": 1, "slip": (0, 0), "velocity": (0, 0)}, "not both"),
    ],
)
def test_impossible_starts(start, message):
    with pytest.raises(rt.RigidtopError, match=message):
        top().motion(**start)


def test_impossible_integrations():
    motion = top(mu=0.3).motion(theta=0.3, omega3=20.0)
    for arguments, message in (
        ({"t": -1.0}, "t must not be negative"),
        ({"t": 1e9}, "turns: at most"),
        ({"t": 1.0, "method": "taylor"}, "Taylor series do not see friction"),
        ({"t": 1.0, "method": "Euler"}, "unknown method"),
        ({"t": 1.0, "rtol": 1.0}, "rtol must be at most"),
    ):
        with pytest.raises(rt.RigidtopError, match=message):
            motion.integrate(**arguments)
    with pytest.raises(rt.RigidtopError, match="it would have to pull with"):
        top(mu=0.3).motion(theta=0.3, theta_dot=25.0, omega3=20.0).integrate(1.0)


def test_painleve_is_an_error():
    """A rod-like top dragged against its tilt by a rough table: no normal force is enough."""
    thin = rt.SlidingTop(lambda1=0.05, lambda3=0.05, M=1.0, R=0.5, mu=2.5)
    with pytest.raises(rt.RigidtopError, match=r"jams at t = 0.*Painlevé"):
        thin.motion(theta=1.0, omega3=0.0, velocity=(-1.0, 0.0)).integrate(1.0)
    assert thin.motion(theta=1.0, omega3=0.0, velocity=(1.0, 0.0)).integrate(0.1).theta[0] > 1


def test_at_an_event_the_row_belongs_to_what_was_before():
    motion = top(mu=0.3, tip=0.1).motion(theta=0.3, omega3=60.0)
    [stands] = motion.integrate([1.0]).events
    at, later = motion.integrate([stands.time, 1.0]), motion.integrate([stands.time + 1e-9, 1.0])
    assert not at.rolling[0]
    assert 0 < np.hypot(*at.slip[0]) < 1e-9
    assert later.rolling[0]
    assert later.slip[0].tolist() == [0, 0]
    assert at.energy[0] == pytest.approx(later.energy[0], rel=1e-10)
