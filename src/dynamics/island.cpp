// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Depth-first search with an explicit stack from each awake body, newest first. The order of bodies and
// joints is a function of the calls that built the world only. Union-find would do as well; the search walks
// the adjacency that exists anyway and yields bodies in an order in which neighbours are close in memory.
#include "dynamics/island.h"

#include <cstdint>

#include "base/ahead.h"

namespace epode {
namespace {

class Search {
  public:
    Search(World& world, std::span<PatchEdge> patches, Arena& arena)
        : mark_(int(world.step_count)),
          bodies_(arena.take<Body*>(world.body_count)),
          joints_(arena.take<Joint*>(world.joint_count)),
          patches_(arena.take<PatchEdge*>(int(patches.size()))),
          stack_(arena.take<Body*>(world.body_count)),
          islands_(arena.take<Island>(world.body_count))
    {}

    void grow_from(Body& seed)
    {
        const int first_body = body_count_, first_joint = joint_count_, first_patch = patch_count_;
        seed.island_index = 0;
        int depth = 0;
        stack_[std::size_t(depth++)] = &seed;
        while (depth) {
            Body& body = *stack_[std::size_t(--depth)];
            body.island_index = body_count_ - first_body;
            bodies_[std::size_t(body_count_++)] = &body;
            for_each_linked<2, 1>(body.joints, [&](JointNode& n) { visit(n, depth); });
            for (PatchEdge* e = body.patches; e;) {
                const int side = e->body[0] == &body ? 0 : 1;
                visit(*e, side, depth);
                e = e->next[side];
            }
        }
        islands_[std::size_t(island_count_++)] = {
            bodies_.subspan(std::size_t(first_body), std::size_t(body_count_ - first_body)),
            joints_.subspan(std::size_t(first_joint), std::size_t(joint_count_ - first_joint)),
            patches_.subspan(std::size_t(first_patch), std::size_t(patch_count_ - first_patch))};
    }

    std::span<Island> islands() const { return islands_.first(std::size_t(island_count_)); }

  private:
    void visit(JointNode& node, int& depth)
    {
        Joint& joint = *node.joint;
        if (joint.island_mark == mark_ || !acting(joint)) return;
        joint.island_mark = mark_;
        joints_[std::size_t(joint_count_++)] = &joint;
        reach(joint.node[&node == &joint.node[0] ? 1 : 0].body, depth);
    }

    void visit(PatchEdge& edge, int side, int& depth)
    {
        if (edge.taken) return;
        edge.taken = true;
        patches_[std::size_t(patch_count_++)] = &edge;
        reach(edge.body[1 - side], depth);
    }

    void reach(Body* other, int& depth)
    {
        if (!other || other->island_index >= 0) return;
        other->island_index = 0;  // tagged; its place is known when it is taken from the stack
        fetch<1>(other->patches);
        const auto node = reinterpret_cast<std::uintptr_t>(other->joints);  // in a joint, not looked at yet
        fetch<2>(reinterpret_cast<const void*>(node - kCacheLine));
        stack_[std::size_t(depth++)] = other;
    }

    int mark_;
    std::span<Body*> bodies_;
    std::span<Joint*> joints_;
    std::span<PatchEdge*> patches_;
    std::span<Body*> stack_;
    std::span<Island> islands_;
    int body_count_ = 0, joint_count_ = 0, patch_count_ = 0, island_count_ = 0;
};

// Into the lists of their bodies, in order.
void link(std::span<PatchEdge> patches)
{
    for (std::size_t i = patches.size(); i-- > 0;)
        for (int side = 0; side < 2; ++side)
            if (Body* body = patches[i].body[side]) {
                patches[i].next[side] = body->patches;
                body->patches = &patches[i];
            }
}

}  // namespace

bool find_islands(World& world, std::span<PatchEdge> patches, Arena& arena, std::span<Island>& islands)
{
    // Bodies that the program creates while it is asked for memory come before this one: the next step's.
    Body* const newest = world.bodies;
    Search search(world, patches, arena);
    if (arena.failed()) return false;
    for_each_linked<1>(newest, [](Body& b) { b.island_index = -1, b.patches = nullptr; });
    link(patches);
    for_each_linked<1>(newest, [&](Body& b) {
        if (b.island_index < 0 && !b.disabled) search.grow_from(b);
    });
    islands = search.islands();
    return true;
}

}  // namespace epode
