// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Builds the tree. A range of triangles is cut where the sum over both sides of (surface of the box) x
// (number of triangles) is least, among kBins - 1 places on each axis. A node takes four parts; the part with
// the largest surface is always cut next. Beyond kGreedy successive cuts, ranges are halved by number, which
// bounds the depth at kGreedy + 27 for every mesh; so are triangles with one common centre. Nodes of four are
// then replaced by their children until sixteen have come together (put_together).
#include "bvh/mesh_tree.h"

#include <algorithm>
#include <atomic>
#include <climits>

namespace epode {
namespace {

constexpr float kRoam = 0.125f;  // of its longest side: a cached box may move so far
constexpr int kBins = 16;
constexpr int kGreedy = 40;
static_assert(kGreedy + 27 < kMeshDepth && TriangleMesh::kMostTriangles <= 1 << 27);

constexpr FloatBox kEmpty = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

void enclose(FloatBox& all, const FloatBox& one)
{
    for (int i = 0; i < 3; ++i) {
        all.lo[i] = one.lo[i] < all.lo[i] ? one.lo[i] : all.lo[i];
        all.hi[i] = one.hi[i] > all.hi[i] ? one.hi[i] : all.hi[i];
    }
}

// The number of leaves for so many triangles, the cost of a side: a leaf with one triangle costs as much as a
// full one.
float leaves(int count) { return float((count + kMeshLeaf - 1) / kMeshLeaf); }

// Half the surface.
float surface(const FloatBox& b)
{
    const float x = b.hi[0] - b.lo[0], y = b.hi[1] - b.lo[1], z = b.hi[2] - b.lo[2];
    return x * y + y * z + z * x;
}

// A triangle to be put into the tree.
struct Item {
    FloatBox box;
    int triangle;
    float twice_centre(int axis) const { return box.lo[axis] + box.hi[axis]; }
};

std::atomic<std::uint64_t> g_editions{0};

struct Part {
    Item* first = nullptr;
    int count = 0;
    int cuts = 0;  // that made it
    float surface = 0;
};

Part part_of(Item* first, int count, int cuts)
{
    FloatBox all = kEmpty;
    for (int i = 0; i < count; ++i) enclose(all, first[i].box);
    return {first, count, cuts, surface(all)};
}

struct Bin {
    FloatBox box = kEmpty;
    int count = 0;
};

struct Bins {
    Bin at[3][kBins];
    float low[3], per[3];  // bins per length; 0 where all centres are the same

    int of(const Item& item, int axis) const
    {
        const int bin = int((item.twice_centre(axis) - low[axis]) * per[axis]);
        return bin < kBins ? bin : kBins - 1;
    }
};

void fill(Bins& bins, const Part& part)
{
    float high[3];
    for (int i = 0; i < 3; ++i) bins.low[i] = high[i] = part.first[0].twice_centre(i);
    for (int j = 1; j < part.count; ++j)
        for (int i = 0; i < 3; ++i) {
            const float c = part.first[j].twice_centre(i);
            bins.low[i] = std::min(bins.low[i], c);
            high[i] = std::max(high[i], c);
        }
    for (int i = 0; i < 3; ++i) {
        const float range = high[i] - bins.low[i];
        bins.per[i] = range > 0 ? kBins / range : 0;
    }
    for (int j = 0; j < part.count; ++j)
        for (int i = 0; i < 3; ++i) {
            Bin& bin = bins.at[i][bins.of(part.first[j], i)];
            enclose(bin.box, part.first[j].box);
            ++bin.count;
        }
}

struct Cut {
    int axis = -1;  // none
    int bin = 0;    // the first of the second side
    float cost = INFINITY;
};

void best_cut(const Bin* bins, int axis, Cut& best)
{
    float second[kBins];  // costs of the sides that begin with each bin
    FloatBox all = kEmpty;
    int count = 0;
    for (int b = kBins - 1; b > 0; --b) {
        enclose(all, bins[b].box);
        count += bins[b].count;
        second[b] = count > 0 ? surface(all) * leaves(count) : INFINITY;
    }
    all = kEmpty;
    count = 0;
    for (int b = 1; b < kBins; ++b) {
        enclose(all, bins[b - 1].box);
        count += bins[b - 1].count;
        if (count == 0) continue;
        const float cost = surface(all) * leaves(count) + second[b];
        if (cost < best.cost) best = {axis, b, cost};
    }
}

// Half of the triangles on each side, along the longest axis.
int halve(const Part& part)
{
    FloatBox all = kEmpty;
    for (int i = 0; i < part.count; ++i) enclose(all, part.first[i].box);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (all.hi[i] - all.lo[i] > all.hi[axis] - all.lo[axis]) axis = i;
    std::sort(part.first, part.first + part.count, [axis](const Item& a, const Item& b) {
        const float ca = a.twice_centre(axis), cb = b.twice_centre(axis);
        return ca != cb ? ca < cb : a.triangle < b.triangle;
    });
    return part.count / 2;
}

// Orders the items; returns how many belong to the first side.
int divide(const Part& part)
{
    if (part.cuts >= kGreedy) return halve(part);
    Bins bins;
    fill(bins, part);
    Cut cut;
    for (int i = 0; i < 3; ++i)
        if (bins.per[i] > 0) best_cut(bins.at[i], i, cut);
    if (cut.axis < 0) return halve(part);
    int left = 0, right = part.count;
    while (left < right) {
        if (bins.of(part.first[left], cut.axis) < cut.bin)
            ++left;
        else
            std::swap(part.first[left], part.first[--right]);
    }
    return left;
}

// A node during construction: nodes of four, -1 - packet, or kNone.
struct Four {
    static constexpr int kNone = INT_MIN;
    int child[4];
};

// The most triangles that the children of a node of so many should hold: the smallest of 4, 16, 64, ... of
// which four suffice. Halving smaller ones would make nodes of two children, twice as many in all.
int full_child(int count)
{
    int full = kMeshLeaf;
    while (full < (count + 3) / 4) full *= 4;
    return full;
}

// The part to cut next: the largest of those above `full`; -1: none.
int to_cut(const Part* parts, int count, int full)
{
    int best = -1;
    for (int i = 0; i < count; ++i)
        if (parts[i].count > full && (best < 0 || parts[i].surface > parts[best].surface)) best = i;
    return best;
}

// Builds node by node from the root. The items stand in one array, finally in the order of the leaves.
class Builder {
  public:
    Builder(Array<Four>& nodes, Array<MeshPacket>& packets) : nodes_(nodes), packets_(packets) {}

    // The new node, or -1 when memory is exhausted.
    int build(const Part& whole)
    {
        if (!nodes_.push({})) return -1;
        const int node = nodes_.size() - 1;
        Part parts[4] = {whole};
        int count = 1;
        const int full = full_child(whole.count);
        for (int i = 0; count < 4 && (i = to_cut(parts, count, full)) >= 0; ++count) cut(parts, count, i);
        for (int k = 0; k < 4; ++k) {
            int child = Four::kNone;
            if (k < count && parts[k].count <= kMeshLeaf) {
                if (!packets_.push(packet_of(parts[k]))) return -1;
                child = -packets_.size();
            } else if (k < count && (child = build(parts[k])) < 0) {
                return -1;
            }
            nodes_[node].child[k] = child;
        }
        return node;
    }

  private:
    // The second side is appended, so that the parts stay in the order of their items.
    static void cut(Part* parts, int count, int i)
    {
        const Part whole = parts[i];
        const int left = divide(whole);
        for (int k = count; k > i + 1; --k) parts[k] = parts[k - 1];
        parts[i] = part_of(whole.first, left, whole.cuts + 1);
        parts[i + 1] = part_of(whole.first + left, whole.count - left, whole.cuts + 1);
    }

    // Coordinates come with refit().
    static MeshPacket packet_of(const Part& part)
    {
        MeshPacket p{};
        for (int k = 0; k < 4; ++k) p.lanes[k] = k < part.count ? part.first[k].triangle : MeshPacket::kNone;
        return p;
    }

    Array<Four>& nodes_;
    Array<MeshPacket>& packets_;
};

// Makes nodes of sixteen from nodes of four: children of a node with the most nodes below them are replaced
// by their own children until sixteen are reached. False when memory is exhausted.
bool put_together(const Array<Four>& fours, Array<MeshNode>& nodes)
{
    Array<int> below;  // of each node of four: number of nodes below it
    Array<int> roots;  // of each node of sixteen: the node of four at its top
    if (!below.resize(fours.size()) || !roots.push(0)) return false;
    for (int n = fours.size() - 1; n >= 0; --n) {
        below[n] = 1;
        for (const int c : fours[n].child) below[n] += c >= 0 ? below[c] : 0;
    }
    for (int w = 0; w < roots.size(); ++w) {
        MeshNode node{};
        node.child[node.count++] = roots[w];
        while (node.count <= MeshNode::kMaxChildren - 3) {
            int best = -1;
            for (int i = 0; i < node.count; ++i)
                if (node.child[i] >= 0 && (best < 0 || below[node.child[i]] > below[node.child[best]]))
                    best = i;
            if (best < 0) break;
            const Four& four = fours[node.child[best]];
            node.child[best] = node.child[--node.count];
            for (const int c : four.child)
                if (c != Four::kNone) node.child[node.count++] = c;
        }
        for (int i = 0; i < node.count; ++i) {
            if (node.child[i] < 0) continue;
            const int four = node.child[i];
            node.child[i] = roots.size();
            if (!roots.push(four)) return false;
        }
        if (!nodes.push(node)) return false;
    }
    return true;
}

// The power of two that scales x, positive, into 1/2 ... 1; next to zero, one that is still finite.
Real scale_for(Real x)
{
    int exponent = 0;
    (void)std::frexp(x, &exponent);
    return std::ldexp(Real(1), std::min(-exponent, std::numeric_limits<Real>::max_exponent - 4));
}

FloatBox widened(FloatBox b)
{
    for (int i = 0; i < 3; ++i) {
        b.lo[i] -= kMeshMargin;
        b.hi[i] += kMeshMargin;
    }
    return b;
}

}  // namespace

// Halves the corners before it adds or subtracts them, because their sum might overflow. Leaves cached for
// another frame are invalidated.
void MeshTree::set_frame(const TriangleMesh& mesh)
{
    edition_ = g_editions.fetch_add(1, std::memory_order_relaxed) + 1;
    box_ = mesh.box();
    centre_ = Real(0.5) * box_.lo + Real(0.5) * box_.hi;
    const Real half = max_component(Real(0.5) * box_.hi - Real(0.5) * box_.lo);
    scale_ = half > 0 ? scale_for(half) : Real(1);
}

bool MeshTree::build(const TriangleMesh& mesh)
{
    MeshTree made;
    made.set_frame(mesh);
    const int count = mesh.triangle_count();
    Array<Item> items;
    if (!items.resize(count)) return false;
    if (count > 0) {
        for (int t = 0; t < count; ++t) {
            const Aabb box = mesh.box(t);
            items[t] = {widened(float_box({made.in_frame(box.lo), made.in_frame(box.hi)})), t};
        }
        Array<Four> fours;
        if (Builder(fours, made.packets_).build(part_of(items.data(), count, 0)) < 0 ||
            !put_together(fours, made.nodes_) || !made.bounds_.resize(made.nodes_.size()))
            return false;
        made.refit(mesh);
    }
    *this = static_cast<MeshTree&&>(made);
    return true;
}

FloatBox MeshTree::bounds_of(const TriangleMesh& mesh, int child) const
{
    if (child >= 0) return bounds_.data()[child];
    const MeshPacket& packet = packets_.data()[-1 - child];
    FloatBox all = kEmpty;
    for (int k = 0; k < 4 && packet.used(k); ++k) {
        const Aabb box = mesh.box(packet.triangle(k));
        enclose(all, widened(float_box({in_frame(box.lo), in_frame(box.hi)})));
    }
    return all;
}

// Lanes without a triangle repeat the first one.
void MeshTree::fill(MeshPacket& packet, const TriangleMesh& mesh) const
{
    for (int k = 0; k < 4; ++k) {
        const int t = packet.triangle(packet.used(k) ? k : 0);
        if (packet.used(k)) packet.lanes[k] = mesh.degenerate(t) ? -2 - t : t;
        packet.corners[k] = mesh.corners(t);
        for (int c = 0; c < 3; ++c) {
            const Vec3 p = in_frame(mesh.corner(t, c));
            for (int i = 0; i < 3; ++i) packet.at[c][i][k] = float(p[i]);
        }
    }
}

void MeshTree::refit(const TriangleMesh& mesh)
{
    set_frame(mesh);
    for (MeshPacket& packet : packets_) fill(packet, mesh);
    for (int n = nodes_.size() - 1; n >= 0; --n) {
        MeshNode& node = nodes_[n];
        FloatBox boxes[MeshNode::kMaxChildren], all = kEmpty;
        for (int k = 0; k < node.count; ++k) {
            boxes[k] = bounds_of(mesh, node.child[k]);
            enclose(all, boxes[k]);
        }
        node.place(boxes, all);
        bounds_[n] = all;
    }
}

bool MeshTree::update_cache(NearLeaves& kept, const FloatBox& query_box) const
{
    if (!kept.knows(edition_, query_box) || kept.count == NearLeaves::kOnlyPlace) {
        const bool near = kept.is_near(edition_, query_box);
        kept.edition = edition_;
        float side = 0;
        for (int i = 0; i < 3; ++i) side = std::max(side, query_box.hi[i] - query_box.lo[i]);
        for (int i = 0; i < 3; ++i) {
            kept.box.lo[i] = query_box.lo[i] - kRoam * side;
            kept.box.hi[i] = query_box.hi[i] + kRoam * side;
        }
        kept.count = NearLeaves::kOnlyPlace;
        if (near) gather(kept);
    }
    return kept.count <= NearLeaves::kCapacity;
}

void MeshTree::gather(NearLeaves& kept) const
{
    kept.count = 0;
    walk(NodeBox(kept.box), [&](int leaf) {
        if (!packets_.data()[leaf].met_by(kept.box)) return true;
        if (kept.count < NearLeaves::kCapacity) kept.leaf[kept.count] = leaf;
        return ++kept.count <= NearLeaves::kCapacity;
    });
}

// Of unit length; beyond the mesh d does not matter.
HalfSpace MeshTree::half_space(Vec3 n, Real d) const
{
    const Real size = length(n);
    const Vec3 unit = size > 0 ? n / size : Vec3{};
    const Real far = size > 0 ? scale_ * (d / size - dot(unit, centre_)) : (d >= 0 ? kInf : -kInf);
    return {{float(unit.x), float(unit.y), float(unit.z)}, float(far > 4 ? 4 : far < -4 ? -4 : far)};
}

// Clips the ray to the slightly widened box of the mesh and moves its origin there. False when it misses.
bool MeshTree::enter(MeshRay& ray, Real from, Real& to) const
{
    const Real margin = Real(kMeshMargin) / scale_;
    Real first = from, last = to;
    for (int i = 0; i < 3; ++i) {
        const Real lo = box_.lo[i] - margin - ray.origin[i], hi = box_.hi[i] + margin - ray.origin[i];
        const Real d = ray.direction[i];
        if (d == 0) {
            if (lo > 0 || hi < 0) return false;
            continue;
        }
        const Real a = lo / d, b = hi / d;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    if (!(first <= last)) return false;
    ray.origin += first * ray.direction;
    ray.start = first;
    to = last;
    return true;
}

}  // namespace epode
