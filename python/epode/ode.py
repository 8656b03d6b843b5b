# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The names and habits of PyODE 1.2, so that its programs run with one changed import:

>>> import epode.ode as ode
>>> world = ode.World()
>>> world.setGravity((0, 0, -9.81))
>>> ball = ode.Body(world)
>>> world.step(0.1)
>>> ball.getLinearVel()
(0.0, 0.0, -0.9810000000000001)

As there, objects are destroyed when nothing refers to them any more: a space does not keep its geoms, and a world does
not keep its bodies; a joint group keeps its joints. What the library refuses raises ``epode.RefusedError``, a ValueError.
"""
from __future__ import annotations

import weakref
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from . import c
from .errors import RefusedError

Infinity = float("inf")
environment = None
AMotorUser, AMotorEuler = c.dAMotorUser, c.dAMotorEuler
ContactMu2, ContactFDir1, ContactBounce, ContactSoftERP = c.dContactMu2, c.dContactFDir1, c.dContactBounce, c.dContactSoftERP
ContactSoftCFM, ContactMotion1, ContactMotion2 = c.dContactSoftCFM, c.dContactMotion1, c.dContactMotion2
ContactSlip1, ContactSlip2, ContactApprox0 = c.dContactSlip1, c.dContactSlip2, c.dContactApprox0
ContactApprox1_1, ContactApprox1_2, ContactApprox1 = c.dContactApprox1_1, c.dContactApprox1_2, c.dContactApprox1
ParamGroup = c.dParamGroup
for _name in ("LoStop", "HiStop", "Vel", "FMax", "FudgeFactor", "Bounce", "CFM", "StopERP", "StopCFM", "SuspensionERP", "SuspensionCFM"):
    _number: int = getattr(c, "dParam" + _name)
    globals().update({f"Param{_name}": _number, f"Param{_name}2": _number + ParamGroup, f"Param{_name}3": _number + 2 * ParamGroup,
                      f"param{_name}": _number})

Vector = tuple[float, float, float]
_MOST_CONTACTS = 150
_geoms: weakref.WeakValueDictionary[int, GeomObject] = weakref.WeakValueDictionary()
_bodies: weakref.WeakValueDictionary[c.dBodyID, Body] = weakref.WeakValueDictionary()


def InitODE() -> None:
    """Nothing: the library is ready when the module is."""


def CloseODE() -> None:
    """Nothing: the library is closed with the process."""


def _tuple(values: Any) -> Any:
    return tuple(float(v) for v in np.asarray(values).reshape(-1))


def _getter(function: Callable[..., Any], convert: Callable[[Any], Any] = _tuple) -> Any:
    def get(self: Any, *arguments: Any) -> Any:
        return convert(function(self._handle, *arguments))
    get.__doc__ = function.__doc__
    return get


def _same(value: Any) -> Any:
    return value


def _setter(function: Callable[..., Any]) -> Any:
    """A method that takes vectors where the function takes their numbers."""
    def put(self: Any, *arguments: Any) -> None:
        numbers: list[Any] = []
        for one in arguments:
            numbers.extend(one if np.ndim(one) else (one,))
        function(self._handle, *numbers)
    put.__doc__ = function.__doc__
    return put


def _whole_setter(function: Callable[..., Any]) -> Any:
    def put(self: Any, value: Any) -> None:
        function(self._handle, value)
    put.__doc__ = function.__doc__
    return put


class _Owner:
    """An object of the library that goes with its Python object."""

    _handle: Any = None
    _destroy: Callable[[Any], Any]

    def __del__(self) -> None:
        handle, self._handle = self._handle, None
        if handle is not None:
            try:
                self._destroy(handle)
            except Exception:  # gone with its world, or at the interpreter's end
                pass


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


def _known(handle: c.dGeomID | None) -> GeomObject | None:
    return None if handle is None else _geoms.get(handle.id)


class GeomObject(_Owner):
    """What all geoms have. A geom takes whatever attributes a program gives it."""

    _destroy = staticmethod(c.dGeomDestroy)
    _placeable = True

    def _begin(self, space: SpaceBase | None, handle: c.dGeomID) -> None:
        self._handle, self.body, self.space, self.attribs = handle, environment, space, {}
        _geoms[handle.id] = self

    body: Body | None
    space: SpaceBase | None
    attribs: dict[str, Any]

    def _id(self) -> int:
        return int(self._handle.id)

    def placeable(self) -> bool:
        """Whether the geom has a place."""
        return self._placeable

    def isSpace(self) -> bool:
        """Whether the geom is a space."""
        return isinstance(self, SpaceBase)

    def setBody(self, body: Body | None) -> None:
        """Put the geom on a body, or take it off (None)."""
        if not self._placeable:
            raise ValueError("the geom has no place and cannot be on a body")
        c.dGeomSetBody(self._handle, None if body is None else body._handle)
        self.body = body

    def getBody(self) -> Body | None:
        """The body, or environment."""
        return self.body

    def getSpace(self) -> SpaceBase | None:
        """The space that the geom is in, or None."""
        found = c.dGeomGetSpace(self._handle)
        known = _known(found)
        return known if isinstance(known, SpaceBase) else None

    getPosition, setPosition = _getter(c.dGeomGetPosition), _setter(c.dGeomSetPosition)
    getRotation, setRotation = _getter(c.dGeomGetRotation), _whole_setter(c.dGeomSetRotation)
    getQuaternion, setQuaternion = _getter(c.dGeomGetQuaternion), _whole_setter(c.dGeomSetQuaternion)
    setOffsetPosition, clearOffset = _setter(c.dGeomSetOffsetPosition), _setter(c.dGeomClearOffset)
    setOffsetRotation, setOffsetQuaternion = _whole_setter(c.dGeomSetOffsetRotation), _whole_setter(c.dGeomSetOffsetQuaternion)
    getAABB = _getter(c.dGeomGetAABB)
    getCategoryBits, setCategoryBits = _getter(c.dGeomGetCategoryBits, int), _setter(c.dGeomSetCategoryBits)
    getCollideBits, setCollideBits = _getter(c.dGeomGetCollideBits, int), _setter(c.dGeomSetCollideBits)
    enable, disable, isEnabled = _setter(c.dGeomEnable), _setter(c.dGeomDisable), _getter(c.dGeomIsEnabled, bool)


def _inside(space: SpaceBase | None) -> c.dSpaceID | None:
    return None if space is None else space._handle


def _depth(function: Callable[..., float]) -> Any:
    def pointDepth(self: Any, p: Sequence[float]) -> float:
        x, y, z = p
        return function(self._handle, x, y, z)
    pointDepth.__doc__ = function.__doc__
    return pointDepth


class GeomSphere(GeomObject):
    """A ball."""

    def __init__(self, space: SpaceBase | None = None, radius: float = 1.0) -> None:
        self._begin(space, c.dCreateSphere(_inside(space), radius))

    getRadius, setRadius = _getter(c.dGeomSphereGetRadius, float), _setter(c.dGeomSphereSetRadius)
    pointDepth = _depth(c.dGeomSpherePointDepth)


class GeomBox(GeomObject):
    """A box with full side lengths."""

    def __init__(self, space: SpaceBase | None = None, lengths: Sequence[float] = (1.0, 1.0, 1.0)) -> None:
        self._begin(space, c.dCreateBox(_inside(space), *lengths))

    getLengths, setLengths = _getter(c.dGeomBoxGetLengths), _setter(c.dGeomBoxSetLengths)
    pointDepth = _depth(c.dGeomBoxPointDepth)


class GeomPlane(GeomObject):
    """The half space below normal . p = dist."""

    _placeable = False

    def __init__(self, space: SpaceBase | None = None, normal: Sequence[float] = (0, 0, 1), dist: float = 0) -> None:
        x, y, z = normal
        self._begin(space, c.dCreatePlane(_inside(space), x, y, z, dist))

    def setParams(self, normal: Sequence[float], dist: float) -> None:
        """Set normal and distance."""
        x, y, z = normal
        c.dGeomPlaneSetParams(self._handle, x, y, z, dist)

    def getParams(self) -> tuple[Vector, float]:
        """Normal and distance."""
        a, b, d, distance = _tuple(c.dGeomPlaneGetParams(self._handle))
        return (a, b, d), distance

    pointDepth = _depth(c.dGeomPlanePointDepth)


class GeomCapsule(GeomObject):
    """A cylinder along z with round caps; length is without them."""

    def __init__(self, space: SpaceBase | None = None, radius: float = 0.5, length: float = 1.0) -> None:
        self._begin(space, c.dCreateCapsule(_inside(space), radius, length))

    getParams, setParams = _getter(c.dGeomCapsuleGetParams, tuple), _setter(c.dGeomCapsuleSetParams)
    pointDepth = _depth(c.dGeomCapsulePointDepth)


GeomCCylinder = GeomCapsule


class GeomCylinder(GeomObject):
    """A cylinder along z."""

    def __init__(self, space: SpaceBase | None = None, radius: float = 0.5, length: float = 1.0) -> None:
        self._begin(space, c.dCreateCylinder(_inside(space), radius, length))

    getParams, setParams = _getter(c.dGeomCylinderGetParams, tuple), _setter(c.dGeomCylinderSetParams)


class GeomRay(GeomObject):
    """A ray."""

    def __init__(self, space: SpaceBase | None = None, rlen: float = 1.0) -> None:
        self._begin(space, c.dCreateRay(_inside(space), rlen))

    getLength, setLength = _getter(c.dGeomRayGetLength, float), _setter(c.dGeomRaySetLength)
    set = _setter(c.dGeomRaySet)

    def get(self) -> tuple[Vector, Vector]:
        """Start and direction."""
        start, direction = c.dGeomRayGet(self._handle)
        return _tuple(start[:3]), _tuple(direction[:3])


class GeomTransform(GeomObject):
    """A geom that is somewhere else than where its body is."""

    def __init__(self, space: SpaceBase | None = None) -> None:
        self._begin(space, c.dCreateGeomTransform(_inside(space)))
        c.dGeomTransformSetCleanup(self._handle, 0)
        self.geom: GeomObject | None = None

    def setGeom(self, geom: GeomObject) -> None:
        """Set the geom inside, which has a place and is in no space and on no body."""
        if not geom.placeable() or c.dGeomGetSpace(geom._handle) is not None or geom.body is not None:
            raise ValueError("a geom expected that has a place, and is in no space and on no body")
        c.dGeomTransformSetGeom(self._handle, geom._handle)
        self.geom = geom

    def getGeom(self) -> GeomObject | None:
        """The geom inside."""
        return self.geom

    getInfo, setInfo = _getter(c.dGeomTransformGetInfo, int), _setter(c.dGeomTransformSetInfo)


class TriMeshData(_Owner):
    """Triangles."""

    _destroy = staticmethod(c.dGeomTriMeshDataDestroy)

    def __init__(self) -> None:
        self._handle = c.dGeomTriMeshDataCreate()

    def build(self, verts: Sequence[Sequence[float]], faces: Sequence[Sequence[int]]) -> None:
        """Vertices, and three indices for each triangle."""
        c.dGeomTriMeshDataBuildDouble(self._handle, np.array(verts, float), np.array(faces, np.uint32))


class GeomTriMesh(GeomObject):
    """A surface of triangles."""

    def __init__(self, data: TriMeshData, space: SpaceBase | None = None) -> None:
        self.data = data
        self._begin(space, c.dCreateTriMesh(_inside(space), data._handle))

    clearTCCache = _setter(c.dGeomTriMeshClearTCCache)
    getTriangleCount = _getter(c.dGeomTriMeshGetTriangleCount, int)

    def getTriangle(self, idx: int) -> tuple[Vector, Vector, Vector]:
        """The corners of a triangle, in the world."""
        a, b, d = c.dGeomTriMeshGetTriangle(self._handle, idx)
        return _tuple(a), _tuple(b), _tuple(d)


def _heights(function: Callable[..., None], dtype: Any) -> Any:
    def build(self: Any, heightData: Any, copy: bool, width: float, depth: float, widthSamples: int, depthSamples: int,
              scale: float, offset: float, thickness: float, bWrap: bool) -> None:
        heights = np.asarray(heightData, dtype).reshape(depthSamples, widthSamples)
        function(self._handle, heights, width, depth, scale, offset, thickness, bool(bWrap))
    build.__doc__ = function.__doc__
    return build


class HeightfieldData(_Owner):
    """Heights on a grid, y up."""

    _destroy = staticmethod(c.dGeomHeightfieldDataDestroy)

    def __init__(self) -> None:
        self._handle = c.dGeomHeightfieldDataCreate()

    buildByte, buildShort = _heights(c.dGeomHeightfieldDataBuildByte, np.uint8), _heights(c.dGeomHeightfieldDataBuildShort, np.int16)
    buildSingle, buildDouble = _heights(c.dGeomHeightfieldDataBuildSingle, np.float32), _heights(c.dGeomHeightfieldDataBuildDouble, float)
    setBounds = _setter(c.dGeomHeightfieldDataSetBounds)

    def build_callback(self, userdata: Any, callback: Callable[[Any, int, int], float], width: float, depth: float, widthSamples: int,
                       depthSamples: int, scale: float, offset: float, thickness: float, bwrap: bool) -> None:
        """Heights that callback(userdata, x, z) returns."""
        c.dGeomHeightfieldDataBuildCallback(self._handle, lambda x, z: callback(userdata, x, z), width, depth, widthSamples,
                                            depthSamples, scale, offset, thickness, bool(bwrap))


class GeomHeightfield(GeomObject):
    """Ground from heights."""

    def __init__(self, data: HeightfieldData, space: SpaceBase | None = None, placeable: bool = True) -> None:
        self.data = data
        self._placeable = bool(placeable)
        self._begin(space, c.dCreateHeightfield(_inside(space), data._handle, int(self._placeable)))

    def setHeightfieldData(self, data: HeightfieldData) -> None:
        """Give the geom other data."""
        c.dGeomHeightfieldSetHeightfieldData(self._handle, data._handle)
        self.data = data


class SpaceBase(GeomObject):
    """What all spaces have: geoms that may collide."""

    _destroy = staticmethod(c.dSpaceDestroy)  # type: ignore[assignment]
    _placeable = False

    def _begin_space(self, space: SpaceBase | None, handle: c.dSpaceID) -> None:
        self._begin(space, handle)
        c.dSpaceSetCleanup(handle, 0)  # geoms go with their Python objects

    def add(self, geom: GeomObject) -> None:
        """Put a geom into the space."""
        c.dSpaceAdd(self._handle, geom._handle)

    def remove(self, geom: GeomObject) -> None:
        """Take a geom out of the space."""
        c.dSpaceRemove(self._handle, geom._handle)

    def query(self, geom: GeomObject) -> bool:
        """Whether a geom is in the space."""
        return bool(c.dSpaceQuery(self._handle, geom._handle))

    clean = _setter(c.dSpaceClean)
    getNumGeoms = _getter(c.dSpaceGetNumGeoms, int)
    getCleanup, setCleanup = _getter(c.dSpaceGetCleanup, int), _setter(c.dSpaceSetCleanup)
    getSublevel, setSublevel = _getter(c.dSpaceGetSublevel, int), _setter(c.dSpaceSetSublevel)
    getManualCleanup, setManualCleanup = _getter(c.dSpaceGetManualCleanup, int), _setter(c.dSpaceSetManualCleanup)

    def getGeom(self, idx: int) -> GeomObject:
        """The geom with a number, from 0 on."""
        if not 0 <= idx < self.getNumGeoms():
            raise IndexError(f"geom {idx}: the space has {self.getNumGeoms()}")
        geom = _known(c.dSpaceGetGeom(self._handle, idx))
        if geom is None:
            raise RuntimeError("geom is in space but not known here: its Python object is gone")
        return geom

    def __len__(self) -> int:
        return int(self.getNumGeoms())

    def __iter__(self) -> Iterator[GeomObject]:
        return (self.getGeom(i) for i in range(len(self)))

    def collide(self, arg: Any, callback: Callable[[Any, GeomObject, GeomObject], Any]) -> None:
        """Call callback(arg, geom1, geom2) for geoms whose boxes touch."""
        c.dSpaceCollide(self._handle, _near(arg, callback))


def _near(arg: Any, callback: Callable[[Any, GeomObject, GeomObject], Any]) -> Callable[[c.dGeomID, c.dGeomID], Any]:
    def near(a: c.dGeomID, b: c.dGeomID) -> None:
        geom1, geom2 = _known(a), _known(b)
        if geom1 is not None and geom2 is not None:
            callback(arg, geom1, geom2)
    return near


class SimpleSpace(SpaceBase):
    """A space that compares each pair."""

    def __init__(self, space: SpaceBase | None = None) -> None:
        self._begin_space(space, c.dSimpleSpaceCreate(_inside(space)))


class HashSpace(SpaceBase):
    """A space that is fast with many geoms."""

    def __init__(self, space: SpaceBase | None = None) -> None:
        self._begin_space(space, c.dHashSpaceCreate(_inside(space)))

    setLevels, getLevels = _setter(c.dHashSpaceSetLevels), _getter(c.dHashSpaceGetLevels, tuple)


class QuadTreeSpace(SpaceBase):
    """A space for landscapes: a tree of depth levels over a box."""

    def __init__(self, center: Sequence[float], extents: Sequence[float], depth: int, space: SpaceBase | None = None) -> None:
        self._begin_space(space, c.dQuadTreeSpaceCreate(_inside(space), center, extents, depth))


class SAPSpace(SpaceBase):
    """A space that sweeps along the axes in an order such as "XYZ"."""

    def __init__(self, sweep_order: str = "XYZ", space: SpaceBase | None = None) -> None:
        first, second, third = ("XYZ".index(axis) for axis in (sweep_order if sorted(sweep_order) == list("XYZ") else "XYZ"))
        self._begin_space(space, c.dSweepAndPruneSpaceCreate(_inside(space), first | second << 2 | third << 4))


def Space(space_type: int = 0) -> SpaceBase:
    """A SimpleSpace (0) or HashSpace (1)."""
    if space_type not in (0, 1):
        raise ValueError(f"space type {space_type}: 0 or 1 expected")
    return HashSpace() if space_type else SimpleSpace()


def collide(geom1: GeomObject, geom2: GeomObject) -> list[Contact]:
    """The contacts of two geoms."""
    contacts = []
    for found in c.dCollide(geom1._handle, geom2._handle, _MOST_CONTACTS):
        contact = Contact()
        contact._contact.geom = found
        contacts.append(contact)
    return contacts


def collide2(geom1: GeomObject, geom2: GeomObject, arg: Any, callback: Callable[[Any, GeomObject, GeomObject], Any]) -> None:
    """Call callback(arg, a, b) for geoms of the one and of the other whose boxes touch."""
    c.dSpaceCollide2(geom1._handle, geom2._handle, _near(arg, callback))


def areConnected(body1: Body | None, body2: Body | None) -> bool:
    """Whether a joint connects two bodies."""
    if body1 is environment or body2 is environment:
        return False
    return bool(c.dAreConnected(body1._handle, body2._handle))
