// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A reader of robots on any text, in the folder of the tests' models, so that meshes and includes are found. What it
// accepts keeps the promises of model.h, and one in eight is written in both formats and read again.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "limit.h"
#include "robots/load.h"
#include "robots/tendon.h"
#include "robots/write/write.h"

using namespace epode::robots;

namespace {

#define CHECK(good)                               \
    do {                                          \
        if (good) break;                          \
        std::fprintf(stderr, "not: %s\n", #good); \
        std::abort();                             \
    } while (false)

void check_links(const RobotModel& model)
{
    for (size_t i = 0; i < model.links.size(); ++i) {
        const Link& link = model.links[i];
        CHECK(i == 0 ? link.parent == -1 : link.parent >= 0 && link.parent < int(i));
        CHECK(is_finite(link.centre) && is_finite(link.inertia) && std::isfinite(link.mass));
        for (int joint : link.joints) CHECK(joint >= 0 && joint < int(model.joints.size()));
        for (const Shape& shape : link.shapes) CHECK(shape.mesh < int(model.meshes.size()));
    }
}

void check_indices(const RobotModel& model)
{
    const int links = int(model.links.size()), joints = int(model.joints.size());
    for (const Joint& joint : model.joints) CHECK(joint.link > 0 && joint.link < links);
    for (const Coupling& coupling : model.couplings)
        for (const Coupling::Term& term : coupling.terms) CHECK(term.joint >= 0 && term.joint < joints);
    for (const Tendon& tendon : model.tendons)
        for (const PathPart& part : tendon.path)
            CHECK(part.link >= 0 && part.link < links && part.side_link < links && part.divisor > 0);
    for (const Actuator& actuator : model.actuators)
        CHECK(actuator.joint < joints && actuator.tendon < int(model.tendons.size()) &&
              (actuator.joint >= 0 || actuator.tendon >= 0));
    for (const auto& pair : model.excluded)
        for (int link : pair) CHECK(link >= 0 && link < links);
    for (const Frame& frame : model.frames) CHECK(frame.link >= 0 && frame.link < links);
    for (const Start& start : model.starts) CHECK(int(start.positions.size()) == model.coordinates);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const epode::fuzz::TimeLimit limit;
    LoadOptions options;
    options.repair = options.inertia_from_shapes = true, options.missing_mass = 1;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const RobotModel model = load_robot_text(EPODE_MODELS "/fuzz." EPODE_ENDING, text, options);
    if (model.has_errors()) return 0;
    check_links(model);
    check_indices(model);
    CHECK(forward_kinematics(model, reference_positions(model)).size() == model.links.size());
    CHECK(tendon_lengths(model, reference_positions(model)).size() == model.tendons.size());
    if (std::hash<std::string>()(text) % 8 != 0) return 0;
    for (const WrittenRobot& written : {write_urdf(model, EPODE_MODELS), write_mjcf(model, EPODE_MODELS)})
        (void)load_robot_text(EPODE_MODELS "/written.xml", written.text, options);
    return 0;
}
