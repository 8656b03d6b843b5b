// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays, overlaps, distances and casts. A query reads the world, and so may its filter: it can make queries of its own.
use crate::callbacks::{query_filter, QueryCall};
use crate::error::Error;
use crate::prelude::*;
use std::cell::RefCell;

/// What a query has hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The geom that was hit.
    pub geom: GeomId,
    /// Where, in the world, m.
    pub position: Vec3,
    /// Unit, out of that geom's surface, against the ray or the motion.
    pub normal: Vec3,
    /// From the beginning of the ray or of the motion, m.
    pub distance: Real,
    /// The triangle of a mesh.
    pub side: Option<i32>,
}

/// How far two geoms are from each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    /// m; below 0: they overlap, and this is minus the depth.
    pub distance: Real,
    /// The points of the two where it is attained, in the world, m.
    pub positions: [Vec3; 2],
    /// Unit, from the second into the first.
    pub normal: Vec3,
}

/// What a query finds: everything, or what bits, a body and a function leave.
#[derive(Default)]
pub struct Filter<'f> {
    bits: Option<(u64, u64)>,
    skip_body: Option<BodyId>,
    decide: Option<RefCell<&'f mut dyn FnMut(GeomId) -> bool>>,
}

impl<'f> Filter<'f> {
    /// Everything.
    pub fn new() -> Self {
        Self::default()
    }
    /// Geoms whose collide bits have one of `category`, or whose category bits have one of `collide`.
    pub fn bits(mut self, category: u64, collide: u64) -> Self {
        self.bits = Some((category, collide));
        self
    }
    /// Leaves the geoms of a body out.
    pub fn skip_body(mut self, body: BodyId) -> Self {
        self.skip_body = Some(body);
        self
    }
    /// Leaves out what the function returns false for. A query within it must not use this very filter.
    pub fn keep(mut self, decide: &'f mut dyn FnMut(GeomId) -> bool) -> Self {
        self.decide = Some(RefCell::new(decide));
        self
    }
}

/// No hit: its geom is null.
fn empty() -> sys::dQueryHit {
    sys::dQueryHit { geom: std::ptr::null_mut(), pos: [0.0; 4], normal: [0.0; 4], distance: 0.0, side: -1 }
}

impl World {
    fn hit(&self, raw: &sys::dQueryHit) -> Option<Hit> {
        let geom = self.shared().geom_of(raw.geom)?;
        let (position, normal) = (vec3(raw.pos), vec3(raw.normal));
        Some(Hit { geom, position, normal, distance: raw.distance, side: (raw.side >= 0).then_some(raw.side) })
    }

    /// Calls a query with a C filter made of this one; a panic of its function goes on when the query is over.
    fn filtered<T>(&self, filter: &Filter<'_>, query: impl FnOnce(*const sys::dQueryFilter) -> T) -> Result<T> {
        let mut raw: sys::dQueryFilter = unsafe { std::mem::zeroed() };
        sure(|| unsafe { sys::dQueryFilterInit(&mut raw, std::mem::size_of::<sys::dQueryFilter>() as u32) });
        if let Some((category, collide)) = filter.bits {
            (raw.category_bits, raw.collide_bits) = (category as _, collide as _);
        }
        if let Some(body) = filter.skip_body {
            raw.skip_body = self.shared().body(body)?;
        }
        let Some(decide) = &filter.decide else { return call(|| query(&raw)) };
        let Ok(mut decide) = decide.try_borrow_mut() else {
            return Err(Error::refused("a query's filter is used by the query that calls it"));
        };
        let mut within = QueryCall { shared: self.shared(), decide: &mut **decide, panic: RefCell::new(None) };
        raw.callback = Some(query_filter);
        raw.data = std::ptr::from_mut(&mut within).cast();
        let result = call(|| query(&raw));
        if let Some(panic) = within.panic.into_inner() {
            std::panic::resume_unwind(panic);
        }
        result
    }

    /// The geom that a ray hits first: from `origin` in `direction` (of any length but 0) to the distance `length`.
    /// C: `dSpaceRayClosest`.
    pub fn ray(&self, origin: Vec3, direction: Vec3, length: Real, filter: &Filter<'_>) -> Result<Option<Hit>> {
        let (origin, direction, mut hit) = (pad3(origin), pad3(direction), empty());
        let (from, along) = (origin.as_ptr(), direction.as_ptr());
        self.filtered(filter, |f| unsafe { sys::dSpaceRayClosest(self.space(), from, along, length, f, &mut hit) })?;
        Ok(self.hit(&hit))
    }

    /// All geoms that a ray hits, the nearest first. C: `dSpaceRayAll`.
    pub fn ray_all(&self, origin: Vec3, direction: Vec3, length: Real, filter: &Filter<'_>) -> Result<Vec<Hit>> {
        let (origin, direction) = (pad3(origin), pad3(direction));
        let (from, along) = (origin.as_ptr(), direction.as_ptr());
        let hits = self
            .growing(filter, empty(), |f, to, capacity| unsafe { sys::dSpaceRayAll(self.space(), from, along, length, f, to, capacity) })?;
        Ok(hits.iter().filter_map(|hit| self.hit(hit)).collect())
    }

    /// Casts many rays at once, on so many threads (0: one for each processor): the hit of each. C: `dSpaceRayBatch`.
    pub fn ray_batch(
        &self,
        origins: &[Vec3],
        directions: &[Vec3],
        lengths: &[Real],
        filter: &Filter<'_>,
        threads: i32,
    ) -> Result<Vec<Option<Hit>>> {
        let count = i32::try_from(origins.len()).ok().filter(|_| origins.len() == directions.len() && origins.len() == lengths.len());
        let Some(count) = count else { return Self::refuse("each ray has an origin, a direction and a length") };
        let mut hits = vec![empty(); origins.len()];
        let (from, along, far, to) = (origins.as_ptr().cast(), directions.as_ptr().cast(), lengths.as_ptr(), hits.as_mut_ptr());
        self.filtered(filter, |f| unsafe { sys::dSpaceRayBatch(self.space(), count, from, along, far, f, to, threads) })?;
        Ok(hits.iter().map(|hit| self.hit(hit)).collect())
    }

    /// The geoms that touch or overlap a geom. C: `dSpaceOverlap`.
    pub fn overlaps(&self, geom: GeomId, filter: &Filter<'_>) -> Result<Vec<GeomId>> {
        let raw = self.shared().geom(geom)?;
        let found = self
            .growing(filter, std::ptr::null_mut(), |f, to, capacity| unsafe { sys::dSpaceOverlap(self.space(), raw, f, to, capacity) })?;
        Ok(found.into_iter().filter_map(|geom| self.shared().geom_of(geom)).collect())
    }

    /// What a convex geom hits first if it moves by `motion`, m, without turning. C: `dSpaceCast`.
    pub fn cast(&self, geom: GeomId, motion: Vec3, filter: &Filter<'_>) -> Result<Option<Hit>> {
        let (raw, motion, mut hit) = (self.shared().geom(geom)?, pad3(motion), empty());
        self.filtered(filter, |f| unsafe { sys::dSpaceCast(self.space(), raw, motion.as_ptr(), f, &mut hit) })?;
        Ok(self.hit(&hit))
    }

    /// The signed distance of two geoms, if it is at most `max_distance`. C: `dGeomGetDistance`.
    pub fn distance(&self, one: GeomId, other: GeomId, max_distance: Real) -> Result<Option<Distance>> {
        let (o1, o2) = (self.shared().geom(one)?, self.shared().geom(other)?);
        let mut raw: sys::dQueryDistance = unsafe { std::mem::zeroed() };
        let near = call(|| unsafe { sys::dGeomGetDistance(o1, o2, max_distance, &mut raw) })?;
        let found = Distance { distance: raw.distance, positions: [vec3(raw.pos1), vec3(raw.pos2)], normal: vec3(raw.normal) };
        Ok((near != 0).then_some(found))
    }

    /// A query whose results have no known number: asked again with more room while there are more. (A filter of the program may
    /// answer otherwise the second time.)
    fn growing<T: Copy>(
        &self,
        filter: &Filter<'_>,
        fill: T,
        query: impl Fn(*const sys::dQueryFilter, *mut T, i32) -> i32,
    ) -> Result<Vec<T>> {
        let mut all = vec![fill; 16];
        loop {
            let capacity = i32::try_from(all.len()).or_else(|_| Self::refuse("too many results"))?;
            let count = self.filtered(filter, |f| query(f, all.as_mut_ptr(), capacity))?.max(0) as usize;
            if count <= all.len() {
                all.truncate(count);
                return Ok(all);
            }
            all.resize(count, fill);
        }
    }
}
