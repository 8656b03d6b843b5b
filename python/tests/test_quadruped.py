# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The robot that follows commands, on flat ground and on landscapes: formulas, commands, curriculum, terrain."""
import hashlib

import numpy as np
import pytest

import epode

gymnasium = pytest.importorskip("gymnasium")
import epode.vector  # noqa: E402
from epode.vector.quadruped import STAND  # noqa: E402
from epode.vector.terrain import KINDS, Landscape  # noqa: E402

SEEN = ("qpos", "qvel", "xquat", "qfrc_actuator")


def vector(name, count=5, **options):
    return epode.vector.make(name, count, **{"dtype": "float64", "threads": 1, **options})


def turn(q):
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def test_observations_and_rewards_are_what_the_task_says():
    env = vector("Quadruped", autoreset_mode="Disabled")
    rng = np.random.default_rng(2)
    env.reset(seed=3)
    last = np.zeros((5, 12))
    for _ in range(60):
        actions = rng.uniform(-1, 1, (5, 12))
        observations, rewards, terminated, _, infos = env.step(actions)
        s = {name: env.batch.read(name) for name in SEEN}
        for i in range(5):
            r = turn(s["qpos"][i, 3:7])
            local, spin, down = r.T @ s["qvel"][i, :3], s["qvel"][i, 3:6], r.T @ np.array([0, 0, -1])
            command = observations[i, 9:12]
            expected = np.concatenate([local, spin, down, command, s["qpos"][i, 7:], 0.1 * s["qvel"][i, 6:], actions[i]])
            assert abs(expected - observations[i]).max() < 1e-12 * (1 + abs(expected).max())
            upright = r[2, 2]
            reward = (-0.5 * np.linalg.norm(local[:2] - command[:2]) + np.exp(-np.sum((local[:2] - command[:2])**2) / 0.25) + 0.5 * np.exp(-(spin[2] - command[2])**2 / 0.25)
                      + 0.1 * (upright >= 0.5) - 0.5 * s["qvel"][i, 2]**2 - 0.01 * np.sum(spin[:2]**2) - 0.5 * np.sum(down[:2]**2)
                      - 2e-5 * np.sum(s["qfrc_actuator"][i, 6:]**2) - 0.002 * np.sum((actions[i] - last[i])**2))
            assert abs(reward - rewards[i]) < 1e-12 * (1 + abs(reward))
            assert terminated[i] == (upright < 0.5)
            assert abs(infos["tracking_error"][i] - np.linalg.norm(local[:2] - command[:2])) < 1e-12
        last = actions
        if terminated.any():
            env.reset(options={"reset_mask": terminated})
            last[terminated] = 0


def test_commands_change_and_follow_the_seed():
    env = vector("Quadruped", 300, command_steps=4, max_episode_steps=0)
    given = [env.reset(seed=5)[0][:, 9:12]]
    for _ in range(8):
        given.append(env.step(np.zeros((300, 12)))[0][:, 9:12])
    assert all((given[k] == given[0]).all() for k in range(4)) and (given[4] == given[7]).all()
    assert (given[4] != given[0]).any(axis=1).mean() > 0.8 and (given[8] != given[4]).any(axis=1).mean() > 0.8
    standing = (given[0] == 0).all(axis=1).mean()
    assert 0.04 < standing < 0.18
    walking = given[0][(given[0] != 0).any(axis=1)]
    assert (abs(walking) <= [1, 0.5, 1]).all() and abs(walking.mean(0)).max() < 0.1 and (walking.std(0) > [0.5, 0.25, 0.5]).all()
    assert (vector("Quadruped", 3).reset(seed=5)[0] == env.reset(seed=5)[0][:3]).all()


def test_it_stands_and_slow_commands_are_nearly_kept_by_standing():
    env = vector("Quadruped", 20, forward_range=(0, 0), sideways_range=(0, 0), turn_range=(0, 0), dtype="float32", max_episode_steps=0)
    env.reset(seed=1)
    for _ in range(750):
        _, rewards, terminated, _, infos = env.step(np.zeros((20, 12)))
        assert not terminated.any()
    assert (rewards > 1.5).all() and infos["tracking_error"].max() < 1e-6


def test_rows_rise_with_who_walks_far_and_fall_with_who_does_not():
    env = vector("RoughQuadruped", 60, autoreset_mode="Disabled")
    _, infos = env.reset(seed=2)
    rows, terrain = infos["row"].copy(), env.batch.get("terrain")
    assert set(rows) == {0, 1} and (terrain[:, 0] == -8 * rows).all() and set(terrain[:, 1]) == {0, -8, -16, -24, -32}
    qpos = env.batch.read("qpos")
    qpos[:20, 0], qpos[20:40, 1] = 5, -3
    env.batch.write("qpos", qpos)
    env.step(np.zeros((60, 12)))
    _, infos = env.reset(options={"reset_mask": np.ones(60, bool)})
    assert (infos["row"][:20] == rows[:20] + 1).all() and (infos["row"][20:40] == rows[20:40]).all() and (infos["row"][40:] == 0).all()
    for _ in range(50):
        _, _, terminated, _, _ = env.step(np.zeros((60, 12)))
        assert not terminated.any()
    assert env.batch.bad == 0 and abs(env.batch.read("qpos")[:, 2] - 0.25).max() < 0.05  # on the fields' flat centres
    with pytest.raises(ValueError, match="curriculum"):
        vector("Quadruped", 1, curriculum=epode.vector.Curriculum(3, 0))


def test_landscapes_are_flat_where_episodes_begin_and_the_same_everywhere():
    land = Landscape(rows=3, seed=4)
    heights, n = land.heights(), land.cells
    assert heights.shape == (7 * n + 1, 5 * n + 1)
    for column in range(len(KINDS)):
        roughness = []
        for row in range(3):
            y, x = (column + 1) * n + n // 2, (row + 1) * n + n // 2
            assert (heights[y - 3:y + 4, x - 3:x + 4] == 0).all()
            roughness.append(np.abs(heights[y - n // 2:y + n // 2, x - n // 2:x + n // 2]).max())
        assert roughness[0] < roughness[1] < roughness[2] < 1.6
    assert (heights[0] == 0).all() and (heights[:, 0] == 0).all()
    numbers = np.round(heights, 6).tobytes()
    assert hashlib.sha256(numbers).hexdigest()[:16] == "c1c1dedd01b95d7f"
    for wrong in ({"kinds": ("lava",)}, {"kinds": ()}, {"rows": 0}, {"cell": 3}):
        with pytest.raises(ValueError):
            Landscape(**wrong)


def test_a_world_of_a_copy_has_it_on_its_field():
    env = vector("RoughQuadruped", 12)
    env.reset(seed=1)
    terrain = env.batch.get("terrain")
    i = int(np.flatnonzero((terrain[:, 0] < 0) & (terrain[:, 1] < 0))[0])
    world = env.batch.world(i)
    trunk = max(world.bodies, key=lambda body: body.mass)
    assert np.allclose(trunk.position[:2], env.batch.read("qpos")[i, :2] - terrain[i, :2])


# ---- the ground around it ----

def scanned(env, scan, copy):
    """Where the places of a scan are, in the world of its copy's ground, from its pose."""
    qpos, r = env.batch.read("qpos")[copy], turn(env.batch.read("qpos")[copy, 3:7])
    ahead = r[:2, 0] / np.linalg.norm(r[:2, 0])
    places = np.array(scan.places)
    return qpos[:2] + places @ np.array([ahead, [-ahead[1], ahead[0]]]), qpos[2]


def thrown(env, seed):
    """After a step from poses of all kinds."""
    rng, n = np.random.default_rng(seed), env.num_envs
    env.reset(seed=seed)
    qpos = env.batch.read("qpos")
    qpos[:, :3] = rng.uniform([-3, -3, 1], [3, 3, 2], (n, 3))
    qpos[:, 3:7] = rng.normal(size=(n, 4))
    env.batch.write("qpos", qpos)
    return env.step(np.zeros((n, 12)))[0]


@pytest.mark.parametrize("normal", [(0, 0, 1), (0.3, -0.1, 1), (0, 0.5, 1)])
def test_scans_of_a_plane_are_linear_in_the_robots_heading(normal):
    scan = epode.vector.HeightScan(1.2, 0.8, 0.2, limit=50)
    nx, ny, nz = np.array(normal) / np.linalg.norm(normal)
    text = epode.vector.quadruped.model_text(ground=f'<geom name="ground" type="plane" size="50 50 1" pos="0.5 0 0.1" zaxis="{nx} {ny} {nz}"/>')
    env = vector("Quadruped", 40, xml_file=text, height_scan=scan, autoreset_mode="Disabled")
    assert scan.shape == (5, 7) and env.single_observation_space.shape == (48 + 35,)
    heights = thrown(env, 4)[:, 48:]
    for i in range(40):
        places, base = scanned(env, scan, i)
        ground = 0.1 - (nx * (places[:, 0] - 0.5) + ny * places[:, 1]) / nz
        assert abs(heights[i] - (base - ground - STAND)).max() < 1e-12


def test_scans_are_what_rays_see_and_nothing_of_the_robot():
    scan = epode.vector.HeightScan(limit=50)
    env = vector("RoughQuadruped", 60, height_scan=scan, autoreset_mode="Disabled", threads=2)
    env.reset(seed=2)
    heights = thrown(env, 3)[:, -len(scan.places):]
    origins = np.column_stack([scan.places, np.full(len(scan.places), 5.0)])
    shapes = np.empty((60, len(origins)), np.int32)
    ranges = env.batch.rays("trunk", np.tile([0.0, 0, -1], (len(origins), 1)), origins=origins, axes="upright", shapes=shapes)
    on_ground = shapes == 0
    assert 0.7 < on_ground.mean() < 1 and len(set(env.batch.get("terrain")[:, 1])) == 5
    assert abs(heights - (ranges - 5 - STAND))[on_ground].max() < 1e-9


def test_scans_end_where_the_ground_does_and_within_their_limit():
    scan = epode.vector.HeightScan(0, 0, limit=0.25)
    env = vector("RoughQuadruped", 3, height_scan=scan, autoreset_mode="Disabled")
    env.reset(seed=1)
    qpos = env.batch.read("qpos")
    qpos[:, :3] = [[0, 0, 0.3], [0, 0, 4], [1000, 0, 0.3]]
    env.batch.write("qpos", qpos)
    heights = env.step(np.zeros((3, 12)))[0][:, -1]
    assert abs(heights[0] - (env.batch.read("qpos")[0, 2] - STAND)) < 1e-12 and (heights[1:] == 0.25).all()


def test_scans_that_cannot_be_are_refused():
    model_text, scan = epode.vector.quadruped.model_text, epode.vector.HeightScan()
    for ground, reason in (('<geom name="stone" type="box" size="1 1 0.1"/>', "'stone' is another shape"),
                           ('<geom name="wall" type="plane" size="1 1 1" zaxis="1 0 0"/>', "'wall' is another shape"),
                           ("", "no ground")):
        with pytest.raises(ValueError, match=reason):
            vector("Quadruped", 1, xml_file=model_text(ground=ground), height_scan=scan)
    with pytest.raises(TypeError, match="HeightScan is expected"):
        vector("Quadruped", 1, height_scan=True)
    for wrong in ({"spacing": 0}, {"length": -1}, {"width": float("nan")}, {"limit": 0}, {"spacing": float("inf")}):
        with pytest.raises(ValueError, match="height_scan"):
            epode.vector.HeightScan(**wrong)
