"""The page of a system: what it computes, and how it looks in a browser."""

from __future__ import annotations

import json
from base64 import b64decode

import numpy as np
import pytest
import sympy
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt
from rigidtop.errors import RigidtopError
from rigidtop.theory import rotation
from rigidtop.theory import symbols as s
from rigidtop.web import table
from rigidtop.web.notebook import page_for
from rigidtop.web.page import FOLDER
from rigidtop.web.system import Scene, data

from .conftest import Engine

m, l, g, k, c, F, w = symbols("m l g k c F w", positive=True)  # noqa: E741
q, x, y, alpha = dynamicsymbols("q x y alpha")
theta, phi, psi = dynamicsymbols("theta phi psi")


def double_pendulum():
    upper = sympy.Matrix([l * sin(theta), -l * cos(theta)])
    lower = upper + sympy.Matrix([l * sin(phi), -l * cos(phi)])
    parts = [rt.Mass(m, upper), rt.Mass(2 * m, lower)]
    system = rt.System.of_parts(parts, [theta, phi], gravity=[0, -g])
    return system.motion({m: 1, l: 1, g: 9.81}, [2, 1])


def gyrostat():
    """A body with a rotor whose axis is e₃, both about a fixed point."""
    attitude = rotation.euler_matrix().xreplace({s.phi: phi, s.theta: theta, s.psi: psi})
    turn = sympy.Matrix([[cos(alpha), -sin(alpha), 0], [sin(alpha), cos(alpha), 0], [0, 0, 1]])
    carrier = rt.Body(0, [2, 2, 1], [0, 0, 0], attitude)
    rotor = rt.Body(0, [m, m, m], [0, 0, 0], attitude * turn)
    system = rt.System.of_parts([carrier, rotor], [phi, theta, psi, alpha])
    return system.motion({m: 0.3}, [0, 1, 0, 0], [1, 0, 2, 10])


def spring(**more):
    return rt.System(m * q.diff() ** 2 / 2 - k * q**2 / 2, [q], **more)


def driven():
    return spring(forces=[F * cos(w * dynamicsymbols._t)], rayleigh=c * q.diff() ** 2 / 2).motion(
        {m: 1, k: 4, F: 1, w: 2.1, c: 0.1}, [0]
    )


def atom():
    """As far and as fast as in a molecule."""
    return spring().motion({m: 1.6e-27, k: 500}, [1e-11])


def bead():
    falls = rt.System(
        m * (x.diff() ** 2 + y.diff() ** 2) / 2 - m * g * y,
        [x, y],
        constraints=[x**2 + y**2 - l**2],
    )
    return falls.motion({m: 1, l: 1, g: 9.81}, [0.6, 0.8])


MOTIONS = {
    "double": (double_pendulum, (), 3.0),
    "gyrostat": (gyrostat, (), 5.0),
    "driven": (driven, [[q, 0]], 20.0),
    "atom": (atom, [[q, 0]], 1e-12),
    "bead": (bead, [[x, y]], 3.0),
}


def engine_of(motion, points=()):
    scene = Scene(motion.system, points)
    made = data(motion, scene, "")
    engine = Engine("dop853", "moving")
    for text in (scene.module(), (FOLDER / "flow.js").read_text("utf-8")):
        engine.load(text)
    engine.run(
        "globalThis.flow = createFlow(data, data.start, data.given); 0",
        data=json.loads(json.dumps(made)),
    )
    return engine


@pytest.mark.parametrize("name", MOTIONS)
def test_the_page_computes_what_python_computes(name):
    make, points, until = MOTIONS[name]
    motion = make()
    engine = engine_of(motion, points)
    found = engine.run(
        f"flow.go({until}); ({{ t: flow.now.t, state: Array.from(flow.now.state),"
        " energy: flow.now.energy, points: Array.from(flow.now.points), drift: flow.drift() })"
    )
    run = motion.integrate([until], rtol=1e-12, atol=1e-14)
    expected = np.concatenate([run.q[0], run.qdot[0]])
    n = len(run.q[0])
    sizes = np.repeat([np.abs(run.q).max(), np.abs(run.qdot).max()], n)
    assert found["t"] == until
    assert np.all(np.abs(np.array(found["state"][: 2 * n]) - expected) < 1e-7 * sizes)
    assert found["energy"] == pytest.approx(float(run.energy[0]), rel=1e-8)
    assert all(each["most"] < 1e-11 for each in found["drift"])
    assert [each["name"] for each in found["drift"]] == list(Scene(motion.system, points).kept)
    if not points:
        places = run.places()[:, 0].ravel()
        assert found["points"][: len(places)] == pytest.approx(places, abs=1e-6)


def test_back_is_where_it_was():
    engine = engine_of(driven(), [[q, 0]])
    there = "(flow.go({}), Array.from(flow.now.state))"
    once = engine.run(there.format(1.3))
    engine.run(there.format(8))
    assert engine.run(there.format(1.3)) == pytest.approx(once, rel=1e-11)
    assert engine.run("(flow.reset(), flow.now.t)") == 0
    times = engine.run("(flow.go(5), flow.trail.map(({ t }) => t))")
    assert np.ptp(np.diff(times)) < 1e-12
    assert times[-1] <= 5 < times[-1] + 2 * (times[1] - times[0])


def test_a_motion_that_ends_says_so():
    r = symbols("r", positive=True)
    v = symbols("v", real=True)
    falls = rt.System(m * v**2 / 2 + k / r, [r], [v]).motion({m: 1, k: 1}, [1.0])
    said = engine_of(falls).run(
        "(() => { try { flow.go(10); return ''; } catch (e) { return e.message; } })()"
    )
    assert "stuck" in said or "leaves that side" in said


def test_what_cannot_be_shown_is_said_in_one_line():
    motion = spring().motion({m: 1, k: 4}, [1])
    odd = spring(forces=[sympy.erf(q)]).motion({m: 1, k: 4}, [1])
    wrong = (
        (motion, {"points": [[symbols("b"), 0]]}, "no number for b"),
        (motion, {"points": [3]}, "places"),
        (motion, {"points": [[1, 2, 3, 4]]}, "two or three components"),
        (odd, {}, "there is no erf in JavaScript"),
        (3, {}, "not a int"),
        (rt.FreeBody(1, 2, 2.5).motion(omega=(1, 0, 0)), {"points": [[q, 0]]}, "own picture"),
    )
    for given, more, said in wrong:
        with pytest.raises(RigidtopError, match=said) as error:
            page_for(given, **more)
        assert "\n" not in str(error.value)


def test_sliders_keep_signs_and_constraints():
    free = data(double_pendulum(), Scene(double_pendulum().system), "")
    names = ["p0", "p1", "p2", "s0", "s1", "s2", "s3"]
    assert [each["name"] for each in free["parameters"]] == names
    assert list(free["first"]["setup"]["values"]) == names
    assert [each["letter"] for each in free["parameters"][:3]] == ["g", "l", "m"]
    assert all(each["logarithmic"] and each["least"] > 0 for each in free["parameters"][:3])
    assert [each["angle"] for each in free["state"]] == [True, True, False, False]
    held = data(bead(), Scene(bead().system, [[x, y]]), "")
    assert [each["letter"] for each in held["parameters"]] == ["g", "m"]
    assert not data(driven(), Scene(driven().system), "")["state"][0]["angle"]


def test_a_name_is_never_markup():
    evil = symbols("</script><img/src=x>", positive=True)
    motion = rt.System(evil * q.diff() ** 2 / 2 - q**2 / 2, [q]).motion({evil: 1}, [1])
    html = page_for(motion).html
    assert "<img" not in html
    assert html.count("</script>") == page_for(spring().motion({m: 1, k: 1}, [1])).html.count(
        "</script>"
    )


def test_in_a_browser(live):
    live.write("double", page_for(double_pendulum()).html)
    live.write("spring", page_for(driven()).html)
    live.open("double", ready="window.rigidtop && rigidtop.frames > 3")
    live.wait("rigidtop.motion.now.t > 0.1")
    assert live.find("h1").text == "Motion in θ, φ"
    assert live.js("document.querySelectorAll('#start input[type=range]').length") == 7
    live.find("#scene").send_keys(" ")
    live.wait("document.querySelector('button[aria-label=Play]')")
    # A slider begins another motion, with another end.
    live.js(
        "(document.querySelector('#number-s0').value = '30',"
        " document.querySelector('#number-s0').dispatchEvent(new Event('change')))"
    )
    live.wait("rigidtop.motion.now.t === 0")
    assert live.js("rigidtop.motion.start.state[0]") == pytest.approx(np.radians(30), rel=1e-12)
    colours = live.js(
        "(() => { const c = document.querySelector('#scene canvas');"
        " const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
        " return new Set(new Uint32Array(d.buffer)).size; })()"
    )
    assert colours > 20
    live.wait("document.querySelector('#scene').ariaLabel?.includes('θ = 0.52')")
    live.js("document.querySelector('button[aria-label=\"One step on\"]').click()")
    live.wait("rigidtop.motion.now.t > 0")
    for name in ("v", "E", "phase", "path"):
        live.js(
            "(document.querySelector('.pick select').value = arguments[0],"
            " document.querySelector('.pick select').dispatchEvent(new Event('change')))",
            name,
        )
        live.drawn()
    assert "θ" in live.js("document.querySelector('#equations').textContent")
    # The address holds what is set, and a ghost that differs a little in one thing.
    hash = live.wait("location.hash.includes('plot=path') && location.hash")
    assert "s0=30deg" in hash
    live.open("double", f"{hash.replace('plot=path', 'plot=v')}&ghost=s0")
    assert live.js("rigidtop.motion.start.state[0]") == pytest.approx(np.radians(30), rel=1e-12)
    picks = "[...document.querySelectorAll('.pick select')].map((x) => x.value)"
    assert live.js(picks) == ["v", "s0"]
    assert not live.find("#notice").is_displayed()
    live.open("double", "#s0=400deg&view=body&p9=1")
    assert "out of range; 115° is used (and 2 more)" in live.find("#notice").text
    live.open("spring", ready="window.rigidtop && rigidtop.frames > 3")
    assert live.js("document.querySelectorAll('#scene canvas').length") == 1
    live.js("(document.querySelector('#more details:last-child').open = true)")
    assert "m" in live.js("document.querySelector('#start').textContent")


def sliding():
    top = rt.SlidingTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5, tip=0.1, mu=0.3)
    return top.motion(theta=0.3, omega3=60.0)


def test_a_top_on_a_table_is_played_as_it_was_computed():
    run = sliding().integrate(np.arange(0, 1, 1 / table.ROWS))
    made = table.data({"As given": run}, "")
    (preset,) = made["presets"]
    engine = Engine()
    for text in (table.module(run.motion.body), (FOLDER / "recording.js").read_text("utf-8")):
        engine.load(text)
    recording = made["recordings"][preset["name"]]
    bytes_ = b64decode(recording["rows"]).decode("latin-1")
    engine.run("globalThis.atob = () => bytes; 0", bytes=bytes_)
    engine.run("globalThis.flow = createRecording(data, recording); 0", data=made,
               recording=recording)  # fmt: skip
    k = 70
    found = engine.run(
        f"(flow.go({run.t[k]}), {{ points: Array.from(flow.now.points), E: flow.now.energy }})"
    )
    contact, _, centre, top = np.reshape(found["points"][:12], (4, 3))
    assert contact == pytest.approx(run.contact[k], abs=1e-6)
    assert centre == pytest.approx(run.position[k], abs=1e-6)
    assert top == pytest.approx(run.position[k] + 0.5 * run.e3[k], abs=1e-6)
    assert found["points"][12:] == pytest.approx(run.rotation.as_matrix()[k].ravel(), abs=1e-5)
    assert found["E"] == pytest.approx(run.energy[k], rel=1e-7)
    # Between two rows it is between them, and at the end it says why it ends.
    between = engine.run(f"(flow.go({run.t[k : k + 2].mean()}), flow.now.energy)")
    assert between == pytest.approx(run.energy[k : k + 2].mean(), rel=1e-7)
    said = "(() => { try { flow.go(2); return ''; } catch (e) { return e.message; } })()"
    assert engine.run(said) == "it was computed for 10 s"
    assert engine.run("flow.now.t") == pytest.approx(run.t[-1])
    about = preset["about"]
    assert about.startswith("λ₁ = 1 kg m², λ₃ = 0.5 kg m², M = 1 kg, R = 0.5 m, r = 0.1 m")
    assert "At t = 0.5438 s its contact stops slipping" in about


def test_other_friction_and_other_spin_stand_beside_it(live):
    changed = table.variants(sliding())
    assert [(m.body.mu, m.omega[2]) for m in changed.values()] == [(0.15, 60), (0.6, 60), (0.3, 30)]
    smooth = rt.SlidingTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5).motion(theta=0.3, omega3=60.0)
    assert list(table.variants(smooth)) == ["Half the spin"]
    html = page_for(sliding()).html
    assert len(html) < 700_000
    live.write("table", html)
    live.open("table", "#preset=twice-the-friction&t=0.3&play=0&ghost=as-given")
    live.wait("rigidtop.motion.now.t === 0.3")
    run = changed["Twice the friction"].integrate([0.3])
    assert live.js("rigidtop.motion.now.state[0]") == pytest.approx(run.theta[0], rel=1e-6)
    assert "μ = 0.6" in live.find(".about").text
    assert not live.find("#corner, #equations, #verdict").is_displayed()
    assert not live.find("#notice").is_displayed()


def test_a_top_that_falls_says_so():
    top = rt.SlidingTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5, mu=0.3)
    run = top.motion(theta=1.0, omega3=1.0).integrate(np.arange(0, 3, 0.1))
    made = table.recording(run)
    assert made["ended"] == "the top lies on the table"
    assert len(b64decode(made["rows"])) == 4 * made["width"] * len(run.t) < 30 * 40
