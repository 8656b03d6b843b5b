// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pairs of the members in poses that both libraries see alike (bench/collision/pair_poses.h). One pass over all poses
// is timed, the quickest of some rounds counts, and the sets alternate between solids, so that no branch is
// learnt from one pose.
#include "bench/collision/pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <sstream>

#include "bench/collision/pair_poses.h"

namespace epode::bench {

namespace {

constexpr int kContacts = 8;

int contacts_of(dGeomID a, dGeomID b)
{
    dContactGeom found[kContacts];
    return dCollide(a, b, kContacts, found, sizeof(dContactGeom));
}

struct Result {
    double ns = 1e300;
    int hits = 0, contacts = 0;
};

Result measure(const std::string& first, const std::string& second, Poses poses, const PairOptions& options)
{
    PosedPairs pairs(first, second);
    pairs.add(poses, options.poses);
    Result result;
    for (int round = 0; round < options.rounds; ++round) {
        result.hits = result.contacts = 0;
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const int n = contacts_of(pairs.first(i), pairs.second(i));
            result.hits += n > 0 ? 1 : 0, result.contacts += n;
        }
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        result.ns = std::min(result.ns, time.count() / options.poses);
    }
    return result;
}

auto place_of(const std::string& name)
{
    return std::find(std::begin(kPairShapes), std::end(kPairShapes), name);
}

bool is_pair_shape(const std::string& name)
{
    if (place_of(name) != std::end(kPairShapes)) return true;
    fmt::print(stderr, "epode_bench: no member of a pair is called {}\n", name);
    return false;
}

// Neither a plane, nor a ground, nor a ray meets its like.
bool can_meet(const std::string& first, const std::string& second)
{
    const PairShape a(first), b(second);
    return !a.is_fixed() && !b.is_ray();
}

using Calls = std::vector<std::pair<dGeomID, dGeomID>>;

double seconds_of(const Calls& calls)
{
    const auto start = std::chrono::steady_clock::now();
    for (const auto& [a, b] : calls) contacts_of(a, b);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The least time of all passes over the calls that fit into a time; three at least.
double nanoseconds_a_call(const Calls& calls)
{
    constexpr double kBudget = 0.02;
    double least = 1e300, spent = 0;
    for (int pass = 0; pass < 3 || spent < kBudget; ++pass) {
        const double time = seconds_of(calls);
        least = std::min(least, time), spent += time;
    }
    return 1e9 * least / double(calls.size());
}

void answer(const std::string& first, const std::string& second, const std::string& selected, int poses)
{
    std::string a = first, b = second;
    bool turned = place_of(a) > place_of(b);  // either order has the same poses
    if (turned) std::swap(a, b);
    turned ^= put_in_order(a, b);
    PosedPairs pairs(a, b);
    for (const Poses set : kAllPoses) pairs.add(set, poses);
    Calls calls;
    std::string counts;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const std::pair call =
            turned ? std::pair(pairs.second(i), pairs.first(i)) : std::pair(pairs.first(i), pairs.second(i));
        if (selected.empty())
            counts += std::to_string(contacts_of(call.first, call.second));
        else if (selected[i] == '1')
            calls.push_back(call);
    }
    selected.empty() ? fmt::print("{} {} {}\n", first, second, counts)
                     : fmt::print("{} {} {:.2f}\n", first, second, nanoseconds_a_call(calls));
    std::fflush(stdout);
}

}  // namespace

int bench_pairs(const PairOptions& options)
{
    for (const std::string& asked : {options.first, options.second})
        if (!asked.empty() && !is_pair_shape(asked)) return 2;
    for (auto i = std::begin(kPairShapes); i != std::end(kPairShapes); ++i)
        for (auto j = i; j != std::end(kPairShapes); ++j) {
            std::string first = *i, second = *j;
            const auto is = [&](const std::string& name) {
                return name.empty() || first == name || second == name;
            };
            const bool twice = options.first == options.second && !options.first.empty();
            if (!is(options.first) || !is(options.second) || (twice && first != second)) continue;
            put_in_order(first, second);
            if (!can_meet(first, second)) continue;
            for (const Poses poses : kAllPoses) {
                if (!options.set.empty() && options.set != name_of(poses)) continue;
                const Result r = measure(first, second, poses, options);
                fmt::print("{} {} {} {:.1f} {:.3f} {:.3f}\n", first, second, name_of(poses), r.ns,
                           double(r.hits) / options.poses, r.hits ? double(r.contacts) / r.hits : 0.0);
            }
        }
    return 0;
}

int bench_listed_pairs(int poses)
{
    std::string line;
    while (std::getline(std::cin, line)) {
        std::istringstream words(line);
        std::string first, second, selected;
        words >> first >> second >> selected;
        if (!is_pair_shape(first) || !is_pair_shape(second)) return 2;
        if (!selected.empty() && selected.size() != std::size(kAllPoses) * std::size_t(poses)) return 2;
        answer(first, second, selected, poses);
    }
    return 0;
}

}  // namespace epode::bench
