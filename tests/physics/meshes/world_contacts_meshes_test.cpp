// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// World-managed contacts between solids and meshes. What a pair keeps of the mesh from step to step
// (bvh/near_leaves.h) must never be that of a mesh that has changed, moved, or gone: balls and boxes stand on
// what is there, and fall where nothing is.
#include <memory>

#include "mesh_floors.h"
#include "world_contacts.h"

namespace epode::physics {
namespace {

// A square of cells x cells about (x, y) at the height z, as arrays that may be changed.
struct Ground {
    std::vector<dReal> vertices;
    std::vector<dTriIndex> triangles;

    void add(int cells, double cell, V3 at)
    {
        const auto first = dTriIndex(vertices.size() / 4);
        const int row = cells + 1;
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) {
                vertices.push_back(real(at.x + cell * (i - 0.5 * cells)));
                vertices.push_back(real(at.y + cell * (j - 0.5 * cells)));
                vertices.push_back(real(at.z)), vertices.push_back(0);
            }
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                const auto a = first + dTriIndex(j * row + i), b = a + 1, c = a + dTriIndex(row), d = c + 1;
                triangles.insert(triangles.end(), {a, b, d, a, d, c});
            }
    }
};

struct Data {
    explicit Data(const Ground& ground) : id(dGeomTriMeshDataCreate())
    {
        dGeomTriMeshDataBuildSimple(id, ground.vertices.data(), int(ground.vertices.size() / 4),
                                    ground.triangles.data(), int(ground.triangles.size()));
    }
    Data(const Data&) = delete;
    Data& operator=(const Data&) = delete;
    ~Data() { dGeomTriMeshDataDestroy(id); }
    dTriMeshDataID id;
};

// A ball, a box, a capsule and a cylinder about the origin, the capsule lying.
struct Guests {
    explicit Guests(Sim& sim)
        : body{sim.sphere({-1.1, 0.1, 0.5}, 0.5, 2), sim.box({1.2, 0, 0.5}, {1, 1, 1}, 2),
               sim.capsule({0, 2.1, 0.5}, 0.5, 1, 2), sim.cylinder({0.1, -2.2, 0.5}, 0.5, 1, 2)}
    {
        const dQuaternion lying = {real(std::sqrt(0.5)), real(std::sqrt(0.5)), 0, 0};
        dBodySetQuaternion(body[2], lying);
    }
    void expect_to_stand_on(double z, const char* why) const
    {
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(position(body[k]).z, z + 0.5, 0.02) << why << ' ' << k;
    }
    void expect_below(double z, const char* why) const
    {
        for (int k = 0; k < 4; ++k) EXPECT_LT(position(body[k]).z, z) << why << ' ' << k;
    }
    dBodyID body[4];
};

class WorldContactsOnMeshes : public testing::Test {
  protected:
    WorldContactsOnMeshes() : sim(Stepper::kFast) { floor.add(8, 1.4, {}); }
    WorldContactsSim sim;
    Ground floor;
};

TEST_F(WorldContactsOnMeshes, change_under_what_stands_on_them)
{
    // Two squares that change places: what was near is far away.
    floor.add(8, 1.4, {100, 0, 0});
    const Data data(floor);
    dCreateTriMesh(sim.space, data.id, nullptr, nullptr, nullptr);
    const Guests guests(sim);
    sim.run(300);
    guests.expect_to_stand_on(0, "before");
    const std::size_t half = floor.vertices.size() / 2;
    for (std::size_t i = 0; i < half; ++i) std::swap(floor.vertices[i], floor.vertices[half + i]);
    dGeomTriMeshDataUpdate(data.id);
    sim.run(300);
    guests.expect_to_stand_on(0, "changed places");
    for (std::size_t i = 2; i < floor.vertices.size(); i += 4) floor.vertices[i] = real(-2);
    dGeomTriMeshDataUpdate(data.id);
    sim.run(90);
    guests.expect_to_stand_on(-2, "lowered");
}

// Their boxes overlap as before, and nothing has moved.
TEST_F(WorldContactsOnMeshes, let_fall_what_has_come_to_rest)
{
    const std::size_t under = floor.vertices.size();
    floor.add(1, 1, {40, 0, 5});
    const Data data(floor);
    dCreateTriMesh(sim.space, data.id, nullptr, nullptr, nullptr);
    const Guests guests(sim);
    sim.run(900);
    guests.expect_to_stand_on(0, "at rest");
    for (std::size_t i = 2; i < under; i += 4) floor.vertices[i] = real(-2);
    dGeomTriMeshDataUpdate(data.id);
    sim.run(120);
    guests.expect_to_stand_on(-2, "lowered");
}

TEST_F(WorldContactsOnMeshes, let_fall_what_becomes_smaller)
{
    floor.add(1, 1, {40, 0, 5});
    const Data data(floor);
    dCreateTriMesh(sim.space, data.id, nullptr, nullptr, nullptr);
    const Guests guests(sim);
    sim.run(900);
    dGeomSphereSetRadius(geom_of(guests.body[0]), real(0.25));
    dGeomBoxSetLengths(geom_of(guests.body[1]), real(0.5), real(0.5), real(0.5));
    dGeomCapsuleSetParams(geom_of(guests.body[2]), real(0.25), 1);
    dGeomCylinderSetParams(geom_of(guests.body[3]), real(0.25), real(0.5));
    sim.run(60);
    guests.expect_to_stand_on(-0.25, "smaller");
}

TEST_F(WorldContactsOnMeshes, are_exchanged_under_what_stands_on_them)
{
    Ground deep;
    deep.add(9, 1.3, {0, 0, -1});
    const Data high_data(floor);
    auto deep_data = std::make_unique<Data>(deep);
    const dGeomID geom = dCreateTriMesh(sim.space, high_data.id, nullptr, nullptr, nullptr);
    const Guests guests(sim);
    sim.run(300);
    guests.expect_to_stand_on(0, "first");
    dGeomTriMeshSetData(geom, deep_data->id);
    sim.run(60);
    guests.expect_to_stand_on(-1, "exchanged");
    deep_data.reset();  // the geom has no triangles
    sim.run(60);
    guests.expect_below(-2, "without data");
}

TEST_F(WorldContactsOnMeshes, move_with_what_stands_on_them)
{
    const Data data(floor);
    const dGeomID geom = dCreateTriMesh(sim.space, data.id, nullptr, nullptr, nullptr);
    const Guests guests(sim);
    sim.run(300);
    dGeomSetPosition(geom, 0, 0, -1);
    sim.run(60);
    guests.expect_to_stand_on(-1, "lowered");
    dMatrix3 turned;
    dRFromAxisAndAngle(turned, 0, 0, 1, real(0.7));
    dGeomSetRotation(geom, turned);
    sim.run(60);
    guests.expect_to_stand_on(-1, "turned");
    dGeomSetPosition(geom, 200, 0, -1);
    sim.run(60);
    guests.expect_below(-2, "gone");
}

TEST_F(WorldContactsOnMeshes, are_destroyed_and_made_again)
{
    const Guests guests(sim);
    for (int i = 0; i < 3; ++i) {
        Ground ground;
        ground.add(8 + i, 1.4, {0, 0, -double(i)});
        const Data data(ground);
        const dGeomID geom = dCreateTriMesh(sim.space, data.id, nullptr, nullptr, nullptr);
        sim.run(90);
        guests.expect_to_stand_on(-i, "made");
        dGeomDestroy(geom);
    }
    sim.run(60);
    guests.expect_below(-4, "destroyed");
}

// What leaves the part of the mesh that is kept, at every speed, is carried all the same.
TEST_F(WorldContactsOnMeshes, carry_what_slides_and_rolls_over_them)
{
    Ground wide;
    wide.add(60, 0.7, {});
    const Data data(wide);
    set_material(dCreateTriMesh(sim.space, data.id, nullptr, nullptr, nullptr), 0);
    for (const double speed : {0.1, 1.0, 8.0}) {
        const dBodyID box = sim.box({-15, 2 * speed, 0.5}, {1, 1, 1}, 2),
                      ball = sim.sphere({-15, -1.5 - 2 * speed, 0.5}, 0.5, 2);
        velocity(box, {speed, 0, 0}), velocity(ball, {speed, 0, 0}, {0, 2 * speed, 0});
    }
    sim.run(180);
    for (std::size_t i = 0; i < 6; ++i) {
        const double speed = i < 2 ? 0.1 : i < 4 ? 1 : 8;
        EXPECT_NEAR(position(sim.bodies[i]).z, 0.5, 0.002) << i;
        EXPECT_NEAR(velocity(sim.bodies[i]).x, speed, 0.01 * speed) << i;
    }
}

}  // namespace
}  // namespace epode::physics
