// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "soaked_world.h"

#include <algorithm>
#include <cmath>

namespace epode::soak {
namespace {

constexpr int kMostBodies = 60;
constexpr double kDropHeight = 6, kWall = 5;
// A fall from kDropHeight ends at 11 m/s; the end of a long lever that is struck may be some times as fast.
constexpr double kFastest = 150, kLowest = -1;

constexpr int kSide = 20;
constexpr float kCorners[4][3] = {{-9, -9, 0.02f}, {9, -9, 0.02f}, {9, 9, 0.02f}, {-9, 9, 0.02f}};
constexpr dTriIndex kFaces[2][3] = {{0, 1, 2}, {0, 2, 3}};

double length_of(const dReal* v) { return std::sqrt(double(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])); }

}  // namespace

int SoakedWorld::Step::operator()(dWorldID world) const
{
    switch (stepper) {
        case 0:
            return dWorldStep(world, size);
        case 1:
            return dWorldStepHybrid(world, size);
        case 2:
            return dWorldQuickStep(world, size);
        default:
            return dWorldStepFast1(world, size, substeps);
    }
}

SoakedWorld::SoakedWorld(std::uint64_t seed, const Habit& habit)
    : habit_(habit),
      random_(seed),
      world_(dWorldCreate()),
      space_(dHashSpaceCreate(nullptr)),
      mesh_(dGeomTriMeshDataCreate()),
      field_(dGeomHeightfieldDataCreate())
{
    dWorldSetGravity(world_, 0, 0, dReal(-9.81));
    dWorldSetContactSpace(world_, space_);
    if (habit.has_preset)
        dWorldUseDefaults(world_, habit.preset);
    else
        dWorldSetContactMaxCorrectingVel(world_, 1);  // what is dropped into others leaves them slowly
    dWorldSetStepReportMode(world_, 1);
    make_ground();
    for (int i = 0; i < kMostBodies / 2; ++i) drop();
}

SoakedWorld::~SoakedWorld()
{
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    dGeomTriMeshDataDestroy(mesh_);
    dGeomHeightfieldDataDestroy(field_);
}

void SoakedWorld::make_ground()
{
    dCreatePlane(space_, 0, 0, 1, 0);
    const double walls[4][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    for (const auto& n : walls) dCreatePlane(space_, dReal(n[0]), dReal(n[1]), 0, -kWall);
    dGeomTriMeshDataBuildSingle(mesh_, kCorners, sizeof kCorners[0], 4, kFaces, 6, sizeof kFaces[0]);
    dCreateTriMesh(space_, mesh_, nullptr, nullptr, nullptr);
    std::vector<double> heights;
    for (int i = 0; i < kSide * kSide; ++i) heights.push_back(0.15 * std::sin(i * 0.7) * std::cos(i / kSide));
    dGeomHeightfieldDataBuildDouble(field_, heights.data(), 1, 2 * kWall, 2 * kWall, kSide, kSide, 1, 0, 1,
                                    0);
    const dGeomID land = dCreateHeightfield(space_, field_, 1);
    dMatrix3 upright;
    dRFromAxisAndAngle(upright, 1, 0, 0, dReal(M_PI / 2));
    dGeomSetRotation(land, upright);
}

dGeomID SoakedWorld::make_shape(dMass& mass)
{
    const auto a = dReal(between(0.1, 0.4)), b = dReal(between(0.1, 0.4)),
               density = dReal(between(100, 2000));
    switch (below(5)) {
        case 0:
            dMassSetSphere(&mass, density, a);
            return dCreateSphere(space_, a);
        case 1:
            dMassSetBox(&mass, density, a, b, a);
            return dCreateBox(space_, a, b, a);
        case 2:
            dMassSetCapsule(&mass, density, 3, a, b);
            return dCreateCapsule(space_, a, b);
        case 3:
            dMassSetCylinder(&mass, density, 3, a, b);
            return dCreateCylinder(space_, a, b);
        default:  // a lever
            dMassSetBox(&mass, density, 2, dReal(0.1), dReal(0.1));
            return dCreateBox(space_, 2, dReal(0.1), dReal(0.1));
    }
}

void SoakedWorld::drop()
{
    if (int(bodies_.size()) >= kMostBodies) {
        const dBodyID oldest = bodies_.front();
        while (const dGeomID geom = dBodyGetFirstGeom(oldest)) dGeomDestroy(geom);
        while (dBodyGetNumJoints(oldest) > 0) dJointDestroy(dBodyGetJoint(oldest, 0));
        dBodyDestroy(oldest);
        bodies_.erase(bodies_.begin());
    }
    dMass mass;
    const dGeomID geom = make_shape(mass);
    const dBodyID body = dBodyCreate(world_);
    dBodySetMass(body, &mass);
    dGeomSetBody(geom, body);
    dBodySetPosition(body, dReal(between(-3, 3)), dReal(between(-3, 3)), dReal(between(2, kDropHeight)));
    if (below(4) == 0) dGeomSetContinuous(geom, 1);
    bodies_.push_back(body);
}

void SoakedWorld::tie()
{
    static constexpr dJointID (*kMakers[])(dWorldID, dJointGroupID) = {
        dJointCreateBall, dJointCreateHinge, dJointCreateUniversal, dJointCreateSlider, dJointCreateFixed};
    drop();
    const dBodyID a = bodies_[bodies_.size() - 2], b = bodies_.back();
    const dReal* p = dBodyGetPosition(a);
    // Arms of up to ten times the radius of gyration.
    dBodySetPosition(b, p[0] + dReal(between(0.3, 1.5)), p[1], p[2] + dReal(between(0.2, 1)));
    dBodyEnable(a);
    const int kind = below(5);
    const dJointID joint = kMakers[kind](world_, nullptr);
    dJointAttach(joint, a, b);
    if (kind == 0) dJointSetBallAnchor(joint, p[0], p[1], p[2]);
    if (kind == 1) dJointSetHingeAnchor(joint, p[0], p[1], p[2]), dJointSetHingeAxis(joint, 0, 1, 0);
    if (kind == 1) dJointSetHingeParam(joint, dParamLoStop, -1), dJointSetHingeParam(joint, dParamHiStop, 1);
    if (kind == 2) dJointSetUniversalAnchor(joint, p[0], p[1], p[2]);
    if (kind == 4) dJointSetFixed(joint);
}

void SoakedWorld::tune()
{
    switch (below(8)) {
        case 0:
            return dWorldSetAutoDisableFlag(world_, below(2));
        case 1:
            return dWorldSetStepThreads(world_, 1 + below(2));
        case 2:
            return dWorldSetStepWarmStarting(world_, dReal(below(3)) / 2);
        case 3:
            return dWorldSetExactSubsteps(world_, 1 + below(3));
        case 4:
            return dWorldSetHybridSubsteps(world_, 1 + below(6));
        case 5:
            return dWorldSetStepProjection(world_, below(3));
        case 6:
            return dWorldSetQuickStepNumIterations(world_, 5 + below(40));
        default:
            return dWorldSetExactRotation(world_, below(2));
    }
}

void SoakedWorld::change()
{
    switch (below(4)) {
        case 0:
            return tie();
        case 1:
            return drop();
        case 2:
            return habit_.has_preset ? drop() : tune();
        default:
            return dBodyDisable(bodies_[std::size_t(below(int(bodies_.size())))]);
    }
}

Bytes SoakedWorld::state_of(dWorldID world) const
{
    Bytes state(dWorldGetStateSize(world));
    if (!dWorldGetState(world, state.data(), state.size())) state.clear();
    return state;
}

// Steps that are taken back and made again are the same.
std::string SoakedWorld::roll_back(const Step& step)
{
    ++states;
    const Bytes before = state_of(world_);
    step(world_);
    const Bytes first = state_of(world_);
    if (!dWorldSetState(world_, before.data(), before.size())) return "a state is refused";
    step(world_);
    if (state_of(world_) != first) return "a step that is made again is another";
    return judge(step);
}

// A clone or a loaded file goes on as the world does.
std::string SoakedWorld::follow_copy(const Step& step, const Bytes& before)
{
    const bool by_file = below(2);
    ++(by_file ? files : copies);
    dSpaceID space = nullptr;
    dWorldID copy;
    if (by_file) {
        Bytes file(dWorldSaveToBuffer(world_, nullptr, nullptr, 0));
        dWorldSaveToBuffer(world_, nullptr, file.data(), file.size());
        copy = dWorldLoadFromBuffer(file.data(), file.size(), &space);
    } else {
        copy = dWorldClone(world_, &space, nullptr, 0);
    }
    if (!copy) return by_file ? "what was saved cannot be loaded" : "no clone";
    std::string wrong = state_of(copy) == before ? "" : "a copy has another state";
    step(copy), step(world_);
    if (wrong.empty() && state_of(copy) != state_of(world_))
        wrong = by_file ? "a loaded world steps otherwise" : "a clone steps otherwise";
    dTriMeshDataID mesh = nullptr;
    dHeightfieldDataID field = nullptr;
    for (int i = 0; by_file && i < dSpaceGetNumGeoms(space); ++i) {
        const dGeomID geom = dSpaceGetGeom(space, i);
        if (dGeomGetClass(geom) == dTriMeshClass) mesh = dGeomTriMeshGetData(geom);
        if (dGeomGetClass(geom) == dHeightfieldClass) field = dGeomHeightfieldGetHeightfieldData(geom);
    }
    dSpaceDestroy(space), dWorldDestroy(copy);
    if (mesh) dGeomTriMeshDataDestroy(mesh);
    if (field) dGeomHeightfieldDataDestroy(field);
    return wrong.empty() ? judge(step) : wrong;
}

std::string SoakedWorld::judge(const Step& step)
{
    dWorldStepReport report = {};
    report.struct_size = sizeof report;
    if (!dWorldGetStepReport(world_, &report)) return "no report";
    contained += report.contained_islands;
    const double gain = report.energy_after - report.energy_before;
    largest_gain = std::max(largest_gain, gain);
    for (const dBodyID body : bodies_) {
        const dReal* p = dBodyGetPosition(body);
        const double v = length_of(dBodyGetLinearVel(body));
        fastest = std::max(fastest, v);
        if (!(v < kFastest) || !(p[2] > kLowest) || !(length_of(p) < 100))
            return "stepper " + std::to_string(step.stepper) + ": a body at " + std::to_string(p[0]) + " " +
                   std::to_string(p[1]) + " " + std::to_string(p[2]) + " with " + std::to_string(v) + " m/s";
    }
    return report.contained_islands ? "an island was contained" : "";
}

SoakedWorld::Step SoakedWorld::next_step()
{
    if (habit_.has_preset) return {1, dReal(habit_.size), 1};
    static constexpr double kSizes[] = {0.002, 0.005, 0.01, 1.0 / 60};
    return {below(4), dReal(kSizes[below(4)]), 1 + below(8)};
}

std::string SoakedWorld::step()
{
    const Step step = next_step();
    ++steps, ++by_stepper[step.stepper];
    switch (below(16)) {
        case 0:
            return roll_back(step);
        case 1:
            return follow_copy(step, state_of(world_));
        default:
            return step(world_) ? judge(step) : "a step was not made";
    }
}

}  // namespace epode::soak
