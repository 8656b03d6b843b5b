// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Trees of 1 to 6 boxes, 2 to 60 cm a side and 0.2 to 5 kg, on joints of six types, let go at rest: a hundred machines as a
// program might build them, none made for the solver. Joints do no work, so that none may end up with more energy than it
// began with, but for what position correction and a first-order step add. Exact joints (dWorldStep; substeps with exact
// joints) hold to that in all of them, and so do substeps, which turn to exact joints where sweeps do not hold.
// Sweeps of dWorldQuickStep that end early do not in some, of which no change may make more. Of 1,000 trees 52 gain in QuickStep,
// and 2 and 1 with 4 and 8 substeps.
#include <algorithm>
#include <vector>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81;

// How trees are stepped, and how many of so many may gain energy: one more in floats.
struct Way {
    const char* name;
    int (*step)(dWorldID, dReal);
    int max_gains;
    int trees = 100;
};

int with_exact_joints(dWorldID world, dReal h)
{
    dWorldSetHybridStepper(world, dStepperSubstepsExactJoints);
    return dWorldStepHybrid(world, h);
}

int with_exact_rotation(dWorldID world, dReal h)
{
    if (!dWorldGetExactRotation(world)) dWorldSetExactRotation(world, 1);
    return dWorldStep(world, h);
}

// In which the bars of such a tree turn by up to a radian and more.
int with_exact_rotation_at_60(dWorldID world, dReal) { return with_exact_rotation(world, real(1 / 60.0)); }

template <int kCount>
int in_substeps(dWorldID world, dReal h)
{
    return dWorldStepFast1(world, h, kCount);
}

V3 unit(Random& random)
{
    for (;;) {
        const V3 a = random.point(1);
        if (const double size = length(a); size > 0.1 && size < 1) return (1 / size) * a;
    }
}

V3 across(V3 axis, Random& random)
{
    for (;;) {
        const V3 a = unit(random), b = a - dot(a, axis) * axis;
        if (length(b) > 0.2) return (1 / length(b)) * b;
    }
}

class Tree {
  public:
    explicit Tree(int number) : random_(std::uint32_t(number))
    {
        sim.gravity(0, 0, -kG);
        h = std::exp(random_.uniform(std::log(1 / 500.0), std::log(1 / 60.0)));
        const int count = 1 + int(random_.uniform(0, 6));
        for (int i = 0; i < count; ++i) add_link();
    }

    double energy() const
    {
        double sum = 0;
        for (dBodyID body : links_) {
            dMass mass;
            dBodyGetMass(body, &mass);
            dVector3 local;
            const V3 v = vec(dBodyGetLinearVel(body)), w = vec(dBodyGetAngularVel(body));
            dBodyVectorFromWorld(body, real(w.x), real(w.y), real(w.z), local);
            sum += double(mass.mass) * (0.5 * dot(v, v) + kG * vec(dBodyGetPosition(body)).z);
            for (int k = 0; k < 3; ++k)
                sum += 0.5 * double(mass.I[5 * k]) * double(local[k]) * double(local[k]);
        }
        return sum;
    }

    // m g times how far all of it could fall.
    double fall() const { return kG * mass_ * size_; }

    Sim sim;
    double h = 0;

  private:
    void add_link()
    {
        const int parent = links_.empty() ? -1 : int(random_.uniform(-1, double(links_.size())));
        const dBodyID before = parent < 0 ? nullptr : links_[std::size_t(parent)];
        const V3 from = before ? vec(dBodyGetPosition(before)) : V3{};
        const double arm = random_.uniform(0.1, 1),
                     mass = std::exp(random_.uniform(std::log(0.2), std::log(5)));
        const V3 to = arm * unit(random_), anchor = from + random_.uniform(0, 1) * to;
        const auto side = [&] { return std::exp(random_.uniform(std::log(0.02), std::log(0.6))); };
        const double x = side(), y = side(), z = side();
        const dBodyID link = sim.box(from + to, {x, y, z}, mass);
        dQuaternion q;
        random_.quaternion(q);
        dBodySetQuaternion(link, q);
        dBodySetGyroscopicMode(link, 1);
        links_.push_back(link);
        mass_ += mass, size_ += arm;
        join(link, before, anchor);
    }

    void join(dBodyID link, dBodyID before, V3 anchor)
    {
        const V3 axis = unit(random_), other = across(axis, random_);
        const dReal x = real(anchor.x), y = real(anchor.y), z = real(anchor.z);
        const auto along = [](auto set, dJointID joint, V3 a) {
            set(joint, real(a.x), real(a.y), real(a.z));
        };
        switch (int(random_.uniform(0, 7))) {
            case 0:
            case 1: {
                const dJointID joint = made(dJointCreateHinge, link, before);
                dJointSetHingeAnchor(joint, x, y, z), along(dJointSetHingeAxis, joint, axis);
                break;
            }
            case 2:
                dJointSetBallAnchor(made(dJointCreateBall, link, before), x, y, z);
                break;
            case 3: {
                const dJointID joint = made(dJointCreateUniversal, link, before);
                dJointSetUniversalAnchor(joint, x, y, z);
                along(dJointSetUniversalAxis1, joint, axis), along(dJointSetUniversalAxis2, joint, other);
                break;
            }
            case 4: {
                const dJointID joint = made(dJointCreateSlider, link, before);
                along(dJointSetSliderAxis, joint, axis);
                dJointSetSliderParam(joint, dParamLoStop, real(-0.3));
                dJointSetSliderParam(joint, dParamHiStop, real(0.3));
                break;
            }
            case 5:
                dJointSetFixed(made(dJointCreateFixed, link, before));
                break;
            default: {
                const dJointID joint = made(dJointCreatePiston, link, before);
                dJointSetPistonAnchor(joint, x, y, z), along(dJointSetPistonAxis, joint, axis);
                dJointSetPistonParam(joint, dParamLoStop, real(-0.3));
                dJointSetPistonParam(joint, dParamHiStop, real(0.3));
            }
        }
    }

    dJointID made(dJointID (*create)(dWorldID, dJointGroupID), dBodyID one, dBodyID two)
    {
        const dJointID joint = create(sim.world, nullptr);
        dJointAttach(joint, one, two);
        return joint;
    }

    Random random_;
    std::vector<dBodyID> links_;
    double mass_ = 0, size_ = 0;
};

class RandomTrees : public testing::TestWithParam<Way> {};

bool gains_energy(Tree& tree, const Way& way)
{
    const double start = tree.energy();
    for (int i = 0; i * tree.h < 4; ++i) {
        EXPECT_EQ(way.step(tree.sim.world, real(tree.h)), 1);
        if (!(tree.energy() < start + 0.02 * tree.fall())) return true;
    }
    return false;
}

TEST_P(RandomTrees, gain_no_energy)
{
    int gains = 0;
    std::string which;
    for (int number = 0; number < GetParam().trees; ++number) {
        Tree tree(number);
        if (!gains_energy(tree, GetParam())) continue;
        ++gains;
        which += ' ' + std::to_string(number);
    }
    EXPECT_LE(gains, GetParam().max_gains) << which;
}

std::string name_of_way(const testing::TestParamInfo<Way>& way) { return way.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Ways, RandomTrees,
    testing::Values(Way{"exact", dWorldStep, 0}, Way{"exact_rotation", with_exact_rotation, 0},
                    Way{"exact_rotation_at_60", with_exact_rotation_at_60, 0},
                    Way{"exact_joints", with_exact_joints, 0}, Way{"quick", dWorldQuickStep, 5},
                    Way{"substeps4", in_substeps<4>, kSingle, 200},
                    Way{"substeps8", in_substeps<8>, kSingle, 200}, Way{"substeps16", in_substeps<16>, 0}),
    name_of_way);

}  // namespace
}  // namespace epode::physics
