// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// robots_hostile [--calls N] [--seed S]: calls of the robots' functions with hostile values, evenly over all. The rules are those of
// tests/hostile: a null, wrong or destroyed handle, a null pointer, NaN or a number out of its range is refused wherever it does not
// mean something; a refused call gives a message that names the function, answers 0, writes and changes nothing; an accepted one
// leaves no NaN, makes libode refuse nothing, and the world steps on. Every thousandth call a body, a joint or the world of living
// robots is destroyed: from then to the next scene only crashes and NaN are faults.
// robots_hostile --list: the functions that it calls.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include "values.h"

using namespace hostile;

namespace {

constexpr long kStepEvery = 61, kVandalEvery = 1009, kRebuildAfter = 61;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
bool has(const char* text, const char* part) { return std::strstr(text, part) != nullptr; }
bool is_output(Role role)
{
    return role == Role::kOutput || role == Role::kOutputOrNone || role == Role::kRangeOutput ||
           role == Role::kFewOutput;
}

// What is written to its outputs are reals.
bool writes_reals(const char* name)
{
    for (const char* part :
         {"Report", "GetLinks", "GetJoints", "GetActuators", "GetSensors", "TakePicture", "Init", "CastRays"})
        if (has(name, part)) return false;
    return true;
}

class Runner {
  public:
    Runner(const std::string& folder, std::uint64_t seed) : scene_(folder), values_(scene_, seed) {}
    ~Runner()
    {
        for (const char* ending : {"urdf", "xml", "mjcf"})
            std::remove((std::string("hostile_saved.") + ending).c_str());
    }
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;

    void run(long calls)
    {
        for (long i = 0; i < calls; ++i) {
            const RobotFunction& f = robot_functions()[std::size_t(i) % robot_functions().size()];
            call(f);
            if (i % kStepEvery == 0) step(f);
            if (i % kVandalEvery == 0) scene_.vandalise(unsigned(values_.random() >> 8)), broken_since_ = i;
            if (scene_.is_vandalised && i - broken_since_ > kRebuildAfter) scene_.rebuild();
        }
    }

    bool report() const
    {
        for (const auto& [what, f] : faults_)
            std::printf("FAULT %s\n      %ld times, first: %s\n", what.c_str(), f.count, f.example.c_str());
        std::printf("%ld calls of %zu functions: %ld refused, %ld accepted; %zu faults\n",
                    refused_ + accepted_, robot_functions().size(), refused_, accepted_, faults_.size());
        return faults_.empty();
    }

  private:
    struct Fault {
        std::string example;
        long count = 0;
    };

    void fault(const RobotFunction& f, const std::string& rule)
    {
        if (scene_.is_vandalised && !has(rule, "NaN")) return;
        Fault& its = faults_[std::string(f.name) + ": " + rule];
        if (its.count++ > 0) return;
        for (std::size_t i = 0; i < f.roles.size(); ++i)
            its.example += (i ? ", " : "(") + std::string(arguments_[i].text);
        its.example += ')';
    }

    void call(const RobotFunction& f)
    {
        values_.choose(f, arguments_, 6);
        const int bad = values_.must_refuse(f, arguments_);
        const std::size_t before = bad >= 0 ? scene_.hash() : 0;
        messages().clear();
        const Result result = f.call(arguments_);
        ++(bad >= 0 ? refused_ : accepted_);
        bad >= 0 ? judge_refused(f, result, bad, before) : judge_accepted(f, result);
        messages().clear();
        // What is made is destroyed again, and what is destroyed made again.
        if (result.pointer && has(f.name, "ModelLoad"))
            dRobotModelDestroy(static_cast<dRobotModelID>(const_cast<void*>(result.pointer)));
        if (result.pointer && has(f.name, "dRobotCreate"))
            dRobotDestroy(static_cast<dRobotID>(const_cast<void*>(result.pointer)));
        if (result.pointer && has(f.name, "dBatchCreate"))
            dBatchDestroy(static_cast<dBatchID>(const_cast<void*>(result.pointer)));
        if (has(f.name, "ConvexDecomposition"))
            for (int i = 0; i < int(result.integer); ++i)
                dGeomDestroy(static_cast<dGeomID*>(arguments_[6].pointer)[i]);
        if (has(f.name, "Destroy") && !scene_.is_vandalised) scene_.mend();
    }

    void judge_refused(const RobotFunction& f, const Result& result, int bad, std::size_t before)
    {
        const std::string about = " (argument " + std::to_string(bad + 1) + ")";
        if (result.integer != 0 || result.pointer) fault(f, "accepts what it must refuse" + about);
        bool is_named = false;
        for (const std::string& message : messages().ours)
            is_named = is_named || has(message, std::string(f.name) + ": ");
        if (!is_named) fault(f, "refuses without a message that names it" + about);
        for (std::size_t i = 0; i < f.roles.size(); ++i)
            if (is_output(f.roles[i]) && !values_.is_untouched(int(i)))
                fault(f, "refused, but writes" + about);
        if (scene_.hash() != before) fault(f, "refused, but the state has changed" + about);
    }

    void judge_accepted(const RobotFunction& f, const Result& result)
    {
        (void)result;
        for (const std::string& message : messages().odes)
            fault(f, "lets libode refuse: " + message.substr(0, 60));
        if (!writes_reals(f.name)) return;
        for (std::size_t i = 0; i < f.roles.size(); ++i) {
            const bool written = is_output(f.roles[i]) || f.roles[i] == Role::kPositionInOut;
            if (written && !values_.is_number(int(i))) fault(f, "writes NaN");
        }
    }

    void step(const RobotFunction& f)
    {
        scene_.step();
        if (scene_.is_vandalised) return messages().clear();
        if (!scene_.is_finite()) fault(f, "leaves NaN in bodies"), scene_.rebuild();
        messages().clear();
    }

    Scene scene_;
    Values values_;
    Value arguments_[kMaxArguments];
    std::map<std::string, Fault> faults_;
    long refused_ = 0, accepted_ = 0, broken_since_ = 0;
};

}  // namespace

int main(int argc, char** argv)
{
    long calls = 20000;
    std::uint64_t seed = 1;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--list")) {
            for (const RobotFunction& f : robot_functions()) std::printf("%s called\n", f.name);
            return 0;
        }
        if (!std::strcmp(argv[i], "--calls") && i + 1 < argc) calls = std::atol(argv[++i]);
        if (!std::strcmp(argv[i], "--seed") && i + 1 < argc) seed = std::strtoull(argv[++i], nullptr, 10);
    }
    Runner runner(EPODE_MODELS, seed);
    runner.run(calls);
    return runner.report() ? 0 : 1;
}
