// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A human as a list of bones. Lengths and places are shares of the height H, after R. Drillis and R. Contini,
// "Body segment parameters", 1966; masses are shares of the whole, after W. T. Dempster, "Space requirements of the
// seated operator", 1955, both as D. A. Winter's "Biomechanics and Motor Control of Human Movement" has them:
//   sole to ankle 0.039, knee 0.285, hip 0.530, wrist 0.485, elbow 0.630, shoulder 0.818, chin 0.870
//   masses: pelvis 0.142, abdomen 0.139, thorax 0.216, head and neck 0.081, upper arm 0.028, forearm 0.016,
//   hand 0.006, thigh 0.100, shank 0.0465, foot 0.0145
// Widths are such that parts that are no neighbours do not touch. Ranges and strengths are those of an
// adult, rounded; torques grow with mass times height.
#include "assemblies/skeleton.h"
#include "base/check.h"
#include "base/float_environment.h"

namespace epode {
namespace {

constexpr int kHumanBones = 16;
constexpr Vec3 kLeft{0, 1, 0}, kUp{0, 0, 1};
constexpr Quat kStraight{1, 0, 0, 0},
    kAcross{Real(0.70710678118654752440), Real(0.70710678118654752440), 0, 0};

struct Range {
    double low, high;
};

// Stiffness (N m/rad) and strength (N m) of a muscle of a man of 75 kg and 1.8 m; damping follows, so that it
// does not swing.
struct Muscle {
    double stiffness, strength;
};

class Human {
  public:
    Human(dBone* bones, Real height, Real mass) : bones_(bones), height_(height), mass_(mass) {}

    // Shares of the height; of the mass.
    int capsule(int parent, double mass, Vec3 at, double radius, double whole_length, Quat q = kStraight)
    {
        dBone& bone = add(parent, mass, at, q);
        bone.shape = dBoneCapsule;
        bone.size[0] = Real(radius) * height_, bone.size[1] = Real(whole_length - 2 * radius) * height_;
        return count - 1;
    }
    int box(int parent, double mass, Vec3 at, Vec3 sides)
    {
        dBone& bone = add(parent, mass, at, kStraight);
        bone.shape = dBoneBox;
        store(bone.size, height_ * sides);
        return count - 1;
    }
    void connect(int i, int joint, Vec3 anchor, Vec3 axis, Vec3 swing, Muscle muscle)
    {
        dBone& bone = bones_[i];
        const Real scale = mass_ * height_ / Real(75 * 1.8);
        bone.joint = joint;
        store(bone.anchor, height_ * anchor), store(bone.axis, axis), store(bone.swing, swing);
        bone.stiffness = scale * Real(muscle.stiffness), bone.strength = scale * Real(muscle.strength);
        bone.damping = bone.stiffness / 12, bone.friction = bone.strength / 50;
    }
    void limit(int i, Range twist, Range across = {}, Range swing = {})
    {
        const Range ranges[] = {twist, across, swing};
        for (int k = 0; k < 3; ++k)
            bones_[i].low[k] = Real(ranges[k].low), bones_[i].high[k] = Real(ranges[k].high);
    }
    void add_trunk();
    void add_arm(double side);
    void add_leg(double side);

    int count = 0;

  private:
    dBone& add(int parent, double mass, Vec3 at, Quat q)
    {
        dBone& bone = bones_[count++];
        bone = {};
        bone.parent = parent;
        bone.mass = Real(mass) * mass_;
        store(bone.position, height_ * at), store_quat(bone.orientation, q);
        return bone;
    }

    dBone* bones_;
    Real height_, mass_;
    int pelvis_ = 0, thorax_ = 0;
};

// What is the same on both sides but for the sign.
constexpr Range mirrored(double side, Range left) { return side > 0 ? left : Range{-left.high, -left.low}; }

constexpr Vec3 at(double x, double y, double z) { return {Real(x), Real(y), Real(z)}; }

void Human::add_trunk()
{
    pelvis_ = capsule(-1, 0.142, at(0, 0, 0.560), 0.0556, 0.222, kAcross);
    const int abdomen = capsule(pelvis_, 0.139, at(0, 0, 0.655), 0.0528, 0.205, kAcross);
    connect(abdomen, dBoneBall, at(0, 0, 0.610), kUp, kLeft, {600, 200});
    limit(abdomen, {-0.4, 0.4}, {-0.3, 0.3}, {-0.3, 0.6});
    thorax_ = box(abdomen, 0.216, at(0, 0, 0.745), at(0.111, 0.167, 0.150));
    connect(thorax_, dBoneBall, at(0, 0, 0.695), kUp, kLeft, {600, 200});
    limit(thorax_, {-0.4, 0.4}, {-0.3, 0.3}, {-0.3, 0.6});
    const int head = capsule(thorax_, 0.081, at(0, 0, 0.9225), 0.0545, 0.155);
    connect(head, dBoneBall, at(0, 0, 0.835), kUp, kLeft, {60, 25});
    limit(head, {-1.2, 1.2}, {-0.6, 0.6}, {-0.7, 0.8});
}

// An arm that hangs: forward and up about -y, outwards about x.
void Human::add_arm(double side)
{
    const double y = 0.140 * side;
    const int upper = capsule(thorax_, 0.028, at(0, y, 0.724), 0.0260, 0.188);
    connect(upper, dBoneBall, at(0, 0.129 * side, 0.800), -kUp, -kLeft, {150, 60});
    limit(upper, {-1, 1}, mirrored(side, {-0.3, 1.5}), {-0.9, 2.8});
    const int fore = capsule(upper, 0.016, at(0, y, 0.5575), 0.0222, 0.145);
    connect(fore, dBoneHinge, at(0, y, 0.630), -kLeft, {}, {100, 40});
    limit(fore, {0, 2.5});
    const int hand = box(fore, 0.006, at(0, y, 0.431), at(0.045, 0.015, 0.108));
    connect(hand, dBoneUniversal, at(0, y, 0.485), -kUp, -kLeft, {20, 8});
    limit(hand, {}, {-0.4, 0.4}, {-1, 1});
}

void Human::add_leg(double side)
{
    const double y = 0.052 * side;
    const int thigh = capsule(pelvis_, 0.100, at(0, y, 0.4075), 0.0440, 0.245);
    connect(thigh, dBoneBall, at(0, y, 0.530), -kUp, -kLeft, {500, 200});
    limit(thigh, {-0.6, 0.6}, mirrored(side, {-0.35, 0.8}), {-0.35, 2});
    const int shank = capsule(thigh, 0.0465, at(0, y, 0.162), 0.0295, 0.246);
    connect(shank, dBoneHinge, at(0, y, 0.285), kLeft, {}, {400, 150});
    limit(shank, {0, 2.4});
    const int foot = box(shank, 0.0145, at(0.037, y, 0.0195), at(0.152, 0.050, 0.039));
    connect(foot, dBoneUniversal, at(0, y, 0.039), -kUp, -kLeft, {300, 100});
    limit(foot, {}, {-0.3, 0.3}, {-0.7, 0.35});
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" int dBonesMakeHuman(dBone* bones, int capacity, dReal height, dReal mass)
{
    const FloatEnvironment floats;
    EPODE_USER(bones, 0);
    EPODE_USER_SAY(capacity >= kHumanBones, "capacity (accepted: 16 or more)", 0);
    EPODE_USER_SAY(usable(height) && height >= Real(0.1) && height <= 100, "height (accepted: 0.1 ... 100 m)",
                   0);
    EPODE_USER_SAY(usable(mass) && mass >= Real(0.001) && mass <= Real(1e6),
                   "mass (accepted: 0.001 ... 1e6 kg)", 0);
    Human human(bones, height, mass);
    human.add_trunk();
    for (const double side : {1.0, -1.0}) human.add_arm(side);
    for (const double side : {1.0, -1.0}) human.add_leg(side);
    return human.count;
}
