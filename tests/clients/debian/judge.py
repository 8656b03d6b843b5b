#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""judge.py OUR_LIBRARY REFERENCE_LIBRARY FOLDER: everything else in Debian 12 that links with libode8, on our library.

Every binary must find its symbols. The games
run for some seconds on an X server without a screen (Xvfb): they must live, say nothing of ours, have our library in their
process map, and where it can be told from the picture, show what they show on Debian's library. Pictures stay in FOLDER.
"""

import os
import re
import subprocess
import sys
import time

from screen import Picture, differing_share

BINARIES = [
    "/usr/lib/x86_64-linux-gnu/libdart-collision-ode.so.6.12",  # judged by ../dart
    "/usr/lib/x86_64-linux-gnu/libompl.so.16",  # judged by ../ompl, in every ctest
    "/usr/lib/python3/dist-packages/ode.cpython-311-x86_64-linux-gnu.so",  # judged by ../pyode, in every ctest
    "/usr/games/darkplaces-server",
    "/usr/games/stormbaancoureur",
    "/usr/games/xmoto",
    "/usr/games/mokomaze",
    "/usr/games/mu-cade",
]
BIKE = (150, 185, 320, 365)  # where xmoto's camera holds the rider

failures = []


def require(condition, text):
    print("%s %s" % ("ok    " if condition else "FAILED", text), flush=True)
    if not condition:
        failures.append(text)


def check_symbols(binary, library):
    environment = dict(os.environ, LD_LIBRARY_PATH=os.path.dirname(library), LD_BIND_NOW="1")
    done = subprocess.run(["ldd", "-r", binary], env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    ours = [line for line in done.stdout.splitlines() if "libode.so.8" in line and os.path.dirname(library) in line]
    missing = sorted(set(re.findall(r"undefined symbol: (d[A-Z]\w+)", done.stdout)))
    require(ours and not missing, "%s: every symbol is there %s" % (os.path.basename(binary), missing[:5]))


class Screen:
    """An X server of 800 x 600 without a screen; it tells its number when it is ready."""

    def __enter__(self):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "800x600x24", "-nolisten", "tcp"], pass_fds=[writing],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as pipe:
            number = pipe.readline().strip()
        self.environment = dict(os.environ, DISPLAY=":" + number, SDL_AUDIODRIVER="dummy", LIBGL_ALWAYS_SOFTWARE="1")
        # A server without clients resets when the last one leaves, which the next may run into: this one stays.
        self.keeper = subprocess.Popen(["xev", "-root"], env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(1)
        return self

    def __exit__(self, *_):
        for process in (self.keeper, self.server):
            process.terminate()
            process.wait()

    def picture(self, path):
        with open(path + ".xwd", "wb") as file:
            subprocess.run(["xwd", "-root", "-silent"], env=self.environment, stdout=file, check=True)
        picture = Picture(path + ".xwd")
        os.remove(path + ".xwd")
        picture.write_png(path + ".png")
        return picture

    def keys(self, *words):
        subprocess.run(["xdotool", *words], env=self.environment, check=True)


def loaded_inode(process):
    with open("/proc/%d/maps" % process.pid) as maps:
        found = [line.split() for line in maps if "/libode.so" in line]
    return int(found[0][4]) if found else None


def play(who, library, folder, command, wait, act=None):
    """Pictures after `wait` seconds and after `act(screen)`; judges life, library and messages."""
    name = os.path.basename(command[0])
    home = os.path.join(folder, "home")
    os.makedirs(home, exist_ok=True)
    log_path = os.path.join(folder, "%s.%s.log" % (name, who))
    pictures = []
    with Screen() as screen, open(log_path, "w") as log:
        environment = dict(screen.environment, HOME=home, LD_LIBRARY_PATH=os.path.dirname(library))
        process = subprocess.Popen(command, env=environment, stdout=log, stderr=subprocess.STDOUT)
        time.sleep(wait)
        pictures.append(screen.picture(os.path.join(folder, "%s.%s.1" % (name, who))))
        if act:
            act(screen)
            pictures.append(screen.picture(os.path.join(folder, "%s.%s.2" % (name, who))))
        alive = process.poll() is None
        inode = loaded_inode(process) if alive else None
        process.terminate()
        process.wait()
    with open(log_path, errors="replace") as log:
        messages = [line.strip() for line in log if re.search(r"\bODE (INTERNAL|Message|Warning)", line)]
    if who == "ours":
        require(alive and inode == os.stat(library).st_ino, "%s: lives on our library" % name)
        require(not messages, "%s: no message of ours %s" % (name, messages[:2]))
        require(pictures[-1].colours() > 5, "%s: shows something: %d colours" % (name, pictures[-1].colours()))
    return pictures


def roll_right(screen):
    screen.keys("keydown", "Right")
    time.sleep(4)
    screen.keys("keyup", "Right")
    time.sleep(3)


def mokomaze(ours, reference, folder):
    """The labyrinth tilted to the right: the ball rolls to the wall and stays."""
    command = ["/usr/games/mokomaze", "-i", "keyboard", "-l", "1"]
    before, after = play("ours", ours, folder, command, 6, roll_right)
    _, other = play("reference", reference, folder, command, 6, roll_right)
    rolled, difference = differing_share(before, after), differing_share(after, other)
    require(rolled > 0.004, "mokomaze: the ball rolls (%.2f %% of the picture changes)" % (100 * rolled))
    require(difference < 0.004, "mokomaze: and stops where it stops there (%.2f %% differ: its pattern)" % (100 * difference))


def xmoto(ours, reference, folder):
    """The first level, nobody drives: the bike must stand, suspended, on its two wheels."""
    command = ["/usr/games/xmoto", "-l", "tut1", "--nowww", "--nosound", "-win", "-res", "800x600"]
    play("first", reference, folder, command, 60)  # fills its data base, which takes time once
    mine, theirs = play("ours", ours, folder, command, 20)[0], play("reference", reference, folder, command, 20)[0]
    difference = differing_share(mine, theirs, BIKE)
    require(difference < 0.15, "xmoto: the bike stands as it stands there (%.1f %% of its part of the picture differ)" % (100 * difference))


def start_game(screen):
    screen.keys("key", "z")
    time.sleep(3)
    for key in ("Right", "Down", "Left", "Up"):
        screen.keys("keydown", key, "keydown", "z")
        time.sleep(1)
        screen.keys("keyup", key, "keyup", "z")


def main(ours, reference, folder):
    for binary in BINARIES:
        check_symbols(binary, ours)
    mokomaze(ours, reference, folder)
    xmoto(ours, reference, folder)
    play("ours", ours, folder, ["/usr/games/mu-cade", "-window", "-nosound"], 8, start_game)
    play("ours", ours, folder, ["/usr/games/stormbaancoureur"], 12)  # its menu: a track is a trimesh
    sys.exit("debian: %d judgements failed" % len(failures) if failures else 0)


if __name__ == "__main__":
    main(*sys.argv[1:4])
