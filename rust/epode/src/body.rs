// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies: how they are made, and what is not written from the headers. A body's origin is its centre of mass; geoms are moved so.
use crate::callbacks;
use crate::error::made;
use crate::geom::GeomDef;
use crate::prelude::*;
use crate::shape::Shape;
use std::marker::PhantomData;
use std::ops::Deref;

/// A body of a world, for reading.
#[derive(Clone, Copy)]
pub struct Body<'w> {
    raw: sys::dBodyID,
    id: BodyId,
    world: &'w World,
}

/// A body of a world, for changing it; it reads as [`Body`] does.
pub struct BodyMut<'w> {
    body: Body<'w>,
    _alone: PhantomData<&'w mut World>,
}

impl<'w> Deref for BodyMut<'w> {
    type Target = Body<'w>;
    fn deref(&self) -> &Body<'w> {
        &self.body
    }
}

impl<'w> Body<'w> {
    pub(crate) fn new(raw: sys::dBodyID, id: BodyId, world: &'w World) -> Self {
        Self { raw, id, world }
    }
    pub(crate) fn raw(&self) -> sys::dBodyID {
        self.raw
    }
    /// Its handle.
    pub fn id(&self) -> BodyId {
        self.id
    }
    /// The number that the program has given to it, 0 at first.
    pub fn tag(&self) -> u64 {
        self.world.shared().bodies.borrow().data(self.id.index).tag
    }
    /// Mass, centre and inertia. C: `dBodyGetMass`.
    pub fn mass(&self) -> Mass {
        let mut mass = sys::dMass { mass: 0.0, c: [0.0; 4], I: [0.0; 12] };
        sure(|| unsafe { sys::dBodyGetMass(self.raw, &mut mass) });
        Mass::from_raw(&mass)
    }
    /// The geoms on it, the one that was put on it last first.
    pub fn geoms(&self) -> Vec<GeomId> {
        let mut all = Vec::new();
        let mut geom = sure(|| unsafe { sys::dBodyGetFirstGeom(self.raw) });
        while !geom.is_null() {
            all.extend(self.world.shared().geom_of(geom));
            geom = sure(|| unsafe { sys::dBodyGetNextGeom(geom) });
        }
        all
    }
    /// The joints that are attached to it.
    pub fn joints(&self) -> Vec<JointId> {
        let joint = |i| self.world.shared().joint_of(sure(|| unsafe { sys::dBodyGetJoint(self.raw, i) }));
        (0..self.num_joints()).filter_map(joint).collect()
    }
}

impl<'w> BodyMut<'w> {
    pub(crate) fn new(raw: sys::dBodyID, id: BodyId, world: &'w mut World) -> Self {
        Self { body: Body::new(raw, id, world), _alone: PhantomData }
    }
    /// Gives it a number of the program's.
    pub fn set_tag(&mut self, tag: u64) {
        self.world.shared().bodies.borrow_mut().data_mut(self.id.index).tag = tag;
    }
    /// Sets mass and inertia; the centre must be at the origin. C: `dBodySetMass`.
    pub fn set_mass(&mut self, mass: &Mass) -> Result<()> {
        call(|| unsafe { sys::dBodySetMass(self.raw, &mass.to_raw()) })
    }
    /// Chooses whether steps that move it call [`World::on_moved`]'s function.
    pub fn report_moves(&mut self, on: bool) -> Result<()> {
        let callback: Option<unsafe extern "C" fn(sys::dBodyID)> = if on { Some(callbacks::moved) } else { None };
        call(|| unsafe { sys::dBodySetMovedCallback(self.raw, callback) })
    }
}

#[derive(Clone, Copy, Debug)]
enum Weight {
    Density(Real),
    Total(Real),
    Given(Mass),
}

/// How a body begins: at the origin, at rest, enabled; its mass that of its shapes filled with 1000 kg/m^3, or 1 kg without a shape.
#[derive(Clone, Debug)]
pub struct BodyDef<'a> {
    position: Vec3,
    quaternion: Quat,
    linear_vel: Vec3,
    angular_vel: Vec3,
    geoms: Vec<GeomDef<'a>>,
    weight: Weight,
    kinematic: bool,
    tag: u64,
}

impl Default for BodyDef<'_> {
    fn default() -> Self {
        let (zero, weight) = ([0.0; 3], Weight::Density(1000.0));
        Self {
            position: zero,
            quaternion: [1.0, 0.0, 0.0, 0.0],
            linear_vel: zero,
            angular_vel: zero,
            geoms: Vec::new(),
            weight,
            kinematic: false,
            tag: 0,
        }
    }
}

impl<'a> BodyDef<'a> {
    /// The defaults.
    pub fn new() -> Self {
        Self::default()
    }
    /// Where its centre of mass is, m.
    pub fn position(mut self, position: Vec3) -> Self {
        self.position = position;
        self
    }
    /// Its orientation: w, x, y, z.
    pub fn quaternion(mut self, quaternion: Quat) -> Self {
        self.quaternion = quaternion;
        self
    }
    /// m/s.
    pub fn linear_vel(mut self, velocity: Vec3) -> Self {
        self.linear_vel = velocity;
        self
    }
    /// rad/s.
    pub fn angular_vel(mut self, velocity: Vec3) -> Self {
        self.angular_vel = velocity;
        self
    }
    /// A shape of the body with default settings.
    pub fn shape(self, shape: Shape<'a>) -> Self {
        self.geom(GeomDef::new(shape))
    }
    /// A geom of the body; its position and quaternion count from the body's frame.
    pub fn geom(mut self, geom: GeomDef<'a>) -> Self {
        self.geoms.push(geom);
        self
    }
    /// What its shapes are filled with, kg/m^3.
    pub fn density(mut self, density: Real) -> Self {
        self.weight = Weight::Density(density);
        self
    }
    /// How heavy it is in all, kg.
    pub fn mass(mut self, total: Real) -> Self {
        self.weight = Weight::Total(total);
        self
    }
    /// Mass and inertia, whatever its shapes are.
    pub fn inertia(mut self, mass: Mass) -> Self {
        self.weight = Weight::Given(mass);
        self
    }
    /// Forces do not move it; it moves as its velocity says.
    pub fn kinematic(mut self) -> Self {
        self.kinematic = true;
        self
    }
    /// A number of the program's.
    pub fn tag(mut self, tag: u64) -> Self {
        self.tag = tag;
        self
    }
}

impl World {
    /// Adds a body and its geoms. If anything of it is refused, nothing is added.
    pub fn add_body(&mut self, def: &BodyDef<'_>) -> Result<BodyId> {
        let raw = made(|| unsafe { sys::dBodyCreate(self.raw()) })?;
        let (index, generation) = self.shared().bodies.borrow_mut().insert(raw as usize, Default::default());
        let id = BodyId { world: self.shared().id, index, generation };
        match self.complete_body(id, def) {
            Ok(()) => Ok(id),
            Err(error) => {
                self.remove_body(id)?;
                Err(error)
            }
        }
    }

    fn complete_body(&mut self, id: BodyId, def: &BodyDef<'_>) -> Result<()> {
        let mut geoms = Vec::new();
        for geom in &def.geoms {
            geoms.push(self.add_geom_on(id, geom)?);
        }
        self.weigh(id, def, &geoms)?;
        let mut body = self.body_mut(id)?;
        body.set_tag(def.tag);
        body.set_position(def.position)?;
        body.set_quaternion(def.quaternion)?;
        body.set_linear_vel(def.linear_vel)?;
        body.set_angular_vel(def.angular_vel)?;
        if def.kinematic {
            self.body_mut(id)?.set_kinematic()?;
        }
        Ok(())
    }

    /// Sets the mass, and moves the geoms so that the centre of mass is the body's origin.
    fn weigh(&mut self, id: BodyId, def: &BodyDef<'_>, geoms: &[GeomId]) -> Result<()> {
        if let Weight::Given(mass) = def.weight {
            return self.body_mut(id)?.set_mass(&mass);
        }
        let mut total = sys::dMass { mass: 0.0, c: [0.0; 4], I: [0.0; 12] };
        let density = if let Weight::Density(density) = def.weight { density } else { 1000.0 };
        for (geom, &of) in def.geoms.iter().zip(geoms) {
            let mass = geom.mass(self.geom(of)?.raw(), density)?;
            call(|| unsafe { sys::dMassAdd(&mut total, &mass) })?;
        }
        if total.mass == 0.0 {
            let kg = if let Weight::Total(kg) = def.weight { kg } else { 1.0 };
            return self.body_mut(id)?.set_mass(&Mass::diagonal(kg, [kg; 3]));
        }
        if let Weight::Total(kg) = def.weight {
            call(|| unsafe { sys::dMassAdjust(&mut total, kg) })?;
        }
        let c = vec3(total.c);
        call(|| unsafe { sys::dMassTranslate(&mut total, -c[0], -c[1], -c[2]) })?;
        total.c = [0.0; 4];
        if c != [0.0; 3] {
            for &of in geoms {
                let mut geom = self.geom_mut(of)?;
                let at = geom.offset_position()?;
                geom.set_offset_position([at[0] - c[0], at[1] - c[1], at[2] - c[2]])?;
            }
        }
        self.body_mut(id)?.set_mass(&Mass::from_raw(&total))
    }

    pub(crate) fn add_geom_on(&mut self, body: BodyId, def: &GeomDef<'_>) -> Result<GeomId> {
        let on = self.shared().body(body)?;
        self.new_geom(def, Some(on))
    }
}
