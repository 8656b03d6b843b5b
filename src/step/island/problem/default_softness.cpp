// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Most islands have no body that is heavy enough, which one look at each body tells.
#include "step/island/problem/default_softness.h"

#include <algorithm>

#include "solve/common/substep_rows.h"

namespace epode {
namespace {

// Of joints: sixteen epsilon in floats, which keep the last digits of a solution from redundant rows. Of contacts: where a
// step is one, how a load is shared by more points than it needs is as well determined as digits allow.
constexpr Real kShareOfJoints = kSingle ? Real(2e-6) : kSoftShare / 2;
constexpr Real kShareOfContacts = Real(0.01), kShareOfContactsInSubsteps = kSoftShare / 2;
static_assert(kShareOfJoints <= kSoftShare / 2,
              "substeps and the projection do not take the default for a spring");

// Is an eigenvalue of M^-1 below x? The least of the inverse inertia S is at least 4 det S / (tr S)^2, because the
// other two multiply to at most (tr S / 2)^2. In double: det S of a body of 50 m is beyond floats.
bool is_heavy(const SolverBody& body, double x)
{
    if (!(body.inv_mass > 0)) return false;
    if (double(body.inv_mass) < x) return true;
    const Sym3& s = body.inv_inertia;
    const double xx = double(s.xx), yy = double(s.yy), zz = double(s.zz);
    const double xy = double(s.xy), xz = double(s.xz), yz = double(s.yz);
    const double trace = xx + yy + zz;
    const double det = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    return 4 * det < x * trace * trace;
}

class Limits {
  public:
    Limits(Real hs, RowSystem& system)
        : system_(system),
          hs_(hs),
          later_(1 - hs / system.h),
          contacts_(hs < system.h ? kShareOfContactsInSubsteps : kShareOfContacts)
    {}

    bool matter() const
    {
        const double least =
            double(kDefaultCfm) / (double(kShareOfJoints) * double(hs_) * double(1 - later_));
        return std::any_of(system_.bodies.begin(), system_.bodies.end(),
                           [least](const SolverBody& body) { return is_heavy(body, least); });
    }

    void limit(const RowBlock& block)
    {
        for (int i = block.first; i < block.first + block.count; ++i) {
            Row& row = system_.rows[std::size_t(i)];
            if (!has_default_softness(row)) continue;
            const Real erp = row.kind == RowKind::kFriction ? 0 : row.erp;
            const Real share = block.contact ? contacts_ : kShareOfJoints;
            const Real d = inverse_mass(block, row), largest = share * hs_ * (1 - erp * later_) * d;
            if (!(d > 0) || row.cfm <= largest) continue;
            row.cfm = largest;
            system_.numbers[std::size_t(i)].C = largest / system_.h;
        }
    }

    void limit(JointManifold& m)
    {
        const Real largest = contacts_ * (mass_share(m.body1) + mass_share(m.body2));
        if (!(largest > 0)) return;
        const auto apply = [&](Real& C) {
            if (C == kDefaultCfm * (1 / system_.h)) C = std::min(C, largest);
        };
        for (int k = 0; k < 2 && !m.slips; ++k) apply(m.C[k]);
        for (JointManifoldPoint& point :
             system_.joint_contacts.points.subspan(std::size_t(m.first), std::size_t(m.count)))
            apply(point.C);
    }

  private:
    Real mass_share(int body) const { return body < 0 ? 0 : system_.bodies[std::size_t(body)].inv_mass; }

    Real inverse_mass(const RowBlock& block, const Row& row) const
    {
        const Real along = block.term_count > 0 ? 0
                                                : mass_share(block.body1) * length2(row.lin1) +
                                                      mass_share(block.body2) * length2(row.lin2);
        return along > 0 ? along : inverse_effective_mass(system_, block, row, system_.bodies);
    }

    RowSystem& system_;
    Real hs_, later_;  // later: the share of the step after its first inner one
    Real contacts_;
};

}  // namespace

bool has_default_softness(const Row& row)
{
    return row.cfm == kDefaultCfm && !row.drive && !(row.soft && row.kind != RowKind::kNormal);
}

void limit_default_softness(const World& world, Real hs, RowSystem& system)
{
    Limits limits(hs, system);
    if (world.acts_as_ode() || !limits.matter()) return;
    for (const RowBlock& block : system.blocks) limits.limit(block);
    for (JointManifold& m : system.joint_contacts.manifolds) limits.limit(m);
}

}  // namespace epode
