// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a world is made of, as bytes: all that its state (state/world_state.h) does not contain and a copy of
// it needs. Objects are named by numbers, in order of creation; spaces come before their members. Steps
// depend on the orders of lists, so these are kept: of joints and geoms of each body (the most recent first)
// and of members of spaces.
//   world       its settings
//   bodies      mass, rules of damping and sleep
//   joints      type, what the type adds (JointType::structure), switches
//   couplings   their members
//   links       joints of each body
//   geoms       class, space, filter bits, material, what the class adds (GeomType::structure)
//   on bodies   geoms of each body, with offsets
//   contacts    the contact space
//   fluids      settings, planes, volumes
//   vehicles    their bodies, settings and wheels
// The geoms are those of one outermost space, of the bodies wherever they are, and what transforms hold.
// A joint or geom type is not named here: it describes itself in its own file.
#pragma once

#include "collide/shape_stream.h"
#include "dynamics/coupling.h"
#include "dynamics/world.h"

namespace epode {

class WorldStructure {
  public:
    // `space`: the outermost one of the geoms; null: none.
    WorldStructure(World& world, Space* space, ShapeStream& stream)
        : world_(&world), space_(space), stream_(stream)
    {}
    // Loads.
    explicit WorldStructure(ShapeStream& stream) : stream_(stream) {}
    WorldStructure(const WorldStructure&) = delete;
    WorldStructure& operator=(const WorldStructure&) = delete;

    // Finds what there is to save. False after a failure of the stream.
    bool gather();
    void save() { visit(); }
    // A new world, or null after a failure, with nothing left of it.
    World* load();
    // Destroys what has been loaded, shared objects included.
    void discard();

    World* const& world() const { return world_; }
    Space* space() const { return space_; }
    std::span<Body* const> bodies() const { return bodies_.span(); }   // the oldest first
    std::span<Joint* const> joints() const { return joints_.span(); }  // the oldest first
    std::span<Geom* const> geoms() const { return stream_.geoms(); }   // spaces before their members

  private:
    void visit();
    void visit_bodies();
    bool load_body();
    void visit_joints();
    Joint* load_joint(int number);
    void visit_switches(Joint& joint);
    void visit_couplings();
    void visit_member(CouplingJoint& coupling, CoupledAxis& member);
    void visit_name(Joint*& joint);
    void visit_links();
    void save_links(const Body& body);
    void load_links(Body& body, int count);
    int number_of(const Joint& joint) const { return numbers_[joint.place]; }

    bool gather_geoms();
    bool gather_space(Space& space);
    bool gather_geom(Geom& geom);
    void visit_geoms();
    void save_geom(Geom& geom);
    bool load_geom();
    bool put_into(Geom& parent, Geom& geom);
    void visit_geoms_of_bodies();
    void visit_geom_of_body(Body& body, Geom* geom);
    void visit_contacts();
    void visit_fluids();
    void visit_vehicles();
    void discard_geoms();

    World* world_ = nullptr;
    Space* space_ = nullptr;
    ShapeStream& stream_;
    Array<Body*> bodies_;
    Array<Joint*> joints_;
    Array<int> numbers_;  // of joints that are saved, by place in the world's roster
};

}  // namespace epode
