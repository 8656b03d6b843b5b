// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies, shapes, contacts and groups through the features of gz-physics, against closed forms.
#include "tests/gazebo/engine.h"

namespace {

TEST_F(Gazebo, falls_rests_and_sleeps)
{
    const WorldPtr world = world_of(plane() + body("b", "0 0 2 0 0 0", box(1)));
    const LinkPtr link = link_of(world, "b");
    step(world, 300);
    const double h = 1e-3, t = 0.3;
    EXPECT_NEAR(place(link).z(), 2 - kGravity * t * t / 2, kGravity * t * h);
    EXPECT_NEAR(link->FrameDataRelativeToWorld().linearVelocity.z(), -kGravity * t, 1e-9);
    EXPECT_NEAR(link->FrameDataRelativeToWorld().linearAcceleration.z(), -kGravity, 1e-9);
    step(world, 2700);
    EXPECT_NEAR(place(link).z(), 0.5, 1e-3);
    auto output = step(world, 1);
    EXPECT_EQ(output.Get<physics::WorldPoses>().entries.size(), 2u);
    EXPECT_TRUE(output.Get<physics::ChangedWorldPoses>().entries.empty());
}

TEST_F(Gazebo, kinds_of_shapes_rest_on_their_weight)
{
    const struct {
        const char *geometry, *pose;
        double height;
    } kinds[] = {{"<sphere><radius>0.3</radius></sphere>", "0 0 0.31 0 0 0", 0.3},
                 {"<box><size>0.4 0.6 0.8</size></box>", "2 0 0.41 0 0 0", 0.4},
                 {"<cylinder><radius>0.3</radius><length>0.5</length></cylinder>", "4 0 0.26 0 0 0", 0.25},
                 {"<capsule><radius>0.2</radius><length>0.6</length></capsule>",
                  "6 0 0.21 1.5707963267948966 0 0", 0.2},
                 {"<ellipsoid><radii>0.4 0.3 0.2</radii></ellipsoid>", "8 0 0.21 0 0 0", 0.2}};
    std::string models = plane();
    for (const auto& kind : kinds) models += body(std::to_string(&kind - kinds), kind.pose, kind.geometry);
    const WorldPtr world = world_of(models);
    step(world, 200);
    for (int i = 0; i < 5; ++i)
        EXPECT_NEAR(place(link_of(world, std::to_string(i))).z(), kinds[i].height, 1e-3) << i;
    double force = 0;
    for (const auto& contact : world->GetContactsFromLastStep()) {
        using Extra = physics::World3d<AllFeatures>::ExtraContactData;
        const auto* const extra = contact.Query<Extra>();
        ASSERT_TRUE(extra);
        EXPECT_NEAR(std::abs(extra->normal.z()), 1, 1e-6);
        force += std::abs(extra->force.z());
    }
    EXPECT_NEAR(force, 5 * kGravity, 0.02 * 5 * kGravity);
}

TEST_F(Gazebo, masks_and_models_decide_what_touches)
{
    const std::string ball = "<sphere><radius>0.1</radius></sphere>";
    const auto bits = [](int mask) {
        return "<surface><contact><collide_bitmask>" + std::to_string(mask) +
               "</collide_bitmask></contact></surface>";
    };
    const std::string pair = "<model name='pair'>" + link("under", "5 0 0.1 0 0 0", ball) +
                             link("over", "5 0 0.15 0 0 0", ball) + "</model>";
    const WorldPtr world = world_of(plane() + body("through", "0 0 1 0 0 0", ball, bits(0)) +
                                    body("stays", "2 0 1 0 0 0", ball, bits(2)) + pair);
    const auto shape = link_of(world, "through")->GetShape(0);
    EXPECT_EQ(shape->GetCollisionFilterMask(), 0);
    step(world, 1000);
    EXPECT_LT(place(link_of(world, "through")).z(), -1);
    EXPECT_NEAR(place(link_of(world, "stays")).z(), 0.1, 1e-3);
    // Links of one model pass through each other.
    EXPECT_NEAR(place(link_of(world, "pair", "over")).z(), 0.1, 1e-3);
    EXPECT_NEAR(place(link_of(world, "pair", "under")).z(), 0.1, 1e-3);
}

TEST_F(Gazebo, callback_changes_friction)
{
    const WorldPtr world = world_of(plane() + body("b", "0 0 0.25 0 0 0", box(0.5)));
    world->SetGravity(Vec3(kGravity * 0.5, 0, -kGravity));
    const LinkPtr link = link_of(world, "b");
    step(world, 300);
    EXPECT_NEAR(place(link).x(), 0, 1e-3);  // mu = 1 holds half of the weight
    std::size_t calls = 0;
    world->AddContactPropertiesCallback("ice", [&](const auto& contact, std::size_t, auto& surface) {
        using Point = physics::World3d<AllFeatures>::ContactPoint;
        EXPECT_TRUE(contact.template Get<Point>().collision1);
        surface.frictionCoeff = 0.1, surface.secondaryFrictionCoeff = 0.1;
        ++calls;
    });
    const double before = link->FrameDataRelativeToWorld().linearVelocity.x();
    step(world, 200);
    EXPECT_GT(calls, 100u);
    // Sliding: a = g_x - mu g_z.
    EXPECT_NEAR(link->FrameDataRelativeToWorld().linearVelocity.x() - before, 0.2 * kGravity * 0.4, 0.02);
    EXPECT_TRUE(world->RemoveContactPropertiesCallback("ice"));
    EXPECT_FALSE(world->RemoveContactPropertiesCallback("ice"));
}

TEST_F(Gazebo, free_groups_move_as_one)
{
    const std::string two =
        "<model name='two'>" + link("a", "0 0 1 0 0 0") + link("b", "1 0 1 0 0 0") +
        "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis><xyz>0 1 0</xyz>"
        "</axis></joint></model>";
    const WorldPtr world = world_of(two);
    world->SetGravity(Vec3(0, 0, 0));
    const ModelPtr model = world->GetModel("two");
    const auto group = model->FindFreeGroup();
    ASSERT_TRUE(group);
    EXPECT_EQ(group->RootLink()->GetName(), "a");
    Pose3 pose = Pose3::Identity();
    pose.translate(Vec3(3, 4, 5));
    pose.rotate(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()));
    group->SetWorldPose(pose);
    EXPECT_LT((place(model->GetLink("b")) - Vec3(3, 5, 5)).norm(), 1e-12);
    group->SetWorldLinearVelocity(Vec3(1, 0, 0));
    group->SetWorldAngularVelocity(Vec3(0, 0, 2));
    // v_b = v + w x r.
    EXPECT_LT((model->GetLink("b")->FrameDataRelativeToWorld().linearVelocity - Vec3(1 - 2, 0, 0)).norm(),
              1e-12);
    EXPECT_NEAR(model->GetJoint("j")->GetVelocity(0), 0, 1e-12);
    const std::string held =
        "<model name='m'>" + link("a", "0 0 1 0 0 0") +
        "<joint name='j' type='fixed'><parent>world</parent><child>a</child></joint></model>";
    EXPECT_FALSE(world_of(held)->GetModel("m")->FindFreeGroup());
}

TEST_F(Gazebo, external_forces_are_newtons)
{
    const WorldPtr world = world_of(body("b", "0 0 1 0 0 0", box(1)));
    world->SetGravity(Vec3(0, 0, 0));
    const LinkPtr link = link_of(world, "b");
    for (int i = 0; i < 100; ++i) {
        link->AddExternalForce(Vec3(3, 0, 0));
        link->AddExternalTorque(Vec3(0, 0, 0.5));
        step(world, 1);
    }
    const auto data = link->FrameDataRelativeToWorld();
    EXPECT_NEAR(data.linearVelocity.x(), 3 * 0.1, 1e-9);
    EXPECT_NEAR(data.angularVelocity.z(), 0.5 / 0.1 * 0.1, 1e-9);
}

TEST_F(Gazebo, removal_in_mid_run)
{
    const WorldPtr world =
        world_of(plane() + body("under", "0 0 0.5 0 0 0", box(1)) + body("over", "0 0 1.5 0 0 0", box(1)));
    step(world, 1000);
    const ModelPtr under = world->GetModel("under");
    const LinkPtr stale = under->GetLink(0);
    EXPECT_TRUE(under->Remove());
    EXPECT_TRUE(under->Removed());
    EXPECT_EQ(world->GetModelCount(), 2u);
    EXPECT_FALSE(world->GetModel("under"));
    EXPECT_FALSE(under->Remove());
    stale->AddExternalForce(Vec3(1, 0, 0));  // refused
    EXPECT_EQ(stale->GetShapeCount(), 0u);
    step(world, 2000);
    EXPECT_NEAR(place(link_of(world, "over")).z(), 0.5, 1e-3);
    EXPECT_FALSE(world->RemoveModel("none"));
    EXPECT_TRUE(world->RemoveModel("over"));
}

TEST_F(Gazebo, nested_models_keep_their_frames)
{
    const std::string outer =
        "<model name='outer'><pose>1 2 3 0 0 1.5707963267948966</pose>" + link("a", "0 0 0 0 0 0") +
        "<model name='inner'><pose>1 0 0 0 0 0</pose>" + link("b", "0 0 1 0 0 0") +
        "</model><joint name='j' type='fixed'><parent>a</parent><child>inner::b</child></joint></model>";
    const WorldPtr world = world_of(outer);
    const ModelPtr model = world->GetModel("outer");
    ASSERT_EQ(model->GetNestedModelCount(), 1u);
    const LinkPtr inner = model->GetNestedModel("inner")->GetLink("b");
    EXPECT_LT((place(inner) - Vec3(1, 3, 4)).norm(), 1e-12);
    ASSERT_TRUE(model->GetJoint("j"));
    step(world, 200);
    const Vec3 apart = place(inner) - place(model->GetLink("a"));
    EXPECT_LT((apart - Vec3(0, 1, 1)).norm(), 1e-6);
    EXPECT_TRUE(model->RemoveNestedModel("inner"));
    EXPECT_EQ(model->GetJointCount(), 0u);
    step(world, 10);
}

TEST_F(Gazebo, boxes_around_shapes)
{
    const WorldPtr world = world_of(body("b", "1 0 0 0 0 0.7853981633974483", box(2)));
    const auto of_link = link_of(world, "b")->GetAxisAlignedBoundingBox();
    EXPECT_NEAR(of_link.max().x(), 1 + std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(of_link.min().z(), -1, 1e-9);
    const auto shape = link_of(world, "b")->GetShape(0)->CastToBoxShape();
    ASSERT_TRUE(shape);
    shape->SetSize(Vec3(1, 1, 4));
    EXPECT_NEAR(link_of(world, "b")->GetAxisAlignedBoundingBox().max().z(), 2, 1e-9);
    shape->SetSize(Vec3(-1, 1, 1));  // refused
    EXPECT_NEAR(shape->GetSize().z(), 4, 0);
    EXPECT_FALSE(link_of(world, "b")->GetShape(0)->CastToSphereShape());
}

TEST_F(Gazebo, same_calls_give_the_same_bits)
{
    const std::string models =
        plane() + body("a", "0 0 1 0.3 0.2 0.1", box(0.5)) + body("b", "0.1 0 2 0 0.4 0", box(0.5));
    const WorldPtr one = world_of(models), two = world_of(models);
    step(one, 1500), step(two, 1500);
    for (const char* name : {"a", "b"}) EXPECT_EQ(place(link_of(one, name)), place(link_of(two, name)));
}

}  // namespace
