// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Models of robots: what a file says, as data, and what a controller computes of it.
use crate::contact::list;
use crate::error::{start, with_notes, Error};
use crate::prelude::*;
use std::ffi::{c_char, CStr, CString};
use std::path::Path;

/// What a file of URDF, MJCF or SDF says: robots of worlds are made of it, as many as wanted ([`World::add_robot`]).
pub struct RobotModel {
    pub(crate) raw: sys::dRobotModelID,
}

// A model is plain data; what robots of it share is guarded by the library.
unsafe impl Send for RobotModel {}

/// A link of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct RobotLink {
    /// As in the file.
    pub name: String,
    /// The number of its parent; link 0 is the world.
    pub parent: Option<usize>,
    /// kg.
    pub mass: Real,
}

/// What a joint of a model leaves free.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RobotJointKind {
    /// An angle about the axis.
    Hinge,
    /// A distance along the axis.
    Slide,
    /// A turn about the anchor: a quaternion.
    Ball,
    /// Everything: a position and a quaternion.
    Free,
}

/// A joint of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct RobotJoint {
    /// As in the file.
    pub name: String,
    /// What it leaves free.
    pub kind: RobotJointKind,
    /// The link that it moves.
    pub link: usize,
    /// The number of its first coordinate among all.
    pub position: usize,
    /// Lower and upper limit of its coordinate, infinite for none.
    pub limits: [Real; 2],
}

fn c_text(text: &str) -> Result<CString> {
    CString::new(text).map_err(|_| Error::refused("a text has no zero bytes"))
}
/// A text that lives as long as a model.
unsafe fn text_of(text: *const c_char) -> String {
    if text.is_null() {
        return String::new();
    }
    CStr::from_ptr(text).to_string_lossy().into_owned()
}
/// Numbers of which the library says how many there are.
pub(crate) fn numbers(fill: impl Fn(*mut Real, i32) -> i32) -> Result<Vec<Real>> {
    let count = call(|| fill(std::ptr::null_mut(), 0))?;
    let mut all = vec![0.0; count.max(0) as usize];
    call(|| fill(all.as_mut_ptr(), count))?;
    Ok(all)
}
fn of_number(number: i32) -> Option<usize> {
    usize::try_from(number).ok()
}
pub(crate) fn to_number(number: usize) -> Result<i32> {
    i32::try_from(number).or_else(|_| World::refuse("no such number"))
}

impl RobotModel {
    /// Reads a file. A model with errors is refused; the text names the first. C: `dRobotModelLoad`.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        start();
        let path = c_text(&path.as_ref().to_string_lossy())?;
        Self::made(|| unsafe { sys::dRobotModelLoad(path.as_ptr(), std::ptr::null()) })
    }
    /// Reads a text as if it were the file `path`, in whose folder meshes are looked for. C: `dRobotModelLoadText`.
    pub fn from_text(path: &str, text: &str) -> Result<Self> {
        start();
        let path = c_text(path)?;
        let (pointer, size) = (text.as_ptr().cast(), text.len());
        Self::made(|| unsafe { sys::dRobotModelLoadText(path.as_ptr(), pointer, size, std::ptr::null()) })
    }
    fn made(load: impl FnOnce() -> sys::dRobotModelID) -> Result<Self> {
        let (raw, notes) = with_notes(load);
        let model = (!raw.is_null()).then_some(Self { raw });
        match model {
            Some(model) if sure(|| unsafe { sys::dRobotModelHasErrors(raw) }) == 0 => Ok(model),
            _ => Err(Error::refused(notes.join("; "))),
        }
    }
    /// What was read as something else, ignored or wrong, a line each. C: `dRobotModelGetReport`.
    pub fn report(&self) -> Vec<String> {
        let lines = list(|to, capacity| unsafe { sys::dRobotModelGetReport(self.raw, to, capacity) });
        let words = ["changed", "approximated", "ignored", "error"];
        let line = |l: &sys::dRobotReportLine| unsafe {
            let word = words.get(l.note as usize).unwrap_or(&"note");
            format!("{word}: {}:{}: {}", text_of(l.file), l.line, text_of(l.text))
        };
        lines.iter().map(line).collect()
    }
    /// All links; link 0 is the world. C: `dRobotModelGetLinks`.
    pub fn links(&self) -> Vec<RobotLink> {
        let links = list(|to, capacity| unsafe { sys::dRobotModelGetLinks(self.raw, to, capacity) });
        let link = |l: &sys::dRobotLink| RobotLink { name: unsafe { text_of(l.name) }, parent: of_number(l.parent), mass: l.mass };
        links.iter().map(link).collect()
    }
    /// All joints. C: `dRobotModelGetJoints`.
    pub fn joints(&self) -> Vec<RobotJoint> {
        let joints = list(|to, capacity| unsafe { sys::dRobotModelGetJoints(self.raw, to, capacity) });
        let kind = |kind: i32| match kind as u32 {
            sys::dRobotSlide => RobotJointKind::Slide,
            sys::dRobotBall => RobotJointKind::Ball,
            sys::dRobotFree => RobotJointKind::Free,
            _ => RobotJointKind::Hinge,
        };
        let joint = |j: &sys::dRobotJoint| RobotJoint {
            name: unsafe { text_of(j.name) },
            kind: kind(j.kind),
            link: j.link.max(0) as usize,
            position: j.position.max(0) as usize,
            limits: [j.low, j.high],
        };
        joints.iter().map(joint).collect()
    }
    /// How many coordinates its joints have.
    pub fn num_positions(&self) -> usize {
        sure(|| unsafe { sys::dRobotModelGetNumPositions(self.raw) }) as usize
    }
    /// How many velocities its joints have.
    pub fn num_velocities(&self) -> usize {
        sure(|| unsafe { sys::dRobotModelGetNumVelocities(self.raw) }) as usize
    }
    /// How many actuators it has.
    pub fn num_actuators(&self) -> usize {
        sure(|| unsafe { sys::dRobotModelGetNumActuators(self.raw) }) as usize
    }
    /// The number of the link of that name.
    pub fn find_link(&self, name: &str) -> Option<usize> {
        let name = c_text(name).ok()?;
        of_number(sure(|| unsafe { sys::dRobotModelFindLink(self.raw, name.as_ptr()) }))
    }
    /// The number of the joint of that name.
    pub fn find_joint(&self, name: &str) -> Option<usize> {
        let name = c_text(name).ok()?;
        of_number(sure(|| unsafe { sys::dRobotModelFindJoint(self.raw, name.as_ptr()) }))
    }
    /// The number of the actuator of that name.
    pub fn find_actuator(&self, name: &str) -> Option<usize> {
        let name = c_text(name).ok()?;
        of_number(sure(|| unsafe { sys::dRobotModelFindActuator(self.raw, name.as_ptr()) }))
    }
    /// The coordinates of the pose in which the file describes it.
    pub fn reference(&self) -> Result<Vec<Real>> {
        numbers(|to, capacity| unsafe { sys::dRobotModelGetReference(self.raw, to, capacity) })
    }
    /// Positions and quaternions of all links in the model's world, 7 numbers each. C: `dRobotModelGetPoses`.
    pub fn poses(&self, positions: &[Real]) -> Result<Vec<[Real; 7]>> {
        let count = to_number(positions.len())?;
        let poses = |to: *mut Real, capacity| unsafe { sys::dRobotModelGetPoses(self.raw, positions.as_ptr(), count, to, capacity) };
        let links = call(|| poses(std::ptr::null_mut(), 0))?;
        let mut all = vec![[0.0; 7]; links.max(0) as usize];
        call(|| poses(all.as_mut_ptr().cast(), links))?;
        Ok(all)
    }
    /// The mass matrix, row by row. C: `dRobotModelGetMassMatrix`.
    pub fn mass_matrix(&self, positions: &[Real]) -> Result<Vec<Real>> {
        self.wants(positions, self.num_positions())?;
        numbers(|to, capacity| unsafe { sys::dRobotModelGetMassMatrix(self.raw, positions.as_ptr(), to, capacity) })
    }
    /// The Jacobian of a link's origin: six rows, linear then angular. C: `dRobotModelGetJacobian`.
    pub fn jacobian(&self, positions: &[Real], link: usize) -> Result<Vec<Real>> {
        self.wants(positions, self.num_positions())?;
        let link = to_number(link)?;
        let origin = std::ptr::null();
        numbers(|to, capacity| unsafe { sys::dRobotModelGetJacobian(self.raw, positions.as_ptr(), link, origin, to, capacity) })
    }
    /// The forces that give the accelerations at these velocities, against gravity. C: `dRobotModelGetInverseDynamics`.
    pub fn inverse_dynamics(&self, positions: &[Real], velocities: &[Real], accelerations: &[Real]) -> Result<Vec<Real>> {
        self.wants(positions, self.num_positions())?;
        self.wants(velocities, self.num_velocities())?;
        self.wants(accelerations, self.num_velocities())?;
        let (q, v, a) = (positions.as_ptr(), velocities.as_ptr(), accelerations.as_ptr());
        numbers(|to, capacity| unsafe { sys::dRobotModelGetInverseDynamics(self.raw, q, v, a, to, capacity) })
    }
    // C reads as many numbers as the model has.
    fn wants(&self, numbers: &[Real], count: usize) -> Result<()> {
        if numbers.len() == count {
            return Ok(());
        }
        World::refuse(&format!("{count} numbers are wanted, not {}", numbers.len()))
    }
}

impl Drop for RobotModel {
    fn drop(&mut self) {
        let _ = call(|| unsafe { sys::dRobotModelDestroy(self.raw) });
    }
}
