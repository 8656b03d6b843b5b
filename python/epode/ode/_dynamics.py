# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Masses, worlds, bodies, joints, and the contacts that joints are made from."""
from __future__ import annotations

import weakref
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from .. import c
from ._base import AMotorUser, ContactBounce, Infinity, Vector, environment
from ._base import _bodies, _getter, _known, _Owner, _setter, _tuple, _whole_setter
from ._parameters import ParamGroup

if TYPE_CHECKING:
    from ._geoms import GeomObject


class Mass:
    """Mass, centre ``c`` (x, y, z) and inertia ``I`` (3 x 3) of a body."""

    def __init__(self, _mass: c.dMass | None = None) -> None:
        self._mass = c.dMass()
        if _mass is None:
            c.dMassSetZero(self._mass)
        else:
            self._copy(_mass)

    def _copy(self, other: c.dMass) -> None:
        self._mass.mass, self._mass.c, self._mass.I = other.mass, other.c, other.I

    @property
    def mass(self) -> float:
        """The total mass."""
        return self._mass.mass

    @mass.setter
    def mass(self, value: float) -> None:
        self.adjust(value) if self._mass.mass > 0 else setattr(self._mass, "mass", value)

    @property
    def I(self) -> tuple[Vector, Vector, Vector]:  # noqa: E743
        """The inertia."""
        rows = [_tuple(row) for row in self._mass.I]
        return rows[0], rows[1], rows[2]

    @property
    def _handle(self) -> Any:
        return self._mass

    setZero = _setter(c.dMassSetZero)
    setParameters = _setter(c.dMassSetParameters)
    setSphere = _setter(c.dMassSetSphere)
    setSphereTotal = _setter(c.dMassSetSphereTotal)
    setCapsule = setCappedCylinder = _setter(c.dMassSetCapsule)
    setCapsuleTotal = setCappedCylinderTotal = _setter(c.dMassSetCapsuleTotal)
    setCylinder = _setter(c.dMassSetCylinder)
    setCylinderTotal = _setter(c.dMassSetCylinderTotal)
    setBox = _setter(c.dMassSetBox)
    setBoxTotal = _setter(c.dMassSetBoxTotal)
    adjust = _setter(c.dMassAdjust)
    translate = _setter(c.dMassTranslate)

    def add(self, b: Mass) -> None:
        """Add another mass."""
        c.dMassAdd(self._mass, b._mass)

    def __add__(self, other: Mass) -> Mass:
        result = Mass(self._mass)
        result.add(other)
        return result

    def __iadd__(self, other: Mass) -> Mass:
        self.add(other)
        return self

    def __str__(self) -> str:
        return f"Mass={self.mass}\nCg=({', '.join(map(str, self.c))})\nI11={self.I[0][0]} I22={self.I[1][1]} I33={self.I[2][2]}"

    @property
    def c(self) -> Vector:  # hides the module in the rest of the class
        """The centre of mass."""
        centre: Vector = _tuple(self._mass.c[:3])
        return centre


class World(_Owner):
    """A world of bodies and joints."""

    _destroy = staticmethod(c.dWorldDestroy)

    def __init__(self) -> None:
        self._handle = c.dWorldCreate()

    getGravity, setGravity = _getter(c.dWorldGetGravity), _setter(c.dWorldSetGravity)
    getERP, setERP = _getter(c.dWorldGetERP, float), _setter(c.dWorldSetERP)
    getCFM, setCFM = _getter(c.dWorldGetCFM, float), _setter(c.dWorldSetCFM)
    step, quickStep = _setter(c.dWorldStep), _setter(c.dWorldQuickStep)
    getQuickStepNumIterations, setQuickStepNumIterations = _getter(c.dWorldGetQuickStepNumIterations, int), _setter(c.dWorldSetQuickStepNumIterations)
    getContactMaxCorrectingVel, setContactMaxCorrectingVel = _getter(c.dWorldGetContactMaxCorrectingVel, float), _setter(c.dWorldSetContactMaxCorrectingVel)
    getContactSurfaceLayer, setContactSurfaceLayer = _getter(c.dWorldGetContactSurfaceLayer, float), _setter(c.dWorldSetContactSurfaceLayer)
    getAutoDisableFlag, setAutoDisableFlag = _getter(c.dWorldGetAutoDisableFlag, bool), _setter(c.dWorldSetAutoDisableFlag)
    getAutoDisableSteps, setAutoDisableSteps = _getter(c.dWorldGetAutoDisableSteps, int), _setter(c.dWorldSetAutoDisableSteps)
    getAutoDisableTime, setAutoDisableTime = _getter(c.dWorldGetAutoDisableTime, float), _setter(c.dWorldSetAutoDisableTime)
    getAutoDisableLinearThreshold, setAutoDisableLinearThreshold = _getter(c.dWorldGetAutoDisableLinearThreshold, float), _setter(c.dWorldSetAutoDisableLinearThreshold)
    getAutoDisableAngularThreshold, setAutoDisableAngularThreshold = _getter(c.dWorldGetAutoDisableAngularThreshold, float), _setter(c.dWorldSetAutoDisableAngularThreshold)
    getLinearDamping, setLinearDamping = _getter(c.dWorldGetLinearDamping, float), _setter(c.dWorldSetLinearDamping)
    getAngularDamping, setAngularDamping = _getter(c.dWorldGetAngularDamping, float), _setter(c.dWorldSetAngularDamping)

    def impulseToForce(self, stepsize: float, impulse: Sequence[float]) -> Vector:
        """The force that has the effect of an impulse in a step."""
        x, y, z = impulse
        force: Vector = _tuple(c.dWorldImpulseToForce(self._handle, stepsize, x, y, z))
        return force


class Body(_Owner):
    """A rigid body. It takes whatever attributes a program gives it."""

    _destroy = staticmethod(c.dBodyDestroy)

    def __init__(self, world: World) -> None:
        self.world = world
        self._handle = c.dBodyCreate(world._handle)
        _bodies[self._handle] = self

    getPosition, setPosition = _getter(c.dBodyGetPosition), _setter(c.dBodySetPosition)
    getQuaternion, setQuaternion = _getter(c.dBodyGetQuaternion), _whole_setter(c.dBodySetQuaternion)
    getRotation, setRotation = _getter(c.dBodyGetRotation), _whole_setter(c.dBodySetRotation)
    getLinearVel, setLinearVel = _getter(c.dBodyGetLinearVel), _setter(c.dBodySetLinearVel)
    getAngularVel, setAngularVel = _getter(c.dBodyGetAngularVel), _setter(c.dBodySetAngularVel)
    getForce, setForce = _getter(c.dBodyGetForce), _setter(c.dBodySetForce)
    getTorque, setTorque = _getter(c.dBodyGetTorque), _setter(c.dBodySetTorque)
    addForce, addTorque = _setter(c.dBodyAddForce), _setter(c.dBodyAddTorque)
    addRelForce, addRelTorque = _setter(c.dBodyAddRelForce), _setter(c.dBodyAddRelTorque)
    addForceAtPos, addForceAtRelPos = _setter(c.dBodyAddForceAtPos), _setter(c.dBodyAddForceAtRelPos)
    addRelForceAtPos, addRelForceAtRelPos = _setter(c.dBodyAddRelForceAtPos), _setter(c.dBodyAddRelForceAtRelPos)
    enable, disable = _setter(c.dBodyEnable), _setter(c.dBodyDisable)
    isEnabled, isKinematic = _getter(c.dBodyIsEnabled, bool), _getter(c.dBodyIsKinematic, bool)
    setKinematic, setDynamic = _setter(c.dBodySetKinematic), _setter(c.dBodySetDynamic)
    getFiniteRotationMode, setFiniteRotationMode = _getter(c.dBodyGetFiniteRotationMode, int), _setter(c.dBodySetFiniteRotationMode)
    getFiniteRotationAxis, setFiniteRotationAxis = _getter(c.dBodyGetFiniteRotationAxis), _setter(c.dBodySetFiniteRotationAxis)
    getNumJoints = _getter(c.dBodyGetNumJoints, int)
    getGravityMode, setGravityMode = _getter(c.dBodyGetGravityMode, bool), _setter(c.dBodySetGravityMode)

    def _of_point(function: Any) -> Any:
        def get(self: Any, p: Sequence[float]) -> Any:
            x, y, z = p
            return _tuple(function(self._handle, x, y, z))
        get.__doc__ = function.__doc__
        return get

    getRelPointPos, getRelPointVel = _of_point(c.dBodyGetRelPointPos), _of_point(c.dBodyGetRelPointVel)
    getPointVel, getPosRelPoint = _of_point(c.dBodyGetPointVel), _of_point(c.dBodyGetPosRelPoint)
    vectorToWorld, vectorFromWorld = _of_point(c.dBodyVectorToWorld), _of_point(c.dBodyVectorFromWorld)

    def setMass(self, mass: Mass) -> None:
        """Set mass and inertia; the centre must be at the origin."""
        c.dBodySetMass(self._handle, mass._mass)

    def getMass(self) -> Mass:
        """A copy of mass and inertia."""
        mass = c.dMass()
        c.dBodyGetMass(self._handle, mass)
        return Mass(mass)

    def setMovedCallback(self, callback: Callable[[Body], Any] | None) -> None:
        """Call callback(body) after each step that moved the body."""
        if callback is None:
            c.dBodySetMovedCallback(self._handle, None)
            return
        called, body = callback, weakref.ref(self)
        c.dBodySetMovedCallback(self._handle, lambda _: called(body()))  # type: ignore[arg-type]


class JointGroup(_Owner):
    """Joints that are destroyed together; keeps them until then."""

    _destroy = staticmethod(c.dJointGroupDestroy)

    def __init__(self) -> None:
        self._handle = c.dJointGroupCreate(0)
        self._joints: list[Joint] = []

    def _addjoint(self, j: Joint) -> None:
        self._joints.append(j)

    def empty(self) -> None:
        """Destroy the joints."""
        c.dJointGroupEmpty(self._handle)
        for joint in self._joints:
            joint._destroyed()
        self._joints = []

    def __del__(self) -> None:
        for joint in getattr(self, "_joints", ()):
            joint._destroyed()
        super().__del__()


class Joint(_Owner):
    """What all joints have."""

    _destroy = staticmethod(c.dJointDestroy)
    _kind = ""

    def __init__(self, world: World, jointgroup: JointGroup | None = None) -> None:
        if not self._kind:
            raise NotImplementedError("Joint: one of its classes expected")
        self._join(world, jointgroup, getattr(c, "dJointCreate" + self._kind)(world._handle, None if jointgroup is None else jointgroup._handle))

    def _join(self, world: World, jointgroup: JointGroup | None, handle: c.dJointID) -> None:
        self.world, self._handle, self._grouped = world, handle, jointgroup is not None
        self.body1: Body | None = None
        self.body2: Body | None = None
        if jointgroup is not None:
            jointgroup._addjoint(self)

    def _destroyed(self) -> None:
        self._handle = None

    def __del__(self) -> None:
        if getattr(self, "_grouped", False):  # goes with its group
            return
        super().__del__()

    def attach(self, body1: Body | None, body2: Body | None) -> None:
        """Attach the joint to two bodies; None (environment): to the world."""
        c.dJointAttach(self._handle, None if body1 is None else body1._handle, None if body2 is None else body2._handle)
        self.body1, self.body2 = body1, body2

    def getBody(self, index: int) -> Body | None:
        """The body, 0 or 1, or None."""
        if index not in (0, 1):
            raise IndexError(f"body {index}: 0 or 1 expected")
        return (self.body1, self.body2)[index]

    enable, disable = _setter(c.dJointEnable), _setter(c.dJointDisable)
    isEnabled = _getter(c.dJointIsEnabled, bool)

    def setFeedback(self, flag: bool = True) -> None:
        """Whether steps report forces and torques."""
        c.dJointSetFeedback(self._handle, c.dJointFeedback() if flag else None)

    def getFeedback(self) -> tuple[Vector, Vector, Vector, Vector] | None:
        """Force and torque on the first body, and on the second; None without setFeedback."""
        f = c.dJointGetFeedback(self._handle)
        return None if f is None else (_tuple(f.f1[:3]), _tuple(f.t1[:3]), _tuple(f.f2[:3]), _tuple(f.t2[:3]))


def _joint(kind: str, vectors: str = "", numbers: str = "", adds: str = "") -> type[Any]:
    """The class of a joint type: vectors that are set and read, numbers that are read, forces that are added."""
    def function(verb: str, name: str) -> Any:
        return getattr(c, f"dJoint{verb}{kind}{name}")
    members: dict[str, Any] = {"_kind": kind, "__doc__": f"A joint: ``c.dJointCreate{kind}``."}
    for name in vectors.split():
        members["get" + name] = _getter(function("Get", name))
        if hasattr(c, f"dJointSet{kind}{name}") and name != "Anchor2":
            members["set" + name] = _setter(function("Set", name))
    for name in numbers.split():
        members["get" + name] = _getter(function("Get", name), float)
    for name in adds.split():
        members["add" + name] = _setter(function("Add", name))
    if hasattr(c, f"dJointSet{kind}Param"):
        members["setParam"], members["getParam"] = _setter(function("Set", "Param")), _getter(function("Get", "Param"), float)
    return type(kind, (Joint,), members)


class BallJoint(_joint("Ball", "Anchor Anchor2")):  # type: ignore[misc]
    """A ball in a socket."""


class HingeJoint(_joint("Hinge", "Anchor Anchor2 Axis", "Angle AngleRate", "Torque")):  # type: ignore[misc]
    """A hinge."""


class SliderJoint(_joint("Slider", "Axis", "Position PositionRate", "Force")):  # type: ignore[misc]
    """A slider."""


class UniversalJoint(_joint("Universal", "Anchor Anchor2 Axis1 Axis2", "Angle1 Angle1Rate Angle2 Angle2Rate", "Torques")):  # type: ignore[misc]
    """A universal joint."""


class Hinge2Joint(_joint("Hinge2", "Anchor Anchor2", "Angle1 Angle1Rate Angle2 Angle2Rate", "Torques")):  # type: ignore[misc]
    """A wheel's joint: two hinges with different axes."""

    getAxis1, getAxis2 = _getter(c.dJointGetHinge2Axis1), _getter(c.dJointGetHinge2Axis2)

    def setAxis1(self, axis: Sequence[float]) -> None:
        """Set the axis of the first body."""
        c.dJointSetHinge2Axes(self._handle, axis, None)

    def setAxis2(self, axis: Sequence[float]) -> None:
        """Set the axis of the second body."""
        c.dJointSetHinge2Axes(self._handle, None, axis)


class FixedJoint(_joint("Fixed")):  # type: ignore[misc]
    """Two bodies as one."""

    setFixed = _setter(c.dJointSetFixed)


class AMotor(_joint("AMotor", "", "", "Torques")):  # type: ignore[misc]
    """A motor of angles."""

    getMode, setMode = _getter(c.dJointGetAMotorMode, int), _setter(c.dJointSetAMotorMode)
    getNumAxes, setNumAxes = _getter(c.dJointGetAMotorNumAxes, int), _setter(c.dJointSetAMotorNumAxes)
    getAxis, setAxis = _getter(c.dJointGetAMotorAxis), _setter(c.dJointSetAMotorAxis)
    getAxisRel = _getter(c.dJointGetAMotorAxisRel, int)
    getAngle, setAngle = _getter(c.dJointGetAMotorAngle, float), _setter(c.dJointSetAMotorAngle)
    getAngleRate = _getter(c.dJointGetAMotorAngleRate, float)


class LMotor(_joint("LMotor")):  # type: ignore[misc]
    """A motor of positions."""

    getNumAxes, setNumAxes = _getter(c.dJointGetLMotorNumAxes, int), _setter(c.dJointSetLMotorNumAxes)
    getAxis, setAxis = _getter(c.dJointGetLMotorAxis), _setter(c.dJointSetLMotorAxis)


class Plane2DJoint(_joint("Plane2D")):  # type: ignore[misc]
    """Keeps a body in the plane z = 0."""

    setXParam, setYParam, setAngleParam = (_setter(c.dJointSetPlane2DXParam), _setter(c.dJointSetPlane2DYParam),
                                           _setter(c.dJointSetPlane2DAngleParam))


class PRJoint(_joint("PR", "Anchor Axis1 Axis2", "Position PositionRate Angle AngleRate", "Torque")):  # type: ignore[misc]
    """A slider and a hinge."""


class Contact:
    """A point of contact and its surface, from ``collide``; what a ContactJoint is made from."""

    def __init__(self) -> None:
        self._contact = c.dContact()
        self._contact.surface.mode = ContactBounce
        self._contact.surface.mu = Infinity
        self._contact.surface.bounce = 0.1

    def _surface(name: str) -> Any:  # type: ignore[misc]
        def get(self: Any) -> Any:
            return getattr(self._contact.surface, name)

        def put(self: Any, value: Any) -> None:
            setattr(self._contact.surface, name, value)
        return get, put

    getMode, setMode = _surface("mode")
    getMu, setMu = _surface("mu")
    getMu2, setMu2 = _surface("mu2")
    getBounce, setBounce = _surface("bounce")
    getBounceVel, setBounceVel = _surface("bounce_vel")
    getSoftERP, setSoftERP = _surface("soft_erp")
    getSoftCFM, setSoftCFM = _surface("soft_cfm")
    getMotion1, setMotion1 = _surface("motion1")
    getMotion2, setMotion2 = _surface("motion2")
    getSlip1, setSlip1 = _surface("slip1")
    getSlip2, setSlip2 = _surface("slip2")

    def getFDir1(self) -> Vector:
        """The first direction of friction."""
        direction: Vector = _tuple(self._contact.fdir1[:3])
        return direction

    def setFDir1(self, fdir: Sequence[float]) -> None:
        """Set the first direction of friction."""
        self._contact.fdir1 = fdir

    def getContactGeomParams(self) -> tuple[Vector, Vector, float, GeomObject | None, GeomObject | None]:
        """Position, normal, depth and the two geoms."""
        geom = self._contact.geom
        return _tuple(geom.pos[:3]), _tuple(geom.normal[:3]), geom.depth, _known(geom.g1), _known(geom.g2)

    def setContactGeomParams(self, pos: Sequence[float], normal: Sequence[float], depth: float,
                             g1: GeomObject | None = None, g2: GeomObject | None = None) -> None:
        """Set what getContactGeomParams returns."""
        geom = self._contact.geom
        geom.pos, geom.normal, geom.depth = pos, normal, depth
        geom.g1, geom.g2 = (None if g is None else g._handle for g in (g1, g2))


class ContactJoint(Joint):
    """Keeps two bodies apart at a contact."""

    def __init__(self, world: World, jointgroup: JointGroup | None, contact: Contact) -> None:
        self._join(world, jointgroup, c.dJointCreateContact(world._handle, None if jointgroup is None else jointgroup._handle, contact._contact))


def areConnected(body1: Body | None, body2: Body | None) -> bool:
    """Whether a joint connects two bodies."""
    if body1 is environment or body2 is environment:
        return False
    return bool(c.dAreConnected(body1._handle, body2._handle))
