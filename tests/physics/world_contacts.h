// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Scenes whose world looks after its contacts.
#pragma once

#include <vector>

#include "rig.h"

namespace epode::physics {

inline constexpr double kH = 1.0 / 60;

// A world that looks after its contacts.
class WorldContactsSim : public Sim {
  public:
    explicit WorldContactsSim(Stepper s) : Sim(s)
    {
        substeps = 5;
        gravity(0, 0, -9.81);
        dWorldSetContactSpace(world, space);
    }

    void run(int steps)
    {
        for (int i = 0; i < steps; ++i) ASSERT_TRUE(advance(kH));
    }

    std::vector<dWorldContact> all_contacts() const
    {
        std::vector<dWorldContact> out(std::size_t(dWorldGetContacts(world, nullptr, 0)));
        EXPECT_EQ(dWorldGetContacts(world, out.data(), int(out.size())), int(out.size()));
        return out;
    }

    std::vector<dContactEvent> events() const
    {
        std::vector<dContactEvent> out(std::size_t(dWorldGetContactEvents(world, nullptr, 0)));
        EXPECT_EQ(dWorldGetContactEvents(world, out.data(), int(out.size())), int(out.size()));
        return out;
    }
};

inline dGeomID geom_of(dBodyID body) { return dBodyGetFirstGeom(body); }

inline void set_material(dGeomID geom, double friction, double bounce = 0, V3 belt = {})
{
    dMaterial m{};
    m.struct_size = sizeof m;
    m.friction = real(friction), m.bounce = real(bounce);
    m.surface_velocity[0] = real(belt.x), m.surface_velocity[1] = real(belt.y),
    m.surface_velocity[2] = real(belt.z);
    ASSERT_EQ(dGeomSetMaterial(geom, &m), 1);
}

}  // namespace epode::physics
