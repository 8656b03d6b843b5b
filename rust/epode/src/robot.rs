// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots from files (libepode_robots). A robot's bodies, joints and geoms are in the world's tables like others, but may be removed
// only together: the library's robot names them by handles of its own. A roll-back to before a robot ends it.
use crate::error::{done, made, Error, ErrorKind};
use crate::prelude::*;
use crate::robot_model::{numbers, to_number, RobotModel};
use crate::state::{raw_bodies, raw_geoms, raw_joints};

/// Names a robot of a [`World`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RobotId {
    world: u32,
    number: u32,
}

pub(crate) struct Members {
    raw: sys::dRobotID,
    number: u32,
    pub bodies: Vec<BodyId>,
    pub joints: Vec<JointId>,
    pub geoms: Vec<GeomId>,
}

/// A robot of a world, for reading.
#[derive(Clone, Copy)]
pub struct Robot<'w> {
    raw: sys::dRobotID,
    world: &'w World,
}

/// A robot of a world, for changing it; it reads as [`Robot`] does.
pub struct RobotMut<'w> {
    robot: Robot<'w>,
    _alone: std::marker::PhantomData<&'w mut World>,
}

impl<'w> std::ops::Deref for RobotMut<'w> {
    type Target = Robot<'w>;
    fn deref(&self) -> &Robot<'w> {
        &self.robot
    }
}

impl World {
    /// Adds a robot of the model, placed at `position` with `quaternion`, in the pose of the file. C: `dRobotCreate`.
    pub fn add_robot(&mut self, model: &RobotModel, position: Vec3, quaternion: Quat) -> Result<RobotId> {
        let raw = made(|| unsafe { sys::dRobotCreate(self.raw(), self.space(), model.raw, position.as_ptr(), quaternion.as_ptr()) })?;
        let shared = self.shared();
        let number = shared.robots_made.get();
        shared.robots_made.set(number + 1);
        let mut owned = Members { raw, number, bodies: Vec::new(), joints: Vec::new(), geoms: Vec::new() };
        // Whatever is in the world now and was not known before is the robot's.
        let bodies = raw_bodies(self.raw());
        for &body in bodies.iter().filter(|&&body| shared.body_of(body).is_none()) {
            shared.bodies.borrow_mut().insert(body as usize, Default::default());
            owned.bodies.extend(shared.body_of(body));
        }
        for joint in raw_joints(self.raw()).into_iter().filter(|&joint| shared.joint_of(joint).is_none()) {
            shared.joints.borrow_mut().insert(joint as usize, Default::default());
            owned.joints.extend(shared.joint_of(joint));
        }
        for geom in raw_geoms(self.space(), &bodies).into_iter().filter(|&geom| shared.geom_of(geom).is_none()) {
            shared.geoms.borrow_mut().insert(geom as usize, Default::default());
            owned.geoms.extend(shared.geom_of(geom));
        }
        shared.robots.borrow_mut().push(owned);
        Ok(RobotId { world: shared.id, number })
    }

    /// Removes a robot with its bodies, joints and geoms. C: `dRobotDestroy`.
    pub fn remove_robot(&mut self, id: RobotId) -> Result<()> {
        self.raw_robot(id)?;
        let shared = self.shared();
        let at = shared.robots.borrow().iter().position(|robot| robot.number == id.number);
        let Some(at) = at else { return Self::refuse("the robot has been removed") };
        let robot = shared.robots.borrow_mut().remove(at);
        call(|| unsafe { sys::dRobotDestroy(robot.raw) })?;
        let keep = shared.keep();
        robot.bodies.iter().for_each(|body| shared.bodies.borrow_mut().remove(body.index, keep));
        robot.joints.iter().for_each(|joint| shared.joints.borrow_mut().remove(joint.index, keep));
        robot.geoms.iter().for_each(|geom| shared.geoms.borrow_mut().remove(geom.index, keep));
        Ok(())
    }

    /// A view of a robot, for reading.
    pub fn robot(&self, id: RobotId) -> Result<Robot<'_>> {
        Ok(Robot { raw: self.raw_robot(id)?, world: self })
    }
    /// A view of a robot, for changing it.
    pub fn robot_mut(&mut self, id: RobotId) -> Result<RobotMut<'_>> {
        let robot = Robot { raw: self.raw_robot(id)?, world: self };
        Ok(RobotMut { robot, _alone: std::marker::PhantomData })
    }
    fn raw_robot(&self, id: RobotId) -> Result<sys::dRobotID> {
        if id.world != self.shared().id {
            return Err(Error::new(ErrorKind::OtherWorld, "the robot belongs to another world"));
        }
        let robots = self.shared().robots.borrow();
        let found = robots.iter().find(|robot| robot.number == id.number);
        found.map(|robot| robot.raw).ok_or_else(|| Error::new(ErrorKind::Removed, "the robot has been removed"))
    }
}

impl Shared {
    /// After a roll-back: robots of which something is gone are gone.
    pub fn end_broken_robots(&self) {
        let whole = |robot: &Members| {
            robot.bodies.iter().all(|&id| self.body(id).is_ok())
                && robot.joints.iter().all(|&id| self.joint(id).is_ok())
                && robot.geoms.iter().all(|&id| self.geom(id).is_ok())
        };
        let (kept, broken) = self.robots.take().into_iter().partition(whole);
        self.robots.replace(kept);
        self.end_robots(broken);
    }
    /// Their handles of what is gone are refused by the library, which is what is wanted here.
    pub fn end_robots(&self, robots: Vec<Members>) {
        for robot in robots {
            let _ = call(|| unsafe { sys::dRobotDestroy(robot.raw) });
        }
    }
}

impl Robot<'_> {
    /// The body of a link of the model. C: `dRobotGetBody`.
    pub fn body(&self, link: usize) -> Result<Option<BodyId>> {
        let link = to_number(link)?;
        Ok(self.world.shared().body_of(call(|| unsafe { sys::dRobotGetBody(self.raw, link) })?))
    }
    /// The joint of a joint of the model, whose axis 0 it is. C: `dRobotGetJoint`.
    pub fn joint(&self, joint: usize) -> Result<Option<JointId>> {
        let joint = to_number(joint)?;
        Ok(self.world.shared().joint_of(call(|| unsafe { sys::dRobotGetJoint(self.raw, joint) })?))
    }
    /// The coordinates of its joints. C: `dRobotGetPositions`.
    pub fn positions(&self) -> Result<Vec<Real>> {
        numbers(|to, capacity| unsafe { sys::dRobotGetPositions(self.raw, to, capacity) })
    }
    /// The velocities of its joints. C: `dRobotGetVelocities`.
    pub fn velocities(&self) -> Result<Vec<Real>> {
        numbers(|to, capacity| unsafe { sys::dRobotGetVelocities(self.raw, to, capacity) })
    }
    /// The control of an actuator. C: `dRobotGetControl`.
    pub fn control(&self, actuator: usize) -> Result<Real> {
        let actuator = to_number(actuator)?;
        call(|| unsafe { sys::dRobotGetControl(self.raw, actuator) })
    }
    /// What it has in addition to its world's state: controls, activations, targets. C: `dRobotGetState`.
    pub fn state(&self) -> Result<Vec<Real>> {
        numbers(|to, capacity| unsafe { sys::dRobotGetState(self.raw, to, capacity) })
    }
}

impl RobotMut<'_> {
    /// Moves it to where the coordinates put it, at rest. C: `dRobotSetPositions`.
    pub fn set_positions(&mut self, positions: &[Real]) -> Result<()> {
        let count = to_number(positions.len())?;
        done(|| unsafe { sys::dRobotSetPositions(self.raw, positions.as_ptr(), count) })
    }
    /// Gives its joints velocities. C: `dRobotSetVelocities`.
    pub fn set_velocities(&mut self, velocities: &[Real]) -> Result<()> {
        let count = to_number(velocities.len())?;
        done(|| unsafe { sys::dRobotSetVelocities(self.raw, velocities.as_ptr(), count) })
    }
    /// Sets the control of an actuator, clamped to its range. C: `dRobotSetControl`.
    pub fn set_control(&mut self, actuator: usize, control: Real) -> Result<()> {
        let actuator = to_number(actuator)?;
        done(|| unsafe { sys::dRobotSetControl(self.raw, actuator, control) })
    }
    /// Lets a hinge or slider be pulled to a target by a spring and a damper; both 0: no longer. C: `dRobotSetTarget`.
    pub fn set_target(&mut self, joint: usize, target: Real, stiffness: Real, damping: Real) -> Result<()> {
        let joint = to_number(joint)?;
        done(|| unsafe { sys::dRobotSetTarget(self.raw, joint, target, stiffness, damping) })
    }
    /// Adds what acts from step to step (filters of actuators, spatial tendons, a medium): call it before each step, with its size.
    /// C: `dRobotAddForces`.
    pub fn add_forces(&mut self, stepsize: Real) -> Result<()> {
        call(|| unsafe { sys::dRobotAddForces(self.raw, stepsize) }).map(drop)
    }
    /// Sets what [`Robot::state`] has returned, of this robot or another one of its model. C: `dRobotSetState`.
    pub fn set_state(&mut self, state: &[Real]) -> Result<()> {
        let count = to_number(state.len())?;
        done(|| unsafe { sys::dRobotSetState(self.raw, state.as_ptr(), count) })
    }
}
