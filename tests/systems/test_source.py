"""Source of a system evaluates to what its own functions evaluate to."""

import json
import re
import shutil
import subprocess
from itertools import pairwise

import numpy as np
import pytest
from sympy import Add, Heaviside, Max, Piecewise, besselj, cos, sin, symbols

import rigidtop as rt
from rigidtop.codegen.lines import StraightLine

m, length, g, k = symbols("m length g k", positive=True)
x, y, r, u, v, w = symbols("x y r u v w", real=True)
BOB = rt.System(
    m * (u**2 + v**2 + u * v * cos(r) + w**2) / 2 - m * g * y * sin(r) - k * x**2,
    [x, y, r],
    [u, v, w],
    constraints=x**2 + y**2 - length**2,
)
STATE = {"x": 0.4, "y": 0.9, "r": 0.2, "u": 0.7, "v": -0.3, "w": 1.1}
NUMBERS = {"g": 9.81, "k": 2.0, "length": 0.98, "m": 1.5}
INSIDE = {"g", "k", "m"}  # the constraint, derived twice, has no length
ROW = [*STATE.values(), *(value for name, value in NUMBERS.items() if name in INSIDE)]


def expected():
    *motion, minus = BOB.numeric.solved(0.0, *STATE.values(), *NUMBERS.values())
    return [*motion, -minus]


def test_python():
    names = {}
    exec(BOB.source("python", "bob"), names)
    assert list(names["bob"](*ROW)) == pytest.approx(expected(), rel=1e-13)


def test_c(tmp_path):
    if shutil.which("gcc") is None:
        pytest.skip("no gcc")
    call = ", ".join(map(repr, ROW))
    main = f"""
    #include <stdio.h>
    int main(void) {{
        double out[4];
        bob({call}, out);
        for (int i = 0; i < 4; i++) printf("%.17g\\n", out[i]);
    }}"""
    (tmp_path / "bob.c").write_text(BOB.source("c", "bob") + main, "utf-8")
    strict = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-Wno-unused-parameter")
    subprocess.run(
        ["gcc", *strict, "bob.c", "-o", "bob", "-lm"], cwd=tmp_path, check=True, timeout=120
    )
    said = subprocess.run(
        [tmp_path / "bob"], capture_output=True, text=True, check=True, timeout=120
    ).stdout
    assert [float(line) for line in said.split()] == pytest.approx(expected(), rel=1e-12)


def test_javascript():
    quickjs = pytest.importorskip("quickjs")
    context = quickjs.Context()
    context.eval(BOB.source("javascript", "bob"))
    found = context.eval(f"JSON.stringify(bob({', '.join(map(repr, ROW))}))")
    assert np.array(json.loads(found)) == pytest.approx(expected(), rel=1e-12)


@pytest.mark.parametrize("language", ["fortran", "julia", "octave"])
def test_the_others_name_all_that_goes_in(language):
    made = BOB.source(language)
    assert all(name in made for name in (*STATE, *INSIDE, "multiplier1", "accelerations"))


def test_a_system_of_many_terms_has_its_energy_and_its_source():
    """As ten pendulums with masses and lengths of their own have them."""
    springs = symbols("s:250", positive=True)
    tied = rt.System(m * u**2 / 2 - Add(*springs) * x**2 / 2, x, u)
    run = tied.motion({m: 2, **dict.fromkeys(springs, 1)}, 0.1).integrate([0.1])
    assert run.drift()["energy"] < 1e-9
    assert run.energy[0] == pytest.approx(250 * 0.1**2 / 2)
    names = {}
    exec(tied.source("python"), names)
    assert names["accelerations"](0.1, 0.0, 2.0, *[1.0] * 250) == pytest.approx([-12.5])


def test_a_program_in_python_keeps_its_lines():
    """Put into one another they would double from line to line."""
    ladder = rt.System(m * u**2 / 2 - k * x**2 / 2, x, u)
    names = symbols("a0:40")
    rungs = [(names[0], x + k), *((b, a * (a + k)) for a, b in pairwise(names))]
    ladder.__dict__["program"] = StraightLine(tuple(rungs), (names[-1],))
    assert ladder.source("python").count(" = ") == 40


def test_fortran_takes_reals_and_letters_of_one_case(tmp_path):
    """max(0, x) and merge(0, …) are no Fortran beside reals, and M is m."""
    if shutil.which("gfortran") is None:
        pytest.skip("no gfortran")
    big, odd = symbols("M _p", positive=True)
    stop = rt.System(
        (m * u**2 + big * v**2) / 2
        - odd * Max(x, 0) ** 3
        - Piecewise((y**2, y > 1), (0, True)) ** 3,
        [x, y],
        [u, v],
    )
    row = (0.7, 1.3, 0.1, 0.2, 2.0, 3.0, 5.0)
    lines = stop.source("fortran", "stop_at").splitlines()
    main = [
        "program main",
        "  use stop_at_module",
        "  real(8) :: out(2)",
        f"  call stop_at({', '.join(f'{value}d0' for value in row)}, out)",
        "  print '(2es26.17)', out",
        "end program",
    ]
    (tmp_path / "stop.f90").write_text("\n".join([*lines, *main, ""]), "utf-8")
    subprocess.run(["gfortran", "stop.f90", "-o", "stop"], cwd=tmp_path, check=True, timeout=120)
    said = subprocess.run(
        [tmp_path / "stop"], capture_output=True, text=True, check=True, timeout=120
    ).stdout
    assert [float(value) for value in said.split()] == pytest.approx(
        stop.numeric.solved.scalar(0.0, *row), rel=1e-14
    )


def test_bad_input_is_one_line():
    for force, said in ((Heaviside(x), "there is no DiracDelta in c"), (besselj(0, x), "besselj")):
        with pytest.raises(rt.RigidtopError, match=said):
            rt.System(u**2 / 2 - force, x, u).source("c")
    with pytest.raises(rt.RigidtopError, match="no language 'rust': there are "):
        BOB.source("rust")
    with pytest.raises(rt.RigidtopError, match="'my code' is no name for a function"):
        BOB.source("c", "my code")


def test_a_letter_of_ones_own_has_no_meaning_of_the_lectures():
    """There a is a distance and θ an Euler angle."""
    a, (theta, rate) = symbols("a", positive=True), symbols("theta thetadot", real=True)
    made = rt.System(m * rate**2 / 2 - a * theta**2 / 2, theta, rate).source("c")
    comment = made[: made.index("*/")]
    for meaning in ("distance", "angle", "(m)", "(rad"):
        assert meaning not in comment
    assert re.search(r"theta +θ\n", comment)
