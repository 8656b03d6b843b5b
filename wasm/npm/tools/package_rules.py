# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What the package for JavaScript has and rust/tools/safe_rules.py does not say: its classes, and which functions its own files call."""

# Classes of the package: (name, the one that it extends, what its C functions begin with). A function belongs to the longest beginning.
CLASSES = (
    ("WorldMethods", "Handle", "dWorld"), ("BodyMethods", "Handle", "dBody"), ("VehicleMethods", "Handle", "dVehicle"),
    ("JointMethods", "Handle", "dJoint"), ("GeomMethods", "Handle", "dGeom"),
)
JOINTS = ("Ball", "Hinge", "Slider", "Universal", "Hinge2", "Fixed", "AMotor", "LMotor", "Plane2D", "PR", "PU", "Piston", "DBall", "DHinge",
          "Transmission")
GEOMS = ("Sphere", "Box", "Plane", "Capsule", "Cylinder", "Cone", "Ellipsoid", "TaperedCapsule", "Convex", "TriMesh", "Heightfield", "Character")

# Left out, besides what the Rust crate leaves out: pattern -> reason.
LEFT_OUT = {
    r"dWorld\w*(StepThreads|MaxThreadCount)|dWorldCleanupWorkingMemory": "WebAssembly has one thread",
    r"dGeomTriMesh(Data\w+|GetPoint)|dGeomHeightfieldData\w+": "meshes and fields are made whole, by createMesh and createHeightfield",
    r"dGeomCCylinder\w+": "ODE's old name of the capsule",
    r"dJoint(AddAMotorTorques\w*)": "addTorques has all three",
    r"dVehicle(\w+Init|Create)": "Body.makeVehicle",
    r"dBody(SetDynamic|SetKinematic|IsKinematic)": "kinematic",
    r"d(Body|Geom)(Is)?(Enabled|Enable|Disable)|dJoint(IsEnabled|Enable|Disable)": "enabled",
    r"dBodyIsVehicle|dGeomIsCharacter": "Body.vehicle and the class Character",
}
# By hand here: what the crate has by hand, and these.
WRITTEN = (r"dVehicle(SetControls|GetControls)", r"dCharacter(SettingsInit|Create|SetSettings|GetSettings)",
           r"dJointGetCoupling\w+|dJointSetCoupling\w+")
# Words of C that the package spells out.
WORDS = {"Vel": "Velocity", "Pos": "Position", "FMax": "MaxForce", "Num": "Count"}
# A C int that is a number of an enumeration, or a flag, that safe_rules.py does not have.
FLAGS = (r"dWorld[GS]etJointCoordinates", r"dBodySetVelocities", r"dGeomTriMesh[GS]etSolid", r"dVehicle(Set|Update)\w+")
STRUCTURES = {
    "dVehicleSettings": ("VehicleSettings", True, ()), "dVehicleWheel": ("VehicleWheel", True, ()),
    "dVehicleControls": ("VehicleControls", True, ()), "dVehicleReport": ("VehicleReport", False, ()),
    "dVehicleWheelReport": ("VehicleWheelReport", False, ()),
    "dQueryFilter": ("QueryFilter", True, ("callback", "data", "skip_body")), "dQueryHit": ("QueryHit", False, ()),
    "dCastHit": ("CastHit", False, ()), "dQueryDistance": ("QueryDistance", False, ()), "dWorldContact": ("Contact", False, ()),
    "dContactEvent": ("ContactEvent", False, ()), "dEvent": ("Event", False, ("gone",)), "dMass": ("Mass", False, ()),
}
ENUMS = (
    ("VehicleKind", "dVehicleKind", "dVehicle", ""), ("WheelCast", "dWheelCast", "dWheel", ""),
    ("Differential", "dDifferential", "dDifferential", ""), ("StateField", "dStateField", "dState", ""), ("Falloff", "dFalloff", "dFalloff", ""),
)
KINDS_OF_FIELDS = {
    "dVehicleSettings.kind": "VehicleKind", "dVehicleWheel.cast": "WheelCast", "dVehicleSettings.differential": "Differential",
    "dVehicleSettings.centre_differential": "Differential", "dContactEvent.kind": "ContactEventKind", "dEvent.kind": "EventKind",
}
FLAGS_OF_FIELDS = {"dVehicleSettings.automatic", "dVehicleSettings.abs", "dVehicleReport.is_shifting", "dVehicleWheelReport.on_ground",
                   "dQueryFilter.skip_overlaps"}

# Names that the rules would make badly.
RENAMED = {"dJointSetFixed": "fix", "dVehicleGetNumWheels": "wheelCount", "dBodyGetNumJoints": "jointCount", "dJointGetNumBodies": "bodyCount",
           "dJointGetNumAxes": "axisCount"}
# What is left of a C name once its class is gone, and what it is here.
RESTS = {"QuickStepNumIterations": "QuickStepIterations", "AutoDisableAverageSamplesCount": "AutoDisableAverageSamples",
         "NumAxes": "MotorAxes", "AutoDisableFlag": "AutoDisable", "GravityMode": "Gravity", "GyroscopicMode": "Gyroscopic",
         "StepReportMode": "ReportSteps", "EnergyLedgerMode": "KeepEnergyLedger", "DiagnosisMode": "DiagnoseSteps"}
# Vectors that may be null: where nothing is said.
NULLABLE = {("dBodyApplyImpulse", "pos"), ("dBodyApplyForce", "pos"), ("dBodySetVelocities", "linear"), ("dBodySetVelocities", "angular")}
