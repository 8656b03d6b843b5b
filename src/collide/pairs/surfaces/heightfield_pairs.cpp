// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sphere, capsule, box, cylinder and polyhedron against a height field. Facets whose cells lie under the
// solid's box are taken one after the other (facet.h). Three answers need no facets: above the highest sample
// there is nothing; below the lowest, one contact straight up; and where all samples lie in one plane, the
// plane's own pair function answers, so that a flat field is a plane, exactly. These are not taken where
// there are holes under the box. A field that has holes is a slab: what has its middle below it is not met.
#include <optional>

#include "collide/pairs/solid_pairs.h"
#include "collide/pairs/surfaces/facet.h"
#include "collide/pairs/surfaces/sub_plane_extent.h"

namespace epode {

namespace {

template <typename Shape>
void weigh_facet(const Shape& a, const Pose& A, const Facet& f, TerrainPair& m)
{
    if constexpr (kRound<Shape>)
        weigh_round(core_of(a, A), f, m);
    else
        weigh_solid(f, m);
}

struct Cells {
    int i0, i1, j0, j1;  // inclusive
};

// A solid is tested against this many cells to each side at most; of a field without end, and of one that is
// finite in name only.
constexpr Real kReach = 128, kFiniteReach = 512;

// The greatest whole number that is not above; of those that an int can hold.
int below(Real x)
{
    const int k = int(x);
    return k - (Real(k) > x ? 1 : 0);
}

// The cells under the box; false when there are none or the place is out of all measure.
bool cells_under(const Terrain& t, const Aabb& box, Cells& out)
{
    const Vec3 o = t.low_corner(), cell = t.cell();
    Real from[2] = {(box.lo.x - o.x) / cell.x, (box.lo.z - o.z) / cell.z};
    Real to[2] = {(box.hi.x - o.x) / cell.x, (box.hi.z - o.z) / cell.z};
    const int count[2] = {t.cells_x(), t.cells_z()};
    int lo[2], hi[2];
    constexpr Real kFar = 1e9;
    for (int a = 0; a < 2; ++a) {
        if (!t.endless()) {
            if (!(to[a] >= 0 && from[a] <= Real(count[a]))) return false;
            from[a] = from[a] < 0 ? 0 : from[a];
            to[a] = to[a] > Real(count[a]) ? Real(count[a]) : to[a];
        }
        const Real middle = Real(0.5) * (from[a] + to[a]), reach = t.endless() ? kReach : kFiniteReach;
        if (to[a] - from[a] > 2 * reach) from[a] = middle - reach, to[a] = middle + reach;
        if (!(from[a] > -kFar && to[a] < Real(2.1e9))) return false;
        lo[a] = below(from[a]), hi[a] = below(to[a]);
        if (t.endless()) continue;
        lo[a] = lo[a] < 0 ? 0 : lo[a] < count[a] ? lo[a] : count[a] - 1;
        hi[a] = hi[a] < 0 ? 0 : hi[a] < count[a] ? hi[a] : count[a] - 1;
    }
    out = {lo[0], hi[0], lo[1], hi[1]};
    return true;
}

// The samples at the corners of cells, each read once where there are few.
class Samples {
  public:
    Samples(const Terrain& terrain, const Cells& cells, bool holes)
        : t_(terrain), i0_(cells.i0), j0_(cells.j0), columns_(cells.i1 - cells.i0 + 2)
    {
        const int rows = cells.j1 - cells.j0 + 2;
        if (holes || columns_ > kMax / 2 || rows > kMax / columns_)
            return;  // in holes they are not looked at
        known_ = true;
        for (int j = 0; j < rows; ++j) t_.heights(i0_, j0_ + j, columns_, y_ + j * columns_);
    }
    Real height(int i, int j) const
    {
        return known_ ? y_[(i - i0_) + (j - j0_) * columns_] : t_.height(i, j);
    }
    Vec3 at(int i, int j) const
    {
        return known_ ? t_.vertex(i, j, y_[(i - i0_) + (j - j0_) * columns_]) : t_.vertex(i, j);
    }

  private:
    static constexpr int kMax = 100;
    const Terrain& t_;
    int i0_, j0_, columns_;
    bool known_ = false;
    union {
        Real y_[kMax];  // in a union: left unwritten until read
    };
};

// The lowest and the highest sample under the solid.
struct HeightRange {
    Real lowest = kInf, highest = -kInf;
    void take(Real y)
    {
        lowest = y < lowest ? y : lowest;
        highest = y > highest ? y : highest;
    }
};

HeightRange survey(const Samples& samples, const Cells& c)
{
    HeightRange g;
    for (int j = c.j0; j <= c.j1 + 1; ++j)
        for (int i = c.i0; i <= c.i1 + 1; ++i) g.take(samples.height(i, j));
    return g;
}

// A bound of how steep the facets are.
Real steepest_sine(const Terrain& t, const Samples& samples, const Cells& c)
{
    Real along_x = 0, along_z = 0;
    for (int j = c.j0; j <= c.j1 + 1; ++j)
        for (int i = c.i0; i <= c.i1 + 1; ++i) {
            const Real y = samples.height(i, j);
            if (i > c.i0) along_x = std::max(along_x, std::fabs(y - samples.height(i - 1, j)));
            if (j > c.j0) along_z = std::max(along_z, std::fabs(y - samples.height(i, j - 1)));
        }
    const Vec3 cell = t.cell();
    const Real tangent = length(Vec3{along_x / cell.x, 0, along_z / cell.z});
    constexpr Real kHair = Real(1e-4);
    return tangent < 1 / kHair ? tangent / std::sqrt(1 + tangent * tangent) + kHair : Real(1);
}

// Do all lie in the plane of the facet?
bool level(const Samples& samples, const Cells& c, const Facet& first, Real slack)
{
    for (int j = c.j0; j <= c.j1 + 1; ++j)
        for (int i = c.i0; i <= c.i1 + 1; ++i)
            if (!(std::fabs(first.height(samples.at(i, j))) <= slack)) return false;
    return true;
}

// Of the cells that are there; their number too. Samples inside holes are not looked at.
HeightRange survey_holed(const Terrain& t, const Cells& c, int& there)
{
    HeightRange g;
    there = 0;
    for (int j = c.j0; j <= c.j1; ++j)
        for (int i = c.i0; i <= c.i1; ++i) {
            if (t.hole(i, j)) continue;
            ++there;
            for (const int di : {0, 1})
                for (const int dj : {0, 1}) g.take(t.height(i + di, j + dj));
        }
    return g;
}

bool any_hole(const Terrain& t, const Cells& c)
{
    if (!t.holed()) return false;
    for (int j = c.j0; j <= c.j1; ++j)
        for (int i = c.i0; i <= c.i1; ++i)
            if (t.hole(i, j)) return true;
    return false;
}

bool inside(const Terrain& t, const Aabb& box)
{
    const Vec3 o = t.low_corner();
    return t.endless() || (box.lo.x >= o.x && box.lo.z >= o.z && box.hi.x <= -o.x && box.hi.z <= -o.z);
}

// The heights at the corners of a cell.
struct CellHeights {
    Real a, b, c, d;
    CellHeights(const Samples& samples, int i, int j)
        : a(samples.height(i, j)),
          b(samples.height(i + 1, j)),
          c(samples.height(i, j + 1)),
          d(samples.height(i + 1, j + 1))
    {}
    Facet facet(const Terrain& terrain, int i, int j, bool upper) const
    {
        Facet f;
        terrain.set_corners(f, i, j, upper, upper ? d : a, upper ? b : c, upper ? c : b);
        return f;
    }
    // Which of the two facets are not all below a height; a bit for each.
    unsigned not_below(Real low) const
    {
        return b >= low || c >= low ? 3 : (a >= low ? 1u : 0u) | (d >= low ? 2u : 0u);
    }
};

// Which facets a solid may meet, of those of two cells side by side.
template <typename Shape>
class Near {
  public:
    Near(const Shape& a, const Pose& A, const Terrain& terrain, const ConvexView& solid, Real slack)
        : terrain_(terrain),
          solid_(solid),
          frame_(terrain.cell(), 2 * slack),
          under_(a, A, frame_),
          slack_(slack)
    {}
    // Does the part of the solid under the facet's plane reach over the walls of its column?
    unsigned may_meet(int i, int j, const CellHeights& one, const CellHeights& two) const
    {
        const Vec3 a = terrain_.vertex(i, j, 0), d = terrain_.vertex(i + 1, j + 1, 0);
        const Quad y = quad(one.a, one.d, two.a, two.d), z = quad(a.z, d.z, a.z, d.z);
        const Quad side = FieldFrame::side();
        const Quad slope_x = (quad(one.b, one.c, two.b, two.c) - y) * side * quad(frame_.per_x()),
                   slope_z = (quad(one.c, one.b, two.c, two.b) - y) * side * quad(frame_.per_z());
        const Quad hair = quad(2 * slack_) * (quad(1) + magnitude(slope_x) + magnitude(slope_z));
        return under_.met(
            {{quad(a.x, d.x, d.x, terrain_.vertex(i + 2, j, 0).x), y, z}, slope_x, slope_z, hair});
    }
    bool may_meet(const Facet& f)
    {
        if constexpr (kRound<Shape>) return true;
        if (!sides_) sides_.emplace(terrain_, solid_, slack_);
        return sides_->reach(f);
    }

  private:
    const Terrain& terrain_;
    const ConvexView& solid_;
    FieldFrame frame_;
    SubPlaneExtent<Shape> under_;
    Real slack_;
    std::optional<Sides> sides_;
};

template <typename Shape>
requires kByView<Shape>
class Near<Shape> {
  public:
    Near(const Shape&, const Pose&, const Terrain& terrain, const ConvexView& solid, Real slack)
        : sides_(terrain, solid, slack)
    {}
    unsigned may_meet(int, int, const CellHeights&, const CellHeights&) const { return 15; }
    bool may_meet(const Facet& f) const { return sides_.reach(f); }

  private:
    Sides sides_;
};

// Where there are holes, all are near.
struct AllNear {
    unsigned may_meet(int, int, const CellHeights&, const CellHeights&) const { return 15; }
    bool may_meet(const Facet&) const { return true; }
};

// Facets that are not below the box and may be met.
template <typename MayMeet, typename Visit>
void each_facet(const TerrainPair& m, const Cells& cells, const Samples& samples, MayMeet& near,
                const Visit& visit)
{
    const Terrain& terrain = m.terrain;
    for (int j = cells.j0; j <= cells.j1; ++j)
        for (int i = cells.i0; i <= cells.i1; i += 2) {
            // In holes, and in a cell too many, samples are not looked at.
            const bool gone = terrain.hole(i, j), last = i == cells.i1 || terrain.hole(i + 1, j);
            if (gone && last) continue;
            const CellHeights one(samples, gone ? i + 1 : i, j),
                two = last ? one : CellHeights(samples, i + 1, j);
            unsigned some =
                (gone ? 0 : one.not_below(m.box.lo.y)) | (last ? 0 : two.not_below(m.box.lo.y) << 2);
            if (some) some &= near.may_meet(i, j, one, two);
            for (; some; some &= some - 1) {
                const int k = __builtin_ctz(some);
                Facet f = (k < 2 ? one : two).facet(terrain, i + k / 2, j, k % 2 != 0);
                if (!near.may_meet(f)) continue;
                finish(f);
                visit(f);
            }
        }
}

// What is computed once of the solid for all facets.
template <typename Shape>
struct KnownParts {
    KnownParts(const ConvexView&, Real) {}
    template <typename Prepare>
    void add_to(TerrainPair&, const Prepare&)
    {}
};

template <>
struct KnownParts<Cylinder> {
    CylinderEnds ends;
    KnownParts(const ConvexView& solid, Real slack) : ends(solid, slack) {}
    template <typename Prepare>
    void add_to(TerrainPair& pair, const Prepare&)
    {
        pair.ends = &ends;
    }
};

template <typename Shape>
requires kByView<Shape>
struct KnownParts<Shape> {
    PlacedHull hull;
    Real slack;
    std::optional<FieldCorners> corners;
    KnownParts(const ConvexView& solid, Real slack_) : hull(solid), slack(slack_) {}
    template <typename Prepare>
    void add_to(TerrainPair& pair, const Prepare& prepare)
    {
        if (!hull.there()) return;
        prepare(hull);
        pair.hull = &hull;
        corners.emplace(hull, slack);
        if (corners->there()) pair.corners = &*corners;
    }
};

// Contacts in the field's frame, where there are holes under the solid.
template <typename Shape>
void collide_holed(const Shape& a, const Pose& A, const Terrain& terrain, const ConvexView& solid,
                   const Aabb& box, Real slack, const Cells& cells, ContactSink& sink)
{
    int there;
    const HeightRange heights = survey_holed(terrain, cells, there);
    const Vec3 middle = solid.pose.p;
    if (there == 0 || box.lo.y > heights.highest || terrain.under_slab(middle, heights.lowest, slack)) return;
    const Samples samples(terrain, cells, true);
    ContactCollector collector(Real(1e-6) * (solid.size + solid.radius), sink);
    int i, j;
    HoleWalls walls(middle, terrain.cell_under(middle, i, j) && terrain.hole(i, j));
    KnownParts<Shape> parts(solid, slack);
    TerrainPair pair{terrain, solid, box, slack, collector, &walls};
    parts.add_to(pair, [](PlacedHull&) {});
    AllNear any;
    each_facet(pair, cells, samples, any, [&](const Facet& f) {
        if (terrain.hole_beyond(f, 0) || terrain.hole_beyond(f, 2)) weigh_facet(a, A, f, pair);
    });
    each_facet(pair, cells, samples, any, [&](const Facet& f) { meet_facet(a, A, f, pair); });
    collector.deliver(sink);
}

// Contacts in the field's frame.
template <typename Shape>
void collide_local(const Shape& a, const Pose& A, const HeightfieldData& data, ContactSink& sink)
{
    const Terrain terrain(data);
    const Aabb box = box_around(a, A, 0);
    Cells cells;
    if (!cells_under(terrain, box, cells)) return;
    const ConvexView solid = view_of(a, A);
    const Real reach = max_component(max(abs(box.lo), abs(box.hi)));
    const Real slack = 64 * kEpsilon * (reach + solid.size);
    if (any_hole(terrain, cells)) return collide_holed(a, A, terrain, solid, box, slack, cells, sink);
    const Samples samples(terrain, cells, false);
    const HeightRange heights = survey(samples, cells);
    if (box.lo.y > heights.highest) return;
    const Vec3 middle = solid.pose.p;
    if (terrain.holed() && terrain.under_slab(middle, heights.lowest, slack)) return;
    if (box.hi.y < heights.lowest) {  // buried: straight up
        sink.add({{middle.x, heights.lowest, middle.z}, kUp, heights.lowest - box.hi.y});
        return;
    }
    if (inside(terrain, box)) {
        const int i = cells.i0, j = cells.j0;
        Facet first;
        terrain.set_corners(first, i, j, false, samples.height(i, j), samples.height(i, j + 1),
                            samples.height(i + 1, j));
        finish(first);
        if (level(samples, cells, first, slack)) return on_plane(a, A, {first.n, first.c}, sink);
    }
    ContactCollector collector(Real(1e-6) * (solid.size + solid.radius), sink);
    KnownParts<Shape> parts(solid, slack);
    TerrainPair pair{terrain, solid, box, slack, collector};
    parts.add_to(pair, [&](PlacedHull& hull) {
        hull.keep_for_field(heights.highest + slack, steepest_sine(terrain, samples, cells));
    });
    Near<Shape> near(a, A, terrain, solid, slack);
    each_facet(pair, cells, samples, near, [&](const Facet& f) { meet_facet(a, A, f, pair); });
    collector.deliver(sink);
}

template <typename Shape>
void collide_field(const Shape& a, const Pose& A, const Heightfield& b, const Pose& B, ContactSink& sink)
{
    const HeightfieldData* data = b.field();
    if (!data) return;
    const int before = sink.count();
    collide_local(a, inverse_times(B, A), *data, sink);
    to_world(B, sink, before);
}

}  // namespace

void sphere_heightfield(const Sphere& a, const Pose& A, const Heightfield& b, const Pose& B,
                        ContactSink& sink)
{
    collide_field(a, A, b, B, sink);
}
void capsule_heightfield(const Capsule& a, const Pose& A, const Heightfield& b, const Pose& B,
                         ContactSink& sink)
{
    collide_field(a, A, b, B, sink);
}
void box_heightfield(const Box& a, const Pose& A, const Heightfield& b, const Pose& B, ContactSink& sink)
{
    collide_field(a, A, b, B, sink);
}
void cylinder_heightfield(const Cylinder& a, const Pose& A, const Heightfield& b, const Pose& B,
                          ContactSink& sink)
{
    collide_field(a, A, b, B, sink);
}
void convex_heightfield(const Convex& a, const Pose& A, const Heightfield& b, const Pose& B,
                        ContactSink& sink)
{
    collide_field(a, A, b, B, sink);
}
void solid_heightfield(const Geom& a, const Pose& A, const Geom& field, const Pose& F, ContactSink& sink)
{
    collide_field(AnySolid(a), A, static_cast<const ShapeGeom<Heightfield>&>(field).shape, F, sink);
}

}  // namespace epode
