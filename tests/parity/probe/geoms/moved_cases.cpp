// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Moved callbacks: who is called, how often, and what the body and its geoms look like at that moment (new
// pose, velocity before damping, accumulators still full). Forces are looked at under dWorldStep only,
// because in the original's QuickStep the torque has been scaled by then.
#include "rig.h"

#include <vector>

namespace parity {
namespace {

struct Seen {
    dBodyID body;
    dReal values[19];  // position, quaternion, velocities, force, torque
};

std::vector<Seen> seen;

void note(dBodyID body)
{
    Seen s;
    s.body = body;
    int count = 0;
    const auto add = [&](const dReal* v, int n) {
        for (int i = 0; i < n; ++i) { s.values[count++] = v[i]; }
    };
    add(dBodyGetPosition(body), 3);
    add(dBodyGetQuaternion(body), 4);
    add(dBodyGetLinearVel(body), 3);
    add(dBodyGetAngularVel(body), 3);
    add(dBodyGetForce(body), 3);
    add(dBodyGetTorque(body), 3);
    seen.push_back(s);
}

void put_seen(Output& out, const std::string& key, bool forces)
{
    int i = 0;
    for (const Seen& s : seen) { out.put(key + std::to_string(i++), s.values, forces ? 19 : 13); }
    seen.clear();
}

PARITY_CASE(body_moved_state)
{
    for (int trial = 0; trial < 30; ++trial) {
        for (const bool quick : {false, true}) {
            out.open_block(std::string(quick ? "quick" : "exact") + "/t" + std::to_string(trial));
            Rig rig(rng, Attach::kAB);
            for (const dBodyID body : {rig.a(), rig.b()}) { dBodySetMovedCallback(body, &note); }
            rig.push(rng, 3.0);
            dBodySetGyroscopicMode(rig.a(), 0);
            dBodySetGyroscopicMode(rig.b(), 0);
            if (trial % 3 == 0) { dBodySetDamping(rig.a(), 0.3, 0.2); }
            if (trial % 4 == 1) { dBodySetKinematic(rig.b()); }
            if (trial % 5 == 2) { dBodyDisable(rig.b()); }
            if (trial % 7 == 3) { dBodySetMaxAngularSpeed(rig.a(), 0.5); }
            if (trial % 6 == 4) {
                dBodySetLinearVel(rig.a(), 0, 0, 0);
                dBodySetAngularVel(rig.a(), 0, 0, 0);
                dBodySetForce(rig.a(), 0, 0, 0);
                dBodySetTorque(rig.a(), 0, 0, 0);
                dBodySetGravityMode(rig.a(), 0);
            }
            quick ? dWorldQuickStep(rig.world(), 0.01) : dWorldStep(rig.world(), 0.01);
            out.put("count.flags", {static_cast<double>(seen.size())});
            put_seen(out, "moved", !quick);
            rig.put_bodies(out, "after");
            dBodySetMovedCallback(rig.a(), nullptr);
            dBodySetPosition(rig.b(), 1, 2, 3);
            dWorldStep(rig.world(), 0.01);
            out.put("second.flags", {static_cast<double>(seen.size())});
            seen.clear();
        }
    }
}

// What a callback may do: set velocities, forces and poses of the body that moved.
void set_velocity(dBodyID body) { dBodySetLinearVel(body, 1, 2, 3); }
void set_force(dBodyID body) { dBodyAddForce(body, 10, 20, 30); }
void set_position(dBodyID body) { dBodySetPosition(body, 7, 8, 9); }
void put_to_sleep(dBodyID body) { dBodyDisable(body); }
void make_kinematic(dBodyID body) { dBodySetKinematic(body); }

PARITY_CASE(body_moved_deeds)
{
    const std::pair<const char*, void (*)(dBodyID)> deeds[] = {{"velocity", set_velocity},
                                                               {"force", set_force},
                                                               {"position", set_position},
                                                               {"sleep", put_to_sleep},
                                                               {"kinematic", make_kinematic}};
    for (const auto& [name, deed] : deeds) {
        for (const bool damped : {false, true}) {
            out.open_block(std::string(name) + (damped ? "/damped" : "/free"));
            Rig rig(rng, Attach::kAB);
            rig.push(rng, 3.0);
            dBodySetMovedCallback(rig.a(), deed);
            if (damped) { dBodySetDamping(rig.a(), 0.25, 0.25); }
            for (int i = 0; i < 3; ++i) {
                dWorldStep(rig.world(), 0.01);
                rig.put_bodies(out, "s" + std::to_string(i));
                out.put("force" + std::to_string(i), dBodyGetForce(rig.a()), 3);
            }
        }
    }
}

// Geoms have followed their bodies when the callback comes.
dGeomID followed = nullptr;
dReal followed_box[6];

void look_at_geom(dBodyID) { dGeomGetAABB(followed, followed_box); }

PARITY_CASE(body_moved_geoms)
{
    for (int trial = 0; trial < 10; ++trial) {
        out.open_block("t" + std::to_string(trial));
        Rig rig(rng, Attach::kA0);
        rig.push(rng, 3.0);
        followed = dCreateBox(nullptr, 1, 2, 3);
        dGeomSetBody(followed, rig.a());
        if (trial % 2) { dGeomSetOffsetPosition(followed, 0.5, 0.6, 0.7); }
        dGeomGetAABB(followed, followed_box);
        dBodySetMovedCallback(rig.a(), &look_at_geom);
        dWorldStep(rig.world(), 0.05);
        out.put("box", followed_box, 6);
        dGeomDestroy(followed);
    }
}

}  // namespace
}  // namespace parity
