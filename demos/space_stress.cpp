// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two hundred solids rain into a pile. Four kinds of spaces hold likenesses of them, and each must tell in
// every tenth step exactly the pairs whose bounding boxes meet, no more, no fewer.
#include <set>
#include <utility>

#include "stage.h"

constexpr int kCount = 200;
static dGeomID solids[kCount], likeness[4][kCount];
static dSpaceID spaces[4];
static const char* const kNames[4] = {"simple", "hash", "sweep and prune", "quadtree"};
static long wrong[4] = {0, 0, 0, 0}, met = 0;
using Pairs = std::set<std::pair<long, long>>;

static double between(double low, double high) { return low + (high - low) * dRandReal(); }

static void build()
{
    dRandSetSeed(7);
    const dVector3 centre = {0, 0, 0}, half = {20, 20, 20};
    spaces[0] = dSimpleSpaceCreate(nullptr);
    spaces[1] = dHashSpaceCreate(nullptr);
    spaces[2] = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    spaces[3] = dQuadTreeSpaceCreate(nullptr, centre, half, 5);
    for (int i = 0; i < kCount; ++i) {
        const double x = between(-1, 1), y = between(-1, 1), z = 1 + 0.06 * i, size = between(0.1, 0.3);
        solids[i] = i % 3 == 0   ? demo::box(x, y, z, size, between(0.1, 0.3), between(0.1, 0.3))
                    : i % 3 == 1 ? demo::sphere(x, y, z, 0.5 * size)
                                 : demo::capsule(x, y, z, 0.4 * size, size);
        for (int k = 0; k < 4; ++k) {
            likeness[k][i] = dCreateBox(spaces[k], 1, 1, 1);
            dGeomSetData(likeness[k][i], reinterpret_cast<void*>(long(i)));
        }
    }
}

static void note(void* pairs, dGeomID a, dGeomID b)
{
    const long i = reinterpret_cast<long>(dGeomGetData(a)), j = reinterpret_cast<long>(dGeomGetData(b));
    static_cast<Pairs*>(pairs)->insert({i < j ? i : j, i < j ? j : i});
}

static bool meet(const dReal* a, const dReal* b)
{
    return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3] && a[4] <= b[5] && b[4] <= a[5];
}

static void compare(double t)
{
    if (int(t / demo::kStep + 0.5) % 10) return;
    static dReal around[kCount][6];
    Pairs truth;
    for (int i = 0; i < kCount; ++i) {
        dGeomGetAABB(solids[i], around[i]);
        for (int j = 0; j < i; ++j) {
            if (meet(around[i], around[j])) truth.insert({j, i});
        }
        for (auto& space : likeness) {
            const dReal* b = around[i];
            dGeomBoxSetLengths(space[i], b[1] - b[0], b[3] - b[2], b[5] - b[4]);
            dGeomSetPosition(space[i], (b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2);
        }
    }
    met += long(truth.size());
    for (int k = 0; k < 4; ++k) {
        Pairs reported;
        dSpaceCollide(spaces[k], &reported, note);
        wrong[k] += reported != truth;
    }
}

static void judge()
{
    for (int k = 0; k < 4; ++k)
        demo::claim(wrong[k] == 0, "%s: other pairs in %ld of the steps", kNames[k], wrong[k]);
    demo::claim(met > 5000, "only %ld pairs met", met);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{3, -3, 2}, {135, -20, 0}, 4, build, judge, compare});
}
