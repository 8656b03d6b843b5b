// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A ray against a mesh. Triangles are tested in a frame in which the ray runs along z (Woop, Benthin and
// Wald, "Watertight ray/triangle intersection", JCGT 2013): with the corners' shadows A, B, C the numbers
//   U = C x B, V = A x C, W = B x A (2D cross products)
// have one sign inside, and exactly opposite ones on either side of a shared edge. A ray that goes exactly
// through an edge belongs to the triangle to the left of it, the edge being taken to run towards larger x,
// then larger y: so no ray slips through a closed seam, and none hits a flat one twice. All hits are
// reported, the nearest first, up to the sink's capacity. FirstContact: any one; ClosestHit: the nearest. A
// callback of the program receives the hits from the nearest on, until it has accepted enough. Normals are
// those of the triangles' fronts, from whichever side the ray comes.
#include "collide/pairs/best_contacts.h"
#include "collide/pairs/surfaces/on_surface.h"
#include "collide/surfaces/mesh_functions.h"

namespace epode {

namespace {

struct Hit {
    Real t = kInf;
    int triangle = -1;
    Real u = 0, v = 0;
    bool before(const Hit& other) const { return t != other.t ? t < other.t : triangle < other.triangle; }
};

struct Shadow {
    Real x, y, z;
};

class Caster {
  public:
    Caster(const TrimeshData& data, Vec3 origin, Vec3 direction, Real length, bool fronts_only)
        : mesh_(data.mesh),
          tree_(data.tree),
          origin_(origin),
          direction_(direction),
          length_(length),
          fronts_only_(fronts_only)
    {
        const Vec3 a = abs(direction);
        kz_ = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
        kx_ = (kz_ + 1) % 3, ky_ = (kz_ + 2) % 3;
        shear_x_ = direction[kx_] / direction[kz_], shear_y_ = direction[ky_] / direction[kz_];
        turned_ = direction[kz_] < 0;
    }

    // found(hit) for every hit; it answers how far the ray has still to be followed.
    template <typename Found>
    void each(Found&& found) const
    {
        Real reach = length_;
        // One corner of each triangle, before it is known which of them are hit. The other corners are
        // usually in adjacent memory, and all twelve are more than can be prefetched at once.
        const auto see = [&](const MeshPacket& packet) {
            for (const MeshCorners& corners : packet.corners) mesh_.prefetch_vertex(corners.at[0]);
        };
        tree_.shoot(origin_, direction_, 0, length_, see,
                    [&](const MeshRay& ray, const MeshPacket& packet, int lane) {
                        Hit hit;
                        if (meets(ray, packet.lanes[lane], packet.corners[lane], hit)) reach = found(hit);
                        return reach;
                    });
    }

    // The nearest hit after another one, which may be none; none: triangle -1.
    Hit next(const Hit& last) const
    {
        Hit best;
        each([&](const Hit& hit) {
            if (last.before(hit) && hit.before(best)) best = hit;
            return best.triangle < 0 ? length_ : best.t;
        });
        return best;
    }

    Hit any() const
    {
        Hit one;
        each([&](const Hit& hit) {
            one = hit;
            return Real(-1);
        });
        return one;
    }

    ContactPoint contact(const Hit& hit) const
    {
        return {origin_ + hit.t * direction_, mesh_.normal(hit.triangle), hit.t, -1, hit.triangle};
    }

  private:
    Shadow shadow(const MeshRay& ray, Vec3 corner) const
    {
        const Vec3 p = ray.scale * (corner - ray.origin);
        return {p[kx_] - shear_x_ * p[kz_], p[ky_] - shear_y_ * p[kz_], p[kz_]};
    }

    // Does the triangle, running round with `sense`, have the point on its side of p-q?
    static bool inside(Real cross, Real sense, const Shadow& p, const Shadow& q)
    {
        if (cross != 0) return (cross > 0) == (sense > 0);
        const bool forwards = p.x != q.x ? p.x < q.x : p.y < q.y;
        return forwards == (sense > 0);
    }

    bool meets(const MeshRay& ray, int t, const MeshCorners& corners, Hit& hit) const
    {
        mesh_.prefetch_normal(t);
        const Shadow a = shadow(ray, mesh_.vertex(corners.at[0])),
                     b = shadow(ray, mesh_.vertex(corners.at[1])),
                     c = shadow(ray, mesh_.vertex(corners.at[2]));
        const Real u = b.x * c.y - b.y * c.x, v = c.x * a.y - c.y * a.x, w = a.x * b.y - a.y * b.x;
        if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
        const Real sense = u + v + w;
        if (!(sense != 0) || !inside(u, sense, b, c) || !inside(v, sense, c, a) || !inside(w, sense, a, b))
            return false;
        // Counter-clockwise seen along an axis is clockwise seen along the ray, if this runs up the axis.
        const bool front = (sense < 0) != turned_;
        if (fronts_only_ && !front) return false;
        const Real wa = u / sense, wb = v / sense, wc = w / sense, per = 1 / (ray.scale * direction_[kz_]);
        const Real at = ray.start + (wa * a.z + wb * b.z + wc * c.z) * per;
        // A surface that the ray starts or ends on is hit, whatever has been rounded.
        const Real spread = (std::fabs(a.z) + std::fabs(b.z) + std::fabs(c.z)) * std::fabs(per);
        const Real slack = 16 * kEpsilon * (ray.start + spread);
        if (!(at >= -slack && at <= length_ + slack)) return false;
        hit = {at < 0 ? 0 : at > length_ ? length_ : at, t, wb, wc};
        return true;
    }

    const TriangleMesh& mesh_;
    const MeshTree& tree_;
    Vec3 origin_, direction_;
    Real length_;
    bool fronts_only_;
    int kx_, ky_, kz_;
    Real shear_x_, shear_y_;
    bool turned_;
};

void all_hits(const Caster& caster, Real length, ContactSink& sink)
{
    BestContacts best(sink, [](const dContactGeom& a, const dContactGeom& b) {
        return a.depth != b.depth ? a.depth < b.depth : a.side2 < b.side2;
    });
    caster.each([&](const Hit& hit) {
        best.add(caster.contact(hit));
        return sink.unimportant() && sink.full() ? Real(-1) : length;
    });
    best.finish();
}

void hits_put_to_the_program(const Caster& caster, const MeshFunctions& functions, bool one,
                             ContactSink& sink)
{
    Hit last{-kInf, -1};
    while (!sink.full() && !(one && sink.count() > 0)) {
        last = caster.next(last);
        if (last.triangle < 0) return;
        if (functions.ray_hits(last.triangle, last.u, last.v) && functions.wants(last.triangle))
            sink.add(caster.contact(last));
    }
}

// Whether the ray starts outside the box along an axis, by more than rounding, and does not approach it.
bool runs_away(const Aabb& box, Vec3 origin, Vec3 direction)
{
    for (int k = 0; k < 3; ++k) {
        const Real slack =
            64 * kEpsilon * (std::fabs(origin[k]) + std::fabs(box.lo[k]) + std::fabs(box.hi[k]));
        if ((origin[k] - slack > box.hi[k] && direction[k] >= 0) ||
            (origin[k] + slack < box.lo[k] && direction[k] <= 0))
            return true;
    }
    return false;
}

}  // namespace

void ray_trimesh(const Ray& a, const Pose& A, const Trimesh& b, const Pose& B, ContactSink& sink)
{
    const TrimeshData* data = b.mesh();
    const Vec3 direction = transposed_times(B.R, A.R.column(2));
    if (!data || !(a.length >= 0) || !(length2(direction) > 0)) return;
    const Vec3 origin = B.to_local(A.p);
    if (runs_away(data->tree.box(), origin, direction)) return;
    const Caster caster(*data, origin, direction, a.length, a.backface_cull);
    const bool one = a.closest_hit || a.first_contact;
    if (b.ray_hits || b.wants) {
        hits_put_to_the_program(caster, MeshFunctions(b, sink, false), one, sink);
    } else if (one) {
        const Hit hit = a.closest_hit ? caster.next({-kInf, -1}) : caster.any();
        if (hit.triangle >= 0) sink.add(caster.contact(hit));
    } else {
        all_hits(caster, a.length, sink);
    }
    to_world(B, sink, 0);
}

}  // namespace epode
