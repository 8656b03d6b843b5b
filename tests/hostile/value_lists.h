// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hostile values, kind by kind: numbers, arrays of reals, structs, samples, formats. The first of each list
// is sensible. Used by values.cpp only.
#pragma once

#include <array>
#include <climits>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "scene.h"

namespace hostile {

using Limits = std::numeric_limits<dReal>;
constexpr bool kFloat = sizeof(dReal) == 4;
constexpr dReal kNaN = Limits::quiet_NaN(), kInf = Limits::infinity(), kTiny = Limits::denorm_min();
constexpr dReal kLarge = kFloat ? dReal(9e17) : dReal(9e99);      // just below what is refused
constexpr dReal kTooLarge = kFloat ? dReal(1e37) : dReal(1e300);  // above

struct Number {
    dReal value;
    Trait trait;
    const char* text;
};
constexpr Number kReals[] = {{dReal(0.5), Trait::kFine, "0.5"},
                             {1, Trait::kFine, "1"},
                             {0, Trait::kStrange, "0"},
                             {dReal(-0.0), Trait::kStrange, "-0"},
                             {-1, Trait::kStrange, "-1"},
                             {kTiny, Trait::kStrange, "denormal"},
                             {kLarge, Trait::kStrange, "large"},
                             {-kLarge, Trait::kStrange, "-large"},
                             {kTooLarge, Trait::kStrange, "1e300"},
                             {Limits::max(), Trait::kStrange, "max"},
                             {kInf, Trait::kStrange, "inf"},
                             {-kInf, Trait::kStrange, "-inf"},
                             {kNaN, Trait::kNaN, "NaN"}};

struct Integer {
    long long value;
    const char* text;
};
constexpr Integer kInts[] = {
    {1, "1"},          {0, "0"},          {-1, "-1"},           {2, "2"},
    {3, "3"},          {14, "14"},        {36, "36"},           {1000, "1000"},
    {1 << 20, "2^20"}, {32767, "2^15-1"}, {INT_MAX, "INT_MAX"}, {INT_MIN, "INT_MIN"}};
constexpr Integer kSizes[] = {{64, "64"},    {0, "0"}, {1, "1"}, {1ll << 40, "2^40"}, {LLONG_MAX, "2^63-1"},
                              {-1, "2^64-1"}};
constexpr int kStateBuffer = 1 << 18;  // bytes; the state of a scene has fewer
constexpr Integer kBufferSizes[] = {{kStateBuffer, "all"}, {64, "64"}, {24, "24"}, {1, "1"}, {0, "0"}};
constexpr Integer kLengths[] = {{2, "2"}, {1, "1"}, {3, "3"},   {4, "4"},
                                {8, "8"}, {0, "0"}, {-1, "-1"}, {INT_MIN, "INT_MIN"}};
constexpr Integer kSampleCounts[] = {
    {2, "2"}, {3, "3"}, {5, "5"}, {1, "1"}, {0, "0"}, {-1, "-1"}, {INT_MIN, "INT_MIN"}};
constexpr Integer kContactFlags[] = {{4, "4"},   {1, "1"},          {0x7fff0008, "0x7fff0008"},
                                     {0, "0"},   {0x10000, "2^16"}, {INT_MIN, "INT_MIN"},
                                     {-1, "-1"}, {65535, "65535"}};
constexpr Integer kSkips[] = {{sizeof(dContactGeom), "sizeof(dContactGeom)"},
                              {sizeof(dContact), "sizeof(dContact)"},
                              {sizeof(dContactGeom) - 1, "sizeof(dContactGeom)-1"},
                              {0, "0"},
                              {1, "1"},
                              {-1, "-1"},
                              {INT_MIN, "INT_MIN"}};
constexpr Integer kStructSizes[] = {{sizeof(dQueryFilter), "sizeof(dQueryFilter)"},
                                    {sizeof(dMaterial), "sizeof(dMaterial)"},
                                    {sizeof(dDrive), "sizeof(dDrive)"},
                                    {sizeof(dFluidSettings), "sizeof(dFluidSettings)"},
                                    {sizeof(dEventSettings), "sizeof(dEventSettings)"},
                                    {sizeof(dCharacterSettings), "sizeof(dCharacterSettings)"},
                                    {sizeof(dVehicleSettings), "sizeof(dVehicleSettings)"},
                                    {sizeof(dVehicleWheel), "sizeof(dVehicleWheel)"},
                                    {sizeof(dRopeSettings), "sizeof(dRopeSettings)"},
                                    {sizeof(dQueryFilter) - 1, "sizeof(dQueryFilter)-1"},
                                    {0, "0"},
                                    {4, "4"},
                                    {-1, "-1"},
                                    {INT_MAX, "INT_MAX"}};
constexpr Integer kBehaviours[] = {
    {dBehaviour1, "1"}, {dBehaviour016, "0.16"}, {0, "0"}, {-1, "-1"}, {INT_MAX, "INT_MAX"}};
constexpr Integer kThreadCounts[] = {{1, "1"},   {2, "2"},       {0, "0"},
                                     {-1, "-1"}, {1025, "1025"}, {INT_MAX, "INT_MAX"}};
constexpr Integer kFaceCounts[] = {
    {6, "6"}, {5, "5"}, {2, "2"}, {0, "0"}, {(1 << 24) + 1, "2^24+1"}, {UINT_MAX, "2^32-1"}};
constexpr Integer kPointCounts[] = {{8, "8"}, {7, "7"}, {3, "3"}, {0, "0"}, {UINT_MAX, "2^32-1"}};
constexpr Integer kVertexStrides[] = {{32, "32"}, {24, "24"}, {12, "12"},          {11, "11"},
                                      {0, "0"},   {-1, "-1"}, {INT_MIN, "INT_MIN"}};
constexpr Integer kVertexCounts[] = {{4, "4"}, {3, "3"},   {1, "1"},
                                     {0, "0"}, {-1, "-1"}, {INT_MIN, "INT_MIN"}};
constexpr Integer kTriangleStrides[] = {{12, "12"}, {16, "16"}, {13, "13"},          {11, "11"},
                                        {0, "0"},   {-1, "-1"}, {INT_MIN, "INT_MIN"}};
constexpr Integer kCornerCounts[] = {{12, "12"}, {3, "3"},   {10, "10"},          {1, "1"},
                                     {0, "0"},   {-1, "-1"}, {INT_MIN, "INT_MIN"}};
constexpr Integer kParameters[] = {{dParamVel, "dParamVel"},
                                   {dParamLoStop, "dParamLoStop"},
                                   {dParamHiStop, "dParamHiStop"},
                                   {dParamFMax, "dParamFMax"},
                                   {dParamFudgeFactor, "dParamFudgeFactor"},
                                   {dParamBounce, "dParamBounce"},
                                   {dParamCFM, "dParamCFM"},
                                   {dParamStopERP, "dParamStopERP"},
                                   {dParamStopCFM, "dParamStopCFM"},
                                   {dParamSuspensionERP, "dParamSuspensionERP"},
                                   {dParamSuspensionCFM, "dParamSuspensionCFM"},
                                   {dParamERP, "dParamERP"},
                                   {dParamHiStop2, "dParamHiStop2"},
                                   {dParamFMax2, "dParamFMax2"},
                                   {dParamCFM2, "dParamCFM2"},
                                   {dParamVel3, "dParamVel3"},
                                   {dParamLoVel, "dParamLoVel"},
                                   {dParamsInGroup, "14"},
                                   {0x2ff, "0x2ff"},
                                   {0x300, "0x300"},
                                   {-1, "-1"},
                                   {INT_MAX, "INT_MAX"},
                                   {INT_MIN, "INT_MIN"}};

inline void ready_nothing(void*) {}
inline void* give_block(dsizeint size) { return std::malloc(size); }
inline void* give_nothing(dsizeint) { return nullptr; }
inline void take_block(void* block, dsizeint) { std::free(block); }

// ---- arrays of reals ----

struct Array {
    std::vector<dReal> values;
    Trait trait;
    std::string text;
};

inline std::vector<Array> variations(std::vector<dReal> good, std::vector<dReal> other, std::vector<int> read)
{
    const std::size_t n = good.size();
    const auto all = [&](dReal v) { return std::vector<dReal>(n, v); };
    std::vector<Array> list = {{good, Trait::kFine, "good"},
                               {other, Trait::kStrange, "other"},
                               {all(0), Trait::kStrange, "zero"},
                               {all(kTiny), Trait::kStrange, "denormal"},
                               {all(kLarge), Trait::kStrange, "large"},
                               {all(kTooLarge), Trait::kStrange, "1e300"}};
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<dReal> v = good;
        v[i] = kNaN;
        bool counts = false;
        for (int k : read) counts = counts || k == int(i);
        list.push_back({v, counts ? Trait::kNaN : Trait::kFine, "NaN at " + std::to_string(i)});
    }
    std::vector<dReal> v = good;
    v[std::size_t(read.back())] = -kInf;
    list.push_back({v, Trait::kStrange, "-inf at " + std::to_string(read.back())});
    return list;
}

inline const std::vector<Array>& arrays(Kind kind)
{
    static const std::vector<Array> vector3 = variations({0, 0, 1, 0}, {1, 2, 3, 0}, {0, 1, 2});
    static const std::vector<Array> vector4 = variations({0, 0, 1, 0}, {1, 2, 3, 4}, {0, 1, 2, 3});
    static const std::vector<Array> quaternion = variations({1, 0, 0, 0}, {1, -2, 3, -4}, {0, 1, 2, 3});
    static const std::vector<Array> matrix =
        variations({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, {1, 2, 3, 0, 2, 4, 6, 0, 0, 0, -1, 0},
                   {0, 1, 2, 4, 5, 6, 8, 9, 10});
    static const std::vector<Array> matrix4 =
        variations(std::vector<dReal>(16, 1), std::vector<dReal>(16, 2), {0, 5, 15});
    static const std::vector<Array> six = {{std::vector<dReal>(6, 1), Trait::kFine, "room"}};
    static const std::vector<Array> one = {{{1}, Trait::kFine, "room"}};
    static const std::vector<Array> square = [] {
        std::vector<dReal> good(64, dReal(0.1));
        for (std::size_t i = 0; i < 64; i += 9) good[i] = 4;
        std::vector<dReal> wrong = good;
        wrong[0] = kNaN;
        return std::vector<Array>{{good, Trait::kFine, "good"},
                                  {std::vector<dReal>(64, 0), Trait::kStrange, "zero"},
                                  {wrong, Trait::kStrange, "NaN at 0"},
                                  {std::vector<dReal>(64, kTooLarge), Trait::kStrange, "1e300"}};
    }();
    switch (kind) {
        case Kind::kVector3:
            return vector3;
        case Kind::kVector4:
            return vector4;
        case Kind::kQuaternion:
            return quaternion;
        case Kind::kMatrix3:
            return matrix;
        case Kind::kMatrix4:
            return matrix4;
        case Kind::kVector6:
            return six;
        case Kind::kReals:
            return square;
        default:
            return one;
    }
}

// ---- structs ----

template <typename T>
struct Item {
    T value;
    Trait trait;
    const char* text;
};

inline dMass unit_mass()
{
    dMass m{};
    m.mass = m.I[0] = m.I[5] = m.I[10] = 1;
    return m;
}

template <typename Change>
dDrive drive_with(Change&& change)
{
    dDrive d{};
    d.struct_size = sizeof d;
    change(d);
    return d;
}

inline const std::vector<Item<dDrive>>& drives()
{
    static const std::vector<Item<dDrive>> list = {
        {drive_with([](dDrive& d) { d.stiffness = 100, d.damping = 1, d.target = dReal(0.5); }), Trait::kFine,
         "a spring"},
        {drive_with([](dDrive& d) { d.armature = 2, d.friction = 1, d.force = 3; }), Trait::kFine, "a rotor"},
        {drive_with([](dDrive& d) { d.stiffness = 9, d.armature = 1, d.force_limit = 1; }), Trait::kFine,
         "a limited servo"},
        {drive_with([](dDrive&) {}), Trait::kStrange, "nothing"},
        {drive_with([](dDrive& d) { d.struct_size = 0; }), Trait::kBad, "struct_size 0"},
        {drive_with([](dDrive& d) { d.stiffness = kLarge; }), Trait::kStrange, "as stiff as can be"},
        {drive_with([](dDrive& d) { d.armature = d.damping = kTiny; }), Trait::kStrange, "denormal"},
        {drive_with([](dDrive& d) { d.stiffness = -1; }), Trait::kStrange, "stiffness -1"},
        {drive_with([](dDrive& d) { d.stiffness = kNaN; }), Trait::kNaN, "stiffness NaN"},
        {drive_with([](dDrive& d) { d.damping = kInf; }), Trait::kStrange, "damping inf"},
        {drive_with([](dDrive& d) { d.damping = kNaN; }), Trait::kNaN, "damping NaN"},
        {drive_with([](dDrive& d) { d.armature = -1; }), Trait::kStrange, "armature -1"},
        {drive_with([](dDrive& d) { d.armature = kNaN; }), Trait::kNaN, "armature NaN"},
        {drive_with([](dDrive& d) { d.friction = kNaN; }), Trait::kNaN, "friction NaN"},
        {drive_with([](dDrive& d) { d.target = kNaN; }), Trait::kNaN, "target NaN"},
        {drive_with([](dDrive& d) { d.target_velocity = kNaN; }), Trait::kNaN, "target velocity NaN"},
        {drive_with([](dDrive& d) { d.force = kLarge, d.force_limit = kInf; }), Trait::kStrange,
         "force large"},
        {drive_with([](dDrive& d) { d.force = kNaN; }), Trait::kNaN, "force NaN"},
        {drive_with([](dDrive& d) { d.force_limit = -1; }), Trait::kStrange, "limit -1"},
        {drive_with([](dDrive& d) { d.force_limit = kNaN; }), Trait::kNaN, "limit NaN"}};
    return list;
}

inline const std::vector<Item<dCharacterSettings>>& character_settings()
{
    static const auto with = [](auto change) {
        dCharacterSettings s;
        dCharacterSettingsInit(&s, sizeof s);
        change(s);
        return s;
    };
    static const std::vector<Item<dCharacterSettings>> list = {
        {with([](auto&) {}), Trait::kFine, "the defaults"},
        {with([](auto& s) { s.shape = dBoxClass; }), Trait::kFine, "a box"},
        {with([](auto& s) { s.shape = dCylinderClass, s.max_force = 1; }), Trait::kFine, "a cylinder"},
        {with([](auto& s) { s.step_height = s.stick_distance = 0; }), Trait::kFine, "no steps"},
        {with([](auto& s) { s.up[0] = 3, s.up[2] = 0; }), Trait::kFine, "up along x"},
        {with([](auto& s) { s.shape = dSphereClass; }), Trait::kBad, "a sphere"},
        {with([](auto& s) { s.shape = INT_MIN; }), Trait::kBad, "shape INT_MIN"},
        {with([](auto& s) { s.struct_size = 0; }), Trait::kBad, "struct_size 0"},
        {with([](auto& s) { s.radius = 0; }), Trait::kBad, "radius 0"},
        {with([](auto& s) { s.radius = kLarge; }), Trait::kBad, "large radius"},
        {with([](auto& s) { s.height = s.radius; }), Trait::kBad, "too low"},
        {with([](auto& s) { s.skin = s.radius; }), Trait::kBad, "skin as the radius"},
        {with([](auto& s) { s.up[2] = 0; }), Trait::kBad, "up of length 0"},
        {with([](auto& s) { s.slope_limit = 2; }), Trait::kBad, "slope 2"},
        {with([](auto& s) { s.max_force = -1; }), Trait::kBad, "force -1"},
        {with([](auto& s) { s.step_height = 1e5; }), Trait::kStrange, "steps of 100 km"},
        {with([](auto& s) { s.up[1] = kNaN; }), Trait::kNaN, "up NaN"},
        {with([](auto& s) { s.radius = kNaN; }), Trait::kNaN, "radius NaN"},
        {with([](auto& s) { s.air_acceleration = kNaN; }), Trait::kNaN, "air NaN"}};
    return list;
}

// As many as the largest length; what is wrong is wrong in the first.
struct BoneList {
    dBone bones[8];
};
inline const std::vector<Item<BoneList>>& bone_lists()
{
    static const auto with = [](auto change) {
        BoneList list{};
        for (int i = 0; i < 8; ++i) {
            dBone& bone = list.bones[i];
            bone.parent = i - 1;
            bone.size[0] = bone.size[1] = bone.size[2] = dReal(0.1);
            bone.position[2] = dReal(0.3) * dReal(i);
            bone.joint = i % 4;
            bone.anchor[2] = dReal(0.3) * dReal(i) - dReal(0.15);
            bone.axis[2] = bone.swing[0] = 1;
            bone.stiffness = bone.damping = 1;
        }
        change(list.bones[0], list.bones[1]);
        return list;
    };
    static const std::vector<Item<BoneList>> list = {
        {with([](auto&, auto&) {}), Trait::kFine, "a chain"},
        {with([](auto& b, auto&) { b.shape = dBoneSphere, b.size[1] = kNaN; }), Trait::kFine, "unused NaN"},
        {with([](auto& b, auto&) { b.parent = 0; }), Trait::kBad, "its own parent"},
        {with([](auto& b, auto&) { b.parent = INT_MIN; }), Trait::kBad, "parent INT_MIN"},
        {with([](auto& b, auto&) { b.shape = 3; }), Trait::kBad, "shape 3"},
        {with([](auto& b, auto&) { b.shape = INT_MIN; }), Trait::kBad, "shape INT_MIN"},
        {with([](auto& b, auto&) { b.size[0] = 0; }), Trait::kBad, "size 0"},
        {with([](auto& b, auto&) { b.mass = -1; }), Trait::kBad, "mass -1"},
        {with([](auto& b, auto&) { b.density = -1; }), Trait::kBad, "density -1"},
        {with([](auto&, auto& b) { b.parent = 1; }), Trait::kStrange, "the second is its own parent"},
        {with([](auto&, auto& b) { b.joint = 4; }), Trait::kStrange, "joint 4"},
        {with([](auto&, auto& b) { b.axis[2] = 0; }), Trait::kStrange, "no axis"},
        {with([](auto&, auto& b) { b.joint = dBoneBall, b.low[1] = -2; }), Trait::kStrange, "wide"},
        {with([](auto&, auto& b) { b.stiffness = kNaN; }), Trait::kStrange, "stiffness NaN"},
        {with([](auto& b, auto&) { b.size[1] = kNaN; }), Trait::kNaN, "size NaN"},
        {with([](auto& b, auto&) { b.position[0] = kNaN; }), Trait::kNaN, "position NaN"},
        {with([](auto& b, auto&) { b.orientation[3] = kNaN; }), Trait::kNaN, "orientation NaN"}};
    return list;
}

// The scene's cone and ellipsoid are on no body; beyond these two there is nothing.
struct PartList {
    dFracturePart parts[8];
};
inline std::vector<Item<PartList>> part_lists(const Scene& scene)
{
    const auto& live = scene.live[std::size_t(Kind::kGeom)];
    const auto with = [&](auto change) {
        PartList list{};
        for (std::size_t i = 0; i < 2 && live.size() > 15; ++i)
            list.parts[i].geom = static_cast<dGeomID>(live[14 + i]);
        change(list.parts[0]);
        return list;
    };
    const auto dead = static_cast<dGeomID>(scene.dead[std::size_t(Kind::kGeom)]);
    return {{with([](auto&) {}), Trait::kFine, "two solids"},
            {with([](auto& p) { p.geom = nullptr; }), Trait::kBad, "no geom"},
            {with([=](auto& p) { p.geom = dead; }), Trait::kBad, "destroyed geom"},
            {with([](auto& p) { p.density = -1; }), Trait::kBad, "density -1"},
            {with([](auto& p) { p.density = kNaN; }), Trait::kNaN, "density NaN"}};
}

struct FractureList {
    dFracture list[8];
};
inline std::vector<Item<FractureList>> fracture_lists(const Scene& scene)
{
    static PartList parts;
    parts = part_lists(scene)[0].value;
    const auto with = [&](auto change) {
        FractureList out{};
        for (dFracture& f : out.list) f = {parts.parts, 2, 1, 1};
        change(out.list[0]);
        return out;
    };
    return {{with([](auto&) {}), Trait::kFine, "all alike"},
            {with([](auto& f) { f.strength = f.radius = kInf; }), Trait::kFine, "infinite"},
            {with([](auto& f) { f.parts = nullptr; }), Trait::kStrange, "no parts"},
            {with([](auto& f) { f.count = INT_MIN; }), Trait::kStrange, "count INT_MIN"},
            {with([](auto& f) { f.count = 3; }), Trait::kStrange, "count 3"},
            {with([](auto& f) { f.strength = -1; }), Trait::kStrange, "strength -1"},
            {with([](auto& f) { f.strength = kNaN; }), Trait::kStrange, "strength NaN"},
            {with([](auto& f) { f.radius = kNaN; }), Trait::kStrange, "radius NaN"}};
}

inline const std::vector<Item<dRopeSettings>>& rope_settings()
{
    static const auto with = [](auto change) {
        dRopeSettings s;
        dRopeSettingsInit(&s, sizeof s);
        s.links = 3, s.length = 50;
        change(s);
        return s;
    };
    static const std::vector<Item<dRopeSettings>> list = {
        {with([](auto&) {}), Trait::kFine, "three links"},
        {with([](auto& s) { s.width = 1, s.ends = dRopeLoose; }), Trait::kFine, "planks"},
        {with([](auto& s) { s.stretch = dReal(0.1), s.load = 10; }), Trait::kFine, "elastic"},
        {with([](auto& s) { s.struct_size = 0; }), Trait::kBad, "struct_size 0"},
        {with([](auto& s) { s.links = 0; }), Trait::kBad, "no links"},
        {with([](auto& s) { s.links = INT_MAX; }), Trait::kBad, "links INT_MAX"},
        {with([](auto& s) { s.length = -1; }), Trait::kBad, "length -1"},
        {with([](auto& s) { s.mass = 0; }), Trait::kBad, "mass 0"},
        {with([](auto& s) { s.radius = 10; }), Trait::kBad, "thick"},
        {with([](auto& s) { s.ends = 4; }), Trait::kBad, "ends 4"},
        {with([](auto& s) { s.width = s.stretch = 1; }), Trait::kBad, "elastic planks"},
        {with([](auto& s) { s.load = 0; }), Trait::kBad, "load 0"},
        {with([](auto& s) { s.links = 1, s.length = 0; }), Trait::kStrange, "one link"},
        {with([](auto& s) { s.length = kNaN; }), Trait::kNaN, "length NaN"},
        {with([](auto& s) { s.mass = kNaN; }), Trait::kNaN, "mass NaN"},
        {with([](auto& s) { s.stretch = kNaN; }), Trait::kNaN, "stretch NaN"}};
    return list;
}

struct BoneBuffer {
    dBone bones[16];
};
inline const std::vector<Item<BoneBuffer>>& bone_buffers()
{
    static const std::vector<Item<BoneBuffer>> list = {{{}, Trait::kFine, "a buffer"}};
    return list;
}

struct PoseList {
    dQuaternion pose[8];
};
inline const std::vector<Item<PoseList>>& poses()
{
    static const auto with = [](dReal w, dReal x) {
        PoseList list{};
        for (dQuaternion& q : list.pose) q[0] = 1;
        list.pose[0][0] = w, list.pose[0][1] = x;
        return list;
    };
    static const std::vector<Item<PoseList>> list = {{with(1, 0), Trait::kFine, "straight"},
                                                     {with(2, 5), Trait::kFine, "not of length 1"},
                                                     {with(0, 0), Trait::kBad, "of length 0"},
                                                     {with(kNaN, 0), Trait::kNaN, "NaN"}};
    return list;
}

inline const std::vector<Item<dVehicleSettings>>& vehicle_settings()
{
    static const auto with = [](auto change) {
        dVehicleSettings s;
        dVehicleSettingsInit(&s, sizeof s);
        change(s);
        return s;
    };
    static const std::vector<Item<dVehicleSettings>> list = {
        {with([](auto&) {}), Trait::kFine, "the defaults"},
        {with([](auto& s) { s.kind = dVehicleBike, s.abs = 1; }), Trait::kFine, "a bike"},
        {with([](auto& s) { s.kind = dVehicleTracked, s.differential = dDifferentialLocked; }), Trait::kFine,
         "tracks"},
        {with([](auto& s) { s.gears = 1, s.torque_points = 2; }), Trait::kFine, "one gear"},
        {with([](auto& s) { s.engine_torques[15] = kNaN, s.gear_ratios[9] = kNaN; }), Trait::kFine,
         "unused NaN"},
        {with([](auto& s) { s.kind = 0; }), Trait::kBad, "kind 0"},
        {with([](auto& s) { s.kind = INT_MAX; }), Trait::kBad, "kind INT_MAX"},
        {with([](auto& s) { s.struct_size = 0; }), Trait::kBad, "struct_size 0"},
        {with([](auto& s) { s.up[2] = 0; }), Trait::kBad, "up of length 0"},
        {with([](auto& s) { s.forward[0] = 0, s.forward[2] = 1; }), Trait::kBad, "forward along up"},
        {with([](auto& s) { s.torque_points = 17; }), Trait::kBad, "17 points"},
        {with([](auto& s) { s.torque_points = INT_MIN; }), Trait::kBad, "points INT_MIN"},
        {with([](auto& s) { s.engine_speeds[1] = 0; }), Trait::kBad, "equal speeds"},
        {with([](auto& s) { s.gears = 11; }), Trait::kBad, "11 gears"},
        {with([](auto& s) { s.gear_ratios[0] = 0; }), Trait::kBad, "ratio 0"},
        {with([](auto& s) { s.differential = 0; }), Trait::kBad, "differential 0"},
        {with([](auto& s) { s.max_steer = 2; }), Trait::kBad, "steer 2"},
        {with([](auto& s) { s.engine_inertia = 0; }), Trait::kBad, "inertia 0"},
        {with([](auto& s) { s.drag = 1e11, s.clutch_torque = 1e11; }), Trait::kStrange, "much drag"},
        {with([](auto& s) { s.engine_torques[1] = kNaN; }), Trait::kNaN, "torque NaN"},
        {with([](auto& s) { s.lean_limit = kNaN; }), Trait::kNaN, "lean NaN"},
        {with([](auto& s) { s.up[1] = kNaN; }), Trait::kNaN, "up NaN"}};
    return list;
}

inline const std::vector<Item<dVehicleWheel>>& vehicle_wheels()
{
    static const auto with = [](auto change) {
        dVehicleWheel w;
        dVehicleWheelInit(&w, sizeof w);
        change(w);
        return w;
    };
    static const std::vector<Item<dVehicleWheel>> list = {
        {with([](auto&) {}), Trait::kFine, "the defaults"},
        {with([](auto& w) { w.cast = dWheelCylinder, w.axle = 5, w.drive = 1; }), Trait::kFine, "a cylinder"},
        {with([](auto& w) { w.cast = dWheelSphere, w.axle = 6, w.position[0] = 1; }), Trait::kFine,
         "a sphere"},
        {with([](auto& w) { w.travel = w.stiffness = 0, w.axle = 7; }), Trait::kFine, "no spring"},
        {with([](auto& w) { w.cast = 0; }), Trait::kBad, "cast 0"},
        {with([](auto& w) { w.cast = INT_MIN; }), Trait::kBad, "cast INT_MIN"},
        {with([](auto& w) { w.struct_size = 0; }), Trait::kBad, "struct_size 0"},
        {with([](auto& w) { w.radius = 0; }), Trait::kBad, "radius 0"},
        {with([](auto& w) { w.axle = 32; }), Trait::kBad, "axle 32"},
        {with([](auto& w) { w.axle = -1; }), Trait::kBad, "axle -1"},
        {with([](auto& w) { w.sliding = 2; }), Trait::kBad, "sliding 2"},
        {with([](auto& w) { w.steer = -2; }), Trait::kBad, "steer -2"},
        {with([](auto& w) { w.position[1] = kLarge; }), Trait::kBad, "far away"},
        {with([](auto& w) { w.stiffness = w.bump_damping = 1e11, w.axle = 8; }), Trait::kStrange, "stiff"},
        {with([](auto& w) { w.radius = 1e5, w.travel = 1e5, w.axle = 9; }), Trait::kStrange, "large"},
        {with([](auto& w) { w.position[2] = kNaN; }), Trait::kNaN, "position NaN"},
        {with([](auto& w) { w.friction_y = kNaN; }), Trait::kNaN, "friction NaN"},
        {with([](auto& w) { w.steer = kNaN; }), Trait::kNaN, "steer NaN"}};
    return list;
}

inline const std::vector<Item<dVehicleControls>>& vehicle_controls()
{
    static const auto with = [](auto change) {
        dVehicleControls c{};
        c.struct_size = sizeof c;
        change(c);
        return c;
    };
    static const std::vector<Item<dVehicleControls>> list = {
        {with([](auto&) {}), Trait::kFine, "none"},
        {with([](auto& c) { c.throttle = 1, c.steer = -1; }), Trait::kFine, "full throttle"},
        {with([](auto& c) { c.brake = c.handbrake = c.clutch = 1; }), Trait::kFine, "brakes"},
        {with([](auto& c) { c.struct_size = 0; }), Trait::kBad, "struct_size 0"},
        {with([](auto& c) { c.throttle = 2; }), Trait::kBad, "throttle 2"},
        {with([](auto& c) { c.brake = -1; }), Trait::kBad, "brake -1"},
        {with([](auto& c) { c.steer = kLarge; }), Trait::kBad, "steer large"},
        {with([](auto& c) { c.steer = kNaN; }), Trait::kNaN, "steer NaN"},
        {with([](auto& c) { c.clutch = kNaN; }), Trait::kNaN, "clutch NaN"}};
    return list;
}

inline const std::vector<Item<dEventSettings>>& event_settings()
{
    static const auto with = [](auto change) {
        dEventSettings s{sizeof(dEventSettings), 63, 64, 0, 0};
        change(s);
        return s;
    };
    static const std::vector<Item<dEventSettings>> list = {
        {with([](auto&) {}), Trait::kFine, "all kinds"},
        {with([](auto& s) { s.kinds = 24; }), Trait::kFine, "sensors"},
        {with([](auto& s) { s.capacity = 1, s.min_impulse = 1; }), Trait::kFine, "one"},
        {with([](auto& s) { s.kinds = 0; }), Trait::kStrange, "no kinds"},
        {with([](auto& s) { s.kinds = ~0u; }), Trait::kBad, "unknown kinds"},
        {with([](auto& s) { s.struct_size = 0; }), Trait::kBad, "struct_size 0"},
        {with([](auto& s) { s.capacity = 0; }), Trait::kBad, "capacity 0"},
        {with([](auto& s) { s.capacity = INT_MAX; }), Trait::kBad, "capacity INT_MAX"},
        {with([](auto& s) { s.capacity = INT_MIN; }), Trait::kBad, "capacity INT_MIN"},
        {with([](auto& s) { s.min_impulse = kLarge; }), Trait::kStrange, "large impulse"},
        {with([](auto& s) { s.min_impulse = kNaN; }), Trait::kNaN, "impulse NaN"},
        {with([](auto& s) { s.min_approach_speed = -1; }), Trait::kBad, "speed -1"},
        {with([](auto& s) { s.min_approach_speed = kNaN; }), Trait::kNaN, "speed NaN"}};
    return list;
}

inline const std::vector<Item<dFluidSettings>>& fluid_settings()
{
    static const auto with = [](auto change) {
        dFluidSettings s{};
        dFluidSettingsInit(&s, sizeof s);
        change(s);
        return s;
    };
    static const std::vector<Item<dFluidSettings>> list = {
        {with([](auto&) {}), Trait::kFine, "water"},
        {with([](auto& s) { s.density = s.drag = s.linear_drag = 0; }), Trait::kFine, "nothing"},
        {with([](auto& s) { s.density = kLarge; }), Trait::kStrange, "large density"},
        {with([](auto& s) { s.current[1] = kLarge, s.drag = kLarge; }), Trait::kStrange,
         "large current and drag"},
        {with([](auto& s) { s.struct_size = 0; }), Trait::kBad, "struct_size 0"},
        {with([](auto& s) { s.density = -1; }), Trait::kBad, "density -1"},
        {with([](auto& s) { s.angular_drag = -1; }), Trait::kBad, "angular drag -1"},
        {with([](auto& s) { s.drag = kNaN; }), Trait::kNaN, "drag NaN"},
        {with([](auto& s) { s.current[2] = kNaN; }), Trait::kNaN, "current NaN"}};
    return list;
}

template <typename Change>
dMaterial material_with(Change&& change)
{
    dMaterial m{};
    m.struct_size = sizeof m;
    change(m);
    return m;
}

inline const std::vector<Item<dQueryFilter>>& filters()
{
    static const auto with = [](auto change) {
        dQueryFilter f{sizeof(dQueryFilter), ~0ul, ~0ul, nullptr, nullptr, nullptr, 0};
        change(f);
        return f;
    };
    using F = dQueryFilter;
    static const std::vector<Item<F>> list = {
        {with([](F&) {}), Trait::kFine, "everything"},
        {with([](F& f) { f.category_bits = f.collide_bits = 0; }), Trait::kFine, "nothing"},
        {with([](F& f) { f.callback = [](void*, dGeomID) { return 0; }; }), Trait::kFine, "rejects all"},
        {with([](F& f) { f.callback = [](void*, dGeomID) { return 1; }; }), Trait::kFine, "keeps all"},
        {with([](F& f) { f.struct_size = offsetof(F, skip_body), f.skip_body = dBodyID(-1); }), Trait::kFine,
         "bits alone"},
        {with([](F& f) { f.skip_body = dBodyID(-1); }), Trait::kBad, "skip_body -1"},
        {with([](F& f) { f.struct_size = 0; }), Trait::kBad, "size 0"},
        {with([](F& f) { f.struct_size = 4; }), Trait::kBad, "size 4"},
        {with([](F& f) { f.struct_size = UINT_MAX; }), Trait::kBad, "size UINT_MAX"}};
    return list;
}

inline const std::vector<Item<dMaterial>>& materials()
{
    static const std::vector<Item<dMaterial>> list = {
        {material_with([](dMaterial& m) { m.friction = dReal(0.3), m.bounce = dReal(0.5); }), Trait::kFine,
         "dull"},
        {material_with([](dMaterial& m) { m.surface_velocity[0] = 2; }), Trait::kFine, "a belt"},
        {material_with(
             [](dMaterial& m) { m.rolling_friction = 1, m.compliance = dReal(1e-4), m.damping_time = 1; }),
         Trait::kFine, "rubber"},
        {material_with([](dMaterial& m) {
             m.friction_rule = dCombineProduct, m.rolling_friction_rule = dCombineAverage;
         }),
         Trait::kFine, "rules"},
        {material_with([](dMaterial& m) { m.struct_size = offsetof(dMaterial, bounce), m.bounce = kNaN; }),
         Trait::kFine, "friction alone"},
        {material_with([](dMaterial& m) { m.struct_size = 0; }), Trait::kBad, "size 0"},
        {material_with([](dMaterial& m) { m.struct_size = 4; }), Trait::kBad, "size 4"},
        {material_with([](dMaterial& m) { m.struct_size = UINT_MAX; }), Trait::kBad, "size UINT_MAX"},
        {material_with([](dMaterial& m) { m.rolling_friction = -1; }), Trait::kStrange, "rolling -1"},
        {material_with([](dMaterial& m) { m.rolling_friction = kNaN; }), Trait::kNaN, "rolling NaN"},
        {material_with([](dMaterial& m) { m.compliance = kInf; }), Trait::kStrange, "softness inf"},
        {material_with([](dMaterial& m) { m.compliance = kNaN; }), Trait::kNaN, "softness NaN"},
        {material_with([](dMaterial& m) { m.compliance = kLarge; }), Trait::kStrange, "as soft as can be"},
        {material_with([](dMaterial& m) { m.damping_time = kNaN; }), Trait::kNaN, "damping time NaN"},
        {material_with([](dMaterial& m) { m.bounce_rule = 7; }), Trait::kStrange, "no rule"},
        {material_with([](dMaterial& m) { m.friction = kInf; }), Trait::kStrange, "friction inf"},
        {material_with([](dMaterial& m) { m.friction = -1; }), Trait::kStrange, "friction -1"},
        {material_with([](dMaterial& m) { m.friction = kNaN; }), Trait::kNaN, "friction NaN"},
        {material_with([](dMaterial& m) { m.bounce = 2; }), Trait::kStrange, "bounce 2"},
        {material_with([](dMaterial& m) { m.bounce = kNaN; }), Trait::kNaN, "bounce NaN"},
        {material_with([](dMaterial& m) { m.bounce_speed = kNaN; }), Trait::kNaN, "bounce speed NaN"},
        {material_with([](dMaterial& m) { m.surface_velocity[1] = kLarge; }), Trait::kStrange, "a fast belt"},
        {material_with([](dMaterial& m) { m.surface_velocity[2] = kNaN; }), Trait::kNaN, "velocity NaN"}};
    return list;
}

template <typename Change>
dMass mass_with(Change&& change)
{
    dMass m = unit_mass();
    change(m);
    return m;
}

inline const std::vector<Item<dMass>>& masses()
{
    static const std::vector<Item<dMass>> list = {
        {unit_mass(), Trait::kFine, "unit"},
        {mass_with([](dMass& m) { m.mass = 0; }), Trait::kStrange, "mass 0"},
        {mass_with([](dMass& m) { m.mass = -1; }), Trait::kStrange, "mass -1"},
        {mass_with([](dMass& m) { m.mass = kTiny; }), Trait::kStrange, "mass denormal"},
        {mass_with([](dMass& m) { m.mass = kLarge; }), Trait::kStrange, "mass large"},
        {mass_with([](dMass& m) { m.mass = kInf; }), Trait::kStrange, "mass inf"},
        {mass_with([](dMass& m) { m.mass = kNaN; }), Trait::kNaN, "mass NaN"},
        {mass_with([](dMass& m) { m.c[1] = 1; }), Trait::kStrange, "c (0,1,0)"},
        {mass_with([](dMass& m) { m.c[2] = kNaN; }), Trait::kNaN, "c NaN"},
        {mass_with([](dMass& m) { m.I[5] = -1; }), Trait::kStrange, "I22 -1"},
        {mass_with([](dMass& m) { m.I[1] = m.I[4] = 2; }), Trait::kStrange, "I not definite"},
        {mass_with([](dMass& m) { m.I[10] = kNaN; }), Trait::kNaN, "I33 NaN"},
        {mass_with([](dMass& m) { m.I[2] = kNaN; }), Trait::kNaN, "I13 NaN"},
        {mass_with([](dMass& m) { m.I[0] = m.I[5] = m.I[10] = kTiny; }), Trait::kStrange, "I denormal"},
        {mass_with([](dMass& m) { m.I[0] = kLarge; }), Trait::kStrange, "I11 large"},
        {mass_with([](dMass& m) { m.I[0] = m.I[5] = m.I[10] = kLarge; }), Trait::kStrange, "I large"}};
    return list;
}

template <typename Change>
dContact contact_with(Change&& change)
{
    dContact c{};
    c.surface.mode = dContactBounce | dContactSoftERP | dContactSoftCFM | dContactApprox1;
    c.surface.mu = c.surface.bounce = c.surface.soft_erp = dReal(0.5);
    c.geom.normal[2] = 1;
    change(c);
    return c;
}

inline const std::vector<Item<dContact>>& contacts()
{
    static const std::vector<Item<dContact>> list = {
        {contact_with([](dContact&) {}), Trait::kFine, "good"},
        {contact_with([](dContact& c) { c.geom.normal[2] = 0; }), Trait::kStrange, "normal 0"},
        {contact_with([](dContact& c) { c.geom.normal[2] = kLarge; }), Trait::kStrange, "normal large"},
        {contact_with([](dContact& c) { c.geom.normal[0] = kNaN; }), Trait::kNaN, "normal NaN"},
        {contact_with([](dContact& c) { c.geom.pos[1] = kNaN; }), Trait::kNaN, "pos NaN"},
        {contact_with([](dContact& c) { c.geom.pos[1] = kTooLarge; }), Trait::kStrange, "pos 1e300"},
        {contact_with([](dContact& c) { c.geom.pos[1] = kLarge; }), Trait::kStrange, "pos large"},
        {contact_with([](dContact& c) { c.geom.depth = kNaN; }), Trait::kNaN, "depth NaN"},
        {contact_with([](dContact& c) { c.geom.depth = kInf; }), Trait::kStrange, "depth inf"},
        {contact_with([](dContact& c) { c.geom.depth = -1; }), Trait::kStrange, "depth -1"},
        {contact_with([](dContact& c) { c.geom.depth = kLarge; }), Trait::kStrange, "depth large"},
        {contact_with([](dContact& c) { c.surface.mode = -1; }), Trait::kStrange, "mode -1"},
        {contact_with([](dContact& c) { c.surface.mu = kNaN; }), Trait::kNaN, "mu NaN"},
        {contact_with([](dContact& c) { c.surface.mu = kInf; }), Trait::kFine, "mu inf"},
        {contact_with([](dContact& c) { c.surface.mu = -1; }), Trait::kStrange, "mu -1"},
        {contact_with([](dContact& c) { c.surface.bounce = kNaN; }), Trait::kNaN, "bounce NaN"},
        {contact_with([](dContact& c) { c.surface.bounce = kLarge; }), Trait::kStrange, "bounce large"},
        {contact_with([](dContact& c) { c.surface.soft_cfm = kNaN; }), Trait::kNaN, "soft_cfm NaN"},
        {contact_with([](dContact& c) { c.surface.soft_cfm = -kLarge; }), Trait::kStrange, "soft_cfm -large"},
        {contact_with([](dContact& c) { c.surface.soft_erp = kLarge; }), Trait::kStrange, "soft_erp large"},
        {contact_with([](dContact& c) { c.surface.mode |= dContactFDir1, c.fdir1[0] = kNaN; }), Trait::kNaN,
         "fdir1 NaN"},
        {contact_with([](dContact& c) { c.surface.mode |= dContactFDir1; }), Trait::kStrange, "fdir1 0"},
        {contact_with([](dContact& c) { c.fdir1[0] = c.surface.slip1 = c.surface.mu2 = kNaN; }), Trait::kFine,
         "NaN in what is not read"}};
    return list;
}

inline const std::vector<Item<dGeomClass>>& classes()
{
    static const auto with = [](auto change) {
        dGeomClass c = kUserClass;
        change(c);
        return c;
    };
    static const std::vector<Item<dGeomClass>> list = {
        {kUserClass, Trait::kFine, "good"},
        {with([](dGeomClass& c) { c.bytes = -1; }), Trait::kBad, "bytes -1"},
        {with([](dGeomClass& c) { c.bytes = INT_MAX; }), Trait::kStrange, "bytes INT_MAX"},
        {with([](dGeomClass& c) { c.collider = nullptr; }), Trait::kBad, "collider null"},
        {with([](dGeomClass& c) { c.aabb = nullptr; }), Trait::kBad, "aabb null"},
        {with([](dGeomClass& c) { c.aabb_test = nullptr, c.dtor = nullptr; }), Trait::kFine,
         "required only"}};
    return list;
}

using Coordinates = std::array<dReal, 24>;

inline Coordinates scaled(const Coordinates& from, dReal x, dReal y, dReal z)
{
    Coordinates c = from;
    for (std::size_t i = 0; i < c.size(); i += 3) c[i] *= x, c[i + 1] *= y, c[i + 2] *= z;
    return c;
}

inline Coordinates with_one(Coordinates c, std::size_t at, dReal value)
{
    c[at] = value;
    return c;
}

inline const std::vector<Item<Coordinates>>& face_points()
{
    const Coordinates& cube = kCube.points;
    static const std::vector<Item<Coordinates>> list = {
        {cube, Trait::kFine, "cube"},
        {scaled(cube, 1, 2, 3), Trait::kFine, "block"},
        {scaled(cube, 1, 1, 0), Trait::kStrange, "flat"},
        {scaled(cube, 0, 0, 0), Trait::kStrange, "one point"},
        {scaled(cube, -1, 1, 1), Trait::kStrange, "inside out"},
        {scaled(cube, 1, 1, dReal(1e-12)), Trait::kStrange, "almost flat"},
        {scaled(cube, kTiny, kTiny, kTiny), Trait::kStrange, "denormal"},
        {scaled(cube, kLarge, kLarge, kLarge), Trait::kStrange, "large"},
        {scaled(cube, kLarge, 1, kTiny), Trait::kStrange, "large and denormal"},
        {scaled(cube, kTooLarge, 1, 1), Trait::kStrange, "1e300"},
        {with_one(cube, 23, dReal(0.5)), Trait::kStrange, "dented"},
        {with_one(cube, 0, 5), Trait::kStrange, "one corner out"},
        {with_one(cube, 7, kInf), Trait::kStrange, "inf"},
        {with_one(cube, 4, kNaN), Trait::kNaN, "NaN at 4"}};
    return list;
}

inline const std::vector<Item<Coordinates>>& face_planes()
{
    const Coordinates& cube = kCube.planes;
    static const std::vector<Item<Coordinates>> list = {
        {cube, Trait::kFine, "cube"},
        {Coordinates{}, Trait::kStrange, "zero"},
        {with_one(cube, 3, -1), Trait::kStrange, "turned"},
        {with_one(cube, 3, kTooLarge), Trait::kStrange, "1e300"},
        {with_one(cube, 0, kNaN), Trait::kNaN, "NaN at 0"}};
    return list;
}

inline const std::vector<Item<decltype(Solid::faces)>>& faces()
{
    using Faces = decltype(Solid::faces);
    static const auto with = [](std::size_t at, unsigned value) {
        Faces f = kCube.faces;
        f[at] = value;
        return f;
    };
    static const std::vector<Item<Faces>> list = {{kCube.faces, Trait::kFine, "cube"},
                                                  {Faces{}, Trait::kStrange, "zeros"},
                                                  {with(0, 0), Trait::kStrange, "no corners"},
                                                  {with(0, 3), Trait::kStrange, "3 corners"},
                                                  {with(25, 8), Trait::kStrange, "8 corners"},
                                                  {with(5, UINT_MAX), Trait::kStrange, "2^32-1 corners"},
                                                  {with(2, 8), Trait::kBad, "no such point"},
                                                  {with(4, UINT_MAX), Trait::kBad, "point 2^32-1"},
                                                  {with(1, 3), Trait::kStrange, "a corner twice"},
                                                  {with(1, 6), Trait::kStrange, "a corner elsewhere"}};
    return list;
}

inline const std::vector<Item<decltype(Mesh::vertices)>>& vertices()
{
    using Vertices = decltype(Mesh::vertices);
    static const auto times = [](double x, double y, double z) {
        Vertices v = kTetrahedron.vertices;
        for (std::size_t i = 0; i < v.size(); i += 4) v[i] *= x, v[i + 1] *= y, v[i + 2] *= z;
        return v;
    };
    static const auto with_first = [](double value) {
        Vertices v = kTetrahedron.vertices;
        v[0] = value;
        return v;
    };
    static const std::vector<Item<Vertices>> list = {
        {kTetrahedron.vertices, Trait::kFine, "tetrahedron"},
        {times(1, 2, 3), Trait::kFine, "tall"},
        {times(-1, 1, 1), Trait::kStrange, "inside out"},
        {times(1, 1, 0), Trait::kStrange, "flat"},
        {times(0, 0, 0), Trait::kStrange, "one point"},
        {times(double(kTiny), 1, 1), Trait::kStrange, "denormal"},
        {times(double(kLarge), 1, 1), Trait::kStrange, "large"},
        {times(1e300, 1, 1), Trait::kStrange, "1e300"},
        {with_first(std::numeric_limits<double>::infinity()), Trait::kStrange, "inf"},
        {with_first(std::numeric_limits<double>::quiet_NaN()), Trait::kNaN, "NaN"}};
    return list;
}

inline const std::vector<Item<decltype(Mesh::corners)>>& corners()
{
    using Corners = decltype(Mesh::corners);
    static const auto with_first = [](unsigned value) {
        Corners c = kTetrahedron.corners;
        c[0] = value;
        return c;
    };
    static const std::vector<Item<Corners>> list = {{kTetrahedron.corners, Trait::kFine, "tetrahedron"},
                                                    {Corners{}, Trait::kStrange, "zeros"},
                                                    {with_first(4), Trait::kBad, "no such vertex"},
                                                    {with_first(UINT_MAX), Trait::kBad, "vertex 2^32-1"}};
    return list;
}

inline const std::vector<Item<std::array<dintptr, 2>>>& extra_data()
{
    static const std::vector<Item<std::array<dintptr, 2>>> list = {
        {{0, 0}, Trait::kFine, "zeros"}, {{0, 2}, Trait::kFine, "words"}, {{-1, -1}, Trait::kStrange, "-1"}};
    return list;
}

template <typename Report>
inline const std::vector<Item<Report>>& reports()
{
    static const auto sized = [](unsigned size) {
        Report r{};
        r.struct_size = size;
        return r;
    };
    static const std::vector<Item<Report>> list = {{sized(sizeof(Report)), Trait::kFine, "good"},
                                                   {sized(8), Trait::kFine, "size 8"},
                                                   {sized(0), Trait::kBad, "size 0"},
                                                   {sized(4), Trait::kBad, "size 4"},
                                                   {sized(9), Trait::kBad, "size 9"},
                                                   {sized(UINT_MAX), Trait::kBad, "size UINT_MAX"}};
    return list;
}

template <typename T>
inline const std::vector<Item<std::array<T, 25>>>& samples()
{
    static const std::vector<Item<std::array<T, 25>>> list = [] {
        std::vector<Item<std::array<T, 25>>> l;
        std::array<T, 25> a{};
        l.push_back({a, Trait::kFine, "flat"});
        for (std::size_t i = 0; i < 25; ++i) a[i] = T(i % 7);
        l.push_back({a, Trait::kFine, "hills"});
        if constexpr (std::is_floating_point_v<T>) {
            for (T bad : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity()}) {
                a[0] = bad;
                l.push_back({a, Trait::kNaN, "NaN or infinity"});
            }
            a[0] = std::numeric_limits<T>::max();
            l.push_back({a, Trait::kStrange, "max"});
        }
        return l;
    }();
    return list;
}

inline const std::vector<Item<dThreadingFunctionsInfo>>& threading_functions()
{
    static const auto with = [](auto change) {
        const dThreadingImplementationID impl = dThreadingAllocateSelfThreadedImplementation();
        dThreadingFunctionsInfo f = *dThreadingImplementationGetFunctions(impl);
        dThreadingFreeImplementation(impl);
        change(f);
        return f;
    };
    using F = dThreadingFunctionsInfo;
    static const std::vector<Item<F>> list = {
        {with([](F&) {}), Trait::kFine, "good"},
        {with([](F& f) { f.struct_size = 0; }), Trait::kBad, "size 0"},
        {with([](F& f) { f.struct_size = UINT_MAX; }), Trait::kStrange, "size UINT_MAX"},
        {with([](F& f) { f.post_call = nullptr; }), Trait::kBad, "post_call null"}};
    return list;
}

inline const std::vector<Item<dWorldStepReserveInfo>>& reserve_infos()
{
    constexpr unsigned kSize = sizeof(dWorldStepReserveInfo);
    static const std::vector<Item<dWorldStepReserveInfo>> list = {
        {{kSize, 1.5f, 1000}, Trait::kFine, "good"},
        {{0, 1.5f, 1000}, Trait::kBad, "size 0"},
        {{kSize, -1, 1000}, Trait::kBad, "factor -1"},
        {{kSize, float(kNaN), 1000}, Trait::kBad, "factor NaN"},
        {{kSize, float(kInf), 1000}, Trait::kBad, "factor inf"},
        {{kSize, 1e38f, 1000}, Trait::kStrange, "factor 1e38"},
        {{kSize, 1, UINT_MAX}, Trait::kStrange, "minimum UINT_MAX"}};
    return list;
}

inline const std::vector<Item<dWorldStepMemoryFunctionsInfo>>& memory_functions()
{
    constexpr unsigned kSize = sizeof(dWorldStepMemoryFunctionsInfo);
    static const std::vector<Item<dWorldStepMemoryFunctionsInfo>> list = {
        {{kSize, give_block, nullptr, take_block}, Trait::kFine, "good"},
        {{kSize, give_nothing, nullptr, take_block}, Trait::kStrange, "gives nothing"},
        {{0, give_block, nullptr, take_block}, Trait::kBad, "size 0"},
        {{kSize, nullptr, nullptr, take_block}, Trait::kBad, "alloc null"},
        {{kSize, give_block, nullptr, nullptr}, Trait::kBad, "free null"}};
    return list;
}

inline const std::vector<Item<std::array<int, 8>>>& indices()
{
    static const std::vector<Item<std::array<int, 8>>> list = {
        {{0, 1, 2, 3, 4, 5, 6, 7}, Trait::kFine, "identity"},
        {{7, 6, 5, 4, 3, 2, 1, 0}, Trait::kStrange, "reversed"},
        {{-1, 1, 2, 3, 4, 5, 6, 7}, Trait::kStrange, "-1"},
        {{INT_MAX, INT_MIN, 2, 3, 4, 5, 6, 7}, Trait::kStrange, "INT_MAX"}};
    return list;
}

inline const std::vector<Item<int>>& pointed_ints()
{
    static const std::vector<Item<int>> list = {{4, Trait::kFine, "4"},
                                                {0, Trait::kFine, "0"},
                                                {-1, Trait::kFine, "-1"},
                                                {INT_MAX, Trait::kFine, "INT_MAX"}};
    return list;
}

// Of files. Nothing may be written over a device.
inline const std::vector<Item<const char*>>& paths(const char* good)
{
    static const std::string long_path(5000, '/');
    static std::vector<Item<const char*>> all = {{good, Trait::kFine, "a file"},
                                                 {"/dev/null", Trait::kStrange, "/dev/null"},
                                                 {"/nowhere/at/all", Trait::kStrange, "/nowhere"},
                                                 {"", Trait::kStrange, "\"\""},
                                                 {long_path.c_str(), Trait::kStrange, "5000 /"}};
    all[0].value = good;
    return all;
}

inline const std::vector<Item<const char*>>& texts(bool formats)
{
    static const std::string long_text(5000, 'x');
    static const std::vector<Item<const char*>> plain = {{"ODE", Trait::kFine, "\"ODE\""},
                                                         {"", Trait::kStrange, "\"\""},
                                                         {long_text.c_str(), Trait::kStrange, "5000 x"}};
    static const std::vector<Item<const char*>> printed = {{"%10.4f ", Trait::kFine, "%10.4f"},
                                                           {"%-+ 0#.3e", Trait::kFine, "%-+ 0#.3e"},
                                                           {"", Trait::kStrange, "\"\""},
                                                           {"no number", Trait::kStrange, "no number"},
                                                           {"%s", Trait::kBad, "%s"},
                                                           {"%n", Trait::kBad, "%n"},
                                                           {"%d", Trait::kBad, "%d"},
                                                           {"%*f", Trait::kBad, "%*f"},
                                                           {"%.*f", Trait::kBad, "%.*f"},
                                                           {"%f %f", Trait::kBad, "%f %f"},
                                                           {"%Lf", Trait::kBad, "%Lf"},
                                                           {"100%% %g", Trait::kFine, "100%% %g"},
                                                           {"%", Trait::kBad, "%"},
                                                           {"%1$f", Trait::kBad, "%1$f"},
                                                           {"%999999999f", Trait::kBad, "%999999999f"},
                                                           {"%.999999999f", Trait::kBad, "%.999999999f"}};
    return formats ? printed : plain;
}

}  // namespace hostile
