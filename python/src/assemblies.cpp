// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ragdolls, ropes and fracture: functions with lists of structures and of bodies. Lists are copied for each call; a pose is an
// array with a quaternion in each row.
#include <nanobind/stl/vector.h>

#include <string>

#include "filter.h"
#include "written_texts.h"

namespace {

using Bones = std::vector<dBone>;
using Parts = std::vector<dFracturePart>;

template <typename P>
nb::list wrapped_all(const std::vector<P>& handles)
{
    nb::list result;
    for (P handle : handles) result.append(wrapped(handle));
    return result;
}

// As C has vectors: three numbers, and one that does not count.
Numbers<4> vector_of(nb::handle from, const char* what)
{
    Numbers<4> result;
    read_numbers(from, result.v, 3, what);
    return result;
}

// What C takes for a list, an empty one too, which it refuses by its count.
template <typename T>
const T* start_of(const std::vector<T>& list)
{
    static const T none{};
    return list.empty() ? &none : list.data();
}

// Null for none.
template <int N>
const dReal* optional(nb::handle from, Numbers<N>& to, int size, const char* what)
{
    if (from.is_none()) return nullptr;
    read_numbers(from, to.v, size, what);
    return to.v;
}

nb::list make_human(double height, double mass)
{
    dBone bones[16];
    Call call;
    const int count = dBonesMakeHuman(bones, 16, height, mass);
    call.done();
    nb::list result;
    for (int i = 0; i < count; ++i) result.append(nb::cast(bones[i]));
    return result;
}

nb::list create_ragdoll(const WorldHandle* world, const SpaceHandle* space, const Bones& bones,
                        nb::object position, nb::object orientation)
{
    Numbers<4> p, q;
    const dReal *at = optional(position, p, 3, "position"),
                *turned = optional(orientation, q, 4, "orientation");
    std::vector<dBodyID> bodies(bones.size() + 1);
    Call call;
    call.uses(get(world));
    dRagdollCreate(get(world), space_of(space), start_of(bones), int(bones.size()), at, turned,
                   bodies.data());
    call.done();
    bodies.pop_back();
    return wrapped_all(bodies);
}

// A call about the bodies of a figure.
struct Figure {
    Figure(const Bones& list, const BodyList* given) : bones(start_of(list)), count(int(list.size()))
    {
        const std::size_t found = given ? given->v.size() : 0;
        if (!given || found != list.size())
            throw nb::value_error((std::to_string(list.size()) +
                                   " bodies, one for each bone, are expected, not " + std::to_string(found))
                                      .c_str());
        bodies = start_of(given->v);
        for (dBodyID body : given->v) call.uses(body);
    }
    Call call;
    const dBone* bones;
    const dBodyID* bodies = nullptr;
    int count;
};

struct Pose {
    Pose(nb::handle from, int count) : numbers(array_in<double>(from))
    {
        if (numbers.size != 4 * std::size_t(count))
            throw nb::value_error((std::to_string(count) +
                                   " quaternions, a row of w x y z each, are expected, not " +
                                   std::to_string(numbers.size) + " numbers")
                                      .c_str());
    }
    const dQuaternion* rows() const { return reinterpret_cast<const dQuaternion*>(numbers.data); }
    Array<const double> numbers;
};

int set_pose(const Bones& bones, const BodyList* bodies, nb::object pose, double strength)
{
    Figure figure(bones, bodies);
    const Pose wanted(pose, figure.count);
    const int driven = dRagdollSetPose(figure.bones, figure.bodies, figure.count, wanted.rows(), strength);
    figure.call.done();
    return driven;
}

nb::object get_pose(const Bones& bones, const BodyList* bodies)
{
    Figure figure(bones, bodies);
    dReal* rows = nullptr;
    nb::object result = real_array(bones.size(), 4, &rows);
    dRagdollGetPose(figure.bones, figure.bodies, figure.count, reinterpret_cast<dQuaternion*>(rows));
    figure.call.done();
    return result;
}

int follow(const Bones& bones, const BodyList* bodies, nb::object position, nb::object pose, double weight,
           double h)
{
    const auto at = vector_of(position, "position");
    Figure figure(bones, bodies);
    const Pose wanted(pose, figure.count);
    const int following =
        dRagdollFollow(figure.bones, figure.bodies, figure.count, at.v, wanted.rows(), weight, h);
    figure.call.done();
    return following;
}

double get_gap(const Bones& bones, const BodyList* bodies)
{
    Figure figure(bones, bodies);
    const double gap = dRagdollGetGap(figure.bones, figure.bodies, figure.count);
    figure.call.done();
    return gap;
}

nb::object create_rope(const WorldHandle* world, const SpaceHandle* space, nb::object from, nb::object to,
                       const BodyHandle* first, const BodyHandle* last, const dRopeSettings* settings)
{
    const auto begin = vector_of(from, "from_"), end = vector_of(to, "to");
    dRopeSettings given;
    dRopeSettingsInit(&given, sizeof given);
    if (settings) given = *settings;
    // As many places as the library writes, if it does not refuse the number.
    const bool possible = given.links >= 1 && given.links <= 10000;
    std::vector<dBodyID> bodies(possible ? std::size_t(given.links) : 1);
    std::vector<dJointID> joints(bodies.size() + 1);
    Call call;
    call.uses(get(world));
    dRopeCreate(get(world), space_of(space), begin.v, end.v, get(first), get(last), &given, bodies.data(),
                joints.data());
    call.done();
    return nb::make_tuple(wrapped_all(bodies), wrapped_all(joints));
}

void uses_parts(Call& call, const Parts& parts)
{
    for (const dFracturePart& part : parts) call.uses(part.geom);
}

nb::object create_fracture(const WorldHandle* world, const Parts& parts)
{
    Call call;
    call.uses(get(world));
    uses_parts(call, parts);
    const dBodyID body = dFractureCreate(get(world), start_of(parts), int(parts.size()));
    call.done();
    return wrapped(body);
}

int break_body(const Parts& parts, const BodyHandle* body, nb::object center, double radius)
{
    Numbers<4> p;
    const dReal* at = optional(center, p, 3, "center");
    Call call;
    call.uses(get(body));
    const int pieces = dFractureBreak(start_of(parts), int(parts.size()), get(body), at, radius);
    call.done();
    return pieces;
}

int update_fractures(const WorldHandle* world, nb::list given)
{
    std::vector<Parts> lists;
    std::vector<dFracture> fractures;
    for (nb::handle one : given) {
        const auto row = nb::cast<nb::tuple>(one);
        if (row.size() != 3) throw nb::value_error("rows of (parts, strength, radius) are expected");
        lists.push_back(nb::cast<Parts>(row[0]));
        fractures.push_back(
            {nullptr, int(lists.back().size()), nb::cast<double>(row[1]), nb::cast<double>(row[2])});
    }
    Call call;
    call.uses(get(world));
    for (std::size_t i = 0; i < lists.size(); ++i)
        uses_parts(call, lists[i]), fractures[i].parts = start_of(lists[i]);
    const int broken = dFractureUpdate(get(world), start_of(fractures), int(fractures.size()));
    call.done();
    return broken;
}

}  // namespace

void bind_assemblies(nb::module_& m)
{
    m.def("dBonesMakeHuman", make_human, "height"_a, "mass"_a, TEXT(dBonesMakeHuman));
    m.def("dRagdollCreate", create_ragdoll, "world"_a.none(), "space"_a.none(), "bones"_a,
          "position"_a.none() = nb::none(), "orientation"_a.none() = nb::none(), TEXT(dRagdollCreate));
    m.def("dRagdollSetPose", set_pose, "bones"_a, "bodies"_a.none(), "pose"_a, "strength"_a = 1.0,
          TEXT(dRagdollSetPose));
    m.def("dRagdollGetPose", get_pose, "bones"_a, "bodies"_a.none(), TEXT(dRagdollGetPose));
    m.def("dRagdollFollow", follow, "bones"_a, "bodies"_a.none(), "position"_a, "pose"_a, "weight"_a, "h"_a,
          TEXT(dRagdollFollow));
    m.def("dRagdollGetGap", get_gap, "bones"_a, "bodies"_a.none(), TEXT(dRagdollGetGap));
    m.def("dRopeCreate", create_rope, "world"_a.none(), "space"_a.none(), "from_"_a, "to"_a,
          "first"_a.none() = nb::none(), "last"_a.none() = nb::none(), "settings"_a.none() = nb::none(),
          TEXT(dRopeCreate));
    m.def("dFractureCreate", create_fracture, "world"_a.none(), "parts"_a, TEXT(dFractureCreate));
    m.def("dFractureBreak", break_body, "parts"_a, "body"_a.none(), "center"_a.none() = nb::none(),
          "radius"_a = double(dInfinity), TEXT(dFractureBreak));
    m.def("dFractureUpdate", update_fractures, "world"_a.none(), "fractures"_a, TEXT(dFractureUpdate));
}
