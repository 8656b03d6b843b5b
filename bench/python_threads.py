#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Two threads of Python with a world each, compared with one thread with one world: python_threads.py [SECONDS], in an environment with
epode. Steps of both in a second, divided by those of one; rounds take turns, and the middle ratio counts. The machine's load
is printed with it: where others want the processors, two threads are also given twice the time, so only an idle machine with two or
more of them proves a gain. A Python loop in two threads, which the interpreter's lock keeps at about 1, is measured with them."""
import os
import statistics
import sys
import threading
import time

import numpy as np

import epode

ROUNDS = 5


def pile():
    """A hundred boxes on the ground, whose steps take much longer than the call."""
    world = epode.World(gravity=(0, 0, -9.81))
    world.plane()
    rng = np.random.default_rng(1)
    for i in range(100):
        x, y = rng.uniform(-1, 1, 2)
        world.body(mass=1, position=(x, y, 0.3 + 0.25 * i), shape=epode.Box(0.2, 0.2, 0.2))
    world.step(0.01, stepper="quick", steps=100)
    return world


def rate(works, seconds):
    """How often all of them were done in a second, each in a thread of its own."""
    counts = [0] * len(works)
    end = time.perf_counter() + seconds

    def run(i):
        while time.perf_counter() < end:
            works[i]()
            counts[i] += 1
    threads = [threading.Thread(target=run, args=(i,)) for i in range(len(works))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return sum(counts) / seconds


def ratio(works, seconds):
    return statistics.median(rate(works, seconds) / rate(works[:1], seconds) for _ in range(ROUNDS))


def main():
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 1.0
    worlds = [pile(), pile()]
    print(f"{os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
    print(f"steps: {ratio([lambda w=w: w.step(0.01, stepper='quick') for w in worlds], seconds):.2f} times one thread (wanted: 1.8)")
    print(f"Python alone: {ratio([lambda: sum(range(20000))] * 2, seconds):.2f} times one thread")


if __name__ == "__main__":
    main()
