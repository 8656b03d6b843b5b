// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// World-managed contacts. Every step makes a new list of pairs from the one before: pairs of the
// space in its order, each with its manifolds brought up to date; then the new list takes the place of the
// old. A step that cannot be finished just drops the new one, so it leaves no trace. Manifolds move from list
// to list, which costs less than looking for them in holes, and neighbours in space stay neighbours in
// memory.
// Where most of the world sleeps, a step looks at the geoms of active bodies alone, and the pairs between
// others lie apart (contacts/resting_pairs.h): what sleeps costs nothing.
#pragma once

#include <atomic>

#include "base/arena.h"
#include "base/array.h"
#include "base/streams/state_stream.h"
#include "collide/space.h"
#include "contacts/active_geoms.h"
#include "contacts/contact_pair.h"
#include "contacts/event_list.h"
#include "contacts/narrow_phase.h"
#include "contacts/pair_finder.h"
#include "contacts/pair_list.h"
#include "contacts/resting_pairs.h"
#include "contacts/space_geoms.h"
#include "dynamics/island.h"
#include "ode/contacts.h"
#include "tasks/tasks.h"

namespace epode {

// In states: the geom has pairs at rest; something has happened to it since the last step, or to what its body
// touches; the program has disabled its body since then.
enum GeomRest : std::uint8_t {
    kGeomDisturbed = 2,
    kGeomAtRest = 8,
    kGeomUnsupported = 16,
    kGeomPutDown = 32
};

struct ActiveBodies {
    int count, all;
};

// What a pair exerted in the last step, and what it will yet: contacts that are speculative stop two bodies where they meet, so
// a blow may begin in one step and end in the next.
struct PairImpulse {
    dGeomID g1, g2;
    Vec3 place, normal;  // where the bodies are now; unit, into g1
    Vec3 on_first;       // N s, with friction
    Real exerted;        // N s, along the normals
    Real remaining;      // N s: what stops the approach that is left, of these two alone
};

class ContactWorld {
  public:
    ContactWorld() = default;
    ContactWorld(const ContactWorld&) = delete;
    ContactWorld& operator=(const ContactWorld&) = delete;
    ~ContactWorld() { forget(); }

    dSpaceID space = nullptr;
    dContactFilter* filter = nullptr;
    void* filter_data = nullptr;
    dManifoldFunction* function = nullptr;  // of the program, for each manifold of a step
    void* function_data = nullptr;
    bool function_on_threads = false;

    // Would update() find what it found in the last step, given that all bodies sleep? Nobody was awake then,
    // and nothing has happened to the space since.
    bool is_settled(const Space& in) const;
    // The step is done, without an update: all pairs are as they were.
    void accept_settled(Real h);

    // Null: there is none, or it has been destroyed.
    Space* live_space() const { return space ? space_from(space) : nullptr; }

    // Before update(): the bodies that sleep on something that has been disturbed since the last step
    // (contacts/support.cpp). They are to be awake then. False: out of memory.
    [[nodiscard]] bool find_unsupported(const World& world, const Space& in, Array<Body*>& out);
    // Would update() look at active bodies alone? If not, all have to be active before.
    bool leaves_at_rest(const Space& in, ActiveBodies active) const;
    // Pairs and manifolds at the bodies' present poses. False: out of memory.
    // `h`: the coming step.
    [[nodiscard]] bool update(const World& world, Space& in, Real h, const Tasks& tasks);
    // A body becomes active after update(): its pairs that were at rest come back. `reached` gets the bodies
    // that they hold to it. When all have come they are listed, behind what update() has found. False: out of
    // memory.
    [[nodiscard]] bool bring_pairs(const Body& body, Array<Body*>& reached);
    [[nodiscard]] bool list_brought(const World& world);
    // Shows the manifolds that it has not seen in this step to the program's function (contacts/manifold_function.cpp).
    void show_manifolds(const Tasks& tasks);
    // The touching manifolds of what has been found, in order.
    [[nodiscard]] bool touching(const Tasks& tasks, Arena& arena, std::span<ManifoldEdge>& out);
    // The step is done: what it found is what the next one starts from. `h`: its length.
    void accept(Real h, const Tasks& tasks);
    // For events, if they are wanted (contact_events.cpp): before the solution, how fast points approach (false:
    // out of memory); after accept(), what has happened to the pairs of the step.
    [[nodiscard]] bool measure_approach(const Tasks& tasks);
    void report(EventList& out) const;
    // What is between bodies that are not active now lies apart until one of the geoms is looked at again.
    void lay_to_rest();
    void forget();
    // All that lies in the world has moved by this, between two steps (state/shift_origin.h).
    void shift(Vec3 by);

    // In states of the world (contact_state.cpp): what the next step starts from, and what of the last one
    // can be asked for. What is loaded lies where a step makes its pairs until it is accepted, which
    // cannot fail.
    class Loaded;
    // False: out of memory.
    [[nodiscard]] bool save(const World& world, const SpaceGeoms& geoms, StateStream& stream);
    [[nodiscard]] bool load(const World& world, const SpaceGeoms& geoms, StateStream& stream, Loaded& out);
    // All geoms have been told that they have moved, if they have.
    // `rest`: as mark_rest() has found when the state was saved.
    void accept(World& world, Loaded& loaded, const SpaceGeoms& geoms, std::span<const std::uint8_t> rest);
    // GeomRest of each geom, as bits.
    void mark_rest(const World& world, const SpaceGeoms& geoms, std::span<std::uint8_t> by_number) const;
    // What is broken between two steps, in words; null: nothing.
    const char* fault() const;

    int events(dContactEvent* out, int capacity) const;
    int contacts(dWorldContact* out, int capacity) const;
    // Impulses of pairs that did not rest and have one of these geoms, sorted serial numbers, in order. False: out of memory.
    [[nodiscard]] bool impulses(std::span<const std::uint64_t> geoms, Array<PairImpulse>& out) const;

  private:
    // What a range of found pairs has; after summing up, where it begins.
    struct PairRange {
        int pairs = 0, manifolds = 0, leaves = 0;
    };

    // How fast the points of a manifold approached before the step, m/s.
    struct PointSpeeds {
        Real at[kManifoldPoints];
    };
    dEvent impact_of(const ContactPair& pair) const;

    // A solid that moves, on what stands: its number, the pair's place, whether it is g1.
    struct FloorPair {
        std::uint64_t solid;
        int pair;
        bool first;
    };

    // A pair that a state may have.
    struct Listed {
        const ContactPair* pair;
        const CachedManifold* manifolds;
        bool rests;
    };
    // A geom, for its pairs in a state.
    struct Described {
        const Body* body;
        dGeomID id;
        std::uint64_t serial;
        std::uint32_t changes;
        bool meets, is_surface, is_mesh, is_solid;

        // Bodies that the program has set since a step may leave its pairs without meaning.
        static bool are_pair(const Described& a, const Described& b)
        {
            return a.meets && b.meets && a.body && a.body != b.body;
        }
    };
    // How many of each a state has.
    struct StateCounts {
        std::uint32_t pairs = 0, manifolds = 0, ended = 0;
    };

    [[nodiscard]] bool describe_geoms(const World& world, const SpaceGeoms& geoms);
    [[nodiscard]] bool list_with_resting();
    void save_pairs(float layer, const SpaceGeoms& geoms, StateStream& stream, StateCounts& counts);
    void save_pair(const Listed& listed, float layer, const SpaceGeoms& geoms, StateStream& stream,
                   StateCounts& counts) const;
    static bool save_ended(const dContactEvent& event, const SpaceGeoms& geoms, StateStream& stream);
    [[nodiscard]] bool load_pair(const World& world, StateStream& stream, std::uint32_t& used, Loaded& out);
    void put_to_rest(const Loaded& loaded, Space& in);
    void take_step_size(Real h);
    [[nodiscard]] bool take_disturbed(const Space& in);
    [[nodiscard]] bool expect_all(Space& in, const SpeculativeMotion& soon, const Tasks& tasks);
    [[nodiscard]] bool expect_few(const World& world, Space& in, const SpeculativeMotion& soon);
    [[nodiscard]] bool bring(Geom& geom);
    [[nodiscard]] bool choose_pairs(const World& world, const Tasks& tasks);
    [[nodiscard]] bool choose_range(const World& world, int range, RecordFinder& finder);
    [[nodiscard]] bool list_pairs(const World& world, const Tasks& tasks);
    ContactPair pair_of(const World& world, const GeomPair& from, int manifold, int leaf) const;
    void ask_filter();
    void collide_pairs(const World& world, Real h, const Tasks& tasks);
    void update_one(ContactPair& pair, int place, const NarrowSettings& settings);
    void keep_manifolds(ContactPair& pair, int place);
    NearLeaves* leaves_of(const ContactPair& pair);
    // Contacts with edges and sides of floors that another floor continues (contacts/flush_floors.cpp).
    bool has_border(const ContactPair& pair) const;
    void note_floor(const ContactPair& pair);
    [[nodiscard]] bool list_floors();
    void empty_hidden(const FloorPair& at, const FloorPair& on);
    [[nodiscard]] bool drop_hidden_contacts();

    template <typename F>
    void for_each_pair(F&& f) const
    {
        for (const ContactPair& pair : last_.pairs) f(pair, last_.of(pair));
        resting_.for_each(f);
    }

    PairList last_, fresh_;  // of the last step, of this one
    RestingPairs resting_;
    ActiveGeoms active_;
    Array<SlotPair> near_;
    int brought_ = 0;  // pairs of last_ from here on are not listed yet
    Array<GeomPair> found_;
    Array<PairRange> ranges_;
    Array<int> table_;
    Array<FloorPair> floors_;
    // In this step: one that is touched, 0: none; whether contacts may have to be dropped.
    std::atomic<std::uint64_t> floor_{0};
    std::atomic<bool> has_seams_{false};
    // While a state is written or read.
    Array<Listed> listed_;
    Array<Described> described_;
    Array<dContactEvent> ended_;   // of the last step
    Array<PointSpeeds> approach_;  // of the manifolds of this step, where events are wanted
    Real h_ = 0;
    bool unfinished_ = false;                                 // an update that nobody has accepted yet
    bool few_active_ = false;                                 // so it was in the last update
    std::uint64_t seen_disturbances_ = 0, disturbances_ = 0;  // of the space, by the last step and this one
    std::uint64_t seen_disturbance_ = 0, disturbance_ = 0;    // the newest of any geom, likewise
    bool any_unsupported_ = false;         // in the state that has been loaded since: geoms have kUnsupported
    std::atomic<bool> all_asleep_{false};  // no pair that the last update has found has an awake body
    bool settled_ = false;                 // so it was in the last step that was made
    std::uint64_t edition_ = 0;            // of the space, then
};

}  // namespace epode
