# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Ragdolls as a user of Python meets them."""
import math
import pickle

import numpy as np
import pytest

import epode

H = 1 / 60


@pytest.fixture
def world():
    with epode.World(defaults="game") as w:
        w.plane()
        yield w


def states(world):
    return world.bodies.get("position", "quaternion", "velocity", "angular_velocity")


def frictionless():
    bones = epode.human()
    for bone in bones:
        bone.friction = 0.0
    return bones


def largest_turn(pose, other):
    """The largest angle between the bones of two poses, of bone 0 apart."""
    cosines = np.abs((pose * other).sum(axis=1))[1:]
    return float(2 * np.arccos(np.clip(cosines, 0, 1)).max())


def test_a_human_has_names_a_mass_and_a_height():
    bones = epode.human(1.8, 75)
    assert sum(bone.mass for bone in bones) == pytest.approx(75) and len(bones) == 16
    assert [bone.name for bone in bones][:7] == ["pelvis", "abdomen", "thorax", "head", "left upper arm", "left forearm", "left hand"]
    assert all(np.asarray(bone.position)[1] > 0 for bone in bones if bone.name.startswith("left"))
    assert all(np.asarray(bone.position)[1] < 0 for bone in bones if bone.name.startswith("right"))
    head = bones[3]
    assert np.asarray(head.position)[2] + head.shape.length / 2 + head.shape.radius == pytest.approx(1.8)
    assert bones[5].joint is epode.BoneJoint.HINGE and bones[bones[5].parent].name == "left upper arm"


def test_a_figure_is_bodies_geoms_and_joints_of_the_world(world):
    half = math.sqrt(0.5)
    figure = world.ragdoll(epode.human(), position=(1, 2, 3), quaternion=(half, half, 0, 0), material=epode.Material(friction=0.9))
    assert len(world.bodies) == 16 and len(world.geoms) == 17 and world.ragdolls == (figure,)
    assert [joint.type for joint in figure.joints[:3]] == ["ball", "amotor", "ball"] and set(figure.joints) == set(world.joints)
    assert figure["left forearm"] is figure[5] is world.bodies[5] and figure[5].geoms[0].shape == figure.bones[5].shape
    x, y, z = figure.bones[3].position[:3]
    assert figure["head"].position == pytest.approx([1 + x, 2 - z, 3 + y])  # z of the list points along -y
    assert figure.gap < 1e-12 and figure[3].geoms[0].material.friction == 0.9 and "16 bones" in repr(figure)


def test_motors_hold_a_human_upright_by_the_hip_and_a_limp_one_falls(world):
    """A hand at the hip holds nothing but the pelvis: the trunk above it stands by its motors."""
    held, limp = (world.ragdoll(epode.human(), position=(0, y, 0)) for y in (-1, 1))
    stand = held.pose
    assert held.hold() == 15
    for figure in (held, limp):
        figure["pelvis"].kinematic = True
    before = held["head"].position
    for figure in (held, limp):
        figure["thorax"].apply_impulse((10, 4, 0))
    world.step(H, steps=180)
    assert held["head"].position == pytest.approx(before, abs=0.02)
    assert largest_turn(held.pose, stand) < 0.05 and held.gap < 1e-3
    assert limp["head"].position[2] < before[2] - 0.3
    assert held.hold(strength=0) == 0
    held["thorax"].apply_impulse((10, 4, 0))
    world.step(H, steps=180)
    assert held["head"].position[2] < before[2] - 0.3


def test_a_pose_by_angles_is_reached_with_their_signs():
    world = epode.World(defaults="game", gravity=(0, 0, 0))
    figure = world.ragdoll(frictionless())
    figure[0].kinematic = True
    assert figure.pose_of() == pytest.approx(figure.pose, abs=1e-12)
    wanted = figure.pose_of({"thorax": (0.2, 0.1, 0.3), "head": (0.4, -0.3, 0.2), "left upper arm": (0.3, 0.8, 1.2), "left forearm": math.pi / 2,
                             "right upper arm": (0, -1.0, 0.4), "left hand": (0, 0.2, -0.6), "left thigh": (0.1, 0.4, 1.1), "left shank": 1.4,
                             "right foot": (0, 0.1, 0.2)})
    figure.hold(wanted)
    world.step(H, steps=240)
    assert largest_turn(figure.pose, wanted) < 3e-3
    elbow = world.ragdoll(frictionless(), position=(5, 0, 0))  # bent forward, the hand before the elbow
    elbow[0].kinematic = True
    elbow.hold(elbow.pose_of({"left forearm": math.pi / 2}))
    world.step(H, steps=240)
    assert elbow["left hand"].position[0] - elbow["left upper arm"].position[0] > 0.25


def test_an_arm_gives_way_at_its_strength():
    """m g r holds a forearm and a hand at a right angle."""
    for share in (0.9, 1.2):
        world = epode.World(defaults="game")
        bones = frictionless()
        fore, hand = bones[5], bones[6]
        levers = [np.asarray(fore.anchor)[2] - np.asarray(bone.position)[2] for bone in (fore, hand)]
        fore.stiffness, fore.damping = 1e5, 1e3
        fore.strength = share * 9.81 * (fore.mass * levers[0] + hand.mass * levers[1])
        hand.joint = epode.BoneJoint.FIXED
        figure = world.ragdoll(bones)
        for i, body in enumerate(figure.bodies):
            body.kinematic = i not in (5, 6)
        elbow = np.asarray(fore.anchor)[:3]
        for body, lever in zip(figure.bodies[5:7], levers):
            body.position = elbow + (lever, 0, 0)
            body.quaternion = (math.cos(math.pi / 4), 0, -math.sin(math.pi / 4), 0)
        figure.hold(figure.pose_of({"left forearm": math.pi / 2}))
        world.step(H, steps=30)
        fall = elbow[2] - figure["left forearm"].position[2]
        assert fall < 2e-3 if share > 1 else fall > 0.02


def test_it_follows_an_animation_and_then_falls(world):
    figure = world.ragdoll(frictionless())
    at, seconds = np.asarray(figure.bones[0].position)[:3], 1.0
    for i in range(1, round(seconds / H) + 1):
        t = i * H
        pose = figure.pose_of({"left upper arm": (0, 0, 0.5 * math.sin(4 * t)), "left thigh": (0, 0, 0.1 + 0.1 * math.sin(4 * t))})
        assert figure.follow(at + (t, 0, 1), pose, H) == 16
        world.step(H)
    assert figure[0].position == pytest.approx(at + (seconds, 0, 1), abs=2e-3) and largest_turn(figure.pose, pose) < 5e-3
    masses, heights, speeds = (np.array(values) for values in zip(*((b.mass, b.position[2], b.velocity[2]) for b in figure.bodies)))
    before, rise = masses @ heights / 75, masses @ speeds / 75
    assert figure.follow(at, figure.pose_of(), H, weight=0) == 0
    world.step(H, steps=24)
    after = masses @ [b.position[2] for b in figure.bodies] / 75
    assert before - after == pytest.approx(9.81 * 0.4**2 / 2 - rise * 0.4, abs=0.05)


def test_a_crowd_falls_asleep_with_closed_joints_and_the_same_bits_on_any_threads():
    seen = []
    for threads in (1, 2):
        world = epode.World(defaults="game", threads=threads)
        world.plane()
        for i in range(8):
            world.ragdoll(epode.human(), position=(0.35 * (i % 2), 0.3 * (i // 2), 0.5 + 0.2 * i), quaternion=(1, 0.1 * i, 0.2, 0))
        gap = 0.0
        for _ in range(300):
            world.step(H)
            gap = max(gap, *(figure.gap for figure in world.ragdolls))
        world.step(H, steps=600)
        assert gap < 0.05
        seen.append(states(world))
        assert np.abs(seen[-1][:, 2]).max() < 1.5 and world.bodies.enabled.mean() < 0.3
    assert np.array_equal(*seen)


def test_copies_go_on_with_the_same_bits(world):
    figure = world.ragdoll(epode.human(), position=(0, 0, 0.5))
    figure.hold(figure.pose_of({"left forearm": 1.2}), 0.5)
    world.step(H, steps=30)
    state, copies = world.save(), [world.clone(), pickle.loads(pickle.dumps(world))]
    pose = figure.pose_of({"right forearm": 1.0})
    for one in (world, *copies):
        twin, = one.ragdolls
        assert twin.world is one and twin["left hand"] is one.bodies[6] and len(twin.joints) == len(figure.joints)
        twin.hold(pose, 0.8)
        one.step(H, steps=60)
    for copy in copies:
        assert np.array_equal(states(copy), states(world)) and copy.ragdolls[0].gap == figure.gap
    after = states(world)
    world.load(state)
    figure.hold(pose, 0.8)
    world.step(H, steps=60)
    assert np.array_equal(states(world), after)


def test_figures_that_were_made_or_destroyed_are_taken_back(world):
    world.history = 30
    old = world.ragdoll(epode.human())
    world.step(H, steps=5)
    young = world.ragdoll(epode.human(), position=(2, 0, 0))
    where = old["head"].position
    world.step(H, steps=5)
    old.destroy()
    assert not old.alive and world.ragdolls == (young,) and len(world.bodies) == 16 and len(world.joints) == len(young.joints)
    with pytest.raises(epode.DeadHandleError, match="Ragdoll"):
        old.gap
    world.step(H)
    world.roll_back(6)
    assert old.alive and not young.alive and world.ragdolls == (old,) and np.array_equal(old["head"].position, where)
    old.hold()
    world.step(H, steps=20)
    assert old.gap < 1e-3


def test_mistakes_are_refused_by_name_and_change_nothing(world):
    bones = epode.human()
    with pytest.raises(KeyError, match="no bone is called 'nose': pelvis"):
        world.ragdoll(bones)["nose"]
    figure, = world.ragdolls
    with pytest.raises(IndexError, match="bone 16: there are 16"):
        figure[16]
    before = states(world)
    bad = epode.human()
    bad[4].parent = 9
    with pytest.raises(epode.RefusedError, match=r"World\.ragdoll\(bones=a list of 16.*parent of a bone"):
        world.ragdoll(bad)
    with pytest.raises(epode.RefusedError, match="count of bones"):
        world.ragdoll([])
    with pytest.raises(TypeError, match="a Capsule, a Box or a Sphere is expected, not Cone"):
        world.ragdoll([epode.Bone(epode.Cone(1, 1))])
    with pytest.raises(epode.RefusedError, match="size of a bone"):
        world.ragdoll([epode.Bone(epode.Sphere(-1))])
    with pytest.raises(epode.RefusedError):
        world.ragdoll(bones, position=(0, 0, float("nan")))
    with pytest.raises(epode.RefusedError, match=r"epode\.human\(height=0"):
        epode.human(0)
    with pytest.raises(ValueError, match="16 quaternions, a row of w x y z each, are expected, not 4 numbers"):
        figure.hold((1, 0, 0, 0))
    with pytest.raises(epode.RefusedError, match=r"Ragdoll\.hold\(.*orientation of a pose"):
        figure.hold(np.zeros((16, 4)))
    with pytest.raises(epode.RefusedError, match="strength .accepted"):
        figure.hold(strength=-1)
    with pytest.raises(epode.RefusedError, match=r"Ragdoll\.follow\(.*weight"):
        figure.follow((0, 0, 1), figure.pose, H, weight=2)
    with pytest.raises(ValueError, match="position: 3 numbers"):
        figure.follow((0, 0), figure.pose, H)
    with pytest.raises(ValueError, match="angles of bone left forearm: 1 finite numbers are expected"):
        figure.pose_of({"left forearm": (1, 2, 3)})
    with pytest.raises(ValueError, match="angles of bone pelvis: 0 finite numbers"):
        figure.pose_of({0: 1})
    other = epode.World()
    with pytest.raises(ValueError, match="16 bodies, one for each bone, are expected, not 1"):
        epode.c.dRagdollGetGap([bone._to_c() for bone in bones], epode.c.BodyList([other.body(mass=1)._handle]))
    assert np.array_equal(states(world), before) and world.ragdolls == (figure,) and len(world.geoms) == 17
    world.destroy()
    assert not figure.alive and "destroyed" in repr(figure)
    with pytest.raises(epode.DeadHandleError):
        figure.hold()
