# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""An arm with two servos: drives hold their targets against gravity, and follow a circle."""
import numpy as np

import epode

UPPER, LOWER = 0.5, 0.4


def angles(x: float, z: float) -> tuple[float, float]:
    """Where the two joints must be for the hand to be at (x, z)."""
    elbow = float(np.arccos(np.clip((x * x + z * z - UPPER ** 2 - LOWER ** 2) / (2 * UPPER * LOWER), -1, 1)))
    shoulder = float(np.arctan2(x, z) - np.arctan2(LOWER * np.sin(elbow), UPPER + LOWER * np.cos(elbow)))
    return shoulder, elbow


def main() -> float:
    world = epode.World(contacts=False)
    upper = world.body(mass=2, shape=epode.Capsule(0.04, UPPER - 0.08), position=(0, 0, UPPER / 2))
    lower = world.body(mass=1.5, shape=epode.Capsule(0.03, LOWER - 0.06), position=(0, 0, UPPER + LOWER / 2))
    shoulder = world.joint("hinge", upper, anchor=(0, 0, 0), axis=(0, 1, 0))
    elbow = world.joint("hinge", lower, upper, anchor=(0, 0, UPPER), axis=(0, 1, 0))
    servo = epode.Drive(stiffness=20000, damping=80, armature=0.02, force_limit=200)
    worst = 0.0
    for step in range(3000):                          # 3 s: half a second to get there, then a circle a second
        t = 0.001 * step
        phase = 2 * np.pi * max(t - 1.0, 0)
        x, z = 0.5 + 0.12 * np.sin(phase), 0.4 + 0.12 * (np.cos(phase) - 1)
        for joint, target in zip((shoulder, elbow), angles(x, z)):
            joint.set_drive(servo, target=target * min(2 * t, 1.0))
        world.step(0.001)
        if t > 1.2:
            hand = lower.to_world((0, 0, LOWER / 2))
            worst = max(worst, float(np.hypot(hand[0] - x, hand[2] - z)))
    print(f"the hand stays within {1000 * worst:.1f} mm of its circle; the shoulder needs {abs(shoulder.drive_force()):.1f} N m")
    return worst


if __name__ == "__main__":
    main()
