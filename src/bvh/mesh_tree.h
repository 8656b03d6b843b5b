// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The tree over the triangles of a mesh, asked by box and by ray. A node has sixteen children, whose boxes
// lie on a grid of its own, 256 steps to a side (8 bits a bound instead of 32 or 64). The grids are in a
// frame of the whole mesh, [-1, 1] to the half of its largest side or less, where floats are as good as
// anywhere; every box is larger by kMeshMargin than what it holds, which is more than the rounding of all
// that is done with it, so that nothing is ever missed. One grid for all nodes (16 bits) would be simpler,
// but blind in a mesh of which one vertex lies far off. Built from above by binned surface area (Wald, "On
// fast construction of SAH-based bounding volume hierarchies", 2007), four parts at a time. The depth is
// bounded, so that walks need no more than a short stack. The order in which triangles are reported depends
// on how the tree was made and on nothing else; refit() keeps it.
#pragma once

#include <bit>

#include "base/prefetch.h"
#include "bvh/mesh_probe.h"
#include "bvh/near_leaves.h"
#include "geometry/triangle_mesh.h"

namespace epode {

// A ray in the mesh's frame, as triangles are tested by it: moved to where it enters the mesh's box.
struct MeshRay {
    Vec3 origin;
    Vec3 direction;
    Real start = 0;  // how far it was moved, in lengths of `direction`
    Real scale = 1;  // a power of two that brings the mesh to the size of 1
};

class MeshTree {
  public:
    // False when memory is exhausted: the tree is as it was.
    [[nodiscard]] bool build(const TriangleMesh& mesh);

    // After vertices have moved. Needs no memory.
    void refit(const TriangleMesh& mesh);

    // visit(triangle) for all that are not degenerate and whose boxes meet `box`, until it answers false.
    template <typename Visit>
    void query(const TriangleMesh& mesh, const Aabb& box, Visit&& visit) const;

    // visit(packet, lane) for those that a solid, which lies in the box, may touch; see(leaf, lanes) before,
    // for the leaves that meet the box: at() of each has the triangles. `kept`: of who asks, brought up to
    // date; or null.
    template <typename See, typename Visit>
    void query(const Aabb& box, const SolidProbe& solid, NearLeaves* kept, See&& see, Visit&& visit) const;
    int at(int leaf, int lane) const { return packets_.data()[leaf].lanes[lane]; }

    // visit(triangle) for those, not degenerate, that may lie at or below the plane n . x = d, until it
    // answers false.
    template <typename Visit>
    void below(Vec3 n, Real d, Visit&& visit) const;

    // visit(ray, packet, lane) for those, not degenerate, that the ray may hit between `from` and `to`, near
    // ones first as a rule. It answers how far the ray has still to be followed (from its unmoved origin);
    // less than `from` ends it. see(packet) before, for each that the ray comes upon.
    template <typename See, typename Visit>
    void shoot(Vec3 origin, Vec3 direction, Real from, Real to, See&& see, Visit&& visit) const;

    const Aabb& box() const { return box_; }  // of the mesh; the origin when it is empty
    int node_count() const { return nodes_.size(); }

  private:
    static constexpr int kStack = (MeshNode::kMaxChildren - 1) * kMeshDepth + 1;

    // open(leaf) for those that a box or a half-space meets, until it answers false.
    template <typename Asked, typename Open>
    void walk(const Asked& asked, Open&& open) const;
    // The same along a ray that has entered: open(packet, reach) answers as a visit of shoot() does.
    template <typename Open>
    void follow(const MeshRay& ray, Real from, Real to, Open&& open) const;
    // Whether `kept` has all leaves that meet `asked`, then.
    bool bring_up_to_date(NearLeaves& kept, const FloatBox& asked) const;
    void gather(NearLeaves& kept) const;
    // Asks for the memory of a child that will be looked at soon.
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
    FloatBox in_frame(const Aabb& box) const  // what of it is in the mesh's
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

template <typename Asked, typename Open>
void MeshTree::walk(const Asked& asked, Open&& open) const
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
        for (unsigned met = node.met_by(asked); met != 0; met &= met - 1) {
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
    const FloatBox asked = in_frame(box);
    walk(NodeBox(asked), [&](int leaf) {
        const MeshPacket& packet = packets_.data()[leaf];
        for (unsigned met = packet.met_by(asked); met != 0; met &= met - 1) {
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
    const FloatBox asked = in_frame(box);
    const MeshProbe probe(solid, in_frame(solid.centre), scale_);
    const auto open = [&](int leaf) {
        const MeshPacket& packet = packets_.data()[leaf];
        const unsigned met = packet.met_by(asked);
        if (met == 0) return true;
        see(leaf, met);
        for (unsigned close = probe.meets(packet, met); close != 0; close &= close - 1)
            visit(packet, std::countr_zero(close));
        return true;
    };
    if (!kept || !bring_up_to_date(*kept, asked)) return walk(NodeBox(asked), open);
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
