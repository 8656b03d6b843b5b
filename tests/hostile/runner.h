// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Makes hostile calls and judges them. The rules (docs/errors.md):
//   a null, wrong or destroyed handle, a null pointer and NaN are refused wherever they do not mean
//   something; a refused call gives one message that names the function, answers 0, writes nothing, changes
//   nothing and keeps no memory; an accepted one leaves no NaN, and the world can be stepped and collided
//   afterwards.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "phases.h"
#include "state.h"
#include "values.h"

namespace hostile {

struct Tally {
    long calls = 0, accepted = 0, refused = 0, rebuilt = 0, exercised = 0;
    std::set<const Function*> called;
};

// What a call has broken inside the library, in words; null: nothing. Where the program is linked with the
// library alone there is no such function (invariants.cpp).
[[gnu::weak]] const char* hostile_broken_invariant(const Scene& scene);

class Runner {
  public:
    explicit Runner(std::uint64_t seed);
    ~Runner();

    // About `budget` calls of one function: everything if that is not more, else each value alone (the
    // various reasons for a refusal first), pairs of values, and then any combination, the other arguments
    // being sensible.
    void run(const Function& function, long budget);

    // Random calls of a random function.
    void run_any(long budget);

    // The same from inside a function of the program that the library calls.
    void run_inside(const Function& function, const Phase& phase, long budget);

    // A part of the budget, rounded up or down by chance.
    long share(long budget, int parts) { return (budget + below(parts)) / parts; }

    const Tally& tally() const { return tally_; }
    void report() const;
    bool clean() const { return faults_.empty(); }

  private:
    using Choice = std::vector<int>;
    struct Fault {
        std::string example;
        long count = 0;
    };

    bool find_base(const Function& f, Choice& base);
    bool all_combinations(const Function& f, long budget);
    void one_of_each(const Function& f, const Choice& base);
    void singles(const Function& f, const Choice& base, long budget);
    void pairs(const Function& f, const Choice& base, long budget);
    void random_ones(const Function& f, const Choice& base, long budget);
    bool perform(const Function& f, const Choice& choice);  // true: accepted
    // The same with other values of some parameters; a value below 0 is none.
    void perform_with(const Function& f, Choice choice, std::initializer_list<std::pair<int, int>> changes);
    void call_and_judge(const Function& f, const Choice& choice);
    void judge_refused(const Function& f, const Result& r, long blocks);
    void judge_accepted(const Function& f, const Result& r);
    void set_scene_for(const Function& f);
    void rebuild();
    void go_on(const Function& f);
    void fault(const Function& f, const std::string& rule);
    std::string described(const Function& f) const;
    const char* must_refuse(const Function& f) const;
    std::uint64_t random();
    int below(int n) { return int(random() % std::uint64_t(n)); }

    Scene scene_;
    Values values_;
    State state_;
    std::uint64_t hash_ = 0, seed_;
    Tally tally_;
    std::map<std::string, Fault> faults_;
    Value arguments_[kMostParameters];
    Result result_;
    bool accepted_ = false, changed_ = false, called_ = false, reset_ = false;
    const Phase* phase_ = nullptr;  // null: at the top
};

}  // namespace hostile
