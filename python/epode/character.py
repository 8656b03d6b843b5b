# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Characters: geoms that walk."""
from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING

from numpy.typing import ArrayLike

from . import c
from ._handle import FloatArray, Value, flag_of, number_of, settable, three, vector_of
from .enums import CharacterState
from .geom import Geom
from .shapes import Box, Capsule, Cylinder, Shape

if TYPE_CHECKING:
    from .body import Body
    from .world import World

Filter = Callable[[Geom, FloatArray], bool]
_SHAPES: dict[str, tuple[int, Callable[[float, float], Shape]]] = {
    "capsule": (c.dCapsuleClass, lambda r, h: Capsule(r, h - 2 * r)),
    "cylinder": (c.dCylinderClass, lambda r, h: Cylinder(r, h)),
    "box": (c.dBoxClass, lambda r, h: Box(2 * r, 2 * r, h))}


def _settings(self: Character) -> c.dCharacterSettings:
    given = c.dCharacterSettings()
    c.dCharacterGetSettings(self._handle, given)
    return given


def _report(self: Character) -> c.dCharacterReport:
    report = c.dCharacterReport()
    c.dCharacterGetReport(self._handle, report)
    return report


def _setting(name: str, doc: str) -> Value[float, float]:
    def put(self: Character, value: float) -> None:
        given = _settings(self)
        setattr(given, name, value)
        c.dCharacterSetSettings(self._handle, given, self._asked)
    return Value(lambda self: float(getattr(_settings(self), name)), put, doc=doc)


class Character(Geom):
    """A character, made by ``World.character``: an upright capsule, cylinder or box without a body that walks as the program says. It
    is a geom, whose ``position`` is that of its middle. Call ``walk`` or ``move`` once after each step of the world: what
    carries it has moved then."""

    __slots__ = ("_filter",)
    _filter: Filter | None

    def __init__(self, world: World, handle: c.dGeomID, shape: Shape, body: Body | None = None) -> None:
        """As ``World.character`` does: handle is a character in the world, of the shape; body: that it is on, if any."""
        super().__init__(world, handle, shape, body)
        self._filter = None

    @classmethod
    def _new(cls, world: World, shape: str, radius: float, height: float, up: ArrayLike) -> Character:
        if shape not in _SHAPES:
            raise ValueError(f"no character is a {shape!r}: {', '.join(_SHAPES)}")
        given = c.dCharacterSettings()
        given.shape, described = _SHAPES[shape]
        given.radius, given.height = radius, height
        given.up = three(up, "up")
        return cls(world, c.dCharacterCreate(world._space, given), described(radius, height))

    gravity = _setting("gravity", "Of ``walk``, m/s^2; 9.81 at first.")
    skin = _setting("skin", "The gap that it keeps, m; 0.01 at first.")
    slope_limit = _setting("slope_limit", "The steepest ground that it can stand on, rad; 0.87 at first.")
    step_height = _setting("step_height", "Of steps that it climbs, m; 0.3 at first.")
    stick_distance = _setting("stick_distance", "How far down it follows ground that falls away, m; 0.3 at first.")
    mass = _setting("mass", "Weighs with ``gravity`` on bodies that it stands on, kg; 70 at first.")
    max_force = _setting("max_force", "That it pushes bodies with, N; 500 at first.")
    air_acceleration = _setting("air_acceleration", "Of ``walk``, how fast it turns in the air, m/s^2; 10 at first.")

    @property
    def radius(self) -> float:
        """m; of a box, half the side of its square base."""
        return float(_settings(self).radius)

    @property
    def height(self) -> float:
        """m, from the feet to the top."""
        return float(_settings(self).height)

    @property
    def up(self) -> FloatArray:
        """The direction that is up for it."""
        return _settings(self).up

    @property
    def filter(self) -> Filter | None:
        """function(other, velocity) that says whether it collides with another geom in a move; None: with all. For one-way platforms
        and to drop through them. Clones of the world have it, pickles and files do not."""
        return self._filter

    @filter.setter
    def filter(self, function: Filter | None) -> None:
        if function is not None and not callable(function):
            raise TypeError(f"a function of (other, velocity), or None, is expected, not {function!r}")
        before, self._filter = self._filter, function
        try:
            c.dCharacterSetSettings(self._handle, _settings(self), self._asked)
        except BaseException:
            self._filter = before
            raise

    @property
    def _asked(self) -> Callable[[c.dGeomID, c.dGeomID, FloatArray], bool] | None:
        """The filter as the library calls it; what the library keeps must not keep the world."""
        called = self._filter
        if called is None:
            return None
        world = weakref.ref(self.world)

        def touches(_: c.dGeomID, other: c.dGeomID, velocity: FloatArray) -> bool:
            me = world()
            geom = None if me is None else me._geoms.get(other.id)
            return geom is None or called(geom, velocity)
        return touches

    # ---- moves ----

    def walk(self, velocity: ArrayLike, h: float, *, jump: float = 0.0) -> CharacterState:
        """Walk for a step of h seconds with gravity, falls and jumps. velocity: how it wants to go, relative to the ground, m/s. jump:
        a speed, m/s, above 0 lets it jump if it stands."""
        return CharacterState(c.dCharacterWalk(self._handle, three(velocity, "velocity"), jump, h))

    def move(self, velocity: ArrayLike, h: float) -> CharacterState:
        """Move for a step of h seconds with a velocity that the program has worked out, gravity included, m/s."""
        return CharacterState(c.dCharacterMove(self._handle, three(velocity, "velocity"), h))

    def set_height(self, height: float) -> bool:
        """Crouch, or stand up: change the height, m, while the feet stay. False, and nothing changes: there is no room above."""
        return bool(c.dCharacterSetHeight(self._handle, height))

    @property
    def feet(self) -> FloatArray:
        """Where its feet are, m. Setting it puts them there, whatever is there."""
        return c.dCharacterGetPosition(self._handle)[1]

    @feet.setter
    def feet(self, value: ArrayLike) -> None:
        c.dCharacterSetPosition(self._handle, *three(value, "feet"))

    @property
    def velocity(self) -> FloatArray:
        """How it has moved in the last move, m/s. Setting it is a blow, or a spring board: ``walk`` goes on from it."""
        return c.dCharacterGetVelocity(self._handle)[1]

    @velocity.setter
    def velocity(self, value: ArrayLike) -> None:
        c.dCharacterSetVelocity(self._handle, three(value, "velocity"))

    # ---- what the last move has done ----

    @property
    def state(self) -> CharacterState:
        """What it stands on."""
        return CharacterState(_report(self).state)

    @property
    def on_ground(self) -> bool:
        """Whether it stands."""
        return self.state == CharacterState.ON_GROUND

    @property
    def ground(self) -> Geom | None:
        """The geom that it stands on or slides on; None: none that Python knows."""
        found = _report(self).ground
        return None if found is None else self.world.geom_of(found.id)

    ground_position = vector_of(_report, "ground_pos", "Where it touches the ground, m.")
    ground_normal = vector_of(_report, "ground_normal", "Of the ground's face, a unit vector.")
    ground_velocity = vector_of(_report, "ground_velocity", "Of the ground where it stands, m/s.")
    turn = number_of(_report, "turn", "Angle by which the ground has turned it, about up, rad.")
    climbed = number_of(_report, "climbed", "Height of the steps that it has climbed, m.")
    overlap = number_of(_report, "overlap", "Depth that it could not be freed from, m.")
    hit_wall = flag_of(_report, "hit_wall", "Whether something steep was in its way.")
    hit_ceiling = flag_of(_report, "hit_ceiling", "Whether something above was.")

    def report(self) -> c.dCharacterReport:
        """All of that by one call."""
        return _report(self)


SETTINGS = settable(Character, Geom)  # of World.character
