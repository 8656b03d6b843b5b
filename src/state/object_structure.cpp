// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/object_structure.h"

#include "base/check.h"
#include "collide/space.h"
#include "collide/transform.h"
#include "contacts/material.h"
#include "math/rotation.h"
#include "ode/shapes.h"
#include "step/step.h"
#include "step/steppers/stepper.h"

namespace epode {
namespace {

constexpr auto kInfinite = StructureStream::kInfinite;

void sleep_rule(SleepRule& rule, StructureStream& stream)
{
    stream.real(rule.linear_threshold2, kInfinite, 0), stream.real(rule.angular_threshold2, kInfinite, 0);
    stream.number(rule.steps), stream.real(rule.time, kInfinite);
    stream.number(rule.samples, 0, (1 << 20) + 1, "a body in it averages over too many samples");
}

void damping_rule(DampingRule& rule, StructureStream& stream)
{
    stream.real(rule.linear_scale), stream.real(rule.angular_scale);
    stream.real(rule.linear_threshold2, kInfinite, 0), stream.real(rule.angular_threshold2, kInfinite, 0);
}

constexpr const char* kStepper = "an unknown stepper";
constexpr int kJointCoordinates = 128;  // above all iterations of the projection

void solver_settings(World& w, StructureStream& stream)
{
    stream.number(w.quick_iterations, std::numeric_limits<int>::min(), 100001, "too many iterations");
    stream.real(w.quick_w), stream.real(w.warm_starting, StructureStream::kFinite, 0);
    for (bool* on : {&w.friction_cone, &w.manifold_friction, &w.exact_rotation, &w.report_wanted})
        stream.flag(*on);
    stream.number(w.auto_enable_depth);
    stream.number(w.exact_substeps, 1, 1001, "too many substeps");
    // One number, as files of before joint coordinates have it.
    int projection = w.projection_iterations + (w.joint_coordinates ? kJointCoordinates : 0);
    stream.number(projection, 0, kJointCoordinates + 101, "too many iterations of the projection");
    w.joint_coordinates = projection >= kJointCoordinates;
    w.projection_iterations = projection % kJointCoordinates;
    stream.demand(w.projection_iterations <= 100, "too many iterations of the projection");
    stream.real(w.projection_tolerance, StructureStream::kFinite, 0);
    stream.number(w.hybrid_stepper), stream.demand(is_stepper(w.hybrid_stepper), kStepper);
    stream.number(w.hybrid_substeps, 1, kMaxSubsteps + 1, "too many substeps");
    if (!stream.is_older_than(3)) stream.real(w.hybrid_budget, StructureStream::kInfinite, 0);
    stream.number(w.islands_max_threads), stream.number(w.step_threads, 0, 65, "too many threads");
}

// Rings of velocities, so that no body needs more memory than it has bytes.
void samples(Body& body, StructureStream& stream)
{
    int count = body.sleep.samples;
    if (stream.loads() && std::size_t(count) * sizeof(Vec3) > stream.left() && count > 1)
        return stream.fail("a body in it averages over %d samples that are not there", count);
    if (stream.loads() && !stream.demand(set_sleep_samples(body, count), kOutOfMemory)) return;
    for (int i = 0; count > 1 && i < count; ++i)
        stream.vector(body.sample_v[i]), stream.vector(body.sample_w[i]);
}

constexpr int kRules = 256;  // a power of two above all rules

constexpr const char* kMaterial = "a material in it has a number that it cannot have";

void material(dMaterial& m, StructureStream& stream)
{
    stream.real(m.friction, kInfinite), stream.real(m.bounce), stream.real(m.bounce_speed, kInfinite);
    stream.reals(m.surface_velocity, 3);
    for (Real* number : {&m.rolling_friction, &m.compliance, &m.damping_time}) stream.real(*number);
    int rule = m.friction_rule + kRules * m.priority;  // one number, as files of before priorities have it
    int bounce = m.bounce_rule + kRules * m.kind;      // and the same of kinds
    for (int* number : {&rule, &bounce, &m.rolling_friction_rule}) stream.number(*number);
    m.friction_rule = rule & (kRules - 1), m.priority = (rule - m.friction_rule) / kRules;
    m.bounce_rule = bounce & (kRules - 1), m.kind = (bounce - m.bounce_rule) / kRules;
    if (!stream.is_older_than(6)) stream.real(m.cross_friction, kInfinite), stream.reals(m.friction_axis, 3);
    stream.demand(usable_material(m), kMaterial);
}

void own_material(Geom& geom, StructureStream& stream)
{
    bool has = geom.material && own_material(geom)->is_given;
    stream.flag(has);
    if (!has || stream.failed()) return;
    dMaterial m = material_of(geom);
    material(m, stream);
    if (stream.loads() && !stream.failed()) stream.demand(set_material(geom, &m), kOutOfMemory);
}

void face_numbers(Geom& geom, StructureStream& stream)
{
    const auto had = face_numbers(geom);
    const int count = stream.count(int(had.size()), 1, "faces");
    Array<unsigned char> numbers;
    if (stream.failed() || !stream.demand(numbers.resize(count), kOutOfMemory)) return;
    if (stream.saves()) std::copy(had.begin(), had.end(), numbers.begin());
    stream.bytes(numbers.data(), std::size_t(count));
    if (stream.loads() && !stream.failed())
        stream.demand(set_face_numbers(geom, numbers.span()), kOutOfMemory);
}

void face_materials(Geom& geom, StructureStream& stream)
{
    for (int number = 1; number <= kMostFaceMaterials && !stream.failed(); ++number) {
        bool has = has_face_material(geom, number);
        stream.flag(has);
        if (!has || stream.failed()) continue;
        dMaterial m = face_material(geom, number);
        material(m, stream);
        if (stream.loads() && !stream.failed())
            stream.demand(set_face_material(geom, number, &m), kOutOfMemory);
    }
}

void materials(Geom& geom, StructureStream& stream)
{
    own_material(geom, stream);
    if (stream.is_older_than(6) || stream.failed()) return;
    bool has = has_face_materials(geom);
    stream.flag(has);
    if (has) face_numbers(geom, stream), face_materials(geom, stream);
}

}  // namespace

void structure_of_settings(World& w, StructureStream& stream)
{
    stream.vector(w.gravity);
    stream.real(w.erp), stream.real(w.cfm, StructureStream::kFinite, 0);
    stream.real(w.contact_max_vel, kInfinite), stream.real(w.contact_layer);
    solver_settings(w, stream);
    stream.number(w.behaviour);
    stream.demand(w.behaviour == dBehaviour016 || w.behaviour == dBehaviour1, "an unknown behaviour");
    stream.flag(w.auto_disable);
    sleep_rule(w.sleep, stream), damping_rule(w.damping, stream);
    stream.real(w.max_angular_speed, kInfinite, 0);
    stream.pointer(w.data);
}

void structure_of_body(Body& body, StructureStream& stream)
{
    dMass mass = body.mass;
    stream.real(mass.mass), stream.reals(mass.c, 3), stream.reals(mass.I, 12);
    damping_rule(body.damping, stream), sleep_rule(body.sleep, stream);
    samples(body, stream);
    stream.real(body.max_angular_speed, kInfinite, 0);
    stream.number(body.hybrid.requested), stream.demand(is_stepper(body.hybrid.requested), kStepper);
    stream.pointer(body.data);
    if (stream.saves() || stream.failed()) return;
    stream.demand(set_mass(body, mass), "a mass in it is no rigid body's");
}

void structure_of_pose(Real* position, Real* rotation, StructureStream& stream)
{
    stream.reals(position, 3);
    for (int row = 0; row < 3; ++row) stream.reals(rotation + 4 * row, 3);
    if (stream.saves()) return;
    Mat3 R = load_mat(rotation);
    if (stream.demand(make_rotation(R), "a geom in it is turned by a matrix that is no rotation"))
        store_mat(rotation, R);
}

void structure_of_geom(Geom& geom, StructureStream& stream)
{
    std::uint8_t continuous = geom.continuous;
    std::uint64_t category = geom.category, collide = geom.collide;
    bool posed = geom.type->placeable && !geom.body.id && !is_space(geom), sensor = geom.sensor;
    stream.flag(geom.enabled), stream.flag(sensor);
    stream.number(continuous, std::uint8_t(0), std::uint8_t(dContinuousIgnored + 1),
                  "a geom of an unknown mode");
    stream.number(category), stream.number(collide);
    stream.flag(posed);
    if (posed) structure_of_pose(geom.own_position, geom.own_rotation, stream);
    materials(geom, stream);
    stream.pointer(geom.data);
    if (stream.saves()) return;
    geom.category = static_cast<unsigned long>(category), geom.collide = static_cast<unsigned long>(collide);
    const bool may_be = continuous != dContinuousOn || geom.type->half_thickness || as_transform(geom);
    if (stream.demand(may_be && (!continuous || !is_space(geom)), "a geom that cannot be continuous is"))
        set_continuous(geom, continuous);
    if (stream.demand(!sensor || !is_space(geom), "a space in it is a sensor")) set_sensor(geom, sensor);
}

}  // namespace epode
