"""What the figures show, read from what they drew, against facts found in another way."""

import math

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure as Canvas
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.derivations.exercises.eulers_equations import flip_seconds, stable_axes
from rigidtop.figures import (
    angles,
    cones,
    falling,
    free,
    nutation,
    picture,
    potential,
    precession,
    space,
    spinning,
    style,
    torque,
)
from rigidtop.figures.catalog import named
from rigidtop.motion.attitude import from_euler_angles
from rigidtop.proof.words import unmarked

from .conftest import line

TOP = rt.HeavyTop(lambda1=0.02, lambda3=0.01, M=1.0, R=0.1, g=9.81)
WEIGHT = 0.981


def lines_like(axes, color, count):
    return [
        each for each in axes.lines if each.get_color() == color and len(each.get_xdata()) == count
    ]


# --- Grey ----------------------------------------------------------------------------------------


def lightness(color):
    """CIE L* of a colour, 0 to 100."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in to_rgb(color)]
    luminance = float(np.dot([0.2126, 0.7152, 0.0722], linear))
    return 116 * luminance ** (1 / 3) - 16 if luminance > 0.008856 else 903.3 * luminance


def test_lines_of_one_picture_differ_in_grey():
    steps = [lightness(color) for color in (style.INK, style.FIRST, style.SECOND, style.THIRD)]
    assert np.all(np.diff(steps) > 12)
    assert steps[2] < 60  # letters in this colour can be read on white


def test_letters_are_not_too_small():
    sizes = [value for key, value in style.STYLE.items() if key.endswith("size")]
    assert min(sizes) >= style.SMALL == 8


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


def test_a_horizontal_top_has_one_rate(axes):
    precession.draw_precession_rates(axes, TOP, math.pi / 2, 40.0)
    spin, rate = line(axes, "_slow").T
    assert rate == pytest.approx(WEIGHT / (TOP.lambda3 * spin), rel=1e-12)
    assert "_fast" not in [each.get_label() for each in axes.lines]


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


@pytest.mark.parametrize("spin", [0.05, 2.0, 8.0, 150.0])
def test_the_largest_angle_is_that_of_a_fine_scan(axes, spin):
    motion = TOP.motion(theta=math.pi / 3, omega3=spin)
    down = motion.exact(np.geomspace(1e-9, 1, 200_000) * motion.nutation_period / 2)
    momentum = down.omega * np.array([TOP.lambda1, TOP.lambda1, TOP.lambda3])
    crossed = np.linalg.norm(np.cross(momentum, down.omega), axis=1)
    scanned = np.arctan2(crossed, np.sum(momentum * down.omega, axis=1)).max()
    assert precession.largest_angle(motion) == pytest.approx(scanned, rel=1e-7)
    precession.draw_parallel(axes, TOP, math.pi / 3, spin)
    assert np.radians(line(axes, "_angle")[:, 1]).max() == pytest.approx(scanned, rel=1e-7)
    drawing = named("parallel")
    values = drawing.values({"omega3": spin})
    assert f"{style.degrees(float(scanned))} at most" in unmarked(drawing.caption(**values))
    twice = scanned > math.asin(1 / 3) * (1 - 1e-7)  # |λ₁ − λ₃|/(λ₁ + λ₃)
    assert twice == (spin < 10)
    assert ("twice in every" in drawing.alternative(**values)) == twice


@pytest.mark.parametrize("theta", [0.0, math.pi])
def test_a_vertical_top_has_no_angle(axes, theta):
    precession.draw_parallel(axes, TOP, theta, 1.0)
    assert line(axes, "_angle")[:, 1] == pytest.approx(0, abs=1e-12)


# --- Torque --------------------------------------------------------------------------------------


@pytest.mark.parametrize("theta", [0.2, math.pi / 4, 2.5])
def test_torque_is_the_rate_of_the_momentum(theta):
    motion = TOP.motion(theta=theta, phi=math.pi / 2, phi_dot=1.0, omega3=30.0)
    step = 1e-5
    before, after = motion.integrate([-step, step], rtol=1e-12, atol=1e-14).angular_momentum
    assert torque.torque(motion) == pytest.approx((after - before) / (2 * step), abs=1e-6)
    # Leaning to the right in the plane of the paper: x̂ points at the reader, N away from it.
    assert motion.start().e3[0] == pytest.approx([0, math.sin(theta), math.cos(theta)], abs=1e-15)
    assert torque.direction_of_torque(motion) == pytest.approx([-1, 0, 0], abs=1e-12)


def test_torque_as_it_is_drawn(axes):
    motion = TOP.motion(theta=0.8, phi=math.pi / 2, omega3=30.0)
    torque.draw_torque(axes, motion)
    shown = {text.get_text(): text for text in axes.texts if text.get_text()}
    x, y = shown[r"$\mathbf{N}$"].xy
    # What goes straight into the paper goes up on it, and to the left of a reader at the right.
    across, up, near = torque.VIEW(np.array([-0.95, 0.0, 0.0]))
    assert (x, y) == pytest.approx((across, up))
    assert near < 0
    assert x < 0 < y


def test_no_torque_on_the_vertical(axes):
    torque.draw_torque(axes, TOP.motion(theta=0.0, omega3=30.0))
    assert r"$\mathbf{N} = 0$" in [text.get_text() for text in axes.texts]
    assert "there is none" in unmarked(
        named("torque").caption(**named("torque").values({"theta": 0.0}))
    )


# --- Euler's angles ------------------------------------------------------------------------------


@pytest.mark.parametrize("sequence", ["zyz", "zxz"])
@pytest.mark.parametrize("chosen", [(1.0, 0.7, 0.8), (-2.0, 2.5, 4.0), (0.0, 0.0, 0.0)])
def test_every_step_is_a_proper_rotation_about_its_axis(sequence, chosen):
    phi, theta, psi = chosen
    steps = angles.steps(sequence, *chosen)
    quarter = math.pi / 2 if sequence == "zxz" else 0.0
    assert steps[3].as_matrix() == pytest.approx(
        from_euler_angles(theta, phi - quarter, psi + quarter).as_matrix(), abs=1e-15
    )
    for before, after, (axis, angle, _, _) in zip(
        steps, steps[1:], angles.turns(sequence, *chosen), strict=False
    ):
        turn = (after * before.inv()).as_matrix()
        assert np.linalg.det(turn) == pytest.approx(1)
        assert turn @ axis == pytest.approx(axis, abs=1e-15)
        assert np.trace(turn) == pytest.approx(1 + 2 * math.cos(angle))
    axes_turned_about = [axis for axis, _, _, _ in angles.turns(sequence, *chosen)]
    nodes = [-math.sin(phi - quarter), math.cos(phi - quarter), 0]
    assert axes_turned_about[0] == pytest.approx([0, 0, 1])
    assert axes_turned_about[1] == pytest.approx(nodes, abs=1e-15)
    assert axes_turned_about[2] == pytest.approx(steps[3].as_matrix()[:, 2], abs=1e-15)


@pytest.mark.parametrize("sequence", ["zyz", "zxz"])
def test_angles_end_where_the_axes_are(axes, sequence):
    chosen = (1.0, 0.7, 0.8)
    steps = angles.steps(sequence, *chosen)
    for i, turned in enumerate(angles.turns(sequence, *chosen)):
        panel = Canvas().subplots()
        angles.draw_rotation(panel, steps[i], steps[i + 1], turned, ("", "", ""))
        [way] = lines_like(panel, angles.ANGLE, 61)
        x, y, _ = angles.VIEW(0.62 * steps[i + 1].as_matrix()[:, turned[2]])
        assert way.get_xydata()[-1] == pytest.approx((x, y), abs=1e-12)


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


@pytest.mark.parametrize("lambda3", [0.5, 1.7])
def test_rolling_cones_as_they_are_drawn(lambda3):
    """The rims of both cones go through the tip of ω, also when they have rolled on."""
    motion = cones.free_motion(1.0, lambda3, 0.7, 1.0)
    for t in (0.0, 1.3):
        panel = Canvas().subplots()
        cones.draw_rolling_cones(panel, motion, t)
        [tip] = [x.xy for x in panel.texts if x.get_text() == style.OMEGA_VEC]
        contact = np.array(tip) / 1.2
        for color in (style.AXIS, style.OMEGA):
            rims = lines_like(panel, color, 241)
            points = np.vstack([rim.get_xydata() for rim in rims])
            distance = np.linalg.norm(points[np.isfinite(points[:, 0])] - contact, axis=1)
            assert distance.min() < 0.01
        [up] = [x.xy for x in panel.texts if x.get_text() == style.L_VEC]
        assert up[0] == pytest.approx(0, abs=1e-12)  # L stays upright
        # e₃ has gone round it by Lt/λ₁, from the left of the paper.
        momentum = math.hypot(1.0 * 0.7, lambda3 * 1.0)
        turned = Rotation.from_rotvec([0, 0, momentum / 1.0 * t])
        lean = math.atan2(0.7, lambda3)
        x, y, _ = space.View(elevation=0.34)(
            1.25 * turned.apply([0, -math.sin(lean), math.cos(lean)])
        )
        [tip] = [text.xy for text in panel.texts if text.get_text() == style.E3]
        assert tip == pytest.approx((x, y), abs=1e-9)


def test_the_cones_share_a_plane(axes):
    cones.draw_cones(axes, cones.free_motion(1.0, 0.55, 0.45, 1.0), space=True)
    tips = {text.get_text(): text.xy for text in axes.texts if text.get_text()}
    assert set(tips) == {style.E3, style.OMEGA_VEC, style.L_VEC}
    assert tips[style.L_VEC][0] == pytest.approx(0)  # in space L stands upright
    assert tips[style.E3][0] < tips[style.OMEGA_VEC][0] < 0
    for space_frame in (False, True):
        three = cones.three_directions(cones.free_motion(1.0, 1.7, 0.45, 1.0), space=space_frame)
        assert np.linalg.det(three) == pytest.approx(0, abs=1e-15)
        assert np.array(three)[:, 0] == pytest.approx(0, abs=1e-15)  # the plane of the paper


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


def test_hidden_lines_are_behind():
    """What is dashed on the sphere is farther from the eye than its centre."""
    panel, view = Canvas().subplots(), space.View(0.4, 0.3)
    points = space.circle([0.0, 0.0, 1.0], 0.9)
    picture.draw(panel, [picture.on_sphere(points, "k")], view)
    back, front = (each.get_xydata() for each in panel.lines)
    behind = view(points)[2] < 0
    assert np.array_equal(np.isfinite(back[:, 0]), behind)
    assert np.isfinite(front[~behind, 0]).all()


def test_flips_are_seen_at_their_period(axes):
    motion = free.flip(1.0, 2.0, 2.9, 2.0, 0.01)
    free.draw_rates(axes, motion, free._flip_times(motion))
    t, middle = np.asarray(axes.lines[1].get_xydata()).T
    changes = t[np.flatnonzero(middle[:-1] * middle[1:] < 0)]
    assert np.diff(changes) == pytest.approx(motion.nutation_period, abs=2 * (t[1] - t[0]))
    later = motion.integrate(t[::200], rtol=1e-11, atol=1e-13).omega
    shown = np.column_stack([axes.lines[k].get_ydata()[::200] for k in range(3)])
    assert shown == pytest.approx(later, abs=1e-6)


@pytest.mark.parametrize("order", [(0, 1, 2), (1, 0, 2), (2, 0, 1)])
def test_flips_are_about_the_middle_axis(order):
    moments = np.array([1.0, 2.0, 2.9])[list(order)]
    omega = np.array(free.flip(*moments, omega=2.0, kick=0.01).omega)
    by_moment = dict(zip(moments, omega, strict=True))
    assert by_moment == {1.0: 0.01, 2.0: 2.0, 2.9: 0.0}


def test_figure_and_exercise_agree_on_the_flip():
    given = {p.name: p.default for p in stable_axes.parameters}
    seconds = flip_seconds((1.0, 1.7, 2.3), given["omega"], given["kick"])
    assert (given["lambda1"], given["lambda2"], given["lambda3"]) == (1.0, 1.7, 2.3)
    drawing = named("flip")
    [panel] = drawing.draw(**drawing.values(given)).axes
    dotted = [float(x.get_xdata()[0]) for x in panel.lines if x.get_label() == "_flip"]
    assert dotted == pytest.approx(seconds * (np.arange(len(dotted)) + 0.5), rel=1e-9)
    assert len(dotted) == 4
    assert f"every {style.said(seconds)} s (dotted)" in unmarked(
        drawing.caption(**drawing.values(given))
    )
    later = free.flip(**given).integrate(dotted, rtol=1e-12, atol=1e-15)
    assert later.omega[:, 1] == pytest.approx(0, abs=1e-6)


def test_flip_wants_a_middle_axis():
    drawing = named("flip")
    with pytest.raises(rt.RigidtopError, match="three different moments"):
        drawing.draw(**drawing.values({"lambda2": 1.0, "lambda3": 1.5}))


@pytest.mark.parametrize("kick", [6.0, 15.0, 1e-9])
def test_a_flip_wants_a_small_kick(kick):
    drawing = named("flip")
    with pytest.raises(rt.RigidtopError, match="kick must be less than omega = 6 and at least"):
        unmarked(drawing.caption(**drawing.values({"kick": kick})))


@pytest.mark.parametrize(("kick", "words"), [(0.01, "stays near"), (3.0, "swings between")])
def test_words_of_a_flip_follow_from_the_kick(kick, words):
    drawing = named("flip")
    assert words in drawing.alternative(**drawing.values({"kick": kick}))


def returns(drawing, given, axis, seconds):
    """How far e₁, e₂ or e₃ is from its place after a time, and how far it was on the way."""
    motion = free._tumbling(**drawing.values(given))
    run = motion.integrate(np.linspace(0, seconds, 41), rtol=1e-11, atol=1e-13)
    place = run.rotation.as_matrix()[:, :, axis]
    gap = np.linalg.norm(place - place[0], axis=1)
    return gap[-1], gap.max()


def test_words_of_tumbling_follow_from_the_regime():
    drawing = named("tumbling")

    def told(given):
        values = drawing.values(given)
        words = drawing.alternative(**values)
        return unmarked(drawing.caption(**values)), words

    usual, words = told({})
    assert "e₃ (thick) and e₁ never come back; 5 nutations" in usual
    assert "do not close" in words

    given = {"omega1": 0.0, "omega2": 0.0}
    steady, words = told(given)
    turn = 2 * math.pi / abs(drawing.values()["omega3"])
    assert "in the body L rests (steady)" in steady
    days = style.said(turn / free.DAY)
    assert f"e₃ rests and e₁ goes round a circle, back after {days} days; one turn" in steady
    assert "never" not in steady
    assert "do not close" not in words
    assert returns(drawing, given, 0, turn) == pytest.approx((0, 2), abs=0.01)
    assert returns(drawing, given, 2, turn) == pytest.approx((0, 0), abs=1e-9)

    given = {"lambda1": 2.0, "lambda2": 2.0}
    round_e3, words = told(given)
    rates = np.array([drawing.values()[f"omega{k}"] for k in (1, 2, 3)])
    turn = 2 * math.pi * 2.0 / np.linalg.norm(rates * [2, 2, 1])  # 2πλ₁/L
    days = style.said(turn / free.DAY)
    assert f"e₃ (thick) goes round a circle about L, back after {days} days, and e₁" in round_e3
    assert "never" not in round_e3
    assert "do not close" not in words
    there, away = returns(drawing, given, 2, turn)
    assert there < 1e-8 < 0.5 < away
    assert returns(drawing, given, 0, turn)[0] > 0.1

    ball, words = told({"lambda1": 1.0, "lambda2": 1.0})
    turn = style.said(2 * math.pi / np.linalg.norm(rates) / free.DAY)
    assert "L rests (steady)" in ball
    assert f"go round circles, back after {turn} days" in ball
    assert "endless" not in ball
    assert "rests" in words


def test_words_of_tumbling_on_the_separatrix():
    drawing = named("tumbling")
    given = {"lambda1": 1.0, "lambda2": 2.0, "lambda3": 2.5, "omega2": 0.0, "omega3": 1.0}
    values = drawing.values({**given, "omega1": math.sqrt(2.5 * 0.5)})
    assert free._tumbling(**values).regime == "separatrix"
    caption = unmarked(drawing.caption(**values))
    assert "L tends to the middle axis and never comes back (separatrix)" in caption
    assert "nutations are drawn" not in caption


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


@pytest.mark.parametrize("theta", [0.0, math.pi])
def test_on_the_vertical_phi_has_no_meaning(theta):
    for name in ("motion", "top", "effective-potential"):
        drawing = named(name)
        caption = unmarked(drawing.caption(**drawing.values({"theta": theta})))
        assert "where φ has no meaning" in caption
        assert "φ̇" not in caption
        with pytest.raises(rt.RigidtopError, match="phi has no meaning: phi_dot must be 0"):
            drawing.draw(**drawing.values({"theta": theta, "phi_dot": 1.0}))
    for name in ("paths", "regimes"):
        drawing = named(name)
        for make in (drawing.draw, drawing.caption, drawing.alternative):
            with pytest.raises(rt.RigidtopError, match="phi has no meaning"):
                make(**drawing.values({"theta": theta}))
    drawing = named("motion")
    values = drawing.values({"theta": theta})
    assert f"θ stays {math.degrees(theta):.0f}°" in unmarked(drawing.caption(**values))
    assert "no meaning" in drawing.alternative(**values)
    assert "runs between" in unmarked(
        drawing.caption(**drawing.values({"theta": theta, "theta_dot": 1.0}))
    )


def test_a_steady_motion_is_told_as_such():
    drawing = named("motion")
    slow, _ = TOP.steady_precession(1.0, 40.0)
    caption = unmarked(drawing.caption(**drawing.values({"theta": 1.0, "phi_dot": slow})))
    assert f"θ stays 57.3°, and φ goes on at {style.said(slow)} rad/s" in caption


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
    [steady] = [each for each in axes.lines if each.get_color() == style.SECOND]
    for spin, rate in np.asarray(steady.get_xydata())[10::60]:
        assert TOP.motion(theta=theta, phi_dot=rate, omega3=spin).regime == "steady"


@pytest.mark.parametrize("spin", [4.0, 15.0, 24.0, 24.5])
def test_the_line_to_the_upright_begins_where_the_energy_reaches_it(axes, spin):
    """√(2λ₁MgR(1 + cos θ))/λ₃ = 24.26 rad/s; before that p_φ = p_ψ is nothing special."""
    theta = math.pi / 3
    nutation.draw_regimes(axes, TOP, theta, 60.0, 30.0)
    up = [x.get_xydata() for x in axes.lines if x.get_label() == "_vertical"]
    [up] = [points for points in up if points[-1, 1] > 0]
    assert up[:, 0].min() == pytest.approx(24.26, abs=0.3)
    rate = TOP.lambda3 * spin / (TOP.lambda1 * (1 + math.cos(theta)))
    path = TOP.motion(theta=theta, phi_dot=rate, omega3=spin).integrate(
        np.linspace(0, 10, 20001), rtol=1e-12, atol=1e-14
    )
    assert (path.theta.min() < 0.02) == (spin > up[:, 0].min())
    drawing = named("regimes")
    assert "from 24.3 rad/s on" in unmarked(drawing.caption(**drawing.values()))
    assert "upright" not in unmarked(drawing.caption(**drawing.values({"omega3": 20.0})))


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


def test_flashes_are_where_the_top_is(axes):
    motion = spinning._motion(**named("top").values())
    times = spinning._times(motion, 300)
    spinning.draw_stroboscopic(axes, motion, times)
    e3 = motion.integrate(np.linspace(0, times[-1], spinning.FLASHES), rtol=1e-11).e3
    for k, axis in enumerate(e3):
        [tip] = [text.xy for text in axes.texts if text.get_text() == f"${k + 1}$"]
        x, y, _ = spinning.VIEW(spinning.TRAIL * axis)
        assert tip == pytest.approx((x, y), abs=1e-6)
