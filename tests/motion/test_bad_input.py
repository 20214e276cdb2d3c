"""Bad input gets one line that says what is wrong."""

import math
import re
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.motion.sweep import Listed, Span
from rigidtop.parameters import Parameter, settings

GOOD = {"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "R": 0.5}
TOP = rt.HeavyTop(**GOOD)
TILTED = {"theta": 1.0, "omega3": 9.0}
UP = Rotation.identity()


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"lambda1": 0.0}, "lambda1 must be positive, not 0"),
        ({"lambda3": -1.0}, "lambda3 must be positive, not -1"),
        ({"lambda3": math.nan}, "lambda3 must be finite, not nan"),
        ({"M": 0}, "M must be positive, not 0"),
        ({"M": math.inf}, "M must be finite, not inf"),
        ({"R": -0.1}, "R must be zero or positive, not -0.1"),
        ({"g": -9.81}, "g must be zero or positive, not -9.81"),
        ({"g": "big"}, "g must be a number, not 'big'"),
        ({"g": None}, "g must be a number, not None"),
        ({"R": 0.9}, "lambda1 = 1 is too small: .* leaves 0.19, .* at least .* = 1.06 "),
    ],
)
def test_heavy_top(change, says):
    with pytest.raises(rt.RigidtopError, match=says):
        rt.HeavyTop(**{**GOOD, **change})


def test_moments_that_no_body_has_are_for_many_tops_too():
    simo_wong = {"lambda1": 5.0, "lambda3": 1.0, "M": 20.0, "R": 1.0}
    one = rt.HeavyTop(**simo_wong, physical=False)
    many = rt.top_motions(**vars(one), theta=0.3, omega3=[50.0, 60.0])
    assert many.regime.tolist() == [one.motion(theta=0.3, omega3=w).regime for w in (50.0, 60.0)]
    with pytest.raises(rt.RigidtopError, match="lambda1 is too small in 1 of 1"):
        rt.top_motions(**simo_wong, theta=0.3, omega3=[50.0, 60.0])


def test_a_disc_about_its_pivot_is_allowed_and_no_more():
    """A disc of M = 2, radius 0.3 at R = 0.4: moments about its centre ½λ₃, ½λ₃, λ₃."""
    lambda3, shift = 0.5 * 2 * 0.3**2, 2 * 0.4**2
    disc = rt.HeavyTop(lambda1=lambda3 / 2 + shift, lambda3=lambda3, M=2.0, R=0.4)
    assert disc.moments == (lambda3 / 2 + shift, lambda3 / 2 + shift, lambda3)
    with pytest.raises(rt.RigidtopError, match="too small"):
        rt.HeavyTop(lambda1=(lambda3 / 2 + shift) * (1 - 1e-9), lambda3=lambda3, M=2.0, R=0.4)


def test_free_body():
    assert rt.FreeBody(1, 2, 3).moments == (1.0, 2.0, 3.0)  # flat
    with pytest.raises(rt.RigidtopError, match="lambda2 = 3 exceeds the sum of the other two"):
        rt.FreeBody(1.0, 3.0, 1.9)
    with pytest.raises(rt.RigidtopError, match="lambda2 must be positive"):
        rt.FreeBody(1.0, 0.0, 1.0)


def test_heavy_body():
    with pytest.raises(rt.RigidtopError, match="about the centre of mass would be 0, 0, 1, the"):
        rt.HeavyBody(1, 1, 1, M=1, centre_of_mass=(1, 0, 0))
    with pytest.raises(rt.RigidtopError, match="centre_of_mass must be three numbers"):
        rt.HeavyBody(1, 1, 1, M=1, centre_of_mass=(0, 0))
    # A stick along e₁, of M = 3 and length 2: 4, 4 about its end, 1, 1 about its middle.
    stick = rt.HeavyBody(1e-3, 4, 4, M=3, centre_of_mass=(1, 0, 0))
    assert stick.weight == (3 * 9.81, 0, 0)
    with pytest.raises(rt.RigidtopError, match="largest more than the sum"):
        rt.HeavyBody(1e-3, 4, 2.9, M=3, centre_of_mass=(1, 0, 0))


@pytest.mark.parametrize("moments", [(1.0, 0.5), (2.0, 3.0)])
def test_the_top_and_the_heavy_body_allow_the_same(moments):
    """λ₁ − MR² ≥ λ₃/2 is what the eigenvalues of the shifted tensor say."""
    least = moments[1] / 2
    for mr2, allowed in ((moments[0] - least - 1e-6, True), (moments[0] - least + 1e-6, False)):
        arm = math.sqrt(mr2)
        for make in (
            lambda arm=arm: rt.HeavyTop(lambda1=moments[0], lambda3=moments[1], M=1.0, R=arm),
            lambda arm=arm: rt.HeavyBody(moments[0], *moments, 1.0, (0.0, 0.0, arm)),
        ):
            if allowed:
                assert make().moments[2] == moments[1]
            else:
                with pytest.raises(rt.RigidtopError):
                    make()


@pytest.mark.parametrize(
    ("start", "says"),
    [
        ({"theta": 1.0}, "give theta and the spin"),
        ({"omega3": 9.0}, "give theta and the spin"),
        ({}, "give theta and the spin"),
        ({**TILTED, "psi_dot": 1.0}, "psi_dot or omega3, not both"),
        ({**TILTED, "theta": -0.1}, "theta must lie between 0 and pi radians, not at -0.1"),
        ({**TILTED, "theta": 3.2}, "theta must lie between 0 and pi"),
        ({**TILTED, "phi_dot": math.inf}, "phi_dot must be finite"),
        ({"attitude": UP}, "needed together"),
        ({"omega": (1, 2, 3)}, "needed together"),
        ({"attitude": UP, "omega": (1, 2, 3), "phi": 0.0}, "not both: phi too"),
        ({"attitude": UP, "omega": (1, 2)}, "omega must be three numbers, not"),
        ({"attitude": UP, "omega": (1, 2, math.nan)}, r"omega\[2\] must be finite"),
        ({"attitude": np.eye(3), "omega": (1, 2, 3)}, "a scipy Rotation, not ndarray"),
        (
            {"attitude": Rotation.from_quat(np.eye(4)), "omega": (1, 2, 3)},
            "one rotation, not a stack of 4",
        ),
    ],
)
def test_starts(start, says):
    with pytest.raises(rt.RigidtopError, match=says) as caught:
        TOP.motion(**start)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"t": math.nan}, "t must be finite"),
        ({"t": [0, math.inf]}, "t must be finite"),
        ({"t": []}, r"not of shape \(0,\)"),
        ({"t": [[1.0]]}, r"not of shape \(1, 1\)"),
        ({"t": "soon"}, "t must be a number or an array of numbers, not 'soon'"),
        ({"t": 1.0, "method": "Euler"}, "unknown method 'Euler': DOP853, RK45, RK23, Radau"),
        ({"t": 1.0, "rtol": 0.0}, "rtol must be at least 2.3e-14, not 0"),
        ({"t": 1.0, "rtol": 1e5, "atol": 1e5}, "rtol must be at most 0.1, not 100000"),
        ({"t": 1.0, "atol": -1.0}, "atol must be positive, not -1"),
        ({"t": 1.0, "atol": 0.0}, "atol must be positive, not 0"),
        ({"t": 1.0, "atol": 1e-120}, "atol must be at least 1e-100, not 1e-120"),
        ({"t": 1.0, "atol": 0.2}, "atol must be at most 0.1, not 0.2"),
        ({"t": [0, -1e101]}, r"t must be at most 1e\+100 in magnitude: use other units"),
        ({"t": 1e20}, r"turns: at most 1e\+07"),
    ],
)
def test_integrations(arguments, says):
    with pytest.raises(rt.RigidtopError, match=says) as caught:
        TOP.motion(**TILTED).integrate(**arguments)
    assert "\n" not in str(caught.value)


def test_a_solver_that_gives_up_says_why(monkeypatch):
    from scipy.integrate import OdeSolution

    from rigidtop.motion import integrate

    class Stopped:
        status, message, t = -1, "Required step size is too small.", np.array([0, 0.5])
        y, sol = np.zeros((6, 2)), OdeSolution

    monkeypatch.setattr(integrate, "solve_ivp", lambda *_, **__: Stopped)
    with pytest.raises(
        rt.RigidtopError, match=r"stopped at t = 0.5 on the way to 1: Required step"
    ):
        TOP.motion(**TILTED).integrate(1.0)


def test_what_is_not_a_number_is_not_passed_on(monkeypatch):
    from rigidtop.motion import integrate

    class Lost:
        status, message, t = 0, "The solver says that it arrived.", np.array([0, 1.0])
        y, sol = np.full((6, 2), np.nan), lambda t: np.full((6, len(t)), np.nan)

    monkeypatch.setattr(integrate, "solve_ivp", lambda *_, **__: Lost)
    with pytest.raises(rt.RigidtopError, match="the integration stopped at t = 1"):
        TOP.motion(**TILTED).integrate(1.0)


@pytest.mark.parametrize("norm", [0.0, 1e-3, 1e3, math.nan])
def test_a_quaternion_that_is_no_attitude(monkeypatch, norm):
    from rigidtop.motion import integrate

    class Coarse:
        status, message, t = 0, "The solver says that it arrived.", np.array([0, 1.0])
        y = np.full((6, 2), 0.5)

        @staticmethod
        def sol(t):
            return np.full((6, len(t)), norm / 2)

    monkeypatch.setattr(integrate, "solve_ivp", lambda *_, **__: Coarse)
    with pytest.raises(rt.RigidtopError, match="smaller rtol and atol are needed") as caught:
        TOP.motion(**TILTED).integrate(1.0)
    assert "\n" not in str(caught.value)


def test_rates_that_overflow():
    from rigidtop.motion.integrate import Accuracy, InitialValueProblem, flow

    with pytest.raises(rt.RigidtopError, match="the velocities are too large"):
        flow(InitialValueProblem(lambda _: (math.inf,), np.ones(1), np.ones_like), 1.0, Accuracy())


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: rt.FreeBody(1e300, 1e300, 1e300), r"lambda1 must be at most 1e\+100 in magnitude"),
        (lambda: rt.FreeBody(1e-300, 1.0, 1.0), "lambda1 must be at least 1e-100, not 1e-300"),
        (lambda: rt.HeavyTop(**{**GOOD, "M": 1e101}), r"M must be at most 1e\+100"),
        (lambda: rt.HeavyTop(**{**GOOD, "R": 1e-101}), "R must be at least 1e-100"),
        (
            lambda: rt.HeavyBody(1, 1, 1, 1.0, (0, -1e200, 0)),
            r"centre_of_mass\[1\] must be at most",
        ),
        (
            lambda: TOP.motion(theta=1.0, omega3=1e200),
            r"omega3 must be at most 1e\+100 in .* 1e\+200",
        ),
        (lambda: rt.FreeBody(1, 1, 1).motion(omega=(0, 0, -1e101)), r"omega\[2\] must be at most"),
        (lambda: TOP.steady_precession(1.0, 1e101), "omega3 must be at most"),
    ],
)
def test_absurd_sizes(make, says):
    with pytest.raises(rt.RigidtopError, match=says) as caught:
        make()
    assert str(caught.value).endswith(": use other units")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("moment", [2e-100, 5e99])
@pytest.mark.parametrize("rate", [1e-100, 1e100])
@pytest.mark.filterwarnings("error")
def test_sizes_that_are_not_refused_do_not_overflow(moment, rate):
    for moments in ((moment, moment, moment), (moment, moment, 1.5 * moment)):
        motion = rt.FreeBody(*moments).motion(omega=(rate, rate / 2, rate / 3))
        run = motion.integrate(min(3 / rate, 1e100))
        assert max(run.drift().values()) < 1e-9
    top = rt.HeavyTop(lambda1=moment, lambda3=moment, M=moment, R=0.5)
    run = top.motion(theta=0.5, omega3=rate).integrate(min(3 / rate, 3.0))
    assert max(run.drift().values()) < 1e-9


def test_polar_angles_of_rates():
    with pytest.raises(rt.RigidtopError, match="theta must lie"):
        TOP.steady_precession(4.0, 9.0)
    with pytest.raises(rt.RigidtopError, match="omega3 must be finite"):
        TOP.steady_precession(1.0, math.nan)
    with pytest.raises(rt.RigidtopError, match="theta must lie"):
        TOP.smallest_spin(-1e-9)


def test_tolerances_and_angles_of_any_kind_of_number():
    with pytest.raises(rt.RigidtopError, match=r"rtol must be at most 0\.1, not 0\.333333$"):
        TOP.motion(**TILTED).integrate(1.0, rtol=Fraction(1, 3))
    assert TOP.motion(**TILTED).integrate(1.0, rtol=Fraction(1, 10**6)).theta.shape == (1,)
    with pytest.raises(rt.NoSteadyPrecession, match=r"theta = 0\.5 with omega3 = 0\.333333:"):
        TOP.steady_precession(Fraction(1, 2), Fraction(1, 3))


@pytest.mark.parametrize(
    ("value", "said"),
    [(math.nan, "finite, not nan"), (2, "True or False, not 2"), ("no", "a number, not 'no'")],
)
def test_what_is_physical_is_a_truth(value, said):
    for make in (
        lambda: rt.HeavyTop(lambda1=1, lambda3=0.5, M=1, R=0.5, physical=value),
        lambda: rt.FreeBody(1, 1, 1, physical=value),
        lambda: rt.HeavyBody(3, 2, 1.5, 1, (0.2, 0.3, 0.4), physical=value),
        lambda: rt.top_motions(
            lambda1=1, lambda3=0.5, M=1, R=0.5, theta=0.5, omega3=1, physical=value
        ),
    ):
        with pytest.raises(rt.RigidtopError, match=f"^physical must be {said}$"):
            make()
    assert rt.FreeBody(1, 1, 3, physical=0.0).lambda3 == 3.0


def test_bodies_are_values():
    assert rt.FreeBody(1, 2, 2.5) == rt.FreeBody(1.0, 2.0, 2.5)
    with pytest.raises(AttributeError):
        TOP.R = 2.0


NO_NUMBERS = [
    ("3", "'3'"),
    (True, "True"),
    (None, "None"),
    (np.True_, "True"),
    (1 + 0j, r"\(1\+0j\)"),
    (np.complex64(1), r"np\.complex64\(1\+0j\)"),
    (np.timedelta64(3, "s"), r"np\.timedelta64\(3,'s'\)"),
    (np.array("3"), "'3'"),
    (np.ma.masked, "mask"),
]
"""What float() or NumPy takes for a number, nearly all of it, and what a message says of it."""

TAKES_ONE = {
    "lambda1": lambda x: rt.HeavyTop(**{**GOOD, "lambda1": x}),
    "g": lambda x: rt.HeavyTop(**GOOD, g=x),
    "lambda2": lambda x: rt.FreeBody(1.0, x, 1.0),
    r"omega\[1\]": lambda x: rt.FreeBody(1.0, 1.0, 1.0).motion(omega=(1.0, x, 1.0)),
    r"centre_of_mass\[0\]": lambda x: rt.HeavyBody(9, 9, 9, M=1, centre_of_mass=(x, 0, 0)),
    "omega3": lambda x: TOP.steady_precession(0.5, x),
    "rtol": lambda x: TOP.motion(**TILTED).integrate(1.0, rtol=x),
    "tip": lambda x: rt.SlidingTop(**GOOD, tip=x),
    r"slip\[0\]": lambda x: rt.SlidingTop(**GOOD).motion(**TILTED, slip=(x, 0.0)),
    "start": lambda x: Span(x, 1.0, 2),
    "a value": lambda x: Listed((x,)),
    "tilt": lambda x: settings([Parameter("tilt", 0.5, "θ")], {"tilt": x}),
}
TAKES_MANY = {
    "t": lambda x: TOP.motion(**TILTED).exact(x),
    "t ": lambda x: TOP.motion(**TILTED).integrate(x),
    "t  ": lambda x: rt.FreeBody(1, 2, 3).motion(omega=(1, 1, 1)).exact(x),
    "t   ": lambda x: rt.SlidingTop(**GOOD).motion(**TILTED).integrate(x),
    "t    ": lambda x: rt.top_motions(**GOOD, **TILTED).exact(x),
    "theta": lambda x: rt.top_motions(**GOOD, omega3=9.0, theta=x),
    "phi_dot": lambda x: rt.top_motions(**GOOD, **TILTED, phi_dot=x),
    "moments": lambda x: rt.free_motions(moments=x, omega=[1.0, 1.0, 1.0]),
}


@pytest.mark.parametrize(("value", "shown"), NO_NUMBERS)
@pytest.mark.parametrize("name", TAKES_ONE)
def test_what_is_no_number_is_refused(name, value, shown):
    with pytest.raises(
        rt.RigidtopError, match=rf"^{name} must be a number, not .*{shown}"
    ) as caught:
        TAKES_ONE[name](value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(("value", "shown"), NO_NUMBERS)
@pytest.mark.parametrize("name", TAKES_MANY)
def test_what_are_no_numbers_is_refused(name, value, shown):
    says = rf"^{name.strip()} must be .*numbers, not .*"
    for many in (value, [1.0, value, 1.0]):
        with pytest.raises(rt.RigidtopError, match=says + shown) as caught:
            TAKES_MANY[name](many)
        assert "\n" not in str(caught.value)
    rows = np.broadcast_to(np.asarray(value), 1000)
    if rows.dtype.kind != "O" and value is not np.ma.masked:
        with pytest.raises(rt.RigidtopError, match=says + re.escape(f"an array of {rows.dtype}")):
            TAKES_MANY[name](rows)


@pytest.mark.parametrize("name", TAKES_MANY)
def test_masks_are_not_lost(name):
    masked = np.ma.array([1.0, 0.5, 1.0], mask=[False, True, False])
    for value in (masked, [masked, masked]):
        with pytest.raises(rt.RigidtopError, match="a masked array: leave out, or fill, what is"):
            TAKES_MANY[name](value)
    TAKES_MANY[name](np.ma.array([1.0, 0.5, 1.0]))


def test_numbers_of_every_kind_are_taken():
    for one in (Fraction(1, 2), Decimal("0.5"), np.float32(0.5), np.array(0.5), 0.5):
        assert TOP.motion(theta=one, omega3=9).exact([one, 1]).t.tolist() == [0.5, 1.0]
        assert rt.top_motions(**GOOD, theta=[one, 1], omega3=9).theta.tolist() == [0.5, 1.0]
    with pytest.raises(rt.RigidtopError, match="t must be finite"):
        TOP.motion(**TILTED).exact([10**400, 1])
    with pytest.raises(rt.RigidtopError, match="phi must be finite, not -inf"):
        TOP.motion(**TILTED, phi=-(10**400))


@pytest.mark.parametrize("value", [[[1, 2], [3]], [[1, 2], 3]])
def test_rows_of_different_lengths(value):
    with pytest.raises(rt.RigidtopError, match="t must be a number or an array of numbers, not"):
        TOP.motion(**TILTED).exact(value)
    with pytest.raises(rt.RigidtopError, match="omega must be three numbers, not"):
        rt.FreeBody(1, 1, 1).motion(omega=value)


@pytest.mark.parametrize("value", [np.eye(3)[:2], np.ones((3, 3, 3)), {1, 2, 3}, 1.0, None, "12"])
def test_what_is_no_vector(value):
    with pytest.raises(rt.RigidtopError, match="omega must be three numbers, not") as caught:
        rt.FreeBody(1, 1, 1).motion(omega=value)
    assert "\n" not in str(caught.value)
