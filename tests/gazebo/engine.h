// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The plugin as a host has it: loaded by its path, worlds from text of SDF, steps of 1 ms.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include <sdf/Joint.hh>
#include <sdf/Link.hh>
#include <sdf/Model.hh>
#include <sdf/Root.hh>
#include <sdf/World.hh>

#include "integrations/gazebo/entity_access.h"
#include "integrations/gazebo/host_names.h"
#include "integrations/gazebo/joint_features.h"
#include "integrations/gazebo/kinematics.h"
#include "integrations/gazebo/shape_features.h"
#include "integrations/gazebo/simulation.h"
#include "integrations/gazebo/world_options.h"

namespace physics = gz::physics;

struct AllFeatures
    : physics::FeatureList<epode::gazebo::EntityAccessFeatures, epode::gazebo::ConstructFeatures,
                           epode::gazebo::ShapeFeatures, epode::gazebo::JointFeatures,
                           epode::gazebo::KinematicsFeatures, epode::gazebo::SimulationFeatures,
                           epode::gazebo::WorldOptionFeatures> {};
using EnginePtr = physics::Engine3dPtr<AllFeatures>;
using WorldPtr = physics::World3dPtr<AllFeatures>;
using ModelPtr = physics::Model3dPtr<AllFeatures>;
using LinkPtr = physics::Link3dPtr<AllFeatures>;
using JointPtr = physics::Joint3dPtr<AllFeatures>;
using Vec3 = Eigen::Vector3d;
using Pose3 = physics::Pose3d;

constexpr double kGravity = 9.8;

class Gazebo : public testing::Test {
  protected:
    void SetUp() override
    {
        const char* const path = std::getenv("EPODE_GAZEBO_PLUGIN");
        ASSERT_TRUE(path) << "EPODE_GAZEBO_PLUGIN must be the path of the plugin";
        const auto found = loader_.LoadLib(path);
        ASSERT_EQ(found.size(), 1u);
        engine_ = physics::RequestEngine3d<AllFeatures>::From(loader_.Instantiate(*found.begin()));
        ASSERT_TRUE(engine_);
    }
    void TearDown() override { engine_ = nullptr; }

    // A world of these models, on nothing.
    WorldPtr world_of(const std::string& models, const std::string& more = "")
    {
        sdf::Root root;
        errors_ = root.LoadSdfString("<sdf version='1.9'><world name='w" + std::to_string(++worlds_) +
                                     "'><gravity>0 0 -9.8</gravity>" + more + models + "</world></sdf>");
        const sdf::World* const world = root.WorldByIndex(0);
        return world ? engine_->ConstructWorld(*world) : WorldPtr();
    }
    static std::string plane()
    {
        return "<model name='ground'><static>true</static><link name='l'><collision "
               "name='c'><geometry><plane>"
               "<normal>0 0 1</normal></plane></geometry></collision></link></model>";
    }
    static std::string link(const std::string& name, const std::string& pose,
                            const std::string& geometry = "", double mass = 1, double moment = 0.1,
                            const std::string& surface = "")
    {
        const std::string moments = std::to_string(moment);
        std::string text = "<link name='" + name + "'><pose>" + pose + "</pose><inertial><mass>" +
                           std::to_string(mass) + "</mass><inertia><ixx>" + moments + "</ixx><iyy>" +
                           moments + "</iyy><izz>" + moments + "</izz></inertia></inertial>";
        if (!geometry.empty())
            text += "<collision name='c'><geometry>" + geometry + "</geometry>" + surface + "</collision>";
        return text + "</link>";
    }
    static std::string body(const std::string& name, const std::string& pose, const std::string& geometry,
                            const std::string& surface = "")
    {
        return "<model name='" + name + "'>" + link("l", pose, geometry, 1, 0.1, surface) + "</model>";
    }
    static std::string box(double side)
    {
        const std::string s = std::to_string(side);
        return "<box><size>" + s + " " + s + " " + s + "</size></box>";
    }
    // Steps of 1 ms; the output of the last.
    physics::ForwardStep::Output step(const WorldPtr& world, int count)
    {
        physics::ForwardStep::Output output;
        physics::ForwardStep::State state;
        physics::ForwardStep::Input input;
        input.Get<std::chrono::steady_clock::duration>() = std::chrono::milliseconds(1);
        for (int i = 0; i < count; ++i) world->Step(output, state, input);
        return output;
    }
    static Vec3 place(const LinkPtr& link) { return link->FrameDataRelativeToWorld().pose.translation(); }
    static LinkPtr link_of(const WorldPtr& world, const std::string& model, const std::string& name = "l")
    {
        const ModelPtr found = world->GetModel(model);
        return found ? found->GetLink(name) : LinkPtr();
    }

    gz::plugin::Loader loader_;
    EnginePtr engine_;
    sdf::Errors errors_;
    int worlds_ = 0;
};
