# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
# %% [markdown]
# # A robot from a file
# An arm of two links, as MJCF. `epode.load("arm.urdf")` reads files; a text does here.

# %%
import numpy as np

import epode

model = epode.robot.from_text("""<mujoco model="arm"><compiler angle="radian"/><worldbody>
<body name="upper" pos="0 0 1"><joint name="shoulder" axis="0 1 0" damping="0.2"/><geom type="capsule" fromto="0 0 0 .5 0 0" size=".04"/>
<body name="fore" pos=".5 0 0"><joint name="elbow" axis="0 1 0" damping="0.2"/><geom type="capsule" fromto="0 0 0 .4 0 0" size=".03"/>
<site name="hand" pos=".4 0 0"/></body></body></worldbody>
<actuator><motor joint="shoulder"/><motor joint="elbow"/></actuator></mujoco>""")
model.joint_names, model.actuator_names

# %% [markdown]
# Kinematics and dynamics need no world.

# %%
q = np.array([-0.3, 0.9])
place, _ = model.pose("hand", q)
expected = [0.5 * np.cos(q[0]) + 0.4 * np.cos(q.sum()), 0, 1 - 0.5 * np.sin(q[0]) - 0.4 * np.sin(q.sum())]
assert np.allclose(place, expected, atol=1e-12)
print("hand at", place.round(3), "held by torques of", model.gravity_forces(q).round(2), "N m")

# %% [markdown]
# A robot shows itself: a picture, its joints and actuators.

# %%
standing = model.build(start=q)
assert "shoulder" in standing._repr_html_()
standing

# %% [markdown]
# In a world: hold it there with these torques, and it stays.

# %%
with epode.World(gravity=model.gravity) as world:
    robot = model.build(world)
    robot.positions = q
    for _ in range(100):
        robot.controls = model.gravity_forces(robot.positions)
        world.step(0.002)
    print("after 0.2 s it is", abs(robot.positions - q).max(), "rad off")
    assert abs(robot.positions - q).max() < 1e-4
