// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/steppers/hybrid_budget.h"

#include <algorithm>
#include <cmath>

#include "step/steppers/hybrid.h"

namespace epode {
namespace {

constexpr double kLeastBudget = 500;    // microseconds
constexpr double kForNewcomers = 0.75;  // of the budget
constexpr double kForBeginners = 8;     // times the budget

struct Candidate {
    int island;
    bool begins, was_exact, sweeps_do, in_tree;
    double work;
    double spared;  // what exact joints would add to its substeps
};

bool precedes(const Candidate& a, const Candidate& b)
{
    if (a.begins != b.begins) return a.begins;
    if (a.was_exact != b.was_exact) return a.was_exact;
    return a.work != b.work ? a.work < b.work : a.island < b.island;
}

// Of one kind of islands: parts that are taken, and what is left to be shared.
class Budget {
  public:
    explicit Budget(double whole, double taken = 0) : whole_(whole), taken_(taken) {}

    // Gives back what is spared. False: it does not fit into so much of the whole.
    bool take(double part, double spared, double share)
    {
        if (part > spared && !(taken_ + part - spared <= share * whole_)) return false;
        taken_ += part - spared, ++parts_;
        return true;
    }
    // What each part may be longer.
    double spare() const
    {
        return parts_ > 0 && whole_ < HUGE_VAL ? std::max(0.0, whole_ - taken_) / parts_ : 0;
    }

  private:
    const double whole_;
    double taken_;
    int parts_ = 0;
};

}  // namespace

bool choose_hybrid_methods(const StepContext& context, std::span<const Island> islands, Arena& arena,
                           std::span<IslandMethod> methods)
{
    const World& world = context.world;
    Arena::Scope scope(arena);
    const auto candidates = arena.take<Candidate>(int(islands.size()));
    if (arena.failed()) return false;
    std::size_t count = 0;
    double substeps = 0, network = 0;
    for (std::size_t i = 0; i < islands.size(); ++i) {
        const HybridChoice choice = choose(world, islands[i], context.h);
        const Stepper& stepper = stepper_for_strain(*choice.stepper, islands[i]);
        methods[i] = {&stepper, hybrid_iterations(world, stepper)};
        substeps += choice.substeps_work, network += choice.network_work;
        if (choice.wants_exact)
            candidates[count++] = {int(i),
                                   choice.begins,
                                   choice.was_exact,
                                   choice.sweeps_do,
                                   choice.in_tree,
                                   choice.max_work,
                                   choice.begins ? 0 : choice.network_work};
    }
    const auto list = candidates.first(count);
    std::sort(list.begin(), list.end(), precedes);
    const double times = double(world.hybrid_budget), whole = times * std::max(substeps, kLeastBudget);
    Budget budget(whole, network), for_beginners(kForBeginners * whole), for_figures(times * kLeastBudget);
    const auto budget_of = [&](const Candidate& candidate) -> Budget& {
        return candidate.begins ? for_beginners : candidate.sweeps_do ? for_figures : budget;
    };
    std::size_t taken = 0;
    for (const Candidate& candidate : list) {
        const double share = candidate.was_exact || candidate.begins ? 1 : kForNewcomers;
        if (budget_of(candidate).take(candidate.work, candidate.spared, share)) list[taken++] = candidate;
    }
    for (const Candidate& candidate : list.first(taken)) {
        const double part = candidate.work + (candidate.in_tree ? 0 : budget_of(candidate).spare());
        IslandMethod& method = methods[std::size_t(candidate.island)];
        method = {&kExact, hybrid_iterations(world, kExact), method.stepper, method.iterations, part};
    }
    return true;
}

}  // namespace epode
