// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What should be alive: a second book of all objects, kept with plain containers and the rules of the guide,
// next to the library's own. Lists have the order in which the library enumerates.
// Objects are never freed while the model lives, only marked dead: a pointer in the model cannot dangle.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "toolbox.h"

namespace epode::sequences {

struct Body;
struct Joint;
struct Geom;
struct Group;

// What all have: the handle, and the number that the written program knows them by.
template <typename Handle>
struct Object {
    using Id = Handle;
    Id id = nullptr;
    int number = 0;
    bool alive = true;
};

struct World : Object<dWorldID> {
    static constexpr const char* kLetter = "w";
    std::vector<Body*> bodies;
    std::vector<Joint*> joints;
    Geom* contacts = nullptr;  // the space of its contacts
    bool filtered = false;     // its contacts, at some time
    bool plain = true;         // bodies are tied by joints alone
};

struct Body : Object<dBodyID> {
    static constexpr const char* kLetter = "b";
    World* world = nullptr;
    std::vector<Joint*> joints;  // most recently attached last
    std::vector<Geom*> geoms;    // most recently attached last
    bool kinematic = false;
};

struct Joint : Object<dJointID> {
    static constexpr const char* kLetter = "j";
    World* world = nullptr;  // null: gone, and a group keeps the joint
    Group* group = nullptr;
    Body* body[2] = {};
    int kind = 0;  // index into kJointKinds; -1: a contact
    bool disabled = false;
};

struct Group : Object<dJointGroupID> {
    static constexpr const char* kLetter = "g";
    std::vector<Joint*> joints;
};

struct Field : Object<dHeightfieldDataID> {
    static constexpr const char* kLetter = "f";
};

struct Mesh : Object<dTriMeshDataID> {
    static constexpr const char* kLetter = "m";
    bool built = false;
};

// Spaces are geoms, here as in the library.
struct Geom : Object<dGeomID> {
    static constexpr const char* kLetter = "o";
    bool is_space = false, is_transform = false, placeable = true;
    int kind = 0;  // index into the player's list of shapes
    Geom* space = nullptr;
    Body* body = nullptr;
    std::vector<Geom*> members;  // of a space, in order of joining
    bool cleanup = true;         // of a space's members; of a transform's geom: `inner_cleanup`
    Geom* inner = nullptr;       // of a transform
    bool inner_cleanup = false;
    std::vector<Geom*> holders;  // transforms that hold this geom
};

template <typename T>
void forget(std::vector<T*>& list, const T* what)
{
    list.erase(std::remove(list.begin(), list.end(), what), list.end());
}

// All objects of one kind: the living in order of birth, and everyone who ever was.
template <typename T>
class Register {
  public:
    T& add(typename T::Id id)
    {
        all_.push_back(std::make_unique<T>());
        all_.back()->id = id;
        all_.back()->number = int(all_.size()) - 1;
        living_.push_back(all_.back().get());
        return *all_.back();
    }
    void bury(T& what)
    {
        what.alive = false;
        forget(living_, &what);
        dead_.push_back(&what);
    }
    const std::vector<T*>& living() const { return living_; }
    const std::vector<T*>& dead() const { return dead_; }
    int made() const { return int(all_.size()); }

  private:
    std::vector<std::unique_ptr<T>> all_;
    std::vector<T*> living_, dead_;
};

class Model {
  public:
    Register<World> worlds;
    Register<Body> bodies;
    Register<Joint> joints;
    Register<Group> groups;
    Register<Geom> geoms;
    Register<Field> fields;
    Register<Mesh> meshes;

    Body& born_body(dBodyID id, World& world);
    Joint& born_joint(dJointID id, World& world, Group* group, int kind);
    Geom& born_geom(dGeomID id, Geom* space);

    void attach(Joint& joint, Body* a, Body* b);
    void set_body(Geom& geom, Body* body);
    void join(Geom& geom, Geom& space);
    void leave(Geom& geom);  // its space
    void hold(Geom& transform, Geom* inner);

    void kill(World& world);
    void kill(Body& body);
    void kill(Joint& joint);
    void kill(Geom& geom);
    void kill(Group& group);
    void empty(Group& group);

    // Would `transform` come to hold itself?
    static bool holds(const Geom& geom, const Geom& transform);
    static bool inside(const Geom& geom, const Geom& space);

    // For the test of the tests: the model makes the mistake that a body's death leaves its joints attached.
    bool forgetful = false;

  private:
    void let_go(Body& body);
};

}  // namespace epode::sequences
