// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What every pair function owes, tried for each line of collide/pairs/pairs.inc in seeded random poses, many
// of them aligned or almost so, because that is where manifolds break:
//   hit or miss and depth as a brute-force sweep over 20 000 directions finds them; the normal is unit, and
//   moving the first solid along it by the depth parts the two; points lie in both solids; the capacity is
//   never exceeded, and less capacity still holds a contact; the same class exchanged gives the opposite
//   normal and the same depth; a tiny motion of a resting solid moves its contacts but little; zero sizes and
//   equal centres give numbers.
// The reference knows the solids only by the support and membership functions written here.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <random>
#include <type_traits>
#include <vector>

#include "../effort.h"
#include "collide/pairs/pairs.h"
#include "geometry/hulls/polyhedron.h"

using namespace epode;

namespace {

constexpr Real kTight = kSingle ? Real(2e-4) : Real(1e-7);   // for sizes near one
constexpr Real kClaim = kSingle ? Real(4e-3) : Real(5e-5);   // depth against the reported normal
constexpr Real kDeeper = kSingle ? Real(6e-3) : Real(2e-6);  // depth against the least one
constexpr int kDirections = 20000;
constexpr int kPoses = tests::effort(400);

class Dice {
  public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    Real unit() { return Real(double(engine_() >> 11) * 0x1p-53); }
    Real between(Real lo, Real hi) { return lo + (hi - lo) * unit(); }
    Vec3 direction()
    {
        for (;;) {
            Vec3 v = {between(-1, 1), between(-1, 1), between(-1, 1)};
            if (length2(v) < 1 && length2(v) > Real(0.01) && normalize(v)) return v;
        }
    }
    // A third of the rotations is aligned with the axes, a third nearly so.
    Mat3 rotation()
    {
        const Real kind = unit();
        if (kind < Real(0.33)) return quarter_turns();
        if (kind < Real(0.66))
            return turn(direction(), std::pow(Real(10), between(-7, -1))) * quarter_turns();
        return turn(direction(), between(0, 2 * kPi));
    }
    static Mat3 turn(Vec3 axis, Real angle)
    {
        const Real s = std::sin(angle / 2);
        Quat q = {std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z};
        normalize(q);
        return to_matrix(q);
    }

  private:
    Mat3 quarter_turns()
    {
        const int i = int(unit() * 3), j = int(unit() * 4);
        Vec3 axis;
        axis.set(i, 1);
        Mat3 m = Mat3::identity();
        const Mat3 quarter = i == 0   ? Mat3{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}
                             : i == 1 ? Mat3{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}
                                      : Mat3{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
        for (int k = 0; k < j; ++k) m = quarter * m;
        return m;
    }
    std::mt19937_64 engine_;
};

// ---- the solids, by mathematics of their own ----
Real side(Real d, Real h) { return d < 0 ? -h : h; }

Vec3 farthest(const Sphere& s, Vec3 d) { return s.radius * d; }
Vec3 farthest(const Box& b, Vec3 d)
{
    return {side(d.x, b.half.x), side(d.y, b.half.y), side(d.z, b.half.z)};
}
Vec3 farthest(const Capsule& c, Vec3 d) { return c.radius * d + Vec3{0, 0, side(d.z, c.half_length)}; }
Vec3 farthest(const Cylinder& c, Vec3 d)
{
    const Real rho = std::hypot(d.x, d.y), k = rho > 0 ? c.radius / rho : 0;
    return {k * d.x, k * d.y, side(d.z, c.half_length)};
}

Vec3 farthest(const Convex& c, Vec3 d)
{
    Vec3 best = c.solid->vertices()[0];
    for (const Vec3 v : c.solid->vertices()) best = dot(d, v) > dot(d, best) ? v : best;
    return best + c.solid->centre();
}

// Positive outside, roughly a distance.
Real beyond(const Sphere& s, Vec3 p) { return length(p) - s.radius; }
Real beyond(const Box& b, Vec3 p) { return max_component(abs(p) - b.half); }
Real beyond(const Capsule& c, Vec3 p)
{
    const Real z = std::clamp(p.z, -c.half_length, c.half_length);
    return length(p - Vec3{0, 0, z}) - c.radius;
}
Real beyond(const Cylinder& c, Vec3 p)
{
    return std::max(std::hypot(p.x, p.y) - c.radius, std::fabs(p.z) - c.half_length);
}
Real beyond(const Convex& c, Vec3 p)
{
    Real largest = -kInf;
    for (const PolyhedronFace& f : c.solid->faces())
        largest = std::max(largest, dot(f.normal, p - c.solid->centre()) - f.offset);
    return largest;
}
Real beyond(const Plane& plane, Vec3 p) { return dot(plane.normal, p) - plane.d; }

Real reach(const Sphere& s) { return s.radius; }
Real reach(const Box& b) { return length(b.half); }
Real reach(const Capsule& c) { return c.radius + c.half_length; }
Real reach(const Cylinder& c) { return std::hypot(c.radius, c.half_length); }
Real reach(const Convex& c) { return length(c.solid->centre()) + c.solid->size(); }
Real reach(const Ray& r) { return r.length; }

void roll(Dice& dice, Sphere& s) { s.radius = dice.between(Real(0.2), 1); }
void roll(Dice& dice, Box& b)
{
    b.half = {dice.between(Real(0.1), 1), dice.between(Real(0.1), 1), dice.between(Real(0.1), 1)};
    if (dice.unit() < Real(0.2)) b.half = {Real(0.5), Real(0.5), Real(0.5)};
}
template <class Round>
requires std::is_same_v<Round, Capsule> || std::is_same_v<Round, Cylinder>
void roll(Dice& dice, Round& c)
{
    c.radius = dice.between(Real(0.1), 1), c.half_length = dice.between(Real(0.1), 1);
    if (dice.unit() < Real(0.2)) c.radius = Real(0.5), c.half_length = Real(0.5);
}
// A box, a prism or a pyramid on a regular polygon, a tetrahedron of any shape, or many points about a ball.
const Polyhedron& random_polyhedron(Dice& dice, Real kinds = 1)
{
    std::vector<Real> points;
    const auto point = [&](Real x, Real y, Real z) { points.insert(points.end(), {x, y, z}); };
    const Real kind = kinds * dice.unit(), h = dice.between(Real(0.2), 1), r = dice.between(Real(0.2), 1);
    if (kind < Real(0.25)) {
        for (int i = 0; i < 8; ++i) point(i & 1 ? h : -h, i & 2 ? r : -r, i & 4 ? h : -h);
    } else if (kind < Real(0.7)) {
        const unsigned n = 3 + unsigned(dice.unit() * 9);
        const bool pyramid = kind > Real(0.5);
        for (unsigned i = 0; i < n; ++i) {
            const Real angle = 2 * kPi * Real(i) / Real(n);
            point(r * std::cos(angle), r * std::sin(angle), -h);
            if (!pyramid) point(r * std::cos(angle), r * std::sin(angle), h);
        }
        if (pyramid) point(0, 0, h);
    } else if (kind < Real(0.9)) {
        for (int i = 0; i < 4; ++i) {
            const Vec3 v = Vec3{i == 0 || i == 3 ? r : -r, i == 1 || i == 3 ? r : -r, i < 2 ? -h : h} +
                           Real(0.15) * r * dice.direction();
            point(v.x, v.y, v.z);
        }
    } else {
        for (int i = 0; i < 60; ++i) {
            const Vec3 v = dice.direction();
            point(r * v.x, r * v.y, h * v.z);
        }
    }
    static std::deque<Polyhedron> made;
    made.emplace_back();
    const char* refusal = made.back().build(points.data(), unsigned(points.size() / 3), 1 << 24, false);
    EXPECT_EQ(refusal, nullptr) << refusal;
    return made.back();
}
void roll(Dice& dice, Convex& c) { c.solid = &random_polyhedron(dice); }
void roll(Dice& dice, Plane& p)
{
    p.normal = dice.unit() < Real(0.5) ? Vec3{0, 0, 1} : dice.direction(), p.d = dice.between(-1, 1);
}
void roll(Dice& dice, Ray& r) { r.length = dice.between(0, 4); }

template <class A, class B>
struct Scene {
    A a;
    Pose pa;
    B b;
    Pose pb;
};

template <class S>
constexpr bool kSolid = !std::is_same_v<S, Plane> && !std::is_same_v<S, Ray>;

template <class A, class B>
constexpr bool kPolyhedra = std::is_same_v<A, Convex> || std::is_same_v<B, Convex>;

// How far b's solid reaches beyond the start of a's along n: moving a by this parts them.
template <class A, class B>
Real overlap_along(const Scene<A, B>& s, Vec3 n)
{
    const Real low = dot(n, s.pa.to_world(farthest(s.a, transposed_times(s.pa.R, -n))));
    if constexpr (std::is_same_v<B, Plane>)
        return dot(n, s.b.normal) > 1 - 16 * kEpsilon ? s.b.d - low : kInf;
    else
        return dot(n, s.pb.to_world(farthest(s.b, transposed_times(s.pb.R, n)))) - low;
}

const std::vector<Vec3>& sphere_points()
{
    static const std::vector<Vec3> points = [] {
        std::vector<Vec3> out;
        const Real golden = kPi * (3 - std::sqrt(Real(5)));
        for (int i = 0; i < kDirections; ++i) {
            const Real z = 1 - (2 * Real(i) + 1) / kDirections, r = std::sqrt(1 - z * z);
            Vec3 n = {r * std::cos(golden * Real(i)), r * std::sin(golden * Real(i)), z};
            normalize(n);
            out.push_back(n);
        }
        return out;
    }();
    return points;
}

// Directions of faces and edges of a solid that has only such, in the world.
template <class S>
std::vector<Vec3> face_normals(const S& s, const Pose& pose)
{
    std::vector<Vec3> out;
    if constexpr (std::is_same_v<S, Convex>)
        for (const PolyhedronFace& f : s.solid->faces()) out.push_back(pose.R * f.normal);
    return out;
}
template <class S>
std::vector<Vec3> edge_directions(const S& s, const Pose& pose)
{
    std::vector<Vec3> out;
    if constexpr (std::is_same_v<S, Convex>)
        for (const Vec3 e : s.solid->edges()) out.push_back(pose.R * e);
    else
        for (int i = 0; i < 3; ++i) out.push_back(pose.R.column(i));
    return out;
}

// Least overlap: the sweep, the normals and the products of edges of both solids, and a pattern search from
// the best few. With flat faces the search creeps along creases: it is cut short, since what touches with
// faces or straight edges is known exactly.
template <class A, class B>
Real least(const Scene<A, B>& s)
{
    if constexpr (std::is_same_v<B, Plane>) return overlap_along(s, s.b.normal);
    std::vector<std::pair<Real, Vec3>> found;
    const auto offer = [&](Vec3 n) { found.push_back({overlap_along(s, n), n}); };
    for (const Vec3& n : sphere_points()) offer(n);
    const auto offer_both = [&](Vec3 n) { offer(n), offer(-n); };
    for (int i = 0; i < 3; ++i) offer_both(s.pa.R.column(i)), offer_both(s.pb.R.column(i));
    for (const Vec3 n : face_normals(s.a, s.pa)) offer_both(n);
    for (const Vec3 n : face_normals(s.b, s.pb)) offer_both(n);
    for (const Vec3 u : edge_directions(s.a, s.pa))
        for (const Vec3 v : edge_directions(s.b, s.pb)) {
            Vec3 n = cross(u, v);
            if (normalize(n)) offer_both(n);
        }
    Vec3 between = s.pa.p - s.pb.p;
    if (normalize(between)) offer(between);
    std::partial_sort(found.begin(), found.begin() + 6, found.end(),
                      [](const auto& x, const auto& y) { return x.first < y.first; });
    constexpr int kMoves = kPolyhedra<A, B> ? 100 : 1 << 30;
    Real best = kInf;
    for (int k = 0; k < 6; ++k) {
        auto [h, n] = found[std::size_t(k)];
        int moves = 0;
        for (Real step = Real(0.03); step > Real(1e-7) && moves < kMoves; ++moves) {
            Vec3 u, v;
            plane_space(n, u, v);
            bool better = false;
            for (int i = 0; i < 16; ++i) {
                const Real angle = Real(i) * kPi / 8;
                Vec3 m = n + step * (std::cos(angle) * u + std::sin(angle) * v);
                normalize(m);
                const Real g = overlap_along(s, m);
                if (g < h) h = g, n = m, better = true;
            }
            if (!better) step *= Real(0.5);
        }
        best = std::min(best, h);
    }
    return best;
}

struct Found {
    dContactGeom contacts[16];
    int count = 0;
    Real depth = -1;
};

template <class A, class B, class F>
Found collide(F function, const Scene<A, B>& s, int capacity = 16)
{
    Found f;
    for (dContactGeom& c : f.contacts) c.depth = -7;
    ContactSink sink(f.contacts, int(sizeof(dContactGeom)), capacity, false);
    function(s.a, s.pa, s.b, s.pb, sink);
    f.count = sink.count();
    for (int i = 0; i < f.count; ++i) f.depth = std::max(f.depth, f.contacts[i].depth);
    return f;
}

template <class A, class B>
Scene<A, B> random_scene(Dice& dice)
{
    Scene<A, B> s;
    roll(dice, s.a), roll(dice, s.b);
    // Directions before their lengths, with every compiler.
    const Vec3 far = dice.direction();
    s.pa = {dice.between(0, 2) * far, dice.rotation()};
    s.pb = {{}, dice.rotation()};
    const Vec3 aside = dice.direction();
    if constexpr (std::is_same_v<B, Plane>)
        s.pa.p = (s.b.d + dice.between(Real(-0.2), reach(s.a))) * s.b.normal + aside;
    else
        s.pb.p = s.pa.p + dice.between(0, Real(1.05)) * (reach(s.a) + reach(s.b)) * aside;
    return s;
}

void check_numbers(const Found& f)
{
    for (int i = 0; i < f.count; ++i) {
        const dContactGeom& c = f.contacts[i];
        const Vec3 n = load(c.normal), p = load(c.pos);
        ASSERT_NEAR(length(n), 1, 16 * kEpsilon);
        ASSERT_GE(c.depth, 0);
        ASSERT_TRUE(std::isfinite(c.depth) && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
    for (int i = f.count; i < 16; ++i) ASSERT_EQ(f.contacts[i].depth, Real(-7)) << "wrote beyond its count";
}

// An edge axis must beat faces by kEdgeHandicap between boxes; nothing else may miss the least depth.
template <class A, class B>
constexpr Real kLoss = std::is_same_v<A, Box>&& std::is_same_v<B, Box> ? Real(1.06) : Real(1.0001);

template <class A, class B, class F>
void check_depth(F function, const Scene<A, B>& s)
{
    const Found f = collide(function, s);
    check_numbers(f);
    const Real truth = least(s);
    if (f.count == 0) {
        ASSERT_LT(truth, Real(1e-4)) << "missed";
        return;
    }
    ASSERT_GT(truth, -kTight) << "reported while apart";
    const Vec3 n = load(f.contacts[0].normal);
    constexpr Real loss = kLoss<A, B>;
    ASSERT_LE(f.depth, truth * loss + kDeeper) << "too deep";
    ASSERT_NEAR(f.depth, overlap_along(s, n), kClaim + (loss - 1) * truth) << "moving apart does not part";
    for (int i = 0; i < f.count; ++i) {
        const Vec3 p = load(f.contacts[i].pos);
        const Real slack = f.contacts[i].depth + Real(1e-4);
        ASSERT_LE(beyond(s.a, s.pa.to_local(p)), slack);
        ASSERT_LE(beyond(s.b, std::is_same_v<B, Plane> ? p : s.pb.to_local(p)), slack);
    }
}

bool in_a_line(const Found& f)
{
    Vec3 first = load(f.contacts[0].pos), line;
    const auto across = [&](int i) {
        const Vec3 d = load(f.contacts[i].pos) - first, n = load(f.contacts[0].normal);
        return d - dot(n, d) * n;
    };
    for (int i = 1; i < f.count; ++i)
        if (length(across(i)) > length(line)) line = across(i);
    for (int i = 1; i < f.count; ++i)
        if (length(cross(line, across(i))) > Real(1e-5) * length2(line)) return false;
    return f.count > 2;
}

template <class A, class B, class F>
void check_capacity(F function, const Scene<A, B>& s)
{
    const Found all = collide(function, s);
    ASSERT_LE(all.count, 4);
    for (int capacity = 1; capacity <= 3; ++capacity) {
        const Found f = collide(function, s, capacity);
        check_numbers(f);
        // Of points in a line, as seen along the normal, only the two ends bear on anything.
        ASSERT_LE(f.count, std::min(capacity, all.count));
        ASSERT_GE(f.count, std::min({capacity, all.count, in_a_line(all) ? 2 : capacity}));
        if (f.count > 0) { ASSERT_NEAR(f.depth, all.depth, Real(1e-4)) << "the deepest must survive"; }
    }
}

template <class A, class F>
void check_exchange(F function, const Scene<A, A>& s)
{
    const Found f = collide(function, s), g = collide(function, Scene<A, A>{s.b, s.pb, s.a, s.pa});
    if (f.count == 0 || g.count == 0) {
        ASSERT_LE(std::max(f.depth, g.depth), Real(1e-6));
        return;
    }
    constexpr Real loss = kLoss<A, A>;
    ASSERT_NEAR(f.depth, g.depth, 2 * kDeeper + (loss - 1) * f.depth);
}

// First place where a ray changes sides, by marching and bisection.
template <class B>
Real march(const Scene<Ray, B>& s, bool& hit)
{
    constexpr int kSteps = 4000;
    const auto outside = [&](Real t) {
        const Vec3 p = s.pa.p + t * s.pa.R.column(2);
        return beyond(s.b, std::is_same_v<B, Plane> ? p : s.pb.to_local(p)) > 0;
    };
    const bool start = outside(0);
    for (int i = 1; i <= kSteps; ++i) {
        Real lo = s.a.length * Real(i - 1) / kSteps, hi = s.a.length * Real(i) / kSteps;
        if (outside(hi) == start) continue;
        for (int k = 0; k < 60; ++k) (outside((lo + hi) / 2) == start ? lo : hi) = (lo + hi) / 2;
        hit = true;
        return hi;
    }
    hit = false;
    return 0;
}

template <class B, class F>
void check_ray(F function, const Scene<Ray, B>& s)
{
    const Found f = collide(function, s);
    check_numbers(f);
    ASSERT_LE(f.count, 1);
    bool hit = false;
    const Real t = march(s, hit);
    const Vec3 d = s.pa.R.column(2);
    if (hit) {
        ASSERT_EQ(f.count, 1) << "missed at " << t;
        ASSERT_NEAR(f.depth, t, 100 * kTight);
    }
    if (f.count == 0) return;
    const Vec3 n = load(f.contacts[0].normal), p = load(f.contacts[0].pos);
    ASSERT_LE(dot(n, d), 100 * kEpsilon) << "the normal must face the ray";
    ASSERT_LE(length(p - (s.pa.p + f.depth * d)), kTight);
    const auto out = [&](Vec3 x) { return beyond(s.b, std::is_same_v<B, Plane> ? x : s.pb.to_local(x)); };
    ASSERT_NEAR(out(p), 0, 10 * kTight);
    ASSERT_GT(std::fabs(out(p + Real(1e-3) * n) - out(p - Real(1e-3) * n)), Real(1e-4))
        << "normal along the surface";
}

template <class A, class B, class F>
void check_pair(F function)
{
    Dice dice(unsigned(sizeof(A) * 31 + sizeof(B)));
    const int few = kPolyhedra<A, B> ? kPoses / 4 : kPoses;  // the sweep takes long
    const int poses = std::is_same_v<A, Ray> || std::is_same_v<B, Plane> ? 10 * few : few;
    int hits = 0;
    for (int i = 0; i < poses; ++i) {
        const Scene<A, B> s = random_scene<A, B>(dice);
        SCOPED_TRACE(i);
        if constexpr (std::is_same_v<A, Ray>) {
            check_ray(function, s);
        } else {
            check_depth(function, s);
            check_capacity(function, s);
            if constexpr (std::is_same_v<A, B>) check_exchange(function, s);
        }
        hits += collide(function, s).count > 0;
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(hits, poses / 8) << "the poses do not try the function";
    EXPECT_LT(hits, poses) << "no pose was apart";
}

// Far more poses without the sweep: whatever is reported must be true.
template <class A, class B, class F>
void check_claims(F function)
{
    if constexpr (kSolid<A>) {
        Dice dice(77);
        for (int i = 0; i < 20 * kPoses; ++i) {
            const Scene<A, B> s = random_scene<A, B>(dice);
            SCOPED_TRACE(i);
            const Found f = collide(function, s);
            check_numbers(f);
            if (f.count > 0) {
                const Real along = overlap_along(s, load(f.contacts[0].normal));
                constexpr Real loss = kLoss<A, B>;
                ASSERT_NEAR(f.depth, along, kClaim + (loss - 1) * std::fabs(along));
            }
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

template <class S>
void flatten(Dice& dice, S& s)
{
    if constexpr (std::is_same_v<S, Sphere>) s.radius = 0;
    if constexpr (std::is_same_v<S, Box>) s.half.set(int(dice.unit() * 3), 0);
    if constexpr (std::is_same_v<S, Box>)
        if (dice.unit() < Real(0.3)) s.half = {};
    if constexpr (std::is_same_v<S, Capsule> || std::is_same_v<S, Cylinder>)
        dice.unit() < Real(0.5) ? s.radius = 0 : s.half_length = 0;
    if constexpr (std::is_same_v<S, Ray>) s.length = 0;
}

template <class A, class B, class F>
void check_degenerate(F function)
{
    Dice dice(5);
    for (int i = 0; i < 4 * kPoses; ++i) {
        Scene<A, B> s = random_scene<A, B>(dice);
        if (dice.unit() < Real(0.5)) s.pb.p = s.pa.p;
        if (dice.unit() < Real(0.3)) s.pb.R = s.pa.R;
        if (dice.unit() < Real(0.5)) flatten(dice, s.a);
        if (dice.unit() < Real(0.5)) flatten(dice, s.b);
        SCOPED_TRACE(i);
        check_numbers(collide(function, s));
        const Real scale = std::pow(Real(10), dice.between(-6, 6));
        s.pa.p *= scale, s.pb.p *= scale;
        check_numbers(collide(function, s));
        if (testing::Test::HasFatalFailure()) return;
    }
}

// Largest distance from a contact of one manifold to the nearest of the other.
Real wander(const Found& f, const Found& g)
{
    Real largest = 0;
    for (int i = 0; i < f.count; ++i) {
        Real nearest = kInf;
        for (int j = 0; j < g.count; ++j)
            nearest = std::min(nearest, length(load(f.contacts[i].pos) - load(g.contacts[j].pos)));
        largest = std::max(largest, nearest);
    }
    return largest;
}

// Middle of all vertices that lie farthest along the direction.
Vec3 middle_of_farthest(const Convex& c, Vec3 d)
{
    const Real extent = dot(d, farthest(c, d) - c.solid->centre());
    Vec3 sum;
    Real count = 0;
    for (const Vec3 v : c.solid->vertices())
        if (dot(d, v) > extent - kTight) sum += v, ++count;
    return sum / count + c.solid->centre();
}
Vec3 level(Vec3 v) { return {v.x, v.y, 0}; }

// a stands or lies on b, a little sunk in; then everything is shaken by a millionth.
template <class A, class B, class F>
void check_steady(F function)
{
    if constexpr (kSolid<A>) {
        Dice dice(11);
        for (int i = 0; i < kPoses; ++i) {
            Scene<A, B> s = random_scene<A, B>(dice);
            // Tips that are not over each other do not meet; only the cubes and prisms are flat above and
            // below.
            if constexpr (std::is_same_v<A, Convex>) s.a.solid = &random_polyhedron(dice, Real(0.5));
            if constexpr (std::is_same_v<B, Convex>) s.b.solid = &random_polyhedron(dice, Real(0.5));
            s.pa.R = s.pb.R = Mat3::identity();
            if (dice.unit() < Real(0.5)) s.pa.R = Dice::turn({1, 0, 0}, kPi / 2);
            if constexpr (std::is_same_v<B, Plane>) s.b = {};
            s.pb.p = {};
            // Round ends of radius 0.1 on each other, sunk in by 4 mm, touch up to 39 mm off the middle.
            s.pa.p = {dice.between(Real(-0.025), Real(0.025)), dice.between(Real(-0.025), Real(0.025)), 0};
            // What lies lowest of a comes over what lies highest of b.
            if constexpr (std::is_same_v<A, Convex>)
                s.pa.p -= level(s.pa.R * middle_of_farthest(s.a, transposed_times(s.pa.R, {0, 0, -1})));
            if constexpr (std::is_same_v<B, Convex>) s.pa.p += level(middle_of_farthest(s.b, {0, 0, 1}));
            const Real sunk = overlap_along(s, {0, 0, 1});
            s.pa.p.z += sunk - Real(0.004);
            const Found f = collide(function, s);
            ASSERT_GT(f.count, 0);
            Scene<A, B> t = s;
            t.pa.p += Real(1e-6) * dice.direction();
            t.pa.R = Dice::turn(dice.direction(), Real(1e-6)) * t.pa.R;
            const Found g = collide(function, t);
            SCOPED_TRACE(i);
            ASSERT_EQ(f.count, g.count);
            ASSERT_LE(wander(f, g), Real(1e-3));
            ASSERT_LE(wander(g, f), Real(1e-3));
            ASSERT_LE(length(load(f.contacts[0].normal) - load(g.contacts[0].normal)), Real(1e-4));
        }
    }
}

}  // namespace

#define PAIR(First, Second, function)                                                        \
    TEST(PairContract, function##_against_sweep) { check_pair<First, Second>(function); }    \
    TEST(PairContract, function##_claims) { check_claims<First, Second>(function); }         \
    TEST(PairContract, function##_degenerate) { check_degenerate<First, Second>(function); } \
    TEST(PairContract, function##_steady) { check_steady<First, Second>(function); }
#include "collide/pairs/pairs.inc"
#undef PAIR
