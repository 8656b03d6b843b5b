// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See robot_stage.h.
#include "robot_stage.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace demo {

void Robot::load(const std::string& file)
{
    model = dRobotModelLoad((EPODE_ROBOT_FILES "/" + file).c_str(), nullptr);
    robot = model ? dRobotCreate(world, space, model, nullptr, nullptr) : nullptr;
    if (!robot) {
        std::fprintf(stderr, "%s is no robot\n", file.c_str());
        std::exit(1);
    }
    const int links = dRobotModelGetLinks(model, nullptr, 0);
    for (int link = 1; link < links; ++link)
        for (dGeomID geom = dBodyGetFirstGeom(dRobotGetBody(robot, link)); geom;
             geom = dBodyGetNextGeom(geom))
            link % 2 ? paint(draw(geom), 0.92f, 0.91f, 0.88f) : paint(draw(geom), 0.90f, 0.45f, 0.22f);
}

void Robot::destroy()
{
    dRobotDestroy(robot);
    dRobotModelDestroy(model);
}

std::vector<dReal> Robot::positions() const
{
    std::vector<dReal> q(static_cast<size_t>(dRobotGetPositions(robot, nullptr, 0)));
    dRobotGetPositions(robot, q.data(), static_cast<int>(q.size()));
    return q;
}

std::vector<dReal> Robot::velocities() const
{
    std::vector<dReal> v(static_cast<size_t>(dRobotGetVelocities(robot, nullptr, 0)));
    dRobotGetVelocities(robot, v.data(), static_cast<int>(v.size()));
    return v;
}

dRobotJoint Robot::joint(const char* name) const
{
    std::vector<dRobotJoint> all(static_cast<size_t>(dRobotModelGetJoints(model, nullptr, 0)));
    dRobotModelGetJoints(model, all.data(), static_cast<int>(all.size()));
    return all[static_cast<size_t>(dRobotModelFindJoint(model, name))];
}

dRobotTarget Robot::target(const char* frame) const
{
    dReal at[7] = {0, 0, 0, 1, 0, 0, 0};
    dRobotTarget out;
    dRobotTargetInit(&out, dRobotModelFindFrame(model, frame, at));
    std::copy_n(at, 3, out.point);
    std::copy_n(at + 3, 4, out.point_q);
    out.orientation_weight = 0;
    return out;
}

void Robot::place(const char* frame, dVector3 out) const
{
    const dRobotTarget its = target(frame);
    std::vector<dRobotLink> links(static_cast<size_t>(dRobotModelGetLinks(model, nullptr, 0)));
    dRobotModelGetLinks(model, links.data(), static_cast<int>(links.size()));
    const dReal* c = links[static_cast<size_t>(its.link)].centre;
    dBodyGetRelPointPos(dRobotGetBody(robot, its.link), its.point[0] - c[0], its.point[1] - c[1],
                        its.point[2] - c[2], out);
}

void print(const char* what, double value, const char* unit)
{
    std::fprintf(stderr, "%s: %.4g %s\n", what, value, unit);
}

}  // namespace demo
