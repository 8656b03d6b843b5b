// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every shape at rest on every shape for ten seconds: on flat tops (plane, box, upright cylinder, convex,
// mesh, height field) and on round cradles (two lying cylinders, two lying capsules, four spheres). After the
// first second nothing drifts, and no contact comes, goes or jumps: warm starting and sleeping live on that.
#include <functional>
#include <memory>

#include "../../effort.h"
#include "mesh_floors.h"

namespace epode::physics {
namespace {

// What lies below has its top at z = 0 near the origin; what it owns goes with the world's things.
struct Below {
    const char* name;
    std::function<std::shared_ptr<void>(Sim&)> make;
};
// What comes to rest, its lowest point at z = 0.
struct Above {
    const char* name;
    std::function<dBodyID(Sim&, std::shared_ptr<void>&)> make;
};

void lay(dGeomID geom, V3 at, double turn)  // from the axis z to the horizontal at that angle from x
{
    dMatrix3 R;
    dRFromAxisAndAngle(R, real(-std::sin(turn)), real(std::cos(turn)), 0, real(kPi / 2));
    dGeomSetRotation(geom, R);
    dGeomSetPosition(geom, real(at.x), real(at.y), real(at.z));
}

std::vector<dReal> prism(double radius, double height, int sides)
{
    std::vector<dReal> points;
    for (int i = 0; i < 2 * sides; ++i) {
        const double a = 2 * kPi * (i / 2) / sides;
        for (const double x : {radius * std::cos(a), radius * std::sin(a), (i % 2 ? 0.5 : -0.5) * height})
            points.push_back(real(x));
    }
    return points;
}

dGeomID hull(dSpaceID space, double radius, double height, int sides)
{
    return dCreateConvexHull(space, prism(radius, height, sides).data(), unsigned(2 * sides), 0);
}

const std::vector<Below> kBelow = {
    {"plane", [](Sim& sim) { return std::make_shared<FlatGround>(sim, Floor::kPlane, 1, 1); }},
    {"mesh", [](Sim& sim) { return std::make_shared<FlatGround>(sim, Floor::kMesh, 20, 0.23); }},
    {"field", [](Sim& sim) { return std::make_shared<FlatGround>(sim, Floor::kField, 20, 0.23); }},
    {"box",
     [](Sim& sim) {
         dGeomSetPosition(dCreateBox(sim.space, 3, 3, 1), 0, 0, real(-0.5));
         return nullptr;
     }},
    {"cylinder",
     [](Sim& sim) {
         dGeomSetPosition(dCreateCylinder(sim.space, 2, 1), 0, 0, real(-0.5));
         return nullptr;
     }},
    {"convex",
     [](Sim& sim) {
         dGeomSetPosition(hull(sim.space, 2, 1, 8), 0, 0, real(-0.5));
         return nullptr;
     }},
    {"two cylinders",
     [](Sim& sim) {
         for (const double x : {-0.22, 0.22})
             lay(dCreateCylinder(sim.space, real(0.2), 3), {x, 0, -0.2}, kPi / 2);
         return nullptr;
     }},
    {"two capsules",
     [](Sim& sim) {
         for (const double x : {-0.22, 0.22})
             lay(dCreateCapsule(sim.space, real(0.2), 3), {x, 0, -0.2}, kPi / 2);
         return nullptr;
     }},
    {"four spheres",
     [](Sim& sim) {
         for (const double x : {-0.21, 0.21})
             for (const double y : {-0.21, 0.21})
                 dGeomSetPosition(dCreateSphere(sim.space, real(0.2)), real(x), real(y), real(-0.2));
         return nullptr;
     }},
};

const std::vector<Above> kAbove = {
    {"sphere",
     [](Sim& sim, auto&) {
         return sim.sphere({0, 0, 0.3}, 0.3, 1);
     }},
    {"box",
     [](Sim& sim, auto&) {
         return sim.box({0.03, 0.02, 0.2}, {0.7, 0.6, 0.4}, 1);
     }},
    {"capsule",
     [](Sim& sim, auto&) {
         const dBodyID body = sim.capsule({0, 0, 0.2}, 0.2, 0.7, 1);
         lay(dBodyGetFirstGeom(body), {0, 0, 0.2}, 0);
         return body;
     }},
    {"cylinder",
     [](Sim& sim, auto&) {
         return sim.cylinder({0.03, 0.02, 0.25}, 0.4, 0.5, 1);
     }},
    {"lying cylinder",
     [](Sim& sim, auto&) {
         const dBodyID body = sim.cylinder({0, 0, 0.2}, 0.2, 0.9, 1);
         lay(dBodyGetFirstGeom(body), {0, 0, 0.2}, 0);
         return body;
     }},
    {"convex",
     [](Sim& sim, auto&) {
         const dBodyID body = sim.body({0.03, 0.02, 0.2}, 1, 0.04);
         dGeomSetBody(hull(sim.space, 0.5, 0.4, 6), body);
         return body;
     }},
    {"mesh",
     [](Sim& sim, std::shared_ptr<void>& kept) {
         const dBodyID body = sim.body({0.03, 0.02, 0.2}, 1, 0.04);
         const std::shared_ptr<MeshGeom> mesh(box_mesh(sim.space, {0.8, 0.7, 0.4}));
         dGeomSetBody(mesh->geom, body);
         kept = mesh;
         return body;
     }},
};

using Places = std::vector<V3>;

void note(void* places, dGeomID a, dGeomID b)
{
    dContactGeom contact[8];
    const int n = dCollide(a, b, 8, contact, sizeof contact[0]);
    for (int i = 0; i < n; ++i) static_cast<Places*>(places)->push_back(vec(contact[i].pos));
}

// The farthest way of a contact to the next of the other list; a thousand kilometres if their numbers differ.
double jump(const Places& a, const Places& b)
{
    double worst = a.size() == b.size() ? 0 : 1e6;
    for (const V3& p : a) {
        double nearest = 1e6;
        for (const V3& q : b) nearest = std::min(nearest, length(p - q));
        worst = std::max(worst, nearest);
    }
    return worst;
}

struct Seen {
    double drift = 0;  // m, and of an axis of the body, in nine seconds
    int jumps = 0;     // of contacts, by more than a millimetre
};

Seen rest(Stepper stepper, const Below& below, const Above& above)
{
    Sim sim(stepper);
    sim.gravity(0, 0, -9.81);
    sim.surface.mode = dContactApprox1;
    sim.surface.mu = 1;
    std::shared_ptr<void> kept;
    const std::shared_ptr<void> ground = below.make(sim);
    const dBodyID body = above.make(sim, kept);
    if (stepper == Stepper::kQuick) dWorldSetContactSurfaceLayer(sim.world, real(tol(1e-4, 1e-3)));
    place(body, position(body) + V3{0, 0, 1e-3});
    sim.steps(100, 0.01);
    const V3 from = position(body), axis = vec(dBodyGetRotation(body)),
             other = vec(dBodyGetRotation(body) + 4);
    Seen seen;
    Places before, now;
    for (int i = 0; i < tests::effort(900); ++i) {
        now.clear();
        dSpaceCollide(sim.space, &now, &note);
        if (i > 0 && jump(before, now) > 1e-3) ++seen.jumps;
        before.swap(now);
        sim.step(0.01);
    }
    const double turned =
        std::max(length(vec(dBodyGetRotation(body)) - axis), length(vec(dBodyGetRotation(body) + 4) - other));
    seen.drift = std::max(length(position(body) - from), turned);
    return seen;
}

struct Rest : testing::TestWithParam<Stepper> {};

TEST_P(Rest, of_every_shape_on_every_shape)
{
    // In floats the quick stepper still turns what rests by more than tells one corner from the next.
    const bool steady = !kSingle || GetParam() == Stepper::kExact;
    double worst = 0;
    for (const Below& below : kBelow)
        for (const Above& above : kAbove) {
            const Seen seen = rest(GetParam(), below, above);
            EXPECT_LT(seen.drift, tol(1e-4, 1e-3)) << above.name << " on " << below.name;
            if (steady) { EXPECT_EQ(seen.jumps, 0) << above.name << " on " << below.name; }
            worst = std::max(worst, seen.drift);
        }
    RecordProperty("worst_drift", std::to_string(worst));
}

INSTANTIATE_TEST_SUITE_P(Steppers, Rest, testing::Values(Stepper::kExact, Stepper::kQuick), case_name);

}  // namespace
}  // namespace epode::physics
