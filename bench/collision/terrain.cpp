// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The terrain of scene S7 (bench/collision/ground.h): 256 x 256 cells, 131,072 triangles, or a height field of the same
// heights. Solids of about half a metre lie on it in random poses, sunk in by up to 5 cm, and for each
// dCollide is asked for eight contacts. Printed per class: the least time per pair over the rounds, how many
// pairs touch, and the mean number of contacts of these.
#include "bench/collision/terrain.h"

#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <vector>

#include "bench/collision/ground.h"
#include "scenes/extensions.h"

namespace epode::bench {

namespace {

class Dice {
  public:
    double in(double lo, double hi)
    {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        return lo + (hi - lo) * double(state_ >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_ = 12345;
};

dGeomID make(const char* name, Dice& dice)
{
    const double s = dice.in(0.2, 0.4);
    switch (name[0]) {
        case 's':
            return dCreateSphere(nullptr, dReal(s));
        case 'b':
            return dCreateBox(nullptr, dReal(2 * s), dReal(1.5 * s), dReal(s));
        default:
            return name[1] == 'a' ? dCreateCapsule(nullptr, dReal(0.6 * s), dReal(1.5 * s))
                                  : dCreateCylinder(nullptr, dReal(0.8 * s), dReal(1.5 * s));
    }
}

// On the ground by its box, then a little in.
void put(dGeomID solid, Dice& dice, double half)
{
    dQuaternion q;
    do {
        for (dReal& v : q) v = dReal(dice.in(-1, 1));
    } while (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] < dReal(0.1));
    const dReal norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (dReal& v : q) v /= norm;
    dGeomSetQuaternion(solid, q);
    const double x = dice.in(-half, half), y = dice.in(-half, half);
    dGeomSetPosition(solid, dReal(x), dReal(y), 0);
    dReal box[6];
    dGeomGetAABB(solid, box);
    dGeomSetPosition(solid, dReal(x), dReal(y), dReal(ground_height(x, y) - box[4] - dice.in(0, 0.05)));
}

void bench_class(const char* name, dGeomID terrain, const TerrainOptions& options)
{
    Dice dice;
    std::vector<dGeomID> all;
    for (int k = 0; k < options.solids; ++k) {
        all.push_back(make(name, dice));
        put(all.back(), dice, 0.45 * kGroundCell * options.cells);
    }
    double least = 1e300;
    int touching = 0, contacts = 0;
    for (int round = 0; round < options.rounds; ++round) {
        touching = contacts = 0;
        const auto start = std::chrono::steady_clock::now();
        for (const dGeomID g : all) {
            dContactGeom found[8];
            const int n = dCollide(g, terrain, 8, found, sizeof(dContactGeom));
            touching += n > 0 ? 1 : 0, contacts += n;
        }
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        least = std::min(least, time.count() / options.solids);
    }
    fmt::print("{:<9} {:>8.0f} ns   touching {:>5}   contacts {:.2f}\n", name, least, touching,
               touching ? double(contacts) / touching : 0.0);
    for (const dGeomID g : all) dGeomDestroy(g);
}

template <typename Ground>
void bench_ground(const TerrainOptions& options)
{
    const Ground ground(options.cells);
    for (const char* name : {"sphere", "box", "capsule", "cylinder"})
        if (options.only.empty() || options.only == name) bench_class(name, ground.geom(), options);
}

}  // namespace

int bench_terrain(const TerrainOptions& options)
{
    fmt::print("library {}\n", scenes::loaded_library());
    options.field ? bench_ground<FieldGround>(options) : bench_ground<MeshGround>(options);
    return 0;
}

}  // namespace epode::bench
