# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Kinds, as the fields of arrays and results name them: numbers that have names. The C API's headers say what each means."""
from __future__ import annotations

import enum

from . import c


class EventKind(enum.IntEnum):
    """What ``World.events`` lists (``c.dEventKind``)."""
    CONTACT_BEGIN = c.dEventContactBegin
    CONTACT_PERSIST = c.dEventContactPersist
    CONTACT_END = c.dEventContactEnd
    SENSOR_BEGIN = c.dEventSensorBegin
    SENSOR_END = c.dEventSensorEnd
    JOINT_BREAK = c.dEventJointBreak


class EventGone(enum.IntFlag):
    """Which objects of an event have been destroyed since (``c.dEventGone``)."""
    G1 = c.dEventGoneG1
    G2 = c.dEventGoneG2
    JOINT = c.dEventGoneJoint


class ContactEventKind(enum.IntEnum):
    """What happened to a pair of ``World.contact_events`` (``c.dContactEventKind``)."""
    BEGIN = c.dContactBegin
    PERSIST = c.dContactPersist
    END = c.dContactEnd


class CombineRule(enum.IntEnum):
    """How a coefficient of a pair follows from those of its two geoms (``c.dCombineRule``)."""
    DEFAULT = c.dCombineDefault
    AVERAGE = c.dCombineAverage
    MINIMUM = c.dCombineMinimum
    PRODUCT = c.dCombineProduct
    MAXIMUM = c.dCombineMaximum


class Falloff(enum.IntEnum):
    """How a radial impulse decreases with the distance r from its centre, up to its radius R (``c.dFalloff``)."""
    NONE = c.dFalloffNone
    LINEAR = c.dFalloffLinear
    QUADRATIC = c.dFalloffQuadratic


class CharacterState(enum.IntEnum):
    """What a character stands on (``c.dCharacterState``)."""
    NOT_MOVED = 0
    IN_AIR = c.dCharacterInAir
    ON_STEEP = c.dCharacterOnSteep
    ON_GROUND = c.dCharacterOnGround


class VehicleKind(enum.IntEnum):
    """How a vehicle is driven and steered (``c.dVehicleKind``)."""
    CAR = c.dVehicleCar
    BIKE = c.dVehicleBike
    TRACKED = c.dVehicleTracked


class WheelCast(enum.IntEnum):
    """How a wheel finds what it stands on (``c.dWheelCast``)."""
    RAY = c.dWheelRay
    SPHERE = c.dWheelSphere
    CYLINDER = c.dWheelCylinder


class Differential(enum.IntEnum):
    """How a differential divides (``c.dDifferential``)."""
    OPEN = c.dDifferentialOpen
    LIMITED = c.dDifferentialLimited
    LOCKED = c.dDifferentialLocked


class CauseKind(enum.IntEnum):
    """What ``World.diagnose`` finds (``c.dDiagnosisKind``)."""
    INPUT = c.dDiagnosisInput
    INERTIA = c.dDiagnosisInertia
    OVERLAP = c.dDiagnosisOverlap
    CONTRADICTION = c.dDiagnosisContradiction
    STIFF_SPRING = c.dDiagnosisStiffSpring
    STEP_TOO_LONG = c.dDiagnosisStepTooLong
    MASS_RATIO = c.dDiagnosisMassRatio
    TUNNELLING = c.dDiagnosisTunnelling
    IMPACT = c.dDiagnosisImpact
    ENERGY = c.dDiagnosisEnergy


class Severity(enum.IntEnum):
    """How sure it is that a cause is harmful (``c.dSeverity``)."""
    NOTE = c.dSeverityNote
    WARNING = c.dSeverityWarning
    ERROR = c.dSeverityError


class IslandMethod(enum.IntEnum):
    """How an island of ``World.island_reports`` was solved (``c.dIslandMethod``)."""
    NONE = c.dIslandMethodNone
    DENSE = c.dIslandMethodDense
    ACTIVE_SET = c.dIslandMethodActiveSet
    INTERIOR_POINT = c.dIslandMethodInteriorPoint
    SWEEPS = c.dIslandMethodSweeps
    SUBSTEPS = c.dIslandMethodSubsteps
    SUBSTEPS_EXACT_JOINTS = c.dIslandMethodSubstepsExactJoints
    JOINT_COORDINATES = c.dIslandMethodJointCoordinates


class BoneJoint(enum.IntEnum):
    """What connects a bone of a ragdoll with its parent (``c.dBoneJoint``)."""
    HINGE = c.dBoneHinge
    UNIVERSAL = c.dBoneUniversal
    BALL = c.dBoneBall
    FIXED = c.dBoneFixed


class RopeEnds(enum.IntFlag):
    """Which ends of a rope are fastened (``c.dRopeEnds``)."""
    LOOSE = c.dRopeLoose
    FROM = c.dRopeFrom
    TO = c.dRopeTo
    BOTH = c.dRopeBoth


class Behaviour(enum.IntEnum):
    """Whose results the steps of a world have (``c.dBehaviour``)."""
    ODE_016 = c.dBehaviour016
    EPODE_1 = c.dBehaviour1
