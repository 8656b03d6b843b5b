// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by rust/tools/generate.py from the public headers.
#![allow(clippy::useless_conversion, clippy::unnecessary_cast, clippy::doc_lazy_continuation, clippy::doc_overindented_list_items)]
use crate::prelude::*;

impl Geom<'_> {
    /// The geom's position in the world: 3 reals, m.
    ///
    /// The pointer is valid until the geom is changed, moved to another body or destroyed.
    ///
    /// C: `dGeomGetPosition`.
    pub fn position(&self) -> Result<Vec3> {
        let r = call(|| unsafe { sys::dGeomGetPosition(self.raw()) })?;
        Ok(read_vec3(r))
    }

    /// The geom's rotation matrix in the world: 12 reals.
    ///
    /// The pointer is valid until the geom is changed, moved to another body or destroyed.
    ///
    /// C: `dGeomGetRotation`.
    pub fn rotation(&self) -> Result<Mat3> {
        let r = call(|| unsafe { sys::dGeomGetRotation(self.raw()) })?;
        Ok(read_mat3(r))
    }

    /// Write the geom's rotation in the world to result as a quaternion.
    ///
    /// The padding is not written.
    ///
    /// C: `dGeomGetQuaternion`.
    pub fn quaternion(&self) -> Result<Quat> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dGeomGetQuaternion(self.raw(), result.as_mut_ptr()) })?;
        Ok(same(result))
    }

    /// The bounding box aabb in the world, m: xmin, xmax, ymin, ymax, zmin, zmax. A space gives the box round its
    /// members.
    ///
    /// C: `dGeomGetAABB`.
    pub fn aabb(&self) -> [Real; 6] {
        let mut aabb: [Real; 6] = [0.0; 6];
        sure(|| unsafe { sys::dGeomGetAABB(self.raw(), aabb.as_mut_ptr()) });
        same(aabb)
    }

    /// The categories that the geom is in, one bit each.
    ///
    /// Spaces report two geoms when the category bits of one meet the collide bits of the other, in at least one
    /// direction.
    ///
    /// C: `dGeomGetCategoryBits`.
    pub fn category_bits(&self) -> u64 {
        let r = sure(|| unsafe { sys::dGeomGetCategoryBits(self.raw()) });
        r as u64
    }

    /// The categories with which the geom collides, one bit each.
    ///
    /// Spaces report two geoms when the category bits of one meet the collide bits of the other, in at least one
    /// direction.
    ///
    /// C: `dGeomGetCollideBits`.
    pub fn collide_bits(&self) -> u64 {
        let r = sure(|| unsafe { sys::dGeomGetCollideBits(self.raw()) });
        r as u64
    }

    /// 1 if spaces find the geom, 0 if they skip it.
    ///
    /// Spaces skip disabled geoms; dCollide does not. A body's own state does not matter.
    ///
    /// C: `dGeomIsEnabled`.
    pub fn is_enabled(&self) -> bool {
        let r = sure(|| unsafe { sys::dGeomIsEnabled(self.raw()) });
        r != 0
    }

    /// The position in the world of the point (px, py, pz) of the geom's frame, m.
    ///
    /// A geom without a pose (a plane, a space) gives the input back.
    ///
    /// C: `dGeomGetRelPointPos`; `point` is (px, py, pz).
    pub fn rel_point_pos(&self, point: Vec3) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dGeomGetRelPointPos(self.raw(), point[0], point[1], point[2], result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The coordinates in the geom's frame of the world's point (px, py, pz), m.
    ///
    /// A geom without a pose (a plane, a space) gives the input back.
    ///
    /// C: `dGeomGetPosRelPoint`; `point` is (px, py, pz).
    pub fn pos_rel_point(&self, point: Vec3) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dGeomGetPosRelPoint(self.raw(), point[0], point[1], point[2], result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The direction (px, py, pz) of the geom's frame, turned to the world's axes.
    ///
    /// A geom without a pose (a plane, a space) gives the input back.
    ///
    /// C: `dGeomVectorToWorld`; `point` is (px, py, pz).
    pub fn vector_to_world(&self, point: Vec3) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dGeomVectorToWorld(self.raw(), point[0], point[1], point[2], result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// The direction (px, py, pz) of the world, turned to the geom's axes.
    ///
    /// A geom without a pose (a plane, a space) gives the input back.
    ///
    /// C: `dGeomVectorFromWorld`; `point` is (px, py, pz).
    pub fn vector_from_world(&self, point: Vec3) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dGeomVectorFromWorld(self.raw(), point[0], point[1], point[2], result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// 1 when the geom has an offset, else 0.
    ///
    /// C: `dGeomIsOffset`.
    pub fn is_offset(&self) -> bool {
        let r = sure(|| unsafe { sys::dGeomIsOffset(self.raw()) });
        r != 0
    }

    /// The offset's position in the body's frame, 3 reals, m; zeros if
    /// there is no offset. Valid until the offset is changed.
    ///
    /// C: `dGeomGetOffsetPosition`.
    pub fn offset_position(&self) -> Result<Vec3> {
        let r = call(|| unsafe { sys::dGeomGetOffsetPosition(self.raw()) })?;
        Ok(read_vec3(r))
    }

    /// The offset's rotation matrix, from the geom's frame to the body's,
    /// 12 reals; the identity if there is no offset. Valid until the offset is changed.
    ///
    /// C: `dGeomGetOffsetRotation`.
    pub fn offset_rotation(&self) -> Result<Mat3> {
        let r = call(|| unsafe { sys::dGeomGetOffsetRotation(self.raw()) })?;
        Ok(read_mat3(r))
    }

    /// Write the offset's rotation, from the geom's frame to the body's, to result
    /// as a quaternion; the identity if there is no offset.
    ///
    /// C: `dGeomGetOffsetQuaternion`.
    pub fn offset_quaternion(&self) -> Result<Quat> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dGeomGetOffsetQuaternion(self.raw(), result.as_mut_ptr()) })?;
        Ok(same(result))
    }

    /// The sphere's radius, m.
    ///
    /// C: `dGeomSphereGetRadius`.
    pub fn sphere_radius(&self) -> Result<Real> {
        call(|| unsafe { sys::dGeomSphereGetRadius(self.raw()) })
    }

    /// How deep the world's point (x, y, z) is inside the sphere, m: positive inside, 0
    /// on the surface, negative outside.
    ///
    /// C: `dGeomSpherePointDepth`; `xyz` is (x, y, z).
    pub fn sphere_point_depth(&self, xyz: Vec3) -> Result<Real> {
        call(|| unsafe { sys::dGeomSpherePointDepth(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Write the box's full side lengths to result: 3 reals, m.
    ///
    /// C: `dGeomBoxGetLengths`.
    pub fn box_lengths(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dGeomBoxGetLengths(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// How deep a point is inside the box: the distance to the nearest face, negative outside.
    ///
    /// C: `dGeomBoxPointDepth`; `xyz` is (x, y, z).
    pub fn box_point_depth(&self, xyz: Vec3) -> Result<Real> {
        call(|| unsafe { sys::dGeomBoxPointDepth(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Write the plane's unit outward normal and its distance from the origin along it,
    /// m, to result: 4 reals.
    ///
    /// C: `dGeomPlaneGetParams`.
    pub fn plane_params(&self) -> Result<[Real; 4]> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dGeomPlaneGetParams(self.raw(), result.as_mut_ptr()) })?;
        Ok(same(result))
    }

    /// How deep the world's point (x, y, z) is below the plane's surface, m: positive
    /// inside the solid half-space, 0 on the surface, negative outside.
    ///
    /// C: `dGeomPlanePointDepth`; `xyz` is (x, y, z).
    pub fn plane_point_depth(&self, xyz: Vec3) -> Result<Real> {
        call(|| unsafe { sys::dGeomPlanePointDepth(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Write the capsule's radius to \*radius and its length to \*length, m.
    ///
    /// The length leaves out the round caps.
    ///
    /// C: `dGeomCapsuleGetParams`.
    pub fn capsule_params(&self) -> Result<(Real, Real)> {
        let mut radius: Real = Default::default();
        let mut length: Real = Default::default();
        call(|| unsafe { sys::dGeomCapsuleGetParams(self.raw(), &mut radius, &mut length) })?;
        Ok((radius, length))
    }

    /// How deep the world's point (x, y, z) is inside the capsule, m: positive inside,
    /// 0 on the surface, negative outside.
    ///
    /// The length leaves out the round caps.
    ///
    /// C: `dGeomCapsulePointDepth`; `xyz` is (x, y, z).
    pub fn capsule_point_depth(&self, xyz: Vec3) -> Result<Real> {
        call(|| unsafe { sys::dGeomCapsulePointDepth(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Write the cylinder's radius to \*radius and its length to \*length, m.
    ///
    /// C: `dGeomCylinderGetParams`.
    pub fn cylinder_params(&self) -> Result<(Real, Real)> {
        let mut radius: Real = Default::default();
        let mut length: Real = Default::default();
        call(|| unsafe { sys::dGeomCylinderGetParams(self.raw(), &mut radius, &mut length) })?;
        Ok((radius, length))
    }

    /// How many triangles there are, those without area included; 0 without data.
    ///
    /// C: `dGeomTriMeshGetTriangleCount`.
    pub fn mesh_triangle_count(&self) -> Result<i32> {
        call(|| unsafe { sys::dGeomTriMeshGetTriangleCount(self.raw()) })
    }

    /// Write the point (1 - u - v) a + u b + v c of triangle Index of the mesh g,
    /// with its corners a, b, c in the world, m, to Out.
    ///
    /// C: `dGeomTriMeshGetPoint`.
    pub fn mesh_point(&self, index: i32, u: Real, v: Real) -> Result<Vec3> {
        let mut out: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dGeomTriMeshGetPoint(self.raw(), index, u, v, out.as_mut_ptr()) })?;
        Ok(vec3(out))
    }

    /// Returns 1 if the geom is a character, else 0.
    ///
    /// C: `dGeomIsCharacter`.
    pub fn is_character(&self) -> bool {
        let r = sure(|| unsafe { sys::dGeomIsCharacter(self.raw()) });
        r != 0
    }

    /// Write the position to feet. Returns 1.
    ///
    /// The position of the feet, m.
    ///
    /// C: `dCharacterGetPosition`.
    pub fn character_position(&self) -> Result<Vec3> {
        let mut feet: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dCharacterGetPosition(self.raw(), feet.as_mut_ptr()) })?;
        Ok(vec3(feet))
    }

    /// Write how it has moved in the last move to velocity. Returns 1.
    ///
    /// The velocity.
    ///
    /// C: `dCharacterGetVelocity`.
    pub fn character_velocity(&self) -> Result<Vec3> {
        let mut velocity: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dCharacterGetVelocity(self.raw(), velocity.as_mut_ptr()) })?;
        Ok(vec3(velocity))
    }

    /// Write what the last move has done to \*report, whose struct\_size the caller has set. Returns 1.
    ///
    /// C: `dCharacterGetReport`.
    pub fn character_report(&self) -> Result<CharacterReport> {
        let mut report = CharacterReport::empty();
        call(|| unsafe { sys::dCharacterGetReport(self.raw(), &mut report) })?;
        Ok(CharacterReport::from_raw(&report, self.shared()))
    }

    /// Copy the geom's material to \*material, the default if it has none. Returns 1.
    ///
    /// A program whose dMaterial has fewer fields than the library's keeps working: the others have their
    /// defaults. Refused: a structure smaller than one that has friction alone, or larger than this library's.
    ///
    /// C: `dGeomGetMaterial`.
    pub fn material(&self) -> Material {
        let mut material = Material::empty();
        sure(|| unsafe { sys::dGeomGetMaterial(self.raw(), &mut material) });
        Material::from_raw(&material, self.shared())
    }

    /// Copy that material, or the default material if there is none, to \*material.
    /// Returns 1.
    ///
    /// Materials by number. Those of the faces of a geom: the triangles of a mesh, in their order, or the cells of a
    /// height field, cell (i, j) by i + j (samples along the first axis - 1); world-managed contacts take the
    /// material of the face that is nearest to the contact. Of any geom, those of pairs: against a geom whose
    /// material has that number as its kind, the numbered one alone says friction, bounce, rolling friction and
    /// compliance. Clones and files of worlds have them.
    ///
    /// C: `dGeomGetFaceMaterial`.
    pub fn face_material(&self, number: i32) -> Result<Material> {
        let mut material = Material::empty();
        call(|| unsafe { sys::dGeomGetFaceMaterial(self.raw(), number, &mut material) })?;
        Ok(Material::from_raw(&material, self.shared()))
    }

    /// 1 if the geom is a sensor, else 0.
    ///
    /// C: `dGeomGetSensor`.
    pub fn sensor(&self) -> bool {
        let r = sure(|| unsafe { sys::dGeomGetSensor(self.raw()) });
        r != 0
    }

    /// Write the cone's radius to \*radius and its length to \*length, m.
    ///
    /// C: `dGeomConeGetParams`.
    pub fn cone_params(&self) -> Result<(Real, Real)> {
        let mut radius: Real = Default::default();
        let mut length: Real = Default::default();
        call(|| unsafe { sys::dGeomConeGetParams(self.raw(), &mut radius, &mut length) })?;
        Ok((radius, length))
    }

    /// Return how deep the world's point (x, y, z) is inside the cone, m.
    ///
    /// C: `dGeomConePointDepth`; `xyz` is (x, y, z).
    pub fn cone_point_depth(&self, xyz: Vec3) -> Result<Real> {
        call(|| unsafe { sys::dGeomConePointDepth(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Write the ellipsoid's radii to result, 3 reals, m.
    ///
    /// C: `dGeomEllipsoidGetRadii`.
    pub fn ellipsoid_radii(&self) -> Result<Vec3> {
        let mut result: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dGeomEllipsoidGetRadii(self.raw(), result.as_mut_ptr()) })?;
        Ok(vec3(result))
    }

    /// Return how deep the world's point (x, y, z) is inside the ellipsoid: the
    /// distance from its surface, m. Refused: an ellipsoid with a radius of 0.
    ///
    /// C: `dGeomEllipsoidPointDepth`; `xyz` is (x, y, z).
    pub fn ellipsoid_point_depth(&self, xyz: Vec3) -> Result<Real> {
        call(|| unsafe { sys::dGeomEllipsoidPointDepth(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Write the geom's radii to \*r1 and \*r2 and its length to \*length, m.
    ///
    /// C: `dGeomTaperedCapsuleGetParams`.
    pub fn tapered_capsule_params(&self) -> Result<(Real, Real, Real)> {
        let mut r1: Real = Default::default();
        let mut r2: Real = Default::default();
        let mut length: Real = Default::default();
        call(|| unsafe { sys::dGeomTaperedCapsuleGetParams(self.raw(), &mut r1, &mut r2, &mut length) })?;
        Ok((r1, r2, length))
    }

    /// Return how deep the world's point (x, y, z) is inside the geom, m.
    ///
    /// C: `dGeomTaperedCapsulePointDepth`; `xyz` is (x, y, z).
    pub fn tapered_capsule_point_depth(&self, xyz: Vec3) -> Result<Real> {
        call(|| unsafe { sys::dGeomTaperedCapsulePointDepth(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// The mode that dGeomSetContinuous has set, dContinuousOff at first.
    ///
    /// C: `dGeomGetContinuous`.
    pub fn continuous(&self) -> Continuous {
        let r = sure(|| unsafe { sys::dGeomGetContinuous(self.raw()) });
        let r = r as i32;
        Continuous::of_number(r)
    }

    /// 1 if the mesh is a solid now, else 0: data that are not closed make it a surface
    /// for as long as it has them.
    ///
    /// C: `dGeomTriMeshGetSolid`.
    pub fn mesh_solid(&self) -> Result<i32> {
        call(|| unsafe { sys::dGeomTriMeshGetSolid(self.raw()) })
    }
}

impl GeomMut<'_> {
    /// Set the geom's position in the world to (x, y, z), m.
    ///
    /// On a body with an offset the body is moved so that the geom gets there.
    ///
    /// C: `dGeomSetPosition`; `xyz` is (x, y, z).
    pub fn set_position(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dGeomSetPosition(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the geom's rotation in the world to the matrix R, from the geom's frame to the
    /// world's.
    ///
    /// On a body with an offset the body is moved so that the geom gets there.
    ///
    /// C: `dGeomSetRotation`.
    pub fn set_rotation(&mut self, r: Mat3) -> Result<()> {
        let r = pad33(r);
        call(|| unsafe { sys::dGeomSetRotation(self.raw(), r.as_ptr()) })
    }

    /// Set the geom's rotation in the world to the quaternion Q, of any length but zero.
    ///
    /// On a body with an offset the body is moved so that the geom gets there.
    ///
    /// C: `dGeomSetQuaternion`.
    pub fn set_quaternion(&mut self, q: Quat) -> Result<()> {
        let q = same(q);
        call(|| unsafe { sys::dGeomSetQuaternion(self.raw(), q.as_ptr()) })
    }

    /// Set the categories that the geom is in, one bit each; default: all.
    ///
    /// Spaces report two geoms when the category bits of one meet the collide bits of the other, in at least one
    /// direction.
    ///
    /// C: `dGeomSetCategoryBits`.
    pub fn set_category_bits(&mut self, bits: u64) -> Result<()> {
        call(|| unsafe { sys::dGeomSetCategoryBits(self.raw(), bits as _) })
    }

    /// Set the categories with which the geom collides, one bit each; default: all.
    ///
    /// Spaces report two geoms when the category bits of one meet the collide bits of the other, in at least one
    /// direction.
    ///
    /// C: `dGeomSetCollideBits`.
    pub fn set_collide_bits(&mut self, bits: u64) -> Result<()> {
        call(|| unsafe { sys::dGeomSetCollideBits(self.raw(), bits as _) })
    }

    /// Let spaces find the geom again. New geoms are enabled.
    ///
    /// Spaces skip disabled geoms; dCollide does not. A body's own state does not matter.
    ///
    /// C: `dGeomEnable`.
    pub fn enable(&mut self) -> Result<()> {
        call(|| unsafe { sys::dGeomEnable(self.raw()) })
    }

    /// Let spaces skip the geom until dGeomEnable.
    ///
    /// Spaces skip disabled geoms; dCollide does not. A body's own state does not matter.
    ///
    /// C: `dGeomDisable`.
    pub fn disable(&mut self) -> Result<()> {
        call(|| unsafe { sys::dGeomDisable(self.raw()) })
    }

    /// Set the offset's position to (x, y, z), m, in the body's frame; its rotation
    /// stays.
    ///
    /// C: `dGeomSetOffsetPosition`; `xyz` is (x, y, z).
    pub fn set_offset_position(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dGeomSetOffsetPosition(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the offset's rotation to the matrix R, from the geom's frame to the body's;
    /// its position stays.
    ///
    /// C: `dGeomSetOffsetRotation`.
    pub fn set_offset_rotation(&mut self, r: Mat3) -> Result<()> {
        let r = pad33(r);
        call(|| unsafe { sys::dGeomSetOffsetRotation(self.raw(), r.as_ptr()) })
    }

    /// Set the offset's rotation to the quaternion Q, of any length but zero, from
    /// the geom's frame to the body's; its position stays.
    ///
    /// C: `dGeomSetOffsetQuaternion`.
    pub fn set_offset_quaternion(&mut self, q: Quat) -> Result<()> {
        let q = same(q);
        call(|| unsafe { sys::dGeomSetOffsetQuaternion(self.raw(), q.as_ptr()) })
    }

    /// Set the offset's position so that the geom is at the world's point (x, y,
    /// z), m, now; the body and the offset's rotation stay.
    ///
    /// C: `dGeomSetOffsetWorldPosition`; `xyz` is (x, y, z).
    pub fn set_offset_world_position(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dGeomSetOffsetWorldPosition(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the offset's rotation so that the geom has the rotation matrix R in
    /// the world now; the body and the offset's position stay.
    ///
    /// C: `dGeomSetOffsetWorldRotation`.
    pub fn set_offset_world_rotation(&mut self, r: Mat3) -> Result<()> {
        let r = pad33(r);
        call(|| unsafe { sys::dGeomSetOffsetWorldRotation(self.raw(), r.as_ptr()) })
    }

    /// Set the offset's rotation so that the geom has the rotation Q in the
    /// world now, a quaternion of any length but zero; the body and the offset's position stay.
    ///
    /// C: `dGeomSetOffsetWorldQuaternion`.
    pub fn set_offset_world_quaternion(&mut self, q: Quat) -> Result<()> {
        let q = same(q);
        call(|| unsafe { sys::dGeomSetOffsetWorldQuaternion(self.raw(), q.as_ptr()) })
    }

    /// Drop the offset: the geom goes to the body's pose.
    ///
    /// C: `dGeomClearOffset`.
    pub fn clear_offset(&mut self) -> Result<()> {
        call(|| unsafe { sys::dGeomClearOffset(self.raw()) })
    }

    /// Set the sphere's radius, m.
    ///
    /// C: `dGeomSphereSetRadius`.
    pub fn set_sphere_radius(&mut self, radius: Real) -> Result<()> {
        call(|| unsafe { sys::dGeomSphereSetRadius(self.raw(), radius) })
    }

    /// Set the box's full side lengths to lx, ly, lz, m.
    ///
    /// C: `dGeomBoxSetLengths`; `lengths` is (lx, ly, lz).
    pub fn set_box_lengths(&mut self, lengths: Vec3) -> Result<()> {
        call(|| unsafe { sys::dGeomBoxSetLengths(self.raw(), lengths[0], lengths[1], lengths[2]) })
    }

    /// Set the plane to the half-space a x + b y + c z \<= d of the world; the four
    /// numbers are divided by the length of the outward normal (a, b, c), and a zero normal becomes (1, 0, 0)
    /// with d = 0.
    ///
    /// C: `dGeomPlaneSetParams`.
    pub fn set_plane_params(&mut self, a: Real, b: Real, c: Real, d: Real) -> Result<()> {
        call(|| unsafe { sys::dGeomPlaneSetParams(self.raw(), a, b, c, d) })
    }

    /// Set the capsule's radius and length, m.
    ///
    /// The length leaves out the round caps.
    ///
    /// C: `dGeomCapsuleSetParams`.
    pub fn set_capsule_params(&mut self, radius: Real, length: Real) -> Result<()> {
        call(|| unsafe { sys::dGeomCapsuleSetParams(self.raw(), radius, length) })
    }

    /// Set the cylinder's radius and length, m.
    ///
    /// C: `dGeomCylinderSetParams`.
    pub fn set_cylinder_params(&mut self, radius: Real, length: Real) -> Result<()> {
        call(|| unsafe { sys::dGeomCylinderSetParams(self.raw(), radius, length) })
    }

    /// Change the height (m) while the feet stay where they are: to crouch and to stand up. Returns 1; 0 if there
    /// is no room above, or no height that the shape can have.
    ///
    /// C: `dCharacterSetHeight`.
    pub fn set_character_height(&mut self, height: Real) -> Result<bool> {
        let r = call(|| unsafe { sys::dCharacterSetHeight(self.raw(), height) })?;
        Ok(r != 0)
    }

    /// Put the feet at (x, y, z), whatever is there; it stands on nothing then.
    ///
    /// The position of the feet, m.
    ///
    /// C: `dCharacterSetPosition`; `xyz` is (x, y, z).
    pub fn set_character_position(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dCharacterSetPosition(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Move the character for a step of h seconds with a velocity that the program has worked out, gravity
    /// included: the ground carries it first, then it collides and slides. On ground it keeps the horizontal part
    /// of the velocity, uphill and downhill, unless the velocity leads away from the ground. Call it once for each
    /// dWorldStep, after it: what carries it has moved then. Called before, it lags by the ground's motion in that
    /// one step. Returns the dCharacterState. Refused: a velocity above 1e4 m/s.
    ///
    /// C: `dCharacterMove`.
    pub fn character_move(&mut self, velocity: Vec3, h: Real) -> Result<CharacterState> {
        let velocity = pad3(velocity);
        let r = call(|| unsafe { sys::dCharacterMove(self.raw(), velocity.as_ptr(), h) })?;
        self.finish();
        let r = r as i32;
        Ok(CharacterState::of_number(r))
    }

    /// Walk: as dCharacterMove, but with gravity, falls and jumps. velocity is how it wants to go, relative to the
    /// ground; of it the part along up does not count. jump\_speed (m/s) above 0 lets it jump if it stands: to the
    /// height jump\_speed^2 / (2 gravity), whatever h. In the air it turns with air\_acceleration. Returns the
    /// dCharacterState. Refused: a jump\_speed below 0 or above 1e4.
    ///
    /// C: `dCharacterWalk`.
    pub fn character_walk(&mut self, velocity: Vec3, jump_speed: Real, h: Real) -> Result<CharacterState> {
        let velocity = pad3(velocity);
        let r = call(|| unsafe { sys::dCharacterWalk(self.raw(), velocity.as_ptr(), jump_speed, h) })?;
        self.finish();
        let r = r as i32;
        Ok(CharacterState::of_number(r))
    }

    /// Give it a velocity, as a blow or a spring board does: dCharacterWalk goes on from
    /// it, and leaves the ground if it leads upward.
    ///
    /// The velocity.
    ///
    /// C: `dCharacterSetVelocity`.
    pub fn set_character_velocity(&mut self, velocity: Vec3) -> Result<()> {
        let velocity = pad3(velocity);
        call(|| unsafe { sys::dCharacterSetVelocity(self.raw(), velocity.as_ptr()) })
    }

    /// Give the geom a copy of \*material from the next step on; 0: the default again.
    /// Returns 1. Refused: coefficients below 0; a bounce above 1; infinite rolling friction, compliance or
    /// damping time; unknown rules; a priority beyond a million; a kind outside 0 ... 255.
    ///
    /// A program whose dMaterial has fewer fields than the library's keeps working: the others have their
    /// defaults. Refused: a structure smaller than one that has friction alone, or larger than this library's.
    ///
    /// C: `dGeomSetMaterial`.
    pub fn set_material(&mut self, material: Option<&Material>) -> Result<()> {
        let material = material.map(Material::to_raw);
        call(|| unsafe { sys::dGeomSetMaterial(self.raw(), material.as_ref().map_or(std::ptr::null(), std::ptr::from_ref)); })
    }

    /// Give the geom a copy of \*material as its material of that number (1 ... 255), from
    /// the next step on; 0 removes it. Returns 1. Refused: another number; what dGeomSetMaterial refuses.
    ///
    /// Materials by number. Those of the faces of a geom: the triangles of a mesh, in their order, or the cells of a
    /// height field, cell (i, j) by i + j (samples along the first axis - 1); world-managed contacts take the
    /// material of the face that is nearest to the contact. Of any geom, those of pairs: against a geom whose
    /// material has that number as its kind, the numbered one alone says friction, bounce, rolling friction and
    /// compliance. Clones and files of worlds have them.
    ///
    /// C: `dGeomSetFaceMaterial`.
    pub fn set_face_material(&mut self, number: i32, material: Option<&Material>) -> Result<()> {
        let material = material.map(Material::to_raw);
        call(|| unsafe { sys::dGeomSetFaceMaterial(self.raw(), number, material.as_ref().map_or(std::ptr::null(), std::ptr::from_ref)); })
    }

    /// Make the geom a sensor (mode 1) or an ordinary geom (mode 0, the default). World-managed
    /// contacts and continuous collision pass through a sensor; sensor events report the geoms that overlap it
    /// at the end of each step, asleep or not, if their bits agree, they or the sensor have a body of the world or they are characters,
    /// and they are not of one body. Sensors and rays are not reported. dSpaceCollide, dCollide and queries
    /// treat it as any geom: a near callback leaves it out by dGeomGetSensor. Refused: a geom that is a space or in
    /// a space that is being collided; other modes.
    ///
    /// C: `dGeomSetSensor`.
    pub fn set_sensor(&mut self, mode: bool) -> Result<()> {
        call(|| unsafe { sys::dGeomSetSensor(self.raw(), i32::from(mode)) })
    }

    /// Set the cone's radius and length, m.
    ///
    /// C: `dGeomConeSetParams`.
    pub fn set_cone_params(&mut self, radius: Real, length: Real) -> Result<()> {
        call(|| unsafe { sys::dGeomConeSetParams(self.raw(), radius, length) })
    }

    /// Set the ellipsoid's radii along its own axes, m.
    ///
    /// C: `dGeomEllipsoidSetRadii`; `radii` is (rx, ry, rz).
    pub fn set_ellipsoid_radii(&mut self, radii: Vec3) -> Result<()> {
        call(|| unsafe { sys::dGeomEllipsoidSetRadii(self.raw(), radii[0], radii[1], radii[2]) })
    }

    /// Set the geom's radii and length, m; the centre of mass stays the origin.
    ///
    /// C: `dGeomTaperedCapsuleSetParams`.
    pub fn set_tapered_capsule_params(&mut self, r1: Real, r2: Real, length: Real) -> Result<()> {
        call(|| unsafe { sys::dGeomTaperedCapsuleSetParams(self.raw(), r1, r2, length) })
    }

    /// Choose whether a fast geom stops at what it would have passed: mode is one of
    /// dContinuousMode, dContinuousOff by default. If the geom would go deeper than an eighth of its
    /// thickness into another one, its body stands still, for the rest of the step, from the moment when they
    /// met; velocities are kept. dWorldStepReport::stopped\_bodies counts. Which geoms are met:
    /// docs/guide/shapes.md. Refused: other modes; dContinuousOn for a geom that is neither sphere, box,
    /// capsule, cylinder, convex, mesh nor a transform.
    ///
    /// C: `dGeomSetContinuous`.
    pub fn set_continuous(&mut self, mode: Continuous) -> Result<()> {
        call(|| unsafe { sys::dGeomSetContinuous(self.raw(), mode.number()) })
    }

    /// Make the mesh the solid that its triangles enclose (solid 1) or, as in ODE and
    /// by default, their surface (0). A convex solid whose centre is inside a solid mesh is pushed out by the
    /// shortest way, however deep it is. docs/guide/shapes.md tells what other geoms and queries see.
    /// Refused: other values of solid; 1 for a mesh that is not closed (a triangle without a neighbour over
    /// an edge, or wound the other way) or that faces inward.
    ///
    /// C: `dGeomTriMeshSetSolid`.
    pub fn set_mesh_solid(&mut self, solid: i32) -> Result<()> {
        call(|| unsafe { sys::dGeomTriMeshSetSolid(self.raw(), solid) })
    }
}
