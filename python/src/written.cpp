// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Functions with arrays: what a program would count and allocate in C comes back as a new array. Arrays of structures
// are structured arrays of numpy; geoms in them are their id.
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <string>

#include "filter.h"
#include "written_texts.h"

namespace {

nb::object contact_type()
{
    using C = dWorldContact;
    return dtype_of({FIELD(C, g1, "u8"), FIELD(C, g2, "u8"), FIELD(C, pos, "3f8"), FIELD(C, normal, "3f8"),
                     FIELD(C, depth, "f8"), FIELD(C, normal_force, "f8"), FIELD(C, friction_force, "3f8")},
                    sizeof(C));
}
nb::object event_type()
{
    using E = dContactEvent;
    return dtype_of({FIELD(E, kind, "i4"), FIELD(E, g1, "u8"), FIELD(E, g2, "u8")}, sizeof(E));
}
nb::object step_event_type()
{
    using E = dEvent;
    return dtype_of({FIELD(E, kind, "i4"), FIELD(E, gone, "i4"), FIELD(E, g1, "u8"), FIELD(E, g2, "u8"),
                     FIELD(E, joint, "u8"), FIELD(E, pos, "3f8"), FIELD(E, normal, "3f8"),
                     FIELD(E, approach_speed, "f8"), FIELD(E, impulse, "f8")},
                    sizeof(E));
}
nb::object hit_type()
{
    using H = dQueryHit;
    return dtype_of({FIELD(H, geom, "u8"), FIELD(H, pos, "3f8"), FIELD(H, normal, "3f8"),
                     FIELD(H, distance, "f8"), FIELD(H, side, "i4")},
                    sizeof(H));
}

// A type is made once.
template <nb::object (*Make)()>
nb::handle type_of()
{
    static PyObject* const type = Make().release().ptr();
    return type;
}

// Asks for the number, then for the elements.
template <typename T, typename F>
nb::object records(nb::handle dtype, F ask)
{
    int count = ask(static_cast<T*>(nullptr), 0);
    void* data;
    nb::object array = empty_records(dtype, size_t(std::max(count, 0)), &data);
    if (count > 0) ask(static_cast<T*>(data), count);
    return array;
}
template <typename T>
nb::list wrapped_all(const std::vector<T>& handles)
{
    nb::list result;
    for (T handle : handles) result.append(wrapped(handle));
    return result;
}

nb::bytes get_state(const WorldHandle* world)
{
    Call call;
    call.uses(get(world));
    std::string bytes(dWorldGetStateSize(get(world)), '\0');
    dWorldGetState(get(world), bytes.data(), bytes.size());
    call.done();
    return nb::bytes(bytes.data(), bytes.size());
}

void set_state(const WorldHandle* world, nb::bytes state)
{
    Call call;
    call.uses(get(world));
    dWorldSetState(get(world), state.c_str(), state.size());
    call.done();
}

// Handles of the original and their counterparts: bodies, then joints, then geoms and spaces (ode/world_file.h).
nb::dict counterparts(dWorldID world, const std::vector<dHandlePair>& table)
{
    const size_t bodies = size_t(dWorldGetBodies(world, nullptr, 0)),
                 joints = size_t(dWorldGetJoints(world, nullptr, 0));
    nb::dict result;
    for (size_t i = 1; i < table.size(); ++i) {
        void *from = table[i].original, *to = table[i].copy;
        if (i <= bodies)
            result[wrapped(static_cast<dBodyID>(from))] = wrapped(static_cast<dBodyID>(to));
        else if (i <= bodies + joints)
            result[wrapped(static_cast<dJointID>(from))] = wrapped(static_cast<dJointID>(to));
        else
            result[wrapped(static_cast<dGeomID>(from))] = wrapped(static_cast<dGeomID>(to));
    }
    return result;
}

nb::object clone_world(const WorldHandle* world, const SpaceHandle* space)
{
    Call call;
    call.uses(get(world));
    std::vector<dHandlePair> table(size_t(std::max(dWorldCountHandles(get(world), space_of(space)), 0)));
    dSpaceID copied = space_of(space);
    dWorldID clone = dWorldClone(get(world), &copied, table.data(), int(table.size()));
    call.done();
    adopt_functions(get(world), clone);
    return nb::make_tuple(wrapped(clone), wrapped(copied), counterparts(get(world), table));
}

nb::bytes save_to_buffer(const WorldHandle* world, const SpaceHandle* space)
{
    Call call;
    call.uses(get(world));
    std::string bytes(dWorldSaveToBuffer(get(world), space_of(space), nullptr, 0), '\0');
    if (!bytes.empty()) dWorldSaveToBuffer(get(world), space_of(space), bytes.data(), bytes.size());
    call.done();
    return nb::bytes(bytes.data(), bytes.size());
}

nb::object save_world(const WorldHandle* world, const SpaceHandle* space, const std::string& path)
{
    Call call;
    call.uses(get(world));
    int saved = dWorldSave(get(world), space_of(space), path.c_str());
    call.done();
    return nb::cast(saved);
}

template <typename Load>
nb::object loaded(Load load)
{
    Call call;
    dSpaceID space = nullptr;
    dWorldID world = load(&space);
    call.done();
    return nb::make_tuple(wrapped(world), wrapped(space));
}

nb::bytes get_delta(const WorldHandle* world, nb::bytes base)
{
    Call call;
    call.uses(get(world));
    std::string bytes(dWorldGetStateDelta(get(world), base.c_str(), base.size(), nullptr, 0), '\0');
    if (!bytes.empty())
        dWorldGetStateDelta(get(world), base.c_str(), base.size(), bytes.data(), bytes.size());
    call.done();
    return nb::bytes(bytes.data(), bytes.size());
}

void set_delta(const WorldHandle* world, nb::bytes base, nb::bytes delta)
{
    Call call;
    call.uses(get(world));
    dWorldSetStateDelta(get(world), base.c_str(), base.size(), delta.c_str(), delta.size());
    call.done();
}

nb::object step_worlds(const std::vector<WorldHandle*>& worlds, double stepsize, int stepper, int iterations,
                       int steps, int threads)
{
    std::vector<dWorldID> ids;
    for (const WorldHandle* world : worlds) ids.push_back(get(world));
    std::vector<int> made(ids.size() + 1);
    Call call;
    for (dWorldID world : ids) call.uses(world);
    {
        Released released(ids.data(), ids.size());
        dWorldsStep(ids.data(), int(ids.size()), stepsize, stepper, iterations, steps, threads, made.data());
    }
    call.done();
    made.pop_back();
    return nb::cast(made);
}

nb::object ray_all(const SpaceHandle* space, nb::object origin, nb::object direction, double length,
                   const Filter* filter)
{
    auto from = numbers<3>(origin, "origin"), to = numbers<3>(direction, "direction");
    dReal o[4] = {from.v[0], from.v[1], from.v[2]}, d[4] = {to.v[0], to.v[1], to.v[2]};
    Call call;
    call.uses(space_of(space));
    nb::object result = records<dQueryHit>(type_of<hit_type>(), [&](dQueryHit* hits, int n) {
        return dSpaceRayAll(space_of(space), o, d, length, filter_of(filter), hits, n);
    });
    call.done();
    return result;
}

nb::object ray_batch(const SpaceHandle* space, nb::object origins, nb::object directions, nb::object lengths,
                     const Filter* filter, int threads)
{
    auto o = array_in<double>(origins), d = array_in<double>(directions), l = array_in<double>(lengths);
    size_t count = o.size / 3;
    if (o.size % 3 || d.size != o.size || l.size != count || count > (1u << 30))
        throw nb::value_error("origins and directions of n rows of 3 numbers and n lengths expected");
    void* data;
    nb::object result = empty_records(type_of<hit_type>(), count, &data);
    const dQueryFilter* found = filter_of(filter);
    Call call;
    call.uses(space_of(space));
    // With the interpreter's lock: no other thread can change the space meanwhile.
    dSpaceRayBatch(space_of(space), int(count), o.data, d.data, l.data, found, static_cast<dQueryHit*>(data),
                   threads);
    call.done();
    return result;
}

nb::object cast_type()
{
    using H = dCastHit;
    return dtype_of(
        {FIELD(H, geom, "u8"), FIELD(H, pos, "3f8"), FIELD(H, normal, "3f8"), FIELD(H, distance, "f8"),
         FIELD(H, side, "i4"), FIELD(H, face_normal, "3f8"), FIELD(H, depth, "f8")},
        sizeof(H));
}

nb::object cast_all(const SpaceHandle* space, const GeomHandle* geom, nb::object motion, const Filter* filter)
{
    const auto way = numbers<3>(motion, "motion");
    const dReal to[4] = {way.v[0], way.v[1], way.v[2]};
    Call call;
    call.uses(space_of(space));
    nb::object result = records<dCastHit>(type_of<cast_type>(), [&](dCastHit* hits, int n) {
        return dSpaceCastAll(space_of(space), get(geom), to, filter_of(filter), hits, n);
    });
    call.done();
    return result;
}

nb::list overlap(const SpaceHandle* space, const GeomHandle* geom, const Filter* filter)
{
    Call call;
    call.uses(space_of(space));
    auto found = listed<dGeomID>([&](dGeomID* geoms, int n) {
        return dSpaceOverlap(space_of(space), get(geom), filter_of(filter), geoms, n);
    });
    call.done();
    return wrapped_all(found);
}

nb::list collide(const GeomHandle* o1, const GeomHandle* o2, int flags)
{
    std::vector<dContactGeom> contacts(size_t(std::max(flags & 0xffff, 1)));
    Call call;
    call.uses(get(o1));
    call.uses(get(o2));
    int count = dCollide(get(o1), get(o2), flags, contacts.data(), sizeof(dContactGeom));
    call.done();
    nb::list result;
    for (int i = 0; i < count; ++i) result.append(nb::cast(contacts[size_t(i)]));
    return result;
}

nb::list connecting(const BodyHandle* body1, const BodyHandle* body2)
{
    Call call;
    call.uses(get(body1));
    std::vector<dJointID> found(size_t(get(body1) ? std::max(dBodyGetNumJoints(get(body1)), 0) : 0) + 1);
    int count = dConnectingJointList(get(body1), get(body2), found.data());
    call.done();
    found.resize(size_t(count));
    return wrapped_all(found);
}

void hinge2_axes(const JointHandle* joint, nb::object axis1, nb::object axis2)
{
    Numbers<4> a{}, b{};
    if (!axis1.is_none()) read_numbers(axis1, a.v, 3, "axis1");
    if (!axis2.is_none()) read_numbers(axis2, b.v, 3, "axis2");
    Call call;
    call.uses(get(joint));
    dJointSetHinge2Axes(get(joint), axis1.is_none() ? nullptr : a.v, axis2.is_none() ? nullptr : b.v);
    call.done();
}

template <typename P, auto F>
HandleList<P> of_world(const WorldHandle* world)
{
    Call call;
    call.uses(get(world));
    HandleList<P> result{listed<P>([&](P* out, int n) { return F(get(world), out, n); })};
    call.done();
    return result;
}

template <typename T, auto F, nb::object (*Type)()>
nb::object records_of_world(const WorldHandle* world)
{
    Call call;
    call.uses(get(world));
    nb::object result = records<T>(type_of<Type>(), [&](T* out, int n) { return F(get(world), out, n); });
    call.done();
    return result;
}

// Tuples in the order of the members of dDiagnosis, then the text.
nb::list diagnose(const WorldHandle* world)
{
    Call call;
    call.uses(get(world));
    auto causes =
        listed<dDiagnosis>([&](dDiagnosis* out, int n) { return dWorldDiagnose(get(world), out, n); });
    nb::list result;
    for (const dDiagnosis& d : causes) {
        char none;
        std::string text(size_t(std::max(dDiagnosisText(&d, &none, 0), 0)) + 1, '\0');
        dDiagnosisText(&d, text.data(), int(text.size()));
        text.pop_back();
        result.append(nb::make_tuple(d.kind, d.severity, wrapped(d.body), wrapped(d.other), wrapped(d.joint),
                                     wrapped(d.geom), d.figure, d.threshold, d.first_step, d.steps, text));
    }
    call.done();
    return result;
}

std::string defaults_text(int preset)
{
    Call call;
    std::string text(size_t(std::max(dDefaultsText(preset, nullptr, 0), 0)) + 1, '\0');
    call.done();
    dDefaultsText(preset, text.data(), int(text.size()));
    text.pop_back();
    return text;
}

}  // namespace

void bind_written(nb::module_& m)
{
    m.def("dWorldGetBodies", of_world<dBodyID, dWorldGetBodies>, "world"_a.none(), TEXT(dWorldGetBodies));
    m.def("dWorldGetJoints", of_world<dJointID, dWorldGetJoints>, "world"_a.none(), TEXT(dWorldGetJoints));
    m.def("dWorldGetBrokenJoints", of_world<dJointID, dWorldGetBrokenJoints>, "world"_a.none(),
          TEXT(dWorldGetBrokenJoints));
    m.def("dWorldGetState", get_state, "world"_a.none(), TEXT(dWorldGetState));
    m.def("dWorldSetState", set_state, "world"_a.none(), "state"_a, TEXT(dWorldSetState));
    m.def("dWorldGetStateDelta", get_delta, "world"_a.none(), "base"_a, TEXT(dWorldGetStateDelta));
    m.def("dWorldSetStateDelta", set_delta, "world"_a.none(), "base"_a, "delta"_a, TEXT(dWorldSetStateDelta));
    m.def("dWorldClone", clone_world, "world"_a.none(), "space"_a.none() = nb::none(), TEXT(dWorldClone));
    m.def("dWorldSave", save_world, "world"_a.none(), "space"_a.none(), "path"_a, TEXT(dWorldSave));
    m.def("dWorldSaveToBuffer", save_to_buffer, "world"_a.none(), "space"_a.none() = nb::none(),
          TEXT(dWorldSaveToBuffer));
    m.def(
        "dWorldLoad",
        [](const std::string& path) {
            return loaded([&](dSpaceID* space) { return dWorldLoad(path.c_str(), space); });
        },
        "path"_a, TEXT(dWorldLoad));
    m.def(
        "dWorldLoadFromBuffer",
        [](nb::bytes buffer) {
            return loaded(
                [&](dSpaceID* space) { return dWorldLoadFromBuffer(buffer.c_str(), buffer.size(), space); });
        },
        "buffer"_a, TEXT(dWorldLoadFromBuffer));
    m.def("dWorldsStep", step_worlds, "worlds"_a, "stepsize"_a, "stepper"_a = int(dStepperHybrid),
          "iterations"_a = 4, "steps"_a = 1, "threads"_a = 0, TEXT(dWorldsStep));
    m.def("dWorldGetContacts", records_of_world<dWorldContact, dWorldGetContacts, contact_type>,
          "world"_a.none(), TEXT(dWorldGetContacts));
    m.def("dWorldGetContactEvents", records_of_world<dContactEvent, dWorldGetContactEvents, event_type>,
          "world"_a.none(), TEXT(dWorldGetContactEvents));
    m.def("dWorldGetEvents", records_of_world<dEvent, dWorldGetEvents, step_event_type>, "world"_a.none(),
          TEXT(dWorldGetEvents));
    m.def("dWorldDiagnose", diagnose, "world"_a.none(), TEXT(dWorldDiagnose));
    m.def("dDefaultsText", defaults_text, "preset"_a, TEXT(dDefaultsText));
    m.def("dSpaceRayAll", ray_all, "space"_a.none(), "origin"_a, "direction"_a, "length"_a,
          "filter"_a.none() = nb::none(), TEXT(dSpaceRayAll));
    m.def("dSpaceRayBatch", ray_batch, "space"_a.none(), "origins"_a, "directions"_a, "lengths"_a,
          "filter"_a.none() = nb::none(), "threads"_a = 0, TEXT(dSpaceRayBatch));
    m.def("dSpaceCastAll", cast_all, "space"_a.none(), "geom"_a.none(), "motion"_a,
          "filter"_a.none() = nb::none(), TEXT(dSpaceCastAll));
    m.def("dSpaceOverlap", overlap, "space"_a.none(), "geom"_a.none(), "filter"_a.none() = nb::none(),
          TEXT(dSpaceOverlap));
    m.def("dCollide", collide, "o1"_a.none(), "o2"_a.none(), "flags"_a = 8, TEXT(dCollide));
    m.def("dConnectingJointList", connecting, "body1"_a.none(), "body2"_a.none(), TEXT(dConnectingJointList));
    m.def("dJointSetHinge2Axes", hinge2_axes, "joint"_a.none(), "axis1"_a.none(), "axis2"_a.none(),
          TEXT(dJointSetHinge2Axes));
}
