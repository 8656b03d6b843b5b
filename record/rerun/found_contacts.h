// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts found again among the geoms of a recording, which does not hold the program's collision callback.
// What it does hold is which pairs it made contacts for and with which surface; so
//     a geom that was never in a contact is in none;
//     a pair that was seen gets its own surface, any other the one that its first geom, else its second, had
//     last; bodies that a joint connects do not meet unless they were seen to; a pair has at most as many
//     contacts as any pair had.
#pragma once

#include <ode/ode.h>

#include <map>
#include <memory>
#include <vector>

#include "record/file/recording.h"

namespace epode::record {

class FoundContacts {
  public:
    FoundContacts(const Recording& was, dWorldID world);
    ~FoundContacts();
    FoundContacts(const FoundContacts&) = delete;
    FoundContacts& operator=(const FoundContacts&) = delete;

    // The surfaces of the contacts of one recorded state, in its order.
    void learn(const Step& step, const std::vector<dSurfaceParameters>& surfaces);
    // Joints for the step that leads to this state; bodies by the recording's numbers.
    void make(size_t state, const std::vector<dBodyID>& bodies);
    // After the step: what they were.
    std::vector<Contact> take();

  private:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;
    static Pair pair_of(std::uint32_t a, std::uint32_t b) { return a < b ? Pair{a, b} : Pair{b, a}; }
    static void near(void* self, dGeomID a, dGeomID b);
    dGeomID create(const Shape& shape);
    dGeomID create_surface(const Shape& shape);
    void place(std::uint32_t number, std::int32_t body, const Pose& pose, const std::vector<dBodyID>& bodies);
    void bring_up_to_date(size_t state, const std::vector<dBodyID>& bodies);
    const dSurfaceParameters* surface_of(std::uint32_t a, std::uint32_t b) const;
    void collide(dGeomID a, dGeomID b);

    const Recording& was_;
    dWorldID world_;
    dSpaceID space_;
    dJointGroupID group_;
    size_t next_geom_ = 0, next_move_ = 0;
    int max_contacts_ = 1;
    std::vector<dGeomID> geoms_;  // by number; null: has no form, or does not live
    std::map<dGeomID, std::uint32_t> numbers_;
    std::map<Pair, dSurfaceParameters> pairs_;
    std::map<std::uint32_t, dSurfaceParameters> last_;
    std::vector<Contact> made_;
    std::vector<dTriMeshDataID> meshes_;
    // What meshes point into.
    struct Triangles {
        std::vector<double> vertices;
        std::vector<dTriIndex> corners;
    };
    std::vector<std::unique_ptr<Triangles>> triangles_;
};

}  // namespace epode::record
