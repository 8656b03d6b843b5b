// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The frame of a sequence: dice, callbacks, tearing down. Random numbers: SplitMix64 (Steele, Lea, Flood
// 2014).
#include "player.h"

#include <cstdarg>
#include <cstdio>

namespace epode::sequences {
namespace {

Script* g_refused_in = nullptr;

void count_refusal(int, const char*, va_list)
{
    if (g_refused_in) ++g_refused_in->refusals;
}
void ignore_message(int, const char*, va_list) {}

}  // namespace

std::uint64_t Dice::next()
{
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

Player::Player()
{
    g_refused_in = &script;
    dSetDebugHandler(count_refusal);
    dSetMessageHandler(ignore_message);
}

Player::~Player()
{
    g_refused_in = nullptr;
    dSetDebugHandler(nullptr);
    dSetMessageHandler(nullptr);
}

void Player::fail(const char* format, ...)
{
    if (!complaint_.empty()) return;
    char buffer[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    complaint_ = buffer;
}

void Player::run_once(Dice& dice)
{
    static const int total = [] {
        int sum = 0;
        for (const Entry* e = kEntries; e->run; ++e) sum += e->weight;
        return sum;
    }();
    int ticket = dice.below(total);
    const Entry* e = kEntries;
    while (ticket >= e->weight) ticket -= e++->weight;
    ++calls;
    (this->*e->run)(dice);
}

bool Player::play(std::uint64_t operation)
{
    Dice dice(operation);
    freedom_ = dice.below(4);
    run_once(dice);
    check_invariants();
    return complaint_.empty();
}

// Contacts between the geoms, and now and then something that no callback should do.
void Player::near(dGeomID a, dGeomID b)
{
    ++depth_;
    const int refusals = script.refusals;
    script.enter_callback(true);
    Dice& dice = *near_dice_;
    World* world = near_world_;
    Group* group = near_group_ && near_group_->alive ? near_group_ : nullptr;
    if (world && world->alive && model.joints.living().size() < 150) {
        const int mode = (dice.chance(30) ? int(dContactBounce) : 0) |
                         (dice.chance(30) ? int(dContactSoftCFM) : 0) |
                         (dice.chance(50) ? int(dContactApprox1) : 0);
        CALL(meet, world, group, (Named{"o1", a}), (Named{"o2", b}), 1 + dice.below(4), mode);
        adopt_contacts(*world, group);
    }
    if (freedom_ > 0 && dice.chance(25)) {
        --freedom_;
        run_once(dice);
    }
    script.leave_callback();
    script.refusals = refusals;  // those count for the calls inside
    --depth_;
}

void Player::moved()
{
    ++depth_;
    const int refusals = script.refusals;
    script.enter_callback(false);
    if (moved_dice_ && freedom_ > 0 && moved_dice_->chance(50)) {
        --freedom_;
        run_once(*moved_dice_);
    }
    script.leave_callback();
    script.refusals = refusals;  // those count for the calls inside
    --depth_;
}

void Player::adopt_contacts(World& world, Group* group)
{
    const auto find = [&](dBodyID id) -> Body* {
        for (Body* body : model.bodies.living())
            if (body->id == id) return body;
        if (id) fail("a contact names a body that should be dead");
        return nullptr;
    };
    for (int i = 0; i < made_count; ++i) {
        Joint& joint = model.born_joint(made[i], world, group, -1);
        model.attach(joint, find(dJointGetBody(made[i], 0)), find(dJointGetBody(made[i], 1)));
        script.write("j[" + std::to_string(joint.number) + "] = made[" + std::to_string(i) + "];");
    }
}

// One thing after the other until nothing is left; what takes others along is as likely as the rest.
bool Player::tear_down(std::uint64_t seed)
{
    Dice dice(seed);
    for (;;) {
        const std::size_t left[] = {model.worlds.living().size(), model.bodies.living().size(),
                                    model.joints.living().size(), model.groups.living().size(),
                                    model.geoms.living().size(),  model.fields.living().size(),
                                    model.meshes.living().size()};
        std::size_t all = 0;
        for (std::size_t n : left) all += n;
        if (all == 0) return complaint_.empty();
        if (dies(dice, dice.below(7)) && dice.chance(10) && !check()) return false;
        if (!complaint_.empty()) return false;
    }
}

// One of the kind, if there is one.
bool Player::dies(Dice& dice, int kind)
{
    switch (kind) {
        case 0:
            if (World* world = any(model.worlds.living(), dice)) {
                CALL(dWorldDestroy, world);
                return model.kill(*world), true;
            }
            return false;
        case 1:
            if (Body* body = any(model.bodies.living(), dice)) {
                CALL(dBodyDestroy, body);
                return model.kill(*body), true;
            }
            return false;
        case 2:
            if (Joint* joint = any(model.joints.living(), dice)) {
                CALL(dJointDestroy, joint);
                if (!joint->group) model.kill(*joint);
                return true;
            }
            return false;
        case 3:
            if (Group* group = any(model.groups.living(), dice)) {
                CALL(dJointGroupDestroy, group);
                return model.kill(*group), true;
            }
            return false;
        case 4:
            if (Geom* geom = any(model.geoms.living(), dice)) {
                if (geom->is_space)
                    CALL(dSpaceDestroy, AsSpace{geom});
                else
                    CALL(dGeomDestroy, geom);
                return model.kill(*geom), true;
            }
            return false;
        case 5:
            if (Mesh* mesh = any(model.meshes.living(), dice)) {
                CALL(dGeomTriMeshDataDestroy, mesh);
                return model.meshes.bury(*mesh), true;
            }
            return false;
        default:
            if (Field* field = any(model.fields.living(), dice)) {
                CALL(dGeomHeightfieldDataDestroy, field);
                return model.fields.bury(*field), true;
            }
            return false;
    }
}

}  // namespace epode::sequences
