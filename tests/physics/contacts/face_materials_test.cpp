// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Materials of triangles and of cells: a block decelerates with the friction of what it is on, in every stepper; files
// and clones have them, and what is refused changes nothing.
#include <vector>

#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kIce = 0.05, kAsphalt = 0.5, kGravity = 9.81;

dMaterial material_with(double friction)
{
    dMaterial m;
    dMaterialInit(&m, sizeof m);
    m.friction = real(friction), m.friction_rule = dCombineMinimum, m.priority = 1;
    return m;
}

void give_faces(dGeomID geom, const std::vector<unsigned char>& numbers)
{
    const dMaterial ice = material_with(kIce), asphalt = material_with(kAsphalt);
    ASSERT_EQ(dGeomSetFaceMaterial(geom, 1, &ice), 1);
    ASSERT_EQ(dGeomSetFaceMaterial(geom, 7, &asphalt), 1);
    ASSERT_EQ(dGeomSetFaceMaterialNumbers(geom, numbers.data(), int(numbers.size())), 1);
}

// Ice where x < 0, asphalt beyond; each of two triangles.
struct MeshFloor {
    MeshFloor()
    {
        static const double at[6][3] = {{-20, -5, 0}, {0, -5, 0}, {20, -5, 0},
                                        {-20, 5, 0},  {0, 5, 0},  {20, 5, 0}};
        static const dTriIndex triangles[12] = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
        data = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildDouble(data, at, 3 * sizeof(double), 6, triangles, 12, 3 * sizeof(dTriIndex));
    }
    ~MeshFloor() { dGeomTriMeshDataDestroy(data); }
    dTriMeshDataID data;
};

dGeomID first_of(dSpaceID space, int number)
{
    for (int i = 0; i < dSpaceGetNumGeoms(space); ++i)
        if (dGeomGetClass(dSpaceGetGeom(space, i)) == number) return dSpaceGetGeom(space, i);
    return nullptr;
}

dMaterial material_of(dGeomID geom, int number)
{
    dMaterial m{};
    m.struct_size = sizeof m;
    number == 0 ? dGeomGetMaterial(geom, &m) : dGeomGetFaceMaterial(geom, number, &m);
    return m;
}

class FaceMaterials : public testing::TestWithParam<Stepper> {};

double speed_after(WorldContactsSim& sim, double x, double speed, int steps)
{
    const dBodyID block = sim.box({x, 0, 0.1}, {0.4, 0.4, 0.2}, 2);
    sim.run(30);
    velocity(block, {speed, 0, 0});
    sim.run(steps);
    return vec(dBodyGetLinearVel(block)).x;
}

TEST_P(FaceMaterials, a_block_on_a_mesh_has_the_friction_of_the_triangle_below)
{
    for (const bool ice : {true, false}) {
        WorldContactsSim sim(GetParam());
        const MeshFloor floor;
        give_faces(dCreateTriMesh(sim.space, floor.data, nullptr, nullptr, nullptr), {1, 1, 7, 7});
        const double mu = ice ? kIce : kAsphalt;
        EXPECT_NEAR(speed_after(sim, ice ? -5 : 5, 4, 30), 4 - mu * kGravity * 0.5, 0.02) << ice;
    }
}

// v^2 falls by 2 mu g for each metre of ice, then of asphalt.
TEST_P(FaceMaterials, a_block_that_comes_from_ice_to_asphalt_is_braked_there)
{
    WorldContactsSim sim(GetParam());
    const MeshFloor floor;
    give_faces(dCreateTriMesh(sim.space, floor.data, nullptr, nullptr, nullptr), {1, 1, 7, 7});
    const dBodyID block = sim.box({-2, 0, 0.1}, {0.4, 0.4, 0.2}, 2);
    sim.run(30);
    velocity(block, {4, 0, 0});
    sim.run(120);
    const double at_seam = 4 * 4 - 2 * kIce * kGravity * 2;
    EXPECT_NEAR(position(block).x, at_seam / (2 * kAsphalt * kGravity), 0.06);
}

TEST_P(FaceMaterials, a_block_on_a_field_has_the_friction_of_the_cell_below)
{
    const std::vector<double> flat(3 * 2, 0);
    for (const bool ice : {true, false}) {
        WorldContactsSim sim(GetParam());
        const dHeightfieldDataID field = dGeomHeightfieldDataCreate();
        dGeomHeightfieldDataBuildDouble(field, flat.data(), 1, 40, 10, 3, 2, 1, 0, 1, 0);
        const dGeomID geom = dCreateHeightfield(sim.space, field, 1);
        dMatrix3 upright;
        dRFromAxisAndAngle(upright, 1, 0, 0, real(kPi / 2));
        dGeomSetRotation(geom, upright);
        give_faces(geom, {1, 7});
        const double mu = ice ? kIce : kAsphalt;
        EXPECT_NEAR(speed_after(sim, ice ? -5 : 5, 4, 30), 4 - mu * kGravity * 0.5, 0.02) << ice;
        dGeomDestroy(geom);
        dGeomHeightfieldDataDestroy(field);
    }
}

// A sphere geom's material is of kind 3, and the plane has one against it; the other block is of no kind.
TEST_P(FaceMaterials, of_a_pair_count_alone_whatever_the_two_have_and_against_nothing_else)
{
    WorldContactsSim sim(GetParam());
    const dGeomID plane = dCreatePlane(sim.space, 0, 0, 1, 0);
    const dMaterial rough = material_with(kAsphalt), ice = material_with(kIce);
    dGeomSetMaterial(plane, &rough);
    ASSERT_EQ(dGeomSetFaceMaterial(plane, 3, &ice), 1);
    dBodyID blocks[3];
    for (int i = 0; i < 3; ++i) {
        blocks[i] = sim.box({0, 2.0 * i, 0.1}, {0.4, 0.4, 0.2}, 2);
        dMaterial own = material_with(kAsphalt);
        own.kind = i == 0 ? 3 : i == 1 ? 4 : 0;
        own.priority = 5;
        ASSERT_EQ(dGeomSetMaterial(dBodyGetFirstGeom(blocks[i]), &own), 1);
    }
    sim.run(30);
    for (dBodyID block : blocks) velocity(block, {4, 0, 0});
    sim.run(30);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(vec(dBodyGetLinearVel(blocks[i])).x, 4 - (i == 0 ? kIce : kAsphalt) * kGravity * 30 * kH,
                    0.02)
            << i;
    dMaterial wrong = rough;
    wrong.kind = 256;
    EXPECT_EQ(dGeomSetMaterial(plane, &wrong), 0);
}

TEST_P(FaceMaterials, of_a_pair_and_their_kinds_are_in_files)
{
    WorldContactsSim sim(GetParam());
    const dGeomID plane = dCreatePlane(sim.space, 0, 0, 1, 0);
    const dMaterial ice = material_with(kIce);
    ASSERT_EQ(dGeomSetFaceMaterial(plane, 200, &ice), 1);
    dMaterial own = material_with(kAsphalt);
    own.kind = 200, own.bounce_rule = dCombineProduct;
    ASSERT_EQ(dGeomSetMaterial(dBodyGetFirstGeom(sim.box({0, 0, 0.1}, {0.4, 0.4, 0.2}, 2)), &own), 1);
    std::vector<unsigned char> file(dWorldSaveToBuffer(sim.world, nullptr, nullptr, 0));
    ASSERT_EQ(dWorldSaveToBuffer(sim.world, nullptr, file.data(), file.size()), file.size());
    dSpaceID space = nullptr;
    const dWorldID copy = dWorldLoadFromBuffer(file.data(), file.size(), &space);
    ASSERT_NE(copy, nullptr);
    const dMaterial box = material_of(first_of(space, dBoxClass), 0);
    EXPECT_EQ(box.kind, 200);
    EXPECT_EQ(box.bounce_rule, dCombineProduct);
    EXPECT_EQ(material_of(first_of(space, dPlaneClass), 200).friction, real(kIce));
    dSpaceDestroy(space), dWorldDestroy(copy);
}

TEST_P(FaceMaterials, a_file_keeps_them_and_goes_on_with_the_same_bits)
{
    WorldContactsSim sim(GetParam());
    const MeshFloor floor;
    give_faces(dCreateTriMesh(sim.space, floor.data, nullptr, nullptr, nullptr), {1, 1, 7, 7});
    const dBodyID block = sim.box({-0.4, 0, 0.1}, {0.4, 0.4, 0.2}, 2);
    velocity(block, {2, 0.5, 0});
    sim.run(5);
    std::vector<unsigned char> file(dWorldSaveToBuffer(sim.world, nullptr, nullptr, 0));
    ASSERT_EQ(dWorldSaveToBuffer(sim.world, nullptr, file.data(), file.size()), file.size());
    dSpaceID space = nullptr;
    const dWorldID copy = dWorldLoadFromBuffer(file.data(), file.size(), &space);
    ASSERT_NE(copy, nullptr);
    unsigned char numbers[4] = {};
    const dGeomID mesh = first_of(space, dTriMeshClass);
    EXPECT_EQ(dGeomGetFaceMaterialNumbers(mesh, numbers, 4), 4);
    EXPECT_EQ(numbers[2], 7);
    sim.run(40);
    for (int i = 0; i < 40; ++i) {
        const int stepped = GetParam() == Stepper::kExact   ? dWorldStep(copy, real(kH))
                            : GetParam() == Stepper::kQuick ? dWorldQuickStep(copy, real(kH))
                                                            : dWorldStepFast1(copy, real(kH), sim.substeps);
        ASSERT_EQ(stepped, 1);
    }
    std::vector<unsigned char> one(dWorldGetStateSize(sim.world)), two(dWorldGetStateSize(copy));
    ASSERT_EQ(dWorldGetState(sim.world, one.data(), one.size()), 1);
    ASSERT_EQ(dWorldGetState(copy, two.data(), two.size()), 1);
    EXPECT_EQ(one, two);
    const dTriMeshDataID loaded = dGeomTriMeshGetData(mesh);
    dSpaceDestroy(space), dWorldDestroy(copy), dGeomTriMeshDataDestroy(loaded);
}

INSTANTIATE_TEST_SUITE_P(Steppers, FaceMaterials, testing::ValuesIn(kSteppers), case_name);

TEST(FaceMaterialCalls, refuses_what_is_no_surface_no_number_and_no_count_and_changes_nothing)
{
    dInitODE();
    const MeshFloor floor;
    const dGeomID mesh = dCreateTriMesh(nullptr, floor.data, nullptr, nullptr, nullptr);
    const dGeomID ball = dCreateSphere(nullptr, 1);
    give_faces(mesh, {1, 1, 7, 7});
    const dMaterial good = material_with(1);
    dMaterial bad = good;
    bad.cross_friction = -1;
    const unsigned char numbers[4] = {};
    dSetMessageHandler([](int, const char*, va_list) {});
    EXPECT_EQ(dGeomSetFaceMaterialNumbers(ball, numbers, 1), 0);
    EXPECT_EQ(dGeomSetFaceMaterial(mesh, 0, &good), 0);
    EXPECT_EQ(dGeomSetFaceMaterial(mesh, 256, &good), 0);
    EXPECT_EQ(dGeomSetFaceMaterial(mesh, 1, &bad), 0);
    EXPECT_EQ(dGeomSetMaterial(ball, &bad), 0);
    EXPECT_EQ(dGeomSetFaceMaterialNumbers(mesh, numbers, 3), 0);
    EXPECT_EQ(dGeomSetFaceMaterialNumbers(mesh, nullptr, 4), 0);
    unsigned char kept[4] = {};
    EXPECT_EQ(dGeomGetFaceMaterialNumbers(mesh, kept, 4), 4);
    EXPECT_EQ(kept[0], 1);
    dMaterial read;
    dMaterialInit(&read, sizeof read);
    EXPECT_EQ(dGeomGetFaceMaterial(mesh, 1, &read), 1);
    EXPECT_EQ(read.friction, real(kIce));
    dSetMessageHandler(nullptr);
    dGeomDestroy(mesh), dGeomDestroy(ball);
    dCloseODE();
}

}  // namespace
}  // namespace epode::physics
