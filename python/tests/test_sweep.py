# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Sweeps: what plans draw, that rows do not depend on where they ran, and that nothing is lost or doubled, whatever ends."""
import concurrent.futures
import functools
import importlib.util
import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("pyarrow"), pytest.importorskip("cloudpickle")
sys.path.insert(0, str(Path(__file__).parent))

import sweep_scenes as scenes  # noqa: E402

import epode  # noqa: E402
from epode import sweep  # noqa: E402
from epode.sweep import identity, progress  # noqa: E402

HAS_RAY = importlib.util.find_spec("ray") is not None
needs_ray = pytest.mark.skipif(not HAS_RAY, reason="ray is not installed")


@pytest.fixture(scope="module")
def one_ray():
    """One start of Ray serves this module."""
    import ray
    ray.init("local", num_cpus=2, include_dashboard=False, log_to_driver=False, logging_level="error",
             runtime_env={"env_vars": {"PYTHONPATH": os.pathsep.join(path or "." for path in sys.path)}})
    yield
    ray.shutdown()


@pytest.fixture(params=["serial", "threads", pytest.param("ray", marks=needs_ray)])
def place(request):
    """Each executor that has a name."""
    if request.param == "ray":
        request.getfixturevalue("one_ray")
    return request.param


def what_matters(table):
    return table.drop_columns(["duration", "node"])


# ---- plans ----

def test_a_grid_is_nested_loops():
    plan = sweep.grid(a=[1, 2], b=["x", "y", "z"], seed=range(5, 7))
    expected = [({"a": a, "b": b}, seed) for a in (1, 2) for b in "xyz" for seed in (5, 6)]
    assert list(plan) == expected and len(plan) == 12 and plan[7] == expected[7]
    assert sweep.grid(a=[1, 2.5])[0] == ({"a": 1.0}, 0)
    assert sweep.log(1, 100, 3) == pytest.approx([1, 10, 100], rel=1e-15) and sweep.linear(0, 1, 5) == [0, 0.25, 0.5, 0.75, 1]
    assert len(sweep.grid(seed=range(10**12), a=[1, 2])) == 2 * 10**12


def test_draws_are_distributed_as_said_and_follow_from_the_run_alone():
    axes = {"u": sweep.distribution("uniform", 2, 5), "n": sweep.distribution("normal", 1, 0.5), "g": sweep.distribution("log", 1, 100)}
    rows = [parameters for parameters, _ in sweep.grid(**axes, draws=3, seed=range(4000))]
    u, n, g = (np.array([row[name] for row in rows]) for name in "ung")
    assert 2 < u.min() and u.max() < 5
    for sample, cumulative in ((u, lambda x: (x - 2) / 3), (g, lambda x: math.log(x) / math.log(100)),
                               (n, lambda x: 0.5 * (1 + math.erf((x - 1) / 0.5 / math.sqrt(2))))):
        shares = np.sort([cumulative(x) for x in sample])
        assert abs(shares - (np.arange(4000) + 0.5) / 4000).max() < 1.63 / math.sqrt(4000)  # Kolmogorov and Smirnov, 1 %
    assert abs(np.corrcoef([u, n, np.log(g)])[np.triu_indices(3, 1)]).max() < 0.06
    alone = [parameters["u"] for parameters, _ in sweep.grid(seed=range(4000), u=axes["u"], draws=3)]
    assert alone == list(u) and alone != [p["u"] for p, _ in sweep.grid(u=axes["u"], draws=4, seed=range(4000))]
    assert alone[0].hex() == "0x1.0b2bcc168c507p+2"  # on every machine


@pytest.mark.parametrize("axes, problem", [
    ({}, "without axes"), ({"a": []}, "no value"), ({"a": [1, "x"]}, "one type"), ({"a": [float("nan")]}, "finite"), ({"a": [2**63]}, "64 bits"),
    ({"a": "word"}, "sequence"), ({"a": 3}, "sequence"), ({"a": [[1]]}, "numbers"), ({"error": [1]}, "column"), ({"seed": [0.5]}, "seed"),
    ({"seed": [-1]}, "seed"), ({"seed": sweep.distribution("uniform", 0, 1)}, "seed"), ({"a": [1], "draws": -1}, "draws")])
def test_what_no_plan_can_be_is_refused(axes, problem):
    with pytest.raises((ValueError, TypeError), match=problem):
        sweep.grid(**axes)


@pytest.mark.parametrize("make", [lambda: sweep.distribution("even", 0, 1), lambda: sweep.distribution("uniform", 1, 1),
                                  lambda: sweep.distribution("normal", 0, 0), lambda: sweep.distribution("log", 0, 1),
                                  lambda: sweep.distribution("uniform", 0, float("inf")), lambda: sweep.log(0, 1, 3), lambda: sweep.linear(0, 1, 0)])
def test_what_no_distribution_can_be_is_refused(make):
    with pytest.raises(ValueError, match="expected"):
        make()


# ---- rows ----

@pytest.fixture(scope="module")
def serial_rows(tmp_path_factory):
    plan = sweep.grid(friction=[0.1, 0.5], mass=sweep.distribution("log", 0.5, 2), seed=range(50))
    return plan, sweep.run(scenes.slide, plan, out=tmp_path_factory.mktemp("serial"), executor="serial", chunk=100)


def test_rows_say_what_ran_and_what_came_out(serial_rows):
    plan, table = serial_rows
    assert table.column_names == ["run", "friction", "mass", "seed", "x", "world_residual", "world_joint_error", "world_penetration",
                                  "world_contained_islands", "state_hash", "error", "duration", "node"]
    assert table["run"].to_pylist() == list(range(100)) and table["error"].null_count == 100
    assert [(row["mass"], row["seed"]) for row in table.to_pylist()] == [(parameters["mass"], seed) for parameters, seed in plan]
    x = table["x"].to_numpy().reshape(2, 50)
    assert x[0].min() > x[1].max()  # less friction slides farther
    assert len(set(table["state_hash"].to_pylist())) == 100 and min(table["duration"].to_pylist()) > 0


@pytest.mark.parametrize("chunk", [7, 30])
def test_rows_have_the_same_bits_everywhere(place, chunk, serial_rows, tmp_path):
    plan, expected = serial_rows
    table = sweep.run(scenes.slide, plan, out=tmp_path, executor=place, chunk=chunk)
    assert what_matters(table).equals(what_matters(expected))
    assert len(list(tmp_path.glob("*.parquet"))) == math.ceil(100 / chunk) and what_matters(sweep.read(tmp_path)).equals(what_matters(expected))


def test_any_executor_will_do_and_runs_need_no_process_of_their_own(serial_rows, tmp_path):
    plan, expected = serial_rows
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        table = sweep.run(scenes.slide, plan, out=tmp_path, executor=pool, chunk=20, isolated=False)
    assert what_matters(table).equals(what_matters(expected))


def test_scenes_may_be_closures(tmp_path):
    factor = 3.0

    def scene(parameters, seed):
        return {"value": factor * parameters["a"]}
    table = sweep.run(scene, sweep.grid(a=[1.0, 2.0]), out=tmp_path, executor="threads")
    assert table["value"].to_pylist() == [3.0, 6.0]


# ---- failures ----

def test_failed_runs_are_rows_that_say_why(place, tmp_path):
    table = sweep.run(scenes.troubled, sweep.grid(a=[1.0], seed=range(9)), out=tmp_path, executor=place, chunk=3, limit=1.5)
    errors = table["error"].to_pylist()
    assert [error is None for error in errors] == [True] + [False] * 7 + [True] and table["value"].to_pylist() == [1.0] + [None] * 7 + [1.0]
    for error, said in zip(errors[1:8], ["ZeroDivisionError: a scene of mine", "time limit: it did not end within 1.5 s", "signal 9",
                                         "exit code 7", "value='much'", "'a', which is a parameter", "int: a dict"], strict=True):
        assert said in error
    assert 1.5 <= table["duration"][2].as_py() < 6


def test_three_bad_chunks_in_a_row_stop_it(tmp_path):
    with pytest.raises(sweep.SweepError, match=r"(?s)3 chunks in a row.*no file of the number 5"):
        sweep.run(scenes.fails, sweep.grid(seed=range(40)), out=tmp_path, executor="serial", chunk=2)
    assert len(sweep.read(tmp_path)) == 6
    assert sweep.status(scenes.fails, sweep.grid(seed=range(40)), out=tmp_path, chunk=2).runs_there == 0  # all of them would be run again


def test_an_executor_that_gives_up_loses_nothing(tmp_path):
    class Broken(concurrent.futures.Executor):
        def submit(self, fn, *args, **kwargs):
            future = concurrent.futures.Future()
            future.set_exception(ConnectionError("no node"))
            return future
    table = sweep.run(scenes.number, sweep.grid(a=[1, 2]), out=tmp_path, executor=Broken(), chunk=1)
    assert ["no node" in error for error in table["error"].to_pylist()] == [True, True]
    table = sweep.run(scenes.number, sweep.grid(a=[1, 2]), out=tmp_path, executor="serial", chunk=1)
    assert table["value"].to_pylist() == [2.0, 4.0] and table["error"].null_count == 2


def test_scenes_that_cannot_be_loaded_say_so(tmp_path, monkeypatch):
    module = tmp_path / "vanishing.py"
    module.write_text("def scene(parameters, seed):\n    return {}\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    import vanishing
    module.unlink()
    table = sweep.run(vanishing.scene, sweep.grid(seed=[1]), out=tmp_path / "out", executor="serial")
    assert "cannot be loaded" in table["error"][0].as_py()


# ---- going on ----

def test_only_what_is_missing_is_run(tmp_path, monkeypatch):
    monkeypatch.setenv("SWEEP_COUNT", str(tmp_path / "count"))
    out, plan = tmp_path / "out", sweep.grid(a=[1.0], seed=range(12))
    options = {"out": out, "executor": "serial", "chunk": 3, "isolated": False}
    expected = sweep.run(scenes.counted, plan, **options)
    victims = sorted(out.glob("*.parquet"))
    victims[0].unlink()
    victims[1].write_bytes(victims[1].read_bytes()[:-20])  # torn, as no file of ours is
    (out / ".left.part").write_bytes(b"of a killed driver")
    assert sweep.status(scenes.counted, plan, out=out, chunk=3) == sweep.Status(12, 4, 6, 2, 0)
    assert what_matters(sweep.run(scenes.counted, plan, **options)).equals(what_matters(expected))
    assert len((tmp_path / "count").read_text().splitlines()) == 12 + 6 and not list(out.glob(".*.part"))
    more = sweep.run(scenes.counted, sweep.grid(a=[1.0], seed=range(15)), **options)
    assert len(more) == 15 and len((tmp_path / "count").read_text().splitlines()) == 12 + 6 + 3
    sweep.run(scenes.counted, plan, **options, version="other")
    assert len((tmp_path / "count").read_text().splitlines()) == 12 + 6 + 3 + 12


def made(text):
    names = {"__name__": "made"}
    exec(text, names)
    return names["scene"]


def test_a_scene_is_known_by_what_it_does():
    text = "K = 2\ndef helper(x):\n    return K * x\ndef scene(p, s, scale=1):\n    'text'\n    return {'v': helper(p['a']) * scale}\n"
    same = [text, "\n\n# a comment\n" + text.replace("'text'", "'other'"), text + "\ndef unused():\n    pass\n"]
    other = [text.replace("K = 2", "K = 3"), text.replace("K * x", "K + x"), text.replace("scale=1", "scale=2"), text.replace("'v'", "'w'")]
    assert len({identity.identity_of(made(one)) for one in same}) == 1
    assert len({identity.identity_of(made(one)) for one in [text, *other]}) == 5
    partial = [identity.identity_of(functools.partial(made(text), scale=scale)) for scale in (1, 1, 2)]
    assert partial[0] == partial[1] != partial[2]


DRIVER = """
import sys
sys.path.insert(0, {tests!r})
import sweep_scenes
from epode import sweep
sweep.run(sweep_scenes.counted, sweep.grid(a=[1.0], seed=range(200)), out={out!r}, executor="threads", chunk=2)
"""


def test_a_killed_driver_loses_its_unfinished_chunks_alone(tmp_path):
    count, out = tmp_path / "count", tmp_path / "out"
    environment = {**os.environ, "SWEEP_COUNT": str(count), "SWEEP_SECONDS": "0.1"}
    command = [sys.executable, "-c", DRIVER.format(tests=str(Path(__file__).parent), out=str(out))]
    driver = subprocess.Popen(command, env=environment)
    while len(list(out.glob("*.parquet"))) < 4:
        assert driver.poll() is None
        time.sleep(0.01)
    driver.send_signal(signal.SIGKILL)
    driver.wait()
    whole = len(list(out.glob("*.parquet")))
    assert 4 <= whole < 100
    time.sleep(1)  # children end when their worker has gone
    before = len(count.read_text().splitlines())
    time.sleep(0.5)
    assert len(count.read_text().splitlines()) == before
    subprocess.run(command, env={**environment, "SWEEP_SECONDS": "0"}, check=True)
    assert len(count.read_text().splitlines()) == before + 200 - 2 * whole
    assert sweep.read(out)["seed"].to_pylist() == list(range(200))


def test_a_full_disk_stops_it_and_it_goes_on(tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(disk)], capture_output=True).returncode:
        pytest.skip("a small disk cannot be mounted here")
    try:
        plan = sweep.grid(a=[1.0, 2.0], seed=range(100))
        options = {"out": disk / "out", "executor": "serial", "isolated": False, "chunk": 5}
        with pytest.raises(sweep.SweepError, match=r"disk is full; \d+ of 40 chunks are whole"):
            sweep.run(scenes.number, plan, **options)
        found = sweep.status(scenes.number, plan, out=disk / "out", chunk=5)
        assert 0 < found.chunks_there < 40 and not list((disk / "out").glob(".*.part"))
        subprocess.run(["mount", "-o", "remount,size=4m", str(disk)], check=True)
        assert sweep.run(scenes.number, plan, **options)["error"].null_count == 200
    finally:
        subprocess.run(["umount", str(disk)], check=True)


def test_two_drivers_do_not_share_a_folder(tmp_path):
    from epode.sweep import files
    tmp_path.mkdir(exist_ok=True)
    with files.locked(tmp_path), pytest.raises(sweep.SweepError, match="another sweep"):
        sweep.run(scenes.number, sweep.grid(a=[1]), out=tmp_path, executor="serial")


@pytest.mark.parametrize("wrong", [{"executor": "cloud"}, {"chunk": 0}, {"limit": 0}, {"limit": float("nan")}, {"limit": 1, "isolated": False}])
def test_wrong_options_are_refused(wrong, tmp_path):
    with pytest.raises(ValueError, match="expected|limit"):
        sweep.run(scenes.number, sweep.grid(a=[1]), out=tmp_path, **{"executor": "serial", **wrong})
    for scene, plan in ((3, sweep.grid(a=[1])), (scenes.number, [1])):
        with pytest.raises(TypeError, match="expected|makes one"):
            sweep.run(scene, plan, out=tmp_path)
    with pytest.raises(FileNotFoundError, match="no rows"):
        sweep.read(tmp_path / "nothing")


# ---- Ray ----

@needs_ray
def test_a_cluster_that_loses_and_gets_nodes_loses_and_doubles_nothing():
    """A short trial of bench/sweep/nodes, which has 2,000 runs: scripts/nightly does 20 of them."""
    script = Path(__file__).parent.parent.parent / "bench" / "sweep" / "nodes"
    done = subprocess.run([sys.executable, str(script), "--runs", "400", "--milliseconds", "20", "--trials", "1"], capture_output=True, text=True)
    assert done.returncode == 0 and "0 lost, 0 doubled, 0 other hashes" in done.stdout, done.stdout + done.stderr


# ---- the command ----

FILE = """
scene = "scene.py:double"
out = "rows"
executor = "serial"
chunk = 4
[axes]
a = {log = [1, 100, 3]}
b = {uniform = [0, 1]}
seed = {range = 2}
"""


def command(*words, cwd):
    return subprocess.run([sys.executable, "-m", "epode", "sweep", *words], capture_output=True, text=True, cwd=cwd)


def test_the_command_runs_a_file(tmp_path):
    (tmp_path / "scene.py").write_text("def double(parameters, seed):\n    print('aside')\n    return {'twice': 2 * parameters['a'] + seed}\n")
    (tmp_path / "sweep.toml").write_text(FILE)
    dry = command("sweep.toml", "--dry-run", cwd=tmp_path)
    assert dry.returncode == 0 and "6 runs in 2 chunks, 0 of them in rows" in dry.stdout and not (tmp_path / "rows").exists()
    done = command("sweep.toml", cwd=tmp_path)
    assert done.returncode == 0 and "6 rows, 0 of failed runs" in done.stdout and "6 of 6 runs" in done.stderr
    assert sweep.read(tmp_path / "rows")["twice"].to_pylist() == pytest.approx([2, 3, 20, 21, 200, 201])
    again = command("sweep.toml", cwd=tmp_path)
    assert again.returncode == 2 and "--resume" in again.stderr
    assert command("sweep.toml", "--resume", cwd=tmp_path).returncode == 0


@pytest.mark.parametrize("old, new, said", [
    ('"scene.py:double"', '"scene.py"', "FILE:FUNCTION"), ('scene.py:', 'other.py:', "no file"), (":double", ":triple", "no function"),
    ("chunk = 4", "chunk = 'many'", "wrong type"), ("chunk = 4", "pieces = 4", "pieces"), ("{log = [1, 100, 3]}", "{steps = 3}", "axes.a"),
    ('out = "rows"', "", "out"), ("[1, 100, 3]", "[0, 100, 3]", "0 < low"), ("[axes]", "[axes", "TOML|line|after|xpected")])
def test_files_that_say_something_else_are_refused(old, new, said, tmp_path):
    import re
    (tmp_path / "scene.py").write_text("def double(parameters, seed):\n    return {}\n")
    (tmp_path / "sweep.toml").write_text(FILE.replace(old, new))
    done = command("sweep.toml", cwd=tmp_path)
    assert done.returncode == 2 and re.search(said, done.stderr) and "Traceback" not in done.stderr, done.stderr


def test_progress_says_what_is_left():
    line = progress.Progress(2000, 400, shown=False)
    line.add(200, 3)
    assert line.line(30.0) == "[######              ] 600 of 2000 runs, 3 failed, 0:30, about 3:30 left"
    assert progress.clock(3723) == "1:02:03"


def test_what_is_missing_is_named(tmp_path):
    (tmp_path / "pyarrow.py").write_text("raise ImportError('not here')")
    done = subprocess.run([sys.executable, "-c", "import epode.sweep"], capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": os.pathsep.join([str(tmp_path), *(path or "." for path in sys.path)])})
    assert done.returncode == 1 and "pip install epode[sweep]" in done.stderr
    assert epode.sweep is sweep
