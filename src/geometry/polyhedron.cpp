// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Building a polyhedron from the client's faces: see polyhedron.h. Lengths are compared with the size of the
// solid: data that come from a file with few digits are let pass (kSlack), while what lies in one plane is
// told more sharply (kFlat). Closed: the vectors normal * area of all faces add up to zero (the divergence
// theorem for a constant field), which needs no two faces to share the numbers of their corners.
#include "geometry/polyhedron.h"

#include <algorithm>

#include "base/check.h"

namespace epode {

namespace {

constexpr Real kSlack = Real(1e-3);  // how far a vertex may stand before a face, of the size
constexpr Real kFlat = kSingle ? Real(1e-5) : Real(1e-7);
constexpr Real kInFace = Real(1e-4);    // a vertex this near to a face's plane belongs to its feature
constexpr Real kParallel = Real(1e-6);  // sine
constexpr int kMost = 1 << 24;          // vertices
constexpr int kCorners = 32;            // of a face; of more, so many evenly chosen ones

}  // namespace

const char* Polyhedron::build(const Real* points, unsigned count, const unsigned* polygons, unsigned faces)
{
    Polyhedron made;
    if (count < 3 || count > unsigned(kMost) || faces < 2) return "too few points or polygons";
    if (!usable(points, int(3 * count))) return "point is not a usable number";
    if (!made.take_points(points, count)) return "out of memory";
    if (!(made.size_ > 0)) return "all points are one";
    for (unsigned i = 0; i < faces; ++i) {
        const unsigned corners = *polygons++;
        if (corners < 3 || corners > count) return "polygon with a wrong number of corners";
        for (unsigned k = 0; k < corners; ++k)
            if (polygons[k] >= count) return "polygon with a corner that is no point";
        if (const char* why = made.take_face(polygons, corners)) return why;
        polygons += corners;
    }
    if (!made.closed()) return "polygons do not close a solid";
    if (!made.take_edges()) return "out of memory";
    swap(made);
    return nullptr;
}

void Polyhedron::swap(Polyhedron& other)
{
    vertices_.swap(other.vertices_), faces_.swap(other.faces_), corners_.swap(other.corners_);
    edges_.swap(other.edges_);
    std::swap(centre_, other.centre_), std::swap(inside_, other.inside_), std::swap(size_, other.size_);
}

bool Polyhedron::take_points(const Real* points, unsigned count)
{
    if (!vertices_.resize(int(count))) return false;
    Vec3 lo{kInf, kInf, kInf}, hi = -lo;
    for (int i = 0; i < int(count); ++i) {
        vertices_[i] = load(points + 3 * i);
        lo = min(lo, vertices_[i]), hi = max(hi, vertices_[i]);
    }
    centre_ = Real(0.5) * (lo + hi);
    for (Vec3& v : vertices_) {
        v -= centre_;
        inside_ += v / Real(count);
        size_ = std::max(size_, length(v));
    }
    return true;
}

// A face without area says nothing and is left out; one in the plane of an earlier face belongs to that.
const char* Polyhedron::take_face(const unsigned* corners, unsigned count)
{
    const Vec3 origin = vertices_[int(corners[0])];
    Vec3 n;
    for (unsigned k = 1; k + 1 < count; ++k)
        n += cross(vertices_[int(corners[k])] - origin, vertices_[int(corners[k + 1])] - origin);
    if (!(length(n) > kFlat * size_ * size_) || !normalize(n)) return nullptr;
    if (dot(n, origin - inside_) < 0) n = -n;
    Face face = {n, -kInf, corners_.size(), 0};
    for (unsigned k = 0; k < count; ++k)
        face.offset = std::max(face.offset, dot(n, vertices_[int(corners[k])]));
    for (const Vec3 v : vertices_)
        if (dot(n, v) > face.offset + kSlack * size_) return "points are not convex";
    for (const Face& known : faces_)
        if (dot(known.normal, n) > 0 && length(cross(known.normal, n)) < kParallel &&
            std::fabs(known.offset - face.offset) < kFlat * size_)
            return nullptr;
    if (!take_corners(face, corners, count)) return "out of memory";
    return face.count < 3 || faces_.push(face) ? nullptr : "out of memory";
}

// The convex outline (Andrew's chain, 1979) of the face's own corners and of the other vertices in its plane.
bool Polyhedron::take_corners(Face& face, const unsigned* own, unsigned count)
{
    Vec3 u, v;
    plane_space(face.normal, u, v);
    Array<int> flat, chain;
    for (unsigned k = 0; k < count; ++k)
        if (!flat.push(int(own[k]))) return false;
    for (int i = 0; i < vertices_.size(); ++i)
        if (face.offset - dot(face.normal, vertices_[i]) < kFlat * size_ && !flat.push(i)) return false;
    const auto x = [&](int i) { return dot(u, vertices_[i]); };
    const auto y = [&](int i) { return dot(v, vertices_[i]); };
    std::sort(flat.begin(), flat.end(), [&](int i, int j) {
        return x(i) != x(j) ? x(i) < x(j) : y(i) != y(j) ? y(i) < y(j) : i < j;
    });
    const auto turns_left = [&](int i, int j, int k) {
        return (x(j) - x(i)) * (y(k) - y(i)) - (y(j) - y(i)) * (x(k) - x(i)) > kFlat * kFlat * size_ * size_;
    };
    const auto extend = [&](int i, int least) {
        int n = chain.size();
        while (n > least && !turns_left(chain[n - 2], chain[n - 1], i)) --n;
        return chain.resize(n) && chain.push(i);
    };
    for (int i = 0; i < flat.size(); ++i)
        if (!extend(flat[i], 1)) return false;
    const int lower = chain.size();
    for (int i = flat.size() - 2; i >= 0; --i)
        if (!extend(flat[i], lower)) return false;
    const int outline = chain.size() - 1, kept = std::min(outline, kCorners);
    if (outline < 3) return true;
    face.count = kept;
    for (int i = 0; i < kept; ++i)
        if (!corners_.push(chain[int(std::int64_t(i) * outline / kept)])) return false;
    return true;
}

bool Polyhedron::closed() const
{
    Vec3 sum;
    Real all = 0;
    for (const Face& f : faces_) {
        Vec3 area;
        for (int k = 1; k + 1 < f.count; ++k)
            area += cross(vertices_[corners_[f.first + k]] - vertices_[corners_[f.first]],
                          vertices_[corners_[f.first + k + 1]] - vertices_[corners_[f.first]]);
        sum += area;
        all += length(area);
    }
    return all > 0 && length(sum) <= Real(0.02) * all;
}

bool Polyhedron::take_edges()
{
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

int Polyhedron::farthest(Vec3 direction) const
{
    int best = 0;
    Real most = -kInf;
    for (int i = 0; i < vertices_.size(); ++i) {
        const Real along = dot(direction, vertices_[i]);
        if (along > most) most = along, best = i;
    }
    return best;
}

void Polyhedron::feature(Vec3 direction, Polygon& out) const
{
    const Vec3 top = support(direction);
    const Face* shown = nullptr;
    Real most = -kInf;
    for (const Face& f : faces_) {
        const Real along = dot(f.normal, direction);
        if (along > most && f.offset - dot(f.normal, top) < kInFace * size_) most = along, shown = &f;
    }
    if (!shown) return out.add(top);
    for (int k = 0; k < shown->count; ++k) out.add(vertices_[corners_[shown->first + k]]);
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
    view.local_support = support_of;
    view.local_feature = feature_of;
    view.pose = {pose.to_world(solid.centre()), pose.R};
    view.size = solid.size();
    view.faces = solid.faces();
    view.edges = solid.edges();
    return view;
}

}  // namespace epode
