# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A description made s times as large. Lengths grow by s, masses by s^3, inertias by s^5. So that motion under the same gravity is the
same, times must grow by s^(1/2), forces by s^3, torques by s^4. With D = 1 for what is a length (slides, strings) and 0 for an angle:

    coordinate s^D, force along it s^(4-D), stiffness s^(4-2D), damping s^(4.5-2D), rotor s^(5-2D)."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ._acting import Actuator, Tendon
from ._links import Joint
from ._tree import Element

if TYPE_CHECKING:
    from ._description import Description

# Powers of what elements of a tag have, number by number (the last one for all further numbers).
LENGTHS: dict[str, dict[str, Sequence[float]]] = {
    "body": {"pos": [1]}, "inertial": {"pos": [1], "mass": [3], "diaginertia": [5], "fullinertia": [5]},
    "geom": {"pos": [1], "size": [1], "mass": [3], "friction": [0, 1, 1], "margin": [1], "gap": [1]},
    "site": {"pos": [1], "size": [1]}, "camera": {"pos": [1]}, "light": {"pos": [1]}, "mesh": {"scale": [1]}, "hfield": {"size": [1]},
    "connect": {"anchor": [1]}, "weld": {"relpose": [1, 1, 1, 0], "anchor": [1], "torquescale": [1]}}
SOFTNESS: dict[str, Sequence[float]] = {"solref": [0.5, 0], "solreflimit": [0.5, 0], "solimp": [0, 0, 1, 0], "solimplimit": [0, 0, 1, 0]}


def scale(description: Description, factor: float, forces: bool) -> None:
    """See Description.scale."""
    if not (np.isfinite(factor) and factor > 0):
        raise ValueError(f"a factor above 0 is expected: {factor!r}")
    size = Sizes(description, factor, forces)
    for one in list(description._top.walk()):
        size.change(one)
    size.change_starts()


class Sizes:
    """Which powers of the factor change what."""

    def __init__(self, description: Description, factor: float, forces: bool) -> None:
        self.description, self.factor, self.forces = description, factor, forces
        self.slides = {joint.name for joint in description.joints if joint.kind == "slide"}
        self.strings = {tendon.name: self.is_length(tendon) for tendon in description.tendons}

    def times(self, element: Element, word: str, powers: Sequence[float]) -> None:
        """Multiply an attribute's numbers."""
        if element[word] is not None:
            numbers = element.numbers(word)
            p = np.array([powers[min(i, len(powers) - 1)] for i in range(len(numbers))])
            element[word] = numbers * self.factor ** p

    def is_length(self, tendon: Tendon) -> bool:
        """Of a string, or of slides alone."""
        return tendon.tag == "spatial" or all(joint in self.slides for joint in tendon.joints)

    def change(self, one: Element) -> None:
        """An element by its kind."""
        if one.tag in LENGTHS and one.section in ("worldbody", "asset", "equality"):
            if not (one.tag == "weld" and not one.numbers("relpose", (0, 0, 0, 0)).any()):
                for word, powers in LENGTHS[one.tag].items():
                    self.times(one, word, powers)
        if one.tag == "mesh" and one.section == "asset" and one["scale"] is None:
            one["scale"] = (self.factor, self.factor, self.factor)
        if isinstance(one, Joint):
            self.change_axis(one, one.kind == "slide", 0 if one.kind == "free" else 1)
        elif isinstance(one, Tendon):
            self.change_tendon(one)
        elif isinstance(one, Actuator):
            self.change_actuator(one)
        elif one.section == "equality" and one["polycoef"] is not None:
            self.change_coupling(one)
        if self.forces:
            for word, powers in SOFTNESS.items():
                if one[word] is not None and not (word.startswith("solref") and one.numbers(word)[0] <= 0):
                    self.times(one, word, powers)

    def change_axis(self, one: Element, is_length: bool, anchors: int) -> None:
        """A joint, or what is along a tendon."""
        d = float(is_length)
        self.times(one, "pos", [anchors])
        for word in ("range", "ref", "springref", "springlength", "margin"):
            self.times(one, word, [d])
        self.times(one, "armature", [5 - 2 * d])
        if self.forces:
            if isinstance(one, Joint) and np.isfinite(one.max_velocity):
                one.max_velocity *= self.factor ** (d - 0.5)
            for word, power in (("stiffness", 4 - 2 * d), ("damping", 4.5 - 2 * d), ("frictionloss", 4 - d), ("actuatorfrcrange", 4 - d),
                                ("springdamper", 0.5)):
                self.times(one, word, [power, 0] if word == "springdamper" else [power])

    def change_tendon(self, tendon: Tendon) -> None:
        """Where hinges and slides are in one sum, the sum stays an angle."""
        if not self.strings[tendon.name]:
            for term in tendon.children:
                if term["joint"] in self.slides:
                    term["coef"] = term.numbers("coef", [1]) / self.factor
        self.change_axis(tendon, self.strings[tendon.name], 1)
        self.times(tendon, "width", [1])

    def change_coupling(self, one: Element) -> None:
        """c_k of  q1 = sum c_k q2^k  becomes  c_k s^(D1 - k D2)."""
        first, second = one["joint1"] or one["tendon1"], one["joint2"] or one["tendon2"]
        lengths = {**dict.fromkeys(self.slides, True)} if one["joint1"] is not None else self.strings
        d1, d2 = float(lengths.get(first or "", False)), float(lengths.get(second or "", False))
        self.times(one, "polycoef", [d1 - k * d2 for k in range(5)])

    def power(self, actuator: Actuator) -> float:
        """D of what it acts on."""
        tendon = actuator["tendon"]
        return float(self.strings.get(tendon, True) if tendon is not None else actuator["joint"] in self.slides)

    def control_power(self, actuator: Actuator) -> float:
        """Of its control: what a servo follows is a coordinate or a rate."""
        d, gain, bias = self.power(actuator), actuator.numbers("gainprm", [1]), actuator.numbers("biasprm", [0])
        bias = np.concatenate([bias, np.zeros(3)])
        if actuator.tag == "position" or (actuator.tag == "general" and bias[1] != 0 and gain[0] == -bias[1]):
            return d
        is_speed = actuator.tag in ("velocity", "intvelocity") or (actuator.tag == "general" and bias[2] != 0 and gain[0] == -bias[2])
        return d - 0.5 if is_speed else 0.0

    def change_actuator(self, one: Actuator) -> None:
        """A motor by its gear, others by their gains."""
        d = self.power(one)
        force, spring, damper, control = 4 - d, 4 - 2 * d, 4.5 - 2 * d, self.control_power(one)
        self.times(one, "lengthrange", [d])
        if one.tag in ("position", "intvelocity"):
            self.times(one, "actrange", [d])
        if not self.forces:
            if one.tag == "position" or (one.tag == "general" and control == d):
                self.times(one, "ctrlrange", [control])
            return
        self.times(one, "ctrlrange", [control])
        if one.tag == "motor":
            one["gear"] = one.numbers("gear", [1]) * self.factor ** force
            return
        self.times(one, "forcerange", [force])
        one_gain = spring if control == d and one.tag == "general" and control else force - control
        gains: dict[str, Sequence[float]] = {"kp": [spring], "kv": [damper], "gainprm": [one_gain, one_gain - d, one_gain - d + 0.5],
                                             "biasprm": [force, spring, damper], "area": [force], "timeconst": [0.5], "dynprm": [0.5]}
        if one.tag == "muscle":
            gains = {"timeconst": [0.5]}
            if one.numbers("force", [-1])[0] > 0:
                gains["force"] = [force]
        for word, powers in gains.items():
            self.times(one, word, powers)
        if one.tag == "velocity" and one["kv"] is None or one.tag in ("position", "intvelocity") and one["kp"] is None:
            one["kv" if one.tag == "velocity" else "kp"] = self.factor ** (damper if one.tag == "velocity" else spring)

    def change_starts(self) -> None:
        """Lengths among coordinates and controls."""
        kinds = {joint.name: joint.kind for joint in self.description.joints}
        powers = {one.name: self.control_power(one) for one in self.description.actuators}
        for start in self.description.starts.values():
            for name, value in start.positions.items():
                if kinds.get(name) == "slide":
                    start.positions[name] = float(value) * self.factor
                elif kinds.get(name) == "free":
                    start.positions[name] = (*(self.factor * float(x) for x in value[:3]), *value[3:])
            for name in start.controls:
                power = powers.get(name, 0.0)
                if self.forces or power == 1:
                    start.controls[name] *= self.factor ** power
            start.mocap = {name: (tuple(self.factor * float(x) for x in p), q) for name, (p, q) in start.mocap.items()}
