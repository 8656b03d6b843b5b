// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Depth-first search with an explicit stack from each awake body, newest first, among the active ones
// (dynamics/active); where a joint leads behind these, what is there is made active first. The order of
// bodies and joints is a function of the calls that built the world only. Union-find would do as well; the
// search yields bodies in an order in which neighbours are close in memory. Joints come by the ten thousand,
// mostly contacts, and lie apart in memory: one walk along the world's roster finds out all that is asked of
// them here. Bodies are numbered in the order of that walk. Joints that follow each other there between the
// same two bodies, as the contacts of a pair do, are one bond; the search goes over bonds, two in a line of
// the cache. Bodies themselves it does not touch: neighbours in a pile are none in memory.
#include "dynamics/island.h"

#include <cstdint>
#include <new>

#include "base/prefetch.h"
#include "dynamics/active.h"
#include "dynamics/coupling.h"
#include "dynamics/sleep/settle.h"

namespace epode {
namespace {

// Acting joints of one pair of bodies, given by their numbers.
struct Bond {
    int body[2];  // the second is kWorld for the static world
    int next[2];  // in the lists of the bodies
    int first, count;
    bool plain, taken;  // all of them plain contacts?
    bool feedback, impulses;
};

constexpr int kWorld = -1, kNone = -1, kUnknown = -2;

enum class Reach : std::uint8_t { kNobody, kAwake, kAsleep, kReached, kTaken };

// What is active, as arrays; bodies and bonds are newest first.
class Bonds {
  public:
    // `more`: bonds of couplings in addition to those of their joints.
    Bonds(int bodies, int joints, int more, Arena& arena)
        : bodies_(arena.take<Body*>(bodies)),
          reach_(arena.take<Reach>(bodies)),
          newest_(arena.take<int>(bodies)),
          manifolds_(arena.take<ManifoldEdge*>(bodies)),
          joints_(arena.take<Joint*>(joints)),
          bonds_(arena.take<Bond>(joints + more))
    {}

    // Below these places; world.reached gets the bodies behind what is active. False: out of memory.
    bool gather(World& world, int body_places, int joint_places)
    {
        world.reached.clear();
        world.bodies.for_each_active_before(body_places, [&](Body& b) {
            const auto number = std::size_t(b.island_index = body_count_++);
            b.manifolds = nullptr;
            bodies_[number] = &b;
            reach_[number] = b.disabled ? Reach::kAsleep : Reach::kAwake;
            manifolds_[number] = nullptr;
            newest_[number] = kNone;
        });
        world.joints.for_each_active_before(
            joint_places, [&](Joint & joint) __attribute__((always_inline)) { add(joint); });
        // From the oldest on, so that each list begins with the newest.
        for (int i = bond_count_; i-- > 0;) link(i);
        return complete_;
    }

    // world.reached gets the bodies behind these, too. False: out of memory.
    bool reach_through(std::span<const ManifoldEdge> manifolds)
    {
        for (const ManifoldEdge& edge : manifolds)
            for (Body* body : edge.body)
                if (body && !is_active(*body)) complete_ = body->world->reached.push(body) && complete_;
        return complete_;
    }

    // Into the lists of their bodies, in order.
    void link(std::span<ManifoldEdge> manifolds)
    {
        for (std::size_t i = manifolds.size(); i-- > 0;)
            for (int side = 0; side < 2; ++side)
                if (Body* body = manifolds[i].body[side]) {
                    const int place = manifolds[i].place[side] = body->island_index;
                    manifolds[i].next[side] = body->manifolds;
                    body->manifolds = manifolds_[std::size_t(place)] = &manifolds[i];
                }
    }

    // Each body for itself (World::acts_as_ode); those that an awake one reaches wake up again.
    void put_idle_to_sleep(Real h)
    {
        for (std::size_t i = 0; i < bodies(); ++i)
            if (reach_[i] == Reach::kAwake && fall_asleep_alone(*bodies_[i], h)) reach_[i] = Reach::kAsleep;
    }

    std::size_t bodies() const { return std::size_t(body_count_); }
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
    ManifoldEdge* manifolds_of(std::size_t place) const { return manifolds_[place]; }
    std::span<Joint* const> joints_of(const Bond& bond) const
    {
        return joints_.subspan(std::size_t(bond.first), std::size_t(bond.count));
    }

  private:
    [[gnu::always_inline]] void add(Joint& joint)
    {
        Body *body1 = joint.body1(), *body2 = joint.body2();
        if (body1 != body1_ || body2 != body2_) {
            body1_ = body1, body2_ = body2;
            open_ = nullptr;
            look_at_bodies();
        }
        if (!active_) {
            if (is_coupling(joint)) return tie(coupling_of(joint));
            joint.world->joints.deactivate(joint);
        }
        if (!acting_ || joint.disabled) return;
        if (!open_ || open_->plain != joint.plain) open_bond(joint);
        put(joint);
    }

    // A coupling is a chain of bonds through its bodies, of which the first has the joint.
    void tie(CouplingJoint& coupling)
    {
        open_ = nullptr;
        bool active = false;
        for_each_body(coupling, [&](const Body& body) { active = active || is_active(body); });
        if (!active) return coupling.world->joints.deactivate(coupling);
        if (!acts(coupling)) return;
        int last = kUnknown;
        for_each_body(coupling, [&](Body& body) {
            const int number = number_of(body);
            if (number == kUnknown || number == last) return;
            if (last != kUnknown || !open_) {
                number1_ = number, number2_ = last == kUnknown ? kWorld : last;
                const bool first = !open_;
                open_bond(coupling);
                if (first) put(coupling);
            }
            last = number;
        });
        open_ = nullptr;
    }

    void put(Joint& joint)
    {
        joints_[std::size_t(joint_count_++)] = &joint;
        ++open_->count;
        open_->feedback = open_->feedback || joint.feedback;
        open_->impulses = open_->impulses || joint.impulse_rows;
    }

    void look_at_bodies()
    {
        active_ = (body1_ && is_active(*body1_)) || (body2_ && is_active(*body2_));
        acting_ = active_ && (!body1_->kinematic() || (body2_ && !body2_->kinematic()));
        if (!acting_) return;
        number1_ = number_of(*body1_), number2_ = body2_ ? number_of(*body2_) : kWorld;
        acting_ = number1_ != kUnknown && number2_ != kUnknown;
    }

    // Unknown are those that become active now, and what the program has made while it was asked for memory.
    int number_of(Body& body)
    {
        if (!is_active(body))
            complete_ = body.world->reached.push(&body) && complete_;
        else if (unsigned(body.island_index) < unsigned(body_count_))
            return body.island_index;
        return kUnknown;
    }

    void open_bond(const Joint& joint)
    {
        open_ = &bonds_[std::size_t(bond_count_++)];
        *open_ = {};
        open_->body[0] = number1_;
        open_->body[1] = number2_;
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
    std::span<int> newest_;               // bond of each body
    std::span<ManifoldEdge*> manifolds_;  // the first of each body
    std::span<Joint*> joints_;
    std::span<Bond> bonds_;
    int body_count_ = 0, joint_count_ = 0, bond_count_ = 0;
    bool complete_ = true;
    Body *body1_ = nullptr, *body2_ = nullptr;  // of the last joint,
    int number1_ = 0, number2_ = 0;             // their numbers,
    bool active_ = false;                       // whether one of them is active,
    bool acting_ = false;                       // and whether it acts if it is not disabled
    Bond* open_ = nullptr;                      // the last bond, if the next joint may belong to it
};

class Search {
  public:
    Search(int bodies, int joints, std::size_t manifolds, Arena& arena)
        : bodies_(arena.take<Body*>(bodies)),
          joints_(arena.take<Joint*>(joints)),
          manifolds_(arena.take<ManifoldEdge*>(int(manifolds))),
          islands_(arena.take<Island>(bodies))
    {}

    // `stack`: room for all bodies.
    Island& grow_from(std::size_t seed, Bonds& bonds, std::span<int> stack)
    {
        const std::size_t first_body = body_count_, first_joint = joint_count_,
                          first_manifold = manifold_count_;
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
            for (ManifoldEdge* e = bonds.manifolds_of(place); e;) {
                const int side = e->place[0] == int(place) ? 0 : 1, other = e->place[1 - side];
                if (other == kWorld || bonds.reach(std::size_t(other)) != Reach::kTaken) {
                    manifolds_[manifold_count_++] = e;
                    if (other != kWorld) reach(other);
                }
                e = e->next[side];
            }
        }
        island.bodies = bodies_.subspan(first_body, body_count_ - first_body);
        island.joints = joints_.subspan(first_joint, joint_count_ - first_joint);
        island.manifolds = manifolds_.subspan(first_manifold, manifold_count_ - first_manifold);
        return island;
    }

    void drop_last()
    {
        const Island& island = islands_[--island_count_];
        body_count_ -= island.bodies.size();
        joint_count_ -= island.joints.size();
        manifold_count_ -= island.manifolds.size();
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
    std::span<ManifoldEdge*> manifolds_;
    std::span<Island> islands_;
    std::size_t body_count_ = 0, joint_count_ = 0, manifold_count_ = 0, island_count_ = 0;
};

// True: it has fallen asleep. False: it may settle.
bool sleep_or_settle(Island& island, Real h)
{
    Readiness found;
    if (fall_asleep(island, h, found)) return true;
    settle(island, h, found);
    return false;
}

}  // namespace

bool find_islands(World& world, Real h, std::span<ManifoldEdge> manifolds, Arena& arena, Islands& found)
{
    activate_couplings(world);
    // Bodies and joints that the program creates while it is asked for memory are behind these: the next
    // step's.
    const int bodies = world.bodies.active_count(), body_places = world.bodies.places();
    const int joints = world.joints.active_count(), joint_places = world.joints.places();
    Search search(bodies, joints, manifolds.size(), arena);
    found.asleep = arena.take<Body*>(bodies);
    Arena::Scope scope(arena);
    Bonds bonds(bodies, joints, kMaxBodyTerms * world.couplings.size(), arena);
    const auto stack = arena.take<int>(bodies);
    if (arena.failed() || !bonds.gather(world, body_places, joint_places) || !bonds.reach_through(manifolds))
        return false;
    if (!world.reached.empty()) return true;
    bonds.link(manifolds);
    const bool alone = world.watches_bodies && world.acts_as_ode();
    if (alone) bonds.put_idle_to_sleep(h);
    for (std::size_t i = 0; i < bonds.bodies(); ++i)
        if (bonds.reach(i) == Reach::kAwake) {
            Island& island = search.grow_from(i, bonds, stack);
            if (world.watches_bodies && !alone && sleep_or_settle(island, h)) search.drop_last();
        }
    std::size_t asleep = 0;
    for (std::size_t i = 0; i < bonds.bodies(); ++i)
        if (bonds.reach(i) == Reach::kAsleep) found.asleep[asleep++] = &bonds.body(i);
    found.asleep = found.asleep.first(asleep);
    found.all = search.islands();
    return true;
}

}  // namespace epode
