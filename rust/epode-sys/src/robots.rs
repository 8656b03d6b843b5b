// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by rust/tools/generate.py from the public headers.
use super::*;

#[repr(C)]
pub struct dxRobotModel {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxRobot {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxBatch {
    _private: [u8; 0],
    _marker: Unshared,
}
/// A model. Its handle is never that of another one.
pub type dRobotModelID = *mut dxRobotModel;
/// A robot. Its handle is never that of another one.
pub type dRobotID = *mut dxRobot;
/// A batch. Its handle is never that of another one.
pub type dBatchID = *mut dxBatch;
/// What a line of a report is about.
pub type dRobotNote = c_uint;
/// read as something else with the same motion
pub const dRobotChanged: dRobotNote = 0;
/// read as something with nearly the same motion
pub const dRobotApproximated: dRobotNote = 1;
/// left out
pub const dRobotIgnored: dRobotNote = 2;
/// wrong: no robot is made of the model
pub const dRobotError: dRobotNote = 3;
/// What a joint of a model leaves free.
pub type dRobotJointKind = c_uint;
/// an angle about the axis
pub const dRobotHinge: dRobotJointKind = 0;
/// a distance along the axis
pub const dRobotSlide: dRobotJointKind = 1;
/// a turn about the anchor
pub const dRobotBall: dRobotJointKind = 2;
/// everything
pub const dRobotFree: dRobotJointKind = 3;
/// What of the copies is read or written.
pub type dBatchQuantity = c_uint;
/// coordinates; can be written
pub const dBatchPositions: dBatchQuantity = 0;
/// velocities; can be written
pub const dBatchVelocities: dBatchQuantity = 1;
/// of actuators, in their order; can be written
pub const dBatchControls: dBatchQuantity = 2;
/// along the velocities, N or N m, until they are changed; can be written
pub const dBatchAppliedForces: dBatchQuantity = 3;
/// of the last step: three of each contact point (normal, two tangents), then of limits, dry friction,
/// limited servos, couplings and tendons (limit, then drive), N or N m; at the end three torques of each contact
/// point with torsional friction (about the normal, two tangents), N m, then of loops the force on the
/// first link in the world's axes, of welds the torque too
pub const dBatchConstraintForces: dBatchQuantity = 4;
/// 1: the copy's numbers left the finite; it keeps its last state until it is reset
pub const dBatchBad: dBatchQuantity = 5;
/// what the last sweep of the last step changed, m/s
pub const dBatchResidual: dBatchQuantity = 6;
/// of the last step
pub const dBatchSweeps: dBatchQuantity = 7;
/// of actuators with a filter between control and force, in their order; can be written
pub const dBatchActivations: dBatchQuantity = 8;
/// of links' origins, in the world: three each, the world's own (0) first
pub const dBatchLinkPositions: dBatchQuantity = 9;
/// of links, in the world
pub const dBatchLinkQuaternions: dBatchQuantity = 10;
/// angular, then linear of the point of the link that is at C, the centre of mass of its tree (all that
/// hangs on one link whose parent is the world), in the world's axes; MuJoCo's cvel
pub const dBatchLinkVelocities: dBatchQuantity = 11;
/// about C, in the world's axes: xx yy zz xy xz yz, mass times the place of the centre from C, mass;
/// MuJoCo's cinert
pub const dBatchLinkInertias: dBatchQuantity = 12;
/// of the last step's contacts and loops, on links: torque about C, force; MuJoCo's cfrc\_ext. Nothing on the world
pub const dBatchLinkForces: dBatchQuantity = 13;
/// of all links
pub const dBatchCentreOfMass: dBatchQuantity = 14;
/// along the velocities, in this state under these controls
pub const dBatchActuatorForces: dBatchQuantity = 15;
/// along the velocities, of the last step's contacts, loops, limits, dry friction, couplings
pub const dBatchVelocityConstraintForces: dBatchQuantity = 16;
/// that the file names, in its order: of joints, actuators and frames in this state; accelerometer, force, torque
/// and touch of the last step, where it began. dBatchGetSensor has their places
pub const dBatchSensors: dBatchQuantity = 17;
/// Numbers of the model that copies may have of their own.
pub type dBatchParameter = c_uint;
/// three, m/s^2
pub const dBatchGravity: dBatchParameter = 0;
/// of links, kg; with one the link's inertia about its centre changes in proportion
pub const dBatchMasses: dBatchParameter = 1;
/// of pairs of shapes that may touch, in the batch's order
pub const dBatchFrictions: dBatchParameter = 2;
/// of rotors, along the velocities, kg m^2 or kg
pub const dBatchArmatures: dBatchParameter = 3;
/// of joints, along the velocities, N m s or N s/m
pub const dBatchDampings: dBatchParameter = 4;
/// of joints' springs, along the velocities, N m or N/m
pub const dBatchStiffnesses: dBatchParameter = 5;
/// of actuators
pub const dBatchGains: dBatchParameter = 6;
/// three, m: by how much shapes of the world and of all that stands still are moved
pub const dBatchTerrain: dBatchParameter = 7;
/// of pairs of shapes, m: 0 of those without (MJCF's condim below 4)
pub const dBatchTorsionalFrictions: dBatchParameter = 8;
/// of pairs of shapes, m: 0 of those without (MJCF's condim below 6)
pub const dBatchRollingFrictions: dBatchParameter = 9;
/// How derivatives of a step are found.
pub type dBatchMethod = c_uint;
/// central differences of steps, solved tightly: at a corner of the step the mean of both sides
pub const dBatchDifferences: dBatchMethod = 0;
/// the implicit function theorem at the contacts, limits and friction that act in this step: at a corner the side
/// of the state
pub const dBatchExact: dBatchMethod = 1;
/// Axes in which rays are given; all of them begin at the link's origin.
pub type dBatchRayAxes = c_uint;
/// the link's: rangefinders, lidars
pub const dBatchRaysOfLink: dBatchRayAxes = 0;
/// the world's
pub const dBatchRaysOfWorld: dBatchRayAxes = 1;
/// z up, x where the link's x heads: scans of the ground's heights
pub const dBatchRaysUpright: dBatchRayAxes = 2;
/// How a file is read. Start from dRobotOptionsInit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotOptions {
    /// sizeof(dRobotOptions), set by the caller or dRobotOptionsInit
    pub struct_size: c_uint,
    /// 1: what is approximated or ignored is an error
    pub strict: c_int,
    /// 1: links that are fixed to others stay links
    pub keep_fixed: c_int,
    /// 1: the root link of a URDF is fixed to the world
    pub fixed_base: c_int,
    /// 1: inertias that no body can have are mended
    pub repair: c_int,
    /// 1: moving links without an inertial get that of their shapes, 1000 kg/m^3
    pub inertia_from_shapes: c_int,
    /// 1: meshes collide as triangles, 0: as their convex hulls
    pub meshes_as_triangles: c_int,
    /// mass of other moving links without an inertial, kg; 0: such a link is an error
    pub missing_mass: dReal,
    /// more folders that may be read, a colon between two; NULL: none
    pub roots: *const c_char,
    /// 1: meshes that are not convex collide as several hulls each
    pub meshes_as_parts: c_int,
    /// of a mesh, up to 256; 0: 32
    pub max_parts: c_int,
    /// of such a hull, 4 or more; 0: 64
    pub max_part_vertices: c_int,
    /// how far a hull may reach out of its mesh, m; 0: 2.5 % of its longest side
    pub part_tolerance: dReal,
}
/// A line of a model's report. The texts live as long as the model.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotReportLine {
    /// a dRobotNote
    pub note: c_int,
    /// in the file, 0 where unknown
    pub line: c_int,
    /// its path
    pub file: *const c_char,
    /// what happened
    pub text: *const c_char,
}
/// A link. The name lives as long as the model.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotLink {
    /// as in the file
    pub name: *const c_char,
    /// its number, -1 of link 0
    pub parent: c_int,
    /// between it and its parent
    pub joints: c_int,
    /// that touch
    pub shapes: c_int,
    /// kg
    pub mass: dReal,
    /// of mass, in the link's frame, m
    pub centre: dVector3,
    /// about the centre, in the link's axes, kg m^2
    pub inertia: dMatrix3,
}
/// A joint between a link and its parent. The name lives as long as the model.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotJoint {
    /// as in the file
    pub name: *const c_char,
    /// a dRobotJointKind
    pub kind: c_int,
    /// the link that it moves
    pub link: c_int,
    /// number of its first coordinate among all
    pub position: c_int,
    /// in the link's frame, m
    pub anchor: dVector3,
    /// in the link's frame, of unit length
    pub axis: dVector3,
    /// lower limit of its coordinate, -dInfinity for none
    pub low: dReal,
    /// upper limit, dInfinity for none
    pub high: dReal,
    /// N or N m, dInfinity for none
    pub max_force: dReal,
    /// m/s or rad/s, dInfinity for none
    pub max_velocity: dReal,
}
/// An actuator. The name lives as long as the model.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotActuator {
    /// as in the file
    pub name: *const c_char,
    /// that it acts on, -1 of one that acts on a tendon, a site or a link
    pub joint: c_int,
    /// 1: its force follows its activation, which follows the control in time
    pub is_filtered: c_int,
    /// least control, -dInfinity for none
    pub low: dReal,
    /// largest control, dInfinity for none
    pub high: dReal,
}
/// Where inverse kinematics is to bring a frame. Start from dRobotTargetInit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotTarget {
    /// that the frame belongs to
    pub link: c_int,
    /// the frame's origin in the link's frame, m; 0
    pub point: dVector3,
    /// its turn there; none
    pub point_q: dQuaternion,
    /// where the origin is to be, in the model's world, m
    pub position: dVector3,
    /// how the frame is to be turned; not at all
    pub q: dQuaternion,
    /// factor of an error of 1 m, 0: any position; 1
    pub position_weight: dReal,
    /// factor of an error of 1 rad, 0: any orientation; 1
    pub orientation_weight: dReal,
}
/// How inverse kinematics searches. Start from dRobotInverseOptionsInit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotInverseOptions {
    /// sizeof(dRobotInverseOptions), which dRobotInverseOptionsInit sets
    pub struct_size: c_uint,
    /// of a start, 1 ... 1000; 100
    pub max_iterations: c_int,
    /// from the given positions, then farther and farther away, 1 ... 1000; 32
    pub max_starts: c_int,
    /// weighted error of a target that is reached; 1e-10, in floats 1e-5
    pub tolerance: dReal,
    /// of each velocity: 0: it stays, 2: rather than one of 1; NULL: 1 each
    pub weights: *const dReal,
    /// positions to be near where the targets leave a choice; NULL: none
    pub posture: *const dReal,
}
/// What inverse kinematics found. Set struct\_size before.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotInverseResult {
    /// sizeof(dRobotInverseResult), set by the caller
    pub struct_size: c_uint,
    /// 1: all targets within the tolerance
    pub is_reached: c_int,
    /// that were made
    pub starts: c_int,
    /// of all starts
    pub iterations: c_int,
    /// root of the sum of the squares of all weighted errors
    pub residual: dReal,
    /// the largest, m
    pub position_error: dReal,
    /// the largest, rad
    pub orientation_error: dReal,
}
/// How a batch steps. Start from dBatchOptionsInit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dBatchOptions {
    /// sizeof(dBatchOptions), set by the caller or dBatchOptionsInit
    pub struct_size: c_uint,
    /// 1: the copies' numbers are doubles, 0: floats
    pub doubles: c_int,
    /// that step, the caller included; 0: as many as the machine has
    pub threads: c_int,
    /// over all constraints in a step, 1 or more: 200
    pub max_sweeps: c_int,
    /// s, above 0: 0.002
    pub stepsize: dReal,
    /// share of an overlap, or of a limit passed, that a step takes back, 0 to 1: 0.2
    pub erp: dReal,
    /// speed of taking back, m/s or rad/s, 0 or more: 2
    pub max_correction: dReal,
    /// surfaces nearer than this are looked at in any case, m, 0 or more: 0.005
    pub reach: dReal,
    /// sweeps end when the last one changed no speed by more, m/s; 0: 1e-5 in floats, 1e-6 in doubles
    pub tolerance: dReal,
    /// 1: each thread but the caller's stays on a processor of its own, where the system can: 0
    pub pinned: c_int,
}
/// How well hulls are to fit. Start from dDecompositionOptionsInit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dDecompositionOptions {
    /// sizeof(dDecompositionOptions), which dDecompositionOptionsInit sets
    pub struct_size: c_uint,
    /// of a hull, 4 or more, 0: as many as it has; 64
    pub max_vertices: c_int,
    /// how far from the solid a hull may reach, m; 0: 2.5 % of its longest side; 0
    pub tolerance: dReal,
}
/// What a decomposition came to. Set struct\_size before.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dDecompositionReport {
    /// sizeof(dDecompositionReport), set by the caller
    pub struct_size: c_uint,
    /// 0: the mesh has edges without a second triangle, or wound the other way
    pub is_closed: c_int,
    /// that was searched for, m
    pub tolerance: dReal,
    /// how far from the solid a measured point of a hull is at most, m
    pub surplus: dReal,
    /// how far outside the hulls a point of the solid is at most, m: for max\_vertices
    pub uncovered: dReal,
    /// distance of the measured points, m
    pub cell: dReal,
}
/// What touches a link.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotTouch {
    /// sizeof(dRobotTouch), set by the caller
    pub struct_size: c_uint,
    /// of contact that bear something
    pub points: c_int,
    /// sum of all normal forces, N
    pub normal_force: dReal,
    /// on the link, friction included, in the world's axes, N
    pub force: dVector3,
    /// of pressure, in the world, m
    pub centre: dVector3,
}
/// A pinhole camera. It looks along its -z axis, x to the right, y up. Start from dRobotCameraInit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotCamera {
    /// sizeof(dRobotCamera), set by the caller
    pub struct_size: c_uint,
    /// pixels of a row, 1 ... 8192; 320
    pub width: c_int,
    /// rows, 1 ... 8192; 240
    pub height: c_int,
    /// of view, from the lowest to the highest row, rad; 0.8
    pub field: dReal,
    /// what is farther is not seen, m; 100
    pub max_distance: dReal,
    /// that work on it, 0: one for each processor; 1
    pub threads: c_int,
}
/// A sensor that a file names. The texts live as long as the model.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRobotSensor {
    /// as in the file
    pub name: *const c_char,
    /// as in the file: accelerometer, gyro, force, torque, touch ...
    pub kind: *const c_char,
    /// on what it sits
    pub object: *const c_char,
    /// that dRobotReadSensor reads, 0: it is not computed
    pub values: c_int,
}
extern "C" {
    /// Fills \*options with zeros, and writes struct\_size, which is sizeof(dRobotOptions), to it. Returns 1.
    /// Refused: another struct\_size.
    pub fn dRobotOptionsInit(options: *mut dRobotOptions, struct_size: c_uint) -> c_int;
    /// Read the robot file path.
    ///
    /// Files are read in the folder of path, its parent, its ROS package, the folders of options-\>roots and
    /// packages that package:// finds there, in ROS\_PACKAGE\_PATH, AMENT\_PREFIX\_PATH or upwards. options may be
    /// NULL: as dRobotOptionsInit leaves them. The root element says whether it is URDF, MJCF or SDF. A model with
    /// errors is returned too, for its report; a message tells the first. Destroy it with dRobotModelDestroy.
    pub fn dRobotModelLoad(path: *const c_char, options: *const dRobotOptions) -> dRobotModelID;
    /// Read the size bytes of text as if they were the file path.
    ///
    /// Files are read in the folder of path, its parent, its ROS package, the folders of options-\>roots and
    /// packages that package:// finds there, in ROS\_PACKAGE\_PATH, AMENT\_PREFIX\_PATH or upwards. options may be
    /// NULL: as dRobotOptionsInit leaves them. The root element says whether it is URDF, MJCF or SDF. A model with
    /// errors is returned too, for its report; a message tells the first. Destroy it with dRobotModelDestroy.
    pub fn dRobotModelLoadText(path: *const c_char, text: *const c_char, size: usize, options: *const dRobotOptions) -> dRobotModelID;
    /// Writes the model to the file path: as URDF if it ends in .urdf, as MJCF if in .xml or .mjcf. Paths of meshes
    /// count from its folder. A message names each thing that the format cannot say. Returns 1, or 0 when
    /// refused: a model with errors, another ending, a file that cannot be written.
    pub fn dRobotModelSave(model: dRobotModelID, path: *const c_char) -> c_int;
    /// Destroys the model. Robots that were made of it stay.
    pub fn dRobotModelDestroy(model: dRobotModelID);
    /// Copies up to capacity lines of the report to lines. Returns how many there are.
    pub fn dRobotModelGetReport(model: dRobotModelID, lines: *mut dRobotReportLine, capacity: c_int) -> c_int;
    /// Returns 1 if the report has an error, else 0.
    pub fn dRobotModelHasErrors(model: dRobotModelID) -> c_int;
    /// Copies up to capacity links to links. Returns how many there are.
    pub fn dRobotModelGetLinks(model: dRobotModelID, links: *mut dRobotLink, capacity: c_int) -> c_int;
    /// Copies up to capacity joints to joints. Returns how many there are.
    pub fn dRobotModelGetJoints(model: dRobotModelID, joints: *mut dRobotJoint, capacity: c_int) -> c_int;
    /// Copies up to capacity actuators to actuators. Returns how many there are.
    pub fn dRobotModelGetActuators(model: dRobotModelID, actuators: *mut dRobotActuator, capacity: c_int) -> c_int;
    /// Returns how many coordinates the joints have.
    pub fn dRobotModelGetNumPositions(model: dRobotModelID) -> c_int;
    /// Returns how many actuators the model has.
    pub fn dRobotModelGetNumActuators(model: dRobotModelID) -> c_int;
    /// Returns how many named start poses the model has.
    pub fn dRobotModelGetNumStarts(model: dRobotModelID) -> c_int;
    /// Returns the number of the link of that name; merged links and sites are those that
    /// they are part of. -1 if there is none.
    pub fn dRobotModelFindLink(model: dRobotModelID, name: *const c_char) -> c_int;
    /// Returns the number of the joint of that name, or -1.
    pub fn dRobotModelFindJoint(model: dRobotModelID, name: *const c_char) -> c_int;
    /// Returns the number of the actuator of that name, or -1.
    pub fn dRobotModelFindActuator(model: dRobotModelID, name: *const c_char) -> c_int;
    /// Copies up to capacity coordinates of the pose in which the file describes the
    /// robot to positions. Returns how many there are.
    pub fn dRobotModelGetReference(model: dRobotModelID, positions: *mut dReal, capacity: c_int) -> c_int;
    /// Copies up to capacity coordinates of the start pose of that number to positions.
    /// Returns how many there are. Refused: a number outside 0 ... dRobotModelGetNumStarts - 1.
    pub fn dRobotModelGetStart(model: dRobotModelID, number: c_int, positions: *mut dReal, capacity: c_int) -> c_int;
    /// Returns the name of that start pose, which lives as long as the model. NULL is
    /// returned where the number is refused.
    pub fn dRobotModelGetStartName(model: dRobotModelID, number: c_int) -> *const c_char;
    /// Writes the pose of up to capacity links in the model's world to poses, 7 reals each: position, m, and
    /// quaternion. positions: count coordinates. Returns how many links there are. Refused: a count other than
    /// dRobotModelGetNumPositions.
    pub fn dRobotModelGetPoses(model: dRobotModelID, positions: *const dReal, count: c_int, poses: *mut dReal, capacity: c_int) -> c_int;
    /// Returns how many velocities the joints of the model have.
    pub fn dRobotModelGetNumVelocities(model: dRobotModelID) -> c_int;
    /// Writes the Jacobian of a point of a link (in its frame, m; NULL: its origin) to jacobian: six rows, linear
    /// then angular, in the world's axes, each of as many reals as there are velocities. At most capacity reals
    /// are written. Returns how many there are. Refused: no such link.
    pub fn dRobotModelGetJacobian(model: dRobotModelID, positions: *const dReal, link: c_int, point: *const dReal, jacobian: *mut dReal, capacity: c_int) -> c_int;
    /// Writes how far couplings and loops are from what they ask, c(positions), to residuals, and C = dc/ds, s being
    /// the velocities, to jacobian, row by row. A coupling has one row (the sum of its factors times coordinates
    /// less its offset); a loop three (m, in the world's axes), and three more (rad) if it is welded. Motions that
    /// keep them have C s = 0: of a frame with the Jacobian J only J N counts, the columns of N being a basis of
    /// those s. At most capacity rows are written; either array may be NULL. Returns how many rows there are.
    pub fn dRobotModelGetConstraints(model: dRobotModelID, positions: *const dReal, residuals: *mut dReal, jacobian: *mut dReal, capacity: c_int) -> c_int;
    /// Writes the gravity of the file, m/s^2, three reals; steps take that of the world that the robot is built in. Returns 1.
    /// Refused: a NULL gravity.
    pub fn dRobotModelGetGravity(model: dRobotModelID, gravity: *mut dReal) -> c_int;
    /// Returns the time of a step that the file asks for (MJCF's timestep, SDF's max\_step\_size), s; 0 where it does not say. Who
    /// steps the world decides.
    pub fn dRobotModelGetStepsize(model: dRobotModelID) -> dReal;
    /// Writes the mass matrix to matrix, row by row, rotor inertias on its diagonal. At most capacity reals are
    /// written. Returns how many there are: the square of the number of velocities.
    pub fn dRobotModelGetMassMatrix(model: dRobotModelID, positions: *const dReal, matrix: *mut dReal, capacity: c_int) -> c_int;
    /// Writes to forces what gives the accelerations at these velocities, against the file's gravity: a force, N
    /// or N m, for each velocity. Springs, dampers and friction are not in it. velocities and accelerations may
    /// be NULL: zeros; both NULL: gravity compensation. At most capacity reals are written. Returns how many
    /// there are.
    pub fn dRobotModelGetInverseDynamics(model: dRobotModelID, positions: *const dReal, velocities: *const dReal, accelerations: *const dReal, forces: *mut dReal, capacity: c_int) -> c_int;
    /// Writes what the medium of the file exerts at these velocities (MJCF: density, viscosity and wind of its option; the
    /// inertia model of MuJoCo) to forces: a force, N or N m, for each velocity; zeros without a medium. At most
    /// capacity reals are written. Returns how many there are.
    pub fn dRobotModelGetFluidForces(model: dRobotModelID, positions: *const dReal, velocities: *const dReal, forces: *mut dReal, capacity: c_int) -> c_int;
    /// Returns the number of the tendon of that name (MJCF), or -1.
    pub fn dRobotModelFindTendon(model: dRobotModelID, name: *const c_char) -> c_int;
    /// Writes the lengths of up to capacity tendons to lengths: of a spatial one that of its way over
    /// sites and round geoms (m), of a fixed one its sum of coordinates; and their moment arms, the derivatives of the
    /// lengths by the velocities, to jacobian, row by row. Either array may be NULL. Returns how many tendons there
    /// are.
    pub fn dRobotModelGetTendons(model: dRobotModelID, positions: *const dReal, lengths: *mut dReal, jacobian: *mut dReal, capacity: c_int) -> c_int;
    /// Returns the number of the link of that name, or of the link that the merged link or site of that name is
    /// part of, and writes where it stands in that link's frame to frame: 7 reals, position and quaternion.
    /// Returns -1 if there is none; frame stays then.
    pub fn dRobotModelFindFrame(model: dRobotModelID, name: *const c_char, frame: *mut dReal) -> c_int;
    /// Fills \*target with the defaults for that link. Returns 1.
    pub fn dRobotTargetInit(target: *mut dRobotTarget, link: c_int) -> c_int;
    /// Fills \*options with the defaults. Returns 1. Refused: a struct\_size other than
    /// sizeof(dRobotInverseOptions).
    pub fn dRobotInverseOptionsInit(options: *mut dRobotInverseOptions, struct_size: c_uint) -> c_int;
    /// Replaces positions by those, within the limits of the joints, at which count targets are reached, or by the
    /// nearest that it found. Couplings and loops hold, also where targets cannot be reached. Damped least
    /// squares; the same arguments give the same bits. options may be NULL: the defaults; result may be NULL. Returns 1 if the targets are reached, 2 if not, and 0 when refused:
    /// targets without a link, weights that are negative, structures of another size.
    pub fn dRobotModelGetInverse(model: dRobotModelID, targets: *const dRobotTarget, count: c_int, options: *const dRobotInverseOptions, positions: *mut dReal, result: *mut dRobotInverseResult) -> c_int;
    /// Makes a robot of the model in the world, with its geoms in the space (NULL: in none).
    /// position and q place the model's world in the world; either may be NULL: none. It begins at the
    /// reference position. A message names what is not built. Refused: a model with errors.
    pub fn dRobotCreate(world: dWorldID, space: dSpaceID, model: dRobotModelID, position: *const dReal, q: *const dReal) -> dRobotID;
    /// Destroys the robot's bodies, joints and geoms.
    pub fn dRobotDestroy(robot: dRobotID);
    /// Returns the body of a link, 0 of link 0 where it has none. Refused: no such link.
    pub fn dRobotGetBody(robot: dRobotID, link: c_int) -> dBodyID;
    /// Returns ODE's joint of a joint of the model, whose axis 0 it is; 0 of a free joint, and
    /// 0 with a message of a number that no joint has.
    pub fn dRobotGetJoint(robot: dRobotID, joint: c_int) -> dJointID;
    /// Moves all bodies to where the count coordinates of positions put them, at rest.
    /// Returns 1. Refused: a count other than dRobotModelGetNumPositions.
    pub fn dRobotSetPositions(robot: dRobotID, positions: *const dReal, count: c_int) -> c_int;
    /// Copies up to capacity coordinates to positions (0 to ask for the number alone, the
    /// array may then be null). Returns how many there are. Refused: a negative capacity.
    pub fn dRobotGetPositions(robot: dRobotID, positions: *mut dReal, capacity: c_int) -> c_int;
    /// Gives all bodies the velocities that the count velocities of the joints make, where
    /// they are. Returns 1. Refused: a count other than dRobotModelGetNumVelocities.
    pub fn dRobotSetVelocities(robot: dRobotID, velocities: *const dReal, count: c_int) -> c_int;
    /// Copies up to capacity velocities to velocities (0 to ask for the number alone, the
    /// array may then be null). Returns how many there are. Refused: a negative capacity.
    pub fn dRobotGetVelocities(robot: dRobotID, velocities: *mut dReal, capacity: c_int) -> c_int;
    /// Sets the control of an actuator, by its number in the model, clamped to its range.
    /// Returns 1. Refused: no such actuator.
    pub fn dRobotSetControl(robot: dRobotID, actuator: c_int, control: dReal) -> c_int;
    /// Returns it, 0 at first. Refused: no such actuator.
    pub fn dRobotGetControl(robot: dRobotID, actuator: c_int) -> dReal;
    /// Lets a hinge or slider be pulled to the target, m or rad, by a spring of stiffness and
    /// a damper of damping, at most the joint's max\_force, next to the model's own springs and dampers;
    /// both 0: no longer. Returns 1, or 0 when refused: a negative argument; an index that no hinge or slider
    /// has.
    pub fn dRobotSetTarget(robot: dRobotID, joint: c_int, target: dReal, stiffness: dReal, damping: dReal) -> c_int;
    /// Adds what the medium of the file exerts to what acts on the robot's bodies until the next step: call it before
    /// each, with its size, s. What would turn a link's motion round within such a step only stops it (0: it is
    /// exerted as it is). Returns how many links of the file it acts on: 0 without a medium. Refused: a negative
    /// stepsize.
    pub fn dRobotAddFluidForces(robot: dRobotID, stepsize: dReal) -> c_int;
    /// Adds all that acts only from step to step: call it before each, with its size, s. It moves the filters of actuators on,
    /// and adds spatial tendons (springs, dampers, limits, actuators) and what dRobotAddFluidForces adds to what acts on
    /// the bodies. A tendon that is stiffer than steps of that size can follow is as stiff as
    /// they can; a limit gives way by the square of the step times the acceleration that it stops. Without calls
    /// spatial tendons do nothing, and filtered actuators act at once. Returns how many filters, tendons and links
    /// it acts on. Refused: a stepsize that is not above 0.
    pub fn dRobotAddForces(robot: dRobotID, stepsize: dReal) -> c_int;
    /// Sets it to activation, within its range; nothing changes of an actuator without a filter.
    /// Returns 1.
    ///
    /// What the force of a filtered actuator follows instead of what dRobotSetControl has set; 0 at first.
    pub fn dRobotSetActivation(robot: dRobotID, actuator: c_int, activation: dReal) -> c_int;
    /// Returns it, 0 of an actuator without a filter.
    /// Refused: no such actuator.
    ///
    /// What the force of a filtered actuator follows instead of what dRobotSetControl has set; 0 at first.
    pub fn dRobotGetActivation(robot: dRobotID, actuator: c_int) -> dReal;
    /// Returns how many there are.
    ///
    /// Bodies that the program moves (MJCF: mocap): they stand where they have been put, whatever touches them, and pull what is
    /// welded to them.
    pub fn dRobotModelGetNumMocap(model: dRobotModelID) -> c_int;
    /// Returns the link of the one of that number. Refused: no such number (0 is returned).
    ///
    /// Bodies that the program moves (MJCF: mocap): they stand where they have been put, whatever touches them, and pull what is
    /// welded to them.
    pub fn dRobotModelGetMocap(model: dRobotModelID, number: c_int) -> c_int;
    /// Puts such a link at the position, m, and quaternion q in the world; NULL: as it is. Returns 1.
    /// Refused: a link that is none of them; a quaternion of length 0.
    ///
    /// Bodies that the program moves (MJCF: mocap): they stand where they have been put, whatever touches them, and pull what is
    /// welded to them.
    pub fn dRobotSetMocap(robot: dRobotID, link: c_int, position: *const dReal, q: *const dReal) -> c_int;
    /// Copies up to capacity \`numbers\` (0 to ask how many there are, \`numbers\` may then be null). Returns
    /// how many there are, as many for all robots of a model. Refused: a negative capacity.
    ///
    /// What a robot has in addition to its world's state (dWorldGetState): controls, activations and what joints are pulled to. Save both,
    /// and set this after dWorldSetState; then the robot goes on with the same bits.
    pub fn dRobotGetState(robot: dRobotID, numbers: *mut dReal, capacity: c_int) -> c_int;
    /// Sets them, and lets sensors begin again. Returns 1. Refused: another count; \`numbers\` that no robot
    /// of this model has returned.
    ///
    /// What a robot has in addition to its world's state (dWorldGetState): controls, activations and what joints are pulled to. Save both,
    /// and set this after dWorldSetState; then the robot goes on with the same bits.
    pub fn dRobotSetState(robot: dRobotID, numbers: *const dReal, count: c_int) -> c_int;
    /// Fills \*options with defaults, and writes struct\_size, which is sizeof(dBatchOptions), to it. Returns 1.
    /// Refused: another struct\_size.
    pub fn dBatchOptionsInit(options: *mut dBatchOptions, struct_size: c_uint) -> c_int;
    /// Create a batch of \`count\` copies of the model, at the reference position and at rest. options may be NULL. The model may be
    /// destroyed afterwards. Destroy the batch with dBatchDestroy. Returns 0, with a message that names the element, when refused: a
    /// model with errors; what a batch does not have (tendons with a path on which something acts); count below 1; options out of bounds;
    /// too little memory.
    pub fn dBatchCreate(model: dRobotModelID, count: c_int, options: *const dBatchOptions) -> dBatchID;
    /// Destroys the batch.
    pub fn dBatchDestroy(batch: dBatchID);
    /// Returns how many copies there are.
    pub fn dBatchGetNumCopies(batch: dBatchID) -> c_int;
    /// Returns the bytes of a number: 4 or 8.
    pub fn dBatchGetNumberSize(batch: dBatchID) -> c_int;
    /// Returns how many threads step.
    pub fn dBatchGetNumThreads(batch: dBatchID) -> c_int;
    /// Returns how many numbers of the quantity a copy has.
    pub fn dBatchGetSize(batch: dBatchID, quantity: c_int) -> c_int;
    /// Returns how many numbers of dBatchSensors a sensor of the model has, as dRobotModelGetSensors numbers them; 0: a batch does not
    /// compute it (rangefinders: dBatchCastRays; kinds that worlds do not compute). \*first, unless first is NULL, is where they begin. Refused: no
    /// such sensor.
    pub fn dBatchGetSensor(batch: dBatchID, sensor: c_int, first: *mut c_int) -> c_int;
    /// Copies the quantity to values.
    ///
    /// Of \`count\` copies from \`first\` on. Both return 1.
    pub fn dBatchRead(batch: dBatchID, quantity: c_int, first: c_int, count: c_int, values: *mut c_void) -> c_int;
    /// Takes it from values. Refused besides: a quantity that cannot be written, numbers that are not finite or
    /// whose squares would not be, quaternions of no length.
    ///
    /// Of \`count\` copies from \`first\` on. Both return 1.
    pub fn dBatchWrite(batch: dBatchID, quantity: c_int, first: c_int, count: c_int, values: *const c_void) -> c_int;
    /// Returns how many numbers a copy has of the parameter, a dBatchParameter.
    ///
    /// Of \`count\` copies from \`first\` on, (count, size) as in dBatchRead.
    pub fn dBatchGetParameterSize(batch: dBatchID, parameter: c_int) -> c_int;
    /// Copies them to \`values\`. Returns 1.
    ///
    /// Of \`count\` copies from \`first\` on, (count, size) as in dBatchRead.
    pub fn dBatchReadParameter(batch: dBatchID, parameter: c_int, first: c_int, count: c_int, values: *mut c_void) -> c_int;
    /// Takes them from values, for those copies only. Returns 1. Refused besides: what is not finite or
    /// beyond 1e15; masses of moving links that are not above 0; negative frictions, armatures, dampings and stiffnesses;
    /// frictions against turning of pairs without them.
    ///
    /// Of \`count\` copies from \`first\` on, (count, size) as in dBatchRead.
    pub fn dBatchWriteParameter(batch: dBatchID, parameter: c_int, first: c_int, count: c_int, values: *const c_void) -> c_int;
    /// Writes the Jacobians of a point of a link (in its frame, m; NULL: its origin) in the states of \`count\` copies from \`first\` on to
    /// values, (count, 6, velocities): linear, then angular, in the world's frame, what the velocities make of it. Returns 1. Refused
    /// besides: no such link; a point that is not finite or beyond 1e9.
    pub fn dBatchJacobian(batch: dBatchID, link: c_int, point: *const dReal, first: c_int, count: c_int, values: *mut c_void) -> c_int;
    /// Returns n.
    ///
    /// Derivatives of the next state of \`count\` copies from \`first\` on, under the controls and applied forces that they have, over the
    /// state and the controls. Nothing moves. A state's n numbers: tangents of positions (along the velocities, of turns a rotation vector
    /// in the link's frame), velocities, activations.
    pub fn dBatchGetTangentSize(batch: dBatchID) -> c_int;
    /// Writes d(next)/d(state), (count, n, n), to a, and d(next)/d(control), (count, n, controls), to b; of bad copies NaN.
    /// Of a control at an end of its range the inner side counts; outside it is 0. Returns 1. Refused besides: another method or
    /// distance; dBatchExact of a model with loops or friction against turning.
    ///
    /// Derivatives of the next state of \`count\` copies from \`first\` on, under the controls and applied forces that they have, over the
    /// state and the controls. Nothing moves. A state's n numbers: tangents of positions (along the velocities, of turns a rotation vector
    /// in the link's frame), velocities, activations.
    pub fn dBatchLinearise(batch: dBatchID, method: c_int, distance: dReal, first: c_int, count: c_int, a: *mut c_void, b: *mut c_void) -> c_int;
    /// Writes derivatives of the next state over the numbers of the parameter, (count, n, its size), to values, as dBatchLinearise with
    /// that method does. distance is relative to the number; of one that is 0 both sides are a sixteenth of the
    /// usual distance away. Returns 1.
    pub fn dBatchLineariseParameter(batch: dBatchID, method: c_int, distance: dReal, parameter: c_int, first: c_int, count: c_int, values: *mut c_void) -> c_int;
    /// Bind an array of all copies to the quantity: from now on every step and reset writes it, and every step first
    /// takes what can be written from it. It is filled at once, and must live until it is replaced, unbound by NULL, or the batch is
    /// destroyed. Returns 1.
    pub fn dBatchBind(batch: dBatchID, quantity: c_int, values: *mut c_void) -> c_int;
    /// Steps all copies \`steps\` times, with the same controls and applied forces. Copies that are bad stay as they are. Returns 1.
    /// Refused: steps below 0; bound arrays with numbers that dBatchWrite refuses.
    pub fn dBatchStep(batch: dBatchID, steps: c_int) -> c_int;
    /// Puts copies back to the reference position, at rest, with no controls and forces: those whose byte of mask, one a copy, is not 0;
    /// all if mask is NULL. Returns 1.
    pub fn dBatchReset(batch: dBatchID, mask: *const c_uchar) -> c_int;
    /// Casts rays from a link of each of \`count\` copies from \`first\` on. What the link itself has is not hit, unless it is the world.
    /// link: its number in the model. axes: a dBatchRayAxes, of origins (m, 0: all in the link's origin) and directions (any length but
    /// 0), 3 reals a ray. ranges: floats or doubles, (count, rays), distances to the nearest shape, m, infinite beyond max\_distance.
    /// shapes: the same of ints, which of the model's shapes, counted link by link, was hit, -1 for none; may be 0. The batch's threads
    /// share the work. Returns 1. Refused besides: no such link or axes; a direction of length 0; rays or max\_distance below 0.
    pub fn dBatchCastRays(batch: dBatchID, link: c_int, axes: c_int, rays: c_int, origins: *const dReal, directions: *const dReal, max_distance: dReal, first: c_int, count: c_int, ranges: *mut c_void, shapes: *mut c_int) -> c_int;
    /// Returns how many copies are bad.
    pub fn dBatchCountBad(batch: dBatchID) -> c_int;
    /// Fills \*options with the defaults. Returns 1. Refused: a struct\_size other than
    /// sizeof(dDecompositionOptions).
    pub fn dDecompositionOptionsInit(options: *mut dDecompositionOptions, struct_size: c_uint) -> c_int;
    /// Creates convex geoms in the space, or (0) in none, that together fill a mesh of vertex\_count vertices,
    /// 3 reals each, m, and triangle\_count triangles, 3 indices each, and writes them to geoms: at most capacity,
    /// 1 ... 256. options: NULL for the defaults; report: NULL for none. A mesh with holes wider than a cell is its
    /// surface alone. The same arguments give the same bits. Returns how many there are. Refused: indices beyond
    /// the vertices; vertices in one plane; more than 6 million of either.
    pub fn dCreateConvexDecomposition(space: dSpaceID, vertices: *const dReal, vertex_count: c_int, triangles: *const c_uint, triangle_count: c_int, options: *const dDecompositionOptions, geoms: *mut dGeomID, capacity: c_int, report: *mut dDecompositionReport) -> c_int;
    /// Notes how all bodies of the robot move, so that dRobotGetImu knows their accelerations: call it after every
    /// step, with its size, s. Returns 1. Refused: a stepsize that is not positive.
    pub fn dRobotUpdateSensors(robot: dRobotID, stepsize: dReal) -> c_int;
    /// Copies what springs, dampers and actuators of the joints have exerted, the mean over the last step, to
    /// forces: a number, N or N m, for each velocity; 0 of balls and free joints. Returns how many there are.
    pub fn dRobotGetDriveForces(robot: dRobotID, forces: *mut dReal, capacity: c_int) -> c_int;
    /// Reads an inertial measurement unit, in its own axes: specific\_force, m/s^2, is acceleration minus gravity,
    /// the mean over the last step (at rest: 9.81 upwards), and angular\_velocity, rad/s, the present one. Either may
    /// be NULL. Returns 1. Refused: a robot without dRobotUpdateSensors after its first step.
    pub fn dRobotGetImu(robot: dRobotID, link: c_int, frame: *const dReal, specific_force: *mut dReal, angular_velocity: *mut dReal) -> c_int;
    /// Lets steps write down (mode 1) what the joint between the link and its parent bears,
    /// or no longer (0). Returns 1, or 0 when refused: another mode, a link that no joint holds.
    pub fn dRobotSetForceSensor(robot: dRobotID, link: c_int, mode: c_int) -> c_int;
    /// Reads what the link has exerted on its parent through that joint in the last step,
    /// in the frame's axes: force, N, and torque about its origin, N m. Either may be NULL. Returns 1. Refused:
    /// a link without dRobotSetForceSensor.
    pub fn dRobotGetForceTorque(robot: dRobotID, link: c_int, frame: *const dReal, force: *mut dReal, torque: *mut dReal) -> c_int;
    /// Sums the contacts of a link in the last step: those that the world manages (dWorldSetContactSpace). Set
    /// touch-\>struct\_size, sizeof(dRobotTouch), before; another one is refused. Returns 1.
    pub fn dRobotGetTouch(robot: dRobotID, link: c_int, touch: *mut dRobotTouch) -> c_int;
    /// Casts count rays from the frame's origin, as a rangefinder or lidar does. directions: 3 reals each, of any
    /// length, in the frame's axes. ranges gets the distances to the nearest geoms that are not the link's, m, dInfinity
    /// beyond max\_distance; geoms may be NULL and gets what was hit, or 0. Returns how many rays hit something.
    /// Refused: a direction of length 0; a count or max\_distance below 0.
    pub fn dRobotCastRays(robot: dRobotID, link: c_int, frame: *const dReal, space: dSpaceID, count: c_int, directions: *const dReal, max_distance: dReal, ranges: *mut dReal, geoms: *mut dGeomID) -> c_int;
    /// Fills \*camera with the defaults. Returns 1. Refused: a struct\_size other than sizeof(dRobotCamera).
    pub fn dRobotCameraInit(camera: *mut dRobotCamera, struct_size: c_uint) -> c_int;
    /// Takes a picture by a ray for each pixel, row by row from the top, without a display or graphics card. The
    /// link's own geoms are not seen. depth: distances along the view axis, m, dInfinity of nothing. geoms: what is
    /// seen, 0 of nothing. color: red, green and blue, 0 ... 255, lit from above. Each may be NULL. Returns how many
    /// pixels see something. Refused: a camera outside its limits or of another size.
    pub fn dRobotTakePicture(robot: dRobotID, link: c_int, frame: *const dReal, space: dSpaceID, camera: *const dRobotCamera, depth: *mut dReal, geoms: *mut dGeomID, color: *mut c_uchar) -> c_int;
    /// Copies up to capacity sensors that the file of the model names to sensors. Returns how many there are.
    pub fn dRobotModelGetSensors(model: dRobotModelID, sensors: *mut dRobotSensor, capacity: c_int) -> c_int;
    /// Reads a sensor of the file, by its number: at most capacity numbers are written to values. Returns how many
    /// there are. space is what rangefinders meet, 0 where there are none. Refused: no such sensor; one that is not
    /// computed; what it cannot read yet.
    pub fn dRobotReadSensor(robot: dRobotID, sensor: c_int, space: dSpaceID, values: *mut dReal, capacity: c_int) -> c_int;
}
