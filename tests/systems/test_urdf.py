"""Robots from their files, against MuJoCo and Pinocchio; broken and hostile files."""

import os

import numpy as np
import pytest
from sympy import Rational, cos, pi, sin
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

ARM = """<?xml version="1.0"?>
<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><origin xyz="0.1 -0.02 0.3" rpy="0.1 -0.2 0.3"/><mass value="2.5"/>
    <inertia ixx="0.4" ixy="0.01" ixz="-0.02" iyy="0.3" iyz="0.03" izz="0.2"/></inertial></link>
  <link name="lower"><inertial><origin xyz="0 0.2 0.05"/><mass value="1.5"/>
    <inertia ixx="0.2" ixy="0" ixz="0.01" iyy="0.15" iyz="0" izz="0.1"/></inertial></link>
  <link name="plate"><inertial><origin xyz="0.05 0 0"/><mass value="0.3"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.015"/></inertial></link>
  <link name="rod"><inertial><origin xyz="0 0 0.1"/><mass value="0.7"/>
    <inertia ixx="0.05" ixy="0" ixz="0" iyy="0.06" iyz="0" izz="0.02"/></inertial></link>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/>
    <origin xyz="0 0 0.4" rpy="1.5708 0 0.3"/><axis xyz="0 0 1"/><dynamics damping="0.2"/></joint>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="lower"/>
    <origin xyz="0.2 0 0.5" rpy="0.2 -0.7854 0.1"/><axis xyz="1 2 2"/>
    <limit lower="-9" upper="9" effort="9" velocity="9"/></joint>
  <joint name="weld" type="fixed"><parent link="lower"/><child link="plate"/>
    <origin xyz="0 0.3 0" rpy="0.5 0 0"/></joint>
  <joint name="slide" type="prismatic"><parent link="plate"/><child link="rod"/>
    <origin xyz="0 0.1 0.1" rpy="0 0.4 0"/><axis xyz="0 1 1"/><dynamics damping="0.5"/>
    <limit lower="-9" upper="9" effort="9" velocity="9"/></joint>
</robot>"""
RIGHT = ARM.replace("1.5708", repr(np.pi / 2)).replace("0.7854", repr(np.pi / 4))
"""For those that know no parts of π."""


def states():
    rng = np.random.default_rng(3)
    return rng.uniform(-1.0, 1.0, (5, 6))


@pytest.fixture(scope="module")
def arm():
    return rt.Mechanism.from_urdf(ARM).system(gravity=(0, 0, Rational(-981, 100)))


def test_an_arm_moves_as_in_pinocchio(arm):
    pin = pytest.importorskip("pinocchio")
    model = pin.buildModelFromXML(RIGHT)
    data, damping = model.createData(), np.array([0.2, 0, 0.5])
    for state in states():
        q, v = state[:3], state[3:]
        full = np.array([np.cos(q[0]), np.sin(q[0]), *q[1:]])  # a continuous joint there
        wanted = pin.aba(model, data, full, v, -damping * v)
        assert arm.numeric.solved.scalar(0.0, *q, *v) == pytest.approx(wanted, abs=1e-10)


def test_an_arm_moves_as_in_mujoco(arm):
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_string(RIGHT)
    model.dof_damping[:] = [0.2, 0, 0.5]
    model.opt.gravity[:] = [0, 0, -9.81]
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
    data = mujoco.MjData(model)
    for state in states():
        data.qpos[:], data.qvel[:] = state[:3], state[3:]
        mujoco.mj_forward(model, data)
        found = arm.numeric.solved.scalar(0.0, *state)
        assert found == pytest.approx(data.qacc, abs=1e-10)


def one(kind, inside="", links=""):
    return f"""<robot name="one"><link name="wall"/>{links}<link name="body"><inertial>
    <origin xyz="0.1 0.2 0.3"/><mass value="2"/>
    <inertia ixx="0.4" ixy="0.01" ixz="0" iyy="0.3" iyz="0" izz="0.2"/></inertial></link>
    <joint name="free" type="{kind}"><parent link="wall"/><child link="body"/>{inside}</joint>
    </robot>"""


def test_a_body_floats_by_six_coordinates():
    made = rt.Mechanism.from_urdf(one("floating"))
    names = ["free_x", "free_y", "free_z", "free_yaw", "free_pitch", "free_roll"]
    assert [x.func.__name__ for x in made.q] == names
    run = made.system((0, 0, -10)).motion({}, [0, 0, 0, 0.1, 0.2, 0.3]).integrate([0, 1])
    assert run.q[-1] == pytest.approx([0, 0, -5, 0.1, 0.2, 0.3])  # it falls, and does not turn
    pushed = made.system((0, 0, 0)).motion({}, [0] * 6, [1, 0, 0, 0.5, 0.2, 0.3])
    assert max(pushed.integrate((0, 2)).drift().values()) < 1e-9


def test_a_body_glides_across_the_axis_of_a_planar_joint():
    made = rt.Mechanism.from_urdf(one("planar", '<axis xyz="0 0 2"/>'))
    x, y, yaw = made.q
    assert list(made.place("body")) == [x, y, 0]
    assert made.attitude("body")[0, 0] == cos(yaw)


def test_a_joint_mimics_another():
    mimic = '<mimic joint="elbow" multiplier="-0.5" offset="1"/>'
    text = ARM.replace('<axis xyz="0 1 1"/>', '<axis xyz="0 1 1"/>' + mimic)
    made = rt.Mechanism.from_urdf(text)
    shoulder, elbow = dynamicsymbols("shoulder elbow")
    assert made.q == (shoulder, elbow)
    assert made.joints[-1].motion == 1 - elbow / 2


def test_angles_that_are_written_short_are_parts_of_a_turn():
    made = rt.Mechanism.from_urdf(ARM)
    assert made.joints[0].attitude[2, 2] == 0
    assert made.joints[1].attitude[2, 0] == sin(pi / 4)
    short = rt.Mechanism.from_urdf(ARM.replace("1.5708", "1.57"))
    assert short.joints[0].attitude[2, 2] == cos(Rational(157, 100))


def test_a_file_is_read_as_its_text(tmp_path):
    path = tmp_path / "arm.urdf"
    path.write_text(ARM)
    assert rt.Mechanism.from_urdf(path) == rt.Mechanism.from_urdf(str(path))
    assert rt.Mechanism.from_urdf(path).joints == rt.Mechanism.from_urdf(ARM).joints


RUBS = '<dynamics friction="0.1"/>'
BOMB = '<!DOCTYPE x [<!ENTITY a "ha"><!ENTITY b "&a;&a;">]><robot name="&b;"/>'


def test_coulomb_friction_is_refused_unless_it_is_left_out():
    with pytest.raises(rt.RigidtopError, match=r"free has Coulomb friction.*friction=False"):
        rt.Mechanism.from_urdf(one("continuous", RUBS))
    assert rt.Mechanism.from_urdf(one("continuous", RUBS), friction=False).joints[0].damping == 0


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (BOMB, "no DOCTYPE and no entities"),
        ("<robot", "the URDF is broken"),
        ("<sdf/>", "a URDF is a robot, not 'sdf'"),
        ("<robot/>", "moved by no joint, the root, and not none"),
        ("<robot><link/></robot>", "a link of the URDF has no name"),
        ("<robot>" * 100_000, "the URDF is broken"),
        ('<robot xmlns:x="http://ros.org/xacro"><x:macro/></robot>', "expand them with xacro"),
        (one("screw"), "free is of no known type: 'screw'"),
        (one("continuous", '<axis xyz="0 0"/>'), "xyz of free is 3 numbers, not '0 0'"),
        (one("continuous", '<axis xyz="0 0 exit()"/>'), "xyz of free is 3 numbers, not"),
        (one("continuous", '<axis xyz="0 0 1e999999999"/>'), "xyz of free is 3 numbers, not"),
        (one("continuous", '<axis xyz="0 0 0"/>'), "the axis of the joint free is zero"),
        (one("planar", '<axis xyz="0 0 0"/>'), "the axis of the joint free is zero"),
        (one("floating", '<dynamics damping="1"/>'), "floating, and has one damping"),
        (one("continuous", '<mimic joint="free"/>'), "the joint free mimics itself"),
        (one("continuous", '<mimic joint="hand"/>'), "free mimics 'hand', which can't be"),
        (one("continuous").replace('<parent link="wall"/>', ""), "the joint free has no parent"),
        (one("continuous").replace('<parent link="wall"/>', '<parent link="x"/>'), "is no link"),
        ("nowhere", "the URDF 'nowhere' can't be read: there is no such file"),
        (3, "a URDF is a path or a text, not 3"),
    ],
)  # fmt: skip
def test_what_is_no_urdf_is_said_in_one_line(text, said):
    with pytest.raises(rt.RigidtopError, match=said) as error:
        rt.Mechanism.from_urdf(text)
    assert "\n" not in str(error.value)


def test_pipes_and_other_bytes_are_no_files(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    with (tmp_path / "large").open("wb") as file:
        file.truncate(30_000_000)
    (tmp_path / "bytes").write_bytes(b"\xff\xfe<\x00")
    wanted = {
        "pipe": "there is no such file",
        "": "there is no such file",
        "bytes": "it is not in UTF-8",
        "large": "it is larger than 20 MB",
    }
    for name, said in wanted.items():
        with pytest.raises(rt.RigidtopError, match=said):
            rt.Mechanism.from_urdf(tmp_path / name)
