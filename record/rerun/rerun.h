// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Builds and steps the world of a captured program again, from the calls that its recording holds. With the
// recorded steppers and contacts this is the recorded run, bit by bit, where the library is the same. With
// another stepper bodies go elsewhere, and contacts of the recorded run would hold them where they were; they
// are then found again among the recorded geoms (found_contacts.h).
#pragma once

#include <ode/ode.h>

#include <functional>
#include <memory>
#include <string>

#include "record/rerun/found_contacts.h"
#include "record/watch/recorder.h"

namespace epode::record {

struct RerunOptions {
    std::string stepper;         // exact, quick, fast or hybrid; "": as recorded
    int iterations = -1;         // sweeps of quick, substeps of fast and hybrid; -1: as recorded
    bool find_contacts = false;  // among the recorded geoms, instead of the recorded ones
};

class Rerun {
  public:
    Rerun(const Recording& was, const RerunOptions& options);
    ~Rerun();
    Rerun(const Rerun&) = delete;
    Rerun& operator=(const Rerun&) = delete;

    // All steps, as long as `goes_on`, which is called with each, says so. False: problem() says why, and `now`
    // ends there.
    bool run(Recording& now, const std::function<bool(size_t)>& goes_on);
    const std::string& problem() const { return problem_; }

    // Handles of the numbers that arguments hold; null where there is none or it lives no more.
    dWorldID world() const { return world_; }
    dBodyID body(std::int32_t number) const;
    dJointID joint(std::int32_t number) const;
    dJointGroupID group(std::int32_t number);

  private:
    struct Group {
        dJointGroupID group;
        std::vector<std::int32_t> members;  // numbers of the joints made since it was empty
    };

    bool play(const CallBlock& block);
    bool call(const std::string& name, const std::vector<Argument>& arguments);
    bool make(const std::string& name, const std::vector<Argument>& arguments);
    bool destroy(const std::string& name, const std::vector<Argument>& arguments);
    bool step(const std::string& name, const std::vector<Argument>& arguments);
    bool take_samples(int count);  // of a body's velocities; false: they are too many
    int parts_of_exact_steps() const;
    void set_iterations();
    void make_contact(const std::vector<Argument>& arguments);
    void keep_joint(dJointID joint, std::int32_t group);
    void forget_joint(dJointID joint);
    void empty(std::int32_t group);
    void begin_recording(Recording& now);
    void take_new_bodies();
    void sample(Recording& now);
    bool refuse(const std::string& why);

    const Recording& was_;
    const RerunOptions options_;
    dWorldID world_;
    std::vector<std::string> names_;
    std::vector<dBodyID> bodies_;  // by the calls' numbers; null: gone
    std::vector<dJointID> joints_;
    std::vector<dJointID> new_joints_;  // not yet told to the recorder; no contacts
    std::vector<Group> groups_;
    std::vector<dBodyID> recorded_;             // by the recording's numbers
    size_t taken_ = 0;                          // bodies that have one, or died before
    std::vector<dSurfaceParameters> surfaces_;  // of the contacts made since the last step
    size_t step_ = 0;                           // the state that comes next
    std::int64_t sweeps_ = 0, samples_ = 0;     // asked for so far
    double time_ = 0, dt_ = 0, ms_ = 0;
    std::unique_ptr<Recorder> recorder_;
    std::unique_ptr<FoundContacts> found_;
    std::string problem_;
};

}  // namespace epode::record
