// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by rust/tools/generate.py from the public headers.
use crate::prelude::*;

/// What dJointGetType answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// C: dJointTypeNone.
    None = sys::dJointTypeNone as isize,
    /// C: dJointTypeBall.
    Ball = sys::dJointTypeBall as isize,
    /// C: dJointTypeHinge.
    Hinge = sys::dJointTypeHinge as isize,
    /// C: dJointTypeSlider.
    Slider = sys::dJointTypeSlider as isize,
    /// C: dJointTypeContact.
    Contact = sys::dJointTypeContact as isize,
    /// C: dJointTypeUniversal.
    Universal = sys::dJointTypeUniversal as isize,
    /// C: dJointTypeHinge2.
    Hinge2 = sys::dJointTypeHinge2 as isize,
    /// C: dJointTypeFixed.
    Fixed = sys::dJointTypeFixed as isize,
    /// C: dJointTypeNull.
    Null = sys::dJointTypeNull as isize,
    /// C: dJointTypeAMotor.
    AMotor = sys::dJointTypeAMotor as isize,
    /// C: dJointTypeLMotor.
    LMotor = sys::dJointTypeLMotor as isize,
    /// C: dJointTypePlane2D.
    Plane2D = sys::dJointTypePlane2D as isize,
    /// C: dJointTypePR.
    PR = sys::dJointTypePR as isize,
    /// C: dJointTypePU.
    PU = sys::dJointTypePU as isize,
    /// C: dJointTypePiston.
    Piston = sys::dJointTypePiston as isize,
    /// C: dJointTypeDBall.
    DBall = sys::dJointTypeDBall as isize,
    /// C: dJointTypeDHinge.
    DHinge = sys::dJointTypeDHinge as isize,
    /// C: dJointTypeTransmission.
    Transmission = sys::dJointTypeTransmission as isize,
    /// C: dJointTypeCoupling.
    Coupling = sys::dJointTypeCoupling as isize,
}
#[allow(dead_code)]
impl JointKind {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::None,
            1 => Self::Ball,
            2 => Self::Hinge,
            3 => Self::Slider,
            4 => Self::Contact,
            5 => Self::Universal,
            6 => Self::Hinge2,
            7 => Self::Fixed,
            8 => Self::Null,
            9 => Self::AMotor,
            10 => Self::LMotor,
            11 => Self::Plane2D,
            12 => Self::PR,
            13 => Self::PU,
            14 => Self::Piston,
            15 => Self::DBall,
            16 => Self::DHinge,
            17 => Self::Transmission,
            18 => Self::Coupling,
            _ => Self::None,
        }
    }
}

/// How a coefficient of a pair follows from those of its two geoms. If their rules differ, the one that is
/// listed later here counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CombineRule {
    /// friction: the geometric mean; bounce and rolling friction: the larger
    Default = sys::dCombineDefault as isize,
    /// half the sum
    Average = sys::dCombineAverage as isize,
    /// the smaller
    Minimum = sys::dCombineMinimum as isize,
    /// the product
    Product = sys::dCombineProduct as isize,
    /// the larger
    Maximum = sys::dCombineMaximum as isize,
}
#[allow(dead_code)]
impl CombineRule {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::Default,
            1 => Self::Average,
            2 => Self::Minimum,
            3 => Self::Product,
            4 => Self::Maximum,
            _ => Self::Default,
        }
    }
}

/// What has happened to a pair in the last step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ContactEventKind {
    /// the geoms touch and did not before
    Begin = sys::dContactBegin as isize,
    /// they touch and did before
    Persist = sys::dContactPersist as isize,
    /// they touched before and do not
    End = sys::dContactEnd as isize,
}
#[allow(dead_code)]
impl ContactEventKind {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::Begin,
            1 => Self::Persist,
            2 => Self::End,
            _ => Self::Begin,
        }
    }
}

/// Kinds of events.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EventKind {
    /// the geoms touch and did not before
    ContactBegin = sys::dEventContactBegin as isize,
    /// they touch and did before
    ContactPersist = sys::dEventContactPersist as isize,
    /// they touched before and do not
    ContactEnd = sys::dEventContactEnd as isize,
    /// a geom overlaps a sensor at the end of the step and did not before
    SensorBegin = sys::dEventSensorBegin as isize,
    /// it did before and does not
    SensorEnd = sys::dEventSensorEnd as isize,
    /// a joint broke (dJointSetBreakLimits)
    JointBreak = sys::dEventJointBreak as isize,
}
#[allow(dead_code)]
impl EventKind {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::ContactBegin,
            1 => Self::ContactPersist,
            2 => Self::ContactEnd,
            3 => Self::SensorBegin,
            4 => Self::SensorEnd,
            5 => Self::JointBreak,
            _ => Self::ContactBegin,
        }
    }
}

/// What a character stands on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CharacterState {
    /// on nothing
    InAir = sys::dCharacterInAir as isize,
    /// it touches ground steeper than the slope limit, and nothing better
    OnSteep = sys::dCharacterOnSteep as isize,
    /// it stands
    OnGround = sys::dCharacterOnGround as isize,
}
#[allow(dead_code)]
impl CharacterState {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            1 => Self::InAir,
            2 => Self::OnSteep,
            3 => Self::OnGround,
            _ => Self::InAir,
        }
    }
}

/// What a world is for. docs/guide/defaults.md has the values of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Defaults {
    /// as ODE begins: the values of a new world
    Ode = sys::dDefaultsOde as isize,
    /// piles, stacks, figures, vehicles: steps of 1/60 s, robust and quick, bodies sleep
    Game = sys::dDefaultsGame as isize,
    /// machines and robots: steps of 0.001 to 0.005 s, joints exact, nothing sleeps
    Robot = sys::dDefaultsRobot as isize,
}
#[allow(dead_code)]
impl Defaults {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::Ode,
            1 => Self::Game,
            2 => Self::Robot,
            _ => Self::Ode,
        }
    }
}

/// Versions of the behaviour of worlds: a hundred times the major number, plus the minor one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Behaviour {
    /// ODE 0.16, where the two differ in the results of a world and it can be had
    Ode016 = sys::dBehaviour016 as isize,
    /// this library's first, the default
    V1 = sys::dBehaviour1 as isize,
}
#[allow(dead_code)]
impl Behaviour {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            16 => Self::Ode016,
            100 => Self::V1,
            _ => Self::Ode016,
        }
    }
}

/// Causes of failure. \`figure\` and \`threshold\` of a dDiagnosis are in the unit that is named here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DiagnosisKind {
    /// the program set a huge velocity or force: m/s that it set or adds in a step;
    /// or a call was refused: refusals before a step
    Input = sys::dDiagnosisInput as isize,
    /// inertia far from the shapes': its radius over theirs; or not that of a body:
    /// largest moment over the sum of the others
    Inertia = sys::dDiagnosisInertia as isize,
    /// geoms started in each other: depth over the thinner one's half thickness
    Overlap = sys::dDiagnosisOverlap as isize,
    /// joints that cannot hold together: error that stays, m or rad
    Contradiction = sys::dDiagnosisContradiction as isize,
    /// the program's force overshoots in each step: h^2 k/m; 4 is unstable
    StiffSpring = sys::dDiagnosisStiffSpring as isize,
    /// the body rotates, or would swing under its load, too far in a step: rad
    StepTooLong = sys::dDiagnosisStepTooLong as isize,
    /// a light body carries heavy ones: mass over mass
    MassRatio = sys::dDiagnosisMassRatio as isize,
    /// a body has passed through a geom: distance over its half thickness
    Tunnelling = sys::dDiagnosisTunnelling as isize,
    /// contact so fast that it is found too late: travel over half thickness
    Impact = sys::dDiagnosisImpact as isize,
    /// energy from nowhere: J gained over J there was
    Energy = sys::dDiagnosisEnergy as isize,
}
#[allow(dead_code)]
impl DiagnosisKind {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::Input,
            1 => Self::Inertia,
            2 => Self::Overlap,
            3 => Self::Contradiction,
            4 => Self::StiffSpring,
            5 => Self::StepTooLong,
            6 => Self::MassRatio,
            7 => Self::Tunnelling,
            8 => Self::Impact,
            9 => Self::Energy,
            _ => Self::Input,
        }
    }
}

/// How sure it is that this is harmful.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Severity {
    /// worth knowing if something looks wrong
    Note = sys::dSeverityNote as isize,
    /// likely to be seen
    Warning = sys::dSeverityWarning as isize,
    /// the simulation is wrong
    Error = sys::dSeverityError as isize,
}
#[allow(dead_code)]
impl Severity {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::Note,
            1 => Self::Warning,
            2 => Self::Error,
            _ => Self::Note,
        }
    }
}

/// How an island was solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum IslandMethod {
    /// nothing to solve
    None = sys::dIslandMethodNone as isize,
    /// exact: active set on the dense matrix of a small island
    Dense = sys::dIslandMethodDense as isize,
    /// exact: active set on the sparse matrix
    ActiveSet = sys::dIslandMethodActiveSet as isize,
    /// exact: interior point, then the active set from its answer
    InteriorPoint = sys::dIslandMethodInteriorPoint as isize,
    /// dWorldQuickStep
    Sweeps = sys::dIslandMethodSweeps as isize,
    /// dWorldStepFast1
    Substeps = sys::dIslandMethodSubsteps as isize,
    /// substeps with all joints solved together
    SubstepsExactJoints = sys::dIslandMethodSubstepsExactJoints as isize,
    /// exact: in joint coordinates (dWorldSetJointCoordinates)
    JointCoordinates = sys::dIslandMethodJointCoordinates as isize,
}
#[allow(dead_code)]
impl IslandMethod {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::None,
            1 => Self::Dense,
            2 => Self::ActiveSet,
            3 => Self::InteriorPoint,
            4 => Self::Sweeps,
            5 => Self::Substeps,
            6 => Self::SubstepsExactJoints,
            7 => Self::JointCoordinates,
            _ => Self::None,
        }
    }
}

/// What steps do about the path of a geom from one place to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Continuous {
    /// nothing: where it ends is what counts
    Off = sys::dContinuousOff as isize,
    /// it does not pass what it meets
    On = sys::dContinuousOn as isize,
    /// continuous geoms may pass it: sensors
    Ignored = sys::dContinuousIgnored as isize,
}
#[allow(dead_code)]
impl Continuous {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::Off,
            1 => Self::On,
            2 => Self::Ignored,
            _ => Self::Off,
        }
    }
}

/// How a world, or an island of it, is stepped; from the most exact on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stepper {
    /// each island in its own way: as dWorldStepHybrid does
    Hybrid = sys::dStepperHybrid as isize,
    /// as dWorldStep does
    Exact = sys::dStepperExact as isize,
    /// in substeps, with all joints of an island solved together and exactly
    SubstepsExactJoints = sys::dStepperSubstepsExactJoints as isize,
    /// in substeps, as dWorldStepFast1 does; exact joints where sweeps fail
    Substeps = sys::dStepperSubsteps as isize,
    /// as dWorldQuickStep does
    Quick = sys::dStepperQuick as isize,
}
#[allow(dead_code)]
impl Stepper {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::Hybrid,
            1 => Self::Exact,
            2 => Self::SubstepsExactJoints,
            3 => Self::Substeps,
            4 => Self::Quick,
            _ => Self::Hybrid,
        }
    }
}

/// Modes of the angular motor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AMotorMode {
    /// the program sets axes and angles
    User = sys::dAMotorUser as isize,
    /// axes and angles follow from the bodies' orientations
    Euler = sys::dAMotorEuler as isize,
    /// the rotation vector
    Turn = sys::dAMotorTurn as isize,
}
#[allow(dead_code)]
impl AMotorMode {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::User,
            1 => Self::Euler,
            2 => Self::Turn,
            _ => Self::User,
        }
    }
}

/// Modes of the transmission joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TransmissionMode {
    /// C: dTransmissionParallelAxes.
    ParallelAxes = sys::dTransmissionParallelAxes as isize,
    /// C: dTransmissionIntersectingAxes.
    IntersectingAxes = sys::dTransmissionIntersectingAxes as isize,
    /// C: dTransmissionChainDrive.
    ChainDrive = sys::dTransmissionChainDrive as isize,
}
#[allow(dead_code)]
impl TransmissionMode {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            0 => Self::ParallelAxes,
            1 => Self::IntersectingAxes,
            2 => Self::ChainDrive,
            _ => Self::ParallelAxes,
        }
    }
}

/// The shape of a character.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CharacterShape {
    /// C: dCapsuleClass.
    Capsule = sys::dCapsuleClass as isize,
    /// C: dCylinderClass.
    Cylinder = sys::dCylinderClass as isize,
    /// C: dBoxClass.
    Box = sys::dBoxClass as isize,
}
#[allow(dead_code)]
impl CharacterShape {
    pub(crate) fn number(self) -> i32 {
        self as i32
    }
    pub(crate) fn of_number(number: i32) -> Self {
        match number {
            2 => Self::Capsule,
            3 => Self::Cylinder,
            1 => Self::Box,
            _ => Self::Capsule,
        }
    }
}
