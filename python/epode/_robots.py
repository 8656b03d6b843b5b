# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Many robots of one model: arrays with a row for each."""
from __future__ import annotations

import typing
from collections.abc import Callable, Iterable, Iterator

import numpy as np
from numpy.typing import ArrayLike

from . import _c
from ._handle import FloatArray, Value
from ._robot_data import RobotContact, Touch
from .world import World, step_worlds

if typing.TYPE_CHECKING:
    from ._c import _Robot
    from .robot import Robot


class Robots:
    """Robots of one model, each in a world of its own or several in one, with arrays that have a row for each: one call
    reads or sets all."""

    __slots__ = ("model", "_robots", "__weakref__")
    __module__ = "epode.robot"

    def __init__(self, robots: Iterable[Robot]) -> None:
        """robots: at least one, all of one model: ``Robots(model.build() for _ in range(100))``."""
        from .robot import Robot
        self._robots: list[Robot] = list(robots) if isinstance(robots, Iterable) else []
        if not self._robots or not all(isinstance(robot, Robot) for robot in self._robots):
            raise ValueError("at least one robot, in a list, is expected: Robots([model.build(), model.build()])")
        if len({id(robot.model) for robot in self._robots}) > 1:
            raise ValueError("robots of one model are expected")
        self.model = self._robots[0].model

    def __len__(self) -> int:
        return len(self._robots)

    def __iter__(self) -> Iterator[Robot]:
        return iter(self._robots)

    def __getitem__(self, index: typing.SupportsIndex) -> Robot:
        return self._robots[index]

    @property
    def worlds(self) -> list[World]:
        """Their worlds, each once."""
        return list(dict.fromkeys(robot.world for robot in self._robots))

    @property
    def _live(self) -> list[_Robot]:
        return [robot._live for robot in self._robots]

    positions: Value[FloatArray, ArrayLike] = Value(
        lambda self: _c._many_positions(self._live),
        lambda self, value: _c._set_many_positions(self._live, self._rows(value, self.model.position_count)),
        doc="A row of ``Robot.positions`` for each robot.")
    velocities: Value[FloatArray, ArrayLike] = Value(
        lambda self: _c._many_velocities(self._live),
        lambda self, value: _c._set_many_velocities(self._live, self._rows(value, self.model.velocity_count)),
        doc="A row of ``Robot.velocities`` for each robot.")

    controls: Value[FloatArray, ArrayLike] = Value(
        lambda self: _c._many_controls(self._live),
        lambda self, value: _c._set_many_controls(self._live, self._rows(value, len(self.model.actuators))),
        doc="A row of ``Robot.controls`` for each robot.")

    def control(self, values: ArrayLike) -> None:
        """Set the controls of all actuators: a row for each robot, or one for all."""
        self.controls = values

    def reset(self, mask: ArrayLike | None = None) -> None:
        """``Robot.reset`` of those that the mask says, a bool for each, or of all."""
        chosen = np.ones(len(self), bool) if mask is None else np.asarray(mask, bool)
        if chosen.shape != (len(self),):
            raise ValueError(f"a mask of {len(self)} is expected, not {chosen.shape}")
        for robot, begins in zip(self._robots, chosen):
            if begins:
                robot.reset()

    def step(self, h: float, *, steps: int = 1, stepper: str | None = None, threads: int = 0) -> None:
        """Advance all worlds, each on a thread of its own (``epode.step_worlds``). stepper: None: as the first one's ``stepper`` says."""
        worlds = self.worlds
        step_worlds(worlds, h, stepper=worlds[0].stepper if stepper is None else stepper, steps=steps, threads=threads)

    def _each(self, read: Callable[[Robot], ArrayLike]) -> FloatArray:
        return np.stack([np.asarray(read(robot), float) for robot in self._robots])

    @property
    def forces(self) -> FloatArray:
        """A row of ``Robot.drive_forces`` for each robot."""
        return _c._many_drive_forces(self._live)

    @property
    def poses(self) -> FloatArray:
        """``Robot.poses`` of each robot: (robots, links, 7)."""
        return _c._many_link_poses(self._live).reshape(len(self), -1, 7)

    def pose(self, frame: str) -> tuple[FloatArray, FloatArray]:
        """Positions (robots, 3) and quaternions (robots, 4) of a frame in its world."""
        rows = self._each(lambda robot: np.concatenate(robot.pose(frame)))
        return rows[:, :3], rows[:, 3:]

    def jacobians(self, frame: str, point: ArrayLike = (0, 0, 0)) -> FloatArray:
        """``Robot.jacobian`` of each robot: (robots, 6, velocities)."""
        return self._each(lambda robot: robot.jacobian(frame, point))

    def mass_matrix(self) -> FloatArray:
        """``Robot.mass_matrix`` of each robot: (robots, velocities, velocities)."""
        return self._each(lambda robot: robot.mass_matrix())

    def bias_forces(self) -> FloatArray:
        """A row of ``Robot.bias_forces`` for each robot."""
        return self._each(lambda robot: robot.bias_forces())

    def apply(self, forces: ArrayLike) -> None:
        """``Robot.apply`` to each robot: a row for each, or one for all."""
        for robot, row in zip(self._robots, self._rows(forces, self.model.velocity_count)):
            robot.apply(row)

    @property
    def actuator_forces(self) -> FloatArray:
        """A row of ``Robot.actuator_forces`` for each robot."""
        return self._each(lambda robot: robot.actuator_forces)

    activations: Value[FloatArray, ArrayLike] = Value(
        lambda self: self._each(lambda robot: robot.activations), lambda self, value: self._set_activations(value),
        doc="A row of ``Robot.activations`` for each robot.")

    def _set_activations(self, value: ArrayLike) -> None:
        for robot, row in zip(self._robots, self._rows(value, len(self.model.actuators))):
            robot.activations = row

    @property
    def sensors(self) -> dict[str | int, FloatArray]:
        """``Robot.sensors`` with a row for each robot."""
        read = [robot.sensors for robot in self._robots]
        return {name: np.stack([one[name] for one in read]) for name in read[0] if all(name in one for one in read)}

    def sensor(self, sensor: str | int) -> FloatArray:
        """``Robot.sensor`` with a row for each robot."""
        return self._each(lambda robot: robot.sensor(sensor))

    def touch(self, link: str) -> Touch:
        """``Robot.touch`` of each robot: a ``Touch`` of arrays with a row for each."""
        points, normal, force, centre = zip(*(robot.touch(link) for robot in self._robots))
        return Touch(np.array(points), np.array(normal), np.array(force), np.array(centre))

    def contacts(self, link: str | None = None) -> list[list[RobotContact]]:
        """``Robot.contacts`` of each robot."""
        return [robot.contacts(link) for robot in self._robots]

    def rays(self, frame: str, directions: ArrayLike, max_distance: float = np.inf, pose: ArrayLike | None = None) -> FloatArray:
        """``Robot.rays`` of each robot: (robots, rays)."""
        return self._each(lambda robot: robot.rays(frame, directions, max_distance, pose))

    def _rows(self, value: ArrayLike, width: int) -> FloatArray:
        array = np.asarray(value, float)
        if array.shape not in ((width,), (len(self), width)):
            raise ValueError(f"an array ({len(self)}, {width}) or a row of {width} is expected, not {array.shape}")
        return np.broadcast_to(array, (len(self), width))
