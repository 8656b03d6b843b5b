// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What lies deep in a landscape and turns meets triangles that it has not touched before. Continuous collision that stops it there, at the
// beginning of each step, keeps it deep, so that contacts push it again and again: a lever of 24 kg had the energy of 10 MJ after some
// hundred steps (stepper_soak --preset game --seed 3).
#include <cmath>
#include <vector>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr int kSide = 20;
constexpr double kWide = 10, kLength = 2, kThick = 0.1, kMass = 24;

std::vector<double> hills()
{
    std::vector<double> heights;
    for (int i = 0; i < kSide * kSide; ++i) heights.push_back(0.15 * std::sin(i * 0.7) * std::cos(i / kSide));
    return heights;
}

class Landscape {
  public:
    explicit Landscape(int preset)
        : world(dWorldCreate()),
          space(dHashSpaceCreate(nullptr)),
          heights_(hills()),
          field_(dGeomHeightfieldDataCreate())
    {
        dWorldUseDefaults(world, preset);
        dWorldSetGravity(world, 0, 0, real(-9.81));
        dWorldSetContactSpace(world, space);
        dGeomHeightfieldDataBuildDouble(field_, heights_.data(), 0, kWide, kWide, kSide, kSide, 1, 0, 1, 0);
        const dGeomID land = dCreateHeightfield(space, field_, 1);
        dMatrix3 upright;
        dRFromAxisAndAngle(upright, 1, 0, 0, real(kPi / 2));
        dGeomSetRotation(land, upright);
    }
    ~Landscape()
    {
        dSpaceDestroy(space), dWorldDestroy(world);
        dGeomHeightfieldDataDestroy(field_);
    }
    Landscape(const Landscape&) = delete;
    Landscape& operator=(const Landscape&) = delete;

    // A lever that leaves the ground at one end, about the other.
    dBodyID lever(double x, double y, double spin) const
    {
        dMass mass;
        dMassSetBoxTotal(&mass, kMass, kLength, kThick, kThick);
        const dBodyID body = dBodyCreate(world);
        dBodySetMass(body, &mass);
        const dGeomID geom = dCreateBox(space, kLength, real(kThick), real(kThick));
        dGeomSetBody(geom, body);
        dGeomSetContinuous(geom, dContinuousOn);
        dBodySetPosition(body, real(x), real(y), 0);
        dBodySetLinearVel(body, 0, 0, real(spin * kLength / 2));
        dBodySetAngularVel(body, 0, real(spin), 0);
        return body;
    }

    dWorldID world;
    dSpaceID space;

  private:
    std::vector<double> heights_;
    dHeightfieldDataID field_;
};

double energy_of(dBodyID body)
{
    const V3 v = vec(dBodyGetLinearVel(body)), w = vec(dBodyGetAngularVel(body));
    const dReal* R = dBodyGetRotation(body);
    const double own = dot(w, V3{double(R[0]), double(R[4]), double(R[8])}), I = kMass / 6 * kThick * kThick,
                 across = kMass / 12 * (kLength * kLength + kThick * kThick);
    const double turning = across * (dot(w, w) - own * own) + I * own * own;
    return (kMass * dot(v, v) + turning) / 2 + kMass * 9.81 * position(body).z;
}

TEST(DeepContinuous, a_lever_leaves_a_landscape_with_the_energy_that_it_has)
{
    for (const int preset : {dDefaultsGame, dDefaultsRobot})
        for (int k = 0; k < 12; ++k) {
            const Landscape land(preset);
            const dBodyID lever = land.lever(-3 + 0.5 * k, 1.5 - 0.3 * k, 10);
            // It is pushed out of 0.2 m by contacts, which may take 3 m/s.
            const double allowed = energy_of(lever) * 1.25 + kMass * 9;
            double before = allowed;
            for (int i = 0; i < 180; ++i) {
                dWorldStepHybrid(land.world, real(1.0 / 60));
                const double now = energy_of(lever);
                ASSERT_LT(now, allowed) << "preset " << preset << ", lever " << k << ", step " << i;
                // Nothing is deep any more where it lands again.
                if (i > 60) {
                    ASSERT_LT(now, 1.05 * before + 20)
                        << "preset " << preset << ", lever " << k << ", step " << i;
                }
                before = now;
            }
        }
}

}  // namespace
}  // namespace epode::physics
