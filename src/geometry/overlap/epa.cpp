// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The expanding polytope: see epa.h. Vertices and faces live in arrays on the stack; a run that would outgrow
// them stops with the best normal found, which is a true upper bound of the depth.
#include "geometry/overlap/epa.h"

#include <algorithm>
#include <utility>

namespace epode {

namespace {

constexpr int kVertices = 96;
constexpr int kMaxFaces = 256;
constexpr int kMaxEdges = 192;

// Plain numbers, so that the arrays below cost nothing until they are used.
struct Face {
    int v[3];
    Real n[3];
    Real distance;  // of its plane from the origin, signed; kInf: no area, never expanded
    Vec3 normal() const { return load(n); }
};

class Polytope {
  public:
    Polytope(const ConvexView& a, const ConvexView& b, Overlap& best) : a_(a), b_(b), best_(best) {}

    bool start(Vec3 direction);
    // The face with the least distance, or -1.
    int nearest() const
    {
        int k = -1;
        for (int i = 0; i < face_count_; ++i)
            if (faces_[i].distance < (k < 0 ? kInf : faces_[k].distance)) k = i;
        return k;
    }
    const Face& face(int i) const { return faces_[i]; }
    bool has_capacity() const { return vertex_count_ < kVertices; }
    Vec3 sample(Vec3 n);
    bool grow(Vec3 p, int from);

  private:
    bool add_face(int i, int j, int k);
    void add_edge(int i, int j);
    static bool share_edge(const Face& f, const Face& g);
    int find_cap(Vec3 p, int from);
    Vec3 farther(Vec3 n, Vec3 from, Real& gain);

    const ConvexView& a_;
    const ConvexView& b_;
    Overlap& best_;
    Real vertices_[kVertices][3];
    Face faces_[kMaxFaces];
    int edges_[kMaxEdges][2];
    int seen_[kMaxFaces];
    int vertex_count_ = 0, face_count_ = 0, edge_count_ = 0;
    Real scale_ = 0;
};

// Support point in direction n, remembering n when it is the least so far.
Vec3 Polytope::sample(Vec3 n)
{
    const Extent e = extent(a_, b_, n);
    if (e.h < best_.depth) best_.depth = e.h, best_.normal = n;
    return e.point;
}

// Of the support points along n and -n, the one farther from `from` along that axis.
Vec3 Polytope::farther(Vec3 n, Vec3 from, Real& gain)
{
    const Vec3 p = sample(n), q = sample(-n);
    const Real up = dot(n, p - from), down = dot(n, from - q);
    gain = up >= down ? up : down;
    return up >= down ? p : q;
}

// Four points with volume; false when C is flat.
bool Polytope::start(Vec3 direction)
{
    const Vec3 axis = normalized_or(direction, {1, 0, 0});
    Vec3 u, v;
    plane_space(axis, u, v);
    Vec3 p[4];
    Real gain = 0;
    scale_ = a_.size + b_.size;
    const Real thin = 64 * kEpsilon * (scale_ + length(direction));
    p[0] = sample(axis);
    p[1] = sample(-axis);
    if (length(p[1] - p[0]) <= thin) p[1] = farther(u, p[0], gain);
    if (length(p[1] - p[0]) <= thin) p[1] = farther(v, p[0], gain);
    Vec3 line = p[1] - p[0];
    if (length(line) <= thin || !normalize(line)) return false;
    plane_space(line, u, v);
    p[2] = farther(u, p[0], gain);
    if (gain <= thin) p[2] = farther(v, p[0], gain);
    if (gain <= thin) return false;
    Vec3 n = cross(line, p[2] - p[0]);
    if (!normalize(n)) return false;
    p[3] = farther(n, p[0], gain);
    if (gain <= thin) return false;
    if (dot(n, p[3] - p[0]) > 0) std::swap(p[1], p[2]);
    for (Vec3 q : p) store(vertices_[vertex_count_++], q);
    return add_face(0, 1, 2) && add_face(0, 3, 1) && add_face(1, 3, 2) && add_face(2, 3, 0);
}

bool Polytope::add_face(int i, int j, int k)
{
    if (face_count_ == kMaxFaces) return false;
    Face& f = faces_[face_count_++];
    f.v[0] = i, f.v[1] = j, f.v[2] = k;
    const Vec3 origin = load(vertices_[i]), e1 = load(vertices_[j]) - origin,
               e2 = load(vertices_[k]) - origin;
    Vec3 normal = cross(e1, e2);
    const Real area2 = length2(normal);
    const bool flat = !(area2 > 16 * kEpsilon * kEpsilon * length2(e1) * length2(e2)) || !normalize(normal);
    store(f.n, normal);
    f.distance = flat ? kInf : dot(normal, origin);
    return true;
}

// Edges met once from either side are the horizon; an edge met from both sides lies inside the removed cap.
void Polytope::add_edge(int i, int j)
{
    for (int k = 0; k < edge_count_; ++k)
        if (edges_[k][0] == j && edges_[k][1] == i) {
            --edge_count_;
            edges_[k][0] = edges_[edge_count_][0], edges_[k][1] = edges_[edge_count_][1];
            return;
        }
    if (edge_count_ < kMaxEdges) edges_[edge_count_][0] = i, edges_[edge_count_][1] = j, ++edge_count_;
}

bool Polytope::share_edge(const Face& f, const Face& g)
{
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            if (f.v[i] == g.v[(k + 1) % 3] && f.v[(i + 1) % 3] == g.v[k]) return true;
    return false;
}

// The faces that p can see and that hang together with face `from`, as the first entries of `seen_`. Rounding
// shows p faces elsewhere too, nearly in line with it: to remove those would tear the surface. A face
// without area cannot be asked and goes with its neighbours.
int Polytope::find_cap(Vec3 p, int from)
{
    const Real hair = 4 * kEpsilon * scale_;
    int count = 0, cap = 1;
    seen_[count++] = from;
    for (int i = 0; i < face_count_; ++i) {
        const Face& f = faces_[i];
        if (i != from && (f.distance == kInf || dot(f.normal(), p) - f.distance > hair)) seen_[count++] = i;
    }
    for (int done = 0; done < cap; ++done)
        for (int i = cap; i < count; ++i)
            if (share_edge(faces_[seen_[done]], faces_[seen_[i]])) std::swap(seen_[cap++], seen_[i]);
    return cap;
}

// Replaces the cap that p can see around face `from` by a fan from the cap's rim to p.
bool Polytope::grow(Vec3 p, int from)
{
    edge_count_ = 0;
    const int cap = find_cap(p, from);
    for (int i = 0; i < cap; ++i) {
        const Face& f = faces_[seen_[i]];
        for (int k = 0; k < 3; ++k) add_edge(f.v[k], f.v[(k + 1) % 3]);
    }
    std::sort(seen_, seen_ + cap);
    for (int i = cap; i-- > 0;) faces_[seen_[i]] = faces_[--face_count_];
    if (edge_count_ == 0) return false;
    const int tip = vertex_count_;
    store(vertices_[vertex_count_++], p);
    for (int k = 0; k < edge_count_; ++k)
        if (!add_face(edges_[k][0], edges_[k][1], tip)) return false;
    return true;
}

}  // namespace

void expand(const ConvexView& a, const ConvexView& b, Real tolerance, Real enough, Overlap& best)
{
    Polytope polytope(a, b, best);
    if (!polytope.start(b.pose.p - a.pose.p)) return;
    while (polytope.has_capacity() && best.depth >= enough) {
        const int k = polytope.nearest();
        if (k < 0) return;
        const Face f = polytope.face(k);
        if (best.depth - f.distance <= tolerance) return;
        const Vec3 p = polytope.sample(f.normal());
        if (dot(f.normal(), p) - f.distance <= tolerance || !polytope.grow(p, k)) return;
    }
}

}  // namespace epode
