// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A mesh against a plane: every vertex on or below it is a contact, once, named after its first triangle, in
// the order of the triangles. When there are more than the client has room for, what carries the mesh is
// kept: the deepest vertex and those that reach farthest in directions spread evenly over the plane, and with
// room for four or less the best manifold among these (contact_sink.h).
#include "collide/pairs/best_contacts.h"
#include "collide/pairs/pairs.h"
#include "math/trig.h"

namespace epode {

namespace {

constexpr int kMostDirections = 64;
constexpr int kFewDirections = 32;  // to choose four from

// The plane in the mesh's frame, and the way back.
struct Meeting {
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
        data.tree.below(n, d, [&](int t) {
            for (int k = 0; k < 3; ++k) {
                if (data.mesh.first_corner(t, k) != 3 * t + k) continue;
                const Vec3 v = data.mesh.corner(t, k);
                if (depth(v) >= 0 && !visit(3 * t + k, v)) return false;
            }
            return true;
        });
    }
};

struct Extreme {
    Vec3 direction;
    Real most = -kInf;
    int half_edge = -1;
    void offer(Vec3 vertex, int candidate)
    {
        const Real along = dot(direction, vertex);
        if (along > most || (along == most && candidate < half_edge)) {
            most = along;
            half_edge = candidate;
        }
    }
};

// The deepest vertex, then the farthest ones; each once.
int extremes(const Meeting& m, Extreme* out, int count)
{
    Vec3 p, q;
    plane_space(normalized_or(m.n, {0, 0, 1}), p, q);
    out[0] = {-m.n};
    for (int i = 1; i < count; ++i) {
        const Real angle = 2 * kPi * Real(i - 1) / Real(count - 1);
        out[i] = {cos(angle) * p + sin(angle) * q};
    }
    m.each([&](int half_edge, Vec3 vertex) {
        for (int i = 0; i < count; ++i) out[i].offer(vertex, half_edge);
        return true;
    });
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        bool fresh = true;
        for (int j = 0; j < kept; ++j) fresh = fresh && out[j].half_edge != out[i].half_edge;
        if (fresh) out[kept++] = out[i];
    }
    return kept;
}

void choose(const Meeting& m, ContactSink& sink)
{
    const bool few = sink.room() <= 4;
    const int room = sink.room() < kMostDirections ? sink.room() : kMostDirections;
    union Room {  // left unwritten until used
        Extreme found[kMostDirections];
        Room() {}
    } extreme;
    const int count = extremes(m, extreme.found, few ? kFewDirections : room);
    if (!few) {
        for (int i = 0; i < count; ++i) sink.add(m.contact(extreme.found[i].half_edge));
        return;
    }
    ContactPoint points[kFewDirections];
    for (int i = 0; i < count; ++i) points[i] = m.contact(extreme.found[i].half_edge);
    sink.add_manifold({points, std::size_t(count)});
}

}  // namespace

void trimesh_plane(const Trimesh& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const TrimeshData* data = a.mesh();
    if (!data) return;
    const Meeting m{*data, A, b.normal, transposed_times(A.R, b.normal), b.d - dot(b.normal, A.p)};
    int count = 0;
    BestContacts in_order(sink, [](const dContactGeom& x, const dContactGeom& y) {
        return x.side1 != y.side1 ? x.side1 < y.side1 : x.side2 < y.side2;
    });
    m.each([&](int half_edge, Vec3) {
        if (++count <= sink.room()) in_order.add(m.contact(half_edge));
        return count <= sink.room();
    });
    if (count > sink.room() && !sink.unimportant()) {
        sink.clear();
        choose(m, sink);
    } else {
        in_order.finish();
    }
    for (int i = 0; i < sink.count(); ++i) sink.at(i)->side2 = -1;
}

}  // namespace epode
