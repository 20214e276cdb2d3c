"""Mechanisms: recursion from link to link against bodies in space and against Lagrange."""

import math
import sys
from pathlib import Path

import numpy as np
import pytest
import sympy
from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt
from rigidtop.theory.rotation import euler_matrix

m, length, g, tau = symbols("m length g tau", positive=True)
t = dynamicsymbols._t
theta, slide = dynamicsymbols("theta slide")
TILT = euler_matrix(Rational(1, 3), Rational(1, 2), Rational(-2, 7))
GRAVITY = (0, Rational(1, 2), -g)
third = Rational(1, 3)


def link(name, k=0):
    """A body whose tensor and centre lie in no symmetric way."""
    xy, xz, yz = Rational(1, 5), Rational(k, 11), Rational(1, 10)
    centre = (Rational(k, 5), Rational(1, 7), -Rational(k + 1, 9))
    tensor = [[2, xy, xz], [xy, 3, yz], [xz, yz, Rational(5, 2)]]
    return rt.Link(name, Rational(2 + k, 3), centre, tensor)


BASE = link("base", 2)
TURNS = rt.Joint("theta", "base", "one", axis=(1, 2, 2), place=(third, 1, 0), attitude=TILT)
SLIDES = rt.Joint("slide", "one", "two", "prismatic", (0, 1, 1), (0, 0, third), TILT.T)
MOTOR = rt.Joint("motor", "one", "three", axis=(0, 1, 0), motion=3 * t + sin(t))
GEAR = rt.Joint(
    "gear", "three", "four", axis=(0, 0, -1), place=(0, third, 0), motion=-2 * theta + slide * t
)
END = rt.Joint("end", "two", "five", axis=(1, 0, 1), place=(third, 0, 0), attitude=TILT)
STICK = rt.Joint("stick", "one", "three", "fixed", place=(0, 1, 1), attitude=TILT)


def mechanism(*joints):
    moved = [joint.child for joint in joints]
    return rt.Mechanism([BASE, *(link(name, k) for k, name in enumerate(moved))], joints)


def row(system, seed=1):
    rng = np.random.default_rng(seed)
    return rng.uniform(0.4, 1.4, len(system.numeric.arguments)).tolist()


@pytest.mark.parametrize(
    "joints",
    [[TURNS], [TURNS, SLIDES], [TURNS, MOTOR], [TURNS, STICK]],
    ids=["a skew axis", "a slide on it", "a motor on it", "a body that is fixed to it"],
)
def test_recursion_gives_what_lagrange_gives(joints):
    system = mechanism(*joints).system(GRAVITY)
    other = rt.System(system.L, system.q)
    at = row(system)
    assert len(at) == len(other.numeric.arguments)
    for quantity in ("solved", "energy", "momenta"):
        found, wanted = (getattr(each.numeric, quantity).scalar(*at) for each in (system, other))
        assert found == pytest.approx(wanted, rel=1e-12)


def test_a_system_of_joints_certifies_itself():
    turns = rt.Joint("theta", "base", "one", axis=(0, 1, 0))
    made = mechanism(turns, rt.Joint("slide", "one", "two", "prismatic", (0, 0, 1)))
    found = made.system((0, 0, -g)).certify({g: 9.81})
    assert {"Hamilton", "Newton–Euler", "Lagrange", "balance of energy"} == found.keys()
    assert max(found.values()) < 1e-11


def test_branches_motors_and_gears_move_as_bodies_in_space():
    """By d'Alembert's principle for the bodies: an independent way, with forces in joints."""
    made = mechanism(TURNS, SLIDES, MOTOR, GEAR, END)
    assert made.q == (theta, slide, dynamicsymbols("end"))
    by_joints = made.system(GRAVITY, forces={"gear": tau, "end": -1, slide: 2 * tau})
    pushes = [-2 * tau, (2 + t) * tau, -1]
    by_bodies = rt.System.of_parts(made.bodies, made.q, gravity=GRAVITY, forces=pushes)
    for seed in (1, 2):
        at = row(by_joints, seed)
        for quantity in ("solved", "momenta", "frames"):
            found, wanted = (
                getattr(each.numeric, quantity).scalar(*at) for each in (by_joints, by_bodies)
            )
            assert found == pytest.approx(wanted, rel=1e-12, abs=1e-12)
    assert by_joints.program.operations < 0.6 * by_bodies.program.operations
    run = by_joints.motion({g: 9.81, tau: 0.7}, [0.1, 0.2, 0.3]).integrate([0, 1, 2])
    assert max(run.drift().values()) < 1e-9


def test_places_and_attitudes_are_those_in_space():
    made = mechanism(TURNS, SLIDES)
    run = made.system(GRAVITY).motion({g: 9.81}, [0.5, 0.2]).integrate([0.0, 0.5])
    weights = np.arange(1.0, 10.0).reshape(3, 3) ** 2  # of which no two sums agree by chance
    for k, body in enumerate(made.bodies):
        wanted = run.value((sympy.Matrix(weights[0]).T * body.place)[0])
        assert run.places()[k] @ weights[0] == pytest.approx(wanted)
        wanted = run.value((sympy.Matrix(weights).T * body.attitude).trace())
        assert np.sum(run.attitudes()[k] * weights, axis=(1, 2)) == pytest.approx(wanted)
    assert run.energy == pytest.approx(run.value(run.motion.system.energy))


def test_damping_takes_what_the_rate_gives():
    """θ̈ = −d θ̇ of a wheel of unit inertia; geared, twice the rate takes four times as much."""
    wheel = rt.Link("wheel", 1, inertia=(1, 1, 1))
    d = symbols("d", positive=True)
    own = rt.Joint("theta", "base", "wheel", damping=d)
    made = rt.Mechanism([rt.Link("base"), wheel], [own]).system()
    assert made.accelerations[0] == -d * theta.diff()
    geared = rt.Joint("theta", "base", "wheel", damping=d, motion=2 * theta)
    made = rt.Mechanism([rt.Link("base"), wheel], [geared]).system()
    assert made.accelerations[0] == -d * theta.diff()
    assert made.rayleigh == 2 * d * theta.diff() ** 2


def test_a_loop_is_closed_by_a_constraint():
    """Four bars: the ends of two cranks are held at the distance of a rod without mass."""
    crank = [rt.Link(name, 1, (0, Rational(-1, 2), 0), (1, 1, 1)) for name in ("left", "right")]
    joints = [rt.Joint("alpha", "wall", "left"), rt.Joint("beta", "wall", "right", place=(1, 0, 0))]
    made = rt.Mechanism([rt.Link("wall"), *crank], joints)
    apart = made.place("left", (0, -1, 0)) - made.place("right", (0, -1, 0))
    system = made.system((0, -10, 0), constraints=apart.dot(apart) - 1)
    alpha, beta = system.q
    run = system.motion({}, {alpha: 0.3, beta: 0.3}).integrate((0, 3))
    assert run.drift()["constraint 1"] < 1e-14
    assert run.value(alpha - beta) == pytest.approx(0, abs=1e-9)  # a parallelogram


def test_a_chain_of_twenty_bodies_is_not_written_out():
    links = [rt.Link("base"), *(rt.Link(f"l{k}", m, (0, 0, -length), (2, 3, 1)) for k in range(20))]
    joints = [
        rt.Joint(
            f"q{k}",
            links[k].name,
            f"l{k}",
            axis=((1, 0, 0), (0, 1, 0))[k % 2],
            place=(0, 0, -2 * length if k else 0),
        )
        for k in range(20)
    ]
    system = rt.Mechanism(links, joints).system((0, 0, -g))
    assert system.program.operations < 10000
    motion = system.motion({m: 1, length: 0.25, g: 9.81}, np.linspace(0.1, 0.5, 20))
    run = motion.integrate([0.0, 0.1])
    assert np.ptp(run.energy) < 1e-8 * np.abs(run.energy).max()
    assert run.places().shape == (20, 2, 3)
    assert np.linalg.norm(run.places()[19], axis=1).max() < 39 * 0.25
    assert "L" not in vars(system)


def test_an_arm_is_shorter_by_joints_than_by_bodies():
    sys.path.insert(0, str(Path(__file__).parent.parent / "benchmarks"))
    try:
        from systems import arm, arm_by_joints
    finally:
        sys.path.pop(0)
    by_bodies, by_joints = arm(), arm_by_joints()
    assert by_joints.program.operations < 0.65 * by_bodies.program.operations
    values = {x.name: 0.5 + k / 60 for k, x in enumerate(by_bodies.numeric.arguments)}
    found, wanted = (
        each.numeric.solved.scalar(*(values[x.name] for x in each.numeric.arguments))
        for each in (by_joints, by_bodies)
    )
    assert found == pytest.approx(wanted, rel=1e-11)


def test_a_name_that_is_none_in_python():
    made = rt.Mechanism(
        [rt.Link("wall"), rt.Link("bob", 1, (0, -1, 0))], [rt.Joint("left-hip", "wall", "bob")]
    )
    system = made.system((0, -g, 0))
    run = system.motion({g: 1}, [0.1]).integrate([0.0, math.pi])
    assert run.q[-1, 0] == pytest.approx(-0.1, abs=1e-3)
    assert "sin" in system.source("c")


ONE, TWO, WALL = rt.Link("one", 1), rt.Link("two", 1), rt.Link("wall")


def tree(*joints, links=(WALL, ONE, TWO)):
    return lambda: rt.Mechanism(list(links), list(joints))


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (
            tree(rt.Joint("a", "wall", "one"), rt.Joint("b", "two", "one")),
            "two joints move the link one: a and b",
        ),
        (tree(rt.Joint("a", "one", "two"), rt.Joint("b", "two", "one")), "one go round in a loop"),
        (
            tree(rt.Joint("a", "one", "two"), rt.Joint("b", "two", "one"), links=(ONE, TWO)),
            "moved by no joint, the root, and not none",
        ),
        (tree(rt.Joint("a", "wall", "one")), "the root, and not wall and two"),
        (tree(rt.Joint("a", "wall", "hand")), "the joint a has hand, which is no link"),
        (tree(rt.Joint("a", "wall", "one"), rt.Joint("a", "wall", "two")), "joints are called a"),
        (tree(links=(WALL, WALL)), "two links are called wall"),
        (tree(links=(WALL, 3)), "among the links is 3"),
        (lambda: rt.Mechanism("wall", []), "the links are a row of them, not 'wall'"),
        (lambda: rt.Link(3), "a link has a name, not 3"),
        (lambda: rt.Link("one", sin(theta)), "the link one has .*, which changes: it is rigid"),
        (lambda: rt.Link("one", 1, (0, 0, 0), (1, 2)), "three principal moments, not 2"),
        (lambda: rt.Joint("a", "b", "c", axis=(0, 0, 0)), "the axis of the joint a is zero"),
        (lambda: rt.Joint("a", "b", "c", "screw"), "is revolute, prismatic or fixed, not 'screw'"),
        (lambda: rt.Joint("a", "b", "c", "fixed", motion=1), "it has no motion and no damping"),
        (lambda: rt.Joint("a", "b", "c", motion=theta.diff()), "and time, not of rates"),
        (lambda: rt.Joint("a", "b", "c", place=(t, 0, 0)), "the joint a has t, which changes"),
        (lambda: rt.Joint("a", "b", "c", attitude=2 * sympy.eye(3)), "the attitude is no rotation"),
        (lambda: mechanism(TURNS).place("hand"), "no link is called 'hand'"),
        (lambda: mechanism(TURNS).system(forces={"elbow": 1}), "a force in 'elbow', which is no"),
        (lambda: mechanism(TURNS, MOTOR).system(forces={"motor": 1}), "motion of motor is given"),
        (
            lambda: tree(
                rt.Joint("a", "wall", "one"), rt.Joint("b", "one", "hand"),
                links=(WALL, rt.Link("one", 1, (1, 0, 0)), rt.Link("hand")),
            )().system().program,
            "the mass matrix is singular: L is not quadratic in Derivative\\(b",
        ),
    ],
)  # fmt: skip
def test_what_is_no_mechanism_is_said_in_one_line(make, said):
    with pytest.raises(rt.RigidtopError, match=said) as error:
        make()
    assert "\n" not in str(error.value)


def test_a_mechanism_stands_beside_other_parts():
    """A pendulum by a joint and another by its place: the same equation twice."""
    other = dynamicsymbols("phi")
    bob = rt.Link("bob", m, (0, -length, 0))
    hung = rt.Mechanism([rt.Link("wall"), bob], [rt.Joint("theta", "wall", "bob")])
    mass = rt.Mass(m, [length * sin(other), -length * cos(other)])
    system = rt.System.of_parts([hung, mass], [theta, other], gravity=[0, -g])
    assert list(system.accelerations) == [-g * sin(x) / length for x in (theta, other)]
