// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Files and calls that are wrong: refused with Gazebo's messages, and the engine goes on. Creating and removing leaves nothing behind.
#include "tests/gazebo/engine.h"

#include <unistd.h>

#include <fstream>

namespace {

double resident_bytes()
{
    std::ifstream file("/proc/self/statm");
    double all = 0, resident = 0;
    file >> all >> resident;
    return resident * double(sysconf(_SC_PAGESIZE));
}

// The box of 1 m, as triangles.
void make_cube(gz::common::Mesh& mesh)
{
    gz::common::SubMesh part;
    for (int i = 0; i < 8; ++i) part.AddVertex((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5);
    const unsigned corners[] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    for (unsigned corner : corners) part.AddIndex(corner);
    mesh.AddSubMesh(part);
}

// A slope: height = x + y + 2, over 4 m by 4 m.
class Slope : public gz::common::HeightmapData {
  public:
    void FillHeightMap(int, unsigned side, const gz::math::Vector3d&, const gz::math::Vector3d&, bool flip,
                       std::vector<float>& heights) override
    {
        heights.clear();
        for (unsigned row = 0; row < side; ++row)
            for (unsigned column = 0; column < side; ++column) {
                const double x = -2 + 4.0 * column / (side - 1), y = 2 - 4.0 * row / (side - 1);
                heights.push_back(float(x + (flip ? -y : y) + 2));
            }
    }
    std::string Filename() const { return "slope"; }
    unsigned Height() const override { return 9; }
    unsigned Width() const override { return 9; }
    float MaxElevation() const override { return 6; }
};

TEST_F(Gazebo, wrong_files_leave_the_rest_of_the_world)
{
    const std::string heavy = "<model name='bad'>" + link("zero", "0 0 1 0 0 0", "", 0, 0) + "</model>";
    const std::string mesh = body("mesh", "0 0 1 0 0 0", "<mesh><uri>nowhere/at/all.dae</uri></mesh>");
    const WorldPtr world = world_of(plane() + mesh + body("good", "3 0 1 0 0 0", box(1)));
    ASSERT_TRUE(world);
    EXPECT_EQ(link_of(world, "mesh")->GetShapeCount(), 0u);
    sdf::Root root;
    root.LoadSdfString("<sdf version='1.9'>" + heavy + "</sdf>");
    if (root.Model()) {
        const ModelPtr model = world->ConstructModel(*root.Model());
        ASSERT_TRUE(model);
        EXPECT_EQ(model->GetLinkCount(), 0u);
    }
    step(world, 2000);
    EXPECT_NEAR(place(link_of(world, "good")).z(), 0.5, 1e-3);
}

TEST_F(Gazebo, wrong_calls_are_refused)
{
    const WorldPtr world = world_of(body("a", "0 0 1 0 0 0", box(1)));
    const LinkPtr link = link_of(world, "a");
    EXPECT_FALSE(link->AttachPlaneShape("p", Vec3(0, 0, 1)));
    EXPECT_FALSE(link->AttachSphereShape("s", -1));
    EXPECT_FALSE(link->AttachSphereShape("c", 1)) << "there is a collision of that name";
    EXPECT_EQ(link->GetShapeCount(), 1u);
    sdf::Joint joint;
    joint.SetName("j"), joint.SetType(sdf::JointType::REVOLUTE);
    joint.SetParentLinkName("l"), joint.SetChildLinkName("l");
    EXPECT_FALSE(world->GetModel("a")->ConstructJoint(joint));
    joint.SetParentLinkName("nobody");
    EXPECT_FALSE(world->GetModel("a")->ConstructJoint(joint));
    world->SetSolver("magic");
    EXPECT_EQ(world->GetSolver(), "hybrid");
    world->SetSolver("PGS");
    EXPECT_EQ(world->GetSolver(), "pgs");
    world->SetCollisionDetector("fcl");
    EXPECT_EQ(world->GetCollisionDetector(), "epode");
    EXPECT_FALSE(engine_->ConstructEmptyWorld(world->GetName()));
    Pose3 nowhere = Pose3::Identity();
    nowhere.translation().x() = NAN;
    link->FindFreeGroup()->SetWorldPose(nowhere);
    EXPECT_EQ(place(link).x(), 0);
}

TEST_F(Gazebo, pieces_make_the_same_as_a_whole)
{
    const WorldPtr world = engine_->ConstructEmptyWorld("pieces");
    const ModelPtr ground = world->ConstructEmptyModel("ground");
    sdf::Model plain;
    plain.SetName("static"), plain.SetStatic(true);
    const ModelPtr fixed = world->ConstructModel(plain);
    sdf::Link piece;
    piece.SetName("l");
    const LinkPtr floor = fixed->ConstructLink(piece);
    ASSERT_TRUE(floor->AttachPlaneShape("p", Vec3(0, 0, 1)));
    const LinkPtr box = ground->ConstructEmptyLink("box");
    ASSERT_TRUE(box->AttachBoxShape("b", Vec3(1, 1, 1)));
    box->FindFreeGroup()->SetWorldPose(Pose3(Eigen::Translation3d(0, 0, 0.6)));
    step(world, 1000);
    EXPECT_NEAR(place(box).z(), 0.5, 1e-3);
}

TEST_F(Gazebo, meshes_and_height_maps)
{
    const WorldPtr world = world_of(
        plane() +
        "<model name='hill'><static>true</static><pose>10 0 0 0 0 0</pose>"
        "<link name='l'/></model>" +
        "<model name='m'>" + link("l", "0 0 0.6 0 0 0") + "</model>" + "<model name='ball'>" +
        link("l", "10.4 -0.2 2.5465 0 0 0", "<sphere><radius>0.2</radius></sphere>", 1, 0.016) + "</model>");
    gz::common::Mesh triangles;
    make_cube(triangles);
    const auto mesh =
        link_of(world, "m")->AttachMeshShape("mesh", triangles, Pose3::Identity(), Vec3(1, 1, 0.5));
    ASSERT_TRUE(mesh);
    EXPECT_NEAR(mesh->GetSize().z(), 1, 1e-12);
    EXPECT_NEAR(mesh->GetScale().z(), 0.5, 0);
    Slope slope;
    ASSERT_TRUE(link_of(world, "hill")->AttachHeightmapShape("h", slope, Pose3::Identity(), Vec3(4, 4, 6)));
    step(world, 300);
    // Turned over, rows run up from the least y: the height at (0.4, -0.2) from the middle is 2.2 m, on a slope of normal (-1, -1, 1).
    const Vec3 at = place(link_of(world, "ball")) - Vec3(10, 0, 0);
    const double height = (at.z() - at.x() - at.y() - 2) / std::sqrt(3.0);
    EXPECT_NEAR(height, 0.2, 2e-3);
    // A ball that rolls from rest: v = 5/7 g sin(slope) t.
    const double speed = link_of(world, "ball")->FrameDataRelativeToWorld().linearVelocity.norm();
    EXPECT_NEAR(speed, 5.0 / 7 * kGravity * std::sqrt(2.0 / 3) * 0.3, 0.03);
    step(world, 700);
    EXPECT_NEAR(place(link_of(world, "m")).z(), 0.25, 1e-3);
}

TEST_F(Gazebo, creating_and_removing_leaves_nothing)
{
    const char* const wanted = std::getenv("EPODE_GAZEBO_CYCLES");
    const int cycles = wanted ? std::atoi(wanted) : 1000;
    const WorldPtr world = world_of(plane());
    sdf::Root root;
    root.LoadSdfString(
        "<sdf version='1.9'><model name='m'>" + link("a", "0 0 0.5 0 0 0", box(1)) +
        link("b", "1.5 0 0.5 0 0 0", box(1)) +
        "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis><xyz>0 1 0</xyz>"
        "</axis></joint></model></sdf>");
    ASSERT_TRUE(root.Model());
    double before = 0;
    for (int i = 0; i < cycles; ++i) {
        if (i == cycles / 2) before = resident_bytes();
        const ModelPtr model = world->ConstructModel(*root.Model());
        ASSERT_TRUE(model);
        step(world, 2);
        ASSERT_TRUE(model->Remove());
    }
    EXPECT_EQ(world->GetModelCount(), 1u);
    EXPECT_LT(resident_bytes() - before, 1e6);
}

}  // namespace
