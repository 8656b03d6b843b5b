// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays: x(t) = o + t d, 0 <= t <= length. Every solid here is convex, so the line is inside it for one
// interval [enter, leave]. A ray that starts outside stops at `enter`; one that starts inside stops at the
// far wall, `leave`, and its normal is turned inward, against the ray. A start on the surface is a hit at
// depth 0 with the outward normal. Contact: position the hit, depth t, one contact at most.
#include "collide/pairs/at_once.h"
#include "geometry/closest.h"
#include "geometry/hulls/polyhedron.h"

namespace epode {

namespace {

struct Line {
    Vec3 o, d;  // in the solid's frame, d unit
    Vec3 at(Real t) const { return o + t * d; }
};

Line line_of(const Pose& ray, const Pose& solid)
{
    return {solid.to_local(ray.p), transposed_times(solid.R, ray.R.column(2))};
}

struct Interval {
    Real enter = -kInf, leave = kInf;
    Vec3 enter_normal, leave_normal;  // outward; of round walls of any length
    bool empty() const { return !(enter <= leave); }
    void cut(Real from, Vec3 from_normal, Real to, Vec3 to_normal)
    {
        if (from > enter) enter = from, enter_normal = from_normal;
        if (to < leave) leave = to, leave_normal = to_normal;
    }
    void clear() { enter = kInf, leave = -kInf; }
};

void cut_slab(const Line& line, int axis, Real half, Interval& in)
{
    const Real o = line.o[axis], d = line.d[axis];
    if (d == 0) {
        if (std::fabs(o) > half) in.clear();
        return;
    }
    Vec3 n;
    n.set(axis, d > 0 ? Real(-1) : Real(1));
    const Real near = d > 0 ? -half : half;
    in.cut((near - o) / d, n, (-near - o) / d, -n);
}

// Roots of a t^2 + 2 b t + c, smaller first, without cancellation; false when there are none.
bool roots(Real a, Real b, Real c, Real& lower, Real& upper)
{
    const Real disc = b * b - a * c;
    if (!(disc >= 0) || !(a > 0)) return false;
    const Real q = b > 0 ? -b - std::sqrt(disc) : -b + std::sqrt(disc);
    const Real t1 = q / a, t2 = q != 0 ? c / q : t1;
    lower = t1 < t2 ? t1 : t2;
    upper = t1 < t2 ? t2 : t1;
    return true;
}

// Quadratics are solved from the point of the line nearest to the solid's centre, so that rays from afar
// keep their digits.
Real nearest_to(const Line& line, Vec3 centre) { return dot(centre - line.o, line.d); }

// The infinite tube of radius r about z.
void cut_tube(const Line& line, Real r, Interval& in)
{
    const Real base = nearest_to(line, {});
    const Vec3 p = line.at(base);
    const Real a = line.d.x * line.d.x + line.d.y * line.d.y, rho = std::sqrt(p.x * p.x + p.y * p.y);
    const Real c = (rho - r) * (rho + r);
    if (!(a > kEpsilon * kEpsilon)) {  // along the axis
        if (c > 0) in.clear();
        return;
    }
    Real lower, upper;
    if (!roots(a, p.x * line.d.x + p.y * line.d.y, c, lower, upper)) return in.clear();
    const auto outward = [&](Real t) { return Vec3{p.x + t * line.d.x, p.y + t * line.d.y, 0}; };
    in.cut(base + lower, outward(lower), base + upper, outward(upper));
}

// The chord of a line in a ball: both ends are equally far from the line's point nearest to the centre.
// half2, the square of half the chord, is negative if the line misses the ball.
struct Chord {
    Real base, shift, half2;
    Vec3 nearest;  // from the centre
    Chord(const Line& line, Vec3 c, Real r) : base(nearest_to(line, c)), nearest(line.at(base) - c)
    {
        const Real per = 1 / length2(line.d);
        shift = -dot(nearest, line.d) * per;
        half2 = (r * r - length2(nearest)) * per;
    }
};

Interval ball(const Line& line, Vec3 c, Real r)
{
    Interval in;
    const Chord chord(line, c, r);
    if (!(chord.half2 >= 0)) {
        in.clear();
        return in;
    }
    const Real half = std::sqrt(chord.half2), lower = chord.shift - half, upper = chord.shift + half;
    in.cut(chord.base + lower, chord.nearest + lower * line.d, chord.base + upper,
           chord.nearest + upper * line.d);
    return in;
}

// The smallest interval around both.
void join(const Interval& other, Interval& in)
{
    if (other.empty()) return;
    if (in.empty()) {
        in = other;
        return;
    }
    if (other.enter < in.enter) in.enter = other.enter, in.enter_normal = other.enter_normal;
    if (other.leave > in.leave) in.leave = other.leave, in.leave_normal = other.leave_normal;
}

// Where the ray meets what it is inside of from `enter` to `leave`; false when it does not.
struct RayHit {
    Real depth;
    bool outside;  // it comes from there
    bool turned;   // the normal looks inward
};

bool meets(const Ray& ray, Real enter, Real leave, Real size, RayHit& out)
{
    if (!(enter <= leave) || !(ray.length >= 0)) return false;
    const Real skin = 8 * kEpsilon * size;
    const bool outside = enter >= -skin;
    const Real t = outside ? enter : leave;
    if (!(t >= -skin) || t > ray.length) return false;
    out = {t > 0 ? t : Real(0), outside, !outside && t > skin};
    return true;
}

void add_hit(const RayHit& m, const Pose& R, Vec3 outward, ContactSink& sink)
{
    sink.add({R.p + m.depth * R.R.column(2), m.turned ? -outward : outward, m.depth});
}

void hit_flat(const Ray& ray, const Pose& R, const Pose& solid, const Interval& in, Real size,
              ContactSink& sink)
{
    RayHit m;
    if (!meets(ray, in.enter, in.leave, size, m)) return;
    add_hit(m, R, solid.R * (m.outside ? in.enter_normal : in.leave_normal), sink);
}

void hit_round(const Ray& ray, const Pose& R, const Pose& solid, const Interval& in, Real size,
               ContactSink& sink)
{
    RayHit m;
    if (!meets(ray, in.enter, in.leave, size, m)) return;
    const Vec3 n = m.outside ? in.enter_normal : in.leave_normal;
    add_hit(m, R, solid.R * direction_of(n, length(n), {1, 0, 0}), sink);
}

}  // namespace

namespace {

constexpr Real kEnters = 64 * kEpsilon;  // of the size: farther along than this is no start on the surface

// Whether the line passes a ball about the origin by more than rounding.
bool passes(const Line& line, Real radius)
{
    return length2(line.at(nearest_to(line, {}))) > Real(1.01) * radius * radius;
}

}  // namespace

void ray_sphere(const Ray& a, const Pose& A, const Sphere& b, const Pose& B, ContactSink& sink)
{
    const Line line = {A.p - B.p, A.R.column(2)};
    const Chord chord(line, {}, b.radius);
    if (!(chord.half2 >= 0)) return;
    const Real half = std::sqrt(chord.half2), lower = chord.shift - half, upper = chord.shift + half;
    RayHit m;
    if (!meets(a, chord.base + lower, chord.base + upper, b.radius, m)) return;
    const Vec3 n = chord.nearest + (m.outside ? lower : upper) * line.d;
    add_hit(m, A, direction_of(n, length(n), {1, 0, 0}), sink);
}

namespace {

// The interval of a ray within a box, and by which axis it begins and ends.
struct BoxInterval {
    Real enter = -kInf, leave = kInf;
    int first = 0, last = 0;
};

// Some number of d is zero. False: outside of a slab that the ray runs along.
[[gnu::noinline]] bool within_slabs(const Real (&o)[3], const Real (&d)[3], const Real (&half)[3],
                                    BoxInterval& in)
{
    for (int i = 0; i < 3; ++i) {
        if (d[i] == 0) {
            if (std::fabs(o[i]) > half[i]) return false;
            continue;
        }
        const Real near = d[i] > 0 ? -half[i] : half[i];
        const Real from = (near - o[i]) / d[i], to = (-near - o[i]) / d[i];
        if (from > in.enter) in.enter = from, in.first = i;
        if (to < in.leave) in.leave = to, in.last = i;
    }
    return true;
}

}  // namespace

// Most boxes that a ray is tried at it misses, which no branch foresees: there is one, on the whole interval.
void ray_box(const Ray& a, const Pose& A, const Box& b, const Pose& B, ContactSink& sink)
{
    const Line line = line_of(A, B);
    const Real o[3] = {line.o.x, line.o.y, line.o.z}, d[3] = {line.d.x, line.d.y, line.d.z};
    const Real half[3] = {b.half.x, b.half.y, b.half.z};
    BoxInterval in;
    if (d[0] * d[1] * d[2] == 0) {
        if (!within_slabs(o, d, half, in)) return;
    } else {
        Real from[3], to[3];
        for (int i = 0; i < 3; ++i) {
            const Real far = std::copysign(half[i], d[i]);
            from[i] = (-far - o[i]) / d[i], to[i] = (far - o[i]) / d[i];
        }
        in.enter = from[1] > from[0] ? from[1] : from[0], in.leave = to[1] < to[0] ? to[1] : to[0];
        in.enter = from[2] > in.enter ? from[2] : in.enter, in.leave = to[2] < in.leave ? to[2] : in.leave;
        if (!(in.enter <= in.leave)) return;
        in.first = from[0] == in.enter ? 0 : from[1] == in.enter ? 1 : 2;
        in.last = to[0] == in.leave ? 0 : to[1] == in.leave ? 1 : 2;
    }
    RayHit m;
    if (!meets(a, in.enter, in.leave, max_component(b.half), m)) return;
    const int axis = m.outside ? in.first : in.last;
    const bool down = m.outside == (d[axis] > 0);
    add_hit(m, A, down ? -B.R.column(axis) : B.R.column(axis), sink);
}

void ray_cylinder(const Ray& a, const Pose& A, const Cylinder& b, const Pose& B, ContactSink& sink)
{
    const Line line = line_of(A, B);
    if (passes(line, b.radius + b.half_length)) return;
    Interval in;
    cut_slab(line, 2, b.half_length, in);
    cut_tube(line, b.radius, in);
    hit_round(a, A, B, in, b.radius + b.half_length, sink);
}

void ray_capsule(const Ray& a, const Pose& A, const Capsule& b, const Pose& B, ContactSink& sink)
{
    const Line line = line_of(A, B);
    const Real size = b.radius + b.half_length;
    if (passes(line, size)) return;
    Interval in;
    cut_tube(line, b.radius, in);
    if (in.empty()) return;
    // Only the tube's part between the caps: beyond it, the caps decide.
    Interval middle = in;
    cut_slab(line, 2, b.half_length, middle);
    const auto cap = [&](Real z) { return ball(line, {0, 0, z}, b.radius); };
    if (!middle.empty() && middle.enter > size * kEnters) {
        // From outside, through the wall, or through the cap over the end by which it comes in.
        if (middle.enter > in.enter) join(cap(line.d.z < 0 ? b.half_length : -b.half_length), middle);
        if (middle.enter > size * kEnters) return hit_round(a, A, B, middle, size, sink);
    }
    Interval all;
    all.clear();
    if (!middle.empty()) join(middle, all);
    join(cap(-b.half_length), all);
    join(cap(b.half_length), all);
    hit_round(a, A, B, all, size, sink);
}

void ray_convex(const Ray& a, const Pose& A, const Convex& b, const Pose& B, ContactSink& sink)
{
    const Pose centred = {B.to_world(b.solid->centre()), B.R};
    const Line line = line_of(A, centred);
    if (passes(line, b.solid->size())) return;
    Interval in;
    const PolyhedronFace *first = nullptr, *last = nullptr;
    for (const PolyhedronFace& f : b.solid->faces()) {
        const Real above = dot(f.normal, line.o) - f.offset, rate = dot(f.normal, line.d);
        if (rate == 0 && above > 0) return;
        const Real t = -above / rate;
        if (rate < 0 && t > in.enter) in.enter = t, first = &f;
        if (rate > 0 && t < in.leave) in.leave = t, last = &f;
    }
    if (first) in.enter_normal = first->normal;
    if (last) in.leave_normal = last->normal;
    hit_flat(a, A, centred, in, b.solid->size(), sink);
}

void ray_plane(const Ray& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const Vec3 d = A.R.column(2);
    const Real above = dot(b.normal, A.p) - b.d, rate = dot(b.normal, d);
    if (rate == 0 || !(a.length >= 0)) return;
    const Real t = -above / rate;
    if (!(t >= 0) || t > a.length) return;
    sink.add({A.p + t * d, above >= 0 ? b.normal : -b.normal, t > 0 ? t : Real(0)});
}

EPODE_AT_ONCE(Ray, Sphere, ray_sphere)
EPODE_AT_ONCE(Ray, Box, ray_box)
EPODE_AT_ONCE(Ray, Capsule, ray_capsule)
EPODE_AT_ONCE(Ray, Cylinder, ray_cylinder)
EPODE_AT_ONCE(Ray, Plane, ray_plane)

}  // namespace epode
