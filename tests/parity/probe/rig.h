// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One world with one or two bodies and a joint between them: the test bench of the step_* cases.
//
// A trial: bodies in random poses with random full inertia tensors; the joint attached and given its
// geometry in that pose; then the bodies moved a little (so that every error term is non-zero), given
// velocities and forces; the joint's getters read; one dWorldStep; everything read again. The movement stays
// below 0.7 rad and 0.7 length units, so stops at +-[0.8,1.2] force the state of a limit whatever sign
// convention the joint uses.
#pragma once

#include "case_list.h"

#include <functional>
#include <string>
#include <vector>

namespace parity {

enum class Attach { kAB, kBA, kA0, kOA };

const char* attach_name(Attach attach);
std::vector<Attach> all_attachments();
std::vector<Attach> two_body_attachments();

class Rig {
  public:
    Rig(Random& random, Attach attach);
    ~Rig();
    Rig(const Rig&) = delete;
    Rig& operator=(const Rig&) = delete;

    dWorldID world() const { return world_; }
    dBodyID a() const { return a_; }
    dBodyID b() const { return b_; }
    double step_size() const { return step_size_; }

    void attach(dJointID joint) const;
    void disturb(Random& random, double distance, double angle);
    void push(Random& random, double speed);
    void put_bodies(Output& out, const std::string& when) const;

  private:
    void disturb_body(dBodyID body, Random& random, double distance, double angle);

    dWorldID world_;
    dBodyID a_;
    dBodyID b_;
    Attach attach_;
    double step_size_;
};

// A random symmetric positive definite inertia: R diag(I) R' with diag(I) of a solid box.
void set_random_mass(dBodyID body, Random& random);
void set_random_pose(dBodyID body, Random& random, double half_side);

struct JointVariant {
    std::string name;
    std::function<void(dJointID, Random&)> set;
};

struct JointBench {
    std::function<dJointID(const Rig&, Random&)> create;
    std::function<void(Output&, const std::string& when, dJointID)> put_getters;
    std::vector<JointVariant> variants;
    std::vector<Attach> attachments = all_attachments();
    int poses = 20;
    double distance = 0.1;  // of the disturbance after the joint's geometry is set
    double angle = 0.5;
    // Where a random disturbance would meet an intended difference: further motion after it, before the
    // variant.
    std::function<void(const Rig&, dJointID, Random&)> settle = nullptr;
    bool readings_only = false;  // no step
};

void run_bench(Output& out, Random& random, const JointBench& bench);

// ---- motion for `settle` ----
void shift(dBodyID body, const Vec3& by);
void turn(dBodyID body, const Vec3& axis, double angle);           // about its centre
void turn_around(dBodyID body, const Vec3& point, const Quat& q);  // about a point of the world
// No spin, no torque, and too much inertia to get any: what lever arms do does not show.
void stiffen(const Rig& rig);

// Records shared by getters.
using Get3 = void (*)(dJointID, dVector3);
void put_vector(Output& out, const std::string& key, dJointID joint, Get3 get);

}  // namespace parity
