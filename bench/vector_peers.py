# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A peer of bench/vector in a process of its own, whose interpreter has it: peers want a MuJoCo of their own each.

  PYTHON bench/vector_peers.py PEER NAME COPIES THREADS STEPS FILE

For each line that it reads it makes so many environment steps with random actions and answers with the seconds of one.
PEER: envpool (the task of Gymnasium, its file's integrator) or mjbatch (Gymnasium's FILE with Euler's step, frame skip 5: no
observations, no rewards, no resets)."""
import sys
import time

import numpy as np


def envpool(name, copies, threads):
    import envpool as peer
    task = next(f"{name}-v{version}" for version in (5, 4) if f"{name}-v{version}" in peer.list_all_envs())
    env = peer.make(task, env_type="gymnasium", num_envs=copies, num_threads=threads, seed=1)
    env.reset()
    dtype = env.action_space.dtype
    return env.action_space.shape[-1], lambda row: env.step(row.astype(dtype, copy=False))


def mjbatch(file, copies, threads):
    import mjbatch as peer
    import mujoco
    model = mujoco.MjModel.from_xml_path(file)
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_EULER
    batch = peer.Batch(model, num_sims=copies, num_threads=threads)
    control = batch.bind("ctrl")

    def step(row):
        control[:] = row
        batch.step(nstep=5)
    return model.nu, step


def main():
    peer, name, copies, threads, steps, file = sys.argv[1:]
    size, step = envpool(name, int(copies), int(threads)) if peer == "envpool" else mjbatch(file, int(copies), int(threads))
    rows = np.random.default_rng(1).uniform(-1, 1, (int(steps), int(copies), size))
    for _ in sys.stdin:
        begin = time.perf_counter()
        for row in rows:
            step(row)
        print((time.perf_counter() - begin) / len(rows), flush=True)


if __name__ == "__main__":
    main()
