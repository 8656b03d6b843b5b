// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Depth-first search with an explicit stack from each awake body, newest first. The order of bodies and
// joints is a function of the calls that built the world only. Union-find would do as well; the search walks
// the adjacency that exists anyway and yields bodies in an order in which neighbours are close in memory.
#include "dynamics/island.h"

namespace epode {
namespace {

class Search {
  public:
    Search(World& world, Arena& arena)
        : mark_(int(world.step_count)),
          bodies_(arena.take<Body*>(world.body_count)),
          joints_(arena.take<Joint*>(world.joint_count)),
          stack_(arena.take<Body*>(world.body_count)),
          islands_(arena.take<Island>(world.body_count))
    {}

    void grow_from(Body& seed)
    {
        const int first_body = body_count_, first_joint = joint_count_;
        seed.island_index = 0;
        int depth = 0;
        stack_[std::size_t(depth++)] = &seed;
        while (depth) {
            Body& body = *stack_[std::size_t(--depth)];
            body.island_index = body_count_ - first_body;
            bodies_[std::size_t(body_count_++)] = &body;
            for (JointNode* n = body.joints; n; n = n->next) visit(*n, depth);
        }
        islands_[std::size_t(island_count_++)] = {
            bodies_.subspan(std::size_t(first_body), std::size_t(body_count_ - first_body)),
            joints_.subspan(std::size_t(first_joint), std::size_t(joint_count_ - first_joint))};
    }

    std::span<Island> islands() const { return islands_.first(std::size_t(island_count_)); }

  private:
    void visit(JointNode& node, int& depth)
    {
        Joint& joint = *node.joint;
        if (joint.island_mark == mark_ || !acting(joint)) return;
        joint.island_mark = mark_;
        joints_[std::size_t(joint_count_++)] = &joint;
        Body* other = joint.node[&node == &joint.node[0] ? 1 : 0].body;
        if (!other || other->island_index >= 0) return;
        other->island_index = 0;  // tagged; its place is known when it is taken from the stack
        stack_[std::size_t(depth++)] = other;
    }

    int mark_;
    std::span<Body*> bodies_;
    std::span<Joint*> joints_;
    std::span<Body*> stack_;
    std::span<Island> islands_;
    int body_count_ = 0, joint_count_ = 0, island_count_ = 0;
};

}  // namespace

bool find_islands(World& world, Arena& arena, std::span<Island>& islands)
{
    // Bodies that the program creates while it is asked for memory come before this one: the next step's.
    Body* const newest = world.bodies;
    Search search(world, arena);
    if (arena.failed()) return false;
    for (Body* b = newest; b; b = b->next) b->island_index = -1;
    for (Body* b = newest; b; b = b->next)
        if (b->island_index < 0 && !b->disabled) search.grow_from(*b);
    islands = search.islands();
    return true;
}

}  // namespace epode
