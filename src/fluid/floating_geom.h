// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A geom as fluids see it. Only what encloses a volume floats: boxes, round solids (SolidType::round_solid), convex hulls, closed
// meshes. Of a mesh every triangle is looked at, so its cost is proportional to their number.
#pragma once

#include "collide/geom.h"
#include "geometry/hulls/polyhedron.h"
#include "geometry/immersion/revolved_solid.h"
#include "geometry/triangle_mesh.h"

namespace epode {

class FloatingGeom {
  public:
    // False: it does not float.
    bool take(Geom& geom);

    const Pose& pose() const { return pose_; }  // of the frame that the others refer to
    Vec3 half_extent() const { return half_; }
    Vec3 middle() const { return middle_; }  // of its box, in that frame
    Vec3 place() const { return pose_.to_world(middle_); }

    Immersed whole() const;
    Immersed under(const WaterPlane& half) const;  // in that frame
    // How large its shadow along a unit vector of that frame is; of meshes with hollows, of all that look that way.
    Real shadow(Vec3 direction) const;

  private:
    enum class Kind : unsigned char { kBox, kRound, kPolyhedron, kMesh };

    void take_polyhedron(const Polyhedron& solid, const Pose& pose);
    template <typename Visit>
    void for_each_face(Visit&& visit) const;  // visit(count of corners, function that gives a corner)

    Kind kind_ = Kind::kBox;
    Pose pose_;
    Vec3 half_, middle_;
    RevolvedSolid round_;
    const Polyhedron* solid_ = nullptr;
    const TriangleMesh* mesh_ = nullptr;
};

// Is the place (world) in the geom? Of a class that cannot bound a fluid: no. A stale pose must have been refreshed.
bool bounds_fluids(const Geom& geom);
bool contains(Geom& geom, Vec3 place);

}  // namespace epode
