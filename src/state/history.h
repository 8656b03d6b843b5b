// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The last states of a world, inside it: a ring of frames, one after each step. A frame is a state without
// contact joints (state/world_state.h) and the topology at that time (state/topology.h), which frames share as
// long as no structure changes. What the program destroys meanwhile is parked until no frame has it.
#pragma once

#include "state/arrange.h"
#include "state/world_state.h"

namespace epode {

class History {
  public:
    History(World& world, WorldState& state) : world_(world), state_(state) {}
    History(const History&) = delete;
    History& operator=(const History&) = delete;
    ~History() { clear(); }

    static int worlds();  // that have one

    // So many steps can be taken back, from now on; 0: none. False: out of memory, and there is no history.
    [[nodiscard]] bool set_frames(int frames);
    int frames() const { return frames_; }
    bool has_frames() const { return count_ > 0; }
    // How many steps can be taken back now.
    int available() const { return count_ > 0 ? count_ - 1 : 0; }
    std::size_t bytes() const;

    // A step has been made. Without memory for its frame the history is empty afterwards, with a message.
    void step_made();
    // Null: done; else why not, with nothing changed.
    const char* roll_back(int frames);

    // The program destroys it. False: it is not kept, or there is no memory; then it must be destroyed.
    bool keep(Body& body);
    bool keep(Joint& joint, dJointGroupID group);
    bool keep(Geom& geom);

  private:
    struct Frame {
        StateBytes state;
        Topology* topology;
    };

    Frame& frame(std::uint64_t number) { return ring_[int(number % std::uint64_t(ring_.size()))]; }
    [[nodiscard]] bool capture();
    [[nodiscard]] bool take_topology(Frame& to);
    [[nodiscard]] bool remember_present(const Topology& target);
    void let_go(Frame& frame);
    void forget();  // all frames
    void clear();   // and their memory

    World& world_;
    WorldState& state_;
    int frames_ = 0;
    Array<Frame> ring_;         // frames_ + 1
    StateBytes present_;        // what a refused roll-back gives back
    std::uint64_t newest_ = 0;  // number of the last frame
    int count_ = 0;             // of frames
    Topology* spare_ = nullptr;
    Parking parking_;
    char text_[200] = {};
};

}  // namespace epode
