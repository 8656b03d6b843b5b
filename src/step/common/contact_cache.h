// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// ODE's contacts are new joints in every step; this cache finds last step's impulses for them. Contacts come
// as manifolds. A manifold is known by its two bodies, looked up once; a point by its place in the first
// body's frame: among the old points of the pair whose normal is similar, the nearest within kReach of the
// lever arm is taken, each at most once. Contacts come in nearly the same order in every step, so the pair
// behind the last one that was found is looked into first, and the table only where nothing is there or the
// pair is one of several of its bodies. The friction impulse is kept as a world vector and projected on the
// new tangents. Bodies, not geoms, are the key: clients need not fill dContactGeom::g1 and g2.
#pragma once

#include "base/array.h"
#include "base/streams/state_stream.h"
#include "dynamics/body_table.h"
#include "math/float3.h"
#include "rows/joint_manifold.h"

namespace epode {

class ContactCache {
  public:
    // A step begins in which contacts have tickets below `tickets`, not all of which need be used, and come
    // from `writers` who may work at the same time, each for other bodies. False: out of memory. What the
    // step may need is reserved now: end() cannot fail.
    [[nodiscard]] bool begin(int tickets, int writers);
    // Notes a manifold under the tickets ticket, ticket + 1 ... of its points, and writes `share` of what is
    // remembered of them into the points, as it is in a step of size h. The tickets of one writer follow each
    // other.
    void load(int writer, int ticket, const Body& body1, const Body* body2, const JointManifold& manifold,
              std::span<JointManifoldPoint> points, Real share, Real h);
    // The writer begins again: what it has loaded it may load once more.
    void begin_again(int writer);
    // The answer for a manifold that has been loaded under these tickets; without one it is zero. Its impulses,
    // `times` as large, are those of the whole step.
    void remember(int ticket, const JointManifold& manifold, std::span<const JointManifoldPoint> points,
                  Real times);
    // The step is over: what it noted is what the next one loads from.
    // `h`: its length.
    void end(Real h);
    // There was no step: the next one finds what this one has found.
    void take_back();

    // In states of the world (contact_cache_state.cpp): what the next step finds. What is loaded lies apart
    // until it is accepted, which cannot fail.
    class Loaded;
    void save(const BodyTable& bodies, StateStream& stream) const;
    [[nodiscard]] static bool load(const BodyTable& bodies, StateStream& stream,
                                   Loaded& out);  // false: no memory
    void accept(Loaded& loaded);
    // What is broken between two steps, in words; null: nothing.
    const char* fault() const;

  private:
    // In floats: seven digits are plenty for a start value.
    struct Pair {
        std::uint64_t serial1, serial2;  // of the bodies
        Float3 normal;                   // world
        int first, count;                // of the points
        int next;                        // pair in the same bucket, -1 at the end
        unsigned step;                   // that noted it: what lies beyond a run is older
        bool twin;                       // another pair has the same bodies
    };
    struct Point {
        Float3 place;     // lever arm from body 1, in its frame
        Float3 friction;  // world impulse
        float normal_impulse;
        std::uint8_t used;  // by so many attempts of its writer
    };
    // What one writer has noted.
    struct Run {
        int first, count;  // of the pairs
        int guess;         // the old pair behind the one in which the last point was found, or -1
        std::uint8_t attempt;
    };
    struct Store {
        Array<Pair> pairs;  // under the ticket of the first point, where a run says so
        Array<Point> points;
        Array<Run> runs;
        unsigned step = 0;
        Real h = 0;  // s, that the impulses have acted; 0: as long as the coming step
        void swap(Store& other);
    };
    static_assert(sizeof(Point) == 32);
    struct Found {
        Point* point;
        int pair;
        Real distance2;
    };
    // What is looked for: a point at `place` between two bodies.
    struct Wanted {
        std::uint64_t serial1, serial2;
        Vec3 place, normal;
    };
    struct Places;
    // Lever arms of the points of one manifold, in the frame of body 1, and the square of the distance within
    // which an old point is accepted as the same.
    struct ManifoldArms {
        Real x[kManifoldPoints], y[kManifoldPoints], z[kManifoldPoints], within2[kManifoldPoints];
        Vec3 place(int i) const { return {x[i], y[i], z[i]}; }
    };
    static ManifoldArms arms_of(const Body& body1, std::span<const JointManifoldPoint> points);
    void note(Run& run, const Wanted& wanted, int ticket, int points);
    bool is_guess(int guess, const Wanted& wanted) const;
    bool fits(const Pair& pair, const Wanted& wanted) const;
    Places places_of(const Pair& pair, std::uint8_t attempt) const;
    void note_points(int ticket, int count, const ManifoldArms& arms);
    void look_into(int pair, const Wanted& wanted, std::uint8_t attempt, Found& best);
    Found find(const Wanted& wanted, Real within2, std::uint8_t attempt);
    [[nodiscard]] bool begin_runs(int writers);
    static int buckets_for(int pairs);
    void fill_buckets();

    Store old_, fresh_;
    unsigned steps_ = 0;  // those that were taken back, too
    Array<int> buckets_;  // power of two many, index of the first pair or -1
};

class ContactCache::Loaded {
    friend class ContactCache;
    Store store;
    Array<int> buckets;
};

}  // namespace epode
