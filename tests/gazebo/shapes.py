#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# Writes a world of N loose shapes above a plane, in a grid 100 wide: boxes, spheres, cylinders, capsules and ellipsoids in turn, 1.5 m
# apart, each 1 kg, a little turned. (After the idea of gz-sim's 3k_shapes.sdf, which has the five kinds in a grid.)
import math
import sys

WIDE = 100
KINDS = [("<box><size>1 1 1</size></box>", [1 / 6] * 3),
         ("<sphere><radius>0.5</radius></sphere>", [0.1] * 3),
         ("<cylinder><radius>0.5</radius><length>1</length></cylinder>", [0.145833, 0.145833, 0.125]),
         ("<capsule><radius>0.2</radius><length>0.6</length></capsule>", [0.074154, 0.074154, 0.018769]),
         ("<ellipsoid><radii>0.2 0.3 0.5</radii></ellipsoid>", [0.068, 0.058, 0.026])]


def model(number):
    geometry, moments = KINDS[number % len(KINDS)]
    x, y = 1.5 * (number % WIDE), 1.5 * (number // WIDE)
    roll, yaw = 0.2 * math.sin(number), 0.3 * math.cos(number)
    inertia = "".join(f"<i{axis}>{moment}</i{axis}>" for axis, moment in zip(("xx", "yy", "zz"), moments))
    return (f"<model name='m{number}'><pose>{x} {y} 1 {roll:.6f} 0 {yaw:.6f}</pose><link name='l'><inertial><mass>1</mass>"
            f"<inertia>{inertia}</inertia></inertial><collision name='c'><geometry>{geometry}</geometry></collision></link></model>")


count = int(sys.argv[1])
print("<?xml version='1.0'?><sdf version='1.9'><world name='shapes'><gravity>0 0 -9.8</gravity>"
      "<model name='ground'><static>true</static><link name='l'><collision name='c'><geometry><plane><normal>0 0 1</normal>"
      "<size>1000 1000</size></plane></geometry></collision></link></model>")
print("\n".join(model(i) for i in range(count)))
print("</world></sdf>")
