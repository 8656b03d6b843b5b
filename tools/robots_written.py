# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""MuJoCo's compiler judges written MJCF: of every MJCF file of the corpus that it compiles and that loads, the file that we write from it
must compile too and have, at random positions, velocities and controls, the same poses, mass matrix, bias forces, passive forces and forces of
actuators. What a file has and its written one lacks is named by its first difference and the lines of the model's report that say ignored.
scripts/robots-corpus --written calls it."""
import collections
import ctypes
import pathlib
import re
import tempfile

import mujoco
import numpy as np

import robots_corpus
from robots_library import Model, load_library, silence

POSES, TOLERANCE = 20, 1e-6


def positions(model, random):
    """Near the reference, quaternions of length 1."""
    q = model.qpos0 + random.normal(size=model.nq)
    for joint in range(model.njnt):
        at, kind = model.jnt_qposadr[joint], int(model.jnt_type[joint])
        if kind < 2:
            at += 3 * (kind == 0)
            q[at:at + 4] /= np.linalg.norm(q[at:at + 4])
    return q


def forces(model, data, q, v, u):
    """By name, what both models must agree in."""
    mujoco.mj_resetData(model, data)
    data.qpos[:], data.qvel[:] = q, v
    if model.nu:
        data.ctrl[:] = u
    mujoco.mj_forward(model, data)
    full = np.zeros((model.nv, model.nv))
    for i, unit in enumerate(np.eye(model.nv)):
        mujoco.mj_mulM(model, data, full[i], unit)
    return {"poses": np.hstack([data.xpos.ravel(), data.xmat.ravel()]), "mass matrix": full, "bias forces": data.qfrc_bias.copy(),
            "passive forces": data.qfrc_passive.copy(), "forces of actuators": data.qfrc_actuator.copy(),
            "errors of equalities": np.sort(np.abs(data.efc_pos[:data.ne]))}


def sizes(model):
    return {"bodies": model.nbody, "positions": model.nq, "velocities": model.nv}


def shared_controls(one, two):
    """Of each control of two, its number in one: by name where some are missing."""
    if one.nu == two.nu:
        return np.arange(one.nu)
    return np.array([one.actuator(two.actuator(i).name).id for i in range(two.nu)], dtype=int)


def difference(one, two, random):
    """What differs first, or an empty text. Controls that are missing are 0 in one."""
    missing = "" if one.nu == two.nu else f"controls: {one.nu}, {two.nu}, else the same"
    for name, count in sizes(one).items():
        if count != sizes(two)[name]:
            return f"{name}: {count}, {sizes(two)[name]}"
    known = shared_controls(one, two)
    a, b = mujoco.MjData(one), mujoco.MjData(two)
    for _ in range(POSES):
        q, v = positions(one, random), random.normal(size=one.nv)
        low, high = np.where(one.actuator_ctrllimited[:, None] != 0, one.actuator_ctrlrange, [-1.0, 1.0]).T
        u = random.uniform(low, np.maximum(low, high))
        shared = np.zeros(one.nu)
        shared[known] = u[known]
        theirs, mine = forces(one, a, q, v, shared), forces(two, b, q, v, u[known])
        for name, values in theirs.items():
            if len(values) != len(mine[name]):
                return f"{name}: {len(values)}, {len(mine[name])}"
            error = np.abs(values - mine[name]).max(initial=0) / max(1e-3, np.abs(values).max(initial=0))
            if not error <= TOLERANCE:
                return f"{name} by {error:.1e}"
    return missing


def compiled(path):
    try:
        return mujoco.MjModel.from_xml_path(str(path)), ""
    except ValueError as problem:
        return None, str(problem).splitlines()[0][:200]


def judge(library, root, path, folder, counts):
    original, _ = compiled(path)
    if original is None:
        return ""
    mine = Model(library, path, root, keep_fixed=1, repair=1)
    ignored = sorted({robots_corpus.kind_of(text) for note, _, text in mine.report if note == "ignored"})
    written = pathlib.Path(folder) / "written.xml"
    saved = not mine.errors and library.dRobotModelSave(mine.handle, str(written).encode())
    mine.close()
    if not saved:
        counts["not loaded"] += 1
        return ""
    counts["loaded"] += 1
    again, problem = compiled(written)
    what = difference(original, again, np.random.default_rng(1)) if again else "is not compiled: " + problem
    counts["compiled"] += again is not None
    counts["same"] += not what
    return what and f"{path.name}: {what}; ignored: {', '.join(ignored) or 'nothing'}"


def table(path, fast, only):
    """Prints a line for each file that differs, then the counts. Returns 1 if a file differs of which nothing was ignored."""
    library, handlers, counts, failed = load_library(path), silence(path), collections.Counter(), 0
    library.dRobotModelSave.argtypes = [ctypes.c_void_p, ctypes.c_char_p]
    with tempfile.TemporaryDirectory() as folder:
        for _, root, file, kind in robots_corpus.corpus(fast):
            if kind != "MJCF" or only not in str(file):
                continue
            line = judge(library, root, file, folder, counts)
            if line:
                print(line, flush=True)
                failed |= bool(re.search("ignored: nothing$", line))
    print(", ".join(f"{count} {name}" for name, count in counts.items()))
    del handlers
    return failed
