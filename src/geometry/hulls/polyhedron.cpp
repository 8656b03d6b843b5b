// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Building a polyhedron from points: see polyhedron.h. Normals are summed over each face from the points
// themselves, in double: the faces of a cube have normals without rounding.
#include "geometry/hulls/polyhedron.h"

#include <algorithm>
#include <bit>

#include "base/check.h"
#include "geometry/hulls/hull_faces.h"

namespace epode {

namespace {

// What lies in one plane, of the size: data that come from a file have few digits.
constexpr Real kFlat = kSingle ? Real(1e-5) : Real(1e-6);
constexpr Real kInFace = Real(1e-4);    // a vertex this near to a face's plane belongs to its feature
constexpr Real kParallel = Real(1e-6);  // sine
constexpr int kMaxPoints = 1 << 24;     // points
constexpr int kCorners = 32;            // of a feature; of more, so many evenly chosen ones
constexpr int kFew = 32;                // vertices that are all tried
constexpr const char* kAllInOnePlane = "all points lie in a plane";

Vec3d wide(Vec3 v) { return {double(v.x), double(v.y), double(v.z)}; }
Vec3d minus(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

// The outline of points in the plane across n (Andrew's chain, 1979), counter-clockwise about n.
bool outline_of(std::span<const Vec3> points, Vec3 n, Real slack, Array<int>& chain)
{
    Vec3 u, v;
    plane_space(n, u, v);
    Array<int> order;
    for (int i = 0; i < int(points.size()); ++i)
        if (!order.push(i)) return false;
    const auto x = [&](int i) { return dot(u, points[std::size_t(i)]); };
    const auto y = [&](int i) { return dot(v, points[std::size_t(i)]); };
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        return x(i) != x(j) ? x(i) < x(j) : y(i) != y(j) ? y(i) < y(j) : i < j;
    });
    const auto extend = [&](int i, int least) {
        const auto left = [&](int j, int k) {
            return (x(k) - x(j)) * (y(i) - y(j)) - (y(k) - y(j)) * (x(i) - x(j)) > slack;
        };
        int count = chain.size();
        while (count > least && !left(chain[count - 2], chain[count - 1])) --count;
        chain.truncate(count);
        return chain.push(i);
    };
    for (const int i : order)
        if (!extend(i, 1)) return false;
    const int lower = chain.size();
    for (int k = order.size() - 2; k >= 0; --k)
        if (!extend(order[k], lower)) return false;
    chain.pop();
    return true;
}

}  // namespace

const char* Polyhedron::build(const Real* points, unsigned count, int max_vertices, bool plates)
{
    if (count < 3 || count > unsigned(kMaxPoints)) return "too few or too many points";
    if (!usable(points, int(3 * count))) return "point is not a usable number";
    Array<Vec3> all;
    if (!all.resize(int(count))) return "out of memory";
    for (int i = 0; i < int(count); ++i) all[i] = load(points + 3 * i);
    Polyhedron made;
    const char* refusal = made.take_hull(all.span(), max_vertices);
    if (refusal == kAllInOnePlane && plates) refusal = made.take_plate(all.span());
    if (refusal) return refusal;
    if (!made.take_all()) return "out of memory";
    swap(made);
    return nullptr;
}

// What follows from vertices and faces.
bool Polyhedron::take_all()
{
    if (!take_edges() || !take_seams() || !take_neighbours() || !take_lanes()) return false;
    take_inner();
    return true;
}

void Polyhedron::swap(Polyhedron& other)
{
    vertices_.swap(other.vertices_), faces_.swap(other.faces_), corners_.swap(other.corners_);
    edges_.swap(other.edges_), seams_.swap(other.seams_), first_.swap(other.first_),
        neighbours_.swap(other.neighbours_);
    around_.swap(other.around_);
    vertex_lanes_.swap(other.vertex_lanes_), face_lanes_.swap(other.face_lanes_);
    std::swap(start_, other.start_), std::swap(centre_, other.centre_), std::swap(size_, other.size_);
    std::swap(inner_, other.inner_), std::swap(inner_radius_, other.inner_radius_);
}

const char* Polyhedron::take_hull(std::span<const Vec3> points, int max_vertices)
{
    Hull hull;
    switch (convex_hull(points, kFlat, max_vertices, hull)) {
        case HullFault::kPoint:
            return "all points are one";
        case HullFault::kLine:
            return "all points lie on a line";
        case HullFault::kPlane:
            return kAllInOnePlane;
        case HullFault::kMemory:
            return "out of memory";
        case HullFault::kNone:
            break;
    }
    if (!take_vertices(points, hull.vertices.span())) return "out of memory";
    const int* at = hull.faces.begin();
    for (const Vec3 n : hull.normals) {
        const int count = *at++;
        if (!take_face({at, std::size_t(count)}, n)) return "out of memory";
        at += count;
    }
    return nullptr;
}

// Two faces, back to back.
const char* Polyhedron::take_plate(std::span<const Vec3> points)
{
    Vec3 lo = points[0], hi = lo;
    for (const Vec3 p : points) lo = min(lo, p), hi = max(hi, p);
    // The normal of the largest triangle on the two points farthest apart.
    const auto farthest = [&](auto measure) {
        return *std::max_element(points.begin(), points.end(),
                                 [&](Vec3 p, Vec3 q) { return measure(p) < measure(q); });
    };
    const Vec3 a = farthest([&](Vec3 p) { return length2(p - lo); });
    const Vec3 b = farthest([&](Vec3 p) { return length2(p - a); });
    const Vec3 c = farthest([&](Vec3 p) { return length2(cross(b - a, p - a)); });
    Vec3 n = cross(b - a, c - a);
    if (!normalize(n)) return "all points lie on a line";
    Array<int> chain, turned;
    const Real extent = max_component(hi - lo);
    if (!outline_of(points, n, kFlat * extent * extent, chain)) return "out of memory";
    if (chain.size() < 3) return "all points lie on a line";
    if (!take_vertices(points, chain.span())) return "out of memory";
    for (int i = 0; i < chain.size(); ++i) chain[i] = i;
    for (int i = chain.size(); i-- > 0;)
        if (!turned.push(i)) return "out of memory";
    return take_face(chain.span(), n) && take_face(turned.span(), -n) ? nullptr : "out of memory";
}

bool Polyhedron::take_vertices(std::span<const Vec3> points, std::span<const int> chosen)
{
    if (!vertices_.resize(int(chosen.size()))) return false;
    Vec3 lo{kInf, kInf, kInf}, hi = -lo;
    for (int i = 0; i < vertices_.size(); ++i) {
        vertices_[i] = points[std::size_t(chosen[std::size_t(i)])];
        lo = min(lo, vertices_[i]), hi = max(hi, vertices_[i]);
    }
    centre_ = Real(0.5) * lo + Real(0.5) * hi;
    for (Vec3& v : vertices_) {
        v -= centre_;
        size_ = std::max(size_, length(v));
    }
    return true;
}

// `fallback`: the normal of a face so thin that its points do not tell it.
bool Polyhedron::take_face(std::span<const int> corners, Vec3 fallback)
{
    const auto corner = [&](std::size_t k) { return wide(vertices_[corners[k]]); };
    Vec3d sum;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        const Vec3d area = minus(corner(k), corner(0)).cross(minus(corner(k + 1), corner(0)));
        sum = {sum.x + area.x, sum.y + area.y, sum.z + area.z};
    }
    const double twice = sum.length();
    Face face = {fallback, -kInf, corners_.size(), int(corners.size())};
    if (twice > 1e-12 * double(size_) * double(size_))
        face.normal = {Real(sum.x / twice), Real(sum.y / twice), Real(sum.z / twice)};
    for (const int c : corners) {
        face.offset = std::max(face.offset, dot(face.normal, vertices_[c]));
        if (!corners_.push(c)) return false;
    }
    return faces_.push(face);
}

bool Polyhedron::take_edges()
{
    if (faces_.size() > kNamedFaces) return true;
    for (const Face& f : faces_)
        for (int k = 0; k < f.count; ++k) {
            Vec3 edge = vertices_[corners_[f.first + (k + 1) % f.count]] - vertices_[corners_[f.first + k]];
            if (!normalize(edge)) continue;
            const bool known = std::any_of(edges_.begin(), edges_.end(), [&](Vec3 other) {
                return length2(cross(edge, other)) < kParallel * kParallel;
            });
            if (!known && !edges_.push(edge)) return false;
        }
    return true;
}

// Each side of a face goes from i to j, and the same edge's other face has it from j to i: sorted by its
// vertices, the two stand side by side.
bool Polyhedron::take_seams()
{
    Array<PolyhedronEdge> sides;
    for (int f = 0; f < faces_.size(); ++f)
        for (int k = 0; k < faces_[f].count; ++k) {
            const int i = corners_[faces_[f].first + k];
            const int j = corners_[faces_[f].first + (k + 1) % faces_[f].count];
            if (!sides.push(i < j ? PolyhedronEdge{i, j, f, -1, 0} : PolyhedronEdge{j, i, -1, f, 0}))
                return false;
        }
    std::sort(sides.begin(), sides.end(), [](const PolyhedronEdge& a, const PolyhedronEdge& b) {
        return a.from != b.from ? a.from < b.from : a.to != b.to ? a.to < b.to : a.left > b.left;
    });
    for (int k = 0; k + 1 < sides.size(); ++k) {
        PolyhedronEdge seam = sides[k];
        const PolyhedronEdge& other = sides[k + 1];
        if (seam.from != other.from || seam.to != other.to || seam.left < 0 || other.right < 0) continue;
        seam.right = other.right;
        seam.cos_half = Real(0.5) * length(faces_[seam.left].normal + faces_[seam.right].normal);
        if (!seams_.push(seam)) return false;
        ++k;
    }
    return true;
}

void Polyhedron::take_inner()
{
    for (const Vec3 v : vertices_) inner_ += v / Real(vertices_.size());
    inner_radius_ = kInf;
    for (const Face& f : faces_) inner_radius_ = std::min(inner_radius_, f.offset - dot(f.normal, inner_));
    inner_radius_ = std::max(inner_radius_, Real(0));
}

// Each edge is met once from either face: from i to its next corner.
bool Polyhedron::take_neighbours()
{
    if (vertices_.size() <= kFew) return true;
    if (!first_.resize(vertices_.size() + 1) || !neighbours_.resize(corners_.size()) ||
        !around_.resize(corners_.size()))
        return false;
    for (const int c : corners_) ++first_[c + 1];
    for (int i = 0; i < vertices_.size(); ++i) first_[i + 1] += first_[i];
    Array<int> filled;
    if (!filled.resize(vertices_.size())) return false;
    for (int f = 0; f < faces_.size(); ++f)
        for (int k = 0; k < faces_[f].count; ++k) {
            const int i = corners_[faces_[f].first + k];
            const int at = first_[i] + filled[i]++;
            neighbours_[at] = corners_[faces_[f].first + (k + 1) % faces_[f].count];
            around_[at] = f;
        }
    for (int octant = 0; octant < 8; ++octant)
        start_[octant] = climb({octant & 1 ? Real(1) : Real(-1), octant & 2 ? Real(1) : Real(-1),
                                octant & 4 ? Real(1) : Real(-1)});
    return true;
}

bool Polyhedron::take_lanes()
{
    return (!first_.empty() || vertex_lanes_.take(vertices())) && face_lanes_.take_planes(faces());
}

int Polyhedron::climb(Vec3 direction) const
{
    int best = start_[(direction.x > 0 ? 1 : 0) | (direction.y > 0 ? 2 : 0) | (direction.z > 0 ? 4 : 0)];
    Real largest = dot(direction, vertices_[best]);
    for (int at = -1; at != best;) {
        at = best;
        for (int k = first_[at]; k < first_[at + 1]; ++k) {
            const Real along = dot(direction, vertices_[neighbours_[k]]);
            if (along > largest) largest = along, best = neighbours_[k];
        }
    }
    return best;
}

Real Polyhedron::reach(Vec3 direction) const
{
    if (!first_.empty()) return dot(direction, vertices_[climb(direction)]);
    const QuadVec d = quad_vec(direction);
    Quad largest = quad(-kInf);
    for (int g = 0; g < vertex_lanes_.groups(); ++g)
        largest = larger(dots(vertex_lanes_.group(g), d), largest);
    return largest_lane(largest);
}

void Polyhedron::extent(Vec3 direction, Real& low, Real& high) const
{
    if (!first_.empty()) {
        low = dot(direction, vertices_[climb(-direction)]),
        high = dot(direction, vertices_[climb(direction)]);
        return;
    }
    const QuadVec d = quad_vec(direction);
    Quad least = quad(kInf), largest = quad(-kInf);
    for (int g = 0; g < vertex_lanes_.groups(); ++g) {
        const Quad along = dots(vertex_lanes_.group(g), d);
        least = smaller(along, least), largest = larger(along, largest);
    }
    low = -largest_lane(quad(0) - least), high = largest_lane(largest);
}

int Polyhedron::farthest(Vec3 direction) const
{
    if (!first_.empty()) return climb(direction);
    const QuadVec d = quad_vec(direction);
    const int groups = std::min(vertex_lanes_.groups(), kFew / DotLanes::kWide);
    Real along[kFew];
    Quad largest = quad(-kInf);
    for (int g = 0; g < groups; ++g) {
        const Quad some = dots(vertex_lanes_.group(g), d);
        store_quad(along + g * DotLanes::kWide, some);
        largest = larger(some, largest);
    }
    const std::uint64_t best = as_large(along, groups, largest_lane(largest));
    return best ? std::countr_zero(best) : 0;
}

void Polyhedron::feature(Vec3 direction, Polygon& out) const
{
    const int highest = farthest(direction);
    const Vec3 top = vertices_[highest];
    const Face *shown = nullptr, *second = nullptr, *third = nullptr;
    Real largest = -kInf, second_largest = -kInf, third_largest = -kInf;
    const auto consider = [&](const Face& f) {
        const Real along = dot(f.normal, direction);
        if (along <= third_largest || f.offset - dot(f.normal, top) >= kInFace * size_) return;
        third_largest = along, third = &f;
        if (third_largest > second_largest)
            std::swap(third_largest, second_largest), std::swap(third, second);
        if (second_largest > largest) std::swap(second_largest, largest), std::swap(second, shown);
    };
    if (faces_.size() <= kNamedFaces || first_.empty()) {
        const QuadVec at = quad_vec(top);
        const Quad limit = quad(kInFace * size_);
        for (int g = 0; g < face_lanes_.groups(); ++g) {
            const Real* const some = face_lanes_.group(g);
            unsigned at_top = ~bits(limit <= offsets(some) - dots(some, at)) & 15;
            for (; at_top; at_top &= at_top - 1)
                if (const int f = g * DotLanes::kWide + __builtin_ctz(at_top); f < faces_.size())
                    consider(faces_[f]);
        }
    } else
        for (int k = first_[highest]; k < first_[highest + 1]; ++k) consider(faces_[around_[k]]);
    if (!shown) return out.add(top);
    const Real size = length(direction);
    if (second && lean_alike(size - largest, size - second_largest, size))
        return third && lean_alike(size - largest, size - third_largest, size)
                   ? out.add(top)
                   : add_shared(*shown, *second, top, out);
    const int count = shown->count, kept = std::min(count, kCorners);
    const auto corner = [&](int k) { return vertices_[corners_[shown->first + k]]; };
    for (int k = 0; k < kept; ++k) out.add(corner(kept == count ? k : int(std::int64_t(k) * count / kept)));
    out.normal = shown->normal;
}

// The edge between two faces, or the point where they meet.
void Polyhedron::add_shared(const Face& f, const Face& g, Vec3 top, Polygon& out) const
{
    const int first = out.count;
    for (int k = 0; k < f.count; ++k)
        for (int j = 0; j < g.count; ++j)
            if (corners_[f.first + k] == corners_[g.first + j]) out.add(vertices_[corners_[f.first + k]]);
    if (out.count == first + 2) return;
    out.count = first;
    out.add(top);
}

MassProperties Polyhedron::mass() const
{
    MeshMoments moments;
    for (const Face& f : faces_)
        for (int k = 1; k + 1 < f.count; ++k)
            moments.add_triangle(vertices_[corners_[f.first]], vertices_[corners_[f.first + k]],
                                 vertices_[corners_[f.first + k + 1]]);
    return translated(moments.properties(1), centre_);
}

namespace {

Vec3 support_of(const void* shape, Vec3 d) { return static_cast<const Polyhedron*>(shape)->support(d); }
void feature_of(const void* shape, Vec3 d, Polygon& out)
{
    static_cast<const Polyhedron*>(shape)->feature(d, out);
}

}  // namespace

// The view's origin is the middle of the solid.
ConvexView view_of(const Convex& convex, const Pose& pose)
{
    const Polyhedron& solid = *convex.solid;
    ConvexView view;
    view.shape = &solid;
    view.kind = SolidKind::kPolyhedron;
    view.local_support = support_of;
    view.local_feature = feature_of;
    view.pose = {pose.to_world(solid.centre()), pose.R};
    view.size = solid.size();
    view.faces = solid.faces();
    view.edges = solid.edges();
    return view;
}

}  // namespace epode
