// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a state does not contain and a roll-back must bring back: which bodies, joints and geoms there were, in
// which order, and what was attached to what. Steps depend on all these orders:
//   bodies, joints      of the world
//   links               joints of each body, the most recently attached first
//   geoms               of each body, the newest first, with their offsets
//   members             of every space in which one of these geoms is, or that has the world's contacts
// Also the masses of bodies and, in the joints' own bytes, anchors and axes. Fluids, and which bodies are vehicles, are
// recorded since they cannot come back. Objects are named by address, handle and serial number, which together recognise
// what has been destroyed.
#pragma once

#include <cstddef>
#include <span>

#include "base/array.h"
#include "collide/geom.h"
#include "dynamics/forces/vehicle.h"
#include "dynamics/world.h"

namespace epode {

// The tag of an object that is destroyed for the program, and may come back (state/history.h).
inline constexpr Tag kParked = Tag(0x0de0001a);

// Named so that it can be recognised when it may have been destroyed.
template <typename O>
struct Named {
    O* object = nullptr;
    typename HandleOf<O>::Id id = nullptr;
    std::uint64_t serial = 0;  // of joints: 0

    Named() = default;
    explicit Named(O& o) : object(&o), id(to_handle(&o))
    {
        if constexpr (requires { o.serial; }) serial = o.serial;
    }
    bool is(Tag tag) const
    {
        if (object->tag != tag || to_handle(object) != id) return false;
        if constexpr (requires { object->serial; }) return object->serial == serial;
        return true;
    }
    bool lives() const { return is(HandleOf<O>::kTag); }
    bool is_parked() const { return is(kParked); }
};

struct Topology {
    struct Range {
        int first = 0, count = 0;
    };
    struct BodyRecord {
        Named<Body> body;
        dMass mass;
        std::uint64_t mass_hash;
        Range links, geoms;
        int wheels;  // of a vehicle; below 0: it is none
    };
    struct JointRecord {
        Named<Joint> joint;
        Body* body[2];  // of its nodes
        bool reverse, driven;
        unsigned attachments;
        int first_byte;  // of its own part
    };
    struct GeomRecord {
        Named<Geom> geom;
        std::uint64_t shape;
        int number;  // of its class: when it may be told the geom may be gone
        bool on_body, has_offset;
        std::uint8_t watched;
        std::uint64_t disturbed;
        GeomOffset offset;  // of a geom without a body: where it is
    };
    struct SpaceRecord {
        Named<Geom> space;
        Range members;
    };

    // The world as it is; contact joints too if `contacts` is set. False: out of memory.
    [[nodiscard]] bool record(const World& world, bool contacts);
    // Also other spaces in which geoms of `other` are now, to which they must return if what leads there is taken back.
    [[nodiscard]] bool record_spaces_of(const Topology& other);
    std::size_t bytes() const;

    std::span<const GeomRecord> of(Range range) const
    {
        return geoms.span().subspan(std::size_t(range.first), std::size_t(range.count));
    }
    std::span<JointNode* const> links_of(const BodyRecord& r) const
    {
        return links.span().subspan(std::size_t(r.links.first), std::size_t(r.links.count));
    }

    Array<BodyRecord> bodies;   // the oldest first
    Array<JointRecord> joints;  // the oldest first
    Array<JointNode*> links;
    Array<std::byte> own_bytes;  // of joints
    Array<GeomRecord> geoms;     // of bodies, then of spaces, then of other spaces
    Array<SpaceRecord> spaces;
    std::uint64_t edition = 0;  // of the structure
    std::uint64_t geoms_made = 0;
    int own_geoms = 0;  // without those of other spaces
    int fluids = 0;
    int users = 0;  // frames

  private:
    [[nodiscard]] bool record_body(Body& body, bool contacts);
    [[nodiscard]] bool record_joint(Joint& joint);
    [[nodiscard]] bool record_geom(Geom& geom);
    [[nodiscard]] bool record_space(Space* space);
};

inline int wheels_of(const Body& body) { return body.vehicle ? body.vehicle->wheel_count : -1; }

// The part of a joint that only its type knows: anchors, axes, settings. It begins behind the last member of
// LastingJoint, whose padding compilers give to the type.
inline std::span<std::byte> own_part(Joint& joint)
{
    auto* const begin = reinterpret_cast<std::byte*>(&static_cast<LastingJoint&>(joint).attachments + 1);
    return {begin, reinterpret_cast<std::byte*>(&joint) + joint.type->size};
}

}  // namespace epode
