# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Others' learners train on our environments. They need torch, 3 GB from PyPI: scripts/nightly's part learners has it."""
import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before torch: its threads wait for each other where others work, too

import numpy as np  # noqa: E402
import pytest  # noqa: E402

gymnasium = pytest.importorskip("gymnasium")
pytest.importorskip("torch")

import epode.vector  # noqa: E402


def mean_of(returns, first):
    """The last returns, of which the first say how it began."""
    assert np.mean(first) < 40  # an untaught policy falls after 20 steps
    return np.mean(returns)


def test_rllib_trains_on_the_vector_natively():
    """As docs/guide/learning.md says; RLlib's runner makes one vector of 16 copies, not 16 environments."""
    ray = pytest.importorskip("ray")
    ppo, tune = pytest.importorskip("ray.rllib.algorithms.ppo"), pytest.importorskip("ray.tune")
    ray.init("local", num_cpus=1, include_dashboard=False, log_to_driver=False, logging_level="error")
    try:
        tune.register_env("epode", lambda config: epode.vector.make("CartPole", config["num_envs"]))
        config = ppo.PPOConfig().environment("epode", observation_space=gymnasium.make("Epode/CartPole-v0").observation_space,
                                             action_space=gymnasium.make("Epode/CartPole-v0").action_space)
        config = config.env_runners(num_env_runners=0, num_envs_per_env_runner=16, gym_env_vectorize_mode="vector_entry_point")
        learner = config.training(train_batch_size_per_learner=2000, minibatch_size=250, num_epochs=8, lr=1e-3).debugging(seed=1).build_algo()
        returns = [learner.train()["env_runners"]["episode_return_mean"] for _ in range(8)]
        print(returns)
        assert mean_of(returns[-1:], returns[:1]) > 100
    finally:
        ray.shutdown()


def test_stable_baselines_trains():
    baselines = pytest.importorskip("stable_baselines3")
    from stable_baselines3.common.evaluation import evaluate_policy
    from stable_baselines3.common.monitor import Monitor
    model = baselines.PPO("MlpPolicy", gymnasium.make("Epode/CartPole-v0"), seed=1, n_steps=512, device="cpu")
    judged = Monitor(gymnasium.make("Epode/CartPole-v0"))
    before = evaluate_policy(model, judged, 5)[0]
    model.learn(10_000)
    after = evaluate_policy(model, judged, 5)[0]
    print(before, after)
    assert mean_of([after], [before]) > 100
