// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The two books side by side: counts, enumerations in both directions, owners, finite numbers, islands; and
// calls with handles of the dead, of nothing and of the wrong kind, all of which must be refused.
#include <cmath>

#include "attempt.h"

namespace epode::sequences {
namespace {

bool finite(const dReal* v, int n)
{
    for (int i = 0; i < n; ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

dSpaceID as_space(const Geom* geom) { return reinterpret_cast<dSpaceID>(geom ? geom->id : nullptr); }

// Slots are distinguished for 63 objects to come, so the last 32 of a kind to die are recognised for certain.
template <typename T>
T* recently_dead(const Register<T>& all, Dice& dice)
{
    const auto& dead = all.dead();
    const int n = int(std::min<std::size_t>(dead.size(), 32));
    return n ? dead[dead.size() - 1 - std::size_t(dice.below(n))] : nullptr;
}

}  // namespace

bool Player::check()
{
    if (!complaint_.empty()) return false;
    const int before = script.refusals;
    check_worlds();
    check_bodies();
    check_joints();
    check_geoms();
    check_spaces();
    if (script.refusals != before) fail("a call with a living object was refused");
    return complaint_.empty();
}

void Player::check_worlds()
{
    for (const World* world : model.worlds.living()) {
        dVector3 g;
        dWorldGetGravity(world->id, g);
        if (!finite(g, 3)) fail("w[%d]: gravity", world->number);
        for (const Body* body : world->bodies)
            if (dBodyGetWorld(body->id) != world->id) fail("b[%d]: wrong world", body->number);
    }
}

void Player::check_bodies()
{
    for (const Body* body : model.bodies.living()) {
        const int number = body->number;
        const dBodyID id = body->id;
        if (dBodyGetNumJoints(id) != int(body->joints.size())) return fail("b[%d]: number of joints", number);
        for (std::size_t i = 0; i < body->joints.size(); ++i)
            if (dBodyGetJoint(id, int(i)) != body->joints[body->joints.size() - 1 - i]->id)
                return fail("b[%d]: joint %d", number, int(i));
        dGeomID geom = dBodyGetFirstGeom(id);
        for (std::size_t i = body->geoms.size(); i-- > 0; geom = dBodyGetNextGeom(geom))
            if (geom != body->geoms[i]->id) return fail("b[%d]: list of geoms", number);
        if (geom) return fail("b[%d]: a geom too many", number);
        if (!finite(dBodyGetPosition(id), 3) || !finite(dBodyGetRotation(id), 12) ||
            !finite(dBodyGetQuaternion(id), 4) || !finite(dBodyGetLinearVel(id), 3) ||
            !finite(dBodyGetAngularVel(id), 3))
            return fail("b[%d]: not finite", number);
        const dReal* q = dBodyGetQuaternion(id);
        if (!(std::fabs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1) < 1e-3))
            return fail("b[%d]: quaternion", number);
        if (dBodyIsKinematic(id) != int(body->kinematic)) return fail("b[%d]: kinematic", number);
    }
}

void Player::check_joints()
{
    for (const Joint* joint : model.joints.living()) {
        const int number = joint->number;
        int bodies = 0;
        for (int i = 0; i < 2; ++i) {
            const Body* body = joint->body[i];
            bodies += body != nullptr;
            if (dJointGetBody(joint->id, i) != (body ? body->id : nullptr))
                return fail("j[%d]: body %d", number, i);
        }
        if (dJointGetNumBodies(joint->id) != bodies) return fail("j[%d]: number of bodies", number);
        const int type = joint->kind < 0 ? int(dJointTypeContact) : kJointKinds[joint->kind].type;
        if (dJointGetType(joint->id) != type) return fail("j[%d]: type", number);
        // One without all of its joints is disabled.
        if (type != dJointTypeCoupling && dJointIsEnabled(joint->id) != int(!joint->disabled))
            return fail("j[%d]: enabled", number);
    }
}

void Player::check_geoms()
{
    for (const Geom* geom : model.geoms.living()) {
        const int number = geom->number;
        if (dGeomGetSpace(geom->id) != as_space(geom->space)) return fail("o[%d]: space", number);
        if (dGeomGetBody(geom->id) != (geom->body ? geom->body->id : nullptr))
            return fail("o[%d]: body", number);
        if (dGeomIsSpace(geom->id) != int(geom->is_space)) return fail("o[%d]: class", number);
        if (geom->is_transform &&
            dGeomTransformGetGeom(geom->id) != (geom->inner ? geom->inner->id : nullptr))
            return fail("o[%d]: encapsulated geom", number);
        dReal box[6];
        dGeomGetAABB(geom->id, box);
        for (int i = 0; i < 3; ++i)
            if (!(box[2 * i] <= box[2 * i + 1])) return fail("o[%d]: bounding box", number);
        if (geom->placeable && !finite(dGeomGetPosition(geom->id), 3)) return fail("o[%d]: position", number);
    }
}

void Player::check_spaces()
{
    for (const Geom* space : model.geoms.living()) {
        if (!space->is_space) continue;
        const int number = space->number, count = int(space->members.size());
        if (dSpaceGetNumGeoms(as_space(space)) != count) return fail("o[%d]: number of geoms", number);
        for (int i = 0; i < count; ++i) {
            const Geom* geom = space->members[std::size_t(count - 1 - i)];
            if (dSpaceGetGeom(as_space(space), i) != geom->id) return fail("o[%d]: geom %d", number, i);
            if (!dSpaceQuery(as_space(space), geom->id)) return fail("o[%d]: query", number);
        }
    }
}

// After a step: islands are the components of enabled bodies under joints that act, and none of these ties an
// enabled body to a disabled one.
void Player::check_islands(World& world)
{
    if (!dWorldGetStepReportMode(world.id) || !world.plain) return;
    std::vector<int> parent(world.bodies.size());
    const auto place = [&](const Body* body) {
        return int(std::find(world.bodies.begin(), world.bodies.end(), body) - world.bodies.begin());
    };
    const auto root = [&](int i) {
        while (parent[std::size_t(i)] != i) i = parent[std::size_t(i)];
        return i;
    };
    int awake = 0, islands = 0;
    for (std::size_t i = 0; i < parent.size(); ++i) {
        parent[i] = int(i);
        if (!dBodyIsEnabled(world.bodies[i]->id)) continue;
        ++awake, ++islands;
    }
    for (const Joint* joint : world.joints) {
        const Body *a = joint->body[0], *b = joint->body[1];
        if (joint->disabled || !a || !b || (a->kinematic && b->kinematic)) continue;
        if (dBodyIsEnabled(a->id) != dBodyIsEnabled(b->id))
            return fail("j[%d] ties an enabled body to a disabled one after a step", joint->number);
        const int ra = root(place(a)), rb = root(place(b));
        if (ra == rb) continue;
        parent[std::size_t(ra)] = rb;
        if (dBodyIsEnabled(a->id)) --islands;
    }
    dWorldStepReport report;
    report.struct_size = sizeof report;
    if (!dWorldGetStepReport(world.id, &report)) return fail("no report of the step");
    if (report.islands != islands || report.bodies != awake)
        fail("w[%d]: %d islands of %d bodies instead of %d of %d", world.number, report.islands,
             report.bodies, islands, awake);
}

void Player::call_the_dead(Dice& dice)
{
    switch (dice.below(7)) {
        case 0:
            if (World* world = recently_dead(model.worlds, dice)) ATTEMPT(false, dWorldStep, world, 0.01);
            break;
        case 1:
            if (Body* body = recently_dead(model.bodies, dice))
                dice.chance(50) ? ATTEMPT(false, dBodyAddForce, body, 1.0, 0.0, 0.0)
                                : ATTEMPT(false, dBodyDestroy, body);
            break;
        case 2:
            if (Joint* joint = recently_dead(model.joints, dice))
                dice.chance(50) ? ATTEMPT(false, dJointDestroy, joint)
                                : ATTEMPT(false, dJointGetNumBodies, joint);
            break;
        case 3:
            if (Geom* geom = recently_dead(model.geoms, dice))
                dice.chance(50) ? ATTEMPT(false, dGeomDestroy, geom) : ATTEMPT(false, dGeomGetClass, geom);
            break;
        case 4:
            if (Group* group = recently_dead(model.groups, dice)) ATTEMPT(false, dJointGroupEmpty, group);
            break;
        case 5:
            if (Mesh* mesh = recently_dead(model.meshes, dice))
                dice.chance(50) ? ATTEMPT(false, dGeomTriMeshDataUpdate, mesh)
                                : ATTEMPT(false, dGeomTriMeshDataDestroy, mesh);
            break;
        default:
            if (Field* field = recently_dead(model.fields, dice))
                ATTEMPT(false, dGeomHeightfieldDataDestroy, field);
            break;
    }
}

void Player::call_nothing(Dice& dice)
{
    Joint* joint = any(model.joints.living(), dice);
    Body* body = any(model.bodies.living(), dice);
    const Named<dBodyID> no_body{"0", nullptr},
        wrong_body{"(dBodyID)w[0]", [&] {
                       World* world = any(model.worlds.living(), dice);
                       return reinterpret_cast<dBodyID>(world ? world->id : nullptr);
                   }()};
    switch (dice.below(4)) {
        case 0:
            ATTEMPT(false, dBodyEnable, no_body);
            break;
        case 1:
            ATTEMPT(false, dBodyAddTorque, wrong_body, 1.0, 2.0, 3.0);
            break;
        case 2:
            if (joint && body) ATTEMPT(false, dJointAttach, joint, body, body);
            break;
        default:
            ATTEMPT(false, dSpaceClean, (AsSpace{nullptr}));
            break;
    }
}

void Player::check_everything(Dice&)
{
    if (!in_callback()) (void)check();
}

const Player::Entry Player::kEntries[] = {
    {&Player::create_world, 2},
    {&Player::destroy_world, 1},
    {&Player::tune_world, 10},
    {&Player::create_body, 60},
    {&Player::destroy_body, 25},
    {&Player::place_body, 30},
    {&Player::push_body, 40},
    {&Player::tune_body, 30},
    {&Player::sleep_body, 30},
    {&Player::create_joint, 60},
    {&Player::attach_joint, 40},
    {&Player::tune_joint, 80},
    {&Player::watch_joint, 10},
    {&Player::destroy_joint, 20},
    {&Player::use_group, 25},
    {&Player::create_geom, 60},
    {&Player::create_space, 6},
    {&Player::change_space, 40},
    {&Player::tune_space, 10},
    {&Player::set_geom_body, 50},
    {&Player::place_geom, 30},
    {&Player::tune_geom, 30},
    {&Player::offset_geom, 30},
    {&Player::hold_geom, 30},
    {&Player::destroy_geom, 25},
    {&Player::use_field, 10},
    {&Player::use_mesh, 15},
    {&Player::collide, 40},
    {&Player::collide_two, 20},
    {&Player::step, 50},
    {&Player::use_states, 25},
    {&Player::copy_world, 6},
    {&Player::extend_world, 20},
    {&Player::step_worlds, 8},
    {&Player::extend_joint, 40},
    {&Player::couple, 15},
    {&Player::extend_geom, 20},
    {&Player::ask_space, 20},
    {&Player::strike_body, 25},
    {&Player::wet_world, 15},
    {&Player::drive_body, 15},
    {&Player::walk_through, 10},
    {&Player::shape_contacts, 10},
    {&Player::call_the_dead, 40},
    {&Player::call_nothing, 10},
    {&Player::check_everything, 60},
    {nullptr, 0},
};

}  // namespace epode::sequences
