// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A geom as questions of distance see it: what it is when transforms have been opened, where, and of which of
// the sorts that are treated alike. Rays are solids, segments no longer than it takes to reach whatever they
// are measured against.
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
    Geom* named = nullptr;

    int number() const { return geom->type->number; }
    template <typename Shape>
    const Shape& as() const
    {
        return static_cast<const ShapeGeom<Shape>*>(geom)->shape;
    }
};

QueryShape query_shape_of(Geom& geom);  // null geom: a transform that holds nothing
QueryKind kind_of(const QueryShape& shape);

struct BoundingBall {
    Vec3 centre;
    Real reach;
};

// Of a ray no more than `max_length` of it.
BoundingBall ball_about(const QueryShape& solid, Real max_length);
BoundingBall ball_about(const TriangleSet& surface, const Pose& pose);

// Two rays, and rays over endless fields, are looked at for so many times what lies between them at most.
inline constexpr Real kEndless = kSingle ? Real(1e3) : Real(1e5);

// `centre`, `reach`: a ball about what it is measured against; `memory` must stay.
ConvexView solid_view(const QueryShape& solid, Vec3 centre, Real reach, Capsule& memory);
ConvexView in_frame(const Pose& frame, const ConvexView& view);

// Of a mesh or a height field.
TriangleSet triangles_of(const QueryShape& shape);

// Where the pair functions find a solid or a mesh in the ground of a height field; in the world.
bool in_terrain(const QueryShape& shape, const QueryShape& field, Separation& out);

}  // namespace epode
