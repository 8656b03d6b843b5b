// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What Rust knows of the objects of a world: their pointers in C, generations, and what C points to and Rust owns (meshes, filters,
// feedback). A world whose history is on may bring removed objects back (World::roll_back): their places are kept, with all that is
// in them, until the history is dropped.
use crate::callbacks::{CharacterFilter, ContactFilter, MovedCallback};
use crate::error::{Error, ErrorKind, Result};
use crate::handle::{BodyId, GeomId, JointId};
use crate::owned::Owned;
use crate::shape::Data;
use epode_sys as sys;
use std::any::Any;
use std::cell::{Cell, RefCell, UnsafeCell};
use std::collections::{HashMap, HashSet, VecDeque};
use std::rc::Rc;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    Live,
    Kept(u64), // removed after so many steps, but a roll-back may bring it back
    Free,
}

struct Slot<D> {
    raw: usize,
    generation: u32,
    place: Place,
    data: D,
}

pub(crate) struct Slots<D> {
    slots: Vec<Slot<D>>,
    free: Vec<u32>,
    by_pointer: HashMap<usize, u32>,
    kept: VecDeque<(u64, u32)>, // by the number of steps
    removed_since_step: HashMap<usize, (u32, u32)>,
}

impl<D> Default for Slots<D> {
    fn default() -> Self {
        Self { slots: Vec::new(), free: Vec::new(), by_pointer: HashMap::new(), kept: VecDeque::new(), removed_since_step: HashMap::new() }
    }
}

impl<D: Default> Slots<D> {
    /// A new place for a pointer, as (index, generation).
    pub fn insert(&mut self, raw: usize, data: D) -> (u32, u32) {
        if let Some(&old) = self.by_pointer.get(&raw) {
            self.release(old); // what was kept there can no longer come back
        }
        let index = self.free.pop().unwrap_or_else(|| {
            self.slots.push(Slot { raw: 0, generation: 0, place: Place::Free, data: D::default() });
            u32::try_from(self.slots.len() - 1).expect("fewer than 2^32 objects")
        });
        let slot = &mut self.slots[index as usize];
        (slot.raw, slot.place, slot.data) = (raw, Place::Live, data);
        self.by_pointer.insert(raw, index);
        (index, slot.generation)
    }

    /// As insert, in the place of another world's object.
    pub fn insert_at(&mut self, index: u32, generation: u32, raw: usize, data: D) {
        while self.slots.len() <= index as usize {
            self.slots.push(Slot { raw: 0, generation: 0, place: Place::Free, data: D::default() });
        }
        self.slots[index as usize] = Slot { raw, generation, place: Place::Live, data };
        self.by_pointer.insert(raw, index);
    }
    /// After the last insert_at: generations as in the other world, and free places for what will be created.
    pub fn complete(&mut self, generations: &[u32]) {
        for (index, &generation) in generations.iter().enumerate() {
            if index >= self.slots.len() {
                self.slots.push(Slot { raw: 0, generation, place: Place::Free, data: D::default() });
            }
            if self.slots[index].place == Place::Free {
                self.slots[index].generation = generation;
                self.free.push(index as u32);
            }
        }
    }
    pub fn generations(&self) -> Vec<u32> {
        // What is kept for the history of the other world must not come back here: its generation is over.
        let over = |slot: &Slot<D>| if matches!(slot.place, Place::Kept(_)) { slot.generation.saturating_add(1) } else { slot.generation };
        self.slots.iter().map(over).collect()
    }

    /// keep: after how many steps it is removed, if a roll-back may bring it back.
    pub fn remove(&mut self, index: u32, keep: Option<u64>) {
        let slot = &mut self.slots[index as usize];
        self.removed_since_step.insert(slot.raw, (index, slot.generation));
        match keep {
            Some(steps) => {
                slot.place = Place::Kept(steps);
                self.kept.push_back((steps, index));
            }
            None => self.release(index),
        }
    }

    fn release(&mut self, index: u32) {
        let slot = &mut self.slots[index as usize];
        self.by_pointer.remove(&slot.raw);
        slot.place = Place::Free;
        slot.data = D::default();
        if let Some(next) = slot.generation.checked_add(1) {
            slot.generation = next;
            self.free.push(index);
        }
    }

    /// Forgets what was removed before so many steps had been made: no roll-back leads there any more.
    pub fn release_kept(&mut self, before: u64) {
        while let Some(&(steps, index)) = self.kept.front().filter(|(steps, _)| *steps < before) {
            self.kept.pop_front();
            if self.slots[index as usize].place == Place::Kept(steps) {
                self.release(index);
            }
        }
    }

    /// After a roll-back to that number of steps: what is alive now. What was created and removed since is gone for good.
    pub fn restore(&mut self, alive: &[usize], steps: u64) {
        let set: HashSet<usize> = alive.iter().copied().collect();
        for index in 0..self.slots.len() {
            let slot = &mut self.slots[index];
            match (slot.place, set.contains(&slot.raw)) {
                (Place::Live, false) => self.release(index as u32),
                (Place::Kept(_), true) => slot.place = Place::Live,
                (Place::Kept(since), false) if since >= steps => self.release(index as u32),
                _ => {}
            }
        }
        for &raw in alive {
            if !self.by_pointer.contains_key(&raw) {
                self.insert(raw, D::default());
            }
        }
        self.kept.retain(|&(since, _)| since < steps);
        self.removed_since_step.clear();
    }

    pub fn raw(&self, index: u32, generation: u32) -> Option<usize> {
        let slot = self.slots.get(index as usize)?;
        (slot.place == Place::Live && slot.generation == generation).then_some(slot.raw)
    }
    pub fn find(&self, raw: usize) -> Option<(u32, u32)> {
        let index = *self.by_pointer.get(&raw)?;
        let slot = &self.slots[index as usize];
        (slot.place == Place::Live).then_some((index, slot.generation))
    }
    /// Also what has been removed since the last step, which events still name.
    pub fn find_lately(&self, raw: usize) -> Option<(u32, u32)> {
        self.find(raw).or_else(|| self.removed_since_step.get(&raw).copied())
    }
    pub fn begin_step(&mut self) {
        self.removed_since_step.clear();
    }
    pub fn data(&self, index: u32) -> &D {
        &self.slots[index as usize].data
    }
    pub fn data_mut(&mut self, index: u32) -> &mut D {
        &mut self.slots[index as usize].data
    }
    pub fn live(&self) -> impl Iterator<Item = (u32, u32, usize)> + '_ {
        let live = |(i, s): (usize, &Slot<D>)| (s.place == Place::Live).then_some((i as u32, s.generation, s.raw));
        self.slots.iter().enumerate().filter_map(live)
    }
}

#[derive(Default)]
pub(crate) struct BodyData {
    pub tag: u64,
}
#[derive(Default)]
pub(crate) struct JointData {
    pub tag: u64,
    /// Where the library writes the joint's forces, in every step.
    pub feedback: Option<Owned<UnsafeCell<sys::dJointFeedback>>>,
}
#[derive(Default)]
pub(crate) struct GeomData {
    pub tag: u64,
    /// The mesh or height field, destroyed after the last of its geoms. An Rc may travel with its world: all of its owners do.
    pub data: Option<Rc<Data>>,
    pub filter: Option<Owned<CharacterFilter>>,
}

/// What a world's callbacks see while the world is lent to the call that makes them: therefore it is behind a pointer of its own, and all of
/// it is in cells. No borrow of a cell lasts over a call into the library, but of the function that is being called.
#[derive(Default)]
pub(crate) struct Shared {
    pub id: u32,
    pub copied_from: Cell<Option<u32>>,
    pub bodies: RefCell<Slots<BodyData>>,
    pub joints: RefCell<Slots<JointData>>,
    pub geoms: RefCell<Slots<GeomData>>,
    pub contact_filter: RefCell<Option<ContactFilter>>,
    pub moved: RefCell<Option<MovedCallback>>,
    pub panic: RefCell<Option<Box<dyn Any + Send>>>,
    pub history: Cell<u64>, // how many steps can be taken back
    #[cfg(feature = "robots")]
    pub robots: RefCell<Vec<crate::robot::Members>>,
    #[cfg(feature = "robots")]
    pub robots_made: Cell<u32>,
    pub steps: Cell<u64>, // that have been made and not taken back
}

/// What belongs to a robot.
#[allow(dead_code)]
pub(crate) struct Parts<'r> {
    pub bodies: &'r [BodyId],
    pub joints: &'r [JointId],
    pub geoms: &'r [GeomId],
}

macro_rules! lookups {
    ($of:ident, $lately:ident, $raw:ident, $table:ident, $id:ident, $handle:ty, $what:literal) => {
        pub fn $of(&self, raw: $handle) -> Option<$id> {
            let (index, generation) = self.$table.borrow().find(raw as usize)?;
            Some($id { world: self.id, index, generation })
        }
        #[allow(dead_code)]
        pub fn $lately(&self, raw: $handle) -> Option<$id> {
            let (index, generation) = self.$table.borrow().find_lately(raw as usize)?;
            Some($id { world: self.id, index, generation })
        }
        pub fn $raw(&self, id: $id) -> Result<$handle> {
            if id.world != self.id {
                return Err(Error::new(ErrorKind::OtherWorld, concat!("the ", $what, " belongs to another world")));
            }
            match self.$table.borrow().raw(id.index, id.generation) {
                Some(raw) => Ok(raw as $handle),
                None => Err(Error::new(ErrorKind::Removed, concat!("the ", $what, " has been removed"))),
            }
        }
    };
}

impl Shared {
    /// Of no world: defaults name no objects.
    pub fn none() -> Self {
        Self::default()
    }
    lookups!(body_of, body_lately, body, bodies, BodyId, sys::dBodyID, "body");
    lookups!(joint_of, joint_lately, joint, joints, JointId, sys::dJointID, "joint");
    lookups!(geom_of, geom_lately, geom, geoms, GeomId, sys::dGeomID, "geom");

    pub fn begin_step(&self) {
        self.bodies.borrow_mut().begin_step();
        self.joints.borrow_mut().begin_step();
        self.geoms.borrow_mut().begin_step();
    }
    pub fn count_step(&self) {
        self.steps.set(self.steps.get() + 1);
        self.release_kept(self.steps.get().saturating_sub(self.history.get()));
    }
    pub fn release_kept(&self, before: u64) {
        self.bodies.borrow_mut().release_kept(before);
        self.joints.borrow_mut().release_kept(before);
        self.geoms.borrow_mut().release_kept(before);
    }
    /// For Slots::remove.
    pub fn keep(&self) -> Option<u64> {
        (self.history.get() > 0).then(|| self.steps.get())
    }
    /// What a robot is made of goes with it alone.
    pub fn refuse_parts_of_robots(&self, is_part: impl Fn(&Parts<'_>) -> bool) -> Result<()> {
        #[cfg(feature = "robots")]
        for robot in self.robots.borrow().iter() {
            if is_part(&Parts { bodies: &robot.bodies, joints: &robot.joints, geoms: &robot.geoms }) {
                return Err(Error::refused("a part of a robot is removed with it (World::remove_robot)"));
            }
        }
        let _ = is_part;
        Ok(())
    }
    /// Lets a panic of a callback go on.
    pub fn finish(&self) {
        let panic = self.panic.borrow_mut().take();
        if let Some(panic) = panic {
            std::panic::resume_unwind(panic);
        }
    }
}
