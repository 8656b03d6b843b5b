# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The arm that lifts a cube: grasped by a program in closed form, it is held by friction; what is observed and rewarded."""
import numpy as np
import pytest

import epode

pytest.importorskip("gymnasium")
import epode.vector  # noqa: E402
from epode.vector.lift import REACH, joints_for  # noqa: E402

SEEN = ("qpos", "qvel", "xpos")


def action(points, *, closed):
    arm = np.array([joints_for(*point) for point in points]) / REACH
    return np.concatenate([arm, np.full((len(points), 2), -1.0 if closed else 1.0)], 1)


def go(env, points, steps, *, closed):
    for _ in range(steps):
        result = env.step(action(points, closed=closed))
    return result


@pytest.mark.parametrize("dtype", ["float32", "float64"])
def test_a_cube_is_lifted_and_held_by_friction(dtype):
    env = epode.vector.make("Lift", 24, dtype=dtype, max_episode_steps=0)
    env.reset(seed=1)
    links, grip = env.batch.model.link_names, 3 * env.batch.model.link_names.index("grip")
    assert links[-1] == "cube"
    cube = env.batch.read("qpos")[:, -7:-4].astype(float)
    go(env, cube + [0, 0, 0.12], 60, closed=False)
    go(env, cube, 40, closed=False)
    go(env, cube, 40, closed=True)
    go(env, cube + [0, 0, 0.2], 100, closed=True)

    def held():
        return env.batch.read("qpos")[:, -7:-4] - env.batch.read("xpos")[:, grip:grip + 3]
    before = held()
    assert (env.batch.read("qpos")[:, -5] > 0.2).all()
    _, rewards, terminated, _, _ = go(env, cube + [0, 0, 0.2], 250, closed=True)  # 5 s
    assert abs(held() - before).max() < 2e-5 and not terminated.any() and env.batch.bad == 0 and (rewards > 1.4).all()
    go(env, cube + [0, 0, 0.2], 50, closed=False)
    assert (abs(env.batch.read("qpos")[:, -5] - 0.02) < 2e-3).all()


def test_observations_and_rewards_are_what_the_task_says():
    env = epode.vector.make("Lift", 4, dtype="float64", threads=1)
    env.reset(seed=3)
    grip, rng, last = 3 * env.batch.model.link_names.index("grip"), np.random.default_rng(1), np.zeros((4, 7))
    for _ in range(40):
        actions = rng.uniform(-1, 1, (4, 7))
        observations, rewards, _, _, infos = env.step(actions)
        s = {name: env.batch.read(name) for name in SEEN}
        for i in range(4):
            tip, cube, goal = s["xpos"][i, grip:grip + 3], s["qpos"][i, -7:-4], observations[i, 33:36]
            expected = np.concatenate([s["qpos"][i, :7], 0.1 * s["qvel"][i, :7], tip, s["qpos"][i, -7:], 0.1 * s["qvel"][i, -6:], cube - tip,
                                       goal, cube - goal, actions[i]])
            assert abs(expected - observations[i]).max() < 1e-12
            reward = (0.5 * np.exp(-np.sum((cube - tip)**2) / 0.02) + np.clip(10 * (cube[2] - 0.02), 0, 1)
                      + 4 * np.exp(-np.sum((cube - goal)**2) / 0.02) - 1e-3 * np.sum(actions[i]**2) - 1e-2 * np.sum((actions[i] - last[i])**2))
            assert abs(reward - rewards[i]) < 1e-12 and abs(infos["goal_distance"][i] - np.linalg.norm(cube - goal)) < 1e-12
        last = actions


def test_joints_are_found_where_they_can_be():
    for point in ((0.4, 0.1, 0.02), (0.3, -0.15, 0.35)):
        env = epode.vector.make("Lift", 1, dtype="float64", max_episode_steps=0)
        env.reset(seed=1)
        qpos = env.batch.read("qpos")
        qpos[0, :5] = joints_for(*point)
        env.batch.write("qpos", qpos)
        grip = 3 * env.batch.model.link_names.index("grip")
        assert abs(env.batch.read("xpos")[0, grip:grip + 3] - point).max() < 1e-12
    with pytest.raises(ValueError, match="reach"):
        joints_for(0.9, 0, 0)
