// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mesh_contacts.h.
#include "collide/pairs/surfaces/mesh_contacts.h"

#include <algorithm>
#include <type_traits>

#include "collide/pairs/surfaces/mesh_facet.h"

namespace epode {

namespace {

// Vertices out of a plane by less, as a part of their distance from the origin, are in it: mesh data is often
// float.
constexpr Real kFlat = kSingle ? 64 * kEpsilon : Real(2e-7);
constexpr int kFewToSort = 16;
constexpr Real kSameWay = kSingle ? Real(1e-6) : Real(1e-9);  // 1 - cosine

// As reach_along(), or more.
template <typename Shape>
Real most_along(const Shape& a, const ConvexView& v, Vec3 n)
{
    if constexpr (kByView<Shape>)
        return v.size;
    else
        return reach_along(a, v.pose, n);
}

template <typename Shape>
constexpr bool kTwoSided = false;
template <>
constexpr bool kTwoSided<Box> = true;
template <>
constexpr bool kTwoSided<Convex> = true;

template <typename Shape>
bool two_sided(const Shape&)
{
    return kTwoSided<Shape>;
}
bool two_sided(const AnySolid& a) { return !a.round; }

// Whether a near neighbour of the triangle leans: tested before all near triangles are.
bool ends_plane(const TriangleMesh& mesh, int t, const Aabb& box)
{
    const Vec3 own = mesh.normal(t);
    for (int k = 0; k < 3; ++k) {
        const int next = mesh.neighbour(t, k);
        if (next >= 0 && dot(mesh.normal(next), own) < 1 - 4 * kSameWay && overlap(mesh.box(next), box))
            return true;
    }
    return false;
}

// The plane of all near triangles, if they have a common one that extends past the box.
bool one_plane(const Surface& surface, NearTriangles& near, const Aabb& box, Real slack, Plane& out)
{
    const TriangleMesh& mesh = surface.mesh;
    if (!near.all() || near.refused()) return false;
    const Vec3 close = mesh.normal(*near.close().begin());
    for (const int t : near.close())
        if (dot(mesh.normal(t), close) < 1 - 4 * kSameWay || ends_plane(mesh, t, box)) return false;
    near.gather(surface, box);
    if (!near.all() || near.near().count() == 0) return false;
    const int first = *std::min_element(near.near().begin(), near.near().end());
    out.normal = mesh.normal(first);
    out.d = dot(out.normal, mesh.corner(first, 0));
    const Real reach = max_component(max(abs(box.lo), abs(box.hi)));
    const Real tolerance = std::max(slack, kFlat * reach);
    for (const int t : near.near()) {
        if (dot(mesh.normal(t), out.normal) < 1 - kSameWay) return false;
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = mesh.corner(t, k), q = mesh.corner(t, (k + 1) % 3);
            if (std::fabs(dot(out.normal, p) - out.d) > tolerance) return false;
            if (mesh.neighbour(t, k) < 0 && overlap({min(p, q), max(p, q)}, box)) return false;
        }
    }
    return true;
}

bool is_over(const TriangleMesh& mesh, int triangle, Vec3 p, Real slack)
{
    const Vec3 n = mesh.normal(triangle);
    bool in = true;
    for (int k = 0; in && k < 3; ++k) {
        const Vec3 v = mesh.corner(triangle, k), e = mesh.corner(triangle, (k + 1) % 3) - v;
        in = dot(cross(n, e), p - v) >= -slack * length(e);
    }
    return in;
}

// The first of the triangles that the point is over.
int triangle_under(const Surface& surface, const NearTriangles& near, Vec3 p, Real slack)
{
    for (const int t : near.near())
        if (is_over(surface.mesh, t, p, slack)) return t;
    return *near.near().begin();
}

// A ball's contact with the plane as ODE reports it: on the mesh, one for each triangle that meets there.
void report_each(const Surface& surface, const NearTriangles& near, Real slack, ContactSink& sink)
{
    dContactGeom& c = *sink.at(sink.count() - 1);
    const Vec3 n = load(c.normal), foot = load(c.pos) + c.depth * n;
    store(c.pos, foot);
    for (const int t : near.near())
        if (t > c.side2 && is_over(surface.mesh, t, foot, slack)) sink.add({foot, n, c.depth, -1, t});
}

}  // namespace

bool TriangleList::grow()
{
    if (many_.empty()) {
        if (!many_.resize(4 * kFew)) return false;
        std::copy(few_, few_ + count_, many_.data());
    } else if (!many_.resize(2 * count_)) {
        return false;
    }
    data_ = many_.data();
    capacity_ = many_.size();
    return true;
}

void TriangleList::sort()
{
    if (count_ > kFewToSort) return std::sort(data_, data_ + count_);
    for (int i = 1; i < count_; ++i) {
        const int t = data_[i];
        int at = i;
        for (; at > 0 && data_[at - 1] > t; --at) data_[at] = data_[at - 1];
        data_[at] = t;
    }
}

void NearTriangles::find(const Surface& surface, const Aabb& box)
{
    near_.clear();
    all_ = true;
    surface.tree.query(surface.mesh, box, [this](int t) {
        all_ = near_.add(t) && all_;
        return true;
    });
    near_.sort();
}

void NearTriangles::find(const Surface& surface, const Aabb& box, const SolidProbe& solid, NearLeaves* kept)
{
    leaves_.clear(), close_.clear();
    all_ = true, gathered_ = false;
    surface.tree.query(
        box, solid, kept,
        [this](int leaf, unsigned met) { all_ = leaves_.add(leaf << 4 | int(met)) && all_; },
        [&](const MeshPacket& packet, int lane) {
            all_ = close_.add(packet.lanes[lane]) && all_;
            surface.mesh.prefetch(packet.lanes[lane]), surface.mesh.prefetch(packet.corners[lane]);
        });
    close_.sort();
}

void NearTriangles::gather(const Surface& surface, const Aabb& box)
{
    if (gathered_) return;
    gathered_ = true;
    near_.clear();
    for (const int seen : leaves_)
        for (unsigned met = seen & 15; met != 0; met &= met - 1) {
            const int t = surface.tree.at(seen >> 4, std::countr_zero(met));
            if (overlap(surface.mesh.box(t), box)) all_ = near_.add(t) && all_;
        }
}

Real slack_of(const ConvexView& solid)
{
    const Real size = solid.size + solid.radius, reach = max_component(abs(solid.pose.p)) + size;
    return std::max(64 * kEpsilon * reach, kMeshTouch * size);
}

template <typename Shape>
void mesh_contacts(const Shape& a, const Pose& A, const Surface& surface, NearTriangles& near,
                   ContactSink& sink)
{
    if (near.close().count() == 0) return;
    const ConvexView solid = view_of(a, A);
    const Real slack = slack_of(solid);
    const bool as_ode = std::is_same_v<Shape, Sphere> && sink.to_program();
    Plane plane;
    if (one_plane(surface, near, box_around(a, A, slack), slack, plane) &&
        dot(plane.normal, solid.pose.p) >= plane.d) {
        const int before = sink.count();
        near.put_in_order();
        on_plane(a, A, plane, sink);
        for (int k = before; k < sink.count(); ++k)
            sink.at(k)->side2 = triangle_under(surface, near, load(sink.at(k)->pos), slack);
        if (as_ode && sink.count() > before) report_each(surface, near, slack, sink);
        return;
    }
    ContactCollector collector(Real(1e-6) * (solid.size + solid.radius), sink);
    PlacedHull hull(solid);
    MeshPair pair{surface.mesh,  solid,  slack,     two_sided(a),
                  near.all(),    as_ode, collector, hull.there() ? &hull : nullptr,
                  near.refused()};
    for (const int t : near.close()) {
        if constexpr (std::is_same_v<Shape, Sphere>) {
            ball_on(A.p, a.radius, t, pair);
            continue;
        }
        const Vec3 n = surface.mesh.normal(t);
        const Real height = dot(n, solid.pose.p - surface.mesh.corner(t, 0));
        if (!pair.two_sided && height < -slack) continue;
        if (std::fabs(height) > most_along(a, solid, n) + slack) continue;
        meet_facet(a, A, pair.facet(t), pair);
    }
    collector.deliver(sink);
}

#define EPODE_MESH_CONTACTS(Shape) \
    template void mesh_contacts(const Shape&, const Pose&, const Surface&, NearTriangles&, ContactSink&)
EPODE_MESH_CONTACTS(Sphere);
EPODE_MESH_CONTACTS(Capsule);
EPODE_MESH_CONTACTS(Box);
EPODE_MESH_CONTACTS(Cylinder);
EPODE_MESH_CONTACTS(Convex);
EPODE_MESH_CONTACTS(AnySolid);

}  // namespace epode
