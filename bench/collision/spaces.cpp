// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The rays: boxes of 1 m in a grid of 1.4 m, turned at random; rays run between random points of the box
// about them, and each wants its first hit. ODE's way is a ray geom against the space, dCollide in the
// callback, and the least depth kept. The moving boxes fly straight in a cube that holds one in 50 m^3, back
// from its walls.
#include "bench/collision/spaces.h"

#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <ode/ext.h>
#include <ode/ode.h>

namespace epode::bench {

namespace {

class Numbers {
  public:
    double in(double low, double high)
    {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return low + (high - low) * double(state_ >> 11) / 9007199254740992.0;
    }

  private:
    std::uint64_t state_ = 4711;
};

template <typename Work>
double seconds(Work&& work)
{
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

dSpaceID make_space(const std::string& kind, double extent)
{
    if (kind == "sap") return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    if (kind == "hash") return dHashSpaceCreate(nullptr);
    const dVector3 centre = {0, 0, 0, 0}, half = {dReal(extent), dReal(extent), dReal(extent), 0};
    return dQuadTreeSpaceCreate(nullptr, centre, half, 6);
}

struct RaySet {
    std::vector<dReal> origins, directions, lengths;
    int count = 0;
};

RaySet make_rays(int count, double extent)
{
    Numbers random;
    RaySet set;
    set.count = count;
    for (int i = 0; i < count; ++i) {
        double from[3], along[3], length2 = 0;
        for (int k = 0; k < 3; ++k) {
            from[k] = random.in(-extent, extent);
            along[k] = random.in(-extent, extent) - from[k];
            length2 += along[k] * along[k];
        }
        for (int k = 0; k < 3; ++k) {
            set.origins.push_back(dReal(from[k]));
            set.directions.push_back(dReal(along[k] / std::sqrt(length2)));
        }
        set.lengths.push_back(dReal(std::sqrt(length2)));
    }
    return set;
}

struct Nearest {
    dGeomID ray;
    dReal depth;
};

void keep_nearest(void* data, dGeomID a, dGeomID b)
{
    Nearest& nearest = *static_cast<Nearest*>(data);
    dContactGeom contact;
    if (dCollide(nearest.ray, a == nearest.ray ? b : a, 1, &contact, sizeof contact) > 0 &&
        contact.depth < nearest.depth)
        nearest.depth = contact.depth;
}

struct RayResult {
    double old_way = 0, closest = 0, batch = 0;  // rays a second
    int hits = 0;
    double sum = 0;
};

void cast_the_old_way(dSpaceID space, const RaySet& set, RayResult& out)
{
    const dGeomID ray = dCreateRay(nullptr, 1);
    const double time = seconds([&] {
        for (int i = 0; i < set.count; ++i) {
            const dReal *o = &set.origins[std::size_t(3 * i)], *d = &set.directions[std::size_t(3 * i)];
            dGeomRaySetLength(ray, set.lengths[std::size_t(i)]);
            dGeomRaySet(ray, o[0], o[1], o[2], d[0], d[1], d[2]);
            Nearest nearest{ray, dInfinity};
            dSpaceCollide2(ray, dGeomID(space), &nearest, keep_nearest);
            if (nearest.depth < dInfinity) ++out.hits, out.sum += double(nearest.depth);
        }
    });
    out.old_way = set.count / time;
    dGeomDestroy(ray);
}

void cast_our_way(dSpaceID space, const RaySet& set, RayResult& out)
{
    const auto closest =
        reinterpret_cast<decltype(&dSpaceRayClosest)>(dlsym(RTLD_DEFAULT, "dSpaceRayClosest"));
    const auto batch = reinterpret_cast<decltype(&dSpaceRayBatch)>(dlsym(RTLD_DEFAULT, "dSpaceRayBatch"));
    if (!closest || !batch) return;
    const int rounds = 20;
    std::vector<dQueryHit> hits(std::size_t(set.count));
    for (int round = 0; round < rounds; ++round) {
        const double one = seconds([&] {
            for (std::size_t i = 0; i < hits.size(); ++i)
                closest(space, &set.origins[3 * i], &set.directions[3 * i], set.lengths[i], nullptr,
                        &hits[i]);
        });
        const double many = seconds([&] {
            batch(space, set.count, set.origins.data(), set.directions.data(), set.lengths.data(), nullptr,
                  hits.data(), 1);
        });
        out.closest = std::max(out.closest, set.count / one);
        out.batch = std::max(out.batch, set.count / many);
    }
}

RayResult rays_against_boxes(const SpaceOptions& options)
{
    const int side = int(std::ceil(std::cbrt(double(options.boxes))));
    const double spacing = 1.4, extent = spacing * side / 2;
    const dSpaceID space = make_space(options.space, extent);
    Numbers random;
    for (int i = 0; i < options.boxes; ++i) {
        const dGeomID box = dCreateBox(space, 1, 1, 1);
        const int at[3] = {i % side, i / side % side, i / side / side};
        dGeomSetPosition(box, dReal(spacing * (at[0] + 0.5) - extent),
                         dReal(spacing * (at[1] + 0.5) - extent), dReal(spacing * (at[2] + 0.5) - extent));
        dMatrix3 turned;
        dRFromEulerAngles(turned, dReal(random.in(0, 6)), dReal(random.in(0, 6)), dReal(random.in(0, 6)));
        dGeomSetRotation(box, turned);
    }
    const RaySet set = make_rays(options.rays, extent);
    RayResult result;
    cast_the_old_way(space, set, result);
    cast_our_way(space, set, result);
    dSpaceDestroy(space);
    return result;
}

struct Moving {
    dGeomID geom;
    double at[3], speed[3];
};

void count_pair(void* count, dGeomID, dGeomID) { ++*static_cast<long*>(count); }

double move_and_collide(const SpaceOptions& options, long& pairs)
{
    const double extent = std::cbrt(50.0 * options.moving) / 2, dt = 1.0 / 60;
    const dSpaceID space = make_space(options.space, extent);
    Numbers random;
    std::vector<Moving> all(std::size_t(options.moving));
    for (Moving& m : all) {
        m.geom = dCreateBox(space, 1, 1, 1);
        for (int k = 0; k < 3; ++k) m.at[k] = random.in(-extent, extent), m.speed[k] = random.in(-5, 5);
    }
    const auto step = [&] {
        for (Moving& m : all) {
            for (int k = 0; k < 3; ++k) {
                m.at[k] += dt * m.speed[k];
                if (std::fabs(m.at[k]) > extent)
                    m.speed[k] = m.at[k] > 0 ? -std::fabs(m.speed[k]) : std::fabs(m.speed[k]);
            }
            dGeomSetPosition(m.geom, dReal(m.at[0]), dReal(m.at[1]), dReal(m.at[2]));
        }
        pairs = 0;
        dSpaceCollide(space, &pairs, count_pair);
    };
    for (int i = 0; i < 5; ++i) step();
    const double time = seconds([&] {
        for (int i = 0; i < options.steps; ++i) step();
    });
    dSpaceDestroy(space);
    return 1e3 * time / options.steps;
}

}  // namespace

int bench_spaces(const SpaceOptions& options)
{
    const RayResult rays = rays_against_boxes(options);
    long pairs = 0;
    const double ms = move_and_collide(options, pairs);
    std::printf("%.0f %.0f %.0f %d %.9g %.3f %ld\n", rays.old_way, rays.closest, rays.batch, rays.hits,
                rays.sum, ms, pairs);
    return 0;
}

}  // namespace epode::bench
