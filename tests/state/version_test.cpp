// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Files of worlds that earlier versions of the library have written, one of each version of the format and
// each precision, are read for ever: bodies are and move as they did, and the world goes on, as its clone does.
// (How it goes on is a matter of the solvers.) With EPODE_WRITE_WORLD=PATH in the environment the file of the
// present version is written there.
#include <array>
#include <bit>
#include <cstdlib>
#include <fstream>

#include "copy_scene.h"
#include "golden/golden.h"

namespace epode::states {
namespace {

constexpr const char* kVersions[] = {"version_1", "version_2", "version_4"};

std::uint64_t hash_of_motion(dWorldID world)
{
    std::vector<dBodyID> bodies(std::size_t(dWorldGetBodies(world, nullptr, 0)));
    dWorldGetBodies(world, bodies.data(), int(bodies.size()));
    std::vector<dReal> rows(13 * bodies.size());
    const unsigned fields = dStatePosition | dStateQuaternion | dStateLinearVel | dStateAngularVel;
    EXPECT_EQ(dBodiesGetStates(bodies.data(), int(bodies.size()), fields, rows.data(), 0), 1);
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const dReal number : rows) {
        const auto bytes = std::bit_cast<std::array<unsigned char, sizeof number>>(number);
        for (std::size_t i = 0; i < sizeof number; ++i)  // as they stand in a little-endian file
            hash = (hash ^ bytes[std::endian::native == std::endian::big ? sizeof number - 1 - i : i]) *
                   0x100000001b3u;
    }
    return hash;
}

TEST(WorldFileVersions, are_read_for_ever)
{
    const Messages messages;
    RichScene scene({.stepper = Stepper::kSubsteps, .piles = 1});
    scene.steps(20);
    if (const char* path = std::getenv("EPODE_WRITE_WORLD")) {
        ASSERT_EQ(dWorldSave(scene.world, scene.space, path), 1) << Messages::last();
    }
    for (const char* const version : kVersions) {
        const std::string name = version + std::string(sizeof(dReal) == 4 ? "_single" : "_double"),
                          path = std::string(EPODE_WORLDS) + '/' + name + ".epw";
        dSpaceID space = nullptr;
        const dWorldID world = dWorldLoad(path.c_str(), &space);
        ASSERT_TRUE(world) << Messages::last();
        const Copy copy(scene, world, space, true);
        const std::uint64_t read = hash_of_motion(world);
        EXPECT_TRUE(golden::is_golden("frozen/" + name, read));
        dSpaceID space_of_clone = space;
        const dWorldID clone = dWorldClone(world, &space_of_clone, nullptr, 0);
        ASSERT_TRUE(clone) << Messages::last();
        const Copy other(scene, clone, space_of_clone, false);
        for (int i = 0; i < 40; ++i) copy.running.step(), other.running.step();
        EXPECT_EQ(difference(state_of(clone), state_of(world)), "");
        EXPECT_NE(hash_of_motion(world), read);
    }
}

}  // namespace
}  // namespace epode::states
