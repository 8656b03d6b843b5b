// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sphere against sphere, box, capsule, cylinder and plane: one contact, closed forms. The sphere's centre c
// is compared with the nearest point q of the other solid: normal (c - q)/|c - q|, depth r - |c - q|; with
// the centre inside, the nearest face is the way out and its distance is added to the radius.
#include "collide/pairs/at_once.h"
#include "collide/pairs/round/ball_contact.h"
#include "geometry/closest.h"

namespace epode {

void sphere_sphere(const Sphere& a, const Pose& A, const Sphere& b, const Pose& B, ContactSink& sink)
{
    ContactPoint c;
    const auto along_x = [] { return Vec3{1, 0, 0}; };
    if (ball_contact(A.p, a.radius, B.p, b.radius, along_x, c)) sink.add(c);
}

void sphere_plane(const Sphere& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const Real depth = a.radius - (dot(b.normal, A.p) - b.d);
    if (depth >= 0) sink.add({A.p - a.radius * b.normal, b.normal, depth});
}

namespace {

// Nearest face from inside: the axis with the least way out; x before y before z.
int nearest_face(Vec3 clearance)
{
    int k = clearance.y < clearance.x ? 1 : 0;
    return clearance.z < clearance[k] ? 2 : k;
}

}  // namespace

void sphere_box(const Sphere& a, const Pose& A, const Box& b, const Pose& B, ContactSink& sink)
{
    const Vec3 c = B.to_local(A.p), q = clamp_to_box(c, b.half), out = c - q;
    const Real distance = length(out);
    if (distance > a.radius) return;
    const Vec3 n = direction_of(out, distance, {});
    if (distance > 0 && !(n == Vec3{})) {
        sink.add({B.to_world(q), B.R * n, a.radius - distance});
        return;
    }
    const Vec3 clearance = b.half - abs(c);
    const int k = nearest_face(clearance);
    sink.add({A.p, (c[k] < 0 ? Real(-1) : Real(1)) * B.R.column(k), clearance[k] + a.radius});
}

// A unit vector across `axis`, as near to x as can be.
[[gnu::noinline]] static Vec3 across(Vec3 axis)
{
    Vec3 n = Vec3{1, 0, 0} - axis.x * axis;
    if (length2(n) > Real(1e-6) && normalize(n)) return n;
    Vec3 q;
    plane_space(axis, n, q);
    return n;
}

void sphere_capsule(const Sphere& a, const Pose& A, const Capsule& b, const Pose& B, ContactSink& sink)
{
    const Vec3 axis = B.R.column(2);
    const Real z = dot(axis, A.p - B.p);
    const Real t = z > b.half_length ? b.half_length : z < -b.half_length ? -b.half_length : z;
    ContactPoint c;
    const auto aside = [axis] { return across(axis); };
    if (ball_contact(A.p, a.radius, B.p + t * axis, b.radius, aside, c)) sink.add(c);
}

void sphere_cylinder(const Sphere& a, const Pose& A, const Cylinder& b, const Pose& B, ContactSink& sink)
{
    const Vec3 c = B.to_local(A.p);
    const Real rho = std::sqrt(c.x * c.x + c.y * c.y);
    const Real side = rho - b.radius, end = std::fabs(c.z) - b.half_length;  // > 0: beyond
    const Vec3 radial = rho > 0 ? Vec3{c.x / rho, c.y / rho, 0} : Vec3{1, 0, 0};
    const Vec3 axial = {0, 0, c.z < 0 ? Real(-1) : Real(1)};
    if (side > 0 && end > 0) {  // past the rim
        const Real distance = std::sqrt(side * side + end * end);
        if (distance > a.radius) return;
        const Vec3 n = normalized_or(side * radial + end * axial, radial);
        sink.add({B.to_world(b.radius * radial + b.half_length * axial), B.R * n, a.radius - distance});
        return;
    }
    const bool by_end = end > side;
    const Real distance = by_end ? end : side;  // <= 0: the centre is inside
    if (distance > a.radius) return;
    const Vec3 n = B.R * (by_end ? axial : radial);
    const Real in =
        !by_end && rho < a.radius ? rho : a.radius;  // sideways no farther than the cylinder's axis
    sink.add({A.p - in * n, n, a.radius - distance});
}

EPODE_AT_ONCE(Sphere, Sphere, sphere_sphere)
EPODE_AT_ONCE(Sphere, Box, sphere_box)
EPODE_AT_ONCE(Sphere, Capsule, sphere_capsule)
EPODE_AT_ONCE(Sphere, Cylinder, sphere_cylinder)
EPODE_AT_ONCE(Sphere, Plane, sphere_plane)

}  // namespace epode
