# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A person stumbles down stairs and goes limp; the recording is a page for a browser. In a notebook, ``recording`` shows itself."""
import epode

H = 1 / 120


def stairs(world: epode.World, steps: int = 8, rise: float = 0.18, tread: float = 0.32) -> None:
    """Down along x, from the top platform."""
    world.plane(distance=-steps * rise)
    for i in range(-2, steps):
        height = (steps - max(i, 0)) * rise
        world.geom(epode.Box(tread, 3, height), position=(i * tread, 0, height / 2 - steps * rise), material=epode.Material(friction=0.5))


def main() -> epode.Recording:
    world = epode.World(defaults="game")
    stairs(world)
    person = world.ragdoll(epode.human(height=1.75, mass=70), position=(-0.2, 0, 0.01))
    for body in person.bodies:
        body.velocity = (1.6, 0, 0)                   # somebody pushed
    standing = float(person["thorax"].position[2])
    arms = person.pose_of({"left upper arm": (0, 0.5, 1.2), "right upper arm": (0, -0.5, 1.2), "left forearm": 0.6, "right forearm": 0.6})
    with world.record("A person stumbles down stairs") as recording:
        for strength in (0.6, 0.4, 0.2, 0.1, 0.0):    # it stretches its arms out, weaker and weaker
            person.hold(arms, strength)
            world.step(H, steps=84)
    fallen = standing - float(person["thorax"].position[2])
    print(f"the chest has fallen {fallen:.2f} m, no joint is open by more than {1000 * person.gap:.1f} mm, {len(recording)} states")
    return recording


if __name__ == "__main__":
    import sys
    film = main()
    for path in sys.argv[1:]:                         # ragdoll.html, ragdoll.png, ...
        film.picture(path) if path.endswith(".png") else film.save(path)
