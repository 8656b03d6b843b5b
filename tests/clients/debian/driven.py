# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Games driven by keys at given steps, and what the observer (observer.c) has written of their bodies.

A script is a list of (step, words): at that step the game waits until the words are done. "+a" presses a key, "-a" releases it.
"""

import glob
import os
import time

PATIENCE = 60  # seconds for a game to reach a step


class Run:
    """The first world that lasts `least` steps: its steps are rows of [step, h, bodies, contacts, x, y, z, speed, x, ...]."""

    def __init__(self, path, least):
        worlds, self.started = [[]], False
        with open(path) as file:
            for line in file:
                words = line.split()
                if line.startswith("end of world"):
                    worlds.append([])
                elif line.startswith("start"):
                    self.started = True
                elif line.endswith("\n") and len(words) == 4 + 4 * min(int(words[2]), 64):
                    worlds[-1].append([float(word) for word in words])
        self.steps = next((world for world in worlds if len(world) >= least), [])

    def finite(self):
        return bool(self.steps) and all(abs(number) < 1e6 for row in self.steps for number in row)

    def path(self, body):
        """Rows of x, y, z, speed."""
        return [row[4 + 4 * body:8 + 4 * body] for row in self.steps if row[2] > body]

    def counts(self):
        return [int(row[2]) for row in self.steps]

    def contacts(self, first, last):
        rows = self.steps[first:last]
        return sum(row[3] for row in rows) / max(1, len(rows))

    def fastest(self):
        return max((max(row[7::4]) for row in self.steps if row[2]), default=0)

    def step_at(self, body, x):
        """When the body first is beyond x."""
        return next((i for i, row in enumerate(self.path(body)) if row[0] > x), 0)

    def speed_at(self, body, x):
        """Of the body when it first is beyond x."""
        return next((row[3] for row in self.path(body) if row[0] > x), 0)


class Driver:
    def __init__(self, log, observer, script):
        for old in glob.glob(log + "*"):
            os.remove(old)
        self.log, self.script = log, script
        self.environment = {"LD_PRELOAD": observer, "OBSERVE": log, "OBSERVE_HOLD": ",".join(str(step) for step, _ in script)}

    def lines(self):
        try:
            with open(self.log, "rb") as file:
                return sum(line[:1].isdigit() for line in file)
        except OSError:
            return 0

    def __call__(self, screen):
        for step, words in self.script:
            give_up = time.time() + PATIENCE
            while self.lines() < step and time.time() < give_up:
                time.sleep(0.05)
            for word in words:
                screen.keys("keydown" if word[0] == "+" else "keyup", word[1:])
            with open("%s.go.%d" % (self.log, step), "w"):
                pass
