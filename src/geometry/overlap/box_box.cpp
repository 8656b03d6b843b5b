// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Box against box: see box_box.h.
// With C = A^T B and p = A^T (b - a), the overlap along a unit axis L is  r_a(L) + r_b(L) - |p . L|, where
// r(L) is the box's half extent along L. For L = a_i x b_j every projection is a product of entries of C, and
// |L|^2 = 1 - C_ij^2. The three axes of one kind (faces of a, faces of b, edges of b with one edge of a) lie
// in lanes; which edges can be better than the faces is decided without a root.
#include "geometry/overlap/box_box.h"

#include <algorithm>

#include "geometry/best_four.h"
#include "geometry/closest.h"
#include "geometry/rectangle_cut.h"
#include "simd/quad.h"

namespace epode {

namespace {

constexpr Real kFaceMargin = Real(1e-5);  // of the sizes
// Of the squared sine between edges that are parallel: what is left of it, 1 - cos^2, must have digits.
constexpr Real kParallel = kSingle ? Real(1e-3) : Real(1e-6);
constexpr unsigned kThree = 7;  // lanes 0 to 2

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

// Of three numbers the first least.
EPODE_LANEWISE int least_of(const Real* x)
{
    const int k = x[1] < x[0] ? 1 : 0;
    return x[2] < x[k] ? 2 : k;
}

struct Axes {
    Quad row[3], column[3];  // of C; lanes 0 to 2
    Quad row_size[3];        // |C|
    Quad pa, pb;             // from a to b, in a's frame and in b's
    Quad ha, hb;
    Real size, touch;

    Axes(const Box& a, const Pose& A, const Box& b, const Pose& B);
    bool search_faces(Search& s);
    bool search_edges(Search& s) const;
    template <int i>
    bool search_edges_of(const Quad& slack2, Search& s) const;
    void offer_faces(const Quad& overlap, const Quad& along, int code, Real margin, Search& s) const;
    bool offer_edges(int i, unsigned those, const Quad& overlap, const Quad& along, Search& s) const;
};

// The fourth lane repeats the third: it never says anything of its own.
EPODE_LANEWISE Quad quad_of(Vec3 a) { return quad(a.x, a.y, a.z, a.z); }

EPODE_LANEWISE Axes::Axes(const Box& a, const Pose& A, const Box& b, const Pose& B)
    : ha(quad_of(a.half)), hb(quad_of(b.half))
{
    const Vec3 d = B.p - A.p;
    const Quad b0 = quad(B.R.row0.x, B.R.row0.y, B.R.row0.z, d.x);
    const Quad b1 = quad(B.R.row1.x, B.R.row1.y, B.R.row1.z, d.y);
    const Quad b2 = quad(B.R.row2.x, B.R.row2.y, B.R.row2.z, d.z);
    row[0] = quad(A.R.row0.x) * b0 + quad(A.R.row1.x) * b1 + quad(A.R.row2.x) * b2;
    row[1] = quad(A.R.row0.y) * b0 + quad(A.R.row1.y) * b1 + quad(A.R.row2.y) * b2;
    row[2] = quad(A.R.row0.z) * b0 + quad(A.R.row1.z) * b1 + quad(A.R.row2.z) * b2;
    const auto column_of = [this](int j) {
        return quad(lane(row[0], j), lane(row[1], j), lane(row[2], j), lane(row[2], j));
    };
    column[0] = column_of(0), column[1] = column_of(1), column[2] = column_of(2), pa = column_of(3);
    row_size[0] = magnitude(row[0]), row_size[1] = magnitude(row[1]), row_size[2] = magnitude(row[2]);
    size = max_component(a.half) + max_component(b.half);
    touch = 8 * kEpsilon * (size + largest_lane(magnitude(pa)));
}

EPODE_LANEWISE void Axes::offer_faces(const Quad& overlap, const Quad& along, int code, Real margin,
                                      Search& s) const
{
    Real depth[4], on[4];
    store_quad(depth, larger(overlap, quad(0)));
    const int k = least_of(depth);
    if (!(depth[k] + margin < s.score)) return;
    store_quad(on, along);
    s = {depth[k], depth[k] + margin, code + k, on[k] < 0};
}

EPODE_LANEWISE bool Axes::search_faces(Search& s)
{
    const Quad rb = magnitude(column[0]) * quad(lane(hb, 0)) + magnitude(column[1]) * quad(lane(hb, 1)) +
                    magnitude(column[2]) * quad(lane(hb, 2));
    const Quad over_a = ha + rb - magnitude(pa);
    if (bits(over_a < quad(-touch))) return false;
    const Quad ra =
        row_size[0] * quad(lane(ha, 0)) + row_size[1] * quad(lane(ha, 1)) + row_size[2] * quad(lane(ha, 2));
    pb = row[0] * quad(lane(pa, 0)) + row[1] * quad(lane(pa, 1)) + row[2] * quad(lane(pa, 2));
    const Quad over_b = hb + ra - magnitude(pb);
    if (bits(over_b < quad(-touch)) & kThree) return false;
    offer_faces(over_a, pa, 1, 0, s);
    // The second box's faces must be better by more than the jitter of a resting stack, so that boxes lying
    // flat on each other keep their roles.
    offer_faces(over_b, pb, 4, kFaceMargin * size, s);
    return true;
}

bool Axes::offer_edges(int i, unsigned those, const Quad& overlap, const Quad& along, Search& s) const
{
    Real over[4], on[4], c[4];
    store_quad(over, overlap), store_quad(on, along), store_quad(c, row[i]);
    for (; those; those &= those - 1) {
        const int j = __builtin_ctz(those);
        const Real sine2 = 1 - c[j] * c[j];
        if (sine2 < kParallel) continue;  // parallel edges: a face direction does as well
        if (over[j] > s.score) continue;  // times |L| = sqrt(sine2) <= 1: cannot win, nor part
        if (!s.offer(over[j] / std::sqrt(sine2), kEdgeHandicap, on[j], 7 + 3 * i + j, touch,
                     kFaceMargin * size))
            return false;
    }
    return true;
}

// (x, y, z) to (y, z, x).
EPODE_LANEWISE Quad turned(const Quad& a) { return quad(lane(a, 1), lane(a, 2), lane(a, 0), lane(a, 0)); }

template <int i>
EPODE_LANEWISE bool Axes::search_edges_of(const Quad& slack2, Search& s) const
{
    constexpr int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    const Quad along = quad(lane(pa, i2)) * row[i1] - quad(lane(pa, i1)) * row[i2];
    const Quad ra = quad(lane(ha, i1)) * row_size[i2] + quad(lane(ha, i2)) * row_size[i1];
    const Quad m1 = turned(row_size[i]), m2 = turned(m1), hb1 = turned(hb), hb2 = turned(hb1);
    const Quad overlap = ra + (hb1 * m2 + hb2 * m1) - magnitude(along);
    const Quad over = larger(overlap, quad(0)), sine2 = quad(1) - row[i] * row[i];
    const unsigned those = bits((overlap < quad(0)) | (over * over < slack2 * sine2)) & kThree;
    return !those || offer_edges(i, those, overlap, along, s);
}

EPODE_LANEWISE bool Axes::search_edges(Search& s) const
{
    // An edge wins by  overlap / |L| * handicap + margin < score: here squared, and a little too often.
    const Real slack = (s.score - kFaceMargin * size + 8 * kEpsilon * s.score) * (1 / kEdgeHandicap);
    const Quad slack2 = quad(slack > 0 ? slack * slack * Real(1.000001) : Real(0));
    return search_edges_of<0>(slack2, s) && search_edges_of<1>(slack2, s) && search_edges_of<2>(slack2, s);
}

// Everything as seen from the reference box: where the other box's axes point, row by row, and where its
// middle is.
struct Incident {
    Real axes[3][4];
    Real p[4];
    Real half[4];
};

EPODE_LANEWISE void set_incident(Incident& out, const Quad* rows, const Quad& p, const Quad& half)
{
    store_quad(out.axes[0], rows[0]), store_quad(out.axes[1], rows[1]), store_quad(out.axes[2], rows[2]);
    store_quad(out.p, p), store_quad(out.half, half);
}

constexpr int kNext[3] = {1, 2, 0}, kLast[3] = {2, 0, 1};

// The face on side `sign` of axis j of the incident box, along the axes after k and along k.
EPODE_LANEWISE Parallelogram face_of(const Incident& box, int j, Real sign, int k)
{
    const int j1 = kNext[j], j2 = kLast[j];
    const Real *x = box.axes[kNext[k]], *y = box.axes[kLast[k]], *z = box.axes[k];
    const Real up = sign * box.half[j], u = box.half[j1], v = box.half[j2];
    return {{box.p[kNext[k]] + up * x[j], box.p[kLast[k]] + up * y[j], box.p[k] + up * z[j]},
            {u * x[j1], u * y[j1], u * z[j1]},
            {v * x[j2], v * y[j2], v * z[j2]}};
}

// Of the incident box, the axis that is most along row k.
EPODE_LANEWISE int facing_axis(const Real* row)
{
    const Real x = std::fabs(row[0]), y = std::fabs(row[1]), z = std::fabs(row[2]);
    return x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
}

// A face of the reference box: its axis, the side on which it is, and that to which the contact normal
// points.
struct Reference {
    Real half[4];
    int k;
    Real sign, inward;
};

[[gnu::noinline]] bool repeats(const ManifoldPoints& points, Vec3 p, Real slack)
{
    for (int i = 0; i < points.count; ++i)
        if (std::fabs(points.x[i] - p.x) <= slack && std::fabs(points.y[i] - p.y) <= slack) return true;
    return false;
}

// Of the face of the incident box that looks most against the reference face, what lies over that and below
// it, or over it by no more than `margin`: coordinates along the two axes after k, and along k.
EPODE_LANEWISE void face_points(const Reference& face, const Incident& other, Real slack, Real margin,
                                ManifoldPoints& out)
{
    const int k = face.k, j = facing_axis(other.axes[k]);
    const Real side = face.sign * other.axes[k][j] > 0 ? Real(-1) : Real(1);
    CutPoints cut;
    // Corners outside by no more than `slack` stay as they are: flush faces would otherwise sprout pairs of
    // nearly equal points.
    cut_by_rectangle(face_of(other, j, side, k), face.half[kNext[k]] + slack, face.half[kLast[k]] + slack,
                     4 * slack, cut);
    for (unsigned left = cut.there; left && out.count < BoxBox::kMax; left &= left - 1) {
        const int i = __builtin_ctz(left);
        const Real depth = face.half[k] - face.sign * cut.at[2][i];
        const Vec3 p = {cut.at[0][i], cut.at[1][i], cut.at[2][i]};
        if (depth < -(slack + margin) || (cut.may_repeat && repeats(out, p, 4 * slack))) continue;
        out.add(p, depth > 0 || depth < -slack ? depth : Real(0));
    }
}

struct Wanted {
    int capacity;
    Real margin;
};

constexpr Real kReach = Real(0.002);  // of the span of four points: what others must add to be told

// Is one of the points outside the polygon of the chosen ones, which are in the order of best_four (the ends
// of a diagonal, then one on each side of it), by more than a part of their span? Seen along the third axis.
bool others_reach_farther(const ManifoldPoints& points, const int* chosen)
{
    const int ring[4] = {chosen[0], chosen[2], chosen[1], chosen[3]};
    Real outside[ManifoldPoints::kMax] = {};
    Real span2 = 0;
    for (int n = 0; n < 4; ++n) {
        const int from = ring[n], to = ring[(n + 1) & 3];
        const Real ex = points.x[to] - points.x[from], ey = points.y[to] - points.y[from];
        const Real length2 = ex * ex + ey * ey;
        span2 = std::max(span2, length2);
        if (!(length2 > 0)) continue;
        const Real ox = points.x[ring[(n + 2) & 3]] - points.x[from],
                   oy = points.y[ring[(n + 2) & 3]] - points.y[from];
        const Real inward = ex * oy - ey * ox > 0 ? Real(-1) : Real(1), scale = inward / std::sqrt(length2);
        for (int i = 0; i < points.count; ++i) {
            const Real away =
                scale * (ex * (points.y[i] - points.y[from]) - ey * (points.x[i] - points.x[from]));
            outside[i] = std::max(outside[i], away);
        }
    }
    const Real farthest = *std::max_element(outside, outside + points.count);
    return farthest * farthest > kReach * kReach * span2;
}

// Which of the points to keep: all that there is room for, but only the best four where the others reach
// hardly farther, as when one of two flush faces is turned by a hair.
[[gnu::noinline]] int keep_best(ManifoldPoints& points, Vec3 normal, int capacity, int* chosen)
{
    const int all = points.count;
    int kept = best_four(points, normal, capacity < kBestFour ? capacity : kBestFour, chosen);
    if (capacity <= kBestFour || kept < kBestFour || !others_reach_farther(points, chosen)) return kept;
    for (int i = 0; i < all && kept < capacity; ++i)
        if (std::find(chosen, chosen + kept, i) == chosen + kept) chosen[kept++] = i;
    return kept;
}

void face_manifold(const Reference& face, const Incident& other, Real slack, const Pose& world, Wanted wanted,
                   BoxBox& out)
{
    const int capacity = wanted.capacity;
    ManifoldPoints points;
    face_points(face, other, slack, wanted.margin, points);
    int chosen[BoxBox::kMax] = {0, 1, 2, 3, 4, 5, 6, 7};
    out.count = points.count;
    if (points.count > kBestFour || points.count > capacity)
        out.count = keep_best(points, {0, 0, face.inward}, capacity, chosen);
    const Real* at[3];
    at[kNext[face.k]] = points.x, at[kLast[face.k]] = points.y, at[face.k] = points.z;
    for (int n = 0; n < out.count; ++n) {
        const int i = chosen[n];
        out.points[n] = world.to_world({at[0][i], at[1][i], at[2][i]});
        out.depths[n] = points.depth[i];
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
    out.depths[0] = out.overlap;
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
    out.depths[0] = out.overlap;
    out.count = 1;
}

Vec3 normal_of(const Search& s, const Pose& A, const Pose& B)
{
    const Real sign = s.flip ? Real(-1) : Real(1);
    if (s.code <= 3) return sign * A.R.column(s.code - 1);
    if (s.code <= 6) return sign * B.R.column(s.code - 4);
    const int i = (s.code - 7) / 3, j = (s.code - 7) % 3;
    return normalized_or(sign * cross(A.R.column(i), B.R.column(j)), {1, 0, 0});
}

// Of an edge and a face nearly across it the face, if that will have the less overlap when the two are deeper
// by the margin: it shows more corners.
void prefer_face(const Search& face, const Pose& A, const Pose& B, Real margin, Search& s, Vec3& normal)
{
    const Vec3 n = normal_of(face, A, B);
    const Real cosine = dot(n, normal);
    if (cosine > kManifoldCosine && face.score + margin * cosine < s.score + margin * kEdgeHandicap)
        s = face, normal = n;
}

}  // namespace

bool boxes_touch(const Box& a, const Pose& A, const Box& b, const Pose& B)
{
    Search s;
    Axes axes(a, A, b, B);
    return axes.search_faces(s) && axes.search_edges(s);
}

bool box_box_manifold(const Box& a, const Pose& A, const Box& b, const Pose& B, BoxBox& out, int capacity,
                      Real margin)
{
    Axes axes(a, A, b, B);
    Search s;
    if (!axes.search_faces(s)) return false;
    const Search faces = s;
    if (!axes.search_edges(s)) return false;
    out.normal = normal_of(s, A, B);
    if (margin > 0 && s.code > 6) prefer_face(faces, A, B, margin, s, out.normal);
    out.code = s.code;
    out.overlap = s.depth;
    out.count = 0;
    const Real sign = s.flip ? Real(-1) : Real(1);
    if (s.code <= 6) {
        const bool of_a = s.code <= 3;
        const Pose& world = of_a ? A : B;
        Reference face;
        Incident other;
        store_quad(face.half, of_a ? axes.ha : axes.hb);
        face.k = s.code - (of_a ? 1 : 4);
        face.sign = of_a ? sign : -sign, face.inward = -sign;
        if (of_a)
            set_incident(other, axes.row, axes.pa, axes.hb);
        else
            set_incident(other, axes.column, quad(0) - axes.pb, axes.ha);
        face_manifold(face, other, 32 * kEpsilon * axes.size, world, {capacity, margin}, out);
    } else {
        const int i = (s.code - 7) / 3, j = (s.code - 7) % 3;
        edge_point(a, A, b, B, i, j, out);
    }
    if (out.count == 0) lowest_corner(A, b, B, s.code <= 3, a, out);
    return true;
}

}  // namespace epode
