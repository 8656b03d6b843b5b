// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by rust/tools/generate.py from the public headers.
#![allow(clippy::useless_conversion, clippy::unnecessary_cast, clippy::doc_lazy_continuation, clippy::doc_overindented_list_items)]
use crate::prelude::*;

/// The surface of a geom. For a pair, friction, bounce and rolling friction follow the rules; the bounce
/// speed is the larger one, velocities of surfaces are subtracted, and compliances add up, as of springs in
/// series. A compliant contact is held, beyond the surface layer and in all steppers, by a spring of
/// stiffness 1/compliance and a damper of damping\_time/compliance at each of its points. Stiffer than 1e9
/// N/m counts as rigid. A surface with a friction axis, seen in the contact plane, bounds friction by the
/// ellipse of its two coefficients; what slides is braked by the point of it that takes most power. Of two
/// such surfaces the one whose coefficients differ more gives the axis. Each field ends with its default.
///
/// C: dMaterial.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// coefficient of Coulomb friction, 0 ... dInfinity (does not slide). 0.6
    pub friction: Real,
    /// restitution: share of the approach speed that comes back, 0 ... 1. 0
    pub bounce: Real,
    /// slower approaches do not rebound, m/s. 1
    pub bounce_speed: Real,
    /// of the surface against the geom, in the geom's frame, m/s: a belt. 0
    pub surface_velocity: Vec3,
    /// largest torque against rolling and spinning, per normal force, m. 0
    pub rolling_friction: Real,
    /// depth per force at a point, m/N; 0: rigid. 0
    pub compliance: Real,
    /// of a compliant surface: damping over stiffness, s. 0
    pub damping_time: Real,
    /// a dCombineRule for friction. dCombineDefault
    pub friction_rule: CombineRule,
    /// for bounce. dCombineDefault
    pub bounce_rule: CombineRule,
    /// for rolling friction. dCombineDefault
    pub rolling_friction_rule: CombineRule,
    /// the geom of the larger one says friction, bounce and rolling friction alone. 0
    pub priority: i32,
    /// coefficient across friction\_axis, where that is not 0. 0.6
    pub cross_friction: Real,
    /// in the geom's frame: friction counts along it; 0: in all directions. 0
    pub friction_axis: Vec3,
    /// 1 ... 255: the other geom's material of that number counts alone, if it has one. 0
    pub kind: i32,
}
#[allow(unused_variables)]
impl Material {
    pub(crate) fn empty() -> sys::dMaterial {
        // Numbers and null pointers: zeros are a value of every field.
        #[allow(unused_mut)]
        let mut raw: sys::dMaterial = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of::<sys::dMaterial>() as u32;
        raw
    }
    pub(crate) fn from_raw(raw: &sys::dMaterial, shared: &Shared) -> Self {
        Self {
            friction: raw.friction,
            bounce: raw.bounce,
            bounce_speed: raw.bounce_speed,
            surface_velocity: vec3(raw.surface_velocity),
            rolling_friction: raw.rolling_friction,
            compliance: raw.compliance,
            damping_time: raw.damping_time,
            friction_rule: CombineRule::of_number(raw.friction_rule as i32),
            bounce_rule: CombineRule::of_number(raw.bounce_rule as i32),
            rolling_friction_rule: CombineRule::of_number(raw.rolling_friction_rule as i32),
            priority: raw.priority,
            cross_friction: raw.cross_friction,
            friction_axis: vec3(raw.friction_axis),
            kind: raw.kind,
        }
    }
    pub(crate) fn to_raw(&self) -> sys::dMaterial {
        let mut raw = Self::empty();
        raw.friction = self.friction;
        raw.bounce = self.bounce;
        raw.bounce_speed = self.bounce_speed;
        raw.surface_velocity = pad3(self.surface_velocity);
        raw.rolling_friction = self.rolling_friction;
        raw.compliance = self.compliance;
        raw.damping_time = self.damping_time;
        raw.friction_rule = self.friction_rule.number();
        raw.bounce_rule = self.bounce_rule.number();
        raw.rolling_friction_rule = self.rolling_friction_rule.number();
        raw.priority = self.priority;
        raw.cross_friction = self.cross_friction;
        raw.friction_axis = pad3(self.friction_axis);
        raw.kind = self.kind;
        raw
    }
}
impl Default for Material {
    fn default() -> Self {
        let mut raw = Self::empty();
        sure(|| unsafe { sys::dMaterialInit(&mut raw, std::mem::size_of::<sys::dMaterial>() as u32) });
        Self::from_raw(&raw, &Shared::none())
    }
}

/// A drive on one axis of a joint: a spring and damper towards a target, a given force, a rotor and dry
/// friction. With position q and rate w it exerts
///
/// force + stiffness (target - q) + damping (target\_velocity - w),   at most force\_limit,
///
/// and besides armature times the deceleration of w, and up to friction against w. All of it is implicit:
/// stiff springs stay stable at any step. Start from zeros: what is 0 is not there.
///
/// C: dDrive.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// N/m or N m/rad, 0 or more
    pub stiffness: Real,
    /// N s/m or N m s/rad, 0 or more
    pub damping: Real,
    /// rotor inertia times the gear ratio squared, kg or kg m^2, 0 or more
    pub armature: Real,
    /// dry friction, N or N m, 0 or more
    pub friction: Real,
    /// position that the spring pulls to, m or rad
    pub target: Real,
    /// rate that the damper pulls to, m/s or rad/s
    pub target_velocity: Real,
    /// feed-forward along the axis, N or N m: of a plain motor, all it does
    pub force: Real,
    /// of spring, damper and force together, N or N m; 0, dInfinity: none
    pub force_limit: Real,
}
#[allow(unused_variables)]
impl Drive {
    pub(crate) fn empty() -> sys::dDrive {
        // Numbers and null pointers: zeros are a value of every field.
        #[allow(unused_mut)]
        let mut raw: sys::dDrive = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of::<sys::dDrive>() as u32;
        raw
    }
    pub(crate) fn from_raw(raw: &sys::dDrive, shared: &Shared) -> Self {
        Self {
            stiffness: raw.stiffness,
            damping: raw.damping,
            armature: raw.armature,
            friction: raw.friction,
            target: raw.target,
            target_velocity: raw.target_velocity,
            force: raw.force,
            force_limit: raw.force_limit,
        }
    }
    pub(crate) fn to_raw(&self) -> sys::dDrive {
        let mut raw = Self::empty();
        raw.stiffness = self.stiffness;
        raw.damping = self.damping;
        raw.armature = self.armature;
        raw.friction = self.friction;
        raw.target = self.target;
        raw.target_velocity = self.target_velocity;
        raw.force = self.force;
        raw.force_limit = self.force_limit;
        raw
    }
}
impl Default for Drive {
    fn default() -> Self {
        let mut raw = Self::empty();
        sure(|| unsafe { sys::dDriveInit(&mut raw, std::mem::size_of::<sys::dDrive>() as u32) });
        Self::from_raw(&raw, &Shared::none())
    }
}

/// Which events a world lists. Each field ends with its default.
///
/// C: dEventSettings.
#[derive(Clone, Debug, PartialEq)]
pub struct EventSettings {
    /// sum of 1 \<\< dEventKind. All but dEventContactPersist
    pub kinds: u32,
    /// events of a step that are kept, 1 ... 1048576. 1024
    pub capacity: i32,
    /// begin and persist events of contacts below it are left out, N s. 0
    pub min_impulse: Real,
    /// the same by their approach speed, m/s. 0
    pub min_approach_speed: Real,
}
#[allow(unused_variables)]
impl EventSettings {
    pub(crate) fn empty() -> sys::dEventSettings {
        // Numbers and null pointers: zeros are a value of every field.
        #[allow(unused_mut)]
        let mut raw: sys::dEventSettings = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of::<sys::dEventSettings>() as u32;
        raw
    }
    pub(crate) fn from_raw(raw: &sys::dEventSettings, shared: &Shared) -> Self {
        Self {
            kinds: raw.kinds,
            capacity: raw.capacity,
            min_impulse: raw.min_impulse,
            min_approach_speed: raw.min_approach_speed,
        }
    }
    pub(crate) fn to_raw(&self) -> sys::dEventSettings {
        let mut raw = Self::empty();
        raw.kinds = self.kinds;
        raw.capacity = self.capacity;
        raw.min_impulse = self.min_impulse;
        raw.min_approach_speed = self.min_approach_speed;
        raw
    }
}
impl Default for EventSettings {
    fn default() -> Self {
        let mut raw = Self::empty();
        sure(|| unsafe { sys::dEventSettingsInit(&mut raw, std::mem::size_of::<sys::dEventSettings>() as u32) });
        Self::from_raw(&raw, &Shared::none())
    }
}

/// What a character is and does. Each field ends with its default.
///
/// C: dCharacterSettings.
#[derive(Clone, Debug, PartialEq)]
pub struct CharacterSettings {
    /// dCapsuleClass, dCylinderClass or dBoxClass. dCapsuleClass
    pub shape: CharacterShape,
    /// m; of a box, half the side of its square base. 0.3
    pub radius: Real,
    /// m, from the feet to the top; of a capsule at least 2 radius. 1.8
    pub height: Real,
    /// of any length but 0. (0, 0, 1)
    pub up: Vec3,
    /// of dCharacterWalk, m/s^2, 0 or more. 9.81
    pub gravity: Real,
    /// the gap that it keeps, m, above 0 and at most radius / 4. 0.01
    pub skin: Real,
    /// the steepest ground that it can stand on, rad, 0 ... 1.5. 0.87 (50 degrees)
    pub slope_limit: Real,
    /// of steps that it climbs, m, 0 or more. 0.3
    pub step_height: Real,
    /// how far down it follows ground that falls away, m, 0 or more. 0.3
    pub stick_distance: Real,
    /// weighs with \`gravity\` on bodies that it stands on, kg; 0: nothing. 70
    pub mass: Real,
    /// that it pushes bodies with, N, 0 or more, not infinite. 500
    pub max_force: Real,
    /// of dCharacterWalk, how fast it turns in the air, m/s^2, 0 or more. 10
    pub air_acceleration: Real,
}
#[allow(unused_variables)]
impl CharacterSettings {
    pub(crate) fn empty() -> sys::dCharacterSettings {
        // Numbers and null pointers: zeros are a value of every field.
        #[allow(unused_mut)]
        let mut raw: sys::dCharacterSettings = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of::<sys::dCharacterSettings>() as u32;
        raw
    }
    pub(crate) fn from_raw(raw: &sys::dCharacterSettings, shared: &Shared) -> Self {
        Self {
            shape: CharacterShape::of_number(raw.shape as i32),
            radius: raw.radius,
            height: raw.height,
            up: vec3(raw.up),
            gravity: raw.gravity,
            skin: raw.skin,
            slope_limit: raw.slope_limit,
            step_height: raw.step_height,
            stick_distance: raw.stick_distance,
            mass: raw.mass,
            max_force: raw.max_force,
            air_acceleration: raw.air_acceleration,
        }
    }
    pub(crate) fn to_raw(&self) -> sys::dCharacterSettings {
        let mut raw = Self::empty();
        raw.shape = self.shape.number();
        raw.radius = self.radius;
        raw.height = self.height;
        raw.up = pad3(self.up);
        raw.gravity = self.gravity;
        raw.skin = self.skin;
        raw.slope_limit = self.slope_limit;
        raw.step_height = self.step_height;
        raw.stick_distance = self.stick_distance;
        raw.mass = self.mass;
        raw.max_force = self.max_force;
        raw.air_acceleration = self.air_acceleration;
        raw
    }
}
impl Default for CharacterSettings {
    fn default() -> Self {
        let mut raw = Self::empty();
        sure(|| unsafe { sys::dCharacterSettingsInit(&mut raw, std::mem::size_of::<sys::dCharacterSettings>() as u32) });
        Self::from_raw(&raw, &Shared::none())
    }
}

/// What the last move has done. Without ground, its fields are 0.
///
/// C: dCharacterReport.
#[derive(Clone, Debug, PartialEq)]
pub struct CharacterReport {
    /// a dCharacterState; 0: it has not moved yet
    pub state: Option<CharacterState>,
    /// how it has really moved, m/s, with what carries it
    pub velocity: Vec3,
    /// the geom that it stands on or slides on; 0: none, or it is destroyed
    pub ground: Option<GeomId>,
    /// its triangle if it is a mesh, else -1
    pub ground_side: i32,
    /// where
    pub ground_pos: Vec3,
    /// unit, of the surface: of a face, not of its edge
    pub ground_normal: Vec3,
    /// of the ground at that point, m/s
    pub ground_velocity: Vec3,
    /// angle by which the ground has turned it, about up, rad
    pub turn: Real,
    /// height of the steps that it has climbed, m
    pub climbed: Real,
    /// 1: something steep was in its way
    pub hit_wall: bool,
    /// 1: something above was
    pub hit_ceiling: bool,
    /// depth that it could not be freed from, m; 0: none.
    pub overlap: Real,
}
#[allow(unused_variables)]
impl CharacterReport {
    pub(crate) fn empty() -> sys::dCharacterReport {
        // Numbers and null pointers: zeros are a value of every field.
        #[allow(unused_mut)]
        let mut raw: sys::dCharacterReport = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of::<sys::dCharacterReport>() as u32;
        raw
    }
    pub(crate) fn from_raw(raw: &sys::dCharacterReport, shared: &Shared) -> Self {
        Self {
            state: (raw.state != 0).then(|| CharacterState::of_number(raw.state as i32)),
            velocity: vec3(raw.velocity),
            ground: shared.geom_of(raw.ground),
            ground_side: raw.ground_side,
            ground_pos: vec3(raw.ground_pos),
            ground_normal: vec3(raw.ground_normal),
            ground_velocity: vec3(raw.ground_velocity),
            turn: raw.turn,
            climbed: raw.climbed,
            hit_wall: raw.hit_wall != 0,
            hit_ceiling: raw.hit_ceiling != 0,
            overlap: raw.overlap,
        }
    }
}

/// What the last step of a world did. Sums and worst values over its islands. Lengths in m, angles in rad,
/// energies in J.
///
/// C: dWorldStepReport.
#[derive(Clone, Debug, PartialEq)]
pub struct StepReport {
    /// islands that were simulated
    pub islands: i32,
    /// bodies in them
    pub bodies: i32,
    /// joints in them that gave at least one row
    pub joints: i32,
    /// constraint rows, all islands together
    pub rows: i32,
    /// worst natural residual over the islands, relative; 0 = solved exactly
    pub residual: f64,
    /// solver iterations, or pivots of the exact solver, summed over islands
    pub iterations: i32,
    /// islands that needed a more careful method than the first one
    pub fallbacks: i32,
    /// islands kept from spreading bad numbers: velocities kept, forces zero
    pub contained_islands: i32,
    /// sparse factorisations, summed over islands
    pub factorisations: i32,
    /// worst distance that a joint should hold at zero, at the step's beginning
    pub joint_error: f64,
    /// the same for angles, rad
    pub joint_angle_error: f64,
    /// deepest contact beyond the surface layer, at the step's beginning
    pub penetration: f64,
    /// kinetic energy plus that of weight, at the step's beginning
    pub energy_before: f64,
    /// the same at its end, before the bodies' own damping
    pub energy_after: f64,
    /// Newton steps of dWorldSetStepProjection, summed over islands
    pub projection_iterations: i32,
    /// islands that they left above the tolerance
    pub projections_unconverged: i32,
    /// worst error that they left, in the unit of the tolerance
    pub projection_error: f64,
    /// bodies that continuous collision (dGeomSetContinuous) has stopped
    pub stopped_bodies: i32,
    /// what friction is off Coulomb's, relative; dWorldStep with a cone
    pub friction_error: f64,
    /// light links whose inertia the step has raised, since it is too long for their loads
    pub raised_bodies: i32,
    /// natural residual with the inertias as they are; \`residual\` if none is raised
    pub raised_residual: f64,
    /// the worst joint that contradicts others; it may be gone since. 0: none
    pub unsolved_joint: Option<JointId>,
    /// how many do; dWorldStep and exact hybrid islands
    pub unsolved_joints: i32,
}
#[allow(unused_variables)]
impl StepReport {
    pub(crate) fn empty() -> sys::dWorldStepReport {
        // Numbers and null pointers: zeros are a value of every field.
        #[allow(unused_mut)]
        let mut raw: sys::dWorldStepReport = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of::<sys::dWorldStepReport>() as u32;
        raw
    }
    pub(crate) fn from_raw(raw: &sys::dWorldStepReport, shared: &Shared) -> Self {
        Self {
            islands: raw.islands,
            bodies: raw.bodies,
            joints: raw.joints,
            rows: raw.rows,
            residual: raw.residual,
            iterations: raw.iterations,
            fallbacks: raw.fallbacks,
            contained_islands: raw.contained_islands,
            factorisations: raw.factorisations,
            joint_error: raw.joint_error,
            joint_angle_error: raw.joint_angle_error,
            penetration: raw.penetration,
            energy_before: raw.energy_before,
            energy_after: raw.energy_after,
            projection_iterations: raw.projection_iterations,
            projections_unconverged: raw.projections_unconverged,
            projection_error: raw.projection_error,
            stopped_bodies: raw.stopped_bodies,
            friction_error: raw.friction_error,
            raised_bodies: raw.raised_bodies,
            raised_residual: raw.raised_residual,
            unsolved_joint: shared.joint_of(raw.unsolved_joint),
            unsolved_joints: raw.unsolved_joints,
        }
    }
}

/// What the last step did with one island. Fields as in dWorldStepReport.
///
/// C: dIslandStepReport.
#[derive(Clone, Debug, PartialEq)]
pub struct IslandStepReport {
    /// one of dIslandMethod
    pub method: IslandMethod,
    /// a body of the island; it may have been destroyed since the step
    pub body: Option<BodyId>,
    /// its bodies
    pub bodies: i32,
    /// its joints that gave at least one row
    pub joints: i32,
    /// its constraint rows
    pub rows: i32,
    /// as in dWorldStepReport, as are those below without a text of their own
    pub iterations: i32,
    /// see dWorldStepReport
    pub factorisations: i32,
    /// 1: needed a more careful method than the first one
    pub fallback: bool,
    /// 1: kept from spreading bad numbers
    pub contained: bool,
    /// see dWorldStepReport
    pub residual: f64,
    /// see dWorldStepReport
    pub joint_error: f64,
    /// see dWorldStepReport
    pub joint_angle_error: f64,
    /// see dWorldStepReport
    pub penetration: f64,
    /// see dWorldStepReport
    pub energy_before: f64,
    /// see dWorldStepReport
    pub energy_after: f64,
    /// see dWorldStepReport
    pub projection_iterations: i32,
    /// 1: left above the tolerance
    pub projection_unconverged: bool,
    /// see dWorldStepReport
    pub projection_error: f64,
    /// see dWorldStepReport
    pub stopped_bodies: i32,
    /// see dWorldStepReport
    pub friction_error: f64,
    /// see dWorldStepReport
    pub raised_bodies: i32,
    /// see dWorldStepReport
    pub raised_residual: f64,
    /// see dWorldStepReport
    pub unsolved_joint: Option<JointId>,
    /// see dWorldStepReport
    pub unsolved_joints: i32,
}
#[allow(unused_variables)]
impl IslandStepReport {
    pub(crate) fn empty() -> sys::dIslandStepReport {
        // Numbers and null pointers: zeros are a value of every field.
        #[allow(unused_mut)]
        let mut raw: sys::dIslandStepReport = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of::<sys::dIslandStepReport>() as u32;
        raw
    }
    pub(crate) fn from_raw(raw: &sys::dIslandStepReport, shared: &Shared) -> Self {
        Self {
            method: IslandMethod::of_number(raw.method as i32),
            body: shared.body_of(raw.body),
            bodies: raw.bodies,
            joints: raw.joints,
            rows: raw.rows,
            iterations: raw.iterations,
            factorisations: raw.factorisations,
            fallback: raw.fallback != 0,
            contained: raw.contained != 0,
            residual: raw.residual,
            joint_error: raw.joint_error,
            joint_angle_error: raw.joint_angle_error,
            penetration: raw.penetration,
            energy_before: raw.energy_before,
            energy_after: raw.energy_after,
            projection_iterations: raw.projection_iterations,
            projection_unconverged: raw.projection_unconverged != 0,
            projection_error: raw.projection_error,
            stopped_bodies: raw.stopped_bodies,
            friction_error: raw.friction_error,
            raised_bodies: raw.raised_bodies,
            raised_residual: raw.raised_residual,
            unsolved_joint: shared.joint_of(raw.unsolved_joint),
            unsolved_joints: raw.unsolved_joints,
        }
    }
}

/// What the last step did to the energy of a world or an island, J. Bodies that sleep and kinematic ones have
/// none. Shares are above 0 where they add kinetic energy.
///
/// C: dEnergyLedger.
#[derive(Clone, Debug, PartialEq)]
pub struct EnergyLedger {
    /// islands of the last step; 1 in that of an island
    pub islands: i32,
    /// a body of the island; it may have been destroyed since the step. World: 0
    pub body: Option<BodyId>,
    /// kinetic energy at the step's beginning
    pub kinetic_before: f64,
    /// at its end, after damping
    pub kinetic_after: f64,
    /// -sum m g.x over the bodies that gravity acts on, at the step's beginning
    pub potential_before: f64,
    /// the same at its end
    pub potential_after: f64,
    /// work of gravity along the path
    pub gravity: f64,
    /// work of the program's forces and torques
    pub forces: f64,
    /// of drives, motors, springs, all that is soft, moving surfaces and kinematic bodies
    pub drives: f64,
    /// of friction in contacts and axes: never above 0
    pub friction: f64,
    /// of normal forces of contacts and stops, also against friction: what restitution
    /// leaves of an impact
    pub impacts: f64,
    /// of rigid joints: 0 but for errors of first order in the step, and for what a
    /// joint takes when it seizes bodies in relative motion
    pub joints: f64,
    /// of dBodySetLinearDamping and its like
    pub damping: f64,
    /// of the correction of positions: penetrations and joint errors
    pub correction: f64,
    /// what none of these explains: the error of the integration, of first order in
    /// the step, and rounding
    pub integration: f64,
}
#[allow(unused_variables)]
impl EnergyLedger {
    pub(crate) fn empty() -> sys::dEnergyLedger {
        // Numbers and null pointers: zeros are a value of every field.
        #[allow(unused_mut)]
        let mut raw: sys::dEnergyLedger = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of::<sys::dEnergyLedger>() as u32;
        raw
    }
    pub(crate) fn from_raw(raw: &sys::dEnergyLedger, shared: &Shared) -> Self {
        Self {
            islands: raw.islands,
            body: shared.body_of(raw.body),
            kinetic_before: raw.kinetic_before,
            kinetic_after: raw.kinetic_after,
            potential_before: raw.potential_before,
            potential_after: raw.potential_after,
            gravity: raw.gravity,
            forces: raw.forces,
            drives: raw.drives,
            friction: raw.friction,
            impacts: raw.impacts,
            joints: raw.joints,
            damping: raw.damping,
            correction: raw.correction,
            integration: raw.integration,
        }
    }
}

/// What a joint did in the last step: force (N) and torque about the body's centre (N m), world
/// frame, on the first (f1, t1) and second (f2, t2) body. See dJointSetFeedback.
///
/// C: dJointFeedback.
#[derive(Clone, Debug, PartialEq)]
pub struct Feedback {
    /// force on body 1
    pub f1: Vec3,
    /// torque on body 1
    pub t1: Vec3,
    /// force on body 2
    pub f2: Vec3,
    /// torque on body 2
    pub t2: Vec3,
}
#[allow(unused_variables)]
impl Feedback {
    pub(crate) fn empty() -> sys::dJointFeedback {
        // Numbers and null pointers: zeros are a value of every field.
        #[allow(unused_mut)]
        let mut raw: sys::dJointFeedback = unsafe { std::mem::zeroed() };
        raw
    }
    pub(crate) fn from_raw(raw: &sys::dJointFeedback, shared: &Shared) -> Self {
        Self {
            f1: vec3(raw.f1),
            t1: vec3(raw.t1),
            f2: vec3(raw.f2),
            t2: vec3(raw.t2),
        }
    }
}
