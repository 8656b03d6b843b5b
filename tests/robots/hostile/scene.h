// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What hostile calls of robots' functions are made on: models of every reader's kind, one of them with errors, two robots of each
// sound one in a world that steps, and of each kind of handle a destroyed one. What a call has destroyed is made again.
#pragma once

#include <epode/batch.h>
#include <epode/robot_sensors.h>
#include <ode/ext.h>

#include <string>
#include <vector>

namespace hostile {

struct Scene {
    explicit Scene(const std::string& folder);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    // Makes again what is gone, or everything.
    void mend();
    void rebuild();
    // What must not change when a call is refused; and whether all bodies are finite.
    std::size_t hash() const;
    bool is_finite() const;
    void step();
    // As no program should: destroys a body, a joint, or the world and the space of robots that live on.
    void vandalise(unsigned how);
    bool is_vandalised = false;

    dWorldID world = nullptr, other_world = nullptr, dead_world = nullptr;
    dSpaceID space = nullptr, dead_space = nullptr;
    std::vector<dRobotModelID> models;
    std::vector<dRobotID> robots;
    dRobotModelID dead_model = nullptr, faulty_model = nullptr;
    dRobotID dead_robot = nullptr;
    static constexpr int kCopies = 5;
    std::vector<dBatchID> batches;  // of floats, of doubles
    dBatchID dead_batch = nullptr;
    mutable std::vector<double> bound;  // what batches may be bound to
    std::vector<std::string> paths;
    std::string text;  // of the first file

  private:
    void build();
    void tear_down();
    dRobotModelID load(std::size_t number) const;
    void mend_batches();
};

// What the library has said since the last clear().
struct Messages {
    std::vector<std::string> ours, odes;  // of the robots' functions; refusals of libode
    void clear() { ours.clear(), odes.clear(); }
};
Messages& messages();

}  // namespace hostile
