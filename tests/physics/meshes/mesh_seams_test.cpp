// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What slides over a floor cut into triangles, over the border between two meshes or over a height field
// slides as on a plane. EPODE_SLIDE sets the way in metres (the nightly run takes 100).
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "mesh_floors.h"

namespace epode::physics {
namespace {

struct Slide {
    double fastest_up = 0;  // largest |v_z| after the first tenth of a second
    double speed = 0, off = 0, turned = 0;
    int changes = 0;
};

enum class Body { kSphere, kBox, kCapsule, kStandingCylinder, kLyingCylinder };

dBodyID make(Sim& sim, Body body, double x)
{
    const double r = 0.3;
    switch (body) {
        case Body::kSphere:
            return sim.sphere({x, 0.1, r}, r, 1);
        case Body::kBox:
            return sim.box({x, 0.1, 0.2}, {0.9, 0.7, 0.4}, 1);
        case Body::kCapsule:
        case Body::kLyingCylinder: {
            const dBodyID b = body == Body::kCapsule ? sim.capsule({x, 0.1, r}, r, 0.8, 1)
                                                     : sim.cylinder({x, 0.1, r}, r, 0.8, 1);
            dMatrix3 R;
            dRFromAxisAndAngle(R, 0, 1, 0, real(kPi / 2));  // along x, so that it slides
            dBodySetRotation(b, R);
            return b;
        }
        default:
            return sim.cylinder({x, 0.1, 0.25}, r, 0.5, 1);
    }
}

// `side`: of the path, and of the velocity a tenth.
Slide slide(Floor floor, Body body, double way, double side)
{
    Sim sim;
    sim.gravity(0, 0, -9.81);
    sim.surface.mode = dContactApprox1;
    sim.surface.mu = real(0.2);
    const double h = 0.005, start = 2 * std::sqrt(way), x = -0.25 * way;
    const FlatGround ground(sim, floor, 200, way > 20 ? 1.0 : 0.1);
    const dBodyID b = make(sim, body, x);
    dBodySetPosition(b, dBodyGetPosition(b)[0], real(side < 0 ? -0.15 : 0.1), dBodyGetPosition(b)[2]);
    velocity(b, {start, side > 0 ? 0.1 * start : 0, 0});
    Slide s;
    for (double t = 0; position(b).x - x < way && t < 0.8 * start / (0.2 * 9.81); t += h) {
        sim.step(h);
        if (t > 0.1) s.fastest_up = std::fmax(s.fastest_up, std::fabs(velocity(b).z));
    }
    s.speed = length(velocity(b));
    s.off = position(b).y;
    s.turned = length(spin(b));
    return s;
}

struct Seams : testing::TestWithParam<Body> {};

TEST_P(Seams, are_not_felt)
{
    const char* wanted = std::getenv("EPODE_SLIDE");
    const double way = wanted ? std::atof(wanted) : 6;
    const double start = 2 * std::sqrt(way) * std::sqrt(1.01);
    for (const Floor floor : {Floor::kMesh, Floor::kRidge, Floor::kTwoMeshes, Floor::kField}) {
        const double side = floor == Floor::kRidge ? -1 : 1;
        const Slide plane = slide(Floor::kPlane, GetParam(), way, side),
                    s = slide(floor, GetParam(), way, side);
        SCOPED_TRACE(testing::Message() << name_of(floor) << ": aside " << s.off << " (plane " << plane.off
                                        << "), spin " << s.turned << " (plane " << plane.turned << ")");
        // What lies across its way comes to roll and rocks on a plane, too, when it is fast.
        EXPECT_LT(s.fastest_up, std::fmax(1e-3, 1.001 * plane.fastest_up));
        if (wanted)
            std::printf("%-16s up %.2e m/s (plane %.2e), deceleration %+.4f %% of the plane's\n",
                        name_of(floor), s.fastest_up, plane.fastest_up,
                        100 * (plane.speed - s.speed) / (start - plane.speed));
        EXPECT_NEAR(s.speed, plane.speed, 0.01 * (start - plane.speed));
    }
}

INSTANTIATE_TEST_SUITE_P(Bodies, Seams,
                         testing::Values(Body::kSphere, Body::kBox, Body::kCapsule, Body::kStandingCylinder,
                                         Body::kLyingCylinder));

}  // namespace
}  // namespace epode::physics
