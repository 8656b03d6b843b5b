// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One intended difference: what must hold of physics (or of the interface's own promise), which ours keeps
// and the original does not. A check answers whether it holds; it may also end or hang its process, as the
// original does on some, since each runs in one of its own.
#pragma once

#include <ode/ode.h>

#include <cmath>
#include <vector>

namespace differences {

struct Difference {
    const char* id;
    const char* promise;
    bool (*holds)();
};

inline std::vector<Difference>& list()
{
    static std::vector<Difference> all;
    return all;
}

struct Entry {
    Entry(const char* id, const char* promise, bool (*holds)()) { list().push_back({id, promise, holds}); }
};

#define DIFFERENCE(id, name, promise)                            \
    bool id##_##name();                                          \
    const Entry entry_##id##_##name(#id, promise, &id##_##name); \
    bool id##_##name()

// Shown when a single check is run by hand.
void note(const char* name, double value);

constexpr double kStep = 0.01;

inline bool near(double a, double b, double slack) { return std::fabs(a - b) <= slack; }
inline double size(const dReal* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

// A world without gravity, with a body or two: 1 kg, inertia 0.1 about each axis.
struct World {
    dWorldID id = dWorldCreate();
    dBodyID body(double x = 0, double y = 0, double z = 0) const
    {
        const dBodyID b = dBodyCreate(id);
        dMass mass;
        dMassSetParameters(&mass, 1, 0, 0, 0, 0.1, 0.1, 0.1, 0, 0, 0);
        dBodySetMass(b, &mass);
        dBodySetPosition(b, x, y, z);
        return b;
    }
    void step(int count = 1) const
    {
        for (int i = 0; i < count; ++i) dWorldStep(id, kStep);
    }
};

inline dJointID attached(dJointID joint, dBodyID a, dBodyID b)
{
    dJointAttach(joint, a, b);
    return joint;
}

// Of the two bodies together, about the origin.
inline double angular_momentum(dBodyID a, dBodyID b, double* sum)
{
    sum[0] = sum[1] = sum[2] = 0;
    for (const dBodyID body : {a, b}) {
        const dReal *p = dBodyGetPosition(body), *v = dBodyGetLinearVel(body), *w = dBodyGetAngularVel(body);
        sum[0] += p[1] * v[2] - p[2] * v[1] + 0.1 * w[0];
        sum[1] += p[2] * v[0] - p[0] * v[2] + 0.1 * w[1];
        sum[2] += p[0] * v[1] - p[1] * v[0] + 0.1 * w[2];
    }
    return size(sum);
}

inline double energy(dBodyID b)
{
    const double v = size(dBodyGetLinearVel(b)), w = size(dBodyGetAngularVel(b));
    return 0.5 * v * v + 0.05 * w * w;
}

// A small generator of its own, the same everywhere.
class Dice {
  public:
    double in(double low, double high)
    {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return low + (high - low) * (double(state_ >> 11) / 9007199254740992.0);
    }

  private:
    unsigned long long state_ = 1;
};

void turn_at_random(dGeomID geom, Dice& dice);

}  // namespace differences
