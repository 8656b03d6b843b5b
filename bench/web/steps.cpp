// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Three scenes on one thread, with public functions alone, so that one text runs natively and as WebAssembly:
// bench/web/run compares the two. Prints for each the mean time of a step in microseconds and a hash of the
// last poses, which must be the same.
#include <ode/ext.h>
#include <ode/ode.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

struct Scene {
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    std::vector<dBodyID> bodies;

    Scene()
    {
        dWorldSetGravity(world, 0, 0, -9.81);
        dWorldSetStepThreads(world, 1);
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene()
    {
        dWorldDestroy(world);
        dSpaceDestroy(space);
    }

    dBodyID add(dReal x, dReal y, dReal z, dReal a, dReal b, dReal c)
    {
        const dBodyID body = dBodyCreate(world);
        dMass mass;
        dMassSetBox(&mass, 500, a, b, c);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, x, y, z);
        bodies.push_back(body);
        return body;
    }

    std::uint64_t hash() const
    {
        std::uint64_t all = 0xcbf29ce484222325u;
        for (const dBodyID body : bodies) {
            unsigned char bytes[3 * sizeof(dReal)];
            std::memcpy(bytes, dBodyGetPosition(body), sizeof bytes);
            for (unsigned char byte : bytes) all = (all ^ byte) * 0x100000001b3u;
        }
        return all;
    }
};

void build_pile(Scene& s)
{
    dWorldSetContactSpace(s.world, s.space);
    dCreatePlane(s.space, 0, 0, 1, 0);
    for (int i = 0; i < 1000; ++i) {
        const dBodyID body = s.add(0.62 * (i % 10) + 0.03125 * (i % 7), 0.62 * (i / 10 % 10),
                                   0.4 + 0.6 * (i / 100), 0.5, 0.5, 0.5);
        dGeomSetBody(dCreateBox(s.space, 0.5, 0.5, 0.5), body);
    }
}

void build_chain(Scene& s)
{
    dBodyID last = nullptr;
    for (int i = 0; i < 400; ++i) {
        const dBodyID body = s.add(0.1 * i + 0.05, 0, 0, 0.1, 0.02, 0.02);
        const dJointID joint = dJointCreateBall(s.world, nullptr);
        dJointAttach(joint, body, last);
        dJointSetBallAnchor(joint, 0.1 * i, 0, 0);
        last = body;
    }
}

int quick(dWorldID world) { return dWorldQuickStep(world, 0.01); }
int exact(dWorldID world) { return dWorldStep(world, 0.01); }
int game(dWorldID world) { return dWorldStepHybrid(world, 0.01); }

void measure(const char* name, void (*build)(Scene&), int (*step)(dWorldID), int before, int count)
{
    Scene scene;
    build(scene);
    for (int i = 0; i < before; ++i) step(scene.world);
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < count; ++i) step(scene.world);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
    std::printf("%s %.1f %016llx\n", name, time.count() / count, (unsigned long long)scene.hash());
}

}  // namespace

int main()
{
    dInitODE2(0);
    measure("pile_quick", build_pile, quick, 150, 150);
    measure("pile_hybrid", build_pile, game, 150, 150);
    measure("chain_exact", build_chain, exact, 200, 400);
    dCloseODE();
}
