// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies at rest on meshes: as on a box geom of the same size, without drift and without contacts that come
// and go; a mesh that rests on a mesh, on a plane's mesh and on a height field.
#include <memory>

#include "mesh_floors.h"

namespace epode::physics {
namespace {

struct Rest {
    V3 moved;  // in the last nine seconds
    double height = 0;
    int flickers = 0;  // changes of the number of contacts in them
    int contacts = 0;
};

Rest rest(Sim& sim, dBodyID body, double seconds = 10)
{
    const double h = 0.01;
    sim.steps(int(1 / h), h);
    const V3 from = position(body);
    Rest r;
    r.contacts = sim.contact_count;
    for (double t = 1; t < seconds; t += h) {
        sim.step(h);
        r.flickers += sim.contact_count != r.contacts ? 1 : 0;
    }
    r.moved = position(body) - from;
    r.height = position(body).z;
    return r;
}

void earthly(Sim& sim)
{
    sim.gravity(0, 0, -9.81);
    sim.surface.mode = dContactApprox1;
    sim.surface.mu = 1;
}

std::vector<dBodyID> bodies(Sim& sim, double top)
{
    const double e = 1e-3;
    const dBodyID lying = sim.capsule({0.1, 0.7, top + 0.2 - e}, 0.2, 0.6, 1);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 0, 0, real(kPi / 2));
    dBodySetRotation(lying, R);
    return {sim.sphere({0.7, 0.1, top + 0.3 - e}, 0.3, 1),
            sim.box({-0.7, 0.05, top + 0.2 - e}, {0.5, 0.6, 0.4}, 1), lying,
            sim.cylinder({0.1, -0.7, top + 0.25 - e}, 0.3, 0.5, 1)};
}

struct MeshRest : testing::TestWithParam<Stepper> {};

TEST_P(MeshRest, is_as_on_a_box)
{
    const bool exact =
        GetParam() == Stepper::kExact;  // what the quick stepper leaves over lifts contacts, on boxes too
    for (int k = 0; k < 4; ++k) {
        Rest on[2];
        for (const bool mesh : {false, true}) {
            Sim sim(GetParam());
            earthly(sim);
            std::unique_ptr<MeshGeom> ground;
            if (mesh)
                ground.reset(box_mesh(sim.space, {3, 3, 1}));
            else
                dCreateBox(sim.space, 3, 3, 1);
            const std::vector<dBodyID> all = bodies(sim, 0.5);
            for (int i = 0; i < 4; ++i)
                if (i != k) dBodyDisable(all[std::size_t(i)]);
            for (int i = 0; i < 4; ++i)
                if (i != k) dGeomDisable(dBodyGetFirstGeom(all[std::size_t(i)]));
            on[mesh] = rest(sim, all[std::size_t(k)]);
        }
        EXPECT_LT(length(on[1].moved), exact ? 1e-4 : 1e-3) << k;
        EXPECT_NEAR(on[1].height, on[0].height, 1e-5) << k;
        EXPECT_EQ(on[1].contacts, on[0].contacts) << k;
        if (exact) { EXPECT_EQ(on[1].flickers, 0) << k; }
    }
}

TEST_P(MeshRest, a_box_mesh_rests_as_a_box_does)
{
    const bool exact = GetParam() == Stepper::kExact;
    for (const Floor floor : {Floor::kPlane, Floor::kMesh, Floor::kField}) {
        Sim sim(GetParam());
        earthly(sim);
        const FlatGround ground(sim, floor, 20, 0.3);
        const std::unique_ptr<MeshGeom> mesh(box_mesh(sim.space, {0.8, 0.6, 0.4}));
        const dBodyID body = sim.body({0.11, 0.07, 0.199});
        dGeomSetBody(mesh->geom, body);
        const Rest r = rest(sim, body);
        EXPECT_LT(length(r.moved), exact ? 1e-4 : 1e-3) << name_of(floor);
        if (exact) { EXPECT_EQ(r.flickers, 0) << name_of(floor); }
        EXPECT_NEAR(r.height, 0.2, 1e-3) << name_of(floor);
        if (exact) { EXPECT_EQ(r.contacts, 4) << name_of(floor); }
    }
}

INSTANTIATE_TEST_SUITE_P(Steppers, MeshRest, testing::Values(Stepper::kExact, Stepper::kQuick), case_name);

TEST(RoughMesh, dropped_solids_stay_on_rough_ground)
{
    Sim sim;
    earthly(sim);
    std::vector<dReal> v;
    std::vector<dTriIndex> t;
    Random dice(3);
    const int n = 30;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            for (const double x : {0.5 * (i - 15), 0.5 * (j - 15), dice.uniform(0, 0.3), 0.0})
                v.push_back(real(x));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const dTriIndex a = dTriIndex(i + j * (n + 1)), b = a + 1, c = a + dTriIndex(n) + 1, d = c + 1;
            for (const dTriIndex corner : {a, b, d, a, d, c}) t.push_back(corner);
        }
    const MeshGeom ground(sim.space, std::move(v), std::move(t));
    std::vector<dBodyID> all;
    for (int k = 0; k < 12; ++k) {
        const V3 at{1.5 * (k % 4) - 2.2, 1.5 * (k / 4) - 1.5, 1.0};
        all.push_back(k % 3 == 0   ? sim.box(at, {0.5, 0.3, 0.4}, 1)
                      : k % 3 == 1 ? sim.cylinder(at, 0.2, 0.4, 1)
                                   : sim.capsule(at, 0.2, 0.4, 1));
        dQuaternion q;
        dice.quaternion(q);
        dBodySetQuaternion(all.back(), q);
    }
    sim.steps(600, 0.01);
    for (const dBodyID b : all) {
        EXPECT_GT(position(b).z, 0.1);
        EXPECT_LT(length(velocity(b)), 1) << "round ones may still roll";
    }
    EXPECT_TRUE(finite_state(sim));
}

}  // namespace
}  // namespace epode::physics
