// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Boxes of 1 m fly straight in a cube that holds one in 8 m^3, 24 or 1,000 of them; the same boxes at rest;
// boxes, and rays of 8 m in ODE's way, that ask a space of 1,000; and two spaces of 500 that ask each other.
#include "bench/collision/space_table.h"

#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "bench/collision/pair_shapes.h"

namespace epode::bench {

namespace {

constexpr const char* kSpaces[] = {"simple", "hash", "sap", "quadtree"};
constexpr int kRounds = 7, kAsked = 200, kSteps = 20;

dSpaceID make_space(const std::string& kind, double extent)
{
    const dVector3 centre = {0, 0, 0, 0}, half = {dReal(extent), dReal(extent), dReal(extent), 0};
    if (kind == "simple") return dSimpleSpaceCreate(nullptr);
    if (kind == "hash") return dHashSpaceCreate(nullptr);
    if (kind == "sap") return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    return dQuadTreeSpaceCreate(nullptr, centre, half, 5);
}

struct Swarm {
    dSpaceID space;
    double extent;
    std::vector<dGeomID> geoms;
    std::vector<double> at, speed;
    PairDice dice{29};

    Swarm(const std::string& kind, int count) : extent(std::cbrt(8.0 * count) / 2)
    {
        space = make_space(kind, extent);
        for (int i = 0; i < count; ++i) geoms.push_back(dCreateBox(space, 1, 1, 1));
        for (int i = 0; i < 3 * count; ++i)
            at.push_back(dice.in(-extent, extent)), speed.push_back(dice.in(-5, 5));
        place();
    }
    Swarm(const Swarm&) = delete;
    Swarm& operator=(const Swarm&) = delete;
    ~Swarm() { dSpaceDestroy(space); }

    void place()
    {
        for (std::size_t i = 0; i < geoms.size(); ++i)
            dGeomSetPosition(geoms[i], dReal(at[3 * i]), dReal(at[3 * i + 1]), dReal(at[3 * i + 2]));
    }
    void move()
    {
        for (std::size_t k = 0; k < at.size(); ++k) {
            at[k] += speed[k] / 60;
            if (std::fabs(at[k]) > extent) speed[k] = std::copysign(speed[k], -at[k]);
        }
        place();
    }
};

void count_pair(void* count, dGeomID, dGeomID) { ++*static_cast<long*>(count); }

void count_hit(void* count, dGeomID a, dGeomID b)
{
    dContactGeom contact;
    *static_cast<long*>(count) += dCollide(a, b, 1, &contact, sizeof contact);
}

// The least time of rounds, each of which makes `times` queries from the same start.
template <typename Prepare, typename Ask>
void time_queries(const std::string& space, const char* name, int times, Prepare&& prepare, Ask&& ask)
{
    double least = 1e300;
    long count = 0;
    for (int round = 0; round < kRounds; ++round) {
        auto subject = prepare();
        count = 0;
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < times; ++i) ask(*subject, i, count);
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        least = std::min(least, time.count() / times);
    }
    fmt::print("{} {} {:.1f} {}\n", space, name, least, count);
}

// Geoms in many places, asked about one after the other.
struct Askers {
    Swarm swarm;
    std::vector<dGeomID> all;

    Askers(const std::string& kind, bool rays) : swarm(kind, 1000)
    {
        for (int i = 0; i < kAsked; ++i) {
            const auto there = [&] { return dReal(swarm.dice.in(-swarm.extent, swarm.extent)); };
            const dReal x = there(), y = there(), z = there();
            all.push_back(rays ? dCreateRay(nullptr, 8) : dCreateBox(nullptr, 2, 2, 2));
            const dReal u = there(), v = there(), w = there();
            rays ? dGeomRaySet(all.back(), x, y, z, u, v, w) : dGeomSetPosition(all.back(), x, y, z);
        }
        long pairs = 0;
        dSpaceCollide(swarm.space, &pairs, count_pair);
    }
    Askers(const Askers&) = delete;
    Askers& operator=(const Askers&) = delete;
    ~Askers()
    {
        for (dGeomID geom : all) dGeomDestroy(geom);
    }
};

void bench_moving(const std::string& space, const char* name, int geoms, bool moving)
{
    time_queries(
        space, name, kSteps,
        [&] {
            auto swarm = std::make_unique<Swarm>(space, geoms);
            long pairs = 0;
            dSpaceCollide(swarm->space, &pairs, count_pair);
            return swarm;
        },
        [moving](Swarm& swarm, int, long& count) {
            if (moving) swarm.move();
            dSpaceCollide(swarm.space, &count, count_pair);
        });
}

void bench_asking(const std::string& space, const char* name, bool rays)
{
    time_queries(
        space, name, kAsked, [&] { return std::make_unique<Askers>(space, rays); },
        [rays](Askers& askers, int i, long& count) {
            dSpaceCollide2(askers.all[std::size_t(i)], dGeomID(askers.swarm.space), &count,
                           rays ? count_hit : count_pair);
        });
}

struct TwoSwarms {
    Swarm one, two;
};

void bench_two_spaces(const std::string& space)
{
    time_queries(
        space, "space-and-space", 5,
        [&] {
            auto both = std::unique_ptr<TwoSwarms>(new TwoSwarms{{space, 500}, {space, 500}});
            for (double& x : both->two.at) x += 0.4;
            both->two.place();
            return both;
        },
        [](TwoSwarms& both, int, long& count) {
            dSpaceCollide2(dGeomID(both.one.space), dGeomID(both.two.space), &count, count_pair);
        });
}

}  // namespace

int bench_space_table()
{
    for (const std::string space : kSpaces) {
        bench_moving(space, "24-moving", 24, true);
        bench_moving(space, "1000-moving", 1000, true);
        bench_moving(space, "1000-at-rest", 1000, false);
        bench_asking(space, "box", false);
        bench_asking(space, "ray", true);
        bench_two_spaces(space);
    }
    return 0;
}

}  // namespace epode::bench
