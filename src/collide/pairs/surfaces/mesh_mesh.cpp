// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mesh_mesh.h. Everything in the second mesh's frame.
#include "collide/pairs/surfaces/mesh_mesh.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>

#include "collide/pairs/surfaces/crossing_table.h"
#include "collide/pairs/surfaces/triangle_triangle.h"

namespace epode {

namespace {

// The box of a box that has been turned.
Aabb box_in(const Pose& pose, const Aabb& box)
{
    const Vec3 half = Real(0.5) * (box.hi - box.lo), centre = pose.to_world(box.lo + half);
    const Vec3 reach{dot(abs(pose.R.row0), half), dot(abs(pose.R.row1), half), dot(abs(pose.R.row2), half)};
    return {centre - reach, centre + reach};
}

Aabb box_of(const Vec3 (&v)[3]) { return {min(v[0], min(v[1], v[2])), max(v[0], max(v[1], v[2]))}; }

Real reach_of(const Aabb& box) { return max_component(max(abs(box.lo), abs(box.hi))); }

constexpr Real kOtherWay = Real(0.99);  // cosine between normals of different contacts
constexpr Real kCovers = Real(1.05);

// Do two triangles have a corner in common?
bool adjoin(const Vec3 (&t)[3], const Vec3 (&u)[3])
{
    for (const Vec3 v : t)
        for (const Vec3 w : u)
            if (v == w) return true;
    return false;
}

// The contacts of pairs of triangles: an unbounded list that rarely needs memory.
class TriangleContactList {
  public:
    TriangleContactList() {}
    TriangleContactList(const TriangleContactList&) = delete;
    TriangleContactList& operator=(const TriangleContactList&) = delete;

    TriangleContact* begin() { return count_ <= kFew ? few_ : many_.data(); }
    TriangleContact* end() { return begin() + count_; }
    int count() const { return count_; }
    bool add(const TriangleContact& contact)  // false without memory
    {
        if (count_ < kFew) {
            few_[count_++] = contact;
            return true;
        }
        if (count_ == kFew) {
            many_.clear();
            if (!many_.reserve(4 * kFew)) return false;
            for (const TriangleContact& p : few_)
                if (!many_.push(p)) return false;
        }
        if (!many_.push(contact)) return false;
        ++count_;
        return true;
    }

    // The shallowest first. Not inlined, for stacks are small.
    [[gnu::noinline]] void sort()
    {
        if (count_ > kFew) return std::sort(begin(), end(), before<TriangleContact>);
        Key keys[kFew];  // contacts are large: each is moved once
        for (int i = 0; i < count_; ++i) keys[i] = {few_[i].depth, few_[i].a, few_[i].b, i};
        std::sort(keys, keys + count_, before<Key>);
        for (int i = 0; i < count_; ++i) {
            if (keys[i].from == i) continue;
            const TriangleContact first = few_[i];
            int to = i;
            for (int from; (from = keys[to].from) != i; to = from) few_[to] = few_[from], keys[to].from = to;
            few_[to] = first, keys[to].from = to;
        }
    }

  private:
    static constexpr int kFew = 40;
    struct Key {
        Real depth;
        int a, b, from;
    };
    template <typename T>
    static bool before(const T& x, const T& y)
    {
        if (x.depth != y.depth) return x.depth < y.depth;
        return x.a != y.a ? x.a < y.a : x.b < y.b;
    }
    union {
        TriangleContact few_[kFew];  // in a union: left unwritten until added
    };
    Array<TriangleContact> many_;
    int count_ = 0;
};

// Under which numbers contacts are found in a table: put under all, asked for by one of the first `asked`.
struct Keys {
    std::uint64_t key[3];
};

// Of a corner; of two that are equal, 0 and -0 included, the same.
std::uint64_t number_of(Vec3 v)
{
    const auto bits = [](Real x) { return std::bit_cast<std::uint64_t>(double(x) + 0.0); };
    return hash_of(hash_of(bits(v.x), bits(v.y)), bits(v.z));
}

Keys keys_of(const Vec3 (&corners)[3])
{
    return {{number_of(corners[0]), number_of(corners[1]), number_of(corners[2])}};
}

// Where two solids meet edge to edge, pairs of adjacent triangles cross, too, with larger overlaps only. A
// contact is needless if a shallower one nearby, in another direction, separates its triangles as well.
template <typename Other>
class Shallower {
  public:
    // `contacts`: the shallowest first.
    Shallower(const TriangleContact* contacts, int count, const Other& b)
        : contacts_(contacts), b_(b), by_table_(count > kFew && table_.reserve(kKeys * count))
    {}
    // Those before it have been added.
    bool is_separated_by_any(int i)
    {
        const TriangleContact& contact = contacts_[i];
        const auto separates = [&](int k) { return this->separates(contacts_[k], contact); };
        if (!by_table_) {
            for (int k = 0; k < i; ++k)
                if (separates(k)) return true;
            return false;
        }
        const Keys of_a = keys_of(contact.corners_a), of_b = b_.keys(contact);
        for (const std::uint64_t x : of_a.key)
            for (const std::uint64_t y : of_b.key)
                if (table_.any(x, y, separates)) return true;
        return false;
    }
    void add(int i)
    {
        if (!by_table_ || !contacts_[i].allowed) return;
        const Keys of_a = keys_of(contacts_[i].corners_a), of_b = b_.keys(contacts_[i]);
        for (const std::uint64_t x : of_a.key)
            for (const std::uint64_t y : of_b.key) table_.put(x, y, i);
    }

  private:
    static constexpr int kFew = 256, kKeys = 9;  // a table is slower for so few

    bool separates(const TriangleContact& s, const TriangleContact& contact) const
    {
        return s.allowed && dot(s.normal, contact.normal) < kOtherWay &&
               adjoin(s.corners_a, contact.corners_a) && b_.adjoin(s, contact) &&
               contact.overlap_along(s.normal) <= kCovers * s.depth;
    }

    const TriangleContact* contacts_;
    const Other& b_;
    CrossingTable table_;
    bool by_table_;
};

template <typename Other>
void collect(TriangleContactList& contacts, const Other& b, ContactCollector& collector)
{
    contacts.sort();
    Shallower<Other> shallower(contacts.begin(), contacts.count(), b);
    for (int i = 0; i < contacts.count(); ++i) {
        const TriangleContact& p = contacts.begin()[i];
        if (p.allowed && !shallower.is_separated_by_any(i))
            for (int k = 0; k < p.count; ++k) collector.add({p.points[k], p.normal, p.depths[k], p.a, p.b});
        shallower.add(i);
    }
    if (!collector.empty()) return;
    for (const TriangleContact& p : contacts)  // the least, although neither mesh allows it
        if (!p.allowed) return collector.add({p.points[0], p.normal, p.depths[0], p.a, p.b});
}

// The second mesh, in its own frame.
class MeshSide {
  public:
    explicit MeshSide(const Surface& surface) : s_(surface) {}

    Aabb box() const { return s_.tree.box(); }
    bool adjoin(const TriangleContact& p, const TriangleContact& q) const
    {
        return epode::adjoin(p.corners_b, q.corners_b);
    }
    Keys keys(const TriangleContact& p) const { return keys_of(p.corners_b); }
    // visit(facet) for all whose boxes meet the box, until it says false.
    template <typename Visit>
    void each(const Aabb& box, const Visit& visit)
    {
        s_.tree.query(s_.mesh, box, [&](int t) {
            PlacedFacet f = placed(s_.mesh, t, here_, placed_corners(s_.mesh, t, here_));
            return visit(f);
        });
    }

  private:
    const Surface& s_;
    const Pose here_;
};

// `a` at the pose P in b's frame; contacts in b's frame.
template <typename Other>
void meet(const Surface& a, const Pose& P, Other& b, ContactSink& sink)
{
    const Pose back = inverse_times(P, Pose{});
    const Aabb whole = box_in(P, a.tree.box());
    const Real slack = 64 * kEpsilon * std::max(reach_of(whole), reach_of(a.tree.box()));
    const Tolerance tolerance{slack, std::max(slack, kMeshTouch * length(whole.hi - whole.lo))};
    TriangleContactList contacts;
    // In any order: the contacts are sorted.
    a.tree.query(a.mesh, box_in(back, b.box()), [&](int t) {
        const PlacedCorners corners = placed_corners(a.mesh, t, P);
        const Aabb box = box_of(corners.v);
        if (!overlap(box, b.box())) return true;
        std::optional<PlacedFacet> fa;  // half of the triangles have no facet near
        b.each(box, [&](PlacedFacet& fb) {
            TriangleContact contact;
            if (!fa) fa.emplace(placed(a.mesh, t, P, corners));
            return !triangle_triangle(*fa, fb, tolerance, contact) || contacts.add(contact);
        });
        return true;
    });
    ContactCollector collector(Real(1e-6) * length(whole.hi - whole.lo), sink);
    collect(contacts, b, collector);
    collector.deliver(sink);
}

// A range of samples, ends included.
struct SampleRange {
    int from, to;
    int count() const { return to - from + 1; }
};

// Those under [lo, hi] and one more to each side; at most kMax. Empty when there are none.
SampleRange samples_under(Real lo, Real hi, Real origin, Real cell, int cells, bool endless)
{
    constexpr Real kMax = 256, kFar = 1e9;
    Real from = std::floor((lo - origin) / cell) - 1, to = std::floor((hi - origin) / cell) + 2;
    if (!(from > -kFar && to < kFar) || (!endless && (to < 0 || from > Real(cells)))) return {0, -1};
    if (to - from > kMax) {
        const Real middle = std::floor(Real(0.5) * (from + to));
        from = middle - kMax / 2, to = middle + kMax / 2;
    }
    if (!endless) from = std::max(from, Real(0)), to = std::min(to, Real(cells));
    return {int(from), int(to)};
}

// The terrain near a box: a window of the grid, the facets of which are numbered row by row.
class TerrainSide {
  public:
    // `near`: a box in the terrain's frame.
    TerrainSide(const Terrain& terrain, const Aabb& near) : terrain_(terrain)
    {
        std::fill(std::begin(kept_), std::end(kept_), -1);
        const Vec3 o = terrain.low_corner(), cell = terrain.cell();
        x_ = samples_under(near.lo.x, near.hi.x, o.x, cell.x, terrain.cells_x(), terrain.endless());
        z_ = samples_under(near.lo.z, near.hi.z, o.z, cell.z, terrain.cells_z(), terrain.endless());
        if (x_.count() < 2 || z_.count() < 2) return;
        if (!terrain.holed()) {
            take_all();
            return;
        }
        for (int j = z_.from; j < z_.to; ++j)
            for (int i = x_.from; i < x_.to; ++i) {
                if (terrain.hole(i, j)) {
                    holes_ = true;
                    continue;
                }
                for (const int corner : {0, 1, 2, 3}) take(terrain.vertex(i + (corner & 1), j + corner / 2));
            }
        lowest_ = box_.lo.y;
        if (holes_) box_.lo.y -= terrain.thickness();
    }

    bool empty() const { return !(box_.lo.y <= box_.hi.y); }
    bool holes() const { return holes_; }
    Real lowest() const { return lowest_; }
    const Aabb& box() const { return box_; }

    // Do two triangles share an edge?
    bool adjoin(const TriangleContact& p, const TriangleContact& q) const
    {
        int same = 0;
        for (const Vec3 v : p.corners_b)
            for (const Vec3 w : q.corners_b) same += v == w;
        return same >= 2;
    }
    // The edges, by their ends in any order.
    Keys keys(const TriangleContact& p) const
    {
        Keys keys{};
        for (int k = 0; k < 3; ++k)
            keys.key[k] = number_of(p.corners_b[k]) + number_of(p.corners_b[(k + 1) % 3]);
        return keys;
    }

    template <typename Visit>
    void each(const Aabb& box, const Visit& visit)
    {
        const Vec3 o = terrain_.low_corner(), cell = terrain_.cell();
        const SampleRange x = cells_within(x_, (box.lo.x - o.x) / cell.x, (box.hi.x - o.x) / cell.x);
        const SampleRange z = cells_within(z_, (box.lo.z - o.z) / cell.z, (box.hi.z - o.z) / cell.z);
        for (int j = z.from; j <= z.to; ++j)
            for (int i = x.from; i <= x.to; ++i)
                if (!terrain_.hole(i, j) && !each_of_cell(i, j, box, visit)) return;
    }

  private:
    // Of a window without holes.
    void take_all()
    {
        constexpr int kAtOnce = 32;
        Real some[kAtOnce], lowest = kInf, highest = -kInf;
        for (int j = z_.from; j <= z_.to; ++j)
            for (int i = x_.from; i <= x_.to; i += kAtOnce) {
                const int count = std::min(kAtOnce, x_.to - i + 1);
                terrain_.heights(i, j, count, some);
                for (int k = 0; k < count; ++k) {
                    lowest = some[k] < lowest ? some[k] : lowest;
                    highest = some[k] > highest ? some[k] : highest;
                }
            }
        take(terrain_.vertex(x_.from, z_.from, lowest));
        take(terrain_.vertex(x_.to, z_.to, highest));
        lowest_ = box_.lo.y;
    }
    void take(Vec3 v) { box_ = {min(box_.lo, v), max(box_.hi, v)}; }

    // Cells of the window from one place to another, and a little more to each side for rounding.
    static SampleRange cells_within(const SampleRange& window, Real from, Real to)
    {
        constexpr Real kMargin = kSingle ? Real(0.01) : Real(1e-6);
        const Real first = std::max(std::floor(from - kMargin), Real(window.from));
        const Real last = std::min(std::floor(to + kMargin), Real(window.to - 1));
        if (!(first <= last)) return {0, -1};
        return {int(first), int(last)};
    }

    // Walls are under the facets' sides.
    template <typename Visit>
    bool each_of_cell(int i, int j, const Aabb& box, const Visit& visit)
    {
        Cell& cell = cell_at(i, j);
        const Real deep = terrain_.holed() ? terrain_.thickness() : Real(0);
        if (cell.highest < box.lo.y || cell.lowest - deep > box.hi.y) return true;
        for (const bool upper : {false, true}) {
            PlacedFacet& f = cell.facets[upper];
            const bool near = overlap(cell.boxes[upper], box);
            if (!cell.there[upper]) continue;
            if (near && !visit(f)) return false;
            if (!terrain_.holed()) continue;
            Aabb all = cell.boxes[upper];
            all.lo.y -= deep;
            if (overlap(all, box) && !walls(f, box, visit)) return false;
        }
        return true;
    }

    // The two facets of a cell; `there`: those that have an area.
    struct Cell {
        Real lowest, highest;
        Aabb boxes[2];
        PlacedFacet facets[2];
        bool there[2];
    };

    // Cells near each other are kept at the same time, in a window of any size.
    Cell& cell_at(int i, int j)
    {
        const int number = (j - z_.from) * (x_.count() - 1) + i - x_.from;
        const int place = (i & (kColumns - 1)) + kColumns * (j & (kRows - 1));
        Cell& cell = cells_[place];
        if (kept_[place] == number) return cell;
        kept_[place] = number;
        const Terrain::BareCell bare = terrain_.bare_cell(i, j);
        cell.lowest = bare.lowest, cell.highest = bare.highest;
        for (const bool upper : {false, true}) {
            PlacedFacet& f = cell.facets[upper];
            f = {{}, nullptr, nullptr, &terrain_, {bare.facets[upper], false}};
            cell.boxes[upper] = box_of(bare.facets[upper].v);
            cell.there[upper] = bare_terrain_facet(bare.facets[upper], f.f);
            f.f.index = 2 * number + (upper ? 1 : 0);
        }
        return cell;
    }

    template <typename Visit>
    bool walls(const PlacedFacet& of, const Aabb& box, const Visit& visit) const
    {
        const int facets = 2 * (x_.count() - 1) * (z_.count() - 1);
        for (const int k : {0, 2}) {
            MeshFacet pair[2];
            if (!terrain_walls(terrain_, of.place.facet, k, pair)) continue;
            for (int n = 0; n < 2; ++n) {
                PlacedFacet w{pair[n], nullptr, nullptr, &terrain_, {of.place.facet, true}, true};
                w.f.index = facets + 4 * of.f.index + k + n;
                if (overlap(box_of(w.f.v), box) && !visit(w)) return false;
            }
        }
        return true;
    }

    const Terrain& terrain_;
    SampleRange x_{0, -1}, z_{0, -1};
    Aabb box_{{kInf, kInf, kInf}, {-kInf, -kInf, -kInf}};
    Real lowest_ = kInf;
    bool holes_ = false;
    static constexpr int kColumns = 4, kRows = 2;  // few, since a program's thread may have a stack of 64 KiB
    int kept_[kColumns * kRows];                   // the number of the cell in each place
    union {
        Cell cells_[kColumns * kRows];  // in a union: left unwritten until found
    };
};

}  // namespace

void mesh_mesh_contacts(const Surface& a, const Pose& A, const Surface& b, const Pose& B, ContactSink& sink)
{
    const int before = sink.count();
    MeshSide second(b);
    meet(a, inverse_times(B, A), second, sink);
    to_world(B, sink, before);
}

void mesh_terrain_contacts(const Surface& a, const Pose& A, const HeightfieldData& field, const Pose& B,
                           ContactSink& sink)
{
    if (a.mesh.triangle_count() == 0) return;
    const Pose P = inverse_times(B, A);
    const Aabb box = box_in(P, a.tree.box());
    const Terrain terrain(field);
    TerrainSide side(terrain, box);
    if (side.empty()) return;
    const Real slack = 64 * kEpsilon * reach_of(box);
    if (terrain.holed() && terrain.under_slab(P.p, side.lowest(), slack)) return;
    const int before = sink.count();
    if (box.hi.y < side.lowest() && !side.holes()) {  // buried: straight up
        sink.add({{P.p.x, side.lowest(), P.p.z}, {0, 1, 0}, side.lowest() - box.hi.y});
    } else {
        meet(a, P, side, sink);
        for (int k = before; k < sink.count(); ++k) sink.at(k)->side2 = -1;
    }
    to_world(B, sink, before);
}

}  // namespace epode
