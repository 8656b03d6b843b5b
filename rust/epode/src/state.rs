// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// States, histories, files and copies of worlds. A roll-back brings back and destroys objects behind the tables, which then follow
// what is alive in C. A copy is made by way of the bytes of a file: it shares nothing with the original, so that both can be used by
// different threads.
use crate::error::{done, made, start, Error, ErrorKind};
use crate::prelude::*;
use crate::shape::Data;
use std::collections::HashMap;
use std::path::Path;
use std::rc::Rc;

/// Parts of a body's state, for [`World::body_states`]: added up with `|`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Fields(u32);

#[rustfmt::skip]
impl Fields {
    /// 3 numbers, m.
    pub const POSITION: Self = Self(sys::dStatePosition);
    /// 4 numbers: w x y z.
    pub const QUATERNION: Self = Self(sys::dStateQuaternion);
    /// 3 numbers, m/s.
    pub const LINEAR_VEL: Self = Self(sys::dStateLinearVel);
    /// 3 numbers, rad/s.
    pub const ANGULAR_VEL: Self = Self(sys::dStateAngularVel);
    /// 3 numbers, accumulated for the next step, N.
    pub const FORCE: Self = Self(sys::dStateForce);
    /// 3 numbers, accumulated for the next step, N m.
    pub const TORQUE: Self = Self(sys::dStateTorque);
    /// 1 number: 1 or 0.
    pub const ENABLED: Self = Self(sys::dStateEnabled);

    /// How many numbers a row has.
    pub fn width(self) -> usize {
        let widths = [(Self::POSITION, 3), (Self::QUATERNION, 4), (Self::LINEAR_VEL, 3), (Self::ANGULAR_VEL, 3), (Self::FORCE, 3), (Self::TORQUE, 3), (Self::ENABLED, 1)];
        widths.iter().filter(|(field, _)| self.0 & field.0 != 0).map(|(_, width)| width).sum()
    }
}

impl std::ops::BitOr for Fields {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl World {
    /// All that a step changes and later steps read, as bytes: a world that is given them goes on with the same bits. C: `dWorldGetState`.
    pub fn save_state(&self) -> Result<Vec<u8>> {
        let size = call(|| unsafe { sys::dWorldGetStateSize(self.raw()) })?;
        let mut bytes = vec![0u8; size];
        done(|| unsafe { sys::dWorldGetState(self.raw(), bytes.as_mut_ptr().cast(), size) })?;
        Ok(bytes)
    }
    /// Gives the world a state of its own, or of a world with the same bodies, joints and geoms. Bytes that are none are refused.
    /// C: `dWorldSetState`.
    pub fn load_state(&mut self, state: &[u8]) -> Result<()> {
        done(|| unsafe { sys::dWorldSetState(self.raw(), state.as_ptr().cast(), state.len()) })
    }
    /// What [`save_state`](Self::save_state) returns, as the difference from another state. C: `dWorldGetStateDelta`.
    pub fn save_state_delta(&self, base: &[u8]) -> Result<Vec<u8>> {
        let delta =
            |to: *mut u8, size| call(|| unsafe { sys::dWorldGetStateDelta(self.raw(), base.as_ptr().cast(), base.len(), to.cast(), size) });
        let mut bytes = vec![0u8; delta(std::ptr::null_mut(), 0)?];
        delta(bytes.as_mut_ptr(), bytes.len())?;
        Ok(bytes)
    }
    /// Gives the world the state that a base and a difference make up. C: `dWorldSetStateDelta`.
    pub fn load_state_delta(&mut self, base: &[u8], delta: &[u8]) -> Result<()> {
        let (from, by) = (base.as_ptr().cast(), delta.as_ptr().cast());
        done(|| unsafe { sys::dWorldSetStateDelta(self.raw(), from, base.len(), by, delta.len()) })
    }
    /// A number that is the same for the same bits: 64-bit FNV-1a of the bytes of the state.
    pub fn state_hash(&self) -> Result<u64> {
        let fold = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        Ok(self.save_state()?.iter().fold(0xcbf2_9ce4_8422_2325, fold))
    }

    /// Keeps the states after the coming steps, so that the last `frames` of them can be taken back; 0: none. C: `dWorldSetHistory`.
    pub fn set_history(&mut self, frames: i32) -> Result<()> {
        call(|| unsafe { sys::dWorldSetHistory(self.raw(), frames) })?;
        let shared = self.shared();
        shared.history.set(u64::try_from(frames).unwrap_or(0));
        shared.release_kept(u64::MAX);
        Ok(())
    }
    /// Takes back the last `frames` steps and all that the program has done since. What has been removed since comes back under its
    /// handle; handles of what has been added since name nothing any more. C: `dWorldRollBack`.
    pub fn roll_back(&mut self, frames: i32) -> Result<()> {
        done(|| unsafe { sys::dWorldRollBack(self.raw(), frames) })?;
        let shared = self.shared();
        let steps = shared.steps.get().saturating_sub(u64::try_from(frames).unwrap_or(0));
        shared.steps.set(steps);
        let bodies = raw_bodies(self.raw());
        shared.bodies.borrow_mut().restore(&addresses(&bodies), steps);
        shared.joints.borrow_mut().restore(&addresses(&raw_joints(self.raw())), steps);
        shared.geoms.borrow_mut().restore(&addresses(&raw_geoms(self.space(), &bodies)), steps);
        #[cfg(feature = "robots")]
        shared.end_broken_robots();
        Ok(())
    }

    /// The world as bytes, with everything in it but functions of the program and tags. C: `dWorldSaveToBuffer`.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        let save = |to: *mut u8, size| call(|| unsafe { sys::dWorldSaveToBuffer(self.raw(), self.space(), to.cast(), size) });
        let mut bytes = vec![0u8; save(std::ptr::null_mut(), 0)?];
        save(bytes.as_mut_ptr(), bytes.len())?;
        Ok(bytes)
    }
    /// Makes the point `offset`, m, the origin of the world: nothing moves against anything else. Histories begin again. C: `dWorldShiftOrigin`.
    pub fn shift_origin(&mut self, offset: Vec3) -> Result<()> {
        done(|| unsafe { sys::dWorldShiftOrigin(self.raw(), self.space(), pad3(offset).as_ptr()) })
    }
    /// Writes the world to a file. C: `dWorldSave`.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        let bytes = self.to_bytes()?;
        std::fs::write(path.as_ref(), bytes).map_err(|error| Error::new(ErrorKind::Failed, format!("{}: {error}", path.as_ref().display())))
    }
    /// The world of a file that [`save`](Self::save), the command or C has written. C: `dWorldLoad`.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let bytes =
            std::fs::read(path.as_ref()).map_err(|error| Error::new(ErrorKind::Failed, format!("{}: {error}", path.as_ref().display())))?;
        Self::from_bytes(&bytes)
    }
    /// The world that [`to_bytes`](Self::to_bytes) has written. C: `dWorldLoadFromBuffer`.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        let world = Self::read(bytes)?;
        let shared = world.shared();
        let bodies = raw_bodies(world.raw());
        for raw in &bodies {
            shared.bodies.borrow_mut().insert(*raw as usize, Default::default());
        }
        for raw in raw_joints(world.raw()) {
            shared.joints.borrow_mut().insert(raw as usize, Default::default());
        }
        for raw in raw_geoms(world.space(), &bodies) {
            shared.geoms.borrow_mut().insert(raw as usize, Default::default());
        }
        world.adopt_data();
        Ok(world)
    }

    /// A copy that goes on with the same bits. It shares nothing with this one. Handles of this world are made into the copy's by
    /// [`BodyId::in_world`] and its sisters; tags are copied; functions of the program, feedback and the history are not.
    pub fn try_clone(&self) -> Result<Self> {
        let mut copy = Self::read(&self.to_bytes()?)?;
        copy.set_method(self.method());
        copy.shared().copied_from.set(Some(self.shared().id));
        let (ours, theirs) = (raw_bodies(self.raw()), raw_bodies(copy.raw()));
        let joints = (raw_joints(self.raw()), raw_joints(copy.raw()));
        let geoms = (raw_geoms(self.space(), &ours), raw_geoms(copy.space(), &theirs));
        let (from, to) = (self.shared(), copy.shared());
        copy_places(&from.bodies.borrow(), &mut to.bodies.borrow_mut(), (&addresses(&ours), &addresses(&theirs)), |data, new| {
            new.tag = data.tag
        })?;
        let places = (addresses(&joints.0), addresses(&joints.1));
        copy_places(&from.joints.borrow(), &mut to.joints.borrow_mut(), (&places.0, &places.1), |data, new| new.tag = data.tag)?;
        let places = (addresses(&geoms.0), addresses(&geoms.1));
        copy_places(&from.geoms.borrow(), &mut to.geoms.borrow_mut(), (&places.0, &places.1), |data, new| new.tag = data.tag)?;
        copy.adopt_data();
        Ok(copy)
    }

    fn read(bytes: &[u8]) -> Result<Self> {
        start();
        let mut space = std::ptr::null_mut();
        let raw = made(|| unsafe { sys::dWorldLoadFromBuffer(bytes.as_ptr().cast(), bytes.len(), &mut space) })?;
        if space.is_null() {
            space = unsafe { sys::dHashSpaceCreate(std::ptr::null_mut()) };
        }
        Ok(Self::around(raw, space))
    }

    /// Meshes and height fields of a world that has been read are its own: they are destroyed with it.
    fn adopt_data(&self) {
        let mut known: HashMap<usize, Rc<Data>> = HashMap::new();
        let mut geoms = self.shared().geoms.borrow_mut();
        let live: Vec<_> = geoms.live().collect();
        for (index, _, raw) in live {
            let Some((address, data)) = (unsafe { Data::of(raw as sys::dGeomID) }) else { continue };
            geoms.data_mut(index).data = Some(known.entry(address).or_insert_with(|| Rc::new(data())).clone());
        }
    }

    /// Writes a row of numbers for each body to `rows`, without a copy in between: the parts that `fields` names, in the order of
    /// their constants. C: `dBodiesGetStates`.
    pub fn body_states(&self, ids: &[BodyId], fields: Fields, rows: &mut [Real]) -> Result<()> {
        let bodies = self.raw_of(ids, fields, rows.len())?;
        let (pointer, count) = (bodies.as_ptr(), bodies.len() as i32);
        done(|| unsafe { sys::dBodiesGetStates(pointer, count, fields.0, rows.as_mut_ptr(), 0) })
    }
    /// Sets the parts that `fields` names of all bodies, from a row of numbers for each. C: `dBodiesSetStates`.
    pub fn set_body_states(&mut self, ids: &[BodyId], fields: Fields, rows: &[Real]) -> Result<()> {
        let bodies = self.raw_of(ids, fields, rows.len())?;
        let (pointer, count) = (bodies.as_ptr(), bodies.len() as i32);
        done(|| unsafe { sys::dBodiesSetStates(pointer, count, fields.0, rows.as_ptr(), 0) })
    }
    fn raw_of(&self, ids: &[BodyId], fields: Fields, numbers: usize) -> Result<Vec<sys::dBodyID>> {
        if ids.len().checked_mul(fields.width()) != Some(numbers) || i32::try_from(ids.len()).is_err() {
            return Self::refuse("rows must have Fields::width() numbers for each body");
        }
        ids.iter().map(|&id| self.shared().body(id)).collect()
    }
}

fn addresses<T>(pointers: &[*mut T]) -> Vec<usize> {
    pointers.iter().map(|&pointer| pointer as usize).collect()
}

/// Bodies, oldest first.
pub(crate) fn raw_bodies(world: sys::dWorldID) -> Vec<sys::dBodyID> {
    let list = |to, capacity| sure(|| unsafe { sys::dWorldGetBodies(world, to, capacity) });
    let count = list(std::ptr::null_mut(), 0);
    let mut all = vec![std::ptr::null_mut(); count as usize];
    list(all.as_mut_ptr(), count);
    all
}
/// Joints, oldest first.
pub(crate) fn raw_joints(world: sys::dWorldID) -> Vec<sys::dJointID> {
    let list = |to, capacity| sure(|| unsafe { sys::dWorldGetJoints(world, to, capacity) });
    let count = list(std::ptr::null_mut(), 0);
    let mut all = vec![std::ptr::null_mut(); count as usize];
    list(all.as_mut_ptr(), count);
    all
}
/// Members of the space and of spaces in it, then geoms of bodies that are in no space.
pub(crate) fn raw_geoms(space: sys::dSpaceID, bodies: &[sys::dBodyID]) -> Vec<sys::dGeomID> {
    let mut all = Vec::new();
    members(space, &mut all);
    let known: std::collections::HashSet<_> = all.iter().copied().collect();
    for &body in bodies {
        let mut geom = sure(|| unsafe { sys::dBodyGetFirstGeom(body) });
        while !geom.is_null() {
            if !known.contains(&geom) {
                all.push(geom);
            }
            geom = sure(|| unsafe { sys::dBodyGetNextGeom(geom) });
        }
    }
    all
}
fn members(space: sys::dSpaceID, all: &mut Vec<sys::dGeomID>) {
    for i in 0..sure(|| unsafe { sys::dSpaceGetNumGeoms(space) }) {
        let geom = sure(|| unsafe { sys::dSpaceGetGeom(space, i) });
        if sure(|| unsafe { sys::dGeomIsSpace(geom) }) != 0 {
            members(geom.cast(), all);
        } else {
            all.push(geom);
        }
    }
}

/// Puts the objects of a copy into the places that they have in the original.
fn copy_places<D: Default>(
    from: &crate::table::Slots<D>,
    to: &mut crate::table::Slots<D>,
    (ours, theirs): (&[usize], &[usize]),
    tag: impl Fn(&D, &mut D),
) -> Result<()> {
    if ours.len() != theirs.len() {
        return Err(Error::new(ErrorKind::Failed, "the copy has another number of objects"));
    }
    for (&original, &counterpart) in ours.iter().zip(theirs) {
        if let Some((index, generation)) = from.find(original) {
            let mut data = D::default();
            tag(from.data(index), &mut data);
            to.insert_at(index, generation, counterpart, data);
        }
    }
    to.complete(&from.generations());
    Ok(())
}
