"""`rigidtop sweep` as a user meets it: a file, a summary, one line for bad input, and no loss."""

import json
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import rigidtop as rt
from rigidtop.cli import main
from rigidtop.commands.sweep import EXAMPLE, noted_interrupts
from rigidtop.motion import store
from rigidtop.motion.sweep import REGIMES, Span, Sweep, load

SMALL = ("--axis", "omega3=0:60:20", "--axis", "phi-dot=-5:5:11")
"""Of the example top."""


def direct():
    return rt.top_motions(
        lambda1=1.0,
        lambda3=0.5,
        M=1.0,
        R=0.5,
        theta=0.5,
        omega3=np.linspace(0, 60, 20)[:, None],
        phi_dot=np.linspace(-5, 5, 11),
    )


def sweep(path, *arguments):
    return main(["sweep", "-o", str(path), *arguments])


@pytest.mark.parametrize("where", [(), ("--workers", "1")])
def test_a_map_of_regimes(tmp_path, capsys, where):
    assert sweep(tmp_path / "map.npy", *SMALL, *where) == 0
    assert np.array_equal(np.array(REGIMES)[np.load(tmp_path / "map.npy")], direct().regime)
    first, second, third = capsys.readouterr().out.splitlines()
    assert first == f"{tmp_path}/map.npy: regime, 20 omega3 × 11 phi_dot"
    assert second.startswith("loops ")
    assert third.startswith("220 points computed in ")


def test_json_is_the_contract(tmp_path, capsys):
    path = tmp_path / "map.npy"
    for computed in (220, 0):
        assert sweep(path, *SMALL, "--json") == 0
        record = json.loads(capsys.readouterr().out)
        assert record.pop("seconds") >= 0
        names, counts = np.unique(direct().regime, return_counts=True)
        assert record == {
            "file": str(path),
            "quantity": "regime",
            "axes": ["omega3", "phi_dot"],
            "shape": [20, 11],
            "points": 220,
            "regimes": dict(zip(names.tolist(), counts.tolist(), strict=True)),
            "computed": computed,
        }


def test_damage_is_said(tmp_path, capsys):
    """A partial file whose only block is no longer what was written."""
    path = tmp_path / "map.npy"
    half = Sweep("regime", {"omega3": Span(0, 60, 20), "phi_dot": Span(-5, 5, 11)}, EXAMPLE)
    with store.open_store(path, half.about, half.dtype, half.shape) as file:
        file.write(0, np.zeros(110, np.uint8))
    with path.open("r+b") as data:
        data.seek(140)
        data.write(b"\x01")
    assert sweep(path, *SMALL) == 0
    assert np.array_equal(np.array(REGIMES)[np.load(path)], direct().regime)
    again = "110 of them again: on the disk they were no longer what was written"
    assert capsys.readouterr().out.splitlines()[-1] == again


def test_numbers_and_degrees(tmp_path, capsys):
    path = tmp_path / "map.npy"
    asked = ("--quantity", "theta", "--axis", "t=0:1:3", "--axis", "psi-dot=10,20", "--json")
    assert sweep(path, *asked, "--set", "theta=90deg", "mass=2", "--set", "arm=0.1") == 0
    found = load(path)
    assert found.sweep.fixed["theta"] == pytest.approx(np.pi / 2)
    assert (found.sweep.fixed["M"], found.sweep.fixed["R"]) == (2.0, 0.1)
    assert "omega3" not in found.sweep.fixed
    record = json.loads(capsys.readouterr().out)
    assert record["least"] == found.values.min()
    assert record["largest"] == found.values.max()


def test_infinite_periods_are_left_out_of_the_summary(tmp_path, capsys):
    asked = ("--quantity", "nutation_period", "--axis", "omega3=0,1", "--set", "theta=0", "--json")
    assert sweep(tmp_path / "map.npy", *asked) == 0
    record = json.loads(capsys.readouterr().out)
    assert np.isinf(load(tmp_path / "map.npy").values).all()
    assert (record["least"], record["largest"]) == (None, None)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "a sweep wants an axis at least"),
        (("--axis", "omega3=0:1:x"), "--axis omega3=0:1:x is not omega3=START:STOP:COUNT or "),
        (("--axis", "omega3=0:1"), "is not omega3=START:STOP:COUNT or omega3=A,B,…"),
        (("--axis", "omega3=0:a:3"), "omega3 must be a number in rad/s, such as"),
        (("--axis", "M=1deg,2"), "M must be a number, such as 0.5, not '1deg'"),
        (("--axis", "omega3=1", "--axis", "omega3=2"), "--axis omega3 is given twice"),
        (("--axis", "mass=0:1:3"), "M must be more than 0, not 0"),
        (("--axis", "theta=0:181deg:3"), "at most 3.14159 rad (180°), not 3.15905 rad (181°)"),
        (("--axis", "omega3=1", "--scheduler", "host"), "wants an address like tcp://host:8786"),
        (("-o", "map"), "--output wants a name that ends in .npy, not 'map'"),
        (("-o", ""), "--output wants a name that ends in .npy, not ''"),
        (("--axis", "omega3"), "argument --axis: 'omega3' is not NAME=VALUE"),
        (("--axis", "omega3=1", "--workers", "0"), "'0' is not a whole number from 1"),
        (("--axis", "omega3=1", "--workers", "2", "--scheduler", "a:1"), "not allowed with"),
    ],
)
def test_bad_input_is_one_line(tmp_path, capsys, arguments, message):
    try:
        code = sweep(tmp_path / "map.npy", *arguments)
    except SystemExit as left:
        code = left.code
    assert code == 2
    [line] = capsys.readouterr().err.splitlines()
    assert line.startswith("rigidtop sweep: ")
    assert message in line
    assert list(tmp_path.iterdir()) == []


def test_without_dask_its_extra_is_named(tmp_path, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert sweep(tmp_path / "map.npy", *SMALL, "--scheduler", "tcp://127.0.0.1:1") == 2
    assert capsys.readouterr().err.endswith("wants Dask: pip install 'rigidtop[cluster]'\n")


# Dask's own: its clean-up warns of sockets and event loops.
@pytest.mark.filterwarnings("ignore")
def test_a_cluster_by_its_address(tmp_path):
    distributed = pytest.importorskip("distributed", reason="distributed is not installed")
    with distributed.LocalCluster(
        n_workers=1,
        threads_per_worker=1,
        processes=False,
        protocol="tcp",
        dashboard_address=None,
    ) as cluster:
        address = cluster.scheduler_address
        assert sweep(tmp_path / "map.npy", *SMALL, "--scheduler", address) == 0
    assert np.array_equal(np.array(REGIMES)[np.load(tmp_path / "map.npy")], direct().regime)


@pytest.mark.skipif(sys.platform == "win32", reason="no such signals there")
@pytest.mark.parametrize("where", [(), ("--workers", "1")])
def test_an_interrupt_is_answered_and_the_same_command_goes_on(tmp_path, capsys, where):
    path = tmp_path / "map.npy"
    asked = ("--quantity", "phi", "--set", "t=2", "--axis", "omega3=1:60:1000",
             "--axis", "phi_dot=-5:5:100", "--json")  # fmt: skip
    # In blocks of ten it would take seconds, and is interrupted after the first.
    slow = (*asked, "--block", "10")
    command = [sys.executable, "-m", "rigidtop", "sweep", "-o", str(path), *slow, *where]
    with subprocess.Popen(
        command, stderr=subprocess.PIPE, text=True, start_new_session=True
    ) as process:
        journal = store.journal_path(path)
        while process.poll() is None and not (journal.exists() and journal.stat().st_size):
            time.sleep(0.005)
        os.killpg(process.pid, signal.SIGINT)  # Ctrl-C reaches the worker processes too
        _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    where_it_is, said = errors.splitlines()[-2:]
    assert where_it_is.endswith(
        f"of 100000 points are in {path}; the same command goes on from there"
    )
    assert said == "rigidtop sweep: interrupted"
    assert "Traceback" not in errors
    assert sweep(path, *asked, "--quantity", "phi") == 0
    record = json.loads(capsys.readouterr().out)
    # The interrupt may fall between the writing of a block and its counting.
    there = int(where_it_is.split()[0])
    assert there > 0
    assert 100000 - there - 1000 <= record["computed"] <= 100000 - there


@pytest.mark.skipif(sys.platform == "win32", reason="no such signals there")
def test_processes_end_with_the_one_that_was_killed(tmp_path):
    script = (
        "import multiprocessing, time\n"
        "from concurrent.futures import ProcessPoolExecutor\n"
        "from rigidtop.commands.sweep import follow\n"
        "import os\n"
        "pool = ProcessPoolExecutor(1, multiprocessing.get_context('spawn'), follow)\n"
        "pool.submit(os.getpid).result()\n"
        "os.kill(os.getpid(), 9)\n"
    )
    # The worker holds the other end of the pipe: it closes when both have gone.
    done = subprocess.run(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, timeout=30, check=False
    )
    assert done.returncode == -signal.SIGKILL


@pytest.mark.skipif(sys.platform == "win32", reason="no such signals there")
def test_an_interrupt_is_noted_and_a_second_one_raises_at_once():
    before = signal.getsignal(signal.SIGINT)
    with noted_interrupts() as interrupted:
        assert not interrupted()
        signal.raise_signal(signal.SIGINT)
        assert interrupted()
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert signal.getsignal(signal.SIGINT) is before
