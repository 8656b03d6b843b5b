// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by rust/tools/generate.py from the public headers.
#![allow(clippy::useless_conversion, clippy::unnecessary_cast, clippy::doc_lazy_continuation, clippy::doc_overindented_list_items)]
use crate::prelude::*;

impl Joint<'_> {
    /// Returns the number of its axis, 0 if the place is empty.
    ///
    /// C: `dJointGetCouplingAxis`.
    pub fn coupling_axis(&self, i: i32) -> Result<i32> {
        call(|| unsafe { sys::dJointGetCouplingAxis(self.raw(), i) })
    }

    /// Returns its factor, 0 if the place is empty.
    ///
    /// C: `dJointGetCouplingFactor`.
    pub fn coupling_factor(&self, i: i32) -> Result<Real> {
        call(|| unsafe { sys::dJointGetCouplingFactor(self.raw(), i) })
    }

    /// Returns a parameter, 0 if the coupling does not have it.
    ///
    /// C: `dJointGetCouplingParam`.
    pub fn coupling_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetCouplingParam(self.raw(), parameter.number()) })
    }

    /// Returns the force along s that stops, springs and drives of the coupling have exerted, N or N m, the mean
    /// over the last step in which it acted; positive lets s grow. Axis i received its factor times this.
    ///
    /// C: `dJointGetCouplingForce`.
    pub fn coupling_force(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetCouplingForce(self.raw()) })
    }

    /// Returns how many axes the joint has: 0 ... 3, by its type; an AMotor and an LMotor have those that the
    /// program has given them.
    ///
    /// C: `dJointGetNumAxes`.
    pub fn num_axes(&self) -> i32 {
        sure(|| unsafe { sys::dJointGetNumAxes(self.raw()) })
    }

    /// Returns the joint's position along or about one of its axes, m or rad. Angles are
    /// in -pi ... pi, or count turns: with stops, and after dJointSetAxisContinuous. A joint without bodies
    /// answers 0.
    ///
    /// C: `dJointGetAxisPosition`.
    pub fn axis_position(&self, axis: i32) -> Result<Real> {
        call(|| unsafe { sys::dJointGetAxisPosition(self.raw(), axis) })
    }

    /// Returns the derivative of dJointGetAxisPosition, m/s or rad/s. Unlike some of the
    /// types' own functions it is exact also where the bodies turn together.
    ///
    /// C: `dJointGetAxisRate`.
    pub fn axis_rate(&self, axis: i32) -> Result<Real> {
        call(|| unsafe { sys::dJointGetAxisRate(self.raw(), axis) })
    }

    /// Returns the mode that dJointSetAxisContinuous has set, 0 at first.
    ///
    /// C: `dJointGetAxisContinuous`.
    pub fn axis_continuous(&self, axis: i32) -> Result<bool> {
        let r = call(|| unsafe { sys::dJointGetAxisContinuous(self.raw(), axis) })?;
        Ok(r != 0)
    }

    /// Write to \*drive, whose size the caller has set, what dJointSetDrive has set, or zeros.
    /// Returns 1 if the axis has a drive, else 0.
    ///
    /// C: `dJointGetDrive`.
    pub fn drive(&self, axis: i32) -> Result<Drive> {
        let mut drive = Drive::empty();
        call(|| unsafe { sys::dJointGetDrive(self.raw(), axis, &mut drive) })?;
        Ok(Drive::from_raw(&drive, self.shared()))
    }

    /// Returns what spring, damper and feed-forward of an axis have exerted, N or N m, the
    /// mean over the last step; armature and friction are not in it. 0 where there are none.
    ///
    /// C: `dJointGetDriveForce`.
    pub fn drive_force(&self, axis: i32) -> Result<Real> {
        call(|| unsafe { sys::dJointGetDriveForce(self.raw(), axis) })
    }

    /// Write to \*stiffness and \*damping what dJointSetStopSpring has set, zeros at first.
    /// Returns 1 if the axis's stops are springs, else 0.
    ///
    /// C: `dJointGetStopSpring`.
    pub fn stop_spring(&self, axis: i32) -> Result<(Real, Real)> {
        let mut stiffness: Real = Default::default();
        let mut damping: Real = Default::default();
        call(|| unsafe { sys::dJointGetStopSpring(self.raw(), axis, &mut stiffness, &mut damping) })?;
        Ok((stiffness, damping))
    }

    /// Returns what dJointSetStopRate has set. Refused: an axis without stops.
    ///
    /// A joint that is made far beyond a stop is pushed back at dParamStopERP / h times the distance: the faster, the
    /// smaller the step is, and it keeps that speed. A \`rate\` bounds it in steps that correct by velocities. It does not
    /// count where poses are corrected instead (dWorldSetStepProjection, dWorldSetContactMaxCorrectingVel).
    ///
    /// C: `dJointGetStopRate`.
    pub fn stop_rate(&self, axis: i32) -> Result<Real> {
        call(|| unsafe { sys::dJointGetStopRate(self.raw(), axis) })
    }

    /// Returns what the stops of an axis have exerted along it, N or N m, the mean over the last step in which the joint acted:
    /// above 0 where its position is to grow. 0 of an axis within its stops, and after a state was set. Refused: an axis without stops.
    ///
    /// C: `dJointGetStopForce`.
    pub fn stop_force(&self, axis: i32) -> Result<Real> {
        call(|| unsafe { sys::dJointGetStopForce(self.raw(), axis) })
    }

    /// Write to \*stiffness and \*damping what dJointSetSpring has set, zeros at first. Returns
    /// 1 if there is such a spring, else 0.
    ///
    /// C: `dJointGetSpring`.
    pub fn spring(&self) -> Result<(Real, Real)> {
        let mut stiffness: Real = Default::default();
        let mut damping: Real = Default::default();
        call(|| unsafe { sys::dJointGetSpring(self.raw(), &mut stiffness, &mut damping) })?;
        Ok((stiffness, damping))
    }

    /// Write to \*force and \*torque what dJointSetBreakLimits has set, dInfinity for none.
    /// Returns 1 if the joint has a limit, else 0.
    ///
    /// C: `dJointGetBreakLimits`.
    pub fn break_limits(&self) -> Result<(Real, Real)> {
        let mut force: Real = Default::default();
        let mut torque: Real = Default::default();
        call(|| unsafe { sys::dJointGetBreakLimits(self.raw(), &mut force, &mut torque) })?;
        Ok((force, torque))
    }

    /// Returns 1 if the joint has broken and has not been enabled since, else 0.
    ///
    /// C: `dJointIsBroken`.
    pub fn is_broken(&self) -> bool {
        let r = sure(|| unsafe { sys::dJointIsBroken(self.raw()) });
        r != 0
    }

    /// How many bodies are attached to the joint: 0, 1 or 2.
    ///
    /// C: `dJointGetNumBodies`.
    pub fn num_bodies(&self) -> i32 {
        sure(|| unsafe { sys::dJointGetNumBodies(self.raw()) })
    }

    /// 1 if the joint is enabled, 0 if it is disabled.
    ///
    /// A disabled joint exerts no force and connects no island, but stays attached.
    ///
    /// C: `dJointIsEnabled`.
    pub fn is_enabled(&self) -> bool {
        let r = sure(|| unsafe { sys::dJointIsEnabled(self.raw()) });
        r != 0
    }

    /// Write the anchor as body 1 has it now to result, m, world frame. It differs from
    /// dJointGetBallAnchor2 by the joint's error.
    ///
    /// C: `dJointGetBallAnchor`.
    pub fn ball_anchor(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetBallAnchor(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the anchor as body 2 has it now to result, m, world frame. It differs from
    /// dJointGetBallAnchor by the joint's error.
    ///
    /// C: `dJointGetBallAnchor2`.
    pub fn ball_anchor2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetBallAnchor2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The value of a parameter of the joint: dParamERP or dParamCFM.
    ///
    /// C: `dJointGetBallParam`.
    pub fn ball_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetBallParam(self.raw(), parameter.number()) })
    }

    /// The value of a parameter of the hinge's limit and motor.
    ///
    /// C: `dJointGetHingeParam`.
    pub fn hinge_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetHingeParam(self.raw(), parameter.number()) })
    }

    /// Write the anchor as body 1 has it now to result, m, world frame. It differs from
    /// dJointGetHingeAnchor2 by the joint's error.
    ///
    /// C: `dJointGetHingeAnchor`.
    pub fn hinge_anchor(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetHingeAnchor(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the anchor as body 2 has it now to result, m, world frame. It differs from
    /// dJointGetHingeAnchor by the joint's error.
    ///
    /// C: `dJointGetHingeAnchor2`.
    pub fn hinge_anchor2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetHingeAnchor2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The axis as body 1 has it now, a unit vector.
    ///
    /// C: `dJointGetHingeAxis`.
    pub fn hinge_axis(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetHingeAxis(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The rotation of body 1 relative to body 2 about the axis since the anchor or axis
    /// was set, rad, within \[-pi, pi\].
    ///
    /// It changes sign when the joint is attached as (0, body).
    ///
    /// C: `dJointGetHingeAngle`.
    pub fn hinge_angle(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetHingeAngle(self.raw()) })
    }

    /// The rate of the hinge's angle, rad/s.
    ///
    /// It changes sign when the joint is attached as (0, body).
    ///
    /// C: `dJointGetHingeAngleRate`.
    pub fn hinge_angle_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetHingeAngleRate(self.raw()) })
    }

    /// The value of a parameter of the slider's limit and motor.
    ///
    /// C: `dJointGetSliderParam`.
    pub fn slider_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetSliderParam(self.raw(), parameter.number()) })
    }

    /// How far body 1 has moved along the axis, relative to body 2, since the axis
    /// was set, m.
    ///
    /// It changes sign when the joint is attached as (0, body).
    ///
    /// C: `dJointGetSliderPosition`.
    pub fn slider_position(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetSliderPosition(self.raw()) })
    }

    /// The rate of the slider's position, m/s.
    ///
    /// It changes sign when the joint is attached as (0, body).
    ///
    /// C: `dJointGetSliderPositionRate`.
    pub fn slider_position_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetSliderPositionRate(self.raw()) })
    }

    /// The axis as body 1 has it now, a unit vector.
    ///
    /// C: `dJointGetSliderAxis`.
    pub fn slider_axis(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetSliderAxis(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The value of a parameter of one of the two limits and motors: of axis 1 by the
    /// plain names, of axis 2 by those that end in 2.
    ///
    /// C: `dJointGetUniversalParam`.
    pub fn universal_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetUniversalParam(self.raw(), parameter.number()) })
    }

    /// Write the anchor as body 1 has it now to result, m, world frame. It differs
    /// from dJointGetUniversalAnchor2 by the joint's error.
    ///
    /// C: `dJointGetUniversalAnchor`.
    pub fn universal_anchor(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetUniversalAnchor(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the anchor as body 2 has it now to result, m, world frame. It differs
    /// from dJointGetUniversalAnchor by the joint's error.
    ///
    /// C: `dJointGetUniversalAnchor2`.
    pub fn universal_anchor2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetUniversalAnchor2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write axis 1 as body 1 has it now to result: a unit vector, world frame.
    ///
    /// C: `dJointGetUniversalAxis1`.
    pub fn universal_axis1(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetUniversalAxis1(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write axis 2 as body 2 has it now to result: a unit vector, world frame.
    ///
    /// C: `dJointGetUniversalAxis2`.
    pub fn universal_axis2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetUniversalAxis2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the angles between body 1 and the cross piece about axis 1, and between
    /// body 2 and the cross piece about axis 2, to \*angle1 and \*angle2: rad, within \[-pi, pi\]. Neither pointer
    /// may be null.
    ///
    /// C: `dJointGetUniversalAngles`.
    pub fn universal_angles(&self) -> Result<(Real, Real)> {
        let mut angle1: Real = Default::default();
        let mut angle2: Real = Default::default();
        call(|| unsafe { sys::dJointGetUniversalAngles(self.raw(), &mut angle1, &mut angle2) })?;
        Ok((angle1, angle2))
    }

    /// The angle between body 1 and the cross piece about axis 1, rad, within \[-pi,
    /// pi\].
    ///
    /// C: `dJointGetUniversalAngle1`.
    pub fn universal_angle1(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetUniversalAngle1(self.raw()) })
    }

    /// The angle between body 2 and the cross piece about axis 2, rad, within \[-pi,
    /// pi\].
    ///
    /// C: `dJointGetUniversalAngle2`.
    pub fn universal_angle2(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetUniversalAngle2(self.raw()) })
    }

    /// The rate of the angle about axis 1, rad/s.
    ///
    /// C: `dJointGetUniversalAngle1Rate`.
    pub fn universal_angle1_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetUniversalAngle1Rate(self.raw()) })
    }

    /// The rate of the angle about axis 2, rad/s.
    ///
    /// C: `dJointGetUniversalAngle2Rate`.
    pub fn universal_angle2_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetUniversalAngle2Rate(self.raw()) })
    }

    /// The value of a parameter: of axis 1 by the plain names, of the motor of axis 2 by
    /// those that end in 2, of the suspension dParamSuspensionERP and dParamSuspensionCFM.
    ///
    /// C: `dJointGetHinge2Param`.
    pub fn hinge2_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetHinge2Param(self.raw(), parameter.number()) })
    }

    /// Write the anchor as body 1 has it now to result, m, world frame. It differs from
    /// dJointGetHinge2Anchor2 by the travel of the suspension.
    ///
    /// C: `dJointGetHinge2Anchor`.
    pub fn hinge2_anchor(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetHinge2Anchor(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the anchor as body 2 has it now to result, m, world frame. It differs
    /// from dJointGetHinge2Anchor by the travel of the suspension.
    ///
    /// C: `dJointGetHinge2Anchor2`.
    pub fn hinge2_anchor2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetHinge2Anchor2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write axis 1 as body 1 has it now to result: a unit vector, world frame.
    ///
    /// C: `dJointGetHinge2Axis1`.
    pub fn hinge2_axis1(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetHinge2Axis1(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write axis 2 as body 2 has it now to result: a unit vector, world frame.
    ///
    /// C: `dJointGetHinge2Axis2`.
    pub fn hinge2_axis2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetHinge2Axis2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Steering angle of body 1 relative to body 2 about axis 1, within (-pi, pi\], rad.
    ///
    /// C: `dJointGetHinge2Angle1`.
    pub fn hinge2_angle1(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetHinge2Angle1(self.raw()) })
    }

    /// Spin angle about axis 2, within (-pi, pi\], rad: it grows as the wheel turns forward about axis 2.
    ///
    /// C: `dJointGetHinge2Angle2`.
    pub fn hinge2_angle2(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetHinge2Angle2(self.raw()) })
    }

    /// The rate of the steering angle, of body 1 relative to body 2 about axis 1,
    /// rad/s.
    ///
    /// C: `dJointGetHinge2Angle1Rate`.
    pub fn hinge2_angle1_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetHinge2Angle1Rate(self.raw()) })
    }

    /// The angular velocity of body 1 relative to body 2 about axis 2, rad/s. It
    /// has the opposite sign of the change of dJointGetHinge2Angle2.
    ///
    /// C: `dJointGetHinge2Angle2Rate`.
    pub fn hinge2_angle2_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetHinge2Angle2Rate(self.raw()) })
    }

    /// The value of a parameter of the joint: dParamERP or dParamCFM.
    ///
    /// C: `dJointGetFixedParam`.
    pub fn fixed_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetFixedParam(self.raw(), parameter.number()) })
    }

    /// The motor's mode: dAMotorUser or dAMotorEuler.
    ///
    /// C: `dJointGetAMotorMode`.
    pub fn amotor_mode(&self) -> Result<AMotorMode> {
        let r = call(|| unsafe { sys::dJointGetAMotorMode(self.raw()) })?;
        let r = r as i32;
        Ok(AMotorMode::of_number(r))
    }

    /// How many axes are in use.
    ///
    /// C: `dJointGetAMotorNumAxes`.
    pub fn amotor_num_axes(&self) -> Result<i32> {
        call(|| unsafe { sys::dJointGetAMotorNumAxes(self.raw()) })
    }

    /// Write axis anum as it is now to result: a unit vector, world frame.
    ///
    /// C: `dJointGetAMotorAxis`.
    pub fn amotor_axis(&self, anum: i32) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetAMotorAxis(self.raw(), anum, result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// What axis anum moves with: 0 the world, 1 body 1, 2 body 2.
    ///
    /// C: `dJointGetAMotorAxisRel`.
    pub fn amotor_axis_rel(&self, anum: i32) -> Result<i32> {
        call(|| unsafe { sys::dJointGetAMotorAxisRel(self.raw(), anum) })
    }

    /// The angle about axis anum, rad: in user mode what the program has set, in Euler
    /// mode that of the last step.
    ///
    /// C: `dJointGetAMotorAngle`.
    pub fn amotor_angle(&self, anum: i32) -> Result<Real> {
        call(|| unsafe { sys::dJointGetAMotorAngle(self.raw(), anum) })
    }

    /// Relative angular velocity of the bodies about axis anum, rad/s.
    ///
    /// C: `dJointGetAMotorAngleRate`.
    pub fn amotor_angle_rate(&self, anum: i32) -> Result<Real> {
        call(|| unsafe { sys::dJointGetAMotorAngleRate(self.raw(), anum) })
    }

    /// The value of a parameter of one of the three limits and motors: of axis 0 by the
    /// plain names, of axis 1 and 2 by those that end in 2 and 3.
    ///
    /// C: `dJointGetAMotorParam`.
    pub fn amotor_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetAMotorParam(self.raw(), parameter.number()) })
    }

    /// How many axes are in use.
    ///
    /// C: `dJointGetLMotorNumAxes`.
    pub fn lmotor_num_axes(&self) -> Result<i32> {
        call(|| unsafe { sys::dJointGetLMotorNumAxes(self.raw()) })
    }

    /// Axis anum as it is stored: result is in the frame of the body it turns with, or in the world's.
    ///
    /// C: `dJointGetLMotorAxis`.
    pub fn lmotor_axis(&self, anum: i32) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetLMotorAxis(self.raw(), anum, result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The value of a parameter of one of the three motors: of axis 0 by the plain
    /// names, of axis 1 and 2 by those that end in 2 and 3.
    ///
    /// C: `dJointGetLMotorParam`.
    pub fn lmotor_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetLMotorParam(self.raw(), parameter.number()) })
    }

    /// The value of a parameter of a limit and motor: of the slide by the plain names, of
    /// the turn by those that end in 2.
    ///
    /// C: `dJointGetPRParam`.
    pub fn pr_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPRParam(self.raw(), parameter.number()) })
    }

    /// The anchor as body 2 has it now.
    ///
    /// C: `dJointGetPRAnchor`.
    pub fn pr_anchor(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPRAnchor(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the axis of the slide as body 1 has it now to result: a unit vector, world
    /// frame.
    ///
    /// C: `dJointGetPRAxis1`.
    pub fn pr_axis1(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPRAxis1(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the axis of the turn as body 1 has it now to result: a unit vector, world
    /// frame.
    ///
    /// C: `dJointGetPRAxis2`.
    pub fn pr_axis2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPRAxis2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// How far body 1's anchor is along axis 1 from body 2's, m.
    ///
    /// C: `dJointGetPRPosition`.
    pub fn pr_position(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPRPosition(self.raw()) })
    }

    /// The rate of the position along axis 1, m/s, where body 1 does not turn: its
    /// angular velocity is not counted.
    ///
    /// C: `dJointGetPRPositionRate`.
    pub fn pr_position_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPRPositionRate(self.raw()) })
    }

    /// The rotation of body 1 relative to body 2 about axis 2, rad, within \[-pi, pi\].
    ///
    /// C: `dJointGetPRAngle`.
    pub fn pr_angle(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPRAngle(self.raw()) })
    }

    /// The rate of the angle about axis 2, rad/s.
    ///
    /// C: `dJointGetPRAngleRate`.
    pub fn pr_angle_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPRAngleRate(self.raw()) })
    }

    /// The value of a parameter of a limit and motor: of axis 1 by the plain names, of axis
    /// 2 and the slide by those that end in 2 and 3.
    ///
    /// C: `dJointGetPUParam`.
    pub fn pu_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPUParam(self.raw(), parameter.number()) })
    }

    /// The anchor as body 2 has it now.
    ///
    /// C: `dJointGetPUAnchor`.
    pub fn pu_anchor(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPUAnchor(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write axis 1 of the universal joint as body 1 has it now to result: a unit vector,
    /// world frame.
    ///
    /// C: `dJointGetPUAxis1`.
    pub fn pu_axis1(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPUAxis1(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write axis 2 of the universal joint as body 2 has it now to result: a unit vector,
    /// world frame.
    ///
    /// C: `dJointGetPUAxis2`.
    pub fn pu_axis2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPUAxis2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write axis 3, of the slide, as body 1 has it now to result: a unit vector, world
    /// frame.
    ///
    /// C: `dJointGetPUAxis3`.
    pub fn pu_axis3(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPUAxis3(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Another name of dJointGetPUAxis3: write the axis of the slide to result, a unit
    /// vector, world frame.
    ///
    /// C: `dJointGetPUAxisP`.
    pub fn pu_axis_p(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPUAxisP(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// How far body 1's anchor is along axis 3 from body 2's, m.
    ///
    /// C: `dJointGetPUPosition`.
    pub fn pu_position(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPUPosition(self.raw()) })
    }

    /// The rate of the position along axis 3, m/s, where body 2 does not turn: its
    /// angular velocity is counted with the opposite sign.
    ///
    /// C: `dJointGetPUPositionRate`.
    pub fn pu_position_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPUPositionRate(self.raw()) })
    }

    /// Write the angles about axis 1 and axis 2 to \*angle1 and \*angle2: rad, as of the
    /// universal joint. Neither pointer may be null.
    ///
    /// C: `dJointGetPUAngles`.
    pub fn pu_angles(&self) -> Result<(Real, Real)> {
        let mut angle1: Real = Default::default();
        let mut angle2: Real = Default::default();
        call(|| unsafe { sys::dJointGetPUAngles(self.raw(), &mut angle1, &mut angle2) })?;
        Ok((angle1, angle2))
    }

    /// The angle about axis 1, rad, as of the universal joint.
    ///
    /// C: `dJointGetPUAngle1`.
    pub fn pu_angle1(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPUAngle1(self.raw()) })
    }

    /// The rate of the angle about axis 1, rad/s.
    ///
    /// C: `dJointGetPUAngle1Rate`.
    pub fn pu_angle1_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPUAngle1Rate(self.raw()) })
    }

    /// The angle about axis 2, rad, as of the universal joint.
    ///
    /// C: `dJointGetPUAngle2`.
    pub fn pu_angle2(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPUAngle2(self.raw()) })
    }

    /// The rate of the angle about axis 2, rad/s.
    ///
    /// C: `dJointGetPUAngle2Rate`.
    pub fn pu_angle2_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPUAngle2Rate(self.raw()) })
    }

    /// The value of a parameter of a limit and motor: of the slide by the plain names,
    /// of the turn by those that end in 2.
    ///
    /// C: `dJointGetPistonParam`.
    pub fn piston_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPistonParam(self.raw(), parameter.number()) })
    }

    /// Write the anchor as body 1 has it now to result, m, world frame.
    ///
    /// C: `dJointGetPistonAnchor`.
    pub fn piston_anchor(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPistonAnchor(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the anchor as body 2 has it now to result, m, world frame.
    ///
    /// C: `dJointGetPistonAnchor2`.
    pub fn piston_anchor2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPistonAnchor2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The axis as body 1 has it now, a unit vector.
    ///
    /// C: `dJointGetPistonAxis`.
    pub fn piston_axis(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetPistonAxis(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// How far body 1's anchor is along the axis from body 2's, m.
    ///
    /// C: `dJointGetPistonPosition`.
    pub fn piston_position(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPistonPosition(self.raw()) })
    }

    /// The velocity along the axis of body 1's centre relative to body 2's, m/s.
    ///
    /// C: `dJointGetPistonPositionRate`.
    pub fn piston_position_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPistonPositionRate(self.raw()) })
    }

    /// The rotation of body 1 relative to body 2 about the axis, rad, within \[-pi, pi\].
    ///
    /// C: `dJointGetPistonAngle`.
    pub fn piston_angle(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPistonAngle(self.raw()) })
    }

    /// The rate of the angle about the axis, rad/s.
    ///
    /// C: `dJointGetPistonAngleRate`.
    pub fn piston_angle_rate(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetPistonAngleRate(self.raw()) })
    }

    /// The distance to keep, m, which need not be the present one.
    ///
    /// C: `dJointGetDBallDistance`.
    pub fn dball_distance(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetDBallDistance(self.raw()) })
    }

    /// The value of a parameter of the joint: dParamERP or dParamCFM.
    ///
    /// C: `dJointGetDBallParam`.
    pub fn dball_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetDBallParam(self.raw(), parameter.number()) })
    }

    /// Write where the point of body 1 is now to result, m, world frame.
    ///
    /// C: `dJointGetDBallAnchor1`.
    pub fn dball_anchor1(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetDBallAnchor1(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write where the point of body 2 is now to result, m, world frame.
    ///
    /// C: `dJointGetDBallAnchor2`.
    pub fn dball_anchor2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetDBallAnchor2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The value of a parameter of the joint: dParamERP or dParamCFM.
    ///
    /// C: `dJointGetDHingeParam`.
    pub fn dhinge_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetDHingeParam(self.raw(), parameter.number()) })
    }

    /// Write the common axis as body 1 has it now to result: a unit vector, world frame.
    ///
    /// C: `dJointGetDHingeAxis`.
    pub fn dhinge_axis(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetDHingeAxis(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write where the point of body 1 is now to result, m, world frame.
    ///
    /// C: `dJointGetDHingeAnchor1`.
    pub fn dhinge_anchor1(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetDHingeAnchor1(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write where the point of body 2 is now to result, m, world frame.
    ///
    /// C: `dJointGetDHingeAnchor2`.
    pub fn dhinge_anchor2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetDHingeAnchor2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The distance to keep, m.
    ///
    /// C: `dJointGetDHingeDistance`.
    pub fn dhinge_distance(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetDHingeDistance(self.raw()) })
    }

    /// What kind of wheels the joint couples: dTransmissionParallelAxes,
    /// dTransmissionIntersectingAxes or dTransmissionChainDrive.
    ///
    /// C: `dJointGetTransmissionMode`.
    pub fn transmission_mode(&self) -> Result<TransmissionMode> {
        let r = call(|| unsafe { sys::dJointGetTransmissionMode(self.raw()) })?;
        let r = r as i32;
        Ok(TransmissionMode::of_number(r))
    }

    /// Write the centre of wheel 1 to result, m, world frame.
    ///
    /// C: `dJointGetTransmissionAnchor1`.
    pub fn transmission_anchor1(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetTransmissionAnchor1(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the centre of wheel 2 to result, m, world frame.
    ///
    /// C: `dJointGetTransmissionAnchor2`.
    pub fn transmission_anchor2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetTransmissionAnchor2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the axis of both wheels to result: a unit vector, world frame.
    ///
    /// C: `dJointGetTransmissionAxis`.
    pub fn transmission_axis(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetTransmissionAxis(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the axis of wheel 1 to result: a unit vector, world frame.
    ///
    /// C: `dJointGetTransmissionAxis1`.
    pub fn transmission_axis1(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetTransmissionAxis1(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write the axis of wheel 2 to result: a unit vector, world frame.
    ///
    /// C: `dJointGetTransmissionAxis2`.
    pub fn transmission_axis2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetTransmissionAxis2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The ratio radius 1 / radius 2.
    ///
    /// C: `dJointGetTransmissionRatio`.
    pub fn transmission_ratio(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetTransmissionRatio(self.raw()) })
    }

    /// The radius of wheel 1, m: as set for a chain, else as measured by the
    /// first step.
    ///
    /// Without radii a chain does nothing; in the other modes they follow from the geometry.
    ///
    /// C: `dJointGetTransmissionRadius1`.
    pub fn transmission_radius1(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetTransmissionRadius1(self.raw()) })
    }

    /// The radius of wheel 2, m: as set for a chain, else as measured by the
    /// first step.
    ///
    /// Without radii a chain does nothing; in the other modes they follow from the geometry.
    ///
    /// C: `dJointGetTransmissionRadius2`.
    pub fn transmission_radius2(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetTransmissionRadius2(self.raw()) })
    }

    /// The backlash: the free play of the rims to either side of zero slip, m.
    ///
    /// C: `dJointGetTransmissionBacklash`.
    pub fn transmission_backlash(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetTransmissionBacklash(self.raw()) })
    }

    /// The value of a parameter of the joint: dParamERP or dParamCFM.
    ///
    /// C: `dJointGetTransmissionParam`.
    pub fn transmission_param(&self, parameter: Param) -> Result<Real> {
        call(|| unsafe { sys::dJointGetTransmissionParam(self.raw(), parameter.number()) })
    }

    /// How far the point of contact has run around wheel 1, as body 1 sees it,
    /// about its axis, rad: a wheel that turns forward counts backward; full turns add up.
    ///
    /// It is what the last step began with.
    ///
    /// C: `dJointGetTransmissionAngle1`.
    pub fn transmission_angle1(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetTransmissionAngle1(self.raw()) })
    }

    /// How far the point of contact has run around wheel 2, as body 2 sees it,
    /// about its axis, rad: a wheel that turns forward counts backward; full turns add up.
    ///
    /// It is what the last step began with.
    ///
    /// C: `dJointGetTransmissionAngle2`.
    pub fn transmission_angle2(&self) -> Result<Real> {
        call(|| unsafe { sys::dJointGetTransmissionAngle2(self.raw()) })
    }

    /// Write where wheel 1 touched the other wheel or the chain to result,
    /// m, world frame.
    ///
    /// It is what the last step began with.
    ///
    /// C: `dJointGetTransmissionContactPoint1`.
    pub fn transmission_contact_point1(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetTransmissionContactPoint1(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Write where wheel 2 touched the other wheel or the chain to result,
    /// m, world frame.
    ///
    /// It is what the last step began with.
    ///
    /// C: `dJointGetTransmissionContactPoint2`.
    pub fn transmission_contact_point2(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dJointGetTransmissionContactPoint2(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }
}

impl JointMut<'_> {
    /// Set a parameter of the coupling to value: dParamLoStop and dParamHiStop, m or rad, 0 at
    /// first; dParamStopERP, dParamStopCFM and dParamBounce. Equal stops hold s there; a stop of -dInfinity or
    /// dInfinity is none. Others have no effect. Refused: NaN, and
    /// dInfinity where it is no stop.
    ///
    /// C: `dJointSetCouplingParam`.
    pub fn set_coupling_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetCouplingParam(self.raw(), parameter.number(), value) })
    }

    /// Let the angle of an axis count turns always, mode 1, from where it is now, or only
    /// while it has stops, mode 0, the default. Turns are counted in steps: an axis may turn by less than pi in
    /// each. Stops compare the position: they may lie beyond half a turn. (With dBehaviour016 and mode 0 they
    /// compare angles in -pi ... pi.) Axes that are no angles do not change. Returns 1. Another mode is refused.
    ///
    /// C: `dJointSetAxisContinuous`.
    pub fn set_axis_continuous(&mut self, axis: i32, mode: bool) -> Result<()> {
        call(|| unsafe { sys::dJointSetAxisContinuous(self.raw(), axis, i32::from(mode)); })
    }

    /// Say in which turn an angle is that counts turns: in the one where it is nearest to
    /// position, rad. Otherwise, where the program places the bodies, it is the one nearest to the middle of its
    /// stops, or, where these are a turn or more apart, nearest to the last. Returns 1. Refused: a position
    /// that is not finite.
    ///
    /// C: `dJointSetAxisTurn`.
    pub fn set_axis_turn(&mut self, axis: i32, position: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetAxisTurn(self.raw(), axis, position); })
    }

    /// Put a drive on an axis, in place of the one it has; drive NULL takes it away. It acts
    /// together with the axis's stops and the motor of dParamVel and dParamFMax, in every stepper and in each
    /// substep, until changed. An angle's target is taken modulo a turn, the shorter way, unless the axis counts
    /// turns (dJointGetAxisPosition). A change wakes the joint's bodies. Returns 1, or 0 when refused
    /// (numbers that are negative or not finite, a structure of a wrong size) or out of memory.
    ///
    /// C: `dJointSetDrive`.
    pub fn set_drive(&mut self, axis: i32, drive: Option<&Drive>) -> Result<()> {
        let drive = drive.map(Drive::to_raw);
        call(|| unsafe { sys::dJointSetDrive(self.raw(), axis, drive.as_ref().map_or(std::ptr::null(), std::ptr::from_ref)); })
    }

    /// Let the stops of an axis be springs with dampers, N/m and N s/m or N m/rad and
    /// N m s/rad, that push back what is beyond them; with equal stops, in both directions. They hold in every
    /// step and substep, whatever its size, in place of dParamStopERP, dParamStopCFM and dParamBounce. Axes are
    /// numbered as groups of parameters are (dParamLoStop2 is a stop of axis 1). stiffness and damping, both 0:
    /// ERP and CFM count again. Returns 1, or 0 when refused: negative numbers; an axis without stops.
    ///
    /// C: `dJointSetStopSpring`.
    pub fn set_stop_spring(&mut self, axis: i32, stiffness: Real, damping: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetStopSpring(self.raw(), axis, stiffness, damping); })
    }

    /// Let the stops of an axis push back what is beyond them by at most \`rate\` times the distance,
    /// per second. Robots of files have 20/s. dInfinity, the default: ERP alone counts. Returns 1, or 0 when
    /// refused: a \`rate\` that is not above 0; an axis without stops.
    ///
    /// A joint that is made far beyond a stop is pushed back at dParamStopERP / h times the distance: the faster, the
    /// smaller the step is, and it keeps that speed. A \`rate\` bounds it in steps that correct by velocities. It does not
    /// count where poses are corrected instead (dWorldSetStepProjection, dWorldSetContactMaxCorrectingVel).
    ///
    /// C: `dJointSetStopRate`.
    pub fn set_stop_rate(&mut self, axis: i32, rate: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetStopRate(self.raw(), axis, rate); })
    }

    /// Let the rows that have the joint's own ERP and CFM be springs with dampers, N/m and
    /// N s/m: the anchor of a ball, the place of a fixed joint, the rod of a double ball or double hinge, the
    /// suspension of a hinge-2 (there dParamSuspensionERP and CFM), in every step and substep, whatever its
    /// size. stiffness and damping, both 0: ERP and CFM count again. Returns 1, or 0 when refused: negative
    /// numbers; a type without ERP and CFM of its own.
    ///
    /// C: `dJointSetSpring`.
    pub fn set_spring(&mut self, stiffness: Real, damping: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetSpring(self.raw(), stiffness, damping); })
    }

    /// Let the joint break when it has exerted more than this force, N, or torque, N m,
    /// as the mean over a step; 0 or dInfinity: no limit, the default. Force and torque are those on body 1,
    /// drives and motors included, the torque about the anchor of a ball, hinge, universal, hinge-2 or fixed
    /// joint, else about the body's centre. A joint that breaks has acted in the whole step and is disabled at
    /// its end; dJointEnable mends it. Returns 1, or 0 when refused (negative numbers, a contact joint) or out
    /// of memory.
    ///
    /// C: `dJointSetBreakLimits`.
    pub fn set_break_limits(&mut self, force: Real, torque: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetBreakLimits(self.raw(), force, torque); })
    }

    /// Let the joint act again. New joints are enabled.
    ///
    /// A disabled joint exerts no force and connects no island, but stays attached.
    ///
    /// C: `dJointEnable`.
    pub fn enable(&mut self) -> Result<()> {
        call(|| unsafe { sys::dJointEnable(self.raw()) })
    }

    /// Let the joint act no more until dJointEnable.
    ///
    /// A disabled joint exerts no force and connects no island, but stays attached.
    ///
    /// C: `dJointDisable`.
    pub fn disable(&mut self) -> Result<()> {
        call(|| unsafe { sys::dJointDisable(self.raw()) })
    }

    /// The point that both bodies have in common. Default: the origin of each body.
    ///
    /// C: `dJointSetBallAnchor`; `xyz` is (x, y, z).
    pub fn set_ball_anchor(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetBallAnchor(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Sets only body 2's anchor; (x, y, z) is in body 2's frame (in the world's when there is no body 2).
    ///
    /// C: `dJointSetBallAnchor2`; `xyz` is (x, y, z).
    pub fn set_ball_anchor2(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetBallAnchor2(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
    /// the world.
    ///
    /// C: `dJointSetBallParam`.
    pub fn set_ball_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetBallParam(self.raw(), parameter.number(), value) })
    }

    /// The point that both bodies have in common. The angle then reads 0.
    ///
    /// C: `dJointSetHingeAnchor`; `xyz` is (x, y, z).
    pub fn set_hinge_anchor(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetHingeAnchor(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// As dJointSetHingeAnchor, with body 2's anchor moved by (ax, ay, az), m, when body 2 is the world.
    ///
    /// C: `dJointSetHingeAnchorDelta`; `xyz` is (x, y, z); `delta` is (ax, ay, az).
    pub fn set_hinge_anchor_delta(&mut self, xyz: Vec3, delta: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetHingeAnchorDelta(self.raw(), xyz[0], xyz[1], xyz[2], delta[0], delta[1], delta[2]) })
    }

    /// The axis that both bodies have in common. The angle then reads 0.
    ///
    /// C: `dJointSetHingeAxis`; `xyz` is (x, y, z).
    pub fn set_hinge_axis(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetHingeAxis(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Sets the axis and shifts the zero of the angle, rad. With t the turn about the axis from body 2's
    /// orientation to body 1's, the angle then reads 2 t - angle: t if the bodies are turned by the given angle,
    /// -angle if they are not turned; attached as (0, B), all of it counts the turn the other way round.
    ///
    /// C: `dJointSetHingeAxisOffset`; `xyz` is (x, y, z).
    pub fn set_hinge_axis_offset(&mut self, xyz: Vec3, angle: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetHingeAxisOffset(self.raw(), xyz[0], xyz[1], xyz[2], angle) })
    }

    /// Set a parameter of the hinge's limit and motor to value; its unit is in the table
    /// of parameters.
    ///
    /// C: `dJointSetHingeParam`.
    pub fn set_hinge_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetHingeParam(self.raw(), parameter.number(), value) })
    }

    /// Apply a torque (N m) about the axis to body 1 and the opposite to body 2, for the next step.
    ///
    /// C: `dJointAddHingeTorque`.
    pub fn add_hinge_torque(&mut self, torque: Real) -> Result<()> {
        call(|| unsafe { sys::dJointAddHingeTorque(self.raw(), torque) })
    }

    /// The axis of the sliding. The position then reads 0, and the present rotation is the one to keep.
    ///
    /// C: `dJointSetSliderAxis`; `xyz` is (x, y, z).
    pub fn set_slider_axis(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetSliderAxis(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Sets the axis, with the zero position shifted by (ax, ay, az), m, when body 2 is the world: the
    /// position then reads -(axis . a).
    ///
    /// C: `dJointSetSliderAxisDelta`; `xyz` is (x, y, z); `delta` is (ax, ay, az).
    pub fn set_slider_axis_delta(&mut self, xyz: Vec3, delta: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetSliderAxisDelta(self.raw(), xyz[0], xyz[1], xyz[2], delta[0], delta[1], delta[2]) })
    }

    /// Set a parameter of the slider's limit and motor to value; its unit is in the
    /// table of parameters.
    ///
    /// C: `dJointSetSliderParam`.
    pub fn set_slider_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetSliderParam(self.raw(), parameter.number(), value) })
    }

    /// Apply a force (N) along the axis to body 1 and the opposite to body 2, for the next step; the torque
    /// that keeps angular momentum is added, too.
    ///
    /// C: `dJointAddSliderForce`.
    pub fn add_slider_force(&mut self, force: Real) -> Result<()> {
        call(|| unsafe { sys::dJointAddSliderForce(self.raw(), force) })
    }

    /// The point that both bodies have in common. The angles then read 0.
    ///
    /// C: `dJointSetUniversalAnchor`; `xyz` is (x, y, z).
    pub fn set_universal_anchor(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetUniversalAnchor(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set axis 1, which moves with body 1; set it perpendicular to axis 2.
    ///
    /// The angles then read 0.
    ///
    /// C: `dJointSetUniversalAxis1`; `xyz` is (x, y, z).
    pub fn set_universal_axis1(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetUniversalAxis1(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set axis 2, which moves with body 2; set it perpendicular to axis 1.
    ///
    /// The angles then read 0.
    ///
    /// C: `dJointSetUniversalAxis2`; `xyz` is (x, y, z).
    pub fn set_universal_axis2(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetUniversalAxis2(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set axis 1, which moves with body 1, and the angles.
    ///
    /// The zeros are shifted so that the angles now read offset1 and offset2, rad.
    ///
    /// C: `dJointSetUniversalAxis1Offset`; `xyz` is (x, y, z).
    pub fn set_universal_axis1_offset(&mut self, xyz: Vec3, offset1: Real, offset2: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetUniversalAxis1Offset(self.raw(), xyz[0], xyz[1], xyz[2], offset1, offset2) })
    }

    /// Set axis 2, which moves with body 2, and the angles.
    ///
    /// The zeros are shifted so that the angles now read offset1 and offset2, rad.
    ///
    /// C: `dJointSetUniversalAxis2Offset`; `xyz` is (x, y, z).
    pub fn set_universal_axis2_offset(&mut self, xyz: Vec3, offset1: Real, offset2: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetUniversalAxis2Offset(self.raw(), xyz[0], xyz[1], xyz[2], offset1, offset2) })
    }

    /// Set a parameter of one of the two limits and motors to value: of axis 1 by the
    /// plain names, of axis 2 by those that end in 2.
    ///
    /// C: `dJointSetUniversalParam`.
    pub fn set_universal_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetUniversalParam(self.raw(), parameter.number(), value) })
    }

    /// Apply torque1 about axis 1 and torque2 about axis 2 (N m) to body 1 and the opposite to body 2, for
    /// the next step.
    ///
    /// C: `dJointAddUniversalTorques`.
    pub fn add_universal_torques(&mut self, torque1: Real, torque2: Real) -> Result<()> {
        call(|| unsafe { sys::dJointAddUniversalTorques(self.raw(), torque1, torque2) })
    }

    /// The centre of the wheel, common to both bodies. The angles then read 0.
    ///
    /// C: `dJointSetHinge2Anchor`; `xyz` is (x, y, z).
    pub fn set_hinge2_anchor(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetHinge2Anchor(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Old form: set axis 1, of the steering, which moves with body 1.
    ///
    /// The other axis stays. dJointSetHinge2Axes sets both.
    ///
    /// C: `dJointSetHinge2Axis1`; `xyz` is (x, y, z).
    pub fn set_hinge2_axis1(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetHinge2Axis1(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Old form: set axis 2, of the spin, which moves with body 2.
    ///
    /// The other axis stays. dJointSetHinge2Axes sets both.
    ///
    /// C: `dJointSetHinge2Axis2`; `xyz` is (x, y, z).
    pub fn set_hinge2_axis2(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetHinge2Axis2(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set a parameter to value: of axis 1 by the plain names, of the motor of axis 2 by
    /// those that end in 2, of the suspension dParamSuspensionERP and dParamSuspensionCFM.
    ///
    /// C: `dJointSetHinge2Param`.
    pub fn set_hinge2_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetHinge2Param(self.raw(), parameter.number(), value) })
    }

    /// Apply torque1 about axis 1 and torque2 about axis 2 (N m) to body 1 and the opposite to body 2, for
    /// the next step.
    ///
    /// C: `dJointAddHinge2Torques`.
    pub fn add_hinge2_torques(&mut self, torque1: Real, torque2: Real) -> Result<()> {
        call(|| unsafe { sys::dJointAddHinge2Torques(self.raw(), torque1, torque2) })
    }

    /// Take the current relative pose as the one to keep. Call it after attaching: attaching alone does not.
    ///
    /// C: `dJointSetFixed`.
    pub fn set_fixed(&mut self) -> Result<()> {
        call(|| unsafe { sys::dJointSetFixed(self.raw()) })
    }

    /// Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
    /// the world.
    ///
    /// C: `dJointSetFixedParam`.
    pub fn set_fixed_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetFixedParam(self.raw(), parameter.number(), value) })
    }

    /// Set what mode the motor is in. dAMotorUser (default): the program sets axes and,
    /// for stops, angles. dAMotorEuler: three axes, of which the program sets axis 0 (fixed in body 1) and
    /// axis 2 (fixed in body 2), perpendicular at that time; axis 1 and the Euler angles follow. The angle
    /// about axis 1 must stay within (-pi/2, pi/2): give it stops. Another mode is refused.
    ///
    /// C: `dJointSetAMotorMode`.
    pub fn set_amotor_mode(&mut self, mode: AMotorMode) -> Result<()> {
        call(|| unsafe { sys::dJointSetAMotorMode(self.raw(), mode.number()) })
    }

    /// Set how many axes are in use: num is 0 ... 3 (others are refused), default 0;
    /// in Euler mode it is always 3.
    ///
    /// C: `dJointSetAMotorNumAxes`.
    pub fn set_amotor_num_axes(&mut self, num: i32) -> Result<()> {
        call(|| unsafe { sys::dJointSetAMotorNumAxes(self.raw(), num) })
    }

    /// Set axis anum to (x, y, z), world frame, and what it moves with: rel 0 the world,
    /// 1 body 1, 2 body 2. In Euler mode axis 0 goes with body 1 and axis 2 with body 2: with rel 0 their
    /// (x, y, z) are in the frame of that body, and the other body is refused.
    ///
    /// C: `dJointSetAMotorAxis`; `xyz` is (x, y, z).
    pub fn set_amotor_axis(&mut self, anum: i32, rel: i32, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetAMotorAxis(self.raw(), anum, rel, xyz[0], xyz[1], xyz[2]) })
    }

    /// Tell the motor the angle about axis anum, rad, with which stops are compared;
    /// default 0. A program in user mode does so before each step; in Euler mode the call is refused.
    ///
    /// C: `dJointSetAMotorAngle`.
    pub fn set_amotor_angle(&mut self, anum: i32, angle: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetAMotorAngle(self.raw(), anum, angle) })
    }

    /// Set a parameter of one of the three limits and motors to value: of axis 0 by the
    /// plain names, of axis 1 and 2 by those that end in 2 and 3.
    ///
    /// C: `dJointSetAMotorParam`.
    pub fn set_amotor_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetAMotorParam(self.raw(), parameter.number(), value) })
    }

    /// Apply torque1, torque2, torque3 (N m) about the axes in use to body 1 and the opposite to body 2, for
    /// the next step.
    ///
    /// C: `dJointAddAMotorTorques`.
    pub fn add_amotor_torques(&mut self, torque1: Real, torque2: Real, torque3: Real) -> Result<()> {
        call(|| unsafe { sys::dJointAddAMotorTorques(self.raw(), torque1, torque2, torque3) })
    }

    /// Set how many axes are in use: num, held to 0 ... 3; default 0.
    ///
    /// C: `dJointSetLMotorNumAxes`.
    pub fn set_lmotor_num_axes(&mut self, num: i32) -> Result<()> {
        call(|| unsafe { sys::dJointSetLMotorNumAxes(self.raw(), num) })
    }

    /// Axis anum (0, 1, 2) and what it turns with: rel 0 the world, 1 body 1, 2 body 2 (body 1 when there is
    /// no body 2). (x, y, z) is in the world frame in any case.
    ///
    /// C: `dJointSetLMotorAxis`; `xyz` is (x, y, z).
    pub fn set_lmotor_axis(&mut self, anum: i32, rel: i32, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetLMotorAxis(self.raw(), anum, rel, xyz[0], xyz[1], xyz[2]) })
    }

    /// Set a parameter of one of the three motors to value: of axis 0 by the plain
    /// names, of axis 1 and 2 by those that end in 2 and 3.
    ///
    /// C: `dJointSetLMotorParam`.
    pub fn set_lmotor_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetLMotorParam(self.raw(), parameter.number(), value) })
    }

    /// Set a parameter of the motor along x to value.
    ///
    /// The plain names are meant; there are no stops.
    ///
    /// C: `dJointSetPlane2DXParam`.
    pub fn set_plane2d_xparam(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetPlane2DXParam(self.raw(), parameter.number(), value) })
    }

    /// Set a parameter of the motor along y to value.
    ///
    /// The plain names are meant; there are no stops.
    ///
    /// C: `dJointSetPlane2DYParam`.
    pub fn set_plane2d_yparam(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetPlane2DYParam(self.raw(), parameter.number(), value) })
    }

    /// Set a parameter of the motor about z to value.
    ///
    /// The plain names are meant; there are no stops.
    ///
    /// C: `dJointSetPlane2DAngleParam`.
    pub fn set_plane2d_angle_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetPlane2DAngleParam(self.raw(), parameter.number(), value) })
    }

    /// The point on the turning axis. The position reads 0 afterwards; the angle keeps its zero.
    ///
    /// C: `dJointSetPRAnchor`; `xyz` is (x, y, z).
    pub fn set_pr_anchor(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPRAnchor(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set axis 1, along which the anchor slides.
    ///
    /// It sets the zero of the angle, too.
    ///
    /// C: `dJointSetPRAxis1`; `xyz` is (x, y, z).
    pub fn set_pr_axis1(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPRAxis1(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set axis 2, about which body 2 turns.
    ///
    /// It sets the zero of the angle, too.
    ///
    /// C: `dJointSetPRAxis2`; `xyz` is (x, y, z).
    pub fn set_pr_axis2(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPRAxis2(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set a parameter of a limit and motor to value: of the slide by the plain names, of
    /// the turn by those that end in 2.
    ///
    /// C: `dJointSetPRParam`.
    pub fn set_pr_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetPRParam(self.raw(), parameter.number(), value) })
    }

    /// Apply a torque (N m) about axis 2 to body 1 and the opposite to body 2, for the next step.
    ///
    /// C: `dJointAddPRTorque`.
    pub fn add_pr_torque(&mut self, torque: Real) -> Result<()> {
        call(|| unsafe { sys::dJointAddPRTorque(self.raw(), torque) })
    }

    /// The point where axes 1 and 2 meet. The position and the angles read 0 afterwards.
    ///
    /// C: `dJointSetPUAnchor`; `xyz` is (x, y, z).
    pub fn set_pu_anchor(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPUAnchor(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// As dJointSetPUAnchor, as if the bodies had come apart by (dx, dy, dz), m, since: the position reads
    /// axis 3 . (dx, dy, dz).
    ///
    /// C: `dJointSetPUAnchorOffset`; `xyz` is (x, y, z); `delta` is (dx, dy, dz).
    pub fn set_pu_anchor_offset(&mut self, xyz: Vec3, delta: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPUAnchorOffset(self.raw(), xyz[0], xyz[1], xyz[2], delta[0], delta[1], delta[2]) })
    }

    /// Old form: the position reads -axis 3 . (dx, dy, dz), m, or plus when attached as (0, body).
    ///
    /// C: `dJointSetPUAnchorDelta`; `xyz` is (x, y, z); `delta` is (dx, dy, dz).
    pub fn set_pu_anchor_delta(&mut self, xyz: Vec3, delta: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPUAnchorDelta(self.raw(), xyz[0], xyz[1], xyz[2], delta[0], delta[1], delta[2]) })
    }

    /// Set axis 1 of the universal joint, which moves with body 1. It sets the zeros of the
    /// angles, too.
    ///
    /// C: `dJointSetPUAxis1`; `xyz` is (x, y, z).
    pub fn set_pu_axis1(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPUAxis1(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set axis 2 of the universal joint, which moves with body 2. It sets the zeros of the
    /// angles, too.
    ///
    /// C: `dJointSetPUAxis2`; `xyz` is (x, y, z).
    pub fn set_pu_axis2(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPUAxis2(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set axis 3, along which the anchor slides.
    ///
    /// C: `dJointSetPUAxis3`; `xyz` is (x, y, z).
    pub fn set_pu_axis3(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPUAxis3(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Another name of dJointSetPUAxis3: set the axis along which the anchor slides.
    ///
    /// C: `dJointSetPUAxisP`; `xyz` is (x, y, z).
    pub fn set_pu_axis_p(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPUAxisP(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set a parameter of a limit and motor to value: of axis 1 by the plain names, of axis
    /// 2 and the slide by those that end in 2 and 3.
    ///
    /// C: `dJointSetPUParam`.
    pub fn set_pu_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetPUParam(self.raw(), parameter.number(), value) })
    }

    /// A point on the axis. The position and the angle read 0 afterwards.
    ///
    /// C: `dJointSetPistonAnchor`; `xyz` is (x, y, z).
    pub fn set_piston_anchor(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPistonAnchor(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// As dJointSetPistonAnchor, as if the bodies had come apart by (dx, dy, dz), m, since: the position
    /// reads axis . (dx, dy, dz).
    ///
    /// C: `dJointSetPistonAnchorOffset`; `xyz` is (x, y, z); `delta` is (dx, dy, dz).
    pub fn set_piston_anchor_offset(&mut self, xyz: Vec3, delta: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPistonAnchorOffset(self.raw(), xyz[0], xyz[1], xyz[2], delta[0], delta[1], delta[2]) })
    }

    /// The axis of the slide and the turn. Sets the zero of the angle, too.
    ///
    /// C: `dJointSetPistonAxis`; `xyz` is (x, y, z).
    pub fn set_piston_axis(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPistonAxis(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Old form of little use: sets the axis, and the vector from body 1 to its anchor to the position of
    /// body 1 relative to body 2 (to the world) minus (ax, ay, az). Use dJointSetPistonAnchorOffset.
    ///
    /// C: `dJointSetPistonAxisDelta`; `xyz` is (x, y, z); `delta` is (ax, ay, az).
    pub fn set_piston_axis_delta(&mut self, xyz: Vec3, delta: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetPistonAxisDelta(self.raw(), xyz[0], xyz[1], xyz[2], delta[0], delta[1], delta[2]) })
    }

    /// Set a parameter of a limit and motor to value: of the slide by the plain names,
    /// of the turn by those that end in 2.
    ///
    /// C: `dJointSetPistonParam`.
    pub fn set_piston_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetPistonParam(self.raw(), parameter.number(), value) })
    }

    /// Apply a force (N) along the axis to body 1 and the opposite to body 2, for the next step: on each of
    /// two bodies at its anchor, on one body at its centre.
    ///
    /// C: `dJointAddPistonForce`.
    pub fn add_piston_force(&mut self, force: Real) -> Result<()> {
        call(|| unsafe { sys::dJointAddPistonForce(self.raw(), force) })
    }

    /// Set the point of body 1, world frame.
    ///
    /// The present distance becomes the one to keep, as when the joint is attached.
    ///
    /// C: `dJointSetDBallAnchor1`; `xyz` is (x, y, z).
    pub fn set_dball_anchor1(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetDBallAnchor1(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the point of body 2, world frame.
    ///
    /// The present distance becomes the one to keep, as when the joint is attached.
    ///
    /// C: `dJointSetDBallAnchor2`; `xyz` is (x, y, z).
    pub fn set_dball_anchor2(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetDBallAnchor2(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the distance to keep, m; a negative one is refused.
    ///
    /// C: `dJointSetDBallDistance`.
    pub fn set_dball_distance(&mut self, distance: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetDBallDistance(self.raw(), distance) })
    }

    /// Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
    /// the world.
    ///
    /// C: `dJointSetDBallParam`.
    pub fn set_dball_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetDBallParam(self.raw(), parameter.number(), value) })
    }

    /// The common axis. Needs a body; before it is called the joint keeps no axis.
    ///
    /// C: `dJointSetDHingeAxis`; `xyz` is (x, y, z).
    pub fn set_dhinge_axis(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetDHingeAxis(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the point of body 1, world frame.
    ///
    /// The present distance becomes the one to keep, as when the joint is attached.
    ///
    /// C: `dJointSetDHingeAnchor1`; `xyz` is (x, y, z).
    pub fn set_dhinge_anchor1(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetDHingeAnchor1(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the point of body 2, world frame.
    ///
    /// The present distance becomes the one to keep, as when the joint is attached.
    ///
    /// C: `dJointSetDHingeAnchor2`; `xyz` is (x, y, z).
    pub fn set_dhinge_anchor2(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetDHingeAnchor2(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
    /// the world.
    ///
    /// C: `dJointSetDHingeParam`.
    pub fn set_dhinge_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetDHingeParam(self.raw(), parameter.number(), value) })
    }

    /// Set what kind of wheels the joint couples: mode is dTransmissionParallelAxes
    /// (default), dTransmissionIntersectingAxes or dTransmissionChainDrive; another one is refused.
    ///
    /// C: `dJointSetTransmissionMode`.
    pub fn set_transmission_mode(&mut self, mode: TransmissionMode) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionMode(self.raw(), mode.number()) })
    }

    /// Set the centre of wheel 1; at first the centre of body 1.
    ///
    /// C: `dJointSetTransmissionAnchor1`; `xyz` is (x, y, z).
    pub fn set_transmission_anchor1(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionAnchor1(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the centre of wheel 2; at first the centre of body 2.
    ///
    /// C: `dJointSetTransmissionAnchor2`; `xyz` is (x, y, z).
    pub fn set_transmission_anchor2(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionAnchor2(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the axis of both wheels; refused with intersecting axes. Default: x of
    /// each body.
    ///
    /// C: `dJointSetTransmissionAxis`; `xyz` is (x, y, z).
    pub fn set_transmission_axis(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionAxis(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the axis of wheel 1; allowed with intersecting axes only.
    ///
    /// C: `dJointSetTransmissionAxis1`; `xyz` is (x, y, z).
    pub fn set_transmission_axis1(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionAxis1(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the axis of wheel 2; allowed with intersecting axes only.
    ///
    /// C: `dJointSetTransmissionAxis2`; `xyz` is (x, y, z).
    pub fn set_transmission_axis2(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionAxis2(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the ratio radius 1 / radius 2, positive; allowed with parallel axes
    /// only. Default 1.
    ///
    /// C: `dJointSetTransmissionRatio`.
    pub fn set_transmission_ratio(&mut self, ratio: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionRatio(self.raw(), ratio) })
    }

    /// Set the radius of wheel 1, m, positive; allowed for a chain only.
    ///
    /// Without radii a chain does nothing; in the other modes they follow from the geometry.
    ///
    /// C: `dJointSetTransmissionRadius1`.
    pub fn set_transmission_radius1(&mut self, radius: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionRadius1(self.raw(), radius) })
    }

    /// Set the radius of wheel 2, m, positive; allowed for a chain only.
    ///
    /// Without radii a chain does nothing; in the other modes they follow from the geometry.
    ///
    /// C: `dJointSetTransmissionRadius2`.
    pub fn set_transmission_radius2(&mut self, radius: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionRadius2(self.raw(), radius) })
    }

    /// Set the backlash: the free play of the rims to either side of zero slip,
    /// m; default 0. A negative one is refused.
    ///
    /// C: `dJointSetTransmissionBacklash`.
    pub fn set_transmission_backlash(&mut self, backlash: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionBacklash(self.raw(), backlash) })
    }

    /// Set a parameter of the joint to value: dParamERP or dParamCFM, at first
    /// those of the world.
    ///
    /// C: `dJointSetTransmissionParam`.
    pub fn set_transmission_param(&mut self, parameter: Param, value: Real) -> Result<()> {
        call(|| unsafe { sys::dJointSetTransmissionParam(self.raw(), parameter.number(), value) })
    }
}
