// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Models of our own for batches, and a batch that is destroyed with the test.
#pragma once

#include <epode/batch.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace epode::tests {

// A body on four legs of two hinges each, with spheres for feet: armature, damping, limits, motors.
inline const char* const kWalker = R"(<mujoco model="walker"><compiler angle="radian"/>
<default><joint armature="0.02" damping="0.3" limited="true" range="-1.2 1.2"/><geom contype="0" conaffinity="1" friction="0.7"/></default>
<worldbody><geom name="floor" type="plane" size="9 9 1" contype="1" conaffinity="0" friction="0.7"/>
<body name="trunk" pos="0 0 0.55"><freejoint/><geom type="box" size="0.25 0.15 0.06" mass="4"/>
<body name="a" pos="0.25 0.15 0"><joint name="a1" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0.05 0.02 -0.25" size="0.03" mass="0.5"/>
<body name="a2" pos="0.05 0.02 -0.25"><joint name="a2" axis="0 1 0.2"/><geom name="fa" pos="0 0 -0.22" size="0.04" mass="0.3"/></body></body>
<body name="b" pos="0.25 -0.15 0"><joint name="b1" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0.05 -0.02 -0.25" size="0.03" mass="0.5"/>
<body name="b2" pos="0.05 -0.02 -0.25"><joint name="b2" axis="0.1 1 0"/><geom pos="0 0 -0.22" size="0.04" mass="0.3"/></body></body>
<body name="c" pos="-0.25 0.15 0"><joint name="c1" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 -0.05 0.02 -0.25" size="0.03" mass="0.5"/>
<body name="c2" pos="-0.05 0.02 -0.25"><joint name="c2" axis="0 1 0"/><geom pos="0 0 -0.22" size="0.04" mass="0.3"/></body></body>
<body name="d" pos="-0.25 -0.15 0"><joint name="d1" axis="1 0 0"/><geom type="capsule" fromto="0 0 0 -0.05 -0.02 -0.25" size="0.03" mass="0.5"/>
<body name="d2" pos="-0.05 -0.02 -0.25"><joint name="d2" axis="0 1 0"/><geom pos="0 0 -0.22" size="0.04" mass="0.3"/></body></body>
</body></worldbody><actuator><motor joint="a1" gear="20" ctrlrange="-1 1"/><motor joint="b1" gear="20" ctrlrange="-1 1"/>
<motor joint="c1" gear="20" ctrlrange="-1 1"/><motor joint="d1" gear="20" ctrlrange="-1 1"/><motor joint="a2" gear="10" ctrlrange="-1 1"/></actuator></mujoco>)";

// Every joint there is: a slide, two hinges of one link with an anchor each, a ball, springs, an offset centre of mass, two trees.
inline const char* const kMixed = R"(<mujoco model="mixed"><compiler angle="radian"/><worldbody>
<body name="cart" pos="0.1 0.2 1"><joint name="rail" type="slide" axis="1 0.2 0" damping="0.4" stiffness="3" springref="0.1"/>
<inertial pos="0.05 0 0.02" mass="2" diaginertia="0.02 0.03 0.025"/>
<body name="arm" pos="0.1 0 -0.1" euler="0.3 0.2 0.1"><joint name="u" axis="0 0 1" pos="0.02 0 0" armature="0.01"/>
<joint name="v" axis="0 1 0" pos="0 0.03 0.01" damping="0.05"/><inertial pos="0 0.02 -0.2" mass="1.1" diaginertia="0.012 0.011 0.004"/>
<body name="bob" pos="0 0 -0.4"><joint name="w" type="ball" pos="0 0 0.02"/><inertial pos="0.03 0.01 -0.1" euler="0.4 0 0.5" mass="0.7" diaginertia="0.004 0.005 0.002"/></body>
</body></body>
<body name="kite" pos="1 0 2"><freejoint/><inertial pos="0.1 0 0" mass="0.9" diaginertia="0.01 0.02 0.027"/>
<body name="tail" pos="-0.2 0 0"><joint name="t" axis="0 1 0" stiffness="2" damping="0.1"/><inertial pos="-0.1 0 0" mass="0.2" diaginertia="0.001 0.002 0.002"/></body></body>
</worldbody><actuator><motor joint="rail" gear="3"/><position joint="u" kp="20"/><velocity joint="v" kv="0.4"/></actuator></mujoco>)";

// FNV-1a over the bits of numbers.
template <typename T>
std::uint64_t hashed(std::uint64_t hash, T x)
{
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof x);
    return (hash ^ bits) * 0x100000001b3u;
}

inline dRobotModelID model_of(const char* text)
{
    return dRobotModelLoadText("model.xml", text, std::strlen(text), nullptr);
}

// Copies whose numbers are T.
template <typename T>
class Copies {
  public:
    Copies(dRobotModelID model, int copies, dReal h, dReal tolerance = 0, int threads = 1, int sweeps = 200,
           dReal correction = 2)
        : copies_(copies)
    {
        dBatchOptions options;
        dBatchOptionsInit(&options, sizeof options);
        options.doubles = sizeof(T) == 8, options.threads = threads, options.stepsize = h,
        options.tolerance = tolerance;
        options.max_sweeps = sweeps, options.max_correction = correction;
        id = dBatchCreate(model, copies, &options);
    }
    ~Copies() { dBatchDestroy(id); }
    Copies(const Copies&) = delete;
    Copies& operator=(const Copies&) = delete;

    int size(int quantity) const { return dBatchGetSize(id, quantity); }
    std::vector<T> read(int quantity) const { return read(quantity, 0, copies_); }
    std::vector<T> read(int quantity, int first, int count) const
    {
        std::vector<T> out(size_t(count) * size_t(size(quantity)));
        EXPECT_EQ(dBatchRead(id, quantity, first, count, out.data()), 1);
        return out;
    }
    void write(int quantity, const std::vector<T>& from)
    {
        EXPECT_EQ(dBatchWrite(id, quantity, 0, copies_, from.data()), 1);
    }
    void write_one(int quantity, int copy, const std::vector<T>& from)
    {
        EXPECT_EQ(dBatchWrite(id, quantity, copy, 1, from.data()), 1);
    }

    dBatchID id;

  private:
    int copies_;
};

class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    double between(double low, double high)
    {
        return low + (high - low) * (double(random_()) / 4294967296.0);
    }
    std::vector<double> many(int count, double low, double high)
    {
        std::vector<double> out;
        for (int i = 0; i < count; ++i) out.push_back(between(low, high));
        return out;
    }

  private:
    std::mt19937 random_;
};

// Anywhere within the limits, but for a tenth at both ends; free joints near their reference, turned anyhow.
inline std::vector<double> any_positions(dRobotModelID model, Dice& dice)
{
    std::vector<dReal> q(size_t(dRobotModelGetNumPositions(model)));
    dRobotModelGetReference(model, q.data(), int(q.size()));
    std::vector<dRobotJoint> joints(size_t(dRobotModelGetJoints(model, nullptr, 0)));
    dRobotModelGetJoints(model, joints.data(), int(joints.size()));
    std::vector<double> out(q.begin(), q.end());
    for (const dRobotJoint& joint : joints) {
        double* its = &out[size_t(joint.position)];
        if (joint.kind == dRobotHinge || joint.kind == dRobotSlide) {
            const double low = std::max(-1.0, double(joint.low)), high = std::min(1.0, double(joint.high));
            its[0] = dice.between(0.9 * low + 0.1 * high, 0.1 * low + 0.9 * high);
            continue;
        }
        if (joint.kind == dRobotFree) its += 3;
        double length = 0;
        for (int k = 0; k < 4; ++k) its[k] = dice.between(-1, 1), length += its[k] * its[k];
        for (int k = 0; k < 4; ++k) its[k] /= std::sqrt(length);
    }
    return out;
}

inline std::vector<dReal> reals_of(const std::vector<double>& from) { return {from.begin(), from.end()}; }

}  // namespace epode::tests
