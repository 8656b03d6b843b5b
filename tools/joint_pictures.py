#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Draws the picture of each joint type for docs/guide/joints.md into docs/guide/images/joint_*.svg, from boxes, cylinders
and balls seen from one direction (orthographic), painted from back to front. Body 1 is blue, body 2 orange, what
belongs to the joint grey; red and green are axis 1 and axis 2, violet a third one; a straight arrow may slide, a bent one turn.

joint_pictures.py            writes the pictures
joint_pictures.py --check    fails when one is not what this script draws"""
import math
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "docs/guide/images"
BLUE, ORANGE, GREY, WORLD = (82, 139, 196), (226, 148, 70), (150, 150, 150), (205, 205, 200)
RED, GREEN, VIOLET = "#c0302b", "#2f8a3a", "#7a3fa0"
SIZE, SCALE = 240, 66
AZIMUTH, HEIGHT = math.radians(-58), math.radians(24)
RIGHT = (-math.sin(AZIMUTH), math.cos(AZIMUTH), 0)
TO_EYE = (math.cos(HEIGHT) * math.cos(AZIMUTH), math.cos(HEIGHT) * math.sin(AZIMUTH), math.sin(HEIGHT))
UP = (-math.sin(HEIGHT) * math.cos(AZIMUTH), -math.sin(HEIGHT) * math.sin(AZIMUTH), math.cos(HEIGHT))
LIGHT = (0.25, -0.55, 0.8)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def add(a, b, s=1.0):
    return tuple(x + s * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return tuple(x / math.sqrt(dot(a, a)) for x in a)


def across(axis):
    """Two unit vectors that make a right-handed frame with a unit axis."""
    u = unit(cross(axis, (0, 0, 1) if abs(axis[2]) < 0.9 else (1, 0, 0)))
    return u, cross(axis, u)


class Picture:
    def __init__(self):
        self.faces, self.over = [], []

    def on_page(self, p):
        return f"{SIZE / 2 + SCALE * dot(p, RIGHT):.1f},{SIZE / 2 - SCALE * dot(p, UP):.1f}"

    def face(self, corners, colour, normal, nearer=0.0):
        if dot(normal, TO_EYE) <= 1e-9:
            return
        shade = 0.62 + 0.38 * max(0.0, dot(unit(LIGHT), normal))
        fill = "#%02x%02x%02x" % tuple(int(c * shade) for c in colour)
        depth = sum(dot(c, TO_EYE) for c in corners) / len(corners) + nearer
        points = " ".join(self.on_page(c) for c in corners)
        self.faces.append((depth, f'<polygon points="{points}" fill="{fill}" stroke="#333" stroke-width="0.8" '
                                  f'stroke-linejoin="round"/>'))

    def box(self, centre, sides, colour, axes=((1, 0, 0), (0, 1, 0), (0, 0, 1)), nearer=0.0):
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            for sign in (-1, 1):
                normal = tuple(sign * x for x in axes[i])
                middle = add(centre, normal, sides[i] / 2)
                corners = [add(add(middle, axes[j], a * sides[j] / 2), axes[k], b * sides[k] / 2)
                           for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
                self.face(corners, colour, normal, nearer)

    def cylinder(self, start, end, radius, colour, nearer=0.0):
        axis = unit(add(end, start, -1))
        u, v = across(axis)
        ring = [add(tuple(radius * math.cos(t) * x for x in u), v, radius * math.sin(t))
                for t in (2 * math.pi * i / 20 for i in range(20))]
        visible = []
        for a, b in zip(ring, ring[1:] + ring[:1]):
            normal = unit(add(a, b))
            if dot(normal, TO_EYE) > 0:
                visible.append(([add(start, a), add(start, b), add(end, b), add(end, a)], normal))
        middle = tuple((a + b) / 2 for a, b in zip(start, end))
        for corners, normal in visible:
            shade = 0.62 + 0.38 * max(0.0, dot(unit(LIGHT), normal))
            fill = "#%02x%02x%02x" % tuple(int(c * shade) for c in colour)
            depth = dot(middle, TO_EYE) + radius * 0.5 + nearer
            self.faces.append((depth, f'<polygon points="{" ".join(self.on_page(c) for c in corners)}" fill="{fill}" '
                                      f'stroke="{fill}" stroke-width="0.6"/>'))
        for at, sign in ((start, -1), (end, 1)):
            corners = [add(at, r) for r in ring]
            self.face(corners, colour, tuple(sign * x for x in axis), nearer + radius * 0.5)

    def ball(self, centre, radius, colour, nearer=0.0):
        x, y = (float(s) for s in self.on_page(centre).split(","))
        fill, light = "#%02x%02x%02x" % tuple(int(c * 0.85) for c in colour), "#%02x%02x%02x" % colour
        r = radius * SCALE
        self.faces.append((dot(centre, TO_EYE) + radius + nearer,
                           f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r:.1f}" fill="{fill}" stroke="#333" stroke-width="0.8"/>'
                           f'<circle cx="{x - 0.25 * r:.1f}" cy="{y - 0.3 * r:.1f}" r="{0.45 * r:.1f}" fill="{light}"/>'))

    def arrow(self, start, end, colour, both=False):
        self.over.append(f'<polyline points="{self.on_page(start)} {self.on_page(end)}" fill="none" stroke="{colour}" '
                         f'stroke-width="2.4"/>')
        self.head(start, end, colour)
        if both:
            self.head(end, start, colour)

    def head(self, start, end, colour):
        a, b = ([float(s) for s in self.on_page(p).split(",")] for p in (start, end))
        d = math.hypot(b[0] - a[0], b[1] - a[1])
        x, y = (b[0] - a[0]) / d, (b[1] - a[1]) / d
        points = [(b[0] + 6 * x, b[1] + 6 * y), (b[0] - 4 * x - 5 * y, b[1] - 4 * y + 5 * x),
                  (b[0] - 4 * x + 5 * y, b[1] - 4 * y - 5 * x)]
        self.over.append('<polygon points="' + " ".join(f"{p[0]:.1f},{p[1]:.1f}" for p in points) + f'" fill="{colour}"/>')

    def turn(self, centre, axis, radius, colour, start=0.3, sweep=4.6):
        """A bent arrow about an axis: the right-hand turn."""
        u, v = across(unit(axis))
        at = [add(add(centre, u, radius * math.cos(start + sweep * i / 30)), v, radius * math.sin(start + sweep * i / 30))
              for i in range(31)]
        self.over.append(f'<polyline points="{" ".join(self.on_page(p) for p in at)}" fill="none" stroke="{colour}" '
                         f'stroke-width="2.4"/>')
        self.head(at[-3], at[-1], colour)

    def axis(self, start, end, colour):
        self.over.append(f'<polyline points="{self.on_page(start)} {self.on_page(end)}" fill="none" stroke="{colour}" '
                         f'stroke-width="1.6" stroke-dasharray="6 3"/>')

    def dot_at(self, point, colour="#222"):
        x, y = self.on_page(point).split(",")
        self.over.append(f'<circle cx="{x}" cy="{y}" r="3.4" fill="{colour}"/>')

    def svg(self, title):
        faces = "\n".join(text for _, text in sorted(self.faces, key=lambda face: face[0]))
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{SIZE}" height="{SIZE - 50}" viewBox="0 25 {SIZE} {SIZE - 50}">\n'
                f"<title>{title}</title>\n{faces}\n" + "\n".join(self.over) + "\n</svg>\n")


X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)


def ball(p):
    p.box((-0.85, 0, 0), (0.9, 0.45, 0.45), BLUE)
    p.cylinder((-0.4, 0, 0), (0, 0, 0), 0.08, BLUE)
    p.ball((0, 0, 0), 0.2, GREY)
    p.cylinder((0.1, 0, 0.1), (0.45, 0, 0.45), 0.08, ORANGE)
    tilt = (unit((1, 0, 1)), Y, unit((-1, 0, 1)))
    p.box((0.72, 0, 0.72), (0.8, 0.45, 0.45), ORANGE, tilt)
    p.dot_at((0, 0, 0))


def hinge(p):
    p.box((-0.75, 0, 0), (1.3, 0.12, 1.2), BLUE)
    p.box((0.75, 0, 0), (1.3, 0.12, 1.2), ORANGE)
    p.cylinder((0, 0, -0.75), (0, 0, 0.75), 0.11, GREY, 0.4)
    p.axis((0, 0, -1.3), (0, 0, 1.35), RED)
    p.turn((0, 0, 1.1), Z, 0.32, RED)
    p.dot_at((0, 0, 0))


def slider(p):
    p.cylinder((-1.3, 0, 0), (1.3, 0, 0), 0.09, GREY, -0.2)
    p.box((-0.8, 0, 0), (0.6, 0.6, 0.6), BLUE)
    p.box((0.7, 0, 0), (0.6, 0.6, 0.6), ORANGE)
    p.arrow((-0.9, 0, 0.75), (0.9, 0, 0.75), RED, True)


def cross_piece(p, at=(0, 0, 0)):
    p.cylinder(add(at, Y, -0.42), add(at, Y, 0.42), 0.07, GREY)
    p.cylinder(add(at, Z, -0.42), add(at, Z, 0.42), 0.07, GREY)


def universal(p, at=(0, 0, 0), front=True):
    p.box(add(at, X, -1.0), (0.7, 0.4, 0.4), BLUE)
    for side in (-1, 1):
        p.box(add(at, (-0.3, 0, side * 0.36)), (0.8, 0.2, 0.1), BLUE)
        p.box(add(at, (0.3, side * 0.36, 0)), (0.8, 0.1, 0.2), ORANGE)
    p.box(add(at, X, 1.0), (0.7, 0.4, 0.4), ORANGE)
    cross_piece(p, at)
    p.axis(add(at, Z, -0.9), add(at, Z, 1.0), RED)
    p.turn(add(at, Z, 0.8), Z, 0.25, RED)
    p.axis(add(at, Y, -1.1), add(at, Y, 1.1), GREEN)
    p.turn(add(at, Y, -0.9), Y, 0.25, GREEN)
    if front:
        p.dot_at(at)


def hinge2(p):
    p.box((-0.1, 0.75, 0.35), (1.5, 0.5, 0.3), BLUE, nearer=-0.3)
    p.cylinder((0, 0.6, 0), (0, -0.2, 0), 0.07, GREY, -0.1)
    p.cylinder((0, -0.15, 0), (0, -0.5, 0), 0.62, ORANGE)
    p.axis((0, 0.3, -0.6), (0, 0.3, 1.45), RED)
    p.turn((0, 0.3, 1.15), Z, 0.28, RED)
    p.arrow((0.35, 0.3, 0.6), (0.35, 0.3, 1.05), RED, True)
    p.axis((0, 0.9, 0), (0, -1.2, 0), GREEN)
    p.turn((0, -0.95, 0), Y, 0.25, GREEN)


def fixed(p):
    p.box((-0.55, 0, 0), (1.1, 0.6, 0.6), BLUE)
    p.box((0.55, 0, 0.25), (1.1, 0.6, 0.6), ORANGE)
    for z in (-0.1, 0.35):
        p.ball((0, -0.32, z), 0.08, GREY)


def amotor(p):
    p.box((-0.85, 0, 0), (0.7, 0.6, 0.6), BLUE)
    p.box((0.85, 0, 0), (0.7, 0.6, 0.6), ORANGE)
    for axis, colour in ((X, RED), (Y, GREEN), (Z, VIOLET)):
        sign = -1 if axis == Y else 1
        end = tuple(sign * 1.0 * a for a in axis) if axis != X else (0.45, 0, 0)
        p.axis((0, 0, 0), end, colour)
        p.turn(tuple(0.8 * e for e in end), axis, 0.22, colour)


def lmotor(p):
    p.box((-0.85, 0, 0), (0.6, 0.6, 0.6), BLUE)
    p.box((0.75, 0, 0), (0.6, 0.6, 0.6), ORANGE)
    for end, colour in (((0.75, 0, 1.2), VIOLET), ((0.75, -1.2, 0), GREEN), ((1.7, 0, 0), RED)):
        p.arrow((0.75, 0, 0), end, colour)


def plane2d(p):
    p.box((0, 0, -0.25), (2.4, 2.4, 0.06), WORLD, nearer=-2)
    p.box((0, 0, 0.05), (0.8, 0.6, 0.5), BLUE)
    p.arrow((0.5, 0, 0.05), (1.15, 0, 0.05), RED, True)
    p.arrow((0, -0.4, 0.05), (0, -1.05, 0.05), GREEN, True)
    p.turn((0, 0, 0.75), Z, 0.3, VIOLET)


def pr(p):
    p.box((0, 0, -0.55), (2.2, 0.5, 0.3), BLUE)
    p.box((0.1, 0, -0.25), (0.5, 0.4, 0.3), GREY)
    p.cylinder((0.1, 0.3, 0.05), (0.1, -0.3, 0.05), 0.09, GREY)
    tilt = (unit((1, 0, 1)), Y, unit((-1, 0, 1)))
    p.box((0.5, 0, 0.45), (1.2, 0.3, 0.25), ORANGE, tilt)
    p.arrow((-0.9, -0.45, -0.1), (0.9, -0.45, -0.1), RED, True)
    p.axis((0.1, 0.9, 0.05), (0.1, -1.2, 0.05), GREEN)
    p.turn((0.1, -0.95, 0.05), Y, 0.25, GREEN)


def pu(p):
    p.cylinder((-1.5, 0, 0), (-0.6, 0, 0), 0.07, GREY, -0.1)
    universal(p, (0.35, 0, 0))
    p.arrow((-1.35, 0, 0.42), (-0.35, 0, 0.42), VIOLET, True)


def piston(p):
    p.cylinder((-1.3, 0, 0), (0.1, 0, 0), 0.34, BLUE)
    p.cylinder((0.1, 0, 0), (0.8, 0, 0), 0.12, GREY, 0.1)
    p.cylinder((0.8, 0, 0), (1.3, 0, 0), 0.34, ORANGE)
    p.arrow((-0.6, 0, 0.65), (0.9, 0, 0.65), RED, True)
    p.axis((-1.7, 0, 0), (1.75, 0, 0), GREEN)
    p.turn((0.45, 0, 0), X, 0.3, GREEN)


def dball(p):
    p.box((-1.0, 0, -0.35), (0.7, 0.5, 0.5), BLUE)
    p.box((1.0, 0, 0.35), (0.7, 0.5, 0.5), ORANGE)
    p.cylinder((-0.6, -0.25, -0.1), (0.6, -0.25, 0.5), 0.05, GREY, 0.6)
    p.ball((-0.6, -0.25, -0.1), 0.11, GREY, 0.8)
    p.ball((0.6, -0.25, 0.5), 0.11, GREY, 0.8)


def dhinge(p):
    p.box((-1.0, 0, -0.45), (0.7, 0.7, 0.35), BLUE)
    p.box((1.0, 0, 0.2), (0.7, 0.7, 0.35), ORANGE)
    for side in (-0.42, 0.42):
        p.cylinder((-0.75, side, -0.35), (0.75, side, 0.35), 0.05, GREY, 0.3 if side < 0 else -0.3)
    for at in ((-0.75, 0, -0.35), (0.75, 0, 0.35)):
        p.cylinder(add(at, Y, 0.5), add(at, Y, -0.5), 0.09, GREY, 0.3)
        p.axis(add(at, Y, 0.7), add(at, Y, -1.0), RED)
    p.turn((-0.75, -0.8, -0.35), Y, 0.22, RED)
    p.turn((0.75, -0.8, 0.35), Y, 0.22, RED)


def wheel(p, centre, radius, colour, teeth):
    p.cylinder(add(centre, Y, 0.14), add(centre, Y, -0.14), radius, colour)
    for i in range(teeth):
        angle = 2 * math.pi * i / teeth
        out = (math.cos(angle), 0, math.sin(angle))
        p.box(add(centre, out, radius + 0.05), (0.12, 0.28, 0.11), colour, (out, Y, cross(out, Y)), -0.05)


def transmission(p):
    wheel(p, (-0.75, 0, 0), 0.7, BLUE, 18)
    wheel(p, (0.5, 0, 0), 0.42, ORANGE, 11)
    p.axis((-0.75, 0.3, 0), (-0.75, -0.9, 0), RED)
    p.turn((-0.75, -0.5, 0), Y, 0.3, RED)
    p.axis((0.5, 0.3, 0), (0.5, -0.9, 0), GREEN)
    p.turn((0.5, -0.5, 0), Y, 0.22, GREEN, 4.6, -4.2)


def contact(p):
    p.box((0, 0, -0.7), (2.3, 1.4, 0.3), ORANGE, nearer=-1)
    p.box((0, 0, -0.15), (0.9, 0.8, 0.8), BLUE)
    for x, y in ((-0.45, -0.4), (0.45, -0.4), (0.45, 0.4)):
        p.arrow((x, y, -0.55), (x, y, 0.15), RED)
        p.dot_at((x, y, -0.55))
    p.arrow((0.45, -0.4, -0.55), (1.0, -0.4, -0.55), GREEN)
    p.arrow((0.45, -0.4, -0.55), (0.45, -0.85, -0.55), VIOLET)


PICTURES = {"ball": ball, "hinge": hinge, "slider": slider, "universal": universal, "hinge2": hinge2, "fixed": fixed,
            "amotor": amotor, "lmotor": lmotor, "plane2d": plane2d, "pr": pr, "pu": pu, "piston": piston, "dball": dball,
            "dhinge": dhinge, "transmission": transmission, "contact": contact}


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    old = []
    for name, draw in PICTURES.items():
        picture = Picture()
        draw(picture)
        file, text = FOLDER / f"joint_{name}.svg", picture.svg(name)
        if "--check" not in sys.argv:
            file.write_text(text, encoding="utf-8")
        elif not file.exists() or file.read_text(encoding="utf-8") != text:
            old.append(file)
    for file in old:
        print(f"{file}: is not what tools/joint_pictures.py draws")
    print(f"{len(PICTURES)} pictures, {len(old)} of them old")
    return bool(old)


if __name__ == "__main__":
    sys.exit(main())
