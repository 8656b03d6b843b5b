# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""CPU microseconds of a world's step in MuJoCo's rollout, with the Euler integrator, on Gymnasium's own file of a
machine: random controls held five steps, one thread.

    rollout_mujoco.py FILE WORLDS STEPS ROUNDS
"""
import glob
import json
import os
import sys
import time

import mujoco
import mujoco.rollout
import numpy

HOLD = 5


def assets():
    """The folder of Gymnasium's models; importing gymnasium would cost more than all steps."""
    for folder in sys.path:
        for found in glob.glob(os.path.join(folder, 'gymnasium/envs/mujoco/assets')):
            return found
    sys.exit('rollout_mujoco: gymnasium is not installed')


def main():
    name, worlds, steps, rounds = sys.argv[1], *map(int, sys.argv[2:])
    model = mujoco.MjModel.from_xml_path(os.path.join(assets(), name))
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_EULER
    data = mujoco.MjData(model)
    full = mujoco.mjtState.mjSTATE_FULLPHYSICS
    state = numpy.zeros((worlds, mujoco.mj_stateSize(model, full)))
    one = numpy.zeros(state.shape[1])
    mujoco.mj_getState(model, data, one, full)
    state[:] = one
    random = numpy.random.default_rng(1)
    low, high = model.actuator_ctrlrange.T
    best = float('inf')
    for _ in range(rounds + 1):   # the first settles
        control = random.uniform(low, high, (worlds, (steps + HOLD - 1) // HOLD, model.nu)).repeat(HOLD, axis=1)
        start = time.process_time()
        states, _ = mujoco.rollout.rollout(model, [data], initial_state=state, control=control)
        best = min(best, (time.process_time() - start) / control.shape[1] / worlds)
        state = states[:, -1, :].copy()
    contacts = []
    for row in state:
        mujoco.mj_setState(model, data, row, full)
        mujoco.mj_forward(model, data)
        contacts.append(data.ncon)
    print(json.dumps({'us': best * 1e6, 'contacts': sum(contacts) / len(contacts), 'version': mujoco.__version__}))


if __name__ == '__main__':
    main()
