# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Every recipe runs, and does what it says."""
import importlib.util
import math
import os
from pathlib import Path

import numpy as np
import pytest

import epode

RECIPES = Path(__file__).parent.parent / "recipes"


def recipe(name):
    spec = importlib.util.spec_from_file_location(name, RECIPES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_pendulum():
    # 1.6493 s for small swings of a capsule; this one swings by some 4 degrees.
    assert recipe("pendulum").main() == pytest.approx(1.6493, rel=2e-3)


def test_buggy():
    x, y, z = recipe("buggy").main().position
    assert x > 8 and y > 3 and 0.2 < z < 0.8


def test_ragdoll():
    recording = recipe("ragdoll").main()
    assert len(recording) == 421
    assert recording.bodies(-1)[0, 2] < 0  # the pelvis is below the platform that the feet stood on
    assert np.isfinite(recording.bodies(-1)).all()


def test_harbour():
    """In every step size the same things happen, no joint opens, and in the end all of it is still."""
    for seen in recipe("harbour").main():
        assert seen.figure_gap < 0.06 and seen.rope_gap < 0.01 and seen.fastest < 20
        assert seen.fence_pieces >= 3                  # the car went through it
        x, _, z = seen.car.position
        assert x > 1 and -0.5 < z < 0.5                # and floats
        assert seen.asleep > 0.5 and seen.energy < 20


def test_a_harbour_has_the_same_bits_again():
    module = recipe("harbour")
    assert module.run(module.build(), 1 / 60, 8).state == module.run(module.build(), 1 / 60, 8).state


def test_arch():
    sunk, friction_error = recipe("arch").main()
    assert sunk < 0.004 and friction_error < 1e-6
    sunk_as_in_ode, _ = recipe("arch").main(cone=False)
    assert sunk_as_in_ode > 3 * sunk


def test_wrecking_ball():
    gap, scattered = recipe("wrecking_ball").main()
    assert gap < 0.003 and scattered > 6


def test_pile():
    seen = recipe("pile").main()
    assert seen["begin"] > 100 and seen["begin"] > seen["end"] > 0


def test_fourbar():
    # Two triangles on the diagonals where crank and coupler are in line: a + b and b - a.
    a, b, c, d = 0.3, math.hypot(1, 0.5), 0.8, 1.0

    def angle(diagonal):
        return math.degrees(math.acos((c * c + d * d - diagonal * diagonal) / (2 * c * d)))
    assert recipe("fourbar").main() == pytest.approx(angle(a + b) - angle(b - a), abs=0.1)


def test_servo():
    assert recipe("servo").main() < 0.005


def test_terrain():
    world = recipe("terrain").main()
    positions = world.bodies.position
    assert len(positions) == 49 and np.abs(positions[:, :2]).max() < 10 and positions[:, 2].min() > -1
    assert positions[:, 2].mean() < 0.9  # the land is 1.35 m high in the mean


def test_rays():
    assert 0.4 < recipe("rays").main(50_000) < 0.95


def test_rollback():
    assert recipe("rollback").main()


def test_many_worlds():
    assert recipe("many_worlds").main() > 150


def test_ant():
    """64 worlds of it: finite rewards, torsos where MuJoCo has them too, and nothing that depends on threads."""
    pytest.importorskip("gymnasium")
    module = recipe("ant")
    seen = module.main(count=64, steps=60)
    rewards, heights, fallen = seen["rewards"], seen["heights"], seen["fallen"].astype(bool)
    assert rewards.shape == (60, 64) and np.isfinite(rewards).all() and np.abs(rewards).max() < 20
    # MuJoCo 4.0's torsos in gymnasium's Ant-v5: 0.3 to 1.0 m while it is healthy, 0.6 m in the mean.
    assert 0.2 <= heights[~fallen].min() and heights[~fallen].max() <= 1.0 and 0.45 < heights.mean() < 0.75
    assert np.abs(seen["rewards"].mean(axis=0)).max() < 5 and fallen.mean() < 0.02


def test_ants_begin_again_with_the_same_bits():
    pytest.importorskip("gymnasium")
    module = recipe("ant")
    actions = np.random.default_rng(5).uniform(-1, 1, (20, 6, 8))
    runs = []
    for threads in (1, 2):
        ants = module.AntVector(6, threads=threads)
        for _ in range(2):                            # the second time worlds have a past, which the state forgets
            observed, _ = ants.reset(seed=9)
            assert observed.shape == (6, 27) and np.ptp(observed, axis=0).min() > 0
            runs.append(np.array([ants.step(action)[0] for action in actions]))
    assert all(np.array_equal(runs[0], run) for run in runs)
    ants.robots[2].body("torso").position = (0, 0, 5)
    observed, _, terminated, truncated, info = ants.step(actions[0])
    assert terminated.tolist() == [False, False, True, False, False, False] and not truncated.any()
    assert 0.5 < observed[2, 0] < 0.9 and info["final_obs"][0, 0] > 1 and ants.steps.tolist() == [21, 21, 0, 21, 21, 21]


def test_ilqr():
    """The pole hung, and stands; no force was beyond what the motor has, and playing the controls again gives the same states."""
    module = recipe("ilqr")
    states, controls = module.main()
    assert np.cos(states[0, 1]) == -1 and abs(states[-1, 1]) < 0.02 and np.abs(states[-1]).max() < 0.1
    assert np.abs(controls).max() <= 10
    alone = epode.Batch(epode.robot.from_text(module.CART_POLE), 1, dtype="float64", stepsize=module.H)
    alone.write("qpos", states[0, :2])
    qpos, qvel = alone.rollout(controls[None, :, None])
    assert np.array_equal(np.hstack([qpos[0], qvel[0]]), states[1:])


def test_mpc():
    """Both targets are reached and held, on any threads the same."""
    distance = recipe("mpc").main()
    half = len(distance) // 2
    assert distance[0] > 0.3 and distance[half] > 0.5
    assert distance[half - 20:half].max() < 0.03 and distance[-20:].max() < 0.03


def test_identify():
    module = recipe("identify")
    assert module.main().max() < 0.01                # a thousandth of a radian of noise
    assert module.main(noise=0).max() < 1e-8


def test_gait():
    """It learns to run: twice as far as the best of the first, and as a second seed does."""
    pytest.importorskip("gymnasium")
    for seed in (0, 1):
        best = recipe("gait").main(seed=seed)
        assert best[0] < 6 and best[-1] > max(9, 2 * best[0])


def test_ppo():
    """It learns to keep a pole upright for ten times as long as at first, and to its limit in most episodes, within 30 s of a quiet machine."""
    pytest.importorskip("mujoco"), pytest.importorskip("imageio")
    module = recipe("ppo")
    learner, curve = module.main(copies=32, seconds=300, enough=800, shown=False, infos=False)
    assert curve[0].value < 30 and curve[-1].value >= 800 and learner.steps < 400_000
    env = module.gymnasium.make_vec("Epode/InvertedPendulum-v0", num_envs=64)
    observations, _ = env.reset(seed=99)
    alive = np.ones(64, bool)
    for _ in range(900):                              # without noise, from starts that it has not seen
        observations, _, terminated, *_ = env.step(learner.act(observations))
        alive &= ~terminated
    assert alive.mean() > 0.9
    recording = module.film(learner, seconds=1.0)
    cart = recording.trajectory(0)
    assert len(recording) == 26 and recording.times[-1] == pytest.approx(1.0) and 0 < np.ptp(cart[:, 0]) < 1


@pytest.mark.skipif("EPODE_LEARN_STEPS" not in os.environ, reason="EPODE_LEARN_STEPS: minutes, scripts/nightly's")
def test_ppo_teaches_the_quadruped_to_follow_commands():
    """After a million steps it is, without noise, off by less than a third of what it is asked for, turns as it is asked to, and rarely falls."""
    pytest.importorskip("gymnasium")
    module = recipe("ppo")
    env = module.gymnasium.make_vec("Epode/Quadruped-v0", num_envs=256, infos=False)
    learner = module.Learner(env, 1, module.SETTINGS["Epode/Quadruped-v0"])
    learner.learn(steps=int(os.environ["EPODE_LEARN_STEPS"]))
    env = module.gymnasium.make_vec("Epode/Quadruped-v0", num_envs=64)
    observations, _ = env.reset(seed=99)
    asked, off, turning, falls = [], [], [], 0
    for _ in range(500):
        asked.append(observations[:, 9:12].copy())
        observations, _, fallen, _, infos = env.step(learner.act(observations))
        off.append(infos["tracking_error"]), turning.append(abs(observations[:, 5] - asked[-1][:, 2]))
        falls += int(fallen.sum())
    print(f"off by {np.mean(off):.3f} m/s and {np.mean(turning):.3f} rad/s, {falls} falls")
    assert np.mean(off) < np.linalg.norm(np.array(asked)[..., :2], axis=-1).mean() / 3 and np.mean(turning) < 0.35 and falls < 32


def test_gradients_of_ppo_are_those_of_its_objective():
    pytest.importorskip("gymnasium")
    module = recipe("ppo")
    rng = np.random.default_rng(2)
    network = module.Network([5, 8, 8, 3], 1.0, rng)
    network.weights = [w.astype(float) + 0.1 * rng.normal(size=w.shape) for w in network.weights]
    inputs, slope = rng.normal(size=(16, 5)), rng.normal(size=(16, 3))
    gradients = network.backward(network.forward(inputs), slope)
    for weight, gradient in zip(network.weights, gradients, strict=True):
        place = tuple(0 for _ in weight.shape)
        kept, outs = weight[place], []
        for change in (1e-6, -1e-6):
            weight[place] = kept + change
            outs.append((network.forward(inputs)[-1] * slope).sum())
        weight[place] = kept
        assert gradient[place] == pytest.approx((outs[0] - outs[1]) / 2e-6, rel=1e-6)


def test_every_recipe_is_tested_and_on_the_page():
    page = (RECIPES.parent.parent / "docs" / "python" / "recipes.md").read_text()
    for path in RECIPES.glob("*.py"):
        assert f"test_{path.stem}" in globals() and f"({'../' * 2}python/recipes/{path.name})" in page
