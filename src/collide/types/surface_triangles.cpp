// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The surface of any convex solid as triangles, to be drawn or recorded. A polyhedron has its faces as fans.
// Else a net of directions covers the sphere, meridians about z and parallels; each is taken to the solid's
// farthest point along it, and what of the net's triangles keeps an area is a triangle of the surface.
// Farthest points along neighbouring directions are neighbours on the surface, whatever the solid.
#include <span>

#include "base/float_environment.h"
#include "collide/solid_type.h"
#include "collide/types/registry.h"
#include "geometry/hulls/polyhedron.h"
#include "math/trig.h"
#include "ode/ext.h"

namespace epode {
namespace {

constexpr int kLeastSegments = 4, kMostSegments = 512;

class TriangleWriter {
  public:
    TriangleWriter(dReal* out, int capacity, const Pose& frame)
        : out_(out), capacity_(capacity), frame_(frame)
    {}
    void add(Vec3 a, Vec3 b, Vec3 c)
    {
        if (count_ < capacity_) {
            int k = 9 * count_;
            for (const Vec3 v : {a, b, c}) {
                const Vec3 p = frame_.to_world(v);
                out_[k] = p.x, out_[k + 1] = p.y, out_[k + 2] = p.z, k += 3;
            }
        }
        ++count_;
    }
    int count() const { return count_; }

  private:
    dReal* out_;
    int capacity_, count_ = 0;
    Pose frame_;
};

void write_faces(const Polyhedron& solid, TriangleWriter& out)
{
    for (const PolyhedronFace& face : solid.faces()) {
        const auto corner = [&](int k) {
            return solid.vertices()[std::size_t(solid.corners()[std::size_t(face.first + k)])];
        };
        for (int k = 2; k < face.count; ++k) out.add(corner(0), corner(k - 1), corner(k));
    }
}

class Net {
  public:
    Net(const ConvexView& solid, int segments) : solid_(solid), around_(segments), rings_(segments / 2) {}

    void write(TriangleWriter& out) const
    {
        for (int ring = 0; ring < rings_; ++ring)
            for (int k = 0; k < around_; ++k) {
                const Vec3 a = at(ring, k), b = at(ring + 1, k), c = at(ring + 1, k + 1), d = at(ring, k + 1);
                add(a, b, c, out), add(a, c, d, out);
            }
    }

  private:
    // From the pole at z downwards.
    Vec3 at(int ring, int k) const
    {
        const Real down = kPi * Real(ring) / Real(rings_), turn = 2 * kPi * Real(k % around_) / Real(around_);
        const bool pole = ring == 0 || ring == rings_;
        const Real across = pole ? Real(0) : sin(down);
        const Vec3 n{across * cos(turn), across * sin(turn), pole ? Real(ring == 0 ? 1 : -1) : cos(down)};
        return solid_.local_support(solid_.shape, n) + solid_.radius * n;
    }
    void add(Vec3 a, Vec3 b, Vec3 c, TriangleWriter& out) const
    {
        const Real size = solid_.size + solid_.radius, least = Real(1e-6) * size * size;
        if (length(cross(b - a, c - a)) > least) out.add(a, b, c);
    }

    const ConvexView& solid_;
    int around_, rings_;
};

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" int dGeomGetTriangles(dGeomID id, int segments, dReal* facets, int capacity)
{
    const FloatEnvironment floats;
    EPODE_GEOM(geom, id, 0);
    EPODE_USER_SAY(is_solid(*geom), "geom must be a convex solid", 0);
    EPODE_USER(segments >= kLeastSegments && segments <= kMostSegments, 0);
    EPODE_USER(capacity >= 0 && (facets || capacity == 0), 0);
    const ConvexView solid = solid_view(*geom, {});
    TriangleWriter out(facets, capacity, solid.pose);
    if (solid.kind == SolidKind::kPolyhedron)
        write_faces(*static_cast<const Polyhedron*>(solid.shape), out);
    else
        Net(solid, segments).write(out);
    return out.count();
}
