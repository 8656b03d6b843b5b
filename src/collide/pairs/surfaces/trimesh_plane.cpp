// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A mesh against a plane: every vertex on or below it is a contact, once, named after its first triangle, in
// the order of the triangles. If there are more than the client's capacity, those that support the mesh are
// kept: the deepest vertex and the farthest ones in directions spread evenly over the plane; with a capacity
// of four or less, the best manifold among these (contact_sink.h).
#include <algorithm>
#include <bit>

#include "collide/pairs/best_contacts.h"
#include "collide/pairs/pairs.h"
#include "math/trig.h"
#include "simd/quad.h"

namespace epode {

namespace {

constexpr int kMostDirections = 64;
constexpr int kFewDirections = 32;  // to choose four from
constexpr int kFewVertices = 128;   // are tested one by one, without the tree

// The plane in the mesh's frame, and the way back.
struct MeshPlanePair {
    const TrimeshData& data;
    const Pose& pose;
    Vec3 normal;  // in the world
    Vec3 n;
    Real d;

    Real depth(Vec3 vertex) const { return d - dot(n, vertex); }
    ContactPoint contact(int half_edge) const
    {
        const Vec3 at = data.mesh.corner(half_edge / 3, half_edge % 3);
        return {pose.to_world(at), normal, depth(at), half_edge / 3, half_edge % 3};
    }

    // visit(half_edge, vertex) for every vertex on or below the plane, until it answers false.
    template <typename Visit>
    void each(Visit&& visit) const
    {
        const auto low = [&](int half_edge) {
            const Vec3 v = data.mesh.corner(half_edge / 3, half_edge % 3);
            return !(depth(v) >= 0) || visit(half_edge, v);
        };
        if (data.mesh.vertex_count() > kFewVertices) return each_in_tree(low);
        for (int i = 0; i < data.mesh.vertex_count(); ++i) {
            const int half_edge = data.mesh.first_corner(i);
            if (half_edge >= 0 && !low(half_edge)) return;
        }
    }

  private:
    template <typename Visit>
    void each_in_tree(const Visit& visit) const
    {
        data.tree.below(n, d, [&](int t) {
            for (int k = 0; k < 3; ++k)
                if (data.mesh.first_corner(t, k) == 3 * t + k && !visit(3 * t + k)) return false;
            return true;
        });
    }
};

// Directions spread evenly over a circle.
struct Turn {
    Real cosine, sine;
};
const Turn* spread(int count)
{
    struct Table {
        Turn turns[kMostDirections * (kMostDirections - 1) / 2];  // of 1, 2, 3 ... directions
        Table()
        {
            for (int n = 1; n < kMostDirections; ++n)
                for (int i = 0; i < n; ++i) {
                    const Real angle = 2 * kPi * Real(i) / Real(n);
                    turns[n * (n - 1) / 2 + i] = {cos(angle), sin(angle)};
                }
        }
    };
    static const Table table;
    return table.turns + count * (count - 1) / 2;
}

// The vertices that reach farthest in some directions, four directions at a time: of most vertices none is
// the farthest so far. Of equal ones the first half-edge counts.
class Extremes {
  public:
    // The first direction is straight into the plane, the others spread evenly along it.
    Extremes(Vec3 normal, int count) : count_(count), groups_((count + kWide - 1) / kWide)
    {
        Vec3 p, q;
        plane_space(normalized_or(normal, {0, 0, 1}), p, q);
        set(0, -normal);
        const Turn* const turns = spread(count - 1);
        for (int i = 1; i < count; ++i) set(i, turns[i - 1].cosine * p + turns[i - 1].sine * q);
        for (int i = count; i < kWide * groups_; ++i) set(i, {});
    }
    void offer(Vec3 vertex, int half_edge)
    {
        const Quad x = quad(vertex.x), y = quad(vertex.y), z = quad(vertex.z);
        for (int g = 0; g < groups_; ++g) {
            Group& some = some_[g];
            const Quad along = load_quad(some.x) * x + load_quad(some.y) * y + load_quad(some.z) * z;
            for (unsigned far = bits(load_quad(some.largest) <= along); far != 0; far &= far - 1) {
                const int i = std::countr_zero(far);
                if (lane(along, i) == some.largest[i] && half_edge > some.half_edge[i]) continue;
                some.largest[i] = lane(along, i), some.half_edge[i] = half_edge;
            }
        }
    }
    // Each once, as half-edges; their number.
    int distinct(int* out) const
    {
        int kept = 0;
        for (int i = 0; i < count_; ++i) {
            const int found = some_[i / kWide].half_edge[i % kWide];
            if (std::find(out, out + kept, found) == out + kept) out[kept++] = found;
        }
        return kept;
    }

  private:
    static constexpr int kWide = 4;
    struct Group {
        Real x[kWide], y[kWide], z[kWide], largest[kWide];
        int half_edge[kWide];
    };
    void set(int i, Vec3 direction)
    {
        Group& some = some_[i / kWide];
        const int k = i % kWide;
        some.x[k] = direction.x, some.y[k] = direction.y, some.z[k] = direction.z;
        some.largest[k] = -kInf, some.half_edge[k] = -1;
    }

    union {
        Group some_[kMostDirections / kWide];  // in a union: left unwritten until set
    };
    int count_, groups_;
};

void choose(const MeshPlanePair& m, ContactSink& sink)
{
    const bool few = sink.capacity() <= 4;
    const int capacity = sink.capacity() < kMostDirections ? sink.capacity() : kMostDirections;
    Extremes extremes(m.n, few ? kFewDirections : capacity);
    m.each([&](int half_edge, Vec3 vertex) {
        extremes.offer(vertex, half_edge);
        return true;
    });
    int found[kMostDirections];
    const int count = extremes.distinct(found);
    if (!few) {
        for (int i = 0; i < count; ++i) sink.add(m.contact(found[i]));
        return;
    }
    ContactPoint points[kFewDirections];
    for (int i = 0; i < count; ++i) points[i] = m.contact(found[i]);
    sink.add_manifold({points, std::size_t(count)});
}

}  // namespace

void trimesh_plane(const Trimesh& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const TrimeshData* data = a.mesh();
    if (!data) return;
    const MeshPlanePair m{*data, A, b.normal, transposed_times(A.R, b.normal), b.d - dot(b.normal, A.p)};
    int count = 0;
    BestContacts in_order(sink, [](const dContactGeom& x, const dContactGeom& y) {
        return x.side1 != y.side1 ? x.side1 < y.side1 : x.side2 < y.side2;
    });
    m.each([&](int half_edge, Vec3) {
        if (++count <= sink.capacity()) in_order.add(m.contact(half_edge));
        return count <= sink.capacity();
    });
    if (count > sink.capacity() && !sink.unimportant()) {
        sink.clear();
        choose(m, sink);
    } else {
        in_order.finish();
    }
    for (int i = 0; i < sink.count(); ++i) sink.at(i)->side2 = -1;
}

}  // namespace epode
