// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "scene.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

namespace hostile {
namespace {

// Sensors of many kinds, on a ball joint's link.
constexpr const char* kWatched =
    R"(<mujoco><option density="1000" viscosity="0.1" wind="1 0 0"/><worldbody><geom type="plane" size="5 5 1"/>
<body name="mast" pos="0 0 1"><joint name="turn" type="ball"/><geom size="0.1" mass="1"/><site name="eye" pos="0 0 0.1"/>
<body name="tip" pos="0 0 0.3"><joint name="knee" range="-1 1"/><geom name="ball" size="0.1" mass="1"/><site name="end" pos="0.1 0 0.2"/></body>
</body></worldbody><tendon><spatial name="string" range="0.1 0.4" stiffness="100" damping="1"><site site="eye"/><geom geom="ball"/><site site="end"/></spatial></tendon>
<actuator><motor name="drive" joint="knee" ctrlrange="-1 1"/><general tendon="string" dyntype="filter" dynprm="0.1" gainprm="10"/></actuator>
<sensor><accelerometer site="eye"/><gyro site="eye"/><force site="eye"/><touch site="eye"/><rangefinder site="eye"/>
<framepos objtype="site" objname="eye"/><ballquat joint="turn"/><jointpos joint="knee"/><magnetometer site="eye"/></sensor></mujoco>)";
// Some of all that a batch can take.
constexpr const char* kSwung =
    R"(<mujoco><option density="1"/><worldbody><geom type="plane" size="5 5 1"/><body pos="0 0 1"><freejoint/><geom size="0.1" mass="1"/>
<body pos="0 0 -0.2"><joint name="a" range="-60 60" frictionloss="0.1"/><geom type="capsule" size="0.05 0.2" mass="1"/></body></body>
<body pos="1 0 0.2"><freejoint/><geom type="box" size="0.1 0.1 0.1" mass="1"/></body></worldbody>
<tendon><fixed name="t" limited="true" range="-1 1"><joint joint="a" coef="2"/></fixed></tendon>
<actuator><position joint="a" kp="10" forcerange="-1 1"/><general tendon="t" dyntype="filter" dynprm="0.1" gainprm="2"/></actuator></mujoco>)";
constexpr const char* kFaulty = "<robot name='r'><link name='a'/><link name='a'/></robot>";

Messages g_messages;

std::string formatted(const char* format, va_list arguments)
{
    char text[400];
    std::vsnprintf(text, sizeof text, format, arguments);
    return text;
}

void note(int, const char* format, va_list arguments)
{
    g_messages.ours.push_back(formatted(format, arguments));
}
void note_refusal(int, const char* format, va_list arguments)
{
    g_messages.odes.push_back(formatted(format, arguments));
}

void mix(std::size_t& hash, const void* data, std::size_t size)
{
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
}

std::vector<dBodyID> bodies_of(dWorldID world)
{
    std::vector<dBodyID> out(std::size_t(dWorldGetBodies(world, nullptr, 0)));
    dWorldGetBodies(world, out.data(), int(out.size()));
    return out;
}

}  // namespace

Messages& messages() { return g_messages; }

Scene::Scene(const std::string& folder)
{
    dInitODE2(0);
    dSetMessageHandler(note), dSetDebugHandler(note_refusal), dSetErrorHandler(note_refusal);
    for (const char* name : {"arm.urdf", "walker.xml", "fourbar.xml"}) paths.push_back(folder + '/' + name);
    std::ifstream file(paths[0], std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(file), {});
    build();
}

Scene::~Scene()
{
    tear_down();
    dSetMessageHandler(nullptr), dSetDebugHandler(nullptr), dSetErrorHandler(nullptr);
    dCloseODE();
}

dRobotModelID Scene::load(std::size_t number) const
{
    if (number < paths.size()) return dRobotModelLoad(paths[number].c_str(), nullptr);
    return dRobotModelLoadText("watched.xml", kWatched, std::strlen(kWatched), nullptr);
}

void Scene::build()
{
    world = dWorldCreate(), other_world = dWorldCreate(), dead_world = dWorldCreate();
    space = dHashSpaceCreate(nullptr), dead_space = dHashSpaceCreate(nullptr);
    dWorldDestroy(dead_world), dSpaceDestroy(dead_space);
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    dWorldSetContactSpace(world, space);
    models.assign(paths.size() + 1, nullptr);
    robots.assign(2 * models.size(), nullptr);
    batches.assign(2, nullptr), bound.assign(1 << 12, 0);
    mend();
}

void Scene::tear_down()
{
    for (const dRobotID robot : robots) dRobotDestroy(robot);
    for (const dRobotModelID model : models) dRobotModelDestroy(model);
    for (const dBatchID batch : batches) dBatchDestroy(batch);
    dRobotModelDestroy(faulty_model);
    faulty_model = nullptr;
    dSpaceDestroy(space), dWorldDestroy(world), dWorldDestroy(other_world);
    messages().clear();
}

void Scene::rebuild() { tear_down(), build(), is_vandalised = false; }

void Scene::mend_batches()
{
    const dRobotModelID model = dRobotModelLoadText("swung.xml", kSwung, std::strlen(kSwung), nullptr);
    for (std::size_t i = 0; i < batches.size(); ++i) {
        if (dBatchGetNumCopies(batches[i]) > 0) continue;
        dBatchOptions options;
        dBatchOptionsInit(&options, sizeof options);
        options.doubles = int(i), options.threads = 2;
        dead_batch = batches[i], batches[i] = dBatchCreate(model, kCopies, &options);
    }
    dRobotModelDestroy(model);
}

void Scene::mend()
{
    mend_batches();
    if (!faulty_model || !dRobotModelHasErrors(faulty_model))
        faulty_model = dRobotModelLoadText("faulty.urdf", kFaulty, std::strlen(kFaulty), nullptr);
    for (std::size_t i = 0; i < models.size(); ++i)
        if (dRobotModelGetNumPositions(models[i]) == 0) dead_model = models[i], models[i] = load(i);
    for (std::size_t i = 0; i < robots.size(); ++i) {
        const dReal place[3] = {dReal(3 * int(i)), 0, dReal(0.5)};
        if (dRobotGetPositions(robots[i], nullptr, 0) > 0) continue;
        dead_robot = robots[i], robots[i] = dRobotCreate(world, space, models[i / 2], place, nullptr);
    }
    messages().clear();
}

std::size_t Scene::hash() const
{
    std::size_t hash = 0xcbf29ce484222325u;
    for (const dBodyID body : bodies_of(world)) {
        mix(hash, dBodyGetPosition(body), 3 * sizeof(dReal));
        mix(hash, dBodyGetQuaternion(body), 4 * sizeof(dReal));
        mix(hash, dBodyGetLinearVel(body), 3 * sizeof(dReal));
        mix(hash, dBodyGetAngularVel(body), 3 * sizeof(dReal));
    }
    const int counts[2] = {dSpaceGetNumGeoms(space), dWorldGetJoints(world, nullptr, 0)};
    mix(hash, counts, sizeof counts);
    return hash;
}

bool Scene::is_finite() const
{
    for (const dBodyID body : bodies_of(world)) {
        const dReal* all[] = {dBodyGetPosition(body), dBodyGetQuaternion(body), dBodyGetLinearVel(body),
                              dBodyGetAngularVel(body)};
        for (const dReal* values : all)
            for (int i = 0; i < 3; ++i)
                if (!std::isfinite(values[i])) return false;
    }
    return true;
}

void Scene::step()
{
    for (int i = 0; i < 2; ++i) {
        for (const dRobotID robot : robots) dRobotAddForces(robot, dReal(0.005));
        i ? dWorldStep(world, dReal(0.005)) : dWorldStepFast1(world, dReal(0.005), 4);
        for (const dRobotID robot : robots) dRobotUpdateSensors(robot, dReal(0.005));
    }
}

void Scene::vandalise(unsigned how)
{
    is_vandalised = true;
    const auto bodies = bodies_of(world);
    if (how % 4 == 0) dWorldDestroy(world);
    if (how % 4 == 1) dSpaceDestroy(space), dWorldDestroy(world);
    if (how % 4 == 2) dBodyDestroy(bodies[how / 4 % bodies.size()]);
    if (how % 4 == 3) dJointDestroy(dRobotGetJoint(robots[how / 4 % robots.size()], 0));
    messages().clear();
}

}  // namespace hostile
