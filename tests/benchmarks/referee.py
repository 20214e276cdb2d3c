"""How far engines for bodies are from the exact top and the exact free body.

Each engine that is installed runs both motions at its own time step, at longer ones and at a
shorter one; the error is the largest angle between its attitude and the exact one at 21 times, and
the order is that in which halving the step lessens it, as far as that is more than rounding.  What
an engine is asked to do is what its manual has for a body that turns about a point, without
contacts.

Run ``python tests/benchmarks/referee.py``; ``-o FOLDER`` writes the exact motions as files, for
those who write simulators.
"""

from __future__ import annotations

import argparse
import importlib
import json
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion.attitude import Floats
from rigidtop.motion.body import FreeBody
from rigidtop.motion.motion import Motion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import EXAMPLE_TOP
from rigidtop.terminal.files import write_all
from rigidtop.terminal.progress import bar

SAMPLES = 20
"""So many times after t = 0."""

STEPS = (4.0, 2.0, 1.0, 0.5)
"""Of an engine's own step."""

ROUNDING = 1e-12
"""Errors (rad) below this tell no order."""


@dataclass(frozen=True)
class Case:
    """A motion that engines are held against: its body about the point that the joint holds."""

    name: str
    motion: Motion
    end: float
    """How long it lasts (s)."""

    mass: float
    arm: float
    """From the joint to the centre of mass along e₃ (m); 0 of a free body."""

    gravity: float = 0.0

    @property
    def times(self) -> Floats:
        return np.linspace(0.0, self.end, SAMPLES + 1)

    @property
    def central(self) -> tuple[float, float, float]:
        """Moments about the centre of mass (kg m²)."""
        shift = self.mass * self.arm**2
        first, second, third = self.motion.body.moments
        return first - shift, second - shift, third

    @property
    def quaternion(self) -> Floats:
        """At the start, scalar first."""
        x, y, z, w = self.motion.attitude.as_quat()
        return np.array([w, x, y, z])


def cases() -> tuple[Case, ...]:
    """A top that nutates, and a free body with three moments."""
    top = HeavyTop(**EXAMPLE_TOP)
    free = FreeBody(1.0, 1.7, 2.5)
    return (
        Case("heavy top", top.motion(theta=0.5, phi_dot=1.0, omega3=20.0), 1.6, 1.0, 0.5, top.g),
        Case("free body", free.motion(omega=(1.0, 0.5, 2.0)), 4.8, 1.0, 0.0),
    )


Runner = Callable[[Case, float], Floats]
"""A case and a time step (s) in, quaternions at the case's times out, scalar first, (N, 4)."""


@dataclass(frozen=True)
class Setting:
    """An engine with one of its integrators; `step` is its own default (s)."""

    engine: str
    module: str
    integrator: str
    step: float
    run: Runner


@dataclass(frozen=True)
class Score:
    """What an engine did: errors (rad) at `STEPS` of its own `step` (s)."""

    case: str
    engine: str
    integrator: str
    step: float
    errors: tuple[float, ...]
    note: str = ""

    @property
    def order(self) -> float:
        """log₂ of the ratio of the last two errors that are more than rounding."""
        known = [error for error in self.errors if error > ROUNDING]
        return math.log2(known[-2] / known[-1]) if len(known) > 1 else math.nan


def settings() -> tuple[Setting, ...]:
    """All that is known here."""
    return (
        *(
            Setting("MuJoCo", "mujoco", name, 0.002, _mujoco(name))
            for name in ("Euler", "implicit", "implicitfast", "RK4")
        ),
        Setting("Pinocchio", "pinocchio", "aba, semi-implicit Euler", 0.001, _pinocchio),
        *(
            Setting("Drake", "pydrake", name, 0.001, _drake(name))
            for name in ("semi_explicit_euler", "runge_kutta2", "runge_kutta3")
        ),
        Setting("Exudyn", "exudyn", "generalised alpha", 0.001, _exudyn),
        # Its own step is 1/240 s, of which no number meets the times.
        Setting("PyBullet", "pybullet", "multibody", 0.004, _pybullet),
    )


def judge(
    chosen: Sequence[Setting] | None = None, progress: Callable[[int, int], None] | None = None
) -> list[Score]:
    """Run all that is installed; what is not has a note."""
    pairs = [(s, c) for s in (settings() if chosen is None else chosen) for c in cases()]
    scores = []
    for done, (setting, case) in enumerate(pairs):
        scores.append(_score(setting, case))
        if progress is not None:
            progress(done + 1, len(pairs))
    return scores


def _score(setting: Setting, case: Case) -> Score:
    try:
        importlib.import_module(setting.module)
    except ImportError:
        note = f"{setting.module} is not installed"
        return Score(case.name, setting.engine, setting.integrator, setting.step, (), note)
    exact = case.motion.exact(case.times).rotation
    errors = []
    for share in STEPS:
        found = setting.run(case, setting.step * share)
        if found.shape != (SAMPLES + 1, 4) or not np.all(np.isfinite(found)):
            raise RigidtopError(f"{setting.engine} gives no attitudes for the {case.name}")
        apart = (exact.inv() * Rotation.from_quat(found[:, [1, 2, 3, 0]])).magnitude()
        errors.append(float(np.max(apart)))
    return Score(case.name, setting.engine, setting.integrator, setting.step, tuple(errors))


def _every(case: Case, step: float) -> int:
    """Steps between two samples."""
    count = case.end / SAMPLES / step
    if abs(count - round(count)) > 1e-6:
        raise RigidtopError(f"a step of {step:g} s does not meet the times of the {case.name}")
    return round(count)


def _mujoco(integrator: str) -> Runner:
    def run(case: Case, step: float) -> Floats:
        mujoco = importlib.import_module("mujoco")
        joint = '<joint type="ball"/>' if case.arm else "<freejoint/>"
        moments = " ".join(map(repr, case.central))
        model = mujoco.MjModel.from_xml_string(
            f"""<mujoco>
            <option timestep="{step!r}" integrator="{integrator}" gravity="0 0 {-case.gravity!r}"/>
            <worldbody><body>{joint}
            <inertial pos="0 0 {case.arm!r}" mass="{case.mass!r}" diaginertia="{moments}"/>
            </body></worldbody></mujoco>"""
        )
        data = mujoco.MjData(model)
        place, rate = (slice(0, 4), slice(0, 3)) if case.arm else (slice(3, 7), slice(3, 6))
        data.qpos[place], data.qvel[rate] = case.quaternion, case.motion.omega
        found = [np.array(data.qpos[place])]
        for _ in range(SAMPLES):
            mujoco.mj_step(model, data, _every(case, step))
            found.append(np.array(data.qpos[place]))
        return np.stack(found)

    return run


def _pinocchio(case: Case, step: float) -> Floats:
    pin = importlib.import_module("pinocchio")
    model = pin.Model()
    joint = model.addJoint(0, pin.JointModelSpherical(), pin.SE3.Identity(), "point")
    body = pin.Inertia(case.mass, np.array([0.0, 0.0, case.arm]), np.diag(case.central))
    model.appendBodyToJoint(joint, body, pin.SE3.Identity())
    model.gravity.linear = np.array([0.0, 0.0, -case.gravity])
    data = model.createData()
    q, v = case.quaternion[[1, 2, 3, 0]], np.array(case.motion.omega)
    found, none = [q], np.zeros(3)
    for _ in range(SAMPLES):
        for _ in range(_every(case, step)):
            v = v + step * pin.aba(model, data, q, v, none)
            q = pin.integrate(model, q, step * v)
        found.append(q)
    return np.stack(found)[:, [3, 0, 1, 2]]


def _drake(integrator: str) -> Runner:
    """With fixed steps: by itself it chooses them to an accuracy."""

    def run(case: Case, step: float) -> Floats:
        plants = importlib.import_module("pydrake.multibody.plant")
        trees = importlib.import_module("pydrake.multibody.tree")
        maths = importlib.import_module("pydrake.math")
        analysis = importlib.import_module("pydrake.systems.analysis")
        plant = plants.MultibodyPlant(0.0)
        central = trees.RotationalInertia(*case.central)
        inertia = trees.SpatialInertia.MakeFromCentralInertia(
            case.mass, [0.0, 0.0, case.arm], central
        )
        body = plant.AddRigidBody("body", inertia)
        if case.arm:
            joint = trees.BallRpyJoint("point", plant.world_frame(), body.body_frame())
            point = plant.AddJoint(joint)
        plant.mutable_gravity_field().set_gravity_vector([0.0, 0.0, -case.gravity])
        plant.Finalize()
        context = plant.CreateDefaultContext()
        attitude = maths.RotationMatrix(case.motion.attitude.as_matrix())
        if case.arm:
            point.set_angles(context, maths.RollPitchYaw(attitude).vector())
            point.set_angular_velocity(context, _in_space(case))
        else:
            place = maths.RigidTransform(attitude, np.zeros(3))
            velocity = importlib.import_module("pydrake.multibody.math").SpatialVelocity
            plant.SetFreeBodyPose(context, body, place)
            plant.SetFreeBodySpatialVelocity(context, body, velocity(_in_space(case), np.zeros(3)))
        simulator = analysis.Simulator(plant, context)
        analysis.ResetIntegratorFromFlags(simulator, integrator, step)
        simulator.get_mutable_integrator().set_fixed_step_mode(True)
        found = []
        for t in case.times:
            simulator.AdvanceTo(t)
            seen = plant.EvalBodyPoseInWorld(context, body).rotation()
            found.append(seen.ToQuaternion().wxyz())
        return np.stack(found)

    return run


def _in_space(case: Case) -> Floats:
    """ω at the start in the space frame (rad/s)."""
    return np.asarray(case.motion.attitude.apply(case.motion.omega))


def _exudyn(case: Case, step: float) -> Floats:
    exudyn = importlib.import_module("exudyn")
    items = importlib.import_module("exudyn.itemInterface")
    utilities = importlib.import_module("exudyn.utilities")
    system = exudyn.SystemContainer().AddSystem()
    inertia = utilities.RigidBodyInertia(
        mass=case.mass,
        inertiaTensor=np.diag(case.motion.body.moments),  # about the origin of the body
        com=np.array([0.0, 0.0, case.arm]),
    )
    body = system.CreateRigidBody(
        inertia=inertia,
        referencePosition=[0.0, 0.0, 0.0],
        referenceRotationMatrix=case.motion.attitude.as_matrix(),
        initialAngularVelocity=_in_space(case).tolist(),
        gravity=[0.0, 0.0, -case.gravity],
    )
    if case.arm:
        ground = system.AddObject(items.ObjectGround())
        system.CreateSphericalJoint(itemNumbers=[ground, body], position=[0, 0, 0], show=False)
    seen = items.SensorBody(
        bodyNumber=body,
        outputVariableType=exudyn.OutputVariableType.RotationMatrix,
        storeInternal=True,
    )
    sensor = system.AddSensor(seen)
    system.Assemble()
    chosen = exudyn.SimulationSettings()
    chosen.timeIntegration.numberOfSteps = SAMPLES * _every(case, step)
    chosen.timeIntegration.endTime = case.end
    chosen.timeIntegration.verboseMode = 0
    chosen.solution.file.write = False
    chosen.solution.sensors.writePeriod = case.end / SAMPLES
    system.SolveDynamic(chosen)
    rows = system.GetSensorStoredData(sensor)[:, 1:]
    return Rotation.from_matrix(rows.reshape(-1, 3, 3)).as_quat()[:, [3, 0, 1, 2]]


def _pybullet(case: Case, step: float) -> Floats:
    bullet = importlib.import_module("pybullet")
    world = {"physicsClientId": bullet.connect(bullet.DIRECT)}
    start, none = case.quaternion[[1, 2, 3, 0]].tolist(), [0.0, 0.0, 0.0]
    try:
        bullet.setTimeStep(step, **world)
        bullet.setGravity(0.0, 0.0, -case.gravity, **world)
        bodies = {
            "linkMasses": [case.mass],
            "linkCollisionShapeIndices": [-1],
            "linkVisualShapeIndices": [-1],
            "linkPositions": [none],
            "linkOrientations": [[0.0, 0.0, 0.0, 1.0]],
            "linkInertialFramePositions": [[0.0, 0.0, case.arm]],
            "linkInertialFrameOrientations": [[0.0, 0.0, 0.0, 1.0]],
            "linkParentIndices": [0],
            "linkJointTypes": [bullet.JOINT_SPHERICAL],
            "linkJointAxis": [[0.0, 0.0, 1.0]],
        }
        held = bodies if case.arm else {"baseMass": case.mass}
        body, link = bullet.createMultiBody(**held, **world), 0 if case.arm else -1
        # Its own damping would be no motion of a free body; nor is the motor that holds its joints.
        bullet.changeDynamics(
            body,
            link,
            localInertiaDiagonal=case.central,
            linearDamping=0,
            angularDamping=0,
            jointDamping=0,
            **world,
        )
        if case.arm:
            bullet.setJointMotorControlMultiDof(
                body, 0, bullet.POSITION_CONTROL, [0.0, 0.0, 0.0, 1.0], force=none, **world
            )
            bullet.resetJointStateMultiDof(body, 0, start, list(case.motion.omega), **world)
        else:
            bullet.resetBasePositionAndOrientation(body, none, start, **world)
            bullet.resetBaseVelocity(body, none, _in_space(case).tolist(), **world)

        def attitude() -> Floats:
            if case.arm:
                return np.array(bullet.getJointStateMultiDof(body, 0, **world)[0])
            return np.array(bullet.getBasePositionAndOrientation(body, **world)[1])

        found = [attitude()]
        for _ in range(SAMPLES):
            for _ in range(_every(case, step)):
                bullet.stepSimulation(**world)
            found.append(attitude())
    finally:
        bullet.disconnect(**world)
    return np.stack(found)[:, [3, 0, 1, 2]]


def reference(case: Case) -> dict[str, object]:
    """A motion as data that a writer of simulators can test against, floats with all digits."""
    run = case.motion.exact(case.times)
    x, y, z, w = run.rotation.as_quat(canonical=True).T
    rows = np.column_stack([run.t, w, x, y, z, run.omega])
    return {
        "about": "exact motion; quaternion scalar first, body to space; omega in the body, rad/s",
        "name": case.name,
        "mass": case.mass,
        "joint_to_centre_of_mass_along_e3": case.arm,
        "moments_about_centre_of_mass": list(case.central),
        "moments_about_joint": list(case.motion.body.moments),
        "gravity_along_minus_z": case.gravity,
        "columns": ["t", "q0", "q1", "q2", "q3", "omega1", "omega2", "omega3"],
        "rows": rows.tolist(),
    }


def written(case: Case) -> str:
    """The same as JSON."""
    return json.dumps(reference(case), indent=1) + "\n"


def table(scores: Sequence[Score]) -> str:
    """Each case with its engines: errors at the steps, and the order."""
    blocks = []
    for name in dict.fromkeys(score.case for score in scores):
        lines = [name]
        for score in (each for each in scores if each.case == name):
            who = f"  {score.engine} {score.integrator}"
            if score.note:
                lines.append(f"{who:37}{score.note}")
                continue
            errors = "".join(f"{error:>9.1e}" for error in score.errors)
            step = f"{1000 * score.step:g} ms"
            lines.append(f"{who:37}{step:>6}:{errors}  order {score.order:.1f}")
        blocks.append("\n".join(lines))
    said = "Largest angle to the exact attitude (rad), at 4, 2, 1 and ½ of the engine's own step."
    return "\n\n".join([*blocks, said])


def main() -> None:
    parser = argparse.ArgumentParser(description="Hold simulators against the exact motions.")
    parser.add_argument("-o", "--output", metavar="FOLDER", help="write the exact motions as JSON")
    folder = parser.parse_args().output
    if folder is None:
        print(table(judge(progress=bar("judging"))))
        return
    files = {f"{case.name.replace(' ', '_')}.json": written(case).encode() for case in cases()}
    print(*write_all(Path(folder), files), sep="\n")


if __name__ == "__main__":
    main()
