// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms: how they are made, and what is not written from the headers.
use crate::error::done;
use crate::prelude::*;
use crate::shape::{Data, Shape};
use crate::table::GeomData;
use std::marker::PhantomData;
use std::ops::Deref;
use std::rc::Rc;

/// A geom of a world, for reading.
#[derive(Clone, Copy)]
pub struct Geom<'w> {
    raw: sys::dGeomID,
    id: GeomId,
    world: &'w World,
}

/// A geom of a world, for changing it; it reads as [`Geom`] does.
pub struct GeomMut<'w> {
    geom: Geom<'w>,
    _alone: PhantomData<&'w mut World>,
}

impl<'w> Deref for GeomMut<'w> {
    type Target = Geom<'w>;
    fn deref(&self) -> &Geom<'w> {
        &self.geom
    }
}

impl<'w> Geom<'w> {
    pub(crate) fn new(raw: sys::dGeomID, id: GeomId, world: &'w World) -> Self {
        Self { raw, id, world }
    }
    pub(crate) fn raw(&self) -> sys::dGeomID {
        self.raw
    }
    pub(crate) fn shared(&self) -> &'w Shared {
        self.world.shared()
    }
    /// Its handle.
    pub fn id(&self) -> GeomId {
        self.id
    }
    /// The number that the program has given to it, 0 at first.
    pub fn tag(&self) -> u64 {
        self.shared().geoms.borrow().data(self.id.index).tag
    }
    /// Its body, if it is on one. C: `dGeomGetBody`.
    pub fn body(&self) -> Option<BodyId> {
        self.shared().body_of(sure(|| unsafe { sys::dGeomGetBody(self.raw) }))
    }
    /// Its surface as triangles of three corners, m, in its own frame; only of convex solids. C: `dGeomGetTriangles`.
    pub fn triangles(&self, segments: i32) -> Result<Vec<[Vec3; 3]>> {
        let list = |to: *mut Real, capacity| call(|| unsafe { sys::dGeomGetTriangles(self.raw, segments, to, capacity) });
        let count = list(std::ptr::null_mut(), 0)?;
        let mut all = vec![[[0.0; 3]; 3]; count as usize];
        list(all.as_mut_ptr().cast(), count)?;
        Ok(all)
    }
    /// The numbers that [`set_face_material_numbers`](GeomMut::set_face_material_numbers) has set. C: `dGeomGetFaceMaterialNumbers`.
    pub fn face_material_numbers(&self) -> Result<Vec<u8>> {
        let list = |to: *mut u8, capacity| call(|| unsafe { sys::dGeomGetFaceMaterialNumbers(self.raw, to, capacity) });
        let mut all = vec![0u8; list(std::ptr::null_mut(), 0)? as usize];
        list(all.as_mut_ptr(), all.len() as i32)?;
        Ok(all)
    }
    /// The corners of a triangle of a mesh, m, in the world. C: `dGeomTriMeshGetTriangle`.
    pub fn mesh_triangle(&self, index: i32) -> Result<[Vec3; 3]> {
        let mut corners = [[0.0; 4]; 3];
        let [a, b, c] = &mut corners;
        call(|| unsafe { sys::dGeomTriMeshGetTriangle(self.raw, index, a, b, c) })?;
        Ok(corners.map(vec3))
    }
    /// Lets a panic of a filter go on.
    pub(crate) fn finish(&self) {
        self.shared().finish();
    }
}

impl<'w> GeomMut<'w> {
    pub(crate) fn new(raw: sys::dGeomID, id: GeomId, world: &'w mut World) -> Self {
        Self { geom: Geom::new(raw, id, world), _alone: PhantomData }
    }
    /// Which of its materials each triangle of a mesh or cell of a height field has; none: all have the geom's own. C:
    /// `dGeomSetFaceMaterialNumbers`.
    pub fn set_face_material_numbers(&mut self, numbers: &[u8]) -> Result<()> {
        done(|| unsafe { sys::dGeomSetFaceMaterialNumbers(self.raw, numbers.as_ptr(), numbers.len() as i32) })
    }
    /// Gives it a number of the program's.
    pub fn set_tag(&mut self, tag: u64) {
        self.shared().geoms.borrow_mut().data_mut(self.id.index).tag = tag;
    }
    /// Puts it on a body, whose pose it then shares; `None` takes it off. C: `dGeomSetBody`.
    pub fn set_body(&mut self, body: Option<BodyId>) -> Result<()> {
        let body = body.map_or(Ok(std::ptr::null_mut()), |id| self.shared().body(id))?;
        call(|| unsafe { sys::dGeomSetBody(self.raw, body) })
    }
}

/// How a geom begins: with its frame that of the world or of its body, and the default material.
#[derive(Clone, Debug)]
pub struct GeomDef<'a> {
    shape: Shape<'a>,
    position: Option<Vec3>,
    quaternion: Option<Quat>,
    material: Option<Material>,
    category_bits: Option<u64>,
    collide_bits: Option<u64>,
    sensor: bool,
    continuous: Option<Continuous>,
    tag: u64,
}

impl<'a> GeomDef<'a> {
    /// A geom of a shape, with the defaults.
    pub fn new(shape: Shape<'a>) -> Self {
        let none = (None, None, None, None, None, None);
        let (position, quaternion, material, category_bits, collide_bits, continuous) = none;
        Self { shape, position, quaternion, material, category_bits, collide_bits, sensor: false, continuous, tag: 0 }
    }
    /// Where its origin is, in the world or in the body's frame, m.
    pub fn position(mut self, position: Vec3) -> Self {
        self.position = Some(position);
        self
    }
    /// Its orientation, in the world or in the body's frame: w, x, y, z.
    pub fn quaternion(mut self, quaternion: Quat) -> Self {
        self.quaternion = Some(quaternion);
        self
    }
    /// Its surface.
    pub fn material(mut self, material: Material) -> Self {
        self.material = Some(material);
        self
    }
    /// What it is, and what it touches, in bits: two geoms may touch if the category of one has a bit of what the other touches.
    pub fn bits(mut self, category: u64, collide: u64) -> Self {
        self.category_bits = Some(category);
        self.collide_bits = Some(collide);
        self
    }
    /// Events report what overlaps it; nothing touches it.
    pub fn sensor(mut self) -> Self {
        self.sensor = true;
        self
    }
    /// What steps do about its path.
    pub fn continuous(mut self, mode: Continuous) -> Self {
        self.continuous = Some(mode);
        self
    }
    /// A number of the program's.
    pub fn tag(mut self, tag: u64) -> Self {
        self.tag = tag;
        self
    }

    /// Its mass about the origin of its body, when it has been put there.
    pub(crate) fn mass(&self, geom: sys::dGeomID, density: Real) -> Result<sys::dMass> {
        let mut mass = self.shape.mass(geom, density)?;
        if matches!(self.shape, Shape::Mesh { .. }) {
            return Ok(mass); // as it stands in the world: the body is still at the origin when it is weighed
        }
        if let Some(q) = self.quaternion {
            let mut rotation = [0.0; 12];
            call(|| unsafe {
                sys::dRfromQ(rotation.as_mut_ptr(), q.as_ptr());
                sys::dMassRotate(&mut mass, rotation.as_ptr());
            })?;
        }
        if let Some([x, y, z]) = self.position {
            call(|| unsafe { sys::dMassTranslate(&mut mass, x, y, z) })?;
        }
        Ok(mass)
    }
}

impl World {
    /// Adds a geom that is fixed in the world.
    pub fn add_geom(&mut self, def: &GeomDef<'_>) -> Result<GeomId> {
        self.new_geom(def, None)
    }
    /// Adds a geom to a body. Its mass stays.
    pub fn add_geom_to(&mut self, body: BodyId, def: &GeomDef<'_>) -> Result<GeomId> {
        self.add_geom_on(body, def)
    }

    pub(crate) fn new_geom(&mut self, def: &GeomDef<'_>, body: Option<sys::dBodyID>) -> Result<GeomId> {
        let (raw, data) = def.shape.create(self.space())?;
        let id = self.register_geom(raw, data);
        match self.complete_geom(id, def, body) {
            Ok(()) => Ok(id),
            Err(error) => {
                self.remove_geom(id)?;
                Err(error)
            }
        }
    }

    pub(crate) fn register_geom(&mut self, raw: sys::dGeomID, data: Option<Data>) -> GeomId {
        let data = GeomData { data: data.map(Rc::new), ..GeomData::default() };
        let (index, generation) = self.shared().geoms.borrow_mut().insert(raw as usize, data);
        GeomId { world: self.shared().id, index, generation }
    }

    fn complete_geom(&mut self, id: GeomId, def: &GeomDef<'_>, body: Option<sys::dBodyID>) -> Result<()> {
        let mut geom = self.geom_mut(id)?;
        if let Some(body) = body {
            call(|| unsafe { sys::dGeomSetBody(geom.raw(), body) })?;
        }
        match (def.position, body) {
            (Some(position), Some(_)) => geom.set_offset_position(position)?,
            (Some(position), None) => geom.set_position(position)?,
            _ => {}
        }
        match (def.quaternion, body) {
            (Some(quaternion), Some(_)) => geom.set_offset_quaternion(quaternion)?,
            (Some(quaternion), None) => geom.set_quaternion(quaternion)?,
            _ => {}
        }
        if def.material.is_some() {
            geom.set_material(def.material.as_ref())?;
        }
        if let (Some(category), Some(collide)) = (def.category_bits, def.collide_bits) {
            geom.set_category_bits(category)?;
            geom.set_collide_bits(collide)?;
        }
        if def.sensor {
            geom.set_sensor(true)?;
        }
        if let Some(mode) = def.continuous {
            geom.set_continuous(mode)?;
        }
        geom.set_tag(def.tag);
        Ok(())
    }
}
