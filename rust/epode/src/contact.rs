// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step did: points of contact, which geoms touch, events, causes of failure. The library fills arrays of its own structures;
// what is shown of them reads those structures in place.
use crate::prelude::*;
use std::ffi::c_char;

/// The points of contact of the last step, as the library has written them.
#[derive(Clone)]
pub struct Contacts<'w> {
    raw: Vec<sys::dWorldContact>,
    world: &'w World,
}

/// A point of contact in the last step.
#[derive(Clone, Copy)]
pub struct Contact<'c> {
    raw: &'c sys::dWorldContact,
    world: &'c World,
}

impl Contacts<'_> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.raw.len()
    }
    /// Whether nothing touches.
    pub fn is_empty(&self) -> bool {
        self.raw.is_empty()
    }
    /// One of them.
    pub fn get(&self, index: usize) -> Option<Contact<'_>> {
        self.raw.get(index).map(|raw| Contact { raw, world: self.world })
    }
    /// All of them, in the order of [`World::contact_events`].
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Contact<'_>> {
        self.raw.iter().map(|raw| Contact { raw, world: self.world })
    }
}

impl Contact<'_> {
    /// The two geoms; the first has a body. `None` if they have been removed since the step.
    pub fn geoms(&self) -> Option<[GeomId; 2]> {
        let shared = self.world.shared();
        Some([shared.geom_of(self.raw.g1)?, shared.geom_of(self.raw.g2)?])
    }
    /// Where, in the world, at the step's beginning, m.
    pub fn position(&self) -> Vec3 {
        vec3(self.raw.pos)
    }
    /// Unit, into the first geom.
    pub fn normal(&self) -> Vec3 {
        vec3(self.raw.normal)
    }
    /// At the step's beginning; below 0: the gap that the step has closed, m.
    pub fn depth(&self) -> Real {
        self.raw.depth
    }
    /// Along the normal, the mean over the step, N.
    pub fn normal_force(&self) -> Real {
        self.raw.normal_force
    }
    /// On the first geom, N.
    pub fn friction_force(&self) -> Vec3 {
        vec3(self.raw.friction_force)
    }
}

/// What has happened to a pair of geoms in the last step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ContactEvent {
    /// What.
    pub kind: ContactEventKind,
    /// The two geoms; the first has a body. `None` if they have been removed since the step.
    pub geoms: Option<[GeomId; 2]>,
}

/// What happened in the last step: [`World::events`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// What.
    pub kind: EventKind,
    /// Of contacts the geom that has a body, of sensors the sensor. The handle may be that of a geom that has been removed since
    /// the last step.
    pub geom1: Option<GeomId>,
    /// The other geom.
    pub geom2: Option<GeomId>,
    /// The joint that broke.
    pub joint: Option<JointId>,
    /// Of contacts the centre of the impulses, of breaks the centre of body 1, m.
    pub position: Vec3,
    /// Of contacts unit, into the first geom; of breaks the direction of the force on body 1.
    pub normal: Vec3,
    /// Of contacts, along the normal at the step's beginning, m/s.
    pub approach_speed: Real,
    /// Normal impulse, of a break that of the joint, over the step, N s.
    pub impulse: Real,
}

/// Why a world misbehaves: [`World::diagnose`].
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// Which cause.
    pub kind: DiagnosisKind,
    /// How harmful it is.
    pub severity: Severity,
    /// The body to blame.
    pub body: Option<BodyId>,
    /// The other one.
    pub other: Option<BodyId>,
    /// The joint to blame.
    pub joint: Option<JointId>,
    /// The geom that was met.
    pub geom: Option<GeomId>,
    /// The worst value, in the unit that [`DiagnosisKind`] names.
    pub figure: f64,
    /// What it should stay below.
    pub threshold: f64,
    /// In how many steps it was seen.
    pub steps: i32,
    /// What it means and how to cure it.
    pub text: String,
}

/// An array that the library fills: its length is asked for first.
pub(crate) fn list<T: Copy>(fill: impl Fn(*mut T, i32) -> i32) -> Vec<T> {
    let count = sure(|| fill(std::ptr::null_mut(), 0));
    let mut all = Vec::with_capacity(count as usize);
    let written = sure(|| fill(all.as_mut_ptr(), count));
    // The library has written that many, as it has said before.
    unsafe { all.set_len(written.min(count) as usize) };
    all
}

impl World {
    /// The points of contact of the last step. C: `dWorldGetContacts`.
    pub fn contacts(&self) -> Contacts<'_> {
        let raw = list(|to, capacity| unsafe { sys::dWorldGetContacts(self.raw(), to, capacity) });
        Contacts { raw, world: self }
    }
    /// What happened to pairs of geoms in the last step. C: `dWorldGetContactEvents`.
    pub fn contact_events(&self) -> Vec<ContactEvent> {
        let shared = self.shared();
        let geoms = |e: &sys::dContactEvent| Some([shared.geom_of(e.g1)?, shared.geom_of(e.g2)?]);
        let event = |e: &sys::dContactEvent| ContactEvent { kind: ContactEventKind::of_number(e.kind as i32), geoms: geoms(e) };
        list(|to, capacity| unsafe { sys::dWorldGetContactEvents(self.raw(), to, capacity) }).iter().map(event).collect()
    }
    /// What happened in the last step, as the event settings say. C: `dWorldGetEvents`.
    pub fn events(&self) -> Vec<Event> {
        let shared = self.shared();
        let event = |e: &sys::dEvent| Event {
            kind: EventKind::of_number(e.kind),
            geom1: shared.geom_lately(e.g1),
            geom2: shared.geom_lately(e.g2),
            joint: shared.joint_lately(e.joint),
            position: vec3(e.pos),
            normal: vec3(e.normal),
            approach_speed: e.approach_speed,
            impulse: e.impulse,
        };
        list(|to, capacity| unsafe { sys::dWorldGetEvents(self.raw(), to, capacity) }).iter().map(event).collect()
    }
    /// The joints that broke in the last step. C: `dWorldGetBrokenJoints`.
    pub fn broken_joints(&self) -> Vec<JointId> {
        let broken = list(|to, capacity| unsafe { sys::dWorldGetBrokenJoints(self.raw(), to, capacity) });
        broken.into_iter().filter_map(|joint| self.shared().joint_of(joint)).collect()
    }
    /// The causes of failure that steps have found since [`World::set_diagnosis_mode`], the most severe first. C: `dWorldDiagnose`.
    pub fn diagnose(&self) -> Vec<Cause> {
        let shared = self.shared();
        let cause = |c: &sys::dDiagnosis| Cause {
            kind: DiagnosisKind::of_number(c.kind),
            severity: Severity::of_number(c.severity),
            body: shared.body_of(c.body),
            other: shared.body_of(c.other),
            joint: shared.joint_of(c.joint),
            geom: shared.geom_of(c.geom),
            figure: c.figure,
            threshold: c.threshold,
            steps: c.steps,
            text: text_of(c),
        };
        list(|to, capacity| unsafe { sys::dWorldDiagnose(self.raw(), to, capacity) }).iter().map(cause).collect()
    }
}

fn text_of(cause: &sys::dDiagnosis) -> String {
    let mut bytes = [0u8; 1000];
    let length = sure(|| unsafe { sys::dDiagnosisText(cause, bytes.as_mut_ptr().cast::<c_char>(), bytes.len() as i32) });
    String::from_utf8_lossy(&bytes[..(length.max(0) as usize).min(bytes.len() - 1)]).into_owned()
}
