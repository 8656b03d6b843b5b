// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The tree over the triangles of a mesh, queried by boxes and rays. A node has sixteen children, whose boxes
// lie on a grid of the node, 256 steps per side (8 bits per bound instead of 32 or 64). The grids are in a
// frame of the whole mesh, [-1, 1] to half of its largest side or less, where floats are as accurate as
// anywhere. Every box is larger by kMeshMargin than its contents, which is more than all rounding, so nothing
// is missed. One grid for all nodes (16 bits) would be simpler, but useless for a mesh with one distant
// vertex. The tree is built from the top by binned surface area (Wald, "On fast construction of SAH-based
// bounding volume hierarchies", 2007), four parts at a time. Its depth is bounded, so walks need only a short
// stack. The order in which triangles are reported depends only on how the tree was built; refit() preserves
// it.
#pragma once

#include <bit>

#include "base/prefetch.h"
#include "bvh/mesh_probe.h"
#include "bvh/near_leaves.h"
#include "geometry/triangle_mesh.h"

namespace epode {

// A ray in the mesh's frame, prepared for triangles: its origin is moved to where it enters the mesh's box.
struct MeshRay {
    Vec3 origin;
    Vec3 direction;
    Real start = 0;  // how far it was moved, in lengths of `direction`
    Real scale = 1;  // a power of two that brings the mesh to the size of 1
};

class MeshTree {
  public:
    // False when memory is exhausted; the tree is unchanged then.
    [[nodiscard]] bool build(const TriangleMesh& mesh);

    // After vertices have moved. Needs no memory.
    void refit(const TriangleMesh& mesh);

    // Calls visit(triangle) for all non-degenerate triangles whose boxes overlap `box`, until it returns
    // false.
    template <typename Visit>
    void query(const TriangleMesh& mesh, const Aabb& box, Visit&& visit) const;

    // Calls visit(packet, lane) for the triangles that a solid inside the box may touch, and before that
    // see(leaf, lanes) for every leaf that overlaps the box; at() of a leaf has the triangles. `kept`: the
    // cached leaves of the caller, which are updated; or null.
    template <typename See, typename Visit>
    void query(const Aabb& box, const SolidProbe& solid, NearLeaves* kept, See&& see, Visit&& visit) const;
    int at(int leaf, int lane) const { return packets_.data()[leaf].lanes[lane]; }

    // Calls visit(triangle) for the non-degenerate triangles that may lie at or below the plane n . x = d,
    // until it returns false.
    template <typename Visit>
    void below(Vec3 n, Real d, Visit&& visit) const;

    // Calls visit(ray, packet, lane) for the non-degenerate triangles that the ray may hit between `from` and
    // `to`, mostly near ones first. It returns how far the ray must still be followed (from its original
    // origin); less than `from` ends the walk. see(packet) comes first, for every packet that the ray meets.
    template <typename See, typename Visit>
    void shoot(Vec3 origin, Vec3 direction, Real from, Real to, See&& see, Visit&& visit) const;

    const Aabb& box() const { return box_; }  // of the mesh; the origin when it is empty
    int node_count() const { return nodes_.size(); }

  private:
    static constexpr int kStack = (MeshNode::kMaxChildren - 1) * kMeshDepth + 1;

    // Calls open(leaf) for the leaves that overlap a box or a half-space, until it returns false.
    template <typename Query, typename Open>
    void walk(const Query& shape, Open&& open) const;
    // The same along a ray that has entered the box: open(packet, reach) returns the same as visit in
    // shoot().
    template <typename Open>
    void follow(const MeshRay& ray, Real from, Real to, Open&& open) const;
    // True if `kept`, after an update, has all leaves that overlap `query_box`.
    bool update_cache(NearLeaves& kept, const FloatBox& query_box) const;
    void gather(NearLeaves& kept) const;
    // Prefetches a child that will be visited soon.
    void prefetch(int child) const
    {
        if (child >= 0)
            epode::prefetch<sizeof(MeshNode) / kCacheLine>(nodes_.data() + child);
        else
            prefetch_leaf(-1 - child);
    }
    void prefetch_leaf(int leaf) const
    {
        epode::prefetch<(sizeof(MeshPacket) + kCacheLine - 1) / kCacheLine>(packets_.data() + leaf);
    }
    HalfSpace half_space(Vec3 n, Real d) const;
    bool enter(MeshRay& ray, Real from, Real& to) const;
    Vec3 in_frame(Vec3 p) const { return scale_ * (p - centre_); }
    FloatBox in_frame(const Aabb& box) const  // the box in the mesh's frame
    {
        return float_box({in_frame(max(box.lo, box_.lo)), in_frame(min(box.hi, box_.hi))});
    }
    void set_frame(const TriangleMesh& mesh);
    FloatBox bounds_of(const TriangleMesh& mesh, int child) const;
    void fill(MeshPacket& packet, const TriangleMesh& mesh) const;

    Array<MeshNode> nodes_;  // children behind their parents
    Array<MeshPacket> packets_;
    Array<FloatBox> bounds_;  // of each node, for refit()
    Aabb box_;
    Vec3 centre_;
    Real scale_ = 1;             // a power of two
    std::uint64_t edition_ = 0;  // see near_leaves.h
};

template <typename Query, typename Open>
void MeshTree::walk(const Query& shape, Open&& open) const
{
    if (nodes_.empty()) return;
    int stack[kStack];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
        const int child = stack[--top];
        if (child < 0) {
            if (!open(-1 - child)) return;
            continue;
        }
        const MeshNode& node = nodes_.data()[child];
        for (unsigned met = node.met_by(shape); met != 0; met &= met - 1) {
            const int next = node.child[std::countr_zero(met)];
            prefetch(next);
            stack[top++] = next;
        }
    }
}

template <typename Visit>
void MeshTree::query(const TriangleMesh& mesh, const Aabb& box, Visit&& visit) const
{
    if (!overlap(box, box_)) return;
    const FloatBox query_box = in_frame(box);
    walk(NodeBox(query_box), [&](int leaf) {
        const MeshPacket& packet = packets_.data()[leaf];
        for (unsigned met = packet.met_by(query_box); met != 0; met &= met - 1) {
            const int t = packet.lanes[std::countr_zero(met)];
            if (overlap(mesh.box(t), box) && !visit(t)) return false;
        }
        return true;
    });
}

template <typename See, typename Visit>
void MeshTree::query(const Aabb& box, const SolidProbe& solid, NearLeaves* kept, See&& see,
                     Visit&& visit) const
{
    if (!overlap(box, box_)) return;
    const FloatBox query_box = in_frame(box);
    const MeshProbe probe(solid, in_frame(solid.centre), scale_);
    const auto open = [&](int leaf) {
        const MeshPacket& packet = packets_.data()[leaf];
        const unsigned met = packet.met_by(query_box);
        if (met == 0) return true;
        see(leaf, met);
        for (unsigned close = probe.meets(packet, met); close != 0; close &= close - 1)
            visit(packet, std::countr_zero(close));
        return true;
    };
    if (!kept || !update_cache(*kept, query_box)) return walk(NodeBox(query_box), open);
    for (int i = 0; i < kept->count; ++i) prefetch_leaf(kept->leaf[i]);
    for (int i = 0; i < kept->count; ++i) open(kept->leaf[i]);
}

template <typename Visit>
void MeshTree::below(Vec3 n, Real d, Visit&& visit) const
{
    walk(half_space(n, d), [&](int leaf) {
        const MeshPacket& packet = packets_.data()[leaf];
        for (unsigned met = packet.whole(); met != 0; met &= met - 1)
            if (!visit(packet.lanes[std::countr_zero(met)])) return false;
        return true;
    });
}

template <typename Open>
void MeshTree::follow(const MeshRay& ray, Real from, Real to, Open&& open) const
{
    const NodeRay node_ray(in_frame(ray.origin), ray.direction);
    const auto left = [&] { return float(scale_ * (to - ray.start)) + kMeshMargin; };
    float reach = left();
    WaitingNode stack[kStack];
    int top = 0;
    stack[top++] = WaitingNode(0, 0);
    while (top > 0) {
        const WaitingNode next = stack[--top];
        if (next.near() > reach) continue;
        if (next.child() < 0) {
            to = open(packets_.data()[-1 - next.child()], reach);
            if (to < from) return;
            reach = left();
            continue;
        }
        const MeshNode& node = nodes_.data()[next.child()];
        float near[MeshNode::kMaxChildren];
        const int bottom = top;
        for (unsigned met = node.met_by(node_ray, reach, near); met != 0; met &= met - 1) {
            const int k = std::countr_zero(met);
            prefetch(node.child[k]);
            const WaitingNode one(node.child[k], near[k]);
            int at = top++;
            for (; at > bottom && stack[at - 1].nearer(one); --at) stack[at] = stack[at - 1];
            stack[at] = one;
        }
    }
}

template <typename See, typename Visit>
void MeshTree::shoot(Vec3 origin, Vec3 direction, Real from, Real to, See&& see, Visit&& visit) const
{
    MeshRay ray{origin, direction, 0, scale_};
    if (nodes_.empty() || !enter(ray, from, to)) return;
    const PacketRay packet_ray(in_frame(ray.origin), direction);
    follow(ray, from, to, [&](const MeshPacket& packet, float reach) {
        see(packet);
        for (unsigned met = packet.met_by(packet_ray, reach); met != 0; met &= met - 1) {
            to = visit(ray, packet, std::countr_zero(met));
            if (to < from) break;
        }
        return to;
    });
}

}  // namespace epode
