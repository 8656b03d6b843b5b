// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Continuous collision. What is fast does not pass what is thin: solids of every class at 100 and 1000 m/s at
// walls of every kind, each other, swung and spinning; what rests, slides, rolls or grazes is left as it was,
// to the bit where nothing is stopped.
#include <algorithm>
#include <array>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kWall = 0.01;  // how thick walls are, m; their middle is at x = 0

void look_out(dBodyID body, int mode = dContinuousOn)
{
    for (dGeomID g = dBodyGetFirstGeom(body); g; g = dBodyGetNextGeom(g)) dGeomSetContinuous(g, mode);
}

// ---- walls across x ----

enum class Wall { kBox, kPlane, kMesh, kField, kCylinder, kConvex, kHeavyBody };
constexpr Wall kWalls[] = {Wall::kBox,      Wall::kPlane,  Wall::kMesh,     Wall::kField,
                           Wall::kCylinder, Wall::kConvex, Wall::kHeavyBody};
const char* name_of(Wall wall)
{
    switch (wall) {
        case Wall::kBox:
            return "box";
        case Wall::kPlane:
            return "plane";
        case Wall::kMesh:
            return "mesh";
        case Wall::kField:
            return "field";
        case Wall::kCylinder:
            return "cylinder";
        case Wall::kConvex:
            return "convex";
        case Wall::kHeavyBody:
            return "heavy_body";
    }
    return "";
}

class WallScene : public Sim {
  public:
    WallScene(Stepper s, Wall wall) : Sim(s)
    {
        surface.mode |= dContactSoftERP;
        surface.soft_erp = real(0.2);
        put(wall);
    }
    ~WallScene()
    {
        if (mesh_) dGeomTriMeshDataDestroy(mesh_);
        if (field_) dGeomHeightfieldDataDestroy(field_);
    }

  private:
    static constexpr int kCells = 20;
    static constexpr double kHalf = 2;

    void put(Wall wall)
    {
        const dReal thick = real(kWall), wide = real(2 * kHalf);
        const double h = kWall / 2;
        dMatrix3 R;
        switch (wall) {
            case Wall::kBox:
                dCreateBox(space, thick, wide, wide);
                break;
            case Wall::kPlane:
                dCreatePlane(space, -1, 0, 0, real(h));
                break;
            case Wall::kMesh:
                put_mesh();
                break;
            case Wall::kField:
                put_field();
                break;
            case Wall::kCylinder: {
                const dGeomID disk = dCreateCylinder(space, real(kHalf), thick);
                dRFromAxisAndAngle(R, 0, 1, 0, real(kPi / 2));
                dGeomSetRotation(disk, R);
                break;
            }
            case Wall::kConvex: {
                const dReal x = real(h), y = real(kHalf);
                const dReal corners[] = {-x, -y, -y, x, -y, -y, -x, y, -y, x, y, -y,
                                         -x, -y, y,  x, -y, y,  -x, y, y,  x, y, y};
                dCreateConvexHull(space, corners, 8, 0);
                break;
            }
            case Wall::kHeavyBody:
                box({}, {kWall, 2 * kHalf, 2 * kHalf}, 1e6);
                bodies.clear();
                break;
        }
    }

    // Triangles that look to -x.
    void put_mesh()
    {
        for (int i = 0; i <= kCells; ++i)
            for (int k = 0; k <= kCells; ++k) {
                const double y = -kHalf + 2 * kHalf * i / kCells, z = -kHalf + 2 * kHalf * k / kCells;
                for (const double c : {0.0, y, z, 0.0}) vertices_.push_back(real(c));
            }
        const auto at = [](int i, int k) { return dTriIndex(i * (kCells + 1) + k); };
        for (int i = 0; i < kCells; ++i)
            for (int k = 0; k < kCells; ++k)
                for (const dTriIndex v :
                     {at(i, k), at(i, k + 1), at(i + 1, k), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)})
                    indices_.push_back(v);
        mesh_ = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSimple(mesh_, vertices_.data(), unsigned(vertices_.size() / 4), indices_.data(),
                                    unsigned(indices_.size()));
        dCreateTriMesh(space, mesh_, nullptr, nullptr, nullptr);
    }

    // Its ground is at x > 0, its height axis looks to -x.
    void put_field()
    {
        samples_.assign(kCells * kCells, 0.0f);
        field_ = dGeomHeightfieldDataCreate();
        dGeomHeightfieldDataBuildSingle(field_, samples_.data(), 0, real(2 * kHalf), real(2 * kHalf), kCells,
                                        kCells, 1, 0, real(kWall), 0);
        const dGeomID ground = dCreateHeightfield(space, field_, 1);
        dMatrix3 R;
        dRFromAxisAndAngle(R, 0, 0, 1, real(kPi / 2));
        dGeomSetRotation(ground, R);
    }

    dTriMeshDataID mesh_ = nullptr;
    dHeightfieldDataID field_ = nullptr;
    std::vector<dReal> vertices_;
    std::vector<dTriIndex> indices_;
    std::vector<float> samples_;
};

// ---- bullets ----

enum class Bullet { kSphere, kBox, kCapsule, kCylinder, kConvex, kMesh, kOffset };
constexpr Bullet kBullets[] = {Bullet::kSphere, Bullet::kBox,  Bullet::kCapsule, Bullet::kCylinder,
                               Bullet::kConvex, Bullet::kMesh, Bullet::kOffset};

struct Tetrahedron {
    Tetrahedron() : data(dGeomTriMeshDataCreate())
    {
        dGeomTriMeshDataBuildSimple(data, vertices, 4, indices, 12);
    }
    ~Tetrahedron() { dGeomTriMeshDataDestroy(data); }
    dReal vertices[16] = {real(0.05),  real(0.05), real(0.05),  0, real(-0.05), real(-0.05), real(0.05),  0,
                          real(-0.05), real(0.05), real(-0.05), 0, real(0.05),  real(-0.05), real(-0.05), 0};
    dTriIndex indices[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    dTriMeshDataID data;
};

dBodyID shoot(Sim& sim, Bullet bullet, V3 from, V3 speed, V3 turning, const Tetrahedron& mesh)
{
    if (bullet == Bullet::kSphere || bullet == Bullet::kOffset) sim.sphere(from, 0.03, 1);
    if (bullet == Bullet::kBox) sim.box(from, {0.1, 0.05, 0.04}, 1);
    if (bullet == Bullet::kCapsule) sim.capsule(from, 0.02, 0.1, 1);
    if (bullet == Bullet::kCylinder) sim.cylinder(from, 0.03, 0.06, 1);
    if (bullet == Bullet::kConvex || bullet == Bullet::kMesh) {
        const dBodyID b = sim.body(from, 1, 1e-3);
        const dReal c = real(0.05);
        const dReal corners[] = {c, c, c, -c, -c, c, -c, c, -c, c, -c, -c};
        const dGeomID g = bullet == Bullet::kMesh
                              ? dCreateTriMesh(sim.space, mesh.data, nullptr, nullptr, nullptr)
                              : dCreateConvexHull(sim.space, corners, 4, 0);
        dGeomSetBody(g, b);
    }
    const dBodyID b = sim.bodies.back();
    if (bullet == Bullet::kOffset) {
        // Two balls on one body, either side of its centre.
        dGeomSetOffsetPosition(dBodyGetFirstGeom(b), 0, real(0.1), 0);
        const dGeomID other = dCreateSphere(sim.space, real(0.03));
        dGeomSetBody(other, b);
        dGeomSetOffsetPosition(other, 0, real(-0.1), 0);
    }
    velocity(b, speed, turning);
    return b;
}

// How often does a bullet get to the other side?
int passed(Stepper stepper, Wall wall, Bullet bullet, double speed, int shots, int mode)
{
    const Tetrahedron mesh;
    int through = 0;
    Random dice(std::uint32_t(77 + int(wall) * 10 + int(bullet)));
    for (int i = 0; i < shots; ++i) {
        WallScene sim(stepper, wall);
        const V3 spot = {0, dice.uniform(-0.5, 0.5), dice.uniform(-0.5, 0.5)};
        const double lean = dice.uniform(-0.3, 0.3), before = dice.uniform(1, 2);
        const V3 v = {speed, lean * speed, 0};
        const dBodyID b = shoot(sim, bullet, spot - (before / speed) * v, v, dice.point(20), mesh);
        look_out(b, mode);
        // As long as it is in front of the wall, or behind.
        for (int step = 0; step < 30 && std::fabs(position(b).y) < 1.8; ++step) {
            sim.step(0.01);
            EXPECT_TRUE(finite_state(sim));
            if (std::fabs(position(b).y) < 1.8 && position(b).x > kWall / 2) {
                ++through;
                break;
            }
        }
    }
    return through;
}

class Bullets : public testing::TestWithParam<Wall> {};

TEST_P(Bullets, do_not_pass_thin_walls)
{
    for (const Bullet bullet : kBullets)
        for (const double speed : {100.0, 1000.0})
            EXPECT_EQ(passed(Stepper::kExact, GetParam(), bullet, speed, 5, dContinuousOn), 0)
                << "bullet " << int(bullet) << " at " << speed;
}

INSTANTIATE_TEST_SUITE_P(Continuous, Bullets, testing::ValuesIn(kWalls),
                         [](const testing::TestParamInfo<Wall>& wall) {
                             return std::string(name_of(wall.param));
                         });

TEST(Continuous, bullets_pass_without_it)
{
    // Half-spaces, fields and planes, hold without it; what is thin does not.
    for (const Wall wall : {Wall::kBox, Wall::kMesh, Wall::kCylinder, Wall::kConvex, Wall::kHeavyBody})
        EXPECT_GT(passed(Stepper::kExact, wall, Bullet::kSphere, 1000, 5, dContinuousOff), 1)
            << name_of(wall);
}

TEST(Continuous, every_stepper_holds_bullets)
{
    for (const Stepper stepper : kSteppers)
        for (const Wall wall : {Wall::kBox, Wall::kMesh})
            EXPECT_EQ(passed(stepper, wall, Bullet::kBox, 300, 4, dContinuousOn), 0) << name_of(stepper);
}

TEST(Continuous, sensors_are_passed)
{
    Sim sim;
    const dGeomID wall = dCreateBox(sim.space, real(kWall), 4, 4);
    dGeomSetContinuous(wall, dContinuousIgnored);
    const dBodyID b = sim.sphere({-1.6, 0, 0}, 0.03, 1);
    look_out(b);
    velocity(b, {100, 0, 0});
    for (int i = 0; i < 4; ++i) sim.advance(0.01);
    EXPECT_NEAR(position(b).x, 2.4, tol(1e-12, 1e-5));
}

// A program that makes no contact with what a bullet meets: it goes on after the step of the meeting.
TEST(Continuous, what_the_program_does_not_hold_is_passed_in_the_next_step)
{
    Sim sim;
    dCreateBox(sim.space, real(kWall), 4, 4);
    const dBodyID b = sim.sphere({-0.5, 0, 0}, 0.03, 1);
    look_out(b);
    velocity(b, {100, 0, 0});
    sim.advance(0.01);
    EXPECT_NEAR(position(b).x, -kWall / 2 - 0.03, 1e-3);
    sim.advance(0.01);
    EXPECT_GT(position(b).x, 0.9);
}

TEST(Continuous, bits_decide_what_is_met)
{
    Sim sim;
    const dGeomID wall = dCreateBox(sim.space, real(kWall), 4, 4);
    const dBodyID b = sim.sphere({-0.5, 0, 0}, 0.03, 1);
    look_out(b);
    dGeomSetCategoryBits(dBodyGetFirstGeom(b), 1);
    dGeomSetCollideBits(dBodyGetFirstGeom(b), 1);
    dGeomSetCategoryBits(wall, 2);
    dGeomSetCollideBits(wall, 2);
    velocity(b, {100, 0, 0});
    sim.advance(0.01);
    EXPECT_NEAR(position(b).x, 0.5, tol(1e-12, 1e-6));
    place(b, {-0.5, 0, 0});
    dGeomSetCollideBits(wall, 1);
    sim.advance(0.01);
    EXPECT_LT(position(b).x, 0);
    place(b, {-0.5, 0, 0});
    dGeomDisable(wall);
    sim.advance(0.01);
    EXPECT_GT(position(b).x, 0.4);
}

// Where a bullet stops it is a hair deep, its velocity is what it was, and the report says so.
TEST(Continuous, stops_a_hair_deep_and_keeps_the_velocity)
{
    Sim sim;
    dWorldSetStepReportMode(sim.world, 1);
    const dGeomID wall = dCreateBox(sim.space, real(kWall), 4, 4);
    const dBodyID b = sim.sphere({-3, 0, 0}, 0.03, 1);
    look_out(b);
    velocity(b, {700, 0, 0}, {5, 6, 7});
    sim.advance(0.01);
    EXPECT_EQ(sim.report().stopped_bodies, 1);
    EXPECT_EQ(length(velocity(b) - V3{700, 0, 0}), 0);
    EXPECT_EQ(length(spin(b) - V3{5, 6, 7}), 0);
    dContactGeom contact;
    ASSERT_EQ(dCollide(dBodyGetFirstGeom(b), wall, 1, &contact, sizeof contact), 1);
    EXPECT_GT(contact.depth, 1e-5);
    EXPECT_LT(contact.depth, 5e-4);
    place(b, {-3, 0, 0});
    velocity(b, {70, 0, 0});
    sim.advance(0.01);
    EXPECT_EQ(sim.report().stopped_bodies, 0);
}

// ---- against what moves ----

TEST(Continuous, two_that_fly_at_each_other_meet)
{
    for (const double speed : {50.0, 400.0})
        for (const int second : {dContinuousOff, dContinuousOn}) {
            Sim sim;
            sim.surface.mu = 0;
            const dBodyID a = sim.sphere({-3, 0, 0}, 0.03, 1), b = sim.sphere({3, 0, 0}, 0.03, 1);
            look_out(a);
            look_out(b, second);
            velocity(a, {speed, 0, 0});
            velocity(b, {-speed, 0, 0});
            for (int i = 0; i < 60; ++i) sim.step(0.01);
            EXPECT_LT(position(a).x, position(b).x) << speed << ' ' << second;
            EXPECT_LE(velocity(a).x, velocity(b).x + 1e-3) << speed << ' ' << second;
        }
}

TEST(Continuous, a_bullet_that_follows_another_one_stops_behind_it)
{
    Sim sim;
    dCreateBox(sim.space, real(kWall), 4, 4);
    // The faster one older, and younger.
    for (const bool faster_first : {true, false}) {
        const dBodyID one = sim.sphere({-1, 0, 0}, 0.03, 1), two = sim.sphere({-1.5, 0, 0}, 0.03, 1);
        const dBodyID ahead = faster_first ? two : one, behind = faster_first ? one : two;
        place(ahead, {-1, 0, 0});
        place(behind, {-1.5, 0, 0});
        look_out(one);
        look_out(two);
        velocity(ahead, {200, 0, 0});
        velocity(behind, {250, 0, 0});
        sim.advance(0.01);
        EXPECT_NEAR(position(ahead).x, -kWall / 2 - 0.03, 1e-3);
        EXPECT_NEAR(position(behind).x, -kWall / 2 - 0.09, 2e-3);
        dBodyDestroy(one);
        dBodyDestroy(two);
        while (dSpaceGetNumGeoms(sim.space) > 1) dGeomDestroy(dSpaceGetGeom(sim.space, 0));
        sim.bodies.clear();
    }
}

// A bat that the program swings: the ball is carried along, and struck.
TEST(Continuous, a_kinematic_bat_carries_the_ball_along)
{
    Sim sim;
    const dBodyID bat = sim.box({0, 0, 0}, {0.02, 2, 0.2}, 1);
    dBodySetKinematic(bat);
    velocity(bat, {0, 0, 0}, {0, 0, -60});  // at y = 0.9: 54 m/s to +x
    const dBodyID ball = sim.sphere({0.2, 0.9, 0}, 0.03, 0.1);
    look_out(ball);
    sim.step(0.01);
    EXPECT_NEAR(length(position(ball)), length(V3{0.2, 0.9, 0}), 0.1);
    // In front of the bat: its normal is R x.
    const dReal* R = dBodyGetRotation(bat);
    const V3 normal = {double(R[0]), double(R[4]), double(R[8])};
    EXPECT_NEAR(dot(normal, position(ball)), 0.04, 2e-3);
    for (int i = 0; i < 3; ++i) sim.step(0.01);
    EXPECT_GT(length(velocity(ball)), 30);
}

TEST(Continuous, a_spinning_rod_does_not_pass_a_post)
{
    for (const int mode : {dContinuousOff, dContinuousOn}) {
        Sim sim;
        const dGeomID post = dCreateCapsule(sim.space, real(0.01), 1);
        dGeomSetPosition(post, real(0.4), 0, 0);
        const dBodyID rod = sim.box({0, 0, 0}, {0.02, 1, 0.02}, 1);
        look_out(rod, mode);
        // From 1.5 rad before the post, 2 rad in the step.
        velocity(rod, {}, {0, 0, -1000 * std::tan(1.0) / 5});
        dMatrix3 R;
        dRFromAxisAndAngle(R, 0, 0, 1, real(0.07));
        dBodySetRotation(rod, R);
        sim.advance(0.01);
        const dReal* q = dBodyGetQuaternion(rod);
        const double angle = 2 * std::atan2(double(q[3]), double(q[0]));
        if (mode == dContinuousOn) {
            EXPECT_NEAR(angle, -(kPi / 2 - 0.05), 0.02);
        } else {
            EXPECT_LT(angle, -1.8);
        }
    }
}

// ---- what is to stay as it is ----

double slid(Stepper stepper, int mode, double speed, bool rolls)
{
    Sim sim(stepper);
    sim.gravity(0, 0, -9.81);
    sim.surface.mu = real(rolls ? 1 : 0.1);
    for (int i = -2; i < 40; ++i) {
        const dGeomID tile = dCreateBox(sim.space, 10, 10, 1);
        dGeomSetPosition(tile, real(10 * i), 0, real(-0.5));
    }
    const dBodyID b = rolls ? sim.sphere({0, 0, 0.1}, 0.1, 1) : sim.box({0, 0, 0.05}, {0.2, 0.2, 0.1}, 1);
    look_out(b, mode);
    velocity(b, {speed, 0, 0}, rolls ? V3{0, speed / 0.1, 0} : V3{});
    sim.steps(300, 0.01);
    return position(b).x;
}

TEST(Continuous, sliding_and_rolling_at_speed_is_not_hindered)
{
    for (const Stepper stepper : kSteppers)
        for (const bool rolls : {false, true}) {
            const double without = slid(stepper, dContinuousOff, 100, rolls);
            EXPECT_GT(without, 100);
            const double with = slid(stepper, dContinuousOn, 100, rolls);
            EXPECT_GE(with, without - 1e-3) << name_of(stepper) << ' ' << rolls;
            // In floats a sphere that is not looked after is caught by seams, 200 m from the origin.
            if (!kSingle) { EXPECT_LE(with, without + 1e-3) << name_of(stepper); }
        }
}

TEST(Continuous, a_stack_stays_as_it_is_to_the_bit)
{
    std::uint64_t hash[2];
    for (const int mode : {dContinuousOff, dContinuousOn}) {
        Sim sim;
        sim.gravity(0, 0, -9.81);
        sim.ground();
        for (int i = 0; i < 8; ++i) look_out(sim.box({0.01 * (i % 3), 0, 0.5 + i}, {1, 1, 1}, 1), mode);
        sim.steps(200, 0.01);
        EXPECT_NEAR(position(sim.bodies[7]).z, 7.5, 0.05);
        hash[mode] = hash_state(sim);
    }
    EXPECT_EQ(hash[0], hash[1]);
}

TEST(Continuous, what_grazes_goes_on)
{
    Sim sim;
    dCreateBox(sim.space, 1, 1, 1);
    const dBodyID b = sim.sphere({-3, 0, 0.5 + 0.0295}, 0.03, 1);  // half a millimetre deep, above the top
    look_out(b);
    velocity(b, {600, 0, 0});
    sim.advance(0.01);
    EXPECT_NEAR(position(b).x, 3, tol(1e-12, 1e-5));
}

TEST(Continuous, bodies_on_joints_stop_together)
{
    Sim sim;
    dCreateBox(sim.space, real(kWall), 4, 4);
    const dBodyID front = sim.sphere({-1, 0, 0}, 0.05, 1), back = sim.sphere({-1.5, 0, 0}, 0.05, 1);
    look_out(front);
    const dJointID joint = dJointCreateFixed(sim.world, nullptr);
    dJointAttach(joint, front, back);
    dJointSetFixed(joint);
    for (const dBodyID b : {front, back}) velocity(b, {300, 0, 0});
    sim.advance(0.01);
    EXPECT_NEAR(position(front).x, -kWall / 2 - 0.05, 1e-3);
    EXPECT_NEAR(position(front).x - position(back).x, 0.5, tol(1e-9, 1e-5));
}

// A ball that spins in its place moves nothing that lies on it; what is carried rigidly with its turn is swung by the turn times its arm.
TEST(Continuous, a_spinning_ball_does_not_swing_what_falls_on_it)
{
    for (const bool tied : {false, true}) {
        Sim sim;
        const dBodyID ball = sim.sphere({0, 0, 0}, 0.2, 100);
        velocity(ball, {0, 0, 0}, {0, 100, 0});  // turns by 1 in the step; its surface moves by 0.2 m
        const dBodyID rod = sim.box({0, 0, 0.35}, {tied ? 0.1 : 4, 0.1, 0.1}, 1);
        velocity(rod, {0, 0, -20}, {});
        look_out(rod);
        const dBodyID far_end = tied ? sim.box({3, 0, 0.35}, {0.1, 0.1, 0.1}, 1) : rod;
        if (tied) {
            velocity(far_end, {0, 0, -20}, {});
            const dJointID joint = dJointCreateFixed(sim.world, nullptr);
            dJointAttach(joint, rod, far_end);
            dJointSetFixed(joint);
        }
        sim.step(0.01);
        const V3 p = position(far_end);
        EXPECT_LT(std::hypot(p.x - (tied ? 3 : 0), p.z - 0.35), 0.45)
            << tied;  // its own way is 0.2 m at most
        const dReal* R = dBodyGetRotation(rod);
        EXPECT_GT(R[0], std::cos(0.1)) << tied;
        EXPECT_GT(position(rod).z, 0.2) << tied;
    }
}

TEST(Continuous, a_body_hung_up_does_not_take_itself_for_a_wall)
{
    // Its two parts overlap, and so do the two bodies that the joint connects.
    Sim sim;
    const dBodyID a = sim.box({0, 0, 0}, {0.2, 0.2, 0.2}, 1), b = sim.box({0.15, 0, 0}, {0.2, 0.2, 0.2}, 1);
    const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(hinge, a, b);
    dJointSetHingeAnchor(hinge, real(0.1), 0, 0);
    for (const dBodyID body : {a, b}) look_out(body), velocity(body, {50, 0, 0});
    velocity(b, {50, 0, 0}, {100, 0, 0});
    sim.advance(0.01);
    EXPECT_NEAR(position(a).x, 0.5, 0.05);
}

// ---- thin meshes ----

TEST(Continuous, a_thin_mesh_that_falls_on_solids_is_not_passed)
{
    // A sheet of two triangles, one way up or the other, on what pricks it, at 10 m/s and 0.05 s a step.
    const dReal corners[] = {-1, -1, 0, 0, 1, -1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0};
    const dTriIndex triangles[] = {0, 1, 2, 0, 2, 3};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(data, corners, 4, triangles, 6);
    for (int kind = 0; kind < 4; ++kind)
        for (const double turn : {0.0, kPi}) {
            Sim sim;
            sim.gravity(0, 0, -9.81);
            dGeomID solid = nullptr;
            if (kind == 0) dCreatePlane(sim.space, 0, 0, 1, 0);
            if (kind == 1) solid = dCreateBox(sim.space, 1, 1, real(0.2));
            if (kind == 2) solid = dCreateBox(sim.space, 4, 4, real(0.02));
            if (kind == 3) {
                const dReal points[] = {1, 1, 0, -1, 1, 0, -1, -1, 0, 1, -1, 0, 0, 0, real(-0.3)};
                solid = dCreateConvexHull(sim.space, points, 5, 0);
            }
            if (solid) dGeomSetPosition(solid, 0, 0, real(-0.01));
            const dBodyID sheet = sim.body({0.05, 0.02, 1.3}, 1, 0.3);
            const dGeomID g = dCreateTriMesh(sim.space, data, nullptr, nullptr, nullptr);
            dGeomSetBody(g, sheet);
            look_out(sheet);
            dMatrix3 R;
            dRFromAxisAndAngle(R, 1, 0, 0, real(turn));
            dBodySetRotation(sheet, R);
            velocity(sheet, {0, 0, -10});
            for (int i = 0; i < 40; ++i) {
                sim.step(0.05);
                ASSERT_GT(position(sheet).z, -0.35) << kind << ' ' << turn << " step " << i;
            }
        }
    dGeomTriMeshDataDestroy(data);
}

// ---- rules of the house ----

std::uint64_t rain(int threads, Stepper stepper, int mode)
{
    WallScene sim(stepper, Wall::kMesh);
    dWorldSetStepThreads(sim.world, threads);
    sim.gravity(20, 0, 0);
    Random dice(5);
    for (int i = 0; i < 60; ++i) {
        const V3 at = {dice.uniform(-3, -1), dice.uniform(-1, 1), dice.uniform(-1, 1)};
        const dBodyID b = i % 2 ? sim.sphere(at, 0.04, 1) : sim.box(at, {0.1, 0.06, 0.08}, 1);
        velocity(b, {dice.uniform(50, 400), dice.uniform(-2, 2), 0}, dice.point(30));
        look_out(b, mode);
    }
    sim.steps(25, 0.01);
    if (mode == dContinuousOn) {
        // None behind the wall, unless it has come round its edge.
        for (const dBodyID b : sim.bodies) {
            const V3 at = position(b);
            EXPECT_TRUE(at.x < 0.05 || std::fabs(at.y) > 1.9 || std::fabs(at.z) > 1.9) << at.x;
        }
    }
    EXPECT_TRUE(finite_state(sim));
    return hash_state(sim);
}

TEST(Continuous, has_the_same_bits_on_any_number_of_threads)
{
    for (const Stepper stepper : {Stepper::kExact, Stepper::kQuick}) {
        const std::uint64_t alone = rain(1, stepper, dContinuousOn);
        EXPECT_NE(alone, rain(1, stepper, dContinuousOff));
        for (const int threads : {2, 3, 5}) EXPECT_EQ(rain(threads, stepper, dContinuousOn), alone);
    }
}

TEST(Continuous, bad_modes_and_geoms_are_refused)
{
    Sim sim;
    const Messages messages;
    const dGeomID ball = dCreateSphere(sim.space, 1), plane = dCreatePlane(sim.space, 0, 0, 1, 0);
    EXPECT_EQ(dGeomGetContinuous(ball), int(dContinuousOff));
    for (const int mode : {-1, 3, 1 << 30}) dGeomSetContinuous(ball, mode);
    dGeomSetContinuous(plane, dContinuousOn);
    dGeomSetContinuous(reinterpret_cast<dGeomID>(sim.space), dContinuousOn);
    dGeomSetContinuous(nullptr, dContinuousOn);
    EXPECT_EQ(messages.count(), 6);
    EXPECT_EQ(dGeomGetContinuous(ball), int(dContinuousOff));
    EXPECT_EQ(dGeomGetContinuous(plane), int(dContinuousOff));
    dGeomSetContinuous(plane, dContinuousIgnored);
    dGeomSetContinuous(ball, dContinuousOn);
    EXPECT_EQ(dGeomGetContinuous(plane), int(dContinuousIgnored));
    EXPECT_EQ(dGeomGetContinuous(ball), int(dContinuousOn));
    EXPECT_EQ(messages.count(), 6);
}

// Speeds that no program means: nothing hangs, nothing becomes a NaN.
TEST(Continuous, absurd_speeds_are_borne)
{
    for (const Wall wall : kWalls)
        for (const double speed : {1e6, 1e12, tol(1e90, 1e15)}) {
            WallScene sim(Stepper::kExact, wall);
            const dBodyID b = sim.box({-1, 0, 0}, {0.1, 0.1, 0.1}, 1);
            look_out(b);
            velocity(b, {speed, speed / 3, 0}, {speed, 0, speed});
            for (int i = 0; i < 3; ++i) sim.step(0.01);
            const V3 at = position(b);
            EXPECT_TRUE(at.x == at.x && at.y == at.y) << name_of(wall) << ' ' << speed;
        }
}

}  // namespace
}  // namespace epode::physics
