// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a recording holds: things (shapes, bodies, geoms, joints), numbered in the order in which they were
// made and never renumbered, and steps. A step has one state for each body that lives, in order of number.
// Everything is in SI units, quaternions are (w, x, y, z), poses are of the world unless a comment says
// otherwise. Sink is how things travel: a recorder or a reader tells them in the order in which they
// happened, a file writer or a Recording in memory listens. The alternative, building a Recording first and
// writing it at the end, would lose everything when the recorded program dies.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "record/file/calls.h"

namespace epode::record {

using Vec3 = std::array<double, 3>;
using Quat = std::array<double, 4>;

struct Pose {
    Vec3 pos{0, 0, 0};
    Quat turn{1, 0, 0, 0};
    bool operator==(const Pose&) const = default;
};

// What this build computes in, as recordings call it.
constexpr const char* kPrecision = sizeof(dReal) == 8 ? "double" : "single";

// How the recording came about: "scene", "stepper", "dt", "seed", "iterations", "library", "precision" ...
using Info = std::map<std::string, std::string>;
// Of a file with several, the later ones add to the first, which is where a run's settings are.
inline void add(const Info& more, Info& to)
{
    for (const auto& [key, value] : more) to[key] = value;
}
// With the number from 1 on: causes of failure, from likely to less likely ones.
constexpr const char* kDiagnosisKey = "diagnosis ";

enum class ShapeKind : std::uint32_t {
    kUnknown,      // a class that this recorder does not know; it has no looks
    kSphere,       // radius
    kBox,          // full sides x, y, z
    kCapsule,      // radius, length between the caps' centres, along z
    kCylinder,     // radius, length, along z
    kPlane,        // normal x, y, z and distance: n.x = d
    kRay,          // length, along z
    kConvex,       // surface
    kMesh,         // surface
    kHeightField,  // surface
    kLast = kHeightField
};

struct Shape {
    ShapeKind kind = ShapeKind::kUnknown;
    std::array<double, 4> size{0, 0, 0, 0};
    // Of the last three kinds, in the geom's frame: triangles counter-clockwise from outside.
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool operator==(const Shape&) const = default;
};

struct Body {
    double mass = 0;
    bool kinematic = false;
};

constexpr std::int32_t kNobody = -1;
constexpr std::uint32_t kNoGeom = UINT32_MAX;

struct Geom {
    std::uint32_t shape = 0;
    std::int32_t body = kNobody;
    Pose pose;  // in the body's frame, or of the world where there is no body
};

struct Joint {
    std::uint32_t type = 0;  // the value of ODE's dJointType
    std::array<std::int32_t, 2> body{kNobody, kNobody};
    std::array<std::uint8_t, 2> has_anchor{0, 0};  // [i]: fixed to body i, in its frame
    std::array<Vec3, 2> anchor{};
    std::array<std::uint8_t, 2> has_axis{0, 0};  // axis 1 in body 1's frame, axis 2 in body 2's
    std::array<Vec3, 2> axis{};
};

enum class ObjectKind : std::uint32_t { kBody, kGeom, kJoint, kLast = kJoint };

struct BodyState {
    Pose pose;
    Vec3 linear{0, 0, 0}, angular{0, 0, 0};
    bool operator==(const BodyState&) const = default;
};

// 32-bit floats: contacts are to be looked at, the exact state is that of the bodies.
struct Contact {
    std::uint32_t geom[2] = {kNoGeom, kNoGeom};
    float pos[3] = {0, 0, 0};
    float normal[3] = {0, 0, 0};  // into geom[0]
    float depth = 0;
    float force[3] = {0, 0, 0};  // on the body of geom[0], where the step knows forces
};

// What holds one freedom of a joint between two stops; radians or metres.
struct Stop {
    std::uint32_t joint = 0;
    bool turns = true;      // about the axis, else along it
    std::uint8_t axis = 0;  // of Joint::axis
    double low = 0, high = 0;
    bool operator==(const Stop&) const = default;
};

struct Limit {
    Stop stop;
    double value = 0;  // where the freedom is now
};

struct Step {
    double time = 0, dt = 0;
    double kinetic = 0, potential = 0;
    double joint_error = 0;  // worst distance by which a joint's anchors part, m
    double ms = 0;           // wall-clock time of the step
    std::uint64_t hash = 0;  // of the bodies' states, hash.h
    bool has_forces = false;
    std::vector<BodyState> bodies;  // of those that live
    std::vector<std::uint8_t> asleep;
    std::vector<Contact> contacts;
    std::vector<Limit> limits;
};

class Sink {
  public:
    virtual ~Sink() = default;
    virtual void info(const Info& info) = 0;
    virtual void shape(const Shape& shape) = 0;
    virtual void body(const Body& body) = 0;
    virtual void geom(const Geom& geom) = 0;
    virtual void joint(const Joint& joint) = 0;
    virtual void gone(ObjectKind kind, std::uint32_t number) = 0;
    // A geom was put elsewhere: by hand, or onto another body.
    virtual void moved(std::uint32_t geom, std::int32_t body, const Pose& pose) = 0;
    // The calls that lead to the next step's state; of programs only.
    virtual void calls(const CallBlock& block) = 0;
    virtual void step(const Step& step) = 0;
};

// Lives in steps [born, died).
struct Life {
    std::uint32_t born = 0;
    std::uint32_t died = UINT32_MAX;
    bool at(size_t step) const { return born <= step && step < died; }
};

struct CallsMade {
    std::uint32_t step;
    CallBlock block;
};

struct Move {
    std::uint32_t step, geom;
    std::int32_t body;
    Pose pose;
};

class Recording : public Sink {
  public:
    Info about;
    std::vector<Shape> shapes;
    std::vector<Body> bodies;
    std::vector<Geom> geoms;  // as they were made; `moves` has what became of them
    std::vector<Joint> joints;
    std::vector<Life> body_lives, geom_lives, joint_lives;
    std::vector<Move> moves;
    std::vector<CallsMade> calls_made;
    std::vector<Step> steps;

    // The numbers of the bodies that live in a step: what Step::bodies[i] belongs to.
    std::vector<std::uint32_t> living(size_t step) const;
    // "" where there is none of that name.
    std::string about_value(const std::string& key) const;

    void info(const Info& info) override { add(info, about); }
    void shape(const Shape& shape) override { shapes.push_back(shape); }
    void body(const Body& body) override;
    void geom(const Geom& geom) override;
    void joint(const Joint& joint) override;
    void gone(ObjectKind kind, std::uint32_t number) override;
    void moved(std::uint32_t geom, std::int32_t body, const Pose& pose) override;
    void calls(const CallBlock& block) override
    {
        calls_made.push_back({std::uint32_t(steps.size()), block});
    }
    void step(const Step& step) override { steps.push_back(step); }
};

const char* name_of(ShapeKind kind);

}  // namespace epode::record
