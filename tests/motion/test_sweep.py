"""A grid's values are those of its tops, wherever they are computed and however often it stops."""

import contextlib
import importlib.util
import json
import math
import multiprocessing
import os
import re
import signal
import subprocess
import sys
import tracemalloc
from concurrent.futures import (
    BrokenExecutor,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
)
from concurrent.futures.process import BrokenProcessPool

import numpy as np
import pytest

import rigidtop as rt
from rigidtop.motion import store
from rigidtop.motion import sweep as sweeps
from rigidtop.motion.sweep import REGIMES, Listed, Span, Sweep, block, load, run

TOP = {"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "R": 0.5, "theta": 0.5}
AXES = {"omega3": Span(0, 60, 7), "phi_dot": Listed((-3.0, 0.0, 0.1, 5.0))}
SMALL = Sweep("theta_min", {"omega3": Span(0, 60, 40), "phi_dot": Span(-5, 5, 25)}, TOP)
"""1000 points."""


class Serial(Executor):
    """Computes at once; raises from the block after `limit` on."""

    def __init__(self, limit=math.inf, error=None):
        self.limit = limit
        self.error = error or BrokenExecutor("a worker has gone")
        self.blocks = []

    def submit(self, function, *arguments):
        future = Future()
        if len(self.blocks) < self.limit:
            self.blocks.append(arguments[1:])
            future.set_result(function(*arguments))
        else:
            future.set_exception(self.error)
        return future


class Closed(Serial):
    """Takes no more work after `limit` blocks."""

    def submit(self, function, *arguments):
        if len(self.blocks) >= self.limit:
            raise RuntimeError("cannot schedule new futures after shutdown")
        return super().submit(function, *arguments)


def in_blocks(sweep, size):
    """The same blocks here: in others φ(t) may differ in its last digit."""
    return np.concatenate([block(sweep, k, k + size) for k in range(0, sweep.size, size)])


def files(folder):
    return sorted(path.name for path in folder.iterdir())


def stop_after(folder, points, sweep=SMALL, block_size=100):
    """A sweep of 1000 points that an executor gave up on."""
    with pytest.raises(rt.RigidtopError, match=f"{points} of {sweep.size} points are in"):
        run(sweep, folder / "map.npy", Serial(points // block_size), block_size=block_size)
    return folder / "map.npy"


# --- Values --------------------------------------------------------------------------------------


def direct(quantity, **arguments):
    tops = rt.top_motions(**{n: v for n, v in arguments.items() if n != "t"})
    if quantity in ("theta_min", "theta_max"):
        return tops.turning_points[quantity == "theta_max"]
    if quantity in sweeps.OF_STATE:
        return getattr(tops.exact(arguments["t"]), quantity)
    return getattr(tops, quantity)


@pytest.mark.parametrize("quantity", sweeps.OF_MOTION + sweeps.OF_STATE)
def test_values_are_those_of_the_tops(tmp_path, quantity):
    time = {"t": 2.0} if quantity in sweeps.OF_STATE else {}
    sweep = Sweep(quantity, AXES, {**TOP, "theta_dot": 0.3, **time})
    found = run(sweep, tmp_path / "map.npy", block_size=5)
    omega3, phi_dot = np.linspace(0, 60, 7)[:, None], np.array([-3.0, 0.0, 0.1, 5.0])
    expected = direct(quantity, **TOP, theta_dot=0.3, omega3=omega3, phi_dot=phi_dot, **time)
    values = np.load(tmp_path / "map.npy")
    if quantity == "regime":
        values = np.array(REGIMES)[values]
    assert values.shape == (7, 4)
    assert np.array_equal(values, expected)
    assert np.array_equal(found.axes["omega3"], omega3[:, 0])
    assert files(tmp_path) == ["map.npy", "map.npy.json"]


def test_time_may_be_an_axis():
    sweep = Sweep("phi", {"t": Span(0, 3, 4), "psi_dot": Listed((30.0, 40.0))}, TOP)
    expected = direct("phi", **TOP, psi_dot=np.array([30.0, 40.0]), t=np.linspace(0, 3, 4)[:, None])
    assert np.array_equal(block(sweep, 0, 8).reshape(4, 2), expected)


@pytest.mark.parametrize(("start", "stop", "count"), [(-5, 5, 1001), (60, 0, 77), (0.1, 0.3, 7)])
def test_spans_are_linspace(start, stop, count):
    axis = Span(start, stop, count)
    assert np.array_equal(axis.at(np.arange(count)), np.linspace(start, stop, count))


def test_every_regime_has_a_code():
    fall = math.sqrt(2 * 4.905 * (1 - math.cos(0.5)))  # from the upright
    starts = {
        "free precession": {"R": 0.0, "omega3": 5.0},
        "sleeping": {"theta": 0.0, "omega3": 40.0},
        "hanging": {"theta": math.pi, "omega3": 40.0},
        "steady": {"omega3": 40.0, "phi_dot": rt.HeavyTop(
            lambda1=1.0, lambda3=0.5, M=1.0, R=0.5).steady_precession(0.5, 40.0)[0]},
        "asymptotic": {"theta_dot": fall, "omega3": 0.0},
        "plane": {"omega3": 0.0},
        "through the vertical": {"theta": 0.0, "theta_dot": 1.0, "omega3": 40.0},
        "cusps": {"omega3": 40.0},
        "loops": {"omega3": 40.0, "phi_dot": -1.0},
        "waves": {"omega3": 40.0, "phi_dot": 0.1},
    }  # fmt: skip
    found = {}
    for name, start in starts.items():
        arguments = {**TOP, **start}
        omega3 = arguments.pop("omega3")
        [code] = block(Sweep("regime", {"omega3": Listed((omega3,))}, arguments), 0, 1)
        assert rt.top_motions(**arguments, omega3=[omega3]).regime.tolist() == [REGIMES[code]]
        found[name] = REGIMES[code]
    assert found == {name: name for name in REGIMES if name != "not computed"}
    assert 0 not in block(SMALL, 0, 1000)


def test_blocks_join_where_chunks_do_not():
    sweep = Sweep("theta_max", {"omega3": Span(0, 60, 300), "phi_dot": Span(-5, 5, 100)}, TOP)
    whole = block(sweep, 0, 30000)
    assert np.array_equal(whole[8000:20001], block(sweep, 8000, 20001))
    assert np.array_equal(
        whole.reshape(300, 100),
        direct("theta_max", **TOP, omega3=np.linspace(0, 60, 300)[:, None],
               phi_dot=np.linspace(-5, 5, 100)),
    )  # fmt: skip


def test_a_map_can_be_read_in_pieces(tmp_path):
    found = run(SMALL, tmp_path / "map.npy")
    assert [len(piece) for piece in found.pieces(300)] == [300, 300, 300, 100]
    assert np.array_equal(np.concatenate(list(found.pieces(300))), found.values.ravel())


# --- Interrupted and resumed ---------------------------------------------------------------------


def test_only_what_is_missing_is_computed(tmp_path):
    path = stop_after(tmp_path, 300)
    assert files(tmp_path) == ["map.npy", "map.npy.journal", "map.npy.json"]
    again, seen = Serial(), []
    run(SMALL, path, again, block_size=100, progress=lambda *at: seen.append(at))
    assert again.blocks == [(k, k + 100) for k in range(300, 1000, 100)]
    assert seen == [(done, 1000) for done in range(300, 1001, 100)]
    assert np.array_equal(np.load(path).ravel(), block(SMALL, 0, 1000))
    assert files(tmp_path) == ["map.npy", "map.npy.json"]
    once_more = Serial()
    run(SMALL, path, once_more)
    assert once_more.blocks == []


def test_an_executor_that_takes_no_more_loses_nothing(tmp_path):
    path = tmp_path / "map.npy"
    with pytest.raises(rt.RigidtopError, match=r"RuntimeError: cannot schedule .* 400 of 1000"):
        run(SMALL, path, Closed(4), block_size=100)
    again = Serial()
    run(SMALL, path, again, block_size=100)
    assert len(again.blocks) == 6


def test_an_interrupt_loses_nothing(tmp_path):
    def interrupt(done, total):
        if done == 500:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(SMALL, tmp_path / "map.npy", Serial(), block_size=100, progress=interrupt)
    again = Serial()
    run(SMALL, tmp_path / "map.npy", again, block_size=100)
    assert len(again.blocks) == 5


@pytest.mark.parametrize("complaint", ["damaged", "moved", "kept"])
@pytest.mark.parametrize("quantity", ["theta_min", "regime"])
def test_a_block_that_was_damaged_is_computed_again(tmp_path, quantity, complaint):
    """4 kB overwritten in the partial file, or a line of the journal for another place."""
    axes = {"omega3": Span(0, 60, 200), "phi_dot": Span(-5, 5, 100)}
    sweep = Sweep(quantity, axes, TOP)
    path = stop_after(tmp_path, 12000, sweep, 2000)
    if complaint == "damaged":
        with path.open("r+b") as file:
            file.seek(5000)
            file.write(bytes(4096))
    journal = store.journal_path(path)
    if complaint == "moved":
        journal.write_bytes(journal.read_bytes().replace(b"2000 4000 ", b"14000 16000 "))
    again = Serial()
    found = run(sweep, path, again, block_size=2000)
    assert np.array_equal(found.values.ravel(), in_blocks(sweep, 2000))
    # Bytes 5000 to 9096 are of the first block of floats, and of three of codes.
    first = 0 if quantity == "theta_min" else 4000
    count = {"damaged": 2000 if quantity == "theta_min" else 6000, "moved": 2000, "kept": 0}
    assert found.damaged == count[complaint]
    assert len(again.blocks) == 4 + count[complaint] // 2000
    if complaint == "damaged":
        assert again.blocks[0] == (first, first + 2000)
    assert run(sweep, path).damaged == 0


def test_what_was_damaged_and_computed_again_stays(tmp_path):
    """In other blocks than before, and interrupted once more."""
    path = stop_after(tmp_path, 600)
    with path.open("r+b") as file:
        for point in (250, 290):
            file.seek(128 + 8 * point)
            file.write(b"damaged!")
    with pytest.raises(rt.RigidtopError, match="564 of 1000 points are in"):
        run(SMALL, path, Serial(1), block_size=64)
    again = Serial()
    found = run(SMALL, path, again, block_size=1000)
    assert again.blocks == [(264, 300), (600, 1000)]
    assert found.damaged == 36
    assert found.values.ravel() == pytest.approx(block(SMALL, 0, 1000), rel=1e-15)


def test_what_was_damaged_after_its_end_is_computed_again(tmp_path):
    path = stop_after(tmp_path, 600)
    run(SMALL, path, Serial(), block_size=100)
    with path.open("r+b") as file:
        file.seek(128 + 8 * 450)
        file.write(b"damaged!")
    with pytest.raises(rt.RigidtopError, match=r"map\.npy is no longer what was written: run its"):
        load(path)
    with pytest.raises(rt.RigidtopError, match="900 of 1000 points are in"):
        run(SMALL, path, Serial(0), block_size=100)
    assert files(tmp_path) == ["map.npy", "map.npy.journal", "map.npy.json"]
    again = Serial()
    found = run(SMALL, path, again, block_size=64)
    assert again.blocks == [(400, 464), (464, 500)]
    assert found.damaged == 100
    assert files(tmp_path) == ["map.npy", "map.npy.json"]
    assert load(path).values.ravel() == pytest.approx(block(SMALL, 0, 1000), rel=1e-15)


@pytest.mark.parametrize(
    "tail", [b"300 4", b"300 400", b"300 400\n", b"\0\0\0\n", b"900 1100 0\n", b"7 7\n1 2\n"]
)
def test_a_torn_journal_costs_its_last_block(tmp_path, tail):
    path = stop_after(tmp_path, 300)
    journal = store.journal_path(path)
    journal.write_bytes(journal.read_bytes() + tail)
    again = Serial(2)
    with pytest.raises(rt.RigidtopError, match="500 of 1000 points"):
        run(SMALL, path, again, block_size=100)
    assert again.blocks == [(300, 400), (400, 500)]
    run(SMALL, path)
    assert np.array_equal(np.load(path).ravel(), block(SMALL, 0, 1000))


def test_what_the_disk_refuses_is_not_in_the_journal(tmp_path, monkeypatch):
    path = stop_after(tmp_path, 300)

    def refuse(file, start, values):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr(store.Store, "write", refuse)
        with pytest.raises(rt.RigidtopError, match=r"map\.npy: No space left on device$"):
            run(SMALL, path, Serial(), block_size=100)
    again = Serial()
    run(SMALL, path, again, block_size=100)
    assert len(again.blocks) == 7


@pytest.mark.parametrize("lost", [store.journal_path, lambda path: path], ids=["journal", "map"])
def test_what_is_lost_costs_time_alone(tmp_path, lost):
    path = stop_after(tmp_path, 300)
    lost(path).unlink()
    again = Serial()
    run(SMALL, path, again, block_size=100)
    assert len(again.blocks) == 10


SLOW = """
import sys, time
from rigidtop.motion.sweep import Span, Sweep, run
def progress(done, total):
    print(done, total, flush=True)
    time.sleep(float(sys.argv[2]))
top = {"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "R": 0.5, "theta": 0.5, "t": 2.0}
sweep = Sweep("phi", {"omega3": Span(1, 60, 500), "phi_dot": Span(-5, 5, 60)}, top)
if __name__ == "__main__":
    run(sweep, sys.argv[1], block_size=1000, progress=progress)
"""
"""Many seconds, where each block waits for some time."""


def test_a_killed_run_loses_little(tmp_path):
    script = tmp_path / "slow.py"
    script.write_text(SLOW)
    path = tmp_path / "map.npy"
    command = [sys.executable, str(script), str(path)]
    with subprocess.Popen([*command, "0.1"], stdout=subprocess.PIPE, text=True) as process:
        while not store.journal_path(path).exists() or not store.journal_path(path).stat().st_size:
            assert process.stdout.readline()
        process.send_signal(signal.SIGKILL)
    assert process.returncode == -signal.SIGKILL
    assert json.loads(store.about_path(path).read_text())["complete"] is False
    again = subprocess.run([*command, "0"], capture_output=True, text=True, check=True, timeout=120)
    assert int(again.stdout.split()[0]) > 0
    found = load(path)
    assert np.array_equal(found.values.ravel(), in_blocks(found.sweep, 1000))


# --- Files that are in the way -------------------------------------------------------------------


def test_another_sweep_is_refused(tmp_path):
    path = stop_after(tmp_path, 300)
    before = {each: each.read_bytes() for each in tmp_path.iterdir()}
    other = Sweep("theta_min", SMALL.axes, {**TOP, "theta": 0.6})
    with pytest.raises(rt.RigidtopError, match=r"holds another sweep \(other fixed\): delete it"):
        run(other, path)
    with pytest.raises(rt.RigidtopError, match=r"\(other quantity\)"):
        run(Sweep("theta_max", SMALL.axes, TOP), path)
    assert {each: each.read_bytes() for each in tmp_path.iterdir()} == before


def test_a_file_of_something_else_is_refused(tmp_path):
    np.save(tmp_path / "map.npy", np.arange(3))
    with pytest.raises(rt.RigidtopError, match=r"no map\.npy\.json says that a sweep wrote it"):
        run(SMALL, tmp_path / "map.npy")
    with pytest.raises(rt.RigidtopError, match="is not an ordinary file"):
        run(SMALL, tmp_path)
    assert files(tmp_path) == ["map.npy"]
    assert np.load(tmp_path / "map.npy").tolist() == [0, 1, 2]


@pytest.mark.parametrize("change", ["cut", "longer"])
@pytest.mark.parametrize("complete", [False, True])
def test_a_file_of_another_length_is_refused(tmp_path, complete, change):
    path = stop_after(tmp_path, 300)
    if complete:
        run(SMALL, path)
    with path.open("r+b") as file:
        if change == "cut":
            file.truncate(1000)
        else:
            file.seek(0, os.SEEK_END)
            file.write(b"\n")
    with pytest.raises(rt.RigidtopError, match="is not as the sweep left it"):
        run(SMALL, path)


@pytest.mark.skipif(sys.platform == "win32", reason="no lock there")
def test_two_runs_at_one_file_are_one_too_many(tmp_path):
    def second(done, total):
        with pytest.raises(rt.RigidtopError, match=r"another run is writing .*map\.npy$"):
            run(SMALL, tmp_path / "map.npy")

    run(SMALL, tmp_path / "map.npy", progress=second)


def test_more_than_the_disk_takes_is_refused(tmp_path):
    vast = Sweep("theta_min", {"omega3": Span(0, 1, 10**9), "psi": Span(0, 1, 10**9)}, TOP)
    with pytest.raises(rt.RigidtopError, match=r"map\.npy takes 8e\+18 bytes, and .* are free"):
        run(vast, tmp_path / "map.npy")
    assert files(tmp_path) == []


def test_a_link_keeps_its_place(tmp_path):
    (tmp_path / "disk").mkdir()
    (tmp_path / "map.npy").symlink_to(tmp_path / "disk" / "1.npy")
    run(SMALL, tmp_path / "map.npy")
    assert (tmp_path / "map.npy").is_symlink()
    assert files(tmp_path / "disk") == ["1.npy", "1.npy.json"]
    assert load(tmp_path / "map.npy").sweep == SMALL


# --- Reading -------------------------------------------------------------------------------------


def test_what_is_loaded_is_what_was_run(tmp_path):
    sweep = Sweep("regime", AXES, TOP)
    written = run(sweep, tmp_path / "map.npy")
    found = load(tmp_path / "map.npy")
    assert found.sweep == sweep
    assert np.array_equal(found.values, written.values)
    assert not found.values.flags.writeable
    assert json.loads((tmp_path / "map.npy.json").read_text())["names"] == list(REGIMES)


def test_what_is_not_complete_is_not_loaded(tmp_path):
    with pytest.raises(rt.RigidtopError, match=r"no sweep wrote .*map\.npy"):
        load(tmp_path / "map.npy")
    path = stop_after(tmp_path, 300)
    with pytest.raises(rt.RigidtopError, match="is not complete: run its sweep again"):
        load(path)
    run(SMALL, path)
    store.about_path(path).write_text('{"complete": true, "axes": 3}')
    with pytest.raises(rt.RigidtopError, match="is not what a sweep wrote"):
        load(path)


# --- Bad input -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("quantity", "axes", "fixed", "message"),
    [
        ("colour", AXES, TOP, "no quantity 'colour': there are regime, "),
        ("regime", {}, TOP, "a sweep wants an axis at least"),
        ("regime", {"mass": Span(1, 2, 3)}, TOP, "a top has no 'mass': there are lambda1, "),
        ("regime", AXES, {**TOP, "omega3": 1}, "omega3 is both fixed and an axis"),
        ("regime", AXES, {}, "a sweep wants lambda1, fixed or as an axis"),
        ("regime", AXES, {**TOP, "t": 1}, "regime has no time: leave t out"),
        ("theta", AXES, TOP, r"theta is wanted at a time: give t \(s\)"),
        ("regime", AXES, {**TOP, "M": math.nan}, "M must be finite"),
        ("regime", AXES, {**TOP, "psi_dot": 1}, "give omega3 or psi_dot, one of them"),
        ("regime", {"phi_dot": Span(0, 1, 2)}, TOP, "give omega3 or psi_dot, one of them"),
        # Wrong in one corner of the grid alone.
        (
            "regime",
            {**AXES, "lambda1": Span(2, 0.4, 9), "lambda3": Listed((0.1, 0.5, 0.2))},
            {n: TOP[n] for n in ("M", "R", "theta")},
            "lambda1 is too small",
        ),
    ],
)
def test_what_makes_no_sense_is_said_before_the_work(quantity, axes, fixed, message):
    with pytest.raises(rt.RigidtopError, match=message):
        Sweep(quantity, axes, fixed)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Span(0, math.inf, 3), "stop must be finite"),
        (lambda: Span(0, 1, 1), "count must be a whole number from 2, not 1"),
        (lambda: Span(0, 1, 2.5), "count must be a whole number from 2, not 2.5"),
        (lambda: Listed(()), "an axis wants at least one value"),
        (lambda: Listed(("a",)), "a value must be a number, not 'a'"),
        (lambda: run(SMALL, "x.npy", block_size=0), "block_size must be a whole number from 1"),
        (lambda: run(SMALL, "x.npy", ahead=0), "ahead must be a whole number from 1, not 0"),
    ],
)
def test_axes_and_blocks_that_make_no_sense(make, message):
    with pytest.raises(rt.RigidtopError, match=message):
        make()


# --- Executors -----------------------------------------------------------------------------------


def test_errors_of_ours_come_through_as_they_are(tmp_path):
    error = rt.RigidtopError("R must be 0 or not so tiny")
    with pytest.raises(rt.RigidtopError, match=r"^R must be 0 or not so tiny$"):
        run(SMALL, tmp_path / "map.npy", Serial(2, error), block_size=100)


def test_a_worker_with_another_version_writes_nothing(tmp_path):
    class Other(Serial):
        def submit(self, function, *arguments):
            return super().submit(lambda *a: function(*a).astype(np.float32), *arguments)

    with pytest.raises(rt.RigidtopError, match="is its rigidtop the same as here"):
        run(SMALL, tmp_path / "map.npy", Other())
    again = Serial()
    run(SMALL, tmp_path / "map.npy", again, block_size=100)
    assert len(again.blocks) == 10


def test_few_blocks_are_on_their_way(tmp_path):
    sent, done, most = [0], [0], [0]

    class Counting(ThreadPoolExecutor):
        def submit(self, function, *arguments):
            sent[0] += 1
            most[0] = max(most[0], sent[0] - done[0])
            return super().submit(function, *arguments)

    def progress(points, total):
        done[0] = points // 10

    with Counting(1) as pool:
        run(SMALL, tmp_path / "map.npy", pool, block_size=10, ahead=7, progress=progress)
    assert most == [7]


def test_the_grid_is_never_in_memory(tmp_path):
    grid = Sweep("theta_min", {"omega3": Span(0, 60, 400), "phi_dot": Span(-5, 5, 400)}, TOP)
    run(SMALL, tmp_path / "small.npy")
    tracemalloc.start()
    try:
        run(grid, tmp_path / "map.npy", Serial(), block_size=1 << 9, ahead=2)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert (tmp_path / "map.npy").stat().st_size > 1_280_000
    assert peak < 1_240_000


@pytest.mark.parametrize("ahead", [1, 2, 64])
def test_blocks_that_are_done_at_the_same_time_are_not_the_last(tmp_path, ahead):
    found = run(SMALL, tmp_path / "map.npy", Serial(), block_size=20, ahead=ahead)
    assert np.array_equal(found.values, load(tmp_path / "map.npy").values)
    assert np.array_equal(found.values.ravel(), block(SMALL, 0, 1000))


def test_a_pool_that_breaks_can_be_resumed_from(tmp_path):
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:

        def progress(done, total):
            # Two blocks may be done at once, so that no single number is sure to be reported; the
            # call ends when the worker has died, since until then the others would go on.
            if 200 <= done < 300:
                with contextlib.suppress(BrokenProcessPool):
                    pool.submit(os._exit, 1).exception()

        message = r"the executor failed \(BrokenProcessPool: .*\); \d+ of 1000 points are in"
        with pytest.raises(rt.RigidtopError, match=message):
            run(SMALL, tmp_path / "map.npy", pool, block_size=20, ahead=2, progress=progress)
    again = Serial()
    run(SMALL, tmp_path / "map.npy", again, block_size=20)
    assert len(again.blocks) <= 40
    assert np.array_equal(np.load(tmp_path / "map.npy").ravel(), block(SMALL, 0, 1000))


@pytest.mark.skipif(
    importlib.util.find_spec("distributed") is None, reason="distributed is not installed"
)
# Dask's own: sockets of a worker that was killed are closed by no one, and its clean-up warns.
@pytest.mark.filterwarnings("ignore")
def test_a_worker_of_a_cluster_is_killed_and_nothing_is_lost(tmp_path):
    from distributed import Client, LocalCluster

    sweep = Sweep("phi", {"omega3": Span(1, 60, 100), "phi_dot": Span(-5, 5, 400)}, TOP | {"t": 2})
    killed, seen = [], []
    with (
        LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster,
        Client(cluster) as client,
    ):

        def progress(done, total):
            seen.append(done)
            if done > total / 4 and not killed:
                at_work = {worker: keys for worker, keys in client.processing().items() if keys}
                worker, keys = max(at_work.items(), key=lambda item: len(item[1]))
                pid = client.run(os.getpid, workers=[worker])[worker]
                os.kill(pid, signal.SIGKILL)
                killed.append((pid, len(keys)))

        def swept():
            executor, file = client.get_executor(), tmp_path / "map.npy"
            return run(sweep, file, executor, block_size=1000, progress=progress)

        try:
            found = swept()
        except rt.RigidtopError:  # Dask's executor itself may fail as a worker is killed
            assert killed
            found = swept()  # goes on from there
        left = set(client.run(os.getpid).values())
    [(pid, waiting)] = killed
    assert waiting > 0
    assert pid not in left
    assert sorted({*seen}) == list(range(0, 40_001, 1000))
    assert np.array_equal(found.values.ravel(), in_blocks(sweep, 1000))


def test_the_failure_is_one_line(tmp_path):
    with pytest.raises(rt.RigidtopError) as caught:
        run(SMALL, tmp_path / "map.npy", Serial(1, OSError("two\nlines")), block_size=100)
    assert re.fullmatch(
        r"the executor failed \(OSError: two lines\); 100 of 1000 points are in .*map\.npy, and "
        "the same call goes on from there",
        str(caught.value),
    )
    assert isinstance(caught.value.__cause__, OSError)
