#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""judge.py OUR_LIBRARY REFERENCE_LIBRARY OBSERVER FOLDER: everything else in Debian 12 that links with libode8, on our library.

Every binary must find its symbols. The games run on an X server without a screen (Xvfb), on both libraries: they must live, say
nothing of ours and have our library in their process map. mokomaze must show what it shows on Debian's library. mu-cade,
stormbaancoureur and xmoto are driven by keys or stand, and OBSERVER, preloaded, writes down where their bodies go (driven.py).
Pictures, logs and paths stay in FOLDER.
"""

import os
import re
import subprocess
import sys
import time

from driven import Driver, Run
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
    """An X server of 800 x 600 without a screen; it tells its number when it is ready.

    Without -noreset it would start again when its last client leaves, and refuse whoever comes meanwhile.
    """

    def __enter__(self):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "800x600x24", "-nolisten", "tcp", "-noreset"],
                                       pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as pipe:
            number = pipe.readline().strip()
        self.environment = dict(os.environ, DISPLAY=":" + number, SDL_AUDIODRIVER="dummy", LIBGL_ALWAYS_SOFTWARE="1",
                                PLODE_NO_SOUND="1", PLODE_NO_SHADOWS="1", PLODE_LOW_DETAIL="1")
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()

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


def play(who, library, folder, command, wait, act=None, extra=None):
    """Pictures after `wait` seconds and after `act(screen)`; judges life, library and messages. `extra`: of its environment."""
    name = os.path.basename(command[0])
    home = os.path.join(folder, "home")
    os.makedirs(home, exist_ok=True)
    log_path = os.path.join(folder, "%s.%s.log" % (name, who))
    pictures = []
    with Screen() as screen, open(log_path, "w") as log:
        environment = dict(screen.environment, HOME=home, LD_LIBRARY_PATH=os.path.dirname(library), **(extra or {}))
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


def drive_one(who, library, observer, folder, command, wait, begin, script, least, extra=None):
    """What the bodies did of a game that was given these keys on this library."""
    driver = Driver(os.path.join(folder, "%s.%s.path" % (os.path.basename(command[0]), who)), observer, script)

    def act(screen):
        begin(screen)
        driver(screen)
    play(who, library, folder, command, wait, act, {**driver.environment, **(extra or {})})
    return Run(driver.log, least)


def drive(ours, reference, *game):
    """The same keys on both libraries: two runs."""
    return drive_one("ours", ours, *game), drive_one("reference", reference, *game)


def point_into_window(screen):
    screen.keys("mousemove", "100", "100")  # where keys go without a window manager
    time.sleep(0.5)


MU_CADE = [(40, ["+z"]), (60, ["-z"]), (100, ["+Right"]), (125, ["-Right", "+Left"]), (170, ["-Left", "+Up"]),
           (200, ["-Up", "+Right", "+Down"]), (230, ["-Right", "-Down"]), (260, [])]


def apart(run, other, steps):
    """How far bodies of two runs are apart, and how much faster one is, at most in the first steps."""
    rows = list(zip(run.steps[:steps], other.steps[:steps]))
    return max((abs(a - b) for row, other_row in rows for a, b in zip(row[4:], other_row[4:])), default=float("inf"))


def mu_cade(ours, reference, observer, folder):
    """The player falls on to the arena and is driven about it, among creatures of nine linked bodies that fall next to it.

    A step is a frame and the seed is the date, which stands still: two runs on one library are the same to the last digit. The
    game bounds the speed of corrections, so that by default stops of joints throw nothing back (compat.md, D52): the first is
    hit in step 63. With the behaviour of ODE 0.16 all is the same, also when the first creature touches the ground in step 99.
    """
    game = observer, folder, ["/usr/games/mu-cade", "-window", "-nosound"], 3, point_into_window, MU_CADE, 200
    mine, theirs = drive(ours, reference, *game)
    as_ode = drive_one("as_ode", ours, *game, {"EPODE_BEHAVIOUR": "0.16"})
    path, other = mine.path(0), theirs.path(0)
    worst = max((abs(a - b) for row, their_row in zip(path, other) for a, b in zip(row, their_row)), default=float("inf"))
    way = sum(row[3] * 0.05 for row in other)
    require(mine.finite() and len(path) >= 200 and way > 15, "mu-cade: %d steps, the player goes %.1f m" % (len(path), way))
    require(worst < 1e-3, "mu-cade: the player's path and speed as there, to %.1e" % worst)
    require(mine.counts()[:150] == theirs.counts()[:150], "mu-cade: bodies come and go as there")
    falling = apart(mine, theirs, 60)
    require(falling < 0.1, "mu-cade: until their joints meet stops the creatures fall as there, to %.4f" % falling)
    same = apart(as_ode, theirs, 110)
    require(same < 1e-3, "mu-cade: with behaviour 0.16 everything goes as there for 110 steps, to %.1e" % same)
    require(mine.fastest() < 1.5 * theirs.fastest(), "mu-cade: nothing faster than %.1f m/s (reference %.1f)" % (mine.fastest(), theirs.fastest()))
    touching, there = mine.contacts(60, 200), theirs.contacts(60, 200)
    require(0.5 * there < touching < 1.5 * there, "mu-cade: %.1f contacts a step (reference %.1f)" % (touching, there))


CAR, BODIES = 28, 33  # stormbaancoureur's chassis, and all its bodies in practice
CRATES = range(8, 28)


def thrown(run, since):
    """How far the ten crates in the middle of the wall have come 100 steps later: the least and the mean."""
    first, last = run.steps[0], run.steps[min(len(run.steps) - 1, since + 100)]
    ways = [sum((first[4 + 4 * crate + k] - last[4 + 4 * crate + k]) ** 2 for k in range(3)) ** 0.5 for crate in CRATES if crate % 4 in (1, 2)]
    return min(ways), sum(ways) / len(ways)


def stormbaancoureur(ours, reference, observer, folder):
    """Practice: the car, on its four sprung wheels, accelerates over a mesh and into a wall of twenty crates.

    Steps are not bound to frames, so a key comes some steps sooner or later: what is compared is how fast the car is at a place. Two
    runs on Debian's library differ by 0.04 m/s before the crash, and after it some crate flies at 13 to 16 m/s.
    """
    def practise(screen):
        point_into_window(screen)
        screen.keys("key", "space")
    mine, theirs = drive(ours, reference, observer, folder, ["/usr/games/stormbaancoureur"], 8, practise, [(200, ["+a"]), (800, ["-a"])], 700)
    require(mine.finite() and mine.counts()[:700] == theirs.counts()[:700] == [BODIES] * 700, "stormbaancoureur: 33 bodies for 700 steps")
    if not mine.steps or not theirs.steps:
        return
    standing = [run.path(CAR)[199] for run in (mine, theirs)]
    require(abs(standing[0][2] - standing[1][2]) < 0.003 and abs(standing[0][3] - standing[1][3]) < 0.05,
            "stormbaancoureur: the car rides on its springs at %.4f m (reference %.4f)" % (standing[0][2], standing[1][2]))
    for x in (-3, 0, 3, 6, 9):
        speed, other = mine.speed_at(CAR, x), theirs.speed_at(CAR, x)
        require(speed > 1 and abs(speed - other) < 0.15, "stormbaancoureur: at %d m %.2f m/s (reference %.2f)" % (x, speed, other))
    lasted, there = (run.step_at(CAR, 9) - run.step_at(CAR, -3) for run in (mine, theirs))
    require(abs(lasted - there) <= 3, "stormbaancoureur: from -3 m to 9 m in %d steps (reference %d)" % (lasted, there))
    crash, other_crash = mine.step_at(CAR, 9.5), theirs.step_at(CAR, 9.5)
    (least, mean), (_, there) = thrown(mine, crash), thrown(theirs, other_crash)
    require(crash > 0 and least > 0.5 and 0.6 * there < mean < 1.7 * there,
            "stormbaancoureur: the crash throws the crates %.1f m, none less than %.1f (reference %.1f)" % (mean, least, there))
    require(mine.fastest() < 2 * theirs.fastest(), "stormbaancoureur: nothing faster than %.1f m/s (reference %.1f)" % (mine.fastest(), theirs.fastest()))
    touching, there = mine.contacts(100, 450), theirs.contacts(100, 450)
    require(0.75 * there < touching < 1.25 * there, "stormbaancoureur: %.0f contacts a step (reference %.0f)" % (touching, there))


FRAME = 2  # xmoto's bike: two wheels, the frame, and a rider of seven parts on either side


def from_frame(row):
    """Where the bodies are as seen from the bike's frame."""
    return [row[4 + 4 * body + k] - row[4 + 4 * FRAME + k] for body in range(int(row[2])) for k in range(3)]


def xmoto(ours, reference, observer, folder):
    """The first level, nobody drives: the bike falls on to its wheels and stands, sprung, its rider on it.

    Where it stands is known from the bodies: it may roll by centimetres to either side, and the camera looks far ahead where it rolls.
    """
    command = ["/usr/games/xmoto", "-l", "tut1", "--nowww", "--nosound", "-win", "-res", "800x600"]
    play("first", reference, folder, command, 60)  # fills its data base, which takes time once
    mine, theirs = drive(ours, reference, observer, folder, command, 5, lambda screen: None, [(1500, [])], 1200)
    require(mine.finite() and mine.counts()[:1200] == theirs.counts()[:1200] == [17] * 1200, "xmoto: 17 bodies for 1,200 steps")
    if not mine.steps or not theirs.steps:
        return
    falling = max(abs(a - b) for row, other in zip(mine.steps[:11], theirs.steps[:11]) for a, b in zip(row[4:], other[4:]))
    require(falling < 1e-4, "xmoto: the bike falls as there, to %.0e" % falling)
    sprung = max(abs(a - b) for a, b in zip(from_frame(mine.steps[1000]), from_frame(theirs.steps[1000])))
    height, other = mine.path(FRAME)[1000][1], theirs.path(FRAME)[1000][1]
    require(sprung < 0.015 and abs(height - other) < 0.005, "xmoto: it stands as there, wheels and rider in place to %.4f m" % sprung)
    moved, there = (abs(run.path(FRAME)[1000][0] - run.path(FRAME)[0][0]) for run in (mine, theirs))
    require(moved < 0.3 and max(mine.steps[1000][7::4]) < 0.05, "xmoto: and where: it has rolled %.3f m (reference %.3f)" % (moved, there))


def darkplaces(ours, reference, observer, folder):
    """The server of Quake without Quake's data, which Debian does not have: no map, no entity, no step.

    So only its start is judged: it starts ODE, says what it says on Debian's library, and waits for commands.
    """
    said = []
    for who, library in (("ours", ours), ("reference", reference)):
        log = os.path.join(folder, "darkplaces.%s.path" % who)
        environment = dict(os.environ, LD_LIBRARY_PATH=os.path.dirname(library), LD_PRELOAD=observer, OBSERVE=log)
        home = os.path.join(folder, "darkplaces")
        with subprocess.Popen(["/usr/games/darkplaces-server", "-basedir", home, "-userdir", home], env=environment, text=True,
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as server:
            time.sleep(3)
            alive, inode = server.poll() is None, loaded_inode(server) if server.poll() is None else None
            server.terminate()
            said.append([line for line in server.stdout.read().splitlines() if line and not line.startswith("Received signal")])
        if who == "ours":
            require(alive and inode == os.stat(library).st_ino and Run(log, 0).started, "darkplaces-server: starts ODE and lives on our library")
    require(len(said[0]) > 5 and said[0] == said[1], "darkplaces-server: says what it says there: %d lines" % len(said[0]))


def main(ours, reference, observer, folder):
    for binary in BINARIES:
        check_symbols(binary, ours)
    darkplaces(ours, reference, observer, folder)
    mu_cade(ours, reference, observer, folder)
    stormbaancoureur(ours, reference, observer, folder)
    mokomaze(ours, reference, folder)
    xmoto(ours, reference, observer, folder)
    sys.exit("debian: %d judgements failed" % len(failures) if failures else 0)


if __name__ == "__main__":
    main(*sys.argv[1:5])
