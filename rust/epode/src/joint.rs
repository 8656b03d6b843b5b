// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints: how they are made, and what is not written from the headers.
use crate::error::{made, Error};
use crate::owned::Owned;
use crate::prelude::*;
use std::cell::UnsafeCell;
use std::marker::PhantomData;
use std::ops::Deref;

/// A joint of a world, for reading. Methods of another type of joint than it is return an error.
#[derive(Clone, Copy)]
pub struct Joint<'w> {
    raw: sys::dJointID,
    id: JointId,
    world: &'w World,
}

/// A joint of a world, for changing it; it reads as [`Joint`] does.
pub struct JointMut<'w> {
    joint: Joint<'w>,
    _alone: PhantomData<&'w mut World>,
}

impl<'w> Deref for JointMut<'w> {
    type Target = Joint<'w>;
    fn deref(&self) -> &Joint<'w> {
        &self.joint
    }
}

impl<'w> Joint<'w> {
    pub(crate) fn new(raw: sys::dJointID, id: JointId, world: &'w World) -> Self {
        Self { raw, id, world }
    }
    pub(crate) fn raw(&self) -> sys::dJointID {
        self.raw
    }
    pub(crate) fn shared(&self) -> &'w Shared {
        self.world.shared()
    }
    /// Its handle.
    pub fn id(&self) -> JointId {
        self.id
    }
    /// The number that the program has given to it, 0 at first.
    pub fn tag(&self) -> u64 {
        self.shared().joints.borrow().data(self.id.index).tag
    }
    /// Its type. C: `dJointGetType`.
    pub fn kind(&self) -> JointKind {
        JointKind::of_number(sure(|| unsafe { sys::dJointGetType(self.raw) }) as i32)
    }
    /// The two bodies that it is attached to; `None` is the world. C: `dJointGetBody`.
    pub fn bodies(&self) -> [Option<BodyId>; 2] {
        [0, 1].map(|i| self.shared().body_of(sure(|| unsafe { sys::dJointGetBody(self.raw, i) })))
    }
    /// What it did in the last step, if it keeps that ([`JointMut::keep_feedback`]).
    pub fn feedback(&self) -> Option<Feedback> {
        let joints = self.shared().joints.borrow();
        // The library writes to it in steps alone, and the world is not stepped while a view of it exists.
        let feedback = joints.data(self.id.index).feedback.as_ref()?;
        Some(Feedback::from_raw(&unsafe { *feedback.get() }, self.shared()))
    }
    /// The joint in a place of a coupling. C: `dJointGetCouplingJoint`.
    pub fn coupling_joint(&self, place: i32) -> Result<Option<JointId>> {
        Ok(self.shared().joint_of(call(|| unsafe { sys::dJointGetCouplingJoint(self.raw, place) })?))
    }
}

impl<'w> JointMut<'w> {
    pub(crate) fn new(raw: sys::dJointID, id: JointId, world: &'w mut World) -> Self {
        Self { joint: Joint::new(raw, id, world), _alone: PhantomData }
    }
    /// Gives it a number of the program's.
    pub fn set_tag(&mut self, tag: u64) {
        self.shared().joints.borrow_mut().data_mut(self.id.index).tag = tag;
    }
    /// Attaches it to two bodies of its world; `None` is the world. C: `dJointAttach`.
    pub fn attach(&mut self, first: Option<BodyId>, second: Option<BodyId>) -> Result<()> {
        let raw = |body: Option<BodyId>| body.map_or(Ok(std::ptr::null_mut()), |id| self.shared().body(id));
        let (first, second) = (raw(first)?, raw(second)?);
        call(|| unsafe { sys::dJointAttach(self.raw, first, second) })
    }
    /// Sets both axes of a hinge-2. C: `dJointSetHinge2Axes`.
    pub fn set_hinge2_axes(&mut self, axis1: Vec3, axis2: Vec3) -> Result<()> {
        let (axis1, axis2) = (pad3(axis1), pad3(axis2));
        call(|| unsafe { sys::dJointSetHinge2Axes(self.raw, axis1.as_ptr(), axis2.as_ptr()) })
    }
    /// Lets the position of an axis of another joint count in a coupling, times a factor; `None` empties the place.
    /// C: `dJointSetCouplingAxis`.
    pub fn set_coupling_axis(&mut self, place: i32, joint: Option<JointId>, axis: i32, factor: Real) -> Result<()> {
        let joint = joint.map_or(Ok(std::ptr::null_mut()), |id| self.shared().joint(id))?;
        call(|| unsafe { sys::dJointSetCouplingAxis(self.raw, place, joint, axis, factor) })?;
        Ok(())
    }
    /// Chooses whether steps write down what it does ([`Joint::feedback`]). C: `dJointSetFeedback`.
    pub fn keep_feedback(&mut self, on: bool) -> Result<()> {
        let kept = on.then(|| Owned::new(UnsafeCell::new(Feedback::empty())));
        let pointer = kept.as_ref().map_or(std::ptr::null_mut(), |feedback| feedback.get());
        call(|| unsafe { sys::dJointSetFeedback(self.raw, pointer) })?;
        self.shared().joints.borrow_mut().data_mut(self.id.index).feedback = kept;
        Ok(())
    }
    /// Sets a parameter, whatever type of joint it is. C: `dJointSetHingeParam` and its sisters.
    pub fn set_param(&mut self, param: Param, value: Real) -> Result<()> {
        match self.kind() {
            JointKind::Ball => self.set_ball_param(param, value),
            JointKind::Hinge => self.set_hinge_param(param, value),
            JointKind::Slider => self.set_slider_param(param, value),
            JointKind::Universal => self.set_universal_param(param, value),
            JointKind::Hinge2 => self.set_hinge2_param(param, value),
            JointKind::Fixed => self.set_fixed_param(param, value),
            JointKind::AMotor => self.set_amotor_param(param, value),
            JointKind::LMotor => self.set_lmotor_param(param, value),
            JointKind::PR => self.set_pr_param(param, value),
            JointKind::PU => self.set_pu_param(param, value),
            JointKind::Piston => self.set_piston_param(param, value),
            JointKind::DBall => self.set_dball_param(param, value),
            JointKind::DHinge => self.set_dhinge_param(param, value),
            JointKind::Transmission => self.set_transmission_param(param, value),
            JointKind::Coupling => self.set_coupling_param(param, value),
            kind => Err(Error::refused(format!("a joint of type {kind:?} has no parameters"))),
        }
    }
}

/// How a joint begins: its type, its bodies, and where it is in the world. What a type does not have is refused.
#[derive(Clone, Debug)]
pub struct JointDef {
    kind: JointKind,
    bodies: [Option<BodyId>; 2],
    anchor: Option<Vec3>,
    anchor2: Option<Vec3>,
    axes: [Option<Vec3>; 3],
    params: Vec<(Param, Real)>,
    feedback: bool,
    tag: u64,
}

impl JointDef {
    /// A joint of a type between two bodies; `None` is the world.
    pub fn new(kind: JointKind, first: impl Into<Option<BodyId>>, second: impl Into<Option<BodyId>>) -> Self {
        let bodies = [first.into(), second.into()];
        Self { kind, bodies, anchor: None, anchor2: None, axes: [None; 3], params: Vec::new(), feedback: false, tag: 0 }
    }
    /// Holds a point of each body together.
    pub fn ball(first: impl Into<Option<BodyId>>, second: impl Into<Option<BodyId>>) -> Self {
        Self::new(JointKind::Ball, first, second)
    }
    /// Lets them turn about an axis.
    pub fn hinge(first: impl Into<Option<BodyId>>, second: impl Into<Option<BodyId>>) -> Self {
        Self::new(JointKind::Hinge, first, second)
    }
    /// Lets them move along an axis.
    pub fn slider(first: impl Into<Option<BodyId>>, second: impl Into<Option<BodyId>>) -> Self {
        Self::new(JointKind::Slider, first, second)
    }
    /// Holds them as they are.
    pub fn fixed(first: impl Into<Option<BodyId>>, second: impl Into<Option<BodyId>>) -> Self {
        Self::new(JointKind::Fixed, first, second)
    }
    /// A universal joint; give it two axes.
    pub fn universal(first: impl Into<Option<BodyId>>, second: impl Into<Option<BodyId>>) -> Self {
        Self::new(JointKind::Universal, first, second)
    }
    /// The anchor, in the world, m.
    pub fn anchor(mut self, anchor: Vec3) -> Self {
        self.anchor = Some(anchor);
        self
    }
    /// The second anchor of a double ball, double hinge or transmission.
    pub fn anchor2(mut self, anchor: Vec3) -> Self {
        self.anchor2 = Some(anchor);
        self
    }
    /// The (first) axis, in the world.
    pub fn axis(mut self, axis: Vec3) -> Self {
        self.axes[0] = Some(axis);
        self
    }
    /// The second axis.
    pub fn axis2(mut self, axis: Vec3) -> Self {
        self.axes[1] = Some(axis);
        self
    }
    /// The third axis, of a PU joint.
    pub fn axis3(mut self, axis: Vec3) -> Self {
        self.axes[2] = Some(axis);
        self
    }
    /// The range of the first axis, rad or m.
    pub fn limits(self, low: Real, high: Real) -> Self {
        // A stop is tested where low <= high: the upper one is set first and last, whichever way they move.
        self.param(Param::HI_STOP, high).param(Param::LO_STOP, low).param(Param::HI_STOP, high)
    }
    /// A motor of the first axis: its rate, rad/s or m/s, and the most force or torque that it may use, N or N m.
    pub fn motor(self, rate: Real, max_force: Real) -> Self {
        self.param(Param::VEL, rate).param(Param::FMAX, max_force)
    }
    /// A parameter.
    pub fn param(mut self, param: Param, value: Real) -> Self {
        self.params.push((param, value));
        self
    }
    /// Steps write down what it does ([`Joint::feedback`]).
    pub fn feedback(mut self) -> Self {
        self.feedback = true;
        self
    }
    /// A number of the program's.
    pub fn tag(mut self, tag: u64) -> Self {
        self.tag = tag;
        self
    }

    fn place(&self, joint: &mut JointMut<'_>) -> Result<()> {
        let surplus = |what: &str| Err(Error::refused(format!("a joint of type {:?} has no {what}", self.kind)));
        let mut anchors = [self.anchor, self.anchor2];
        let mut axes = self.axes;
        use JointKind as K;
        if let (K::Hinge2, [Some(one), Some(two), _]) = (self.kind, axes) {
            joint.set_hinge2_axes(one, two)?;
            axes = [None; 3];
        }
        for (number, axis) in axes.iter_mut().enumerate().filter_map(|(i, axis)| Some((i, axis.take()?))) {
            match (self.kind, number) {
                (K::Hinge, 0) => joint.set_hinge_axis(axis)?,
                (K::Slider, 0) => joint.set_slider_axis(axis)?,
                (K::Piston, 0) => joint.set_piston_axis(axis)?,
                (K::DHinge, 0) => joint.set_dhinge_axis(axis)?,
                (K::Universal, 0) => joint.set_universal_axis1(axis)?,
                (K::Universal, 1) => joint.set_universal_axis2(axis)?,
                (K::PR, 0) => joint.set_pr_axis1(axis)?,
                (K::PR, 1) => joint.set_pr_axis2(axis)?,
                (K::PU, 0) => joint.set_pu_axis1(axis)?,
                (K::PU, 1) => joint.set_pu_axis2(axis)?,
                (K::PU, 2) => joint.set_pu_axis3(axis)?,
                (K::Transmission, 0) => joint.set_transmission_axis(axis)?,
                _ => return surplus("such axis"),
            }
        }
        for (number, anchor) in anchors.iter_mut().enumerate().filter_map(|(i, anchor)| Some((i, anchor.take()?))) {
            match (self.kind, number) {
                (K::Ball, 0) => joint.set_ball_anchor(anchor)?,
                (K::Hinge, 0) => joint.set_hinge_anchor(anchor)?,
                (K::Universal, 0) => joint.set_universal_anchor(anchor)?,
                (K::Hinge2, 0) => joint.set_hinge2_anchor(anchor)?,
                (K::PR, 0) => joint.set_pr_anchor(anchor)?,
                (K::PU, 0) => joint.set_pu_anchor(anchor)?,
                (K::Piston, 0) => joint.set_piston_anchor(anchor)?,
                (K::DBall, 0) => joint.set_dball_anchor1(anchor)?,
                (K::DBall, 1) => joint.set_dball_anchor2(anchor)?,
                (K::DHinge, 0) => joint.set_dhinge_anchor1(anchor)?,
                (K::DHinge, 1) => joint.set_dhinge_anchor2(anchor)?,
                (K::Transmission, 0) => joint.set_transmission_anchor1(anchor)?,
                (K::Transmission, 1) => joint.set_transmission_anchor2(anchor)?,
                _ => return surplus("such anchor"),
            }
        }
        Ok(())
    }
}

impl World {
    /// Adds a joint. If anything of it is refused, nothing is added.
    pub fn add_joint(&mut self, def: &JointDef) -> Result<JointId> {
        let create = match def.kind {
            JointKind::Ball => sys::dJointCreateBall,
            JointKind::Hinge => sys::dJointCreateHinge,
            JointKind::Slider => sys::dJointCreateSlider,
            JointKind::Universal => sys::dJointCreateUniversal,
            JointKind::Hinge2 => sys::dJointCreateHinge2,
            JointKind::Fixed => sys::dJointCreateFixed,
            JointKind::Null => sys::dJointCreateNull,
            JointKind::AMotor => sys::dJointCreateAMotor,
            JointKind::LMotor => sys::dJointCreateLMotor,
            JointKind::Plane2D => sys::dJointCreatePlane2D,
            JointKind::PR => sys::dJointCreatePR,
            JointKind::PU => sys::dJointCreatePU,
            JointKind::Piston => sys::dJointCreatePiston,
            JointKind::DBall => sys::dJointCreateDBall,
            JointKind::DHinge => sys::dJointCreateDHinge,
            JointKind::Transmission => sys::dJointCreateTransmission,
            JointKind::Coupling => sys::dJointCreateCoupling,
            JointKind::None | JointKind::Contact => return Self::refuse("joints of this type are made by the library alone"),
        };
        let raw = made(|| unsafe { create(self.raw(), std::ptr::null_mut()) })?;
        let (index, generation) = self.shared().joints.borrow_mut().insert(raw as usize, Default::default());
        let id = JointId { world: self.shared().id, index, generation };
        match self.complete_joint(id, def) {
            Ok(()) => Ok(id),
            Err(error) => {
                self.remove_joint(id)?;
                Err(error)
            }
        }
    }

    fn complete_joint(&mut self, id: JointId, def: &JointDef) -> Result<()> {
        let mut joint = self.joint_mut(id)?;
        joint.set_tag(def.tag);
        if def.kind != JointKind::Coupling {
            joint.attach(def.bodies[0], def.bodies[1])?;
        }
        def.place(&mut joint)?;
        if def.kind == JointKind::Fixed {
            joint.set_fixed()?;
        }
        for &(param, value) in &def.params {
            joint.set_param(param, value)?;
        }
        if def.feedback {
            joint.keep_feedback(true)?;
        }
        Ok(())
    }
}
