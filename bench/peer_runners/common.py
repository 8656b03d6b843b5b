# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What the runners of peers in Python share: a runner reads a scene that `epode_bench export` has written, steps it,
writes states for `epode_bench judge` after each eighth of the run, and prints its times as JSON. Time is that of the
process's own work around the one call that steps, so that Python's share is a call a step."""
import json
import math
import sys
import time

SAMPLES = 8


class Refused(Exception):
    """The engine, or its binding, cannot have this scene."""


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def product(p, q):
    """Of quaternions w, x, y, z: turns by q first."""
    w, v, s, u = p[0], p[1:], q[0], q[1:]
    dot = sum(x * y for x, y in zip(v, u))
    return [w * s - dot] + [w * y + s * x + z for x, y, z in zip(v, u, cross(v, u))]


def inverse(q):
    return [q[0], -q[1], -q[2], -q[3]]


def rotate(q, v):
    return product(product(q, [0] + list(v)), inverse(q))[1:]


def turn(axis, angle):
    size = math.sqrt(sum(x * x for x in axis))
    return [math.cos(angle / 2)] + [math.sin(angle / 2) * x / size for x in axis]


def z_to(axis):
    """The turn that takes z there: joints of many engines go about their frame's z."""
    side = cross([0, 0, 1], axis)
    sine = math.sqrt(sum(x * x for x in side))
    return turn(side, math.atan2(sine, axis[2])) if sine > 1e-9 else [1, 0, 0, 0]


def local(body, point):
    """A world point of the start in the frame of a body."""
    return rotate(inverse(body['turn']), subtract(point, body['pos']))


def driven(body, at):
    """Pose of a driven body at a time."""
    drive = body['drive']
    centre = drive['axis_point']
    pos = add(centre, rotate(turn([0, 0, 1], drive['orbit'] * at), subtract(body['pos'], centre)))
    rate = math.sqrt(sum(x * x for x in drive['spin']))
    return pos, product(turn(drive['spin'], rate * at), body['turn']) if rate else body['turn']


def cylinder_points(shape, sides):
    radius, half = shape['size'][0], shape['size'][1] / 2
    return [[radius * math.cos(2 * math.pi * i / sides), radius * math.sin(2 * math.pi * i / sides), z]
            for i in range(sides) for z in (-half, half)]


def write_state(out, step, states):
    out.write(f'state {step}\n')
    for numbers in states:
        out.write(' '.join(f'{x:.9g}' for part in numbers for x in part) + '\n')


def play(make, version):
    """make(scene) gives an object with step(time) and states(): position, quaternion w x y z, linear and angular
    velocity of every body, or with cast(rays): hits and their summed distances."""
    scene = json.load(open(sys.argv[1]))
    try:
        if scene['task'] == 'broad_phase':
            raise Refused('has no broad phase to be asked alone')
        engine = make(scene)
        times = shoot(engine, scene) if scene['task'] == 'rays' else simulate(engine, scene)
    except Refused as refusal:
        print(json.dumps({'refused': str(refusal)}))
        return
    print(json.dumps({'version': version, **times}))


def shoot(engine, scene):
    spent = []
    for _ in range(scene['steps']):
        start = time.process_time()
        hits, distance = engine.cast(scene['rays'])
        spent.append(1e3 * (time.process_time() - start))
    return {'ms': sum(spent) / len(spent), 'hits': hits, 'distance': distance}


def simulate(engine, scene):
    spent, steps = [], scene['steps']
    with open(sys.argv[2], 'w') as out:
        for i in range(1, steps + 1):
            start = time.process_time()
            engine.step((i - 1) * scene['dt'])
            spent.append(1e3 * (time.process_time() - start))
            if i * SAMPLES // steps != (i - 1) * SAMPLES // steps:
                write_state(out, i, engine.states())
    return {'ms': sum(spent) / len(spent)}
