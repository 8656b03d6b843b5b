// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A bench for joints alone: a world, bodies where a test wants them, and the rows that a joint writes there.
// No stepper takes part; what a row asks for is read through the policy that dWorldStep uses.
#pragma once

#include <vector>

#include "base/objects/pool.h"
#include "dynamics/joint.h"
#include "dynamics/world.h"
#include "joints/drive_rows.h"
#include "joints/registry.h"
#include "math/trig.h"
#include "rows/policy.h"

namespace epode::test {

inline Quat turn(Vec3 axis, Real angle)
{
    const Vec3 v = epode::sin(angle / 2) * normalized_or(axis, {1, 0, 0});
    return {epode::cos(angle / 2), v.x, v.y, v.z};
}

struct Emitted {
    std::vector<Row> rows;
    Vec3 force[2], torque[2];
    bool applied = false;
};

struct Rig {
    World* world = Pool<World>::create();
    StepInfo info;

    Rig()
    {
        info.h = Real(0.01);
        info.fps = 100;
        info.erp = world->erp;
        info.cfm = world->cfm;
    }
    ~Rig() { Pool<World>::destroy(world); }

    dWorldID id() const { return to_handle(world); }

    Body* body(Vec3 position, Quat q = {})
    {
        Body* b = create_body(*world);
        place(b, position, q);
        return b;
    }
    static void place(Body* b, Vec3 position, Quat q = {})
    {
        store(b->pos, position);
        normalize(q);
        set_orientation(*b, q);
    }
    static void velocity(Body* b, Vec3 v, Vec3 w = {})
    {
        store(b->lvel, v);
        store(b->avel, w);
    }
    static void join(dJointID j, Body* a, Body* b = nullptr) { attach(*from_handle<Joint>(j), a, b); }

    Emitted emit(dJointID id) const
    {
        Joint& j = *from_handle<Joint>(id);
        Row rows[kMaxBlockRows];
        RowWriter out(rows, info);
        emit_joint(j, out);
        Emitted e;
        e.rows.assign(rows, rows + out.count());
        e.applied = out.applied();
        for (int i = 0; i < 2; ++i) e.force[i] = out.force(i), e.torque[i] = out.torque(i);
        return e;
    }
    // The wanted J v of a row.
    Real c(const Row& row) const { return ode_baumgarte(row, info.h, 0).c; }
};

}  // namespace epode::test
