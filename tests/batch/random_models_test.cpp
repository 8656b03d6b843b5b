// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Models that nobody thought of: random trees of every joint, with springs, dampers, rotors, dry friction, limits, motors, servos and feet
// on a floor. From rest a step of a batch and one of dWorldStep have the same joint velocities. EPODE_BATCH_STATES: how many of each model
// (scripts/nightly wants 500).
#include "models.h"

#include <ode/ext.h>

#include <algorithm>
#include <cstdlib>

namespace epode::tests {
namespace {

constexpr dReal kShortStep = dReal(1e-6), kTakingBack = dReal(0.1);

class RandomTree {
  public:
    explicit RandomTree(unsigned seed) : dice_(seed) {}

    std::string text()
    {
        floats_ = dice_.between(0, 1) < 0.5, links_ = 2 + int(dice_.between(0, 5.999));
        std::string tree;
        for (int i = 0; i < links_; ++i) parents_.push_back(i == 0 ? -1 : int(dice_.between(0, i - 1e-9)));
        const std::string bodies = body(0);
        return "<mujoco><compiler angle=\"radian\" autolimits=\"true\"/><worldbody><geom type=\"plane\" "
               "size=\"9 9 1\" contype=\"1\" "
               "conaffinity=\"0\"/>" +
               bodies + "</worldbody><actuator>" + actuators_ + "</actuator></mujoco>";
    }

    bool has_several_joints() const { return has_several_joints_; }

  private:
    static std::string number(double x)
    {
        char out[32];
        std::snprintf(out, sizeof out, "%.9g ", x);
        return out;
    }
    std::string numbers(int count, double low, double high)
    {
        std::string out;
        for (const double x : dice_.many(count, low, high)) out += number(x);
        return out;
    }
    bool is(double share) { return dice_.between(0, 1) < share; }

    std::string body(int i)
    {
        const bool is_base = i == 0 && floats_;
        std::string out = "<body pos=\"" +
                          (i == 0 ? "0 0 " + number(dice_.between(-0.1, 0.5)) : numbers(3, -0.3, 0.3)) +
                          "\" euler=\"" + numbers(3, -0.5, 0.5) + "\">";
        out += is_base ? "<freejoint/>" : joints(i);
        out += inertial();
        if (is(0.6))
            out += "<geom type=\"sphere\" contype=\"0\" conaffinity=\"1\" mass=\"0\" pos=\"" +
                   numbers(3, -0.2, 0.2) + "\" size=\"" + numbers(1, 0.03, 0.1) + "\"/>";
        for (int k = i + 1; k < links_; ++k)
            if (parents_[size_t(k)] == i) out += body(k);
        return out + "</body>";
    }

    // Moments as of a box.
    std::string inertial()
    {
        const double m = dice_.between(0.3, 3), a = dice_.between(0.02, 0.3), b = dice_.between(0.02, 0.3),
                     c = dice_.between(0.02, 0.3);
        return "<inertial mass=\"" + number(m) + "\" pos=\"" + numbers(3, -0.1, 0.1) + "\" euler=\"" +
               numbers(3, -2, 2) + "\" diaginertia=\"" + number(m / 3 * (b * b + c * c)) +
               number(m / 3 * (a * a + c * c)) + number(m / 3 * (a * a + b * b)) + "\"/>";
    }

    std::string joints(int i)
    {
        if (is(0.2)) return "<joint type=\"ball\" pos=\"" + numbers(3, -0.05, 0.05) + "\"/>";
        std::string out;
        const int count = is(0.25) ? 2 : 1;
        has_several_joints_ |= count > 1;
        for (int k = 0; k < count; ++k) out += joint("j" + std::to_string(i) + "_" + std::to_string(k));
        return out;
    }

    std::string joint(const std::string& name)
    {
        std::string out = "<joint name=\"" + name + "\" type=\"" + (is(0.3) ? "slide" : "hinge") +
                          "\" axis=\"" + numbers(2, -1, 1) + number(dice_.between(0.1, 1)) + "\" pos=\"" +
                          numbers(3, -0.05, 0.05) + "\"";
        const auto some = [&](const char* what, double share, double low, double high) {
            if (is(share)) out += std::string(" ") + what + "=\"" + numbers(1, low, high) + "\"";
        };
        some("damping", 0.5, 0, 2), some("armature", 0.4, 0, 0.1), some("stiffness", 0.3, 0, 30);
        some("frictionloss", 0.2, 0, 2);
        if (is(0.5))
            out += " range=\"" + number(-dice_.between(0.3, 1.5)) + number(dice_.between(0.3, 1.5)) + "\"";
        if (is(0.4))
            actuators_ += "<motor joint=\"" + name + "\" gear=\"" + numbers(1, -20, 20) + "\"/>";
        else if (is(0.3))
            actuators_ += "<position joint=\"" + name + "\" kp=\"" + numbers(1, 1, 100) + "\"/>";
        return out + "/>";
    }

    Dice dice_;
    bool floats_ = false, has_several_joints_ = false;
    int links_ = 0;
    std::vector<int> parents_;
    std::string actuators_;
};

// of_chains: of models with several joints of a link, which are a chain of bodies in a world, the middle ones with some inertia.
struct Compared {
    std::vector<double> differences, of_chains;
    int touches = 0, unsolved_in_batches = 0, unsolved_in_worlds = 0;
    int lessened =
        0;  // worlds whose corrections near a dead centre throw the robot, so that a share of them is made
    long count() const
    {
        return long(differences.size() + of_chains.size()) + unsolved_in_batches + unsolved_in_worlds +
               lessened;
    }
    long beyond(double bound) const
    {
        return std::count_if(differences.begin(), differences.end(), [&](double x) { return !(x < bound); });
    }
};

class RandomModels : public testing::Test {
  protected:
    RandomModels() { dInitODE2(0); }
    ~RandomModels() override { dCloseODE(); }

    struct Contacts {
        dWorldID world;
        dJointGroupID group;
        double mu;
        int count;
    };

    // Feet touch the floor midway, as in a batch; nothing else touches.
    static void touch(void* data, dGeomID a, dGeomID b)
    {
        auto& its = *static_cast<Contacts*>(data);
        if (dGeomGetClass(a) == dPlaneClass) std::swap(a, b);
        dContact contact{};
        if (dGeomGetClass(b) != dPlaneClass || dCollide(a, b, 1, &contact.geom, sizeof contact.geom) == 0)
            return;
        for (int k = 0; k < 3; ++k) contact.geom.pos[k] += contact.geom.normal[k] * contact.geom.depth / 2;
        contact.surface.mu = dReal(its.mu), contact.surface.mode = dContactApprox1, ++its.count;
        dJointAttach(dJointCreateContact(its.world, its.group, &contact), dGeomGetBody(contact.geom.g1),
                     dGeomGetBody(contact.geom.g2));
    }

    static std::vector<dReal> step_of_world(dRobotModelID model, const std::vector<double>& q,
                                            const std::vector<double>& control, double mu, Compared& to)
    {
        const dWorldID world = dWorldCreate();
        const dSpaceID space = dSimpleSpaceCreate(nullptr);
        const dJointGroupID group = dJointGroupCreate(0);
        dWorldSetGravity(world, 0, 0, dReal(-9.81)), dWorldSetERP(world, dReal(0.2)), dWorldSetCFM(world, 0);
        dWorldSetContactMaxCorrectingVel(world, kTakingBack), dWorldSetFrictionCone(world, 1);
        const dRobotID robot = dRobotCreate(world, space, model, nullptr, nullptr);
        dRobotSetPositions(robot, reals_of(q).data(), int(q.size()));
        for (size_t i = 0; i < control.size(); ++i) dRobotSetControl(robot, int(i), dReal(control[i]));
        Contacts contacts{world, group, mu, 0};
        dSpaceCollide(space, &contacts, touch);
        dWorldSetStepReportMode(world, 1);
        dWorldStep(world, kShortStep);
        dWorldStepReport report{};
        report.struct_size = sizeof report;
        dWorldGetStepReport(world, &report);
        to.touches += contacts.count, to.unsolved_in_worlds += report.friction_error > 1e-7;
        to.lessened += report.fallbacks > 0;
        std::vector<dReal> out(size_t(dRobotGetVelocities(robot, nullptr, 0)));
        dRobotGetVelocities(robot, out.data(), int(out.size()));
        dRobotDestroy(robot), dJointGroupDestroy(group), dSpaceDestroy(space), dWorldDestroy(world);
        return out;
    }

    // The worst of each state, m/s or rad/s, less 2 h v^2: joint velocities of a world are read where bodies have moved to.
    static void compare(unsigned seed, int states, double mu, Compared& out)
    {
        RandomTree tree(seed);
        const std::string text = tree.text();
        const dRobotModelID model = model_of(text.c_str());
        ASSERT_NE(model, nullptr) << text;
        Dice dice(seed + 1000);
        Copies<double> copies(model, states, kShortStep, dReal(1e-13), 1, 20000, kTakingBack);
        ASSERT_NE(copies.id, nullptr) << text;
        const int controls = dBatchGetSize(copies.id, dBatchControls),
                  pairs = dBatchGetParameterSize(copies.id, dBatchFrictions);
        std::vector<std::vector<double>> q, control;
        for (int i = 0; i < states; ++i) {
            q.push_back(any_positions(model, dice)), control.push_back(dice.many(controls, -1, 1));
            copies.write_one(dBatchPositions, i, q.back());
            if (controls > 0) copies.write_one(dBatchControls, i, control.back());
        }
        const std::vector<double> frictions(size_t(states * pairs), mu);
        if (pairs > 0) {
            EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchFrictions, 0, states, frictions.data()), 1);
        }
        dBatchStep(copies.id, 1);
        for (int i = 0; i < states; ++i) {
            const auto got = copies.read(dBatchVelocities, i, 1);
            const int unsolved = out.unsolved_in_worlds, lessened = out.lessened;
            const auto want = step_of_world(model, q[size_t(i)], control[size_t(i)], mu, out);
            double worst = 0, largest = 0;
            for (size_t k = 0; k < got.size(); ++k) {
                worst = std::max(worst, std::fabs(double(want[k]) - got[k]));
                largest = std::max(largest, std::fabs(got[k]));
            }
            worst -= 2 * double(kShortStep) * largest * largest;
            // What either says itself to have left unsolved is not compared.
            if (out.unsolved_in_worlds > unsolved || out.lessened > lessened) continue;
            if (!(copies.read(dBatchResidual, i, 1)[0] < 1e-9)) {
                ++out.unsolved_in_batches;
                continue;
            }
            (tree.has_several_joints() ? out.of_chains : out.differences).push_back(worst);
        }
        dRobotModelDestroy(model);
    }

    static Compared compared(double mu)
    {
        const char* const wanted = std::getenv("EPODE_BATCH_STATES");
        const int states = wanted ? std::max(1, std::atoi(wanted)) : 10;
        Compared out;
        for (unsigned seed = 1; seed <= 20; ++seed) compare(seed, states, mu, out);
        return out;
    }
};

TEST_F(RandomModels, step_as_in_worlds_without_friction)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "differences of this size are rounding in floats";
    const Compared its = compared(0);
    EXPECT_GT(its.touches, int(its.differences.size() / 4));
    EXPECT_EQ(its.beyond(1e-9), 0);
    EXPECT_LE(its.lessened, its.count() / 100);
    for (const double x : its.of_chains) EXPECT_LT(x, 1e-5);
}

// Coulomb's law may have several solutions, and where joints nearly jam dWorldStep's error of friction, 1e-7 and less, is 1e-4 m/s. Of
// 10,000 states 3 % are beyond that error in worlds, none unsolved in batches alone; of the others 4 % differ, 0.3 % of those whose error
// is below 1e-9.
TEST_F(RandomModels, step_as_in_worlds_with_friction)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "differences of this size are rounding in floats";
    const Compared its = compared(0.6);
    EXPECT_LE(its.beyond(1e-6), long(its.differences.size() / 20));
    EXPECT_LE(its.unsolved_in_batches, its.count() * 3 / 100);
    EXPECT_LE(its.unsolved_in_worlds, its.count() * 5 / 100);
}

}  // namespace
}  // namespace epode::tests
