# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Robots built and edited in Python: links, joints, geoms, actuators, sensors, sites, tendons, couplings.

>>> import epode
>>> arm = epode.robot.Description("arm")
>>> upper = arm.add_link("upper", position=(0, 0, 1))
>>> shoulder = upper.add_joint("shoulder", axis=(0, 1, 0), limits=(-2, 2), damping=0.1)
>>> rod = upper.add_geom(epode.Capsule(0.03, 0.4), position=(0, 0, -0.2), mass=1)
>>> lower = upper.add_link("lower", position=(0, 0, -0.4))
>>> elbow = lower.add_joint("elbow", axis=(0, 1, 0))
>>> ball = lower.add_geom(epode.Sphere(0.05), position=(0, 0, -0.3), mass=0.5)
>>> servo = arm.add_actuator("servo", "position", joint=elbow, kp=40, kv=4)
>>> arm.model()
<epode.robot.Model 'arm': 2 links, 2 joints>

``Model.edit`` makes a description of a model, ``Description.model`` compiles it again:

>>> arm.joints["elbow"].axis = (1, 0, 0)
>>> arm.links["lower"].remove()
["actuator 'servo'"]
>>> arm.scale(2).model().links[1].mass
8.0

A description is MJCF: ``element["solref"] = ...`` sets what has no property here, and ``text()`` is what other programs read.
Angles are rad, poses are those of link frames, and there are no default classes. What is wrong is refused when it is compiled,
in a sentence that names the element.
"""
from ._acting import Actuator, Coupling, Exclusion, Loop, Sensor, Tendon
from ._description import Description
from ._geoms import Geom, MeshAsset
from ._links import Joint, Link, Site
from ._part import Part, Placed
from ._starts import Start
from ._tree import Element
from ._values import Elements

__all__ = ["Actuator", "Coupling", "Description", "Element", "Elements", "Exclusion", "Geom", "Joint", "Link", "Loop", "MeshAsset", "Part",
           "Placed", "Sensor", "Site", "Start", "Tendon"]
