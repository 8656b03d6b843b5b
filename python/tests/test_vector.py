# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Vectors of environments: Gymnasium's formulas on the same states, its autoreset modes step for step, randomness, refusals."""
import subprocess
import sys

import numpy as np
import pytest

import epode

gymnasium = pytest.importorskip("gymnasium")
from gymnasium.utils.env_checker import check_env  # noqa: E402
from gymnasium.vector import AutoresetMode, SyncVectorEnv  # noqa: E402

NAMES = ["Ant", "HalfCheetah", "Humanoid", "Hopper", "Walker2d", "Swimmer", "Reacher", "Pusher", "InvertedPendulum",
         "InvertedDoublePendulum", "CartPole"]
SEEN = ("qpos", "qvel", "xpos", "cinert", "cvel", "qfrc_actuator", "cfrc_ext", "com", "qfrc_constraint", "xquat")


def vector(name, count=5, **options):
    return epode.vector.make(name, count, **{"dtype": "float64", "threads": 1, **options})


def actions_of(env, rng):
    if env.task.choices:
        return rng.integers(0, 2, env.num_envs)
    low, high = env.single_action_space.low, env.single_action_space.high
    return rng.uniform(low, high, env.action_space.shape).astype(np.float32)


def state(env):
    return {name: env.batch.read(name) for name in SEEN}


# ---- Gymnasium's formulas, written again from its version 5, of one copy ----

def ant(was, s, action, dt):
    touch = np.clip(s["cfrc_ext"], -1, 1)
    healthy = 0.2 <= s["qpos"][2] <= 1.0
    reward = (s["xpos"][3] - was["xpos"][3]) / dt + healthy - 0.5 * np.sum(action**2) - 5e-4 * np.sum(touch**2)
    return np.concatenate([s["qpos"][2:], s["qvel"], touch[6:]]), reward, not healthy


def half_cheetah(was, s, action, dt):
    return np.concatenate([s["qpos"][1:], s["qvel"]]), (s["qpos"][0] - was["qpos"][0]) / dt - 0.1 * np.sum(action**2), False


def humanoid(was, s, action, dt):
    healthy = 1.0 < s["qpos"][2] < 2.0
    contact = min(5e-7 * np.sum(s["cfrc_ext"]**2), 10.0)
    reward = 1.25 * (s["com"][0] - was["com"][0]) / dt + 5 * healthy - 0.1 * np.sum(action**2) - contact
    parts = [s["qpos"][2:], s["qvel"], s["cinert"][10:], s["cvel"][6:], s["qfrc_actuator"][6:], s["cfrc_ext"][6:]]
    return np.concatenate(parts), reward, not healthy


def planar(was, s, action, dt, healthy):
    reward = (s["qpos"][0] - was["qpos"][0]) / dt + healthy - 1e-3 * np.sum(action**2)
    return np.concatenate([s["qpos"][1:], np.clip(s["qvel"], -10, 10)]), reward, not healthy


def hopper(was, s, action, dt):
    rest = np.concatenate([s["qpos"], s["qvel"]])[2:]
    return planar(was, s, action, dt, s["qpos"][1] > 0.7 and abs(s["qpos"][2]) < 0.2 and (abs(rest) < 100).all())


def walker2d(was, s, action, dt):
    return planar(was, s, action, dt, 0.8 < s["qpos"][1] < 2.0 and abs(s["qpos"][2]) < 1.0)


def swimmer(was, s, action, dt):
    return np.concatenate([s["qpos"][2:], s["qvel"]]), (s["qpos"][0] - was["qpos"][0]) / dt - 1e-4 * np.sum(action**2), False


def reacher(was, s, action, dt):
    apart = s["xpos"].reshape(-1, 3)[3] - s["xpos"].reshape(-1, 3)[4]
    observation = np.concatenate([np.cos(s["qpos"][:2]), np.sin(s["qpos"][:2]), s["qpos"][2:], s["qvel"][:2], apart[:2]])
    return observation, -np.linalg.norm(apart) - np.sum(action**2), False


def pusher(was, s, action, dt):
    tip, object_, goal = s["xpos"].reshape(-1, 3)[-3:]
    reward = -np.linalg.norm(object_ - goal) - 0.5 * np.linalg.norm(object_ - tip) - 0.1 * np.sum(action**2)
    return np.concatenate([s["qpos"][:7], s["qvel"][:7], tip, object_, goal]), reward, False


def inverted_pendulum(was, s, action, dt):
    fallen = abs(s["qpos"][1]) > 0.2
    return np.concatenate([s["qpos"], s["qvel"]]), float(not fallen), fallen


def inverted_double_pendulum(was, s, action, dt):
    first, second = s["qpos"][1], s["qpos"][1] + s["qpos"][2]
    x, z = s["qpos"][0] + 0.6 * (np.sin(first) + np.sin(second)), 0.6 * (np.cos(first) + np.cos(second))
    fallen = z <= 1
    reward = 10.0 * (not fallen) - 0.01 * x**2 - (z - 2) ** 2 - 1e-3 * s["qvel"][1] ** 2 - 5e-3 * s["qvel"][2] ** 2
    observation = [s["qpos"][:1], np.sin(s["qpos"][1:]), np.cos(s["qpos"][1:]), np.clip(s["qvel"], -10, 10),
                   np.clip(s["qfrc_constraint"][:1], -10, 10)]
    return np.concatenate(observation), reward, fallen


def cart_pole(was, s, action, dt):
    fallen = abs(s["qpos"][0]) > 2.4 or abs(s["qpos"][1]) > 12 * 2 * np.pi / 360
    return np.array([s["qpos"][0], s["qvel"][0], s["qpos"][1], s["qvel"][1]]), 1.0, fallen


FORMULAS = [ant, half_cheetah, humanoid, hopper, walker2d, swimmer, reacher, pusher, inverted_pendulum, inverted_double_pendulum, cart_pole]


@pytest.mark.parametrize(("name", "formula"), list(zip(NAMES, FORMULAS, strict=True)))
def test_formulas_are_gymnasiums(name, formula):
    env = vector(name, autoreset_mode="Disabled", max_episode_steps=40)
    rng, steps, ends = np.random.default_rng(4), 0, 0
    observations, _ = env.reset(seed=3)
    dt = env.batch.stepsize * env.task.frame_skip
    while steps < 120:
        was, actions = state(env), actions_of(env, rng)
        observations, rewards, terminated, truncated, _ = env.step(actions)
        now, steps = state(env), steps + 1
        for i in range(env.num_envs):
            seen, reward, ended = formula(*({key: all_[key][i] for key in SEEN} for all_ in (was, now)),
                                          np.asarray(actions[i], float), dt)
            assert abs(seen - observations[i]).max() <= 1e-12 * (1 + abs(seen).max())
            assert abs(reward - rewards[i]) <= 1e-12 * (1 + abs(reward))
            assert bool(ended) == terminated[i]
        done = terminated | truncated
        ends += done.sum()
        if done.any():
            env.reset(options={"reset_mask": done})
    assert ends >= 10


@pytest.mark.parametrize("name", NAMES[:-1])
def test_spaces_and_first_observations_are_gymnasiums(name):
    pytest.importorskip("mujoco"), pytest.importorskip("imageio")
    env, theirs = vector(name, 4), gymnasium.make(f"{name}-v5").unwrapped
    assert env.single_observation_space.shape == theirs.observation_space.shape and env.single_action_space == theirs.action_space
    assert env.metadata["render_fps"] == theirs.metadata["render_fps"]
    observations, _ = env.reset(seed=5)
    for i in range(4):
        theirs.set_state(env.batch.read("qpos")[i], env.batch.read("qvel")[i])
        assert abs(theirs._get_obs() - observations[i]).max() < 1e-9


def equal(ours, theirs):
    assert set(ours) == set(theirs)
    for key, value in theirs.items():
        if isinstance(value, dict):
            equal(ours[key], value)
        elif value.dtype == object:
            assert all((a is None) == (b is None) and (a is None or (a == b).all()) for a, b in zip(ours[key], value, strict=True))
        else:
            assert (ours[key] == value).all(), key


@pytest.mark.parametrize("mode", list(AutoresetMode))
@pytest.mark.parametrize("name", ["Ant", "Hopper", "InvertedPendulum", "CartPole"])
def test_autoreset_is_the_references_step_for_step(mode, name):
    count = 6
    options = {"dtype": "float64", "max_episode_steps": 13}
    env = vector(name, count, autoreset_mode=mode, **options)
    reference = SyncVectorEnv([lambda i=i: epode.vector.Scalar(name, copy=i, **options) for i in range(count)], autoreset_mode=mode)
    rng = np.random.default_rng(5)
    for ours, theirs in zip(env.reset(seed=11), reference.reset(seed=[11] * count), strict=True):
        (equal if isinstance(theirs, dict) else np.testing.assert_array_equal)(ours, theirs)
    ends = 0
    for _ in range(60):
        actions = actions_of(env, rng)
        *ours, our_infos = env.step(actions)
        *theirs, their_infos = reference.step(actions)
        for one, other in zip(ours, theirs, strict=True):
            np.testing.assert_array_equal(one, other)
        equal(our_infos, their_infos)
        done = ours[2] | ours[3]
        ends += done.sum()
        if mode == AutoresetMode.DISABLED and done.any():
            one, _ = env.reset(options={"reset_mask": done})
            other, _ = reference.reset(options={"reset_mask": done})
            np.testing.assert_array_equal(one, other)
    assert ends >= 12


def test_gymnasium_makes_and_checks_them():
    env = gymnasium.make_vec("Epode/Ant-v0", num_envs=3, threads=1)
    assert isinstance(env, epode.vector.VectorEnvironment) and env.spec.id == "Epode/Ant-v0"
    observations, infos = env.reset(seed=1)
    assert env.observation_space.contains(observations) and observations.dtype == np.float32 and "x_position" in infos
    for name in ("Ant", "CartPole"):
        check_env(gymnasium.make(f"Epode/{name}-v0").unwrapped, skip_render_check=True)
    scalar = gymnasium.make("Epode/Hopper-v0", max_episode_steps=7)
    scalar.reset(seed=2)
    ends = [scalar.step(scalar.action_space.sample() * 0)[3] for _ in range(7)]
    assert ends == [False] * 6 + [True]


def test_gymnasium_imports_them_by_name():
    code = "import gymnasium; print(gymnasium.make_vec('epode.vector:Epode/CartPole-v0', num_envs=2).reset(seed=1)[0].shape)"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "(2, 4)\n"


def run(env, steps=60, seed=9):
    rng, out = np.random.default_rng(1), [env.reset(seed=seed)[0]]
    actions = [rng.uniform(-1, 1, (64, env.single_action_space.shape[0])) for _ in range(steps)]
    for row in actions:
        observations, rewards, *_ = env.step(row[:env.num_envs])
        out += [observations, rewards[:, None]]
    return np.concatenate(out, 1)


@pytest.mark.parametrize("dtype", ["float32", "float64"])
def test_a_copy_depends_neither_on_how_many_there_are_nor_on_threads(dtype):
    options = {"dtype": dtype, "max_episode_steps": 20, "randomise": {"friction": ("uniform", 0.4, 1.2)}, "observation_noise": 0.01}
    all_of_them = run(vector("Ant", 23, threads=2, **options))
    assert (all_of_them == run(vector("Ant", 23, **options))).all()
    assert (all_of_them[:7] == run(vector("Ant", 7, **options))).all()
    assert (all_of_them[20:21] != run(vector("Ant", 1, first=21, **options))).any()
    assert len(np.unique(all_of_them[:, 3])) == 23
    assert (run(vector("Ant", 2, **options)) != run(vector("Ant", 2, **options), seed=10)).any()


def test_episodes_draw_the_numbers_of_the_model():
    env = vector("Ant", 400, max_episode_steps=1, autoreset_mode="SameStep",
                 randomise={"friction": ("uniform", 0.4, 1.2), "mass": ("normal", 1.0, 0.1, "scale", "each"), "gain": ("uniform", 0.9, 1.1, "scale")})
    env.reset(seed=1)
    friction, mass, gain = (env.batch.get(name) for name in ("friction", "mass", "gain"))
    model = epode.vector.make("Ant", 1).batch
    assert (friction == friction[:, :1]).all() and friction.min() >= 0.4 and friction.max() < 1.2 and abs(friction.mean() - 0.8) < 0.04
    factors = mass[:, 1:] / model.get("mass")[0, 1:].astype(float)
    assert abs(factors.mean() - 1) < 0.01 and abs(factors.std() - 0.1) < 0.01 and abs(np.corrcoef(factors[:, 0], factors[:, 1])[0, 1]) < 0.2
    assert 0.9 <= (gain / model.get("gain")[0]).min() and len(np.unique(gain[:, 0])) == 400
    env.step(np.zeros((400, 8)))
    assert (env.batch.get("friction") != friction).all()
    for wrong in ({"speed": ("uniform", 0, 1)}, {"mass": ("log", 0, 1)}, {"mass": ("uniform", 0, np.inf)}, {"mass": ("uniform", 0, 1, "often")}):
        with pytest.raises(ValueError, match="randomise"):
            vector("Ant", 1, randomise=wrong)


def test_episodes_of_a_seed_come_again_bit_by_bit():
    env = vector("Ant", 3, max_episode_steps=5, randomise={"mass": ("uniform", 0.5, 2.0, "scale")})
    first, _, again = run(env), run(env, seed=10), run(env)
    assert (first == again).all()


def test_arrays_that_are_bound_to_the_batch_follow():
    env, plain = vector("Hopper", 3), vector("Hopper", 3)
    env.reset(seed=1), plain.reset(seed=1)
    qpos, ctrl = env.batch.bind("qpos"), env.batch.bind("ctrl")
    for actions in (np.ones((3, 3)), -np.ones((3, 3))):
        assert (env.step(actions)[0] == plain.step(actions)[0]).all()
        assert (ctrl == actions).all() and (qpos == env.batch.read("qpos")).all()
    qpos[0, 1] = 0.1
    assert env.step(actions)[2].tolist() == [True, False, False]


def test_starts_and_noise_are_distributed_as_said():
    env = vector("Ant", 4000)
    env.reset(seed=6)
    velocities, heights = env.batch.read("qvel") / 0.1, (env.batch.read("qpos")[:, 2] - 0.75) / 0.1
    assert abs(velocities.mean(0)).max() < 0.06 and abs(velocities.std(0) - 1).max() < 0.05 and abs((velocities**4).mean() - 3) < 0.15
    assert heights.min() >= -1 and heights.max() <= 1 and abs(heights.std() - 1 / np.sqrt(3)) < 0.02
    quiet, noisy = (vector("HalfCheetah", 500, observation_noise=noise).reset(seed=2)[0] for noise in (0.0, 0.05))
    assert abs((noisy - quiet).std() - 0.05) < 0.002
    targets = (lambda env: env.reset(seed=1) and env.batch.read("qpos")[:, 2:])(vector("Reacher", 2000))
    assert np.linalg.norm(targets, axis=1).max() < 0.2 and abs((np.linalg.norm(targets, axis=1) ** 2).mean() - 0.02) < 0.001


def test_what_is_wrong_raises_and_changes_nothing(tmp_path):
    env = vector("Ant", 4)
    good = np.zeros((4, 8), np.float32)
    with pytest.raises(RuntimeError):
        env.step(good)
    with pytest.raises(ValueError, match="first reset"):
        env.reset(options={"reset_mask": np.ones(4, bool)})
    env.reset(seed=1)
    before = state(env)
    bad = good.copy()
    bad[3, 7] = np.nan
    for wrong in (bad, good[:3], good[:, :7], np.full((4, 8), np.inf), good.astype(str), np.zeros(32)):
        with pytest.raises(ValueError, match="action"):
            env.step(wrong)
    for mask in (np.zeros(4, bool), np.ones(3, bool)):
        with pytest.raises(ValueError, match="reset_mask"):
            env.reset(options={"reset_mask": mask})
    with pytest.raises(TypeError):
        env.reset(options={"reset_mask": [True] * 4})
    with pytest.raises(ValueError, match="seed"):
        env.reset(seed=-1)
    assert all((now == before[name]).all() for name, now in state(env).items())
    poles = vector("CartPole", 2)
    poles.reset(seed=1)
    for wrong in (np.array([0, 2]), np.array([-1, 0]), np.array([0.0, 1.0])):
        with pytest.raises(ValueError, match="action"):
            poles.step(wrong)
    ended = vector("Ant", 2, autoreset_mode="Disabled", max_episode_steps=1)
    ended.reset(seed=1)
    ended.step(good[:2])
    with pytest.raises(ValueError, match="reset_mask"):
        ended.step(good[:2])
    for wrong in ({"frame_skip": 0}, {"observation_noise": -1}, {"observation_noise": [1, 2]}, {"render_mode": "human"}, {"autoreset_mode": "Now"}):
        with pytest.raises(ValueError):
            vector("Ant", 1, **wrong)
    with pytest.raises(TypeError):
        vector("Ant", 1, speed=3)
    with pytest.raises(ValueError, match="HalfCheetah"):
        vector("Cat")
    file = tmp_path / "rope.xml"
    file.write_text("""<mujoco><option timestep="0.01"/><worldbody><site name="s"/><body name="a" pos="0 0 1"><joint/><geom size=".1"/><site name="t"/></body>
</worldbody><tendon><spatial name="rope" stiffness="1"><site site="s"/><site site="t"/></spatial></tendon></mujoco>""")
    with pytest.raises(epode.RefusedError, match="rope"):
        vector("Swimmer", xml_file=str(file))


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_a_copy_that_goes_bad_ends_its_episode(mode):
    env = vector("HalfCheetah", 3, autoreset_mode=mode)
    env.reset(seed=1)
    speeds = env.batch.read("qvel")
    speeds[1] = 1e59
    env.batch.write("qvel", speeds)
    observations, rewards, terminated, _, infos = env.step(np.ones((3, 6)))
    assert terminated.tolist() == [False, True, False] and infos["bad"].tolist() == [False, True, False]
    observations, rewards, terminated, _, infos = env.step(np.ones((3, 6)))
    assert "bad" not in infos and not terminated.any() and env.batch.bad == 0
    assert np.isfinite(observations).all() and np.isfinite(rewards).all() and (abs(observations[1]) < 100).all()


def test_arrays_are_copies_or_the_environments_own():
    env, own = vector("Hopper", 2), vector("Hopper", 2, copy=False, infos=False)
    one, _ = env.reset(seed=1)
    kept = one.copy()
    two, _ = own.reset(seed=1)
    env.step(np.ones((2, 3)))
    *_, infos = own.step(np.ones((2, 3)))
    assert (one == kept).all() and (two != kept).any() and not infos
