// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What docs/guide/gz_sim.md says of the elements <ode> and <surface>, by what bodies then do.
#include "tests/gazebo/engine.h"

namespace {

class Values : public Gazebo {
  protected:
    static std::string ode(const std::string& solver, const std::string& constraints = "")
    {
        return "<physics name='p' type='ode'><max_step_size>0.001</max_step_size><real_time_factor>1"
               "</real_time_factor><ode><solver>" +
               solver + "</solver><constraints>" + constraints + "</constraints></ode></physics>";
    }
    // The height of a box of 1 m after that many steps on a plane, let go at z.
    double height(const std::string& physics, double z, int steps, const std::string& surface = "")
    {
        const WorldPtr world =
            world_of(plane() + body("b", "0 0 " + std::to_string(z) + " 0 0 0", box(1), surface), physics);
        step(world, steps);
        return place(link_of(world, "b")).z();
    }
    // Its speed after 0.2 s under gravity that leans by so much of its weight.
    Vec3 slide(const std::string& friction, double along_x, double along_y)
    {
        const std::string surface = "<surface><friction><ode>" + friction + "</ode></friction></surface>";
        const WorldPtr world = world_of(plane() + body("b", "0 0 0.5 0 0 0", box(1), surface));
        step(world, 100);
        world->SetGravity(kGravity * Vec3(along_x, along_y, -1));
        step(world, 200);
        return link_of(world, "b")->FrameDataRelativeToWorld().linearVelocity;
    }
    // How high a ball of 0.1 m bounces that fell 1 m.
    double bounce(const std::string& surface)
    {
        const std::string ball = "<sphere><radius>0.1</radius></sphere>";
        const WorldPtr world = world_of(plane() + body("b", "0 0 1.1 0 0 0", ball, surface));
        step(world, 500);  // it lands after 0.45 s
        double highest = 0;
        for (int i = 0; i < 500; ++i)
            step(world, 1), highest = std::max(highest, place(link_of(world, "b")).z());
        return highest - 0.1;
    }
};

TEST_F(Values, solvers_by_name)
{
    for (const char* name : {"quick", "world", "hybrid", "substeps"}) {
        const WorldPtr world = world_of(plane() + body("b", "0 0 0.6 0 0 0", box(1)),
                                        ode(std::string("<type>") + name + "</type>"));
        EXPECT_EQ(world->GetSolver(), name);
        step(world, 1000);
        EXPECT_NEAR(place(link_of(world, "b")).z(), 0.5, 2e-3) << name;
    }
    EXPECT_EQ(world_of(plane())->GetSolver(), "hybrid");
}

TEST_F(Values, sweeps_and_their_relaxation)
{
    const auto stack = [this](const std::string& more) {
        std::string models = plane();
        for (int i = 0; i < 5; ++i)
            models +=
                body("b" + std::to_string(i), "0 0 " + std::to_string(0.51 * i + 0.26) + " 0 0 0", box(0.5));
        const WorldPtr world = world_of(models, ode("<type>quick</type>" + more));
        step(world, 300);
        return place(link_of(world, "b4")).z();
    };
    const double usual = stack("");  // what is left out of a <solver> has SDF's own values
    EXPECT_EQ(stack("<iters>50</iters><sor>1.3</sor>"), usual);
    EXPECT_NE(stack("<iters>3</iters><sor>1.3</sor>"), usual);
    EXPECT_NE(stack("<iters>50</iters><sor>0.7</sor>"), usual);
}

TEST_F(Values, errors_are_corrected_as_constraints_say)
{
    const std::string level = "<contact_surface_layer>0</contact_surface_layer>";
    const std::string exact = "<type>world</type>";
    for (const double erp : {0.1, 0.4}) {
        // A box 0.1 m deep goes up by erp of that in a step.
        const double z = height(ode(exact, level + "<erp>" + std::to_string(erp) + "</erp>"), 0.4, 1);
        EXPECT_NEAR(z, 0.4 + erp * 0.1, 2e-4);
    }
    // Sweeps give it a velocity for that, of no more than they may.
    const std::string slow = "<contact_max_correcting_vel>0.1</contact_max_correcting_vel>";
    EXPECT_NEAR(height(ode("<type>quick</type>", slow), 0.4, 200), 0.42, 2e-3);
    const std::string layer = "<contact_surface_layer>0.02</contact_surface_layer>";
    EXPECT_NEAR(height(ode(exact, layer), 0.5, 1500), 0.48, 1e-3);
}

TEST_F(Values, softness_is_a_spring)
{
    // k = erp / (h cfm) = 0.2 / (0.001 0.1); it holds 1 kg.
    const std::string held =
        "<model name='m'>" + link("a", "0 0 1 0 0 0") +
        "<joint name='j' type='fixed'><parent>world</parent><child>a</child></joint></model>";
    const WorldPtr world = world_of(held, ode("<type>world</type>", "<cfm>0.1</cfm><erp>0.2</erp>"));
    step(world, 2000);
    const double z = place(world->GetModel("m")->GetLink("a")).z();
    EXPECT_NEAR(1 - z, kGravity / 2000, 0.05 * kGravity / 2000);
}

TEST_F(Values, friction_of_both_directions)
{
    // a = g_x - mu g_z.
    EXPECT_NEAR(slide("<mu>0.3</mu><mu2>0.3</mu2>", 0.5, 0).x(), 0.2 * kGravity * 0.2, 0.01);
    EXPECT_NEAR(slide("<mu>0.3</mu><mu2>0.3</mu2>", 0.2, 0).x(), 0, 1e-3);
    EXPECT_NEAR(slide("<mu>0.3</mu>", 0, 0.5).y(), 0.2 * kGravity * 0.2, 0.01);  // mu2 without fdir1
    const std::string across = "<mu>1</mu><mu2>0.1</mu2><fdir1>1 0 0</fdir1>";
    EXPECT_NEAR(slide(across, 0.5, 0).x(), 0, 1e-3);
    EXPECT_NEAR(slide(across, 0, 0.5).y(), 0.4 * kGravity * 0.2, 0.01);
}

TEST_F(Values, bounces_above_its_threshold)
{
    const auto surface = [](const char* threshold) {
        return "<surface><bounce><restitution_coefficient>0.8</restitution_coefficient><threshold>" +
               std::string(threshold) + "</threshold></bounce></surface>";
    };
    EXPECT_NEAR(bounce(surface("0.1")), 0.64, 0.02);  // e^2 of the fall
    EXPECT_NEAR(bounce(surface("10")), 0, 1e-3);
    EXPECT_NEAR(
        bounce("<surface><bounce><restitution_coefficient>0.8</restitution_coefficient></bounce></surface>"),
        0.64, 0.02);
    EXPECT_NEAR(bounce(""), 0, 1e-3);
}

TEST_F(Values, stiffness_is_that_of_a_point)
{
    const std::string soft = "<surface><contact><ode><kp>1000</kp><kd>100</kd></ode></contact></surface>";
    // Four points under the box: m g / 4 k.
    const double sunk = height("", 0.5, 2000) - height("", 0.5, 2000, soft);
    EXPECT_NEAR(sunk, kGravity / 4000, 0.2e-3);
}

}  // namespace
