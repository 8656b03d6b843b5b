# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What ragdolls, ropes and fractures share: bodies, joints and geoms of a world that belong together. They have no handle: they live as
long as what they are made of, and a copy of a world has them again by the numbers of their parts."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from . import c
from .body import Body
from .errors import DeadHandleError
from .geom import Geom
from .joint import Joint, type_of

if TYPE_CHECKING:
    from .shapes import Shape
    from .world import World


class Parts(NamedTuple):
    """The numbers of an assembly's bodies, joints and geoms among those of its world; None: one that was destroyed, or never was."""
    bodies: list[int | None]
    joints: list[int | None]
    geoms: list[int | None]


class Assembly:
    """Bodies, joints and geoms of a world that belong together."""

    __slots__ = ("world", "_bodies", "_joints", "_geoms", "__weakref__")

    def __init__(self, world: World, bodies: Sequence[Body | None], joints: Sequence[Joint | None], geoms: Sequence[Geom | None]) -> None:
        """As the world does: of the world, from bodies, joints and geoms, which may have been destroyed (None)."""
        self.world, self._bodies, self._joints, self._geoms = world, tuple(bodies), tuple(joints), tuple(geoms)

    @property
    def alive(self) -> bool:
        """Whether all of its bodies are there."""
        return all(body is not None and body.alive for body in self._bodies)

    def _must_live(self) -> None:
        if not self.alive:
            raise DeadHandleError(f"this {type(self).__name__}, or a body of it, has been destroyed")

    @property
    def bodies(self) -> tuple[Body, ...]:
        """Its bodies, in the order in which they were made."""
        return tuple(body for body in self._bodies if body is not None)

    @property
    def joints(self) -> tuple[Joint | None, ...]:
        """Its joints, in the order in which they were made; None: one that was not made."""
        return self._joints

    def destroy(self) -> None:
        """Destroy its joints, and its bodies with their geoms. What has been destroyed already is left out."""
        for one in (*self._joints, *self._bodies):
            if one is not None and one.alive:
                one.destroy()

    # ---- copies ----

    def _settings(self) -> tuple[Any, ...]:
        """What ``_again`` needs in addition to the parts."""
        return ()

    @classmethod
    def _again(cls, world: World, settings: tuple[Any, ...], bodies: list[Body | None], joints: list[Joint | None],
               geoms: list[Geom | None]) -> Self:
        return cls(world, bodies, joints, geoms)

    def _parts(self, bodies: dict[Body, int], joints: dict[Joint, int], geoms: dict[Geom, int]) -> Parts:
        def places(of: Iterable[Any], numbers: dict[Any, int]) -> list[int | None]:
            return [None if one is None else numbers.get(one) for one in of]
        return Parts(places(self._bodies, bodies), places(self._joints, joints), places(self._geoms, geoms))


Described = tuple[type[Assembly], tuple[Any, ...], Parts]  # of an assembly, by numbers


def describe(world: World) -> list[Described]:
    """The assemblies of a world."""
    bodies, joints, geoms = ({one: i for i, one in enumerate(group.values())} for group in (world._bodies, world._joints, world._geoms))
    return [(type(one), one._settings(), one._parts(bodies, joints, geoms)) for one in world._assemblies if one.alive]  # type: ignore[arg-type]


def assemble(world: World, described: list[Described]) -> None:
    """Give a copy of a world the assemblies of the original."""
    def found(group: dict[Any, Any], places: list[int | None]) -> list[Any]:
        ordered = list(group.values())
        return [None if i is None else ordered[i] for i in places]
    for kind, settings, parts in described:
        one = kind._again(world, settings, found(world._bodies, parts.bodies), found(world._joints, parts.joints),
                          found(world._geoms, parts.geoms))
        world._assemblies.append(one)


def adopt_bodies(world: World, handles: Sequence[c.dBodyID], shape_of: Callable[[int], Shape]) -> list[Body]:
    """Objects for new bodies of the library with a geom each, the i-th of shape_of(i)."""
    bodies = []
    for i, handle in enumerate(handles):
        body = world._bodies[handle] = Body(world, handle)
        geom = c.dBodyGetFirstGeom(handle)
        assert geom is not None
        body.geoms.append(Geom(world, geom, shape_of(i), body))
        world._geoms[geom.id] = body.geoms[0]
        bodies.append(body)
    world._body_list = None
    world._edition += 1
    return bodies


def adopt_joints(world: World, bodies: Sequence[Body]) -> list[Joint]:
    """Objects for the joints of new bodies, in the order in which the library has made them."""
    new = {body._handle for body in bodies}
    joints, every = [], c.dWorldGetJoints(world._handle)
    for handle in (every[i] for i in range(len(every))):
        ends = [c.dJointGetBody(handle, side) for side in (0, 1)]
        if handle not in world._joints and not new.isdisjoint(ends):
            body1, body2 = (None if end is None else world._bodies.get(end) for end in ends)
            joint = world._joints[handle] = Joint(world, handle, type_of(handle), body1, body2)
            joints.append(joint)
    return joints
