// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See limit_states.h. Bounce variants meet both signs of the approach velocity because velocities are random;
// fudge variants meet a motor pushing into and away from the stop because the motor velocity's sign is
// random.
#include "limit_states.h"

namespace parity {
namespace {

using Values = std::vector<std::pair<int, double>>;

JointVariant variant(const std::string& name, SetParam set, int group, Values (*values)(Random&))
{
    return {name, [=](dJointID joint, Random& random) {
                for (const auto& [parameter, value] : values(random)) {
                    set(joint, parameter + group, value);
                }
            }};
}

Values none(Random&) { return {}; }

Values motor_weak(Random& r) { return {{dParamVel, r.range(-3, 3)}, {dParamFMax, r.range(0.1, 2)}}; }

Values motor_strong(Random& r) { return {{dParamVel, r.range(-3, 3)}, {dParamFMax, 1e5}}; }

Values motor_cfm(Random& r)
{
    return {{dParamVel, r.range(-3, 3)}, {dParamFMax, 1e5}, {dParamCFM, r.range(1e-4, 1e-2)}};
}

Values brake(Random& r) { return {{dParamVel, 0}, {dParamFMax, r.range(0.1, 200)}}; }

Values low(Random&) { return {{dParamLoStop, 0.8}, {dParamHiStop, 1.2}}; }

Values high(Random&) { return {{dParamLoStop, -1.2}, {dParamHiStop, -0.8}}; }

Values inside(Random&) { return {{dParamLoStop, -1.3}, {dParamHiStop, 1.4}}; }

Values crossed(Random&) { return {{dParamLoStop, 1.2}, {dParamHiStop, 0.8}}; }

Values locked(Random& r)
{
    const double at = r.range(-0.3, 0.3);
    return {{dParamLoStop, at}, {dParamHiStop, at}};
}

Values joined(Values a, const Values& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Values locked_motor(Random& r) { return joined(locked(r), motor_weak(r)); }

Values low_soft(Random& r)
{
    return joined(low(r), {{dParamStopERP, r.range(0.1, 0.9)}, {dParamStopCFM, r.range(1e-4, 1e-2)}});
}

Values high_soft(Random& r)
{
    return joined(high(r), {{dParamStopERP, r.range(0.1, 0.9)}, {dParamStopCFM, r.range(1e-4, 1e-2)}});
}

Values locked_soft(Random& r)
{
    return joined(locked(r), {{dParamStopERP, r.range(0.1, 0.9)}, {dParamStopCFM, r.range(1e-4, 1e-2)}});
}

Values low_motor(Random& r) { return joined(low(r), motor_weak(r)); }

Values high_motor(Random& r) { return joined(high(r), motor_weak(r)); }

Values low_fudge(Random& r) { return joined(low_motor(r), {{dParamFudgeFactor, r.range(0, 1)}}); }

Values high_fudge(Random& r) { return joined(high_motor(r), {{dParamFudgeFactor, r.range(0, 1)}}); }

Values low_brake(Random& r) { return joined(low(r), brake(r)); }

Values high_brake(Random& r) { return joined(high(r), brake(r)); }

// A small stop ERP, so that the bounce velocity and not the correction decides in part of the poses.
Values low_bounce(Random& r)
{
    return joined(low(r), {{dParamBounce, r.range(0.2, 1.2)}, {dParamStopERP, r.range(0, 0.02)}});
}

Values high_bounce(Random& r)
{
    return joined(high(r), {{dParamBounce, r.range(0.2, 1.2)}, {dParamStopERP, r.range(0, 0.02)}});
}

}  // namespace

std::vector<JointVariant> limit_variants(SetParam set, int group, const std::string& prefix)
{
    const std::pair<const char*, Values (*)(Random&)> table[] = {
        {"free", none},
        {"motor-weak", motor_weak},
        {"motor-strong", motor_strong},
        {"motor-cfm", motor_cfm},
        {"brake", brake},
        {"low", low},
        {"high", high},
        {"inside", inside},
        {"crossed", crossed},
        {"locked", locked},
        {"locked-motor", locked_motor},
        {"locked-soft", locked_soft},
        {"low-soft", low_soft},
        {"high-soft", high_soft},
        {"low-motor", low_motor},
        {"high-motor", high_motor},
        {"low-fudge", low_fudge},
        {"high-fudge", high_fudge},
        {"low-brake", low_brake},
        {"high-brake", high_brake},
        {"low-bounce", low_bounce},
        {"high-bounce", high_bounce},
    };
    std::vector<JointVariant> variants;
    for (const auto& [name, values] : table) {
        variants.push_back(variant(prefix + name, set, group, values));
    }
    return variants;
}

void add_variants(std::vector<JointVariant>& all, std::vector<JointVariant> more)
{
    for (JointVariant& one : more) { all.push_back(std::move(one)); }
}

void put_params(Output& out, const std::string& key, dJointID joint, GetParam get, int group)
{
    if (key.starts_with("after")) {
        return;  // a step does not change parameters: once per trial is enough
    }
    static const int parameters[] = {dParamLoStop, dParamHiStop,      dParamVel,
                                     dParamFMax,   dParamFudgeFactor, dParamBounce,
                                     dParamCFM,    dParamStopERP,     dParamStopCFM};
    dReal values[9];
    int count = 0;
    for (const int parameter : parameters) { values[count++] = get(joint, parameter + group); }
    out.put(key, values, count);
}

}  // namespace parity
