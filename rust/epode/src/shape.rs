// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Shapes: what a geom is made from. Triangles and heights are copied by the library when the geom is made; their data belong to that
// geom alone and are destroyed after it.
use crate::error::made;
use crate::prelude::*;
use std::mem::size_of;

/// A shape. Lengths are in m, full ones: a box of lengths 1, 1, 1 is a cube of 1 m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<'a> {
    /// A ball.
    Sphere {
        /// m.
        radius: Real,
    },
    /// A box.
    Box {
        /// Full lengths of the sides, m.
        lengths: Vec3,
    },
    /// A cylinder with a half ball at each end, along z.
    Capsule {
        /// m.
        radius: Real,
        /// Of the cylinder, without the half balls.
        length: Real,
    },
    /// A cylinder along z.
    Cylinder {
        /// m.
        radius: Real,
        /// m.
        length: Real,
    },
    /// A cone along z, its origin the centre of mass.
    Cone {
        /// Of the base, m.
        radius: Real,
        /// From the base to the apex, m.
        length: Real,
    },
    /// An ellipsoid.
    Ellipsoid {
        /// Half the lengths along x, y and z, m.
        radii: Vec3,
    },
    /// The hull of two balls on z; its origin is the centre of mass.
    TaperedCapsule {
        /// Of the lower ball, m.
        r1: Real,
        /// Of the upper ball, m.
        r2: Real,
        /// Distance of the balls' centres, m.
        length: Real,
    },
    /// Everything with normal . p <= distance: ground. It has no pose and belongs to no body.
    Plane {
        /// Of any length but 0.
        normal: Vec3,
        /// m.
        distance: Real,
    },
    /// The convex hull of points.
    Hull {
        /// In any order, m.
        points: &'a [Vec3],
    },
    /// Triangles, their corners counter-clockwise from outside.
    Mesh {
        /// m.
        vertices: &'a [Vec3],
        /// Numbers of vertices.
        triangles: &'a [[u32; 3]],
    },
    /// Ground given by heights on a grid, along y: the grid lies in x and z, its centre at the origin.
    Heights {
        /// Row by row (x runs fastest), m.
        heights: &'a [Real],
        /// Samples along x.
        columns: usize,
        /// Samples along z.
        rows: usize,
        /// Of the whole field along x, m.
        width: Real,
        /// Of the whole field along z, m.
        depth: Real,
    },
}

impl Shape<'static> {
    /// The plane z = 0 with everything below.
    pub fn ground() -> Self {
        Self::Plane { normal: [0.0, 0.0, 1.0], distance: 0.0 }
    }
    /// A cube.
    pub fn cube(side: Real) -> Self {
        Self::Box { lengths: [side; 3] }
    }
}

fn count(length: usize) -> Result<i32> {
    i32::try_from(length).or_else(|_| World::refuse("more than 2^31 - 1 elements"))
}

impl Shape<'_> {
    /// A new geom in the space, with the data that it needs.
    pub(crate) fn create(&self, space: sys::dSpaceID) -> Result<(sys::dGeomID, Option<Data>)> {
        let without = |geom| (geom, None);
        match *self {
            Shape::Sphere { radius } => made(|| unsafe { sys::dCreateSphere(space, radius) }).map(without),
            Shape::Box { lengths: [x, y, z] } => made(|| unsafe { sys::dCreateBox(space, x, y, z) }).map(without),
            Shape::Capsule { radius, length } => made(|| unsafe { sys::dCreateCapsule(space, radius, length) }).map(without),
            Shape::Cylinder { radius, length } => made(|| unsafe { sys::dCreateCylinder(space, radius, length) }).map(without),
            Shape::Cone { radius, length } => made(|| unsafe { sys::dCreateCone(space, radius, length) }).map(without),
            Shape::Ellipsoid { radii: [x, y, z] } => made(|| unsafe { sys::dCreateEllipsoid(space, x, y, z) }).map(without),
            Shape::TaperedCapsule { r1, r2, length } => made(|| unsafe { sys::dCreateTaperedCapsule(space, r1, r2, length) }).map(without),
            Shape::Plane { normal: [a, b, c], distance } => made(|| unsafe { sys::dCreatePlane(space, a, b, c, distance) }).map(without),
            Shape::Hull { points } => {
                let (pointer, number) = (points.as_ptr().cast(), count(points.len())? as u32);
                made(|| unsafe { sys::dCreateConvexHull(space, pointer, number, 0) }).map(without)
            }
            Shape::Mesh { vertices, triangles } => Self::mesh(space, vertices, triangles),
            Shape::Heights { heights, columns, rows, width, depth } => Self::heights(space, heights, [columns, rows], [width, depth]),
        }
    }

    fn mesh(space: sys::dSpaceID, vertices: &[Vec3], triangles: &[[u32; 3]]) -> Result<(sys::dGeomID, Option<Data>)> {
        let numbers = count(triangles.len().saturating_mul(3))?;
        let corners = count(vertices.len())?;
        let (strides, raw) = ([size_of::<Vec3>() as i32, size_of::<[u32; 3]>() as i32], made(|| unsafe { sys::dGeomTriMeshDataCreate() })?);
        let data = Data::Mesh(raw);
        #[cfg(not(feature = "single"))]
        let build = sys::dGeomTriMeshDataBuildDouble;
        #[cfg(feature = "single")]
        let build = sys::dGeomTriMeshDataBuildSingle;
        let (from, of) = (vertices.as_ptr().cast(), triangles.as_ptr().cast());
        call(|| unsafe { build(raw, from, strides[0], corners, of, numbers, strides[1]) })?;
        let geom = made(|| unsafe { sys::dCreateTriMesh(space, raw, None, None, None) })?;
        Ok((geom, Some(data)))
    }

    fn heights(space: sys::dSpaceID, heights: &[Real], samples: [usize; 2], size: [Real; 2]) -> Result<(sys::dGeomID, Option<Data>)> {
        if samples[0].checked_mul(samples[1]) != Some(heights.len()) {
            return World::refuse("a height field has columns times rows heights");
        }
        let (columns, rows) = (count(samples[0])?, count(samples[1])?);
        let raw = made(|| unsafe { sys::dGeomHeightfieldDataCreate() })?;
        let data = Data::Heights(raw);
        #[cfg(not(feature = "single"))]
        let build = sys::dGeomHeightfieldDataBuildDouble;
        #[cfg(feature = "single")]
        let build = sys::dGeomHeightfieldDataBuildSingle;
        call(|| unsafe { build(raw, heights.as_ptr(), 1, size[0], size[1], columns, rows, 1.0, 0.0, 0.0, 0) })?;
        let geom = made(|| unsafe { sys::dCreateHeightfield(space, raw, 1) })?;
        Ok((geom, Some(data)))
    }

    /// The mass of the shape as it is, about the origin of its frame. What has no volume has none.
    pub(crate) fn mass(&self, geom: sys::dGeomID, density: Real) -> Result<sys::dMass> {
        let mut mass = sys::dMass { mass: 0.0, c: [0.0; 4], I: [0.0; 12] };
        let m = &mut mass;
        call(|| unsafe {
            match *self {
                Shape::Sphere { radius } => sys::dMassSetSphere(m, density, radius),
                Shape::Box { lengths: [x, y, z] } => sys::dMassSetBox(m, density, x, y, z),
                Shape::Capsule { radius, length } => sys::dMassSetCapsule(m, density, 3, radius, length),
                Shape::Cylinder { radius, length } => sys::dMassSetCylinder(m, density, 3, radius, length),
                Shape::Cone { radius, length } => sys::dMassSetCone(m, density, 3, radius, length),
                Shape::Ellipsoid { radii: [x, y, z] } => sys::dMassSetEllipsoid(m, density, x, y, z),
                Shape::TaperedCapsule { r1, r2, length } => sys::dMassSetTaperedCapsule(m, density, 3, r1, r2, length),
                Shape::Hull { .. } => sys::dMassSetConvex(m, density, geom),
                Shape::Mesh { .. } => sys::dMassSetTrimesh(m, density, geom),
                Shape::Plane { .. } | Shape::Heights { .. } => {}
            }
        })?;
        Ok(mass)
    }
}

/// Triangles or heights of a geom: destroyed when this is dropped.
#[derive(Debug)]
pub(crate) enum Data {
    Mesh(sys::dTriMeshDataID),
    Heights(sys::dHeightfieldDataID),
}

impl Data {
    /// The address of those that a live geom of the library has, and what makes them this crate's: once for an address.
    ///
    /// # Safety
    /// The geom is alive.
    pub unsafe fn of(geom: sys::dGeomID) -> Option<(usize, impl FnOnce() -> Self)> {
        let class = sys::dGeomGetClass(geom);
        let data = match class {
            sys::dTriMeshClass => Self::address(sys::dGeomTriMeshGetData(geom)),
            sys::dHeightfieldClass => Self::address(sys::dGeomHeightfieldGetHeightfieldData(geom)),
            _ => 0,
        };
        let make = move || if class == sys::dTriMeshClass { Self::Mesh(data as _) } else { Self::Heights(data as _) };
        (data != 0).then_some((data, make))
    }
    fn address<T>(pointer: *mut T) -> usize {
        pointer as usize
    }
}

impl Drop for Data {
    fn drop(&mut self) {
        let _ = call(|| unsafe {
            match *self {
                Self::Mesh(data) => sys::dGeomTriMeshDataDestroy(data),
                Self::Heights(data) => sys::dGeomHeightfieldDataDestroy(data),
            }
        });
    }
}
