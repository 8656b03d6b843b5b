// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Cones, ellipsoids and tapered capsules: masses against integrals over a grid, depths of points against the
// distance of a ball without size, the contacts they rest on, and piles of them at rest with every stepper.
#include <algorithm>
#include <functional>

#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81, kDensity = 700;

struct ShapeCase {
    const char* name;
    std::function<dGeomID(dSpaceID)> make;
    std::function<void(dMass*, double)> mass, total;
};
const ShapeCase kShapes[] = {
    {"cone", [](dSpaceID s) { return dCreateCone(s, real(0.3), real(0.7)); },
     [](dMass* m, double d) { dMassSetCone(m, real(d), 3, real(0.3), real(0.7)); },
     [](dMass* m, double t) { dMassSetConeTotal(m, real(t), 3, real(0.3), real(0.7)); }},
    {"ellipsoid", [](dSpaceID s) { return dCreateEllipsoid(s, real(0.2), real(0.3), real(0.45)); },
     [](dMass* m, double d) { dMassSetEllipsoid(m, real(d), real(0.2), real(0.3), real(0.45)); },
     [](dMass* m, double t) { dMassSetEllipsoidTotal(m, real(t), real(0.2), real(0.3), real(0.45)); }},
    {"tapered", [](dSpaceID s) { return dCreateTaperedCapsule(s, real(0.3), real(0.15), real(0.4)); },
     [](dMass* m, double d) { dMassSetTaperedCapsule(m, real(d), 3, real(0.3), real(0.15), real(0.4)); },
     [](dMass* m, double t) {
         dMassSetTaperedCapsuleTotal(m, real(t), 3, real(0.3), real(0.15), real(0.4));
     }},
};

double depth_of(dGeomID geom, V3 p)
{
    const dReal x = real(p.x), y = real(p.y), z = real(p.z);
    const int number = dGeomGetClass(geom);
    return double(number == dConeClass        ? dGeomConePointDepth(geom, x, y, z)
                  : number == dEllipsoidClass ? dGeomEllipsoidPointDepth(geom, x, y, z)
                                              : dGeomTaperedCapsulePointDepth(geom, x, y, z));
}

std::vector<dContactGeom> contacts_of(dGeomID a, dGeomID b)
{
    std::vector<dContactGeom> out(8);
    out.resize(std::size_t(dCollide(a, b, 8, out.data(), sizeof(dContactGeom))));
    return out;
}

class MoreShapes : public testing::TestWithParam<ShapeCase> {
  protected:
    ~MoreShapes() override { dGeomDestroy(geom); }
    dGeomID geom = GetParam().make(nullptr);
};
INSTANTIATE_TEST_SUITE_P(all, MoreShapes, testing::ValuesIn(kShapes),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST_P(MoreShapes, weigh_what_an_integral_over_a_grid_says)
{
    constexpr int kCells = 120;
    constexpr double kSide = 1.4, kCell = kSide / kCells;
    double volume = 0, xx = 0, zz = 0;
    V3 first;
    for (int i = 0; i < kCells; ++i)
        for (int j = 0; j < kCells; ++j)
            for (int k = 0; k < kCells; ++k) {
                const V3 p{(i + 0.5) * kCell - kSide / 2, (j + 0.5) * kCell - kSide / 2,
                           (k + 0.5) * kCell - kSide / 2};
                // The part of a cell at the surface that is inside, to first order.
                const double in = std::clamp(depth_of(geom, p) / kCell + 0.5, 0.0, 1.0);
                volume += in, first = first + in * p;
                xx += in * (p.y * p.y + p.z * p.z), zz += in * (p.x * p.x + p.y * p.y);
            }
    const double cell = kCell * kCell * kCell * kDensity;
    dMass m, t;
    GetParam().mass(&m, kDensity);
    EXPECT_NEAR(double(m.mass), cell * volume, 2e-3 * double(m.mass));
    EXPECT_NEAR(double(m.I[0]), cell * xx, 2e-3 * double(m.I[0]));
    EXPECT_NEAR(double(m.I[10]), cell * zz, 2e-3 * double(m.I[10]));
    EXPECT_LT(length(first) / volume, 1e-3) << "the origin is not the centre of mass";
    EXPECT_EQ(double(m.c[2]), 0);
    GetParam().total(&t, 5);
    EXPECT_EQ(double(t.mass), 5);
    EXPECT_NEAR(double(t.I[0]) / 5, double(m.I[0]) / double(m.mass), tol(1e-12, 1e-5));
}

TEST_P(MoreShapes, measure_the_depth_of_a_point)
{
    Random random(3);
    dGeomID point = dCreateSphere(nullptr, 0);
    for (int i = 0; i < 300; ++i) {
        const V3 p = random.point(0.8);
        dGeomSetPosition(point, real(p.x), real(p.y), real(p.z));
        dQueryDistance d;
        dGeomGetDistance(point, geom, dInfinity, &d);
        // Inside, the search for the least depth is good to a millionth of the size.
        EXPECT_NEAR(depth_of(geom, p), -double(d.distance), tol(3e-6, 1e-4)) << i;
    }
    dGeomDestroy(point);
}

TEST_P(MoreShapes, lie_still_in_a_pile_with_every_stepper_both_ways)
{
    for (const Stepper stepper : kSteppers)
        for (const bool world_contacts : {false, true}) {
            SCOPED_TRACE(std::string(name_of(stepper)) + (world_contacts ? ", contacts of the world" : ""));
            Sim sim(stepper);
            sim.gravity(0, 0, -kG);
            sim.ground();
            sim.surface.mu = real(0.7);
            dWorldSetAngularDamping(sim.world, real(0.05));
            dWorldSetLinearDamping(sim.world, real(0.02));
            if (world_contacts) dWorldSetContactSpace(sim.world, sim.space), sim.substeps = 5;
            for (int side = 0; side < 4; ++side) {  // a pit 1.6 m wide
                const double x = side == 0 ? 1 : side == 1 ? -1 : 0, y = side == 2 ? 1 : side == 3 ? -1 : 0;
                dCreatePlane(sim.space, real(x), real(y), 0, real(-0.8));
            }
            Random random(7);
            for (int i = 0; i < 12; ++i) {
                dBodyID body = dBodyCreate(sim.world);
                dMass m;
                GetParam().mass(&m, kDensity);
                dBodySetMass(body, &m);
                dGeomSetBody(GetParam().make(sim.space), body);
                dQuaternion q;
                random.quaternion(q);
                dBodySetQuaternion(body, q);
                place(body, {0.35 * (i % 2) - 0.2, 0.3 * (i / 2 % 2) - 0.15, 0.6 + 0.7 * (i / 4)});
                sim.bodies.push_back(body);
            }
            for (int i = 0; i < 600; ++i) world_contacts ? sim.advance(0.01) : sim.step(0.01);
            double fastest = 0;
            for (dBodyID body : sim.bodies) {
                fastest = std::max(fastest, length(velocity(body)));
                EXPECT_GT(position(body).z, 0.05);
                EXPECT_LT(position(body).z, 2.5);
                EXPECT_LT(std::max(std::fabs(position(body).x), std::fabs(position(body).y)), 0.8);
            }
            EXPECT_LT(fastest, 0.2);
        }
}

// A cone of 0.4 m height on its base, its origin a quarter of it above.
struct StandingCone {
    dGeomID geom = dCreateCone(nullptr, real(0.2), real(0.4));
    StandingCone() { dGeomSetPosition(geom, 0, 0, real(0.1 - 0.001)); }
    ~StandingCone() { dGeomDestroy(geom); }
};

// Four points on the rim, each a quarter turn from the next.
void expect_four_on_the_rim(const std::vector<dContactGeom>& found)
{
    ASSERT_EQ(found.size(), 4u);
    double least = 1;
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(std::hypot(double(found[i].pos[0]), double(found[i].pos[1])), 0.2, 1e-5);
        EXPECT_NEAR(double(found[i].normal[2]), 1, 1e-9);
        EXPECT_NEAR(double(found[i].depth), 0.001, tol(1e-9, 1e-6));
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, length(vec(found[i].pos) - vec(found[j].pos)));
    }
    EXPECT_NEAR(least, 0.2 * std::sqrt(2.0), 1e-5);
}

TEST(Cone, stands_on_four_points_of_its_rim)
{
    StandingCone cone;
    dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, 0), box = dCreateBox(nullptr, 2, 2, 2);
    dGeomSetPosition(box, 0, 0, -1);
    expect_four_on_the_rim(contacts_of(cone.geom, plane));
    expect_four_on_the_rim(contacts_of(cone.geom, box));
    dGeomDestroy(plane), dGeomDestroy(box);
}

TEST(Cone, stands_on_a_flat_mesh_as_on_a_plane)
{
    static const dReal corners[] = {-9, -8, 0, 0, 9, -9, 0, 0, 9, 9, 0, 0, -9, 9, 0, 0};
    static const dTriIndex triangles[] = {0, 1, 2, 0, 2, 3};
    dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(data, corners, 4, triangles, 6);
    dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    expect_four_on_the_rim(contacts_of(StandingCone().geom, mesh));
    dGeomDestroy(mesh), dGeomTriMeshDataDestroy(data);
}

TEST(Cone, lies_on_the_line_of_its_side)
{
    dGeomID cone = dCreateCone(nullptr, real(0.2), real(0.4));
    dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, 0), box = dCreateBox(nullptr, 2, 2, 2);
    dGeomSetPosition(box, 0, 0, -1);
    // The axis leans from the ground by the angle whose tangent is radius / length.
    const double lean = std::atan2(0.2, 0.4), turn = kPi / 2 + lean;
    dQuaternion q = {real(std::cos(turn / 2)), 0, real(std::sin(turn / 2)), 0};
    dGeomSetQuaternion(cone, q);
    // 3/4 of the side's way from the apex, which touches.
    dGeomSetPosition(cone, 0, 0, real(0.3 * std::sin(lean) - 0.001));
    for (dGeomID ground : {plane, box}) {
        const std::vector<dContactGeom> found = contacts_of(cone, ground);
        ASSERT_EQ(found.size(), 2u);
        EXPECT_NEAR(length(vec(found[0].pos) - vec(found[1].pos)), std::hypot(0.2, 0.4), 1e-4);
        for (const dContactGeom& c : found) {
            EXPECT_NEAR(double(c.depth), 0.001, tol(1e-9, 1e-6));
            EXPECT_NEAR(double(c.normal[2]), 1, 1e-9);
        }
    }
    dGeomDestroy(cone), dGeomDestroy(plane), dGeomDestroy(box);
}

TEST(Cone, that_stands_does_not_move)
{
    for (const Stepper stepper : kSteppers)
        for (const bool world_contacts : {false, true}) {
            SCOPED_TRACE(std::string(name_of(stepper)) + (world_contacts ? ", contacts of the world" : ""));
            Sim sim(stepper);
            sim.gravity(0, 0, -kG);
            sim.ground();
            sim.surface.mu = real(0.6);
            if (world_contacts) dWorldSetContactSpace(sim.world, sim.space), sim.substeps = 5;
            dBodyID body = dBodyCreate(sim.world);
            dMass m;
            dMassSetCone(&m, real(kDensity), 3, real(0.2), real(0.4));
            dBodySetMass(body, &m);
            dGeomSetBody(dCreateCone(sim.space, real(0.2), real(0.4)), body);
            place(body, {0, 0, 0.1});
            for (int i = 0; i < 300; ++i) world_contacts ? sim.advance(0.01) : sim.step(0.01);
            EXPECT_LT(std::hypot(position(body).x, position(body).y), 1e-3);
            EXPECT_NEAR(position(body).z, 0.1, 5e-3);
            EXPECT_LT(length(velocity(body)), 1e-3);
            EXPECT_GT(double(dBodyGetRotation(body)[10]), 1 - 1e-5) << "it has tilted";
        }
}

TEST(Ellipsoid, touches_a_plane_where_the_closed_form_says)
{
    Random random(5);
    const double r[3] = {0.2, 0.3, 0.45};
    dGeomID egg = dCreateEllipsoid(nullptr, real(r[0]), real(r[1]), real(r[2]));
    dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, 0);
    for (int i = 0; i < 100; ++i) {
        dQuaternion q;
        random.quaternion(q);
        dGeomSetQuaternion(egg, q);
        const dReal* R = dGeomGetRotation(egg);
        double reach = 0;
        for (int k = 0; k < 3; ++k) reach += std::pow(r[k] * double(R[8 + k]), 2);
        reach = std::sqrt(reach);
        dGeomSetPosition(egg, 0, 0, real(reach - 0.01));
        V3 low;
        for (int k = 0; k < 3; ++k) {
            const double along = -r[k] * r[k] * double(R[8 + k]) / reach;
            low = low + along * V3{double(R[k]), double(R[4 + k]), double(R[8 + k])};
        }
        const std::vector<dContactGeom> found = contacts_of(egg, plane);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NEAR(double(found[0].depth), 0.01, tol(1e-12, 1e-6));
        EXPECT_LT(length(vec(found[0].pos) - (low + vec(dGeomGetPosition(egg)))), tol(1e-12, 1e-6));
    }
    dGeomDestroy(egg), dGeomDestroy(plane);
}

TEST(Ellipsoid, of_three_equal_radii_meets_what_a_sphere_meets)
{
    Random random(9);
    dGeomID egg = dCreateEllipsoid(nullptr, real(0.4), real(0.4), real(0.4)),
            ball = dCreateSphere(nullptr, real(0.4));
    dGeomID others[] = {dCreateSphere(nullptr, real(0.3)),
                        dCreateBox(nullptr, 1, real(0.5), real(0.7)),
                        dCreateCapsule(nullptr, real(0.2), real(0.6)),
                        dCreateCylinder(nullptr, real(0.3), 1),
                        dCreateCone(nullptr, real(0.5), 1),
                        dCreatePlane(nullptr, 0, 0, 1, 0)};
    for (dGeomID other : others)
        for (int i = 0; i < 60; ++i) {
            dQuaternion q;
            random.quaternion(q);
            const V3 p = 0.7 * random.point(1);
            dGeomSetQuaternion(egg, q);
            for (dGeomID g : {egg, ball}) dGeomSetPosition(g, real(p.x), real(p.y), real(p.z));
            const std::vector<dContactGeom> one = contacts_of(egg, other), two = contacts_of(ball, other);
            if (two.empty() || double(two[0].depth) < 1e-5 || double(two[0].depth) > 0.15) continue;
            ASSERT_EQ(one.size(), 1u) << dGeomGetClass(other);
            EXPECT_NEAR(double(one[0].depth), double(two[0].depth), tol(1e-6, 1e-4)) << dGeomGetClass(other);
            EXPECT_LT(length(vec(one[0].normal) - vec(two[0].normal)), tol(1e-3, 1e-2))
                << dGeomGetClass(other);
        }
    for (dGeomID g : others) dGeomDestroy(g);
    dGeomDestroy(egg), dGeomDestroy(ball);
}

TEST(Ellipsoid, rolls_down_a_slope_as_a_ball_of_equal_radii_does)
{
    double way[2];
    for (const bool egg : {false, true}) {
        Sim sim(Stepper::kExact);
        sim.gravity(kG * std::sin(0.2), 0, -kG * std::cos(0.2));
        sim.ground();
        sim.surface.mu = real(2);
        dBodyID body = dBodyCreate(sim.world);
        dMass m;
        dMassSetEllipsoidTotal(&m, 1, real(0.3), real(0.3), real(0.3));
        dBodySetMass(body, &m);
        dGeomSetBody(egg ? dCreateEllipsoid(sim.space, real(0.3), real(0.3), real(0.3))
                         : dCreateSphere(sim.space, real(0.3)),
                     body);
        place(body, {0, 0, 0.3});
        sim.steps(200, 0.005);
        way[egg] = position(body).x;
    }
    EXPECT_NEAR(way[0], 0.5 * 5.0 / 7 * kG * std::sin(0.2), 0.02);
    EXPECT_NEAR(way[1], way[0], 1e-3);
}

}  // namespace
}  // namespace epode::physics
