# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A ragdoll falls down stairs; the recording is a page for a browser. In a notebook, ``recording`` shows itself."""
import epode

# name: (radius, length of the cylinder, centre, axis of the limb, what it hangs on, where the joint is, its type)
LIMBS = {
    "chest": (0.14, 0.25, (0, 0, 1.35), "y", None, None, None),
    "hips": (0.13, 0.16, (0, 0, 1.0), "y", "chest", (0, 0, 1.17), "ball"),
    "head": (0.11, 0.06, (0, 0, 1.68), "z", "chest", (0, 0, 1.53), "ball"),
    "thigh_l": (0.08, 0.3, (0, 0.11, 0.7), "z", "hips", (0, 0.11, 0.92), "ball"),
    "thigh_r": (0.08, 0.3, (0, -0.11, 0.7), "z", "hips", (0, -0.11, 0.92), "ball"),
    "shin_l": (0.06, 0.32, (0, 0.11, 0.26), "z", "thigh_l", (0, 0.11, 0.48), "hinge"),
    "shin_r": (0.06, 0.32, (0, -0.11, 0.26), "z", "thigh_r", (0, -0.11, 0.48), "hinge"),
    "arm_l": (0.05, 0.24, (0, 0.28, 1.25), "z", "chest", (0, 0.28, 1.42), "ball"),
    "arm_r": (0.05, 0.24, (0, -0.28, 1.25), "z", "chest", (0, -0.28, 1.42), "ball"),
    "hand_l": (0.045, 0.22, (0, 0.28, 0.95), "z", "arm_l", (0, 0.28, 1.1), "hinge"),
    "hand_r": (0.045, 0.22, (0, -0.28, 0.95), "z", "arm_r", (0, -0.28, 1.1), "hinge"),
}
LIE = (0.7071067811865476, 0.7071067811865476, 0, 0)  # z turned to -y


def ragdoll(world: epode.World, at: tuple[float, float, float]) -> dict[str, epode.Body]:
    """A person of capsules, held together by joints; its feet are at a point."""
    def there(p: tuple[float, float, float]) -> tuple[float, float, float]:
        return p[0] + at[0], p[1] + at[1], p[2] + at[2]
    bodies: dict[str, epode.Body] = {}
    for name, (radius, length, centre, axis, parent, anchor, kind) in LIMBS.items():
        body = world.body(density=900, shape=epode.Capsule(radius, length), position=there(centre),
                          quaternion=LIE if axis == "y" else (1, 0, 0, 0))
        bodies[name] = body
        body.angular_damping = 0.02
        if parent is None or anchor is None or kind is None:
            continue
        joint = world.joint(kind, bodies[parent], body, anchor=there(anchor))
        if kind == "hinge":                           # knees and elbows bend one way
            joint.axis = (0, 1, 0)
            joint.stops = (-2.2, 0.05) if name.startswith("shin") else (-0.05, 2.2)
        limbs = body.geoms + bodies[parent].geoms     # neighbours overlap at their joint
        for geom in limbs:
            PAIRS.setdefault(geom, set()).update(limbs)
    return bodies


PAIRS: dict[epode.Geom, set[epode.Geom]] = {}


def stairs(world: epode.World, steps: int = 8, rise: float = 0.18, tread: float = 0.32) -> None:
    """Down along x, from the top platform."""
    world.plane(distance=-steps * rise)
    for i in range(-2, steps):
        height = (steps - max(i, 0)) * rise
        world.geom(epode.Box(tread, 3, height), position=(i * tread, 0, height / 2 - steps * rise), material=epode.Material(friction=0.5))


def main() -> epode.Recording:
    world = epode.World()
    stairs(world)
    person = ragdoll(world, (-0.2, 0, 0.01))
    world.on_pair(lambda a, b: b not in PAIRS.get(a, ()))
    for body in person.values():
        body.velocity = (1.6, 0, 0)                   # somebody pushed
    with world.record("A ragdoll falls down stairs") as recording:
        world.step(0.005, stepper="hybrid", steps=700)
    fallen = -float(person["chest"].position[2])
    print(f"the chest is {fallen:.2f} m below the platform, {len(recording)} states")
    return recording


if __name__ == "__main__":
    import sys
    film = main()
    for path in sys.argv[1:]:                         # ragdoll.html, ragdoll.png, ...
        film.picture(path) if path.endswith(".png") else film.save(path)
