# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What Python knows of a world in addition to the library: to take steps back, and for copies."""
from __future__ import annotations

import typing

from . import c
from ._assembly import Described, describe
from .body import Body
from .geom import Geom
from .joint import Joint, type_of
from .shapes import LoadedShape, Shape

if typing.TYPE_CHECKING:
    from ._handle import FloatArray
    from .robot import Robot
    from .world import World


class Structure:
    """The objects of a world and their handles after a step."""

    __slots__ = ("edition", "handles", "riders")

    def __init__(self, world: World) -> None:
        self.edition = world._edition
        self.handles: list[tuple[Body | Joint | Geom, typing.Any]] = [
            (one, one._live) for group in (world._bodies, world._joints, world._geoms) for one in group.values()]
        self.riders = [list(body.geoms) for body in world._bodies.values()]

    def restore(self, world: World) -> None:
        """Make the world's objects what they were."""
        for group in (world._bodies, world._joints, world._geoms):
            for one in group.values():
                one._live = None
            group.clear()
        world._body_list = None
        self.edition = world._edition = world._edition + 1
        for one, handle in self.handles:
            one._live = handle
            if isinstance(one, Body):
                world._bodies[handle] = one
            elif isinstance(one, Joint):
                world._joints[handle] = one
            else:
                world._geoms[one._key] = one
                one.body = None
        for body, riders in zip(world._bodies.values(), self.riders):
            body.geoms = list(riders)
            for geom in riders:
                geom.body = body


class Past(typing.NamedTuple):
    """What there was after a step: objects, and the numbers of robots (``_robot_states``)."""
    structure: Structure
    robots: list[tuple[Robot, FloatArray]]


class Description:
    """What Python knows of a world in addition to the library: types of joints, shapes, and who belongs to whom, by number."""

    def __init__(self, world: World) -> None:
        number = {body: i for i, body in enumerate(world._bodies.values())}

        def place(body: Body | None) -> int | None:
            return None if body is None else number.get(body)
        self.stepper = world.stepper
        self.joints: list[tuple[str, int | None, int | None]] = [(joint.type, place(joint.body1), place(joint.body2)) for joint in world._joints.values()]
        self.geoms: list[tuple[Shape, int | None]] = [(geom.shape, place(geom.body)) for geom in world._geoms.values()]
        self.assemblies: list[Described] = describe(world)

    @classmethod
    def of_handles(cls, bodies: list[c.dBodyID], joints: list[c.dJointID], geoms: list[c.dGeomID]) -> Description:
        """Of a world that Python knows nothing of."""
        self = cls.__new__(cls)
        number = {body: i for i, body in enumerate(bodies)}

        def place(body: c.dBodyID | None) -> int | None:
            return None if body is None else number.get(body)
        self.stepper = "exact"
        self.joints = [(type_of(joint), place(c.dJointGetBody(joint, 0)), place(c.dJointGetBody(joint, 1))) for joint in joints]
        self.geoms = [(LoadedShape(), place(c.dGeomGetBody(geom))) for geom in geoms]
        self.assemblies = []
        return self
