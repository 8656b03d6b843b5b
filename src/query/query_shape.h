// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A geom as distance queries see it: the geom inside all transforms, its pose, and its kind; geoms of one
// kind are treated alike. Rays count as solids: segments cut to the length that reaches the other geom.
#pragma once

#include "collide/geom.h"
#include "collide/types/registry.h"
#include "query/separation.h"
#include "query/triangle_set.h"

namespace epode {

enum class QueryKind { kSolid, kPlane, kMesh, kField, kNone };

struct QueryShape {
    Geom* geom = nullptr;  // never a transform
    Pose pose;
    Geom* named = nullptr;  // the geom that results name

    int number() const { return geom->type->number; }
    template <typename Shape>
    const Shape& as() const
    {
        return static_cast<const ShapeGeom<Shape>*>(geom)->shape;
    }
};

QueryShape query_shape_of(Geom& geom);  // null geom: an empty transform
QueryKind kind_of(const QueryShape& shape);

struct BoundingBall {
    Vec3 centre;
    Real reach;
};

// A ball around the solid; a ray is cut to `max_length`.
BoundingBall ball_about(const QueryShape& solid, Real max_length);
BoundingBall ball_about(const TriangleSet& surface, const Pose& pose);

// Limit for rays against rays and against endless fields, as a multiple of the distance between the two.
inline constexpr Real kEndless = kSingle ? Real(1e3) : Real(1e5);

// `centre`, `reach`: a ball around the other geom. The view points into `memory`.
ConvexView solid_view(const QueryShape& solid, Vec3 centre, Real reach, Capsule& memory);
ConvexView in_frame(const Pose& frame, const ConvexView& view);

// Its points and its normal into the world.
void to_world(const Pose& frame, Separation& s);

// The triangles of a mesh or a height field.
TriangleSet triangles_of(const QueryShape& shape);
// Of a mesh; 0 for what is none.
int mesh_triangles(const QueryShape& shape);

// True if the pair functions find a solid or a mesh below the surface of a height field. `out` is in world
// coordinates.
bool in_terrain(const QueryShape& shape, const QueryShape& field, Separation& out);

// True if the middle of the solid is inside a closed, solid mesh. Then `out` is minus the shortest way out,
// in world coordinates.
bool in_mesh(const QueryShape& solid, const QueryShape& mesh, Separation& out);

}  // namespace epode
