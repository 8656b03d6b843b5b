# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""All that games need in one world under the defaults for games: a car breaks through a fence and drives off a quay into the water, past
people who stand by their motors; a boat on a rope, crates that float and a crane's load; a character walks along. In the end
all of it lies, floats or hangs still."""
import dataclasses

import numpy as np

import epode

SECONDS = 24.0
TOP, DEPTH = 0.8, 3.0                                 # of the quay above the water, of the water


@dataclasses.dataclass
class Harbour:
    """The world, and what to look at."""
    world: epode.World
    car: epode.Vehicle
    fence: epode.Fracture
    boat: epode.Body
    mooring: epode.Rope
    crane: epode.Rope
    load: epode.Body
    people: list[epode.Ragdoll]
    guard: epode.Character


@dataclasses.dataclass
class Seen:
    """The worst of a run: gaps of joints, m, and the fastest body, m/s; then how it ended."""
    figure_gap: float
    rope_gap: float
    fastest: float
    asleep: float                                     # share of the bodies
    energy: float                                     # of motion, J
    car: epode.Vehicle
    fence_pieces: int
    state: bytes


def car(world: epode.World) -> epode.Vehicle:
    """1,200 kg that float: the chassis has 3 m^3."""
    chassis = world.vehicle(mass=1200, shape=epode.Box(4, 1.6, 0.5), position=(-24, 0, TOP + 0.65))
    for i in range(4):
        chassis.add_wheel((1.3 if i < 2 else -1.3, -0.75 if i % 2 else 0.75, -0.4), axle=i // 2, steer=float(i < 2), drive=float(i >= 2))
    return chassis


def build() -> Harbour:
    world = epode.World(defaults="game")
    world.plane(distance=-DEPTH)
    world.fluid()
    world.geom(epode.Box(30, 16, TOP + DEPTH), position=(-15, 0, (TOP - DEPTH) / 2))
    planks = [world.geom(epode.Box(0.05, 0.38, 1.0), position=(-5, 0.4 * i, TOP + 0.5)) for i in range(-4, 5)]
    fence = world.fracture(planks, density=600, strength=150, radius=1.0)
    boat = world.body(density=300, shape=epode.Box(4, 1.8, 0.6), position=(4, 5, 0.1))
    mooring = world.rope((0, 5, TOP), (2, 5, 0.1), length=2.6, links=16, mass=8, last=boat)
    load = world.body(mass=60, shape=epode.Box(0.6, 0.6, 0.6), position=(5, -5, 0.7))
    crane = world.rope((2.5, -5, 5), (5, -5, 1), length=5, links=25, mass=10, last=load)
    for i in range(12):
        world.body(density=300 + 60 * i, shape=epode.Box(0.6, 0.6, 0.6), position=(3 + 0.8 * (i % 4), -1 + 0.9 * (i // 4), 0.6 + 0.3 * (i % 2)))
    people = [world.ragdoll(epode.human(1.7 + 0.05 * i, 65 + 5 * i), position=(-9 - 1.5 * i, 0.9 - 1.8 * (i % 2), TOP)) for i in range(4)]
    for person in people:
        person.hold()
    people.append(world.ragdoll(epode.human(), position=(7, 2, 1)))
    guard = world.character(feet=(-20, 4, TOP))
    return Harbour(world, car(world), fence, boat, mooring, crane, load, people, guard)


def drive(stage: Harbour, time: float, h: float) -> None:
    """What the program does before each step."""
    stage.car.control(throttle=0.7 if time < 6 and stage.car.position[0] < -1 else 0.0)
    stage.car.update(h)
    stage.guard.walk((1.2 if time < 14 else 0.0, 0, 0), h)
    for person in stage.people:                       # who was hit goes limp
        if float(np.linalg.norm(person["thorax"].velocity)) > 2:
            person.hold(strength=0)
    stage.world.break_fractures()


def run(stage: Harbour, h: float, seconds: float = SECONDS) -> Seen:
    seen = Seen(0, 0, 0, 0, 0, stage.car, 0, b"")
    for i in range(round(seconds / h)):
        drive(stage, i * h, h)
        stage.world.step(h)
        seen.figure_gap = max(seen.figure_gap, *(person.gap for person in stage.people))
        seen.rope_gap = max(seen.rope_gap, stage.mooring.gap, stage.crane.gap)
        seen.fastest = max(seen.fastest, float(np.linalg.norm(stage.world.bodies.velocity, axis=1).max()))
    awake = stage.world.bodies.enabled
    seen.asleep = 1 - float(awake.mean())
    seen.energy = sum(0.5 * body.mass * float(body.velocity @ body.velocity) for body, moves in zip(stage.world.bodies, awake) if moves)
    seen.fence_pieces, seen.state = len(stage.fence.bodies), stage.world.save()
    return seen


def main() -> list[Seen]:
    runs = []
    for rate in (60, 120, 240):
        seen = run(build(), 1 / rate)
        runs.append(seen)
        print(f"1/{rate} s: joints of figures open by {1000 * seen.figure_gap:.1f} mm, of ropes by {1000 * seen.rope_gap:.2f} mm, fastest {seen.fastest:.1f} m/s, "
              f"fence in {seen.fence_pieces} pieces, {100 * seen.asleep:.0f} % asleep, {seen.energy:.3f} J")
    return runs


if __name__ == "__main__":
    import sys
    if len(sys.argv) == 1:
        main()
    for path in sys.argv[1:]:                         # harbour.html, harbour.png
        harbour = build()
        with harbour.world.record("A harbour") as film:
            run(harbour, 1 / 60, 10)
        film.picture(path, eye=(16, -18, 9), target=(-2, 0, 0), state=270) if path.endswith(".png") else film.save(path)
