"""``import rigidtop`` is cheap, and its names are where they should be."""

import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import rigidtop as rt


def test_import_loads_nothing_heavy():
    code = (
        "import sys, rigidtop; dir(rigidtop);"
        "heavy = {'numpy', 'scipy', 'sympy', 'matplotlib', 'importlib.metadata'};"
        "print(sorted(heavy & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=120
    )
    assert done.stdout.strip() == "[]"


def test_every_public_name_is_listed_and_found():
    for name in rt.__all__:
        assert name in dir(rt)
        if name != "__version__":
            assert getattr(rt, name).__name__ == name
            assert getattr(rt, name).__module__.startswith("rigidtop.")


def test_unknown_name():
    with pytest.raises(AttributeError, match="module 'rigidtop' has no attribute 'LightTop'"):
        _ = rt.LightTop


def test_errors_are_value_errors():
    assert issubclass(rt.NoSteadyPrecession, rt.RigidtopError)
    assert issubclass(rt.RigidtopError, ValueError)


def test_the_oldest_versions_are_those_that_are_tried():
    root = Path(rt.__file__).parents[1]
    asked = tomllib.loads((root / "pyproject.toml").read_text("utf-8"))["project"]["dependencies"]
    _, *tried = (root / "tests/lowest.txt").read_text("utf-8").splitlines()
    assert tried == [each.replace(">=", "==") for each in asked]
