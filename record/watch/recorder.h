// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Watches a world through the public interface and tells a sink what happens in it. Whoever records says
// which things there are and when one goes; the recorder asks them for the rest, after each step.
#pragma once

#include <ode/ode.h>

#include <map>

#include "record/file/recording.h"

namespace epode::record {

// What the recorder cannot ask the library for.
struct StepFigures {
    double time = 0, dt = 0;
    double kinetic = 0, potential = 0, joint_error = 0;
    double ms = 0;
};

struct ContactSeen {
    dGeomID geom[2];
    double pos[3], normal[3], depth;
    double force[3];
};

class Recorder {
  public:
    explicit Recorder(Sink& sink) : sink_(sink) {}

    // Bodies before the geoms and joints that are on them.
    void add(dBodyID body);
    void add(dGeomID geom);
    void add(dJointID joint);
    // Before the thing is destroyed, or just after: it is not asked any more.
    void remove(dBodyID body);
    void remove(dGeomID geom);
    void remove(dJointID joint);

    // The state now: first of all the initial one, then one after each step.
    void step(const StepFigures& figures, const std::vector<ContactSeen>& contacts, bool with_forces);

    const std::vector<dBodyID>& bodies() const { return bodies_.living; }
    const std::vector<dJointID>& joints() const { return joints_.living; }

  private:
    template <class Id>
    struct Numbers {
        std::map<Id, std::uint32_t> number;
        std::vector<Id> living;  // in order of number
        std::uint32_t next = 0;
        void add(Id id);
        bool remove(Id id, std::uint32_t& was);
    };
    // Where a geom was when last asked, in the library's own numbers: the cheapest thing to compare.
    struct Place {
        dBodyID body = nullptr;
        dReal pos[3] = {0, 0, 0}, rot[12] = {};
        bool operator==(const Place&) const = default;
    };
    static Place place_of(dGeomID geom);
    std::int32_t number_of(dBodyID body) const;
    std::uint32_t number_of(dGeomID geom) const;
    std::uint32_t shape_number(dGeomID geom);
    void send_moves();
    void send_joint(dJointID joint);

    Sink& sink_;
    Numbers<dBodyID> bodies_;
    Numbers<dGeomID> geoms_;
    Numbers<dJointID> joints_;
    std::map<dGeomID, Place> places_;
    std::map<dJointID, std::array<dBodyID, 2>> attached_;
    std::map<std::pair<std::uint32_t, std::array<double, 4>>, std::uint32_t> simple_shapes_;
    std::map<dTriMeshDataID, std::uint32_t> mesh_shapes_;
    std::uint32_t next_shape_ = 0;
    Step step_;
};

BodyState state_of(dBodyID body);

}  // namespace epode::record
