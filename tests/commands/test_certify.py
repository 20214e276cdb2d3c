"""`rigidtop certify` on parsed options."""

import argparse
import json

import pytest

from rigidtop.commands import certify
from rigidtop.errors import RigidtopError
from rigidtop.motion import equations

EXAMPLE = ["top", "--theta-dot", "0.1", "--phi-dot", "1", "--psi-dot", "40", "--time", "1"]
FREE = ["free", "--moments", "1", "2", "3", "--omega", "0.01", "2", "0.01", "--time", "1"]


def run(*arguments):
    parser = argparse.ArgumentParser(exit_on_error=False)
    parser.add_argument("--json", action="store_true")
    certify.add_options(parser)
    return certify.run(parser.parse_args(arguments))


def test_json(capsys):
    assert run("--json", *FREE) == 0
    certificate = json.loads(capsys.readouterr().out)
    assert certificate["passed"] is True
    assert list(certificate["differences"]) == ["exact", "Lagrange", "Hamilton"]
    assert list(certificate["bounds"]) == list(certificate["differences"])
    assert set(certificate["drifts"]["exact"]) == {"energy", "p_phi", "L"}
    assert list(certificate["left_out"]) == ["Routh"]


def test_exit_code_of_a_disagreement(capsys, monkeypatch):
    right = equations.top_by_routh
    monkeypatch.setattr(
        equations, "top_by_routh", lambda first, *rest, **f: right(first * 1.01, *rest, **f)
    )
    assert run(*EXAMPLE) == 1
    assert capsys.readouterr().out.endswith("THE WAYS DISAGREE: Routh\n")


def test_ways_that_do_not_exist_are_named(capsys):
    assert run("top", "--theta", "0", "--time", "1") == 0
    assert "Hamilton  sin θ stays below 0.001: Euler angles" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["top", "--moments", "1", "2", "3"], "--moments does not go with `certify top`"),
        (["free", "--theta", "0.5"], "--theta does not go with `certify free`"),
        (["free"], "a free body needs --moments"),
        (["top", "--time", "0"], "--time 0 leaves nothing to compute"),
        (["top", "--rtol", "1e-20"], "rtol must be at least"),
    ],
)
def test_bad_input(arguments, message):
    with pytest.raises(RigidtopError, match=f"^{message}"):
        run(*arguments)
