// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds: a dWorldID with a space of its own for all geoms, which is the space of its contacts.
use crate::callbacks;
use crate::callbacks::{Moved, Touching};
use crate::error::{done, made, start, Error};
use crate::prelude::*;
use std::ptr::NonNull;
use std::sync::atomic::{AtomicU32, Ordering};

/// How a step is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Method {
    /// Exactly: for joints, machines, small piles. C: `dWorldStep`.
    #[default]
    Exact,
    /// By sweeps: for large piles. C: `dWorldQuickStep`.
    Quick,
    /// Each island as suits it; what [`Defaults::Game`] and [`Defaults::Robot`] are made for. C: `dWorldStepHybrid`.
    Hybrid,
    /// In so many substeps. C: `dWorldStepFast1`.
    Substeps(u16),
}

/// Bodies, joints and geoms, and the steps that move them on in time. See the [crate's page](crate).
pub struct World {
    raw: sys::dWorldID,
    space: sys::dSpaceID,
    shared: NonNull<Shared>,
    method: Method,
}

// Nothing in a world is tied to a thread: the library keeps no data per thread, and functions of the program are Send. What a world
// shares with others in the library (pools, handlers) is guarded there. It is not Sync: reading may compute boxes of geoms.
unsafe impl Send for World {}

/// How a world begins.
#[derive(Clone, Debug)]
pub struct WorldDef {
    gravity: Vec3,
    defaults: Defaults,
    threads: Option<i32>,
    history: i32,
    events: Option<EventSettings>,
}

impl Default for WorldDef {
    fn default() -> Self {
        Self { gravity: [0.0, 0.0, -9.81], defaults: Defaults::Ode, threads: None, history: 0, events: None }
    }
}

impl WorldDef {
    /// Gravity (0, 0, -9.81), the defaults of ODE, one thread, no history and no events.
    pub fn new() -> Self {
        Self::default()
    }
    /// m/s^2.
    pub fn gravity(mut self, gravity: Vec3) -> Self {
        self.gravity = gravity;
        self
    }
    /// What the world is for ([`World::use_defaults`]).
    pub fn defaults(mut self, defaults: Defaults) -> Self {
        self.defaults = defaults;
        self
    }
    /// Threads of a step ([`World::set_step_threads`]); 0: one for each processor. Results do not depend on it.
    pub fn threads(mut self, threads: i32) -> Self {
        self.threads = Some(threads);
        self
    }
    /// How many steps can be taken back ([`World::roll_back`]).
    pub fn history(mut self, frames: i32) -> Self {
        self.history = frames;
        self
    }
    /// Which events steps list ([`World::events`]).
    pub fn events(mut self, settings: EventSettings) -> Self {
        self.events = Some(settings);
        self
    }
    /// Makes the world.
    pub fn build(&self) -> Result<World> {
        let mut world = World::empty()?;
        world.set_gravity(self.gravity)?;
        if self.defaults != Defaults::Ode {
            world.use_defaults(self.defaults)?;
        }
        if let Some(threads) = self.threads {
            world.set_step_threads(threads)?;
        }
        if self.history != 0 {
            world.set_history(self.history)?;
        }
        if self.events.is_some() {
            world.set_event_settings(self.events.as_ref())?;
        }
        Ok(world)
    }
}

static WORLDS: AtomicU32 = AtomicU32::new(1);

impl World {
    /// An empty world with the gravity of the earth, (0, 0, -9.81). [`WorldDef`] makes others.
    pub fn new() -> Result<Self> {
        WorldDef::new().build()
    }

    fn empty() -> Result<Self> {
        start();
        let raw = made(|| unsafe { sys::dWorldCreate() })?;
        match made(|| unsafe { sys::dHashSpaceCreate(std::ptr::null_mut()) }) {
            Ok(space) => {
                let world = Self::around(raw, space);
                call(|| unsafe { sys::dWorldSetContactSpace(raw, space) })?;
                Ok(world)
            }
            Err(error) => {
                unsafe { sys::dWorldDestroy(raw) };
                Err(error)
            }
        }
    }

    /// Takes over a world and a space of the library that nobody else has.
    pub(crate) fn around(raw: sys::dWorldID, space: sys::dSpaceID) -> Self {
        let shared = Box::new(Shared { id: WORLDS.fetch_add(1, Ordering::Relaxed), ..Shared::default() });
        let shared = NonNull::from(Box::leak(shared));
        sure(|| unsafe { sys::dWorldSetData(raw, shared.as_ptr().cast()) });
        Self { raw, space, shared, method: Method::Exact }
    }

    pub(crate) fn raw(&self) -> sys::dWorldID {
        self.raw
    }
    pub(crate) fn space(&self) -> sys::dSpaceID {
        self.space
    }
    pub(crate) fn shared(&self) -> &Shared {
        // It lives until the world is dropped, and is never borrowed but like this.
        unsafe { self.shared.as_ref() }
    }
    pub(crate) fn shared_pointer(&self) -> *const Shared {
        self.shared.as_ptr()
    }

    /// Gives every parameter of steps the value for a purpose, and takes the method that goes with them: `Hybrid`, or `Exact` for
    /// [`Defaults::Ode`]. Call it before bodies are added. C: `dWorldUseDefaults`.
    pub fn use_defaults(&mut self, defaults: Defaults) -> Result<()> {
        done(|| unsafe { sys::dWorldUseDefaults(self.raw, defaults.number()) })?;
        self.method = if defaults == Defaults::Ode { Method::Exact } else { Method::Hybrid };
        Ok(())
    }

    /// How [`step`](Self::step) solves; `Exact` at first.
    pub fn method(&self) -> Method {
        self.method
    }
    /// Chooses how [`step`](Self::step) solves.
    pub fn set_method(&mut self, method: Method) {
        self.method = method;
    }

    /// Advances by `h` seconds. A step that is refused has changed nothing. A panic of a callback goes on when the step is over.
    pub fn step(&mut self, h: Real) -> Result<()> {
        self.step_by(self.method, h)
    }
    /// Advances by `h` seconds, solved as `method` says.
    pub fn step_by(&mut self, method: Method, h: Real) -> Result<()> {
        self.shared().begin_step();
        let raw = self.raw;
        let mut made = 0;
        let stepped = done(|| {
            made = unsafe {
                match method {
                    Method::Exact => sys::dWorldStep(raw, h),
                    Method::Quick => sys::dWorldQuickStep(raw, h),
                    Method::Hybrid => sys::dWorldStepHybrid(raw, h),
                    Method::Substeps(count) => sys::dWorldStepFast1(raw, h, i32::from(count)),
                }
            };
            made
        });
        // Counted as the library's history counts, whatever was said on the way.
        if made != 0 {
            self.shared().count_step();
        }
        self.shared().finish();
        stepped
    }

    /// Lets `filter` decide which geoms may touch: not if it returns false. It is called once when two of them come near each other,
    /// and again when they have been apart.
    pub fn set_contact_filter(&mut self, filter: impl FnMut(Touching, Touching) -> bool + Send + 'static) -> Result<()> {
        let data = self.shared.as_ptr().cast();
        call(|| unsafe { sys::dWorldSetContactFilter(self.raw, Some(callbacks::contact_filter), data) })?;
        *self.shared().contact_filter.borrow_mut() = Some(Box::new(filter));
        Ok(())
    }
    /// Lets all geoms touch again whose bits agree.
    pub fn remove_contact_filter(&mut self) -> Result<()> {
        call(|| unsafe { sys::dWorldSetContactFilter(self.raw, None, std::ptr::null_mut()) })?;
        *self.shared().contact_filter.borrow_mut() = None;
        Ok(())
    }
    /// Calls `callback` for each body that a step has moved and that reports it ([`BodyMut::report_moves`](crate::BodyMut)), in
    /// the order of the step's islands.
    pub fn on_moved(&mut self, callback: impl FnMut(Moved) + Send + 'static) {
        *self.shared().moved.borrow_mut() = Some(Box::new(callback));
    }

    // ---- what is in it ----

    /// A view of a body, for reading.
    pub fn body(&self, id: BodyId) -> Result<Body<'_>> {
        Ok(Body::new(self.shared().body(id)?, id, self))
    }
    /// A view of a body, for changing it.
    pub fn body_mut(&mut self, id: BodyId) -> Result<BodyMut<'_>> {
        Ok(BodyMut::new(self.shared().body(id)?, id, self))
    }
    /// A view of a joint, for reading.
    pub fn joint(&self, id: JointId) -> Result<Joint<'_>> {
        Ok(Joint::new(self.shared().joint(id)?, id, self))
    }
    /// A view of a joint, for changing it.
    pub fn joint_mut(&mut self, id: JointId) -> Result<JointMut<'_>> {
        Ok(JointMut::new(self.shared().joint(id)?, id, self))
    }
    /// A view of a geom, for reading.
    pub fn geom(&self, id: GeomId) -> Result<Geom<'_>> {
        Ok(Geom::new(self.shared().geom(id)?, id, self))
    }
    /// A view of a geom, for changing it.
    pub fn geom_mut(&mut self, id: GeomId) -> Result<GeomMut<'_>> {
        Ok(GeomMut::new(self.shared().geom(id)?, id, self))
    }

    /// All bodies, in the order of their places.
    pub fn bodies(&self) -> Vec<BodyId> {
        let world = self.shared().id;
        self.shared().bodies.borrow().live().map(|(index, generation, _)| BodyId { world, index, generation }).collect()
    }
    /// All joints, in the order of their places.
    pub fn joints(&self) -> Vec<JointId> {
        let world = self.shared().id;
        self.shared().joints.borrow().live().map(|(index, generation, _)| JointId { world, index, generation }).collect()
    }
    /// All geoms, in the order of their places.
    pub fn geoms(&self) -> Vec<GeomId> {
        let world = self.shared().id;
        self.shared().geoms.borrow().live().map(|(index, generation, _)| GeomId { world, index, generation }).collect()
    }

    /// Removes a body and the geoms that are on it. Its joints stay, attached to nothing.
    pub fn remove_body(&mut self, id: BodyId) -> Result<()> {
        let raw = self.shared().body(id)?;
        let geoms = self.body(id)?.geoms();
        self.shared().refuse_parts_of_robots(|parts| parts.bodies.contains(&id) || geoms.iter().any(|geom| parts.geoms.contains(geom)))?;
        for geom in geoms {
            self.remove_geom(geom)?;
        }
        call(|| unsafe { sys::dBodyDestroy(raw) })?;
        self.shared().bodies.borrow_mut().remove(id.index, self.shared().keep());
        Ok(())
    }
    /// Removes a geom. C: `dGeomDestroy`.
    pub fn remove_geom(&mut self, id: GeomId) -> Result<()> {
        let raw = self.shared().geom(id)?;
        self.shared().refuse_parts_of_robots(|parts| parts.geoms.contains(&id))?;
        call(|| unsafe { sys::dGeomDestroy(raw) })?;
        self.shared().geoms.borrow_mut().remove(id.index, self.shared().keep());
        Ok(())
    }
    /// Removes a joint. C: `dJointDestroy`.
    pub fn remove_joint(&mut self, id: JointId) -> Result<()> {
        let raw = self.shared().joint(id)?;
        self.shared().refuse_parts_of_robots(|parts| parts.joints.contains(&id))?;
        call(|| unsafe { sys::dJointDestroy(raw) })?;
        self.shared().joints.borrow_mut().remove(id.index, self.shared().keep());
        Ok(())
    }
    pub(crate) fn refuse<T>(text: &str) -> Result<T> {
        Err(Error::refused(text))
    }
}

/// Makes `steps` steps of `h` seconds in each of many worlds, with one stepper, on so many threads (0: one for each processor). Each has
/// the bits that it would have alone. `substeps` is the number of those of the steppers that have them. Returns how many worlds have made
/// all steps: those that find no memory stop. C: `dWorldsStep`.
pub fn step_worlds(worlds: &mut [World], h: Real, stepper: Stepper, substeps: i32, steps: i32, threads: i32) -> Result<usize> {
    let Ok(count) = i32::try_from(worlds.len()) else { return World::refuse("too many worlds") };
    let raw: Vec<_> = worlds.iter().map(|world| world.raw).collect();
    let mut made = vec![0; worlds.len()];
    worlds.iter().for_each(|world| world.shared().begin_step());
    let (of, to) = (raw.as_ptr(), made.as_mut_ptr());
    let complete = call(|| unsafe { sys::dWorldsStep(of, count, h, stepper.number(), substeps, steps, threads, to) });
    for (world, &steps) in worlds.iter().zip(&made) {
        (0..steps).for_each(|_| world.shared().count_step());
    }
    // The panics of all callbacks are taken; the first goes on.
    let mut panics: Vec<_> = worlds.iter().filter_map(|world| world.shared().panic.borrow_mut().take()).collect();
    if !panics.is_empty() {
        std::panic::resume_unwind(panics.swap_remove(0));
    }
    complete.map(|complete| complete.max(0) as usize)
}

impl Drop for World {
    fn drop(&mut self) {
        // Functions of the program are not called while what they belong to goes; then C lets go of what Rust has, then that is freed.
        #[cfg(feature = "robots")]
        self.shared().end_robots(self.shared().robots.take());
        let geoms: Vec<_> = self.shared().geoms.borrow().live().map(|(_, _, raw)| raw as sys::dGeomID).collect();
        let _ = call(|| unsafe {
            sys::dWorldDestroy(self.raw);
            geoms.into_iter().filter(|&geom| sys::dGeomGetSpace(geom).is_null()).for_each(|geom| sys::dGeomDestroy(geom));
            sys::dSpaceSetCleanup(self.space, 1);
            sys::dSpaceDestroy(self.space);
        });
        drop(unsafe { Box::from_raw(self.shared.as_ptr()) });
    }
}

impl std::fmt::Debug for World {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let counts = (self.bodies().len(), self.joints().len(), self.geoms().len());
        write!(f, "World {{ bodies: {}, joints: {}, geoms: {}, method: {:?} }}", counts.0, counts.1, counts.2, self.method)
    }
}
