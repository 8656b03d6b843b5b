# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Vehicles: bodies on wheels with suspension, tyres, engine and gears."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from . import c
from ._handle import FloatArray, Value, flag_of, number_of, put_settings, settable, three, vector_of
from .body import Body
from .enums import Differential, VehicleKind, WheelCast

if TYPE_CHECKING:
    from .geom import Geom
    from .world import World

T = TypeVar("T")


def _settings(self: Vehicle) -> c.dVehicleSettings:
    given = c.dVehicleSettings()
    c.dVehicleGetSettings(self._handle, given)
    return given


def _report(self: Vehicle) -> c.dVehicleReport:
    report = c.dVehicleReport()
    c.dVehicleGetReport(self._handle, report)
    return report


def _controls(self: Vehicle) -> c.dVehicleControls:
    controls = c.dVehicleControls()
    c.dVehicleGetControls(self._handle, controls)
    return controls


def _wheel_settings(self: Wheel) -> c.dVehicleWheel:
    given = c.dVehicleWheel()
    c.dVehicleGetWheel(self.vehicle._handle, self.number, given)
    return given


def _wheel_report(self: Wheel) -> c.dVehicleWheelReport:
    report = c.dVehicleWheelReport()
    c.dVehicleGetWheelReport(self.vehicle._handle, self.number, report)
    return report


def _field(read: Callable[[Any], Any], write: Callable[[Any, Any], Any], name: str, kind: Callable[[Any], T], doc: str) -> Value[T, T]:
    """A property that is a field of a structure, which is read, changed and written."""
    def put(self: Any, value: T) -> None:
        given = read(self)
        setattr(given, name, value)
        write(self, given)
    return Value(lambda self: kind(getattr(read(self), name)), put, doc=doc)


def _setting(name: str, doc: str, kind: Callable[[Any], T]) -> Value[T, T]:
    return _field(_settings, lambda self, given: c.dVehicleSetSettings(self._handle, given), name, kind, doc)


def _control(name: str, doc: str) -> Value[float, float]:
    return _field(_controls, lambda self, given: c.dVehicleSetControls(self._handle, given), name, float, doc)


def _of_wheel(name: str, doc: str, kind: Callable[[Any], T]) -> Value[T, T]:
    return _field(_wheel_settings, lambda self, given: c.dVehicleSetWheel(self.vehicle._handle, self.number, given), name, kind, doc)


class Wheel:
    """A wheel of a vehicle, made by ``Vehicle.add_wheel``: suspension, tyre and brakes, and what the last update has done there."""

    __slots__ = ("vehicle", "number")

    def __init__(self, vehicle: Vehicle, number: int) -> None:
        """The wheel of the vehicle with that number, 0 for the first that was added."""
        self.vehicle, self.number = vehicle, number

    def __repr__(self) -> str:
        return f"<epode.Wheel: {self.number} of {self.vehicle!r}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Wheel) and (self.vehicle, self.number) == (other.vehicle, other.number)

    def __hash__(self) -> int:
        return hash((self.vehicle, self.number))

    @property
    def position(self) -> FloatArray:
        """Of the hub when the suspension hangs free, in the body's frame, m."""
        return _wheel_settings(self).position

    @position.setter
    def position(self, value: ArrayLike) -> None:
        given = _wheel_settings(self)
        given.position = three(value, "position")
        c.dVehicleSetWheel(self.vehicle._handle, self.number, given)

    cast = _of_wheel("cast", "How it finds what it stands on; WheelCast.RAY at first.", WheelCast)
    radius = _of_wheel("radius", "m; 0.33 at first.", float)
    width = _of_wheel("width", "m; 0.2 at first.", float)
    inertia = _of_wheel("inertia", "About its axle, with its brake and shaft, kg m^2; 1 at first.", float)
    axle = _of_wheel("axle", "The two wheels with one number are a pair; 0 at first.", int)
    travel = _of_wheel("travel", "Of the suspension, m; 0.25 at first.", float)
    preload = _of_wheel("preload", "N, of the spring that hangs free; 0 at first.", float)
    stiffness = _of_wheel("stiffness", "N/m; 30000 at first.", float)
    bump_damping = _of_wheel("bump_damping", "N s/m, where it is compressed; 3000 at first.", float)
    rebound_damping = _of_wheel("rebound_damping", "N s/m, where it extends; 3000 at first.", float)
    stop_stiffness = _of_wheel("stop_stiffness", "N/m, beyond the travel; 300000 at first.", float)
    anti_roll = _of_wheel("anti_roll", "N/m, times the difference of the pair's compressions; 0 at first.", float)
    roll_centre = _of_wheel("roll_centre", "m above what it stands on, where lateral forces act on the chassis; 0 at first.", float)
    friction_x = _of_wheel("friction_x", "mu forward at the nominal load; 1.1 at first.", float)
    friction_y = _of_wheel("friction_y", "mu sideways; 1 at first.", float)
    stiffness_x = _of_wheel("stiffness_x", "Force over load for a small slip ratio; 18 at first.", float)
    stiffness_y = _of_wheel("stiffness_y", "Force over load for a small slip angle, rad; 14 at first.", float)
    sliding = _of_wheel("sliding", "What is left of mu in full slip; 0.8 at first.", float)
    nominal_load = _of_wheel("nominal_load", "N; 4000 at first.", float)
    load_sensitivity = _of_wheel("load_sensitivity", "mu falls by this share where the load doubles; 0.05 at first.", float)
    relaxation = _of_wheel("relaxation", "m, that it rolls while its force builds up; 0.3 at first.", float)
    rolling_resistance = _of_wheel("rolling_resistance", "Force over load; 0.012 at first.", float)
    steer = _of_wheel("steer", "Times the vehicle's angle, -1 ... 1; 0 at first.", float)
    drive = _of_wheel("drive", "Its share of the torque; 0 at first.", float)
    brake_torque = _of_wheel("brake_torque", "N m at brake 1; 1500 at first.", float)
    handbrake_torque = _of_wheel("handbrake_torque", "N m at handbrake 1; 0 at first.", float)

    # ---- what the last update has done ----

    on_ground = flag_of(_wheel_report, "on_ground", "Whether it stands on something.")
    ground_position = vector_of(_wheel_report, "ground_pos", "Where, m.")
    ground_normal = vector_of(_wheel_report, "ground_normal", "Of what it stands on, a unit vector.")
    hub = vector_of(_wheel_report, "hub", "The middle of the wheel, to draw it, m.")
    steer_angle = number_of(_wheel_report, "steer", "rad about up, above 0 to the left.")
    angle = number_of(_wheel_report, "angle", "That it has turned, rad, 0 ... 2 pi.")
    spin = number_of(_wheel_report, "spin", "rad/s, above 0 forward.")
    compression = number_of(_wheel_report, "compression", "Of the suspension, m.")
    load = number_of(_wheel_report, "load", "N along the normal.")
    force_x = number_of(_wheel_report, "force_x", "N, forward along the ground, on the vehicle.")
    force_y = number_of(_wheel_report, "force_y", "N, to the left.")
    slip_ratio = number_of(_wheel_report, "slip_ratio", "Of its speed over the ground: above 0 it drives.")
    slip_angle = number_of(_wheel_report, "slip_angle", "rad, from where it points to where it moves, above 0 to the left.")
    slip = number_of(_wheel_report, "slip", "Both together: from 1 on it slides.")

    @property
    def ground(self) -> Geom | None:
        """The geom that it stands on; None: none that Python knows."""
        found = _wheel_report(self).ground
        return None if found is None else self.vehicle.world.geom_of(found.id)

    def report(self) -> c.dVehicleWheelReport:
        """All of that by one call."""
        return _wheel_report(self)


class Vehicle(Body):
    """A body on wheels, made by ``World.vehicle``: its chassis, with an engine at idle in the first gear. Call ``update`` once before
    each step of the world."""

    __slots__ = ()

    kind = _setting("kind", "How it is driven and steered; VehicleKind.CAR at first.", VehicleKind)
    engine_inertia = _setting("engine_inertia", "kg m^2; 0.2 at first.", float)
    engine_drag = _setting("engine_drag", "N m at the limiter with closed throttle; 60 at first.", float)
    idle_speed = _setting("idle_speed", "rad/s, that the engine keeps by itself; 90 at first.", float)
    automatic = _setting("automatic", "Whether it shifts by itself between forward gears; True at first.", bool)
    reverse_ratio = _setting("reverse_ratio", "Engine over shaft; 3.3 at first.", float)
    final_ratio = _setting("final_ratio", "Shaft over wheels; 3.8 at first.", float)
    shift_time = _setting("shift_time", "s without drive while it shifts; 0.2 at first.", float)
    shift_up_speed = _setting("shift_up_speed", "Of the engine, rad/s: above it the automatic gearbox shifts up; 580 at first.", float)
    shift_down_speed = _setting("shift_down_speed", "Below it the automatic gearbox shifts down; 230 at first.", float)
    max_clutch_torque = _setting("clutch_torque", "The greatest of the clutch, N m; 700 at first.", float)
    differential = _setting("differential", "Of each axle, of a tracked one of its sides; Differential.OPEN at first.", Differential)
    lock_torque = _setting("lock_torque", "Of a limited one, N m; 200 at first.", float)
    centre_differential = _setting("centre_differential", "Between driven axles; Differential.OPEN at first.", Differential)
    centre_lock_torque = _setting("centre_lock_torque", "Of a limited one, N m; 200 at first.", float)
    max_steer = _setting("max_steer", "rad, of a wheel in the middle with steer 1; 0.6 at first.", float)
    steer_speed = _setting("steer_speed", "rad/s, that it turns with at most; 2 at first.", float)
    ackermann = _setting("ackermann", "1: all axles point to one centre; 0: wheels of an axle are parallel; 1 at first.", float)
    drag = _setting("drag", "The air's force over the square of the speed, N s^2/m^2; 0.4 at first.", float)
    downforce = _setting("downforce", "Likewise, along minus up; 0 at first.", float)
    abs = _setting("abs", "Whether brakes keep below locking; False at first.", bool)
    lean_frequency = _setting("lean_frequency", "Of a bike, how fast it leans, rad/s; 0: it does not hold itself; 8 at first.", float)
    lean_limit = _setting("lean_limit", "rad; 0.9 at first.", float)
    wheel_category = _setting("category_bits", "Its wheels meet geoms that collide with one of these bits.", int)
    wheel_collides_with = _setting("collide_bits", "... or whose category has one of these.", int)

    @property
    def engine_curve(self) -> FloatArray:
        """The engine at full throttle: rows of speed, rad/s, and torque, N m; the last speed is the limiter's."""
        given = _settings(self)
        return np.column_stack((given.engine_speeds, given.engine_torques))[:given.torque_points]

    @engine_curve.setter
    def engine_curve(self, rows: ArrayLike) -> None:
        curve = np.asarray(rows, dtype=float)
        if curve.ndim != 2 or curve.shape[1] != 2 or not 2 <= len(curve) <= c.dVehicleMaxTorquePoints:
            raise ValueError(f"engine_curve: 2 to {c.dVehicleMaxTorquePoints} rows of (rad/s, N m) are expected, not an array of {curve.shape}")
        given = _settings(self)
        given.torque_points, given.engine_speeds, given.engine_torques = len(curve), curve[:, 0], curve[:, 1]
        c.dVehicleSetSettings(self._handle, given)

    @property
    def gear_ratios(self) -> FloatArray:
        """Engine over shaft, of each forward gear."""
        given = _settings(self)
        return given.gear_ratios[:given.gears]

    @gear_ratios.setter
    def gear_ratios(self, ratios: ArrayLike) -> None:
        given, values = _settings(self), np.asarray(ratios, dtype=float)
        if values.ndim != 1 or not 1 <= len(values) <= c.dVehicleMaxGears:
            raise ValueError(f"gear_ratios: 1 to {c.dVehicleMaxGears} numbers are expected, not an array of {values.shape}")
        given.gears, given.gear_ratios = len(values), values
        c.dVehicleSetSettings(self._handle, given)

    @property
    def forward(self) -> FloatArray:
        """In the body's frame."""
        return _settings(self).forward

    @forward.setter
    def forward(self, value: ArrayLike) -> None:
        given = _settings(self)
        given.forward = three(value, "forward")
        c.dVehicleSetSettings(self._handle, given)

    @property
    def up(self) -> FloatArray:
        """In the body's frame; the suspensions work along it."""
        return _settings(self).up

    @up.setter
    def up(self, value: ArrayLike) -> None:
        given = _settings(self)
        given.up = three(value, "up")
        c.dVehicleSetSettings(self._handle, given)

    # ---- wheels ----

    def add_wheel(self, position: ArrayLike, **settings: Any) -> Wheel:
        """A new wheel with its hub at a position of the body's frame when the suspension hangs free, m. settings: what a Wheel has."""
        given = c.dVehicleWheel()
        given.position = three(position, "position")
        for name, value in settings.items():
            if name not in WHEEL_SETTINGS:
                raise TypeError(f"a wheel has no {name}: {', '.join(WHEEL_SETTINGS)}")
            setattr(given, name, value)
        return Wheel(self, c.dVehicleAddWheel(self._handle, given) - 1)

    @property
    def wheels(self) -> tuple[Wheel, ...]:
        """Its wheels, the oldest first."""
        return tuple(Wheel(self, i) for i in range(c.dVehicleGetNumWheels(self._handle)))

    def wheel_values(self, name: str) -> FloatArray:
        """A property of all wheels as an array with a row for each: "hub" has three columns, "load" is flat."""
        if not isinstance(getattr(Wheel, name, None), property) or name == "ground":
            raise ValueError(f"wheels have no numbers called {name!r}")
        return np.array([getattr(wheel, name) for wheel in self.wheels], dtype=float)

    # ---- what the driver does ----

    throttle = _control("throttle", "0 ... 1.")
    brake = _control("brake", "0 ... 1.")
    handbrake = _control("handbrake", "0 ... 1.")
    steer = _control("steer", "-1 ... 1, above 0 to the left.")
    clutch = _control("clutch", "0 ... 1: pressed, nothing is driven; an automatic clutch works besides.")

    def control(self, *, throttle: float | None = None, brake: float | None = None, steer: float | None = None,
                handbrake: float | None = None, clutch: float | None = None) -> None:
        """Set several controls by one call; None: it stays."""
        given = _controls(self)
        for name, value in (("throttle", throttle), ("brake", brake), ("steer", steer), ("handbrake", handbrake), ("clutch", clutch)):
            if value is not None:
                setattr(given, name, value)
        c.dVehicleSetControls(self._handle, given)

    @property
    def gear(self) -> int:
        """-1 reverse, 0 neutral, 1 ... forward; while it shifts the next one. Setting it shifts."""
        return int(_report(self).gear)

    @gear.setter
    def gear(self, gear: int) -> None:
        c.dVehicleSetGear(self._handle, gear)

    def update(self, h: float) -> int:
        """Let wheels, engine and gears act for a step of h seconds, before ``World.step``. Returns how many wheels stand on something."""
        return c.dVehicleUpdate(self._handle, h)

    # ---- what the last update has done ----

    speed = number_of(_report, "speed", "Of the chassis along forward, m/s.")
    engine_speed = number_of(_report, "engine_speed", "rad/s.")
    engine_torque = number_of(_report, "engine_torque", "N m.")
    clutch_torque = number_of(_report, "clutch_torque", "N m, that the engine gives to the gearbox.")
    is_shifting = flag_of(_report, "is_shifting", "Whether it shifts, without drive.")
    steer_angle = number_of(_report, "steer", "The angle that it steers, rad.")
    lean = number_of(_report, "lean", "rad, about forward, above 0 to the right.")
    curvature = number_of(_report, "curvature", "Of the path that it steers, 1/m, above 0 to the left.")

    @property
    def wheels_on_ground(self) -> int:
        """How many wheels stand on something."""
        return int(_report(self).wheels_on_ground)

    def report(self) -> c.dVehicleReport:
        """All of that by one call."""
        return _report(self)

    @classmethod
    def _new(cls, world: World, body: Body, settings: dict[str, Any]) -> Vehicle:
        """Make a new body of the world, which is nobody's yet, a vehicle."""
        c.dVehicleCreate(body._handle, None)
        vehicle = cls(world, body._handle)
        vehicle.geoms = body.geoms
        for geom in vehicle.geoms:
            geom.body = vehicle
        world._bodies[body._handle] = vehicle
        body._live = None
        put_settings(vehicle, settings, SETTINGS, "vehicle")
        return vehicle


SETTINGS = settable(Vehicle, Body)  # of World.vehicle
WHEEL_SETTINGS = settable(Wheel)  # of Vehicle.add_wheel
