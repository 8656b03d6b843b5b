// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Functions of the program that the library calls. A panic must not cross C: it is caught, the functions are not called again until
// the call into the library is complete, and then it goes on. None of them can reach the world that calls it: that is lent to the
// call. So a step within a step does not compile.
use crate::handle::{BodyId, GeomId};
use crate::prelude::*;
use std::any::Any;
use std::cell::RefCell;
use std::ffi::{c_int, c_void};
use std::panic::{catch_unwind, AssertUnwindSafe};

/// One side of a pair that a contact filter judges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Touching {
    /// The geom.
    pub geom: GeomId,
    /// Its body, if it has one.
    pub body: Option<BodyId>,
    /// The number that the program gave to the geom ([`GeomDef::tag`](crate::GeomDef::tag)), 0 at first.
    pub tag: u64,
}

/// A body that a step has moved, as it was then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    /// The body.
    pub body: BodyId,
    /// The number that the program gave to the body, 0 at first.
    pub tag: u64,
    /// m.
    pub position: Vec3,
    /// Its orientation.
    pub quaternion: Quat,
}

pub(crate) type ContactFilter = Box<dyn FnMut(Touching, Touching) -> bool + Send>;
pub(crate) type MovedCallback = Box<dyn FnMut(Moved) + Send>;

/// A character's own filter; `shared` is that of the world that owns it.
pub(crate) struct CharacterFilter {
    pub shared: *const Shared,
    pub decide: RefCell<Box<dyn FnMut(GeomId, Vec3) -> bool + Send>>,
}

/// Calls a function of the program unless one of them has panicked.
fn guarded<R>(panic: &RefCell<Option<Box<dyn Any + Send>>>, otherwise: R, f: impl FnOnce() -> R) -> R {
    if panic.borrow().is_some() {
        return otherwise;
    }
    match catch_unwind(AssertUnwindSafe(f)) {
        Ok(result) => result,
        Err(payload) => {
            *panic.borrow_mut() = Some(payload);
            otherwise
        }
    }
}

impl Shared {
    unsafe fn touching(&self, raw: sys::dGeomID) -> Option<Touching> {
        let geom = self.geom_of(raw)?;
        let body = self.body_of(sys::dGeomGetBody(raw));
        Some(Touching { geom, body, tag: self.geoms.borrow().data(geom.index).tag })
    }
}

/// `data` is the world's Shared, which lives as long as the world.
pub(crate) unsafe extern "C" fn contact_filter(data: *mut c_void, o1: sys::dGeomID, o2: sys::dGeomID) -> c_int {
    let shared = &*data.cast::<Shared>();
    let kept = guarded(&shared.panic, true, || match (shared.touching(o1), shared.touching(o2)) {
        (Some(one), Some(two)) => shared.contact_filter.borrow_mut().as_mut().map_or(true, |filter| filter(one, two)),
        _ => true,
    });
    c_int::from(kept)
}

pub(crate) unsafe extern "C" fn moved(raw: sys::dBodyID) {
    let shared = sys::dWorldGetData(sys::dBodyGetWorld(raw)).cast::<Shared>();
    if shared.is_null() {
        return;
    }
    let shared = &*shared;
    guarded(&shared.panic, (), || {
        let Some(body) = shared.body_of(raw) else { return };
        let tag = shared.bodies.borrow().data(body.index).tag;
        let position = read_vec3(sys::dBodyGetPosition(raw));
        let quaternion = read_quat(sys::dBodyGetQuaternion(raw));
        if let Some(callback) = shared.moved.borrow_mut().as_mut() {
            callback(Moved { body, tag, position, quaternion });
        }
    });
}

/// `data` is a CharacterFilter, which lives as long as the geom.
pub(crate) unsafe extern "C" fn character_filter(data: *mut c_void, _: sys::dGeomID, other: sys::dGeomID, velocity: *const Real) -> c_int {
    let filter = &*data.cast::<CharacterFilter>();
    let shared = &*filter.shared;
    let kept = guarded(&shared.panic, true, || match shared.geom_of(other) {
        Some(geom) => (filter.decide.borrow_mut())(geom, read_vec3(velocity)),
        None => true,
    });
    c_int::from(kept)
}

/// What a query's filter needs, on the stack of the query.
pub(crate) struct QueryCall<'a> {
    pub shared: &'a Shared,
    pub decide: &'a mut dyn FnMut(GeomId) -> bool,
    pub panic: RefCell<Option<Box<dyn Any + Send>>>,
}

/// `data` is a QueryCall, which lives as long as the query.
pub(crate) unsafe extern "C" fn query_filter(data: *mut c_void, raw: sys::dGeomID) -> c_int {
    let call = &mut *data.cast::<QueryCall<'_>>();
    let QueryCall { shared, decide, panic } = call;
    let kept = guarded(panic, false, || shared.geom_of(raw).is_some_and(decide));
    c_int::from(kept)
}
