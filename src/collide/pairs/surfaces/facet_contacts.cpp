// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See facet_contacts.h. The corners of a box differ in signs only: their places are computed four by four.
#include "collide/pairs/surfaces/facet_contacts.h"

#include <bit>

#include "collide/pairs/surfaces/facet_manifold_builder.h"
#include "simd/quad.h"

namespace epode {

void FacetContacts::add_edge(Vec3 p, const PrismPlace& a, Vec3 q, const PrismPlace& b)
{
    for (int k = 0; k < 3; ++k) {
        const Real at_p = a.beyond[k], at_q = b.beyond[k];
        const bool in_p = at_p <= slack_, in_q = at_q <= slack_;
        if (in_p == in_q || !ends_at(k) || (in_p ? at_p : at_q) >= 0)
            continue;  // an end on the wall is itself
        const Real t = at_p / (at_p - at_q);
        if (!low(a.height + t * (b.height - a.height))) continue;
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        if (a.beyond[i] + t * (b.beyond[i] - a.beyond[i]) <= slack_ &&
            a.beyond[j] + t * (b.beyond[j] - a.beyond[j]) <= slack_)
            give(p + t * (q - p));
    }
}

bool FacetContacts::met(Vec3 centre) const
{
    const PrismPlace middle = place(centre);
    for (int i = 0; i < held_; ++i) {
        const PrismPlace at = place(holds_[i]);
        const Real down = at.height < 0 ? -at.height : 0;
        if (!(middle.height > 0)) return false;
        const Real t = down / (middle.height + down);
        bool in = true;
        for (int k = 0; k < 3; ++k) in = in && at.beyond[k] + t * (middle.beyond[k] - at.beyond[k]) <= slack_;
        if (in) return true;
    }
    return false;
}

bool brought_down(const Polygon& face, Vec3 v, Vec3 up, Real slack, Vec3& out)
{
    const Real fall = -dot(up, face.normal);
    if (!(fall > 0)) return false;
    const Real depth = dot(face.points[0] - v, face.normal) / fall;
    if (!(depth >= -slack)) return false;
    out = v - depth * up;
    bool in = true;
    for (int i = 0, j = face.count - 1; in && i < face.count; j = i++)
        in = dot(cross(face.normal, face.points[i] - face.points[j]), out - face.points[j]) >= 0;
    return in;
}

void FacetContacts::add_corners(const Polygon& face)
{
    Vec3 p;
    for (int k = 0; k < 3; ++k)
        if (corner_counts(k) && brought_down(face, f_.v[k], up_, slack_, p)) give(p);
}

// Heights and distances from the walls of the corners of a disc; of the latter a bit for each that is within.
struct FacetContacts::DiscPlaces {
    Real height[kRimPoints], beyond[3][kRimPoints];
    unsigned in[3];
};

namespace {

static_assert(kRimPoints == 8);
unsigned turned(unsigned bits8)
{
    return (bits8 << 1 | bits8 >> 7) & 255u;
}  // of each corner that of the one before

EPODE_LANEWISE Quad along_disc(const Disc& d, Vec3 n, int from)
{
    return quad(n.x) * load_quad(d.x + from) + quad(n.y) * load_quad(d.y + from) +
           quad(n.z) * load_quad(d.z + from);
}

// A linear function at the corners; the mask of those where it is no more than `limit`, and of those where it is
// over zero.
unsigned place_disc(const Disc& d, Vec3 n, Real c, Real limit, Real (&at)[kRimPoints], unsigned& over)
{
    const Quad a = along_disc(d, n, 0) - quad(c), b = along_disc(d, n, 4) - quad(c);
    store_quad(at, a);
    store_quad(at + 4, b);
    over = bits(a > quad(0)) | bits(b > quad(0)) << 4;
    return bits(a <= quad(limit)) | bits(b <= quad(limit)) << 4;
}

}  // namespace

// From corner i - 1 to i, where they are not on the same side of a wall.
void FacetContacts::cross_disc(const Disc& disc, const DiscPlaces& at, int i)
{
    const int j = i > 0 ? i - 1 : kRimPoints - 1;
    const auto place = [&at](int k) {
        return PrismPlace{at.height[k], {at.beyond[0][k], at.beyond[1][k], at.beyond[2][k]}};
    };
    add_edge(disc.face.points[j], place(j), disc.face.points[i], place(i));
}

bool FacetContacts::add_disc(const Disc& disc)
{
    DiscPlaces at;
    unsigned over;
    const unsigned low = place_disc(disc, f_.n, f_.c, slack_, at.height, over);
    if (low == 0) return false;
    const unsigned known = low | turned(low) | (low >> 1 | (low << 7 & 255u));
    unsigned in = 255, changes = 0;
    int crossed = 0;
    for (int k = 0; k < 3; ++k) {
        at.in[k] = place_disc(disc, prism_.out[k], prism_.limit[k], slack_, at.beyond[k], over);
        crossed += (over & known) != 0;
        in &= at.in[k];
        if (ends_[k]) changes |= at.in[k] ^ turned(at.in[k]);
    }
    const unsigned given = low & in, edges = changes & (low | turned(low));
    for (unsigned some = (given | edges) & 255u; some; some &= some - 1) {
        const int i = std::countr_zero(some);
        if (given >> i & 1) give(disc.face.points[i]);
        if (i > 0 && (edges >> i & 1)) cross_disc(disc, at, i);
    }
    if (edges & 1) cross_disc(disc, at, 0);
    return crossed > 1;
}

void FacetContacts::add(const Polygon& face)
{
    Real height[Polygon::kMax];
    Real least = kInf;
    for (int i = 0; i < face.count; ++i) {
        height[i] = f_.height(face.points[i]);
        least = height[i] < least ? height[i] : least;
    }
    if (!low(least)) return;
    PrismPlace first{}, last{};
    bool known = false, crossed[3] = {};  // is the place of the last corner known?
    for (int i = 0, j = face.count - 1; i < face.count; j = i++) {
        const bool low_i = low(height[i]), low_j = low(height[j]);
        const bool was_known = known;
        if (!(known = low_i || low_j || low(height[(i + 1) % face.count]))) continue;
        const PrismPlace here = place(face.points[i]);
        if (i == 0) first = here;
        for (int k = 0; k < 3; ++k) crossed[k] = crossed[k] || here.beyond[k] > 0;
        if (low_i && within(here)) give(face.points[i]);
        if (i > 0 && was_known && (low_i || low_j)) add_edge(face.points[j], last, face.points[i], here);
        last = here;
    }
    const int end = face.count - 1;
    if (face.count > 2 && (low(height[0]) || low(height[end])))
        add_edge(face.points[end], last, face.points[0], first);
    if (face.count > 2 && crossed[0] + crossed[1] + crossed[2] > 1) add_corners(face);
}

namespace {

// Corner v of a box is c + sum of +-A_i, plus where bit i of v is set; sets of corners are masks of 8 bits.
class BoxManifoldBuilder {
  public:
    BoxManifoldBuilder(const Box& box, const Pose& pose, const Triangle& f, FacetContacts& to)
        : half_(box.half), pose_(pose), f_(f), to_(to), middle_(to.place(pose.p))
    {
        for (int i = 0; i < 3; ++i) {
            arm_[i] = half_[i] * pose.R.column(i);
            step_[i] = to_.along(arm_[i]);
            lean_[i] = dot(pose.R.column(i), f.n);
            leans_[i] = std::fabs(lean_[i]) >= kFaceLean;
            // The corners of the face across axis i that looks down.
            shown_[i] = !leans_[i] ? 0 : lean_[i] > 0 ? unsigned(~kPlus[i]) & 255u : kPlus[i];
        }
    }

    void all()
    {
        const unsigned low =
            place(height_, middle_.height, step_[0].height, step_[1].height, step_[2].height);
        if (!low) return;
        for (int k = 0; k < 3; ++k)
            in_[k] = place(beyond_[k], middle_.beyond[k], step_[0].beyond[k], step_[1].beyond[k],
                           step_[2].beyond[k]);
        unsigned given = low & (shown_[0] | shown_[1] | shown_[2]) & in_[0] & in_[1] & in_[2];
        for (; given; given &= given - 1) to_.give(point(std::countr_zero(given)));
        for (int i = 0; i < 3; ++i) edges(i, low);
        triangle_corners();
    }

  private:
    static constexpr unsigned kPlus[3] = {0xaa, 0xcc, 0xf0};
    static Real sign(int v, int i) { return v >> i & 1 ? Real(1) : Real(-1); }
    Vec3 point(int v) const
    {
        return pose_.p + sign(v, 0) * arm_[0] + sign(v, 1) * arm_[1] + sign(v, 2) * arm_[2];
    }

    // A linear function at all corners; the mask of those where it is not more than the slack.
    unsigned place(Real (&at)[8], Real middle, Real x, Real y, Real z) const
    {
        const Quad side = quad(middle - x, middle + x, middle - x, middle + x) + quad(-y, -y, y, y);
        const Quad minus = side - quad(z), plus = side + quad(z), farthest = quad(to_.slack());
        store_quad(at, minus);
        store_quad(at + 4, plus);
        return bits(minus <= farthest) | bits(plus <= farthest) << 4;
    }

    // The edges along axis i of faces that look down: from a corner v without bit i to the one with it.
    void edges(int i, unsigned low)
    {
        const unsigned first = ~kPlus[i] & 255u, shown = shown_[(i + 1) % 3] | shown_[(i + 2) % 3];
        const int step = 1 << i;
        unsigned crossing[3];
        for (int k = 0; k < 3; ++k) crossing[k] = to_.ends_at(k) ? in_[k] ^ in_[k] >> step : 0;
        unsigned some = first & shown & (low | low >> step) & (crossing[0] | crossing[1] | crossing[2]);
        for (; some; some &= some - 1) {
            const int v = std::countr_zero(some);
            for (int k = 0; k < 3; ++k)
                if (crossing[k] >> v & 1) cross_wall(k, v, v + step);
        }
    }

    void cross_wall(int k, int v, int w)
    {
        const Real at_v = beyond_[k][v], at_w = beyond_[k][w];
        if (at_v >= 0 && at_w >= 0) return;  // an end on the wall is itself
        const Real t = at_v / (at_v - at_w);
        const auto between = [&](const Real(&at)[8]) { return at[v] + t * (at[w] - at[v]); };
        if (!to_.low(between(height_)) || between(beyond_[(k + 1) % 3]) > to_.slack() ||
            between(beyond_[(k + 2) % 3]) > to_.slack())
            return;
        const Vec3 p = point(v);
        to_.give(p + t * (point(w) - p));
    }

    bool crosses(int wall) const
    {
        Real farthest = middle_.beyond[wall];
        for (int i = 0; i < 3; ++i) farthest += std::fabs(step_[i].beyond[wall]);
        return farthest > 0;
    }

    // Those over the box, brought down onto the face by which the way down leaves it.
    void triangle_corners()
    {
        const bool crossed[3] = {crosses(0), crosses(1), crosses(2)};
        for (int k = 0; k < 3; ++k) {
            if (!crossed[k] || !crossed[(k + 2) % 3] || !to_.corner_counts(k)) continue;
            const Vec3 v = transposed_times(pose_.R, f_.v[k] - pose_.p);
            const Vec3 up = to_.upright();
            Real enters = -kInf, leaves = kInf;
            int by = 0;
            for (int i = 0; i < 3; ++i) {
                const Real way = -dot(pose_.R.column(i), up), to_plus = half_[i] - v[i],
                           to_minus = -half_[i] - v[i];
                if (way == 0) {
                    if (to_plus < 0 || to_minus > 0) enters = kInf;
                    continue;
                }
                const Real in = (way > 0 ? to_minus : to_plus) / way,
                           out = (way > 0 ? to_plus : to_minus) / way;
                enters = in > enters ? in : enters;
                if (out < leaves) leaves = out, by = i;
            }
            if (leans_[by] && enters <= leaves && leaves >= -to_.slack()) to_.give(f_.v[k] - leaves * up);
        }
    }

    Vec3 half_;
    const Pose& pose_;
    const Triangle& f_;
    FacetContacts& to_;
    PrismPlace middle_, step_[3];
    Vec3 arm_[3];
    Real lean_[3];
    bool leans_[3];
    unsigned shown_[3];
    Real height_[8], beyond_[3][8];
    unsigned in_[3];
};

}  // namespace

void collect_facet_contacts(const ConvexView& solid, PlacedHull* hull, const Triangle& face,
                            FacetContacts& contacts)
{
    if (solid.kind == SolidKind::kBox)
        BoxManifoldBuilder(*static_cast<const Box*>(solid.shape), solid.pose, face, contacts).all();
    else if (hull)
        collect_hull_contacts(*hull, face, contacts);
    else
        build_facet_manifold<FacetContacts&>(solid, face, contacts);
}

}  // namespace epode
