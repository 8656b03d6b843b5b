// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Box against box: see box_box.h.
// With C = A^T B and p = A^T (b - a), the overlap along a unit axis L is  r_a(L) + r_b(L) - |p . L|, where
// r(L) is the box's half extent along L. For L = a_i x b_j every projection is a product of entries of C, and
// |L|^2 = 1 - C_ij^2.
#include "geometry/box_box.h"

#include "geometry/clip.h"
#include "geometry/closest.h"

namespace epode {

namespace {

constexpr Real kFaceMargin = Real(1e-5);  // of the sizes

// Plain arrays: the loops below run over axes.
struct Frames {
    Real c[3][3], m[3][3];  // C and |C|
    Real ha[3], hb[3];
    Real pa[3], pb[3];  // from a to b, in a's frame and in b's
    Real size, touch;
};

Frames frames_of(const Box& a, const Pose& A, const Box& b, const Pose& B)
{
    Frames f;
    const Mat3 C = transpose(A.R) * B.R;
    store(f.c[0], C.row0), store(f.c[1], C.row1), store(f.c[2], C.row2);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) f.m[i][j] = std::fabs(f.c[i][j]);
    store(f.ha, a.half), store(f.hb, b.half);
    const Vec3 p = transposed_times(A.R, B.p - A.p);
    store(f.pa, p), store(f.pb, transposed_times(C, p));
    f.size = max_component(a.half) + max_component(b.half);
    f.touch = 8 * kEpsilon * (f.size + max_component(abs(p)));
    return f;
}

// The best axis so far.
struct Search {
    Real depth = kInf;  // true overlap
    Real score = kInf;  // with the handicap
    int code = 0;
    bool flip = false;  // the axis points from b to a
    // False: apart along this axis.
    bool offer(Real overlap, Real handicap, Real along, int c, Real touch, Real margin = 0)
    {
        if (overlap < -touch) return false;
        if (overlap < 0) overlap = 0;
        if (overlap * handicap + margin < score) {
            score = overlap * handicap + margin;
            depth = overlap;
            code = c;
            flip = along < 0;
        }
        return true;
    }
};

bool search_faces(const Frames& f, Search& s)
{
    for (int i = 0; i < 3; ++i) {
        const Real rb = f.m[i][0] * f.hb[0] + f.m[i][1] * f.hb[1] + f.m[i][2] * f.hb[2];
        if (!s.offer(f.ha[i] + rb - std::fabs(f.pa[i]), 1, f.pa[i], 1 + i, f.touch)) return false;
    }
    // The second box's faces must be better by more than the jitter of a resting stack, so that boxes lying
    // flat on each other keep their roles.
    for (int j = 0; j < 3; ++j) {
        const Real ra = f.m[0][j] * f.ha[0] + f.m[1][j] * f.ha[1] + f.m[2][j] * f.ha[2];
        if (!s.offer(f.hb[j] + ra - std::fabs(f.pb[j]), 1, f.pb[j], 4 + j, f.touch, kFaceMargin * f.size))
            return false;
    }
    return true;
}

bool search_edges(const Frames& f, Search& s)
{
    constexpr int kNext[3] = {1, 2, 0}, kLast[3] = {2, 0, 1};
    for (int i = 0; i < 3; ++i) {
        const int i1 = kNext[i], i2 = kLast[i];
        for (int j = 0; j < 3; ++j) {
            const int j1 = kNext[j], j2 = kLast[j];
            const Real sine2 = 1 - f.c[i][j] * f.c[i][j];
            if (sine2 < Real(1e-6)) continue;  // parallel edges: a face direction does as well
            const Real along = f.pa[i2] * f.c[i1][j] - f.pa[i1] * f.c[i2][j];
            const Real ra = f.ha[i1] * f.m[i2][j] + f.ha[i2] * f.m[i1][j];
            const Real rb = f.hb[j1] * f.m[i][j2] + f.hb[j2] * f.m[i][j1];
            const Real overlap = ra + rb - std::fabs(along);  // times |L| = sqrt(sine2) <= 1
            if (overlap > s.score) continue;                  // cannot win, nor part
            if (!s.offer(overlap / std::sqrt(sine2), kEdgeHandicap, along, 7 + 3 * i + j, f.touch,
                         kFaceMargin * f.size))
                return false;
        }
    }
    return true;
}

bool search(const Frames& f, Search& s) { return search_faces(f, s) && search_edges(f, s); }

// Both boxes seen from the reference one: its frame, and the other's pose in it.
struct Incident {
    Vec3 p;
    Mat3 R;  // columns: the incident box's axes
    Vec3 half;
};

// Corners of the incident face that looks most against `normal`, counter-clockwise about its outward side.
void incident_face(const Incident& box, Vec3 normal, Polygon& out)
{
    const Vec3 d = transposed_times(box.R, normal), m = abs(d);
    const int k = m.x >= m.y ? (m.x >= m.z ? 0 : 2) : (m.y >= m.z ? 1 : 2);
    const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    const Vec3 u = box.half[k1] * box.R.column(k1), v = box.half[k2] * box.R.column(k2);
    const Vec3 centre = box.p + (d[k] > 0 ? -box.half[k] : box.half[k]) * box.R.column(k);
    out.add(centre + u + v), out.add(centre - u + v), out.add(centre - u - v), out.add(centre + u - v);
}

// Cuts the incident face by the sides of reference face `k` on side `sign`, and keeps what lies below it.
void face_points(Vec3 half, const Incident& other, int k, Real sign, const Pose& world, BoxBox& out)
{
    Vec3 normal;
    normal.set(k, sign);
    Polygon face;
    incident_face(other, normal, face);
    const Real slack = 32 * kEpsilon * (max_component(half) + max_component(other.half));
    for (int side = 1; side <= 2; ++side) {
        const int axis = (k + side) % 3;
        clip(face, axis, 1, half[axis], slack);
        clip(face, axis, -1, half[axis], slack);
    }
    for (int i = 0; i < face.count && out.count < BoxBox::kMax; ++i) {
        const Real depth = half[k] - sign * face.points[i][k];
        if (depth < -slack) continue;
        out.depths[out.count] = depth > 0 ? depth : Real(0);
        out.points[out.count++] = world.to_world(face.points[i]);
    }
}

// The ends of the edge along axis i that lies farthest along `towards`.
void supporting_edge(Vec3 half, const Pose& pose, int i, Vec3 towards, Vec3& from, Vec3& to)
{
    const Vec3 d = transposed_times(pose.R, towards);
    Vec3 corner = {d.x >= 0 ? half.x : -half.x, d.y >= 0 ? half.y : -half.y, d.z >= 0 ? half.z : -half.z};
    corner.set(i, -half[i]);
    from = pose.to_world(corner);
    corner.set(i, half[i]);
    to = pose.to_world(corner);
}

void edge_point(const Box& a, const Pose& A, const Box& b, const Pose& B, int i, int j, BoxBox& out)
{
    Vec3 a1, a2, b1, b2, p, q;
    supporting_edge(a.half, A, i, out.normal, a1, a2);
    supporting_edge(b.half, B, j, -out.normal, b1, b2);
    closest_segment_points(a1, a2, b1, b2, p, q);
    out.points[0] = Real(0.5) * (p + q);
    out.depths[0] = out.depth;
    out.count = 1;
}

// Corners of b's side-cut face can miss the reference face when a handicapped edge axis was the true answer.
void lowest_corner(const Pose& A, const Box& b, const Pose& B, bool reference_is_a, const Box& a, BoxBox& out)
{
    const Pose& P = reference_is_a ? B : A;
    const Vec3 half = reference_is_a ? b.half : a.half;
    Vec3 from, to;
    supporting_edge(half, P, 0, reference_is_a ? -out.normal : out.normal, from, to);
    const Vec3 inward = reference_is_a ? out.normal : -out.normal;
    out.points[0] = dot(inward, from) <= dot(inward, to) ? from : to;
    out.depths[0] = out.depth;
    out.count = 1;
}

}  // namespace

bool boxes_touch(const Box& a, const Pose& A, const Box& b, const Pose& B)
{
    Search s;
    return search(frames_of(a, A, b, B), s);
}

bool box_box_manifold(const Box& a, const Pose& A, const Box& b, const Pose& B, BoxBox& out)
{
    const Frames f = frames_of(a, A, b, B);
    Search s;
    if (!search(f, s)) return false;
    const Mat3 C = {load(f.c[0]), load(f.c[1]), load(f.c[2])};
    out.code = s.code;
    out.depth = s.depth;
    out.count = 0;
    const Real sign = s.flip ? Real(-1) : Real(1);
    if (s.code <= 3) {
        const int k = s.code - 1;
        out.normal = sign * A.R.column(k);
        face_points(a.half, {load(f.pa), C, b.half}, k, sign, A, out);
    } else if (s.code <= 6) {
        const int k = s.code - 4;
        out.normal = sign * B.R.column(k);
        face_points(b.half, {-load(f.pb), transpose(C), a.half}, k, -sign, B, out);
    } else {
        const int i = (s.code - 7) / 3, j = (s.code - 7) % 3;
        out.normal = normalized_or(sign * cross(A.R.column(i), B.R.column(j)), {1, 0, 0});
        edge_point(a, A, b, B, i, j, out);
    }
    if (out.count == 0) lowest_corner(A, b, B, s.code <= 3, a, out);
    return true;
}

}  // namespace epode
