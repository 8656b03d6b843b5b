# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Stand-ins for the modules with which pyode's tutorials draw (pygame, OpenGL, cgtypes) and read a picture (PIL, numpy).

The tutorials run unchanged, without a window and without waiting: each frame that they would show calls `on_frame(number)`
instead, and after `frames` frames the program is asked to end in its own way (pygame's QUIT, glut's key). Only ode itself is the
real thing. The real modules would cost 57 MB of packages and prove no more.
"""

import re
import struct
import sys
import types
import zlib


class Screen:
    """Counts the frames of the program, tells the observer, and says when the program must end."""

    def __init__(self, frames, on_frame, keys=()):
        self.frames = frames
        self.on_frame = on_frame
        self.keys = dict(keys)
        self.shown = 0

    def flip(self):
        self.shown += 1
        self.on_frame(self.shown)

    def is_over(self):
        return self.shown >= self.frames


def nothing(*_arguments, **_names):
    return None


def named(name, **members):
    module = types.ModuleType(name)
    module.__dict__.update(members)
    sys.modules[name] = module
    return module


def install_pygame(screen):
    quit_event, key_down = 1, 2
    keys = {"K_w": 10, "K_a": 11, "K_s": 12, "K_d": 13, "K_ESCAPE": 14}

    def events():
        found = [types.SimpleNamespace(type=key_down, key=keys[name])
                 for frame, name in screen.keys.items() if frame == screen.shown]
        return found + [types.SimpleNamespace(type=quit_event)] * screen.is_over()

    surface = types.SimpleNamespace(fill=nothing)
    display = types.SimpleNamespace(set_mode=lambda *_: surface, set_caption=nothing, flip=screen.flip)
    named("pygame", init=lambda: (1, 0), display=display, time=types.SimpleNamespace(Clock=lambda: types.SimpleNamespace(tick=nothing)),
          event=types.SimpleNamespace(get=events), draw=types.SimpleNamespace(circle=nothing, line=nothing),
          mouse=types.SimpleNamespace(set_visible=nothing, get_pos=lambda: (0, 0)),
          QUIT=quit_event, KEYDOWN=key_down, KEYUP=3, MOUSEBUTTONDOWN=4, OPENGL=0, DOUBLEBUF=0, **keys)
    named("pygame.locals", QUIT=quit_event)


def install_opengl(screen, source):
    """Every gl name that the program uses: functions do nothing, constants are 0; glut's loop runs the program's callbacks."""
    callbacks = {}

    def main_loop():
        while not screen.is_over():
            callbacks["idle"]()
            callbacks["display"]()
        callbacks["keyboard"](b"q", 0, 0)

    members = {name: 0 if name.startswith("GL") else nothing for name in re.findall(r"\b(?:gl[A-Zu]\w*|GL(?:UT)?_\w+)\b", source)}
    for kind in ("Idle", "Display", "Keyboard"):
        members["glut%sFunc" % kind] = lambda function, kind=kind: callbacks.__setitem__(kind.lower(), function)
    members.update(glutMainLoop=main_loop, glutSwapBuffers=screen.flip)
    named("OpenGL")
    named("OpenGL.GL", **members)
    named("OpenGL.GLU")
    named("OpenGL.GLUT")


class Matrix(dict):
    """cgtypes.mat4 as far as a program that only draws with it needs it: it takes anything, and nobody looks."""

    def __init__(self, *_numbers):
        dict.__init__(self)

    def __getattr__(self, _name):
        return lambda *_a, **_k: self


class Vector(tuple):
    """cgtypes.vec3: multiplied by a number on the left."""

    def __new__(cls, *numbers):
        return tuple.__new__(cls, numbers)

    def __rmul__(self, factor):
        return Vector(*(factor * number for number in self))


def decode_png(path):
    """Width, height and red channel of a PNG of 8 bits a channel, not interlaced (PNG specification, sections 9 and 11)."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed, header = 8, b"", None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        header = struct.unpack(">IIBBBBB", body) if kind == b"IHDR" else header
        packed += body if kind == b"IDAT" else b""
        at += size + 12
    width, height, bits, colour, _, _, interlace = header
    if bits != 8 or interlace:
        sys.exit("pyode: a picture of another kind than expected: %s" % (header,))
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
    raw, stride = zlib.decompress(packed), width * channels
    above, red = bytearray(stride), []
    for row in range(height):
        start = row * (stride + 1)
        above = unfilter(raw[start], bytearray(raw[start + 1:start + 1 + stride]), above, channels)
        red.extend(above[::channels])
    return width, height, red


def unfilter(kind, line, above, channels):
    for i, value in enumerate(line):
        left = line[i - channels] if i >= channels else 0
        corner = above[i - channels] if i >= channels else 0
        guess = left + above[i] - corner
        paeth = min((abs(guess - left), 0, left), (abs(guess - above[i]), 1, above[i]), (abs(guess - corner), 2, corner))[2]
        line[i] = (value + (0, left, above[i], (left + above[i]) // 2, paeth)[kind]) & 255
    return line


class Array(list):
    def astype(self, _kind):
        return bytearray(self)


def install_pictures():
    def open_picture(path, _mode):
        width, height, red = decode_png(path)
        return types.SimpleNamespace(size=(width, height), getdata=lambda _channel: red)

    named("PIL", Image=types.SimpleNamespace(open=open_picture))
    named("numpy", array=Array, ubyte="ubyte", ascontiguousarray=lambda data: data)


def install(screen, source):
    install_pygame(screen)
    install_opengl(screen, source)
    install_pictures()
    named("cgtypes", mat4=Matrix, vec3=Vector)
