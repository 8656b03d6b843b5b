# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Many copies of one robot, stepped side by side in the lanes of the machine's registers.

>>> import epode
>>> model = epode.robot.from_text('''<mujoco><worldbody><geom type="plane" size="9 9 1"/>
... <body pos="0 0 1"><freejoint/><geom size="0.1"/></body></worldbody></mujoco>''')
>>> batch = epode.Batch(model, 1000, stepsize=0.005)
>>> qpos = batch.bind("qpos")
>>> batch.step(400)
>>> bool(abs(qpos[:, 2] - 0.1).max() < 1e-3)
True
"""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _c
from ._poses import _moved, _unknown, _vector
from .errors import RefusedError
from .recording import Recording
from .robot import Model
from .world import World

_QUANTITIES = ("qpos", "qvel", "ctrl", "applied", "forces", "bad", "residual", "sweeps", "act",
               "xpos", "xquat", "cvel", "cinert", "cfrc_ext", "com", "qfrc_actuator", "qfrc_constraint", "sensordata")
_AXES = ("link", "world", "upright")
_PARAMETERS = ("gravity", "mass", "friction", "armature", "damping", "stiffness", "gain", "terrain", "torsional_friction",
               "rolling_friction")
_METHODS = ("differences", "exact")


def _number_in(names: tuple[str, ...], name: str, what: str) -> int:
    if name not in names:
        raise ValueError(f"no {what} is called {name!r}: {', '.join(names)}")
    return names.index(name)


class _Film:
    """Robots that stand where copies of a batch are, in a world that is never stepped."""

    def __init__(self, batch: Batch, copies: list[int], spacing: float, title: str) -> None:
        self._copies, self._world = copies, World()
        side = max(1, int(np.ceil(np.sqrt(len(copies)))))
        places = [(spacing * (i % side), spacing * (i // side), 0.0) for i in range(len(copies))]
        self._robots = [batch.model.build(self._world, position=place) for place in places]
        self._put(batch)
        self.recording = Recording(self._world, title or batch.model.name)

    @property
    def is_running(self) -> bool:
        return self.recording._world is not None

    def take(self, batch: Batch, time: float) -> None:
        self._put(batch)
        self.recording._take(time, 0.0)

    def _put(self, batch: Batch) -> None:
        qpos, qvel = batch._on_the_ground(), batch.read("qvel").astype(float)
        for copy, robot in zip(self._copies, self._robots, strict=True):
            robot.positions, robot.velocities = qpos[copy], qvel[copy]


class Batch:
    """n copies of a model. Arrays have a row for each copy: qpos and qvel are coordinates and velocities as the model's ``joints``
    number them, ctrl the actuators' controls, act the activations of those with a filter, applied forces along the velocities; forces
    (of contact points, limits, dry friction, servos, couplings, tendons), bad (1: the copy left the finite and waits for its reset),
    residual and sweeps of the last step can only be read.

    So can what follows from them, under MuJoCo's names, a link's numbers side by side: xpos and xquat of links, cvel and cinert about
    the centre of mass of their tree, com of all; qfrc_actuator in this state; cfrc_ext on links and qfrc_constraint of the last step;
    sensordata of the sensors that the file names, whose places ``sensors`` has."""

    def __init__(self, model: Model, copies: int, *, dtype: Literal["float32", "float64"] = "float32", threads: int = 0,
                 stepsize: float | None = None, erp: float = 0.2, max_correction: float = 2.0, reach: float = 0.005, tolerance: float = 0.0,
                 max_sweeps: int = 200, pinned: bool = False) -> None:
        """So many copies of a model, at its reference, at rest.

        dtype: "float32" or "float64". threads: 0 for as many as the machine has. stepsize: s; None: the file's, or 0.002 where it
        does not say. erp, max_correction: the share of an overlap that a step takes back, and how fast, m/s. reach: surfaces nearer
        than this, m, are looked at. tolerance: sweeps end when the last one changed no speed by more, m/s; 0: 1e-5 in floats, 1e-6 in
        doubles. max_sweeps: of a step. pinned: each thread but the caller's stays on a processor of its own, where the system can."""
        if not isinstance(model, Model):
            raise TypeError(f"a Model, as epode.load returns it, is expected, not {model!r}")
        self.dtype = np.dtype(dtype)
        if self.dtype not in (np.dtype("float32"), np.dtype("float64")):
            raise ValueError(f"float32 or float64 is expected, not {self.dtype}")
        if stepsize is None:
            stepsize = model.stepsize or 0.002
        options = {"stepsize": stepsize, "erp": erp, "max_correction": max_correction, "reach": reach, "tolerance": tolerance,
                   "max_sweeps": max_sweeps, "pinned": pinned}
        self.model = model
        self.stepsize = stepsize
        self._arguments = {**options, "dtype": str(self.dtype), "threads": threads}
        try:
            self._batch = _c._Batch(model._model, copies, self.dtype.itemsize == 8, threads, options)
        except ValueError as problem:
            raise RefusedError(str(problem)) from None
        self._bound: dict[str, NDArray[Any]] = {}
        self._films: list[_Film] = []

    def __repr__(self) -> str:
        return f"<Batch of {self.copies} {self.model.name!r}, {self.dtype}, {self.threads} threads>"

    def __reduce__(self) -> Any:
        raise TypeError("a batch cannot be pickled: pickle its arrays (read) and make another one")

    @property
    def copies(self) -> int:
        """How many there are."""
        return self._batch.copies

    @property
    def threads(self) -> int:
        """How many threads step, the caller's included."""
        return self._batch.threads

    @property
    def bad(self) -> int:
        """How many copies are bad."""
        return self._batch.bad

    def size(self, name: str) -> int:
        """How many numbers of the quantity a copy has."""
        return self._batch.size(_number_in(_QUANTITIES, name, "quantity"))

    def bind(self, name: str) -> NDArray[Any]:
        """The live array (copies, size) of a quantity: steps and resets write it, and steps first read qpos, qvel, ctrl, applied and act."""
        if name not in self._bound:
            array = np.empty((self.copies, self.size(name)), self.dtype)
            self._batch.bind(_QUANTITIES.index(name), array)
            self._bound[name] = array
        return self._bound[name]

    @property
    def sensors(self) -> dict[str | int, slice]:
        """Where each sensor of the file stands in a row of sensordata: by its name, or its number if it has none. Those that a batch
        does not compute are not there."""
        out: dict[str | int, slice] = {}
        for number, sensor in enumerate(self.model.sensors):
            first, values = self._batch.sensor(number)
            if values > 0:
                out[sensor.name or number] = slice(first, first + values)
        return out

    def sensor(self, sensor: str | int) -> NDArray[Any]:
        """A live view (copies, values) of a sensor's columns of sensordata, which is bound. By name, or number in the file."""
        places = self.sensors
        name = self.model.sensors[sensor].name or sensor if isinstance(sensor, int) else sensor
        if name not in places:
            for its in self.model.sensors:
                if its.name and its.name == name:
                    raise RefusedError(f"the sensor {name!r}: a batch does not compute sensors of kind {its.kind}, or not on {its.object!r}")
            raise ValueError(f"no sensor that a batch computes is called {sensor!r}: {', '.join(map(str, places))}")
        return self.bind("sensordata")[:, places[name]]

    def read(self, name: str) -> NDArray[Any]:
        """A new array (copies, size)."""
        array = np.empty((self.copies, self.size(name)), self.dtype)
        self._batch.read(_QUANTITIES.index(name), 0, self.copies, array)
        return array

    def write(self, name: str, values: ArrayLike) -> None:
        """Sets qpos, qvel, ctrl, applied or act of all copies: (copies, size), or a row for all."""
        number, size = _number_in(_QUANTITIES, name, "quantity"), self.size(name)
        array = self._rows(values, size)
        self._batch.write(number, 0, self.copies, array)
        if name in self._bound:
            self._batch.read(number, 0, self.copies, self._bound[name])

    def _rows(self, values: ArrayLike, size: int) -> NDArray[Any]:
        given = np.asarray(values, self.dtype)
        if given.shape not in ((self.copies, size), (size,)):
            raise ValueError(f"an array ({self.copies}, {size}) or a row of {size} is expected, not {given.shape}")
        return np.array(np.broadcast_to(given, (self.copies, size)), order="C")

    def get(self, parameter: str) -> NDArray[Any]:
        """A new array (copies, size) of gravity, mass, friction (of pairs of shapes), armature, damping, stiffness, gain, terrain
        (by how much all that stands still is moved), torsional_friction or rolling_friction (of pairs, m)."""
        number = _number_in(_PARAMETERS, parameter, "parameter")
        array = np.empty((self.copies, self._batch.parameter_size(number)), self.dtype)
        self._batch.read_parameter(number, 0, self.copies, array)
        return array

    def set(self, parameter: str, values: ArrayLike) -> None:
        """Gives each copy such numbers of its own: (copies, size), or a row for all."""
        number = _number_in(_PARAMETERS, parameter, "parameter")
        array = self._rows(values, self._batch.parameter_size(number))
        self._batch.write_parameter(number, 0, self.copies, array)

    def step(self, steps: int = 1) -> None:
        """Advance all copies. Other threads go on meanwhile; Ctrl-C ends it between two steps."""
        self._batch.step(steps)
        self._take(steps)

    def _take(self, steps: int) -> None:
        """What is recorded after so many steps."""
        self._films = [film for film in self._films if film.is_running]
        for film in self._films:
            film.take(self, steps * self.stepsize)

    def reset(self, mask: ArrayLike | None = None) -> None:
        """Puts copies back to the reference, at rest: those that the mask says, or all."""
        self._batch.reset(None if mask is None else np.ascontiguousarray(mask, bool))

    def rays(self, link: int | str, directions: ArrayLike, *, origins: ArrayLike | None = None,
             axes: Literal["link", "world", "upright"] = "link", max_distance: float = np.inf,
             shapes: NDArray[np.int32] | None = None) -> NDArray[Any]:
        """Distances (copies, rays) from a link of each copy to the nearest shape that is not its own, infinite where none is.

        directions and origins: (rays, 3), from the link's origin, in the link's axes, in the world's, or upright: z up, x where the
        link's x heads, as scans of heights want it. shapes: an array (copies, rays) that gets which shape of the model was hit, or -1."""
        if isinstance(link, str) and link not in self.model.link_names:
            raise KeyError(_unknown(link, self.model.link_names, "link"))
        number = self.model.link_names.index(link) if isinstance(link, str) else link
        ways = np.ascontiguousarray(directions, float)
        starts = np.zeros_like(ways) if origins is None else np.ascontiguousarray(origins, float)
        if ways.ndim != 2 or ways.shape[1] != 3 or starts.shape != ways.shape:
            raise ValueError(f"directions and origins (rays, 3) are expected, not {ways.shape} and {starts.shape}")
        if not (np.isfinite(ways).all() and np.isfinite(starts).all() and (ways != 0).any(axis=1).all() and max_distance >= 0):
            raise ValueError("finite origins, directions that are not 0 and a distance of 0 or more are expected")
        ranges = np.empty((self.copies, len(ways)), self.dtype)
        self._batch.rays(number, _number_in(_AXES, axes, "kind of axes"), starts, ways, max_distance, ranges, shapes)
        return ranges

    def rollout(self, controls: ArrayLike, *, steps: int = 1) -> tuple[NDArray[Any], NDArray[Any]]:
        """Steps with controls (copies, times, actuators), `steps` each. Returns qpos and qvel (copies, times, size) after each time."""
        given = np.asarray(controls, self.dtype)
        if given.ndim != 3 or given.shape[::2] != (self.copies, self.size("ctrl")):
            raise ValueError(f"controls ({self.copies}, times, {self.size('ctrl')}) are expected, not {given.shape}")
        times = given.shape[1]
        qpos = np.empty((self.copies, times, self.size("qpos")), self.dtype)
        qvel = np.empty((self.copies, times, self.size("qvel")), self.dtype)
        for time in range(times):
            self.write("ctrl", given[:, time])
            self.step(steps)
            qpos[:, time], qvel[:, time] = self.read("qpos"), self.read("qvel")
        return qpos, qvel

    def _on_the_ground(self) -> NDArray[np.float64]:
        """qpos where the ground is the model's: what floats, moved against the terrain."""
        qpos, terrain = self.read("qpos").astype(float), self.get("terrain").astype(float)
        for joint in self.model.joints:
            if joint.kind == "free":
                qpos[:, joint.position:joint.position + 3] -= terrain
        return qpos

    def record(self, copies: int | Sequence[int] = 0, *, spacing: float = 0.0, title: str = "") -> Recording:
        """Begin to record copies: their state now, and one after each ``step``, until the recording's ``stop`` or the end of its ``with``
        block. spacing: m between neighbours, in rows; 0: all are seen where they are, in one another."""
        chosen = [copies] if isinstance(copies, int) else list(copies)
        for copy in chosen:
            if not 0 <= copy < self.copies:
                raise IndexError(f"copy {copy}: the batch has {self.copies}")
        film = _Film(self, chosen, spacing, title)
        self._films.append(film)
        return film.recording

    def _chosen(self, copies: Sequence[int] | None) -> list[int]:
        return list(range(self.copies)) if copies is None else [int(copy) for copy in copies]

    def jacobian(self, frame: str, point: ArrayLike = (0, 0, 0), *, copies: Sequence[int] | None = None) -> NDArray[Any]:
        """What the velocities make of a point of a link, merged link or site, by name: (copies, 6, velocities), linear then angular, in the
        world's axes. point: in the frame, m. copies: which, None for all."""
        link, local = self.model._frame(frame)
        chosen = self._chosen(copies)
        out = np.empty((len(chosen), 6, self.size("qvel")), self.dtype)
        self._batch.jacobian(link, _moved(local, _vector(point, 3, "point")).tolist(), chosen, out)
        return out

    @property
    def tangent_size(self) -> int:
        """How many numbers a state has in ``linearise``: tangents of positions (along the velocities; of turns a rotation vector in the
        link's axes), velocities, activations."""
        return self._batch.tangents

    def linearise(self, copies: Sequence[int] | None = None, *, method: Literal["differences", "exact"] = "exact",
                  distance: float = 0.0) -> tuple[NDArray[Any], NDArray[Any]]:
        """Derivatives of the next state: over the state, (copies, n, n), and over the controls, (copies, n, actuators); n is
        ``tangent_size``. Nothing moves; of bad copies they are NaN.

        method: "exact", at the contacts, limits and friction that act in this step, or "differences", of steps. distance: of both sides
        from the state, in its unit, up to 0.5; 0: 1/131072, in floats 1/256. A control beyond its range has none."""
        chosen, n = self._chosen(copies), self.tangent_size
        a = np.empty((len(chosen), n, n), self.dtype)
        b = np.empty((len(chosen), n, self.size("ctrl")), self.dtype)
        self._batch.linearise(_number_in(_METHODS, method, "method") == 1, distance, chosen, a, b)
        return a, b

    def linearise_parameter(self, parameter: str, copies: Sequence[int] | None = None, *,
                            method: Literal["differences", "exact"] = "exact", distance: float = 0.0) -> NDArray[Any]:
        """Derivatives of the next state over the numbers of a parameter (see ``get``): (copies, n, size). distance is relative to the
        number; of one that is 0 both sides are a sixteenth of the usual distance away."""
        chosen, number = self._chosen(copies), _number_in(_PARAMETERS, parameter, "parameter")
        out = np.empty((len(chosen), self.tangent_size, self._batch.parameter_size(number)), self.dtype)
        self._batch.linearise_parameter(_number_in(_METHODS, method, "method") == 1, distance, number, chosen, out)
        return out

    def world(self, copy: int) -> World:
        """A new world with the model's robot in the state of one copy, to look at or to go on with. Where the copy's terrain is moved,
        what floats is moved the other way."""
        world = World(gravity=self.get("gravity")[copy].astype(float))
        world.use_defaults("robot")
        robot = self.model.build(world)
        robot.positions = self._on_the_ground()[copy]
        robot.velocities = self.read("qvel")[copy].astype(float)
        robot.controls = self.read("ctrl")[copy].astype(float)
        return world
