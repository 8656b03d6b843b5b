// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by rust/tools/generate.py from the public headers.
#![allow(clippy::useless_conversion, clippy::unnecessary_cast, clippy::doc_lazy_continuation, clippy::doc_overindented_list_items)]
use crate::prelude::*;

impl Body<'_> {
    /// What dBodySetHybridStepper has set, dStepperHybrid at first.
    ///
    /// C: `dBodyGetHybridStepper`.
    pub fn hybrid_stepper(&self) -> Stepper {
        let r = sure(|| unsafe { sys::dBodyGetHybridStepper(self.raw()) });
        let r = r as i32;
        Stepper::of_number(r)
    }

    /// Returns 1 if the body is a \`vehicle\`, else 0.
    ///
    /// C: `dBodyIsVehicle`.
    pub fn is_vehicle(&self) -> bool {
        let r = sure(|| unsafe { sys::dBodyIsVehicle(self.raw()) });
        r != 0
    }

    /// The body's position, 3 reals, m.
    ///
    /// C: `dBodyGetPosition`.
    pub fn position(&self) -> Vec3 {
        let r = sure(|| unsafe { sys::dBodyGetPosition(self.raw()) });
        read_vec3(r)
    }

    /// The body's rotation matrix, from body to world, 12 reals.
    ///
    /// C: `dBodyGetRotation`.
    pub fn rotation(&self) -> Mat3 {
        let r = sure(|| unsafe { sys::dBodyGetRotation(self.raw()) });
        read_mat3(r)
    }

    /// The body's orientation as a quaternion, from body to world, 4 reals.
    ///
    /// C: `dBodyGetQuaternion`.
    pub fn quaternion(&self) -> Quat {
        let r = sure(|| unsafe { sys::dBodyGetQuaternion(self.raw()) });
        read_quat(r)
    }

    /// The velocity of the body's centre of mass, 3 reals, m/s.
    ///
    /// C: `dBodyGetLinearVel`.
    pub fn linear_vel(&self) -> Vec3 {
        let r = sure(|| unsafe { sys::dBodyGetLinearVel(self.raw()) });
        read_vec3(r)
    }

    /// The body's angular velocity, 3 reals, rad/s.
    ///
    /// C: `dBodyGetAngularVel`.
    pub fn angular_vel(&self) -> Vec3 {
        let r = sure(|| unsafe { sys::dBodyGetAngularVel(self.raw()) });
        read_vec3(r)
    }

    /// The sum of the forces that have been added for the next step: 3 reals, N,
    /// world frame.
    ///
    /// A step clears the sums of all bodies. With dBehaviour016 a disabled body keeps its sum until it moves again.
    ///
    /// C: `dBodyGetForce`.
    pub fn force(&self) -> Vec3 {
        let r = sure(|| unsafe { sys::dBodyGetForce(self.raw()) });
        read_vec3(r)
    }

    /// The sum of the torques that have been added for the next step: 3 reals, N
    /// m, world frame.
    ///
    /// A step clears the sums of all bodies. With dBehaviour016 a disabled body keeps its sum until it moves again.
    ///
    /// C: `dBodyGetTorque`.
    pub fn torque(&self) -> Vec3 {
        let r = sure(|| unsafe { sys::dBodyGetTorque(self.raw()) });
        read_vec3(r)
    }

    /// The position in the world, m, of the point (px, py, pz) of the body's frame.
    ///
    /// C: `dBodyGetRelPointPos`; `point` is (px, py, pz).
    pub fn rel_point_pos(&self, point: Vec3) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dBodyGetRelPointPos(self.raw(), point[0], point[1], point[2], result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The velocity in the world, m/s, of the point (px, py, pz) of the body's frame.
    ///
    /// C: `dBodyGetRelPointVel`; `point` is (px, py, pz).
    pub fn rel_point_vel(&self, point: Vec3) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dBodyGetRelPointVel(self.raw(), point[0], point[1], point[2], result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Velocity of the body's material at the world point (px, py, pz), m/s, world frame.
    ///
    /// C: `dBodyGetPointVel`; `point` is (px, py, pz).
    pub fn point_vel(&self, point: Vec3) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dBodyGetPointVel(self.raw(), point[0], point[1], point[2], result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Body coordinates of the world point (px, py, pz).
    ///
    /// C: `dBodyGetPosRelPoint`; `point` is (px, py, pz).
    pub fn pos_rel_point(&self, point: Vec3) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dBodyGetPosRelPoint(self.raw(), point[0], point[1], point[2], result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The direction (px, py, pz) of the body's frame, turned to the world's axes.
    ///
    /// C: `dBodyVectorToWorld`; `point` is (px, py, pz).
    pub fn vector_to_world(&self, point: Vec3) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dBodyVectorToWorld(self.raw(), point[0], point[1], point[2], result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The direction (px, py, pz) of the world, turned to the body's axes.
    ///
    /// C: `dBodyVectorFromWorld`; `point` is (px, py, pz).
    pub fn vector_from_world(&self, point: Vec3) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dBodyVectorFromWorld(self.raw(), point[0], point[1], point[2], result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Non-zero if the body's orientation is advanced by exact rotations, else 0,
    /// the default.
    ///
    /// C: `dBodyGetFiniteRotationMode`.
    pub fn finite_rotation_mode(&self) -> bool {
        let r = sure(|| unsafe { sys::dBodyGetFiniteRotationMode(self.raw()) });
        r != 0
    }

    /// Write the axis of fast spin, a unit vector in the world's frame, to result;
    /// zeros: none.
    ///
    /// C: `dBodyGetFiniteRotationAxis`.
    pub fn finite_rotation_axis(&self) -> Vec3 {
        let mut result: [Real; 4] = [0.0; 4];
        sure(|| unsafe { sys::dBodyGetFiniteRotationAxis(self.raw(), result.as_mut_ptr()) });
        vec3(result)
    }

    /// How many joints are attached to the body.
    ///
    /// C: `dBodyGetNumJoints`.
    pub fn num_joints(&self) -> i32 {
        sure(|| unsafe { sys::dBodyGetNumJoints(self.raw()) })
    }

    /// 1 if the body is kinematic, else 0.
    ///
    /// A kinematic body moves by its velocity alone: forces, gravity and joints do not act on it, while it acts
    /// on others as if infinitely heavy.
    ///
    /// C: `dBodyIsKinematic`.
    pub fn is_kinematic(&self) -> bool {
        let r = sure(|| unsafe { sys::dBodyIsKinematic(self.raw()) });
        r != 0
    }

    /// 1 if the body is enabled, 0 if it is disabled.
    ///
    /// A disabled body is not stepped until it is enabled or an enabled body reaches it through a joint; it
    /// keeps its velocity.
    ///
    /// C: `dBodyIsEnabled`.
    pub fn is_enabled(&self) -> bool {
        let r = sure(|| unsafe { sys::dBodyIsEnabled(self.raw()) });
        r != 0
    }

    /// Non-zero if the world's gravity acts on the body, else 0.
    ///
    /// C: `dBodyGetGravityMode`.
    pub fn gravity_mode(&self) -> bool {
        let r = sure(|| unsafe { sys::dBodyGetGravityMode(self.raw()) });
        r != 0
    }

    /// Non-zero if the gyroscopic torque is applied to the body, else 0.
    ///
    /// C: `dBodyGetGyroscopicMode`.
    pub fn gyroscopic_mode(&self) -> bool {
        let r = sure(|| unsafe { sys::dBodyGetGyroscopicMode(self.raw()) });
        r != 0
    }

    /// The averaged linear speed up to which the body counts as idle, m/s.
    ///
    /// C: `dBodyGetAutoDisableLinearThreshold`.
    pub fn auto_disable_linear_threshold(&self) -> Real {
        sure(|| unsafe { sys::dBodyGetAutoDisableLinearThreshold(self.raw()) })
    }

    /// The averaged angular speed up to which the body counts as idle,
    /// rad/s.
    ///
    /// C: `dBodyGetAutoDisableAngularThreshold`.
    pub fn auto_disable_angular_threshold(&self) -> Real {
        sure(|| unsafe { sys::dBodyGetAutoDisableAngularThreshold(self.raw()) })
    }

    /// Over how many steps the body's velocities are averaged.
    ///
    /// C: `dBodyGetAutoDisableAverageSamplesCount`.
    pub fn auto_disable_average_samples_count(&self) -> i32 {
        sure(|| unsafe { sys::dBodyGetAutoDisableAverageSamplesCount(self.raw()) })
    }

    /// How many idle steps the body needs before it is disabled.
    ///
    /// C: `dBodyGetAutoDisableSteps`.
    pub fn auto_disable_steps(&self) -> i32 {
        sure(|| unsafe { sys::dBodyGetAutoDisableSteps(self.raw()) })
    }

    /// How much idle time the body needs before it is disabled, s.
    ///
    /// C: `dBodyGetAutoDisableTime`.
    pub fn auto_disable_time(&self) -> Real {
        sure(|| unsafe { sys::dBodyGetAutoDisableTime(self.raw()) })
    }

    /// Non-zero if the body disables itself, else 0.
    ///
    /// C: `dBodyGetAutoDisableFlag`.
    pub fn auto_disable_flag(&self) -> bool {
        let r = sure(|| unsafe { sys::dBodyGetAutoDisableFlag(self.raw()) });
        r != 0
    }

    /// The scale of the body's linear damping.
    ///
    /// C: `dBodyGetLinearDamping`.
    pub fn linear_damping(&self) -> Real {
        sure(|| unsafe { sys::dBodyGetLinearDamping(self.raw()) })
    }

    /// The scale of the body's angular damping.
    ///
    /// C: `dBodyGetAngularDamping`.
    pub fn angular_damping(&self) -> Real {
        sure(|| unsafe { sys::dBodyGetAngularDamping(self.raw()) })
    }

    /// The linear speed from which on damping acts on the body, m/s.
    ///
    /// C: `dBodyGetLinearDampingThreshold`.
    pub fn linear_damping_threshold(&self) -> Real {
        sure(|| unsafe { sys::dBodyGetLinearDampingThreshold(self.raw()) })
    }

    /// The angular speed from which on damping acts on the body, rad/s.
    ///
    /// C: `dBodyGetAngularDampingThreshold`.
    pub fn angular_damping_threshold(&self) -> Real {
        sure(|| unsafe { sys::dBodyGetAngularDampingThreshold(self.raw()) })
    }

    /// The angular speed that the body is held to, rad/s.
    ///
    /// C: `dBodyGetMaxAngularSpeed`.
    pub fn max_angular_speed(&self) -> Real {
        sure(|| unsafe { sys::dBodyGetMaxAngularSpeed(self.raw()) })
    }
}

impl BodyMut<'_> {
    /// Give the body the impulse at pos, which may be 0: impulse / mass in velocity, and its
    /// moment about the centre.
    ///
    /// Change the velocities at once: by an impulse (N s), or by its moment alone (N m s).
    ///
    /// C: `dBodyApplyImpulse`.
    pub fn apply_impulse(&mut self, impulse: Vec3, pos: Vec3) -> Result<()> {
        let impulse = pad3(impulse);
        let pos = pad3(pos);
        call(|| unsafe { sys::dBodyApplyImpulse(self.raw(), impulse.as_ptr(), pos.as_ptr()) })
    }

    /// Give the body the moment.
    ///
    /// Change the velocities at once: by an impulse (N s), or by its moment alone (N m s).
    ///
    /// C: `dBodyApplyAngularImpulse`.
    pub fn apply_angular_impulse(&mut self, impulse: Vec3) -> Result<()> {
        let impulse = pad3(impulse);
        call(|| unsafe { sys::dBodyApplyAngularImpulse(self.raw(), impulse.as_ptr()) })
    }

    /// Add the force (N) at pos, which may be 0.
    ///
    /// Act in the next step, as dBodyAddForceAtPos and dBodyAddTorque do, on a body that is awake from now on.
    ///
    /// C: `dBodyApplyForce`.
    pub fn apply_force(&mut self, force: Vec3, pos: Vec3) -> Result<()> {
        let force = pad3(force);
        let pos = pad3(pos);
        call(|| unsafe { sys::dBodyApplyForce(self.raw(), force.as_ptr(), pos.as_ptr()) })
    }

    /// Add the torque (N m).
    ///
    /// Act in the next step, as dBodyAddForceAtPos and dBodyAddTorque do, on a body that is awake from now on.
    ///
    /// C: `dBodyApplyTorque`.
    pub fn apply_torque(&mut self, torque: Vec3) -> Result<()> {
        let torque = pad3(torque);
        call(|| unsafe { sys::dBodyApplyTorque(self.raw(), torque.as_ptr()) })
    }

    /// Set the velocities, linear in m/s and angular in rad/s. Either may be 0: it stays. wake: 1 wakes the body;
    /// 0 does not, as dBodySetLinearVel and dBodySetAngularVel. Refused: another wake.
    ///
    /// C: `dBodySetVelocities`.
    pub fn set_velocities(&mut self, linear: Vec3, angular: Vec3, wake: i32) -> Result<()> {
        let linear = pad3(linear);
        let angular = pad3(angular);
        call(|| unsafe { sys::dBodySetVelocities(self.raw(), linear.as_ptr(), angular.as_ptr(), wake) })
    }

    /// Request a stepper for the body's island in hybrid steps; dStepperHybrid, the
    /// default: none. An island takes the most exact of those that its bodies request. Other numbers are
    /// refused.
    ///
    /// C: `dBodySetHybridStepper`.
    pub fn set_hybrid_stepper(&mut self, stepper: Stepper) -> Result<()> {
        call(|| unsafe { sys::dBodySetHybridStepper(self.raw(), stepper.number()) })
    }

    /// Position of the body's origin, which is its centre of mass, m.
    ///
    /// C: `dBodySetPosition`; `xyz` is (x, y, z).
    pub fn set_position(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodySetPosition(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the body's orientation, from body to world, by the rotation matrix R (12 reals,
    /// made orthonormal here). A degenerate matrix is refused.
    ///
    /// C: `dBodySetRotation`.
    pub fn set_rotation(&mut self, r: Mat3) -> Result<()> {
        let r = pad33(r);
        call(|| unsafe { sys::dBodySetRotation(self.raw(), r.as_ptr()) })
    }

    /// Set the body's orientation, from body to world, by the quaternion q (4 reals,
    /// normalised here). A zero quaternion is refused.
    ///
    /// C: `dBodySetQuaternion`.
    pub fn set_quaternion(&mut self, q: Quat) -> Result<()> {
        let q = same(q);
        call(|| unsafe { sys::dBodySetQuaternion(self.raw(), q.as_ptr()) })
    }

    /// Set the velocity of the body's centre of mass to (x, y, z), m/s.
    ///
    /// C: `dBodySetLinearVel`; `xyz` is (x, y, z).
    pub fn set_linear_vel(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodySetLinearVel(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the body's angular velocity to (x, y, z), rad/s.
    ///
    /// C: `dBodySetAngularVel`; `xyz` is (x, y, z).
    pub fn set_angular_vel(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodySetAngularVel(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Add the force (fx, fy, fz), N, world frame, at the body's centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    ///
    /// C: `dBodyAddForce`; `force` is (fx, fy, fz).
    pub fn add_force(&mut self, force: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodyAddForce(self.raw(), force[0], force[1], force[2]) })
    }

    /// Add the torque (fx, fy, fz), N m, world frame.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    ///
    /// C: `dBodyAddTorque`; `force` is (fx, fy, fz).
    pub fn add_torque(&mut self, force: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodyAddTorque(self.raw(), force[0], force[1], force[2]) })
    }

    /// Add the force (fx, fy, fz), N, in the body's axes, at the body's centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    ///
    /// C: `dBodyAddRelForce`; `force` is (fx, fy, fz).
    pub fn add_rel_force(&mut self, force: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodyAddRelForce(self.raw(), force[0], force[1], force[2]) })
    }

    /// Add the torque (fx, fy, fz), N m, in the body's axes.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    ///
    /// C: `dBodyAddRelTorque`; `force` is (fx, fy, fz).
    pub fn add_rel_torque(&mut self, force: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodyAddRelTorque(self.raw(), force[0], force[1], force[2]) })
    }

    /// Add the force (fx, fy, fz), N, world frame, at the world's point (px, py, pz), with
    /// its torque about the centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    ///
    /// C: `dBodyAddForceAtPos`; `force` is (fx, fy, fz); `point` is (px, py, pz).
    pub fn add_force_at_pos(&mut self, force: Vec3, point: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodyAddForceAtPos(self.raw(), force[0], force[1], force[2], point[0], point[1], point[2]) })
    }

    /// Add the force (fx, fy, fz), N, world frame, at the point (px, py, pz) of the
    /// body's frame, with its torque about the centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    ///
    /// C: `dBodyAddForceAtRelPos`; `force` is (fx, fy, fz); `point` is (px, py, pz).
    pub fn add_force_at_rel_pos(&mut self, force: Vec3, point: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodyAddForceAtRelPos(self.raw(), force[0], force[1], force[2], point[0], point[1], point[2]) })
    }

    /// Add the force (fx, fy, fz), N, in the body's axes, at the world's point (px, py,
    /// pz), with its torque about the centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    ///
    /// C: `dBodyAddRelForceAtPos`; `force` is (fx, fy, fz); `point` is (px, py, pz).
    pub fn add_rel_force_at_pos(&mut self, force: Vec3, point: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodyAddRelForceAtPos(self.raw(), force[0], force[1], force[2], point[0], point[1], point[2]) })
    }

    /// Add the force (fx, fy, fz), N, in the body's axes, at the point (px, py, pz)
    /// of the body's frame, with its torque about the centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    ///
    /// C: `dBodyAddRelForceAtRelPos`; `force` is (fx, fy, fz); `point` is (px, py, pz).
    pub fn add_rel_force_at_rel_pos(&mut self, force: Vec3, point: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodyAddRelForceAtRelPos(self.raw(), force[0], force[1], force[2], point[0], point[1], point[2]) })
    }

    /// Set the sum of the forces for the next step to (x, y, z), N, world frame.
    ///
    /// A step clears the sums of all bodies. With dBehaviour016 a disabled body keeps its sum until it moves again.
    ///
    /// C: `dBodySetForce`; `xyz` is (x, y, z).
    pub fn set_force(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodySetForce(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the sum of the torques for the next step to (x, y, z), N m, world frame.
    ///
    /// A step clears the sums of all bodies. With dBehaviour016 a disabled body keeps its sum until it moves again.
    ///
    /// C: `dBodySetTorque`; `xyz` is (x, y, z).
    pub fn set_torque(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodySetTorque(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set how the body's orientation is advanced (mode). 0 (default): q += h/2
    /// (0, w) q, normalised; cheap, inexact at high spin. Non-zero: the exact rotation by \|w\| h; with a finite
    /// rotation axis only the part of w about that axis is treated exactly.
    ///
    /// C: `dBodySetFiniteRotationMode`.
    pub fn set_finite_rotation_mode(&mut self, mode: bool) -> Result<()> {
        call(|| unsafe { sys::dBodySetFiniteRotationMode(self.raw(), i32::from(mode)) })
    }

    /// Set the axis of fast spin to (x, y, z), world frame, normalised here; (0,
    /// 0, 0), the default, means none.
    ///
    /// C: `dBodySetFiniteRotationAxis`; `xyz` is (x, y, z).
    pub fn set_finite_rotation_axis(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dBodySetFiniteRotationAxis(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Make the body dynamic, which is the default, with the mass that it had.
    ///
    /// A kinematic body moves by its velocity alone: forces, gravity and joints do not act on it, while it acts
    /// on others as if infinitely heavy.
    ///
    /// C: `dBodySetDynamic`.
    pub fn set_dynamic(&mut self) -> Result<()> {
        call(|| unsafe { sys::dBodySetDynamic(self.raw()) })
    }

    /// Make the body kinematic; it keeps its mass in store.
    ///
    /// A kinematic body moves by its velocity alone: forces, gravity and joints do not act on it, while it acts
    /// on others as if infinitely heavy.
    ///
    /// C: `dBodySetKinematic`.
    pub fn set_kinematic(&mut self) -> Result<()> {
        call(|| unsafe { sys::dBodySetKinematic(self.raw()) })
    }

    /// Wake the body and restart its idle counters. New bodies are enabled.
    ///
    /// A disabled body is not stepped until it is enabled or an enabled body reaches it through a joint; it
    /// keeps its velocity.
    ///
    /// C: `dBodyEnable`.
    pub fn enable(&mut self) -> Result<()> {
        call(|| unsafe { sys::dBodyEnable(self.raw()) })
    }

    /// Put the body to sleep.
    ///
    /// A disabled body is not stepped until it is enabled or an enabled body reaches it through a joint; it
    /// keeps its velocity.
    ///
    /// C: `dBodyDisable`.
    pub fn disable(&mut self) -> Result<()> {
        call(|| unsafe { sys::dBodyDisable(self.raw()) })
    }

    /// Set whether the world's gravity acts on the body (mode not 0); default 1.
    ///
    /// C: `dBodySetGravityMode`.
    pub fn set_gravity_mode(&mut self, mode: bool) -> Result<()> {
        call(|| unsafe { sys::dBodySetGravityMode(self.raw(), i32::from(mode)) })
    }

    /// Set whether the gyroscopic torque -w x I w is applied to the body (enabled not
    /// 0), by an implicit formula that is stable at any spin; default on.
    ///
    /// C: `dBodySetGyroscopicMode`.
    pub fn set_gyroscopic_mode(&mut self, enabled: bool) -> Result<()> {
        call(|| unsafe { sys::dBodySetGyroscopicMode(self.raw(), i32::from(enabled)) })
    }

    /// Set the averaged linear speed linear\_average\_threshold, m/s, up to
    /// which the body counts as idle.
    ///
    /// C: `dBodySetAutoDisableLinearThreshold`.
    pub fn set_auto_disable_linear_threshold(&mut self, linear_average_threshold: Real) -> Result<()> {
        call(|| unsafe { sys::dBodySetAutoDisableLinearThreshold(self.raw(), linear_average_threshold) })
    }

    /// Set the averaged angular speed angular\_average\_threshold, rad/s,
    /// up to which the body counts as idle.
    ///
    /// C: `dBodySetAutoDisableAngularThreshold`.
    pub fn set_auto_disable_angular_threshold(&mut self, angular_average_threshold: Real) -> Result<()> {
        call(|| unsafe { sys::dBodySetAutoDisableAngularThreshold(self.raw(), angular_average_threshold) })
    }

    /// Set over how many steps (average\_samples\_count) the body's
    /// velocities are averaged; more than 2^20 are refused. Changing the count throws the samples gathered so
    /// far away.
    ///
    /// C: `dBodySetAutoDisableAverageSamplesCount`.
    pub fn set_auto_disable_average_samples_count(&mut self, average_samples_count: u32) -> Result<()> {
        call(|| unsafe { sys::dBodySetAutoDisableAverageSamplesCount(self.raw(), average_samples_count) })
    }

    /// Set how many idle steps the body needs before it is disabled. The new value
    /// counts from the next restart of the idle counters.
    ///
    /// C: `dBodySetAutoDisableSteps`.
    pub fn set_auto_disable_steps(&mut self, steps: i32) -> Result<()> {
        call(|| unsafe { sys::dBodySetAutoDisableSteps(self.raw(), steps) })
    }

    /// Set how much idle time, s, the body needs before it is disabled. The new value
    /// counts from the next restart of the idle counters.
    ///
    /// C: `dBodySetAutoDisableTime`.
    pub fn set_auto_disable_time(&mut self, time: Real) -> Result<()> {
        call(|| unsafe { sys::dBodySetAutoDisableTime(self.raw(), time) })
    }

    /// Switch automatic disabling of the body on (do\_auto\_disable not 0) or off. Off
    /// also enables the body and takes steps, time and sample count over from the world.
    ///
    /// C: `dBodySetAutoDisableFlag`.
    pub fn set_auto_disable_flag(&mut self, do_auto_disable: bool) -> Result<()> {
        call(|| unsafe { sys::dBodySetAutoDisableFlag(self.raw(), i32::from(do_auto_disable)) })
    }

    /// Take all auto-disable settings over from the world.
    ///
    /// C: `dBodySetAutoDisableDefaults`.
    pub fn set_auto_disable_defaults(&mut self) -> Result<()> {
        call(|| unsafe { sys::dBodySetAutoDisableDefaults(self.raw()) })
    }

    /// Take all damping settings over from the world.
    ///
    /// C: `dBodySetDampingDefaults`.
    pub fn set_damping_defaults(&mut self) -> Result<()> {
        call(|| unsafe { sys::dBodySetDampingDefaults(self.raw()) })
    }

    /// Set the scale of the body's linear damping, sensibly 0 ... 1; 0: no damping.
    ///
    /// C: `dBodySetLinearDamping`.
    pub fn set_linear_damping(&mut self, scale: Real) -> Result<()> {
        call(|| unsafe { sys::dBodySetLinearDamping(self.raw(), scale) })
    }

    /// Set the scale of the body's angular damping, sensibly 0 ... 1; 0: no damping.
    ///
    /// C: `dBodySetAngularDamping`.
    pub fn set_angular_damping(&mut self, scale: Real) -> Result<()> {
        call(|| unsafe { sys::dBodySetAngularDamping(self.raw(), scale) })
    }

    /// Set the scales of the body's linear (linear\_scale) and angular damping
    /// (angular\_scale), each sensibly 0 ... 1; 0: no damping.
    ///
    /// C: `dBodySetDamping`.
    pub fn set_damping(&mut self, linear_scale: Real, angular_scale: Real) -> Result<()> {
        call(|| unsafe { sys::dBodySetDamping(self.raw(), linear_scale, angular_scale) })
    }

    /// Set the linear speed threshold, m/s, from which on damping acts on the
    /// body.
    ///
    /// C: `dBodySetLinearDampingThreshold`.
    pub fn set_linear_damping_threshold(&mut self, threshold: Real) -> Result<()> {
        call(|| unsafe { sys::dBodySetLinearDampingThreshold(self.raw(), threshold) })
    }

    /// Set the angular speed threshold, rad/s, from which on damping acts on
    /// the body.
    ///
    /// C: `dBodySetAngularDampingThreshold`.
    pub fn set_angular_damping_threshold(&mut self, threshold: Real) -> Result<()> {
        call(|| unsafe { sys::dBodySetAngularDampingThreshold(self.raw(), threshold) })
    }

    /// Set the angular speed max\_speed, rad/s, that the body is held to.
    ///
    /// C: `dBodySetMaxAngularSpeed`.
    pub fn set_max_angular_speed(&mut self, max_speed: Real) -> Result<()> {
        call(|| unsafe { sys::dBodySetMaxAngularSpeed(self.raw(), max_speed) })
    }
}
