"""Parameters of systems from measurements: they come back, with errors that cover the truth."""

import numpy as np
import pytest
from sympy import cos, sign, sin, symbols, tanh

import rigidtop as rt

m, k, c, g, rod, mu = symbols("m k c g l mu", positive=True)
x, y, u, v = symbols("x y u v", real=True)
SPRING = rt.System(m * u**2 / 2 - k * x**2 / 2, x, u, rayleigh=c * u**2 / 2)
COASTING = rt.System(u**2 / 2, x, u, rayleigh=c * u**2 / 2)
PENDULUM = rt.System(m * rod**2 * u**2 / 2 + m * g * rod * cos(x), x, u)
BOB = rt.System(m * (u**2 + v**2) / 2 - m * g * y, [x, y], [u, v], constraints=x**2 + y**2 - rod**2)
TIMES = np.linspace(0, 10, 101)
ONCE = {"starts": 1}
"""Of a search that begins near its end, or that nothing can help."""


def noise(size, shape=101, seed=1):
    return size * np.random.default_rng(seed).normal(size=shape)


def oscillation(stiffness=8.0, friction=0.1, mass=0.5, q=1.0, qdot=0.3):
    motion = SPRING.motion({m: mass, k: stiffness, c: friction}, q, qdot)
    return motion.integrate(TIMES)


@pytest.mark.parametrize(
    ("stiffness", "friction", "place", "speed", "by_speed"),
    [(37.0, 0.02, 0.5, -2.0, False), (2.5, 0.3, 2.0, 1.0, True)],
)
def test_without_noise_the_truth_comes_back(stiffness, friction, place, speed, by_speed):
    """From a range of k in which the number of turns is unknown."""
    run = oscillation(stiffness, friction, 0.5, place, speed)
    measured = {u: run.qdot[:, 0]} if by_speed else {x: run.q[:, 0]}
    fit = SPRING.fit(TIMES, measured, {k: (1, 50), c: (0, 0.5)}, known={m: 0.5})
    assert fit.parameters == pytest.approx({k: stiffness, c: friction}, rel=1e-6)
    assert [*fit.values] == ["k", "c", "x", "u"]
    assert fit.values["x"] == pytest.approx(place, abs=1e-6)
    assert fit.values["u"] == pytest.approx(speed, abs=1e-6)


def test_errors_cover_the_truth_as_often_as_they_say():
    """30 sets of data of a block that coasts to rest; bounds of three standard deviations."""
    times = np.linspace(0, 3, 31)
    truth = {c: 0.8, u: 2.0}
    way = COASTING.motion({c: 0.8}, 0, 2).integrate(times).q[:, 0]
    assert way == pytest.approx(2 / 0.8 * (1 - np.exp(-0.8 * times)), abs=1e-9)
    pulls = []
    for seed in range(30):
        data = {x: way + noise(0.02, 31, seed)}
        fit = COASTING.fit(times, data, {c: 0.7}, start={x: 0}, starts=1)
        pulls.append([(fit.values[z.name] - truth[z]) / fit.errors[z.name] for z in truth])
    one, two = (np.sum(np.abs(pulls) < sigmas, axis=0) for sigmas in (1, 2))
    assert np.all((one >= 13) & (one <= 28))
    assert np.all(two >= 25)
    assert np.all(np.abs(np.mean(pulls, axis=0)) < 0.55)


def test_the_covariance_is_that_of_the_slopes():
    """Of a given noise it is (JᵀJ)⁻¹ σ², with J by differences; without it that of residuals."""
    run, size = oscillation(), 0.02
    data = run.q[:, 0] + noise(size)
    asked = {"parameters": {k: 7.0, c: 0.2}, "start": {x: 1.0, u: 0.3}, "known": {m: 0.5}}
    fit = SPRING.fit(TIMES, {x: data}, **asked, sigma=size)
    steps = np.diag([1e-4, 1e-5])
    best = np.array([*fit.parameters.values()])

    def place(values):
        return oscillation(*values).q[:, 0]

    sides = [(place(best + h) - place(best - h)) / (2 * h.sum()) for h in steps]
    J = np.stack(sides, axis=1) / size
    assert fit.covariance == pytest.approx(np.linalg.inv(J.T @ J), rel=1e-4)
    assert J.T @ (fit.residuals["x"] / size) == pytest.approx(0, abs=1e-2)  # of sizes of 10³
    free = SPRING.fit(TIMES, {x: data}, **asked)
    scale = np.sum((fit.residuals["x"] / size) ** 2) / 99
    assert free.covariance == pytest.approx(fit.covariance * scale, rel=1e-4)
    assert fit.motion.integrate(TIMES).q[:, 0] == pytest.approx(fit.computed["x"], abs=1e-6)


def test_any_quantities_with_their_own_noise():
    """A pendulum by the height of its bob, in which l stands itself, and by its rate."""
    run = PENDULUM.motion({m: 1, g: 9.81, rod: 0.7}, 1.2).integrate(TIMES)
    height, rate = 0.7 * (1 - np.cos(run.q[:, 0])), run.qdot[:, 0]
    data = {rod * (1 - cos(x)): height + noise(1e-3), u: rate + noise(0.1, seed=2)}
    sigma = dict(zip(data, (1e-3, 0.1), strict=True))
    fit = PENDULUM.fit(TIMES, data, {g: (5, 15), rod: (0.2, 2)}, {x: (0.5, 2)}, {m: 1}, sigma)
    for letter, truth in ((g, 9.81), (rod, 0.7), (x, 1.2)):
        assert abs(fit.values[letter.name] - truth) < 3 * fit.errors[letter.name]
    assert fit.errors["g"] < 0.05
    assert [*fit.residuals] == ["l*(1 - cos(x))", "u"]
    assert np.std(fit.residuals["u"]) == pytest.approx(0.1, rel=0.3)


def test_friction_that_is_smooth_and_a_constraint():
    block = rt.System(m * u**2 / 2 - k * x**2 / 2, x, u, forces=-mu * m * g * tanh(u / 0.1))
    times = np.linspace(0, 4, 81)
    known = {m: 1, g: 9.81, k: 20}
    data = block.motion({**known, mu: 0.05}, 1.0).integrate(times).q[:, 0] + noise(1e-3, 81)
    fit = block.fit(times, {x: data}, {mu: 0.1}, {x: 1, u: 0}, known, **ONCE)
    assert abs(fit.parameters[mu] - 0.05) < 4 * fit.errors["mu"] < 1e-3
    place = {x: 2 * np.sin(1), y: -2 * np.cos(1), u: 0, v: 0}
    run = BOB.motion({m: 1, g: 9.81, rod: 2}, [place[x], place[y]]).integrate(times)
    fit = BOB.fit(times, {x: run.q[:, 0] + noise(1e-3, 81)}, {g: (5, 15)}, place, {m: 1, rod: 2})
    assert abs(fit.parameters[g] - 9.81) < 3 * fit.errors["g"] < 0.01


def test_what_can_not_be_known_is_named():
    data = {x: oscillation().q[:, 0] + noise(0.01)}
    with pytest.raises(
        rt.RigidtopError, match=r"all be known .*: only k/m and m/c are known; give"
    ):
        SPRING.fit(TIMES, data, {k: 8, m: 1, c: 0.1}, **ONCE)
    alone = rt.System(m * u**2 / 2 - k * x**2 / 2, x, u)
    data = {x: alone.motion({m: 0.5, k: 8}, 1).integrate(TIMES).q[:, 0] + noise(0.01)}
    with pytest.raises(rt.RigidtopError, match=r"^k and m can't all .*: only k/m is known; give"):
        alone.fit(TIMES, data, {k: 8, m: 1}, **ONCE)
    fit = alone.fit(TIMES, data, {k: 14}, known={m: 1}, **ONCE)
    assert abs(fit.parameters[k] - 16) < 3 * fit.errors["k"]


def test_powers_and_what_changes_nothing_are_named():
    run = PENDULUM.motion({m: 1, g: 9.81, rod: 0.7}, 1.2).integrate(TIMES)
    data = {x: run.q[:, 0] + noise(0.01)}
    with pytest.raises(rt.RigidtopError, match=r"m can't be known from this: .* change with it"):
        PENDULUM.fit(TIMES, data, {m: 1, g: 9}, {x: 1.2, u: 0}, {rod: 0.7}, **ONCE)
    with pytest.raises(rt.RigidtopError, match=r"only l/g is known"):
        PENDULUM.fit(TIMES, data, {rod: 0.7, g: 9}, {x: 1.2, u: 0}, {m: 1}, **ONCE)
    squares = rt.System(u**2 / 2 - k**2 * g * x**2 / 2, x, u)
    run = squares.motion({k: 2, g: 3}, 1).integrate(TIMES)
    with pytest.raises(rt.RigidtopError, match=r"only k\*\*2\*g is known|only g\*k\*\*2 is known"):
        squares.fit(TIMES, {x: run.q[:, 0]}, {k: 2.1, g: 2.8}, {x: 1, u: 0}, **ONCE)


DATA = {x: np.cos(TIMES)}


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((TIMES, DATA, {k: 1, c: 1}), "m has no number: parameters has what shall be found, known"),
        ((TIMES, DATA, {k: 1, c: 1, m: 1}, {}, {m: 1}), "m is in parameters and in known"),
        ((TIMES[::-1], DATA), "t must increase from row to row"),
        ((TIMES, {x: [1, 2]}), "must be 101 numbers, as t has them, not of shape"),
        ((TIMES, {}), "what was measured is given as {quantity: row of 101 numbers}"),
        ((TIMES, {"x": TIMES}), "what was measured must be an expression of SymPy"),
        ((TIMES, {y: TIMES}, {k: 1, c: 1, m: 1}), "no number for y: the system has"),
        ((TIMES, DATA, {y: 1}), "parameters has y: there is"),
        ((TIMES, DATA, {k: (2, 1), c: 1, m: 1}), r"the range of k is \(low, high\), not \(2, 1\)"),
        ((TIMES, DATA, {k: -1, c: 1, m: 1}), "k must be positive, not -1"),
        ((TIMES, DATA, {k: 1, c: 1}, {y: 1}, {m: 1}), "start has y: there is x, u"),
        ((TIMES, DATA, {}, {x: 1, u: 0}, {k: 1, c: 1, m: 1}), "what shall be found?"),
        ((TIMES, DATA, {k: 1, c: 1}, {}, {m: 1}, {u: 1}), "sigma is one number, or has one for"),
        ((TIMES, DATA, {k: 1, c: 1}, {}, {m: 1}, -1), "sigma must be positive"),
        ((TIMES[:3], {x: TIMES[:3]}, {k: 1, c: 1}, {}, {m: 1}), "3 rows are too few"),
    ],
)
def test_what_is_no_fit_is_said(arguments, said):
    with pytest.raises(rt.RigidtopError, match=said):
        SPRING.fit(*arguments)


def test_a_force_that_jumps_and_a_start_that_is_tied_are_said():
    dry = rt.System(u**2 / 2, x, u, forces=-mu * sign(u))
    with pytest.raises(rt.RigidtopError, match=r"may jump with sign\(u\)"):
        dry.fit(TIMES, {x: TIMES}, {mu: 1})
    run = BOB.motion({m: 1, g: 9.81, rod: 2}, [2 * np.sin(1), -2 * np.cos(1)]).integrate(TIMES)
    data = {x: run.q[:, 0], y: run.q[:, 1]}
    with pytest.raises(rt.RigidtopError, match=r"constraint|can't change alone"):
        BOB.fit(TIMES, data, {g: 9}, known={m: 1, rod: 2})


def test_other_names_and_sines():
    """Coordinates that are functions of time, by a quantity of theirs."""
    from sympy.physics.mechanics import dynamicsymbols

    a = dynamicsymbols("a")
    system = rt.System(a.diff() ** 2 / 2 + g * cos(a), a)
    run = system.motion({g: 4}, 1).integrate(TIMES)
    fit = system.fit(TIMES, {sin(a): np.sin(run.q[:, 0]), a.diff(): run.qdot[:, 0]}, {g: (1, 9)})
    assert fit.values == pytest.approx({"g": 4, "a": 1, "a_dot": 0}, abs=1e-5)
