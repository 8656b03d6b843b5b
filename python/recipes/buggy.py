# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A buggy: a chassis on four wheels with suspension, driven at the back and steered in front."""
import epode


def build(world: epode.World) -> tuple[epode.Body, list[epode.Joint]]:
    """The chassis, and the joints of its wheels: front left and right, back left and right."""
    chassis = world.body(mass=40, shape=epode.Box(1.6, 0.8, 0.25), position=(0, 0, 0.6))
    tyre = epode.Material(friction=1.2)
    joints = []
    for x, y in ((0.6, 0.55), (0.6, -0.55), (-0.6, 0.55), (-0.6, -0.55)):
        wheel = world.body(mass=3, shape=epode.Sphere(0.3), position=(x, y, 0.4), material=tyre)
        joint = world.joint("hinge2", chassis, wheel, anchor=(x, y, 0.4), axis1=(0, 0, 1), axis2=(0, 1, 0))
        joint.set_parameter("suspension_erp", 0.4)
        joint.set_parameter("suspension_cfm", 0.0005)
        joint.stops = (0.0, 0.0)                      # wheels are held straight; steering moves the stops of the front ones
        joints.append(joint)
    return chassis, joints


def main() -> epode.Body:
    world = epode.World()
    world.plane()
    chassis, wheels = build(world)
    for t in range(600):                              # 6 s
        for wheel in wheels[2:]:
            wheel.motor(velocity=-12.0, max_force=30.0, axis=1)
        for wheel in wheels[:2]:
            wheel.stops = (-0.3, -0.3) if t > 300 else (0.0, 0.0)
        world.step(0.01)
        if t == 300:
            print(f"after 3 s at x = {chassis.position[0]:.1f} m, {chassis.velocity[0]:.1f} m/s")
    x, y, _ = chassis.position
    print(f"after 6 s at ({x:.1f}, {y:.1f}) m: it has turned")
    return chassis


if __name__ == "__main__":
    main()
