// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Depth-first search with an explicit stack from each awake body, newest first. The order of bodies and
// joints is a function of the calls that built the world only. Union-find would do as well; the search yields
// bodies in an order in which neighbours are close in memory.
// Joints come by the ten thousand, mostly contacts, and lie apart in memory: one walk along the world's
// roster finds out all that is asked of them here. Joints that follow each other there between the same two
// bodies, as the contacts of a pair do, are one bond; the search goes over bonds, two in a line of the cache.
// Bodies themselves it does not touch: neighbours in a pile are none in memory.
#include "dynamics/island.h"

#include <cstdint>
#include <new>

#include "base/ahead.h"

namespace epode {
namespace {

// Acting joints of one pair of bodies, given by their places in the world's roster.
struct Bond {
    int body[2];  // the second is kWorld for the static world
    int next[2];  // in the lists of the bodies
    int first, count;
    bool plain, taken;  // all of them plain contacts?
    bool feedback, impulses;
};

constexpr int kWorld = -1, kNone = -1;

enum class Reach : std::uint8_t { kNobody, kAwake, kAsleep, kReached, kTaken };

// The world as arrays. `places`: of the bodies that there are; bonds are newest first.
class Bonds {
  public:
    Bonds(int places, int joints, Arena& arena)
        : bodies_(arena.take<Body*>(places)),
          reach_(arena.take_zeroed<Reach>(places)),
          newest_(arena.take<int>(places)),
          patches_(arena.take<PatchEdge*>(places)),
          joints_(arena.take<Joint*>(joints)),
          bonds_(arena.take<Bond>(joints))
    {}

    // Joints below `joint_places`.
    void gather(World& world, int joint_places)
    {
        for (Body& b : world.bodies.before(int(bodies_.size()))) {
            b.patches = nullptr;
            b.island_index = -1;
            const auto place = std::size_t(b.place);
            bodies_[place] = &b;
            reach_[place] = b.disabled ? Reach::kAsleep : Reach::kAwake;
            patches_[place] = nullptr;
            newest_[place] = kNone;
        }
        for (Joint& joint : world.joints.before(joint_places)) add(joint);
        // From the oldest on, so that each list begins with the newest.
        for (int i = bond_count_; i-- > 0;) link(i);
    }

    // Into the lists of their bodies, in order.
    void link(std::span<PatchEdge> patches)
    {
        for (std::size_t i = patches.size(); i-- > 0;)
            for (int side = 0; side < 2; ++side)
                if (Body* body = patches[i].body[side]) {
                    const int place = patches[i].place[side] = body->place;
                    patches[i].next[side] = body->patches;
                    body->patches = patches_[std::size_t(place)] = &patches[i];
                }
    }

    std::size_t places() const { return bodies_.size(); }
    Body& body(std::size_t place) const { return *bodies_[place]; }
    Reach& reach(std::size_t place) { return reach_[place]; }
    // f(bond, the body's side of it), the newest first.
    template <typename F>
    void for_each_of(std::size_t place, F&& f)
    {
        for (int i = newest_[place]; i != kNone;) {
            Bond& bond = bonds_[std::size_t(i)];
            const int side = bond.body[0] == int(place) ? 0 : 1;
            f(bond, side);
            i = bond.next[side];
        }
    }
    PatchEdge* patches_of(std::size_t place) const { return patches_[place]; }
    std::span<Joint* const> joints_of(const Bond& bond) const
    {
        return joints_.subspan(std::size_t(bond.first), std::size_t(bond.count));
    }

  private:
    void add(Joint& joint)
    {
        if (joint.disabled) return;
        const Body *body1 = joint.body1(), *body2 = joint.body2();
        if (body1 != body1_ || body2 != body2_) {
            body1_ = body1, body2_ = body2;
            acting_ = acting(joint);
            open_ = nullptr;
        }
        if (!acting_) return;
        if (!open_ || open_->plain != joint.plain) open_bond(joint);
        joints_[std::size_t(joint_count_++)] = &joint;
        ++open_->count;
        open_->feedback = open_->feedback || joint.feedback;
        open_->impulses = open_->impulses || joint.impulse_rows;
    }

    void open_bond(const Joint& joint)
    {
        open_ = &bonds_[std::size_t(bond_count_++)];
        *open_ = {};
        open_->body[0] = body1_->place;
        open_->body[1] = body2_ ? body2_->place : kWorld;
        open_->first = joint_count_;
        open_->plain = joint.plain;
    }

    void link(int i)
    {
        Bond& bond = bonds_[std::size_t(i)];
        for (int side = 0; side < 2; ++side)
            if (bond.body[side] != kWorld) {
                int& newest = newest_[std::size_t(bond.body[side])];
                bond.next[side] = newest;
                newest = i;
            }
    }

    std::span<Body*> bodies_;
    std::span<Reach> reach_;
    std::span<int> newest_;          // bond of each body
    std::span<PatchEdge*> patches_;  // the first of each body
    std::span<Joint*> joints_;
    std::span<Bond> bonds_;
    int joint_count_ = 0, bond_count_ = 0;
    const Body *body1_ = nullptr, *body2_ = nullptr;  // of the last joint,
    bool acting_ = false;                             // which acts as it is not disabled
    Bond* open_ = nullptr;                            // the last bond, if the next joint may belong to it
};

class Search {
  public:
    Search(int bodies, int joints, std::size_t patches, Arena& arena)
        : bodies_(arena.take<Body*>(bodies)),
          joints_(arena.take<Joint*>(joints)),
          patches_(arena.take<PatchEdge*>(int(patches))),
          islands_(arena.take<Island>(bodies))
    {}

    // `stack`: room for all bodies' places.
    void grow_from(std::size_t seed, Bonds& bonds, std::span<int> stack)
    {
        const std::size_t first_body = body_count_, first_joint = joint_count_, first_patch = patch_count_;
        Island& island = *new (&islands_[island_count_++]) Island;
        std::size_t depth = 0;
        const auto reach = [&](int place) {
            Reach& reached = bonds.reach(std::size_t(place));
            if (reached >= Reach::kReached) return;
            reached = Reach::kReached;
            stack[depth++] = place;
        };
        reach(int(seed));
        while (depth) {
            const auto place = std::size_t(stack[--depth]);
            bonds.reach(place) = Reach::kTaken;
            bodies_[body_count_++] = &bonds.body(place);
            bonds.for_each_of(place, [&](Bond& bond, int side) {
                if (bond.taken) return;
                bond.taken = true;
                take(bonds.joints_of(bond), bond, island);
                if (const int other = bond.body[1 - side]; other != kWorld) reach(other);
            });
            for (PatchEdge* e = bonds.patches_of(place); e;) {
                const int side = e->place[0] == int(place) ? 0 : 1, other = e->place[1 - side];
                if (other == kWorld || bonds.reach(std::size_t(other)) != Reach::kTaken) {
                    patches_[patch_count_++] = e;
                    if (other != kWorld) reach(other);
                }
                e = e->next[side];
            }
        }
        island.bodies = bodies_.subspan(first_body, body_count_ - first_body);
        island.joints = joints_.subspan(first_joint, joint_count_ - first_joint);
        island.patches = patches_.subspan(first_patch, patch_count_ - first_patch);
    }

    std::span<Island> islands() const { return islands_.first(island_count_); }

  private:
    void take(std::span<Joint* const> joints, const Bond& bond, Island& island)
    {
        for (Joint* joint : joints) joints_[joint_count_++] = joint;
        if (bond.plain) island.plain_contacts += bond.count;
        island.feedback = island.feedback || (bond.plain && bond.feedback);
        island.impulses = island.impulses || bond.impulses;
    }

    std::span<Body*> bodies_;
    std::span<Joint*> joints_;
    std::span<PatchEdge*> patches_;
    std::span<Island> islands_;
    std::size_t body_count_ = 0, joint_count_ = 0, patch_count_ = 0, island_count_ = 0;
};

}  // namespace

bool find_islands(World& world, std::span<PatchEdge> patches, Arena& arena, std::span<Island>& islands)
{
    // Bodies and joints that the program creates while it is asked for memory are behind these: the next
    // step's.
    const int bodies = world.bodies.count(), places = world.bodies.places();
    const int joints = world.joints.count(), joint_places = world.joints.places();
    Search search(bodies, joints, patches.size(), arena);
    Arena::Scope scope(arena);
    Bonds bonds(places, joints, arena);
    const auto stack = arena.take<int>(bodies);
    if (arena.failed()) return false;
    bonds.gather(world, joint_places);
    bonds.link(patches);
    for (std::size_t place = bonds.places(); place-- > 0;)
        if (bonds.reach(place) == Reach::kAwake) search.grow_from(place, bonds, stack);
    islands = search.islands();
    return true;
}

}  // namespace epode
