// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Files of worlds that earlier versions of the library have written, one of each version of the format and
// each precision, are read for ever, and go on with the bits that they had. With EPODE_WRITE_WORLD=PATH in
// the environment the file of the present version is written there.
#include <cstdlib>
#include <fstream>

#include "checksum.h"
#include "copy_scene.h"

namespace epode::states {
namespace {

struct Version {
    const char* file;
    std::uint64_t after;  // checksum of what the bodies do 40 steps later
};

#ifdef dIDEDOUBLE
constexpr Version kVersions[] = {{"version_1_double.epw", 16219834461081234855u}};
#else
constexpr Version kVersions[] = {{"version_1_single.epw", 9384463220980488835u}};
#endif

std::uint64_t checksum_of_motion(dWorldID world)
{
    std::vector<dBodyID> bodies(std::size_t(dWorldGetBodies(world, nullptr, 0)));
    dWorldGetBodies(world, bodies.data(), int(bodies.size()));
    std::vector<dReal> rows(13 * bodies.size());
    const unsigned fields = dStatePosition | dStateQuaternion | dStateLinearVel | dStateAngularVel;
    EXPECT_EQ(dBodiesGetStates(bodies.data(), int(bodies.size()), fields, rows.data(), 0), 1);
    return checksum(reinterpret_cast<const unsigned char*>(rows.data()), rows.size() * sizeof(dReal));
}

TEST(WorldFileVersions, are_read_for_ever_and_go_on_with_the_same_bits)
{
    const Messages messages;
    RichScene scene({.stepper = Stepper::kSmallSteps, .piles = 1});
    scene.steps(20);
    if (const char* path = std::getenv("EPODE_WRITE_WORLD")) {
        ASSERT_EQ(dWorldSave(scene.world, scene.space, path), 1) << Messages::last();
    }
    for (const Version& version : kVersions) {
        const std::string path = std::string(EPODE_WORLDS) + '/' + version.file;
        dSpaceID space = nullptr;
        const dWorldID world = dWorldLoad(path.c_str(), &space);
        ASSERT_TRUE(world) << Messages::last();
        const Copy copy(scene, world, space, true);
        for (int i = 0; i < 40; ++i) copy.running.step();
        EXPECT_EQ(checksum_of_motion(world), version.after) << version.file;
    }
}

}  // namespace
}  // namespace epode::states
