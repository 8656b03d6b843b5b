// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Support points and features of the primitives, each in its own frame. On a tie (a direction along the axis
// of a cylinder, say) the middle of the feature is returned: it depends on no rounding. Where two faces look
// that way alike, what they share is the feature, an edge or a corner; rounding chooses neither of them.
#include "geometry/convex_view.h"

namespace epode {

namespace {

template <class Shape>
const Shape& as(const void* shape)
{
    return *static_cast<const Shape*>(shape);
}

constexpr Real pick(Real d, Real h) { return d > 0 ? h : d < 0 ? -h : Real(0); }

Vec3 point_support(const void*, Vec3) { return {}; }
void point_feature(const void*, Vec3, Polygon& out) { out.add({}); }

Vec3 box_support(const void* shape, Vec3 d)
{
    const Vec3 h = as<Box>(shape).half;
    return {pick(d.x, h.x), pick(d.y, h.y), pick(d.z, h.z)};
}

// The four corners of the face across axis k.
void box_face(Vec3 h, Vec3 d, int k, Polygon& out)
{
    const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    const Real side = d[k] < 0 ? -1 : 1;
    for (int i = 0; i < 4; ++i) {
        Vec3 p;
        p.set(k, side * h[k]);
        p.set(k1, (i == 0 || i == 3) ? h[k1] : -h[k1]);
        p.set(k2, side * (i < 2 ? h[k2] : -h[k2]));
        out.add(p);
    }
    out.normal.set(k, side);
}

void box_feature(const void* shape, Vec3 d, Polygon& out)
{
    const Vec3 h = as<Box>(shape).half, m = abs(d);
    const int k = m.x >= m.y ? (m.x >= m.z ? 0 : 2) : (m.y >= m.z ? 1 : 2);
    const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    const Real size = length(d), lean = size - m[k];
    const bool alike1 = lean_alike(lean, size - m[k1], size), alike2 = lean_alike(lean, size - m[k2], size);
    if (!alike1 && !alike2) return box_face(h, d, k, out);
    const Vec3 corner = {d.x < 0 ? -h.x : h.x, d.y < 0 ? -h.y : h.y, d.z < 0 ? -h.z : h.z};
    out.add(corner);
    if (alike1 && alike2) return;
    const int along = alike1 ? k2 : k1;
    Vec3 other = corner;
    other.set(along, -corner[along]);
    out.add(other);
}

Vec3 segment_support(const void* shape, Vec3 d) { return {0, 0, pick(d.z, as<Capsule>(shape).half_length)}; }
void segment_feature(const void* shape, Vec3, Polygon& out)
{
    const Real h = as<Capsule>(shape).half_length;
    out.add({0, 0, -h}), out.add({0, 0, h});
}

Vec3 cylinder_support(const void* shape, Vec3 d)
{
    const Cylinder& c = as<Cylinder>(shape);
    const Real rho = std::sqrt(d.x * d.x + d.y * d.y);
    const Real z = pick(d.z, c.half_length);
    if (!(rho > 4 * kEpsilon * std::fabs(d.z))) return {0, 0, z};
    return {c.radius * d.x / rho, c.radius * d.y / rho, z};
}

// The end or the side line, whichever looks along d; a point of the rim when both do.
void cylinder_feature(const void* shape, Vec3 d, Polygon& out)
{
    const Cylinder& c = as<Cylinder>(shape);
    const Real rho = std::sqrt(d.x * d.x + d.y * d.y);
    const Real size = length(d), lean_end = size - std::fabs(d.z), lean_side = size - rho;
    if (lean_alike(std::fmin(lean_end, lean_side), std::fmax(lean_end, lean_side), size)) {
        out.add(cylinder_support(shape, d));
        return;
    }
    if (rho > std::fabs(d.z)) {
        const Real x = c.radius * d.x / rho, y = c.radius * d.y / rho;
        out.add({x, y, -c.half_length}), out.add({x, y, c.half_length});
        return;
    }
    const Real side = d.z < 0 ? -1 : 1;
    add_disc(c.radius, side * c.half_length, side, out);
}

}  // namespace

void add_disc(Real radius, Real z, Real side, Polygon& out)
{
    constexpr Real kHalf = Real(0.70710678118654752440);
    constexpr Real kX[kRimPoints] = {1, kHalf, 0, -kHalf, -1, -kHalf, 0, kHalf};
    for (int i = 0; i < kRimPoints; ++i)  // sine of the i-th angle = cosine of the one two places before
        out.add({radius * kX[i], side * radius * kX[(i + 6) % kRimPoints], z});
    out.normal = {0, 0, side};
}

ConvexView view_of(const Sphere& sphere, const Pose& pose)
{
    return {.shape = &sphere,
            .kind = SolidKind::kPoint,
            .local_support = point_support,
            .local_feature = point_feature,
            .pose = pose,
            .radius = sphere.radius,
            .size = 0,
            .face_axes = 0,
            .edge_axes = 0,
            .rim_radius = 0};
}
ConvexView view_of(const Box& box, const Pose& pose)
{
    return {.shape = &box,
            .kind = SolidKind::kBox,
            .local_support = box_support,
            .local_feature = box_feature,
            .pose = pose,
            .radius = 0,
            .size = length(box.half),
            .face_axes = 7,
            .edge_axes = 7,
            .rim_radius = 0};
}
ConvexView view_of(const Capsule& capsule, const Pose& pose)
{
    return {.shape = &capsule,
            .kind = SolidKind::kSegment,
            .local_support = segment_support,
            .local_feature = segment_feature,
            .pose = pose,
            .radius = capsule.radius,
            .size = capsule.half_length,
            .face_axes = 0,
            .edge_axes = 4,
            .rim_radius = 0};
}
ConvexView view_of(const Cylinder& cylinder, const Pose& pose)
{
    return {
        .shape = &cylinder,
        .kind = SolidKind::kCylinder,
        .local_support = cylinder_support,
        .local_feature = cylinder_feature,
        .pose = pose,
        .radius = 0,
        .size = std::sqrt(cylinder.radius * cylinder.radius + cylinder.half_length * cylinder.half_length),
        .face_axes = 4,
        .edge_axes = 4,
        .rim_radius = cylinder.radius};
}

}  // namespace epode
