// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/positions/asked.h"

#include <algorithm>

#include "step/island/positions/solved_motion.h"

namespace epode {
namespace {

// Of the whole part, turning as one about its centre of mass.
struct Whole {
    double mass = 0, inertia = 0;
};

Whole whole_of(const IslandWork& work, int first, int last)
{
    Whole whole;
    Vec3 centre{};
    const auto for_each = [&](auto&& use) {
        for (auto i = std::size_t(first); i < std::size_t(last); ++i)
            if (!moves_by_itself(work.system.bodies[i])) use(*work.island.bodies[i]);
    };
    for_each([&](const Body& body) {
        whole.mass += double(body.mass.mass), centre += body.mass.mass * body.position();
    });
    if (whole.mass > 0) centre = centre / Real(whole.mass);
    for_each([&](const Body& body) {
        const Sym3& I = body.inertia;
        whole.inertia += double(body.mass.mass * length2(body.position() - centre) + I.xx + I.yy + I.zz);
    });
    return whole;
}

}  // namespace

double energy_of(const Asked& asked, const IslandWork& work, int part)
{
    const Whole whole = whole_of(work, work.system.begin_of(part).bodies, work.system.end_of(part).bodies);
    return whole.mass * asked.linear + whole.inertia * asked.angular;
}

double asked_by_errors(const IslandWork& work, int part, Real h)
{
    const RowSystem& system = work.system;
    const SystemPart from = system.begin_of(part), to = system.end_of(part);
    Asked asked;
    for (int k = from.blocks; k < to.blocks; ++k) {
        const RowBlock& block = system.blocks[std::size_t(k)];
        for (int i = block.first; i < block.first + block.count; ++i) {
            const Row& row = system.rows[std::size_t(i)];
            if (row.kind != RowKind::kFriction) asked.add(row, double(row.error / h));
        }
    }
    for (int k = from.joint_manifolds; k < to.joint_manifolds; ++k) {
        const JointManifold& m = system.joint_contacts.manifolds[std::size_t(k)];
        for (int i = m.first; i < m.first + m.count; ++i) {
            const double depth = std::max(double(system.joint_contacts.points[std::size_t(i)].error), 0.0);
            asked.linear += depth * depth / double(h * h);
        }
    }
    for (int k = from.contact_manifolds; k < to.contact_manifolds; ++k) {
        const ContactManifold& m = *system.contact_manifolds[std::size_t(k)];
        for (int i = 0; i < m.count; ++i) {
            const double depth = std::min(double(m.points[i].separation), 0.0);
            asked.linear += depth * depth / double(h * h);
        }
    }
    return energy_of(asked, work, part);
}

}  // namespace epode
