// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Links of one robot that overlap and are not meant to touch: neighbours of neighbours, covers, collars. Contacts would hold them
// fast or throw them. Files of URDF do not name them: what overlaps at the reference position is taken for such a pair. Files of MJCF
// and SDF name them, but not all: a shoulder or wrist whose middle link has no length leaves two links that can never part. Those
// that overlap at the reference and at kPositions more positions of all joints do not touch either, with a message.
#include <ode/ext.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <random>
#include <set>

#include "robots/build.h"

namespace epode::robots {

namespace {

constexpr int kPositions = 64;
constexpr double kFar = 1000;  // m, of a free joint or a slide without limits
constexpr double kPi = 3.14159265358979323846;

using Pairs = std::set<std::array<int, 2>>;  // links, the lower number first

struct Overlaps {
    std::map<dBodyID, int> link_of;
    Pairs found;
};

void note_overlap(void* data, dGeomID one, dGeomID two)
{
    Overlaps& overlaps = *static_cast<Overlaps*>(data);
    const dBodyID a = dGeomGetBody(one), b = dGeomGetBody(two);
    dContactGeom contact;
    if (!a || !b || a == b || dAreConnected(a, b)) return;
    if (dCollide(one, two, 1, &contact, sizeof contact) == 0) return;
    const auto [low, high] = std::minmax(overlaps.link_of[a], overlaps.link_of[b]);
    overlaps.found.insert({low, high});
}

Pairs overlaps_now(Overlaps& overlaps, dSpaceID space)
{
    overlaps.found.clear();
    dSpaceCollide(space, &overlaps, &note_overlap);
    return overlaps.found;
}

// The same ones for everybody.
class AnyPositions {
  public:
    std::vector<double> next(const RobotModel& model)
    {
        std::vector<double> out = reference_positions(model);
        for (const Joint& joint : model.joints) move(joint, &out[size_t(joint.position)]);
        return out;
    }

  private:
    double between(double low, double high)
    {
        return low + (high - low) * (double(random_()) / 4294967296.0);
    }

    void move(const Joint& joint, double* its)
    {
        const double far = joint.kind == JointKind::kHinge ? kPi : kFar;
        if (joint.is_scalar()) {
            its[0] = joint.limited ? between(std::max(joint.low, -kFar), std::min(joint.high, kFar))
                                   : its[0] + between(-far, far);
        } else if (joint.kind == JointKind::kFree) {
            for (int i = 0; i < 3; ++i) its[i] += between(-kFar, kFar);
        } else {
            const Quat turn = normalised({between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)});
            its[0] = turn.w, its[1] = turn.x, its[2] = turn.y, its[3] = turn.z;
        }
    }

    std::mt19937 random_;
};

// Of the pairs those that overlap wherever the joints are.
Pairs never_apart(Pairs pairs, Robot& robot, Overlaps& overlaps, dSpaceID space)
{
    AnyPositions positions;
    for (int i = 0; i < kPositions && !pairs.empty(); ++i) {
        robot.set_positions(positions.next(robot.model()));
        const Pairs now = overlaps_now(overlaps, space);
        Pairs both;
        std::set_intersection(pairs.begin(), pairs.end(), now.begin(), now.end(),
                              std::inserter(both, both.end()));
        pairs = both;
    }
    return pairs;
}

}  // namespace

void Prepared::find_overlapping()
{
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(nullptr);
    if (world && space) {
        const std::shared_ptr<const Prepared> borrowed(this, [](const Prepared*) {});
        Robot robot(borrowed, world, space, {}, {});
        Overlaps overlaps;
        for (size_t i = 0; i < model_.links.size(); ++i)
            if (robot.body(int(i))) overlaps.link_of[robot.body(int(i))] = int(i);
        Pairs pairs = overlaps_now(overlaps, space);
        if (model_.touches_itself) pairs = never_apart(pairs, robot, overlaps, space);
        overlapping_.assign(pairs.begin(), pairs.end());
    }
    if (space) dSpaceDestroy(space);
    if (world) dWorldDestroy(world);
    for (const auto& [one, two] : overlapping_)
        if (model_.touches_itself)
            dMessage(d_ERR_UNKNOWN,
                     "robot %s: links '%s' and '%s' overlap wherever the joints are, and do not touch: "
                     "exclude the pair",
                     (model_.name.empty() ? model_.path : model_.name).c_str(),
                     model_.links[size_t(one)].name.c_str(), model_.links[size_t(two)].name.c_str());
}

}  // namespace epode::robots
