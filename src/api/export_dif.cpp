// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldExportDIF. The format is the one that ODE writes, down to names, order and what is left out because
// it is the default; what makes ODE's text unreadable for Lua is put right (commas, bare words), what it
// cannot write is written (plane-2D, double-ball, double-hinge and transmission joints, motion along the
// contact normal, rolling friction, the fourth number of a quaternion), and a vector is left out when it is
// zero, not when one of its elements is. Joints and geoms describe themselves.
#include "ode/export-dif.h"

#include "base/check.h"
#include "base/streams/dif_writer.h"
#include "collide/describe.h"
#include "dynamics/world.h"
#include "step/step.h"

using namespace epode;

namespace {

void put(DifWriter& out, const char* name, Vec3 v) { out.list(name, {v.x, v.y, v.z}); }

void put_nonzero(DifWriter& out, const char* name, Vec3 v)
{
    if (length2(v) > 0) put(out, name, v);
}

void open_sleep(DifWriter& out, const SleepRule& rule)
{
    out.open("auto_disable");
    out.real("linear_threshold", rule.linear_threshold2);
    out.real("angular_threshold", rule.angular_threshold2);
    out.integer("average_samples", rule.samples);
    out.real("idle_time", rule.time);
    out.integer("idle_steps", rule.steps);
}

void write_world(DifWriter& out, const World& world)
{
    out.begin_object("world", -1, "world");
    put(out, "gravity", world.gravity);
    out.open("ODE");
    out.real("ERP", world.erp);
    out.real("CFM", world.cfm);
    open_sleep(out, world.sleep);
    out.close();
    out.close();
    out.end_object();
}

void write_behaviour(DifWriter& out, const Body& body)
{
    out.open("ODE");
    if (body.kinematic()) out.integer("kinematic", 1);
    if (body.finite_rotation) out.integer("finite_rotation", 1);
    if (body.disabled) out.integer("disabled", 1);
    if (!body.gravity) out.integer("no_gravity", 1);
    if (body.auto_disable) {
        open_sleep(out, body.sleep);
        out.real("time_left", body.idle_time_left);
        out.integer("steps_left", body.idle_steps_left);
        out.close();
    }
    put_nonzero(out, "facc", load(body.facc));
    put_nonzero(out, "tacc", load(body.tacc));
    put_nonzero(out, "finite_rotation_axis", body.finite_axis);
    out.close();
}

void write_geoms(DifWriter& out, const Body& body)
{
    const Geom* geom = from_handle<Geom>(body.first_geom);
    if (!geom) return;
    out.open("geometry");
    for (; geom; geom = geom->body_next) {
        out.open();
        describe(out, *geom);
        out.close();
    }
    out.close();
}

void write_body(DifWriter& out, const Body& body, int index)
{
    const Quat q = body.orientation();
    const Real* I = body.mass.I;
    out.begin_object("body", index, "body");
    out.reference("world", "world");
    put(out, "pos", body.position());
    out.list("q", {q.w, q.x, q.y, q.z});
    put(out, "lvel", body.velocity());
    put(out, "avel", body.angular_velocity());
    out.real("mass", body.mass.mass);
    out.rows("I", {{I[0], I[1], I[2]}, {I[4], I[5], I[6]}, {I[8], I[9], I[10]}});
    put_nonzero(out, "com", load(body.mass.c));
    write_behaviour(out, body);
    write_geoms(out, body);
    out.end_object();
}

// Bodies carry their index in `island_index`, which only a step uses.
void write_joint(DifWriter& out, const Joint& joint, int index)
{
    out.begin_object("joint", index, joint.type->dif_name);
    out.reference("world", "world");
    const Body *first = joint.body1(), *second = joint.body2();
    if (second)
        out.references("body", "body", {first->island_index, second->island_index});
    else if (first)
        out.references("body", "body", {first->island_index});
    else
        out.references("body", "body", {});
    joint.type->describe(joint, out);
    out.end_object();
}

}  // namespace

extern "C" [[gnu::cold]] void dWorldExportDIF(dWorldID w, FILE* file, const char* world_name)
{
    World* const world = from_handle<World>(w);
    EPODE_USER(world && file);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world));
    DifWriter out(file, world_name ? world_name : "");
    out.comment("Dynamics Interchange Format v0.1");
    write_world(out, *world);
    out.collection("body");
    int count = 0;
    for (Body& body : world->bodies) {
        body.island_index = count;
        write_body(out, body, count++);
    }
    out.collection("joint");
    count = 0;
    for (const Joint& joint : world->joints) write_joint(out, joint, count++);
    for (Body& body : world->bodies) body.island_index = -1;
}
