// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Runs the same world on plugins of gz-physics, one after the other, and says how fast and how well.
//   gazebo_drive features PLUGIN...                   which features each of them offers
//   gazebo_drive run WORLD.sdf STEPS EVERY PLUGIN...  steps of 1 ms; after each EVERY of them a line:
//       plugin  time  real-time factor since the last line, by processor time and by the clock  energy  lowest centre  fastest link
// A plugin is the path of its library. Energy, J, is kinetic and potential, of the masses in the file; the velocities are those that
// the plugin says links have; of one that does not show its links there are none, and 0 is printed. Real-time factor: simulated time over the time of the calls alone.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <set>

#include <sdf/Link.hh>
#include <sdf/Model.hh>
#include <sdf/Root.hh>
#include <sdf/World.hh>

#include "integrations/gazebo/host_names.h"

namespace {

namespace physics = gz::physics;

// To run, and to look at links, which not every plugin offers.
using Runs = physics::FeatureList<physics::sdf::ConstructSdfWorld, physics::ForwardStep>;
using Looks = physics::FeatureList<physics::GetWorldFromEngine, physics::GetModelFromWorld,
                                   physics::GetLinkFromModel, physics::LinkFrameSemantics>;
using World = physics::World3dPtr<Runs>;
using LinkPtr = physics::Link3dPtr<Looks>;
using Seconds = std::chrono::duration<double>;

constexpr auto kStep = std::chrono::milliseconds(1);

// The name of a file without folder and endings.
std::string short_name(const std::string& path)
{
    const std::string name = path.substr(path.rfind('/') + 1);
    return name.substr(0, name.find('.'));
}

gz::plugin::PluginPtr load(gz::plugin::Loader& loader, const std::string& path)
{
    const auto found = loader.LoadLib(path);
    if (found.empty()) std::fprintf(stderr, "gazebo_drive: %s is no plugin\n", path.c_str());
    return found.empty() ? gz::plugin::PluginPtr() : loader.Instantiate(*found.begin());
}

// A feature's interface is class Implementation in it; those of three dimensions count.
std::string feature_of(const std::string& interface)
{
    const std::size_t end = interface.find("::Implementation<");
    if (end == std::string::npos || interface.find("double, 3") == std::string::npos) return {};
    const std::size_t begin = interface.rfind("::", end - 1);
    return interface.substr(begin + 2, end - begin - 2);
}

int print_features(const std::vector<std::string>& paths)
{
    std::vector<std::set<std::string>> offered;
    std::set<std::string> all;
    for (const std::string& path : paths) {
        gz::plugin::Loader loader;
        if (loader.LoadLib(path).empty()) return 1;
        auto& its = offered.emplace_back();
        for (const std::string& interface : loader.InterfacesImplemented())
            if (const std::string name = feature_of(interface); !name.empty())
                its.insert(name), all.insert(name);
    }
    for (const std::string& name : all) {
        std::printf("%-44s", name.c_str());
        for (const auto& its : offered) std::printf("\t%s", its.count(name) ? "yes" : "-");
        std::printf("\n");
    }
    for (std::size_t i = 0; i < paths.size(); ++i)
        std::printf("%s: %zu\n", short_name(paths[i]).c_str(), offered[i].size());
    return 0;
}

struct Mass {
    LinkPtr link;
    gz::math::Inertiald inertial;
};

std::vector<Mass> masses_of(const gz::plugin::PluginPtr& plugin, const sdf::World& from)
{
    std::vector<Mass> masses;
    const auto engine = physics::RequestEngine3d<Looks>::From(plugin);
    const auto world = engine ? engine->GetWorld(from.Name()) : physics::World3dPtr<Looks>();
    if (!world) return masses;
    for (std::uint64_t i = 0; i < from.ModelCount(); ++i) {
        const sdf::Model& model = *from.ModelByIndex(i);
        const auto its = world->GetModel(model.Name());
        if (!its || model.Static()) continue;
        for (std::uint64_t k = 0; k < model.LinkCount(); ++k)
            if (const LinkPtr link = its->GetLink(model.LinkByIndex(k)->Name()))
                masses.push_back({link, model.LinkByIndex(k)->Inertial()});
    }
    return masses;
}

struct Measure {
    double energy = 0, lowest = HUGE_VAL, fastest = 0;  // nothing measured: the lowest is infinite
};

Measure measure(const std::vector<Mass>& masses, const Eigen::Vector3d& gravity)
{
    Measure sum;
    for (const Mass& mass : masses) {
        const auto data = mass.link->FrameDataRelativeToWorld();
        const auto c = mass.inertial.Pose().Pos();
        const Eigen::Vector3d arm = data.pose.linear() * Eigen::Vector3d(c.X(), c.Y(), c.Z());
        const Eigen::Vector3d centre = data.pose.translation() + arm;
        const Eigen::Vector3d velocity = data.linearVelocity + data.angularVelocity.cross(arm);
        const Eigen::Vector3d turn = data.pose.linear().transpose() * data.angularVelocity;
        Eigen::Matrix3d moments;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) moments(i, k) = mass.inertial.Moi()(unsigned(i), unsigned(k));
        const double m = mass.inertial.MassMatrix().Mass();
        sum.energy += m * (velocity.squaredNorm() / 2 - gravity.dot(centre)) + turn.dot(moments * turn) / 2;
        sum.lowest = std::min(sum.lowest, centre.z());
        sum.fastest = std::max(sum.fastest, velocity.norm());
    }
    return sum;
}

bool run(const sdf::World& from, int steps, int every, const std::string& path)
{
    gz::plugin::Loader loader;
    const gz::plugin::PluginPtr plugin = load(loader, path);
    if (!plugin) return false;
    const auto engine = physics::RequestEngine3d<Runs>::From(plugin);
    const World world = engine ? engine->ConstructWorld(from) : World();
    if (!world) return std::fprintf(stderr, "gazebo_drive: %s cannot run this world\n", path.c_str()), false;
    const std::vector<Mass> masses = masses_of(plugin, from);
    const auto g = from.Gravity();
    physics::ForwardStep::Output output;
    physics::ForwardStep::State state;
    physics::ForwardStep::Input input;
    input.Get<std::chrono::steady_clock::duration>() = kStep;
    for (int done = 0; done < steps;) {
        const int now = std::min(every, steps - done);
        const auto begin = std::chrono::steady_clock::now();
        const std::clock_t work = std::clock();
        for (int i = 0; i < now; ++i) world->Step(output, state, input);
        const double worked = double(std::clock() - work) / CLOCKS_PER_SEC;
        const double took = Seconds(std::chrono::steady_clock::now() - begin).count();
        done += now;
        const Measure its = measure(masses, {g.X(), g.Y(), g.Z()});
        std::printf("%-40s\t%.3f\t%.4g\t%.4g\t%.9g\t%.6f\t%.3g\n", short_name(path).c_str(), done * 1e-3,
                    now * 1e-3 / worked, now * 1e-3 / took, its.energy, its.lowest, its.fastest);
        std::fflush(stdout);
    }
    return true;
}

int run_all(int count, char** arguments)
{
    sdf::Root root;
    for (const auto& error : root.Load(arguments[2])) std::fprintf(stderr, "%s\n", error.Message().c_str());
    const sdf::World* const world = root.WorldByIndex(0);
    const int steps = std::atoi(arguments[3]), every = std::atoi(arguments[4]);
    if (!world || steps < 1 || every < 1)
        return std::fprintf(stderr, "gazebo_drive: no world, or no steps\n"), 1;
    bool good = true;
    for (int i = 5; i < count; ++i) good = run(*world, steps, every, arguments[i]) && good;
    return good ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments)
{
    const std::string what = count > 1 ? arguments[1] : "";
    if (what == "features" && count > 2) return print_features({arguments + 2, arguments + count});
    if (what == "run" && count > 5) return run_all(count, arguments);
    std::fprintf(stderr, "gazebo_drive features PLUGIN... | run WORLD.sdf STEPS EVERY PLUGIN...\n");
    return 2;
}
