// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The target of a row in one of n substeps, hs = h/n.
//
// ODE's pair is a spring k and damper d at step h: ERP = h k/(h k + d), CFM = 1/(h k + d). The same k and d
// at hs are
//
//   CFM_s = CFM / (1 - ERP (1 - 1/n)),   ERP_s = (ERP/n) / (1 - ERP (1 - 1/n)).
//
// A row without position error (motor, friction) is a damper: k = 0, and its CFM does not change. A drive has
// physical units, from which its numbers at hs follow.
//
// Contacts with default softness are soft constraints relative to their effective mass (frequency f, damping
// ratio z, w = 2 pi f):  a1 = 2 z + hs w,  a2 = hs w a1,  rate = w/a1,  C = d/a2   (after Box2D's soft step
// by Catto, 2022: relaxed without bias afterwards, so the bias velocity does not remain). Under the weight of N
// bodies they sink by N g/w^2, whatever the size, so f of world-managed contacts has a limit that grows with
// 1/sqrt(size): lengths and times go together (Froude).
#pragma once

#include <algorithm>
#include <cmath>

#include "rows/policy.h"
#include "rows/row_system.h"

namespace epode {

struct Substep {
    Real hs;
    int n;
};

// J v + C p = c while correcting; while relaxing, `c_relaxed`.
struct RowAim {
    Real rate;               // bias velocity per position error
    Real max_bias_velocity;  // its largest value
    Real C;
    bool spring;  // chosen softness: the error term belongs to the force and stays while relaxing
};

// Above this share of the row's inverse effective mass, CFM is meant as compliance and not as regularisation.
inline constexpr Real kSoftShare = Real(1e-3);

inline RowAim map_row(const Row& row, const Substep& step, Real inverse_mass)
{
    if (row.drive) {
        const DriveAim aim = drive_aim(*row.drive, step.hs);
        return {aim.rate, kInf, aim.C, true};
    }
    const Real erp = row.kind == RowKind::kFriction ? 0 : row.erp;
    const Real share = Real(1) / Real(step.n);
    const Real rest = 1 - erp * (1 - share);
    RowAim aim;
    aim.rate = erp * share / rest / step.hs;
    aim.max_bias_velocity = kInf;
    aim.C = row.cfm / rest / step.hs;
    aim.spring = row.soft || aim.C > kSoftShare * inverse_mass;
    return aim;
}

// The part of c that is not correction.
inline Real target_speed(const Row& row, const Substep& step)
{
    return row.drive ? drive_aim(*row.drive, step.hs).speed : row.speed;
}

// Hz; of bodies at least as large as a cube of 0.4 m.
inline constexpr Real kContactFrequency = 60;
// Substeps allow no more than this.
inline Real frequency_limit(const Substep& step) { return Real(0.125) / step.hs; }

// The limit for bodies of these sizes; the smaller radius of gyration, r^2 = 3 / (m tr I^-1), counts.
inline Real contact_frequency(const SolverBody& a, const SolverBody* b)
{
    constexpr Real kLargeRadius = Real(0.16);
    const auto per_radius2 = [](const SolverBody& body) {
        const Sym3& s = body.inv_inertia;
        return body.inv_mass > 0 ? (s.xx + s.yy + s.zz) / (3 * body.inv_mass) : Real(0);
    };
    const Real q = std::max(per_radius2(a), b ? per_radius2(*b) : Real(0));
    return kContactFrequency * std::sqrt(std::sqrt(std::max(Real(1), kLargeRadius * kLargeRadius * q)));
}

inline RowAim default_contact(const Substep& step, Real inverse_mass, bool against_static,
                              Real frequency = kContactFrequency, Real damping_ratio = 10)
{
    constexpr Real kMaxBiasVelocity = 3;
    const Real f = std::min(frequency, frequency_limit(step)) * (against_static ? 2 : 1);
    const Real w = 2 * kPi * f;
    const Real a1 = 2 * damping_ratio + step.hs * w;
    const Real a2 = step.hs * w * a1;
    return {w / a1, kMaxBiasVelocity, inverse_mass / a2, false};
}

}  // namespace epode
