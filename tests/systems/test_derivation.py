"""The way from L to the equations of motion: every line follows, and nothing else does."""

from dataclasses import replace

import pytest
from sympy import cos, sin, symbols

import rigidtop as rt
from rigidtop.proof.derivation import judge_line

m, k, c, g, R, length = symbols("m k c g R length", positive=True)
x, y, u, v, F, t, r, w = symbols("x y u v F t r w", real=True)
ORBIT = rt.System(m * (u**2 + r**2 * w**2) / 2 + k / r, [r, x], [u, w])
SYSTEMS = {
    "two coordinates, one cyclic": ORBIT,
    "forced and damped": rt.System(
        m * u**2 / 2 - k * x**2 / 2, x, u, forces=F * cos(3 * t), rayleigh=c * u**2 / 2
    ),
    "with letters that have other units in the lecture": rt.System(
        m * u**2 / 2 - k * x**2 / 2, x, u, forces=R * cos(g * t) - length * u
    ),
    "with the time": rt.System(m * u**2 / 2 - k * x**2 * cos(3 * t) / 2, x, u),
    "by a constraint": rt.System(
        m * (u**2 + v**2) / 2 - m * g * y, [x, y], [u, v], constraints=x**2 + y**2 - length**2
    ),
    "coupled": rt.System(m * (u**2 + v**2 + u * v) / 2 - k * sin(y), [x, y], [u, v]),
    "sleigh": rt.System(
        m * (u**2 + v**2 + R**2 * w**2) / 2,
        [x, y, r],
        [u, v, w],
        forces={r: F},
        constraints=u * sin(r) - v * cos(r),
    ),
}


@pytest.fixture(scope="module", params=SYSTEMS)
def way(request):
    return SYSTEMS[request.param].derivation()


def test_every_line_follows(way):
    assert way.gaps() == ()
    assert way.follows
    assert len(way) > 7


def test_nothing_is_cited_for_nothing_and_every_change_falls(way):
    if len(way.system.q) > 2:
        pytest.skip("takes long, and shows nothing else")
    for id in list(way.lecture.lines)[::2]:
        trial = way.lecture.trial(id)
        assert trial.unneeded == (), id
        survived = trial.survived
        if way.lecture.lines[id].sentence.startswith("Solve"):
            # p = const says what its rate says.
            survived = [x for x in survived if not x.endswith("cited instead")]
        assert not survived, id


def test_it_ends_at_the_accelerations():
    last = [line for line in ORBIT.derivation() if line.line.sentence.startswith("Solve")]
    found = [e.sides[1] for line in last for e in line.line.equations]
    names = {z.name: z for z in ORBIT.names.q + ORBIT.names.v + ORBIT.parameters}
    back = [e.xreplace({z: names[z.name] for z in e.free_symbols}) for e in found]
    assert back == list(ORBIT.accelerations)


def test_where_it_stops_before_the_accelerations_it_says_why():
    q, v = symbols("q1:6", real=True), symbols("v1:6", real=True)
    coupled = m * (sum(v) ** 2 + sum(rate**2 for rate in v)) / 2 - k * sum(z**2 for z in q) / 2
    way = rt.System(coupled, q, v).derivation()
    assert way.follows
    said = "They are not solved here: 5 unknowns stand in 5 equations at once"
    assert said in str(way)
    assert said in way.markdown()
    assert "not solved here" not in str(ORBIT.derivation())


def test_a_wrong_lagrangian_is_a_gap():
    way = ORBIT.derivation()
    for judged in way:
        if judged.line.sentence.startswith("Differentiate"):
            [equation] = judged.line.equations
            wrong = type(equation)(equation.sides[0], equation.sides[1] + 1)
            assert not judge_line(
                replace(judged.line, equations=(wrong,)), way.lecture.letters
            ).follows


def test_it_shows_itself():
    way = ORBIT.derivation()
    assert repr(way) == f"<Derivation: {len(way)} lines, all follow>"
    assert "Lagrange's equation for r" in str(way)
    assert "∂ℒ/∂w = mwr²" in str(way)
    assert r"\frac{\partial\mathcal{L}}{\partial w}" in way.latex()
    assert "<math" in way._repr_html_()
    assert {step["verdict"] for step in way.steps()} == {"definition", "follows"}


def test_functions_of_time_that_are_not_known_are_refused():
    from sympy import Function

    lifted = rt.System(m * (u + Function("a")(t)) ** 2 / 2, x, u)
    with pytest.raises(rt.RigidtopError, match=r"L has the function a\(t\)"):
        lifted.derivation()


def test_letters_without_assumptions_are_printed_as_parameters():
    from sympy.physics.mechanics import dynamicsymbols

    theta = dynamicsymbols("theta")
    M, arm = symbols("M l")
    made = rt.System(M * arm**2 * theta.diff() ** 2 / 2, theta).derivation()
    assert "∂ℒ/∂θ̇ = Ml²θ̇" in str(made)
    assert "where M ≠ 0 and l ≠ 0" in str(made) or "where l ≠ 0 and M ≠ 0" in str(made)
